// SPDX-License-Identifier: Apache-2.0
#include "numbers_beside.hpp"

#include <fmt/format.h>

#include "strainwave/model/input/compliance_table.hpp"
#include "strainwave/model/input/turn_table.hpp"

namespace strainwave {

std::string numbers_beside(const GearSet& gear) {
  std::string beside;
  for (const auto& [name, table] : gear.compliance_tables) {
    beside += name;
    for (const TableValues* const values : {&table.positive, &table.negative, &table.axial})
      for (const double value : values->values) beside += fmt::format(" {:a}", value);
    for (const TableAxis& axis : table.axes)
      for (const double node : axis.nodes) beside += fmt::format(" {:a}", node);
  }
  for (const auto& [name, table] : gear.turn_tables) {
    beside += name;
    for (const std::vector<double>* const axis :
         {&table->sizes, &table->aspect_ratios, &table->torques, &table->stations, &table->angles})
      for (const double node : *axis) beside += fmt::format(" {:a}", node);
    for (const auto& K : table->K) beside += fmt::format(" {:a} {:a} {:a}", K[0], K[1], K[2]);
  }
  if (const auto& table = gear.error_table) {
    beside += fmt::format("error_table {:a}", table->turns);
    for (const double value : table->values) beside += fmt::format(" {:a}", value);
    // The phases tell tables apart that begin at different angles.
    for (const ErrorOrder& line : table->lines.orders)
      beside += fmt::format(" {:a} {:a} {:a}", line.order, line.amplitude, line.phase);
    beside += '\n';
  }
  if (const auto& record = gear.duty_record)
    for (const DutyRow& row : record->rows)
      beside += fmt::format("{:a} {:a} {:a}\n", row.time, row.torque, row.speed);
  return beside;
}

}  // namespace strainwave

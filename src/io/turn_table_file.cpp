// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/turn_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

/// A column over which the table runs.
struct TurnColumn {
  std::string name;
  std::size_t number = 0;         // in the file
  double factor = 1.0;            // to SI
  std::string unit = {};          // as written
  std::vector<double> node = {};  // in the unit of the file, ascending

  [[nodiscard]] std::string at(double value) const {
    return fmt::format("{} {:g}{}{}", name, value, unit.empty() ? "" : " ", unit);
  }
};

using Block = std::vector<std::vector<double>>;

/// The nodes of the columns, from rows that are sorted.
void find_nodes(const HistoryFile& file, const Block& rows, std::vector<TurnColumn>& columns) {
  std::string order;
  for (const TurnColumn& column : columns) order += (order.empty() ? "" : ", ") + column.name;
  for (std::size_t r = 1; r < rows[0].size(); ++r) {
    std::size_t c = 0;
    while (c < columns.size() && rows[c][r] == rows[c][r - 1]) ++c;
    if (c == columns.size())
      file.refuse(r, columns.back().number, rows[c - 1][r],
                  "a point of the table appears once; remove one of the two rows");
    if (rows[c][r] < rows[c][r - 1])
      file.refuse(r, columns[c].number, rows[c][r],
                  fmt::format("rows sorted by {}, each ascending; the row before has {:g}", order,
                              rows[c][r - 1]));
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<double>& node = columns[c].node = rows[c];
    std::sort(node.begin(), node.end());
    node.erase(std::unique(node.begin(), node.end()), node.end());
  }
}

/// Refuses rows that are not the full grid of the nodes.
void require_grid(const HistoryFile& file, const Block& rows,
                  const std::vector<TurnColumn>& columns) {
  const std::size_t n = rows[0].size();
  std::size_t points = 1;  // or any number above that of the rows
  for (const TurnColumn& column : columns)
    if (points <= n) points *= column.node.size();
  const auto missing = [&](std::size_t point) {
    std::string text;
    for (std::size_t c = columns.size(); c-- > 0;) {
      const std::vector<double>& node = columns[c].node;
      const std::string here = columns[c].at(node[point % node.size()]);
      text = text.empty() ? here : fmt::format("{}, {}", here, text);
      point /= node.size();
    }
    return text;
  };
  for (std::size_t r = 0; r < n; ++r) {
    std::size_t rest = r;
    for (std::size_t c = columns.size(); c-- > 0;) {
      const std::vector<double>& node = columns[c].node;
      if (rows[c][r] != node[rest % node.size()])
        file.refuse(r, columns[c].number, rows[c][r],
                    fmt::format("a full grid; the point {} is missing", missing(r)));
      rest /= node.size();
    }
  }
  if (n < points)
    file.refuse(n - 1, columns.back().number, rows[columns.size() - 1][n - 1],
                fmt::format("a full grid; the point {} is missing behind this row", missing(n)));
}

/// Refuses a turn that does not end where it begins.
void require_closed_turn(const HistoryFile& file, const TurnTable& table, const Block& rows,
                         const std::vector<std::size_t>& numbers, std::size_t first_mode) {
  double largest = 0.0;
  for (const auto& K : table.K)
    for (const double mode : K) largest = std::max(largest, std::abs(mode));
  const std::size_t n = table.angles.size();
  for (std::size_t r = n - 1; r < table.K.size(); r += n)
    for (std::size_t mode = 0; mode < 3; ++mode)
      if (std::abs(table.K[r][mode] - table.K[r + 1 - n][mode]) > kTurnCloses * largest)
        file.refuse(r, numbers[first_mode + mode], rows[first_mode + mode][r],
                    fmt::format("the value at the first angle, {:g}, because the last angle is the "
                                "first one a wave or a turn later",
                                rows[first_mode + mode][r + 1 - n]));
}

/// Begins the remark of a table that must not be used.
constexpr std::string_view kUnusableMark = "NOT usable: ";
/// Begins a remark that names a condition: "for flexspline.barrel.wall_thickness = 0.453 mm".
constexpr std::string_view kConditionMark = "for ";

std::vector<TurnCondition> conditions_in(const std::vector<std::string>& remarks) {
  std::vector<TurnCondition> conditions;
  for (const std::string& remark : remarks) {
    constexpr std::string_view kEquals = " = ";
    const std::size_t equals = remark.find(kEquals);
    if (!remark.starts_with(kConditionMark) || equals == std::string::npos) continue;
    conditions.push_back(
        {.name = remark.substr(kConditionMark.size(), equals - kConditionMark.size()),
         .text = remark.substr(equals + kEquals.size())});
  }
  return conditions;
}

}  // namespace

TurnTable read_turn_table(HistoryFile& file) {
  TurnTable table;
  table.file = file.name();
  table.conditions = conditions_in(file.remarks());
  for (const std::string& remark : file.remarks())
    if (remark.starts_with(kUnusableMark))
      throw InputError(TextPlace{.file = file.name()},
                       fmt::format("says that it is not usable: {}; compute a better table",
                                   shown(remark.substr(kUnusableMark.size()))));
  if (file.has("depth") == file.has("half_length"))
    throw InputError(TextPlace{.file = file.name()},
                     "must have one of the columns depth and half_length, with its unit");
  table.size_name = file.has("depth") ? "depth" : "half_length";
  std::vector<TurnColumn> columns;
  const auto add = [&](const std::string& name, std::string_view unit) {
    TurnColumn& column = columns.emplace_back();
    column.name = name;
    column.number = file.number_of(name);
    column.unit = file.columns()[column.number].unit;
    if (unit != "1" || !column.unit.empty()) column.factor = file.factor_to(unit, column.number);
  };
  add(table.size_name, "m");
  const bool shapes = file.has("aspect_ratio");
  if (shapes) add("aspect_ratio", "1");
  add("torque", "N*m");
  add("station", "1");
  add("angle", "rad");
  std::vector<std::size_t> wanted;
  for (const TurnColumn& column : columns) wanted.push_back(column.number);
  const std::size_t first_mode = wanted.size();
  std::vector<double> factor;
  for (const char* const mode : {"K_I", "K_II", "K_III"}) {
    wanted.push_back(file.number_of(mode));
    factor.push_back(file.factor_to("Pa*m^0.5", wanted.back()));
  }
  const Block rows = file.read(wanted, kMaxTurnRows + 1);
  const std::size_t n = rows[0].size();
  if (n == 0) throw InputError(TextPlace{.file = file.name()}, "has no rows of numbers");
  if (n > kMaxTurnRows)
    throw InputError(TextPlace{.file = file.name()},
                     fmt::format("has more than {} rows; give fewer angles", kMaxTurnRows));
  for (std::size_t r = 0; r < n; ++r) {
    if (!(rows[0][r] > 0)) file.refuse(r, wanted[0], rows[0][r], "> 0");
    if (shapes && !(rows[1][r] > 0 && rows[1][r] <= 1))
      file.refuse(r, wanted[1], rows[1][r], "> 0 and <= 1");
  }
  find_nodes(file, rows, columns);
  require_grid(file, rows, columns);
  const auto nodes_of = [&](std::size_t c) {
    std::vector<double> nodes;
    for (const double node : columns[c].node) nodes.push_back(node * columns[c].factor);
    return nodes;
  };
  std::size_t c = 0;
  table.sizes = nodes_of(c++);
  if (shapes) table.aspect_ratios = nodes_of(c++);
  table.torques = nodes_of(c++);
  table.stations = nodes_of(c++);
  table.angles = nodes_of(c);
  if (shapes && table.aspect_ratios.size() < 2)
    throw InputError(TextPlace{.file = file.name()},
                     "has one aspect_ratio; give more of them, or leave the column out for a crack "
                     "that keeps its shape");
  if (table.angles.size() < kMinTurnAngles)
    throw InputError(TextPlace{.file = file.name()},
                     fmt::format("has {} angles; give {} or more, with the first one again at the "
                                 "end",
                                 table.angles.size(), kMinTurnAngles));
  table.K.reserve(n);
  for (std::size_t r = 0; r < n; ++r)
    table.K.push_back({rows[first_mode][r] * factor[0], rows[first_mode + 1][r] * factor[1],
                       rows[first_mode + 2][r] * factor[2]});
  require_closed_turn(file, table, rows, wanted, first_mode);
  return table;
}

std::string turn_table_text(const TurnTable& table, const std::vector<std::string>& remarks) {
  constexpr double kMPaRootMetre = 1e6;
  std::string text;
  for (const std::string& remark : remarks) text += fmt::format("# {}\n", remark);
  if (!table.unusable_because.empty())
    text += fmt::format("# {}{}\n", kUnusableMark, table.unusable_because);
  for (const TurnCondition& condition : table.conditions)
    text += fmt::format("# {}{} = {}\n", kConditionMark, condition.name, condition.text);
  const bool shapes = !table.aspect_ratios.empty();
  text += fmt::format(
      "{} [mm],{}torque [N*m],station,angle [deg],K_I [MPa*m^0.5],K_II [MPa*m^0.5],K_III "
      "[MPa*m^0.5]\n",
      table.size_name, shapes ? "aspect_ratio," : "");
  auto K = table.K.begin();
  for (const double size : table.sizes)
    for (std::size_t shape = 0; shape < std::max<std::size_t>(1, table.aspect_ratios.size());
         ++shape)
      for (const double torque : table.torques)
        for (const double station : table.stations)
          for (const double angle : table.angles) {
            text += fmt::format("{:.12g},", size / units::mm);
            if (shapes) text += fmt::format("{:.12g},", table.aspect_ratios[shape]);
            text += fmt::format("{:.12g},{:.12g},{:.12g},{:.6g},{:.6g},{:.6g}\n", torque, station,
                                angle / units::deg, (*K)[0] / kMPaRootMetre,
                                (*K)[1] / kMPaRootMetre, (*K)[2] / kMPaRootMetre);
            ++K;
          }
  return text;
}

void read_turn_tables(GearSet& gear, const Attachments& attachments) {
  std::map<std::string, std::shared_ptr<const TurnTable>> tables;
  for_each_crack_with_turn(gear, [&](const std::string& path, const auto& crack) {
    if (!crack.turn_table || tables.contains(*crack.turn_table)) return;
    const std::string& name = *crack.turn_table;
    const std::string at = path + ".turn_table";
    TextPieces pieces = attachments.pieces(name, at);
    try {
      HistoryFile file(std::move(pieces), name);
      tables.emplace(name, std::make_shared<const TurnTable>(read_turn_table(file)));
    } catch (const InputError& error) {
      throw InputError(at, error.what());
    }
  });
  gear.turn_tables = std::move(tables);
}

}  // namespace strainwave

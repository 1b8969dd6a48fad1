// SPDX-License-Identifier: Apache-2.0
#include "tooth_file.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"

namespace strainwave {
namespace {

/// The teeth of a part from a table with a row for each tooth.
std::vector<ToothDeviation> teeth_of(const Request& request, std::string_view option,
                                     const std::string& name, int teeth) {
  HistoryFile file(request.pieces(option, name), name == "-" ? "standard input" : name);
  std::vector<std::size_t> wanted;
  std::vector<double> factors;
  std::vector<double ToothDeviation::*> members;
  for (const auto& [column, member] : {std::pair{"position", &ToothDeviation::position},
                                       std::pair{"thickness", &ToothDeviation::thickness}}) {
    if (!file.has(column)) continue;
    wanted.push_back(file.number_of(column));
    factors.push_back(file.factor_to("m", wanted.back()));
    members.push_back(member);
  }
  if (wanted.empty())
    throw InputError(TextPlace{.file = file.name()},
                     "has neither a column position nor a column thickness; name one of them, such "
                     "as position [um]");
  std::vector<ToothDeviation> read;
  for (;;) {
    const std::vector<std::vector<double>>& block = file.read(wanted);
    if (block.front().empty()) break;
    for (std::size_t row = 0; row < block.front().size(); ++row) {
      ToothDeviation& tooth = read.emplace_back();
      for (std::size_t c = 0; c < wanted.size(); ++c)
        tooth.*members[c] = factors[c] * block[c][row];
    }
  }
  if (read.size() != static_cast<std::size_t>(teeth))
    throw InputError(TextPlace{.file = file.name()},
                     fmt::format("has {} rows, but the part has {} teeth; give one row for each "
                                 "tooth",
                                 read.size(), teeth));
  return read;
}

}  // namespace

std::optional<Deviations> measured_teeth(const Request& request, const ToothFiles& files) {
  if (!files.flexspline_teeth && !files.spline_teeth) return std::nullopt;
  Deviations measured;
  const int teeth = flexspline_teeth(request.drive.gear.drive);
  if (files.flexspline_teeth)
    measured.flexspline = teeth_of(request, "flexspline_teeth", *files.flexspline_teeth, teeth);
  if (files.spline_teeth)
    measured.spline = teeth_of(request, "spline_teeth", *files.spline_teeth,
                               teeth + request.drive.gear.drive.wave_number);
  return measured;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/error_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr double kEvenAngles = 1e-3;   // difference to even angles, over their step [-]
constexpr double kErrorCloses = 1e-2;  // difference of last and first error, over the range [-]

}  // namespace

ErrorTable read_error_table(HistoryFile& file) {
  const std::array<std::size_t, 2> wanted = {file.number_of("input_angle"),
                                             file.number_of("error")};
  const double to_angle = file.factor_to("rad", wanted[0]);
  const double to_error = file.factor_to("rad", wanted[1]);
  const std::vector<std::vector<double>>& rows = file.read(wanted, kMaxErrorRows + 1);
  const std::vector<double>& angle = rows[0];
  const std::vector<double>& error = rows[1];
  const std::size_t n = angle.size();
  if (n < kMinErrorRows || n > kMaxErrorRows)
    throw InputError(TextPlace{.file = file.name()},
                     n > kMaxErrorRows
                         ? fmt::format("has more than {} rows; give {} to {}", kMaxErrorRows,
                                       kMinErrorRows, kMaxErrorRows)
                         : fmt::format("has {} {}; give {} to {} rows", n, n == 1 ? "row" : "rows",
                                       kMinErrorRows, kMaxErrorRows));
  const double step = (angle.back() - angle.front()) / static_cast<double>(n - 1);
  for (std::size_t r = 1; r < n; ++r) {
    if (!(angle[r] > angle[r - 1]))
      file.refuse(r, wanted[0], angle[r],
                  fmt::format("above the angle before, {:g}", angle[r - 1]));
    const double even = angle.front() + step * static_cast<double>(r);
    if (std::abs(angle[r] - even) > kEvenAngles * step)
      file.refuse(r, wanted[0], angle[r], fmt::format("even angles, here {:g}", even));
  }
  const auto [least, largest] = std::ranges::minmax(error);
  if (std::abs(error.back() - error.front()) > kErrorCloses * (largest - least))
    file.refuse(n - 1, wanted[1], error.back(),
                fmt::format("the first error, {:g}, because the last row is the first one a period "
                            "later",
                            error.front()));
  // The mean only turns the output, so the zero of the measurement does not matter.
  const double mean =
      std::accumulate(error.begin(), error.end() - 1, 0.0) / static_cast<double>(n - 1);
  for (std::size_t r = 0; r < n; ++r)
    if (!(std::abs(error[r] - mean) * to_error < kLargestError))
      file.refuse(r, wanted[1], error[r],
                  fmt::format("less than 0.5 deg from the mean of the errors, {:g}", mean));
  ErrorTable table;
  table.turns = step * to_angle * static_cast<double>(n - 1) / (2 * std::numbers::pi);
  if (const double whole = std::round(table.turns);
      whole > 0 && std::abs(table.turns - whole) <= kEvenAngles * whole / static_cast<double>(n))
    table.turns = whole;
  if (table.turns * kLargestOrder < 1)
    file.refuse(n - 1, wanted[0], angle.back(),
                fmt::format("an angle at least 1/{:g} of a turn above the first one, {:g}, because "
                            "orders above {:g} are left out; check the unit of the column",
                            kLargestOrder, angle.front(), kLargestOrder));
  for (std::size_t r = 0; r + 1 < n; ++r) table.values.push_back(error[r] * to_error);
  table.lines = error_lines(table.values, table.turns);
  // The first row stands at any angle.
  for (ErrorOrder& line : table.lines.orders)
    line.phase =
        std::remainder(line.phase - line.order * angle.front() * to_angle, 2 * std::numbers::pi);
  return table;
}

void read_error_table(GearSet& gear, const Attachments& attachments) {
  gear.error_table.reset();
  if (!gear.drivetrain || !gear.drivetrain->error_table) return;
  const std::string at = "drivetrain.error_table";
  const std::string& name = *gear.drivetrain->error_table;
  TextPieces pieces = attachments.pieces(name, at);
  try {
    HistoryFile file(std::move(pieces), name);
    gear.error_table = std::make_shared<const ErrorTable>(read_error_table(file));
  } catch (const InputError& error) {
    throw InputError(at, error.what());
  }
}

}  // namespace strainwave

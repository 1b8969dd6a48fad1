// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <optional>

#include "strainwave/core/error.hpp"
#include "strainwave/study/growth_fit_report.hpp"

namespace strainwave {
namespace {

/// Most readings of a file; they stay in memory.
constexpr std::uint64_t kMostReadings = 2'000'000;

/// The readings of one specimen while they are read.
struct Readings {
  std::string name;
  std::vector<double> sizes = {};  // in the unit of the file
  std::vector<double> cycles = {};
  std::vector<double> ranges = {};
};

void require_room(const HistoryFile& file, std::uint64_t readings) {
  if (readings > kMostReadings)
    throw InputError(file.name(),
                     fmt::format("has more than {} readings; give fewer of them", kMostReadings));
}

/// Refuses a value that is not larger than the one before.
void require_rise(const HistoryFile& file, std::size_t row, std::size_t column, double value,
                  const std::vector<double>& before, std::string_view what) {
  if (!before.empty() && !(value > before.back()))
    file.refuse(row, column, value,
                fmt::format("each {} must be larger than the one before", what));
}

/// Makes a specimen of its readings, with sizes in metres.
GrowthSpecimen finished(const HistoryFile& file, Readings&& r, double metre,
                        const GrowthTest& test) {
  for (double& size : r.sizes) size *= metre;
  try {
    return test ? specimen_of(r.name, std::move(r.sizes), std::move(r.cycles), *test)
                : specimen_of(r.name, std::move(r.sizes), std::move(r.cycles), r.ranges);
  } catch (const InputError& fault) {
    throw InputError(file.name(), fmt::format("specimen {}", fault.what()));
  }
}

void require_pure(const HistoryFile& file, std::size_t column) {
  const std::string& unit = file.columns()[column].unit;
  if (!unit.empty() && unit != "cycle" && unit != "cycles" && unit != "1")
    throw InputError(file.name(),
                     fmt::format("has the unit [{}] in column {}; cycles have the unit "
                                 "[cycle], or none",
                                 unit, file.columns()[column].name));
}

std::vector<Readings> read_wide(HistoryFile& file) {
  const std::size_t columns = file.columns().size();
  if (columns < 2)
    throw InputError(file.name(),
                     "has one column; give sizes in the first and cycles in the others");
  std::vector<std::size_t> wanted;
  for (std::size_t c = 0; c < columns; ++c) wanted.push_back(c);
  std::vector<Readings> specimens;
  for (std::size_t c = 1; c < columns; ++c) {
    require_pure(file, c);
    specimens.push_back({.name = file.columns()[c].name});
  }
  for (;;) {
    const auto& block = file.read(wanted);
    if (block.front().empty()) break;
    require_room(file, file.rows() * (columns - 1));
    for (std::size_t row = 0; row < block.front().size(); ++row)
      for (std::size_t c = 1; c < columns; ++c) {
        Readings& r = specimens[c - 1];
        const double size = block[0][row];
        if (!(size > 0)) file.refuse(row, 0, size, "a size must be > 0");
        require_rise(file, row, 0, size, r.sizes, "size");
        require_rise(file, row, c, block[c][row], r.cycles, "number of cycles");
        r.sizes.push_back(size);
        r.cycles.push_back(block[c][row]);
      }
  }
  return specimens;
}

std::vector<Readings> read_long(HistoryFile& file, bool with_ranges) {
  std::vector<std::size_t> wanted = {file.number_of("specimen"), file.number_of("crack_length"),
                                     file.number_of("cycles")};
  require_pure(file, wanted[2]);
  double pascal = 1.0;
  if (with_ranges) {
    wanted.push_back(file.number_of("delta_K"));
    pascal = file.factor_to("Pa*m^0.5", wanted[3]);
  }
  std::vector<Readings> specimens;
  std::optional<double> number;
  for (;;) {
    const auto& block = file.read(wanted);
    if (block.front().empty()) break;
    require_room(file, file.rows());
    for (std::size_t row = 0; row < block.front().size(); ++row) {
      if (!number || block[0][row] != *number) {
        number = block[0][row];
        specimens.push_back({.name = fmt::format("{}", *number)});
      }
      Readings& r = specimens.back();
      const double size = block[1][row];
      if (!(size > 0)) file.refuse(row, wanted[1], size, "a size must be > 0");
      require_rise(file, row, wanted[1], size, r.sizes, "size");
      require_rise(file, row, wanted[2], block[2][row], r.cycles, "number of cycles");
      r.sizes.push_back(size);
      r.cycles.push_back(block[2][row]);
      if (!with_ranges) continue;
      if (!(block[3][row] > 0)) file.refuse(row, wanted[3], block[3][row], "a range must be > 0");
      r.ranges.push_back(pascal * block[3][row]);
    }
  }
  return specimens;
}

}  // namespace

std::vector<GrowthSpecimen> read_specimens(HistoryFile& file, const GrowthTest& test) {
  const bool long_file = file.has("specimen");
  if (!test && !long_file)
    throw InputError(file.name(),
                     "has no ranges of the stress intensity factor; give the columns specimen, "
                     "crack_length, cycles and delta_K, or the stress range of the plate");
  std::vector<GrowthSpecimen> specimens;
  const double metre = file.factor_to("m", long_file ? file.number_of("crack_length") : 0);
  for (Readings& readings : long_file ? read_long(file, !test) : read_wide(file))
    specimens.push_back(finished(file, std::move(readings), metre, test));
  if (specimens.empty())
    throw InputError(file.name(), "has no reading; give at least two of each specimen");
  return specimens;
}

}  // namespace strainwave

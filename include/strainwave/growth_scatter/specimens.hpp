// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Specimens whose cracks were measured while they grew.

namespace strainwave {

/// The record of one specimen: sizes of its crack and the cycles at which it reached them.
struct GrowthSpecimen {
  std::string name;            ///< for messages and results
  std::vector<double> sizes;   ///< a [m]; at least two, each larger than the one before
  std::vector<double> cycles;  ///< N [-]; as many, each larger than the one before
  /// Range of the stress intensity factor that stands for the step from size i to size i + 1,
  /// Delta K_i [Pa*sqrt(m)]; one less than there are sizes
  std::vector<double> ranges;

  /// Number of steps from size to size.
  [[nodiscard]] std::size_t steps() const { return ranges.size(); }
};

/// A plate with a through crack in its middle, pulled at its ends.
struct PlateTest {
  double stress_range = 0.0;         ///< Delta sigma of the gross section [Pa]; > 0
  std::optional<double> width = {};  ///< W [m]; absent: a wide plate
};

/// Range of the stress intensity factor of half length a, Delta sigma sqrt(pi a sec(pi a/W))
/// [Pa*sqrt(m)].
///
/// Implements theory manual eq. (GS-1).
/// @param test  range of the stress and width of the plate
/// @param a     half length [m]; > 0, < W/2
[[nodiscard]] double plate_range(const PlateTest& test, double a);

/// Checks a record and gives each step the range at its middle.
/// @throws InputError  naming the specimen, if a size or a number of cycles is not larger than the
///                     one before, or a crack reaches the edge of the plate
[[nodiscard]] GrowthSpecimen specimen_of(std::string name, std::vector<double> sizes,
                                         std::vector<double> cycles, const PlateTest& test);

/// As above, with measured ranges: each step takes the geometric mean of its ends.
/// @param name    of the specimen, for messages and results
/// @param sizes   a [m]; > 0; at least two, each larger than the one before
/// @param cycles  N [-]; as many, each larger than the one before
/// @param ranges  Delta K at each size [Pa*sqrt(m)]; > 0
[[nodiscard]] GrowthSpecimen specimen_of(std::string name, std::vector<double> sizes,
                                         std::vector<double> cycles,
                                         const std::vector<double>& ranges);

/// Cycles at which a crack reached a size, on straight lines between the records [-].
/// @return  absent outside of the record
[[nodiscard]] std::optional<double> cycles_at(const GrowthSpecimen& specimen, double size);

/// Straight line through all steps of all specimens, ln(da/dN) over ln(Delta K), by least squares.
struct PooledLine {
  double exponent = 0.0;         ///< m [-]
  double log_coefficient = 0.0;  ///< ln C, C in metres per cycle at 1 MPa*sqrt(m)
  double deviation = 0.0;  ///< standard deviation of a step [-], with two parameters taken off
};

/// Implements theory manual eq. (GS-2).
[[nodiscard]] PooledLine pooled_line(const std::vector<GrowthSpecimen>& specimens);

}  // namespace strainwave

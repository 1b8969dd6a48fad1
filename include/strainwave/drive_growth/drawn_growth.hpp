// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/growth_scatter/growth_path.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Growth that deviates from its law, as `growth_scatter` of the materials says, in one drawn
/// drive.

namespace strainwave {

/// Standard normal deviates of the specimen of a material.
struct DrawnSpecimen {
  double level = 0.0;     ///< of its level [-]
  double exponent = 0.0;  ///< of its exponent, beside what goes with the level [-]
};

/// What is drawn for the growth of one drive.
struct DrawnGrowth {
  /// The specimens of the materials; a material that is left out has the deviates 0.
  std::map<std::string, DrawnSpecimen, std::less<>> specimen = {};
  std::uint64_t seed = 1;  ///< of the parts that belong to one crack
  std::uint64_t draw = 0;  ///< number of the draw
  /// Whether cracks deviate from each other and along their paths; false: by their specimens only.
  bool of_crack = true;
};

/// The deviations of all cracks of a drawn drive, by the number of the crack in drive_cracks.
///
/// Implements theory manual eq. (GS-12).
class DeviatingCracks {
 public:
  /// @param gear    has passed `check`
  /// @param cracks  drive_cracks(gear)
  /// @param drawn   of this drive
  DeviatingCracks(const GearSet& gear, const std::vector<DriveCrack>& cracks,
                  const DrawnGrowth& drawn);

  /// The present deviation of a crack.
  [[nodiscard]] RateDeviation of(std::size_t crack) const;
  /// ln of the size in metres at which this deviation ends; infinite if it does not vary.
  [[nodiscard]] double log_end(std::size_t crack) const;
  /// Goes on behind this end.
  void next(std::size_t crack);
  /// As GrowthPath::go_on.
  /// @param crack  its index
  /// @param size   of the crack in its new measure [m]; > 0
  void go_on(std::size_t crack, double size);

 private:
  struct Deviating {
    RateDeviation specimen;
    std::optional<GrowthPath> path;
    double log_end = 0.0;  // of the present cell of the path
  };
  std::vector<Deviating> cracks_;
};

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/growth_scatter/specimens.hpp"

/// @file
/// How the growth of cracks varies from specimen to specimen and along the path of one crack.

namespace strainwave {

/// ln(Delta a/Delta N) of a step, in metres per cycle; eq. (GS-2).
[[nodiscard]] inline double log_rate(const GrowthSpecimen& specimen, std::size_t step) {
  return std::log((specimen.sizes[step + 1] - specimen.sizes[step]) /
                  (specimen.cycles[step + 1] - specimen.cycles[step]));
}
/// ln(Delta K) of a step, in MPa*sqrt(m); eq. (GS-2).
[[nodiscard]] inline double log_range(const GrowthSpecimen& specimen, std::size_t step) {
  return std::log(specimen.ranges[step] / 1e6);
}

/// The step whose mean rate has the deviation `white` of ScatterParameters [m].
inline constexpr double kWhiteStep = 1e-3;

/// Parameters of the scatter.  They may have either sign; only their squares and products act.
///
/// A specimen has ln C and m of its own: b0 = level z0, b1 = tilt z0 + slope z1 with independent
/// standard normals z; eq. (GS-4).
struct ScatterParameters {
  double level = 0.0;        ///< deviation of ln(da/dN) of a specimen at the pivot [-]
  double tilt = 0.0;         ///< part of the deviation of m that goes with the level [-]
  double slope = 0.0;        ///< part of the deviation of m of its own [-]
  double wander = 0.0;       ///< deviation of the correlated part along the path [-]
  double log_length = -2.0;  ///< logarithm of its correlation length in ln a [-]
  double white = 0.0;        ///< deviation of the mean over a step of kWhiteStep [-]

  /// Number of parameters.
  static constexpr std::size_t kCount = 6;
  /// The parameters in the order of their declaration.
  [[nodiscard]] std::array<double, kCount> values() const {
    return {level, tilt, slope, wander, log_length, white};
  }
  /// The parameters from their `values`.
  [[nodiscard]] static ScatterParameters of(const std::array<double, kCount>& v) {
    return {v[0], v[1], v[2], v[3], v[4], v[5]};
  }
};

/// A part of the scatter, as ScatterParts.
enum class ScatterPart { level, slope, correlated, white };
template <>
struct EnumNames<ScatterPart> {
  static constexpr std::array<std::string_view, 4> names = {"level", "slope", "correlated",
                                                            "white"};
};

/// Which parts of the scatter act.
struct ScatterParts {
  bool level = true;       ///< specimens differ by a factor
  bool slope = true;       ///< and by their exponent; needs `level`
  bool correlated = true;  ///< the rate wanders along the path
  bool white = true;       ///< steps differ on their own

  /// The named parts act, and no others.
  [[nodiscard]] static ScatterParts of(std::span<const ScatterPart> named);
  /// Which of ScatterParameters::values act.
  [[nodiscard]] std::array<bool, ScatterParameters::kCount> acting() const {
    return {level, slope, slope, correlated, correlated, white};
  }
};

/// Median rate of growth over the range: straight lines in the logarithms between knots; two knots
/// are Paris' law.
struct MeanGrowth {
  std::vector<double> knots;  ///< ln(Delta K), in MPa*sqrt(m), ascending; at least two
  std::vector<double> rates;  ///< ln(da/dN) at the knots, in metres per cycle
  double pivot = 0.0;         ///< ln(Delta K) at which `level` counts

  /// Weights of the rates at the knots for a range; the outer lines go on beyond the knots.
  [[nodiscard]] std::vector<double> weights(double log_range) const;
  /// ln(da/dN), eq. (GS-3).
  [[nodiscard]] double log_rate(double log_range) const;
};

/// Logarithm of the likelihood of records with the rates at the knots that make it largest.
struct GrowthLikelihood {
  double value = 0.0;         ///< logarithm of the likelihood [-]
  std::vector<double> rates;  ///< at the knots, as MeanGrowth::rates
  /// Covariance of the rates at the knots, row by row [-]; eq. (GS-7)
  std::vector<double> covariance;
};

/// The records of specimens in the form that the likelihood takes; specimens with the same sizes
/// and ranges share their work.
class GrowthData {
 public:
  /// @param specimens  at least one
  explicit GrowthData(std::span<const GrowthSpecimen> specimens);

  /// Number of steps of all specimens together.
  [[nodiscard]] std::size_t steps() const { return steps_; }
  /// Smallest ln(Delta K) of a step, in MPa*sqrt(m).
  [[nodiscard]] double lowest() const { return lowest_; }
  /// Largest ln(Delta K) of a step, in MPa*sqrt(m).
  [[nodiscard]] double highest() const { return highest_; }

  /// Logarithm of the likelihood, by a filter along each record.
  ///
  /// Implements theory manual eqs. (GS-5) to (GS-7); takes time in proportion to the steps.
  /// @param mean        its knots and pivot are used; its rates are not
  /// @param parameters  of either sign; wander or white is not 0
  /// @throws SolverError  if the parameters allow no scatter, so that no record is possible
  [[nodiscard]] GrowthLikelihood likelihood(const MeanGrowth& mean,
                                            const ScatterParameters& parameters) const;
  /// Derivatives of the logarithm of the likelihood with respect to the parameters, with the best
  /// rates at the knots; exact.
  [[nodiscard]] std::array<double, ScatterParameters::kCount> slope(
      const MeanGrowth& mean, const ScatterParameters& parameters) const;

 private:
  /// Specimens with the same sizes and ranges.
  struct Design {
    std::vector<double> log_sizes;             // at the middle of each step
    std::vector<double> lengths;               // of each step [m]
    std::vector<double> log_ranges;            // of each step
    std::vector<std::vector<double>> records;  // ln(da/dN) of each specimen, less offset_
  };
  std::vector<Design> designs_;
  std::size_t steps_ = 0;
  double offset_ = 0.0;  // mean of ln(da/dN); without it the likelihood loses digits
  double lowest_ = 0.0;
  double highest_ = 0.0;
};

}  // namespace strainwave

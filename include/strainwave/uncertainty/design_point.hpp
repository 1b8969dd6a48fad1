// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace strainwave {

/// Margin of a requirement at independent standard normal inputs: negative where the drive does not
/// meet the requirement, and empty where the output has no value.
using LimitState = std::function<std::optional<double>(std::span<const double> z)>;

/// Beyond this distance from the origin a failure has a probability below 1e-15, and the inputs no
/// meaning [-].
inline constexpr double kFarthestFailure = 8.0;

/// The failure nearest to the origin, where it is most likely.
struct DesignPoint {
  bool converged = false;  ///< whether the search found the point
  std::string reason;      ///< why the search did not converge; empty after convergence
  /// Distance beta of the failures from the origin [-]; negative if the origin fails.
  double reliability_index = 0.0;
  std::vector<double> place;   ///< z*
  std::vector<double> normal;  ///< unit vector toward more failure
  double slope = 0.0;          ///< magnitude of the gradient of the margin at z*
  int iterations = 0;          ///< steps of the search

  /// Probability of failure of a plane limit, Phi(-beta) [-]; eq. (UQ-4).
  [[nodiscard]] double probability() const;
};

/// Finds the design point by the improved method of Hasofer, Lind, Rackwitz and Fiessler.
///
/// Implements theory manual eq. (UQ-4).  Gradients are central differences with step 1e-3, so the
/// margin must be smooth and accurate to about 1e-9.
///
/// @param margin  of the requirement; scaled so that it is of the order of one
/// @param start   first place of the search; its size is the number of inputs
[[nodiscard]] DesignPoint find_design_point(const LimitState& margin, std::vector<double> start);

/// Correction of a probability of failure by the curvature of the limit.
struct CurvedLimit {
  std::vector<double> curvatures;     ///< principal, in units of 1/z; > 0: fewer failures
  std::optional<double> probability;  ///< absent if the limit is curved too much
  std::string reason;                 ///< reason for an absent probability
};

/// Implements theory manual eq. (UQ-5): the limit is replaced by a paraboloid at the design point.
/// @param margin  as in `find_design_point`
/// @param at      its design point; converged
[[nodiscard]] CurvedLimit curved_limit(const LimitState& margin, const DesignPoint& at);

}  // namespace strainwave

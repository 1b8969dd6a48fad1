// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace strainwave {

/// What the failure assessment asks of a material.
struct AssessmentMaterial {
  double youngs_modulus = 0.0;  ///< E [Pa]; > 0
  double yield_strength = 0.0;  ///< sigma_Y [Pa]; > 0
  std::optional<double> ultimate_strength =
      {};  ///< sigma_U [Pa]; >= sigma_Y; absent: line ends at 1
};

/// Largest L_r that is accepted, (sigma_Y + sigma_U)/(2 sigma_Y) [-]; eq. (FA-2).
///
/// 1 where the ultimate strength is not known.
/// @throws InputError  if E or sigma_Y is not positive, or sigma_U < sigma_Y
[[nodiscard]] double collapse_limit(const AssessmentMaterial& material);

/// Largest K_r that is accepted at L_r [-].
///
/// Implements theory manual eq. (FA-1), option 1 of BS 7910 for continuous yielding,
///
///     f = (1 + L_r^2/2)^(-1/2) [0.3 + 0.7 exp(-mu L_r^6)],  mu = min(0.001 E/sigma_Y, 0.6)
///
/// up to L_r = 1, then f(1) L_r^((N-1)/(2N)), N = 0.3 (1 - sigma_Y/sigma_U), up to the collapse
/// limit; 0 beyond.  Lower bound of many steels; not for those with a yield plateau.
/// Source: bs7910 (secondary).
///
/// @param L_r       reference stress over yield strength [-]; >= 0
/// @param material  E, sigma_Y, sigma_U
/// @throws InputError  as collapse_limit, or if L_r < 0
[[nodiscard]] double assessment_line(double L_r, const AssessmentMaterial& material);

/// One row of the line as a table.
struct AssessmentPoint {
  double L_r = 0.0;
  double K_r = 0.0;
};

/// The line from L_r = 0 to the collapse limit, whose last row has K_r = 0 [-].
/// @param steps  intervals up to L_r = 1; >= 1
[[nodiscard]] std::vector<AssessmentPoint> assessment_table(const AssessmentMaterial& material,
                                                            int steps = 20);

/// Largest chi at which the interaction formula holds [-].
inline constexpr double kMaxInteractionRatio = 4.0;

/// V, by which plasticity under the load raises the K of a displacement-controlled stress [-].
///
/// Implements theory manual eq. (FA-3),
///
///     V = min(1 + 0.2 L_r + 0.02 chi (1 + 2 L_r), 3.1 - 2 L_r) for L_r < 1.05, else 1,
///
/// chi = K_s L_r/K_p at most 4; a larger one is taken as 4.  Source: bs7910 (secondary).
///
/// @param chi  ratio of the K of the secondary stress to that of the load at yield [-]; >= 0
/// @param L_r  [-]; >= 0
[[nodiscard]] double plasticity_interaction(double chi, double L_r);

}  // namespace strainwave

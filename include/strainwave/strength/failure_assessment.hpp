// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace strainwave {

/// Material properties that the failure assessment needs.
struct AssessmentMaterial {
  double youngs_modulus = 0.0;  ///< E [Pa]; > 0
  double yield_strength = 0.0;  ///< sigma_Y [Pa]; > 0
  std::optional<double> ultimate_strength =
      {};  ///< sigma_U [Pa]; >= sigma_Y; absent: the line ends at 1
};

/// Largest accepted L_r, (sigma_Y + sigma_U)/(2 sigma_Y) [-]; eq. (FA-2).
///
/// The limit is 1 if the ultimate strength is not known.
/// @throws InputError  if E or sigma_Y is not positive, or sigma_U < sigma_Y
[[nodiscard]] double collapse_limit(const AssessmentMaterial& material);

/// Largest accepted K_r at L_r [-].
///
/// Implements theory manual eq. (FA-1), option 1 of BS 7910 for continuous yielding,
///
///     f = (1 + L_r^2/2)^(-1/2) [0.3 + 0.7 exp(-mu L_r^6)],  mu = min(0.001 E/sigma_Y, 0.6)
///
/// up to L_r = 1, then f(1) L_r^((N-1)/(2N)), N = 0.3 (1 - sigma_Y/sigma_U), up to the collapse
/// limit, and 0 beyond.  The line is a lower bound for many steels, except those with a yield
/// plateau.  Source: bs7910 (secondary).
///
/// @param L_r       reference stress over yield strength [-]; >= 0
/// @param material  E, sigma_Y, sigma_U
/// @throws InputError  on the same conditions as collapse_limit, or if L_r < 0
[[nodiscard]] double assessment_line(double L_r, const AssessmentMaterial& material);

/// One row of a table of the assessment line.
struct AssessmentPoint {
  double L_r = 0.0;  ///< reference stress over yield strength [-]
  double K_r = 0.0;  ///< largest accepted stress intensity over toughness [-]
};

/// The assessment line from L_r = 0 to the collapse limit; the last row has K_r = 0 [-].
/// @param material  E and sigma_Y [Pa], > 0; sigma_U [Pa], >= sigma_Y or absent
/// @param steps     intervals up to L_r = 1; >= 1
/// @throws InputError  on the same conditions as collapse_limit, or if `steps` is below 1
[[nodiscard]] std::vector<AssessmentPoint> assessment_table(const AssessmentMaterial& material,
                                                            int steps = 20);

/// Largest chi at which the interaction formula holds [-].
inline constexpr double kMaxInteractionRatio = 4.0;

/// Factor V by which plasticity under the load raises K of a displacement-controlled stress [-].
///
/// Implements theory manual eq. (FA-3),
///
///     V = min(1 + 0.2 L_r + 0.02 chi (1 + 2 L_r), 3.1 - 2 L_r) for L_r < 1.05, else 1,
///
/// with chi = K_s L_r/K_p; a chi above 4 is replaced by 4.  Source: bs7910 (secondary).
///
/// @param chi  ratio of the K of the secondary stress to that of the load at yield [-]; >= 0
/// @param L_r  [-]; >= 0
[[nodiscard]] double plasticity_interaction(double chi, double L_r);

}  // namespace strainwave

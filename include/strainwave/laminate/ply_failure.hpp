// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/laminate/lamina_strength.hpp"
#include "strainwave/laminate/laminate.hpp"

/// @file
/// Stress of the plies of a tube under its loads and under a given curvature, and their first
/// failure.

namespace strainwave {

/// Stress of a layer in the axes of its fibres [Pa].
struct LaminaStress {
  double along = 0.0;   ///< sigma_1, along the fibres; tension > 0
  double across = 0.0;  ///< sigma_2, across the fibres; tension > 0
  double shear = 0.0;   ///< tau, between the two directions
};

/// Left-hand side of the criterion of Tsai and Wu, 1 at failure [-]; theory manual eq. (LA-12).
[[nodiscard]] double tsai_wu(const LaminaStress& stress, const LaminaStrength& strength);

/// Least factor f >= 0 at which `fixed` + f `scaled` fails by (LA-12); theory manual eq. (LA-14).
/// @return  0 if `fixed` alone fails; empty if no factor does
[[nodiscard]] std::optional<double> tsai_wu_factor(const LaminaStress& fixed,
                                                   const LaminaStress& scaled,
                                                   const LaminaStrength& strength);

/// The same by the largest strain (LA-13), with linear strains at the strengths.
[[nodiscard]] std::optional<double> strain_factor(const LaminaStress& fixed,
                                                  const LaminaStress& scaled,
                                                  const Lamina<>& lamina,
                                                  const LaminaStrength& strength);

/// How a layer endures a constant stress beside one that changes its sign over a turn.
struct PlyEndurance {
  double fibre = 0.0;   ///< share of the Haigh line along the fibres, 1 at its end [-]
  double matrix = 0.0;  ///< the same across the fibres and in shear together [-]
  /// The larger of both [-].
  [[nodiscard]] double utilisation() const { return fibre > matrix ? fibre : matrix; }
};

/// Shares of the Haigh lines of a layer; theory manual eq. (LA-19).
/// @param amplitude  of the stress that changes its sign [Pa]; signs do not matter
/// @param mean       constant stress [Pa]
/// @param strength   ends of the lines on the axis of the mean stress [Pa]
/// @param endurance  ends of the lines on the axis of the amplitude [Pa]
[[nodiscard]] PlyEndurance ply_endurance(const LaminaStress& amplitude, const LaminaStress& mean,
                                         const LaminaStrength& strength,
                                         const LaminaEndurance& endurance);

/// Least factor f >= 0 on the mean stress at which a share of (LA-19) is 1, at this amplitude.
/// @return  0 if the amplitude alone reaches a line; empty if no factor does
[[nodiscard]] std::optional<double> endurance_factor(const LaminaStress& amplitude,
                                                     const LaminaStress& mean,
                                                     const LaminaStrength& strength,
                                                     const LaminaEndurance& endurance);

/// Loads of a thin tube.
struct TubeLoads {
  double radius = 0.0;       ///< mean radius r [m]; > 0
  double torque = 0.0;       ///< T [N*m]
  double axial_force = 0.0;  ///< P, tension > 0 [N]
  double curvature = 0.0;    ///< kappa, change of the hoop curvature by the assembly [1/m]
};

/// Stress of one face of a ply.
struct PlyFace {
  std::size_t ply = 0;    ///< from the inner face of the wall
  bool outer = false;     ///< the face that is farther from the axis of the tube
  LaminaStress load;      ///< by torque and axial force
  LaminaStress assembly;  ///< by the curvature, where it is positive
};

/// Computes the stress of both faces of each ply; theory manual eq. (LA-11).
/// @param plies      from the inner face of the wall to the outer one
/// @param thickness  of the wall [m]
/// @param loads      torque, axial force and curvature of the tube, and its mean radius
/// @return           two faces for each ply, the inner one first
[[nodiscard]] std::vector<PlyFace> ply_stresses(std::span<const LaminatePly<double>> plies,
                                                double thickness, const TubeLoads& loads);

}  // namespace strainwave

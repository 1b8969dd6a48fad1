// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/life/fatigue.hpp"

/// @file
/// Fatigue of a point at a free surface whose stresses do not keep their proportion: the wave turns
/// the bending, but not the shear of the torque.

namespace strainwave {

/// Surface factor of the endurance limit of steel, K_R (LI-34) [-]; at most 1.
/// @param roughness         R_z [m]; >= 0; below 1 um the surface counts as polished
/// @param tensile_strength  R_m [Pa]; > 0
[[nodiscard]] double surface_factor(double roughness, double tensile_strength);

/// Stresses at a free surface, without the axial stress.
struct SurfaceStress {
  double hoop = 0.0;   ///< normal stress round the axis [Pa]
  double shear = 0.0;  ///< in the plane of the surface, hoop against axis [Pa]
};

/// Stresses that a point passes in a wave at one torque.
using WaveStates = std::vector<SurfaceStress>;

/// Cycles of a duty: each reaches all stresses of two waves.
struct WaveCycles {
  std::size_t first = 0;   ///< number of the one wave
  std::size_t second = 0;  ///< number of the other; the same: cycles of one wave
  double count = 0.0;      ///< in a repetition of the duty [-]; >= 0
};

/// What a point endures.
struct PlaneStrength {
  double normal = 0.0;             ///< amplitude of normal stress at R = -1 [Pa]; > 0
  double shear = 0.0;              ///< amplitude of shear stress at R = -1 [Pa]; > 0
  double sensitivity = 0.0;        ///< M of normal stress [-]; 0 <= M < 1
  double shear_sensitivity = 0.0;  ///< M_tau [-]; 0 <= M_tau < 1
};

/// Fatigue limit of shear over that of normal stress, and M_tau over M, for steel [-].
inline constexpr double kShearOverNormal = 0.577;

/// The most used plane through a point, at right angles to the surface.
struct CriticalPlane {
  double angle = 0.0;             ///< of the plane's normal against the hoop direction [rad]
  double normal_amplitude = 0.0;  ///< [Pa]
  double normal_mean = 0.0;       ///< [Pa]
  double shear_amplitude = 0.0;   ///< [Pa]
  double shear_mean = 0.0;        ///< [Pa]
  double utilisation = 0.0;       ///< 1 at the endurance limit [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"angle", "rad", "normal of the plane against the hoop direction"},
          &CriticalPlane::angle);
    field({"normal_amplitude", "Pa", "amplitude of the normal stress"},
          &CriticalPlane::normal_amplitude);
    field({"normal_mean", "Pa", "mean normal stress"}, &CriticalPlane::normal_mean);
    field({"shear_amplitude", "Pa", "amplitude of the shear stress"},
          &CriticalPlane::shear_amplitude);
    field({"shear_mean", "Pa", "mean shear stress"}, &CriticalPlane::shear_mean);
    field({"utilisation", "1", "1 at the endurance limit"}, &CriticalPlane::utilisation);
  }
};

/// The plane with the largest utilisation by the extremes of all stresses of a duty.
///
/// Implements theory manual eqs. (LI-35), (LI-36).  For pure shear the utilisation is exact, for
/// one normal stress it is 6 % too high.
/// @param waves     at least one, each with at least one state
/// @param strength  what the point endures: limits [Pa], > 0, and sensitivities [-], 0 <= M < 1
/// @throws InputError  if a number is out of range
[[nodiscard]] CriticalPlane critical_plane(std::span<const WaveStates> waves,
                                           const PlaneStrength& strength);

/// Damage of a repetition of a duty, on the plane with the most damage (LI-37) [-].
/// @param waves        the stresses at each torque
/// @param cycles       of the waves and between them
/// @param strength     as in critical_plane; `normal` is the amplitude at the knee of the line
/// @param knee_cycles  cycles at the endurance limit [-]; > 0
/// @param slope        k of the line above it [-]; >= 1
/// @param rule         the line below the knee
/// @throws InputError  if a number is out of range
[[nodiscard]] double plane_damage(std::span<const WaveStates> waves,
                                  std::span<const WaveCycles> cycles, const PlaneStrength& strength,
                                  double knee_cycles, double slope, MinerRule rule);

/// Stresses of bending and torsion, as the handbooks of these drives take them.
struct HandbookStress {
  double bending_amplitude = 0.0;  ///< amplitude of the bending stress [Pa]; >= 0
  double shear_amplitude = 0.0;    ///< amplitude of the shear stress [Pa]; >= 0
  double shear_mean = 0.0;         ///< mean shear stress [Pa]; >= 0
};
/// Safety of bending and torsion by the handbooks of these drives (LI-38) [-].
/// @param stress          at the point [Pa]; each >= 0
/// @param strength        of the part, so that K_sigma and K_tau are contained
/// @param specimen_shear  tau_-1 of a smooth specimen [Pa]; > 0
/// @return  absent if there is no stress
[[nodiscard]] std::optional<double> handbook_reserve(const HandbookStress& stress,
                                                     const PlaneStrength& strength,
                                                     double specimen_shear);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"

namespace strainwave::gear_fem {

/// Names of the tips: toward +z and toward -z.
inline constexpr std::array<std::string_view, 2> kTips = {"upper", "lower"};

/// Largest K_I that the integrals may leave on touching faces, over K0 = tau sqrt(pi a).
inline constexpr double kClosedShare = 0.02;

enum TubeTag { kTubeFree = 1, kTubeClamp, kTubeLoad, kTubeCrack };

struct TubePlan {
  double mean_radius{};   ///< mean radius [m]
  double length{};        ///< [m]
  double place{};         ///< z of the template's origin [m]
  double angle{};         ///< beta of its first axis [rad]
  double rigid_radius{};  ///< the plan is turned without strain inside of it [m]
  /// Radial place of the plan's surface from the middle surface; lengths and angles are true on
  /// this surface [m].
  double surface = 0;
  /// radius at which the turn ends, over the rigid radius; it ends at the end of the tube at the
  /// latest [-]
  double turn_reach{};
};

/// A plane plan (x along the crack, y normal to it, radial place from the middle surface) rolled
/// onto the tube without strain on `TubePlan::surface`.  At the ends, grid lines run along the
/// generators; near the crack, a smooth rotation that preserves areas turns them (FE-29).
struct TubeBody {
  TubePlan plan;
  fem::PointMap map;               ///< template -> space
  std::array<double, 2> along{};   ///< ends of the template in x [m]
  std::array<double, 2> across{};  ///< ends of the template in y [m]
  double longest_along{};          ///< longest cell in x [m]
  double longest_across{};         ///< longest cell in y [m]
  std::function<int(const fem::Point3&)>
      end_tag;  ///< kTubeClamp, kTubeLoad, 0; of a template point
};

/// @throws InputError  if the crack is too close to an end, or too long
[[nodiscard]] TubeBody tube_body(const TubePlan& plan);

/// Traction of a torque on the end of a tube with this wall, tau = T r/J.
[[nodiscard]] fem::Traction end_torque(double mean_radius, double wall_thickness, double torque);

/// The problem of a tube clamped at z = 0.
[[nodiscard]] fem::SolidProblem clamped_tube(const fem::Elasticity& material);
/// The traction of a torque at z = length, with the stress of the tube without a crack.
[[nodiscard]] fem::SolidLoad tube_torsion(double mean_radius, double wall_thickness, double torque);
inline constexpr std::array kBothSenses = {TorqueSense::positive, TorqueSense::negative};
/// Sign of a torque about +z.
[[nodiscard]] constexpr double sign_of(TorqueSense sense) {
  return sense == TorqueSense::positive ? 1.0 : -1.0;
}

/// By how much smaller the crack is that judges the given one, over its size [-].
inline constexpr double kSizeStep = 0.01;

/// A crack of one size.
struct SizedRelease {
  double work;     ///< added by the crack [J], (FE-26)
  double release;  ///< its release per unit of size over the given one, int G dA/ds [J]
};
/// The release of the given crack by the work that a crack smaller by kSizeStep lacks [J], (FE-28).
[[nodiscard]] double release_by_work(const SizedRelease& given, const SizedRelease& smaller);

/// Polar moment J = pi/2 (ro^4 - ri^4) [m^4].
[[nodiscard]] double tube_polar_moment(double mean_radius, double wall_thickness);

void check_tube(double mean_radius, double wall_thickness, double length, double angle,
                double place);

/// Fills in `usable` and `reason`.
void judge(TubeCrackResult& result, bool derivative, bool overlap);

}  // namespace strainwave::gear_fem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/fem/elasticity.hpp"
#include "strainwave/fem/harmonic_section.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "strainwave/model/result/oval_stress.hpp"

/// @file
/// A sound flexspline at work: bent oval by the wave generator, and twisted by the torque.

namespace strainwave::gear_fem {

struct OvalOptions {
  /// true: the cam only pushes; false: the band follows the cam all round
  bool one_sided = true;
  int order = 5;        ///< p of the section [-]; in 3..8
  int most_waves = 48;  ///< highest number of waves of the pressure [-]; a multiple of 4, 8 to 96
  LargeRotations large_rotations = LargeRotations::automatic;
  int most_bent_waves = 12;  ///< highest number of waves with large rotations [-]; even, 4 to 24
  /// Grid lines that follow each other more closely toward the corners of the section, for the
  /// stress within a few walls of a corner.
  bool fine_corners = false;
};

/// Contact of the wave generator with the bore.
struct OvalContact : WaveContact {
  double overlap{};              ///< deepest remaining overlap over w_0 [-]
  int steps{};                   ///< linear systems of the contact; 0 if it is not one-sided
  bool large_rotations = false;  ///< whether they were computed
  int iterations{};              ///< of the large rotations; 0 without them

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = OvalContact;
    WaveContact::describe(field);
    field({.name = "overlap", .unit = "1", .doc = "deepest overlap over w_0", .detail = true},
          &R::overlap);
    field({"large_rotations", "", "whether the oval was computed with large rotations"},
          &R::large_rotations);
    field({.name = "iterations",
           .unit = "",
           .doc = "iterations of the large rotations",
           .detail = true},
          &R::iterations);
  }
};

/// Largest nodal force out of equilibrium over the largest load, in a usable result [-].
inline constexpr double kOvalEquilibrium = 1e-5;

/// What the oval and a unit torque cause at one place (r, z) of the section, round the axis.
struct OvalPlace {
  double r{};                                ///< [m]
  std::vector<fem::HarmonicPoint> of_waves;  ///< of 0, 2, 4, ... waves
  /// the same for small rotations; empty if these are the answer
  std::vector<fem::HarmonicPoint> of_small_waves;
  fem::HarmonicPoint of_torque;  ///< per N*m
};

/// Cylindrical components of a field: r, theta, z; and rr, theta theta, zz, theta z, rz, r theta.
struct OvalField {
  std::array<double, 3> displacement{};  ///< [m]
  std::array<double, 6> stress{};        ///< [Pa]
};

/// A sound cup under the wave generator and under torque; elastic (FE-52), with large rotations of
/// the oval (FE-53).
///
/// The end of the boss is held, else the bore of the diaphragm, else the end of the barrel.  The
/// wave generator presses on a band of the rim's bore, in the middle of the rim, without friction;
/// its pressure is even over the width of the band, and the mean displacement over this width
/// follows the cam.  The torque acts evenly on the outside of the rim.
///
/// Range: strains are small.  The torque is computed for the round cup, and its stress is added.
class OvalCup {
 public:
  /// @throws InputError   for a cup without a rim, or values out of range; if the cam does not
  /// touch
  ///                      the bore
  /// @throws SolverError  if the contact or the large rotations do not converge
  OvalCup(const CupSection& cup, const fem::Elasticity& steel, const CamFit& fit,
          const OvalOptions& options = {});
  ~OvalCup();
  OvalCup(OvalCup&&) noexcept;
  OvalCup& operator=(OvalCup&&) noexcept;

  [[nodiscard]] const OvalContact& contact() const;
  [[nodiscard]] std::size_t unknowns() const;  ///< of one number of waves
  /// Largest nodal force out of equilibrium over the largest nodal load, over all solutions [-].
  [[nodiscard]] double equilibrium_residual() const;
  /// Order of the stress that small rotations leave out, E (w_0/r)^2 [Pa].
  [[nodiscard]] double second_order_stress() const;

  /// The waves at a place of the section.
  /// @param r, z  [m], with z from the outer face of the diaphragm as in CupSection
  /// @param beyond  a place this far outside of a cell, over the cell's size, counts as inside [-]
  /// @throws InputError  for a place outside of the section
  [[nodiscard]] OvalPlace at(double r, double z, double beyond = 1e-7) const;

  /// The fields at a place and an angle.
  /// @param from_lobe  angle from a lobe of the wave generator toward +theta [rad]
  /// @param torque     T [N*m], in the sense of +theta on the rim
  [[nodiscard]] OvalField field(const OvalPlace& place, double from_lobe, double torque) const;
  /// The same for small rotations.
  [[nodiscard]] OvalField small_field(const OvalPlace& place, double from_lobe,
                                      double torque) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace strainwave::gear_fem

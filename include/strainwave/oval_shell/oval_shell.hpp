// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/turning_cup.hpp"

/// @file
/// A sound flexspline at work as a thin shell: bent oval by the wave generator, and twisted.

namespace strainwave {

/// A cup of thin walls.  z = 0 is the end of the barrel toward the diaphragm, or the held end of a
/// barrel without one.  The bore of the diaphragm is held.
struct ShellCup {
  TubeSection barrel;                  ///< from z = 0
  TubeSection rim;                     ///< from the end of the barrel
  std::optional<Diaphragm> diaphragm;  ///< meets the barrel in the middle of its wall
  double youngs_modulus{};             ///< E [Pa]; > 0
  double poissons_ratio{};             ///< nu [-]; in [0, 0.5)
};

/// Membrane force and moment of one number of waves, as strains, at a place of the barrel.
struct ShellWave {
  double axial_strain{};    ///< cosine [-]
  double hoop_strain{};     ///< cosine [-]
  double shear_strain{};    ///< sine [-]
  double axial_bend{};      ///< curvature, cosine [1/m]
  double hoop_bend{};       ///< cosine [1/m]
  double twist{};           ///< sine [1/m]
  double axial_rotation{};  ///< of the normal in the meridian, cosine [-]
  double hoop_rotation{};   ///< of the normal round the axis, sine [-]
  double spin{};            ///< about the normal, sine [-]
};

/// Stress in the wall of the barrel [Pa].
struct WallStress {
  double axial{};  ///< zz
  double hoop{};   ///< theta theta
  double shear{};  ///< theta z
};

/// What the wave generator does, in numbers.
struct ShellContact {
  double lobe_force{};  ///< resultant of the pressure of one lobe along its axis [N]
  double half_arc{};    ///< half of the arc on which a lobe presses [rad]
  int iterations{};     ///< of the large rotations; 0: small rotations

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = ShellContact;
    field({"lobe_force", "N", "force of one lobe of the wave generator on the bore"},
          &R::lobe_force);
    field({"half_arc", "rad", "half of the arc on which a lobe presses"}, &R::half_arc);
    field({.name = "iterations",
           .unit = "",
           .doc = "iterations of the large rotations",
           .detail = true},
          &R::iterations);
  }
};

/// A sound cup under the wave generator and under torque, as a shell.
struct OvalShell {
  ShellCup cup;
  bool large_rotations = false;
  ShellContact contact;
  /// the barrel at ascending z; the waves 0, 2, 4, ... at each place
  std::vector<double> places;
  std::vector<std::vector<ShellWave>> waves;

  /// Stress at a place of the barrel.
  /// @param z          [m], from 0 to the length of the barrel
  /// @param zeta       from -1 at the inner face to 1 at the outer face
  /// @param from_lobe  angle from a lobe toward +theta [rad]
  /// @param torque     T [N*m], in the sense of +theta on the rim
  /// @throws InputError  for a place outside of the barrel
  [[nodiscard]] WallStress stress(double z, double zeta, double from_lobe, double torque) const;
  /// The waves at a place, interpolated.
  /// @throws InputError  for a place outside of the barrel
  [[nodiscard]] std::vector<ShellWave> waves_at(double z) const;
};

/// Computes the oval.
///
/// Implements theory manual eqs. (CU-1) to (CU-4).  Large rotations are computed if their second
/// order stress E (w_0/R)^2 exceeds 2 % of the bending stress of the rim.
///
/// Range: thin walls; the rim's wall covers that of the barrel; the hub is rigid.
/// Accuracy: the table of (CU-4).
///
/// @throws InputError   for lengths out of range; if the cam does not touch the bore
/// @throws SolverError  if contact or large rotations do not converge
[[nodiscard]] OvalShell oval_shell(const ShellCup& cup, const CamFit& cam);

/// The stress of waves at a place of the barrel, as OvalShell::stress.
[[nodiscard]] WallStress wall_stress(const ShellCup& cup, const std::vector<ShellWave>& waves,
                                     bool large_rotations, double zeta, double from_lobe,
                                     double torque);

}  // namespace strainwave

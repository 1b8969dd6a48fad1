// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "strainwave/model/result/oval_stress.hpp"

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

  /// Where a part begins and ends: z, or the radius in the diaphragm [m].
  [[nodiscard]] std::array<double, 2> ends(WallPart part) const;
};

/// Membrane force and moment of one number of waves, as strains, at a place of the meridian.
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

/// A place of the meridian.
struct ShellPlace {
  WallPart part = WallPart::barrel;  ///< the part that has the place
  /// z, or the radius if the place is in the diaphragm [m]
  double at{};
  double radius{};               ///< of the middle surface [m]
  double thickness{};            ///< [m]
  double torque_share{};         ///< of the output torque that the wall carries here [-]
  std::vector<ShellWave> waves;  ///< the waves 0, 2, 4, ...
};

/// Stress in the wall [Pa].
struct WallStress {
  double axial{};  ///< along the meridian: zz, in the diaphragm rr
  double hoop{};   ///< theta theta
  double shear{};  ///< theta z, in the diaphragm theta r
};

/// Contact of the wave generator with the bore.
struct ShellContact : WaveContact {
  int iterations{};  ///< of the large rotations; 0: small rotations

  template <class Visitor>
  static void describe(Visitor&& field) {
    WaveContact::describe(field);
    field({.name = "iterations",
           .unit = "",
           .doc = "iterations of the large rotations",
           .detail = true},
          &ShellContact::iterations);
  }
};

/// A sound cup under the wave generator and under torque, as a shell.
struct OvalShell {
  ShellCup cup;                  ///< as given
  bool large_rotations = false;  ///< whether large rotations were computed
  ShellContact contact;          ///< of the wave generator with the bore
  /// Pressure on the band at even angles from a lobe, 0, to the middle between the lobes, pi/2
  /// [Pa].
  std::vector<double> pressure;
  /// The barrel at ascending z, or the whole meridian from the bore of the diaphragm.
  std::vector<ShellPlace> places;

  /// Stress at a place, eq. (CU-4).
  /// @param place      of this shell, from `places`, `part` or `at`
  /// @param zeta       from -1 at the inner face to 1 at the outer face
  /// @param from_lobe  angle from a lobe toward +theta [rad]
  /// @param torque     T [N*m], in the sense of +theta on the rim
  [[nodiscard]] WallStress stress(const ShellPlace& place, double zeta, double from_lobe,
                                  double torque) const;
  /// Stress at a place of the barrel.
  /// @param z          [m], from 0 to the length of the barrel
  /// @param zeta       from -1 at the inner face to 1 at the outer face
  /// @param from_lobe  angle from a lobe toward +theta [rad]
  /// @param torque     T [N*m], in the sense of +theta on the rim
  /// @throws InputError  for a place outside of the barrel
  [[nodiscard]] WallStress stress(double z, double zeta, double from_lobe, double torque) const;
  /// The places of a part.
  [[nodiscard]] std::span<const ShellPlace> part(WallPart part) const;
  /// A place of a part, interpolated.
  /// @param part  barrel; also rim or diaphragm if the shell has the whole meridian
  /// @param at    z, or the radius if the part is the diaphragm [m]; within `ShellCup::ends`
  /// @throws InputError  for a place outside of the part
  [[nodiscard]] ShellPlace at(WallPart part, double at) const;
  /// A place of the barrel.
  /// @throws InputError  for a place outside of the barrel
  [[nodiscard]] ShellPlace barrel_at(double z) const { return at(WallPart::barrel, z); }
};

/// The flexspline of a drive as a shell.
/// @param gear  passes require_turning_cup
[[nodiscard]] ShellCup shell_cup(const GearSet& gear);

/// How `oval_shell` computes, and what it keeps.
struct ShellOptions {
  /// automatic: the size of their second order stress decides, see `oval_shell`
  LargeRotations large_rotations = LargeRotations::automatic;
  bool whole_meridian = false;  ///< false: only the barrel's places are kept
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
[[nodiscard]] OvalShell oval_shell(const ShellCup& cup, const CamFit& cam,
                                   const ShellOptions& options = {});

}  // namespace strainwave

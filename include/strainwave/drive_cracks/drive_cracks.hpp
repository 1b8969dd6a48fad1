// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/drive_cracks/faces.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave {

/// Size and shape of a crack.
struct CrackSize {
  double size = 0.0;          ///< a: depth, or half length of a crack through the thickness [m]
  double aspect_ratio = 1.0;  ///< a/c of a surface crack, in (0, 1]; 1 of all others [-]

  /// A surface crack by its depth a and half length c, each of which may grow by itself [m].
  [[nodiscard]] static CrackSize of(double depth, double half_length) {
    return {.size = depth, .aspect_ratio = depth / half_length};
  }
  /// c of a surface crack [m].
  [[nodiscard]] double half_length() const { return size / aspect_ratio; }
};

/// K_I, K_II, K_III [Pa*m^0.5, or that per unit of a load]; K_I < 0 presses the faces together.
using Modes = std::array<double, 3>;

/// K at one point of a front per unit of each load.
struct FrontIntensity {
  UnitStressIntensity<2> load;  ///< over [axial force, torque] [Pa*m^0.5/N, Pa*m^0.5/(N*m)]
  /// Of the assembly at a lobe, where its hoop stress is tension [Pa*m^0.5]; at a wave angle theta
  /// from it times `DriveCrack::assembly_phase(theta)`.
  Modes assembly{};
};

/// A crack of a drive as stiffness, strength and growth need it: whatever its kind, K along its
/// front at any size, and how far that can be trusted.
struct DriveCrack {
  std::string path;      ///< "flexspline.crack[0]"
  std::string kind;      ///< "through"
  std::string material;  ///< name of its material; empty: the member has none
  /// It acts through contacts, which only the coupled drive has: nothing below is given.
  bool acts_in_coupled_drive = false;

  std::string size_name;  ///< "depth" or "half_length"
  CrackSize size;         ///< in the file
  double ligament = 0.0;  ///< what that leaves of the section [m]
  CrackModuli moduli;     ///< E' and mu [Pa]
  sif::Constraint constraint = sif::Constraint::plane_strain;
  BothSenses faces;  ///< at the given load, without the assembly
  /// False: the load has one sense, whatever that of the torque (the force on a lobe).
  bool reverses = true;

  /// K along the front at any size up to the end of the range, with the faces apart or pressed.
  /// A crack of the bearing: at the contact of the given torque, which is not linear in it.
  std::function<std::vector<FrontIntensity>(const CrackSize&, Faces)> front;
  /// K along the front per unit of a bending moment of the member, the crack in the middle of the
  /// pulled side [Pa*m^0.5/(N*m)]; empty where it cannot be stated.
  std::function<std::vector<Modes>(const CrackSize&)> bending;
  /// Yield strength at which the net section is fully plastic, at a size, under an axial force [N]
  /// and a torque [N*m]; proportional to both [Pa].  Throws InputError at a size that leaves
  /// nothing of the section, beyond `range_end`.
  std::function<double(const CrackSize&, double axial_force, double torque)> reference_stress;

  double range_end = 0.0;              ///< largest size that the solutions reach [m]
  std::string range_text;              ///< what that size is
  bool assembly = false;               ///< the assembly stresses it
  double assembly_peak = 0.0;          ///< largest elastic stress of the assembly in the wall [Pa]
  int wave_number = 0;                 ///< U [-]
  std::string unknown;                 ///< which stress of the crack is not known; empty: all is
  std::string next_step;               ///< what to do about that
  std::vector<StrengthNote> notes;     ///< what the stress leaves out
  std::vector<Note> kinks;             ///< where its compliance has one right at this drive
  std::vector<std::string> equations;  ///< tags of the theory manual

  /// cos(U theta), by which K of the assembly varies [-].
  /// @param wave_angle  theta, from a lobe to the crack [rad]
  [[nodiscard]] double assembly_phase(double wave_angle) const;
};

/// Turns a drive into its loaded cracks: once for all that use them.
///
/// Implements theory manual eqs. (FR-4) to (FR-17), (FA-6) to (FA-12), (FA-14).
///
/// @param gear  has passed `check`
/// @return      one per crack: wave generator, flexspline, mesh, circular spline, output shaft
/// @throws InputError  if the material of a crack is missing or contradicts itself
[[nodiscard]] std::vector<DriveCrack> drive_cracks(const GearSet& gear);

}  // namespace strainwave

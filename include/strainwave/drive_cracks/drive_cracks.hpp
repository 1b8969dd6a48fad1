// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/drive_cracks/faces.hpp"
#include "strainwave/drive_cracks/shaft_group.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/turn_table.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave {

/// Size and shape of a crack.
struct CrackSize {
  double size = 0.0;          ///< a: depth, or half length of a crack through the thickness [m]
  double aspect_ratio = 1.0;  ///< a/c of a surface crack, in (0, 1]; 1 for all other cracks [-]

  /// A surface crack by its depth a and half length c, which may grow independently [m].
  [[nodiscard]] static CrackSize of(double depth, double half_length) {
    return {.size = depth, .aspect_ratio = depth / half_length};
  }
  /// Half length c of a surface crack [m].
  [[nodiscard]] double half_length() const { return size / aspect_ratio; }
};

/// The factors K_I, K_II, K_III [Pa*m^0.5, or Pa*m^0.5 per unit of a load]; K_I < 0 presses the
/// faces together.
using Modes = std::array<double, 3>;

/// Stress intensity at one point of a front, per unit of each load.
struct FrontIntensity {
  UnitStressIntensity<2> load;  ///< over [axial force, torque] [Pa*m^0.5/N, Pa*m^0.5/(N*m)]
  /// K of the assembly for a crack at a lobe, where the hoop stress is tensile [Pa*m^0.5].  At a
  /// wave angle theta from the lobe, multiply by `DriveCrack::assembly_phase(theta)`.
  Modes assembly{};
  /// K that acts whatever the load is; for a crack at one torque, on which K does not depend in
  /// proportion [Pa*m^0.5]
  Modes constant{};
};

/// The load that changes in each turn of a running drive, seen from the crack.
enum class TurningLoad {
  none,            ///< the crack sees the torque alone
  wave,            ///< the assembly, whose sign changes with each wave
  wave_at_spline,  ///< the same, seen from the circular spline, which passes fewer waves
  bending,         ///< a bending moment fixed in space, round which the crack turns
  balls,           ///< the pressure of the balls, from 0 to its full value and back
};

/// A crack of a drive, in one form for all kinds, as stiffness, strength and growth need it: K
/// along its front at any size, and the limits of its validity.
struct DriveCrack {
  std::string path;      ///< "flexspline.crack[0]"
  std::string kind;      ///< "through"
  std::string material;  ///< name of its material; empty: the member has no material
  /// True if the crack acts through contacts, which only the coupled drive models.  The members
  /// below, apart from `turn_table`, are then empty.
  bool acts_in_coupled_drive = false;

  std::string size_name;           ///< "depth" or "half_length"
  CrackSize size;                  ///< size in the file
  double ligament = 0.0;           ///< thickness of the section that the crack leaves [m]
  double through_thickness = 0.0;  ///< thickness of the wall of a through crack, else 0 [m]
  TurningLoad turning = TurningLoad::none;  ///< load that changes in each turn
  CrackModuli moduli;                       ///< E' and mu [Pa]
  /// Whether the crack cuts the plies of a laminate.  Modes I and II are then those of (LA-15), and
  /// `moduli` is the reference modulus.
  bool laminate = false;
  /// Equivalent K at which the crack fractures [Pa*m^0.5]; absent: the material states none
  std::optional<double> toughness = {};
  /// Plane stress or plane strain ahead of the front; the plastic zone depends on it.
  sif::Constraint constraint = sif::Constraint::plane_strain;
  BothSenses faces;  ///< state of the faces at the given load, without the assembly
  /// False if the load has the same sense for both senses of torque, as the force on a lobe does.
  bool reverses = true;

  /// K along the front at any size up to the end of the range, with the faces apart or pressed.
  /// For a crack of the bearing, the contact is that of the given torque, on which K does not
  /// depend linearly.
  std::function<std::vector<FrontIntensity>(const CrackSize&, Faces)> front;
  /// K along the front per unit of a bending moment of the member, with the crack in the middle of
  /// the tension side; for a surface crack of a shaft the largest K in a turn (GR-34)
  /// [Pa*m^0.5/(N*m)]; empty if it cannot be stated.
  std::function<std::vector<Modes>(const CrackSize&)> bending;
  /// The first and the last point of `front` alone, in a fraction of its time; empty: there is no
  /// faster way to them.
  std::function<std::vector<FrontIntensity>(const CrackSize&, Faces)> front_ends;
  /// The first and the last point of `bending` alone; empty where `front_ends` or `bending` is.
  std::function<std::vector<Modes>(const CrackSize&)> bending_ends;
  /// Yield strength at which the net section is fully plastic [Pa], as a function of size, axial
  /// force [N] and torque [N*m]; proportional to both loads.  Throws InputError at a size beyond
  /// `range_end`, where no section is left.
  std::function<double(const CrackSize&, double axial_force, double torque)> reference_stress;

  /// The cracks of its section that influence this crack (CG-9); null: none.  All cracks of one
  /// call of `drive_cracks` share it, and `front` answers at the half lengths that it keeps for the
  /// other cracks.
  std::shared_ptr<WallGroup> group = {};
  std::size_t in_group = 0;  ///< its place among the members of the group
  /// K along the front with the faces of all cracks of the group as the given load leaves them
  /// under one sense of the torque; empty without a group.  `front` takes all faces as apart.
  std::function<std::vector<FrontIntensity>(const CrackSize&, TorqueSense)> front_in_group = {};

  /// The annular cracks that shield this one in torsion (CG-12); null: none.  All cracks of one
  /// call of `drive_cracks` share it, and `front` answers at the depths that it keeps for the
  /// others.
  std::shared_ptr<ShaftGroup> shaft_group = {};
  std::size_t in_shaft_group = 0;  ///< its place among the cracks of that group

  int count = 1;  ///< equal cracks of the row (CG-7) [-]
  /// Largest half length of a surface crack at a depth, both [m]; empty: no such limit.
  std::function<double(double depth)> longest;
  /// half length of a surface crack at which its solution ends [m]
  double length_end = std::numeric_limits<double>::infinity();
  double range_begin = 0.0;  ///< smallest size at which K over a turn is known [m]
  double range_end = 0.0;    ///< largest size at which the solutions are valid [m]
  std::string range_text;    ///< description of that size
  /// K over the turn of the wave generator, in place of `front` with the assembly; null: none
  std::shared_ptr<const TurnTable> turn_table;
  bool ends_in_table = false;  ///< whether `range_end` is the end of `turn_table`
  bool assembly = false;       ///< true if the assembly stresses the crack
  double assembly_peak = 0.0;  ///< largest elastic stress of the assembly in the wall [Pa]
  int wave_number = 0;         ///< U [-]
  /// the stress of the crack that is not known; empty: all are known
  std::string unknown;
  std::string next_step;  ///< action that makes the stress known
  /// the model of the stress, in words, if it gives an upper bound; empty: it gives none
  std::string upper_bound;
  std::vector<StrengthNote> notes;     ///< effects that the stress leaves out
  std::vector<std::string> equations;  ///< tags of the theory manual

  /// Factor cos(U theta) by which K of the assembly varies round the wall [-].
  /// @param wave_angle  angle theta from a lobe to the crack [rad]
  [[nodiscard]] double assembly_phase(double wave_angle) const;
};

/// Gives a crack its table of K over a turn (GR-30): the table replaces what bounds or leaves out
/// the stress of the assembly, and may end the range of sizes sooner.
void take_turn_table(DriveCrack& crack, std::shared_ptr<const TurnTable> table);

/// Turns a drive into its loaded cracks, in one form for all models that use them.
///
/// Implements theory manual eqs. (FR-4) to (FR-17), (FA-6) to (FA-12), (FA-14).
///
/// @param gear  has passed `check`
/// @return      one element per crack, in the order wave generator, flexspline, mesh, circular
///              spline, output shaft
/// @throws InputError  if the material of a crack is missing or contradicts itself
[[nodiscard]] std::vector<DriveCrack> drive_cracks(const GearSet& gear);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/axisymmetric.hpp"
#include "strainwave/gear_fem/checks.hpp"
#include "strainwave/model/input/output_shaft.hpp"

namespace strainwave::gear_fem {

/// A shoulder: beyond it the shaft is thicker.
struct ShaftShoulder {
  double position = 0.0;        ///< z of the shoulder's face [m]; in (0, length)
  double outer_diameter = 0.0;  ///< beyond it [m]; > that before it
  double fillet_radius = 0.0;   ///< [m]; >= 0, <= half the step; 0 is a sharp corner
};

/// A circumferential crack of uniform depth, normal to the axis.
struct ShaftCrack {
  enum class Surface { outer, inner };
  Surface surface = Surface::outer;
  double depth = 0.0;     ///< a [m]; > 0, < wall
  double position = 0.0;  ///< z [m]; before the shoulder
};

/// A shaft from z = 0, where it is held, to z = length, where it is loaded.
struct ShaftSection {
  double outer_diameter = 0.0;  ///< [m]; > 0
  double inner_diameter = 0.0;  ///< [m]; >= 0, < outer; 0 is solid
  double length = 0.0;          ///< [m]; > 0
  std::optional<ShaftShoulder> shoulder = {};
  std::optional<ShaftCrack> crack = {};
};

/// The output shaft of a drive with one of its cracks, halfway along.
/// @throws std::out_of_range  if there is no such crack
[[nodiscard]] ShaftSection shaft_section(const OutputShaft& shaft, std::size_t crack);

/// Grid of a shaft: cells are squares of half the crack's depth, ligament or distance to an end,
/// whichever is least, at its tip, and grow away from it.
/// @throws InputError  for lengths out of range
[[nodiscard]] fem::SectionMesh mesh_shaft(const ShaftSection& shaft);

/// A crack smaller than the given one, or the given one, per unit of load.
struct ShaftCrackSize {
  double depth = 0.0;  ///< a [m]
  fem::TipResult tip;
};

/// One load on a cracked shaft, per unit of load.
struct ShaftCrackLoad {
  double sound_compliance = 0.0;  ///< without the crack [rad/(N*m)] or [m/N]
  fem::TipResult tip;             ///< at the given depth
  /// int 2 G dA over the crack's growth from nothing, or, where that is more than kDifferenceShare
  /// of the sound compliance, the difference of two compliances (FE-8) [as the compliance].
  double added_compliance = 0.0;
  /// The same by subtracting two compliances: for small cracks it has no digits.
  double added_by_difference = 0.0;
  /// C of neighbouring sizes, their difference over int 2 G dA, - 1 (FE-9) [-].
  double growth_check = 0.0;
  double energy_balance = 0.0;        ///< the worst of all solutions [-]
  double equilibrium_residual = 0.0;  ///< the worst [-]
  double worst_jacobian = 0.0;        ///< the worst [-]
  std::size_t dofs = 0;               ///< of one solution
  bool usable = false;
  std::string reason;                      ///< why it may not be used; empty if it may
  std::vector<ShaftCrackSize> sizes = {};  ///< that (FE-8) has solved, the given depth last
  fem::SampledFields fields = {};          ///< at the given depth, as the options ask

  [[nodiscard]] Checks checks() const;
};

/// The same of one kind of load, which gives the numbers their units.
template <fem::SectionLoad kLoad>
struct LoadOnShaft : ShaftCrackLoad {
  template <class Visitor>
  static void describe(Visitor&& field) {
    constexpr bool kTwisted = kLoad == fem::SectionLoad::torsion;
    constexpr std::string_view kCompliance = kTwisted ? "rad/(N*m)" : "m/N";
    field({"sound_compliance", kCompliance, "without the crack"},
          &ShaftCrackLoad::sound_compliance);
    field({"added_compliance", kCompliance, "by the crack"}, &ShaftCrackLoad::added_compliance);
    field({"added_by_difference", kCompliance, "the same by subtracting two solutions"},
          &ShaftCrackLoad::added_by_difference);
    field({"energy_release_rate_per_load_squared", kTwisted ? "J/(m^2*N^2*m^2)" : "J/(m^2*N^2)",
           "G of a load of one"},
          [](const LoadOnShaft& load) { return load.tip.energy_release_rate; });
    field({"evidence", "", "how well the solution agrees with itself"}, &ShaftCrackLoad::checks);
    field({"usable", "", "whether the checks agree"}, &ShaftCrackLoad::usable);
    field({"reason", "", "why not; empty if they do"}, &ShaftCrackLoad::reason);
  }
};

/// A cracked shaft under torque and axial force.
struct ShaftCrackResult {
  LoadOnShaft<fem::SectionLoad::torsion> torsion;  ///< per N*m
  /// Per N; its K_I is negative under compression: closed.
  LoadOnShaft<fem::SectionLoad::tension> tension;

  [[nodiscard]] std::array<const ShaftCrackLoad*, 2> loads() const { return {&torsion, &tension}; }
};

/// A crack that adds more than this share of the sound compliance is measured by subtraction [-]:
/// the difference keeps six digits, and the integral's five depths miss up to half of a deep crack.
inline constexpr double kDifferenceShare = 1e-3;

/// How far the checks of a usable result may be off [-].
inline constexpr double kGrowthTolerance = 2e-3;
inline constexpr double kRingTolerance = 5e-3;
inline constexpr double kDisplacementTolerance = 2e-2;
inline constexpr double kResidualTolerance = 1e-6;
inline constexpr double kEnergyTolerance = 1e-6;

/// Solves a cracked shaft: seven times for each load, at the depth, next to it on both sides, at
/// three sizes below it, and without the crack.
/// @throws InputError, SolverError  as fem::solve_section; InputError without a crack
[[nodiscard]] ShaftCrackResult solve_shaft(const ShaftSection& shaft,
                                           const fem::Elasticity& elasticity,
                                           const fem::SectionOptions& options = {});

}  // namespace strainwave::gear_fem

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

/// A shoulder, beyond which the shaft is thicker.
struct ShaftShoulder {
  double position = 0.0;        ///< z of the shoulder's face [m]; in (0, length)
  double outer_diameter = 0.0;  ///< diameter beyond the shoulder [m]; > outer diameter before it
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

/// The output shaft of a drive with one of its cracks, placed at half length.
/// @throws std::out_of_range  if the crack does not exist
[[nodiscard]] ShaftSection shaft_section(const OutputShaft& shaft, std::size_t crack);

/// Meshes a shaft.  At the tip, cells are squares of half the crack's depth, ligament or distance
/// to an end, whichever is least.  Cells grow away from the tip.
/// @throws InputError  for lengths out of range
[[nodiscard]] fem::SectionMesh mesh_shaft(const ShaftSection& shaft);

/// Results for the given crack or a smaller one, per unit of load.
struct ShaftCrackSize {
  double depth = 0.0;  ///< a [m]
  fem::TipResult tip;
};

/// Results for one load on a cracked shaft, per unit of load.
struct ShaftCrackLoad {
  double sound_compliance = 0.0;  ///< compliance without the crack [rad/(N*m)] or [m/N]
  fem::TipResult tip;             ///< crack tip at the given depth
  /// Integral of 2 G dA over the growth of the crack from zero (FE-8) [as the compliance].  If this
  /// exceeds kDifferenceShare of the sound compliance, the difference of two compliances is used.
  double added_compliance = 0.0;
  /// Added compliance as the difference of two compliances; for small cracks no digit is
  /// significant.
  double added_by_difference = 0.0;
  /// Difference of C between neighbouring sizes over int 2 G dA, - 1 (FE-9) [-].
  double growth_check = 0.0;
  double energy_balance = 0.0;        ///< worst value of all solutions [-]
  double equilibrium_residual = 0.0;  ///< worst value of all solutions [-]
  double worst_jacobian = 0.0;        ///< worst value of all solutions [-]
  std::size_t dofs = 0;               ///< unknowns of one solution
  bool usable = false;
  /// reason why the result must not be used; empty if usable
  std::string reason;
  std::vector<ShaftCrackSize> sizes = {};  ///< sizes solved for (FE-8), the given depth last
  fem::SampledFields fields = {};          ///< fields at the given depth, as the options request

  [[nodiscard]] Checks checks() const;
};

/// Results for one kind of load, which determines the units of the numbers.
template <fem::SectionLoad kLoad>
struct LoadOnShaft : ShaftCrackLoad {
  template <class Visitor>
  static void describe(Visitor&& field) {
    constexpr bool kTwisted = kLoad == fem::SectionLoad::torsion;
    constexpr std::string_view kCompliance = kTwisted ? "rad/(N*m)" : "m/N";
    field({"sound_compliance", kCompliance, "compliance without the crack"},
          &ShaftCrackLoad::sound_compliance);
    field({"added_compliance", kCompliance, "compliance added by the crack"},
          &ShaftCrackLoad::added_compliance);
    field(
        {"added_by_difference", kCompliance, "added compliance as the difference of two solutions"},
        &ShaftCrackLoad::added_by_difference);
    field({"energy_release_rate_per_load_squared", kTwisted ? "J/(m^2*N^2*m^2)" : "J/(m^2*N^2)",
           "G under a unit load"},
          [](const LoadOnShaft& load) { return load.tip.energy_release_rate; });
    field({"evidence", "", "internal checks of the solution"}, &ShaftCrackLoad::checks);
    field({"usable", "", "whether the checks agree"}, &ShaftCrackLoad::usable);
    field({"reason", "", "failed check; empty if all agree"}, &ShaftCrackLoad::reason);
  }
};

/// A cracked shaft under torque and axial force.
struct ShaftCrackResult {
  LoadOnShaft<fem::SectionLoad::torsion> torsion;  ///< results per N*m
  /// Results per N.  Under compression K_I is negative, which means a closed crack.
  LoadOnShaft<fem::SectionLoad::tension> tension;

  [[nodiscard]] std::array<const ShaftCrackLoad*, 2> loads() const { return {&torsion, &tension}; }
};

/// If a crack adds more than this share of the sound compliance, the added compliance is found by
/// subtraction [-].  The difference then keeps six digits, while the five depths of the integral
/// miss up to half of a deep crack's compliance.
inline constexpr double kDifferenceShare = 1e-3;

/// Largest deviation of the growth check of a usable result [-].
inline constexpr double kGrowthTolerance = 2e-3;
inline constexpr double kRingTolerance = 5e-3;
inline constexpr double kDisplacementTolerance = 2e-2;
inline constexpr double kResidualTolerance = 1e-6;
inline constexpr double kEnergyTolerance = 1e-6;

/// Solves a cracked shaft seven times for each load: at the given depth, at a neighbouring depth on
/// both sides, at three smaller depths, and without the crack.
/// @throws InputError, SolverError  on the same conditions as fem::solve_section; InputError also
///     without a crack
[[nodiscard]] ShaftCrackResult solve_shaft(const ShaftSection& shaft,
                                           const fem::Elasticity& elasticity,
                                           const fem::SectionOptions& options = {});

}  // namespace strainwave::gear_fem

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/shaft_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using fem::EdgeRole;
using fem::SectionLoad;
using fem::SectionSolution;
using std::numbers::pi;

double wall(const ShaftSection& shaft) { return (shaft.outer_diameter - shaft.inner_diameter) / 2; }

void check(const ShaftSection& shaft) {
  require(shaft.outer_diameter > 0, "outer_diameter", shaft.outer_diameter, "m", "> 0");
  require(shaft.inner_diameter >= 0 && shaft.inner_diameter < shaft.outer_diameter,
          "inner_diameter", shaft.inner_diameter, "m", ">= 0 and < outer_diameter");
  require(shaft.length > 0, "length", shaft.length, "m", "> 0");
  if (shaft.shoulder) {
    const ShaftShoulder& shoulder = *shaft.shoulder;
    require(shoulder.position > 0 && shoulder.position < shaft.length, "shoulder.position",
            shoulder.position, "m", "> 0 and < length");
    require(shoulder.outer_diameter > shaft.outer_diameter, "shoulder.outer_diameter",
            shoulder.outer_diameter, "m", "> outer_diameter");
    const double step = (shoulder.outer_diameter - shaft.outer_diameter) / 2;
    require(shoulder.fillet_radius >= 0 && shoulder.fillet_radius <= step / 2,
            "shoulder.fillet_radius", shoulder.fillet_radius, "m", ">= 0 and <= half the step");
  }
  if (!shaft.crack) return;
  const ShaftCrack& crack = *shaft.crack;
  require(crack.depth > 0 && crack.depth < wall(shaft), "crack.depth", crack.depth, "m",
          "> 0 and less than the wall");
  const bool bored = crack.surface == ShaftCrack::Surface::outer || shaft.inner_diameter > 0;
  if (!bored) throw InputError("crack.surface", "a solid shaft has no inner surface");
  const double end = shaft.shoulder ? shaft.shoulder->position - 2.5 * shaft.shoulder->fillet_radius
                                    : shaft.length;
  require(crack.position > 0 && crack.position < end, "crack.position", crack.position, "m",
          shaft.shoulder ? "> 0, and more than 1.5 fillet radii before the shoulder's fillet"
                         : "> 0 and < length");
}

/// Radius of the crack's front.
double tip_radius(const ShaftSection& shaft) {
  return shaft.crack->surface == ShaftCrack::Surface::outer
             ? shaft.outer_diameter / 2 - shaft.crack->depth
             : shaft.inner_diameter / 2 + shaft.crack->depth;
}

/// Area swept per depth at the tip.
double swept(double tip) { return 2 * pi * tip; }

/// Keeps the worst check values of several solutions.
void keep_worst(ShaftCrackLoad& result, const SectionSolution& solution) {
  const auto worse = [](double& kept, double value) {
    if (!(std::abs(value) <= std::abs(kept))) kept = value;
  };
  worse(result.energy_balance, solution.energy_balance);
  worse(result.equilibrium_residual, solution.equilibrium_residual);
  result.worst_jacobian = std::min(result.worst_jacobian, solution.worst_jacobian);
}

/// The reason why a result must not be used; empty if usable.
std::string fault_of(const ShaftCrackLoad& r) {
  const auto above = [](double value, double most) { return !(std::abs(value) <= most); };
  if (!(r.tip.energy_release_rate > 0)) return "the energy release rate is not positive";
  if (above(r.equilibrium_residual, kResidualTolerance))
    return fmt::format("equilibrium is violated by {:.2g} of the load", r.equilibrium_residual);
  if (above(r.energy_balance, kEnergyTolerance))
    return fmt::format("strain energy and work differ by {:.2g}", r.energy_balance);
  if (above(r.tip.ring_spread, kRingTolerance))
    return fmt::format("the energy release rate differs from ring to ring by {:.2g}",
                       r.tip.ring_spread);
  if (above(r.growth_check, kGrowthTolerance))
    return fmt::format("dC/dA of neighbouring sizes and 2G differ by {:.2g}", r.growth_check);
  if (above(r.tip.displacement_check, kDisplacementTolerance))
    return fmt::format("G of the faces' displacement and G of the domain integral differ by {:.2g}",
                       r.tip.displacement_check);
  return {};
}

ShaftCrackLoad solve_load(const ShaftSection& shaft, SectionLoad load,
                          const fem::Elasticity& elasticity, const fem::SectionOptions& options) {
  ShaftCrackLoad result{.tip = {}, .worst_jacobian = 1.0, .reason = {}};
  fem::SectionOptions without_fields = options;
  without_fields.fields = {};
  const auto solve = [&](const fem::SectionMesh& mesh) {
    SectionSolution solution = fem::solve_section(mesh, load, elasticity, without_fields);
    keep_worst(result, solution);
    return solution;
  };
  const fem::SectionMesh mesh = mesh_shaft(shaft);
  const double tip = tip_radius(shaft);
  const double direction = mesh.crack->direction;
  SectionSolution here = fem::solve_section(mesh, load, elasticity, options);
  keep_worst(result, here);
  result.fields = std::move(here.fields);
  result.tip = *here.tip;
  result.dofs = here.dofs;

  // C(a+d) - C(a-d) against Simpson's rule of 2 G dA/da.  (FE-9)
  const double step = 0.1 * mesh.crack->cell;
  const SectionSolution longer = solve(fem::with_longer_crack(mesh, step));
  const SectionSolution shorter = solve(fem::with_longer_crack(mesh, -step));
  const auto release = [&](const SectionSolution& s, double radius) {
    return 2 * s.tip->energy_release_rate * swept(radius);
  };
  const double by_G = step / 3 *
                      (release(shorter, tip - direction * step) + 4 * release(here, tip) +
                       release(longer, tip + direction * step));
  result.growth_check = (longer.compliance - shorter.compliance) / by_G - 1;

  // The added compliance is the integral of 2 G dA over the depth, by Lobatto's rule with five
  // points (FE-8).  G is zero at depth 0, and the last point is this solution.
  const double depth = shaft.crack->depth;
  const auto at_share = [&](double share) {
    ShaftSection smaller = shaft;
    smaller.crack->depth = share * depth;
    const SectionSolution solution = solve(mesh_shaft(smaller));
    result.sizes.push_back({smaller.crack->depth, *solution.tip});
    return release(solution, tip_radius(smaller));
  };
  const double aside = std::sqrt(3.0 / 7) / 2;
  const double near_nothing = at_share(0.5 - aside);
  const double half = at_share(0.5);
  const double near_all = at_share(0.5 + aside);
  result.added_compliance =
      depth * (release(here, tip) / 20 + 49.0 / 180 * (near_nothing + near_all) + 16.0 / 45 * half);
  result.sizes.push_back({depth, *here.tip});

  ShaftSection sound = shaft;
  sound.crack.reset();
  result.sound_compliance = solve(mesh_shaft(sound)).compliance;
  result.added_by_difference = here.compliance - result.sound_compliance;
  // For a deep crack G rises steeply, which five depths miss; its compliance is large enough for a
  // difference.
  if (result.added_by_difference > kDifferenceShare * result.sound_compliance)
    result.added_compliance = result.added_by_difference;  // (FE-8)
  result.reason = fault_of(result);
  result.usable = result.reason.empty();
  return result;
}

}  // namespace

ShaftSection shaft_section(const OutputShaft& shaft, std::size_t crack) {
  const auto& annular = std::get<AnnularCrack>(shaft.crack.at(crack));
  return {.outer_diameter = shaft.outer_diameter,
          .inner_diameter = shaft.inner_diameter,
          .length = shaft.length,
          .crack = ShaftCrack{.surface = ShaftCrack::Surface::outer,
                              .depth = annular.depth,
                              .position = annular.distance.value_or(shaft.length / 2)}};
}

fem::SectionMesh mesh_shaft(const ShaftSection& shaft) {
  check(shaft);
  const double inner = shaft.inner_diameter / 2;
  const double outer = shaft.outer_diameter / 2;
  const double first_end = shaft.shoulder ? shaft.shoulder->position : shaft.length;
  fem::SectionShape shape{
      .rectangles = {{.r_from = inner, .r_to = outer, .z_from = 0, .z_to = first_end, .part = 0}},
      .fillets = {},
      .sides = {{.at_z = true, .level = 0, .from = inner, .to = outer, .role = EdgeRole::held}},
      .crack = {}};
  double loaded_outer = outer;
  if (shaft.shoulder) {
    loaded_outer = shaft.shoulder->outer_diameter / 2;
    // Use two rectangles, so that a grid line runs along the corner.
    shape.rectangles.push_back({inner, outer, first_end, shaft.length, 1});
    shape.rectangles.push_back({outer, loaded_outer, first_end, shaft.length, 1});
    if (shaft.shoulder->fillet_radius > 0)
      shape.fillets.push_back({.corner = {outer, first_end},
                               .void_r = 1,
                               .void_z = -1,
                               .radius = shaft.shoulder->fillet_radius});
  }
  shape.sides.push_back({.at_z = true,
                         .level = shaft.length,
                         .from = inner,
                         .to = loaded_outer,
                         .role = EdgeRole::loaded});
  if (shaft.crack) {
    const bool from_outside = shaft.crack->surface == ShaftCrack::Surface::outer;
    shape.crack = fem::SectionCrack{.z = shaft.crack->position,
                                    .mouth = from_outside ? outer : inner,
                                    .tip = tip_radius(shaft)};
  }
  return fem::mesh_section(shape, {.coarse_r = outer, .coarse_z = outer, .growth = 1.0});
}

ShaftCrackResult solve_shaft(const ShaftSection& shaft, const fem::Elasticity& elasticity,
                             const fem::SectionOptions& options) {
  if (!shaft.crack) throw InputError("crack", "must be given to be solved");
  return {.torsion = {solve_load(shaft, SectionLoad::torsion, elasticity, options)},
          .tension = {solve_load(shaft, SectionLoad::tension, elasticity, options)}};
}

Checks ShaftCrackLoad::checks() const {
  return {.ring_spread = tip.ring_spread,
          .growth_check = growth_check,
          .displacement_check = tip.displacement_check,
          .energy_balance = energy_balance,
          .equilibrium_residual = equilibrium_residual,
          .worst_jacobian = worst_jacobian,
          .unknowns = dofs};
}

}  // namespace strainwave::gear_fem

// SPDX-License-Identifier: Apache-2.0
#include "bent_shaft.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "strainwave/growth/mixed_mode.hpp"
#include "strainwave/strength/failure_assessment.hpp"

namespace strainwave {
namespace {

/// Reference stress of the net section under all three loads (GR-40) [Pa].
double reference_stress(const OutputShaft& shaft, const DriveCrack& crack, const CrackSize& size,
                        const LoadState& load) {
  const double net = shaft.outer_diameter / 2 - size.size;
  const double bore = shaft.inner_diameter / 2;
  const double modulus = 4.0 / 3 * (std::pow(net, 3) - std::pow(bore, 3));  // plastic
  if (!(modulus > 0)) return std::numeric_limits<double>::infinity();
  const double normal =
      crack.reference_stress(size, load.axial_force, 0.0) + std::abs(load.bending_moment) / modulus;
  return std::hypot(normal, crack.reference_stress(size, 0.0, load.torque));
}

}  // namespace

std::optional<double> bent_reserve(const GearSet& gear, const DriveCrack& crack,
                                   const CrackSize& size, const LoadState& load) {
  const Material& material = material_of(gear, crack.material, "output_shaft.material");
  if (!material.fracture_toughness || !material.yield_strength || !crack.bending)
    return std::nullopt;
  const ElasticConstants steel = elastic_constants(material);
  const CracksAtTorques proportional;
  const CrackFactors factors(crack, proportional, size);
  LoadState pulled = load;
  pulled.bending_moment = std::abs(load.bending_moment);
  double K = 0.0;
  for (std::size_t i = 0; i < factors.points(); ++i) {
    const Modes at = factors.at(i, pulled);
    K = std::max(
        K, equivalent_factor(MixedMode::energy, {.I = at[0], .II = at[1], .III = at[2]}, steel.nu));
  }
  const double K_r = K / *material.fracture_toughness;
  const double L_r =
      reference_stress(*gear.output_shaft, crack, size, load) / *material.yield_strength;
  if (!std::isfinite(L_r)) return 0.0;
  const AssessmentMaterial line{.youngs_modulus = steel.E,
                                .yield_strength = *material.yield_strength,
                                .ultimate_strength = material.ultimate_strength};
  double safe = 0.0;
  double beyond = std::min(L_r > 0 ? collapse_limit(line) / L_r : 1 / K_r,
                           K_r > 0 ? 1 / K_r : collapse_limit(line) / L_r);
  if (!std::isfinite(beyond)) return std::nullopt;  // no load acts
  if (K_r * beyond < assessment_line(L_r * beyond, line)) return beyond;
  constexpr int kSteps = 50;
  for (int i = 0; i < kSteps; ++i) {
    const double middle = (safe + beyond) / 2;
    (K_r * middle < assessment_line(L_r * middle, line) ? safe : beyond) = middle;
  }
  return safe;
}

}  // namespace strainwave

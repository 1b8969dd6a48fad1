// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/roller_bearing.hpp"

#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr double kRollerExponent = 10.0 / 3.0;
constexpr double kMillion = 1e6;

}  // namespace

double output_bearing_load(const OutputBearing& bearing, const OutputBearingLoad& load) {
  require(bearing.pitch_diameter > 0, "output_bearing.pitch_diameter", bearing.pitch_diameter, "m",
          "> 0");
  require(load.radial_force >= 0 && std::isfinite(load.radial_force), "radial_force",
          load.radial_force, "N", ">= 0");
  require(load.bending_moment >= 0 && std::isfinite(load.bending_moment), "bending_moment",
          load.bending_moment, "N*m", ">= 0");
  require(std::isfinite(load.axial_force), "axial_force", load.axial_force, "N", "a finite number");
  const double axial = std::abs(load.axial_force);
  const double radial = load.radial_force + 2 * load.bending_moment / bearing.pitch_diameter;
  const bool mostly_radial = axial <= 1.5 * radial;
  const double X = mostly_radial ? 1.0 : 0.67;
  const double Y = mostly_radial ? 0.45 : 0.67;
  return X * radial + Y * axial;  // (LI-33)
}

OutputBearingLife output_bearing_life(const OutputBearing& bearing,
                                      std::span<const OutputBearingLoad> duty) {
  require(bearing.dynamic_rating > 0, "output_bearing.dynamic_rating", bearing.dynamic_rating, "N",
          "> 0");
  require(bearing.load_factor >= 1, "output_bearing.load_factor", bearing.load_factor, "1", ">= 1");
  double time = 0.0;
  double turns = 0.0;
  double damage = 0.0;
  for (const OutputBearingLoad& load : duty) {
    require(load.speed >= 0 && std::isfinite(load.speed), "speed", load.speed, "1/s", ">= 0");
    require(load.duration > 0 && std::isfinite(load.duration), "duration", load.duration, "s",
            "> 0");
    const double turned = load.speed * load.duration;
    time += load.duration;
    turns += turned;
    damage += std::pow(output_bearing_load(bearing, load), kRollerExponent) * turned;
  }
  if (!(damage > 0)) throw InputError("duty", "does not turn the output bearing under load");
  const double P = std::pow(damage / turns, 1 / kRollerExponent);
  const double life_turns = kMillion * std::pow(bearing.dynamic_rating / (bearing.load_factor * P),
                                                kRollerExponent);  // (LI-33)
  return {.ten_percent = life_turns * time / turns, .load = P};
}

}  // namespace strainwave

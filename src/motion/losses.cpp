// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/losses.hpp"

#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

double bristle_torque(const LuGre& model, double speed) {
  const double ratio = speed / model.stribeck_speed;
  return model.coulomb + (model.breakaway - model.coulomb) * std::exp(-ratio * ratio);  // (MO-10)
}

}  // namespace

double BoucWen::rate(double torque, double twist_rate) const {
  const double share = std::abs(torque) / limit;
  const double power = exponent == 1 ? share : std::pow(share, exponent);
  const double along = std::copysign(1.0, torque) * std::abs(twist_rate);
  return stiffness *
         (twist_rate - power * ((1 - asymmetry) * along + asymmetry * twist_rate));  // (MO-8)
}

BoucWen dahl(double stiffness, double limit) {
  return {.stiffness = stiffness, .limit = limit};  // (MO-9)
}

double dahl_after(const BoucWen& model, double torque, double change) {
  const double end = std::copysign(model.limit, change);
  return end + (torque - end) * std::exp(-model.stiffness * std::abs(change) / model.limit);
  // (MO-9)
}

LuGre::At LuGre::at(double deflection, double speed) const {
  const double g = bristle_torque(*this, speed);
  const double rate = speed - bristle_stiffness * std::abs(speed) * deflection / g;  // (MO-10)
  return {.rate = rate,
          .torque = bristle_stiffness * deflection + bristle_damping * rate + viscous * speed};
}

double LuGre::steady(double speed) const {
  if (speed == 0) return 0.0;
  return std::copysign(bristle_torque(*this, speed), speed) + viscous * speed;  // (MO-10)
}

void require_constants(const BoucWen& model) {
  const auto positive = [](const char* field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  positive("hysteresis.stiffness", model.stiffness, "N*m/rad");
  positive("hysteresis.limit", model.limit, "N*m");
  require(model.exponent >= 1 && std::isfinite(model.exponent), "hysteresis.exponent",
          model.exponent, "1", ">= 1");
  require(model.asymmetry <= 0.5 && std::isfinite(model.asymmetry), "hysteresis.asymmetry",
          model.asymmetry, "1", "at most 1/2, so that each closed path loses energy");
}

void require_constants(const LuGre& model) {
  const auto rule = [](bool ok, const char* field, double value, const char* unit,
                       const char* text) {
    require(ok && std::isfinite(value), field, value, unit, text);
  };
  rule(model.bristle_stiffness > 0, "friction.bristle_stiffness", model.bristle_stiffness,
       "N*m/rad", "> 0");
  rule(model.bristle_damping >= 0, "friction.bristle_damping", model.bristle_damping, "N*m*s/rad",
       ">= 0");
  rule(model.viscous >= 0, "friction.viscous", model.viscous, "N*m*s/rad", ">= 0");
  rule(model.coulomb > 0, "friction.coulomb", model.coulomb, "N*m", "> 0");
  rule(model.breakaway >= model.coulomb, "friction.breakaway", model.breakaway, "N*m",
       "at least friction.coulomb");
  rule(model.stribeck_speed > 0, "friction.stribeck_speed", model.stribeck_speed, "rad/s", "> 0");
}

}  // namespace strainwave

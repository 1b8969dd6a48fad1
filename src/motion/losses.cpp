// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/losses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr double kMostWarming = 200.0;  // [K]

/// Torque of an element after a monotonic change of the twist.
double torque_after(const SlipElement& element, double torque, double change) {
  return std::clamp(torque + element.stiffness * change, -element.limit, element.limit);  // (MO-44)
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

SlipState relaxed(const std::vector<SlipElement>& elements, double twist) {
  return {.twist = twist, .torque = std::vector<double>(elements.size(), 0.0)};
}

SlipState slip_after(const std::vector<SlipElement>& elements, const SlipState& state,
                     double twist) {
  SlipState after{.twist = twist, .torque = state.torque};
  for (std::size_t j = 0; j < elements.size(); ++j)
    after.torque[j] = torque_after(elements[j], state.torque[j], twist - state.twist);
  return after;
}

double slip_torque(const std::vector<SlipElement>& elements, const SlipState& state, double twist) {
  double sum = 0.0;
  for (std::size_t j = 0; j < elements.size(); ++j)
    sum += torque_after(elements[j], state.torque[j], twist - state.twist);
  return sum;  // (MO-44)
}

double slip_energy(const std::vector<SlipElement>& elements, const SlipState& state, double twist) {
  double sum = 0.0;
  for (std::size_t j = 0; j < elements.size(); ++j) {
    const double torque = torque_after(elements[j], state.torque[j], twist - state.twist);
    sum += torque * torque / (2 * elements[j].stiffness);  // (MO-45)
  }
  return sum;
}

double slip_loss(const std::vector<SlipElement>& elements, const SlipState& state, double twist,
                 double twist_rate) {
  double sum = 0.0;
  for (std::size_t j = 0; j < elements.size(); ++j) {
    const double torque = torque_after(elements[j], state.torque[j], twist - state.twist);
    const bool slips = std::abs(state.torque[j]) >= elements[j].limit;
    if (slips && torque * twist_rate > 0 && std::abs(torque) >= elements[j].limit)
      sum += torque * twist_rate;  // (MO-45)
  }
  return sum;
}

double LuGre::largest_passive_damping() const {
  const double more = load_breakaway.value_or(load_coulomb) - load_coulomb;
  if (more > 0 && load_coulomb == 0) return 0.0;
  double drop = breakaway / coulomb - 1;
  if (more > 0) drop = std::max(drop, more / load_coulomb);
  if (drop == 0) return std::numeric_limits<double>::infinity();
  return viscous_when_warm() / drop;  // (MO-10)
}

double LuGre::sliding(double speed, double load) const {
  const double ratio = speed / stribeck_speed;
  const double turning = coulomb + load_coulomb * load;                              // (MO-40)
  const double standing = breakaway + load_breakaway.value_or(load_coulomb) * load;  // (MO-40)
  return turning + (standing - turning) * std::exp(-ratio * ratio);                  // (MO-10)
}

LuGre::At LuGre::at(double deflection, double speed, double load) const {
  const double g = sliding(speed, load);
  const double rate = speed - bristle_stiffness * std::abs(speed) * deflection / g;  // (MO-10)
  return {.rate = rate,
          .torque = bristle_stiffness * deflection + bristle_damping * rate +
                    viscous_when_warm() * speed};
}

double LuGre::steady(double speed, double load) const {
  if (speed == 0) return 0.0;
  return std::copysign(sliding(speed, load), speed) + viscous_when_warm() * speed;  // (MO-10)
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

void require_constants(const std::vector<SlipElement>& elements) {
  const FieldPath at("slip_element");
  for (std::size_t j = 0; j < elements.size(); ++j) {
    const auto positive = [&](const char* field, double value, const char* unit) {
      require(value > 0 && std::isfinite(value), (at[j] / field).text(), value, unit, "> 0");
    };
    positive("stiffness", elements[j].stiffness, "N*m/rad");
    positive("limit", elements[j].limit, "N*m");
  }
}

void require_constants(const LuGre& model, const FieldPath& at) {
  const auto rule = [&](bool ok, const char* field, double value, const char* unit,
                        std::string_view text) {
    require(ok && std::isfinite(value), (at / field).text(), value, unit, text);
  };
  rule(model.bristle_stiffness > 0, "bristle_stiffness", model.bristle_stiffness, "N*m/rad", "> 0");
  rule(model.bristle_damping >= 0, "bristle_damping", model.bristle_damping, "N*m*s/rad", ">= 0");
  rule(model.viscous >= 0, "viscous", model.viscous, "N*m*s/rad", ">= 0");
  rule(model.coulomb > 0, "coulomb", model.coulomb, "N*m", "> 0");
  rule(model.breakaway >= model.coulomb, "breakaway", model.breakaway, "N*m",
       "at least " + (at / "coulomb").text());
  rule(model.stribeck_speed > 0, "stribeck_speed", model.stribeck_speed, "rad/s", "> 0");
  rule(model.thinning >= 0, "thinning", model.thinning, "1/K", ">= 0");
  rule(std::abs(model.warming) <= kMostWarming, "warming", model.warming, "K",
       "at most 200 K, up or down");
  rule(model.load_coulomb >= 0, "load_coulomb", model.load_coulomb, "1", ">= 0");
  rule(model.load_breakaway.value_or(0) >= 0, "load_breakaway", model.load_breakaway.value_or(0),
       "1", ">= 0");
}

}  // namespace strainwave

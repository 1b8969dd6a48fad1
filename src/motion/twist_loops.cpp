// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/twist_loops.hpp"

// pchip.hpp of Boost 1.74 calls ::isnan, which <cmath> does not have to declare.
#include <math.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kLeastTorques = 4;  // of the interpolation

/// Threshold over half of the width, of the element k from 0 on.  The element with threshold 0
/// always follows the spring, and bears no twist of its own.
double threshold(std::size_t k) {
  return 2.0 * static_cast<double>(k + 1) / LoopMemory::kElements;  // (MO-52)
}
/// Weights of the trapezoidal rule over the thresholds from 0 to 2.
double weight(std::size_t k) {
  return (k + 1 == LoopMemory::kElements ? 0.5 : 1.0) / LoopMemory::kElements;  // (MO-52)
}

}  // namespace

TwistLoops::TwistLoops(const std::vector<double>& torques, const std::vector<double>& widths,
                       double fading)
    : fading_(fading) {
  require(fading >= 0 && std::isfinite(fading), "loops.fading", fading, "1/rad", ">= 0");
  if (torques.size() < kLeastTorques || torques.size() != widths.size())
    throw InputError("loops", "must have at least 4 torques, and as many widths");
  const FieldPath at("loops");
  for (std::size_t n = 0; n < torques.size(); ++n) {
    require(std::isfinite(torques[n]) && (n == 0 || torques[n] > torques[n - 1]),
            (at / "torque")[n].text(), torques[n], "N*m", "larger than the torque before");
    require(widths[n] >= 0 && std::isfinite(widths[n]), (at / "width")[n].text(), widths[n], "rad",
            ">= 0");
  }
  require(torques.front() < 0, "loops.torque", torques.front(), "N*m", "< 0 at the first point");
  require(torques.back() > 0, "loops.torque", torques.back(), "N*m", "> 0 at the last point");
  torques_ = torques;
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  std::vector<double> nodes = torques;
  std::vector<double> values = widths;
  const boost::math::interpolators::pchip curve(std::move(nodes), std::move(values));
  pieces_.push_back(
      {.least = -kEndless, .most = torques.front(), .from = 0.0, .a = {widths.front()}});
  for (std::size_t n = 0; n + 1 < torques.size(); ++n) {
    const double h = torques[n + 1] - torques[n];
    const double chord = (widths[n + 1] - widths[n]) / h;
    const double first = curve.prime(torques[n]);
    const double last = curve.prime(torques[n + 1]);
    pieces_.push_back({.least = torques[n],
                       .most = torques[n + 1],
                       .from = torques[n],
                       .a = {widths[n], first, (3 * chord - 2 * first - last) / h,
                             (first + last - 2 * chord) / (h * h)}});
  }
  pieces_.push_back({.least = torques.back(), .most = kEndless, .from = 0.0, .a = {widths.back()}});
}

const TwistLoops::WidthPiece& TwistLoops::width_near(double torque) const {
  const auto next = std::ranges::upper_bound(torques_, torque);
  return pieces_[static_cast<std::size_t>(next - torques_.begin())];
}

double TwistLoops::bound(std::size_t element, double torque) const {
  return threshold(element) / 2 * width(torque).value;
}

double TwistLoops::left_of(const Path& path) const {
  return fading_ > 0 ? std::exp(-fading_ * path.turn) : 1.0;
}

TwistLoops::At TwistLoops::at(const LoopMemory& memory, const Path& path) const {
  At sum;
  double play = 0.0;
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    const double between = weight(k) * (1 - std::abs(memory.side[k]));
    sum.free_weight += between;
    play += between * memory.play[k];
    sum.held += weight(k) * memory.side[k] * threshold(k) / 2;
  }
  sum.free_twist = left_of(path) * play - sum.free_weight * path.slide;  // (MO-52, MO-53)
  return sum;
}

double TwistLoops::margin(const LoopMemory& memory, const Path& path, double torque) const {
  const double left = left_of(path);
  const double w = width(torque).value;
  double largest = -w;
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    const double place = left * memory.play[k] - path.slide;  // (MO-53)
    if (memory.side[k] == 0) largest = std::max(largest, std::abs(place) - threshold(k) / 2 * w);
  }
  return largest;
}

LoopMemory TwistLoops::after(const LoopMemory& memory, const Path& path, double torque,
                             double input_angle) const {
  const double left = left_of(path);
  const double w = width(torque).value;
  LoopMemory made{.torque = torque, .input_angle = input_angle, .play = {}, .side = memory.side};
  for (std::size_t k = 0; k < made.play.size(); ++k) {
    const double bound = threshold(k) / 2 * w;
    made.play[k] = made.side[k] != 0
                       ? made.side[k] * bound
                       : std::clamp(left * memory.play[k] - path.slide, -bound, bound);  // (MO-53)
  }
  return made;
}

double TwistLoops::outward(std::size_t element, double side, const Rates& rates,
                           const Width& w) const {
  return -side * rates.slide -
         threshold(element) / 2 * (fading_ * rates.turn * w.value + w.slope * rates.torque);
}

double TwistLoops::hold_margin(const LoopMemory& memory, const Rates& rates, double torque) const {
  const Width w = width(torque);
  double least = 1.0;
  for (std::size_t k = 0; k < memory.play.size(); ++k)
    if (memory.side[k] != 0) least = std::min(least, outward(k, memory.side[k], rates, w));
  return least;
}

bool TwistLoops::hold(LoopMemory& memory, const Rates& rates, double within,
                      const std::optional<Step>& step) const {
  const Width w = width(memory.torque);
  const Width w_before = step ? width(step->torque) : Width{};
  bool changed = false;
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    const double bound = threshold(k) / 2 * w.value;
    double& play = memory.play[k];
    double& side = memory.side[k];
    if (side == 0 && std::abs(play) < bound - within) continue;
    const double at = bound > 0 ? std::copysign(1.0, play) : -std::copysign(1.0, rates.torque);
    const double outward_now = outward(k, at, rates, w);
    const bool stays = outward_now >= 0;  // (MO-53)
    double inward = 2 * within;
    if (step && side != 0 && !stays) {
      // It left the bound where the straight line between the rates passes zero.
      const double before = outward(k, at, step->rates, w_before);
      if (before > 0)
        inward = std::max(inward,
                          outward_now * outward_now * step->length / (2 * (before - outward_now)));
    }
    const double there = at * (stays ? bound : std::max(0.0, bound - inward));
    changed = changed || stays != (side != 0) || there != play;
    side = stays ? at : 0.0;
    play = there;
  }
  return changed;
}

LoopMemory TwistLoops::relaxed(double torque, double input_angle) const {
  return {.torque = torque, .input_angle = input_angle};
}

}  // namespace strainwave

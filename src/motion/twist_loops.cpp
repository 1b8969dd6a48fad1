// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/twist_loops.hpp"

// pchip.hpp of Boost 1.74 calls ::isnan, which <cmath> does not have to declare.
#include <math.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kLeastTorques = 4;  // of the interpolation
constexpr double kEdge = 1e-9;            // of the bound [-]
constexpr double kShortTurn = 1e-4;       // share of Theta below which series replace differences

/// Threshold over half of the width, of the element k from 0 on.  The element with threshold 0
/// always follows the spring, and bears no twist of its own.
double threshold(std::size_t k) {
  return 2.0 * static_cast<double>(k + 1) / LoopMemory::kElements;  // (MO-52)
}
/// Weights of the trapezoidal rule over the thresholds from 0 to 2.
double weight(std::size_t k) {
  return (k + 1 == LoopMemory::kElements ? 0.5 : 1.0) / LoopMemory::kElements;  // (MO-52)
}

/// What is left of the memory, and of a slide that went on evenly over the turn (MO-53).
struct Fading {
  double memory = 1.0;
  double slide = 1.0;
  double memory_rate = 0.0;  ///< per angle of the input [1/rad]
  double slide_rate = 0.0;   ///< likewise
};

Fading fading_over(double turn, double rate) {
  const double x = turn * rate;
  Fading f;
  f.memory = std::exp(-x);
  f.memory_rate = -rate * f.memory;
  if (x < kShortTurn) {
    f.slide = 1 - x / 2 + x * x / 6;
    f.slide_rate = -rate * (0.5 - x / 3 + x * x / 8);
  } else {
    f.slide = -std::expm1(-x) / x;
    f.slide_rate = rate * (f.memory - f.slide) / x;
  }
  return f;
}

}  // namespace

struct TwistLoops::Width {
  using Pchip = boost::math::interpolators::pchip<std::vector<double>>;

  double least = 0.0;  ///< torque [N*m]
  double most = 0.0;   ///< torque [N*m]
  Pchip over_torque;

  struct Value {
    double value = 0.0;
    double slope = 0.0;
  };
  [[nodiscard]] Value at(double torque) const {
    const double inside = std::clamp(torque, least, most);
    return {over_torque(inside), inside == torque ? over_torque.prime(inside) : 0.0};
  }
};

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
  width_ = std::make_unique<const Width>(
      Width{.least = torques.front(),
            .most = torques.back(),
            .over_torque = Width::Pchip(std::vector(torques), std::vector(widths))});
}

TwistLoops::~TwistLoops() = default;
TwistLoops::TwistLoops(TwistLoops&&) noexcept = default;
TwistLoops& TwistLoops::operator=(TwistLoops&&) noexcept = default;

double TwistLoops::width(double torque) const { return width_->at(torque).value; }

double TwistLoops::bound(std::size_t element, double torque) const {
  return threshold(element) / 2 * width(torque);
}

TwistLoops::At TwistLoops::at(const LoopMemory& memory, const Change& change) const {
  const Fading left = fading_over(change.turn, fading_);
  const Width::Value width = width_->at(change.torque);
  const double slid = left.slide * change.slide;
  At sum;
  double free = 0.0;         // weight of the elements that keep their place
  double free_memory = 0.0;  // their weighted memory
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    const double half = threshold(k) / 2;
    const double bound = half * width.value;
    const double kept = left.memory * memory.play[k] - slid;  // (MO-52, MO-53)
    const bool between = std::abs(memory.play[k]) < half * memory.width * (1 - kEdge);
    if (between) sum.margin = std::max(sum.margin, std::abs(kept) - bound);
    double side = kept < 0 ? -1.0 : 1.0;
    bool bounded = kept < -bound || kept > bound;
    if (between && change.before_slip) {
      bounded = false;
    } else if (std::abs(std::abs(kept) - bound) <= kEdge * bound) {
      sum.on_edge = true;
      if (bound == 0) side = change.slide_rate > 0 ? -1.0 : 1.0;
      // Outward faster than the bound itself.
      const double outward =
          -side * change.slide_rate - fading_ * change.turn_rate * std::abs(kept);
      const double of_bound =
          change.compliance > 0 ? half * width.slope * change.slide_rate / change.compliance : 0.0;
      bounded = outward >= of_bound;
    }
    if (bounded) {
      sum.twist += weight(k) * side * bound;
      sum.compliance += weight(k) * side * half * width.slope;
    } else {
      sum.twist += weight(k) * kept;
      free += weight(k);
      free_memory += weight(k) * memory.play[k];
    }
  }
  sum.by_slide = -left.slide * free;
  sum.compliance += sum.by_slide * change.compliance;
  sum.by_turn = left.memory_rate * free_memory - left.slide_rate * change.slide * free;
  return sum;
}

LoopMemory TwistLoops::after(const LoopMemory& memory, const Change& change,
                             double input_angle) const {
  const Fading left = fading_over(change.turn, fading_);
  LoopMemory made = relaxed(change.torque, input_angle);
  for (std::size_t k = 0; k < made.play.size(); ++k) {
    const double bound = threshold(k) / 2 * made.width;
    made.play[k] = std::clamp(left.memory * memory.play[k] - left.slide * change.slide, -bound,
                              bound);  // (MO-52, MO-53)
  }
  return made;
}

LoopMemory TwistLoops::relaxed(double torque, double input_angle) const {
  return {.torque = torque, .width = width(torque), .input_angle = input_angle};
}

}  // namespace strainwave

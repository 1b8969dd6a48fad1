// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/survival.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

constexpr double kMakersSpeed = 2000 * 2 * std::numbers::pi / 60;  // [rad/s]

void require_share(double share) {
  require(share > 0 && share < 1, "share", share, "1", "between 0 and 1");
}

/// -ln of the survival.
double hazard(const WeibullLife& part, double time) {
  require(part.ten_percent > 0 && std::isfinite(part.ten_percent), "L10", part.ten_percent, "s",
          "> 0");
  require(part.slope > 0 && std::isfinite(part.slope), "slope", part.slope, "1", "> 0");
  require(time >= 0 && std::isfinite(time), "time", time, "s", ">= 0");
  return -std::log(0.9) * std::pow(time / part.ten_percent, part.slope);  // (LI-4)
}

}  // namespace

double makers_weibull_slope() {
  static const double slope = std::log(std::log(2.0) / -std::log(0.9)) / std::log(5.0);  // (LI-4)
  return slope;
}

double WeibullLife::survival(double time) const { return std::exp(-hazard(*this, time)); }

double WeibullLife::time_of(double share) const {
  require_share(share);
  return ten_percent * std::pow(std::log(share) / std::log(0.9), 1 / slope);  // (LI-4)
}

double bearing_life(double rated_life, double rated_torque, const DutyAverage& duty) {
  require(rated_life > 0 && std::isfinite(rated_life), "rated_life", rated_life, "s", "> 0");
  require(rated_torque > 0 && std::isfinite(rated_torque), "rated_torque", rated_torque, "N*m",
          "> 0");
  require(duty.torque > 0, "T_av", duty.torque, "N*m", "> 0, because the rule has no other load");
  require(duty.input_speed > 0, "n_in,av", duty.input_speed, "rad/s", "> 0");
  const double load = rated_torque / duty.torque;
  return rated_life * load * load * load * (kMakersSpeed / duty.input_speed);  // (LI-3)
}

double survival_of_all(std::span<const WeibullLife> parts, double time) {
  double sum = 0.0;
  for (const WeibullLife& part : parts) sum += hazard(part, time);
  return std::exp(-sum);  // (LI-5)
}

double time_of_all(std::span<const WeibullLife> parts, double share) {
  require_share(share);
  require(!parts.empty(), "parts", 0, "1", "at least one part");
  // The weakest part alone is an upper bound, and all parts as weak as the weakest a lower bound.
  double most = parts.front().time_of(share);
  double least = most;
  const double each = std::pow(share, 1.0 / static_cast<double>(parts.size()));
  for (const WeibullLife& part : parts) {
    most = std::min(most, part.time_of(share));
    least = std::min(least, part.time_of(each));
  }
  if (!(least < most)) return most;
  return bracketed_root(
      [&](double time) { return std::log(survival_of_all(parts, time) / share); },  // (LI-5)
      least * (1 - 1e-12), most * (1 + 1e-12));
}

}  // namespace strainwave

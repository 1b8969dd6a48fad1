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

void require_part(const WeibullLife& part) {
  require(part.ten_percent > 0 && std::isfinite(part.ten_percent), "L10", part.ten_percent, "s",
          "> 0");
  require(part.slope > 0 && std::isfinite(part.slope), "slope", part.slope, "1", "> 0");
}

/// -ln of the survival.
double hazard(const WeibullLife& part, double time) {
  require_part(part);
  require(time >= 0 && std::isfinite(time), "time", time, "s", ">= 0");
  return -std::log(0.9) * std::pow(time / part.ten_percent, part.slope);  // (LI-4)
}

/// Time at which the hazard of a part reaches a value.
double time_of_hazard(const WeibullLife& part, double wanted) {
  require_part(part);
  return part.ten_percent * std::pow(wanted / -std::log(0.9), 1 / part.slope);  // (LI-4)
}

double hazard_of_all(std::span<const WeibullLife> parts, double time) {
  double sum = 0.0;
  for (const WeibullLife& part : parts) sum += hazard(part, time);
  return sum;
}

}  // namespace

double makers_weibull_slope() {
  static const double slope = std::log(std::log(2.0) / -std::log(0.9)) / std::log(5.0);  // (LI-4)
  return slope;
}

double WeibullLife::survival(double time) const { return std::exp(-hazard(*this, time)); }

double WeibullLife::time_of(double share) const {
  require_share(share);
  return time_of_hazard(*this, -std::log(share));
}

double bearing_life(double rated_life, double rated_torque, const DutyAverage& duty) {
  require(rated_life > 0 && std::isfinite(rated_life), "rated_life", rated_life, "s", "> 0");
  require(rated_torque > 0 && std::isfinite(rated_torque), "rated_torque", rated_torque, "N*m",
          "> 0");
  require(duty.torque > 0 && std::isfinite(duty.torque), "T_av", duty.torque, "N*m",
          "> 0, because the rule has no other load");
  require(duty.input_speed > 0 && std::isfinite(duty.input_speed), "n_in,av", duty.input_speed,
          "rad/s", "> 0");
  const double load = rated_torque / duty.torque;
  return rated_life * load * load * load * (kMakersSpeed / duty.input_speed);  // (LI-3)
}

double survival_of_all(std::span<const WeibullLife> parts, double time) {
  return std::exp(-hazard_of_all(parts, time));  // (LI-5)
}

double time_of_all(std::span<const WeibullLife> parts, double share) {
  require_share(share);
  require(!parts.empty(), "parts", 0, "1", "at least one part");
  // The weakest part alone reaches the longest time.  The hazards add up, so the time is at least
  // that of parts of which each has an equal share of the hazard.
  const double wanted = -std::log(share);
  double most = time_of_hazard(parts.front(), wanted);
  double least = most;
  for (const WeibullLife& part : parts) {
    most = std::min(most, time_of_hazard(part, wanted));
    least = std::min(least, time_of_hazard(part, wanted / static_cast<double>(parts.size())));
  }
  return bracketed_root(
      [&](double time) { return std::log(hazard_of_all(parts, time) / wanted); },  // (LI-5)
      least * (1 - 1e-9), most * (1 + 1e-9));
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/ball_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

constexpr double kWeibullSlope = 10.0 / 9.0;  // of ISO 281 for point contact
constexpr double kLoadExponent = 3.0;
constexpr double kRatedTurns = 1e6;

/// Q_c of a ring.  @param side  +1 the inner ring, -1 the outer ring
double ring_rating(double conformity, double gamma, double ball, double balls, double side) {
  require(conformity > 0.5, "conformity", conformity, "1", "> 0.5");
  return 98.1 * std::pow(2 * conformity / (2 * conformity - 1), 0.41) *
         std::pow(1 - side * gamma, 1.39) / std::cbrt(1 + side * gamma) * std::pow(gamma, 0.3) *
         std::pow(ball / units::mm, 1.8) / std::cbrt(balls);  // (LI-31)
}

}  // namespace

RingRatings ring_ratings(const Bearing& bearing) {
  if (!bearing.ball_count)
    throw InputError("wave_generator.bearing.ball_count", "must be given for the bearing's life");
  const double pitch = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  const double gamma = bearing.ball_diameter / pitch;
  require(gamma > 0 && gamma < 1, "ball_diameter", bearing.ball_diameter, "m",
          "> 0 and below the pitch diameter");
  const auto rating = [&](double conformity, double side) {
    return ring_rating(conformity, gamma, bearing.ball_diameter, *bearing.ball_count, side);
  };
  return {.inner = rating(bearing.inner_conformity, +1),
          .outer = rating(bearing.outer_conformity, -1)};
}

BallBearingLife ball_bearing_life(const RingRatings& ratings, std::span<const BallLoads> duty) {
  require(ratings.inner > 0 && ratings.outer > 0, "Q_c", std::min(ratings.inner, ratings.outer),
          "N", "> 0");
  require(!duty.empty(), "duty", 0, "1", "at least one load");
  const std::size_t places = duty.front().forces.size();
  require(places > 0, "forces", 0, "1", "at least one place");
  std::vector<double> damage(places, 0.0);  // sum of Q^3 times turns, per place
  double time = 0.0;
  double turns = 0.0;
  BallBearingLife life{.ratings = ratings};
  for (const BallLoads& load : duty) {
    require(load.forces.size() == places, "forces", static_cast<double>(load.forces.size()), "1",
            "as many places under each load");
    require(load.speed >= 0 && std::isfinite(load.speed), "speed", load.speed, "1/s", ">= 0");
    require(load.duration > 0 && std::isfinite(load.duration), "duration", load.duration, "s",
            "> 0");
    time += load.duration;
    turns += load.speed * load.duration;
    for (std::size_t i = 0; i < places; ++i) {
      const double force = load.forces[i];
      require(force >= 0 && std::isfinite(force), "force", force, "N", ">= 0");
      damage[i] += std::pow(force, kLoadExponent) * load.speed * load.duration;
      if (load.speed > 0) life.largest_force = std::max(life.largest_force, force);
    }
  }
  const auto count = static_cast<double>(places);
  double all = 0.0;    // of the turning ring
  double chain = 0.0;  // of the standing ring, whose places fail independently
  for (const double one : damage) {
    all += one / count;
    chain += std::pow(one, kWeibullSlope) / count;
  }
  if (!(all > 0)) throw InputError("duty", "does not turn the bearing under load");
  const double standing = std::pow(chain, 1 / kWeibullSlope);
  life.inner = kRatedTurns * std::pow(ratings.inner, kLoadExponent) * time / standing;  // (LI-32)
  life.outer = kRatedTurns * std::pow(ratings.outer, kLoadExponent) * time / all;       // (LI-32)
  life.equivalent_inner = std::cbrt(standing / turns);
  life.equivalent_outer = std::cbrt(all / turns);
  life.ten_percent =
      std::pow(std::pow(life.inner, -kWeibullSlope) + std::pow(life.outer, -kWeibullSlope),
               -1 / kWeibullSlope);  // (LI-32)
  return life;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/drive_orders.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "strainwave/dynamics/kinematics.hpp"

namespace strainwave {
namespace {

/// How often something happens, in words.
std::string times_words(int times) {
  constexpr std::array kWords = {"once", "twice", "three times", "four times"};
  const auto at = static_cast<std::size_t>(times) - 1;
  return at < kWords.size() ? kWords[at] : fmt::format("{} times", times);
}

}  // namespace

std::vector<DriveOrder> drive_orders(const GearSet& gear) {
  const Arrangement arrangement = arrangement_of(gear.drivetrain->fixed);
  const double ratio = gear.drive.ratio;
  const WaveOrders waves = wave_orders(arrangement, ratio, gear.drive.wave_number);
  const double output = 1 / std::abs(signed_ratio(arrangement, ratio));
  std::vector<DriveOrder> all;
  // (DY-2): once by an eccentric cam, and with the waves and twice as often by the lobes.
  const int lobes = gear.drive.wave_number;
  for (const int times : std::set{1, lobes, 2 * lobes})
    all.push_back({fmt::format("kinematic error, {} in a turn of the input", times_words(times)),
                   static_cast<double>(times)});
  all.insert(all.end(), {{"crack of flexspline, tooth or outer ring", waves.flexspline},
                         {"crack of the circular spline", waves.circular_spline},
                         {"once in a turn of the output", output},
                         {"twice in a turn of the output", 2 * output}});
  if (!gear.wave_generator || !gear.wave_generator->bearing) return all;
  const Bearing& bearing = *gear.wave_generator->bearing;
  if (!bearing.ball_count) return all;
  const double pitch = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  const BallOrders balls =
      ball_orders(arrangement, ratio,
                  {.balls = *bearing.ball_count, .diameter_ratio = bearing.ball_diameter / pitch},
                  gear.drive.wave_number);
  all.push_back({"balls pass a point of the inner ring", balls.inner_ring});
  all.push_back({"balls pass a point of the outer ring", balls.outer_ring});
  all.push_back({"a ball comes to a lobe of the wave", balls.lobe});
  all.push_back({"a ball comes to a lobe of the wave, second harmonic", 2 * balls.lobe});
  return all;
}

}  // namespace strainwave

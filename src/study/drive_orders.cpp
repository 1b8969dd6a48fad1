// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/drive_orders.hpp"

#include <cmath>

#include "strainwave/dynamics/kinematics.hpp"

namespace strainwave {

std::vector<DriveOrder> drive_orders(const GearSet& gear) {
  const Arrangement arrangement = arrangement_of(gear.drivetrain->fixed);
  const double ratio = gear.drive.ratio;
  const WaveOrders waves = wave_orders(arrangement, ratio, gear.drive.wave_number);
  const double output = 1 / std::abs(signed_ratio(arrangement, ratio));
  std::vector<DriveOrder> all = {{"kinematic error, once in a turn of the input", 1.0},
                                 {"kinematic error, twice in a turn of the input", 2.0},
                                 {"kinematic error, four times in a turn of the input", 4.0},
                                 {"crack of flexspline, tooth or outer ring", waves.flexspline},
                                 {"crack of the circular spline", waves.circular_spline},
                                 {"once in a turn of the output", output},
                                 {"twice in a turn of the output", 2 * output}};
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

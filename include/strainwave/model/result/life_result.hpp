// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/core/quantity.hpp"

/// @file
/// The numbers of the life of a drive that sweep, solve and require can name.

namespace strainwave {

/// Life of the drive over its duty.  A number that the file does not decide is absent.
struct LifeResult {
  /// life that 90 % of the drives reach with all parts whose life is known, and not longer than
  /// that of the cracks [s]; absent if no part ends, and if a crack that cannot be told may end the
  /// drive before
  std::optional<Quantity> hours;
  /// until the first crack that can be computed ends the life [s]; absent without cracks, without
  /// their laws, and if they stand still
  std::optional<Quantity> cracks;
  std::optional<Quantity> bearing_L10;  ///< by the maker's rule [s]
  std::optional<Quantity> bearing_L50;  ///< by the maker's rule [s]
  /// L10 by the ball forces over that at rated torque and 2000 rpm [-]
  std::optional<Quantity> bearing_ratio;
  std::optional<Quantity> output_bearing_L10;   ///< [s]
  std::optional<Quantity> average_torque;       ///< T_av [N*m]
  std::optional<Quantity> average_input_speed;  ///< [rad/s]
  /// Reserves against endurance, 1 at the limit [-]
  std::optional<Quantity> wall_reserve;
  std::optional<Quantity> rim_reserve;
  std::optional<Quantity> tooth_root_reserve;
  /// Least allowed over present of the maker's rules that can be told [-]
  std::optional<Quantity> makers_reserve;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"hours", "s",
           "life that 90 % of the drives reach; absent if a crack that cannot be told may end the "
           "drive before"},
          &LifeResult::hours);
    field({"cracks", "s", "time of duty until a crack that can be computed ends the life"},
          &LifeResult::cracks);
    field({"bearing_L10", "s", "L10 of the wave generator's bearing by the maker's rule"},
          &LifeResult::bearing_L10);
    field({"bearing_L50", "s", "L50 of the wave generator's bearing by the maker's rule"},
          &LifeResult::bearing_L50);
    field({"bearing_ratio", "1",
           "L10 of the wave generator's bearing by its ball forces over that at rated torque and "
           "2000 rpm"},
          &LifeResult::bearing_ratio);
    field({"output_bearing_L10", "s", "L10 of the output bearing"},
          &LifeResult::output_bearing_L10);
    field({"average_torque", "N*m", "average torque of the duty"}, &LifeResult::average_torque);
    field({"average_input_speed", "rad/s", "average speed of the input over the duty"},
          &LifeResult::average_input_speed);
    field({"wall_reserve", "1", "reserve of the wall against endurance"},
          &LifeResult::wall_reserve);
    field({"rim_reserve", "1", "reserve of the rim's bore against endurance"},
          &LifeResult::rim_reserve);
    field({"tooth_root_reserve", "1", "reserve of the tooth root against endurance"},
          &LifeResult::tooth_root_reserve);
    field({"makers_reserve", "1", "least allowed over present of the maker's rules"},
          &LifeResult::makers_reserve);
  }
};

}  // namespace strainwave

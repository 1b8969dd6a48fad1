// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/model/input/wave_generator.hpp"

/// @file
/// Life of the wave generator's bearing from the forces of its balls.

namespace strainwave {

/// Forces that let 90 % of the rings live for a million turns, Q_c [N].
struct RingRatings {
  double inner = 0.0;
  double outer = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"inner", "N", "ball force of the inner ring for a million turns"}, &RingRatings::inner);
    field({"outer", "N", "ball force of the outer ring for a million turns"}, &RingRatings::outer);
  }
};

/// Implements theory manual eq. (LI-31), Lundberg and Palmgren's rating of a contact as ISO 281
/// uses it, for bearings of one row and steel of its time.
/// @throws InputError  if the bearing has no ball_count, or a conformity of 0.5 or less
[[nodiscard]] RingRatings ring_ratings(const Bearing& bearing);

/// The balls of a bearing under one load, at evenly spaced places over the turn.
struct BallLoads {
  /// Forces [N]; >= 0.  The place of a force is its index, the same for all loads of a duty.
  std::vector<double> forces;
  double speed = 0.0;     ///< turns of the rings against each other per time [1/s]; >= 0
  double duration = 0.0;  ///< how long the load acts [s]; > 0
};

/// Life that 90 % of the bearings reach, and its parts.
struct BallBearingLife {
  double ten_percent = 0.0;       ///< L10 of the bearing [s]
  double inner = 0.0;             ///< L10 of the inner ring, which stands against the load [s]
  double outer = 0.0;             ///< L10 of the outer ring, which turns against the load [s]
  double equivalent_inner = 0.0;  ///< constant force at all places with the same life [N]
  double equivalent_outer = 0.0;  ///< as equivalent_inner [N]
  double largest_force = 0.0;     ///< [N]
  RingRatings ratings;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"L10", "s", "life that 90 % of the bearings reach, from the ball forces"},
          &BallBearingLife::ten_percent);
    field({"inner_ring", "s", "L10 of the inner ring, which stands against the load"},
          &BallBearingLife::inner);
    field({"outer_ring", "s", "L10 of the outer ring, which turns against the load"},
          &BallBearingLife::outer);
    field({"equivalent_inner", "N", "constant force of all balls with the inner ring's life"},
          &BallBearingLife::equivalent_inner);
    field({"equivalent_outer", "N", "constant force of all balls with the outer ring's life"},
          &BallBearingLife::equivalent_outer);
    field({"largest_force", "N", "largest force of a ball"}, &BallBearingLife::largest_force);
    field({"ratings", "", "forces for a life of a million turns"}, &BallBearingLife::ratings);
  }
};

/// Life of a bearing over a duty that is repeated for ever.
///
/// Implements theory manual eq. (LI-32).  Each place of the standing ring adds up the damage of its
/// own forces; the turning ring takes all places in turn.  The order of the loads does not matter.
/// @throws InputError  if the loads have different numbers of places, a number is out of range, or
///                     nothing moves under load
[[nodiscard]] BallBearingLife ball_bearing_life(const RingRatings& ratings,
                                                std::span<const BallLoads> duty);

}  // namespace strainwave

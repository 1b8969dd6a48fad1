// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/duty.hpp"

/// @file
/// Angles of the three parts of a strain wave gear, with sign.

namespace strainwave {

/// A part of a strain wave gear that turns or stands.
enum class DrivePart { wave_generator, flexspline, circular_spline };
template <>
struct EnumNames<DrivePart> {
  static constexpr std::array<std::string_view, 3> names = {"wave_generator", "flexspline",
                                                            "circular_spline"};
};

/// The part that stands and the part that is driven; the third part is the output.
struct Arrangement {
  DrivePart fixed = DrivePart::circular_spline;  ///< the part that stands
  DrivePart input = DrivePart::wave_generator;   ///< the part that is driven

  /// @throws InputError  if one part is both fixed and the input
  [[nodiscard]] DrivePart output() const;
};

/// The arrangement of a duty, whose input is the wave generator.
[[nodiscard]] Arrangement arrangement_of(FixedMember fixed);

/// Turns of the three parts, each with its sign [-].
struct PartTurns {
  double wave_generator = 0.0;   ///< turns of the wave generator [-]
  double flexspline = 0.0;       ///< turns of the flexspline [-]
  double circular_spline = 0.0;  ///< turns of the circular spline [-]

  /// Turns of one part, with sign [-].
  [[nodiscard]] double of(DrivePart part) const;
};

/// Turns of the parts in one turn of the input, without elastic twist (DY-1) [-].
/// @param arrangement  fixed and driven part; not the same
/// @param ratio        i, turns of the wave generator in one turn of the flexspline, without sign,
///                     while the circular spline stands [-]; > 0
/// @throws InputError  if the ratio is out of range, or one part is both fixed and the input
[[nodiscard]] PartTurns part_turns(const Arrangement& arrangement, double ratio);

/// Turns of the input in one turn of the output, with sign (DY-1) [-].
[[nodiscard]] double signed_ratio(const Arrangement& arrangement, double ratio);

/// Torque that acts on the flexspline from outside over that on the output, with sign (DY-1) [-].
/// It is 1 if the flexspline is the output, and -i/(i + 1) if the circular spline is.
/// @param arrangement  fixed and driven part; not the same
/// @param ratio        as in `part_turns` [-]; > 0
/// @throws InputError  as `part_turns`
[[nodiscard]] double flexspline_torque(const Arrangement& arrangement, double ratio);

/// Number of times in one turn of the input that the wave passes a fixed point of the material of a
/// part (DY-2) [-]; the orders of the lines that a crack there adds to a spectrum.
struct WaveOrders {
  double flexspline = 0.0;       ///< at flexspline, teeth and outer ring of the bearing
  double circular_spline = 0.0;  ///< at the circular spline
};

/// Implements theory manual eq. (DY-2).
/// @param arrangement  fixed and driven part; not the same
/// @param ratio        as in `part_turns` [-]; > 0
/// @param wave_number  U, number of lobes [-]; >= 1
/// @throws InputError  if an argument is out of range
[[nodiscard]] WaveOrders wave_orders(const Arrangement& arrangement, double ratio, int wave_number);

/// The bearing of the wave generator.
struct BallSet {
  int balls = 0;                ///< Z [-]; >= 1
  double diameter_ratio = 0.0;  ///< ball over pitch diameter, d/D [-]; in (0, 1)
};

/// Number of times in one turn of the input that balls pass a fixed point of each ring, and a lobe
/// (DY-2) [-].
struct BallOrders {
  double inner_ring = 0.0;  ///< at the inner ring, which turns with the wave generator
  double outer_ring = 0.0;  ///< at the outer ring, which turns with the flexspline
  double cage = 0.0;        ///< turns of the cage against the wave generator
  /// Number of times in one turn of the input that a ball stands at a lobe of the wave; balls that
  /// stand at several lobes at once count once
  double lobe = 0.0;
};

/// Implements theory manual eq. (DY-2).  The outer ring turns with the flexspline, and the balls
/// roll.
/// @param arrangement  fixed and driven part; not the same
/// @param ratio        as in `part_turns` [-]; > 0
/// @param bearing      number of balls and ratio of the diameters
/// @param wave_number  U, number of lobes [-]; >= 1
/// @throws InputError  if an argument is out of range
[[nodiscard]] BallOrders ball_orders(const Arrangement& arrangement, double ratio,
                                     const BallSet& bearing, int wave_number = 2);

}  // namespace strainwave

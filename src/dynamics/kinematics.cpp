// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/kinematics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// (DY-1): w = (i + 1) c - i f; the coefficient of each part with all parts on one side.
double weight(DrivePart part, double ratio) {
  return part == DrivePart::wave_generator ? 1.0
         : part == DrivePart::flexspline   ? ratio
                                           : -(ratio + 1);
}

}  // namespace

DrivePart Arrangement::output() const {
  if (fixed == input)
    throw InputError("input", fmt::format("must not be the fixed part; {} is both fixed and the "
                                          "input",
                                          enum_name(fixed)));
  for (const DrivePart part :
       {DrivePart::wave_generator, DrivePart::flexspline, DrivePart::circular_spline})
    if (part != fixed && part != input) return part;
  return DrivePart::flexspline;  // not reached: of three parts one is left
}

Arrangement arrangement_of(FixedMember fixed) {
  return {.fixed = fixed == FixedMember::circular_spline ? DrivePart::circular_spline
                                                         : DrivePart::flexspline,
          .input = DrivePart::wave_generator};
}

double PartTurns::of(DrivePart part) const {
  switch (part) {
    case DrivePart::wave_generator:
      return wave_generator;
    case DrivePart::flexspline:
      return flexspline;
    case DrivePart::circular_spline:
      break;
  }
  return circular_spline;
}

PartTurns part_turns(const Arrangement& arrangement, double ratio) {
  require(ratio > 0 && std::isfinite(ratio), "ratio", ratio, "1", "> 0");
  const DrivePart output = arrangement.output();
  const double turned = -weight(arrangement.input, ratio) / weight(output, ratio);
  const auto of = [&](DrivePart part) {
    return part == arrangement.input ? 1.0 : part == output ? turned : 0.0;
  };
  return {.wave_generator = of(DrivePart::wave_generator),
          .flexspline = of(DrivePart::flexspline),
          .circular_spline = of(DrivePart::circular_spline)};
}

double signed_ratio(const Arrangement& arrangement, double ratio) {
  return 1 / part_turns(arrangement, ratio).of(arrangement.output());
}

double flexspline_torque(const Arrangement& arrangement, double ratio) {
  require(ratio > 0 && std::isfinite(ratio), "ratio", ratio, "1", "> 0");
  return weight(DrivePart::flexspline, ratio) / weight(arrangement.output(), ratio);  // (DY-1)
}

WaveOrders wave_orders(const Arrangement& arrangement, double ratio, int wave_number) {
  require(wave_number >= 1, "wave_number", wave_number, "1", ">= 1");
  const PartTurns turns = part_turns(arrangement, ratio);
  // (DY-2)
  return {.flexspline = wave_number * std::abs(turns.wave_generator - turns.flexspline),
          .circular_spline = wave_number * std::abs(turns.wave_generator - turns.circular_spline)};
}

BallOrders ball_orders(const Arrangement& arrangement, double ratio, const BallSet& bearing,
                       int wave_number) {
  require(wave_number >= 1, "wave_number", wave_number, "1", ">= 1");
  require(bearing.balls >= 1, "balls", bearing.balls, "1", ">= 1");
  require(bearing.diameter_ratio > 0 && bearing.diameter_ratio < 1, "diameter_ratio",
          bearing.diameter_ratio, "1", "between 0 and 1");
  const PartTurns turns = part_turns(arrangement, ratio);
  const double rings = std::abs(turns.wave_generator - turns.flexspline);
  // (DY-2): a ball rolls on the inner ring of the wave generator and on the outer ring.
  const double cage = rings * (1 + bearing.diameter_ratio) / 2;
  return {.inner_ring = bearing.balls * cage,
          .outer_ring = bearing.balls * (rings - cage),
          .cage = cage,
          .lobe = std::lcm(bearing.balls, wave_number) * cage};  // (DY-2)
}

}  // namespace strainwave

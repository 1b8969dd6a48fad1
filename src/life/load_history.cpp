// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/load_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/growth/rainflow.hpp"
#include "strainwave/model/input/fixed_member.hpp"

namespace strainwave {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

DutyStep step_of(const DutyBlock& block, double ratio, FixedMember fixed) {
  return {.duration = block.repetitions * block.duration,
          .output_speed = output_speed(block, ratio, fixed),
          .torque = block.torque,
          .axial_force = block.axial_force,
          .radial_force = block.radial_force,
          .bending_moment = block.bending_moment};
}

std::vector<DutyStep> steps_of(const DutyRecord& record, double ratio, FixedMember fixed) {
  std::vector<DutyStep> steps;
  steps.reserve(record.rows.size());
  const double factor = record.of_input ? 1 / signed_ratio(arrangement_of(fixed), ratio) : 1.0;
  for (std::size_t i = 0; i < record.rows.size(); ++i) {
    const DutyRow& row = record.rows[i];
    const bool last = i + 1 == record.rows.size();
    steps.push_back({.duration = last ? 0.0 : record.rows[i + 1].time - row.time,  // (LI-22)
                     .output_speed = factor * row.speed,
                     .torque = row.torque});
  }
  return steps;
}

/// Sets the sums over the steps.
void sum_up(DutyHistory& history) {
  history.average = duty_average(history.steps, history.ratio, history.fixed);
  for (const DutyStep& step : history.steps) history.duration += step.duration;
  history.output_turns = history.average.output_speed * history.duration / kTurn;
  history.input_turns =
      std::abs(signed_ratio(arrangement_of(history.fixed), history.ratio)) * history.output_turns;
}

}  // namespace

DutyHistory duty_history(const GearSet& gear) {
  if (!gear.duty)
    throw InputError("duty", "must be given; add [duty] with its [[duty.block]]s or a history");
  const Duty& duty = *gear.duty;
  DutyHistory history;
  history.residue = duty.residue;
  history.fixed = duty.fixed;
  history.ratio = gear.drive.ratio;
  history.wave_number = gear.drive.wave_number;
  if (duty.history) {
    if (!gear.duty_record || gear.duty_record->rows.empty())
      throw InputError("duty.history",
                       fmt::format("\"{}\" was not read; read the drive with its attachments",
                                   shown(*duty.history)));
    history.steps = steps_of(*gear.duty_record, history.ratio, duty.fixed);
  } else {
    for (const DutyBlock& block : duty.block)
      history.steps.push_back(step_of(block, history.ratio, duty.fixed));
  }
  sum_up(history);
  for (const DutyPeak& peak : duty.peak)
    history.peaks.push_back({.step = {.duration = peak.duration,
                                      .output_speed = output_speed(peak, history.ratio, duty.fixed),
                                      .torque = peak.torque},
                             .per_repetition = history.duration / peak.interval});
  return history;
}

double amplification(const DutyResonance& resonance, double softer) {
  const double square = resonance.frequency_ratio * resonance.frequency_ratio * softer;
  return 1 / std::hypot(1 - square, 2 * resonance.damping_ratio * std::sqrt(square));  // (GR-28)
}

DutyHistory amplified(DutyHistory history, double factor) {
  const auto amplify = [factor](DutyStep& step) {
    step.torque *= factor;
    step.axial_force *= factor;
    step.bending_moment *= factor;
  };
  for (DutyStep& step : history.steps) amplify(step);
  for (DutyMomentaryPeak& peak : history.peaks) amplify(peak.step);
  history.average.torque *= factor;
  return history;
}

DutyHistory at_flexspline(DutyHistory history) {
  const double share = flexspline_torque(arrangement_of(history.fixed), history.ratio);  // (DY-1)
  for (DutyStep& step : history.steps) step.torque *= share;
  for (DutyMomentaryPeak& peak : history.peaks) peak.step.torque *= share;
  return history;
}

std::optional<double> cycles_per_output_turn(const GearSet& gear, DutyPlace place) {
  const Arrangement arrangement = arrangement_of(fixed_member(gear));
  const double i = gear.drive.ratio;
  const double input_turns = std::abs(signed_ratio(arrangement, i));
  switch (place) {  // (LI-21)
    case DutyPlace::flexspline:
    case DutyPlace::outer_ring:
      return input_turns * wave_orders(arrangement, i, gear.drive.wave_number).flexspline;
    case DutyPlace::circular_spline:
      return input_turns * wave_orders(arrangement, i, gear.drive.wave_number).circular_spline;
    case DutyPlace::inner_ring: {
      if (!gear.wave_generator || !gear.wave_generator->bearing ||
          !gear.wave_generator->bearing->ball_count)
        return std::nullopt;
      const Bearing& bearing = *gear.wave_generator->bearing;
      const double pitch = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
      return input_turns * ball_orders(arrangement, i,
                                       {.balls = *bearing.ball_count,
                                        .diameter_ratio = bearing.ball_diameter / pitch})
                               .inner_ring;
    }
    case DutyPlace::output_shaft:
      return 1.0;
  }
  return std::nullopt;
}

PlaceCycles duty_cycles(const GearSet& gear, const DutyHistory& history, DutyPlace place) {
  const std::optional<double> per_turn = cycles_per_output_turn(gear, place);
  if (!per_turn)
    throw InputError("wave_generator.bearing.ball_count",
                     "must be given for the ball passes of the inner ring");
  PlaceCycles of{.place = place,
                 .per_output_turn = *per_turn,
                 .per_repetition = *per_turn * history.output_turns,
                 .per_hour = *per_turn * history.output_turns * history.per_hour(),
                 .steps = {}};
  of.steps.reserve(history.steps.size());
  for (std::size_t i = 0; i < history.steps.size(); ++i) {
    const DutyStep& step = history.steps[i];
    of.steps.push_back({.step = i,
                        .torque = step.torque,
                        .axial_force = step.axial_force,
                        .bending_moment = step.bending_moment,
                        .cycles = *per_turn * std::abs(step.output_speed) * step.duration / kTurn});
  }
  return of;
}

std::vector<PlaceCycles> duty_cycles(const GearSet& gear, const DutyHistory& history) {
  std::vector<PlaceCycles> all;
  for (const DutyPlace place : {DutyPlace::flexspline, DutyPlace::outer_ring, DutyPlace::inner_ring,
                                DutyPlace::circular_spline, DutyPlace::output_shaft})
    if (cycles_per_output_turn(gear, place)) all.push_back(duty_cycles(gear, history, place));
  return all;
}

std::vector<TorqueCycle> torque_cycles(const DutyHistory& history) {
  std::vector<double> torques;
  std::vector<double> begins;
  torques.reserve(history.steps.size());
  double time = 0.0;
  for (const DutyStep& step : history.steps) {
    torques.push_back(step.torque);
    begins.push_back(time);
    time += step.duration;
  }
  std::vector<TorqueCycle> cycles;
  const auto sink = [&](const CountedCycle& cycle) {
    const Reversal& peak =
        std::abs(cycle.to.value) > std::abs(cycle.from.value) ? cycle.to : cycle.from;
    cycles.push_back({.from = cycle.from.value,
                      .to = cycle.to.value,
                      .count = cycle.count,
                      .peak_time = begins[peak.place]});
  };
  RainflowCounter counter;
  counter.add(torques, sink);
  counter.finish(history.residue, sink);
  if (torques.empty()) return cycles;
  const auto [least, largest] = std::minmax_element(torques.begin(), torques.end());
  for (const DutyMomentaryPeak& peak : history.peaks) {
    const double torque = peak.step.torque;
    const double farthest = torque - *least > *largest - torque ? *least : *largest;
    if (torque != farthest)
      cycles.push_back({.from = farthest,
                        .to = torque,
                        .count = peak.per_repetition,
                        .peak_time = history.duration});
  }
  return cycles;
}

}  // namespace strainwave

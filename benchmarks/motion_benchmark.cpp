// SPDX-License-Identifier: Apache-2.0
// Motion of a joint with a catalogue spring, hysteresis, a breathing crack and a kinematic error;
// of a drive with its computed curve and the loops of its contacts; and periodic motions by
// harmonic balance.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/motion/harmonic_balance.hpp"
#include "strainwave/motion/simulate.hpp"
#include "strainwave/study/contact_losses.hpp"
#include "strainwave/study/drive_joint.hpp"

namespace strainwave {
namespace {

/// The joint of benchmarks/peer/joint_motion_peer.py at 2000 rpm.
Joint joint() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}},
          .damping = 10,
          .input_damping = 1e-3,
          .output_damping = 0.5,
          .hysteresis = dahl(1e5, 3),
          .kinematic_error = {{{2, 2e-4, 0.3}, {4, 5e-5, 1.1}, {1, 3e-5, 0.0}}},
          .cracks = {{.compliance = 2e-6,
                      .sense = OpeningSense::positive,
                      .opening = AngleOpening{.order = 2.02}}},
          .input = GivenTorque{{.value = {-0.6094395102}}},
          .output_torque = {.value = {-40.0}}};
}

Motion motion(double tolerance) {
  constexpr double kDuration = 2;
  return simulate(joint(), {.input_speed = -209.4395102, .output_speed = 2.094395102},
                  {.duration = kDuration, .output_step = kDuration, .tolerance = tolerance});
}

/// Simulated time over CPU time, with the error of the output's angle behind 2 s.  The argument is
/// the number of digits of the tolerance.
void joint_motion(benchmark::State& state) {
  const double exact = motion(1e-15).last.output_angle;
  Motion last;
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  for (auto _ : state) last = motion(tolerance);
  state.counters["error_rad"] = std::abs(last.last.output_angle - exact);
  state.counters["steps"] = static_cast<double>(last.steps);
  state.counters["events"] = static_cast<double>(last.event_count);
  state.counters["imbalance"] = last.energy.imbalance;
  state.counters["real_time"] =
      benchmark::Counter(last.time_reached, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["output_angle"] = last.last.output_angle;
}
BENCHMARK(joint_motion)->Arg(6)->Arg(7)->Arg(8)->Arg(9)->Arg(10)->Unit(benchmark::kMillisecond);

/// The joint above with the computed curve of a drive of size 25 with a cracked tooth and a cracked
/// outer ring, and with the loops of its contacts in place of the hysteresis.
Joint joint_with_contacts() {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/tooth_crack_orders_size25.toml");
  gear.drivetrain->contact_friction = ContactFriction::computed;
  Joint made = joint();
  made.table = drive_joint(gear).joint.table;
  made.loops = drive_contacts(gear).loops;
  made.hysteresis.reset();
  made.cracks.clear();
  return made;
}

Motion motion_with_contacts(double tolerance) {
  static const Joint kJoint = joint_with_contacts();
  constexpr double kDuration = 2;
  return simulate(kJoint, {.input_speed = -209.4395102, .output_speed = 2.094395102},
                  {.duration = kDuration, .output_step = kDuration, .tolerance = tolerance});
}

/// Simulated time over CPU time, with the error of the output's angle behind 2 s.  The argument is
/// the number of digits of the tolerance.
void motion_in_contacts(benchmark::State& state) {
  const double exact = motion_with_contacts(1e-13).last.output_angle;
  Motion last;
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  for (auto _ : state) last = motion_with_contacts(tolerance);
  state.counters["error_rad"] = std::abs(last.last.output_angle - exact);
  state.counters["steps"] = static_cast<double>(last.steps);
  state.counters["events"] = static_cast<double>(last.event_count);
  state.counters["imbalance"] = last.energy.imbalance;
  state.counters["real_time"] =
      benchmark::Counter(last.time_reached, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["output_angle"] = last.last.output_angle;
}
BENCHMARK(motion_in_contacts)
    ->Arg(6)
    ->Arg(7)
    ->Arg(8)
    ->Arg(9)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);

/// Backbone of 200 points with 9 harmonics: 0: a cubic spring, as benchmarks/peer/
/// duffing_balance_peer.py; 1: corners and a crack; 2: the same with damping; 3: with hysteresis
/// too; 4: with three slip elements in its place; 5: with 20 of them.
void backbone_of_200_points(benchmark::State& state) {
  Joint of{
      .ratio = -100, .input_inertia = 1e-4, .output_inertia = 1, .spring = CubicSpring{5e4, 1e10}};
  if (state.range(0) > 0) {
    of.spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
    of.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
  }
  if (state.range(0) > 1) of.damping = 10;
  if (state.range(0) == 3) of.hysteresis = dahl(1e5, 3);
  if (state.range(0) > 3) {
    const int count = state.range(0) == 4 ? 3 : 20;
    for (int n = 1; n <= count; ++n)
      of.slip_elements.push_back({1e5 / count, 6.0 * n / (count * (count + 1))});
  }
  BackboneSettings settings{.kind = state.range(0) > 1 ? BackboneKind::quadrature
                                                       : BackboneKind::undamped};
  for (int n = 0; n < 200; ++n) settings.amplitudes.push_back(5e-3 * (n + 1) / 200);
  Backbone curve;
  for (auto _ : state) curve = backbone(of, settings);
  state.counters["points"] = static_cast<double>(curve.points.size());
  state.counters["last_hertz"] = curve.points.back().frequency;
}
BENCHMARK(backbone_of_200_points)->DenseRange(0, 5)->Unit(benchmark::kMillisecond);

/// A response with two folds, with the stability of each point.
void forced_response_with_folds(benchmark::State& state) {
  const Joint of{.ratio = -100,
                 .input_inertia = 1e-4,
                 .output_inertia = 1,
                 .spring = CubicSpring{5e4, 2e10},
                 .damping = 12};
  ForcedResponse curve;
  for (auto _ : state)
    curve = forced_response(
        of, {.balance = {.input = VibratingInput::locked}, .excitation = 8, .from = 25, .to = 75});
  state.counters["points"] = static_cast<double>(curve.points.size());
  state.counters["folds"] = static_cast<double>(curve.folds.size());
}
BENCHMARK(forced_response_with_folds)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave

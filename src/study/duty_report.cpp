// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/duty_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kMostLoads = 64;
constexpr double kLoadClasses = 32;
constexpr std::size_t kMostBetween = 1000;
constexpr std::size_t kMostPlotSteps = 20000;

CountedCycles counted(const CycleTable& table, std::string unit, Residue residue) {
  CountedCycles cycles{.unit = std::move(unit),
                       .residue = residue,
                       .cycles = table.cycles(),
                       .largest_range = table.largest_range(),
                       .class_width = table.class_width(),
                       .left_out = table.left_out()};
  if (table.left_out() > 0) cycles.largest_left_out = table.largest_left_out();
  cycles.rows = table.rows();
  return cycles;
}

void note_left_out(std::vector<Note>& notes, const CountedCycles& cycles, std::string_view path) {
  if (cycles.left_out > 0)
    notes.push_back({"duty.cycles_left_out",
                     fmt::format("the rows show the {} largest ranges; {:.17g} cycles with ranges "
                                 "of at most {} {} are only counted",
                                 cycles.rows.size(), cycles.left_out,
                                 shown_number(*cycles.largest_left_out), cycles.unit),
                     std::string(path), "LI-23", Severity::information,
                     "Give --classes 64 to see all cycles in classes."});
}

/// The loads of a place, equal ones added up, in the order in which they come first.
std::vector<PlaceLoad> sums_of(const std::vector<PlaceStep>& steps, std::size_t most) {
  std::map<std::tuple<double, double, double>, std::size_t> known;
  std::vector<PlaceLoad> loads;
  for (const PlaceStep& step : steps) {
    if (step.cycles == 0) continue;
    const auto [at, fresh] =
        known.try_emplace({step.torque, step.axial_force, step.bending_moment}, loads.size());
    if (fresh)
      loads.push_back({.torque = step.torque,
                       .axial_force = step.axial_force,
                       .bending_moment = step.bending_moment,
                       .cycles = 0.0});
    loads[at->second].cycles += step.cycles;
    if (loads.size() > most) break;
  }
  return loads;
}

/// Sums up the loads, in classes of torque if there are too many.
void set_loads(PlaceReport& report, std::vector<PlaceStep> steps) {
  report.loads = sums_of(steps, kMostLoads);
  if (report.loads.size() <= kMostLoads) return;
  const auto [least, largest] = std::minmax_element(
      steps.begin(), steps.end(),
      [](const PlaceStep& a, const PlaceStep& b) { return a.torque < b.torque; });
  const double span = largest->torque - least->torque;
  const double width = std::exp2(std::ceil(std::log2(span / kLoadClasses)));
  for (PlaceStep& step : steps) step.torque = (std::floor(step.torque / width) + 0.5) * width;
  report.class_width = width;
  report.loads = sums_of(steps, steps.size());
  std::ranges::sort(report.loads, {}, &PlaceLoad::torque);
}

/// The waves whose range is larger than that of a wave at one torque, because their peak and valley
/// have different torques.  The amplitude of the wave is so large that a change of the torque is
/// smaller, as in a flexspline, whose bending is the larger part.  The table leaves out changes of
/// the torque within one rise or fall of the wave, and waves with a smaller range.
CountedCycles cycles_between(const PlaceCycles& of, Residue residue, std::optional<int> classes) {
  double largest = 0.0;
  for (const PlaceStep& step : of.steps) largest = std::max(largest, std::abs(step.torque));
  const double amplitude = 4 * largest;
  const std::vector<OscillatingStep> steps = oscillating_steps(
      of, [](const PlaceStep& step) { return step.torque; },
      [&](const PlaceStep&) { return amplitude; });
  CycleTable table(classes, kMostBetween);
  superposed_cycles(steps, residue, [&](const StepCycle& cycle) {
    const double more = cycle.range() - 2 * amplitude;
    if (more > 1e-9 * largest) table.add(more, cycle.mean(), cycle.count);
  });
  return counted(table, "N*m", residue);
}

std::string cycle_of(DutyPlace place) {
  switch (place) {
    case DutyPlace::inner_ring:
      return "ball pass";
    case DutyPlace::output_shaft:
      return "turn";
    case DutyPlace::flexspline:
    case DutyPlace::outer_ring:
    case DutyPlace::circular_spline:
      break;
  }
  return "wave";
}

/// The column to count: the one that is asked for, or the only one.
std::size_t counted_column(const HistoryFile& file, const std::optional<std::string>& name) {
  if (name) return file.number_of(*name);
  if (file.columns().size() == 1) return 0;
  std::string names;
  for (const HistoryColumn& column : file.columns())
    names += (names.empty() ? "" : ", ") + shown(column.name);
  throw InputError(TextPlace{.file = file.name()},
                   fmt::format("has the columns {}; choose one by --column", names));
}

}  // namespace

DutyReport count_history(HistoryFile& file, const HistoryCountOptions& options,
                         const Progress& progress) {
  const std::size_t column = counted_column(file, options.column);
  const HistoryColumn& of = file.columns()[column];
  DutyReport report;
  HistoryCount& count = report.history.emplace();
  count.file = file.name();
  count.column = of.name;
  count.unit = of.unit.empty() ? "1" : of.unit;
  CycleTable table(options.classes);
  std::int64_t closed = 0;
  const auto sink = [&](const CountedCycle& cycle) {
    ++closed;
    table.add(cycle.range(), cycle.mean(), cycle.count);
  };
  RainflowCounter counter;
  const std::array<std::size_t, 1> wanted = {column};
  for (;;) {
    progress.at(0.0);
    const std::vector<double>& values = file.read(wanted)[0];
    if (values.empty()) break;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    count.least = counter.size() == 0 ? *least : std::min(count.least, *least);
    count.largest = counter.size() == 0 ? *largest : std::max(count.largest, *largest);
    counter.add(values, sink);
  }
  if (counter.size() == 0)
    throw InputError(TextPlace{.file = file.name()},
                     "has no row of numbers; give at least one below the names of the columns");
  count.points = static_cast<std::int64_t>(counter.size());
  const auto open = static_cast<std::int64_t>(counter.open().size());
  count.reversals = 2 * closed + open + (open > 0 ? 1 : 0);
  counter.finish(options.residue, sink);
  count.counted = counted(table, count.unit, options.residue);
  note_left_out(report.notes, count.counted, "");
  report.equations = {"GR-1"};
  if (options.classes || count.counted.left_out > 0) report.equations.emplace_back("LI-23");
  return report;
}

DutyReport duty_report(const GearSet& gear, std::optional<int> classes) {
  const DutyHistory history = duty_history(gear);
  DutyReport report;
  DriveDuty& duty = report.drive.emplace();
  duty.fixed = history.fixed;
  duty.steps = static_cast<std::int64_t>(history.steps.size());
  duty.duration = history.duration;
  duty.output_turns = history.output_turns;
  duty.input_turns = history.input_turns;
  duty.average_torque = history.average.torque;
  duty.average_output_speed = history.average.output_speed;
  duty.average_input_speed = history.average.input_speed;
  CycleTable torques(classes);
  for (const TorqueCycle& cycle : torque_cycles(history))
    torques.add(cycle.range(), cycle.mean(), cycle.count);
  duty.torque = counted(torques, "N*m", history.residue);
  note_left_out(report.notes, duty.torque, "duty");
  for (const DutyPlace place : {DutyPlace::flexspline, DutyPlace::outer_ring, DutyPlace::inner_ring,
                                DutyPlace::circular_spline, DutyPlace::output_shaft}) {
    if (!cycles_per_output_turn(gear, place)) continue;
    PlaceCycles cycles = duty_cycles(gear, history, place);
    PlaceReport& of = duty.places.emplace_back();
    of.place = place;
    of.cycle = cycle_of(place);
    of.per_output_turn = cycles.per_output_turn;
    of.per_repetition = cycles.per_repetition;
    of.per_hour = cycles.per_hour;
    if (place == DutyPlace::outer_ring)
      of.between = duty.places.front().between;  // it has the waves of the flexspline
    else if (of.cycle == "wave")
      of.between = cycles_between(cycles, history.residue, classes);
    set_loads(of, std::move(cycles.steps));
  }
  if (!cycles_per_output_turn(gear, DutyPlace::inner_ring))
    report.notes.push_back({"duty.ball_passes_unknown",
                            "the ball passes of the inner ring are not known, because the file "
                            "does not give the number of balls",
                            "wave_generator.bearing", "LI-21", Severity::information,
                            "Give wave_generator.bearing with ball_count."});
  const double waves_per_turn = *cycles_per_output_turn(gear, DutyPlace::flexspline);
  for (const DutyMomentaryPeak& peak : history.peaks)
    duty.peaks.push_back({.torque = peak.step.torque,
                          .duration = peak.step.duration,
                          .per_repetition = peak.per_repetition,
                          .waves = waves_per_turn * std::abs(peak.step.output_speed) *
                                   peak.step.duration / (2 * std::numbers::pi)});
  if (gear.duty->resonance)
    report.notes.push_back({"duty.vibration",
                            fmt::format("the loads are those of the file; the vibration, which "
                                        "multiplies them by {} in life and growth, is not counted",
                                        shown_number(amplification(*gear.duty->resonance), 3)),
                            "duty.resonance", "GR-28", Severity::information});
  if (!history.peaks.empty())
    report.notes.push_back({"duty.peaks_added",
                            "each momentary peak adds a cycle of the torque from the farthest "
                            "torque of the duty, and all other cycles stay, which is on the safe "
                            "side",
                            "duty.peak", "LI-22", Severity::information});
  double time = 0.0;
  for (std::size_t i = 0; i < std::min(history.steps.size(), kMostPlotSteps); ++i) {
    duty.step_begins.push_back(time);
    duty.step_torques.push_back(history.steps[i].torque);
    time += history.steps[i].duration;
  }
  report.equations = {"GR-1", "LI-1", "LI-20", "LI-21"};
  if (!history.peaks.empty() || gear.duty->history) report.equations.emplace_back("LI-22");
  if (classes || duty.torque.left_out > 0) report.equations.emplace_back("LI-23");
  return report;
}

}  // namespace strainwave

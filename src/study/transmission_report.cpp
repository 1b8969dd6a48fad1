// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/transmission_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/model/input/fixed_member.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/ring_energy.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Random positions at which the sum of both families is compared with the complete drive.
constexpr int kChecks = 20;
/// Lines that the report has at most, and the least share of the largest one that a line has [-].
constexpr std::size_t kLines = 12;
constexpr double kSmallLine = 1e-3;
/// Amplitudes below it are rounding [rad].
constexpr double kRoundedLine = 1e-12;
/// A note is due if the sum of the families misses the complete drive by this share [-].
constexpr double kAddingError = 0.05;

/// The drive as it meets the wave at each tooth.
struct ToothByTooth {
  AssembledDrive drive;
  bool cracked = false;  ///< cracks turn with their part
  double turn = 0.0;     ///< of the wave generator against the circular spline, a tooth [rad]
  double torque = 0.0;   ///< of the flexspline [N*m]
  double step = 1.0;     ///< angle of the output over that of the flexspline [-]

  /// Place of the output after the wave generator has moved on by a number of teeth, but for a
  /// constant [rad].  The place is measured in the wave: deviations move the state without torque
  /// too.
  [[nodiscard]] double place(const Deviations& deviations, int teeth) const {
    const AssembledDrive moved = cracked ? drive.turned(teeth * turn) : drive;
    const AssembledDrive deviating = moved.with_deviations(moved_on(deviations, teeth));
    return step * ring_energies(deviating, {{torque / 3, torque}}).back().rotation;
  }
};

/// Only the deviations of one part; balls, cam and gap stay.
Deviations of_family(Deviations all, ErrorFamily family) {
  auto& other = family == ErrorFamily::flexspline ? all.spline : all.flexspline;
  std::ranges::fill(other, ToothDeviation{});
  return all;
}

/// Only the cracks of one part: those of the circular spline, or all others.
GearSet with_cracks_of(const GearSet& gear, ErrorFamily family) {
  return with_cracks_where(gear, [&](std::string_view member, const auto&) {
    return (member == "circular_spline") == (family == ErrorFamily::circular_spline);
  });
}

/// Errors of one family at each tooth, less their mean [rad].
std::vector<double> family_error(const ToothByTooth& of, const Deviations& deviations, int teeth,
                                 int threads, const Progress& progress) {
  std::vector<double> error(static_cast<std::size_t>(teeth));
  for_each_index(error.size(), {.block = 8, .threads = threads}, progress, [&] {
    return [&](std::size_t n) { error[n] = of.place(deviations, static_cast<int>(n)); };
  });
  const double mean = std::accumulate(error.begin(), error.end(), 0.0) / teeth;
  for (double& value : error) value -= mean;
  return error;
}

double range_of(const std::vector<double>& error) {
  const auto [least, largest] = std::ranges::minmax(error);
  return largest - least;
}

/// The errors of both families.
using FamilyErrors = std::array<std::vector<double>, 2>;

double range_of(const FamilyErrors& errors) { return range_of(errors[0]) + range_of(errors[1]); }

/// Amplitude and phase of the sine with k periods in the errors.
std::pair<double, double> line_of(const std::vector<double>& error, int k) {
  std::complex<double> sum = 0.0;
  const auto n_teeth = static_cast<double>(error.size());
  for (std::size_t n = 0; n < error.size(); ++n)
    sum += error[n] * std::polar(1.0, -2 * pi * k * static_cast<double>(n) / n_teeth);
  sum *= 2 / n_teeth;
  return {std::abs(sum), std::remainder(std::arg(sum) + pi / 2, 2 * pi)};
}

/// Turns of the wave against the part in one turn of the input [-].
double turns_against(const GearSet& gear, FixedMember fixed, ErrorFamily family) {
  const PartTurns turns = part_turns(arrangement_of(fixed), gear.drive.ratio);
  return std::abs(turns.wave_generator -
                  (family == ErrorFamily::flexspline ? turns.flexspline : turns.circular_spline));
}

void add_lines(TransmissionReport& report, const FamilyErrors& sound,
               const std::optional<FamilyErrors>& cracked, const std::array<double, 2>& turns) {
  for (std::size_t f = 0; f < 2; ++f)
    for (int k = 1; 2 * k < static_cast<int>(sound[f].size()); ++k) {
      TransmissionLine line{
          .family = static_cast<ErrorFamily>(f), .periods = k, .order = k * turns[f]};
      std::tie(line.amplitude, line.phase) = line_of(sound[f], k);
      if (cracked) {
        const auto [amplitude, phase] = line_of((*cracked)[f], k);
        line.cracked_amplitude = amplitude;
        line.cracked_phase = phase;
      }
      report.lines.push_back(line);
    }
  const auto size = [](const TransmissionLine& line) {
    return std::max(line.amplitude, line.cracked_amplitude.value_or(0.0));
  };
  std::ranges::stable_sort(report.lines, std::greater<>(), size);
  const double least = std::max(kRoundedLine, kSmallLine * size(report.lines.front()));
  std::size_t kept = 0;
  while (kept < std::min(kLines, report.lines.size()) && size(report.lines[kept]) > least) ++kept;
  report.lines.resize(kept);
}

void add_rows(TransmissionReport& report, const FamilyErrors& sound,
              const std::optional<FamilyErrors>& cracked, const std::array<double, 2>& turns) {
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t n = 0; n < sound[f].size(); ++n) {
      const double part = 2 * pi * static_cast<double>(n) / static_cast<double>(sound[f].size());
      TransmissionRow row{
          .family = static_cast<ErrorFamily>(f), .angle = part / turns[f], .error = sound[f][n]};
      if (cracked) row.cracked = (*cracked)[f][n];
      report.rows.push_back(row);
    }
}

void add_notes(TransmissionReport& report) {
  report.notes.push_back(
      {.code = "transmission.left_out",
       .text = "balls and the eccentricity of the cam keep their places, and what passes within "
               "one tooth is left out",
       .path = {},
       .equation = "DY-17",
       .severity = Severity::information});
  if (report.source == DeviationSource::drawn)
    report.notes.push_back(
        {.code = "transmission.independent_teeth",
         .text =
             "the teeth are drawn one by one, so the deviations of a real gear that add up over "
             "many teeth are missing, and the error of a real drive is larger",
         .path = "tolerance",
         .equation = "DY-17",
         .severity = Severity::care,
         .next_step = "Give the measured positions of the teeth by --flexspline-teeth and "
                      "--spline-teeth."});
  const double range = std::max(report.range, report.cracked_range.value_or(0.0));
  if (report.adding_error > kAddingError * range)
    report.notes.push_back(
        {.code = "transmission.not_additive",
         .text = fmt::format(
             "the errors of both parts do not add: at {} random positions, the complete drive "
             "differs from their sum by up to {} of the range from peak to valley",
             report.checks, percent(report.adding_error / range)),
         .path = {},
         .equation = "DY-17",
         .severity = Severity::care,
         .next_step = "Do not use the error more exactly than this difference."});
}

}  // namespace

TransmissionReport transmission_report(const GearSet& gear, const TransmissionOptions& options,
                                       const Progress& progress) {
  check(gear);
  require(options.draws >= 0, "draws", options.draws, "1", ">= 0");
  const FixedMember fixed = fixed_member(gear);
  const double step = flexspline_torque(arrangement_of(fixed), gear.drive.ratio);
  TransmissionReport report;
  report.torque = options.torque.value_or(gear.load.torque);
  require(std::isfinite(report.torque) && report.torque != 0,
          options.torque ? "torque" : "load.torque", report.torque, "N*m",
          "a finite number and not 0, because the flanks hold the output at its place under torque "
          "only");
  const AssembledDrive sound(without_cracks(gear));
  if (!sound.fails_because().empty()) throw SolverError(sound.fails_because());
  const int teeth = flexspline_teeth(gear.drive);
  const int spaces = teeth + 2;
  const std::array<int, 2> counts = {teeth, spaces};
  const std::array<double, 2> turns = {turns_against(gear, fixed, ErrorFamily::flexspline),
                                       turns_against(gear, fixed, ErrorFamily::circular_spline)};
  const auto tooth_by_tooth = [&](AssembledDrive drive, bool cracked) {
    return ToothByTooth{.drive = std::move(drive),
                        .cracked = cracked,
                        .turn = 2 * pi / spaces,
                        .torque = step * report.torque,
                        .step = step};
  };
  const ToothByTooth of_sound = tooth_by_tooth(sound, false);
  const auto sound_errors = [&](const Deviations& deviations, const Progress& part) {
    FamilyErrors errors;
    for (std::size_t f = 0; f < 2; ++f)
      errors[f] = family_error(
          of_sound, of_family(deviations, static_cast<ErrorFamily>(f)), counts[f], options.threads,
          part.part(0.5 * static_cast<double>(f), 0.5 * static_cast<double>(f + 1)));
    return errors;
  };

  Deviations deviations;
  FamilyErrors intact;
  if (options.measured) {
    deviations = paired(*options.measured, gear);
    report.source = DeviationSource::measured;
    intact = sound_errors(deviations, progress.part(0.0, 0.6));
  } else if (options.draws > 0) {
    report.source = DeviationSource::drawn;
    DrawnTransmission drawn{.seed = options.seed};
    std::vector<std::pair<double, std::uint64_t>> ranges;
    for (int n = 0; n < options.draws; ++n) {
      const auto draw = static_cast<std::uint64_t>(n);
      const Progress part = progress.part(0.6 * n / options.draws, 0.6 * (n + 1) / options.draws);
      try {
        ranges.emplace_back(range_of(sound_errors(draw_deviations(gear, options.seed, draw), part)),
                            draw);
      } catch (const SolverError&) {  // these parts have no equilibrium
        ++drawn.failed;
      }
    }
    if (ranges.empty()) throw SolverError("none of the drawn drives has an equilibrium");
    std::ranges::sort(ranges);
    std::vector<double> values;
    for (const auto& [range, draw] : ranges) values.push_back(range);
    drawn.draws = static_cast<int>(values.size());
    drawn.low = quantile(values, 0.05);
    drawn.median = quantile(values, 0.5);
    drawn.high = quantile(values, 0.95);
    report.drawn = drawn;
    deviations = draw_deviations(gear, options.seed, ranges[(ranges.size() - 1) / 2].second);
    intact = sound_errors(deviations, progress.part(0.6, 0.65));
  } else {
    intact = {std::vector<double>(static_cast<std::size_t>(teeth)),
              std::vector<double>(static_cast<std::size_t>(spaces))};
  }
  report.range = range_of(intact);

  std::optional<FamilyErrors> cracked;
  std::optional<ToothByTooth> complete;
  if (has_cracks(gear)) {
    cracked.emplace();
    for (std::size_t f = 0; f < 2; ++f) {
      const auto family = static_cast<ErrorFamily>(f);
      const AssembledDrive drive(with_cracks_of(gear, family));
      if (!drive.fails_because().empty()) throw SolverError(drive.fails_because());
      (*cracked)[f] = family_error(
          tooth_by_tooth(drive, true), of_family(deviations, family), counts[f], options.threads,
          progress.part(0.65 + 0.15 * static_cast<double>(f), 0.8 + 0.15 * static_cast<double>(f)));
    }
    report.cracked_range = range_of(*cracked);
    complete = tooth_by_tooth(AssembledDrive(gear), true);
  } else {
    complete = of_sound;
  }

  // The mean of the complete drive is that of its families up to what does not add.
  if (!deviations.empty() || cracked) {
    const FamilyErrors& added = cracked ? *cracked : intact;
    std::vector<double> differences;
    for (int n = 0; n < kChecks; ++n) {
      const double share = counter_uniform(options.seed, static_cast<std::uint64_t>(n), 0);
      const int at = static_cast<int>(share * teeth * spaces / 2);
      differences.push_back(complete->place(deviations, at) -
                            added[0][static_cast<std::size_t>(at % teeth)] -
                            added[1][static_cast<std::size_t>(at % spaces)]);
    }
    report.checks = kChecks;
    const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / kChecks;
    for (const double difference : differences)
      report.adding_error = std::max(report.adding_error, std::abs(difference - mean));
  }
  add_lines(report, intact, cracked, turns);
  add_rows(report, intact, cracked, turns);
  report.notes = complete->drive.notes();
  add_notes(report);
  report.equations = {"DY-1", "DY-2", "DY-17", "TC-28", "TC-36"};
  progress.at(1.0);
  return report;
}

}  // namespace strainwave

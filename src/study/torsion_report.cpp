// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/torsion_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string_view>

#include "drawn_drive.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/result/input_notes.hpp"

namespace strainwave {

template <class Archive>
void archive(Archive& to, MakersLines& lines) {
  to(lines.K1, lines.K2, lines.K3, lines.phi1, lines.phi2, lines.phi3);
}

namespace {

constexpr int kRimPositions = 180;
constexpr int kCagePhases = 12;
constexpr int kCurvePoints = 40;  // points on each side, evenly spaced in the root of the torque

std::vector<double> curve_torques(const MakersTorques& at, const TwistAtLoad& at_load) {
  const double most = std::max(at.T3, at.rated);
  std::vector<double> torques = {at.T1, at.T2, at.T3, at.rated};
  if (at_load.torque > 0 && at_load.positive && at_load.negative) torques.push_back(at_load.torque);
  for (int i = 1; i <= kCurvePoints; ++i) {
    const double share = static_cast<double>(i) / kCurvePoints;
    torques.push_back(most * share * share);
  }
  std::ranges::sort(torques);
  const auto same = [&](double a, double b) { return b - a < 1e-9 * most; };
  torques.erase(std::unique(torques.begin(), torques.end(), same), torques.end());
  return torques;
}

TorsionCurve usable_curve(const AssembledDrive& drive, std::vector<double> torques, double sense) {
  for (double& torque : torques) torque *= sense;
  TorsionCurve curve = torsion_curve(drive, torques);
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  return curve;
}

/// The twist at the load's torque, with a note if the drive does not reach it.
TwistAtLoad twist_at_load(const AssembledDrive& drive, std::vector<Note>& notes) {
  TwistAtLoad at{.torque = std::abs(drive.gear().load.torque), .positive = {}, .negative = {}};
  const auto reach = [&](std::optional<double>& twist, double sense) {
    const auto reached = reached_twist(drive, sense * at.torque, notes);
    if (reached) twist = std::abs(*reached);
  };
  reach(at.positive, +1);
  reach(at.negative, -1);
  return at;
}

/// Lost motion from which a drive is not like those that makers sell, whose limit is 1 to 2 arcmin
/// [rad].
constexpr double kLargeLostMotion = 3 * units::arcmin;

/// Share of the ball force at T2 from which the force of the assembly alone is noted [-].
constexpr double kLargeAssemblyShare = 0.5;

double largest_ball_force(const TorsionCurve& curve, double torque) {
  const auto point = std::ranges::min_element(
      curve.points, {}, [&](const CurvePoint& p) { return std::abs(p.torque - torque); });
  return std::ranges::max(point->balls, {}, &ContactForce::force).force;
}

/// Notes results that a working drive does not have, with their cause.
void note_consequences(TorsionReport& report) {
  const auto shown = [](double angle) { return shown_quantity(angle, "rad", 4, "lost_motion"); };
  const double at_rest = report.curve.assembly_ball_force;
  const double at_T2 = largest_ball_force(report.curve, report.torques.T2);
  if (at_rest > kLargeAssemblyShare * at_T2)
    report.notes.push_back(
        {"torsion.assembly_force",
         fmt::format("the most loaded ball carries {} without torque and {} at T2, so most of its "
                     "load comes from "
                     "the assembly",
                     shown_quantity(at_rest, "N", 3, "force"),
                     shown_quantity(at_T2, "N", 3, "force")),
         "wave_generator.bearing", "TC-12", Severity::care,
         "Check ball_count, the lengths of the flexspline and the thicknesses of its walls."});
  if (report.lost_motion > kLargeLostMotion)
    report.notes.push_back(
        {"torsion.lost_motion",
         fmt::format(
             "the lost motion of {} is far above the 1 to 2 arcmin that makers state; gaps of "
             "flanks or bearing let the output turn without load",
             shown(report.lost_motion)),
         "mesh.lobe_gap", "TC-18", Severity::care,
         "Check mesh.lobe_gap and wave_generator.bearing.clearance."});
  if (report.positive.K1 > report.positive.K2 || report.negative.K1 > report.negative.K2)
    report.notes.push_back({"torsion.falling_stiffness",
                            fmt::format("K1 is above K2, unlike in any catalogue{}",
                                        report.curve.assembly_flank_force > 0
                                            ? ": flanks press on each other without torque and "
                                              "part as the torque grows"
                                            : ""),
                            "mesh.lobe_gap", "TC-14", Severity::care,
                            "Check mesh.lobe_gap and drive.radial_displacement."});
  if (!report.comparison) return;
  const auto& [with, without] =
      std::pair(report.comparison->lost_motion_cracked, report.comparison->lost_motion_sound);
  if (with < without * (1 - 1e-9))
    report.notes.push_back(
        {"torsion.less_lost_motion",
         fmt::format(
             "at the positions of the file the cracks reduce the lost motion from {} to {}, "
             "because a cracked ring gives back part of the bending of the assembly there; "
             "this is no sign of a better drive",
             shown(without), shown(with)),
         "", "TC-22", Severity::information, "Look at the changes over a turn."});
}

/// The makers' limit of the hysteresis loss [rad].
double makers_loss(const GearSet& gear) {
  constexpr double kLeastRegularRatio = 50;
  return (gear.drive.ratio < kLeastRegularRatio ? 3 : 1) * units::arcmin;
}

/// Notes on the friction without load.
void note_friction(TorsionReport& report, const GearSet& gear) {
  const auto shown = [](double angle) { return shown_quantity(angle, "rad", 3, "width_at_zero"); };
  const LossAtZero& loss = report.friction.loss_at_zero;
  const bool pressed = report.curve.assembly_flank_force > 0;
  if (loss.output == 0)
    report.notes.push_back(
        {"hysteresis.no_load",
         fmt::format(
             "the loss at zero torque and the no-load torque contain the friction of {}; "
             "grease and seals cause most of a maker's values, and the output's part of them "
             "is rating.friction_torque, which is 0",
             pressed ? "balls, outer ring and flanks, which press on each other without "
                       "torque"
                     : "balls and outer ring; flanks carry nothing without torque"),
         "rating.friction_torque", "TC-34", Severity::care, "Give rating.friction_torque."});
  if (loss.total() > makers_loss(gear))
    report.notes.push_back(
        {"hysteresis.large_loss",
         fmt::format(
             "the loss at zero torque of {} is above the {} that makers guarantee: {} by the "
             "flanks, {} by the outer ring, {} by rating.friction_torque",
             shown(loss.total()), shown(makers_loss(gear)), shown(loss.flanks),
             shown(loss.outer_ring), shown(loss.output)),
         pressed ? "mesh.lobe_gap" : "rating.friction_torque", "TC-16", Severity::care,
         "Check mesh.lobe_gap, the coefficients of friction and rating.friction_torque."});
}

/// Module below which ISO 1328-1 gives no tolerances [m].
constexpr double kLeastModule = 0.5 * units::mm;

/// Notes on the drives drawn from the tolerances.
void note_tolerances(TorsionReport& report, const GearSet& gear) {
  if (!report.tolerances) {
    if (gear.tolerance)
      report.notes.push_back(
          {"tolerance.not_drawn",
           "the file gives tolerances, but the curve is that of a drive without deviations", "",
           "TC-36", Severity::information, "Run the command with --tolerances 100."});
    return;
  }
  const ToleranceEffects& effects = *report.tolerances;
  if (const double module = gear.drive.pitch_diameter / report.curve.teeth; module < kLeastModule)
    report.notes.push_back(
        {"tolerance.small_module",
         fmt::format("the module of this drive, {}, is below {}, where ISO 1328-1 begins, so the "
                     "single pitch deviation of {} is extrapolated from its formula",
                     shown_quantity(module, "m", 3, "module"),
                     shown_quantity(kLeastModule, "m", 3, "module"),
                     shown_quantity(effects.limits.single_pitch, "m", 3, "single_pitch")),
         "tolerance.grade", "TC-36", Severity::information});
  if (effects.failed > 0)
    report.notes.push_back(
        {"tolerance.failed",
         fmt::format("{} of {} drawn drives have no equilibrium and are left out of the quantiles",
                     effects.failed, effects.failed + effects.draws),
         "tolerance", "TC-36", Severity::care,
         "Check tolerance.grade, tolerance.run_out and mesh.lobe_gap."});
}

void add_once(std::vector<Note>& notes, const std::vector<Note>& more) {
  for (const Note& note : more)
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
}

struct Limits {
  double lower = 0.0;
  double upper = 0.0;
};

std::vector<Limits> limits_of(const GearSet& gear, const std::vector<InputRange>& ranges) {
  std::vector<Limits> limits;
  for (const InputRange& range : ranges) {
    const std::string_view unit = number_at(gear, range.path).field.unit;
    limits.push_back({.lower = parse_quantity("lower", range.lower, unit),
                      .upper = parse_quantity("upper", range.upper, unit)});
  }
  return limits;
}

Band band(std::vector<double> values) {
  return {quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
}

/// Hands the positions of the wave generator over as rows.
void write_positions(const CurveComparison& comparison, RowSink& to) {
  RowHead head{.of = "positions of the wave generator",
               .rows = comparison.angles.size(),
               .columns = {{"angle", "rad"}}};
  for (const std::string_view sense : {"positive", "negative"})
    for (const std::string_view line : {"K1", "K2", "K3"})
      head.columns.push_back({fmt::format("{}.{}", sense, line), "1"});
  to.begin(head);
  for (std::size_t n = 0; n < comparison.angles.size(); ++n) {
    const LineChanges& positive = comparison.positive.at_angle[n];
    const LineChanges& negative = comparison.negative.at_angle[n];
    to.add(std::array{comparison.angles[n], positive.K1, positive.K2, positive.K3, negative.K1,
                      negative.K2, negative.K3},
           RowStatus::usable, {});
  }
}

}  // namespace

std::vector<InputRange> ranges_of_curve(const GearSet& gear) {
  constexpr std::array<std::string_view, 3> kMotion = {"drivetrain.", "kinematic_error[",
                                                       "manoeuvre["};
  std::vector<InputRange> ranges;
  for (const InputRange& range : gear.range)
    if (std::ranges::none_of(
            kMotion, [&](std::string_view section) { return range.path.starts_with(section); }))
      ranges.push_back(range);
  return ranges;
}

LineBands line_bands(const AssembledDrive& drive, const BandOptions& options,
                     const Progress& progress) {
  const GearSet& gear = drive.gear();
  const std::vector<InputRange> ranges = ranges_of_curve(gear);
  const std::vector<Limits> limits = limits_of(gear, ranges);
  std::mt19937_64 random(20240607);
  // The sequence of std::uniform_real_distribution differs between libraries, so it is not used.
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto draws = static_cast<std::size_t>(options.draws);
  std::vector<double> values;  // values of all draws, one draw after the other
  for (std::size_t n = 0; n < draws; ++n)
    for (const Limits& limit : limits)
      values.push_back(limit.lower + (limit.upper - limit.lower) * uniform());

  const auto drawn_lines = [&](DrawnDrive& drawn, std::size_t n) {
    for (std::size_t i = 0; i < limits.size(); ++i) drawn.number(i) = values[n * limits.size() + i];
    return makers_lines(
        AssembledDrive(drawn.gear(), drive.options()).with_deviations(drive.deviations()));
  };
  using Lines = std::optional<MakersLines>;
  const Parallel parallel{.threads = options.threads};
  std::vector<Lines> lines = shared_rows<Lines>(draws, parallel, progress, options.shared, [&] {
    return [&, drawn = std::make_unique<DrawnDrive>(gear, ranges)](std::size_t n, Lines& of_draw) {
      try {
        of_draw = drawn_lines(*drawn, n);
      } catch (const Error&) {  // this combination cannot be assembled
      }
    };
  });
  if (options.rows != nullptr) {
    RowHead head{.of = "draws of the ranges", .rows = draws, .columns = {}};
    for (const InputRange& range : ranges)
      head.columns.push_back({range.path, std::string(number_at(gear, range.path).field.unit)});
    for (const char* const line : {"K1", "K2", "K3"}) head.columns.push_back({line, "N*m/rad"});
    options.rows->begin(head);
    DrawnDrive drawn(gear, ranges);
    for (std::size_t n = 0; n < draws; ++n) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(n * limits.size());
      std::vector<double> numbers(first, first + static_cast<std::ptrdiff_t>(limits.size()));
      RowStatus status = RowStatus::usable;
      std::string rule;
      if (lines[n]) {
        numbers.insert(numbers.end(), {lines[n]->K1, lines[n]->K2, lines[n]->K3});
      } else {
        try {
          (void)drawn_lines(drawn, n);
        } catch (const InputError& fault) {
          status = RowStatus::refused;
          rule = rule_of(fault);
        } catch (const Error& fault) {
          status = RowStatus::unusable;
          rule = rule_of(fault);
        }
      }
      numbers.resize(head.columns.size(), std::numeric_limits<double>::quiet_NaN());
      options.rows->add(numbers, status, rule);
    }
  }
  const auto rejected = std::erase(lines, std::nullopt);
  if (lines.empty())
    throw SolverError("none of the drives drawn from the ranges can be built or assembled");
  const auto band_of = [&](double MakersLines::*line) {
    std::vector<double> drawn;
    for (const auto& of_draw : lines) drawn.push_back((*of_draw).*line);
    return band(std::move(drawn));
  };
  return {.K1 = band_of(&MakersLines::K1),
          .K2 = band_of(&MakersLines::K2),
          .K3 = band_of(&MakersLines::K3),
          .ranges = static_cast<int>(ranges.size()),
          .draws = static_cast<int>(lines.size()),
          .rejected = static_cast<int>(rejected)};
}

TorsionReport torsion_report(const GearSet& gear, const TorsionReportOptions& options,
                             const Progress& progress) {
  // Shares of the time; without ranges and cracks, the curve takes all of it.
  const bool draws = !ranges_of_curve(gear).empty() && options.draws > 0;
  const double curve_ends = draws || options.compare ? 0.2 : 1.0;
  const double draws_end = !draws ? curve_ends : options.compare ? 0.5 : 1.0;
  ToleranceOptions of_tolerances = options.tolerances.value_or(ToleranceOptions());
  if (options.tolerances) {
    of_tolerances.shared = options.shared;
    of_tolerances.rows = options.rows;
  }
  SharedRows* const of_positions =
      options.compare && !options.tolerances ? options.shared : nullptr;
  SharedRows* const of_bands = !options.compare && !options.tolerances ? options.shared : nullptr;
  RowSink* const rows_of_bands = !options.compare && !options.tolerances ? options.rows : nullptr;
  const Progress of_file = options.tolerances ? progress.part(0.0, 0.4) : progress;
  TorsionReport report;
  const CoupledOptions coupled{.cage_phase = options.cage_phase};
  const AssembledDrive drive(gear, coupled);
  of_file.at(0.0);
  report.torques = makers_torques(gear);
  std::vector<Note> unreached;
  report.at_load = twist_at_load(drive, unreached);
  const std::vector<double> torques = curve_torques(report.torques, report.at_load);
  const std::array<std::function<void()>, 3> parts = {
      [&] { report.curve = usable_curve(drive, torques, +1); },
      [&] { report.curve_negative = usable_curve(drive, torques, -1); },
      [&] {
        const Hysteresis hysteresis(drive, report.torques.rated);
        report.loop = hysteresis_loop(hysteresis, report.torques.rated);
        report.friction = {.loss_at_zero = hysteresis.loss_at_zero(),
                           .no_load = no_load_torque(drive),
                           .back_driving_torque = back_driving_torque(drive)};
      }};
  for_each_index(parts.size(), {}, of_file.part(0.0, 0.9 * curve_ends),
                 [&] { return [&](std::size_t i) { parts[i](); }; });
  std::vector<double> shown = {report.torques.T1, report.torques.T2, report.torques.rated};
  if (report.at_load.torque > 0 && report.at_load.positive && report.at_load.negative)
    shown.push_back(report.at_load.torque);
  std::ranges::sort(shown);
  for (const double at : shown) {
    const auto point = std::ranges::min_element(
        report.curve.points, {}, [&](const CurvePoint& p) { return std::abs(p.torque - at); });
    const auto index = static_cast<std::size_t>(point - report.curve.points.begin());
    if (std::ranges::find(report.shown, index) == report.shown.end()) report.shown.push_back(index);
  }
  report.positive = makers_lines(drive, +1);
  report.negative = makers_lines(drive, -1);
  report.over_cage =
      lines_over_cage(drive, kCagePhases, of_file.part(0.9 * curve_ends, curve_ends));
  of_file.at(curve_ends);
  report.lost_motion = lost_motion(drive);
  report.rim = rim_states(drive, report.torques.rated, kRimPositions);
  of_file.at(curve_ends);
  if (draws)
    report.bands =
        line_bands(drive, {.draws = options.draws, .shared = of_bands, .rows = rows_of_bands},
                   of_file.part(curve_ends, draws_end));
  if (options.compare) {
    report.comparison =
        compare_curves(drive, options.angles, of_file.part(draws_end, 1.0), of_positions);
    if (options.rows != nullptr && !options.tolerances)
      write_positions(*report.comparison, *options.rows);
    const AssembledDrive sound = drive.without_cracks();
    report.sound = usable_curve(sound, torques, +1);
    report.sound_negative = usable_curve(sound, torques, -1);
  }
  if (options.tolerances)
    report.tolerances = tolerance_effects(drive, of_tolerances, progress.part(0.4, 1.0));
  if (report.torques.by_convention)
    report.notes.push_back({"rating.convention",
                            "the file does not give T1 and T2; they are assumed as 0.0517 and "
                            "0.187 N/mm^2 times the cube of the pitch diameter, as in catalogues",
                            "rating", "TC-14", Severity::information,
                            "Give rating.T1 and rating.T2 to use the maker's torques."});
  add_once(report.notes, input_notes(gear));
  add_once(report.notes, unreached);
  add_once(report.notes, report.curve.notes);
  add_once(report.notes, report.curve_negative.notes);
  if (has_cracks(gear) && !options.compare)
    report.notes.push_back({"torsion.compare",
                            "the drive has cracks; --compare shows the changes by the cracks, also "
                            "over a turn of the wave generator",
                            "", "TC-26", Severity::information, "Run the command with --compare."});
  if (options.compare && !has_cracks(gear))
    report.notes.push_back({"torsion.no_cracks",
                            "the file has no cracks, so there is nothing to compare", "", "TC-26",
                            Severity::information});
  note_consequences(report);
  note_friction(report, gear);
  note_tolerances(report, gear);
  report.equations = report.curve.equations;
  for (const char* const tag : {"TC-16", "TC-17", "TC-18", "TC-24", "TC-33", "TC-34", "TC-35"})
    report.equations.emplace_back(tag);
  if (options.compare) report.equations.emplace_back("TC-26");
  if (options.tolerances) report.equations.emplace_back("TC-36");
  return report;
}

}  // namespace strainwave

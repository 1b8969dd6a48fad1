// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/backbone_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/study/drive_joint.hpp"

namespace strainwave {
namespace {

/// Excitations if none is given, of the load's torque.
constexpr std::array<double, 2> kExcitationsByDefault = {0.05, 0.2};
constexpr double kSmallestAmplitude = 0.01;  // of the largest one
constexpr double kBelowResonances = 0.5;     // where responses begin
constexpr double kAboveResonances = 1.5;     // where they end
constexpr double kLargestTruncation = 1e-3;  // of the energy
constexpr int kMostBackbonePoints = 10'000;
constexpr int kAnglesPerSide = 720;      // of the input, at which the tangent is compared
constexpr double kLargestChange = 0.01;  // of the tangent, from which the note is of care

void check_settings(const GearSet& gear, const BackboneReportSettings& settings) {
  const auto positive_number = [](std::string_view field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  if (!gear.drivetrain)
    throw InputError("drivetrain",
                     "must be given for a backbone; give [drivetrain] with motor_inertia and "
                     "load_inertia");
  for (const double excitation : settings.excitations)
    positive_number("--excitation", excitation, "N*m");
  if (settings.amplitude) positive_number("--amplitude", *settings.amplitude, "rad");
  if (settings.from) positive_number("--from", *settings.from, "Hz");
  if (settings.to) positive_number("--to", *settings.to, "Hz");
  if (settings.from && settings.to)
    require(*settings.to > *settings.from, "--to", *settings.to, "Hz", "larger than --from");
  if (settings.load_torque)
    require(std::isfinite(*settings.load_torque), "--load-torque", *settings.load_torque, "N*m",
            "a finite number");
  require(settings.points >= 2 && settings.points <= kMostBackbonePoints, "--points",
          settings.points, "1", "from 2 to 10000");
  if (settings.input == VibratingInput::locked && settings.at == JointEnd::motor)
    throw InputError("--at",
                     "cannot be motor while the input is locked; give --at load, or --input free");
}

/// Amplitudes with equal ratios.
std::vector<double> growing_amplitudes(double largest, int count) {
  std::vector<double> values;
  for (int n = 0; n + 1 < count; ++n)
    values.push_back(largest * std::pow(kSmallestAmplitude, 1 - n / (count - 1.0)));
  values.push_back(largest);
  return values;
}

/// Both backbones of a joint.
struct Backbones {
  Backbone undamped;
  Backbone quadrature;

  [[nodiscard]] std::size_t size() const {
    return std::min(undamped.points.size(), quadrature.points.size());
  }
  [[nodiscard]] VibrationAt at(std::size_t n) const {
    const BackbonePoint& free = undamped.points[n];
    const BackbonePoint& kept = quadrature.points[n];
    return {.frequency = free.frequency,
            .resonance = kept.frequency,
            .damping_ratio = kept.damping_ratio,
            .torque = kept.torque,
            .excitation = kept.excitation};
  }
};

Backbones backbones_of(const Joint& joint, const BalanceSettings& balance, JointEnd at,
                       const std::vector<double>& amplitudes, const Progress& progress) {
  return {.undamped = backbone(joint,
                               {.balance = balance,
                                .kind = BackboneKind::undamped,
                                .excited = at,
                                .amplitudes = amplitudes},
                               progress.part(0.0, 0.3)),
          .quadrature = backbone(joint,
                                 {.balance = balance,
                                  .kind = BackboneKind::quadrature,
                                  .excited = at,
                                  .amplitudes = amplitudes},
                                 progress.part(0.3, 1.0))};
}

ResponseOf response_of(const ForcedResponse& curve, DriveState drive, double excitation) {
  ResponseOf made{.drive = drive,
                  .excitation = excitation,
                  .converged = curve.converged,
                  .reason = curve.reason};
  for (const ResponsePoint& at : curve.points) {
    made.points.push_back({.frequency = at.frequency,
                           .amplitude = at.amplitude,
                           .torque = at.torque,
                           .output = at.output,
                           .lag = at.lag,
                           .multiplier = at.multiplier,
                           .stable = at.stable});
  }
  // The end of a curve may be above its peaks.
  const auto raise = [&](const auto& at) {
    if (!at.stable || at.amplitude <= made.peak) return;
    made.peak = at.amplitude;
    made.peak_frequency = at.frequency;
    made.peak_torque = at.torque;
  };
  for (const ResponsePoint& at : curve.points) raise(at);
  for (const Peak& at : curve.peaks) raise(at);
  for (const Fold& fold : curve.folds) {
    made.jumps.push_back(
        {.frequency = fold.frequency, .amplitude = fold.amplitude, .rising = fold.rising});
  }
  return made;
}

/// Whether a vibration loses energy.  A motor that keeps its speed does not.
bool loses_energy(const Joint& joint, VibratingInput input) {
  return joint.hysteresis || !joint.slip_elements.empty() || joint.damping > 0 ||
         joint.output_damping > 0 || (input == VibratingInput::free && joint.input_damping > 0);
}

void note_left_out(const GearSet& gear, std::vector<Note>& notes) {
  const auto left_out = [&](const char* words, const char* path) {
    notes.push_back({.code = "backbone.left_out",
                     .text = fmt::format("a backbone leaves out {}", words),
                     .path = path,
                     .equation = "MO-15",
                     .severity = Severity::information,
                     .next_step = "Run strainwave simulate, which contains it."});
  };
  if (gear.drivetrain->contact_friction == ContactFriction::computed)
    left_out("the loops of the contacts, which hold a vibration with a standing input back",
             "drivetrain.contact_friction");
  if (!kinematic_error_of(gear).orders().empty())
    left_out("the kinematic error, because the drive does not turn on average", "kinematic_error");
  if (gear.drivetrain->friction)
    left_out("the friction of the input, because the drive does not turn on average",
             "drivetrain.friction");
  if (gear.drivetrain->load_friction)
    left_out("the friction of the load, whose loss is not one of the twist",
             "drivetrain.load_friction");
  if (gear.drivetrain->gravity_torque != 0)
    left_out("gravity, because the drive works about a constant load torque",
             "drivetrain.gravity_torque");
}

/// Largest torque of the curves with the load [N*m].
double largest_torque(const BackboneReport& report) {
  double range = 0.0;
  for (const BackboneRow& row : report.backbone)
    range = std::max({range, row.intact.torque, row.cracked ? row.cracked->torque : 0.0});
  for (const ResponseOf& of : report.responses) range = std::max(range, of.peak_torque);
  return std::abs(report.load_torque) + range;
}

/// Largest torque of the curves against the momentary peak that the maker allows.
void note_large_torque(const GearSet& gear, BackboneReport& report) {
  const auto limit = makers_limits(gear).momentary_peak;
  if (!limit) return;
  const double largest = largest_torque(report);
  if (largest <= limit->value) return;
  report.notes.push_back(
      {.code = "backbone.large_torque",
       .text =
           fmt::format("vibrations reach {} with the load, above the momentary peak of {} that "
                       "the maker allows",
                       shown_quantity(largest, "N*m", 4), shown_quantity(limit->value, "N*m", 4)),
       .path = "drivetrain",
       .equation = "LI-30",
       .severity = Severity::care,
       .next_step = "Choose a smaller --excitation or --amplitude."});
}

/// Largest torque of the curves against the end of the table.
void note_end_of_table(BackboneReport& report) {
  if (!report.table || largest_torque(report) <= report.table->most_torque) return;
  report.notes.push_back(
      {.code = "backbone.beyond_table",
       .text = fmt::format("vibrations reach {} with the load, beyond {}, where the table of the "
                           "computed curve ends and its last tangent goes on",
                           shown_quantity(largest_torque(report), "N*m", 4),
                           shown_quantity(report.table->most_torque, "N*m", 4)),
       .path = "drivetrain.curve_torque",
       .equation = "MO-26",
       .severity = Severity::care,
       .next_step = "Raise drivetrain.curve_torque."});
}

/// What the curve at one angle of the input leaves out: the change of its tangent under the load
/// over the swing of a free input, and over a whole turn (MO-28).
void evaluate_standing_input(const Joint& joint, BackboneReport& report) {
  if (!joint.table) return;
  const auto compliance = [&](double angle) {
    return joint.table->at(angle).at_torque(-report.load_torque).compliance;
  };
  const double at_start = compliance(0.0);
  const auto change_within = [&](double reach) {
    double most = 0.0;
    for (int n = -kAnglesPerSide; n <= kAnglesPerSide; ++n) {
      const double here = compliance(reach * n / kAnglesPerSide);
      most = std::max(most, std::abs(at_start / here - 1));  // (MO-28)
    }
    return most;
  };
  report.change_over_turn = change_within(std::numbers::pi);
  if (report.input == VibratingInput::locked) {
    report.change_over_swing = 0.0;
  } else {
    double largest = 0.0;
    if (!report.backbone.empty()) largest = report.backbone.back().amplitude;
    for (const ResponseOf& of : report.responses) largest = std::max(largest, of.peak);
    const double input = joint.ratio * joint.ratio * joint.input_inertia;
    report.input_swing = std::abs(joint.ratio) * largest * joint.output_inertia /
                         (input + joint.output_inertia);  // (MO-28)
    report.change_over_swing = change_within(std::min(*report.input_swing, std::numbers::pi));
  }
  const auto percent = [](double share) { return shown_number(100 * share, 2); };
  std::string text = "the computed curve is that of an input that stands where it starts; ";
  if (report.input_swing)
    text += fmt::format(
        "the free input swings by up to {}, over which the tangent stiffness under the load "
        "changes by up to {} %, and over a whole turn it changes by up to {} %",
        shown_quantity(*report.input_swing, "deg", 3), percent(*report.change_over_swing),
        percent(*report.change_over_turn));
  else
    text += fmt::format(
        "over a whole turn of the input the tangent stiffness under the load changes by up to {} %",
        percent(*report.change_over_turn));
  report.notes.push_back(
      {.code = "backbone.input_angle",
       .text = std::move(text),
       .path = "drivetrain.spring",
       .equation = "MO-28",
       .severity =
           *report.change_over_swing > kLargestChange ? Severity::care : Severity::information,
       .next_step = "Run strainwave simulate, whose input moves along the curve."});
}

}  // namespace

BackboneReport backbone_report(const GearSet& gear, const BackboneReportSettings& settings,
                               const Progress& progress) {
  check_settings(gear, settings);
  DriveJoint made = drive_joint(gear, progress.part(0.0, 0.1));
  const Joint sound = made.sound();
  const bool cracked = made.cracked();
  BackboneReport report{.load_torque = settings.load_torque.value_or(gear.load.torque),
                        .input = settings.input,
                        .at = settings.at,
                        .harmonics = settings.harmonics,
                        .springs = made.springs,
                        .table = made.table,
                        .notes = std::move(made.notes)};
  const BalanceSettings balance{
      .input = settings.input, .load_torque = report.load_torque, .harmonics = settings.harmonics};
  report.small_frequency = small_frequency(sound, balance);
  if (cracked) report.cracked_small_frequency = small_frequency(made.joint, balance);
  const double largest = settings.amplitude.value_or(
      std::abs(twist_at_rest(sound, gear.load.torque) - twist_at_rest(sound, 0.0)));
  if (largest == 0)
    throw InputError("--amplitude", "must be given, because the load of the file has no torque");
  const std::vector<double> amplitudes = growing_amplitudes(largest, settings.points);

  const Backbones intact =
      backbones_of(sound, balance, settings.at, amplitudes, progress.part(0.1, 0.25));
  std::optional<Backbones> softer;
  if (cracked)
    softer = backbones_of(made.joint, balance, settings.at, amplitudes, progress.part(0.25, 0.4));
  double lowest = report.small_frequency;
  double highest = lowest;
  const auto take = [&](const Backbone& curve, std::string_view words) {
    for (const BackbonePoint& at : curve.points) {
      lowest = std::min(lowest, at.frequency);
      highest = std::max(highest, at.frequency);
      report.truncation = std::max(report.truncation, at.truncation);
    }
    if (curve.converged) return;
    report.notes.push_back(
        {.code = "backbone.not_finished",
         .text = fmt::format("the backbone of the {} drive ends early: {}", words, curve.reason),
         .path = "drivetrain",
         .equation = "MO-16",
         .severity = Severity::critical,
         .next_step = "Choose a smaller --amplitude, or another number of --harmonics."});
  };
  std::size_t rows = intact.size();
  take(intact.undamped, "sound");
  take(intact.quadrature, "sound");
  if (softer) {
    take(softer->undamped, "cracked");
    take(softer->quadrature, "cracked");
    rows = std::min(rows, softer->size());
  }
  for (std::size_t n = 0; n < rows; ++n) {
    BackboneRow& row = report.backbone.emplace_back(
        BackboneRow{.amplitude = amplitudes[n], .intact = intact.at(n)});
    if (softer) row.cracked = softer->at(n);
  }

  std::vector<double> excitations = settings.excitations;
  const bool lossy = loses_energy(sound, settings.input);
  if (!excitations.empty() && !lossy)
    throw InputError("--excitation",
                     "needs a drive that loses energy, because its response would grow without "
                     "bound; give drivetrain.gear_damping, drivetrain.hysteresis or "
                     "drivetrain.slip_element");
  if (!lossy)
    report.notes.push_back(
        {.code = "backbone.no_damping",
         .text =
             "no response is computed, because the drive loses no energy and each response would "
             "grow without bound",
         .path = "drivetrain",
         .equation = "MO-18",
         .severity = Severity::information,
         .next_step = "Give drivetrain.gear_damping, drivetrain.hysteresis or "
                      "drivetrain.slip_element."});
  if (excitations.empty() && lossy && gear.load.torque != 0)
    for (const double share : kExcitationsByDefault)
      excitations.push_back(share * std::abs(gear.load.torque) /
                            (settings.at == JointEnd::motor ? std::abs(sound.ratio) : 1.0));
  const double from = settings.from.value_or(kBelowResonances * lowest);
  const double to = settings.to.value_or(kAboveResonances * highest);
  if (settings.from)
    require(to > from, "--from", from, "Hz",
            fmt::format("below the end of the responses, {}; give --to too",
                        shown_quantity(to, "Hz", 4)));
  else
    require(to > from, "--to", to, "Hz",
            fmt::format("above the beginning of the responses, {}; give --from too",
                        shown_quantity(from, "Hz", 4)));
  const double curves = static_cast<double>(excitations.size() * (cracked ? 2 : 1));
  double done = 0.0;
  const auto follow = [&](const Joint& joint, DriveState drive, double excitation) {
    const double begin = 0.4 + 0.6 * done / curves;
    ++done;
    const ForcedResponse curve = forced_response(joint,
                                                 {.balance = balance,
                                                  .excited = settings.at,
                                                  .excitation = excitation,
                                                  .from = from,
                                                  .to = to},
                                                 progress.part(begin, 0.4 + 0.6 * done / curves));
    for (const ResponsePoint& at : curve.points)
      report.truncation = std::max(report.truncation, at.truncation);
    report.responses.push_back(response_of(curve, drive, excitation));
    if (curve.converged) return;
    report.notes.push_back(
        {.code = "backbone.response_not_finished",
         .text = fmt::format("the response of the {} drive to {} has no end: {}", enum_name(drive),
                             shown_quantity(excitation, "N*m", 4), curve.reason),
         .path = "drivetrain",
         .equation = "MO-18",
         .severity = Severity::critical,
         .next_step = "Choose a smaller --excitation, other frequencies with --from and --to, or "
                      "another number of --harmonics."});
  };
  for (const double excitation : excitations) {
    follow(sound, DriveState::sound, excitation);
    if (cracked) follow(made.joint, DriveState::cracked, excitation);
  }
  note_left_out(gear, report.notes);
  note_large_torque(gear, report);
  note_end_of_table(report);
  evaluate_standing_input(made.joint, report);
  if (report.truncation > kLargestTruncation)
    report.notes.push_back(
        {.code = "backbone.harmonics",
         .text = fmt::format("the last two harmonics have {} % of the energy of a vibration, so "
                             "harmonics that are left out may matter",
                             shown_number(100 * report.truncation, 2)),
         .path = "drivetrain",
         .equation = "MO-15",
         .severity = Severity::care,
         .next_step = "Give more --harmonics and compare."});
  report.equations = {"MO-1", "MO-5", "MO-14", "MO-15", "MO-16", "MO-17", "MO-18", "MO-19"};
  if (gear.drivetrain->hysteresis) report.equations.emplace_back("MO-8");
  if (!gear.drivetrain->slip_element.empty())
    for (const char* const tag : {"MO-44", "MO-47"}) report.equations.emplace_back(tag);
  if (report.table)
    for (const char* const tag : {"MO-25", "MO-26", "MO-27", "MO-28"})
      report.equations.emplace_back(tag);
  return report;
}

}  // namespace strainwave

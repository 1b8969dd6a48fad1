// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupled.hpp"
#include "strainwave/article/as_printed.hpp"
#include "strainwave/article/repaired.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/drive_turn/drive_turn.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/model/input/turn_table.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/crack_assessment.hpp"
#include "strainwave/strength/crack_reserves.hpp"
#include "strainwave/study/life_report.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

void use_equations(std::vector<std::string>& equations, const std::vector<std::string>& tags) {
  for (const std::string& tag : tags)
    if (std::ranges::find(equations, tag) == equations.end()) equations.push_back(tag);
}

/// K1, K2, K3 and the wind-up for one sense of torque, +1 or -1.
CurveStiffness lines_of(const AssembledDrive& drive, int sense, std::vector<Note>& notes) {
  const GearSet& gear = drive.gear();
  const double uncertainty = curve_uncertainty(gear);
  const MakersLines lines = makers_lines(drive, sense);
  const auto stiffness = [&](double K) { return Quantity{K, "N*m/rad", uncertainty}; };
  const auto angle = [&](double phi) { return Quantity{phi, "rad", uncertainty}; };
  CurveStiffness result{.K1 = stiffness(lines.K1),
                        .K2 = stiffness(lines.K2),
                        .K3 = stiffness(lines.K3),
                        .wind_up = {},
                        .wind_up_at_T1 = angle(lines.phi1),
                        .wind_up_at_T2 = angle(lines.phi2),
                        .wind_up_at_T3 = angle(lines.phi3)};
  if (const auto twist = reached_twist(drive, sense * std::abs(gear.load.torque), notes))
    result.wind_up = angle(std::abs(*twist));
  return result;
}

/// The relative change by the cracks.  It has no stated accuracy: the form of the model is the same
/// with and without cracks, and no reference tells how accurate the effect of a crack in the
/// contacts is.
Quantity change_of(const Quantity& cracked, const Quantity& sound) {
  return {sound.value == 0 ? 0.0 : cracked.value / sound.value - 1, "1"};
}

CrackedCurve cracked_lines_of(const AssembledDrive& drive, int sense, const CurveStiffness& sound,
                              std::vector<Note>& notes) {
  CrackedCurve curve{lines_of(drive, sense, notes), {}, {}};
  curve.change = {.K1 = change_of(curve.K1, sound.K1),
                  .K2 = change_of(curve.K2, sound.K2),
                  .K3 = change_of(curve.K3, sound.K3),
                  .wind_up = {}};
  if (curve.wind_up && sound.wind_up)
    curve.change.wind_up = change_of(*curve.wind_up, *sound.wind_up);
  return curve;
}

/// The stiffnesses over a turn, from those of the sound drive and their changes by the cracks.
CurveOverTurn over_turn_of(const CurveStiffness& sound, const ChangesOverTurn& turn) {
  const auto lines = [&](const LineChanges& changes) {
    const auto changed = [](Quantity K, double change) {
      K.value *= 1 + change;
      return K;
    };
    return LineStiffness{.K1 = changed(sound.K1, changes.K1),
                         .K2 = changed(sound.K2, changes.K2),
                         .K3 = changed(sound.K3, changes.K3)};
  };
  return {.mean = lines(turn.mean), .softest = lines(turn.worst)};
}

/// The cracks that turn relative to the lobes, with their angles in the file: "mesh.crack[0] at 5
/// degrees".
std::string angles_of_file(const GearSet& gear) {
  std::string angles;
  for_each_crack(gear, [&]<class Crack>(const std::string& path, const Crack& crack) {
    if constexpr (ContactCrack<Crack>)
      angles += fmt::format("{}{} at {:.4g} degrees", angles.empty() ? "" : ", ", path,
                            crack.position / units::deg);
  });
  return angles;
}

/// The changes of the stiffness that varies most over a turn, in words.
std::string range_of(const ChangesOverTurn& positive, const ChangesOverTurn& negative) {
  std::string text;
  double most = -1.0;
  const auto take = [&](const ChangesOverTurn& turn, std::string_view torque) {
    for (const auto& [name, line] :
         {std::pair{"K1", &LineChanges::K1}, {"K2", &LineChanges::K2}, {"K3", &LineChanges::K3}}) {
      if (turn.ripple.*line <= most) continue;
      most = turn.ripple.*line;
      text = fmt::format(
          "at this angle the cracks change {} under {} torque by {}; over a turn the change is {} "
          "to {}, and {} on average",
          name, torque, percent_change(turn.as_given.*line), percent_change(turn.worst.*line),
          percent_change(turn.best.*line), percent_change(turn.mean.*line));
    }
  };
  take(positive, "positive");
  take(negative, "negative");
  return text;
}

/// The note that a stiffness at one angle of a turn misleads, because a crack may even raise the
/// stiffness there.
/// @param unknown_because  why the turn is not solved; empty if it is, or if nobody asked for it
Note one_angle_note(const GearSet& gear, const TurnChanges* turn,
                    const std::string& unknown_because) {
  constexpr double kSeen = 1e-3;  // ripple that a designer may care about [-]
  Severity severity = Severity::care;
  std::string over_turn = "over a turn the effect of these cracks varies and may change its sign";
  std::string next_step =
      "Run strainwave stiffness for the mean and the softest values over a turn.";
  if (!unknown_because.empty()) {
    over_turn =
        "their effect over a turn is not known, because an angle of the turn has no "
        "solution: " +
        unknown_because;
    next_step = "Set other positions of these cracks for K1, K2, K3 at other angles.";
  } else if (turn != nullptr) {
    over_turn = range_of(turn->positive, turn->negative);
    next_step =
        "Design with the softest values over a turn, curve.positive.over_turn.softest and "
        "curve.negative.over_turn.softest; strainwave torsion --compare shows every angle.";
    double ripple = 0.0;
    for (const ChangesOverTurn* const sense : {&turn->positive, &turn->negative})
      ripple = std::max({ripple, sense->ripple.K1, sense->ripple.K2, sense->ripple.K3});
    if (ripple <= kSeen) severity = Severity::information;
  }
  return {.code = "curve.one_angle",
          .text = fmt::format("K1, K2, K3 and the wind-up are valid at one angle of the wave "
                              "generator, with {} from the lobe; {}",
                              angles_of_file(gear), over_turn),
          .path = {},
          .equation = "TC-26",
          .severity = severity,
          .next_step = next_step};
}

/// Adds the strength of the cracks to the stiffness, or a note that names the missing input.
void add_strength(StiffnessResult& result, const GearSet& gear) {
  std::vector<CrackStrength> strength = crack_strength(gear, result.cracks);
  if (strength.empty()) return;
  if (!strength_is_known(gear)) {
    result.notes.push_back(
        {.code = "strength.cannot_tell",
         .text = "crack strength not assessed: no material specifies fracture_toughness or "
                 "yield_strength",
         .path = "material",
         .equation = "FA-13",
         .severity = Severity::cannot_tell,
         .next_step = "Give fracture_toughness and yield_strength of the cracked materials."});
    return;
  }
  for (Note& note : strength_notes(strength)) result.notes.push_back(std::move(note));
  for (const CrackStrength& crack : strength) use_equations(result.equations, crack.equations);
  result.strength = std::move(strength);
}

/// Whether the flexspline is of one isotropic material.
bool is_of_one_metal(const GearSet& gear) {
  try {
    (void)only_material(gear, *gear.flexspline);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Adds the life over the duty; its notes stay with `strainwave life` and `strainwave grow`.
void add_life(StiffnessResult& result, const GearSet& gear) {
  if (!gear.duty || (gear.duty->history && !gear.duty_record)) return;
  if (gear.flexspline && !is_of_one_metal(gear)) {
    result.notes.push_back(
        {.code = "life.other_materials",
         .text = "the life over the duty is left out, because it is derived for a flexspline of "
                 "one isotropic material",
         .path = "flexspline",
         .equation = "LI-34",
         .severity = Severity::care,
         .next_step =
             "Ask strainwave laminate for the plies, and strainwave grow for the cracks."});
    return;
  }
  const LifeReport report = life_report(gear);
  result.life = life_result(report);
  use_equations(result.equations, report.equations);
  const std::size_t cracks = drive_cracks(gear).size();
  if (cracks == 0) return;
  std::optional<Quantity>& hours = result.life->hours;
  double known_until = 0.0;  // the time up to which no crack ends the life without being seen
  try {
    const GrowthReport growth = grow_cracks(gear);
    use_equations(result.equations, growth.equations);
    const bool all_known =
        growth.cracks.size() == cracks && std::ranges::none_of(growth.notes, [](const Note& note) {
          return note.severity == Severity::cannot_tell && note.code != "growth.range";
        });
    if (all_known)
      known_until =
          growth.end == DriveEnd::range ? growth.time : std::numeric_limits<double>::infinity();
    if (growth.life) {
      result.life->cracks = Quantity{*growth.life, "s"};
      if (!hours || hours->value > *growth.life) hours = result.life->cracks;
    }
  } catch (const Error&) {
    // A crack whose growth cannot be computed has no life that can be told; `strainwave grow` says
    // why.
  }
  if (hours && hours->value > known_until) hours.reset();
}

/// K_I over a turn of a crack without a table; absent if its kind or its drive is not modelled.
std::optional<DriveTurn> computed_turn(const GearSet& gear, const std::string& path) {
  try {
    return drive_turn(gear, {.crack = path, .torques = {gear.load.torque}});
  } catch (const Error&) {
    return std::nullopt;  // strainwave turn says why
  }
}

/// Adds K over a turn of the flexspline's cracks, from their tables or by the shell.
void add_turns(StiffnessResult& result, const GearSet& gear) {
  const double T = gear.load.torque;
  for_each_crack_with_turn(gear, [&](const std::string& path, const auto& crack) {
    const auto report = std::ranges::find(result.cracks, path, &CrackReport::path);
    if (report == result.cracks.end()) return;
    if (crack.turn_table) {
      const TurnTable& table = *gear.turn_tables.at(*crack.turn_table);
      if (!table.covers(T)) return;
      if constexpr (requires {
                      crack.depth;
                      crack.half_length;
                    })
        report->at_work = turn_range(table, crack.depth, crack.depth / crack.half_length, T);
      else if constexpr (requires { crack.depth; })
        report->at_work = turn_range(table, crack.depth, 1.0, T);
      else
        report->at_work = turn_range(table, crack.half_length, 1.0, T);
      use_equations(result.equations, {"GR-30", "GR-31"});
      return;
    }
    const std::optional<DriveTurn> turn = computed_turn(gear, path);
    if (!turn) return;
    report->at_work = turn->governing().mode_I;
    use_equations(result.equations, turn->equations);
    std::string assumptions;
    for (const Note& note : turn->notes) assumptions += "; " + note.text;
    result.notes.push_back(
        {.code = "turn.at_work",
         .text = fmt::format("over a turn of the wave generator this crack is open during {:.3g} % "
                             "of the turn at the place where K_I varies most; this K_I is that of "
                             "strainwave turn, and failure assessment and growth do not use it{}",
                             100 * report->at_work->open_share, assumptions),
         .path = path,
         .equation = "IN-2",
         .severity = Severity::information,
         .next_step = "Write its table by strainwave turn --format csv, and name the table as "
                      "turn_table."});
  });
}

}  // namespace

Coupled coupled_drive(const GearSet& gear, bool over_turn, const Progress& progress) {
  Coupled coupled;
  if (const std::string missing = missing_for_torsion_curve(gear); !missing.empty()) {
    coupled.notes.push_back({.code = "curve.missing",
                             .text = "the coupled drive is not solved; " + missing,
                             .path = "",
                             .equation = "TC-1",
                             .severity = Severity::information,
                             .next_step = "Give these fields; strainwave new --size SIZE --ratio "
                                          "RATIO writes a file with all of them."});
    return coupled;
  }
  try {
    const AssembledDrive drive(gear);
    std::vector<Note> notes = drive.notes();
    std::vector<std::string> equations = drive.equations();
    const AssembledDrive sound = drive.without_cracks();
    CurveResult curve{.torques = makers_torques(gear),
                      .intact = lines_of(sound, +1, notes),
                      .positive = {},
                      .negative = {}};
    const CurveStiffness sound_negative = lines_of(sound, -1, notes);
    curve.positive = cracked_lines_of(drive, +1, curve.intact, notes);
    curve.negative = cracked_lines_of(drive, -1, sound_negative, notes);
    if (has_moving_cracks(gear)) {
      std::optional<TurnChanges> turn;
      std::string unknown_because;
      if (over_turn) {
        try {
          turn = changes_over_turn(drive, 0, progress);
          curve.positive.over_turn = over_turn_of(curve.intact, turn->positive);
          curve.negative.over_turn = over_turn_of(sound_negative, turn->negative);
          equations.emplace_back("TC-26");
        } catch (const Error& error) {
          unknown_because = error.what();
        }
      }
      notes.insert(notes.begin(), one_angle_note(gear, turn ? &*turn : nullptr, unknown_because));
    }
    coupled = {drive, curve, std::move(notes), std::move(equations)};
  } catch (const Error& error) {
    coupled.notes = {
        {.code = "curve.none",
         .text = fmt::format("no torsion curve of the coupled drive: {}", error.what()),
         .path = "",
         .equation = "TC-11",
         .severity = Severity::care}};
  }
  return coupled;
}

bool is_of_coupled_drive(std::string_view output) { return output.starts_with("curve."); }
bool is_of_life(std::string_view output) { return output.starts_with("life."); }
bool is_over_turn(std::string_view output) {
  return output.find(".over_turn.") != std::string_view::npos;
}

StiffnessResult evaluate(const GearSet& gear, Method method, const EvaluationOptions& options,
                         const Progress& progress) {
  switch (method) {
    case Method::as_printed:
      return torsional_stiffness_as_printed(gear);
    case Method::repaired:
      return torsional_stiffness_repaired(gear);
    case Method::corrected:
      break;
  }
  assert(method == Method::corrected);
  check(gear);
  Coupled coupled =
      options.coupled_drive ? coupled_drive(gear, options.over_turn, progress) : Coupled{};
  StiffnessResult result =
      stiffness_of_checked(gear, {.coupled = coupled.curve ? &*coupled.curve : nullptr});
  result.curve = coupled.curve;
  // Put the notes that limit the answer first.
  for (Note& note : result.notes)
    if (std::ranges::find(coupled.notes, note) == coupled.notes.end())
      coupled.notes.push_back(std::move(note));
  result.notes = std::move(coupled.notes);
  use_equations(result.equations, coupled.equations);
  add_strength(result, gear);
  if (options.over_turn) add_turns(result, gear);
  if (options.life) add_life(result, gear);
  return result;
}

}  // namespace strainwave

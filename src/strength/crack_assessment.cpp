// SPDX-License-Identifier: Apache-2.0
#include "strainwave/strength/crack_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessed_crack.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/crack_reserves.hpp"

namespace strainwave {
namespace {

const StrengthNote kResidual = {
    "residual stress (hardening, peening, press fits) is not known and left out; the line is for "
    "steels that yield continuously",
    "FA-1"};
const StrengthNote kLineEnds = {
    "the material gives no ultimate_strength, so the line ends at L_r = 1, on the safe side",
    "FA-2"};

/// The answer for a crack whose stress is not computed.
CrackStrength acts_in_coupled_drive(CrackStrength report) {
  report.sentence =
      "cannot tell, because the crack acts in the coupled drive only, where its stress is not "
      "computed";
  report.next_step =
      "Assess the crack by finite elements, because no field of the file makes an assessment "
      "possible.";
  report.equations = {"FA-13"};
  return report;
}

/// The answer for a crack whose K over a turn is not known at the given torque.
CrackStrength beyond_turn_table(CrackStrength report, const TurnTable& table, double torque) {
  report.sentence = fmt::format(
      "cannot tell, because the table {} covers torques from {} to {}, but the load is {}",
      shown(table.file), shown_quantity(table.torques.front(), "N*m", 9),
      shown_quantity(table.torques.back(), "N*m", 9), shown_quantity(torque, "N*m", 9));
  report.next_step = "Compute K over the turn at this torque too, and add it to the table.";
  report.equations = {"FA-13", "GR-30"};
  return report;
}

/// Notes that a table of K over a turn lacks the other sense of torque.
void note_one_sense(CrackStrength& report, const TurnTable& table, double torque) {
  if (!table.covers(-torque))
    report.notes.push_back(
        {fmt::format("the table {} has no torque of the other sense, so the other "
                     "sense is not assessed",
                     shown(table.file)),
         "GR-30"});
}

/// The torque of a state, with the magnitude of the load [N*m].
double torque_of(const StrengthState& state, double torque) {
  return state.sense == TorqueSense::positive ? std::abs(torque) : -std::abs(torque);
}

/// Notes on where the table of K over a turn ends an answer.
void note_ends_of_table(CrackStrength& report, const TurnTable& table, double torque) {
  note_one_sense(report, table, torque);
  if (!table.covers(0))
    report.notes.push_back(
        {fmt::format("the table {} does not have torque 0, so all of its K counts "
                     "as that of the load",
                     shown(table.file)),
         "GR-30"});
  for (const StrengthState& state : report.states) {
    if (!state.with_assembly || !state.reserve) continue;
    const auto [least, most] = turn_load_range(table, torque_of(state, torque));
    const char* const sense = state.sense == TorqueSense::positive ? "T > 0" : "T < 0";
    // With a table of one torque both ends are this torque.
    const bool beyond =
        state.verdict == StrengthVerdict::fractures || state.verdict == StrengthVerdict::collapses;
    if (!beyond && !clearly_less(*state.reserve, most))
      report.notes.push_back({fmt::format("under {} the table {} ends at {:.3g} times the load, so "
                                          "the reserve of this sense is at least this",
                                          sense, shown(table.file), most),
                              "GR-30"});
    else if (least > 0 && !clearly_less(least, *state.reserve))
      report.notes.push_back({fmt::format("under {} the table {} begins at {:.3g} times the load, "
                                          "so the reserve of this sense is at most this",
                                          sense, shown(table.file), least),
                              "GR-30"});
  }
}

/// The answer for an axial crack of the rim with its table of K over a turn: K against the
/// toughness. The stress of the net section is not known.
CrackStrength rim_with_table(const GearSet& gear, const DriveCrack& crack, CrackStrength report) {
  const TurnTable& table = *crack.turn_table;
  const Material& material = material_of(gear, crack.material, crack.path + ".material");
  const ElasticConstants steel = elastic_constants(material);
  for_each_crack_with_turn(gear, [&](const std::string& path, const auto& of) {
    if constexpr (requires { of.depth; })
      if (path == crack.path) report.size = of.depth;
  });
  report.size_name = "depth";
  report.ligament = gear.flexspline->rim->wall_thickness - report.size;
  report.toughness = material.fracture_toughness;
  report.equations = {"FA-13", "FR-1", "FR-20", "GR-30"};
  report.notes = {kResidual};
  const TurnFactors factors(table, report.size, 1.0);
  // The drive may reverse, so the worst K under either sense that the table covers counts.
  for (const double torque : {gear.load.torque, -gear.load.torque}) {
    if (!table.covers(torque)) continue;
    StrengthState& state = report.states.emplace_back(StrengthState{
        .sense = torque > 0 ? TorqueSense::positive : TorqueSense::negative,
        .with_assembly = true,
        .unknown = "the stress of the rim's net section is not known",
        .next_step =
            "Compare K with the toughness, and assess the net section by finite elements."});
    for (std::size_t i = 0; i < factors.stations(); ++i)
      for (const Modes& K : factors.at(i, torque))
        state.K = std::max(state.K,
                           std::sqrt(steel.plane_strain_modulus() *
                                     energy_release_rate(std::max(K[0], 0.0), K[1], K[2],
                                                         {steel.plane_strain_modulus(), steel.G})));
    if (material.fracture_toughness) state.utilisation = state.K / *material.fracture_toughness;
    if (state.utilisation && *state.utilisation >= 1) {
      state.verdict = StrengthVerdict::fractures;
      state.unknown.clear();
      state.next_step.clear();
    }
  }
  note_one_sense(report, table, gear.load.torque);
  report.governing = static_cast<std::size_t>(
      std::ranges::max_element(report.states, {}, &StrengthState::K) - report.states.begin());
  const StrengthState& state = report.states[report.governing];
  const char* const sense = report.governing == 0 ? "" : " under the other sense of the torque";
  report.sentence = "cannot tell: the stress of the rim's net section is not known";
  const std::string shown_K = shown_quantity(state.K, "Pa*m^0.5", 3);
  if (state.verdict == StrengthVerdict::fractures)
    report.sentence = fmt::format(
        "fractures at this load{} together with the assembly's bending: K = {} reaches K_Ic", sense,
        shown_K);
  else if (state.utilisation)
    report.sentence += fmt::format("; K/K_Ic = {:.3g}{}", *state.utilisation, sense);
  else
    report.sentence += "; K = " + shown_K + sense;
  report.verdict = state.verdict;
  report.next_step = state.next_step;
  return report;
}

/// The answer for a crack whose group has none.
CrackStrength in_unknown_group(CrackStrength report, const std::string& fault) {
  report.sentence = "cannot tell, because " + fault;
  report.next_step = "Place the cracks farther apart, or assess them by finite elements.";
  report.equations = {"FA-13", "CG-9"};
  return report;
}

/// Ends the range of a crack where its group is not known any more, with the others at their
/// present sizes.
void end_in_group(DriveCrack& crack) {
  WallGroup group = *crack.group;
  const double present = crack.size.size;
  const auto shorten = [&](int halvings, const char* text, const auto& known) {
    // What is known may end in the middle of the range and begin again, so some sizes are asked
    // one after the other.
    constexpr int kSizes = 8;
    double inside = present;
    const double end = crack.range_end;
    bool all = true;
    for (int i = 1; i <= kSizes && all; ++i) {
      const double size = present + (end - present) * i / kSizes;
      if (known(size)) {
        inside = size;
      } else {
        crack.range_end = size;
        all = false;
      }
    }
    if (all) return;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (inside + crack.range_end) / 2;
      (known(middle) ? inside : crack.range_end) = middle;
    }
    crack.range_end = inside;
    crack.range_text = text;
  };
  // A narrower ligament may collapse (CG-9).
  const auto wide = [&](double half_length) {
    group.set_half_length(crack.in_group, half_length);
    std::vector<StraightCrack> places;
    for (const WallGroup::Member& member : group.members()) places.push_back(member.place);
    return nearest_crack(places, crack.in_group, group.wall().round).gap >= 1;
  };
  if (wide(present))
    shorten(
        40,
        "where the ligament to the next crack becomes narrower than the longer half length, whose "
        "collapse is not assessed",
        wide);
  const char* const kEndOfGroup = "the end of what is known of the cracks' influence on each other";
  shorten(40, kEndOfGroup, [&](double half_length) {
    group.set_half_length(crack.in_group, half_length);
    return group.fault_of_places().empty();
  });
  shorten(16, kEndOfGroup, [&](double half_length) {
    group.set_half_length(crack.in_group, half_length);
    return group.fault().empty();
  });
}

/// A surface crack of a row is assessed with its shape, so the end of its length ends its depth.
void end_in_row(DriveCrack& crack) {
  const double end = crack.length_end * crack.size.aspect_ratio;
  if (crack.count == 1 || end >= crack.range_end) return;
  crack.range_end = end;
  crack.range_text = "where the surface cracks of the row influence each other too much";
}

/// What an assessment computes beside verdicts and reserves.
struct Asked {
  bool sizes = true;  ///< critical sizes
  bool words = true;  ///< sentences, notes and equations
};

/// Adds what a verdict leaves out, and the equations that it uses.
void add_scope(CrackStrength& report, const DriveCrack& crack, const Material& material) {
  report.notes.push_back(kResidual);
  if (material.yield_strength && !material.ultimate_strength) report.notes.push_back(kLineEnds);
  report.notes.insert(report.notes.end(), crack.notes.begin(), crack.notes.end());
  report.equations = {"FA-1", "FA-2", "FA-4", "FA-5", "FA-13"};
  report.equations.insert(report.equations.end(), crack.equations.begin(), crack.equations.end());
  if (crack.assembly) report.equations.emplace_back("FA-3");
  if (material.fracture_toughness) report.equations.emplace_back("FR-20");
  if (material.yield_strength) report.equations.emplace_back("FR-19");
}

CrackStrength strength_of(const GearSet& gear, const DriveCrack& crack,
                          std::span<const CrackReport> reports, const Asked& what) {
  CrackStrength report{.path = crack.path, .kind = crack.kind, .material = crack.material};
  if (crack.turn_table && !crack.turn_table->covers(gear.load.torque))
    return beyond_turn_table(std::move(report), *crack.turn_table, gear.load.torque);
  if (crack.acts_in_coupled_drive)
    return crack.turn_table ? rim_with_table(gear, crack, std::move(report))
                            : acts_in_coupled_drive(std::move(report));
  if (crack.group)
    if (const std::string fault = crack.group->fault(); !fault.empty())
      return in_unknown_group(std::move(report), fault);
  const Material& material = material_of(gear, crack.material, crack.path + ".material");
  report.size_name = crack.size_name;
  report.size = crack.size.size;
  report.ligament = crack.ligament;
  if (what.words) add_scope(report, crack, material);
  const auto of_path = std::ranges::find(reports, crack.path, &CrackReport::path);
  report =
      assess({.crack = crack,
              .material = material,
              .load = gear.load,
              .relative_uncertainty = of_path == reports.end() ? std::optional<double>()
                                                               : of_path->intensity_uncertainty,
              .with_sizes = what.sizes,
              .with_words = what.words},
             std::move(report));
  if (!what.words) return report;
  if (crack.turn_table) note_ends_of_table(report, *crack.turn_table, gear.load.torque);
  if (report.breaks())
    report.next_step =
        (crack.upper_bound.empty()
             ? "Lower"
             : fmt::format("Assess the crack by finite elements of the part, because its stress, "
                           "{}, is an upper bound; otherwise lower",
                           crack.upper_bound)) +
        " the load or replace the part; the stiffness holds for the present size of the crack.";
  return report;
}

/// Note that the plastic zone is not small, at the given load alone.
void note_plastic_zone(std::vector<Note>& notes, const CrackStrength& crack) {
  if (crack.states.empty() || !crack.states.front().plastic_zone) return;
  const double length = std::min(crack.size, crack.ligament.value_or(crack.size));
  if (*crack.states.front().plastic_zone <= kSmallScaleYielding * length) return;
  notes.push_back({.code = "crack.plastic_zone",
                   .text = "the plastic zone is larger than a tenth of the crack or of the "
                           "remaining section, so linear elasticity is no longer accurate",
                   .path = crack.path,
                   .equation = "FR-19",
                   .severity = Severity::care});
}

std::vector<CrackStrength> strengths(const GearSet& gear, std::span<const CrackReport> reports,
                                     const Asked& what) {
  std::vector<CrackStrength> result;
  for (DriveCrack& crack : drive_cracks(gear)) {
    end_in_row(crack);
    if (what.sizes && crack.group && crack.size.size < crack.range_end &&
        crack.group->fault().empty())
      end_in_group(crack);
    result.push_back(strength_of(gear, crack, reports, what));
  }
  return result;
}

}  // namespace

std::vector<CrackStrength> crack_strength(const GearSet& gear,
                                          std::span<const CrackReport> reports) {
  check(gear);
  return strengths(gear, reports, {});
}

std::vector<CrackStrength> crack_reserves(const GearSet& gear) {
  check(gear);
  return strengths(gear, {}, {.sizes = false});
}

std::vector<CrackStrength> crack_margins(const GearSet& gear) {
  return strengths(gear, {}, {.sizes = false, .words = false});
}

bool strength_is_known(const GearSet& gear) {
  return std::ranges::any_of(gear.material, [](const auto& named) {
    return named.second.fracture_toughness || named.second.yield_strength ||
           named.second.fracture_energy;
  });
}

BreakingCracks::BreakingCracks() = default;
BreakingCracks::~BreakingCracks() = default;

std::optional<std::string> BreakingCracks::first(
    const GearSet& gear, const std::function<bool(const std::string& path)>& counts) {
  std::vector<DriveCrack> cracks = drive_cracks(gear);
  fronts_.resize(cracks.size());
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    DriveCrack& crack = cracks[i];
    if (!counts(crack.path)) continue;
    end_in_row(crack);
    // These few kinds are assessed in another way, or are not assessed.
    if (crack.acts_in_coupled_drive || crack.turn_table) {
      if (strength_of(gear, crack, {}, {.sizes = false, .words = false}).breaks())
        return crack.path;
      continue;
    }
    if (crack.group && !crack.group->fault().empty()) continue;
    // K of these cracks depends on more than its size and the state of its own faces.
    FrontsAtSize of_this_load;
    const bool of_size_alone =
        !crack.group && crack.reverses && crack.turning != TurningLoad::balls;
    FrontsAtSize& fronts = of_size_alone ? fronts_[i] : of_this_load;
    if (breaks({.crack = crack,
                .material = material_of(gear, crack.material, crack.path + ".material"),
                .load = gear.load,
                .relative_uncertainty = {},
                .with_sizes = false,
                .fronts = &fronts}))
      return crack.path;
  }
  return std::nullopt;
}

std::vector<CrackStrength> crack_strength(const GearSet& gear) {
  const StiffnessResult result = torsional_stiffness(gear);
  return crack_strength(gear, result.cracks);
}

std::vector<Note> strength_notes(std::span<const CrackStrength> cracks) {
  std::vector<Note> notes;
  for (const CrackStrength& crack : cracks) {
    if (crack.breaks())
      notes.push_back({.code = "strength.breaks",
                       .text = crack.sentence,
                       .path = crack.path,
                       .equation = "FA-13",
                       .severity = Severity::critical,
                       .next_step = crack.next_step});
    else if (crack.verdict == StrengthVerdict::cannot_tell)
      notes.push_back({.code = "strength.cannot_tell",
                       .text = crack.sentence,
                       .path = crack.path,
                       .equation = "FA-13",
                       .severity = Severity::cannot_tell,
                       .next_step = crack.next_step});
    note_plastic_zone(notes, crack);
    for (const StrengthNote& scope : crack.notes) {
      const auto same = std::ranges::find_if(notes, [&](const Note& note) {
        return note.code == "strength.scope" && note.text == scope.text;
      });
      if (same == notes.end())
        notes.push_back({.code = "strength.scope",
                         .text = scope.text,
                         .path = crack.path,
                         .equation = scope.equation,
                         .severity = Severity::care});
      else
        same->path += ", " + crack.path;
    }
  }
  return notes;
}

}  // namespace strainwave

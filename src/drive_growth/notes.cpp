// SPDX-License-Identifier: Apache-2.0
#include "notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/life/block_temperature.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

std::string hours(double seconds) { return fmt::format("{:.4g} h", seconds / 3600); }

/// "after 20 h"; a crack that ends the life at its size in the file does so in the first cycles.
std::string after(double seconds) {
  return seconds > 0 ? "after " + hours(seconds) : "in the first cycles";
}

/// The record of the library that gives the law; null if the file gives it.
const MaterialRecord* record_of(const GearSet& gear, const GrowingCrack& crack,
                                const RateChoice& choice) {
  if (!choice.law.empty()) return &require_material(choice.law);
  const std::string& name = crack.crack().material;
  const Material& material = gear.material.at(name);
  if (std::ranges::find(material.from_library, "growth") == material.from_library.end())
    return nullptr;
  return &require_material(material.based_on.value_or(name));
}

Confidence confidence_of(const MaterialRecord& record) {
  return std::visit([](const Evidence& evidence) { return evidence.confidence; },
                    record.growth.front());
}

std::string origin_of(const GearSet& gear, const GrowingCrack& crack, const RateChoice& choice) {
  const MaterialRecord* const record = record_of(gear, crack, choice);
  if (record == nullptr) return fmt::format("material {} of the file", crack.crack().material);
  std::string origin = fmt::format("record {} of the material library ({})", record->name,
                                   enum_name(confidence_of(*record)));
  if (!choice.law.empty()) origin += fmt::format(", chosen in place of {}", crack.crack().material);
  return origin;
}

/// Where the cycles of a crack leave the range for which constants are stated; empty: nowhere.
std::string beyond_bounds(const CrackGrowth& crack, const RatioRange& R,
                          const GrowthBounds& bounds) {
  const auto ends = std::ranges::minmax(crack.series, {}, &GrowthPoint::delta_K);
  std::string outside;
  if (bounds.stress_ratio &&
      (R.least < (*bounds.stress_ratio)[0] || R.most > (*bounds.stress_ratio)[1]))
    outside = fmt::format("R is {:.3g} to {:.3g}, and the law is stated for {:.3g} to {:.3g}",
                          R.least, R.most, (*bounds.stress_ratio)[0], (*bounds.stress_ratio)[1]);
  if ((bounds.from && ends.min.delta_K < *bounds.from) ||
      (bounds.to && ends.max.delta_K > *bounds.to)) {
    if (!outside.empty()) outside += "; ";
    outside += fmt::format("Delta K is {:.3g} to {:.3g} MPa*m^0.5, beyond the range of the law",
                           ends.min.delta_K / units::MPa, ends.max.delta_K / units::MPa);
  }
  return outside;
}

/// Where the cycles of a crack leave the curves of a table; empty: nowhere.
std::string beyond_table(const CrackGrowth& crack, const RatioRange& R, const Tabulated& law) {
  std::string outside;
  if (R.least < law.curve.front().stress_ratio || R.most > law.curve.back().stress_ratio)
    outside = fmt::format(
        "R is {:.3g} to {:.3g}, and the table has curves for {:.3g} to {:.3g}; outside of them the "
        "nearest curve holds{}",
        R.least, R.most, law.curve.front().stress_ratio, law.curve.back().stress_ratio,
        R.most > law.curve.back().stress_ratio
            ? ", which is on the unsafe side for cycles of a larger R"
            : "");
  const TableOfRates table = law.prepared();
  const auto beyond = std::ranges::find_if(crack.series, [&](const GrowthPoint& point) {
    return point.delta_K > table.last(point.ratio) * (1 + 1e-12);
  });
  if (beyond != crack.series.end()) {
    if (!outside.empty()) outside += "; ";
    outside += fmt::format(
        "Delta K reaches {:.3g} MPa*m^0.5, and the last point of the table is at {:.3g} MPa*m^0.5; "
        "the line of the last two points goes on",
        std::ranges::max(crack.series, {}, &GrowthPoint::delta_K).delta_K / units::MPa,
        table.last(beyond->ratio) / units::MPa);
  }
  return outside;
}

/// Notes on the ranges for which the constants of a crack are stated.
void note_range(GrowthReport& report, const CrackGrowth& crack, const RatioRange& R,
                const RateLaw* law, const std::optional<GrowthBounds>& bounds) {
  if (crack.series.empty() || !crack.grows) return;
  const auto add = [&](const std::string& outside, std::string_view equation) {
    if (!outside.empty())
      report.notes.push_back(
          {.code = "growth.law_range",
           .text = outside,
           .path = crack.path,
           .equation = std::string(equation),
           .severity = Severity::care,
           .next_step = "Use constants that are stated for these cycles, or compare with another "
                        "law by --law."});
  };
  if (bounds) add(beyond_bounds(crack, R, *bounds), "GR-2");
  if (law != nullptr)
    if (const auto* const table = std::get_if<Tabulated>(law))
      add(beyond_table(crack, R, *table), "GR-36");
}

/// Notes on what the constants of the cracks are stated for.
void note_validity(GrowthReport& report, const GearSet& gear, const RateChoice& choice,
                   std::span<const RatioRange> ratios) {
  std::vector<std::string> told;
  for (std::size_t k = 0; k < report.cracks.size(); ++k) {
    const CrackGrowth& crack = report.cracks[k];
    std::optional<GrowthBounds> bounds;
    const RateLaw* law = nullptr;
    std::string of = choice.law;
    for (const DriveCrack& in_drive : drive_cracks(gear))
      if (in_drive.path == crack.path && choice_of(in_drive, choice).law.empty())
        of = in_drive.material;
    if (of == choice.law) {
      bounds = growth_bounds(require_material(choice.law));
    } else {
      const Material& material = gear.material.at(of);
      bounds = material.growth_bounds;
      if (!material.growth.empty()) law = &material.growth.front();
    }
    note_range(report, crack, ratios[k], law, bounds);
    if (std::ranges::find(told, of) != told.end()) continue;
    told.push_back(of);
    if (const auto unstated = unstated_temperature(
            *gear.duty, fmt::format("the constants of crack growth, {},", crack.constants),
            bounds ? bounds->temperature : std::nullopt))
      report.notes.push_back({.code = "growth.temperature",
                              .text = unstated->text,
                              .path = unstated->path,
                              .equation = "",
                              .severity = Severity::care,
                              .next_step =
                                  "Give constants that hold at this temperature, and state their "
                                  "temperatures in growth_bounds.temperature."});
  }
}

/// Notes on the table that gives K over a turn.
void note_turn_table(std::vector<Note>& notes, const GrowingCrack& crack) {
  const DriveCrack& of = crack.crack();
  const TurnTable& table = *of.turn_table;
  const double missed = crack.missed_by_angles();
  constexpr double kMuch = 0.01;
  notes.push_back(
      {.code = "growth.turn_table",
       .text =
           fmt::format("K over the turn is that of the table {}; its {} angles miss about {:.2g} % "
                       "of the widest range",
                       shown(table.file), table.angles.size() - 1, 100 * missed),
       .path = of.path,
       .equation = "GR-31",
       .severity = missed > kMuch ? Severity::care : Severity::information,
       .next_step = missed > kMuch ? "Give more angles near the largest and the least K." : ""});
  if (of.group)
    notes.push_back({.code = "growth.turn_table",
                     .text = fmt::format("the table {} leaves out the other cracks of the {}",
                                         shown(table.file), of.group->wall().name),
                     .path = of.path,
                     .equation = "CG-9",
                     .severity = Severity::care,
                     .next_step = "Leave out turn_table to grow the cracks with their influence on "
                                  "each other."});
  std::string held;
  if (table.sizes.size() == 1)
    held = fmt::format("has one size, {}, so K/sqrt(pi a) counts as constant",
                       shown_quantity(table.sizes.front(), "m", 3, table.size_name));
  if (of.kind == WallSurfaceCrack::kKind && table.aspect_ratios.empty())
    held += fmt::format(
        "{}has no aspect_ratio, so the crack keeps its shape and grows by its worst "
        "point",
        held.empty() ? "" : ", and ");
  if (!held.empty())
    notes.push_back({.code = "growth.turn_table_held",
                     .text = fmt::format("the table {} {}", shown(table.file), held),
                     .path = of.path,
                     .equation = "GR-30",
                     .severity = Severity::care,
                     .next_step = table.sizes.size() == 1 ? "Give the table more sizes."
                                                          : "Give the table aspect ratios."});
}

}  // namespace

Note through_wall_note(const std::string& path) {
  return {.code = "growth.upper_bound",
          .text =
              "behind the wall there is no table of K over a turn, so the range of K from the "
              "wave is an upper bound from there on",
          .path = path,
          .equation = "FA-12",
          .severity = Severity::care};
}

Note coupled_crack_note(const std::string& path, const std::string& why, const char* next_step) {
  return {.code = "growth.coupled",
          .text = fmt::format("the stress intensity of this crack is not known, so its growth is "
                              "not computed: {}",
                              why),
          .path = path,
          .equation = "GR-33",
          .severity = Severity::cannot_tell,
          .next_step = next_step};
}

Note not_amplified_note(const std::string& path) {
  return {.code = "growth.not_amplified",
          .text =
              "the amplification by duty.resonance does not reach this crack, because its stress "
              "is not proportional to the torque",
          .path = path,
          .equation = "GR-28",
          .severity = Severity::cannot_tell,
          .next_step =
              "Give the torques with their vibration in the duty, and leave out "
              "duty.resonance."};
}

Note tooth_crack_note(const std::string& path) {
  return {.code = "growth.no_size",
          .text = "a crack of a tooth has a loss of stiffness and no size, so it cannot grow",
          .path = path,
          .equation = "TC-21",
          .severity = Severity::cannot_tell,
          .next_step = "Give a crack of the rim from the root in its place, kind = \"rim_axial\"."};
}

Note unknown_balls_note(const std::string& path) {
  return {.code = "growth.unknown_balls",
          .text = "the number of balls that pass is not known, so the growth is not computed",
          .path = path,
          .equation = "GR-21",
          .severity = Severity::cannot_tell,
          .next_step = "Give wave_generator.bearing with its ball_count."};
}

Note laminate_crack_note(const std::string& path) {
  return {.code = "growth.laminate",
          .text =
              "the crack is in a laminate that states no law of growth, so the crack keeps its "
              "size",
          .path = path,
          .equation = "LA-15",
          .severity = Severity::cannot_tell,
          .next_step = "Give growth and reference_modulus of the laminate in the file."};
}

Note refused_size_note(const std::string& path, const std::string& rule) {
  return {.code = "growth.refused_size",
          .text = fmt::format("the growth ends where a larger crack breaks a rule: {}", rule),
          .path = path,
          .equation = "GR-24",
          .severity = Severity::care,
          .next_step = "If two cracks meet, replace them by one crack and grow it."};
}

Note group_note(const WallGroup& at_begin, const WallGroup& at_end) {
  double left_out = 0.0;
  const auto words = [&](const WallGroup& group) {
    if (const std::string fault = group.fault_of_places(); !fault.empty())
      return std::string("not known");
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const GroupEffect& effect : group.apart()) {
      least = std::min(least, effect.intensity);
      most = std::max(most, effect.intensity);
      left_out = std::max(left_out, group.uncertainty() * effect.changed_intensity);
    }
    return fmt::format("{:.3f} to {:.3f}", least, most);
  };
  const std::string begin = words(at_begin);
  const std::string end = words(at_end);
  constexpr double kSmall = 0.05;
  return {
      .code = "growth.group",
      .text = fmt::format(
          "the {} through cracks of the {} influence each other, as in a flat sheet with all "
          "faces apart: K of the given load is {} times that of a crack alone at the beginning, "
          "and {} times at the end; the curvature between the cracks may change K by {:.2g} "
          "%; each crack keeps its middle and grows at both tips by the larger K",
          at_end.members().size(), at_end.wall().name, begin, end, 100 * left_out),
      .path = "flexspline.crack",
      .equation = "CG-9",
      .severity = left_out > kSmall ? Severity::care : Severity::information};
}

Note merger_note(const std::string& first, const std::string& second,
                 const WallThroughCrack& merged, std::optional<double> change) {
  return {
      .code = "growth.merges",
      .text = fmt::format(
          "{} and {} lie in one line, and the gap between them is at most {:g} of the longer "
          "half length: they count as one crack from here on, from outer tip to outer tip, "
          "which lets the ligament break at once; at stresses above 0.3 of the yield strength the "
          "ligament yields before; the one crack has half_length = \"{:.6g} mm\", "
          "angle = \"{:.6g} deg\", distance = \"{:.6g} mm\" and position = \"{:.6g} deg\", "
          "{}",
          first, second, kLeastGroupGap, merged.half_length / units::mm, merged.angle / units::deg,
          *merged.distance / units::mm, *merged.position / units::deg,
          change ? fmt::format("and changes the stiffness under the softer sense by {:.3g} %",
                               100 * *change)
                 : std::string("whose stiffness is not known, because another crack is near")),
      .path = first,
      .equation = "CG-14",
      .severity = Severity::care,
      .next_step =
          "Replace both by this crack, assess it and grow it; the life is the time up to here and "
          "that of the one crack."};
}

Note superposed_note(const std::string& member) {
  return {.code = "growth.superposed",
          .text =
              "K of the cracks of this member leaves out the influence of all cracks that no "
              "other note names as a group: cracks without a place, part-through cracks, cracks "
              "of a laminate, and cracks of another section; cracks in one line near each other "
              "grow faster",
          .path = member,
          .equation = "CG-9",
          .severity = Severity::care,
          .next_step = "Give through cracks of a wall a position, or annular cracks a distance."};
}

Note shielding_note(const ShaftGroup& at_begin, const ShaftGroup& at_end) {
  const auto words = [](const ShaftGroup& group) {
    if (!group.fault().empty() || group.stretched()) return std::string("1");
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const GroupedAnnularCrack& crack : group.solved().cracks) {
      least = std::min(least, crack.factor);
      most = std::max(most, crack.factor);
    }
    return fmt::format("{:.3f} to {:.3f}", least, most);
  };
  return {.code = "growth.shielding",
          .text = fmt::format(
              "the {} annular cracks of the output shaft shield each other in torsion: K_III is {} "
              "times that of a crack alone at the beginning, and {} times at the end; K_I of axial "
              "forces and bending moments is that of a crack alone; the deeper of two cracks soon "
              "grows nearly as alone, so a neighbour that is a little shallower than given, or "
              "whose faces stick by friction, may halve the life",
              at_end.cracks.size(), words(at_begin), words(at_end)),
          .path = "output_shaft.crack",
          .equation = "CG-12",
          .severity = Severity::care,
          .next_step = "Leave out the distances for a lower bound of the life."};
}

Note no_curve_note(const std::string& why) {
  return {.code = "growth.no_curve",
          .text = "the coupled drive has no solution with the grown cracks: " + why,
          .path = "",
          .equation = "TC-11",
          .severity = Severity::care,
          .next_step = "Read the stiffness of the sum of the members, or stop the growth earlier."};
}

std::vector<Note> crack_notes(const GearSet& gear, const GrowingCrack& crack,
                              const RateChoice& choice) {
  std::vector<Note> notes;
  const DriveCrack& of = crack.crack();
  if (!of.unknown.empty())
    notes.push_back({.code = "growth.unknown_stress",
                     .text = "the growth leaves out what is not known of the crack: " + of.unknown,
                     .path = of.path,
                     .equation = "GR-22",
                     .severity = Severity::cannot_tell,
                     .next_step = of.next_step});
  const auto material = gear.material.find(std::string(solid_name(gear, of.material)));
  if (material != gear.material.end() && material->second.growth_scatter)
    notes.push_back(
        {.code = "growth.median",
         .text = "the crack grows at the median rate of its law, without the scatter of growth "
                 "that the file gives",
         .path = of.path,
         .equation = "GS-12",
         .severity = Severity::information,
         .next_step = "Run strainwave inspect, which draws lives with this scatter."});
  if (of.turn_table)
    note_turn_table(notes, crack);
  else if (of.assembly)
    notes.push_back({.code = "growth.upper_bound",
                     .text =
                         "the range of K from the wave is an upper bound, with open faces and the "
                         "stress of the outer fibre; the true crack grows more slowly or not at "
                         "all",
                     .path = of.path,
                     .equation = "FA-12",
                     .severity = Severity::care});
  const MaterialRecord* const record = record_of(gear, crack, choice);
  if (record == nullptr || confidence_of(*record) != Confidence::unverified) return notes;
  std::string text =
      fmt::format("the constants of its law, those of {}, are unverified", record->name);
  const auto* const law = std::get_if<Nasgro>(&crack.law());
  double least = 0.0;  // smallest R of the duty
  for (const std::vector<TipLoad>& at_tip : crack.loads(crack.crack().size))
    for (const TipLoad& load : at_tip)
      if (load.cycle.largest > 0) least = std::min(least, load.cycle.ratio);
  if (law != nullptr && least < 0) {
    Nasgro other = *law;
    other.slope_minus = -other.slope_minus;
    const double a = crack.crack().size.size;
    text += fmt::format(
        "; with the other sign of C_th for R < 0, the threshold at R = {:.3g} is {:.4g} in place "
        "of "
        "{:.4g} MPa*m^0.5",
        least, other.threshold(least, a) / units::MPa, law->threshold(least, a) / units::MPa);
  }
  notes.push_back({.code = "growth.unverified",
                   .text = text,
                   .path = of.path,
                   .equation = "GR-10",
                   .severity = Severity::care,
                   .next_step = "Compare with another law by --law, or give constants of a test."});
  return notes;
}

CrackGrowth described_crack(const GearSet& gear, const GrowingCrack& crack,
                            const RateChoice& choice, double amplification) {
  CrackGrowth told{.path = crack.crack().path, .kind = crack.crack().kind};
  told.law = std::visit([](const auto& l) { return std::string(l.kKind); }, crack.law());
  told.constants = origin_of(gear, crack, choice);
  const CrackDuty& duty = crack.duty();
  told.cycles_per_hour = duty.duration > 0 ? duty.cycles() / duty.duration * 3600 : 0.0;
  for (const std::vector<TipLoad>& at_tip : crack.loads(crack.crack().size, amplification))
    told.grows = told.grows || crack.growth(at_tip, crack.crack().size.size) > 0;
  const Modes K = crack.worst_factors(crack.crack().size);
  if (K[2] == 0 && (K[0] != 0 || K[1] != 0) && K[0] >= 0)
    told.kink_angle = kink_angle({.I = K[0], .II = K[1], .III = 0});
  return told;
}

void describe_arrest(CrackGrowth& to, const GrowingCrack& crack, const CrackSize& size,
                     double amplification, const GrowsUnder& grows) {
  for (const std::vector<TipLoad>& at_tip : crack.loads(size, amplification))
    for (const TipLoad& load : at_tip) {
      const auto threshold = crack.threshold(load.cycle, size.size);
      if (!threshold || !(load.cycle.full_range() > 0)) continue;
      const double margin = *threshold / load.cycle.full_range();
      to.margin = std::min(to.margin.value_or(margin), margin);
    }
  // A table of K over a turn has no answer beyond its torques.
  const double most = std::min(1000.0, crack.largest_factor() / amplification);
  // The coupled drive has no answer far above its rating: the factor lies between the largest one
  // without growth and the least one with growth or without an answer.
  double below = 1.0;
  double above = 1.0;
  std::optional<bool> there = false;
  while (there.has_value() && !*there && above < most) {
    below = above;
    above = std::min(2 * above, most);
    there = grows(above);
  }
  if (there.has_value() && !*there) return;
  constexpr int kSteps = 50;  // halves the logarithm of 2 down to rounding
  for (int i = 0; i < kSteps; ++i) {
    const double middle = std::sqrt(below * above);
    (grows(middle).value_or(true) ? above : below) = middle;
  }
  if (grows(above).value_or(false)) to.factor_to_grow = above;
}

void cite(GrowthReport& report, std::span<const std::string_view> tags) {
  for (const std::string_view tag : tags)
    if (std::ranges::find(report.equations, tag) == report.equations.end())
      report.equations.emplace_back(tag);
}

void cite_models(GrowthReport& report, const GrowingCrack& crack, const Interaction& interaction) {
  const auto use = [&](std::initializer_list<std::string_view> tags) {
    cite(report, std::span(tags.begin(), tags.size()));
  };
  std::visit([&](const auto& law) { cite(report, law.kEquations); }, crack.law());
  use({"GR-12"});
  if (crack.crack().count > 1) use({"CG-7"});
  switch (crack.mixed_mode()) {
    case MixedMode::energy:
      use({"GR-13"});
      break;
    case MixedMode::tanaka:
      use({"GR-14"});
      break;
    case MixedMode::richard:
      use({"GR-15"});
      break;
    case MixedMode::largest_tangential_stress:
      use({"GR-16"});
      break;
  }
  switch (interaction.rule) {
    case InteractionRule::none:
      break;
    case InteractionRule::wheeler:
      use({"GR-17", "GR-18", "GR-27"});
      break;
    case InteractionRule::willenborg:
      use({"GR-17", "GR-19", "GR-27"});
      break;
    case InteractionRule::closure:
      use({"GR-17", "GR-7", "GR-32", "GR-27"});
      break;
  }
  if (crack.crack().turn_table) use({"GR-30", "GR-31"});
  if (crack.crack().kind == "surface" && crack.crack().turning == TurningLoad::bending)
    use({"GR-34", "GR-35"});
  if (std::ranges::any_of(crack.duty().cycle, [](const LoadCycle& cycle) {
        return cycle.from.bending_moment != 0 || cycle.to.bending_moment != 0;
      }))
    use({"GR-40"});
}

void complete(GrowthReport& report, const GearSet& gear, const RateChoice& choice,
              std::span<const RatioRange> ratios) {
  note_validity(report, gear, choice, ratios);
  for (const CrackGrowth& crack : report.cracks) {
    constexpr double kTurns = 5 * units::deg;
    if (crack.kink_angle && std::abs(*crack.kink_angle) > kTurns)
      report.notes.push_back(
          {.code = "growth.turns",
           .text = fmt::format(
               "the crack would turn by {:.3g} degrees at once, but its path is computed "
               "straight",
               *crack.kink_angle / units::deg),
           .path = crack.path,
           .equation = "GR-16",
           .severity = Severity::care,
           .next_step = "Give the crack the direction into which it turns."});
  }
  const auto of = [&](const std::string& path) -> const CrackGrowth* {
    const auto found = std::ranges::find(report.cracks, path, &CrackGrowth::path);
    return found == report.cracks.end() ? nullptr : &*found;
  };
  const CrackGrowth* const governing = of(report.governing);
  const auto size_at_end = [&] {
    return governing && !governing->events.empty()
               ? fmt::format(" at {:.4g} mm", governing->events.back().size / units::mm)
               : std::string();
  };
  // Cracks whose stress is known in part cannot be told either, unless they end the life.
  std::set<std::string> unknown;
  for (const Note& note : report.notes)
    if (note.severity == Severity::cannot_tell && of(note.path) != nullptr)
      unknown.insert(note.path);
  const std::size_t all = drive_cracks(gear).size();
  const std::size_t untold = all - report.cracks.size() + unknown.size();
  const std::string but = untold == 0
                              ? std::string()
                              : fmt::format(", but {} of {} cracks cannot be told", untold, all);
  switch (report.end) {
    case DriveEnd::breaks:
      report.sentence = fmt::format("{} breaks the part {}{}.", report.governing,
                                    after(report.time), size_at_end());
      break;
    case DriveEnd::assessment:
      report.sentence = fmt::format("{} fails the assessment {}{}.", report.governing,
                                    after(report.time), size_at_end());
      break;
    case DriveEnd::arrested: {
      std::string margins;
      for (const CrackGrowth& crack : report.cracks)
        if (crack.factor_to_grow)
          margins += fmt::format("{}{} grows from {:.4g} times the loads",
                                 margins.empty() ? "; " : ", ", crack.path, *crack.factor_to_grow);
      const std::string when = report.time > 0 ? " any more after " + hours(report.time) : "";
      report.sentence =
          untold == 0
              ? fmt::format("No crack grows{}, so the cracks do not end the life{}.", when, margins)
              : fmt::format(
                    "No crack that can be computed grows{}, but {} of {} cracks cannot be "
                    "told{}.",
                    when, untold, all, margins);
      break;
    }
    case DriveEnd::severed:
      report.sentence = fmt::format("{} leaves less than 1 % of the stiffness {}{}.",
                                    report.governing, after(report.time), size_at_end());
      break;
    case DriveEnd::until:
      report.sentence = fmt::format("No crack ends the life within {}{}.", hours(report.time), but);
      break;
    case DriveEnd::too_slow:
      report.sentence = fmt::format(
          "No crack ends the life within {}, the longest duty that is "
          "computed{}.",
          hours(report.time), but);
      break;
    case DriveEnd::range:
      if (governing && !governing->events.empty() &&
          governing->events.back().event == CrackEvent::merges) {
        report.sentence = fmt::format(
            "{} grows together with another crack after {}{}; a note describes the one "
            "crack, whose growth is to be computed next.",
            report.governing, hours(report.time), size_at_end());
        break;
      }
      report.sentence =
          fmt::format("The solution for {} ends after {}{}; nobody can tell what follows.",
                      report.governing, hours(report.time), size_at_end());
      report.notes.push_back(
          {.code = "growth.range",
           .text = fmt::format("{} leaves the range of its stress intensity", report.governing),
           .path = report.governing,
           .equation = "GR-24",
           .severity = Severity::cannot_tell,
           .next_step = "Replace the part before this time, or assess a longer "
                        "crack by finite elements."});
      break;
    case DriveEnd::not_known:
      report.sentence = "The drive has no crack whose growth can be computed.";
      break;
  }
  if (report.life)
    report.notes.push_back(
        {.code = "growth.ends",
         .text = fmt::format("the crack ends the life of the drive {}", after(report.time)),
         .path = report.governing,
         .equation = "GR-24",
         .severity = Severity::critical,
         .next_step = "Replace or inspect the part well before this time."});
}

}  // namespace strainwave

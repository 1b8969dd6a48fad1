// SPDX-License-Identifier: Apache-2.0
#include "notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
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

/// Notes on the range for which the constants are stated.
void note_range(GrowthReport& report, const GearSet& gear, const RateChoice& choice) {
  for (const CrackGrowth& crack : report.cracks) {
    if (crack.series.empty() || !crack.grows) continue;
    std::optional<GrowthBounds> bounds;
    if (!choice.law.empty()) {
      bounds = growth_bounds(require_material(choice.law));
    } else {
      for (const DriveCrack& of : drive_cracks(gear))
        if (of.path == crack.path) bounds = gear.material.at(of.material).growth_bounds;
    }
    if (!bounds) continue;
    double least = crack.series.front().delta_K;
    double most = least;
    double least_R = crack.series.front().ratio;
    double most_R = least_R;
    for (const GrowthPoint& point : crack.series) {
      least = std::min(least, point.delta_K);
      most = std::max(most, point.delta_K);
      least_R = std::min(least_R, point.ratio);
      most_R = std::max(most_R, point.ratio);
    }
    std::string outside;
    if (bounds->stress_ratio &&
        (least_R < (*bounds->stress_ratio)[0] || most_R > (*bounds->stress_ratio)[1]))
      outside =
          fmt::format("R is {:.3g} to {:.3g}, and the law is stated for {:.3g} to {:.3g}", least_R,
                      most_R, (*bounds->stress_ratio)[0], (*bounds->stress_ratio)[1]);
    if ((bounds->from && least < *bounds->from) || (bounds->to && most > *bounds->to)) {
      if (!outside.empty()) outside += "; ";
      outside += fmt::format("Delta K is {:.3g} to {:.3g} MPa*m^0.5, beyond the range of the law",
                             least / units::MPa, most / units::MPa);
    }
    if (!outside.empty())
      report.notes.push_back(
          {.code = "growth.law_range",
           .text = outside,
           .path = crack.path,
           .equation = "GR-2",
           .severity = Severity::care,
           .next_step = "Use constants that are stated for these cycles, or compare with another "
                        "law by --law."});
  }
}

}  // namespace

Note coupled_crack_note(const std::string& path) {
  return {.code = "growth.coupled",
          .text = "the stress intensity of this crack is not known, so its growth is not computed",
          .path = path,
          .equation = "TC-22",
          .severity = Severity::cannot_tell,
          .next_step = "Inspect the part, or assess the crack by finite elements."};
}

Note unknown_balls_note(const std::string& path) {
  return {.code = "growth.unknown_balls",
          .text = "the number of balls that pass is not known, so the growth is not computed",
          .path = path,
          .equation = "GR-21",
          .severity = Severity::cannot_tell,
          .next_step = "Give wave_generator.bearing with its ball_count."};
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
    notes.push_back(
        {.code = "growth.unknown_stress",
         .text = "a part of the stress is not known, so the growth is that of the known "
                 "part: " +
                 of.unknown,
         .path = of.path,
         .equation = "GR-22",
         .severity = Severity::cannot_tell,
         .next_step = of.next_step});
  if (of.assembly)
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
                     double amplification) {
  const auto grows = [&](double factor) {
    for (const std::vector<TipLoad>& at_tip : crack.loads(size, factor * amplification))
      if (crack.growth(at_tip, size.size) > 0) return true;
    return false;
  };
  for (const std::vector<TipLoad>& at_tip : crack.loads(size, amplification))
    for (const TipLoad& load : at_tip) {
      const auto threshold = crack.threshold(load.cycle, size.size);
      if (!threshold || !(load.cycle.full_range() > 0)) continue;
      const double margin = *threshold / load.cycle.full_range();
      to.margin = std::min(to.margin.value_or(margin), margin);
    }
  constexpr double kMost = 1000;
  if (!grows(kMost)) return;
  double below = 1.0;
  double above = kMost;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(below * above);
    (grows(middle) ? above : below) = middle;
  }
  to.factor_to_grow = above;
}

void complete(GrowthReport& report, const GearSet& gear, const RateChoice& choice) {
  note_range(report, gear, choice);
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
    if (crack.kind == "annular" && crack.grows) report.equations.emplace_back("GR-25");
  }
  for (const DriveCrack& crack : drive_cracks(gear))
    if (crack.kind == "surface" && crack.turning == TurningLoad::bending)
      report.equations.insert(report.equations.end(), {"GR-34", "GR-35"});
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
      const std::size_t all = drive_cracks(gear).size();
      const std::size_t left_out = all - report.cracks.size();
      report.sentence =
          left_out == 0
              ? fmt::format("No crack grows{}, so the cracks do not end the life{}.", when, margins)
              : fmt::format(
                    "No crack that can be computed grows{}, but {} of {} cracks cannot be "
                    "told{}.",
                    when, left_out, all, margins);
      break;
    }
    case DriveEnd::severed:
      report.sentence = fmt::format("{} leaves less than 1 % of the stiffness {}{}.",
                                    report.governing, after(report.time), size_at_end());
      break;
    case DriveEnd::until:
      report.sentence = fmt::format("No crack ends the life within {}.", hours(report.time));
      break;
    case DriveEnd::too_slow:
      report.sentence = fmt::format(
          "No crack ends the life within {}, the longest duty that is "
          "computed.",
          hours(report.time));
      break;
    case DriveEnd::range:
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

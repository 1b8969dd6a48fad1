// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"
#include "strainwave/torsion/hysteresis.hpp"

namespace strainwave {

template <class Archive>
void archive(Archive& to, LineChanges& change) {
  to(change.K1, change.K2, change.K3);
}

namespace {

using std::numbers::pi;

constexpr double LineChanges::*kLines[] = {&LineChanges::K1, &LineChanges::K2, &LineChanges::K3};

LineChanges changes(const MakersLines& cracked, const MakersLines& sound) {
  return {cracked.K1 / sound.K1 - 1, cracked.K2 / sound.K2 - 1, cracked.K3 / sound.K3 - 1};
}

/// Order per turn with the largest amplitude; 0 if the changes do not vary.
int dominant_order(const std::vector<LineChanges>& at_angle) {
  const auto n = static_cast<int>(at_angle.size());
  double largest = 1e-9;
  int order = 0;
  for (int k = 1; k <= n / 2; ++k) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < n; ++i)
      sum += at_angle[static_cast<std::size_t>(i)].K1 * std::polar(1.0, -2 * pi * k * i / n);
    const double amplitude = 2 * std::abs(sum) / n;
    if (amplitude > largest * (1 + 1e-9)) {
      largest = amplitude;
      order = k;
    }
  }
  return order;
}

/// @param at_angle  changes at the positions; the first position is that of the file
ChangesOverTurn over_turn(std::vector<LineChanges> at_angle) {
  ChangesOverTurn result;
  result.as_given = result.worst = result.best = at_angle.front();
  for (const LineChanges& at : at_angle)
    for (const auto line : kLines) {
      result.mean.*line += at.*line / static_cast<double>(at_angle.size());
      result.worst.*line = std::min(result.worst.*line, at.*line);
      result.best.*line = std::max(result.best.*line, at.*line);
    }
  for (const auto line : kLines) result.ripple.*line = result.best.*line - result.worst.*line;
  result.ripple_order = dominant_order(at_angle);
  result.at_angle = std::move(at_angle);
  return result;
}

/// Whether a crack moves with the circular spline; other cracks of the contacts move with the
/// flexspline.
template <ContactCrack Crack>
bool of_spline(const Crack& crack) {
  return crack.place().part == CrackedPart::circular_spline;
}

/// Angles of the wave generator over one of its turns against the cracked part, in steps of one
/// tooth of the circular spline.  In each step the flexspline passes the wave by one of its own
/// teeth (TC-28), so a crack meets the same teeth and gaps at each position.
std::vector<double> positions_over_turn(const GearSet& gear, int angles) {
  const int teeth = flexspline_teeth(gear.drive);
  const int spaces = teeth + gear.drive.wave_number;
  bool flexspline = false;
  for_each_crack(gear, [&]<class Crack>(const std::string&, const Crack& crack) {
    if constexpr (ContactCrack<Crack>) flexspline = flexspline || !of_spline(crack);
  });
  const int steps = flexspline ? teeth : spaces;
  const int count = !has_moving_cracks(gear) ? 1 : angles == 0 ? steps : std::min(angles, steps);
  std::vector<double> positions;
  for (int i = 0; i < count; ++i)
    positions.push_back(2 * pi / spaces * std::round(static_cast<double>(i) * steps / count));
  return positions;
}

double size(const LineChanges& c) {
  return std::max({std::abs(c.K1), std::abs(c.K2), std::abs(c.K3)});
}

/// Finds the kind of cracked member (TC-26).  A member in series adds the same compliance to all
/// three lines at every position.  Teeth and rings change K1 most, by an amount that depends on the
/// position.
void diagnose(CurveComparison& comparison) {
  constexpr double kAlike = 0.1;
  constexpr double kContact = 1.5;
  constexpr double kRounding = 1e-8;
  const bool positive = size(comparison.positive.mean) >= size(comparison.negative.mean);
  const ChangesOverTurn& more = positive ? comparison.positive : comparison.negative;
  if (size(more.mean) < kRounding && size(more.worst) < kRounding) {
    comparison.evidence = "the curve does not change";
    return;
  }
  const auto added = [&](double LineChanges::*line, double sound) {
    return (1 / (1 + more.mean.*line) - 1) / sound;
  };
  const auto [least, most] = std::minmax({added(&LineChanges::K1, comparison.sound.K1),
                                          added(&LineChanges::K2, comparison.sound.K2),
                                          added(&LineChanges::K3, comparison.sound.K3)});
  const bool alike = least > 0 && most - least < kAlike * most;
  const double mean = std::abs(more.mean.K1);
  const bool k3_still = std::abs(more.mean.K3) < kRounding;
  comparison.class_ratio = k3_still ? 0.0 : more.mean.K1 / more.mean.K3;
  if (alike && more.ripple.K1 < kAlike * mean)
    comparison.crack_class = CrackClass::series;
  else if (!alike && (more.ripple.K1 > mean || k3_still || comparison.class_ratio > kContact))
    comparison.crack_class = CrackClass::contact_path;
  else
    comparison.crack_class = CrackClass::undecided;
  comparison.evidence = fmt::format(
      "the mean change of K1 is {:.2g} times that of K3, the compliances added to the three lines "
      "{}, and K1 varies by {:.2g} % over a turn of the wave generator{}",
      comparison.class_ratio, alike ? "are alike" : "differ", 100 * more.ripple.K1,
      more.ripple_order > 0 ? fmt::format(", {} times per turn", more.ripple_order)
                            : std::string());
}

/// Changes at one position of the wave generator.
struct TurnRow {
  LineChanges positive;
  LineChanges negative;
};

template <class Archive>
void archive(Archive& to, TurnRow& row) {
  to(row.positive, row.negative);
}

}  // namespace

GearSet without_cracks(const GearSet& gear) {
  return with_cracks_where(gear, [](std::string_view, const auto&) { return false; });
}

bool has_cracks(const GearSet& gear) {
  bool any = false;
  for_each_crack(gear, [&](const std::string&, const auto&) { any = true; });
  return any;
}

bool has_moving_cracks(const GearSet& gear) {
  bool any = false;
  for_each_crack(gear, [&]<class Crack>(const std::string&, const Crack&) {
    any = any || ContactCrack<Crack>;
  });
  return any;
}

double flexspline_turn(const Transmission& drive, double angle) {
  return (1 + 1 / drive.ratio) * angle;  // (TC-28)
}

double turned_position(double position, double angle) {
  return std::remainder(position - angle, 2 * pi);
}

GearSet after_turn(const GearSet& gear, double angle) {
  return after_moves(gear, flexspline_turn(gear.drive, angle), angle);
}

GearSet after_moves(const GearSet& gear, double flexspline, double spline) {
  GearSet turned = gear;
  for_each_crack(turned, [&]<class Crack>(const std::string&, Crack& crack) {
    if constexpr (ContactCrack<Crack>)
      crack.position = turned_position(crack.position, of_spline(crack) ? spline : flexspline);
  });
  drop_lost_paths(turned, gear);
  return turned;
}

TurnChanges changes_over_turn(const AssembledDrive& drive, int angles, const Progress& progress,
                              SharedRows* shared) {
  require(angles >= 0, "angles", angles, "1", ">= 0");
  const AssembledDrive sound = drive.without_cracks();
  const MakersLines positive_sound = makers_lines(sound, +1);
  const MakersLines negative_sound = makers_lines(sound, -1);
  const std::vector<double> turn = positions_over_turn(drive.gear(), angles);
  const auto rows = shared_rows<TurnRow>(turn.size(), {}, progress, shared, [&] {
    return [&](std::size_t i, TurnRow& row) {
      const AssembledDrive turned = drive.turned(turn[i]);
      row.positive = changes(makers_lines(turned, +1), positive_sound);
      row.negative = changes(makers_lines(turned, -1), negative_sound);
    };
  });
  std::vector<LineChanges> positive;
  std::vector<LineChanges> negative;
  for (const TurnRow& row : rows) {
    positive.push_back(row.positive);
    negative.push_back(row.negative);
  }
  return {.angles = turn,
          .positive = over_turn(std::move(positive)),
          .negative = over_turn(std::move(negative))};
}

LinesOverCage lines_over_cage(const AssembledDrive& drive, int phases, const Progress& progress) {
  require(phases >= 1, "phases", phases, "1", ">= 1");
  const double pitch = 2 * pi / *drive.gear().wave_generator->bearing->ball_count;
  LinesOverCage result;
  for (int i = 0; i < phases; ++i)
    result.phases.push_back(drive.options().cage_phase + pitch * i / phases);
  result.at_phase.resize(result.phases.size());
  for_each_index(result.phases.size(), {}, progress, [&] {
    return [&](std::size_t i) {
      CoupledOptions options = drive.options();
      options.cage_phase = result.phases[i];
      const MakersLines lines =
          makers_lines(AssembledDrive(drive.gear(), options).with_deviations(drive.deviations()));
      result.at_phase[i] = {lines.K1, lines.K2, lines.K3};
    };
  });
  for (double LineStiffnesses::*const line :
       {&LineStiffnesses::K1, &LineStiffnesses::K2, &LineStiffnesses::K3}) {
    const auto [softest, stiffest] = std::ranges::minmax(result.at_phase, {}, line);
    result.softest.*line = softest.*line;
    result.stiffest.*line = stiffest.*line;
    for (const LineStiffnesses& at : result.at_phase) result.mean.*line += at.*line / phases;
  }
  return result;
}

CurveComparison compare_curves(const AssembledDrive& drive, int angles, const Progress& progress,
                               SharedRows* shared) {
  const AssembledDrive sound = drive.without_cracks();
  CurveComparison comparison;
  comparison.torques = makers_torques(drive.gear());
  comparison.sound = makers_lines(sound, +1);
  // Shares of the time: the positions take most of it, the loops the rest.
  TurnChanges turn = changes_over_turn(drive, angles, progress.part(0.0, 0.9), shared);
  comparison.angles = std::move(turn.angles);
  comparison.positive = std::move(turn.positive);
  comparison.negative = std::move(turn.negative);
  comparison.lost_motion_sound = lost_motion(sound);
  comparison.lost_motion_cracked = lost_motion(drive);
  const auto largest_width = [&](const AssembledDrive& of, const Progress& part) {
    const double rated = comparison.torques.rated;
    return hysteresis_loop(Hysteresis(of, rated, {}, part), rated).largest_width;
  };
  comparison.hysteresis_sound = largest_width(sound, progress.part(0.9, 0.95));
  comparison.hysteresis_cracked = largest_width(drive, progress.part(0.95, 1.0));
  diagnose(comparison);
  return comparison;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "crack_interaction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "member_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/crack_group/straight_cracks.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The dense system of more cracks would take longer than the rest of an answer.
constexpr std::size_t kMostCracks = 10;

/// The through cracks of a section that have a position, on the wall unrolled to a sheet.
struct PlacedCracks {
  std::vector<std::string> paths;
  std::vector<StraightCrack> cracks;
};

PlacedCracks placed_cracks(const Flexspline& fs, WallSection section, double radius,
                           double length) {
  PlacedCracks placed;
  for (std::size_t i = 0; i < fs.crack.size(); ++i) {
    const auto* const crack = std::get_if<WallThroughCrack>(&fs.crack[i]);
    // A row contains the influence of its own cracks.
    if (crack == nullptr || crack->section != section || !crack->position || crack->count > 1)
      continue;
    placed.paths.push_back((FieldPath("flexspline") / "crack")[i].text());
    // x runs round the axis and y along it; beta counts from +y toward -x.
    placed.cracks.push_back(
        {.centre = {radius * *crack->position, crack->distance.value_or(length / 2)},
         .half_length = crack->half_length,
         .angle = pi / 2 + crack->angle});
  }
  return placed;
}

void require_apart(const PlacedCracks& placed, double round) {
  const auto touching = touching_cracks(placed.cracks, round);
  if (!touching) return;
  const auto [j, i] = *touching;
  throw InputError(placed.paths[i],
                   i == j ? std::string("reaches round the whole wall; give a shorter crack")
                          : fmt::format("crosses or touches {}; move one of them by position or "
                                        "distance, or replace both by one crack",
                                        placed.paths[j]));
}

/// How much a group differs from its cracks alone, under one sense of the torque.
struct Influence {
  double compliance = 1.0;    ///< that of the group over the sum [-]
  double factor = 1.0;        ///< the largest K of a crack in the group over its K alone [-]
  std::size_t of = 0;         ///< the crack that has it
  double least_factor = 1.0;  ///< the smallest such ratio over the cracks [-]
  bool acts = false;          ///< whether a crack opens or slides
  bool settled = false;       ///< whether each crack is open or closed as a whole

  [[nodiscard]] double largest_change() const {
    return std::max({std::abs(compliance - 1), std::abs(factor - 1), std::abs(least_factor - 1)});
  }
};

/// The larger K of the tips of a crack, modes 1 and 2 together.
double whole(const GroupedCrack& crack) {
  return std::max(std::hypot(crack.behind.mode_1, crack.behind.mode_2),
                  std::hypot(crack.ahead.mode_1, crack.ahead.mode_2));
}

/// @param stress   of the load, which decides which cracks are closed
/// @param torsion  its part by the torque, whose compliance counts
Influence influence_of(const std::vector<StraightCrack>& cracks, const SheetStress& stress,
                       const SheetStress& torsion, double round) {
  constexpr int kOrder = 24;
  constexpr int kFineOrder = 60;  // of cracks that nearly touch
  constexpr double kGood = 1e-3;
  GroupOptions options{.order = kOrder, .period = round, .compliance_of = torsion};
  CrackGroup group = crack_group(cracks, stress, options);
  if (group.error > kGood) {
    options.order = kFineOrder;
    group = crack_group(cracks, stress, options);
  }
  Influence influence{.compliance = group.compliance_ratio, .settled = group.settled};
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const double alone =
        whole(crack_group(std::span(&cracks[i], 1), stress, {.order = 8}).cracks.front());
    const double largest = std::max(std::abs(stress.yy), std::abs(stress.xy));
    constexpr double kRounding = 1e-9;
    if (alone <= kRounding * largest * std::sqrt(pi * cracks[i].half_length)) continue;
    const double ratio = whole(group.cracks[i]) / alone;
    if (!influence.acts || ratio > influence.factor) {
      influence.factor = ratio;
      influence.of = i;
    }
    influence.least_factor = influence.acts ? std::min(influence.least_factor, ratio) : ratio;
    influence.acts = true;
  }
  return influence;
}

std::string words_of(std::string_view sense, const Influence& influence,
                     const std::vector<std::string>& paths) {
  if (!influence.acts) return fmt::format("under {} none of them opens or slides", sense);
  return fmt::format(
      "under {} they add {:.3f} times the sum of their compliances, and K is {:.3f} to {:.3f} "
      "times that of a crack alone, the most at {}",
      sense, influence.compliance, influence.least_factor, influence.factor, paths[influence.of]);
}

}  // namespace

std::size_t note_interaction(const GearSet& gear, const CrackLoads<double>& loads,
                             WallSection section, MemberCompliance& member) {
  const Flexspline& fs = *gear.flexspline;
  const bool sections = fs.crack_free == CrackFree::sections;
  const bool rim = section == WallSection::rim;
  if (sections && rim && !fs.rim) return 0;
  // The solver is for isotropic sheets.
  if (material_of(gear, material_name(fs, section), "flexspline.material").is_laminate()) return 0;
  const double length = !sections ? *fs.length : rim ? fs.rim->length : fs.barrel->length;
  const auto wall = loads.wall_of(section);
  const PlacedCracks placed = placed_cracks(fs, section, wall.mean_radius, length);
  if (placed.cracks.size() < 2) return 0;
  const double round = 2 * pi * wall.mean_radius;
  require_apart(placed, round);
  if (placed.cracks.size() > kMostCracks) return 0;
  const double area = round * wall.thickness;
  const double shear =
      std::abs(gear.load.torque) * fs.stress_nonuniformity / (area * wall.mean_radius);
  const auto under = [&](double sense) {
    const SheetStress torsion{.xy = sense * shear};
    SheetStress stress = torsion;
    stress.yy = gear.load.axial_force / area;
    return influence_of(placed.cracks, stress, torsion, round);
  };
  const Influence positive = under(+1);
  const Influence negative = under(-1);
  if (!positive.settled || !negative.settled) return 0;  // faces that touch in part: cannot tell
  constexpr double kSmall = 0.05;
  const double change = std::max(positive.acts ? positive.largest_change() : 0.0,
                                 negative.acts ? negative.largest_change() : 0.0);
  use_equations(member.equations, {"CG-6"});
  member.notes.push_back(
      {.code = "crack.interaction",
       .text = fmt::format(
           "the {} through cracks of the {} influence each other as in a flat sheet: {}; {}; this "
           "answer adds their compliances and takes each K alone",
           placed.cracks.size(),
           rim        ? "rim"
           : sections ? "barrel"
                      : "wall",
           words_of("T > 0", positive, placed.paths), words_of("T < 0", negative, placed.paths)),
       .path = "flexspline.crack",
       .equation = "CG-6",
       .severity = change > kSmall ? Severity::care : Severity::information,
       .next_step = change > kSmall
                        ? "Multiply the compliance of these cracks and K by these numbers."
                        : ""});
  return placed.cracks.size();
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/shaft_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Most cracks that are solved together, because the time grows with the third power of their
/// number.
constexpr std::size_t kMostAnnularCracks = 20;

std::string path_of(std::size_t index) {
  return (FieldPath("output_shaft") / "crack")[index].text();
}

}  // namespace

ShaftGroup shaft_group(const GearSet& gear) {
  ShaftGroup group;
  if (!gear.output_shaft) return group;
  const OutputShaft& shaft = *gear.output_shaft;
  group.radii = {.outer = shaft.outer_diameter / 2, .inner = shaft.inner_diameter / 2};
  for (std::size_t i = 0; i < shaft.crack.size(); ++i) {
    const auto* const crack = std::get_if<AnnularCrack>(&shaft.crack[i]);
    if (crack == nullptr || !crack->distance) continue;
    group.index.push_back(i);
    group.cracks.push_back({.place = *crack->distance, .depth = crack->depth});
  }
  if (group.cracks.size() < 2) return {};
  return group;
}

std::string ShaftGroup::fault() const {
  if (cracks.size() > kMostAnnularCracks)
    return fmt::format(
        "{}: {} annular cracks have a distance, and at most {} are solved together; leave out the "
        "distance of cracks that are more than a radius away from the others",
        path_of(index.front()), cracks.size(), kMostAnnularCracks);
  const double wall = radii.outer - radii.inner;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const double share = cracks[i].depth / wall;
    if (share < kLeastAnnularDepth || share > kLargestAnnularDepth)
      return fmt::format(
          "{}: the depth is {:.3g} of the wall, and the influence is known from {:g} to {:g}; "
          "leave out "
          "its distance if it is more than a radius away from the others",
          path_of(index[i]), share, kLeastAnnularDepth, kLargestAnnularDepth);
  }
  if (const auto near = touching_annular_cracks(cracks))
    return fmt::format(
        "{}: the distance to {} is less than {:g} of the deeper crack; replace both by one crack, "
        "whose "
        "compliance is about that of the deeper one",
        path_of(index[near->second]), path_of(index[near->first]), kLeastAnnularDistance);
  return {};
}

std::vector<double> shaft_ratios(const GearSet& gear, const Lift<double>&) {
  const ShaftGroup group = shaft_group(gear);
  if (group.cracks.empty() || !group.fault().empty()) return {};
  std::vector<double> ratios(gear.output_shaft->crack.size(), 1.0);
  const AnnularGroup solved = group.solved();
  for (std::size_t j = 0; j < group.index.size(); ++j)
    ratios[group.index[j]] = solved.cracks[j].compliance;  // (CG-12)
  return ratios;
}

std::vector<DualReal> shaft_ratios(const GearSet& gear, const Lift<DualReal>& lift) {
  const std::vector<double> values = shaft_ratios(gear, Lift<double>());
  std::vector<DualReal> ratios(values.begin(), values.end());
  if (ratios.empty()) return ratios;
  const ShaftGroup group = shaft_group(gear);
  const auto modes = annular_modes(group.cracks, group.radii);
  // A number of the drive that moves the group, and what it moves.
  const auto add = [&](const double& number, const auto& move) {
    const DualReal input = lift(number);
    if (std::ranges::all_of(input.partial, [](double partial) { return partial == 0; })) return;
    const double step = 1e-4 * std::max(number, group.radii.outer - group.radii.inner);
    // At the end of a range the difference is one-sided.
    const auto moved = [&](double by) {
      ShaftGroup other = group;
      move(other, by);
      return std::pair(other, by);
    };
    auto [above, up] = moved(step);
    auto [below, down] = moved(-step);
    if (!above.fault().empty()) std::tie(above, up) = moved(0.0);
    if (!below.fault().empty()) std::tie(below, down) = moved(0.0);
    const AnnularGroup of_above = annular_group(above.cracks, above.radii, modes);
    const AnnularGroup of_below = annular_group(below.cracks, below.radii, modes);
    for (std::size_t j = 0; j < group.index.size(); ++j) {
      const double slope =
          (of_above.cracks[j].compliance - of_below.cracks[j].compliance) / (up - down);
      ratios[group.index[j]] += slope * (input - number);
    }
  };
  const OutputShaft& shaft = *gear.output_shaft;
  for (std::size_t j = 0; j < group.index.size(); ++j) {
    const auto& crack = std::get<AnnularCrack>(shaft.crack[group.index[j]]);
    add(crack.depth, [j](ShaftGroup& of, double by) { of.cracks[j].depth += by; });
    add(*crack.distance, [j](ShaftGroup& of, double by) { of.cracks[j].place += by; });
  }
  add(shaft.outer_diameter, [](ShaftGroup& of, double by) { of.radii.outer += by / 2; });
  add(shaft.inner_diameter, [](ShaftGroup& of, double by) { of.radii.inner += by / 2; });
  return ratios;
}

}  // namespace strainwave

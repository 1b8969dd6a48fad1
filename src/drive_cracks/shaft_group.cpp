// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/shaft_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
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
          "leave out its distance if it is more than a radius away from the others",
          path_of(index[i]), share, kLeastAnnularDepth, kLargestAnnularDepth);
  }
  for (std::size_t j = 0; j < cracks.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (cracks[i].place == cracks[j].place)
        return fmt::format(
            "{}: the distance is that of {}; replace both by one crack, the deeper one",
            path_of(index[j]), path_of(index[i]));
  return {};
}

double ShaftGroup::stretch() const {
  double most = 1.0;
  for (std::size_t j = 0; j < cracks.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      most = std::max(most, kLeastAnnularDistance * std::max(cracks[i].depth, cracks[j].depth) /
                                std::abs(cracks[i].place - cracks[j].place));
  return most;  // (CG-12)
}

bool ShaftGroup::stretched() const { return stretch() > 1 + 1e-11; }

AnnularGroup ShaftGroup::solved_with(const std::vector<std::size_t>& modes) const {
  // Rounding must not leave two cracks nearer than the limit.
  const double apart = stretch() * (1 + 1e-12);
  std::vector<PlacedAnnularCrack> placed = cracks;
  if (stretched())
    for (PlacedAnnularCrack& crack : placed) crack.place *= apart;
  return annular_group(placed, radii, modes);
}

AnnularGroup ShaftGroup::solved() const {
  // This thread keeps the last groups: an assessment asks several times at each of some hundred
  // sizes.
  constexpr std::size_t kKept = 32;
  struct Known {
    ShaftRadii radii;
    std::vector<PlacedAnnularCrack> cracks;
    AnnularGroup solved;
  };
  thread_local std::deque<Known> last;
  for (const Known& known : last)
    if (known.radii.outer == radii.outer && known.radii.inner == radii.inner &&
        std::ranges::equal(known.cracks, cracks, [](const auto& a, const auto& b) {
          return a.place == b.place && a.depth == b.depth;
        }))
      return known.solved;
  last.push_front({radii, cracks, solved_with(annular_modes(cracks, radii))});
  if (last.size() > kKept) last.pop_back();
  return last.front().solved;
}

double ShaftGroup::intensity(std::size_t member, double depth) const {
  ShaftGroup at = *this;
  at.cracks[member].depth = depth;
  return at.fault().empty() && !at.stretched() ? at.solved().cracks[member].factor
                                               : 1.0;  // (CG-12)
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

namespace {

/// Slopes of the ratios of a group by each length that moves it [1/m]; the inner index is that of
/// the crack whose ratio changes.
struct ShaftSlopes {
  std::vector<std::vector<double>> depth;
  std::vector<std::vector<double>> place;
  std::vector<double> outer;  ///< by the outer radius
  std::vector<double> inner;  ///< by the inner radius
};

ShaftSlopes slopes_of(const ShaftGroup& group) {
  constexpr double kShareOfRoom = 5e-4;
  const std::size_t n = group.cracks.size();
  const auto modes = annular_modes(group.cracks, group.radii);
  double room = group.radii.outer - group.radii.inner;  // the smallest depth, gap or wall
  for (std::size_t i = 0; i < n; ++i) {
    room = std::min(room, group.cracks[i].depth);
    for (std::size_t j = 0; j < i; ++j)
      room = std::min(room, std::abs(group.cracks[i].place - group.cracks[j].place));
  }
  // Differences with an error of the fourth power of the step.
  const auto slope = [&](double step, const auto& move) {
    const auto moved = [&](double by) {
      ShaftGroup other = group;
      move(other, by);
      return other.solved_with(modes);
    };
    const AnnularGroup two_before = moved(-2 * step);
    const AnnularGroup one_before = moved(-step);
    const AnnularGroup one_behind = moved(step);
    const AnnularGroup two_behind = moved(2 * step);
    std::vector<double> result;
    for (std::size_t j = 0; j < n; ++j)
      result.push_back((8 * (one_behind.cracks[j].compliance - one_before.cracks[j].compliance) -
                        (two_behind.cracks[j].compliance - two_before.cracks[j].compliance)) /
                       (12 * step));
    return result;
  };
  ShaftSlopes slopes;
  const double step = kShareOfRoom * room;
  for (std::size_t i = 0; i < n; ++i)
    slopes.depth.push_back(
        slope(step, [i](ShaftGroup& of, double by) { of.cracks[i].depth += by; }));
  // A shift of all cracks together changes nothing.
  slopes.place.emplace_back(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    slopes.place.push_back(
        slope(step, [i](ShaftGroup& of, double by) { of.cracks[i].place += by; }));
    for (std::size_t j = 0; j < n; ++j) slopes.place[0][j] -= slopes.place[i][j];
  }
  // A small bore changes the ratios by its fourth power, so that of a solid shaft has no slope.
  slopes.inner.assign(n, 0.0);
  if (group.radii.inner > 0)
    slopes.inner = slope(kShareOfRoom * std::min(room, group.radii.inner),
                         [](ShaftGroup& of, double by) { of.radii.inner += by; });
  // The ratios have no dimension, so all lengths in proportion change nothing.
  slopes.outer.assign(n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    double sum = group.radii.inner * slopes.inner[j];
    for (std::size_t i = 0; i < n; ++i)
      sum += group.cracks[i].depth * slopes.depth[i][j] +
             (group.cracks[i].place - group.cracks[0].place) * slopes.place[i][j];
    slopes.outer[j] = -sum / group.radii.outer;
  }
  return slopes;
}

}  // namespace

std::vector<DualReal> shaft_ratios(const GearSet& gear, const Lift<DualReal>& lift) {
  const std::vector<double> values = shaft_ratios(gear, Lift<double>());
  std::vector<DualReal> ratios(values.begin(), values.end());
  if (ratios.empty()) return ratios;
  const ShaftGroup group = shaft_group(gear);
  const OutputShaft& shaft = *gear.output_shaft;
  bool any = false;
  const auto change = [&](const double& number) {
    const DualReal result = lift(number) - number;
    any = any || std::ranges::any_of(result.partial, [](double partial) { return partial != 0; });
    return result;
  };
  std::vector<DualReal> depth;
  std::vector<DualReal> place;
  for (const std::size_t i : group.index) {
    const auto& crack = std::get<AnnularCrack>(shaft.crack[i]);
    depth.push_back(change(crack.depth));
    place.push_back(change(*crack.distance));
  }
  const DualReal outer = change(shaft.outer_diameter) / 2;
  const DualReal inner = change(shaft.inner_diameter) / 2;
  if (!any) return ratios;
  const ShaftSlopes slopes = slopes_of(group);
  for (std::size_t j = 0; j < group.index.size(); ++j) {
    DualReal& ratio = ratios[group.index[j]];
    for (std::size_t i = 0; i < group.index.size(); ++i)
      ratio += slopes.depth[i][j] * depth[i] + slopes.place[i][j] * place[i];
    ratio += slopes.outer[j] * outer + slopes.inner[j] * inner;
  }
  return ratios;
}

}  // namespace strainwave

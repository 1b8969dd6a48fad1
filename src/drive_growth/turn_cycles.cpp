// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/turn_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

double equivalent_of(MixedMode rule, const Modes& K, double nu) {
  return equivalent_factor(rule, {.I = K[0], .II = K[1], .III = K[2]}, nu);
}

/// Two moments with the largest equivalent range.
struct WidestRange {
  double range = 0.0;  ///< [Pa*m^0.5]
  Modes from{};
  Modes to{};
};

/// A moment with its distance from a centre.
struct Moment {
  double distance = 0.0;  // equivalent of the difference [Pa*m^0.5]
  const Modes* K = nullptr;
};

double equivalent_range(MixedMode rule, const Modes& from, const Modes& to, double nu) {
  Modes range{};
  for (std::size_t mode = 0; mode < range.size(); ++mode)
    range[mode] = std::abs(from[mode] - to[mode]);
  return equivalent_of(rule, range, nu);
}

/// The moments of a turn, the farthest from the centre first.
std::vector<Moment> by_distance(MixedMode rule, std::span<const Modes> turn, const Modes& centre,
                                double nu) {
  std::vector<Moment> moments;
  moments.reserve(turn.size());
  for (const Modes& K : turn)
    moments.push_back({.distance = equivalent_range(rule, K, centre, nu), .K = &K});
  std::stable_sort(moments.begin(), moments.end(),
                   [](const Moment& a, const Moment& b) { return a.distance > b.distance; });
  return moments;
}

WidestRange widest_range(MixedMode rule, std::span<const Modes> one, std::span<const Modes> other,
                         double nu) {
  Modes least = one.front();
  Modes most = one.front();
  for (const std::span<const Modes> turn : {one, other})
    for (const Modes& K : turn)
      for (std::size_t mode = 0; mode < K.size(); ++mode) {
        least[mode] = std::min(least[mode], K[mode]);
        most[mode] = std::max(most[mode], K[mode]);
      }
  Modes centre{};
  for (std::size_t mode = 0; mode < centre.size(); ++mode)
    centre[mode] = (least[mode] + most[mode]) / 2;
  // Every rule is a norm of the range, so two moments are not farther apart than the sum of their
  // distances from the centre.  Most pairs need no look.
  const bool same = one.data() == other.data();
  const std::vector<Moment> from = by_distance(rule, one, centre, nu);
  const std::vector<Moment> of_other =
      same ? std::vector<Moment>() : by_distance(rule, other, centre, nu);
  const std::vector<Moment>& to = same ? from : of_other;
  WidestRange widest;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t first = same ? i + 1 : 0;
    if (first == to.size() || from[i].distance + to[first].distance <= widest.range) break;
    for (std::size_t j = first; j < to.size(); ++j) {
      if (from[i].distance + to[j].distance <= widest.range) break;
      const double here = equivalent_range(rule, *from[i].K, *to[j].K, nu);
      if (here > widest.range) widest = {.range = here, .from = *from[i].K, .to = *to[j].K};
    }
  }
  return widest;
}

/// K at the moments of a turn along the direction of its widest range (GR-31).
std::vector<double> along_widest(std::span<const Modes> turn, const WidestRange& widest) {
  std::vector<double> along;
  along.reserve(turn.size());
  for (const Modes& K : turn) {
    double sum = 0.0;
    for (std::size_t mode = 0; mode < K.size(); ++mode)
      sum += K[mode] * (widest.from[mode] - widest.to[mode]);
    along.push_back(sum);
  }
  return along;
}

}  // namespace

TipCycle cycle_of_turns(MixedMode rule, std::span<const Modes> one, std::span<const Modes> other,
                        double poissons_ratio) {
  double largest = 0.0;
  for (const std::span<const Modes> turn : {one, other})
    for (const Modes& K : turn) largest = std::max(largest, equivalent_of(rule, K, poissons_ratio));
  if (!(largest > 0)) return {};
  const double range = widest_range(rule, one, other, poissons_ratio).range;
  return {.largest = largest, .ratio = 1 - range / largest};  // (GR-31)
}

std::vector<CycleWithinTurn> cycles_within_turn(MixedMode rule, std::span<const Modes> turn,
                                                int waves, double poissons_ratio) {
  const WidestRange widest = widest_range(rule, turn, turn, poissons_ratio);
  if (!(widest.range > 0)) return {};
  std::vector<double> along = along_widest(turn, widest);
  // The turn is closed, and begins and ends at its largest value.
  const auto begin =
      static_cast<std::size_t>(std::max_element(along.begin(), along.end()) - along.begin());
  std::rotate(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(begin), along.end());
  along.push_back(along.front());
  std::vector<CountedCycle> counted;
  const auto take = [&](const CountedCycle& cycle) { counted.push_back(cycle); };
  RainflowCounter counter;
  counter.add(along, take);
  counter.finish(Residue::half_cycles, take);
  std::stable_sort(
      counted.begin(), counted.end(),
      [](const CountedCycle& a, const CountedCycle& b) { return a.range() > b.range(); });
  double of_waves = waves;  // the widest cycles, which count as waves
  std::vector<CycleWithinTurn> smaller;
  const auto at = [&](const Reversal& reversal) -> const Modes& {
    return turn[(begin + static_cast<std::size_t>(reversal.place)) % turn.size()];
  };
  for (const CountedCycle& cycle : counted) {
    const double taken = std::min(of_waves, cycle.count);
    of_waves -= taken;
    const TipCycle of = tip_cycle(rule, at(cycle.from), at(cycle.to), poissons_ratio);
    if (cycle.count > taken && of.full_range() > 0)
      smaller.push_back({.cycle = of, .count = (cycle.count - taken) / waves});
  }
  return smaller;
}

double missed_between_angles(MixedMode rule, std::span<const Modes> turn,
                             std::span<const double> angles, double poissons_ratio) {
  const WidestRange widest = widest_range(rule, turn, turn, poissons_ratio);
  if (!(widest.range > 0)) return 0.0;
  const std::vector<double> along = along_widest(turn, widest);
  const std::size_t n = turn.size();
  // How far the parabola through an extreme and its two neighbours goes beyond it.
  const auto beyond = [&](std::size_t k) {
    const double left = k == 0 ? angles[n] - angles[n - 1] : angles[k] - angles[k - 1];
    const double right = angles[k + 1] - angles[k];
    const double to_left = (along[(k + n - 1) % n] - along[k]) / left;
    const double to_right = (along[(k + 1) % n] - along[k]) / right;
    const double curvature = (to_left + to_right) / (left + right);
    const double slope = to_right - curvature * right;
    return curvature == 0 ? 0.0 : std::abs(slope * slope / (4 * curvature));
  };
  const auto [least, most] = std::minmax_element(along.begin(), along.end());
  return (beyond(static_cast<std::size_t>(least - along.begin())) +
          beyond(static_cast<std::size_t>(most - along.begin()))) /
         (*most - *least);
}

}  // namespace strainwave

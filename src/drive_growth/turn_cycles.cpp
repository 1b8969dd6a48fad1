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

WidestRange widest_range(MixedMode rule, std::span<const Modes> one, std::span<const Modes> other,
                         double nu) {
  WidestRange widest;
  const bool same = one.data() == other.data();
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t j = same ? i + 1 : 0; j < other.size(); ++j) {
      Modes range{};
      for (std::size_t mode = 0; mode < range.size(); ++mode)
        range[mode] = std::abs(one[i][mode] - other[j][mode]);
      const double here = equivalent_of(rule, range, nu);
      if (here > widest.range) widest = {.range = here, .from = one[i], .to = other[j]};
    }
  return widest;
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
  std::vector<double> along;  // (GR-31)
  for (const Modes& K : turn) {
    double sum = 0.0;
    for (std::size_t mode = 0; mode < K.size(); ++mode)
      sum += K[mode] * (widest.from[mode] - widest.to[mode]);
    along.push_back(sum);
  }
  // The turn is closed, and begins and ends at its largest value.
  const auto begin = static_cast<std::size_t>(std::max_element(along.begin(), along.end()) -
                                              along.begin());
  std::rotate(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(begin), along.end());
  along.push_back(along.front());
  std::vector<CountedCycle> counted;
  const auto take = [&](const CountedCycle& cycle) { counted.push_back(cycle); };
  RainflowCounter counter;
  counter.add(along, take);
  counter.finish(Residue::half_cycles, take);
  std::stable_sort(counted.begin(), counted.end(), [](const CountedCycle& a, const CountedCycle& b) {
    return a.range() > b.range();
  });
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

}  // namespace strainwave

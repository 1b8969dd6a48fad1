// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/interaction.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Skipped repetitions in one part over those between two peaks, per unit of the share: a quarter
/// at a share of 0.01.
constexpr double kPartsPerShare = 25;

/// A tip that moves through the zone of the overload that governs.
class TipBehindOverload {
 public:
  TipBehindOverload(const GrowingCrack& crack, double crack_size, const Interaction& interaction,
                    double share)
      : crack_(crack),
        size_(crack_size),
        rule_(interaction),
        zone_{.yield_strength = crack.yield_strength(), .factor = interaction.zone_factor},
        share_(share) {
    // The threshold of K_max is that of R = 0, so it is the same for all cycles.
    if (interaction.rule == InteractionRule::willenborg)
      threshold_ = crack.threshold({.largest = 1.0, .ratio = 0.0}, crack_size).value_or(0.0);
  }

  /// Distance that the tip has moved [m].
  [[nodiscard]] double moved() const { return moved_; }

  /// Applies equal cycles.
  void apply(const TipLoad& load, double count) {
    const double own_zone = zone_.size(load.cycle.largest);
    double left = count;
    while (left > 0) {
      const bool governs = size_ + moved_ + own_zone >= zone_end();
      double rate = governs ? rate_of(load.cycle) : retarded_rate(load.cycle, moved_);
      if (governs) {
        moved_ += left * rate;
        overload_ = {.crack_size = size_ + moved_, .largest = load.cycle.largest};
        return;
      }
      if (!(rate > 0)) return;
      // The zone shrinks while the tip moves, so the cycles go on in parts, each with the rate in
      // its middle.
      const double rest = zone_end() - size_ - moved_;
      const double part = std::min(left, std::max(1.0, std::floor(share_ * rest / rate)));
      if (part > 1) {
        const double middle = moved_ + (part - 1) * rate / 2;  // a cycle has the rate of its begin
        rate = size_ + middle + own_zone < zone_end() ? retarded_rate(load.cycle, middle)
                                                      : rate_of(load.cycle);
      }
      moved_ += part * rate;
      left -= part;
    }
  }

  /// Goes on by repetitions that each move the tip by the same distance.
  /// @param refreshed  whether each repetition has its own overload
  void jump(double repetitions, double distance, bool refreshed) {
    moved_ += repetitions * distance;
    if (refreshed) overload_.crack_size += repetitions * distance;
  }

  [[nodiscard]] double zone_of_overload() const { return zone_.size(overload_.largest); }
  [[nodiscard]] double overload_place() const { return overload_.crack_size; }

 private:
  [[nodiscard]] double zone_end() const { return overload_.crack_size + zone_of_overload(); }
  [[nodiscard]] double rate_of(const TipCycle& cycle) const { return crack_.rate_of(cycle, size_); }
  [[nodiscard]] double retarded_rate(const TipCycle& cycle, double moved) const {
    if (rule_.rule == InteractionRule::wheeler)
      return rate_of(cycle) *
             wheeler_factor(zone_, overload_, size_ + moved, cycle.largest, rule_.wheeler_exponent);
    return rate_of(willenborg_cycle({.zone = zone_,
                                     .threshold = threshold_,
                                     .shut_off_ratio = rule_.shut_off_ratio,
                                     .negative = rule_.negative},
                                    overload_, size_ + moved, cycle));
  }

  const GrowingCrack& crack_;
  double size_;
  const Interaction& rule_;
  PlasticZone zone_;
  double share_;
  double threshold_ = 0.0;
  double moved_ = 0.0;
  Overload overload_;
};

}  // namespace

double growth_with_interaction(const GrowingCrack& crack, std::span<const TipLoad> loads,
                               double crack_size, const Interaction& interaction, double share) {
  if (std::isinf(crack.rate_of(GrowingCrack::governing(loads), crack_size)))
    return std::numeric_limits<double>::infinity();
  if (interaction.rule == InteractionRule::none) return crack.growth(loads, crack_size);
  // (GR-27): peaks that come less than once in a repetition, and the repetitions between them.
  double rarest = 1.0;
  for (const TipLoad& load : loads)
    if (load.rare) rarest = std::min(rarest, load.count);
  const double repetitions = 1 / rarest;
  TipBehindOverload tip(crack, crack_size, interaction, share);
  const auto repeat = [&] {
    for (const TipLoad& load : loads)
      if (!load.rare) tip.apply(load, load.count);
  };
  const auto peaks = [&] {
    for (const TipLoad& load : loads)
      if (load.rare) tip.apply(load, load.count * repetitions);
  };
  if (rarest == 1.0) {
    // The largest cycle governs whenever it comes, so a repetition that begins behind it needs no
    // other one before it.
    const auto largest =
        std::ranges::max_element(loads, {}, [](const TipLoad& load) { return load.cycle.largest; });
    tip.apply(*largest, largest->count);
    const double begin = tip.moved();
    for (auto load = std::next(largest); load != loads.end(); ++load) tip.apply(*load, load->count);
    for (auto load = loads.begin(); load != std::next(largest); ++load)
      tip.apply(*load, load->count);
    return tip.moved() - begin;
  }
  // The first pass brings the overload that acts when the second one begins.
  repeat();
  peaks();
  const double begin = tip.moved();
  double left = repetitions;
  while (left > 0) {
    const double place = tip.overload_place();
    const double before = tip.moved();
    repeat();
    left -= 1;
    const double distance = tip.moved() - before;
    if (!(left > 0)) break;
    if (!(distance > 0)) break;
    const bool refreshed = tip.overload_place() != place;
    const double allowed = refreshed ? left : share * tip.zone_of_overload() / distance;
    // At least some parts lie between two peaks, and halving the share doubles their number.
    const double part = refreshed ? left : kPartsPerShare * share * repetitions;
    const double jump = std::min(left, std::floor(std::min(allowed, part)));
    if (jump > 0) {
      tip.jump(jump, distance, refreshed);
      left -= jump;
    }
  }
  peaks();
  return (tip.moved() - begin) / repetitions;
}

}  // namespace strainwave

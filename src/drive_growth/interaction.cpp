// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/interaction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <variant>

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
    if (interaction.rule == InteractionRule::closure) closure_ = closure_of(crack, interaction);
    if (interaction.rule == InteractionRule::willenborg)
      threshold_ = crack.threshold({.largest = 1.0, .ratio = 0.0}, crack_size).value_or(0.0);
  }

  /// Distance that the tip has moved [m].
  [[nodiscard]] double moved() const { return moved_; }

  /// Applies equal cycles.
  void apply(const TipLoad& load, double count) {
    const double own_zone = zone_.size(load.cycle.largest);
    const double least = load.least_of_cycle();
    double left = count;
    while (left > 0) {
      const bool governs = size_ + moved_ + own_zone >= zone_end();
      if (!governs) overload_.least = std::min(overload_.least, least);
      double rate = governs ? rate_of(load.cycle) : retarded_rate(load.cycle, moved_);
      if (governs) {
        moved_ += left * rate;
        overload_ = {.crack_size = size_ + moved_, .largest = load.cycle.largest, .least = least};
        return;
      }
      if (!(rate > 0)) return;
      // The zone shrinks while the tip moves, so the cycles go on in parts, each with the rate in
      // its middle.
      const double rest = this->rest();
      if (rule_.rule == InteractionRule::closure) {
        // The opening is held, so the rate is the same up to the cycle that governs.
        const double part = std::min(left, std::max(1.0, std::ceil((rest - own_zone) / rate)));
        moved_ += part * rate;
        left -= part;
        continue;
      }
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
    // Rounding must not place the overload ahead of the tip.
    if (refreshed)
      overload_.crack_size =
          std::min(overload_.crack_size + repetitions * distance, size_ + moved_);
  }

  [[nodiscard]] double zone_of_overload() const { return zone_.size(overload_.largest); }
  [[nodiscard]] const Overload& overload() const { return overload_; }
  /// What is left of the overload's zone beyond the tip [m].
  [[nodiscard]] double rest() const { return zone_end() - size_ - moved_; }
  [[nodiscard]] double zone_of(double K) const { return zone_.size(K); }

 private:
  [[nodiscard]] double zone_end() const { return overload_.crack_size + zone_of_overload(); }
  [[nodiscard]] double rate_of(const TipCycle& cycle) const { return crack_.rate_of(cycle, size_); }
  [[nodiscard]] double retarded_rate(const TipCycle& cycle, double moved) const {
    if (rule_.rule == InteractionRule::wheeler)
      return rate_of(cycle) *
             wheeler_factor(zone_, overload_, size_ + moved, cycle.largest, rule_.wheeler_exponent);
    if (rule_.rule == InteractionRule::closure)
      return rate_of(closure_cycle(zone_, closure_, overload_, size_ + moved, cycle));
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
  NewmanClosure closure_;
  double moved_ = 0.0;
  Overload overload_;
};

}  // namespace

bool has_own_closure(const GrowingCrack& crack) {
  return std::holds_alternative<Nasgro>(crack.law());
}

NewmanClosure closure_of(const GrowingCrack& crack, const Interaction& interaction) {
  if (const auto* const law = std::get_if<Nasgro>(&crack.law())) return law->closure;
  if (!interaction.closure)
    throw InputError("interaction.closure",
                     fmt::format("must be given for {}, because its law has no crack opening of "
                                 "its own: give --constraint and --stress-level",
                                 crack.crack().path));
  return *interaction.closure;
}

double growth_with_interaction(const GrowingCrack& crack, std::span<const TipLoad> loads,
                               double crack_size, const Interaction& interaction, double share) {
  if (std::isinf(crack.rate_of(GrowingCrack::governing(loads), crack_size)))
    return std::numeric_limits<double>::infinity();
  if (interaction.rule == InteractionRule::none) return crack.growth(loads, crack_size);
  // (GR-27): peaks that come less than once in a repetition, and the repetitions between them.  The
  // further cycles of a peak have counts of their own.
  double rarest = 1.0;
  for (const TipLoad& load : loads)
    if (load.rare && !load.further) rarest = std::min(rarest, load.count);
  const double repetitions = 1 / rarest;
  TipBehindOverload tip(crack, crack_size, interaction, share);
  const auto repeat = [&](double part) {
    for (const TipLoad& load : loads)
      if (!load.rare) tip.apply(load, part * load.count);
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
  repeat(1.0);
  peaks();
  const double begin = tip.moved();
  double left = repetitions;
  double widest_zone = 0.0;  // of a cycle that comes in each repetition
  for (const TipLoad& load : loads)
    if (!load.rare) widest_zone = std::max(widest_zone, tip.zone_of(load.cycle.largest));
  bool was_refreshed = false;
  while (left > 0) {
    const Overload overload = tip.overload();
    const double before = tip.moved();
    const double part = std::min(left, 1.0);  // the number between two peaks need not be whole
    repeat(part);
    left -= part;
    const double distance = tip.moved() - before;
    if (!(left > 0)) break;
    const bool refreshed = tip.overload().crack_size != overload.crack_size;
    // The first repetition behind a peak, or behind its zone, differs from those that follow.
    const bool settled = refreshed == was_refreshed && tip.overload().least == overload.least;
    was_refreshed = refreshed;
    if (!settled) continue;
    if (!(distance > 0)) break;
    double allowed = left;
    if (!refreshed && interaction.rule == InteractionRule::closure)
      allowed = (tip.rest() - widest_zone) / distance;  // all the same up to the end of the zone
    else if (!refreshed)
      // At least some parts lie between two peaks, and halving the share doubles their number.
      allowed =
          std::min(share * tip.zone_of_overload() / distance, kPartsPerShare * share * repetitions);
    const double jump = std::min(left, std::floor(allowed));
    if (jump > 0) {
      tip.jump(jump, distance, refreshed);
      left -= jump;
    }
  }
  peaks();
  return (tip.moved() - begin) / repetitions;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/growing_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/drive_growth/turn_cycles.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

ModeFactors as_factors(const Modes& K) { return {.I = K[0], .II = K[1], .III = K[2]}; }

/// Materials of the library that have a law, for a message.
std::string records_with_laws() {
  std::string known;
  for (const MaterialRecord& record : material_library())
    if (!record.growth.empty()) known += (known.empty() ? "" : ", ") + record.name;
  return known;
}

const Material& material_of_crack(const GearSet& gear, const DriveCrack& crack) {
  const std::string member = crack.path.substr(0, crack.path.find('.'));
  return material_of(gear, crack.material, member + ".material");
}

/// The law that is chosen for a crack, or that of its material.
RateLaw law_of_crack(const GearSet& gear, const DriveCrack& crack, const RateChoice& choice) {
  const Material& material = material_of_crack(gear, crack);
  if (crack.laminate && choice.mixed_mode != MixedMode::energy)
    throw InputError("mixed_mode",
                     fmt::format("must be energy, because {} is in a laminate, whose modes are "
                                 "those of the energy release rate",
                                 crack.path));
  if (choice.law.empty() && material.growth.empty())
    throw InputError(
        (FieldPath("material") / crack.material / "growth").text(),
        fmt::format("must be given for the growth of {}; the library has laws for {}, which "
                    "--law NAME takes",
                    crack.path, records_with_laws()));
  RateLaw law =
      choice.law.empty() ? material.growth.front() : rate_law(require_material(choice.law));
  if (crack.through_thickness > 0 && !crack.laminate)
    law = law_of_through_crack(law, crack.through_thickness, material.yield_strength);
  return law;
}

/// Which of the phases and points of a cycle counts: the one with the fastest growth; without
/// growth the one with the widest range; among equal ones the one with the largest K_max.
class WorstPoint {
 public:
  void take(const TipCycle& at, double rate, double least) {
    if (at.largest > load_.largest.largest) load_.largest = at;
    if (rate < fastest_ && !equal(rate, fastest_)) return;
    if (rate == 0) load_.least = std::min(load_.least.value_or(least), least);
    if (equal(rate, fastest_) && !goes_before(at)) return;
    fastest_ = std::max(rate, fastest_);
    load_.cycle = at;
    if (rate > 0) load_.least = least;
  }
  [[nodiscard]] TipLoad load(const LoadCycle& of) const {
    TipLoad load = load_;
    load.count = of.count;
    load.step = of.step;
    load.rare = of.rare;
    load.further = of.further;
    return load;
  }

 private:
  /// Whether two numbers differ by rounding at most.
  static bool equal(double one, double other) {
    constexpr double kRounding = 1e-9;
    return one == other ||
           std::abs(one - other) < kRounding * std::max(std::abs(one), std::abs(other));
  }
  /// Whether a cycle of the same rate goes before the one that counts so far.
  [[nodiscard]] bool goes_before(const TipCycle& at) const {
    const double range = at.full_range();
    const double so_far = load_.cycle.full_range();
    return equal(range, so_far) ? at.largest > load_.cycle.largest : range > so_far;
  }

  TipLoad load_;
  double fastest_ = 0.0;
};

/// A crack of the bearing at each torque of the duty, because K is not proportional to the torque.
CracksAtTorques race_at_torques(const GearSet& gear, const DriveCrack& crack,
                                const DutyHistory& history) {
  CracksAtTorques made;
  for (const double torque : torques_of(history, true)) {
    if (torque == 0) continue;
    GearSet at = gear;
    at.load.torque = torque;
    for (DriveCrack& other : drive_cracks(at))
      if (other.path == crack.path) made.emplace_back(torque, std::move(other));
  }
  return made;
}

}  // namespace

TipCycle tip_cycle(MixedMode rule, const Modes& from, const Modes& to, double poissons_ratio) {
  const auto equivalent = [&](const Modes& K) {
    return equivalent_factor(rule, as_factors(K), poissons_ratio);
  };
  const double largest = std::max(equivalent(from), equivalent(to));
  if (!(largest > 0)) return {};
  Modes range{};
  for (std::size_t mode = 0; mode < range.size(); ++mode)
    range[mode] = std::abs(from[mode] - to[mode]);
  return {.largest = largest, .ratio = 1 - equivalent(range) / largest};  // (GR-22)
}

double least_factor(MixedMode rule, const TipCycle& cycle, std::span<const Modes> one,
                    std::span<const Modes> other, double poissons_ratio) {
  if (cycle.largest > 0) return cycle.ratio * cycle.largest;
  double pressed = 0.0;
  for (const std::span<const Modes> moments : {one, other})
    for (const Modes& K : moments)
      pressed = std::max(
          pressed,
          equivalent_factor(rule, as_factors({std::abs(K[0]), std::abs(K[1]), std::abs(K[2])}),
                            poissons_ratio));
  return -pressed;
}

RateChoice choice_of(const DriveCrack& crack, RateChoice choice) {
  if (crack.laminate) choice.law.clear();
  return choice;
}

bool has_law(const GearSet& gear, const DriveCrack& crack) {
  return !material_of_crack(gear, crack).growth.empty();
}

GrowingCrack::GrowingCrack(const GearSet& gear, DriveCrack crack, const DutyHistory& history,
                           const RateChoice& choice, CracksAtTorques at_torque)
    : crack_(std::move(crack)),
      at_torque_(crack_.turning == TurningLoad::balls ? race_at_torques(gear, crack_, history)
                                                      : std::move(at_torque)),
      duty_(crack_duty(gear, crack_, history, at_torque_)),
      law_(law_of_crack(gear, crack_, choice)),
      mixed_mode_(choice.mixed_mode) {
  const Material& material = material_of_crack(gear, crack_);
  // The rule of energy does not ask for it in a laminate, which has no mode III.
  poissons_ratio_ = crack_.laminate ? 0.0 : elastic_constants(material).nu;
  yield_strength_ = material.yield_strength;
  const std::optional<GrowthBounds> bounds =
      choice.law.empty() ? material.growth_bounds : growth_bounds(require_material(choice.law));
  if (bounds) {
    limits_.threshold = bounds->threshold;
    limits_.intrinsic_size = bounds->short_crack_size;
  }
  if (!law_.toughness()) limits_.toughness = crack_.toughness;
}

std::span<const Tip> GrowingCrack::tips() const {
  static constexpr std::array<Tip, 2> kBoth = {Tip::depth, Tip::length};
  const bool keeps_shape = crack_.turn_table && crack_.turn_table->aspect_ratios.empty();
  const bool surface = crack_.kind == "surface" && !keeps_shape;
  return surface ? std::span<const Tip>(kBoth) : std::span<const Tip>(kBoth).first(1);
}

CrackFactors GrowingCrack::factors(const CrackSize& size) const {
  const bool bent = std::ranges::any_of(duty_.cycle, [](const LoadCycle& cycle) {
    return cycle.from.bending_moment != 0 || cycle.to.bending_moment != 0;
  });
  // Two tips are the ends of the front.
  return {crack_, at_torque_, size, bent,
          tips().size() == 1 ? FrontPoints::all : FrontPoints::ends};
}

std::pair<std::size_t, std::size_t> GrowingCrack::points_of(Tip tip, std::size_t points) const {
  // A surface crack grows at its deepest point and at the surface; any other one by its worst
  // point.
  if (tips().size() == 1) return {0, points};
  return tip == Tip::depth ? std::pair{points - 1, points}
                           : std::pair{std::size_t{0}, std::size_t{1}};
}

std::vector<std::vector<TipLoad>> GrowingCrack::loads(const CrackSize& size, double factor) const {
  const CrackFactors K = factors(size);
  std::vector<std::vector<TipLoad>> result;
  for (const Tip tip : tips()) {
    const std::pair<std::size_t, std::size_t> points = points_of(tip, K.points());
    std::vector<TipLoad>& at_tip = result.emplace_back();
    at_tip.reserve(duty_.cycle.size());
    for (const LoadCycle& cycle : duty_.cycle) {
      if (K.has_turn()) {
        add_turn(at_tip, K, points, cycle, size, factor);
        continue;
      }
      // The load that turns may meet the constant loads in either phase.
      LoadState from = cycle.from;
      LoadState to = cycle.to;
      const bool one_phase = !from.turns() && !to.turns();
      const bool alone = one_phase && points.second - points.first == 1;
      WorstPoint worst;
      for (int phase = 0; phase < (one_phase ? 1 : 2); ++phase) {
        for (std::size_t i = points.first; i < points.second; ++i) {
          const std::array<Modes, 2> ends = {K.at(i, from, factor), K.at(i, to, factor)};
          const TipCycle at = tip_cycle(mixed_mode_, ends[0], ends[1], poissons_ratio_);
          worst.take(at, alone ? 0.0 : rate_of(at, size.size),
                     least_factor(mixed_mode_, at, ends, {}, poissons_ratio_));
        }
        std::swap(from.assembly, to.assembly);
        from.bending_moment = -from.bending_moment;
        to.bending_moment = -to.bending_moment;
      }
      at_tip.push_back(worst.load(cycle));
    }
  }
  return result;
}

void GrowingCrack::add_turn(std::vector<TipLoad>& to, const CrackFactors& K,
                            std::pair<std::size_t, std::size_t> points, const LoadCycle& cycle,
                            const CrackSize& size, double factor) const {
  WorstPoint worst;
  std::vector<CycleWithinTurn> within;
  double fastest = -1.0;
  for (std::size_t i = points.first; i < points.second; ++i) {
    const std::vector<Modes> one = K.over_turn(i, cycle.from.torque * factor);
    if (cycle.within_wave) {
      std::vector<CycleWithinTurn> here = cycles_within_turn(
          mixed_mode_, one, waves_of(*crack_.turn_table, crack_.wave_number), poissons_ratio_);
      double rate = 0.0;
      for (const CycleWithinTurn& of : here) rate += of.count * rate_of(of.cycle, size.size);
      if (rate <= fastest) continue;
      fastest = rate;
      within = std::move(here);
      continue;
    }
    const bool same = cycle.from.torque == cycle.to.torque;
    const std::vector<Modes> other =
        same ? std::vector<Modes>() : K.over_turn(i, cycle.to.torque * factor);
    const TipCycle at = cycle_of_turns(mixed_mode_, one, same ? one : other, poissons_ratio_);
    worst.take(at, rate_of(at, size.size),
               least_factor(mixed_mode_, at, one, other, poissons_ratio_));
  }
  if (!cycle.within_wave) to.push_back(worst.load(cycle));
  for (const CycleWithinTurn& of : within)
    to.push_back({.cycle = of.cycle,
                  .count = cycle.count * of.count,
                  .step = cycle.step,
                  .rare = cycle.rare,
                  .further = cycle.further});
}

double GrowingCrack::rate_of(const TipCycle& cycle, double crack_size) const {
  GrowthLimits limits = limits_;
  limits.toughness.reset();  // a law without its own toughness stays smooth up to the event
  if (!(cycle.ratio < 1)) {  // K stands still
    const TipCycle once{.largest = cycle.largest};
    return growth_rate(law_, once, crack_size, limits).state == TipState::breaks
               ? std::numeric_limits<double>::infinity()
               : 0.0;
  }
  const GrowthRate rate = growth_rate(law_, cycle, crack_size, limits);
  if (rate.state == TipState::breaks) return std::numeric_limits<double>::infinity();
  if (deviation_.exponent == 0) return factor_ * rate.per_cycle;  // (GS-12)
  return factor_ * std::pow(cycle.full_range() / deviation_.pivot, deviation_.exponent) *
         rate.per_cycle;  // (GS-12)
}

void GrowingCrack::deviate(const RateDeviation& deviation) {
  deviation_ = deviation;
  factor_ = std::exp(deviation.logarithm);  // (GS-12)
}

double GrowingCrack::growth(std::span<const TipLoad> loads, double crack_size) const {
  if (law_.toughness() && governing(loads).largest >= *law_.toughness())
    return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const TipLoad& load : loads)  // (GR-23)
    sum += load.count * rate_of(load.cycle, crack_size);
  return sum;
}

double GrowingCrack::yield_strength() const {
  if (crack_.laminate)
    throw InputError("interaction",
                     fmt::format("must be none, because {} is in a laminate, where no plastic zone "
                                 "slows the growth down behind an overload",
                                 crack_.path));
  if (!yield_strength_)
    throw InputError(
        (FieldPath("material") / crack_.material / "yield_strength").text(),
        "must be given: the plastic zone behind an overload depends on the yield strength");
  return *yield_strength_;
}

TipCycle GrowingCrack::governing(std::span<const TipLoad> loads) {
  TipCycle largest;
  for (const TipLoad& load : loads)
    if (load.governing().largest > largest.largest) largest = load.governing();
  return largest;
}

TipCycle GrowingCrack::widest(std::span<const TipLoad> loads) const {
  TipCycle widest;
  for (const TipLoad& load : loads)
    if (load.cycle.full_range() > widest.full_range()) widest = load.cycle;
  return widest;
}

std::optional<double> GrowingCrack::threshold(const TipCycle& cycle, double crack_size) const {
  std::optional<double> highest = law_.threshold(cycle.ratio, crack_size);
  if (limits_.threshold)
    highest = std::max(
        highest.value_or(0.0),
        *limits_.threshold * std::sqrt(crack_size / (crack_size + limits_.intrinsic_size)));
  return highest;
}

Modes GrowingCrack::worst_factors(const CrackSize& size) const {
  const CrackFactors K = factors(size);
  const std::pair<std::size_t, std::size_t> points = points_of(Tip::depth, K.points());
  Modes worst{};
  double largest = 0.0;
  for (const LoadCycle& cycle : duty_.cycle)
    for (const LoadState* const state : {&cycle.from, &cycle.to})
      for (std::size_t i = points.first; i < points.second; ++i)
        for (const Modes& here :
             K.has_turn() ? K.over_turn(i, state->torque) : std::vector<Modes>{K.at(i, *state)}) {
          const double equivalent =
              equivalent_factor(mixed_mode_, as_factors(here), poissons_ratio_);
          if (equivalent <= largest) continue;
          largest = equivalent;
          worst = here;
        }
  return worst;
}

bool GrowingCrack::breaks(const CrackSize& size, double factor) const {
  for (const std::vector<TipLoad>& at_tip : loads(size, factor))
    for (const TipLoad& load : at_tip) {
      const TipCycle& of = load.governing();
      const TipCycle reached = of.ratio < 1 ? of : TipCycle{.largest = of.largest};
      if (growth_rate(law_, reached, size.size, limits_).state == TipState::breaks) return true;
    }
  return false;
}

double GrowingCrack::largest_factor() const {
  double largest = std::numeric_limits<double>::infinity();
  if (!crack_.turn_table) return largest;
  for (const LoadCycle& cycle : duty_.cycle)
    for (const double torque : {cycle.from.torque, cycle.to.torque})
      if (torque != 0) largest = std::min(largest, turn_load_range(*crack_.turn_table, torque)[1]);
  return largest;
}

double GrowingCrack::missed_by_angles() const {
  if (!crack_.turn_table) return 0.0;
  const CrackFactors K = factors(crack_.size);
  double missed = 0.0;
  for (const LoadCycle& cycle : duty_.cycle)
    for (std::size_t i = 0; i < K.points(); ++i)
      missed =
          std::max(missed, missed_between_angles(mixed_mode_, K.over_turn(i, cycle.from.torque),
                                                 crack_.turn_table->angles, poissons_ratio_));
  return missed;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/grow_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "bent_shaft.hpp"
#include "coupled_crack.hpp"
#include "notes.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/crack_group/merged_crack.hpp"
#include "strainwave/drive_cracks/shaft_group.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/drive_growth/crack_sizes.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/drive_growth/longest_duty.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/model/input/check_rules.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/crack_reserves.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kLongestStep = 0.05;  // of a path in ln(size) [-]
constexpr double kShortestStep = 1e-13;
constexpr std::size_t kCoupledRows = 12;  // rows with the coupled drive
constexpr double kSevered = 0.01;    // share of the stiffness below which a drive is severed [-]
constexpr double kFirstJump = 1e-9;  // of a path, over a place where a rate jumps
constexpr double kLongestJump = 1e-3;
constexpr double kShareOfZone = 0.01;  // by which a tip advances behind an overload in one step [-]
constexpr double kNoTorque = 1e-9;     // of the torque of the file, where none acts [-]
constexpr double kAssessmentStep = 0.02;  // path between two failure assessments [-]

using State = std::vector<double>;  // ln of the size of each tip, then repetitions
using Stepper = boost::numeric::odeint::runge_kutta_dopri5<State>;

/// The stiffness under the softer sense of torque [N*m/rad].
double softer_stiffness(const SeriesCompliance<double>& of) {
  return std::min(of.positive_stiffness(), of.negative_stiffness());
}
double softer_stiffness(const GearSet& gear) {
  return softer_stiffness(series_compliance<double>(gear));
}

/// The steps of the duty and its peaks that the failure assessment looks at: those that no other
/// step exceeds in torque, axial force and bending moment together (GR-40).
std::vector<DutyStep> heaviest_steps(const DutyHistory& history) {
  std::vector<DutyStep> steps = history.steps;
  for (const DutyMomentaryPeak& peak : history.peaks) steps.push_back(peak.step);
  std::erase_if(steps, [](const DutyStep& step) {
    return step.torque == 0 && step.axial_force == 0 && step.bending_moment == 0;
  });
  // A step of the front exceeds every other one, and each comes after those that exceed it.
  const auto front = [&](double sign) {
    std::ranges::stable_sort(steps, {}, [&](const DutyStep& step) {
      return std::tuple(-std::abs(step.torque), step.torque, -sign * step.axial_force,
                        -std::abs(step.bending_moment));
    });
    std::vector<DutyStep> kept;
    for (const DutyStep& step : steps)
      if (std::ranges::none_of(kept, [&](const DutyStep& other) {
            return other.torque * step.torque >= 0 &&
                   std::abs(other.torque) >= std::abs(step.torque) &&
                   std::abs(other.bending_moment) >= std::abs(step.bending_moment) &&
                   sign * other.axial_force >= sign * step.axial_force;
          }))
        kept.push_back(step);
    return kept;
  };
  std::vector<DutyStep> heaviest = front(1);
  // Of two steps in compression, the weaker one may press the faces less, and both count.
  for (const DutyStep& step : front(-1))
    if (step.axial_force < 0 && std::ranges::none_of(heaviest, [&](const DutyStep& known) {
          return known.torque == step.torque && known.axial_force == step.axial_force &&
                 std::abs(known.bending_moment) == std::abs(step.bending_moment);
        }))
      heaviest.push_back(step);
  return heaviest;
}

/// The cracks of a drive on their common path.
class Growing {
 public:
  /// @param drawn  how the rates deviate from the laws; null: not at all
  Growing(const GearSet& gear, const GrowthOptions& options, GrowthReport& report,
          double step_factor, const DrawnGrowth* drawn = nullptr)
      : gear_(gear),
        options_(options),
        report_(report),
        step_factor_(step_factor),
        history_(duty_history(gear)),
        at_flexspline_(at_flexspline(history_)),
        heaviest_(heaviest_steps(history_)) {
    check(gear_);
    take_scratch();
    first_stiffness_ = softer_stiffness(sized_);
    if (drawn != nullptr) deviating_.emplace(gear, drive_cracks(gear), *drawn);
    take_cracks();
    const double factor = amplification(start(0.0));
    for (const GrowingCrack& crack : cracks_)
      if (factor > crack.largest_factor())
        throw InputError(
            "duty.resonance",
            fmt::format("multiplies the loads of {} by {:.4g}, beyond the torques of {}; "
                        "compute K up to these loads, or leave out duty.resonance",
                        crack.crack().path, factor, crack.crack().turn_table->file));
  }

  [[nodiscard]] const GearSet& gear() const { return gear_; }
  [[nodiscard]] const std::vector<GrowingCrack>& cracks() const { return cracks_; }
  [[nodiscard]] bool none() const { return cracks_.empty(); }

  /// Time of a repetition [s].
  [[nodiscard]] double duration() const { return history_.duration; }

  [[nodiscard]] State start(double repetitions) const {
    State state;
    for (const GrowingCrack& crack : cracks_)
      for (const Tip tip : crack.tips())
        state.push_back(std::log(tip == Tip::depth ? crack.crack().size.size
                                                   : crack.crack().size.half_length()));
    state.push_back(repetitions);
    return state;
  }

  /// Size of one crack; a crack is not deeper than half its length.
  [[nodiscard]] CrackSize size_of(const State& state, std::size_t k) const {
    const std::size_t at = first_[k];
    const double end = cracks_[k].crack().range_end;
    const double a = std::min(std::exp(state[at]), end);
    if (cracks_[k].tips().size() == 1)
      return {.size = a, .aspect_ratio = cracks_[k].crack().size.aspect_ratio};
    double c = std::max(std::exp(state[at + 1]), a);
    if (const auto& longest = cracks_[k].crack().longest) c = std::min(c, longest(a));
    c = std::min(c, cracks_[k].crack().length_end);
    if (const auto& table = cracks_[k].crack().turn_table)
      c = std::clamp(c, a / table->aspect_ratios.back(), a / table->aspect_ratios.front());
    return CrackSize::of(a, c);
  }

  /// Gives the cracks of groups the sizes of a state, at which K of each one contains the others
  /// (CG-9), (CG-12).
  void take_sizes(const State& state) const {
    for (std::size_t k = 0; k < cracks_.size(); ++k)
      if (const DriveCrack& crack = cracks_[k].crack(); crack.group)
        crack.group->set_half_length(crack.in_group, size_of(state, k).size);
      else if (crack.shaft_group)
        crack.shaft_group->cracks[crack.in_shaft_group].depth = size_of(state, k).size;
  }
  /// The annular cracks that shield each other at the sizes of a state; empty: none do.
  [[nodiscard]] ShaftGroup annular(const State& state) const {
    take_sizes(state);
    for (const GrowingCrack& crack : cracks_)
      if (crack.crack().shaft_group) return *crack.crack().shaft_group;
    return {};
  }
  /// The groups at the sizes of a state, each once.
  [[nodiscard]] std::vector<WallGroup> groups(const State& state) const {
    take_sizes(state);
    std::vector<WallGroup> result;
    std::vector<const WallGroup*> known;
    for (const GrowingCrack& crack : cracks_) {
      const WallGroup* const group = crack.crack().group.get();
      if (group == nullptr || std::ranges::find(known, group) != known.end()) continue;
      known.push_back(group);
      result.push_back(*group);
    }
    return result;
  }

  /// Factor D of the vibration on the loads of the duty; (GR-28).
  [[nodiscard]] double amplification(const State& state) const {
    const auto& resonance = gear_.duty->resonance;
    if (!resonance) return 1.0;
    try {
      return strainwave::amplification(*resonance, first_stiffness_ / stiffness_at(state));
    } catch (const InputError&) {  // a trial beyond the end that `end_at` finds
      return 1.0;
    }
  }

  /// Relative growth of each tip in one repetition.
  [[nodiscard]] State rates(const State& state) const {
    State rate;
    take_sizes(state);
    const double factor = amplification(state);
    for (std::size_t k = 0; k < cracks_.size(); ++k) {
      const CrackSize size = size_of(state, k);
      const auto loads = cracks_[k].loads(size, std::min(factor, cracks_[k].largest_factor()));
      for (std::size_t t = 0; t < loads.size(); ++t) {
        const double grown = grown_in_repetition(cracks_[k], loads[t], size.size);
        rate.push_back(std::min(grown / (t == 0 ? size.size : size.half_length()), kFastest));
      }
      // Where the fit ends at a = c, the shape stays.
      if (loads.size() == 2 && size.aspect_ratio >= 1 && rate[rate.size() - 2] > rate.back())
        rate[rate.size() - 2] = rate.back();
    }
    return rate;
  }

  /// Growth of a tip in one repetition [m].
  [[nodiscard]] double grown_in_repetition(const GrowingCrack& crack,
                                           std::span<const TipLoad> loads, double a) const {
    return growth_with_interaction(crack, loads, a, options_.interaction,
                                   kShareOfZone * step_factor_);
  }

  /// (GR-24): the path in the logarithms of the sizes has the length of the variable.
  void derivative(const State& state, State& by_path) const {
    const State rate = rates(state);
    double norm = 0.0;
    for (const double r : rate) norm += r * r;
    norm = std::sqrt(norm);
    by_path.assign(state.size(), 0.0);
    if (!(norm > 0)) {
      by_path.back() = kStandsStill;
      return;
    }
    for (std::size_t i = 0; i < rate.size(); ++i) by_path[i] = rate[i] / norm;
    by_path.back() = 1 / norm;
  }
  static constexpr double kFastest = 1e40;
  static constexpr double kStandsStill = 1e200;

  [[nodiscard]] std::vector<CrackSize> sizes(const State& state) const {
    std::vector<CrackSize> all = unchanged_;
    for (std::size_t k = 0; k < cracks_.size(); ++k) all[in_drive_[k]] = size_of(state, k);
    return all;
  }
  [[nodiscard]] GearSet gear_at(const State& state) const {
    return with_crack_sizes(gear_, sizes(state));
  }
  /// The stiffness under the softer sense of torque at a state [N*m/rad].
  /// @throws InputError  if the drive breaks a rule at these sizes
  [[nodiscard]] double stiffness_at(const State& state) const {
    const std::vector<CrackSize> all = sizes(state);
    set_crack_sizes(sized_, all);
    // Nothing but sizes has changed since the first check.
    const bool plain = std::ranges::all_of(all, [](const CrackSize& of) {
      return of.size >= 0 && of.size < kPlainSize && of.aspect_ratio > 0 && of.aspect_ratio <= 1;
    });
    plain ? check_crack_rules(sized_) : check(sized_);
    return softer_stiffness(sized_);
  }
  static constexpr double kPlainSize = 1e3;  ///< of a crack, inside the ranges of all fields [m]

  /// What ends the step at a state, apart from the failure assessment.
  struct End {
    CrackEvent event;
    std::size_t crack;
    /// The rule of the input that the drive breaks at this state; empty: none.
    std::string refused = {};
  };
  [[nodiscard]] std::optional<End> end_at(const State& state) const {
    const double factor = amplification(state);
    bool severed = false;
    try {
      severed = stiffness_at(state) < kSevered * first_stiffness_;
    } catch (const InputError& error) {  // cracks that meet, for example
      return End{CrackEvent::range, crack_of(error.field()), error.what()};
    }
    for (const WallGroup& group : groups(state))
      if (std::string fault = group.fault(); !fault.empty())
        return End{CrackEvent::range, crack_of(fault), std::move(fault)};
    for (std::size_t k = 0; k < cracks_.size(); ++k) {
      const double a = std::exp(state[first_[k]]);
      // A vibration may raise the torque beyond a table of K over a turn.
      if (factor > cracks_[k].largest_factor()) return End{CrackEvent::range, k};
      if (cracks_[k].breaks(size_of(state, k), factor)) return End{CrackEvent::breaks, k};
      if (severed) return End{CrackEvent::severed, k};
      const bool too_long = cracks_[k].tips().size() == 2 &&
                            std::exp(state[first_[k] + 1]) >= cracks_[k].crack().length_end;
      if (a >= cracks_[k].crack().range_end || too_long || leaves_shapes(state, k))
        return End{CrackEvent::range, k};
      if (cracks_[k].crack().path == options_.stop.crack && a >= options_.stop.size)
        return End{CrackEvent::wanted_size, k};
    }
    return std::nullopt;
  }

  /// Two cracks of a group that are about to grow together in one line (CG-14).
  struct Merger {
    std::size_t first = 0;   ///< among `cracks`
    std::size_t second = 0;  ///< likewise
    WallThroughCrack crack;  ///< in place of both
    /// Change of the stiffness under the softer sense of torque [-]; absent: not known.
    std::optional<double> change = {};
  };
  /// The merger at a state where a group ends; absent: no two cracks of one line meet there.
  [[nodiscard]] std::optional<Merger> merger(const State& state) const {
    for (const WallGroup& group : groups(state)) {
      std::vector<StraightCrack> places;
      for (const WallGroup::Member& member : group.members()) places.push_back(member.place);
      for (std::size_t j = 0; j < places.size(); ++j) {
        const NearestCrack nearest = nearest_crack(places, j, group.wall().round);
        // A path ends just before its limit.
        constexpr double kAtLimit = 1e-6;
        if (nearest.index <= j || nearest.gap > kLeastGroupGap + kAtLimit) continue;
        const auto one = merged_crack(places[j], places[nearest.index], group.wall().round);
        if (!one) continue;
        const auto [first, second] = std::pair(group.members()[j], group.members()[nearest.index]);
        GearSet gear = gear_at(state);
        auto& cracks = gear.flexspline->crack;
        auto& merged = std::get<WallThroughCrack>(cracks[first.index]);
        merged.half_length = one->half_length;
        merged.angle = std::remainder(one->angle - pi / 2, pi);
        if (merged.angle <= -pi / 2) merged.angle += pi;
        merged.position = one->centre.real() * 2 * pi / group.wall().round;
        merged.distance = one->centre.imag();
        merged.compliance_table.reset();
        merged.turn_table.reset();
        Merger result{
            .first = crack_of(first.path), .second = crack_of(second.path), .crack = merged};
        cracks.erase(cracks.begin() + static_cast<std::ptrdiff_t>(second.index));
        try {
          check(gear);
          const auto before = series_compliance<double>(gear_at(state));
          const auto after = series_compliance<double>(gear);
          if (before.usable && after.usable)
            result.change = softer_stiffness(after) / softer_stiffness(before) - 1;
        } catch (const InputError&) {  // the one crack is too long for the drive
          continue;
        }
        // The ligament gives energy when it breaks, so the drive becomes softer.
        if (!result.change || *result.change < 0) return result;
      }
    }
    return std::nullopt;
  }

  /// Least factor on the heaviest loads of the duty at which a crack fails the failure assessment;
  /// absent: there is none.
  [[nodiscard]] std::optional<double> reserve(const State& state) const {
    std::optional<double> least;
    const auto take = [&](std::optional<double> reserve) {
      if (reserve) least = std::min(least.value_or(*reserve), *reserve);
      return false;
    };
    (void)under_heaviest(
        state,
        [&](const GearSet& gear, const auto& counts) {
          for (const CrackStrength& crack : crack_reserves(gear))
            if (counts(crack.path) && !ends_in_table(crack, gear.load.torque))
              take(crack.least_reserve());
          return false;
        },
        [&](const std::string&, std::optional<double> reserve) { return take(reserve); });
    return least;
  }

  /// The first crack that fails the failure assessment under the heaviest loads of the duty.
  [[nodiscard]] std::optional<std::string> failing(const State& state) const {
    std::optional<std::string> path;
    BreakingCracks breaking;
    (void)under_heaviest(
        state,
        [&](const GearSet& gear, const auto& counts) {
          path = breaking.first(gear, counts);
          return path.has_value();
        },
        [&](const std::string& of, std::optional<double> reserve) {
          if (reserve && *reserve < 1) path = of;
          return path.has_value();
        });
    return path;
  }

  /// Assesses the cracks at a state under the heaviest loads of the duty, until a call returns
  /// true.
  /// @param assess  (drive at the load, which paths count): assesses the cracks under torque
  /// @param bent    (path, reserve): takes the reserve of a crack under bending
  template <class Assess, class Bent>
  bool under_heaviest(const State& state, const Assess& assess, const Bent& bent) const {
    GearSet& gear = loaded_;
    set_crack_sizes(gear, sizes(state));
    const double factor = amplification(state);
    const bool axial =
        std::ranges::any_of(heaviest_, [](const DutyStep& step) { return step.axial_force != 0; });
    const double of_flexspline = flexspline_torque(arrangement_of(history_.fixed), history_.ratio);
    const auto under_torque = [&](double torque, const auto& counts) {
      // The assessment asks for a torque; a step without one takes a negligible torque.
      gear.load.torque = torque != 0 ? torque * factor : kNoTorque * gear_.load.torque;
      return assess(
          gear, [&](const std::string& path) { return counts(path.starts_with("output_shaft")); });
    };
    for (const DutyStep& step : heaviest_) {
      if (axial) gear.load.axial_force = step.axial_force * factor;
      if (step.torque != 0 || step.axial_force != 0) {
        const bool alike = of_flexspline == 1;  // all members bear the torque of the output
        if (under_torque(of_flexspline * step.torque, [&](bool shaft) { return alike || !shaft; }))
          return true;
        if (!alike && under_torque(step.torque, [](bool shaft) { return shaft; })) return true;
      }
      if (step.bending_moment == 0) continue;
      for (std::size_t k = 0; k < cracks_.size(); ++k) {
        const DriveCrack& crack = cracks_[k].crack();
        if (crack.turning != TurningLoad::bending) continue;
        if (bent(crack.path, bent_reserve(gear, crack, size_of(state, k),
                                          {.torque = step.torque * factor,
                                           .axial_force = gear.load.axial_force,
                                           .bending_moment = step.bending_moment * factor})))
          return true;
      }
    }
    return false;
  }

  /// Whether a crack grows under the loads of the duty times a factor; absent: not known.
  [[nodiscard]] std::optional<bool> grows(std::size_t k, const CrackSize& size, double factor,
                                          double amplification) const {
    const auto any = [&](const GrowingCrack& crack, double by) {
      return std::ranges::any_of(crack.loads(size, by), [&](const std::vector<TipLoad>& at_tip) {
        return crack.growth(at_tip, size.size) > 0;
      });
    };
    if (!coupled_[k]) return any(cracks_[k], factor * amplification);
    // K of the coupled drive is not proportional to the torque.
    DutyHistory scaled = history_of(cracks_[k].crack());
    for (DutyStep& step : scaled.steps) step = times(step, factor);
    for (DutyMomentaryPeak& peak : scaled.peaks) peak.step = times(peak.step, factor);
    CoupledCrack crack = coupled_crack(gear_, drive_cracks(gear_)[in_drive_[k]], scaled);
    if (!crack.known) return std::nullopt;
    return any(GrowingCrack(gear_, std::move(crack.crack), scaled, options_.rate,
                            std::move(crack.at_torque)),
               1.0);
  }

  /// Whether the shape of a surface crack leaves its table of K over a turn.
  [[nodiscard]] bool leaves_shapes(const State& state, std::size_t k) const {
    const auto& table = cracks_[k].crack().turn_table;
    if (!table || cracks_[k].tips().size() == 1) return false;
    constexpr double kRounding = 1e-9;
    const double shape = std::exp(state[first_[k]] - state[first_[k] + 1]);
    const double most = table->aspect_ratios.back();
    return shape < table->aspect_ratios.front() * (1 - kRounding) ||
           (most < 1 && shape > most * (1 + kRounding));
  }

  /// Whether rates deviate from the laws.
  [[nodiscard]] bool deviates() const { return deviating_.has_value(); }
  /// The longest step from a state to the end of a deviation, if the path were straight.
  [[nodiscard]] double room(const State& state, const State& slope) const {
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < cracks_.size(); ++k) {
      const double end = deviating_->log_end(in_drive_[k]);
      const std::size_t at = first_[k];
      if (std::isfinite(end) && slope[at] > 0)
        room = std::min(room, std::max(end - state[at], kAtEnd) / slope[at]);
    }
    return room;
  }
  /// The share of a step that leads to the first end of a deviation; 1 if the step passes none.
  [[nodiscard]] double share_to_end(const State& state, const State& next) const {
    double share = 1.0;
    for (std::size_t k = 0; k < cracks_.size(); ++k) {
      const double end = deviating_->log_end(in_drive_[k]);
      const std::size_t at = first_[k];
      if (next[at] > end + kAtEnd)
        share = std::min(share, (end - state[at]) / (next[at] - state[at]));
    }
    return share;
  }
  /// Takes the next deviation of each crack that has reached the end of its own; true if there is
  /// such a crack.
  bool next_deviations(const State& state) {
    bool any = false;
    for (std::size_t k = 0; k < cracks_.size(); ++k)
      while (state[first_[k]] > deviating_->log_end(in_drive_[k]) - kAtEnd) {
        deviating_->next(in_drive_[k]);
        cracks_[k].deviate(deviating_->of(in_drive_[k]));
        any = true;
      }
    return any;
  }
  static constexpr double kAtEnd = 1e-9;  ///< in ln(size), within which an end counts as reached

  /// Repetitions after which the duty ends.
  [[nodiscard]] double last_repetition() const {
    double last = kLongestDuty / duration();
    if (options_.stop.time) last = std::min(last, *options_.stop.time / duration());
    if (options_.stop.cycles) {
      double most = 0.0;
      for (const GrowingCrack& crack : cracks_) most = std::max(most, crack.duty().cycles());
      if (most > 0) last = std::min(last, *options_.stop.cycles / most);
    }
    return last;
  }

  /// Lets a surface crack go on through the wall; false if the crack cannot.
  [[nodiscard]] bool through_wall(const State& state, std::size_t k) {
    const DriveCrack& crack = cracks_[k].crack();
    if (crack.ends_in_table || std::exp(state[first_[k]]) < crack.range_end) return false;
    GearSet grown = gear_at(state);
    if (!break_through(grown, in_drive_[k])) return false;
    // A crack that is longer than the solution for the crack through the wall cannot go on.
    const DriveCrack through = drive_cracks(grown)[in_drive_[k]];
    if (through.size.size >= through.range_end) return false;
    try {
      check(grown);
      (void)softer_stiffness(grown);
    } catch (const InputError&) {
      return false;
    }
    gear_ = std::move(grown);
    take_scratch();
    if (deviating_) deviating_->go_on(in_drive_[k], through.size.size);
    take_cracks();
    return true;
  }

 private:
  /// The growing crack to which a field of the drive belongs; the first one if there is none.
  [[nodiscard]] std::size_t crack_of(const std::string& field) const {
    for (std::size_t k = 0; k < cracks_.size(); ++k)
      if (field.starts_with(cracks_[k].crack().path)) return k;
    return 0;
  }
  /// Whether the reserve of a crack is only the end of its table of K over a turn.
  [[nodiscard]] bool ends_in_table(const CrackStrength& strength, double torque) const {
    for (const GrowingCrack& crack : cracks_) {
      const auto& table = crack.crack().turn_table;
      if (!table || crack.crack().path != strength.path || !table->covers(torque)) continue;
      const auto reserve = strength.least_reserve();
      return std::ranges::any_of(strength.states, [&](const StrengthState& state) {
        const double of_state =
            state.sense == TorqueSense::positive ? std::abs(torque) : -std::abs(torque);
        const bool beyond = state.verdict == StrengthVerdict::fractures ||
                            state.verdict == StrengthVerdict::collapses;
        return !beyond && state.with_assembly && reserve && state.reserve == reserve &&
               table->covers(of_state) && *reserve > 0.999 * turn_load_range(*table, of_state)[1];
      });
    }
    return false;
  }
  [[nodiscard]] static DutyStep times(DutyStep step, double factor) {
    step.torque *= factor;
    step.axial_force *= factor;
    step.bending_moment *= factor;
    return step;
  }

  /// The duty with the torque that a crack bears: the output shaft that of the output, all other
  /// members that of the flexspline.
  [[nodiscard]] const DutyHistory& history_of(const DriveCrack& crack) const {
    return crack.turning == TurningLoad::bending ? history_ : at_flexspline_;
  }

  /// Takes the drives of which only sizes and loads are set.
  void take_scratch() {
    loaded_ = gear_;
    sized_ = gear_;
  }

  void take_cracks() {
    cracks_.clear();
    coupled_.clear();
    first_.clear();
    in_drive_.clear();
    unchanged_.clear();
    std::size_t at = 0;
    const bool first_time = report_.cracks.empty();
    std::vector<DriveCrack> all = drive_cracks(gear_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      unchanged_.push_back(all[i].size);
      CracksAtTorques at_torque;
      // A table of K over a turn needs no coupled drive.
      const bool coupled_drive = all[i].acts_in_coupled_drive && !all[i].turn_table;
      if (all[i].acts_in_coupled_drive) {
        CoupledCrack coupled = coupled_crack(gear_, all[i], history_of(all[i]));
        if (first_time) take_evidence(coupled);
        if (!coupled.known) continue;
        all[i] = std::move(coupled.crack);
        at_torque = std::move(coupled.at_torque);
        unchanged_.back() = all[i].size;
      }
      if (all[i].turning == TurningLoad::balls &&
          !cycles_per_output_turn(gear_, DutyPlace::inner_ring)) {
        if (first_time) report_.notes.push_back(unknown_balls_note(all[i].path));
        continue;
      }
      if (all[i].laminate && !has_law(gear_, all[i])) {
        if (first_time) report_.notes.push_back(laminate_crack_note(all[i].path));
        continue;
      }
      in_drive_.push_back(i);
      coupled_.push_back(coupled_drive);
      const DutyHistory& history = history_of(all[i]);
      const RateChoice choice = choice_of(all[i], options_.rate);
      cracks_.emplace_back(gear_, std::move(all[i]), history, choice, std::move(at_torque));
      if (deviating_) cracks_.back().deviate(deviating_->of(i));
      if (first_time) check_first(cracks_.back());
      first_.push_back(at);
      at += cracks_.back().tips().size();
    }
    if (first_time && options_.interaction.closure && !cracks_.empty() &&
        std::ranges::all_of(cracks_, has_own_closure))
      throw InputError("interaction.closure",
                       "is not used, because the law of each crack has its own opening; leave out "
                       "--constraint and --stress-level");
  }

  /// Refuses at once what would stop the run on its way.
  void check_first(const GrowingCrack& of) const {
    const DriveCrack& crack = of.crack();
    if (crack.path == options_.stop.crack)
      require(
          options_.stop.size < crack.range_end, "until " + crack.path, options_.stop.size, "m",
          fmt::format("below {}, {}", shown_quantity(crack.range_end, "m", 4), crack.range_text));
    if (crack.kind != WallSurfaceCrack::kKind || crack.turning != TurningLoad::wave) return;
    try {  // the crack may go through the wall
      (void)law_of_through_crack(of.law(), crack.size.size + crack.ligament,
                                 gear_.material.at(crack.material).yield_strength);
    } catch (const InputError&) {
      throw InputError((FieldPath("material") / crack.material / "yield_strength").text(),
                       fmt::format("must be given: {} may go through the wall, where the toughness "
                                   "of its law depends on the yield strength",
                                   crack.path));
    }
  }

  void take_evidence(const CoupledCrack& of) {
    report_.notes.insert(report_.notes.end(), of.notes.begin(), of.notes.end());
    cite(report_,
         std::vector<std::string_view>(of.crack.equations.begin(), of.crack.equations.end()));
  }

  GearSet gear_;
  mutable GearSet loaded_;  ///< the drive at the sizes and the load of the last assessment
  mutable GearSet sized_;   ///< the drive at the sizes of the last stiffness
  const GrowthOptions& options_;
  GrowthReport& report_;
  double step_factor_;
  DutyHistory history_;             ///< with the torque of the output
  DutyHistory at_flexspline_;       ///< with the torque of the flexspline
  std::vector<DutyStep> heaviest_;  ///< those that are assessed
  double first_stiffness_ = 0.0;
  std::vector<GrowingCrack> cracks_;
  std::vector<std::size_t> first_;     // first tip of each crack in the state
  std::vector<std::size_t> in_drive_;  // index among drive_cracks
  std::vector<bool> coupled_;          // whether K comes from the coupled drive
  std::vector<CrackSize> unchanged_;
  std::optional<DeviatingCracks> deviating_;  // absent: the rates are those of the laws
};

/// At most n of the rows, with the first and the last one, spread along their curve y(x) in a
/// square frame, so that many short steps at one place do not take most of them.
template <class Row, class X, class Y>
std::vector<std::size_t> spread_rows(const std::vector<Row>& rows, int n, X x, Y y) {
  if (rows.size() < 2) return std::vector<std::size_t>(rows.size(), 0);
  const auto extent = [&](auto member) {
    const auto [least, most] = std::ranges::minmax(rows, {}, member);
    const double size = std::invoke(member, most) - std::invoke(member, least);
    return size > 0 ? size : 1.0;
  };
  const double width = extent(x);
  const double height = extent(y);
  std::vector<double> along = {0.0};
  for (std::size_t i = 1; i < rows.size(); ++i)
    along.push_back(along.back() +
                    std::hypot((std::invoke(x, rows[i]) - std::invoke(x, rows[i - 1])) / width,
                               (std::invoke(y, rows[i]) - std::invoke(y, rows[i - 1])) / height));
  const double spacing = along.back() / (n - 1);
  std::vector<std::size_t> kept = {0};
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    if (along[i] - along[kept.back()] >= spacing && along.back() - along[i] >= spacing)
      kept.push_back(i);
  kept.push_back(rows.size() - 1);
  return kept;
}

template <class Row>
void keep_rows(std::vector<Row>& rows, const std::vector<std::size_t>& kept) {
  std::vector<Row> thin;
  for (const std::size_t i : kept) thin.push_back(std::move(rows[i]));
  rows = std::move(thin);
}

/// Integrates the path and fills the report.
class Path {
 public:
  /// @param pass  0: the path; 1: a path with half steps, which only checks the time and fills no
  ///              series, events and notes
  Path(const GearSet& gear, const GrowthOptions& options, GrowthReport& report,
       const Progress& progress, GrowthCheckpoint& checkpoint, int pass)
      : growing_(gear, options, report, pass == 0 ? 1.0 : 0.5),
        options_(options),
        report_(report),
        progress_(progress),
        checkpoint_(checkpoint),
        pass_(pass),
        step_factor_(pass == 0 ? 1.0 : 0.5),
        told_(pass == 0) {}
  /// A path that only fills the end and a trace.
  Path(const GearSet& gear, const GrowthOptions& options, GrowthReport& report,
       const Progress& progress, GrowthCheckpoint& checkpoint, LifeTrace& trace,
       const DrawnGrowth* drawn)
      : growing_(gear, options, report, 1.0, drawn),
        options_(options),
        report_(report),
        progress_(progress),
        checkpoint_(checkpoint),
        pass_(0),
        step_factor_(1.0),
        told_(false),
        trace_(&trace) {}

  void run() {
    if (growing_.none()) {
      report_.end = DriveEnd::not_known;
      return;
    }
    if (told_) begin_report();
    State state = growing_.start(0.0);
    const double duration = growing_.duration();
    report_.duty_duration = duration;
    const auto at_once = growing_.end_at(state);
    if (at_once) record(state);
    if (!at_once || finish_at(state, *at_once))
      while (integrate(state)) {
      }
    report_.repetitions = state.back();
    report_.time = state.back() * duration;
    end_ = state;
    if (!told_) return;
    note_groups(state);
    describe_rest(state);
    const auto kept = spread_rows(report_.stiffness, options_.points, &StiffnessOverLife::time,
                                  &StiffnessOverLife::change);
    keep_rows(report_.stiffness, kept);
    keep_rows(report_.drives, kept);
    add_coupled_drive();
  }

  /// Stress ratios of the cycles by which each crack grows.
  [[nodiscard]] const std::vector<RatioRange>& ratios() const { return ratios_; }

  /// Largest difference of the time and of the sizes at the end to another computation [-].
  [[nodiscard]] double difference(const Path& other) const {
    if (end_.size() != other.end_.size() || !(end_.back() > 0)) return 1.0;
    double largest = std::abs(other.end_.back() / end_.back() - 1);
    for (std::size_t i = 0; i + 1 < end_.size(); ++i)
      largest = std::max(largest, std::abs(other.end_[i] - end_[i]));
    return largest;
  }

 private:
  /// Runs until an end; true if the cracks go on with another set.
  bool integrate(State& state) {
    const auto system = [this](const State& at, State& by_path, double) {
      growing_.derivative(at, by_path);
    };
    Stepper stepper;
    State slope(state.size());
    State next(state.size());
    State next_slope(state.size());
    State error(state.size());
    // A crack of the coupled drive may begin larger than the file says.
    if (growing_.deviates()) (void)growing_.next_deviations(state);
    system(state, slope, 0.0);
    double h = 1e-3 * step_factor_;
    double since_assessment = kAssessmentStep;
    const double last = growing_.last_repetition();
    const auto ended = [&](const State& at) {
      return at.back() >= last || growing_.end_at(at).has_value();
    };
    // The path ends between two neighbouring states.
    const auto finish = [&](const State& before, const State& beyond) {
      const auto end = growing_.end_at(beyond);
      state = end && end->refused.empty() ? beyond : before;
      if (const auto failed = failing(before)) {
        state = before;
        return assessment_end(state, *failed);
      }
      if (!end) {
        stop_at(state);
        report_.end = last * growing_.duration() < 0.999 * kLongestDuty ? DriveEnd::until
                                                                        : DriveEnd::too_slow;
        return false;
      }
      return finish_at(state, *end);
    };
    // Shortens a step that passes an end until the end lies between two neighbouring states.
    const auto finish_between = [&](double above, const auto& step_to) {
      State before = state;
      double below = 0.0;
      for (double middle = above / 2; below < middle && middle < above;
           middle = (below + above) / 2) {
        State at(state.size());
        step_to(middle, at);
        if (ended(at)) {
          above = middle;
          next = at;
        } else {
          below = middle;
          before = at;
        }
      }
      return finish(before, next);
    };
    double jump = kFirstJump * step_factor_;
    double since_jump = 1.0;
    record(state);
    while (true) {
      progress_.at(std::min(0.99, state.back() / last));
      if (slope.back() >= Growing::kStandsStill) return arrested(state);
      // Behind a jump the next one may follow soon, if a tip rests and grows in turns.
      const bool again = since_jump < 10 * jump;
      if (h < (again ? 0.1 * jump : kShortestStep)) {
        // No step is short enough, so a rate jumps here.  If all cracks stand still beyond, they
        // are arrested; otherwise the path goes on behind the jump.
        jump = again ? std::min(8 * jump, kLongestJump * step_factor_) : kFirstJump * step_factor_;
        for (std::size_t i = 0; i < state.size(); ++i) next[i] = state[i] + jump * slope[i];
        system(next, next_slope, 0.0);
        if (next_slope.back() >= Growing::kStandsStill) {
          state = next;
          return arrested(state);
        }
        if (ended(next))
          return finish_between(jump, [&](double length, State& at) {
            for (std::size_t i = 0; i < state.size(); ++i) at[i] = state[i] + length * slope[i];
          });
        state = next;
        slope = next_slope;
        if (growing_.deviates() && growing_.next_deviations(state)) system(state, slope, 0.0);
        since_jump = 0.0;
        since_assessment += jump;
        h = jump;
        continue;
      }
      if (since_assessment >= kAssessmentStep) {
        since_assessment = 0.0;
        if (const auto failed = failing(state)) return assessment_end(state, *failed);
        acceptable_ = state;
      }
      if (std::optional<PathStep> stored = checkpoint_.next(pass_, leg_)) {
        if (stored->state.size() != state.size())
          throw InputError("--resume", "has a step of another drive; remove the file");
        state = std::move(stored->state);
        h = stored->next_length;
        report_.steps = stored->tried;
        since_assessment = stored->since_assessment;
        since_jump = stored->since_jump;
        jump = stored->jump;
        system(state, slope, 0.0);
        record(state);
        continue;
      }
      // No step passes the end of a deviation, where the rate jumps.
      double length = h;
      if (growing_.deviates()) length = std::min(h, growing_.room(state, slope));
      stepper.do_step(system, state, slope, 0.0, next, next_slope, length, error);
      if (growing_.deviates())
        for (double share = growing_.share_to_end(state, next); share < 1;
             share = growing_.share_to_end(state, next)) {
          length *= share;
          stepper.do_step(system, state, slope, 0.0, next, next_slope, length, error);
        }
      const double excess = error_of(error, state, next, slope, length);
      if (!(excess <= 1)) {
        ++report_.steps;
        h = length * (std::isfinite(excess) ? std::max(0.2, 0.9 * std::pow(excess, -0.2)) : 0.2);
        continue;
      }
      ++report_.steps;
      if (ended(next))
        return finish_between(length, [&](double shorter, State& at) {
          State at_slope(state.size());
          stepper.do_step(system, state, slope, 0.0, at, at_slope, shorter, error);
        });
      since_assessment += length;
      since_jump += length;
      state = next;
      slope = next_slope;
      record(state);
      const double longer =
          std::min({5 * length, 0.9 * length * std::pow(std::max(excess, 1e-5), -0.2),
                    kLongestStep * step_factor_});
      h = length < h ? std::max(h, longer) : longer;
      if (growing_.deviates() && growing_.next_deviations(state)) system(state, slope, 0.0);
      checkpoint_.add({.pass = pass_,
                       .leg = leg_,
                       .state = state,
                       .next_length = h,
                       .tried = report_.steps,
                       .since_assessment = since_assessment,
                       .since_jump = since_jump,
                       .jump = jump});
    }
  }

  [[nodiscard]] double error_of(const State& error, const State& state, const State& next,
                                const State& slope, double h) const {
    double excess = 0.0;
    const double allowed = options_.tolerance * step_factor_;
    for (std::size_t i = 0; i + 1 < error.size(); ++i)
      excess = std::max(excess, std::abs(error[i]) / (allowed * h + 1e-15));
    const double repetitions = std::abs(next.back() - state.back()) + h * slope.back();
    excess = std::max(excess, std::abs(error.back()) / (allowed * repetitions + 1e-300));
    return excess;
  }

  /// The crack that fails the assessment at a state.
  [[nodiscard]] std::optional<std::string> failing(const State& state) const {
    return growing_.failing(state);
  }

  bool assessment_end(State& state, const std::string& path) {
    const State beyond = state;
    if (acceptable_.size() == beyond.size()) {
      // The states in between lie on the path; its chord is accurate enough for an end that is
      // known within the accuracy of the assessment.
      double below = 0.0;
      double above = 1.0;
      const auto between = [&](double share) {
        State at = beyond;
        for (std::size_t i = 0; i < at.size(); ++i)
          at[i] = acceptable_[i] + share * (beyond[i] - acceptable_[i]);
        return at;
      };
      for (int i = 0; i < 24; ++i) {
        const double middle = (below + above) / 2;
        (failing(between(middle)) ? above : below) = middle;
      }
      state = between(above);
    }
    drop_rows_beyond(state);
    report_.end = DriveEnd::assessment;
    report_.governing = path;
    report_.repetitions = state.back();
    report_.life = state.back() * growing_.duration();
    for (std::size_t k = 0; k < growing_.cracks().size(); ++k)
      if (growing_.cracks()[k].crack().path == path) event(state, k, CrackEvent::assessment);
    stop_at(state);
    return false;
  }

  bool arrested(const State& state) {
    report_.end = DriveEnd::arrested;
    stop_at(state);
    return false;
  }

  bool finish_at(State& state, const Growing::End& end) {
    const std::string path = growing_.cracks()[end.crack].crack().path;
    if (end.event == CrackEvent::range) {
      const State before = state;
      if (const auto merger = end.refused.empty() ? std::nullopt : growing_.merger(before)) {
        merge(before, *merger);
        return false;
      }
      event(before, end.crack, CrackEvent::range);
      const bool had_table = growing_.cracks()[end.crack].crack().turn_table != nullptr;
      if (!end.refused.empty()) {
        report_.notes.push_back(refused_size_note(path, end.refused));
      } else if (growing_.through_wall(state, end.crack)) {
        if (told_) {
          CrackGrowth& crack = report_.cracks[end.crack];
          crack.events.back().event = CrackEvent::through_wall;
          if (had_table) report_.notes.push_back(through_wall_note(path));
        }
        ++leg_;
        state = growing_.start(before.back());
        acceptable_.clear();
        if (const auto at_once = growing_.end_at(state)) return finish_at(state, *at_once);
        return true;
      }
      report_.end = DriveEnd::range;
      report_.governing = path;
      stop_at(state);
      return false;
    }
    event(state, end.crack, end.event);
    report_.governing = path;
    report_.end = end.event == CrackEvent::breaks    ? DriveEnd::breaks
                  : end.event == CrackEvent::severed ? DriveEnd::severed
                                                     : DriveEnd::until;
    if (report_.end != DriveEnd::until) report_.life = state.back() * growing_.duration();
    stop_at(state);
    return false;
  }

  /// Ends the path where two cracks become one.
  void merge(const State& state, const Growing::Merger& merger) {
    for (const std::size_t k : {merger.first, merger.second}) event(state, k, CrackEvent::merges);
    const auto& cracks = growing_.cracks();
    report_.notes.push_back(merger_note(cracks[merger.first].crack().path,
                                        cracks[merger.second].crack().path, merger.crack,
                                        merger.change));
    cite(report_, std::array<std::string_view, 1>{"CG-14"});
    report_.end = DriveEnd::range;
    report_.governing = cracks[merger.first].crack().path;
    stop_at(state);
  }

  void stop_at(const State& state) {
    record(state);
    report_.repetitions = state.back();
    report_.time = state.back() * growing_.duration();
  }

  void event(const State& state, std::size_t k, CrackEvent what) {
    if (!told_) return;
    const CrackSize size = growing_.size_of(state, k);
    report_.cracks[k].events.push_back(
        {.event = what,
         .time = state.back() * growing_.duration(),
         .cycles = state.back() * growing_.cracks()[k].duty().cycles(),
         .size = size.size,
         .half_length = size.half_length()});
  }

  void begin_report() {
    const auto& cracks = growing_.cracks();
    const State start = growing_.start(0.0);
    const double factor = growing_.amplification(start);
    first_groups_ = growing_.groups(start);
    first_annular_ = growing_.annular(start);
    for (const GrowingCrack& crack : cracks) {
      const RateChoice choice = choice_of(crack.crack(), options_.rate);
      report_.cracks.push_back(described_crack(growing_.gear(), crack, choice, factor));
      for (Note& note : crack_notes(growing_.gear(), crack, choice))
        report_.notes.push_back(std::move(note));
      cite_models(report_, crack, options_.interaction);
    }
    stands_still_.assign(cracks.size(), false);
    ratios_.assign(cracks.size(), {});
  }

  /// Adds the maker's stiffnesses to some rows, with the first and the last one.
  void add_coupled_drive() {
    if (report_.drives.empty() || !missing_for_torsion_curve(report_.drives.front()).empty())
      return;
    const std::size_t n = report_.drives.size();
    const std::size_t rows = std::min(n, kCoupledRows);
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t at = rows == 1 ? 0 : i * (n - 1) / (rows - 1);
      StiffnessOverLife& row = report_.stiffness[at];
      try {
        const AssembledDrive drive(report_.drives[at]);
        const MakersLines positive = makers_lines(drive, +1);
        const MakersLines negative = makers_lines(drive, -1);
        row.K1_positive = positive.K1;
        row.K2_positive = positive.K2;
        row.K3_positive = positive.K3;
        row.K1_negative = negative.K1;
        row.K2_negative = negative.K2;
        row.K3_negative = negative.K3;
      } catch (const Error& error) {
        report_.notes.push_back(no_curve_note(error.what()));
        return;
      }
    }
    report_.equations.emplace_back("TC-11");
  }

  /// What the cracks of groups change of each other's K at begin and end.
  void note_groups(const State& state) {
    for (const WallGroup& at_end : growing_.groups(state)) {
      const auto at_begin = std::ranges::find_if(first_groups_, [&](const WallGroup& group) {
        return group.wall().name == at_end.wall().name;
      });
      report_.notes.push_back(
          group_note(at_begin != first_groups_.end() ? *at_begin : at_end, at_end));
      cite(report_, std::array<std::string_view, 1>{"CG-9"});
    }
    if (const ShaftGroup at_end = growing_.annular(state); !at_end.cracks.empty()) {
      report_.notes.push_back(shielding_note(first_annular_, at_end));
      cite(report_, std::array<std::string_view, 1>{"CG-12"});
    }
  }

  /// What would let the cracks grow that stand still at the end.
  void describe_rest(const State& state) {
    growing_.take_sizes(state);
    for (std::size_t k = 0; k < growing_.cracks().size(); ++k) {
      if (!stands_still_[k]) continue;
      const CrackSize size = growing_.size_of(state, k);
      const double amplification = growing_.amplification(state);
      describe_arrest(
          report_.cracks[k], growing_.cracks()[k], size, amplification,
          [&](double factor) { return growing_.grows(k, size, factor, amplification); });
    }
  }

  /// Takes the notes on the solutions of the growing cracks at their present sizes, each once.  A
  /// table of K needs none of them, and growth counts all faces as open (GR-22).
  void take_notes(const std::vector<Note>& notes) {
    for (const Note& note : notes) {
      const bool grows = std::ranges::any_of(growing_.cracks(), [&](const GrowingCrack& crack) {
        return crack.crack().path == note.path && !crack.crack().turn_table &&
               note.code != "crack.closed";
      });
      const bool told = std::ranges::any_of(report_.notes, [&](const Note& other) {
        return other.code == note.code && other.path == note.path;
      });
      if (grows && !told && note.severity != Severity::information) report_.notes.push_back(note);
    }
  }

  /// Notes that cracks of a member grow without the influence of the others, if one of them grows.
  void note_superposed(const std::string& member) {
    if (std::ranges::any_of(growing_.cracks(), [&](const GrowingCrack& crack) {
          return crack.crack().path.starts_with(member);
        }))
      report_.notes.push_back(superposed_note(member));
  }

  void take_trace(const State& state) {
    const auto& cracks = growing_.cracks();
    if (trace_->cracks.empty()) {
      for (const GrowingCrack& crack : cracks) trace_->cracks.push_back(crack.crack().path);
      trace_->sizes.resize(cracks.size());
    }
    const double time = state.back() * growing_.duration();
    // An end may lie before the last step.
    while (!trace_->times.empty() && trace_->times.back() >= time) {
      trace_->times.pop_back();
      for (std::vector<double>& sizes : trace_->sizes) sizes.pop_back();
    }
    trace_->times.push_back(time);
    for (std::size_t k = 0; k < cracks.size(); ++k)
      trace_->sizes[k].push_back(growing_.size_of(state, k).size);
  }

  /// Takes off the rows and the arrests beyond a state that lies before the last step.
  void drop_rows_beyond(const State& state) {
    const double time = state.back() * growing_.duration();
    const auto beyond = [&](const auto& row) { return row.time > time; };
    for (std::size_t k = 0; k < report_.cracks.size(); ++k) {
      std::erase_if(report_.cracks[k].series, beyond);
      if (std::erase_if(report_.cracks[k].events, beyond) > 0) stands_still_[k] = false;
    }
    std::erase_if(report_.stiffness, beyond);
    report_.drives.resize(report_.stiffness.size());
  }

  /// Adds a row to the series, if the last one is far enough.
  void record(const State& state) {
    if (trace_ != nullptr) take_trace(state);
    if (!told_) return;
    const double factor = growing_.amplification(state);
    growing_.take_sizes(state);
    for (std::size_t k = 0; k < growing_.cracks().size(); ++k) {
      const GrowingCrack& crack = growing_.cracks()[k];
      const CrackSize size = growing_.size_of(state, k);
      const auto loads = crack.loads(size, std::min(factor, crack.largest_factor()));
      std::size_t fastest = 0;
      double rate = 0.0;
      bool all_stand = true;
      for (std::size_t t = 0; t < loads.size(); ++t) {
        const double grown = growing_.grown_in_repetition(crack, loads[t], size.size);
        if (t == 0) rate = grown;
        all_stand = all_stand && grown == 0;
        if (GrowingCrack::governing(loads[t]).largest >
            GrowingCrack::governing(loads[fastest]).largest)
          fastest = t;
      }
      for (const std::vector<TipLoad>& at_tip : loads)
        for (const TipLoad& load : at_tip)
          if (load.count > 0 && crack.rate_of(load.cycle, size.size) > 0)
            ratios_[k].take(load.cycle.ratio);
      if (all_stand && !stands_still_[k]) event(state, k, CrackEvent::arrested);
      // A vibration that rises, or the other cracks, may let a crack grow on.
      if (!all_stand) {
        report_.cracks[k].grows = true;
        if (stands_still_[k])
          std::erase_if(report_.cracks[k].events, [](const GrowthEvent& event) {
            return event.event == CrackEvent::arrested;
          });
      }
      stands_still_[k] = all_stand;
      const double cycles = crack.duty().cycles();
      const TipCycle widest = crack.widest(loads[fastest]);
      std::vector<GrowthPoint>& series = report_.cracks[k].series;
      const double time = state.back() * growing_.duration();
      if (!series.empty() && series.back().time == time && series.back().size == size.size &&
          series.back().half_length == size.half_length())
        series.pop_back();
      series.push_back({.time = state.back() * growing_.duration(),
                        .cycles = state.back() * cycles,
                        .size = size.size,
                        .half_length = size.half_length(),
                        .K_max = GrowingCrack::governing(loads[fastest]).largest,
                        .delta_K = widest.full_range(),
                        .ratio = widest.ratio,
                        .rate = cycles > 0 ? rate / cycles : 0.0});
    }
    const GearSet gear = growing_.gear_at(state);
    const StiffnessResult stiffness = torsional_stiffness(gear);
    StiffnessOverLife row{.time = state.back() * growing_.duration(),
                          .positive = stiffness.positive.stiffness.value,
                          .negative = stiffness.negative.stiffness.value};
    if (report_.stiffness.empty()) {
      first_positive_ = row.positive;
      first_negative_ = row.negative;
    }
    take_notes(stiffness.notes);
    if (report_.stiffness.empty())
      for (const Note& note : stiffness.notes)
        if (note.code == "crack.superposed") note_superposed(note.path);
    row.change = std::min(row.positive / first_positive_, row.negative / first_negative_) - 1;
    row.resonance = std::sqrt(1 + row.change);  // (GR-25)
    row.reserve = growing_.reserve(state);
    if (!report_.stiffness.empty() && report_.stiffness.back().time == row.time &&
        report_.stiffness.back().change == row.change) {
      report_.stiffness.pop_back();
      report_.drives.pop_back();
    }
    report_.stiffness.push_back(row);
    report_.drives.push_back(gear);
  }

  Growing growing_;
  const GrowthOptions& options_;
  GrowthReport& report_;
  const Progress& progress_;
  GrowthCheckpoint& checkpoint_;
  int pass_;
  int leg_ = 0;
  double step_factor_;
  bool told_;
  LifeTrace* trace_ = nullptr;  ///< null: none is asked for
  std::vector<bool> stands_still_;
  std::vector<RatioRange> ratios_;  // of the cycles by which each crack grows
  State acceptable_;
  State end_;
  std::vector<WallGroup> first_groups_;  // at the first sizes
  ShaftGroup first_annular_;             // likewise
  double first_positive_ = 0.0;
  double first_negative_ = 0.0;
};

}  // namespace

LifeTrace life_trace(const GearSet& gear, const GrowthOptions& options, const DrawnGrowth* drawn) {
  require(options.tolerance > 0 && options.tolerance < 1, "tolerance", options.tolerance, "1",
          "between 0 and 1");
  const TabulatedPairs tables;
  LifeTrace trace;
  GrowthReport report;
  GrowthCheckpoint none;
  const Progress silent;
  Path(gear, options, report, silent, none, trace, drawn).run();
  trace.end = report.end;
  trace.governing = report.governing;
  trace.life = report.life;
  trace.time = report.time;
  return trace;
}

GrowthReport grow_cracks(const GearSet& gear, const GrowthOptions& options,
                         const Progress& progress, GrowthCheckpoint* checkpoint) {
  require(options.tolerance > 0 && options.tolerance < 1, "tolerance", options.tolerance, "1",
          "between 0 and 1");
  require(options.points >= 2, "points", options.points, "1", ">= 2");
  GrowthReport report;
  report.tolerance = options.tolerance;
  report.mixed_mode = std::string(enum_name(options.rate.mixed_mode));
  report.equations = {"GR-21", "GR-22", "GR-23", "GR-24", "GR-25"};
  report.interaction = std::string(enum_name(options.interaction.rule));
  if (gear.duty && gear.duty->resonance) report.equations.emplace_back("GR-28");
  if (gear.duty) report.rainflow = std::string(enum_name(gear.duty->residue));
  GrowthCheckpoint none;
  GrowthCheckpoint& stored = checkpoint != nullptr ? *checkpoint : none;
  const Progress coarse = progress.part(0, 0.3);
  Path path(gear, options, report, coarse, stored, 0);
  path.run();
  if (!report.cracks.empty() && report.time > 0) {
    GrowthReport fine;
    const Progress halved = progress.part(0.3, 1);
    Path half(gear, options, fine, halved, stored, 1);
    half.run();
    report.step_error = path.difference(half);
  }
  complete(report, gear, options.rate, path.ratios());
  for (CrackGrowth& crack : report.cracks)
    keep_rows(crack.series,
              spread_rows(crack.series, options.points, &GrowthPoint::time, &GrowthPoint::size));
  return report;
}

}  // namespace strainwave

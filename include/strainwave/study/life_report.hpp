// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/life/ball_bearing.hpp"
#include "strainwave/life/critical_plane.hpp"
#include "strainwave/life/roller_bearing.hpp"
#include "strainwave/life/tube_buckling.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/life_result.hpp"

/// @file
/// The results of `strainwave life`: the life of a drive without cracks over its duty.

namespace strainwave {

/// A rule of the makers.
enum class MakersRule {
  average_torque,
  repeated_peak,
  momentary_peak,
  momentary_peaks,  ///< the number of momentary peaks, N_k
  average_speed,    ///< of the input
  largest_speed,    ///< of the input
  ratcheting,
  buckling,
};
template <>
struct EnumNames<MakersRule> {
  static constexpr std::array<std::string_view, 8> names = {
      "average_torque", "repeated_peak", "momentary_peak", "momentary_peaks",
      "average_speed",  "largest_speed", "ratcheting",     "buckling"};
};

/// Outcome of a rule.
enum class RuleOutcome {
  kept,
  broken,
  not_known,   ///< the limit is not known
  not_needed,  ///< the duty has nothing to compare
};
template <>
struct EnumNames<RuleOutcome> {
  static constexpr std::array<std::string_view, 4> names = {"kept", "broken", "not known",
                                                            "not needed"};
};

/// A rule with what is allowed and what is present.
struct RuleAnswer {
  MakersRule rule = MakersRule::average_torque;
  RuleOutcome outcome = RuleOutcome::not_known;
  std::optional<Quantity> allowed;
  std::optional<Quantity> present;
  std::optional<double> margin;  ///< allowed over present, minus 1 [-]
  std::string origin;            ///< of the limit, or what to give

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"rule", "", "rule of the makers"}, &RuleAnswer::rule);
    field({"outcome", "", "kept, broken, not known or not needed"}, &RuleAnswer::outcome);
    field({.name = "allowed", .unit = kUnitBeside, .doc = "what the maker allows"},
          &RuleAnswer::allowed);
    field({.name = "present", .unit = kUnitBeside, .doc = "what the duty has"},
          &RuleAnswer::present);
    field({"margin", "1", "allowed over present, minus 1"}, &RuleAnswer::margin);
    field({"origin", "", "origin of the limit, or what to give for it"}, &RuleAnswer::origin);
  }
};

/// The constant load that stands for the duty.
struct AverageLoad {
  double torque = 0.0;        ///< T_av [N*m]
  double output_speed = 0.0;  ///< [rad/s]
  double input_speed = 0.0;   ///< [rad/s]
  double duration = 0.0;      ///< of a repetition of the duty [s]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "average torque T_av"}, &AverageLoad::torque);
    field({"output_speed", "rad/s", "average speed of the output, with pauses"},
          &AverageLoad::output_speed);
    field({"input_speed", "rad/s", "average speed of the input, with pauses"},
          &AverageLoad::input_speed);
    field({"duration", "s", "time of a repetition of the duty"}, &AverageLoad::duration);
  }
};

/// Life of the wave generator's bearing by the maker's rule.
struct MakersBearingLife {
  double ten_percent = 0.0;    ///< L10 [s]
  double fifty_percent = 0.0;  ///< L50 [s]
  std::string origin;          ///< of L_n

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"L10", "s", "life that 90 % of the bearings reach"}, &MakersBearingLife::ten_percent);
    field({"L50", "s", "life that half of the bearings reach"}, &MakersBearingLife::fifty_percent);
    field({"origin", "", "origin of the rated life"}, &MakersBearingLife::origin);
  }
};

/// The wave generator's bearing by the forces of its balls.  Its hours are not comparable with the
/// maker's (theory manual, chapter LI); its ratios are.
struct BearingByForces {
  BallBearingLife duty;
  std::optional<BallBearingLife> rated;  ///< at rated torque and 2000 rpm
  std::optional<double> ratio;           ///< L10 of the duty over L10 at the rating [-]
  std::optional<double> by_ratio;        ///< the maker's rated life times the ratio [s]
  int cage_phases = 0;                   ///< positions of the balls that were solved

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"duty", "", "life over the duty, not comparable with the maker's hours"},
          &BearingByForces::duty);
    field({"rated", "", "life at rated torque and 2000 rpm"}, &BearingByForces::rated);
    field({"ratio", "1", "L10 over the duty over L10 at the rating"}, &BearingByForces::ratio);
    field({"by_ratio", "s", "the maker's rated life times this ratio"}, &BearingByForces::by_ratio);
    field({"cage_phases", "", "positions of the balls that were solved"},
          &BearingByForces::cage_phases);
  }
};

/// A place of the flexspline.
enum class FatiguePlace { wall, rim, tooth_root };
template <>
struct EnumNames<FatiguePlace> {
  static constexpr std::array<std::string_view, 3> names = {"wall", "rim", "tooth_root"};
};

/// Hours until Miner's sum is 1.
struct MinerLife {
  MinerRule rule = MinerRule::haibach;
  double damage_rate = 0.0;    ///< damage per time [1/s]
  std::optional<double> life;  ///< [s]; absent: no damage

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"rule", "", "line of the endurance below its knee"}, &MinerLife::rule);
    field({"damage_rate", "1/s", "damage per time"}, &MinerLife::damage_rate);
    field({"life", "s", "time to a damage of 1; absent without damage"}, &MinerLife::life);
  }
};

/// Fatigue of the worst point of a place of the flexspline.
struct PlaceFatigue {
  FatiguePlace place = FatiguePlace::wall;
  std::string unknown_because;  ///< what to give; empty if the reserve is known
  double hoop_amplitude = 0.0;  ///< over the duty, with concentration [Pa]
  double hoop_mean = 0.0;       ///< [Pa]
  double shear_least = 0.0;     ///< over the duty [Pa]
  double shear_most = 0.0;      ///< [Pa]
  double concentration = 1.0;   ///< of the hoop stress [-]
  double surface = 1.0;         ///< K_R [-]
  double size = 1.0;            ///< size factor [-]
  double support = 1.0;         ///< support factor n of the notch [-]
  double sensitivity = 0.0;     ///< M [-]
  double endurance = 0.0;       ///< of the part, normal stress at R = -1 [Pa]
  std::optional<CriticalPlane> plane;
  std::optional<double> reserve;                  ///< 1/utilisation of the plane [-]
  std::optional<double> reserve_with_peaks = {};  ///< with the momentary peaks [-]
  std::optional<double> handbook;                 ///< handbook reserve S [-]
  std::vector<MinerLife> miner;                   ///< empty without knee cycles and slope

  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = PlaceFatigue;
    field({"place", "", "wall, rim at its bore, or tooth root"}, &P::place);
    field({"unknown_because", "", "what to give; empty if the reserve is known"},
          &P::unknown_because);
    field({"hoop_amplitude", "Pa", "amplitude of the hoop stress over the duty"},
          &P::hoop_amplitude);
    field({"hoop_mean", "Pa", "mean hoop stress over the duty"}, &P::hoop_mean);
    field({"shear_least", "Pa", "least shear stress over the duty"}, &P::shear_least);
    field({"shear_most", "Pa", "largest shear stress over the duty"}, &P::shear_most);
    field({"concentration", "1", "concentration of the hoop stress of the rim"}, &P::concentration);
    field({"surface", "1", "surface factor K_R"}, &P::surface);
    field({"size", "1", "size factor"}, &P::size);
    field({"support", "1", "support factor of the notch"}, &P::support);
    field({"sensitivity", "1", "sensitivity M to the mean stress"}, &P::sensitivity);
    field({"endurance", "Pa", "amplitude that the place endures at R = -1"}, &P::endurance);
    field({"plane", "", "the most used plane"}, &P::plane);
    field({"reserve", "1", "reserve against endurance by the most used plane"}, &P::reserve);
    field({"reserve_with_peaks", "1",
           "reserve with the momentary peaks, each as if it came for ever"},
          &P::reserve_with_peaks);
    field({"handbook", "1", "reserve by the handbooks; 1.5 is usual"}, &P::handbook);
    field({"miner", "", "damage by Miner"}, &P::miner);
  }
};

/// The sum that ends a place: Haibach's if blocks bring it above its endurance limit, the original
/// one if only momentary peaks do, else null.
[[nodiscard]] const MinerLife* governing_sum(const PlaceFatigue& place);

/// Buckling of the barrel from its geometry.
struct BuckledBarrel {
  TubeBuckling elastic;
  std::optional<double> plastic_torque;  ///< with yielding [N*m]; absent without yield_strength
  std::optional<double> reserve;         ///< torque over the largest torque of the duty [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"elastic", "", "the barrel as an elastic tube"}, &BuckledBarrel::elastic);
    field({"plastic_torque", "N*m", "buckling torque of a wall that yields"},
          &BuckledBarrel::plastic_torque);
    field({"reserve", "1", "buckling torque over the largest torque of the duty"},
          &BuckledBarrel::reserve);
  }
};

/// The drive with worn flanks.
struct WornState {
  double time = 0.0;                  ///< [s]
  double depth = 0.0;                 ///< mean of both flanks of a tooth, with their mates [m]
  std::optional<double> lost_motion;  ///< [rad]; absent if the curve has no solution
  std::optional<double> K1;           ///< [N*m/rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"time", "s", "time of duty"}, &WornState::time);
    field({"depth", "m", "depth of wear of a pair of flanks, mean of both senses"},
          &WornState::depth);
    field({"lost_motion", "rad", "lost motion of the worn drive"}, &WornState::lost_motion);
    field({"K1", "N*m/rad", "stiffness up to T1 of the worn drive"}, &WornState::K1);
  }
};

/// Wear of the flanks by Archard.
struct FlankWear {
  double drive_rate = 0.0;        ///< of the drive flanks [m/s]
  double coast_rate = 0.0;        ///< of the coast flanks [m/s]
  std::vector<WornState> states;  ///< up to the drive's life, or 10 000 h

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"drive_rate", "m/s", "depth per time of the flanks under torque about +z"},
          &FlankWear::drive_rate);
    field({"coast_rate", "m/s", "depth per time of the flanks under torque about -z"},
          &FlankWear::coast_rate);
    field({"states", "", "the drive with worn flanks"}, &FlankWear::states);
  }
};

/// A part of the drive and its end.
struct LifePart {
  std::string name;
  std::optional<double> ten_percent;  ///< L10 [s]; absent: no distribution
  std::optional<double> slope;        ///< Weibull's slope [-]
  std::optional<double> end;          ///< time of its end without distribution [s]
  std::string origin;                 ///< of the life, or why it is not known

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "the part"}, &LifePart::name);
    field({"L10", "s", "life that 90 % reach; absent without a distribution"},
          &LifePart::ten_percent);
    field({"slope", "1", "Weibull's slope"}, &LifePart::slope);
    field({"end", "s", "end of a part without a distribution"}, &LifePart::end);
    field({"origin", "", "origin of the life, or why it is not known"}, &LifePart::origin);
  }
};

/// Share of drives that reach a time.
struct SurvivalPoint {
  double time = 0.0;   ///< [s]
  double share = 0.0;  ///< of drives whose parts with a distribution all reach it [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"time", "s", "time of duty"}, &SurvivalPoint::time);
    field({"share", "1", "share of the drives that reach it"}, &SurvivalPoint::share);
  }
};

/// The result of `strainwave life`.
struct LifeReport {
  std::string answer;           ///< "ends by ... after ... h", or "no end found"
  std::optional<double> hours;  ///< life that 90 % of the drives reach [s]; absent: no end found
  std::string governing;        ///< part that ends first; empty: none
  AverageLoad average;
  std::vector<RuleAnswer> rules;
  std::optional<MakersBearingLife> bearing;
  std::optional<BearingByForces> bearing_by_forces;
  std::optional<OutputBearingLife> output_bearing;
  std::vector<PlaceFatigue> fatigue;
  std::optional<BuckledBarrel> buckling;
  std::optional<FlankWear> wear;  ///< absent without mesh.wear_coefficient
  std::vector<LifePart> parts;
  std::vector<SurvivalPoint> survival;
  std::vector<Note> notes;             ///< remarks on the validity of the lives
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = LifeReport;
    field({.name = "answer", .unit = "", .doc = "what ends the drive, and when", .headline = true},
          &R::answer);
    field({.name = "hours",
           .unit = "s",
           .doc = "life that 90 % of the drives reach, of the parts whose life is known",
           .headline = true},
          &R::hours);
    field({"governing", "", "part that ends first"}, &R::governing);
    field({"average", "", "the constant load that stands for the duty"}, &R::average);
    field({"rules", "", "the maker's rules"}, &R::rules);
    field({"bearing", "", "the wave generator's bearing by the maker's rule"}, &R::bearing);
    field({"bearing_by_forces", "", "the wave generator's bearing by the forces of its balls"},
          &R::bearing_by_forces);
    field({"output_bearing", "", "the output bearing"}, &R::output_bearing);
    field({"fatigue", "", "fatigue of the flexspline"}, &R::fatigue);
    field({"buckling", "", "buckling of the barrel from its geometry"}, &R::buckling);
    field({"wear", "", "wear of the flanks"}, &R::wear);
    field({"parts", "", "parts and their ends"}, &R::parts);
    field({"survival", "", "share of the drives over time"}, &R::survival);
  }
};

/// Life of a drive without its cracks over its duty.
/// @throws InputError  if the drive breaks a rule or has no duty
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] LifeReport life_report(const GearSet& gear, const Progress& progress = {});

/// The numbers of a report that sweep, solve and require can name.
[[nodiscard]] LifeResult life_result(const LifeReport& report);

}  // namespace strainwave

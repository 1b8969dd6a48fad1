// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/inspection/detection_fit.hpp"
#include "strainwave/inspection/inspected_risk.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// The results of `strainwave inspect`: the scatter of the life of cracks, the probability of
/// failure over hours, and what inspections take off it.

namespace strainwave {

/// Which inspections there are.
struct InspectionTimes {
  std::vector<double> at;       ///< given times [s]
  std::optional<double> every;  ///< interval [s]
  std::optional<double> first;  ///< of the intervals [s]; absent: one interval
  std::optional<double> risk;   ///< wanted probability of failure; plans are made for it [-]
  int most = 20;                ///< largest number of planned inspections
};

/// What is drawn and inspected.
struct InspectionOptions {
  GrowthOptions growth;         ///< how the cracks grow
  std::optional<double> until;  ///< end of service [s]; absent: the life at the values of the file
  std::optional<Inspection> method;  ///< how cracks are looked for; absent: as the file says
  /// trials from which a50, a90 and form of the method come; absent: none
  std::optional<DetectionFit> trials;
  InspectionTimes times;  ///< when the drive is inspected
  int draws = 500;        ///< drawn drives; 20 to 1 000 000
  /// whether draws scatter about the failures up to the end of service too, (IR-16)
  bool importance_sampling = false;
  std::uint64_t seed = 1;  ///< the same seed gives the same draws
  int threads = 0;         ///< 0: as many as the machine runs; the result does not depend on it
  SharedRows* shared = nullptr;  ///< null, or the part of the draws computed or read here
  RowSink* rows = nullptr;       ///< null, or takes each draw
};

/// How the drawn drives end.
struct DrawnOutcomes {
  int failed = 0;        ///< a crack ends the life before the end of service
  int later = 0;         ///< a crack ends the life after the end of service
  int arrested = 0;      ///< no crack grows any more
  int unfinished = 0;    ///< no end within the longest duty that is computed
  int out_of_range = 0;  ///< a crack leaves the range of its solution; counts as a failure
  int refused = 0;       ///< a rule is broken, or there is no answer; not counted among the others

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = DrawnOutcomes;
    field({"failed", "", "a crack ends the life before the end of service"}, &O::failed);
    field({"later", "", "a crack ends the life after the end of service"}, &O::later);
    field({"arrested", "", "no crack grows any more: the life has no end"}, &O::arrested);
    field({"unfinished", "", "no end within the longest duty that is computed"}, &O::unfinished);
    field({"out_of_range", "",
           "a crack leaves the range of its solution, which counts as a failure at that time"},
          &O::out_of_range);
    field(
        {"refused", "", "the drawn numbers break a rule of the input, or have no answer; left out"},
        &O::refused);
  }
};

/// One input at a centre of the failures.
struct FailureInput {
  static constexpr bool kTableRow = true;
  std::string path;
  std::string_view unit;
  double value = 0.0;       ///< in the file
  double at_centre = 0.0;   ///< at u*
  double deviations = 0.0;  ///< of `at_centre`, standard normal [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using I = FailureInput;
    field({"path", "", "the number that scatters"}, &I::path);
    field({"unit", "", "SI unit of the number"}, &I::unit);
    field({"value", kUnitBeside, "value in the file"}, &I::value);
    field({"at_centre", kUnitBeside, "value at the centre of the failures"}, &I::at_centre);
    field({"deviations", "1", "standard normal deviate there"}, &I::deviations);
  }
};

/// A place about which failures lie (UQ-10).
struct CentreOfFailures {
  double distance = 0.0;             ///< from the inputs of the file, |u*| [-]
  std::vector<FailureInput> inputs;  ///< the most deviating first

  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = CentreOfFailures;
    field({"distance", "1", "distance of the centre from the inputs of the file"}, &C::distance);
    field({"inputs", "", "the inputs there, the most deviating first"}, &C::inputs);
  }
};

/// Draws about the failures up to the end of service (IR-16), and what plain draws say.
struct DrawsAboutFailures {
  std::vector<CentreOfFailures> centres;  ///< the first found first
  int rounds = 0;                         ///< of the search for the centres
  int plain_draws = 0;                    ///< accepted draws about the inputs of the file
  double plain = 0.0;                     ///< probability of failure by them alone [-]
  double plain_low = 0.0;
  double plain_high = 1.0;
  /// largest probability of failures that these may have missed, with 97.5 % confidence [-]
  double elsewhere = 1.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using D = DrawsAboutFailures;
    field({"centres", "", "places about which equal numbers of draws scatter"}, &D::centres);
    field({"rounds", "", "rounds of draws that found the centres"}, &D::rounds);
    field({"plain_draws", "", "accepted draws about the inputs of the file"}, &D::plain_draws);
    field({"plain", "1", "probability of failure without inspections by these alone"}, &D::plain);
    field({"plain_low", "1", "lower limit with 95 % confidence"}, &D::plain_low);
    field({"plain_high", "1", "upper limit with 95 % confidence"}, &D::plain_high);
    field({"elsewhere", "1",
           "probability of failures far from the centres that the plain draws do not exclude with "
           "97.5 % confidence"},
          &D::elsewhere);
  }
};

/// A percentile of the life; a drive whose cracks stand still has an endless life, and one without
/// an end in the longest duty counts so.
struct LifePercentile {
  static constexpr bool kTableRow = true;
  double share = 0.0;                ///< of the drives with a shorter life [-]
  std::optional<double> life = {};   ///< [s]; absent: endless
  std::optional<double> lower = {};  ///< limits with 95 % confidence [s]; absent: endless
  std::optional<double> upper = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = LifePercentile;
    field({"share", "1", "share of the drives with a shorter life"}, &P::share);
    field({"life", "s", "the life; absent: endless"}, &P::life);
    field({"lower", "s", "lower limit with 95 % confidence; absent: endless"}, &P::lower);
    field({"upper", "s", "upper limit with 95 % confidence; absent: endless, or not known"},
          &P::upper);
  }
};

/// Effect of one scattering input on the life.
struct LifeShare {
  static constexpr bool kTableRow = true;
  std::string path;
  double share = 0.0;  ///< in the variance of the logarithm of the lives that end, linear part [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "the number that scatters"}, &LifeShare::path);
    field({"share", "1", "share in the variance of the logarithm of the life, linear part"},
          &LifeShare::share);
  }
};

/// Probabilities of failure up to one time.
struct RiskPoint {
  static constexpr bool kTableRow = true;
  double time = 0.0;  ///< [s]
  double without = 0.0;
  double without_low = 0.0;
  double without_high = 1.0;
  std::optional<double> inspected = {};
  std::optional<double> inspected_low = {};
  std::optional<double> inspected_high = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = RiskPoint;
    field({"time", "s", "time of duty"}, &R::time);
    field({"without", "1", "probability of failure without inspections"}, &R::without);
    field({"without_low", "1", "lower limit with 95 % confidence"}, &R::without_low);
    field({"without_high", "1", "upper limit with 95 % confidence"}, &R::without_high);
    field({"inspected", "1", "probability of failure with the inspections"}, &R::inspected);
    field({"inspected_low", "1", "lower limit with 95 % confidence"}, &R::inspected_low);
    field({"inspected_high", "1", "upper limit with 95 % confidence"}, &R::inspected_high);
  }
};

/// One inspection.
struct InspectionRow {
  static constexpr bool kTableRow = true;
  double time = 0.0;        ///< [s]
  double found = 0.0;       ///< probability that it finds a crack, of all drives [-]
  double in_service = 0.0;  ///< share of the drives that are still in service before it [-]
  double false_call = 0.0;  ///< probability of a false call, of all drives [-]
  /// Probability of failure up to the end of service that remains if it is the last one [-]
  double remaining = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using I = InspectionRow;
    field({"time", "s", "time of duty"}, &I::time);
    field({"in_service", "1", "share of the drives in service before it"}, &I::in_service);
    field({"found", "1", "probability that it finds a crack"}, &I::found);
    field({"false_call", "1", "probability of a false call"}, &I::false_call);
    field({"remaining", "1",
           "probability of failure up to the end of service if it is the last inspection"},
          &I::remaining);
  }
};

/// A point of the probability of detection over the size of a crack.
struct DetectionPoint {
  static constexpr bool kTableRow = true;
  double size = 0.0;                  ///< [m]
  double probability = 0.0;           ///< that one inspection finds the crack [-]
  std::optional<double> change = {};  ///< of a measured value by the crack, relative [-]
  /// size at which the lower bound of a curve from trials has the probability [m]
  std::optional<double> bound = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = DetectionPoint;
    field({"size", "m", "depth, or half length of a through crack"}, &P::size);
    field({"probability", "1", "probability that one inspection finds the crack"}, &P::probability);
    field({"change", "1", "of a measurement: share by which the crack changes the measured value"},
          &P::change);
    field({"bound", "m",
           "of a curve from trials: size with this probability on the lower bound with 95 % "
           "confidence"},
          &P::bound);
  }
};

/// How inspections find cracks, and what a find leads to.
struct MethodOfInspection {
  InspectionMeans method = InspectionMeans::curve;
  FindLeadsTo find = FindLeadsTo::out;
  std::optional<double> repaired_to = {};  ///< [m]
  double false_calls = 0.0;                ///< [-]
  std::optional<double> a50 = {};          ///< [m]; absent: no size up to the end
  std::optional<double> a90 = {};          ///< [m]; absent: no size up to the end
  std::optional<double> a50_bound = {};    ///< a50 on the lower bound of trials [m]
  std::optional<double> a90_bound = {};    ///< a90 on the lower bound of trials [m]
  std::optional<int> trials = {};          ///< number of trials behind the curve
  std::string bound_equation = {};         ///< tag of the equation of the bound of trials
  std::optional<int> below_floor = {};     ///< of these, signals at the floor or below
  std::optional<int> above_ceiling = {};   ///< of these, signals at the ceiling or above
  std::string crack = {};            ///< of a measurement: the crack that ends the life of the file
  std::optional<double> noise = {};  ///< of one measurement; the first record counts as exact [-]
  std::optional<double> threshold = {};      ///< change from which on a measurement calls [-]
  std::optional<double> change_ninety = {};  ///< change that nine of ten measurements find [-]
  std::optional<double> size_at_end = {};    ///< of the crack when it ends the life [m]
  std::optional<double> change_at_end = {};  ///< by the crack of this size [-]
  std::optional<double> found_at_end = {};   ///< probability that this crack is found [-]
  std::vector<DetectionPoint> points = {};   ///< by rising size

  template <class Visitor>
  static void describe(Visitor&& field) {
    using M = MethodOfInspection;
    field({"method", "", "what an inspection looks at"}, &M::method);
    field({"find", "", "what a find leads to"}, &M::find);
    field({"repaired_to", "m", "size of a crack after its repair"}, &M::repaired_to);
    field({"false_calls", "1", "probability that an inspection finds what is not there"},
          &M::false_calls);
    field({"a50", "m", "size that is found in half of the cases; absent: no size up to the end"},
          &M::a50);
    field({"a90", "m", "size that is found in nine of ten; absent: no size up to the end"},
          &M::a90);
    field({"a50_bound", "m",
           "a50 on the lower bound of the trials with 95 % confidence; absent: not bounded"},
          &M::a50_bound);
    field({"a90_bound", "m",
           "a90 on the lower bound of the trials with 95 % confidence; absent: not bounded"},
          &M::a90_bound);
    field({"trials", "", "number of trials behind the curve"}, &M::trials);
    field({"bound_equation", "", "equation of the bound of the trials"}, &M::bound_equation);
    field({"below_floor", "", "of these trials, signals at the floor or below"}, &M::below_floor);
    field({"above_ceiling", "", "of these trials, signals at the ceiling or above"},
          &M::above_ceiling);
    field({"crack", "", "of a measurement: the crack that ends the life of the file"}, &M::crack);
    field({"noise", "1", "standard deviation of a measured change over the measured value"},
          &M::noise);
    field({"threshold", "1", "change from which on a measurement counts as a find"}, &M::threshold);
    field({"change_ninety", "1", "smallest change that nine of ten measurements find"},
          &M::change_ninety);
    field({"size_at_end", "m", "size of the crack when it ends the life"}, &M::size_at_end);
    field({"change_at_end", "1", "change of the measured value by the crack of this size"},
          &M::change_at_end);
    field({"found_at_end", "1", "probability that one measurement finds the crack of this size"},
          &M::found_at_end);
    field({"points", "", "probability of detection over the size"}, &M::points);
  }
};

/// Expected cost of one drive up to the end of service, in the currency of the file.
struct ExpectedCost {
  double without = 0.0;                    ///< of failures without inspections [-]
  std::optional<double> inspected = {};    ///< with the inspections [-]; sum of the three below
  std::optional<double> inspections = {};  ///< of the inspections [-]
  std::optional<double> calls = {};        ///< of finds and false calls [-]
  std::optional<double> failures = {};     ///< of failures [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = ExpectedCost;
    field({"without", "1", "of failures, without inspections"}, &C::without);
    field({"inspected", "1", "with the inspections: the sum of the three below"}, &C::inspected);
    field({"inspections", "1", "of the inspections"}, &C::inspections);
    field({"calls", "1", "of finds and false calls"}, &C::calls);
    field({"failures", "1", "of failures, with the inspections"}, &C::failures);
  }
};

/// Inspections that keep a wanted risk.
struct PlannedInspections {
  std::string kind;  ///< "equal" or "least"
  bool reached = false;
  int inspections = 0;
  std::vector<double> times;  ///< [s]
  double risk = 0.0;          ///< [-]
  double risk_low = 0.0;
  double risk_high = 1.0;
  std::optional<double> cost = {};  ///< expected, of one drive [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = PlannedInspections;
    field({"kind", "", "equal intervals, or times of least risk"}, &P::kind);
    field({"reached", "", "whether the wanted risk is reached"}, &P::reached);
    field({"inspections", "", "number of inspections"}, &P::inspections);
    field({"times", "s", "times of duty"}, &P::times);
    field({"risk", "1", "probability of failure up to the end of service"}, &P::risk);
    field({"risk_low", "1", "lower limit with 95 % confidence"}, &P::risk_low);
    field({"risk_high", "1", "upper limit with 95 % confidence"}, &P::risk_high);
    field({"cost", "1", "expected cost of one drive"}, &P::cost);
  }
};

/// The result of `strainwave inspect`.
struct InspectionReport {
  std::string sentence;                     ///< the answer in words
  double until = 0.0;                       ///< end of service [s]
  std::optional<double> nominal_life = {};  ///< at the values of the file [s]
  int draws = 0;
  std::uint64_t seed = 0;
  DrawnOutcomes outcomes;
  std::vector<LifePercentile> percentiles;
  std::vector<LifeShare> shares;
  RiskPoint at_end;  ///< at the end of service
  std::vector<RiskPoint> risk;
  std::optional<DrawsAboutFailures> importance_sampling = {};  ///< absent: plain draws alone
  std::optional<MethodOfInspection> method = {};               ///< absent: no inspections
  std::vector<InspectionRow> inspections;
  std::vector<PlannedInspections> plans;
  /// Risk at the end of service by the lower bound of detection of trials [-]
  std::optional<double> bound_risk = {};
  std::optional<ExpectedCost> cost = {};  ///< absent: the file gives no cost
  /// Half of the time from the size a90 to the end of the life, at the values of the file [s]
  std::optional<double> half_interval = {};
  std::vector<Note> notes;             ///< remarks on the validity of the probabilities
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = InspectionReport;
    field({.name = "sentence", .unit = "", .doc = "the answer in words", .headline = true},
          &R::sentence);
    field({.name = "until", .unit = "s", .doc = "end of service", .headline = true}, &R::until);
    field({"nominal_life", "s", "life at the values of the file; absent: endless"},
          &R::nominal_life);
    field({"draws", "", "number of drawn drives"}, &R::draws);
    field({"seed", "", "seed of the draws"}, &R::seed);
    field({"outcomes", "", "how the drawn drives end"}, &R::outcomes);
    field({"percentiles", "", "percentiles of the life"}, &R::percentiles);
    field({"shares", "", "what the scatter of the life comes from"}, &R::shares);
    field({"at_end", "", "probabilities of failure up to the end of service"}, &R::at_end);
    field({"risk", "", "probabilities of failure over time"}, &R::risk);
    field({"importance_sampling", "", "the draws about the failures, and what the others say"},
          &R::importance_sampling);
    field({"method", "", "how inspections find cracks, and what a find leads to"}, &R::method);
    field({"inspections", "", "each inspection"}, &R::inspections);
    field({"bound_risk", "1",
           "probability of failure with the inspections, by the lower bound of detection with 95 % "
           "confidence from the trials"},
          &R::bound_risk);
    field({"cost", "", "expected cost of one drive, in the currency of the file"}, &R::cost);
    field({"plans", "", "inspections that keep the wanted risk"}, &R::plans);
    field({"half_interval", "s",
           "half of the time from the size a90 of the crack that ends the life to this end, at the "
           "values of the file"},
          &R::half_interval);
  }
};

/// Draws lives of a drive whose numbers scatter, and states the risk without and with inspections.
///
/// Implements theory manual eqs. (IR-1) to (IR-16).  Draws depend on seed, number and input alone,
/// and are summed in their order, so the bits are the same for any number of threads.
/// @param gear      has passed `check`, with cracks, a duty and [[scatter]]; its [inspection] says
///                  how cracks are looked for
/// @param options   end of service, inspections and draws; `draws` 20 to 1 000 000
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError    if something of this is missing, or an option is out of range
/// @throws Stopped       if the caller requests a stop
/// @throws ShareDone     after the draws of a share were computed and kept
/// @throws BrokenRecord  if draws that are read are not those of this study
[[nodiscard]] InspectionReport inspection_report(const GearSet& gear,
                                                 const InspectionOptions& options,
                                                 const Progress& progress = {});

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/growth_scatter/fit.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// Law of growth and its scatter from measured specimens, and how well it predicts specimens that
/// the fit did not see.

namespace strainwave {

/// The test whose records are read; without a stress range the file gives the column delta_K.
using GrowthTest = std::optional<PlateTest>;

/// Reads the records of specimens.
///
/// A wide file has the size in its first column and the cycles of one specimen in each further
/// column. A long file has the columns specimen (a number), crack_length and cycles; a new number
/// begins a new specimen.  Long files may have the column delta_K.
/// @throws InputError  naming file, line, column and value, if a column or its unit is missing, or
/// a
///                     size or a number of cycles is not larger than the one before
[[nodiscard]] std::vector<GrowthSpecimen> read_specimens(HistoryFile& file, const GrowthTest& test);

/// One knot of the median rate.
struct FittedKnot {
  double delta_K = 0.0;         ///< [Pa*sqrt(m)]
  double rate = 0.0;            ///< median [m] per cycle
  double relative_error = 0.0;  ///< standard error of ln(rate) [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using K = FittedKnot;
    field({"delta_K", "Pa*m^0.5", "range of the stress intensity factor"}, &K::delta_K);
    field({"rate", "m", "median growth in a cycle"}, &K::rate);
    field({"relative_error", "1", "standard error of the logarithm of the rate"},
          &K::relative_error);
  }
};

/// A parameter of the scatter with its standard error.
struct FittedParameter {
  std::string name;
  double value = 0.0;                ///< [-]
  std::optional<double> error = {};  ///< standard error [-]; absent: the records do not tell
  /// whether the value is larger than two standard errors; for the logarithm of a length, whether
  /// the error is below 1
  bool identified = false;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = FittedParameter;
    field({"name", "", "what varies"}, &P::name);
    field({"value", "1", "its value"}, &P::value);
    field({"error", "1", "standard error; absent if the records do not determine the value"},
          &P::error);
    field({"identified", "", "whether the value exceeds two standard errors"}, &P::identified);
  }
};

/// A number of knots that was tried.
struct TriedKnots {
  int knots = 0;
  double log_likelihood = 0.0;
  double criterion = 0.0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using T = TriedKnots;
    field({"knots", "", "number of knots of the median rate"}, &T::knots);
    field({"log_likelihood", "1", "logarithm of the likelihood"}, &T::log_likelihood);
    field({"criterion", "1", "Bayesian information criterion; the least is taken"}, &T::criterion);
  }
};

/// How bands of unseen specimens compare with what the specimens did.
struct BandCheck {
  std::optional<double> known = {};  ///< size up to which the own record was known [m]
  double size = 0.0;                 ///< size whose cycles were predicted [m]
  int specimens = 0;                 ///< that reached it
  int inside = 0;                    ///< of the band
  int fewest = 0;                    ///< a right model has this many inside, or more,
  int most = 0;                      ///< and at most this many, with 99 % probability together
  double mean_width = 0.0;           ///< of the bands [-]
  /// Over the width of a log-normal band fitted to the same specimens; for bands without a record
  std::optional<double> width_over_lognormal = {};
  /// Over the width of the band of the same cycles without the record; for bands with one
  std::optional<double> width_over_unknown = {};
  double distance = 0.0;  ///< Kolmogorov's distance of the transforms from uniform [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using B = BandCheck;
    field({"known", "m", "size up to which the specimen's own record was known; absent: nothing"},
          &B::known);
    field({"size", "m", "size whose cycles were predicted"}, &B::size);
    field({"specimens", "", "specimens that reached the size"}, &B::specimens);
    field({"inside", "", "specimens inside of their band"}, &B::inside);
    field({"fewest", "", "lower end of the numbers inside that a right model has with 99 %"},
          &B::fewest);
    field({"most", "", "upper end of them"}, &B::most);
    field({"mean_width", "1", "mean width of the bands in cycles"}, &B::mean_width);
    field({"width_over_lognormal", "1",
           "mean width over that of a log-normal distribution fitted to the same specimens"},
          &B::width_over_lognormal);
    field({"width_over_unknown", "1", "mean width over that without the specimen's own record"},
          &B::width_over_unknown);
    field({"distance", "1", "largest distance of the probability transforms from uniform"},
          &B::distance);
  }
};

/// The band of one specimen.
struct SpecimenBand {
  std::string specimen;
  std::optional<double> known = {};  ///< [m]
  double size = 0.0;                 ///< [m]
  double cycles = 0.0;               ///< measured, from the first size or from `known` [-]
  double low = 0.0;                  ///< [-]
  double median = 0.0;               ///< [-]
  double high = 0.0;                 ///< [-]
  double transform = 0.0;            ///< probability that the model gives to fewer cycles [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = SpecimenBand;
    field({"specimen", "", "name of the specimen"}, &S::specimen);
    field({"known", "m", "size up to which its own record was known; absent: nothing"}, &S::known);
    field({"size", "m", "size whose cycles are predicted"}, &S::size);
    field({"cycles", "1", "measured cycles from the first size, or from the known one"},
          &S::cycles);
    field({"low", "1", "lower end of the band"}, &S::low);
    field({"median", "1", "median"}, &S::median);
    field({"high", "1", "upper end of the band"}, &S::high);
    field({"transform", "1", "probability that the model gives to fewer cycles than measured"},
          &S::transform);
  }
};

/// How the specimens were judged.
enum class JudgedBy { leave_one_out, other_specimens };
template <>
struct EnumNames<JudgedBy> {
  static constexpr std::array<std::string_view, 2> names = {"leave_one_out", "other_specimens"};
};

/// What the records of the specimens are, and what they do not say: the validity of law and
/// scatter.
struct GrowthFitBasis {
  std::string test = {};                    ///< how the ranges of K were found, in words
  std::optional<double> stress_ratio = {};  ///< R of the test, as stated [-]; absent: not stated
  double from = 0.0;                        ///< least range of a step [Pa*sqrt(m)]
  double to = 0.0;                          ///< greatest range of a step [Pa*sqrt(m)]
  double step = 0.0;                        ///< geometric mean of the lengths of the steps [m]
  double pivot = 0.0;                       ///< range at which the level holds [Pa*sqrt(m)]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using B = GrowthFitBasis;
    field({"test", "", "how the ranges of the stress intensity factor were found"}, &B::test);
    field({"stress_ratio", "1", "R of the test, as stated; absent: not stated"}, &B::stress_ratio);
    field({"from", "Pa*m^0.5", "least range of a step of the records"}, &B::from);
    field({"to", "Pa*m^0.5", "greatest range of a step of the records"}, &B::to);
    field({"step", "m", "geometric mean of the lengths of the steps"}, &B::step);
    field({"pivot", "Pa*m^0.5", "range at which the level of a specimen holds"}, &B::pivot);
  }
};

/// A law of growth with its scatter, and its predictions judged.
struct GrowthFitReport {
  int specimens = 0;
  int steps = 0;
  PooledLine pooled;  ///< one straight line through all steps (GS-2)
  std::vector<FittedKnot> knots;
  std::vector<FittedParameter> scatter;
  ScatterParts parts;            ///< of the scatter that were fitted
  ScatterParameters parameters;  ///< of the scatter; those of `parts` count
  GrowthFitBasis basis;          ///< what law and scatter are stated for
  std::vector<TriedKnots> tried;
  double log_likelihood = 0.0;
  bool converged = false;
  std::string reason;
  JudgedBy judged_by = JudgedBy::leave_one_out;
  double confidence = 0.0;
  std::vector<BandCheck> checks;
  std::optional<double> coverage;  ///< mean share inside over the bands without a record [-]
  std::vector<SpecimenBand> bands;
  std::vector<Note> notes;             ///< remarks on the validity of law and bands
  std::vector<std::string> equations;  ///< tags of the theory manual
  std::string unusable_because;        ///< reason why the answer must not be used; empty if usable

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = GrowthFitReport;
    field({"specimens", "", "specimens of the fit"}, &R::specimens);
    field({"steps", "", "their steps of growth"}, &R::steps);
    field({"pooled_exponent", "1", "exponent m of one straight line through all steps"},
          [](const R& r) { return r.pooled.exponent; });
    field(
        {"pooled_log_coefficient", "1", "ln C of this line, in metres per cycle at 1 MPa*sqrt(m)"},
        [](const R& r) { return r.pooled.log_coefficient; });
    field({"pooled_deviation", "1", "standard deviation of a step from this line"},
          [](const R& r) { return r.pooled.deviation; });
    field({"knots", "", "median rate of growth"}, &R::knots);
    field({"scatter", "", "parameters of the scatter"}, &R::scatter);
    field({"basis", "", "what law and scatter are stated for"}, &R::basis);
    field({"tried", "", "numbers of knots that were tried"}, &R::tried);
    field({"log_likelihood", "1", "logarithm of the likelihood"}, &R::log_likelihood);
    field({"converged", "", "whether the search found a maximum"}, &R::converged);
    field({"reason", "", "how the search ended"}, &R::reason);
    field({"judged_by", "", "specimens of which the bands were judged"}, &R::judged_by);
    field({"confidence", "1", "probability of a band"}, &R::confidence);
    field({"checks", "", "bands of unseen specimens against their records"}, &R::checks);
    field({"coverage", "1", "mean share of specimens inside, over the bands without own record"},
          &R::coverage);
    field({"bands", "", "band of each specimen"}, &R::bands);
  }
};

/// What is fitted, and which bands are judged.
struct GrowthFitRequest {
  GrowthFitSettings fit;      ///< parts of the scatter and number of knots
  std::vector<double> sizes;  ///< whose cycles are predicted [m]; empty: five over the record
  std::vector<double> known;  ///< sizes up to which the own record is known, too [m]
  double confidence = 0.9;    ///< of the bands [-]; in (0, 1)
  int draws = 4000;           ///< >= 100
  std::uint64_t seed = 1;     ///< seed of the draws; the same seed gives the same bands
  int threads = 0;            ///< 0: as many as the machine runs; does not change the answer
  GrowthTest test = {};       ///< from which the ranges came; absent: measured ranges
  std::optional<double> stress_ratio = {};  ///< R of the test [-]; < 1; absent: not stated
  /// Specimens to judge; empty: each specimen of the fit, by a fit to all others.
  std::vector<GrowthSpecimen> judged;
};

/// Fits law and scatter, and judges bands of specimens that the fit did not see.
///
/// Implements theory manual eqs. (GS-2) to (GS-11).
/// @throws InputError  as fit_growth; if a size lies in no record; if a single specimen is to be
///                     judged by the others
[[nodiscard]] GrowthFitReport growth_fit_report(const std::vector<GrowthSpecimen>& specimens,
                                                const GrowthFitRequest& request,
                                                const Progress& progress = {});

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/factors.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Validation: the torsion curve compared with the makers' stiffness tables.

namespace strainwave {

/// Which factors a validation fits, and to what.
enum class ValidationMode {
  geometry,             ///< no factor is fitted
  leave_one_size_out,   ///< at most three factors, fitted to all other sizes
  leave_one_class_out,  ///< at most three factors, fitted to all other classes of ratio
  per_row,              ///< at most three factors, fitted to each row alone: shows what the model
                        ///< can follow, not what it predicts
};
template <>
struct EnumNames<ValidationMode> {
  static constexpr std::array<std::string_view, 4> names = {"geometry", "leave-one-size-out",
                                                            "leave-one-class-out", "per-row"};
};

/// What a validation predicts, and how.
struct ValidationOptions {
  ValidationMode mode = ValidationMode::geometry;  ///< which factors are fitted, and to what
  /// Factors for the modes that fit.  If the list is empty, leave-one-size-out and
  /// leave-one-class-out use support, coning and cam_flattening: one unknown each of housing, tooth
  /// and cam, because makers do not publish these.
  /// Per-row then uses coning, gap_factor and structure, which bend the curve at its beginning,
  /// middle and end.
  std::vector<Factor> factors = {};
  Blank blank = Blank::ratio;  ///< of all drives
  bool all_sets = false;       ///< also fit every set of one to three factors to all sizes at once
  int draws = 0;               ///< draws of the proportions for the bands; 0, or 2 to 100000
  /// seed of the draws of the proportions; the same seed gives the same draws
  std::uint64_t seed = 1;
  std::vector<int> sizes = {};  ///< sizes of the catalogue to predict; empty: all
  /// Rows of a user, which judge only (parse_stiffness_rows).
  std::vector<StiffnessRow> data = {};
  CoupledOptions coupled = {};  ///< options of the coupled drive, for all predictions
};

/// Quantiles 5 %, 50 % and 95 % of the drawn predictions with the discrepancy of the model (CV-3)
/// [N*m/rad].
struct PredictionBand {
  double low = 0.0;     ///< quantile 5 % [N*m/rad]
  double middle = 0.0;  ///< quantile 50 % [N*m/rad]
  double high = 0.0;    ///< quantile 95 % [N*m/rad]
};

/// One row of a table and its prediction, at one ratio or as the mean over several.
struct ValidationRow {
  StiffnessRow catalogue;             ///< the row of the table
  std::vector<double> ratios;         ///< reduction ratios over which `predicted` is the mean
  std::array<double, 3> predicted{};  ///< K1, K2, K3 [N*m/rad]
  std::array<double, 3> least{};      ///< least prediction over the ratios [N*m/rad]
  std::array<double, 3> most{};       ///< largest prediction over the ratios [N*m/rad]
  /// values of the factors in the prediction; empty in mode geometry
  std::vector<double> factors;
  std::vector<bool> at_limit;  ///< whether each factor is at a limit
  /// bands of K1, K2, K3; absent if nothing was drawn
  std::array<std::optional<PredictionBand>, 3> band;
  /// why the row lies outside of what the bands were made from; empty if it lies inside
  std::string outside = {};

  /// predicted/catalogue of K1, K2, K3 [-]; absent if the table has no value
  [[nodiscard]] std::array<std::optional<double>, 3> ratio() const;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using Row = ValidationRow;
    StiffnessRow::describe_drive([&](const Field& of_drive, auto member) {
      if constexpr (!std::is_same_v<decltype(member), std::vector<double> StiffnessRow::*>)
        field(of_drive, [member](const Row& row) { return row.catalogue.*member; });
    });
    field({"ratios", "1", "reduction ratios over which predicted is the mean"}, &Row::ratios);
    field({"T1", "N*m", "upper torque of K1"}, [](const Row& row) { return row.catalogue.T1; });
    field({"T2", "N*m", "upper torque of K2"}, [](const Row& row) { return row.catalogue.T2; });
    field({"T3", "N*m", "upper torque of the comparison of K3"},
          [](const Row& row) { return row.catalogue.T3(); });
    describe_line<0>(field, {"catalogue_K1", "predicted_K1", "least_K1", "most_K1", "ratio_K1",
                             "low_K1", "middle_K1", "high_K1"});
    describe_line<1>(field, {"catalogue_K2", "predicted_K2", "least_K2", "most_K2", "ratio_K2",
                             "low_K2", "middle_K2", "high_K2"});
    describe_line<2>(field, {"catalogue_K3", "predicted_K3", "least_K3", "most_K3", "ratio_K3",
                             "low_K3", "middle_K3", "high_K3"});
    field({"factors", "1", "values of the factors in the prediction"}, &Row::factors);
    field({"at_limit", "", "whether each factor is at a limit"}, &Row::at_limit);
    field({"outside", "", "why the row lies outside of what the bands were made from"},
          &Row::outside);
  }

 private:
  /// Describes one of K1, K2, K3; the band is absent if nothing was drawn.
  template <std::size_t k, class Visitor>
  static void describe_line(Visitor&& field, const std::array<std::string_view, 8>& names) {
    using Row = ValidationRow;
    field({names[0], "N*m/rad", "stiffness that the table states"},
          [](const Row& row) { return row.catalogue.K()[k]; });
    field({names[1], "N*m/rad", "predicted, mean over the ratios"},
          [](const Row& row) { return row.predicted[k]; });
    field({names[2], "N*m/rad", "least prediction over the ratios"},
          [](const Row& row) { return row.least[k]; });
    field({names[3], "N*m/rad", "largest prediction over the ratios"},
          [](const Row& row) { return row.most[k]; });
    field({names[4], "1", "predicted/catalogue"}, [](const Row& row) { return row.ratio()[k]; });
    field({names[5], "N*m/rad", "5 % quantile of the drawn predictions with the discrepancy"},
          [](const Row& row) { return row.of_band(k, &PredictionBand::low); });
    field({names[6], "N*m/rad", "50 % quantile of the drawn predictions with the discrepancy"},
          [](const Row& row) { return row.of_band(k, &PredictionBand::middle); });
    field({names[7], "N*m/rad", "95 % quantile of the drawn predictions with the discrepancy"},
          [](const Row& row) { return row.of_band(k, &PredictionBand::high); });
  }
  [[nodiscard]] std::optional<double> of_band(std::size_t k, double PredictionBand::*limit) const {
    return band[k] ? std::optional((*band[k]).*limit) : std::nullopt;
  }
};

/// Statistics of |predicted/catalogue - 1| over a group of rows [-].
struct ErrorSummary {
  std::string of = {};  ///< name of the group of rows
  int rows = 0;
  int values = 0;
  double median = 0.0;
  double worst = 0.0;
  std::array<std::optional<double>, 3> median_of{};  ///< medians of K1, K2, K3; absent: no value
  std::array<std::optional<double>, 3> worst_of{};  ///< largest of K1, K2, K3 [-]; absent: no value
  /// medians of largest/least - 1 over the ratios of a row, of the rows with several ratios [-]
  std::array<std::optional<double>, 3> spread_of{};
  int in_band = 0;  ///< how many of `values` lie between `low` and `high`

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"of", "", "name of the group of rows"}, &ErrorSummary::of);
    field({"rows", "1", "number of rows"}, &ErrorSummary::rows);
    field({"values", "1", "number of values"}, &ErrorSummary::values);
    field({"median", "1", "median of |predicted/catalogue - 1|"}, &ErrorSummary::median);
    field({"worst", "1", "largest of |predicted/catalogue - 1|"}, &ErrorSummary::worst);
    field({"median_K1", "1", "median for K1 alone"},
          [](const ErrorSummary& s) { return s.median_of[0]; });
    field({"median_K2", "1", "median for K2 alone"},
          [](const ErrorSummary& s) { return s.median_of[1]; });
    field({"median_K3", "1", "median for K3 alone"},
          [](const ErrorSummary& s) { return s.median_of[2]; });
    field({"worst_K1", "1", "largest for K1 alone"},
          [](const ErrorSummary& s) { return s.worst_of[0]; });
    field({"worst_K2", "1", "largest for K2 alone"},
          [](const ErrorSummary& s) { return s.worst_of[1]; });
    field({"worst_K3", "1", "largest for K3 alone"},
          [](const ErrorSummary& s) { return s.worst_of[2]; });
    field({"spread_K1", "1", "median of largest/least - 1 over the ratios of a row, for K1"},
          [](const ErrorSummary& s) { return s.spread_of[0]; });
    field({"spread_K2", "1", "median of largest/least - 1 over the ratios of a row, for K2"},
          [](const ErrorSummary& s) { return s.spread_of[1]; });
    field({"spread_K3", "1", "median of largest/least - 1 over the ratios of a row, for K3"},
          [](const ErrorSummary& s) { return s.spread_of[2]; });
    field({"in_band", "1", "number of values within the band"}, &ErrorSummary::in_band);
  }
};

/// The discrepancy of the model, by which the bands are wider than the draws of the proportions.
///
/// It is a fit of the bands to the catalogue's short cups, never of a prediction.  Implements
/// theory manual eq. (CV-3).  All spreads are standard deviations of ln K.
struct BandFit {
  int classes = 0;           ///< classes of size and ratio
  int values = 0;            ///< values of the catalogue
  double between = 0.0;      ///< root mean square of the mean errors of the classes [-]
  double within = 0.0;       ///< spread of the errors within a class [-]
  double draws = 0.0;        ///< spread by the draws of the proportions [-]
  double discrepancy = 0.0;  ///< spread by which the bands are wider than the draws [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"classes", "", "classes of size and ratio to which the bands are fitted"},
          &BandFit::classes);
    field({"values", "", "values of the catalogue in these classes"}, &BandFit::values);
    field({"between", "1", "root mean square of the mean errors of the classes, of ln K"},
          &BandFit::between);
    field({"within", "1", "standard deviation of the errors within a class, of ln K"},
          &BandFit::within);
    field({"draws", "1", "standard deviation by the draws of the proportions, of ln K"},
          &BandFit::draws);
    field({"discrepancy", "1",
           "standard deviation of ln K by which the bands are wider than the draws; a fit of the "
           "bands, never of a prediction"},
          &BandFit::discrepancy);
  }
};

/// How many values of a class lie within their 90 % bands.
struct BandTest {
  std::string of = {};  ///< name of the class, or of all classes in turn
  int values = 0;
  int in_band = 0;                         ///< with bands from all classes
  int left_out = 0;                        ///< with bands from the other classes
  std::optional<double> discrepancy = {};  ///< that of the other classes [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"of", "", "class of size or ratio, or all of them in turn"}, &BandTest::of);
    field({"values", "1", "number of values"}, &BandTest::values);
    field({"in_band", "1", "values within bands that are fitted to all classes"},
          &BandTest::in_band);
    field({"left_out", "1", "values within bands that are fitted to the other classes"},
          &BandTest::left_out);
    field({"discrepancy", "1", "discrepancy of the bands that are fitted to the other classes"},
          &BandTest::discrepancy);
  }
};

/// A set of factors fitted to all sizes at once.
struct FactorTrial {
  std::vector<Factor> factors;
  std::vector<double> values;
  std::vector<bool> at_limit;
  int fitted = 0;       ///< number of values of the catalogue to which the factors are fitted
  double median = 0.0;  ///< median of |error| over the fitted rows
  double worst = 0.0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"factors", "", "names of the factors"}, &FactorTrial::factors);
    field({"values", "1", "fitted values of the factors"}, &FactorTrial::values);
    field({"at_limit", "", "whether each factor is at a limit"}, &FactorTrial::at_limit);
    field({"fitted", "1", "number of values to which the factors are fitted"},
          &FactorTrial::fitted);
    field({"median", "1", "median of |error| over the fitted rows"}, &FactorTrial::median);
    field({"worst", "1", "largest of |error| over the fitted rows"}, &FactorTrial::worst);
  }
};

/// The result of a validation: predictions of all rows, and their errors.
struct Validation {
  ValidationOptions options;              ///< with the factors filled in
  std::vector<ValidationRow> rows;        ///< each row, as the mean over its ratios
  std::vector<ErrorSummary> errors;       ///< of `rows`
  std::vector<ValidationRow> each_ratio;  ///< each row at each of its ratios
  std::vector<ErrorSummary> errors_at_each_ratio;
  std::vector<FactorTrial> trials;  ///< the set in use first, then the other sets on request
  std::optional<BandFit> band_fit;  ///< absent if nothing was drawn
  std::vector<BandTest> band_tests;
  int failed_draws = 0;          ///< draws left out because they have no equilibrium
  std::vector<Note> notes = {};  ///< remarks on the validity of the bands

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"mode", "", "which factors are fitted, and to what"},
          [](const Validation& v) { return v.options.mode; });
    field({"factors", "", "names of the fitted factors"},
          [](const Validation& v) { return v.options.factors; });
    field({"blank", "", "the wave for which the walls of the drives are made"},
          [](const Validation& v) { return v.options.blank; });
    field({"draws", "", "drives drawn for the bands"},
          [](const Validation& v) { return v.options.draws; });
    field({"failed_draws", "", "draws left out because they have no equilibrium"},
          &Validation::failed_draws);
    field({"seed", "", "seed of the draws"}, [](const Validation& v) { return v.options.seed; });
    field({"band_fit", "", "discrepancy of the model in the bands"}, &Validation::band_fit);
    field({"band_tests", "", "values within their bands, with each class left out in turn"},
          &Validation::band_tests);
    field({"errors", "", "errors over groups of rows, a row as the mean over its ratios"},
          &Validation::errors);
    field({"errors_at_each_ratio", "", "errors over groups of rows, each row at each ratio"},
          &Validation::errors_at_each_ratio);
    field({"rows", "", "each row of the tables and its prediction, the mean over its ratios"},
          &Validation::rows);
    field({"each_ratio", "", "each row of the tables and its prediction at each of its ratios"},
          &Validation::each_ratio);
    field({"sets_tried", "", "sets of factors fitted to all sizes at once"}, &Validation::trials);
  }
};

/// Whether a fit uses this row: a row of the catalogue, size 17 and more, ratio 50 and more.  In
/// the catalogue, smaller sizes deviate from the similarity K ~ d^3 by 20 to 50 %.  At ratio 30 the
/// model is not valid.
[[nodiscard]] bool is_regular(const StiffnessRow& row);

/// Predicts every row of the catalogue, of other series and of a user with the typical drive of
/// each of its ratios, without an output shaft, at the row's T1 and T2 and at 1.6 T2.  A row of the
/// class 80 and more states one number for several ratios, so it is judged by the mean over the
/// ratios that the maker offers in this size, and at each ratio by itself.
///
/// In the modes that leave out, every row is predicted by a fit to the catalogue's rows of other
/// sizes or of other classes.  Fits are least squares of ln K with equal weights, with factors in
/// their plausible ranges (factor_info).
///
/// Mode `per_row` fits each row alone.  It leaves out the rows of other series, and refuses rows of
/// a user.
///
/// @param options   `draws` 0 or 2 to 100000, at most three factors; {}: no fit and no bands
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param shared    null, or the part of the draws that this process computes or reads
/// @param to        null, or takes each draw: its proportions, and K1 to K3 of each row at each of
///                  its ratios; untouched without draws
/// @throws InputError    if an option is out of range or does not suit the mode, or if a size is
///                       unknown
/// @throws SolverError   if a drive has no equilibrium
/// @throws Stopped       if the caller requests a stop
/// @throws ShareDone     after the draws of a share were computed and kept
/// @throws BrokenRecord  if draws that are read are not those of this study
[[nodiscard]] Validation validate(const ValidationOptions& options = {},
                                  const Progress& progress = {}, SharedRows* shared = nullptr,
                                  RowSink* to = nullptr);

}  // namespace strainwave

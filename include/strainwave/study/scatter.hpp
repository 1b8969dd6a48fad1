// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/study/sobol_report.hpp"
#include "strainwave/study/table_evidence.hpp"

/// @file
/// Effect of the scatter of the inputs on stiffness and stiffness loss, by first order and by Monte
/// Carlo.

namespace strainwave {

/// Largest number of draws in one study.
inline constexpr int kMaxSamples = 1'000'000'000;
/// Largest number of draws whose values are kept; they take 480 MB.  A study of more draws takes
/// 0.2 GB, because it keeps only values about the quantiles, and draws again if these are not
/// enough.
inline constexpr int kKeptSamples = 10'000'000;

/// Draws of a study of scatter.
struct ScatterOptions {
  int samples = 100'000;   ///< draws; 2 to kMaxSamples
  std::uint64_t seed = 1;  ///< the same seed gives the same draws
  /// 0: as many as the machine can run; the result is the same for any number
  int threads = 0;
  SharedRows* shared = nullptr;  ///< null, or the part of the draws computed or read here
  int kept = kKeptSamples;       ///< largest number of draws whose values are kept
  /// Null, or takes each draw: its inputs, its outputs, and the rule that it breaks.
  RowSink* rows = nullptr;
};

/// An output under the scatter of the inputs.
struct ScatterOutput {
  std::string name;
  std::string_view unit;
  double value = 0.0;  ///< value at the inputs of the file
  /// First-order results (SN-7).
  double first_order = 0.0;  ///< relative standard deviation [-]
  /// Share of each scattering input in its square, with its part of the covariances.  The sum is 1,
  /// or all are 0.
  std::vector<double> share;
  /// Monte Carlo results (SN-8), over the evaluated draws.
  double mean = 0.0;
  double relative_deviation = 0.0;        ///< standard deviation over mean [-]
  double relative_deviation_error = 0.0;  ///< standard error of relative_deviation [-]
  double mean_error = 0.0;                ///< standard error of the mean, over the mean [-]
  double low = 0.0;                       ///< 5 % of the draws are lower
  double median = 0.0;
  double high = 0.0;  ///< 95 % of the draws are lower
  /// One standard relative uncertainty of the model's form; it does not include the scatter.
  std::optional<double> model_uncertainty;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = ScatterOutput;
    field({"name", "", "the output"}, &O::name);
    field({"unit", "", "SI unit of the output"}, &O::unit);
    field({"value", kUnitBeside, "value at the inputs of the file"}, &O::value);
    field({"first_order", "1", "relative standard deviation, first order"}, &O::first_order);
    field({"share", "1",
           "share of each scattering input in the square of first_order; with its part of the "
           "covariances"},
          &O::share);
    field({"mean", kUnitBeside, "mean of the draws"}, &O::mean);
    field({"relative_deviation", "1", "standard deviation over mean of the draws"},
          &O::relative_deviation);
    field({"relative_deviation_error", "1", "standard error of the relative deviation"},
          &O::relative_deviation_error);
    field({"mean_error", "1", "standard error of the mean, over the mean"}, &O::mean_error);
    field({"low", kUnitBeside, "5 % of the draws are lower"}, &O::low);
    field({"median", kUnitBeside, "half of the draws are lower"}, &O::median);
    field({"high", kUnitBeside, "95 % of the draws are lower"}, &O::high);
    field(
        {"model_uncertainty", "1", "relative uncertainty of the model's form, without the scatter"},
        &O::model_uncertainty);
  }
};

/// An input that scatters.
struct ScatteredInput {
  std::string path;
  double relative_standard_deviation = 0.0;  ///< s [-]
  ScatterDistribution distribution = ScatterDistribution::lognormal;
  std::string source;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using I = ScatteredInput;
    field({"path", "", "path of the number"}, &I::path);
    field({"relative_standard_deviation", "1", "standard deviation over the value in the file"},
          &I::relative_standard_deviation);
    field({"distribution", "", "distribution about the value in the file"}, &I::distribution);
    field({"source", "", "one line"}, &I::source);
  }
};

/// Combined uncertainty of stiffness and loss from the scatter of the inputs.
struct Scatter {
  std::vector<ScatteredInput> inputs;  ///< scatter as in the file
  std::vector<ScatterOutput> outputs;
  int samples = 0;    ///< requested draws
  int evaluated = 0;  ///< draws with a result
  /// draws that broke a rule of the input, such as a crack deeper than its wall
  int refused = 0;
  int unusable = 0;  ///< draws beyond the validity of the model
  std::uint64_t seed = 0;
  std::optional<TableEvidence> tables;  ///< absent if the engine computed all draws
  std::vector<Note> notes;              ///< remarks on the validity of the results

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"inputs", "", "scatter that the file gives"}, &Scatter::inputs);
    field({"outputs", "", "combined uncertainty of each output"}, &Scatter::outputs);
    field({"samples", "", "requested draws"}, &Scatter::samples);
    field({"evaluated", "", "draws with a result"}, &Scatter::evaluated);
    field({"refused", "", "draws that broke a rule of the input"}, &Scatter::refused);
    field({"unusable", "", "draws beyond the validity of the model"}, &Scatter::unusable);
    field({"seed", "", "seed of the draws"}, &Scatter::seed);
    field(
        {"tables", "", "error of the tables that the draws read; absent: the engine computed all"},
        &Scatter::tables);
  }
};

/// Dependence of stiffness and stiffness loss on each input, and the effect of the inputs' scatter.
struct SensitivityReport {
  Sensitivity sensitivity;  ///< derivatives with respect to each input
  std::optional<Scatter> scatter;
  std::optional<Sobol> sobol = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    Sensitivity::describe([&](const Field& what, auto member) {
      field(what,
            [member](const SensitivityReport& r) { return std::invoke(member, r.sensitivity); });
    });
    field({"scatter", "", "combined uncertainty from the scatter of the inputs"},
          &SensitivityReport::scatter);
    field({"sobol", "", "shares of the scattering inputs in the variance of outputs"},
          &SensitivityReport::sobol);
  }
};

/// The notes of all studies.
[[nodiscard]] ResultEvidence evidence_of(const SensitivityReport& report);

/// Propagates the scatter of the inputs that the file gives.
///
/// The first-order result (SN-7) uses the exact elasticities.  For the Monte Carlo result (SN-8),
/// every draw is a full evaluation of the series model.  Draws depend on seed, number and input
/// alone, and results are summed in the order of the draws, so the bits are the same for any number
/// of threads.
///
/// @param gear         the drive, with [[scatter]]; is checked
/// @param sensitivity  sensitivity of the same gear; must be usable
/// @param options      draws and threads; `samples` 2 to kMaxSamples, of a share up to `kept`; {}:
///                     100 000 draws
/// @param progress     receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError    if the file gives no scatter, or an option is out of range
/// @throws SolverError   if fewer than two draws could be evaluated
/// @throws Stopped       if the caller requests a stop
/// @throws ShareDone     after the draws of a share were computed and kept
/// @throws BrokenRecord  if draws that are read are not those of this study
[[nodiscard]] Scatter scatter_of(const GearSet& gear, const Sensitivity& sensitivity,
                                 const ScatterOptions& options = {}, const Progress& progress = {});

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/sensitivity.hpp"

/// @file
/// What the scatter of the inputs makes of stiffness and of its loss, by first order and by Monte
/// Carlo.

namespace strainwave {

/// Most draws of one study: 80 MB of results.
inline constexpr int kMaxSamples = 2'000'000;

struct ScatterOptions {
  int samples = 100'000;   ///< draws; 2 to kMaxSamples
  std::uint64_t seed = 1;  ///< the same seed gives the same draws
  int threads = 0;         ///< 0: as many as the machine has; the result is the same for any number
};

/// An output under the scatter of the inputs.
struct ScatterOutput {
  std::string name;
  std::string_view unit;
  double value = 0.0;  ///< at the values of the file
  /// First order (SN-7).
  double first_order = 0.0;   ///< relative standard deviation [-]
  std::vector<double> share;  ///< of its square, by input of the file's scatter; sum 1, or all 0
  /// Monte Carlo (SN-8), of the draws that were evaluated.
  double mean = 0.0;
  double relative_deviation = 0.0;        ///< standard deviation over mean [-]
  double relative_deviation_error = 0.0;  ///< one standard error of it [-]
  double mean_error = 0.0;                ///< one standard error of the mean, over it [-]
  double low = 0.0;                       ///< 5 % of the draws are below
  double median = 0.0;
  double high = 0.0;  ///< 95 % of the draws are below
  /// One standard relative uncertainty of the model's form, which the scatter is not part of.
  std::optional<double> model_uncertainty;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = ScatterOutput;
    field({"name", "", "the output"}, &O::name);
    field({"unit", "", "SI unit of the output"}, &O::unit);
    field({"value", kUnitBeside, "at the values of the file"}, &O::value);
    field({"first_order", "1", "relative standard deviation, first order"}, &O::first_order);
    field({"share", "1", "of its square, by input of the file's scatter"}, &O::share);
    field({"mean", kUnitBeside, "of the draws"}, &O::mean);
    field({"relative_deviation", "1", "standard deviation over mean of the draws"},
          &O::relative_deviation);
    field({"relative_deviation_error", "1", "one standard error of the relative deviation"},
          &O::relative_deviation_error);
    field({"mean_error", "1", "one standard error of the mean, over the mean"}, &O::mean_error);
    field({"low", kUnitBeside, "5 % of the draws are below"}, &O::low);
    field({"median", kUnitBeside, "half of the draws are below"}, &O::median);
    field({"high", kUnitBeside, "95 % of the draws are below"}, &O::high);
    field({"model_uncertainty", "1", "of the model's form, relative; not part of the scatter"},
          &O::model_uncertainty);
  }
};

/// Combined uncertainty of stiffness and loss by the scatter of the inputs.
struct Scatter {
  std::vector<InputScatter> inputs;  ///< as in the file
  std::vector<ScatterOutput> outputs;
  int samples = 0;    ///< asked for
  int evaluated = 0;  ///< of them
  int refused = 0;    ///< broke a rule of the input, such as a crack deeper than its wall
  int unusable = 0;   ///< beyond the validity of the model
  std::uint64_t seed = 0;
  std::vector<Note> notes;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"inputs", "", "scatter that the file gives"}, &Scatter::inputs);
    field({"outputs", "", "combined uncertainty of each output"}, &Scatter::outputs);
    field({"samples", "", "draws asked for"}, &Scatter::samples);
    field({"evaluated", "", "draws with a result"}, &Scatter::evaluated);
    field({"refused", "", "draws that broke a rule of the input"}, &Scatter::refused);
    field({"unusable", "", "draws beyond the validity of the model"}, &Scatter::unusable);
    field({"seed", "", "of the draws"}, &Scatter::seed);
  }
};

/// How stiffness and its loss depend on each input, and what their scatter makes of it.
struct SensitivityReport {
  Sensitivity sensitivity;
  std::optional<Scatter> scatter;

  template <class Visitor>
  static void describe(Visitor&& field) {
    Sensitivity::describe([&](const Field& what, auto member) {
      field(what,
            [member](const SensitivityReport& r) { return std::invoke(member, r.sensitivity); });
    });
    field({"scatter", "", "combined uncertainty by the scatter of the inputs"},
          &SensitivityReport::scatter);
  }
};

/// The notes of both studies.
[[nodiscard]] ResultEvidence evidence_of(const SensitivityReport& report);

/// Propagates the scatter that the file gives.
///
/// First order (SN-7) from the exact elasticities, and Monte Carlo (SN-8): every draw is a full
/// evaluation of the series model.  Draws depend on seed, number and input alone, and results are
/// summed in the order of the draws: the same bits for any number of threads.
///
/// @param sensitivity  of the same gear; usable
/// @throws InputError   if the file gives no scatter, or an option is out of range
/// @throws SolverError  if fewer than two draws could be evaluated
[[nodiscard]] Scatter scatter_of(const GearSet& gear, const Sensitivity& sensitivity,
                                 const ScatterOptions& options = {}, const Progress& progress = {});

}  // namespace strainwave

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
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "strainwave/study/table_evidence.hpp"

/// @file
/// Shares of the scattering inputs in the variance of outputs, without linearisation.

namespace strainwave {

/// Largest number of base points of one study.
inline constexpr int kMaxSobolPoints = 1 << 18;
/// Independent scramblings of the points, from which the intervals follow.
inline constexpr int kSobolReplicates = 16;

/// Points and outputs of a study of Sobol's indices.
struct SobolSettings {
  int points = 4096;                      ///< base points; a multiple of kSobolReplicates
  std::uint64_t seed = 1;                 ///< the same seed gives the same numbers
  int threads = 0;                        ///< 0: as many as the machine runs
  std::vector<std::string> outputs = {};  ///< empty: stiffness and loss of the sum of the members
  SharedRows* shared = nullptr;           ///< null, or the part of the points computed or read here
  RowSink* rows = nullptr;                ///< null, or takes each point of the design
};

/// A share with its 95 % interval.
struct SobolShare {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"value", "1", "the share"}, &SobolShare::value);
    field({"low", "1", "lower end of its 95 % interval"}, &SobolShare::low);
    field({"high", "1", "upper end of its 95 % interval"}, &SobolShare::high);
  }
};

/// One input, or a group of inputs that depend on each other, and its shares in the variance of an
/// output.
struct SobolInput {
  std::string path;  ///< of the input; of a group, its paths with commas
  SobolShare first;  ///< by the input alone; eq. (UQ-2)
  SobolShare total;  ///< alone and together with other inputs; eq. (UQ-3)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "field of the input; of inputs that depend on each other, their fields"},
          &SobolInput::path);
    field({"first", "", "share by the input alone"}, &SobolInput::first);
    field({"total", "", "share by the input alone and together with others"}, &SobolInput::total);
  }
};

/// One output and the shares of all inputs in its variance.
struct SobolAnswer {
  std::string name;
  std::string_view unit;
  double value = 0.0;              ///< value at the inputs of the file
  double mean = 0.0;               ///< over the points
  double deviation = 0.0;          ///< standard deviation over the points
  std::vector<SobolInput> inputs;  ///< the largest total share first; empty if nothing varies
  SobolShare first_sum;            ///< sum of the first shares; 1 if no inputs act together

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "the output"}, &SobolAnswer::name);
    field({"unit", "", "SI unit of the output"}, &SobolAnswer::unit);
    field({"value", kUnitBeside, "value at the inputs of the file"}, &SobolAnswer::value);
    field({"mean", kUnitBeside, "mean over the points"}, &SobolAnswer::mean);
    field({"deviation", kUnitBeside, "standard deviation over the points"},
          &SobolAnswer::deviation);
    field({"inputs", "", "shares of the inputs, the largest total share first"},
          &SobolAnswer::inputs);
    field({"first_sum", "", "sum of the shares by single inputs"}, &SobolAnswer::first_sum);
  }
};

/// Sobol's indices of the scattering inputs.
struct Sobol {
  std::vector<SobolAnswer> outputs = {};
  int points = 0;
  int replicates = 0;
  int evaluations = 0;  ///< of the drive
  int left_out = 0;     ///< base points at which a drive broke a rule or left the models' range
  std::uint64_t seed = 0;
  std::optional<TableEvidence> tables = {};  ///< absent if the engine computed all drives
  std::vector<Note> notes = {};              ///< remarks on the validity of the shares

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"outputs", "", "shares for each output"}, &Sobol::outputs);
    field({"points", "", "base points"}, &Sobol::points);
    field({"replicates", "", "independent scramblings of the points"}, &Sobol::replicates);
    field({"evaluations", "", "evaluated drives"}, &Sobol::evaluations);
    field({"left_out", "", "base points without a usable drive"}, &Sobol::left_out);
    field({"seed", "", "seed of the scramblings"}, &Sobol::seed);
    field(
        {"tables", "", "error of the tables that the drives read; absent: the engine computed all"},
        &Sobol::tables);
  }
};

/// Checks the settings of a study; `sobol_of` calls it.
/// @throws InputError  if a number is out of range, or an output does not exist
void check_settings(const GearSet& gear, const SobolSettings& settings);

/// Shares of the inputs that the file lets scatter in the variance of outputs.
///
/// Implements theory manual eqs. (UQ-1) to (UQ-3).  Inputs with a correlation, given or by
/// way of other inputs, have one share together.
///
/// @throws InputError   if the file gives no scatter, an output does not exist, or an option is out
///                      of range
/// @throws SolverError  if almost no point has a usable drive
[[nodiscard]] Sobol sobol_of(const GearSet& gear, const SobolSettings& settings = {},
                             const Progress& progress = {});

}  // namespace strainwave

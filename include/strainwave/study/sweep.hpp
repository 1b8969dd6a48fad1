// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/variation.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// A column of a table of results.
struct SweepColumn {
  std::string name;
  std::string_view unit;  ///< SI
};

/// A value of an output with its accuracy, as in Quantity; the column has the unit.
struct SweepValue {
  double value = 0.0;
  std::optional<double> relative_uncertainty;
};

/// One point of a sweep.
struct SweepRow {
  std::vector<double> inputs;  ///< the varied numbers
  /// Shape (n output columns); empty if the point was refused, an element is absent if this point
  /// has no such output.
  std::vector<std::optional<SweepValue>> outputs;
  std::string reason;  ///< why the point was refused, or why its outputs may not be used

  [[nodiscard]] bool usable() const { return reason.empty(); }
};

/// A note and the rows it was given for; `note.text` is that of the first of them.
struct SweepNote {
  Note note;
  std::size_t first_row = 0;
  std::size_t n_rows = 0;
};

/// A table of results over one or two varied numbers.
struct SweepResult {
  Method method = Method::corrected;
  std::vector<Variation> variations;
  std::vector<SweepColumn> inputs;       ///< the varied numbers
  std::vector<SweepColumn> outputs;      ///< all quantities of a result (model/result_fields.hpp)
  std::vector<SweepRow> rows;            ///< the first variation varies slowest
  std::vector<SweepNote> notes;          ///< of all rows, each once
  std::vector<std::string> crack_paths;  ///< of cracks[0], cracks[1], ... in the outputs
};

/// Computes the stiffness for all values of one number, or all pairs of values of two.
///
/// A point that the method refuses stays in the table, with the reason in place of outputs; a
/// point whose result may not be used has both.
///
/// @param variations   one or two, of different numbers
/// @throws InputError  if there are none or more than two, if one of them is not valid, if there
///                     are more than kMaxSweepPoints points; the first fault if every point is
///                     refused
[[nodiscard]] SweepResult sweep(const GearSet& gear, Method method,
                                std::span<const Variation> variations);

/// The table as CSV (RFC 4180 quoting, lines end with LF): a column for each varied number, each
/// output, `usable` and `reason`; the header names path and SI unit, `intact.stiffness [N*m/rad]`.
/// Numbers have all their digits; what is absent is empty.  Uncertainties and notes are in the JSON
/// form only.
[[nodiscard]] std::string sweep_csv(const SweepResult& result);

/// The table as a JSON object: `method`, `variations`, `columns` (varied numbers, then outputs),
/// `rows` with `values` and `relative_uncertainties` in the order of the columns, `notes`.
[[nodiscard]] std::string sweep_json(const SweepResult& result);

}  // namespace strainwave

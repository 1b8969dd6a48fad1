// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/variation.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// A column of a table of results.
struct SweepColumn {
  std::string name;  ///< path of the field or of the output
  std::string unit;  ///< SI unit of the column

  friend bool operator==(const SweepColumn&, const SweepColumn&) = default;
};

/// A value of an output with its accuracy, as in Quantity; the column states the unit.
struct SweepValue {
  double value = 0.0;  ///< value of the output [unit of the column]
  /// one standard uncertainty, relative [-]; absent if it cannot be stated
  std::optional<double> relative_uncertainty;
};

/// A column with all its values, as documents show it.
struct SweepValues {
  std::string name;
  std::string_view unit;                      ///< SI unit of the values
  bool varied = false;                        ///< true for an input, false for an output
  std::vector<std::optional<double>> values;  ///< shape (n rows)
  std::vector<std::optional<double>>
      relative_uncertainties;  ///< shape (n rows); empty for an input

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "path of the field or the output"}, &SweepValues::name);
    field({"unit", "", "SI unit of the values"}, &SweepValues::unit);
    field({"varied", "", "true for a varied field, false for an output"}, &SweepValues::varied);
    field({"values", kUnitBeside, "a value for each point; null if absent"}, &SweepValues::values);
    field({"relative_uncertainties", "1", "one standard uncertainty of each value, over the value"},
          &SweepValues::relative_uncertainties);
  }
};

/// One point of a sweep.
struct SweepRow {
  std::vector<double> inputs;  ///< the varied numbers
  /// Shape (n output columns); empty if the point was refused.  An element is absent if the point
  /// lacks the output.
  std::vector<std::optional<SweepValue>> outputs;
  std::string reason;  ///< why the point was refused, or why its outputs must not be used

  /// Whether the outputs of this point may be used.
  [[nodiscard]] bool usable() const { return reason.empty(); }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"usable", "", "whether the outputs may be used"}, &SweepRow::usable);
    field({"reason", "", "why the point was refused, or must not be used"}, &SweepRow::reason);
  }
};

/// A note and the rows that have it; `note.text` is the text in the first of these rows.
struct SweepNote {
  Note note;  ///< the note, with the text of its first row
  std::size_t first_row = 0;
  std::size_t n_rows = 0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"code", "", "code of the note"}, [](const SweepNote& n) { return n.note.code; });
    field({"path", "", "field that the note concerns"},
          [](const SweepNote& n) { return n.note.path; });
    field({"first_row", "", "first point that has the note"}, &SweepNote::first_row);
    field({"rows", "", "number of points that have the note"}, &SweepNote::n_rows);
  }
};

/// A table of results over one or two varied numbers.
struct SweepResult {
  Method method = Method::corrected;
  std::vector<Variation> variations;     ///< the varied numbers, one or two, with their values
  std::vector<SweepColumn> inputs;       ///< the varied numbers
  std::vector<SweepColumn> outputs;      ///< all quantities of a result (model/result_fields.hpp)
  std::vector<SweepRow> rows;            ///< the first variation varies slowest
  std::vector<SweepNote> notes;          ///< notes of all rows, each listed once
  std::vector<std::string> crack_paths;  ///< paths of the cracks in the outputs

  /// The table by columns: varied numbers, then outputs.
  [[nodiscard]] std::vector<SweepValues> columns() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"method", "", "as-printed, repaired or corrected"}, &SweepResult::method);
    field({"columns", "", "varied fields, then outputs; one value for each point"},
          &SweepResult::columns);
    field({"rows", "", "the points; the first varied field varies slowest"}, &SweepResult::rows);
    field({"note_rows", "", "the points that have each note"}, &SweepResult::notes);
    field({"crack_paths", "", "fields of the cracks"}, &SweepResult::crack_paths);
  }
};

/// The notes of all points; not usable if no point is usable.
[[nodiscard]] ResultEvidence evidence_of(const SweepResult& result);

/// Checks the variations of a sweep.
/// @throws InputError  if the list is empty or has more than two entries; if a variation is not
///                     valid; if both vary the same number; if they have more than kMaxSweepPoints
///                     points together
void check_variations(std::span<const Variation> variations);

/// Computes the stiffness for all values of one number, or for all pairs of values of two numbers.
///
/// A point that the method refuses stays in the table, with the reason in place of outputs.  A
/// point whose result must not be used has outputs and a reason.
///
/// @param gear         the drive whose numbers vary
/// @param method       theory by which each point is evaluated
/// @param variations   one or two variations of different numbers
/// @param progress     receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param shared       null, or the part of the points that this process computes or reads
/// @param rows         null, or takes the points: the varied numbers, and the outputs
/// @throws InputError    on the same conditions as check_variations; with the first fault if every
///                       point is refused, after `rows` has taken them
/// @throws Stopped       if the caller requests a stop
/// @throws ShareDone     after the points of a share were computed and kept
/// @throws BrokenRecord  if points that are read are not those of this sweep
[[nodiscard]] SweepResult sweep(const GearSet& gear, Method method,
                                std::span<const Variation> variations,
                                const Progress& progress = {}, SharedRows* shared = nullptr,
                                RowSink* rows = nullptr);

}  // namespace strainwave

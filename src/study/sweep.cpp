// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {

template <class Archive>
void archive(Archive& to, SweepColumn& column) {
  to(column.name, column.unit);
}

template <class Archive>
void archive(Archive& to, SweepValue& value) {
  to(value.value, value.relative_uncertainty);
}

template <class Archive>
void archive(Archive& to, Note& note) {
  to(note.code, note.text, note.path, note.equation, note.severity, note.next_step);
}

namespace {

/// One evaluated point.
struct SweptPoint {
  bool refused = false;
  std::string reason;  ///< why the point was refused, or why its outputs must not be used
  /// Names and units of the outputs; most points share one list.  Null if the point was refused.
  std::shared_ptr<const std::vector<SweepColumn>> names;
  std::vector<SweepValue> values;  ///< shape (n names)
  std::vector<Note> notes;
  std::vector<std::string> crack_paths;
};

template <class Archive>
void archive(Archive& to, SweptPoint& point) {
  std::vector<SweepColumn> names = point.names ? *point.names : std::vector<SweepColumn>();
  to(point.refused, point.reason, names, point.values, point.notes, point.crack_paths);
  if (!point.names)
    point.names = std::make_shared<const std::vector<SweepColumn>>(std::move(names));
}

SweptPoint point_of(const StiffnessResult& result) {
  SweptPoint point{.reason = result.unusable_because,
                   .names = {},
                   .values = {},
                   .notes = result.notes,
                   .crack_paths = {}};
  std::vector<SweepColumn> names;
  for_each_quantity(result, [&](const std::string& name, const Quantity& q) {
    names.push_back({name, std::string(q.unit)});
    point.values.push_back({q.value, q.relative_uncertainty});
  });
  point.names = std::make_shared<const std::vector<SweepColumn>>(std::move(names));
  for (const CrackReport& crack : result.cracks) point.crack_paths.push_back(crack.path);
  return point;
}

/// Assigns a column to each output name, in order of first appearance.
class Columns {
 public:
  explicit Columns(std::vector<SweepColumn>& columns) : columns_(columns) {}

  std::size_t index(const SweepColumn& column) {
    const auto [found, is_new] = index_.try_emplace(column.name, columns_.size());
    if (is_new) columns_.push_back(column);
    return found->second;
  }

 private:
  std::vector<SweepColumn>& columns_;
  std::map<std::string, std::size_t> index_;
};

/// Adds the notes of one row to those of the sweep.  Texts with numbers differ from row to row, so
/// code and path decide whether two notes are the same.
void gather_notes(std::vector<SweepNote>& gathered, const std::vector<Note>& notes,
                  std::size_t row) {
  for (const Note& note : notes) {
    const auto known = std::ranges::find_if(gathered, [&](const SweepNote& g) {
      return g.note.code == note.code && g.note.path == note.path;
    });
    if (known == gathered.end())
      gathered.push_back({.note = note, .first_row = row, .n_rows = 1});
    else
      ++known->n_rows;
  }
}

/// Rounds a value so that it has no digits from rounding errors, such as 0.0102 instead of
/// 0.010199999999999999.
double short_value(const Variation& variation, int i) {
  const double exact = variation.value(i);
  if (i == 0 || i == variation.n_points - 1) return exact;
  return parse_number(fmt::format("{:.15g}", exact)).value_or(exact);
}

/// Hands the points over as rows.
void write_points(const SweepResult& result, RowSink& to) {
  RowHead head{.of = "points", .rows = result.rows.size(), .columns = {}};
  for (const auto* const group : {&result.inputs, &result.outputs})
    for (const SweepColumn& column : *group) head.columns.push_back({column.name, column.unit});
  to.begin(head);
  for (const SweepRow& row : result.rows) {
    std::vector<double> numbers = row.inputs;
    for (const auto& output : row.outputs)
      numbers.push_back(output ? output->value : std::numeric_limits<double>::quiet_NaN());
    numbers.resize(head.columns.size(), std::numeric_limits<double>::quiet_NaN());
    const RowStatus status = row.usable()          ? RowStatus::usable
                             : row.outputs.empty() ? RowStatus::refused
                                                   : RowStatus::unusable;
    to.add(numbers, status, row.reason);
  }
}

}  // namespace

void check_variations(std::span<const Variation> variations) {
  if (variations.empty() || variations.size() > 2)
    throw InputError("--vary",
                     fmt::format("is given {} times; must be once or twice", variations.size()));
  for (const Variation& variation : variations) check_variation(variation);
  if (variations.size() == 1) return;
  const Variation& slow = variations[0];
  const Variation& fast = variations[1];
  if (slow.path == fast.path) throw InputError(vary_option(slow.path), "is given twice");
  if (std::ptrdiff_t{slow.n_points} * fast.n_points > kMaxSweepPoints)
    throw InputError("--vary",
                     fmt::format("{} times {} points are too many; at most {} are possible",
                                 slow.n_points, fast.n_points, kMaxSweepPoints));
}

SweepResult sweep(const GearSet& gear, Method method, std::span<const Variation> variations,
                  const Progress& progress, SharedRows* shared, RowSink* rows) {
  check_variations(variations);
  SweepResult result;
  result.method = method;
  std::size_t n_rows = 1;
  for (const Variation& variation : variations) {
    const NumberAt number = varied_number(gear, variation.path);
    n_rows *= static_cast<std::size_t>(variation.n_points);
    result.variations.push_back(variation);
    result.inputs.push_back({number.path, std::string(number.field.unit)});
  }
  const auto inputs_of = [&](std::size_t row) {
    std::vector<double> inputs(variations.size());
    for (std::size_t i = variations.size(); i-- > 0;) {
      const auto points = static_cast<std::size_t>(variations[i].n_points);
      inputs[i] = short_value(variations[i], static_cast<int>(row % points));
      row /= points;
    }
    return inputs;
  };
  const auto evaluated = [&](std::size_t row) {
    GearSet varied = gear;
    const std::vector<double> inputs = inputs_of(row);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      set_number(varied, result.inputs[i].name, inputs[i]);
    return evaluate(varied, method);
  };
  std::vector<SweptPoint> points = shared_rows<SweptPoint>(n_rows, {}, progress, shared, [&] {
    return [&, last = std::shared_ptr<const std::vector<SweepColumn>>()](
               std::size_t row, SweptPoint& point) mutable {
      try {
        point = point_of(evaluated(row));
        if (last && *last == *point.names) point.names = last;
        last = point.names;
      } catch (const Error& error) {
        point = SweptPoint();
        point.refused = true;
        point.reason = error.what();
      }
    };
  });
  const bool all_refused = std::ranges::all_of(points, &SweptPoint::refused);
  Columns columns(result.outputs);
  for (std::size_t n = 0; n < n_rows; ++n) {
    SweptPoint& point = points[n];
    SweepRow row{.inputs = inputs_of(n), .outputs = {}, .reason = std::move(point.reason)};
    for (std::size_t y = 0; y < point.values.size(); ++y) {
      const std::size_t i = columns.index((*point.names)[y]);
      if (i >= row.outputs.size()) row.outputs.resize(i + 1);
      row.outputs[i] = point.values[y];
    }
    gather_notes(result.notes, point.notes, n);
    if (!point.refused && result.crack_paths.empty())
      result.crack_paths = std::move(point.crack_paths);
    result.rows.push_back(std::move(row));
  }
  for (SweepRow& row : result.rows)
    if (!row.outputs.empty()) row.outputs.resize(result.outputs.size());
  if (rows != nullptr) write_points(result, *rows);
  if (all_refused) (void)evaluated(0);  // throws its fault
  return result;
}

std::vector<SweepValues> SweepResult::columns() const {
  std::vector<SweepValues> columns;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    SweepValues column{inputs[i].name, inputs[i].unit, true, {}, {}};
    for (const SweepRow& row : rows) column.values.emplace_back(row.inputs[i]);
    columns.push_back(std::move(column));
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    SweepValues column{outputs[i].name, outputs[i].unit, false, {}, {}};
    for (const SweepRow& row : rows) {
      const bool there = i < row.outputs.size() && row.outputs[i];
      column.values.push_back(there ? std::optional(row.outputs[i]->value) : std::nullopt);
      column.relative_uncertainties.push_back(there ? row.outputs[i]->relative_uncertainty
                                                    : std::nullopt);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

ResultEvidence evidence_of(const SweepResult& result) {
  ResultEvidence evidence;
  for (const SweepNote& note : result.notes) evidence.notes.push_back(note.note);
  const auto n_unusable = std::ranges::count(result.rows, false, &SweepRow::usable);
  const std::string sentence =
      fmt::format("{} of {} points are not usable; the column `reason` says why", n_unusable,
                  result.rows.size());
  if (n_unusable == std::ssize(result.rows))
    evidence.unusable_because = sentence;
  else if (n_unusable > 0)
    evidence.notes.push_back({.code = "sweep.unusable_points",
                              .text = sentence,
                              .path = {},
                              .equation = {},
                              .severity = Severity::care});
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave

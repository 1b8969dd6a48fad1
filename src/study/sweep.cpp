// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {
namespace {

/// Assigns a column to each output name, in order of first appearance.
class Columns {
 public:
  explicit Columns(std::vector<SweepColumn>& columns) : columns_(columns) {}

  std::size_t index(const std::string& name, std::string_view unit) {
    const auto [found, is_new] = index_.try_emplace(name, columns_.size());
    if (is_new) columns_.push_back({name, unit});
    return found->second;
  }

 private:
  std::vector<SweepColumn>& columns_;
  std::map<std::string, std::size_t> index_;
};

void fill_outputs(SweepRow& row, const StiffnessResult& result, Columns& columns) {
  for_each_quantity(result, [&](const std::string& name, const Quantity& q) {
    const std::size_t i = columns.index(name, q.unit);
    if (i >= row.outputs.size()) row.outputs.resize(i + 1);
    row.outputs[i] = SweepValue{q.value, q.relative_uncertainty};
  });
  row.reason = result.unusable_because;
}

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
                  const Progress& progress) {
  check_variations(variations);
  SweepResult result;
  result.method = method;
  std::ptrdiff_t n_rows = 1;
  for (const Variation& variation : variations) {
    const NumberAt number = varied_number(gear, variation.path);
    n_rows *= variation.n_points;
    result.variations.push_back(variation);
    result.inputs.push_back({number.path, number.field.unit});
  }

  Columns columns(result.outputs);
  std::exception_ptr first_fault;
  bool all_refused = true;
  GearSet varied = gear;
  const auto add_row = [&](std::vector<double> inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i)
      set_number(varied, result.inputs[i].name, inputs[i]);
    SweepRow row{.inputs = std::move(inputs), .outputs = {}, .reason = {}};
    try {
      const StiffnessResult at_point = evaluate(varied, method);
      fill_outputs(row, at_point, columns);
      gather_notes(result.notes, at_point.notes, result.rows.size());
      if (all_refused)
        for (const CrackReport& crack : at_point.cracks) result.crack_paths.push_back(crack.path);
      all_refused = false;
    } catch (const Error& error) {
      row.reason = error.what();
      if (!first_fault) first_fault = std::current_exception();
    }
    result.rows.push_back(std::move(row));
    progress.at(static_cast<double>(result.rows.size()) / static_cast<double>(n_rows));
  };
  for (int i = 0; i < variations[0].n_points; ++i) {
    if (variations.size() == 1) {
      add_row({short_value(variations[0], i)});
      continue;
    }
    for (int j = 0; j < variations[1].n_points; ++j)
      add_row({short_value(variations[0], i), short_value(variations[1], j)});
  }
  if (all_refused) std::rethrow_exception(first_fault);
  for (SweepRow& row : result.rows)
    if (!row.outputs.empty()) row.outputs.resize(result.outputs.size());
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

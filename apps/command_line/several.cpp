// SPDX-License-Identifier: Apache-2.0
#include "several.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/present/field_list.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave::cli {
namespace {

/// Reads the outputs whose fields are headlines.
class HeadlineWalk : public OutputWalk {
 public:
  using OutputWalk::OutputWalk;

  bool field(const Field& field) override {
    headline_ = field.headline;
    return OutputWalk::field(field);
  }
  void quantity(const Quantity& value) override {
    if (headline_) OutputWalk::quantity(value);
  }

 private:
  bool headline_ = false;
};

/// Reads the headlines of the elements of a list, such as requirements.  Each element gives a row.
class RowWalk : public OutputWalk {
 public:
  using Row = std::vector<std::pair<std::string, std::string>>;  // names and texts

  RowWalk() : OutputWalk([](const std::string&, const Quantity&) {}) {}
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  void begin_list() override {
    ++lists_;
    OutputWalk::begin_list();
  }
  void end_list() override {
    --lists_;
    OutputWalk::end_list();
  }
  void end_record() override {
    if (lists_ > 0 && !row_.empty()) rows_.push_back(std::exchange(row_, {}));
    OutputWalk::end_record();
  }
  bool field(const Field& field) override {
    headline_ = field.headline ? field.name : std::string_view();
    return OutputWalk::field(field);
  }
  void quantity(const Quantity& value) override {
    add(shown_quantity(value.value, value.unit, 6, row_.empty() ? "" : row_.front().second));
    OutputWalk::quantity(value);
  }
  void text(std::string_view value) override {
    add(std::string(value));
    OutputWalk::text(value);
  }

 private:
  void add(std::string text) {
    if (lists_ > 0 && !headline_.empty()) row_.emplace_back(headline_, std::move(text));
  }

  std::vector<Row> rows_;
  Row row_;
  std::string_view headline_;
  int lists_ = 0;
};

struct Output {
  std::string name;
  std::string unit;
};

/// The outputs of all answers as columns, and the value of each answer in each.
struct Outputs {
  std::vector<Output> columns;
  std::vector<std::vector<std::optional<Quantity>>> rows;
};

template <class Walk>
Outputs outputs_of(std::span<const FileAnswer> answers) {
  Outputs outputs;
  for (const FileAnswer& of : answers) {
    outputs.rows.emplace_back(outputs.columns.size());
    // A column that the earlier files lack follows the previous column of this file.
    std::ptrdiff_t next = 0;
    Walk walk([&](const std::string& name, const Quantity& value) {
      const auto found = std::ranges::find(outputs.columns, name, &Output::name);
      const std::ptrdiff_t at =
          found != outputs.columns.end() ? found - outputs.columns.begin() : next;
      if (found == outputs.columns.end()) {
        outputs.columns.insert(outputs.columns.begin() + at, {name, std::string(value.unit)});
        for (auto& row : outputs.rows) row.insert(row.begin() + at, std::nullopt);
      }
      outputs.rows.back()[static_cast<std::size_t>(at)] = value;
      next = at + 1;
    });
    if (of.answer) of.answer->visit(walk);
  }
  return outputs;
}

std::string verdict_of(const FileAnswer& of) {
  if (!of.answer) return "no answer";
  const ResultEvidence& evidence = of.answer->evidence();
  if (!of.answer->usable()) return "not usable";
  return evidence.requirement ? std::string(enum_name(*evidence.requirement))
                              : std::string(enum_name(evidence.verdict.judgement));
}

/// A table with a row for each element that has headlines in a list of the answers, and a row for
/// each file without such elements.  There is no table if no answer has such a list.
std::optional<Table> table_of_elements(std::span<const FileAnswer> answers) {
  Table table{.head = {"file", "verdict"}, .align = "ll"};
  bool any = false;
  for (const FileAnswer& of : answers) {
    RowWalk walk;
    if (of.answer) of.answer->visit(walk);
    any = any || !walk.rows().empty();
    if (walk.rows().empty()) table.rows.push_back(cells(of.file, verdict_of(of)));
    for (const RowWalk::Row& row : walk.rows()) {
      auto& into = table.rows.emplace_back(cells(of.file, verdict_of(of)));
      for (const auto& [name, text] : row) {
        auto column = std::ranges::find(table.head, name);
        if (column == table.head.end()) column = table.head.insert(column, name);
        const auto at = static_cast<std::size_t>(column - table.head.begin());
        into.resize(std::max(into.size(), at + 1));
        into[at] = text;
      }
    }
  }
  return any ? std::optional(std::move(table)) : std::nullopt;
}

/// The lines of the heading of an output: the words of its name, then its unit.
std::vector<std::string> head_of(const Output& output) {
  std::vector<std::string> lines(1);
  for (const char c : output.name)
    if (c == '.')
      lines.emplace_back();
    else
      lines.back() += c;
  const DisplayUnit shown = display_unit(output.name, output.unit);
  if (shown.text != "1") lines.push_back(fmt::format("[{}]", shown.text));
  return lines;
}

std::string text_of_several(std::span<const FileAnswer> answers) {
  if (const auto table = table_of_elements(answers)) return text_table(*table);
  const Outputs outputs = outputs_of<HeadlineWalk>(answers);
  std::vector<std::vector<std::string>> heads = {{"file"}, {"verdict"}};
  for (const Output& output : outputs.columns) heads.push_back(head_of(output));
  std::size_t n_lines = 1;
  for (const auto& head : heads) n_lines = std::max(n_lines, head.size());
  Table table{.head = std::vector<std::string>(heads.size()), .align = "ll"};
  for (std::size_t line = 0; line < n_lines; ++line) {
    auto& row = table.rows.emplace_back();
    for (const auto& head : heads) {
      const std::size_t above = n_lines - head.size();
      row.push_back(line < above ? std::string() : head[line - above]);
    }
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    auto& row = table.rows.emplace_back(cells(answers[i].file, verdict_of(answers[i])));
    for (std::size_t n = 0; n < outputs.columns.size(); ++n) {
      const auto& value = outputs.rows[i][n];
      const DisplayUnit shown = display_unit(outputs.columns[n].name, outputs.columns[n].unit);
      row.push_back(value ? warranted_digits({value->value / shown.in_si, shown.text,
                                              value->relative_uncertainty})
                          : std::string());
    }
  }
  return text_table(table);
}

std::string csv_of_several(std::span<const FileAnswer> answers, const AskedUnits& units,
                           const std::vector<std::string>& columns) {
  const Outputs outputs = outputs_of<OutputWalk>(answers);
  Table table{.head = {"file", "verdict", "exit_status"}};
  for (const auto& [name, unit] : outputs.columns)
    table.head.push_back(fmt::format("{} [{}]", name, unit));
  table.head.emplace_back("fault");
  for (std::size_t i = 0; i < answers.size(); ++i) {
    auto& row = table.rows.emplace_back(
        cells(answers[i].file, verdict_of(answers[i]), static_cast<int>(answers[i].code)));
    for (const auto& value : outputs.rows[i])
      row.push_back(value ? cell(value->value) : std::string());
    row.push_back(answers[i].fault);
  }
  const std::string csv = csv_in_units(csv_table(table), units);
  return columns.empty() ? csv : from_option([&] { return csv_columns(csv, columns); });
}

/// A list of envelopes; each has the file among its provenance.
std::string json_of_several(std::span<const FileAnswer> answers) {
  std::string text = "{\n\"format\": \"strainwave-results/1\",\n\"answers\": [\n";
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const FileAnswer& of = answers[i];
    JsonWriter head;
    head.begin_record();
    head.member("file", of.file);
    head.member("fault", of.fault);
    head.end_record();
    std::string record = head.document();
    record.resize(record.rfind('\n', record.size() - 2));  // without the bracket that closes it
    text += fmt::format("{},\n  \"exit_status\": {},\n  \"answer\": {}}}{}\n", record,
                        static_cast<int>(of.code), of.answer ? of.answer->json() : "null",
                        i + 1 < answers.size() ? "," : "");
  }
  return text + "]\n}\n";
}

}  // namespace

bool answers_several(const Command& command) {
  return command.takes == Takes::drive &&
         std::ranges::any_of(list_of_fields(command.walk),
                             [](const ListedField& listed) { return listed.field.headline; });
}

ExitCode worst_of(std::span<const FileAnswer> answers) {
  static constexpr std::array<ExitCode, 6> kBetterFirst = {kOk,        kCannotTell, kNotMet,
                                                           kNotUsable, kInput,      kUsage};
  ExitCode worst = kOk;
  for (const FileAnswer& of : answers)
    if (std::ranges::find(kBetterFirst, of.code) > std::ranges::find(kBetterFirst, worst))
      worst = of.code;
  return worst;
}

std::string several_document(std::string_view format, std::span<const FileAnswer> answers,
                             const AskedUnits& units, const std::vector<std::string>& columns) {
  const AskedUnitsScope scope(units);
  if (format == "csv") return csv_of_several(answers, units, columns);
  return format == "json" ? json_of_several(answers) : text_of_several(answers);
}

}  // namespace strainwave::cli

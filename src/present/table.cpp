// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

using Cells = std::vector<std::string>;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string markdown_field(const std::string& text) {
  std::string field;
  for (const char c : text) field += c == '|' ? std::string("\\|") : std::string(1, c);
  return field;
}

/// The lines above the head of a CSV table that begin with #.
std::string_view remarks_of(std::string_view csv) {
  std::size_t end = 0;
  while (end < csv.size() && csv[end] == '#')
    end = std::min(csv.find('\n', end), csv.size() - 1) + 1;
  return csv.substr(0, end);
}

/// The rows of a table that csv_table wrote.
std::vector<Cells> csv_rows(std::string_view csv) {
  std::vector<Cells> rows;
  Cells row(1);
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') {
      // Of a doubled quote the second one begins another quoted part.
      if (!quoted && !row.back().empty()) row.back() += c;
      quoted = !quoted;
    } else if (quoted || (c != ',' && c != '\n')) {
      row.back() += c;
    } else if (c == ',') {
      row.emplace_back();
    } else {
      rows.push_back(std::exchange(row, Cells(1)));
    }
  }
  return rows;
}

/// The head of a column without and with its unit: "depth", "m".
std::pair<std::string, std::string> name_and_unit(const std::string& head) {
  const std::size_t at = head.rfind(" [");
  if (at == std::string::npos || !head.ends_with(']')) return {head, {}};
  return {head.substr(0, at), head.substr(at + 2, head.size() - at - 3)};
}

void change_cell(std::string& cell, std::string_view from, std::string_view to) {
  if (const std::optional<double> value = parse_number(cell); value && from != to)
    cell = number_in(*value, from, to);
}

}  // namespace

std::string exact_text(double value) { return fmt::format("{}", value); }
std::string exact_text(int value) { return fmt::format("{}", value); }
std::string exact_text(bool value) { return value ? "true" : "false"; }

std::string text_table(const Table& table) {
  std::vector<const Cells*> lines;
  if (std::ranges::any_of(table.head, [](const std::string& cell) { return !cell.empty(); }))
    lines.push_back(&table.head);
  for (const Cells& row : table.rows) lines.push_back(&row);
  const auto across = [&](const Cells& row) { return row.size() == 1 && table.head.size() > 1; };
  std::vector<std::size_t> widths(table.head.size());
  for (const Cells* const row : lines)
    for (std::size_t i = 0; i < row->size() && !across(*row); ++i)
      widths[i] = std::max(widths[i], (*row)[i].size());
  std::string text;
  for (const Cells* const row : lines) {
    for (std::size_t i = 0; i < row->size(); ++i) {
      const std::size_t width = across(*row) ? 0 : widths[i];
      const bool left = i < table.align.size() ? table.align[i] == 'l' : i == 0;
      text += left ? fmt::format("  {:<{}}", (*row)[i], width)
                   : fmt::format("  {:>{}}", (*row)[i], width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string text_tables(const std::vector<TitledTable>& tables) {
  std::string text;
  for (const auto& [title, table, remark] : tables) {
    text += '\n' + title + '\n' + text_table(table);
    if (!remark.empty()) text += paragraph(remark, 2);
  }
  return text;
}

std::string markdown_table(const Table& table) {
  std::string text;
  const auto line = [&](const Cells& row) {
    for (std::size_t i = 0; i < table.head.size(); ++i)
      text += "| " + (i < row.size() ? markdown_field(row[i]) : std::string()) + ' ';
    text += "|\n";
  };
  line(table.head);
  for (std::size_t i = 0; i < table.head.size(); ++i) text += "|---";
  text += "|\n";
  for (const Cells& row : table.rows) line(row);
  return text;
}

std::string csv_line(const std::vector<std::string>& row) {
  std::string text;
  for (const std::string& field : row) text += csv_field(field) + ',';
  text.back() = '\n';
  return text;
}

std::string csv_table(const Table& table) {
  std::string text = csv_line(table.head);
  for (Cells row : table.rows) {
    row.resize(table.head.size());
    text += csv_line(row);
  }
  return text;
}

std::string csv_in_units(const std::string& csv, const AskedUnits& units) {
  const std::string_view remarks = remarks_of(csv);
  std::vector<Cells> rows = csv_rows(std::string_view(csv).substr(remarks.size()));
  if (rows.empty()) return csv;
  const Cells head = rows.front();
  for (std::size_t i = 0; i < head.size(); ++i) {
    const auto [name, unit] = name_and_unit(head[i]);
    if (const auto asked = units.of(name, unit)) {
      rows.front()[i] = fmt::format("{} [{}]", name, asked->text);
      for (std::size_t n = 1; n < rows.size(); ++n) change_cell(rows[n][i], unit, asked->text);
    }
    const std::string beside = name == "value" ? "unit" : name + "_unit";
    const auto at = static_cast<std::size_t>(std::ranges::find(head, beside) - head.begin());
    if (at == head.size()) continue;
    for (std::size_t n = 1; n < rows.size(); ++n) {
      Cells& row = rows[n];
      const auto to = units.of(row.front(), row[at]);
      if (!to) continue;
      change_cell(row[i], row[at], to->text);
      row[at] = to->text;
    }
  }
  std::string text(remarks);
  for (const Cells& row : rows) text += csv_line(row);
  return text;
}

std::string csv_columns(const std::string& csv, const std::vector<std::string>& names) {
  const std::string_view remarks = remarks_of(csv);
  const std::vector<Cells> rows = csv_rows(std::string_view(csv).substr(remarks.size()));
  std::vector<std::string> known;
  if (!rows.empty())
    for (const std::string& head : rows.front()) known.push_back(name_and_unit(head).first);
  std::vector<std::size_t> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      const std::string near = nearest_word(name, known);
      throw InputError("columns",
                       fmt::format("{} is not a column of this table; {}", shown(name),
                                   near.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                                : fmt::format("did you mean {}?", near)));
    }
    chosen.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  std::string text(remarks);
  for (const Cells& row : rows) {
    Cells line;
    for (const std::size_t i : chosen) line.push_back(row[i]);
    text += csv_line(line);
  }
  return text;
}

}  // namespace strainwave

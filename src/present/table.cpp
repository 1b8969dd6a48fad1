// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/table.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace strainwave

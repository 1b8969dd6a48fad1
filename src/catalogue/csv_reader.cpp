// SPDX-License-Identifier: Apache-2.0
#include "csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "strainwave/core/quantity_text.hpp"

namespace strainwave {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Removes the first line of a text with its end (\n, \r\n or \r), and returns the line.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + (text.substr(end, 2) == "\r\n" ? 2 : 1), text.size()));
  return line;
}

/// The cells of a line; a quote inside quotes is written twice.
std::vector<CsvCell> cells_of(std::string_view line, char separator, TextPlace place) {
  std::vector<CsvCell> cells;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const std::size_t first = std::min(line.find_first_not_of(' ', at), line.size());
    CsvCell cell{.text = {}, .column = first + 1};
    if (line.substr(first).starts_with('"')) {
      place.column = first + 1;
      for (at = first + 1; at < line.size(); ++at) {
        if (line[at] == '"' && line.substr(at + 1).starts_with('"'))
          ++at;
        else if (line[at] == '"')
          break;
        cell.text += line[at];
      }
      const std::size_t end = std::min(line.find(separator, at), line.size());
      if (at >= line.size() || !trimmed(line.substr(at + 1, end - at - 1)).empty())
        throw InputError(place, "has a quote that is not closed before the next cell");
      at = end;
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      cell.text = trimmed(line.substr(at, end - at));
      at = end;
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

/// The separator that a line of names uses outside its quotes.
char separator_of(std::string_view line) {
  bool quoted = false;
  bool semicolon = false;
  for (const char c : line) {
    quoted = quoted != (c == '"');
    if (!quoted && c == '\t') return c;
    semicolon = semicolon || (!quoted && c == ';');
  }
  return semicolon ? ';' : ',';
}

std::string lower(std::string_view text) {
  std::string low(text);
  std::ranges::transform(low, low.begin(), [](unsigned char c) { return std::tolower(c); });
  return low;
}

}  // namespace

CsvReader::CsvReader(std::string_view file_name, std::vector<CsvColumn> columns,
                     std::string_view head_rule)
    : place_{.file = std::string(file_name)}, columns_(std::move(columns)), head_rule_(head_rule) {}

void CsvReader::read(std::string_view text, const std::function<void()>& take_row) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  if (text.find('\0') != std::string_view::npos)
    refuse_at(0, "is not CSV text in UTF-8; save the table as \"CSV UTF-8\"");
  while (!text.empty()) {
    ++place_.line;
    if (take(take_line(text))) take_row();
  }
  place_.line = 0;
  if (!separator_) refuse_at(0, "is empty");
}

void CsvReader::refuse(std::string_view column, std::string_view problem) const {
  const CsvColumn& named = *column_named(column);
  refuse_at(named.index ? cells_[*named.index].column : 1, problem);
}

void CsvReader::refuse_at(std::size_t column, std::string_view problem) const {
  throw InputError(TextPlace{place_.file, place_.line, column}, problem);
}

bool CsvReader::take(std::string_view line) {
  if (trimmed(line).empty() || trimmed(line).starts_with('#')) return false;
  if (!separator_ && !told_separator_ && line.size() == 5 && line.starts_with("sep=")) {
    told_separator_ = line[4];
    return false;
  }
  if (!separator_) {
    separator_ = told_separator_.value_or(separator_of(line));
    const std::vector<CsvCell> names = cells_of(line, *separator_, place_);
    n_columns_ = names.size();
    read_names(names);
    return false;
  }
  cells_ = cells_of(line, *separator_, place_);
  // Spreadsheets write an empty row as a line of separators.
  if (std::ranges::all_of(cells_, [](const CsvCell& cell) { return cell.text.empty(); }))
    return false;
  // Data loggers end each row with a separator.
  while (cells_.size() > n_columns_ && cells_.back().text.empty()) cells_.pop_back();
  if (cells_.size() != n_columns_) refuse_count(cells_.size());
  return true;
}

void CsvReader::read_names(const std::vector<CsvCell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view cell = cells[i].text;
    const std::size_t open = cell.find('[');
    const std::size_t close = cell.rfind(']');
    const std::string name = lower(trimmed(cell.substr(0, std::min(open, cell.size()))));
    const auto column = std::ranges::find_if(
        columns_, [&](const CsvColumn& known) { return lower(known.name) == name; });
    if (column == columns_.end()) continue;
    const bool with_unit =
        open != std::string_view::npos && close != std::string_view::npos && close > open;
    if (!column->usual.empty() && !with_unit)
      refuse_at(cells[i].column, fmt::format("the column {0} has no unit; write {0} [{1}]",
                                             column->name, column->usual));
    if (column->index)
      refuse_at(cells[i].column,
                fmt::format("names the column {} twice; name it once", column->name));
    column->index = i;
    if (column->usual.empty()) continue;
    column->unit = trimmed(cell.substr(open + 1, close - open - 1));
    try {
      (void)parse_quantity(column->name, "1 " + column->unit, column->si);
    } catch (const InputError& error) {
      refuse_at(cells[i].column, error.what());
    }
  }
  for (const CsvColumn& column : columns_)
    if (column.required && !column.index) refuse_at(1, head_rule_);
}

/// Refuses a row with a wrong number of cells.  In a table with commas, a decimal comma makes two
/// cells of one number.
void CsvReader::refuse_count(std::size_t n_cells) const {
  const std::string_view advice =
      n_cells < n_columns_ ? "write a cell for each column; a cell may be empty"
      : *separator_ == ',' ? "if commas are decimal, separate the cells by semicolons, or put "
                             "each number in quotes"
                           : "remove the cells without a column";
  refuse_at(0, fmt::format("has {} cell{}, but the head names {} columns; {}", n_cells,
                           n_cells == 1 ? "" : "s", n_columns_, advice));
}

const CsvColumn* CsvReader::column_named(std::string_view name) const {
  return &*std::ranges::find(columns_, name, &CsvColumn::name);
}

std::string_view CsvReader::text(std::string_view column) const {
  const CsvColumn& named = *column_named(column);
  return named.index ? std::string_view(cells_[*named.index].text) : std::string_view();
}

double CsvReader::number(std::string_view column_name) {
  const CsvColumn& column = *column_named(column_name);
  const auto fault = [&](std::string_view why) {
    refuse(column.name, fmt::format("{} = \"{}\" {}", column.name, shown(text(column.name)), why));
  };
  constexpr std::string_view kNoNumber = "is not a number; write a number such as 12.5 or 12,5";
  std::string text(this->text(column.name));
  if (text.empty()) fault(kNoNumber);
  const auto marks = std::ranges::count_if(text, [](char c) { return c == '.' || c == ','; });
  if (marks > 1) fault("has separators of thousands; write the number without them");
  if (marks == 1) {
    const std::size_t at = text.find_first_of(".,");
    const std::size_t other = text[at] == ',' ? 0 : 1;
    decimal_line_.at(1 - other) = place_.line;
    if (const std::size_t line = decimal_line_.at(other); line != 0)
      fault(fmt::format("has a decimal {}, but line {} has a decimal {}; use one of the two",
                        other == 0 ? "comma" : "point", line, other == 0 ? "point" : "comma"));
    text[at] = '.';
  }
  try {
    return parse_quantity(column.name, fmt::format("{} {}", text, column.unit), column.si);
  } catch (const InputError&) {
    fault(kNoNumber);
  }
  return 0.0;
}

}  // namespace strainwave

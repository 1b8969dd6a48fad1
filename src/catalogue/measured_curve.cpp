// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "strainwave/catalogue/calibration.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"

// Reads the tables that spreadsheets write: with or without a byte order mark, with any line end,
// cells between commas, semicolons or tabs, with or without quotes, and numbers with a point or a
// comma.

namespace strainwave {
namespace {

struct Cell {
  std::string text;
  std::size_t column = 0;  // column of its first byte in the line, from 1
};

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
std::vector<Cell> cells_of(std::string_view line, char separator, TextPlace place) {
  std::vector<Cell> cells;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const std::size_t first = std::min(line.find_first_not_of(' ', at), line.size());
    Cell cell{.text = {}, .column = first + 1};
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

/// A column of the curve.
struct Column {
  std::string_view name;
  std::string_view si;
  std::string_view usual;  // unit
  std::string unit = {};
  std::optional<std::size_t> index = {};
};

class CurveReader {
 public:
  explicit CurveReader(std::string_view file_name) : place_{.file = std::string(file_name)} {}

  std::vector<MeasuredPoint> read(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    if (text.find('\0') != std::string_view::npos)
      refuse(0, "is not CSV text in UTF-8; save the table as \"CSV UTF-8\"");
    while (!text.empty()) {
      ++place_.line;
      take(take_line(text));
    }
    place_.line = 0;
    if (!separator_) refuse(0, "is empty");
    if (points_.empty()) refuse(0, "has no point with a torque; give at least one");
    return std::move(points_);
  }

 private:
  [[noreturn]] void refuse(std::size_t column, std::string_view problem) const {
    throw InputError(TextPlace{place_.file, place_.line, column}, problem);
  }

  void take(std::string_view line) {
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) return;
    if (!separator_ && !told_separator_ && line.size() == 5 && line.starts_with("sep=")) {
      told_separator_ = line[4];
      return;
    }
    if (!separator_) {
      separator_ = told_separator_.value_or(separator_of(line));
      const std::vector<Cell> names = cells_of(line, *separator_, place_);
      n_columns_ = names.size();
      return read_names(names);
    }
    std::vector<Cell> cells = cells_of(line, *separator_, place_);
    // Spreadsheets write an empty row as a line of separators.
    if (std::ranges::all_of(cells, [](const Cell& cell) { return cell.text.empty(); })) return;
    // Data loggers end each row with a separator.
    while (cells.size() > n_columns_ && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != n_columns_) refuse_count(cells.size());
    const double torque = number(cells, torque_);
    const double twist = number(cells, twist_);
    if (torque == 0.0 && twist == 0.0) return;
    if (!(torque * twist > 0))
      refuse(cells[*twist_.index].column,
             "torque and twist must have the same sign; measure the twist from the unloaded state");
    points_.push_back({torque, twist});
  }

  void read_names(const std::vector<Cell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string_view cell = cells[i].text;
      const std::size_t open = cell.find('[');
      const std::size_t close = cell.rfind(']');
      std::string name(trimmed(cell.substr(0, std::min(open, cell.size()))));
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
      Column* const column = name == torque_.name  ? &torque_
                             : name == twist_.name ? &twist_
                                                   : nullptr;
      if (column == nullptr) continue;
      if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        refuse(cells[i].column,
               fmt::format("the column {0} has no unit; write {0} [{1}]", name, column->usual));
      if (column->index)
        refuse(cells[i].column, fmt::format("names the column {} twice; name it once", name));
      column->unit = trimmed(cell.substr(open + 1, close - open - 1));
      column->index = i;
      try {
        (void)parse_quantity(name, "1 " + column->unit, column->si);
      } catch (const InputError& error) {
        refuse(cells[i].column, error.what());
      }
    }
    if (!torque_.index || !twist_.index)
      refuse(1,
             "must name the columns torque and twist with their units, such as \"torque "
             "[N*m],twist [arcmin]\"");
  }

  /// Refuses a row with a wrong number of cells.  In a table with commas, a decimal comma makes two
  /// cells of one number.
  [[noreturn]] void refuse_count(std::size_t n_cells) const {
    const std::string_view advice =
        n_cells < n_columns_ ? "write a cell for each column; a cell may be empty"
        : *separator_ == ',' ? "if commas are decimal, separate the cells by semicolons, or put "
                               "each number in quotes"
                             : "remove the cells without a column";
    refuse(0, fmt::format("has {} cell{}, but the head names {} columns; {}", n_cells,
                          n_cells == 1 ? "" : "s", n_columns_, advice));
  }

  double number(const std::vector<Cell>& cells, const Column& column) {
    const Cell& cell = cells[*column.index];
    const auto fault = [&](std::string_view why) {
      refuse(cell.column, fmt::format("{} = \"{}\" {}", column.name, shown(cell.text), why));
    };
    std::string text = cell.text;
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
      fault("is not a number; write a number such as 12.5 or 12,5");
    }
    return 0.0;
  }

  TextPlace place_;
  std::optional<char> told_separator_;  // by a line "sep=;"
  std::optional<char> separator_;
  std::size_t n_columns_ = 0;
  Column torque_{.name = "torque", .si = "N*m", .usual = "N*m"};
  Column twist_{.name = "twist", .si = "rad", .usual = "arcmin"};
  std::array<std::size_t, 2> decimal_line_ = {};  // lines in which a point and a comma were seen
  std::vector<MeasuredPoint> points_;
};

}  // namespace

std::vector<MeasuredPoint> parse_measured_curve(std::string_view text, std::string_view file_name) {
  return CurveReader(file_name).read(text);
}

}  // namespace strainwave

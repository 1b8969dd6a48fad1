// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/history_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "text_lines.hpp"

namespace strainwave {
namespace {

/// Largest number of remarks that are kept.
constexpr std::size_t kMaxRemarks = 1000;

bool is_blank_character(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank_character(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank_character(text.back())) text.remove_suffix(1);
  return text;
}

std::string in_lower_case(std::string_view text) {
  std::string low(text);
  std::ranges::transform(low, low.begin(), [](unsigned char c) { return std::tolower(c); });
  return low;
}

/// The separator of a line of names: a tab, a semicolon, or else a comma.
char separator_in(std::string_view line) {
  for (const char separator : {'\t', ';'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

/// Reads a number at the beginning of a cell; returns its end, or null if there is none.
const char* number_at_front(const char* from, const char* to, double& value) {
  if (from != to && *from == '+') ++from;
  const auto [end, fault] = std::from_chars(from, to, value);
  return fault == std::errc() ? end : nullptr;
}

/// The number that a whole cell is, also with a decimal comma.
std::optional<double> number_of_cell(std::string_view cell, bool decimal_comma) {
  std::string text(without_blanks(cell));
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  if (decimal_comma &&
      std::ranges::count_if(text, [](char c) { return c == ',' || c == '.'; }) == 1)
    std::ranges::replace(text, ',', '.');
  double value = 0.0;
  const char* const to = text.data() + text.size();
  return number_at_front(text.data(), to, value) == to ? std::optional(value) : std::nullopt;
}

}  // namespace

struct HistoryFile::Contents {
  TextLines lines;
  std::string name;
  char separator = ',';
  std::vector<HistoryColumn> columns = {};
  std::vector<std::string> remarks = {};
  std::size_t head_line = 0;
  /// The first row, if no row names the columns; it is read again.
  std::optional<std::string> first_row = {};
  std::uint64_t rows = 0;
  std::vector<std::vector<double>> block = {};
  std::vector<std::size_t> block_lines = {};
  std::vector<std::size_t> place = {};  // of each column in the block; columns.size(): not wanted

  [[noreturn]] void refuse_at(std::size_t line, std::size_t column,
                              std::string_view problem) const {
    throw InputError(TextPlace{.file = name, .line = line, .column = column}, problem);
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const HistoryColumn& column : columns) all.push_back(shown(column.name));
    return all;
  }

  /// The next line with content.
  std::optional<std::string_view> next_row() {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    while (std::optional<std::string_view> line = lines.next()) {
      if (lines.line() == 1 && line->starts_with(kMark)) line->remove_prefix(kMark.size());
      if (lines.too_long()) refuse_at(lines.line(), 0, "is longer than 1 MiB; it is no row of CSV");
      const std::string_view text = without_blanks(*line);
      if (text.empty()) continue;
      if (text.front() != '#') return line;
      if (columns.empty() && remarks.size() < kMaxRemarks)
        remarks.emplace_back(without_blanks(text.substr(1)));
    }
    return std::nullopt;
  }

  void read_names() {
    std::optional<std::string_view> line = next_row();
    if (!line) refuse_at(0, 0, "is empty; give rows of numbers below a row of names");
    if (line->find('\0') != std::string_view::npos)
      refuse_at(0, 0, "is not CSV text in UTF-8; save the table as \"CSV UTF-8\"");
    if (line->size() >= 5 && line->starts_with("sep=")) {
      separator = (*line)[4];
      line = next_row();
      if (!line) refuse_at(0, 0, "is empty; give rows of numbers below a row of names");
    } else {
      separator = separator_in(*line);
    }
    head_line = lines.line();
    std::size_t numbers = 0;
    for (std::size_t at = 0; at <= line->size();) {
      const std::size_t end = std::min(line->find(separator, at), line->size());
      const std::string_view cell = line->substr(at, end - at);
      std::string_view text = without_blanks(cell);
      if (text.size() > 1 && text.front() == '"' && text.back() == '"')
        text = text.substr(1, text.size() - 2);
      if (number_of_cell(text, separator != ',')) ++numbers;
      const std::size_t open = text.find('[');
      const std::size_t close = text.rfind(']');
      const bool unit =
          open != std::string_view::npos && close != std::string_view::npos && close > open;
      columns.push_back(
          {.name = std::string(without_blanks(text.substr(0, unit ? open : text.size()))),
           .unit = std::string(unit ? without_blanks(text.substr(open + 1, close - open - 1))
                                    : std::string_view()),
           .column = at + 1});
      at = end + 1;
    }
    // Data loggers end each row with a separator.
    while (columns.size() > 1 && columns.back().name.empty() && columns.back().unit.empty())
      columns.pop_back();
    if (numbers < columns.size()) return;
    first_row = std::string(*line);
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].name = fmt::format("{}", i + 1);
  }

  [[noreturn]] void refuse_cell(std::size_t column, std::size_t at, std::string_view cell) const {
    const std::string_view text = without_blanks(cell);
    const std::string& of = columns[column].name;
    if (text.empty())
      refuse_at(lines.line(), at,
                fmt::format("{} is empty; give a number in every row", shown(of)));
    const std::optional<double> value = number_of_cell(text, separator != ',');
    refuse_at(lines.line(), at,
              fmt::format("{} = \"{}\" {}", shown(of), shown(text),
                          value ? "is not finite; give finite numbers only"
                                : "is not a number; write a number such as 12.5"));
  }

  [[noreturn]] void refuse_count(std::size_t cells) const {
    refuse_at(lines.line(), 0,
              fmt::format("has {} cell{}, but there are {} columns; {}", cells,
                          cells == 1 ? "" : "s", columns.size(),
                          cells > columns.size() && separator == ','
                              ? "if commas are decimal, separate the cells by semicolons"
                              : "write a cell for each column"));
  }

  void read_row(std::string_view line) {
    const std::size_t n_columns = columns.size();
    const char* const begin = line.data();
    const char* const end = begin + line.size();
    const char* at = begin;
    std::size_t cells = 0;
    for (;; ++cells) {
      const char* stop = nullptr;
      if (cells < n_columns && place[cells] < n_columns) {
        const char* from = at;
        while (from != end && is_blank_character(*from) && *from != separator) ++from;
        double value = 0.0;
        const char* behind = number_at_front(from, end, value);
        if (behind != nullptr)
          while (behind != end && is_blank_character(*behind) && *behind != separator) ++behind;
        if (behind != nullptr && (behind == end || *behind == separator)) {
          stop = behind;
        } else {
          stop = std::find(at, end, separator);
          const std::string_view cell(at, static_cast<std::size_t>(stop - at));
          const auto read = number_of_cell(cell, separator != ',');
          if (!read) {
            // A row that is too short or too long is the better reason.
            if (const auto number = static_cast<std::size_t>(std::count(begin, end, separator)) + 1;
                number != n_columns && !(number == n_columns + 1 && end[-1] == separator))
              refuse_count(number);
            refuse_cell(cells, static_cast<std::size_t>(at - begin) + 1, cell);
          }
          value = *read;
        }
        if (!std::isfinite(value))
          refuse_cell(cells, static_cast<std::size_t>(at - begin) + 1,
                      {at, static_cast<std::size_t>(stop - at)});
        block[place[cells]].push_back(value);
      } else {
        stop = std::find(at, end, separator);
      }
      if (stop == end) break;
      at = stop + 1;
    }
    ++cells;
    // Data loggers end each row with a separator.
    if (cells == n_columns + 1 && without_blanks({at, static_cast<std::size_t>(end - at)}).empty())
      --cells;
    if (cells != n_columns) refuse_count(cells);
    block_lines.push_back(lines.line());
  }
};

HistoryFile::HistoryFile(TextPieces pieces, std::string name)
    : contents_(new Contents{.lines = TextLines(std::move(pieces)), .name = std::move(name)}) {
  contents_->read_names();
}
HistoryFile::~HistoryFile() = default;
HistoryFile::HistoryFile(HistoryFile&&) noexcept = default;
HistoryFile& HistoryFile::operator=(HistoryFile&&) noexcept = default;

const std::string& HistoryFile::name() const { return contents_->name; }
const std::vector<HistoryColumn>& HistoryFile::columns() const { return contents_->columns; }
const std::vector<std::string>& HistoryFile::remarks() const { return contents_->remarks; }
std::uint64_t HistoryFile::rows() const { return contents_->rows; }
std::uint64_t HistoryFile::bytes() const { return contents_->lines.bytes(); }

bool HistoryFile::has(std::string_view column) const {
  return std::ranges::any_of(contents_->columns, [&](const HistoryColumn& known) {
    return in_lower_case(known.name) == in_lower_case(column);
  });
}

std::size_t HistoryFile::number_of(std::string_view column) const {
  const std::vector<HistoryColumn>& columns = contents_->columns;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (in_lower_case(columns[i].name) != in_lower_case(column)) continue;
    if (found)
      contents_->refuse_at(contents_->head_line, columns[i].column,
                           fmt::format("names the column {} twice; name it once", shown(column)));
    found = i;
  }
  if (found) return *found;
  const std::vector<std::string> names = contents_->names();
  contents_->refuse_at(contents_->head_line, 0,
                       fmt::format("has no column {}; its column{} {}", shown(column),
                                   names.size() == 1 ? " is" : "s are", fmt::join(names, ", ")));
}

double HistoryFile::factor_to(std::string_view si_unit, std::size_t column) const {
  const HistoryColumn& of = contents_->columns[column];
  if (of.unit.empty())
    contents_->refuse_at(
        contents_->head_line, of.column,
        fmt::format("the column {0} has no unit; write \"{0} [{1}]\"", shown(of.name), si_unit));
  try {
    return parse_quantity(of.name, "1 " + of.unit, si_unit);
  } catch (const InputError& error) {
    contents_->refuse_at(contents_->head_line, of.column, error.what());
  }
}

const std::vector<std::vector<double>>& HistoryFile::read(std::span<const std::size_t> wanted,
                                                          std::size_t most) {
  Contents& of = *contents_;
  of.place.assign(of.columns.size(), of.columns.size());
  of.block.resize(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    of.place[wanted[i]] = i;
    of.block[i].clear();
  }
  of.block_lines.clear();
  while (of.block_lines.size() < most) {
    if (of.first_row) {
      const std::string row = *std::exchange(of.first_row, std::nullopt);
      of.read_row(row);
      continue;
    }
    const std::optional<std::string_view> line = of.next_row();
    if (!line) break;
    of.read_row(*line);
  }
  of.rows += of.block_lines.size();
  return of.block;
}

void HistoryFile::refuse(std::size_t row, std::size_t column, double value,
                         std::string_view rule) const {
  const HistoryColumn& of = contents_->columns[column];
  contents_->refuse_at(contents_->block_lines[row], 0,
                       fmt::format("{} = {:g}{}{} violates: {}", shown(of.name), value,
                                   of.unit.empty() ? "" : " ", shown(of.unit), rule));
}

DutyRecord read_duty_record(HistoryFile& file) {
  DutyRecord record;
  const std::size_t time = file.number_of("time");
  const std::size_t torque = file.number_of("torque");
  record.of_input = !file.has("output_speed") && file.has("input_speed");
  if (file.has("output_speed") && file.has("input_speed"))
    throw InputError(TextPlace{.file = file.name()},
                     "has the columns output_speed and input_speed; give one of them");
  const std::size_t speed = file.number_of(record.of_input ? "input_speed" : "output_speed");
  const std::array<std::size_t, 3> wanted = {time, torque, speed};
  const double second = file.factor_to("s", time);
  const double newton_metre = file.factor_to("N*m", torque);
  const double radian_per_second = file.factor_to("rad/s", speed);
  std::optional<DutyRow> last;
  bool kept = true;  // the last row is in the record
  for (;;) {
    const std::vector<std::vector<double>>& block = file.read(wanted);
    if (block[0].empty()) break;
    for (std::size_t i = 0; i < block[0].size(); ++i) {
      const DutyRow row{.time = second * block[0][i],
                        .torque = newton_metre * block[1][i],
                        .speed = radian_per_second * block[2][i]};
      if (last && !(row.time > last->time))
        file.refuse(i, time, block[0][i],
                    fmt::format("later than the row before, {:g}", last->time / second));
      // A row with the load of the row before adds nothing: that row holds on.
      kept = !last || row.torque != last->torque || row.speed != last->speed;
      if (kept) record.rows.push_back(row);
      last = row;
    }
    if (record.rows.size() > kMaxDutyRows)
      throw InputError(TextPlace{.file = file.name()},
                       fmt::format("changes its load more than {} times; give a representative "
                                   "part of it, or count its cycles by strainwave duty --rainflow",
                                   kMaxDutyRows));
  }
  if (!kept) record.rows.push_back(*last);
  if (record.rows.size() < 2)
    throw InputError(TextPlace{.file = file.name()},
                     "has fewer than two rows of numbers; a row holds until the time of the next");
  return record;
}

void read_duty_record(GearSet& gear, const Attachments& attachments) {
  if (!gear.duty || !gear.duty->history) return;
  HistoryFile file(attachments.pieces(*gear.duty->history, "duty.history"), *gear.duty->history);
  gear.duty_record = std::make_shared<const DutyRecord>(read_duty_record(file));
}

}  // namespace strainwave

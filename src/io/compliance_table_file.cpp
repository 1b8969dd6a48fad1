// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/compliance_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/crack_parameters.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kAddedPositive = "added_compliance_positive";
constexpr std::string_view kAddedNegative = "added_compliance_negative";
constexpr std::string_view kAddedTorsion = "added_compliance_torsion";
constexpr std::string_view kAddedTension = "added_compliance_tension";

std::string column_text(std::string_view name, std::string_view unit) {
  return fmt::format("{} [{}]", name, unit);
}

/// Number of places of a line after the values.
constexpr std::size_t kPlacesBehind = 5;

[[noreturn]] void refuse(std::string_view name, std::size_t line, std::string_view problem) {
  throw InputError(TextPlace{.file = std::string(name), .line = line}, problem);
}

/// The places of a CSV line; only the last may be quoted.
std::vector<std::string> places_of(std::string_view line) {
  std::vector<std::string> places;
  while (!line.starts_with('"')) {
    const std::size_t comma = line.find(',');
    places.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return places;
    line.remove_prefix(comma + 1);
  }
  std::string text;
  line.remove_prefix(1);
  while (!line.empty()) {
    if (line.front() == '"') {
      if (!line.starts_with("\"\"")) break;
      line.remove_prefix(1);
    }
    text += line.front();
    line.remove_prefix(1);
  }
  places.push_back(text);
  return places;
}

TablePoint row_of(const std::vector<std::string>& places, std::size_t n_at, std::string_view name,
                  std::size_t line) {
  const auto number = [&](const std::string& text) {
    const std::optional<double> value = parse_number(text);
    if (!value) refuse(name, line, fmt::format("\"{}\" is not a number", shown(text)));
    return *value;
  };
  const std::size_t n_values = places.size() - kPlacesBehind - n_at;
  TablePoint row;
  for (std::size_t i = 0; i < n_at; ++i) row.at.push_back(number(places[i]));
  const auto may_be_empty = [&](const std::string& text) {
    return text.empty() ? std::nullopt : std::optional<double>(number(text));
  };
  for (std::size_t i = 0; i < n_values; ++i) row.values.push_back(may_be_empty(places[n_at + i]));
  const std::string* const behind = places.data() + n_at + n_values;
  row.relative_error = may_be_empty(behind[0]);
  if (behind[1] != "true" && behind[1] != "false")
    refuse(name, line, fmt::format("\"{}\" is not true or false", shown(behind[1])));
  row.usable = behind[1] == "true";
  row.unknowns = static_cast<std::size_t>(number(behind[2]));
  row.seconds = number(behind[3]);
  row.reason = behind[4];
  return row;
}

/// The head of a file by its keys.
class Head {
 public:
  Head(std::string_view head, std::string_view name) : name_(name) {
    for (std::size_t line = 1; !head.empty(); ++line) {
      const std::size_t end = std::min(head.find('\n'), head.size());
      const std::string_view text = head.substr(0, end);
      head.remove_prefix(std::min(end + 1, head.size()));
      if (!text.starts_with("# ")) {
        columns_ = places_of(text);
        continue;
      }
      const std::size_t colon = text.find(": ");
      if (line > 1 && colon != std::string_view::npos)
        lines_.emplace_back(text.substr(2, colon - 2), text.substr(colon + 2));
    }
  }

  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }

  [[nodiscard]] std::string one(std::string_view key) const {
    const std::vector<std::string> found = all(key);
    if (found.size() != 1)
      throw InputError(name_, fmt::format("must have one line \"# {}: ...\"", key));
    return found.front();
  }

  [[nodiscard]] std::vector<std::string> all(std::string_view key) const {
    std::vector<std::string> found;
    for (const auto& [known, value] : lines_)
      if (known == key) found.push_back(value);
    return found;
  }

 private:
  std::string name_;
  std::vector<std::pair<std::string, std::string>> lines_;
  std::vector<std::string> columns_;
};

/// Splits a text such as "half_length [m]" into name and unit.
TableColumn named_unit(std::string_view text, std::string_view name) {
  const std::size_t open = text.find(" [");
  if (open == std::string_view::npos || !text.ends_with(']'))
    throw InputError(name,
                     fmt::format("\"{}\" must be a name and a unit in brackets", shown(text)));
  return {std::string(text.substr(0, open)),
          std::string(text.substr(open + 2, text.size() - open - 3))};
}

}  // namespace

std::string table_head_text(const TableHead& head) {
  std::string text = fmt::format("# {}\n", kTableFormat);
  const auto line = [&](std::string_view key, std::string_view value) {
    text += fmt::format("# {}: {}\n", key, shown(value, 1000));
  };
  line("kind", head.kind);
  line("crack", head.crack);
  line("made by", head.program);
  line("input", head.input);
  line("drive sha256", head.digest);
  line("order", fmt::format("{}", head.order));
  line("equations", head.equations);
  line("held", head.held);
  for (const TableRange& range : head.ranges) {
    const Variation& v = range.variation;
    line("over",
         fmt::format("{}, {}, {} to {}, {} points, {}",
                     column_text(range.parameter.name, range.parameter.unit), v.path,
                     quantity_text(v.from, range.parameter.unit),
                     quantity_text(v.to, range.parameter.unit), v.n_points, enum_name(v.spacing)));
  }
  for (const TableParameter& fixed : head.fixed)
    line("fixed", fmt::format("{} = {}", fixed.name, quantity_text(fixed.value, fixed.unit)));
  for (const TableRange& range : head.ranges)
    text += column_text(range.parameter.name, range.parameter.unit) + ',';
  for (const TableColumn& column : head.columns)
    text += column_text(column.name, column.unit) + ',';
  return text + "relative_error [1],usable,unknowns,seconds [s],reason\n";
}

std::string table_row_text(const TablePoint& row) {
  std::string text;
  for (const double at : row.at) text += fmt::format("{},", at);
  const auto optional = [&](const std::optional<double>& value) {
    if (value) text += fmt::format("{}", *value);
    text += ',';
  };
  for (const std::optional<double>& value : row.values) optional(value);
  optional(row.relative_error);
  text += fmt::format("{},{},{:.3g},", row.usable, row.unknowns, row.seconds);
  if (!row.reason.empty()) {
    text += '"';
    for (const char c : shown(row.reason, 1000))
      text += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += '"';
  }
  return text + '\n';
}

TableFile parse_table_file(std::string_view text, std::string_view name) {
  if (!text.starts_with(fmt::format("# {}\n", kTableFormat)))
    refuse(name, 1, fmt::format("must begin with \"# {}\"", kTableFormat));
  TableFile file;
  std::size_t n_at = 0;
  std::size_t n_places = 0;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      file.torn = true;
      break;
    }
    const std::string_view content = text.substr(0, end);
    text.remove_prefix(end + 1);
    file.whole += end + 1;
    if (n_places == 0) {
      file.head += content;
      file.head += '\n';
      if (content.starts_with("# over: ")) ++n_at;
      if (content.starts_with('#')) continue;
      n_places = places_of(content).size();
      if (n_at == 0) refuse(name, line, "no line \"# over: ...\" before the columns");
      if (n_places <= n_at + kPlacesBehind) refuse(name, line, "has too few columns");
      continue;
    }
    const std::vector<std::string> places = places_of(content);
    if (places.size() != n_places)
      refuse(name, line,
             fmt::format("has {} cell{}, but the head names {} columns; separate cells by commas, "
                         "and write numbers with a decimal point",
                         places.size(), places.size() == 1 ? "" : "s", n_places));
    file.rows.push_back(row_of(places, n_at, name, line));
  }
  if (n_places == 0) throw InputError(name, "ends before the names of the columns");
  return file;
}

ComplianceTable parse_compliance_table(std::string_view text, std::string_view name) {
  const TableFile file = parse_table_file(text, name);
  const Head head(file.head, name);
  if (file.torn)
    throw InputError(name, "ends within a line: finish it with strainwave fe tabulate");
  ComplianceTable table;
  table.file = name;
  table.kind = head.one("kind");
  table.made_by = fmt::format("{}, order {}", head.one("made by"), head.one("order"));
  for (const std::string& text_of : head.all("fixed")) {
    const std::size_t equals = text_of.find(" = ");
    const std::size_t blank = text_of.rfind(' ');
    if (equals == std::string::npos)
      throw InputError(name, fmt::format("\"{}\" must be NAME = VALUE", shown(text_of)));
    TableParameter fixed{.name = text_of.substr(0, equals), .unit = "1", .value = 0.0};
    if (blank > equals + 2) fixed.unit = text_of.substr(blank + 1);
    fixed.value = parse_quantity(name, text_of.substr(equals + 3), fixed.unit);
    table.fixed.push_back(std::move(fixed));
  }
  const std::vector<std::string> over = head.all("over");
  for (std::size_t a = 0; a < over.size(); ++a) {
    const TableColumn column = named_unit(head.columns().at(a), name);
    TableAxis axis{.name = column.name,
                   .unit = column.unit,
                   .logarithmic = over[a].ends_with(", logarithmic"),
                   .nodes = {}};
    for (const TablePoint& row : file.rows) axis.nodes.push_back(row.at[a]);
    std::ranges::sort(axis.nodes);
    axis.nodes.erase(std::unique(axis.nodes.begin(), axis.nodes.end()), axis.nodes.end());
    if (axis.nodes.size() < kMinTableNodes)
      throw InputError(name, fmt::format("has {} values of {}; interpolation needs {}",
                                         axis.nodes.size(), axis.name, kMinTableNodes));
    if (axis.logarithmic && !(axis.nodes.front() > 0))
      throw InputError(name, fmt::format("{} must be > 0 on a logarithmic axis", axis.name));
    table.axes.push_back(std::move(axis));
  }
  std::size_t n_points = 1;
  for (const TableAxis& axis : table.axes) n_points *= axis.nodes.size();
  if (n_points > file.rows.size())
    throw InputError(name, fmt::format("has {} of {} points: finish it with strainwave fe tabulate",
                                       file.rows.size(), n_points));

  const auto fill = [&](TableValues& column, std::string_view wanted, std::string_view unit) {
    const auto found = std::ranges::find(head.columns(), column_text(wanted, unit));
    if (found == head.columns().end()) return false;
    const auto place = static_cast<std::size_t>(found - head.columns().begin()) - table.axes.size();
    column.values.assign(n_points, 0.0);
    std::vector<bool> filled(n_points, false);
    for (std::size_t r = 0; r < file.rows.size(); ++r) {
      const TablePoint& row = file.rows[r];
      if (!row.usable)
        throw InputError(name, fmt::format("point {} is not usable: {}", r + 1, shown(row.reason)));
      if (!row.values.at(place) || !row.relative_error)
        throw InputError(name, fmt::format("point {} has no {} or no error", r + 1, wanted));
      std::size_t index = 0;
      for (std::size_t a = 0; a < table.axes.size(); ++a) {
        const std::vector<double>& nodes = table.axes[a].nodes;
        index =
            index * nodes.size() +
            static_cast<std::size_t>(std::ranges::lower_bound(nodes, row.at[a]) - nodes.begin());
      }
      if (filled[index])
        throw InputError(name, fmt::format("point {} appears twice; remove one of them", r + 1));
      filled[index] = true;
      column.values[index] = *row.values[place];
      table.point_error = std::max(table.point_error, std::abs(*row.relative_error));
    }
    return true;
  };
  constexpr std::string_view kUnit = "rad/(N*m)";
  if (fill(table.positive, kAddedTorsion, kUnit)) {
    table.negative = table.positive;
    (void)fill(table.axial, kAddedTension, "m/N");
  } else if (!fill(table.positive, kAddedPositive, kUnit) ||
             !fill(table.negative, kAddedNegative, kUnit)) {
    throw InputError(
        name,
        fmt::format("has no column \"{}\", or \"{}\" and \"{}\"", column_text(kAddedTorsion, kUnit),
                    column_text(kAddedPositive, kUnit), column_text(kAddedNegative, kUnit)));
  }
  return completed(std::move(table));
}

void read_compliance_tables(GearSet& gear, const Attachments& attachments) {
  std::map<std::string, ComplianceTable> tables;
  for_each_tabulated_kind(gear, [&](const std::string& path, const auto& crack) {
    if (!crack.compliance_table || tables.contains(*crack.compliance_table)) return;
    const std::string& name = *crack.compliance_table;
    const std::string at = path + ".compliance_table";
    const std::string text = attachments.text(name, at);
    try {
      tables.emplace(name, parse_compliance_table(text, name));
    } catch (const InputError& error) {
      throw InputError(at, error.what());
    }
  });
  gear.compliance_tables = std::move(tables);
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "csv_reader.hpp"
#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/proportions.hpp"

namespace strainwave {
namespace {

/// A number that keeps a rule.
/// @param check  throws InputError with the rule
double ruled(CsvReader& reader, std::string_view column, void (*check)(double)) {
  const double value = reader.number(column);
  try {
    check(value);
  } catch (const InputError& error) {
    reader.refuse(column, fmt::format("{} = {} violates: {}", column, shown(reader.text(column)),
                                      error.rule()));
  }
  return value;
}

void require_positive(double value) { require(value > 0, "", value, "1", "> 0"); }

template <class E>
E choice(const CsvReader& reader, std::string_view column, E fallback) {
  const std::string_view text = reader.text(column);
  if (text.empty()) return fallback;
  const auto value = enum_value<E>(text);
  if (!value)
    reader.refuse(column, fmt::format("{} = \"{}\" is not one of {}", column, shown(text),
                                      fmt::join(EnumNames<E>::names, ", ")));
  return *value;
}

std::optional<double> stiffness_cell(CsvReader& reader, std::string_view column) {
  if (reader.text(column).empty()) return std::nullopt;
  return ruled(reader, column, require_positive);
}

}  // namespace

std::vector<StiffnessRow> parse_stiffness_rows(std::string_view text, std::string_view file_name) {
  CsvReader reader(file_name,
                   {{.name = "series", .required = false},
                    {.name = "form", .required = false},
                    {.name = "length", .required = false},
                    {.name = "size", .si = "1", .required = false},
                    {.name = "pitch_diameter", .si = "m", .usual = "mm", .required = false},
                    {.name = "ratio", .si = "1"},
                    {.name = "T1", .si = "N*m", .usual = "N*m"},
                    {.name = "T2", .si = "N*m", .usual = "N*m"},
                    {.name = "K1", .si = "N*m/rad", .usual = "N*m/rad"},
                    {.name = "K2", .si = "N*m/rad", .usual = "N*m/rad"},
                    {.name = "K3", .si = "N*m/rad", .usual = "N*m/rad"}},
                   "must name the columns of the rows with their units, such as \"series,form,"
                   "length,size,ratio,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad]\"");
  std::vector<StiffnessRow> rows;
  reader.read(text, [&] {
    StiffnessRow row{.series = std::string(reader.text("series")),
                     .form = choice(reader, "form", FlexsplineForm::cup),
                     .length = choice(reader, "length", FlexsplineLength::short_length),
                     .origin = RowOrigin::file,
                     .ratios = {ruled(reader, "ratio", require_typical_ratio)},
                     .T1 = ruled(reader, "T1", require_positive),
                     .T2 = ruled(reader, "T2", require_positive),
                     .K1 = stiffness_cell(reader, "K1"),
                     .K2 = stiffness_cell(reader, "K2"),
                     .K3 = stiffness_cell(reader, "K3"),
                     .sources = fmt::format("{}:{}", file_name, reader.line())};
    row.ratio_class = ratio_class_of(row.ratios.front());
    const bool sized = !reader.text("size").empty();
    if (sized == !reader.text("pitch_diameter").empty())
      reader.refuse_at(0, "must give either size or pitch_diameter [mm]");
    // Rounding makes 50.8 mm the size 20 of the catalogue.
    const auto size_of = [](double diameter) {
      return std::round(1e9 * diameter / pitch_diameter_of(1)) / 1e9;
    };
    row.size = sized ? ruled(reader, "size", require_positive)
                     : size_of(ruled(reader, "pitch_diameter", require_positive));
    if (!(row.T2 > row.T1))
      reader.refuse("T2", fmt::format("T2 = {} violates: > T1", shown(reader.text("T2"))));
    if (!row.K1 && !row.K2 && !row.K3) reader.refuse("K1", "must give one of K1, K2, K3");
    rows.push_back(std::move(row));
  });
  if (rows.empty()) reader.refuse_at(0, "has no row; give at least one");
  return rows;
}

}  // namespace strainwave

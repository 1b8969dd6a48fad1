// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/present/field_list.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

struct UnitsOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

/// A unit and where a drive has it.
struct UnitRow {
  std::string unit;
  std::string dimension;  ///< "length"
  bool prefixed = false;  ///< it takes prefixes
  double factor = 0.0;    ///< value in SI of one of this unit
  std::string si;         ///< unit of the factor
  std::string written;    ///< a field of the input that takes the unit; empty if no field takes the
                          ///< unit alone

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"unit", "", "name of the unit in a text"}, &UnitRow::unit);
    field({"dimension", "", "dimension of the unit"}, &UnitRow::dimension);
    field({"takes_prefix", "", "whether a prefix may stand before the unit"}, &UnitRow::prefixed);
    field({"factor", "1", "factor to the SI unit"}, &UnitRow::factor);
    field({"si", "", "the SI unit"}, &UnitRow::si);
    field({"written_in", "", "a field of the input that takes the unit"}, &UnitRow::written);
  }
};

struct PrefixRow {
  std::string prefix;
  int power = 0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"prefix", "", "before a unit"}, &PrefixRow::prefix);
    field({"power", "", "of ten"}, &PrefixRow::power);
  }
};

struct UnitList {
  std::vector<UnitRow> units;
  std::vector<PrefixRow> prefixes;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"units", "", "units of which a quantity can be made"}, &UnitList::units);
    field({"prefixes", "", "prefixes of the units that take one"}, &UnitList::prefixes);
  }
};

/// "kg*m^2/s^2" of the dimension of a unit.
std::string si_text(const Unit& unit) {
  static constexpr std::array<std::string_view, 5> kBase = {"m", "kg", "s", "K", "rad"};
  std::string above;
  std::string below;
  for (std::size_t i = 0; i < kBase.size(); ++i) {
    const double power = unit.dimension[i];
    if (power == 0) continue;
    std::string& side = power > 0 ? above : below;
    side += (power > 0 && side.empty() ? "" : power > 0 ? "*" : "/");
    side += kBase[i];
    if (std::abs(power) != 1) side += fmt::format("^{:g}", std::abs(power));
  }
  return (above.empty() ? "1" : above) + below;
}

UnitList unit_list() {
  const std::vector<ListedField> fields = list_of_fields(visit_type<GearSet>);
  UnitList list;
  for (const KnownUnit& known : known_units()) {
    UnitRow row{.unit = std::string(known.symbol),
                .dimension = std::string(known.kind),
                .prefixed = known.takes_prefix,
                .factor = known.unit.factor,
                .si = {},
                .written = {}};
    std::size_t n = 0;
    for (const auto& [path, field, values, kind] : fields) {
      if (field.unit.empty() || !same_dimension(parse_unit(field.unit), known.unit)) continue;
      if (++n > 1) continue;
      row.si = field.unit;
      row.written = path;
    }
    if (n > 1) row.written += fmt::format(" and {} more", n - 1);
    // A unit that no field has alone stands in products, such as the second.
    const auto alone = std::ranges::find_if(known_units(), [&](const KnownUnit& base) {
      return base.unit.factor == 1.0 && same_dimension(base.unit, known.unit);
    });
    if (n == 0)
      row.si = alone != known_units().end() ? std::string(alone->symbol) : si_text(known.unit);
    list.units.push_back(std::move(row));
  }
  for (const auto& [symbol, power] : unit_prefixes())
    list.prefixes.push_back({.prefix = std::string(symbol), .power = power});
  return list;
}

Table units_table(const UnitList& list, std::string_view prefixed) {
  Table table{.head = {"unit", "dimension", "in SI", "SI unit", "where the unit is written"},
              .align = "llrll"};
  for (const UnitRow& row : list.units)
    table.rows.push_back(cells(row.unit + (row.prefixed ? std::string(prefixed) : std::string()),
                               row.dimension, row.factor, row.si, row.written));
  return table;
}

std::string units_text(const UnitList& list) {
  std::string prefixes;
  for (const auto& [prefix, power] : list.prefixes)
    prefixes += fmt::format("{}{} = 10^{}", prefixes.empty() ? "" : ", ", prefix, power);
  return text_table(units_table(list, " *")) + '\n' + paragraph("* takes a prefix: " + prefixes) +
         paragraph(
             "Products are written with * or a middle dot, /, ^ and parentheses: N*m/rad, "
             "MPa*m^0.5, rad/(N*m), lbf*in/arcmin. A quantity is a number and a unit: "
             "\"2.24 mm\", \"45 deg\". Pure numbers are bare or in %.");
}

}  // namespace

Command units_command() {
  return command<UnitsOptions, UnitList>({
      .name = "units",
      .summary = "List all units with dimension, factor to SI and a field that takes them",
      .description =
          "Prints the units that the input file, the options and --units know, each with its "
          "dimension, its factor to SI and a field of the input that takes the unit, and the "
          "prefixes. Products of units are formed with * / ^ and parentheses.",
      .example = "strainwave units --format csv",
      .takes = Takes::nothing,
      .function = [](const Request&, const UnitsOptions&) { return unit_list(); },
      .documents = {{Format::text, units_text},
                    {Format::csv,
                     [](const UnitList& list) { return csv_table(units_table(list, "")); }},
                    {Format::markdown,
                     [](const UnitList& list) { return markdown_table(units_table(list, " *")); }}},
  });
}

}  // namespace strainwave

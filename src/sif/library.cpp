// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/library.hpp"

#include <string>

#include "row.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"

namespace strainwave::sif {

double example_value(const Field& field) {
  std::string text(field.example);
  std::erase(text, '"');
  return parse_quantity(field.name, text, field.unit);
}

void require_in_range(const Field& field, double value) {
  require(field.range.contains(value), field.name, value, field.unit,
          std::isfinite(value) ? rule_text(field.range, field.unit) : "a finite number");
}

std::string near_text(std::string_view word, std::span<const std::string> known) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? std::string() : "; do you mean " + near + "?";
}

std::span<const Row> library() {
  static const std::vector<Row> kRows = [] {
    std::vector<Row> rows;
    for (auto* const family : {plate_rows, tube_rows, bar_rows, gradient_rows})
      for (Row& row : family()) rows.push_back(std::move(row));
    return rows;
  }();
  return kRows;
}

const Row& solution(std::string_view name) {
  std::vector<std::string> names;
  for (const Row& row : library()) {
    if (row.info.name == name) return row;
    names.emplace_back(row.info.name);
  }
  throw InputError(name.empty() ? "\"\"" : shown(name),
                   "is not a solution of the library" + near_text(name, names) +
                       "; `strainwave sif list` lists all solutions");
}

}  // namespace strainwave::sif

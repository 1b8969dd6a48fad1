// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/reference.hpp"

#include <fmt/format.h>

#include "strainwave/present/field_list.hpp"

namespace strainwave {

std::string fields_reference(TypeWalk walk) {
  std::string table = "| field | unit | meaning |\n|---|---|---|\n";
  for (const auto& [path, field, values, kind] : list_of_fields(walk))
    table += kind.empty()
                 ? fmt::format("| `{}` | {} | {}{}{} |\n", path,
                               field.unit == kUnitBeside ? "as the field `unit` says" : field.unit,
                               field.doc, values.empty() ? "" : "; ", values)
                 : fmt::format("| `{}` | | \"{}\", with: |\n", path, kind);
  return table;
}

}  // namespace strainwave

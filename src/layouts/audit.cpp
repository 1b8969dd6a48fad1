// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/audit.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string number(const std::optional<double>& value) {
  if (!value) return "-";
  return std::abs(*value) < 1e-25 ? "0" : fmt::format("{:.5g}", *value);
}

std::string unit_of(const AuditRow& row) { return std::string(row.unit == "1" ? "" : row.unit); }

/// Reason of the verdict, and the input that reproduces the printed number.
std::string reason(const AuditRow& row) {
  if (!row.reproduce) return row.sentence;
  const ReproducingInput& r = *row.reproduce;
  return fmt::format("{}; reproduced by {} = {:.6g}{}{}", row.sentence, r.name, r.value,
                     r.unit == "1" ? "" : " ", r.unit == "1" ? "" : r.unit);
}

}  // namespace

std::string audit_text(std::span<const AuditRow> rows) {
  Table table{.head = {"", "", "printed", "own", "corrected", "ratio", "unit"}, .align = "llrrrrl"};
  std::array<int, EnumNames<AuditVerdict>::names.size()> counts{};
  for (const AuditRow& row : rows) {
    table.rows.push_back({row.id, row.quantity, number(row.printed), number(row.own),
                          number(row.corrected), number(row.ratio()), unit_of(row)});
    table.rows.push_back(
        {"     " +
         wrapped(fmt::format("{}: {}", enum_name(row.verdict), reason(row)), kTextWidth - 7, 7)});
    ++counts[static_cast<std::size_t>(row.verdict)];
  }
  std::string total = fmt::format("\n{} rows:", rows.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
    total +=
        fmt::format("{} {} {}", i == 0 ? "" : ",", counts[i], EnumNames<AuditVerdict>::names[i]);
  return "The article's worked example, number by number.  Units N, mm, MPa, rad.\n"
         "printed: value in the article; own: result of the article's equation for its printed "
         "inputs;\ncorrected: result of the corrected theory; ratio: printed/own, or own/corrected "
         "if nothing is printed.\n\n" +
         text_table(table) + total + "\n";
}

std::string audit_markdown(std::span<const AuditRow> rows) {
  Table table{
      .head = {"", "quantity", "unit", "printed", "own equation", "corrected", "ratio", "verdict"}};
  for (const AuditRow& row : rows)
    table.rows.push_back({row.id, row.quantity, unit_of(row), number(row.printed), number(row.own),
                          number(row.corrected), number(row.ratio()),
                          fmt::format("**{}**: {}", enum_name(row.verdict), reason(row))});
  return markdown_table(table);
}

}  // namespace strainwave

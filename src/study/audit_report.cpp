// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/audit_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "strainwave/io/result_writer.hpp"

namespace strainwave {
namespace {

std::string number(const std::optional<double>& value) {
  if (!value) return "-";
  return std::abs(*value) < 1e-25 ? "0" : fmt::format("{:.5g}", *value);
}

std::string reproduce_text(const AuditRow& row) {
  if (!row.reproduce) return {};
  const ReproducingInput& r = *row.reproduce;
  return fmt::format("{} = {:.6g}{}{}", r.name, r.value, r.unit == "1" ? "" : " ",
                     r.unit == "1" ? "" : r.unit);
}

}  // namespace

std::string audit_text(std::span<const AuditRow> rows) {
  constexpr std::size_t kWidth = 108;
  std::string text =
      "The article's worked example, number by number.  Units N, mm, MPa, rad.\n"
      "printed: in the article; own: its own printed equation with its printed inputs; corrected:\n"
      "the corrected theory; ratio: printed/own, or own/corrected where nothing is printed.\n\n";
  text += fmt::format("{:<5}{:<46}{:>12}{:>12}{:>12}{:>11}  {}\n", "", "", "printed", "own",
                      "corrected", "ratio", "unit");
  for (const AuditRow& row : rows) {
    const std::string unit = row.unit == "1" ? "" : fmt::format("  {}", row.unit);
    text += fmt::format("{:<5}{:<46}{:>12}{:>12}{:>12}{:>11}{}\n", row.id, row.quantity,
                        number(row.printed), number(row.own), number(row.corrected),
                        number(row.ratio()), unit);
    std::string remark = fmt::format("{}: {}", enum_name(row.verdict), row.sentence);
    if (row.reproduce) remark += fmt::format("; reproduced by {}", reproduce_text(row));
    text += fmt::format("     {}\n", wrapped(remark, kWidth - 5, 5));
  }
  std::array<int, EnumNames<AuditVerdict>::names.size()> counts{};
  for (const AuditRow& row : rows) ++counts[static_cast<std::size_t>(row.verdict)];
  text += fmt::format("\n{} rows:", rows.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
    text +=
        fmt::format("{} {} {}", i == 0 ? "" : ",", counts[i], EnumNames<AuditVerdict>::names[i]);
  return text + "\n";
}

std::string audit_markdown(std::span<const AuditRow> rows) {
  std::string text =
      "| | quantity | unit | printed | own equation | corrected | ratio | verdict |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const AuditRow& row : rows) {
    std::string remark = fmt::format("**{}**: {}", enum_name(row.verdict), row.sentence);
    if (row.reproduce) remark += fmt::format("; reproduced by {}", reproduce_text(row));
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.id, row.quantity,
                        row.unit == "1" ? "" : row.unit, number(row.printed), number(row.own),
                        number(row.corrected), number(row.ratio()), remark);
  }
  return text;
}

}  // namespace strainwave

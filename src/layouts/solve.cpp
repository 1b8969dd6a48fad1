// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/solve.hpp"

#include <fmt/format.h>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

std::string quantity_line(std::string_view name, const Quantity& q) {
  const DisplayUnit unit = display_unit(name, q.unit);
  std::string line = fmt::format(
      "{} = {}", name, warranted_digits({q.value / unit.in_si, unit.text, q.relative_uncertainty}));
  if (unit.text != "1") line += fmt::format(" {}", unit.text);
  if (q.relative_uncertainty)
    line += fmt::format(" (accuracy {})", percent(*q.relative_uncertainty));
  return line + '\n';
}

}  // namespace

std::string solve_text(const SolveResult& result) {
  const auto input = [&](double x) { return shown_quantity(x, result.unit, 6, result.path); };
  std::string text =
      fmt::format("{} for {} = {}\nmethod {}, searched from {} to {}; at present {}\n\n",
                  result.path, result.target.output,
                  shown_quantity(result.target.value, result.target.unit, 6, result.target.output),
                  enum_name(result.method), input(result.searched.from), input(result.searched.to),
                  input(result.present));
  for (const Solution& solution : result.solutions) {
    text += "  " + quantity_line(result.path, solution.value);
    text += "    " + quantity_line(result.target.output, solution.output);
    const auto drive = [&](std::string_view name, const Quantity& q) {
      if (name != result.target.output) text += "    " + quantity_line(name, q);
    };
    drive("intact.stiffness", solution.result.intact.stiffness);
    drive("cracked.positive.stiffness", solution.result.positive.stiffness);
    drive("cracked.negative.stiffness", solution.result.negative.stiffness);
    text += '\n';
  }
  if (!result.reason.empty())
    text += paragraph((result.usable() ? "Note: " : "NO SOLUTION: ") + result.reason) + '\n';
  if (!result.notes.empty()) text += "Note on the accuracy\n" + notes_text(result.notes) + '\n';
  if (result.usable())  // otherwise the reason contains the range
    text += paragraph(fmt::format("Over the searched range {} lies {}", result.target.output,
                                  output_range(result)));
  if (!result.excluded.empty()) text += "Parts of the range left out of the search\n";
  for (const Excluded& part : result.excluded) {
    const std::string from = input(part.from);
    const std::string to = input(part.to);
    text += paragraph(
        fmt::format("{}: {}: {}", from == to ? "at " + from : fmt::format("{} to {}", from, to),
                    part.refused ? "refused" : "not usable", part.reason),
        2);
  }
  if (!result.solutions.empty() && !result.solutions.front().result.notes.empty()) {
    text += result.solutions.size() > 1 ? "\nNotes on the first solution\n" : "\nNotes\n";
    text += notes_text(result.solutions.front().result.notes);
  }
  return text;
}

}  // namespace strainwave

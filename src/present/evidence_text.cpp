// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/evidence_text.hpp"

#include <fmt/format.h>

#include "strainwave/core/shown_text.hpp"

namespace strainwave {

std::string notes_text(std::span<const Note> notes) {
  std::string text;
  for (const Note& note : notes) {
    std::string line = note.path.empty() ? note.text : note.path + ": " + note.text;
    if (!note.equation.empty()) line += fmt::format(" ({})", note.equation);
    if (!note.next_step.empty()) line += ". " + note.next_step;
    text += paragraph("- " + line, 2);
  }
  return text;
}

std::string verdict_text(const Verdict& verdict) {
  std::string line = fmt::format("Verdict: {}. {}", enum_name(verdict.judgement), verdict.reason);
  if (!verdict.next_step.empty()) line += ". " + verdict.next_step;
  return paragraph(line, 2);
}

std::string equations_text(std::span<const std::string> equations) {
  return paragraph(fmt::format("Equations of the theory manual: {}", fmt::join(equations, ", ")));
}

}  // namespace strainwave

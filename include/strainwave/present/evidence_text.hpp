// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// Notes as a list, with one item each: field, sentence, equation, next step.
[[nodiscard]] std::string notes_text(std::span<const Note> notes);

/// "Verdict: with care.  REASON.  NEXT STEP"
[[nodiscard]] std::string verdict_text(const Verdict& verdict);

/// Equation tags of the theory manual as a sentence.
[[nodiscard]] std::string equations_text(std::span<const std::string> equations);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/evidence.hpp"

#include <algorithm>

namespace strainwave {
namespace {

Judgement judgement_of(Severity severity) {
  switch (severity) {
    case Severity::information:
      return Judgement::good;
    case Severity::care:
      return Judgement::with_care;
    case Severity::cannot_tell:
      return Judgement::cannot_be_told;
    case Severity::critical:
      break;
  }
  return Judgement::critical;
}

}  // namespace

Verdict verdict_of(std::string_view unusable_because, std::span<const Note> notes) {
  const auto worst = std::ranges::max_element(notes, {}, &Note::severity);
  if (!unusable_because.empty())
    return {Judgement::cannot_be_told, std::string(unusable_because),
            "Do not use the numbers; change what the reason names, and run again."};
  if (worst == notes.end() || worst->severity == Severity::information)
    return {Judgement::good, "no note limits the answer", {}};
  return {judgement_of(worst->severity),
          worst->path.empty() ? worst->text : worst->path + ": " + worst->text, worst->next_step};
}

}  // namespace strainwave

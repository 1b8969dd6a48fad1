// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// Evidence of every result besides its numbers: notes, accuracies, equations, and one verdict.

namespace strainwave {

/// Weight of a note.  The code that makes a note sets its severity.
enum class Severity {
  information,  ///< states what was done and does not raise doubt
  care,         ///< the answer is valid within a limit that the note names
  cannot_tell,  ///< a decisive input is unknown
  critical,     ///< a part fails, or the answer must not be acted on as it stands
};
template <>
struct EnumNames<Severity> {
  static constexpr std::array<std::string_view, 4> names = {"information", "care", "cannot tell",
                                                            "critical"};
};

/// A remark on validity: machine-readable code, sentence, field, equation of the theory manual.
struct Note {
  std::string code;
  std::string text;
  std::string path;            ///< path of the field concerned; empty: the whole drive
  std::string equation;        ///< tag, such as "FR-4"; empty: none
  Severity severity;           ///< no default, so the code that makes a note must choose it
  std::string next_step = {};  ///< action for the reader; empty: none

  friend bool operator==(const Note&, const Note&) = default;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"code", "", "machine-readable code"}, &Note::code);
    field({"severity", "", "weight of the note"}, &Note::severity);
    field({"text", "", "the remark, for a person"}, &Note::text);
    field({"next_step", "", "action for the reader; empty: none"}, &Note::next_step);
    field({"path", "", "field concerned; empty: the whole drive"}, &Note::path);
    field({"equation", "", "tag of the theory manual; empty: none"}, &Note::equation);
  }
};

/// A model-form uncertainty that entered a result, and its basis.
struct AccuracyBasis {
  std::string path;                   ///< path of the member or crack
  double relative_uncertainty = 0.0;  ///< one standard uncertainty, as it enters the compliance [-]
  std::string source;

  friend bool operator==(const AccuracyBasis&, const AccuracyBasis&) = default;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "member or crack"}, &AccuracyBasis::path);
    field({"relative_uncertainty", "1", "one standard uncertainty, as it enters the compliance"},
          &AccuracyBasis::relative_uncertainty);
    field({"source", "", "basis of the uncertainty"}, &AccuracyBasis::source);
  }
};

/// Judgement of an answer as a whole.
enum class Judgement { good, with_care, critical, cannot_be_told };
template <>
struct EnumNames<Judgement> {
  static constexpr std::array<std::string_view, 4> names = {"good", "with care", "critical",
                                                            "cannot be told"};
};

/// The verdict on an answer, with its reason and the next step.
struct Verdict {
  Judgement judgement = Judgement::good;
  std::string reason;     ///< one sentence
  std::string next_step;  ///< one sentence; empty if no action is needed

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"judgement", "", "good, with care, critical or cannot be told"}, &Verdict::judgement);
    field({"reason", "", "reason in one sentence"}, &Verdict::reason);
    field({"next_step", "", "next step; empty if no action is needed"}, &Verdict::next_step);
  }
};

/// The verdict that follows from notes.  The order is critical, cannot be told, with care.
///
/// @param unusable_because  reason why the answer must not be used; empty if usable.  An unusable
///                          answer gives the verdict "cannot be told", regardless of the notes.
/// @param notes             notes on the answer; may be empty
/// @return  the judgement of the most severe note, the first if several tie, with its text as the
///          reason; good if no note raises doubt
[[nodiscard]] Verdict verdict_of(std::string_view unusable_because, std::span<const Note> notes);

/// Outcome of requirements.
enum class RequirementOutcome { met, cannot_be_told, not_met };
template <>
struct EnumNames<RequirementOutcome> {
  static constexpr std::array<std::string_view, 3> names = {"met", "cannot be told", "not met"};
};

/// Evidence of a result.
struct ResultEvidence {
  std::string unusable_because;        ///< empty if the answer may be used
  bool refused = false;                ///< unusable because the request in the input cannot be met
  Verdict verdict;                     ///< follows from the notes, see verdict_of
  std::vector<Note> notes;             ///< on the validity of the answer
  std::vector<std::string> equations;  ///< tags of the theory manual
  std::vector<AccuracyBasis> accuracies;  ///< uncertainties that entered the result
  /// outcome of a command that judges requirements
  std::optional<RequirementOutcome> requirement;
};

/// The evidence of a result, taken from its members `unusable_because`, `notes`, `equations` and
/// `accuracies` if it has them.  A result with nested evidence has an overload of its own.
template <class Result>
[[nodiscard]] ResultEvidence evidence_of(const Result& result) {
  ResultEvidence evidence;
  if constexpr (requires { result.unusable_because; })
    evidence.unusable_because = result.unusable_because;
  if constexpr (requires { result.notes; }) evidence.notes = result.notes;
  if constexpr (requires { result.equations; }) evidence.equations = result.equations;
  if constexpr (requires { result.accuracies; }) evidence.accuracies = result.accuracies;
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave

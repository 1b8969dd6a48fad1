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
/// What every result says about itself besides its numbers: notes, accuracies, equations, and one
/// verdict.

namespace strainwave {

/// How much a note weighs.  It is set where the note is made.
enum class Severity {
  information,  ///< says what was done; raises no doubt
  care,         ///< the answer holds within a limit that the note names
  cannot_tell,  ///< something that decides is not known
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
  std::string path;            ///< of the field concerned; empty: the whole drive
  std::string equation;        ///< tag, such as "FR-4"; empty: none
  Severity severity;           ///< no default: whoever makes a note weighs it
  std::string next_step = {};  ///< what the reader can do about it; empty: nothing

  friend bool operator==(const Note&, const Note&) = default;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"code", "", "machine-readable code"}, &Note::code);
    field({"severity", "", "how much the note weighs"}, &Note::severity);
    field({"text", "", "the remark, for a person"}, &Note::text);
    field({"next_step", "", "what the reader can do about it; empty: nothing"}, &Note::next_step);
    field({"path", "", "field concerned; empty: the whole drive"}, &Note::path);
    field({"equation", "", "tag of the theory manual; empty: none"}, &Note::equation);
  }
};

/// A model-form uncertainty that entered a result, and what it rests on.
struct AccuracyBasis {
  std::string path;                   ///< of the member or crack
  double relative_uncertainty = 0.0;  ///< one standard, as it enters the compliance [-]
  std::string source;

  friend bool operator==(const AccuracyBasis&, const AccuracyBasis&) = default;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "member or crack"}, &AccuracyBasis::path);
    field({"relative_uncertainty", "1", "one standard, as it enters the compliance"},
          &AccuracyBasis::relative_uncertainty);
    field({"source", "", "what the uncertainty rests on"}, &AccuracyBasis::source);
  }
};

/// What an answer as a whole is worth.
enum class Judgement { good, with_care, critical, cannot_be_told };
template <>
struct EnumNames<Judgement> {
  static constexpr std::array<std::string_view, 4> names = {"good", "with care", "critical",
                                                            "cannot be told"};
};

/// One verdict on an answer, with its reason and what to do next.
struct Verdict {
  Judgement judgement = Judgement::good;
  std::string reason;     ///< one sentence
  std::string next_step;  ///< one sentence; empty where there is nothing to do

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"judgement", "", "good, with care, critical or cannot be told"}, &Verdict::judgement);
    field({"reason", "", "why, in one sentence"}, &Verdict::reason);
    field({"next_step", "", "what to do next; empty where there is nothing to do"},
          &Verdict::next_step);
  }
};

/// The verdict that notes lead to: critical before cannot be told before with care.
///
/// @param unusable_because  why the answer may not be used; empty if it may.  An answer that may
///                          not be used cannot be told, whatever the notes say.
/// @return  the judgement of the most severe note, the first if several tie, with its text as the
///          reason; good where no note raises a doubt
[[nodiscard]] Verdict verdict_of(std::string_view unusable_because, std::span<const Note> notes);

/// What became of requirements.
enum class RequirementOutcome { met, cannot_be_told, not_met };
template <>
struct EnumNames<RequirementOutcome> {
  static constexpr std::array<std::string_view, 3> names = {"met", "cannot be told", "not met"};
};

/// Everything that a result says about itself.
struct ResultEvidence {
  std::string unusable_because;  ///< empty if the answer may be used
  bool refused = false;          ///< it may not, because what the input asks for cannot be done
  Verdict verdict;
  std::vector<Note> notes;
  std::vector<std::string> equations;  ///< tags of the theory manual
  std::vector<AccuracyBasis> accuracies;
  std::optional<RequirementOutcome> requirement;  ///< of a command that answers requirements
};

/// The evidence of a result, from those of its members that hold one: `unusable_because`, `notes`,
/// `equations`, `accuracies`.  A result whose evidence lies deeper has an overload of its own.
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

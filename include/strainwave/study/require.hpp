// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

/// @file
/// Requirements on the outputs of a drive, judged with regard to the uncertainty of the outputs.

namespace strainwave {

/// How an output must compare with a bound.
enum class Comparison { at_least, more_than, at_most, less_than };
template <>
struct EnumNames<Comparison> {
  static constexpr std::array<std::string_view, 4> names = {">=", ">", "<=", "<"};
};

/// A requirement on one output.
struct Requirement {
  std::string output;                            ///< name of the output, as in for_each_quantity
  Comparison comparison = Comparison::at_least;  ///< how the output must compare with the bound
  double bound = 0.0;                            ///< [unit]
  std::string_view unit = "1";                   ///< SI unit of the bound
};

/// One requirement and its answer.
struct RequirementAnswer {
  Requirement requirement;  ///< the requirement as it was read
  Quantity value;           ///< value of the output
  /// Limits of the value by its uncertainty [unit]; absent if the uncertainty cannot be stated.
  std::optional<double> low;
  std::optional<double> high;  ///< upper limit [unit]
  /// met, not met, or cannot be told
  RequirementOutcome outcome = RequirementOutcome::cannot_be_told;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using A = RequirementAnswer;
    const auto shown = [](std::string_view name, std::string_view unit, std::string_view doc) {
      return Field{.name = name, .unit = unit, .doc = doc, .headline = true};
    };
    field(shown("output", "", "name of the output"),
          [](const A& a) { return a.requirement.output; });
    field(shown("comparison", "", "how the output must compare with the bound"),
          [](const A& a) { return a.requirement.comparison; });
    field(shown("bound", kUnitBeside, "the bound"), [](const A& a) {
      return Quantity{a.requirement.bound, a.requirement.unit};
    });
    field(shown("value", kUnitBeside, "the output"), &A::value);
    const auto limit = [](std::optional<double> A::*end) {
      return [end](const A& a) {
        return a.*end ? std::optional(Quantity{*(a.*end), a.requirement.unit}) : std::nullopt;
      };
    };
    field(shown("low", kUnitBeside, "the output less its uncertainty"), limit(&A::low));
    field(shown("high", kUnitBeside, "the output plus its uncertainty"), limit(&A::high));
    field(shown("outcome", "", "met, not met, or cannot be told"), &A::outcome);
  }
};

/// All requirements of one drive.
struct RequirementReport {
  Method method = Method::corrected;
  /// coverage factor: number of standard uncertainties taken into account [-]
  double coverage = 1.0;
  std::vector<RequirementAnswer> answers;
  RequirementOutcome outcome = RequirementOutcome::cannot_be_told;
  /// a remark on each requirement that is not met, cannot be told, or is met by the value alone
  std::vector<Note> notes;
  std::string unusable_because;  ///< reason why the outputs must not be used; empty if usable

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = RequirementReport;
    field({"method", "", "as-printed, repaired or corrected"}, &R::method);
    field({"coverage", "1", "number of standard uncertainties taken into account"}, &R::coverage);
    field({"requirements", "", "each requirement and its answer"}, &R::answers);
    field({.name = "outcome",
           .unit = "",
           .doc = "combined answer to all requirements",
           .headline = true},
          &R::outcome);
  }
};

/// The notes and the outcome of a report.
[[nodiscard]] ResultEvidence evidence_of(const RequirementReport& report);

/// Reads a requirement, "OUTPUT OP VALUE".
/// @param result  has the output
/// @param text    as in `require_outputs`
/// @param option  that gives the text, for messages
/// @throws InputError  if the text cannot be read, or does not name an output of the result
[[nodiscard]] Requirement parse_requirement(const StiffnessResult& result, std::string_view text,
                                            std::string_view option);

/// Judges requirements on the outputs of a result.
///
/// A requirement is met if the whole uncertainty interval of the output keeps the bound.  It is not
/// met if the whole interval breaks the bound.  In between, the answer is `cannot be told`.  An
/// output without a stated uncertainty is judged by its value, and a note says so.  The change of a
/// sum cannot be told if cracks change the coupled drive alone (ST-18).  The effects that a sum of
/// members leaves out extend its interval on the softer side only, if the drive is known to be
/// softer (ST-18).  A change has its own uncertainty, smaller than that of the stiffnesses it
/// compares.  The combined answer is `not met` if one requirement is not met, and `met` if all are
/// met.
///
/// @param result    has the outputs
/// @param texts     "OUTPUT OP VALUE" where OP is one of >=, >, <=, < and VALUE has a unit:
///                  "curve.positive.K2 >= 4e4 N*m/rad"
/// @param coverage  k, number of standard uncertainties taken into account [-]; > 0
/// @throws InputError  if a text cannot be read, or does not name an output of the result
[[nodiscard]] RequirementReport require_outputs(const StiffnessResult& result,
                                                const std::vector<std::string>& texts,
                                                double coverage);

}  // namespace strainwave

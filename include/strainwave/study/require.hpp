// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

/// @file
/// Requirements on the outputs of a drive, answered with regard to their uncertainty.

namespace strainwave {

/// How an output is to compare with a bound.
enum class Comparison { at_least, more_than, at_most, less_than };
template <>
struct EnumNames<Comparison> {
  static constexpr std::array<std::string_view, 4> names = {">=", ">", "<=", "<"};
};

/// What is asked of one output.
struct Requirement {
  std::string output;  ///< as for_each_quantity names it
  Comparison comparison = Comparison::at_least;
  double bound = 0.0;           ///< [unit]
  std::string_view unit = "1";  ///< SI
};

/// One requirement and its answer.
struct RequirementAnswer {
  Requirement requirement;
  Quantity value;  ///< of the output
  /// Between these the value lies, by its uncertainty [unit]; absent where nobody can state it.
  std::optional<double> low;
  std::optional<double> high;
  RequirementOutcome outcome = RequirementOutcome::cannot_be_told;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using A = RequirementAnswer;
    field({"output", "", "name of the output"}, [](const A& a) { return a.requirement.output; });
    field({"comparison", "", "how the output is to compare with the bound"},
          [](const A& a) { return a.requirement.comparison; });
    field({"bound", kUnitBeside, "the bound"}, [](const A& a) {
      return Quantity{a.requirement.bound, a.requirement.unit};
    });
    field({"value", kUnitBeside, "the output"}, &A::value);
    const auto limit = [](std::optional<double> A::*end) {
      return [end](const A& a) {
        return a.*end ? std::optional(Quantity{*(a.*end), a.requirement.unit}) : std::nullopt;
      };
    };
    field({"low", kUnitBeside, "the output less its uncertainty"}, limit(&A::low));
    field({"high", kUnitBeside, "the output plus its uncertainty"}, limit(&A::high));
    field({"outcome", "", "met, not met, or cannot be told"}, &A::outcome);
  }
};

/// All requirements of one drive.
struct RequirementReport {
  Method method = Method::corrected;
  double coverage = 1.0;  ///< standard uncertainties that count [-]
  std::vector<RequirementAnswer> answers;
  RequirementOutcome outcome = RequirementOutcome::cannot_be_told;
  std::vector<Note> notes;
  std::string unusable_because;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = RequirementReport;
    field({"method", "", "as-printed, repaired or corrected"}, &R::method);
    field({"coverage", "1", "standard uncertainties that count"}, &R::coverage);
    field({"requirements", "", "each requirement and its answer"}, &R::answers);
    field({.name = "outcome", .unit = "", .doc = "of all together", .headline = true}, &R::outcome);
  }
};

/// Its notes and its outcome.
[[nodiscard]] ResultEvidence evidence_of(const RequirementReport& report);

/// Answers requirements on the outputs of a result.
///
/// A requirement is met if the output keeps its bound with all of its uncertainty, not met if it
/// breaks the bound with all of it, and cannot be told between.  A change has an uncertainty of its
/// own, which is smaller than that of the stiffnesses it compares.  All together are not met if one
/// is not met, and met if all are met.
///
/// @param texts     "OUTPUT OP VALUE" with OP one of >=, >, <=, < and a unit at the value:
///                  "cracked.positive.stiffness >= 2e4 N*m/rad"
/// @param coverage  k, standard uncertainties that count [-]; > 0
/// @throws InputError  a text cannot be read, or names no output of the result
[[nodiscard]] RequirementReport require_outputs(const StiffnessResult& result,
                                                const std::vector<std::string>& texts,
                                                double coverage);

}  // namespace strainwave

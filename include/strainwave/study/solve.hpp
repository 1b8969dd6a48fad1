// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Values between which a number of the gear is sought [unit of the field].
struct SearchRange {
  double from = 0.0;
  double to = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", kUnitBeside, "in the SI unit of the field"}, &SearchRange::from);
    field({"to", kUnitBeside, "in the SI unit of the field"}, &SearchRange::to);
  }
};

/// The number of the gear to be found.
struct Unknown {
  std::string path;  ///< "output_shaft.crack[0].depth"
  /// Absent: chosen round the present value.  A field with two bounds is searched from one to the
  /// other; any other from 1/1000 to 1000 times its present value, with 0 and with the other sign
  /// where the field allows them.
  std::optional<SearchRange> range;
};

/// The value that an output is to take.
struct Target {
  std::string output;           ///< as for_each_quantity names it: "cracked.positive.stiffness"
  std::string_view unit = "1";  ///< SI
  double value = 0.0;           ///< [unit]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"output", "", "name of the output"}, &Target::output);
    field({"unit", "", "SI unit of the output"}, &Target::unit);
    field({"value", kUnitBeside, "the wanted value"}, &Target::value);
  }
};

/// Reads "PATH" or "PATH=FROM..TO", such as "output_shaft.crack[0].depth=0.1 mm..8 mm".
/// @throws InputError  if the path is no number of `gear`, or the text is anything else
[[nodiscard]] Unknown parse_unknown(const GearSet& gear, std::string_view text);

/// Reads "OUTPUT=VALUE", such as "cracked.positive.stiffness_change=-1 %" or "intact.stiffness=6e5
/// N*m/rad".
///
/// @param gear, method  decide which outputs there are
/// @throws InputError   if there is no such output, the message names near ones; if the text is
///                      anything else; as evaluate(gear, method)
[[nodiscard]] Target parse_target(const GearSet& gear, Method method, std::string_view text);

struct SolveOptions {
  /// Points of the first scan; two solutions closer than its spacing are found only where the
  /// output turns round between them.
  int n_scan = 400;
};

/// One value that gives the target.
struct Solution {
  /// The sought number [unit of the field].  Its uncertainty is that of the output, carried over
  /// to first order: u_x = u_y |y/(x dy/dx)|; absent where it cannot be stated.
  Quantity value;
  Quantity output;         ///< the output there
  StiffnessResult result;  ///< everything else there

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"value", kUnitBeside, "the value of the field"}, &Solution::value);
    field({"output", kUnitBeside, "the output there"}, &Solution::output);
    field({"result", "", "everything else there"}, &Solution::result);
  }
};

/// A part of the range where the method gives no result that may be used.
struct Excluded {
  double from = 0.0;  ///< [unit of the field]
  double to = 0.0;
  bool refused = false;  ///< no result at all; else one that may not be used
  std::string reason;    ///< of the first point

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", kUnitBeside, "in the SI unit of the field"}, &Excluded::from);
    field({"to", kUnitBeside, "in the SI unit of the field"}, &Excluded::to);
    field({"refused", "", "no result at all; else one that may not be used"}, &Excluded::refused);
    field({"reason", "", "of the first point"}, &Excluded::reason);
  }
};

/// All values of a number that give an output its wanted value.
struct SolveResult {
  Method method = Method::corrected;
  std::string path;             ///< of the sought number
  std::string_view unit = "1";  ///< of the sought number, SI
  double present = 0.0;         ///< its value in the gear as given
  Target target;
  SearchRange searched;             ///< from < to
  std::vector<Solution> solutions;  ///< ascending
  std::vector<Excluded> excluded;   ///< ascending
  /// Of the output over the searched range, where its result may be used; absent if nowhere.
  std::optional<double> least;
  std::optional<double> greatest;
  /// Empty if there is one solution and nothing to remark; else sentences: none, several, jumps
  /// over the target, solutions that may not be used.
  std::string reason;
  [[nodiscard]] bool usable() const { return !solutions.empty(); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = SolveResult;
    const auto output = [](std::optional<double> R::*member) {
      return [member](const R& r) {
        return r.*member ? std::optional(Quantity{*(r.*member), r.target.unit}) : std::nullopt;
      };
    };
    field({"method", "", "as-printed, repaired or corrected"}, &R::method);
    field({"path", "", "the sought field"}, &R::path);
    field({"unit", "", "SI unit of the sought field"}, &R::unit);
    field({"present", kUnitBeside, "value of the field in the file"}, &R::present);
    field({"target", "", "what the output is to be"}, &R::target);
    field({"searched", "", "range that was searched"}, &R::searched);
    field({"least", kUnitBeside, "of the output over the range"}, output(&R::least));
    field({"greatest", kUnitBeside, "of the output over the range"}, output(&R::greatest));
    field({"excluded", "", "parts of the range without a usable result"}, &R::excluded);
    field({"reason", "", "what there is to remark; empty for one plain solution"}, &R::reason);
    field({"solutions", "", "ascending"}, &R::solutions);
  }
};

/// The notes and accuracies of the first solution; not usable without one.
[[nodiscard]] ResultEvidence evidence_of(const SolveResult& result);

/// Finds all values of one number of the gear for which an output takes a wanted value.
///
/// The range is scanned; the ends of each stretch that the method accepts are found by bisection,
/// so that a solution close to a limit (a crack almost through the wall) is not lost; each change
/// of sign is refined to rounding.  Where the output jumps over the target (a crack that closes)
/// there is no solution, and `reason` says so.  A result that may not be used is none either.
///
/// @throws InputError  if the range is not valid or none can be chosen; if there is no such output;
///                     the first fault if the method refuses every value
[[nodiscard]] SolveResult solve(const GearSet& gear, Method method, const Unknown& unknown,
                                const Target& target, const SolveOptions& options = {},
                                const Progress& progress = {});

/// What the output takes over the searched range: "between 1 % and 2 %", or that it is the same
/// everywhere.  The result has `least`.
[[nodiscard]] std::string output_range(const SolveResult& result);

}  // namespace strainwave

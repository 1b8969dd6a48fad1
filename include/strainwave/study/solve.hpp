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

/// Range in which a number of the gear is sought [unit of the field].
struct SearchRange {
  double from = 0.0;
  double to = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", kUnitBeside, "lower end, in the SI unit of the field"}, &SearchRange::from);
    field({"to", kUnitBeside, "upper end, in the SI unit of the field"}, &SearchRange::to);
  }
};

/// The number of the gear to be found.
struct Unknown {
  std::string path;  ///< "output_shaft.crack[0].depth"
  /// Absent: a range round the present value is chosen.  A field with two bounds is searched from
  /// one bound to the other.  Any other field is searched from 1/1000 to 1000 times its present
  /// value, with 0 and with the other sign if the field allows them.
  std::optional<SearchRange> range;
};

/// The value that an output has to reach.
struct Target {
  std::string output;           ///< name as in for_each_quantity: "cracked.positive.stiffness"
  std::string_view unit = "1";  ///< SI unit of the value
  double value = 0.0;           ///< [unit]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"output", "", "name of the output"}, &Target::output);
    field({"unit", "", "SI unit of the output"}, &Target::unit);
    field({"value", kUnitBeside, "the wanted value"}, &Target::value);
  }
};

/// Reads "PATH" or "PATH=FROM..TO", such as "output_shaft.crack[0].depth=0.1 mm..8 mm".
/// @throws InputError  if the path does not name a number of `gear`, or the text has another form
[[nodiscard]] Unknown parse_unknown(const GearSet& gear, std::string_view text);

/// Reads "OUTPUT=VALUE", such as "cracked.positive.stiffness_change=-1 %" or "intact.stiffness=6e5
/// N*m/rad".
///
/// @param gear, method  determine the available outputs
/// @param text          "OUTPUT=VALUE"; the unit of VALUE may be left out only if it is 1
/// @throws InputError   if the output does not exist (the message names near outputs); if the text
///                      has another form; on the same conditions as evaluate(gear, method)
[[nodiscard]] Target parse_target(const GearSet& gear, Method method, std::string_view text);

/// How a range is searched.
struct SolveOptions {
  /// Points of the first scan.  Two solutions closer than the spacing are found only if the output
  /// has an extremum between them.
  int n_scan = 400;
};

/// One value of the sought number that gives the target.
struct Solution {
  /// The sought number [unit of the field].  Its uncertainty follows from that of the output to
  /// first order, u_x = u_y |y/(x dy/dx)|; absent if it cannot be stated or exceeds 100 %.
  Quantity value;
  Quantity output;         ///< the output at this value
  StiffnessResult result;  ///< the complete result at this value

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"value", kUnitBeside, "the value of the field"}, &Solution::value);
    field({"output", kUnitBeside, "the output at this value"}, &Solution::output);
    field({"result", "", "the complete result at this value"}, &Solution::result);
  }
};

/// A part of the range where the method does not give a usable result.
struct Excluded {
  double from = 0.0;  ///< lower end [unit of the field]
  double to = 0.0;
  /// true: the method refuses the values; false: its results must not be used
  bool refused = false;
  std::string reason;  ///< reason at the first point

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", kUnitBeside, "lower end, in the SI unit of the field"}, &Excluded::from);
    field({"to", kUnitBeside, "upper end, in the SI unit of the field"}, &Excluded::to);
    field({"refused", "", "true: refused by the method; false: result must not be used"},
          &Excluded::refused);
    field({"reason", "", "reason at the first point"}, &Excluded::reason);
  }
};

/// All values of a number that give an output its wanted value.
struct SolveResult {
  Method method = Method::corrected;
  std::string path;             ///< path of the sought number
  std::string_view unit = "1";  ///< SI unit of the sought number
  double present = 0.0;         ///< its value in the gear as given
  Target target;
  SearchRange searched;             ///< from < to
  std::vector<Solution> solutions;  ///< ascending
  std::vector<Excluded> excluded;   ///< ascending
  /// Extremes of the output over the usable parts of the searched range; absent if no part is
  /// usable.
  std::optional<double> least;
  std::optional<double> greatest;  ///< largest value of the output [unit of the target], as `least`
  /// Empty for a single solution without remarks; else sentences on no solution, several solutions,
  /// jumps over the target, or solutions that must not be used.
  std::string reason;
  std::vector<Note> notes;  ///< notes on the accuracies of the solutions
  /// Whether there is a solution.
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
    field({"target", "", "wanted value of the output"}, &R::target);
    field({"searched", "", "range that was searched"}, &R::searched);
    field({"least", kUnitBeside, "least output over the range"}, output(&R::least));
    field({"greatest", kUnitBeside, "greatest output over the range"}, output(&R::greatest));
    field({"excluded", "", "parts of the range without a usable result"}, &R::excluded);
    field({"reason", "", "remarks; empty for a single solution without remarks"}, &R::reason);
    field({"solutions", "", "ascending"}, &R::solutions);
  }
};

/// The notes and accuracies of the first solution; not usable without a solution.
[[nodiscard]] ResultEvidence evidence_of(const SolveResult& result);

/// Finds all values of one number of the gear for which an output takes a wanted value.
///
/// The range is scanned.  The ends of each stretch that the method accepts are found by bisection,
/// so that a solution close to a limit (a crack almost through the wall) is found.  Each change of
/// sign is refined to rounding.  If the output jumps over the target (a crack that closes), there
/// is no solution, and `reason` explains it.  A value whose result must not be used does not count
/// as a solution.
///
/// @throws InputError  if the range is not valid or cannot be chosen; if the output does not exist;
///                     with the first fault if the method refuses every value
[[nodiscard]] SolveResult solve(const GearSet& gear, Method method, const Unknown& unknown,
                                const Target& target, const SolveOptions& options = {},
                                const Progress& progress = {});

/// Values of the output over the searched range in words: "between 1 % and 2 %", or that the output
/// is constant.  The result must have `least`.
[[nodiscard]] std::string output_range(const SolveResult& result);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Verdict on one number or equation of the article.
enum class AuditVerdict {
  reproduced,        ///< follows from the printed inputs by the printed equation
  misprint,          ///< a slip of a digit, sign or exponent that can be named
  dimension,         ///< the dimension of the equation is not that of the quantity it defines
  physics,           ///< the equation is wrong for all numbers
  not_reproducible,  ///< nothing printed leads to the number
  ambiguous,         ///< the text has more than one meaning
  input,  ///< the article takes the number from elsewhere, so there is nothing to reproduce
};
template <>
struct EnumNames<AuditVerdict> {
  static constexpr std::array<std::string_view, 7> names = {
      "reproduced", "misprint", "dimension", "physics", "not reproducible", "ambiguous", "input"};
};

/// The value of an input for which the printed equation gives the printed number.
struct ReproducingInput {
  std::string name;
  double value = 0.0;
  std::string unit;  ///< unit used in the article: mm, N, MPa, rad

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"input", "", "name of the input, by its symbol"}, &ReproducingInput::name);
    field({"unit", "", "unit used in the article: mm, N, MPa, rad, or \"1\""},
          &ReproducingInput::unit);
    field({"value", kUnitBeside, "value of the input, in the unit beside it"},
          &ReproducingInput::value);
  }
};

/// One number or equation of the article's worked example, and what the audit found.
struct AuditRow {
  std::string id;        ///< A: fracture mechanics, B: wave generator, C: flexspline, D: output
                         ///< shaft, T: table and text
  std::string quantity;  ///< description of the quantity, with its symbol
  std::string unit;      ///< unit of the numbers of this row, as in the article; "1" if pure
  std::optional<double> printed = {};  ///< the printed number
  std::optional<double> own = {};      ///< result of the article's equation for its printed inputs
  std::optional<double> corrected = {};  ///< result of the corrected theory
  AuditVerdict verdict = AuditVerdict::reproduced;
  std::string sentence = {};  ///< reason of the verdict, in one sentence
  /// value of one input that gives the printed number, by root finding
  std::optional<ReproducingInput> reproduce = {};

  /// Ratio printed/own; own/corrected if nothing is printed; absent if one of the two is missing.
  [[nodiscard]] std::optional<double> ratio() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"id", "", "chapter and number"}, &AuditRow::id);
    field({"quantity", "", "description of the quantity, with its symbol"}, &AuditRow::quantity);
    field({"unit", "", "unit of the numbers of this row, as in the article, or \"1\""},
          &AuditRow::unit);
    field({"printed", kUnitBeside, "the printed number, in the unit of the row"},
          &AuditRow::printed);
    field({"own_equation", kUnitBeside,
           "result of the article's equation for its printed inputs, in the unit of the row"},
          &AuditRow::own);
    field({"corrected", kUnitBeside, "result of the corrected theory, in the unit of the row"},
          &AuditRow::corrected);
    field({"ratio", "1", "printed/own, or own/corrected if nothing is printed"}, &AuditRow::ratio);
    field({"verdict", "", "verdict on the number or equation"}, &AuditRow::verdict);
    field({"sentence", "", "why"}, &AuditRow::sentence);
    field({"reproduced_by", "", "value of one input that gives the printed number"},
          &AuditRow::reproduce);
  }
};

/// The audit of the article's worked example.  Every number is computed by this call; only the
/// article's printed numbers and inputs are constants in the code.
[[nodiscard]] std::vector<AuditRow> audit();

}  // namespace strainwave

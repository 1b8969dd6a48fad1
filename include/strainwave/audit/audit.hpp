// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// What became of one number or equation of the article.
enum class AuditVerdict {
  reproduced,        ///< follows from the printed inputs by the printed equation
  misprint,          ///< a slip of a digit, sign or exponent that can be named
  dimension,         ///< the equation does not have the dimension of what it gives
  physics,           ///< the equation is wrong, whatever its numbers
  not_reproducible,  ///< the number does not follow from anything printed
  ambiguous,         ///< the text leaves open what is meant
  input,             ///< the article takes it from elsewhere; there is nothing to reproduce
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
  std::string unit;  ///< of the article: mm, N, MPa, rad

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"input", "", "name of the input, by its symbol"}, &ReproducingInput::name);
    field({"unit", "", "unit of the article: mm, N, MPa, rad, \"1\" if pure"},
          &ReproducingInput::unit);
    field({"value", kUnitBeside, "its value, in the unit beside it"}, &ReproducingInput::value);
  }
};

/// One number or equation of the article's worked example.
struct AuditRow {
  std::string id;        ///< A: fracture mechanics, B: wave generator, C: flexspline, D: output
                         ///< shaft, T: table and text
  std::string quantity;  ///< what it is, with symbol
  std::string unit;      ///< of the numbers of this row, as the article has them; "1" if pure
  std::optional<double> printed = {};  ///< the printed number
  std::optional<double> own = {};      ///< what its own printed equation gives with printed inputs
  std::optional<double> corrected = {};  ///< what the corrected theory gives
  AuditVerdict verdict = AuditVerdict::reproduced;
  std::string sentence = {};                       ///< why, in one sentence
  std::optional<ReproducingInput> reproduce = {};  ///< found by root finding

  /// Printed over own; own over corrected where nothing is printed; absent where there is none.
  [[nodiscard]] std::optional<double> ratio() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"id", "", "chapter and number"}, &AuditRow::id);
    field({"quantity", "", "what it is, with its symbol"}, &AuditRow::quantity);
    field({"unit", "", "unit of the numbers of this row, as the article has it, \"1\" if pure"},
          &AuditRow::unit);
    field({"printed", kUnitBeside, "the printed number, in the unit of the row"},
          &AuditRow::printed);
    field({"own_equation", kUnitBeside,
           "what its own printed equation gives with the printed inputs, in the unit of the row"},
          &AuditRow::own);
    field({"corrected", kUnitBeside, "what the corrected theory gives, in the unit of the row"},
          &AuditRow::corrected);
    field({"ratio", "1", "printed over own equation; own equation over corrected if not printed"},
          &AuditRow::ratio);
    field({"verdict", "", "what became of the number or equation"}, &AuditRow::verdict);
    field({"sentence", "", "why"}, &AuditRow::sentence);
    field({"reproduced_by", "", "value of one input for which the printed number follows"},
          &AuditRow::reproduce);
  }
};

/// The audit of the article's worked example, computed now: only the printed numbers and inputs
/// are typed in.
[[nodiscard]] std::vector<AuditRow> audit();

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
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
};
template <>
struct EnumNames<AuditVerdict> {
  static constexpr std::array<std::string_view, 6> names = {
      "reproduced", "misprint", "dimension", "physics", "not reproducible", "ambiguous"};
};

/// The value of an input for which the printed equation gives the printed number.
struct ReproducingInput {
  std::string name;
  double value = 0.0;
  std::string unit;  ///< of the article: mm, N, MPa, rad
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
};

/// The audit of the article's worked example, computed now: only the printed numbers and inputs
/// are typed in.
[[nodiscard]] std::vector<AuditRow> audit();

/// The rows as a table for a terminal, at most 110 columns wide.
[[nodiscard]] std::string audit_text(std::span<const AuditRow> rows);

/// The rows as a JSON array.
[[nodiscard]] std::string audit_json(std::span<const AuditRow> rows);

/// The rows as a table of the theory manual.
[[nodiscard]] std::string audit_markdown(std::span<const AuditRow> rows);

}  // namespace strainwave

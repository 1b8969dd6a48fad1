// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace strainwave {

/// Root of everything strainwave throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A place in a text that was read; lines and columns count from 1, and 0 is none.
struct TextPlace {
  std::string file = {};
  std::size_t line = 0;
  std::size_t column = 0;
};

/// A value given by the caller is outside what the model accepts.
///
/// The message names the field, its value and unit, and the rule it breaks.  Readers of files put
/// `file:line:column` in front of it (io/gear_reader.hpp).  Its parts can also be had one by one.
class InputError : public Error {
 public:
  /// A number that breaks a rule: `field = value unit violates: rule`.
  InputError(std::string_view field, double value, std::string_view unit, std::string_view rule);
  /// Anything else that is wrong with a field: `field: problem`.
  InputError(std::string_view field, std::string_view problem);
  /// A text that is wrong at a place, before any field is known: `file:line:column: problem`.
  InputError(const TextPlace& place, std::string_view problem);
  /// The same fault with its place in a file: `file:line:column: ...`.
  [[nodiscard]] InputError located(const TextPlace& place, std::string_view value_as_written) const;

  [[nodiscard]] const std::string& field() const noexcept { return field_; }
  /// The value at fault, as it is written in the text or else with its unit; empty where none is.
  [[nodiscard]] const std::string& value() const noexcept { return value_; }
  /// The rule that a number breaks; empty when the fault is of another kind.
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }
  /// Where the fault is in a text; no file where it is in none.
  [[nodiscard]] const TextPlace& place() const noexcept { return place_; }

 private:
  struct Parts {
    std::string field;
    std::string value;
    std::string rule;
    TextPlace place;
  };
  InputError(const std::string& message, Parts parts);

  std::string field_;
  std::string value_;
  std::string rule_;
  TextPlace place_;
};

/// A numerical method did not deliver; the message says the last step and the usual causes.
class SolverError : public Error {
 public:
  using Error::Error;
};

/// Text from outside as a message shows it: on one line, control characters escaped, cut after
/// `most` bytes.
[[nodiscard]] std::string shown(std::string_view text, std::size_t most = 200);

/// Throws InputError unless `ok`; write the rule as the reader would say it, and the condition
/// positively, so that NaN breaks it.
inline void require(bool ok, std::string_view field, double value, std::string_view unit,
                    std::string_view rule) {
  if (!ok) throw InputError(field, value, unit, rule);
}

}  // namespace strainwave

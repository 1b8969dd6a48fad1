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

/// A value given by the caller is outside what the model accepts.
///
/// The message names the field, its value and unit, and the rule it breaks.  Readers of files put
/// `file:line:column` in front of it (io/gear_reader.hpp).
class InputError : public Error {
 public:
  /// A number that breaks a rule: `field = value unit violates: rule`.
  InputError(std::string_view field, double value, std::string_view unit, std::string_view rule);
  /// Anything else that is wrong with a field: `field: problem`.
  InputError(std::string_view field, std::string_view problem);
  /// The same fault with its place in a file: `file:line:column: ...`.
  [[nodiscard]] InputError located(std::string_view place, std::string_view value_as_written) const;

  [[nodiscard]] const std::string& field() const noexcept { return field_; }
  /// The rule that a number breaks; empty when the fault is of another kind.
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }

 private:
  struct Text {
    std::string message;
  };
  InputError(const Text& text, std::string field, std::string rule);

  std::string field_;
  std::string rule_;
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

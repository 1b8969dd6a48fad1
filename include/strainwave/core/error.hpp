// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace strainwave {

/// Base class of all exceptions that strainwave throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A place in a text that was read.  Lines and columns count from 1; 0 means unknown.
struct TextPlace {
  std::string file = {};   ///< name of the text
  std::size_t line = 0;    ///< from 1; 0: unknown
  std::size_t column = 0;  ///< from 1; 0: unknown
};

/// A value given by the caller is outside what the model accepts.
///
/// The message names the field, its value and unit, and the rule it breaks.  Readers of files put
/// `file:line:column` in front of it (io/gear_reader.hpp).  The parts of the message are also
/// available one by one.
class InputError : public Error {
 public:
  /// A number that breaks a rule: `field = value unit violates: rule`.
  InputError(std::string_view field, double value, std::string_view unit, std::string_view rule);
  /// Any other fault of a field: `field: problem`.
  InputError(std::string_view field, std::string_view problem);
  /// A fault at a place of a text before any field is known: `file:line:column: problem`.
  InputError(const TextPlace& place, std::string_view problem);
  /// The same fault with its place in a file: `file:line:column: ...`.
  [[nodiscard]] InputError located(const TextPlace& place, std::string_view value_as_written) const;
  /// The same fault with a remark at the end of its message: `...; remark`.
  [[nodiscard]] InputError remarked(std::string_view remark) const;

  /// Path of the faulty field, or name of the option or the file; empty if no field is known.
  [[nodiscard]] const std::string& field() const noexcept { return field_; }
  /// The faulty value as written in the text, or else with its unit; empty if no value is at fault.
  [[nodiscard]] const std::string& value() const noexcept { return value_; }
  /// The rule that a number breaks; empty for a fault of another kind.
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }
  /// Place of the fault in a text; the file is empty if the fault is not in a text.
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

/// A numerical method failed; the message states the last step and the usual causes.
class SolverError : public Error {
 public:
  using Error::Error;
};

/// Foreign text made safe for a message: on one line, with escaped control characters, cut after
/// `most` bytes.
[[nodiscard]] std::string shown(std::string_view text, std::size_t most = 200);

/// Throws InputError unless `ok`.  Phrase the rule for the reader of the message, and the condition
/// positively, so that NaN fails it.
inline void require(bool ok, std::string_view field, double value, std::string_view unit,
                    std::string_view rule) {
  if (!ok) throw InputError(field, value, unit, rule);
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/described.hpp"

namespace strainwave {

/// Form of the numbers in a JSON document.
enum class JsonNumbers {
  with_unit,  ///< {"value": 0.003, "unit": "m"}; a column states its unit once
  as_input,   ///< "0.003 m", in the form that the reader of drives accepts
};

/// Writes described values as JSON, with an indentation of two spaces per level.  A quantity takes
/// one line, and so does a column with its values.  Text may be any bytes; the document is UTF-8.
class JsonWriter : public ValueVisitor {
 public:
  explicit JsonWriter(JsonNumbers numbers = JsonNumbers::with_unit) : numbers_(numbers) {}

  /// The document, ended by a line feed.
  [[nodiscard]] std::string document() const { return text_ + '\n'; }
  /// Changes the form of the numbers that follow.
  void write_numbers(JsonNumbers numbers) { numbers_ = numbers; }
  /// From here on, writes numbers with a unit in these units, by dimension.  In a table by columns,
  /// units that have a column of their own do not change.
  /// @param units  units that must outlive the writer
  void write_units(const AskedUnits& units) { units_ = &units; }
  /// Writes a field with its text, flag or null.
  void member(std::string_view name, std::string_view value);
  void member(std::string_view name, const char* value) { member(name, std::string_view(value)); }
  void member(std::string_view name, bool value);

  void begin_record() override;
  void end_record() override;
  bool field(const Field& field) override;
  void begin_list() override;
  void end_list() override;
  void begin_column(const Field& field) override;
  void end_column() override;
  void number(double value, const Field& field) override;
  void quantity(const Quantity& value) override;
  void whole(std::int64_t value) override;
  void flag(bool value) override;
  void text(std::string_view value) override;
  void nothing() override;

 private:
  /// The unit of a value and the one to write it in; equal texts: as it is.
  struct Change {
    std::string from;
    std::string to;
  };
  [[nodiscard]] Change change_of(std::string_view unit) const;
  [[nodiscard]] std::string written(double value, const Change& change) const;

  void open(char bracket);
  void close(char bracket);
  void separate();
  void line();

  JsonNumbers numbers_;
  std::string text_;
  std::vector<bool> empty_;  // whether each open bracket is still empty
  int columns_ = 0;          // number of open columns; their content stays on one line
  bool keyed_ = false;       // true after a key, before its value
  const AskedUnits* units_ = nullptr;
  std::string key_;              // the last key
  std::vector<Change> records_;  // for each open record, from its field `unit`
  Change column_;                // for the open column
};

/// A described value as a JSON document.
template <class T>
[[nodiscard]] std::string json_of(const T& value, JsonNumbers numbers = JsonNumbers::with_unit) {
  JsonWriter writer(numbers);
  visit_value(value, {}, writer);
  return writer.document();
}

}  // namespace strainwave

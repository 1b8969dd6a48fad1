// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "strainwave/core/described.hpp"

namespace strainwave {

/// Receives the name and the value of an output.
using QuantityReader = std::function<void(const std::string& path, const Quantity& quantity)>;

/// Walks the outputs of a described result in the order of the JSON document: all numbers except
/// details and columns, with paths such as "cracked.positive.stiffness".  CSV, sweep, solve and
/// require name their outputs by this walk.  If an element has a field `path`, the names of its
/// outputs begin with the value of this field:
/// "flexspline.crack[0].added_compliance.positive.at_output".
class OutputWalk : public ValueVisitor {
 public:
  /// @param read  is called for each output
  explicit OutputWalk(QuantityReader read) : read_(std::move(read)) {}

  /// See ValueVisitor.  A number outside a column goes to the reader with its path.
  /// @{
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
  /// @}

 private:
  struct Level {
    std::string path;      ///< path of the record or list
    std::size_t next = 0;  ///< index of the next element of a list
    bool list = false;
  };
  void element();

  QuantityReader read_;
  std::string path_;
  std::string_view name_;  ///< path of the last field
  std::vector<Level> levels_;
  int columns_ = 0;
};

/// Walks the outputs of a result and calls `read(path, quantity)` for each.
template <Described Result>
void for_each_quantity(const Result& result, QuantityReader read) {
  OutputWalk walk(std::move(read));
  visit_value(result, {}, walk);
}

}  // namespace strainwave

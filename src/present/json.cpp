// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "strainwave/core/quantity_text.hpp"

namespace strainwave {
namespace {

std::string in_quotes(std::string_view text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Writes a number; JSON cannot represent infinity and NaN.
std::string bare(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

}  // namespace

void JsonWriter::line() {
  if (columns_ > 0) return;
  text_ += '\n';
  text_.append(2 * empty_.size(), ' ');
}

void JsonWriter::separate() {
  if (keyed_) {
    keyed_ = false;
    return;
  }
  if (empty_.empty()) return;
  if (!empty_.back()) text_ += columns_ > 0 ? ", " : ",";
  empty_.back() = false;
  line();
}

void JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
  empty_.push_back(true);
}

void JsonWriter::close(char bracket) {
  const bool empty = empty_.back();
  empty_.pop_back();
  if (!empty) line();
  text_ += bracket;
}

JsonWriter::Change JsonWriter::change_of(std::string_view unit) const {
  if (unit == kUnitBeside) return records_.empty() ? Change{} : records_.back();
  const auto asked = units_ == nullptr ? std::nullopt : units_->of({}, unit);
  return {std::string(unit), std::string(asked ? asked->text : unit)};
}

std::string JsonWriter::written(double value, const Change& change) const {
  if (!std::isfinite(value) || change.from == change.to) return bare(value);
  return number_in(value, change.from, change.to);
}

void JsonWriter::begin_record() {
  open('{');
  records_.push_back(records_.empty() ? Change{} : records_.back());
}

void JsonWriter::end_record() {
  close('}');
  records_.pop_back();
}
void JsonWriter::begin_list() { open('['); }
void JsonWriter::end_list() { close(']'); }

bool JsonWriter::field(const Field& field) {
  separate();
  text_ += in_quotes(field.name) + ": ";
  key_ = field.name;
  keyed_ = true;
  return true;
}

void JsonWriter::member(std::string_view name, std::string_view value) {
  field({.name = name, .unit = {}, .doc = {}});
  text(value);
}

void JsonWriter::member(std::string_view name, bool value) {
  field({.name = name, .unit = {}, .doc = {}});
  flag(value);
}

void JsonWriter::begin_column(const Field& field) {
  if (columns_ == 0 && numbers_ == JsonNumbers::with_unit) {
    separate();
    column_ = change_of(field.unit);
    text_ += '{';
    if (!field.unit.empty() && field.unit != kUnitBeside)
      text_ += fmt::format("\"unit\": {}, ", in_quotes(column_.to));
    text_ += "\"values\": ";
    keyed_ = true;
  }
  open('[');
  ++columns_;
}

void JsonWriter::end_column() {
  close(']');
  --columns_;
  if (columns_ == 0 && numbers_ == JsonNumbers::with_unit) text_ += '}';
}

void JsonWriter::number(double value, const Field& field) {
  if (numbers_ == JsonNumbers::as_input && field.unit != "1") {
    text(quantity_text(value, field.unit));
  } else if (columns_ > 0 || field.unit == kUnitBeside || numbers_ == JsonNumbers::as_input) {
    separate();
    text_ += columns_ > 0 ? written(value, column_) : written(value, change_of(field.unit));
  } else {
    separate();
    const Change change = change_of(field.unit);
    text_ +=
        fmt::format(R"({{"value": {}, "unit": {}}})", written(value, change), in_quotes(change.to));
  }
}

void JsonWriter::quantity(const Quantity& value) {
  separate();
  const Change change = columns_ > 0 ? column_ : change_of(value.unit);
  if (columns_ > 0)
    text_ += written(value.value, change);
  else
    text_ += fmt::format(
        R"({{"value": {}, "unit": {}, "relative_uncertainty": {}}})", written(value.value, change),
        in_quotes(change.to),
        value.relative_uncertainty ? bare(*value.relative_uncertainty) : std::string("null"));
}

void JsonWriter::whole(std::int64_t value) {
  separate();
  text_ += std::to_string(value);
}

void JsonWriter::flag(bool value) {
  separate();
  text_ += value ? "true" : "false";
}

void JsonWriter::text(std::string_view value) {
  separate();
  if (key_ == "unit" && columns_ == 0 && !records_.empty()) {
    records_.back() = change_of(value);
    text_ += in_quotes(records_.back().to);
    return;
  }
  text_ += in_quotes(value);
}

void JsonWriter::nothing() {
  separate();
  text_ += "null";
}

}  // namespace strainwave

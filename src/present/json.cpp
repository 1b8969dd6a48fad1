// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "strainwave/core/quantity_text.hpp"

namespace strainwave {
namespace {

std::string quoted(std::string_view text) {
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

void JsonWriter::begin_record() { open('{'); }
void JsonWriter::end_record() { close('}'); }
void JsonWriter::begin_list() { open('['); }
void JsonWriter::end_list() { close(']'); }

bool JsonWriter::field(const Field& field) {
  separate();
  text_ += quoted(field.name) + ": ";
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
    text_ += '{';
    if (!field.unit.empty() && field.unit != kUnitBeside)
      text_ += fmt::format("\"unit\": {}, ", quoted(field.unit));
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
    text_ += bare(value);
  } else {
    separate();
    text_ += fmt::format(R"({{"value": {}, "unit": {}}})", bare(value), quoted(field.unit));
  }
}

void JsonWriter::quantity(const Quantity& value) {
  separate();
  if (columns_ > 0)
    text_ += bare(value.value);
  else
    text_ += fmt::format(
        R"({{"value": {}, "unit": {}, "relative_uncertainty": {}}})", bare(value.value),
        quoted(value.unit),
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
  text_ += quoted(value);
}

void JsonWriter::nothing() {
  separate();
  text_ += "null";
}

}  // namespace strainwave

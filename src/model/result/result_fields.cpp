// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/result_fields.hpp"

namespace strainwave {

/// Begins a value; in a list, its index completes the path.
void OutputWalk::element() {
  if (levels_.empty() || !levels_.back().list) return;
  Level& list = levels_.back();
  path_ = list.path + '[' + std::to_string(list.next++) + ']';
}

void OutputWalk::begin_record() {
  element();
  levels_.push_back({.path = path_});
}

void OutputWalk::end_record() {
  path_ = levels_.back().path;
  levels_.pop_back();
}

bool OutputWalk::field(const Field& field) {
  if (field.detail) return false;
  path_ = levels_.back().path;
  if (!path_.empty()) path_ += '.';
  path_ += field.name;
  name_ = field.name;
  return true;
}

void OutputWalk::begin_list() {
  element();
  levels_.push_back({.path = path_, .list = true});
}

void OutputWalk::end_list() { end_record(); }

void OutputWalk::begin_column(const Field&) { ++columns_; }

void OutputWalk::end_column() { --columns_; }

void OutputWalk::number(double value, const Field& field) {
  quantity({.value = value, .unit = field.unit});
}

void OutputWalk::quantity(const Quantity& value) {
  if (columns_ > 0) return;
  element();
  read_(path_, value);
}

void OutputWalk::whole(std::int64_t) {}
void OutputWalk::flag(bool) {}
void OutputWalk::text(std::string_view value) {
  if (columns_ > 0) return;
  element();
  const std::size_t depth = levels_.size();
  if (name_ == "path" && depth > 1 && !levels_[depth - 1].list && levels_[depth - 2].list)
    levels_.back().path = value;
}
void OutputWalk::nothing() {}

}  // namespace strainwave

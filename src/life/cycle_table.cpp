// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/cycle_table.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {

void CycleTable::add(double range, double mean, double count) {
  if (!(range > 0) || !(count > 0)) return;
  if (!std::isfinite(range))
    throw InputError("history", "has a range beyond the largest number; scale its values");
  cycles_ += count;
  largest_range_ = std::max(largest_range_, range);
  if (classes_)
    add_to_class(range, mean, count);
  else
    add_exact(range, mean + 0.0, count);
}

void CycleTable::add_exact(double range, double mean, double count) {
  const auto leave_out = [&](double of, double number) {
    left_out_ += number;
    largest_left_out_ = std::max(largest_left_out_, of);
  };
  const Key key(range, mean);
  if (counts_.size() >= most_ && key < counts_.begin()->first) return leave_out(range, count);
  counts_[key] += count;
  if (counts_.size() <= most_) return;
  // What is less than every row never becomes a row again, so the order does not matter.
  const auto least = counts_.begin();
  leave_out(least->first.first, least->second);
  counts_.erase(least);
}

void CycleTable::add_to_class(double range, double mean, double count) {
  const auto classes = static_cast<double>(*classes_);
  if (width_ == 0) {
    width_ = std::exp2(std::ilogb(range / classes));
    first_mean_ = last_mean_ = std::floor(mean / width_);
  }
  for (;; widen()) {
    const double of_range = std::floor(range / width_);  // (LI-23)
    const double of_mean = std::floor(mean / width_);
    const double first = std::min(first_mean_, of_mean);
    const double last = std::max(last_mean_, of_mean);
    if (std::max(of_range, last_range_) >= classes || last - first >= classes) continue;
    first_mean_ = first;
    last_mean_ = last;
    last_range_ = std::max(last_range_, of_range);
    counts_[{of_range, of_mean}] += count;
    return;
  }
}

void CycleTable::widen() {
  const auto half = [](double number) { return std::floor(number / 2); };
  std::map<Key, double> wider;
  for (const auto& [key, count] : counts_) wider[{half(key.first), half(key.second)}] += count;
  counts_ = std::move(wider);
  first_mean_ = half(first_mean_);
  last_mean_ = half(last_mean_);
  last_range_ = half(last_range_);
  width_ *= 2;
}

std::vector<CycleCount> CycleTable::rows() const {
  std::vector<CycleCount> rows;
  rows.reserve(counts_.size());
  const auto middle = [&](double key) { return classes_ ? (key + 0.5) * width_ : key; };
  for (const auto& [key, count] : counts_)
    rows.push_back({.range = middle(key.first), .mean = middle(key.second), .count = count});
  std::ranges::stable_sort(rows, std::ranges::greater(), &CycleCount::range);
  return rows;
}

std::optional<double> CycleTable::class_width() const {
  return classes_ && width_ > 0 ? std::optional(width_) : std::nullopt;
}

}  // namespace strainwave

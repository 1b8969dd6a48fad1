// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/streamed_sample.hpp"

#include <algorithm>
#include <cmath>

namespace strainwave {

void StreamedMoments::add(double value) {
  const auto before = static_cast<double>(count_);
  ++count_;
  const auto n = static_cast<double>(count_);
  const double away = value - mean_;
  const double step = away / n;
  const double square = away * step * before;
  mean_ += step;
  fourth_ +=
      square * step * step * (n * n - 3 * n + 3) + 6 * step * step * second_ - 4 * step * third_;
  third_ += square * step * (n - 2) - 3 * step * second_;
  second_ += square;
}

StreamedQuantile::StreamedQuantile(double p, std::size_t kept) : p_(p), kept_(kept) {}

void StreamedQuantile::narrow() {
  // The rank among the values so far, with six standard errors of the rank among all.
  constexpr double kErrors = 6.0;
  const auto n = static_cast<double>(count_);
  const double margin = kErrors * std::sqrt(n * p_ * (1 - p_)) + 2;
  const auto size = static_cast<double>(inside_.size());
  const double target = std::clamp(p_ * n - static_cast<double>(below_), 0.0, size - 1);
  const double half = std::min(margin, static_cast<double>(kept_) / 4);
  const auto at = [&](double rank) {
    const auto nth = inside_.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(inside_.begin(), nth, inside_.end());
    return *nth;
  };
  const double low = target - half > 0 ? at(std::floor(target - half)) : low_;
  const double high = target + half < size - 1 ? at(std::ceil(target + half)) : high_;
  if (low > low_) {
    low_ = low;
    at_low_ = static_cast<std::size_t>(std::ranges::count(inside_, low));
    below_ += static_cast<std::size_t>(
        std::ranges::count_if(inside_, [&](double value) { return value <= low; }));
  }
  if (high < high_) {
    high_ = high;
    // Equal ends: their values count at the lower one.
    at_high_ = high > low_ ? static_cast<std::size_t>(std::ranges::count(inside_, high)) : 0;
  }
  std::erase_if(inside_, [&](double value) { return value <= low_ || value >= high_; });
}

bool StreamedQuantile::end_of_pass() {
  const double at = p_ * static_cast<double>(count_ - 1);
  const auto first = static_cast<std::size_t>(at);
  std::ranges::sort(inside_);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t rank = std::min(first + i, count_ - 1);
    if (neighbours_[i]) continue;
    if (rank < below_ - at_low_)
      first_high_ = low_;
    else if (rank < below_)
      neighbours_[i] = low_;
    else if (rank < below_ + inside_.size())
      neighbours_[i] = inside_[rank - below_];
    else if (rank < below_ + inside_.size() + at_high_)
      neighbours_[i] = high_;
    else
      first_low_ = high_;
  }
  low_ = first_low_;
  high_ = first_high_;
  count_ = below_ = at_low_ = at_high_ = 0;
  inside_.clear();
  if (!neighbours_[0] || !neighbours_[1]) return false;
  value_ = std::lerp(*neighbours_[0], *neighbours_[1], at - static_cast<double>(first));
  return true;
}

}  // namespace strainwave

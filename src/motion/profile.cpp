// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/profile.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {

double Profile::at(double t) const {
  const auto next = std::ranges::upper_bound(time, t);
  if (next == time.begin()) return value.front();
  if (next == time.end()) return value.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  return value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / (time[i] - time[i - 1]);
}

double Profile::slope(double t) const {
  const auto next = std::ranges::upper_bound(time, t);
  if (next == time.begin() || next == time.end()) return 0.0;
  const auto i = static_cast<std::size_t>(next - time.begin());
  return (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
}

double Profile::integral(double t) const {
  if (time.empty() || t <= time.front()) return value.front() * t;
  double sum = value.front() * time.front();
  for (std::size_t i = 1; i < time.size() && time[i - 1] < t; ++i) {
    const double end = std::min(time[i], t);
    sum += (at(time[i - 1]) + at(end)) / 2 * (end - time[i - 1]);
  }
  return sum + (t > time.back() ? value.back() * (t - time.back()) : 0.0);
}

void require_constants(const Profile& profile, const std::string& name) {
  const FieldPath at{name};
  if (profile.value.empty()) throw InputError(at.text(), "must have at least one value");
  if (profile.time.size() != profile.value.size() &&
      !(profile.time.empty() && profile.value.size() == 1))
    throw InputError(at.text(), "must have as many times as values");
  for (std::size_t i = 0; i < profile.value.size(); ++i)
    require(std::isfinite(profile.value[i]), at[i].text(), profile.value[i], "", "a finite number");
  for (std::size_t i = 0; i < profile.time.size(); ++i)
    require(std::isfinite(profile.time[i]) && (i == 0 || profile.time[i] > profile.time[i - 1]),
            (at / "time")[i].text(), profile.time[i], "s", "later than the time before");
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_laws/tabulated.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace strainwave {
namespace {

double mixed(double low, double high, double share) { return low + share * (high - low); }

}  // namespace

TableOfRates::TableOfRates(const std::vector<RateCurve>& curves) {
  for (const RateCurve& given : curves) {
    if (given.delta_K.size() < 2 || given.rate.size() != given.delta_K.size()) {
      curves_.clear();
      return;
    }
    Curve& made = curves_.emplace_back(
        Curve{.ratio = given.stress_ratio, .first = given.delta_K.front(), .x = {}, .y = {}});
    for (const double range : given.delta_K) made.x.push_back(std::log(range));
    for (const double rate : given.rate) made.y.push_back(std::log(rate));
  }
}

double TableOfRates::Curve::at(double x_wanted) const {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, x_wanted);
  const auto i = static_cast<std::size_t>(above - x.begin());
  return mixed(y[i - 1], y[i], (x_wanted - x[i - 1]) / (x[i] - x[i - 1]));
}

TableOfRates::Between TableOfRates::between(double ratio) const {
  const auto above = std::ranges::upper_bound(curves_, ratio, {}, &Curve::ratio);
  const Curve* const high = &*(above == curves_.end() ? above - 1 : above);
  const Curve* const low = &*(above == curves_.begin() ? above : above - 1);
  if (low == high || ratio == low->ratio) return {low, low, 0.0};
  return {low, high, (ratio - low->ratio) / (high->ratio - low->ratio)};
}

double TableOfRates::rate(const TipCycle& cycle) const {
  if (curves_.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double range = cycle.full_range();
  const auto [low, high, share] = between(cycle.ratio);
  if (low == high) return range > low->first ? std::exp(low->at(std::log(range))) : 0.0;
  // (GR-36): the same position between threshold and last point on either curve.
  const double x = std::log(range);
  const double first = mixed(low->x.front(), high->x.front(), share);
  const double end = mixed(low->x.back(), high->x.back(), share);
  if (!(x > first)) return 0.0;
  const double position = (x - first) / (end - first);
  const auto on = [&](const Curve& curve) {
    return curve.at(mixed(curve.x.front(), curve.x.back(), position));
  };
  return std::exp(mixed(on(*low), on(*high), share));  // (GR-36)
}

double TableOfRates::threshold(double ratio) const {
  if (curves_.empty()) return 0.0;
  const auto [low, high, share] = between(ratio);
  return low == high ? low->first : std::exp(mixed(low->x.front(), high->x.front(), share));
}

double TableOfRates::last(double ratio) const {
  if (curves_.empty()) return 0.0;
  const auto [low, high, share] = between(ratio);
  return std::exp(mixed(low->x.back(), high->x.back(), share));
}

}  // namespace strainwave

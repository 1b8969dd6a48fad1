// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/kinematic_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/multiple_angle.hpp"

namespace strainwave {

namespace {

// A rotation costs about a tenth of a sine and a cosine: a family ends before a longer gap.
constexpr double kLongestGap = 8;       // multiples without a line [-]
constexpr double kWholeWithin = 1e-15;  // of the multiple, whose order is rounded [-]

}  // namespace

KinematicError::KinematicError(std::vector<ErrorOrder> orders) : orders_(std::move(orders)) {
  std::vector<ErrorOrder> rising = orders_;
  std::ranges::stable_sort(rising, {}, &ErrorOrder::order);
  for (const auto& [order, amplitude, phase] : rising) {
    const auto multiple_in = [&, order = order](const Family& family) -> std::size_t {
      const double ratio = order / family.order;
      const double whole = std::round(ratio);
      const bool member = std::abs(ratio - whole) <= kWholeWithin * whole &&
                          whole <= static_cast<double>(family.lines.size()) + kLongestGap;
      return member ? static_cast<std::size_t>(whole) : 0;
    };
    auto family = std::ranges::find_if(families_, multiple_in);
    if (family == families_.end()) family = families_.insert(family, {.order = order});
    const std::size_t multiple = std::max<std::size_t>(multiple_in(*family), 1);
    if (family->lines.size() < multiple) family->lines.resize(multiple);
    family->lines[multiple - 1].sine += amplitude * std::cos(phase);
    family->lines[multiple - 1].cosine += amplitude * std::sin(phase);
  }
}

KinematicError::At KinematicError::at(double input_angle) const {
  At result;
  for (const auto& [order, lines] : families_) {
    MultipleAngle multiple(order * input_angle);
    double slope = 0.0;
    double number = 0.0;
    for (const auto& [sine, cosine] : lines) {
      multiple.next();
      number += 1;
      result.value += sine * multiple.sine() + cosine * multiple.cosine();      // (MO-4)
      slope += number * (sine * multiple.cosine() - cosine * multiple.sine());  // (MO-4)
    }
    result.slope += order * slope;
  }
  return result;
}

double KinematicError::highest_order() const {
  double highest = 0.0;
  for (const ErrorOrder& line : orders_) highest = std::max(highest, line.order);
  return highest;
}

ErrorLines error_lines(const std::vector<double>& values, double turns) {
  using std::numbers::pi;
  require(values.size() >= 3, "error table", static_cast<double>(values.size()), "1",
          "3 values or more");
  require(turns > 0 && std::isfinite(turns), "turns", turns, "1", "> 0");
  ErrorLines made;
  const auto [least, largest] = std::ranges::minmax(values);
  made.range = largest - least;
  if (!(made.range > 0)) return made;
  const std::size_t n = values.size();
  std::vector<std::complex<double>> turn(n);
  for (std::size_t j = 0; j < n; ++j)
    turn[j] = std::polar(1.0, -2 * pi * static_cast<double>(j) / static_cast<double>(n));
  for (std::size_t k = 1; 2 * k <= n; ++k) {
    std::complex<double> sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) sum += values[j] * turn[k * j % n];
    const double share = (2 * k == n ? 1.0 : 2.0) / static_cast<double>(n);
    const ErrorOrder line{.order = static_cast<double>(k) / turns,
                          .amplitude = share * std::abs(sum),
                          .phase = std::remainder(std::arg(sum) + pi / 2, 2 * pi)};  // (MO-56)
    if (line.order <= kLargestOrder) made.orders.push_back(line);
  }
  std::ranges::stable_sort(made.orders, std::greater<>(), &ErrorOrder::amplitude);
  double rest = 0.0;
  std::size_t kept = made.orders.size();
  while (kept > 0 && (kept > kMostErrorLines ||
                      rest + made.orders[kept - 1].amplitude <= kErrorLeftOut * made.range))
    rest += made.orders[--kept].amplitude;
  made.orders.resize(kept);
  const KinematicError lines{made.orders};
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    const double angle = 2 * pi * turns * static_cast<double>(j) / static_cast<double>(n);
    made.left_out = std::max(made.left_out, std::abs(values[j] - mean - lines.at(angle).value));
  }
  return made;
}

void require_constants(const KinematicError& error) {
  const FieldPath at("kinematic_error");
  for (std::size_t i = 0; i < error.orders().size(); ++i) {
    const auto& [order, amplitude, phase] = error.orders()[i];
    require(order > 0 && order <= kLargestOrder, (at[i] / "order").text(), order, "1",
            "> 0 and <= 1000");
    require(amplitude >= 0 && amplitude < kLargestError, (at[i] / "amplitude").text(), amplitude,
            "rad", "from 0 to below 0.5 deg");
    require(std::isfinite(phase), (at[i] / "phase").text(), phase, "rad", "a finite number");
  }
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/order_spectrum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kResolution = 2.0;  // spacing of separate lines, over 1/turns [-]
constexpr int kProbes = 128;         // orders at which the floor is read
constexpr double kAbove = 1.25;      // the highest of them, over the highest line [-]

/// Hann's weight, which lets a line act little on orders that are not beside it.
double weight(double share) { return 0.5 * (1 - std::cos(2 * pi * share)); }

void require_signal(std::span<const double> angle, std::span<const double> signal,
                    std::span<const double> orders) {
  if (angle.size() != signal.size())
    throw InputError("signal", "must have as many values as the angle");
  if (angle.size() < 2 * orders.size() + 4)
    throw InputError("angle", "must have at least four values more than twice the orders");
  const bool rising = angle.back() > angle.front();
  for (std::size_t n = 0; n < angle.size(); ++n) {
    const bool on = n == 0 || (angle[n] != angle[n - 1] && (angle[n] > angle[n - 1]) == rising);
    if (!std::isfinite(angle[n]) || !on)
      throw InputError("angle", "must rise, or fall, from each value to the next");
    if (!std::isfinite(signal[n])) throw InputError("signal", "must have finite values");
  }
  for (const double order : orders)
    require(order > 0 && std::isfinite(order), "order", order, "1", "> 0");
}

}  // namespace

OrderSpectrum order_spectrum(std::span<const double> angle, std::span<const double> signal,
                             std::span<const double> orders) {
  require_signal(angle, signal, orders);
  OrderSpectrum made;
  const double whole = angle.back() - angle.front();
  made.turns = std::abs(whole) / (2 * pi);
  const double spacing = kResolution / made.turns;
  std::vector<double> fitted;
  for (const double order : orders) {
    double nearest = order;  // the distance from order 0, which mean and drift occupy
    for (const double other : fitted) nearest = std::min(nearest, std::abs(order - other));
    OrderLine& line = made.lines.emplace_back(OrderLine{.order = order});
    line.separate = nearest >= spacing * (1 - 1e-12);
    // A line that stands on another one is never separate from it.
    line.turns_needed =
        nearest > 0 ? kResolution / nearest : std::numeric_limits<double>::infinity();
    if (line.separate) fitted.push_back(order);
  }
  // Columns: mean, drift, cosine and sine of each line.
  const auto columns = static_cast<Eigen::Index>(2 + 2 * fitted.size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns);
  Eigen::VectorXd row(columns);
  const auto fill = [&](double at) {
    row[0] = 1.0;
    row[1] = 2 * (at - angle.front()) / whole - 1;
    for (std::size_t k = 0; k < fitted.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(2 + 2 * k);
      row[column] = std::cos(fitted[k] * at);
      row[column + 1] = std::sin(fitted[k] * at);
    }
  };
  std::vector<double> weights(angle.size());
  for (std::size_t n = 0; n < angle.size(); ++n) {
    weights[n] = weight((angle[n] - angle.front()) / whole);
    fill(angle[n]);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(row, weights[n]);
    right += weights[n] * signal[n] * row;
  }
  const Eigen::VectorXd solution =
      Eigen::MatrixXd(gram.selfadjointView<Eigen::Lower>()).ldlt().solve(right);  // (MO-20)
  Eigen::Index column = 2;
  for (OrderLine& line : made.lines) {
    if (!line.separate) continue;
    line.amplitude = std::hypot(solution[column], solution[column + 1]);
    line.phase = std::atan2(solution[column + 1], solution[column]);
    column += 2;
  }
  std::vector<double> rest(angle.size());
  double sum = 0.0;
  for (std::size_t n = 0; n < angle.size(); ++n) {
    fill(angle[n]);
    rest[n] = weights[n] * (signal[n] - row.dot(solution));
    sum += weights[n];
  }
  const double highest = orders.empty() ? 1.0 : *std::ranges::max_element(orders);
  std::vector<double> amplitudes;
  for (int probe = 1; probe <= kProbes; ++probe) {
    const double order = kAbove * highest * probe / kProbes;
    const bool beside = order < spacing || std::ranges::any_of(orders, [&](double named) {
                          return std::abs(order - named) < spacing;
                        });
    if (beside) continue;
    double cosine = 0.0;
    double sine = 0.0;
    for (std::size_t n = 0; n < angle.size(); ++n) {
      cosine += rest[n] * std::cos(order * angle[n]);
      sine += rest[n] * std::sin(order * angle[n]);
    }
    amplitudes.push_back(2 * std::hypot(cosine, sine) / sum);
  }
  if (!amplitudes.empty()) {
    const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
    std::ranges::nth_element(amplitudes, middle);
    made.floor = *middle;
  }
  return made;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/order_spectrum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kResolution = 2.0;   // spacing of separate lines, over 1/turns [-]
constexpr std::size_t kProbes = 128;  // orders at which the floor is read
constexpr double kAbove = 1.25;       // the highest of them, over the highest line [-]

/// Hann's weight, which lets a line act little on orders that are not beside it.
double weight(double share) { return 0.5 * (1 - std::cos(2 * pi * share)); }

constexpr std::size_t kFloorNumbers = std::size_t{2} * kProbes;

/// Places of the single numbers of the sums; the normal equations and the sums at the orders of the
/// floor follow.
enum Place : std::size_t { kCount, kFirstAngle, kLastAngle, kSense, kTurnedBack, kWeight, kHead };

using Matrix = Eigen::Map<Eigen::MatrixXd>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd>;

Eigen::Index index(std::size_t n) { return static_cast<Eigen::Index>(n); }

/// Order of a probe of the floor, over the highest order; n from 0 [-].
double probe_share(std::size_t n) {
  return kAbove * static_cast<double>(n + 1) / static_cast<double>(kProbes);
}

double highest_of(const std::vector<double>& orders) {
  return orders.empty() ? 1.0 : *std::ranges::max_element(orders);
}

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
}

}  // namespace

OrderSums::OrderSums(std::vector<double> orders, std::size_t signals)
    : orders_(std::move(orders)), signals_(signals) {
  for (const double order : orders_)
    require(order > 0 && std::isfinite(order), "order", order, "1", "> 0");
  row_.resize(columns() + signals_);
  probes_.resize(kFloorNumbers);
  numbers_.resize(kHead + columns() * row_.size() + kFloorNumbers * row_.size());
}

void OrderSums::add(double share, double angle, std::span<const double> values) {
  if (numbers_[kCount] == 0) {
    numbers_[kFirstAngle] = angle;
  } else {
    const double sense = angle > numbers_[kLastAngle] ? 1.0 : -1.0;
    if (numbers_[kCount] == 1) numbers_[kSense] = sense;
    if (angle == numbers_[kLastAngle] || sense != numbers_[kSense]) numbers_[kTurnedBack] = 1;
  }
  ++numbers_[kCount];
  numbers_[kLastAngle] = angle;
  const double w = weight(share);
  numbers_[kWeight] += w;
  // The drift counts from the first angle, so that many turns before it do not take digits.
  const double turned = angle - numbers_[kFirstAngle];
  row_[0] = 1.0;
  row_[1] = turned;
  for (std::size_t k = 0; k < orders_.size(); ++k) {
    row_[2 + 2 * k] = std::cos(orders_[k] * angle);
    row_[3 + 2 * k] = std::sin(orders_[k] * angle);
  }
  for (std::size_t n = 0; n < signals_; ++n) row_[columns() + n] = values[n];
  const std::complex<double> turn = std::polar(1.0, probe_share(0) * highest_of(orders_) * turned);
  std::complex<double> probe = w;
  for (std::size_t n = 0; n < kFloorNumbers; n += 2) {
    probe *= turn;
    probes_[n] = probe.real();
    probes_[n + 1] = probe.imag();
  }
  const ConstMatrix row(row_.data(), index(row_.size()), 1);
  const ConstMatrix probes(probes_.data(), index(kFloorNumbers), 1);
  double* const equations = numbers_.data() + kHead;
  Matrix normal(equations, index(columns()), index(row_.size()));
  normal.noalias() += (w * row.topRows(index(columns()))) * row.transpose();
  Matrix floor(equations + columns() * row_.size(), index(kFloorNumbers), index(row_.size()));
  floor.noalias() += probes * row.transpose();
}

double OrderSums::count() const { return numbers_[kCount]; }

bool OrderSums::turns_on() const { return numbers_[kCount] > 0 && numbers_[kTurnedBack] == 0; }

double OrderSums::whole() const { return numbers_[kLastAngle] - numbers_[kFirstAngle]; }

void OrderSums::restore(std::vector<double> numbers) {
  if (numbers.size() != numbers_.size())
    throw InputError("checkpoint", "has other orders than this motion; begin the motion again");
  numbers_ = std::move(numbers);
}

OrderSpectrum OrderSums::spectrum(std::size_t signal) const {
  if (!(count() >= static_cast<double>(columns() + 2)))
    throw InputError("angle", "must have at least four values more than twice the orders");
  if (!turns_on()) throw InputError("angle", "must rise, or fall, from each value to the next");
  OrderSpectrum made;
  made.turns = std::abs(whole()) / (2 * pi);
  const double spacing = kResolution / made.turns;
  std::vector<double> fitted;
  std::vector<Eigen::Index> chosen = {0, 1};  // mean, drift, cosine and sine of each line
  for (std::size_t k = 0; k < orders_.size(); ++k) {
    const double order = orders_[k];
    double nearest = order;  // the distance from order 0, which mean and drift occupy
    for (const double other : fitted) nearest = std::min(nearest, std::abs(order - other));
    OrderLine& line = made.lines.emplace_back(OrderLine{.order = order});
    line.separate = nearest >= spacing * (1 - 1e-12);
    // A line that stands on another one is never separate from it.
    line.turns_needed =
        nearest > 0 ? kResolution / nearest : std::numeric_limits<double>::infinity();
    if (!line.separate) continue;
    fitted.push_back(order);
    chosen.push_back(index(2 + 2 * k));
    chosen.push_back(index(3 + 2 * k));
  }
  const double* const equations = numbers_.data() + kHead;
  const ConstMatrix normal(equations, index(columns()), index(row_.size()));
  const ConstMatrix floor(equations + columns() * row_.size(), index(kFloorNumbers),
                          index(row_.size()));
  const Eigen::Index value = index(columns() + signal);
  const Eigen::MatrixXd gram = normal(chosen, chosen);
  // The drift grows with the turns; columns of one size keep the digits of the solution.
  const Eigen::VectorXd size = gram.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = size.asDiagonal() * gram * size.asDiagonal();
  const Eigen::VectorXd right = size.asDiagonal() * normal.col(value)(chosen);
  const Eigen::VectorXd solution = size.asDiagonal() * scaled.ldlt().solve(right);  // (MO-20)
  Eigen::Index column = 2;
  for (OrderLine& line : made.lines) {
    if (!line.separate) continue;
    line.amplitude = std::hypot(solution[column], solution[column + 1]);
    line.phase = std::atan2(solution[column + 1], solution[column]);
    column += 2;
  }
  const Eigen::VectorXd rest = floor.col(value) - floor(Eigen::all, chosen) * solution;
  std::vector<double> amplitudes;
  for (std::size_t n = 0; n < kProbes; ++n) {
    const double order = probe_share(n) * highest_of(orders_);
    const bool beside = order < spacing || std::ranges::any_of(orders_, [&](double named) {
                          return std::abs(order - named) < spacing;
                        });
    if (!beside)
      amplitudes.push_back(2 * std::hypot(rest[index(2 * n)], rest[index(2 * n + 1)]) /
                           numbers_[kWeight]);
  }
  if (!amplitudes.empty()) {
    const auto middle = amplitudes.begin() + static_cast<std::ptrdiff_t>(amplitudes.size() / 2);
    std::ranges::nth_element(amplitudes, middle);
    made.floor = *middle;
  }
  return made;
}

OrderSpectrum order_spectrum(std::span<const double> angle, std::span<const double> signal,
                             std::span<const double> orders) {
  require_signal(angle, signal, orders);
  OrderSums sums({orders.begin(), orders.end()}, 1);
  for (std::size_t n = 0; n < angle.size(); ++n)
    sums.add(static_cast<double>(n) / static_cast<double>(angle.size() - 1), angle[n],
             signal.subspan(n, 1));
  return sums.spectrum(0);
}

}  // namespace strainwave

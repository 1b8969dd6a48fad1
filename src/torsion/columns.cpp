// SPDX-License-Identifier: Apache-2.0
#include "columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace strainwave {
namespace {

constexpr Eigen::Index kBlock = 8;  // columns that are eliminated together

/// Products of the rows from `first` to `end` of four columns with those of a vector.
std::array<double, 4> products(const std::array<const double*, 4>& column, const double* x,
                               Eigen::Index first, Eigen::Index end) {
  using Pair = Eigen::Array2d;  // the compiler does not reorder a sum of single numbers
  using At = Eigen::Map<const Pair>;
  std::array<Pair, 4> sum = {Pair::Zero(), Pair::Zero(), Pair::Zero(), Pair::Zero()};
  Eigen::Index i = first;
  for (; i + 2 <= end; i += 2) {
    const Pair at = At(x + i);
    for (std::size_t k = 0; k < 4; ++k) sum[k] += At(column[k] + i) * at;
  }
  std::array<double, 4> total{};
  for (std::size_t k = 0; k < 4; ++k) {
    total[k] = sum[k][0] + sum[k][1];
    if (i < end) total[k] += column[k][i] * x[i];
  }
  return total;
}

}  // namespace

bool SmallCholesky::factor(Eigen::MatrixXd matrix) {
  lower_ = std::move(matrix);
  const Eigen::Index n = lower_.rows();
  inverse_.resize(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    double* const column = &lower_(j, j);
    subtract_columns(
        column, n - j, j, [&](Eigen::Index k) { return below(j, k); },
        [&](Eigen::Index k) { return *below(j, k); });
    if (!(column[0] > 0)) return false;
    const double inverse = 1 / std::sqrt(column[0]);
    inverse_[j] = inverse;
    for (Eigen::Index i = 1; i < n - j; ++i) column[i] *= inverse;
  }
  return true;
}

void SmallCholesky::solve(Eigen::VectorXd& right) const {
  const Eigen::Index n = lower_.rows();
  double* const x = right.data();
  for (Eigen::Index first = 0; first < n; first += kBlock) {
    const Eigen::Index end = std::min(first + kBlock, n);
    std::array<const double*, kBlock> column{};
    std::array<double, kBlock> factor{};
    for (Eigen::Index j = first; j < end; ++j) {
      const double* const of = lower_.data() + j * n;
      const double value = x[j] * inverse_[j];
      x[j] = value;
      for (Eigen::Index i = j + 1; i < end; ++i) x[i] -= of[i] * value;
      column[static_cast<std::size_t>(j - first)] = of + end;
      factor[static_cast<std::size_t>(j - first)] = value;
    }
    subtract_columns(
        x + end, n - end, end - first,
        [&](Eigen::Index k) { return column[static_cast<std::size_t>(k)]; },
        [&](Eigen::Index k) { return factor[static_cast<std::size_t>(k)]; });
  }
  for (Eigen::Index end = n; end > 0;) {
    const Eigen::Index first = std::max<Eigen::Index>(end - 4, 0);
    std::array<const double*, 4> column{};
    for (Eigen::Index k = 0; k < 4; ++k)
      column[static_cast<std::size_t>(k)] = lower_.data() + std::min(first + k, end - 1) * n;
    const std::array<double, 4> sum = products(column, x, end, n);
    for (Eigen::Index j = end - 1; j >= first; --j) {
      const double* const of = column[static_cast<std::size_t>(j - first)];
      double value = x[j] - sum[static_cast<std::size_t>(j - first)];
      for (Eigen::Index i = j + 1; i < end; ++i) value -= of[i] * x[i];
      x[j] = value * inverse_[j];
    }
    end = first;
  }
}

}  // namespace strainwave

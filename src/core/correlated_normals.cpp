// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/correlated_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strainwave {

std::optional<CorrelatedNormals> CorrelatedNormals::of(std::size_t size,
                                                       const std::vector<RankCorrelation>& pairs) {
  CorrelatedNormals normals(size);
  if (std::ranges::all_of(pairs, [](const RankCorrelation& pair) { return pair.value == 0; }))
    return normals;
  std::vector<double> matrix(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) matrix[i * size + i] = 1.0;
  for (const RankCorrelation& pair : pairs) {
    const double r = 2 * std::sin(std::numbers::pi * pair.value / 6);  // (UQ-8)
    matrix[pair.first * size + pair.second] = matrix[pair.second * size + pair.first] = r;
  }
  // Cholesky factor.  A pivot is the variance that the earlier variables leave to this one; one of
  // the size of rounding belongs to a matrix that is singular.
  constexpr double kLeastPivot = 1e-12;
  std::vector<double>& factor = normals.factor_;
  factor.assign(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * size + j];
      for (std::size_t k = 0; k < j; ++k) rest -= factor[i * size + k] * factor[j * size + k];
      if (i == j && !(rest > kLeastPivot)) return std::nullopt;
      factor[i * size + j] = i == j ? std::sqrt(rest) : rest / factor[j * size + j];
    }
  return normals;
}

void CorrelatedNormals::correlate(std::span<double> u) const {
  if (independent()) return;
  for (std::size_t i = size_; i-- > 0;) {  // from the end, because z_i needs u_0 ... u_i
    double z = 0.0;
    for (std::size_t j = 0; j <= i; ++j) z += factor(i, j) * u[j];
    u[i] = z;
  }
}

double CorrelatedNormals::correlation(std::size_t i, std::size_t j) const {
  if (independent()) return i == j ? 1.0 : 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k <= std::min(i, j); ++k) sum += factor(i, k) * factor(j, k);
  return sum;
}

std::vector<double> CorrelatedNormals::shares(std::span<const double> slope) const {
  std::vector<double> shares(size_, 0.0);
  double variance = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) shares[i] += slope[i] * correlation(i, j) * slope[j];
    variance += shares[i];
  }
  for (double& share : shares) share /= variance;  // (UQ-9)
  return shares;
}

std::vector<double> CorrelatedNormals::slope_in_z(std::span<const double> slope) const {
  std::vector<double> result(slope.begin(), slope.end());
  if (independent()) return result;
  for (std::size_t i = size_; i-- > 0;) {
    for (std::size_t j = i + 1; j < size_; ++j) result[i] -= factor(j, i) * result[j];
    result[i] /= factor(i, i);
  }
  return result;
}

std::vector<std::vector<std::size_t>> CorrelatedNormals::groups() const {
  std::vector<std::size_t> first(size_);  // smallest index of the group of each variable
  for (std::size_t i = 0; i < size_; ++i) first[i] = i;
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      // Each pair that depends on each other joins two groups.
      if (correlation(i, j) == 0 || first[i] == first[j]) continue;
      const auto [low, high] = std::minmax(first[i], first[j]);
      std::ranges::replace(first, std::size_t{high}, std::size_t{low});
    }
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < size_; ++i) {
    std::vector<std::size_t> members;
    for (std::size_t j = i; j < size_; ++j)
      if (first[j] == i) members.push_back(j);
    if (!members.empty()) groups.push_back(std::move(members));
  }
  return groups;
}

}  // namespace strainwave

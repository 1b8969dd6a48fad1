// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace strainwave {

/// Rank correlation of two variables of a vector.
struct RankCorrelation {
  std::size_t first = 0;   ///< index of one variable
  std::size_t second = 0;  ///< index of the other
  double value = 0.0;      ///< Spearman's rho [-]; in (-1, 1)
};

/// Standard normal variables z with correlations, made from independent ones u.
///
/// Implements theory manual eq. (UQ-8): z = L u, and L L^T is the matrix of the correlations.
class CorrelatedNormals {
 public:
  /// @param size   number of variables
  /// @param pairs  each pair once; other pairs are independent
  /// @return  absent if the matrix of the correlations is not positive definite
  [[nodiscard]] static std::optional<CorrelatedNormals> of(
      std::size_t size, const std::vector<RankCorrelation>& pairs);

  /// Number of variables.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Whether all variables are independent, so that z = u.
  [[nodiscard]] bool independent() const { return factor_.empty(); }
  /// Replaces u by z = L u.  @param u  shape (size)
  void correlate(std::span<double> u) const;
  /// Correlation of two standard normal variables [-], 2 sin(pi rho/6) for the rank correlation
  /// rho.
  [[nodiscard]] double correlation(std::size_t i, std::size_t j) const;
  /// Shares of the variables in the variance of a linear function a.z, which sum to one; eq.
  /// (UQ-9).
  /// @param slope  a, shape (size); not 0
  [[nodiscard]] std::vector<double> shares(std::span<const double> slope) const;
  /// Slope in z of a function whose slope in u is known, L^-T a.  @param slope  shape (size)
  [[nodiscard]] std::vector<double> slope_in_z(std::span<const double> slope) const;
  /// Sets of variables that depend on each other, and on no other variable, by their first index.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groups() const;

 private:
  explicit CorrelatedNormals(std::size_t size) : size_(size) {}
  [[nodiscard]] double factor(std::size_t i, std::size_t j) const { return factor_[i * size_ + j]; }

  std::size_t size_;
  std::vector<double> factor_;  ///< L, lower triangle, shape (size, size); empty: the unit matrix
};

}  // namespace strainwave

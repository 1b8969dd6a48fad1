// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/group_response.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dislocations.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Calls f(index, crack) for each crack that is near one of a group: the others and their
/// neighbours of the row, and the crack's own neighbours.
template <class F>
void for_each_near(std::span<const StraightCrack> cracks, std::size_t of,
                   const std::optional<double>& period, const F& f) {
  for (std::size_t j = 0; j < cracks.size(); ++j) {
    if (!period) {
      if (j != of) f(j, cracks[j]);
      continue;
    }
    // The nearest neighbours of the row on both sides, whatever multiples of the period lie between
    // the centres.
    const double apart = cracks[of].centre.real() - cracks[j].centre.real();
    const double turns = std::round(apart / *period);
    const double reach = (cracks[of].half_length + cracks[j].half_length) / *period;
    const int images = 1 + static_cast<int>(std::ceil(reach));
    for (int k = -images; k <= images; ++k) {
      if (j == of && k == 0) continue;
      StraightCrack moved = cracks[j];
      moved.centre += (turns + k) * *period;
      f(j, moved);
    }
  }
}

/// Number of points on a crack for which the error of the quadrature is negligible.
int points_on(std::span<const StraightCrack> cracks, std::size_t of,
              const std::optional<double>& period) {
  constexpr double kDigits = 10.0;
  constexpr int kMost = 160;
  constexpr int kLeast = 8;
  // On the crack from -1 to 1, the stress of another one has its poles at the places of the other
  // one, and its series falls by the powers of the ellipse through the nearest pole.
  double ellipse = std::numeric_limits<double>::infinity();
  const Complex turned = std::exp(-kI * cracks[of].angle) / cracks[of].half_length;
  for_each_near(cracks, of, period, [&](std::size_t, const StraightCrack& other) {
    constexpr int kPlaces = 32;
    for (int i = -kPlaces; i <= kPlaces; ++i) {
      const Complex at =
          other.centre + std::exp(kI * other.angle) * (other.half_length * i / kPlaces);
      const Complex u = (at - cracks[of].centre) * turned;
      const double pole = std::abs(u + std::sqrt(u * u - 1.0));
      ellipse = std::min(ellipse, std::max(pole, 1 / pole));
    }
  });
  if (std::isinf(ellipse)) return kLeast;
  const double points = kDigits * std::log(10.0) / std::log(ellipse);
  return std::clamp(static_cast<int>(std::min(points, double{kMost})) + kLeast, kLeast, kMost);
}

/// The system of a group with given faces.
class System {
 public:
  System(std::span<const FacedCrack> cracks, std::span<const int> points,
         const std::optional<double>& period)
      : cracks_(cracks), period_(period) {
    Eigen::Index first = 0;
    for (std::size_t j = 0; j < cracks.size(); ++j) {
      points_.emplace_back(points[j]);
      turn_.push_back(std::exp(kI * cracks[j].crack.angle));
      first_.push_back(first);
      first += (cracks[j].closed ? 1 : 2) * n(j);
    }
    size_ = first;
    factor();
  }

  [[nodiscard]] std::vector<CrackResponse> response(const SheetStress& stress) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size_);
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      const Tractions t = tractions_of(stress, cracks_[i].crack.angle);
      if (!cracks_[i].closed) right.segment(first_[i], n(i) - 1).setConstant(-t.normal);
      right.segment(shear_of(i), n(i) - 1).setConstant(-t.shear);
    }
    const Eigen::VectorXd densities = factored_.solve(right);
    std::vector<CrackResponse> result;
    for (std::size_t j = 0; j < cracks_.size(); ++j) {
      const Eigen::VectorXd shear = densities.segment(shear_of(j), n(j));
      const double root = 2 * pi * std::sqrt(pi * cracks_[j].crack.half_length);
      CrackResponse& of = result.emplace_back();
      // (CG-5)
      of.ahead.mode_2 = root * at_end(shear);
      of.behind.mode_2 = -root * at_end(shear.reverse());
      of.sliding = jump(j, shear);
      of.slid = along(j, shear);
      if (cracks_[j].closed) {
        of.faces = pull(j, stress, densities);
        continue;
      }
      const Eigen::VectorXd normal = densities.segment(first_[j], n(j));
      of.ahead.mode_1 = root * at_end(normal);
      of.behind.mode_1 = -root * at_end(normal.reverse());
      of.opening = jump(j, normal);
      of.faces = along(j, normal);
    }
    return result;
  }

 private:
  /// Number of points on a crack.
  [[nodiscard]] Eigen::Index n(std::size_t j) const { return points_[j].density.size(); }
  /// First unknown of a crack's shear; those of its normal part come before, unless it is closed.
  [[nodiscard]] Eigen::Index shear_of(std::size_t j) const {
    return first_[j] + (cracks_[j].closed ? 0 : n(j));
  }
  [[nodiscard]] Complex place(std::size_t j, double s) const {
    return cracks_[j].crack.centre + s * cracks_[j].crack.half_length * turn_[j];
  }
  [[nodiscard]] double weight(std::size_t j) const {
    return pi / static_cast<double>(n(j)) * cracks_[j].crack.half_length;
  }
  [[nodiscard]] Influence influence(std::size_t on, std::size_t by, const Complex& w) const {
    return influence_of(turn_[on], turn_[by], w, sums_of(w, period_));
  }

  /// Makes and factors the matrix of (CG-3).  The last equation of each part of a crack closes the
  /// crack at its ends.
  void factor() {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size_, size_);
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      for (Eigen::Index r = 0; r + 1 < n(i); ++r) {
        const Complex here = place(i, points_[i].force[r]);
        for (std::size_t j = 0; j < cracks_.size(); ++j)
          for (Eigen::Index k = 0; k < n(j); ++k) {
            const Influence at = influence(i, j, here - place(j, points_[j].density[k]));
            matrix(shear_of(i) + r, shear_of(j) + k) = weight(j) * at.of_shear.imag();
            if (!cracks_[j].closed)
              matrix(shear_of(i) + r, first_[j] + k) = weight(j) * at.of_normal.imag();
            if (cracks_[i].closed) continue;
            matrix(first_[i] + r, shear_of(j) + k) = weight(j) * at.of_shear.real();
            if (!cracks_[j].closed)
              matrix(first_[i] + r, first_[j] + k) = weight(j) * at.of_normal.real();
          }
      }
      matrix.block(shear_of(i) + n(i) - 1, shear_of(i), 1, n(i)).setOnes();
      if (!cracks_[i].closed) matrix.block(first_[i] + n(i) - 1, first_[i], 1, n(i)).setOnes();
    }
    factored_.compute(matrix);
  }

  /// E' times the integral of the jump of a density (CG-6).
  [[nodiscard]] double jump(std::size_t j, const Eigen::VectorXd& density) const {
    return 8 * pi * cracks_[j].crack.half_length * weight(j) * points_[j].density.dot(density);
  }

  /// E' times the jump of a density at the points where the tractions are given.
  [[nodiscard]] std::vector<double> along(std::size_t j, const Eigen::VectorXd& density) const {
    const auto count = static_cast<int>(n(j));
    // The density is a series of T_m(s)/sqrt(1 - s^2), whose integral from s to 1 is sin(m phi)/m
    // at s = cos(phi).
    std::vector<double> terms(static_cast<std::size_t>(count), 0.0);
    for (int m = 1; m < count; ++m)
      for (int k = 0; k < count; ++k)
        terms[static_cast<std::size_t>(m)] +=
            2.0 / count * density[k] * std::cos(m * (2 * k + 1) * pi / (2 * count));
    std::vector<double> result;
    for (int r = 1; r < count; ++r) {
      double sum = 0.0;
      for (int m = 1; m < count; ++m)
        sum += terms[static_cast<std::size_t>(m)] * std::sin(m * r * pi / count) / m;
      result.push_back(8 * pi * cracks_[j].crack.half_length * sum);
    }
    return result;
  }

  /// Normal stress on the faces of a closed crack; > 0 pulls.
  [[nodiscard]] std::vector<double> pull(std::size_t i, const SheetStress& stress,
                                         const Eigen::VectorXd& densities) const {
    std::vector<double> result;
    for (Eigen::Index r = 0; r + 1 < n(i); ++r) {
      const Complex here = place(i, points_[i].force[r]);
      double sum = tractions_of(stress, cracks_[i].crack.angle).normal;
      for (std::size_t j = 0; j < cracks_.size(); ++j)
        for (Eigen::Index k = 0; k < n(j); ++k) {
          const Influence at = influence(i, j, here - place(j, points_[j].density[k]));
          sum += weight(j) * at.of_shear.real() * densities[shear_of(j) + k];
          if (!cracks_[j].closed) sum += weight(j) * at.of_normal.real() * densities[first_[j] + k];
        }
      result.push_back(sum);
    }
    return result;
  }

  std::span<const FacedCrack> cracks_;
  std::optional<double> period_;
  std::vector<Points> points_;
  std::vector<Complex> turn_;        ///< exp(i angle) of each crack
  std::vector<Eigen::Index> first_;  ///< first unknown of each crack
  Eigen::Index size_ = 0;
  Eigen::PartialPivLU<Eigen::MatrixXd> factored_;
};

}  // namespace

NearestCrack nearest_crack(std::span<const StraightCrack> cracks, std::size_t of,
                           const std::optional<double>& period) {
  NearestCrack nearest{.gap = std::numeric_limits<double>::infinity(), .index = of};
  for_each_near(cracks, of, period, [&](std::size_t j, const StraightCrack& other) {
    const double gap =
        distance(cracks[of], other) / std::max(cracks[of].half_length, other.half_length);
    if (gap < nearest.gap) nearest = {.gap = gap, .index = j};
  });
  return nearest;
}

std::vector<int> response_points(std::span<const StraightCrack> cracks,
                                 const std::optional<double>& period) {
  std::vector<int> points;
  for (std::size_t j = 0; j < cracks.size(); ++j) points.push_back(points_on(cracks, j, period));
  return points;
}

std::vector<std::vector<CrackResponse>> group_response(std::span<const FacedCrack> cracks,
                                                       std::span<const SheetStress> stresses,
                                                       const ResponseOptions& options) {
  if (cracks.size() > kMostGroupedCracks)
    throw InputError("cracks", fmt::format("must be at most {}", kMostGroupedCracks));
  if (cracks.empty()) return std::vector<std::vector<CrackResponse>>(stresses.size());
  std::vector<StraightCrack> places;
  for (const FacedCrack& of : cracks) places.push_back(of.crack);
  if (const auto touching = touching_cracks(places, options.period)) {
    const auto [j, i] = *touching;
    throw InputError("cracks", i == j ? fmt::format("crack {} touches the next one of its row", i)
                                      : fmt::format("cracks {} and {} cross or touch", j, i));
  }
  constexpr int kLeast = 4;
  const std::vector<int> points =
      options.points.empty() ? response_points(places, options.period) : options.points;
  if (points.size() != cracks.size() || std::ranges::min(points) < kLeast)
    throw InputError("points",
                     fmt::format("must be a number of at least {} of each crack", kLeast));
  const System system(cracks, points, options.period);
  std::vector<std::vector<CrackResponse>> result;
  for (const SheetStress& stress : stresses) result.push_back(system.response(stress));
  return result;
}

}  // namespace strainwave

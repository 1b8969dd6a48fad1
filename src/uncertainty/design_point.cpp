// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/design_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

using Vector = Eigen::VectorXd;

std::span<const double> span_of(const Vector& z) {
  return {z.data(), static_cast<std::size_t>(z.size())};
}

/// Gradient by central differences; one-sided where a side has no value; empty if both lack one.
std::optional<Vector> gradient(const LimitState& margin, const Vector& z, double value) {
  constexpr double kStep = 1e-3;
  Vector slope(z.size());
  Vector moved = z;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    moved[i] = z[i] + kStep;
    const auto above = margin(span_of(moved));
    moved[i] = z[i] - kStep;
    const auto below = margin(span_of(moved));
    moved[i] = z[i];
    if (!above && !below) return std::nullopt;
    slope[i] = above && below ? (*above - *below) / (2 * kStep)
               : above        ? (*above - value) / kStep
                              : (value - *below) / kStep;
  }
  return slope;
}

}  // namespace

double DesignPoint::probability() const { return normal_probability(-reliability_index); }

DesignPoint find_design_point(const LimitState& margin, std::vector<double> start) {
  constexpr int kMostIterations = 100;
  constexpr double kOnLimit = 1e-8;   // margin, as a share of the slope
  constexpr double kParallel = 1e-5;  // distance from the normal through the origin
  DesignPoint point;
  const std::vector<double> origin(start.size(), 0.0);
  const std::optional<double> at_origin = margin(origin);
  Vector z = Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()));
  std::optional<double> value = margin(span_of(z));
  if (!at_origin || !value) {
    point.reason = "the output has no value where the search starts";
    return point;
  }
  const auto give_up = [&](std::string reason) {
    point.reason = std::move(reason);
    return point;
  };
  double penalty = 0.0;
  while (point.iterations < kMostIterations) {
    ++point.iterations;
    const std::optional<Vector> slope = gradient(margin, z, *value);
    if (!slope) return give_up("the output has no value on either side of a place of the search");
    const double size = slope->norm();
    if (!(size > 0)) return give_up("the output does not depend on the scattering inputs");
    const Vector normal = -*slope / size;
    const Vector onto = (z.dot(normal) + *value / size) * normal;  // (UQ-4)
    Vector step = onto - z;
    if (std::abs(*value) / size < kOnLimit && (z - z.dot(normal) * normal).norm() < kParallel) {
      point.converged = true;
      point.reliability_index = (*at_origin < 0 ? -1 : 1) * z.norm();
      point.place.assign(z.begin(), z.end());
      point.normal.assign(normal.begin(), normal.end());
      point.slope = size;
      return point;
    }
    if (onto.norm() > 2 * kFarthestFailure) step *= 2 * kFarthestFailure / onto.norm();
    // The merit of Zhang and Der Kiureghian falls along the step for a penalty beyond |z|/|slope|.
    penalty = std::max(penalty, 2 * std::max(z.norm(), 1.0) / size);
    const double merit = z.squaredNorm() / 2 + penalty * std::abs(*value);
    // Rate at which the merit falls along the step.  A step must achieve a quarter of it, because
    // full steps on a curved limit would reach about the same merit on the other side of the point.
    const double rate = -(z + (*value < 0 ? -penalty : penalty) * *slope).dot(step);
    double share = 1.0;
    for (;; share /= 2) {
      if (share < 1e-6) return give_up("the search stalls; the limit has a kink or a step there");
      const Vector next = z + share * step;
      const std::optional<double> there = margin(span_of(next));
      if (there && next.squaredNorm() / 2 + penalty * std::abs(*there) <
                       merit - 0.25 * share * rate + 1e-14) {
        z = next;
        value = there;
        break;
      }
    }
    if (z.norm() > kFarthestFailure)
      return give_up(*at_origin < 0
                         ? "no drive that meets the requirement is nearer than 8 standard "
                           "deviations of the inputs"
                         : "no failure is nearer than 8 standard deviations of the "
                           "inputs");
  }
  return give_up("the search does not converge in 100 steps");
}

CurvedLimit curved_limit(const LimitState& margin, const DesignPoint& at) {
  constexpr double kStep = 1e-2;
  const auto n = static_cast<Eigen::Index>(at.place.size());
  CurvedLimit limit;
  if (n == 1) {
    limit.probability = at.probability();
    return limit;
  }
  const Vector z = Eigen::Map<const Vector>(at.place.data(), n);
  const Vector normal = Eigen::Map<const Vector>(at.normal.data(), n);
  // Orthonormal directions in the limit: all columns but the first of a rotation whose first
  // column is the normal.
  const Eigen::MatrixXd rotation = Eigen::HouseholderQR<Eigen::MatrixXd>(normal).householderQ();
  const auto tangents = rotation.rightCols(n - 1);
  const auto value = [&](const Vector& place) { return margin(span_of(place)); };
  const auto without = [&] {
    limit.reason = "the output has no value beside the design point";
    return limit;
  };
  const std::optional<double> here = value(z);
  if (!here) return without();
  Eigen::MatrixXd bent(n - 1, n - 1);
  for (Eigen::Index i = 0; i + 1 < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const Vector di = kStep * tangents.col(i);
      const Vector dj = kStep * tangents.col(j);
      const auto at_step = [&](double a, double b) { return value(z + a * di + b * dj); };
      double second = 0.0;
      if (i == j) {
        const auto above = at_step(1, 0);
        const auto below = at_step(-1, 0);
        if (!above || !below) return without();
        second = (*above - 2 * *here + *below) / (kStep * kStep);
      } else {
        const auto pp = at_step(1, 1);
        const auto pm = at_step(1, -1);
        const auto mp = at_step(-1, 1);
        const auto mm = at_step(-1, -1);
        if (!pp || !pm || !mp || !mm) return without();
        second = (*pp - *pm - *mp + *mm) / (4 * kStep * kStep);
      }
      bent(i, j) = bent(j, i) = second / at.slope;
    }
  const Vector curvatures = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(bent).eigenvalues();
  limit.curvatures.assign(curvatures.begin(), curvatures.end());
  // A drive that fails has the design point on the side of those that meet the requirement, which
  // are then the rare ones.
  const double side = at.reliability_index < 0 ? -1.0 : 1.0;
  const double beta = std::abs(at.reliability_index);
  const double tail = normal_probability(-beta);
  const double hazard = normal_density(beta) / tail;
  double factor = 1.0;
  for (const double curvature : limit.curvatures) {
    const double term = 1 + hazard * side * curvature;
    if (!(term > 0)) {
      limit.reason = "the limit bends round the origin more than a sphere through the design point";
      return limit;
    }
    factor /= std::sqrt(term);  // (UQ-5)
  }
  limit.probability = side > 0 ? tail * factor : 1 - tail * factor;
  return limit;
}

}  // namespace strainwave

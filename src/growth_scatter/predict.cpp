// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_scatter/predict.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "step_filter.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// What is known of a specimen: rates at the knots, z0, z1, and the correlated part.
struct SpecimenState {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

Eigen::VectorXd step_weights(const GrowthFit& fit, double log_range) {
  const ScatterParameters& p = fit.parameters;
  const std::vector<double> w = fit.mean.weights(log_range);
  const double x = log_range - fit.mean.pivot;
  Eigen::VectorXd h(static_cast<Eigen::Index>(w.size()) + 3);
  h << Eigen::Map<const Eigen::VectorXd>(w.data(), static_cast<Eigen::Index>(w.size())),
      p.level + p.tilt * x, p.slope * x, 1.0;
  return h;
}

SpecimenState before_any_step(const GrowthFit& fit) {
  const auto knots = static_cast<Eigen::Index>(fit.mean.rates.size());
  SpecimenState state{Eigen::VectorXd::Zero(knots + 3),
                      Eigen::MatrixXd::Zero(knots + 3, knots + 3)};
  state.mean.head(knots) = Eigen::Map<const Eigen::VectorXd>(fit.mean.rates.data(), knots);
  state.covariance.topLeftCorner(knots, knots) =
      Eigen::Map<const Eigen::MatrixXd>(fit.rate_covariance.data(), knots, knots);
  state.covariance(knots, knots) = 1.0;
  state.covariance(knots + 1, knots + 1) = 1.0;
  state.covariance(knots + 2, knots + 2) = fit.parameters.wander * fit.parameters.wander;
  return state;
}

/// Carries the correlated part over a change of ln a.
void carry(SpecimenState& state, const ScatterParameters& p, double change) {
  const double phi = remembered(change, p.log_length);
  const Eigen::Index last = state.mean.size() - 1;
  state.mean[last] *= phi;
  state.covariance.row(last) *= phi;
  state.covariance.col(last) *= phi;
  state.covariance(last, last) += p.wander * p.wander * (1 - phi * phi);
}

/// Takes a measured step into account, (GS-6).
void learn(SpecimenState& state, const Eigen::VectorXd& h, double variance, double measured) {
  const Eigen::VectorXd Ph = state.covariance * h;
  const double total = h.dot(Ph) + variance;
  state.mean += Ph * ((measured - h.dot(state.mean)) / total);
  state.covariance -= Ph * (Ph.transpose() / total);
}

/// A matrix whose product with its transpose is a covariance that may be singular.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(covariance);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

GrowthDraws::GrowthDraws(std::size_t draws, std::size_t steps, std::uint64_t seed)
    : draws_(draws), steps_(steps), numbers_((kState + 2 * steps) * draws) {
  for (std::size_t input = 0; input < kState + 2 * steps; ++input)
    for (std::size_t draw = 0; draw < draws; ++draw)
      numbers_[input * draws + draw] = counter_normal(seed, draw, input);
}

std::vector<std::vector<double>> draw_growth(const GrowthFit& fit, const GrowthSpecimen& specimen,
                                             std::optional<double> known, double from,
                                             const std::vector<double>& sizes,
                                             const GrowthDraws& draws) {
  const ScatterParameters& p = fit.parameters;
  const std::vector<double>& a = specimen.sizes;
  if (!(from >= a.front() && from < a.back()))
    throw InputError(specimen.name,
                     fmt::format("has no crack of {:.6g} mm in its record", 1e3 * from));
  if (specimen.steps() > draws.steps())
    throw InputError(specimen.name, fmt::format("has {} steps, and numbers were drawn for {}",
                                                specimen.steps(), draws.steps()));
  const auto middle = [&](std::size_t i) { return std::log(std::midpoint(a[i], a[i + 1])); };
  SpecimenState state = before_any_step(fit);
  std::size_t i = 0;
  const auto go_to_step = [&](std::size_t next) {
    if (next > 0) carry(state, p, middle(next) - middle(next - 1));
  };
  for (; known && i < specimen.steps() && a[i + 1] <= *known * (1 + 1e-9); ++i) {
    go_to_step(i);
    learn(state, step_weights(fit, log_range(specimen, i)),
          white_variance(p.white, a[i + 1] - a[i]), log_rate(specimen, i));
  }
  // Steps before the first counted one, unknown: the correlated part is carried over them.
  for (; i + 1 < specimen.steps() && a[i + 1] <= from; ++i) go_to_step(i);
  if (i == specimen.steps())
    throw InputError(specimen.name, "is known to its end; leave something to predict");
  go_to_step(i);

  const Eigen::MatrixXd root = root_of(state.covariance);
  const Eigen::Index size = state.mean.size();
  const std::size_t n = draws.draws();
  // Of each draw: the rate without the correlated part is linear in the first components.
  Eigen::MatrixXd drawn(size, static_cast<Eigen::Index>(n));
  for (Eigen::Index r = 0; r < size; ++r) {
    const std::span<const double> z = draws.input(static_cast<std::size_t>(r));
    drawn.row(r) = Eigen::Map<const Eigen::RowVectorXd>(z.data(), static_cast<Eigen::Index>(n));
  }
  drawn = (root * drawn).colwise() + state.mean;

  std::vector<std::vector<double>> result(sizes.size());
  Eigen::ArrayXd count = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(n));
  const auto numbers = [&](std::size_t input) {
    return Eigen::Map<const Eigen::ArrayXd>(draws.input(input).data(),
                                            static_cast<Eigen::Index>(n));
  };
  for (const std::size_t first = i; i < specimen.steps(); ++i) {
    const Eigen::Index last = size - 1;
    if (i > first) {
      const double phi = remembered(middle(i) - middle(i - 1), p.log_length);
      drawn.row(last) =
          phi * drawn.row(last).array() +
          p.wander * std::sqrt(1 - phi * phi) * numbers(GrowthDraws::kState + 2 * i).transpose();
    }
    const double length = a[i + 1] - a[i];
    const Eigen::ArrayXd rate =
        (step_weights(fit, log_range(specimen, i)).transpose() * drawn).transpose().array() +
        std::sqrt(white_variance(p.white, length)) * numbers(GrowthDraws::kState + 2 * i + 1);
    const Eigen::ArrayXd cycles = length * (-rate).exp();  // (GS-10)
    const double begin = std::max(from, a[i]);
    for (std::size_t s = 0; s < sizes.size(); ++s)
      if (sizes[s] >= begin &&
          (sizes[s] < a[i + 1] || (sizes[s] == a[i + 1] && i + 1 == specimen.steps()))) {
        const Eigen::ArrayXd until = count + cycles * ((sizes[s] - begin) / length);
        result[s].assign(until.begin(), until.end());
      }
    count += cycles * ((a[i + 1] - begin) / length);
  }
  return result;
}

}  // namespace strainwave

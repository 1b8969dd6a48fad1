// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_scatter/fit.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kCount = ScatterParameters::kCount;
using Values = std::array<double, kCount>;

/// Share of the largest curvature below which the likelihood counts as flat.
constexpr double kNoCurvature = 1e-9;

/// The search for the parameters that act, for one set of knots.
class Search {
 public:
  Search(const GrowthData& data, const MeanGrowth& mean, const ScatterParts& parts)
      : data_(data), mean_(mean) {
    const auto acting = parts.acting();
    for (std::size_t k = 0; k < kCount; ++k)
      if (acting[k]) acting_.push_back(k);
  }

  struct Found {
    Values values{};
    double likelihood = 0.0;
    Eigen::MatrixXd curvature;  ///< of minus the likelihood over the parameters that act
    bool converged = false;
  };

  /// Newton's method from a start; the curvature is that of differences of exact slopes.  It ends
  /// where the likelihood is flat to the first order and does not bend upwards anywhere.
  [[nodiscard]] Found from(const Values& start, const Progress& progress) const {
    constexpr int kMostSteps = 60;
    constexpr double kDecrement = 1e-8;  // of the likelihood; parameters are then right to 1e-4 sd
    constexpr double kSaddle = 1e-4;     // of the largest curvature; the differences err by less
    Found found{.values = start, .likelihood = value(start), .curvature = {}};
    for (int step_number = 0; step_number < kMostSteps; ++step_number) {
      progress.at(static_cast<double>(step_number) / kMostSteps);
      const Eigen::VectorXd slope = slope_at(found.values);
      found.curvature = curvature_at(found.values);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(found.curvature);
      // A direction of wrong or no curvature gets a safe one, so that the step leads uphill.
      const double largest = axes.eigenvalues().cwiseAbs().maxCoeff();
      const Eigen::VectorXd curvatures =
          axes.eigenvalues().cwiseAbs().cwiseMax(kNoCurvature * largest);
      Eigen::VectorXd step =
          axes.eigenvectors() * (axes.eigenvectors().transpose() * slope).cwiseQuotient(curvatures);
      if (slope.dot(step) < kDecrement) {
        if (axes.eigenvalues()[0] > -kSaddle * largest) {
          found.converged = true;
          return found;
        }
        // A saddle, such as a deviation of 0: both senses lead uphill.
        step = axes.eigenvectors().col(0);
      }
      // Deviations are of the size 0.1, a logarithm of the size 1.
      double longest = 0.0;
      for (std::size_t k = 0; k < acting_.size(); ++k)
        longest = std::max(longest, std::abs(step[index(k)]) / (acting_[k] == 4 ? 1.0 : 0.2));
      if (longest > 1) step /= longest;
      if (!climb(found, step, std::max(0.0, slope.dot(step)))) return found;
    }
    return found;
  }

 private:
  static Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

  [[nodiscard]] double value(const Values& v) const {
    return data_.likelihood(mean_, ScatterParameters::of(v)).value;
  }
  [[nodiscard]] Eigen::VectorXd slope_at(const Values& v) const {
    const Values all = data_.slope(mean_, ScatterParameters::of(v));
    Eigen::VectorXd slope(index(acting_.size()));
    for (std::size_t k = 0; k < acting_.size(); ++k) slope[index(k)] = all[acting_[k]];
    return slope;
  }
  [[nodiscard]] Eigen::MatrixXd curvature_at(const Values& v) const {
    const Eigen::Index n = index(acting_.size());
    Eigen::MatrixXd curvature(n, n);
    for (std::size_t k = 0; k < acting_.size(); ++k) {
      constexpr double kStep = 1e-5;
      Values low = v;
      Values high = v;
      low[acting_[k]] -= kStep;
      high[acting_[k]] += kStep;
      curvature.col(index(k)) = (slope_at(low) - slope_at(high)) / (2 * kStep);
    }
    return (curvature + curvature.transpose()) / 2;
  }
  /// Shortens the step until the likelihood rises enough; returns whether it does.
  bool climb(Found& found, Eigen::VectorXd step, double promised) const {
    constexpr double kShare = 1e-4;  // of the promised gain, Armijo's rule
    for (double length = 1.0; length > 1e-6; length /= 2) {
      Values next = found.values;
      for (std::size_t k = 0; k < acting_.size(); ++k) next[acting_[k]] += length * step[index(k)];
      // Beyond these limits the correlated part is another white or level part.
      next[4] = std::clamp(next[4], -9.0, 4.0);
      double reached = 0.0;
      try {
        reached = value(next);
      } catch (const SolverError&) {
        continue;
      }
      if (reached > found.likelihood + kShare * length * promised) {
        found.values = next;
        found.likelihood = reached;
        return true;
      }
    }
    return false;
  }

  const GrowthData& data_;
  const MeanGrowth& mean_;
  std::vector<std::size_t> acting_;
};

/// Turns the signs so that deviations are positive.
Values normalised(Values v) {
  if (v[0] < 0) {
    v[0] = -v[0];
    v[1] = -v[1];
  }
  for (const std::size_t k : {std::size_t{2}, std::size_t{3}, std::size_t{5}})
    v[k] = std::abs(v[k]);
  return v;
}

MeanGrowth knots_over(const GrowthData& data, int number) {
  MeanGrowth mean;
  for (int k = 0; k < number; ++k)
    mean.knots.push_back(
        std::lerp(data.lowest(), data.highest(), static_cast<double>(k) / (number - 1)));
  mean.pivot = std::midpoint(data.lowest(), data.highest());
  return mean;
}

std::vector<Values> starts_for(const std::vector<GrowthSpecimen>& specimens,
                               const GrowthFitSettings& settings) {
  const auto acting = settings.parts.acting();
  const auto only_acting = [&](Values v) {
    for (std::size_t k = 0; k < kCount; ++k)
      if (!acting[k] && k != 4) v[k] = 0.0;
    return v;
  };
  if (settings.start) return {only_acting(settings.start->values())};
  const double deviation = std::max(pooled_line(specimens).deviation, 1e-6);
  double length = 0.0;
  double steps = 0.0;
  for (const GrowthSpecimen& s : specimens) {
    length += s.sizes.back() - s.sizes.front();
    steps += static_cast<double>(s.steps());
  }
  const double white = 0.7 * deviation * std::sqrt(length / steps / kWhiteStep);
  std::vector<Values> starts;
  for (const double log_length : {-3.5, -2.0, -0.5})
    starts.push_back(
        only_acting({0.4 * deviation, 0.0, 0.4 * deviation, 0.6 * deviation, log_length, white}));
  if (!settings.parts.correlated) starts.resize(1);
  return starts;
}

void check(const std::vector<GrowthSpecimen>& specimens, const GrowthFitSettings& settings,
           const GrowthData& data) {
  const ScatterParts& parts = settings.parts;
  if (!parts.correlated && !parts.white)
    throw InputError("parts", "has neither correlated nor white; a step needs one of them");
  if (parts.slope && !parts.level)
    throw InputError("parts", "has slope without level; give level too");
  if (settings.knots && (*settings.knots < 2 || *settings.knots > kMostKnots))
    throw InputError("knots",
                     fmt::format("is {}; it must be from 2 to {}", *settings.knots, kMostKnots));
  if (!(data.highest() > data.lowest()))
    throw InputError("specimens",
                     "has one range of the stress intensity factor only; a law needs "
                     "at least two");
  const std::size_t constants = static_cast<std::size_t>(settings.knots.value_or(2)) +
                                static_cast<std::size_t>(std::ranges::count(parts.acting(), true));
  if (data.steps() <= constants)
    throw InputError("specimens",
                     fmt::format("has {} steps for {} constants; give longer records or more of "
                                 "them, or fit fewer parts",
                                 data.steps(), constants));
  if (parts.level && specimens.size() < 2)
    throw InputError("parts",
                     "has level, which one specimen cannot tell from the median; give more "
                     "specimens or leave level and slope out");
}

/// Standard errors from the curvature, (GS-8).  A parameter that takes part in a direction without
/// curvature has none; the errors of the others do not depend on such directions.
void set_errors(GrowthFit& fit, const Eigen::MatrixXd& curvature) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(curvature);
  const double flat = kNoCurvature * axes.eigenvalues().cwiseAbs().maxCoeff();
  const auto acting = fit.parts.acting();
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < kCount; ++k) {
    if (!acting[k]) continue;
    double variance = 0.0;
    double undetermined = 0.0;
    for (Eigen::Index j = 0; j < curvature.rows(); ++j) {
      const double share = std::pow(axes.eigenvectors()(at, j), 2);
      if (axes.eigenvalues()[j] > flat)
        variance += share / axes.eigenvalues()[j];
      else
        undetermined += share;
    }
    if (undetermined < 1e-6) fit.errors[k] = std::sqrt(variance);
    ++at;
  }
}

}  // namespace

GrowthFit fit_growth(const std::vector<GrowthSpecimen>& specimens,
                     const GrowthFitSettings& settings, const Progress& progress) {
  const GrowthData data(specimens);
  check(specimens, settings, data);
  const auto acting = settings.parts.acting();
  const auto of_scatter = static_cast<double>(std::ranges::count(acting, true));
  constexpr int kTriedKnots = 8;
  const int fewest = settings.knots.value_or(2);
  // Each knot needs some steps of its own in the longest record.
  const auto longest = std::ranges::max(specimens, {}, &GrowthSpecimen::steps).steps();
  const int most = settings.knots.value_or(
      std::clamp(static_cast<int>(std::min<std::size_t>(longest, 1000) / 4), 2, kTriedKnots));

  GrowthFit best;
  Search::Found best_found;
  std::vector<Values> starts = starts_for(specimens, settings);
  std::vector<KnotTrial> trials;
  for (int knots = fewest; knots <= most; ++knots) {
    const MeanGrowth mean = knots_over(data, knots);
    const Search search(data, mean, settings.parts);
    std::optional<Search::Found> found;
    const double first = static_cast<double>(knots - fewest) / (most - fewest + 1);
    const double last = static_cast<double>(knots - fewest + 1) / (most - fewest + 1);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const auto share = [&](std::size_t done) {
        return std::lerp(first, last,
                         static_cast<double>(done) / static_cast<double>(starts.size()));
      };
      Search::Found from = search.from(starts[k], progress.part(share(k), share(k + 1)));
      if (!found || from.likelihood > found->likelihood) found = std::move(from);
    }
    const KnotTrial trial{
        .knots = knots,
        .log_likelihood = found->likelihood,
        .criterion = (knots + of_scatter) * std::log(static_cast<double>(data.steps())) -
                     2 * found->likelihood};  // (GS-9)
    if (trials.empty() ||
        trial.criterion < std::ranges::min(trials, {}, &KnotTrial::criterion).criterion) {
      best.mean = mean;
      best_found = *found;
    }
    trials.push_back(trial);
    // The next number of knots begins where this one ended, and once more afar.
    starts = {found->values};
    starts.push_back(found->values);
    starts.back()[4] = -2.5;
    starts.back()[2] = acting[2] ? std::max(std::abs(starts.back()[2]), 0.1) : 0.0;
  }
  best.trials = std::move(trials);
  best.parts = settings.parts;
  best.parameters = ScatterParameters::of(normalised(best_found.values));
  const GrowthLikelihood at_best = data.likelihood(best.mean, best.parameters);
  best.mean.rates = at_best.rates;
  best.rate_covariance = at_best.covariance;
  best.log_likelihood = at_best.value;
  best.converged = best_found.converged;
  best.reason = best.converged
                    ? "no change of the parameters raises the likelihood by more than 1e-8"
                    : "the likelihood cannot be raised further, but its slope is not zero";
  set_errors(best, best_found.curvature);
  return best;
}

}  // namespace strainwave

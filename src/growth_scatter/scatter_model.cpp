// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_scatter/scatter_model.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numbers>
#include <numeric>

#include "step_filter.hpp"
#include "strainwave/core/dual.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {

std::vector<double> MeanGrowth::weights(double log_range) const {
  std::vector<double> result(knots.size(), 0.0);
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, log_range);
  const auto j = static_cast<std::size_t>(above - knots.begin());
  const double share = (log_range - knots[j - 1]) / (knots[j] - knots[j - 1]);
  result[j - 1] = 1 - share;
  result[j] = share;
  return result;
}

double MeanGrowth::log_rate(double log_range) const {
  const std::vector<double> w = weights(log_range);
  double sum = 0.0;
  for (std::size_t k = 0; k < w.size(); ++k) sum += w[k] * rates[k];  // (GS-3)
  return sum;
}

ScatterParts ScatterParts::of(std::span<const ScatterPart> named) {
  const auto has = [&](ScatterPart part) { return std::ranges::find(named, part) != named.end(); };
  return {.level = has(ScatterPart::level),
          .slope = has(ScatterPart::slope),
          .correlated = has(ScatterPart::correlated),
          .white = has(ScatterPart::white)};
}

GrowthData::GrowthData(std::span<const GrowthSpecimen> specimens) {
  if (specimens.empty()) throw InputError("specimens", "has no record; give at least one");
  lowest_ = log_range(specimens.front(), 0);
  highest_ = lowest_;
  for (const GrowthSpecimen& specimen : specimens) {
    for (std::size_t i = 0; i < specimen.steps(); ++i) offset_ += log_rate(specimen, i);
    steps_ += specimen.steps();
  }
  offset_ /= static_cast<double>(steps_);
  std::vector<const GrowthSpecimen*> firsts;  // of each design
  for (const GrowthSpecimen& specimen : specimens) {
    const auto same = std::ranges::find_if(firsts, [&](const GrowthSpecimen* first) {
      return first->sizes == specimen.sizes && first->ranges == specimen.ranges;
    });
    const auto number = static_cast<std::size_t>(same - firsts.begin());
    if (same == firsts.end()) {
      firsts.push_back(&specimen);
      Design& design = designs_.emplace_back();
      for (std::size_t i = 0; i < specimen.steps(); ++i) {
        design.log_sizes.push_back(
            std::log(std::midpoint(specimen.sizes[i], specimen.sizes[i + 1])));
        design.lengths.push_back(specimen.sizes[i + 1] - specimen.sizes[i]);
        design.log_ranges.push_back(log_range(specimen, i));
        lowest_ = std::min(lowest_, design.log_ranges.back());
        highest_ = std::max(highest_, design.log_ranges.back());
      }
    }
    std::vector<double>& record = designs_[number].records.emplace_back();
    for (std::size_t i = 0; i < specimen.steps(); ++i)
      record.push_back(log_rate(specimen, i) - offset_);
  }
}

GrowthLikelihood GrowthData::likelihood(const MeanGrowth& mean,
                                        const ScatterParameters& parameters) const {
  const std::size_t knots = mean.knots.size();
  const auto size = static_cast<Eigen::Index>(knots);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  double squares = 0.0;
  double log_variances = 0.0;
  for (const Design& design : designs_) {
    const std::size_t n = design.lengths.size();
    // The columns of the knots come first.
    std::vector<std::vector<double>> columns(knots, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const std::vector<double> w = mean.weights(design.log_ranges[i]);
      for (std::size_t k = 0; k < knots; ++k) columns[k][i] = w[k];
    }
    columns.insert(columns.end(), design.records.begin(), design.records.end());
    const auto records = static_cast<double>(design.records.size());
    pass_steps<double>(design.log_sizes, design.lengths, design.log_ranges, mean.pivot,
                       parameters.values(), columns,
                       [&](double variance, std::span<const double> e) {
                         const Eigen::Map<const Eigen::VectorXd> of_knots(e.data(), size);
                         normal.noalias() += (records / variance) * of_knots * of_knots.transpose();
                         double sum = 0.0;
                         for (std::size_t c = knots; c < e.size(); ++c) {
                           sum += e[c];
                           squares += e[c] * e[c] / variance;
                         }
                         right += (sum / variance) * of_knots;
                         log_variances += records * std::log(variance);
                       });
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
  const Eigen::VectorXd rates = solver.solve(right);  // (GS-7)
  const Eigen::MatrixXd covariance = solver.solve(Eigen::MatrixXd::Identity(size, size));
  GrowthLikelihood result;
  result.value = -(log_variances + static_cast<double>(steps_) * std::log(2 * std::numbers::pi) +
                   squares - right.dot(rates)) /
                 2;  // (GS-5)
  for (const double rate : rates) result.rates.push_back(rate + offset_);
  result.covariance.assign(covariance.reshaped().begin(), covariance.reshaped().end());
  return result;
}

std::array<double, ScatterParameters::kCount> GrowthData::slope(
    const MeanGrowth& mean, const ScatterParameters& parameters) const {
  constexpr std::size_t kCount = ScatterParameters::kCount;
  using Real = Dual<kCount>;
  MeanGrowth best = mean;
  best.rates = likelihood(mean, parameters).rates;
  std::array<Real, kCount> carried{};
  const std::array<double, kCount> values = parameters.values();
  for (std::size_t k = 0; k < kCount; ++k) {
    carried[k] = values[k];
    carried[k].partial[k] = 1.0;
  }
  // The likelihood is at its maximum over the rates, so their change adds nothing.
  Real sum = 0.0;
  for (const Design& design : designs_) {
    std::vector<std::vector<double>> columns = design.records;
    for (std::size_t i = 0; i < design.lengths.size(); ++i) {
      const double median = best.log_rate(design.log_ranges[i]) - offset_;
      for (std::vector<double>& column : columns) column[i] -= median;
    }
    const auto records = static_cast<double>(columns.size());
    pass_steps<Real>(design.log_sizes, design.lengths, design.log_ranges, mean.pivot, carried,
                     columns, [&](const Real& variance, std::span<const Real> e) {
                       Real squares = 0.0;
                       for (const Real& number : e) squares += number * number;
                       sum += records * log(variance) + squares / variance;
                     });
  }
  std::array<double, kCount> slopes{};
  for (std::size_t k = 0; k < kCount; ++k) slopes[k] = -sum.partial[k] / 2;
  return slopes;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/sobol_indices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "strainwave/uncertainty/sobol_points.hpp"

namespace strainwave {
namespace {

/// Outputs at the points A, B and A with one input of B, for one base point.
class Rows {
 public:
  Rows(std::size_t points, std::size_t inputs, std::size_t outputs)
      : outputs_(outputs),
        per_point_((inputs + 2) * outputs),
        values_(points * per_point_),
        whole_(points, 1) {}

  [[nodiscard]] std::span<double> row(std::size_t point, std::size_t which) {
    return std::span(values_).subspan(point * per_point_ + which * outputs_, outputs_);
  }
  [[nodiscard]] double of(std::size_t point, std::size_t which, std::size_t output) const {
    return values_[point * per_point_ + which * outputs_ + output];
  }
  void leave_out(std::size_t point) { whole_[point] = 0; }
  [[nodiscard]] bool whole(std::size_t point) const { return whole_[point] != 0; }

 private:
  std::size_t outputs_;
  std::size_t per_point_;
  std::vector<double> values_;
  std::vector<char> whole_;  // not bool, because threads write neighbours
};

constexpr std::size_t kA = 0;
constexpr std::size_t kB = 1;
constexpr std::size_t kMixed = 2;  ///< A with input i of B is row kMixed + i

Estimate estimate_of(std::span<const double> replicates) {
  const auto n = static_cast<double>(replicates.size());
  double mean = 0.0;
  for (const double value : replicates) mean += value / n;
  double square = 0.0;
  for (const double value : replicates) square += (value - mean) * (value - mean);
  const boost::math::students_t student(n - 1);
  const double half = boost::math::quantile(student, 0.975) * std::sqrt(square / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

/// Shares of all inputs from the points of one replicate.
struct Shares {
  double mean = 0.0;
  double variance = 0.0;
  std::vector<double> first;
  std::vector<double> total;
};

Shares shares_of(const Rows& rows, std::size_t begin, std::size_t end, std::size_t inputs,
                 std::size_t output) {
  Shares shares{.first = std::vector<double>(inputs), .total = std::vector<double>(inputs)};
  std::vector<std::size_t> whole;
  for (std::size_t n = begin; n < end; ++n)
    if (rows.whole(n)) whole.push_back(n);
  if (whole.size() < 2)
    throw SolverError(
        "the outputs have values at fewer than two points of a replicate; take more points, or "
        "scatter the inputs less");
  const auto count = static_cast<double>(whole.size());
  for (const std::size_t n : whole)
    shares.mean += (rows.of(n, kA, output) + rows.of(n, kB, output)) / (2 * count);
  for (const std::size_t n : whole) {
    const double a = rows.of(n, kA, output) - shares.mean;
    const double b = rows.of(n, kB, output) - shares.mean;
    shares.variance += (a * a + b * b) / (2 * count);
    for (std::size_t i = 0; i < inputs; ++i) {
      const double mixed = rows.of(n, kMixed + i, output) - shares.mean;
      shares.first[i] += b * (mixed - a) / count;                  // (UQ-2)
      shares.total[i] += (a - mixed) * (a - mixed) / (2 * count);  // (UQ-3)
    }
  }
  return shares;
}

SobolOutput output_of(const Rows& rows, std::size_t points, std::size_t replicates,
                      std::size_t inputs, std::size_t output) {
  SobolOutput result;
  std::vector<Shares> all;
  const std::size_t size = points / replicates;
  for (std::size_t r = 0; r < replicates; ++r) {
    all.push_back(shares_of(rows, r * size, (r + 1) * size, inputs, output));
    result.mean += all.back().mean / static_cast<double>(replicates);
    result.variance += all.back().variance / static_cast<double>(replicates);
  }
  // The variance of a constant is that of rounding.
  const double rounding = std::pow(1e-13 * result.mean, 2);
  if (std::ranges::any_of(all, [&](const Shares& s) { return !(s.variance > rounding); })) {
    result.variance = 0.0;
    return result;
  }
  std::vector<double> of_replicate(replicates);
  const auto estimate = [&](const auto& share) {
    for (std::size_t r = 0; r < replicates; ++r) of_replicate[r] = share(all[r]) / all[r].variance;
    return estimate_of(of_replicate);
  };
  for (std::size_t i = 0; i < inputs; ++i)
    result.input.push_back({estimate([&](const Shares& s) { return s.first[i]; }),
                            estimate([&](const Shares& s) { return s.total[i]; })});
  result.first_sum = estimate([](const Shares& s) {
    double sum = 0.0;
    for (const double first : s.first) sum += first;
    return sum;
  });
  return result;
}

}  // namespace

SobolStudy sobol_indices(const std::function<NormalFunction()>& make, std::size_t inputs,
                         std::size_t outputs, const SobolOptions& options,
                         const Progress& progress) {
  require(options.replicates >= 2, "replicates", options.replicates, "1", ">= 2");
  require(options.points >= 2 * options.replicates && options.points % options.replicates == 0,
          "points", options.points, "1",
          fmt::format("a multiple of {}, the replicates, and at least twice as many",
                      options.replicates));
  require(inputs >= 1 && inputs <= SobolPoints::kMaxDimensions / 2, "inputs",
          static_cast<double>(inputs), "1",
          fmt::format(">= 1 and <= {}", SobolPoints::kMaxDimensions / 2));
  const auto points = static_cast<std::size_t>(options.points);
  const auto replicates = static_cast<std::size_t>(options.replicates);
  const std::size_t size = points / replicates;
  const SobolPoints sobol(2 * inputs, size);
  Rows rows(points, inputs, outputs);
  for_each_index(points, {.block = 16, .threads = options.threads}, progress, [&] {
    return [&, function = make(), a = std::vector<double>(inputs), b = std::vector<double>(inputs),
            mixed = std::vector<double>()](std::size_t n) mutable {
      const std::uint64_t scrambling = splitmix64(options.seed, n / size);
      for (std::size_t i = 0; i < inputs; ++i) {
        // Neighbouring dimensions fill their plane best, and the shares rest on the planes of (a, b).
        a[i] = normal_quantile(sobol.at(n % size, 2 * i, scrambling));
        b[i] = normal_quantile(sobol.at(n % size, 2 * i + 1, scrambling));
      }
      bool whole = function(a, rows.row(n, kA)) && function(b, rows.row(n, kB));
      for (std::size_t i = 0; whole && i < inputs; ++i) {
        mixed = a;
        mixed[i] = b[i];
        whole = function(mixed, rows.row(n, kMixed + i));
      }
      if (!whole) rows.leave_out(n);
    };
  });
  SobolStudy study{.output = {}, .evaluations = points * (inputs + 2)};
  for (std::size_t n = 0; n < points; ++n) study.left_out += rows.whole(n) ? 0 : 1;
  for (std::size_t y = 0; y < outputs; ++y)
    study.output.push_back(output_of(rows, points, replicates, inputs, y));
  return study;
}

}  // namespace strainwave

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

/// Outputs at the points A, B and A with one group of inputs of B, for one base point.
struct BasePoint {
  std::vector<double> values;  ///< shape (2 + groups, outputs)
  bool whole = false;          ///< whether the function has values at all points
};

template <class Archive>
void archive(Archive& to, BasePoint& point) {
  to(point.values, point.whole);
}

constexpr std::size_t kA = 0;
constexpr std::size_t kB = 1;
constexpr std::size_t kMixed = 2;  ///< A with group i of B is row kMixed + i

/// The outputs at all base points.
class Rows {
 public:
  Rows(std::vector<BasePoint> points, std::size_t outputs)
      : outputs_(outputs), points_(std::move(points)) {}

  [[nodiscard]] double of(std::size_t point, std::size_t which, std::size_t output) const {
    return points_[point].values[which * outputs_ + output];
  }
  /// All outputs at a point; empty if the base point is not whole.
  [[nodiscard]] std::span<const double> of(std::size_t point, std::size_t which) const {
    if (!whole(point)) return {};
    return std::span(points_[point].values).subspan(which * outputs_, outputs_);
  }
  [[nodiscard]] bool whole(std::size_t point) const { return points_[point].whole; }

 private:
  std::size_t outputs_;
  std::vector<BasePoint> points_;
};

/// The points of the design.
class Design {
 public:
  Design(const InputGroups& groups, std::size_t inputs, const SobolOptions& options)
      : groups_(groups),
        size_(static_cast<std::size_t>(options.points / options.replicates)),
        seed_(options.seed),
        sobol_(2 * inputs, size_) {}

  /// Number of points for each base point.
  [[nodiscard]] std::size_t sets() const { return kMixed + groups_.size(); }
  /// Fills the points A and B of a base point.
  void fill(std::size_t base, std::span<double> a, std::span<double> b) const {
    const std::uint64_t scrambling = splitmix64(seed_, base / size_);
    for (std::size_t i = 0; i < a.size(); ++i) {
      // Neighbouring dimensions fill their plane best, and the shares rest on the planes of (a, b).
      a[i] = normal_quantile(sobol_.at(base % size_, 2 * i, scrambling));
      b[i] = normal_quantile(sobol_.at(base % size_, 2 * i + 1, scrambling));
    }
  }
  /// Makes `point` the point of a set.
  void choose(std::size_t set, const std::vector<double>& a, const std::vector<double>& b,
              std::vector<double>& point) const {
    point = set == kB ? b : a;
    if (set < kMixed) return;
    for (const std::size_t i : groups_[set - kMixed]) point[i] = b[i];
  }

 private:
  const InputGroups& groups_;
  std::size_t size_;  ///< of a replicate
  std::uint64_t seed_;
  SobolPoints sobol_;
};

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

/// Shares of all groups from the points of one replicate.
struct Shares {
  double mean = 0.0;
  double variance = 0.0;
  std::vector<double> first;
  std::vector<double> total;
};

Shares shares_of(const Rows& rows, std::size_t begin, std::size_t end, std::size_t groups,
                 std::size_t output) {
  Shares shares{.first = std::vector<double>(groups), .total = std::vector<double>(groups)};
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
    for (std::size_t i = 0; i < groups; ++i) {
      const double mixed = rows.of(n, kMixed + i, output) - shares.mean;
      shares.first[i] += b * (mixed - a) / count;                  // (UQ-2)
      shares.total[i] += (a - mixed) * (a - mixed) / (2 * count);  // (UQ-3)
    }
  }
  return shares;
}

SobolOutput output_of(const Rows& rows, std::size_t points, std::size_t replicates,
                      std::size_t groups, std::size_t output) {
  SobolOutput result;
  std::vector<Shares> all;
  const std::size_t size = points / replicates;
  for (std::size_t r = 0; r < replicates; ++r) {
    all.push_back(shares_of(rows, r * size, (r + 1) * size, groups, output));
    result.mean += all.back().mean / static_cast<double>(replicates);
    result.variance += all.back().variance / static_cast<double>(replicates);
  }
  // The variance of a constant is that of rounding.
  const double rounding = std::pow(1e-13 * result.mean, 2);
  const auto constant = [&](const Shares& s) { return !(s.variance > rounding); };
  if (std::ranges::all_of(all, constant)) {
    result.variance = 0.0;
    return result;
  }
  // An output that seldom changes may stand still in a replicate; then all take the mean variance.
  const bool pooled = std::ranges::any_of(all, constant);
  std::vector<double> of_replicate(replicates);
  const auto estimate = [&](const auto& share) {
    for (std::size_t r = 0; r < replicates; ++r)
      of_replicate[r] = share(all[r]) / (pooled ? result.variance : all[r].variance);
    return estimate_of(of_replicate);
  };
  for (std::size_t i = 0; i < groups; ++i)
    result.group.push_back({estimate([&](const Shares& s) { return s.first[i]; }),
                            estimate([&](const Shares& s) { return s.total[i]; })});
  result.first_sum = estimate([](const Shares& s) {
    double sum = 0.0;
    for (const double first : s.first) sum += first;
    return sum;
  });
  return result;
}

}  // namespace

SobolStudy sobol_indices(const std::function<NormalFunction()>& make, const InputGroups& groups,
                         std::size_t outputs, const SobolOptions& options,
                         const Progress& progress) {
  require(options.replicates >= 2, "replicates", options.replicates, "1", ">= 2");
  require(options.points >= 2 * options.replicates && options.points % options.replicates == 0,
          "points", options.points, "1",
          fmt::format("a multiple of {}, the replicates, and at least twice as many",
                      options.replicates));
  std::size_t inputs = 0;
  for (const std::vector<std::size_t>& group : groups) inputs += group.size();
  require(inputs >= 1 && inputs <= SobolPoints::kMaxDimensions / 2, "inputs",
          static_cast<double>(inputs), "1",
          fmt::format(">= 1 and <= {}", SobolPoints::kMaxDimensions / 2));
  for (const std::vector<std::size_t>& group : groups)
    for (const std::size_t input : group)
      require(input < inputs, "group", static_cast<double>(input), "1",
              fmt::format("the index of one of the {} inputs", inputs));
  const auto points = static_cast<std::size_t>(options.points);
  const auto replicates = static_cast<std::size_t>(options.replicates);
  const std::size_t size = points / replicates;
  const Design design(groups, inputs, options);
  const Parallel parallel{.block = 16, .threads = options.threads};
  const auto make_point = [&] {
    return [&, function = make(), a = std::vector<double>(inputs), b = std::vector<double>(inputs),
            at = std::vector<double>()](std::size_t n, BasePoint& point) mutable {
      design.fill(n, a, b);
      point.values.resize(design.sets() * outputs);
      point.whole = true;
      for (std::size_t set = 0; point.whole && set < design.sets(); ++set) {
        design.choose(set, a, b, at);
        point.whole = function(at, std::span(point.values).subspan(set * outputs, outputs));
      }
    };
  };
  const double computed = options.each ? 0.9 : 1.0;
  const Rows rows(shared_rows<BasePoint>(points, parallel, progress.part(0.0, computed),
                                         options.shared, make_point),
                  outputs);
  if (options.each) {
    std::vector<double> a(inputs);
    std::vector<double> b(inputs);
    std::vector<double> at;
    const Progress handed = progress.part(computed, 1.0);
    for (std::size_t n = 0; n < points; ++n) {
      if (n % size == 0) handed.at(static_cast<double>(n) / static_cast<double>(points));
      design.fill(n, a, b);
      for (std::size_t set = 0; set < design.sets(); ++set) {
        design.choose(set, a, b, at);
        options.each(n, set, at, rows.of(n, set));
      }
    }
  }
  SobolStudy study{.output = {}, .evaluations = points * design.sets()};
  for (std::size_t n = 0; n < points; ++n) study.left_out += rows.whole(n) ? 0 : 1;
  for (std::size_t y = 0; y < outputs; ++y)
    study.output.push_back(output_of(rows, points, replicates, groups.size(), y));
  return study;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_scatter/specimens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "strainwave/core/error.hpp"
#include "strainwave/growth_scatter/scatter_model.hpp"

namespace strainwave {
namespace {

void check_record(const std::string& name, const std::vector<double>& sizes,
                  const std::vector<double>& cycles) {
  if (sizes.size() != cycles.size() || sizes.size() < 2)
    throw InputError(name, fmt::format("has {} sizes and {} numbers of cycles; give at least two "
                                       "of each",
                                       sizes.size(), cycles.size()));
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (!(std::isfinite(sizes[i]) && sizes[i] > 0 && std::isfinite(cycles[i])))
      throw InputError(name, fmt::format("has the size {} mm after {} cycles; a size must be "
                                         "positive and finite",
                                         1e3 * sizes[i], cycles[i]));
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    if (!(sizes[i] > sizes[i - 1]))
      throw InputError(name,
                       fmt::format("has the size {:.6g} mm after {:.6g} mm; each size must be "
                                   "larger than the one before, so leave out readings at "
                                   "which the crack did not grow",
                                   1e3 * sizes[i], 1e3 * sizes[i - 1]));
    if (!(cycles[i] > cycles[i - 1]))
      throw InputError(
          name,
          fmt::format("has {} cycles at {:.6g} mm after {} at {:.6g} mm; each number of cycles "
                      "must be larger than the one before",
                      cycles[i], 1e3 * sizes[i], cycles[i - 1], 1e3 * sizes[i - 1]));
  }
}

}  // namespace

double plate_range(const PlateTest& test, double a) {
  const double secant = test.width ? 1 / std::cos(std::numbers::pi * a / *test.width) : 1.0;
  return test.stress_range * std::sqrt(std::numbers::pi * a * secant);  // (GS-1)
}

GrowthSpecimen specimen_of(std::string name, std::vector<double> sizes, std::vector<double> cycles,
                           const PlateTest& test) {
  check_record(name, sizes, cycles);
  if (test.width && sizes.back() >= *test.width / 2)
    throw InputError(name,
                     fmt::format("has a half length of {:.6g} mm in a plate of {:.6g} mm; the "
                                 "half length must be smaller than half of the width",
                                 1e3 * sizes.back(), 1e3 * *test.width));
  GrowthSpecimen specimen{std::move(name), std::move(sizes), std::move(cycles), {}};
  for (std::size_t i = 1; i < specimen.sizes.size(); ++i)
    specimen.ranges.push_back(
        plate_range(test, std::midpoint(specimen.sizes[i - 1], specimen.sizes[i])));
  return specimen;
}

GrowthSpecimen specimen_of(std::string name, std::vector<double> sizes, std::vector<double> cycles,
                           const std::vector<double>& ranges) {
  check_record(name, sizes, cycles);
  if (ranges.size() != sizes.size())
    throw InputError(name, fmt::format("has {} ranges for {} sizes; give one for each",
                                       ranges.size(), sizes.size()));
  for (const double range : ranges)
    if (!(std::isfinite(range) && range > 0))
      throw InputError(name, fmt::format("has the range {} MPa*m^0.5; a range must be positive and "
                                         "finite",
                                         range / 1e6));
  GrowthSpecimen specimen{std::move(name), std::move(sizes), std::move(cycles), {}};
  for (std::size_t i = 1; i < ranges.size(); ++i)
    specimen.ranges.push_back(std::sqrt(ranges[i - 1] * ranges[i]));
  return specimen;
}

std::optional<double> cycles_at(const GrowthSpecimen& specimen, double size) {
  const std::vector<double>& a = specimen.sizes;
  if (!(size >= a.front() && size <= a.back())) return std::nullopt;
  const auto above = std::ranges::upper_bound(a, size);
  if (above == a.end()) return specimen.cycles.back();
  const auto i = static_cast<std::size_t>(above - a.begin());
  return std::lerp(specimen.cycles[i - 1], specimen.cycles[i],
                   (size - a[i - 1]) / (a[i] - a[i - 1]));
}

PooledLine pooled_line(const std::vector<GrowthSpecimen>& specimens) {
  double n = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  const auto each = [&](const auto& visit) {
    for (const GrowthSpecimen& specimen : specimens)
      for (std::size_t i = 0; i < specimen.steps(); ++i)
        visit(log_range(specimen, i), log_rate(specimen, i));
  };
  each([&](double x, double y) {
    n += 1;
    sum_x += x;
    sum_y += y;
  });
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  each([&](double x, double y) {
    xx += (x - sum_x / n) * (x - sum_x / n);
    xy += (x - sum_x / n) * (y - sum_y / n);
    yy += (y - sum_y / n) * (y - sum_y / n);
  });
  PooledLine line;
  line.exponent = xy / xx;  // (GS-2)
  line.log_coefficient = (sum_y - line.exponent * sum_x) / n;
  line.deviation = std::sqrt(std::max(0.0, yy - line.exponent * xy) / (n - 2));
  return line;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/drawn_growth.hpp"

#include <cmath>
#include <limits>

#include "strainwave/core/counter_random.hpp"

namespace strainwave {
namespace {

/// Streams of a seed for the growth of single cracks, beyond the numbers of all draws.
constexpr std::uint64_t kSpecimenStream = std::uint64_t{1} << 41U;
constexpr std::uint64_t kPathStream = std::uint64_t{1} << 42U;

/// A deviate of one crack that has the correlation `shared` with that of other cracks.
double deviate_of_crack(double common, double own, double shared) {
  return std::sqrt(shared) * common + std::sqrt(1 - shared) * own;  // (GS-12)
}

/// The specimen in which a crack grows.
DrawnSpecimen specimen_of(const GrowthScatter& scatter, const DrawnSpecimen& common,
                          const DrawnGrowth& drawn, std::size_t crack) {
  const double shared = scatter.level_correlation.value_or(1.0);
  if (shared == 1) return common;
  if (!drawn.of_crack)
    return {deviate_of_crack(common.level, 0.0, shared),
            deviate_of_crack(common.exponent, 0.0, shared)};
  const std::uint64_t seed = splitmix64(drawn.seed, kSpecimenStream + crack);
  return {deviate_of_crack(common.level, counter_normal(seed, drawn.draw, 0), shared),
          deviate_of_crack(common.exponent, counter_normal(seed, drawn.draw, 1), shared)};
}

RateDeviation deviation_of(const GrowthScatter& scatter, const DrawnSpecimen& specimen) {
  RateDeviation deviation;
  deviation.logarithm = scatter.level.value_or(0.0) * specimen.level;  // (GS-12)
  if (!scatter.exponent) return deviation;
  const double shared = scatter.exponent_correlation.value_or(0.0);
  deviation.exponent =
      *scatter.exponent *
      (shared * specimen.level + std::sqrt(1 - shared * shared) * specimen.exponent);  // (GS-12)
  deviation.pivot = *scatter.pivot;
  return deviation;
}

}  // namespace

DeviatingCracks::DeviatingCracks(const GearSet& gear, const std::vector<DriveCrack>& cracks,
                                 const DrawnGrowth& drawn) {
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    Deviating& crack = cracks_.emplace_back();
    crack.log_end = std::numeric_limits<double>::infinity();
    const std::string_view name = solid_name(gear, cracks[i].material);
    const auto material = gear.material.find(std::string(name));
    if (material == gear.material.end() || !material->second.growth_scatter) continue;
    const GrowthScatter& scatter = *material->second.growth_scatter;
    const auto specimen = drawn.specimen.find(name);
    crack.specimen = deviation_of(
        scatter,
        specimen_of(scatter, specimen == drawn.specimen.end() ? DrawnSpecimen{} : specimen->second,
                    drawn, i));
    const PathScatter path{.wander = scatter.wander.value_or(0.0),
                           .wander_length = scatter.wander ? *scatter.wander_length : 0.0,
                           .white = scatter.white.value_or(0.0),
                           .white_step = scatter.white ? *scatter.white_step : 0.0};
    if (!drawn.of_crack || !path.any()) continue;
    crack.path.emplace(path, splitmix64(drawn.seed, kPathStream + i), drawn.draw,
                       cracks[i].size.size);
    crack.log_end = std::log(crack.path->end());
  }
}

RateDeviation DeviatingCracks::of(std::size_t crack) const {
  RateDeviation deviation = cracks_[crack].specimen;
  if (cracks_[crack].path) deviation.logarithm += cracks_[crack].path->deviation();  // (GS-12)
  return deviation;
}

double DeviatingCracks::log_end(std::size_t crack) const { return cracks_[crack].log_end; }

void DeviatingCracks::next(std::size_t crack) {
  Deviating& of = cracks_[crack];
  of.path->next();
  of.log_end = std::log(of.path->end());
}

void DeviatingCracks::go_on(std::size_t crack, double size) {
  Deviating& of = cracks_[crack];
  if (!of.path) return;
  of.path->go_on(size);
  of.log_end = std::log(of.path->end());
}

}  // namespace strainwave

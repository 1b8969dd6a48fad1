// SPDX-License-Identifier: Apache-2.0
#include "drawn_lives.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kCentreDraws = 200;  // of a round of the search for the failures

}  // namespace

template <class Archive>
void archive(Archive& to, DrawnLife& life) {
  to(life.refused, life.unfinished, life.out_of_range, life.arrested, life.part.failure,
     life.part.times, life.part.sizes, life.part.weight);
}

DrawnPart part_of(const LifeTrace& trace) {
  DrawnPart part{.times = trace.times, .sizes = trace.sizes};
  if (trace.life)
    part.failure = *trace.life;
  else if (trace.end == DriveEnd::range)
    part.failure = trace.time;
  return part;
}

DrawnLives::DrawnLives(const GearSet& gear, const InspectionOptions& options)
    : gear_(gear), options_(options), normals_(scattering_normals(gear)) {
  for (const InputScatter& scatter : gear.scatter)
    laws_.emplace_back(scatter, number_at(gear, scatter.path).value);
}

std::vector<double> DrawnLives::normals_of(std::size_t draw) const {
  std::vector<double> u(laws_.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = counter_normal(options_.seed, draw, i);
  if (about_failures(draw))
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += centre_[i];
  return u;
}

FailureCentre DrawnLives::centre_draws(double until, const Progress& progress) {
  const auto make = [&]() -> LimitState {
    return [this, until, drive = std::make_shared<DrawnDrive>(gear_, gear_.scatter)](
               std::span<const double> u) -> std::optional<double> {
      const DrawnLife life = life_at(*drive, {u.begin(), u.end()}, nullptr);
      if (life.refused) return std::nullopt;
      return std::log(life.part.failure / until);
    };
  };
  FailureCentre centre = find_failure_centre(make, laws_.size(),
                                             {.draws = kCentreDraws,
                                              .seed = splitmix64(options_.seed, kCentreDraws),
                                              .threads = options_.threads},
                                             progress);
  if (centre.found) centre_ = centre.place;
  return centre;
}

std::vector<FailureInput> DrawnLives::inputs_at_centre() const {
  std::vector<double> z = centre_;
  normals_.correlate(z);
  std::vector<FailureInput> inputs;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const NumberAt number = number_at(gear_, gear_.scatter[i].path);
    inputs.push_back({.path = number.path,
                      .unit = number.field.unit,
                      .value = number.value,
                      .at_centre = laws_[i].at(z[i]),
                      .deviations = z[i]});
  }
  std::ranges::stable_sort(inputs, std::ranges::greater{},
                           [](const FailureInput& input) { return std::abs(input.deviations); });
  return inputs;
}

std::vector<DrawnLife> DrawnLives::draws(const std::vector<std::string>& cracks,
                                         const Progress& progress) const {
  const Parallel parallel{.block = 4, .threads = options_.threads};
  return shared_rows<DrawnLife>(
      static_cast<std::size_t>(options_.draws), parallel, progress, options_.shared, [&] {
        return [this, &cracks, drive = std::make_unique<DrawnDrive>(gear_, gear_.scatter)](
                   std::size_t index, DrawnLife& life) {
          const std::vector<double> u = normals_of(index);
          life = life_at(*drive, u, &cracks);
          if (!centre_.empty()) life.part.weight = mixture_weight(u, centre_);  // (IR-16)
        };
      });
}

DrawnLife DrawnLives::life_at(DrawnDrive& drive, std::vector<double> z,
                              const std::vector<std::string>* cracks) const {
  normals_.correlate(z);
  for (std::size_t i = 0; i < laws_.size(); ++i) drive.number(i) = laws_[i].at(z[i]);
  DrawnLife result;
  try {
    check(drive.gear());
    const LifeTrace trace = life_trace(drive.gear(), options_.growth);
    result.part = part_of(trace);
    result.arrested = trace.end == DriveEnd::arrested;
    result.out_of_range = trace.end == DriveEnd::range;
    result.unfinished = trace.end == DriveEnd::too_slow;
    result.refused =
        trace.end == DriveEnd::not_known || (cracks != nullptr && trace.cracks != *cracks);
  } catch (const Error&) {
    result.refused = true;
  }
  return result;
}

}  // namespace strainwave

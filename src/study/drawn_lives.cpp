// SPDX-License-Identifier: Apache-2.0
#include "drawn_lives.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"

namespace strainwave {
namespace {

/// Draws of a round of the search for failures: at least these, and so many for each input.
constexpr std::size_t kRoundDraws = 200;
constexpr std::size_t kRoundDrawsPerInput = 50;
/// Stream of the search in the numbers of a seed, beyond those of all draws.
constexpr std::uint64_t kSearchStream = std::uint64_t{1} << 40U;

}  // namespace

template <class Archive>
void archive(Archive& to, DrawnLife& life) {
  to(life.refused, life.unfinished, life.out_of_range, life.arrested, life.part.failure,
     life.part.times, life.part.sizes, life.part.weight);
}

bool growth_scatters(const GearSet& gear) {
  return std::ranges::any_of(
      gear.material, [](const auto& named) { return named.second.growth_scatter.has_value(); });
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
    : gear_(gear),
      options_(options),
      levels_(growth_levels(gear)),
      growth_scatters_(growth_scatters(gear)),
      normals_(life_normals(gear)) {
  for (const InputScatter& scatter : gear.scatter)
    laws_.emplace_back(scatter, number_at(gear, scatter.path).value);
}

std::vector<std::string> DrawnLives::inputs() const {
  std::vector<std::string> paths;
  for (const InputScatter& scatter : gear_.scatter) paths.push_back(scatter.path);
  for (const GrowthLevel& level : levels_) paths.push_back(level.path);
  return paths;
}

std::vector<double> DrawnLives::normals_of(std::size_t draw) const {
  std::vector<double> u(normals_.size());
  counter_normals(options_.seed, draw, u);
  if (about_failures(draw)) {
    const std::vector<double>& centre = centres_[draw % (centres_.size() + 1) - 1];
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += centre[i];
  }
  return u;
}

FailureCentres DrawnLives::centre_draws(double until, const std::vector<std::string>& cracks,
                                        const Progress& progress) {
  const auto make = [&]() -> LimitState {
    return [this, until, &cracks, drive = std::make_shared<DrawnDrive>(gear_, gear_.scatter)](
               std::span<const double> u) -> std::optional<double> {
      // A path is no variable of the search, so the search takes the median of each.
      const DrawnLife life = life_at(*drive, u, std::nullopt, cracks);
      if (life.refused) return std::nullopt;
      return std::log(life.part.failure / until);
    };
  };
  FailureCentres found =
      find_failure_centres(make, normals_.size(),
                           {.draws = std::max(kRoundDraws, kRoundDrawsPerInput * normals_.size()),
                            .seed = splitmix64(options_.seed, kSearchStream),
                            .threads = options_.threads},
                           progress);
  centres_ = found.places;
  return found;
}

std::vector<CentreOfFailures> DrawnLives::centres() const {
  std::vector<CentreOfFailures> described;
  for (const std::vector<double>& centre : centres_) {
    CentreOfFailures& of = described.emplace_back();
    of.distance = std::sqrt(std::inner_product(centre.begin(), centre.end(), centre.begin(), 0.0));
    std::vector<double> z = centre;
    normals_.correlate(z);
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      const NumberAt number = number_at(gear_, gear_.scatter[i].path);
      of.inputs.push_back({.path = number.path,
                           .unit = number.field.unit,
                           .value = number.value,
                           .at_centre = laws_[i].at(z[i]),
                           .deviations = z[i]});
    }
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const double deviate = z[laws_.size() + i];
      of.inputs.push_back({.path = levels_[i].path,
                           .unit = "1",
                           .value = 0.0,
                           .at_centre = number_at(gear_, levels_[i].path).value * deviate,
                           .deviations = deviate});
    }
    std::ranges::stable_sort(of.inputs, std::ranges::greater{},
                             [](const FailureInput& input) { return std::abs(input.deviations); });
  }
  return described;
}

std::vector<DrawnLife> DrawnLives::draws(const std::vector<std::string>& cracks,
                                         const Progress& progress) const {
  const Parallel parallel{.block = 4, .threads = options_.threads};
  return shared_rows<DrawnLife>(
      static_cast<std::size_t>(options_.draws), parallel, progress, options_.shared, [&] {
        return [this, &cracks, drive = std::make_unique<DrawnDrive>(gear_, gear_.scatter)](
                   std::size_t index, DrawnLife& life) {
          const std::vector<double> u = normals_of(index);
          life = life_at(*drive, u, index, cracks);
          if (!centres_.empty()) life.part.weight = mixture_weight(u, centres_);  // (IR-16)
        };
      });
}

void DrawnLives::write_lives(const std::vector<DrawnLife>& lives,
                             const std::vector<std::string>& cracks, RowSink& to) const {
  RowHead head{.of = "draws", .rows = lives.size(), .columns = {}, .seed = options_.seed};
  for (const InputScatter& scatter : gear_.scatter)
    head.columns.push_back({scatter.path, std::string(number_at(gear_, scatter.path).field.unit)});
  for (const GrowthLevel& level : levels_) head.columns.push_back({level.path, "1"});
  head.columns.push_back({"life", "s"});
  for (const char* const flag : {"arrested", "unfinished", "out_of_range", "weight"})
    head.columns.push_back({flag, "1"});
  for (const std::string& crack : cracks) head.columns.push_back({crack + ".size_at_end", "m"});
  to.begin(head);
  DrawnDrive drive(gear_, gear_.scatter);
  for (std::size_t n = 0; n < lives.size(); ++n) {
    const DrawnLife& life = lives[n];
    std::vector<double> numbers = values_at(normals_of(n));
    if (!life.refused) {
      const auto flag = [](bool is) { return is ? 1.0 : 0.0; };
      numbers.insert(numbers.end(), {life.part.failure, flag(life.arrested), flag(life.unfinished),
                                     flag(life.out_of_range), life.part.weight});
      for (const std::vector<double>& sizes : life.part.sizes) numbers.push_back(sizes.back());
    }
    numbers.resize(head.columns.size(), std::numeric_limits<double>::quiet_NaN());
    to.add(numbers, life.refused ? RowStatus::refused : RowStatus::usable,
           life.refused ? reason_of(drive, n, cracks) : std::string());
  }
}

std::string DrawnLives::reason_of(DrawnDrive& drive, std::size_t draw,
                                  const std::vector<std::string>& cracks) const {
  try {
    const LifeTrace trace = trace_at(drive, normals_of(draw), draw);
    return trace.cracks != cracks ? "other cracks grow than in the drive of the file"
                                  : "the growth of no crack can be computed";
  } catch (const Error& fault) {
    return rule_of(fault);
  }
}

std::vector<double> DrawnLives::values_at(std::span<const double> u) const {
  std::vector<double> values(u.begin(), u.end());
  normals_.correlate(values);
  for (std::size_t i = 0; i < laws_.size(); ++i) values[i] = laws_[i].at(values[i]);
  for (std::size_t i = 0; i < levels_.size(); ++i)
    values[laws_.size() + i] *= number_at(gear_, levels_[i].path).value;
  return values;
}

DrawnLife DrawnLives::life_at(DrawnDrive& drive, std::span<const double> u,
                              std::optional<std::size_t> draw,
                              const std::vector<std::string>& cracks) const {
  DrawnLife result;
  try {
    const LifeTrace trace = trace_at(drive, u, draw);
    result.part = part_of(trace);
    result.arrested = trace.end == DriveEnd::arrested;
    result.out_of_range = trace.end == DriveEnd::range;
    result.unfinished = trace.end == DriveEnd::too_slow;
    result.refused = trace.end == DriveEnd::not_known || trace.cracks != cracks;
  } catch (const Error&) {
    result.refused = true;
  }
  return result;
}

LifeTrace DrawnLives::trace_at(DrawnDrive& drive, std::span<const double> u,
                               std::optional<std::size_t> draw) const {
  std::vector<double> z(u.begin(), u.end());
  normals_.correlate(z);
  DrawnGrowth growth{.seed = options_.seed, .draw = draw.value_or(0), .of_crack = draw.has_value()};
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    DrawnSpecimen& specimen = growth.specimen[levels_[i].material];
    (levels_[i].exponent ? specimen.exponent : specimen.level) = z[laws_.size() + i];
  }
  for (std::size_t i = 0; i < laws_.size(); ++i) drive.number(i) = laws_[i].at(z[i]);
  check(drive.gear());
  return life_trace(drive.gear(), options_.growth, growth_scatters_ ? &growth : nullptr);
}

}  // namespace strainwave

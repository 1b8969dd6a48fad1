// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/inspection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "drawn_drive.hpp"
#include "drawn_outputs.hpp"
#include "measured_detection.hpp"
#include "scatter_law.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/drive_growth/longest_duty.hpp"
#include "strainwave/uncertainty/failure_centre.hpp"
#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

constexpr double kTail = 0.025;
constexpr int kRiskPoints = 61;
/// A drawn history takes about two kilobytes.
constexpr int kMostDraws = 1'000'000;
constexpr double kMostInspections = 1000;
constexpr std::array kShares = {0.01, 0.1, 0.5, 0.9};
constexpr std::size_t kCentreDraws = 200;  // of a round of the search for the failures

/// What became of one draw.
struct DrawnLife {
  bool refused = false;     ///< breaks a rule of the input, or has no answer
  bool unfinished = false;  ///< no end within the longest duty that is computed
  bool out_of_range = false;
  bool arrested = false;
  DrawnPart part;
};

template <class Archive>
void archive(Archive& to, DrawnLife& life) {
  to(life.refused, life.unfinished, life.out_of_range, life.arrested, life.part.failure,
     life.part.times, life.part.sizes, life.part.weight);
}

/// The paths of the cracks that grow, and the part of a trace.
DrawnPart part_of(const LifeTrace& trace) {
  DrawnPart part{.times = trace.times, .sizes = trace.sizes};
  if (trace.life)
    part.failure = *trace.life;
  else if (trace.end == DriveEnd::range)
    part.failure = trace.time;
  return part;
}

class Study {
 public:
  Study(const GearSet& gear, const InspectionOptions& options)
      : gear_(gear), options_(options), normals_(scattering_normals(gear)) {
    for (const InputScatter& scatter : gear.scatter)
      laws_.emplace_back(scatter, number_at(gear, scatter.path).value);
  }

  [[nodiscard]] const CorrelatedNormals& normals() const { return normals_; }

  /// Whether a draw scatters about the failures (IR-16).
  [[nodiscard]] bool about_failures(std::size_t draw) const {
    return !centre_.empty() && draw % 2 == 1;
  }
  [[nodiscard]] std::vector<double> normals_of(std::size_t draw) const {
    std::vector<double> u(laws_.size());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = counter_normal(options_.seed, draw, i);
    if (about_failures(draw))
      for (std::size_t i = 0; i < u.size(); ++i) u[i] += centre_[i];
    return u;
  }

  /// Lets every other draw scatter about the failures up to a time (UQ-10).
  FailureCentre centre_draws(double until, const Progress& progress) {
    const auto make = [&]() -> LimitState {
      return [this, until, drive = std::make_shared<DrawnDrive>(gear_, gear_.scatter)](
                 std::span<const double> u) -> std::optional<double> {
        const DrawnLife life = life_at(*drive, {u.begin(), u.end()});
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

  /// The inputs at the centre of the failures, the most deviating first.
  [[nodiscard]] std::vector<FailureInput> inputs_at_centre() const {
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

  /// @param cracks  paths of the cracks that grow in the drive of the file
  [[nodiscard]] std::vector<DrawnLife> draws(const std::vector<std::string>& cracks,
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

 private:
  /// @param cracks  paths of the cracks that must grow; null: any
  [[nodiscard]] DrawnLife life_at(DrawnDrive& drive, std::vector<double> z,
                                  const std::vector<std::string>* cracks = nullptr) const {
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
      // Inspections find a crack by its place in the list of the file.
      result.refused = trace.end == DriveEnd::not_known || (cracks && trace.cracks != *cracks);
    } catch (const Error&) {
      result.refused = true;
    }
    return result;
  }

  const GearSet& gear_;
  const InspectionOptions& options_;
  std::vector<ScatterLaw> laws_;
  CorrelatedNormals normals_;
  std::vector<double> centre_;  ///< u* of the failures; empty: plain draws alone
};

void check_options(const InspectionOptions& options) {
  require(options.draws >= 20 && options.draws <= kMostDraws, "draws", options.draws, "1",
          ">= 20 and <= 1e6");
  if (options.until)
    require(*options.until > 0 && *options.until <= kLongestDuty, "until", *options.until, "s",
            "> 0 and <= a million years");
  const InspectionTimes& times = options.times;
  for (const double time : times.at)
    require(time > 0 && std::isfinite(time), "at", time, "s", "> 0");
  if (times.every)
    require(*times.every > 0 && std::isfinite(*times.every), "every", *times.every, "s", "> 0");
  if (times.first)
    require(*times.first > 0 && std::isfinite(*times.first), "first", *times.first, "s", "> 0");
  if (times.risk)
    require(*times.risk > 0 && *times.risk < 1, "risk", *times.risk, "1", "> 0 and < 1");
  require(times.most >= 1 && times.most <= 100, "most", times.most, "1", ">= 1 and <= 100");
  if (times.first && !times.every)
    throw InputError("first", "is read with the interval only; give every");
  if (times.every && !times.at.empty())
    throw InputError("every", "is given beside at; give one of them");
}

bool asks_for_inspections(const InspectionTimes& times) {
  return times.every || !times.at.empty() || times.risk;
}

/// How the cracks of a drive are looked for: as asked, or as its file says.
std::optional<Inspection> method_of(const GearSet& gear, const InspectionOptions& options) {
  const bool inspected = asks_for_inspections(options.times);
  if (!options.method) {
    if (inspected && !gear.inspection)
      throw InputError("a50",
                       "must be given for inspections, with a90, or the table [inspection] of the "
                       "file");
    return gear.inspection;
  }
  if (!inspected)
    throw InputError(is_measurement(options.method->method) ? "noise" : "a50",
                     "is read with inspections only; give at, every or risk");
  GearSet checked = gear;
  checked.inspection = options.method;
  check(checked);
  return options.method;
}

/// Which of the cracks of the histories an inspection sees.
std::vector<bool> seen_cracks(const std::vector<std::string>& cracks, const Inspection& method) {
  std::vector<bool> seen(cracks.size(), method.place.empty());
  for (std::size_t i = 0; i < method.place.size(); ++i) {
    const std::string& path = method.place[i].crack;
    const auto at = std::ranges::find(cracks, path);
    if (at == cracks.end())
      throw InputError(fmt::format("inspection.place[{}].crack", i),
                       fmt::format("\"{}\" is not a growing crack of this drive: {}", shown(path),
                                   shown(fmt::format("{}", fmt::join(cracks, ", ")))));
    seen[static_cast<std::size_t>(at - cracks.begin())] = true;
  }
  return seen;
}

std::optional<double> finite(double time) {
  return std::isfinite(time) ? std::optional(time) : std::nullopt;
}

/// Percentiles with limits by order statistics (IR-7).
void add_plain_percentiles(InspectionReport& report, const std::vector<double>& lives) {
  const auto n = static_cast<double>(lives.size());
  const auto at = [&](double rank) {
    const auto i = static_cast<std::size_t>(std::clamp(rank, 1.0, n)) - 1;
    return finite(lives[i]);
  };
  for (const double share : kShares) {
    const boost::math::binomial counts(n, share);
    LifePercentile row{.share = share, .life = at(std::ceil(n * share))};
    const double low = std::floor(boost::math::quantile(counts, kTail));
    const double high =
        std::ceil(boost::math::quantile(boost::math::complement(counts, kTail))) + 1;
    row.lower = low >= 1 ? at(low) : std::optional(0.0);
    row.upper = high <= n ? at(high) : std::nullopt;
    report.percentiles.push_back(row);
  }
}

/// Percentiles of weighted draws: the times at which the probability of failure and its limits
/// reach the share (IR-16).
void add_weighted_percentiles(InspectionReport& report, const std::vector<DrawnPart>& by_life) {
  double total = 0.0;
  for (const DrawnPart& part : by_life) total += part.weight;
  for (const double share : kShares) {
    LifePercentile row{.share = share, .lower = 0.0};
    bool low = false;  // whether a time is found
    bool middle = false;
    bool high = false;
    double sum = 0.0;
    double squares = 0.0;
    double further = 0.0;
    for (const DrawnPart& part : by_life) {
      sum += part.weight;
      squares += part.weight * part.weight;
      further = std::max(further, part.weight);
      const RiskEstimate risk = weighted_risk(sum, squares, further, total);
      const auto reach = [&](double probability, bool& found, std::optional<double>& time) {
        if (found || probability < share) return;
        found = true;
        time = finite(part.failure);
      };
      reach(risk.high, low, row.lower);
      reach(risk.probability, middle, row.life);
      reach(risk.low, high, row.upper);
    }
    report.percentiles.push_back(row);
  }
}

void add_percentiles(InspectionReport& report, const std::vector<DrawnPart>& parts) {
  std::vector<DrawnPart> by_life;
  for (const DrawnPart& part : parts)
    by_life.push_back({.failure = part.failure, .weight = part.weight});
  std::ranges::stable_sort(by_life, {}, &DrawnPart::failure);
  if (report.importance_sampling) return add_weighted_percentiles(report, by_life);
  std::vector<double> lives;
  for (const DrawnPart& part : by_life) lives.push_back(part.failure);
  add_plain_percentiles(report, lives);
}

/// Linear shares of the inputs in the scatter of the logarithm of the lives that end (IR-8).
void add_shares(InspectionReport& report, const GearSet& gear, const Study& study,
                const std::vector<DrawnLife>& draws) {
  const std::size_t inputs = gear.scatter.size();
  std::vector<double> logs;
  std::vector<double> weights;
  std::vector<std::vector<double>> normals;
  double total = 0.0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const DrawnPart& part = draws[i].part;
    if (draws[i].refused || !std::isfinite(part.failure) || part.failure <= 0) continue;
    logs.push_back(std::log(part.failure));
    weights.push_back(part.weight);
    normals.push_back(study.normals_of(i));
    total += part.weight;
  }
  if (logs.size() < 10 * inputs + 10) return;
  const auto mean_of = [&](const auto& value) {
    double sum = 0.0;
    for (std::size_t k = 0; k < logs.size(); ++k) sum += weights[k] / total * value(k);
    return sum;
  };
  const double mean = mean_of([&](std::size_t k) { return logs[k]; });
  const double variance =
      mean_of([&](std::size_t k) { return (logs[k] - mean) * (logs[k] - mean); });
  if (!(variance > 0)) return;
  std::vector<double> slope(inputs, 0.0);
  double linear = 0.0;
  for (std::size_t i = 0; i < inputs; ++i) {
    const double average = mean_of([&](std::size_t k) { return normals[k][i]; });
    const double with_log =
        mean_of([&](std::size_t k) { return (normals[k][i] - average) * (logs[k] - mean); });
    const double square = mean_of(
        [&](std::size_t k) { return (normals[k][i] - average) * (normals[k][i] - average); });
    slope[i] = with_log / square;
    linear += with_log * with_log / square;
  }
  const std::vector<double> shares = study.normals().shares(study.normals().slope_in_z(slope));
  for (std::size_t i = 0; i < inputs; ++i)
    report.shares.push_back(
        {.path = gear.scatter[i].path, .share = shares[i] * std::min(1.0, linear / variance)});
  std::ranges::stable_sort(report.shares, std::ranges::greater{}, &LifeShare::share);
}

/// Half of the time from the size a90 of the crack that ends the life to this end [s]; absent if
/// the life has no end, or if inspections do not see the crack.
std::optional<double> half_interval(const LifeTrace& trace, std::optional<double> a90,
                                    const std::vector<bool>& seen) {
  if (!a90) return std::nullopt;
  const auto governing = std::ranges::find(trace.cracks, trace.governing);
  if (!trace.life || governing == trace.cracks.end()) return std::nullopt;
  const auto k = static_cast<std::size_t>(governing - trace.cracks.begin());
  if (!seen[k]) return std::nullopt;
  const DrawnPart part = part_of(trace);
  if (part.size_at(k, *trace.life) < *a90) return 0.0;  // the part fails before a90
  double below = 0.0;
  double above = *trace.life;
  for (double middle = above / 2; below < middle && middle < above; middle = (below + above) / 2)
    (part.size_at(k, middle) >= *a90 ? above : below) = middle;
  return (*trace.life - above) / 2;
}

/// A curve of a form as points, from 1 % to 99 %, and the bound of trials (IR-13).
std::vector<DetectionPoint> points_of(const DetectionCurve& curve, const Inspection& method,
                                      const std::optional<DetectionFit>& trials) {
  std::vector<DetectionPoint> points;
  if (trials) {
    for (const FittedDetection& point : trials->points)
      points.push_back(
          {.size = point.size, .probability = point.probability, .bound = point.bound});
    return points;
  }
  constexpr int kPoints = 41;
  const double reach = method.detection == DetectionForm::log_normal
                           ? normal_quantile(0.99) / normal_quantile(0.9)
                           : std::log(99.0) / std::log(9.0);
  for (int i = 0; i < kPoints; ++i) {
    const double size =
        *method.a50 * std::pow(*method.a90 / *method.a50, reach * (2.0 * i / (kPoints - 1) - 1));
    points.push_back({.size = size, .probability = curve.at(size)});
  }
  return points;
}

/// The lower bound of a curve from trials; absent: the trials bound nothing (IR-13).
std::optional<DetectionCurve> bound_of(const DetectionFit& trials) {
  std::vector<double> sizes;
  std::vector<double> probabilities;
  for (const FittedDetection& point : trials.points) {
    if (!point.bound || (!sizes.empty() && *point.bound <= sizes.back())) continue;
    sizes.push_back(*point.bound);
    probabilities.push_back(point.probability);
  }
  if (sizes.empty()) return std::nullopt;
  return DetectionCurve(std::move(sizes), std::move(probabilities));
}

/// What inspections do to all parts together.
struct CourseSums {
  std::vector<double> in_service;  ///< of each inspection, share of all parts [-]
  std::vector<double> found;
  double failed = 0.0;
};

CourseSums course_sums(std::span<const DrawnPart> parts, double until,
                       std::span<const double> inspections, const CrackSearch& search) {
  CourseSums sums{.in_service = std::vector<double>(inspections.size(), 0.0),
                  .found = std::vector<double>(inspections.size(), 0.0)};
  double total = 0.0;
  for (const DrawnPart& part : parts) total += part.weight;
  for (const DrawnPart& part : parts) {
    const InspectedCourse course = inspected_course(part, until, inspections, search);
    const double share = part.weight / total;
    for (std::size_t k = 0; k < course.found.size(); ++k) {
      sums.in_service[k] += share * course.in_service[k];
      sums.found[k] += share * course.found[k];
    }
    sums.failed += share * course.failed;
  }
  return sums;
}

/// Expected cost of one drive (IR-15).
ExpectedCost cost_of(const InspectionCost& cost, const CourseSums& sums, double without,
                     double false_calls) {
  double inspections = 0.0;
  double calls = 0.0;
  for (std::size_t k = 0; k < sums.found.size(); ++k) {
    inspections += sums.in_service[k];
    calls += sums.found[k] + (sums.in_service[k] - sums.found[k]) * false_calls;
  }
  ExpectedCost expected{.without = without * cost.failure,
                        .inspections = inspections * cost.inspection,
                        .calls = calls * cost.call,
                        .failures = sums.failed * cost.failure};
  expected.inspected = *expected.inspections + *expected.calls + *expected.failures;  // (IR-15)
  return expected;
}

/// Number of cracks of a part that grow.
std::ptrdiff_t growing_cracks(const DrawnPart& part) {
  return std::ranges::count_if(
      part.sizes, [](const std::vector<double>& size) { return size.back() > size.front(); });
}

std::string hours(double seconds) { return fmt::format("{:.4g} h", seconds / 3600); }

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// What a measurement can find, in words; it ends with a full stop.
std::string measurement_words(const MethodOfInspection& method) {
  const std::string_view what = method.method == InspectionMeans::stiffness
                                    ? "the stiffness of the drive"
                                : method.method == InspectionMeans::resonance
                                    ? "the natural frequency of the drive"
                                    : "the difference of the stiffness between the senses";
  std::string words = fmt::format(
      "{} changes {} by {} at its last size before the failure, {}; nine of ten measurements find "
      "a change of {}",
      method.crack, what, percent(*method.change_at_end),
      shown_quantity(*method.size_at_end, "m", 4), percent(*method.change_ninety));
  if (method.a90)
    return words +
           fmt::format(", which the crack reaches at {}.", shown_quantity(*method.a90, "m", 4));
  return words + fmt::format(
                     ". The crack does not reach this change before the failure, so it {} in time: "
                     "one measurement just before the failure finds it in {} of the cases.",
                     *method.found_at_end < 0.5 ? "cannot be found so" : "is not surely found so",
                     percent(*method.found_at_end));
}

std::string risk_words(double probability, double low, double high) {
  return fmt::format("{:.3g} (95 % limits {:.2g} to {:.2g})", probability, low, high);
}

}  // namespace

InspectionReport inspection_report(const GearSet& gear, const InspectionOptions& options,
                                   const Progress& progress) {
  check_options(options);
  const std::optional<Inspection> method = method_of(gear, options);
  require_scatter(gear);
  if (!gear.duty)
    throw InputError("duty", "must be given; add [duty] with its [[duty.block]]s or a history");
  InspectionReport report;
  report.draws = options.draws;
  report.seed = options.seed;
  const LifeTrace nominal = life_trace(gear, options.growth);
  if (nominal.cracks.empty())
    throw InputError("duty",
                     "no crack of this drive grows by a known law, so no life can be drawn");
  report.nominal_life = nominal.life;
  if (!options.until && !nominal.life)
    throw InputError("until",
                     "must be given, because the life at the values of the file has no end");
  report.until = options.until.value_or(nominal.life.value_or(0.0));
  const auto before_end = [&](const char* field, double time) {
    require(time < report.until, FieldPath(field), time, "s",
            [&] { return fmt::format("before the end of service, {}", hours(report.until)); });
  };
  for (const double time : options.times.at) before_end("at", time);
  if (options.times.first)
    before_end("first", *options.times.first);
  else if (options.times.every)
    before_end("every", *options.times.every);
  if (options.times.every)
    require(*options.times.every * kMostInspections >= report.until, "every", *options.times.every,
            "s", "at most 1000 inspections up to the end of service");

  Study study(gear, options);
  if (options.importance_sampling) {
    if (nominal.life && *nominal.life <= report.until)
      throw InputError("importance-sampling",
                       fmt::format("is for rare failures, but the drive of the file fails before "
                                   "the end of service, after {}; give an earlier --until",
                                   hours(*nominal.life)));
    const FailureCentre centre = study.centre_draws(report.until, progress.part(0.0, 0.3));
    if (!centre.found)
      throw InputError("importance-sampling",
                       fmt::format("finds no failures up to {}: {}; give a later --until, or leave "
                                   "the option out",
                                   hours(report.until), centre.reason));
    report.importance_sampling = DrawsAboutFailures{
        .distance = std::sqrt(std::inner_product(centre.place.begin(), centre.place.end(),
                                                 centre.place.begin(), 0.0)),
        .rounds = centre.rounds,
        .inputs = study.inputs_at_centre()};
    report.equations = {"UQ-10", "UQ-11", "IR-16"};
  }
  std::vector<DrawnLife> draws =
      study.draws(nominal.cracks, options.importance_sampling ? progress.part(0.3, 1.0) : progress);
  std::vector<DrawnPart> parts;
  std::vector<DrawnPart>
      plain_draws;  // of importance sampling; their weights are those of plain draws
  for (std::size_t i = 0; i < draws.size(); ++i) {
    DrawnLife& draw = draws[i];
    if (draw.refused) {
      ++report.outcomes.refused;
      continue;
    }
    const bool by_end = draw.part.failure <= report.until;
    if (draw.arrested)
      ++report.outcomes.arrested;
    else if (draw.unfinished)
      ++report.outcomes.unfinished;
    else if (by_end)
      ++report.outcomes.failed;
    else
      ++report.outcomes.later;
    if (draw.out_of_range) ++report.outcomes.out_of_range;
    if (options.importance_sampling && !study.about_failures(i))
      plain_draws.push_back({.failure = draw.part.failure});
    parts.push_back(draw.part);
  }
  if (parts.size() < 20)
    throw InputError("scatter", fmt::format("lets {} of {} drawn drives break a rule of the input, "
                                            "so too few lives are left; narrow the scatter",
                                            report.outcomes.refused, options.draws));
  add_percentiles(report, parts);
  add_shares(report, gear, study, draws);
  report.equations.insert(report.equations.end(), {"IR-3", "IR-7", "IR-8"});

  std::vector<double> schedule = options.times.at;
  std::ranges::sort(schedule);
  std::optional<CrackSearch> search;
  const auto planned_cost = [&](std::span<const DrawnPart> of, std::span<const double> times) {
    return cost_of(method->cost.value_or(InspectionCost{}),
                   course_sums(of, report.until, times, *search),
                   failure_risk(of, report.until).probability, report.method->false_calls);
  };
  if (method) {
    report.method = MethodOfInspection{};
    if (is_measurement(method->method)) {
      try {
        const auto governing = std::ranges::find(nominal.cracks, nominal.governing);
        if (governing == nominal.cracks.end()) refuse_without_end(method->method);
        const auto k = static_cast<std::size_t>(governing - nominal.cracks.begin());
        double smallest = std::numeric_limits<double>::infinity();
        for (const DrawnPart& part : parts) smallest = std::min(smallest, part.sizes[k].front());
        MeasuredDetection measured =
            measured_detection(gear, *method, options.growth, smallest, Progress());
        std::vector<bool> seen(nominal.cracks.size(), false);
        seen[k] = true;
        search = CrackSearch{.curve = std::move(measured.curve), .seen = std::move(seen)};
        report.method = std::move(measured.stated);
        report.equations.insert(report.equations.end(), {"IR-4", "IR-10", "IR-11"});
      } catch (const InputError& error) {  // lives and risk need no measurement
        if (asks_for_inspections(options.times)) throw;
        report.method.reset();
        report.notes.push_back(
            {.code = "inspection.no_measurement",
             .text = fmt::format("the measurement is left out: {}", error.what()),
             .path = "inspection.method",
             .equation = "IR-10",
             .severity = Severity::care});
      }
    } else {
      search = CrackSearch{
          .curve = DetectionCurve(method->detection.value_or(DetectionForm::log_logistic),
                                  *method->a50, *method->a90),
          .seen = seen_cracks(nominal.cracks, *method)};
      report.method->a50 = method->a50;
      report.method->a90 = method->a90;
      report.method->false_calls = method->false_calls.value_or(0.0);
      report.method->points = points_of(search->curve, *method, options.trials);
      report.equations.insert(report.equations.end(), {"IR-1", "IR-2", "IR-4"});
      if (options.trials) {
        report.method->a50_bound = options.trials->a50_bound;
        report.method->a90_bound = options.trials->a90_bound;
        report.method->trials = options.trials->trials;
        report.equations.insert(report.equations.end(),
                                {options.trials->of_signals ? "IR-14" : "IR-12", "IR-13"});
      }
    }
  }
  if (search) {
    search->repaired_to = method->repaired_to;
    report.method->find = method->find;
    report.method->repaired_to = method->repaired_to;
    if (method->repaired_to) report.equations.emplace_back("IR-9");
    if (options.times.every)
      schedule = equal_inspections(options.times.first.value_or(*options.times.every),
                                   *options.times.every, report.until);
    if (options.times.risk) {
      const auto add = [&](std::string kind, const InspectionPlan& plan,
                           std::span<const DrawnPart> of) {
        PlannedInspections& row = report.plans.emplace_back(
            PlannedInspections{.kind = std::move(kind),
                               .reached = plan.reached,
                               .inspections = static_cast<int>(plan.times.size()),
                               .times = plan.times,
                               .risk = plan.risk.probability,
                               .risk_low = plan.risk.low,
                               .risk_high = plan.risk.high});
        if (method->cost) row.cost = planned_cost(of, plan.times).inspected;
        return plan.times;
      };
      const auto most = static_cast<std::size_t>(options.times.most);
      const double wanted = *options.times.risk;
      const std::span<const DrawnPart> all = parts;
      const std::vector<double> equal =
          add("equal", equal_plan(parts, report.until, wanted, most, *search), all);
      const std::size_t half = all.size() / 2;
      add("least",
          least_plan(all.first(half), all.subspan(half), report.until, wanted, most, *search),
          all.subspan(half));
      report.equations.insert(report.equations.end(), {"IR-5", "IR-6"});
      if (schedule.empty()) schedule = equal;
    }
    report.half_interval = half_interval(nominal, report.method->a90, search->seen);
  }

  const auto point_at = [&](double time) {
    const RiskEstimate without = failure_risk(parts, time);
    RiskPoint point{.time = time,
                    .without = without.probability,
                    .without_low = without.low,
                    .without_high = without.high};
    if (schedule.empty()) return point;
    const RiskEstimate with = inspected_risk(parts, time, schedule, *search);
    point.inspected = with.probability;
    point.inspected_low = with.low;
    point.inspected_high = with.high;
    return point;
  };
  for (int i = 0; i < kRiskPoints; ++i)
    report.risk.push_back(point_at(report.until * i / (kRiskPoints - 1)));
  report.at_end = point_at(report.until);
  if (report.importance_sampling) {
    DrawsAboutFailures& about = *report.importance_sampling;
    const RiskEstimate plain = failure_risk(plain_draws, report.until);
    about.plain_draws = static_cast<int>(plain_draws.size());
    about.plain = plain.probability;
    about.plain_low = plain.low;
    about.plain_high = plain.high;
  }
  if (!schedule.empty()) {
    const CourseSums sums = course_sums(parts, report.until, schedule, *search);
    for (std::size_t k = 0; k < schedule.size(); ++k) {
      const std::span<const double> up_to(schedule.data(), k + 1);
      report.inspections.push_back(
          {.time = schedule[k],
           .found = sums.found[k],
           .in_service = sums.in_service[k],
           .false_call = (sums.in_service[k] - sums.found[k]) * report.method->false_calls,
           .remaining = inspected_risk(parts, report.until, up_to, *search).probability});
    }
    if (options.trials)
      if (const std::optional<DetectionCurve> bound = bound_of(*options.trials)) {
        CrackSearch low = *search;
        low.curve = *bound;
        report.bound_risk = inspected_risk(parts, report.until, schedule, low).probability;
      }
  }
  if (search && method->cost) {
    report.cost = planned_cost(parts, schedule);
    if (schedule.empty()) report.cost = ExpectedCost{.without = report.cost->without};
    report.equations.emplace_back("IR-15");
  }

  const int total = static_cast<int>(parts.size());
  report.sentence = fmt::format(
      "Up to {} the probability of failure is {}", hours(report.until),
      risk_words(report.at_end.without, report.at_end.without_low, report.at_end.without_high));
  if (report.at_end.inspected)
    report.sentence +=
        fmt::format(" without inspections, and {} with {}",
                    risk_words(*report.at_end.inspected, *report.at_end.inspected_low,
                               *report.at_end.inspected_high),
                    schedule.size() == 1 ? std::string("one inspection")
                                         : fmt::format("{} inspections", schedule.size()));
  report.sentence += ".";
  if (report.method && report.method->change_at_end) {
    report.sentence += " The crack " + measurement_words(*report.method);
    if (report.method->method != InspectionMeans::resonance)
      report.notes.push_back(
          {.code = "inspection.series",
           .text = "the change of the stiffness is that of the members in series; the contacts of "
                   "the teeth and other parts make the change of the whole drive smaller",
           .path = "inspection.method",
           .equation = "IR-10",
           .severity = Severity::care,
           .next_step = "Compare with the coupled drive, strainwave torsion --compare."});
    const bool several =
        schedule.size() > 1 ||
        std::ranges::any_of(report.plans, [](const auto& plan) { return plan.inspections > 1; });
    if (several && report.method->method != InspectionMeans::one_sided_stiffness)
      report.notes.push_back(
          {.code = "inspection.record",
           .text = "the error of the first record of a drive is the same in all of its "
                   "inspections, and it is left out; the risk is then too low",
           .path = "inspection.noise",
           .equation = "IR-11",
           .severity = Severity::care,
           .next_step = "Take the mean of many measurements as the first record."});
    if (!report.method->a90)
      report.notes.push_back(
          {.code = "inspection.not_found",
           .text = measurement_words(*report.method),
           .path = report.method->crack,
           .equation = "IR-11",
           .severity = Severity::care,
           .next_step = "Look for the crack itself, or measure with less noise."});
  }
  if (report.bound_risk)
    report.sentence += fmt::format(
        " With the lower 95 % bound of detection at each size, it is {:.3g}.", *report.bound_risk);
  if (report.method && report.method->trials && !report.method->a90_bound)
    report.notes.push_back(
        {.code = "inspection.trials",
         .text = fmt::format("{} trials do not bound the size a90 with 95 % confidence",
                             *report.method->trials),
         .path = "detection-data",
         .equation = "IR-13",
         .severity = Severity::care,
         .next_step = "Try more cracks, over a wider range of sizes."});
  if (search && search->repaired_to) {
    const auto several = std::ranges::count_if(
        parts, [](const DrawnPart& part) { return growing_cracks(part) > 1; });
    if (several > 0)
      report.notes.push_back(
          {.code = "inspection.other_cracks",
           .text = fmt::format(
               "in {} of {} drives several cracks grow, and the path of each is known up to the "
               "first failure only; after a repair a drive counts as failed when another crack "
               "reaches this age, so the risk may be too high",
               several, parts.size()),
           .path = "inspection.repaired_to",
           .equation = "IR-9",
           .severity = Severity::information});
    const auto larger = std::ranges::count_if(parts, [&](const DrawnPart& part) {
      for (std::size_t k = 0; k < part.sizes.size(); ++k)
        if (search->seen[k] && part.sizes[k].front() > *search->repaired_to) return true;
      return false;
    });
    if (larger > 0)
      report.notes.push_back(
          {.code = "inspection.first_size",
           .text =
               fmt::format("in {} of {} drives a crack is larger than {} at first, and its path "
                           "from there on is not known; a repair reduces it to its first size",
                           larger, parts.size(), shown_quantity(*search->repaired_to, "m", 4)),
           .path = "inspection.repaired_to",
           .equation = "IR-9",
           .severity = Severity::information});
  }
  if (report.outcomes.arrested > 0)
    report.notes.push_back(
        {.code = "inspection.arrested",
         .text =
             fmt::format("in {} of {} drives no crack grows any more; their life has no end and "
                         "is in no mean",
                         report.outcomes.arrested, total),
         .path = "duty",
         .equation = "IR-7",
         .severity = Severity::information});
  if (report.outcomes.out_of_range > 0)
    report.notes.push_back(
        {.code = "inspection.range",
         .text =
             fmt::format("in {} of {} drives a crack leaves the range of its solution, where the "
                         "rest is not known; this counts as a failure at that time",
                         report.outcomes.out_of_range, total),
         .path = nominal.governing,
         .equation = "IR-3",
         .severity = Severity::care});
  if (report.outcomes.refused > 0)
    report.notes.push_back(
        {.code = "inspection.refused",
         .text = fmt::format(
             "{} of {} draws break a rule of the input, or have no answer, and are left out",
             report.outcomes.refused, options.draws),
         .path = "scatter",
         .equation = "IR-3",
         .severity = Severity::care,
         .next_step = "Narrow the scatter, or use a distribution without such values."});
  const double wanted = options.times.risk.value_or(0.0);
  const bool resolved = options.times.risk
                            ? std::ranges::all_of(report.plans,
                                                  [&](const PlannedInspections& plan) {
                                                    return plan.reached && plan.risk_high <= wanted;
                                                  })
                            : report.at_end.without_low > 0;
  if (!resolved)
    report.notes.push_back(
        {.code = "inspection.draws",
         .text =
             options.times.risk
                 ? "the upper limit of the risk of a plan is above the wanted risk, or the plan "
                   "does not reach it, so the plan is not proven"
                 : "no drawn drive fails, so only the upper limit of the risk is known",
         .path = "",
         .equation = "IR-4",
         .severity = Severity::cannot_tell,
         .next_step =
             options.importance_sampling ? "Ask for more --draws."
             : options.times.risk
                 ? fmt::format("Plan for a smaller --risk, whose upper limit is below the wanted "
                               "one, with --importance-sampling or more than {} draws; the plan at "
                               "times of least risk needs twice as many.",
                               static_cast<std::int64_t>(std::ceil(3.69 / wanted)))
                 : "Give --importance-sampling, or ask for more --draws."});
  if (report.importance_sampling) {
    const int plain_draws = report.importance_sampling->plain_draws;
    report.notes.push_back(
        {.code = "inspection.importance",
         .text = fmt::format("every other draw scatters about the failures that were found; the {} "
                             "plain draws do not exclude that other ones, far from these, add up "
                             "to {:.2g} to the probability",
                             plain_draws, 1 - std::pow(kTail, 1.0 / plain_draws)),
         .path = "scatter",
         .equation = "IR-16",
         .severity = Severity::care,
         .next_step = "Ask for more --draws if failures may have several causes."});
  }
  return report;
}

}  // namespace strainwave

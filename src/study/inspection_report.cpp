// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/inspection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <utility>

#include "drawn_lives.hpp"
#include "drawn_outputs.hpp"
#include "inspection_notes.hpp"
#include "measured_detection.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/drive_growth/longest_duty.hpp"
#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

constexpr double kTail = 0.025;
constexpr int kRiskPoints = 61;
/// A drawn history takes about two kilobytes.
constexpr int kMostDraws = 1'000'000;
constexpr double kMostInspections = 1000;
constexpr std::array kShares = {0.01, 0.1, 0.5, 0.9};

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
void add_weighted_percentiles(InspectionReport& report, const std::vector<DrawnPart>& by_life,
                              double further) {
  std::vector<RiskEstimate> up_to(by_life.size());  // the failures up to each of the lives
  std::vector<WeightSums> after(by_life.size() + 1);
  for (std::size_t i = by_life.size(); i-- > 0;) {
    after[i] = after[i + 1];
    after[i].add(by_life[i].weight);
  }
  WeightSums failing;
  for (std::size_t i = 0; i < by_life.size(); ++i) {
    failing.add(by_life[i].weight);
    up_to[i] = weighted_risk(failing, after[i + 1], further);
  }
  for (const double share : kShares) {
    const auto time_of = [&](double RiskEstimate::*probability) -> std::optional<double> {
      const auto at = std::ranges::find_if(
          up_to, [&](const RiskEstimate& risk) { return risk.*probability >= share; });
      if (at == up_to.end()) return std::nullopt;
      return finite(by_life[static_cast<std::size_t>(at - up_to.begin())].failure);
    };
    const bool before_all = up_to.front().high >= share;  // not bounded by the first life
    report.percentiles.push_back(
        {.share = share,
         .life = time_of(&RiskEstimate::probability),
         .lower = before_all ? std::optional(0.0) : time_of(&RiskEstimate::high),
         .upper = time_of(&RiskEstimate::low)});
  }
}

void add_percentiles(InspectionReport& report, const PartSample& sample) {
  std::vector<DrawnPart> by_life;
  for (const DrawnPart& part : sample.parts)
    by_life.push_back({.failure = part.failure, .weight = part.weight});
  std::ranges::stable_sort(by_life, {}, &DrawnPart::failure);
  if (report.importance_sampling) return add_weighted_percentiles(report, by_life, sample.further);
  std::vector<double> lives;
  for (const DrawnPart& part : by_life) lives.push_back(part.failure);
  add_plain_percentiles(report, lives);
}

/// Linear shares of the inputs in the scatter of the logarithm of the lives that end (IR-8).
void add_shares(InspectionReport& report, const DrawnLives& study,
                const std::vector<DrawnLife>& draws) {
  const std::vector<std::string> paths = study.inputs();
  const std::size_t inputs = paths.size();
  std::vector<double> logs;
  std::vector<double> weights;
  std::vector<std::vector<double>> normals;
  WeightSums sums;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const DrawnPart& part = draws[i].part;
    if (draws[i].refused || !std::isfinite(part.failure) || part.failure <= 0) continue;
    logs.push_back(std::log(part.failure));
    weights.push_back(part.weight);
    normals.push_back(study.normals_of(i));
    sums.add(part.weight);
  }
  // The number of plain draws that would be as precise.
  const double worth = sums.squares > 0 ? sums.sum * sums.sum / sums.squares : 0.0;
  if (worth < static_cast<double>(10 * inputs + 10)) return;
  const auto mean_of = [&](const auto& value) {
    double sum = 0.0;
    for (std::size_t k = 0; k < logs.size(); ++k) sum += weights[k] / sums.sum * value(k);
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
        {.path = paths[i], .share = shares[i] * std::min(1.0, linear / variance)});
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

CourseSums course_sums(const PartSample& sample, double until, std::span<const double> inspections,
                       const CrackSearch& search) {
  CourseSums sums{.in_service = std::vector<double>(inspections.size(), 0.0),
                  .found = std::vector<double>(inspections.size(), 0.0)};
  const double total = sample.total_weight();
  for (const DrawnPart& part : sample.parts) {
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

}  // namespace

InspectionReport inspection_report(const GearSet& gear, const InspectionOptions& options,
                                   const Progress& progress) {
  check_options(options);
  const std::optional<Inspection> method = method_of(gear, options);
  if (!growth_scatters(gear)) require_scatter(gear);
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
            [&] { return fmt::format("before the end of service, {}", hours_text(report.until)); });
  };
  for (const double time : options.times.at) before_end("at", time);
  if (options.times.first)
    before_end("first", *options.times.first);
  else if (options.times.every)
    before_end("every", *options.times.every);
  if (options.times.every)
    require(*options.times.every * kMostInspections >= report.until, "every", *options.times.every,
            "s", "at most 1000 inspections up to the end of service");

  DrawnLives study(gear, options);
  double further = 1.0;  // weight of a further drive that may fail
  if (options.importance_sampling) {
    const double life = part_of(nominal).failure;
    if (!options.until)
      throw InputError("importance-sampling",
                       fmt::format("needs --until, an end of service before the life at the values "
                                   "of the file, {}",
                                   hours_text(life)));
    if (life <= report.until)
      throw InputError("importance-sampling",
                       fmt::format("is for rare failures, but the drive of the file fails before "
                                   "the end of service, after {}; give an earlier --until",
                                   hours_text(life)));
    const FailureCentres found =
        study.centre_draws(report.until, nominal.cracks, progress.part(0.0, 0.6));
    if (found.places.empty())
      throw InputError("importance-sampling",
                       fmt::format("finds no failures up to {}: {}; leave the option out, or give "
                                   "another --until",
                                   hours_text(report.until), found.reason));
    report.importance_sampling =
        DrawsAboutFailures{.centres = study.centres(), .rounds = found.rounds};
    report.equations = {"UQ-10", "UQ-11", "IR-16"};
    further = found.heaviest;
  }
  std::vector<DrawnLife> draws =
      study.draws(nominal.cracks, options.importance_sampling ? progress.part(0.6, 1.0) : progress);
  if (options.rows != nullptr) study.write_lives(draws, nominal.cracks, *options.rows);
  std::vector<DrawnPart> parts;
  std::vector<DrawnPart> plain_draws;  // beside those about the failures
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
    // The failure and the weight of the draw stay behind for its shares.
    parts.push_back(std::move(draw.part));
  }
  if (parts.size() < 20)
    throw InputError("scatter", fmt::format("lets {} of {} drawn drives break a rule of the input, "
                                            "so too few lives are left; narrow the scatter",
                                            report.outcomes.refused, options.draws));
  if (options.importance_sampling) {
    if (plain_draws.empty())
      throw InputError("scatter",
                       "lets all plain draws break a rule of the input; narrow the scatter");
    for (const DrawnPart& part : parts)
      if (part.failure <= report.until) further = std::max(further, part.weight);  // (IR-16)
  }
  const PartSample sample(parts, further);
  add_percentiles(report, sample);
  add_shares(report, study, draws);
  report.equations.insert(report.equations.end(), {"IR-3", "IR-8"});
  if (growth_scatters(gear)) report.equations.insert(report.equations.end(), {"GS-12", "GS-13"});
  if (!options.importance_sampling) report.equations.emplace_back("IR-7");

  std::vector<double> schedule = options.times.at;
  std::ranges::sort(schedule);
  std::optional<CrackSearch> search;
  const auto planned_cost = [&](const PartSample& of, std::span<const double> times) {
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
        report.method->bound_equation = options.trials->equations.back();
        if (options.trials->below + options.trials->above > 0) {
          report.method->below_floor = options.trials->below;
          report.method->above_ceiling = options.trials->above;
        }
        report.equations.insert(report.equations.end(), options.trials->equations.begin(),
                                options.trials->equations.end());
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
      const auto add = [&](std::string kind, const InspectionPlan& plan, const PartSample& of) {
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
      const std::vector<double> equal =
          add("equal", equal_plan(sample, report.until, wanted, most, *search), sample);
      const std::size_t half = parts.size() / 2;
      const PartSample judging(sample.parts.subspan(half), further);
      add("least",
          least_plan(PartSample(sample.parts.first(half), further), judging, report.until, wanted,
                     most, *search),
          judging);
      report.equations.insert(report.equations.end(), {"IR-5", "IR-6"});
      if (schedule.empty()) schedule = equal;
    }
    report.half_interval = half_interval(nominal, report.method->a90, search->seen);
  }

  const auto point_at = [&](double time) {
    const RiskEstimate without = failure_risk(sample, time);
    RiskPoint point{.time = time,
                    .without = without.probability,
                    .without_low = without.low,
                    .without_high = without.high};
    if (schedule.empty()) return point;
    const RiskEstimate with = inspected_risk(sample, time, schedule, *search);
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
    about.elsewhere = 1 - std::pow(kTail, 1.0 / about.plain_draws);
  }
  if (!schedule.empty()) {
    const CourseSums sums = course_sums(sample, report.until, schedule, *search);
    for (std::size_t k = 0; k < schedule.size(); ++k) {
      const std::span<const double> up_to(schedule.data(), k + 1);
      report.inspections.push_back(
          {.time = schedule[k],
           .found = sums.found[k],
           .in_service = sums.in_service[k],
           .false_call = (sums.in_service[k] - sums.found[k]) * report.method->false_calls,
           .remaining = inspected_risk(sample, report.until, up_to, *search).probability});
    }
    if (options.trials)
      if (const std::optional<DetectionCurve> bound = bound_of(*options.trials)) {
        CrackSearch low = *search;
        low.curve = *bound;
        report.bound_risk = inspected_risk(sample, report.until, schedule, low).probability;
      }
  }
  if (search && method->cost) {
    report.cost = planned_cost(sample, schedule);
    if (schedule.empty()) report.cost = ExpectedCost{.without = report.cost->without};
    report.equations.emplace_back("IR-15");
  }

  add_inspection_notes(report, {.options = options,
                                .parts = parts,
                                .governing = nominal.governing,
                                .search = search ? &*search : nullptr,
                                .inspections = schedule.size()});
  return report;
}

}  // namespace strainwave

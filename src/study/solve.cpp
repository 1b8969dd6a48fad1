// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/study/sweep.hpp"
#include "strainwave/study/varied_series.hpp"

namespace strainwave {
namespace {

// --- Outputs by name ------------------------------------------------------------------------

// --- The output as a function of the sought number --------------------------------------------

enum class State {
  refused,   // the method gives no result
  unusable,  // the result must not be used
  usable,
};

struct Sample {
  double x = 0.0;
  State state = State::refused;
  double y = 0.0;  // the output; not set if refused
  std::string reason = {};
};

class Probe {
 public:
  Probe(const GearSet& gear, Method method, std::string path, const Target& target, int n_scan,
        const Progress& progress)
      : gear_(gear),
        method_(method),
        path_(std::move(path)),
        target_(target),
        over_turn_(is_over_turn(target.output)),
        n_scan_(n_scan),
        progress_(progress),
        plan_(plan_for(gear, method, path_, target.output)) {
    if (plan_) planned_.emplace(*plan_);
  }

  /// The whole result, with the coupled drive.
  [[nodiscard]] StiffnessResult result(double x) { return result(x, {.over_turn = over_turn_}); }

  [[nodiscard]] Sample sample(double x) {
    // Progress counts the scan and about as many evaluations for its refinement.
    progress_.at(std::min(1.0, ++n_samples_ / (2.0 * n_scan_)));
    // The plan computes the same bits without a report; a value without an answer needs the reason.
    if (double y = 0.0;
        planned_ && (*planned_)({&x, 1}, {&y, 1}) == Fate::evaluated && std::isfinite(y))
      return {.x = x, .state = State::usable, .y = y};
    try {
      const StiffnessResult at_x = result(x, {.coupled_drive = is_of_coupled_drive(target_.output),
                                              .over_turn = over_turn_,
                                              .life = is_of_life(target_.output)});
      const std::optional<Quantity> output = output_named(at_x, target_.output);
      if (!output || !std::isfinite(output->value))
        return {.x = x, .reason = target_.output + " has no finite value"};
      return {.x = x,
              .state = at_x.usable() ? State::usable : State::unusable,
              .y = output->value,
              .reason = at_x.unusable_because};
    } catch (const Error& error) {
      return {.x = x, .reason = error.what()};
    }
  }

  /// The output alone; NaN if the method refuses.
  [[nodiscard]] double output(double x) {
    const Sample s = sample(x);
    return s.state == State::refused ? std::numeric_limits<double>::quiet_NaN() : s.y;
  }

 private:
  /// The plan of the drive for this output; absent if it does not cover it, or if the file needs
  /// the sought number to keep a rule.
  static std::optional<VariedSeries> plan_for(const GearSet& gear, Method method,
                                              const std::string& path, const std::string& output) {
    if (method != Method::corrected || !VariedSeries::covers(std::span(&output, 1)) ||
        !VariedSeries::can_vary(std::span(&path, 1)))
      return std::nullopt;
    try {
      check(gear);
    } catch (const InputError&) {
      return std::nullopt;
    }
    return VariedSeries(gear, {path}, {output});
  }
  [[nodiscard]] StiffnessResult result(double x, const EvaluationOptions& options) {
    set_number(gear_, path_, x);
    return evaluate(gear_, method_, options);
  }

  GearSet gear_;
  Method method_;
  std::string path_;
  Target target_;
  bool over_turn_;
  int n_scan_;
  int n_samples_ = 0;
  const Progress& progress_;
  std::optional<VariedSeries> plan_;
  std::optional<VariedSeries::Evaluator> planned_;
};

using Samples = std::vector<Sample>;

// --- Where to look ---------------------------------------------------------------------------

void append_spaced(std::vector<double>& points, double from, double to, int n, Spacing spacing) {
  const Variation between{.path = {}, .from = from, .to = to, .n_points = n, .spacing = spacing};
  for (int i = 0; i < n; ++i) points.push_back(between.value(i));
}

/// Points over a range that the user gives.
std::vector<double> points_within(const SearchRange& range, int n) {
  const auto [lower, upper] = std::minmax(range.from, range.to);
  // Use equal ratios if the range covers more than one decade.
  const bool decades = (lower > 0 && upper > 10 * lower) || (upper < 0 && lower < 10 * upper);
  std::vector<double> points;
  append_spaced(points, lower, upper, n, decades ? Spacing::logarithmic : Spacing::linear);
  return points;
}

/// Points round the present value; see Unknown::range.
std::vector<double> points_round(const NumberAt& number, int n) {
  const Range& range = number.field.range;
  std::vector<double> points;
  if (std::isfinite(range.lower) && std::isfinite(range.upper)) {
    append_spaced(points, range.lower, range.upper, n, Spacing::linear);
    return points;
  }
  const double scale = std::abs(number.value);
  if (scale == 0)
    throw InputError(
        vary_option(number.path),
        fmt::format("is 0, from which no range can be chosen; give one: {}=FROM..TO", number.path));
  constexpr double kReach = 1e3;
  const auto append_decades = [&](double sign, double lower, double upper) {
    if (upper > lower) append_spaced(points, sign * lower, sign * upper, n, Spacing::logarithmic);
  };
  append_decades(1.0, std::max(scale / kReach, range.lower), std::min(scale * kReach, range.upper));
  append_decades(-1.0, std::max(scale / kReach, -range.upper),
                 std::min(scale * kReach, -range.lower));
  if (range.contains(0.0)) points.push_back(0.0);
  return points;
}

std::vector<double> scan_points(const NumberAt& number, const Unknown& unknown, int n) {
  std::vector<double> points =
      unknown.range ? points_within(*unknown.range, n) : points_round(number, n);
  const auto [lower, upper] = std::ranges::minmax(points);
  if (number.value > lower && number.value < upper) points.push_back(number.value);
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// --- Ends of stretches, turning points ---------------------------------------------------------

/// Narrows [a, b], whose ends differ in state, to rounding; near zero, to `resolution`.
std::pair<Sample, Sample> end_of_stretch(Probe& probe, Sample a, Sample b, double resolution) {
  const State state = a.state;
  for (;;) {
    const double width = b.x - a.x;
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a.x), std::abs(b.x));
    if (width <= std::max(rounding, resolution)) return {std::move(a), std::move(b)};
    Sample middle = probe.sample(a.x + width / 2);
    (middle.state == state ? a : b) = std::move(middle);
  }
}

/// The samples, with the ends of each stretch of one state added.
Samples with_ends(Probe& probe, Samples samples) {
  const double resolution = 1e-15 * (samples.back().x - samples.front().x);
  Samples result;
  for (Sample& next : samples) {
    // More than one change may lie between two samples.
    constexpr int kMaxChanges = 8;
    for (int i = 0; i < kMaxChanges && !result.empty() && result.back().state != next.state; ++i) {
      if (next.x - result.back().x <= resolution) break;
      auto [last, first] = end_of_stretch(probe, result.back(), next, resolution);
      if (last.x > result.back().x) result.push_back(std::move(last));
      if (first.x >= next.x) break;
      result.push_back(std::move(first));
    }
    result.push_back(std::move(next));
  }
  return result;
}

/// The samples, with the extrema of the output added, because two solutions may lie close together
/// on either side of an extremum.
Samples with_turning_points(Probe& probe, const Samples& samples) {
  Samples result;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    result.push_back(samples[i]);
    if (i == 0 || i + 1 == samples.size()) continue;
    const Sample& before = samples[i - 1];
    const Sample& here = samples[i];
    const Sample& after = samples[i + 1];
    if (here.state == State::refused || before.state != here.state || after.state != here.state)
      continue;
    const double rise = here.y - before.y;
    const double fall = here.y - after.y;
    const double rounding = 1e-12 * std::abs(here.y);
    if (!(rise * fall > 0) || std::min(std::abs(rise), std::abs(fall)) < rounding) continue;
    const double sign = rise > 0 ? -1.0 : 1.0;
    constexpr int kBits = 26;  // accuracy of the place; the value there is accurate to all digits
    const double x =
        boost::math::tools::brent_find_minima([&](double at) { return sign * probe.output(at); },
                                              before.x, after.x, kBits)
            .first;
    Sample turn = probe.sample(x);
    if (turn.state != here.state || turn.x == here.x) continue;
    if (turn.x > here.x)
      result.push_back(std::move(turn));
    else
      result.insert(result.end() - 1, std::move(turn));
  }
  std::ranges::sort(result, {}, &Sample::x);
  return result;
}

// --- Solutions ---------------------------------------------------------------------------------

/// Whether the output is continuous at `x`.  Over a step a thousand times wider than rounding, a
/// continuous output changes far more than over a step of rounding.
bool continuous_at(Probe& probe, double x, double lower, double upper, double scale) {
  const double rounding = 1e-15 * std::max(std::abs(x), upper - lower);
  const auto change = [&](double step) {
    return std::abs(probe.output(std::min(x + step, upper)) -
                    probe.output(std::max(x - step, lower)));
  };
  const double narrow = change(rounding);
  // Changes within the tolerance of the crack integrals are not jumps.
  return narrow <= 1e-9 * scale || narrow <= 0.5 * change(1000 * rounding);
}

/// d output/d x by a central difference, one-sided at the end of a stretch; NaN if it cannot be
/// computed.
double slope_at(Probe& probe, const Sample& at) {
  const double step = 1e-4 * std::abs(at.x);
  const auto neighbour = [&](double x) {
    Sample s = probe.sample(x);
    return s.state == State::refused ? at : s;
  };
  const Sample a = neighbour(at.x - step);
  const Sample b = neighbour(at.x + step);
  return (b.y - a.y) / (b.x - a.x);
}

/// From this value on, an accuracy to first order has no meaning [-].
constexpr double kMostAccuracy = 1.0;

Solution solution_at(Probe& probe, const Sample& at, SolveResult& problem) {
  Solution solution{.value = {at.x, problem.unit}, .output = {}, .result = probe.result(at.x)};
  solution.output = *output_named(solution.result, problem.target.output);
  if (solution.output.relative_uncertainty) {
    const double u = std::abs(*solution.output.relative_uncertainty * solution.output.value /
                              (at.x * slope_at(probe, at)));
    if (std::isfinite(u) && u <= kMostAccuracy)
      solution.value.relative_uncertainty = u;
    else if (problem.notes.empty())
      problem.notes.push_back(
          {.code = "solve.accuracy",
           .text = fmt::format(
               "the accuracy of this solution cannot be told, because to first order a change of "
               "the field by 100 % changes {} by less than the uncertainty of {}",
               problem.target.output, percent(*solution.output.relative_uncertainty)),
           .path = problem.path,
           .equation = "ST-16",
           .severity = Severity::cannot_tell,
           .next_step =
               "Choose an output that depends more on this field or has a smaller uncertainty."});
  }
  return solution;
}

constexpr int kDigits = 6;

/// A number of the gear or an output for people, such as "3.66 mm".
std::string shown_at(std::string_view name, double value, std::string_view si) {
  return shown_quantity(value, si, kDigits, name);
}

/// A range such as "1 mm to 2 mm", with enough digits to distinguish both ends.
std::string span_shown(std::string_view name, double from, double to, std::string_view si,
                       std::string_view between) {
  constexpr int kAllDigits = 17;
  for (int digits = kDigits;; ++digits) {
    const std::string first = shown_quantity(from, si, digits, name);
    const std::string last = shown_quantity(to, si, digits, name);
    if (first != last || digits == kAllDigits) return fmt::format("{} {} {}", first, between, last);
  }
}

/// Collects solutions, and remarks on values that do not count as solutions.
class Findings {
 public:
  Findings(Probe& probe, SolveResult& result) : probe_(probe), result_(result) {}

  void found(const Sample& at) {
    if (at.state == State::usable)
      result_.solutions.push_back(solution_at(probe_, at, result_));
    else
      remark(fmt::format("{} = {} would give {}, but its result may not be used: {}", result_.path,
                         input(at.x), wanted(), at.reason));
  }

  void found_everywhere(double from, double to) {
    remark(fmt::format("{} over the whole range from {} = {}", wanted(), result_.path,
                       span_shown(result_.path, from, to, result_.unit, "to")));
  }

  void crossed(const Sample& a, const Sample& b) {
    const double target = result_.target.value;
    const double x =
        bracketed_root([&](double at) { return probe_.output(at) - target; }, a.x, b.x);
    const Sample at = probe_.sample(x);
    const double scale = std::max(std::abs(at.y), std::abs(target));
    if (at.state == a.state && continuous_at(probe_, x, a.x, b.x, scale))
      found(at);
    else
      remark(fmt::format(
          "{} jumps over {} at {} = {}, where there is no solution", result_.target.output,
          shown_at(result_.target.output, target, result_.target.unit), result_.path, input(x)));
  }

  void conclude() {
    const std::size_t n = result_.solutions.size();
    if (n > 1)
      remarks_.insert(remarks_.begin(), fmt::format("several solutions: {} values of {} give {}", n,
                                                    result_.path, wanted()));
    if (n == 0) {
      std::string none =
          fmt::format("no {} from {} to {} gives {}; ", result_.path, input(result_.searched.from),
                      input(result_.searched.to), wanted());
      if (result_.least) {
        none +=
            (*result_.least == *result_.greatest ? "it is " : "it lies ") + output_range(result_);
      } else {
        const auto unusable = std::ranges::find(result_.excluded, false, &Excluded::refused);
        none += fmt::format("no value gives a result that may be used: {}", unusable->reason);
      }
      remarks_.insert(remarks_.begin(), std::move(none));
    }
    result_.reason = fmt::format("{}", fmt::join(remarks_, "; "));
  }

 private:
  void remark(std::string text) { remarks_.push_back(std::move(text)); }
  [[nodiscard]] std::string input(double x) const {
    return shown_at(result_.path, x, result_.unit);
  }
  [[nodiscard]] std::string wanted() const {
    return fmt::format("{} = {}", result_.target.output,
                       shown_at(result_.target.output, result_.target.value, result_.target.unit));
  }

  Probe& probe_;
  SolveResult& result_;
  std::vector<std::string> remarks_;
};

/// Walks the samples and finds the places at which the output meets the target.
void find_solutions(const Samples& samples, Findings& findings, double target) {
  // A smaller difference counts as equal, because the last digits of the output are rounding.
  const auto met = [&](const Sample& s) {
    return std::abs(s.y - target) <= 1e-14 * std::max(std::abs(target), std::abs(s.y));
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& here = samples[i];
    if (here.state == State::refused) continue;
    if (met(here)) {
      std::size_t last = i;
      while (last + 1 < samples.size() && samples[last + 1].state == here.state &&
             met(samples[last + 1]))
        ++last;
      if (last == i)
        findings.found(here);
      else
        findings.found_everywhere(here.x, samples[last].x);
      i = last;
      continue;
    }
    if (i + 1 == samples.size()) continue;
    const Sample& next = samples[i + 1];
    if (next.state == here.state && !met(next) && (next.y < target) != (here.y < target))
      findings.crossed(here, next);
  }
}

void describe_range(const Samples& samples, SolveResult& result) {
  result.searched = {samples.front().x, samples.back().x};
  State previous = State::usable;
  for (const Sample& s : samples) {
    if (s.state == State::usable) {
      result.least = std::min(result.least.value_or(s.y), s.y);
      result.greatest = std::max(result.greatest.value_or(s.y), s.y);
    } else if (s.state == previous) {
      result.excluded.back().to = s.x;
    } else {
      result.excluded.push_back({s.x, s.x, s.state == State::refused, s.reason});
    }
    previous = s.state;
  }
}

}  // namespace

Unknown parse_unknown(const GearSet& gear, std::string_view text) {
  const Assignment given = assignment(text);
  const NumberAt number = varied_number(gear, given.key);
  Unknown unknown{.path = number.path, .range = std::nullopt};
  if (given.has_value) {
    const Interval interval = parse_interval(number, given.value);
    unknown.range = {interval.from, interval.to};
  }
  return unknown;
}

Target parse_target(const GearSet& gear, Method method, std::string_view text) {
  const Assignment given = assignment(text);
  if (!given.has_value)
    throw InputError("--target", fmt::format("\"{}\" must be OUTPUT=VALUE, such as "
                                             "\"cracked.positive.stiffness_change=-1 %\"",
                                             text));
  const StiffnessResult present = evaluate(gear, method, {.over_turn = is_over_turn(given.key)});
  const std::optional<Quantity> output = output_named(present, given.key);
  if (!output) refuse_output(present, given.key, "--target");
  return {
      .output = std::string(given.key),
      .unit = output->unit,
      .value = parse_quantity(fmt::format("--target {}", given.key), given.value, output->unit)};
}

SolveResult solve(const GearSet& gear, Method method, const Unknown& unknown, const Target& target,
                  const SolveOptions& options, const Progress& progress) {
  const NumberAt number = varied_number(gear, unknown.path);
  require(options.n_scan >= 2 && options.n_scan <= kMaxSweepPoints, "n_scan", options.n_scan, "1",
          fmt::format(">= 2 and <= {}", kMaxSweepPoints));
  require(std::isfinite(target.value), target.output, target.value, target.unit, "a finite number");
  if (unknown.range) {
    const auto& [from, to] = *unknown.range;
    if (!std::isfinite(from) || !std::isfinite(to) || from == to)
      throw InputError(vary_option(number.path),
                       fmt::format("{}..{} must be two different finite numbers", from, to));
  }

  Probe probe(gear, method, number.path, target, options.n_scan, progress);
  Samples samples;
  for (const double x : scan_points(number, unknown, options.n_scan))
    samples.push_back(probe.sample(x));
  if (std::ranges::all_of(samples, [](const Sample& s) { return s.state == State::refused; })) {
    const StiffnessResult result = probe.result(samples.front().x);  // throws the original fault
    refuse_output(result, target.output, "--target");
  }
  samples = with_turning_points(probe, with_ends(probe, std::move(samples)));

  SolveResult result{.method = method,
                     .path = number.path,
                     .unit = number.field.unit,
                     .present = number.value,
                     .target = target,
                     .searched = {},
                     .solutions = {},
                     .excluded = {},
                     .least = {},
                     .greatest = {},
                     .reason = {},
                     .notes = {}};
  describe_range(samples, result);
  Findings findings(probe, result);
  find_solutions(samples, findings, target.value);
  findings.conclude();
  return result;
}

std::string output_range(const SolveResult& result) {
  const std::string_view name = result.target.output;
  if (*result.least == *result.greatest)
    return fmt::format("{} everywhere in this range, because the output does not depend on {}",
                       shown_at(name, *result.least, result.target.unit), result.path);
  return "between " + span_shown(name, *result.least, *result.greatest, result.target.unit, "and");
}

ResultEvidence evidence_of(const SolveResult& result) {
  ResultEvidence evidence;
  if (!result.solutions.empty()) evidence = evidence_of(result.solutions.front().result);
  evidence.notes.insert(evidence.notes.end(), result.notes.begin(), result.notes.end());
  if (!result.usable())
    evidence.unusable_because = result.reason;
  else if (!result.reason.empty())
    evidence.notes.push_back({.code = "solve.remark",
                              .text = result.reason,
                              .path = result.path,
                              .equation = {},
                              .severity = Severity::care});
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave

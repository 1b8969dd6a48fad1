// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "growth_rule_options.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/inspection/detection_fit.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/layouts/inspection.hpp"

namespace strainwave {
namespace {

struct InspectOptions : GrowthRuleOptions {
  std::optional<std::string> until;
  std::optional<InspectionMeans> method;
  std::optional<std::string> a50;
  std::optional<std::string> a90;
  std::optional<DetectionForm> detection;
  std::optional<double> noise;
  std::optional<double> false_calls;
  std::optional<FindLeadsTo> find;
  std::optional<std::string> repaired_to;
  std::optional<std::string> detection_data;
  std::optional<double> threshold;
  std::optional<double> floor;
  std::optional<double> ceiling;
  std::vector<std::string> see;
  std::vector<std::string> at;
  std::optional<std::string> every;
  std::optional<std::string> first;
  std::optional<double> risk;
  std::optional<int> most;
  int draws = 500;
  bool importance_sampling = false;
  std::uint64_t seed = 1;
  int threads = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = InspectOptions;
    field({"until", "",
           "end of service, a time of duty with its unit; the life at the values of the file if "
           "left out"},
          &O::until);
    field({"method", "",
           "what an inspection looks at: the cracks, with a curve of detection over their size, or "
           "a measurement of the drive; as [inspection] of the file says, or a curve, if left out"},
          &O::method);
    field(
        {"a50", "",
         "size of a crack that one inspection finds in half of the cases, a number with its unit: "
         "the depth, or the half length of a crack through the wall; as [inspection] of the file "
         "says if left out"},
        &O::a50);
    field({"a90", "", "size that is found in nine of ten cases, a number with its unit"}, &O::a90);
    field({"detection", "",
           "form of the probability of detection over the size; log_logistic if left out"},
          &O::detection);
    field({.name = "noise",
           .unit = "1",
           .doc = "of a measurement: standard deviation of the measured change over the measured "
                  "value",
           .range = {.lower = 0.0, .upper = 1.0}},
          &O::noise);
    field(
        {.name = "false_calls",
         .unit = "1",
         .doc = "probability that an inspection finds a crack that is not there; 0 if left out of "
                "a curve; the threshold of a measurement follows from it",
         .range = {.lower = 0.0, .lower_open = false, .upper = 1.0}},
        &O::false_calls);
    field({"find", "",
           "what a find leads to: the drive goes out of service, or the repair of its cracks; out "
           "if left out"},
          &O::find);
    field({"repaired_to", "", "size of a crack after its repair, a number with its unit"},
          &O::repaired_to);
    field({.name = "detection_data",
           .unit = "",
           .doc = "CSV of trials on cracks of known size, from which the curve is fitted, in place "
                  "of a50 and a90: the columns size [mm] and hit (1 or 0), or size [mm] and signal "
                  "with --threshold",
           .names = "history"},
          &O::detection_data);
    field({.name = "threshold",
           .unit = "1",
           .doc = "signal of --detection-data from which on a crack counts as found, in the unit "
                  "of the signal",
           .range = kPositive},
          &O::threshold);
    field(
        {.name = "floor",
         .unit = "1",
         .doc = "signal of --detection-data at which the noise begins, in the unit of the signal; "
                "a signal at the floor or below it counts as somewhere below",
         .range = kPositive},
        &O::floor);
    field(
        {.name = "ceiling",
         .unit = "1",
         .doc = "signal of --detection-data at which the scale ends, in the unit of the signal; a "
                "signal at the ceiling or above it counts as somewhere above",
         .range = kPositive},
        &O::ceiling);
    field({"see", "",
           "path of a crack that the inspections can see, once for each; all cracks if left out"},
          &O::see);
    field({"at", "", "time of an inspection, with its unit, once for each"}, &O::at);
    field({"every", "", "interval of the inspections, a time with its unit"}, &O::every);
    field({"first", "", "first inspection of the intervals; one interval if left out"}, &O::first);
    field({.name = "risk",
           .unit = "1",
           .doc = "wanted probability of failure up to the end of service; plans the fewest "
                  "inspections for it",
           .range = {.lower = 0.0, .upper = 1.0}},
          &O::risk);
    field({"most", "", "largest number of inspections of a plan, 1 to 100; 20 if left out"},
          &O::most);
    GrowthRuleOptions::describe(field);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives drawn from [[scatter]] and growth_scatter, 20 to 1e6",
           .fallback = "500"},
          &O::draws);
    field({"importance_sampling", "",
           "let draws scatter about the failures up to the end of service too, for probabilities "
           "below about 1e-2; needs an --until before the life at the values of the file"},
          &O::importance_sampling);
    field({.name = "seed", .unit = "", .doc = "seed of the draws", .fallback = "1"}, &O::seed);
    field({.name = "threads",
           .unit = "",
           .doc = "threads; 0: as many as the machine runs; the answer does not depend on them",
           .fallback = "0"},
          &O::threads);
  }
};

/// Refuses an option that is read with another one only, if that one is missing.
void needs(bool given, const char* option, bool other, std::string_view name) {
  if (given && !other) throw OptionError(option, fmt::format("is read with --{} only", name));
}

/// The curve of detection that makes the trials of a file most likely.
DetectionFit fitted_detection(const Request& request, const InspectOptions& o, DetectionForm form) {
  HistoryFile file(request.pieces("detection-data", *o.detection_data),
                   *o.detection_data == "-" ? "standard input" : *o.detection_data);
  const bool signals = file.has("signal");
  if (signals != o.threshold.has_value())
    throw OptionError("threshold", signals ? "must be given, because the file has signals"
                                           : "is read with the column signal only");
  const std::array<std::size_t, 2> columns = {file.number_of("size"),
                                              file.number_of(signals ? "signal" : "hit")};
  const double metre = file.factor_to("m", columns[0]);
  std::vector<HitOrMiss> hits;
  std::vector<SizedSignal> read;
  while (true) {
    const std::vector<std::vector<double>>& rows = file.read(columns);
    if (rows[0].empty()) break;
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      const double value = rows[1][i];
      if (!(rows[0][i] > 0)) file.refuse(i, columns[0], rows[0][i], "> 0");
      if (signals && !(value > 0) && !(o.floor && value <= *o.floor))
        file.refuse(i, columns[1], value, "> 0");
      if (!signals && value != 0 && value != 1) file.refuse(i, columns[1], value, "0 or 1");
      if (signals)
        read.push_back({.size = rows[0][i] * metre, .signal = value});
      else
        hits.push_back({.size = rows[0][i] * metre, .hit = value == 1});
    }
  }
  if (!signals && (o.floor || o.ceiling))
    throw OptionError(o.floor ? "floor" : "ceiling", "is read with the column signal only");
  if (!signals) return fit_hits(form, hits);
  if (o.detection == DetectionForm::log_logistic)
    throw OptionError("detection", "must be log_normal, or left out, for signals");
  try {
    return fit_signals(read, *o.threshold, {.floor = o.floor, .ceiling = o.ceiling});
  } catch (const InputError& error) {
    if (error.field() == "floor" || error.field() == "ceiling") throw OptionError(error);
    throw;
  }
}

/// An option that says how cracks are looked for, in the place of a field of [inspection].
struct MethodOption {
  std::string_view field;
  std::string_view option;
  bool given;
};

std::array<MethodOption, 9> method_options(const InspectOptions& o) {
  return {{{"method", "method", o.method.has_value()},
           {"a50", "a50", o.a50.has_value()},
           {"a90", "a90", o.a90.has_value()},
           {"detection", "detection", o.detection.has_value()},
           {"noise", "noise", o.noise.has_value()},
           {"false_calls", "false_calls", o.false_calls.has_value()},
           {"find", "find", o.find.has_value()},
           {"repaired_to", "repaired_to", o.repaired_to.has_value()},
           {"place", "see", !o.see.empty()}}};
}

/// The first of the options that say how cracks are looked for; empty: none is given.
std::string_view given_option(const InspectOptions& o) {
  if (o.detection_data) return "detection_data";
  for (const MethodOption& of : method_options(o))
    if (of.given) return of.option;
  return {};
}

/// Refuses what needs a curve of the options, because the file has no [inspection].
void need_curve(const InspectOptions& o) {
  if (o.a50.has_value() != o.a90.has_value())
    throw OptionError(o.a50 ? "a90" : "a50", "must be given: a50 and a90 belong together");
  if (o.a50) return;
  throw OptionError(given_option(o), "is read with --a50 or with [inspection] in the file only");
}

/// The method of the file with what the options say instead; absent: the options say nothing.
std::optional<Inspection> asked_method(const Request& request, const InspectOptions& o,
                                       std::optional<DetectionFit>& trials) {
  const std::optional<Inspection>& table = request.drive.gear.inspection;
  if (given_option(o).empty()) return std::nullopt;
  const InspectionMeans means = o.method.value_or(table ? table->method : InspectionMeans::curve);
  const bool measured = is_measurement(means);
  if (!table && !measured && !o.detection_data) need_curve(o);
  if (o.detection_data && (o.a50 || o.a90))
    throw OptionError(o.a50 ? "a50" : "a90", "is given beside --detection-data; give one of them");
  if (o.detection_data && measured)
    throw OptionError("detection_data", "is read with a curve only, not with a measurement");
  Inspection method = table.value_or(Inspection{});
  if (is_measurement(method.method) != measured) {  // the rest belongs to the other kind
    method.detection.reset();
    method.a50.reset();
    method.a90.reset();
    method.noise.reset();
    method.place.clear();
  }
  method.method = means;
  if (o.detection) method.detection = o.detection;
  if (o.a50) method.a50 = option_quantity("--a50", *o.a50, "m");
  if (o.a90) method.a90 = option_quantity("--a90", *o.a90, "m");
  if (o.noise) method.noise = o.noise;
  if (o.false_calls) method.false_calls = o.false_calls;
  if (o.find == FindLeadsTo::out) method.repaired_to.reset();
  if (o.find) method.find = *o.find;
  if (o.repaired_to) method.repaired_to = option_quantity("--repaired-to", *o.repaired_to, "m");
  if (!o.see.empty()) {
    method.place.clear();
    for (const std::string& path : o.see) method.place.push_back({path});
  }
  if (o.detection_data) {
    trials = fitted_detection(request, o, method.detection.value_or(DetectionForm::log_logistic));
    method.detection = trials->form;
    method.a50 = trials->a50;
    method.a90 = trials->a90;
  }
  return method;
}

/// The fault of a field of [inspection] at the option that stands in its place; the same fault if
/// the file gives the field.
void throw_at_option(const InputError& error, const InspectOptions& o, bool has_table) {
  constexpr std::string_view kTable = "inspection.";
  if (!error.field().starts_with(kTable)) return;
  const std::string key =
      error.field().substr(kTable.size(), error.field().find('[') - kTable.size());
  for (const MethodOption& of : method_options(o))
    if (of.field == key && (of.given || !has_table))
      throw OptionError(of.option,
                        error.rule().empty()
                            ? std::string(error.what()).substr(error.field().size() + 2)
                            : fmt::format("{} violates: {}", error.value(), error.rule()));
}

InspectionReport inspect(const Request& request, const InspectOptions& o) {
  InspectionOptions options;
  options.growth = growth_options(o);
  options.growth.tolerance = 1e-6;
  const auto time = [](const char* option, const std::string& text) {
    return option_quantity(option, text, "s");
  };
  if (o.until) options.until = time("--until", *o.until);
  needs(o.threshold.has_value(), "threshold", o.detection_data.has_value(), "detection-data");
  needs(o.floor.has_value(), "floor", o.detection_data.has_value(), "detection-data");
  needs(o.ceiling.has_value(), "ceiling", o.detection_data.has_value(), "detection-data");
  needs(o.most.has_value(), "most", o.risk.has_value(), "risk");
  options.method = asked_method(request, o, options.trials);
  if (options.method && !o.every && !o.risk && o.at.empty())
    throw OptionError(given_option(o),
                      "is read with inspections only; give --at, --every or --risk");
  for (const std::string& at : o.at) options.times.at.push_back(time("--at", at));
  if (o.every) options.times.every = time("--every", *o.every);
  if (o.first) options.times.first = time("--first", *o.first);
  options.times.risk = o.risk;
  if (o.most) options.times.most = *o.most;
  options.draws = o.draws;
  options.importance_sampling = o.importance_sampling;
  options.seed = o.seed;
  options.threads = o.threads;
  options.shared = request.shared;
  options.rows = request.rows;
  try {
    return inspection_report(request.drive.gear, options, request.progress);
  } catch (const InputError& error) {
    throw_at_option(error, o, request.drive.gear.inspection.has_value());
    throw;
  }
}

}  // namespace

Command inspect_command() {
  return command<InspectOptions, InspectionReport>({
      .name = "inspect",
      .summary = "Compute the risk of cracked drives over hours, and the inspections that lower it",
      .description =
          "Draws the numbers of [[scatter]] and the scatter of growth of the materials, and grows "
          "the "
          "cracks of each drawn drive over the duty of the file. Percentiles of the life with "
          "their limits, the probability of failure over "
          "hours, and the shares of the inputs follow; cracks that stand still have an endless "
          "life. "
          "[inspection] of the file, or --a50 and --a90, say how cracks are looked for. "
          "Inspections "
          "at given times or intervals take drives with a found crack out of service, or repair "
          "them, and --risk plans the fewest inspections, at equal intervals and at times of least "
          "risk. With --method, the measured stiffness or natural frequency of the drive is the "
          "inspection, and --detection-data fits a curve of detection to trials. "
          "--importance-sampling resolves probabilities that plain draws do not reach.",
      .example = "strainwave inspect examples/inspected_shaft.toml --until '350 h' --a50 '1 mm' "
                 "--a90 '2 mm' --every '100 h'",
      .shares = "draws",
      .rows = "draws",
      .takes = Takes::drive,
      .function = inspect,
      .documents = {{Format::text, inspection_text},
                    {Format::csv, inspection_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the probability of failure over time as an SVG file"},
                     inspection_plot}},
  });
}

}  // namespace strainwave

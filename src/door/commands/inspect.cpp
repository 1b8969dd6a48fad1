// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string_view>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/inspection.hpp"

namespace strainwave {
namespace {

struct InspectOptions {
  std::optional<std::string> until;
  std::optional<std::string> a50;
  std::optional<std::string> a90;
  std::optional<DetectionForm> detection;
  std::optional<double> false_calls;
  std::vector<std::string> see;
  std::vector<std::string> at;
  std::optional<std::string> every;
  std::optional<std::string> first;
  std::optional<double> risk;
  std::optional<int> most;
  int draws = 500;
  std::uint64_t seed = 1;
  int threads = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = InspectOptions;
    field({"until", "",
           "end of service, a time of duty with its unit; the life at the values of the file if "
           "left out"},
          &O::until);
    field(
        {"a50", "",
         "size of a crack that one inspection finds in half of the cases, a number with its unit: "
         "the depth, or the half length of a crack through the wall; no inspections if left out"},
        &O::a50);
    field({"a90", "", "size that is found in nine of ten cases, a number with its unit"}, &O::a90);
    field({"detection", "",
           "form of the probability of detection over the size; log_logistic if left out"},
          &O::detection);
    field({.name = "false_calls",
           .unit = "1",
           .doc = "probability that an inspection finds a crack that is not there; 0 if left out",
           .range = {.lower = 0.0, .lower_open = false, .upper = 1.0}},
          &O::false_calls);
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
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives drawn from [[scatter]], 20 to 1e6",
           .fallback = "500"},
          &O::draws);
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

InspectionReport inspect(const Request& request, const InspectOptions& o) {
  InspectionOptions options;
  options.growth.tolerance = 1e-6;
  const auto time = [](const char* option, const std::string& text) {
    return parse_quantity(option, text, "s");
  };
  if (o.until) options.until = time("--until", *o.until);
  if (o.a50.has_value() != o.a90.has_value())
    throw OptionError(o.a50 ? "a90" : "a50", "must be given: a50 and a90 belong together");
  needs(o.detection.has_value(), "detection", o.a50.has_value(), "a50");
  needs(o.false_calls.has_value(), "false_calls", o.a50.has_value(), "a50");
  needs(!o.see.empty(), "see", o.a50.has_value(), "a50");
  needs(o.most.has_value(), "most", o.risk.has_value(), "risk");
  if (o.a50)
    options.method = InspectionMethod{.form = o.detection.value_or(DetectionForm::log_logistic),
                                      .a50 = parse_quantity("--a50", *o.a50, "m"),
                                      .a90 = parse_quantity("--a90", *o.a90, "m"),
                                      .false_calls = o.false_calls.value_or(0.0),
                                      .see = o.see};
  for (const std::string& at : o.at) options.times.at.push_back(time("--at", at));
  if (o.every) options.times.every = time("--every", *o.every);
  if (o.first) options.times.first = time("--first", *o.first);
  options.times.risk = o.risk;
  if (o.most) options.times.most = *o.most;
  options.draws = o.draws;
  options.seed = o.seed;
  options.threads = o.threads;
  options.shared = request.shared;
  return inspection_report(request.drive.gear, options, request.progress);
}

}  // namespace

Command inspect_command() {
  return command<InspectOptions, InspectionReport>({
      .name = "inspect",
      .summary = "Compute the risk of cracked drives over hours, and the inspections that lower it",
      .description =
          "Draws the numbers of [[scatter]] and grows the cracks of each drawn drive over the duty "
          "of the file. Percentiles of the life with their limits, the probability of failure over "
          "hours, and the shares of the inputs follow; cracks that stand still have an endless "
          "life. "
          "With --a50 and --a90, inspections at given times or intervals take drives with a found "
          "crack out of service, and --risk plans the fewest inspections, at equal intervals and "
          "at "
          "times of least risk.",
      .example = "strainwave inspect examples/inspected_shaft.toml --until '350 h' --a50 '1 mm' "
                 "--a90 '2 mm' --every '100 h'",
      .shares = "draws",
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

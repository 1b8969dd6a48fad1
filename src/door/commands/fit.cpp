// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/enum_list.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/growth_fit.hpp"

namespace strainwave {
namespace {

struct FitOptions {
  std::string data;
  std::optional<std::string> stress_range;
  std::optional<std::string> plate_width;
  std::optional<double> stress_ratio;
  std::optional<std::string> judge;
  std::vector<std::string> size;
  std::vector<std::string> known;
  std::string parts = "level,slope,correlated,white";
  std::optional<int> knots;
  double confidence = 0.9;
  int draws = 4000;
  std::uint64_t seed = 1;
  int threads = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using F = FitOptions;
    field({.name = "data",
           .unit = "",
           .doc = "CSV with sizes such as \"crack_length [mm]\" in the first column and the cycles "
                  "of one specimen in each other column; or with the columns specimen, "
                  "crack_length, cycles and, without --stress-range, delta_K",
           .positional = true,
           .names = "history"},
          &F::data);
    field({"stress_range", "",
           "range of the stress on a plate with a crack in its middle, a number with its unit; "
           "sizes are then half lengths"},
          &F::stress_range);
    field({"plate_width", "",
           "width of the plate, a number with its unit; left out for a wide plate"},
          &F::plate_width);
    field(
        {.name = "stress_ratio",
         .unit = "1",
         .doc = "R of the test, which the records do not say; the text for a drive file states it",
         .range = {.upper = 1.0}},
        &F::stress_ratio);
    field({.name = "judge",
           .unit = "",
           .doc = "CSV of other specimens, of the same test, whose cycles are predicted; each "
                  "specimen of the data by a fit to all others if left out",
           .names = "history"},
          &F::judge);
    field({"size", "",
           "size whose cycles are predicted, a number with its unit; once or more; five sizes over "
           "the records if left out"},
          &F::size);
    field({"known", "",
           "also predict the cycles left, with the own record of a specimen up to this size, a "
           "number with its unit; once or more"},
          &F::known);
    field({.name = "parts",
           .unit = "",
           .doc = "parts of the scatter, separated by commas: level and slope differ from specimen "
                  "to specimen; correlated and white vary along the path of a crack",
           .fallback = "level,slope,correlated,white"},
          &F::parts);
    field({.name = "knots",
           .unit = "",
           .doc = "points of the median rate; 2 give Paris' law; left out, the number from 2 to 8 "
                  "with the least information criterion",
           .range = {.lower = 2, .lower_open = false, .upper = kMostKnots, .upper_open = false}},
          &F::knots);
    field({.name = "confidence",
           .unit = "1",
           .doc = "probability of a band",
           .range = {.lower = 0.0, .upper = 1.0},
           .fallback = "0.9"},
          &F::confidence);
    field({.name = "draws",
           .unit = "",
           .doc = "drawn paths of growth for a band",
           .range = {.lower = 100, .lower_open = false, .upper = 100000, .upper_open = false},
           .fallback = "4000"},
          &F::draws);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws",
           .range = kNonNegative,
           .fallback = "1"},
          &F::seed);
    field({.name = "threads",
           .unit = "",
           .doc = "number of threads; 0 for all of the machine; the answer does not depend on it",
           .range = {.lower = 0, .lower_open = false, .upper = 256, .upper_open = false},
           .fallback = "0"},
          &F::threads);
  }
};

double positive(const char* name, const std::string& text, std::string_view unit) {
  return from_option([&] {
    const double value = option_quantity(name, text, unit);
    require(value > 0, name, value, unit, "> 0");
    return value;
  });
}

std::vector<double> sizes_of(const char* name, const std::vector<std::string>& texts) {
  std::vector<double> sizes;
  for (const std::string& text : texts) sizes.push_back(positive(name, text, "m"));
  return sizes;
}

GrowthTest test_of(const FitOptions& o) {
  if (!o.stress_range) {
    if (o.plate_width) throw OptionError("plate-width", "needs --stress-range; give it too");
    return std::nullopt;
  }
  PlateTest test{.stress_range = positive("stress-range", *o.stress_range, "Pa")};
  if (o.plate_width) test.width = positive("plate-width", *o.plate_width, "m");
  return test;
}

GrowthFitReport fitted(const Request& request, const FitOptions& o) {
  const GrowthTest test = test_of(o);
  const auto specimens_in = [&](const char* option, const std::string& name) {
    HistoryFile file(request.pieces(option, name), name == "-" ? "standard input" : name);
    if (!test && !(file.has("specimen") && file.has("delta_K")))
      throw OptionError("stress-range",
                        "must be given; or give a file with the columns specimen, "
                        "crack_length, cycles and delta_K");
    return read_specimens(file, test);
  };
  const auto parts = from_option([&] { return parse_enum_list<ScatterPart>("parts", o.parts); });
  GrowthFitRequest asked{.fit = {.parts = ScatterParts::of(parts), .knots = o.knots},
                         .sizes = sizes_of("size", o.size),
                         .known = sizes_of("known", o.known),
                         .confidence = o.confidence,
                         .draws = o.draws,
                         .seed = o.seed,
                         .threads = o.threads,
                         .test = test,
                         .stress_ratio = o.stress_ratio,
                         .judged = {}};
  const std::vector<GrowthSpecimen> specimens = specimens_in("data", o.data);
  if (o.judge) asked.judged = specimens_in("judge", *o.judge);
  return from_option([&] { return growth_fit_report(specimens, asked, request.progress); });
}

}  // namespace

Command fit_command() {
  return command<FitOptions, GrowthFitReport>({
      .name = "fit",
      .summary = "Fit a law of crack growth and its scatter to measured specimens",
      .description =
          "Reads how cracks of specimens grew, and fits the median rate of growth over the range "
          "of "
          "the stress intensity factor, together with its scatter, by maximum likelihood: "
          "specimens differ in ln C and m, and the rate of one crack varies along its path, in a "
          "correlated and a white part. Predicts the cycles of specimens that the fit did not see, "
          "without and with the beginning of their own records, and counts how many lie inside of "
          "their bands. The answer says which parameters the records determine. --format toml "
          "writes law and scatter as tables for a drive file, with which `strainwave inspect` "
          "draws lives. `strainwave grow --fit DATA.csv` is the same command.",
      .example = "strainwave fit examples/growth_specimens.csv --stress-range '60 MPa' "
                 "--plate-width '100 mm' --known '14 mm'",
      .takes = Takes::nothing,
      .also = "grow --fit",
      .function = fitted,
      .documents = {{Format::text, growth_fit_text},
                    {Format::csv, growth_fit_csv},
                    {Format::toml, [](const GrowthFitReport& report,
                                      const Rendering&) { return growth_fit_toml(report); }},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the probability transforms of the specimens as an SVG file"},
                     growth_fit_plot}},
  });
}

}  // namespace strainwave

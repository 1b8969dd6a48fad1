// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/sensitivity.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct SensitivityOptions {
  bool scatter = false;
  bool sobol = false;
  std::vector<std::string> of;
  std::optional<int> points;
  std::optional<int> samples;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"scatter", "", "also propagate the scatter that the file gives"},
          &SensitivityOptions::scatter);
    field({"sobol", "", "also divide the variance of outputs among the inputs, by Sobol's indices"},
          &SensitivityOptions::sobol);
    field({.name = "of",
           .unit = "",
           .doc = "output of the Sobol study, such as curve.positive.K1; may be repeated; by "
                  "default stiffness and loss of the sum of the members",
           .names = "output"},
          &SensitivityOptions::of);
    field(
        {.name = "points",
         .unit = "",
         .doc = "base points of the Sobol study, a multiple of 16; the drive is evaluated at each "
                "of them for two more than the inputs",
         .range = {.lower = 2 * kSobolReplicates,
                   .lower_open = false,
                   .upper = kMaxSobolPoints,
                   .upper_open = false},
         .fallback = "4096"},
        &SensitivityOptions::points);
    field({.name = "samples",
           .unit = "",
           .doc = "draws of the Monte Carlo study",
           .range = {.lower = 2, .lower_open = false, .upper = kMaxSamples, .upper_open = false},
           .fallback = "100000"},
          &SensitivityOptions::samples);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws",
           .range = kNonNegative,
           .fallback = "1"},
          &SensitivityOptions::seed);
    field({.name = "threads",
           .unit = "",
           .doc = "number of threads; 0 for all of the machine; the answer does not depend on it",
           .range = {.lower = 0, .lower_open = false, .upper = 256, .upper_open = false},
           .fallback = "0"},
          &SensitivityOptions::threads);
  }
};

SensitivityReport report_of(const Request& request, const SensitivityOptions& options) {
  if (!options.scatter && options.samples)
    throw OptionError("scatter", "samples needs --scatter; give it too");
  if (!options.sobol && (options.points || !options.of.empty()))
    throw OptionError("sobol", "points and of need --sobol; give it too");
  if (!options.scatter && !options.sobol && (options.seed || options.threads))
    throw OptionError("scatter", "seed and threads need --scatter or --sobol; give one");
  if (request.shared != nullptr && options.scatter == options.sobol)
    throw OptionError("shard", "needs either --scatter or --sobol; give one of them");
  if (request.rows != nullptr && !options.scatter && !options.sobol)
    throw OptionError("rows", "needs --scatter or --sobol; give one of them");
  const GearSet& gear = request.drive.gear;
  SensitivityReport report{.sensitivity = sensitivity_of(gear), .scatter = {}, .sobol = {}};
  if (options.scatter) {
    ScatterOptions scatter;
    scatter.samples = options.samples.value_or(scatter.samples);
    scatter.seed = options.seed.value_or(scatter.seed);
    scatter.threads = options.threads.value_or(scatter.threads);
    scatter.shared = request.shared;
    scatter.rows = request.rows;
    report.scatter = scatter_of(gear, report.sensitivity, scatter,
                                request.progress.part(0.0, options.sobol ? 0.5 : 1.0));
  }
  if (options.sobol) {
    SobolSettings settings;
    settings.points = options.points.value_or(settings.points);
    settings.seed = options.seed.value_or(settings.seed);
    settings.threads = options.threads.value_or(settings.threads);
    settings.outputs = options.of;
    settings.shared = request.shared;
    if (!options.scatter) settings.rows = request.rows;
    from_option([&] { check_settings(gear, settings); });
    report.sobol =
        sobol_of(gear, settings, request.progress.part(options.scatter ? 0.5 : 0.0, 1.0));
  }
  return report;
}

}  // namespace

Command sensitivity_command() {
  return command<SensitivityOptions, SensitivityReport>({
      .name = "sensitivity",
      .summary = "Find the inputs that determine stiffness and its loss",
      .description =
          "Prints the elasticities of the stiffness K_HD of the sum of the members, sound and "
          "cracked under both senses of torque, and of its loss by cracks, with respect to every "
          "number of the file. If the coupled drive can be solved, the elasticities of its K1, K2, "
          "K3 come first. An elasticity is per cent of output per per cent of input. Automatic "
          "differentiation of the corrected method and of the equilibrium of the contacts gives "
          "exact values; the largest come first. The sums of the elasticities must reproduce the "
          "dimensions of the outputs; otherwise the answer is refused. With --scatter, the "
          "relative standard deviations that the file gives under [[scatter]] are propagated by "
          "first order and by Monte Carlo, with the share of each input. Draws that break a rule "
          "of the input are counted. With --sobol, the variance of each output is divided among "
          "the scattering inputs without linearisation: the first share is that of the input "
          "alone, the total share that of the input alone and together with others, both with an "
          "interval of 95 % confidence.",
      .example = "strainwave sensitivity examples/article_scatter.toml --scatter --plot "
                 "tornado.svg",
      .shares = "draws of --scatter, or points of --sobol",
      .rows = "draws of --scatter, else points of --sobol",
      .function = report_of,
      .documents = {{Format::text, sensitivity_text},
                    {Format::csv, sensitivity_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the elasticities as an SVG file"},
                     sensitivity_plot}},
  });
}

}  // namespace strainwave

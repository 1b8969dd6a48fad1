// SPDX-License-Identifier: Apache-2.0
// The kernels whose instructions tools/count_instructions.py counts:
//
//     kernels NAME COUNT     runs a kernel COUNT times
//     kernels --list         prints the names
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/study/varied_series.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

double sink = 0.0;  // what the kernels compute, so that the compiler keeps it

using Kernel = std::function<void(int count)>;

template <class F>
Kernel repeated(const F& once) {
  return [once](int count) {
    for (int n = 0; n < count; ++n) sink += once();
  };
}

GearSet article() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml"); }

double dual_series() {
  static const GearSet gear = article();
  static const std::vector<const double*> inputs = {&gear.output_shaft->outer_diameter,
                                                    &gear.output_shaft->length};
  return series_compliance(gear, Lift<DualReal>(inputs)).positive.partial[0];
}

/// Draws of the cracked drive by tables, which the first draws fill.
void draws(int count) {
  const GearSet gear = article();
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth",
                                          "flexspline.crack[0].half_length",
                                          "wave_generator.radial_stiffness"};
  const std::vector<std::string> outputs = {"cracked.positive.stiffness"};
  const std::vector<double> centres = {1e-4, 1e-4, 1.2e8};
  const auto fill = [&](std::size_t row, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = centres[i] * (1 + 0.05 * counter_normal(1, row % 1000, i));
  };
  VariedSeries varied(gear, paths, outputs);
  varied.prepare(1'000'000, fill);
  VariedSeries::Evaluator evaluate(varied);
  std::vector<double> values(paths.size());
  double output = 0.0;
  for (int n = 0; n < 1000 + count; ++n) {
    fill(static_cast<std::size_t>(n), values);
    if (evaluate(values, {&output, 1}) == Fate::evaluated) sink += output;
  }
}

const std::map<std::string, Kernel>& kernels() {
  static const std::map<std::string, Kernel> all = {
      {"check_input",
       [gear = article()](int count) {
         for (int n = 0; n < count; ++n) check(gear);
       }},
      {"corrected_result",
       repeated([gear = article()] { return torsional_stiffness(gear).positive.stiffness.value; })},
      {"series_compliance",
       repeated([gear = article()] { return series_compliance<double>(gear).positive; })},
      {"series_derivatives", repeated(dual_series)},
      {"all_elasticities",
       repeated([gear = article()] { return sensitivity_of(gear).outputs[0].length_residual; })},
      {"draw_by_tables", draws},
      {"through_crack", repeated([] {
         const sif::ThroughCrackInTube crack{.half_length = 1e-3,
                                             .mean_radius = 0.08,
                                             .wall_thickness = 2e-3,
                                             .angle = 0.7,
                                             .thin_sheet = false};
         return added_compliance(crack, {.opening = 2e11, .shear = 8e10}).matrix(1, 1);
       })},
      {"surface_crack", repeated([] {
         const sif::SurfaceCrack<1> crack({.depth = 1e-4,
                                           .aspect_ratio = 0.52,
                                           .thickness = 0.01,
                                           .normal_stress = {1.0},
                                           .shear_stress = {}});
         return added_compliance(crack, {.opening = 2e11, .shear = 8e10}).matrix(0, 0);
       })},
      {"hollow_shaft", repeated([] {
         const sif::AnnularCrackHollow crack(
             {.depth = 1e-3, .outer_radius = 0.035, .inner_radius = 0.0225});
         return added_compliance(crack, {.opening = 2e11, .shear = 8e10}).matrix(1, 1);
       })},
      {"torsion_curve",
       repeated([gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml")] {
         const std::vector<double> torques = {0, 14, 28, 48, 87};
         return torsion_curve(gear, {torques}).series_compliance;
       })},
      {"curve_of_200_points",
       [](int count) {
         GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
         gear.circular_spline->support = 0.0;
         gear.range.clear();
         gear.rating.reset();
         std::vector<double> torques;
         for (int i = 1; i <= 200; ++i) torques.push_back(makers_torques(gear).T3 * i / 200);
         for (int n = 0; n < count; ++n) sink += torsion_curve(gear, torques).points.back().twist;
       }},
      {"read_file", repeated([] { return article().load.torque; })}};
  return all;
}

int run(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "--list") {
    for (const auto& [known, kernel] : kernels()) std::printf("%s\n", known.c_str());
    return 0;
  }
  const auto found = kernels().find(name);
  if (argc != 3 || found == kernels().end()) {
    std::fprintf(stderr, "usage: kernels --list | kernels NAME COUNT\n");
    return 2;
  }
  found->second(std::atoi(argv[2]));
  std::printf("%.17g\n", sink);
  return 0;
}

}  // namespace
}  // namespace strainwave

int main(int argc, char** argv) { return strainwave::run(argc, argv); }

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/stress_intensity.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/model/input/material.hpp"

namespace strainwave {
namespace {

struct SifListOptions {
  std::optional<std::string> family;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"family", "", "family to list: plate, tube, bar or gradient"}, &SifListOptions::family);
  }
};

constexpr Field kSolutionName{.name = "name",
                              .unit = "",
                              .doc = "name of the solution",
                              .positional = true,
                              .names = "solution"};

struct SifShowOptions {
  std::string name;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSolutionName, &SifShowOptions::name);
  }
};

constexpr Field kSet{
    .name = "set", .unit = "", .doc = "NAME=VALUE, a field or a load, with its unit; repeatable"};

struct SifEvalOptions {
  std::string name;
  std::vector<std::string> set;
  std::optional<std::string> material;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSolutionName, &SifEvalOptions::name);
    field(kSet, &SifEvalOptions::set);
    field({.name = "material",
           .unit = "",
           .doc = "steel of the material library; if left out, E = 210 GPa and nu = 0.3",
           .names = "material"},
          &SifEvalOptions::material);
  }
};

struct SifPlotOptions {
  std::string name;
  std::vector<std::string> set;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSolutionName, &SifPlotOptions::name);
    field(kSet, &SifPlotOptions::set);
  }
};

struct SifPlot {
  std::string svg;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"svg", "", "the picture"}, &SifPlot::svg);
  }
};

/// Elastic constants and toughness of a steel of the material library.
sif::CrackMaterial crack_material(const std::optional<std::string>& name) {
  if (!name) return {};
  const Material steel = as_material(require_material(*name));
  const ElasticConstants elastic = elastic_constants(steel);
  return {.youngs_modulus = elastic.E,
          .poissons_ratio = elastic.nu,
          .fracture_toughness = steel.fracture_toughness};
}

sif::Evaluation evaluated(const Request&, const SifEvalOptions& options) {
  return from_option([&] {
    const sif::Row& row = sif::solution(options.name);
    return sif::evaluate(row, sif_assignments(row, options.set), crack_material(options.material));
  });
}

constexpr std::string_view kSolutionsDescription =
    "The library has solutions for cracks in plates, tubes, round bars and stress gradients, each "
    "with its modes, validity range, accuracy and source. sif list lists the solutions. sif show "
    "describes one solution. sif eval gives geometry factors, stress intensities under the given "
    "loads and the added compliance matrix, and reports quantities outside the validity range. sif "
    "plot draws the geometry factors over the crack size and along the front. Fields and loads are "
    "set by name, with units; a field left out takes the value that sif show prints.";

}  // namespace

Command sif_list_command() {
  return command<SifListOptions, SolutionList>({
      .name = "sif list",
      .summary = "List all solutions of the library",
      .description = kSolutionsDescription,
      .example = "strainwave sif list --family tube",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const SifListOptions& o) {
            return from_option([&] { return sif_list(o.family.value_or(std::string())); });
          },
      .documents = {{Format::text, sif_list_text}, {Format::markdown, sif_list_markdown}},
  });
}

Command sif_show_command() {
  return command<SifShowOptions, DescribedSolution>({
      .name = "sif show",
      .summary = "Describe one solution",
      .description = kSolutionsDescription,
      .example = "strainwave sif show plate-surface",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const SifShowOptions& o) {
            return from_option([&] { return DescribedSolution{&sif::solution(o.name)}; });
          },
      .documents = {{Format::text, sif_solution_text}},
  });
}

Command sif_eval_command() {
  return command<SifEvalOptions, sif::Evaluation>({
      .name = "sif eval",
      .summary = "Compute stress intensity, geometry factors, added compliance",
      .description = kSolutionsDescription,
      .example = "strainwave sif eval plate-surface --set 'depth=1 mm' --set 'half_length=2 mm' "
                 "--set 'tension=200 MPa'",
      .takes = Takes::nothing,
      .function = evaluated,
      .documents = {{Format::text, sif_evaluation_text}},
  });
}

Command sif_plot_command() {
  return command<SifPlotOptions, SifPlot>({
      .name = "sif plot",
      .summary = "Draw geometry factors over the crack size and along its front",
      .description = kSolutionsDescription,
      .example = "strainwave sif plot plate-surface --output plate-surface.svg",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const SifPlotOptions& o) {
            return from_option([&] {
              const sif::Row& row = sif::solution(o.name);
              return SifPlot{sif_plot(row, sif_assignments(row, o.set))};
            });
          },
      .documents = {{Format::svg, &SifPlot::svg}},
  });
}

}  // namespace strainwave

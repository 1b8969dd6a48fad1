// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/member_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave::fe_study {
namespace {

fem::Elasticity elasticity_of(const GearSet& gear, std::string_view material,
                              std::string_view field) {
  const ElasticConstants steel = elastic_constants(material_of(gear, material, field));
  return {.youngs_modulus = steel.E, .poissons_ratio = steel.nu};
}

/// Measured on one core: seconds = kSeconds * dofs * p^2 for one solution.
constexpr double kSecondsPerDof = 4e-7;
constexpr double kBytesPerDof = 4e3;

RunSize size_of(std::string path, const fem::SectionMesh& mesh, std::size_t components,
                const fem::SectionOptions& options, std::size_t solutions) {
  // A ring adds twelve cells at a crack tip, nine at a corner.
  const auto cells = static_cast<double>(mesh.cells.size()) +
                     (mesh.crack ? 12.0 * options.tip_rings : 0.0) +
                     9.0 * options.corner_rings * static_cast<double>(mesh.corners.size());
  const double p = options.order;
  const double dofs = cells * p * p * static_cast<double>(components);
  return {.path = std::move(path),
          .dofs = static_cast<std::size_t>(dofs),
          .memory = 2e8 + kBytesPerDof * dofs,
          .seconds = kSecondsPerDof * dofs * p * p * static_cast<double>(solutions),
          .solutions = solutions};
}

/// What is asked for, and may be.
struct Work {
  bool shaft = false;
  bool flexspline = false;
  std::vector<std::string> notes;
};

Work work_of(const GearSet& gear, const RunOptions& options) {
  check(gear);
  require(options.order >= 2 && options.order <= 8, "order", options.order, "1", ">= 2 and <= 8");
  const auto asked = [&](Member member) { return !options.member || *options.member == member; };
  Work work{.notes = {}};
  if (options.member == Member::output_shaft && !gear.output_shaft)
    throw InputError("output_shaft", "is not given, so there is nothing to calculate");
  if (options.member == Member::flexspline && !gear.flexspline)
    throw InputError("flexspline", "is not given, so there is nothing to calculate");
  if (gear.output_shaft && asked(Member::output_shaft)) {
    work.shaft = !gear.output_shaft->crack.empty();
    if (!work.shaft && options.member)
      throw InputError("output_shaft.crack",
                       "there is none, and a sound shaft of one diameter needs no finite elements");
  }
  if (gear.flexspline && asked(Member::flexspline)) {
    const bool sections = gear.flexspline->crack_free == CrackFree::sections;
    if (options.member || sections) {
      (void)gear_fem::cup_section(*gear.flexspline);
      if (!gear.flexspline->crack.empty()) {
        if (options.member)
          throw InputError("flexspline.crack[0]",
                           "a crack in the flexspline is not axisymmetric, and the finite elements "
                           "of this version are: take it out to calculate the sound cup");
        work.notes.push_back(
            "the flexspline is calculated without its cracks, which are not axisymmetric");
      }
      work.flexspline = true;
    } else {
      work.notes.push_back(
          "the flexspline is left out: crack_free = \"factor\" gives no geometry of it");
    }
  }
  if (!work.shaft && !work.flexspline)
    throw InputError("drive",
                     "gives nothing that finite elements can calculate: an output shaft "
                     "with an annular crack, or a flexspline by sections");
  const auto contradiction = [&](const std::string& material, std::string_view field) {
    const Material& steel = material_of(gear, material, field);
    if (std::abs(elastic_contradiction(steel)) > 1e-6)
      work.notes.push_back(
          fmt::format("{}: the shear modulus is E/(2(1+nu)), {:.5g} GPa, and not the given one",
                      field, elasticity_of(gear, material, field).shear_modulus() / 1e9));
  };
  if (work.shaft) contradiction(gear.output_shaft->material, "output_shaft.material");
  if (work.flexspline) contradiction(gear.flexspline->material, "flexspline.material");
  if (work.shaft && gear.output_shaft->crack.size() > 1)
    work.notes.push_back("each crack of the output shaft is calculated alone, halfway along it");
  return work;
}

std::string crack_path(std::size_t n) { return fmt::format("output_shaft.crack[{}]", n); }

}  // namespace

std::string_view member_name(Member member) {
  return member == Member::output_shaft ? "output-shaft" : "flexspline";
}

bool RunResult::usable() const { return reason().empty(); }

std::string RunResult::reason() const {
  for (const ShaftCrackRun& crack : shaft_cracks)
    for (const auto* const load : {&crack.result.torsion, &crack.result.tension})
      if (!load->usable) return fmt::format("{}: {}", crack.path, load->reason);
  if (cup && !cup->usable) return fmt::format("flexspline: {}", cup->reason);
  return {};
}

std::vector<RunSize> plan(const GearSet& gear, const RunOptions& options) {
  const Work work = work_of(gear, options);
  const fem::SectionOptions section{.order = options.order};
  std::vector<RunSize> sizes;
  if (work.shaft)
    for (std::size_t n = 0; n < gear.output_shaft->crack.size(); ++n)
      sizes.push_back(size_of(crack_path(n),
                              gear_fem::mesh_shaft(gear_fem::shaft_section(*gear.output_shaft, n)),
                              2, section, 14));
  if (work.flexspline)
    sizes.push_back(size_of(
        "flexspline", gear_fem::mesh_cup(gear_fem::cup_section(*gear.flexspline)), 1, section, 2));
  return sizes;
}

RunResult run(const GearSet& gear, const RunOptions& options) {
  Work work = work_of(gear, options);
  RunResult result{.order = options.order, .shaft_cracks = {}, .cup = {}, .notes = work.notes};
  const fem::SectionOptions section{.order = options.order};
  if (work.shaft) {
    const OutputShaft& shaft = *gear.output_shaft;
    const auto steel = elasticity_of(gear, shaft.material, "output_shaft.material");
    for (std::size_t n = 0; n < shaft.crack.size(); ++n) {
      const auto geometry = gear_fem::shaft_section(shaft, n);
      result.shaft_cracks.push_back(
          {crack_path(n), geometry, gear_fem::solve_shaft(geometry, steel, section)});
    }
  }
  if (work.flexspline)
    result.cup = gear_fem::solve_cup(
        gear_fem::cup_section(*gear.flexspline),
        elasticity_of(gear, gear.flexspline->material, "flexspline.material"), section);
  return result;
}

}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/member_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/mesh_size.hpp"

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

/// The same for solids, order 3; a solid of order p costs about (p/3)^2 of that per unknown.
constexpr double kSolidSecondsPerDof = 1e-4;
constexpr double kSolidBytesPerDof = 1.5e4;
/// Three crack sizes opened, and the same closed; the contact of all three costs two more.
constexpr std::size_t kTubeSolutions = 8;

/// The wall that carries a crack, alone: a tube.
TubeSection wall_of(const GearSet& gear, WallSection section) {
  const Flexspline& fs = *gear.flexspline;
  if (fs.crack_free == CrackFree::factor)
    return {.outer_diameter = gear.drive.pitch_diameter,
            .wall_thickness = fs.wall_thickness,
            .length = fs.length};
  return section == WallSection::rim ? *fs.rim : *fs.barrel;
}

gear_fem::TubeWithThroughCrack tube_of(const GearSet& gear, const WallThroughCrack& crack,
                                       int order) {
  const TubeSection wall = wall_of(gear, crack.section);
  return {.material = elasticity_of(gear, gear.flexspline->material, "flexspline.material"),
          .mean_radius = (wall.outer_diameter - wall.wall_thickness) / 2,
          .wall_thickness = wall.wall_thickness,
          .length = wall.length,
          .half_length = crack.half_length,
          .angle = crack.angle,
          .torque = std::abs(gear.load.torque),
          .sense = TorqueSense::positive,
          .order = order};
}

std::string wall_crack_path(std::size_t n) { return fmt::format("flexspline.crack[{}]", n); }

/// One crack of the work list.
struct WallCrack {
  std::string path;
  gear_fem::TubeWithThroughCrack tube;
  std::size_t dofs = 0;
};

/// Meshes it, so that one that does not fit is refused before anything is solved.
WallCrack wall_crack(const GearSet& gear, std::size_t n, const WallThroughCrack& crack, int order) {
  WallCrack result{.path = wall_crack_path(n), .tube = tube_of(gear, crack, order)};
  try {
    const fem::HexMesh mesh = gear_fem::mesh_tube_with_through_crack(result.tube);
    (void)fem::check_jacobians(mesh);
    result.dofs = fem::count_unknowns(mesh, order);
  } catch (const InputError& error) {
    throw InputError(result.path, error.what());
  }
  return result;
}

/// What is asked for, and may be.
struct Work {
  bool shaft = false;
  bool cup = false;
  std::vector<WallCrack> wall_cracks;
  std::vector<std::string> notes;
};

void add_flexspline(Work& work, const GearSet& gear, const RunOptions& options) {
  const Flexspline& flexspline = *gear.flexspline;
  const int order = options.order.value_or(kSolidOrder);
  for (std::size_t n = 0; n < flexspline.crack.size(); ++n) {
    const auto* const through = std::get_if<WallThroughCrack>(&flexspline.crack[n]);
    if (through == nullptr) {
      const std::string_view kind =
          std::visit([](const auto& crack) { return crack.kKind; }, flexspline.crack[n]);
      const std::string problem = fmt::format(
          "a crack of kind \"{}\" is not calculated by finite elements, only through cracks of the "
          "wall are",
          kind);
      if (options.member) throw InputError(wall_crack_path(n), problem + ": take it out");
      work.notes.push_back(fmt::format("{} is left out: {}", wall_crack_path(n), problem));
      continue;
    }
    require(order <= 4, "order", order, "1", "<= 4 for a through crack of the flexspline");
    work.wall_cracks.push_back(wall_crack(gear, n, *through, order));
  }
  if (!work.wall_cracks.empty()) {
    work.notes.push_back(
        "each through crack is calculated alone, halfway along its section of the wall, a tube "
        "that is clamped at one end and twisted at the other");
    if (gear.load.axial_force != 0)
      work.notes.push_back("the axial force is not applied to the flexspline");
    if (flexspline.stress_nonuniformity != 1)
      work.notes.push_back(
          "flexspline.stress_nonuniformity is not applied: finite elements find their own stress");
  }
  work.cup = flexspline.crack_free == CrackFree::sections;
  if (work.cup) {
    (void)gear_fem::cup_section(flexspline);
    if (!flexspline.crack.empty())
      work.notes.push_back(
          "the cup of rim, barrel, diaphragm and boss is calculated without cracks");
  } else if (options.member && work.wall_cracks.empty()) {
    (void)gear_fem::cup_section(flexspline);  // says what is missing
  } else {
    work.notes.push_back(
        "the sound flexspline is left out: crack_free = \"factor\" gives no geometry of it");
  }
}

Work work_of(const GearSet& gear, const RunOptions& options) {
  check(gear);
  if (options.order)
    require(*options.order >= 2 && *options.order <= 8, "order", *options.order, "1",
            ">= 2 and <= 8");
  const auto asked = [&](Member member) { return !options.member || *options.member == member; };
  Work work;
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
  if (gear.flexspline && asked(Member::flexspline)) add_flexspline(work, gear, options);
  if (!work.shaft && !work.cup && work.wall_cracks.empty())
    throw InputError("drive",
                     "gives nothing that finite elements can calculate: an output shaft "
                     "with an annular crack, a through crack of the flexspline's wall, or a "
                     "flexspline by sections");
  const auto contradiction = [&](const std::string& material, std::string_view field) {
    const Material& steel = material_of(gear, material, field);
    if (std::abs(elastic_contradiction(steel)) > 1e-6)
      work.notes.push_back(
          fmt::format("{}: the shear modulus is E/(2(1+nu)), {:.5g} GPa, and not the given one",
                      field, elasticity_of(gear, material, field).shear_modulus() / 1e9));
  };
  if (work.shaft) contradiction(gear.output_shaft->material, "output_shaft.material");
  if (work.cup || !work.wall_cracks.empty())
    contradiction(gear.flexspline->material, "flexspline.material");
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
  for (const TubeCrackRun& crack : wall_cracks)
    for (const auto* const one : {&crack.positive, &crack.negative})
      if (!one->usable)
        return fmt::format("{}, {} torque: {}", crack.path,
                           one == &crack.positive ? "positive" : "negative", one->reason);
  return {};
}

std::vector<RunSize> plan(const GearSet& gear, const RunOptions& options) {
  const Work work = work_of(gear, options);
  const fem::SectionOptions section{.order = options.order.value_or(kSectionOrder)};
  std::vector<RunSize> sizes;
  if (work.shaft)
    for (std::size_t n = 0; n < gear.output_shaft->crack.size(); ++n)
      sizes.push_back(size_of(crack_path(n),
                              gear_fem::mesh_shaft(gear_fem::shaft_section(*gear.output_shaft, n)),
                              2, section, 14));
  if (work.cup)
    sizes.push_back(size_of(
        "flexspline", gear_fem::mesh_cup(gear_fem::cup_section(*gear.flexspline)), 1, section, 2));
  for (const WallCrack& crack : work.wall_cracks) {
    const auto dofs = static_cast<double>(crack.dofs);
    const double p = crack.tube.order / 3.0;
    sizes.push_back({.path = crack.path,
                     .dofs = crack.dofs,
                     .memory = 2e8 + kSolidBytesPerDof * dofs,
                     .seconds = kSolidSecondsPerDof * dofs * p * p * kTubeSolutions,
                     .solutions = kTubeSolutions});
  }
  return sizes;
}

RunResult run(const GearSet& gear, const RunOptions& options, const fem::MpiSession& session) {
  const Work work = work_of(gear, options);
  RunResult result{.section_order = options.order.value_or(kSectionOrder),
                   .solid_order = options.order.value_or(kSolidOrder),
                   .shaft_cracks = {},
                   .cup = {},
                   .wall_cracks = {},
                   .notes = work.notes};
  // First what all ranks do together: an error of the first rank alone must not leave them waiting.
  for (const WallCrack& crack : work.wall_cracks) {
    gear_fem::TubeWithThroughCrack tube = crack.tube;
    TubeCrackRun done{.path = crack.path, .tube = tube, .positive = {}, .negative = {}};
    done.positive = gear_fem::solve_tube_with_through_crack(tube);
    tube.sense = TorqueSense::negative;
    done.negative = gear_fem::solve_tube_with_through_crack(tube);
    result.wall_cracks.push_back(std::move(done));
  }
  if (session.rank() != 0) return result;
  const fem::SectionOptions section{.order = options.order.value_or(kSectionOrder)};
  if (work.shaft) {
    const OutputShaft& shaft = *gear.output_shaft;
    const auto steel = elasticity_of(gear, shaft.material, "output_shaft.material");
    for (std::size_t n = 0; n < shaft.crack.size(); ++n) {
      const auto geometry = gear_fem::shaft_section(shaft, n);
      result.shaft_cracks.push_back(
          {crack_path(n), geometry, gear_fem::solve_shaft(geometry, steel, section)});
    }
  }
  if (work.cup)
    result.cup = gear_fem::solve_cup(
        gear_fem::cup_section(*gear.flexspline),
        elasticity_of(gear, gear.flexspline->material, "flexspline.material"), section);
  return result;
}

}  // namespace strainwave::fe_study

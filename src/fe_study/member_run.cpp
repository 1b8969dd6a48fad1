// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/member_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "cup_notes.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fem/mesh_size.hpp"
#include "wall_tubes.hpp"

namespace strainwave::fe_study {
namespace {

constexpr const char* kFlexspline = "flexspline";

/// Time of one solution, seconds = kSecondsPerDof * dofs * p.  Measurements on one core at p = 4..8
/// differ by -20 to +80 %.
constexpr double kSecondsPerDof = 3e-7;
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
          .memory = kProgramBytes + kBytesPerDof * dofs,
          .seconds = kSecondsPerDof * dofs * p * static_cast<double>(solutions),
          .solutions = solutions};
}

/// Two crack sizes, each with one factorisation for both senses of torque.
constexpr std::size_t kTubeSolutions = 2;
/// Number of solutions; fields of a cup add the sound cup.
std::size_t tube_solutions(const gear_fem::TubeWithThroughCrack& tube, RunFields fields) {
  return kTubeSolutions + (tube.ends.any() && fields != RunFields::none ? 1 : 0);
}
/// Solutions of a surface crack; a fully closed crack needs only the first, because it is not
/// compared with another size.
constexpr std::size_t kSurfaceSolutions = 2;

std::string crack_path(std::size_t n) { return fmt::format("output_shaft.crack[{}]", n); }

std::string wall_crack_path(std::size_t n) { return fmt::format("flexspline.crack[{}]", n); }

/// One crack of the work list.
template <class Tube>
struct WallCrack {
  std::string path;
  Tube tube;
  std::size_t dofs = 0;
};

/// Meshes a crack, so a crack that does not fit is refused before the first solution.
template <class Tube>
WallCrack<Tube> wall_crack(std::size_t n, const Tube& tube) {
  WallCrack<Tube> result{.path = wall_crack_path(n), .tube = tube};
  try {
    const fem::HexMesh mesh = mesh_of(tube);
    (void)fem::check_jacobians(mesh);
    result.dofs = fem::count_unknowns(mesh, tube.order);
  } catch (const InputError& error) {
    throw InputError(result.path, error.what());
  }
  return result;
}

template <class Tube>
RunSize size_of(const WallCrack<Tube>& crack, std::size_t solutions) {
  return size_of_solid(crack.path, crack.dofs, solutions);
}

/// The requested parts that can be computed.
struct Work {
  std::vector<std::size_t> shaft;  ///< cracks of the shaft
  bool cup = false;
  std::vector<WallCrack<gear_fem::TubeWithThroughCrack>> wall_cracks;
  std::vector<WallCrack<gear_fem::TubeWithSurfaceCrack>> surface_cracks;
  std::vector<Note> notes;

  [[nodiscard]] bool has_wall_cracks() const {
    return !wall_cracks.empty() || !surface_cracks.empty();
  }
};

/// Refuses a crack of a kind without finite elements if the user asked for it, and notes it
/// otherwise.
/// @param computed  the kinds that finite elements compute in this member
template <class Crack>
void leave_out(Work& work, const RunOptions& options, const std::string& path, const Crack& crack,
               std::string_view computed) {
  const std::string_view kind =
      std::visit([](const auto& one) -> std::string_view { return one.kKind; }, crack);
  const std::string problem =
      fmt::format("finite elements do not compute a crack of kind \"{}\", {}", kind, computed);
  if (options.crack) throw InputError(path, problem);
  if (options.member)
    throw InputError(path, problem + "; remove it or choose other cracks by --crack");
  work.notes.push_back({"fe.crack_left_out", fmt::format("{} is left out: {}", path, problem), path,
                        "", Severity::care});
}

void add_shaft(Work& work, const OutputShaft& shaft, const RunOptions& options) {
  for (std::size_t n = 0; n < shaft.crack.size(); ++n) {
    if (options.crack && options.crack != crack_path(n)) continue;
    if (std::holds_alternative<AnnularCrack>(shaft.crack[n]))
      work.shaft.push_back(n);
    else
      leave_out(work, options, crack_path(n), shaft.crack[n], "only annular cracks of a shaft");
  }
  if (shaft.crack.empty() && options.member)
    throw InputError(
        "output_shaft.crack",
        "must be given, because a sound shaft of one diameter does not need finite elements");
}

void add_flexspline(Work& work, const GearSet& gear, const RunOptions& options) {
  const Flexspline& flexspline = *gear.flexspline;
  const int order = options.order.value_or(kSolidOrder);
  for (std::size_t n = 0; n < flexspline.crack.size(); ++n) {
    if (options.crack && options.crack != wall_crack_path(n)) continue;
    const FlexsplineCrack& crack = flexspline.crack[n];
    const auto* const through = std::get_if<WallThroughCrack>(&crack);
    const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
    if (through == nullptr && surface == nullptr) {
      leave_out(work, options, wall_crack_path(n), crack,
                "only through and surface cracks of the wall");
      continue;
    }
    require(order <= 4, "order", order, "1", "<= 4 for a crack of the flexspline's wall");
    const int count = through != nullptr ? through->count : surface->count;
    require(count == 1, wall_crack_path(n) + ".count", count, "1",
            "1, because the mesh contains one crack");
    if (through != nullptr)
      work.wall_cracks.push_back(
          wall_crack(n, tube_of(gear, *through, order, options.surroundings)));
    else
      work.surface_cracks.push_back(wall_crack(n, tube_of(gear, *surface, order)));
  }
  if (work.has_wall_cracks()) {
    const auto in_cups = std::ranges::count_if(
        work.wall_cracks, [](const auto& crack) { return crack.tube.ends.any(); });
    if (in_cups > 0)
      work.notes.push_back(
          {"fe.crack_in_cup",
           "each through crack of the barrel is computed alone, at its distance or half-way along "
           "the barrel, in the cup of the sections, held at its boss or bore and twisted at the "
           "open end",
           kFlexspline, "", Severity::information});
    if (static_cast<std::size_t>(in_cups) < work.wall_cracks.size() || !work.surface_cracks.empty())
      work.notes.push_back(
          {"fe.crack_in_tube",
           fmt::format("each {} is computed alone, at its distance or half-way along its section, "
                       "as a tube that "
                       "is clamped at one end and twisted at the other",
                       in_cups > 0 ? "other crack of the wall" : "crack of the wall"),
           kFlexspline, "", Severity::care});
    if (has_other_rim(flexspline) && !work.wall_cracks.empty())
      work.notes.push_back(
          {"fe.rim_apart",
           "the rim's wall does not cover the barrel's wall, so no crack is computed in the cup",
           "flexspline.rim", "", Severity::care});
    const auto without_mouth = [](const FlexsplineCrack& crack) {
      const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
      return surface != nullptr && !surface->mouth;
    };
    if (!work.surface_cracks.empty() && std::ranges::any_of(flexspline.crack, without_mouth))
      work.notes.push_back({"fe.mouth_outside",
                            "the mouth of a surface crack is assumed on the outer surface, because "
                            "the file does not state it",
                            kFlexspline, "", Severity::care});
    add_load_notes(work.notes, gear);
  }
  if (options.crack) return;
  work.cup = flexspline.crack_free == CrackFree::sections;
  if (work.cup) {
    (void)gear_fem::cup_section(flexspline);
    if (!flexspline.crack.empty())
      work.notes.push_back(
          {"fe.sound_without_cracks",
           "the sound flexspline is computed as a body of revolution, without cracks", kFlexspline,
           "", Severity::information});
  } else if (options.member && !work.has_wall_cracks()) {
    (void)gear_fem::cup_section(flexspline);  // throws and names the missing field
  } else {
    work.notes.push_back({"fe.sound_left_out",
                          "the sound flexspline is left out, because crack_free = \"factor\" does "
                          "not give its geometry",
                          "flexspline.crack_free", "", Severity::information});
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
    throw InputError("output_shaft", "must be given to be computed");
  if (options.member == Member::flexspline && !gear.flexspline)
    throw InputError("flexspline", "must be given to be computed");
  if (gear.output_shaft && asked(Member::output_shaft))
    add_shaft(work, *gear.output_shaft, options);
  if (gear.flexspline && asked(Member::flexspline)) add_flexspline(work, gear, options);
  const bool nothing = work.shaft.empty() && !work.cup && !work.has_wall_cracks();
  if (nothing && options.crack)
    throw InputError("--crack", fmt::format("\"{}\" is not a crack of the selected members",
                                            shown(*options.crack)));
  if (nothing)
    throw InputError(
        "drive",
        "must give a part that finite elements can compute: an output shaft with an annular crack, "
        "a through or surface crack of the flexspline's wall, or a flexspline by sections");
  const auto contradiction = [&](const std::string& material, std::string_view field) {
    const Material& steel = material_of(gear, material, field);
    if (std::abs(elastic_contradiction(steel)) > 1e-6)
      work.notes.push_back(
          {"fe.shear_modulus",
           fmt::format("{}: finite elements use the shear modulus E/(2(1+nu)), {:.5g} GPa, not the "
                       "given one",
                       field, elasticity_of(gear, material, field).shear_modulus() / 1e9),
           std::string(field), "", Severity::care});
  };
  if (!work.shaft.empty()) contradiction(gear.output_shaft->material, "output_shaft.material");
  if (work.cup || work.has_wall_cracks())
    contradiction(gear.flexspline->material, "flexspline.material");
  if (work.shaft.size() > 1)
    work.notes.push_back({"fe.shaft_cracks_alone",
                          "each crack of the output shaft is computed alone, at half length",
                          "output_shaft", "", Severity::care});
  return work;
}

/// Sizes of all parts of the work.
std::vector<RunSize> sizes_of(const Work& work, const GearSet& gear, const RunOptions& options) {
  const fem::SectionOptions section{.order = options.order.value_or(kSectionOrder)};
  std::vector<RunSize> sizes;
  for (const std::size_t n : work.shaft)
    sizes.push_back(size_of(crack_path(n),
                            gear_fem::mesh_shaft(gear_fem::shaft_section(*gear.output_shaft, n)), 2,
                            section, 14));
  if (work.cup)
    sizes.push_back(size_of(
        "flexspline", gear_fem::mesh_cup(gear_fem::cup_section(*gear.flexspline)), 1, section, 2));
  for (const auto& crack : work.wall_cracks)
    sizes.push_back(size_of(crack, tube_solutions(crack.tube, options.fields)));
  for (const auto& crack : work.surface_cracks) sizes.push_back(size_of(crack, kSurfaceSolutions));
  return sizes;
}

}  // namespace

StressIntensity ShaftCrackRun::at_load() const {
  return {.K_I = opens() ? result.tension.tip.K_I * force : 0.0,
          .K_II = opens() ? result.tension.tip.K_II * force : 0.0,
          .K_III = result.torsion.tip.K_III * torque};
}

std::string RunResult::reason() const {
  for (const ShaftCrackRun& crack : output_shaft.cracks)
    for (const auto* const load : crack.result.loads())
      if (!load->usable) return fmt::format("{}: {}", crack.path, load->reason);
  if (flexspline.sound && !flexspline.sound->usable)
    return fmt::format("flexspline: {}", flexspline.sound->reason);
  const auto sense = [](const auto& crack) -> std::string {
    for (const auto* const one : {&crack.positive, &crack.negative})
      if (!one->usable)
        return fmt::format("{}, {} torque: {}", crack.path,
                           one == &crack.positive ? "positive" : "negative", one->reason);
    return {};
  };
  for (const WallCrackRun& crack : flexspline.cracks)
    if (std::string why = std::visit(sense, crack); !why.empty()) return why;
  return {};
}

ResultEvidence evidence_of(const RunResult& result) {
  ResultEvidence evidence{
      .unusable_because = result.refused.empty() ? result.reason() : result.refused,
      .refused = !result.refused.empty(),
      .verdict = {},
      .notes = result.notes,
      .equations = {},
      .accuracies = {},
      .requirement = {}};
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  std::set<std::string> equations;
  if (!result.output_shaft.cracks.empty())
    equations.insert({"FE-3", "FE-6", "FE-7", "FE-8", "FE-9"});
  if (result.flexspline.sound) equations.insert({"FE-1", "FE-4", "FE-10"});
  for (const WallCrackRun& crack : result.flexspline.cracks) {
    equations.insert({"FE-23", "FE-24", "FE-26"});
    equations.insert(std::holds_alternative<TubeCrackRun>(crack) ? "FE-28" : "FE-34");
  }
  evidence.equations.assign(equations.begin(), equations.end());
  return evidence;
}

namespace {

/// The parts of a result that are known before the first solution.
RunResult planned(Work& work, const GearSet& gear, const RunOptions& options) {
  return {.plan = sizes_of(work, gear, options),
          .calculated = false,
          .refused = {},
          .section_order = options.order.value_or(kSectionOrder),
          .solid_order = options.order.value_or(kSolidOrder),
          .output_shaft = {},
          .flexspline = {},
          .notes = std::move(work.notes)};
}

fem::FieldRequest fields_of(RunFields fields, int divisions) {
  if (fields == RunFields::none) return {};
  return {.divisions = divisions, .every_cell = fields == RunFields::everywhere};
}

/// A crack of the wall under both senses of torque.
template <class Run, class Tube>
Run both_senses(const WallCrack<Tube>& crack, const RunOptions& options, std::size_t solutions) {
  Tube tube = crack.tube;
  tube.fields = fields_of(options.fields, 2 * tube.order);
  std::size_t solution = 0;
  tube.solved = [&](const fem::SolidResult& solid, double seconds) {
    ++solution;
    if (!options.progress) return;
    options.progress(fmt::format(
        "{}, torque +-{:.6g} N*m: solution {} of at most {}, {:.0f} k unknowns, {:.1f} s",
        crack.path, tube.torque, solution, solutions, static_cast<double>(solid.dofs) / 1e3,
        seconds));
  };
  auto [positive, negative] = gear_fem::solve_both_senses(tube);
  return {.path = crack.path,
          .tube = crack.tube,
          .positive = std::move(positive),
          .negative = std::move(negative)};
}

}  // namespace

RunResult plan(const GearSet& gear, const RunOptions& options) {
  Work work = work_of(gear, options);
  return planned(work, gear, options);
}

RunResult run(const GearSet& gear, const RunOptions& options, const Ranks& ranks) {
  Work work = work_of(gear, options);
  RunResult result = planned(work, gear, options);
  require_memory(result.plan, ranks);
  result.calculated = true;
  const auto say = [&](const std::string& line) {
    if (options.progress) options.progress(line);
  };
  // Do the work of all ranks first, so an error of the first rank alone does not leave the others
  // waiting.
  for (const auto& crack : work.wall_cracks)
    result.flexspline.cracks.emplace_back(
        both_senses<TubeCrackRun>(crack, options, tube_solutions(crack.tube, options.fields)));
  for (const auto& crack : work.surface_cracks)
    result.flexspline.cracks.emplace_back(
        both_senses<SurfaceCrackRun>(crack, options, kSurfaceSolutions));
  if (!ranks.first()) return result;
  const int order = options.order.value_or(kSectionOrder);
  const fem::SectionOptions section{.order = order, .fields = fields_of(options.fields, order)};
  if (!work.shaft.empty()) {
    const OutputShaft& shaft = *gear.output_shaft;
    const auto steel = elasticity_of(gear, shaft.material, "output_shaft.material");
    for (const std::size_t n : work.shaft) {
      const auto geometry = gear_fem::shaft_section(shaft, n);
      const auto start = std::chrono::steady_clock::now();
      result.output_shaft.cracks.push_back(
          {.path = crack_path(n),
           .section = geometry,
           .result = gear_fem::solve_shaft(geometry, steel, section),
           .elasticity = steel,
           .torque = gear.load.torque,
           .force = gear.load.axial_force});
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      say(fmt::format("{}: torsion and tension, 14 solutions, {:.1f} s", crack_path(n),
                      taken.count()));
    }
  }
  if (work.cup)
    result.flexspline.sound = gear_fem::solve_cup(gear_fem::cup_section(*gear.flexspline),
                                                  elasticity_of(gear, *gear.flexspline), section);
  return result;
}

}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/core/ranks.hpp"
#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/gear_fem/shaft_section.hpp"
#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// Finite elements of the members of a drive, from its input file: what `strainwave-fe run` does.

namespace strainwave {

namespace fe_study {

/// The members that finite elements know.
enum class Member { output_shaft, flexspline };

}  // namespace fe_study

template <>
struct EnumNames<fe_study::Member> {
  static constexpr std::array<std::string_view, 2> names = {"output-shaft", "flexspline"};
};

namespace fe_study {

inline constexpr int kSectionOrder = 6;  ///< p of bodies of revolution
inline constexpr int kSolidOrder = 3;    ///< p of solids

/// Whether a run samples its solutions: elements of order p by p points each way, of solids p+1.
enum class RunFields {
  none,
  of_rank,     ///< each rank its own cells, for files
  everywhere,  ///< each rank all cells, for pictures
};

/// What a through crack of the barrel is calculated in.
enum class Surroundings {
  as_given,  ///< the cup, where the file has rim, diaphragm or boss
  none,      ///< a tube
};

struct RunOptions {
  std::optional<Member> member = {};  ///< nothing: every member that the file gives
  /// p; in 2..8, of solids in 2..4; nothing: kSectionOrder and kSolidOrder
  std::optional<int> order = {};
  /// Path of the only crack that is calculated, "flexspline.crack[0]", and nothing else; nothing:
  /// all of the members asked for
  std::optional<std::string> crack = {};
  /// Called with one line after each solution, on every rank; may be empty.
  std::function<void(const std::string&)> progress = {};
  RunFields fields = RunFields::none;
  Surroundings surroundings = Surroundings::as_given;
};

/// Size of one calculation, before it is done.
struct RunSize {
  std::string path;           ///< "output_shaft.crack[0]" or "flexspline"
  std::size_t dofs = 0;       ///< of its largest solution; of solids exact, else within 10 %
  double memory = 0.0;        ///< estimate, of one rank alone [byte]; (FE-44)
  double seconds = 0.0;       ///< estimate for one core [s]
  std::size_t solutions = 0;  ///< how many are solved
  bool divided = false;       ///< among the ranks of MPI; else the first does it all

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "crack or member"}, &RunSize::path);
    field({"unknowns", "", "of its largest solution"}, &RunSize::dofs);
    field({"solutions", "", "how many are solved"}, &RunSize::solutions);
    field({"memory_bytes", "", "estimate of one process alone"},
          [](const RunSize& size) { return static_cast<std::int64_t>(size.memory); });
    field({"time", "s", "estimate for one core"}, &RunSize::seconds);
  }
};

/// Stress intensity at one place of a front [Pa*m^0.5].
struct StressIntensity {
  double K_I = 0.0;
  double K_II = 0.0;
  double K_III = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K_I", "Pa*m^0.5", "opening; 0 where the crack is closed"}, &StressIntensity::K_I);
    field({"K_II", "Pa*m^0.5", "sliding; 0 where the crack is closed"}, &StressIntensity::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &StressIntensity::K_III);
  }
};

/// One crack of the output shaft.
struct ShaftCrackRun {
  std::string path;
  gear_fem::ShaftSection section;
  gear_fem::ShaftCrackResult result;
  fem::Elasticity elasticity;
  double torque = 0.0;  ///< given [N*m]
  double force = 0.0;   ///< given, axial [N]

  /// Whether the force leaves the faces apart.
  [[nodiscard]] bool opens() const { return force >= 0; }
  /// At the given load: modes I and II of the force, III of the torque.
  [[nodiscard]] StressIntensity at_load() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = ShaftCrackRun;
    field({"path", "", "the crack in the input file"}, &R::path);
    field({"kind", "", "annular"}, [](const R&) { return AnnularCrack::kKind; });
    field({"depth", "m", "a"}, [](const R& r) { return r.section.crack->depth; });
    field({"opens", "", "whether the axial force leaves the faces apart"}, &R::opens);
    field({"stress_intensity", "", "at the given load"}, &R::at_load);
    field(
        {"torsion", "", "by a torque of 1 N*m"},
        [](const R& r) -> const auto& { return r.result.torsion; });
    field(
        {"tension", "", "by a force of 1 N"},
        [](const R& r) -> const auto& { return r.result.tension; });
  }
};

/// What both kinds of crack of the wall have.
template <class Run, class Visitor>
void describe_wall_crack(Visitor& field) {
  field({"path", "", "the crack in the input file"}, &Run::path);
  field({"half_length", "m", "of the crack"}, [](const Run& r) { return r.tube.half_length; });
  field({"angle", "rad", "from the generator"}, [](const Run& r) { return r.tube.angle; });
  field({"torque", "N*m", "given, without its sense"}, [](const Run& r) { return r.tube.torque; });
  field({"compliance_without", "rad/(N*m)", "of the body without the crack"},
        [](const Run& r) { return r.positive.compliance_without; });
  field({"positive", "", "under a torque > 0"}, &Run::positive);
  field({"negative", "", "under a torque < 0"}, &Run::negative);
}

/// One through crack of the flexspline's wall, in a tube or, with `tube.ends`, in the cup, at the
/// size of the given torque and both senses.
struct TubeCrackRun {
  static constexpr std::string_view kKind = WallThroughCrack::kKind;
  std::string path;
  gear_fem::TubeWithThroughCrack tube;
  gear_fem::TubeCrackResult positive;  ///< torque > 0
  gear_fem::TubeCrackResult negative;  ///< torque < 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TubeCrackRun;
    describe_wall_crack<R>(field);
    field({"body", "", "what has the crack: tube or cup"},
          [](const R& r) { return std::string_view(r.tube.ends.any() ? "cup" : "tube"); });
  }
};

/// One part-through crack of the flexspline's wall, its mouth on the outer surface, at the size of
/// the given torque and both senses.
struct SurfaceCrackRun {
  static constexpr std::string_view kKind = WallSurfaceCrack::kKind;
  std::string path;
  gear_fem::TubeWithSurfaceCrack tube;
  gear_fem::TubeSurfaceCrackResult positive;  ///< torque > 0
  gear_fem::TubeSurfaceCrackResult negative;  ///< torque < 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = SurfaceCrackRun;
    describe_wall_crack<R>(field);
    field({"mouth", "", "the surface that the crack starts from"},
          [](const R&) { return std::string_view("outer"); });
    field({"depth", "m", "a"}, [](const R& r) { return r.tube.depth; });
  }
};

using WallCrackRun = std::variant<TubeCrackRun, SurfaceCrackRun>;

/// What was run of the output shaft.
struct ShaftRun {
  std::vector<ShaftCrackRun> cracks;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"cracks", "", "each alone"}, &ShaftRun::cracks);
  }
};

/// What was run of the flexspline.
struct FlexsplineRun {
  std::optional<gear_fem::CupResult> sound;
  std::vector<WallCrackRun> cracks;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"sound", "", "without its cracks, in torsion"}, &FlexsplineRun::sound);
    field({"cracks", "", "of the wall, each alone"}, &FlexsplineRun::cracks);
  }
};

/// Everything that was run.
struct RunResult {
  std::vector<RunSize> plan;  ///< estimated before
  bool calculated = false;    ///< else there is a plan only
  std::string refused;        ///< why the plan cannot be calculated here; empty: it can
  int section_order = 0;      ///< of shaft and sound cup
  int solid_order = 0;        ///< of cracks of the wall
  ShaftRun output_shaft;
  FlexsplineRun flexspline;
  std::vector<Note> notes;  ///< what finite elements leave out, or see otherwise
  /// True if every part may be used.
  [[nodiscard]] bool usable() const { return reason().empty(); }
  /// The first reason why not; empty if it may.
  [[nodiscard]] std::string reason() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"plan", "", "estimates made before"}, &RunResult::plan);
    field({"calculated", "", "false of a dry run"}, &RunResult::calculated);
    field({"section_order", "", "p of the elements of shaft and sound flexspline"},
          &RunResult::section_order);
    field({"solid_order", "", "p of the elements of cracks of the wall"}, &RunResult::solid_order);
    field({"output_shaft", "", "with annular cracks"}, &RunResult::output_shaft);
    field({"flexspline", "", "sound, and with cracks of its wall"}, &RunResult::flexspline);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const RunResult& result);

/// Plans a run: all of a result but what is calculated.
/// @throws InputError  for what finite elements cannot do, by name: a member that the file does not
///                     give, a crack of the flexspline that is not one of the wall or does not
///                     fit into it, a sound flexspline without sections, an order out of
///                     range, a shaft without cracks, a crack that is asked for and not there
[[nodiscard]] RunResult plan(const GearSet& gear, const RunOptions& options);

/// Runs.  Of shafts and cups torque and force are 1 N*m and 1 N, and the given load is applied in
/// the report; cracks of the wall have the given torque, for the contact of their faces.
///
/// Every rank of MPI calls it.  All have the wall cracks; shaft and cup are calculated by the first
/// rank only, and are empty in the others.
/// @throws InputError, SolverError  as plan, fem::solve_section and fem::solve_solid; InputError,
///                                  before the first solution, for what will not fit into memory
[[nodiscard]] RunResult run(const GearSet& gear, const RunOptions& options, const Ranks& ranks);

}  // namespace fe_study
}  // namespace strainwave

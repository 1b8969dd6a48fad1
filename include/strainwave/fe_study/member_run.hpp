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
/// Finite element runs of the members of a drive from its input file, as `strainwave-fe run` does
/// them.

namespace strainwave {

namespace fe_study {

/// The members that finite elements can treat.
enum class Member { output_shaft, flexspline };

}  // namespace fe_study

template <>
struct EnumNames<fe_study::Member> {
  static constexpr std::array<std::string_view, 2> names = {"output-shaft", "flexspline"};
};

namespace fe_study {

inline constexpr int kSectionOrder = 6;  ///< default order p for bodies of revolution
inline constexpr int kSolidOrder = 3;    ///< default order p for solids

/// Where a run samples its solutions.  An element of order p gets p points in each direction, a
/// solid p+1.
enum class RunFields {
  none,
  of_rank,     ///< each rank samples its own cells, for files
  everywhere,  ///< each rank samples all cells, for pictures
};

/// The body in which a through crack of the barrel is computed.
enum class Surroundings {
  as_given,  ///< the cup, if the file gives rim, diaphragm or boss
  none,      ///< a tube
};

struct RunOptions {
  std::optional<Member> member = {};  ///< absent: every member that the file gives
  /// Order p, 2 to 8, for solids 2 to 4; absent: kSectionOrder and kSolidOrder
  std::optional<int> order = {};
  /// Path of the only crack to compute, such as "flexspline.crack[0]"; absent: all cracks of the
  /// selected members.
  std::optional<std::string> crack = {};
  /// Called with one line after each solution, on every rank; may be empty.
  std::function<void(const std::string&)> progress = {};
  RunFields fields = RunFields::none;
  Surroundings surroundings = Surroundings::as_given;
};

/// Estimated size of one computation.
struct RunSize {
  std::string path;  ///< "output_shaft.crack[0]" or "flexspline"
  /// unknowns of its largest solution; exact for solids, else within 10 %
  std::size_t dofs = 0;
  double memory = 0.0;        ///< estimated memory of a single rank [byte]; (FE-44)
  double seconds = 0.0;       ///< estimated time on one core [s]
  std::size_t solutions = 0;  ///< number of solutions
  bool divided = false;       ///< true: divided among the MPI ranks; false: the first rank does all

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "crack or member"}, &RunSize::path);
    field({"unknowns", "", "unknowns of its largest solution"}, &RunSize::dofs);
    field({"solutions", "", "number of solutions"}, &RunSize::solutions);
    field({"memory_bytes", "", "estimated memory of a single process"},
          [](const RunSize& size) { return static_cast<std::int64_t>(size.memory); });
    field({"time", "s", "estimated time on one core"}, &RunSize::seconds);
  }
};

/// Stress intensity at one place of a front [Pa*m^0.5].
struct StressIntensity {
  double K_I = 0.0;
  double K_II = 0.0;
  double K_III = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K_I", "Pa*m^0.5", "opening mode; 0 if the crack is closed"}, &StressIntensity::K_I);
    field({"K_II", "Pa*m^0.5", "sliding mode; 0 if the crack is closed"}, &StressIntensity::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &StressIntensity::K_III);
  }
};

/// One crack of the output shaft.
struct ShaftCrackRun {
  std::string path;
  gear_fem::ShaftSection section;
  gear_fem::ShaftCrackResult result;
  fem::Elasticity elasticity;
  double torque = 0.0;  ///< given torque [N*m]
  double force = 0.0;   ///< given axial force [N]

  /// Whether the force leaves the faces apart.
  [[nodiscard]] bool opens() const { return force >= 0; }
  /// Stress intensity at the given load: modes I and II from the force, mode III from the torque.
  [[nodiscard]] StressIntensity at_load() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = ShaftCrackRun;
    field({"path", "", "path of the crack in the input file"}, &R::path);
    field({"kind", "", "annular"}, [](const R&) { return AnnularCrack::kKind; });
    field({"depth", "m", "a"}, [](const R& r) { return r.section.crack->depth; });
    field({"opens", "", "whether the axial force leaves the faces apart"}, &R::opens);
    field({"stress_intensity", "", "stress intensity at the given load"}, &R::at_load);
    field(
        {"torsion", "", "result for a torque of 1 N*m"},
        [](const R& r) -> const auto& { return r.result.torsion; });
    field(
        {"tension", "", "result for a force of 1 N"},
        [](const R& r) -> const auto& { return r.result.tension; });
  }
};

/// Describes the fields that both kinds of wall cracks share.
template <class Run, class Visitor>
void describe_wall_crack(Visitor& field) {
  field({"path", "", "path of the crack in the input file"}, &Run::path);
  field({"half_length", "m", "half length of the crack"},
        [](const Run& r) { return r.tube.half_length; });
  field({"angle", "rad", "angle from the generator"}, [](const Run& r) { return r.tube.angle; });
  field({"torque", "N*m", "magnitude of the given torque"},
        [](const Run& r) { return r.tube.torque; });
  field({"compliance_without", "rad/(N*m)", "compliance of the body without the crack"},
        [](const Run& r) { return r.positive.compliance_without; });
  field({"positive", "", "result under torque > 0"}, &Run::positive);
  field({"negative", "", "result under torque < 0"}, &Run::negative);
}

/// One through crack of the flexspline's wall, in a tube or, with `tube.ends`, in the cup, for both
/// senses of the given torque.
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
    field({"body", "", "body that contains the crack: tube or cup"},
          [](const R& r) { return std::string_view(r.tube.ends.any() ? "cup" : "tube"); });
  }
};

/// The surface from which a crack starts: "outer" or "inner".
[[nodiscard]] inline std::string_view mouth_of(const gear_fem::TubeWithSurfaceCrack& tube) {
  return enum_name(tube.surface == gear_fem::TubeWithSurfaceCrack::Surface::inner ? Mouth::inner
                                                                                  : Mouth::outer);
}

/// One part-through crack of the flexspline's wall, for both senses of the given torque.
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
          [](const R& r) { return mouth_of(r.tube); });
    field({"depth", "m", "a"}, [](const R& r) { return r.tube.depth; });
  }
};

using WallCrackRun = std::variant<TubeCrackRun, SurfaceCrackRun>;

/// Results for the output shaft.
struct ShaftRun {
  std::vector<ShaftCrackRun> cracks;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"cracks", "", "results for each crack alone"}, &ShaftRun::cracks);
  }
};

/// Results for the flexspline.
struct FlexsplineRun {
  std::optional<gear_fem::CupResult> sound;
  std::vector<WallCrackRun> cracks;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"sound", "", "flexspline without its cracks, in torsion"}, &FlexsplineRun::sound);
    field({"cracks", "", "results for each wall crack alone"}, &FlexsplineRun::cracks);
  }
};

/// Results of a run.
struct RunResult {
  std::vector<RunSize> plan;  ///< estimates made before the run
  bool calculated = false;    ///< false: only the plan exists
  std::string refused;        ///< reason why this machine cannot compute the plan; empty if it can
  int section_order = 0;      ///< order p for shaft and sound cup
  int solid_order = 0;        ///< order p for wall cracks
  ShaftRun output_shaft;
  FlexsplineRun flexspline;
  std::vector<Note> notes;  ///< effects that finite elements leave out or treat differently
  /// True if every part may be used.
  [[nodiscard]] bool usable() const { return reason().empty(); }
  /// The first reason why the result must not be used; empty if it may be used.
  [[nodiscard]] std::string reason() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"plan", "", "estimates made before the run"}, &RunResult::plan);
    field({"calculated", "", "false for a dry run"}, &RunResult::calculated);
    field({"section_order", "", "order p of the elements for shaft and sound flexspline"},
          &RunResult::section_order);
    field({"solid_order", "", "order p of the elements for wall cracks"}, &RunResult::solid_order);
    field({"output_shaft", "", "output shaft with annular cracks"}, &RunResult::output_shaft);
    field({"flexspline", "", "flexspline, sound and with wall cracks"}, &RunResult::flexspline);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const RunResult& result);

/// Plans a run: fills a result except for the computed parts.
/// @throws InputError  for requests that finite elements cannot treat: a member that the file does
///                     not give, a crack of the flexspline outside its wall or too large for it, a
///                     sound flexspline without sections, an order out of range, a shaft without
///                     cracks, a requested crack that does not exist
[[nodiscard]] RunResult plan(const GearSet& gear, const RunOptions& options);

/// Executes a run.  For shafts and cups, torque and force are 1 N*m and 1 N, and the report scales
/// to the given load.  Wall cracks are computed at the given torque because their faces may touch.
///
/// Every MPI rank must call it.  All ranks get the results of wall cracks.  Only the first rank
/// computes shaft and cup; they are empty on the other ranks.
/// @throws InputError, SolverError  on the same conditions as plan, fem::solve_section and
///     fem::solve_solid; InputError before the first solution if the memory does not suffice
[[nodiscard]] RunResult run(const GearSet& gear, const RunOptions& options, const Ranks& ranks);

}  // namespace fe_study
}  // namespace strainwave

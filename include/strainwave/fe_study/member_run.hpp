// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/mpi_session.hpp"
#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/gear_fem/shaft_section.hpp"
#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Finite elements of the members of a drive, from its input file: what strainwave-fe does.

namespace strainwave::fe_study {

/// The members that finite elements know.
enum class Member { output_shaft, flexspline };
/// "output-shaft", "flexspline"
[[nodiscard]] std::string_view member_name(Member member);

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
};

/// One crack of the output shaft.
struct ShaftCrackRun {
  std::string path;
  gear_fem::ShaftSection section;
  gear_fem::ShaftCrackResult result;
  fem::Elasticity elasticity;
};

/// One through crack of the flexspline's wall, in a tube or, with `tube.ends`, in the cup, at the
/// size of the given torque and both senses.
struct TubeCrackRun {
  std::string path;
  gear_fem::TubeWithThroughCrack tube;
  gear_fem::TubeCrackResult positive;  ///< torque > 0
  gear_fem::TubeCrackResult negative;  ///< torque < 0
};

/// One part-through crack of the flexspline's wall, its mouth on the outer surface, at the size of
/// the given torque and both senses.
struct SurfaceCrackRun {
  std::string path;
  gear_fem::TubeWithSurfaceCrack tube;
  gear_fem::TubeSurfaceCrackResult positive;  ///< torque > 0
  gear_fem::TubeSurfaceCrackResult negative;  ///< torque < 0
};

/// Everything that was run.
struct RunResult {
  int section_order = 0;  ///< of shaft and sound cup
  int solid_order = 0;    ///< of cracks of the wall
  std::vector<ShaftCrackRun> shaft_cracks;
  std::optional<gear_fem::CupResult> cup;
  std::vector<TubeCrackRun> wall_cracks;        ///< through the wall
  std::vector<SurfaceCrackRun> surface_cracks;  ///< part of the way
  std::vector<std::string> notes;  ///< what finite elements leave out, or see otherwise
  /// True if every part may be used.
  [[nodiscard]] bool usable() const;
  /// The first reason why not; empty if it may.
  [[nodiscard]] std::string reason() const;
};

/// Plans a run.
/// @throws InputError  for what finite elements cannot do, by name: a member that the file does not
///                     give, a crack of the flexspline that is not one of the wall or does not
///                     fit into it, a sound flexspline without sections, an order out of
///                     range, a shaft without cracks, a crack that is asked for and not there
[[nodiscard]] std::vector<RunSize> plan(const GearSet& gear, const RunOptions& options);

/// Runs.  Of shafts and cups torque and force are 1 N*m and 1 N, and the given load is applied in
/// the report; cracks of the wall have the given torque, for the contact of their faces.
///
/// Every rank of MPI calls it.  All have the wall cracks; shaft and cup are calculated by the first
/// rank only, and are empty in the others.
/// @throws InputError, SolverError  as plan, fem::solve_section and fem::solve_solid; InputError,
///                                  before the first solution, for what will not fit into memory
[[nodiscard]] RunResult run(const GearSet& gear, const RunOptions& options,
                            const fem::MpiSession& session);

}  // namespace strainwave::fe_study

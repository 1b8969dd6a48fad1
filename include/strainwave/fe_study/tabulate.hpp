// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/io/compliance_table_file.hpp"
#include "strainwave/model/input/variation.hpp"

/// @file
/// A family of finite element runs for one crack (`strainwave fe tabulate`).  The results are
/// written point by point into a table that the stiffness model reads.

namespace strainwave::fe_study {

/// A family of runs before execution.
struct TableStudy {
  GearSet gear;    ///< the drive reduced to the parts that the crack needs
  RunOptions run;  ///< options, which name the crack
  TableHead head;
  /// values of the varied numbers; the last number runs fastest
  std::vector<std::vector<double>> points;
};

/// Prepares a family of runs.
///
/// @param gear   the drive
/// @param input  name of the input file, for the head of the table
/// @param run    order and crack; the crack may be left out if the file has only one
/// @param over   numbers that vary; the finite elements of the crack must depend on each of them,
///               and no other number may change with it (model/crack_parameters.hpp)
/// @throws InputError  if finite elements cannot treat the crack or the crack is not named; if a
///                     number has no effect or changes several numbers at once; if a number is
///                     given twice; if there are too many points
[[nodiscard]] TableStudy table_study(const GearSet& gear, const std::string& input,
                                     const RunOptions& run, std::span<const Variation> over);

/// Size of a whole family.
struct TableSize {
  RunSize largest;                 ///< the point that needs the most memory
  std::size_t least_unknowns = 0;  ///< fewest unknowns of a point
  double seconds = 0.0;            ///< time of all points on one core [s]
  std::size_t points = 0;          ///< number of points of the family
  /// points that cannot be meshed or break a rule, with the reason
  std::vector<std::string> misfits;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"largest", "", "the point that needs the most memory"}, &TableSize::largest);
    field({"least_unknowns", "", "fewest unknowns of a point"}, &TableSize::least_unknowns);
    field({"time", "s", "estimated time of all points on one core"}, &TableSize::seconds);
    field({"points", "", "number of points of the family"}, &TableSize::points);
    field({"misfits", "", "points that cannot be computed, with the reason"}, &TableSize::misfits);
  }
};
/// Meshes every point without solving it.
[[nodiscard]] TableSize table_size(const TableStudy& study);
[[nodiscard]] std::string table_size_text(const TableSize& size);

/// Computes one point of the family.  If the geometry is refused, or the solution fails or is not
/// usable, the row states the reason.
///
/// Every MPI rank must call it; the first rank gets the row.
/// @throws MemoryRefusal, fem::MemoryError  if the memory does not suffice; a later run may
///     succeed, so no row is written
/// @throws Error  for any fault that the point does not cause
[[nodiscard]] TablePoint table_point(const TableStudy& study, std::size_t point,
                                     const Ranks& ranks);

/// Outcome of a family of runs.
struct TableOutcome {
  TableSize plan;
  bool calculated = false;  ///< false: only the plan exists
  /// reason why this machine cannot compute the plan; empty if it can
  std::string refused = {};
  std::string table = {};             ///< name of the table's file
  std::size_t found = 0;              ///< points that the file had already
  std::size_t unusable = 0;           ///< number of unusable points
  std::string unusable_because = {};  ///< reason of the first unusable point

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"plan", "", "estimates for all points before the run"}, &TableOutcome::plan);
    field({"calculated", "", "false for a dry run"}, &TableOutcome::calculated);
    field({"table", "", "name of the table's file"}, &TableOutcome::table);
    field({"found", "", "points that the table had already"}, &TableOutcome::found);
    field({"unusable", "", "points that must not be used"}, &TableOutcome::unusable);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const TableOutcome& outcome);

/// Computes the points that the table lacks and adds each point when it is finished.
///
/// A killed run loses only its current point.  Every MPI rank must call it.
///
/// @param table     journal of the table; only the first rank uses it
/// @param progress  receives each finished point
/// @throws InputError  if a different table exists (the message names the first line that differs);
///                     before the first solution, if the memory does not suffice for a point
[[nodiscard]] TableOutcome run_table(const TableStudy& study, Journal& table, const Ranks& ranks,
                                     const Progress& progress);

/// Relative error of the added compliance of a crack, estimated from its run.
///
/// Implements theory manual eq. (FE-42): the largest of the growth check, the spread between rings,
/// and the smallest error found for such runs.
[[nodiscard]] double table_error(const TubeCrackRun& run);
[[nodiscard]] double table_error(const ShaftCrackRun& run);

}  // namespace strainwave::fe_study

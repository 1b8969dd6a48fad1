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
/// A family of finite element runs for one crack, written point by point into a table that the
/// stiffness model reads: `strainwave fe tabulate`.

namespace strainwave::fe_study {

/// A family, before it is run.
struct TableStudy {
  GearSet gear;    ///< the drive, with nothing but what the crack needs
  RunOptions run;  ///< names the crack
  TableHead head;
  std::vector<std::vector<double>> points;  ///< the varied numbers, the last runs fastest
};

/// Makes ready a family of runs.
///
/// @param gear   the drive
/// @param input  name of its file, for the head of the table
/// @param run    order; the crack, which may be left out where the file has one only
/// @param over   numbers that vary, each of which must be one that the crack's finite elements
///               depend on, and alone (model/crack_parameters.hpp)
/// @throws InputError  for a crack that finite elements do not know or that is not named, a number
///                     that changes nothing or several at once, one given twice, too many points
[[nodiscard]] TableStudy table_study(const GearSet& gear, const std::string& input,
                                     const RunOptions& run, std::span<const Variation> over);

/// Size of a whole family.
struct TableSize {
  RunSize largest;                   ///< the point that needs the most memory
  std::size_t least_unknowns = 0;    ///< of a point
  double seconds = 0.0;              ///< of all points, one core [s]
  std::size_t points = 0;            ///< of the family
  std::vector<std::string> misfits;  ///< points that cannot be meshed or break a rule, with reason

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"largest", "", "the point that needs the most memory"}, &TableSize::largest);
    field({"least_unknowns", "", "of a point"}, &TableSize::least_unknowns);
    field({"time", "s", "of all points, estimate for one core"}, &TableSize::seconds);
    field({"points", "", "of the family"}, &TableSize::points);
    field({"misfits", "", "points that cannot be calculated, with the reason"},
          &TableSize::misfits);
  }
};
/// Meshes every point and solves none.
[[nodiscard]] TableSize table_size(const TableStudy& study);
[[nodiscard]] std::string table_size_text(const TableSize& size);

/// One point of the family.  A point whose geometry is refused, that was not solved or is not
/// usable is a row that says why.
///
/// Every rank of MPI calls it; the first has the row.
/// @throws MemoryRefusal, fem::MemoryError  too little memory, which the next run may have: no row
/// @throws Error  any other fault that is not of the point
[[nodiscard]] TablePoint table_point(const TableStudy& study, std::size_t point,
                                     const Ranks& ranks);

/// What became of a table.
struct TableOutcome {
  TableSize plan;
  bool calculated = false;            ///< else there is a plan only
  std::string refused = {};           ///< why the plan cannot be calculated here; empty: it can
  std::string table = {};             ///< name of its file
  std::size_t found = 0;              ///< points that were in the file
  std::size_t unusable = 0;           ///< of all
  std::string unusable_because = {};  ///< of the first of these

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"plan", "", "of all points, estimated before"}, &TableOutcome::plan);
    field({"calculated", "", "false of a dry run"}, &TableOutcome::calculated);
    field({"table", "", "name of its file"}, &TableOutcome::table);
    field({"found", "", "points that were in it before"}, &TableOutcome::found);
    field({"unusable", "", "points that may not be used"}, &TableOutcome::unusable);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const TableOutcome& outcome);

/// Runs the points that the table does not have yet and adds each to it as it is finished.
///
/// A run that is killed loses the point that it was at.  Every rank of MPI calls it.
///
/// @param table     used by the first rank
/// @param progress  is told of each point
/// @throws InputError  if the table is there and is another one, naming the first line that
///                     differs; before the first solution, for a point that will not fit into
///                     memory
[[nodiscard]] TableOutcome run_table(const TableStudy& study, Journal& table, const Ranks& ranks,
                                     const Progress& progress);

/// Relative error of the added compliance of a crack, from the evidence of its run.
///
/// Implements theory manual eq. (FE-42): the largest of the growth check, the spread between rings,
/// and what such a run was found to be off at best.
[[nodiscard]] double table_error(const TubeCrackRun& run);
[[nodiscard]] double table_error(const ShaftCrackRun& run);

}  // namespace strainwave::fe_study

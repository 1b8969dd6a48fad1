// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

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
[[nodiscard]] TableRow table_point(const TableStudy& study, std::size_t point,
                                   const fem::MpiSession& session);

/// What became of a table.
struct TableOutcome {
  std::size_t found = 0;     ///< points that were in the file
  std::size_t unusable = 0;  ///< of all
  std::string first_reason;  ///< of the first of these
};

/// Runs the points that the file does not have yet and adds each to it as it is finished.
///
/// A run that is killed loses the point that it was at.  Every rank of MPI calls it.
///
/// @param say  for messages, on the first rank only
/// @throws InputError  if the file is there and is another table, naming the first line that
/// differs;
///                     before the first solution, for a point that will not fit into memory
[[nodiscard]] TableOutcome run_table(const TableStudy& study, const std::filesystem::path& file,
                                     const fem::MpiSession& session,
                                     const std::function<void(const std::string&)>& say);

/// Relative error of the added compliance of a crack, from the evidence of its run.
///
/// Implements theory manual eq. (FE-42): the largest of the growth check, the spread between rings,
/// and what such a run was found to be off at best.
[[nodiscard]] double table_error(const TubeCrackRun& run);
[[nodiscard]] double table_error(const ShaftCrackRun& run);

}  // namespace strainwave::fe_study

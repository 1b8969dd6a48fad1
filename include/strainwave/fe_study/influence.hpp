// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "strainwave/command/command.hpp"

/// @file
/// The table of a through crack under unit tractions (`strainwave fe influence`), by which the
/// closed forms compute K over a turn (FE-56).

namespace strainwave::fe_study {

/// The cracks of the table: all combinations.
struct InfluenceGrid {
  std::vector<double> half_lengths;  ///< a/t [-]
  std::vector<double> radii;         ///< R/t [-]
  std::vector<double> angles;        ///< beta [rad]

  [[nodiscard]] std::size_t size() const {
    return half_lengths.size() * radii.size() * angles.size();
  }
};

/// The grid of the table that the program carries.
[[nodiscard]] InfluenceGrid influence_grid();

struct InfluenceOutcome {
  std::string table;       ///< name of the table's file
  std::size_t cracks{};    ///< cracks of the table
  std::size_t found{};     ///< cracks that the file had already
  std::size_t unknowns{};  ///< most unknowns of a crack that was computed
  double asymmetry{};      ///< largest difference from reciprocity of a crack that was computed

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = InfluenceOutcome;
    field({"table", "", "name of the table's file"}, &O::table);
    field({"cracks", "", "cracks of the table"}, &O::cracks);
    field({"found", "", "cracks that the file had already"}, &O::found);
    field({"unknowns", "", "most unknowns of a crack that was computed"}, &O::unknowns);
    field({"asymmetry", "1", "largest difference from reciprocity of a crack that was computed"},
          &O::asymmetry);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const InfluenceOutcome& outcome);
[[nodiscard]] std::string influence_text(const InfluenceOutcome& outcome);

/// Computes the cracks that the table lacks and adds each crack when it is finished.
///
/// A killed run loses only its current crack.  Every MPI rank must call it.
/// @param table     journal of the table; only the first rank uses it
/// @throws InputError  if a different table exists
[[nodiscard]] InfluenceOutcome run_influence(const InfluenceGrid& grid, Journal* table,
                                             const Ranks& ranks, const Progress& progress);

}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// How far the numbers of a study that read tables of cracks are from the engine (ST-22).
struct TableEvidence {
  int cracks = 0;              ///< cracks that have tables
  int points = 0;              ///< drives at which tables and engine were compared
  double largest_error = 0.0;  ///< largest difference of an output, over its value [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using T = TableEvidence;
    field({"cracks", "", "cracks whose compliance was read from tables"}, &T::cracks);
    field({"points", "", "random drives of the study at which tables and engine were compared"},
          &T::points);
    field({"largest_error", "1",
           "largest difference between tables and engine at these drives, over the output"},
          &T::largest_error);
  }
};
/// The note that says it in words.
[[nodiscard]] Note note_of(const TableEvidence& evidence);

}  // namespace strainwave

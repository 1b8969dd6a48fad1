// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace strainwave {

/// Provenance of a result.  The same input and version give the same bytes, so it contains neither
/// time nor host.
struct Provenance {
  std::string version;                ///< version of strainwave
  std::string revision;               ///< revision of the sources
  std::string input_file;             ///< input file as named by the user
  double quadrature_tolerance = 0.0;  ///< relative tolerance of the crack integrals [-]
};

}  // namespace strainwave

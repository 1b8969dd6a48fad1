// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace strainwave {

/// Where a result comes from.  The same input and version give the same bytes: no times, no hosts.
struct Provenance {
  std::string version;                ///< of strainwave
  std::string revision;               ///< of its sources
  std::string input_file;             ///< as the user named it
  double quadrature_tolerance = 0.0;  ///< relative, of the crack integrals [-]
};

}  // namespace strainwave

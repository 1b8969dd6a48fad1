// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/error.hpp"

namespace strainwave::fem {

/// The memory did not suffice.  The cause is the present state of the machine, not the problem.
class MemoryError : public SolverError {
 public:
  using SolverError::SolverError;
};

}  // namespace strainwave::fem

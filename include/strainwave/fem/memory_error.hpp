// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/error.hpp"

namespace strainwave::fem {

/// There was too little memory: a fault of the machine as it was, not of the problem.
class MemoryError : public SolverError {
 public:
  using SolverError::SolverError;
};

}  // namespace strainwave::fem

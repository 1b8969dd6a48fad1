// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/solid.hpp"

namespace strainwave::test {

/// MPI for the rest of the test program; started without mpirun it has one rank.
inline void start_mpi() {
  static int count = 1;
  static char name[] = "test";
  static char* arguments[] = {name, nullptr};
  static char** argv = arguments;
  static fem::MpiSession session(count, argv);
}

}  // namespace strainwave::test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/mpi_session.hpp"

namespace strainwave::test {

/// MPI for the rest of the test program; without mpirun it has one rank.
inline const fem::MpiSession& mpi() {
  static int count = 1;
  static char name[] = "test";
  static char* arguments[] = {name, nullptr};
  static char** argv = arguments;
  static const fem::MpiSession session(count, argv);
  return session;
}
inline void start_mpi() { (void)mpi(); }

}  // namespace strainwave::test

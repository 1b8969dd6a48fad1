// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/fe_study/member_run.hpp"

namespace strainwave::fe_study {

/// Memory that this process may still take.
struct AvailableMemory {
  double bytes = 0.0;  ///< infinite where nothing says
  std::string from;    ///< what says so: "MemAvailable of /proc/meminfo"
};

/// The least of what the system has left, MemAvailable of /proc/meminfo, and what is left of the
/// process's own limit (`ulimit -v`).
[[nodiscard]] AvailableMemory available_memory();

/// Refuses a run that would need more memory than there is.
///
/// @param sizes    solved one after the other: the largest counts
/// @param here     available on this machine
/// @param ranks_here  ranks of MPI on this machine; >= 1
/// @param ranks    of all machines together; >= ranks_here
/// @throws InputError  naming the part, the memory needed and available
void require_memory(const std::vector<RunSize>& sizes, const AvailableMemory& here, int ranks_here,
                    int ranks);
/// The same on this machine, as it is now.  Every rank calls it; each refuses what any refuses.
void require_memory(const std::vector<RunSize>& sizes, const fem::MpiSession& session);

}  // namespace strainwave::fe_study

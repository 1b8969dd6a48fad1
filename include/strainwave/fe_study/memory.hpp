// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/member_run.hpp"

namespace strainwave::fe_study {

/// A run was refused, for there is not the memory for it.  It may be there another time.
class MemoryRefusal : public InputError {
 public:
  using InputError::InputError;
};

/// Memory that may still be taken.
struct MemoryLimit {
  double bytes = std::numeric_limits<double>::infinity();  ///< infinite where nothing says
  std::string from = "nothing";                            ///< "MemAvailable of /proc/meminfo"
};

struct AvailableMemory {
  MemoryLimit machine;  ///< by all ranks of this machine together
  MemoryLimit process;  ///< by each of them
};

/// Contents of a file; nothing if there is none.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

/// What the control groups of this process leave, the least of all levels: a container, or the
/// memory that Slurm was asked for.
///
/// Version 2: memory.max - memory.current; version 1: memory.limit_in_bytes -
/// memory.usage_in_bytes.  Pages of files that the kernel drops when they are in the way
/// (inactive_file of memory.stat) do not count as used.
/// @param read  reads /proc/self/cgroup and the files of /sys/fs/cgroup
[[nodiscard]] MemoryLimit control_group_memory(const FileReader& read);

/// Of the machine the least of MemAvailable of /proc/meminfo and the limits of the control groups;
/// of the process what is left of its own limit (`ulimit -v`).
[[nodiscard]] AvailableMemory available_memory();

/// What a process takes before it solves anything [byte].
inline constexpr double kProgramBytes = 2e8;

/// Memory of one of several ranks [byte]: of what is above kProgramBytes four fifths are divided
/// among them, and one fifth each has whole (FE-44).
///
/// Measured at 16 and 46 thousand unknowns with one, two and four ranks, as a share of what one
/// rank alone takes: 0 to 12 % less than that.
[[nodiscard]] double memory_of_rank(const RunSize& size, int ranks);

/// Refuses a run that would need more memory than there is.
///
/// @param sizes    solved one after the other: the largest counts
/// @param here     available on this machine
/// @param ranks_here  ranks of MPI on this machine; >= 1
/// @param ranks    of all machines together; >= ranks_here
/// @throws MemoryRefusal  naming the part, the memory needed and available
void require_memory(const std::vector<RunSize>& sizes, const AvailableMemory& here, int ranks_here,
                    int ranks);
/// The same on this machine, as it is now.  Every rank calls it; each refuses what any refuses.
///
/// @throws MemoryRefusal        here
/// @throws OtherRankError  on another machine
void require_memory(const std::vector<RunSize>& sizes, const Ranks& ranks);

}  // namespace strainwave::fe_study

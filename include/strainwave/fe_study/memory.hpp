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

/// A run was refused because the available memory does not suffice.  A later attempt may succeed.
class MemoryRefusal : public InputError {
 public:
  using InputError::InputError;
};

/// Memory that may still be allocated.
struct MemoryLimit {
  double bytes = std::numeric_limits<double>::infinity();  ///< infinite if no limit is known
  std::string from = "nothing";                            ///< "MemAvailable of /proc/meminfo"
};

struct AvailableMemory {
  MemoryLimit machine;  ///< limit for all ranks of this machine together
  MemoryLimit process;  ///< limit for each rank
};

/// Reads the contents of a file; absent if the file does not exist.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

/// Memory that the control groups of this process leave, the least of all levels.  A control group
/// limits a container or a Slurm job.
///
/// Version 2: memory.max - memory.current; version 1: memory.limit_in_bytes -
/// memory.usage_in_bytes.  File pages that the kernel can drop on demand (inactive_file of
/// memory.stat) do not count as used.
/// @param read  reads /proc/self/cgroup and the files of /sys/fs/cgroup
[[nodiscard]] MemoryLimit control_group_memory(const FileReader& read);

/// For the machine: the least of MemAvailable of /proc/meminfo and the limits of the control
/// groups. For the process: the rest of its own limit (`ulimit -v`).
[[nodiscard]] AvailableMemory available_memory();

/// Memory of a process before its first solution [byte].
inline constexpr double kProgramBytes = 2e8;

/// Memory of one of several ranks [byte].  Of the part above kProgramBytes, four fifths are divided
/// among the ranks, and every rank holds the remaining fifth (FE-44).
///
/// Measured at 16 and 46 thousand unknowns with one, two and four ranks, measured use was 0 to 12 %
/// below this estimate.
[[nodiscard]] double memory_of_rank(const RunSize& size, int ranks);

/// Refuses a run that needs more memory than is available.
///
/// @param sizes    sizes of solutions that are solved one after the other, so the largest counts
/// @param here     memory available on this machine
/// @param ranks_here  MPI ranks on this machine; >= 1
/// @param ranks    MPI ranks on all machines; >= ranks_here
/// @throws MemoryRefusal  if the memory does not suffice; the message names the part and the needed
///                        and available memory
void require_memory(const std::vector<RunSize>& sizes, const AvailableMemory& here, int ranks_here,
                    int ranks);
/// Refuses a run that needs more memory than this machine has now.  Every rank must call it; all
/// ranks refuse if one refuses.
///
/// @throws MemoryRefusal    if the memory of this machine does not suffice
/// @throws OtherRankError   if the memory of another machine does not suffice
void require_memory(const std::vector<RunSize>& sizes, const Ranks& ranks);

}  // namespace strainwave::fe_study

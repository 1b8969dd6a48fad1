// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include "strainwave/core/error.hpp"

namespace strainwave::fe_study {
namespace {

/// The kilobytes that a line "Key:  123 kB" of a file of /proc gives, in bytes.
std::optional<double> proc_bytes(const char* file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key + ":")) continue;
    std::istringstream rest(line.substr(key.size() + 1));
    double kilobytes = 0.0;
    if (rest >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

}  // namespace

AvailableMemory available_memory() {
  AvailableMemory memory{std::numeric_limits<double>::infinity(), "nothing"};
  if (const auto system = proc_bytes("/proc/meminfo", "MemAvailable"))
    memory = {*system, "MemAvailable of /proc/meminfo"};
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const double taken = proc_bytes("/proc/self/status", "VmSize").value_or(0.0);
    const double left = std::max(0.0, static_cast<double>(limit.rlim_cur) - taken);
    if (left < memory.bytes) memory = {left, "the limit of the process, ulimit -v"};
  }
  return memory;
}

void require_memory(const std::vector<RunSize>& sizes, const AvailableMemory& here, int ranks_here,
                    int ranks) {
  for (const RunSize& size : sizes) {
    const double needed = size.memory * ranks_here / ranks;
    if (needed <= here.bytes) continue;
    throw InputError(
        size.path,
        fmt::format("{} unknowns need about {:.2g} GB of memory{}, and {:.2g} GB are "
                    "available ({})",
                    size.dofs, needed / 1e9, ranks > ranks_here ? " on each machine" : "",
                    here.bytes / 1e9, here.from));
  }
}

void require_memory(const std::vector<RunSize>& sizes, const fem::MpiSession& session) {
  const int ranks_here = session.on_this_machine();
  std::string fault;
  try {
    require_memory(sizes, available_memory(), ranks_here, session.size());
  } catch (const InputError& error) {
    if (session.size() == 1) throw;
    fault = error.what();
  }
  // One machine alone may be too small: the first that says so stops all.
  fault = session.from_any(fault);
  if (!fault.empty()) throw InputError("memory", fault);
}

}  // namespace strainwave::fe_study

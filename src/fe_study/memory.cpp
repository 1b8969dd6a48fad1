// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include "strainwave/core/number_text.hpp"

namespace strainwave::fe_study {
namespace {

std::optional<std::string> contents(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// The number after a key at the beginning of a line.
std::optional<double> number_of(const std::optional<std::string>& text, std::string_view key) {
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key)) continue;
    std::string_view rest = line;
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t", key.size()), rest.size()));
    if (const auto number = parse_number(rest.substr(0, number_length(rest)))) return number;
  }
  return std::nullopt;
}

/// The kilobytes that a line "Key:  123 kB" of a file of /proc gives, in bytes.
std::optional<double> proc_bytes(const std::string& file, const std::string& key) {
  const auto kilobytes = number_of(contents(file), key + ":");
  return kilobytes ? std::optional(*kilobytes * 1024) : std::nullopt;
}

/// Files of one version of control groups.
struct GroupFiles {
  std::string root;
  std::string_view limit;
  std::string_view used;
  std::string_view cache;  ///< line of memory.stat
};

/// The least memory that a group and its parent groups leave.
MemoryLimit left_of_group(std::string group, const GroupFiles& files, const FileReader& read) {
  MemoryLimit least;
  for (;;) {
    while (!group.empty() && group.back() == '/') group.pop_back();
    const std::string folder = files.root + group + '/';
    // The limit "max" is not a number and means no limit.
    const auto limit = number_of(read(folder + std::string(files.limit)), "");
    const auto used = number_of(read(folder + std::string(files.used)), "");
    if (limit && used) {
      const double cache = number_of(read(folder + "memory.stat"), files.cache).value_or(0.0);
      const double left = std::max(0.0, *limit - std::max(0.0, *used - cache));
      if (left < least.bytes) least = {left, fmt::format("{} of the control group", files.limit)};
    }
    if (group.empty()) return least;
    group.erase(group.rfind('/') == std::string::npos ? 0 : group.rfind('/'));
  }
}

void require_memory(const RunSize& size, double needed, const MemoryLimit& limit,
                    std::string_view where) {
  if (needed <= limit.bytes) return;
  throw MemoryRefusal(size.path,
                      fmt::format("{} unknowns need about {:.2g} GB of memory{}, and {:.2g} GB are "
                                  "available ({})",
                                  size.dofs, needed / 1e9, where, limit.bytes / 1e9, limit.from));
}

}  // namespace

MemoryLimit control_group_memory(const FileReader& read) {
  MemoryLimit least;
  std::istringstream lines(read("/proc/self/cgroup").value_or(""));
  for (std::string line;
       std::getline(lines, line);) {  // "4:memory:/group", of version 2 "0::/group"
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    MemoryLimit limit;
    if (controllers == ",,")
      limit = left_of_group(
          group, {"/sys/fs/cgroup", "memory.max", "memory.current", "inactive_file "}, read);
    else if (controllers.find(",memory,") != std::string::npos)
      limit = left_of_group(group,
                            {"/sys/fs/cgroup/memory", "memory.limit_in_bytes",
                             "memory.usage_in_bytes", "total_inactive_file "},
                            read);
    if (limit.bytes < least.bytes) least = limit;
  }
  return least;
}

AvailableMemory available_memory() {
  AvailableMemory memory;
  if (const auto system = proc_bytes("/proc/meminfo", "MemAvailable"))
    memory.machine = {*system, "MemAvailable of /proc/meminfo"};
  if (const MemoryLimit group = control_group_memory(contents); group.bytes < memory.machine.bytes)
    memory.machine = group;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const double taken = proc_bytes("/proc/self/status", "VmSize").value_or(0.0);
    memory.process = {std::max(0.0, static_cast<double>(limit.rlim_cur) - taken),
                      "the limit of the process, ulimit -v"};
  }
  return memory;
}

double memory_of_rank(const RunSize& size, int ranks) {
  if (!size.divided || size.memory <= kProgramBytes) return size.memory;
  return kProgramBytes + (size.memory - kProgramBytes) * (0.2 + 0.8 / ranks);  // (FE-44)
}

void require_memory(const std::vector<RunSize>& sizes, const AvailableMemory& here, int ranks_here,
                    int ranks) {
  for (const RunSize& size : sizes) {
    const double of_rank = memory_of_rank(size, ranks);
    require_memory(size, size.divided ? of_rank * ranks_here : of_rank, here.machine,
                   ranks > ranks_here ? " on each machine" : "");
    require_memory(size, of_rank, here.process, ranks > 1 ? " in each process" : "");
  }
}

void require_memory(const std::vector<RunSize>& sizes, const Ranks& ranks) {
  const int ranks_here = ranks.on_this_machine();
  // If the memory of one machine does not suffice, all ranks stop.
  ranks.together([&] { require_memory(sizes, available_memory(), ranks_here, ranks.size()); });
}

}  // namespace strainwave::fe_study

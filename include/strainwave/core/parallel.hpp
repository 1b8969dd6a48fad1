// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/progress.hpp"

namespace strainwave {

/// How the indices of a loop are shared among threads.
struct Parallel {
  std::size_t block = 1;  ///< how many indices a thread takes at a time; >= 1
  int threads = 0;        ///< 0: as many as the machine runs at once
};

/// Calls an evaluator with each index below n.  Any free thread takes the next block.
///
/// The result of an index must depend on the index only; then the results are the same for any
/// number of threads.  Only the calling thread reports progress, before each index.  After
/// a request to stop, each thread finishes only the index at which it works.  If the machine cannot
/// start more threads, the running ones do the work.
/// @param n         number of indices
/// @param parallel  block size, which must be >= 1, and number of threads
/// @param progress  hears the share i/n before each index of the calling thread, and 1 at the end
/// @param make      () -> evaluator of one thread, a function of the index
/// @throws  the exception of the lowest block in which an evaluator threw, for any number of
///          threads; Stopped on request
template <class Make>
void for_each_index(std::size_t n, const Parallel& parallel, const Progress& progress,
                    const Make& make) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::exception_ptr fault;
  std::size_t fault_at = n;
  std::mutex fault_mutex;
  const AskedUnits& units = asked_units();
  const auto work = [&](const Progress& told) {
    const AskedUnitsScope scope(units);
    std::size_t first = 0;
    try {
      auto evaluate = make();
      for (;;) {
        first = next.fetch_add(parallel.block);
        if (first >= n) return;
        for (std::size_t i = first; i < std::min(first + parallel.block, n); ++i) {
          told.at(static_cast<double>(i) / static_cast<double>(n));
          evaluate(i);
        }
      }
    } catch (const Stopped&) {
      stopped = true;
    } catch (...) {
      // Threads take blocks in ascending order, so every lower block is done or will be finished.
      const std::scoped_lock lock(fault_mutex);
      if (!fault || first < fault_at) {
        fault = std::current_exception();
        fault_at = first;
      }
      next = n;
    }
  };
  const unsigned asked = parallel.threads > 0 ? static_cast<unsigned>(parallel.threads)
                                              : std::max(1U, std::thread::hardware_concurrency());
  const std::size_t blocks = (n + parallel.block - 1) / parallel.block;
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t t = 1; t < std::min<std::size_t>(asked, blocks); ++t)
        others.emplace_back(work, Progress([&](double) { return !stopped.load(); }));
    } catch (const std::system_error&) {  // the machine cannot start more threads
    }
    work(progress);
  }
  if (stopped) throw Stopped();
  if (fault) std::rethrow_exception(fault);
  progress.at(1.0);
}

}  // namespace strainwave

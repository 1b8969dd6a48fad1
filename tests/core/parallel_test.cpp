// SPDX-License-Identifier: Apache-2.0 A loop over indices by several threads calls every index once
// and reports the same fault for any number of threads.
#include "strainwave/core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace strainwave {
namespace {

std::vector<int> counts(std::size_t n, const Parallel& parallel) {
  std::vector<int> count(n, 0);
  for_each_index(n, parallel, {}, [&] { return [&](std::size_t i) { ++count[i]; }; });
  return count;
}

TEST(ForEachIndex, IdentityEveryIndexOnce) {
  for (const int threads : {1, 2, 5})
    for (const std::size_t block : {1U, 7U, 5000U})
      EXPECT_EQ(counts(1000, {.block = block, .threads = threads}), std::vector<int>(1000, 1));
  EXPECT_TRUE(counts(0, {.threads = 3}).empty());
}

TEST(ForEachIndex, BehaviourTheFaultOfTheLowestBlockIsTold) {
  for (int run = 0; run < 50; ++run)
    for (const int threads : {1, 4}) {
      std::string told;
      try {
        for_each_index(200, {.threads = threads}, {}, [] {
          return [](std::size_t i) {
            if (i >= 20) throw std::runtime_error(std::to_string(i));
          };
        });
      } catch (const std::runtime_error& error) {
        told = error.what();
      }
      EXPECT_EQ(told, "20") << threads;
    }
}

TEST(ForEachIndex, BehaviourTheCallerStopsItAndIsToldTheEnd) {
  const auto nothing = [] { return [](std::size_t) {}; };
  EXPECT_THROW(for_each_index(100, {.threads = 4}, Progress([](double) { return false; }), nothing),
               Stopped);
  double last = 0.0;
  for_each_index(100, {.threads = 4}, Progress([&](double share) {
                   last = share;
                   return true;
                 }),
                 nothing);
  EXPECT_EQ(last, 1.0);
}

TEST(ForEachIndex, RegressionAStopDoesNotWaitForTheEndOfABlock) {
  // One block contains all indices of a thread; the caller stops it before its fourth index.
  int n_asked = 0;
  int n_done = 0;
  const Progress stop([&](double) { return ++n_asked < 4; });
  EXPECT_THROW(for_each_index(1000, {.block = 1000, .threads = 1}, stop,
                              [&] { return [&](std::size_t) { ++n_done; }; }),
               Stopped);
  EXPECT_EQ(n_done, 3);
  // The other threads do not finish their blocks either: each would run for 10 s.
  std::atomic<bool> other_runs{false};
  std::atomic<int> n_slow{0};
  const auto caller = std::this_thread::get_id();
  const Progress stop_both([&](double) { return !other_runs.load(); });
  EXPECT_THROW(for_each_index(2000000, {.block = 1000000, .threads = 2}, stop_both,
                              [&] {
                                return [&](std::size_t) {
                                  if (std::this_thread::get_id() != caller) {
                                    other_runs = true;
                                    ++n_slow;
                                  }
                                  while (!other_runs) std::this_thread::yield();
                                  std::this_thread::sleep_for(std::chrono::microseconds(10));
                                };
                              }),
               Stopped);
  EXPECT_LT(n_slow, 1000000);
}

}  // namespace
}  // namespace strainwave

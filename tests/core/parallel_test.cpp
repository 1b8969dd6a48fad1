// SPDX-License-Identifier: Apache-2.0 A loop over indices by several threads calls every index once
// and reports the same fault for any number of threads.
#include "strainwave/core/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
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

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0 lone_fault.py runs this program with two processes for each
// test.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

#include "strainwave/fem/mpi_session.hpp"

namespace strainwave::fem {
namespace {

constexpr std::chrono::duration<double> kTestPatience{0.5};

class TwoRanks {
 public:
  const MpiSession& session() { return session_; }
  [[nodiscard]] bool faulty() const { return session_.rank() == 1; }
  void wait_for_the_other() const { (void)session_.all(true); }

 private:
  int count_ = 1;
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  char** argv_ = arguments_;
  MpiSession session_{count_, argv_, kTestPatience};
};

// Rank 1 throws while rank 0 waits for it in the middle of the work, so rank 1 ends both.
TEST(MpiSession, IdentityLoneFaultTogether) {
  TwoRanks two;
  two.session().together([&] {
    if (two.faulty()) throw std::runtime_error("a fault in the work");
    two.wait_for_the_other();
  });
  std::cerr << "not ended\n";
}

TEST(MpiSession, IdentityLoneFaultLastCode) {
  TwoRanks two;
  if (!two.faulty()) two.wait_for_the_other();
  (void)two.session().last_code(4, [] { std::cerr << "a fault at last\n"; });
  std::cerr << "not ended\n";
}

// Rank 0 arrives late but within the waiting time, so both continue and learn of the fault.
TEST(MpiSession, IdentityLateRankIsWaitedFor) {
  TwoRanks two;
  std::string heard;
  try {
    two.session().together([&] {
      if (two.faulty()) throw std::runtime_error("a fault in the work");
      std::this_thread::sleep_for(0.3 * kTestPatience);
    });
  } catch (const OtherRankError& error) {
    heard = std::string("of the other: ") + error.what();
  } catch (const std::runtime_error& error) {
    heard = error.what();
  }
  EXPECT_EQ(heard, two.faulty() ? "a fault in the work" : "of the other: a fault in the work");
  if (!two.faulty()) std::this_thread::sleep_for(0.3 * kTestPatience);
  std::function<void()> complain;
  if (two.faulty()) complain = [] { std::cerr << "a fault at last\n"; };
  EXPECT_EQ(two.session().last_code(two.faulty() ? 4 : 0, complain), 4);
}

}  // namespace
}  // namespace strainwave::fem

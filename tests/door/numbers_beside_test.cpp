// SPDX-License-Identifier: Apache-2.0
// The numbers of a drive that stand in other files, by which a checkpoint knows its drive.
#include "numbers_beside.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace strainwave {
namespace {

TEST(NumbersBeside, BehaviourAShiftedErrorTableIsAnother) {
  // The rows are the same; only the phases of the lines tell where the first row stands.
  const auto gear = [](double phase, double value) {
    GearSet made;
    made.error_table = std::make_shared<const ErrorTable>(ErrorTable{
        .values = {0.0, value}, .turns = 1.0, .lines = {.orders = {{2.0, 1e-4, phase}}}});
    return made;
  };
  EXPECT_EQ(numbers_beside(gear(0.3, 1e-4)), numbers_beside(gear(0.3, 1e-4)));
  EXPECT_NE(numbers_beside(gear(0.3, 1e-4)), numbers_beside(gear(0.4, 1e-4)));
  EXPECT_NE(numbers_beside(gear(0.3, 1e-4)), numbers_beside(gear(0.3, 2e-4)));
  EXPECT_NE(numbers_beside(gear(0.3, 1e-4)), numbers_beside(GearSet{}));
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/counter_random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace strainwave {
namespace {

TEST(CounterRandom, ReferenceSplitMix64) {
  // The first numbers of seed 1234567, from the published test vectors of the generator.
  constexpr std::array<std::uint64_t, 5> kPublished = {6457827717110365317U, 3203168211198807973U,
                                                       9817491932198370423U, 4593380528125082431U,
                                                       16408922859458223821U};
  for (std::size_t n = 0; n < kPublished.size(); ++n)
    EXPECT_EQ(splitmix64(1234567, n), kPublished[n]);
}

TEST(CounterRandom, IdentityUniformIsInside) {
  for (std::uint64_t n = 0; n < 1000; ++n) {
    EXPECT_GT(counter_uniform(7, n, 0), 0.0);
    EXPECT_LT(counter_uniform(7, n, 0), 1.0);
  }
}

TEST(CounterRandom, ConvergenceMomentsOfTheNormalDeviate) {
  // The expected moments are mean 0, variance 1, third moment 0, fourth moment 3; inputs, draws and
  // seeds are not correlated.  Standard errors are 1/sqrt(n) times 1, sqrt 2, sqrt 15, sqrt 96;
  // tolerance: four of them.
  constexpr int kN = 100'000;
  std::array<double, 4> moment{};
  double with_next_input = 0.0;
  double with_next_draw = 0.0;
  double with_next_seed = 0.0;
  for (std::uint64_t n = 0; n < kN; ++n) {
    const double z = counter_normal(42, n, 3);
    double power = 1.0;
    for (double& m : moment) m += (power *= z) / kN;
    with_next_input += z * counter_normal(42, n, 4) / kN;
    with_next_draw += z * counter_normal(42, n + 1, 3) / kN;
    with_next_seed += z * counter_normal(43, n, 3) / kN;
  }
  const double error = 4 / std::sqrt(kN);
  EXPECT_NEAR(moment[0], 0, error);
  EXPECT_NEAR(moment[1], 1, error * std::sqrt(2));
  EXPECT_NEAR(moment[2], 0, error * std::sqrt(15));
  EXPECT_NEAR(moment[3], 3, error * std::sqrt(96));
  EXPECT_NEAR(with_next_input, 0, error);
  EXPECT_NEAR(with_next_draw, 0, error);
  EXPECT_NEAR(with_next_seed, 0, error);
}

TEST(CounterRandom, IdentityNormalInvertsItsDistribution) {
  for (std::uint64_t n = 0; n < 100; ++n)
    EXPECT_NEAR(std::erfc(-counter_normal(1, n, 2) / std::sqrt(2.0)) / 2, counter_uniform(1, n, 2),
                1e-15);
}

}  // namespace
}  // namespace strainwave

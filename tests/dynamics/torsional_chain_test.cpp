// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/torsional_chain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Motor and load with one spring behind a gear of signed ratio 1/gear.
TorsionalChain two_inertias(double motor, double load, double stiffness, double gear,
                            double damping = 0.0) {
  return {.inertias = {{"motor", motor}, {"load", load}},
          .springs = {{.name = "drive",
                       .compliance = 1 / stiffness,
                       .damping = damping,
                       .twist_of = {gear, -1.0}}}};
}

/// The four inertias of a drive with a spring for each member.
TorsionalChain four_inertias() {
  return {.inertias = {{"wave generator", 46.8e-4}, {"rim", 0.02}, {"cup", 0.03}, {"load", 20.0}},
          .springs = {{"wave generator", 3.407e-7, 0.0, {-0.01, -1, 0, 0}},
                      {"flexspline", 2.359e-7, 0.0, {0, 1, -1, 0}},
                      {"output shaft", 6.906e-7, 0.0, {0, 0, 1, -1}}}};
}

TEST(TorsionalChain, ReferenceTwoInertias) {
  // (DY-3, DY-5): Closed form: f_r = sqrt(K (1/J_L + 1/(i^2 J_m)))/2 pi, f_a = sqrt(K/J_L)/2 pi;
  // ten digits given.
  struct Case {
    double load, free, locked;
  };
  for (const Case& one : {Case{1.0, 50.32921210, 35.58812717}, Case{0.2, 87.17275, 79.57747},
                          Case{5.0, 38.98484, 15.91549}}) {
    const TorsionalChain chain = two_inertias(1e-4, one.load, 5e4, -0.01, 10.0);
    const auto modes = chain_modes(chain);
    ASSERT_EQ(modes.size(), 2U);
    EXPECT_EQ(modes[0].frequency, 0.0);
    EXPECT_TRUE(modes[0].energy_share.empty());
    test::expect_relative(modes[1].frequency, one.free, 4e-7);
    const std::array<std::size_t, 1> motor = {0};
    const auto locked = chain_modes(chain, motor);
    ASSERT_EQ(locked.size(), 1U);
    test::expect_relative(locked[0].frequency, one.locked, 4e-7);
    EXPECT_EQ(locked[0].shape[0], 0.0);
  }
  // zeta = c omega/(2 K), with the printed digits.
  test::expect_relative(chain_modes(two_inertias(1e-4, 1, 5e4, -0.01, 10))[1].damping_ratio,
                        0.0316227766, 1e-8);
}

TEST(TorsionalChain, ReferenceCriticalSpeeds) {
  // (DY-8): The wave of order 2 meets f at 30 f rpm, for the frequency of the boundary condition.
  const double rpm = 2 * pi / 60;
  test::expect_relative(critical_speed(35.58812717, 2) / rpm, 1067.6438, 1e-7);
  test::expect_relative(critical_speed(50.32921210, 2) / rpm, 1509.8764, 1e-7);
}

TEST(TorsionalChain, ReferenceFourInertias) {
  // (DY-3): Eigenvalues and energies of an independent program, all digits given.
  const TorsionalChain chain = four_inertias();
  const auto modes = chain_modes(chain);
  ASSERT_EQ(modes.size(), 4U);
  const std::array<double, 3> frequencies = {37.76907141, 1437.55305, 3438.53968};
  const std::array<std::array<double, 3>, 3> shares = {{{0.268941, 0.186230, 0.544829},
                                                        {0.504778, 0.069059, 0.426162},
                                                        {0.226281, 0.744710, 0.029009}}};
  for (std::size_t m = 0; m < 3; ++m) {
    test::expect_relative(modes[m + 1].frequency, frequencies[m], 1e-7);
    for (std::size_t s = 0; s < 3; ++s)
      EXPECT_NEAR(modes[m + 1].energy_share[s], shares[m][s], 6e-7);  // the last digit
  }
  const std::array<std::size_t, 1> input = {0};
  const auto locked = chain_modes(chain, input);
  const std::array<double, 3> held = {31.60817296, 1437.27415, 3438.48741};
  for (std::size_t m = 0; m < 3; ++m) test::expect_relative(locked[m].frequency, held[m], 1e-7);
}

TEST(TorsionalChain, ReferencePublishedDrives) {
  // Third axis of a robot: ratio -105, 43 N*m/rad and 0.0013 kg*m^2 at the motor, load 10 kg*m^2.
  const TorsionalChain axis = two_inertias(0.0013, 10, 43.0 * 105 * 105, -1.0 / 105);
  test::expect_relative(chain_modes(axis)[1].frequency, 45.151902, 1e-7);
  const std::array<std::size_t, 1> motor = {0};
  test::expect_relative(chain_modes(axis, motor)[0].frequency, 34.653225, 1e-7);
  // Joint of three inertias, all at the output.
  const TorsionalChain joint = {
      .inertias = {{"motor", 0.3594}, {"gear", 0.112}, {"load", 1.0}},
      .springs = {{"gear", 1.0 / 16000, 0.0, {1, -1, 0}}, {"bar", 1.0 / 6000, 0.0, {0, 1, -1}}}};
  test::expect_relative(chain_modes(joint)[1].frequency, 19.582041, 1e-7);
  test::expect_relative(chain_modes(joint)[2].frequency, 76.627604, 1e-7);
}

TEST(TorsionalChain, CrosscheckShareIsTheDerivativeOfTheFrequency) {
  // (DY-4): Central difference of ln f by ln lambda with step 1e-5: truncation below 1e-9.
  for (std::size_t s = 0; s < 3; ++s) {
    TorsionalChain more = four_inertias();
    TorsionalChain less = more;
    more.springs[s].compliance *= 1 + 1e-5;
    less.springs[s].compliance *= 1 - 1e-5;
    for (std::size_t m = 1; m < 4; ++m) {
      const double slope =
          std::log(chain_modes(more)[m].frequency / chain_modes(less)[m].frequency) / 2e-5;
      EXPECT_NEAR(slope, -chain_modes(four_inertias())[m].energy_share[s] / 2, 1e-8);
    }
  }
}

TEST(TorsionalChain, IdentityShapesAreOrthogonalAndSharesSumToOne) {
  std::mt19937_64 numbers(7);
  std::uniform_real_distribution<double> exponent(-2, 2);
  for (int n = 0; n < 20; ++n) {
    TorsionalChain chain = four_inertias();
    for (ChainInertia& of : chain.inertias) of.inertia *= std::pow(10, exponent(numbers));
    for (ChainSpring& of : chain.springs) of.compliance *= std::pow(10, exponent(numbers));
    const auto modes = chain_modes(chain);
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t k = 0; k < 4; ++k) {
        double product = 0.0;
        for (std::size_t j = 0; j < 4; ++j)
          product += chain.inertias[j].inertia * modes[m].shape[j] * modes[k].shape[j];
        EXPECT_NEAR(product, m == k ? 1.0 : 0.0, 1e-9);
      }
      if (m == 0) continue;
      double sum = 0.0;
      for (const double share : modes[m].energy_share) sum += share;
      // Rounding of a soft mode beside one that is 1e5 times faster.
      EXPECT_NEAR(sum, 1.0, 1e-6);
    }
  }
}

TEST(TorsionalChain, ReferenceResponseOfTwoInertias) {
  // (DY-6): Closed form of the response to a torque on the motor, ten digits given.
  const TorsionalChain chain = two_inertias(1e-4, 1, 5e4, -0.01, 10);
  struct Case {
    double frequency, motor, load;
  };
  for (const Case& one :
       {Case{10, 1.214468844, 1.318561114e-2}, Case{35.58812717, 8.908708064e-3, 1.994038735e-3},
        Case{50.32921210, 0.7921489759, 7.921489759e-3},
        Case{100, 2.960474156e-2, 4.326274878e-5}}) {
    const ChainResponse at = torque_response(chain, 0, one.frequency);
    // At f_a the printed frequency has ten digits, and the response of the motor is near its least.
    test::expect_relative(std::abs(at[0]), one.motor, 1e-8);
    test::expect_relative(std::abs(at[1]), one.load, 1e-8);
  }
}

TEST(TorsionalChain, ReferenceResponseToAKinematicError) {
  // (DY-7): Motor of given speed: theta_L/theta_k = (c s + K)/(J_L s^2 + c s + K), in closed form.
  const TorsionalChain chain = two_inertias(1e-4, 1, 5e4, 0.01, 10);
  const std::array<std::size_t, 1> motor = {0};
  for (const double frequency : {1.0, 20.0, 40.0, 300.0}) {
    const std::complex<double> s(0, 2 * pi * frequency);
    const std::complex<double> expected = (10.0 * s + 5e4) / (s * s + 10.0 * s + 5e4);
    const std::complex<double> found = twist_response(chain, 0, frequency, motor)[1];
    EXPECT_LT(std::abs(found - expected), 1e-12 * std::abs(expected));
  }
}

TEST(TorsionalChain, IdentityOfReciprocity) {
  // The answer at a to a torque at b is the answer at b to a torque at a.
  TorsionalChain chain = four_inertias();
  chain.springs[0].damping = 3;
  chain.inertias[2].damping_to_ground = 0.4;
  for (const double frequency : {5.0, 37.0, 1000.0})
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_LT(std::abs(torque_response(chain, a, frequency)[b] -
                           torque_response(chain, b, frequency)[a]),
                  1e-9 * std::abs(torque_response(chain, a, frequency)[b]));
}

TEST(TorsionalChain, LimitOfAStiffSpringJoinsItsInertias) {
  TorsionalChain chain = four_inertias();
  chain.springs[1].compliance *= 1e-6;
  TorsionalChain joined = {
      .inertias = {chain.inertias[0], {"rim and cup", 0.05}, chain.inertias[3]},
      .springs = {{"wave generator", 3.407e-7, 0.0, {-0.01, -1, 0}},
                  {"output shaft", 6.906e-7, 0.0, {0, 1, -1}}}};
  for (std::size_t m = 1; m < 3; ++m)  // the spring's twist is 1e-6 of that of the others
    test::expect_relative(chain_modes(chain)[m].frequency, chain_modes(joined)[m].frequency, 1e-5);
}

TEST(TorsionalChain, InputEachRuleBrokenOnce) {
  const TorsionalChain good = four_inertias();
  const auto message = [](const TorsionalChain& chain, std::span<const std::size_t> held = {}) {
    return test::broken_rule([&] { return chain_modes(chain, held); });
  };
  EXPECT_EQ(message(good), "no error");
  EXPECT_NE(message({}).find("inertias"), std::string::npos);
  TorsionalChain chain = good;
  chain.inertias[1].inertia = 0;
  EXPECT_NE(message(chain).find("rim.inertia"), std::string::npos);
  chain = good;
  chain.inertias[1].damping_to_ground = -1;
  EXPECT_NE(message(chain).find("rim.damping_to_ground"), std::string::npos);
  chain = good;
  chain.springs[2].compliance = -1e-7;
  EXPECT_NE(message(chain).find("output shaft.compliance"), std::string::npos);
  chain = good;
  chain.springs[2].damping = -1;
  EXPECT_NE(message(chain).find("output shaft.damping"), std::string::npos);
  chain = good;
  chain.springs[2].twist_of.pop_back();
  EXPECT_NE(message(chain).find("one number for each inertia"), std::string::npos);
  chain = good;
  chain.springs[2].twist_of[1] = std::nan("");
  EXPECT_NE(message(chain).find("a finite number"), std::string::npos);
  // With the input held nothing turns freely, and a frequency that only rounding leaves is refused.
  chain = good;
  chain.inertias[3].inertia = 1e12;
  const std::array<std::size_t, 1> input = {0};
  EXPECT_NE(message(chain, input).find("inertias: differ so much"), std::string::npos);
  chain.inertias[3].inertia = 1e3;
  EXPECT_EQ(message(chain, input), "no error");
  const std::array<std::size_t, 1> none = {7};
  EXPECT_NE(message(good, none).find("held"), std::string::npos);
  const std::array<std::size_t, 4> all = {0, 1, 2, 3};
  EXPECT_NE(message(good, all).find("can turn"), std::string::npos);
  const auto response = [&](std::size_t loaded, double frequency) {
    return test::broken_rule([&] { return torque_response(good, loaded, frequency); });
  };
  EXPECT_NE(response(9, 10).find("loaded"), std::string::npos);
  EXPECT_NE(response(0, 0).find("frequency"), std::string::npos);
  EXPECT_NE(test::broken_rule([&] { return twist_response(good, 5, 10); }).find("spring"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([] { return critical_speed(10, 0); }).find("order"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([] { return critical_speed(-1, 2); }).find("frequency"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/frequency_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Motor of 1e-4 kg*m^2 and load of 1 kg*m^2 behind a gear of -100, 5e4 N*m/rad.
TorsionalChain shaken_pair(double damping) {
  return {
      .inertias = {{"motor", 1e-4}, {"load", 1.0}},
      .springs = {
          {.name = "drive", .compliance = 1 / 5e4, .damping = damping, .twist_of = {-0.01, -1.0}}}};
}

/// A row of inertias with springs between them; the first spring has a gear.
TorsionalChain shaken_row(std::size_t n, double damping) {
  TorsionalChain chain;
  for (std::size_t i = 0; i < n; ++i)
    chain.inertias.push_back(
        {"J" + std::to_string(i), i == 0 ? 1e-4 : 0.02 * double(i), i == 0 ? 1e-5 * damping : 0.0});
  for (std::size_t i = 0; i + 1 < n; ++i) {
    ChainSpring spring{.name = "K" + std::to_string(i),
                       .compliance = 1e-6 * double(i + 1),
                       .damping = damping * double(i + 1),
                       .twist_of = std::vector<double>(n, 0.0)};
    spring.twist_of[i] = i == 0 ? -0.01 : 1.0;
    spring.twist_of[i + 1] = -1.0;
    chain.springs.push_back(std::move(spring));
  }
  return chain;
}

constexpr ChainPath kMotorToMotor{.at = 0, .inertia = 0};
constexpr ChainPath kMotorToLoad{.at = 0, .inertia = 1};
constexpr ChainPath kErrorToLoad{.by = ShakenBy::twist, .at = 0, .inertia = 1};
constexpr ChainPath kLoadToLoad{.at = 1, .inertia = 1};

TEST(FrequencyResponse, ReferenceTwoInertias) {
  // (DY-12): closed forms theta_m/T_m = (J_L s^2 + c s + K)/{s^2 [J_m J_L s^2 + (J_m + J_L/i^2)
  // (c s + K)]} and theta_L/T_m = (1/i)(c s + K)/{...}; amplitudes of the design paper with their
  // printed digits.
  const std::vector<double> frequencies = {10, 35.58812717, 50.32921210, 100};
  const std::array<double, 4> motor = {1.214468844, 8.908708064e-3, 0.7921489759, 2.960474156e-2};
  const std::array<double, 4> load = {1.318561114e-2, 1.994038735e-3, 7.921489759e-3,
                                      4.326274878e-5};
  const std::array paths = {kMotorToMotor, kMotorToLoad};
  const auto found = frequency_responses(shaken_pair(10), paths, frequencies);
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    test::expect_relative(std::abs(found[0][n]), motor[n], 1e-8);
    test::expect_relative(std::abs(found[1][n]), load[n], 1e-8);
    const Complex s(0, 2 * pi * frequencies[n]);
    const Complex K = 10.0 * s + 5e4;
    const Complex below = s * s * (1e-4 * s * s + (1e-4 + 1e-4) * K);
    // The sum of terms of 1e5 leaves 1e-12 near the antiresonance.
    EXPECT_LT(std::abs(found[0][n] - (s * s + K) / below), 1e-10 * std::abs(found[0][n]));
    EXPECT_LT(std::abs(found[1][n] + 0.01 * K / below), 1e-10 * std::abs(found[1][n]));
  }
}

TEST(FrequencyResponse, ReferenceKinematicErrorAtGivenSpeed) {
  // (DY-12): theta_L/theta_k = (c s + K)/(J s^2 + c s + K) with locked input, in closed form.
  const std::vector<double> frequencies = logarithmic_frequencies(0.01, 1e4, 61);
  const std::array paths = {kErrorToLoad, kLoadToLoad};
  const std::array<std::size_t, 1> locked = {0};
  const auto found = frequency_responses(shaken_pair(10), paths, frequencies, locked);
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    const Complex s(0, 2 * pi * frequencies[n]);
    const Complex K = 10.0 * s + 5e4;
    EXPECT_LT(std::abs(found[0][n] - K / (s * s + K)), 1e-13 * std::abs(K / (s * s + K)));
    EXPECT_LT(std::abs(found[1][n] - 1.0 / (s * s + K)), 1e-13 / std::abs(s * s + K));
  }
}

TEST(FrequencyResponse, CrosscheckEachSizeOfChainWithOneFrequencyAtATime) {
  // (DY-6, DY-7, DY-12): a solution by Eigen's factors for each frequency and each excitation.
  for (std::size_t n = 2; n <= 8; ++n) {
    const TorsionalChain chain = shaken_row(n, 3.0);
    const std::size_t last = n - 1;
    const std::vector<ChainPath> paths = {{.at = 0, .inertia = 0},
                                          {.at = 0, .inertia = last},
                                          {.by = ShakenBy::twist, .at = n - 2, .inertia = last},
                                          {.by = ShakenBy::twist, .at = 0, .inertia = 0},
                                          {.at = last, .inertia = last}};
    const std::vector<double> frequencies = {0.3, 17.0, 900.0, 4.1e3};
    const auto found = frequency_responses(chain, paths, frequencies);
    for (std::size_t f = 0; f < frequencies.size(); ++f)
      for (std::size_t p = 0; p < paths.size(); ++p) {
        const ChainResponse one = paths[p].by == ShakenBy::torque
                                      ? torque_response(chain, paths[p].at, frequencies[f])
                                      : twist_response(chain, paths[p].at, frequencies[f]);
        // Both lose digits to the free turn at low frequency.
        EXPECT_LT(std::abs(found[p][f] - one[paths[p].inertia]),
                  1e-8 * std::abs(one[paths[p].inertia]))
            << n << ' ' << p << ' ' << f;
      }
  }
}

TEST(FrequencyResponse, LimitWithoutDampingIsReal) {
  // (DY-12): without damping theta_m/T_m = (K - w^2 J_L)/(-w^2 [J_m J_L (-w^2) + (J_m + J_L/i^2)
  // K]); the angle is exactly in phase or against it.
  const std::array paths = {kMotorToMotor};
  const std::vector<double> frequencies = {5, 30, 45, 200};
  const auto found = frequency_responses(shaken_pair(0), paths, frequencies);
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    const double square = std::pow(2 * pi * frequencies[n], 2);
    EXPECT_EQ(found[0][n].imag(), 0.0);
    test::expect_relative(found[0][n].real(),
                          (5e4 - square) / (-square * (-1e-4 * square + 2e-4 * 5e4)), 1e-11);
  }
}

TEST(FrequencyResponse, IdentityAHeldInertiaDoesNotTurn) {
  const std::array paths = {ChainPath{.at = 1, .inertia = 0}};
  const std::array<std::size_t, 1> locked = {0};
  const std::array frequencies = {20.0};
  EXPECT_EQ(frequency_responses(shaken_pair(10), paths, frequencies, locked)[0][0], 0.0);
}

TEST(ResponseExtrema, ReferenceOneInertiaOnASpring) {
  // (DY-13): |1/(K - w^2 J + i w c)| is largest at w_0 sqrt(1 - 2 zeta^2) with 1/(c w_0 sqrt(1 -
  // zeta^2)); the half-power points have w^2 = w_0^2 (1 - 2 zeta^2 -+ 2 zeta sqrt(1 - zeta^2)).
  const std::array<std::size_t, 1> locked = {0};
  for (const double damping : {1.0, 10.0, 100.0}) {
    const auto found = response_extrema(shaken_pair(damping), kLoadToLoad, 1.0, 1000.0, locked);
    ASSERT_EQ(found.size(), 1U);
    const double omega = std::sqrt(5e4);
    const double zeta = damping / (2 * omega);
    EXPECT_EQ(found[0].kind, ExtremumKind::resonance);
    const double peak = omega * std::sqrt(1 - 2 * zeta * zeta);
    // A flat top hides half of the digits of its place.
    test::expect_relative(found[0].frequency, peak / (2 * pi), 1e-7);
    test::expect_relative(*found[0].amplitude, 1 / (damping * omega * std::sqrt(1 - zeta * zeta)),
                          1e-10);
    const auto at = [&](double sign) {
      return omega * std::sqrt(1 - 2 * zeta * zeta + sign * 2 * zeta * std::sqrt(1 - zeta * zeta));
    };
    test::expect_relative(*found[0].damping_ratio, (at(1) - at(-1)) / (2 * peak), 1e-7);
  }
}

TEST(ResponseExtrema, LimitOfSmallDampingIsTheDampingOfTheMode) {
  // (DY-5, DY-13): the next term is the square of the damping ratio times three.
  const double zeta = chain_modes(shaken_pair(1))[1].damping_ratio;
  const auto found = response_extrema(shaken_pair(1), kMotorToMotor, 10.0, 100.0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, ExtremumKind::antiresonance);
  EXPECT_EQ(found[1].kind, ExtremumKind::resonance);
  EXPECT_NEAR(*found[1].damping_ratio / zeta, 1.0, 10 * zeta);
  test::expect_relative(found[1].frequency, 50.32921210, 1e-4);
  // The antiresonance is the locked drive, whose damping ratio is c w/(2 K).
  test::expect_relative(found[0].frequency, 35.58812717, 1e-4);
  EXPECT_NEAR(*found[0].damping_ratio / (std::sqrt(5e4) / 1e5), 1.0, 10 * zeta);
}

TEST(ResponseExtrema, LimitWithoutDamping) {
  // (DY-13): resonance at f_r and antiresonance at f_a, closed forms with ten digits given.
  const auto found = response_extrema(shaken_pair(0), kMotorToMotor, 1.0, 1000.0);
  ASSERT_EQ(found.size(), 2U);
  test::expect_relative(found[0].frequency, 35.58812717, 1e-9);
  EXPECT_EQ(*found[0].amplitude, 0.0);
  test::expect_relative(found[1].frequency, 50.32921210, 1e-9);
  EXPECT_FALSE(found[1].amplitude.has_value());
  EXPECT_EQ(*found[1].damping_ratio, 0.0);
}

TEST(ResponseExtrema, BehaviourAPeakThatIsCutHasNoDampingRatio) {
  // The half-power points of f_r = 50.3 Hz with zeta = 0.032 are near 48.7 and 51.9 Hz.
  const auto found = response_extrema(shaken_pair(10), kMotorToMotor, 49.5, 60.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].damping_ratio.has_value());
  const auto right = response_extrema(shaken_pair(10), kMotorToMotor, 40.0, 51.0);
  ASSERT_EQ(right.size(), 1U);
  EXPECT_FALSE(right[0].damping_ratio.has_value());
  const auto whole = response_extrema(shaken_pair(10), kMotorToMotor, 40.0, 60.0);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_NEAR(*whole[0].damping_ratio, 0.0316, 1e-3);
}

TEST(ResponseExtrema, BehaviourALeastAmplitudeWithoutAZeroIsNoAntiresonance) {
  // theta_L/T_m has no zero below K/c; between the free turn and the resonance it is only small.
  for (const double damping : {0.0, 10.0}) {
    const auto found = response_extrema(shaken_pair(damping), kMotorToLoad, 1.0, 500.0);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, ExtremumKind::resonance);
  }
}

TEST(ResponseExtrema, CrosscheckARowOfInertiasAgainstItsModes) {
  // A lightly damped row has its resonances at its natural frequencies; zeta is below 1e-3.
  const TorsionalChain chain = shaken_row(6, 1e-3);
  const auto modes = chain_modes(chain);
  const auto found = response_extrema(chain, kMotorToMotor, 1.0, 2e4);
  std::vector<double> peaks;
  for (const ResponseExtremum& at : found)
    if (at.kind == ExtremumKind::resonance) peaks.push_back(at.frequency);
  ASSERT_EQ(peaks.size(), modes.size() - 1);
  for (std::size_t m = 0; m < peaks.size(); ++m)
    test::expect_relative(peaks[m], modes[m + 1].frequency, 1e-5);
}

TEST(ResponseExtrema, LimitAZeroInADampedChainIsExact) {
  // (DY-13): the response of an inertia to its own torque is 0 where the rest of the chain, with
  // this inertia at rest, is at resonance.  A damper on this inertia does not act there.
  const TorsionalChain chain = {
      .inertias = {{"motor", 2.0, 0.03}, {"load", 3.0}},
      .springs = {{.name = "spring", .compliance = 1 / 50.0, .twist_of = {1.0, -1.0}}}};
  const auto extrema = response_extrema(chain, {.at = 0, .inertia = 0}, 0.1, 10);
  const auto zero =
      std::ranges::find(extrema, ExtremumKind::antiresonance, &ResponseExtremum::kind);
  ASSERT_NE(zero, extrema.end());
  test::expect_relative(zero->frequency, std::sqrt(50.0 / 3) / (2 * pi), 1e-7);
  EXPECT_EQ(zero->amplitude, 0.0);
  EXPECT_EQ(zero->damping_ratio, 0.0);
}

TEST(FrequencyResponse, BehaviourFrequenciesAreEvenlySpacedInTheirLogarithm) {
  const std::vector<double> at = logarithmic_frequencies(2, 2000, 7);
  ASSERT_EQ(at.size(), 7U);
  EXPECT_EQ(at.front(), 2.0);
  EXPECT_EQ(at.back(), 2000.0);
  for (std::size_t n = 1; n < at.size(); ++n)
    test::expect_relative(at[n] / at[n - 1], std::sqrt(10.0), 1e-12);
}

TEST(FrequencyResponse, InputEachRuleBrokenOnce) {
  const auto message = [](const ChainPath& path, double frequency, double damping = 10) {
    return test::broken_rule([&] {
      return frequency_responses(shaken_pair(damping), std::array{path}, std::array{frequency});
    });
  };
  EXPECT_EQ(message(kMotorToLoad, 10), "no error");
  EXPECT_NE(message({.at = 2, .inertia = 0}, 10).find("loaded"), std::string::npos);
  EXPECT_NE(message({.at = 0, .inertia = 2}, 10).find("inertia"), std::string::npos);
  EXPECT_NE(message({.by = ShakenBy::twist, .at = 1}, 10).find("spring"), std::string::npos);
  EXPECT_NE(message(kMotorToLoad, 0).find("frequency"), std::string::npos);
  EXPECT_NE(message(kMotorToLoad, std::numeric_limits<double>::quiet_NaN()).find("frequency"),
            std::string::npos);
  EXPECT_NE(message(kMotorToLoad, std::numeric_limits<double>::infinity()).find("frequency"),
            std::string::npos);
  // One inertia of 1 kg*m^2 on 1 N*m/rad is at its resonance at 1/(2 pi) Hz: K - w^2 J is 0.
  const TorsionalChain single = {.inertias = {{"load", 1.0}}, .springs = {{"K", 1.0, 0.0, {1.0}}}};
  const std::array paths = {ChainPath{}};
  const double omega_one = 1 / (2 * pi);
  ASSERT_EQ(2 * pi * omega_one, 1.0);
  EXPECT_NE(test::broken_rule([&] {
              return frequency_responses(single, paths, std::array{omega_one});
            }).find("infinite"),
            std::string::npos);
  const auto range = [](double from, double to, std::size_t points) {
    return test::broken_rule([&] { return logarithmic_frequencies(from, to, points); });
  };
  EXPECT_NE(range(0, 10, 5).find("from"), std::string::npos);
  EXPECT_NE(range(10, 10, 5).find("to"), std::string::npos);
  EXPECT_NE(range(1, 10, 1).find("points"), std::string::npos);
  const auto searched = [](double from, double to) {
    return test::broken_rule(
        [&] { return response_extrema(shaken_pair(10), kMotorToLoad, from, to); });
  };
  EXPECT_NE(searched(std::numeric_limits<double>::quiet_NaN(), 10).find("from"), std::string::npos);
  EXPECT_NE(searched(10, 1).find("to"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

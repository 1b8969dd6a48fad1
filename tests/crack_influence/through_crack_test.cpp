// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_influence/through_crack.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr std::size_t kShapes = FaceTractions::kShapes;

/// Unit traction number i, the direction running slowest.
FaceTractions unit(std::size_t i) {
  FaceTractions tractions;
  (i / kShapes == 0   ? tractions.normal
   : i / kShapes == 1 ? tractions.along
                      : tractions.outward)[i % kShapes] = 1;
  return tractions;
}

FaceTractions reflected(FaceTractions tractions) {
  for (auto* const shear : {&tractions.along, &tractions.outward})
    for (double& value : *shear) value = -value;
  return tractions;
}

// --- A table of formulas
// --------------------------------------------------------------------------

/// A number of the table: of the row and column of K; linear in ln R, and no cubic in ln a.
double formula(double a, double R, double beta, std::size_t row, std::size_t column, bool keeps) {
  const double size = 1 + 0.3 * static_cast<double>(row) - 0.1 * static_cast<double>(column);
  const double x = std::log(a);
  const double at = 1 + 0.2 * x + 0.1 * x * x * x * x - 0.1 * std::log(R);
  return keeps ? size * (at + 0.5 * at * std::cos(2 * beta) - 0.2 * std::cos(4 * beta))
               : size * at * std::sin(2 * beta);
}

/// Whether a mirror image keeps the sign of mode m under traction i.
bool keeps(std::size_t mode, std::size_t i) {
  return (mode == 0) == (i >= 3 * kShapes || i / kShapes == 0);
}

/// A table with two stations and one place of contact along the crack, two through the wall.
std::string table_text() {
  std::string text =
      "# made of formulas\nsteps 1000000000000\npoissons_ratio 0.3\nstations -1 1\n"
      "contact_along 0\ncontact_across -1 1\nhalf_lengths 1 2 4 8 16\nradii 50 100\nangles 0 45 "
      "90\n";
  for (const double a : {1.0, 2.0, 4.0, 8.0, 16.0})
    for (const double R : {50.0, 100.0})
      for (const double degrees : {0.0, 45.0, 90.0}) {
        const double beta = degrees * pi / 180;
        text += fmt::format("case {} {} {} K 1e3", a, R, degrees);
        for (std::size_t row = 0; row < 6; ++row)
          for (std::size_t i = 0; i < 20; ++i)
            text += fmt::format(" {:.0f}", 1e9 * formula(a, R, beta, row, i, keeps(row % 3, i)));
        text += " gap 1e3";
        for (std::size_t place = 0; place < 2; ++place)
          for (std::size_t i = 0; i < 18; ++i)
            text += fmt::format(" {:.0f}", 1e9 * formula(a, R, beta, place, i, keeps(0, i)));
        text += " pressed 1 2e12 1e12 2e12\n";
      }
  return text;
}

// (IN-1) Kind: identity.  The interpolation gives back what a table of its own functions was made
// of, at its nodes of the size, between those of radius and angle, at the upper tip; the lower tip
// follows by half a turn, which keeps normal and along tractions of even powers of s and outward
// ones of odd powers.  Tolerance: digits of the table.
TEST(ThroughCrackTable, IdentityInterpolation) {
  const ThroughCrackTable table(table_text());
  const double t = 0.5e-3;
  for (const auto& [a, R, beta] : {std::array{1.0, 50.0, pi / 4}, std::array{2.0, 70.0, 0.3},
                                   std::array{8.0, 95.0, -1.1}, std::array{16.0, 100.0, pi / 2}}) {
    const ThroughCrackResponse crack = table.at(a * t, t, R * t, beta);
    const double root = std::sqrt(pi * a * t);
    for (std::size_t i = 0; i < 18; ++i) {
      const ThroughCrackState state = crack.state_without_contact(unit(i));
      ASSERT_EQ(state.upper.size(), 2U);
      const bool odd = i % kShapes / 2 == 1;
      const double lower = odd != (i / kShapes == 2) ? -1 : 1;
      for (std::size_t s = 0; s < 2; ++s)
        for (std::size_t m = 0; m < 3; ++m) {
          const double expected = root * formula(a, R, beta, 3 * s + m, i, keeps(m, i));
          EXPECT_NEAR(state.upper[s][m], expected, 1e-8 * root) << i << ' ' << s << ' ' << m;
          EXPECT_NEAR(state.lower[s][m], lower * expected, 1e-8 * root)
              << i << ' ' << s << ' ' << m;
        }
    }
  }
}

// (IN-2) Kind: identity.  One place of two carries the pressure, by hand: the gaps under the
// traction that closes the first place are -g_0 and +g_1.
TEST(ThroughCrackTable, IdentityContactOfTwoPlaces) {
  const ThroughCrackTable table(table_text());
  const double a = 2;
  const double R = 60;
  const double beta = 0.2;
  const ThroughCrackResponse crack = table.at(a, 1, R, beta);
  const auto g = [&](std::size_t place, std::size_t i) {
    return formula(a, R, beta, place, i, keeps(0, i));
  };
  // Tractions of two shapes such that the gaps are -1 and +1.
  const double D = g(0, 0) * g(1, 1) - g(0, 1) * g(1, 0);
  FaceTractions tractions;
  tractions.normal[0] = (-g(1, 1) - g(0, 1)) / D;
  tractions.normal[1] = (g(0, 0) + g(1, 0)) / D;
  const ThroughCrackState state = crack.state(tractions);
  EXPECT_NEAR(state.pressure[0], 0.5, 1e-8);
  EXPECT_EQ(state.pressure[1], 0);
  const double root = std::sqrt(pi * a);
  for (std::size_t m = 0; m < 3; ++m) {
    double expected = 0;
    for (const auto& [i, load] :
         {std::pair(0, tractions.normal[0]), std::pair(1, tractions.normal[1]), std::pair(18, 0.5)})
      expected += load * formula(a, R, beta, m, static_cast<std::size_t>(i),
                                 keeps(m, static_cast<std::size_t>(i)));
    if (m == 0) expected = std::max(expected, 0.0);
    EXPECT_NEAR(state.upper[0][m], root * expected, 1e-7 * root);
  }
}

TEST(ThroughCrackTable, InputOfATable) {
  const std::string good = table_text();
  const auto rule = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return test::broken_rule([&] { return ThroughCrackTable(text); });
  };
  const auto names = [](const std::string& message, std::string_view words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  names(rule("steps", "step"), "\"steps\" in place of \"step\"");
  names(rule("1000000000000", "many"), "a finite number in place of \"many\"");
  names(rule("1000000000000", "nan"), "a finite number in place of \"nan\"");
  names(rule("1000000000000", "0"), "rising");
  names(rule("half_lengths 1 2", "half_lengths 2 1"), "rising half_lengths");
  names(rule("radii 50 100", "radii 50"), "rising half_lengths and radii");
  names(rule("angles 0 45 90", "angles 0 40 90"), "equal steps from 0 to 90");
  names(rule("angles 0 45 90", "angles 0 45 80"), "equal steps from 0 to 90");
  names(rule("case 1 50 45", "case 1 50 44"), "in the order of its axes");
  names(rule(" gap 1e3", " gap"), "in place of");
  names(test::broken_rule([&] { return ThroughCrackTable(good + "case"); }),
        "behind its last case");
  names(test::broken_rule([&] { return ThroughCrackTable(good.substr(0, good.size() - 40)); }),
        "in place of");
  EXPECT_EQ(test::broken_rule([&] { return ThroughCrackTable(good + "\n# end"); }), "no error");
}

// --- The table of the program -----------------------------------------------------------------

// Kind: identity.  A mirror image of crack and tractions has the mirror image of K.
TEST(ThroughCrack, IdentityMirror) {
  const auto at = [](double beta) { return through_crack_table().at(2e-3, 0.5e-3, 35e-3, beta); };
  const ThroughCrackResponse one = at(0.6);
  const ThroughCrackResponse other = at(-0.6);
  FaceTractions tractions;
  tractions.normal = {1e6, -60e6, 2e6, 0, -3e6, 0};
  tractions.along = {20e6, 5e6, -3e6, 0, 0, 0};
  const ThroughCrackState here = one.state(tractions);
  const ThroughCrackState there = other.state(reflected(tractions));
  double largest = 0;
  for (std::size_t s = 0; s < 5; ++s) {
    EXPECT_NEAR(here.upper[s][0], there.upper[s][0], 1);
    EXPECT_NEAR(here.lower[s][0], there.lower[s][0], 1);
    EXPECT_NEAR(here.upper[s][1], -there.upper[s][1], 1);
    EXPECT_NEAR(here.upper[s][2], -there.upper[s][2], 1);
    largest = std::max(largest, here.upper[s][0]);
  }
  EXPECT_GT(largest, 1e6);
}

// Kind: limit.  A short crack in a wide tube is a crack in a sheet: G = sigma^2 pi a/E in the mean
// over the wall, carried by K of plane strain: K_I = sigma sqrt(pi a/(1 - nu^2)) under tension, and
// K_II the same under shear.  Tolerance 1.5 %: the stations are five, K falls at the faces, and the
// tube is curved; 4 % of K_II, as K_III at the faces carries a part of G.
TEST(ThroughCrack, LimitSheet) {
  const double root = std::sqrt(pi * 1e-3 / (1 - 0.3 * 0.3));
  for (const double beta : {0.0, 0.7, pi / 2}) {
    const ThroughCrackResponse crack = through_crack_table().at(1e-3, 1e-3, 120e-3, beta);
    const auto mean = [&](const std::vector<StationModes>& K, std::size_t mode) {
      // Simpson's rule over the five stations.
      return (K[0][mode] + 4 * K[1][mode] + 2 * K[2][mode] + 4 * K[3][mode] + K[4][mode]) / 12;
    };
    EXPECT_NEAR(mean(crack.state(unit(0)).upper, 0) / root, 1, 0.015);
    EXPECT_NEAR(mean(crack.state(unit(0)).lower, 0) / root, 1, 0.015);
    EXPECT_NEAR(std::abs(mean(crack.state(unit(kShapes)).upper, 1)) / root, 1, 0.04);
    // A traction that grows along the crack, or with its square, loads the upper tip by half of it.
    EXPECT_NEAR(mean(crack.state_without_contact(unit(2)).upper, 0) / root, 0.5, 0.0075);
    EXPECT_NEAR(mean(crack.state_without_contact(unit(2)).lower, 0) / root, -0.5, 0.0075);
    EXPECT_NEAR(mean(crack.state_without_contact(unit(4)).upper, 0) / root, 0.5, 0.0075);
  }
}

// Kind: limit.  Pressure alone shuts the crack: K_I is 0 everywhere, and the pressure of the faces
// is the given one.  Tolerance 25 % near the tips, where a hat is wide against the pressure's
// effect; in the mean of the places 4 %.
TEST(ThroughCrack, LimitShut) {
  const ThroughCrackResponse crack = through_crack_table().at(2e-3, 0.5e-3, 35e-3, 0.8);
  FaceTractions pressed;
  pressed.normal[0] = -1e6;
  const ThroughCrackState state = crack.state(pressed);
  const double open = crack.state_without_contact(unit(0)).upper[2][0] * 1e6;
  for (const auto* const tip : {&state.upper, &state.lower})
    for (const StationModes& K : *tip) EXPECT_LT(K[0], 0.01 * open);
  ASSERT_EQ(state.pressure.size(), 54U);
  double mean = 0;
  for (const double p : state.pressure) {
    EXPECT_NEAR(p, 1e6, 0.25e6);
    mean += p / 54;
  }
  EXPECT_NEAR(mean, 1e6, 0.04e6);
  // Tension leaves the faces apart, and K is that without contact.
  FaceTractions pulled;
  pulled.normal[0] = 1e6;
  const ThroughCrackState apart = crack.state(pulled);
  EXPECT_EQ(std::ranges::count(apart.pressure, 0.0), 54);
  EXPECT_EQ(apart.upper, crack.state_without_contact(pulled).upper);
}

// Kind: behaviour.  Bending opens one face and shuts the other; the contact lowers K of the open
// face, and a start from a neighbouring state does not change the answer.
TEST(ThroughCrack, BehaviourBending) {
  const ThroughCrackResponse crack = through_crack_table().at(2e-3, 0.5e-3, 35e-3, pi / 4);
  FaceTractions bent;
  bent.normal[1] = 50e6;
  const ThroughCrackState state = crack.state(bent);
  const ThroughCrackState free = crack.state_without_contact(bent);
  EXPECT_GT(state.upper[4][0], 1e6);
  EXPECT_LT(state.upper[4][0], free.upper[4][0]);
  EXPECT_EQ(state.upper[0][0], 0);
  EXPECT_LT(free.upper[0][0], 0);
  bent.normal[0] = 5e6;
  const ThroughCrackState cold = crack.state(bent);
  const ThroughCrackState warm = crack.state(bent, state.pressure);
  for (std::size_t s = 0; s < 5; ++s)
    EXPECT_NEAR(cold.upper[s][0], warm.upper[s][0], 1e-6 * state.upper[4][0]);
  EXPECT_GT(cold.upper[4][0], state.upper[4][0]);
}

TEST(ThroughCrack, InputBeyondTheTable) {
  const auto rule = [](double a, double t, double R) {
    return test::broken_rule([&] { return through_crack_table().at(a, t, R, 0.1); });
  };
  EXPECT_EQ(rule(16e-3, 1e-3, 120e-3), "no error");
  EXPECT_EQ(rule(1e-3, 1e-3, 30e-3), "no error");
  EXPECT_NE(rule(17e-3, 1e-3, 60e-3).find("half_length"), std::string::npos);
  EXPECT_EQ(rule(0.5e-3, 1e-3, 60e-3), "no error");
  EXPECT_NE(rule(0.49e-3, 1e-3, 60e-3).find("half_length"), std::string::npos);
  EXPECT_NE(rule(0, 1e-3, 60e-3).find("half_length"), std::string::npos);
  EXPECT_NE(rule(1e-3, 1e-3, 29e-3).find("mean_radius"), std::string::npos);
  EXPECT_NE(rule(1e-3, 1e-3, 121e-3).find("mean_radius"), std::string::npos);
  EXPECT_NE(rule(1e-3, 0, 60e-3).find("wall_thickness"), std::string::npos);
  EXPECT_NE(rule(std::nan(""), 1e-3, 60e-3).find("half_length"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

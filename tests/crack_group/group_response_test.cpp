// SPDX-License-Identifier: Apache-2.0
// Linear response of a group with given faces.
#include "strainwave/crack_group/group_response.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

double root(double a) { return std::sqrt(pi * a); }

/// Open cracks.
std::vector<FacedCrack> open(const std::vector<StraightCrack>& cracks) {
  std::vector<FacedCrack> result;
  for (const StraightCrack& crack : cracks) result.push_back({crack, false});
  return result;
}

// Kind: reference (CG-5).  Willmore: two collinear cracks on a < |x| < b,
// K_inner = sqrt(pi/(a(b^2-a^2))) (b^2 E/K - a^2), K_outer = sqrt(pi/(b(b^2-a^2))) b^2 (1 - E/K).
// Tolerance: the stated 1e-9; the smallest gap is that of kLeastGroupGap.
TEST(GroupResponse, ReferenceTwoCollinearCracks) {
  for (const double a : {0.1, 0.5, 2.0, 20.0}) {  // half of the gap, of cracks of half length 1
    const double b = a + 2;
    const double k = std::sqrt(1 - a * a / (b * b));
    const double E = boost::math::ellint_2(k);
    const double K = boost::math::ellint_1(k);
    const double inner = std::sqrt(pi / (a * (b * b - a * a))) * (b * b * E / K - a * a);
    const double outer = std::sqrt(pi / (b * (b * b - a * a))) * b * b * (1 - E / K);
    const auto cracks = open({{{a + 1, 0}, 1.0, 0.0}, {{-a - 1, 0}, 1.0, pi}});
    const std::vector<SheetStress> stresses = {{.yy = 1}, {.xy = 1}};
    const auto of = group_response(cracks, stresses);
    test::expect_relative(of[0][0].behind.mode_1, inner, 1e-9);
    test::expect_relative(of[0][0].ahead.mode_1, outer, 1e-9);
    test::expect_relative(of[0][1].behind.mode_1, inner, 1e-9);  // turned by half a turn
    test::expect_relative(of[1][0].behind.mode_2, inner, 1e-9);
    test::expect_relative(of[1][0].ahead.mode_2, outer, 1e-9);
  }
}

// Kind: cross-check (CG-3).  Groups of unlike cracks against `crack_group` with many points, and
// against a shift of one centre by a period.  Tolerance: the stated 1e-9 of the largest K.
TEST(GroupResponse, CrosscheckOfUnlikeCracks) {
  const std::vector<std::vector<StraightCrack>> groups = {
      {{{0, 0}, 1.0, 0.3}, {{1.9, 0.9}, 0.6, -0.8}, {{-1.2, 1.1}, 0.9, 1.4}},
      {{{0, 0}, 1.0, 0.0}, {{0, 0.2}, 1.0, 0.0}},      // stacked, the smallest gap
      {{{0, 0}, 1.0, 0.0}, {{0.3, 0.75}, 0.55, 1.5}},  // one beside the flank of the other
      {{{0, 0}, 1.0, 0.9}, {{0.9, 0.1}, 0.1, -0.4}}};
  for (const std::vector<StraightCrack>& cracks : groups) {
    const SheetStress stress{.xx = 40, .yy = 50, .xy = 7};  // opens all of them
    const CrackGroup fine = crack_group(cracks, stress, {.order = 160, .period = 8.0});
    ASSERT_TRUE(fine.settled);
    const std::vector<SheetStress> one = {stress};
    std::vector<StraightCrack> shifted = cracks;
    shifted[1].centre += 16.0;
    for (const auto& places : {cracks, shifted}) {
      const auto of = group_response(open(places), one, {.period = 8.0});
      double work = 0.0;
      for (std::size_t j = 0; j < cracks.size(); ++j) {
        const double scale = 100 * root(1.0);
        EXPECT_NEAR(of[0][j].ahead.mode_1, fine.cracks[j].ahead.mode_1, 1e-9 * scale);
        EXPECT_NEAR(of[0][j].ahead.mode_2, fine.cracks[j].ahead.mode_2, 1e-9 * scale);
        EXPECT_NEAR(of[0][j].behind.mode_1, fine.cracks[j].behind.mode_1, 1e-9 * scale);
        EXPECT_NEAR(of[0][j].behind.mode_2, fine.cracks[j].behind.mode_2, 1e-9 * scale);
        const double c = std::cos(2 * cracks[j].angle);
        const double s = std::sin(2 * cracks[j].angle);
        work += (45 + 5 * c - 7 * s) * of[0][j].opening + (5 * s + 7 * c) * of[0][j].sliding;
      }
      test::expect_relative(work, fine.work, 1e-9);
    }
  }
}

// Kind: cross-check (CG-7).  Equal cracks evenly spaced over the period are the row, and both tips
// have its factors; the row counts its angle from its normal.  Tolerance: 1e-9.
TEST(GroupResponse, CrosscheckOfARowOfPlacedCracks) {
  for (const double beta : {pi / 4, 0.5, -0.9}) {
    std::vector<StraightCrack> cracks;
    constexpr int kCount = 5;
    for (int i = 0; i < kCount; ++i) cracks.push_back({{2.5 * i, 0.3}, 1.0, pi / 2 + beta});
    const double share = 2 / 2.5;
    const RowFactors F = row_factors(share, beta);
    const std::vector<SheetStress> stresses = {{.yy = 1}, {.xy = 1}};
    const auto of = group_response(open(cracks), stresses, {.period = 2.5 * kCount});
    const double c = std::cos(beta);
    const double s = std::sin(beta);
    const double normal[] = {s * s, 2 * s * c};     // (FR-6)
    const double shear[] = {s * c, c * c - s * s};  // (FR-6)
    for (std::size_t load = 0; load < 2; ++load)
      for (const CrackResponse& crack : of[load])
        for (const TipFactors& tip : {crack.behind, crack.ahead}) {
          const double opened =
              F.opening_by_normal * normal[load] + F.opening_by_shear * shear[load];
          const double slid = F.sliding_by_normal * normal[load] + F.sliding_by_shear * shear[load];
          EXPECT_NEAR(tip.mode_1, opened * root(1.0), 1e-9);
          // The sheet counts the shear toward the other side than the wall.
          EXPECT_NEAR(tip.mode_2, -slid * root(1.0), 1e-9);
        }
  }
}

// Kind: identity (CG-6).  By the theorem of Clapeyron, the energy of all cracks grows by G of all
// tips: with all half lengths, places and gaps in proportion, dU/ds = sum of G over the tips.
// The growth in proportion moves the tips by the distance from the origin, which no energy needs
// except along the cracks; so each half length is changed alone.  Tolerance: the differences.
TEST(GroupResponse, IdentityOfWorkAndFactors) {
  const std::vector<StraightCrack> cracks = {
      {{0, 0}, 1.0, 0.3}, {{1.9, 0.9}, 0.6, -0.8}, {{-1.2, 1.1}, 0.9, 1.4}};
  const std::vector<SheetStress> stress = {{.xx = 2, .yy = 5, .xy = 1.5}};
  // The third crack is closed and only slides.
  const auto solved = [&](const std::vector<StraightCrack>& places) {
    std::vector<FacedCrack> faced = open(places);
    faced[2].closed = true;
    return group_response(faced, stress)[0];
  };
  const auto work = [&](const std::vector<StraightCrack>& places) {
    const auto of = solved(places);
    double sum = 0.0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      const double c = std::cos(2 * places[j].angle);
      const double s = std::sin(2 * places[j].angle);
      sum += (3.5 + 1.5 * c - 1.5 * s) * of[j].opening + (1.5 * s + 1.5 * c) * of[j].sliding;
    }
    return sum;
  };
  const auto of = solved(cracks);
  for (std::size_t j = 0; j < cracks.size(); ++j) {
    constexpr double kStep = 1e-4;
    std::vector<StraightCrack> longer = cracks;
    std::vector<StraightCrack> shorter = cracks;
    longer[j].half_length += kStep;
    shorter[j].half_length -= kStep;
    // Half of the work is the energy, whose derivative is G = K^2/E' of both tips.
    const double slope = (work(longer) - work(shorter)) / (4 * kStep);
    double release = 0.0;
    for (const TipFactors& tip : {of[j].behind, of[j].ahead})
      release += tip.mode_1 * tip.mode_1 + tip.mode_2 * tip.mode_2;
    test::expect_relative(slope, release, 1e-6);
  }
}

// Kind: reference (CG-6).  Along one crack the opening is 4 N sqrt(a^2 - x^2)/E'; the faces of a
// closed one bear the normal stress of the sheet.  Tolerance: rounding.
TEST(GroupResponse, ReferenceFacesOfOneCrack) {
  const StraightCrack crack{{0.1, 0.2}, 2.0, 0.7};
  const double c = std::cos(1.4);
  const double s = std::sin(1.4);
  const double normal = 4 + 1 * c - 3 * s;
  const double shear = 1 * s + 3 * c;
  const std::vector<SheetStress> stress = {{.xx = 3, .yy = 5, .xy = 3}};
  const std::vector<FacedCrack> apart = {{crack, false}};
  const std::vector<FacedCrack> closed = {{crack, true}};
  const CrackResponse open = group_response(apart, stress)[0][0];
  const CrackResponse pressed = group_response(closed, stress)[0][0];
  const auto points = static_cast<double>(open.faces.size() + 1);
  for (std::size_t r = 0; r < open.faces.size(); ++r) {
    const double half_width = 2 * std::sin(static_cast<double>(r + 1) * pi / points);
    EXPECT_NEAR(open.faces[r], 4 * normal * half_width, 1e-11);
    EXPECT_NEAR(open.slid[r], 4 * shear * half_width, 1e-11);
    EXPECT_NEAR(pressed.faces[r], normal, 1e-11);
  }
  EXPECT_NEAR(open.opening, 2 * pi * 4 * normal, 1e-10);
  EXPECT_NEAR(pressed.sliding, 2 * pi * 4 * shear, 1e-10);
  EXPECT_EQ(pressed.ahead.mode_1, 0);
}

TEST(GroupResponse, ReferenceNearestCrack) {
  const std::vector<StraightCrack> cracks = {
      {{0, 0}, 1.0, 0.0}, {{0, 3}, 2.0, 0.0}, {{9, 0}, 0.5, 0.0}};
  EXPECT_NEAR(nearest_crack(cracks, 0).gap, 1.5, 1e-12);
  EXPECT_EQ(nearest_crack(cracks, 0).index, 1U);
  // Round the period, the third crack is 2 from the first one.
  EXPECT_NEAR(nearest_crack(cracks, 0, 11.0).gap, 0.5, 1e-12);
  EXPECT_EQ(nearest_crack(cracks, 0, 11.0).index, 2U);
  // A crack alone in a row is near itself.
  const std::vector<StraightCrack> one = {{{5, 0}, 1.0, 0.0}};
  EXPECT_NEAR(nearest_crack(one, 0, 3.0).gap, 1, 1e-12);
  EXPECT_TRUE(std::isinf(nearest_crack(one, 0).gap));
}

TEST(GroupResponse, InputGroupsThatCannotBe) {
  const auto rule = [](std::vector<FacedCrack> cracks) {
    return test::broken_rule([&] { (void)group_response(cracks, {}, {.period = 10.0}); });
  };
  EXPECT_EQ(rule({{{{0, 0}, 1.0, 0.0}}, {{{0.5, 0}, 1.0, 1.0}}}),
            "cracks: cracks 0 and 1 cross or touch");
  EXPECT_EQ(rule({{{{0, 0}, 5.0, 0.0}}}), "cracks: crack 0 touches the next one of its row");
  EXPECT_EQ(rule(std::vector<FacedCrack>(11)), "cracks: must be at most 10");
  const std::vector<FacedCrack> one = {{{{0, 0}, 1.0, 0.0}}};
  EXPECT_EQ(test::broken_rule([&] { (void)group_response(one, {}, {.points = {3}}); }),
            "points: must be a number of at least 4 of each crack");
}

}  // namespace
}  // namespace strainwave

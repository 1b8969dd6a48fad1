// SPDX-License-Identifier: Apache-2.0
// Straight cracks in a sheet: exact rows, two cracks, closed faces, energy.
#include "strainwave/crack_group/straight_cracks.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

double root_of(double a) { return std::sqrt(pi * a); }

std::vector<StraightCrack> one_at(double angle) {
  return {{.centre = {0.3, -0.2}, .half_length = 1.0, .angle = angle}};
}

// Kind: reference (CG-1), (CG-5).  A single crack: K and work of the stress on its plane.
// Tolerance: rounding.
TEST(CrackGroup, ReferenceSingleCrackAtAnyAngle) {
  const SheetStress stress{.xx = 3, .yy = 5, .xy = 1.5, .xz = -0.7, .yz = 0.4};
  for (const double angle : {0.0, 0.3, pi / 2, -1.1}) {
    std::vector<StraightCrack> crack = one_at(angle);
    crack[0].half_length = 2.5;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double normal = 3 * s * s + 5 * c * c - 2 * 1.5 * s * c;
    const double shear = (5 - 3) * s * c + 1.5 * (c * c - s * s);
    const double out = 0.4 * c + 0.7 * s;
    const CrackGroup group = crack_group(crack, stress, {.order = 10});
    for (const TipFactors& tip : {group.cracks[0].behind, group.cracks[0].ahead}) {
      EXPECT_NEAR(tip.mode_1, normal * root_of(2.5), 1e-12);
      EXPECT_NEAR(tip.mode_2, shear * root_of(2.5), 1e-12);
      EXPECT_NEAR(tip.mode_3, out * root_of(2.5), 1e-12);
    }
    EXPECT_NEAR(group.compliance_ratio, 1, 1e-13);
    EXPECT_NEAR(group.compliance_ratio_out_of_plane, 1, 1e-13);
    // Twice the energy of a crack is 2 pi a^2 (N^2 + S^2)/E' and pi a^2 Q^2/G.
    test::expect_relative(group.work, 2 * pi * 2.5 * 2.5 * (normal * normal + shear * shear),
                          1e-12);
    test::expect_relative(group.work_out_of_plane, 2 * pi * 2.5 * 2.5 * out * out, 1e-12);
    EXPECT_LT(group.error, 1e-12);
  }
}

// Kind: reference (CG-2), (CG-6).  Exact: collinear row in all modes, stacked row in mode III
// (Tada, Paris and Irwin), with their compliances.  Tolerance: 1e-9, rounding.
TEST(CrackGroup, ReferenceExactRows) {
  for (const double share : {0.3, 0.5, 0.8}) {
    const CrackGroup row =
        crack_group(one_at(0), {.yy = 1, .xy = 0.5, .yz = 2}, {.order = 60, .period = 2 / share});
    const double F = std::sqrt(2 / (pi * share) * std::tan(pi * share / 2));
    for (const TipFactors& tip : {row.cracks[0].behind, row.cracks[0].ahead}) {
      test::expect_relative(tip.mode_1, F * root_of(1), 1e-9);
      test::expect_relative(tip.mode_2, 0.5 * F * root_of(1), 1e-9);
      test::expect_relative(tip.mode_3, 2 * F * root_of(1), 1e-9);
    }
    test::expect_relative(row.compliance_ratio,
                          -8 / (pi * pi * share * share) * std::log(std::cos(pi * share / 2)),
                          1e-9);
  }
  for (const double h : {1.0, 2.0, 4.0}) {
    const CrackGroup row = crack_group(one_at(pi / 2), {.xz = 1}, {.order = 60, .period = h});
    test::expect_relative(std::abs(row.cracks[0].ahead.mode_3),
                          std::sqrt(h / pi * std::tanh(pi / h)) * root_of(1), 1e-9);
    test::expect_relative(row.compliance_ratio_out_of_plane,
                          2 * h * h / (pi * pi) * std::log(std::cosh(pi / h)), 1e-9);
  }
}

// Kind: reference (CG-3).  Two equal collinear cracks a < |x| < b (Willmore), by complete elliptic
// integrals.  Tolerance: 1e-8, the error of 60 points for the narrowest gap.
TEST(CrackGroup, ReferenceTwoCollinearCracks) {
  for (const double share : {0.5, 0.8, 0.9}) {
    const double a = 1 / share - 1;
    const double b = 1 / share + 1;
    const double k = std::sqrt(1 - a * a / (b * b));
    const double ratio = boost::math::ellint_2(k) / boost::math::ellint_1(k);
    const double inner = std::sqrt(pi / (a * (b * b - a * a))) * (b * b * ratio - a * a);
    const double outer = std::sqrt(pi / (b * (b * b - a * a))) * (b * b - b * b * ratio);
    const std::vector<StraightCrack> two = {{{-1 / share, 0}, 1, 0}, {{1 / share, 0}, 1, 0}};
    const CrackGroup group = crack_group(two, {.yy = 1}, {.order = 60});
    test::expect_relative(group.cracks[0].ahead.mode_1, inner, 1e-8);
    test::expect_relative(group.cracks[0].behind.mode_1, outer, 1e-8);
    test::expect_relative(group.cracks[1].behind.mode_1, inner, 1e-8);
    EXPECT_LT(group.error, 1e-5);
  }
}

// Kind: cross-check.  Source: independent solutions of the stacked rows (kernel 2S + xS' and -xS')
// and of the row of 45 degree cracks under torsion, computed for the design of this module.
// Tolerance: half a unit of their sixth digit.
TEST(CrackGroup, CrosscheckOfRowsWithoutClosedForm) {
  for (const auto& [h, F] : {std::pair{1.0, 0.398933},
                             {2.0, 0.570193},
                             {4.0, 0.789599},
                             {5.0, 0.847876},
                             {10.0, 0.954058}})
    EXPECT_NEAR(
        crack_group(one_at(pi / 2), {.xx = 1}, {.order = 60, .period = h}).cracks[0].ahead.mode_1 /
            root_of(1),
        F, 6e-7);
  for (const auto& [h, F] : {std::pair{1.0, 1.579980}, {2.0, 1.257383}, {4.0, 1.088079}})
    EXPECT_NEAR(std::abs(crack_group(one_at(pi / 2), {.xy = 1}, {.order = 60, .period = h})
                             .cracks[0]
                             .ahead.mode_2) /
                    root_of(1),
                F, 6e-7);
  struct Row {
    double period;
    double mode_1;
    double mode_2;
    double compliance;
  };
  for (const Row& row : {Row{1.5, 1.241311, 0.705067, 1.595288},
                         {2, 1.211517, 0.476926, 1.378589},
                         {3, 1.143479, 0.220598, 1.181804},
                         {6, 1.043891, 0.049167, 1.045982},
                         {20, 1.004100, 0.004143, 1.004116}}) {
    const CrackGroup group =
        crack_group(one_at(pi / 4), {.xy = -1}, {.order = 80, .period = row.period});
    EXPECT_NEAR(group.cracks[0].ahead.mode_1 / root_of(1), row.mode_1, 6e-7);
    EXPECT_NEAR(std::abs(group.cracks[0].ahead.mode_2) / root_of(1), row.mode_2, 6e-7);
    EXPECT_NEAR(group.compliance_ratio, row.compliance, 6e-7);
  }
}

// Kind: identity.  A row of many cracks given one by one is the periodic row, at its middle; the
// difference falls with the number of cracks.
TEST(CrackGroup, IdentityOfAnExplicitRow) {
  const double p = 3.0;
  const double periodic =
      crack_group(one_at(0.4), {.yy = 1}, {.order = 24, .period = p}).cracks[0].ahead.mode_1;
  double before = 1.0;
  for (const int beside : {3, 6, 12}) {
    std::vector<StraightCrack> row;
    for (int i = -beside; i <= beside; ++i) row.push_back({{i * p, 0.0}, 1.0, 0.4});
    const double middle = crack_group(row, {.yy = 1}, {.order = 12})
                              .cracks[static_cast<std::size_t>(beside)]
                              .ahead.mode_1;
    const double difference = std::abs(middle / periodic - 1);
    EXPECT_LT(difference, 0.7 * before);
    before = difference;
  }
  EXPECT_LT(before, 0.02);
}

// Kind: identity.  Turning the whole sheet, or moving it, changes nothing; the tips keep their
// factors.
TEST(CrackGroup, IdentityOfATurnedSheet) {
  const std::vector<StraightCrack> cracks = {
      {{0, 0}, 1.0, 0.2}, {{1.5, 0.8}, 0.7, -0.9}, {{-0.5, 1.4}, 1.2, 1.3}};
  const SheetStress stress{.xx = 1, .yy = 3, .xy = 0.5};
  const CrackGroup group = crack_group(cracks, stress);
  const double turn = 0.7;
  const std::complex<double> by = std::polar(1.0, turn);
  std::vector<StraightCrack> turned = cracks;
  for (StraightCrack& crack : turned) {
    crack.centre = crack.centre * by + std::complex<double>(5, -2);
    crack.angle += turn;
  }
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const SheetStress same{.xx = 1 * c * c + 3 * s * s - 2 * 0.5 * s * c,
                         .yy = 1 * s * s + 3 * c * c + 2 * 0.5 * s * c,
                         .xy = (1 - 3) * s * c + 0.5 * (c * c - s * s)};
  const CrackGroup other = crack_group(turned, same);
  for (std::size_t j = 0; j < cracks.size(); ++j) {
    EXPECT_NEAR(group.cracks[j].ahead.mode_1, other.cracks[j].ahead.mode_1, 1e-10);
    EXPECT_NEAR(group.cracks[j].behind.mode_2, other.cracks[j].behind.mode_2, 1e-10);
  }
  EXPECT_NEAR(group.compliance_ratio, other.compliance_ratio, 1e-10);
}

// Kind: identity.  The work of the group grows by 2 a dK^2 when all its cracks grow together (G
// over the tips), so compliance by opening and by K agree.  Tolerance: 1e-7, central differences.
TEST(CrackGroup, IdentityOfEnergyByOpeningAndByFactors) {
  const auto cracks_at = [](double scale) {
    return std::vector<StraightCrack>{{{0, 0}, 1.0 * scale, 0.2}, {{1.5, 0.9}, 0.7 * scale, -0.9}};
  };
  const SheetStress stress{.xx = 1, .yy = 3, .xy = 0.5};
  const auto work_at = [&](double scale) {
    return crack_group(cracks_at(scale), stress, {.order = 60}).work;
  };
  constexpr double kStep = 1e-4;
  const double by_opening = (work_at(1 + kStep) - work_at(1 - kStep)) / (2 * kStep);
  const CrackGroup group = crack_group(cracks_at(1), stress, {.order = 60});
  const std::vector<StraightCrack> cracks = cracks_at(1);
  double by_factors = 0.0;  // d(2 U E') = 2 sum of K^2 da
  for (std::size_t j = 0; j < cracks.size(); ++j)
    for (const TipFactors& tip : {group.cracks[j].behind, group.cracks[j].ahead})
      by_factors += 2 * (tip.mode_1 * tip.mode_1 + tip.mode_2 * tip.mode_2) * cracks[j].half_length;
  test::expect_relative(by_opening, by_factors, 1e-7);
}

// Kind: reference.  Two cracks far apart join the single one as (a/d)^2.
TEST(CrackGroup, ReferenceFarCracksAreAlone) {
  const auto excess = [](double d) {
    const std::vector<StraightCrack> two = {{{0, 0}, 1, 0}, {{d, 0}, 1, 0}};
    return crack_group(two, {.yy = 1}).cracks[0].ahead.mode_1 / root_of(1) - 1;
  };
  test::expect_relative(excess(200) / excess(400), 4, 0.02);
  test::expect_relative(excess(400), 1 / (2 * 400.0 * 400.0), 0.02);
}

// Kind: behaviour (CG-4).  Pressed faces touch: no mode I, the shear as without contact; a pressed
// crack beside an open one.
TEST(CrackGroup, BehaviourPressedCracksAreClosed) {
  const CrackGroup pressed = crack_group(one_at(pi / 4), {.xy = 1});  // normal stress -1
  EXPECT_TRUE(pressed.cracks[0].closed);
  EXPECT_EQ(pressed.cracks[0].ahead.mode_1, 0);
  EXPECT_EQ(pressed.compliance_ratio, 1.0);  // neither opens nor slides
  const CrackGroup slides = crack_group(one_at(0), {.yy = -1, .xy = 2});
  EXPECT_TRUE(slides.cracks[0].closed);
  test::expect_relative(slides.cracks[0].ahead.mode_2, 2 * root_of(1), 1e-12);
  EXPECT_NEAR(slides.compliance_ratio, 1, 1e-12);
  const CrackGroup shear = crack_group(one_at(0), {.xy = 1}, {.period = 3.0});
  EXPECT_FALSE(shear.cracks[0].closed);  // a pressure of the size of rounding closes nothing
  // Crossed senses: the second is at -45 degrees.
  const std::vector<StraightCrack> two = {{{0, 0}, 1, pi / 4}, {{4, 0}, 1, -pi / 4}};
  const CrackGroup both = crack_group(two, {.xy = -1});
  EXPECT_FALSE(both.cracks[0].closed);
  EXPECT_TRUE(both.cracks[1].closed);
  EXPECT_GT(both.cracks[0].ahead.mode_1, 0);
  EXPECT_EQ(both.cracks[1].behind.mode_1, 0);
}

// Kind: behaviour (CG-4).  A closed crack stands beside two that the stress opens.  If the first
// step let all faces overlap, the last crack would look pressed; its factors show that it is open.
TEST(CrackGroup, BehaviourCracksThatOpenAreNotClosedByOthers) {
  const std::vector<StraightCrack> cracks = {{{0.643, -1.374}, 1.047, 1.225},
                                             {{-1.101, -1.410}, 0.629, 2.102},
                                             {{1.240, 0.598}, 0.690, 0.223}};
  const CrackGroup group = crack_group(cracks, {.xx = -0.2288, .yy = 0.5257, .xy = 1});
  EXPECT_TRUE(group.settled);
  EXPECT_TRUE(group.cracks[0].closed);
  EXPECT_FALSE(group.cracks[1].closed);
  EXPECT_FALSE(group.cracks[2].closed);
  EXPECT_GT(group.cracks[2].behind.mode_1, 0.1);
  EXPECT_GT(group.cracks[2].ahead.mode_1, 0);
  // Faces that touch over a part of their length have no such state, and the answer says so.
  const std::vector<StraightCrack> crowded = {{{-0.592, 0.716}, 1.043, 0.091},
                                              {{0.478, -0.981}, 1.188, 0.420},
                                              {{-1.178, 1.441}, 0.823, 2.927}};
  EXPECT_FALSE(crack_group(crowded, {.xx = 0.2062, .yy = 0.0728, .xy = 1}).settled);
}

// Kind: identity (CG-6).  The compliance of a part of the load does not depend on another part that
// leaves the faces open; where the whole load closes the faces, only sliding counts.
TEST(CrackGroup, IdentityOfTheComplianceOfAPart) {
  const std::vector<StraightCrack> two = {{{0, 0}, 1, pi / 4}, {{1.2, 0.9}, 0.8, 0.9}};
  const SheetStress torsion{.xy = -1};
  const CrackGroup alone = crack_group(two, torsion);
  const CrackGroup with_force = crack_group(two, {.yy = 0.4, .xy = -1}, {.compliance_of = torsion});
  test::expect_relative(with_force.compliance_ratio, alone.compliance_ratio, 1e-12);
  test::expect_relative(with_force.work, alone.work, 1e-12);
  EXPECT_GT(with_force.cracks[0].ahead.mode_1, 1.1 * alone.cracks[0].ahead.mode_1);
  const std::vector<StraightCrack> flat = {{{0, 0}, 1, 0}};
  const CrackGroup closed =
      crack_group(flat, {.yy = -1, .xy = 2}, {.compliance_of = SheetStress{.yy = 3, .xy = 2}});
  test::expect_relative(closed.work, 2 * pi * 2 * 2, 1e-12);
  test::expect_relative(closed.compliance_ratio, 1.0, 1e-12);
}

// Kind: behaviour.  The stated error is that of the solution, within a factor of ten, and falls.
TEST(CrackGroup, BehaviourErrorIsStated) {
  const std::vector<StraightCrack> near = {{{-1.05, 0}, 1, 0}, {{1.05, 0}, 1, 0}};
  const double exact = crack_group(near, {.yy = 1}, {.order = 240}).cracks[0].ahead.mode_1;
  double before = 1.0;
  for (const int order : {12, 24, 48}) {
    const CrackGroup group = crack_group(near, {.yy = 1}, {.order = order});
    EXPECT_LT(std::abs(group.cracks[0].ahead.mode_1 / exact - 1), group.error);
    EXPECT_LT(group.error, 0.5 * before);
    before = group.error;
  }
}

// Kind: reference.  Distances by hand: end to inside, end to end, side by side, crossing.
TEST(CrackGroup, ReferenceDistances) {
  const StraightCrack flat{{1, 2}, 2, 0};
  EXPECT_NEAR(distance(flat, {{2, 3.5}, 1, pi / 2}), 0.5, 1e-14);  // above its inside
  EXPECT_NEAR(distance({{2, 3.5}, 1, pi / 2}, flat), 0.5, 1e-14);
  EXPECT_NEAR(distance(flat, {{7, 6}, 1, 0}), 5, 1e-14);  // 3-4-5 from its end
  EXPECT_NEAR(distance(flat, {{1.5, 1}, 2, 0}), 1, 1e-14);
  EXPECT_EQ(distance(flat, {{2, 2.5}, 1, pi / 2}), 0);
  EXPECT_NEAR(distance(flat, {{2, 3}, 1, pi / 2}), 0, 1e-14);  // touches
}

// Kind: cross-check.  A group of cracks that is solved step by step agrees with the same cracks as
// two, which are factored: the third is too small to matter.
TEST(CrackGroup, CrosscheckOfTheTwoSolvers) {
  const std::vector<StraightCrack> two = {{{0, 0}, 1, 0.3}, {{1.6, 0.9}, 0.8, -0.6}};
  std::vector<StraightCrack> three = two;
  three.push_back({{0.4, 40}, 1e-6, 0.1});
  const SheetStress stress{.xx = 0.5, .yy = 1, .xy = 0.2, .xz = 0.3, .yz = 1};
  const CrackGroup by_factor = crack_group(two, stress);
  const CrackGroup by_steps = crack_group(three, stress);
  for (std::size_t j = 0; j < 2; ++j) {
    const TipFactors& one = by_factor.cracks[j].ahead;
    const TipFactors& other = by_steps.cracks[j].ahead;
    test::expect_relative(other.mode_1, one.mode_1, 1e-11);
    test::expect_relative(other.mode_2, one.mode_2, 1e-11);
    test::expect_relative(other.mode_3, one.mode_3, 1e-11);
  }
}

TEST(CrackGroup, ReferenceTouchingCracks) {
  using Pair = std::pair<std::size_t, std::size_t>;
  const std::vector<StraightCrack> cracks = {{{0, 0}, 1, 0}, {{5, 2}, 1, 0}, {{9.5, 0}, 1, 0}};
  EXPECT_FALSE(touching_cracks(cracks));
  EXPECT_EQ(touching_cracks(cracks, 11.0), (Pair{0, 2}));  // once round
  EXPECT_FALSE(touching_cracks(cracks, 20.0));
  EXPECT_EQ(touching_cracks(std::span(cracks).first(1), 2.0), (Pair{0, 0}));
}

TEST(CrackGroup, InputCracksThatCannotBe) {
  const auto refusal = [](const std::vector<StraightCrack>& cracks, GroupOptions options = {}) {
    return test::broken_rule([&] { return crack_group(cracks, {.yy = 1}, options); });
  };
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}, {{0.5, 0.5}, 1, pi / 2}}),
            "cracks: cracks 0 and 1 cross or touch");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}, {{2, 0}, 1, 0}}), "cracks: cracks 0 and 1 cross or touch");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}, {{0, 0}, 1, 0}}), "cracks: cracks 0 and 1 cross or touch");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}}, {.period = 2.0}),
            "cracks: crack 0 touches the next one of its row");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}, {{5, 0.1}, 1, 1.0}}, {.period = 5.0}),
            "cracks: cracks 0 and 1 cross or touch");
  EXPECT_EQ(refusal({{{0, 0}, 0, 0}}), "half_length = 0 m violates: > 0");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}}, {.order = 3}), "order = 3 violates: >= 4 and <= 400");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}}, {.period = 0.0}), "period = 0 m violates: > 0");
  EXPECT_EQ(refusal({{{0, 0}, 1, 0}}, {.period = 2.1}), "no error");
  const auto touching = [](const StraightCrack& crack, double period) {
    return test::broken_rule([&] { return touching_cracks(std::span(&crack, 1), period); });
  };
  EXPECT_EQ(touching({{0, 0}, 1, 0}, 0.0), "period = 0 m violates: > 0");
  EXPECT_EQ(touching({{0, 0}, 0, 0}, 3.0), "half_length = 0 m violates: > 0");
}

TEST(CrackGroup, BehaviourTheErrorOfTheFewestPointsIsNotZero) {
  // Two thirds of 4 points are 2, so the estimate compares two orders at each order that is
  // allowed.
  const std::vector<StraightCrack> pair = {{{0, 0}, 1, 0}, {{2.3, 0}, 1, 0}};
  EXPECT_GT(crack_group(pair, {.yy = 1}, {.order = 4}).error, 1e-3);
}

}  // namespace
}  // namespace strainwave

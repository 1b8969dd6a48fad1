// SPDX-License-Identifier: Apache-2.0
// Unlike through cracks of the flexspline that have places: what they change of each other's
// compliance and K.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::mm;

constexpr double kWallRadius = (160 * mm - 2.24 * mm) / 2;

GearSet with_cracks(std::vector<WallThroughCrack> cracks) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  gear.flexspline->crack.clear();
  for (WallThroughCrack& crack : cracks) gear.flexspline->crack.emplace_back(std::move(crack));
  gear.flexspline->dynamic_load = 1;
  return gear;
}

WallThroughCrack& crack_at(GearSet& gear, std::size_t i) {
  return std::get<WallThroughCrack>(gear.flexspline->crack.at(i));
}

/// A crack in the sheet of the wall: x round the axis, y along it [m].
WallThroughCrack placed(double half_length, double angle, double x, double y, bool shell = false) {
  return {.half_length = half_length,
          .angle = angle,
          .shell_correction = shell,
          .distance = y,
          .position = x / kWallRadius};
}

/// Three unlike cracks near each other, of which the load opens or presses each one.
GearSet three_cracks(bool shell = true) {
  return with_cracks({placed(3 * mm, pi / 4, 10 * mm, 80 * mm, shell),
                      placed(2 * mm, 0.6, 16 * mm, 82 * mm, shell),
                      placed(2.5 * mm, -0.9, 12 * mm, 90 * mm, shell)});
}

/// A narrow tube, in which nine short cracks fill the round.
GearSet narrow(std::vector<WallThroughCrack> cracks) {
  GearSet gear = with_cracks(std::move(cracks));
  gear.drive.pitch_diameter = 26 * mm;
  gear.flexspline->wall_thickness = 1 * mm;
  return gear;
}

double whole_K(const CrackReport& report) {
  return std::hypot(report.largest->K_I.value, report.largest->K_II.value);
}

/// The answer for a crack as if it were alone.
CrackReport alone(GearSet gear, std::size_t i) {
  gear.flexspline->crack = {gear.flexspline->crack.at(i)};
  return flexspline_compliance(gear).cracks.at(0);
}

// Kind: reference (CG-9).  Two equal cracks in one line across the axis, under shear, in a flat
// wall: K_II of the inner tips is that of Willmore.  Tolerance: 1e-4, the images round the axis.
TEST(UnlikeCracks, ReferenceTwoCracksInOneLine) {
  const double a = 2 * mm;
  const double gap = 1 * mm;
  GearSet gear = with_cracks(
      {placed(a, pi / 2, -a - gap / 2, 80 * mm), placed(a, pi / 2, a + gap / 2, 80 * mm)});
  const MemberCompliance member = flexspline_compliance(gear);
  ASSERT_EQ(member.unusable_because, "");
  // c/d = 0.8 of the design's table: inner tips 1.228935, outer ones 1.081067; compliance 1.126008.
  for (std::size_t i = 0; i < 2; ++i) {
    test::expect_relative(whole_K(member.cracks[i]) / whole_K(alone(gear, i)), 1.228935, 1e-4);
    for (const auto sense : {&CrackReport::positive, &CrackReport::negative})
      test::expect_relative(
          (member.cracks[i].*sense).at_output.value / (alone(gear, i).*sense).at_output.value,
          1.126008, 1e-4);
  }
}

// Kind: crosscheck (CG-9), (CG-7).  Nine cracks evenly round a flat wall are the row of nine, whose
// compliance is an integral of G, while the group takes the work on the faces.  Tolerance: 1e-8; of
// the compliance 2 %, because the effect of the wall's thickness varies over the growth from 0.
TEST(UnlikeCracks, CrosscheckOfAFullRound) {
  for (const double angle : {pi / 4, 0.3, -0.8}) {
    constexpr int kCount = 9;
    std::vector<WallThroughCrack> cracks;
    for (int i = 0; i < kCount; ++i) {
      cracks.push_back(placed(2 * mm, angle, 0, 80 * mm));
      cracks.back().position = 2 * pi * i / kCount;
    }
    const MemberCompliance group = flexspline_compliance(narrow(cracks));
    ASSERT_EQ(group.unusable_because, "");
    WallThroughCrack row = cracks.front();
    row.position.reset();
    row.count = kCount;
    const CrackReport of_row = flexspline_compliance(narrow({row})).cracks.at(0);
    for (const CrackReport& crack : group.cracks)
      test::expect_relative(whole_K(crack), whole_K(of_row), 1e-8);
    double sum = 0.0;
    for (const CrackReport& crack : group.cracks) sum += crack.positive.at_output.value;
    test::expect_relative(sum, of_row.positive.at_output.value, 0.02);
  }
}

// Kind: crosscheck (CG-9), (CG-8).  With the curvature, a full round of cracks is the row of the
// shallow shell within the stated uncertainty of the flat influence, which is not much wider.
TEST(UnlikeCracks, CrosscheckOfTheCurvature) {
  for (const double half_length : {1.2 * mm, 2.2 * mm}) {
    constexpr int kCount = 9;
    std::vector<WallThroughCrack> cracks;
    for (int i = 0; i < kCount; ++i) {
      cracks.push_back(placed(half_length, pi / 4, 0, 80 * mm, true));
      cracks.back().position = 2 * pi * i / kCount;
    }
    const MemberCompliance group = flexspline_compliance(narrow(cracks));
    ASSERT_EQ(group.unusable_because, "");
    WallThroughCrack row = cracks.front();
    row.position.reset();
    const CrackReport one = flexspline_compliance(narrow({row})).cracks.at(0);
    row.count = kCount;
    const CrackReport of_row = flexspline_compliance(narrow({row})).cracks.at(0);
    double sum = 0.0;
    for (const CrackReport& crack : group.cracks) sum += crack.positive.at_output.value;
    const double by_shell = of_row.positive.at_output.value;
    const double flat = sum / (kCount * one.positive.at_output.value);
    const CrackReport& first = group.cracks.front();
    const double stated = *first.positive.at_output.relative_uncertainty;
    EXPECT_LT(std::abs(sum / by_shell - 1), stated);
    EXPECT_LT(stated, 1.5 * std::abs(flat - 1) + 0.05);
    EXPECT_LT(std::abs(whole_K(first) / whole_K(of_row) - 1), *first.intensity_uncertainty);
  }
}

// Kind: limit (CG-9).  Far apart, the ratios join 1 as the square of size over distance: along the
// axis, where no image comes near.
TEST(UnlikeCracks, LimitFarApart) {
  const auto excess = [](double apart) {
    GearSet gear = with_cracks({placed(0.5 * mm, pi / 4, 0, 80 * mm - apart / 2),
                                placed(0.5 * mm, pi / 4, 0, 80 * mm + apart / 2)});
    const MemberCompliance member = flexspline_compliance(gear);
    return member.cracks[0].positive.at_output.value / alone(gear, 0).positive.at_output.value - 1;
  };
  test::expect_relative(excess(10 * mm) / excess(20 * mm), 4, 0.05);
  EXPECT_LT(std::abs(excess(40 * mm)), 1e-3);
}

// Kind: behaviour (CG-9).  Stacked cracks shield each other; what one hides behind is not lost: a
// small crack in the shadow of a large one hardly counts.
TEST(UnlikeCracks, BehaviourOfAShadow) {
  const double step = 1.4 * mm;  // side by side, across the cracks
  GearSet gear = with_cracks(
      {placed(5 * mm, pi / 4, 0, 80 * mm), placed(1 * mm, pi / 4, step, 80 * mm + step)});
  const MemberCompliance member = flexspline_compliance(gear);
  ASSERT_EQ(member.unusable_because, "");
  EXPECT_LT(whole_K(member.cracks[1]), 0.6 * whole_K(alone(gear, 1)));
  EXPECT_LT(member.cracks[1].positive.at_output.value,
            0.4 * alone(gear, 1).positive.at_output.value);
}

// Kind: identity (CG-9).  The short computation has the numbers of the report to the last bit, and
// a drive without a group those of the sum.
TEST(UnlikeCracks, IdentityOfTheTwoComputations) {
  for (const bool shell : {true, false}) {
    const GearSet gear = three_cracks(shell);
    const StiffnessResult whole = torsional_stiffness(gear);
    ASSERT_EQ(whole.unusable_because, "");
    const auto series = series_compliance<double>(gear);
    EXPECT_TRUE(series.usable);
    EXPECT_EQ(series.positive_added, whole.cracks[0].positive.at_output.value +
                                         whole.cracks[1].positive.at_output.value +
                                         whole.cracks[2].positive.at_output.value);
    EXPECT_EQ(series.negative_added, whole.cracks[0].negative.at_output.value +
                                         whole.cracks[1].negative.at_output.value +
                                         whole.cracks[2].negative.at_output.value);
  }
}

// Kind: crosscheck (CG-9), (SN-2).  Derivatives against central differences of the whole stiffness
// with respect to sizes, angles, places and wall.  Tolerance: 1e-7 of the added compliance, of
// which the differences use a share.
TEST(UnlikeCracks, CrosscheckOfDerivatives) {
  GearSet gear = three_cracks();
  crack_at(gear, 2).distance.reset();  // in the middle of the wall, whose length moves it
  crack_at(gear, 2).position = 0.35;
  const std::vector<double*> inputs = {
      &crack_at(gear, 0).half_length, &crack_at(gear, 1).angle,
      &*crack_at(gear, 1).position,   &*crack_at(gear, 0).distance,
      &gear.drive.pitch_diameter,     &*gear.flexspline->wall_thickness,
      &*gear.flexspline->length,      &crack_at(gear, 2).half_length};
  const std::vector<const double*> constant(inputs.begin(), inputs.end());
  const auto dual = series_compliance(gear, Lift<DualReal>(constant));
  ASSERT_TRUE(dual.usable);
  const auto plain = series_compliance<double>(gear);
  test::expect_relative(dual.positive_added.value, plain.positive_added, 1e-9);
  test::expect_relative(dual.negative_added.value, plain.negative_added, 1e-9);
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const double value = *inputs[k];
    constexpr double kStep = 2e-4;
    const auto at = [&](double by) {
      *inputs[k] = value * (1 + by * kStep);
      const auto made = series_compliance<double>(gear);
      *inputs[k] = value;
      return std::array{made.positive_added, made.negative_added};
    };
    const auto [p1, n1] = at(1);
    const auto [p2, n2] = at(-1);
    const auto [p3, n3] = at(2);
    const auto [p4, n4] = at(-2);
    const double positive = (8 * (p1 - p2) - (p3 - p4)) / (12 * kStep);
    const double negative = (8 * (n1 - n2) - (n3 - n4)) / (12 * kStep);
    EXPECT_NEAR(dual.positive_added.partial[k], positive, 1e-7 * plain.positive_added) << k;
    EXPECT_NEAR(dual.negative_added.partial[k], negative, 1e-7 * plain.negative_added) << k;
  }
}

// Kind: identity (CG-9).  The tables of a study answer like the engine.
TEST(UnlikeCracks, IdentityOfTables) {
  GearSet varied = three_cracks();
  const auto row = [&](std::size_t i) -> const GearSet* {
    crack_at(varied, 0).half_length = (3 + 1e-8 * static_cast<double>(i)) * mm;
    return &varied;
  };
  const CrackTables tables(100'000'000, row);
  EXPECT_GT(tables.tables(), 0U);
  CrackTables::Reader reader(tables);
  for (const std::size_t i : {0UL, 40'000'000UL, 90'000'000UL}) {
    (void)row(i);
    const double by_engine = series_compliance<double>(varied).positive_added;
    test::expect_relative(series_compliance(varied, reader).positive_added, by_engine, 1e-9);
  }
}

// Kind: identity (CG-9).  The torque alone and the axial force alone stress different faces, but
// the axial-torsion entries of all cracks follow from one work; a force that leaves the faces as
// they are does not change the compliances.
TEST(UnlikeCracks, IdentityUnderAnAxialForce) {
  GearSet gear = three_cracks();
  const MemberCompliance without = flexspline_compliance(gear);
  gear.load.axial_force = 100.0;
  const MemberCompliance with = flexspline_compliance(gear);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(with.cracks[i].positive.at_output.value, without.cracks[i].positive.at_output.value);
    EXPECT_NE(whole_K(with.cracks[i]), whole_K(without.cracks[i]));
  }
}

// Kind: behaviour (CG-9).  A table of finite elements is that of the crack alone, and the group
// changes its compliance as it changes that of the closed form.
TEST(UnlikeCracks, BehaviourTheNoteTellsWhatSuperpositionMisses) {
  const MemberCompliance member = flexspline_compliance(three_cracks());
  const auto note = std::ranges::find(member.notes, "crack.interaction", &Note::code);
  ASSERT_NE(note, member.notes.end());
  EXPECT_NE(note->text.find("this answer contains their influence"), std::string::npos);
  EXPECT_NE(note->text.find("plain superposition would be "), std::string::npos);
  for (const char* const tag : {"CG-6", "CG-9"})
    EXPECT_NE(std::ranges::find(member.equations, tag), member.equations.end());
}

// Kind: input (CG-9).  Each reason why a group cannot tell.
TEST(UnlikeCracks, InputGroupsThatCannotTell) {
  const auto fault = [](std::vector<WallThroughCrack> cracks) {
    const GearSet gear = with_cracks(std::move(cracks));
    const std::string why = flexspline_compliance(gear).unusable_because;
    EXPECT_EQ(series_compliance<double>(gear).usable, why.empty());
    return why;
  };
  std::vector<WallThroughCrack> many;
  for (int i = 0; i < 11; ++i) many.push_back(placed(1 * mm, pi / 4, 20 * mm * i, 80 * mm));
  EXPECT_EQ(fault(many),
            "flexspline.crack[0]: 11 through cracks of the wall have a position, and at most 10 "
            "are solved together; leave out the position of cracks that are far from the others");
  many.pop_back();
  EXPECT_EQ(fault(many), "");
  const double step = 10.8 * mm / std::numbers::sqrt2;  // 0.8 mm apart in one line
  EXPECT_EQ(
      fault({placed(5 * mm, pi / 4, 0, 80 * mm), placed(5 * mm, pi / 4, -step, 80 * mm + step)}),
      "flexspline.crack[1]: the gap to flexspline.crack[0] is less than 0.2 of the longer "
      "half length, where the cracks are about to grow together; replace both by one crack, "
      "or move one of them by position or distance");
  // A crack that only slides alone, beside one that opens.
  EXPECT_EQ(fault({placed(5 * mm, pi / 4, 0, 80 * mm), placed(2 * mm, 0, 3 * mm, 86 * mm)}),
            "flexspline.crack[1]: under positive torque the other cracks of the wall let its faces "
            "touch over a part of their length, and no model tells which part; place the cracks "
            "farther apart");
  // Long cracks near each other in a thin wall.
  const std::string curved = fault(
      {placed(20 * mm, pi / 4, 0, 80 * mm, true), placed(20 * mm, pi / 4, 10 * mm, 90 * mm, true)});
  EXPECT_TRUE(curved.starts_with(
      "flexspline.crack[0]: the cracks of the wall change each other's compliance by "))
      << curved;
  EXPECT_TRUE(curved.ends_with("place the cracks farther apart, or give shorter cracks")) << curved;
  // A small crack behind a long one does not count in the compliance, but in its own K.
  const std::string shadow = fault({placed(9 * mm, pi / 4, 0, 80 * mm, true),
                                    placed(1 * mm, pi / 4, 1.9 * mm, 81.9 * mm, true)});
  EXPECT_TRUE(
      shadow.starts_with("flexspline.crack[1]: the other cracks of the wall change its K by "))
      << shadow;
}

}  // namespace
}  // namespace strainwave

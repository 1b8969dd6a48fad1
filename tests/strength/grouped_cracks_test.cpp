// SPDX-License-Identifier: Apache-2.0
// Assessment of through cracks that influence each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/annular_cracks.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/model/input/placed_group.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/crack_assessment.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::mm;
using units::MPa;

constexpr double kRadiusOfWall = (160 * mm - 2.24 * mm) / 2;

/// Cracks across the axis in one line, which the torque slides, in a flat wall that is not bent.
GearSet in_one_line(const std::vector<double>& half_lengths, const std::vector<double>& middles) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  gear.flexspline->crack.clear();
  gear.drive.wave_number = 1;
  for (std::size_t i = 0; i < half_lengths.size(); ++i)
    gear.flexspline->crack.emplace_back(WallThroughCrack{.half_length = half_lengths[i],
                                                         .angle = pi / 2,
                                                         .shell_correction = false,
                                                         .distance = 80 * mm,
                                                         .position = middles[i] / kRadiusOfWall});
  Material& steel = gear.material["steel"];
  steel.yield_strength = 900 * MPa;
  steel.fracture_toughness = 50 * MPa;
  return gear;
}

// Kind: reference (CG-9).  K of the inner tips of two equal cracks, by Willmore, and the reference
// stress with the section that the other crack takes.  Tolerance: 1e-4, the images round the axis.
TEST(GroupedCracks, ReferenceTwoCracksInOneLine) {
  const GearSet pair = in_one_line({2 * mm, 2 * mm}, {-2.5 * mm, 2.5 * mm});
  const CrackStrength one = crack_strength(in_one_line({2 * mm}, {0.0})).at(0);
  for (const CrackStrength& crack : crack_strength(pair)) {
    test::expect_relative(crack.states.at(0).K_load / one.states.at(0).K_load, 1.228935, 1e-4);
    test::expect_relative(*crack.states.at(0).L_r / *one.states.at(0).L_r,
                          1 / (1 - 2 * mm / (pi * kRadiusOfWall)), 1e-9);
    EXPECT_NE(std::ranges::find(crack.equations, "CG-9"), crack.equations.end());
  }
}

// Kind: identity (CG-12).  K of annular cracks that shield each other is that of a crack alone
// times the factor of the group, in torsion; the collapse is that of each section.  The reserve
// grows by the same factor where K alone decides.  Tolerance: rounding.
TEST(GroupedCracks, IdentityAnnularCracks) {
  const auto shaft = [](std::optional<double> apart, double axial_force) {
    GearSet gear = in_one_line({}, {});
    gear.load.axial_force = axial_force;
    gear.output_shaft->length = 300 * mm;
    gear.output_shaft->crack.emplace_back(AnnularCrack{.depth = 2 * mm});
    gear.output_shaft->crack.emplace_back(AnnularCrack{.depth = 1.2 * mm});
    if (apart) {
      std::get<AnnularCrack>(gear.output_shaft->crack[0]).distance = 150 * mm;
      std::get<AnnularCrack>(gear.output_shaft->crack[1]).distance = 150 * mm + *apart;
    }
    return gear;
  };
  const GearSet near = shaft(1 * mm, 0);
  const OutputShaft& of = *near.output_shaft;
  const AnnularGroup group =
      annular_group(std::vector<PlacedAnnularCrack>{{0, 2 * mm}, {1 * mm, 1.2 * mm}},
                    {of.outer_diameter / 2, of.inner_diameter / 2});
  const auto together = crack_strength(near);
  const auto alone = crack_strength(shaft({}, 0));
  for (const std::size_t j : {0U, 1U}) {
    test::expect_relative(together[j].states.at(0).K_load,
                          group.cracks[j].factor * alone[j].states.at(0).K_load, 1e-9);
    EXPECT_EQ(together[j].states.at(0).L_r, alone[j].states.at(0).L_r);
    EXPECT_GE(*together[j].least_reserve(), *alone[j].least_reserve());
    EXPECT_NE(std::ranges::find(together[j].equations, "CG-12"), together[j].equations.end());
  }
  EXPECT_LT(group.cracks[1].factor, 0.7);
  // An axial force opens each crack as if it were alone.
  const auto opening = [](const GearSet& gear) {
    return drive_cracks(gear)[0].front({.size = 2 * mm}, Faces::open)[0].load.I[kAxial];
  };
  EXPECT_EQ(opening(shaft(1 * mm, 1e4)), opening(shaft({}, 1e4)));
  // Without an answer of the group, K is that of a crack alone, and a note says why.
  const auto at_one_place = crack_strength(shaft(0.0, 0));
  EXPECT_EQ(at_one_place[1].states.at(0).K_load, alone[1].states.at(0).K_load);
  const auto says = [](const CrackStrength& crack, const char* part) {
    return std::ranges::any_of(crack.notes, [&](const StrengthNote& note) {
      return note.text.find(part) != std::string::npos;
    });
  };
  EXPECT_TRUE(says(at_one_place[1], "which is an upper bound in torsion"));
  // Very near each other, and where an axial force presses the faces, K is that of a crack alone.
  const auto very_near = crack_strength(shaft(0.09 * mm, 0));
  const auto pressed = crack_strength(shaft(1 * mm, -1e5));
  const auto pressed_alone = crack_strength(shaft({}, -1e5));
  for (const std::size_t j : {0U, 1U}) {
    EXPECT_EQ(very_near[j].states.at(0).K_load, alone[j].states.at(0).K_load);
    EXPECT_TRUE(says(very_near[j], "two of them are nearer than 0.05 of the deeper one"));
    EXPECT_EQ(pressed[j].states.at(0).K_load, pressed_alone[j].states.at(0).K_load);
  }
  EXPECT_TRUE(says(together[1], "K_III contains that the other annular cracks"));
  EXPECT_FALSE(says(alone[1], "annular cracks of the shaft"));
}

// Kind: behaviour (CG-9).  With a ligament narrower than a crack, and with a group that has no
// answer, nobody can tell; farther apart the cracks hold.
TEST(GroupedCracks, BehaviourWhatCannotBeTold) {
  const auto of = [](double middle) {
    return crack_strength(in_one_line({2 * mm, 1.5 * mm}, {0.0, middle})).at(1);
  };
  const CrackStrength apart = of(6 * mm);
  EXPECT_EQ(apart.verdict, StrengthVerdict::acceptable) << apart.sentence;
  const CrackStrength narrow = of(5 * mm);
  EXPECT_EQ(narrow.verdict, StrengthVerdict::cannot_tell);
  EXPECT_NE(narrow.sentence.find("the ligament to flexspline.crack[0] is narrower than the longer "
                                 "half length, and its collapse is not assessed"),
            std::string::npos)
      << narrow.sentence;
  EXPECT_EQ(narrow.next_step,
            "Assess both cracks as one crack over their whole length, or by finite elements of the "
            "part.");
  const CrackStrength unknown = of(3.7 * mm);
  EXPECT_EQ(unknown.verdict, StrengthVerdict::cannot_tell);
  EXPECT_EQ(unknown.sentence,
            "cannot tell, because flexspline.crack[1]: the gap to flexspline.crack[0] is less than "
            "0.2 of the longer half length, where the cracks are about to grow together; replace "
            "both by one crack, or move one of them by position or distance");
}

// Kind: behaviour (CG-9).  A critical size is searched up to where the ligament to the other crack,
// which keeps its size, is as narrow as the crack is long; beyond it, a crack of this size cannot
// be told.
TEST(GroupedCracks, BehaviourTheRangeEndsAtTheNeighbour) {
  const CrackStrength crack = crack_strength(in_one_line({2 * mm, 2 * mm}, {0.0, 10 * mm})).at(0);
  const auto& critical = crack.states.at(0).critical_size;
  ASSERT_TRUE(critical && critical->none_up_to) << crack.sentence;
  // The gap 10 mm - a - 2 mm is a.
  test::expect_relative(*critical->none_up_to, 4 * mm, 1e-3);
  EXPECT_NE(critical->text.find("where the ligament to the next crack becomes narrower"),
            std::string::npos)
      << critical->text;
}

// Kind: identity (CG-9).  Under either sense the crack that opens has the K of the stiffness, also
// beside a crack that the load presses.
TEST(GroupedCracks, IdentityWithTheReportOfStiffness) {
  GearSet gear = in_one_line({2 * mm, 3 * mm}, {0.0, 9 * mm});
  std::get<WallThroughCrack>(gear.flexspline->crack[0]).angle = pi / 4;
  std::get<WallThroughCrack>(gear.flexspline->crack[1]).angle = -0.7;
  for (const double torque : {100.0, -100.0}) {
    gear.load.torque = torque;
    const StiffnessResult stiffness = torsional_stiffness(gear);
    ASSERT_EQ(stiffness.unusable_because, "");
    const auto strength = crack_strength(gear, stiffness.cracks);
    for (std::size_t i = 0; i < 2; ++i) {
      const StressIntensities& K = *stiffness.cracks[i].largest;
      const double whole = std::hypot(std::max(0.0, K.K_I.value), K.K_II.value);
      test::expect_relative(strength[i].states.at(0).K_load, whole, 1e-9);
    }
  }
}

// Kind: behaviour (CG-9), (FA-14).  The assembly stresses all cracks at once, and what they shield
// does not count, so K of the assembly is at least that of a crack alone.
TEST(GroupedCracks, BehaviourOfTheAssembly) {
  GearSet gear = in_one_line({2 * mm, 2 * mm}, {0.0, 3 * mm});
  gear.drive.wave_number = 2;
  for (FlexsplineCrack& crack : gear.flexspline->crack)
    std::get<WallThroughCrack>(crack).angle = 0;  // beside each other along the axis
  const DriveCrack shielded = drive_cracks(gear).at(0);
  gear.flexspline->crack.pop_back();
  const DriveCrack alone = drive_cracks(gear).at(0);
  const double K = alone.front(alone.size, Faces::open).at(0).assembly[0];
  for (const FrontIntensity& at : shielded.front(shielded.size, Faces::open))
    EXPECT_GE(at.assembly[0], K * (1 - 1e-12));
  // The load has no such bound.
  const auto sliding = [](const DriveCrack& crack) {
    return std::abs(crack.front(crack.size, Faces::open).at(0).load.II[kTorsion]);
  };
  EXPECT_NE(sliding(shielded), sliding(alone));
}

// Kind: identity.  A group of one table has the answers of its cracks one by one, to the last bit.
TEST(GroupedCracks, IdentityOneTableForAll) {
  GearSet group = in_one_line({2 * mm}, {0.0});
  auto& table = std::get<WallThroughCrack>(group.flexspline->crack[0]);
  table.angle = pi / 4;
  table.count = 3;
  table.pitch = 7 * mm / kRadiusOfWall;
  place_groups(group);
  GearSet single = in_one_line({2 * mm, 2 * mm, 2 * mm}, {0.0, 7 * mm, 14 * mm});
  for (FlexsplineCrack& crack : single.flexspline->crack)
    std::get<WallThroughCrack>(crack).angle = pi / 4;
  std::get<WallThroughCrack>(single.flexspline->crack[2]).position = 2 * (7 * mm / kRadiusOfWall);
  const std::vector<CrackStrength> of_group = crack_strength(group);
  const std::vector<CrackStrength> of_single = crack_strength(single);
  ASSERT_EQ(of_group.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(of_group[i].path, of_single.at(i).path);
    EXPECT_EQ(of_group[i].states.at(0).K_load, of_single[i].states.at(0).K_load);
    EXPECT_EQ(of_group[i].states.at(0).L_r, of_single[i].states.at(0).L_r);
  }
  // The crack in the middle has two neighbours.
  EXPECT_NE(of_group[0].states.at(0).K_load, of_group[1].states.at(0).K_load);
  const auto stiffness = [](const GearSet& gear) {
    return torsional_stiffness(gear).positive.stiffness.value;
  };
  EXPECT_EQ(stiffness(group), stiffness(single));
}

}  // namespace
}  // namespace strainwave

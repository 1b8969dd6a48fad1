// SPDX-License-Identifier: Apache-2.0
// Groups of cracks that one table gives: the single cracks, and every rule broken once.
#include "strainwave/model/input/placed_group.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/article_gear.hpp"
#include "support/not_finite.hpp"

namespace strainwave {
namespace {

using units::deg;
using units::mm;

/// A cup with a rim, a diaphragm and a shaft, without cracks.
GearSet cup_for_groups() {
  GearSet gear = test::article_gear();
  Flexspline& fs = *gear.flexspline;
  fs.crack_free = CrackFree::sections;
  fs.rim = TubeSection{.outer_diameter = 160 * mm, .wall_thickness = 3 * mm, .length = 30 * mm};
  fs.barrel = TubeSection{.outer_diameter = 158 * mm, .wall_thickness = 2 * mm, .length = 100 * mm};
  fs.diaphragm = Diaphragm{
      .outer_diameter = 154 * mm, .inner_diameter = 80 * mm, .thickness = 3 * mm, .profile = {}};
  fs.length.reset();
  fs.wall_thickness.reset();
  gear.wave_generator->crack.clear();
  fs.crack.clear();
  gear.output_shaft->crack.clear();
  return gear;
}

WallThroughCrack through_for_groups() {
  return {.half_length = 2 * mm, .angle = std::numbers::pi / 4, .distance = 40 * mm};
}

/// The cracks of a flexspline after their groups are made.
std::vector<FlexsplineCrack> made(const std::vector<FlexsplineCrack>& tables) {
  GearSet gear = cup_for_groups();
  gear.flexspline->crack = tables;
  place_groups(gear);
  check(gear);
  return gear.flexspline->crack;
}

/// All numbers of a drive, with their paths.
std::vector<std::pair<std::string, double>> numbers_of(const GearSet& gear) {
  std::vector<std::pair<std::string, double>> numbers;
  for_each_number(gear, [&](const FieldPath& path, const Field&, const double& number) {
    numbers.emplace_back(path.text(), number);
  });
  return numbers;
}

/// What refuses the groups of a drive; "accepted" if nothing does.
std::string refusal_of_group(const GearSet& drive) {
  GearSet gear = drive;
  try {
    place_groups(gear);
    check(gear);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Kind: identity.  A list of positions is the cracks with these positions one by one, for each kind
// of crack.  The first crack keeps its index, and the others come behind all tables.
TEST(PlacedGroups, IdentityPositionsAreCracksOneByOne) {
  const std::vector<double> places = {10 * deg, -35 * deg, 100 * deg};
  const auto both = [&](const FlexsplineCrack& one) {
    GearSet group = cup_for_groups();
    GearSet single = cup_for_groups();
    group.flexspline->crack = {one, through_for_groups(), one};
    single.flexspline->crack = {one, through_for_groups(), one, one, one};
    std::visit(
        [&](auto crack) {
          if constexpr (GroupableCrack<decltype(crack)>) {
            using Crack = decltype(crack);
            crack.positions = places;
            group.flexspline->crack[0] = crack;
            for (const auto& [index, place] :
                 {std::pair{0, places[0]}, {3, places[1]}, {4, places[2]}})
              std::get<Crack>(single.flexspline->crack[static_cast<std::size_t>(index)]).*
                  Crack::kPlace = place;
            for (GearSet* const drive : {&group, &single})
              std::get<Crack>(drive->flexspline->crack[2]).*Crack::kPlace = 200 * deg;
          } else {
            FAIL() << "not a kind with groups";
          }
        },
        one);
    place_groups(group);
    check(group);
    EXPECT_EQ(numbers_of(group), numbers_of(single));
    EXPECT_EQ(group.flexspline->crack.size(), 5U);
    ASSERT_EQ(group.placed_groups.size(), 1U);
    EXPECT_EQ(std::string(group.placed_groups[0].crack(0)), "flexspline.crack[0]");
    EXPECT_EQ(std::string(group.placed_groups[0].crack(2)), "flexspline.crack[4]");
    EXPECT_EQ(group.placed_groups[0].count, 3U);
    GearSet again = group;
    place_groups(again);
    EXPECT_EQ(numbers_of(again), numbers_of(group));
  };
  both(through_for_groups());
  both(WallSurfaceCrack{.depth = 1 * mm, .half_length = 2 * mm, .section = WallSection::rim});
  both(RimAxialCrack{{.depth = 1 * mm}});
  both(DiaphragmArcCrack{.half_length = 4 * mm, .radius = 50 * mm});

  GearSet group = cup_for_groups();
  group.output_shaft->crack = {AnnularCrack{.depth = 1 * mm, .positions = {12 * mm, 9 * mm}}};
  GearSet single = cup_for_groups();
  single.output_shaft->crack = {AnnularCrack{.depth = 1 * mm, .distance = 12 * mm},
                                AnnularCrack{.depth = 1 * mm, .distance = 9 * mm}};
  place_groups(group);
  check(group);
  EXPECT_EQ(numbers_of(group), numbers_of(single));
}

// Kind: reference.  The places by a pitch are first + i pitch, in both directions.  Tolerance:
// none.
TEST(PlacedGroups, ReferencePlacesByAPitch) {
  WallThroughCrack crack = through_for_groups();
  crack.position = 350 * deg;
  crack.count = 3;
  crack.pitch = 20 * deg;
  crack.axial_pitch = -5 * mm;
  const std::vector<FlexsplineCrack> oblique = made({crack});
  ASSERT_EQ(oblique.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const auto& one = std::get<WallThroughCrack>(oblique[static_cast<std::size_t>(i)]);
    EXPECT_EQ(one.position, 350 * deg + i * (20 * deg));
    EXPECT_EQ(one.distance, 40 * mm + i * (-5 * mm));
    EXPECT_EQ(one.count, 1);
    EXPECT_FALSE(one.pitch || one.axial_pitch || !one.positions.empty());
  }
  crack.pitch.reset();
  crack.axial_pitch = 6 * mm;
  const std::vector<FlexsplineCrack> stacked = made({crack});
  for (int i = 0; i < 3; ++i) {
    const auto& one = std::get<WallThroughCrack>(stacked[static_cast<std::size_t>(i)]);
    EXPECT_EQ(one.position, 350 * deg);
    EXPECT_EQ(one.distance, 40 * mm + i * (6 * mm));
  }
  // Axial cracks of the rim have no row of their own, so their count is a group round the axis.
  RimAxialCrack axial{{.depth = 1 * mm, .position = 5 * deg}};
  axial.count = 4;
  const std::vector<FlexsplineCrack> round = made({axial});
  ASSERT_EQ(round.size(), 4U);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(std::get<RimAxialCrack>(round[static_cast<std::size_t>(i)]).position,
              5 * deg + i * (2 * std::numbers::pi / 4));
  // A row stays one crack.
  crack = through_for_groups();
  crack.count = 7;
  EXPECT_EQ(made({crack}).size(), 1U);

  GearSet shaft = cup_for_groups();
  shaft.output_shaft->crack = {
      AnnularCrack{.depth = 1 * mm, .distance = 9 * mm, .count = 2, .pitch = 3 * mm}};
  place_groups(shaft);
  check(shaft);
  EXPECT_EQ(std::get<AnnularCrack>(shaft.output_shaft->crack.at(1)).distance, 9 * mm + 3 * mm);
}

// Two groups: their copies follow in the order of the tables.
TEST(PlacedGroups, BehaviourCopiesOfTwoGroups) {
  WallThroughCrack first = through_for_groups();
  first.positions = {0 * deg, 30 * deg};
  WallThroughCrack second = through_for_groups();
  second.half_length = 1 * mm;
  second.positions = {90 * deg, 120 * deg, 150 * deg};
  const std::vector<FlexsplineCrack> cracks = made({first, second});
  const std::vector<double> places = {0, 90, 30, 120, 150};
  ASSERT_EQ(cracks.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_EQ(std::get<WallThroughCrack>(cracks[i]).position, places[i] * deg);
}

TEST(PlacedGroups, InputRulesOfAGroup) {
  const auto wall = [](const std::function<void(WallThroughCrack&)>& change) {
    GearSet gear = cup_for_groups();
    WallThroughCrack crack = through_for_groups();
    crack.position = 0.0;
    crack.count = 3;
    crack.pitch = 20 * deg;
    change(crack);
    gear.flexspline->crack = {crack};
    return refusal_of_group(gear);
  };
  EXPECT_EQ(wall([](auto&) {}), "accepted");
  EXPECT_EQ(wall([](auto& crack) { crack.positions = {0.0}; }),
            "flexspline.crack[0].pitch: is given beside positions; give one of the two, pitch with "
            "count or positions");
  EXPECT_EQ(wall([](auto& crack) {
              crack.pitch.reset();
              crack.positions = {0.0};
            }),
            "flexspline.crack[0].position: is given beside positions; leave it out, or make it one "
            "of the positions");
  EXPECT_EQ(wall([](auto& crack) {
              crack.pitch.reset();
              crack.position.reset();
              crack.positions = {0.0, 1.0};
            }),
            "flexspline.crack[0].count = 3 violates: 2, the number of positions; or leave count "
            "out");
  EXPECT_EQ(wall([](auto& crack) {
              crack.pitch.reset();
              crack.position.reset();
              crack.positions = {0.0, 1.0, 2 * std::numbers::pi};
            }),
            "flexspline.crack[0].positions[2] = 6.28318531 rad violates: a place of its own, but "
            "positions[0] is the same");
  EXPECT_EQ(wall([](auto& crack) { crack.count = 1; }),
            "flexspline.crack[0].pitch: must be given with count, the number of cracks, 2 or more");
  EXPECT_EQ(wall([](auto& crack) { crack.pitch = 0.0; }),
            "flexspline.crack[0].pitch = 0 rad violates: pitch != 0");
  EXPECT_EQ(wall([](auto& crack) { crack.axial_pitch = 0.0; }),
            "flexspline.crack[0].axial_pitch = 0 m violates: axial_pitch != 0");
  EXPECT_EQ(wall([](auto& crack) { crack.position.reset(); }),
            "flexspline.crack[0].position: must be given with pitch, the place of the first crack "
            "[rad]");
  EXPECT_EQ(wall([](auto& crack) {
              crack.axial_pitch = 5 * mm;
              crack.distance.reset();
            }),
            "flexspline.crack[0].distance: must be given with axial_pitch, the place of the first "
            "crack [m]");
  EXPECT_EQ(wall([](auto& crack) { crack.pitch = test::kNaN; }),
            "flexspline.crack[0].position = nan rad violates: a finite number");
  EXPECT_EQ(wall([](auto& crack) { crack.count = 201; }),
            "flexspline.crack[0].count: makes 201 cracks of the groups of flexspline; at most 200 "
            "are allowed");

  const auto shaft = [](const AnnularCrack& crack) {
    GearSet gear = cup_for_groups();
    gear.output_shaft->crack = {crack};
    return refusal_of_group(gear);
  };
  EXPECT_EQ(shaft({.depth = 1 * mm, .count = 2}),
            "output_shaft.crack[0].pitch: must be given with count [m]; or give positions in place "
            "of both");
  EXPECT_EQ(
      shaft({.depth = 1 * mm, .count = 2, .pitch = 1 * mm}),
      "output_shaft.crack[0].distance: must be given with pitch, the place of the first crack "
      "[m]");
  EXPECT_EQ(shaft({.depth = 1 * mm, .positions = {5 * mm, 7 * mm, 5 * mm}}),
            "output_shaft.crack[0].positions[2] = 0.005 m violates: a place of its own, but "
            "positions[0] is the same");
}

// Kind: limit.  A pitch just longer than the crack along it is accepted, and one just shorter is
// not.  The length along the pitch is 2 a |sin(angle)| round the axis and 2 a |cos(angle)| along
// it; along the crack itself it is 2 a, and across the crack it is 0.
TEST(PlacedGroups, LimitPitchOfTheLengthOfTheCrack) {
  const double radius = 78 * mm;  // of the middle of the wall
  const auto of_steps = [&](double angle, double round, double along, double stretch) {
    GearSet gear = cup_for_groups();
    WallThroughCrack crack = through_for_groups();
    crack.angle = angle;
    crack.position = 0.0;
    crack.count = 2;
    if (round != 0) crack.pitch = stretch * round / radius;
    if (along != 0) crack.axial_pitch = stretch * along;
    gear.flexspline->crack = {crack};
    return refusal_of_group(gear);
  };
  const double a = 2 * mm;
  const double angle = 30 * deg;
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double near = 1e-6;
  struct Case {
    double round, along;
  };
  for (const Case& one : {Case{2 * a * sine, 0}, Case{0, 2 * a * cosine},
                          // In one line with the crack, which runs toward -theta.
                          Case{-2 * a * sine, 2 * a * cosine}}) {
    EXPECT_EQ(of_steps(angle, one.round, one.along, 1 + near), "accepted");
    EXPECT_NE(of_steps(angle, one.round, one.along, 1 - near).find("the length of the crack"),
              std::string::npos)
        << one.round << ' ' << one.along;
  }
  EXPECT_EQ(of_steps(angle, a * cosine, a * sine, 1e-3), "accepted");  // side by side
  EXPECT_EQ(of_steps(angle, a * sine, 0, 1),
            "flexspline.crack[0].pitch = 0.0128205128 rad violates: a step of more than 2 mm from "
            "crack to crack, the length of the crack along the step, but it is 1 mm; give "
            "positions, or one table for each crack, if they pass each other side by side");

  const auto of_arc = [&](double pitch) {
    GearSet gear = cup_for_groups();
    DiaphragmArcCrack arc{.half_length = a, .radius = 50 * mm, .position = 0.0};
    arc.count = 2;
    arc.pitch = pitch;
    gear.flexspline->crack = {arc};
    return refusal_of_group(gear);
  };
  EXPECT_EQ(of_arc(2 * a / (50 * mm) * (1 + near)), "accepted");
  EXPECT_NE(of_arc(2 * a / (50 * mm) * (1 - near)), "accepted");
}

TEST(PlacedGroups, InputCracksThatTouch) {
  WallThroughCrack crack = through_for_groups();
  crack.positions = {0 * deg, 90 * deg, 90.0001 * deg};
  GearSet gear = cup_for_groups();
  crack.angle = std::numbers::pi / 2;
  gear.flexspline->crack = {crack};
  EXPECT_EQ(refusal_of_group(gear),
            "flexspline.crack[2].position: the crack touches or crosses flexspline.crack[1]; place "
            "the two apart, or give one crack");
  DiaphragmArcCrack arc{.half_length = 5 * mm, .radius = 50 * mm};
  arc.positions = {0 * deg, 11 * deg};
  gear.flexspline->crack = {arc};
  EXPECT_EQ(refusal_of_group(gear),
            "flexspline.crack[1].position: the arc touches flexspline.crack[0]; place the two "
            "apart, or give one arc");
  arc.positions = {0 * deg, 12 * deg};
  gear.flexspline->crack = {arc};
  EXPECT_EQ(refusal_of_group(gear), "accepted");
  // The circle closes, a row repeats its arc, and another circle is another place.
  arc.positions = {0 * deg, 349 * deg};
  gear.flexspline->crack = {arc};
  EXPECT_NE(refusal_of_group(gear), "accepted");
  arc.positions.clear();
  arc.position = 0.0;
  DiaphragmArcCrack row = arc;
  row.count = 4;
  row.position = 280 * deg;
  gear.flexspline->crack = {arc, row};
  EXPECT_NE(refusal_of_group(gear), "accepted");
  row.radius = 51 * mm;
  gear.flexspline->crack = {arc, row};
  EXPECT_EQ(refusal_of_group(gear), "accepted");
}

TEST(PlacedGroups, InputCheckNeedsTheCracks) {
  GearSet gear = cup_for_groups();
  const auto refused = [&] {
    try {
      check(gear);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  WallThroughCrack crack = through_for_groups();
  crack.positions = {0.0, 1.0};
  gear.flexspline->crack = {crack};
  EXPECT_EQ(refused(),
            "flexspline.crack[0]: stands for a group whose cracks are not made; call place_groups "
            "before check");
  place_groups(gear);
  EXPECT_EQ(refused(), "accepted");
}

}  // namespace
}  // namespace strainwave

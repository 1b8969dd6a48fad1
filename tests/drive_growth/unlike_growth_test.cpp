// SPDX-License-Identifier: Apache-2.0
// Growth of through cracks that influence each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/annular_cracks.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::mm;

constexpr double kWall = (0.160 - 0.00224) / 2;

/// Cracks across the axis in one line, which the torque alone slides, in a flat wall.
/// @param apart  between the middles [m]
GearSet pair_in_line(double first, double second, double apart) {
  const auto crack = [](double a, double at) {
    return "kind = \"through\"\nhalf_length = \"" + std::to_string(a / mm) +
           " mm\"\nangle = \"90 deg\"\nshell_correction = false\nposition = \"" +
           std::to_string(at / kWall) + " rad\"\n";
  };
  return test::cracked_wall(crack(first, 0.0) + "[[flexspline.crack]]\n" + crack(second, apart),
                            "100", "1");
}

/// K of the inner tips of two equal cracks in one line over K alone (Willmore).
double inner_factor(double a, double apart) {
  const double inside = apart / 2 - a;
  const double outside = apart / 2 + a;
  const double k = std::sqrt(1 - inside * inside / (outside * outside));
  const double ratio = boost::math::ellint_2(k) / boost::math::ellint_1(k);
  return (outside * outside * ratio - inside * inside) /
         std::sqrt(a * inside * (outside * outside - inside * inside));
}

// Kind: reference (CG-9), (GR-24).  Two equal cracks grow alike, each by its inner tip, so the time
// up to a size is an integral over the size with Willmore's factor.  Tolerance: 3e-4, the error of
// the path and the images round the axis.
TEST(UnlikeGrowth, ReferenceTwoEqualCracksInOneLine) {
  const double apart = 8 * mm;
  const double begin = 2 * mm;
  const double end = 3 * mm;
  const GrowthOptions options = test::until_size("flexspline.crack[0]", end);
  const GrowthReport pair = grow_cracks(pair_in_line(begin, begin, apart), options);
  GearSet one = pair_in_line(begin, begin, apart);
  one.flexspline->crack.pop_back();
  const GrowthReport alone = grow_cracks(one, options);
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto time = [&](bool together) {
    return Quadrature::integrate(
        [&](double a) {
          const double factor = together ? inner_factor(a, apart) : 1.0;
          return std::pow(factor * std::sqrt(a), -3.0);
        },
        begin, end);
  };
  test::expect_relative(pair.time / alone.time, time(true) / time(false), 3e-4);
  EXPECT_LT(pair.step_error, 1e-3);
  // Both cracks have the same sizes all the time.
  test::expect_relative(pair.cracks.at(1).series.back().size, pair.cracks.at(0).series.back().size,
                        1e-9);
  EXPECT_NE(std::ranges::find(pair.equations, "CG-9"), pair.equations.end());
  EXPECT_EQ(std::ranges::find(alone.equations, "CG-9"), alone.equations.end());
  const auto note = std::ranges::find(pair.notes, "growth.group", &Note::code);
  ASSERT_NE(note, pair.notes.end());
  EXPECT_NE(note->text.find("the 2 through cracks of the wall influence each other"),
            std::string::npos);
}

// Kind: limit (CG-9).  Cracks on opposite sides of the wall grow as alone.  Tolerance: 1e-3.
TEST(UnlikeGrowth, LimitFarApart) {
  const GrowthOptions options = test::until_size("flexspline.crack[0]", 2.4 * mm);
  const GrowthReport pair = grow_cracks(pair_in_line(2 * mm, 1.5 * mm, pi * kWall), options);
  GearSet one = pair_in_line(2 * mm, 1.5 * mm, pi * kWall);
  one.flexspline->crack.pop_back();
  test::expect_relative(pair.time, grow_cracks(one, options).time, 2e-3);
}

// Kind: behaviour (CG-9), (CG-14).  Cracks of one line merge where the gap is a fifth of the longer
// half length: both have the event, and a note gives the one crack from outer tip to outer tip and
// how the stiffness falls, which is that of the drive with this crack.
TEST(UnlikeGrowth, BehaviourTheEndWhereCracksMeet) {
  const double apart = 6 * mm;
  const GrowthReport report = grow_cracks(pair_in_line(2 * mm, 1.5 * mm, apart));
  ASSERT_EQ(report.end, DriveEnd::range) << report.sentence;
  const double first = report.cracks.at(0).series.back().size;
  const double second = report.cracks.at(1).series.back().size;
  test::expect_relative(apart - first - second, 0.2 * std::max(first, second), 1e-4);
  EXPECT_GT(second, 1.6 * mm);
  for (const CrackGrowth& crack : report.cracks) {
    EXPECT_EQ(crack.events.back().event, CrackEvent::merges);
    EXPECT_EQ(crack.events.back().time, report.time);
  }
  EXPECT_NE(report.sentence.find("flexspline.crack[0] grows together with another crack after"),
            std::string::npos)
      << report.sentence;
  EXPECT_EQ(test::count_notes(report.notes, "growth.refused_size"), 0);
  const auto note = std::ranges::find(report.notes, "growth.merges", &Note::code);
  ASSERT_NE(note, report.notes.end());
  EXPECT_EQ(note->path, "flexspline.crack[0]");
  // The drives before and after.
  GearSet merged = pair_in_line(first, second, apart);
  const double before = torsional_stiffness(merged).positive.stiffness.value;
  merged.flexspline->crack.pop_back();
  auto& one = std::get<WallThroughCrack>(merged.flexspline->crack[0]);
  one.half_length = (apart + first + second) / 2;
  one.position = (apart + second - first) / 2 / kWall;
  const double after = torsional_stiffness(merged).positive.stiffness.value;
  EXPECT_LT(after, before);  // the ligament gives energy
  for (const std::string& part :
       {fmt::format("half_length = \"{:.6g} mm\", angle = \"90 deg\"", one.half_length / mm),
        fmt::format("position = \"{:.6g} deg\"", *one.position / units::deg),
        fmt::format("by {:.3g} %", 100 * (after / before - 1))})
    EXPECT_NE(note->text.find(part), std::string::npos) << note->text << " lacks " << part;
}

// Kind: behaviour (CG-14).  Cracks of one line at 45 degrees: the one crack has its middle between
// the outer tips, and its angle is counted from the generator.
TEST(UnlikeGrowth, BehaviourCracksOfOneInclinedLineMeet) {
  for (const double angle : {45 * units::deg, -30 * units::deg}) {
    const double apart = 6 * mm;
    GearSet pair = pair_in_line(2 * mm, 1.5 * mm, apart);
    const double from =
        3.1;  // rad; the place of the other crack is beyond half a turn or before it
    const auto place = [&](WallThroughCrack& crack, double along) {
      crack.angle = angle;
      crack.distance = 80 * mm + along * std::cos(angle);
      crack.position = from - along * std::sin(angle) / kWall;
    };
    place(std::get<WallThroughCrack>(pair.flexspline->crack[0]), 0.0);
    place(std::get<WallThroughCrack>(pair.flexspline->crack[1]), apart);
    const GrowthReport report = grow_cracks(pair);
    const auto note = std::ranges::find(report.notes, "growth.merges", &Note::code);
    ASSERT_NE(note, report.notes.end()) << report.sentence;
    WallThroughCrack one;
    const double first = report.cracks.at(0).series.back().size;
    const double second = report.cracks.at(1).series.back().size;
    place(one, (apart + second - first) / 2);
    for (const std::string& part :
         {fmt::format("half_length = \"{:.6g} mm\"", (apart + first + second) / 2 / mm),
          fmt::format("angle = \"{:.6g} deg\"", angle / units::deg),
          fmt::format("distance = \"{:.6g} mm\"", *one.distance / mm),
          fmt::format("position = \"{:.6g} deg\"", *one.position / units::deg)})
      EXPECT_NE(note->text.find(part), std::string::npos) << note->text << " lacks " << part;
  }
}

// Kind: behaviour (CG-14).  A third crack that is nearer to the one crack than a fifth of its half
// length: the drive with the one crack has no usable stiffness, and the note states none.
TEST(UnlikeGrowth, BehaviourAMergerBesideAThirdCrack) {
  GearSet three = pair_in_line(2 * mm, 1.5 * mm, 6 * mm);
  WallThroughCrack third = std::get<WallThroughCrack>(three.flexspline->crack[0]);
  third.half_length = 1 * mm;
  third.position = -5.3 * mm / kWall;  // a gap that shrinks with the other one
  three.flexspline->crack.emplace_back(third);
  const GrowthReport report = grow_cracks(three);
  const auto note = std::ranges::find(report.notes, "growth.merges", &Note::code);
  ASSERT_NE(note, report.notes.end()) << report.sentence;
  EXPECT_NE(note->text.find("whose stiffness is not known, because another crack is near"),
            std::string::npos)
      << note->text;
}

// Kind: behaviour (CG-9).  Cracks that come near each other in two lines do not become a straight
// crack, so the growth ends, and a note names both.
TEST(UnlikeGrowth, BehaviourTheEndWhereCracksOfTwoLinesMeet) {
  GearSet pair = pair_in_line(2 * mm, 1.5 * mm, 4.1 * mm);
  std::get<WallThroughCrack>(pair.flexspline->crack[0]).distance = 80 * mm;
  std::get<WallThroughCrack>(pair.flexspline->crack[1]).distance = 80.3 * mm;
  const GrowthReport report = grow_cracks(pair);
  ASSERT_EQ(report.end, DriveEnd::range) << report.sentence;
  EXPECT_EQ(test::count_notes(report.notes, "growth.merges"), 0);
  const auto note = std::ranges::find(report.notes, "growth.refused_size", &Note::code);
  ASSERT_NE(note, report.notes.end());
  EXPECT_NE(note->text.find("flexspline.crack[1]: the gap to flexspline.crack[0] is less than 0.2"),
            std::string::npos)
      << note->text;
  EXPECT_EQ(note->path, "flexspline.crack[1]");
}

// Kind: cross-check (CG-15).  The lives of a study take the influence of a pair from a table, and
// `grow` solves each pair.  The sizes and times agree, also where the cracks are about to meet.
// Tolerance: 1e-6, ten times that of the table, because the rate has the third power of K; the
// steps of both are the same.
TEST(UnlikeGrowth, CrosscheckOfTheTableOfPairs) {
  const GearSet gear = pair_in_line(2 * mm, 1.5 * mm, 6 * mm);
  const GrowthOptions options =
      test::kSanitized ? test::until_size("flexspline.crack[0]", 2.05 * mm) : GrowthOptions{};
  const GrowthReport solved = grow_cracks(gear, options);
  const LifeTrace tabulated = life_trace(gear, options);
  ASSERT_EQ(tabulated.end, solved.end);
  EXPECT_EQ(tabulated.governing, solved.governing);
  test::expect_relative(tabulated.time, solved.time, 1e-6);
  for (const std::size_t k : {0U, 1U})
    test::expect_relative(tabulated.sizes[k].back(), solved.cracks[k].series.back().size, 1e-6);
  // Lives of other sizes in between do not change the answer by a bit.
  (void)life_trace(pair_in_line(2.02 * mm, 1.4 * mm, 6 * mm),
                   test::until_size("flexspline.crack[0]", 2.05 * mm));
  EXPECT_EQ(life_trace(gear, options).time, tabulated.time);
}

// Kind: behaviour.  Cracks without places grow without each other, and a note says so; the ligament
// of a pair is named as what it is.
TEST(UnlikeGrowth, BehaviourWhatIsLeftOut) {
  GearSet pair = pair_in_line(2 * mm, 1.5 * mm, 5 * mm);
  const GrowthOptions options = test::until_size("flexspline.crack[0]", 2.02 * mm);
  const GrowthReport near = grow_cracks(pair, options);
  EXPECT_EQ(test::count_notes(near.notes, "growth.superposed"), 0);
  const auto ligament = std::ranges::find(near.notes, "growth.unknown_stress", &Note::code);
  ASSERT_NE(ligament, near.notes.end());
  EXPECT_NE(ligament->text.find("the growth leaves out what is not known of the crack: the "
                                "ligament to flexspline.crack[1] is narrower than the longer half "
                                "length"),
            std::string::npos)
      << ligament->text;
  for (auto& any : pair.flexspline->crack) std::get<WallThroughCrack>(any).position.reset();
  std::get<WallThroughCrack>(pair.flexspline->crack[0]).distance = 40 * mm;
  EXPECT_EQ(test::count_notes(grow_cracks(pair, options).notes, "growth.superposed"), 1);
}

/// Two equal annular cracks of a solid shaft, and without their places.
GearSet annular_pair(double depth, std::optional<double> apart) {
  GearSet gear = test::unbreakable_shaft();
  gear.output_shaft->crack = {AnnularCrack{}, AnnularCrack{}};
  double place = gear.output_shaft->length / 2;
  for (auto& any : gear.output_shaft->crack) {
    auto& crack = std::get<AnnularCrack>(any);
    crack.depth = depth;
    if (apart) crack.distance = place;
    place += apart.value_or(0.0);
  }
  return gear;
}

// Kind: reference (CG-12), (GR-24).  Two equal annular cracks grow alike, so the time up to a depth
// is an integral over the depth with K alone times the factor of (CG-12).  Tolerance: 3e-4, the
// error of the path.
TEST(UnlikeGrowth, ReferenceTwoEqualAnnularCracks) {
  const double begin = 2 * mm;
  const double end = 2.3 * mm;
  const double apart = 1 * mm;
  const GearSet placed = annular_pair(begin, apart);
  const GearSet far = annular_pair(begin, std::nullopt);
  GrowthOptions options = test::until_size("output_shaft.crack[0]", end);
  options.tolerance = 1e-6;
  const GrowthReport with = grow_cracks(placed, options);
  const GrowthReport without = grow_cracks(far, options);
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;
  const double diameter = placed.output_shaft->outer_diameter;
  const auto time = [&](bool together) {
    return Quadrature::integrate(
        [&](double a) {
          const sif::AnnularCrackSolid alone{.depth = a, .diameter = diameter};
          const double factor =
              together ? annular_group(std::vector<PlacedAnnularCrack>{{0, a}, {apart, a}},
                                       {diameter / 2, 0})
                             .cracks[0]
                             .factor
                       : 1.0;
          return std::pow(factor * alone.stress_intensity(a, 0).III[1], -3.0);
        },
        begin, end);
  };
  test::expect_relative(with.time / without.time, time(true) / time(false), 3e-4);
  EXPECT_GT(with.time, 1.5 * without.time);
  EXPECT_EQ(with.stiffness.front().positive, torsional_stiffness(placed).positive.stiffness.value);
  EXPECT_EQ(without.stiffness.front().positive, torsional_stiffness(far).positive.stiffness.value);
  EXPECT_GT(with.stiffness.back().change, without.stiffness.back().change);
  ASSERT_EQ(test::count_notes(with.notes, "growth.shielding"), 1);
  EXPECT_EQ(test::count_notes(without.notes, "growth.shielding"), 0);
}

// Kind: behaviour (CG-12).  Equal cracks shield each other only while they stay equal: a neighbour
// that is 0.1 mm shallower takes half of the life, and the life of a crack alone is the lower
// bound. The numbers are those that the chapter states.
TEST(UnlikeGrowth, BehaviourEqualAnnularCracksAreTheBestCase) {
  GrowthOptions options = test::until_size("output_shaft.crack[0]", 12 * mm);
  options.tolerance = 1e-4;
  const auto life = [&](double neighbour, std::optional<double> apart) {
    GearSet gear = annular_pair(6 * mm, apart);
    std::get<AnnularCrack>(gear.output_shaft->crack[1]).depth = neighbour;
    return grow_cracks(gear, options).time;
  };
  const double alone = life(6 * mm, std::nullopt);
  EXPECT_NEAR(life(6 * mm, 0.6 * mm) / alone, 2.3, 0.1);
  EXPECT_NEAR(life(5.9 * mm, 0.6 * mm) / alone, 1.2, 0.05);
  EXPECT_EQ(life(6 * mm, 0.25 * mm), alone);  // nearer than 0.05 of the deeper one
}

// Kind: behaviour (CG-12).  Of two unequal annular cracks the deeper one grows nearly as alone,
// and the shallow one behind it hardly grows.  Tolerance: what the shallow one shields.
TEST(UnlikeGrowth, BehaviourADeepAnnularCrackShieldsAShallowOne) {
  GearSet pair = annular_pair(3 * mm, 1 * mm);
  std::get<AnnularCrack>(pair.output_shaft->crack[1]).depth = 1 * mm;
  GearSet alone = pair;
  alone.output_shaft->crack.pop_back();
  GrowthOptions options = test::until_size("output_shaft.crack[0]", 3.2 * mm);
  options.tolerance = 1e-6;
  const GrowthReport together = grow_cracks(pair, options);
  test::expect_relative(together.time, grow_cracks(alone, options).time, 0.02);
  EXPECT_LT(together.cracks.at(1).series.back().size, 1.01 * mm);
}

}  // namespace
}  // namespace strainwave

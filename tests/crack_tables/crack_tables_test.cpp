// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_tables/crack_tables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::mm;

/// A drive and how its numbers vary from row to row.
struct Case {
  std::string name;
  GearSet gear;
  std::function<void(GearSet&, test::Dice&)> vary;
};

GearSet with_wall_crack(const FlexsplineCrack& crack) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  gear.flexspline->crack = {crack};
  return gear;
}

GearSet with_shaft_crack(const OutputShaftCrack& crack, double bore) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.flexspline->crack.clear();
  gear.output_shaft->inner_diameter = bore;
  gear.output_shaft->crack = {crack};
  return gear;
}

GearSet with_race_crack(const WaveGeneratorCrack& crack) {
  GearSet gear = test::article_gear();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  gear.wave_generator->crack = {crack};
  return gear;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"article", test::article_gear(), [](GearSet& g, test::Dice& dice) {
                   auto& race = std::get<RaceSurfaceCrack>(g.wave_generator->crack[0]);
                   race.depth = dice.uniform(0.05, 0.09) * mm;
                   auto& wall = std::get<WallThroughCrack>(g.flexspline->crack[0]);
                   wall.half_length = dice.uniform(0.5, 0.9) * mm;
                   std::get<AnnularCrack>(g.output_shaft->crack[0]).depth = dice.uniform(1, 2) * mm;
                   g.material.at("steel").youngs_modulus = dice.uniform(190e9, 220e9);
                   g.material.at("steel").shear_modulus = dice.uniform(75e9, 85e9);
                 }});
  WallThroughCrack through;
  through.half_length = 1 * mm;
  through.angle = pi / 4;
  all.push_back(
      {"through: length, wall, angle", with_wall_crack(through), [](GearSet& g, test::Dice& dice) {
         auto& crack = std::get<WallThroughCrack>(g.flexspline->crack[0]);
         crack.half_length = dice.uniform(0.9, 1.1) * mm;
         crack.angle = dice.uniform(0.05, 0.15);
         *g.flexspline->wall_thickness = dice.uniform(2.2, 2.3) * mm;
       }});
  all.push_back(
      {"through: Poisson's ratio", with_wall_crack(through), [](GearSet& g, test::Dice& dice) {
         g.material.at("steel").poissons_ratio = dice.uniform(0.25, 0.35);
         g.material.at("steel").shear_modulus.reset();
         g.flexspline->stress_nonuniformity = dice.uniform(1, 1.3);
       }});
  WallThroughCrack row = through;
  row.count = 60;
  all.push_back({"through: row", with_wall_crack(row), [](GearSet& g, test::Dice& dice) {
                   auto& crack = std::get<WallThroughCrack>(g.flexspline->crack[0]);
                   crack.half_length = dice.uniform(2.5, 3.5) * mm;
                   crack.angle = dice.uniform(0.75, 0.85);
                 }});
  // A crack and its mirror image share a table, which contains the ends of the angle too.
  all.push_back({"through: any angle", with_wall_crack(through), [](GearSet& g, test::Dice& dice) {
                   std::get<WallThroughCrack>(g.flexspline->crack[0]).angle =
                       dice.uniform(-1.57, 1.57);
                 }});
  // Pressed faces at 45 degrees to the shear have no K: their compliance becomes 0 there.
  all.push_back(
      {"through: about 45 degrees", with_wall_crack(through), [](GearSet& g, test::Dice& dice) {
         std::get<WallThroughCrack>(g.flexspline->crack[0]).angle =
             pi / 4 + dice.uniform(-1e-3, 1e-3);
       }});
  all.push_back(
      {"through: row and its mirror image", with_wall_crack(row), [](GearSet& g, test::Dice& dice) {
         std::get<WallThroughCrack>(g.flexspline->crack[0]).angle = dice.uniform(-0.2, 0.2);
       }});
  WallThroughCrack in_line = row;
  in_line.angle = pi / 2;
  all.push_back(
      {"through: row in one line", with_wall_crack(in_line), [](GearSet& g, test::Dice& dice) {
         std::get<WallThroughCrack>(g.flexspline->crack[0]).half_length =
             dice.uniform(3.2, 3.4) * mm;  // the cracks would touch at 4.13 mm, in the same box
       }});
  WallSurfaceCrack surface;
  surface.depth = 0.5 * mm;
  surface.half_length = 1 * mm;
  surface.angle = 0.6;
  surface.count = 3;
  all.push_back(
      {"surface: both senses", with_wall_crack(surface), [](GearSet& g, test::Dice& dice) {
         auto& crack = std::get<WallSurfaceCrack>(g.flexspline->crack[0]);
         crack.depth = dice.uniform(0.4, 0.6) * mm;
         crack.half_length = crack.depth / dice.uniform(0.6, 0.9);
         crack.angle = dice.uniform(-0.7, 0.7);
         g.load.axial_force = dice.uniform(-50, 50);
       }});
  RaceSurfaceCrack race;
  race.depth = 0.5 * mm;
  race.aspect_ratio = 0.6;
  GearSet ring = with_race_crack(race);
  ring.wave_generator->inner_ring_width = 12 * mm;
  ring.wave_generator->inner_ring_mean_radius = 40 * mm;
  std::get<RaceSurfaceCrack>(ring.wave_generator->crack[0]).stress_driver =
      StressDriver::ring_bending;
  all.push_back({"race: bending and width", ring, [](GearSet& g, test::Dice& dice) {
                   auto& crack = std::get<RaceSurfaceCrack>(g.wave_generator->crack[0]);
                   crack.depth = dice.uniform(1.0, 1.5) * mm;
                   crack.aspect_ratio = dice.uniform(0.6, 0.8);
                 }});
  RaceEdgeCrack edge;
  edge.depth = 1 * mm;
  GearSet edged = ring;
  edge.stress_driver = StressDriver::ring_bending;
  edged.wave_generator->crack = {edge};
  all.push_back({"edge", edged, [](GearSet& g, test::Dice& dice) {
                   std::get<RaceEdgeCrack>(g.wave_generator->crack[0]).depth =
                       dice.uniform(0.1, 8) * mm;
                   *g.wave_generator->inner_ring_width = dice.uniform(10, 13) * mm;
                 }});
  AnnularCrack annular;
  annular.depth = 3 * mm;
  all.push_back({"annular, solid", with_shaft_crack(annular, 0), [](GearSet& g, test::Dice& dice) {
                   std::get<AnnularCrack>(g.output_shaft->crack[0]).depth =
                       dice.uniform(0.5, 25) * mm;
                   g.output_shaft->outer_diameter = dice.uniform(60, 80) * mm;
                 }});
  all.push_back(
      {"annular, hollow", with_shaft_crack(annular, 45 * mm), [](GearSet& g, test::Dice& dice) {
         std::get<AnnularCrack>(g.output_shaft->crack[0]).depth = dice.uniform(2, 4) * mm;
         g.output_shaft->inner_diameter = dice.uniform(42, 46) * mm;
       }});
  ShaftSurfaceCrack one_sided;
  one_sided.depth = 4 * mm;
  one_sided.half_length = 6 * mm;
  all.push_back(
      {"one-sided, solid", with_shaft_crack(one_sided, 0), [](GearSet& g, test::Dice& dice) {
         auto& crack = std::get<ShaftSurfaceCrack>(g.output_shaft->crack[0]);
         crack.depth = dice.uniform(3, 6) * mm;
         crack.half_length = crack.depth * dice.uniform(1.1, 2);
       }});
  all.push_back(
      {"one-sided, hollow", with_shaft_crack(one_sided, 45 * mm), [](GearSet& g, test::Dice& dice) {
         auto& crack = std::get<ShaftSurfaceCrack>(g.output_shaft->crack[0]);
         crack.depth = dice.uniform(3, 6) * mm;
         crack.half_length = crack.depth * dice.uniform(1.1, 2);
         g.material.at("steel").youngs_modulus = dice.uniform(190e9, 220e9);
       }});
  return all;
}

/// The tables of a case for many rows.
CrackTables tables_of(const Case& of, std::size_t rows, GearSet& varied) {
  return CrackTables(rows, [&](std::size_t row) -> const GearSet* {
    test::Dice dice(row + 1);
    of.vary(varied, dice);
    return &varied;
  });
}

// Kind: cross-check (ST-21).  Source: the engine of the added compliance, ADR 0007.  Tolerance:
// 1e-10 of the compliance added by the cracks; the tables have 1e-11 and the engine's quadrature
// 1e-10, which it undercuts by far.
TEST(CrackTables, CrosscheckEveryKindWithTheEngine) {
  std::size_t number = 0;
  for (const Case& of : cases()) {
    if (test::kSanitized && ++number % 2 == 0) continue;
    GearSet varied = of.gear;
    const CrackTables tables = tables_of(of, 100'000'000, varied);
    ASSERT_GE(tables.tables(), 1U) << of.name;
    CrackTables::Reader reader(tables);
    for (std::uint64_t row = 1000; row < 1030; ++row) {
      test::Dice dice(row);
      of.vary(varied, dice);
      check(varied);
      const auto exact = series_compliance<double>(varied);
      const auto read = series_compliance(varied, reader);
      EXPECT_EQ(read.usable, exact.usable) << of.name;
      EXPECT_EQ(read.intact, exact.intact);
      test::expect_relative(read.positive_added, exact.positive_added, 1e-10);
      test::expect_relative(read.negative_added, exact.negative_added, 1e-10);
      test::expect_relative(read.positive, exact.positive, 1e-12);
      test::expect_relative(read.positive_in_line, exact.positive_in_line, 1e-10);
      if (HasFailure()) FAIL() << of.name << ", row " << row;
    }
    EXPECT_GT(tables.largest_error(), 0.0) << of.name << ": no table was read";
    EXPECT_LT(tables.largest_error(), 1e-11) << of.name;
  }
}

// Kind: behaviour.  Tables that several threads fill before a drive is read give the same bits as
// tables that are filled by what one thread asks.
TEST(CrackTables, BehaviourTablesFilledBeforeTheyAreRead) {
  constexpr std::size_t kRows = 10'000'000;
  std::size_t number = 0;
  for (const Case& of : cases()) {
    if (number++ % 4 != 0) continue;
    if (number > 1 && test::kSanitized) break;
    GearSet varied = of.gear;
    const CrackTables lazy = tables_of(of, kRows, varied);
    CrackTables filled = tables_of(of, kRows, varied);
    EXPECT_EQ(filled.largest_error(), 0.0);
    filled.fill(2, {});
    if (filled.tables() > 0) {
      EXPECT_GT(filled.largest_error(), 0.0) << of.name;
    }
    CrackTables::Reader by_demand(lazy);
    CrackTables::Reader reader(filled);
    for (std::size_t n = 0; n < CrackTables::kSamples; n += 16) {
      test::Dice dice(n * kRows / CrackTables::kSamples + 1);
      of.vary(varied, dice);
      EXPECT_EQ(series_compliance(varied, reader).positive,
                series_compliance(varied, by_demand).positive)
          << of.name << ", row " << n;
    }
  }
}

// Kind: behaviour.  A value that none of the sampled drives had is not in the tables; the engine
// answers, to the last bit.
TEST(CrackTables, BehaviourTheEngineAnswersForWhatIsNotInTheTables) {
  const Case article = cases()[0];
  GearSet varied = article.gear;
  const CrackTables tables = tables_of(article, 1'000'000, varied);
  CrackTables::Reader reader(tables);
  GearSet other = article.gear;
  other.material.at("steel").poissons_ratio = 0.31;
  std::get<RaceSurfaceCrack>(other.wave_generator->crack[0]).aspect_ratio = 0.6;
  other.output_shaft->inner_diameter = 46 * mm;
  EXPECT_EQ(series_compliance(other, reader).positive, series_compliance<double>(other).positive);
  // Switches of a solution count too.
  std::get<WallThroughCrack>(other.flexspline->crack[0]).shell_correction = false;
  EXPECT_EQ(series_compliance(other, reader).positive, series_compliance<double>(other).positive);
}

// Kind: behaviour.  Tables cost evaluations of the engine, so few rows get none.
TEST(CrackTables, BehaviourFewRowsHaveNoTables) {
  for (const Case& of : cases()) {
    GearSet varied = of.gear;
    EXPECT_EQ(tables_of(of, 30, varied).tables(), 0U) << of.name;
  }
}

// Kind: behaviour.  Rows that break a rule are left out of the sample; if all do, there are no
// tables and the engine answers.
TEST(CrackTables, BehaviourNoSampleNoTables) {
  const CrackTables tables(1'000'000, [](std::size_t) { return nullptr; });
  EXPECT_EQ(tables.tables(), 0U);
  CrackTables::Reader reader(tables);
  const GearSet gear = test::article_gear();
  EXPECT_EQ(series_compliance(gear, reader).positive, series_compliance<double>(gear).positive);
}

/// A crack that is oblique to the layers of its wall, so both modes of the sheet are coupled.
Case coupled_sheet() {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.output_shaft.reset();
  gear.article.reset();
  Material layer;
  layer.youngs_modulus = 181e9;
  layer.transverse_modulus = 10.3e9;
  layer.shear_modulus = 7.17e9;
  layer.poissons_ratio = 0.28;
  gear.material["layer"] = layer;
  for (const double angle : {0.4, -0.4, 0.4})
    gear.material["wall"].ply.push_back(
        {.material = "layer", .angle = angle, .thickness = 0.4 * mm});
  Flexspline& fs = *gear.flexspline;
  fs.shape = FlexsplineShape::cylinder;
  fs.crack_free = CrackFree::sections;
  fs.length.reset();
  fs.wall_thickness.reset();
  gear.drive.pitch_diameter = 122 * mm;
  gear.drive.radial_displacement = gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  fs.barrel = TubeSection{.outer_diameter = 121.2 * mm,
                          .wall_thickness = 1.2 * mm,
                          .length = 90 * mm,
                          .material = "wall"};
  fs.rim = TubeSection{.outer_diameter = 122 * mm, .wall_thickness = 2 * mm, .length = 20 * mm};
  WallThroughCrack crack;
  crack.half_length = 1 * mm;
  crack.angle = 0.5;
  fs.crack = {crack};
  return {"through: laminate", gear, {}};
}

// Kind: cross-check (SN-10).  Source: central differences of fourth order of the engine.
// Tolerance: 1e-6 of the compliance added by the cracks; differences with a step of 1e-3 have an
// error of about 1e-8, and the quadrature adds 1e-10/1e-3.
TEST(CrackDerivatives, CrosscheckDifferencesOfEveryKind) {
  std::vector<Case> all = cases();
  all.push_back(coupled_sheet());
  std::size_t number = 0;
  for (const Case& of : all) {
    if (test::kSanitized && ++number % 3 != 0) continue;
    const GearSet& gear = of.gear;
    SeriesDerivatives derivatives(gear);
    GearSet varied = gear;
    std::vector<double*> numbers;
    for_each_number(varied, [&](const FieldPath&, const Field&, double& x) {
      if (x != 0) numbers.push_back(&x);
    });
    std::vector<const double*> inputs;
    std::vector<std::string> paths;
    for_each_number(gear, [&](const FieldPath& path, const Field&, const double& x) {
      if (x == 0) return;
      inputs.push_back(&x);
      paths.push_back(path.text());
    });
    const double scale = series_compliance<double>(gear).positive_added;
    // At 90 degrees any change of the angle opens or presses the faces under torque.
    const bool kink = of.name == "through: row in one line";
    int act = 0;
    for (std::size_t n = 0; n < inputs.size(); ++n) {
      if (kink && paths[n].ends_with(".angle")) continue;
      const auto dual = derivatives.of(Lift<DualReal>({&inputs[n], 1}));
      EXPECT_TRUE(dual.usable) << of.name;
      const double x = *inputs[n];
      const auto at = [&](double steps) {
        *numbers[n] = x * (1 + 1e-3 * steps);
        const auto series = series_compliance<double>(varied);
        *numbers[n] = x;
        return std::array{series.positive_added, series.negative_added};
      };
      const auto far_ahead = at(2);
      const auto ahead = at(1);
      const auto behind = at(-1);
      const auto far_behind = at(-2);
      const auto difference = [&](std::size_t i) {
        return (8 * (ahead[i] - behind[i]) - (far_ahead[i] - far_behind[i])) / (12 * 1e-3);
      };
      EXPECT_NEAR(dual.positive_added.partial[0], difference(0), 1e-6 * scale)
          << of.name << ": " << paths[n];
      EXPECT_NEAR(dual.negative_added.partial[0], difference(1), 1e-6 * scale)
          << of.name << ": " << paths[n];
      act += std::abs(difference(0)) > 1e-3 * scale;
    }
    EXPECT_GE(act, 3) << of.name;  // a size of the crack, one of its member, and a modulus
    test::expect_relative(derivatives.of(Lift<DualReal>({inputs.data(), 0})).positive_added.value,
                          scale, 1e-10);
  }
}

// Kind: identity (SN-10).  The derivatives with respect to eight inputs are those with respect to
// each of them, to the last bit, and a second lift gives the same numbers as the first.
TEST(CrackDerivatives, IdentityAnyNumberOfInputs) {
  const GearSet gear = test::article_gear();
  const auto& wall = std::get<WallThroughCrack>(gear.flexspline->crack[0]);
  const std::array<const double*, 3> inputs = {&wall.half_length, &wall.angle,
                                               &*gear.flexspline->wall_thickness};
  SeriesDerivatives derivatives(gear);
  const auto all = derivatives.of(Lift<DualReal>(inputs));
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto one = derivatives.of(Lift<DualReal>({&inputs[k], 1}));
    EXPECT_EQ(one.positive.partial[0], all.positive.partial[k]);
    EXPECT_EQ(one.negative.partial[0], all.negative.partial[k]);
    const auto alone = series_compliance(gear, Lift<DualReal>({&inputs[k], 1}));
    EXPECT_EQ(alone.positive.partial[0], all.positive.partial[k]);
  }
}

}  // namespace
}  // namespace strainwave

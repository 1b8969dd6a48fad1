// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turn_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/turn_table.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Modes3 = std::array<double, 3>;

test::TurnGrid turn_grid() {
  return {.sizes = {1e-3, 2e-3, 4e-3, 10e-3}, .torques = {-100, 0, 300}, .stations = {-1, 1}};
}

/// Over sqrt(pi a): a cubic in ln a, linear in the torque on both sides of 0.
Modes3 made_up_turn(double a, double T, std::size_t s, double theta) {
  const double x = std::log(a / 2e-3);
  const double root = std::sqrt(pi * a) * (1 + 0.3 * x - 0.1 * x * x + 0.02 * x * x * x);
  const double opened = T > 0 ? 2e5 * T : 1e5 * T;
  return {root * (opened + 3e7 * std::cos(2 * theta)), root * 1e7 * std::sin(2 * theta),
          root * 1e6 * static_cast<double>(s)};
}

TurnTable made_up_table_of_turn() {
  return test::turn_table_of(turn_grid(), "half_length",
                             [](double a, double, double T, std::size_t s, double theta) {
                               return made_up_turn(a, T, s, theta);
                             });
}

// (GR-31) Kind: exact.  K_I = 3 + 2 cos 2 theta at one face, and 1 + 4 cos 2 theta at the other:
// pressed faces count as 0, so the second has the larger range, 5, and R = 0.
TEST(TurnTable, ReferenceRangeOverATurn) {
  const TurnTable table =
      test::turn_table_of({.sizes = {2e-3}, .torques = {100}, .stations = {-1, 1}}, "half_length",
                          [](double, double, double, std::size_t s, double theta) {
                            const double wave = std::cos(2 * theta);
                            return Modes3{1e6 * (s == 0 ? 3 + 2 * wave : 1 + 4 * wave), 0, 0};
                          });
  const TurnRange turn = turn_range(table, 2e-3, 1.0, 100);
  EXPECT_NEAR(turn.largest, 5e6, 1e-3);
  EXPECT_EQ(turn.least, 0);
  EXPECT_NEAR(turn.range, 5e6, 1e-3);
  EXPECT_EQ(turn.ratio, 0);
  EXPECT_EQ(turn.at_largest, 0);
  EXPECT_NEAR(turn.open_share, 13.0 / 24, 1e-12);  // cos 2 theta > -1/4
  EXPECT_THROW((void)turn_range(table, 2e-3, 1.0, -100), InputError);
}

TEST(TurnTable, IdentityCubicOverTheSizeLinearOverTheTorque) {  // GR-30, FE-41
  // The interpolation reproduces what it assumes.
  const TurnTable table = made_up_table_of_turn();
  for (const double a : {1e-3, 1.7e-3, 3e-3, 9.9e-3})
    for (const double T : {-100.0, -40.0, 0.0, 123.0, 300.0}) {
      const TurnFactors factors(table, a, 1.0);
      ASSERT_EQ(factors.stations(), 2U);
      for (std::size_t s = 0; s < 2; ++s) {
        const auto turn = factors.at(s, T);
        ASSERT_EQ(turn.size(), table.angles.size() - 1);
        for (std::size_t k = 0; k < turn.size(); ++k) {
          const Modes3 exact = made_up_turn(a, T, s, table.angles[k]);
          for (std::size_t mode = 0; mode < 3; ++mode)
            EXPECT_NEAR(turn[k][mode], exact[mode], 1e-8 * 1e6);
        }
      }
    }
}

TEST(TurnTable, LimitBeyondTheSizes) {  // GR-30
  // K/sqrt(pi a) of the nearest size counts, and with one size everywhere.
  const TurnTable table = made_up_table_of_turn();
  const double at_end = TurnFactors(table, 10e-3, 1.0).at(0, 50)[3][0];
  test::expect_relative(TurnFactors(table, 40e-3, 1.0).at(0, 50)[3][0], 2 * at_end, 1e-12);
  const double at_begin = TurnFactors(table, 1e-3, 1.0).at(0, 50)[3][0];
  test::expect_relative(TurnFactors(table, 0.25e-3, 1.0).at(0, 50)[3][0], at_begin / 2, 1e-12);
  test::TurnGrid one = turn_grid();
  one.sizes = {2e-3};
  const TurnTable single = test::turn_table_of(
      one, "half_length", [](double a, double, double T, std::size_t s, double theta) {
        return made_up_turn(a, T, s, theta);
      });
  test::expect_relative(TurnFactors(single, 8e-3, 1.0).at(1, 50)[5][0],
                        2 * made_up_turn(2e-3, 50, 1, single.angles[5])[0], 1e-12);
}

TEST(TurnTable, IdentityShapes) {  // GR-30
  test::TurnGrid grid = turn_grid();
  grid.aspect_ratios = {0.2, 0.5, 1.0};
  grid.stations = {0, 1};
  const TurnTable table = test::turn_table_of(
      grid, "depth", [](double a, double shape, double T, std::size_t s, double theta) {
        Modes3 K = made_up_turn(a, T, s, theta);
        for (double& mode : K) mode *= 2 + std::log(shape);
        return K;
      });
  for (const double shape : {0.2, 0.33, 0.8, 1.0})
    test::expect_relative(TurnFactors(table, 3e-3, shape).at(1, 200)[7][0],
                          (2 + std::log(shape)) * made_up_turn(3e-3, 200, 1, table.angles[7])[0],
                          1e-12);
}

TEST(TurnTable, BehaviourLoadsAndWaves) {
  const TurnTable table = made_up_table_of_turn();
  EXPECT_TRUE(table.covers(-100));
  EXPECT_FALSE(table.covers(-101));
  // Rounding carries no torque beyond the table, and K stays that of the end.
  for (const double end : {-100.0, 300.0}) {
    EXPECT_TRUE(table.covers(end * (1 + 1e-10)));
    EXPECT_FALSE(table.covers(end * (1 + 1e-8)));
    EXPECT_EQ(TurnFactors(table, 2e-3, 1.0).at(0, end * (1 + 1e-10)),
              TurnFactors(table, 2e-3, 1.0).at(0, end));
  }
  EXPECT_THROW((void)TurnFactors(table, 2e-3, 1.0).at(0, 301), InputError);
  EXPECT_EQ(turn_load_range(table, 150), (std::array<double, 2>{0.0, 2.0}));
  EXPECT_EQ(turn_load_range(table, -50), (std::array<double, 2>{0.0, 2.0}));
  EXPECT_EQ(waves_of(table, 2), 1);
  TurnTable whole = table;
  for (double& angle : whole.angles) angle *= 2;
  EXPECT_EQ(waves_of(whole, 2), 2);
  EXPECT_EQ(waves_of(whole, 1), 1);
  EXPECT_EQ(waves_of(whole, 3), 3);
  // A table of one torque, above 0.
  test::TurnGrid single = turn_grid();
  single.torques = {50};
  const TurnTable one = test::turn_table_of(
      single, "half_length", [](double a, double, double T, std::size_t s, double theta) {
        return made_up_turn(a, T, s, theta);
      });
  test::expect_relative(TurnFactors(one, 2e-3, 1.0).at(1, 50)[5][0],
                        made_up_turn(2e-3, 50, 1, one.angles[5])[0], 1e-12);
  EXPECT_EQ(turn_load_range(one, 200), (std::array<double, 2>{0.25, 0.25}));
}

TEST(TurnTable, InputRulesBrokenOnce) {
  const auto gear_of = [] {
    GearSet gear = test::article_gear();
    auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
    crack.half_length = 3e-3;
    test::give_turn_table<WallThroughCrack>(gear, made_up_table_of_turn());
    return gear;
  };
  EXPECT_NO_THROW(check(gear_of()));
  // A whole turn in place of a wave, and one size for cracks of all sizes.
  GearSet other = gear_of();
  TurnTable whole = made_up_table_of_turn();
  for (double& angle : whole.angles) angle *= 2;
  test::give_turn_table<WallThroughCrack>(other, whole);
  EXPECT_NO_THROW(check(other));
  test::TurnGrid one = turn_grid();
  one.sizes = {2e-3};
  test::give_turn_table<WallThroughCrack>(
      other, test::turn_table_of(one, "half_length",
                                 [](double a, double, double T, std::size_t s, double theta) {
                                   return made_up_turn(a, T, s, theta);
                                 }));
  EXPECT_NO_THROW(check(other));
  const auto refused = [&](const std::function<void(GearSet&, TurnTable&)>& change,
                           const std::string& words) {
    GearSet gear = gear_of();
    TurnTable table = *gear.turn_tables.at("turn.csv");
    change(gear, table);
    if (!gear.turn_tables.empty())
      gear.turn_tables["turn.csv"] = std::make_shared<const TurnTable>(std::move(table));
    try {
      check(gear);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_EQ(error.field(), "flexspline.crack[0].turn_table");
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused([](GearSet& gear, TurnTable&) { gear.turn_tables.clear(); }, "has not been read");
  refused([](GearSet&, TurnTable& table) { table.size_name = "depth"; },
          "has a column depth, but a crack of kind \"through\" needs the column half_length");
  refused(
      [](GearSet&, TurnTable& table) {
        table.aspect_ratios = {0.5, 1};
      },
      "has a column aspect_ratio, which a crack of kind \"through\" does not have");
  refused([](GearSet&, TurnTable& table) { table.stations.back() = 2; },
          "must have stations from -1 to 1 only");
  refused([](GearSet&, TurnTable& table) { table.stations.front() = -1.1; },
          "must have stations from -1 to 1 only");
  refused([](GearSet&, TurnTable& table) { table.angles.back() += 0.01; },
          "but must run over a wave of 180 deg or a turn of 360 deg");
  refused(
      [](GearSet& gear, TurnTable&) {
        std::get<WallThroughCrack>(gear.flexspline->crack.at(0)).half_length = 10.1e-3;
      },
      "covers 1 mm to 10 mm of half_length, but the drive has 10.1 mm");
  refused([](GearSet& gear, TurnTable&) { gear.load.axial_force = 1; },
          "is a table for torque alone, so load.axial_force must be 0");
  refused(
      [](GearSet& gear, TurnTable&) {
        gear.duty.emplace();
        gear.duty->block = {{.duration = 1, .output_speed = 1.0, .torque = 1, .axial_force = 2}};
      },
      "is a table for torque alone, so duty.block[0].axial_force must be 0");
}

// Every condition that a table states is broken once.  A difference below the tolerance is none.
TEST(TurnTable, InputAnotherDrive) {
  const GearSet good = [] {
    GearSet gear = test::article_gear();
    auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
    crack.half_length = 3e-3;
    Flexspline& wall = *gear.flexspline;
    wall.crack_free = CrackFree::sections;
    wall.rim = TubeSection{.outer_diameter = 0.16, .wall_thickness = 0.003, .length = 0.03};
    wall.barrel = TubeSection{.outer_diameter = 0.158, .wall_thickness = 0.002, .length = 0.1};
    wall.diaphragm = Diaphragm{
        .outer_diameter = 0.156, .inner_diameter = 0.08, .thickness = 0.003, .profile = {}};
    TurnTable table = made_up_table_of_turn();
    gear.wave_generator->cam.emplace();
    gear.wave_generator->cam->profile = CamProfile::two_arcs;
    gear.wave_generator->cam->arc_angle = pi / 6;
    table.conditions = turn_conditions(gear, "flexspline.crack[0]");
    test::give_turn_table<WallThroughCrack>(gear, std::move(table));
    return gear;
  }();
  EXPECT_NO_THROW(check(good));
  const auto refused = [&](const std::function<void(GearSet&, WallThroughCrack&)>& change,
                           const std::string& words) {
    GearSet gear = good;
    change(gear, std::get<WallThroughCrack>(gear.flexspline->crack.at(0)));
    try {
      check_turn_tables(gear);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_EQ(error.field(), "flexspline.crack[0].turn_table");
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused([](GearSet& gear, WallThroughCrack&) { gear.drive.wave_number = 3; },
          "but must run over a wave of 120 deg");
  refused([](GearSet& gear, WallThroughCrack&) { gear.drive.radial_displacement *= 1.02; },
          "\"turn.csv\" is for a drive with drive.radial_displacement = 0.8 mm, but this drive has "
          "0.816 mm; leave out turn_table, and compute a table for this drive by strainwave turn");
  refused([](GearSet& gear, WallThroughCrack&) { gear.wave_generator->cam->arc_angle = pi / 4; },
          "wave_generator.cam = two arcs of 30 deg, but this drive has two arcs of 45 deg");
  refused([](GearSet& gear, WallThroughCrack&) { gear.wave_generator->cam.reset(); },
          "but this drive has cosine with a flattening of 0");
  refused(
      [](GearSet& gear, WallThroughCrack&) { gear.wave_generator->cam_perimeter_excess = 1e-5; },
      "wave_generator.cam_perimeter_excess = 0 m");
  refused([](GearSet& gear, WallThroughCrack&) { gear.flexspline->barrel->wall_thickness *= 0.98; },
          "flexspline.barrel.wall_thickness = ");
  refused([](GearSet& gear, WallThroughCrack&) { gear.flexspline->diaphragm.reset(); },
          "flexspline.diaphragm = plate, but this drive has none");
  refused([](GearSet&, WallThroughCrack& crack) { crack.angle = 0.9; }, "crack.angle = 45 deg");
  refused([](GearSet&, WallThroughCrack& crack) { crack.section = WallSection::rim; },
          "crack.section = barrel, but this drive has rim");
  refused([](GearSet&, WallThroughCrack& crack) { crack.distance = 0.02; }, "crack.distance = ");
  // A table for a cup without a bottom, and for a profile, is not for this cup.
  const auto for_another = [&](const std::function<void(Flexspline&)>& change,
                               const std::string& words) {
    GearSet other = good;
    change(*other.flexspline);
    TurnTable table = *good.turn_tables.at("turn.csv");
    table.conditions = turn_conditions(other, "flexspline.crack[0]");
    GearSet gear = good;
    gear.turn_tables["turn.csv"] = std::make_shared<const TurnTable>(std::move(table));
    const std::string message = test::broken_rule([&] {
      check_turn_tables(gear);
      return 0;
    });
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  for_another([](Flexspline& wall) { wall.diaphragm.reset(); },
              "flexspline.diaphragm = none, but this drive has plate");
  for_another(
      [](Flexspline& wall) {
        wall.diaphragm->profile = {{0.05, 0.004}, {0.06, 0.003}};
      },
      "stations of flexspline.diaphragm.profile = 2, but this drive has 0");
  for_another([](Flexspline& wall) { wall.rim->length = 0.02; }, ".rim.length");
  GearSet near = good;
  near.drive.radial_displacement *= 1.009;
  EXPECT_NO_THROW(check_turn_tables(near));
  // A condition that the program does not know, and a number that is none.
  const auto with = [&](TurnCondition condition) {
    TurnTable table = *good.turn_tables.at("turn.csv");
    table.conditions.push_back(std::move(condition));
    GearSet gear = good;
    gear.turn_tables["turn.csv"] = std::make_shared<const TurnTable>(std::move(table));
    check_turn_tables(gear);
  };
  EXPECT_THROW(with({.name = "colour", .text = "blue"}), InputError);
  EXPECT_THROW(with({.name = "crack.angle", .text = "45 mm"}), InputError);
  EXPECT_NO_THROW(with({.name = "crack.angle", .text = "0.785398 rad"}));
}

TEST(TurnTable, InputSurfaceCracks) {
  GearSet gear = test::article_gear();
  gear.flexspline->crack = {WallSurfaceCrack{.depth = 2e-3, .half_length = 4e-3}};
  test::TurnGrid grid = turn_grid();
  grid.stations = {0, 1};
  grid.aspect_ratios = {0.4, 0.6};
  const auto give = [&] {
    test::give_turn_table<WallSurfaceCrack>(
        gear, test::turn_table_of(grid, "depth",
                                  [](double a, double, double T, std::size_t s, double theta) {
                                    return made_up_turn(a, T, s, theta);
                                  }));
  };
  const auto refused = [&](const std::string& words) {
    give();
    try {
      check(gear);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  give();
  EXPECT_NO_THROW(check(gear));
  grid.stations = {0, 0.9};
  refused("must have the stations 0, at the surface, and 1, at the deepest point");
  grid.stations = {0.1, 1};
  refused("must have the stations 0, at the surface, and 1, at the deepest point");
  grid.stations = {0, 1};
  grid.aspect_ratios = {0.1, 0.4};
  refused("covers 0.1 to 0.4 of depth/half_length, but the drive has 0.5");
}

}  // namespace
}  // namespace strainwave

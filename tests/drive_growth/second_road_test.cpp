// SPDX-License-Identifier: Apache-2.0
// Growth beside the independent program tools/reference/crack_growth.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/growth/constant_amplitude.hpp"
#include "strainwave/growth/rainflow.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The rows of a case, by size; 0 where no size applies.
std::map<double, test::CsvRow> rows_of(const std::string& name) {
  std::map<double, test::CsvRow> rows;
  for (const test::CsvRow& row : test::read_reference_csv("crack_growth"))
    if (row.quantity == name) {
      const auto size = row.inputs.find("size");
      rows[size == row.inputs.end() ? 0.0 : size->second] = row;
    }
  return rows;
}

double value_of(const std::string& name) { return rows_of(name).at(0.0).value; }

/// Case P1: surface crack in a wide plate of 10 mm, from a = c = 1 mm to a = 8 mm.
void expect_plate_crack(const std::string& name, bool bending) {
  const Paris law{6.9e-12, 3};
  const auto rate = [&](double a, double c, double phi) {
    const sif::NewmanRajuPlate plate(a / c);
    const double factor =
        plate.tension(a / 10e-3, phi) * (bending ? plate.bending_ratio(a / 10e-3, phi) : 1.0);
    return growth_rate(law, {.largest = 200e6 * std::sqrt(pi * a) * factor}, a).per_cycle;
  };
  // Runge and Kutta's method of order 4 in the depth: the step leaves 1e-9.
  constexpr int kSteps = 8000;
  const double h = 7e-3 / kSteps;
  double c = 1e-3;
  double N = 0.0;
  const auto slopes = [&](double a, double length) {
    const double deep = rate(a, std::max(length, a), pi / 2);
    return std::array{rate(a, std::max(length, a), 0.0) / deep, 1 / deep};
  };
  for (int i = 0; i < kSteps; ++i) {
    const double a = 1e-3 + i * h;
    const auto k1 = slopes(a, c);
    const auto k2 = slopes(a + h / 2, c + h / 2 * k1[0]);
    const auto k3 = slopes(a + h / 2, c + h / 2 * k2[0]);
    const auto k4 = slopes(a + h, c + h * k3[0]);
    c += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0]);
    N += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1]);
  }
  test::expect_relative(N, value_of(name + ".cycles"), 1e-8);
  test::expect_relative(c, value_of(name + ".half_length"), 1e-8);
}

TEST(SecondRoad, ReferenceSurfaceCrackOfAPlate) {  // P1; GR-2, GR-23
  // 357 475.217 cycles and 10.2272122 mm in tension, 1 123 437.31 and 37.699888 mm in bending.
  // Tolerance: the steps of this test.
  expect_plate_crack("P1.tension", false);
  expect_plate_crack("P1.bending", true);
}

/// Shape factor of a crack in a plate of 50 mm.
double finite_plate(double a) {
  const double x = a / 50e-3;
  return (1 - x / 2 + 0.37 * x * x - 0.044 * x * x * x) / std::sqrt(1 - x);
}

/// Cycles of a history, from and to with their counts.
std::vector<CountedCycle> cycles_of(const std::vector<double>& history, Residue residue) {
  std::vector<CountedCycle> cycles;
  const auto sink = [&](const CountedCycle& cycle) { cycles.push_back(cycle); };
  RainflowCounter counter;
  counter.add(history, sink);
  counter.finish(residue, sink);
  return cycles;
}

TEST(SecondRoad, ReferenceBlocksOfAPublicProgram) {  // P2, P3; GR-1, GR-8, GR-9, GR-20
  // 21 246.565 blocks; easigrow's loop stops after 21 247.5.  139 377.838 cycles; its loop 139 380.
  const Nasgro law{.coefficient = 6.35e-10,
                   .exponent = 2.5,
                   .threshold_exponent = 1,
                   .instability_exponent = 1,
                   .toughness = 35.16e6,
                   .closure = {.constraint = 2, .stress_level = 0.3},
                   .form = NasgroThreshold::from_zero,
                   .threshold_datum = 0.8e6,
                   .slope_plus = 2.2,
                   .slope_minus = 2.2,
                   .intrinsic_size = 38.1e-6};
  const auto cycles = cycles_of({0, 1, 0.1, 0.8, 0.3, 0.9, 0.2, 0.6, 0}, Residue::repeated);
  const auto inverse = [&](double a) {
    const double K = 120e6 * finite_plate(a) * std::sqrt(pi * a);
    double sum = 0.0;
    for (const CountedCycle& cycle : cycles) {
      const double high = std::max(cycle.from.value, cycle.to.value);
      const double low = std::min(cycle.from.value, cycle.to.value);
      sum +=
          cycle.count * growth_rate(law, {.largest = K * high, .ratio = low / high}, a).per_cycle;
    }
    return 1 / sum;
  };
  const double blocks = integrate(inverse, 1e-3, 10e-3, {.relative_tolerance = 1e-11}).value;
  test::expect_relative(blocks, value_of("P2.blocks"), 1e-9);
  EXPECT_NEAR(blocks, 21247.5, 1.5);
  const auto growth = grow_at_constant_amplitude(
      Paris{6.9e-12, 3},
      [](double a) { return TipCycle{.largest = 200e6 * finite_plate(a) * std::sqrt(pi * a)}; },
      1e-3, 10e-3);
  test::expect_relative(growth.cycles.value(), value_of("P3.cycles"), 1e-9);
}

TEST(SecondRoad, ReferenceSingleCyclesAndBlocks) {  // G3, G18; GR-1, GR-2, GR-12
  const Paris law{6.9e-12, 3};
  const auto loop = [&](const auto& grown) {
    double a = 1e-3;
    int cycles = 0;
    for (; a < 1e-2; ++cycles) a += grown(a);
    return cycles;
  };
  const auto K = [](double stress, double a) { return 1.12 * stress * std::sqrt(pi * a); };
  EXPECT_EQ(loop([&](double a) { return growth_rate(law, {.largest = K(200e6, a)}, a).per_cycle; }),
            value_of("G3.cycles"));
  const auto cycles = cycles_of({-2, 1, -3, 5, -1, 3, -4, 4, -2}, Residue::half_cycles);
  const auto block = [&](double a, bool tensile) {
    double sum = 0.0;
    for (const CountedCycle& cycle : cycles) {
      const double high = std::max(cycle.from.value, cycle.to.value);
      double low = std::min(cycle.from.value, cycle.to.value);
      if (tensile) low = std::max(low, 0.0);
      sum += cycle.count *
             growth_rate(law, {.largest = K(40e6 * high, a), .ratio = low / high}, a).per_cycle;
    }
    return sum;
  };
  EXPECT_EQ(loop([&](double a) { return block(a, false); }), value_of("G18.loop"));
  for (const bool tensile : {false, true}) {
    const double blocks = integrate([&](double a) { return 1 / block(a, tensile); }, 1e-3, 1e-2,
                                    {.relative_tolerance = 1e-12})
                              .value;
    test::expect_relative(blocks, value_of(tensile ? "G18.tensile_blocks" : "G18.blocks"), 1e-10);
  }
}

TEST(SecondRoad, ReferenceARateThatFallsToItsThreshold) {  // G8; GR-8, GR-9, GR-20
  // NASGRO with n 2, p 1, q 0 at R = 0 is C DK^2 (1 - DK_th/DK), where C has the factor
  // (1 - A_0)^2: 3 458 287.53159 cycles, at rest at 0.634386731 mm.
  Nasgro law{.coefficient = 1.0,
             .exponent = 2,
             .threshold_exponent = 1,
             .instability_exponent = 0,
             .toughness = 1e12,
             .closure = {.constraint = 2.5, .stress_level = 0.3},
             .form = NasgroThreshold::from_zero,
             .threshold_datum = 3e6};
  const double closed = 1 - law.closure.at_zero();
  law.coefficient = 1e-10 / (closed * closed);
  const auto at = [](double a) { return TipCycle{.largest = 1.12 * 60e6 * std::sqrt(pi * a)}; };
  test::expect_relative(grow_at_constant_amplitude(law, at, 1e-3, 1e-2).cycles.value(),
                        value_of("G8.cycles"), 1e-9);
  const double rest = value_of("G8.rest");
  EXPECT_EQ(growth_rate(law, at(rest * (1 - 1e-9)), rest).state, TipState::arrested);
  EXPECT_EQ(growth_rate(law, at(rest * (1 + 1e-9)), rest).state, TipState::grows);
}

// --- drives --------------------------------------------------------------------------------------

constexpr const char* kShaftCrack = "output_shaft.crack[0]";

/// The shaft of the script: torque and rotating bending in three blocks.
GearSet bent_shaft() {
  GearSet gear = test::unbreakable_shaft();
  gear.material.at("steel").growth = {Walker{6.9e-12, 3, 0.5}};
  constexpr double kRpm = pi / 30;
  gear.duty->block = {
      {.duration = 7.5, .output_speed = 20 * kRpm, .torque = 4000, .bending_moment = 700},
      {.duration = 3.75, .output_speed = -40 * kRpm, .torque = -1500, .bending_moment = 700},
      {.duration = 12, .output_speed = 10 * kRpm, .torque = 2600, .bending_moment = 700}};
  return gear;
}

TEST(SecondRoad, ReferenceShaftUnderTorqueAndRotatingBending) {  // GR-21 to GR-24
  // Torque +-, three blocks of 2.5, 2.5 and 2 turns; single waves by three points of the standard.
  // The script integrates over the size.  Tolerance: ten digits of the script, 1e-9 of each step
  // here.
  for (const auto& [depth, row] : rows_of("shaft.repetitions")) {
    const GrowthReport report = grow_cracks(bent_shaft(), test::until_size(kShaftCrack, depth));
    EXPECT_EQ(report.end, DriveEnd::until);
    test::expect_relative(report.repetitions, row.value, 2e-8);
    test::expect_relative(report.cracks[0].series.back().size, depth, 1e-10);
    EXPECT_LT(report.step_error, 1e-6);
  }
}

TEST(SecondRoad, ReferenceShaftAtRest) {  // GR-12, GR-22
  // A threshold of 20 MPa sqrt(m): the factor on the loads from which the crack of 0.5 mm grows,
  // and the size from which it grows under the given loads.
  GearSet gear = bent_shaft();
  gear.material.at("steel").growth_bounds = GrowthBounds{.threshold = 20e6,
                                                         .short_crack_size = 0,
                                                         .stress_ratio = {},
                                                         .from = {},
                                                         .to = {},
                                                         .environment = ""};
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::arrested);
  EXPECT_EQ(report.time, 0.0);
  const double factor = rows_of("shaft.factor_to_grow").begin()->second.value;
  test::expect_relative(report.cracks[0].factor_to_grow.value_or(0), factor, 1e-9);
  test::expect_relative(report.cracks[0].margin.value_or(0), factor, 1e-9);
  const double size = value_of("shaft.size_at_rest");
  AnnularCrack& crack = std::get<AnnularCrack>(gear.output_shaft->crack[0]);
  crack.depth = size * (1 - 1e-8);
  EXPECT_EQ(grow_cracks(gear).end, DriveEnd::arrested);
  crack.depth = size * (1 + 1e-8);
  EXPECT_EQ(grow_cracks(gear, test::until_size(kShaftCrack, 4e-3)).end, DriveEnd::until);
}

/// The shaft with a crack of 1 mm under torques from 0 to `low` twice and to `high` once, 15-5PH.
struct OverloadedShaft {
  GearSet gear = test::growing_shaft();
  GrowthOptions options;
};
OverloadedShaft overloaded_shaft(double low, double high, double until, InteractionRule rule) {
  OverloadedShaft made;
  Material& steel = made.gear.material.at("steel");
  steel.fracture_toughness.reset();
  steel.ultimate_strength.reset();
  std::get<AnnularCrack>(made.gear.output_shaft->crack[0]).depth = 1e-3;
  const auto block = [](double torque) {
    return DutyBlock{.duration = 1, .output_speed = 1.0, .torque = torque};
  };
  made.gear.duty->block = {block(0), block(low), block(0), block(low), block(0), block(high)};
  made.options = test::until_size(kShaftCrack, until);
  made.options.rate = {.mixed_mode = MixedMode::richard, .law = "15-5PH H900"};
  made.options.interaction = {.rule = rule, .zone_factor = 2.0};
  return made;
}

TEST(SecondRoad, ReferenceWillenborgCycleByCycle) {  // GR-19, GR-27
  // Torque 0 to 3000 twice and 0 to 6000 N*m once, 15-5PH, 1 to 1.01 mm; the script's loop changes
  // the size after each cycle, the path holds it over a repetition.
  const OverloadedShaft shaft = overloaded_shaft(3000, 6000, 1.01e-3, InteractionRule::willenborg);
  const GrowthReport report = grow_cracks(shaft.gear, shaft.options);
  EXPECT_EQ(report.end, DriveEnd::until);
  test::expect_relative(report.repetitions, rows_of("shaft.willenborg").at(1.01e-3).value, 2e-3);
}

TEST(SecondRoad, ReferenceHeldOpeningCycleByCycle) {  // GR-32, GR-27
  // Torque 0 to 7000 twice and 0 to 10 000 N*m once, 15-5PH, 1 to 1.05 mm, as above.
  const OverloadedShaft shaft = overloaded_shaft(7000, 10000, 1.05e-3, InteractionRule::closure);
  GrowthOptions alone = shaft.options;
  alone.interaction.rule = InteractionRule::none;
  const double unslowed = grow_cracks(shaft.gear, alone).repetitions;
  const GrowthReport report = grow_cracks(shaft.gear, shaft.options);
  EXPECT_EQ(report.end, DriveEnd::until);
  test::expect_relative(report.repetitions, rows_of("shaft.closure").at(1.05e-3).value, 2e-3);
  EXPECT_GT(report.repetitions, 1.1 * unslowed);
}

TEST(SecondRoad, ReferenceSurfaceCrackOfABentShaft) {  // FR-22, SB-7, GR-22, GR-34, GR-35
  // Turns and half length until three depths, beside the script's own K, integrated over the depth.
  // Tolerance: the steps of the growth.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/bent_shaft.toml");
  Material& steel = gear.material.at("steel");
  steel.fracture_toughness.reset();
  steel.yield_strength.reset();
  steel.ultimate_strength.reset();
  const auto lengths = rows_of("bent_shaft.half_length");
  int seen = 0;
  for (const auto& [depth, row] : rows_of("bent_shaft.turns")) {
    ++seen;
    const GrowthReport report = grow_cracks(gear, test::until_size("output_shaft.crack[0]", depth));
    EXPECT_EQ(report.end, DriveEnd::until);
    test::expect_relative(14 * report.repetitions, row.value, 1e-6);
    test::expect_relative(report.cracks[0].series.back().half_length, lengths.at(depth).value,
                          1e-6);
    EXPECT_NE(std::find(report.equations.begin(), report.equations.end(), "GR-34"),
              report.equations.end());
  }
  EXPECT_EQ(seen, 3);
}

TEST(SecondRoad,
     ReferenceSurfaceCrackUnderTorqueAndWave) {  // FA-12, FR-4, FR-10, SP-3, GR-21 to GR-24
  GearSet gear = test::cracked_wall(R"(
kind = "surface"
depth = "0.4 mm"
half_length = "0.7 mm"
angle = "60 deg")");
  gear.material.at("steel").growth = {Walker{6.9e-12, 3, 0.5}};
  // The step of the middle torque has a whole number of the 202 waves a turn, the others a half.
  gear.duty->block[0].duration = gear.duty->block[2].duration = 807.5 / 202;
  // The depth and the length are related, so the depth of the script ends the path.
  const auto depths = rows_of("wall.depth");
  for (const auto& [length, row] : rows_of("wall.repetitions")) {
    const GrowthReport report =
        grow_cracks(gear, test::until_size("flexspline.crack[0]", depths.at(length).value));
    EXPECT_EQ(report.end, DriveEnd::until);
    test::expect_relative(report.repetitions, row.value, 1e-7);
    test::expect_relative(report.cracks[0].series.back().half_length, length, 1e-7);
  }
}

}  // namespace
}  // namespace strainwave

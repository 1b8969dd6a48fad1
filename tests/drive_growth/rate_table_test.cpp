// SPDX-License-Identifier: Apache-2.0
// A law from a table in the file of a drive, and the temperatures for which a law is stated.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

/// The wall of growth_support.hpp with a table of three points of its Paris law, on line 7 to 10.
std::string wall_text(const std::string& ranges, const std::string& rates,
                      const std::string& ratio = "-1") {
  return R"(format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
[[material.steel.growth]]
kind = "tabulated"
[[material.steel.growth.curve]]
stress_ratio = )" +
         ratio + "\ndelta_K = " + ranges + "\nrate = " + rates + R"(
[drive]
ratio = 100
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "6000 N*m"
[flexspline]
material = "steel"
shape = "cylinder"
wall_thickness = "2.24 mm"
length = "160 mm"
[[flexspline.crack]]
kind = "through"
half_length = "4 mm"
angle = "45 deg"
[duty]
[[duty.block]]
duration = "4 s"
output_speed = "60 rpm"
torque = "6000 N*m"
)";
}

// Paris with C 6.9e-12 m and m 3: 1, 20 and 50 MPa sqrt(m).
constexpr const char* kRanges = R"(["1 MPa*m^0.5", "20 MPa*m^0.5", "50 MPa*m^0.5"])";
constexpr const char* kRates = R"(["6.9e-12 m", "5.52e-8 m", "8.625e-7 m"])";

GearSet wall_with_table() { return read_gear_set(wall_text(kRanges, kRates), "wall.toml"); }

const Note* note_of(const GrowthReport& report, const std::string& code) {
  const auto found = std::ranges::find(report.notes, code, &Note::code);
  return found == report.notes.end() ? nullptr : &*found;
}

TEST(RateTable, IdentityATableOfParisGrowsAsParis) {  // GR-36, GR-2
  const GearSet table = wall_with_table();
  GearSet paris = table;
  paris.material.at("steel").growth = {Paris{6.9e-12, 3}};
  const GrowthOptions options = test::until_size("flexspline.crack[0]", 8e-3);
  const GrowthReport by_table = grow_cracks(table, options);
  const GrowthReport by_paris = grow_cracks(paris, options);
  EXPECT_EQ(by_table.end, by_paris.end);
  // The table meets its points at 1e-15; the path is the same to its tolerance.
  test::expect_relative(by_table.repetitions, by_paris.repetitions, 1e-9);
  EXPECT_EQ(by_table.cracks[0].law, "tabulated");
  EXPECT_EQ(by_table.cracks[0].constants, "material steel of the file");
}

TEST(RateTable, LimitTheFirstPointIsTheThreshold) {  // GR-36, GR-12
  // The range of the wave is below 2000 MPa sqrt(m), so the crack rests; its margin is that of the
  // first point.
  const GearSet gear = read_gear_set(
      wall_text(R"(["2000 MPa*m^0.5", "3000 MPa*m^0.5"])", R"(["1e-9 m", "1e-8 m"])"), "wall.toml");
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::arrested);
  const double widest = report.cracks[0].series.front().delta_K;
  test::expect_relative(report.cracks[0].margin.value_or(0), 2000e6 / widest, 1e-12);
  // More torque does not start it, because the wave alone makes the range.
  EXPECT_FALSE(report.cracks[0].factor_to_grow.has_value());
  EXPECT_EQ(note_of(report, "growth.law_range"), nullptr);  // a crack at rest uses no rate
}

TEST(RateTable, BehaviourBeyondTheCurvesIsSaid) {  // GR-36
  const GrowthOptions options = test::until_size("flexspline.crack[0]", 5e-3);
  const GearSet inside = wall_with_table();
  const double R = grow_cracks(inside, options).cracks[0].series.front().ratio;
  EXPECT_LT(R, 0.0);
  const auto text_of = [&](const GearSet& gear) {
    const GrowthReport report = grow_cracks(gear, options);
    const Note* const note = note_of(report, "growth.law_range");
    return note == nullptr ? std::string() : note->text;
  };
  const std::string low = text_of(read_gear_set(wall_text(kRanges, kRates, "0.5"), "wall.toml"));
  EXPECT_NE(low.find("the table has curves for 0.5 to 0.5"), std::string::npos) << low;
  const std::string high = text_of(read_gear_set(
      wall_text(R"(["1 MPa*m^0.5", "2 MPa*m^0.5"])", R"(["6.9e-12 m", "5.52e-11 m"])"),
      "wall.toml"));
  EXPECT_NE(high.find("the last point of the table is at 2 MPa*m^0.5"), std::string::npos) << high;
}

TEST(RateTable, InputEachRuleNamesFileLineAndField) {
  const auto message = [](const std::string& ranges, const std::string& rates,
                          const std::string& ratio = "0.1") {
    return test::broken_rule(
        [&] { return read_gear_set(wall_text(ranges, rates, ratio), "wall.toml"); });
  };
  EXPECT_EQ(message(kRanges, kRates), "no error");
  const std::string table = "material.steel.growth[0].curve[0].";
  struct Case {
    std::string ranges, rates, ratio, place, problem;
  };
  const std::vector<Case> cases = {
      {R"(["1 MPa*m^0.5"])", kRates, "0.1",
       "wall.toml:9:11: " + table + "delta_K:", "must have at least two values"},
      {kRanges, R"(["1e-9 m", "2e-9 m"])", "0.1",
       "wall.toml:10:8: " + table + "rate:", "has 2 values, but delta_K has 3"},
      {R"(["1 MPa*m^0.5", "5 MPa*m^0.5", "5 MPa*m^0.5"])", kRates, "0.1",
       "wall.toml:9:42: " + table + "delta_K[2]:", "must be larger than the value before"},
      {kRanges, R"(["1e-9 m", "2e-9 m", "1.5e-9 m"])", "0.1",
       "wall.toml:10:29: " + table + "rate[2]:", "must be larger than the value before"},
      {R"(["0 MPa*m^0.5", "5 MPa*m^0.5", "6 MPa*m^0.5"])", kRates, "0.1",
       "wall.toml:9:12: " + table + "delta_K[0]", "> 0"},
      {kRanges, R"(["-1e-9 m", "2e-9 m", "3e-9 m"])", "0.1", "wall.toml:10:9: " + table + "rate[0]",
       "> 0"},
      {kRanges, kRates, "1", "wall.toml:8:16: " + table + "stress_ratio", "< 1"},
      {kRanges, R"([1e-9, "2e-9 m", "3e-9 m"])", "0.1",
       "wall.toml:10:9: " + table + "rate[0]:", "has no unit"},
      {kRanges, R"("1e-9 m")", "0.1", "wall.toml:10:8: " + table + "rate:", "is not a list"}};
  for (const Case& one : cases) {
    const std::string said = message(one.ranges, one.rates, one.ratio);
    EXPECT_TRUE(said.starts_with(one.place)) << said;
    EXPECT_NE(said.find(one.problem), std::string::npos) << said;
  }
  // A second curve at a smaller R, and a table without curves.
  std::string text = wall_text(kRanges, kRates, "0.1");
  const std::size_t drive = text.find("[drive]");
  const std::string curve = text.substr(text.find("[[material.steel.growth.curve]]"),
                                        drive - text.find("[[material.steel.growth.curve]]"));
  const std::string twice =
      test::broken_rule([&] { return read_gear_set(text.insert(drive, curve), "wall.toml"); });
  EXPECT_TRUE(twice.starts_with("wall.toml:12:16: material.steel.growth[0].curve[1].stress_ratio"))
      << twice;
  text = wall_text(kRanges, kRates, "0.1");
  text.erase(text.find(curve), curve.size());
  const std::string none = test::broken_rule([&] { return read_gear_set(text, "wall.toml"); });
  EXPECT_TRUE(none.starts_with("wall.toml:5:1: material.steel.growth[0].curve")) << none;
}

TEST(RateTable, BehaviourTemperatureOfABlock) {
  // The note names block, temperature and the constants; nothing else changes.
  GearSet gear = wall_with_table();
  const GrowthOptions options = test::until_size("flexspline.crack[0]", 5e-3);
  const GrowthReport cold = grow_cracks(gear, options);
  EXPECT_EQ(note_of(cold, "growth.temperature"), nullptr);
  gear.duty->block.push_back(gear.duty->block[0]);
  gear.duty->block[0].temperature = 300;
  gear.duty->block[1].temperature = 393;
  GrowthReport report = grow_cracks(gear, options);
  const Note* note = note_of(report, "growth.temperature");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->path, "duty.block[1].temperature");
  EXPECT_EQ(note->text,
            "the block is at 393 K, but the constants of crack growth, material steel of the file, "
            "state no temperature; the same holds for 1 other block");
  GrowthBounds bounds;
  bounds.temperature = {290, 310};
  gear.material.at("steel").growth_bounds = bounds;
  report = grow_cracks(gear, options);
  note = note_of(report, "growth.temperature");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->text,
            "the block is at 393 K, but the constants of crack growth, material steel of the file, "
            "are stated for 290 K to 310 K");
  bounds.temperature = {290, 400};
  gear.material.at("steel").growth_bounds = bounds;
  const GrowthReport within = grow_cracks(gear, options);
  EXPECT_EQ(note_of(within, "growth.temperature"), nullptr);
  EXPECT_EQ(within.life, report.life);
  EXPECT_EQ(within.time, report.time);
}

}  // namespace
}  // namespace strainwave

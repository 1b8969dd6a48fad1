// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/study/evaluate.hpp"
#include "support/article_gear.hpp"

namespace strainwave {
namespace {

const GearSet& gear() {
  static const GearSet kGear = test::article_gear();
  return kGear;
}

TEST(Variation, ReferenceTextIsReadWithUnitsAndSpacing) {
  const Variation v = parse_variation(gear(), "output_shaft.crack[0].depth=0.05 mm..8 mm:60:log");
  EXPECT_EQ(v.path, "output_shaft.crack[0].depth");
  EXPECT_DOUBLE_EQ(v.from, 5e-5);
  EXPECT_DOUBLE_EQ(v.to, 8e-3);
  EXPECT_EQ(v.n_points, 60);
  EXPECT_EQ(v.spacing, Spacing::logarithmic);
  EXPECT_EQ(v.value(0), v.from);
  EXPECT_EQ(v.value(59), v.to);
  EXPECT_NEAR(v.value(1) / v.value(0), v.value(59) / v.value(58), 1e-12);
  const Variation bare = parse_variation(gear(), "drive.ratio=50..100:3");
  EXPECT_EQ(bare.spacing, Spacing::linear);
  EXPECT_DOUBLE_EQ(bare.value(1), 75.0);
}

TEST(Variation, InputEveryFaultIsRefusedByName) {
  for (const char* const text :
       {"", "output_shaft.crack[0].depth", "output_shaft.crack[0].depth=",
        "output_shaft.crack[0].depth=1 mm..2 mm", "output_shaft.crack[0].depth=1 mm..2 mm:1",
        "output_shaft.crack[0].depth=1 mm..2 mm:100001", "output_shaft.crack[0].depth=1 mm..2 mm:x",
        "output_shaft.crack[0].depth=1 mm..1 mm:3", "output_shaft.crack[0].depth=1..2:3",
        "output_shaft.crack[0].depth=1 mm..2 N:3", "output_shaft.crack[0].depth=nan mm..2 mm:3",
        "output_shaft.crack[0].depth=0 mm..2 mm:3:log", "load.axial_force=-1 N..1 N:3:log",
        "output_shaft.crack[0].depth=1 mm..2 mm:3:cubic",
        "output_shaft.crack[9].depth=1 mm..2 mm:3", "output_shaft.crack[0].dept=1 mm..2 mm:3"})
    EXPECT_THROW((void)parse_variation(gear(), text), InputError) << text;
  try {
    (void)parse_variation(gear(), "output_shaft.crack[0].dept=1 mm..2 mm:3");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("output_shaft.crack[0].depth"), std::string::npos)
        << error.what();
  }
}

TEST(Sweep, CrosscheckEveryRowIsTheResultAtThatPoint) {
  for (const Method method : {Method::as_printed, Method::repaired, Method::corrected}) {
    const std::vector<Variation> two{
        parse_variation(gear(), "output_shaft.crack[0].depth=0.1 mm..2 mm:3"),
        parse_variation(gear(), "flexspline.length=100 mm..200 mm:2")};
    const SweepResult result = sweep(gear(), method, two);
    ASSERT_EQ(result.rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const SweepRow& row = result.rows[i];
      EXPECT_EQ(row.inputs[0], two[0].value(static_cast<int>(i / 2)));  // the first varies slowest
      EXPECT_EQ(row.inputs[1], two[1].value(static_cast<int>(i % 2)));
      GearSet at = gear();
      set_number(at, two[0].path, row.inputs[0]);
      set_number(at, two[1].path, row.inputs[1]);
      const double K = evaluate(at, method).positive.stiffness.value;
      bool found = false;
      for (std::size_t c = 0; c < result.outputs.size(); ++c)
        if (result.outputs[c].name == "cracked.positive.stiffness") {
          found = true;
          EXPECT_EQ(row.outputs[c]->value, K);
          EXPECT_EQ(result.outputs[c].unit, "N*m/rad");
        }
      EXPECT_TRUE(found);
    }
  }
}

TEST(Sweep, InputRefusedPointsStayWithTheirReason) {
  const std::vector<Variation> one{
      parse_variation(gear(), "output_shaft.crack[0].depth=9 mm..15 mm:3")};
  const SweepResult result = sweep(gear(), Method::corrected, one);
  EXPECT_TRUE(result.rows[0].usable());
  EXPECT_FALSE(result.rows[1].usable());  // 12 mm of 12.5 mm: outside the table, but computed
  EXPECT_FALSE(result.rows[1].outputs.empty());
  EXPECT_NE(result.rows[1].reason.find("a/t"), std::string::npos);
  EXPECT_FALSE(result.rows[2].usable());
  EXPECT_TRUE(result.rows[2].outputs.empty());
  EXPECT_NE(result.rows[2].reason.find("depth"), std::string::npos);
}

TEST(Sweep, InputAllRefusedNoneOrTooMany) {
  const auto vary = [](const char* text) { return parse_variation(gear(), text); };
  const std::vector<Variation> outside{vary("output_shaft.crack[0].depth=13 mm..15 mm:3")};
  EXPECT_THROW((void)sweep(gear(), Method::corrected, outside), InputError);
  EXPECT_THROW((void)sweep(gear(), Method::corrected, {}), InputError);
  const Variation depth = vary("output_shaft.crack[0].depth=1 mm..2 mm:3");
  const std::vector<Variation> same{depth, depth};
  EXPECT_THROW((void)sweep(gear(), Method::corrected, same), InputError);
  const std::vector<Variation> three{depth, vary("drive.ratio=50..100:2"),
                                     vary("flexspline.length=100 mm..200 mm:2")};
  EXPECT_THROW((void)sweep(gear(), Method::corrected, three), InputError);
}

TEST(Sweep, IdentityCsvAndJsonCarryTheSameTable) {
  const std::vector<Variation> one{
      parse_variation(gear(), "output_shaft.crack[0].depth=9 mm..15 mm:3")};
  const SweepResult result = sweep(gear(), Method::corrected, one);
  std::istringstream lines(sweep_csv(result));
  std::string header;
  std::getline(lines, header);
  EXPECT_EQ(header.rfind("output_shaft.crack[0].depth [m],", 0), 0U);
  EXPECT_NE(header.find("intact.stiffness [N*m/rad]"), std::string::npos);
  EXPECT_NE(header.find(",usable,reason"), std::string::npos);
  int n = 0;
  for (std::string line; std::getline(lines, line);) ++n;
  EXPECT_EQ(n, 3);
  const nlohmann::json json = nlohmann::json::parse(sweep_json(result));
  EXPECT_EQ(json.at("method"), "corrected");
  EXPECT_EQ(json.at("rows").size(), 3U);
  EXPECT_EQ(json.at("rows")[0].at("values").size(), json.at("columns").size());
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/layouts/sweep.hpp"
#include "strainwave/present/json.hpp"
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

TEST(Variation, InputMessagesNameOptionAndValue) {
  const auto fault = [](const char* text) -> std::string {
    try {
      (void)parse_variation(gear(), text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  };
  EXPECT_EQ(fault("output_shaft.crack[0].depth=0.1..2 mm:3"),
            "--vary output_shaft.crack[0].depth: \"0.1\" has no unit; it must be convertible to m");
  EXPECT_EQ(
      fault("output_shaft.crack[0].depth=0.1 mm..2 mm:2.5"),
      "--vary output_shaft.crack[0].depth: the number of points is \"2.5\"; it must be a whole "
      "number from 2 to 100000");
  EXPECT_EQ(fault("output_shaft.crack[0].depth=0.1 mm..2 mm:100001"),
            "--vary output_shaft.crack[0].depth: the number of points is 100001; it must be from 2 "
            "to 100000");
  EXPECT_EQ(fault("output_shaft.crack[0].depth=0.1 mm..2 mm"),
            "--vary output_shaft.crack[0].depth: \"0.1 mm..2 mm\" needs a number of points: "
            "FROM..TO:N");
  EXPECT_EQ(fault("output_shaft.crack[0].depth=0.1 mm-2 mm:3"),
            "--vary output_shaft.crack[0].depth: \"0.1 mm-2 mm\" must be FROM..TO, each with its "
            "unit");
  EXPECT_EQ(fault("drive.ratio=1...2:3"),  // may mean 1. to 2, or 1 to .2
            "--vary drive.ratio: \"1...2\" must be FROM..TO, each with its unit");
  EXPECT_EQ(fault("drive.ratio=0..2:3:log"),
            "--vary drive.ratio: the range reaches 0, but equal ratios (:log) never reach 0; "
            "begin at a number other than 0, or leave out :log for equal steps");
  EXPECT_EQ(
      fault("drive.ratio=1..2:3:cubic"),
      "--vary drive.ratio: has \"cubic\" after the number of points, where only \"log\" may stand");
  EXPECT_EQ(fault("output_shaft.crack[0].dept=1 mm..2 mm:3"),
            "--vary: output_shaft.crack[0].dept: is not a number of this drive; did you mean "
            "output_shaft.crack[0].depth?");
}

TEST(Variation, BehaviourDescendingAndNegativeRanges) {
  const Variation down = parse_variation(gear(), "drive.ratio = 100 .. 50 : 3");
  EXPECT_EQ(down.value(0), 100);
  EXPECT_EQ(down.value(1), 75);
  EXPECT_EQ(down.value(2), 50);
  const Variation negative = parse_variation(gear(), "load.torque=-1 N*m..-100 N*m:3:log");
  EXPECT_NEAR(negative.value(1), -10, 1e-14);
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
  const std::vector<Variation> many{vary("drive.ratio=50..100:1000"),
                                    vary("flexspline.length=100 mm..200 mm:101")};
  EXPECT_THROW((void)sweep(gear(), Method::corrected, many), InputError);
  for (const Variation& broken :
       {Variation{.path = "drive.ratio", .from = 1, .to = 1, .n_points = 3},
        Variation{.path = "drive.ratio", .from = 1, .to = std::nan(""), .n_points = 3},
        Variation{.path = "drive.ratio", .from = 1, .to = 2, .n_points = 1},
        Variation{.path = "drive.ratio",
        .from = -1,
        .to = 2,
        .n_points = 3,
        .spacing = Spacing::logarithmic},
        Variation{.path = "drive", .from = 1, .to = 2, .n_points = 3}})
    EXPECT_THROW((void)sweep(gear(), Method::corrected, std::vector{broken}), InputError)
        << broken.path << ' ' << broken.from << ' ' << broken.to << ' ' << broken.n_points;
}

TEST(Sweep, BehaviourNotesAreGatheredWithTheirRows) {
  const std::vector<Variation> one{
      parse_variation(gear(), "flexspline.crack[0].half_length=13 mm..20 mm:8")};
  const SweepResult result = sweep(gear(), Method::corrected, one);
  const auto note = std::ranges::find_if(result.notes, [](const SweepNote& n) {
    return n.note.code == "crack.shell_range";  // shell parameter > 2, so beyond 14.6 mm
  });
  ASSERT_NE(note, result.notes.end());
  EXPECT_EQ(note->first_row, 2U);
  EXPECT_EQ(note->n_rows, 6U);
  EXPECT_EQ(result.crack_paths,
            (std::vector<std::string>{"wave_generator.crack[0]", "flexspline.crack[0]",
                                      "output_shaft.crack[0]"}));
  const nlohmann::json json = nlohmann::json::parse(json_of(result));
  EXPECT_EQ(json.at("note_rows").at("code").at("values").size(), result.notes.size());
  EXPECT_EQ(evidence_of(result).notes.size(), result.notes.size());
}

TEST(Sweep, BehaviourCsvKeepsEveryDigitAndQuotes) {
  GearSet odd = gear();
  odd.material["a,\"b\""] = odd.material.at("steel");
  odd.output_shaft->material = "a,\"b\"";
  const std::vector<Variation> one{
      {.path = "material.a,\"b\".shear_modulus", .from = 70e9, .to = 1e11 / 3, .n_points = 2}};
  const SweepResult result = sweep(odd, Method::corrected, one);
  std::istringstream lines(sweep_csv(result));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("\"material.a,\"\"b\"\".shear_modulus [Pa]\",", 0), 0U) << line;
  for (const SweepRow& row : result.rows) {
    std::getline(lines, line);
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    EXPECT_EQ(std::stod(cell), row.inputs[0]);
    for (const auto& output : row.outputs) {
      std::getline(cells, cell, ',');
      EXPECT_EQ(std::stod(cell), output->value);
    }
    std::getline(cells, cell);
    EXPECT_EQ(cell, "true,");
  }
}

TEST(Sweep, BehaviourCsvAndJsonCarryTheSameTable) {
  const std::vector<Variation> one{
      parse_variation(gear(), "output_shaft.crack[0].depth=9 mm..15 mm:3")};
  const SweepResult result = sweep(gear(), Method::corrected, one);
  std::istringstream lines(sweep_csv(result));
  std::string header;
  std::getline(lines, header);
  EXPECT_EQ(header.rfind("output_shaft.crack[0].depth [m],", 0), 0U);
  EXPECT_NE(header.find("intact.stiffness [N*m/rad]"), std::string::npos);
  EXPECT_NE(header.find(",usable,reason"), std::string::npos);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_TRUE(rows[0].ends_with(",true,")) << rows[0];
  EXPECT_NE(rows[1].find(",false,\"output_shaft.crack[0]: a/t"), std::string::npos) << rows[1];
  EXPECT_EQ(rows[2].rfind("0.015,,,,", 0), 0U) << rows[2];  // a refused point has no outputs
  const nlohmann::json json = nlohmann::json::parse(json_of(result));
  EXPECT_EQ(json.at("method"), "corrected");
  const auto values = [](const nlohmann::json& record, const char* name) {
    return record.at(name).at("values");
  };
  EXPECT_EQ(json.at("columns").size(), 1 + result.outputs.size());
  for (const nlohmann::json& column : json.at("columns")) {
    EXPECT_EQ(values(column, "values").size(), 3U);
    EXPECT_EQ(values(column, "relative_uncertainties").size(), column.at("varied") ? 0U : 3U);
  }
  const nlohmann::json& varied = json.at("columns")[0];
  EXPECT_EQ(varied.at("name"), "output_shaft.crack[0].depth");
  EXPECT_EQ(varied.at("varied"), true);
  for (std::size_t i = 0; i < result.rows.size(); ++i)
    EXPECT_EQ(values(varied, "values")[i].get<double>(), result.rows[i].inputs[0]);
  const nlohmann::json& output = json.at("columns")[1];
  EXPECT_EQ(output.at("unit"), "rad/(N*m)");
  EXPECT_EQ(values(output, "values")[0].get<double>(), result.rows[0].outputs[0]->value);
  EXPECT_EQ(values(output, "relative_uncertainties")[0].get<double>(),
            *result.rows[0].outputs[0]->relative_uncertainty);
  EXPECT_TRUE(values(output, "values")[2].is_null());
  EXPECT_EQ(values(json.at("rows"), "usable"), nlohmann::json({true, false, false}));
}

}  // namespace
}  // namespace strainwave

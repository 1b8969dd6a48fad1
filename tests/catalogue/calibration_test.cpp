// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/calibration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "least_squares.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/calibration.hpp"
#include "strainwave/present/json.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::broken_rule;

constexpr double kArcmin = std::numbers::pi / 10800;  // [rad]

/// K1, K2, K3 of a drive as a target, as a maker would state them.
CalibrationTarget lines_of(const GearSet& gear) {
  const MakersTorques at = makers_torques(gear);
  const MakersLines lines = makers_lines(gear);
  return {.source = "made up",
          .values = {{"K1", 0, at.T1, lines.K1},
                     {"K2", at.T1, at.T2, lines.K2},
                     {"K3", at.T2, at.T3, lines.K3}},
          .relative_uncertainty = 0.01};
}

// The fit recovers known factors; 0.1 % is the accuracy at which it stops.
TEST(Calibration, IdentityRecoversWhatWasPutIn) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const GearSet truth = with_factor(with_factor(gear, Factor::support, 0.3), Factor::coning, 0.6);
  const Calibration c = calibrate(gear, lines_of(truth), {Factor::support, Factor::coning});
  EXPECT_TRUE(c.converged);
  ASSERT_EQ(c.factors.size(), 2U);
  test::expect_relative(c.factors[0].value, 0.3, 1e-3);
  test::expect_relative(c.factors[1].value, 0.6, 1e-3);
  EXPECT_TRUE(c.factors[0].identified);
  EXPECT_TRUE(c.factors[1].identified);
  EXPECT_TRUE(evidence_of(c).notes.empty());
  EXPECT_EQ(c.gear.circular_spline->support, c.factors[0].value);
  for (const CalibratedStiffness& s : c.stiffnesses)
    test::expect_relative(s.after, s.target.stiffness, 1e-4);
}

// Kind: behaviour.  A wall behind which the drive has no equilibrium is no minimum: the search ends
// there without convergence.  A minimum at the same place converges.
TEST(Calibration, BehaviourAWallIsNoMinimum) {
  const auto fit = [](double wanted) {
    return fit_factors({.factors = {Factor::support},
                        .start = {0.2},
                        .residuals = [wanted](const std::vector<double>& at) -> Eigen::VectorXd {
                          if (at[0] > 0.5) throw SolverError("no equilibrium");
                          return Eigen::VectorXd::Constant(1, std::log(at[0] / wanted));
                        }});
  };
  EXPECT_FALSE(fit(0.8).converged);
  EXPECT_TRUE(fit(0.4).converged);
  test::expect_relative(fit(0.4).values[0], 0.4, 1e-4);
}

// Kind: behaviour.  Where the drive has no equilibrium a difference beyond the start, the
// difference to the other side takes its place, and the search goes on to its minimum.
TEST(Calibration, BehaviourDifferencesBesideAWall) {
  const FactorFit fit =
      fit_factors({.factors = {Factor::support},
                   .start = {0.4999},
                   .residuals = [](const std::vector<double>& at) -> Eigen::VectorXd {
                     if (at[0] > 0.5) throw SolverError("no equilibrium");
                     return Eigen::VectorXd::Constant(1, std::log(at[0] / 0.3));
                   }});
  EXPECT_TRUE(fit.converged);
  test::expect_relative(fit.values[0], 0.3, 1e-4);
}

// While only a part of the face touches, coning and compliance of a pair act as one number.  No K
// distinguishes them, so neither is called identified.
TEST(Calibration, LimitInseparableFactorsAreNotIdentified) {
  GearSet gear = typical_drive_of_size(25, 100);
  gear.mesh->tooth.reset();  // drawn teeth touch on the whole face in the middle of the engagement
  const Calibration c = calibrate(gear, lines_of(with_factor(gear, Factor::coning, 0.9)),
                                  {Factor::coning, Factor::pair_compliance}, {.harmonics = 8});
  EXPECT_FALSE(c.factors[0].identified);
  EXPECT_FALSE(c.factors[1].identified);
  ASSERT_EQ(c.combinations.size(), 2U);
  EXPECT_TRUE(c.combinations[0].identified);
  EXPECT_FALSE(c.combinations[1].identified);
  const std::string text = calibration_text(c);
  EXPECT_NE(text.find("NOT IDENTIFIED"), std::string::npos) << text;
  EXPECT_NE(text.find("3 values identify 1 of 2"), std::string::npos) << text;
  // The verdict asks for care, and the note says what to do.
  const ResultEvidence evidence = evidence_of(c);
  ASSERT_EQ(evidence.notes.size(), 1U);
  EXPECT_EQ(evidence.notes[0].code, "calibration.not_identified");
  EXPECT_EQ(evidence.notes[0].text, "these values do not identify coning, pair_compliance");
  EXPECT_NE(evidence.notes[0].next_step.find("one factor or other factors"), std::string::npos);
  EXPECT_EQ(evidence.verdict.judgement, Judgement::with_care);
  EXPECT_NE(text.find("do not identify coning"), std::string::npos) << text;
}

// The sum of squares of the weights is one; a single factor is its own combination.
TEST(Calibration, IdentityUncertaintyOfOneFactor) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const Calibration c = calibrate(gear, lines_of(gear), {Factor::coning}, {.harmonics = 8});
  ASSERT_EQ(c.combinations.size(), 1U);
  test::expect_relative(c.combinations[0].weights.at(0), 1.0, 1e-12);
  test::expect_relative(
      c.factors[0].uncertainty,
      c.factors[0].value * c.relative_uncertainty / c.combinations[0].singular_value, 1e-12);
}

TEST(Calibration, BehaviourFittedNumbersHaveNoRangeAnyMore) {
  GearSet gear = starting_drive(25, 100).gear;
  for (const char* const path : {"mesh.coning", "flexspline.wall_thickness"})
    gear.scatter.push_back({.path = path, .relative_standard_deviation = 0.1, .source = {}});
  GearSet truth = with_factor(gear, Factor::coning, 1.6);
  truth.range.clear();
  const Calibration c = calibrate(gear, lines_of(truth), {Factor::coning});
  EXPECT_GT(c.gear.mesh->coning, 1.5);
  EXPECT_EQ(c.gear.range.size() + 1, gear.range.size());
  for (const InputRange& range : c.gear.range) EXPECT_NE(range.path, "mesh.coning");
  ASSERT_EQ(c.gear.scatter.size(), 1U);
  EXPECT_EQ(c.gear.scatter[0].path, "flexspline.wall_thickness");
  EXPECT_NO_THROW(check(c.gear));
}

TEST(Calibration, IdentityCatalogueStiffnessIsOfTheComponentSet) {
  // Shaft, flange and cracks belong to the customer: they stay in the drive but not in the
  // comparison.
  GearSet gear = starting_drive(25, 100).gear;
  const Calibration plain = calibrate(gear, catalogue_target(gear), {Factor::coning});
  OutputShaft shaft;
  shaft.material = "steel";
  shaft.outer_diameter = 0.03;
  shaft.length = 0.04;
  gear.output_shaft = shaft;
  gear.flexspline->flange_compliance = 1e-6;
  gear.flexspline->crack.push_back(WallThroughCrack{.half_length = 2e-3});
  // Ranges and scatters of the customer's parts stay in the drive too.
  for (const auto& [path, lower, upper] :
       {std::array{"output_shaft.length", "30 mm", "50 mm"},
        std::array{"flexspline.flange_compliance", "0.5e-6 rad/(N*m)", "2e-6 rad/(N*m)"},
        std::array{"flexspline.crack[0].half_length", "1 mm", "3 mm"}}) {
    gear.range.push_back({.path = path, .lower = lower, .upper = upper, .source = {}});
    gear.scatter.push_back({.path = path, .relative_standard_deviation = 0.1, .source = {}});
  }
  const Calibration customer = calibrate(gear, catalogue_target(gear), {Factor::coning});
  EXPECT_EQ(customer.gear.range.size(), plain.gear.range.size() + 3);
  EXPECT_EQ(customer.gear.scatter.size(), 3U);
  EXPECT_EQ(customer.gear.mesh->coning, plain.gear.mesh->coning);
  EXPECT_TRUE(customer.gear.output_shaft.has_value());
  EXPECT_EQ(customer.gear.flexspline->crack.size(), 1U);
  EXPECT_EQ(customer.gear.flexspline->flange_compliance, 1e-6);
}

TEST(CalibrationTargets, ReferenceCatalogueRow) {
  const CalibrationTarget own = catalogue_target(typical_drive_of_size(32, 120));
  ASSERT_EQ(own.values.size(), 3U);
  test::expect_relative(own.values[1].stiffness, 11e4, 1e-12);
  test::expect_relative(own.values[2].to_torque, 1.6 * 108, 1e-12);
  // d = 160 mm against size 65 of 165.1 mm: the cube of the ratio.
  const CalibrationTarget scaled = catalogue_target(typical_drive(0.16, 100));
  test::expect_relative(scaled.values[0].stiffness, 54e4 * std::pow(160 / 165.1, 3), 1e-12);
  EXPECT_EQ(catalogue_target(typical_drive_of_size(100, 50)).values.size(),
            2U);  // the row lacks K3
}

// Rows of other series judge only: size 8 has a row of ratio 100 there, but the nearest row of a
// cup in the catalogue is size 14, because size 11 is stated for a hat.  It is scaled by the cube
// of the diameter; 1e-12 is rounding.
TEST(CalibrationTargets, BehaviourRowsOfOtherSeriesAreNoTarget) {
  const CalibrationTarget target = catalogue_target(typical_drive(pitch_diameter_of(8), 100));
  EXPECT_EQ(target.source.rfind("catalogue, size 14, ratio 80+", 0), 0U) << target.source;
  // Small sizes miss the cube of the diameter by 20 to 50 %.
  EXPECT_EQ(target.relative_uncertainty, 0.3);
  EXPECT_EQ(catalogue_target(typical_drive_of_size(25, 100)).relative_uncertainty, 0.02);
  EXPECT_EQ(catalogue_target(typical_drive(0.16, 100)).relative_uncertainty, 0.05);
  test::expect_relative(target.values[0].stiffness, 4700 * std::pow(8.0 / 14, 3), 1e-12);
}

// Kind: crosscheck.  The stated error of a row that is scaled by d^3 bounds the root of the mean
// square of the differences of K/d^3 between neighbouring sizes of the catalogue; from size 17 on
// it is less than three times as large.  Source: the rows themselves.
TEST(CalibrationTargets, CrosscheckErrorOfScaling) {
  for (const auto& [ratio, ratio_class] :
       {std::pair{30, RatioClass::thirty}, {50, RatioClass::fifty}, {100, RatioClass::eighty_up}}) {
    std::vector<const StiffnessRow*> rows;
    for (const StiffnessRow& row : stiffness_rows())
      if (row.ratio_class == ratio_class && row.form == FlexsplineForm::cup &&
          row.size >= kLeastSimilarSize)
        rows.push_back(&row);
    ASSERT_GE(rows.size(), 4U);
    for (std::size_t k = 0; k < 3; ++k) {
      double squares = 0;
      int count = 0;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto K = rows[i]->K()[k];
        const auto before = rows[i - 1]->K()[k];
        if (!K || !before) continue;
        squares += std::pow(*K / *before * std::pow(rows[i - 1]->size / rows[i]->size, 3) - 1, 2);
        ++count;
      }
      const double rms = std::sqrt(squares / count);
      const double stated =
          catalogue_target(typical_drive(pitch_diameter_of(28), ratio)).relative_uncertainty;
      EXPECT_LT(rms, stated) << ratio << " K" << k + 1;
      EXPECT_GT(3 * rms, stated) << ratio << " K" << k + 1;
    }
  }
}

// A drive is fitted to a row of its own form and length only; the one row of a hat is that of size
// 11, 80 and more, and it is not scaled to other sizes.
TEST(CalibrationTargets, InputNoRowOfTheForm) {
  const DriveType short_hat{.form = FlexsplineForm::hat};
  const CalibrationTarget own = catalogue_target(typical_drive_of_size(11, 100, short_hat));
  EXPECT_EQ(own.source, "catalogue, size 11, ratio 80+");
  EXPECT_EQ(own.values[0].stiffness, 2700);
  ASSERT_NE(own.row, nullptr);
  EXPECT_EQ(own.row->form, FlexsplineForm::hat);

  const auto refusal = [](const GearSet& gear) {
    return broken_rule([&] { return catalogue_target(gear); });
  };
  EXPECT_EQ(refusal(typical_drive_of_size(25, 100, short_hat)),
            "catalogue: the catalogue states no stiffness of a short hat with a pitch diameter of "
            "63.5 mm at "
            "ratio 100; calibrate to a measured curve (--measured)");
  for (const DriveType& type :
       {DriveType{.form = FlexsplineForm::hat, .length = FlexsplineLength::flat},
        DriveType{.length = FlexsplineLength::flat},
        DriveType{.length = FlexsplineLength::standard}})
    EXPECT_NE(refusal(typical_drive_of_size(20, 100, type)).find("states no stiffness of a "),
              std::string::npos);
  GearSet cylinder = typical_drive_of_size(25, 100);
  cylinder.flexspline->shape = FlexsplineShape::cylinder;
  EXPECT_NE(refusal(cylinder).find("states the stiffness of cups and hats only"),
            std::string::npos);
}

TEST(MeasuredCurve, BehaviourUnitsAndColumns) {
  const auto points = parse_measured_curve(
      "# a bench\n\ntwist [arcmin], speed, torque [kN*m]\r\n0,0,0\n1.5,9,0.014\n-1.5,9,-0.014\n",
      "bench.csv");
  ASSERT_EQ(points.size(), 2U);
  test::expect_relative(points[0].torque, 14, 1e-12);
  test::expect_relative(points[0].twist, 1.5 * kArcmin, 1e-12);
  test::expect_relative(points[1].torque, -14, 1e-12);
}

TEST(MeasuredCurve, IdentityDialectsOfSpreadsheets) {
  const auto plain =
      parse_measured_curve("torque [N*m],twist [arcmin]\n14,1.5\n48.25,2.75\n", "bench.csv");
  ASSERT_EQ(plain.size(), 2U);
  for (const std::string text :
       {"\xEF\xBB\xBFtorque [N*m],twist [arcmin]\n14,1.5\n48.25,2.75\n",  // byte order mark
        "torque [N*m];twist [arcmin]\r\n14;1,5\r\n48,25;2,75\r\n",
        "torque [N*m];twist [arcmin]\n14;1.5\n48.25;2.75\n",
        "torque [N*m],twist [arcmin]\n14,1.5,\n48.25,2.75, ,\n",  // of a data logger
        "sep=;\nTorque [N*m];Twist [arcmin]\n14;1,5\n48,25;2,75",
        "torque [N*m]\ttwist [arcmin]\n14\t1,5\n48,25\t2,75\n",
        "torque [N*m]\ttwist [arcmin]\r14\t1.5\r48.25\t2.75\r",
        "\"torque [N*m]\",\"twist [arcmin]\"\n\"14\",\"1,5\"\n\"48,25\" , \"2,75\"\n",
        "\"remark; \"\"a\"\", b\";\"torque [N*m]\";twist "
        "[arcmin];;\n\"x;y\";14;1,5;;\n;;;;\n;48,25;2,75;;\n;;;;\n"}) {
    const auto points = parse_measured_curve(text, "bench.csv");
    ASSERT_EQ(points.size(), 2U) << text;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(points[i].torque, plain[i].torque) << text;
      EXPECT_EQ(points[i].twist, plain[i].twist) << text;
    }
  }
}

TEST(MeasuredCurve, CrosscheckCalibratesBothSenses) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const GearSet truth = with_factor(gear, Factor::support, 0.8);
  const CoupledOptions coarse{.harmonics = 8};
  std::string csv = "torque [N*m],twist [rad]\n";
  for (const double T : {10.0, 60.0, -30.0}) {
    const TorsionCurve curve = torsion_curve(truth, {{T / 3, T}}, coarse);
    csv += std::to_string(T) + "," + std::to_string(1e6 * curve.points.back().twist) + "e-6\n";
  }
  const CalibrationTarget target = measured_target(parse_measured_curve(csv, "made up"), "made up");
  const Calibration c = calibrate(gear, target, {Factor::support}, coarse);
  test::expect_relative(c.factors[0].value, 0.8, 1e-3);  // where the fit stops
}

// A test bench records thousands of points, and the drive is solved at some of them. The answer
// agrees with that of all points within a tenth of the uncertainty of a measured value, 1 %.
TEST(MeasuredCurve, CrosscheckManyPointsAreFittedAsFew) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const CoupledOptions coarse{.harmonics = 8};
  const auto fitted = [&](int n) {
    std::vector<MeasuredPoint> points;
    for (int i = 1; i <= n; ++i) {
      const double T = 60.0 * i / n;
      points.push_back({T, T / 3e4 * (1 + 0.2 * std::exp(-T / 20))});
    }
    return calibrate(gear, measured_target(points, "made up"), {Factor::support}, coarse)
        .factors[0]
        .value;
  };
  test::expect_relative(fitted(2000), fitted(200), 0.01);
}

TEST(MeasuredCurve, InputRefusals) {
  const auto message = [](const std::string& text) {
    return broken_rule([&] { return parse_measured_curve(text, "bench.csv"); });
  };
  EXPECT_NE(message("").find("bench.csv: is empty"), std::string::npos);
  EXPECT_NE(message("torque [N*m],angle [rad]\n").find("must name the columns"), std::string::npos);
  EXPECT_NE(message("torque,twist [rad]\n").find("has no unit"), std::string::npos);
  EXPECT_NE(message("torque [N],twist [rad]\n").find("bench.csv:1"), std::string::npos);
  EXPECT_NE(message("torque [N*m],twist [rad]\n").find("no point with a torque"),
            std::string::npos);
  const std::string head = "torque [N*m];twist [rad]\n";
  for (const auto& [text, sentence] : std::map<std::string, std::string>{
           {head + "1\n",
            "bench.csv:2: has 1 cell, but the head names 2 columns; write a cell for each column; "
            "a cell may be empty"},
           {head + "1;2\n1;2;3\n",
            "bench.csv:3: has 3 cells, but the head names 2 columns; remove the cells without a "
            "column"},
           {"torque [N*m],twist [rad]\n30,2,132\n",
            "bench.csv:2: has 3 cells, but the head names 2 columns; if commas are decimal, "
            "separate the cells by semicolons, or put each number in quotes"},
           {"torque [N*m],twist [rad],remark\n30,2,1\n30,2\n",
            "bench.csv:3: has 2 cells, but the head names 3 columns"},
           {head + "1;x\n",
            "bench.csv:2:3: twist = \"x\" is not a number; write a number such as 12.5 or 12,5"},
           {head + "1;\n",
            "bench.csv:2:3: twist = \"\" is not a number; write a number such as 12.5 or 12,5"},
           {head + "\n 1.234,5; 1\n",
            "bench.csv:3:2: torque = \"1.234,5\" has separators of thousands; write the number "
            "without them"},
           {head + "1,5;1\n2.5;2\n",
            "bench.csv:3:1: torque = \"2.5\" has a decimal point, but line 2 has a decimal comma; "
            "use one of the two"},
           {head + "1;\"2\n", "bench.csv:2:3: has a quote that is not closed before the next cell"},
           {head + "\"1\"0;2\n",
            "bench.csv:2:1: has a quote that is not closed before the next cell"},
           {"a;torque [N*m];torque [N*m]\n", "bench.csv:1:16: names the column torque twice"},
           {"a;torque [kg];twist [rad]\n", "bench.csv:1:3: torque"},
           {std::string("\xFF\xFEt\0o\0", 6),
            "bench.csv: is not CSV text in UTF-8; save the table as \"CSV UTF-8\""}})
    EXPECT_EQ(message(text).substr(0, sentence.size()), sentence) << text;
  EXPECT_NE(message("torque [N*m],twist [rad]\n1,-1\n").find("same sign"), std::string::npos);
  EXPECT_NE(broken_rule([] {
              return measured_target({{1, 1}}, "x", 0.0);
            }).find("> 0 and < 1"),
            std::string::npos);
}

TEST(Calibration, InputRefusals) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const CalibrationTarget target = catalogue_target(gear);
  EXPECT_NE(broken_rule([&] { return calibrate(gear, target, {}); }).find("at least one"),
            std::string::npos);
  EXPECT_NE(broken_rule([&] {
              return calibrate(
                  gear, target,
                  {Factor::support, Factor::coning, Factor::gap_factor, Factor::structure});
            }).find("name fewer"),
            std::string::npos);
  GearSet bare = gear;
  bare.circular_spline.reset();
  EXPECT_NE(broken_rule([&] {
              return calibrate(bare, target, {Factor::support});
            }).find("circular_spline"),
            std::string::npos);
}

TEST(CalibrationProgress, BehaviourAStopEndsIt) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const CalibrationTarget target = catalogue_target(gear);
  const auto stopped_after = [&](int most) {
    int told = 0;
    EXPECT_THROW((void)calibrate(gear, target, {Factor::support}, {.harmonics = 8},
                                 Progress([&](double) { return ++told < most; })),
                 Stopped);
    return told;
  };
  EXPECT_EQ(stopped_after(1), 1);
  EXPECT_EQ(stopped_after(2), 2);
}

TEST(CalibrationOutput, BehaviourJson) {
  const GearSet gear = typical_drive_of_size(25, 100);
  const Calibration c =
      calibrate(gear, catalogue_target(gear), {Factor::support}, {.harmonics = 8});
  const auto json = nlohmann::json::parse(json_of(c));
  EXPECT_EQ(json["factors"]["name"]["values"][0], "support");
  EXPECT_EQ(json["factors"]["value"]["values"][0], c.factors[0].value);
  EXPECT_EQ(json["stiffness"]["after"]["values"].size(), 3U);
  EXPECT_EQ(json["stiffness"]["wanted"]["values"][1], 50000);
}

/// A joint about as stiff and heavy as one of size 25.
Joint bench_joint() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = LinearSpring{5e4},
          .damping = 10};
}

TEST(Calibration, CrosscheckFrictionOfTheCatalogue) {
  // (MO-41 to MO-43): all rows return their four values by simulation, and an input file with the
  // printed section reads back the fitted numbers to their six digits.
  for (const FrictionRow& row : friction_rows()) {
    GearSet gear = typical_drive_of_size(row.size, row.ratio);
    gear.drivetrain = Drivetrain{.motor_inertia = 1e-4, .load_inertia = 1.0};
    const Calibration c =
        calibrate_friction(gear, bench_joint(), friction_targets(gear), "the catalogue");
    EXPECT_TRUE(c.converged);
    EXPECT_LT(c.residual, 1e-3);
    EXPECT_TRUE(evidence_of(c).unusable_because.empty());
    const std::string text = calibration_text(c);
    EXPECT_NE(text.find("[drivetrain.friction]"), std::string::npos);
    EXPECT_NE(text.find("coulomb is assumed"), std::string::npos) << text;
    const std::string drive = calibrated_drive(c, gear, {});
    EXPECT_TRUE(
        drive.starts_with("# drivetrain.friction is fitted to the catalogue, at 209.44 rad/s"))
        << drive.substr(0, 200);
    const GearSet written = read_gear_set(drive, "written.toml");
    const LuGre& fitted = c.friction->friction;
    const LuGre& read = written.drivetrain->friction.value();
    test::expect_relative(read.breakaway, fitted.breakaway, 1e-5);
    test::expect_relative(read.viscous, fitted.viscous, 1e-5);
    test::expect_relative(read.load_coulomb, fitted.load_coulomb, 1e-5);
    test::expect_relative(read.load_breakaway.value(), fitted.load_breakaway.value(), 1e-5);
  }
}

TEST(Calibration, BehaviourFrictionThatContradictsIsNotUsable) {
  // (MO-42, MO-43): the notes name the value and why it has a residual.
  GearSet gear = typical_drive_of_size(25, 100);
  FrictionTargets targets = friction_targets(gear);
  targets.back_driving_torque = 6.0;
  const auto evidence = [&] {
    return evidence_of(calibrate_friction(gear, bench_joint(), targets, "made up"));
  };
  ResultEvidence of = evidence();
  EXPECT_FALSE(of.unusable_because.empty());
  ASSERT_EQ(of.notes.front().code, "calibration.friction_residual");
  EXPECT_NE(of.notes.front().text.find("the back-driving torque is 6.9 N*m in place of 6 N*m"),
            std::string::npos)
      << of.notes.front().text;
  targets.back_driving_torque = 7.26;
  targets.efficiency = 0.9;
  of = evidence();
  ASSERT_EQ(of.notes.front().code, "calibration.friction_residual");
  EXPECT_EQ(of.notes.front().equation, "MO-43");
  // A bench that is too slow for its steps has no value.
  targets.efficiency = 0.77;
  Calibration c = calibrate_friction(gear, bench_joint(), targets, "made up");
  of = evidence_of(c);
  EXPECT_TRUE(of.unusable_because.empty());
  EXPECT_EQ(std::ranges::count(of.notes, "calibration.friction_assumed", &Note::code), 1);
  c.converged = false;
  c.friction->values[1].simulated.reset();
  c.friction->values[1].reason = "the input does not turn";
  of = evidence_of(c);
  EXPECT_EQ(of.notes.front().code, "calibration.friction_not_simulated");
  EXPECT_NE(of.notes.front().text.find("the starting torque has no value: the input does not turn"),
            std::string::npos)
      << of.notes.front().text;
}

TEST(Calibration, InputFrictionOfNoRow) {
  GearSet turned = typical_drive_of_size(25, 100);
  turned.drivetrain = Drivetrain{.fixed = FixedMember::flexspline};
  EXPECT_TRUE(broken_rule([&] {
                (void)friction_targets(turned);
              }).starts_with("catalogue: states friction with the circular spline fixed only"));
  EXPECT_TRUE(broken_rule([] {
                (void)friction_targets(typical_drive_of_size(32, 100));
              }).starts_with("catalogue: the catalogue states no friction of a drive with"));
  EXPECT_TRUE(broken_rule([] {
                (void)friction_targets(typical_drive_of_size(25, 80));
              }).starts_with("catalogue: the catalogue states no friction of a drive with"));
}

}  // namespace
}  // namespace strainwave

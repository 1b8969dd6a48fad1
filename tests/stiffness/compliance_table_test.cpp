// SPDX-License-Identifier: Apache-2.0
// Cracks whose compliance is read from a table, in the stiffness of the drive.
#include "strainwave/model/input/compliance_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/compliance_table.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace)
using test::made_up_compliance;
using test::tabulated_gear;

const CrackReport& wall_crack(const StiffnessResult& result) {
  return *std::ranges::find(result.cracks, "flexspline.crack[0]", &CrackReport::path);
}

// (FE-41), (FE-42), (FE-43): the crack adds the compliance of the table, under the sense of the
// table.
TEST(TabulatedCrack, CrosscheckAddsWhatTheTableSays) {
  const GearSet gear = tabulated_gear(7 * mm);
  const StiffnessResult result = torsional_stiffness(gear);
  ASSERT_TRUE(result.usable()) << result.unusable_because;
  const CrackReport& crack = wall_crack(result);
  const ComplianceTable& table = gear.compliance_tables.at("made_up.csv");
  const double error = std::hypot(0.002, table.positive.interpolation_error);
  EXPECT_NEAR(crack.positive.at_output.value / made_up_compliance(7 * mm), 1, error);
  EXPECT_NEAR(*crack.positive.at_output.relative_uncertainty, error, 1e-15);
  EXPECT_EQ(crack.negative.at_output.value, 0.0);
  EXPECT_EQ(crack.opens_under, OpensUnder::positive);
  // The crack enters the drive like any other crack.
  GearSet sound = gear;
  sound.flexspline->crack.clear();
  const double added = result.positive.compliance.flexspline.value -
                       torsional_stiffness(sound).positive.compliance.flexspline.value;
  EXPECT_NEAR(added / crack.positive.at_output.value, 1, 1e-9);
  EXPECT_EQ(test::count_notes(result.notes, "crack.compliance_table", "flexspline.crack[0]"), 1);
  EXPECT_EQ(test::count_notes(result.notes, "crack.stress_nonuniformity", "flexspline.crack[0]"),
            1);  // the article uses 1.1
  EXPECT_EQ(test::count_notes(result.notes, "crack.plane_stress"), 0);
  for (const char* const tag : {"FE-41", "FE-42", "FE-43"})
    EXPECT_NE(std::ranges::find(result.equations, tag), result.equations.end()) << tag;
  const auto basis =
      std::ranges::find(result.accuracies, "flexspline.crack[0]", &AccuracyBasis::path);
  ASSERT_NE(basis, result.accuracies.end());
  EXPECT_NE(basis->source.find("made_up.csv: points 0.2 %"), std::string::npos) << basis->source;
}

// Stress intensity stays that of the closed form, and is left out if the closed form does not give
// it.
TEST(TabulatedCrack, IdentityStressIntensityOfTheClosedForm) {
  GearSet gear = tabulated_gear(7 * mm);
  const StiffnessResult tabulated = torsional_stiffness(gear);
  auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  crack.compliance_table.reset();
  const StiffnessResult closed_form = torsional_stiffness(gear);
  EXPECT_EQ(wall_crack(tabulated).deepest->K_I, wall_crack(closed_form).deepest->K_I);
  EXPECT_EQ(wall_crack(tabulated).deepest->K_II, wall_crack(closed_form).deepest->K_II);
  const StiffnessResult far = torsional_stiffness(tabulated_gear(32 * mm));
  EXPECT_TRUE(far.usable()) << far.unusable_because;  // the closed form would not be usable
  EXPECT_FALSE(wall_crack(far).deepest);
  EXPECT_EQ(test::count_notes(far.notes, "crack.shell_range", "flexspline.crack[0]"), 1);
  crack.half_length = 32 * mm;
  EXPECT_FALSE(torsional_stiffness(gear).usable());
}

// Notes and equations on the stress intensity of the closed form do not depend on the source of the
// compliance, in each case.
TEST(TabulatedCrack, BehaviourNotesOfTheClosedForm) {
  const auto expect_same = [](GearSet gear, std::initializer_list<const char*> notes) {
    const StiffnessResult tabulated = torsional_stiffness(gear);
    std::get<WallThroughCrack>(gear.flexspline->crack.at(0)).compliance_table.reset();
    const StiffnessResult closed_form = torsional_stiffness(gear);
    for (const char* const code : notes) {
      EXPECT_EQ(test::count_notes(tabulated.notes, code, "flexspline.crack[0]"), 1) << code;
      EXPECT_EQ(test::count_notes(closed_form.notes, code, "flexspline.crack[0]"), 1) << code;
    }
    EXPECT_EQ(wall_crack(tabulated).deepest->K_I, wall_crack(closed_form).deepest->K_I);
    EXPECT_EQ(wall_crack(tabulated).largest->K_II, wall_crack(closed_form).largest->K_II);
    for (const char* const tag : {"FR-6", "FR-7", "FR-17", "ST-11"})
      EXPECT_TRUE(std::ranges::count(tabulated.equations, tag) == 1) << tag;
    return std::ranges::count(tabulated.equations, "SU-2");
  };
  EXPECT_EQ(expect_same(tabulated_gear(7 * mm), {"crack.closed"}), 1);
  EXPECT_EQ(expect_same(tabulated_gear(18 * mm), {"crack.closed", "crack.shell_range"}), 1);
  GearSet flat = tabulated_gear(7 * mm);
  std::get<WallThroughCrack>(flat.flexspline->crack.at(0)).shell_correction = false;
  EXPECT_EQ(expect_same(flat, {"crack.closed", "crack.flat_plate"}), 0);
}

// The short computation of the same model, and its derivative with respect to the varied number by
// both methods.
TEST(TabulatedCrack, CrosscheckSeriesAndDerivative) {
  GearSet gear = tabulated_gear(7 * mm);
  const auto series = series_compliance<double>(gear);
  const StiffnessResult result = torsional_stiffness(gear);
  EXPECT_TRUE(series.usable);
  EXPECT_NEAR(series.positive_stiffness() / result.positive.stiffness.value, 1, 1e-14);
  EXPECT_NEAR(series.negative_stiffness() / result.negative.stiffness.value, 1, 1e-14);
  double& a = std::get<WallThroughCrack>(gear.flexspline->crack[0]).half_length;
  const std::vector<const double*> inputs = {&a};
  const auto dual = series_compliance(gear, Lift<DualReal>(inputs));
  EXPECT_EQ(dual.positive.value, series.positive);
  const double here = a;
  const double step = 1e-5 * here;
  const auto at = [&](double value) {
    a = value;
    return series_compliance<double>(gear).positive_added;
  };
  const double difference = (at(here + step) - at(here - step)) / (2 * step) * here;
  EXPECT_NEAR(dual.positive_added.partial[0] / difference, 1, 1e-6);
  // both must be close to x dy/dx of the law
  const double x = 7.0 / 5;
  const double law = 2e-10 * x * x * (2 + 0.9 * x);
  a = here;
  GearSet alone = gear;
  alone.wave_generator->crack.clear();
  alone.output_shaft->crack.clear();
  const std::vector<const double*> one = {
      &std::get<WallThroughCrack>(alone.flexspline->crack[0]).half_length};
  EXPECT_NEAR(series_compliance(alone, Lift<DualReal>(one)).positive_added.partial[0] / law, 1,
              0.01);
}

ComplianceTable shaft_table(const GearSet& gear) {
  ComplianceTable table;
  table.kind = "annular";
  table.axes = {{"depth", "m", false, {1 * mm, 3 * mm, 5 * mm, 7 * mm, 12 * mm}}};
  for (const double a : table.axes[0].nodes) {
    table.positive.values.push_back(3e-3 * a * a);
    table.axial.values.push_back(1e-6 * a * a);
  }
  table.negative.values = table.positive.values;
  const OutputShaft& shaft = *gear.output_shaft;
  table.fixed = {{"outer_diameter", "m", shaft.outer_diameter},
                 {"inner_diameter", "m", shaft.inner_diameter},
                 {"length", "m", shaft.length},
                 {"youngs_modulus", "Pa", 210 * GPa},
                 {"poissons_ratio", "1", 0.3}};
  table.point_error = 0.01;
  return completed(table);
}

TEST(TabulatedCrack, CrosscheckShaftWithTension) {
  GearSet gear = test::article_gear(4 * mm);
  gear.load.axial_force = 5000;
  auto& crack = std::get<AnnularCrack>(gear.output_shaft->crack.at(0));
  crack.compliance_table = "shaft.csv";
  gear.compliance_tables["shaft.csv"] = shaft_table(gear);
  const StiffnessResult result = torsional_stiffness(gear);
  const CrackReport& report = result.cracks.back();
  ASSERT_EQ(report.path, "output_shaft.crack[0]");
  const double error = *report.positive.at_output.relative_uncertainty;
  EXPECT_GE(error, 0.01);
  EXPECT_NEAR(report.positive.at_output.value / (3e-3 * 16e-6), 1, error);
  EXPECT_EQ(report.negative.at_output.value, report.positive.at_output.value);
  EXPECT_NEAR((*report.positive.axial_torsion)[0].value / (1e-6 * 16e-6), 1, error);
  EXPECT_EQ((*report.positive.axial_torsion)[1].value, 0.0);
  EXPECT_EQ((*report.positive.axial_torsion)[2], report.positive.at_output);
  EXPECT_TRUE(report.deepest);
  EXPECT_NEAR(
      series_compliance<double>(gear).positive_stiffness() / result.positive.stiffness.value, 1,
      1e-14);
  // Beyond the range of the closed form, the result is usable but without stress intensity.
  crack.depth = 11.9 * mm;
  const StiffnessResult deep = torsional_stiffness(gear);
  EXPECT_TRUE(deep.usable()) << deep.unusable_because;
  EXPECT_FALSE(deep.cracks.back().deepest);
  EXPECT_EQ(test::count_notes(deep.notes, "crack.depth_range"), 1);
  EXPECT_TRUE(series_compliance<double>(gear).usable);
}

}  // namespace
}  // namespace strainwave

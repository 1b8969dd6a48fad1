// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/compliance_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "support/compliance_table.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace)
using test::made_up_compliance;
using test::made_up_table;
using test::tabulated_gear;

double positive_at(const ComplianceTable& table, double a) {
  const std::vector<double> at = {table.axes[0].coordinate(a)};
  return interpolated<double>(table.axes, table.positive, at).value;
}

// The estimate (FE-43) must not be smaller than the error of the interpolation (FE-41) between the
// nodes.
TEST(ComplianceTable, CrosscheckErrorCoversTheInterpolation) {
  for (const int nodes : {4, 7, 12, 23}) {
    const ComplianceTable table = made_up_table(nodes);
    double largest = 0.0;
    for (double a = 0.1 * mm; a < 20 * mm; a *= 1.03)
      largest = std::max(largest, std::abs(positive_at(table, a) / made_up_compliance(a) - 1));
    EXPECT_GT(table.positive.interpolation_error, largest) << nodes;
    EXPECT_LT(table.positive.interpolation_error, 60 * largest) << nodes;
    EXPECT_EQ(table.positive.scale, TableValues::Scale::logarithmic);
  }
  // A power law is exact in logarithms, and the points of the table are reproduced.
  ComplianceTable power = made_up_table();
  for (std::size_t i = 0; i < 12; ++i)
    power.positive.values[i] = std::pow(power.axes[0].nodes[i], 2.5);
  power = completed(power);
  EXPECT_LT(power.positive.interpolation_error, 1e-12);
  EXPECT_NEAR(positive_at(power, 3 * mm) / std::pow(3 * mm, 2.5), 1, 1e-12);
  const ComplianceTable table = made_up_table();
  EXPECT_NEAR(positive_at(table, table.axes[0].nodes[4]) / table.positive.values[4], 1, 1e-14);
}

TEST(ComplianceTable, IdentityScales) {
  const ComplianceTable table = made_up_table();
  // 1e-6 of the other sense counts as zero, for either sense.
  EXPECT_EQ(table.negative.scale, TableValues::Scale::nothing);
  ComplianceTable turned = made_up_table();
  turned.positive.scale = turned.negative.scale = TableValues::Scale::linear;
  std::swap(turned.positive, turned.negative);
  turned = completed(turned);
  EXPECT_EQ(turned.positive.scale, TableValues::Scale::nothing);
  EXPECT_EQ(turned.negative.scale, TableValues::Scale::logarithmic);
  EXPECT_EQ(positive_at(turned, 3 * mm), 0.0);
  // A value that is 2e-4 of the other sense makes the sense count; a value that is not positive
  // makes the interpolation linear.
  ComplianceTable signs = made_up_table();
  signs.negative.scale = TableValues::Scale::linear;
  signs.negative.values[11] = 2e-4 * signs.positive.values[11];
  signs.negative.values[3] = -1e-20;
  signs = completed(signs);
  EXPECT_EQ(signs.negative.scale, TableValues::Scale::linear);
  const std::vector<double> at = {signs.axes[0].coordinate(signs.axes[0].nodes[11])};
  const auto end = interpolated<double>(signs.axes, signs.negative, at);
  EXPECT_NEAR(end.value / signs.negative.values[11], 1, 1e-13);
  EXPECT_DOUBLE_EQ(end.relative_error, signs.negative.interpolation_error);
}

TEST(ComplianceTable, CrosscheckTwoAxes) {
  ComplianceTable table = made_up_table(8);
  table.axes.push_back(
      {"wall_thickness", "m", false, {1 * mm, 1.5 * mm, 2 * mm, 2.5 * mm, 3 * mm}});
  const auto law = [](double a, double t) {
    return made_up_compliance(a) * std::exp(-t / (2 * mm));
  };
  table.positive.values.clear();
  for (const double a : table.axes[0].nodes)
    for (const double t : table.axes[1].nodes) table.positive.values.push_back(law(a, t));
  table.negative.values = table.positive.values;
  table.negative.scale = TableValues::Scale::linear;
  table = completed(table);
  const double a = 7 * mm;
  const double t = 2.24 * mm;
  const std::vector<double> at = {std::log(a), t};
  const auto value = interpolated<double>(table.axes, table.positive, at);
  EXPECT_NEAR(value.value / law(a, t), 1, value.relative_error);
  EXPECT_LT(value.relative_error, 0.02);
}

// Every rule of the docstring, broken once.
TEST(ComplianceTable, InputRulesBrokenOnce) {
  EXPECT_NO_THROW(check(tabulated_gear()));
  const auto refused = [](const GearSet& gear, const std::string& words) {
    try {
      check(gear);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_TRUE(std::string(error.field()).starts_with("flexspline.crack[0].compliance_table"));
    }
  };
  GearSet gear = tabulated_gear();
  gear.compliance_tables.clear();
  refused(gear, "has not been read");
  gear = tabulated_gear();
  gear.compliance_tables["made_up.csv"].kind = "annular";
  refused(gear, "is a table of cracks of kind \"annular\", not \"through\"");
  refused(tabulated_gear(0.0999 * mm), "covers 0.1 mm to 40 mm of half_length, but the drive has");
  refused(tabulated_gear(0.0405), "of half_length, but the drive has 40.5 mm");
  gear = tabulated_gear();
  gear.load.axial_force = 1;
  refused(gear, "load.axial_force must be 0");
  gear = tabulated_gear();
  gear.compliance_tables["made_up.csv"].fixed.pop_back();
  refused(gear, "does not state the poissons_ratio of its computation");
  gear = tabulated_gear();
  gear.compliance_tables["made_up.csv"].fixed[3].unit = "N";
  refused(gear, "has length in \"N\", not in \"m\"");
  gear = tabulated_gear();
  gear.compliance_tables["made_up.csv"].axes[0].unit = "rad";
  refused(gear, "has half_length in \"rad\", not in \"m\"");
  for (const double end :
       {made_up_table().axes[0].nodes.front(), made_up_table().axes[0].nodes.back()})
    EXPECT_NO_THROW(check(tabulated_gear(end))) << end;
  for (const auto& [name, unit, value] : made_up_table().fixed) {
    gear = tabulated_gear();
    for (const double factor : {1 + 2e-6, 1 - 2e-6}) {  // larger, smaller
      for (TableParameter& fixed : gear.compliance_tables["made_up.csv"].fixed)
        if (fixed.name == name) fixed.value = value * factor;
      refused(gear, "was made with " + name);
    }
    for (TableParameter& fixed : gear.compliance_tables["made_up.csv"].fixed)
      if (fixed.name == name) fixed.value = value * (1 + 5e-7);
    EXPECT_NO_THROW(check(gear)) << name;
  }
}

TEST(ComplianceTable, ReferenceParametersOfBothKinds) {
  GearSet gear = test::article_gear();
  const auto shaft =
      crack_parameters(Lift<double>(), gear, std::get<AnnularCrack>(gear.output_shaft->crack[0]));
  ASSERT_EQ(shaft.size(), 6U);
  EXPECT_EQ(shaft[2].name, "inner_diameter");
  EXPECT_EQ(shaft[2].value, 45 * mm);
  // With sections, the tube is that of the section.
  gear.flexspline->crack_free = CrackFree::sections;
  gear.flexspline->barrel = {
      .outer_diameter = 150 * mm, .wall_thickness = 1 * mm, .length = 90 * mm};
  const auto wall =
      crack_parameters(Lift<double>(), gear, std::get<WallThroughCrack>(gear.flexspline->crack[0]));
  ASSERT_EQ(wall.size(), 7U);
  EXPECT_EQ(wall[2].value, 150 * mm);
  EXPECT_EQ(wall[3].value, 1 * mm);
  EXPECT_EQ(wall[4].value, 90 * mm);
}

}  // namespace
}  // namespace strainwave

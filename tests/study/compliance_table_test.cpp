// SPDX-License-Identifier: Apache-2.0 The supplied table of finite elements in the stiffness of its
// example.
#include "strainwave/model/input/compliance_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/study/evaluate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

GearSet tabulated() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/tabulated_crack.toml"); }

Quantity added_at(GearSet gear, double half_length) {
  std::get<WallThroughCrack>(gear.flexspline->crack.at(0)).half_length = half_length;
  const StiffnessResult result = evaluate(gear, Method::corrected);
  EXPECT_TRUE(result.usable()) << result.unusable_because;
  return result.cracks.at(0).positive.at_output;
}

// 10 mm lies between two points of the table: `strainwave fe examples/through_crack.toml`, order 3,
// 24324 unknowns, computed separately, gives 1.09964e-9 rad/(N*m).
TEST(ShippedTable, ReferenceBetweenItsPoints) {
  const Quantity added = added_at(tabulated(), 10e-3);
  const double fresh = 1.0996449700e-9;
  EXPECT_NEAR(added.value / fresh, 1, *added.relative_uncertainty);
  EXPECT_LT(*added.relative_uncertainty, 0.005);
  // The interpolation alone is far better than the stated error.
  EXPECT_NEAR(added.value / fresh, 1, 2e-4);
}

// Both agree within their stated errors.
TEST(ShippedTable, CrosscheckClosedForm) {
  GearSet gear = tabulated();
  const Quantity tabulated = added_at(gear, 6e-3);
  std::get<WallThroughCrack>(gear.flexspline->crack.at(0)).compliance_table.reset();
  const Quantity closed_form = added_at(gear, 6e-3);
  EXPECT_NEAR(tabulated.value / closed_form.value, 1,
              std::hypot(*tabulated.relative_uncertainty, *closed_form.relative_uncertainty));
}

TEST(ShippedTable, InputArticleMethodsSayThatTheyDoNotReadIt) {
  GearSet gear = tabulated();
  EXPECT_EQ(test::count_notes(evaluate(gear, Method::corrected).notes, "crack.compliance_table"),
            1);
  EXPECT_EQ(test::count_notes(evaluate(gear, Method::repaired).notes, "article.compliance_table",
                              "flexspline.crack[0].compliance_table"),
            1);
}

}  // namespace
}  // namespace strainwave

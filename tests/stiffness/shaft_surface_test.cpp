// SPDX-License-Identifier: Apache-2.0
//
// Surface cracks of an output shaft in the sum of the members.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "stiffness/members_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/stiffness/accuracy.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

/// A long shaft of 70 mm with a surface crack.
GearSet surface_in_shaft(double inner_diameter, double depth, double half_length) {
  GearSet gear = test::article_gear(1 * mm);
  gear.output_shaft->length = 300 * mm;
  gear.output_shaft->inner_diameter = inner_diameter;
  gear.output_shaft->crack = {ShaftSurfaceCrack{.depth = depth, .half_length = half_length}};
  return gear;
}

bool has_surface_note(const GearSet& gear, const std::string& code) {
  const MemberCompliance member = output_shaft_compliance(gear);
  return std::ranges::any_of(member.notes, [&](const Note& note) { return note.code == code; });
}

TEST(ShaftSurfaceStiffness, IdentityBothSensesOfTorque) {  // FR-22
  for (const double inner : {0.0, 45 * mm}) {
    GearSet gear = surface_in_shaft(inner, 4 * mm, 6 * mm);
    const StiffnessResult plus = torsional_stiffness(gear);
    gear.load.torque = -gear.load.torque;
    const StiffnessResult minus = torsional_stiffness(gear);
    const CrackReport& a = plus.cracks.back();
    const CrackReport& b = minus.cracks.back();
    EXPECT_EQ(a.positive.at_output.value, a.negative.at_output.value);
    EXPECT_EQ(a.positive.at_output.value, b.positive.at_output.value);
    EXPECT_EQ(a.largest->K_III.value, -b.largest->K_III.value);
    EXPECT_EQ(a.kind, "surface");
  }
}

TEST(ShaftSurfaceStiffness, IdentityForceOpensOrCloses) {  // FR-17, FR-22
  GearSet gear = surface_in_shaft(0.0, 4 * mm, 6 * mm);
  const auto entries_at = [&](double P) {
    gear.load.axial_force = P;
    return test::entries(output_shaft_compliance(gear).cracks.at(0).positive);
  };
  const auto pulled = entries_at(1e4);
  const auto pushed = entries_at(-1e4);
  EXPECT_GT(pulled[0], 0.0);
  EXPECT_EQ(pushed[0], 0.0);
  EXPECT_EQ(pulled[1], 0.0);
  EXPECT_EQ(pulled[2], pushed[2]);
  EXPECT_TRUE(has_surface_note(gear, "crack.closed"));
}

TEST(ShaftSurfaceStiffness, LimitSmallCrackAndBoundByTheAnnularCrack) {  // FR-22, FR-14
  // The compliance falls with the cube of the size, and a crack on one side adds less than a crack
  // of its depth all round.
  for (const double inner : {0.0, 45 * mm}) {
    const auto added = [&](double scale) {
      return output_shaft_compliance(surface_in_shaft(inner, scale * 4 * mm, scale * 6 * mm))
          .cracks.at(0)
          .positive.at_output.value;
    };
    test::expect_relative(added(1e-4) / added(2e-4), 1.0 / 8, 1e-3);
    GearSet all_round = surface_in_shaft(inner, 4 * mm, 6 * mm);
    all_round.output_shaft->crack = {AnnularCrack{.depth = 4 * mm}};
    EXPECT_LT(added(1), output_shaft_compliance(all_round).cracks.at(0).positive.at_output.value);
  }
}

TEST(ShaftSurfaceStiffness, BehaviourNotesOutsideTheRange) {  // SB-7, SB-10, FR-22
  EXPECT_FALSE(has_surface_note(surface_in_shaft(0.0, 4 * mm, 6 * mm), "crack.surface_range"));
  EXPECT_TRUE(has_surface_note(surface_in_shaft(0.0, 4 * mm, 40 * mm), "crack.surface_range"));
  EXPECT_FALSE(has_surface_note(surface_in_shaft(45 * mm, 4 * mm, 6 * mm), "crack.surface_range"));
  for (const GearSet& gear :
       {surface_in_shaft(45 * mm, 4 * mm, 12 * mm), surface_in_shaft(45 * mm, 8 * mm, 10 * mm),
        surface_in_shaft(30 * mm, 4 * mm, 6 * mm), surface_in_shaft(65 * mm, 1 * mm, 2 * mm)}) {
    EXPECT_TRUE(has_surface_note(gear, "crack.surface_range"));
    EXPECT_EQ(output_shaft_compliance(gear).cracks.at(0).positive.at_output.relative_uncertainty,
              accuracy::kShaftSurfaceExtrapolated);
  }
  GearSet other = surface_in_shaft(0.0, 4 * mm, 6 * mm);
  other.material.at(other.output_shaft->material).poissons_ratio = 0.4;
  other.material.at(other.output_shaft->material).shear_modulus.reset();
  EXPECT_TRUE(has_surface_note(other, "crack.poissons_ratio"));
  GearSet short_shaft = surface_in_shaft(0.0, 4 * mm, 6 * mm);
  EXPECT_FALSE(has_surface_note(short_shaft, "crack.short_shaft"));
  short_shaft.output_shaft->length = 100 * mm;
  EXPECT_TRUE(has_surface_note(short_shaft, "crack.short_shaft"));
}

TEST(ShaftSurfaceStiffness, BehaviourNothingLeft) {  // SB-10
  const MemberCompliance member =
      output_shaft_compliance(surface_in_shaft(45 * mm, 12 * mm, 14 * mm));
  EXPECT_NE(member.unusable_because.find("output_shaft.crack[0]"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

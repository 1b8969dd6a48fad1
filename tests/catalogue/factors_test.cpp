// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/factors.hpp"

#include <gtest/gtest.h>

#include <string>

#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/flank.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::broken_rule;

constexpr Factor kAll[] = {Factor::support,         Factor::coning,    Factor::gap_factor,
                           Factor::pair_compliance, Factor::structure, Factor::clearance,
                           Factor::cam_flattening};

TEST(Factors, IdentityOwnValueChangesNothing) {
  const GearSet gear = typical_drive(0.0635, 100);
  const MakersLines before = makers_lines(gear, +1, {.harmonics = 8});
  for (const Factor factor : kAll) {
    const MakersLines after =
        makers_lines(with_factor(gear, factor, factor_value(gear, factor)), +1, {.harmonics = 8});
    test::expect_relative(after.K1, before.K1, 1e-9);  // Newton's tolerance
    test::expect_relative(after.K3, before.K3, 1e-9);
  }
}

/// A larger value of any factor makes the middle of the curve softer; clearance and cam act through
/// the balls.
TEST(Factors, IdentityMoreIsSofter) {
  const GearSet gear = typical_drive(0.0635, 100);
  for (const Factor factor : kAll) {
    const FactorInfo& info = factor_info(factor);
    const MakersLines low =
        makers_lines(with_factor(gear, factor, info.lower), +1, {.harmonics = 8});
    const MakersLines high =
        makers_lines(with_factor(gear, factor, info.upper), +1, {.harmonics = 8});
    EXPECT_GT(low.K1, high.K1) << enum_name(factor);
    EXPECT_LE(info.least, info.lower) << enum_name(factor);
    EXPECT_GE(info.most, info.upper) << enum_name(factor);
  }
}

TEST(Factors, BehaviourFieldsThatChange) {
  const GearSet gear = typical_drive(0.0635, 100);
  const GearSet walls = with_factor(gear, Factor::structure, 2.0);
  test::expect_relative(walls.flexspline->barrel->wall_thickness,
                        gear.flexspline->barrel->wall_thickness / 2, 1e-14);
  test::expect_relative(walls.flexspline->diaphragm->thickness,
                        gear.flexspline->diaphragm->thickness / 2, 1e-14);
  const GearSet pair = with_factor(gear, Factor::pair_compliance, 2.0);
  test::expect_relative(pair.mesh->pair_stiffness.value(), drive_pair_stiffness(gear) / 2, 1e-14);
  // Without drawn teeth the stiffness is that of (TC-9).
  GearSet plain = gear;
  plain.mesh->tooth.reset();
  test::expect_relative(
      drive_pair_stiffness(plain),
      tooth_pair_stiffness(206e9, 0.0635 / 200, gear.flexspline->rim->wall_thickness), 1e-14);
  test::expect_relative(
      with_factor(pair, Factor::pair_compliance, 3.0).mesh->pair_stiffness.value(),
      *pair.mesh->pair_stiffness / 3, 1e-14);
  const GearSet play = with_factor(gear, Factor::clearance, 0.01);
  test::expect_relative(play.wave_generator->bearing->clearance,
                        0.01 * gear.drive.radial_displacement, 1e-14);
  EXPECT_EQ(factor_value(play, Factor::clearance), 0.01);
  EXPECT_EQ(factor_value(with_factor(gear, Factor::support, 0.2), Factor::support), 0.2);
  EXPECT_EQ(factor_value(with_factor(gear, Factor::cam_flattening, 1.5), Factor::cam_flattening),
            1.5);
}

TEST(Factors, InputRefusals) {
  GearSet gear = typical_drive(0.0635, 100);
  const auto refuses = [&](Factor factor, const std::string& field) {
    const std::string message = broken_rule([&] { return factor_value(gear, factor); });
    EXPECT_NE(message.find(field + ": must be given for the factor"), std::string::npos) << message;
    EXPECT_NE(broken_rule([&] { return with_factor(gear, factor, 1.0); }), "no error");
  };
  gear.circular_spline.reset();
  refuses(Factor::support, "circular_spline");
  gear.flexspline->diaphragm.reset();
  refuses(Factor::structure, "flexspline.diaphragm");
  gear.flexspline->barrel.reset();
  refuses(Factor::structure, "flexspline.barrel");
  gear.flexspline->rim.reset();
  refuses(Factor::pair_compliance, "flexspline.rim");
  gear.mesh.reset();
  refuses(Factor::coning, "mesh");
  refuses(Factor::gap_factor, "mesh");
  refuses(Factor::pair_compliance, "mesh");
  gear.wave_generator->cam =
      Cam{.profile = CamProfile::ellipse, .arc_angle = {}, .disc_offset = {}, .point = {}};
  EXPECT_NE(broken_rule([&] {
              return with_factor(gear, Factor::cam_flattening, 1.0);
            }).find("wave_generator.cam: must be left out"),
            std::string::npos);
  gear.wave_generator->bearing.reset();
  refuses(Factor::clearance, "wave_generator.bearing");
  gear.wave_generator.reset();
  refuses(Factor::cam_flattening, "wave_generator");
}

TEST(FactorList, InputNames) {
  EXPECT_EQ(factor_names(parse_factors("support, gap_factor")), "support, gap_factor");
  EXPECT_NE(broken_rule([] { return parse_factors("suport"); }).find("\"suport\" is not one of"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return parse_factors("support,support"); }).find("twice"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return parse_factors(""); }).find("is not one of"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

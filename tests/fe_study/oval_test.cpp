// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/oval_run.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave::fe_study {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

GearSet oval_drive() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml"); }

// (FE-52) Kind: identity and closed form.  The torque of a round cup changes the shear alone, in
// the middle of the barrel by T rho/J within 1 %, and at the rim's end by nothing.  The rim cones
// by about w_0 over the distance to the diaphragm.
TEST(FeOval, IdentityTorqueAndCone) {
  const OvalRun run = run_oval(oval_drive(), {.torques = {48, 0}});
  EXPECT_TRUE(run.usable) << run.reason;
  EXPECT_GT(run.order_difference, 0);
  EXPECT_LT(run.equilibrium_residual, 1e-5);
  EXPECT_TRUE(run.contact.large_rotations);
  EXPECT_GT(run.rotation_stress, 1 * MPa);
  EXPECT_LT(run.rotation_stress, 10 * MPa);
  EXPECT_NEAR(run.coning_angle / (0.3175 / 21.95), 1, 0.06);
  ASSERT_EQ(run.torques.size(), 2U);
  ASSERT_EQ(run.torques[0].stations.size(), 54U);
  const double outer = 62.499 * mm / 2;
  const double J = pi / 2 * (std::pow(outer, 4) - std::pow(outer - 0.453 * mm, 4));
  double largest = 0;
  int middle = 0;
  for (std::size_t i = 0; i < run.torques[0].stations.size(); ++i) {
    const OvalStation& none = run.torques[0].stations[i];
    const OvalStation& loaded = run.torques[1].stations[i];
    EXPECT_NEAR(none.shear.largest, -none.shear.least, 1e-3 * MPa);
    EXPECT_NEAR(loaded.hoop.largest, none.hoop.largest, 0.1 * MPa);
    EXPECT_GE(loaded.equivalent.largest, 0.99 * std::abs(loaded.shear.largest) * std::sqrt(3.0));
    largest = std::max(largest, loaded.equivalent.largest);
    if (none.part == WallPart::barrel && std::abs(none.at - 8.6 * mm) < 0.01 * mm) {
      ++middle;
      const double rho = none.face == "outer" ? outer : outer - 0.453 * mm;
      test::expect_relative(loaded.shear.largest - none.shear.largest, 48 * rho / J, 0.01);
    }
  }
  EXPECT_EQ(middle, 2);
  EXPECT_EQ(std::ranges::count(run.notes, "fe.oval_model", &Note::code), 1);
  EXPECT_EQ(run.largest(), largest);
  const std::string text = oval_text(run, oval_drive());
  EXPECT_NE(text.find("unknowns for each number of waves, usable"), std::string::npos) << text;
  EXPECT_NE(text.find("torque +48 N*m"), std::string::npos);
  const std::string csv = oval_csv(run);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 54);
  EXPECT_NE(oval_plot(run, oval_drive()).find("Stress round the axis"), std::string::npos);
}

// A coarse section is not usable, and the answer says what to do.  What is not applied is noted.
TEST(FeOval, BehaviourOfTheChecks) {
  GearSet gear = oval_drive();
  gear.load.axial_force = 100;
  gear.flexspline->stress_nonuniformity = 1.2;
  const OvalRun run = run_oval(gear, {.large_rotations = LargeRotations::off}, 4);
  EXPECT_FALSE(run.large_rotations);
  EXPECT_EQ(run.rotation_stress, 0);
  EXPECT_FALSE(run.usable);
  EXPECT_GT(run.order_difference, gear_fem::kStressTolerance);
  EXPECT_NE(run.reason.find("give a higher order"), std::string::npos) << run.reason;
  EXPECT_EQ(evidence_of(run).unusable_because, run.reason);
  for (const char* const code : {"fe.axial_force", "fe.stress_nonuniformity", "fe.cam_perimeter"})
    EXPECT_EQ(std::ranges::count(run.notes, code, &Note::code), 1) << code;
}

TEST(FeOval, InputRulesBrokenOnce) {
  const auto refused = [](const auto& change, const OvalRequest& request, const std::string& words,
                          std::optional<int> order = std::nullopt) {
    GearSet gear = oval_drive();
    change(gear);
    const std::string message = test::broken_rule([&] { return run_oval(gear, request, order); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  const auto nothing = [](GearSet&) {};
  refused(nothing, {.torques = {std::nan("")}}, "torque");
  refused(nothing, {}, "order", 3);
  refused(nothing, {}, "order", 9);
  refused([](GearSet& gear) { gear.drive.wave_number = 3; }, {}, "drive.wave_number");
  refused([](GearSet& gear) { gear.flexspline->rim.reset(); }, {}, "flexspline.rim");
  refused([](GearSet& gear) { gear.wave_generator->bearing->clearance = 0.4 * mm; }, {},
          "smaller than the bore");
  refused([](GearSet& gear) { gear.flexspline->rim->length = 3 * mm; }, {},
          "must be longer than four walls");
}

}  // namespace
}  // namespace strainwave::fe_study

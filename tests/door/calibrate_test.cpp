// SPDX-License-Identifier: Apache-2.0
// The friction that `calibrate` fits.
#include <gtest/gtest.h>

#include <string>

#include "answers.hpp"

namespace strainwave {
namespace {

/// The joint with a cracked tooth, as text.
/// @param spring  line for [drivetrain]
std::string cracked_joint(const std::string& spring) {
  const std::string heading = "[drivetrain]\n";
  std::string text = test::contents(STRAINWAVE_EXAMPLES "/joint_size25.toml");
  text.insert(text.find(heading) + heading.size(), spring);
  text += R"(
[[mesh.crack]]
kind = "tooth"
stiffness_loss = 0.5
position = "5 deg"
)";
  return text;
}

TEST(CalibrateFriction, IdentityTheComputedCurveOfACrackedDriveChangesNothing) {
  // The four values are those of the sound drive on the maker's lines (MO-14), so neither the
  // computed curve nor the cracks that it contains enter the answer.
  const std::string options =
      R"({"friction": true, "no_load_torque": "195 mN*m", "starting_torque": "69 mN*m", )"
      R"("back_driving_torque": "7.26 N*m", "efficiency": "77 %", "at_torque": "87 N*m"})";
  const auto answer = [&](const std::string& spring) {
    return test::run_command("calibrate", read_drive(cracked_joint(spring), "joint.toml"), options)
        .document("text");
  };
  const std::string by_lines = answer("");
  EXPECT_NE(by_lines.find("simulated"), std::string::npos);
  const std::string by_curve = answer("spring = \"computed\"\n");
  EXPECT_EQ(by_curve.substr(0, by_curve.find("Notes")), by_lines.substr(0, by_lines.find("Notes")));
}

}  // namespace
}  // namespace strainwave

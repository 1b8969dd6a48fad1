// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_turn/drive_oval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

GearSet breathing_cup() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml"); }

/// The station of a part nearest to a place.
const OvalStation& station_at(const LoadedOval& loaded, WallPart part, double at,
                              std::string_view face) {
  const OvalStation* nearest = nullptr;
  for (const OvalStation& station : loaded.stations)
    if (station.part == part && station.face == face &&
        (nearest == nullptr || std::abs(station.at - at) < std::abs(nearest->at - at)))
      nearest = &station;
  return *nearest;
}

// Kind: closed form.  Source: an inextensional cone, whose wall bends by 3 w z/(L r^2): the hoop
// stress E t 3 w_0/(2 (1 - nu^2) r^2) in the middle of the rim, whose cam presses all round.
// Tolerance 6 %: the stretch of the rim by the cam and the curvature along the axis.
TEST(DriveOval, LimitBendingOfTheRim) {
  GearSet gear = breathing_cup();
  gear.wave_generator->cam_perimeter_excess = 0.02 * mm;
  const DriveOval oval = drive_oval(gear, {.torques = {0}, .large_rotations = LargeRotations::off});
  EXPECT_FALSE(oval.large_rotations);
  EXPECT_EQ(oval.rotation_stress, 0);
  const double t = 0.755 * mm;
  const double r = (62.801 * mm - t) / 2;
  const double bending = 206 * GPa * t * 3 * 0.3175 * mm / (2 * (1 - 0.09) * r * r);
  const OvalStation& outer = station_at(oval.torques[0], WallPart::rim, 21.95 * mm, "outer");
  EXPECT_NEAR(outer.hoop.range() / (2 * bending), 1, 0.06);
  // The outer face is stretched at a lobe, the inner face between the lobes.
  EXPECT_NEAR(outer.hoop.at_largest, 0, 1e-12);
  EXPECT_NEAR(station_at(oval.torques[0], WallPart::rim, 21.95 * mm, "inner").hoop.at_largest,
              pi / 2, 1e-12);
  EXPECT_NEAR(oval.coning_angle / (0.3175 / 21.95), 1, 0.05);
}

// Kind: identity.  The pressure of half the band adds up to the force of a lobe.  Tolerance 2 %:
// the force is that of the waves, the sum that of the angles.
TEST(DriveOval, IdentityForceOfThePressure) {
  const DriveOval oval = drive_oval(breathing_cup());
  ASSERT_EQ(oval.pressure.size(), 25U);
  EXPECT_EQ(oval.pressure.front().angle, 0);
  EXPECT_NEAR(oval.pressure.back().angle, pi / 2, 1e-15);
  const double bore = 62.801 * mm / 2 - 0.755 * mm;
  const double width = 9.2 * mm;
  double force = 0;
  double largest = 0;
  for (std::size_t i = 0; i < oval.pressure.size(); ++i) {
    const auto& [angle, pressure] = oval.pressure[i];
    const double step = pi / 48 * (i == 0 || i + 1 == oval.pressure.size() ? 0.5 : 1.0);
    force += 2 * pressure * std::cos(angle) * step * bore * width;
    largest = std::max(largest, pressure);
    EXPECT_GE(pressure, 0);
  }
  EXPECT_NEAR(force / oval.contact.lobe_force, 1, 0.02);
  EXPECT_EQ(oval.contact.largest_pressure, largest);
}

// Kind: identity.  Without torque the shear is odd about a lobe; torque moves it by T r/J and moves
// nothing else.  The governing station has the largest von Mises stress, which follows from the
// components where one of them is alone.
TEST(DriveOval, IdentityExtremes) {
  const DriveOval oval = drive_oval(breathing_cup(), {.torques = {48, 0}});
  ASSERT_EQ(oval.torques.size(), 2U);
  EXPECT_EQ(oval.torques[0].torque, 0);
  EXPECT_EQ(oval.torques[1].torque, 48);
  ASSERT_EQ(oval.torques[0].stations.size(), oval.torques[1].stations.size());
  const double outer = 62.499 * mm / 2;
  const double J = pi / 2 * (std::pow(outer, 4) - std::pow(outer - 0.453 * mm, 4));
  double largest = 0;
  for (std::size_t i = 0; i < oval.torques[0].stations.size(); ++i) {
    const OvalStation& none = oval.torques[0].stations[i];
    const OvalStation& loaded = oval.torques[1].stations[i];
    EXPECT_NEAR(none.shear.largest, -none.shear.least, 1e-6 * MPa);
    EXPECT_EQ(none.hoop.largest, loaded.hoop.largest);
    EXPECT_EQ(none.meridional.least, loaded.meridional.least);
    EXPECT_NEAR(loaded.shear.range(), none.shear.range(), 1e-6 * MPa);
    EXPECT_GE(loaded.equivalent.least, 0);
    largest = std::max(largest, loaded.equivalent.largest);
    if (none.part == WallPart::barrel && none.face == "outer") {
      test::expect_relative(loaded.shear.largest - none.shear.largest, 48 * outer / J, 1e-9);
    }
    if (none.part == WallPart::rim && none.at > 26.69 * mm) {  // no teeth beyond, so no torque
      EXPECT_NEAR(loaded.shear.largest, none.shear.largest, 1);
    }
  }
  EXPECT_EQ(oval.largest(), largest);
  EXPECT_EQ(oval.governing().part, WallPart::diaphragm);
  EXPECT_NEAR(oval.governing().at, 18.4 * mm, 1e-9);
  // In the diaphragm the shear of the torque falls with the square of the radius.
  const auto shear = [&](double radius) {
    return station_at(oval.torques[1], WallPart::diaphragm, radius, "inner").shear.largest -
           station_at(oval.torques[0], WallPart::diaphragm, radius, "inner").shear.largest;
  };
  test::expect_relative(shear(18.4 * mm), 48 / (2 * pi * std::pow(18.4 * mm, 2) * 0.762 * mm),
                        1e-9);
}

// Kind: behaviour.  Large rotations are asked for and left out, and the difference is stated.
TEST(DriveOval, BehaviourLargeRotations) {
  const DriveOval large = drive_oval(breathing_cup());
  EXPECT_TRUE(large.large_rotations);
  const DriveOval small = drive_oval(breathing_cup(), {.large_rotations = LargeRotations::off});
  EXPECT_FALSE(small.large_rotations);
  EXPECT_EQ(small.rotation_stress, 0);
  // The components of the shells, seen directly.
  const GearSet gear = breathing_cup();
  const auto shell = [&](LargeRotations rotations) {
    return oval_shell(shell_cup(gear), cam_fit(gear),
                      {.large_rotations = rotations, .whole_meridian = true});
  };
  const OvalShell bent = shell(LargeRotations::on);
  const OvalShell straight = shell(LargeRotations::off);
  double change = 0;
  for (std::size_t i = 0; i < large.torques[0].stations.size(); i += 2)
    for (const double zeta : {-1.0, 1.0})
      for (int j = 0; j < 36; ++j) {
        const auto& [part, at] =
            std::pair(large.torques[0].stations[i].part, large.torques[0].stations[i].at);
        const WallStress a = bent.stress(bent.at(part, at), zeta, pi * j / 36, 0);
        const WallStress b = straight.stress(straight.at(part, at), zeta, pi * j / 36, 0);
        change = std::max({change, std::abs(a.hoop - b.hoop), std::abs(a.axial - b.axial),
                           std::abs(a.shear - b.shear)});
      }
  test::expect_relative(large.rotation_stress, change, 1e-9);
  double difference = 0;
  for (std::size_t i = 0; i < large.torques[0].stations.size(); ++i)
    difference = std::max(difference, std::abs(large.torques[0].stations[i].hoop.largest -
                                               small.torques[0].stations[i].hoop.largest));
  EXPECT_GT(large.rotation_stress, difference * (1 - 1e-3));
  EXPECT_LT(large.rotation_stress, 10 * MPa);
  EXPECT_GT(difference, 1 * MPa);
  EXPECT_EQ(drive_oval(breathing_cup(), {.large_rotations = LargeRotations::on}).largest(),
            large.largest());
}

TEST(DriveOval, InputRulesBrokenOnce) {
  const auto refused = [](const GearSet& gear, const OvalRequest& request,
                          const std::string& words) {
    const std::string message = test::broken_rule([&] { return drive_oval(gear, request); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  refused(breathing_cup(), {.torques = {std::nan("")}}, "torque");
  GearSet gear = breathing_cup();
  gear.drive.wave_number = 3;
  refused(gear, {}, "drive.wave_number");
  gear = breathing_cup();
  gear.wave_generator->bearing->clearance = 0.4 * mm;
  refused(gear, {}, "smaller than the bore");
  gear = breathing_cup();
  gear.load.torque = std::nan("");
  refused(gear, {}, "load.torque");
  gear = breathing_cup();
  gear.flexspline->crack.clear();  // a sound drive is enough
  EXPECT_NO_THROW((void)drive_oval(gear));
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "turn.cam_perimeter"), 1);
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "oval.model"), 1);
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "oval.boss"), 0);
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "oval.profile"), 0);
  gear.flexspline->boss =
      Boss{{.outer_diameter = 36.8 * mm, .wall_thickness = 6 * mm, .length = 4 * mm}};
  gear.flexspline->diaphragm->profile = {{20 * mm, 1.2 * mm}, {26 * mm, 0.762 * mm}};
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "oval.boss"), 1);
  EXPECT_EQ(test::count_notes(drive_oval(gear).notes, "oval.profile"), 1);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// The report on the laminates of a flexspline.
#include "strainwave/study/laminate_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/laminate/ply_failure.hpp"
#include "strainwave/layouts/laminate.hpp"
#include "strainwave/study/evaluate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

std::string drive(const std::string& plies, const std::string& more = "") {
  return "format = \"strainwave-drive/1\"\n"
         "[material.steel]\nyoungs_modulus = \"208 GPa\"\npoissons_ratio = 0.3\n"
         "yield_strength = \"900 MPa\"\n"
         "[material.tube]\n" +
         plies +
         "[drive]\nratio = 100\npitch_diameter = \"81.3 mm\"\nradial_displacement = \"0.4 mm\"\n"
         "[load]\ntorque = \"137 N*m\"\n"
         "[flexspline]\nmaterial = \"steel\"\nshape = \"cylinder\"\ncrack_free = \"sections\"\n"
         "[flexspline.barrel]\nmaterial = \"tube\"\nouter_diameter = \"81.1 mm\"\n"
         "wall_thickness = \"1.2 mm\"\nlength = \"45 mm\"\n"
         "[flexspline.rim]\nouter_diameter = \"81.3 mm\"\nwall_thickness = \"1.3 mm\"\n"
         "length = \"15 mm\"\n" +
         more;
}

std::string ply(const std::string& material, const std::string& angle, const std::string& t) {
  return "[[material.tube.ply]]\nmaterial = \"" + material + "\"\nangle = \"" + angle +
         "\"\nthickness = \"" + t + "\"\n";
}

const std::string kAnglePly = "stacking = \"symmetric\"\n" + ply("T300/5208", "45 deg", "0.3 mm") +
                              ply("T300/5208", "-45 deg", "0.3 mm");

LaminateReport report_of(const std::string& text) {
  return laminate_report(read_gear_set(text, "drive.toml"));
}

bool has(const LaminateReport& report, const std::string& code) {
  return std::ranges::any_of(report.notes, [&](const Note& note) { return note.code == code; });
}

// Kind: reference (LA-4), (LA-5), (LA-14).  Moduli of +-45 degrees; the stress of a ply under pure
// shear: sigma_1 = tau (Q11 - Q22)/(2 G), by hand.  Tolerance: 1e-6, the digits of the modulus.
TEST(LaminateReport, ReferenceAnglePlyTube) {
  const LaminateReport report = report_of(drive(kAnglePly));
  ASSERT_EQ(report.walls.size(), 1U);
  const LaminateWall& wall = report.walls.front();
  EXPECT_EQ(wall.path, "flexspline.barrel");
  test::expect_relative(wall.G_xy, 46.590862e9, 1e-7);
  test::expect_relative(wall.E_x, wall.E_y, 1e-12);
  EXPECT_TRUE(wall.symmetric);
  EXPECT_TRUE(wall.balanced);
  ASSERT_EQ(wall.plies.size(), 4U);
  const double r = 39.95 * mm;
  const double tau = 137 / (2 * 3.141592653589793 * r * r * 1.2 * mm);
  // Plies at +45 degrees are pressed along their fibres.
  const double along = -tau * (181.811139 - 2.896924) / 2 / 46.590862;
  test::expect_relative(wall.plies[0].load_along, along, 1e-6);
  test::expect_relative(wall.plies[1].load_along, -along, 1e-6);
  EXPECT_NEAR(wall.plies[0].load_shear, 0, 1);
  test::expect_relative(*wall.compliance, 45 * mm / *wall.torsional_rigidity, 1e-12);
  EXPECT_EQ(wall.first_ply, 1);
  EXPECT_TRUE(report.reserve && *report.reserve > 1);
  EXPECT_NE(report.sentence.find("Ply 1 of flexspline.barrel fails first, at"), std::string::npos);
}

// Kind: identity (LA-14).  At the reserve times the load, the reserve is 1; the sense of the torque
// does not matter; a pressed first ply is found where the other sense would be safe.
TEST(LaminateReport, IdentityReserveScalesTheLoad) {
  const GearSet gear = read_gear_set(drive(kAnglePly), "drive.toml");
  const double reserve = laminate_report(gear).reserve.value();
  GearSet loaded = gear;
  loaded.load.torque *= reserve;
  test::expect_relative(laminate_report(loaded).reserve.value(), 1, 1e-9);
  loaded.load.torque *= 1.01;
  EXPECT_LT(laminate_report(loaded).reserve.value(), 1);
  EXPECT_TRUE(has(laminate_report(loaded), "laminate.fails"));
  loaded = gear;
  loaded.load.torque *= -1;
  test::expect_relative(laminate_report(loaded).reserve.value(), reserve, 1e-12);
}

// Kind: identity (LA-18).  The place that fails first carries load and assembly; the factor on the
// load makes it fail, and the proportional factor makes both together fail.  A drive without
// deflection has one factor.  Tolerance: rounding.
TEST(LaminateReport, IdentityPlyUnderLoadAndAssembly) {
  GearSet gear = read_gear_set(drive(kAnglePly), "drive.toml");
  const LaminaStrength strength = gear.material.at("T300/5208").ply_strength.value();
  const LaminateReport report = laminate_report(gear);
  for (const PlyState& ply : report.walls.front().plies) {
    ASSERT_NE(ply.worst_sense, 0);
    EXPECT_TRUE(ply.worst_face == "inner" || ply.worst_face == "outer");
    // The load of the sense that governs, and the assembly there.
    const double sense = ply.worst_sense;
    const LaminaStress load{sense * ply.load_along, sense * ply.load_across,
                            sense * ply.load_shear};
    const LaminaStress bent{ply.worst_along - load.along, ply.worst_across - load.across,
                            ply.worst_shear - load.shear};
    test::expect_relative(std::abs(bent.along), ply.assembly_along, 1e-9);
    test::expect_relative(std::abs(bent.across), ply.assembly_across, 1e-9);
    test::expect_relative(tsai_wu_factor(bent, load, strength).value(), *ply.tsai_wu, 1e-9);
    const LaminaStress both{ply.worst_along, ply.worst_across, ply.worst_shear};
    EXPECT_LE(*ply.proportional, tsai_wu_factor({}, both, strength).value() * (1 + 1e-12));
    EXPECT_TRUE(ply.worst_angle == 0 || std::abs(ply.worst_angle - std::numbers::pi / 2) < 1e-12);
  }
  EXPECT_LT(*report.walls.front().proportional, *report.walls.front().reserve);
  EXPECT_GT(*report.walls.front().proportional, 1);
  GearSet flat = gear;
  flat.drive.radial_displacement = 1e-15;
  const LaminateReport round = laminate_report(flat);
  test::expect_relative(*round.walls.front().proportional, *round.walls.front().reserve, 1e-9);
  // Load and deflection grow together to the proportional factor.
  GearSet grown = gear;
  grown.load.torque *= *report.walls.front().proportional;
  grown.drive.radial_displacement *= *report.walls.front().proportional;
  test::expect_relative(laminate_report(grown).walls.front().reserve.value(), 1, 1e-9);
}

const std::string kEnduring =
    "[material.layer]\nbased_on = \"T300/5208\"\n[material.layer.ply_endurance]\n"
    "fibre = \"600 MPa\"\ntransverse = \"16 MPa\"\nshear = \"30 MPa\"\n";

// Kind: identity (LA-19).  The share over a turn is that of the largest amplitude of the assembly
// and of the worse sense of the load; at the factor on the load it is 1.  Tolerance: rounding.
TEST(LaminateReport, IdentityEnduranceOverATurn) {
  GearSet gear =
      read_gear_set(drive("stacking = \"symmetric\"\n" + ply("layer", "45 deg", "0.3 mm") +
                          ply("layer", "-45 deg", "0.3 mm") + kEnduring),
                    "drive.toml");
  gear.drive.radial_displacement *= 0.5;
  gear.load.torque *= 0.3;
  const LaminateReport report = laminate_report(gear);
  const Material& layer = gear.material.at("layer");
  double most = 0.0;
  double least = 1e9;
  for (const PlyState& of : report.walls.front().plies) {
    double share = 0.0;
    for (const double sense : {1.0, -1.0})
      share = std::max(
          share,
          ply_endurance({of.assembly_along, of.assembly_across, of.assembly_shear},
                        {sense * of.load_along, sense * of.load_across, sense * of.load_shear},
                        *layer.ply_strength, *layer.ply_endurance)
              .utilisation());
    test::expect_relative(*of.haigh, share, 1e-9);
    most = std::max(most, share);
    least = std::min(least, *of.haigh_factor);
  }
  test::expect_relative(*report.haigh, most, 1e-12);
  EXPECT_LT(most, 1);
  EXPECT_FALSE(has(report, "laminate.no_endurance"));
  EXPECT_FALSE(has(report, "laminate.fatigue"));
  EXPECT_NE(report.sentence.find("Over a turn the plies use 0."), std::string::npos)
      << report.sentence;
  gear.load.torque *= least;
  test::expect_relative(*laminate_report(gear).haigh, 1, 1e-9);
  gear.load.torque *= 1.01;
  EXPECT_TRUE(has(laminate_report(gear), "laminate.fatigue"));
  const LaminateReport silent = report_of(drive(kAnglePly));
  EXPECT_FALSE(silent.haigh);
  EXPECT_TRUE(has(silent, "laminate.no_endurance"));
  EXPECT_FALSE(silent.walls.front().plies.front().haigh_factor);
}

// Kind: input.  An endurance belongs to a layer with strengths, which exceed it.
TEST(LaminateReport, InputEndurance) {
  const auto refused = [](const std::string& more) {
    return test::broken_rule([&] { (void)report_of(drive(kAnglePly, more)); });
  };
  const std::string values = "fibre = \"600 MPa\"\ntransverse = \"16 MPa\"\nshear = \"30 MPa\"\n";
  EXPECT_NE(refused("[material.other]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
                    "[material.other.ply_endurance]\n" +
                    values)
                .find("ply_endurance: is read only beside transverse_modulus"),
            std::string::npos);
  EXPECT_NE(refused("[material.other]\nyoungs_modulus = \"45 GPa\"\ntransverse_modulus = \"16 "
                    "GPa\"\nshear_modulus = \"6 GPa\"\npoissons_ratio = 0.28\n"
                    "[material.other.ply_endurance]\n" +
                    values)
                .find("ply_endurance: needs ply_strength"),
            std::string::npos);
  const std::string base =
      "[material.other]\nbased_on = \"T300/5208\"\n"
      "[material.other.ply_endurance]\n";
  EXPECT_EQ(refused(base + values), "no error");
  for (const auto& [from, to] : {std::pair{"600", "1500"}, {"16", "40"}, {"30", "68"}}) {
    std::string beyond = values;
    beyond.replace(beyond.find(from), std::string(from).size(), to);
    EXPECT_NE(refused(base + beyond).find("the smaller strength of ply_strength"),
              std::string::npos)
        << to;
  }
  std::string on_laminate = kAnglePly;
  on_laminate.insert(on_laminate.size(), "[material.tube.ply_endurance]\n" + values);
  EXPECT_NE(test::broken_rule([&] {
              (void)report_of(drive(on_laminate));
            }).find("ply_endurance: is not read beside ply"),
            std::string::npos);
}

// Kind: limit (LA-12).  A ply of steel fails where von Mises' stress reaches the yield strength;
// without assembly the reserve is yield/(sqrt(3) tau).  Tolerance: 1e-3, the share of the
// curvature.
TEST(LaminateReport, LimitOfSteelPlies) {
  std::string text = drive(ply("steel", "0 deg", "0.6 mm") + ply("T300/5208", "0 deg", "1e-5 mm"));
  text.replace(text.find("\"0.4 mm\""), 8, "\"0.2 mm\"");
  GearSet gear = read_gear_set(text, "drive.toml");
  gear.drive.radial_displacement = 1e-12;
  const LaminateReport report = laminate_report(gear);
  const double r = 39.95 * mm;
  const double tau = 137 / (2 * 3.141592653589793 * r * r * 1.2 * mm);
  test::expect_relative(report.walls.front().plies.front().tsai_wu.value(),
                        900e6 / (std::sqrt(3.0) * tau), 1e-3);
}

// Kind: behaviour.  Notes on what is missing and what is odd.
TEST(LaminateReport, BehaviourNotes) {
  const LaminateReport odd = report_of(
      drive(ply("T300/5208", "30 deg", "0.6 mm") + ply("T300/5208", "-45 deg", "0.7 mm")));
  for (const char* const code :
       {"laminate.unsymmetric", "laminate.unbalanced", "laminate.thickness", "laminate.left_out"})
    EXPECT_TRUE(has(odd, code)) << code;
  EXPECT_GT(std::abs(*odd.walls.front().axial_strain), 1e-7);
  std::string text = drive(ply("layer", "30 deg", "1.2 mm"));
  text +=
      "[material.layer]\nyoungs_modulus = \"45 GPa\"\ntransverse_modulus = \"16 GPa\"\n"
      "shear_modulus = \"6 GPa\"\npoissons_ratio = 0.28\n";
  const LaminateReport unknown = report_of(text);
  EXPECT_TRUE(has(unknown, "laminate.no_strength"));
  EXPECT_FALSE(unknown.reserve);
  EXPECT_NE(unknown.sentence.find("It is not known"), std::string::npos);
  // One tube without strengths leaves the whole reserve unknown.
  GearSet two = read_gear_set(drive(kAnglePly), "drive.toml");
  two.flexspline->rim->material = "tube";
  EXPECT_TRUE(laminate_report(two).reserve);
  two.material["layer"] = two.material.at("T300/5208");
  two.material.at("layer").ply_strength.reset();
  two.material["weak"] = two.material.at("tube");
  for (Ply& ply : two.material.at("weak").ply) ply.material = "layer";
  two.flexspline->rim->material = "weak";
  EXPECT_FALSE(laminate_report(two).reserve);
  EXPECT_FALSE(has(report_of(drive(kAnglePly)), "laminate.thickness"));
  GearSet one = read_gear_set(drive(kAnglePly), "drive.toml");
  one.drive.wave_number = 1;
  EXPECT_TRUE(has(laminate_report(one), "laminate.one_lobe"));
  EXPECT_EQ(laminate_report(one).walls.front().plies.front().assembly_along, 0);
  GearSet cup = read_gear_set(drive(kAnglePly), "drive.toml");
  cup.flexspline->diaphragm = Diaphragm{.outer_diameter = 79.9 * mm,
                                        .inner_diameter = 44 * mm,
                                        .thickness = 2 * mm,
                                        .profile = {},
                                        .material = "tube"};
  EXPECT_TRUE(has(laminate_report(cup), "laminate.bottom"));
  EXPECT_EQ(laminate_report(cup).walls.size(), 2U);
}

// Kind: behaviour (LA-9).  A crack of a laminate keeps its size over the duty, and a note says so.
TEST(LaminateReport, BehaviourCrackDoesNotGrow) {
  const GearSet gear = read_gear_set(
      drive(
          kAnglePly,
          "[[flexspline.crack]]\nkind = \"through\"\nhalf_length = \"3 mm\"\nangle = \"45 deg\"\n"
          "section = \"barrel\"\nshell_correction = false\n"
          "[[duty.block]]\nduration = \"10 s\"\ntorque = \"100 N*m\"\noutput_speed = \"20 rpm\"\n"),
      "drive.toml");
  const GrowthReport growth = grow_cracks(gear);
  EXPECT_TRUE(std::ranges::any_of(growth.notes, [](const Note& note) {
    return note.code == "growth.laminate" && note.severity == Severity::cannot_tell;
  }));
  EXPECT_FALSE(growth.life);
}

// Kind: behaviour.  A duty does not keep the stiffness of a drive of laminates from its answer; the
// life is left out, and a note says so.
TEST(LaminateReport, BehaviourStiffnessWithADuty) {
  const std::string duty =
      "[[duty.block]]\nduration = \"10 s\"\ntorque = \"100 N*m\"\noutput_speed = \"20 rpm\"\n";
  const StiffnessResult with =
      evaluate(read_gear_set(drive(kAnglePly, duty), "drive.toml"), Method::corrected);
  const StiffnessResult without =
      evaluate(read_gear_set(drive(kAnglePly), "drive.toml"), Method::corrected);
  EXPECT_EQ(with.intact.stiffness.value, without.intact.stiffness.value);
  EXPECT_FALSE(with.life);
  EXPECT_TRUE(std::ranges::any_of(
      with.notes, [](const Note& note) { return note.code == "life.other_materials"; }));
}

// Kind: input.  A drive without laminates; an angle without its unit; no plies.
TEST(LaminateReport, InputWithoutLaminates) {
  std::string text = drive(kAnglePly);
  text.replace(text.find("material = \"tube\""), 17, "material = \"steel\"");
  EXPECT_NE(test::broken_rule([&] { return report_of(text); }).find("names no laminate"),
            std::string::npos);
  std::string bare = drive(kAnglePly);
  bare.replace(bare.find("angle = \"45 deg\""), 16, "angle = 45");
  EXPECT_NE(test::broken_rule([&] { return report_of(bare); }).find("has no unit"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([&] { return report_of(drive("")); }).find("youngs_modulus"),
            std::string::npos);
}

// Kind: behaviour.  The documents contain every ply.
TEST(LaminateReport, BehaviourDocuments) {
  const GearSet gear = read_gear_set(drive(kAnglePly), "drive.toml");
  const LaminateReport report = laminate_report(gear);
  const std::string text = laminate_text(report, gear);
  EXPECT_NE(text.find("Plies of flexspline.barrel, from the inner face"), std::string::npos);
  const std::string csv = laminate_csv(report);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_NE(csv.find(",proportional [1],worst_face,worst_angle [rad],worst_sense,"),
            std::string::npos);
  EXPECT_NE(text.find("Plies of flexspline.barrel under load and assembly (LA-18), (LA-19)"),
            std::string::npos);
  EXPECT_TRUE(has_laminates(gear));
  GearSet metal = gear;
  metal.flexspline->barrel->material.reset();
  EXPECT_FALSE(has_laminates(metal));
  metal.flexspline.reset();
  EXPECT_FALSE(has_laminates(metal));
  EXPECT_NE(laminate_plot(report, gear).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

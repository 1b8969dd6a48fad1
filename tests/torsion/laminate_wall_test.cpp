// SPDX-License-Identifier: Apache-2.0
// A steel rim on a barrel and a bottom of plies in the coupled drive (LA-16), (LA-17).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "coupled_geometry.hpp"
#include "flexspline_wall.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"
#include "torsion/solved_drive.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

Material layer_of(double E1, double E2, double G12, double nu12) {
  Material layer;
  layer.youngs_modulus = E1;
  layer.transverse_modulus = E2;
  layer.shear_modulus = G12;
  layer.poissons_ratio = nu12;
  return layer;
}

Material plies_at(const std::string& material, const std::vector<double>& degrees) {
  Material laminate;
  for (const double angle : degrees)
    laminate.ply.push_back({.material = material, .angle = angle * deg, .thickness = 0.1 * mm});
  return laminate;
}

const std::map<std::string, std::vector<double>> kStacks = {
    {"angle_ply", {45, -45, -45, 45}},
    {"steep", {60, -60, 0, 0, -60, 60}},
    {"cross_ply", {0, 90, 90, 0}},
    {"quasi", {0, 45, -45, 90, 90, -45, 45, 0}},
    {"many", {0, 60, -60, 0, 60, -60, 0, 60, -60, -60, 60, 0, -60, 60, 0, -60, 60, 0}},
    {"steel", {0}}};

/// The typical cup of steel whose barrel and bottom are of plies.
GearSet ply_drive(const std::vector<double>& barrel, const std::vector<double>& bottom) {
  GearSet gear = test::typical_drive(25, 100);
  test::half_free(gear);
  gear.material["carbon"] = layer_of(181 * GPa, 10.3 * GPa, 7.17 * GPa, 0.28);
  gear.material["tube"] = plies_at("carbon", barrel);
  gear.material["plate"] = plies_at("carbon", bottom);
  gear.flexspline->barrel->material = "tube";
  gear.flexspline->diaphragm->material = "plate";
  gear.flexspline->barrel->wall_thickness *= 2;
  gear.flexspline->diaphragm->thickness *= 2;
  gear.flexspline->joint_compliance = 2e-7;
  return gear;
}
GearSet ply_drive() { return ply_drive(kStacks.at("angle_ply"), kStacks.at("quasi")); }

// Kind: crosscheck (LA-16).  Source: tools/reference/laminate_wall.py, a shell of revolution with
// all couplings of A, B and D.  Tolerances: the largest deviations of the table of (LA-16) and half
// of its last digit.
TEST(LaminateWall, CrosscheckShellOfRevolution) {
  // of n = 2, of n = 3 and 6, of the tilt
  const std::map<std::string, std::array<double, 3>> percent = {{"steel", {0.8, 2.7, 1.5}},
                                                                {"angle_ply", {5.7, 3.1, 2.5}},
                                                                {"steep", {0.6, 0.9, 2.2}},
                                                                {"cross_ply", {1.3, 2.2, 1.2}},
                                                                {"quasi", {0.8, 1.3, 1.8}}};
  int compared = 0;
  for (const test::CsvRow& row : test::read_reference_csv("laminate_wall")) {
    const std::string name = row.quantity.substr(
        row.quantity.find('.') + 1, row.quantity.rfind('.') - row.quantity.find('.') - 1);
    const bool tilt = row.quantity.ends_with("tilt");
    const double R = row("radius");
    GearSet gear;
    gear.material["steel"] = {.youngs_modulus = 206 * GPa,
                              .shear_modulus = {},
                              .poissons_ratio = 0.3,
                              .yield_strength = {},
                              .fracture_toughness = {}};
    gear.material["carbon"] = layer_of(181 * GPa, 10.3 * GPa, 7.17 * GPa, 0.28);
    gear.material["tube"] = plies_at(name == "steel" ? "steel" : "carbon", kStacks.at(name));
    Flexspline fs;
    fs.material = "steel";
    const auto tube = [&](const char* part, const char* length) {
      const double t = row(std::string(part) + "_thickness");
      return TubeSection{.outer_diameter = 2 * R + t, .wall_thickness = t, .length = row(length)};
    };
    fs.barrel = tube("barrel", "barrel_length");
    fs.barrel->material = "tube";
    fs.rim = tube("rim", "rim_width");
    const bool open = row.quantity.starts_with("open");
    fs.diaphragm = Diaphragm{.outer_diameter = open ? 2 * R : 2 * row("bottom_outer"),
                             .inner_diameter = open ? R : 2 * row("bottom_inner"),
                             .thickness = open ? 1 * mm : row("bottom_thickness"),
                             .profile = {}};
    gear.flexspline = fs;
    const Lift<double> lift;
    const auto wall = flexspline_wall(fs, lift, R, wall_materials(gear, lift, R), !open);
    const int n = static_cast<int>(row("mode"));
    const auto mode = wall_mode(wall, n);
    const double EI =
        row("ring_bending") + 206 * GPa * row("rim_width") * std::pow(row("rim_thickness"), 3) / 12;
    const double ours = tilt ? mode.tilt
                             : pi * EI / std::pow(R, 3) * (n * n - 1.0) * (n * n - 1.0) +
                                   mode.barrel + mode.diaphragm;
    const double off = 100 * (ours / row.value - 1);
    const std::size_t column = tilt ? 2 : n == 2 ? 0 : 1;
    EXPECT_NEAR(off, 0, percent.at(name)[column] + 0.05) << row.quantity << " n = " << n;
    ++compared;
  }
  EXPECT_EQ(compared, 240);
}

// Kind: crosscheck (LA-17).  Source: tools/reference/laminate_wall.py, a plate whose fibres keep
// their directions, by Rayleigh and Ritz.  Its mean over the directions of the wave lies between
// both means of the bending stiffness.  An isotropic plate meets both.  Tolerance: the digits of
// the source.
TEST(LaminateWall, CrosscheckBottomOfPlies) {
  const Lift<double> lift;
  GearSet gear = ply_drive();
  int between = 0;
  for (const test::CsvRow& row : test::read_reference_csv("laminate_bottom")) {
    const double h = row("thickness");
    gear.material["layer"] = row.quantity == "steel" ? layer_of(208 * GPa, 208 * GPa, 80 * GPa, 0.3)
                                                     : gear.material.at("carbon");
    gear.material["plate"] = plies_at("layer", kStacks.at(row.quantity));
    const auto wall = wall_laminate(lift, gear, gear.material.at("plate"), h).value();
    const auto stiffness = [&](const EvenPlate<>& plate) {
      const double nu = plate.poissons_ratio;
      return plate_edge_stiffness(
          ClampedPlate{.outer_radius = row("outer"),
                       .inner_radius = row("inner"),
                       .thickness = h,
                       .youngs_modulus = 12 * (1 - nu * nu) * plate.bending / (h * h * h),
                       .poissons_ratio = nu},
          static_cast<int>(row("mode")));
    };
    const double upper = stiffness(mean_plate(wall));
    const double lower = stiffness(softest_plate(wall));
    EXPECT_GE(upper, row.value * (1 - 1e-4)) << row.quantity;
    EXPECT_LE(lower, row.value * (1 + 1e-4)) << row.quantity;
    // How close they are, as (LA-17) states.
    const bool even = row.quantity == "steel";
    const bool many = row.quantity == "many";
    EXPECT_LE(upper, row.value * (even ? 1.0001 : many ? 1.011 : 1.107)) << row.quantity;
    EXPECT_GE(lower, row.value * (even ? 0.9999 : many ? 0.952 : 0.625)) << row.quantity;
    ++between;
  }
  EXPECT_EQ(between, 18);
}

// Kind: identity.  Plies with the constants of a steel, which take every road of the laminates, are
// this steel in the whole curve; plies of the steel itself are, to the last bit.  Tolerance: 1e-12.
TEST(LaminateWall, IdentityIsotropicPliesAreTheMetal) {
  GearSet metal = ply_drive();
  metal.flexspline->barrel->material.reset();
  metal.flexspline->diaphragm->material.reset();
  const ElasticConstants steel = elastic_constants(metal.material.at("steel"));
  GearSet layers = ply_drive();
  layers.material["carbon"] = layer_of(steel.E, steel.E, steel.G, steel.nu);
  GearSet plies = ply_drive();
  for (const char* const name : {"tube", "plate"})
    for (Ply& ply : plies.material.at(name).ply) ply.material = "steel";
  const std::array<double, 4> torques = {-40, 3, 30, 70};
  const TorsionCurve of_metal = torsion_curve(metal, torques);
  const TorsionCurve of_layers = torsion_curve(layers, torques);
  const TorsionCurve of_plies = torsion_curve(plies, torques);
  ASSERT_TRUE(of_metal.usable());
  test::expect_relative(of_layers.cam_amplitude, of_metal.cam_amplitude, 1e-12);
  for (std::size_t i = 0; i < torques.size(); ++i) {
    const CurvePoint& expected = of_metal.points[i];
    EXPECT_EQ(of_plies.points[i].twist, expected.twist);
    test::expect_relative(of_layers.points[i].twist, expected.twist, 1e-12);
    test::expect_relative(of_layers.points[i].tangent_compliance, expected.tangent_compliance,
                          1e-12);
    for (std::size_t m = 0; m < expected.share.size(); ++m)
      EXPECT_NEAR(of_layers.points[i].share[m], expected.share[m], 1e-12) << m;
  }
  const MakersLines a = makers_lines(layers);
  const MakersLines b = makers_lines(metal);
  test::expect_relative(a.K1, b.K1, 1e-12);
  test::expect_relative(a.K2, b.K2, 1e-12);
  test::expect_relative(a.K3, b.K3, 1e-12);
}

// Kind: identity (TC-13), (LA-5), (LA-10).  The tube, the bottom and the joint are in series with
// the ring: their shares of the tangent compliance are those of the series model, and a joint that
// yields more adds its compliance alone.  Tolerance: rounding.
TEST(LaminateWall, IdentitySeriesOfRingAndTube) {
  GearSet gear = ply_drive();
  const Lift<double> lift;
  const Flexspline& fs = *gear.flexspline;
  const double t = fs.barrel->wall_thickness;
  const auto tube = plies_of(lift, gear, gear.material.at("tube"));
  const double barrel =
      fs.barrel->length /
      tube_torsion<double>(tube, t, (fs.barrel->outer_diameter - t) / 2).stiffness;
  const CurvePoint small = test::point_at(gear, 0.5);
  test::expect_relative(test::share(small, CurveMember::barrel) * small.tangent_compliance, barrel,
                        1e-11);
  const CurvePoint large = test::point_at(gear, 60);
  test::expect_relative(test::share(large, CurveMember::barrel) * large.tangent_compliance, barrel,
                        1e-11);
  // The whole twist is the rotation of the ring and the members in series: those of the series
  // model, with a third of the rim, and no wave generator.
  const double in_series = (small.twist - small.ring_rotation) / 0.5;
  const MemberCompliance sum = flexspline_compliance(gear);
  const TubeSection& rim = *fs.rim;
  const double whole_rim =
      torsional_compliance(Tube{.outer_diameter = rim.outer_diameter,
                                .inner_diameter = rim.outer_diameter - 2 * rim.wall_thickness,
                                .length = rim.length},
                           elastic_constants(gear.material.at("steel")).G);
  test::expect_relative(in_series, sum.intact - whole_rim * 2 / 3, 1e-10);
  GearSet soft = gear;
  soft.flexspline->joint_compliance += 1e-6;
  EXPECT_NEAR(test::twist(soft, 30) - test::twist(gear, 30), 30e-6, 1e-14);
}

// Kind: behaviour.  A crack of the tube adds the compliance of the series model.
TEST(LaminateWall, IdentityCrackOfTheTubeIsInSeries) {
  GearSet gear = ply_drive();
  const double sound = test::twist(gear, 20);
  gear.flexspline->crack.push_back(
      WallThroughCrack{.half_length = 2 * mm, .angle = 45 * deg, .shell_correction = false});
  const MemberCompliance member = flexspline_compliance(gear);
  const double added = member.cracks.at(0).positive.at_output.value;
  EXPECT_GT(added, 0);
  EXPECT_NEAR(test::twist(gear, 20) - sound, 20 * added, 1e-6 * 20 * added + 1e-14);
}

// Kind: limit (LA-16).  A barrel of plies that nearly have no stiffness leaves the ring alone.
TEST(LaminateWall, LimitSoftBarrelLeavesTheRing) {
  GearSet gear = ply_drive();
  const Lift<double> lift;
  const double R = 31e-3;
  const auto stiffness = [&] {
    const auto mode = wall_mode(
        flexspline_wall(*gear.flexspline, lift, R, wall_materials(gear, lift, R), true), 2);
    return mode.barrel + mode.diaphragm;
  };
  const double full = stiffness();
  gear.material["carbon"] = layer_of(181e3, 10.3e3, 7.17e3, 0.28);
  EXPECT_LT(stiffness(), 1e-4 * full);
  EXPECT_GT(stiffness(), 0);
}

// Kind: behaviour.  The stresses of a wall of plies are not those of a metal; the mean shear stays.
TEST(LaminateWall, BehaviourNoHoopStressOfTheBarrel) {
  for (const RimState& state : rim_states(ply_drive(), 20, 8)) {
    EXPECT_FALSE(state.barrel_bending_stress);
    EXPECT_GT(state.barrel_shear_stress, 0);
  }
  GearSet two_metals = ply_drive();
  two_metals.material["bronze"] = {.youngs_modulus = 103 * GPa,
                                   .shear_modulus = {},
                                   .poissons_ratio = 0.3,
                                   .yield_strength = {},
                                   .fracture_toughness = {}};
  two_metals.flexspline->barrel->material = "bronze";
  const auto states = rim_states(two_metals, 20, 8);
  const double ratio = *states[1].barrel_bending_stress /
                       (states[1].rim_outside_stress - states[1].rim_inside_stress);
  const Flexspline& fs = *two_metals.flexspline;
  test::expect_relative(ratio,
                        0.5 * fs.barrel->wall_thickness / (2 * fs.rim->wall_thickness) * 103 /
                            (two_metals.material.at("steel").youngs_modulus.value() / GPa / 2),
                        1e-9);
}

// Kind: behaviour.  The notes say what is left out and how far the bottom may be off.
TEST(LaminateWall, BehaviourNotes) {
  const std::vector<Note> notes = AssembledDrive(ply_drive()).notes();
  for (const char* const code : {"torsion.laminate", "torsion.laminate_bottom"})
    EXPECT_EQ(std::ranges::count(notes, code, &Note::code), 1) << code;
  const std::vector<Note> of_steel = AssembledDrive(test::typical_drive()).notes();
  EXPECT_EQ(std::ranges::count(of_steel, "torsion.laminate", &Note::code), 0);
}

// Kind: input.  A rim of plies, and walls whose stretching couples with shear or bending, are
// refused by the name of the field.
TEST(LaminateWall, InputWhatIsNotDerivedIsRefused) {
  const auto message = [](const GearSet& gear) -> std::string {
    try {
      (void)AssembledDrive(gear);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  GearSet rim = ply_drive();
  rim.flexspline->rim->material = "tube";
  EXPECT_EQ(message(rim),
            "flexspline.rim.material: \"tube\" is a laminate; the coupled drive is derived for an "
            "isotropic rim under the teeth, while barrel and diaphragm may be of laminates");
  const std::string coupled =
      " couples stretching with shear or bending, which the coupled drive does not know; give a "
      "symmetric laminate with as many plies at +angle as at -angle";
  EXPECT_EQ(message(ply_drive({45, 45}, kStacks.at("quasi"))),
            "flexspline.barrel.material: \"tube\"" + coupled);
  EXPECT_EQ(message(ply_drive({0, 90}, kStacks.at("quasi"))),
            "flexspline.barrel.material: \"tube\"" + coupled);
  EXPECT_EQ(message(ply_drive({45, -45, -45, 45}, {0, 45, -45, 90})),
            "flexspline.diaphragm.material: \"plate\"" + coupled);
  const std::string one_way = message(ply_drive({45, -45, -45, 45}, {0, 90, 90, 0}));
  EXPECT_NE(one_way.find("not as stiff in every direction"), std::string::npos) << one_way;
  // Angles that scatter by a degree are no coupling.
  EXPECT_EQ(message(ply_drive({45.5, -45, -44.5, 45}, kStacks.at("quasi"))), "");
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// A flexspline of laminates in the series model: compliance, cracks, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "stiffness/members_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

constexpr double kThickness = 1.2 * mm;
constexpr double kMeanRadius = 60 * mm;

Material carbon() {
  Material layer;
  layer.youngs_modulus = 181 * GPa;
  layer.transverse_modulus = 10.3 * GPa;
  layer.shear_modulus = 7.17 * GPa;
  layer.poissons_ratio = 0.28;
  return layer;
}

Material laminate_of(const std::string& material, const std::vector<double>& degrees) {
  Material laminate;
  for (const double angle : degrees)
    laminate.ply.push_back({.material = material,
                            .angle = angle * deg,
                            .thickness = kThickness / static_cast<double>(degrees.size())});
  return laminate;
}

/// A cylinder of steel rim and laminated barrel.
GearSet tube_gear(const std::vector<double>& degrees) {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.output_shaft.reset();
  gear.article.reset();
  gear.material["carbon"] = carbon();
  gear.material["tube"] = laminate_of("carbon", degrees);
  Flexspline& fs = *gear.flexspline;
  fs.shape = FlexsplineShape::cylinder;
  fs.crack_free = CrackFree::sections;
  fs.length.reset();
  fs.wall_thickness.reset();
  fs.stress_nonuniformity = 1;
  fs.dynamic_load = 1;
  fs.crack.clear();
  gear.drive.pitch_diameter = 2 * kMeanRadius + 2 * mm;
  gear.drive.radial_displacement = gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  fs.barrel = TubeSection{.outer_diameter = 2 * kMeanRadius + kThickness,
                          .wall_thickness = kThickness,
                          .length = 90 * mm,
                          .material = "tube"};
  fs.rim = TubeSection{
      .outer_diameter = 2 * kMeanRadius + 2 * mm, .wall_thickness = 2 * mm, .length = 20 * mm};
  return gear;
}

// Kind: identity (ST-21).  The series model and the answer agree on the size of a crack in a
// laminate beyond which the sheet is no model.  The limit of this wall is a = 4 sqrt(r t)/1.817.
TEST(LaminateCup, IdentitySeriesEndsWhereTheAnswerDoes) {
  const double limit = 4 * std::sqrt(kMeanRadius * kThickness) / std::pow(12 * (1 - 0.09), 0.25);
  for (const double share : {0.99, 1.01}) {
    GearSet gear = tube_gear({45, -45, -45, 45});
    gear.flexspline->crack = {WallThroughCrack{
        .half_length = share * limit, .angle = 45 * deg, .shell_correction = false}};
    check(gear);
    EXPECT_EQ(series_compliance<double>(gear).usable, share < 1) << share;
    EXPECT_EQ(torsional_stiffness(gear).usable(), share < 1) << share;
  }
}

double sound(const GearSet& gear) {
  check(gear);
  return flexspline_compliance(gear).intact;
}

void add_crack(GearSet& gear, double half_length, double angle) {
  gear.flexspline->crack.push_back(
      WallThroughCrack{.half_length = half_length, .angle = angle, .shell_correction = false});
}

// Kind: identity (ST-2), (LA-5).  Rim and joint add to the tube; the tube is L over the rigidity of
// its plies.  A wall of plies twice as thick has the rigidity of the scaled plies.  Tolerance:
// rounding.
TEST(LaminateCup, IdentitySumOfSections) {
  GearSet gear = tube_gear({30, -45, 0});
  const double steel_rim =
      torsional_compliance(Tube{.outer_diameter = 2 * kMeanRadius + 2 * mm,
                                .inner_diameter = 2 * kMeanRadius - 2 * mm,
                                .length = 20 * mm},
                           elastic_constants(material_of(gear, gear.flexspline->material, "")).G);
  const Lift<double> lift;
  const auto plies = plies_of(lift, gear, gear.material.at("tube"));
  const double tube = 90 * mm / tube_torsion<double>(plies, kThickness, kMeanRadius).stiffness;
  test::expect_relative(sound(gear), steel_rim + tube, 1e-13);
  gear.flexspline->joint_compliance = 3e-7;
  test::expect_relative(sound(gear), steel_rim + tube + 3e-7, 1e-13);
  for (Ply& ply : gear.material.at("tube").ply) ply.thickness *= 2;
  test::expect_relative(sound(gear), steel_rim + tube + 3e-7, 1e-13);
}

// Kind: identity.  A list with its mirror image is the laminate written out.
TEST(LaminateCup, IdentitySymmetricStacking) {
  GearSet listed = tube_gear({30, -45, 0, 0, -45, 30});
  GearSet mirrored = tube_gear({30, -45, 0});
  mirrored.material.at("tube").stacking = Stacking::symmetric;
  test::expect_relative(sound(mirrored), sound(listed), 1e-14);
  EXPECT_GT(std::abs(sound(tube_gear({30, -45, 0, 30, -45, 0})) / sound(listed) - 1), 1e-7);
}

// Kind: identity.  Plies of isotropic steel are steel, in the whole answer: sound, cracked, with
// the shell correction; and the theory of laminates gives the same tube.  Tolerance: 1e-12.
TEST(LaminateCup, IdentityIsotropicPliesAreTheMetal) {
  GearSet metal = tube_gear({0});
  metal.flexspline->barrel->material.reset();
  metal.material.at(metal.flexspline->material).shear_modulus.reset();
  GearSet plies = tube_gear({0});
  plies.material.at(plies.flexspline->material).shear_modulus.reset();
  plies.material["tube"] = laminate_of(plies.flexspline->material, {10, -40, 90});
  for (GearSet* const gear : {&metal, &plies})
    gear->flexspline->crack.push_back(WallThroughCrack{.half_length = 4 * mm, .angle = 30 * deg});
  const auto one = torsional_stiffness(metal);
  const auto other = torsional_stiffness(plies);
  test::expect_relative(sound(plies), sound(metal), 1e-12);
  const auto added = [](const GearSet& gear) {
    return flexspline_compliance(gear).cracks.at(0).positive.at_output.value;
  };
  test::expect_relative(added(plies), added(metal), 1e-12);
  EXPECT_EQ(drive_cracks(plies).at(0).material, metal.flexspline->material);
  EXPECT_EQ(one.notes.size(), other.notes.size());
  // The same tube by the theory of laminates: two steels that differ in the last digit.
  plies.material["other"] = plies.material.at(plies.flexspline->material);
  *plies.material["other"].youngs_modulus *= 1 + 1e-15;
  plies.material.at("tube").ply.at(1).material = "other";
  plies.flexspline->crack.clear();
  metal.flexspline->crack.clear();
  EXPECT_TRUE(material_of(plies, "tube", "").is_laminate());
  test::expect_relative(sound(plies), sound(metal), 1e-12);
}

// Kind: cross-check (LA-9).  The energy of a crack is that of the stress on its plane in the axes
// of the sheet, in which the tensor of energies of fibres along the tube is diagonal, for any angle
// of crack and fibres: it needs neither K_II nor a sign.  Entries of torque and of axial force with
// torque.  Tolerance: 1e-11.
TEST(LaminateCup, CrosscheckCracksByTheEnergyTensor) {
  const TipEnergy<> tensor =
      tip_energy(sheet_compliance(laminate_stiffness<double>(
                     std::vector<LaminatePly<>>{
                         {.lamina = {181 * GPa, 10.3 * GPa, 7.17 * GPa, 0.28}, .thickness = 1}},
                     kThickness)),
                 0.0);
  for (const double fibres : {0.0, 45.0, -20.0, 90.0})
    for (const double crack : {30.0, 45.0, 80.0}) {
      GearSet gear = tube_gear({fibres});
      const double a = 2 * mm;
      add_crack(gear, a, crack * deg);
      check(gear);
      const CrackReport report = flexspline_compliance(gear).cracks.at(0);
      const auto& open =
          report.opens_under == OpensUnder::positive ? report.positive : report.negative;
      // Unit torque; x along the tube, y against the hoop direction.
      const double tau = -1 / (2 * pi * kMeanRadius * kMeanRadius * kThickness);
      const double n_x = std::sin(crack * deg);
      const double n_y = -std::cos(crack * deg);
      const double s_x = tau * n_y;
      const double s_y = tau * n_x;
      const double c = std::cos(fibres * deg);
      const double s = std::sin(fibres * deg);
      const double along = c * s_x + s * s_y;
      const double across = -s * s_x + c * s_y;
      // G = pi a (g_II along^2 + g_I across^2); both tips sweep the wall: 2 * 2 t * int G da.
      const double expected = 4 * kThickness * pi * a * a / 2 *
                              (tensor.sliding * along * along + tensor.opening * across * across);
      test::expect_relative(open.at_output.value, expected, 1e-11);
      // The entry of axial force and torque.
      const double sigma = 1 / (2 * pi * kMeanRadius * kThickness);
      const double p_along = c * sigma * n_x;
      const double p_across = -s * sigma * n_x;
      const double mixed = 4 * kThickness * pi * a * a / 2 *
                           (tensor.sliding * along * p_along + tensor.opening * across * p_across);
      EXPECT_NEAR((*open.axial_torsion)[1].value, mixed,
                  1e-11 * std::abs(expected) + 1e-11 * std::abs(mixed));
    }
}

// Kind: limit (LA-9).  A contact makes nothing more compliant: for any angle of fibres and crack
// the sense of torque that presses the faces adds at most what the other sense adds, and turning
// all angles round exchanges the senses.  Some cracks are opened by the sense whose normal stress
// would press them.
TEST(LaminateCup, LimitPressedFacesAreNoMoreCompliant) {
  int against_normal_stress = 0;
  for (const double fibres : {0.0, 10.0, 30.0, 45.0, 70.0})
    for (int crack = -85; crack <= 90; crack += 5) {
      GearSet gear = tube_gear({fibres});
      add_crack(gear, 2 * mm, crack * deg);
      const CrackReport report = flexspline_compliance(gear).cracks.at(0);
      const double positive = report.positive.at_output.value;
      const double negative = report.negative.at_output.value;
      const bool opens = report.opens_under == OpensUnder::positive;
      EXPECT_LE(opens ? negative : positive, (opens ? positive : negative) * (1 + 1e-12))
          << fibres << " deg, crack " << crack << " deg";
      if (crack % 90 != 0 && opens != (crack > 0)) ++against_normal_stress;
      GearSet mirrored = tube_gear({-fibres});
      add_crack(mirrored, 2 * mm, -crack * deg);
      test::expect_relative(flexspline_compliance(mirrored).cracks.at(0).negative.at_output.value,
                            positive, 1e-11);
    }
  EXPECT_GT(against_normal_stress, 5);
}

// Kind: crosscheck (LA-9).  Source: tools/reference/laminate.py, from the displacements of the
// faces, which may not overlap; a crack of 2 mm.  Tolerance: digits of the table.
TEST(LaminateCup, CrosscheckOpenAndShutCracks) {
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("laminate_cracks")) {
    GearSet gear = tube_gear({row("first") / deg, row("second") / deg});
    add_crack(gear, 2 * mm, row("angle"));
    const CrackReport report = flexspline_compliance(gear).cracks.at(0);
    const AddedCompliance& added = row.quantity == "positive" ? report.positive : report.negative;
    test::expect_relative(added.at_output.value, row.value, std::pow(10, 1 - row.digits));
    ++rows;
  }
  EXPECT_EQ(rows, 48);
}

// Kind: reference (LA-9), (FR-7).  A square-symmetric wall releases K^2 times one number at any
// angle: at 45 degrees a^2 g/(r^4 t)/(2 pi), with g for 1/E.  Tolerance: rounding.
TEST(LaminateCup, ReferenceCrackOfAnAnglePlyTube) {
  GearSet gear = tube_gear({45, -45, -45, 45});
  add_crack(gear, 5 * mm, 45 * deg);
  const double g = tip_energy(sheet_compliance(*wall_laminate(
                                  Lift<double>(), gear, gear.material.at("tube"), kThickness)),
                              0.3)
                       .opening;
  const double added = flexspline_compliance(gear).cracks.at(0).positive.at_output.value;
  test::expect_relative(added, 25e-6 * g / (2 * pi * std::pow(kMeanRadius, 4) * kThickness), 1e-11);
  EXPECT_EQ(drive_cracks(gear).at(0).material, "tube");
}

// Kind: behaviour.  A crack of a laminate and its plies leave their evidence.
TEST(LaminateCup, BehaviourEvidence) {
  GearSet gear = tube_gear({45, -45, -45, 45});
  add_crack(gear, 5 * mm, 45 * deg);
  for (Ply& ply : gear.material.at("tube").ply) ply.thickness *= 1.05;
  const MemberCompliance member = flexspline_compliance(gear);
  for (const char* const code :
       {"crack.laminate", "laminate.thickness", "flexspline.laminate_assembly"})
    EXPECT_TRUE(std::ranges::any_of(member.notes, [&](const Note& n) { return n.code == code; }))
        << code;
  EXPECT_TRUE(member.unusable_because.empty());
  add_crack(gear, 40 * mm, 45 * deg);
  gear.flexspline->crack.erase(gear.flexspline->crack.begin());
  EXPECT_NE(flexspline_compliance(gear).unusable_because.find("shorten its half length"),
            std::string::npos);
}

struct Refused {
  const char* name;
  std::function<void(GearSet&)> change;
  const char* message;
};

void PrintTo(const Refused& of, std::ostream* out) { *out << of.name; }

class LaminateRules : public testing::TestWithParam<Refused> {};

Flexspline& fs(GearSet& gear) { return *gear.flexspline; }

const Refused kRules[] = {
    {"PlyOfNoMaterial", [](GearSet& g) { g.material.at("tube").ply[0].material = "kevlar"; },
     "material.tube.ply[0].material"},
    {"PlyOfALaminate",
     [](GearSet& g) {
       g.material["other"] = laminate_of("carbon", {0, 90});
       g.material.at("tube").ply[1].material = "other";
     },
     "material.tube.ply[1].material: \"other\" is a laminate"},
    {"PlyOfItself", [](GearSet& g) { g.material.at("tube").ply[1].material = "tube"; },
     "material.tube.ply[1].material: \"tube\" is a laminate"},
    {"RatioBeyondTheModuli",
     [](GearSet& g) {
       g.material.at("carbon").youngs_modulus = 10 * GPa;
       g.material.at("carbon").transverse_modulus = 181 * GPa;
     },
     "material.carbon.poissons_ratio = 0.28 violates: of a smaller magnitude than"},
    {"LayerWithoutShear", [](GearSet& g) { g.material.at("carbon").shear_modulus.reset(); },
     "material.carbon.shear_modulus: must be given beside transverse_modulus"},
    {"LayerWithoutRatio", [](GearSet& g) { g.material.at("carbon").poissons_ratio.reset(); },
     "material.carbon.poissons_ratio: must be given beside transverse_modulus"},
    {"LayerWithYield", [](GearSet& g) { g.material.at("carbon").yield_strength = 1e9; },
     "material.carbon.yield_strength: is not read for a layer"},
    {"LaminateWithModulus", [](GearSet& g) { g.material.at("tube").youngs_modulus = 1e11; },
     "material.tube.youngs_modulus: is not read beside ply"},
    {"LaminateWithToughness", [](GearSet& g) { g.material.at("tube").fracture_toughness = 1e7; },
     "material.tube.fracture_toughness: is not read for a laminate"},
    {"StrengthWithoutLayer",
     [](GearSet& g) {
       g.material.at(fs(g).material).ply_strength = LaminaStrength{1, 1, 1, 1, 1};
     },
     "ply_strength: is read only beside transverse_modulus"},
    {"StackingWithoutPlies",
     [](GearSet& g) { g.material.at("carbon").stacking = Stacking::symmetric; },
     "material.carbon.stacking: is read only beside ply"},
    {"RowInALaminate",
     [](GearSet& g) {
       add_crack(g, 2 * mm, 45 * deg);
       std::get<WallThroughCrack>(fs(g).crack[0]).count = 2;
     },
     "flexspline.crack[0].count: must be 1 for a crack in a laminate"},
    {"PartOfALayer", [](GearSet& g) { fs(g).barrel->material = "carbon"; },
     "flexspline.barrel.material: \"carbon\" is a single layer"},
    {"FactorOfALaminate",
     [](GearSet& g) {
       fs(g).crack_free = CrackFree::factor;
       fs(g).material = "tube";
       fs(g).length = 0.1;
       fs(g).wall_thickness = kThickness;
       fs(g).rim.reset();
       fs(g).barrel.reset();
     },
     "flexspline.material: \"tube\" is a laminate; only rim, barrel and diaphragm"},
    {"BossOfALaminate",
     [](GearSet& g) {
       fs(g).shape = FlexsplineShape::cup;
       fs(g).diaphragm = Diaphragm{.outer_diameter = 2 * kMeanRadius,
                                   .inner_diameter = 60 * mm,
                                   .thickness = 2 * mm,
                                   .profile = {}};
       fs(g).boss = Boss{{.outer_diameter = 60 * mm, .wall_thickness = 8 * mm, .length = 8 * mm}};
       fs(g).boss->material = "tube";
     },
     "flexspline.boss.material: \"tube\" is a laminate"},
    {"ShellCorrection",
     [](GearSet& g) { fs(g).crack.push_back(WallThroughCrack{.half_length = 2 * mm}); },
     "flexspline.crack[0].shell_correction: must be false for a crack in a laminate"},
    {"SurfaceCrack",
     [](GearSet& g) {
       fs(g).crack.push_back(WallSurfaceCrack{.depth = 0.3 * mm, .half_length = 1 * mm});
     },
     "flexspline.crack[0].kind: is in a laminate"},
    {"JointOfAFactor",
     [](GearSet& g) {
       fs(g).crack_free = CrackFree::factor;
       fs(g).length = 0.1;
       fs(g).wall_thickness = kThickness;
       fs(g).rim.reset();
       fs(g).barrel.reset();
       fs(g).joint_compliance = 1e-7;
     },
     "flexspline.joint_compliance: is read only where crack_free"}};

// Kind: input.  Every rule of plies and sections is broken once.
TEST_P(LaminateRules, InputIsRefused) {
  GearSet gear = tube_gear({45, -45});
  check(gear);
  GetParam().change(gear);
  const std::string message = test::broken_rule([&] { check(gear); });
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(LaminateCup, LaminateRules, testing::ValuesIn(kRules),
                         [](const auto& of) { return std::string(of.param.name); });

// Kind: input (LA-10).  A bottom must be as stiff in every direction of its plane.
TEST(LaminateCup, InputBottomWithADirection) {
  GearSet gear = tube_gear({45, -45});
  Flexspline& of = *gear.flexspline;
  of.shape = FlexsplineShape::cup;
  of.diaphragm = Diaphragm{.outer_diameter = 2 * kMeanRadius,
                           .inner_diameter = 60 * mm,
                           .thickness = 2 * mm,
                           .profile = {},
                           .material = "tube"};
  EXPECT_NE(test::broken_rule([&] {
              return sound(gear);
            }).find("flexspline.diaphragm.material: \"tube\" is not as stiff in every direction"),
            std::string::npos);
  gear.material["bottom"] = laminate_of("carbon", {0, 45, -45, 90});
  of.diaphragm->material = "bottom";
  const double with = sound(gear);
  of.shape = FlexsplineShape::cylinder;
  of.diaphragm.reset();
  const double G = 26.880431 * GPa;
  test::expect_relative(with - sound(gear),
                        torsional_compliance(AnnularPlate{.outer_diameter = 2 * kMeanRadius,
                                                          .inner_diameter = 60 * mm,
                                                          .thickness = 2 * mm},
                                             G),
                        1e-7);
}

// Kind: identity.  A crack is of the material of its section, in moduli and in name; a rule that a
// missing section breaks is told as such.
TEST(LaminateCup, IdentityCrackOfItsSection) {
  GearSet gear = tube_gear({45, -45});
  Flexspline& of = *gear.flexspline;
  of.shape = FlexsplineShape::cup;
  of.barrel->material.reset();
  gear.material["soft"] = gear.material.at(of.material);
  *gear.material["soft"].youngs_modulus /= 2;
  *gear.material["soft"].shear_modulus /= 2;
  of.diaphragm = Diaphragm{.outer_diameter = 2 * kMeanRadius,
                           .inner_diameter = 60 * mm,
                           .thickness = 2 * mm,
                           .profile = {}};
  of.crack = {DiaphragmArcCrack{.half_length = 4 * mm, .radius = 45 * mm}};
  const auto added = [&] {
    check(gear);
    return flexspline_compliance(gear).cracks.at(0).positive.at_output.value;
  };
  const double steel = added();
  EXPECT_EQ(drive_cracks(gear).at(0).material, of.material);
  of.diaphragm->material = "soft";
  test::expect_relative(added(), 2 * steel, 1e-12);
  EXPECT_EQ(drive_cracks(gear).at(0).material, "soft");
  of.shape = FlexsplineShape::cylinder;
  of.diaphragm.reset();
  of.barrel->material = "tube";
  EXPECT_NE(test::broken_rule([&] { check(gear); }).find("flexspline.diaphragm"),
            std::string::npos);
}

// Kind: input.  What is derived for one isotropic material refuses a wall of another.
TEST(LaminateCup, InputOnlyOneMaterial) {
  GearSet gear = tube_gear({45, -45});
  const auto message = [&] {
    return test::broken_rule([&] { return only_material(gear, *gear.flexspline).is_laminate(); });
  };
  EXPECT_NE(message().find("flexspline.barrel.material: \"tube\" is another material"),
            std::string::npos);
  gear.flexspline->barrel->material.reset();
  EXPECT_EQ(message(), "no error");
  gear.flexspline->material = "tube";
  EXPECT_NE(message().find("flexspline.material: \"tube\" is a laminate"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

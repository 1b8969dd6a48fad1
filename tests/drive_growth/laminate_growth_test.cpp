// SPDX-License-Identifier: Apache-2.0
// A through crack of a laminate: its modes of energy, fracture and growth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/laminate/laminate.hpp"
#include "strainwave/strength/crack_assessment.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

constexpr double kThickness = 1.2 * mm;
constexpr double kMeanRadius = 60 * mm;
constexpr double kTorque = 3000;  ///< of the first block [N*m]

/// A cylinder with one lobe, so that the assembly does not bend the wall; its barrel is of `tube`.
GearSet tube(const std::string& material, double angle, double half_length = 3 * mm) {
  return read_gear_set(R"(
format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
fracture_toughness = "20 MPa*m^0.5"
[[material.steel.growth]]
kind = "paris"
coefficient = "6.9e-12 m"
exponent = 3
[material.alike]
youngs_modulus = "210.00000001 GPa"
poissons_ratio = 0.3
[material.carbon]
youngs_modulus = "181 GPa"
transverse_modulus = "10.3 GPa"
shear_modulus = "7.17 GPa"
poissons_ratio = 0.28
)" + material + R"(
[drive]
ratio = 100
wave_number = 1
pitch_diameter = "122 mm"
radial_displacement = "0.61 mm"
[load]
torque = "3000 N*m"
[flexspline]
material = "steel"
shape = "cylinder"
crack_free = "sections"
[flexspline.rim]
outer_diameter = "122 mm"
wall_thickness = "2 mm"
length = "20 mm"
[flexspline.barrel]
material = "tube"
outer_diameter = "121.2 mm"
wall_thickness = "1.2 mm"
length = "90 mm"
[[flexspline.crack]]
kind = "through"
section = "barrel"
half_length = ")" + std::to_string(half_length / mm) +
                           R"( mm"
angle = ")" + std::to_string(angle / deg) +
                           R"( deg"
shell_correction = false
[[duty.block]]
torque = "3000 N*m"
output_speed = "20 rpm"
duration = "1 s"
[[duty.block]]
torque = "-1000 N*m"
output_speed = "20 rpm"
duration = "1 s"
)",
                       "tube.toml");
}

std::string plies(const std::string& head, const std::vector<std::string>& of) {
  std::string text = "[material.tube]\n" + head;
  for (const std::string& ply : of)
    text += "[[material.tube.ply]]\n" + ply + "\nthickness = \"0.3 mm\"\n";
  return text;
}

std::string at(double degrees) {
  return "material = \"carbon\"\nangle = \"" + std::to_string(degrees) + " deg\"";
}

const std::string kLaw =
    "[[material.tube.growth]]\nkind = \"paris\"\ncoefficient = \"6.9e-12 m\"\nexponent = 3\n";

// Kind: identity (LA-15), (FR-20).  Two steels that differ in the tenth digit make a laminate that
// does what the steel does: strength, growth and the hours to the fracture.
TEST(LaminateGrowth, IdentityOfAMetal) {
  const std::string solid = plies(
      "", {"material = \"steel\"\nangle = \"0 deg\"", "material = \"steel\"\nangle = \"0 deg\""});
  // G_c = K_Ic^2/E
  const std::string layered =
      plies(
          "fracture_energy = \"1904.76190476 J/m^2\"\nreference_modulus = \"210 GPa\"\n",
          {"material = \"steel\"\nangle = \"0 deg\"", "material = \"alike\"\nangle = \"20 deg\""}) +
      kLaw;
  for (const double angle : {45 * deg, 20 * deg}) {
    const GearSet metal = tube(solid, angle);
    const GearSet laminate = tube(layered, angle);
    const CrackStrength of_metal = crack_strength(metal).at(0);
    const CrackStrength of_laminate = crack_strength(laminate).at(0);
    test::expect_relative(of_laminate.worst()->K, of_metal.worst()->K, 1e-8);
    test::expect_relative(*of_laminate.worst()->utilisation, *of_metal.worst()->utilisation, 1e-8);
    const GrowthReport grown_metal = grow_cracks(metal);
    const GrowthReport grown = grow_cracks(laminate);
    ASSERT_TRUE(grown_metal.life && grown.life) << angle;
    test::expect_relative(*grown.life, *grown_metal.life, 1e-7);
    EXPECT_EQ(grown.mixed_mode, "energy");
  }
}

// Kind: crosscheck (LA-9), (LA-15).  The energy of the two modes is that of the tensor of (LA-8)
// with the stresses on the plane of the crack.  An open crack takes both stresses.  Pressed faces
// take the shear and the pressure that keeps them shut.  Tolerance: rounding.
TEST(LaminateGrowth, CrosscheckEnergyOfTheTwoModes) {
  int open = 0;
  int pressed = 0;
  const double shear = kTorque / (2 * pi * kMeanRadius * kMeanRadius * kThickness);
  const double root = std::sqrt(pi * 3 * mm);
  for (const double fibres : {0.0, 15.0, 40.0, 75.0})
    for (const double angle : {-65 * deg, -20 * deg, 10 * deg, 40 * deg, 80 * deg}) {
      const GearSet gear = tube(plies("reference_modulus = \"40 GPa\"\n",
                                      {at(fibres), at(fibres), at(fibres), at(fibres)}),
                                angle);
      const auto wall = *wall_laminate(Lift<double>(), gear, gear.material.at("tube"), kThickness);
      const TipEnergy<double> g = tip_energy(sheet_compliance(wall), angle);
      const DriveCrack crack = drive_cracks(gear).at(0);
      for (const double sense : {1.0, -1.0}) {
        // (FR-6) for torsion
        const double normal = sense * shear * std::sin(2 * angle);
        const double tangential = sense * shear * std::cos(2 * angle);
        const bool opens = g.opening * normal - g.coupling * tangential > 0;
        const double K_II = tangential * root;
        // What keeps the faces shut acts like the normal stress that opens nothing.
        const double K_I = opens ? normal * root : K_II * g.coupling / g.opening;
        const double G =
            g.opening * K_I * K_I + g.sliding * K_II * K_II - 2 * g.coupling * K_I * K_II;
        const Faces faces = opens ? Faces::open : Faces::pressed;
        EXPECT_EQ(sense > 0 ? crack.faces.positive : crack.faces.negative, faces);
        const UnitStressIntensity<2> k = crack.front(crack.size, faces).front().load;
        const double K_1 = k.I[kTorsion] * sense * kTorque;
        const double K_2 = k.II[kTorsion] * sense * kTorque;
        test::expect_relative((K_1 * K_1 + K_2 * K_2) / (40 * GPa), G, 1e-11);
        test::expect_relative(energy_release_rate(K_1, K_2, 0, crack.moduli), G, 1e-11);
        EXPECT_EQ(K_1 > 0, opens);
        ++(opens ? open : pressed);
      }
    }
  EXPECT_EQ(open, 20);
  EXPECT_EQ(pressed, 20);
}

// Kind: crosscheck (LA-15), (GR-1).  In a wall with square symmetry G = g K^2 at any angle, and a
// crack at 45 degrees opens under one sense of the torque only, so the life between two sizes is
// Paris' closed form.  Tolerance: the integration.
TEST(LaminateGrowth, CrosscheckParisOfAnAnglePly) {
  GearSet gear = tube(plies("reference_modulus = \"40 GPa\"\nfracture_energy = \"5 kJ/m^2\"\n",
                            {at(45), at(-45), at(-45), at(45)}) +
                          kLaw,
                      45 * deg);
  gear.duty->block[1].torque = 0;
  const GrowthReport report = grow_cracks(gear);
  ASSERT_TRUE(report.life);
  const double g = tip_energy(sheet_compliance(*wall_laminate(
                                  Lift<double>(), gear, gear.material.at("tube"), kThickness)),
                              0.3)
                       .opening;
  const double stress = kTorque / (2 * pi * kMeanRadius * kMeanRadius * kThickness);
  const double per_root = stress * std::sqrt(pi * 40 * GPa * g) / MPa;  // K/sqrt(a)
  const double end = std::pow(std::sqrt(5e3 * 40 * GPa) / MPa / per_root, 2);
  const double cycles =
      2 / (6.9e-12 * std::pow(per_root, 3)) * (1 / std::sqrt(3 * mm) - 1 / std::sqrt(end));
  test::expect_relative(report.cracks.at(0).series.back().size, end, 1e-6);
  test::expect_relative(*report.life, 2 * cycles, 1e-4);
  EXPECT_EQ(report.notes.end(), std::ranges::find(report.notes, "growth.laminate", &Note::code));
  EXPECT_NE(report.notes.end(),
            std::ranges::find(report.notes, "growth.unknown_stress", &Note::code));
}

GearSet with_two_lobes(GearSet gear) {
  gear.drive.wave_number = 2;
  check(gear);
  return gear;
}

// Kind: identity (LA-20), (FA-12), (FA-14).  Two steels that differ in the tenth digit make a
// laminate whose bending by the assembly is that of the steel: in K, strength and growth.
TEST(LaminateGrowth, IdentityBendingOfAMetal) {
  const std::string solid = plies(
      "", {"material = \"steel\"\nangle = \"0 deg\"", "material = \"steel\"\nangle = \"0 deg\""});
  const std::string layered =
      plies(
          "fracture_energy = \"1904.76190476 J/m^2\"\nreference_modulus = \"210 GPa\"\n",
          {"material = \"steel\"\nangle = \"0 deg\"", "material = \"alike\"\nangle = \"20 deg\""}) +
      kLaw;
  for (const double angle : {45 * deg, -20 * deg, 80 * deg}) {
    const GearSet metal = with_two_lobes(tube(solid, angle));
    const GearSet laminate = with_two_lobes(tube(layered, angle));
    const DriveCrack of_metal = drive_cracks(metal).at(0);
    const DriveCrack of_laminate = drive_cracks(laminate).at(0);
    ASSERT_TRUE(of_metal.assembly && of_laminate.assembly);
    test::expect_relative(of_laminate.assembly_peak, of_metal.assembly_peak, 1e-8);
    for (std::size_t mode = 0; mode < 2; ++mode)
      test::expect_relative(of_laminate.front(of_laminate.size, Faces::open).front().assembly[mode],
                            of_metal.front(of_metal.size, Faces::open).front().assembly[mode],
                            1e-8);
    EXPECT_GT(std::abs(of_metal.front(of_metal.size, Faces::open).front().assembly[0]), 1 * MPa);
    const CrackStrength strength = crack_strength(laminate).at(0);
    const CrackStrength expected = crack_strength(metal).at(0);
    ASSERT_EQ(strength.states.size(), expected.states.size());
    for (std::size_t i = 0; i < strength.states.size(); ++i) {
      test::expect_relative(strength.states[i].K, expected.states[i].K, 1e-8);
      EXPECT_EQ(strength.states[i].with_assembly, expected.states[i].with_assembly);
    }
    // At -20 degrees the assessment ends the life of the metal under the torque of the other sense,
    // where the bound of a laminate proves no fracture.
    if (angle < 0) continue;
    GrowthOptions energy;
    energy.rate.mixed_mode = MixedMode::energy;
    const GrowthReport grown_metal = grow_cracks(metal, energy);
    const GrowthReport grown = grow_cracks(laminate, energy);
    ASSERT_TRUE(grown.life && grown_metal.life) << angle;
    test::expect_relative(*grown.life, *grown_metal.life, 1e-6);
    test::expect_relative(grown.cracks.at(0).series.back().size,
                          grown_metal.cracks.at(0).series.back().size, 1e-6);
  }
}

// Kind: crosscheck (LA-20).  The bound is the mean over the wall of the stress that the strain of
// the outer face causes in every ply, turned to the crack by a tensor; in no ply does the stress of
// the bending exceed it.  Tolerance: rounding.
TEST(LaminateGrowth, CrosscheckBoundOfTheBending) {
  const GearSet gear = with_two_lobes(tube(plies("", {at(30), at(-50), at(10)}), 0.3));
  const auto layup = plies_of(Lift<double>(), gear, gear.material.at("tube"));
  const auto wall = laminate_stiffness<double>(layup, kThickness);
  const double curvature = 3 * gear.drive.radial_displacement / (kMeanRadius * kMeanRadius);
  const double neutral = wall.B.m22 / wall.A.m22;
  const double strain = curvature * (kThickness / 2 + std::abs(neutral));
  for (const double angle : {-1.2, 0.0, 0.4, 1.5}) {
    const double n[2] = {-std::sin(angle), std::cos(angle)};
    const double t[2] = {std::cos(angle), std::sin(angle)};
    double normal = 0.0;
    double shear = 0.0;
    for (std::size_t i = 0; i < layup.size(); ++i) {
      const auto at_face = turned_stiffness(reduced_stiffness(layup[i].lamina), layup[i].angle)
                               .times({0, strain, 0});
      const double stress[2][2] = {{at_face[0], at_face[2]}, {at_face[2], at_face[1]}};
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          normal += n[a] * stress[a][b] * n[b] / 3;
          shear += t[a] * stress[a][b] * n[b] / 3;
        }
      const double z0 = kThickness * (static_cast<double>(i) / 3 - 0.5);
      for (const double z : {z0, z0 + kThickness / 3})
        EXPECT_LE(std::abs(curvature * (z - neutral)), strain * (1 + 1e-12));
    }
    const AssemblyStress bound = assembly_stress(gear.drive, wall, kMeanRadius, angle);
    test::expect_relative(bound.normal, normal, 1e-12);
    // K_II of (FR-6) shears the faces against the sense of the laminate's axes.
    test::expect_relative(bound.shear, -shear, 1e-11);
  }
}

// Kind: behaviour (LA-20).  The bound of the bending proves no fracture, and the answer states the
// energy with and without it; the energy of the load alone does prove one.
TEST(LaminateGrowth, BehaviourBoundIsNoFracture) {
  const auto strength = [](double energy) {
    return crack_strength(with_two_lobes(tube(
                              plies("fracture_energy = \"" + std::to_string(energy) + " J/m^2\"\n",
                                    {at(45), at(-45), at(-45), at(45)}),
                              45 * deg)))
        .at(0);
  };
  const CrackStrength tough = strength(1e6);
  const StrengthState& worst = *tough.worst();
  EXPECT_TRUE(worst.with_assembly);
  EXPECT_GT(worst.K, 1.1 * worst.K_load);
  const double of_load =
      worst.K_load * worst.K_load * 1e6 / std::pow(worst.K / *worst.utilisation, 2);
  const CrackStrength between = strength(1.2 * of_load);
  EXPECT_EQ(between.verdict, StrengthVerdict::cannot_tell);
  EXPECT_GT(*between.worst()->utilisation, 1);
  EXPECT_NE(between.sentence.find("the energy release rate is at most "), std::string::npos)
      << between.sentence;
  EXPECT_NE(between.sentence.find("and 0.833 times without the bending of the plies"),
            std::string::npos)
      << between.sentence;
  EXPECT_EQ(strength(0.99 * of_load).verdict, StrengthVerdict::fractures);
}

// Kind: behaviour (LA-15).  Below the fracture energy nothing is told but the ratio; at it the
// crack fractures.  Without it the answer asks for it.
TEST(LaminateGrowth, BehaviourVerdicts) {
  const auto strength = [](const std::string& energy) {
    return crack_strength(tube(plies(energy, {at(45), at(-45), at(-45), at(45)}), 45 * deg)).at(0);
  };
  const CrackStrength without = strength("");
  EXPECT_EQ(without.verdict, StrengthVerdict::cannot_tell);
  EXPECT_NE(without.next_step.find("fracture_energy"), std::string::npos);
  const CrackStrength holds = strength("fracture_energy = \"5 kJ/m^2\"\n");
  EXPECT_EQ(holds.verdict, StrengthVerdict::cannot_tell);
  EXPECT_NE(holds.sentence.find("the energy release rate is "), std::string::npos);
  const double ratio = std::pow(*holds.worst()->utilisation, 2);
  EXPECT_LT(ratio, 1);
  const CrackStrength breaks =
      strength("fracture_energy = \"" + std::to_string(5e3 * ratio * 0.999) + " J/m^2\"\n");
  EXPECT_EQ(breaks.verdict, StrengthVerdict::fractures);
  EXPECT_NE(breaks.sentence.find("fractures at this load: the energy release rate is 1 times"),
            std::string::npos)
      << breaks.sentence;
  // G rises with the size, so the critical half length follows from the ratio.
  test::expect_relative(*holds.worst()->brittle_size->size, 3 * mm / ratio, 1e-9);
}

// Kind: input.  What is of metals only, and a law without the modulus that makes K of energies.
TEST(LaminateGrowth, InputOfMetals) {
  const std::string ply = at(45);
  const auto grown = [&](const GrowthOptions& options) {
    const GearSet gear =
        tube(plies("reference_modulus = \"40 GPa\"\n", {ply, at(-45)}) + kLaw, 45 * deg);
    return test::broken_rule([&] { (void)grow_cracks(gear, options); });
  };
  GrowthOptions tanaka;
  tanaka.rate.mixed_mode = MixedMode::tanaka;
  EXPECT_NE(grown(tanaka).find("must be energy"), std::string::npos);
  GrowthOptions wheeler;
  wheeler.interaction.rule = InteractionRule::wheeler;
  EXPECT_NE(grown(wheeler).find("no plastic zone"), std::string::npos);
  const auto refused = [&](const std::string& material) {
    return test::broken_rule([&] { (void)tube(material, 45 * deg); });
  };
  EXPECT_NE(refused(plies("", {ply}) + kLaw).find("reference_modulus: must be given beside growth"),
            std::string::npos);
  const std::string sound = plies("", {ply});
  EXPECT_NE(refused(sound + "[material.other]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
                            "fracture_energy = \"1 kJ/m^2\"\n")
                .find("fracture_energy: is read only beside ply"),
            std::string::npos);
  EXPECT_NE(refused(sound + "[material.other]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
                            "reference_modulus = \"1 GPa\"\n")
                .find("reference_modulus: is read only beside ply"),
            std::string::npos);
  EXPECT_NE(
      refused(sound + "[[material.carbon.growth]]\nkind = \"paris\"\ncoefficient = \"1e-12 m\"\n"
                      "exponent = 3\n")
          .find("growth: is not read for a layer"),
      std::string::npos);
  EXPECT_NE(refused(sound + "[material.carbon.growth_scatter]\nlevel = 0.1\n")
                .find("growth_scatter: is not read for a layer"),
            std::string::npos);
}

// Kind: behaviour.  The laws of the library are those of metals: a laminate keeps its own.
TEST(LaminateGrowth, BehaviourChosenLaw) {
  const GearSet gear =
      tube(plies("reference_modulus = \"40 GPa\"\nfracture_energy = \"5 kJ/m^2\"\n",
                 {at(45), at(-45), at(-45), at(45)}) +
               kLaw,
           45 * deg);
  GrowthOptions chosen;
  chosen.rate.law = "17-4PH H900";
  const GrowthReport with = grow_cracks(gear, chosen);
  EXPECT_EQ(*with.life, *grow_cracks(gear).life);
  EXPECT_EQ(with.cracks.at(0).constants, "material tube of the file");
}

}  // namespace
}  // namespace strainwave

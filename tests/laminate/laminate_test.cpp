// SPDX-License-Identifier: Apache-2.0
// Layers and laminates: stiffness, torsion of tubes, energy at the tip of a crack.
#include "strainwave/laminate/laminate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180;
constexpr double kGPa = 1e9;
const Lamina<> kCarbon{.E1 = 181e9, .E2 = 10.3e9, .G12 = 7.17e9, .nu12 = 0.28};
const Lamina<> kGlass{.E1 = 45.6e9, .E2 = 16.2e9, .G12 = 5.83e9, .nu12 = 0.278};
const Lamina<> kSteel{.E1 = 208e9, .E2 = 208e9, .G12 = 80e9, .nu12 = 0.3};
constexpr double kRadius = 78.88e-3;
constexpr double kWall = 2.24e-3;

std::vector<LaminatePly<>> carbon(const std::vector<double>& degrees) {
  std::vector<LaminatePly<>> plies;
  for (const double angle : degrees)
    plies.push_back({.lamina = kCarbon, .angle = angle * kDegree, .thickness = 1});
  return plies;
}

LaminateStiffness<> wall_of(const std::vector<LaminatePly<>>& plies, double thickness = kWall) {
  return laminate_stiffness<double>(plies, thickness);
}

double rigidity(const std::vector<LaminatePly<>>& plies) {
  return tube_torsion<double>(plies, kWall, kRadius).stiffness;
}

void expect_all(const InPlane<>& m, const std::array<double, 6>& expected, double tolerance) {
  const std::array<double, 6> entries = {m.m11, m.m12, m.m22, m.m16, m.m26, m.m66};
  for (std::size_t i = 0; i < 6; ++i) test::expect_relative(entries[i], expected[i], tolerance);
}

// Kind: reference (LA-1), (LA-2).  Source: worked examples of a textbook of mechanics of composite
// materials (Kaw), recomputed.  Tolerance: the printed digits.
TEST(Laminate, ReferenceLayerInItsOwnAndInTurnedAxes) {
  const InPlane<> Q = reduced_stiffness(kCarbon);
  test::expect_relative(Q.m11, 181.811139 * kGPa, 1e-8);
  test::expect_relative(Q.m12, 2.896924 * kGPa, 2e-7);
  test::expect_relative(Q.m22, 10.346159 * kGPa, 1e-7);
  EXPECT_EQ(Q.m66, 7.17 * kGPa);
  const InPlane<> t = turned_stiffness(Q, 60 * kDegree);
  InPlane<> in_GPa;
  in_GPa.add(t, 1 / kGPa);
  expect_all(in_GPa, {23.646757, 32.462571, 109.379247, 20.053523, 54.192991, 36.735647}, 1e-7);
}

// Kind: reference (LA-3).  Source: as above, [0/30/-45] of 5 mm plies.  Tolerance: seven digits.
TEST(Laminate, ReferenceStiffnessOfAnUnsymmetricLaminate) {
  const LaminateStiffness<> wall = wall_of(carbon({0, 30, -45}), 15e-3);
  expect_all(wall.A, {1.739241e9, 3.883864e8, 4.532535e8, 5.663373e7, -1.140636e8, 4.524825e8},
             5e-7);
  test::expect_relative(wall.B.m11, -3.128834e6, 5e-7);
  test::expect_relative(wall.B.m12, 9.855216e5, 5e-7);
  test::expect_relative(wall.D.m11, 3.343203e4, 5e-7);
  test::expect_relative(wall.D.m66, 7.662780e3, 5e-7);
}

// Kind: identity (LA-2).  A stiffness with all six entries turns back; its invariants stay.
// Tolerance: rounding.
TEST(Laminate, IdentityTurningThereAndBack) {
  InPlane<> Q = turned_stiffness(reduced_stiffness(kGlass), 0.7);
  for (const double angle : {0.3, -1.4, 2.0}) {
    const InPlane<> there = turned_stiffness(Q, angle);
    const InPlane<> back = turned_stiffness(there, -angle);
    expect_all(back, {Q.m11, Q.m12, Q.m22, Q.m16, Q.m26, Q.m66}, 1e-13);
    test::expect_relative(there.m11 + there.m22 + 2 * there.m12, Q.m11 + Q.m22 + 2 * Q.m12, 1e-13);
    test::expect_relative(there.m66 - there.m12, Q.m66 - Q.m12, 1e-13);
  }
  expect_all(inverse(inverse(Q)), {Q.m11, Q.m12, Q.m22, Q.m16, Q.m26, Q.m66}, 1e-13);
}

// Kind: identity (LA-3).  Reversed stacking: A and D stay, B turns its sign; turned by 90 degrees,
// the directions change places.  Tolerance: rounding.
TEST(Laminate, IdentityReversedStackingAndAQuarterTurn) {
  const LaminateStiffness<> wall = wall_of(carbon({0, 30, -45, 80}));
  const LaminateStiffness<> reversed = wall_of(carbon({80, -45, 30, 0}));
  const LaminateStiffness<> turned = wall_of(carbon({90, 120, 45, 170}));
  EXPECT_NEAR(reversed.A.m16, wall.A.m16, 1e-13 * wall.A.m11);
  EXPECT_NEAR(reversed.D.m22, wall.D.m22, 1e-13 * wall.D.m11);
  EXPECT_NEAR(reversed.B.m11, -wall.B.m11, 1e-13 * wall.A.m11 * kWall);
  EXPECT_NEAR(reversed.B.m26, -wall.B.m26, 1e-13 * wall.A.m11 * kWall);
  test::expect_relative(turned.A.m11, wall.A.m22, 1e-13);
  test::expect_relative(turned.D.m22, wall.D.m11, 1e-13);
  EXPECT_NEAR(turned.A.m16, -wall.A.m26, 1e-12 * wall.A.m11);
}

// Kind: reference (LA-4), (LA-5).  Source: closed forms; moduli of a laminate of equal shares at 0,
// 45, -45 and 90 degrees.  Tolerance: the digits of the source.
TEST(Laminate, ReferenceModuliOfTheWall) {
  const auto modulus = [](const std::vector<double>& degrees) {
    return 1 / sheet_compliance(wall_of(carbon(degrees))).m66 / kGPa;
  };
  test::expect_relative(modulus({45, -45, -45, 45}), 46.590862, 1e-7);
  test::expect_relative(modulus({0, 45, -45, 90, 90, -45, 45, 0}), 26.880431, 1e-7);
  test::expect_relative(modulus({0, 90, 90, 0}), 7.17, 1e-12);
  test::expect_relative(modulus({45}), 1 / (1 / 181.0 + 2 * 0.28 / 181 + 1 / 10.3), 1e-12);
  const InPlane<> a = sheet_compliance(wall_of(carbon({0, 45, -45, 90, 90, -45, 45, 0})));
  test::expect_relative(1 / a.m11, 69.675741 * kGPa, 1e-7);
  test::expect_relative(1 / a.m22, 1 / a.m11, 1e-12);
  test::expect_relative(1 / a.m66, 1 / (2 * (a.m11 - a.m12)), 1e-12);
}

// Kind: reference (LA-5).  Isotropic plies are exact, G J = pi/2 G (r_o^4 - r_i^4); rigidities of
// three balanced walls with the correction for their thickness, and of all fibres at 45 degrees,
// thin.  Source: closed forms.  Tolerance: 1e-7, four digits beyond the thin wall; 1e-3, (h/r)^2,
// for the unbalanced wall.
TEST(Laminate, ReferenceRigidityOfTubes) {
  const double r_o = kRadius + kWall / 2;
  const double r_i = kRadius - kWall / 2;
  const std::vector<LaminatePly<>> steel = {{kSteel, 0.3, 1}, {kSteel, -0.7, 2}};
  test::expect_relative(rigidity(steel), pi / 2 * 80e9 * (std::pow(r_o, 4) - std::pow(r_i, 4)),
                        1e-13);
  test::expect_relative(rigidity(steel), 552721.2054, 1e-9);
  test::expect_relative(rigidity(carbon({45, -45, -45, 45})), 321896.969, 1e-7);
  test::expect_relative(rigidity(carbon({0, 45, -45, 90, 90, -45, 45, 0})), 185712.157, 1e-7);
  test::expect_relative(rigidity(carbon({0, 90, 90, 0})), 49537.638, 1e-8);
  test::expect_relative(rigidity(carbon({45})), 65347.396, 1e-3);
}

std::map<std::string, std::vector<LaminatePly<>>> reference_walls() {
  return {
      {"isotropic", {{kSteel, 0.3, 1}, {kSteel, -0.7, 2}}},
      {"along", {{kCarbon, 0, 1}}},
      {"plus45", {{kCarbon, pi / 4, 1}}},
      {"plus30", {{kCarbon, pi / 6, 1}}},
      {"minus20", {{kGlass, -pi / 9, 1}}},
      {"angle_ply",
       {{kCarbon, pi / 4, 1}, {kCarbon, -pi / 4, 1}, {kCarbon, -pi / 4, 1}, {kCarbon, pi / 4, 1}}},
      {"two_plies", {{kCarbon, pi / 6, 1}, {kCarbon, -pi / 4, 2}}},
      {"hybrid", {{kSteel, 0, 1}, {kGlass, 1.1, 1}, {kCarbon, -0.4, 0.5}}}};
}

// Kind: cross-check (LA-5).  Source: layered cylinders in elasticity theory,
// tests/data/laminate.csv. Tolerance: what the radial stress changes, 0.15 % at r/h = 40 and 0.6 %
// at r/h = 10; the lengthening of a balanced wall is nearly zero in both.
TEST(Laminate, CrosscheckTubesByElasticityTheory) {
  const auto walls = reference_walls();
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("laminate")) {
    const std::string name = row.quantity.substr(0, row.quantity.find('.'));
    const bool strain = row.quantity.ends_with("axial_strain");
    if (!strain && !row.quantity.ends_with("rigidity")) continue;
    const double h = row("thickness");
    const TubeTorsion<> tube = tube_torsion<double>(walls.at(name), h, row("radius"));
    const double tolerance = h < 0.005 ? 0.0015 : 0.006;
    ++rows;
    if (!strain)
      test::expect_relative(tube.stiffness, row.value, tolerance);
    else if (std::abs(row.value) > 1e-9)
      test::expect_relative(tube.axial_strain, row.value, tolerance);
    else
      EXPECT_LT(std::abs(tube.axial_strain), 1e-10);
  }
  EXPECT_EQ(rows, 32);
}

// Kind: cross-check (LA-7), (LA-8).  Source: the four roots with 40 digits,
// tests/data/laminate.csv. Tolerance: 1e-10 of the largest of the three numbers, the digits of the
// source.
TEST(Laminate, CrosscheckEnergyOfCracksByRoots) {
  const auto walls = reference_walls();
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("laminate")) {
    const std::string name = row.quantity.substr(0, row.quantity.find('.'));
    const std::string part = row.quantity.substr(row.quantity.find('.') + 1);
    if (part == "rigidity" || part == "axial_strain") continue;
    const TipEnergy<> energy = tip_energy(sheet_compliance(wall_of(walls.at(name))), row("angle"));
    const double actual = part == "opening"    ? energy.opening
                          : part == "coupling" ? energy.coupling
                                               : energy.sliding;
    EXPECT_NEAR(actual, row.value, 1e-10 * std::max(energy.opening, energy.sliding)) << row.place;
    ++rows;
  }
  EXPECT_EQ(rows, 120);
}

// Kind: reference (LA-8).  Source: closed forms of an orthotropic sheet (Sih, Paris and Irwin), K =
// 1 MPa m^0.5, energies in J/m^2.  Tolerance: the digits of the source.
TEST(Laminate, ReferenceEnergyOfAnOrthotropicSheet) {
  constexpr double kSquare = 1e12;
  const InPlane<> a = sheet_compliance(wall_of(carbon({0})));
  const TipEnergy<> along = tip_energy(a, 0.0);
  test::expect_relative(along.opening * kSquare, 66.591143, 1e-8);
  test::expect_relative(along.sliding * kSquare, 15.885314, 5e-8);
  EXPECT_NEAR(along.coupling, 0, 1e-13 * along.opening);
  const TipEnergy<> across = tip_energy(a, pi / 2);
  test::expect_relative(across.opening, along.sliding, 1e-13);
  test::expect_relative(across.sliding, along.opening, 1e-13);
  const TipEnergy<> inclined = tip_energy(a, pi / 4);
  test::expect_relative(inclined.opening * kSquare, 41.238228, 2e-8);
  test::expect_relative((inclined.opening + 2 * inclined.coupling + inclined.sliding) * kSquare,
                        133.182286, 1e-8);
  // Closed form on a symmetry axis.
  const double root = std::sqrt(std::sqrt(a.m22 / a.m11) + (2 * a.m12 + a.m66) / (2 * a.m11));
  test::expect_relative(along.opening, std::sqrt(a.m11 * a.m22 / 2) * root, 1e-13);
  test::expect_relative(along.sliding, a.m11 / std::sqrt(2.0) * root, 1e-13);
}

// Kind: limit (LA-7).  Equal roots: an isotropic sheet has K^2/E at any angle, and walls close to
// it differ in proportion; quasi-isotropic and square-symmetric walls do not depend on the angle.
// Tolerance: rounding; 1e-6 of the difference for the neighbour.
TEST(Laminate, LimitOfEqualRoots) {
  for (const double angle : {0.0, 0.4, -1.3}) {
    const Lamina<> isotropic{.E1 = 210e9, .E2 = 210e9, .G12 = 210e9 / 2.6, .nu12 = 0.3};
    const TipEnergy<> same = tip_energy(inverse(reduced_stiffness(isotropic)), angle);
    test::expect_relative(same.opening, 1 / 210e9, 1e-13);
    test::expect_relative(same.sliding, 1 / 210e9, 1e-13);
    EXPECT_NEAR(same.coupling, 0, 1e-13 * same.opening);
    Lamina<> near = isotropic;
    near.E2 *= 1 + 1e-7;
    const TipEnergy<> close = tip_energy(inverse(reduced_stiffness(near)), angle);
    EXPECT_NEAR(close.opening / same.opening, 1, 1e-7);
    const TipEnergy<> quasi =
        tip_energy(sheet_compliance(wall_of(carbon({0, 45, -45, 90}))), angle);
    test::expect_relative(quasi.opening, 14.3521975776e-12, 1e-11);
    for (const std::vector<double>& square : {std::vector<double>{45, -45}, {0, 90}}) {
      const InPlane<> a = sheet_compliance(wall_of(carbon(square)));
      test::expect_relative(tip_energy(a, angle).opening, tip_energy(a, 0.0).opening, 1e-12);
      test::expect_relative(tip_energy(a, angle).sliding, tip_energy(a, 0.0).opening, 1e-12);
      EXPECT_NEAR(tip_energy(a, angle).coupling, 0, 1e-12 * tip_energy(a, 0.0).opening);
    }
  }
}

// Kind: cross-check (LA-8), (SN-2).  Derivatives of the energy and of the rigidity against
// differences of the values.  Tolerance: 1e-7, the error of central differences.
TEST(Laminate, CrosscheckDerivatives) {
  using D = DualReal;
  const auto walls = [](const auto& E1, const auto& angle) {
    using Real = std::decay_t<decltype(angle)>;
    const Lamina<Real> lamina{
        .E1 = Real(E1), .E2 = Real(10.3e9), .G12 = Real(7.17e9), .nu12 = Real(0.28)};
    return std::vector<LaminatePly<Real>>{{lamina, angle, Real(1.0)},
                                          {lamina, Real(-0.4), Real(2.0)}};
  };
  const auto both = [&](const auto& E1, const auto& angle) {
    using Real = std::decay_t<decltype(angle)>;
    const auto plies = walls(E1, angle);
    const InPlane<Real> a = sheet_compliance(laminate_stiffness<Real>(plies, Real(kWall)));
    const TipEnergy<Real> energy = tip_energy(a, Real(0.9));
    return std::array<Real, 4>{energy.opening, energy.coupling, energy.sliding,
                               tube_torsion<Real>(plies, Real(kWall), Real(kRadius)).stiffness};
  };
  D E1(181e9);
  E1.partial[0] = 1;
  D angle(0.5);
  angle.partial[1] = 1;
  const auto exact = both(E1, angle);
  const auto up_E = both(181e9 * (1 + 1e-5), 0.5);
  const auto down_E = both(181e9 * (1 - 1e-5), 0.5);
  const auto up = both(181e9, 0.5 + 1e-5);
  const auto down = both(181e9, 0.5 - 1e-5);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double scale = std::abs(exact[i].value);
    EXPECT_NEAR(exact[i].partial[0] * 181e9, (up_E[i] - down_E[i]) / 2e-5, 1e-7 * scale);
    EXPECT_NEAR(exact[i].partial[1], (up[i] - down[i]) / 2e-5, 1e-7 * scale);
  }
}

// Kind: reference (LA-6).  An isotropic wall has E h^3/(12 (1 - nu^2)); of two plies, the wall with
// the neutral surface where the hoop force vanishes, by the parallel axis theorem.  Tolerance:
// rounding.
TEST(Laminate, ReferenceBendingRoundTheTube) {
  const Lamina<> isotropic{.E1 = 210e9, .E2 = 210e9, .G12 = 210e9 / 2.6, .nu12 = 0.3};
  const std::vector<LaminatePly<>> one = {{isotropic, 0.2, 1}};
  test::expect_relative(hoop_bending_stiffness(wall_of(one)),
                        210e9 * std::pow(kWall, 3) / (12 * (1 - 0.09)), 1e-12);
  const std::vector<LaminatePly<>> two = {{kCarbon, 0, 1}, {kCarbon, pi / 2, 1}};
  const double soft = reduced_stiffness(kCarbon).m22;
  const double stiff = reduced_stiffness(kCarbon).m11;
  const double t = kWall / 2;
  const double neutral = (soft * -t / 2 + stiff * t / 2) / (soft + stiff);
  const auto part = [&](double E, double z) {
    return E * (t * t * t / 12 + t * (z - neutral) * (z - neutral));
  };
  test::expect_relative(hoop_bending_stiffness(wall_of(two)),
                        part(soft, -t / 2) + part(stiff, t / 2), 1e-12);
}

// Kind: behaviour (LA-10).  What counts as isotropic in its plane.
TEST(Laminate, BehaviourIsotropicInItsPlane) {
  EXPECT_TRUE(isotropic_in_plane(wall_of(carbon({0, 45, -45, 90}))));
  EXPECT_TRUE(isotropic_in_plane(wall_of(carbon({10, 70, -50}))));
  EXPECT_FALSE(isotropic_in_plane(wall_of(carbon({45, -45}))));
  EXPECT_FALSE(isotropic_in_plane(wall_of(carbon({0, 90}))));
  EXPECT_FALSE(isotropic_in_plane(wall_of(carbon({30}))));
}

// Kind: reference (LA-17).  Source: the means over the directions by quadrature over turned
// stiffnesses and compliances; an isotropic wall has E h^3/(12 (1 - nu^2)) and its nu in both.  The
// stiffer mean is the larger.  Tolerance: rounding.
TEST(Laminate, ReferenceMeanPlate) {
  const double nu = 0.27;
  const Lamina<> isotropic{.E1 = 210e9, .E2 = 210e9, .G12 = 210e9 / (2 * (1 + nu)), .nu12 = nu};
  const LaminateStiffness<> even = wall_of({{isotropic, 0.2, 1}});
  for (const EvenPlate<>& plate : {mean_plate(even), softest_plate(even)}) {
    test::expect_relative(plate.bending, 210e9 * std::pow(kWall, 3) / (12 * (1 - nu * nu)), 1e-12);
    test::expect_relative(plate.poissons_ratio, nu, 1e-12);
  }
  const LaminateStiffness<> wall = wall_of(carbon({0, 30, -75, 80}));
  InPlane<> stiffness;
  InPlane<> compliance;
  constexpr int kAngles = 16;
  for (int i = 0; i < kAngles; ++i) {
    const InPlane<> turned = turned_stiffness(wall.D, i * pi / kAngles);
    stiffness.add(turned, 1.0 / kAngles);
    compliance.add(inverse(turned), 1.0 / kAngles);
  }
  const EvenPlate<> upper = mean_plate(wall);
  test::expect_relative(upper.bending, stiffness.m11, 1e-12);
  test::expect_relative(upper.poissons_ratio, stiffness.m12 / stiffness.m11, 1e-12);
  test::expect_relative(upper.bending * (1 - upper.poissons_ratio) / 2, stiffness.m66, 1e-12);
  const InPlane<> soft = inverse(compliance);
  const EvenPlate<> lower = softest_plate(wall);
  test::expect_relative(lower.bending, soft.m11, 1e-12);
  test::expect_relative(lower.poissons_ratio, soft.m12 / soft.m11, 1e-12);
  EXPECT_LT(lower.bending, 0.8 * upper.bending);
}

// Kind: behaviour (LA-16).  What counts as a wall without couplings, and where the tolerance ends.
TEST(Laminate, BehaviourBalancedAndSymmetric) {
  const auto uncoupled = [](const std::vector<double>& degrees, double tolerance = 1e-9) {
    return balanced_and_symmetric(wall_of(carbon(degrees)), tolerance);
  };
  EXPECT_TRUE(uncoupled({45, -45, -45, 45}));
  EXPECT_TRUE(uncoupled({0, 90, 90, 0}));
  EXPECT_FALSE(uncoupled({30}));          // A16, A26
  EXPECT_FALSE(uncoupled({0, 90}));       // B11, B22
  EXPECT_FALSE(uncoupled({45, -45}));     // B16, B26
  EXPECT_FALSE(uncoupled({0, 60, -60}));  // B, although A is isotropic
  EXPECT_FALSE(uncoupled({45, -44, -44, 45}));
  EXPECT_TRUE(uncoupled({45, -44, -44, 45}, 0.05));
  // Each entry alone breaks the rule just above its limit: of A against the lesser of A11 and A22,
  // of B against this times half of the thickness.
  LaminateStiffness<> wall = wall_of(carbon({45, -45, -45, 45}));
  wall.A = {.m11 = 3e7, .m12 = 1e6, .m22 = 2e7, .m16 = 0, .m26 = 0, .m66 = 1e7};
  wall.B = {};
  wall.thickness = 2e-3;
  const auto limit = [&](double& entry, double at) {
    for (const double sign : {1.0, -1.0}) {
      entry = sign * at * 0.999;
      EXPECT_TRUE(balanced_and_symmetric(wall, 0.1));
      entry = sign * at * 1.001;
      EXPECT_FALSE(balanced_and_symmetric(wall, 0.1));
    }
    entry = 0;
  };
  limit(wall.A.m16, 2e6);
  limit(wall.A.m26, 2e6);
  for (double* const entry :
       {&wall.B.m11, &wall.B.m12, &wall.B.m22, &wall.B.m16, &wall.B.m26, &wall.B.m66})
    limit(*entry, 2e3);
  std::swap(wall.A.m11, wall.A.m22);
  limit(wall.A.m16, 2e6);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/axisymmetric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using std::numbers::pi;

constexpr Elasticity kSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};
constexpr double kRounding = 1e-10;  ///< of solving a few thousand equations

/// A tube r_i..r_o of length L, which is held at z = 0 and loaded at z = L.
SectionShape tube(double r_i, double r_o, double length) {
  return {
      .rectangles = {{r_i, r_o, 0, length, 0}},
      .fillets = {},
      .sides = {{true, 0, r_i, r_o, EdgeRole::held}, {true, length, r_i, r_o, EdgeRole::loaded}},
      .crack = {}};
}

/// An annular plate of thickness h, held at its bore and loaded at its rim.
SectionShape plate(double r_i, double r_o, double h) {
  return {.rectangles = {{r_i, r_o, 0, h, 0}},
          .fillets = {},
          .sides = {{false, r_i, 0, h, EdgeRole::held}, {false, r_o, 0, h, EdgeRole::loaded}},
          .crack = {}};
}

/// A shaft of 70 and 45 mm with a crack 4 mm deep from outside.
SectionShape cracked_shaft() {
  SectionShape shape = tube(0.0225, 0.035, 0.2);
  shape.crack = SectionCrack{.z = 0.1, .mouth = 0.035, .tip = 0.031};
  return shape;
}

SectionMesh mesh_of(const SectionShape& shape, double coarse) {
  return mesh_section(shape, {.coarse_r = coarse, .coarse_z = coarse});
}

/// Moves inner points at random and keeps the outline.
SectionMesh shaken(SectionMesh mesh, const SectionRectangle& box, double by) {
  for (SectionPoint& p : mesh.points) {
    const double room =
        std::min({p.r - box.r_from, box.r_to - p.r, p.z - box.z_from, box.z_to - p.z, by});
    if (room <= 0) continue;
    p.r += room * std::sin(40 * p.r + 70 * p.z);
    p.z += room * std::cos(90 * p.r - 30 * p.z);
  }
  return mesh;
}

double polar(double r_i, double r_o) { return pi / 2 * (std::pow(r_o, 4) - std::pow(r_i, 4)); }

// --- exact solutions

// (FE-1, FE-3, FE-4, FE-5): lambda = L/(mu J), psi is linear in z, which elements of every order
// contain.
TEST(SectionTorsion, ReferenceTubeIsExact) {
  const SectionShape shape = tube(0.07776, 0.08, 0.16);
  for (const int p : {1, 2, 6}) {
    const auto s = solve_section(mesh_of(shape, 0.02), SectionLoad::torsion, kSteel, {.order = p});
    EXPECT_NEAR(s.compliance * kSteel.shear_modulus() * polar(0.07776, 0.08) / 0.16, 1, kRounding);
    EXPECT_NEAR(s.energy_balance, 0, kRounding);
    EXPECT_LT(s.equilibrium_residual, 1e-8);
    EXPECT_FALSE(s.tip);
  }
}

TEST(SectionTorsion, IdentityPatchTestOnShakenMesh) {
  const SectionShape shape = tube(1, 2, 1.5);
  const SectionMesh mesh = shaken(mesh_of(shape, 0.3), shape.rectangles[0], 0.06);
  for (const int p : {1, 3}) {
    const auto s = solve_section(mesh, SectionLoad::torsion, {2.6, 0.3}, {.order = p});
    EXPECT_NEAR(s.compliance * polar(1, 2) / 1.5, 1, kRounding);
    EXPECT_LT(s.worst_jacobian, 0.9);
  }
}

// (FE-2): sigma_z = 1/A, u_z = z sigma/E, u_r = -nu r sigma/E.
TEST(SectionTension, IdentityPatchTestOnShakenMesh) {
  const SectionShape shape = tube(1, 2, 1.5);
  const SectionMesh mesh = shaken(mesh_of(shape, 0.3), shape.rectangles[0], 0.06);
  for (const int p : {2, 5}) {
    const auto s = solve_section(mesh, SectionLoad::tension, {2.0, 0.35}, {.order = p});
    EXPECT_NEAR(s.compliance * 2.0 * pi * 3 / 1.5, 1, kRounding);
    EXPECT_NEAR(s.energy_balance, 0, kRounding);
    EXPECT_LT(s.equilibrium_residual, 1e-8);
  }
}

TEST(SectionTension, ReferenceSolidBarIsHeldOnItsAxis) {
  const auto s = solve_section(mesh_of(tube(0, 1, 2), 0.5), SectionLoad::tension, {1.0, 0.3});
  EXPECT_NEAR(s.compliance * pi / 2, 1, kRounding);
}

/// lambda of an annular plate, (1/(4 pi mu h)) (1/r_i^2 - 1/r_o^2), and the error of a ring.
double plate_error(int p, int halvings) {
  const auto s = solve_section(mesh_of(plate(1, 2, 0.5), 1), SectionLoad::torsion, {2.6, 0.3},
                               {.order = p, .halvings = halvings});
  return s.compliance / ((1 - 0.25) / (4 * pi * 0.5)) - 1;
}

// The compliance is twice an energy, so its error falls as h^(2p).
TEST(SectionTorsion, ConvergencePlateInH) {
  for (const int p : {1, 2, 3}) {
    const double order = std::log2(plate_error(p, 2) / plate_error(p, 3));
    EXPECT_NEAR(order, 2 * p, 0.35) << p;
  }
}

TEST(SectionTorsion, ConvergencePlateInP) {
  double before = std::abs(plate_error(1, 0));
  for (int p = 2; p <= 6; ++p) {
    const double error = std::abs(plate_error(p, 0));
    EXPECT_LT(error, before / 5) << p;
    before = error;
  }
  EXPECT_LT(std::abs(plate_error(8, 1)), kRounding);
}

/// Volume displaced by pressure in the bore of a thick tube in plane strain over Lame's exact
/// value,
/// - 1.
double lame_error(int p, int halvings) {
  SectionShape shape = tube(1, 2, 0.5);
  shape.sides = {{true, 0, 1, 2, EdgeRole::held},
                 {true, 0.5, 1, 2, EdgeRole::held},
                 {false, 1, 0, 0.5, EdgeRole::loaded}};
  const double E = 3;
  const double nu = 0.3;
  const double u = (1 + nu) / E / 3 * ((1 - 2 * nu) + 4);  // (1+nu) p a^2/(E (b^2-a^2)) [...]
  const auto s = solve_section(mesh_of(shape, 1), SectionLoad::pressure, {E, nu},
                               {.order = p, .halvings = halvings});
  return s.compliance / (2 * pi * 0.5 * u) - 1;
}

TEST(SectionPressure, ConvergenceLameInHAndP) {
  for (const int p : {2, 3}) {
    const double order = std::log2(lame_error(p, 2) / lame_error(p, 3));
    EXPECT_NEAR(order, 2 * p, 0.4) << p;
  }
  EXPECT_LT(std::abs(lame_error(8, 1)), kRounding);
}

// A cone cut by spheres of radius 1 and 2: psi = const - 1/R^3, shear stress as r on the spheres.
// Straight chords instead of arcs would cause an error of several per cent.
double cone_error(int p) {
  const auto at = [](double radius, double angle) {
    return SectionPoint{radius * std::sin(angle), radius * std::cos(angle)};
  };
  SectionMesh mesh;
  constexpr std::size_t kPieces = 3;
  const double from = pi / 6;
  const double to = pi / 3;
  for (std::size_t k = 0; k <= kPieces; ++k) {
    const double angle = to + (from - to) * static_cast<double>(k) / kPieces;
    mesh.points.push_back(at(1, angle));
    mesh.points.push_back(at(2, angle));
  }
  for (std::size_t k = 0; k < kPieces; ++k) {
    mesh.cells.push_back({2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2});
    mesh.part.push_back(0);
    mesh.arcs.push_back({2 * k, 2 * k + 2, {0, 0}});
    mesh.arcs.push_back({2 * k + 1, 2 * k + 3, {0, 0}});
    mesh.roles.push_back({2 * k, 2 * k + 2, EdgeRole::held});
    mesh.roles.push_back({2 * k + 1, 2 * k + 3, EdgeRole::loaded});
  }
  const auto primitive = [](double x) { return std::pow(std::cos(x), 3) / 3 - std::cos(x); };
  const double exact = 7.0 / 24 / (2 * pi * (primitive(to) - primitive(from)));
  const auto s = solve_section(mesh, SectionLoad::torsion, {2.6, 0.3}, {.order = p, .halvings = 1});
  return std::abs(s.compliance / exact - 1);
}

TEST(SectionTorsion, ConvergenceConeWithArcs) {
  EXPECT_LT(cone_error(8), 1e-8);
  EXPECT_LT(cone_error(4), 1e-4);
  EXPECT_LT(cone_error(6), cone_error(4) / 10);
}

// --- what must be refused, and what must not matter

TEST(SectionMeshes, IdentityOrderOfVerticesDoesNotMatter) {
  const SectionMesh mesh = mesh_of(cracked_shaft(), 0.02);
  SectionMesh turned = mesh;
  for (std::size_t c = 0; c < turned.cells.size(); ++c)
    std::ranges::rotate(turned.cells[c], turned.cells[c].begin() + static_cast<long>(c * 7 % 4));
  for (const SectionLoad load : {SectionLoad::torsion, SectionLoad::tension}) {
    const auto a = solve_section(mesh, load, kSteel, {.order = 4});
    const auto b = solve_section(turned, load, kSteel, {.order = 4});
    EXPECT_NEAR(b.compliance / a.compliance, 1, kRounding);
    EXPECT_NEAR(b.tip->energy_release_rate / a.tip->energy_release_rate, 1, 1e-8);
  }
}

// Rectangles are integrated as products, any other cell point by point: moving points by 1e-11 of
// the section turns every cell into a general cell.
TEST(SectionMeshes, CrosscheckRectanglesAndAnyCell) {
  const SectionMesh mesh = mesh_of(cracked_shaft(), 0.035);
  SectionMesh moved = mesh;
  for (SectionPoint& p : moved.points)
    if (p.z > 0 && p.z != 0.1 && p.z < 0.2) p.z += 2e-12 * std::sin(1e3 * p.r + 700 * p.z);
  for (const SectionLoad load : {SectionLoad::torsion, SectionLoad::tension, SectionLoad::pressure})
    for (const int p : {2, 5}) {
      const auto a = solve_section(mesh, load, kSteel, {.order = p, .tip_rings = 4});
      const auto b = solve_section(moved, load, kSteel, {.order = p, .tip_rings = 4});
      EXPECT_EQ(a.worst_jacobian, 1);
      EXPECT_LT(b.worst_jacobian, 1);
      EXPECT_NEAR(b.compliance / a.compliance, 1, 1e-9);
      EXPECT_NEAR(b.tip->energy_release_rate / a.tip->energy_release_rate, 1, 1e-8);
      EXPECT_NEAR(b.tip->displacement_check, a.tip->displacement_check, 1e-8);
      EXPECT_LT(b.equilibrium_residual, 1e-8);
    }
}

TEST(SectionMeshes, InputTangledAndFoldedAreRefused) {
  SectionMesh tangled = mesh_of(tube(1, 2, 1), 0.3);
  for (SectionPoint& p : tangled.points)
    if (p.r > 1.4 && p.r < 1.6 && p.z > 0.4 && p.z < 0.6) p.r += 0.6;
  EXPECT_THROW((void)solve_section(tangled, SectionLoad::torsion, kSteel), InputError);
  // Corners are right, but the arc below bulges through the side above.
  SectionMesh folded{.points = {{1, 0}, {2, 0}, {2, 0.1}, {1, 0.1}},
                     .cells = {{0, 1, 2, 3}},
                     .part = {0},
                     .roles = {{3, 0, EdgeRole::held}, {1, 2, EdgeRole::loaded}},
                     .arcs = {{0, 1, {1.5, -0.6}}},
                     .crack = {},
                     .corners = {}};
  EXPECT_NO_THROW(check_mesh(folded));
  try {
    (void)solve_section(folded, SectionLoad::torsion, kSteel);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is folded"), std::string::npos) << error.what();
  }
}

TEST(SolveSection, InputEveryRuleBrokenOnce) {
  const SectionMesh sound = mesh_of(tube(1, 2, 1), 0.5);
  const auto refused = [&](const std::function<void(SectionMesh&, Elasticity&, SectionOptions&)>& f,
                           SectionLoad load) {
    SectionMesh mesh = sound;
    Elasticity steel = kSteel;
    SectionOptions options;
    f(mesh, steel, options);
    EXPECT_THROW((void)solve_section(mesh, load, steel, options), InputError);
  };
  const auto torsion = SectionLoad::torsion;
  refused([](auto&, auto& e, auto&) { e.youngs_modulus = 0; }, torsion);
  refused([](auto&, auto& e, auto&) { e.poissons_ratio = 0.5; }, torsion);
  refused([](auto&, auto& e, auto&) { e.poissons_ratio = -1; }, torsion);
  refused([](auto&, auto&, auto& o) { o.order = 0; }, torsion);
  refused([](auto&, auto&, auto& o) { o.order = 9; }, torsion);
  refused([](auto&, auto&, auto& o) { o.order = 1; }, SectionLoad::tension);
  refused([](auto&, auto&, auto& o) { o.tip_rings = 3; }, torsion);
  refused([](auto&, auto&, auto& o) { o.tip_rings = 17; }, torsion);
  refused([](auto&, auto&, auto& o) { o.corner_rings = -1; }, torsion);
  refused([](auto&, auto&, auto& o) { o.corner_rings = 17; }, torsion);
  refused([](auto&, auto&, auto& o) { o.halvings = -1; }, torsion);
  refused([](auto&, auto&, auto& o) { o.halvings = 6; }, torsion);
  for (const EdgeRole role : {EdgeRole::held, EdgeRole::loaded})
    refused([&](auto& m, auto&,
                auto&) { std::erase_if(m.roles, [&](auto& e) { return e.role == role; }); },
            torsion);
}

// At order 1 a cell between two held sides does not have unknowns.
TEST(SectionTorsion, IdentityCellHeldAllRound) {
  SectionShape shape = tube(1, 2, 3);
  shape.sides.push_back({false, 1, 0, 1, EdgeRole::held});
  shape.sides.push_back({false, 2, 0, 1, EdgeRole::held});
  const SectionMesh mesh = mesh_of(shape, 1);
  const auto s = solve_section(mesh, SectionLoad::torsion, {2.6, 0.3}, {.order = 1});
  EXPECT_NEAR(s.compliance * polar(1, 2) / 2, 1, kRounding);  // the part beyond z = 1
}

TEST(SolveSection, InputPartThatNothingHolds) {
  SectionShape two = tube(1, 2, 1);
  two.rectangles.push_back({1, 2, 2, 3, 0});
  two.sides[1].level = 3;
  try {
    (void)solve_section(mesh_of(two, 0.5), SectionLoad::torsion, kSteel, {.order = 3});
    ADD_FAILURE();
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("check that an edge of the section is held"),
              std::string::npos);
  }
}

// --- cracks

TEST(SectionCracks, ConvergenceComplianceRisesWithOrder) {
  const SectionMesh mesh = mesh_of(cracked_shaft(), 0.035);
  for (const SectionLoad load : {SectionLoad::torsion, SectionLoad::tension}) {
    double before = 0.0;
    double G_before = 0.0;
    for (int p = 2; p <= 8; ++p) {
      const auto s = solve_section(mesh, load, kSteel, {.order = p});
      EXPECT_GT(s.compliance, before) << p;
      EXPECT_NEAR(s.energy_balance, 0, kRounding);
      EXPECT_LT(s.equilibrium_residual, 1e-8);
      if (p >= 6) {
        EXPECT_LT(s.tip->ring_spread, 1e-6) << p;
        EXPECT_NEAR(s.tip->energy_release_rate / G_before, 1, 1e-4);
        EXPECT_NEAR(s.tip->displacement_check, 0, 1.5e-3);  // error of the cells at the crack tip
      }
      before = s.compliance;
      G_before = s.tip->energy_release_rate;
    }
  }
}

TEST(SectionCracks, ConvergenceRingsAndHalvings) {
  const SectionMesh mesh = mesh_of(cracked_shaft(), 0.035);
  const auto G = [&](const SectionOptions& options) {
    return solve_section(mesh, SectionLoad::tension, kSteel, options).tip->energy_release_rate;
  };
  const double best = G({.order = 7, .tip_rings = 14});
  const double rings4 = std::abs(G({.order = 6, .tip_rings = 5}) / best - 1);
  const double rings8 = std::abs(G({}) / best - 1);
  EXPECT_LT(rings8, 5e-5);
  EXPECT_LT(rings8, rings4 / 4);
  EXPECT_NEAR(G({.order = 4, .halvings = 1}) / best, 1, 3e-4);
}

// Scaling: lengths by 1000, moduli by 1e-6: K per torque scales with length^-5/2, G with 1/(E L^5).
TEST(SectionCracks, ScalingUnits) {
  const SectionMesh mesh = mesh_of(cracked_shaft(), 0.035);
  SectionMesh big = mesh;
  for (SectionPoint& p : big.points) p = {p.r * 1000, p.z * 1000};
  big.crack->tip = {big.crack->tip.r * 1000, big.crack->tip.z * 1000};
  big.crack->cell *= 1000;
  const auto a = solve_section(mesh, SectionLoad::torsion, kSteel);
  const auto b = solve_section(big, SectionLoad::torsion, {210e3, 0.3});
  EXPECT_NEAR(a.compliance / b.compliance * 1e-3, 1, 1e-9);  // 1/(E L^3)
  EXPECT_NEAR(a.tip->energy_release_rate / b.tip->energy_release_rate / 1e9, 1, 1e-8);
  EXPECT_NEAR(a.tip->K_III / b.tip->K_III / std::pow(1000, 2.5), 1, 1e-8);
}

// The same crack at the other end of the mirrored shaft, and independence of Poisson's ratio in
// torsion.
TEST(SectionCracks, IdentityMirrorAndPoisson) {
  SectionShape shape = cracked_shaft();
  shape.crack->z = 0.06;
  const SectionMesh mesh = mesh_of(shape, 0.035);
  SectionMesh mirrored = mesh;
  for (SectionPoint& p : mirrored.points) p.z = 0.2 - p.z;
  for (auto& cell : mirrored.cells) std::swap(cell[1], cell[3]);
  mirrored.crack->tip.z = 0.14;
  const auto a = solve_section(mesh, SectionLoad::torsion, kSteel, {.order = 4});
  const auto b = solve_section(mirrored, SectionLoad::torsion,
                               {2 * 1.1 * kSteel.shear_modulus(), 0.1}, {.order = 4});
  EXPECT_NEAR(a.tip->energy_release_rate / b.tip->energy_release_rate, 1, 1e-8);
  EXPECT_NEAR(a.compliance / b.compliance, 1, 1e-9);
}

// (FE-6, FE-7): K_I, K_III > 0 for loads > 0 on either side of the loaded end; G from K equals G.
TEST(SectionCracks, IdentitySignsAndRelease) {
  for (const bool from_outside : {true, false}) {
    SectionShape shape = tube(0.0225, 0.035, 0.2);
    shape.crack = SectionCrack{
        .z = 0.1, .mouth = from_outside ? 0.035 : 0.0225, .tip = from_outside ? 0.031 : 0.0265};
    const SectionMesh mesh = mesh_of(shape, 0.035);
    const auto torsion = *solve_section(mesh, SectionLoad::torsion, kSteel).tip;
    const auto tension = *solve_section(mesh, SectionLoad::tension, kSteel).tip;
    EXPECT_GT(torsion.K_III, 0);
    EXPECT_EQ(torsion.K_I, 0);
    EXPECT_GT(tension.K_I, 0);
    EXPECT_EQ(tension.K_III, 0);
    EXPECT_NEAR(tension.K_II / tension.K_I, 0, 1e-5);  // by symmetry
    EXPECT_NEAR(
        torsion.K_III * torsion.K_III / (2 * kSteel.shear_modulus()) / torsion.energy_release_rate,
        1, 1e-12);
    EXPECT_NEAR((tension.K_I * tension.K_I + tension.K_II * tension.K_II) * (1 - 0.09) / 210e9 /
                    tension.energy_release_rate,
                1, 1e-12);
  }
}

}  // namespace
}  // namespace strainwave::fem

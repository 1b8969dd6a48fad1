// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/swept_section.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/axisymmetric.hpp"
#include "strainwave/fem/solid.hpp"
#include "support/expect.hpp"
#include "support/mpi.hpp"

namespace strainwave::fem {
namespace {

using std::numbers::pi;

constexpr Elasticity kSweptSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};
constexpr double kWide = 0.03;
constexpr double kNarrow = 0.022;
constexpr double kBore = 0.015;

/// A hollow shaft, its shoulder rounded by a fillet: arcs, and cells that turn.
SectionMesh shouldered() {
  return mesh_section(
      {.rectangles = {{kBore, kNarrow, 0, 0.02, 0},
                      {kNarrow, kWide, 0, 0.02, 0},
                      {kBore, kNarrow, 0.02, 0.05, 1}},
       .fillets = {{.corner = {kNarrow, 0.02}, .void_r = 1, .void_z = 1, .radius = 2e-3}},
       .sides = {{.level = 0, .from = kBore, .to = kWide, .role = EdgeRole::held},
                 {.level = 0.05, .from = kBore, .to = kNarrow, .role = EdgeRole::loaded}},
       .crack = {}},
      {.coarse_r = 0.02, .coarse_z = 0.02});
}

std::vector<double> full_turn(int cells) {
  std::vector<double> angles;
  for (int i = 0; i <= cells; ++i) angles.push_back(pi * (2.0 * i / cells - 1));
  return angles;
}

HexMesh solid_of(const SectionMesh& section, const std::vector<double>& around) {
  const TemplateBody body{.map = revolved,
                          .on_crack = {},
                          .face_tag = [&section](const Point3& p) -> int {
                            const auto role = role_at(section, {p[2], p[1]});
                            return !role ? 0 : *role == EdgeRole::held ? 1 : 2;
                          },
                          .length = kWide};
  return make_hex_mesh(swept_section(section, around), body);
}

// Torsion of the solid and of its meridian section, with different elements, assembly and solver.
TEST(SweptSection, CrosscheckTorsionOfAShoulderWithAFillet) {
  test::start_mpi();
  const SectionMesh section = shouldered();
  const double expected = solve_section(section, SectionLoad::torsion, kSweptSteel).compliance;
  const HexMesh mesh = solid_of(section, full_turn(8));
  EXPECT_GT(check_jacobians(mesh), 0.3);
  SolidProblem problem{.material = kSweptSteel, .supports = {}, .order = 3};
  problem.supports.push_back({.tag = 1, .directions = [](const Point3&) {
                                return std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                              }});
  const double J = pi / 2 * (std::pow(kNarrow, 4) - std::pow(kBore, 4));
  const SolidLoad torque{.tractions = {{.tag = 2,
                                        .value =
                                            [J](const Point3& p) {
                                              return Point3{-p[1] / J, p[0] / J, 0};
                                            }}},
                         .stress_without_crack = {}};
  const SolidResult solid = solve_solid(mesh, problem, torque);
  // The tolerance is the discretisation at order 3; a solid converges from below.
  test::expect_relative(solid.work, expected, 2e-3);
  EXPECT_LT(solid.work, expected);
  EXPECT_LT(solid.energy_balance, 1e-9);
}

TEST(SweptSection, IdentityArcsStayArcs) {
  const SectionMesh section = shouldered();
  ASSERT_EQ(section.arcs.size(), 2U);
  const SectionPoint centre = section.arcs.front().centre;
  int on_arc = 0;
  for (const TemplateCell& cell : swept_section(section, {0, 0.5}))
    for (std::size_t i = 0; i < 4; ++i) {
      // Quarter points of the edges of the section's cell.
      const std::array<Point3, 4> edge{
          Point3{0, 0.25, 0}, {0, 0.25, 1}, {0, 0, 0.25}, {0, 1, 0.25}};
      const Point3 p = cell.map(edge[i]);
      EXPECT_EQ(p[0], 0.0);
      if (std::abs(std::hypot(p[2] - centre.r, p[1] - centre.z) / 2e-3 - 1) < 1e-12) ++on_arc;
    }
  EXPECT_EQ(on_arc, 2);
}

TEST(SweptSection, IdentityRolesByMiddle) {
  const SectionMesh section = shouldered();
  double held = 0;
  for (const RoleEdge& role : section.roles) {
    const SectionPoint& a = section.points[role.first];
    const SectionPoint& b = section.points[role.second];
    EXPECT_EQ(role_at(section, {(a.r + b.r) / 2, (a.z + b.z) / 2}), role.role);
    EXPECT_FALSE(role_at(section, {(a.r + 3 * b.r) / 4, (a.z + 3 * b.z) / 4}));
    if (role.role == EdgeRole::held) held += b.r - a.r;
  }
  EXPECT_NEAR(std::abs(held), kWide - kBore, 1e-12);
  EXPECT_FALSE(role_at(section, {kBore, 0.01}));
}

TEST(SweptSection, InputEveryRuleBrokenOnce) {
  const SectionMesh good = shouldered();
  EXPECT_EQ(swept_section(good, full_turn(4)).size(), 4 * good.cells.size());
  const auto refused = [](const SectionMesh& section, const std::vector<double>& around) {
    return test::broken_rule([&] { return swept_section(section, around); });
  };
  EXPECT_EQ(refused(good, {0}).rfind("around", 0), 0U);
  EXPECT_EQ(refused(good, {0, 0}).rfind("around[1]", 0), 0U);
  EXPECT_EQ(refused(good, {0, 1, 2.6}).rfind("around[2]", 0), 0U);
  SectionMesh section = good;
  section.cells.clear();
  EXPECT_EQ(refused(section, {0, 1}).rfind("mesh", 0), 0U);
  section = good;
  section.crack = CrackTip{};
  EXPECT_EQ(refused(section, {0, 1}).rfind("section.crack", 0), 0U);
  section = good;
  for (SectionPoint& point : section.points)
    if (point.r == kBore) point.r = 0;
  EXPECT_NE(refused(section, {0, 1}).find("> 0 in a swept section"), std::string::npos);
}

}  // namespace
}  // namespace strainwave::fem

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/section_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

/// The unit square, one cell, held below and loaded above.
SectionMesh square() {
  return {.points = {{1, 0}, {2, 0}, {2, 1}, {1, 1}},
          .cells = {{0, 1, 2, 3}},
          .part = {0},
          .roles = {{0, 1, EdgeRole::held}, {2, 3, EdgeRole::loaded}},
          .arcs = {},
          .crack = {},
          .corners = {}};
}

void expect_refused(const SectionMesh& mesh, const std::string& sentence) {
  try {
    check_mesh(mesh);
    ADD_FAILURE() << "accepted; expected: " << sentence;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
  }
}

double area(const SectionMesh& mesh) {
  double sum = 0.0;
  for (const auto& cell : mesh.cells)
    for (std::size_t k = 0; k < 4; ++k) {
      const SectionPoint& a = mesh.points[cell[k]];
      const SectionPoint& b = mesh.points[cell[(k + 1) % 4]];
      sum += (a.r * b.z - b.r * a.z) / 2;
    }
  return sum;
}

/// An L: a leg r 1..2 up to z = 2, on a foot r 1..4 of height 1; the corner is at (2, 1).
SectionShape angle_section() {
  return {.rectangles = {{1, 2, 0, 1, 0}, {2, 4, 0, 1, 0}, {1, 2, 1, 3, 1}},
          .fillets = {},
          .sides = {{true, 0, 1, 4, EdgeRole::held}, {true, 3, 1, 2, EdgeRole::loaded}},
          .crack = {}};
}
constexpr SectionSpacing kCoarse{.coarse_r = 1, .coarse_z = 1};

TEST(CheckMesh, IdentitySoundMeshPasses) {
  EXPECT_NO_THROW(check_mesh(square()));
  EXPECT_DOUBLE_EQ(mesh_quality(square()).worst_corner_sine, 1.0);
  SectionMesh leaning = square();
  leaning.points[2].r += std::sqrt(3.0);
  leaning.points[3].r += std::sqrt(3.0);
  EXPECT_NEAR(mesh_quality(leaning).worst_corner_sine, 0.5, 1e-15);  // sine of 30 degrees
}

TEST(CheckMesh, InputEveryRuleBrokenOnce) {
  const std::vector<std::pair<std::function<void(SectionMesh&)>, std::string>> broken = {
      {[](SectionMesh& m) { m.cells.clear(); }, "has no cells"},
      {[](SectionMesh& m) { m.part.push_back(0); }, "one entry for each cell"},
      {[](SectionMesh& m) { m.cells[0][2] = 9; }, "point 9 does not exist"},
      {[](SectionMesh& m) { m.points[0].r = -1e-3; }, ">= 0, and z finite"},
      {[](SectionMesh& m) { m.points[0].z = std::nan(""); }, ">= 0, and z finite"},
      {[](SectionMesh& m) { std::swap(m.cells[0][1], m.cells[0][3]); }, "inside out"},  // clockwise
      {[](SectionMesh& m) { std::swap(m.cells[0][1], m.cells[0][2]); }, "inside out"},  // crossed
      {[](SectionMesh& m) {
         m.points[2] = {1.2, 0.2};
       },
       "inside out"},                                                     // arrow head
      {[](SectionMesh& m) { m.points[2] = m.points[1]; }, "inside out"},  // flat
      {[](SectionMesh& m) { m.roles[0].second = 2; }, "not an edge of the boundary"},
      {[](SectionMesh& m) {
         m.arcs = {{0, 2, {1.5, 0.5}}};
       },
       "not an edge of a cell"},
      {[](SectionMesh& m) {
         m.arcs = {{0, 1, {1.4, 3}}};
       },
       "equally far"},
      {[](SectionMesh& m) {
         for (int n = 0; n < 2; ++n) {
           m.cells.push_back(m.cells[0]);
           m.part.push_back(0);
         }
       },
       "belongs to 3 cells"},
  };
  for (const auto& [change, sentence] : broken) {
    SectionMesh mesh = square();
    change(mesh);
    expect_refused(mesh, sentence);
  }
}

TEST(GridLines, IdentityBreaksAreLinesAndSpacingGrows) {
  const auto lines = grid_lines({.breaks = {3, 0, 1, 1}, .focus = {{1, 0.1}}, .coarse = 0.8});
  EXPECT_TRUE(std::ranges::is_sorted(lines));
  for (const double line : {0.0, 1.0, 3.0}) EXPECT_EQ(std::ranges::count(lines, line), 1) << line;
  const auto at = static_cast<std::size_t>(std::ranges::find(lines, 1.0) - lines.begin());
  EXPECT_LT(lines[at + 1] - 1, 0.3);                       // the grid is fine at the focus
  EXPECT_GT(lines.back() - lines[lines.size() - 2], 0.5);  // the grid is coarse far from the focus
  for (std::size_t k = 1; k < lines.size(); ++k) EXPECT_LT(lines[k] - lines[k - 1], 0.9);
}

TEST(GridLines, IdentityWholeIntervalsAreKept) {
  const auto lines = grid_lines(
      {.breaks = {0, 1, 3}, .focus = {{1, 0.1}}, .coarse = 0.8, .growth = 1, .whole = {{1, 3}}});
  EXPECT_EQ(lines.back(), 3);
  EXPECT_EQ(lines[lines.size() - 2], 1);
  EXPECT_GT(lines.size(), 4U);
}

TEST(GridLines, InputRules) {
  EXPECT_THROW((void)grid_lines({.breaks = {0, 1}, .focus = {}, .coarse = 0}), InputError);
  EXPECT_THROW((void)grid_lines({.breaks = {0, 1}, .focus = {}, .coarse = 1, .growth = 0}),
               InputError);
  EXPECT_THROW((void)grid_lines({.breaks = {0, 1}, .focus = {{0, 0}}, .coarse = 1}), InputError);
}

TEST(MeshSection, IdentityAreaPartsRolesAndCorner) {
  const SectionMesh mesh = mesh_section(angle_section(), kCoarse);
  EXPECT_NEAR(area(mesh), 5, 1e-12);
  double held = 0.0;
  double loaded = 0.0;
  for (const RoleEdge& role : mesh.roles) {
    const double length = std::abs(mesh.points[role.first].r - mesh.points[role.second].r);
    (role.role == EdgeRole::held ? held : loaded) += length;
  }
  EXPECT_NEAR(held, 3, 1e-12);
  EXPECT_NEAR(loaded, 1, 1e-12);
  ASSERT_EQ(mesh.corners.size(), 1U);
  EXPECT_EQ(mesh.corners[0].r, 2);
  EXPECT_EQ(mesh.corners[0].z, 1);
}

TEST(MeshSection, IdentityFilletInEachOfFourDirections) {
  // The polygon with the fillet is larger by its chords: (1 - sqrt(1/2)) rho^2.
  const double rho = 0.3;
  const double more = (1 - std::numbers::sqrt2 / 2) * rho * rho;
  for (const double void_r : {1.0, -1.0})
    for (const double void_z : {1.0, -1.0}) {
      SectionShape shape = angle_section();
      for (SectionRectangle& box : shape.rectangles) {
        if (void_r < 0) std::tie(box.r_from, box.r_to) = std::pair(6 - box.r_to, 6 - box.r_from);
        if (void_z < 0) std::tie(box.z_from, box.z_to) = std::pair(-box.z_to, -box.z_from);
      }
      shape.sides.clear();
      const SectionPoint corner{void_r > 0 ? 2.0 : 4.0, void_z > 0 ? 1.0 : -1.0};
      shape.fillets = {{corner, void_r, void_z, rho}};
      const SectionMesh mesh = mesh_section(shape, kCoarse);
      EXPECT_NEAR(area(mesh), 5 + more, 1e-12) << void_r << ' ' << void_z;
      EXPECT_EQ(mesh.arcs.size(), 2U);
      EXPECT_TRUE(mesh.corners.empty());
    }
}

TEST(MeshSection, IdentityCrackFacesAreDoubled) {
  for (const bool from_outside : {true, false}) {
    SectionShape shape = angle_section();
    shape.crack = SectionCrack{.z = 2, .mouth = from_outside ? 2.0 : 1.0, .tip = 1.6};
    const SectionMesh mesh = mesh_section(shape, kCoarse);
    EXPECT_NEAR(area(mesh), 5, 1e-12);
    std::map<std::pair<double, double>, int> places;
    for (const SectionPoint& p : mesh.points) ++places[{p.r, p.z}];
    for (const auto& [place, count] : places) {
      const bool on_face = place.second == 2 && place.first >= 1 - 1e-9 &&
                           (from_outside ? place.first > 1.6 + 1e-9 : place.first < 1.6 - 1e-9);
      EXPECT_EQ(count, on_face ? 2 : 1) << place.first << ' ' << place.second;
    }
    EXPECT_EQ(mesh.crack->direction, from_outside ? -1 : 1);
    EXPECT_NEAR(mesh.crack->cell, from_outside ? 0.2 : 0.2,
                1e-12);  // half of the smaller distance, 0.4
  }
}

TEST(MeshSection, InputEveryRuleBrokenOnce) {
  const std::vector<std::pair<std::function<void(SectionShape&)>, std::string>> broken = {
      {[](SectionShape& s) { s.rectangles.clear(); }, "must have at least one"},
      {[](SectionShape& s) {
         s.rectangles.push_back({1.5, 2, 0, 1, 0});
       },
       "overlap"},
      {[](SectionShape& s) { s.rectangles[0].r_from = -1; }, ">= 0"},
      {[](SectionShape& s) { s.rectangles[0].r_to = 1; }, "> r_from"},
      {[](SectionShape& s) { s.rectangles[0].z_to = 0; }, "> z_from"},
      {[](SectionShape& s) {
         s.fillets = {{{2, 1}, 1, 1, 0}};
       },
       "> 0"},
      {[](SectionShape& s) {
         s.fillets = {{{4, 1}, 1, 1, 0.1}};
       },
       "re-entrant corner"},
      {[](SectionShape& s) {
         s.fillets = {{{2, 1}, 1, 1, 3}};
       },
       "inside out"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{2, 2, 2.5};
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{2, 1.9, 1.5};
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{5, 2, 1.5};
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{2, 2, 1};  // through the whole wall
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{2, 1, 2};
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{1, 2, 1.5};  // in the line between two rectangles
       },
       "inside one rectangle"},
      {[](SectionShape& s) {
         s.crack = SectionCrack{3, 2, 1.5};  // in the end
       },
       "inside one rectangle"},
  };
  for (const auto& [change, sentence] : broken) {
    SectionShape shape = angle_section();
    change(shape);
    try {
      (void)mesh_section(shape, kCoarse);
      ADD_FAILURE() << "accepted; expected: " << sentence;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)mesh_section(angle_section(), {.coarse_r = 0, .coarse_z = 1}), InputError);
  EXPECT_THROW((void)mesh_section(angle_section(), {.coarse_r = 1, .coarse_z = 0}), InputError);
}

TEST(WithLongerCrack, IdentityTipMovesAndTheRestStays) {
  SectionShape shape = angle_section();
  shape.crack = SectionCrack{.z = 2, .mouth = 2.0, .tip = 1.6};
  const SectionMesh mesh = mesh_section(shape, kCoarse);
  const SectionMesh longer = with_longer_crack(mesh, 0.02);
  EXPECT_NEAR(longer.crack->tip.r, 1.58, 1e-15);
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    const double away = std::max(std::abs(mesh.points[n].r - 1.6), std::abs(mesh.points[n].z - 2));
    const double moved = longer.points[n].r - mesh.points[n].r;
    EXPECT_NEAR(moved, -0.02 * std::clamp(2 - away / 0.2, 0.0, 1.0), 1e-12);
  }
  check_mesh(longer);
  EXPECT_THROW((void)with_longer_crack(mesh, 0.09), InputError);
  EXPECT_THROW((void)with_longer_crack(mesh_section(angle_section(), kCoarse), 0.01), InputError);
}

}  // namespace
}  // namespace strainwave::fem

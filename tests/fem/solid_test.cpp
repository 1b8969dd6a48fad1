// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/hex_mesh.hpp"
#include "support/expect.hpp"
#include "support/mpi.hpp"

namespace strainwave::fem {
namespace {

using std::numbers::pi;

constexpr Elasticity kSolidSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

enum Tag { kLow = 1, kHigh = 2, kSide = 3 };

/// n[0] x n[1] x n[2] cells of the unit cube, carried to a body.
HexMesh grid(const std::array<int, 3>& n, const PointMap& map) {
  std::vector<TemplateCell> cells;
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k) {
        TemplateCell cell;
        cell.map = [=](const Point3& p) {
          return Point3{(i + p[0]) / n[0], (j + p[1]) / n[1], (k + p[2]) / n[2]};
        };
        cells.push_back(cell);
      }
  TemplateBody body;
  body.map = map;
  body.face_tag = [](const Point3& p) -> int {
    if (p[2] < 1e-9) return kLow;
    return p[2] > 1 - 1e-9 ? kHigh : kSide;
  };
  body.length = 1;
  return make_hex_mesh(cells, body);
}

Point3 same(const Point3& p) { return p; }

/// A tube R = 10, t = 1, L = 10, twisted by unit torque.
SolidResult twisted_tube(int order, int round = 4, CrackFaces faces = CrackFaces::free) {
  const HexMesh mesh = grid({round, 1, 1}, [](const Point3& p) {
    const double r = 10.5 - p[1];
    return Point3{r * std::cos(2 * pi * p[0]), r * std::sin(2 * pi * p[0]), 10 * p[2]};
  });
  SolidProblem problem;
  problem.material = kSolidSteel;
  problem.order = order;
  problem.crack_faces = faces;
  problem.supports = {{.tag = kLow, .directions = [](const Point3&) {
                         return std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                       }}};
  const double J = pi / 2 * (std::pow(10.5, 4) - std::pow(9.5, 4));
  problem.tractions = {{.tag = kHigh, .value = [J](const Point3& p) {
                          return Point3{-p[1] / J, p[0] / J, 0};
                        }}};
  return solve_solid(mesh, problem);
}

double exact_tube() {
  return 10 / (kSolidSteel.youngs_modulus / 2.6 * pi / 2 * (std::pow(10.5, 4) - std::pow(9.5, 4)));
}

// (FE-20): a linear field is exact in any mesh, distorted ones included.
TEST(Solid, IdentityPatchTest) {
  test::start_mpi();
  std::vector<TemplateCell> cells;  // trilinear; the vertex in the middle is moved
  for (int c = 0; c < 8; ++c) {
    TemplateCell cell;
    cell.map = [c](const Point3& p) {
      Point3 x{(p[0] + (c & 1)) / 2, (p[1] + (c >> 1 & 1)) / 2, (p[2] + (c >> 2 & 1)) / 2};
      double middle = 1;
      for (std::size_t k = 0; k < 3; ++k) middle *= (c >> k & 1) ? 1 - p[k] : p[k];
      return Point3{x[0] + 0.1 * middle, x[1] - 0.07 * middle, x[2] + 0.12 * middle};
    };
    cells.push_back(cell);
  }
  TemplateBody body;
  body.map = same;
  body.face_tag = [](const Point3& p) -> int {
    return p[2] < 1e-9 ? kLow : p[2] > 1 - 1e-9 ? kHigh : 0;
  };
  body.length = 1;
  const HexMesh mesh = make_hex_mesh(cells, body);
  for (const int order : {1, 2, 3}) {
    SolidProblem problem;
    problem.material = kSolidSteel;
    problem.order = order;
    problem.supports = {{.tag = kLow, .directions = [](const Point3& p) {
                           std::vector<Point3> held{{0, 0, 1}};
                           if (p[0] < 1e-9 && p[1] < 1e-9) held = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                           if (p[0] > 1 - 1e-9 && p[1] < 1e-9) held.push_back({0, 1, 0});
                           return held;
                         }}};
    const double sigma = 1e6;
    problem.tractions = {{.tag = kHigh, .value = [=](const Point3&) {
                            return Point3{0, 0, sigma};
                          }}};
    const SolidResult result = solve_solid(mesh, problem);
    // Rounding of a direct solver; force sigma, displacement sigma/E.
    test::expect_relative(result.work, sigma * sigma / kSolidSteel.youngs_modulus, 1e-11);
    EXPECT_LT(result.energy_balance, 1e-11);
    EXPECT_LT(result.equilibrium_residual, 1e-11);  // (FE-21)
    EXPECT_LT(result.worst_jacobian, 1.0);
    EXPECT_EQ(result.cells, 8U);
    EXPECT_EQ(result.dofs, static_cast<std::size_t>(3 * std::pow(2 * order + 1, 3)));
  }
}

// Compliance rises with p toward L/(mu J): displacements of a conforming element store too much.
TEST(Solid, ConvergenceOfTheTwistedTube) {
  test::start_mpi();
  double error = 1;
  for (const int order : {1, 2, 3, 4, 5}) {
    const SolidResult result = twisted_tube(order, 6);
    const double now = 1 - result.work / exact_tube();
    EXPECT_GT(now, order < 4 ? 0 : -1e-6) << order;  // geometry of order 4: 60 degrees to 1e-6
    EXPECT_LT(now, 0.2 * error) << order;
    error = std::max(now, 1e-6);
  }
}

// Cells halved round the tube only, geometry of a higher order than the displacements: the order
// of the energy is 3.2 here (12 to 24 cells), short of the 2p = 4 of a regular refinement.
TEST(Solid, ConvergenceWithTheCells) {
  test::start_mpi();
  const double coarse = 1 - twisted_tube(2, 12).work / exact_tube();
  const double fine = 1 - twisted_tube(2, 24).work / exact_tube();
  EXPECT_GT(fine, 0);
  EXPECT_GT(std::log2(coarse / fine), 3.0);
}

// (FE-22)
TEST(Solid, InputTangledAndLeftHandedMeshesAreRefused) {
  test::start_mpi();
  EXPECT_NEAR(check_jacobians(grid({2, 1, 1}, same)), 1.0, 1e-12);
  const auto refused = [](const HexMesh& mesh) {
    try {
      (void)check_jacobians(mesh);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string left = refused(grid({1, 1, 1}, [](const Point3& p) {
    return Point3{p[0], p[1], -p[2]};
  }));
  EXPECT_NE(left.find("mesh: cell 0 is tangled or left-handed"), std::string::npos) << left;
  const std::string folded = refused(grid({2, 1, 1}, [](const Point3& p) {  // x turns back
    return Point3{p[0] - 1.2 * p[0] * p[0] * p[0], p[1], p[2]};
  }));
  EXPECT_NE(folded.find("mesh: cell 1"), std::string::npos) << folded;
}

TEST(Solid, InputValuesOutOfRangeAreRefused) {
  test::start_mpi();
  const HexMesh mesh = grid({1, 1, 1}, same);
  const auto fails = [&](const SolidProblem& problem, const std::string& field) {
    try {
      (void)solve_solid(mesh, problem);
    } catch (const InputError& error) {
      return error.field() == field;
    }
    return false;
  };
  SolidProblem problem;
  problem.material = kSolidSteel;
  problem.material.youngs_modulus = 0;
  EXPECT_TRUE(fails(problem, "youngs_modulus"));
  problem.material = {.youngs_modulus = 1, .poissons_ratio = 0.5};
  EXPECT_TRUE(fails(problem, "poissons_ratio"));
  problem.material.poissons_ratio = -0.1;
  EXPECT_TRUE(fails(problem, "poissons_ratio"));
  problem.material = kSolidSteel;
  problem.order = 0;
  EXPECT_TRUE(fails(problem, "order"));
  problem.order = 7;
  EXPECT_TRUE(fails(problem, "order"));
  EXPECT_THROW((void)make_hex_mesh({}, {}), InputError);
  EXPECT_THROW((void)twisted_tube(2, 4, CrackFaces::contact), InputError);  // without a crack
}

}  // namespace
}  // namespace strainwave::fem

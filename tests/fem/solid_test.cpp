// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
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

/// A tube of mean radius 10 and length 10 under unit torque.
SolidResult twisted_tube(int order, int round = 4, double wall = 1,
                         CrackFaces faces = CrackFaces::free) {
  const double outer = 10 + wall / 2;
  const HexMesh mesh = grid({round, 1, 1}, [=](const Point3& p) {
    const double r = outer - wall * p[1];
    return Point3{r * std::cos(2 * pi * p[0]), r * std::sin(2 * pi * p[0]), 10 * p[2]};
  });
  SolidProblem problem;
  problem.material = kSolidSteel;
  problem.order = order;
  problem.crack_faces = faces;
  problem.supports = {{.tag = kLow, .directions = [](const Point3&) {
                         return std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                       }}};
  const double J = pi / 2 * (std::pow(outer, 4) - std::pow(outer - wall, 4));
  const SolidLoad torque{.tractions = {{.tag = kHigh,
                                        .value =
                                            [J](const Point3& p) {
                                              return Point3{-p[1] / J, p[0] / J, 0};
                                            }}},
                         .stress_without_crack = {}};
  return solve_solid(mesh, problem, torque);
}

double exact_tube(double wall = 1) {
  return 10 / (kSolidSteel.youngs_modulus / 2.6 * pi / 2 *
               (std::pow(10 + wall / 2, 4) - std::pow(10 - wall / 2, 4)));
}

// (FE-20): a linear field is exact in any mesh, distorted ones included.
TEST(Solid, IdentityPatchTest) {
  test::start_mpi();
  std::vector<TemplateCell> cells;  // trilinear cells with the middle vertex moved
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
    const SolidLoad pull{.tractions = {{.tag = kHigh,
                                        .value =
                                            [=](const Point3&) {
                                              return Point3{0, 0, sigma};
                                            }}},
                         .stress_without_crack = {}};
    const SolidResult result = solve_solid(mesh, problem, pull);
    // The tolerance is rounding of a direct solver; force sigma, displacement sigma/E.
    test::expect_relative(result.work, sigma * sigma / kSolidSteel.youngs_modulus, 1e-11);
    EXPECT_LT(result.energy_balance, 1e-11);
    EXPECT_LT(result.equilibrium_residual, 1e-11);  // (FE-21)
    EXPECT_LT(result.worst_jacobian, 1.0);
    EXPECT_EQ(result.cells, 8U);
    EXPECT_EQ(result.dofs, static_cast<std::size_t>(3 * std::pow(2 * order + 1, 3)));
  }
}

// Compliance rises with p toward L/(mu J): conforming elements are too stiff.
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

// Cells are halved round the tube only; the order of the energy is 2p.  A thin wall reaches this
// order late.  While a cell is much longer than the wall's thickness, bending of the wall absorbs a
// part of the error, so coarse meshes are more accurate than the asymptotic law predicts.  Wall 1:
// order 3.5, 3.2, 3.7, 3.9 for 6 to 96 cells; wall 8, the same clamp, load and geometry: 4.0 from
// the start; without Poisson's ratio it is the same.
TEST(Solid, ConvergenceWithTheCells) {
  test::start_mpi();
  const auto order = [](int cells, double wall) {
    const double coarse = 1 - twisted_tube(2, cells, wall).work / exact_tube(wall);
    const double fine = 1 - twisted_tube(2, 2 * cells, wall).work / exact_tube(wall);
    EXPECT_GT(fine, 0);
    return std::log2(coarse / fine);
  };
  EXPECT_NEAR(order(12, 8), 4, 0.1);
  EXPECT_NEAR(order(48, 1), 4, 0.15);
  EXPECT_LT(order(12, 1), 3.5);
}

/// Work of unit pressure in the bore of a quarter of a thick tube 1 to 2 in plane strain, as 1
/// minus its ratio to Lame's value.
double lame_defect(int order, int cells) {
  const double height = 0.5;
  const HexMesh mesh = [&] {
    std::vector<TemplateCell> template_cells;
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j)
        template_cells.push_back({.map =
                                      [=](const Point3& p) {
                                        return Point3{(i + p[0]) / cells, (j + p[1]) / cells, p[2]};
                                      },
                                  .side = 0,
                                  .front = std::nullopt});
    TemplateBody body;
    body.map = [=](const Point3& p) {
      const double r = 2 - p[1];
      return Point3{r * std::cos(pi / 2 * p[0]), r * std::sin(pi / 2 * p[0]), height * p[2]};
    };
    body.face_tag = [](const Point3& p) -> int {
      if (p[2] < 1e-9 || p[2] > 1 - 1e-9) return 3;
      if (p[0] < 1e-9) return 2;
      if (p[0] > 1 - 1e-9) return 1;
      return p[1] > 1 - 1e-9 ? 4 : 0;
    };
    body.length = 1;
    return make_hex_mesh(template_cells, body);
  }();
  SolidProblem problem;
  problem.material = {.youngs_modulus = 3, .poissons_ratio = 0.3};
  problem.order = order;
  for (int k = 0; k < 3; ++k)  // planes of symmetry: tag 1 is x = 0, 2 is y = 0, 3 is z = const
    problem.supports.push_back({.tag = k + 1, .directions = [k](const Point3&) {
                                  Point3 normal{};
                                  normal[static_cast<std::size_t>(k)] = 1;
                                  return std::vector<Point3>{normal};
                                }});
  const SolidLoad pressure{.tractions = {{.tag = 4,
                                          .value =
                                              [](const Point3& p) {
                                                const double r = std::hypot(p[0], p[1]);
                                                return Point3{p[0] / r, p[1] / r, 0};
                                              }}},
                           .stress_without_crack = {}};
  const double moved = 1.3 / 3 / 3 * (0.4 + 4);  // (1+nu)/E a^2/(b^2-a^2) ((1-2 nu) a + b^2/a)
  return 1 - solve_solid(mesh, problem, pressure).work / (moved * pi / 2 * height);
}

// (FE-20), Lame: the energy approaches from below, with order 2p in the size of the cells, and
// exponentially in p.  Measured: 3.75 and 3.92 for p = 2, 5.55 and 5.85 for p = 3, from 2 to 4 and
// from 4 to 8 cells; 5e-2, 1e-3, 2e-5, 2e-7 for p = 1 to 4 with 2 cells each way.
TEST(Solid, ConvergenceLameInHAndP) {
  test::start_mpi();
  EXPECT_NEAR(std::log2(lame_defect(2, 4) / lame_defect(2, 8)), 4, 0.15);
  EXPECT_NEAR(std::log2(lame_defect(3, 2) / lame_defect(3, 4)), 6, 0.5);
  double last = 1;
  for (const int order : {1, 2, 3, 4}) {
    const double defect = lame_defect(order, 2);
    EXPECT_GT(defect, 0) << order;
    EXPECT_LT(defect, 0.06 * last) << order;
    last = defect;
  }
  EXPECT_LT(last, 1e-6);
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

// (FE-20): one factorisation serves several loads, and each result is that of its load alone; the
// tolerance is rounding of a direct solver.
TEST(Solid, IdentityEachOfSeveralLoadsIsThatAlone) {
  test::start_mpi();
  const HexMesh mesh = grid({2, 1, 2}, same);
  SolidProblem problem;
  problem.material = kSolidSteel;
  problem.order = 2;
  problem.supports = {{.tag = kLow, .directions = [](const Point3&) {
                         return std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                       }}};
  const auto loaded = [](const Point3& traction) {
    return SolidLoad{
        .tractions = {{.tag = kHigh, .value = [=](const Point3&) { return traction; }}},
        .stress_without_crack = {}};
  };
  const std::vector<SolidLoad> loads = {loaded({0, 0, 1e6}), loaded({2e5, 1e5, 0}),
                                        loaded({0, 0, -2e6})};
  const std::vector<SolidResult> results = solve_solid(mesh, problem, loads);
  ASSERT_EQ(results.size(), loads.size());
  for (std::size_t n = 0; n < loads.size(); ++n) {
    const SolidResult alone = solve_solid(mesh, problem, loads[n]);
    test::expect_relative(results[n].work, alone.work, 1e-12);
    test::expect_relative(results[n].strain_energy, alone.strain_energy, 1e-12);
    EXPECT_LT(results[n].equilibrium_residual, 1e-11);
  }
  test::expect_relative(results[2].work, 4 * results[0].work, 1e-12);
  EXPECT_THROW((void)solve_solid(mesh, problem, std::span<const SolidLoad>()), InputError);
}

TEST(Solid, InputValuesOutOfRangeAreRefused) {
  test::start_mpi();
  const HexMesh mesh = grid({1, 1, 1}, same);
  const auto fails = [&](const SolidProblem& problem, const std::string& field) {
    try {
      (void)solve_solid(mesh, problem, SolidLoad{});
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
  EXPECT_THROW((void)twisted_tube(2, 4, 1, CrackFaces::contact), InputError);  // without a crack
}

}  // namespace
}  // namespace strainwave::fem

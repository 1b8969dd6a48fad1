// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/axisymmetric.hpp"
#include "strainwave/fem/solid.hpp"
#include "strainwave/fem/vtu.hpp"
#include "support/mpi.hpp"

namespace strainwave::fem {
namespace {

constexpr Elasticity kFieldSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};
constexpr double kFieldPi = std::numbers::pi;

/// A sheared box of 2 x 3 x 4 m, held along z below, pulled by 1 MPa above.
SolidResult pulled_box(int divisions) {
  test::start_mpi();
  TemplateCell cell;
  cell.map = [](const Point3& p) { return p; };
  TemplateBody body;
  body.map = [](const Point3& p) { return Point3{2 * p[0] + 0.3 * p[1], 3 * p[1], 4 * p[2]}; };
  body.face_tag = [](const Point3& p) { return p[2] < 1e-9 ? 1 : p[2] > 1 - 1e-9 ? 2 : 0; };
  body.length = 1;
  SolidProblem problem;
  problem.material = kFieldSteel;
  problem.order = 2;
  problem.supports = {{.tag = 1, .directions = [](const Point3& p) {
                         std::vector<Point3> held = {{0, 0, 1}};
                         if (std::abs(p[1]) < 1e-9) held.push_back({0, 1, 0});
                         if (std::abs(p[0]) < 1e-9) held.push_back({1, 0, 0});
                         return held;
                       }}};
  SolidLoad load;
  load.tractions = {{.tag = 2, .value = [](const Point3&) { return Point3{0, 0, 1e6}; }}};
  load.stress_without_crack = [](const Point3&) {  // half of it
    return std::array<Point3, 3>{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0.5e6}}};
  };
  problem.fields = {.divisions = divisions};
  return solve_solid(make_hex_mesh({cell}, body), problem, load);
}

// (FE-38): sigma^2/2E everywhere; points i/n of the cell, the first coordinate fastest.
TEST(SampledFields, ReferenceUniformTensionOfASolid) {
  const SampledFields fields = pulled_box(3).fields;
  EXPECT_EQ(fields.dimension, 3);
  EXPECT_TRUE(fields.without_crack);
  ASSERT_EQ(fields.cells.size(), 1U);
  const FieldCell& cell = fields.cells[0];
  ASSERT_EQ(cell.points.size(), 64U);
  EXPECT_EQ(cell.face_tag, (std::array{0, 0, 0, 0, 1, 2}));
  const double w = 1e12 / (2 * 210e9);
  for (std::size_t i = 0; i < 64; ++i) {
    const FieldPoint& p = cell.points[i];
    const double x = static_cast<double>(i % 4) / 3;
    const double y = static_cast<double>(i / 4 % 4) / 3;
    const double z = static_cast<double>(i / 16) / 3;
    EXPECT_NEAR(p.place[0], 2 * x + 0.3 * y, 1e-12);
    EXPECT_NEAR(p.place[1], 3 * y, 1e-12);
    EXPECT_NEAR(p.place[2], 4 * z, 1e-12);
    EXPECT_NEAR(p.displacement[2], 1e6 / 210e9 * 4 * z, 1e-15);
    EXPECT_NEAR(p.stress[2], 1e6, 1e-3);
    for (const std::size_t other : {0U, 1U, 3U, 4U, 5U}) EXPECT_NEAR(p.stress[other], 0, 1e-3);
    EXPECT_NEAR(p.energy_density, w, 1e-9 * w);
    EXPECT_NEAR(p.energy_density_without_crack, w / 4, 1e-12 * w);
  }
  EXPECT_TRUE(pulled_box(0).fields.cells.empty());
}

/// A solid shaft of radius 30 mm and length 50 mm.
SampledFields shaft_fields(SectionLoad load) {
  const SectionShape shape{
      .rectangles = {{0, 0.03, 0, 0.05, 0}},
      .fillets = {},
      .sides = {{true, 0, 0, 0.03, EdgeRole::held}, {true, 0.05, 0, 0.03, EdgeRole::loaded}},
      .crack = {}};
  return solve_section(mesh_section(shape, {.coarse_r = 0.02, .coarse_z = 0.03}), load, kFieldSteel,
                       {.order = 2, .fields = {.divisions = 2}})
      .fields;
}

// (FE-38) in the half plane y = 0: a shaft has tau = r/J and sigma = 1/A, on the axis too.
TEST(SampledFields, ReferenceShaftUnderTorqueAndForce) {
  const double J = kFieldPi / 2 * std::pow(0.03, 4);
  const double A = kFieldPi * 0.03 * 0.03;
  const double mu = 210e9 / 2.6;
  const SampledFields twisted = shaft_fields(SectionLoad::torsion);
  const SampledFields pulled = shaft_fields(SectionLoad::tension);
  EXPECT_EQ(twisted.dimension, 2);
  EXPECT_FALSE(twisted.without_crack);
  ASSERT_EQ(twisted.cells.size(), pulled.cells.size());
  for (const FieldCell& cell : twisted.cells)
    for (const FieldPoint& p : cell.points) {
      const double r = p.place[0];
      EXPECT_EQ(p.place[1], 0);
      EXPECT_NEAR(p.stress[3], r / J, 1e-8 * 0.03 / J);  // tau_z theta is yz
      EXPECT_NEAR(p.stress[5], 0, 1e-8 * 0.03 / J);
      EXPECT_NEAR(p.energy_density, r * r / (J * J) / (2 * mu), 1e-8 / (A * A * mu));
      EXPECT_NEAR(p.displacement[1], r * p.place[2] / (mu * J), 1e-10 * 0.03 / (mu * J));
    }
  for (const FieldCell& cell : pulled.cells) {
    EXPECT_EQ(cell.points.size(), 9U);
    for (const FieldPoint& p : cell.points) {
      EXPECT_NEAR(p.stress[2], 1 / A, 1e-7 / A);
      for (const std::size_t other : {0U, 1U, 3U, 4U, 5U})
        EXPECT_NEAR(p.stress[other], 0, 1e-7 / A);
      EXPECT_NEAR(p.energy_density * 2 * 210e9 * A * A, 1, 1e-7);
      EXPECT_NEAR(p.displacement[0], -0.3 * p.place[0] / (210e9 * A), 1e-9 * 0.03 / (210e9 * A));
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// tests/fe_study/folders.py tests how other programs read the files.
TEST(SampledFields, IdentityOfTheDocuments) {
  const SampledFields fields = pulled_box(3).fields;
  const std::string body = vtu_text(fields);
  EXPECT_EQ(count(body, "NumberOfPoints=\"64\" NumberOfCells=\"27\""), 1U);
  EXPECT_EQ(count(body, "strain_energy_density_added"), 1U);
  EXPECT_EQ(body, vtu_text(fields));
  const std::string section = vtu_text(shaft_fields(SectionLoad::torsion));
  EXPECT_EQ(count(section, "strain_energy_density_added"), 0U);
  const std::string record = pvtu_text({"a.vtu", "b.vtu"}, fields);
  EXPECT_EQ(count(record, "<Piece Source="), 2U);
  EXPECT_EQ(count(record, "<PDataArray"), count(body, "<DataArray") - 3);  // arrays of the cells
  const CrackFront front{.stations = {{.place = {1, 2, 3}, .K_I = 4}, {.place = {2, 2, 3}}}};
  const std::string line = fronts_vtu_text(std::array{front});
  EXPECT_EQ(count(line, "NumberOfPoints=\"2\" NumberOfCells=\"1\""), 1U);
  // Eight bytes, then 4.0f and 0.0f: base64 of 08000000 00008040 00000000.
  EXPECT_EQ(count(line, "CAAAAAAAgEAAAAAA"), 1U);
}

TEST(SampledFields, InputDivisionsOutOfRange) {
  EXPECT_THROW((void)pulled_box(9), InputError);
  EXPECT_THROW((void)pulled_box(-1), InputError);
  EXPECT_THROW((void)vtu_text({}), InputError);
  EXPECT_THROW((void)crack_faces_vtu_text({}), InputError);
  const SectionShape shape{
      .rectangles = {{0, 0.03, 0, 0.05, 0}},
      .fillets = {},
      .sides = {{true, 0, 0, 0.03, EdgeRole::held}, {true, 0.05, 0, 0.03, EdgeRole::loaded}},
      .crack = {}};
  const SectionMesh mesh = mesh_section(shape, {.coarse_r = 0.02, .coarse_z = 0.03});
  for (const int divisions : {-1, 9})
    EXPECT_THROW((void)solve_section(mesh, SectionLoad::torsion, kFieldSteel,
                                     {.order = 2, .fields = {.divisions = divisions}}),
                 InputError);
}

}  // namespace
}  // namespace strainwave::fem

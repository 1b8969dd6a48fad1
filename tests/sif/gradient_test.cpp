// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "sif/solution_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/sif/gradient/contact_edge.hpp"
#include "strainwave/sif/gradient/gradient_edge.hpp"
#include "strainwave/sif/gradient/gradient_surface.hpp"
#include "strainwave/sif/gradient/notch_edge.hpp"
#include "strainwave/sif/gradient/notch_surface.hpp"
#include "strainwave/sif/gradient/race_hoop_edge.hpp"
#include "strainwave/sif/gradient/race_hoop_surface.hpp"
#include "strainwave/sif/gradient/residual_edge.hpp"
#include "strainwave/sif/gradient/residual_surface.hpp"
#include "strainwave/sif/library.hpp"
#include "strainwave/sif/plate/plate_surface.hpp"
#include "strainwave/sif/tube/edge_axial.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

using test::Texts;

using std::numbers::pi;
using test::expect_relative;

const std::vector<std::string> kEdgeSolutions{"gradient-edge", "notch-edge", "residual-edge",
                                              "race-hoop-edge"};
const std::vector<std::string> kSurfaceSolutions{"gradient-surface", "notch-surface",
                                                 "residual-surface", "race-hoop-surface"};

std::vector<std::string> texts_outside(const std::string& name, const Assignments& values) {
  std::vector<std::string> texts;
  for (const ValidityLimit& limit : solution(name).make(values)->validity())
    if (!limit.inside) texts.emplace_back(limit.text);
  return texts;
}

std::string message(const std::string& name, const Assignments& values) {
  try {
    solution(name).make(values);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// --- polynomials (SW-1), (SW-5)
// -------------------------------------------------------------------------------

TEST(GradientEdgeCrack, ReferenceIntegralEquation) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("weight_function")) {
    if (row.quantity != "power" || row("exponent") > 3 || row("depth_ratio") == 0) continue;
    const double alpha = row("depth_ratio");
    const GradientEdgeCrack crack{.depth = 0.01 * alpha, .thickness = 0.01, .width = 1};
    const auto k = crack.stress_intensity(crack.depth, 0).I;
    const auto j = static_cast<std::size_t>(row("exponent"));
    test::expect_row(k[j] / (std::pow(alpha, row("exponent")) * std::sqrt(pi * crack.depth)), row,
                     2e-5);
    ++n;
  }
  EXPECT_EQ(n, 32);
}

TEST(GradientSurfaceCrack, IdentityPlateSurfaceCrack) {
  for (const double rho : {0.5, 1.6}) {
    const GradientSurfaceCrack crack{.depth = 2e-3, .half_length = 2e-3 / rho, .thickness = 5e-3};
    const PlateSurfaceCrack plate{
        .depth = 2e-3, .half_length = 2e-3 / rho, .thickness = 5e-3, .half_width = 1e3};
    EXPECT_EQ(crack.swept_area(1e-3, 0), plate.swept_area(1e-3, 0));
    for (const double phi : {0.0, 0.4, pi / 2}) {
      const auto k = crack.stress_intensity(1.5e-3, phi).I;
      const auto p = plate.stress_intensity(1.5e-3, phi).I;
      expect_relative(k[0], p[0], 1e-10);
      expect_relative(k[0] - 2 * k[1], p[1], 1e-10);
    }
  }
}

TEST(GradientSurfaceCrack, IdentityHigherPowersWorkNearTheTip) {
  // K decreases in the order of the stresses 1 > x/t > (x/t)^2 > (x/t)^3, most strongly at the
  // surface.
  const GradientSurfaceCrack crack{.depth = 2e-3, .half_length = 4e-3, .thickness = 1e-2};
  for (const double phi : {0.0, 0.5, pi / 2}) {
    const auto k = crack.stress_intensity(2e-3, phi).I;
    for (const std::size_t n : {1U, 2U, 3U}) EXPECT_LT(k[n], 0.2 * k[n - 1]);
    EXPECT_GT(k[3], 0);
  }
  // At mouth and tip, x^2 lies between x^3 and x.
  const auto deepest = crack.stress_intensity(2e-3, pi / 2).I;
  const auto surface = crack.stress_intensity(2e-3, 0).I;
  for (const std::size_t n : {1U, 2U, 3U})
    EXPECT_GT(deepest[n] / deepest[0], 2 * surface[n] / surface[0]);
}

// --- residual stress (SW-6)
// -----------------------------------------------------------------------------------

TEST(ResidualProfile, IdentityNoForceNoMoment) {
  for (const double hump : {0.0, 1.0, 2.0}) {
    const ResidualProfile r(0.3, hump, 8.0);
    EXPECT_DOUBLE_EQ(r(0), 1);
    EXPECT_NEAR(integrate([&](double x) { return r(x); }, 0, 8).value, 0, 1e-11);
    EXPECT_NEAR(integrate([&](double x) { return x * r(x); }, 0, 8).value, 0, 1e-10);
  }
}

TEST(ResidualProfile, LimitThickSection) {
  // In a thick section the balancing stress vanishes: r -> (1 + h x/delta) exp(-x/delta), largest
  // at delta (1 - 1/h); the next term is delta/t.
  const ResidualProfile r(1.0, 2.0, 1e6);
  for (const double x : {0.2, 0.5, 2.0}) EXPECT_NEAR(r(x), (1 + 2 * x) * std::exp(-x), 2e-5);
  EXPECT_GT(r(0.5), r(0.45));
  EXPECT_GT(r(0.5), r(0.55));
}

TEST(ResidualEdgeCrack, ReferenceIntegralEquation) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("gradient")) {
    if (row.quantity != "residual") continue;
    const ResidualEdgeCrack crack{
        .depth = row("a"), .thickness = 1, .width = 1, .decay = row("b"), .hump = row("c")};
    test::expect_row(crack.stress_intensity(row("a"), 0).I[2] / std::sqrt(pi * row("a")), row,
                     6e-5);
    ++n;
  }
  EXPECT_EQ(n, 4);
}

TEST(ResidualEdgeCrack, LimitShallowTreatment) {
  // For delta << a, the treatment acts through the balancing stress of the section, which is linear
  // over the depth; the layer itself adds 2 sqrt(2/(pi a)) M(1) delta (1 + h).  The next terms are
  // smaller by (delta/a)^2.
  for (const double decay : {1e-5, 3e-6, 1.0001e-6}) {
    const double a = 1e-3;
    const double t = 1e-2;
    const ResidualEdgeCrack crack{
        .depth = a, .thickness = t, .width = 1, .decay = decay, .hump = 1.5};
    const EdgeWeight weight(a / t);
    const ResidualProfile r(decay, 1.5, t);
    const double far = r(a);  // g = 0
    const double further = r(a / 2);
    const double slope = (far - further) / (a / 2);
    const double line =
        weighted_intensity(weight, a, [&](double x) { return far + slope * (x - a); }).value;
    const double layer =
        (1 - far + slope * a) * std::sqrt(2 / (pi * a)) * weight.value(1) * decay * (1 + 1.5);
    const double K = crack.stress_intensity(a, 0).I[2];
    EXPECT_NEAR(K, line + layer, 0.2 * decay / a * layer);
    EXPECT_GT(K, 0);
  }
}

TEST(ResidualSurfaceCrack, LimitShallowTreatment) {
  // K of the layer is proportional to delta at every point of the front, so the ratio is 2; the
  // next term is delta/a.
  const auto K = [](double decay, double phi) {
    const ResidualSurfaceCrack crack{
        .depth = 1e-3, .half_length = 2e-3, .thickness = 1e-2, .decay = decay, .hump = 0};
    return crack.stress_intensity(1e-3, phi).I[2];
  };
  expect_relative(K(4e-6, pi / 2), 2 * K(2e-6, pi / 2), 0.02);
  EXPECT_GT(K(2e-6, pi / 2), 0);
}

TEST(GradientFamily, InputIntegralThatDoesNotConvergeIsRefused) {
  // A stress that oscillates faster than the pieces can resolve.
  const auto stress = [](double x) { return std::sin(1e7 * x * x); };
  const auto integral = weighted_intensity(EdgeWeight(0), 1.0, stress);
  EXPECT_FALSE(integral.converged);
  EXPECT_THROW((void)converged_value(integral), SolverError);
}

TEST(ResidualEdgeCrack, IdentityAppliedLoads) {
  const ResidualEdgeCrack crack{
      .depth = 2e-3, .thickness = 8e-3, .width = 1, .decay = 2e-4, .hump = 1};
  const GradientEdgeCrack gradient{.depth = 2e-3, .thickness = 8e-3, .width = 1};
  const auto k = crack.stress_intensity(1e-3, 0).I;
  const auto g = gradient.stress_intensity(1e-3, 0).I;
  expect_relative(k[0], g[0], 1e-14);
  expect_relative(k[1], g[0] - 2 * g[1], 1e-13);
}

TEST(ResidualSurfaceCrack, IdentityAppliedLoads) {
  const ResidualSurfaceCrack crack{
      .depth = 2e-3, .half_length = 3e-3, .thickness = 8e-3, .decay = 4e-4, .hump = 1};
  const GradientSurfaceCrack gradient{.depth = 2e-3, .half_length = 3e-3, .thickness = 8e-3};
  const auto k = crack.stress_intensity(1e-3, 0.7).I;
  const auto g = gradient.stress_intensity(1e-3, 0.7).I;
  expect_relative(k[0], g[0], 1e-13);
  expect_relative(k[1], g[0] - 2 * g[1], 1e-11);
}

TEST(ResidualSurfaceCrack, LimitShallowAndSlender) {
  // For a crack much shallower than the treatment, the uniform surface stress counts; the next term
  // is a/delta.
  ResidualSurfaceCrack crack{
      .depth = 1e-6, .half_length = 2e-6, .thickness = 1e-2, .decay = 1e-3, .hump = 0};
  const auto k = crack.stress_intensity(1e-6, 0.5).I;
  expect_relative(k[2], k[0], 2e-3);
  // A slender crack in a thick section is the edge crack; the tolerance is 2 % as for powers.
  crack = {.depth = 1e-3, .half_length = 0.1, .thickness = 1.0, .decay = 1e-3, .hump = 1.5};
  const ResidualEdgeCrack edge{
      .depth = 1e-3, .thickness = 1.0, .width = 1, .decay = 1e-3, .hump = 1.5};
  expect_relative(crack.stress_intensity(1e-3, pi / 2).I[2], edge.stress_intensity(1e-3, 0).I[2],
                  0.02);
}

TEST(ResidualEdgeCrack, IdentityPeeningClosesAShallowCrack) {
  // -500 MPa at the surface against 300 MPa of tension: the crack is closed at 0.05 mm and open at
  // 2 mm.
  const ResidualEdgeCrack crack{
      .depth = 2e-3, .thickness = 1e-2, .width = 1, .decay = 2e-4, .hump = 1.5};
  const auto K = [&](double a) {
    const auto k = crack.stress_intensity(a, 0).I;
    return 300e6 * k[0] - 500e6 * k[2];
  };
  EXPECT_LT(K(5e-5), 0);
  EXPECT_GT(K(2e-3), 0);
}

// --- line contact (SW-7), (SW-8)
// ------------------------------------------------------------------------------

TEST(HertzLineStress, ReferenceFlamant) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("gradient")) {
    const bool pressure = row.quantity.starts_with("pressure_");
    if (!pressure && !row.quantity.starts_with("traction_")) continue;
    const double b = 0.3e-3;
    const auto stress = pressure ? hertz_pressure_stress(row("a") * b, row("b") * b, b)
                                 : hertz_traction_stress(row("a") * b, row("b") * b, b);
    const double actual = row.quantity.ends_with("along")    ? stress.along
                          : row.quantity.ends_with("normal") ? stress.normal
                                                             : stress.shear;
    test::expect_row(actual, row, 1e-9);
    ++n;
  }
  EXPECT_GE(n, 30);
}

TEST(HertzLineStress, IdentitySurface) {
  // Below the contact sigma_x = sigma_z = -p; beside it only sigma_x from the traction remains.
  for (const double x : {-0.9, 0.0, 0.4}) {
    const double p = std::sqrt(1 - x * x);
    const auto stress = hertz_pressure_stress(x, 0, 1);
    EXPECT_NEAR(stress.along, -p, 1e-15);
    EXPECT_NEAR(stress.normal, -p, 1e-15);
    EXPECT_NEAR(stress.shear, 0, 1e-15);
    EXPECT_NEAR(hertz_traction_stress(x, 0, 1).along, -2 * x, 1e-15);
    EXPECT_NEAR(hertz_traction_stress(x, 0, 1).shear, -p, 1e-15);
  }
  EXPECT_NEAR(hertz_pressure_stress(1.5, 0, 1).along, 0, 1e-15);
  EXPECT_NEAR(hertz_traction_stress(1.5, 0, 1).along, 2 * (std::sqrt(1.25) - 1.5), 1e-15);
  EXPECT_NEAR(hertz_traction_stress(-1.5, 0, 1).along, 2 * (1.5 - std::sqrt(1.25)), 1e-15);
  // Points at the edges of the contact.
  for (const double x : {-1.0, 1.0}) {
    EXPECT_EQ(hertz_pressure_stress(x, 0, 1).along, 0);
    EXPECT_EQ(hertz_traction_stress(x, 0, 1).along, -2 * x);
  }
}

TEST(HertzLineStress, LimitFarAway) {
  // A line force P = pi b p_0/2, by Flamant: sigma_x = -(2 P/pi) x^2 z/r^4, sigma_z by z^3,
  // tau by x z^2; of a tangential force x^3, x z^2, x^2 z.  The next term is (b/r)^2, 1e-7.
  for (const double x : {-3000.0, 2000.0, 5000.0})
    for (const double z : {500.0, 4000.0}) {
      const double r4 = std::pow(x * x + z * z, 2);
      const auto p = hertz_pressure_stress(x, z, 1);
      EXPECT_NEAR(p.along * r4, -x * x * z, 3e-6 * std::abs(x * x * z) + 1e-6 * z * z * z);
      EXPECT_NEAR(p.normal * r4, -z * z * z, 3e-5 * z * z * z);
      EXPECT_NEAR(p.shear * r4, -x * z * z, 3e-5 * std::abs(x * z * z));
      const auto q = hertz_traction_stress(x, z, 1);
      EXPECT_NEAR(q.along * r4, -x * x * x, 3e-5 * std::abs(x * x * x));
    }
}

TEST(HertzLineStress, ReferenceLargestShear) {
  // tau_max = 0.300 p_0 at z = 0.786 b, and orthogonal shear 0.25 p_0 at z = 0.5 b (johnson1985,
  // secondary; printed digits).
  const auto axis = hertz_pressure_stress(0, 0.786, 1);
  EXPECT_NEAR((axis.along - axis.normal) / 2, 0.300, 0.0005);
  double largest = 0;
  for (double x = 0.8; x < 0.95; x += 0.001)
    largest = std::max(largest, std::abs(hertz_pressure_stress(x, 0.5, 1).shear));
  EXPECT_NEAR(largest, 0.25, 0.0005);
}

TEST(ContactEdgeCrack, ReferenceIntegralEquation) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("gradient")) {
    if (!row.quantity.starts_with("contact_")) continue;
    const double b = 0.4e-3;
    const ContactEdgeCrack crack{
        .depth = row("b") * b, .contact_half_width = b, .position = row("a") * b, .width = 1};
    const auto k = crack.stress_intensity(crack.depth, 0);
    const std::size_t load = row.quantity.find("pressure") == std::string::npos ? 1 : 0;
    const double K = row.quantity.ends_with("_II") ? k.II[load] : k.I[load];
    test::expect_row(K / std::sqrt(pi * crack.depth), row, 1e-4);
    ++n;
  }
  EXPECT_EQ(n, 12);
}

TEST(ContactEdgeCrack, IdentityMirror) {
  ContactEdgeCrack crack{.depth = 5e-4, .contact_half_width = 3e-4, .position = 4e-4, .width = 1};
  const auto right = crack.stress_intensity(5e-4, 0);
  crack.position = -4e-4;
  const auto left = crack.stress_intensity(5e-4, 0);
  expect_relative(left.I[0], right.I[0], 1e-13);
  expect_relative(left.II[0], -right.II[0], 1e-13);
  expect_relative(left.I[1], -right.I[1], 1e-13);
  expect_relative(left.II[1], right.II[1], 1e-13);
  // Behind a contact that drags the surface toward +x, the surface is in tension.
  EXPECT_GT(left.I[1], 0);
  EXPECT_LT(left.I[0], 0);
}

// --- race (SW-9)
// ----------------------------------------------------------------------------------------------

TEST(RaceHoop, IdentityAngle) {
  const GradientEdgeCrack strip{.depth = 1e-3, .thickness = 4e-3, .width = 1};
  const auto g = strip.stress_intensity(1e-3, 0).I;
  const GradientSurfaceCrack plate{.depth = 1e-3, .half_length = 2e-3, .thickness = 4e-3};
  const auto p = plate.stress_intensity(1e-3, 0.3).I;
  for (const double lobes : {2.0, 3.0})
    for (const double angle : {0.0, 0.2, pi / (2 * lobes), pi / lobes}) {
      const double c = std::cos(lobes * angle);
      const RaceHoopEdgeCrack edge{
          .depth = 1e-3, .thickness = 4e-3, .width = 1, .angle = angle, .lobes = lobes};
      const auto k = edge.stress_intensity(1e-3, 0).I;
      expect_relative(k[0], g[0], 1e-14);
      EXPECT_NEAR(k[1], c * (g[0] - 2 * g[1]), 1e-13 * g[0]);
      const RaceHoopSurfaceCrack surface{
          .depth = 1e-3, .half_length = 2e-3, .thickness = 4e-3, .angle = angle, .lobes = lobes};
      const auto s = surface.stress_intensity(1e-3, 0.3).I;
      expect_relative(s[0], p[0], 1e-13);
      EXPECT_NEAR(s[1], c * (p[0] - 2 * p[1]), 1e-11 * p[0]);
    }
}

TEST(RaceHoop, IdentityBetweenTheLobesTheSignTurns) {
  const auto K = [](double angle) {
    return RaceHoopEdgeCrack{
        .depth = 1e-3, .thickness = 4e-3, .width = 1, .angle = angle, .lobes = 2}
        .stress_intensity(1e-3, 0)
        .I[1];
  };
  EXPECT_GT(K(0), 0);
  expect_relative(K(pi / 2), -K(0), 1e-14);
  expect_relative(K(pi), K(0), 1e-14);
}

TEST(RaceHoop, CrosscheckClosedRing) {
  // SU-11, within 0.7 % of finite elements, includes the resistance of the ring.  The strip is an
  // upper bound, by no more than the stated accuracy at the end of the range; 0.7 % is the
  // difference of (FR-11) from the exact strip and elements.
  const auto excess = [](const auto& ring) {
    const RaceHoopEdgeCrack strip{.depth = ring.depth,
                                  .thickness = ring.thickness,
                                  .width = ring.length,
                                  .angle = 0,
                                  .lobes = 2};
    const auto s = strip.stress_intensity(strip.depth, 0).I;
    const auto r = ring.stress_intensity(ring.depth, 0).I;
    return std::array{s[0] / r[1] - 1, s[1] / r[2] - 1};  // hoop stress, wall bending
  };
  struct Case {
    double radius_ratio, depth_ratio, membrane, ovality;
  };
  for (const Case& c :
       {Case{10, 0.2, 0.018, 0.020}, Case{5, 0.2, 0.037, 0.041}, Case{5, 0.5, 0.292, 0.362}}) {
    const TubeEdgeAxialInner inner{
        .depth = c.depth_ratio, .mean_radius = c.radius_ratio, .thickness = 1, .length = 10};
    const TubeEdgeAxialOuter outer{
        .depth = c.depth_ratio, .mean_radius = c.radius_ratio, .thickness = 1, .length = 10};
    const auto in = excess(inner);
    const auto out = excess(outer);
    EXPECT_NEAR(in[0], c.membrane, 0.007 + 0.02 * c.membrane);
    EXPECT_NEAR(in[1], c.ovality, 0.007 + 0.02 * c.ovality);
    for (const std::size_t load : {0U, 1U}) {
      EXPECT_GT(out[load], 0.8 * in[load]);
      EXPECT_LT(out[load], in[load]);
    }
  }
  const auto& info = solution("race-hoop-edge").info;
  EXPECT_GE(info.relative_uncertainty, 0.04);
  EXPECT_NE(info.accuracy.find("upper bound"), std::string_view::npos);
}

// --- notch (SW-10), (SW-11)
// -----------------------------------------------------------------------------------

TEST(NotchProfile, IdentityEllipse) {
  for (const double kt : {1.5, 3.0, 7.0, 15.0}) {
    const double rho = 0.7e-3;
    const NotchProfile notch(rho, kt);
    expect_relative(notch.depth(), rho * std::pow((kt - 1) / 2, 2), 1e-14);
    expect_relative(notch(0), kt, 1e-13);
    const double h = 1e-5 * rho;
    expect_relative((notch(h) - notch(0)) / h, -(2 * kt + 1) / rho, 1e-4);
    EXPECT_NEAR(notch(1e6 * notch.depth()), 1, 1e-11);
    // The material beside the hole carries the missing force: int (s - 1) dx = D.
    const double force =
        integrate([&](double u) { return (notch(rho * u / (1 - u)) - 1) / ((1 - u) * (1 - u)); },
                  0.0, 1 - 1e-9)
            .value;
    expect_relative(force * rho, notch.depth(), 1e-6);
  }
}

TEST(NotchProfile, LimitSharpNotch) {
  // K_t >> 1: K_t/sqrt(1 + 2 x/rho) (1 + 1/(1 + 2 x/rho))/2, Creager and Paris' field of a slender
  // notch; next term 1/K_t.  The difference of squares must not become NaN when x is negligible
  // compared with D.
  for (const double kt : {1e3, 1e9}) {
    const NotchProfile notch(1e-3, kt);
    for (const double x : {0.0, 1e-4, 1e-3, 3e-3}) {
      const double y = 1 + 2 * x / 1e-3;
      expect_relative(notch(x), kt / std::sqrt(y) * (1 + 1 / y) / 2, kt > 1e6 ? 1e-6 : 4e-3);
    }
  }
  for (const std::string name : {"notch-edge", "notch-surface"}) {
    EXPECT_NE(message(name, {{"concentration", 1001}}), "");
    EXPECT_TRUE(std::isfinite(
        solution(name).make({{"concentration", 999}})->unit_intensity(0, 1e-3, 0).K_I));
  }
}

TEST(NotchProfile, IdentityKirsch) {
  const NotchProfile notch(1.0, 3.0000001);
  for (const double r : {1.0, 1.2, 2.0, 5.0})
    expect_relative(notch(r - 1), 1 + 0.5 / (r * r) + 1.5 / std::pow(r, 4), 1e-6);
}

TEST(NotchEdgeCrack, ReferenceCracksAtEllipticalHoles) {
  // Two cracks at a hole; a crack at an edge notch has the factor 1 for a << D and 1.1215 for a >>
  // D.  In between, the factor is a model; the tolerance is that of the fit.
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("gradient")) {
    if (row.quantity != "hole") continue;
    const double a = row("a");
    const double D = row("b");
    const NotchProfile notch(1.0, 1 + 2 * std::sqrt(D) + 1e-9);
    const double K = weighted_intensity(EdgeWeight(0), a, notch).value * notch.flank_factor(a);
    expect_relative(K / std::sqrt(pi * a), row.value * (1 + 0.1215 * a / (a + D)), 0.0055);
    ++n;
  }
  EXPECT_GE(n, 25);
}

TEST(NotchEdgeCrack, LimitShallowAndDeep) {
  NotchEdgeCrack crack{
      .depth = 1e-4, .thickness = 1e4, .width = 1, .root_radius = 1, .concentration = 5};
  const auto shallow = crack.stress_intensity(1e-4, 0).I;
  expect_relative(shallow[0], 5 * 1.1215 * std::sqrt(pi * 1e-4), 1e-3);
  expect_relative(shallow[1], shallow[0], 1e-6);
  // For D = 4 and a >> rho, the effective depth is that of notch and crack together.
  for (const double a : {40.0, 200.0})
    expect_relative(crack.stress_intensity(a, 0).I[0], 1.1215 * std::sqrt(pi * (a + 4)), 0.015);
}

TEST(NotchEdgeCrack, IdentityBendingOfTheSection) {
  // The gradient of the bending, to first order in a/t, is the same as for the flat strip.
  const NotchEdgeCrack notched{
      .depth = 2e-3, .thickness = 8e-3, .width = 1, .root_radius = 2e-3, .concentration = 1.5};
  const auto k = notched.stress_intensity(2e-3, 0).I;
  const NotchProfile notch(2e-3, 1.5);
  const double expected =
      notch.flank_factor(2e-3) * weighted_intensity(EdgeWeight(0.25), 2e-3, [&](double x) {
                                   return notch(x) * (1 - x / 4e-3);
                                 }).value;
  expect_relative(k[1], expected, 1e-12);
  EXPECT_LT(k[1], k[0]);
}

TEST(NotchSurfaceCrack, LimitOfItsNeighbours) {
  // A shallow crack is the surface crack under K_t; the next term is a (2 K_t + 1)/(K_t rho).
  const NotchSurfaceCrack crack{.depth = 1e-6,
                                .half_length = 2e-6,
                                .thickness = 8e-3,
                                .root_radius = 1e-3,
                                .concentration = 4};
  const GradientSurfaceCrack flat{.depth = 1e-6, .half_length = 2e-6, .thickness = 8e-3};
  for (const double phi : {0.0, 0.8, pi / 2})
    for (const std::size_t load : {0U, 1U})
      expect_relative(crack.stress_intensity(1e-6, phi).I[load],
                      4 * flat.stress_intensity(1e-6, phi).I[0], 3e-3);
  // A slender crack at the end of the range is the edge crack without its flank factor.
  const NotchSurfaceCrack slender{.depth = 3e-4,
                                  .half_length = 3e-2,
                                  .thickness = 1.0,
                                  .root_radius = 1e-3,
                                  .concentration = 4};
  const NotchEdgeCrack edge{
      .depth = 3e-4, .thickness = 1.0, .width = 1, .root_radius = 1e-3, .concentration = 4};
  const double ratio =
      edge.stress_intensity(3e-4, 0).I[0] / slender.stress_intensity(3e-4, pi / 2).I[0];
  EXPECT_NEAR(ratio, NotchProfile(1e-3, 4).flank_factor(3e-4), 0.01);
  EXPECT_GT(ratio, 0.87);
}

// --- all
// ------------------------------------------------------------------------------------------------------

TEST(GradientFamily, IdentityEnergyOfTension) {
  // FR-2 of the first load: (2/E') B int K^2 da, here by the trapezoidal rule; 0.1 %.
  for (const std::string& name : kEdgeSolutions) {
    const auto crack = solution(name).make({});
    const double a = crack->size();
    double sum = 0;
    constexpr int kSteps = 200;
    for (int i = 1; i <= kSteps; ++i) {
      const double K = crack->unit_intensity(0, a * i / kSteps, 0).K_I;
      sum += K * K * (i == kSteps ? 0.5 : 1.0) * a / kSteps;
    }
    const auto compliance = crack->compliance({.opening = 2e11, .shear = 8e10});
    EXPECT_TRUE(compliance.converged) << name;
    expect_relative(compliance.upper[0], 2 / 2e11 * 0.02 * sum, 1e-3);
  }
  for (const std::string& name : kSurfaceSolutions)
    EXPECT_TRUE(solution(name).make({})->compliance({.opening = 2e11, .shear = 8e10}).converged)
        << name;
  EXPECT_TRUE(
      solution("contact-edge").make({})->compliance({.opening = 2e11, .shear = 8e10}).converged);
}

template <class Crack>
void expect_half_ellipse(const Crack& crack) {
  // int swept_area ds da over the front is the area pi a c/2.
  const double a = crack.size();
  EXPECT_EQ(crack.front().begin, 0);
  EXPECT_EQ(crack.front().end, pi / 2);
  expect_relative(crack.swept_area(0.3 * a, 0.4), 0.6 * crack.half_length, 1e-14);  // 2 c a'/a
  for (const std::size_t load : {0U, 1U}) EXPECT_EQ(crack.gross_stress(load), 1);
}

TEST(GradientFamily, IdentitySweptArea) {
  expect_half_ellipse(GradientSurfaceCrack{.depth = 2, .half_length = 3, .thickness = 9});
  expect_half_ellipse(NotchSurfaceCrack{
      .depth = 2, .half_length = 3, .thickness = 9, .root_radius = 8, .concentration = 2});
  expect_half_ellipse(
      ResidualSurfaceCrack{.depth = 2, .half_length = 3, .thickness = 9, .decay = 0.5, .hump = 1});
  expect_half_ellipse(
      RaceHoopSurfaceCrack{.depth = 2, .half_length = 3, .thickness = 9, .angle = 0, .lobes = 2});
  for (const std::string& name : kEdgeSolutions)
    EXPECT_EQ(solution(name).make({})->gross_stress(0, 1 * mm), 1);
  const ContactEdgeCrack contact{.depth = 2, .contact_half_width = 3, .position = 4, .width = 5};
  EXPECT_EQ(contact.swept_area(1, 0), 5);
  EXPECT_EQ(contact.gross_stress(1), 1);
}

TEST(GradientFamily, InputRules) {
  for (const auto* names : {&kEdgeSolutions, &kSurfaceSolutions})
    for (const std::string& name : *names)
      EXPECT_NE(message(name, {{"depth", 0.01}}).find("depth <= 0.99 thickness"),
                std::string::npos);
  for (const std::string& name : kSurfaceSolutions)
    for (const double half_length : {0.101, 0.99e-5})
      EXPECT_NE(message(name, {{"half_length", half_length}}).find("0.01 <= depth/half_length"),
                std::string::npos)
          << name;
  EXPECT_NE(message("contact-edge", {{"depth", 0.301}}).find("1000 contact_half_width"),
            std::string::npos);
  for (const double x : {-0.301, 0.301})
    EXPECT_NE(message("contact-edge", {{"position", x}}).find("|position| <= 1000"),
              std::string::npos);
  EXPECT_NE(message("residual-edge", {{"decay", 0.99e-6}}).find("depth <= 1000 decay"),
            std::string::npos);
  EXPECT_NE(message("residual-surface", {{"decay", 4.99e-5}}).find("depth <= 20 decay"),
            std::string::npos);
  for (const std::string name : {"race-hoop-edge", "race-hoop-surface"}) {
    EXPECT_NE(message(name, {{"lobes", 2.5}}).find("whole number"), std::string::npos);
    EXPECT_NE(message(name, {{"lobes", 1}}), "");
    EXPECT_EQ(message(name, {{"lobes", 3}}), "");
  }
  for (const std::string name : {"residual-edge", "residual-surface"}) {
    // thickness/5 = 2 mm.
    EXPECT_EQ(message(name, {{"decay", 0.9e-3}, {"hump", 1}}), "");
    EXPECT_NE(message(name, {{"decay", 1.1e-3}, {"hump", 1}}).find("thickness/5"),
              std::string::npos);
  }
}

// Every corner of the allowed region terminates with a finite compliance.
TEST(GradientFamily, LimitCornersOfTheRules) {
  struct Case {
    const char* name;
    Assignments values;
  };
  for (const auto& [name, values] :
       std::vector<Case>{{"gradient-surface", {{"half_length", 1.01e-5}}},
                         {"gradient-surface", {{"depth", 9.8e-3}, {"half_length", 0.97}}},
                         {"gradient-edge", {{"depth", 9.8e-3}}},
                         {"notch-edge", {{"concentration", 999}}},
                         {"notch-edge", {{"root_radius", 1e-9}}},
                         {"residual-edge", {{"decay", 1.01e-6}}},
                         {"residual-surface", {{"decay", 5.01e-5}}},
                         {"contact-edge", {{"position", 0.29}}},
                         {"contact-edge", {{"contact_half_width", 1.01e-6}}},
                         {"plate-surface", {{"depth", 9.8e-3}, {"thickness", 1e-2}}},
                         {"tube-edge-axial-inner", {{"depth", 0.98e-3}}}}) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = solution(name).make(values)->compliance({.opening = 2e11, .shear = 8e10});
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    for (const double c : result.upper) EXPECT_TRUE(std::isfinite(c)) << name;

    EXPECT_LT(time.count(), 30) << name;  // [s]; longer means a hang on any machine
  }
}

TEST(GradientFamily, InputValidity) {
  for (const auto* names : {&kEdgeSolutions, &kSurfaceSolutions})
    for (const std::string& name : *names) EXPECT_EQ(texts_outside(name, {}), Texts{}) << name;
  EXPECT_EQ(texts_outside("contact-edge", {}), Texts{});

  EXPECT_EQ(texts_outside("gradient-edge", {{"depth", 9.1e-3}}), Texts{"a/t <= 0.9"});
  EXPECT_EQ(texts_outside("race-hoop-edge", {{"depth", 2.1e-3}}), Texts{"a/t <= 0.2"});
  EXPECT_EQ(texts_outside("race-hoop-surface", {{"depth", 2.1e-3}}), Texts{"a/t <= 0.2"});
  EXPECT_EQ(texts_outside("residual-edge", {{"depth", 9.1e-3}, {"decay", 1e-3}, {"hump", 0}}),
            Texts{"a/t <= 0.9"});
  EXPECT_EQ(texts_outside("residual-edge", {{"depth", 3.1e-3}}), Texts{"a <= 10 delta"});
  EXPECT_EQ(texts_outside("notch-edge", {{"depth", 9.1e-3}}), Texts{"a/t <= 0.9"});
  EXPECT_EQ(texts_outside("notch-edge", {{"root_radius", 6e-3}}), Texts{"rho <= t/2"});

  for (const std::string name : {"gradient-surface", "race-hoop-surface"}) {
    if (name == "gradient-surface") {
      EXPECT_EQ(texts_outside(name, {{"depth", 8.1e-3}, {"half_length", 8e-3}}),
                Texts{"a/t <= 0.8"});
    }
    EXPECT_EQ(texts_outside(name, {{"half_length", 6e-3}}), Texts{"0.2 <= a/c <= 2"});
    EXPECT_EQ(texts_outside(name, {{"half_length", 0.4e-3}}), Texts{"0.2 <= a/c <= 2"});
  }
  EXPECT_EQ(texts_outside("residual-surface", {{"depth", 1.3e-3}}), Texts{"a <= 4 delta"});
  EXPECT_EQ(texts_outside("notch-surface", {{"depth", 1.3e-3}}), Texts{"a <= 0.3 rho"});
  for (const std::string name : {"notch-edge", "notch-surface"})
    for (const double kt : {1.4, 21.0})
      EXPECT_EQ(texts_outside(name, {{"concentration", kt}}), Texts{"1.5 <= K_t <= 20"});
  EXPECT_EQ(texts_outside("contact-edge", {{"depth", 3.1e-3}}), Texts{"a <= 10 b"});
  EXPECT_EQ(texts_outside("contact-edge", {{"position", -3.1e-3}}), Texts{"|x| <= 10 b"});
}

}  // namespace
}  // namespace strainwave::sif

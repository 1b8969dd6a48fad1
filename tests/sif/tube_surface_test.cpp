// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sif/solution_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/sif/tube/edge_axial.hpp"
#include "strainwave/sif/tube/ovalised.hpp"
#include "strainwave/sif/tube/surface_axial.hpp"
#include "strainwave/sif/tube/surface_circumferential.hpp"
#include "strainwave/sif/tube/surface_inclined.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

using test::limits_broken;
using test::rules_broken;
using test::Texts;

using std::numbers::pi;

/// A wall of 1 mm thickness.
template <class S>
S crack_of(double depth, double half_length, double mean_radius) {
  return {
      .depth = depth, .half_length = half_length, .mean_radius = mean_radius, .thickness = 0.001};
}

// --- (SU-6), (SU-7): stress of the wall
// ---------------------------------------------------------------------

TEST(WallStress, IdentityLine) {
  const WallStress line = WallStress::line(10.0, 7.0, 0.4, 2.0);
  test::expect_relative(line.tension + line.bending, 10.0, 1e-15);
  test::expect_relative(line.tension + line.bending * (1 - 2 * 0.4 / 2.0), 7.0, 1e-15);
}

TEST(WallStress, IdentityLameCarriesThePressure) {
  // By equilibrium of half of the tube, the integral of the hoop stress is p r_i.
  const TubeWall wall{.mean_radius = 0.02, .thickness = 0.006};
  const double sum =
      integrate([&](double r) { return lame_hoop_stress(wall, r); }, wall.inner(), wall.outer())
          .value;
  test::expect_relative(sum, wall.inner(), 1e-13);
  // sigma_theta + sigma_r is the same everywhere (sum 2A): sigma_r is -1 inside and 0 outside.
  test::expect_relative(lame_hoop_stress(wall, wall.inner()) - 1,
                        lame_hoop_stress(wall, wall.outer()), 1e-13);
  EXPECT_DOUBLE_EQ(wall.radius(Face::inner, 0.001), 0.018);
  EXPECT_DOUBLE_EQ(wall.radius(Face::outer, 0.001), 0.022);
}

// --- Axial
// ----------------------------------------------------------------------------------------------------

TEST(TubeSurfaceAxial, CrosscheckCylinderFactor) {
  // Newman and Raju's own factor of an inner crack, newmanraju1980 (secondary),
  //     0.97 ((r_o^2 + r_i^2)/(r_o^2 - r_i^2) + 1 - sqrt(alpha)/2) t/r_i  times p r_i/t,
  // for t/r_i 0.1 to 0.25.  Here the plate's fit under Lame's stress is above it, by 0 to 4.5 % at
  // the deepest point and 4.5 to 9.1 % at the surface.
  double least = 1e9;
  double most = 0.0;
  for (const double ratio : {0.1, 0.25})
    for (const double rho : {0.2, 0.4, 1.0})
      for (const double alpha : {0.2, 0.5, 0.8})
        for (const double phi : {0.0, pi / 2}) {
          const double inner = 1 / ratio;
          const double i2 = inner * inner;
          const double o2 = (inner + 1) * (inner + 1);
          const double published = 0.97 * sif::NewmanRaju(rho).factor(alpha, phi) *
                                   ((o2 + i2) / (o2 - i2) + 1 - 0.5 * std::sqrt(alpha)) *
                                   std::sqrt(pi * alpha * 1e-3);
          const double K = crack_of<TubeSurfaceAxialInner>(alpha * 1e-3, alpha * 1e-3 / rho,
                                                           (inner + 0.5) * 1e-3)
                               .stress_intensity(alpha * 1e-3, phi)
                               .I[0];
          least = std::min(least, K / published);
          most = std::max(most, K / published);
          EXPECT_LT(K / published, phi > 0 ? 1.045 : 1.091);
        }
  EXPECT_NEAR(least, 1.0044, 5e-4);  // measured difference of the two models
  EXPECT_NEAR(most, 1.0902, 5e-4);
}

TEST(TubeSurfaceAxial, CrosscheckWeightFunction) {
  // Deepest point, the whole of Lame's stress integrated with Shen and Glinka's weight function,
  // calibrated on the plate's tension and bending, against the line through two of its points.
  const double rho = 0.4;
  const NewmanRajuPlate fit(rho);
  for (const double alpha : {0.2, 0.5, 0.8})
    for (const double radius : {4.5, 10.0, 40.0}) {
      const double tension = fit.tension(alpha, pi / 2);
      const double bending = tension * fit.bending_ratio(alpha, pi / 2);
      // sigma = y = 1 - x/a is bending/(2 alpha) + tension (1 - 1/(2 alpha))
      const double linear = bending / (2 * alpha) + tension * (1 - 1 / (2 * alpha));
      // K/sqrt(pi a) = (sqrt(2)/pi) int sigma y^-1/2 (1 + M1 y^1/2 + M2 y + M3 y^3/2) dy, M2 = 3
      const double u = tension * pi / std::sqrt(2.0) - 2 - 2;
      const double v = linear * pi / std::sqrt(2.0) - 2.0 / 3 - 6.0 / 5;
      const double M3 = (v - u / 2) / (1.0 / 3 - 1.0 / 4);
      const double M1 = u - M3 / 2;
      const TubeWall wall{.mean_radius = radius, .thickness = 1.0};
      for (const Face face : {Face::inner, Face::outer}) {
        const double faces = face == Face::inner ? 1.0 : 0.0;
        const double weighed =
            std::sqrt(2.0) / pi *
            integrate(
                [&](double q) {  // y = q^2
                  const double stress =
                      faces + lame_hoop_stress(wall, wall.radius(face, alpha * (1 - q * q)));
                  return 2 * stress * (1 + M1 * q + 3 * q * q + M3 * q * q * q);
                },
                0.0, 1.0)
                .value;
        const double K = face == Face::inner
                             ? TubeSurfaceAxialInner{alpha, alpha / rho, radius, 1.0}
                                   .stress_intensity(alpha, pi / 2)
                                   .I[0]
                             : TubeSurfaceAxialOuter{alpha, alpha / rho, radius, 1.0}
                                   .stress_intensity(alpha, pi / 2)
                                   .I[0];
        test::expect_relative(K / std::sqrt(pi * alpha), weighed, 0.01);  // the line's curvature
      }
    }
}

TEST(TubeSurfaceAxial, LimitPlate) {
  // For large r, the result is exactly the plate's fit under the uniform stress p r/t, for shallow
  // and deep cracks.
  for (const double c : {0.8e-3, 0.3e-3}) {
    const auto inner = crack_of<TubeSurfaceAxialInner>(0.4e-3, c, 100.0);
    const auto outer = crack_of<TubeSurfaceAxialOuter>(0.4e-3, c, 100.0);
    const NewmanRajuPlate fit(0.4e-3 / c);
    for (const double phi : {0.0, 0.6, pi / 2}) {
      const double plate = fit.tension(0.4, phi) * std::sqrt(pi * 0.4e-3);
      test::expect_relative(inner.stress_intensity(0.4e-3, phi).I[1], plate, 1e-14);
      test::expect_relative(outer.stress_intensity(0.4e-3, phi).I[1], plate, 1e-14);
      // The next terms are t/(2r) from Lame and t/r from the pressure on the faces; rounding is
      // 1e-16 r/t.
      test::expect_relative(inner.stress_intensity(0.4e-3, phi).I[0], plate * 1e5, 3e-5);
      test::expect_relative(outer.stress_intensity(0.4e-3, phi).I[0], plate * 1e5, 3e-5);
    }
  }
}

TEST(TubeSurfaceAxial, IdentityFaces) {
  // For a shallow crack, the stress is that at its face; an inner crack also carries the pressure
  // on its faces.
  const auto inner = crack_of<TubeSurfaceAxialInner>(1e-6, 1e-6, 0.0045);
  const auto outer = crack_of<TubeSurfaceAxialOuter>(1e-6, 1e-6, 0.0045);
  const double i2 = 16.0;
  const double o2 = 25.0;
  const double in = (o2 + i2) / (o2 - i2) + 1;  // 1 for the pressure on the faces
  const double out = 2 * i2 / (o2 - i2);
  const auto k = [](const auto& crack) {
    const auto both = crack.stress_intensity(1e-6, pi / 2);
    return both.I[0] / both.I[1];
  };
  test::expect_relative(k(inner), in, 1e-3);  // the gradient over a/t = 0.001
  test::expect_relative(k(outer), out, 1e-3);
  test::expect_relative(inner.gross_stress(0), 4.0, 1e-14);
  EXPECT_EQ(outer.gross_stress(1), 1.0);
}

TEST(TubeSurfaceAxial, IdentitySweptArea) {
  const auto crack = crack_of<TubeSurfaceAxialInner>(0.4e-3, 1e-3, 0.04);
  EXPECT_DOUBLE_EQ(crack.swept_area(0.2e-3, 0.3), 2 * 0.5e-3);
  EXPECT_EQ(crack.size(), 0.4e-3);
  EXPECT_EQ(crack.front().begin, 0.0);
  EXPECT_EQ(crack.front().end, pi / 2);
}

TEST(TubeSurfaceCrack, InputRules) {
  const auto sound = crack_of<TubeSurfaceAxialInner>(0.4e-3, 1e-3, 0.04);
  EXPECT_EQ(rules_broken(sound), Texts{});
  EXPECT_EQ(limits_broken(sound), Texts{});
  EXPECT_EQ(rules_broken(crack_of<TubeSurfaceAxialInner>(1e-3, 1e-3, 0.04)), Texts{"depth"});
  EXPECT_EQ(rules_broken(crack_of<TubeSurfaceAxialInner>(0.4e-3, 1e-3, 0.5e-3)),
            Texts{"thickness"});
  for (const double half_length : {0.0401, 3.99e-6})
    EXPECT_EQ(rules_broken(crack_of<TubeSurfaceAxialInner>(0.4e-3, half_length, 0.04)),
              Texts{"half_length"});
  EXPECT_EQ(limits_broken(crack_of<TubeSurfaceAxialInner>(0.81e-3, 1e-3, 0.04)),
            Texts{"a/t <= 0.8"});
  EXPECT_EQ(limits_broken(crack_of<TubeSurfaceAxialInner>(0.19e-3, 1e-3, 0.04)),
            Texts{"0.2 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(crack_of<TubeSurfaceAxialInner>(0.41e-3, 0.2e-3, 0.04)),
            Texts{"0.2 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(crack_of<TubeSurfaceAxialInner>(0.4e-3, 1e-3, 3.9e-3)),
            Texts{"r >= 4 t"});
  EXPECT_EQ(limits_broken(crack_of<TubeSurfaceAxialInner>(0.7e-3, 2.5e-3, 6e-3)),
            Texts{"c <= sqrt(r t)"});
}

// --- (SU-8): circumferential
// ----------------------------------------------------------------------------------

TEST(TubeSurfaceCircumferential, IdentityBeam) {
  const TubeWall wall{.mean_radius = 0.0045, .thickness = 0.001};
  using Outer = CircumferentialSurfaceCase<Face::outer>;
  using Inner = CircumferentialSurfaceCase<Face::inner>;
  // I by quadrature of rho^2/2 over the ring.
  const double I =
      integrate([](double rho) { return pi * rho * rho * rho; }, wall.inner(), wall.outer()).value;
  test::expect_relative(Outer::second_moment(wall), I, 1e-13);
  const WallStress outer = Outer::stress(1, wall, 0.3e-3);
  const WallStress inner = Inner::stress(1, wall, 0.3e-3);
  test::expect_relative(outer.tension + outer.bending, 0.005 / I, 1e-13);
  test::expect_relative(outer.tension - outer.bending, 0.004 / I, 1e-13);
  test::expect_relative(inner.tension + inner.bending, 0.004 / I, 1e-13);
  test::expect_relative(inner.tension - inner.bending, 0.005 / I, 1e-13);
  test::expect_relative(Outer::gross(1, wall), 0.005 / I, 1e-13);
  test::expect_relative(Inner::gross(1, wall), 0.004 / I, 1e-13);
  test::expect_relative(Outer::gross(0, wall), 1 / (pi * (25e-6 - 16e-6)), 1e-13);
  EXPECT_EQ(Inner::stress(0, wall, 0.3e-3).bending, 0.0);
  test::expect_relative(Inner::stress(0, wall, 0.3e-3).tension, Inner::gross(0, wall), 1e-15);
}

TEST(TubeSurfaceCircumferential, LimitPlateAndFaces) {
  // For large r, both faces behave as plates under their nominal stress; the next term is t/r =
  // 1e-4.
  const auto inner = crack_of<TubeSurfaceCircumferentialInner>(0.4e-3, 0.8e-3, 10.0);
  const auto outer = crack_of<TubeSurfaceCircumferentialOuter>(0.4e-3, 0.8e-3, 10.0);
  for (const double phi : {0.0, pi / 2}) {
    const double plate = NewmanRajuPlate(0.5).tension(0.4, phi) * std::sqrt(pi * 0.4e-3);
    for (const std::size_t load : {0U, 1U}) {
      test::expect_relative(inner.stress_intensity(0.4e-3, phi).I[load],
                            plate * inner.gross_stress(load), 1e-4);
      test::expect_relative(outer.stress_intensity(0.4e-3, phi).I[load],
                            plate * outer.gross_stress(load), 1e-4);
    }
  }
  // In a thick wall, bending falls towards the axis.
  const auto thick = crack_of<TubeSurfaceCircumferentialOuter>(0.4e-3, 0.8e-3, 0.005);
  EXPECT_LT(thick.stress_intensity(0.4e-3, pi / 2).I[1] / thick.gross_stress(1),
            thick.stress_intensity(0.4e-3, pi / 2).I[0] / thick.gross_stress(0));
}

// --- (SU-9): ovalised
// -----------------------------------------------------------------------------------------

TEST(TubeOvalisedSurface, IdentityPlateBending) {
  // Bending of the wall is that of the plate, which closes the tip of a deep crack, so H falls
  // below 0.
  for (const double c : {0.8e-3, 0.3e-3}) {
    const auto crack = crack_of<TubeOvalisedSurface>(0.4e-3, c, 0.04);
    const NewmanRajuPlate fit(0.4e-3 / c);
    for (const double phi : {0.0, 0.9, pi / 2}) {
      const auto k = crack.stress_intensity(0.4e-3, phi);
      const double plate = fit.tension(0.4, phi) * std::sqrt(pi * 0.4e-3);
      test::expect_relative(k.I[1], plate, 1e-14);
      test::expect_relative(k.I[0], plate * fit.bending_ratio(0.4, phi), 1e-14);
    }
    EXPECT_EQ(crack.gross_stress(0), 1.0);  // SU-9
  }
  const auto deep = crack_of<TubeOvalisedSurface>(0.8e-3, 0.8e-3, 0.04);
  EXPECT_LT(deep.stress_intensity(0.8e-3, pi / 2).I[0], 0.0);
  EXPECT_GT(deep.stress_intensity(0.8e-3, 0.0).I[0], 0.0);
}

// --- (SU-10): inclined
// ----------------------------------------------------------------------------------------

TubeSurfaceInclined inclined_surface(double angle) {
  return {.depth = 0.4e-3,
          .half_length = 1e-3,
          .angle = angle,
          .mean_radius = 0.04,
          .thickness = 0.001,
          .poissons_ratio = 0.3};
}

TEST(TubeSurfaceInclined, LimitCircumferential) {
  const auto crack = crack_of<TubeSurfaceCircumferentialInner>(0.4e-3, 1e-3, 0.04);
  for (const double phi : {0.0, 0.7, pi / 2}) {
    const auto k = inclined_surface(pi / 2).stress_intensity(0.3e-3, phi);
    test::expect_relative(k.I[kAxial], crack.stress_intensity(0.3e-3, phi).I[0], 1e-14);
    EXPECT_EQ(k.II[kAxial], 0.0);
    EXPECT_EQ(k.III[kAxial], 0.0);
  }
}

TEST(TubeSurfaceInclined, IdentityModes) {
  // SU-10 at 30 degrees: stresses by Mohr's circle, the three factors of the ellipse.
  const double beta = 30 * units::deg;
  const double sigma = 1 / (2 * pi * 0.04 * 0.001);
  const double tau = sigma / 0.04;
  const sif::NewmanRaju opening(0.4);
  const sif::KassirSih shearing(0.4, 0.3);
  const double root = std::sqrt(pi * 0.3e-3);
  const TubeSurfaceInclined crack = inclined_surface(beta);
  for (const double phi : {0.0, 0.7, pi / 2}) {
    const auto k = crack.stress_intensity(0.3e-3, phi);
    const double I = opening.factor(0.3, phi) * root;
    const double II = shearing.factor_II(phi) * root;
    const double III = shearing.factor_III(phi) * root;
    test::expect_relative(k.I[kAxial], sigma * 0.25 * I, 1e-13);
    test::expect_relative(k.I[kTorsion], tau * std::sqrt(0.75) * I, 1e-13);
    EXPECT_NEAR(k.II[kAxial], sigma * std::sqrt(3.0) / 4 * II, 1e-13 * sigma);
    EXPECT_NEAR(k.II[kTorsion], tau * 0.5 * II, 1e-13 * tau);
    EXPECT_NEAR(k.III[kAxial], sigma * std::sqrt(3.0) / 4 * III, 1e-13 * sigma);
    EXPECT_NEAR(k.III[kTorsion], tau * 0.5 * III, 1e-13 * tau);
  }
  EXPECT_LT(inclined_surface(-beta).stress_intensity(0.3e-3, 0.7).I[kTorsion], 0.0);
  test::expect_relative(crack.gross_stress(kAxial), sigma, 1e-14);
  test::expect_relative(crack.gross_stress(kTorsion), tau, 1e-14);
  EXPECT_DOUBLE_EQ(crack.swept_area(0.3e-3, 0.0), 2 * 0.75e-3);
  EXPECT_EQ(crack.size(), 0.4e-3);
}

TEST(TubeSurfaceInclined, InputRules) {
  const auto changed = [](double TubeSurfaceInclined::*field, double value) {
    TubeSurfaceInclined crack = inclined_surface(0.5);
    crack.*field = value;
    return crack;
  };
  using T = TubeSurfaceInclined;
  EXPECT_EQ(rules_broken(inclined_surface(0.5)), Texts{});
  EXPECT_EQ(limits_broken(inclined_surface(0.5)), Texts{});
  EXPECT_EQ(rules_broken(changed(&T::depth, 1e-3)), Texts{"depth"});
  EXPECT_EQ(rules_broken(changed(&T::half_length, 0.39e-3)), Texts{"depth"});
  EXPECT_EQ(rules_broken(changed(&T::half_length, 41e-3)), Texts{"half_length"});
  EXPECT_EQ(rules_broken(changed(&T::mean_radius, 0.5e-3)), Texts{"thickness"});
  EXPECT_EQ(limits_broken(changed(&T::depth, 0.81e-3)), Texts{"a/t <= 0.8"});
  EXPECT_EQ(limits_broken(changed(&T::depth, 0.19e-3)), Texts{"a/c >= 0.2"});
  EXPECT_EQ(limits_broken(changed(&T::mean_radius, 9.9e-3)), Texts{"r >= 10 t"});
  TubeSurfaceInclined crack = changed(&T::half_length, 3.5e-3);
  crack.depth = 0.75e-3;
  crack.mean_radius = 0.0121;
  EXPECT_EQ(limits_broken(crack), Texts{"c <= sqrt(r t)"});
}

// --- (SU-11): all along the tube
// ------------------------------------------------------------------------------

template <class S>
S edge(double depth_ratio, double radius_ratio) {
  return {.depth = depth_ratio * 0.01,
          .mean_radius = radius_ratio * 0.01,
          .thickness = 0.01,
          .length = 0.1};
}

TEST(TubeEdgeAxial, ReferenceFiniteElementsOfRings) {
  // K/sqrt(pi a).  Strip (FR-11) and curved beam: 0.7 % at r/t = 5, 0.3 % from 10; the elements are
  // accurate to 0.3 %.
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("cracked_ring")) {
    const double a = row("depth_ratio") * 0.01;
    const auto k = row("inner_face") == 1
                       ? edge<TubeEdgeAxialInner>(row("depth_ratio"), row("radius_ratio"))
                             .stress_intensity(a, 0)
                       : edge<TubeEdgeAxialOuter>(row("depth_ratio"), row("radius_ratio"))
                             .stress_intensity(a, 0);
    const std::size_t load = row.quantity == "pressure" ? 0 : (row.quantity == "tension" ? 1 : 2);
    EXPECT_NEAR(k.I[load] / std::sqrt(pi * a) / row.value, 1,
                row("radius_ratio") < 10 ? 7e-3 : 3.5e-3)
        << row.place;
    ++n;
  }
  EXPECT_EQ(n, 54);
}

TEST(TubeEdgeAxial, LimitStrip) {
  // A slender ring does not resist, so the result is the strip; the next term is t/r.
  const double a = 0.005;
  const double root = std::sqrt(pi * a);
  const auto inner = edge<TubeEdgeAxialInner>(0.5, 1e4).stress_intensity(a, 0);
  const auto outer = edge<TubeEdgeAxialOuter>(0.5, 1e4).stress_intensity(a, 0);
  const double tension = sif::edge_crack_factor(sif::StripLoading::tension, 0.5) * root;
  const double bending = sif::edge_crack_factor(sif::StripLoading::bending, 0.5) * root;
  for (const auto& k : {inner, outer}) {
    test::expect_relative(k.I[0], tension * 1e4, 5e-4);
    test::expect_relative(k.I[1], tension, 5e-4);
    test::expect_relative(k.I[2], bending, 5e-4);
  }
}

TEST(TubeEdgeAxial, LimitLongSurfaceCrack) {
  // Newman and Raju give 1.13 for a long shallow crack; the edge crack gives 1.1215.
  const auto shallow = edge<TubeEdgeAxialInner>(1e-5, 20).stress_intensity(1e-7, 0);
  const TubeSurfaceAxialInner surface{
      .depth = 1e-7, .half_length = 1e-3, .mean_radius = 0.2, .thickness = 0.01};
  test::expect_relative(shallow.I[1], surface.stress_intensity(1e-7, pi / 2).I[1], 0.01);
  test::expect_relative(shallow.I[0], surface.stress_intensity(1e-7, pi / 2).I[0], 0.01);
}

TEST(TubeEdgeAxial, IdentityGeometry) {
  const auto crack = edge<TubeEdgeAxialOuter>(0.4, 8);
  EXPECT_EQ(crack.swept_area(0.001, 0.0), 0.1);
  EXPECT_EQ(crack.size(), 0.004);
  EXPECT_EQ(crack.front().begin, crack.front().end);
  test::expect_relative(crack.gross_stress(0), 7.5, 1e-14);
  EXPECT_EQ(crack.gross_stress(2), 1.0);
}

TEST(TubeEdgeAxial, InputRules) {
  EXPECT_EQ(rules_broken(edge<TubeEdgeAxialInner>(0.4, 8)), Texts{});
  EXPECT_EQ(limits_broken(edge<TubeEdgeAxialInner>(0.4, 8)), Texts{});
  EXPECT_EQ(rules_broken(edge<TubeEdgeAxialInner>(1.0, 8)), Texts{"depth"});
  EXPECT_EQ(rules_broken(edge<TubeEdgeAxialInner>(0.4, 0.5)), Texts{"thickness"});
  EXPECT_EQ(limits_broken(edge<TubeEdgeAxialInner>(0.71, 8)), Texts{"a/t <= 0.7"});
  EXPECT_EQ(limits_broken(edge<TubeEdgeAxialInner>(0.4, 4.9)), Texts{"r >= 5 t"});
  auto crack = edge<TubeEdgeAxialInner>(0.4, 8);
  crack.length = 0.049;
  EXPECT_EQ(limits_broken(crack), Texts{"length >= 5 t, plane strain"});
}

}  // namespace
}  // namespace strainwave::sif

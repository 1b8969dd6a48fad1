// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/harmonic_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using std::numbers::pi;

constexpr Elasticity kRingSteel{.youngs_modulus = 206e9, .poissons_ratio = 0.3};

struct Tube {
  double inner = 0.03;
  double outer = 0.031;
  double length = 0.02;
  bool held = true;
};

SectionMesh waved_mesh(const Tube& tube, double coarse) {
  SectionShape shape;
  shape.rectangles.push_back({tube.inner, tube.outer, 0, tube.length, 0});
  if (tube.held)
    shape.sides.push_back(
        {.at_z = true, .level = 0, .from = tube.inner, .to = tube.outer, .role = EdgeRole::held});
  return mesh_section(shape, {.coarse_r = coarse, .coarse_z = coarse});
}

/// Traction on the end z = length.
EdgeTraction on_end(const Tube& tube, std::function<WaveVector(double r)> traction) {
  return [=, length = tube.length](const SectionPoint& place, const SectionPoint& out) {
    return out.z > 0.5 && std::abs(place.z - length) < 1e-12 ? traction(place.r) : WaveVector{};
  };
}

// (FE-51) Kind: closed form.  Source: St Venant's torsion, L/(mu J), exact for the traction T r/J.
// Tolerance 1e-10: rounding.
TEST(HarmonicSection, ReferenceTwistOfATube) {
  const Tube tube;
  const double J = pi / 2 * (std::pow(tube.outer, 4) - std::pow(tube.inner, 4));
  const HarmonicSection body(waved_mesh(tube, 0.01), kRingSteel, {.order = 3});
  const std::vector<EdgeTraction> loads{on_end(tube, [&](double r) {
    return WaveVector{0, r / J, 0};
  })};
  const HarmonicSolution twisted = body.equations(0).solve(loads).front();
  const double compliance = tube.length / (kRingSteel.shear_modulus() * J);
  EXPECT_NEAR(twisted.work_of_loads.front() / compliance, 1, 1e-10);
  EXPECT_NEAR(2 * twisted.energy / compliance, 1, 1e-10);
  EXPECT_LT(twisted.equilibrium_residual, 1e-9);
  const std::vector<SectionPoint> points{{.r = 0.0305, .z = 0.007}};
  const HarmonicPoint at = body.at(twisted, body.locate(points).front());
  EXPECT_NEAR(at.stress[3] / (0.0305 / J), 1, 1e-9);  // theta z
  EXPECT_NEAR(at.displacement[1] / (0.0305 * 0.007 / (kRingSteel.shear_modulus() * J)), 1, 1e-9);
}

// Kind: closed form.  Source: a clamped beam under a force at its end, P L^3/(3 E I) with the shear
// of a thin tube, shape factor 2(1+nu)/(4+3nu).  Tolerance 1 %: the clamp holds the section's
// shape.
TEST(HarmonicSection, ReferenceBeamUnderOneWave) {
  const Tube tube{.inner = 0.0285, .outer = 0.0315, .length = 0.6};
  const HarmonicSection body(waved_mesh(tube, 0.03), kRingSteel, {.order = 4});
  const double area = pi * (std::pow(tube.outer, 2) - std::pow(tube.inner, 2));
  const double I = pi / 4 * (std::pow(tube.outer, 4) - std::pow(tube.inner, 4));
  // Shear stress of a thin tube, 2 P/A sin(theta) against theta: the force P acts along x.
  const std::vector<EdgeTraction> loads{on_end(tube, [&](double) {
    return WaveVector{0, -2 / area, 0};
  })};
  const HarmonicSolution bent = body.equations(1).solve(loads).front();
  const double E = kRingSteel.youngs_modulus;
  const double nu = kRingSteel.poissons_ratio;
  const double shape = 2 * (1 + nu) / (4 + 3 * nu);
  const double beam = std::pow(tube.length, 3) / (3 * E * I) +
                      tube.length / (shape * kRingSteel.shear_modulus() * area);
  EXPECT_NEAR(bent.work_of_loads.front() / beam, 1, 0.01);
}

/// Amplitude of the radial displacement of a ring under q cos(n theta), per q R^4/(E I) [-].
double ring_displacement(const HarmonicSection& body, int waves, const Tube& ring) {
  const double R = (ring.inner + ring.outer) / 2;
  const double t = ring.outer - ring.inner;
  const std::vector<EdgeTraction> loads{[&](const SectionPoint&, const SectionPoint& out) {
    return out.r > 0.5 ? WaveVector{1, 0, 0} : WaveVector{};
  }};
  const HarmonicSolution bent = body.equations(waves).solve(loads).front();
  const std::vector<SectionPoint> middle{{.r = R, .z = ring.length / 2}};
  const double w = body.at(bent, body.locate(middle).front()).displacement[0];
  const double I = ring.length * std::pow(t, 3) / 12;
  const double q = ring.length * ring.outer / R;  // per length of the centre line
  return w * kRingSteel.youngs_modulus * I / (q * std::pow(R, 4));
}

// Kind: closed form and published.  Source: a thin ring that does not stretch bends by
// 1/(n^2-1)^2; the sum over even n is the ring under two opposite forces, whose diameters change by
// 0.1488 and -0.1366 P R^3/(E I) (Timoshenko).  Tolerance 1e-4 n^2: stretch and shear of the ring
// at t/R = 1/60; 4e-4: the same, and the sum ends at n = 12.
TEST(HarmonicSection, ReferenceRingUnderWaves) {
  const Tube ring{.inner = 0.0295, .outer = 0.03, .length = 0.0005, .held = false};
  const HarmonicSection body(waved_mesh(ring, 0.001), kRingSteel, {.order = 6});
  double along = 0;
  double across = 0;
  for (int n = 2; n <= 12; n += 2) {
    const double w = ring_displacement(body, n, ring);
    EXPECT_NEAR(w * std::pow(n * n - 1, 2), 1, 1e-4 * n * n) << n;
    along += 4 / pi * w;
    across += 4 / pi * w * (n % 4 == 0 ? 1 : -1);
  }
  EXPECT_NEAR(along, 0.1488, 4e-4);
  EXPECT_NEAR(across, -0.1366, 4e-4);
}

// Kind: reciprocity of two loads, and superposition.  Tolerance 1e-9: rounding.
TEST(HarmonicSection, IdentityReciprocityOfLoads) {
  const Tube tube;
  const HarmonicSection body(waved_mesh(tube, 0.005), kRingSteel, {.order = 4});
  const std::vector<EdgeTraction> loads{on_end(tube,
                                               [](double) {
                                                 return WaveVector{1e6, 0, 3e5};
                                               }),
                                        [](const SectionPoint& place, const SectionPoint& out) {
                                          return out.r < -0.5 && place.z > 0.005 && place.z < 0.01
                                                     ? WaveVector{2e5, 4e5, 0}
                                                     : WaveVector{};
                                        }};
  const auto solutions = body.equations(3).solve(loads);
  ASSERT_EQ(solutions.size(), 2U);
  EXPECT_NEAR(solutions[0].work_of_loads[1] / solutions[1].work_of_loads[0], 1, 1e-9);
  EXPECT_NEAR(solutions[0].work_of_loads[0] / (2 * solutions[0].energy), 1, 1e-9);
  EXPECT_NE(solutions[0].work_of_loads[1], 0);
}

/// Strain energy of waves 0, 2, 4, ... of a tube by quadrature in the test [J].
/// @param large  with H^T H in the strain
double energy_of(const HarmonicSection& body, const Tube& tube,
                 const std::vector<HarmonicSolution>& waves, bool large) {
  constexpr std::array kPoint{-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                              0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
  constexpr std::array kWeight{0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                               0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  constexpr int kAngles = 48;
  const double mu = kRingSteel.shear_modulus();
  const double lambda = 2 * mu * kRingSteel.poissons_ratio / (1 - 2 * kRingSteel.poissons_ratio);
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const double r = (tube.inner + tube.outer + kPoint[i] * (tube.outer - tube.inner)) / 2;
      const double z = tube.length * (1 + kPoint[j]) / 2;
      const std::vector<SectionPoint> point{{.r = r, .z = z}};
      const SectionPlace place = body.locate(point).front();
      const double area = kWeight[i] * kWeight[j] * (tube.outer - tube.inner) * tube.length / 4;
      for (int k = 0; k < kAngles; ++k) {
        const double angle = 2 * pi * k / kAngles;
        CylinderGradient H{};
        for (const HarmonicSolution& wave : waves)
          add_gradient(H, body.at(wave, place), wave.waves, r, angle);
        double square = 0;
        double trace = 0;
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t b = 0; b < 3; ++b) {
            double strain = (H[a][b] + H[b][a]) / 2;
            if (large)
              for (std::size_t c = 0; c < 3; ++c) strain += H[c][a] * H[c][b] / 2;
            square += strain * strain;
            if (a == b) trace += strain;
          }
        sum += (lambda / 2 * trace * trace + mu * square) * r * area * 2 * pi / kAngles;
      }
    }
  return sum;
}

// (FE-53) Kind: two roads.  The forces of large rotations are the derivative of the strain energy
// that they add, here a difference of energies by a quadrature of the test's own.  Tolerance 1e-5:
// the step of the difference.
TEST(HarmonicSection, CrosscheckForcesOfLargeRotations) {
  const Tube tube{.inner = 0.03, .outer = 0.032, .length = 0.01};
  const HarmonicSection body(waved_mesh(tube, 0.02), kRingSteel, {.order = 3});
  const auto waves = [&](const EdgeTraction& load, double scale) {
    std::vector<HarmonicSolution> solutions;
    for (int n = 0; n <= 4; n += 2) {
      solutions.push_back(body.equations(n).solve(std::span(&load, 1)).front());
      // A displacement of about a tenth of the radius: large rotations.
      double largest = 0;
      for (const double u : solutions.back().displacement) largest = std::max(largest, std::abs(u));
      for (double& u : solutions.back().displacement) u *= scale / largest;
    }
    return solutions;
  };
  const auto state = waves(on_end(tube, [](double) { return WaveVector{1e6, 0, 2e5}; }), 2e-3);
  const auto direction = waves(on_end(tube,
                                      [](double r) {
                                        return WaveVector{1e6, 3e6 * (r - 0.031) / 0.031, -4e5};
                                      }),
                               1e-3);
  const auto moved = [&](double by) {
    auto sum = state;
    for (std::size_t n = 0; n < sum.size(); ++n)
      for (std::size_t i = 0; i < sum[n].displacement.size(); ++i)
        sum[n].displacement[i] += by * direction[n].displacement[i];
    return sum;
  };
  constexpr double kStep = 1e-3;
  const auto slope = [&](bool large) {
    return (energy_of(body, tube, moved(kStep), large) -
            energy_of(body, tube, moved(-kStep), large)) /
           (2 * kStep);
  };
  const double added = slope(true) - slope(false);
  const auto forces = body.large_rotation_forces(state);
  double work = 0;
  for (std::size_t n = 0; n < forces.size(); ++n)
    for (std::size_t i = 0; i < forces[n].size(); ++i)
      work -= (n == 0 ? 2 : 1) * pi * forces[n][i] * direction[n].displacement[i];
  EXPECT_NEAR(work / added, 1, 1e-5);
  EXPECT_GT(std::abs(added), 0.1 * std::abs(slope(false)));  // not a small part
}

TEST(HarmonicSection, InputRefused) {
  const Tube tube;
  EXPECT_THROW(HarmonicSection(waved_mesh(tube, 0.01), kRingSteel, {.order = 1}), InputError);
  EXPECT_THROW(HarmonicSection(waved_mesh(tube, 0.01), {.youngs_modulus = -1}), InputError);
  const HarmonicSection body(waved_mesh(tube, 0.01), kRingSteel, {.order = 2});
  const std::vector<EdgeTraction> none;
  const std::vector<EdgeTraction> one{on_end(tube, [](double) { return WaveVector{1, 0, 0}; })};
  EXPECT_THROW((void)body.equations(2).solve(none), InputError);
  EXPECT_THROW((void)body.equations(-1).solve(one), InputError);
  const std::vector<SectionPoint> outside{{.r = 0.05, .z = 0.01}};
  EXPECT_THROW((void)body.locate(outside), InputError);
  Tube loose = tube;
  loose.held = false;
  const HarmonicSection free(waved_mesh(loose, 0.01), kRingSteel, {.order = 2});
  EXPECT_THROW((void)free.equations(1).solve(one), InputError);
  EXPECT_GT(free.equations(2).solve(one).front().energy, 0);
  Tube solid = tube;
  solid.inner = 0;
  EXPECT_THROW(HarmonicSection(waved_mesh(solid, 0.01), kRingSteel), InputError);
}

}  // namespace
}  // namespace strainwave::fem

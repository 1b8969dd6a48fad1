// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/crack_compliance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include "strainwave/core/quadrature.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using test::Arg;

// --- cracks with closed solutions, only for these tests
// ---------------------------------------------

/// Penny in an infinite body under tension: K_I = 2 sigma sqrt(a/pi), dA = a da dtheta.
struct Penny {
  static constexpr std::size_t kLoads = 1;
  double radius = 1.0;

  [[nodiscard]] double size() const { return radius; }
  [[nodiscard]] FrontRange front() const { return {0.0, 2 * pi}; }
  [[nodiscard]] UnitStressIntensity<1> stress_intensity(double a, double) const {
    return {.I = {2 * std::sqrt(a / pi)}, .II = {}, .III = {}};
  }
  [[nodiscard]] double swept_area(double a, double) const { return a; }
};

/// Ellipse in an infinite body under tension: K_I = sigma sqrt(pi a) f/E(k), dA = c da dphi; the
/// complete elliptic integral is given.
struct EmbeddedEllipse {
  static constexpr std::size_t kLoads = 1;
  double depth = 1.0;
  double aspect_ratio = 0.5;
  double elliptic_E = 0.0;
  double front_end = 2 * pi;  ///< of the part of the front that is followed

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {0.0, front_end}; }
  [[nodiscard]] UnitStressIntensity<1> stress_intensity(double a, double phi) const {
    const double f2 = std::hypot(aspect_ratio * std::cos(phi), std::sin(phi));
    return {.I = {std::sqrt(pi * a * f2) / elliptic_E}, .II = {}, .III = {}};
  }
  [[nodiscard]] double swept_area(double a, double) const { return a / aspect_ratio; }
};

/// Edge crack in a strip under antiplane shear: K_III = tau sqrt(2t tan(pi a/2t)), front of width
/// B.
struct AntiplaneStrip {
  static constexpr std::size_t kLoads = 1;
  double depth = 0.5;
  double thickness = 1.0;
  double width = 1.0;

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<1> stress_intensity(double a, double) const {
    const double t = thickness;
    return {.I = {}, .II = {}, .III = {std::sqrt(2 * t * std::tan(pi * a / (2 * t)))}};
  }
  [[nodiscard]] double swept_area(double, double) const { return width; }
};

/// A front of one point from a callable: stress_intensity = f(a), dA = width da.
template <std::size_t N, class F>
struct PointFront {
  static constexpr std::size_t kLoads = N;
  F f;
  double final_size = 1.0;
  double width = 1.0;

  [[nodiscard]] double size() const { return final_size; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<N> stress_intensity(double a, double) const { return f(a); }
  [[nodiscard]] double swept_area(double, double) const { return width; }
};
template <std::size_t N, class F>
PointFront<N, F> point_front(F f, double size = 1.0, double width = 1.0) {
  return {std::move(f), size, width};
}

// --- the symmetric matrix
// ---------------------------------------------------------------------------

TEST(SymmetricMatrix, IdentityIndicesAreSymmetricAndComplete) {
  using Matrix = SymmetricMatrix<4>;
  static_assert(std::tuple_size_v<decltype(Matrix::upper)> == 10);
  std::size_t next = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) {
      EXPECT_EQ(Matrix::index(i, j), next);
      EXPECT_EQ(Matrix::index(j, i), next);
      ++next;
    }
  EXPECT_EQ(next, 10U);
}

TEST(SymmetricMatrix, IdentityArithmeticWorksOnEveryEntry) {
  SymmetricMatrix<2> a;
  EXPECT_EQ(a.upper, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(SymmetricMatrix<2>(2.5).upper, (std::array{2.5, 2.5, 2.5}));
  a(0, 0) = 1;
  a(1, 0) = -2;  // written below the diagonal
  a(1, 1) = 3;
  EXPECT_EQ(a(0, 1), -2.0);
  const SymmetricMatrix<2> b(10.0);
  EXPECT_EQ((a + b).upper, (std::array{11.0, 8.0, 13.0}));
  EXPECT_EQ((a - b).upper, (std::array{-9.0, -12.0, -7.0}));
  EXPECT_EQ((-a).upper, (std::array{-1.0, 2.0, -3.0}));
  EXPECT_EQ((a * 3.0).upper, (std::array{3.0, -6.0, 9.0}));
  EXPECT_EQ((3.0 * a).upper, (std::array{3.0, -6.0, 9.0}));
  a += b;
  EXPECT_EQ(a.upper, (std::array{11.0, 8.0, 13.0}));
  a *= 2;
  EXPECT_EQ(a.upper, (std::array{22.0, 16.0, 26.0}));
}

TEST(SymmetricMatrix, IdentityNormIsTheLargestMagnitude) {
  SymmetricMatrix<2> a;
  EXPECT_EQ(abs(a), 0.0);
  a(0, 1) = -7;
  a(1, 1) = 3;
  EXPECT_EQ(abs(a), 7.0);
  a(0, 0) = 9;
  EXPECT_EQ(abs(a), 9.0);
}

// --- (FR-1), (FR-2): the integrand
// -----------------------------------------------------------------

TEST(EnergyReleaseRate, ReferenceIrwin) {
  const CrackModuli moduli{.opening = 5.0, .shear = 7.0};
  const auto irwin = [](double value) {
    return test::Reference{.value = value,
                           .unit = "J/m^2",
                           .relative_tolerance = 1e-15,
                           .source = "Irwin: G = (K_I^2 + K_II^2)/E' + K_III^2/(2 mu), by hand",
                           .tolerance_is = "rounding of seven operations"};
  };
  test::expect_reference(energy_release_rate(2, 0, 0, moduli), irwin(4.0 / 5));
  test::expect_reference(energy_release_rate(0, 3, 0, moduli), irwin(9.0 / 5));
  test::expect_reference(energy_release_rate(0, 0, 4, moduli), irwin(16.0 / 14));
  test::expect_reference(energy_release_rate(2, -3, 4, moduli), irwin(13.0 / 5 + 8.0 / 7));
}

TEST(EnergyReleaseRate, IdentityModeThreeOfAnIsotropicBodyNeedsNoStressState) {
  // K_III^2/(2 mu) = (1 + nu) K_III^2/E, in plane stress and in plane strain.
  const double E = 210e9;
  const double nu = 0.3;
  const double mu = E / (2 * (1 + nu));
  for (const double opening : {E, E / (1 - nu * nu)})
    test::expect_relative(energy_release_rate(0, 0, 1, {.opening = opening, .shear = mu}),
                          (1 + nu) / E, 1e-15);
}

TEST(EnergyReleaseRate, ScalingIsEnergyPerArea) {
  test::expect_dimensionally_consistent(
      "J/m^2",
      [](double K1, double K2, double K3, double E, double mu) {
        return energy_release_rate(K1, K2, K3, {.opening = E, .shear = mu});
      },
      Arg{3e6, "Pa*m^0.5"}, Arg{2e6, "Pa*m^0.5"}, Arg{5e6, "Pa*m^0.5"}, Arg{2.1e11, "Pa"},
      Arg{8e10, "Pa"});
}

TEST(ComplianceDensity, IdentityTwiceTheEnergyReleaseRate) {
  // Q^T (d lambda/dA) Q = 2 G for all loads Q, which fixes every entry of the matrix.
  const UnitStressIntensity<3> k{
      .I = {1.0, -2.0, 0.5}, .II = {0.3, 4.0, -1.0}, .III = {2.0, 0.0, -3.0}};
  const CrackModuli moduli{.opening = 11.0, .shear = 4.0};
  const SymmetricMatrix<3> density = compliance_density(k, moduli);
  for (const std::array<double, 3> Q : {std::array{1.0, 0.0, 0.0},
                                        {0.0, 1.0, 0.0},
                                        {0.0, 0.0, 1.0},
                                        {1.0, 1.0, 0.0},
                                        {0.0, 1.0, -1.0},
                                        {1.0, 0.0, 1.0},
                                        {2.0, -3.0, 5.0}}) {
    double quadratic = 0.0;
    std::array<double, 3> K{};
    for (std::size_t i = 0; i < 3; ++i) {
      K[0] += k.I[i] * Q[i];
      K[1] += k.II[i] * Q[i];
      K[2] += k.III[i] * Q[i];
      for (std::size_t j = 0; j < 3; ++j) quadratic += Q[i] * density(i, j) * Q[j];
    }
    test::expect_relative(quadratic, 2 * energy_release_rate(K[0], K[1], K[2], moduli), 1e-14);
  }
  EXPECT_NE(density(0, 1), 0.0);
}

// --- (FR-2): the engine against closed solutions
// ----------------------------------------------------

TEST(AddedCompliance, ReferencePennyInTension) {
  const double nu = 0.3;
  const auto added =
      added_compliance(Penny{}, {.opening = 1 / (1 - nu * nu), .shear = 1.0});  // E = 1
  test::expect_reference(added.matrix(0, 0) / 2,  // energy 1/2 lambda sigma^2
                         {.value = 8 * 0.91 / 3,
                          .unit = "J, at sigma = a = E = 1",
                          .relative_tolerance = 1e-12,
                          .source = "Sneddon: 8(1-nu^2) sigma^2 a^3/(3E), exact",
                          .tolerance_is = "rounding; the integrand is a polynomial"});
  EXPECT_TRUE(added.converged);
}

TEST(AddedCompliance, ReferenceEmbeddedEllipse) {
  const double nu = 0.3;
  const auto added =
      added_compliance(EmbeddedEllipse{.depth = 1.0, .aspect_ratio = 0.5, .elliptic_E = 1.2110560},
                       {.opening = 1 / (1 - nu * nu), .shear = 1.0});
  test::expect_reference(added.matrix(0, 0) / 2,
                         {.value = 6.2950004,
                          .unit = "J, at sigma = a = E = 1",
                          .relative_tolerance = 5e-8,
                          .source = "Irwin; Green and Sneddon: (4 pi/3)(1-nu^2) a^2 c/E(k), exact",
                          .tolerance_is = "eight digits printed, of the energy and of E(k)"});
}

TEST(AddedCompliance, ReferenceEllipseTable) {
  // The front average of f^2 is given by the complete elliptic integral E(k).
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("elliptical_crack_shear")) {
    const bool unit = row.quantity == "unit_penny.tension_energy" ||
                      row.quantity == "unit_ellipse.tension_energy";
    if (!unit && row.quantity != "tension_energy_per_stress_squared") continue;
    const double rho = row("aspect_ratio");
    const double E_k =
        integrate<31>([&](double phi) { return std::hypot(rho * std::cos(phi), std::sin(phi)); },
                      0.0, pi / 2, {.relative_tolerance = 1e-14})
            .value;
    const double nu = row("poissons_ratio");
    const EmbeddedEllipse crack{.depth = row("depth"), .aspect_ratio = rho, .elliptic_E = E_k};
    const double E = row("youngs_modulus");
    const auto added =
        added_compliance(crack, {.opening = E / (1 - nu * nu), .shear = E / (2 * (1 + nu))});
    // The tolerance of the engine is 1e-10 for each integral.
    test::expect_row(added.matrix(0, 0) / 2, row, 1e-11);
    ++n;
  }
  EXPECT_GE(n, 14);
}

TEST(AddedCompliance, ReferenceAntiplaneStrip) {
  const auto added = added_compliance(AntiplaneStrip{}, {.opening = 1.0, .shear = 1.0});
  test::expect_reference(added.matrix(0, 0),
                         {.value = 0.44127120,
                          .unit = "m^2, at t = 1, a = 0.5",
                          .relative_tolerance = 2e-8,
                          .source = "tada2000 (secondary): (4t^2/pi) ln sec(pi a/2t), exact",
                          .tolerance_is = "eight digits printed"});
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    if (row.quantity != "antiplane_energy_integral") continue;
    const AntiplaneStrip crack{.depth = row("depth_ratio") * row("thickness"),
                               .thickness = row("thickness")};
    test::expect_row(added_compliance(crack, {.opening = 1.0, .shear = 1.0}).matrix(0, 0), row,
                     1e-12);
  }
}

TEST(AddedCompliance, IdentityAntiplaneStripForEveryDepth) {
  for (const double alpha : {1e-6, 0.1, 0.5, 0.9, 0.99}) {
    const AntiplaneStrip crack{.depth = alpha * 0.01, .thickness = 0.01, .width = 0.3};
    const auto added = added_compliance(crack, {.opening = 3.0, .shear = 8e10});
    const double s = std::sin(pi * alpha / 4);
    const double log_sec = -std::log1p(-2 * s * s);  // 1 - 2 sin^2(x/2) = cos(x)
    test::expect_relative(added.matrix(0, 0), 0.3 * 4 * 1e-4 / pi * log_sec / 8e10, 1e-10);
    EXPECT_TRUE(added.converged);
  }
}

TEST(AddedCompliance, IdentityGriffith) {
  // Plate of thickness t, K_I = sigma sqrt(pi a), two tips: energy pi sigma^2 a^2 t/E.
  const double t = 2.24e-3;
  const double a = 1e-3;
  const auto crack = point_front<1>(
      [](double s) {
        return UnitStressIntensity<1>{.I = {std::sqrt(pi * s)}, .II = {}, .III = {}};
      },
      a, 2 * t);
  const auto added = added_compliance(crack, {.opening = 210e9, .shear = 80e9});
  test::expect_relative(added.matrix(0, 0) / 2, pi * a * a * t / 210e9, 1e-12);
}

TEST(AddedCompliance, IdentityDisplacementIsTwiceTheIntegralOfReleaseRateOverLoad) {
  // Castigliano: Delta u = d/dP int G dA = int (2G/P) dA, not half of it.
  const double P = 3.0;
  const CrackModuli moduli{.opening = 2.0, .shear = 0.7};
  const AntiplaneStrip crack{.depth = 0.6, .thickness = 1.0, .width = 2.0};
  const double energy = integrate(
                            [&](double a) {
                              const double K = crack.stress_intensity(a, 0).III[0] * P;
                              return energy_release_rate(0, 0, K, moduli) * crack.width;
                            },
                            0.0, crack.depth)
                            .value;
  test::expect_relative(added_compliance(crack, moduli).matrix(0, 0) * P, 2 * energy / P, 1e-12);
}

TEST(AddedCompliance, IdentityHalfFrontAddsHalf) {
  const CrackModuli moduli{.opening = 2.0, .shear = 1.0};
  EmbeddedEllipse crack{.depth = 0.7, .aspect_ratio = 0.3, .elliptic_E = 1.1};
  const double full = added_compliance(crack, moduli).matrix(0, 0);
  crack.front_end = pi;
  test::expect_relative(added_compliance(crack, moduli).matrix(0, 0), full / 2, 1e-10);
  crack.front_end = pi / 2;
  test::expect_relative(added_compliance(crack, moduli).matrix(0, 0), full / 4, 1e-10);
}

TEST(AddedCompliance, IdentityModesAndModuli) {
  // k constant over a unit area: 2/E' of modes I and II, 1/mu of mode III.
  const CrackModuli moduli{.opening = 5.0, .shear = 3.0};
  const auto with = [&](double I, double II, double III) {
    const auto k = [=](double) {
      return UnitStressIntensity<1>{.I = {I}, .II = {II}, .III = {III}};
    };
    return added_compliance(point_front<1>(k), moduli).matrix(0, 0);
  };
  test::expect_relative(with(1, 0, 0), 2.0 / 5, 1e-14);
  test::expect_relative(with(0, 1, 0), 2.0 / 5, 1e-14);
  test::expect_relative(with(0, 0, 1), 1.0 / 3, 1e-14);
  test::expect_relative(with(2, 3, 4), 26.0 / 5 + 16.0 / 3, 1e-14);
}

// --- the engine: loads, units, evidence
// -------------------------------------------------------------

/// Three loads: a smooth one, one with a kink at a third of the size, and one without effect.
UnitStressIntensity<3> smooth_kinked_idle(double x, double smooth, double kinked) {
  const double kink = kinked * std::sqrt(std::abs(x - 1.0 / 3));
  return {.I = {smooth * x, 0, 0}, .II = {}, .III = {0, kink, 0}};
}

TEST(AddedCompliance, IdentityLoadUnitsDoNotMatter) {
  // The same crack with its loads in other units, and with lengths in millimetres: the entries
  // scale with the units to rounding, and the evidence does not change.
  const CrackModuli moduli{.opening = 1.0, .shear = 1.0};
  const QuadratureOptions coarse{.relative_tolerance = 1e-4};
  const auto result = [&](double unit0, double unit1, double size) {
    const auto k = [=](double a) { return smooth_kinked_idle(a / size, unit0, unit1); };
    return added_compliance(point_front<3>(k, size), moduli, coarse);
  };
  const auto plain = result(1, 1, 1);
  EXPECT_GT(plain.relative_error, 0.0);
  for (const auto& [unit0, unit1, size] :
       {std::array{1e6, 1e-5, 1.0}, {1e-7, 1e4, 1.0}, {1.0, 1.0, 1e-3}, {1e3, 1e-3, 1e-3}}) {
    const auto other = result(unit0, unit1, size);
    test::expect_relative(other.matrix(0, 0) / (unit0 * unit0 * size), plain.matrix(0, 0), 1e-13);
    test::expect_relative(other.matrix(1, 1) / (unit1 * unit1 * size), plain.matrix(1, 1), 1e-13);
    test::expect_relative(other.relative_error, plain.relative_error, 1e-6);
    EXPECT_EQ(other.matrix(0, 1), 0.0);
    EXPECT_EQ(other.matrix(2, 2), 0.0);
    EXPECT_EQ(other.converged, plain.converged);
  }
}

TEST(AddedCompliance, IdentityEveryLoadGetsTheSameAccuracy) {
  // lambda = 2 int x^2 dx = 2/3 for a smooth load, together with a weak load with a kink, int |x -
  // 1/3| dx = 5/18.
  const auto k = [](double a) { return smooth_kinked_idle(a, 1e4, 1e-4); };
  const auto added = added_compliance(point_front<3>(k), {.opening = 1.0, .shear = 1.0});
  test::expect_relative(added.matrix(0, 0), 1e8 * 2 / 3, 1e-12);
  test::expect_relative(added.matrix(1, 1), 1e-8 * 5 / 18, 1e-9);
  EXPECT_TRUE(added.converged);
}

TEST(AddedCompliance, LimitIdleCrackAddsNothing) {
  const auto idle = [](double) { return UnitStressIntensity<2>{}; };
  const auto added = added_compliance(point_front<2>(idle), {.opening = 1.0, .shear = 1.0},
                                      {.relative_tolerance = 0.0});
  EXPECT_EQ(added.matrix.upper, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(added.relative_error, 0.0);
  EXPECT_TRUE(added.converged);
}

TEST(AddedCompliance, ConvergenceToleranceIsKept) {
  const CrackModuli moduli{.opening = 1.0, .shear = 1.0};
  const auto crack = point_front<3>([](double a) { return smooth_kinked_idle(a, 0.0, 1.0); });
  double last = 1.0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const auto added = added_compliance(crack, moduli, {.relative_tolerance = tolerance});
    const double error = std::abs(added.matrix(1, 1) / (5.0 / 18) - 1);
    EXPECT_LE(error, tolerance);
    EXPECT_LE(error, std::max(last, 1e-15));
    EXPECT_GE(added.relative_error, error - 1e-15);
    EXPECT_TRUE(added.converged);
    last = error;
  }
}

TEST(AddedCompliance, ConvergenceIsDenied) {
  // A single piece does not resolve the kink, and the result reports it.
  const CrackModuli moduli{.opening = 1.0, .shear = 1.0};
  const auto crack = point_front<3>([](double a) { return smooth_kinked_idle(a, 0.0, 1.0); });
  const auto added = added_compliance(crack, moduli, {.max_pieces = 1});
  EXPECT_FALSE(added.converged);
  EXPECT_GT(added.relative_error, 1e-4);
  EXPECT_LT(added.relative_error, 1e-1);
  const auto with = [&](double factor) {
    return added_compliance(crack, moduli,
                            {.relative_tolerance = added.relative_error * factor, .max_pieces = 1})
        .converged;
  };
  EXPECT_TRUE(with(1.001));
  EXPECT_FALSE(with(0.999));
}

TEST(AddedCompliance, ConvergenceAlongTheFrontCountsToo) {
  // A kink along the front but not in the size is invisible to the outer integral alone.
  struct KinkedFront : Penny {
    [[nodiscard]] UnitStressIntensity<1> stress_intensity(double a, double s) const {
      return {.I = {std::sqrt(a * std::abs(s - 1))}, .II = {}, .III = {}};
    }
  };
  const CrackModuli moduli{.opening = 1.0, .shear = 1.0};
  EXPECT_FALSE(added_compliance(KinkedFront{}, moduli, {.max_pieces = 1}).converged);
  const auto added = added_compliance(KinkedFront{}, moduli);
  EXPECT_TRUE(added.converged);
  const double along = (1 + (2 * pi - 1) * (2 * pi - 1)) / 2;
  test::expect_relative(added.matrix(0, 0), 2 * along / 3, 1e-9);
}

TEST(AddedCompliance, ConvergenceOfSlenderFronts) {
  // a/c = 0.01 bends the front within 1 % of its parameter.
  const double rho = 0.01;
  const double E_k = 1.00027458243066;  // complete elliptic integral of modulus sqrt(1 - 1e-4)
  const auto added =
      added_compliance(EmbeddedEllipse{.depth = 1.0, .aspect_ratio = rho, .elliptic_E = E_k},
                       {.opening = 1.0, .shear = 1.0});
  // int_0^2pi f^2 dphi = 4 E(k), int_0^1 a^2 da = 1/3.
  test::expect_relative(added.matrix(0, 0), 2 * pi / (E_k * rho) * 4 / 3, 1e-9);
}

TEST(AddedCompliance, InputNothingUnlessGiven) {
  const UnitStressIntensity<2> k;
  EXPECT_EQ(k.I, (std::array{0.0, 0.0}));
  EXPECT_EQ(k.II, (std::array{0.0, 0.0}));
  EXPECT_EQ(k.III, (std::array{0.0, 0.0}));
  EXPECT_EQ(CrackModuli{}.opening, 0.0);
  EXPECT_EQ(CrackModuli{}.shear, 0.0);
  EXPECT_EQ(FrontRange{}.begin, 0.0);
  EXPECT_EQ(FrontRange{}.end, 0.0);
  const CrackCompliance<1> nothing;
  EXPECT_EQ(nothing.matrix(0, 0), 0.0);
  EXPECT_EQ(nothing.relative_error, 0.0);
  EXPECT_FALSE(nothing.converged);
}

TEST(AddedCompliance, ScalingPennyIsDisplacementPerStress) {
  // Load: stress.  Energy = 1/2 lambda sigma^2, so lambda is J/Pa^2 = m^3/Pa.
  test::expect_dimensionally_consistent(
      "m^3/Pa",
      [](double a, double E) {
        return added_compliance(Penny{.radius = a}, {.opening = E, .shear = E}).matrix(0, 0);
      },
      Arg{1e-3, "m"}, Arg{2.1e11, "Pa"});
}

}  // namespace
}  // namespace strainwave

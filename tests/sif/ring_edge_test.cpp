// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/member/ring_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::Arg;

/// Strip under an axial force and a bending moment at once, from the two factors.
struct Strip {
  static constexpr std::size_t kLoads = 2;
  double depth = 0.0;
  double thickness = 0.0;
  double width = 0.0;

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<2> stress_intensity(double a, double) const {
    const double area = width * thickness;
    const double root = std::sqrt(pi * a);
    return {.I = {sif::edge_crack_factor(sif::StripLoading::tension, a / thickness) / area * root,
                  sif::edge_crack_factor(sif::StripLoading::bending, a / thickness) * 6 /
                      (area * thickness) * root},
            .II = {},
            .III = {}};
  }
  [[nodiscard]] double swept_area(double, double) const { return width; }
};

sif::EdgeCrack ring(double depth, sif::StripLoading loading = sif::StripLoading::tension) {
  return {.depth = depth,
          .thickness = 10 * mm,
          .width = 20 * mm,
          .unit_stress = 3e3,
          .loading = loading};
}

// --- (FR-11): the factors
// -----------------------------------------------------------------------------

TEST(EdgeCrackFactor, ReferenceTable) {
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    const double alpha = row("depth_ratio");
    if (row.quantity == "F_tension")
      test::expect_row(sif::edge_crack_factor(sif::StripLoading::tension, alpha), row, 1e-14);
    else if (row.quantity == "F_bending")
      test::expect_row(sif::edge_crack_factor(sif::StripLoading::bending, alpha), row, 1e-14);
    else
      continue;
    ++seen[row.quantity];
  }
  EXPECT_GE(seen["F_tension"], 10);
  EXPECT_GE(seen["F_bending"], 10);
}

TEST(EdgeCrackFactor, CrosscheckFiniteElements) {
  // tools/reference/cracked_strip.py, 0.01 <= alpha <= 0.95; 9 of the 22 depths were not used for
  // the fit.  The tolerance is that of the fit, 0.02 %.
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("cracked_strip")) {
    const bool tension = row.quantity == "edge.tension";
    if (!tension && row.quantity != "edge.bending") continue;
    test::expect_relative(
        sif::edge_crack_factor(tension ? sif::StripLoading::tension : sif::StripLoading::bending,
                               row("size_ratio")),
        row.value, 2e-4);
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen["edge.tension"], 22);
  EXPECT_EQ(seen["edge.bending"], 22);
}

TEST(EdgeCrackFactor, CrosscheckIntegralEquation) {
  // tools/reference/weight_function.py: the stress (x/a)^n gives P_n, tension P_0 and bending P_0 -
  // 2 alpha P_1.  The tolerance is 0.02 % up to alpha = 0.9 and 0.1 % beyond.
  std::map<double, std::map<int, double>> power;
  for (const test::CsvRow& row : test::read_reference_csv("weight_function"))
    if (row.quantity == "power")
      power[row("depth_ratio")][static_cast<int>(row("exponent"))] = row.value;
  EXPECT_EQ(power.size(), 9U);
  for (const auto& [alpha, P] : power) {
    const double tolerance = alpha <= 0.9 ? 2e-4 : 1e-3;
    test::expect_relative(sif::edge_crack_factor(sif::StripLoading::tension, alpha), P.at(0),
                          tolerance);
    test::expect_relative(sif::edge_crack_factor(sif::StripLoading::bending, alpha),
                          P.at(0) - 2 * alpha * P.at(1), tolerance);
  }
}

TEST(EdgeCrackFactor, CrosscheckGrossAndSrawley) {
  // The handbook states 0.5 % for these fits to boundary collocation, alpha <= 0.6 (tada2000,
  // secondary); the measured differences are 0.46 % in tension and 0.35 % in bending.
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    if (!row.quantity.ends_with("_gross_srawley")) continue;
    const bool tension = row.quantity.starts_with("F_tension");
    test::expect_relative(
        sif::edge_crack_factor(tension ? sif::StripLoading::tension : sif::StripLoading::bending,
                               row("depth_ratio")),
        row.value, 5e-3);
    ++n;
  }
  EXPECT_EQ(n, 16);
}

TEST(EdgeCrackFactor, CrosscheckTadaAsRecalled) {
  // Another handbook form, with a stated accuracy of 0.5 % for every depth (tada2000, secondary:
  // from memory),
  // agrees within 0.67 % in tension but is 2.34 % low in bending at alpha = 0.3; the library does
  // not use it.
  double lowest = 1.0;
  for (double alpha = 0.01; alpha < 0.955; alpha += 0.01) {
    const double u = pi * alpha / 2;
    const double root = std::sqrt(std::tan(u) / u) / std::cos(u);
    const double q = 1 - std::sin(u);
    const double tension = root * (0.752 + 2.02 * alpha + 0.37 * std::pow(q, 3));
    const double bending = root * (0.923 + 0.199 * std::pow(q, 4));
    EXPECT_NEAR(tension / sif::edge_crack_factor(sif::StripLoading::tension, alpha), 1, 0.007)
        << alpha;
    const double ratio = bending / sif::edge_crack_factor(sif::StripLoading::bending, alpha);
    EXPECT_LT(ratio, 1.002) << alpha;
    lowest = std::min(lowest, ratio);
  }
  EXPECT_NEAR(lowest, 1 - 0.0234, 2e-4);
}

TEST(EdgeCrackFactor, LimitHalfPlane) {
  // The limit is Koiter's 1.1215222552 for the half plane, in tension and in bending, of which four
  // decimals are used.
  for (const sif::StripLoading loading : {sif::StripLoading::tension, sif::StripLoading::bending}) {
    EXPECT_NEAR(sif::edge_crack_factor(loading, 0), 1.1215222552, 3e-5);
    EXPECT_NEAR(sif::edge_crack_factor(loading, 1e-12), 1.1215222552, 3e-5);
  }
}

TEST(EdgeCrackFactor, LimitDeepLigament) {
  // The ligament b = t - a bends: K = 3.975 M/(B b^(3/2)), with M the moment about the ligament,
  // that is N t/2 in tension.  The tolerance is the last digit and the next term of order 1 -
  // alpha.
  const double alpha = 1 - 1e-6;
  const double scale = std::pow(1 - alpha, 1.5) * std::sqrt(pi);
  EXPECT_NEAR(sif::edge_crack_factor(sif::StripLoading::tension, alpha) * scale / (3.975 / 2), 1,
              3e-4);
  EXPECT_NEAR(sif::edge_crack_factor(sif::StripLoading::bending, alpha) * scale / (3.975 / 6), 1,
              3e-4);
}

TEST(EdgeCrackFactor, IdentityTensionIsMoreSevereThanBending) {
  for (double alpha = 0.05; alpha < 1; alpha += 0.05)
    EXPECT_GT(sif::edge_crack_factor(sif::StripLoading::tension, alpha),
              sif::edge_crack_factor(sif::StripLoading::bending, alpha));
}

// --- the crack through the width of a ring
// ----------------------------------------------------------------

TEST(EdgeCrack, ReferenceComplianceTable) {
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    if (row.quantity.find("_compliance") == std::string::npos) continue;
    const double t = row("thickness");
    const double B = row("width");
    const double a = row("depth_ratio") * t;
    const double nu = row("poissons_ratio");
    const CrackModuli moduli{.opening = row("youngs_modulus") / (1 - nu * nu), .shear = 80 * GPa};
    double actual = 0.0;
    if (row.quantity.starts_with("coupling")) {
      const Strip strip{.depth = a, .thickness = t, .width = B};
      actual = added_compliance(strip, moduli).matrix(0, 1);
    } else {
      const bool axial = row.quantity.starts_with("axial");
      const sif::EdgeCrack crack{
          .depth = a,
          .thickness = t,
          .width = B,
          .unit_stress = axial ? 1 / (B * t) : 6 / (B * t * t),
          .loading = axial ? sif::StripLoading::tension : sif::StripLoading::bending};
      actual = added_compliance(crack, moduli).matrix(0, 0);
    }
    // With the same polynomials, the tolerance is that of the engine.  With the factors of the
    // finite elements, it is twice the 0.02 % of K.
    if (row.quantity.ends_with("_by_elements"))
      test::expect_relative(actual, row.value, 4e-4);
    else
      test::expect_row(actual, row, 1e-10);
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 6U);
  for (const auto& [quantity, n] : seen) EXPECT_GE(n, 8) << quantity;
}

TEST(EdgeCrack, IdentityStressIntensity) {
  const sif::EdgeCrack crack = ring(4 * mm, sif::StripLoading::bending);
  test::expect_relative(
      crack.stress_intensity(3 * mm, 0).I[0],
      sif::edge_crack_factor(sif::StripLoading::bending, 0.3) * 3e3 * std::sqrt(pi * 3 * mm),
      1e-15);
  EXPECT_EQ(crack.stress_intensity(3 * mm, 0).II[0], 0.0);
  EXPECT_EQ(crack.stress_intensity(3 * mm, 0).III[0], 0.0);
  EXPECT_EQ(crack.size(), 4 * mm);
  EXPECT_EQ(crack.front().begin, crack.front().end);
  EXPECT_EQ(crack.swept_area(0.1, 0.2), crack.width);
}

TEST(EdgeCrack, IdentityClosedFacesAddNothing) {  // (FR-17)
  sif::EdgeCrack crack = ring(4 * mm);
  crack.open = false;
  EXPECT_EQ(crack.stress_intensity(4 * mm, 0).I[0], 0.0);
  EXPECT_EQ(added_compliance(crack, {.opening = 1.0, .shear = 1.0}).matrix(0, 0), 0.0);
}

TEST(EdgeCrack, LimitShallowIsAQuarterOfASquare) {
  // lambda -> (2/E') B (1.1215 s)^2 pi a^2/2; the first correction is linear in a/t.
  const CrackModuli moduli{.opening = 7.0, .shear = 1.0};
  for (const double alpha : {1e-6, 1e-3}) {
    const sif::EdgeCrack crack = ring(alpha * 10 * mm);
    const double limit = pi / 7 * crack.width * std::pow(1.1215 * 3e3 * crack.depth, 2);
    EXPECT_NEAR(added_compliance(crack, moduli).matrix(0, 0) / limit, 1, 3 * alpha);
  }
}

TEST(EdgeCrack, ScalingComplianceOfARing) {
  for (const sif::StripLoading loading : {sif::StripLoading::tension, sif::StripLoading::bending})
    test::expect_dimensionally_consistent(
        "m/N",
        [=](double a, double t, double B, double stress, double E) {
          const sif::EdgeCrack crack{
              .depth = a, .thickness = t, .width = B, .unit_stress = stress, .loading = loading};
          return added_compliance(crack, {.opening = E, .shear = E}).matrix(0, 0);
        },
        Arg{2e-3, "m"}, Arg{1e-2, "m"}, Arg{2e-2, "m"}, Arg{4e3, "1/m^2"}, Arg{2.3e11, "Pa"});
}

TEST(EdgeCrack, InputDefaults) {
  const sif::EdgeCrack crack;
  EXPECT_EQ(crack.depth, 0.0);
  EXPECT_EQ(crack.thickness, 0.0);
  EXPECT_EQ(crack.width, 0.0);
  EXPECT_EQ(crack.unit_stress, 0.0);
  EXPECT_EQ(crack.loading, sif::StripLoading::tension);
  EXPECT_TRUE(crack.open);
}

}  // namespace
}  // namespace strainwave

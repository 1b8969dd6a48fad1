// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/edge_crack.hpp"

#include <gtest/gtest.h>

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

/// Strip under an axial force and a bending moment at once, made of the two factors.
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
    return {.I = {edge_crack_factor(StripLoading::tension, a / thickness) / area * root,
                  edge_crack_factor(StripLoading::bending, a / thickness) * 6 / (area * thickness) *
                      root},
            .II = {},
            .III = {}};
  }
  [[nodiscard]] double swept_area(double, double) const { return width; }
};

EdgeCrack ring(double depth, StripLoading loading = StripLoading::tension) {
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
      test::expect_row(edge_crack_factor(StripLoading::tension, alpha), row, 1e-14);
    else if (row.quantity == "F_bending")
      test::expect_row(edge_crack_factor(StripLoading::bending, alpha), row, 1e-14);
    else
      continue;
    ++seen[row.quantity];
  }
  EXPECT_GE(seen["F_tension"], 10);
  EXPECT_GE(seen["F_bending"], 10);
}

TEST(EdgeCrackFactor, CrosscheckGrossAndSrawley) {
  // Another handbook fit of the same strip, stated to 0.5 % like this one, for alpha <= 0.6.
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    if (row.quantity != "F_tension_gross_srawley") continue;
    EXPECT_NEAR(edge_crack_factor(StripLoading::tension, row("depth_ratio")) / row.value, 1, 0.012)
        << row.place;
    ++n;
  }
  EXPECT_EQ(n, 8);
}

TEST(EdgeCrackFactor, LimitHalfPlane) {
  // 1.1215 of the half plane, in tension and in bending; the fit has 1.122.
  for (const StripLoading loading : {StripLoading::tension, StripLoading::bending}) {
    EXPECT_DOUBLE_EQ(edge_crack_factor(loading, 0), 1.122);
    EXPECT_NEAR(edge_crack_factor(loading, 0), 1.1215, 0.001);
    EXPECT_NEAR(edge_crack_factor(loading, 1e-12), 1.122, 1e-10);
  }
}

TEST(EdgeCrackFactor, LimitDeepLigament) {
  // The ligament b = t - a bends: K = 3.975 M/(B b^(3/2)), with M the moment about the ligament,
  // that is N t/2 in tension.  Tolerance: the 0.5 % of the fit.
  const double alpha = 1 - 1e-5;
  const double scale = std::pow(1 - alpha, 1.5) * std::sqrt(pi);
  EXPECT_NEAR(edge_crack_factor(StripLoading::tension, alpha) * scale / (3.975 / 2), 1, 0.005);
  EXPECT_NEAR(edge_crack_factor(StripLoading::bending, alpha) * scale / (3.975 / 6), 1, 0.005);
}

TEST(EdgeCrackFactor, IdentityTensionIsMoreSevereThanBending) {
  for (double alpha = 0.05; alpha < 1; alpha += 0.05)
    EXPECT_GT(edge_crack_factor(StripLoading::tension, alpha),
              edge_crack_factor(StripLoading::bending, alpha));
}

// --- the crack through the width of a ring
// ----------------------------------------------------------------

TEST(EdgeCrack, ReferenceComplianceTable) {
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("edge_crack")) {
    if (!row.quantity.ends_with("_compliance")) continue;
    const double t = row("thickness");
    const double B = row("width");
    const double a = row("depth_ratio") * t;
    const double nu = row("poissons_ratio");
    const CrackModuli moduli{.opening = row("youngs_modulus") / (1 - nu * nu), .shear = 80 * GPa};
    double actual = 0.0;
    if (row.quantity == "coupling_compliance") {
      const Strip strip{.depth = a, .thickness = t, .width = B};
      actual = added_compliance(strip, moduli).matrix(0, 1);
    } else {
      const bool axial = row.quantity == "axial_compliance";
      const EdgeCrack crack{.depth = a,
                            .thickness = t,
                            .width = B,
                            .unit_stress = axial ? 1 / (B * t) : 6 / (B * t * t),
                            .loading = axial ? StripLoading::tension : StripLoading::bending};
      actual = added_compliance(crack, moduli).matrix(0, 0);
    }
    test::expect_row(actual, row, 1e-10);  // tolerance of the engine
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 3U);
  for (const auto& [quantity, n] : seen) EXPECT_GE(n, 9) << quantity;
}

TEST(EdgeCrack, IdentityStressIntensity) {
  const EdgeCrack crack = ring(4 * mm, StripLoading::bending);
  test::expect_relative(
      crack.stress_intensity(3 * mm, 0).I[0],
      edge_crack_factor(StripLoading::bending, 0.3) * 3e3 * std::sqrt(pi * 3 * mm), 1e-15);
  EXPECT_EQ(crack.stress_intensity(3 * mm, 0).II[0], 0.0);
  EXPECT_EQ(crack.stress_intensity(3 * mm, 0).III[0], 0.0);
  EXPECT_EQ(crack.size(), 4 * mm);
  EXPECT_EQ(crack.front().begin, crack.front().end);
  EXPECT_EQ(crack.swept_area(0.1, 0.2), crack.width);
}

TEST(EdgeCrack, IdentityClosedFacesAddNothing) {  // (FR-17)
  EdgeCrack crack = ring(4 * mm);
  crack.open = false;
  EXPECT_EQ(crack.stress_intensity(4 * mm, 0).I[0], 0.0);
  EXPECT_EQ(added_compliance(crack, {.opening = 1.0, .shear = 1.0}).matrix(0, 0), 0.0);
}

TEST(EdgeCrack, LimitShallowIsAQuarterOfASquare) {
  // lambda -> (2/E') B (1.122 s)^2 pi a^2/2; the first correction is linear in a/t.
  const CrackModuli moduli{.opening = 7.0, .shear = 1.0};
  for (const double alpha : {1e-6, 1e-3}) {
    const EdgeCrack crack = ring(alpha * 10 * mm);
    const double limit = pi / 7 * crack.width * std::pow(1.122 * 3e3 * crack.depth, 2);
    EXPECT_NEAR(added_compliance(crack, moduli).matrix(0, 0) / limit, 1, 3 * alpha);
  }
}

TEST(EdgeCrack, ScalingComplianceOfARing) {
  for (const StripLoading loading : {StripLoading::tension, StripLoading::bending})
    test::expect_dimensionally_consistent(
        "m/N",
        [=](double a, double t, double B, double stress, double E) {
          const EdgeCrack crack{
              .depth = a, .thickness = t, .width = B, .unit_stress = stress, .loading = loading};
          return added_compliance(crack, {.opening = E, .shear = E}).matrix(0, 0);
        },
        Arg{2e-3, "m"}, Arg{1e-2, "m"}, Arg{2e-2, "m"}, Arg{4e3, "1/m^2"}, Arg{2.3e11, "Pa"});
}

TEST(EdgeCrack, InputDefaults) {
  const EdgeCrack crack;
  EXPECT_EQ(crack.depth, 0.0);
  EXPECT_EQ(crack.thickness, 0.0);
  EXPECT_EQ(crack.width, 0.0);
  EXPECT_EQ(crack.unit_stress, 0.0);
  EXPECT_EQ(crack.loading, StripLoading::tension);
  EXPECT_TRUE(crack.open);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0 Annular cracks: finite elements against the closed forms and
// tables of the fracture module, which are independent.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "strainwave/gear_fem/shaft_section.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using fem::SectionLoad;
using gear_fem::ShaftCrack;
using gear_fem::ShaftSection;
using std::numbers::pi;

constexpr fem::Elasticity kSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

/// A shaft of outer radius 1, long enough that the ends do not matter.
ShaftSection unit_shaft(double radius_ratio, double depth) {
  return {
      .outer_diameter = 2,
      .inner_diameter = 2 * radius_ratio,
      .length = 8,
      .crack = ShaftCrack{.surface = ShaftCrack::Surface::outer, .depth = depth, .position = 4}};
}

fem::TipResult tip(const ShaftSection& shaft, SectionLoad load, double nu = 0.3) {
  return *fem::solve_section(gear_fem::mesh_shaft(shaft), load, {210e9, nu}).tip;
}

// Measured ratios for the handbook polynomials and for our own fits (FR-12, FR-13).
TEST(FeAnnular, CrosscheckSolidShaft) {
  struct Row {
    double x, III_over_tada, I_over_tada;
  };
  // Net over gross diameter; finite elements over Tada by an independent program, four digits.
  for (const Row& row : {Row{0.3, 0.9996, 1.0071}, Row{0.5, 0.9963, 1.0199},
                         Row{0.7, 0.9872, 1.0295}, Row{0.9, 0.9824, 1.0245}}) {
    const ShaftSection shaft = unit_shaft(0, 1 - row.x);
    const double III = tip(shaft, SectionLoad::torsion).K_III;
    const double I = tip(shaft, SectionLoad::tension).K_I;
    const auto of = [&](sif::AnnularPolynomials which) {
      const sif::AnnularCrackSolid crack{.depth = 1 - row.x, .diameter = 2, .polynomials = which};
      return crack.stress_intensity(1 - row.x, 0);
    };
    const auto tada = of(sif::AnnularPolynomials::tada);
    EXPECT_NEAR(III / tada.III[kTorsion], row.III_over_tada, 1.5e-4) << row.x;
    EXPECT_NEAR(I / tada.I[kAxial], row.I_over_tada, 1.5e-4) << row.x;
    const auto improved = of(sif::AnnularPolynomials::improved);
    EXPECT_NEAR(III / improved.III[kTorsion], 1, 3e-4) << row.x;  // the stated accuracy
    EXPECT_NEAR(I / improved.I[kAxial], 1, 6e-4) << row.x;
  }
}

TEST(FeAnnular, CrosscheckHollowShaft) {
  for (const double ratio : {0.3, 0.643, 0.9})
    for (const double alpha : {0.1, 0.4, 0.7}) {
      const double a = alpha * (1 - ratio);
      const sif::AnnularCrackHollow crack({.depth = a, .outer_radius = 1, .inner_radius = ratio});
      const auto k = crack.stress_intensity(a, 0);
      const ShaftSection shaft = unit_shaft(ratio, a);
      EXPECT_NEAR(tip(shaft, SectionLoad::torsion).K_III / k.III[kTorsion], 1, 1e-3)
          << ratio << ' ' << alpha;
      EXPECT_NEAR(tip(shaft, SectionLoad::tension).K_I / k.I[kAxial], 1, 3e-3)
          << ratio << ' ' << alpha;
    }
}

// The added compliance in torsion against dual series, which are exact to 1e-6: tests/data.
TEST(FeAnnular, CrosscheckDualSeries) {
  int seen = 0;
  for (const auto& row : test::read_reference_csv("annular_hollow_torsion")) {
    if (row.quantity != "C_T") continue;
    const double ratio = row("radius_ratio");
    const double alpha = row("depth_ratio");
    if (std::abs(alpha - 0.25) > 1e-9 && std::abs(alpha - 0.55) > 1e-9) continue;
    if (std::abs(ratio - 0.1) > 1e-9 && std::abs(ratio - 0.55) > 1e-9) continue;
    const double wall = 1 - ratio;
    const auto r = gear_fem::solve_shaft(unit_shaft(ratio, alpha * wall), kSteel).torsion;
    const double J = pi / 2 * (1 - std::pow(ratio, 4));
    const double unit =
        4 * wall / pi * -std::log(std::cos(pi * alpha / 2)) / (kSteel.shear_modulus() * J);
    // The elements are accurate to 1e-4; the five depths of the integral add 1.5e-4 for the deepest
    // crack of the thickest wall (measured).
    EXPECT_NEAR(r.added_by_difference / unit / row.value, 1, 1e-4) << ratio << ' ' << alpha;
    EXPECT_NEAR(r.added_compliance / unit / row.value, 1, 2e-4) << ratio << ' ' << alpha;
    EXPECT_TRUE(r.usable) << r.reason;
    EXPECT_NEAR(r.growth_check, 0, 2e-5);  // Simpson's rule over a tenth of a tip cell
    ++seen;
  }
  EXPECT_EQ(seen, 4);
}

// A deep crack, whose energy release rate rises steeply: two points of
// tests/data/judgement_annular.csv calculated anew, and the closed form (FR-12).
TEST(FeAnnular, CrosscheckDeepCrackAndCommittedRow) {
  const double a = 0.8;
  const auto r = gear_fem::solve_shaft(unit_shaft(0, a), kSteel).torsion;
  EXPECT_TRUE(r.usable) << r.reason;
  const double mu = kSteel.shear_modulus();
  const sif::AnnularCrackSolid crack{.depth = a, .diameter = 2};
  const double closed =
      added_compliance(crack, {.opening = kSteel.youngs_modulus, .shear = mu}).matrix(1, 1);
  EXPECT_NEAR(r.added_compliance / closed, 1, 1e-3);
  const double shallow = pi * pi * a * a / (mu * std::pow(pi / 2, 2));
  int seen = 0;
  for (const auto& row : test::read_reference_csv("judgement_annular")) {
    if (row("radius_ratio") != 0 || row("depth_ratio") != a || row("poissons_ratio") != 0.3)
      continue;
    if (row.quantity == "C_T") {
      EXPECT_NEAR(r.added_compliance / shallow / row.value, 1, 1e-4);
    } else if (row.quantity == "K_III") {
      EXPECT_NEAR(r.tip.K_III / (std::sqrt(pi * a) / (pi / 2)) / row.value, 1, 1e-4);
    }
    ++seen;
  }
  EXPECT_EQ(seen, 4);
}

}  // namespace
}  // namespace strainwave

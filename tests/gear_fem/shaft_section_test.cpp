// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/shaft_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "strainwave/core/error.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;
using Surface = ShaftCrack::Surface;

constexpr fem::Elasticity kShaftSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

/// The article's shaft, 70/45 mm and 200 mm long, with a crack at half length.
ShaftSection article_shaft(double depth, Surface surface = Surface::outer) {
  return {.outer_diameter = 0.07,
          .inner_diameter = 0.045,
          .length = 0.2,
          .crack = ShaftCrack{.surface = surface, .depth = depth, .position = 0.1}};
}

double polar() { return pi / 2 * (std::pow(0.035, 4) - std::pow(0.0225, 4)); }
double area() { return pi * (0.035 * 0.035 - 0.0225 * 0.0225); }

struct Row {
  double depth, added, III, I;
};
// An independent program of finite elements (p = 8, other meshes; agrees with two further programs
// in the given digits): rad/(N*m), K_III/(tau_s sqrt(pi a)), K_I/(sigma sqrt(pi a)).
constexpr std::array<Row, 4> kHollow = {{{0.1e-3, 1.3713e-11, 1.0015, 1.1237},
                                         {1e-3, 1.3789e-9, 1.0200, 1.1548},
                                         {4e-3, 2.3616e-8, 1.1406, 1.3589},
                                         {8e-3, 1.1869e-7, 1.5349, 1.8863}}};
constexpr double kPrinted = 1e-4;  // five printed digits, and the discretisation of both programs

// (FE-6, FE-7, FE-8, FE-9)
TEST(SolveShaft, ReferenceHollowShaft) {
  for (const Row& row : kHollow) {
    const ShaftCrackResult r = solve_shaft(article_shaft(row.depth), kShaftSteel);
    const double root = std::sqrt(pi * row.depth);
    EXPECT_NEAR(r.torsion.added_compliance / row.added, 1, kPrinted) << row.depth;
    EXPECT_NEAR(r.torsion.tip.K_III / (0.035 / polar() * root) / row.III, 1, kPrinted) << row.depth;
    EXPECT_NEAR(r.tension.tip.K_I * area() / root / row.I, 1, kPrinted) << row.depth;
    EXPECT_NEAR(r.torsion.sound_compliance * kShaftSteel.shear_modulus() * polar() / 0.2, 1, 1e-9);
    EXPECT_NEAR(r.tension.sound_compliance * kShaftSteel.youngs_modulus * area() / 0.2, 1, 1e-9);
    for (const auto* const load : r.loads()) {
      EXPECT_TRUE(load->usable) << load->reason;
      EXPECT_TRUE(load->reason.empty());
      EXPECT_NEAR(load->growth_check, 0, 1e-5) << row.depth;
      if (row.depth >= 1e-3) {  // two computations of the same value: int 2G dA, and subtraction
        EXPECT_NEAR(load->added_by_difference / load->added_compliance, 1, 2e-4) << row.depth;
      }
      EXPECT_LT(std::abs(load->energy_balance), 1e-7);  // rounding
      EXPECT_LT(load->equilibrium_residual, 1e-7);
      EXPECT_GT(load->dofs, 1000U);
      // All cells are rectangles except those next to a moved tip, which are a tenth narrower on
      // one side.
      EXPECT_GT(load->worst_jacobian, 0.9 / 0.95);
      EXPECT_LT(load->worst_jacobian, 0.96);
    }
  }
}

// Cracks from the bore, by a program of Fourier elements.
TEST(SolveShaft, CrosscheckInnerCrack) {
  int seen = 0;
  for (const auto& row : test::read_reference_csv("annular_fourier")) {
    if (row.quantity != "inner.torsion" && row.quantity != "inner.tension") continue;
    const double ratio = row("radius_ratio");
    const double depth_ratio = row("depth_ratio");
    if (depth_ratio < 0.2 || depth_ratio > 0.6) continue;
    const double wall = 1 - ratio;
    const double a = depth_ratio * wall;
    const ShaftSection shaft{
        .outer_diameter = 2,
        .inner_diameter = 2 * ratio,
        .length = 8,
        .crack = ShaftCrack{.surface = Surface::inner, .depth = a, .position = 4}};
    const bool torsion = row.quantity == "inner.torsion";
    const auto tip =
        *fem::solve_section(mesh_shaft(shaft),
                            torsion ? fem::SectionLoad::torsion : fem::SectionLoad::tension,
                            kShaftSteel)
             .tip;
    const double J = pi / 2 * (1 - std::pow(ratio, 4));
    // The nominal stress is that at the front, (SB-5).
    const double nominal = torsion ? (ratio + a) / J : 1 / (pi * (1 - ratio * ratio));
    const double K = torsion ? tip.K_III : tip.K_I;
    EXPECT_NEAR(K / (nominal * std::sqrt(pi * a)) / row.value, 1, 3e-3)
        << row.quantity << ' ' << ratio << ' ' << depth_ratio;
    ++seen;
  }
  EXPECT_GT(seen, 5);
}

TEST(SolveShaft, LimitShallowCrackIsThatOfHalfPlane) {
  const ShaftCrackResult r = solve_shaft(article_shaft(5e-5), kShaftSteel);
  const double root = std::sqrt(pi * 5e-5);
  EXPECT_NEAR(r.torsion.tip.K_III / (0.035 / polar() * root), 1, 2e-3);
  EXPECT_NEAR(r.tension.tip.K_I * area() / root, 1.1215, 1.1215 * 3e-3);
}

TEST(SolveShaft, LimitShoulderFarAwayDoesNotMatter) {
  ShaftSection stepped = article_shaft(4e-3);
  stepped.length = 0.3;
  stepped.shoulder = ShaftShoulder{.position = 0.22, .outer_diameter = 0.1, .fillet_radius = 3e-3};
  const ShaftCrackResult plain = solve_shaft(article_shaft(4e-3), kShaftSteel);
  const ShaftCrackResult far = solve_shaft(stepped, kShaftSteel);
  EXPECT_NEAR(far.torsion.tip.K_III / plain.torsion.tip.K_III, 1, 2e-4);
  EXPECT_NEAR(far.tension.tip.K_I / plain.tension.tip.K_I, 1, 2e-3);
  EXPECT_NEAR(far.tension.tip.K_II / far.tension.tip.K_I, 0, 2e-3);
  EXPECT_TRUE(far.torsion.usable) << far.torsion.reason;
  EXPECT_TRUE(far.tension.usable) << far.tension.reason;
}

TEST(SolveShaft, LimitCrackAtShoulderHasModeTwo) {
  ShaftSection stepped = article_shaft(2e-3);
  stepped.shoulder = ShaftShoulder{.position = 0.108, .outer_diameter = 0.1, .fillet_radius = 2e-3};
  const ShaftCrackResult r = solve_shaft(stepped, kShaftSteel);
  EXPECT_GT(std::abs(r.tension.tip.K_II / r.tension.tip.K_I), 0.005);
  EXPECT_TRUE(r.tension.usable) << r.tension.reason;
  const ShaftCrackResult plain = solve_shaft(article_shaft(2e-3), kShaftSteel);
  EXPECT_GT(r.tension.tip.K_I, 0.7 * plain.tension.tip.K_I);
  EXPECT_LT(r.tension.tip.K_I, 1.6 * plain.tension.tip.K_I);
}

TEST(SolveShaft, IdentityFilletStiffensASharpCorner) {
  ShaftSection stepped{.outer_diameter = 0.06,
                       .inner_diameter = 0,
                       .length = 0.2,
                       .shoulder = ShaftShoulder{0.1, 0.1, 0}};
  const auto compliance = [&](double radius, int order) {
    stepped.shoulder->fillet_radius = radius;
    return fem::solve_section(mesh_shaft(stepped), fem::SectionLoad::torsion, kShaftSteel,
                              {.order = order})
        .compliance;
  };
  const double sharp = compliance(0, 6);
  EXPECT_NEAR(compliance(0, 8) / sharp, 1, 3e-6);
  EXPECT_LT(compliance(4e-3, 6), sharp);
  EXPECT_NEAR(compliance(4e-3, 8) / compliance(4e-3, 6), 1, 3e-6);
  // The compliance lies between those of the two diameters, and above their sum, because the corner
  // is soft.
  const auto bar = [](double d) {
    return 0.1 / (kShaftSteel.shear_modulus() * pi / 32 * std::pow(d, 4));
  };
  EXPECT_GT(sharp, bar(0.06) + bar(0.1));
  EXPECT_LT(sharp, 1.1 * (bar(0.06) + bar(0.1)));
}

TEST(SolveShaft, IdentityNotUsableHasAReason) {
  // Order 2 with few rings cannot give the displacement of the faces to 2 %.
  const ShaftCrackResult r =
      solve_shaft(article_shaft(11e-3), kShaftSteel, {.order = 2, .tip_rings = 4});
  EXPECT_FALSE(r.tension.usable);
  EXPECT_FALSE(r.tension.reason.empty());
}

TEST(ShaftSection, IdentityFromTheModel) {
  OutputShaft model{.material = "steel",
                    .outer_diameter = 0.07,
                    .inner_diameter = 0.045,
                    .length = 0.2,
                    .crack = {AnnularCrack{.depth = 1e-3}, AnnularCrack{.depth = 3e-3}}};
  const ShaftSection second = shaft_section(model, 1);
  EXPECT_EQ(second.outer_diameter, 0.07);
  EXPECT_EQ(second.inner_diameter, 0.045);
  EXPECT_EQ(second.length, 0.2);
  EXPECT_EQ(second.crack->depth, 3e-3);
  EXPECT_EQ(second.crack->position, 0.1);
  EXPECT_THROW((void)shaft_section(model, 2), std::out_of_range);
}

TEST(MeshShaft, InputEveryRuleBrokenOnce) {
  const std::array<std::function<void(ShaftSection&)>, 15> broken = {{
      [](auto& s) { s.outer_diameter = 0; },
      [](auto& s) { s.inner_diameter = -1e-3; },
      [](auto& s) { s.inner_diameter = 0.07; },
      [](auto& s) { s.length = 0; },
      [](auto& s) { s.crack->depth = 0; },
      [](auto& s) { s.crack->depth = 0.0126; },
      [](auto& s) { s.crack->position = 0; },
      [](auto& s) { s.crack->position = 0.2; },
      [](auto& s) { s.inner_diameter = 0, s.crack->surface = Surface::inner; },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0, 0.1, 0};
      },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0.2, 0.1, 0};
      },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0.15, 0.07, 0};
      },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0.15, 0.1, -1e-3};
      },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0.15, 0.1, 8e-3};
      },
      [](auto& s) {
        s.shoulder = ShaftShoulder{0.102, 0.1, 1e-3};
      },
  }};
  for (const auto& change : broken) {
    ShaftSection shaft = article_shaft(4e-3);
    EXPECT_NO_THROW((void)mesh_shaft(shaft));
    change(shaft);
    EXPECT_THROW((void)mesh_shaft(shaft), InputError);
  }
  ShaftSection sound = article_shaft(4e-3);
  sound.crack.reset();
  EXPECT_THROW((void)solve_shaft(sound, kShaftSteel), InputError);
}

}  // namespace
}  // namespace strainwave::gear_fem

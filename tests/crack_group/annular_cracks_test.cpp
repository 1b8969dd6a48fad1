// SPDX-License-Identifier: Apache-2.0
// Annular cracks of a shaft in torsion: one crack, pairs by finite elements, a sheet, energy,
// rules.
#include "strainwave/crack_group/annular_cracks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/crack_group/straight_cracks.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Cracks = std::vector<PlacedAnnularCrack>;

// Kind: reference (CG-10), (CG-12).  One crack of a solid shaft against (FR-12), which is fitted to
// finite elements, and of a hollow one against the table of (FR-14), which is a dual series.
// Tolerance: 0.1 % of the rotation, which is the accuracy of those fits and of the jump.
TEST(AnnularCracks, ReferenceOneCrack) {
  for (const double depth : {0.02, 0.1, 0.3, 0.5, 0.7}) {
    const GroupedAnnularCrack crack = annular_group(Cracks{{0, depth}}, {1, 0}).cracks[0];
    const sif::AnnularCrackSolid fitted{.depth = depth, .diameter = 2};
    // (FR-2) with G = 1: the rotation is the integral of K_III^2 over the swept area.
    const double swept = boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double a) {
          const double K = fitted.stress_intensity(a, 0).III[1];
          return K * K * fitted.swept_area(a, 0);
        },
        0.0, depth);
    test::expect_relative(crack.rotation, swept, 1e-3);
    EXPECT_EQ(crack.factor, 1);
    EXPECT_EQ(crack.compliance, 1);
  }
  for (const double inner : {0.3, 0.6, 0.9})
    for (const double share : {0.05, 0.4, 0.8}) {
      const double wall = 1 - inner;
      const GroupedAnnularCrack crack =
          annular_group(Cracks{{0, share * wall}}, {1, inner}).cracks[0];
      const sif::AnnularCrackHollow tabulated(
          {.depth = share * wall, .outer_radius = 1, .inner_radius = inner});
      const double polar = pi / 2 * (1 - std::pow(inner, 4));
      const double strip = -4 * wall / (pi * polar) * std::log(std::cos(pi * share / 2));
      test::expect_relative(crack.rotation, strip * tabulated.torsion_factor(share), 1e-3);
    }
}

// Kind: crosscheck (CG-11), (CG-12).  Pairs and a triple by finite elements, solid and hollow, deep
// and shallow, equal and unequal: rotation and K.  Tolerance: 0.15 %, the error of these elements.
TEST(AnnularCracks, CrosscheckFiniteElements) {
  for (const test::CsvRow& row : test::read_reference_csv("annular_cracks")) {
    Cracks cracks;
    for (const std::string j : {"0", "1", "2"})
      if (row.inputs.contains("place_" + j))
        cracks.push_back({row("place_" + j), row("depth_" + j)});
    const auto which = static_cast<std::size_t>(row.quantity.back() - '0');
    const AnnularGroup group = annular_group(cracks, {1, row("inner")});
    const GroupedAnnularCrack& crack = group.cracks[which];
    EXPECT_NEAR(row.quantity.starts_with("rotation") ? crack.compliance : crack.factor, row.value,
                1.5e-3)
        << row.place;
  }
}

// Kind: behaviour (CG-12).  The modes fade out, so the ratios have no step where a deeper crack
// needs fewer of them: third differences over that depth are those of a smooth function. Tolerance:
// 2e-9 for steps of 0.1 %; a sum that ends at once has a step of 1e-4.
TEST(AnnularCracks, BehaviourNoStepWhereTheNumberOfModesChanges) {
  const auto factor = [](double depth) {
    return annular_group(Cracks{{0, depth}, {0.05, depth}}, {1, 0}).cracks[0].factor;
  };
  // 112/(pi a) = 512 modes.
  const double depth = 112 / (pi * 512);
  const Cracks below{{0, 0.9999 * depth}};
  const Cracks above{{0, 1.0001 * depth}};
  EXPECT_NE(annular_modes(below, {1, 0}), annular_modes(above, {1, 0}));
  const double step = 1e-3 * depth;
  const double third = factor(depth + 1.5 * step) - 3 * factor(depth + 0.5 * step) +
                       3 * factor(depth - 0.5 * step) - factor(depth - 1.5 * step);
  EXPECT_LT(std::abs(third), 2e-9);
}

// Kind: reference (CG-13).  The sums over a few modes are those over all of them, each found by
// itself: solid, hollow and with a small bore.  Source: tools/reference/annular_modes.py.
// Tolerance: 1e-8, what ten functions change by rounding, and Hankel's series.
TEST(AnnularCracks, ReferenceAllModesOneByOne) {
  for (const test::CsvRow& row : test::read_reference_csv("annular_modes")) {
    const Cracks cracks{{row("place_0"), row("depth_0")}, {row("place_1"), row("depth_1")}};
    const auto which = static_cast<std::size_t>(row.quantity.back() - '0');
    const GroupedAnnularCrack crack = annular_group(cracks, {1, row("inner")}).cracks[which];
    test::expect_relative(row.quantity.starts_with("rotation") ? crack.rotation : crack.factor,
                          row.value, 1e-8);
  }
}

// Kind: limit (CG-12).  The last mode of a crack fades to 0 and never below it, where rounding
// would make its root not a number.  The depths put mode n just before the end, k a = 112.
TEST(AnnularCracks, LimitOfTheLastMode) {
  for (const int n : {60, 61, 90, 200})
    for (const double before : {0.0, 1e-9, 1e-7, 3e-7, 1e-6, 2e-6, 3e-6, 1e-5}) {
      const double k = boost::math::cyl_bessel_j_zero(2.0, n);
      const double depth = 112 * (1 - before) / k;
      const AnnularGroup group = annular_group(Cracks{{0, depth}, {depth, depth / 2}}, {1, 0});
      EXPECT_GT(group.cracks[0].factor, 0.5) << n << ", " << before;  // false for NaN too
      EXPECT_LT(group.cracks[0].factor, 1.0) << n << ", " << before;
    }
  // A depth at which the answer was not a number.
  EXPECT_GT(annular_group(Cracks{{0, 0.55061482988319}}, {1, 0}).cracks[0].rotation, 0);
}

// Kind: limit (CG-11).  Shallow cracks of a large shaft are cracks out of the plane of a sheet,
// twice as long, since the surface is a mirror.  Tolerance: depth over radius, and the error of the
// jump.
TEST(AnnularCracks, LimitShallowCracksAreThoseOfASheet) {
  const Cracks cracks{{0, 0.01}, {0.006, 0.01}, {0.02, 0.013}};
  std::vector<StraightCrack> sheet;
  for (const PlacedAnnularCrack& crack : cracks)
    sheet.push_back({.centre = {crack.place, 0}, .half_length = crack.depth, .angle = pi / 2});
  const CrackGroup flat = crack_group(sheet, {.xz = 1}, {.order = 60});
  const AnnularGroup group = annular_group(cracks, {1, 0});
  for (std::size_t j = 0; j < cracks.size(); ++j)
    EXPECT_NEAR(group.cracks[j].factor,
                std::abs(flat.cracks[j].ahead.mode_3) / std::sqrt(pi * cracks[j].depth), 5e-3);
}

// Kind: limit (CG-10).  Far apart, what two cracks do to each other falls like the first mode of
// the shaft, whose wave number is 5.1356/R in a solid one (second Bessel function).  Tolerance: the
// next mode.
TEST(AnnularCracks, LimitFarApart) {
  const auto influence = [](double distance) {
    return 1 - annular_group(Cracks{{0, 0.4}, {distance, 0.4}}, {1, 0}).cracks[0].compliance;
  };
  test::expect_relative(influence(1.5) / influence(1.2), std::exp(-5.135622 * 0.3), 1e-2);
  EXPECT_LT(influence(2), 3e-5);
}

// Kind: identity (CG-12).  Energy: the rotation grows with the depth of a crack by 2 pi c
// K_III^2/G, also beside another crack.  K of the crack alone is that of (FR-12).  Tolerance: 0.5
// %, the errors of the factor and of (FR-12).
TEST(AnnularCracks, IdentityEnergy) {
  const double step = 1e-3;
  for (const double depth : {0.1, 0.25, 0.5}) {
    const Cracks cracks{{0, depth}, {0.12, 0.2}};
    const auto modes = annular_modes(cracks, {1, 0});
    const auto rotation = [&](double of_first) {
      const AnnularGroup group = annular_group(Cracks{{0, of_first}, {0.12, 0.2}}, {1, 0}, modes);
      return group.cracks[0].rotation + group.cracks[1].rotation;
    };
    const double slope = (rotation(depth + step) - rotation(depth - step)) / (2 * step);
    const sif::AnnularCrackSolid alone{.depth = depth, .diameter = 2};
    const double K =
        alone.stress_intensity(depth, 0).III[1] * annular_group(cracks, {1, 0}).cracks[0].factor;
    test::expect_relative(slope, 2 * pi * (1 - depth) * K * K, 0.005);
  }
}

// Kind: scaling.  Another unit of length, another order and another origin.  Tolerance: rounding.
TEST(AnnularCracks, ScalingUnitsAndOrder) {
  const AnnularGroup group = annular_group(Cracks{{0, 0.2}, {0.1, 0.1}}, {1, 0.4});
  const AnnularGroup scaled = annular_group(Cracks{{5.3, 0.3}, {5, 0.6}}, {3, 1.2});
  for (const std::size_t j : {0U, 1U}) {
    test::expect_relative(scaled.cracks[1 - j].rotation, group.cracks[j].rotation / 27, 1e-9);
    test::expect_relative(scaled.cracks[1 - j].factor, group.cracks[j].factor, 1e-9);
  }
}

// Kind: convergence (CG-11).  The stated error contains the change by more functions.  With this
// solver cracks at a tenth of their depth are within 1 %, and far ones within rounding.
TEST(AnnularCracks, ConvergenceStatedError) {
  EXPECT_LT(annular_group(Cracks{{0, 0.3}, {0.03, 0.3}}, {1, 0}).error, 0.01);
  EXPECT_GT(annular_group(Cracks{{0, 0.3}, {0.03, 0.3}}, {1, 0}).error, 1e-4);
  EXPECT_LT(annular_group(Cracks{{0, 0.3}, {0.1, 0.3}}, {1, 0}).error, 3e-3);
  EXPECT_LT(annular_group(Cracks{{0, 0.3}, {0.6, 0.3}}, {1, 0}).error, 1e-4);
}

// Kind: input.  Each rule is broken once, and the message names the crack.
TEST(AnnularCracks, InputRules) {
  const auto refusal = [](const Cracks& cracks, const ShaftRadii& radii) {
    return test::broken_rule([&] { return annular_group(cracks, radii); });
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(refusal({}, {1, 0}), "is empty");
  contains(refusal({{0, 0.1}}, {1, 1}), "are no shaft");
  contains(refusal({{0, 0.1}}, {0, 0}), "are no shaft");
  contains(refusal({{0, 0.1}, {1, 0.9}}, {1, 0}), "cracks[1]");
  contains(refusal({{0, 0.1}, {1, 0.0009}}, {1, 0}), "0.001 to 0.85 of the wall");
  contains(refusal({{0, std::nan("")}}, {1, 0}), "0.001 to 0.85 of the wall");
  contains(refusal({{std::nan(""), 0.1}}, {1, 0}), "the place finite");
  contains(refusal({{0, 0.2}, {1, 0.1}, {0.009, 0.1}}, {1, 0}), "is nearer to cracks[0]");
  EXPECT_EQ(refusal({{0, 0.2}, {0.0101, 0.1}}, {1, 0}), "no error");
  EXPECT_FALSE(touching_annular_cracks(Cracks{{0, 0.2}, {0.011, 0.1}}));
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// Straight cracks in plates and across strips: (SP-4) to (SP-15), (SP-22) to (SP-24).

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <type_traits>

#include "sif/solution_support.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/plate/collinear_periodic.hpp"
#include "strainwave/sif/plate/collinear_two.hpp"
#include "strainwave/sif/plate/inclined_edge.hpp"
#include "strainwave/sif/plate/pin_forces.hpp"
#include "strainwave/sif/plate/plate_through.hpp"
#include "strainwave/sif/plate/stacked_periodic.hpp"
#include "strainwave/sif/plate/strip_centre.hpp"
#include "strainwave/sif/plate/strip_double_edge.hpp"
#include "strainwave/sif/plate/strip_edge.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::kUnitModuli;
using test::limits_broken;
using test::rules_broken;
using test::Texts;

/// The modes do not mix: each load causes one mode.
template <std::size_t N>
void expect_only(const UnitStressIntensity<N>& k, std::size_t load, char mode) {
  EXPECT_EQ(k.I[load] != 0.0, mode == '1');
  EXPECT_EQ(k.II[load] != 0.0, mode == '2');
  EXPECT_EQ(k.III[load] != 0.0, mode == '3');
}

// --- (SP-4): inclined through crack ------------------------------------------------------------

TEST(PlateThrough, IdentityStressOnThePlaneOfTheCrack) {
  // K_I and K_II are the normal and the shear stress of the rotated tensor; their squares add up to
  // the traction's.
  for (const double beta : {0.0, 0.3, pi / 4, 1.2, pi / 2}) {
    const PlateThroughCrack crack{.half_length = 5 * mm, .thickness = 2 * mm, .angle = beta};
    const auto k = crack.stress_intensity(3 * mm, 0);
    const double root = std::sqrt(pi * 3 * mm);
    // direction of the crack (cos b, sin b) to the tension's, normal (-sin b, cos b)
    EXPECT_NEAR(k.I[0] / root, (1 - std::cos(2 * beta)) / 2, 1e-15);
    EXPECT_NEAR(k.II[0] / root, std::sin(2 * beta) / 2, 1e-15);
    EXPECT_NEAR(std::hypot(k.I[0], k.II[0]) / root, std::sin(beta), 1e-15);
    EXPECT_EQ(k.II[1], root);
    EXPECT_EQ(k.III[2], root);
    expect_only(k, 1, '2');
    expect_only(k, 2, '3');
    EXPECT_EQ(k.III[0], 0.0);
  }
}

TEST(PlateThrough, IdentityGriffithEnergy) {
  // lambda = 2 pi a^2 t/E of a crack across the tension and in shear; pi a^2 t/mu antiplane.
  const double a = 5 * mm;
  const double t = 2 * mm;
  const PlateThroughCrack crack{.half_length = a, .thickness = t, .angle = pi / 2};
  const auto m = added_compliance(crack, {.opening = 3.0, .shear = 7.0}).matrix;
  test::expect_relative(m(0, 0), 2 * pi * a * a * t / 3, 1e-10);
  test::expect_relative(m(1, 1), 2 * pi * a * a * t / 3, 1e-10);
  test::expect_relative(m(2, 2), pi * a * a * t / 7, 1e-10);
  EXPECT_NEAR(m(0, 1), 0.0, 1e-15 * m(0, 0));
}

TEST(PlateThrough, InputLimits) {
  EXPECT_EQ(limits_broken(PlateThroughCrack{.half_length = 4 * mm, .thickness = 2 * mm}), Texts{});
  EXPECT_EQ(limits_broken(PlateThroughCrack{.half_length = 3.9 * mm, .thickness = 2 * mm}).size(),
            1U);
  test::expect_refused("plate-through", {{"angle", 1.6}}, "angle");
  test::expect_refused("plate-through", {{"half_length", 0.0}}, "half_length");
}

// --- (SP-5) to (SP-10), (FR-11): strips ----------------------------------------------------------

double factor(const std::string& name, double x) {
  const double root = std::sqrt(pi * x);
  const auto value = [&](double k) { return k / root; };
  if (name.starts_with("edge.")) {
    const auto k = StripEdgeCrack{.depth = x, .width = 1, .thickness = 1}.stress_intensity(x, 0);
    return value(name == "edge.tension" ? k.I[0] : name == "edge.bending" ? k.I[1] : k.II[2]);
  }
  if (name.starts_with("centre.")) {
    const auto k =
        StripCentreCrack{.half_length = x, .half_width = 1, .thickness = 1}.stress_intensity(x, 0);
    return value(name == "centre.tension" ? k.I[0] : k.II[1]);
  }
  if (name.starts_with("double.")) {
    const auto k =
        StripDoubleEdgeCrack{.depth = x, .half_width = 1, .thickness = 1}.stress_intensity(x, 0);
    return value(name == "double.tension" ? k.I[0] : k.II[1]);
  }
  const auto k =
      PlateStackedPeriodic{.half_length = x, .spacing = 1, .thickness = 1}.stress_intensity(x, 0);
  return value(name == "stack.tension" ? k.I[0] : k.II[1]);
}

TEST(Strip, ReferenceFiniteElements) {
  // (SP-5), (SP-7), (SP-8), (SP-9), (SP-10), (SP-14), (SP-15), (SP-22):
  // tools/reference/cracked_strip.py.  Half of the rows were not used for the fits.  The tolerance
  // is that of the fit.
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("cracked_strip")) {
    const double fit = row.quantity.starts_with("stack") ? 3e-5 : 2.5e-4;
    test::expect_row(factor(row.quantity, row("size_ratio")), row, fit);
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 9U);
  for (const auto& [name, n] : seen) EXPECT_EQ(n, 22) << name;
}

TEST(Strip, CrosscheckHandbookFormulas) {
  // Tada's formulas, written out here; their stated accuracy is the tolerance, 0.1 % for the centre
  // crack.  Those for the edge crack are compared in tests/fracture/edge_crack_test.cpp (FR-11).
  for (double x = 0.05; x < 0.96; x += 0.1) {
    const double u = pi / 2 * x;
    EXPECT_NEAR(factor("centre.tension", x) * std::sqrt(std::cos(u)) /
                    (1 - 0.025 * x * x + 0.06 * x * x * x * x),
                1, 0.0015);
    EXPECT_NEAR(factor("double.tension", x) / std::sqrt(std::tan(u) / u) /
                    (1 + 0.122 * std::pow(std::cos(u), 4)),
                1, 0.009);
  }
}

TEST(Strip, LimitSmallCrack) {
  // Half plane 1.1215 for both modes; for a stress that grows linearly from the edge, 0.6829.  The
  // parabola of the edge crack gives 6 times this value, that of the double edge crack 3 times.
  constexpr double kTiny = 1e-9;
  EXPECT_NEAR(factor("edge.tension", kTiny), 1.12152, 1e-4);
  EXPECT_NEAR(factor("edge.bending", kTiny), 1.12152, 1e-4);
  EXPECT_NEAR(factor("double.tension", kTiny), 1.12152, 1e-4);
  EXPECT_NEAR(factor("edge.shear", kTiny) / kTiny, 6 * 0.6829, 2e-3);
  EXPECT_NEAR(factor("double.shear", kTiny) / kTiny, 3 * 0.6829, 2e-3);
  EXPECT_NEAR(factor("centre.tension", kTiny), 1.0, 1e-8);
  EXPECT_NEAR(factor("centre.shear", kTiny), 1.5, 1e-8);  // the parabola's maximum
  EXPECT_NEAR(strip_antiplane(0), 1.0, 0);
  EXPECT_NEAR(strip_antiplane(1e-4), 1.0, 1e-8);
}

TEST(Strip, LimitDeepLigament) {
  // Edge crack: K = 3.975 M/(t (w - a)^(3/2)), M the moment about the ligament (FR-11); two edge
  // cracks: the external crack of a plane, K = P/(t sqrt(pi (b - a))).  Next term of order 1 - x.
  constexpr double kLigament = 1e-6;
  const double x = 1 - kLigament;
  const double deep = std::pow(kLigament, 1.5) * std::sqrt(pi);
  EXPECT_NEAR(factor("edge.tension", x) * deep / (3.975 / 2), 1, 0.004);
  EXPECT_NEAR(factor("edge.bending", x) * deep / (3.975 / 6), 1, 0.004);
  const double external = std::sqrt(kLigament) * pi;
  EXPECT_NEAR(factor("double.tension", x) * external / 2, 1, 0.002);
  EXPECT_NEAR(factor("double.shear", x) * external / 2, 1, 0.006);
}

TEST(Strip, IdentityAntiplaneIsTheRow) {
  // (SP-6) is (SP-12): the lines of symmetry between the cracks of a row are free of shear.
  for (const double x : {0.1, 0.5, 0.93}) {
    const double a = x * 20 * mm;
    const double row = PlateCollinearPeriodic{.half_length = a, .pitch = 40 * mm, .thickness = mm}
                           .stress_intensity(a, 0)
                           .III[2];
    const StripEdgeCrack edge{.depth = a, .width = 20 * mm, .thickness = mm};
    const StripCentreCrack centre{.half_length = a, .half_width = 20 * mm, .thickness = mm};
    const StripDoubleEdgeCrack two{.depth = a, .half_width = 20 * mm, .thickness = mm};
    test::expect_relative(edge.stress_intensity(a, 0).III[3], row, 1e-13);
    test::expect_relative(centre.stress_intensity(a, 0).III[2], row, 1e-13);
    test::expect_relative(two.stress_intensity(a, 0).III[2], row, 1e-13);
  }
}

TEST(Strip, IdentityLoadsMakeTheirModes) {
  const auto edge = StripEdgeCrack{.depth = 2 * mm, .width = 10 * mm, .thickness = 3 * mm};
  const auto k = edge.stress_intensity(2 * mm, 0);
  expect_only(k, 0, '1');
  expect_only(k, 1, '1');
  expect_only(k, 2, '2');
  expect_only(k, 3, '3');
  const StripCentreCrack centre{.half_length = 2 * mm, .half_width = 10 * mm, .thickness = 3 * mm};
  const StripDoubleEdgeCrack two{.depth = 2 * mm, .half_width = 10 * mm, .thickness = 3 * mm};
  for (const auto& each : {centre.stress_intensity(2 * mm, 0), two.stress_intensity(2 * mm, 0)}) {
    expect_only(each, 0, '1');
    expect_only(each, 1, '2');
    expect_only(each, 2, '3');
  }
}

TEST(Strip, IdentityAntiplaneEnergy) {
  // int 2 w tan(pi a/(2 w)) da = (4 w^2/pi) ln sec(pi a/(2 w)), for each tip.
  const double w = 10 * mm;
  const double a = 6 * mm;
  const double t = 3 * mm;
  const double energy = 4 * w * w / pi * -std::log(std::cos(pi * a / (2 * w))) * t;
  const auto entry = [](const auto& crack, std::size_t load) {
    return added_compliance(crack, kUnitModuli).matrix(load, load);
  };
  test::expect_relative(entry(StripEdgeCrack{.depth = a, .width = w, .thickness = t}, 3), energy,
                        1e-10);
  test::expect_relative(
      entry(StripCentreCrack{.half_length = a, .half_width = w, .thickness = t}, 2), 2 * energy,
      1e-10);
  test::expect_relative(entry(StripDoubleEdgeCrack{.depth = a, .half_width = w, .thickness = t}, 2),
                        2 * energy, 1e-10);
}

TEST(Strip, InputRulesAndLimits) {
  EXPECT_EQ(rules_broken(StripEdgeCrack{.depth = 1, .width = 1, .thickness = 1}), Texts{"depth"});
  EXPECT_EQ(rules_broken(StripEdgeCrack{.depth = 0.99, .width = 1, .thickness = 1}), Texts{});
  EXPECT_EQ(limits_broken(StripEdgeCrack{.depth = 0.96, .width = 1, .thickness = 1}),
            Texts{"a/w <= 0.95"});
  EXPECT_EQ(limits_broken(StripEdgeCrack{.depth = 0.94, .width = 1, .thickness = 1}), Texts{});
  EXPECT_EQ(rules_broken(StripCentreCrack{.half_length = 1, .half_width = 1, .thickness = 1}),
            Texts{"half_length"});
  EXPECT_EQ(limits_broken(StripCentreCrack{.half_length = 0.96, .half_width = 1, .thickness = 1}),
            Texts{"a/b <= 0.95"});
  EXPECT_EQ(limits_broken(StripCentreCrack{.half_length = 0.94, .half_width = 1, .thickness = 1}),
            Texts{});
  EXPECT_EQ(rules_broken(StripDoubleEdgeCrack{.depth = 1, .half_width = 1, .thickness = 1}),
            Texts{"depth"});
  EXPECT_EQ(limits_broken(StripDoubleEdgeCrack{.depth = 0.96, .half_width = 1, .thickness = 1}),
            Texts{"a/b <= 0.95"});
  EXPECT_EQ(limits_broken(StripDoubleEdgeCrack{.depth = 0.94, .half_width = 1, .thickness = 1}),
            Texts{});
  test::expect_refused("strip-edge", {{"depth", 0.011}}, "depth");
  test::expect_refused("strip-centre", {{"half_length", 0.021}}, "half_length");
  test::expect_refused("strip-double-edge", {{"depth", 0.011}}, "depth");
}

// --- (SP-24): inclined edge crack
// ------------------------------------------------------------------

HalfPlaneEdgeCrack inclined_edge(double angle) {
  return {.length = 2 * mm, .angle = angle, .thickness = 3 * mm};
}

TEST(HalfPlaneEdge, ReferenceIntegralEquation) {
  // tools/reference/inclined_edge_crack.py; the tolerance is that of the fits.
  int n = 0;
  const double root = std::sqrt(pi * mm);
  for (const test::CsvRow& row : test::read_reference_csv("inclined_edge_crack")) {
    const auto k = inclined_edge(row("angle")).stress_intensity(mm, 0);
    if (row.quantity == "F_I")
      test::expect_row(k.I[0] / root, row, 3.5e-4);
    else
      test::expect_row(k.II[0] / root, row, 1.2e-3);
    ++n;
  }
  EXPECT_EQ(n, 27);
}

TEST(HalfPlaneEdge, LimitNormalCrackIsTheShallowStrip) {
  const double root = std::sqrt(pi * mm);
  const auto k = inclined_edge(0).stress_intensity(mm, 0);
  test::expect_relative(k.I[0], sif::edge_crack_factor(sif::StripLoading::tension, 0) * root,
                        1e-14);
  EXPECT_EQ(k.II[0], 0.0);
  EXPECT_EQ(k.III[0], 0.0);
}

TEST(HalfPlaneEdge, CrosscheckPublishedAt45Degrees) {
  // 0.705 and 0.364, quoted in many papers (secondary); the tolerance is the third digit.
  const auto k = inclined_edge(pi / 4).stress_intensity(mm, 0);
  EXPECT_NEAR(k.I[0] / std::sqrt(pi * mm), 0.705, 0.0006);
  EXPECT_NEAR(k.II[0] / std::sqrt(pi * mm), 0.364, 0.0009);
}

TEST(HalfPlaneEdge, IdentityEnergy) {
  // 2 (F_I^2 + F_II^2) pi a^2/2 t.
  const HalfPlaneEdgeCrack crack = inclined_edge(0.6);
  const auto k = crack.stress_intensity(2 * mm, 0);
  test::expect_relative(added_compliance(crack, kUnitModuli).matrix(0, 0),
                        (k.I[0] * k.I[0] + k.II[0] * k.II[0]) * 2 * mm * 3 * mm, 1e-10);
}

TEST(HalfPlaneEdge, InputLimits) {
  EXPECT_EQ(limits_broken(inclined_edge(1.14)), Texts{"beta <= 65 deg"});
  EXPECT_EQ(limits_broken(inclined_edge(1.13)), Texts{});
  test::expect_refused("halfplane-edge", {{"angle", 1.6}}, "angle");
  test::expect_refused("halfplane-edge", {{"length", 0.0}}, "length");
}

// --- (SP-11), (SP-12): collinear cracks ----------------------------------------------------------

TEST(Collinear, ReferenceIntegralEquation) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("collinear_cracks")) {
    const double a = row("half_length");
    const double d = row("half_distance");
    const double root = std::sqrt(pi * a);
    const PlateCollinearTwo two{.half_length = a, .half_distance = d, .thickness = mm};
    const PlateCollinearPeriodic many{.half_length = a, .pitch = 2 * d, .thickness = mm};
    const auto k = row.quantity == "two.inner"   ? two.stress_intensity(a, 0.25)
                   : row.quantity == "two.outer" ? two.stress_intensity(a, 0.75)
                                                 : many.stress_intensity(a, 0);
    test::expect_row(k.I[0] / root, row, 1e-13);  // (SP-11), (SP-12)
    EXPECT_EQ(k.II[1], k.I[0]);
    EXPECT_EQ(k.III[2], k.I[0]);
    expect_only(k, 0, '1');
    expect_only(k, 1, '2');
    expect_only(k, 2, '3');
    ++n;
  }
  EXPECT_EQ(n, 15);
}

TEST(Collinear, LimitFarApart) {
  // Two cracks give 1 + (a/d)^2/8 at both tips, with a next term of third order; a row gives 1 +
  // (pi a/p)^2/6.
  const double a = mm;
  const double root = std::sqrt(pi * a);
  for (const double ratio : {1e-6, 1e-3, 0.02}) {
    const PlateCollinearTwo two{.half_length = a, .half_distance = a / ratio, .thickness = mm};
    const double cube = ratio * ratio * ratio;
    EXPECT_NEAR(two.stress_intensity(a, 0).I[0] / root, 1 + ratio * ratio / 8, cube + 1e-14);
    EXPECT_NEAR(two.stress_intensity(a, 1).I[0] / root, 1 + ratio * ratio / 8, cube + 1e-14);
    const PlateCollinearPeriodic row{.half_length = a, .pitch = a / ratio, .thickness = mm};
    EXPECT_NEAR(row.stress_intensity(a, 0).I[0] / root, 1 + pi * pi * ratio * ratio / 6,
                20 * cube * ratio + 1e-14);
  }
}

TEST(Collinear, LimitMergedCracks) {
  // As the gap 2 e closes, D/K -> 1 - 1/ln(8 d/e): the outer tips become those of one crack of half
  // length 2 d, and the inner K grows without bound.  Next term: the square of e/(2 d).
  const double d = 10 * mm;
  for (const double e : {1e-4 * d, 1e-8 * d, 1e-12 * d}) {
    const double a = d - e;
    const PlateCollinearTwo two{.half_length = a, .half_distance = d, .thickness = mm};
    const double gap = d - a;  // e after rounding
    const double log = std::log(4 * (d + a) / gap);
    const double tolerance = gap / d;
    EXPECT_NEAR(
        two.stress_intensity(a, 1).I[0] / std::sqrt(pi * 4 * a * d / (d + a)) / (1 - 1 / log), 1,
        tolerance + 1e-14);
    EXPECT_NEAR(two.stress_intensity(a, 0).I[0] / std::sqrt(pi * 4 * a * d / gap) * log, 1,
                tolerance + 1e-13);
  }
}

TEST(Collinear, IdentityAreaOfFourTips) {
  // Far apart, the compliance is twice that of one crack; a change at s = 1/2 costs no accuracy.
  const double a = mm;
  const PlateCollinearTwo two{.half_length = a, .half_distance = 1e6 * a, .thickness = 3 * mm};
  const auto result = added_compliance(two, kUnitModuli);
  EXPECT_TRUE(result.converged);
  test::expect_relative(result.matrix(0, 0), 2 * (2 * pi * a * a * 3 * mm), 1e-9);
  test::expect_relative(result.matrix(2, 2), 2 * (pi * a * a * 3 * mm), 1e-9);
  const PlateCollinearPeriodic row{.half_length = 2 * a, .pitch = 10 * a, .thickness = 3 * mm};
  // int 2 p tan(pi a/p) 2 t da = 4 t p^2/pi ln sec(pi a/p).
  test::expect_relative(added_compliance(row, kUnitModuli).matrix(0, 0),
                        4 * 3 * mm * 100 * a * a / pi * -std::log(std::cos(0.2 * pi)), 1e-10);
}

TEST(Collinear, IdentityInteriorTipIsTheWorse) {
  for (const double x : {0.2, 0.5, 0.8, 0.99}) {
    const PlateCollinearTwo two{.half_length = x * mm, .half_distance = mm, .thickness = mm};
    EXPECT_GT(two.stress_intensity(x * mm, 0.49).I[0], two.stress_intensity(x * mm, 0.51).I[0]);
  }
}

TEST(Collinear, InputRulesAndLimits) {
  EXPECT_EQ(rules_broken(PlateCollinearTwo{.half_length = 1, .half_distance = 1, .thickness = 1}),
            Texts{"half_length"});
  EXPECT_EQ(rules_broken(PlateCollinearTwo{.half_length = 0.9, .half_distance = 1}), Texts{});
  EXPECT_EQ(rules_broken(PlateCollinearPeriodic{.half_length = 0.5, .pitch = 1, .thickness = 1}),
            Texts{"half_length"});
  EXPECT_EQ(rules_broken(PlateCollinearPeriodic{.half_length = 0.49, .pitch = 1}), Texts{});
  EXPECT_EQ(limits_broken(PlateCollinearTwo{.half_length = 1.9, .half_distance = 9, .thickness = 1})
                .size(),
            1U);
  EXPECT_EQ(limits_broken(PlateCollinearTwo{.half_length = 2, .half_distance = 9, .thickness = 1}),
            Texts{});
  EXPECT_EQ(
      limits_broken(PlateCollinearPeriodic{.half_length = 1.9, .pitch = 9, .thickness = 1}).size(),
      1U);
  EXPECT_EQ(limits_broken(PlateCollinearPeriodic{.half_length = 2, .pitch = 9, .thickness = 1}),
            Texts{});
  test::expect_refused("plate-collinear-two", {{"half_length", 0.009}}, "half_length");
  test::expect_refused("plate-collinear-periodic", {{"half_length", 0.008}}, "half_length");
}

// --- (SP-13) to (SP-15): stacks
// ----------------------------------------------------------------------

PlateStackedPeriodic stack(double a, double h) {
  return {.half_length = a, .spacing = h, .thickness = mm};
}

TEST(Stack, LimitDense) {
  // The layers between the cracks are unloaded: G = sigma^2 h/(2 E'), tau^2 h/(2 mu) (SP-13,
  // SP-14); in mode II they are beams of length a + 0.1433 h clamped at the tip (SP-15).
  for (const double x : {3.0, 20.0, 1e4}) {
    const double h = 2 * mm;
    const auto k = stack(x * h, h).stress_intensity(x * h, 0);
    test::expect_relative(k.I[0], std::sqrt(h / 2), 1e-5);
    test::expect_relative(k.III[2], std::sqrt(h), 1e-7);
    test::expect_relative(k.II[1], std::sqrt(6 * h) * (x + 0.143275), 1e-5);
    expect_only(k, 0, '1');
    expect_only(k, 1, '2');
    expect_only(k, 2, '3');
  }
}

TEST(Stack, LimitFarApart) {
  for (const double x : {1e-6, 1e-3}) {
    const double a = 3 * mm;
    const auto k = stack(a, a / x).stress_intensity(a, 0);
    const double root = std::sqrt(pi * a);
    EXPECT_NEAR(k.I[0] / root, 1, x + 1e-12);
    EXPECT_NEAR(k.II[1] / root, 1, x + 1e-12);
    EXPECT_NEAR(k.III[2] / root, 1, pi * pi * x * x / 6 + 1e-12);  // tanh z = z - z^3/3
  }
}

TEST(Stack, IdentityAntiplaneEnergy) {
  // int 2 h tanh(pi a/h) t da = (2 t h^2/pi) ln cosh(pi a/h).
  const double h = 5 * mm;
  const double a = 4 * mm;
  test::expect_relative(added_compliance(stack(a, h), kUnitModuli).matrix(2, 2),
                        2 * mm * h * h / pi * std::log(std::cosh(pi * a / h)), 1e-10);
}

TEST(Stack, IdentityNeighboursShieldInOpening) {
  for (double x = 0.05; x < 3; x += 0.05) {
    const auto k = stack(x, 1).stress_intensity(x, 0);
    EXPECT_LT(k.I[0], std::sqrt(pi * x));
    EXPECT_LT(k.III[2], std::sqrt(pi * x));
    EXPECT_GT(k.II[1], std::sqrt(pi * x));
  }
}

TEST(Stack, InputLimits) {
  EXPECT_EQ(
      limits_broken(PlateStackedPeriodic{.half_length = 1.9, .spacing = 1, .thickness = 1}).size(),
      1U);
  EXPECT_EQ(limits_broken(PlateStackedPeriodic{.half_length = 2, .spacing = 1, .thickness = 1}),
            Texts{});
  test::expect_refused("plate-stacked-periodic", {{"spacing", 0.0}}, "spacing");
}

TEST(PlateStraight, IdentityNominalStressIsTheLoad) {
  const auto all_one = [](const auto& crack) {
    for (std::size_t load = 0; load < std::decay_t<decltype(crack)>::kLoads; ++load)
      EXPECT_EQ(crack.gross_stress(load), 1.0);
    EXPECT_EQ(crack.size(), 1.0);
  };
  all_one(PlateThroughCrack{.half_length = 1, .thickness = 1});
  all_one(StripCentreCrack{.half_length = 1, .half_width = 2, .thickness = 1});
  all_one(StripEdgeCrack{.depth = 1, .width = 2, .thickness = 1});
  all_one(StripDoubleEdgeCrack{.depth = 1, .half_width = 2, .thickness = 1});
  all_one(HalfPlaneEdgeCrack{.length = 1, .thickness = 1});
  all_one(PlateCollinearTwo{.half_length = 1, .half_distance = 2, .thickness = 1});
  all_one(PlateCollinearPeriodic{.half_length = 1, .pitch = 3, .thickness = 1});
  all_one(PlateStackedPeriodic{.half_length = 1, .spacing = 3, .thickness = 1});
}

// --- (SP-23): pins
// ----------------------------------------------------------------------------------

TEST(PlatePin, IdentityStressOfTheForces) {
  // K = 2 sqrt(a/pi) int sigma dx/sqrt(a^2 - x^2), sigma from Kelvin's point forces in plane
  // stress: (P/t) y/(2 pi r^2) [1 - nu + 2 (1 + nu) y^2/r^2].
  for (const double y : {2 * mm, 9 * mm, 40 * mm}) {
    const double a = 7 * mm;
    const double nu = 0.25;
    const PlatePinForces crack{
        .half_length = a, .distance = y, .thickness = 3 * mm, .poissons_ratio = nu};
    const auto stress = [&](double x) {
      const double r2 = x * x + y * y;
      return y / (2 * pi * r2 * 3 * mm) * (1 - nu + 2 * (1 + nu) * y * y / r2);
    };
    // x = a sin(u)
    const double K =
        2 * std::sqrt(a / pi) *
        integrate([&](double u) { return stress(a * std::sin(u)); }, 0.0, pi / 2).value;
    test::expect_relative(crack.stress_intensity(a, 0).I[0], K, 1e-9);
    test::expect_relative(crack.gross_stress(0), stress(0), 1e-14);
    EXPECT_EQ(crack.stress_intensity(a, 0).II[0], 0.0);
  }
}

TEST(PlatePin, LimitOnTheCrackAndFarAway) {
  const PlatePinForces near{.half_length = 5 * mm, .distance = 1e-9 * mm, .thickness = 2 * mm};
  test::expect_relative(near.stress_intensity(5 * mm, 0).I[0],
                        1 / (2 * mm * std::sqrt(pi * 5 * mm)), 1e-12);
  // Far away the stress is uniform over the crack; next term (a/y)^2.
  const PlatePinForces far{.half_length = 5 * mm, .distance = 5e6 * mm, .thickness = 2 * mm};
  test::expect_relative(far.stress_intensity(5 * mm, 0).I[0],
                        far.gross_stress(0) * std::sqrt(pi * 5 * mm), 1e-10);
}

TEST(PlatePin, IdentityArea) {
  // For distant pins, the compliance is 2 pi a^2 t/E' times the square of the stress.
  const double a = 5 * mm;
  const PlatePinForces far{.half_length = a, .distance = 1e6 * a, .thickness = 2 * mm};
  const double s = far.gross_stress(0);
  test::expect_relative(added_compliance(far, kUnitModuli).matrix(0, 0),
                        2 * pi * a * a * 2 * mm * s * s, 1e-9);
}

TEST(PlatePin, InputLimits) {
  EXPECT_EQ(limits_broken(PlatePinForces{.half_length = 1.9, .distance = 1, .thickness = 1}).size(),
            1U);
  EXPECT_EQ(limits_broken(PlatePinForces{.half_length = 2, .distance = 1, .thickness = 1}),
            Texts{});
  test::expect_refused("plate-pin", {{"distance", 0.0}}, "distance");
  test::expect_refused("plate-pin", {{"poissons_ratio", 0.5}}, "poissons_ratio");
}

}  // namespace
}  // namespace strainwave::sif

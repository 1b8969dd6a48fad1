// SPDX-License-Identifier: Apache-2.0 Judgement of the closed forms: results of finite elements
// (tests/data/judgement_*.csv, written by tools/judge_closed_forms.py) against those of the
// library, each row within the accuracy that the library states.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/accuracy.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kJudgedE = 210e9;

/// Counts the rows of each case, so that missing rows are detected.
using Seen = std::map<std::string, int>;

TEST(Judgement, CrosscheckAnnularCracks) {
  Seen seen;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_annular")) {
    const double ratio = row("radius_ratio");
    const double alpha = row("depth_ratio");
    const double nu = row("poissons_ratio");
    if (ratio > 0 && alpha > sif::AnnularCrackHollow::kMaxDepthRatio + 1e-9) continue;  // refused
    const double a = alpha * (1 - ratio);
    const double mu = kJudgedE / (2 * (1 + nu));
    const double J = pi / 2 * (1 - std::pow(ratio, 4));
    const double A = pi * (1 - ratio * ratio);
    const CrackModuli moduli{.opening = kJudgedE / (1 - nu * nu), .shear = mu};
    SymmetricMatrix<2> added;
    UnitStressIntensity<2> k;
    if (ratio > 0) {
      const sif::AnnularCrackHollow crack({.depth = a, .outer_radius = 1, .inner_radius = ratio});
      added = added_compliance(crack, moduli).matrix;
      k = crack.stress_intensity(a, 0);
    } else {
      const sif::AnnularCrackSolid crack{.depth = a, .diameter = 2};
      added = added_compliance(crack, moduli).matrix;
      k = crack.stress_intensity(a, 0);
    }
    // Values over those of a shallow crack.
    const double shallow = pi * pi * a * a;
    const std::map<std::string, double> ours{
        {"C_T", added(kTorsion, kTorsion) / (shallow / (mu * J * J))},
        {"C_P", added(kAxial, kAxial) / (2 / moduli.opening * 1.1215 * 1.1215 * shallow / (A * A))},
        {"K_III", k.III[kTorsion] / (std::sqrt(pi * a) / J)},
        {"K_I", k.I[kAxial] / (1.1215 * std::sqrt(pi * a) / A)}};
    const bool torsion = row.quantity == "C_T" || row.quantity == "K_III";
    // Tables and fits for tension are for Poisson's ratio 0.3.
    const double of_compliance = torsion     ? accuracy::kAnnularTorsion
                                 : nu == 0.3 ? accuracy::kAnnularTension
                                             : accuracy::kAnnularTensionOtherRatio;
    double tolerance = of_compliance;
    if (row.quantity == "K_I" || row.quantity == "K_III") tolerance = of_compliance / 2;
    if (ratio > 0 && row.quantity == "K_III") tolerance = accuracy::kHollowTorsionIntensity;
    if (ratio > 0 && row.quantity == "K_I")
      tolerance = nu == 0.3 ? accuracy::kHollowTensionIntensity : of_compliance;
    EXPECT_NEAR(ours.at(row.quantity) / row.value, 1, tolerance)
        << row.place << ": " << row.quantity << ", r_i/r_o " << ratio << ", a/t " << alpha
        << ", nu " << nu;
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const auto& [name, n] : seen) EXPECT_GE(n, 70) << name;
}

/// The crack of a row in a wall with the mean radius 1.
sif::ThroughCrackInTube through_crack(const test::CsvRow& row) {
  const double t = 1 / row("radius_ratio");
  return {.half_length = row("length_ratio") * t,
          .mean_radius = 1,
          .wall_thickness = t,
          .angle = row("angle"),
          .poissons_ratio = row("poissons_ratio"),
          .thin_sheet = false};
}

double shell_parameter(const sif::ThroughCrackInTube& crack) {
  return std::sqrt(crack.shell_parameter_squared(crack.half_length));
}

/// Stress at the middle of the wall, T r/J, over Bredt's T/(2 pi r^2 t), mean radius 1.
double of_middle(const sif::ThroughCrackInTube& crack) {
  return 1 / (1 + std::pow(crack.wall_thickness / 2, 2));
}

/// Added compliance over that of the flat sheet, a^2/(2 pi E r^4 t).
double relative_compliance(const sif::ThroughCrackInTube& crack) {
  const double t = crack.wall_thickness;
  const double a = crack.half_length;
  return added_compliance(crack, {.opening = kJudgedE, .shear = kJudgedE}).matrix(1, 1) *
         (2 * pi * kJudgedE * t) / (a * a) / std::pow(of_middle(crack), 2);
}

/// K under unit torque over tau sqrt(pi a).
std::array<double, 2> relative_intensity(const sif::ThroughCrackInTube& crack, double s) {
  const UnitStressIntensity<2> k = crack.stress_intensity(crack.half_length, s);
  const double unit = std::sqrt(pi * crack.half_length) / (2 * pi * crack.wall_thickness);
  return {k.I[kTorsion] / unit, k.II[kTorsion] / unit};
}

/// Energy release rate over that of the flat sheet.
double relative_release(const sif::ThroughCrackInTube& crack) {
  double sum = 0;  // mean by Simpson's rule, which is exact because K is linear in s
  for (const double s : {-1.0, 0.0, 1.0}) {
    const auto [K_I, K_II] = relative_intensity(crack, s);
    sum += (K_I * K_I + K_II * K_II) * (s == 0 ? 4 : 1) / 6;
  }
  return sum * crack.wall_factor(crack.half_length) / std::pow(of_middle(crack), 2);
}

struct Measured {
  double compliance, release;
};

/// Largest differences by the table of (FR-21), whose last digit is 0.1 %.
Measured measured_of_through_cracks(const test::CsvRow& row, double lambda) {
  const double degrees = row("angle") * 180 / pi;
  if (row("poissons_ratio") == 0) return {.compliance = 0.010, .release = 0.017};
  if (row("poissons_ratio") == 0.45) return {.compliance = 0.007, .release = 0.012};
  if (degrees < 20) return {.compliance = 0.004, .release = 0.005};
  if (degrees > 70) return {.compliance = 0.011, .release = 0.012};
  if (std::abs(degrees - 45) > 10) return {.compliance = 0.003, .release = 0.008};
  if (lambda > 3.1) return {.compliance = 0.013, .release = 0.027};
  return {.compliance = 0.006, .release = 0.008};
}

TEST(Judgement, CrosscheckThroughCracks) {
  Seen seen;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_through")) {
    if (row.quantity != "C" && row.quantity != "G") continue;
    const sif::ThroughCrackInTube crack = through_crack(row);
    const double lambda = shell_parameter(crack);
    if (lambda > sif::ThroughCrackInTube::kMaxShellParameter) continue;  // marked unusable
    const bool compliance = row.quantity == "C";
    const double ours = compliance ? relative_compliance(crack) : relative_release(crack);
    const Measured measured = measured_of_through_cracks(row, lambda);
    constexpr double kLastDigit = 0.0005;
    const double stated = lambda > 2 ? accuracy::kThroughCrackLong : accuracy::kThroughCrack;
    EXPECT_NEAR(
        ours / row.value, 1,
        std::min(stated, kLastDigit + (compliance ? measured.compliance : measured.release)))
        << row.place << ": " << row.quantity << ", r/t " << row("radius_ratio") << ", a/t "
        << row("length_ratio") << ", " << row("angle") * 180 / pi << " deg, nu "
        << row("poissons_ratio");
    ++seen[row.quantity];
  }
  EXPECT_GE(seen["C"], 50);
  EXPECT_EQ(seen["C"], seen["G"]);
}

// K of a sheet against local K.  At the middle and the outer face, the stated accuracy refers to
// the whole local K.  At the inner face, where the K_II of a sheet is too small near 0 and 90
// degrees, it refers to the largest K in the wall, as stated in the docstring.
TEST(Judgement, CrosscheckThroughCrackIntensities) {
  Seen seen;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_through")) {
    if (!row.quantity.starts_with("K_")) continue;
    const sif::ThroughCrackInTube crack = through_crack(row);
    if (shell_parameter(crack) > sif::ThroughCrackInTube::kMaxShellParameter) continue;
    const bool inner = row.quantity.ends_with("inner");
    const double s = inner ? -1.0 : row.quantity.ends_with("outer") ? 1.0 : 0.0;
    const auto [K_I, K_II] = relative_intensity(crack, s);
    double whole = std::hypot(K_I, K_II);
    if (inner)
      for (const double at : {0.0, 1.0}) {
        const auto [one, two] = relative_intensity(crack, at);
        whole = std::max(whole, std::hypot(one, two));
      }
    const double stated = inner ? 0.28
                          : crack.poissons_ratio > 0.3 + 1e-12
                              ? accuracy::kThroughCrackIntensityOtherRatio
                              : accuracy::kThroughCrackIntensity;
    EXPECT_NEAR(row.quantity.starts_with("K_II") ? K_II : K_I, row.value, stated * whole)
        << row.place << ": " << row.quantity;
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 6U);
  for (const auto& [name, n] : seen) EXPECT_GE(n, 50) << name;
}

// Torque that closes the crack makes the faces slide without friction in both computations.
TEST(Judgement, CrosscheckClosedThroughCracks) {
  Seen seen;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_closed")) {
    sif::ThroughCrackInTube crack = through_crack(row);
    crack.open = false;
    const double ours = row.quantity == "C" ? relative_compliance(crack) : relative_release(crack);
    const double measured = row.quantity == "C" ? 0.0085 : 0.0205;  // table of the theory manual
    const double stated = accuracy::combined(
        shell_parameter(crack) > 2 ? accuracy::kThroughCrackLong : accuracy::kThroughCrack,
        accuracy::kThroughCrackPressed);
    EXPECT_NEAR(ours / row.value, 1, std::min(measured, stated))
        << row.place << ": " << row.quantity << ", a/t " << row("length_ratio") << ", "
        << row("angle") * 180 / pi << " deg: " << 100 * (ours / row.value - 1) << " %";
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen["C"], 8);
  EXPECT_EQ(seen["C"], seen["G"]);
}

TEST(Judgement, CrosscheckSurfaceCracks) {
  int seen = 0;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_surface")) {
    constexpr double kRatio = 0.3;  // Poisson's
    const double t = 1 / row("radius_ratio");
    const double a = row("depth_ratio") * t;
    const sif::CrackPlaneStress stress = sif::crack_plane_stress(1, t, row("angle"), 1);
    const sif::SurfaceCrack<2> crack({.depth = a,
                                      .aspect_ratio = row("aspect_ratio"),
                                      .thickness = t,
                                      .poissons_ratio = kRatio,
                                      .normal_stress = stress.normal,
                                      .shear_stress = stress.shear});
    const double tau = 1 / (2 * pi * t);
    const UnitStressIntensity<2> k = crack.stress_intensity(a, pi / 2);
    const double E_prime = kJudgedE / (1 - kRatio * kRatio);
    const CrackModuli moduli{.opening = E_prime, .shear = kJudgedE / (2 * (1 + kRatio))};
    const double root = tau * std::sqrt(pi * a);
    const double ours = row.quantity == "K_I" ? k.I[kTorsion] / root
                        : row.quantity == "K_III"
                            ? std::abs(k.III[kTorsion]) / root
                            : added_compliance(crack, moduli).matrix(1, 1) * kJudgedE *
                                  row("aspect_ratio") / (2 * pi * tau * tau * a * a * a);
    const double opened =
        row("depth_ratio") > 0.7 ? accuracy::kSurfaceCrackDeep : accuracy::kSurfaceCrack;
    const double of_compliance = std::abs(row("angle") - pi / 4) < 1e-9
                                     ? opened
                                     : accuracy::combined(opened, accuracy::kSurfaceCrackShear);
    EXPECT_NEAR(ours / row.value, 1, row.quantity == "C" ? of_compliance : of_compliance / 2)
        << row.place << ": " << row.quantity;
    ++seen;
  }
  EXPECT_EQ(seen, 24);
}

// Nine shapes from outside in a tube, 45 degrees, with the shear stress at the mouth: Newman and
// Raju's plate at the deepest point.  5 % as stated; at 0.8 of the wall, the end of the fit, 8 %
// (FR-4).
TEST(Judgement, CrosscheckSurfaceCracksDeepestPoint) {
  int seen = 0;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_surface_mouth")) {
    const double a = row("depth_ratio");
    const double rho = row("aspect_ratio");
    const sif::SurfaceCrack<1> crack({.depth = a,
                                      .aspect_ratio = rho,
                                      .thickness = 1,
                                      .poissons_ratio = 0.3,
                                      .normal_stress = {1.0},
                                      .shear_stress = {0.0}});
    const double ours = crack.stress_intensity(a, pi / 2).I[0] / std::sqrt(pi * a) *
                        std::comp_ellint_2(std::sqrt(1 - rho * rho));
    const double tolerance = (a > 0.7 ? accuracy::kSurfaceCrackDeep : accuracy::kSurfaceCrack) / 2;
    EXPECT_NEAR(ours / row.value, 1, tolerance) << row.place << ": a/t " << a << ", a/c " << rho;
    ++seen;
  }
  EXPECT_EQ(seen, 9);
}

// A crack at half length of a cup's barrel: solid elements over the long tube of the closed form.
// The effect of the ends is within the uncertainty that `strainwave stiffness` states, for C and
// for K, which has half the uncertainty of G.  A tube (no diaphragm) is clamped at one end and free
// at the other.
TEST(Judgement, CrosscheckThroughCrackInABarrel) {
  int seen = 0;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_barrel")) {
    const double length = row("barrel_length");
    if (std::abs(row("place") - length / 2) > 1e-9)
      continue;  // elsewhere the ends have more effect
    const double share = 2 * row("half_length") / length;
    const double ends = (row("rim") == 1 ? accuracy::kThroughCrackBetweenJoints
                                         : accuracy::kThroughCrackNearFreeEnd) *
                        share * share;
    const double more = row.quantity == "C" ? row.value - 1 : std::sqrt(row.value) - 1;
    EXPECT_LT(std::abs(more), ends) << row.place << ": " << row.quantity;
    EXPECT_GT(std::abs(more), 0.2 * ends) << row.place << ": " << row.quantity;
    ++seen;
  }
  EXPECT_EQ(seen, 14);
}

TEST(Judgement, CrosscheckSoundCups) {
  int seen = 0;
  for (const test::CsvRow& row : test::read_reference_csv("judgement_cup")) {
    constexpr double kOuter = 80.5e-3;
    constexpr double kWall = 0.6e-3;
    constexpr double kLength = 40e-3;
    const double G = 8e10;  // cancels
    const Tube barrel{
        .outer_diameter = kOuter, .inner_diameter = kOuter - 2 * kWall, .length = kLength};
    const Diaphragm diaphragm{.outer_diameter = kOuter - kWall,
                              .inner_diameter = row("bore_ratio") * (kOuter - 2 * kWall),
                              .thickness = row("diaphragm_ratio") * kWall,
                              .profile = {}};
    const double ours = 1 + torsional_compliance(diaphragm, G) / torsional_compliance(barrel, G);
    EXPECT_NEAR(ours / row.value, 1, accuracy::kSections) << row.place;
    // The article's factor has the opposite effect.
    EXPECT_LT(0.83 / row.value, 1) << row.place;
    ++seen;
  }
  EXPECT_EQ(seen, 16);
}

}  // namespace
}  // namespace strainwave

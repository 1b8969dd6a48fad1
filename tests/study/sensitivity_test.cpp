// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using test::article_gear;
using test::expect_relative;
using test::random_drive;

using Outputs = std::array<double, 5>;

/// Stiffness sound, T > 0, T < 0; loss T > 0, T < 0; from the computation without derivatives.
Outputs outputs(const GearSet& gear, const StiffnessOptions& options = {}) {
  const auto series = series_compliance<double>(gear, {}, options);
  return {series.intact_stiffness(), series.positive_stiffness(), series.negative_stiffness(),
          series.positive_loss(), series.negative_loss()};
}

const std::array<std::string, 5> kNames = {
    "intact.stiffness", "cracked.positive.stiffness", "cracked.negative.stiffness",
    "cracked.positive.stiffness_loss", "cracked.negative.stiffness_loss"};

std::size_t output_index(const Sensitivity& sensitivity, const std::string& name) {
  const auto found = std::ranges::find(sensitivity.outputs, name, &SensitivityOutput::name);
  return static_cast<std::size_t>(found - sensitivity.outputs.begin());
}

/// The influence of an input on an output; 0 for an input without influence.
Influence influence(const Sensitivity& sensitivity, const std::string& path,
                    const std::string& output) {
  const std::size_t y = output_index(sensitivity, output);
  const auto input = std::ranges::find(sensitivity.inputs, path, &SensitivityInput::path);
  if (y == sensitivity.outputs.size()) ADD_FAILURE() << "no output " << output;
  if (input == sensitivity.inputs.end()) {
    EXPECT_TRUE(std::ranges::find(sensitivity.no_influence, path) !=
                    sensitivity.no_influence.end() ||
                std::ranges::find(sensitivity.not_differentiated, path, &CurveStep::path) !=
                    sensitivity.not_differentiated.end())
        << path;
    return {};
  }
  return input->influence[y];
}

/// The step of a central difference of an input.
double step_of(const GearSet& gear, std::string_view unit, double x) {
  // A crack along or across the tube opens in proportion to the square of its angle, and to one
  // side only.  The derivative is 0 there, and differences approach it linearly in the step.
  if (unit == "rad" && std::abs(std::sin(2 * x)) < 1e-12) return 1e-9;
  if (x != 0) return 2e-4 * std::abs(x);
  if (unit == "rad/(N*m)") return 2e-4 * series_compliance<double>(gear).intact;
  return unit == "m" ? 1e-8 : 1e-4;
}

/// Central differences of fourth order of the five outputs, times their step; truncation and
/// rounding are below 1e-9 of the outputs per unit of elasticity.
Outputs central_differences(const GearSet& gear, const std::string& path, double step) {
  const StiffnessOptions exact{.quadrature = {.relative_tolerance = 1e-13}};
  const auto at = [&](double n) {
    GearSet varied = gear;
    set_number(varied, path, number_at(gear, path).value + n * step);
    return outputs(varied, exact);
  };
  const Outputs p1 = at(1);
  const Outputs m1 = at(-1);
  const Outputs p2 = at(2);
  const Outputs m2 = at(-2);
  Outputs d{};
  for (std::size_t y = 0; y < d.size(); ++y) d[y] = (8 * (p1[y] - m1[y]) - (p2[y] - m2[y])) / 12;
  return d;
}

/// Every derivative of a drive against central differences; one in four under the sanitizers.
void expect_derivatives(const GearSet& gear, const std::string& what) {
  const Sensitivity sensitivity = sensitivity_of(gear);
  EXPECT_LT(sensitivity.homogeneity_residual(), 1e-10) << what;
  const Outputs value = outputs(gear);
  static std::size_t number = 0;
  for_each_number(gear, [&](const FieldPath& field_path, const Field& field, const double& x) {
    const std::string& path = field_path.text();
    if (path.starts_with("scatter[")) return;
    if (test::kSanitized && ++number % 4 != 0) return;
    // The bore of a solid shaft cannot be reduced; see the test IdentityBoreOfASolidShaft.
    if (path == "output_shaft.inner_diameter" && x == 0) return;
    const double h = step_of(gear, field.unit, x);
    // The tolerance covers the error of the crack integrals, 1e-10, and rounding of differences.
    const double tolerance = h < 1e-8 ? 2e-6 : 3e-8;
    const Outputs difference = central_differences(gear, path, h);
    for (std::size_t y = 0; y < kNames.size(); ++y) {
      if (value[y] == 0) continue;
      const double derivative = influence(sensitivity, path, kNames[y]).derivative;
      // Relative to the larger of the output and its change over one unit of ln x.
      const double scale =
          std::max(std::abs(value[y]) * (x != 0 ? h / std::abs(x) : 1e-4), std::abs(difference[y]));
      EXPECT_NEAR(derivative * h / scale, difference[y] / scale, tolerance)
          << what << ": d " << kNames[y] << "/d " << path << " at " << x;
    }
  });
}

TEST(Sensitivity, CrosscheckSeriesComplianceIsTheReport) {
  // The lean computation gives the numbers of the full computation to the last bit.
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const GearSet gear = random_drive(seed);
    const StiffnessResult result = torsional_stiffness(gear);
    const auto series = series_compliance<double>(gear);
    EXPECT_EQ(series.intact, result.intact.compliance.total.value) << seed;
    EXPECT_EQ(series.positive, result.positive.compliance.total.value) << seed;
    EXPECT_EQ(series.negative, result.negative.compliance.total.value) << seed;
    EXPECT_EQ(series.positive_loss(), -result.positive.stiffness_change.value) << seed;
    EXPECT_EQ(series.negative_loss(), -result.negative.stiffness_change.value) << seed;
    EXPECT_EQ(series.intact_stiffness(), result.intact.stiffness.value) << seed;
    EXPECT_EQ(series.positive_stiffness(), result.positive.stiffness.value) << seed;
    EXPECT_EQ(series.negative_stiffness(), result.negative.stiffness.value) << seed;
    EXPECT_EQ(series.usable, result.usable()) << seed << result.unusable_because;
  }
}

TEST(Sensitivity, CrosscheckArticleAgainstDifferences) {
  expect_derivatives(article_gear(), "article");
}

TEST(Sensitivity, CrosscheckExamplesAgainstDifferences) {
  int n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    const GearSet gear = read_gear_set_file(entry.path());
    if (!gear.compliance_tables.empty()) continue;  // below
    expect_derivatives(gear, entry.path().filename());
    ++n;
  }
  EXPECT_GE(n, 6);
}

// A table has only one value of each fixed number, so derivatives with respect to it are unknown.
TEST(Sensitivity, InputTableHoldsNumbersFixed) {
  const Sensitivity s =
      sensitivity_of(read_gear_set_file(STRAINWAVE_EXAMPLES "/tabulated_crack.toml"));
  EXPECT_EQ(s.unusable_because,
            "flexspline.crack[0].compliance_table: \"tables/through_45.csv\" keeps angle, "
            "outer_diameter, wall_thickness, length, youngs_modulus, poissons_ratio fixed, so the "
            "derivatives with respect to these are not known");
}

TEST(Sensitivity, CrosscheckRandomDrivesAgainstDifferences) {
  // Among them every kind of crack, driver, source of radial stiffness, conversion, shaft and
  // section; closed and open cracks; axial forces.
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const GearSet gear = random_drive(seed);
    if (test::count_notes(smoothness_notes(gear), "sensitivity.step") > 0) continue;
    expect_derivatives(gear, "random drive " + std::to_string(seed));
  }
}

/// A cup whose diaphragm has a profile, with each kind of crack that random drives lack.
GearSet profiled_cup() {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cup_sections.toml");
  Flexspline& fs = *gear.flexspline;
  fs.diaphragm->profile = {{.radius = 23 * mm, .thickness = 2 * mm},
                           {.radius = 30 * mm, .thickness = 1.2 * mm}};
  fs.flange_compliance = 1e-7;
  fs.joint_compliance = 1e-7;
  DiaphragmArcCrack arc;
  arc.half_length = 2 * mm;
  arc.radius = 26 * mm;
  DiaphragmArcCrack inner_arc;
  inner_arc.half_length = 1 * mm;
  DiaphragmGroove groove;
  groove.depth = 0.2 * mm;
  groove.width = 3 * mm;
  groove.radius = 30.5 * mm;  // over a station
  fs.crack.emplace_back(arc);
  fs.crack.emplace_back(inner_arc);
  fs.crack.emplace_back(groove);
  gear.load.axial_force = -300 * N;
  return gear;
}

TEST(Sensitivity, CrosscheckProfiledCupAgainstDifferences) {
  expect_derivatives(profiled_cup(), "profiled cup");
}

TEST(Sensitivity, CrosscheckEveryDriverAgainstDifferences) {
  for (const StressDriver driver : {StressDriver::orthogonal_shear, StressDriver::contact_edge,
                                    StressDriver::ring_bending, StressDriver::given})
    for (const bool bearing : {false, true}) {
      GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cup_sections.toml");
      gear.flexspline.reset();
      WaveGenerator& wg = *gear.wave_generator;
      if (!bearing) {
        wg.bearing.reset();
        wg.displacements = LobeDisplacements{.bearing = 2e-6, .cam = 1e-6, .shaft = 0.0};
        wg.contact_semi_axes = {0.8 * mm, 0.1 * mm};
      }
      RaceSurfaceCrack surface;
      surface.depth = 0.3 * mm;
      surface.aspect_ratio = 0.7;
      surface.stress_driver = driver;
      if (driver == StressDriver::given) surface.stress = 40 * MPa;
      RaceEdgeCrack edge;
      edge.depth = 0.2 * mm;
      edge.stress_driver = driver;
      if (driver == StressDriver::given) edge.stress = 40 * MPa;
      wg.crack = {surface, edge};
      for (const Conversion conversion : {Conversion::reciprocity, Conversion::cam}) {
        wg.conversion = conversion;
        expect_derivatives(gear, std::string(enum_name(driver)) + (bearing ? ", bearing" : ""));
      }
    }
}

TEST(Sensitivity, IdentityDimensionsHoldForEveryDrive) {
  // SN-6, to rounding; the tolerance grows with the elasticities of thin walls.
  for (std::uint64_t seed = 41; seed <= 100; ++seed) {
    const Sensitivity sensitivity = sensitivity_of(random_drive(seed));
    double largest = 1.0;
    for (const SensitivityInput& input : sensitivity.inputs)
      largest = std::max(largest, input.largest_elasticity());
    EXPECT_LT(sensitivity.homogeneity_residual(), 1e-12 * largest) << seed;
  }
}

TEST(Sensitivity, BehaviourALostDerivativeIsRefused) {
  // Simulates a number read without a lift: its elasticity is missing.
  const Sensitivity sensitivity = sensitivity_of(article_gear());
  ASSERT_TRUE(sensitivity.usable()) << sensitivity.unusable_because;
  for (std::size_t i = 0; i < sensitivity.inputs.size(); ++i) {
    const LengthAndForce unit = length_and_force(sensitivity.inputs[i].unit);
    if (unit.length == 0 && unit.force == 0)
      continue;  // only differences detect errors in pure numbers
    Sensitivity leaking = sensitivity;
    for (Influence& influence : leaking.inputs[i].influence) influence.elasticity = 0.0;
    leaking = held_to_dimensions(std::move(leaking));
    EXPECT_FALSE(leaking.usable()) << sensitivity.inputs[i].path;
    EXPECT_NE(leaking.unusable_because.find("SN-6"), std::string::npos);
  }
}

TEST(Sensitivity, ReferenceTubeByHand) {
  // K = G pi (D^4 - d^4)/(32 L), G = E/(2(1 + nu)): elasticities by hand, SN-1.
  GearSet gear = article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  gear.output_shaft->crack.clear();
  gear.material["steel"].shear_modulus.reset();
  const double D = gear.output_shaft->outer_diameter;
  const double d = gear.output_shaft->inner_diameter;
  const double nu = *gear.material["steel"].poissons_ratio;
  const Sensitivity sensitivity = sensitivity_of(gear);
  const auto elasticity = [&](const std::string& path) {
    return influence(sensitivity, path, "intact.stiffness").elasticity;
  };
  const double rounding = 1e-14;
  EXPECT_NEAR(elasticity("output_shaft.length"), -1, rounding);
  EXPECT_NEAR(elasticity("material.steel.youngs_modulus"), 1, rounding);
  EXPECT_NEAR(elasticity("material.steel.poissons_ratio"), -nu / (1 + nu), rounding);
  const double J = std::pow(D, 4) - std::pow(d, 4);
  EXPECT_NEAR(elasticity("output_shaft.outer_diameter"), 4 * std::pow(D, 4) / J, rounding);
  EXPECT_NEAR(elasticity("output_shaft.inner_diameter"), -4 * std::pow(d, 4) / J, rounding);
  const double K = torsional_stiffness(gear).intact.stiffness.value;
  expect_relative(influence(sensitivity, "output_shaft.length", "intact.stiffness").derivative,
                  -K / gear.output_shaft->length, 1e-14);
  // All other inputs have no influence and are listed.
  EXPECT_EQ(sensitivity.inputs.size(), 5U);
  EXPECT_EQ(sensitivity.inputs[0].path, "output_shaft.outer_diameter");
  EXPECT_EQ(elasticity("load.torque"), 0.0);
  EXPECT_EQ(elasticity("drive.ratio"), 0.0);
  // Without cracks, losses are not listed.
  EXPECT_EQ(sensitivity.outputs.size(), 3U);
  EXPECT_EQ(test::count_notes(sensitivity.notes, "sensitivity.no_loss"), 2);
}

TEST(Sensitivity, ReferenceWaveGeneratorByHand) {
  // K = (d_1 U/(2 c_F k_r))^2 K_G0/U by (ST-5), (ST-6); a Hertz contact stiffens as T^(1/3).
  GearSet gear = article_gear();
  gear.flexspline.reset();
  gear.output_shaft.reset();
  gear.wave_generator->crack.clear();
  const Sensitivity stiff = sensitivity_of(gear);
  const auto elasticity = [](const Sensitivity& sensitivity, const std::string& path) {
    return influence(sensitivity, path, "intact.stiffness").elasticity;
  };
  EXPECT_NEAR(elasticity(stiff, "drive.pitch_diameter"), 2, 1e-14);
  EXPECT_NEAR(elasticity(stiff, "wave_generator.load_factor"), -2, 1e-14);
  EXPECT_NEAR(elasticity(stiff, "wave_generator.force_transmission_coefficient"), -2, 1e-14);
  EXPECT_NEAR(elasticity(stiff, "wave_generator.radial_stiffness"), 1, 1e-14);
  EXPECT_EQ(elasticity(stiff, "load.torque"), 0.0);
  const Sensitivity hertz = [] {
    GearSet cup = read_gear_set_file(STRAINWAVE_EXAMPLES "/cup_sections.toml");
    cup.flexspline.reset();
    cup.wave_generator->crack.clear();
    return sensitivity_of(cup);
  }();
  // SN-3: the axis ratio of the contact is found as a root and does not depend on the force.
  EXPECT_NEAR(elasticity(hertz, "load.torque"), 1.0 / 3, 1e-13);
  EXPECT_NEAR(elasticity(hertz, "material.bearing_steel.youngs_modulus"), 2.0 / 3, 1e-13);
  EXPECT_NEAR(elasticity(hertz, "wave_generator.bearing.loaded_balls"), 2.0 / 3, 1e-13);
}

TEST(Sensitivity, LimitLossOfAShallowCrack) {
  // A shallow annular crack adds compliance in proportion to a^2, so the elasticity of its loss
  // with respect to the depth is 2.
  GearSet gear = article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  auto& crack = std::get<AnnularCrack>(gear.output_shaft->crack[0]);
  for (const double inner : {0.0, 45 * mm}) {
    gear.output_shaft->inner_diameter = inner;
    crack.depth = 1e-7;
    // The next term is of order a/radius of the shaft, or a/wall.
    EXPECT_NEAR(influence(sensitivity_of(gear), "output_shaft.crack[0].depth",
                          "cracked.positive.stiffness_loss")
                    .elasticity,
                2, 1e-4);
  }
}

TEST(Sensitivity, IdentityBoreOfASolidShaft) {
  GearSet gear = article_gear();
  gear.output_shaft->inner_diameter = 0.0;
  const Sensitivity sensitivity = sensitivity_of(gear);
  // D^4 - d^4 is flat at d = 0.
  EXPECT_EQ(influence(sensitivity, "output_shaft.inner_diameter", "intact.stiffness").derivative,
            0.0);
  EXPECT_EQ(test::count_notes(sensitivity.notes, "sensitivity.solid_shaft"), 1);
  EXPECT_EQ(test::count_notes(sensitivity_of(article_gear()).notes, "sensitivity.solid_shaft"), 0);
}

TEST(Sensitivity, IdentityAZeroInputHasADerivative) {
  GearSet gear = profiled_cup();
  gear.flexspline->flange_compliance = 0.0;
  const double K = torsional_stiffness(gear).intact.stiffness.value;
  const Sensitivity sensitivity = sensitivity_of(gear);
  const Influence flange =
      influence(sensitivity, "flexspline.flange_compliance", "intact.stiffness");
  expect_relative(flange.derivative, -K * K, 1e-13);
  EXPECT_EQ(flange.elasticity, 0.0);
}

TEST(Sensitivity, BehaviourAStepIsSaid) {
  // sigma_n = P sin^2(b)/(2 pi r t) + T sin(2b)/(2 pi r^2 t) = 0 at 45 degrees: P r = -2 T.
  GearSet gear = article_gear();
  gear.flexspline->stress_nonuniformity = 1.0;
  const double r = (gear.drive.pitch_diameter - *gear.flexspline->wall_thickness) / 2;
  EXPECT_EQ(test::count_notes(sensitivity_of(gear).notes, "sensitivity.step"), 0);
  gear.load.axial_force = -2 * gear.load.torque / r;
  EXPECT_EQ(test::count_notes(sensitivity_of(gear).notes, "sensitivity.step"), 1);
  // A crack along the tube also has touching faces, but a small opening does not change its
  // compliance.
  gear.load.axial_force = 0.0;
  std::get<WallThroughCrack>(gear.flexspline->crack[0]).angle = 0.0;
  EXPECT_EQ(test::count_notes(sensitivity_of(gear).notes, "sensitivity.step"), 0);
}

TEST(Sensitivity, BehaviourAKinkIsSaid) {
  GearSet gear = profiled_cup();
  EXPECT_EQ(test::count_notes(sensitivity_of(gear).notes, "sensitivity.kink"), 0);
  gear.flexspline->diaphragm->profile[1].radius = 26 * mm;
  EXPECT_EQ(test::count_notes(sensitivity_of(gear).notes, "sensitivity.kink"), 1);
}

TEST(Sensitivity, BehaviourAnUnusableDriveStaysUnusable) {
  GearSet gear = article_gear();
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 11 * mm;  // a/t = 0.88
  const Sensitivity sensitivity = sensitivity_of(gear);
  EXPECT_FALSE(sensitivity.usable());
  EXPECT_EQ(sensitivity.unusable_because, torsional_stiffness(gear).unusable_because);
}

TEST(Sensitivity, BehaviourEveryNumberIsListedOnce) {
  const GearSet gear = article_gear();
  const Sensitivity sensitivity = sensitivity_of(gear);
  std::multiset<std::string> listed(sensitivity.no_influence.begin(),
                                    sensitivity.no_influence.end());
  for (const SensitivityInput& input : sensitivity.inputs) listed.insert(input.path);
  std::multiset<std::string> present;
  for_each_number(gear, [&](const FieldPath& path, const Field&, const double&) {
    present.insert(path.text());
  });
  EXPECT_EQ(listed, present);
  EXPECT_TRUE(std::ranges::is_sorted(sensitivity.inputs, std::ranges::greater{},
                                     &SensitivityInput::largest_elasticity));
}

TEST(Sensitivity, ConvergenceWithTheTolerance) {
  // Derivatives meet the tolerance of the crack integrals like the values.
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cup_sections.toml");
  const Sensitivity exact = sensitivity_of(gear, {.quadrature = {.relative_tolerance = 1e-13}});
  for (const double tolerance : {1e-6, 1e-10}) {
    const Sensitivity coarse =
        sensitivity_of(gear, {.quadrature = {.relative_tolerance = tolerance}});
    for (const SensitivityInput& input : exact.inputs)
      for (std::size_t y = 0; y < exact.outputs.size(); ++y)
        EXPECT_NEAR(influence(coarse, input.path, exact.outputs[y].name).elasticity,
                    input.influence[y].elasticity, 3 * tolerance)
            << input.path;
  }
}

TEST(Sensitivity, ReferenceLengthAndForce) {
  const auto expect = [](std::string_view unit, double length, double force) {
    const LengthAndForce d = length_and_force(unit);
    EXPECT_EQ(d.length, length) << unit;
    EXPECT_EQ(d.force, force) << unit;
  };
  expect("m", 1, 0);
  expect("N", 0, 1);
  expect("N*m", 1, 1);
  expect("N*m/rad", 1, 1);
  expect("rad/(N*m)", -1, -1);
  expect("Pa", -2, 1);
  expect("Pa*m^0.5", -1.5, 1);
  expect("N/m", -1, 1);
  expect("rad", 0, 0);
  expect("1", 0, 0);
  EXPECT_THROW((void)length_and_force("kg"), InputError);
  EXPECT_THROW((void)length_and_force("s"), InputError);
  EXPECT_THROW((void)length_and_force("K"), InputError);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/sensitivity.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

GearSet example_drive(const char* name) {
  return read_gear_set_file(std::string(STRAINWAVE_EXAMPLES "/") + name + ".toml");
}

/// K1, K2, K3 of the sound drive, then cracked under both senses.
std::array<double, 9> all_lines(const GearSet& gear) {
  CoupledOptions options;
  options.tolerance = 1e-13;  // tight tolerance, so that differences over small steps are accurate
  const AssembledDrive drive(gear, options);
  std::array<double, 9> K{};
  std::size_t i = 0;
  const auto add = [&](const MakersLines& lines) {
    for (const double line : {lines.K1, lines.K2, lines.K3}) K[i++] = line;
  };
  add(makers_lines(drive.without_cracks(), +1));
  add(makers_lines(drive, +1));
  add(makers_lines(drive, -1));
  return K;
}

constexpr std::array<const char*, 9> kLineNames = {
    "curve.intact.K1",   "curve.intact.K2",   "curve.intact.K3",
    "curve.positive.K1", "curve.positive.K2", "curve.positive.K3",
    "curve.negative.K1", "curve.negative.K2", "curve.negative.K3"};

/// Derivatives with respect to ln x, or to x if x is 0, by central differences of two steps and one
/// step of Richardson's extrapolation.
std::array<double, 9> line_differences(const GearSet& gear, const std::string& path, double step) {
  const double x = number_at(gear, path).value;
  const auto central = [&](double h) {
    const auto at = [&](double change) {
      GearSet moved = gear;
      set_number(moved, path, x == 0 ? change * 1e-3 : x * (1 + change));
      return all_lines(moved);
    };
    const std::array<double, 9> above = at(+h);
    const std::array<double, 9> below = at(-h);
    std::array<double, 9> slope{};
    for (std::size_t i = 0; i < 9; ++i) slope[i] = (above[i] - below[i]) / (2 * h);
    return slope;
  };
  const std::array<double, 9> wide = central(step);
  std::array<double, 9> slope = central(step / 2);
  for (std::size_t i = 0; i < 9; ++i) slope[i] += (slope[i] - wide[i]) / 3;
  return slope;
}

/// @param takes  whether to compare the derivatives with respect to a field; all if empty
void expect_differences(const GearSet& gear, double step, double tolerance,
                        const std::function<bool(const std::string&)>& takes = {}) {
  const Sensitivity s = sensitivity_of(gear);
  ASSERT_TRUE(s.usable()) << s.unusable_because;
  const std::array<double, 9> K = all_lines(gear);
  std::size_t compared = 0;
  for (const SensitivityInput& input : s.inputs) {
    if (takes && !takes(input.path)) continue;
    if (std::ranges::find(s.not_differentiated, input.path, &CurveStep::path) !=
        s.not_differentiated.end())
      continue;
    const std::array<double, 9> slope = line_differences(gear, input.path, step);
    for (std::size_t i = 0; i < 9; ++i) {
      const auto output = std::ranges::find(s.outputs, kLineNames[i], &SensitivityOutput::name);
      if (output == s.outputs.end()) continue;
      const Influence& exact =
          input.influence[static_cast<std::size_t>(output - s.outputs.begin())];
      const double by_log = input.value == 0 ? exact.derivative * 1e-3 / K[i] : exact.elasticity;
      EXPECT_NEAR(by_log, slope[i] / K[i], tolerance) << input.path << ' ' << kLineNames[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
}

/// The drive moved off the limits of its fields, so that differences can be taken on both sides.
GearSet inside(GearSet gear) {
  gear.range.clear();
  gear.wave_generator->bearing->ball_diameter *= 0.999;
  gear.wave_generator->bearing->clearance = 2.3e-6;
  gear.wave_generator->cam_flattening = 0.3;
  *gear.flexspline->length += 1e-4;
  gear.flexspline->flange_compliance = 1e-7;
  gear.flexspline->joint_compliance = 1e-7;
  gear.mesh->lobe_gap = 1.5e-6;
  if (gear.rating) gear.rating->friction_torque = 0.3;
  if (gear.output_shaft) gear.output_shaft->inner_diameter = 3e-3;
  return gear;
}

// Kind: crosscheck of derivatives of the equilibrium (TC-27) with central differences of the whole
// model, solved to 1e-13.  Tolerance 1e-8 of an elasticity: rounding of the differences, 1e-9, and
// the rest of their truncation.  No contact opens or closes within the steps.
constexpr double kStep = 3e-5;
constexpr double kTolerance = 1e-8;

TEST(CoupledSensitivity, CrosscheckDifferencesOfASoundDrive) {
  GearSet gear = example_drive("catalogue_size25");
  gear.mesh->tooth.reset();  // drawn teeth have a test of their own, with their own tolerance
  expect_differences(inside(gear), kStep, kTolerance);
}

TEST(CoupledSensitivity, CrosscheckDifferencesOfADriveWithEveryCrack) {
  expect_differences(inside(example_drive("cracked_size25")), kStep, kTolerance);
}

TEST(CoupledSensitivity, CrosscheckDifferencesOfACompositeTube) {
  // The steel rim on a barrel and a bottom of plies (LA-16), (LA-17), with a crack of the tube.
  GearSet gear = example_drive("composite_size25");
  gear.mesh->tooth.reset();
  gear.flexspline->crack.push_back(
      WallThroughCrack{.half_length = 2e-3, .angle = 0.7, .shell_correction = false});
  gear = inside(gear);
  for (Ply& ply : gear.material.at("bottom").ply) ply.angle *= 0.99;  // 90 deg is a limit
  const auto of_the_walls = [](const std::string& path) {
    return path.starts_with("material.") ? path.find(".ply_") == std::string::npos
                                         : path.starts_with("flexspline.");
  };
  expect_differences(gear, kStep, kTolerance, of_the_walls);
}

TEST(CoupledSensitivity, CrosscheckDifferencesWhereFlanksHoldTheRestingRing) {
  // The drive has an interference at the lobes, and torques by convention, which contain a pressure
  // (TC-14).
  GearSet gear = inside(example_drive("cracked_size25"));
  gear.rating.reset();
  gear.mesh->lobe_gap = -3e-6;
  expect_differences(gear, kStep, kTolerance);
}

TEST(CoupledSensitivity, IdentityMirroredRaceCracksExchangeTheSenses) {
  // A crack of the inner race is evaluated at the sense of torque that loads its ball more.  The
  // mirror image of a drive under -T is the drive with its cracks mirrored under T, so derivatives
  // of the outputs for T > 0 and T < 0 change places.  Tolerance 1e-9 of an elasticity: rounding of
  // both equilibria.
  GearSet gear = inside(example_drive("cracked_size25"));
  gear.wave_generator->crack.resize(1);
  gear.flexspline->crack.clear();
  gear.mesh->crack.clear();
  gear.circular_spline->crack.clear();
  gear.output_shaft->crack.clear();
  auto& race = std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]);
  race.depth = 0.8e-3;  // deep enough for K1 to depend on the load of its ball
  const Sensitivity given = sensitivity_of(gear);
  race.position = -race.position;
  const Sensitivity mirrored = sensitivity_of(gear);
  ASSERT_TRUE(given.usable()) << given.unusable_because;
  ASSERT_TRUE(mirrored.usable()) << mirrored.unusable_because;
  ASSERT_EQ(given.inputs.size(), mirrored.inputs.size());
  const auto index_of = [&](const std::string& output) {
    const auto found = std::ranges::find(given.outputs, output, &SensitivityOutput::name);
    EXPECT_NE(found, given.outputs.end()) << output;
    return static_cast<std::size_t>(found - given.outputs.begin());
  };
  for (const SensitivityInput& input : given.inputs) {
    const auto other = std::ranges::find(mirrored.inputs, input.path, &SensitivityInput::path);
    ASSERT_NE(other, mirrored.inputs.end()) << input.path;
    for (const std::string K : {"K1", "K2", "K3"}) {
      const std::size_t positive = index_of("curve.positive." + K);
      const std::size_t negative = index_of("curve.negative." + K);
      EXPECT_NEAR(input.influence[positive].elasticity, other->influence[negative].elasticity, 1e-9)
          << input.path << ' ' << K;
      EXPECT_NEAR(input.influence[negative].elasticity, other->influence[positive].elasticity, 1e-9)
          << input.path << ' ' << K;
    }
  }
}

/// The same drive with teeth as drawn.
GearSet drawn(GearSet gear, ToothProfile profile, ToothTips tips = ToothTips::full) {
  const double module = gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  gear.mesh->tooth =
      ToothShape{.profile = profile,
                 .addendum = (profile == ToothProfile::half_path ? 0.5 : 0.6) * module,
                 .spline_addendum = 0.55 * module,
                 .thickness = 1.5 * module,
                 .tips = tips};
  return gear;
}

TEST(CoupledSensitivity, CrosscheckDifferencesWithDrawnTeeth) {
  // Tolerance 1e-6: the rounding of the seat's angle (TC-29) moves the differences by 3e-7.
  for (const ToothProfile profile :
       {ToothProfile::straight, ToothProfile::involute, ToothProfile::half_path}) {
    GearSet gear = inside(drawn(example_drive("cracked_size25"), profile));
    gear.wave_generator->bearing->clearance = 3e-6;  // no contact opens within the steps
    expect_differences(gear, kStep, 1e-6);
  }
}

TEST(CoupledSensitivity, CrosscheckDifferencesWithRelievedTips) {
  // The angle at which engagement ends moves with the fields, but no tooth passes it within the
  // steps.  Tolerance as for full tips.
  GearSet gear =
      inside(drawn(example_drive("cracked_size25"), ToothProfile::straight, ToothTips::relieved));
  gear.wave_generator->bearing->clearance = 3e-6;  // no contact opens within the steps
  expect_differences(gear, kStep, 1e-6);
}

// (SN-6): no number is read without its derivative.
TEST(CoupledSensitivity, IdentityDimensionsHold) {
  GearSet convention = example_drive("cracked_size25");
  convention.rating.reset();
  for (const GearSet& gear :
       {example_drive("catalogue_size25"), example_drive("cracked_size25"), convention,
        drawn(example_drive("cracked_size25"), ToothProfile::straight),
        drawn(example_drive("cracked_size25"), ToothProfile::straight, ToothTips::relieved),
        drawn(example_drive("catalogue_size25"), ToothProfile::involute),
        drawn(example_drive("catalogue_size25"), ToothProfile::half_path)}) {
    const Sensitivity s = sensitivity_of(gear);
    EXPECT_TRUE(s.usable()) << s.unusable_because;
    EXPECT_LT(s.homogeneity_residual(), 1e-10);
  }
}

TEST(CoupledSensitivity, BehaviourWhatHasNoDerivativeIsListed) {
  const Sensitivity s = sensitivity_of(example_drive("cracked_size25"));
  std::vector<std::string> paths;
  for (const CurveStep& step : s.not_differentiated) paths.push_back(step.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"drive.ratio", "wave_generator.crack[0].position",
                                             "mesh.crack[0].position"}));
  for (const std::string& path : paths)
    EXPECT_EQ(std::ranges::find(s.no_influence, path), s.no_influence.end()) << path;
  // A drive without a coupled solution gives no such outputs, and a note names the missing fields.
  const Sensitivity article = sensitivity_of(example_drive("article"));
  EXPECT_TRUE(article.not_differentiated.empty());
  EXPECT_EQ(test::count_notes(article.notes, "curve.missing"), 1);
}

TEST(CoupledSensitivity, BehaviourScatterIsOfTheSumAlone) {
  GearSet gear = example_drive("catalogue_size25");
  InputScatter& scattered = gear.scatter.emplace_back();
  scattered.path = "flexspline.barrel.wall_thickness";
  scattered.relative_standard_deviation = 0.02;
  const Sensitivity s = sensitivity_of(gear);
  const Scatter scatter = scatter_of(gear, s, {.samples = 50, .threads = 1});
  ASSERT_FALSE(scatter.outputs.empty());
  for (std::size_t y = 0; y < scatter.outputs.size(); ++y)
    EXPECT_EQ(scatter.outputs[y].name, s.outputs[y].name);
  EXPECT_EQ(test::count_notes(scatter.notes, "scatter.sum_alone"), 1);
  // Outputs that are not drawn have neither a share in the CSV nor a table of their scatter.
  const SensitivityReport report{.sensitivity = s, .scatter = scatter};
  const std::string csv = sensitivity_csv(report);
  EXPECT_NE(csv.find("curve.intact.K1,flexspline.barrel.wall_thickness,"), std::string::npos);
  EXPECT_EQ(sensitivity_text(report, gear).find("Scatter of the outputs: K1"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

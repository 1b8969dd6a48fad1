// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/grow_cracks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/crack_sizes.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

GearSet shaft() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_shaft.toml"); }

GrowthOptions until_depth(double depth) {
  GrowthOptions options;
  options.rate.mixed_mode = MixedMode::richard;  // K_III alone gives K = K_III
  options.stop = {.time = {}, .cycles = {}, .crack = "output_shaft.crack[0]", .size = depth};
  return options;
}

TEST(GrowCracks, ReferenceSolidShaft) {  // GR-24
  // Solid shaft of 60 mm, torque 0 to 6000 N*m, Paris C 6.9e-12 and m 3 on K_III, from 0.5 mm:
  // cycles until a depth, and K_HD over that of the sound shaft, by an independent quadrature of
  // the handbook's K_III.  The digits of that table give 1e-5 and 1e-5.
  struct Row {
    double depth, cycles, stiffness, resonance;
  };
  constexpr std::array<Row, 6> kRows = {{{1e-3, 224990, -0.165e-2, 0.99917},
                                         {2e-3, 373060, -0.673e-2, 0.99663},
                                         {3e-3, 431413, -1.542e-2, 0.99226},
                                         {5e-3, 480034, -4.443e-2, 0.97753},
                                         {8e-3, 503699, -12.02e-2, 0.93799},
                                         {10e-3, 509168, -19.44e-2, 0.89757}}};
  GearSet gear = shaft();
  gear.material.at("steel").fracture_toughness.reset();  // the table has no fracture
  gear.material.at("steel").yield_strength.reset();
  gear.material.at("steel").ultimate_strength.reset();
  const double first = std::sqrt(1 - 0.041e-2);  // of the crack of 0.5 mm
  for (const Row& row : kRows) {
    const GrowthReport report = grow_cracks(gear, until_depth(row.depth));
    EXPECT_EQ(report.end, DriveEnd::until);
    test::expect_relative(report.repetitions, row.cycles, 1e-5);
    test::expect_relative(report.cracks[0].series.back().cycles, report.repetitions, 1e-12);
    test::expect_relative(report.cracks[0].series.back().size, row.depth, 1e-10);
    EXPECT_NEAR((1 + report.stiffness.back().change) * first * first - 1, row.stiffness, 1.5e-5);
    EXPECT_NEAR(report.stiffness.back().resonance * first, row.resonance, 1.5e-5);
    EXPECT_LT(report.step_error, 1e-7);
  }
}

/// Flat sheet of the flexspline with a crack at 45 degrees, and no wave: case P8.
GearSet sheet() {
  return read_gear_set(R"(
format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
[[material.steel.growth]]
kind = "paris"
coefficient = "6.9e-12 m"
exponent = 3
[drive]
ratio = 100
wave_number = 1
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "8000 N*m"
[flexspline]
material = "steel"
shape = "cylinder"
wall_thickness = "2.24 mm"
length = "160 mm"
[[flexspline.crack]]
kind = "through"
half_length = "2 mm"
angle = "45 deg"
shell_correction = false
[duty]
[[duty.block]]
duration = "1 s"
output_speed = "1 rpm"
torque = "8000 N*m"
[[duty.block]]
duration = "1 s"
output_speed = "1 rpm"
torque = "0 N*m"
)",
                       "sheet.toml");
}

TEST(GrowCracks, ReferenceThroughCrackOfSheet) {  // GR-21 to GR-25
  // Closed form: tau = T/(2 pi r^2 t) = 91.3541532 MPa opens the crack, K = tau sqrt(pi a), 2 to
  // 10 mm in 843 943.868 cycles; the stiffness of 6.1547e5 N*m/rad changes by -0.05375991 % if the
  // added compliance goes from 3.49578893e-11 to 8.73947231e-10 rad/(N*m).
  const GearSet gear = sheet();
  GrowthOptions options;
  options.stop = {.time = {}, .cycles = {}, .crack = "flexspline.crack[0]", .size = 10e-3};
  const GrowthReport report = grow_cracks(gear, options);
  EXPECT_EQ(report.end, DriveEnd::until);
  test::expect_relative(report.repetitions, 843943.868, 1e-8);
  const CrackGrowth& crack = report.cracks[0];
  test::expect_relative(crack.series.front().K_max, 91.3541532e6 * std::sqrt(pi * 2e-3), 1e-8);
  EXPECT_NEAR(crack.series.front().ratio, 0.0, 1e-12);
  EXPECT_EQ(crack.kink_angle.value_or(1), 0.0);
  const double added = 1 / report.stiffness.back().positive - 1 / report.stiffness.front().positive;
  test::expect_relative(added, 8.73947231e-10 - 3.49578893e-11, 1e-6);
}

}  // namespace
}  // namespace strainwave

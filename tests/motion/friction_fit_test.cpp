// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/friction_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kRunSpeed = 2000 * 2 * pi / 60;

/// A maker's four values at ratio 100, 20 °C and 2000 rpm: Schaeffler TPI 275, series RT1-H-CS, as
/// digitised in harmonic-drive-twin (catalogue.py, MIT).
struct MakersRow {
  int size;
  double no_load, starting, back_driving, efficiency, rated;
  [[nodiscard]] FrictionTargets targets() const {
    return {no_load, starting, back_driving, efficiency, kRunSpeed, rated};
  }
};
constexpr MakersRow kRows[] = {{14, 35e-3, 21e-3, 2.21, 0.67, 10},
                               {17, 51e-3, 29e-3, 3.06, 0.77, 31},
                               {20, 105e-3, 37e-3, 3.89, 0.77, 52},
                               {25, 195e-3, 69e-3, 7.26, 0.77, 87}};

/// A joint about as stiff and heavy as one of size 25.
Joint joint_of_size25(double ratio) {
  return {.ratio = ratio,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}},
          .damping = 10};
}

TEST(FrictionFit, ReferenceConstantsOfAMakersRow) {
  // (MO-41 to MO-43), by hand for size 25: viscous (195 - 69) mN*m over 2000 rpm; kappa_s =
  // 1 - 100*69e-3/7.26 = 0.04959; kappa_c = 1/0.77 - 1 - 0.195/0.87 = 0.07456.  Rounding.
  const FrictionFit fit = fit_friction(kRows[3].targets(), -100);
  test::expect_relative(fit.friction.breakaway, 69e-3, 1e-15);
  test::expect_relative(fit.friction.coulomb, 69e-3, 1e-15);
  test::expect_relative(fit.friction.viscous, 0.126 / kRunSpeed, 1e-13);
  test::expect_relative(fit.friction.load_breakaway.value(), 1 - 6.9 / 7.26, 1e-13);
  test::expect_relative(fit.friction.load_coulomb, 1 / 0.77 - 1 - 0.195 / 0.87, 1e-12);
  EXPECT_EQ(fit.ratio, 100);
}

TEST(FrictionFit, IdentityFourValuesReturn) {
  // (MO-41 to MO-43): the formulas return what was fitted, each within rounding.
  for (const MakersRow& row : kRows)
    for (const FrictionValue& value : fit_friction(row.targets(), 100).values)
      EXPECT_NEAR(value.residual(), 0.0, 1e-10) << row.size << " " << enum_name(value.quantity);
}

TEST(FrictionFit, CrosscheckFourValuesBySimulation) {
  // (MO-40 to MO-43): the bench knows only the equations of motion.  The tolerance of the steps
  // leaves 1e-7 in a run; a ramp adds 5e-4 by inertia and ends when the input has turned by ten
  // deflections of its bristles.
  for (const MakersRow& row : kRows)
    for (const double ratio : {100.0, -100.0}) {
      FrictionFit fit = fit_friction(row.targets(), ratio);
      measure(fit, joint_of_size25(ratio));
      EXPECT_TRUE(fit.converged);
      ASSERT_EQ(fit.values.size(), 4U);
      for (const FrictionValue& value : fit.values) {
        ASSERT_TRUE(value.simulated.has_value()) << value.reason;
        const bool run = value.quantity == FrictionQuantity::no_load_torque ||
                         value.quantity == FrictionQuantity::efficiency;
        EXPECT_NEAR(*value.error(), 0.0, run ? 1e-6 : 1e-3)
            << row.size << " " << enum_name(value.quantity);
      }
    }
}

TEST(FrictionFit, BehaviourAResidualIsNotHidden) {
  // (MO-42, MO-43): a back-driving torque below ratio times starting torque, and an efficiency
  // beyond what the no-load torque leaves, need a negative part of the load.
  FrictionTargets targets = kRows[3].targets();
  targets.back_driving_torque = 6.0;
  targets.efficiency = 0.85;
  FrictionFit fit = fit_friction(targets, 100);
  EXPECT_EQ(fit.friction.load_breakaway.value(), 0.0);
  EXPECT_EQ(fit.friction.load_coulomb, 0.0);
  test::expect_relative(fit.values[2].fitted, 6.9, 1e-13);
  test::expect_relative(fit.values[3].fitted, 0.87 / (0.87 + 0.195), 1e-12);
  EXPECT_NEAR(fit.values[0].residual(), 0.0, 1e-12);
  measure(fit, joint_of_size25(100));
  EXPECT_FALSE(fit.converged);
  // The bench returns the residual of the formula.
  EXPECT_NEAR(*fit.values[2].error(), 0.15, 1e-3);
  EXPECT_NEAR(*fit.values[3].error(), fit.values[3].residual(), 1e-8);
}

TEST(FrictionFit, LimitRunningBelowStarting) {
  // (MO-41): a no-load torque below the starting torque is Coulomb friction alone.
  FrictionTargets targets = kRows[3].targets();
  targets.no_load_torque = 50e-3;
  FrictionFit fit = fit_friction(targets, 100);
  EXPECT_EQ(fit.friction.coulomb, 50e-3);
  EXPECT_EQ(fit.friction.viscous, 0.0);
  measure(fit, joint_of_size25(100));
  EXPECT_TRUE(fit.converged);
  for (const FrictionValue& value : fit.values) EXPECT_NEAR(value.error().value(), 0.0, 1e-3);
}

TEST(FrictionFit, LimitADriveLocksItself) {
  // (MO-42): with kappa_s >= 1 no torque on the output turns the input.
  LuGre friction = fit_friction(kRows[3].targets(), 100).friction;
  friction.load_breakaway = 1.0;
  const std::vector<double> values = four_values(friction, 100, kRows[3].targets());
  EXPECT_TRUE(std::isinf(values[2]));
  friction.load_breakaway.reset();  // then that of the turning input counts
  test::expect_relative(four_values(friction, 100, kRows[3].targets())[2],
                        6.9 / (1 - friction.load_coulomb), 1e-13);
}

TEST(FrictionFit, IdentityWhatTheBenchLeavesOut) {
  // Cracks, kinematic error, gravity and the damping of motor and load do not change the values.
  Joint joint = joint_of_size25(100);
  FrictionFit plain = fit_friction(kRows[3].targets(), 100);
  FrictionFit full = plain;
  measure(plain, joint);
  joint.kinematic_error = {{{2, 1e-4, 0.0}}};
  joint.cracks = {{.compliance = 1e-6}};
  joint.gravity_torque = 30;
  joint.input_damping = 1e-3;
  joint.output_damping = 5;
  joint.output_torque = {.value = {4.0}};
  joint.output_speed = Profile{.value = {1.0}};
  measure(full, joint);
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_EQ(full.values[n].simulated.value(), plain.values[n].simulated.value());
}

TEST(FrictionFit, InputEachNumber) {
  const auto refused = [](auto change) {
    FrictionTargets targets = kRows[3].targets();
    double ratio = 100;
    FrictionAssumptions assumed;
    change(targets, ratio, assumed);
    return test::broken_rule([&] { (void)fit_friction(targets, ratio, assumed); });
  };
  using T = FrictionTargets&;
  using A = FrictionAssumptions&;
  EXPECT_EQ(refused([](T t, double&, A) { t.no_load_torque = 0; }),
            "no_load_torque = 0 N*m violates: > 0");
  EXPECT_EQ(refused([](T t, double&, A) { t.starting_torque = -1; }),
            "starting_torque = -1 N*m violates: > 0");
  EXPECT_EQ(refused([](T t, double&, A) { t.back_driving_torque = 0; }),
            "back_driving_torque = 0 N*m violates: > 0");
  EXPECT_EQ(refused([](T t, double&, A) { t.efficiency = 1; }),
            "efficiency = 1 violates: > 0 and < 1");
  EXPECT_EQ(refused([](T t, double&, A) { t.efficiency = 0; }),
            "efficiency = 0 violates: > 0 and < 1");
  EXPECT_EQ(refused([](T t, double&, A) { t.speed = 0; }), "at_speed = 0 rad/s violates: > 0");
  EXPECT_EQ(refused([](T t, double&, A) { t.torque = 0; }), "at_torque = 0 N*m violates: > 0");
  EXPECT_EQ(refused([](T, double& i, A) { i = 0; }), "ratio = 0 violates: not 0");
  EXPECT_EQ(refused([](T, double&, A a) { a.breakaway_deflection = 0; }),
            "breakaway_deflection = 0 rad violates: > 0");
  EXPECT_EQ(refused([](T t, double&, A) { t.speed = 9; }),
            "at_speed = 9 rad/s violates: at least five times the Stribeck speed, which is assumed "
            "to be 2 rad/s");
  EXPECT_EQ(refused([](T, double&, A a) { a.stribeck_speed = 0; }),
            "stribeck_speed = 0 rad/s violates: > 0");
}

}  // namespace
}  // namespace strainwave

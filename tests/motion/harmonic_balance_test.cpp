// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/harmonic_balance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/dynamics/torsional_chain.hpp"
#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A load on a spring behind a free input: frequency of small vibrations 50.3 Hz for K = 5e4.
Joint joint_with(const Spring& spring) {
  return {.ratio = -100, .input_inertia = 1e-4, .output_inertia = 1, .spring = spring};
}

std::vector<double> rising_amplitudes(double from, double to, int count) {
  std::vector<double> values;
  for (int n = 0; n < count; ++n) values.push_back(from + (to - from) * n / (count - 1));
  return values;
}

BackboneSettings undamped(std::vector<double> amplitudes, VibratingInput input, int harmonics = 9,
                          double load_torque = 0.0) {
  return {.balance = {.input = input, .load_torque = load_torque, .harmonics = harmonics},
          .amplitudes = std::move(amplitudes)};
}

TEST(HarmonicBalance, ReferenceBackboneOfACubicSpring) {
  // (MO-16): Duffing: T = 4 K(m)/sqrt(w0^2 + b A^2), m = b A^2/(2 (w0^2 + b A^2)); 9 harmonics
  // leave less than 5e-8.
  const double K3 = 1e10;
  const double inertia = 1.0 / 2.0;  // of two ends of 1 kg*m^2
  const Backbone curve =
      backbone(joint_with(CubicSpring{5e4, K3}),
               undamped(rising_amplitudes(1e-4, 5e-3, 60), VibratingInput::free));
  ASSERT_TRUE(curve.converged) << curve.reason;
  ASSERT_EQ(curve.points.size(), 60U);
  for (const BackbonePoint& at : curve.points) {
    const double bent = K3 / inertia * at.amplitude * at.amplitude;
    const double square = 5e4 / inertia + bent;
    const double modulus = std::sqrt(bent / (2 * square));
    test::expect_relative(at.frequency, std::sqrt(square) / (4 * boost::math::ellint_1(modulus)),
                          5e-8);
    test::expect_relative(at.torque, 5e4 * at.amplitude + K3 * std::pow(at.amplitude, 3), 1e-9);
    EXPECT_EQ(at.damping_ratio, 0.0);
    EXPECT_LT(at.truncation, 1e-6);
  }
}

TEST(HarmonicBalance, ReferenceBilinearSpring) {
  // (MO-5, MO-16): T = pi (1/w1 + 1/w2); the shifts for K- = .98, .9, .5 K+.  Harmonics beyond the
  // 40th change the frequency by less than 1e-7.
  for (const auto& [r, shift] :
       {std::pair{0.98, -0.0050506}, {0.9, -0.0263340}, {0.5, -0.1715729}}) {
    Joint joint = joint_with(LinearSpring{5e4});
    joint.cracks = {{.compliance = (1 / r - 1) / 5e4, .sense = OpeningSense::negative}};
    const Backbone curve = backbone(joint, undamped({1e-5, 1e-3}, VibratingInput::locked, 40));
    ASSERT_TRUE(curve.converged) << curve.reason;
    const double f0 = std::sqrt(5e4) / (2 * pi);
    for (const BackbonePoint& at : curve.points) {
      EXPECT_NEAR(at.frequency / f0 - 1, shift, 1e-7);
      test::expect_relative(at.frequency / f0, 2 * std::sqrt(r) / (1 + std::sqrt(r)), 3e-8);
    }
  }
}

TEST(HarmonicBalance, ReferenceSmallVibrationsOfABilinearSpring) {
  // (MO-16): about torque 0 the period is pi (1/w1 + 1/w2) for a crack of either sense, also with
  // the hysteresis as a spring beside both.  Under a torque one sense holds.  The tolerance is that
  // of rounding.
  for (const double beside : {0.0, 2e4})
    for (const OpeningSense sense : {OpeningSense::positive, OpeningSense::negative}) {
      Joint joint = joint_with(LinearSpring{5e4});
      joint.cracks = {{.compliance = 1 / 5e4, .sense = sense}};
      if (beside > 0) joint.slip_elements = {{.stiffness = beside, .limit = 1}};
      const double whole = std::sqrt(5e4 + beside);
      const double cracked = std::sqrt(2.5e4 + beside);
      const auto small = [&](double load_torque) {
        return small_frequency(
            joint, {.input = VibratingInput::locked, .load_torque = load_torque, .harmonics = 9});
      };
      test::expect_relative(small(0.0), 1 / (pi / whole + pi / cracked), 1e-14);
      const double open = sense == OpeningSense::positive ? -1.0 : 1.0;  // external torque
      test::expect_relative(small(open), cracked / (2 * pi), 1e-14);
      test::expect_relative(small(-open), whole / (2 * pi), 1e-14);
    }
}

TEST(HarmonicBalance, ReferenceSmallVibrationsWhereTwoLinesMeet) {
  // (MO-16): about a load of T1 or T2 the spring has another stiffness on each side, whatever
  // rounding says.  The tolerance is that of rounding.
  const CatalogueSpring spring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  const Joint joint = joint_with(spring);
  for (const std::size_t line : {0U, 1U})
    for (const double sense : {1.0, -1.0}) {
      const BalanceSettings about{.input = VibratingInput::locked,
                                  .load_torque = sense * spring.torque[line],
                                  .harmonics = 9};
      const double below = std::sqrt(spring.stiffness[line]);
      const double above = std::sqrt(spring.stiffness[line + 1]);
      test::expect_relative(small_frequency(joint, about), 1 / (pi / below + pi / above), 1e-14);
    }
}

TEST(HarmonicBalance, ConvergenceOfABilinearSpringOverTheHarmonics) {
  // (MO-15): the error of the frequency falls at least with the fourth power of the harmonics.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.cracks = {{.compliance = 1 / 5e4, .sense = OpeningSense::negative}};
  const double exact = std::sqrt(5e4) / (2 * pi) * 2 * std::sqrt(0.5) / (1 + std::sqrt(0.5));
  std::vector<double> errors;
  for (const int harmonics : {4, 8, 16}) {
    const Backbone curve = backbone(joint, undamped({1e-3}, VibratingInput::locked, harmonics));
    ASSERT_TRUE(curve.converged) << curve.reason;
    errors.push_back(std::abs(curve.points[0].frequency / exact - 1));
  }
  EXPECT_LT(errors[1], errors[0] / 16);
  EXPECT_LT(errors[2], errors[1] / 16);
}

TEST(HarmonicBalance, ReferencePeriodOfTheMakersThreePieces) {
  // (MO-2, MO-16): period of each piece by an arc sine, growth by amplitude; also about a mean
  // torque of 30 N*m.  60 harmonics leave 1e-7.
  const CatalogueSpring spring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  for (const double mean : {0.0, 30.0})
    for (const double amplitude : {2e-4, 1e-3, 2.2e-3}) {
      const Backbone curve =
          backbone(joint_with(spring), undamped({amplitude}, VibratingInput::locked, 60, -mean));
      ASSERT_TRUE(curve.converged) << curve.reason;
      const BackbonePoint& at = curve.points[0];
      // The extremes of the twist lie at equal energy: V(high) - M high = V(low) - M low.
      double high = 0.0;
      double low = 0.0;
      const auto potential = [&](double twist) { return spring.energy(twist) - mean * twist; };
      double first = 0.0;
      double last = 4e-3;
      for (int i = 0; i < 200; ++i) {
        const double middle = (first + last) / 2;
        high = middle;
        low = middle - 2 * amplitude;
        (potential(high) > potential(low) ? last : first) = middle;
      }
      const double energy = potential(high);
      std::vector<double> ends = {low, high};
      for (const double corner : {14 / 3.1e4, 14 / 3.1e4 + 34 / 5e4})
        for (const double twist : {-corner, corner})
          if (twist > low && twist < high) ends.push_back(twist);
      std::ranges::sort(ends);
      double half = 0.0;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        // In a piece: J phi'' = M - T(m) - k (phi - m), an arc of a sine.
        const double m = (ends[i] + ends[i + 1]) / 2;
        const double k = spring.tangent(m);
        const double centre = m + (mean - spring.in_series(m, 0.0).torque) / k;
        const double speed_square = 2 * (energy - potential(m));
        const double reach = std::sqrt(speed_square / k + (m - centre) * (m - centre));
        const auto phase = [&](double twist) {
          return std::asin(std::clamp((twist - centre) / reach, -1.0, 1.0));
        };
        half += (phase(ends[i + 1]) - phase(ends[i])) / std::sqrt(k);
      }
      test::expect_relative(at.frequency, 1 / (2 * half), 1e-7);
      EXPECT_NEAR(at.torque,
                  (spring.in_series(high, 0.0).torque - spring.in_series(low, 0.0).torque) / 2,
                  1e-5);
    }
}

TEST(HarmonicBalance, LimitLinearJointAnswersAsTheChain) {
  // (DY-6, MO-15): a linear joint with damping at three places against the response of a chain, at
  // both ends, free and locked; rounding.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.damping = 10;
  joint.input_damping = 2e-3;
  joint.output_damping = 5;
  const TorsionalChain chain{.inertias = {{"motor", 1e-4, 2e-3}, {"load", 1.0, 5.0}},
                             .springs = {{"drive", 1 / 5e4, 10, {1 / -100.0, -1.0}}}};
  for (const VibratingInput input : {VibratingInput::free, VibratingInput::locked})
    for (const JointEnd end : {JointEnd::motor, JointEnd::load}) {
      if (input == VibratingInput::locked && end == JointEnd::motor) continue;
      const double torque = end == JointEnd::motor ? 0.05 : 5.0;
      const ResponseSettings settings{.balance = {.input = input, .harmonics = 3},
                                      .excited = end,
                                      .excitation = torque,
                                      .from = 20,
                                      .to = 90};
      const ForcedResponse curve = forced_response(joint, settings);
      ASSERT_TRUE(curve.converged) << curve.reason;
      EXPECT_GT(curve.points.size(), 30U);
      EXPECT_TRUE(curve.folds.empty());
      EXPECT_EQ(curve.points.front().frequency, 20.0);
      EXPECT_DOUBLE_EQ(curve.points.back().frequency, 90.0);
      const std::vector<std::size_t> held = input == VibratingInput::locked
                                                ? std::vector<std::size_t>{0}
                                                : std::vector<std::size_t>{};
      for (const ResponsePoint& at : curve.points) {
        const ChainResponse linear =
            torque_response(chain, end == JointEnd::motor ? 0 : 1, at.frequency, held);
        const std::complex<double> output = torque * linear[1];
        const std::complex<double> twist = torque * (linear[0] / -100.0 - linear[1]);
        test::expect_relative(at.output, std::abs(output), 1e-9);
        EXPECT_NEAR(std::abs(std::polar(1.0, -at.lag) - output / std::abs(output)), 0.0, 1e-9);
        EXPECT_NEAR(std::abs(std::complex(at.twist[1], -at.twist[2]) - twist), 0.0,
                    1e-9 * std::abs(twist));
        test::expect_relative(at.amplitude, std::abs(twist), 1e-9);
        EXPECT_TRUE(at.stable);
        EXPECT_LT(at.truncation, 1e-25);
      }
    }
}

TEST(HarmonicBalance, ReferenceMultipliersOfALinearJoint) {
  // (MO-19): exp(lambda T) with the roots lambda of J s^2 + c s + K, in closed form.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.damping = 40;
  const ForcedResponse curve =
      forced_response(joint, {.excitation = 5, .from = 30, .to = 70, .largest_step = 0.5});
  for (const ResponsePoint& at : curve.points) {
    const std::complex<double> root(-40 / (2 * 0.5), std::sqrt(5e4 / 0.5 - 1600));
    const std::complex<double> expected = std::exp(root / at.frequency);
    ASSERT_EQ(at.multipliers.size(), 2U);
    test::expect_relative(at.multiplier, std::abs(expected), 1e-10);
    EXPECT_NEAR(std::abs(at.multipliers[0].imag()), std::abs(expected.imag()), 1e-9);
    EXPECT_NEAR(at.multipliers[0].real(), expected.real(), 1e-9);
  }
}

TEST(HarmonicBalance, IdentityMultipliersOfTwoDampedEnds) {
  // (MO-19): with damping of an end to the ground the common speed is a state of its own; the
  // product of the multipliers is exp(T times the trace of the rates), by Liouville.
  for (const bool input : {true, false}) {
    Joint joint = joint_with(LinearSpring{5e4});
    joint.damping = 10;
    (input ? joint.input_damping : joint.output_damping) = input ? 2e-3 : 0.8;
    const ForcedResponse curve = forced_response(
        joint, {.balance = {.harmonics = 2}, .excitation = 5, .from = 30, .to = 40});
    for (const ResponsePoint& at : curve.points) {
      ASSERT_EQ(at.multipliers.size(), 3U);
      const double trace =
          joint.input_damping / 1e-4 + 10.0 / (1e4 * 1e-4) + (joint.output_damping + 10) / 1.0;
      const std::complex<double> product =
          at.multipliers[0] * at.multipliers[1] * at.multipliers[2];
      test::expect_relative(product.real(), std::exp(-trace / at.frequency), 1e-9);
      EXPECT_TRUE(at.stable);
    }
  }
}

TEST(HarmonicBalance, IdentityFewAmplitudesLeadToTheSameVibration) {
  // (MO-17): two amplitudes with a factor of 5000 between them lead to the vibration of many small
  // steps; a step that fails is halved.
  Joint joint = joint_with(CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}});
  joint.hysteresis = dahl(1e5, 3);
  joint.cracks = {{.compliance = 2e-5, .sense = OpeningSense::positive}};
  std::vector<double> many;
  for (int n = 0; n < 100; ++n) many.push_back(1e-6 * std::pow(5000.0, n / 99.0));
  for (const BackboneKind kind : {BackboneKind::undamped, BackboneKind::quadrature}) {
    const Backbone few = backbone(joint, {.kind = kind, .amplitudes = {many.front(), many.back()}});
    const Backbone fine = backbone(joint, {.kind = kind, .amplitudes = many});
    ASSERT_TRUE(few.converged) << few.reason;
    ASSERT_TRUE(fine.converged) << fine.reason;
    test::expect_relative(few.points.back().frequency, fine.points.back().frequency, 1e-8);
    test::expect_relative(few.points.back().torque, fine.points.back().torque, 1e-8);
  }
}

TEST(HarmonicBalance, LimitQuadratureOfALinearJoint) {
  // (MO-17): the twist of a linear joint is a quarter of a period behind the torque on it at the
  // natural frequency, with zeta = c/(2 J w); rounding.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.damping = 40;
  for (const JointEnd end : {JointEnd::motor, JointEnd::load}) {
    const Backbone curve = backbone(
        joint,
        {.kind = BackboneKind::quadrature, .excited = end, .amplitudes = {1e-5, 1e-4, 1e-3}});
    ASSERT_TRUE(curve.converged) << curve.reason;
    const double omega = std::sqrt(5e4 / 0.5);
    for (const BackbonePoint& at : curve.points) {
      test::expect_relative(at.frequency, omega / (2 * pi), 1e-9);
      test::expect_relative(at.damping_ratio, 40 / (2 * 0.5 * omega), 1e-9);
      // Half of a torque on the load acts on the twist; at the motor it counts 100 times.
      const double on_twist = 40 * omega * at.amplitude;
      test::expect_relative(at.excitation, on_twist * (end == JointEnd::load ? 2 : 0.02), 1e-9);
    }
  }
}

/// Joint of the tests of hysteresis.
Joint with_loop(double damping = 5.0) {
  Joint joint = joint_with(LinearSpring{5e4});
  joint.hysteresis = dahl(5e4, 3);
  joint.damping = damping;
  return joint;
}

TEST(HarmonicBalance, ReferenceQuadratureOfADahlLoopByOneHarmonic) {
  // (MO-9, MO-17): with one harmonic the work of the loop gives zeta = W/(2 pi J w^2 X^2), with W
  // in closed form; and the torque of the excitation is W/(pi X).
  Joint joint = with_loop(0.0);
  const Backbone curve = backbone(joint, {.balance = {.harmonics = 1},
                                          .kind = BackboneKind::quadrature,
                                          .amplitudes = {1e-6, 3e-5, 1e-4, 2e-3}});
  ASSERT_TRUE(curve.converged) << curve.reason;
  for (const BackbonePoint& at : curve.points) {
    const double q = 5e4 * at.amplitude / 3;
    const double work = 4 * 3 * at.amplitude * (1 - std::tanh(q) / q);
    const double omega = 2 * pi * at.frequency;
    test::expect_relative(at.damping_ratio,
                          work / (2 * pi * 0.5 * omega * omega * at.amplitude * at.amplitude),
                          1e-8);
    test::expect_relative(at.torque, 5e4 * at.amplitude + 3 * std::tanh(q), 1e-10);
  }
  // Small loops are springs of the stiffness A, wide ones fall to the spring alone.
  test::expect_relative(curve.points.front().frequency, small_frequency(joint, {}), 1e-2);
  test::expect_relative(small_frequency(joint, {}), std::sqrt(1e5 / 0.5) / (2 * pi), 1e-14);
  EXPECT_LT(curve.points.back().frequency, 1.03 * std::sqrt(5e4 / 0.5) / (2 * pi));
}

/// An excitation for `simulate`: a cosine by straight lines.
Profile cosine(double mean, double amplitude, double frequency, double duration, int per_period) {
  Profile made{.time = {}, .value = {}};
  const int points = static_cast<int>(std::ceil(duration * frequency * per_period)) + 2;
  // Lines between the points have a first harmonic that is smaller by the square of a sinc.
  const double half = pi / per_period;
  const double lines = std::pow(std::sin(half) / half, 2);
  for (int n = 0; n < points; ++n) {
    made.time.push_back(n / (frequency * per_period));
    made.value.push_back(mean + amplitude / lines * std::cos(2 * pi * n / per_period));
  }
  return made;
}

TEST(HarmonicBalance, CrosscheckResponseRepeatsInTime) {
  // (MO-13, MO-15): a response with corners, a crack, hysteresis and damping at three places
  // returns to its start in a simulated period; 60 harmonics leave 1e-6 of the amplitude.
  Joint joint = joint_with(CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}});
  joint.hysteresis = dahl(1e5, 3);
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.output_damping = 0.5;
  joint.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
  for (const JointEnd end : {JointEnd::load, JointEnd::motor}) {
    const ResponseSettings settings{.balance = {.load_torque = -12, .harmonics = 60},
                                    .excited = end,
                                    .excitation = end == JointEnd::load ? 8.0 : 0.08,
                                    .from = 35,
                                    .to = 36};
    const ForcedResponse curve = forced_response(joint, settings);
    ASSERT_TRUE(curve.converged) << curve.reason;
    const ResponsePoint& at = curve.points.back();
    const double period = 1 / at.frequency;
    Joint moving = joint;
    const Profile of_excitation = cosine(0.0, settings.excitation, at.frequency, period, 4000);
    moving.output_torque = {.value = {-12.0}};
    moving.input = GivenTorque{{.value = {-12.0 / 100}}};  // the mean torque 12 over the ratio -100
    if (end == JointEnd::load) {
      moving.output_torque = of_excitation;
      for (double& value : moving.output_torque.value) value -= 12;
    } else {
      Profile motor = of_excitation;
      for (double& value : motor.value) value -= 0.12;
      moving.input = GivenTorque{std::move(motor)};
    }
    const JointState start = state_on_response(joint, settings, at);
    const Motion motion =
        simulate(moving, start, {.duration = period, .output_step = period, .tolerance = 1e-13});
    ASSERT_TRUE(motion.converged) << motion.reason;
    const auto twist = [](const JointState& s) { return s.input_angle / -100 - s.output_angle; };
    EXPECT_NEAR(twist(motion.last), twist(start), 2e-6 * at.amplitude);
    const double speed = 2 * pi * at.frequency * at.amplitude;
    EXPECT_NEAR(motion.last.output_speed, start.output_speed, 2e-5 * speed);
    EXPECT_NEAR(motion.last.input_speed, start.input_speed, 2e-5 * 100 * speed);
    EXPECT_NEAR(motion.last.hysteresis, start.hysteresis, 2e-5);
  }
}

/// A locked joint with slip elements: one that slips early, one late, one never.
Joint with_elements(double damping = 3.0) {
  Joint joint = joint_with(LinearSpring{5e4});
  joint.slip_elements = {{3e4, 1.0}, {2e4, 4.0}, {1e4, 100.0}};
  joint.damping = damping;
  return joint;
}

/// Harmonic of one slip element under X cos tau, by (MO-47): cosine and sine of the torque.
std::pair<double, double> of_element(const SlipElement& element, double X) {
  const double most = element.stiffness * X;
  if (element.limit >= most) return {most, 0.0};
  const double theta = std::acos(1 - 2 * element.limit / most);
  const double sine = std::sin(theta);
  return {most / pi * (theta - sine * std::cos(theta)), -most / pi * sine * sine};
}

TEST(HarmonicBalance, ReferenceResonanceWithSlipElements) {
  // (MO-17, MO-44, MO-45, MO-47): with one harmonic, J w^2 = K + sum a/X with the cosines a of the
  // elements in closed form, and zeta = (W + pi c w X^2)/(2 pi J w^2 X^2) with the work W.
  const Joint joint = with_elements();
  const std::vector<double> amplitudes = {1e-6, 3e-5, 3.5e-5, 1e-4, 2.1e-4, 1e-3};
  const Backbone curve = backbone(
      joint,
      {.balance = {.harmonics = 1}, .kind = BackboneKind::quadrature, .amplitudes = amplitudes});
  ASSERT_TRUE(curve.converged) << curve.reason;
  for (const BackbonePoint& at : curve.points) {
    const double X = at.amplitude;
    double stiffness = 5e4;
    double work = 0.0;
    double torque = 5e4 * X;
    for (const SlipElement& of : joint.slip_elements) {
      stiffness += of_element(of, X).first / X;
      torque += std::min(of.stiffness * X, of.limit);
      if (of.limit < of.stiffness * X) work += 4 * of.limit * (X - of.limit / of.stiffness);
    }
    const double omega = std::sqrt(stiffness / 0.5);
    test::expect_relative(at.frequency, omega / (2 * pi), 1e-9);
    test::expect_relative(at.torque, torque, 1e-10);
    test::expect_relative(at.damping_ratio,
                          (work + pi * 3 * omega * X * X) / (2 * pi * stiffness * X * X), 1e-8);
  }
  test::expect_relative(small_frequency(joint, {}), std::sqrt(1.1e5 / 0.5) / (2 * pi), 1e-14);
  test::expect_relative(curve.points.front().frequency, small_frequency(joint, {}), 1e-10);
}

TEST(HarmonicBalance, ReferenceResponseWithSlipElements) {
  // (MO-18, MO-47): with one harmonic and a locked input, P^2 = ((K - J w^2) X + a)^2 +
  // (c w X - b)^2 with the harmonics a, b of the elements in closed form, on both sides of the
  // corners at which an element begins to slip.
  const Joint joint = with_elements();
  for (const double excitation : {0.5, 2.0, 8.0}) {
    const ForcedResponse curve =
        forced_response(joint, {.balance = {.input = VibratingInput::locked, .harmonics = 1},
                                .excitation = excitation,
                                .from = 25,
                                .to = 75});
    ASSERT_TRUE(curve.converged) << curve.reason;
    int slipping = 0;
    for (const ResponsePoint& at : curve.points) {
      const double X = at.amplitude;
      const double omega = 2 * pi * at.frequency;
      double cosine = (5e4 - omega * omega) * X;
      double sine = -3 * omega * X;
      for (const SlipElement& of : joint.slip_elements) {
        const auto [a, b] = of_element(of, X);
        cosine += a;
        sine += b;
        slipping += of.limit < of.stiffness * X ? 1 : 0;
      }
      test::expect_relative(std::hypot(cosine, sine), excitation, 1e-7);
      EXPECT_TRUE(at.stable);
    }
    EXPECT_GT(slipping, 0);
    EXPECT_LT(slipping, 2 * static_cast<int>(curve.points.size()));
  }
}

TEST(HarmonicBalance, ConvergenceOfManySlipElementsToDahl) {
  // (MO-9, MO-44): in a loop of amplitude X, Dahl's torque behind a turn is 2 f(d/2) with
  // f(x) = (F + F tanh q)/2 (1 - exp(-2 s x/F)) and q = s X/F.  Elements whose first loading is a
  // polygon on f give a resonance that tends to Dahl's with the square of their number.
  const double s = 1e5;
  const double F = 3.0;
  const double X = 4.5e-5;
  Joint smooth = joint_with(LinearSpring{5e4});
  smooth.hysteresis = dahl(s, F);
  const auto resonance = [&](const Joint& joint) {
    const Backbone curve = backbone(joint, {.kind = BackboneKind::quadrature, .amplitudes = {X}});
    EXPECT_TRUE(curve.converged) << curve.reason;
    return curve.points.at(0);
  };
  const BackbonePoint exact = resonance(smooth);
  const auto first_loading = [&](double x) {
    return F / 2 * (1 + std::tanh(s * X / F)) * -std::expm1(-2 * s * x / F);
  };
  std::vector<double> of_frequency;
  std::vector<double> of_damping;
  for (const int count : {16, 32, 64}) {
    Joint joint = joint_with(LinearSpring{5e4});
    const double h = X / count;
    double next_slope = 0.0;
    for (int n = count; n >= 1; --n) {
      const double slope = (first_loading(n * h) - first_loading((n - 1) * h)) / h;
      joint.slip_elements.push_back({slope - next_slope, (slope - next_slope) * n * h});
      next_slope = slope;
    }
    const BackbonePoint at = resonance(joint);
    of_frequency.push_back(std::abs(at.frequency / exact.frequency - 1));
    of_damping.push_back(std::abs(at.damping_ratio / exact.damping_ratio - 1));
    test::expect_relative(at.torque, exact.torque, 1e-9);
  }
  for (const std::size_t n : {1U, 2U}) {
    EXPECT_NEAR(of_frequency[n - 1] / of_frequency[n], 4.0, 0.3) << of_frequency[n];
    EXPECT_NEAR(of_damping[n - 1] / of_damping[n], 4.0, 0.3) << of_damping[n];
  }
  EXPECT_LT(of_damping[2], 1e-2);
}

TEST(HarmonicBalance, CrosscheckSlipElementsRepeatInTime) {
  // (MO-13, MO-15, MO-44): as above with slip elements; each torque of them returns to its start.
  Joint joint = joint_with(CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}});
  joint.slip_elements = {{3e4, 1.0}, {2e4, 4.0}, {1e4, 100.0}};
  joint.damping = 10;
  joint.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
  const ResponseSettings settings{
      .balance = {.load_torque = -12, .harmonics = 60}, .excitation = 8.0, .from = 35, .to = 36};
  const ForcedResponse curve = forced_response(joint, settings);
  ASSERT_TRUE(curve.converged) << curve.reason;
  const ResponsePoint& at = curve.points.back();
  EXPECT_TRUE(at.stable);
  const double period = 1 / at.frequency;
  Joint moving = joint;
  moving.output_torque = cosine(-12.0, settings.excitation, at.frequency, period, 4000);
  moving.input = GivenTorque{{.value = {-12.0 / 100}}};
  const JointState start = state_on_response(joint, settings, at);
  ASSERT_TRUE(start.slip);
  const Motion motion =
      simulate(moving, start, {.duration = period, .output_step = period, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  const auto twist = [](const JointState& s) { return s.input_angle / -100 - s.output_angle; };
  EXPECT_NEAR(twist(motion.last), twist(start), 2e-6 * at.amplitude);
  const double speed = 2 * pi * at.frequency * at.amplitude;
  EXPECT_NEAR(motion.last.output_speed, start.output_speed, 2e-5 * speed);
  ASSERT_TRUE(motion.last.slip);
  const SlipState end = slip_after(joint.slip_elements, *motion.last.slip, twist(motion.last));
  for (std::size_t j = 0; j < end.torque.size(); ++j)
    EXPECT_NEAR(end.torque[j], start.slip->torque[j], 2e-5) << j;
}

/// A table that stiffens and moves with the input, at the output.
std::shared_ptr<const EnergyTable> moving_table() {
  const std::vector<double> torques = {-100, -40, -15, -4, 4, 15, 40, 100};
  EnergySamples samples{.rate = 1.3, .period = 0.7, .energy = {}, .twist = {}, .compliance = {}};
  for (int q = 0; q < 12; ++q) {
    const double wave = std::cos(2 * pi * q / 12);
    std::vector<double> twist;
    for (const double T : torques)
      twist.push_back(3e-5 * T / (1 + std::abs(T) / 300) + wave * (2e-7 * T + 1e-5));
    const std::vector<double> slopes = rising_slopes(torques, twist);
    samples.energy.push_back(1e-4 + 1e-4 * wave);
    samples.twist.insert(samples.twist.end(), twist.begin(), twist.end());
    samples.compliance.insert(samples.compliance.end(), slopes.begin(), slopes.end());
  }
  return std::make_shared<const EnergyTable>(torques, std::vector{samples}, 4e-6);
}

TEST(HarmonicBalance, CrosscheckTableOfALockedInputRepeatsInTime) {
  // (MO-13, MO-25, MO-28): a response about a load, of a locked input on the curve of a table with
  // a crack and slip elements, returns to its start in a simulated period; 60 harmonics leave 1e-6
  // of the amplitude.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.table = moving_table();
  joint.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
  joint.slip_elements = {{1e4, 1.0}};
  joint.damping = 10;
  const ResponseSettings settings{
      .balance = {.input = VibratingInput::locked, .load_torque = -3, .harmonics = 60},
      .excitation = 8.0,
      .from = 20,
      .to = 21};
  const ForcedResponse curve = forced_response(joint, settings);
  ASSERT_TRUE(curve.converged) << curve.reason;
  const ResponsePoint& at = curve.points.back();
  const double period = 1 / at.frequency;
  Joint moving = joint;
  moving.output_torque = cosine(-3.0, settings.excitation, at.frequency, period, 4000);
  moving.input = GivenSpeed{{.value = {0.0}}};
  const JointState start = state_on_response(joint, settings, at);
  const Motion motion =
      simulate(moving, start, {.duration = period, .output_step = period, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_NEAR(motion.last.output_angle, start.output_angle, 2e-6 * at.amplitude);
  const double speed = 2 * pi * at.frequency * at.amplitude;
  EXPECT_NEAR(motion.last.output_speed, start.output_speed, 2e-5 * speed);
}

TEST(HarmonicBalance, LimitSmallVibrationsOnATable) {
  // (MO-16, MO-28): small vibrations about a load have the tangent of the table there, with the
  // torque -T_0; and the twist at rest is that of the table.
  Joint joint = joint_with(LinearSpring{5e4});
  joint.table = moving_table();
  const EnergyTable::At at = joint.table->at(0.0).at_torque(-20.0);
  const double expected = std::sqrt(1 / at.compliance / 0.5) / (2 * pi);
  const BalanceSettings balance{.load_torque = 20};
  test::expect_relative(small_frequency(joint, balance), expected, 1e-12);
  const Backbone curve = backbone(joint, {.balance = balance, .amplitudes = {1e-7, 1e-6}});
  ASSERT_TRUE(curve.converged) << curve.reason;
  // The curve bends, which counts with the square of the amplitude.
  test::expect_relative(curve.points[0].frequency, expected, 1e-6);
  test::expect_relative(twist_at_rest(joint, 20), at.twist, 1e-13);
}

/// A hard spring behind a locked input, whose response has two folds.
Joint hard_joint() {
  Joint joint = joint_with(CubicSpring{5e4, 2e10});
  joint.damping = 12;
  return joint;
}
ResponseSettings hard_settings(int harmonics) {
  return {.balance = {.input = VibratingInput::locked, .harmonics = harmonics},
          .excitation = 8,
          .from = 25,
          .to = 75};
}

TEST(HarmonicBalance, ReferenceFoldsOfOneHarmonic) {
  // (MO-18): with one harmonic, (p^2 + (c w)^2) a^2 = F^2 with p = K - J w^2 + 3 K3 a^2/4, and a
  // vertical tangent where p (p + 3 K3 a^2/2) + (c w)^2 = 0.
  const ForcedResponse curve = forced_response(hard_joint(), hard_settings(1));
  ASSERT_TRUE(curve.converged) << curve.reason;
  ASSERT_EQ(curve.folds.size(), 2U);
  EXPECT_TRUE(curve.folds[0].rising);
  EXPECT_FALSE(curve.folds[1].rising);
  EXPECT_GT(curve.folds[0].frequency, curve.folds[1].frequency);
  for (const Fold& fold : curve.folds) {
    const double omega = 2 * pi * fold.frequency;
    const double a = fold.amplitude;
    const double bent = 0.75 * 2e10 * a * a;
    const double p = 5e4 - omega * omega + bent;
    const double loss = 12 * omega;
    test::expect_relative((p * p + loss * loss) * a * a, 64.0, 1e-7);
    EXPECT_NEAR((p * (p + 2 * bent) + loss * loss) / (loss * loss), 0.0, 1e-6);
  }
}

TEST(HarmonicBalance, IdentityStabilityChangesAtTheFolds) {
  // (MO-18, MO-19): a multiplier passes 1 where the curve turns; the product of the multipliers is
  // exp(-c T/J) everywhere, by Liouville.
  const ForcedResponse curve = forced_response(hard_joint(), hard_settings(9));
  ASSERT_TRUE(curve.converged) << curve.reason;
  ASSERT_EQ(curve.folds.size(), 2U);
  int changes = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ResponsePoint& at = curve.points[i];
    const std::complex<double> product = at.multipliers[0] * at.multipliers[1];
    EXPECT_NEAR(product.real(), std::exp(-12 / at.frequency), 1e-9);
    if (i == 0) continue;
    const ResponsePoint& before = curve.points[i - 1];
    if (before.stable != at.stable) {
      const Fold& fold = curve.folds[static_cast<std::size_t>(changes++)];
      const double low = std::min(before.amplitude, at.amplitude);
      const double high = std::max(before.amplitude, at.amplitude);
      EXPECT_GE(fold.amplitude, 0.98 * low);
      EXPECT_LE(fold.amplitude, 1.02 * high);
    }
  }
  EXPECT_EQ(changes, 2);
}

TEST(HarmonicBalance, ReferencePeaks) {
  // (MO-18): a linear joint with damping parallel to the spring has its largest twist at
  // w^2 = w0^2 (1 - 2 zeta^2), with F/(2 zeta K sqrt(1 - zeta^2)) and locked input; a cubic spring
  // with one harmonic where d(p^2 + (c w)^2)/d(w) = 0.
  Joint linear = joint_with(LinearSpring{5e4});
  linear.damping = 60;
  const double zeta = 60 / (2 * std::sqrt(5e4));
  const ResponseSettings settings{.balance = {.input = VibratingInput::locked, .harmonics = 1},
                                  .excitation = 8,
                                  .from = 15,
                                  .to = 75};
  const ForcedResponse curve = forced_response(linear, settings);
  ASSERT_EQ(curve.peaks.size(), 1U);
  const Peak& peak = curve.peaks[0];
  EXPECT_TRUE(peak.stable);
  test::expect_relative(peak.frequency, std::sqrt(5e4 * (1 - 2 * zeta * zeta)) / (2 * pi), 1e-6);
  test::expect_relative(peak.amplitude, 8 / (2 * zeta * 5e4 * std::sqrt(1 - zeta * zeta)), 1e-9);
  test::expect_relative(peak.torque, 5e4 * peak.amplitude, 1e-9);
  // A range that ends just above the peak contains it, and one that ends just below does not.
  for (const double share : {1.00002, 0.99998}) {
    ResponseSettings narrow = settings;
    narrow.to = share * peak.frequency;
    EXPECT_EQ(forced_response(linear, narrow).peaks.size(), share > 1 ? 1U : 0U) << share;
  }
  const ForcedResponse bent = forced_response(hard_joint(), hard_settings(1));
  ASSERT_EQ(bent.peaks.size(), 1U);
  const double omega = 2 * pi * bent.peaks[0].frequency;
  const double a = bent.peaks[0].amplitude;
  const double p = 5e4 - omega * omega + 0.75 * 2e10 * a * a;
  test::expect_relative((p * p + 144 * omega * omega) * a * a, 64.0, 1e-7);
  test::expect_relative(2 * p, 144.0, 1e-4);
  EXPECT_TRUE(bent.peaks[0].stable);
}

/// A joint with its input locked after some periods of an excitation of the load.
JointState after_periods(Joint joint, const JointState& start, double excitation, double frequency,
                         int periods, double tolerance = 1e-11, int lines = 400) {
  const double duration = periods / frequency;
  joint.input = GivenSpeed{{.value = {0.0}}};
  joint.output_torque = cosine(0.0, excitation, frequency, duration, lines);
  const Motion motion = simulate(
      joint, start, {.duration = duration, .output_step = duration, .tolerance = tolerance});
  EXPECT_TRUE(motion.converged) << motion.reason;
  return motion.last;
}

/// Distance of two states of the load, over the size of the vibration [-].
double distance(const JointState& a, const JointState& b, const ResponsePoint& size) {
  const double speed = 2 * pi * size.frequency * size.amplitude;
  return std::hypot((a.output_angle - b.output_angle) / size.amplitude,
                    (a.output_speed - b.output_speed) / speed);
}

/// The responses of a curve at one frequency, from the first branch to the last.
std::vector<ResponsePoint> branches_at(const ForcedResponse& curve, double frequency) {
  std::vector<ResponsePoint> found;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const double a = curve.points[i].frequency - frequency;
    const double b = curve.points[i + 1].frequency - frequency;
    if (a * b <= 0)
      found.push_back(std::abs(a) < std::abs(b) ? curve.points[i] : curve.points[i + 1]);
  }
  return found;
}

TEST(HarmonicBalance, CrosscheckBranchesAndJumpsInTime) {
  // (MO-13, MO-18, MO-19): between the folds the motion in time stays on the upper and on the lower
  // branch and leaves the middle one; beyond a fold it jumps to the branch that is left.  With a
  // hard spring, without and with hysteresis.  The tolerance is that of the harmonics that are
  // left out, of 200 periods in which the rest has died out, and of lines for the cosine.
  Joint with_hysteresis = hard_joint();
  with_hysteresis.damping = 8;
  with_hysteresis.hysteresis = dahl(4e3, 0.5);
  for (const Joint& joint : {hard_joint(), with_hysteresis}) {
    ResponseSettings settings = hard_settings(15);
    settings.largest_step = 0.02;
    const ForcedResponse curve = forced_response(joint, settings);
    ASSERT_TRUE(curve.converged) << curve.reason;
    ASSERT_EQ(curve.folds.size(), 2U);
    const Fold& up = curve.folds[0];
    const Fold& down = curve.folds[1];
    const std::vector<ResponsePoint> branches =
        branches_at(curve, (up.frequency + down.frequency) / 2);
    ASSERT_EQ(branches.size(), 3U);
    EXPECT_TRUE(branches[0].stable);
    EXPECT_FALSE(branches[1].stable);
    EXPECT_TRUE(branches[2].stable);
    EXPECT_GT(branches[0].amplitude, 2 * branches[2].amplitude);
    for (const std::size_t stable : {0U, 2U}) {
      const ResponsePoint& at = branches[stable];
      const JointState start = state_on_response(joint, settings, at);
      const JointState end = after_periods(joint, start, 8, at.frequency, 60);
      EXPECT_LT(distance(end, start, at), 2e-4);
    }
    const JointState middle = state_on_response(joint, settings, branches[1]);
    const JointState left = after_periods(joint, middle, 8, branches[1].frequency, 200);
    EXPECT_GT(distance(left, middle, branches[1]), 0.3);
    // Beyond the folds.
    const auto jumps_to = [&](std::size_t from_branch, double frequency) {
      const JointState start = state_on_response(joint, settings, branches[from_branch]);
      // In small steps of the frequency up to the fold the branch is kept.
      const Fold& fold = from_branch == 0 ? up : down;
      const double before = fold.frequency * (from_branch == 0 ? 0.997 : 1.003);
      JointState state = start;
      const double first = branches[from_branch].frequency;
      for (int n = 1; n <= 20; ++n)
        state = after_periods(joint, state, 8, first + (before - first) * n / 20, 20, 1e-10, 200);
      const auto kept = branches_at(curve, before);
      state = after_periods(joint, state, 8, kept[from_branch].frequency, 100);
      EXPECT_LT(
          distance(state, state_on_response(joint, settings, kept[from_branch]), kept[from_branch]),
          1e-3);
      const auto beyond = branches_at(curve, frequency);
      ASSERT_EQ(beyond.size(), 1U);
      const JointState end = after_periods(joint, state, 8, beyond[0].frequency, 200);
      EXPECT_LT(distance(end, state_on_response(joint, settings, beyond[0]), beyond[0]), 1e-3);
    };
    jumps_to(0, up.frequency * 1.01);
    jumps_to(2, down.frequency * 0.99);
  }
}

TEST(HarmonicBalance, CrosscheckMultipliersAgainstDifferencesOfMotions) {
  // (MO-13, MO-19): the monodromy matrix by differences of `simulate` over one period, with a hard
  // spring, hysteresis by Dahl and by Bouc and Wen, and an open crack.  The tolerance is that of
  // the harmonics that are left out and of the differences.
  const BoucWen loops[] = {dahl(4e4, 2),
                           {.stiffness = 4e4, .limit = 2, .exponent = 2, .asymmetry = 0.3}};
  for (const BoucWen& loop : loops) {
    Joint joint = hard_joint();
    joint.hysteresis = loop;
    joint.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
    ResponseSettings settings = hard_settings(40);
    settings.from = 38;
    settings.to = 39;
    const ForcedResponse curve = forced_response(joint, settings);
    ASSERT_TRUE(curve.converged) << curve.reason;
    const ResponsePoint& at = curve.points.back();
    const JointState start = state_on_response(joint, settings, at);
    const double scale[] = {at.amplitude, 2 * pi * at.frequency * at.amplitude, loop.limit};
    Eigen::Matrix3d monodromy;
    for (int column = 0; column < 3; ++column) {
      std::array<std::array<double, 3>, 2> ends{};
      for (const int side : {0, 1}) {
        JointState moved = start;
        const double h = (side == 0 ? -1 : 1) * 1e-4 * scale[column];
        (column == 0   ? moved.output_angle
         : column == 1 ? moved.output_speed
                       : moved.hysteresis) += h;
        const JointState end = after_periods(joint, moved, 8, at.frequency, 1, 1e-14, 4000);
        ends[static_cast<std::size_t>(side)] = {end.output_angle, end.output_speed, end.hysteresis};
      }
      for (int row = 0; row < 3; ++row)
        monodromy(row, column) =
            (ends[1][static_cast<std::size_t>(row)] - ends[0][static_cast<std::size_t>(row)]) /
            (2e-4 * scale[column]) * scale[column] / scale[row];
    }
    const Eigen::VectorXcd values = monodromy.eigenvalues();
    ASSERT_EQ(at.multipliers.size(), 3U);
    for (const std::complex<double>& own : at.multipliers) {
      double nearest = 1e9;
      for (Eigen::Index k = 0; k < 3; ++k) nearest = std::min(nearest, std::abs(values(k) - own));
      EXPECT_LT(nearest, 2e-5);
    }
    EXPECT_GT(at.multiplier, 0.3);
  }
}

TEST(HarmonicBalance, CrosscheckMultipliersWithSlipElements) {
  // (MO-13, MO-47): the monodromy matrix by differences of `simulate` over the period from the
  // largest twist, where each element that slips bears its limit.  A start that is moved keeps
  // these torques, and the element that sticks bears the move.  The tolerance is that of the
  // harmonics that are left out and of the differences.
  Joint joint = hard_joint();
  joint.slip_elements = {{3e4, 1.0}, {2e4, 3.0}, {1e4, 100.0}};
  ResponseSettings settings = hard_settings(40);
  settings.from = 38;
  settings.to = 39;
  const ForcedResponse curve = forced_response(joint, settings);
  ASSERT_TRUE(curve.converged) << curve.reason;
  const ResponsePoint& at = curve.points.back();
  ASSERT_EQ(at.multipliers.size(), 2U);
  // From the cosine's 1 the motion is followed to its largest twist.
  Joint moving = joint;
  moving.input = GivenSpeed{{.value = {0.0}}};
  const double omega = 2 * pi * at.frequency;
  double top = 0.0;
  double most = -1.0;
  const auto twist_at = [&](double angle) {
    double sum = at.twist[0];
    for (std::size_t k = 1; 2 * k < at.twist.size(); ++k)
      sum += at.twist[2 * k - 1] * std::cos(static_cast<double>(k) * angle) +
             at.twist[2 * k] * std::sin(static_cast<double>(k) * angle);
    return sum;
  };
  for (int n = 0; n < 100000; ++n)
    if (const double angle = 2 * pi * n / 100000; twist_at(angle) > most) {
      most = twist_at(angle);
      top = angle / omega;
    }
  // Lines for a cosine that begins at the largest twist.
  const double period = 1 / at.frequency;
  const double half = pi / 4000;
  const double lines = std::pow(std::sin(half) / half, 2);
  moving.output_torque = {.time = {}, .value = {}};
  for (int n = 0; n <= 4002; ++n) {
    moving.output_torque.time.push_back(n * period / 4000);
    moving.output_torque.value.push_back(8 / lines * std::cos(omega * top + 2 * pi * n / 4000));
  }
  const auto after = [&](double angle, double speed) {
    const double twist = most - angle;
    SlipState slip{.twist = twist, .torque = {1.0, 3.0, 1e4 * (at.amplitude - angle)}};
    const Motion motion =
        simulate(moving, {.output_angle = -twist, .output_speed = speed, .slip = slip},
                 {.duration = period, .output_step = period, .tolerance = 1e-14});
    EXPECT_TRUE(motion.converged) << motion.reason;
    return std::array{motion.last.output_angle / at.amplitude,
                      motion.last.output_speed / (omega * at.amplitude)};
  };
  const double step = 1e-4;
  Eigen::Matrix2d monodromy;
  for (int column = 0; column < 2; ++column) {
    const double angle = column == 0 ? step * at.amplitude : 0.0;
    const double speed = column == 1 ? step * omega * at.amplitude : 0.0;
    const auto up = after(angle, speed);
    const auto down = after(-angle, -speed);
    for (int row = 0; row < 2; ++row)
      monodromy(row, column) =
          (up[static_cast<std::size_t>(row)] - down[static_cast<std::size_t>(row)]) / (2 * step);
  }
  const Eigen::Vector2cd values = monodromy.eigenvalues();
  for (const std::complex<double>& own : at.multipliers)
    EXPECT_LT(std::min(std::abs(values(0) - own), std::abs(values(1) - own)), 2e-5);
  EXPECT_GT(at.multiplier, 0.2);
}

TEST(HarmonicBalance, IdentityQuadratureLiesOnTheForcedResponse) {
  // (MO-17, MO-18): excited with the torque of a point of the backbone, the forced response passes
  // its amplitude and frequency; linear interpolation between two points of the curve.
  const Joint joint = with_loop();
  const BalanceSettings balance{.load_torque = 6};
  const Backbone resonances = backbone(
      joint, {.balance = balance, .kind = BackboneKind::quadrature, .amplitudes = {3e-5, 2e-4}});
  ASSERT_TRUE(resonances.converged) << resonances.reason;
  for (const BackbonePoint& at : resonances.points) {
    const ForcedResponse curve = forced_response(joint, {.balance = balance,
                                                         .excitation = at.excitation,
                                                         .from = 0.7 * at.frequency,
                                                         .to = at.frequency});
    ASSERT_TRUE(curve.converged) << curve.reason;
    test::expect_relative(curve.points.back().amplitude, at.amplitude, 1e-8);
    test::expect_relative(curve.points.back().torque, at.torque, 1e-8);
    // The first harmonic of the twist is a quarter of a period from the torque.
    EXPECT_NEAR(curve.points.back().twist[1], 0.0, 1e-8 * at.amplitude);
  }
}

TEST(HarmonicBalance, LimitMeanOfAnOpeningAndNoCrack) {
  // (MO-15): a crack that opens over an angle has its mean opening; one of no compliance has no
  // effect.
  Joint mean = joint_with(LinearSpring{5e4});
  mean.cracks = {{.compliance = 4e-6}};
  Joint turning = mean;
  turning.cracks = {{.compliance = 8e-6, .opening = AngleOpening{.order = 2.02}}};
  Joint closed = mean;
  closed.cracks = {{.compliance = 0.0, .sense = OpeningSense::positive}};
  const auto frequency = [](const Joint& joint) {
    return backbone(joint, undamped({1e-3}, VibratingInput::free)).points.at(0).frequency;
  };
  EXPECT_DOUBLE_EQ(frequency(mean), frequency(turning));
  test::expect_relative(frequency(mean), std::sqrt(1 / (2e-5 + 4e-6) / 0.5) / (2 * pi), 1e-12);
  test::expect_relative(frequency(closed), std::sqrt(5e4 / 0.5) / (2 * pi), 1e-12);
  test::expect_relative(small_frequency(mean, {}), frequency(mean), 1e-12);
  EXPECT_NEAR(twist_at_rest(mean, 12), -12 * 2.4e-5, 1e-15);
}

TEST(HarmonicBalance, InputRulesAreBroken) {
  const Joint joint = joint_with(LinearSpring{5e4});
  const auto of_backbone = [&](BackboneSettings settings) {
    return test::broken_rule([&] { return backbone(joint, settings); });
  };
  const auto of_response = [&](ResponseSettings settings) {
    return test::broken_rule([&] { return forced_response(joint, settings); });
  };
  const auto expect_text = [](const std::string& message, const std::string& text) {
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  expect_text(of_backbone({.balance = {.harmonics = 0}, .amplitudes = {1e-4}}), "from 1 to 200");
  expect_text(of_backbone({.balance = {.harmonics = 201}, .amplitudes = {1e-4}}), "from 1 to 200");
  expect_text(of_backbone({.balance = {.load_torque = kNan}, .amplitudes = {1e-4}}),
              "a finite number");
  expect_text(of_backbone({.amplitudes = {}}), "must have at least one value");
  expect_text(of_backbone({.amplitudes = {0.0}}), "> 0 and larger");
  expect_text(of_backbone({.amplitudes = {kNan}}), "> 0 and larger");
  expect_text(of_backbone({.amplitudes = {2e-4, 1e-4}}), "amplitudes[1]");
  expect_text(of_backbone({.balance = {.input = VibratingInput::locked},
                           .kind = BackboneKind::quadrature,
                           .excited = JointEnd::motor,
                           .amplitudes = {1e-4}}),
              "cannot be the motor while the input is locked");
  const ResponseSettings good{.excitation = 1, .from = 10, .to = 90};
  EXPECT_EQ(of_response(good), "no error");
  ResponseSettings bad = good;
  bad.excitation = 0;
  expect_text(of_response(bad), "excitation");
  bad = good;
  bad.excitation = kNan;
  expect_text(of_response(bad), "excitation");
  bad = good;
  bad.from = -1;
  expect_text(of_response(bad), "from");
  bad = good;
  bad.to = 10;
  expect_text(of_response(bad), "larger than from");
  bad = good;
  bad.largest_step = 0;
  expect_text(of_response(bad), "largest_step");
  bad = good;
  bad.most_points = 1;
  expect_text(of_response(bad), "most_points");
  expect_text(test::broken_rule([&] { return state_on_response(joint, good, {}); }),
              "a response of the same settings");
}

TEST(HarmonicBalance, BehaviourUnfinishedCurveSaysWhy) {
  // (MO-18): too few points leave a curve without an end.
  const ForcedResponse curve =
      forced_response(hard_joint(), {.excitation = 8, .from = 25, .to = 60, .most_points = 5});
  EXPECT_FALSE(curve.converged);
  EXPECT_EQ(curve.points.size(), 5U);
  EXPECT_NE(curve.reason.find("narrower range"), std::string::npos) << curve.reason;
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/frf_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/frf.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// The joint without the inertias of its own parts: two inertias.
GearSet frf_joint() {
  GearSet gear =
      read_gear_set_file(std::string(STRAINWAVE_EXAMPLES "/") + "joint_size25" + ".toml");
  gear.material.at("steel").density.reset();
  return gear;
}

bool has_note(const FrfReport& report, std::string_view code) {
  return std::ranges::any_of(report.notes, [&](const Note& note) { return note.code == code; });
}

TEST(FrfReport, CrosscheckTwoInertiasInClosedForm) {
  // (DY-12): all six responses of two inertias with the stiffness of strainwave modes, for both
  // arrangements: i = -100 and +101.
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    GearSet gear = frf_joint();
    gear.drivetrain->fixed = fixed;
    gear.drivetrain->motor_damping = 2e-4;
    gear.drivetrain->load_damping = 0.7;
    const FrfReport report = frf_report(gear, {.points = 40});
    const ModesReport modes = modes_report(gear);
    const double ratio = fixed == FixedMember::circular_spline ? -100.0 : 101.0;
    EXPECT_EQ(report.signed_ratio, ratio);
    EXPECT_EQ(report.torque, gear.load.torque);
    const double J_m = gear.drivetrain->motor_inertia + *gear.drivetrain->wave_generator_inertia;
    const double J_L = gear.drivetrain->load_inertia;
    for (const bool cracked : {false, true}) {
      const double K = cracked ? *modes.cracked_stiffness : modes.intact_stiffness;
      // The drive keeps its time constant, so its damping falls with its stiffness.
      const double c = gear.drivetrain->gear_damping;
      for (std::size_t n = 0; n < report.frequency.size(); ++n) {
        const Complex s(0, 2 * pi * report.frequency[n]);
        const Complex Z = c * s + K;
        const Complex motor = J_m * s * s + 2e-4 * s;
        const Complex load = J_L * s * s + 0.7 * s;
        const Complex below = motor * load + Z * (motor + load / (ratio * ratio));
        const auto expect = [&](DriveResponse response, const Complex& expected) {
          const ResponseCurve& curve = report.of(response);
          EXPECT_EQ(curve.response, response);
          const Complex found =
              std::polar((cracked ? curve.cracked_amplitude : curve.intact_amplitude)[n],
                         (cracked ? curve.cracked_phase : curve.intact_phase)[n]);
          EXPECT_LT(std::abs(found - expected), 1e-9 * std::abs(expected))
              << enum_name(response) << ' ' << report.frequency[n] << ' ' << found << expected;
        };
        expect(DriveResponse::motor_angle, (load + Z) / below);
        expect(DriveResponse::load_angle, Z / ratio / below);
        expect(DriveResponse::error_given_torque, Z * motor / below);
        expect(DriveResponse::error_given_speed, Z / (load + Z));
        expect(DriveResponse::load_torque, (motor + Z / (ratio * ratio)) / below);
        expect(DriveResponse::load_torque_at_speed, 1.0 / (load + Z));
      }
    }
  }
}

TEST(FrfReport, LimitSlowKinematicErrorMovesTheLoadAsMuch) {
  // (DY-12): far below the resonance the load follows the error of the output, for each arrangement
  // and with the gear's own inertias, a coupling, or a drive that is only a shaft; the next term is
  // (f/f_a)^2, about 1e-6.
  for (const bool summed : {false, true})
    for (const bool with_inertias : {false, true})
      for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
        GearSet gear = with_inertias ? read_gear_set_file(STRAINWAVE_EXAMPLES "/joint_size25.toml")
                                     : frf_joint();
        gear.drivetrain->fixed = fixed;
        gear.drivetrain->coupling_stiffness = 3000.0;
        if (summed) {
          gear.wave_generator.reset();
          gear.mesh.reset();
          if (with_inertias) gear.flexspline.reset();
        }
        const FrfReport report = frf_report(gear, {.from = 0.02, .to = 0.03, .points = 2});
        EXPECT_NEAR(report.of(DriveResponse::error_given_speed).cracked_amplitude.front(), 1.0,
                    1e-5);
        EXPECT_NEAR(report.of(DriveResponse::error_given_speed).cracked_phase.front(), 0.0, 1e-4);
      }
}

TEST(FrfReport, CrosscheckResonancesAgainstTheModes) {
  // (DY-13): the peaks lie at the natural frequencies, up to the square of the damping ratio.
  const GearSet gear = frf_joint();
  const FrfReport report = frf_report(gear);
  const ModesReport modes = modes_report(gear);
  const ModePair& free = *modes.first(MotorGives::torque);
  const ModePair& locked = *modes.first(MotorGives::speed);
  const double square = std::pow(free.intact.damping_ratio, 2);
  const auto found = [&](DriveResponse response, ExtremumKind kind) {
    for (const ExtremumPair& pair : report.extrema)
      if (pair.response == response && pair.kind == kind) return pair;
    ADD_FAILURE();
    return ExtremumPair{};
  };
  const ExtremumPair peak = found(DriveResponse::motor_angle, ExtremumKind::resonance);
  EXPECT_NEAR(peak.intact->frequency / free.intact.frequency, 1.0, 2 * square);
  EXPECT_NEAR(peak.cracked->frequency / free.cracked->frequency, 1.0, 2 * square);
  EXPECT_NEAR(*peak.intact->damping_ratio / free.intact.damping_ratio, 1.0, 0.02);
  EXPECT_NEAR(*peak.change(), *free.change, 1e-5);
  EXPECT_GT(*peak.amplitude_change(), 0.0);
  const ExtremumPair valley = found(DriveResponse::motor_angle, ExtremumKind::antiresonance);
  EXPECT_NEAR(valley.intact->frequency / locked.intact.frequency, 1.0, 2 * square);
  EXPECT_EQ(report.resonance(), peak.cracked->frequency);
  EXPECT_EQ(report.antiresonance(), valley.cracked->frequency);
  EXPECT_EQ(report.error_gain(),
            found(DriveResponse::error_given_speed, ExtremumKind::resonance).cracked->amplitude);
  // The range goes a decade beyond the natural frequencies.
  test::expect_relative(report.frequency.front(), locked.intact.frequency / 10, 1e-12);
  test::expect_relative(report.frequency.back(), free.intact.frequency * 10, 1e-12);
  EXPECT_EQ(report.frequency.size(), 1000U);
}

TEST(FrfReport, LimitWithoutCracksOrDamping) {
  GearSet gear = frf_joint();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  gear.drivetrain->gear_damping = 0.0;
  const FrfReport report = frf_report(gear, {.points = 5});
  EXPECT_FALSE(report.cracked);
  EXPECT_FALSE(report.damped);
  EXPECT_TRUE(has_note(report, "frf.undamped"));
  for (const ResponseCurve& curve : report.curves) EXPECT_TRUE(curve.cracked_amplitude.empty());
  for (const ExtremumPair& pair : report.extrema) {
    EXPECT_FALSE(pair.cracked.has_value());
    EXPECT_FALSE(pair.change().has_value());
    EXPECT_EQ(pair.intact->damping_ratio, 0.0);
  }
  EXPECT_FALSE(report.error_gain().has_value());
  const double f = modes_report(gear).first(MotorGives::torque)->intact.frequency;
  test::expect_relative(*report.resonance(), f, 1e-9);
  EXPECT_NE(frf_text(report, gear).find("infinite"), std::string::npos);
}

TEST(FrfReport, BehaviourHysteresisAndFrictionAreNamed) {
  EXPECT_TRUE(has_note(frf_report(frf_joint(), {.points = 2}), "frf.linear"));
  GearSet gear = frf_joint();
  gear.drivetrain->hysteresis.reset();
  EXPECT_FALSE(has_note(frf_report(gear, {.points = 2}), "frf.linear"));
  gear.drivetrain->load_friction = LuGre{.bristle_stiffness = 1e5, .coulomb = 2, .breakaway = 3};
  EXPECT_TRUE(has_note(frf_report(gear, {.points = 2}), "frf.linear"));
}

TEST(FrfReport, BehaviourTheDocumentsShowAllFrequencies) {
  const GearSet gear = frf_joint();
  const FrfReport report = frf_report(gear, {.points = 30});
  const std::string csv = frf_csv(report);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 31);
  EXPECT_TRUE(csv.starts_with("frequency [Hz],intact_motor_angle_amplitude [rad/(N*m)],"))
      << csv.substr(0, 80);
  const std::vector<PlotPanel> panels = frf_panels(report);
  ASSERT_EQ(panels.size(), 6U);
  for (const PlotPanel& panel : panels) {
    EXPECT_EQ(panel.series.size(), 4U);
    EXPECT_EQ(panel.series.front().x.size(), 30U);
  }
}

TEST(FrfReport, LimitPhasesWithoutDamping) {
  // (DY-13): the phase of a response without damping is that of a small damping, which falls by pi
  // at each resonance and rises by pi at each antiresonance.  Beside them, 1 degree is 50 times
  // the lag that a damping ratio of 1e-6 leaves at 1 % of the frequency.
  GearSet gear = frf_joint();
  gear.drivetrain->gear_damping = 0.0;
  const FrfReport without = frf_report(gear, {.points = 300});
  gear.drivetrain->gear_damping = 5e-4;
  const FrfReport with = frf_report(gear, {.points = 300});
  int compared = 0;
  for (std::size_t r = 0; r < kDriveResponses; ++r) {
    const auto response = static_cast<DriveResponse>(r);
    for (std::size_t n = 0; n < without.frequency.size(); ++n) {
      const double f = without.frequency[n];
      const bool beside = std::ranges::any_of(without.extrema, [&](const ExtremumPair& pair) {
        return pair.response == response &&
               ((pair.intact && std::abs(pair.intact->frequency / f - 1) < 0.01) ||
                (pair.cracked && std::abs(pair.cracked->frequency / f - 1) < 0.01));
      });
      if (beside) continue;
      ++compared;
      EXPECT_NEAR(without.of(response).intact_phase[n], with.of(response).intact_phase[n], pi / 180)
          << r << ' ' << f;
      EXPECT_NEAR(without.of(response).cracked_phase[n], with.of(response).cracked_phase[n],
                  pi / 180);
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(FrfReport, LimitAMotorThatKeepsItsSpeedHoldsItsDamper) {
  // (DY-13): the responses at a given speed are those of a drive without damping, and a note says
  // that they have infinite amplitudes.
  GearSet gear = frf_joint();
  gear.drivetrain->gear_damping = 0.0;
  const FrfReport without = frf_report(gear, {.points = 300});
  gear.drivetrain->motor_damping = 1e-3;
  const FrfReport with = frf_report(gear, {.points = 300});
  EXPECT_TRUE(with.damped);
  for (const DriveResponse response :
       {DriveResponse::error_given_speed, DriveResponse::load_torque_at_speed}) {
    EXPECT_EQ(with.of(response).intact_phase, without.of(response).intact_phase);
    EXPECT_EQ(with.of(response).cracked_phase, without.of(response).cracked_phase);
  }
  const auto note = std::ranges::find(with.notes, "frf.undamped", &Note::code);
  ASSERT_NE(note, with.notes.end());
  EXPECT_NE(note->text.find("keeps its speed"), std::string::npos);
}

TEST(FrfReport, InputEachRuleBrokenOnce) {
  const GearSet gear = frf_joint();
  const auto message = [&](const FrfOptions& options) {
    return test::broken_rule([&] { return frf_report(gear, options); });
  };
  EXPECT_EQ(message({.points = 2}), "no error");
  EXPECT_NE(message({.points = 1}).find("--points"), std::string::npos);
  EXPECT_NE(message({.points = kMostFrfPoints + 1}).find("--points"), std::string::npos);
  EXPECT_NE(message({.from = 0.0}).find("--from"), std::string::npos);
  EXPECT_NE(message({.from = 10.0, .to = 10.0}).find("--to"), std::string::npos);
  EXPECT_NE(message({.from = 1e6}).find("--to"), std::string::npos);
  EXPECT_NE(message({.torque = std::nan("")}).find("torque"), std::string::npos);
  GearSet without = gear;
  without.drivetrain.reset();
  without.manoeuvre.clear();
  EXPECT_EQ(test::broken_rule([&] { return frf_report(without); }),
            "drivetrain: must be given for the frequency responses; give [drivetrain] with "
            "motor_inertia and load_inertia");
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/modes_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/modes.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_orders.hpp"
#include "strainwave/study/frf_report.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"
#include "support/summed_joint.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

GearSet example(const std::string& name) {
  return read_gear_set_file(std::string(STRAINWAVE_EXAMPLES "/") + name + ".toml");
}

/// The joint without the inertias of its own parts.
GearSet robot_joint() {
  GearSet gear = example("joint_size25");
  gear.material.at("steel").density.reset();
  return gear;
}

const ModePair& first(const ModesReport& report, MotorGives motor) {
  return report.conditions[motor == MotorGives::torque ? 0 : 1].modes.front();
}

double free_frequency(double stiffness, double motor, double load, double ratio) {
  return std::sqrt(stiffness * (1 / load + 1 / (ratio * ratio * motor))) / (2 * pi);
}

TEST(ModesReport, CrosscheckTwoInertiasOnTheTangentOfTheCurve) {
  // (DY-10): the closed form of two inertias with the tangent of the torsion curve.
  const GearSet gear = robot_joint();
  const ModesReport report = modes_report(gear);
  EXPECT_EQ(report.springs, SpringModel::coupled_drive);
  EXPECT_EQ(report.torque, gear.load.torque);
  EXPECT_EQ(report.signed_ratio, -100.0);
  const auto tangent = [&](const GearSet& of) {
    return torsion_curve(of, std::array{gear.load.torque}).points.front().tangent_stiffness();
  };
  GearSet sound = gear;
  sound.flexspline->crack.clear();
  sound.output_shaft->crack.clear();
  const double K = tangent(sound);
  const double cracked = tangent(gear);
  test::expect_relative(report.intact_stiffness, K, 1e-9);
  test::expect_relative(*report.cracked_stiffness, cracked, 1e-9);
  const double J_m = gear.drivetrain->motor_inertia + *gear.drivetrain->wave_generator_inertia;
  const double J_L = gear.drivetrain->load_inertia;
  const ModePair& free = first(report, MotorGives::torque);
  test::expect_relative(free.intact.frequency, free_frequency(K, J_m, J_L, 100), 1e-9);
  test::expect_relative(free.cracked->frequency, free_frequency(cracked, J_m, J_L, 100), 1e-9);
  test::expect_relative(*free.change, std::sqrt(cracked / K) - 1, 1e-6);
  EXPECT_NEAR(*free.likeness, 1.0, 1e-12);
  EXPECT_EQ(report.free_frequency(), free.cracked->frequency);
  EXPECT_EQ(report.free_change(), free.change);
  EXPECT_EQ(report.locked_frequency(), first(report, MotorGives::speed).cracked->frequency);
  const ModePair& held = first(report, MotorGives::speed);
  test::expect_relative(held.intact.frequency, std::sqrt(K / J_L) / (2 * pi), 1e-9);
  // zeta = c omega/(2 K).
  test::expect_relative(held.intact.damping_ratio,
                        gear.drivetrain->gear_damping * std::sqrt(K / J_L) / (2 * K), 1e-9);
}

TEST(ModesReport, CrosscheckTwoInertiasOnTheSumOfTheMembers) {
  GearSet gear = robot_joint();
  gear.mesh.reset();
  gear.circular_spline.reset();
  gear.drivetrain->fixed = FixedMember::flexspline;
  for (const double sense : {1.0, -1.0}) {
    const ModesReport report = modes_report(gear, sense * 48.0);
    EXPECT_EQ(report.springs, SpringModel::members);
    EXPECT_EQ(report.signed_ratio, 101.0);
    const StiffnessResult sum = torsional_stiffness(gear);
    // The housing holds the flexspline with the opposite torque (DY-10).
    const Compliances& hub = (sense > 0 ? sum.negative : sum.positive).compliance;
    const Compliances& shaft = (sense > 0 ? sum.positive : sum.negative).compliance;
    const double step = 100.0 / 101;
    const double K = 1 / (step * step * (hub.wave_generator.value + hub.flexspline.value) +
                          shaft.output_shaft.value);
    test::expect_relative(*report.cracked_stiffness, K, 1e-9);
    test::expect_relative(first(report, MotorGives::torque).cracked->frequency,
                          free_frequency(K, 9.13e-5, 1.2, 101), 1e-9);
  }
}

double share_of_member(const DriveMode& mode, std::string_view member) {
  for (const MemberEnergy& of : mode.energy)
    if (of.member == member) return of.share;
  ADD_FAILURE() << member;
  return 0.0;
}

TEST(ModesReport, IdentitySharesSumToOneAndGiveTheDerivative) {
  // (DY-4): a crack of the shaft that is small lowers ln f by half its share; the next term is the
  // square of the added part, below 1e-4.
  GearSet gear = robot_joint();
  gear.flexspline->crack.clear();
  std::get<AnnularCrack>(gear.output_shaft->crack.front()).depth = 0.3e-3;
  gear.drivetrain->coupling_stiffness = 3000.0;
  const ModesReport report = modes_report(gear);
  const ModePair& mode = first(report, MotorGives::torque);
  double sum = 0.0;
  for (const MemberEnergy& of : mode.intact.energy) {
    sum += of.share;
    EXPECT_EQ(of.derivative(), -of.share / 2);
  }
  const double shaft = share_of_member(mode.intact, "output shaft");
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_EQ(mode.intact.energy.front().member, "coupling");
  const MemberCompliance of = output_shaft_compliance(gear);
  const double added = of.cracks.front().positive.at_output.value / of.intact;
  ASSERT_GT(added, 1e-6);
  EXPECT_NEAR(std::log1p(*mode.change) / (-shaft / 2 * added), 1.0, 1e-3);
  // One crack alone is all that changes the drive.
  ASSERT_EQ(mode.cracks.size(), 1U);
  EXPECT_EQ(mode.cracks.front().path, "output_shaft.crack[0]");
  test::expect_relative(mode.cracks.front().change, *mode.change, 1e-6);
}

TEST(ModesReport, BehaviourACrackOfOneSenseAboutNoTorque) {
  // (MO-16): without a torque no sense opens the crack, so a note gives the frequencies of both
  // senses and that of the vibration through 0.  The numbers are those of reports about a torque.
  const GearSet gear = test::summed_joint("");
  const auto note_of = [](const std::vector<Note>& notes) {
    const auto found = std::ranges::find(notes, "modes.one_sense", &Note::code);
    return found == notes.end() ? std::string() : found->text;
  };
  const auto locked = [&](double torque) {
    return first(modes_report(gear, torque), MotorGives::speed).cracked->frequency;
  };
  const double one = locked(100.0);
  const double other = locked(-100.0);
  const std::string text = note_of(modes_report(gear, 0.0).notes);
  for (const double frequency : {one, other, 2 / (1 / one + 1 / other)})
    EXPECT_NE(text.find(shown_quantity(frequency, "Hz", 6)), std::string::npos) << text;
  EXPECT_NE(shown_quantity(one, "Hz", 6), shown_quantity(other, "Hz", 6));
  FrfOptions about_zero;
  about_zero.torque = 0.0;
  about_zero.points = 40;
  EXPECT_EQ(note_of(frf_report(gear, about_zero).notes), text);
  EXPECT_EQ(note_of(modes_report(gear, 100.0).notes), "");
  // A crack that both senses open needs no note.
  GearSet both = gear;
  both.flexspline->crack.clear();
  EXPECT_EQ(note_of(modes_report(both, 0.0).notes), "");
}

/// Derivative of ln f of the first mode by the logarithm of a compliance, by central differences.
/// @param set         sets the drive to a parameter [any]
/// @param compliance  at a parameter [rad/(N*m)]
double difference(const std::function<GearSet(double)>& set,
                  const std::function<double(const GearSet&)>& compliance, MotorGives motor,
                  double at, double step) {
  const auto both = [&](double parameter) {
    const GearSet gear = set(parameter);
    const ModesReport report = modes_report(gear);
    const ModePair& mode = first(report, motor);
    return std::pair{std::log((mode.cracked ? *mode.cracked : mode.intact).frequency),
                     std::log(compliance(gear))};
  };
  const auto [f_over, L_over] = both(at * (1 + step));
  const auto [f_under, L_under] = both(at * (1 - step));
  return (f_over - f_under) / (L_over - L_under);
}

TEST(ModesReport, CrosscheckDerivativesOfMembersByDifferences) {
  // (DY-4): compliances of shaft and coupling grow by 0.1 %.  The next term of a central
  // difference is the square of the step, and the coupled drive is solved to 1e-9; 1e-5 contains
  // both.  The flexspline's cracks add to the shaft's torque sense only, so they stay.
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
    GearSet base = robot_joint();
    base.output_shaft->crack.clear();
    base.drivetrain->coupling_stiffness = 3000.0;
    const ModesReport report = modes_report(base);
    const DriveMode& mode = *first(report, motor).cracked;
    const auto shaft = [&](double length) {
      GearSet gear = base;
      gear.output_shaft->length = length;
      return gear;
    };
    const auto of_shaft = [](const GearSet& gear) { return output_shaft_compliance(gear).intact; };
    test::expect_relative(difference(shaft, of_shaft, motor, base.output_shaft->length, 1e-3),
                          -share_of_member(mode, "output shaft") / 2, 1e-5);
    const auto coupling = [&](double stiffness) {
      GearSet gear = base;
      gear.drivetrain->coupling_stiffness = stiffness;
      return gear;
    };
    const auto of_coupling = [](const GearSet& gear) {
      return 1 / *gear.drivetrain->coupling_stiffness;
    };
    test::expect_relative(difference(coupling, of_coupling, motor, 3000.0, 1e-3),
                          -share_of_member(mode, "coupling") / 2, 1e-5);
  }
}

TEST(ModesReport, CrosscheckDerivativesOfCracksByDifferences) {
  // (DY-4): a crack grows by 0.1 %, and its compliance with it; tolerance as for the members.
  const GearSet base = robot_joint();
  const auto added = [](const MemberCompliance& of) {
    return of.cracks.front().positive.at_output.value;
  };
  const auto depth = [&](double value) {
    GearSet gear = base;
    std::get<AnnularCrack>(gear.output_shaft->crack.front()).depth = value;
    return gear;
  };
  const auto length = [&](double value) {
    GearSet gear = base;
    std::get<WallThroughCrack>(gear.flexspline->crack.front()).half_length = value;
    return gear;
  };
  const auto of_shaft = [&](const GearSet& gear) { return added(output_shaft_compliance(gear)); };
  const auto of_wall = [&](const GearSet& gear) { return added(flexspline_compliance(gear)); };
  const ModesReport report = modes_report(base);
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
    const std::vector<CrackOnMode>& cracks = first(report, motor).cracks;
    ASSERT_EQ(cracks.size(), 2U);
    ASSERT_TRUE(cracks[0].derivative().has_value());
    ASSERT_TRUE(cracks[1].derivative().has_value());
    test::expect_relative(difference(length, of_wall, motor, 2e-3, 1e-3), *cracks[0].derivative(),
                          1e-4);
    test::expect_relative(difference(depth, of_shaft, motor, 2e-3, 1e-3), *cracks[1].derivative(),
                          1e-4);
    EXPECT_LT(*cracks[0].derivative(), 0);
  }
}

TEST(ModesReport, BehaviourOnlyOpenCracksInLineHaveAShare) {
  // A crack of a tooth acts inside the contacts.  Under negative torque the flexspline's crack is
  // closed.
  GearSet gear = robot_joint();
  gear.mesh->crack.push_back(ToothCrack{.stiffness_loss = 0.5, .position = 0.1});
  const ModesReport positive = modes_report(gear);
  for (const CrackOnMode& crack : first(positive, MotorGives::torque).cracks) {
    EXPECT_EQ(crack.share.has_value(), crack.path != "mesh.crack[0]") << crack.path;
    // A tooth that gives way moves the force to others, which may be stiffer in the tangent.
    if (crack.share) {
      EXPECT_LT(crack.change, 0) << crack.path;
    } else {
      EXPECT_NE(crack.change, 0) << crack.path;
    }
  }
  gear = robot_joint();
  const ModesReport negative = modes_report(gear, -48.0);
  const std::vector<CrackOnMode>& cracks = first(negative, MotorGives::torque).cracks;
  EXPECT_FALSE(cracks[0].derivative().has_value());
  EXPECT_NEAR(cracks[0].change, 0.0, 1e-9);
  EXPECT_TRUE(cracks[1].derivative().has_value());
}

TEST(ModesReport, IdentityACrackOfTheShaftIsEnergyOfTheShaft) {
  GearSet gear = robot_joint();
  gear.flexspline->crack.clear();
  const ModesReport report = modes_report(gear);
  const ModePair& mode = first(report, MotorGives::speed);
  for (const MemberEnergy& of : mode.cracked->energy) EXPECT_NE(of.member, "series cracks");
  const MemberCompliance shaft = output_shaft_compliance(gear);
  const double all = shaft.intact + shaft.cracks.front().positive.at_output.value;
  for (const MemberEnergy& of : mode.cracked->energy) {
    if (of.member != "output shaft") continue;
    test::expect_relative(of.share, all * *report.cracked_stiffness, 1e-6);
  }
}

TEST(ModesReport, ReferenceCriticalSpeeds) {
  // (DY-2, DY-8): with the circular spline fixed, a wave passes it twice a turn and the flexspline
  // 2 (1 + 1/i) times; with the flexspline fixed, 2 (1 - 1/(i + 1)) times and twice.  23 balls of
  // 4.673 mm on 53.63 mm pass 11.5 (1 +- 4.673/53.63) times a turn of the wave against the
  // flexspline.  With the two lobes, an odd number of balls comes twice as often to a lobe as to a
  // point of the inner ring.  The lowest frequency is that of the free input for a given torque,
  // and that of the locked input for a given speed.
  const double balls = 4.673 / 53.63;
  struct Case {
    FixedMember fixed;
    std::array<double, 11> orders;
  };
  for (const Case& of : {Case{FixedMember::circular_spline,
                              {1, 2, 4, 2.02, 2, 0.01, 0.02, 11.615 * (1 + balls),
                               11.615 * (1 - balls), 23.23 * (1 + balls), 46.46 * (1 + balls)}},
                         Case{FixedMember::flexspline,
                              {1, 2, 4, 2, 2 - 2 / 101.0, 1 / 101.0, 2 / 101.0, 11.5 * (1 + balls),
                               11.5 * (1 - balls), 23 * (1 + balls), 46 * (1 + balls)}}}) {
    GearSet gear = robot_joint();
    gear.drivetrain->fixed = of.fixed;
    const ModesReport report = modes_report(gear);
    for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
      const ModePair& mode = first(report, motor);
      ASSERT_EQ(mode.critical_speeds.size(), of.orders.size());
      for (std::size_t i = 0; i < of.orders.size(); ++i) {
        const ModeSpeed& speed = mode.critical_speeds[i];
        test::expect_relative(speed.order, of.orders[i], 1e-12);
        test::expect_relative(speed.intact, 2 * pi * mode.intact.frequency / of.orders[i], 1e-12);
        test::expect_relative(*speed.cracked, 2 * pi * mode.cracked->frequency / of.orders[i],
                              1e-12);
      }
    }
    EXPECT_GT(first(report, MotorGives::torque).critical_speeds[1].intact,
              first(report, MotorGives::speed).critical_speeds[1].intact);
  }
  // Order 2 of the locked input: 30 f in turns per minute.
  const ModesReport report = modes_report(robot_joint());
  const ModePair& locked = first(report, MotorGives::speed);
  test::expect_relative(locked.critical_speeds[1].intact / units::rpm, 30 * locked.intact.frequency,
                        1e-12);
  test::expect_relative(*report.largest_speed / units::rpm, 5600.0, 1e-12);
}

TEST(ModesReport, ReferenceOrdersOfOtherWaves) {
  // (DY-2): the lobes make the orders U and 2U of the kinematic error, and an eccentric cam makes
  // the order 1; with the circular spline fixed, cracks have U(1 + 1/i) and U.
  GearSet gear = robot_joint();
  gear.mesh.reset();
  gear.circular_spline.reset();
  gear.wave_generator->bearing->ball_count.reset();
  gear.wave_generator->bearing->outer_ring.reset();
  const auto orders = [&](int waves) {
    gear.drive.wave_number = waves;
    std::vector<std::pair<std::string, double>> all;
    for (const DriveOrder& of : drive_orders(gear)) all.emplace_back(of.words, of.order);
    return all;
  };
  const std::string error = "kinematic error, ";
  const std::string turn = " in a turn of the input";
  const std::vector<std::pair<std::string, double>> three = orders(3);
  ASSERT_EQ(three.size(), 7U);
  EXPECT_EQ(three[0], std::pair(error + "once" + turn, 1.0));
  EXPECT_EQ(three[1], std::pair(error + "three times" + turn, 3.0));
  EXPECT_EQ(three[2], std::pair(error + "6 times" + turn, 6.0));
  test::expect_relative(three[3].second, 3.03, 1e-12);
  test::expect_relative(three[4].second, 3.0, 1e-12);
  const std::vector<std::pair<std::string, double>> one = orders(1);
  ASSERT_EQ(one.size(), 6U);
  EXPECT_EQ(one[0], std::pair(error + "once" + turn, 1.0));
  EXPECT_EQ(one[1], std::pair(error + "twice" + turn, 2.0));
}

TEST(ModesReport, IdentityTorqueAndAxialForceOpenCracksTogether) {
  // 1324 N make 15 MPa along the barrel, and half of it acts across a crack at 45 deg.  The shear
  // of -48 N*m, 17.5 MPa, closes this crack, and that of -10 N*m, 3.7 MPa, does not.  The answer is
  // that of a file with this torque, for both models.  Without the force the sense decides alone.
  for (const bool coupled : {true, false}) {
    GearSet gear = robot_joint();
    if (!coupled) gear.mesh.reset();
    const auto share_at = [&](double of_file, double asked) {
      gear.load.torque = of_file;
      const ModesReport report = modes_report(gear, asked);
      return std::pair(first(report, MotorGives::speed).cracks[0].share.has_value(),
                       first(report, MotorGives::speed).cracked->frequency);
    };
    gear.load.axial_force = 1324;
    for (const double asked : {-10.0, -48.0}) {
      const auto [open, frequency] = share_at(48, asked);
      EXPECT_EQ(open, asked == -10.0) << coupled;
      const auto [same, of_file] = share_at(asked, asked);
      EXPECT_EQ(open, same) << coupled;
      test::expect_relative(frequency, of_file, 1e-12);
    }
    EXPECT_TRUE(share_at(48, 10).first) << coupled;
    gear.load.axial_force = 0;
    EXPECT_FALSE(share_at(48, -10).first) << coupled;
  }
}

TEST(ModesReport, IdentityTheBearingIsThatOfTheTorque) {
  // (DY-10), (CO-4): without the coupled drive, the contacts of the bearing are as stiff as in a
  // file with the asked torque.  Stated displacements belong to the torque of the file.
  GearSet gear = robot_joint();
  gear.mesh.reset();
  gear.flexspline->crack.clear();
  const auto frequency_at = [&](double of_file, double asked) {
    gear.load.torque = of_file;
    return first(modes_report(gear, asked), MotorGives::speed).intact.frequency;
  };
  EXPECT_LT(frequency_at(48, 10), 0.99 * frequency_at(48, 48));
  test::expect_relative(frequency_at(48, 10), frequency_at(10, 10), 1e-12);
  gear.wave_generator->bearing.reset();
  gear.wave_generator->displacements = LobeDisplacements{.bearing = 5e-6};
  test::expect_relative(frequency_at(48, 10), frequency_at(48, 48), 1e-12);
}

TEST(ModesReport, BehaviourTheBallsNeedTheirCount) {
  GearSet gear = robot_joint();
  gear.mesh.reset();
  gear.circular_spline.reset();
  gear.wave_generator->bearing->ball_count.reset();
  gear.wave_generator->bearing->outer_ring.reset();
  EXPECT_EQ(first(modes_report(gear), MotorGives::speed).critical_speeds.size(), 7U);
}

TEST(ModesReport, IdentityEveryModeHasItsOwnPartner) {
  // (DY-11): with a deep crack of the shaft the modes of rim and hub mix, and still each mode of
  // the cracked drive belongs to one mode of the sound one.
  GearSet gear = example("joint_size25");
  std::get<AnnularCrack>(gear.output_shaft->crack.front()).depth = 13.5e-3;
  for (const MotorModes& of : modes_report(gear).conditions) {
    std::set<double> frequencies;
    for (const ModePair& pair : of.modes) {
      EXPECT_TRUE(frequencies.insert(pair.cracked->frequency).second);
      EXPECT_LT(pair.cracked->frequency, pair.intact.frequency);
    }
    EXPECT_EQ(frequencies.size(), of.modes.size());
  }
}

TEST(ModesReport, BehaviourInertiasOfTheGearAddModesFarAbove) {
  const ModesReport without = modes_report(robot_joint());
  const ModesReport with = modes_report(example("joint_size25"));
  ASSERT_EQ(with.conditions.front().modes.size(), 3U);
  ASSERT_EQ(without.conditions.front().modes.size(), 1U);
  const double f = first(with, MotorGives::torque).intact.frequency;
  EXPECT_NEAR(f / first(without, MotorGives::torque).intact.frequency, 1.0, 1e-3);
  EXPECT_GT(with.conditions.front().modes[1].intact.frequency, 50 * f);
  EXPECT_TRUE(std::ranges::any_of(
      without.notes, [](const Note& note) { return note.code == "modes.no_density"; }));
  EXPECT_TRUE(std::ranges::none_of(
      with.notes, [](const Note& note) { return note.code == "modes.no_density"; }));
  // Damping in proportion to the compliance is large for modes far above.
  EXPECT_TRUE(std::ranges::any_of(
      with.notes, [](const Note& note) { return note.code == "modes.large_damping"; }));
  EXPECT_TRUE(std::ranges::none_of(
      without.notes, [](const Note& note) { return note.code == "modes.large_damping"; }));
}

/// The rows of one mode for a condition of the motor.
std::vector<ModeAtTorque> over_torque(const ModesReport& report, MotorGives motor, int number) {
  std::vector<ModeAtTorque> rows;
  for (const ModeAtTorque& row : report.over_torque)
    if (row.motor == motor && row.number == number) rows.push_back(row);
  return rows;
}

TEST(ModesReport, CrosscheckTheModesOverTheTorque) {
  // (DY-3), (DY-11): each row against the closed form of two inertias on the tangent of a torsion
  // curve that is solved for this torque alone.
  const GearSet gear = robot_joint();
  const ModesReport report = modes_report(gear);
  const double J = gear.drivetrain->load_inertia;
  const auto locked = over_torque(report, MotorGives::speed, 1);
  const auto free = over_torque(report, MotorGives::torque, 1);
  ASSERT_GE(locked.size(), 24U);
  ASSERT_EQ(free.size(), locked.size());
  EXPECT_EQ(locked.front().torque, -locked.back().torque);
  EXPECT_GE(locked.back().torque, *gear.rating->rated_torque);
  for (std::size_t n = 0; n < locked.size(); ++n) {
    const auto frequency = [&](const GearSet& of) {
      const double K =
          torsion_curve(of, std::array{locked[n].torque}).points.front().tangent_stiffness();
      return std::sqrt(K / (J + gear_inertias(of).shaft)) / (2 * pi);
    };
    GearSet sound = gear;
    sound.flexspline->crack.clear();
    sound.output_shaft->crack.clear();
    EXPECT_NEAR(locked[n].intact / frequency(sound), 1.0, 1e-6) << locked[n].torque;
    EXPECT_NEAR(*locked[n].cracked / frequency(gear), 1.0, 1e-6) << locked[n].torque;
    EXPECT_EQ(*locked[n].change(), *locked[n].cracked / locked[n].intact - 1);
    // One mode of two inertias has one shape at all torques.
    EXPECT_NEAR(free[n].likeness.value_or(1.0), 1.0, 1e-12);
    // The ratio of both conditions holds at each torque.
    EXPECT_NEAR(free[n].intact / locked[n].intact, free[0].intact / locked[0].intact, 1e-9);
  }
  // Positive torque opens the crack of the wall; the annular crack of the shaft stays open.
  EXPECT_LT(*locked.back().change(), *locked.front().change() - 5e-5);
  EXPECT_LT(*locked.front().change(), -1e-3);
}

TEST(ModesReport, BehaviourModesThatCrossKeepTheirNumber) {
  // (DY-11): the motor on a stiff coupling vibrates at 11.7 kHz at each torque.  A mode of the
  // flexspline passes this frequency while the torque rises, and each shape keeps its number.
  GearSet gear = example("joint_size25");
  gear.drivetrain->coupling_stiffness = 1.19e5;
  const ModesReport report = modes_report(gear);
  const auto second = over_torque(report, MotorGives::torque, 2);
  const auto third = over_torque(report, MotorGives::torque, 3);
  ASSERT_EQ(second.size(), third.size());
  bool below = false;
  bool above = false;
  for (std::size_t n = 0; n < second.size(); ++n) {
    below |= second[n].intact < third[n].intact;
    above |= second[n].intact > third[n].intact;
    EXPECT_GT(second[n].likeness.value_or(1.0), 0.8) << second[n].torque;
    EXPECT_GT(third[n].likeness.value_or(1.0), 0.8) << third[n].torque;
  }
  EXPECT_TRUE(below);
  EXPECT_TRUE(above);
}

TEST(ModesReport, LimitTheSumOfTheMembersHasNoModesOverTheTorque) {
  GearSet gear = robot_joint();
  gear.mesh.reset();
  gear.circular_spline.reset();
  const ModesReport report = modes_report(gear);
  ASSERT_EQ(report.springs, SpringModel::members);
  EXPECT_TRUE(report.over_torque.empty());
}

TEST(ModesReport, BehaviourTorquesOutOfReachLeaveOutTheMap) {
  GearSet gear = robot_joint();
  gear.rating = Rating{.T1 = 14, .T2 = 48, .T3 = {}, .rated_torque = {}};
  gear.rating->repeated_peak = 1e6;
  const ModesReport report = modes_report(gear);
  EXPECT_TRUE(report.over_torque.empty());
  EXPECT_GT(report.conditions.front().modes.front().intact.frequency, 0.0);
  EXPECT_EQ(std::ranges::count(report.notes, "modes.no_map", &Note::code), 1);
}

TEST(ModesReport, CrosscheckTheFirstModeWhileACrackGrows) {
  // (GR-25), (DY-3): each row against the closed form of one inertia on the tangent of the torsion
  // curve of the drive with the crack at its size.
  GearSet gear = example("resonance_shift_size25");
  gear.material.at("steel").density.reset();
  ModesReport report = modes_report(gear);
  EXPECT_FALSE(report.over_growth.has_value());
  add_modes_over_growth(report, gear, 12);
  const ModesOverGrowth& over = *report.over_growth;
  GrowthOptions options;
  options.points = 12;
  const GrowthReport growth = grow_cracks(gear, options);
  ASSERT_TRUE(growth.life.has_value());
  EXPECT_EQ(over.life, growth.life);
  EXPECT_EQ(over.sentence, growth.sentence);
  ASSERT_EQ(over.rows.size(), growth.drives.size());
  ASSERT_GE(over.rows.size(), 8U);
  const auto tangent = [&](const GearSet& of) {
    return torsion_curve(of, std::array{of.load.torque}).points.front().tangent_stiffness();
  };
  for (std::size_t n = 0; n < over.rows.size(); ++n) {
    const double expected = std::sqrt(tangent(growth.drives[n]) / tangent(gear)) - 1;
    EXPECT_EQ(over.rows[n].time, growth.stiffness[n].time);
    EXPECT_NEAR(*over.rows[n].locked_change, expected, 1e-9);
    EXPECT_NEAR(*over.rows[n].free_change, expected, 1e-9);
    EXPECT_EQ(over.rows[n].likeness.has_value(), n > 0);
    EXPECT_NEAR(over.rows[n].likeness.value_or(1.0), 1.0, 1e-12);
  }
  EXPECT_EQ(over.rows.front().free_change, 0.0);
  EXPECT_NEAR(*over.rows.front().free, *report.free_frequency(), 1e-9 * *report.free_frequency());
  EXPECT_LT(*over.rows.back().free_change, -1e-3);
  // The report tells the notes and the equations of the growth, each once.
  for (const Note& note : growth.notes)
    EXPECT_EQ(std::ranges::count(report.notes, note), 1) << note.text;
  EXPECT_EQ(std::ranges::count(report.equations, "GR-24"), 1);
}

TEST(ModesReport, InputGrowthWithoutADuty) {
  const GearSet gear = robot_joint();
  ModesReport report = modes_report(gear);
  EXPECT_THROW(add_modes_over_growth(report, gear), InputError);
  EXPECT_FALSE(report.over_growth.has_value());
}

TEST(ModesReport, InputADriveWithoutADrivetrain) {
  try {
    (void)modes_report(example("cracked_size25"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "drivetrain: must be given for the modes; give [drivetrain] with motor_inertia and "
        "load_inertia");
  }
}

TEST(ModesReport, InputATorqueAtWhichNoFlankTouches) {
  GearSet gear = robot_joint();
  gear.mesh->lobe_gap = 20e-6;
  try {
    (void)modes_report(gear, 0.0);
    FAIL();
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("choose a larger torque"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace strainwave

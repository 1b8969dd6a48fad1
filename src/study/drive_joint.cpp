// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/drive_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// The compliances of the members at the output, with the circular spline fixed, and their cracks.
struct MemberSum {
  double flexspline_side = 0.0;  ///< wave generator and flexspline [rad/(N*m)]
  double shaft = 0.0;            ///< [rad/(N*m)]
  std::vector<BreathingCrack> cracks = {};
};

/// The torque of the drive on its load is the negative of that on the output (MO-14).
/// @param step        torque of the member over that on the output, with sign [-]
/// @param opening_of  opening over an angle of the crack with a path
void add_cracks(std::vector<BreathingCrack>& cracks, const MemberCompliance& member, double step,
                const std::function<std::optional<AngleOpening>(const std::string&)>& opening_of) {
  const bool turned = step < 0;
  const OpeningSense under_positive = turned ? OpeningSense::positive : OpeningSense::negative;
  const OpeningSense under_negative = turned ? OpeningSense::negative : OpeningSense::positive;
  for (const CrackReport& crack : member.cracks) {
    const double positive = step * step * crack.positive.at_output.value;
    const double negative = step * step * crack.negative.at_output.value;
    const auto add = [&](double compliance, std::optional<OpeningSense> sense) {
      if (compliance > 0)
        cracks.push_back({.path = crack.path,
                          .compliance = compliance,
                          .sense = sense,
                          .opening = opening_of(crack.path)});
    };
    if (positive == negative) {
      add(positive, {});
      continue;
    }
    add(positive, under_positive);
    add(negative, under_negative);
  }
}

/// Whether a crack of the drive is of one of the kinds.
template <class... Kinds>
bool is_crack_of(const GearSet& gear, const std::string& path) {
  bool is = false;
  for_each_crack(gear, [&]<class Crack>(const std::string& of, const Crack&) {
    if constexpr ((std::is_same_v<Crack, Kinds> || ...)) is |= of == path;
  });
  return is;
}

/// A crack of the wall opens with the wave (DY-2, MO-6); the wave does not reach the diaphragm.
std::optional<AngleOpening> opening_by_wave(const GearSet& gear, const std::string& path) {
  if (gear.drivetrain->breathing == CrackBreathing::torque ||
      !is_crack_of<WallThroughCrack, WallSurfaceCrack>(gear, path))
    return std::nullopt;
  return AngleOpening{.shaft = BreathingShaft::input,
                      .order = wave_orders(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio,
                                           gear.drive.wave_number)
                                   .flexspline};
}

/// A surface crack of the output shaft opens once in a turn under a moment that is fixed in space.
std::optional<AngleOpening> opening_by_moment(const GearSet& gear, const std::string& path) {
  const bool bent = gear.duty && std::ranges::any_of(gear.duty->block, [](const DutyBlock& block) {
                      return block.bending_moment > 0;
                    });
  if (gear.drivetrain->breathing == CrackBreathing::torque || !bent ||
      !is_crack_of<ShaftSurfaceCrack>(gear, path))
    return std::nullopt;
  return AngleOpening{.shaft = BreathingShaft::output, .order = 1.0};
}

/// @param coupled  whether the file gives enough for the coupled drive
MemberSum members_of(const GearSet& gear, bool coupled) {
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  MemberSum sum;
  const auto take = [&](const MemberCompliance& member, double& side, double member_step,
                        const auto& opening_of) {
    if (!member.unusable_because.empty()) throw SolverError(member.unusable_because);
    side += member.intact;
    add_cracks(sum.cracks, member, member_step, opening_of);
  };
  if (gear.wave_generator && !coupled)
    take(wave_generator_compliance(gear), sum.flexspline_side, step, [](const std::string&) {
      return std::optional<AngleOpening>();
    });  // it turns with the wave
  if (gear.flexspline)
    take(flexspline_compliance(gear), sum.flexspline_side, step,
         [&](const std::string& path) { return opening_by_wave(gear, path); });
  if (gear.output_shaft)
    take(output_shaft_compliance(gear), sum.shaft, 1.0,
         [&](const std::string& path) { return opening_by_moment(gear, path); });
  return sum;
}

Note breathing_note(CrackBreathing breathing) {
  Note note{
      .code = "motion.breathing",
      .text =
          "cracks open with the sense of the torque; that the wave opens and closes them "
          "in each turn is left out",
      .path = "drivetrain.breathing",
      .equation = "MO-5",
      .severity = Severity::care,
      .next_step = "Give drivetrain.breathing = \"turn\" for cracks that open with the wave."};
  if (breathing == CrackBreathing::turn) {
    note.text =
        "the opening of cracks over a turn is Mayes' law, which is assumed: open at the "
        "major axis, closed at the minor axis, and half of the compliance on average";
    note.equation = "MO-6";
    note.next_step =
        "Compare with drivetrain.breathing = \"torque\", where these cracks stay open too.";
  }
  return note;
}

Note contact_note(const std::string& path) {
  return {
      .code = "motion.contact_crack",
      .text =
          "a motion leaves this crack out, because it acts through the contacts of balls and "
          "teeth",
      .path = path,
      .equation = "MO-14",
      .severity = Severity::care,
      .next_step = "Run strainwave torsion --compare, whose coupled drive contains this crack."};
}

/// Error of the table, over what the cracks add, from which a note says so.
constexpr double kLargestShare = 0.1;

Note cage_note() {
  return {.code = "motion.cage",
          .text =
              "a ball stands at the lobe when the motion begins, and the cage rolls without "
              "slip; both are assumed",
          .path = "drivetrain.spring",
          .equation = "MO-27",
          .severity = Severity::information};
}

/// @param torque  at which the range was taken [N*m]
Note teeth_note(double range, double torque) {
  return {.code = "motion.teeth",
          .text = fmt::format(
              "the deviations of the teeth turn the output by {} arcmin from peak to valley at {}; "
              "what passes within one tooth and deviating balls are left out",
              shown_number(range / units::arcmin, 3), shown_quantity(torque, "N*m", 3)),
          .path = "drivetrain.spring",
          .equation = "MO-58",
          .severity = Severity::information,
          .next_step = "Leave lines of the teeth out of kinematic_error, which adds to them."};
}

Note table_note(const CurveTable& table) {
  return {
      .code = "motion.curve_error",
      .text = fmt::format("the energies of cage, flexspline and circular spline are added; against "
                          "the coupled drive at {} random angles, the twist that the cracks "
                          "add is off by {} %, as root mean squares",
                          table.triples, shown_number(100 * *table.rms_share, 2)),
      .path = "drivetrain.spring",
      .equation = "MO-27",
      .severity = Severity::care,
      .next_step = "Run strainwave torsion --compare, which solves the cracks together."};
}

/// The maker's lines as pieces at the output (MO-14).
CatalogueSpring pieces_at_output(const GearSet& gear, const MakersLines& lines, double shaft) {
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  CatalogueSpring spring;
  const std::array<double, 3> stiffness{lines.K1, lines.K2, lines.K3};
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    spring.stiffness[i] = 1 / (step * step * (1 / stiffness[i] - shaft) + shaft);  // (MO-14)
  const MakersTorques torques = makers_torques(gear);
  spring.torque = {torques.T1 / std::abs(step), torques.T2 / std::abs(step)};  // (MO-14)
  return spring;
}

}  // namespace

DriveJoint drive_joint(const GearSet& gear, const Progress& progress,
                       std::optional<RestoringTorque> asked, const CurveSource& source) {
  check(gear);
  if (!gear.drivetrain)
    throw InputError("drivetrain",
                     "must be given for a motion; give [drivetrain] with motor_inertia and "
                     "load_inertia");
  const Drivetrain& train = *gear.drivetrain;
  const bool computed = asked.value_or(train.spring) == RestoringTorque::computed;
  DriveJoint made;
  Joint& joint = made.joint;
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  const bool coupled = missing_for_torsion_curve(gear).empty();
  made.notes = coupled ? AssembledDrive(gear).notes() : torsional_stiffness(gear).notes;
  // In the coupled drive, all cracks of the wave generator act inside the contacts.
  if (gear.wave_generator && coupled && !computed)
    for (const CrackReport& crack : wave_generator_compliance(gear).cracks)
      made.notes.push_back(contact_note(crack.path));
  MemberSum sum = members_of(gear, coupled);
  joint.cracks = std::move(sum.cracks);
  progress.at(0.1);
  if (computed) {
    ComputedCurve curve = source(gear, progress.part(0.1, 1.0));
    made.springs = SpringModel::computed_curve;
    joint.spring = LinearSpring{1 / curve.sound->at(0.0).at_torque(0.0).compliance};
    joint.table = std::move(curve.cracked);
    made.sound_table = std::move(curve.sound);
    made.table = curve.table;
    made.notes.push_back(cage_note());
    if (curve.table.teeth_range)
      made.notes.push_back(teeth_note(
          *curve.table.teeth_range, std::min(makers_torques(gear).rated, curve.table.most_torque)));
    if (curve.table.rms_share.value_or(0.0) > kLargestShare)
      made.notes.push_back(table_note(curve.table));
  } else if (coupled) {
    made.springs = SpringModel::coupled_drive;
    joint.spring = pieces_at_output(gear, makers_lines(without_cracks(gear)), sum.shaft);
  } else {
    joint.spring = LinearSpring{1 / (step * step * sum.flexspline_side + sum.shaft)};  // (MO-14)
  }
  const GearInertias own = gear_inertias(gear);
  const bool spline_turns = train.fixed == FixedMember::flexspline;
  joint.ratio = signed_ratio(arrangement_of(train.fixed), gear.drive.ratio);
  joint.input_inertia = train.motor_inertia + train.wave_generator_inertia.value_or(0.0);
  joint.output_inertia = train.load_inertia + own.shaft +
                         (spline_turns ? own.circular_spline : own.rim + own.hub);  // (MO-14)
  joint.damping = train.gear_damping;
  joint.input_damping = train.motor_damping;
  joint.output_damping = train.load_damping;
  joint.hysteresis = train.hysteresis;
  joint.slip_elements = train.slip_element;
  joint.input_friction = train.friction;
  joint.output_friction = train.load_friction;
  joint.gravity_torque = train.gravity_torque;
  joint.gravity_angle = train.gravity_angle;
  joint.kinematic_error = kinematic_error_of(gear);
  if (std::optional<Note> left_out = error_table_note(gear))
    made.notes.push_back(*std::move(left_out));
  if (train.coupling_stiffness)
    made.notes.push_back(
        {.code = "motion.rigid_coupling",
         .text = "the coupling between motor and wave generator is rigid in a motion, because a "
                 "joint has two inertias",
         .path = "drivetrain.coupling_stiffness",
         .equation = "MO-14",
         .severity = Severity::care,
         .next_step = "Compare with strainwave modes, which contains the coupling."});
  for_each_crack(gear, [&]<class Crack>(const std::string& path, const Crack&) {
    if constexpr (ContactCrack<Crack>)
      if (!computed) made.notes.push_back(contact_note(path));
  });
  if (!joint.cracks.empty()) made.notes.push_back(breathing_note(train.breathing));
  return made;
}

std::optional<Note> error_table_note(const GearSet& gear) {
  constexpr double kLargestLeftOut = 0.01;  // over the range [-]
  if (!gear.error_table) return std::nullopt;
  const ErrorLines& lines = gear.error_table->lines;
  if (!(lines.left_out > kLargestLeftOut * lines.range)) return std::nullopt;
  return Note{.code = "motion.error_table",
              .text = fmt::format("the {} lines of the table differ from its rows by up to {} of "
                                  "its range from peak to valley",
                                  lines.orders.size(), percent(lines.left_out / lines.range)),
              .path = "drivetrain.error_table",
              .equation = "MO-56",
              .severity = Severity::care,
              .next_step = "Smooth the table, or give fewer turns."};
}

std::vector<BreathingCrack> joint_cracks(const GearSet& gear) {
  return members_of(gear, missing_for_torsion_curve(gear).empty()).cracks;
}

}  // namespace strainwave

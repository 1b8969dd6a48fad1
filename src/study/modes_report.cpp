// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/modes_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_orders.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// The three springs of a drive.
enum class SpringPlace { mesh, body, shaft };

/// A crack that is a spring of its own.
struct SeriesCrack {
  std::string path;
  SpringPlace spring = SpringPlace::mesh;
  double compliance = 0.0;  ///< at the output, circular spline fixed [rad/(N*m)]; > 0
};

struct Member {
  std::string name;
  SpringPlace spring = SpringPlace::mesh;
  double compliance = 0.0;  ///< at the output, circular spline fixed [rad/(N*m)]
};

/// The members of a drive, with the cracks that are part of them.
struct Members {
  std::vector<Member> members;
  std::vector<SeriesCrack> cracks;
};

double sum_of(const std::vector<Member>& members, SpringPlace spring) {
  double sum = 0.0;
  for (const Member& member : members)
    if (member.spring == spring) sum += member.compliance;
  return sum;
}

DriveSprings springs_of(const std::vector<Member>& members) {
  return {.mesh = sum_of(members, SpringPlace::mesh),
          .body = sum_of(members, SpringPlace::body),
          .shaft = sum_of(members, SpringPlace::shaft)};
}

double part_of(const DrivetrainChain::Parts& parts, SpringPlace spring) {
  switch (spring) {
    case SpringPlace::mesh:
      return parts.mesh;
    case SpringPlace::body:
      return parts.body;
    case SpringPlace::shaft:
      break;
  }
  return parts.shaft;
}

/// The cracks of a member that are open under the sense of a torque.
std::vector<SeriesCrack> open_cracks(const MemberCompliance& member, SpringPlace spring,
                                     double torque) {
  std::vector<SeriesCrack> open;
  for (const CrackReport& crack : member.cracks) {
    const double compliance = (torque >= 0 ? crack.positive : crack.negative).at_output.value;
    if (compliance > 0) open.push_back({crack.path, spring, compliance});
  }
  return open;
}

double sum_of(const std::vector<SeriesCrack>& cracks) {
  double sum = 0.0;
  for (const SeriesCrack& crack : cracks) sum += crack.compliance;
  return sum;
}

/// The members by the sum.
/// @param torque  of the flexspline; @param output_torque  of the output shaft [N*m]
Members summed_members(const GearSet& gear, double torque, double output_torque) {
  Members made;
  const auto add = [&](std::string_view name, SpringPlace spring, double torque_of,
                       const MemberCompliance& of) {
    if (!of.unusable_because.empty()) throw SolverError(of.unusable_because);
    const std::vector<SeriesCrack> open = open_cracks(of, spring, torque_of);
    made.members.push_back({std::string(name), spring, of.intact + sum_of(open)});
    made.cracks.insert(made.cracks.end(), open.begin(), open.end());
  };
  if (gear.wave_generator)
    add("wave generator", SpringPlace::mesh, torque, wave_generator_compliance(gear));
  if (gear.flexspline) add("flexspline", SpringPlace::body, torque, flexspline_compliance(gear));
  if (gear.output_shaft)
    add("output shaft", SpringPlace::shaft, output_torque, output_shaft_compliance(gear));
  return made;
}

SpringPlace spring_of(CurveMember member) {
  switch (member) {
    case CurveMember::barrel:
    case CurveMember::diaphragm:
    case CurveMember::rim_shear:
    case CurveMember::boss_and_flange:
    case CurveMember::series_cracks:
      return SpringPlace::body;
    case CurveMember::output_shaft:
      return SpringPlace::shaft;
    case CurveMember::balls:
    case CurveMember::rim_bending:
    case CurveMember::outer_ring_bending:
    case CurveMember::barrel_warping:
    case CurveMember::diaphragm_warping:
    case CurveMember::rim_extension:
    case CurveMember::teeth:
    case CurveMember::circular_spline:
      break;
  }
  return SpringPlace::mesh;
}

/// The members by the tangent of the torsion curve.
Members coupled_members(const AssembledDrive& drive, double torque, double output_torque) {
  const TorsionCurve curve = torsion_curve(drive, std::array{torque});
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  const CurvePoint& at = curve.points.front();
  if (!std::isfinite(at.tangent_compliance))
    throw SolverError(
        fmt::format("no flank touches at {}, so the drive has no stiffness there; "
                    "choose a larger torque",
                    shown_quantity(torque, "N*m", 4, "torque")));
  const GearSet& gear = drive.gear();
  Members made;
  for (std::size_t k = 0; k < kCurveMembers; ++k) {
    const auto member = static_cast<CurveMember>(k);
    const double compliance = at.share[k] * at.tangent_compliance;
    if (compliance == 0) continue;
    std::string name(enum_name(member));
    std::ranges::replace(name, '_', ' ');
    made.members.push_back({std::move(name), spring_of(member), compliance});
  }
  // The cracks in line are those of flexspline and shaft, and each acts where it is.
  if (gear.flexspline)
    made.cracks = open_cracks(flexspline_compliance(gear), SpringPlace::body, torque);
  if (gear.output_shaft) {
    const std::vector<SeriesCrack> of_shaft =
        open_cracks(output_shaft_compliance(gear), SpringPlace::shaft, output_torque);
    for (Member& member : made.members) {
      if (member.name == "series cracks") member.compliance -= sum_of(of_shaft);
      if (member.name == "output shaft") member.compliance += sum_of(of_shaft);
    }
    // Without cracks of the flexspline, only the rounding of the difference is left.
    if (made.cracks.empty())
      std::erase_if(made.members,
                    [](const Member& member) { return member.name == "series cracks"; });
    made.cracks.insert(made.cracks.end(), of_shaft.begin(), of_shaft.end());
  }
  return made;
}

double compliance_of(const DriveSprings& springs, SpringPlace spring) {
  switch (spring) {
    case SpringPlace::mesh:
      return springs.mesh;
    case SpringPlace::body:
      return springs.body;
    case SpringPlace::shaft:
      break;
  }
  return springs.shaft;
}

/// Share of the elastic energy of a mode in a part of a spring of the drive (DY-4) [-].
/// @param compliance  of the part [rad/(N*m)]
double share_of(const DrivetrainChain& made, const std::vector<Member>& members,
                const ChainMode& mode, SpringPlace spring, double compliance) {
  double share = 0.0;
  for (std::size_t s = 0; s < made.parts.size(); ++s)
    share += mode.energy_share[s] * part_of(made.parts[s], spring);
  return share * compliance / compliance_of(springs_of(members), spring);
}

DriveMode mode_of(const DrivetrainChain& made, const std::vector<Member>& members,
                  const ChainMode& mode) {
  DriveMode of{.frequency = mode.frequency, .damping_ratio = mode.damping_ratio};
  const auto& inertias = made.chain.inertias;
  const auto energy = [&](std::size_t i) {
    return inertias[i].inertia * mode.shape[i] * mode.shape[i];
  };
  std::size_t most = 0;
  for (std::size_t i = 1; i < inertias.size(); ++i)
    if (energy(i) > energy(most)) most = i;
  for (std::size_t i = 0; i < inertias.size(); ++i)
    of.shape.push_back({inertias[i].name, mode.shape[i] / mode.shape[most]});
  for (std::size_t s = 0; s < made.chain.springs.size(); ++s)
    if (made.chain.springs[s].name == "coupling")
      of.energy.push_back({"coupling", mode.energy_share[s]});
  for (const Member& member : members)
    of.energy.push_back(
        {member.name, share_of(made, members, mode, member.spring, member.compliance)});
  return of;
}

/// The drive with springs, as a chain with its elastic modes.
struct Vibrating {
  std::vector<Member> members;
  std::vector<SeriesCrack> cracks;
  DrivetrainChain made;

  [[nodiscard]] std::vector<ChainMode> modes(MotorGives motor) const {
    std::vector<std::size_t> held;
    if (motor == MotorGives::speed) held.push_back(made.motor);
    std::vector<ChainMode> all = chain_modes(made.chain, held);
    std::erase_if(all, [](const ChainMode& mode) { return mode.frequency == 0; });
    return all;
  }
};

Vibrating vibrating(const GearSet& gear, Members of) {
  DrivetrainChain made = drivetrain_chain(*gear.drivetrain, gear.drive.ratio,
                                          springs_of(of.members), gear_inertias(gear));
  return {
      .members = std::move(of.members), .cracks = std::move(of.cracks), .made = std::move(made)};
}

/// (DY-11), by the inertias; the angles of both have a kinetic energy of 1.
double likeness(const TorsionalChain& chain, const ChainMode& a, const ChainMode& b) {
  double product = 0.0;
  for (std::size_t i = 0; i < chain.inertias.size(); ++i)
    product += chain.inertias[i].inertia * a.shape[i] * b.shape[i];
  return product * product;
}

/// For each mode the index of the same mode among others, each of them once (DY-11).  The pairs
/// with the largest likeness come first.
std::vector<std::size_t> same_modes(const TorsionalChain& chain, const std::vector<ChainMode>& of,
                                    const std::vector<ChainMode>& others) {
  std::vector<std::size_t> same(of.size(), 0);
  std::vector<bool> found(of.size(), false);
  std::vector<bool> taken(others.size(), false);
  for (std::size_t n = 0; n < std::min(of.size(), others.size()); ++n) {
    double best = -1.0;
    std::size_t first = 0;
    std::size_t second = 0;
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t k = 0; k < others.size(); ++k) {
        if (found[i] || taken[k]) continue;
        const double here = likeness(chain, of[i], others[k]);
        if (here <= best) continue;
        best = here;
        first = i;
        second = k;
      }
    same[first] = second;
    found[first] = true;
    taken[second] = true;
  }
  return same;
}

double stiffness_at_output(const GearSet& gear, const std::vector<Member>& members) {
  const DriveSprings springs = springs_of(members);
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  return 1 / (step * step * (springs.mesh + springs.body) + springs.shaft);  // (DY-10)
}

std::vector<ModeSpeed> critical_speeds(const GearSet& gear, double intact,
                                       std::optional<double> cracked) {
  std::vector<ModeSpeed> speeds;
  for (const DriveOrder& excitation : drive_orders(gear)) {
    ModeSpeed& of =
        speeds.emplace_back(ModeSpeed{.excitation = excitation.words,
                                      .order = excitation.order,
                                      .intact = critical_speed(intact, excitation.order)});
    if (cracked) of.cracked = critical_speed(*cracked, excitation.order);
  }
  return speeds;
}

/// Above it the damping ratio of first order is not reliable [-].
constexpr double kSmallDamping = 0.3;

void note_inertias(const GearSet& gear, std::vector<Note>& notes) {
  const auto missing = [&](std::string_view words, const std::string& name,
                           const std::string& path) {
    if (material_of(gear, name, path).density) return;
    notes.push_back({"modes.no_density",
                     fmt::format("the inertia of the {} is left out, because its material has no "
                                 "density; this changes only modes far above the first one",
                                 words),
                     path, "DY-9", Severity::information,
                     fmt::format("Give the density of the material {}.", name)});
  };
  const bool spline_turns = gear.drivetrain->fixed == FixedMember::flexspline;
  if (gear.flexspline && !spline_turns)
    missing("flexspline", gear.flexspline->material, "flexspline.material");
  if (gear.circular_spline && spline_turns)
    missing("circular spline", gear.circular_spline->material, "circular_spline.material");
  if (gear.output_shaft)
    missing("output shaft", gear.output_shaft->material, "output_shaft.material");
}

void note_damping(const ModesReport& report, std::vector<Note>& notes) {
  double most = 0.0;
  for (const MotorModes& of : report.conditions)
    for (const ModePair& pair : of.modes)
      most = std::max(
          {most, pair.intact.damping_ratio, pair.cracked ? pair.cracked->damping_ratio : 0.0});
  if (most > kSmallDamping)
    notes.push_back({"modes.large_damping",
                     fmt::format("a mode has a damping ratio of {}; above {:g} the ratios are not "
                                 "reliable, because they are of first order in the damping",
                                 shown_number(most, 3), kSmallDamping),
                     "drivetrain.gear_damping", "DY-5", Severity::information,
                     fmt::format("Do not use damping ratios above {:g}.", kSmallDamping)});
}

/// The modes for one condition of the motor.
/// @param without_one  the drive without each of its cracks, by the path of that crack
MotorModes motor_modes(const GearSet& gear, MotorGives motor, const Vibrating& intact,
                       const std::optional<Vibrating>& with_cracks,
                       const std::vector<std::pair<std::string, Vibrating>>& without_one) {
  MotorModes condition{.motor = motor};
  const TorsionalChain& chain = intact.made.chain;
  const std::vector<ChainMode> modes = intact.modes(motor);
  std::vector<ChainMode> softer;
  std::vector<std::size_t> same;
  if (with_cracks) {
    softer = with_cracks->modes(motor);
    same = same_modes(chain, modes, softer);
  }
  for (std::size_t m = 0; m < modes.size(); ++m) {
    ModePair pair{.number = static_cast<int>(m) + 1,
                  .intact = mode_of(intact.made, intact.members, modes[m])};
    std::optional<double> frequency;
    if (with_cracks) {
      const ChainMode& like = softer[same[m]];
      frequency = like.frequency;
      pair.cracked = mode_of(with_cracks->made, with_cracks->members, like);
      pair.change = *frequency / modes[m].frequency - 1;
      pair.likeness = likeness(chain, modes[m], like);
      for (const auto& [path, without] : without_one) {
        const std::vector<ChainMode> others = without.modes(motor);
        const ChainMode& other = others[same_modes(chain, softer, others)[same[m]]];
        CrackOnMode& crack = pair.cracks.emplace_back(
            CrackOnMode{.path = path, .change = *frequency / other.frequency - 1});
        for (const SeriesCrack& spring : with_cracks->cracks)
          if (spring.path == path)
            crack.share = share_of(with_cracks->made, with_cracks->members, like, spring.spring,
                                   spring.compliance);
      }
    }
    pair.critical_speeds = critical_speeds(gear, modes[m].frequency, frequency);
    condition.modes.push_back(std::move(pair));
  }
  return condition;
}

/// The drive without one of its cracks.
GearSet without_crack(GearSet gear, const std::string& path) {
  for_each_cracked_member(gear, [&](std::string_view name, auto& member) {
    for (std::size_t i = 0; i < member.crack.size(); ++i)
      if (path == fmt::format("{}.crack[{}]", name, i)) {
        member.crack.erase(member.crack.begin() + static_cast<std::ptrdiff_t>(i));
        return;
      }
  });
  return gear;
}

GearSet without_any_crack(GearSet gear) {
  for_each_cracked_member(gear, [](std::string_view, auto& member) { member.crack.clear(); });
  return gear;
}

}  // namespace

ModesReport modes_report(const GearSet& gear, std::optional<double> torque,
                         const Progress& progress) {
  check(gear);
  if (!gear.drivetrain)
    throw InputError("drivetrain",
                     "must be given for the modes; give [drivetrain] with motor_inertia and "
                     "load_inertia");
  ModesReport report;
  report.torque = torque.value_or(gear.load.torque);
  report.signed_ratio = signed_ratio(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  if (const auto speed = makers_limits(gear).largest_speed) report.largest_speed = speed->value;
  const std::string missing = missing_for_torsion_curve(gear);
  report.springs = missing.empty() ? SpringModel::coupled_drive : SpringModel::members;
  std::vector<std::string> paths;
  for_each_crack(gear, [&](const std::string& path, const auto&) { paths.push_back(path); });
  const double drives = static_cast<double>(paths.empty() ? 1 : 2 + paths.size());
  double done = 0.0;
  const auto vibrating_drive = [&](const GearSet& of) {
    progress.at(done++ / drives);
    const double at_flexspline =
        flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio) * report.torque;
    return vibrating(gear, report.springs == SpringModel::coupled_drive
                               ? coupled_members(AssembledDrive(of), at_flexspline, report.torque)
                               : summed_members(of, at_flexspline, report.torque));
  };
  const Vibrating intact = vibrating_drive(without_any_crack(gear));
  report.intact_stiffness = stiffness_at_output(gear, intact.members);
  std::optional<Vibrating> with_cracks;
  std::vector<std::pair<std::string, Vibrating>> without_one;
  if (!paths.empty()) {
    with_cracks = vibrating_drive(gear);
    report.cracked_stiffness = stiffness_at_output(gear, with_cracks->members);
    for (const std::string& path : paths)
      without_one.emplace_back(path, vibrating_drive(without_crack(gear, path)));
  }
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed})
    report.conditions.push_back(motor_modes(gear, motor, intact, with_cracks, without_one));
  note_inertias(gear, report.notes);
  note_damping(report, report.notes);
  const std::vector<Note> of_springs = report.springs == SpringModel::coupled_drive
                                           ? AssembledDrive(gear).notes()
                                           : torsional_stiffness(gear).notes;
  report.notes.insert(report.notes.end(), of_springs.begin(), of_springs.end());
  report.equations = {"DY-1", "DY-2", "DY-3", "DY-4", "DY-5", "DY-8", "DY-9", "DY-10", "DY-11"};
  return report;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "vibrating_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/motion/harmonic_balance.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// The members of a drive, with the cracks that are part of them.
struct VibratingParts {
  std::vector<VibratingMember> members;
  std::vector<SeriesCrack> cracks;
};

double sum_of(const std::vector<VibratingMember>& members, SpringPlace spring) {
  double sum = 0.0;
  for (const VibratingMember& member : members)
    if (member.spring == spring) sum += member.compliance;
  return sum;
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

constexpr double kSenseOnly = 1e-9;  // torque that opens cracks and does nothing else [N*m]

/// The drive under another torque beside the axial force of its load, because both together decide
/// which cracks are open.  Without an axial force the sense of the torque decides alone.
/// @param torque  of the output [N*m]; 0 counts as a torque that opens cracks and does nothing else
GearSet opened_by(const GearSet& gear, double torque) {
  GearSet loaded = gear;
  if (gear.load.axial_force != 0) loaded.load.torque = torque != 0 ? torque : kSenseOnly;
  return loaded;
}

/// Whether the file states numbers of the wave generator that belong to the torque of its load.
bool of_one_torque(const WaveGenerator& of) {
  const auto given = [](const auto& crack) {
    if constexpr (requires { crack.stress_driver; })
      return crack.stress_driver == StressDriver::given;
    else
      return false;
  };
  return of.displacements ||
         std::ranges::any_of(of.crack, [&](const auto& crack) { return std::visit(given, crack); });
}

/// The members by the sum.
/// @param torque  of the flexspline; @param output_torque  of the output shaft [N*m]
VibratingParts summed_members(const GearSet& gear, double torque, double output_torque) {
  const GearSet opened = opened_by(gear, output_torque);
  VibratingParts made;
  const auto add = [&](std::string_view name, SpringPlace spring, double torque_of,
                       const MemberCompliance& of) {
    if (!of.unusable_because.empty()) throw SolverError(of.unusable_because);
    const std::vector<SeriesCrack> open = open_cracks(of, spring, torque_of);
    made.members.push_back({std::string(name), spring, of.intact + sum_of(open)});
    made.cracks.insert(made.cracks.end(), open.begin(), open.end());
  };
  if (gear.wave_generator)
    add("wave generator", SpringPlace::mesh, torque, wave_generator_compliance(gear));
  if (gear.flexspline) add("flexspline", SpringPlace::body, torque, flexspline_compliance(opened));
  if (gear.output_shaft)
    add("output shaft", SpringPlace::shaft, output_torque, output_shaft_compliance(opened));
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

/// The members by the tangent of the torsion curve at a point with a stiffness.
VibratingParts coupled_members(const GearSet& gear, const CurvePoint& at, double output_torque) {
  VibratingParts made;
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
    made.cracks = open_cracks(flexspline_compliance(gear), SpringPlace::body, at.torque);
  if (gear.output_shaft) {
    const std::vector<SeriesCrack> of_shaft =
        open_cracks(output_shaft_compliance(gear), SpringPlace::shaft, output_torque);
    for (VibratingMember& member : made.members) {
      if (member.name == "series cracks") member.compliance -= sum_of(of_shaft);
      if (member.name == "output shaft") member.compliance += sum_of(of_shaft);
    }
    // Without cracks of the flexspline, only the rounding of the difference is left.
    if (made.cracks.empty())
      std::erase_if(made.members,
                    [](const VibratingMember& member) { return member.name == "series cracks"; });
    made.cracks.insert(made.cracks.end(), of_shaft.begin(), of_shaft.end());
  }
  return made;
}

void note_inertias(const GearSet& gear, std::vector<Note>& notes) {
  const auto missing = [&](const std::string& words, const std::string& name,
                           const std::string& path) {
    if (density_of(gear, name)) return;
    notes.push_back({"modes.no_density",
                     fmt::format("the inertia of the {} is left out, because its material has no "
                                 "density; this changes only modes far above the first one",
                                 words),
                     path, "DY-9", Severity::information,
                     fmt::format("Give the density of the material {}.", name)});
  };
  const bool spline_turns = gear.drivetrain->fixed == FixedMember::flexspline;
  if (gear.flexspline && !spline_turns) {
    std::set<std::string> names;
    for_each_section(*gear.flexspline, [&](std::string_view, const auto& section) {
      names.insert(material_name(*gear.flexspline, section));
    });
    if (names.empty()) names.insert(gear.flexspline->material);
    for (const std::string& name : names)
      missing(names.size() == 1 ? "flexspline" : "flexspline's sections of " + name, name,
              "flexspline.material");
  }
  if (gear.circular_spline && spline_turns)
    missing("circular spline", gear.circular_spline->material, "circular_spline.material");
  if (gear.output_shaft)
    missing("output shaft", gear.output_shaft->material, "output_shaft.material");
}

constexpr double kSameCracks = 1e-9;  // of their compliance and of a frequency [-]

/// Cracks that open under one sense only have two linear drives about torque 0.
void note_both_senses(const GearSet& gear, std::vector<Note>& notes) {
  const std::vector<std::optional<VibratingDrive>> drives =
      vibrating_drives(gear, std::array{kSenseOnly, -kSenseOnly});
  if (!drives[0] || !drives[1]) return;
  const auto differ = [](double one, double other) {
    return std::abs(one - other) > kSameCracks * std::max(one, other);
  };
  if (!differ(sum_of(drives[0]->cracks), sum_of(drives[1]->cracks))) return;
  const std::vector<ChainMode> forward = drives[0]->modes(MotorGives::speed);
  const std::vector<ChainMode> backward = drives[1]->modes(MotorGives::speed);
  if (forward.empty() || backward.empty()) return;
  const double f = forward.front().frequency;
  const double b = backward.front().frequency;
  if (!differ(f, b)) return;
  notes.push_back(
      {.code = "modes.one_sense",
       .text =
           fmt::format("the torque is 0, and the answer holds while the cracks are as one sense "
                       "of the torque opens them; with a locked input the first mode has {} "
                       "under positive torque and {} under negative torque, and a small "
                       "vibration through 0 has {}",
                       shown_quantity(f, "Hz", 6), shown_quantity(b, "Hz", 6),
                       shown_quantity(bilinear_frequency(f, b), "Hz", 6)),
       .path = "load.torque",
       .equation = "MO-16",
       .severity = Severity::care,
       .next_step = "Give a torque that the drive bears, or run strainwave backbone, which follows "
                    "the cracks over a period."});
}

}  // namespace

DriveSprings springs_of(const std::vector<VibratingMember>& members) {
  return {.mesh = sum_of(members, SpringPlace::mesh),
          .body = sum_of(members, SpringPlace::body),
          .shaft = sum_of(members, SpringPlace::shaft)};
}

std::vector<std::size_t> VibratingDrive::held(MotorGives motor) const {
  if (motor == MotorGives::torque) return {};
  return {made.motor};
}

std::vector<ChainMode> VibratingDrive::modes(MotorGives motor) const {
  std::vector<ChainMode> all = chain_modes(made.chain, held(motor));
  std::erase_if(all, [](const ChainMode& mode) { return mode.frequency == 0; });
  return all;
}

double VibratingDrive::stiffness() const {
  const DriveSprings springs = springs_of(members);
  return 1 / (step * step * (springs.mesh + springs.body) + springs.shaft);  // (DY-10)
}

GearSet without_crack(GearSet gear, const std::string& path) {
  const GearSet before = gear;
  for_each_cracked_member(gear, [&](std::string_view name, auto& member) {
    for (std::size_t i = 0; i < member.crack.size(); ++i)
      if (path == fmt::format("{}.crack[{}]", name, i)) {
        member.crack.erase(member.crack.begin() + static_cast<std::ptrdiff_t>(i));
        return;
      }
  });
  drop_lost_paths(gear, before);
  return gear;
}

std::vector<std::optional<VibratingDrive>> vibrating_drives(const GearSet& gear,
                                                            std::span<const double> torques) {
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  const GearInertias own = gear_inertias(gear);
  const auto drive_with = [&](VibratingParts parts) {
    DrivetrainChain made =
        drivetrain_chain(*gear.drivetrain, gear.drive.ratio, springs_of(parts.members), own);
    return VibratingDrive{.members = std::move(parts.members),
                          .cracks = std::move(parts.cracks),
                          .made = std::move(made),
                          .step = step};
  };
  std::vector<std::optional<VibratingDrive>> drives;
  if (!missing_for_torsion_curve(gear).empty()) {
    for (const double torque : torques)
      drives.emplace_back(drive_with(summed_members(gear, step * torque, torque)));
    return drives;
  }
  const auto add_coupled = [&](const GearSet& loaded, std::span<const double> some) {
    std::vector<double> of_flexspline;
    for (const double torque : some) of_flexspline.push_back(step * torque);
    const TorsionCurve curve = torsion_curve(AssembledDrive(loaded), of_flexspline);
    if (!curve.usable()) throw SolverError(curve.unusable_because);
    for (std::size_t n = 0; n < some.size(); ++n) {
      drives.emplace_back();
      if (std::isfinite(curve.points[n].tangent_compliance))
        drives.back() = drive_with(coupled_members(loaded, curve.points[n], some[n]));
    }
  };
  if (gear.load.axial_force == 0)
    add_coupled(gear, torques);
  else
    for (const double torque : torques) add_coupled(opened_by(gear, torque), std::span(&torque, 1));
  return drives;
}

VibratingDrive vibrating_drive(const GearSet& gear, double torque) {
  std::optional<VibratingDrive> drive =
      std::move(vibrating_drives(gear, std::array{torque}).front());
  if (!drive)
    throw SolverError(
        fmt::format("no flank touches at {}, so the drive has no stiffness there; "
                    "choose a larger torque",
                    shown_quantity(torque, "N*m", 4, "torque")));
  return std::move(*drive);
}

GearSet with_load_torque(GearSet gear, double torque) {
  if (torque != 0 && !(gear.wave_generator && of_one_torque(*gear.wave_generator)))
    gear.load.torque = torque;
  return gear;
}

VibratingStates vibrating_states(const GearSet& of_file, const VibratingOptions& options,
                                 std::string_view purpose, const Progress& progress) {
  check(of_file);
  if (!of_file.drivetrain)
    throw InputError("drivetrain",
                     fmt::format("must be given for {}; give [drivetrain] with motor_inertia and "
                                 "load_inertia",
                                 purpose));
  const double torque = options.torque.value_or(of_file.load.torque);
  require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  const GearSet gear = with_load_torque(of_file, torque);
  const bool coupled = missing_for_torsion_curve(gear).empty();
  std::vector<std::string> paths;
  for_each_crack(gear, [&](const std::string& path, const auto&) { paths.push_back(path); });
  const double drives =
      static_cast<double>(paths.empty() ? 1 : 2 + (options.without_each_crack ? paths.size() : 0));
  double done = 0.0;
  const auto vibrating = [&](const GearSet& of) {
    progress.at(done++ / drives);
    return vibrating_drive(of, torque);
  };
  VibratingStates states{.torque = torque,
                         .springs = coupled ? SpringModel::coupled_drive : SpringModel::members,
                         .intact = vibrating(without_cracks(gear))};
  if (!paths.empty()) {
    states.with_cracks = vibrating(gear);
    if (options.without_each_crack)
      for (const std::string& path : paths)
        states.without_one.emplace_back(path, vibrating(without_crack(gear, path)));
  }
  if (torque == 0 && states.with_cracks) note_both_senses(gear, states.notes);
  note_inertias(gear, states.notes);
  const std::vector<Note> of_springs =
      coupled ? AssembledDrive(gear).notes() : torsional_stiffness(gear).notes;
  states.notes.insert(states.notes.end(), of_springs.begin(), of_springs.end());
  return states;
}

}  // namespace strainwave

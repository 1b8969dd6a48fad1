// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/modes_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/study/drive_orders.hpp"
#include "vibrating_drive.hpp"

namespace strainwave {
namespace {

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
double share_of(const DrivetrainChain& made, const std::vector<VibratingMember>& members,
                const ChainMode& mode, SpringPlace spring, double compliance) {
  double share = 0.0;
  for (std::size_t s = 0; s < made.parts.size(); ++s)
    share += mode.energy_share[s] * part_of(made.parts[s], spring);
  return share * compliance / compliance_of(springs_of(members), spring);
}

DriveMode mode_of(const DrivetrainChain& made, const std::vector<VibratingMember>& members,
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
  for (const VibratingMember& member : members)
    of.energy.push_back(
        {member.name, share_of(made, members, mode, member.spring, member.compliance)});
  return of;
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
MotorModes motor_modes(const GearSet& gear, MotorGives motor, const VibratingDrive& intact,
                       const std::optional<VibratingDrive>& with_cracks,
                       const std::vector<std::pair<std::string, VibratingDrive>>& without_one) {
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

}  // namespace

ModesReport modes_report(const GearSet& gear, std::optional<double> torque,
                         const Progress& progress) {
  const VibratingStates states =
      vibrating_states(gear, {.torque = torque, .without_each_crack = true}, "the modes", progress);
  ModesReport report;
  report.torque = states.torque;
  report.springs = states.springs;
  report.intact_stiffness = states.intact.stiffness();
  if (states.with_cracks) report.cracked_stiffness = states.with_cracks->stiffness();
  report.signed_ratio = signed_ratio(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  if (const auto speed = makers_limits(gear).largest_speed) report.largest_speed = speed->value;
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed})
    report.conditions.push_back(
        motor_modes(gear, motor, states.intact, states.with_cracks, states.without_one));
  report.notes = states.notes;
  note_damping(report, report.notes);
  report.equations = {"DY-1", "DY-2", "DY-3", "DY-4", "DY-5", "DY-8", "DY-9", "DY-10", "DY-11"};
  return report;
}

}  // namespace strainwave

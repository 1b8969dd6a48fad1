// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/modes_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/study/drive_orders.hpp"
#include "strainwave/torsion/compare.hpp"
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

/// Intervals between the torques of the map, on both sides of zero together.
constexpr int kIntervals = 48;

/// The torques of the map [N*m].
std::vector<double> torques_of_map(const GearSet& gear, double torque) {
  const MakersLimits limits = makers_limits(gear);
  double largest = std::abs(torque);
  for (const auto& limit : {limits.repeated_peak, limits.rated_torque})
    if (limit) {
      largest = std::max(largest, limit->value);
      break;
    }
  std::vector<double> torques;
  for (int n = 0; n <= kIntervals; ++n) torques.push_back(largest * (2.0 * n / kIntervals - 1));
  return torques;
}

/// Follows the modes from the torque of the report to smaller and to larger torques.
std::vector<ModeAtTorque> modes_over_torque(const GearSet& gear, const VibratingStates& states) {
  if (states.springs != SpringModel::coupled_drive) return {};
  const std::vector<double> torques = torques_of_map(gear, states.torque);
  const auto intact = vibrating_drives(without_cracks(gear), torques);
  std::vector<std::optional<VibratingDrive>> cracked(torques.size());
  if (states.with_cracks) cracked = vibrating_drives(gear, torques);
  std::vector<ModeAtTorque> map;
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
    const TorsionalChain& chain = states.intact.made.chain;
    const std::vector<ChainMode> asked = states.intact.modes(motor);
    std::vector<std::vector<ModeAtTorque>> rows(torques.size());
    // The rows of one torque, and the modes there in the order of those before.
    const auto row_of = [&](std::size_t n, const std::vector<ChainMode>& before, bool nearest) {
      const std::vector<ChainMode> here = intact[n]->modes(motor);
      const std::vector<std::size_t> same = same_modes(chain, before, here);
      std::vector<ChainMode> in_order;
      for (const std::size_t at : same) in_order.push_back(here[at]);
      std::vector<ChainMode> softer;
      std::vector<std::size_t> same_softer;
      if (cracked[n]) {
        softer = cracked[n]->modes(motor);
        same_softer = same_modes(chain, in_order, softer);
      }
      for (std::size_t m = 0; m < in_order.size(); ++m) {
        ModeAtTorque& row = rows[n].emplace_back(ModeAtTorque{.torque = torques[n],
                                                              .motor = motor,
                                                              .number = static_cast<int>(m) + 1,
                                                              .intact = in_order[m].frequency});
        if (cracked[n]) row.cracked = softer[same_softer[m]].frequency;
        if (!nearest) row.likeness = likeness(chain, before[m], in_order[m]);
      }
      return in_order;
    };
    std::optional<std::size_t> start;
    for (std::size_t n = 0; n < torques.size(); ++n)
      if (intact[n] && (!start || std::abs(torques[n] - states.torque) <
                                      std::abs(torques[*start] - states.torque)))
        start = n;
    if (!start) continue;
    const std::vector<ChainMode> first = row_of(*start, asked, true);
    for (const int way : {-1, +1}) {
      std::vector<ChainMode> before = first;
      for (std::size_t n = *start + static_cast<std::size_t>(way); n < torques.size();
           n += static_cast<std::size_t>(way))
        if (intact[n]) before = row_of(n, before, false);
    }
    for (const std::vector<ModeAtTorque>& row : rows) map.insert(map.end(), row.begin(), row.end());
  }
  return map;
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
  try {
    report.over_torque = modes_over_torque(gear, states);
  } catch (const SolverError& error) {
    report.notes.push_back(
        {.code = "modes.no_map",
         .text =
             fmt::format("the map of the modes over the torque is left out, because the torsion "
                         "curve does not reach its largest torques: {}",
                         error.what()),
         .path = "rating",
         .equation = "DY-8",
         .severity = Severity::care,
         .next_step = "Use the modes at the torque of the answer; correct the torques of [rating] "
                      "if the drive is not made for them."});
  }
  note_damping(report, report.notes);
  report.equations = {"DY-1", "DY-2", "DY-3", "DY-4", "DY-5", "DY-8", "DY-9", "DY-10", "DY-11"};
  return report;
}

void add_modes_over_growth(ModesReport& report, const GearSet& gear, int points,
                           const Progress& progress) {
  GrowthOptions options;
  options.points = points;
  const GrowthReport growth = grow_cracks(gear, options, progress.part(0.0, 0.9));
  ModesOverGrowth over{.sentence = growth.sentence, .life = growth.life};
  std::array<std::vector<ChainMode>, 2> before;
  for (std::size_t n = 0; n < growth.drives.size(); ++n) {
    const VibratingDrive drive =
        vibrating_drive(with_load_torque(growth.drives[n], report.torque), report.torque);
    ModeOverGrowth row{.time = growth.stiffness[n].time};
    for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
      const bool is_free = motor == MotorGives::torque;
      std::vector<ChainMode>& last = before[is_free ? 0 : 1];
      std::vector<ChainMode> here = drive.modes(motor);
      if (here.empty()) continue;
      if (last.empty()) last = here;
      // The followed mode stands first from here on.
      std::swap(here.front(), here[same_modes(drive.made.chain, last, here).front()]);
      if (is_free && n > 0) row.likeness = likeness(drive.made.chain, last.front(), here.front());
      (is_free ? row.free : row.locked) = here.front().frequency;
      last = std::move(here);
    }
    const ModeOverGrowth& first = over.rows.empty() ? row : over.rows.front();
    if (row.free) row.free_change = *row.free / *first.free - 1;
    if (row.locked) row.locked_change = *row.locked / *first.locked - 1;
    over.rows.push_back(row);
  }
  report.over_growth = std::move(over);
  for (const Note& note : growth.notes)
    if (std::ranges::find(report.notes, note) == report.notes.end()) report.notes.push_back(note);
  for (const std::string& tag : growth.equations)
    if (std::ranges::find(report.equations, tag) == report.equations.end())
      report.equations.push_back(tag);
}

}  // namespace strainwave

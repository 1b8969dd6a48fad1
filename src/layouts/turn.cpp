// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/turn.hpp"

#include <fmt/format.h>

#include "strainwave/core/units.hpp"
#include "strainwave/io/turn_table_file.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/turn.hpp"

namespace strainwave {

std::string drive_turn_text(const DriveTurn& turn, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n" + verdict_text(evidence_of(turn).verdict) + '\n';
  const TurnRange& K = turn.governing().mode_I;
  constexpr double kMPaRootMetre = 1e6;
  text += paragraph(
      fmt::format("K_I of {} runs from {:.4g} to {:.4g} MPa*m^0.5 twice in a turn of the wave "
                  "generator: Delta K = {:.4g} MPa*m^0.5, R = {:.3g}.",
                  turn.path, K.least / kMPaRootMetre, K.largest / kMPaRootMetre,
                  K.range / kMPaRootMetre, K.ratio));
  text += paragraph(fmt::format(
      "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides. The stress "
      "of the sound wall normal to the crack is up to {:.3g} MPa{}.",
      turn.contact.lobe_force, turn.contact.half_arc / units::deg, turn.largest_stress / units::MPa,
      turn.large_rotations ? ", with large rotations of the oval" : ""));
  for (const SizedTurn& size : turn.sizes)
    for (const LoadedTurn& torque : size.torques)
      text += fmt::format("\n{}, torque {:+.6g} N*m\n", size.name(), torque.torque) +
              turn_rows(torque.stations, !size.depth);
  text += "\nNotes\n" + notes_text(turn.notes);
  return text + '\n' + equations_text(turn.equations);
}

std::string drive_turn_csv(const DriveTurn& turn, const GearSet& gear) {
  return turn_table_text(turn_table(turn.sizes, turn_conditions(gear, turn.path)), {});
}

std::string drive_turn_plot(const DriveTurn& turn, const GearSet& gear) {
  return turn_plot(turn.sizes, gear.name);
}

}  // namespace strainwave

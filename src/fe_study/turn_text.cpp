// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "run_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/turn_run.hpp"
#include "strainwave/io/turn_table_file.hpp"
#include "strainwave/present/turn.hpp"

namespace strainwave::fe_study {
namespace {

using gear_fem::TorqueTurn;

std::string of_check(const std::optional<double>& check) {
  return check ? fmt::format("{:.1e}", *check) : std::string("nothing is released");
}

void write(std::string& text, const TorqueTurn& turn, bool through) {
  text +=
      fmt::format(" torque {:+.6g} N*m; the faces touch over {:.3g} to {:.3g} % of the crack\n",
                  turn.torque, 100 * turn.least_contact_share, 100 * turn.largest_contact_share);
  text += fmt::format("    largest opening {:.3g} um at {:.4g} deg\n", 1e6 * turn.largest_opening,
                      turn.at_opening / units::deg);
  text += turn_rows(turn.stations, through);
  text += fmt::format("    checks at {:.4g} deg: dC/dA {}, K {}, equilibrium {:.1e}\n",
                      turn.checked_angle / units::deg, of_check(turn.checks.growth_check),
                      of_check(turn.checks.mode_check), turn.checks.equilibrium_residual);
}

void write(std::string& text, const TurnAtSize& size) {
  const gear_fem::CrackTurn& turn = size.turn;
  text += fmt::format("\n{}: {} states, {} unknowns, {}\n", size.name(), turn.states, turn.unknowns,
                      verdict(turn.usable, turn.reason));
  for (const TorqueTurn& torque : turn.torques) write(text, torque, !size.depth);
}

}  // namespace

std::string turn_csv(const TurnRun& run, const GearSet& gear) {
  if (!run.calculated) return plan_text(run.plan);
  const bool surface = run.sizes.front().depth.has_value();
  const std::vector<SizedTurn> turns = run.turns();
  const std::vector<std::string> remarks = {
      fmt::format("K of {} over a turn of the wave generator by finite elements, {} tip.", run.path,
                  governing_station(turns)->tip),
      fmt::format(
          "Stations {}; the faces may touch, then K_I = 0.",
          surface ? "from the place of the front next to the surface, 0, to the deepest point, 1"
                  : "from -1 at the inner face to 1 at the outer face")};
  TurnTable table = turn_table(turns, turn_conditions(gear, run.path));
  table.unusable_because = run.reason();
  return turn_table_text(table, remarks);
}

std::string turn_text(const TurnRun& run, const GearSet& gear) {
  if (!run.calculated) return plan_text(run.plan);
  std::string text = fmt::format("Finite elements: {}\n{} over a turn of the wave generator\n",
                                 gear.name.empty() ? "drive" : gear.name, run.path);
  const gear_fem::OvalContact& contact = run.sizes.front().turn.contact;
  text += fmt::format(
      "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides, at most {:.3g} "
      "MPa\n",
      contact.lobe_force, contact.half_arc / units::deg, contact.largest_pressure / units::MPa);
  const gear_fem::CrackTurn& first = run.sizes.front().turn;
  text += contact.large_rotations
              ? fmt::format(
                    "Large rotations of the oval change the stress normal to the crack by up "
                    "to {:.3g} MPa of {:.3g} MPa\n",
                    first.rotation_stress / units::MPa, first.largest_stress / units::MPa)
              : fmt::format(
                    "The oval is computed for small rotations; the stress normal to the "
                    "crack is up to {:.3g} MPa\n",
                    first.largest_stress / units::MPa);
  for (const TurnAtSize& size : run.sizes) write(text, size);
  if (!run.notes.empty()) text += "\nNotes\n";
  for (const Note& note : run.notes)
    text += "  " + wrapped("- " + note.text, kTextWidth - 2, 4) + "\n";
  return text;
}

std::string turn_plot(const TurnRun& run, const GearSet& gear) {
  return strainwave::turn_plot(run.turns(), gear.name);
}

}  // namespace strainwave::fe_study

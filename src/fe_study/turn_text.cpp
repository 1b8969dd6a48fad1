// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "run_text.hpp"
#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/turn_run.hpp"

namespace strainwave::fe_study {
namespace {

using gear_fem::StationTurn;
using gear_fem::TorqueTurn;
using gear_fem::TurnFactor;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMPaRootMetre = 1e6;

std::string place_of(const StationTurn& station, bool through) {
  if (station.station == -1) return "inner face";
  if (station.station == 1) return through ? "outer face" : "deepest";
  return through ? fmt::format("{:+.2f}", station.station) : fmt::format("{:.2f}", station.station);
}

std::string of_check(const std::optional<double>& check) {
  return check ? fmt::format("{:.1e}", *check) : std::string("nothing is released");
}

void write(std::string& text, const TorqueTurn& turn, bool through) {
  text +=
      fmt::format(" torque {:+.6g} N*m; the faces touch over {:.3g} to {:.3g} % of the crack\n",
                  turn.torque, 100 * turn.least_contact_share, 100 * turn.largest_contact_share);
  text +=
      "    station               K_max     K_min   Delta K  MPa*m^0.5       R  open [%]  at "
      "[deg]\n";
  for (const StationTurn& station : turn.stations) {
    const gear_fem::TurnRange& K = station.mode_I;
    text += fmt::format(
        "    {:<17} {:>9.4g} {:>9.4g} {:>9.4g}            {:>7.3g}   {:>7.3g}   {:>7.3g}\n",
        fmt::format("{} {}", station.tip, place_of(station, through)), K.largest / kMPaRootMetre,
        K.least / kMPaRootMetre, K.range / kMPaRootMetre, K.ratio, 100 * K.open_share,
        K.at_largest / kDegree);
  }
  text += fmt::format("    checks at {:.4g} deg: dC/dA {}, K {}, equilibrium {:.1e}\n",
                      turn.checked_angle / kDegree, of_check(turn.checks.growth_check),
                      of_check(turn.checks.mode_check), turn.checks.equilibrium_residual);
}

void write(std::string& text, const TurnAtSize& size) {
  const gear_fem::CrackTurn& turn = size.turn;
  text += fmt::format("\n{}: {} states, {} unknowns, {}\n", size.name(), turn.states, turn.unknowns,
                      verdict(turn.usable, turn.reason));
  for (const TorqueTurn& torque : turn.torques) write(text, torque, !size.depth);
}

}  // namespace

std::string turn_csv(const TurnRun& run) {
  if (!run.calculated) return plan_text(run.plan);
  const bool surface = run.sizes.front().depth.has_value();
  std::string text = fmt::format(
      "# K of {} over a turn of the wave generator by finite elements, {} tip.\n"
      "# Stations {}; the faces may touch, then K_I = 0.\n",
      run.path, run.governing_tip(),
      surface ? "from the place of the front next to the surface, 0, to the deepest point, 1"
              : "from -1 at the inner face to 1 at the outer face");
  if (const std::string reason = run.reason(); !reason.empty())
    text += fmt::format("# NOT usable: {}\n", reason);
  text += surface ? "depth" : "half_length";
  text +=
      " [mm],torque [N*m],station,angle [deg],K_I [MPa*m^0.5],K_II [MPa*m^0.5],K_III "
      "[MPa*m^0.5]\n";
  for (const TurnAtSize& size : run.sizes)
    for (const TorqueTurn& torque : size.turn.torques)
      for (const StationTurn& station : torque.stations) {
        if (station.tip != run.governing_tip()) continue;
        const bool first =
            &station == &torque.stations.front() || (&station - 1)->tip != station.tip;
        for (const TurnFactor& K : station.factors)
          text +=
              fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.6g},{:.6g},{:.6g}\n",
                          size.depth.value_or(size.half_length) / units::mm, torque.torque,
                          surface && first ? 0.0 : station.station, K.angle / kDegree,
                          K.K_I / kMPaRootMetre, K.K_II / kMPaRootMetre, K.K_III / kMPaRootMetre);
      }
  return text;
}

std::string turn_text(const TurnRun& run, const GearSet& gear) {
  if (!run.calculated) return plan_text(run.plan);
  std::string text = fmt::format("Finite elements: {}\n{} over a turn of the wave generator\n",
                                 gear.name.empty() ? "drive" : gear.name, run.path);
  const gear_fem::OvalContact& contact = run.sizes.front().turn.contact;
  text += fmt::format(
      "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides, at most {:.3g} "
      "MPa\n",
      contact.lobe_force, contact.half_arc / kDegree, contact.largest_pressure / units::MPa);
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
  std::vector<PlotPanel> panels;
  for (const TurnAtSize& size : run.sizes)
    for (const TorqueTurn& torque : size.turn.torques) {
      PlotPanel& panel = panels.emplace_back();
      panel.title = fmt::format("T = {:.6g} N·m, {}, {} tip", torque.torque, size.name(),
                                run.governing_tip());
      if (panels.size() == 1) panel.subtitle = gear.name;
      panel.x_label = "angle from a lobe to the crack [deg]";
      panel.y_label = "K_I [MPa·√m]";
      panel.legend_title = "station";
      for (const StationTurn& station : torque.stations) {
        if (station.tip != run.governing_tip()) continue;
        PlotSeries line{.label = place_of(station, !size.depth)};
        for (const TurnFactor& K : station.factors) {
          line.x.push_back(K.angle / kDegree);
          line.y.push_back(K.K_I / kMPaRootMetre);
        }
        panel.series.push_back(std::move(line));
      }
    }
  return svg_plot(panels);
}

}  // namespace strainwave::fe_study

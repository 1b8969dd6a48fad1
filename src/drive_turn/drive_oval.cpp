// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_turn/drive_oval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cup_notes.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Even places of the parts of the wall, with their ends.
std::vector<ShellPlace> places_of(const OvalShell& shell) {
  std::vector<ShellPlace> places;
  for (const WallPart part : {WallPart::diaphragm, WallPart::barrel, WallPart::rim}) {
    if (part == WallPart::diaphragm && !shell.cup.diaphragm) continue;
    const auto [from, to] = shell.cup.ends(part);
    for (int i = 0; i < kOvalPlaces; ++i)
      places.push_back(shell.at(part, from + (to - from) * i / (kOvalPlaces - 1)));
  }
  return places;
}

OvalStation over_turn(const OvalShell& shell, const ShellPlace& place, double zeta, double torque) {
  OvalStation station{.part = place.part,
                      .at = place.at,
                      .face = zeta < 0 ? "inner" : "outer",
                      .hoop = {},
                      .meridional = {},
                      .shear = {},
                      .equivalent = {}};
  for (int i = 0; i < kOvalAngles; ++i) {
    const double angle = pi * i / kOvalAngles;
    const WallStress s = shell.stress(place, zeta, angle, torque);
    station.hoop.take(s.hoop, angle, i == 0);
    station.meridional.take(s.axial, angle, i == 0);
    station.shear.take(s.shear, angle, i == 0);
    station.equivalent.take(von_mises({0, s.hoop, s.axial, s.shear, 0, 0}), angle, i == 0);
  }
  return station;
}

/// Largest difference of a stress to that of small rotations.
double rotation_stress(const OvalShell& large, const OvalShell& small) {
  constexpr int kCoarse = 36;
  const std::vector<ShellPlace> of_large = places_of(large);
  const std::vector<ShellPlace> of_small = places_of(small);
  double largest = 0;
  for (std::size_t i = 0; i < of_large.size(); ++i)
    for (const double zeta : {-1.0, 1.0})
      for (int j = 0; j < kCoarse; ++j) {
        const WallStress a = large.stress(of_large[i], zeta, pi * j / kCoarse, 0);
        const WallStress b = small.stress(of_small[i], zeta, pi * j / kCoarse, 0);
        largest = std::max({largest, std::abs(a.hoop - b.hoop), std::abs(a.axial - b.axial),
                            std::abs(a.shear - b.shear)});
      }
  return largest;
}

/// Turn of the normal in the meridian at a lobe, in the middle of the rim.
double coning_angle(const OvalShell& shell) {
  const auto [from, to] = shell.cup.ends(WallPart::rim);
  double turn = 0;
  for (const ShellWave& wave : shell.at(WallPart::rim, (from + to) / 2).waves)
    turn -= wave.axial_rotation;
  return turn;
}

std::vector<Note> notes_of(const GearSet& gear) {
  std::vector<Note> notes;
  notes.push_back({"oval.model",
                   "the wall is a thin shell without cracks, teeth and fillets; the cam is rigid "
                   "and has no friction; the torque acts evenly round the rim",
                   "flexspline", "CU-1", Severity::care,
                   "Add the notch of a fillet or of a tooth root by a factor of your own."});
  add_cup_notes(notes, gear);
  if (gear.flexspline->boss)
    notes.push_back(
        {"oval.boss",
         "the boss gives way, so the stress of the diaphragm beside it is smaller; in a "
         "cup of size 25 a stress of the diaphragm was up to 16 % of the largest too "
         "large",
         "flexspline.boss", "CU-4", Severity::care,
         "Compute the stress by strainwave fe oval too."});
  if (gear.flexspline->diaphragm && !gear.flexspline->diaphragm->profile.empty())
    notes.push_back({"oval.profile",
                     "the middle of a diaphragm with a profile is taken as flat; in a cup of size "
                     "25 a stress of the diaphragm differed by up to 6 % of the largest from "
                     "finite elements",
                     "flexspline.diaphragm.profile", "CU-4", Severity::care,
                     "Compute the stress by strainwave fe oval too."});
  return notes;
}

}  // namespace

DriveOval drive_oval(const GearSet& gear, const OvalRequest& request) {
  const std::vector<double> torques = plan_oval(gear, request);
  const ShellCup cup = shell_cup(gear);
  const CamFit cam = cam_fit(gear);
  const OvalShell shell =
      oval_shell(cup, cam, {.large_rotations = request.large_rotations, .whole_meridian = true});
  DriveOval oval;
  oval.contact = shell.contact;
  oval.coning_angle = coning_angle(shell);
  oval.large_rotations = shell.large_rotations;
  if (shell.large_rotations)
    oval.rotation_stress = rotation_stress(
        shell,
        oval_shell(cup, cam, {.large_rotations = LargeRotations::off, .whole_meridian = true}));
  for (std::size_t i = 0; i < shell.pressure.size(); ++i)
    oval.pressure.push_back(
        {.angle = pi / 2 * static_cast<double>(i) / static_cast<double>(shell.pressure.size() - 1),
         .pressure = shell.pressure[i]});
  for (const double torque : torques) {
    LoadedOval& loaded = oval.torques.emplace_back(LoadedOval{.torque = torque, .stations = {}});
    for (const ShellPlace& place : places_of(shell))
      for (const double zeta : {-1.0, 1.0})
        loaded.stations.push_back(over_turn(shell, place, zeta, torque));
  }
  oval.notes = notes_of(gear);
  oval.equations = {"CU-1", "CU-2"};
  if (oval.large_rotations) oval.equations.emplace_back("CU-3");
  oval.equations.emplace_back("CU-4");
  return oval;
}

}  // namespace strainwave

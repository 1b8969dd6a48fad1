// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coupled_drive.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/stiffness/section_torsion.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {

/// Compliances of the members in series with the ring [rad/(N*m)].
template <class Real>
struct BasicSeriesMembers {
  Real barrel{};
  Real diaphragm{};
  Real rim{};
  Real boss_and_flange{};
  Real output_shaft{};
  Real cracks_positive{};
  Real cracks_negative{};

  [[nodiscard]] Real cracks(double torque) const {
    return torque < 0 ? cracks_negative : cracks_positive;
  }
  [[nodiscard]] Real sound() const {
    return barrel + diaphragm + rim + boss_and_flange + output_shaft;
  }
};
using SeriesMembers = BasicSeriesMembers<double>;

/// Compliances of the flexspline's members in series with the ring, without cracks.
template <class Real>
[[nodiscard]] BasicSeriesMembers<Real> cup_members(const GearSet& gear, const Lift<Real>& lift) {
  const Flexspline& fs = *gear.flexspline;
  const auto material = [&](const auto& section) -> const Material& {
    return material_of(gear, material_name(fs, section), "flexspline.material");
  };
  const auto tube = [&](const TubeSection& section, const Real& length) {
    return section_twist(lift, gear, section, material(section), length);
  };
  BasicSeriesMembers<Real> series;
  series.barrel = tube(*fs.barrel, lift(fs.barrel->length));
  series.diaphragm = section_twist(lift, gear, *fs.diaphragm, material(*fs.diaphragm));  // (TC-13)
  // (TC-13): traction spread evenly over the teeth twists the rim as much as a third of its length
  // would.
  series.rim = tube(*fs.rim, lift(fs.rim->length) / 3);
  if (fs.boss) series.boss_and_flange += tube(*fs.boss, lift(fs.boss->length));
  series.boss_and_flange += lift(fs.joint_compliance) + lift(fs.flange_compliance);
  return series;
}

/// Of the states of the sound drive under both senses of a torque, the one in which the ball
/// nearest to a position carries the larger force.
[[nodiscard]] Equilibrium worst_of_ball(const CoupledDrive& sound, double torque, double position);

/// Whether the moment of the assembly presses the faces of a ring's crack together, so that the
/// crack does not soften the ring (TC-22).  The circular spline has no moment without torque.
template <class Real>
[[nodiscard]] bool pressed_by_assembly(const CoupledDrive& sound,
                                       const BasicRingHinge<Real>& hinge) {
  if (hinge.ring == RingHinge::Ring::spline) return false;
  const double bends_more = sound.rings().curvature(sound.coefficients_of(sound.assembled().force),
                                                    value_of(hinge.position));
  return hinge.from_inside ? bends_more > 0 : bends_more < 0;
}

/// The cracks whose faces the assembly does not press together.
template <class Real>
[[nodiscard]] BasicContactCracks<Real> acting(const CoupledDrive& sound,
                                              BasicContactCracks<Real> cracks) {
  std::erase_if(cracks.hinges, [&](const BasicRingHinge<Real>& hinge) {
    return pressed_by_assembly(sound, hinge);
  });
  return cracks;
}

struct AssembledDrive::Contents {
  GearSet gear;
  CoupledOptions options;
  Deviations deviations;
  CoupledGeometry geometry;
  CoupledDrive sound;    // the sound drive on its cam
  ContactCracks cracks;  // including those that the assembly presses
  CoupledDrive drive;    // the drive with its cracks, on the cam of the sound drive
  SeriesMembers series;
  std::vector<Note> notes;
  std::vector<std::string> equations;
  std::string sound_fails_because;  // reason; empty if the sound drive assembles
  std::string fails_because;        // reason; empty if the drive with its cracks assembles
  std::string unusable_because;     // reason; empty if the answers with these cracks may be used

  /// Twist of the output at a state of the rings (TC-14) [rad].
  [[nodiscard]] double twist(const Equilibrium& state) const {
    return (state.rotation - drive.assembled().rotation) / geometry.ring_radius +
           (series.sound() + series.cracks(state.torque)) * state.torque;
  }
};

/// The state of equilibrium of a drive at one torque.
/// @param torque  T at the output [N*m], finite
/// @throws SolverError  if there is no equilibrium
[[nodiscard]] Equilibrium state_at(const AssembledDrive& drive, double torque);

/// Solves one torque after the other and passes each state to `see`, which may set its system.
/// @return  reason why the curve is not usable from some torque on; empty if all states were found
/// @throws InputError  if a torque is not a finite number
[[nodiscard]] std::string walk(const AssembledDrive::Contents& contents,
                               std::span<const double> torques, const Progress& progress,
                               const std::function<void(Equilibrium&)>& see);

}  // namespace strainwave

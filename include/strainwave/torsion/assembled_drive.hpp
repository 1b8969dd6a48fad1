// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/coupled_options.hpp"
#include "strainwave/torsion/deviations.hpp"

/// @file
/// A drive on its cam, assembled once and ready for any torque.

namespace strainwave {

/// The coupled drive in equilibrium on its cam at zero torque, without friction.
///
/// Implements theory manual eqs. (TC-1) to (TC-13).  The object is immutable.  Copies share the
/// computed state, and any number of threads may use one drive.
class AssembledDrive {
 public:
  /// Assembles the sound drive, then adds its cracks on the same cam.
  ///
  /// A drive that cannot be assembled gives an object too; `fails_because` then states the reason.
  /// @param gear     drive with bearing, sections and mesh
  /// @param options  resolution, tolerances and assumptions of the solution; {}: their defaults
  /// @throws InputError  if a rule is broken or this model lacks an input
  explicit AssembledDrive(const GearSet& gear, const CoupledOptions& options = {});

  /// The same drive without its cracks; the assembled sound drive is reused.
  [[nodiscard]] AssembledDrive without_cracks() const;
  /// The same drive after the wave generator has turned by an angle [rad]: cracks of flexspline,
  /// outer ring and circular spline move against the wave, each by its own angle (TC-28).  Cracks
  /// of the inner race do not move, and the cage keeps its phase.
  [[nodiscard]] AssembledDrive turned(double angle) const;
  /// The same drive after its parts have moved against the wave, each by its own angle [rad]:
  /// cracks of flexspline, teeth and outer ring by the first, those of the circular spline by the
  /// second.
  [[nodiscard]] AssembledDrive moved(double flexspline, double spline) const;

  /// The same drive with deviations of its parts in place of those it has, on the cam of the drive
  /// without them (TC-36).  The rings are reused, so this costs one solve.  Cracks of the inner
  /// race keep their compliance, which comes from the ball forces without deviations.
  /// @throws InputError  if the deviations do not fit the drive
  [[nodiscard]] AssembledDrive with_deviations(const Deviations& deviations) const;

  /// The drive as given, or after `turned`.
  [[nodiscard]] const GearSet& gear() const;
  /// The options with which the drive was assembled.
  [[nodiscard]] const CoupledOptions& options() const;
  /// Deviations of the parts; empty without `with_deviations`.
  [[nodiscard]] const Deviations& deviations() const;
  /// Reason why there is no equilibrium at zero torque; empty if there is an equilibrium.
  [[nodiscard]] const std::string& fails_because() const;
  /// Notes on the limits of the answers: on the assumptions of the model, on the cracks, and on
  /// flanks that press on each other without torque.
  [[nodiscard]] std::vector<Note> notes() const;
  /// Tags of the equations of the model.
  [[nodiscard]] const std::vector<std::string>& equations() const;
  /// Cam amplitude A that lifts the lobes to w_0 (TC-12) [m].
  [[nodiscard]] double cam_amplitude() const;

  struct Contents;
  /// Data for the functions of this module; opaque to other modules.
  [[nodiscard]] const Contents& contents() const { return *contents_; }

 private:
  explicit AssembledDrive(std::shared_ptr<const Contents> contents);

  std::shared_ptr<const Contents> contents_;
};

/// Stiffness of a pair of teeth of a drive per unit of face width, c' [Pa]: that of the file, else
/// that of the teeth as drawn (TC-30), else that of (TC-9).
/// @throws InputError  if a rule of the torsion curve is broken
[[nodiscard]] double drive_pair_stiffness(const GearSet& gear);

}  // namespace strainwave

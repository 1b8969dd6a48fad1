// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/coupled_options.hpp"

/// @file
/// A drive on its cam, ready for any torque: assembled once, asked often.

namespace strainwave {

/// The coupled drive in equilibrium on its cam without torque, for one state of flank friction.
///
/// Implements theory manual eqs. (TC-1) to (TC-13).  A value that never changes: copies share what
/// was computed, and any number of threads may use one drive.
class AssembledDrive {
 public:
  /// Assembles the sound drive, then its cracks on the same cam.
  ///
  /// A drive that does not assemble is a value too; `fails_because` says why.
  /// @param gear  with bearing, sections and mesh
  /// @throws InputError  if a rule is broken or something is missing for this model
  explicit AssembledDrive(const GearSet& gear, const CoupledOptions& options = {});

  /// The same drive without its cracks; nothing is assembled again.
  [[nodiscard]] AssembledDrive without_cracks() const;
  /// The same drive after the wave generator has turned by an angle [rad]: cracks of flexspline,
  /// circular spline and outer ring move against the wave, those of the inner race stay.
  [[nodiscard]] AssembledDrive turned(double angle) const;

  /// The drive as it was given, or as it was turned.
  [[nodiscard]] const GearSet& gear() const;
  [[nodiscard]] const CoupledOptions& options() const;
  /// Why there is no state without torque; empty if there is one.
  [[nodiscard]] const std::string& fails_because() const;
  /// What limits its answers; of the model's ground, of the cracks, of flanks that press on each
  /// other without torque.
  [[nodiscard]] std::vector<Note> notes() const;
  /// Tags of the equations that describe it.
  [[nodiscard]] const std::vector<std::string>& equations() const;
  /// A that lifts the lobes to w_0 (TC-12) [m]
  [[nodiscard]] double cam_amplitude() const;

  struct Contents;
  /// What the functions of this module need; opaque to others.
  [[nodiscard]] const Contents& contents() const { return *contents_; }

 private:
  explicit AssembledDrive(std::shared_ptr<const Contents> contents);

  std::shared_ptr<const Contents> contents_;
};

/// A drive whose flanks all slip: the two envelopes of its hysteresis (TC-16).
struct SlidingDrive {
  AssembledDrive loading;    ///< while the torque grows in size
  AssembledDrive unloading;  ///< while it falls

  /// @throws InputError  as AssembledDrive
  explicit SlidingDrive(const GearSet& gear, const CoupledOptions& options = {});
  SlidingDrive(AssembledDrive at_loading, AssembledDrive at_unloading);

  [[nodiscard]] SlidingDrive without_cracks() const;
};

}  // namespace strainwave

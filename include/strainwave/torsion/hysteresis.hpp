// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Hysteresis by flank friction: any path of the torque, between two envelopes.

namespace strainwave {

struct HysteresisOptions {
  int elements = 64;  ///< play elements, [-]; >= 1; the loop's area converges like 1/elements^2
  int grid = 48;      ///< torques at which the envelopes are solved, for each sense [-]; >= 8
};

/// Twist of the drive along a path of the torque, friction on the flanks.
///
/// Implements theory manual eqs. (TC-16) and (TC-17).  Friction turns the force of the flanks by
/// atan(mu): one envelope for full slip while the torque grows in size, one while it falls.  In
/// between, play elements with thresholds spread evenly from 0 to twice the envelopes' distance
/// make Masing branches: smooth after a reversal, minor loops closed, the memory of a minor loop
/// wiped out when the path leaves it.  The envelopes are an upper bound of the loop's width (full
/// slip on all flanks).  At no load the flank friction vanishes; what a real drive shows there
/// comes from seal, grease and bearings: `Rating::friction_torque`.
class Hysteresis {
 public:
  /// Solves the envelopes up to `largest_torque` [N*m]; > 0.
  /// @throws InputError   if a number is out of range
  /// @throws SolverError  if a curve is not usable
  /// @throws Stopped      on request
  Hysteresis(const SlidingDrive& drive, double largest_torque,
             const HysteresisOptions& options = {}, const Progress& progress = {});
  /// The same for a drive that is assembled first.
  Hysteresis(const GearSet& gear, double largest_torque, const HysteresisOptions& options = {})
      : Hysteresis(SlidingDrive(gear), largest_torque, options) {}
  ~Hysteresis();
  Hysteresis(Hysteresis&&) noexcept;
  Hysteresis& operator=(Hysteresis&&) noexcept;

  /// Twist after each torque of a path that starts from rest, untouched, at zero [rad].
  ///
  /// Between two torques of the path the way is monotonic.
  /// @param path  torques [N*m], within +- largest_torque
  [[nodiscard]] std::vector<double> twist(std::span<const double> path) const;

  /// Twist while the torque grows in size, all flanks slipping [rad]; odd in the torque.
  [[nodiscard]] double loading(double torque) const;
  /// Twist while the torque falls in size, all flanks slipping [rad]; odd in the torque.
  [[nodiscard]] double unloading(double torque) const;

 private:
  struct Envelopes;
  std::unique_ptr<Envelopes> envelopes_;
};

/// A loop between +T and -T, after a first loading.
struct HysteresisLoop {
  std::vector<double> torque;            ///< [N*m], down from +T to -T and up again
  std::vector<double> twist;             ///< [rad]
  double amplitude = 0.0;                ///< T [N*m]
  double width_at_zero = 0.0;            ///< maker's hysteresis loss [rad]
  double largest_width = 0.0;            ///< [rad]
  double torque_of_largest_width = 0.0;  ///< in size [N*m]
  double lost_energy = 0.0;              ///< area of the loop [J]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"amplitude", "N*m", "T, amplitude of the torque"}, &HysteresisLoop::amplitude);
    field({"width_at_zero", "rad", "width without torque, maker's hysteresis loss"},
          &HysteresisLoop::width_at_zero);
    field({"largest_width", "rad", "largest width of the loop"}, &HysteresisLoop::largest_width);
    field({"torque_of_largest_width", "N*m", "where it is, in size"},
          &HysteresisLoop::torque_of_largest_width);
    field({"lost_energy", "J", "area of the loop"}, &HysteresisLoop::lost_energy);
    field({"torque", "N*m", "down from +T to -T and up again"}, &HysteresisLoop::torque);
    field({"twist", "rad", "at each torque"}, &HysteresisLoop::twist);
  }
};

/// Loop at the amplitude of the given torque [N*m]; eq. (TC-17).
/// @param points_per_branch  torques on each way [-]; >= 4
[[nodiscard]] HysteresisLoop hysteresis_loop(const Hysteresis& hysteresis, double amplitude,
                                             int points_per_branch = 101);

/// Twist between +T and -T at the middle of the loop, T the share of rated torque of the maker
/// [rad]; eq. (TC-18).
/// @throws SolverError  if the curve is not usable
[[nodiscard]] double lost_motion(const AssembledDrive& drive);
/// The same for a drive that is assembled first.
[[nodiscard]] inline double lost_motion(const GearSet& gear, const CoupledOptions& options = {}) {
  return lost_motion(AssembledDrive(gear, options));
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "strainwave/torsion/friction.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Hysteresis from friction, for any path of the torque between two envelopes.

namespace strainwave {

/// Resolution of the loops.
struct HysteresisOptions {
  /// number of play elements [-]; >= 1; the area of the loop converges like 1/elements^2
  int elements = 64;
  int grid = 48;  ///< torques per sense at which the envelopes are solved [-]; >= 8
};

/// Width of the hysteresis loop at zero torque, by its causes.
struct LossAtZero {
  double flanks = 0.0;      ///< flanks that press on each other without torque [rad]
  double outer_ring = 0.0;  ///< outer ring in the bore of the rim, under the assembly [rad]
  double output = 0.0;      ///< `Rating::friction_torque` [rad]
  /// The maker's hysteresis loss, the sum of all causes [rad].
  [[nodiscard]] double total() const { return flanks + outer_ring + output; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"total", "rad", "maker's hysteresis loss"}, &LossAtZero::total);
    field({"flanks", "rad", "by flanks that press on each other without torque"},
          &LossAtZero::flanks);
    field({"outer_ring", "rad", "by the outer ring in the bore of the rim"},
          &LossAtZero::outer_ring);
    field({"output", "rad", "by rating.friction_torque"}, &LossAtZero::output);
  }
};

/// What a loop remembers of its path.
struct HysteresisMemory {
  double torque = 0.0;          ///< the last torque [N*m]
  double elastic_torque = 0.0;  ///< T*, the part of the torque that reaches the flanks [N*m]
  double twist = 0.0;           ///< the last twist [rad]
  std::vector<double> play;     ///< twist of each play element [rad]
};

/// Twist of the drive along a path of the torque, with friction of flanks, outer ring and output.
///
/// Implements theory manual eqs. (TC-16) and (TC-17).  All contacts slip on the envelopes, one for
/// rising and one for falling torque; their middle is the twist without friction.  Between the
/// envelopes, play elements with thresholds spread evenly from 0 to twice the distance of the
/// envelopes make Masing branches: smooth after a reversal, with closed minor loops, and with the
/// memory of a minor loop erased once the path leaves it.  At zero torque the distance comes from
/// what the assembly presses; grease, seals and output bearing add `Rating::friction_torque`.
class Hysteresis {
 public:
  /// Solves the envelopes up to `largest_torque` [N*m]; > 0.
  /// @throws InputError   if a number is out of range
  /// @throws SolverError  if a curve is not usable
  /// @throws Stopped      if the caller requests a stop
  Hysteresis(const AssembledDrive& drive, double largest_torque,
             const HysteresisOptions& options = {}, const Progress& progress = {});
  /// Solves the envelopes of a drive that is not assembled yet.
  Hysteresis(const GearSet& gear, double largest_torque, const HysteresisOptions& options = {})
      : Hysteresis(AssembledDrive(gear), largest_torque, options) {}
  ~Hysteresis();
  /// Takes over the envelopes of another object, which must not be used after that.
  /// @{
  Hysteresis(Hysteresis&&) noexcept;
  Hysteresis& operator=(Hysteresis&&) noexcept;
  /// @}

  /// Twist after each torque of a path that starts at zero torque without previous load [rad].
  ///
  /// Between two torques of the path the torque is monotonic.
  /// @param path  torques [N*m], within +- largest_torque
  /// @throws InputError  if a torque is beyond largest_torque
  [[nodiscard]] std::vector<double> twist(std::span<const double> path) const;

  /// A drive at zero torque without previous load.
  [[nodiscard]] HysteresisMemory at_rest() const;
  /// Goes on to a torque, monotonically, and returns the twist [rad].
  /// @param memory  state of the path, from `at_rest` of this object; moved on to the torque
  /// @param torque  [N*m], within +- largest_torque
  /// @throws InputError  if the torque is beyond largest_torque
  double advance(HysteresisMemory& memory, double torque) const;
  /// Goes on to a twist, monotonically, and returns the torque [N*m]: the inverse of `advance`.
  ///
  /// When the twist turns back, the torque jumps by twice `Rating::friction_torque`, and by what
  /// the first element holds.  Without a change of the twist the torque stays, although friction
  /// would allow a range.
  /// @param memory  state of the path, from `at_rest` of this object; moved on to the twist
  /// @param twist   [rad], within the twists at +- largest_torque
  /// @throws InputError  if no torque within the envelopes has this twist
  double advance_to_twist(HysteresisMemory& memory, double twist) const;

  /// Twist while the torque rises, with slip in all contacts and without the friction torque of the
  /// output [rad].
  [[nodiscard]] double rising(double torque) const;
  /// Twist while the torque falls [rad].
  [[nodiscard]] double falling(double torque) const;

  /// Width at zero torque of a loop that is long enough for slip in all contacts.
  [[nodiscard]] LossAtZero loss_at_zero() const;

 private:
  /// Moves T* and the elements; eq. (TC-17).
  void slide(HysteresisMemory& memory, double elastic_torque) const;

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
  double torque_of_largest_width = 0.0;  ///< magnitude of the torque at the largest width [N*m]
  double lost_energy = 0.0;              ///< area of the loop [J]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"amplitude", "N*m", "T, amplitude of the torque"}, &HysteresisLoop::amplitude);
    field({"width_at_zero", "rad", "width without torque, maker's hysteresis loss"},
          &HysteresisLoop::width_at_zero);
    field({"largest_width", "rad", "largest width of the loop"}, &HysteresisLoop::largest_width);
    field({"torque_of_largest_width", "N*m", "magnitude of the torque at the largest width"},
          &HysteresisLoop::torque_of_largest_width);
    field({"lost_energy", "J", "area of the loop"}, &HysteresisLoop::lost_energy);
    field({"torque", "N*m", "torques down from +T to -T and up again"}, &HysteresisLoop::torque);
    field({"twist", "rad", "twist at each torque"}, &HysteresisLoop::twist);
  }
};

/// Hysteresis loop with the amplitude of the given torque [N*m]; eq. (TC-17).
/// @param hysteresis         envelopes of the drive, solved up to the amplitude or beyond
/// @param amplitude          T [N*m]; > 0, within the largest torque of the envelopes
/// @param points_per_branch  number of torques on each branch [-]; >= 4; an even number
///                           gives one torque more
/// @throws InputError  if the amplitude or the number of torques is out of range
[[nodiscard]] HysteresisLoop hysteresis_loop(const Hysteresis& hysteresis, double amplitude,
                                             int points_per_branch = 101);

/// Lost motion: twist between +T and -T at the middle of the loop [rad]; eq. (TC-18).  T is the
/// maker's share of the rated torque.
/// @throws SolverError  if the curve is not usable
[[nodiscard]] double lost_motion(const AssembledDrive& drive);
/// Lost motion of a drive that is not assembled yet.
[[nodiscard]] inline double lost_motion(const GearSet& gear, const CoupledOptions& options = {}) {
  return lost_motion(AssembledDrive(gear, options));
}

}  // namespace strainwave

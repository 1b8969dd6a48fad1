// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"

/// @file
/// The stress intensity factors of a crack of a drive under a load.

namespace strainwave {

/// Load of a crack at one moment.
struct LoadState {
  double torque = 0.0;       ///< T [N*m]
  double axial_force = 0.0;  ///< P [N]
  /// Share of the assembly that acts at the crack, -1 to 1 [-]
  double assembly = 0.0;
  double bending_moment = 0.0;  ///< M that acts at the crack, with sign [N*m]

  /// Whether a load that turns acts.
  [[nodiscard]] bool turns() const { return assembly != 0 || bending_moment != 0; }
};

/// A crack at several torques [N*m], on which K does not depend in proportion; for a crack that
/// does not reverse, at their sizes.  Empty: K is proportional to the torque.
using CracksAtTorques = std::vector<std::pair<double, DriveCrack>>;

/// Which points of a front are computed.
enum class FrontPoints {
  all,
  ends,  ///< the first and the last one alone, where a crack has a faster way to them
};

/// K of a crack of one size, at the points of its front, with open faces.
class CrackFactors {
 public:
  /// @param crack      must outlive this object
  /// @param at_torque  must outlive this object, by rising torque; K between two is linear
  /// @param size       a [m] and a/c [-] of the crack
  /// @param bent       whether to prepare the factors of a bending moment
  /// @param points     which points are needed
  CrackFactors(const DriveCrack& crack, const CracksAtTorques& at_torque, const CrackSize& size,
               bool bent = true, FrontPoints points = FrontPoints::all);

  /// Number of points of the front.
  [[nodiscard]] std::size_t points() const {
    return turn_ ? turn_->stations() : fronts_.front().load.size();
  }
  /// Whether K over the turn is that of a table; then only `over_turn` gives K.
  [[nodiscard]] bool has_turn() const { return turn_.has_value(); }
  /// K at a point at the angles of the table (GR-30) [Pa*m^0.5].
  /// @throws InputError  if the torque [N*m] is beyond the table
  [[nodiscard]] std::vector<Modes> over_turn(std::size_t point, double torque) const {
    return turn_->at(point, torque);
  }
  /// K at a point [Pa*m^0.5].
  /// @param point   of the front, 0 to points() - 1
  /// @param state   load at the moment; of a crack that does not reverse, |T| counts
  /// @param factor  on torque, axial force and bending moment [-]
  [[nodiscard]] Modes at(std::size_t point, const LoadState& state, double factor = 1.0) const;

 private:
  struct Front {
    std::vector<FrontIntensity> load;
    std::vector<Modes> bending;  // empty: no bending moment acts
  };

  const CracksAtTorques& at_torque_;
  bool reverses_;
  std::vector<Front> fronts_;  // of the crack itself, or of each torque; empty with a table
  std::optional<TurnFactors> turn_;
};

}  // namespace strainwave

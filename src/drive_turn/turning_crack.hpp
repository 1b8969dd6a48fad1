// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "strainwave/model/input/crack.hpp"
#include "strainwave/model/result/crack_turn.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

namespace strainwave {

/// K_I, K_II, K_III at a station [Pa*m^0.5].
using StationFactors = std::array<double, 3>;

/// Half length of a through crack over the radius of the barrel up to which K was judged (IN-2)
/// [-].
inline constexpr double kJudgedLength = 1.0 / 6;

/// A crack of the wall at one size, in the stress of the sound wall.  Each kind of crack is one
/// class.
class TurningCrack {
 public:
  TurningCrack() = default;
  virtual ~TurningCrack() = default;
  TurningCrack(const TurningCrack&) = delete;
  TurningCrack& operator=(const TurningCrack&) = delete;
  TurningCrack(TurningCrack&&) = delete;
  TurningCrack& operator=(TurningCrack&&) = delete;

  /// Labels of the stations of one tip, as StationTurn::station.
  [[nodiscard]] virtual std::vector<double> stations() const = 0;
  /// K at the stations of the upper tip, then of the lower tip.  Neighbouring angles in turn are
  /// fastest.
  /// @param from_lobe  angle from a lobe to the middle of the crack [rad]
  /// @param torque     T [N*m]
  [[nodiscard]] virtual std::vector<StationFactors> at(double from_lobe, double torque) = 0;
  /// Largest stress of the sound wall normal to the crack [Pa].
  [[nodiscard]] virtual double largest_stress(double from_lobe, double torque) const = 0;
};

/// @param shell   must outlive the result
/// @param place   z of the middle of the crack [m]
/// @param size    in place of that of the crack
/// @throws InputError  beyond the range of the table, or of the judged cracks
[[nodiscard]] std::unique_ptr<TurningCrack> turning_crack(const WallThroughCrack& crack,
                                                          const OvalShell& shell, double place,
                                                          const TurnSize& size);
/// @throws InputError  beyond the range of the solution
[[nodiscard]] std::unique_ptr<TurningCrack> turning_crack(const WallSurfaceCrack& crack,
                                                          const OvalShell& shell, double place,
                                                          const TurnSize& size);

}  // namespace strainwave

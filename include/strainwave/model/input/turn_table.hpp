// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/turn_condition.hpp"
#include "strainwave/model/result/crack_turn.hpp"

/// @file
/// Stress intensity of a crack over a turn of the wave generator, from a table.

namespace strainwave {

/// K of a crack over a turn of the wave generator, as read from its file (GR-30).
///
/// All lists are in ascending order.
struct TurnTable {
  std::string file;  ///< file name as the drive gives it
  /// What the drive must be; empty: the table does not say for which drive it is.
  std::vector<TurnCondition> conditions = {};
  /// Reason why the table must not be used, for its file; a table with a reason is not read back.
  std::string unusable_because = {};
  std::string size_name;      ///< "depth" or "half_length"
  std::vector<double> sizes;  ///< depth a, or half length of a through crack [m]; one or more
  /// a/c of a surface crack [-]; empty: the table is for the shape of the crack in the file
  std::vector<double> aspect_ratios = {};
  std::vector<double> torques;  ///< T at the output [N*m]; one or more
  /// Places of the front [-].  Of a surface crack: from 0, at the surface, to 1, at the deepest
  /// point.  Of a crack through the wall: from -1, at the inner face, to 1, at the outer face.  Of
  /// a crack of the rim: from -1 to 1 over its width.
  std::vector<double> stations;
  /// Angle from a lobe of the wave generator to the crack, toward +theta [rad].  The last one is
  /// the first one again, a wave or a whole turn later.
  std::vector<double> angles;
  /// K_I, K_II, K_III [Pa*m^0.5], over sizes, aspect ratios, torques, stations and angles; the
  /// angle runs fastest.  K_I < 0 presses the faces.
  std::vector<std::array<double, 3>> K;

  /// Whether a torque is within the table.
  [[nodiscard]] bool covers(double torque) const;
};

/// The least and the largest factor on a torque that the table covers [-].
/// @param table   K over a turn; only its torques count
/// @param torque  T [N*m]; covered, not 0
[[nodiscard]] std::array<double, 2> turn_load_range(const TurnTable& table, double torque);

/// Fewest rows of a table over the angle, with the first one again at the end.
inline constexpr std::size_t kMinTurnAngles = 4;
/// Largest difference of K at the last angle to K at the first one, as a share of the largest K of
/// the table.
inline constexpr double kTurnCloses = 1e-3;

/// K over a turn at one size of the crack.
///
/// Implements theory manual eq. (GR-30).
class TurnFactors {
 public:
  /// @param table         must outlive this object
  /// @param size          a [m]; beyond the table, K/sqrt(pi a) of the nearest size counts
  /// @param aspect_ratio  a/c [-]; not read if the table has no aspect ratios
  TurnFactors(const TurnTable& table, double size, double aspect_ratio);

  /// Number of places of the front.
  [[nodiscard]] std::size_t stations() const { return table_.stations.size(); }
  /// K at the angles of the table, without the last one, at one station [Pa*m^0.5].
  /// @param station      index of the place of the front; 0 to stations() - 1
  /// @param torque       T [N*m]
  /// @throws InputError  if the torque is beyond the table
  [[nodiscard]] std::vector<std::array<double, 3>> at(std::size_t station, double torque) const;

 private:
  const TurnTable& table_;
  std::vector<std::array<double, 3>> K_;  // over torques, stations and angles
};

/// Number of waves over which the angles of a table run, of a drive of this wave number: 1 or all.
[[nodiscard]] int waves_of(const TurnTable& table, int wave_number);

/// The turn of the governing tip as a table, without a file's name.
/// @param sizes       of one crack, ascending, each under the same torques; one or more
/// @param conditions  of this crack
[[nodiscard]] TurnTable turn_table(std::span<const SizedTurn> sizes,
                                   std::vector<TurnCondition> conditions);

/// K_I over a turn under a torque, at the place of the front where its range is largest; pressed
/// faces have K_I = 0.
/// @param table               K over a turn
/// @param size, aspect_ratio  as TurnFactors
/// @param torque              T [N*m]
/// @throws InputError  if the torque is beyond the table
[[nodiscard]] TurnRange turn_range(const TurnTable& table, double size, double aspect_ratio,
                                   double torque);

/// Checks the cracks of a drive against the tables of K that they name; `check` calls it.
///
/// @throws InputError  if a table was not read, is for another kind of crack or another
///                     drive, or does not run over a wave or a turn; if the crack is beyond the
///                     table; if an axial force acts, which tables do not cover.  The message names
///                     crack and table
void check_turn_tables(const GearSet& gear);

/// Calls `f(path, crack)` for each crack that can have a table of K over a turn.
template <class Gear, class F>
void for_each_crack_with_turn(Gear& gear, const F& f) {
  for_each_crack(gear, [&](const CrackPath& path, auto& crack) {
    if constexpr (requires { crack.turn_table; }) f(path, crack);
  });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "strainwave/fem/crack_response.hpp"
#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/crack_turn.hpp"

/// @file
/// What a turn needs to know of a kind of crack.  Another kind needs another body.

namespace strainwave::gear_fem {

/// A place of a front in the results.
struct LabelledStation {
  std::size_t number;    ///< among the stations of the crack
  std::string_view tip;  ///< "upper" or "lower"
  double label;          ///< StationTurn::station
};

/// Release of a crack that grows in proportion, per unit of its size over the given one.
struct ProportionalRelease {
  double rate = 0;   ///< [J]
  double of_K = 0;   ///< that of the factors K [J]
  double sweep = 0;  ///< area [m^2]

  [[nodiscard]] double mean() const { return rate / sweep; }  ///< G [J/m^2]
};

/// A body with a crack of any size near the given one, and how it is held.
class TurnBody {
 public:
  TurnBody() = default;
  virtual ~TurnBody() = default;
  TurnBody(const TurnBody&) = delete;
  TurnBody& operator=(const TurnBody&) = delete;
  TurnBody(TurnBody&&) = delete;
  TurnBody& operator=(TurnBody&&) = delete;

  [[nodiscard]] virtual const fem::SolidProblem& problem() const = 0;
  /// @param size  over the given one [-]
  [[nodiscard]] virtual fem::HexMesh mesh(double size) const = 0;
  /// The places of the fronts in the order of the results: for each tip, ascending labels.
  [[nodiscard]] virtual std::vector<LabelledStation> labels(
      std::span<const fem::StationPlace> stations) const = 0;
  /// @param size  that of the solid, over the given one [-]; near 1
  [[nodiscard]] virtual ProportionalRelease release(const fem::SolidResult& solid,
                                                    double size) const = 0;
};

/// The body of the crack.
/// @throws InputError  if the crack does not fit
[[nodiscard]] std::unique_ptr<TurnBody> turn_body(const TurningCrack& turning);

/// The cup of the crack, without the crack.
[[nodiscard]] CupSection sound_cup(const TurningCrack& turning);

}  // namespace strainwave::gear_fem

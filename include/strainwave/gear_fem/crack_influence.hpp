// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "strainwave/gear_fem/tube_through_crack.hpp"

/// @file
/// The answer of a through crack to unit tractions on its faces, in numbers without dimension: the
/// source of the table by which the closed forms compute K over a turn (FE-56).

namespace strainwave::gear_fem {

/// The places where the pressure between the faces is described.
///
/// At one place of `along` and one of `across`, the pressure is a hat: 1 there, 0 at the neighbours
/// and linear between.  Along the crack, the tips are neighbours of the outermost places.
struct ContactGrid {
  std::vector<double> along;   ///< s, from -1 at the lower tip to 1 at the upper tip; tips left out
  std::vector<double> across;  ///< zeta, from -1 at the inner face to 1 at the outer face

  [[nodiscard]] std::size_t size() const { return along.size() * across.size(); }
  /// Value of each hat at a place, `across` running fastest.
  [[nodiscard]] std::vector<double> values(double s, double zeta) const;
};

/// The grid of the table.
[[nodiscard]] ContactGrid contact_grid();

/// Directions of a traction: across the crack, along it toward the upper tip, and outward.
inline constexpr std::size_t kTractionDirections = 3;
/// Powers of s (0, 1, 2), each times 1 and zeta.
inline constexpr std::size_t kTractionShapes = 6;
/// The tractions, the direction running slowest, then the power of s, then that of zeta.
inline constexpr std::size_t kUnitTractions = kTractionDirections * kTractionShapes;

/// The answer of one crack.  Tractions and pressures are 1, lengths are in units of the half length
/// a, gaps in units of a/E, and K in units of sqrt(pi a).
struct CrackInfluence {
  std::vector<double> stations;  ///< zeta of the stations of a front
  /// K_I, K_II, K_III at the stations of the upper tip, in rows, the mode running fastest; in
  /// columns the unit tractions and the hats of pressure
  std::vector<std::vector<double>> K;
  /// Mean gap over each hat, in rows: the integral of hat times gap over the crack, in units of
  /// (a/E)(a t); in columns as those of K
  std::vector<std::vector<double>> gap;
  double asymmetry{};  ///< largest difference of the gaps from symmetry, as a share of the largest
  std::size_t unknowns{};
};

/// Computes the answer of a crack half-way along a tube whose ends are held.
/// @param tube  lengths in units of the wall's thickness, with a Young's modulus of 1
/// @throws InputError, SolverError  as fem::CrackResponse and mesh_tube_with_through_crack
[[nodiscard]] CrackInfluence crack_influence(const TubeWithThroughCrack& tube);

/// The tube of the table: long, and held at both ends.
/// @param half_length  a/t [-]
/// @param radius       R/t [-]
/// @param angle        beta [rad]
[[nodiscard]] TubeWithThroughCrack influence_tube(double half_length, double radius, double angle);

}  // namespace strainwave::gear_fem

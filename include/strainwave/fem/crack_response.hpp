// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "strainwave/fem/solid.hpp"

/// @file
/// A crack under many states of stress: what its faces and fronts do under tractions on its faces.
///
/// The body without the crack carries a stress.  The crack releases this stress on its faces, which
/// displaces them and causes K.  Both are linear in the stress while the faces do not touch, so one
/// factorisation serves all states (FE-54), and pressure between faces enters in the same way.

namespace strainwave::fem {

/// A node of the crack's faces.
struct CrackNode {
  Point3 place{};         ///< [m]
  Point3 normal{};        ///< unit normal, from the side -1 to the side +1
  double area{};          ///< the node's share of the crack [m^2]; may be < 0 at a front
  bool on_front = false;  ///< both sides share the node
};

/// One face of a cell on the crack: a grid of (p+1)^2 nodes, whose first index runs fastest.
struct CrackCell {
  std::vector<std::size_t> nodes;  ///< indices into CrackResponse::nodes
};

/// K at a station of a front.
struct StationFactors {
  /// The faces touch beside the station, or would pass through each other; K_I is then exactly 0.
  bool closed = false;
  double K_I{};    ///< [Pa*m^0.5], as in FrontStation, but not rescaled to G
  double K_II{};   ///< [Pa*m^0.5]
  double K_III{};  ///< [Pa*m^0.5]
};

/// A crack in one state of stress.
struct CrackState {
  std::vector<StationFactors> stations;  ///< of all fronts, as CrackResponse::stations
  /// Normal distance of the faces at each node [m]; 0 on a front.
  std::vector<double> gap;
  std::vector<double> pressure;  ///< of contact at each node [Pa]; 0 on a front
  double contact_share{};        ///< share of the crack's area that touches [-]
  int contact_steps{};           ///< linear systems of the contact
};

/// A station of a crack front.
struct StationPlace {
  std::size_t front{};
  double position{};  ///< along the front, 0 to 1 by segments [-]
  Point3 place{};     ///< [m]
};

/// The response of one crack to tractions on its faces.
class CrackResponse {
 public:
  /// Factorises the body, and solves once for each node and each number of a station.
  ///
  /// Every rank must call it with the same arguments.  An MpiSession must exist.
  /// @param problem  with crack_tag and crack_faces = contact; only `solve` reads `fields`
  /// @throws InputError, SolverError  as solve_solid
  CrackResponse(const HexMesh& mesh, const SolidProblem& problem);
  ~CrackResponse();
  CrackResponse(CrackResponse&&) noexcept;
  CrackResponse& operator=(CrackResponse&&) noexcept;

  [[nodiscard]] std::span<const CrackNode> nodes() const;
  /// The cells that tile the crack, each once.  The same on every rank.
  [[nodiscard]] std::span<const CrackCell> cells() const;
  [[nodiscard]] std::span<const StationPlace> stations() const;
  [[nodiscard]] std::size_t unknowns() const;  ///< of the body
  [[nodiscard]] double worst_jacobian() const;
  /// Back substitutions that were needed.
  [[nodiscard]] std::size_t solutions() const;

  /// The crack in a body whose stress without the crack is given.
  ///
  /// Accuracy: that of K of FrontStation before its rescaling, and of the interpolation of the
  /// stress between the nodes.
  /// @param traction  stress times normal at each node [Pa]
  /// @param faces     `free` lets the faces pass through each other; K_I may then be < 0
  /// @throws InputError   if the number of tractions is wrong, or one is not finite
  /// @throws SolverError  if the contact does not converge
  [[nodiscard]] CrackState state(std::span<const Point3> traction,
                                 CrackFaces faces = CrackFaces::contact) const;

  /// The body of the response solved in full, with the factorisation that it keeps.
  /// @throws InputError, SolverError  as solve_solid
  [[nodiscard]] std::vector<SolidResult> solve(std::span<const SolidLoad> loads) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace strainwave::fem

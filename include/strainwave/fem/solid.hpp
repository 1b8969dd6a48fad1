// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "strainwave/fem/elasticity.hpp"
#include "strainwave/fem/fields.hpp"
#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::fem {

/// Directions with zero displacement on the faces with a tag; a clamp holds all directions.
struct Support {
  int tag{};
  /// Unit vectors held at a place [-]; at most three, orthogonal to each other.
  std::function<std::vector<Point3>(const Point3& place)> directions;
};

/// Dead traction on the faces with a tag.
struct Traction {
  int tag{};
  PointMap value;  ///< place [m] -> traction [Pa]
};

/// Treatment of the crack faces.
enum class CrackFaces {
  free,     ///< without traction; the faces may pass through each other, so the problem is linear
  contact,  ///< the faces touch without friction instead of passing through each other
};

/// What acts on a body.
struct SolidLoad {
  std::vector<Traction> tractions;
  /// Stress of the body without the crack at a place of the crack [Pa], rows of the tensor; used
  /// for `added_work`.  With `fields`, it must accept any place.  May be empty.
  std::function<std::array<Point3, 3>(const Point3&)> stress_without_crack;
  /// The crack releases `stress_without_crack` on its faces, in place of loads that cause it.  The
  /// displacements are then those that the crack adds (FE-54).  The stress of `fields` is that of
  /// the body, with what the crack released.
  bool released = false;
  /// Displacement of the body without the crack at any place [m].  The displacements of `fields`
  /// contain it where the crack releases the stress.  May be empty.
  PointMap displacement_without_crack = {};
};

/// A body and how it is held.
struct SolidProblem {
  Elasticity material;  ///< nu in [0, 0.5)
  std::vector<Support> supports;
  int order = 3;  ///< p of the displacements; 1 to 6; with cracks, 2 to 4 are useful
  CrackFaces crack_faces = CrackFaces::free;
  int crack_tag = 0;         ///< tag of the crack faces; 0: no crack
  FieldRequest fields = {};  ///< content of SolidResult::fields; empty if left out
};

/// Fracture quantities at one station of a front.
///
/// The frame is x1 = direction of growth, x3 along the front in the sense of the template's third
/// coordinate, x2 = x3 x x1 normal to the crack.  K_I > 0 opens; K_II > 0 moves the side x2 > 0
/// toward +x1, K_III > 0 toward +x3.
struct FrontStation {
  double position{};             ///< position along the front, 0 to 1 by segments [-]
  Point3 place{};                ///< [m]
  double energy_release_rate{};  ///< G by domain integral [J/m^2], (FE-23)
  double ring_spread{};          ///< largest difference between rings, relative to the mean G [-]
  /// Contact only: true if most places next to the station touch, or if (FE-24) gave K_I < 0
  /// (magnitude in CrackFront::closed_K_I).  K_I is then exactly 0.
  bool closed = false;
  double K_I{};     ///< [Pa*m^0.5], (FE-24); rescaled to G
  double K_II{};    ///< [Pa*m^0.5]
  double K_III{};   ///< [Pa*m^0.5]
  double G_of_K{};  ///< G of the factors K before they were rescaled to G [J/m^2], (FE-25)
};

struct CrackFront {
  std::vector<FrontStation> stations{};
  double release{};  ///< dU/da, the integral of G over the front, per unit of growth [N]
  double length{};   ///< length of the front [m]
  /// relative spread of `release` between rings without the innermost [-]
  double ring_spread{};
  double mode_energy_ratio{};  ///< integral of G_of_K over the integral of G [-]; 1 in plane strain
  double closed_K_I{};         ///< largest |K_I| that (FE-24) left at closed stations [Pa*m^0.5]
};

/// Results of a solid: energies, crack fronts and checks.
struct SolidResult {
  double work{};             ///< traction times displacement, f.u [J]; compliance is work/load^2
  double strain_energy{};    ///< [J]; work/2 by Clapeyron
  double added_work{};       ///< increase of the work by the crack, by reciprocity [J], (FE-26)
  double crack_volume{};     ///< integral of the opening over the crack [m^3]
  double contact_share{};    ///< share of the crack's area that touches [-]
  int contact_iterations{};  ///< steps of the contact problem; 0 if the faces do not touch
  double contact_overlap{};  ///< deepest remaining overlap at a node, over the largest jump without
                             ///< contact [-]
  std::vector<CrackFront> fronts;
  double worst_jacobian{};        ///< smallest scaled Jacobian determinant, 1 for a cuboid [-]
  double equilibrium_residual{};  ///< largest free nodal force over largest nodal load [-]
  double energy_balance{};        ///< |work/(2 strain_energy) - 1| [-]
  std::size_t cells{};
  std::size_t dofs{};
  double assembly_seconds{};   ///< of all loads together
  double solver_seconds{};     ///< likewise
  double factor_megabytes{};   ///< memory of the factorisation over all ranks [MB]
  double factor_operations{};  ///< floating-point operations of the last elimination
  /// as SolidProblem::fields requests, for the cells of this rank or for all cells
  SampledFields fields;
};

/// Solves a problem of linear elasticity on mapped hexahedra under several loads, and evaluates its
/// crack fronts.
///
/// One factorisation serves all loads, also where the faces of the crack touch (FE-30).
///
/// The displacements are continuous polynomials of order p in each unit coordinate.  The geometry
/// has order max(p, 4) through points of the analytic maps.  MUMPS factorises by Cholesky.  Every
/// rank must call it with the same arguments and gets the same result; the number of ranks changes
/// the result by rounding only.  An MpiSession must exist.
///
/// Accuracy (theory manual, chapter FE): 0.3 % of G with the ring templates of gear_fem at p = 3.
/// @param loads  one or more
/// @return the result of each load, in the same sequence
/// @throws InputError   if a value is out of range, or the mesh has a Jacobian determinant <= 0
/// @throws SolverError  if factorisation or contact fails
[[nodiscard]] std::vector<SolidResult> solve_solid(const HexMesh& mesh, const SolidProblem& problem,
                                                   std::span<const SolidLoad> loads);

/// The same under one load.
[[nodiscard]] SolidResult solve_solid(const HexMesh& mesh, const SolidProblem& problem,
                                      const SolidLoad& load);

/// The smallest scaled Jacobian determinant over corners and Gauss points [-].  A mesh that is
/// tangled or left-handed anywhere is refused (FE-22).
///
/// @throws InputError  if a determinant is <= 0; the message names the first such cell
double check_jacobians(const HexMesh& mesh);

}  // namespace strainwave::fem

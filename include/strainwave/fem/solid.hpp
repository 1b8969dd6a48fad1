// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "strainwave/fem/elasticity.hpp"
#include "strainwave/fem/fields.hpp"
#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::fem {

/// Directions held to zero on the faces with a tag: a clamp has all of them.
struct Support {
  int tag{};
  /// Unit vectors that are held at a place [-]; none or up to three, orthogonal to each other.
  std::function<std::vector<Point3>(const Point3& place)> directions;
};

/// Dead traction on the faces with a tag.
struct Traction {
  int tag{};
  PointMap value;  ///< place [m] -> traction [Pa]
};

/// The faces of the cracks.
enum class CrackFaces {
  free,     ///< without traction, may pass through each other: linear
  contact,  ///< touch without friction where they would pass through each other
};

struct SolidProblem {
  Elasticity material;  ///< nu in [0, 0.5)
  std::vector<Support> supports;
  std::vector<Traction> tractions;
  int order = 3;  ///< p of the displacements; 1 to 6, with cracks 2 to 4 are of use
  CrackFaces crack_faces = CrackFaces::free;
  int crack_tag = 0;  ///< tag of the crack faces; 0: no crack
  /// Stress that the body without the crack would have at a place of the crack [Pa], rows of the
  /// tensor; for `added_work`.  With `fields`, at any place.  May be empty.
  std::function<std::array<Point3, 3>(const Point3&)> stress_without_crack;
  FieldRequest fields = {};  ///< what to fill SolidResult::fields with; nothing if left out
};

/// Fracture quantities at one station of a front.
///
/// Frame: x1 = direction of growth, x3 along the front in the sense of the template's third
/// coordinate, x2 = x3 x x1 normal to the crack.  K_I > 0 opens; K_II > 0 moves the side x2 > 0
/// toward +x1, K_III > 0 toward +x3.
struct FrontStation {
  double position{};             ///< along the front, 0 to 1 by segments [-]
  Point3 place{};                ///< [m]
  double energy_release_rate{};  ///< G by domain integral [J/m^2], (FE-23)
  double ring_spread{};          ///< largest difference between rings, relative to the mean G [-]
  /// Contact only: most places next to the station touch, or (FE-24) gave less than 0 (how much:
  /// CrackFront::closed_K_I).  K_I is exactly 0.
  bool closed = false;
  double K_I{};     ///< [Pa*m^0.5], (FE-24); rescaled to G
  double K_II{};    ///< [Pa*m^0.5]
  double K_III{};   ///< [Pa*m^0.5]
  double G_of_K{};  ///< of the K before they were rescaled to G [J/m^2], (FE-25)
};

struct CrackFront {
  std::vector<FrontStation> stations;
  double release{};            ///< dU/da: integral of G over the front, per unit of growth [N]
  double length{};             ///< of the front [m]
  double ring_spread{};        ///< of `release` between rings (innermost left out), relative [-]
  double mode_energy_ratio{};  ///< integral of G_of_K over that of G [-]; 1 in plane strain
  double closed_K_I{};         ///< largest |K_I| that (FE-24) left at closed stations [Pa*m^0.5]
};

/// Displacements and what follows from them, with its evidence.
struct SolidResult {
  double work{};             ///< traction times displacement, f.u [J]; compliance is work/load^2
  double strain_energy{};    ///< [J]; work/2 by Clapeyron
  double added_work{};       ///< work more than without the crack, by reciprocity [J], (FE-26)
  double crack_volume{};     ///< integral of the opening over the crack [m^3]
  double contact_share{};    ///< share of the crack's area that touches [-]
  int contact_iterations{};  ///< steps of the contact problem; 0 when the faces do not touch
  double contact_overlap{};  ///< deepest overlap left at a node, over the largest jump without
                             ///< contact [-]
  std::vector<CrackFront> fronts;
  double worst_jacobian{};        ///< smallest scaled Jacobian determinant, 1 for a cuboid [-]
  double equilibrium_residual{};  ///< largest free nodal force over largest nodal load [-]
  double energy_balance{};        ///< |work/(2 strain_energy) - 1| [-]
  std::size_t cells{};
  std::size_t dofs{};
  double assembly_seconds{};
  double solver_seconds{};
  double factor_megabytes{};   ///< memory of the factorisation over all ranks [MB]
  double factor_operations{};  ///< floating-point operations of the last elimination
  SampledFields fields;        ///< as SolidProblem::fields asks: of this rank's cells, or of all
};

/// Solves a problem of linear elasticity on mapped hexahedra and evaluates its crack fronts.
///
/// Continuous polynomials of order p in each unit coordinate, geometry of order max(p, 4) through
/// points of the analytic maps, Cholesky factorisation by MUMPS.  Every rank calls it with the
/// same arguments and gets the same result; the number of ranks changes it by rounding only.
/// An MpiSession must be alive.
///
/// Accuracy (theory manual, chapter FE): with the ring templates of gear_fem at p = 3, G is good
/// to 0.3 %.
/// @throws InputError   a bad value, or a mesh with a Jacobian determinant <= 0
/// @throws SolverError  factorisation or contact failed
[[nodiscard]] SolidResult solve_solid(const HexMesh& mesh, const SolidProblem& problem);

/// The smallest scaled Jacobian determinant over corners and Gauss points [-]; refuses a mesh
/// that is tangled or left-handed anywhere (FE-22).
///
/// @throws InputError  naming the first cell with a determinant <= 0
double check_jacobians(const HexMesh& mesh);

}  // namespace strainwave::fem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/fem/elasticity.hpp"
#include "strainwave/fem/fields.hpp"
#include "strainwave/fem/section_mesh.hpp"

/// @file
/// Bodies of revolution under torque and axial force: finite elements of order p in the meridian
/// section (2.5 dimensions).  All results are linear elastic and per unit of load.

namespace strainwave::fem {

/// The load on the edges of role `loaded`; the edges of role `held` react.
enum class SectionLoad {
  torsion,  ///< a torque of 1 N*m, as shear stress r/J
  tension,  ///< an axial force of 1 N, as stress 1/A
  /// A pressure of 1 Pa normal to the loaded edges; "compliance" is then the displaced volume
  /// [m^3/Pa].  It serves verification, because it strains the hoops, which tension hardly does.
  pressure,
};

/// Options of the elements and of the rings of cells.
struct SectionOptions {
  int order = 6;  ///< p [-]; in 2..8 (torsion also 1)
  /// Rings of cells round the crack tip, each half as wide as the next one outside [-]; in 4..16
  int tip_rings = 8;
  int corner_rings = 6;  ///< rings of cells round a sharp re-entrant corner [-]; in 0..16
  int halvings = 0;      ///< halvings of all cells before the rings are made [-]; in 0..5
  /// Content of SectionSolution::fields; empty if left out.
  FieldRequest fields = {};
};

/// Results at a crack tip, per unit of load.
struct TipResult {
  /// Energy release rate G by the domain integral, mean of the rings [J/m^2 per load^2] (FE-6).
  double energy_release_rate = 0.0;
  double ring_spread = 0.0;  ///< (largest - smallest)/mean of G over the rings [-]
  /// [Pa*m^0.5 per load]; 0 in torsion; a value < 0 means a closed crack
  double K_I = 0.0;
  double K_II = 0.0;   ///< [Pa*m^0.5 per load]; 0 in torsion
  double K_III = 0.0;  ///< [Pa*m^0.5 per load]; 0 in tension
  /// Check of one solution by two evaluations (FE-7): G from the stress intensity that the
  /// displacement of the faces gives, over G from the domain integral, - 1 [-].
  double displacement_check = 0.0;
};

/// A solution with its checks.
struct SectionSolution {
  double compliance = 0.0;          ///< [rad/(N*m)] or [m/N] (FE-4)
  std::vector<double> part_energy;  ///< strain energy of each part [J per load^2]
  std::optional<TipResult> tip = {};
  double energy_balance = 0.0;        ///< strain energy/(work/2) - 1 [-]
  double equilibrium_residual = 0.0;  ///< largest nodal force over largest load [-]
  double worst_jacobian = 0.0;        ///< least det J over its mean in the cell [-]; > 0
  std::size_t cells = 0;
  std::size_t dofs = 0;
  SampledFields fields = {};  ///< fields per unit of load, in the half plane y = 0
};

/// Solves a section under one load.
///
/// Torsion solves for the twist angle psi(r, z) with the weak form int mu r^3 grad psi . grad phi
/// dr dz (FE-1).  Tension solves for u_r and u_z with the hoop strain u_r/r (FE-2).  The elements
/// are of Lagrange type and order p, curved where the mesh has arcs, with hanging nodes at the
/// rings.  Unknowns that belong to one cell alone are eliminated within the cell (FE-45); Eigen's
/// sparse Cholesky factors the rest.
///
/// @throws InputError   for a mesh that check_mesh refuses; without a held or a loaded edge; for a
///                      cell whose Jacobian is not positive at every quadrature point; for numbers
///                      out of range
/// @throws SolverError  if the system of equations is singular
[[nodiscard]] SectionSolution solve_section(const SectionMesh& mesh, SectionLoad load,
                                            const Elasticity& elasticity,
                                            const SectionOptions& options = {});

}  // namespace strainwave::fem

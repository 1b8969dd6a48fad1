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
/// section, 2.5 dimensions.  Everything is per unit of load and linear elastic.

namespace strainwave::fem {

/// What is applied to the edges of role `loaded`, against those of role `held`.
enum class SectionLoad {
  torsion,  ///< a torque of 1 N*m, as shear stress r/J
  tension,  ///< an axial force of 1 N, as stress 1/A
  /// A pressure of 1 Pa, normal to the loaded edges; "compliance" is the volume that it displaces
  /// [m^3/Pa].  For verification: it strains the hoops, which tension hardly does.
  pressure,
};

/// Order and rings.
struct SectionOptions {
  int order = 6;  ///< p [-]; in 2..8 (torsion also 1)
  /// Rings of cells round the crack tip, each half as wide as the one outside it [-]; in 4..16
  int tip_rings = 8;
  int corner_rings = 6;  ///< of cells round a sharp re-entrant corner [-]; in 0..16
  int halvings = 0;      ///< of all cells, before the rings [-]; in 0..5
  /// What to fill SectionSolution::fields with; nothing if left out.
  FieldRequest fields = {};
};

/// What a crack tip says, per unit of load.
struct TipResult {
  /// G: energy release rate by the domain integral, mean of the rings [J/m^2 per load^2] (FE-6)
  double energy_release_rate = 0.0;
  double ring_spread = 0.0;  ///< (largest - smallest)/mean of G over the rings [-]
  double K_I = 0.0;          ///< [Pa*m^0.5 per load]; 0 in torsion; < 0 would be a closed crack
  double K_II = 0.0;         ///< [Pa*m^0.5 per load]; 0 in torsion
  double K_III = 0.0;        ///< [Pa*m^0.5 per load]; 0 in tension
  /// G of the stress intensity that the faces' displacement gives, over G by the domain integral,
  /// - 1 [-]: two evaluations of one solution (FE-7).
  double displacement_check = 0.0;
};

/// A solution with its evidence.
struct SectionSolution {
  double compliance = 0.0;          ///< [rad/(N*m)] or [m/N] (FE-4)
  std::vector<double> part_energy;  ///< strain energy of each part [J per load^2]
  std::optional<TipResult> tip = {};
  double energy_balance = 0.0;        ///< strain energy/(work/2) - 1 [-]
  double equilibrium_residual = 0.0;  ///< largest nodal force over largest load [-]
  double worst_jacobian = 0.0;        ///< least det J over its mean in the cell [-]; > 0
  std::size_t cells = 0;
  std::size_t dofs = 0;
  SampledFields fields = {};  ///< per unit of load, in the half plane y = 0
};

/// Solves one load.
///
/// Torsion: the twist angle psi(r, z), weak form int mu r^3 grad psi . grad phi dr dz (FE-1).
/// Tension: u_r and u_z with hoop strain u_r/r (FE-2).  Lagrange elements of order p, curved where
/// the mesh has arcs; hanging nodes at the rings; what one cell alone has is eliminated in
/// it (FE-45), the rest is factored by Eigen's sparse Cholesky.
///
/// @throws InputError   for a mesh that check_mesh refuses, no edge held or loaded, a cell whose
///                      Jacobian is not positive at every quadrature point, numbers out of range
/// @throws SolverError  if the equations are singular
[[nodiscard]] SectionSolution solve_section(const SectionMesh& mesh, SectionLoad load,
                                            const Elasticity& elasticity,
                                            const SectionOptions& options = {});

}  // namespace strainwave::fem

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/solid.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "solid/assembly.hpp"
#include "solid/contact.hpp"
#include "solid/fields.hpp"
#include "solid/fronts.hpp"
#include "solid/space.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using namespace solid;
using Clock = std::chrono::steady_clock;

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

/// Work and volume between the faces of the cracks.
struct FaceWork {
  double work = 0;    ///< work of the stress without the crack [J], (FE-26)
  double volume = 0;  ///< volume between the faces [m^3]
};

FaceWork face_work(const Space& space, const SolidLoad& load, const Vector& u) {
  const dealii::QGauss<2> rule(static_cast<unsigned>(space.problem.order) + 3);
  dealii::FEFaceValues<3> values(space.body.mapping, space.scalar, rule,
                                 dealii::update_values | dealii::update_normal_vectors |
                                     dealii::update_quadrature_points | dealii::update_JxW_values);
  FaceWork result;
  space.visit_crack_faces([&](const Cell& cell, unsigned f) {
    if (!cell->is_locally_owned()) return;
    Space::reinit(values, cell, f);
    const CellDisplacement displacement(space, cell, u);
    for (const unsigned q : values.quadrature_point_indices()) {
      const Tensor<1, 3> moved = displacement.at(values, q);
      const Tensor<1, 3>& n = values.normal_vector(q);
      result.volume -= moved * n * values.JxW(q);
      if (!load.stress_without_crack) continue;
      result.work += released_traction(load, values, q) * moved * values.JxW(q);  // (FE-26)
    }
  });
  result.work = dealii::Utilities::MPI::sum(result.work, MPI_COMM_WORLD);
  result.volume = dealii::Utilities::MPI::sum(result.volume, MPI_COMM_WORLD);
  return result;
}

/// Largest free nodal force over the largest nodal load [-], (FE-21).
double equilibrium_residual(Vector residual, const Vector& load, const Contact* contact,
                            const Constraints& constraints) {
  residual -= load;
  if (contact != nullptr) residual -= contact->forces;
  constraints.condense(residual);
  double largest = 0;
  for (Index i = 0; i < residual.size(); ++i)
    if (!constraints.is_constrained(i)) largest = std::max(largest, std::abs(residual[i]));
  return largest / load.linfty_norm();  // (FE-21)
}

/// A body under one load.
struct LoadedBody {
  Vector load;  ///< nodal forces [N]
  Vector u;     ///< [m]
  std::optional<Contact> contact;
};

}  // namespace

std::vector<SolidResult> solve_solid(const HexMesh& mesh, const SolidProblem& problem,
                                     std::span<const SolidLoad> loads) {
  const Elasticity& m = problem.material;
  require(m.youngs_modulus > 0 && std::isfinite(m.youngs_modulus), "youngs_modulus",
          m.youngs_modulus, "Pa", "youngs_modulus > 0");
  require(m.poissons_ratio >= 0 && m.poissons_ratio < 0.5, "poissons_ratio", m.poissons_ratio, "1",
          "0 <= poissons_ratio < 0.5");
  require(problem.order >= 1 && problem.order <= 6, "order", problem.order, "1", "1 <= order <= 6");
  require(problem.fields.divisions >= 0 && problem.fields.divisions <= 8, "divisions",
          problem.fields.divisions, "1", "0 <= divisions <= 8");
  if (mesh.cells.empty()) throw InputError("mesh", "has no cells");
  if (loads.empty()) throw InputError("loads", "must have at least one load");
  for (const SolidLoad& load : loads)
    if (load.released && !load.stress_without_crack)
      throw InputError("loads", "must have a stress without the crack where the crack releases it");

  const Space space(mesh, problem);
  SolidResult of_body;
  of_body.worst_jacobian = space.jacobian;
  of_body.dofs = space.dofs.n_dofs();
  of_body.cells = mesh.cells.size();

  const Clock::time_point start = Clock::now();
  const Constraints constraints = support_constraints(space);
  std::vector<LoadedBody> loaded;
  {  // this scope frees the factorisation, which takes most of the memory
    Equations equations(space, constraints);
    std::optional<FaceContact> faces;
    if (problem.crack_faces == CrackFaces::contact) faces.emplace(space, constraints, equations);
    for (const SolidLoad& load : loads) {
      LoadedBody& of = loaded.emplace_back();
      of.load = nodal_loads(space, load);
      of.u = equations.displacements(of.load);
      if (faces) of.contact = faces->close(of.load, of.u);
      if (of.contact) of.u = of.contact->u;
    }
    of_body.assembly_seconds = seconds(equations.assembled() - start);
    of_body.solver_seconds = seconds(Clock::now() - equations.assembled());
    of_body.factor_megabytes = equations.solver().megabytes();
    of_body.factor_operations = equations.solver().operations();
  }

  std::vector<SolidResult> results;
  for (std::size_t n = 0; n < loads.size(); ++n) {
    const auto& [load, u, contact] = loaded[n];
    SolidResult& result = results.emplace_back(of_body);
    if (contact) {
      result.contact_share = contact->share;
      result.contact_iterations = contact->iterations;
      result.contact_overlap = contact->overlap;
    }
    const Contact* const touching = contact ? &*contact : nullptr;
    const InternalForces inner = internal_forces(space, u);
    result.strain_energy = inner.energy;
    result.work = load * u;
    result.equilibrium_residual = equilibrium_residual(inner.forces, load, touching, constraints);
    result.energy_balance = std::abs(result.work / (2 * inner.energy) - 1);
    const FaceWork faces = face_work(space, loads[n], u);
    result.added_work = faces.work;
    result.crack_volume = faces.volume;
    for (std::size_t f = 0; f < mesh.fronts; ++f)
      result.fronts.push_back(evaluate_front(space, loads[n], u, touching, f));
    if (problem.fields.divisions > 0) result.fields = sampled_fields(space, loads[n], u);
  }
  return results;
}

SolidResult solve_solid(const HexMesh& mesh, const SolidProblem& problem, const SolidLoad& load) {
  return std::move(solve_solid(mesh, problem, std::span(&load, 1)).front());
}

double check_jacobians(const HexMesh& mesh) { return worst_jacobian(mesh, Body(mesh, 1)); }

}  // namespace strainwave::fem

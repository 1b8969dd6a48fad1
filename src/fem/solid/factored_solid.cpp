// SPDX-License-Identifier: Apache-2.0
#include "factored_solid.hpp"

#include <algorithm>
#include <cmath>

#include "fields.hpp"
#include "fronts.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

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

SolidProblem checked(const HexMesh& mesh, const SolidProblem& problem) {
  const Elasticity& m = problem.material;
  require(m.youngs_modulus > 0 && std::isfinite(m.youngs_modulus), "youngs_modulus",
          m.youngs_modulus, "Pa", "youngs_modulus > 0");
  require(m.poissons_ratio >= 0 && m.poissons_ratio < 0.5, "poissons_ratio", m.poissons_ratio, "1",
          "0 <= poissons_ratio < 0.5");
  require(problem.order >= 1 && problem.order <= 6, "order", problem.order, "1", "1 <= order <= 6");
  require(problem.fields.divisions >= 0 && problem.fields.divisions <= 8, "divisions",
          problem.fields.divisions, "1", "0 <= divisions <= 8");
  if (mesh.cells.empty()) throw InputError("mesh", "has no cells");
  return problem;
}

}  // namespace

void check(std::span<const SolidLoad> loads) {
  if (loads.empty()) throw InputError("loads", "must have at least one load");
  for (const SolidLoad& load : loads)
    if (load.released && !load.stress_without_crack)
      throw InputError("loads", "must have a stress without the crack where the crack releases it");
}

/// A body under one load.
struct FactoredSolid::Loaded {
  Vector load;  ///< nodal forces [N]
  Vector u;     ///< [m]
  std::optional<Contact> contact;
};

FactoredSolid::FactoredSolid(const HexMesh& mesh, const SolidProblem& problem)
    : mesh_(mesh),
      problem_(checked(mesh, problem)),
      space_(mesh_, problem_),
      start_(Clock::now()),
      constraints_(support_constraints(space_)),
      equations_(std::make_unique<Equations>(space_, constraints_)) {
  if (problem_.crack_faces == CrackFaces::contact)
    contact_ = std::make_unique<FaceContact>(space_, constraints_, *equations_);
  of_body_.worst_jacobian = space_.jacobian;
  of_body_.dofs = space_.dofs.n_dofs();
  of_body_.cells = mesh_.cells.size();
  of_body_.assembly_seconds = seconds(equations_->assembled() - start_);
  factor_seconds_ = seconds(Clock::now() - equations_->assembled());
  of_body_.factor_megabytes = equations_->solver().megabytes();
  of_body_.factor_operations = equations_->solver().operations();
}

FactoredSolid::~FactoredSolid() = default;

SolidResult FactoredSolid::evaluated(const SolidLoad& load, const Loaded& loaded) const {
  const auto& [forces, u, contact] = loaded;
  SolidResult result = of_body_;
  if (contact) {
    result.contact_share = contact->share;
    result.contact_iterations = contact->iterations;
    result.contact_overlap = contact->overlap;
  }
  const Contact* const touching = contact ? &*contact : nullptr;
  const InternalForces inner = internal_forces(space_, u);
  result.strain_energy = inner.energy;
  result.work = forces * u;
  result.equilibrium_residual = equilibrium_residual(inner.forces, forces, touching, constraints_);
  result.energy_balance = std::abs(result.work / (2 * inner.energy) - 1);
  const FaceWork faces = face_work(space_, load, u);
  result.added_work = faces.work;
  result.crack_volume = faces.volume;
  for (std::size_t f = 0; f < mesh_.fronts; ++f)
    result.fronts.push_back(evaluate_front(space_, load, u, touching, f));
  if (problem_.fields.divisions > 0) result.fields = sampled_fields(space_, load, u);
  return result;
}

std::vector<SolidResult> FactoredSolid::solve(std::span<const SolidLoad> loads, Factors after) {
  check(loads);
  const Clock::time_point start = Clock::now();
  std::vector<Loaded> loaded;
  for (const SolidLoad& load : loads) {
    Loaded& of = loaded.emplace_back();
    of.load = nodal_loads(space_, load);
    of.u = equations_->displacements(of.load);
    if (contact_) of.contact = contact_->close(of.load, of.u);
    if (of.contact) of.u = of.contact->u;
  }
  of_body_.solver_seconds = factor_seconds_ + seconds(Clock::now() - start);
  if (after == Factors::freed) {
    contact_.reset();
    equations_.reset();
  }
  std::vector<SolidResult> results;
  for (std::size_t n = 0; n < loads.size(); ++n) results.push_back(evaluated(loads[n], loaded[n]));
  return results;
}

}  // namespace strainwave::fem::solid

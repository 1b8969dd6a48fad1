// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/solid.hpp"

#include <utility>

#include "solid/factored_solid.hpp"

namespace strainwave::fem {

std::vector<SolidResult> solve_solid(const HexMesh& mesh, const SolidProblem& problem,
                                     std::span<const SolidLoad> loads) {
  solid::check(loads);
  return solid::FactoredSolid(mesh, problem).solve(loads, solid::Factors::freed);
}

SolidResult solve_solid(const HexMesh& mesh, const SolidProblem& problem, const SolidLoad& load) {
  return std::move(solve_solid(mesh, problem, std::span(&load, 1)).front());
}

double check_jacobians(const HexMesh& mesh) {
  return solid::worst_jacobian(mesh, solid::Body(mesh, 1));
}

}  // namespace strainwave::fem

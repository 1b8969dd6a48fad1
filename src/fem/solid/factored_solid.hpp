// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "assembly.hpp"
#include "contact.hpp"
#include "space.hpp"

namespace strainwave::fem::solid {

/// What becomes of the factorisation, which takes most of the memory, after a solution.
enum class Factors {
  kept,   ///< more loads follow
  freed,  ///< before the solution is evaluated; no load may follow
};

/// @throws InputError  without a load, or if a load releases a stress that it does not have
void check(std::span<const SolidLoad> loads);

/// A body whose stiffness is factorised.
class FactoredSolid {
 public:
  /// Every rank must construct it with the same arguments.
  /// @throws InputError, SolverError  as solve_solid
  FactoredSolid(const HexMesh& mesh, const SolidProblem& problem);
  ~FactoredSolid();
  FactoredSolid(const FactoredSolid&) = delete;
  FactoredSolid& operator=(const FactoredSolid&) = delete;

  [[nodiscard]] const Space& space() const { return space_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] Equations& equations() { return *equations_; }
  /// The faces of the crack, of a problem whose faces can touch.
  [[nodiscard]] FaceContact& contact() { return *contact_; }

  /// As solve_solid.
  [[nodiscard]] std::vector<SolidResult> solve(std::span<const SolidLoad> loads, Factors after);

 private:
  struct Loaded;
  [[nodiscard]] SolidResult evaluated(const SolidLoad& load, const Loaded& loaded) const;

  HexMesh mesh_;
  SolidProblem problem_;
  Space space_;
  std::chrono::steady_clock::time_point start_;
  Constraints constraints_;
  std::unique_ptr<Equations> equations_;
  std::unique_ptr<FaceContact> contact_;  ///< null if the faces do not touch
  double factor_seconds_ = 0;
  SolidResult of_body_;  ///< what does not depend on the load
};

}  // namespace strainwave::fem::solid

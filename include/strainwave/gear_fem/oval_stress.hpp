// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/gear_fem/oval_cup.hpp"
#include "strainwave/model/result/oval_stress.hpp"

/// @file
/// Stress of a sound flexspline over a turn of the wave generator, as a solid.

namespace strainwave::gear_fem {

/// Largest change of a stress from order p-1 to p over the largest stress, in a usable result [-].
inline constexpr double kStressTolerance = 0.02;

/// Stress over a turn, with its checks.
struct OvalStress : OvalState {
  OvalContact contact;
  std::size_t unknowns{};         ///< of one number of waves
  double order_difference{};      ///< largest change of a stress from p-1 to p over the largest [-]
  double equilibrium_residual{};  ///< largest nodal force out of equilibrium over the largest load
  bool usable = false;
  std::string reason;  ///< reason why the result must not be used; empty if usable

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = OvalStress;
    OvalState::describe(field);
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"unknowns", "", "of one number of waves"}, &R::unknowns);
    field({"order_difference", "1",
           "largest change of a stress from order p-1 to p over the largest stress"},
          &R::order_difference);
    field({"equilibrium_residual", "1",
           "largest nodal force out of equilibrium over the largest nodal load"},
          &R::equilibrium_residual);
    field({"usable", "", "whether the checks agree"}, &R::usable);
    field({"reason", "", "failed check; empty if all agree"}, &R::reason);
  }
};

/// Computes the stress at both faces of diaphragm, barrel and rim (FE-52, FE-53).
///
/// The places are even, from two walls inside each end of a part: at the sharp corner of two walls
/// the stress of a solid has no limit.
///
/// @param cup      with a rim
/// @param torques  T at the output [N*m]; one or more
/// @throws InputError, SolverError  as OvalCup; InputError for a part that is not longer than
///                                  four walls
[[nodiscard]] OvalStress oval_stress(const CupSection& cup, const fem::Elasticity& steel,
                                     const CamFit& fit, const std::vector<double>& torques,
                                     const OvalOptions& options = {});

}  // namespace strainwave::gear_fem

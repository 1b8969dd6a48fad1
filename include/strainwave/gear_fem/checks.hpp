// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "strainwave/core/fields.hpp"

namespace strainwave::gear_fem {

/// Internal checks of a solution; a check that does not apply is absent.
struct Checks {
  std::optional<double> ring_spread = {};   ///< spread of G between rings [-]
  std::optional<double> growth_check = {};  ///< dC/dA over 2G, - 1 [-]
  /// G from the displacement of the faces over G, - 1 [-]
  std::optional<double> displacement_check = {};
  std::optional<double> mode_check = {};  ///< G of the factors K over G, - 1 [-]
  /// compliance of the sound solid over the body of revolution, - 1 [-]
  std::optional<double> sound_check = {};
  /// compliance at order p-1 over compliance at p, - 1 [-]
  std::optional<double> lower_order = {};
  double energy_balance = 0.0;        ///< strain energy over work, minus 1 [-]
  double equilibrium_residual = 0.0;  ///< largest nodal force over largest load [-]
  double worst_jacobian = 0.0;        ///< least Jacobian of a cell over its mean [-]
  std::size_t unknowns = 0;           ///< unknowns of one solution

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, std::string_view doc, auto member) {
      field({.name = name, .unit = "1", .doc = doc, .detail = true}, member);
    };
    add("ring_spread", "spread of the energy release rate between rings", &Checks::ring_spread);
    add("growth_check", "dC/dA of neighbouring sizes over 2G, minus 1", &Checks::growth_check);
    add("displacement_check",
        "G from the displacement of the faces over G from the domain integral, minus 1",
        &Checks::displacement_check);
    add("mode_check", "G of the stress intensity factors over G from the domain integral, minus 1",
        &Checks::mode_check);
    add("sound_check",
        "compliance without the crack over compliance of the body of revolution, minus 1",
        &Checks::sound_check);
    add("lower_order", "compliance at order p-1 over compliance at order p, minus 1",
        &Checks::lower_order);
    add("energy_balance", "strain energy over work, minus 1", &Checks::energy_balance);
    add("equilibrium_residual", "largest unbalanced nodal force over largest load",
        &Checks::equilibrium_residual);
    add("worst_jacobian", "least Jacobian determinant of a cell over its mean",
        &Checks::worst_jacobian);
    field({.name = "unknowns", .unit = "", .doc = "unknowns of one solution", .detail = true},
          &Checks::unknowns);
  }
};

}  // namespace strainwave::gear_fem

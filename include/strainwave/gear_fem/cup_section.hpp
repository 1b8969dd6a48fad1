// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/axisymmetric.hpp"
#include "strainwave/gear_fem/checks.hpp"
#include "strainwave/model/input/flexspline.hpp"

namespace strainwave::gear_fem {

/// The meridian section of a flexspline, without teeth.
///
/// z = 0 is the outer face of the diaphragm.  A boss lies outside at z < 0; barrel and rim follow
/// inside at z > thickness.  Without a diaphragm, z = 0 is the end of the barrel.  The end of the
/// boss is held, else the bore of the diaphragm, else the end of the barrel.  The open end is
/// loaded.
struct CupSection {
  TubeSection barrel;
  std::optional<TubeSection> rim = {};
  std::optional<Diaphragm> diaphragm = {};
  std::optional<TubeSection> boss = {};
  /// Fillet between barrel and diaphragm, inside [m]; >= 0; 0 is a sharp corner.
  double barrel_fillet = 0.0;
  /// Fillet between diaphragm and boss, outside [m]; >= 0; 0 is a sharp corner.
  double boss_fillet = 0.0;
};

/// The sections that an input file gives.  An input file cannot give fillets.
/// @throws InputError  if the flexspline has no barrel: crack_free is not "sections"
[[nodiscard]] CupSection cup_section(const Flexspline& flexspline);

/// Meshes a cup.
/// @throws InputError  for sections that do not meet: a diaphragm whose outer diameter is not
///                     inside the barrel's wall, a boss that is not as wide as its bore, ...
[[nodiscard]] fem::SectionMesh mesh_cup(const CupSection& cup);

/// The part that a section contributes to the compliance of the cup.
struct CupPart {
  std::string name;         ///< "rim", "barrel", "diaphragm", "boss"
  double compliance = 0.0;  ///< twice its strain energy at a torque of 1 N*m [rad/(N*m)] (FE-10)
  double share = 0.0;       ///< share of the whole [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "rim, barrel, diaphragm or boss"}, &CupPart::name);
    field({"compliance", "rad/(N*m)", "part of the compliance"}, &CupPart::compliance);
    field({"share", "1", "share of the whole compliance"}, &CupPart::share);
  }
};

/// A cup in torsion.
struct CupResult {
  double compliance = 0.0;  ///< rotation of the open end against the held end [rad/(N*m)]
  std::vector<CupPart> parts;
  fem::SectionSolution solution;
  double lower_order = 0.0;  ///< compliance at order p-1 over compliance at p, - 1 [-]
  bool usable = false;
  std::string reason;  ///< reason why the result must not be used; empty if usable

  [[nodiscard]] Checks checks() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"compliance", "rad/(N*m)", "rotation of the open end against the held end"},
          &CupResult::compliance);
    field({"parts", "", "contribution of each part"}, &CupResult::parts);
    field({"evidence", "", "internal checks of the solution"}, &CupResult::checks);
    field({"usable", "", "whether the checks agree"}, &CupResult::usable);
    field({"reason", "", "failed check; empty if all agree"}, &CupResult::reason);
  }
};

/// Largest change of the compliance from order p-1 to p in a usable result [-].
inline constexpr double kOrderTolerance = 1e-3;

/// Solves a cup in torsion at orders p and p-1.
/// @throws InputError, SolverError  on the same conditions as fem::solve_section
[[nodiscard]] CupResult solve_cup(const CupSection& cup, const fem::Elasticity& elasticity,
                                  const fem::SectionOptions& options = {});

}  // namespace strainwave::gear_fem

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
/// z = 0 is the outer face of the diaphragm: the boss, if there is one, stands outside at z < 0,
/// barrel and rim follow inside at z > thickness.  Without a diaphragm z = 0 is the barrel's end.
/// Held: the boss's end, else the diaphragm's bore, else the barrel's end.  Loaded: the open end.
struct CupSection {
  TubeSection barrel;
  std::optional<TubeSection> rim = {};
  std::optional<Diaphragm> diaphragm = {};
  std::optional<TubeSection> boss = {};
  /// Between barrel and diaphragm, inside [m]; >= 0; 0 is a sharp corner.
  double barrel_fillet = 0.0;
  /// Between diaphragm and boss, outside [m]; >= 0; 0 is a sharp corner.
  double boss_fillet = 0.0;
};

/// The sections that an input file gives; it knows no fillets.
/// @throws InputError  if the flexspline has no barrel: crack_free is not "sections"
[[nodiscard]] CupSection cup_section(const Flexspline& flexspline);

/// Whether the rim's wall covers the barrel's, inside and outside: a solid can have no other.
[[nodiscard]] bool rim_covers(const TubeSection& rim, const TubeSection& barrel);

/// Grid of a cup.
/// @throws InputError  for sections that do not meet: a diaphragm whose outer diameter is not
///                     inside the barrel's wall, a boss that is not as wide as its bore, ...
[[nodiscard]] fem::SectionMesh mesh_cup(const CupSection& cup);

/// What a part of the cup has of the whole compliance.
struct CupPart {
  std::string name;         ///< "rim", "barrel", "diaphragm", "boss"
  double compliance = 0.0;  ///< twice its strain energy at a torque of 1 N*m [rad/(N*m)] (FE-10)
  double share = 0.0;       ///< of the whole [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "rim, barrel, diaphragm or boss"}, &CupPart::name);
    field({"compliance", "rad/(N*m)", "its part of the whole"}, &CupPart::compliance);
    field({"share", "1", "of the whole"}, &CupPart::share);
  }
};

/// A cup in torsion.
struct CupResult {
  double compliance = 0.0;  ///< open end against the held one [rad/(N*m)]
  std::vector<CupPart> parts;
  fem::SectionSolution solution;
  double lower_order = 0.0;  ///< compliance at order p-1 over that at p, - 1 [-]
  bool usable = false;
  std::string reason;  ///< why it may not be used; empty if it may

  [[nodiscard]] Checks checks() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"compliance", "rad/(N*m)", "torsion of the open end against the held one"},
          &CupResult::compliance);
    field({"parts", "", "what each part has of it"}, &CupResult::parts);
    field({"evidence", "", "how well the solution agrees with itself"}, &CupResult::checks);
    field({"usable", "", "whether the checks agree"}, &CupResult::usable);
    field({"reason", "", "why not; empty if they do"}, &CupResult::reason);
  }
};

/// How much the compliance of a usable result may change from order p-1 to p [-].
inline constexpr double kOrderTolerance = 1e-3;

/// Solves a cup in torsion, at order p and p-1.
/// @throws InputError, SolverError  as fem::solve_section
[[nodiscard]] CupResult solve_cup(const CupSection& cup, const fem::Elasticity& elasticity,
                                  const fem::SectionOptions& options = {});

}  // namespace strainwave::gear_fem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/sif/library.hpp"

namespace strainwave::sif {

/// Material properties that the evaluation of one crack needs.
struct CrackMaterial {
  double youngs_modulus = 210e9;             ///< E [Pa]; > 0
  double poissons_ratio = 0.3;               ///< nu [-]; in (-1, 0.5)
  std::optional<double> fracture_toughness;  ///< K_Ic [Pa*m^0.5]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"youngs_modulus", "Pa", "E"}, &CrackMaterial::youngs_modulus);
    field({"poissons_ratio", "1", "nu"}, &CrackMaterial::poissons_ratio);
    field({"fracture_toughness", "Pa*m^0.5", "K_Ic"}, &CrackMaterial::fracture_toughness);
  }
};

/// A field or load with its value.
struct Input {
  std::string name;
  std::string unit;
  std::string doc;  ///< meaning of the field or load
  double value = 0.0;
  /// true: given by the caller; false: the example of a field, or 0 for a load
  bool given = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the field or load"}, &Input::name);
    field({"unit", "", "SI unit"}, &Input::unit);
    field({"value", kUnitBeside, "its value"}, &Input::value);
    field({"given", "",
           "value from the caller; if left out, the example of a field, or 0 for a load"},
          &Input::given);
  }
};

/// Y = K/(sigma sqrt(pi a)) of one load at one point of the front [-].
struct GeometryFactors {
  std::string load;
  std::string point;
  double Y_I = 0.0;
  double Y_II = 0.0;
  double Y_III = 0.0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"load", "", "of the factors"}, &GeometryFactors::load);
    field({"point", "", "of the front"}, &GeometryFactors::point);
    field({"Y_I", "1", "K_I/(sigma sqrt(pi a))"}, &GeometryFactors::Y_I);
    field({"Y_II", "1", "K_II/(sigma sqrt(pi a))"}, &GeometryFactors::Y_II);
    field({"Y_III", "1", "K_III/(sigma sqrt(pi a))"}, &GeometryFactors::Y_III);
  }
};

/// Entry (i, j) of the added compliance: increase of the displacement that does work on load i, per
/// unit of load j.
struct ComplianceEntry {
  std::string load_i;
  std::string load_j;
  double value = 0.0;
  std::string unit;  ///< unit such as "m/N", "1/N", "rad/(N*m)", "m^3/Pa"

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"load_i", "", "whose displacement"}, &ComplianceEntry::load_i);
    field({"load_j", "", "factors per unit of this load"}, &ComplianceEntry::load_j);
    field({"unit", "", "SI unit"}, &ComplianceEntry::unit);
    field({"value", kUnitBeside, "added compliance"}, &ComplianceEntry::value);
  }
};

/// A solution with numbers: stress intensities, geometry factors, compliance, and its evidence.
struct Evaluation {
  SolutionInfo info;  ///< title, source, accuracy and tag of the equation
  std::vector<Input> fields;
  std::vector<Input> loads;
  CrackMaterial material;
  double crack_size = 0.0;  ///< size a used in the geometry factors [m]
  std::vector<GeometryFactors> factors;
  /// Values at the named points under all loads; empty without loads.
  std::vector<PointIntensity> points;
  /// Largest K_I, and largest magnitude of K_II and K_III with its sign, along the front, each at
  /// its own point; absent without loads.
  std::optional<PointIntensity> largest;
  /// True if K_I < 0 somewhere on the front.  The faces press on each other there, and mode I
  /// counts as 0 in the results below (FR-17).  The compliance is still that of open faces.
  bool pressed = false;
  /// Equivalent intensity sqrt(G E') at the worst point of the front [Pa*m^0.5]; (FR-20).
  std::optional<double> equivalent;
  std::optional<double> utilisation;  ///< equivalent/K_Ic [-]
  std::vector<ComplianceEntry> compliance;
  double quadrature_error = 0.0;  ///< relative error of the compliance [-]
  bool converged = false;         ///< whether the quadrature of the compliance converged
  std::vector<ValidityLimit> validity;

  /// True if the crack keeps every limit of the validity range, so the stated accuracy is valid.
  [[nodiscard]] bool in_range() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    SolutionInfo::describe([&](const Field& what, auto member) {
      field(what, [member](const Evaluation& e) { return std::invoke(member, e.info); });
    });
    field({"fields", "", "of the crack"}, &Evaluation::fields);
    field({"loads", "", "that act"}, &Evaluation::loads);
    field({"material", "", "elastic constants and toughness"}, &Evaluation::material);
    field({"crack_size", "m", "crack size a in the geometry factors"}, &Evaluation::crack_size);
    field({"geometry_factors", "", "geometry factors for each load and point"},
          &Evaluation::factors);
    field({"points", "", "stress intensities under all loads, at the named points"},
          &Evaluation::points);
    field({"largest", "", "along the front"}, &Evaluation::largest);
    field({"faces_pressed", "", "whether the faces press on each other somewhere on the front"},
          &Evaluation::pressed);
    field({"equivalent", "Pa*m^0.5", "sqrt(G E') at the worst point"}, &Evaluation::equivalent);
    field({"utilisation", "1", "equivalent over K_Ic"}, &Evaluation::utilisation);
    field({"added_compliance", "", "upper triangle"}, &Evaluation::compliance);
    field({"quadrature_error", "1", "relative error of the compliance"},
          &Evaluation::quadrature_error);
    field({"validity", "", "each limit of the range"}, &Evaluation::validity);
    field({"in_range", "", "whether the crack keeps every limit of the range"},
          &Evaluation::in_range);
  }
};

/// One standard relative uncertainty of some modes of K.
struct ModeAccuracy {
  std::string_view of;                ///< "K", "K_I", or "K_II and K_III"
  double relative_uncertainty = 0.0;  ///< [-]
};
/// The accuracy of all modes for which a solution gives K.
[[nodiscard]] std::vector<ModeAccuracy> mode_accuracies(const SolutionInfo& info);
/// The accuracy of the modes that the loads of an evaluation cause; if no load is given, of the
/// modes of any load.
[[nodiscard]] std::vector<ModeAccuracy> mode_accuracies(const Evaluation& evaluation);

/// Number of points at which a front is scanned for its largest stress intensity.
inline constexpr int kFrontScan = 65;

/// Evaluates a solution.
///
/// @param row       row of the library
/// @param values    values of fields and loads by name [SI].  A field left out takes its example, a
///                  load left out is 0.  A field poissons_ratio left out takes the value of the
///                  material; if it is given, it replaces the value of the material
/// @param material  E, nu, toughness
/// @throws InputError   if a name is unknown, a number is outside its range, or the geometry is
///                      impossible
/// @throws SolverError  if a result is not finite because numbers are too large or too small for
///                      the formulas
[[nodiscard]] Evaluation evaluate(const Row& row, const Assignments& values,
                                  const CrackMaterial& material = {});

/// Unit of the compliance between two loads.  The displacement that does work is a length for a
/// force, an angle for a moment, and a volume for a stress.
[[nodiscard]] std::string compliance_unit(const LoadInfo& i, const LoadInfo& j);

}  // namespace strainwave::sif

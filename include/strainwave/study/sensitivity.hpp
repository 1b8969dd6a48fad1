// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/curve_derivatives.hpp"

/// @file
/// What `strainwave sensitivity` tells: how stiffness and its loss depend on each input.

namespace strainwave {

/// An output that is differentiated.
struct SensitivityOutput {
  std::string name;  ///< "cracked.positive.stiffness"
  Quantity value;    ///< with the uncertainty of the model's form, which is not of the inputs
  /// What the elasticities leave of the dimensions of the output, (SN-6), powers of length and of
  /// force; 0 but for rounding unless a number was read without its derivative.
  double length_residual = 0.0;
  double force_residual = 0.0;
  /// Elasticity to constants of the model that are pressures, which (SN-6) counts: the maker's
  /// torques by convention, (TC-14).  Not part of documents.
  double of_pressures = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "the output"}, &SensitivityOutput::name);
    field({"value", kUnitBeside, "its value"}, &SensitivityOutput::value);
    field({"length_residual", "1", "what the elasticities leave of the power of length"},
          &SensitivityOutput::length_residual);
    field({"force_residual", "1", "what the elasticities leave of the power of force"},
          &SensitivityOutput::force_residual);
  }
};

/// How one output depends on one input.
struct Influence {
  double derivative = 0.0;  ///< dy/dx [unit of the output per unit of the input]
  double elasticity = 0.0;  ///< d ln y/d ln x [-]; 0 where the input is 0; eq. (SN-1)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"derivative", kUnitBeside, "dy/dx, unit of the output over that of the input"},
          &Influence::derivative);
    field({"elasticity", "1", "d ln y/d ln x"}, &Influence::elasticity);
  }
};

/// One number of the file.
struct SensitivityInput {
  std::string path;
  std::string_view unit;  ///< SI
  double value = 0.0;
  std::vector<Influence> influence;  ///< shape (n outputs)

  /// Largest magnitude of an elasticity over the outputs.
  [[nodiscard]] double largest_elasticity() const;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "field of the input"}, &SensitivityInput::path);
    field({"unit", "", "SI unit of the field"}, &SensitivityInput::unit);
    field({"value", kUnitBeside, "value in the file"}, &SensitivityInput::value);
    field({"influence", "", "on each output, in their order"}, &SensitivityInput::influence);
  }
};

/// Exact first derivatives at one drive: of the sum of the members, and of the coupled drive where
/// it is solved.
struct Sensitivity {
  /// Stiffness of the sum, sound and cracked under both senses of torque; its losses that are not
  /// zero; then K1, K2, K3 of the coupled drive, sound, and cracked if there are cracks.
  std::vector<SensitivityOutput> outputs;
  /// Numbers that any output depends on, the largest elasticity first.
  std::vector<SensitivityInput> inputs;
  std::vector<std::string> no_influence;  ///< paths of all other numbers: every derivative is 0
  /// Numbers to which K1, K2, K3 have no derivative; of the coupled drive, where it is solved.
  std::vector<CurveStep> not_differentiated;
  std::vector<Note> notes;
  std::string unusable_because;  ///< empty if usable

  [[nodiscard]] bool usable() const { return unusable_because.empty(); }
  /// Largest magnitude of the residuals of all outputs (SN-6).
  [[nodiscard]] double homogeneity_residual() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"outputs", "", "what is differentiated"}, &Sensitivity::outputs);
    field({"inputs", "", "fields with an influence, the largest elasticity first"},
          &Sensitivity::inputs);
    field({"no_influence", "", "all other numbers of the file"}, &Sensitivity::no_influence);
    field({"not_differentiated", "", "fields to which K1, K2, K3 have no derivative"},
          &Sensitivity::not_differentiated);
    field({"homogeneity_residual", "1", "largest residual of the dimensions"},
          &Sensitivity::homogeneity_residual);
  }
};

/// A residual beyond this makes a sensitivity not usable; rounding leaves less than 1e-12.
inline constexpr double kMaxHomogeneityResidual = 1e-9;

/// Derivatives and elasticities of stiffness K_HD, of stiffness loss, and of K1, K2, K3 of the
/// coupled drive where it is solved, to every number of a drive.
///
/// Implements theory manual eqs. (SN-1), (SN-2), (SN-6), (TC-27): forward-mode automatic
/// differentiation of the corrected series model and of the equilibrium of the coupled drive, exact
/// but for rounding and the tolerance of the crack integrals.
/// Whole numbers, such as the wave number, are not differentiated.  At a crack whose faces just
/// touch the derivative does not exist; a note says so.
///
/// @param gear     drive, cracks, load
/// @param options  tolerance of the crack integrals; value and derivatives are held to it
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] Sensitivity sensitivity_of(const GearSet& gear, const StiffnessOptions& options = {});

/// The sensitivity with its residuals of (SN-6) computed; not usable if one of them is too large.
///
/// `sensitivity_of` ends with it: a number that the model reads without its derivative, which no
/// other check would see, leaves its dimension missing.
[[nodiscard]] Sensitivity held_to_dimensions(Sensitivity sensitivity);

/// Power of length and of force in a unit: those of N*m are 1 and 1.
struct LengthAndForce {
  double length = 0.0;
  double force = 0.0;
};
/// @throws InputError  if the unit has a dimension that length and force do not make up
[[nodiscard]] LengthAndForce length_and_force(std::string_view unit);

}  // namespace strainwave

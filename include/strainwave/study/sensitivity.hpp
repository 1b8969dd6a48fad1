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
/// The results of `strainwave sensitivity`: dependence of stiffness and stiffness loss on each
/// input.

namespace strainwave {

/// An output that is differentiated.
struct SensitivityOutput {
  std::string name;  ///< "cracked.positive.stiffness"
  Quantity value;    ///< value with the uncertainty of the model's form, without that of the inputs
  /// Residual of the dimensions of the output, (SN-6), as powers of length and of force.  It is
  /// zero up to rounding unless a number was read without its derivative.
  double length_residual = 0.0;
  double force_residual = 0.0;
  /// Elasticity with respect to constants of the model that are pressures, which (SN-6) includes:
  /// the constants of the maker's torques by convention, (TC-14).  Documents do not contain this
  /// number.
  double of_pressures = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "the output"}, &SensitivityOutput::name);
    field({"value", kUnitBeside, "its value"}, &SensitivityOutput::value);
    field({"length_residual", "1", "residual of the power of length after the elasticities"},
          &SensitivityOutput::length_residual);
    field({"force_residual", "1", "residual of the power of force after the elasticities"},
          &SensitivityOutput::force_residual);
  }
};

/// Dependence of one output on one input.
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

/// One number of the file and its influence on each output.
struct SensitivityInput {
  std::string path;
  std::string_view unit;  ///< SI unit of the number
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
    field({"influence", "", "influence on each output, in the order of the outputs"},
          &SensitivityInput::influence);
  }
};

/// Exact first derivatives at one drive: those of the sum of the members and, if it is solved,
/// those of the coupled drive.
struct Sensitivity {
  /// Stiffness of the sum, sound and cracked under both senses of torque; its losses that are not
  /// zero; then K1, K2, K3 of the coupled drive, sound, and cracked if there are cracks.
  std::vector<SensitivityOutput> outputs;
  /// Numbers on which at least one output depends, the largest elasticity first.
  std::vector<SensitivityInput> inputs;
  std::vector<std::string> no_influence;  ///< paths of the numbers whose derivatives are all 0
  /// Numbers with respect to which K1, K2, K3 have no derivative, if the coupled drive is solved.
  std::vector<CurveStep> not_differentiated;
  std::vector<Note> notes;       ///< remarks on the validity of the derivatives
  std::string unusable_because;  ///< reason why the result must not be used; empty if usable

  /// Whether the result may be used.
  [[nodiscard]] bool usable() const { return unusable_because.empty(); }
  /// Largest magnitude of the residuals of all outputs (SN-6).
  [[nodiscard]] double homogeneity_residual() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"outputs", "", "what is differentiated"}, &Sensitivity::outputs);
    field({"inputs", "", "fields with an influence, the largest elasticity first"},
          &Sensitivity::inputs);
    field({"no_influence", "", "all other numbers of the file"}, &Sensitivity::no_influence);
    field({"not_differentiated", "", "fields with respect to which K1, K2, K3 have no derivative"},
          &Sensitivity::not_differentiated);
    field({"homogeneity_residual", "1", "largest residual of the dimensions"},
          &Sensitivity::homogeneity_residual);
  }
};

/// Largest residual of a usable sensitivity; rounding leaves less than 1e-12.
inline constexpr double kMaxHomogeneityResidual = 1e-9;

/// Derivatives and elasticities of stiffness K_HD, of stiffness loss, and of K1, K2, K3 of the
/// coupled drive if it is solved, with respect to every number of a drive.
///
/// Implements theory manual eqs. (SN-1), (SN-2), (SN-6), (TC-27): forward-mode automatic
/// differentiation of the corrected series model and of the equilibrium of the coupled drive, exact
/// apart from rounding and the tolerance of the crack integrals.
/// Whole numbers, such as the wave number, are not differentiated.  If the faces of a crack just
/// touch, the derivative does not exist; a note reports this.
///
/// @param gear     drive, cracks, load
/// @param options  tolerance of the crack integrals, for values and derivatives
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] Sensitivity sensitivity_of(const GearSet& gear, const StiffnessOptions& options = {});

/// Computes the residuals of (SN-6) of a sensitivity and marks it not usable if one is too large.
///
/// `sensitivity_of` ends with this check.  A number that the model reads without its derivative
/// leaves a residual in its dimension; no other check would find such a number.
[[nodiscard]] Sensitivity held_to_dimensions(Sensitivity sensitivity);

/// Powers of length and of force in a unit; for N*m they are 1 and 1.
struct LengthAndForce {
  double length = 0.0;  ///< power of length [-]
  double force = 0.0;   ///< power of force [-]
};
/// @throws InputError  if the unit has a dimension other than length and force
[[nodiscard]] LengthAndForce length_and_force(std::string_view unit);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/quantity.hpp"

namespace strainwave {

/// Compliances of the members at the output [rad/(N*m)].
struct Compliances {
  Quantity wave_generator;
  Quantity flexspline;
  Quantity output_shaft;
  Quantity total;
};

/// The sound drive.
struct IntactDrive {
  Compliances compliance;
  Quantity stiffness;  ///< K_HD at the output, input locked [N*m/rad]
  Quantity wind_up;    ///< at the given torque [rad]
};

/// The cracked drive under one sense of torque.
struct CrackedDrive {
  Compliances compliance;
  Quantity stiffness;         ///< [N*m/rad]
  Quantity stiffness_change;  ///< K/K_intact - 1 [-]; negative means softer
  Quantity wind_up;           ///< at the given torque [rad]
};

/// Which sense of torque, with the given axial force, pulls the faces of a crack apart.
enum class OpensUnder { neither, positive, negative, both };
template <>
struct EnumNames<OpensUnder> {
  static constexpr std::array<std::string_view, 4> names = {"neither", "positive", "negative",
                                                            "both"};
};

/// K_I, K_II, K_III at one point of a crack front under the given load; K_II and K_III have the
/// sign of the shear in the corrected method, magnitudes in the article's.
struct StressIntensities {
  Quantity K_I;    ///< [Pa*m^0.5]
  Quantity K_II;   ///< [Pa*m^0.5]
  Quantity K_III;  ///< [Pa*m^0.5]
};

/// What one crack adds under one sense of torque.
struct AddedCompliance {
  /// Its share of the drive's compliance [rad/(N*m)].
  Quantity at_output;
  /// Symmetric matrix over [axial, torsion] of cracks in flexspline and shaft:
  /// axial-axial [m/N], axial-torsion [1/N], torsion-torsion [rad/(N*m)].
  std::optional<std::array<Quantity, 3>> axial_torsion;
};

/// One crack and its evidence.
struct CrackReport {
  std::string path = {};  ///< "output_shaft.crack[0]"
  std::string kind = {};
  OpensUnder opens_under = OpensUnder::neither;
  AddedCompliance positive = {};
  AddedCompliance negative = {};
  /// At the deepest point of the front (the tip, where a front has no deepest point).
  std::optional<StressIntensities> deepest = {};
  /// The largest magnitude of each mode along the front.
  std::optional<StressIntensities> largest = {};
  /// Relative, of the largest K along the front [-]; absent where there is no K.
  std::optional<double> intensity_uncertainty = {};
};

/// The maker's stiffnesses of the coupled drive, cracks at the positions of the file [N*m/rad].
struct CurveStiffness {
  Quantity K1;
  Quantity K2;
  Quantity K3;
};

/// The coupled drive beside the series model, where the file gives enough for it.
struct CurveResult {
  CurveStiffness intact;
  CurveStiffness positive;  ///< cracked, torque about +z
  CurveStiffness negative;  ///< cracked, torque about -z
};

/// Torsional stiffness of a drive, sound and cracked, by one method, with its evidence.
struct StiffnessResult {
  Method method = Method::corrected;
  IntactDrive intact;
  CrackedDrive positive;  ///< torque about +z
  CrackedDrive negative;  ///< torque about -z
  std::optional<CurveResult> curve;
  std::vector<CrackReport> cracks;
  /// Of all cracks, where a material gives toughness or yield strength; corrected method only.
  std::vector<CrackStrength> strength;
  std::vector<Note> notes;
  std::vector<AccuracyBasis> accuracies;  ///< where the uncertainties come from
  std::vector<std::string> equations;     ///< tags of the equations used, in order of first use
  /// Empty if the answer may be used; else one sentence that says why not.
  std::string unusable_because;

  [[nodiscard]] bool usable() const { return unusable_because.empty(); }
};

}  // namespace strainwave

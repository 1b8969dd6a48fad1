// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/quadrature.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// What the sum of the members takes beside the drive.
struct StiffnessOptions {
  /// Tolerance of the crack integrals.
  QuadratureOptions quadrature = {};
  /// The coupled drive of the same gear, if the result gives it beside the sum of the members.  In
  /// this case the stated accuracy of the sum contains the coupled value, and notes on effects that
  /// the sum leaves out are information only.
  const CurveResult* coupled = nullptr;

  /// Severity of a note on an effect that only the coupled drive contains.
  [[nodiscard]] Severity left_out() const {
    return coupled != nullptr ? Severity::information : Severity::care;
  }
};

/// Compliance of one member at the output, with its cracks.
struct MemberCompliance {
  double intact = 0.0;                ///< without cracks [rad/(N*m)]
  double relative_uncertainty = 0.0;  ///< relative uncertainty of `intact` [-]
  std::vector<CrackReport> cracks;  ///< the member's cracks, each with the compliance that it adds
  std::vector<Note> notes;          ///< remarks on the validity of the member's values
  /// uncertainties that entered the values, with their bases
  std::vector<AccuracyBasis> accuracies;
  std::vector<std::string> equations;  ///< tags of the theory manual
  std::string unusable_because;        ///< empty if usable
};

/// Compliance of the wave generator: lobe compliance (ST-8, ST-9), conversion (ST-6, ST-7), race
/// cracks.
[[nodiscard]] MemberCompliance wave_generator_compliance(const GearSet& gear,
                                                         const StiffnessOptions& options = {});

/// Compliance of the flexspline: factor (ST-4) or sections (ST-2, ST-3), wall cracks under both
/// senses of torque.
[[nodiscard]] MemberCompliance flexspline_compliance(const GearSet& gear,
                                                     const StiffnessOptions& options = {});

/// Compliance of the output shaft: tube (ST-2), annular cracks.
[[nodiscard]] MemberCompliance output_shaft_compliance(const GearSet& gear,
                                                       const StiffnessOptions& options = {});

/// Torsional stiffness of a drive at the output with locked input, by the corrected method.
///
/// Implements theory manual eq. (ST-1),
///
///     K_HD = 1/(lambda_H + lambda_f + lambda_so),
///
/// each lambda being the compliance of a sound member plus the part that its cracks add.  The sum
/// leaves out the compliances of the tooth mesh, the circular spline and the diaphragm (unless
/// sections are given).  Without an output shaft, the result is therefore 2 to 5 times too stiff
/// against catalogue values.  The accuracy of the sum contains this, eq. (ST-18).
///
/// @param gear     drive, cracks, load; checked by `check`
/// @param options  tolerance of the crack integrals
/// @return         stiffness sound and cracked, for both senses of torque, with evidence
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] StiffnessResult torsional_stiffness(const GearSet& gear,
                                                  const StiffnessOptions& options = {});
/// The same for a drive that has passed `check`, which is not repeated.
[[nodiscard]] StiffnessResult stiffness_of_checked(const GearSet& gear,
                                                   const StiffnessOptions& options = {});

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// Section of a tooth at its root.
struct RootSection {
  double thickness = 0.0;    ///< s_F of the tooth at its root [m]; > 0
  double lever = 0.0;        ///< of the force over the root [m]; > 0
  double root_radius = 0.0;  ///< rho_F [m]; > 0
  double face_width = 0.0;   ///< b [m]; > 0
};

/// Nominal bending stress of the root, 6 F h/(b s_F^2), times Y_S (LI-41) [Pa].
/// @param root   section of the tooth, each dimension > 0 [m]
/// @param force  across the tooth, at the lever [N]
/// @throws InputError  if a dimension is out of range
[[nodiscard]] double root_bending_stress(const RootSection& root, double force);

/// Stress correction factor Y_S of ISO 6336-3 (LI-41) [-].  It is stated for 1 <= q_s < 8, with
/// q_s = s_F/(2 rho_F).
[[nodiscard]] double stress_correction(const RootSection& root);
/// q_s of the stress correction [-].
[[nodiscard]] double notch_parameter(const RootSection& root);

/// Support factor n_sigma of a notch in steel by the FKM guideline (LI-43) [-]; at least 1.
/// @param root_radius       [m]; > 0
/// @param tensile_strength  R_m [Pa]; > 0
[[nodiscard]] double notch_support(double root_radius, double tensile_strength);

/// Concentrations of the rim's stresses at the bottom of a row of grooves (LI-42) [-]; at least 1.
struct GrooveConcentration {
  double hoop = 1.0;   ///< of the hoop stress
  double shear = 1.0;  ///< of the shear stress by the torque
};
/// From the stress intensity of a row of deep grooves and the field of a blunt tip.  For radii well
/// below the pitch.  The factors are estimates; no finite elements confirm them.
/// @param pitch        of the teeth at their roots [m]; > 0
/// @param root_radius  [m]; > 0
[[nodiscard]] GrooveConcentration groove_concentration(double pitch, double root_radius);

}  // namespace strainwave

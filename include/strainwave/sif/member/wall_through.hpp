// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/tube/shell_factors.hpp"
#include "strainwave/sif/tube/shell_row.hpp"

namespace strainwave::sif {

/// Stress of a thin tube on the plane of an inclined crack, per unit of axial force and torque.
template <class Real>
struct BasicCrackPlaneStress {
  std::array<Real, 2> normal{};  ///< sigma_n per [P, T] [1/m^2, 1/m^3]
  std::array<Real, 2> shear{};   ///< tau_n per [P, T] [1/m^2, 1/m^3]
};
using CrackPlaneStress = BasicCrackPlaneStress<double>;

/// Implements theory manual eq. (FR-6),
///
///     sigma_n = P sin^2(b)/(2 pi r t) + K_u T sin(2b)/(2 pi r^2 t),
///     tau_n   = P sin(b)cos(b)/(2 pi r t) + K_u T cos(2b)/(2 pi r^2 t).
///
/// @param mean_radius     r [m]; > 0
/// @param wall_thickness  t [m]; > 0, t/r small (Bredt: 1.5 % of tau at t/r = 0.03)
/// @param angle           angle beta from the generator (+z) toward -theta [rad]
/// @param nonuniformity   K_u, multiplies the stress of the torque [-]
/// @{
[[nodiscard]] CrackPlaneStress crack_plane_stress(double mean_radius, double wall_thickness,
                                                  double angle, double nonuniformity);
[[nodiscard]] BasicCrackPlaneStress<CrackReal> crack_plane_stress(const CrackReal& mean_radius,
                                                                  const CrackReal& wall_thickness,
                                                                  const CrackReal& angle,
                                                                  const CrackReal& nonuniformity);
[[nodiscard]] BasicCrackPlaneStress<DualReal> crack_plane_stress(const DualReal& mean_radius,
                                                                 const DualReal& wall_thickness,
                                                                 const DualReal& angle,
                                                                 const DualReal& nonuniformity);
/// @}

template <class Real>
class BasicThroughCrackFamily;

/// Straight through crack in the wall of a thin tube, loads [axial force, torque].
///
/// The stress intensity (FR-7) is that of the curved sheet (FR-8), (FR-9), linear through the wall:
/// s runs from -1 (inner face) to +1 (outer face).  The thickness of the wall changes the energy
/// release rate by (FR-21), unless the wall is treated as a thin sheet.  Range: shell parameter <=
/// 4.
/// Accuracy against finite elements with (FR-21), open faces under torque, nu = 0.3, r/t 20 to 60,
/// any angle: 1.1 % of the added compliance and 1.2 % of G up to a shell parameter of 3, 1.3 and
/// 2.7 % up to 4.  At nu = 0 and 0.45, the errors are 1.1 and 1.7 % up to a shell parameter of 1.4.
/// For pressed faces without friction, nu = 0.3, up to a shell parameter of 2.8: 1 % of the added
/// compliance and 2 % of G.
/// In the middle and at the outer face, K of the sheet is within 12 % of the whole local K (nu =
/// 0.45: 19 %).  Near 0 and 90 degrees, K_II at the inner face is too small by up to 28 % of the
/// largest K in the wall.  As a thin sheet, the added compliance is 9 % too large at a = 0.05 t,
/// and 5 % too small at a shell parameter of 4.
/// In a row of cracks, the flat sheet (CG-7) and the curvature between the cracks (CG-8) tell what
/// the neighbours change.
template <class Real>
struct BasicThroughCrackInTube {
  static constexpr std::size_t kLoads = 2;
  /// Largest shell parameter at which finite elements confirm the solution [-].
  static constexpr double kMaxShellParameter = 4.0;

  Real half_length{};              ///< a [m]; > 0
  Real mean_radius{};              ///< r [m]; > 0
  Real wall_thickness{};           ///< t [m]; > 0
  Real angle{};                    ///< beta [rad]
  Real stress_nonuniformity{1.0};  ///< K_u [-]
  Real poissons_ratio{0.3};        ///< nu [-]
  bool shell_correction = true;    ///< false: flat plate
  bool thin_sheet = true;          ///< plane stress at every size; false: (FR-21)
  bool open = true;                ///< false: the faces touch, K_I = 0 (FR-17)
  int count = 1;                   ///< equal cracks, evenly spaced round the axis (CG-7) [-]; >= 1
  /// Whether the neighbours lie on the line of the crack, as arcs on a circle do, whatever `angle`
  bool in_line = false;
  /// Stress on the plane of the crack that acts at a tip like the loads and other cracks together
  /// (CG-9); absent: that of the sound wall (FR-6)
  std::optional<BasicCrackPlaneStress<Real>> tip_stress = {};

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicThroughCrackInTube pressed() const {
    BasicThroughCrackInTube crack = *this;
    crack.open = false;
    return crack;
  }
  [[nodiscard]] Real size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {-1.0, 1.0}; }
  /// The crack at all sizes.
  [[nodiscard]] BasicThroughCrackFamily<Real> family() const;
  /// K of the sheet at one place, s in [-1, 1] [Pa*m^0.5 per unit of load].
  [[nodiscard]] UnitStressIntensity<2, Real> stress_intensity(const Real& a, double s) const;
  /// Swept area of two tips of each crack; its integral over s is 2 t times their number [m].
  [[nodiscard]] Real swept_area(const Real&, double) const { return count * wall_thickness; }
  /// Length of a crack over the pitch of the row, 2 a/p = a n/(pi r) [-].
  [[nodiscard]] Real row_share(const Real& a) const {
    return a * count / (std::numbers::pi * mean_radius);
  }
  /// Angle of the cracks from the normal of the row [rad].
  [[nodiscard]] Real row_angle() const { return in_line ? Real(std::numbers::pi / 2) : angle; }
  /// Factor of the wall's thickness on the energy release rate of the sheet [-]; eq. (FR-21).
  [[nodiscard]] Real wall_factor(const Real& a) const;

  /// Shell parameter squared, lambda^2 = sqrt(12(1-nu^2)) a^2/(r t) [-]; eq. (FR-8).
  [[nodiscard]] Real shell_parameter_squared(const Real& a) const {
    using std::sqrt;
    const Real& nu = poissons_ratio;
    return sqrt(12 * (1 - nu * nu)) * a * a / (mean_radius * wall_thickness);  // (FR-8)
  }
  /// Factor of the shell on the energy release rate of an open crack alone under torque, whether
  /// the correction is on or off [-]; eq. (FR-9).
  [[nodiscard]] Real shell_release(const Real& a) const;
};
using ThroughCrackInTube = BasicThroughCrackInTube<double>;

/// Factor of the wall's thickness at all sizes of a crack; eq. (FR-21).
template <class Real>
class BasicWallFactor {
 public:
  /// Computes what does not depend on the size of the crack.
  explicit BasicWallFactor(const BasicThroughCrackInTube<Real>& crack);

  /// The factor at a size, with the faces apart and pressed [-].
  [[nodiscard]] ApartAndPressed<Real> at(const Real& a) const;

 private:
  bool thin_sheet_;
  Real poissons_ratio_squared_;
  Real wall_thickness_;
  ApartAndPressed<Real> bulging_{};  ///< growth with the size [1/m]; 0 without the curvature
};

/// A through crack at all sizes; what does not depend on the size is computed once.
template <class Real>
class BasicThroughCrackFamily {
 public:
  /// Computes what does not depend on the size of the crack.
  explicit BasicThroughCrackFamily(const BasicThroughCrackInTube<Real>& crack);

  /// Factor of the wall's thickness on the energy release rate of the sheet [-]; eq. (FR-21).
  [[nodiscard]] Real wall_factor(const Real& a) const;
  /// The same with the faces apart and pressed, whatever the state of the crack.
  [[nodiscard]] ApartAndPressed<Real> wall_factors(const Real& a) const { return wall_.at(a); }

  /// K of the sheet through the wall [Pa*m^0.5 per unit of load]; (FR-7), (FR-9).
  [[nodiscard]] LinearStressIntensity<2, Real> linear_stress_intensity(const Real& a) const;
  /// The same with the faces apart and pressed; the factors of the shell are computed once.
  /// Only the family of a crack with its faces apart answers for both.
  [[nodiscard]] ApartAndPressed<LinearStressIntensity<2, Real>> in_both_states(const Real& a) const;

 private:
  [[nodiscard]] BasicShellFactors<Real> factors(const Real& a) const;
  [[nodiscard]] LinearStressIntensity<2, Real> intensity(const BasicShellFactors<Real>& factors,
                                                         const Real& a, bool open) const;

  BasicThroughCrackInTube<Real> crack_;
  BasicCrackPlaneStress<Real> stress_;
  BasicWallFactor<Real> wall_;
  Real shell_per_size_;                                  ///< shell parameter over a [1/m]
  std::optional<BasicShellFactorsAtAngle<Real>> shell_;  ///< nothing: flat plate
  std::optional<BasicShellRowAtAngle<Real>> row_;        ///< nothing: alone, pressed or flat
};

template <class Real>
BasicThroughCrackFamily<Real> BasicThroughCrackInTube<Real>::family() const {
  return BasicThroughCrackFamily<Real>(*this);
}

template <class Real>
UnitStressIntensity<2, Real> BasicThroughCrackInTube<Real>::stress_intensity(const Real& a,
                                                                             double s) const {
  return family().linear_stress_intensity(a).at(s);
}

extern template class BasicWallFactor<double>;
extern template class BasicWallFactor<CrackReal>;
extern template class BasicThroughCrackFamily<double>;
extern template class BasicThroughCrackFamily<CrackReal>;
extern template struct BasicThroughCrackInTube<double>;
extern template struct BasicThroughCrackInTube<CrackReal>;

}  // namespace strainwave::sif

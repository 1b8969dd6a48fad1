// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/model/input/flexspline.hpp"

namespace strainwave {

/// A round tube in uniform torsion.
template <class Real>
struct BasicTube {
  Real outer_diameter{};  ///< D [m]; > 0
  Real inner_diameter{};  ///< d [m]; >= 0, < D; 0 is a solid bar
  Real length{};          ///< L [m]; > 0
};
/// A tube in plain numbers.
using Tube = BasicTube<double>;

/// Torsional compliance of a tube [rad/(N*m)].
///
/// Implements theory manual eq. (ST-2), lambda = L/(G J), J = pi/32 (D^4 - d^4).  Exact for a round
/// section of any wall thickness; teeth, fillets and ends are left out.
///
/// @param tube           geometry
/// @param shear_modulus  G [Pa]; > 0
/// @throws InputError    if a length or G is not positive, or the bore is not smaller than the
///                       outer diameter
[[nodiscard]] double torsional_compliance(const Tube& tube, double shear_modulus);
/// The compliance of a tube with its derivatives [rad/(N*m)], in dual numbers.
[[nodiscard]] DualReal torsional_compliance(const BasicTube<DualReal>& tube,
                                            const DualReal& shear_modulus);

/// A flat annular plate of constant thickness, twisted in its own plane.
struct AnnularPlate {
  double outer_diameter = 0.0;  ///< [m]; > inner_diameter
  double inner_diameter = 0.0;  ///< [m]; > 0
  double thickness = 0.0;       ///< h [m]; > 0
};

/// Torsional compliance between the two rims of a plate [rad/(N*m)].
///
/// Implements theory manual eq. (ST-3), lambda = (1/(4 pi G h)) (1/r_i^2 - 1/r_o^2).  Exact for the
/// shear stress tau = T/(2 pi h r^2) and rims that stay round.
///
/// @throws InputError  on the same conditions as for the tube
[[nodiscard]] double torsional_compliance(const AnnularPlate& plate, double shear_modulus);

/// Torsional compliance of a diaphragm of any thickness law [rad/(N*m)].
///
/// Implements theory manual eq. (TC-13), lambda = (1/(2 pi G)) integral of dr/(r^3 h(r)), exactly
/// for a law that is linear between stations.
///
/// @throws InputError  on the same conditions as for the tube
[[nodiscard]] double torsional_compliance(const Diaphragm& diaphragm, double shear_modulus);
/// Torsional compliance of a diaphragm in the scalar of a lift, double or DualReal.
template <class Real>
[[nodiscard]] Real torsional_compliance(const Lift<Real>& lift, const Diaphragm& diaphragm,
                                        const Real& shear_modulus);

/// Compliance that a groove all round a diaphragm adds [rad/(N*m)]; eq. (TC-20).
///
/// Over the width of the groove, the thickness is reduced by its depth.
[[nodiscard]] double groove_compliance(const Diaphragm& diaphragm, const DiaphragmGroove& groove,
                                       double shear_modulus);
/// Compliance of a groove in the scalar of a lift, double or DualReal.
template <class Real>
[[nodiscard]] Real groove_compliance(const Lift<Real>& lift, const Diaphragm& diaphragm,
                                     const DiaphragmGroove& groove, const Real& shear_modulus);

/// Deflection of a thin ring under U equal and evenly spaced radial forces, at one of them and over
/// the force [m/N].
///
/// Implements theory manual eq. (ST-10), with theta = pi/U,
///
///     C = (R^3/(2EI)) [(theta + sin(theta)cos(theta))/(2 sin^2(theta)) - 1/theta].
///
/// The ring is inextensible and without shear deformation.  At thickness/R = 0.1 a real ring is
/// more compliant, by 1.6 % for two lobes and by 15 % for four.
///
/// @param wave_number        U [-]; >= 2
/// @param mean_radius        R [m]; > 0
/// @param bending_stiffness  E I of the section [N*m^2]; > 0
/// @throws InputError        if a parameter is out of range
[[nodiscard]] double ring_compliance(int wave_number, double mean_radius, double bending_stiffness);
/// The deflection over the force with its derivatives [m/N], in dual numbers.
[[nodiscard]] DualReal ring_compliance(int wave_number, const DualReal& mean_radius,
                                       const DualReal& bending_stiffness);

}  // namespace strainwave

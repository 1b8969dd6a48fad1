// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "strainwave/core/dual.hpp"

/// @file
/// Classical theory of laminates in plane stress, in the scalar `Real`: double, or DualReal for the
/// derivatives of everything.
///
/// The axes of a wall are 1 = x along the tube and 2 = y round it, the third index 6 is the shear.
/// y points against the hoop direction of the drive, so the angle of a ply is measured like the
/// angle of a crack (theory manual, chapter LA).

namespace strainwave {

/// A symmetric 3 x 3 matrix of in-plane stiffness or compliance; shear strain is gamma.
template <class Real = double>
struct InPlane {
  /// Entry of two indices: 1 and 2 are the axes, 6 is the shear [unit of the matrix].
  /// @{
  Real m11{};
  Real m12{};
  Real m22{};
  Real m16{};
  Real m26{};
  Real m66{};
  /// @}

  /// Adds `factor` times another matrix to this one.
  InPlane& add(const InPlane& other, const Real& factor) {
    m11 += other.m11 * factor;
    m12 += other.m12 * factor;
    m22 += other.m22 * factor;
    m16 += other.m16 * factor;
    m26 += other.m26 * factor;
    m66 += other.m66 * factor;
    return *this;
  }
  /// The matrix times a vector.
  [[nodiscard]] std::array<Real, 3> times(const std::array<Real, 3>& v) const {
    return {m11 * v[0] + m12 * v[1] + m16 * v[2], m12 * v[0] + m22 * v[1] + m26 * v[2],
            m16 * v[0] + m26 * v[1] + m66 * v[2]};
  }
};

/// Elastic constants of an orthotropic layer in its own axes.
template <class Real = double>
struct Lamina {
  Real E1{};    ///< along the fibres [Pa]; > 0
  Real E2{};    ///< across the fibres [Pa]; > 0
  Real G12{};   ///< [Pa]; > 0
  Real nu12{};  ///< strain across over strain along, under a stress along [-]; |nu12| < sqrt(E1/E2)
};

/// A layer in its place.
template <class Real = double>
struct LaminatePly {
  Lamina<Real> lamina{};  ///< elastic constants in the axes of its fibres
  Real angle{};           ///< of the fibres from the axis of the tube [rad]
  Real thickness{};       ///< [m]; > 0
};

/// Stiffness of a layer in its own axes [Pa]; theory manual eq. (LA-1).
template <class Real>
[[nodiscard]] InPlane<Real> reduced_stiffness(const Lamina<Real>& of) {
  const Real through = 1 - of.nu12 * of.nu12 * of.E2 / of.E1;
  InPlane<Real> Q;
  Q.m11 = of.E1 / through;
  Q.m12 = of.nu12 * of.E2 / through;
  Q.m22 = of.E2 / through;
  Q.m66 = of.G12;  // (LA-1)
  return Q;
}

/// A stiffness in axes from which its own axes are turned by `angle`; theory manual eq. (LA-2).
template <class Real>
[[nodiscard]] InPlane<Real> turned_stiffness(const InPlane<Real>& Q, const Real& angle) {
  using std::cos, std::sin;
  const Real c = cos(angle);
  const Real s = sin(angle);
  const Real c2 = c * c;
  const Real s2 = s * s;
  const Real cs = c * s;
  const Real both = Q.m12 + 2 * Q.m66;
  InPlane<Real> t;
  // (LA-2)
  t.m11 =
      c2 * c2 * Q.m11 + 2 * c2 * s2 * both + s2 * s2 * Q.m22 - 4 * cs * (c2 * Q.m16 + s2 * Q.m26);
  t.m22 =
      s2 * s2 * Q.m11 + 2 * c2 * s2 * both + c2 * c2 * Q.m22 + 4 * cs * (s2 * Q.m16 + c2 * Q.m26);
  t.m12 = c2 * s2 * (Q.m11 + Q.m22 - 4 * Q.m66) + (c2 * c2 + s2 * s2) * Q.m12 +
          2 * cs * (c2 - s2) * (Q.m16 - Q.m26);
  t.m66 = c2 * s2 * (Q.m11 + Q.m22 - 2 * Q.m12) + (c2 - s2) * (c2 - s2) * Q.m66 +
          2 * cs * (c2 - s2) * (Q.m16 - Q.m26);
  t.m16 = cs * (c2 * (Q.m11 - both) - s2 * (Q.m22 - both)) + c2 * (c2 - 3 * s2) * Q.m16 +
          s2 * (3 * c2 - s2) * Q.m26;
  t.m26 = cs * (s2 * (Q.m11 - both) - c2 * (Q.m22 - both)) + s2 * (3 * c2 - s2) * Q.m16 +
          c2 * (c2 - 3 * s2) * Q.m26;
  return t;
}

/// The inverse of a stiffness or of a compliance.
template <class Real>
[[nodiscard]] InPlane<Real> inverse(const InPlane<Real>& m) {
  InPlane<Real> c;
  c.m11 = m.m22 * m.m66 - m.m26 * m.m26;
  c.m12 = m.m16 * m.m26 - m.m12 * m.m66;
  c.m16 = m.m12 * m.m26 - m.m16 * m.m22;
  const Real determinant = m.m11 * c.m11 + m.m12 * c.m12 + m.m16 * c.m16;
  c.m22 = m.m11 * m.m66 - m.m16 * m.m16;
  c.m26 = m.m12 * m.m16 - m.m11 * m.m26;
  c.m66 = m.m11 * m.m22 - m.m12 * m.m12;
  InPlane<Real> result;
  return result.add(c, 1 / determinant);
}

/// Integrals of the stiffness of the plies through the wall, with the powers 0 to 2 of the distance
/// from the middle of the wall, outward.
template <class Real = double>
struct LaminateStiffness {
  InPlane<Real> A;   ///< [N/m]
  InPlane<Real> B;   ///< [N]
  InPlane<Real> D;   ///< [N*m]
  Real thickness{};  ///< h, of the wall [m]
};

/// Stiffness of a laminate; theory manual eq. (LA-3).
///
/// @param plies      from the inner face of the wall to the outer one
/// @param thickness  of the wall [m]; the plies share it in proportion to their own thicknesses
template <class Real>
[[nodiscard]] LaminateStiffness<Real> laminate_stiffness(std::span<const LaminatePly<Real>> plies,
                                                         const Real& thickness) {
  Real sum(0.0);
  for (const LaminatePly<Real>& ply : plies) sum += ply.thickness;
  LaminateStiffness<Real> total;
  total.thickness = thickness;
  const Real half = thickness / 2;
  Real below(0.0);  // thickness of the plies inside of this one
  for (const LaminatePly<Real>& ply : plies) {
    const InPlane<Real> Q = turned_stiffness(reduced_stiffness(ply.lamina), ply.angle);
    const Real z0 = below / sum * thickness - half;
    below += ply.thickness;
    const Real z1 = below / sum * thickness - half;
    const Real z0_2 = z0 * z0;
    const Real z1_2 = z1 * z1;
    total.A.add(Q, Real(z1 - z0));  // (LA-3)
    total.B.add(Q, Real((z1_2 - z0_2) / 2));
    total.D.add(Q, Real((z1_2 * z1 - z0_2 * z0) / 3));
  }
  return total;
}

/// How a thin round tube answers to a torque.
template <class Real = double>
struct TubeTorsion {
  Real stiffness{};     ///< G J, torque over twist per length [N*m^2]
  Real axial_strain{};  ///< of the tube per torque in the positive sense [1/(N*m)]
  Real hoop_strain{};   ///< of the middle of the wall per torque, likewise [1/(N*m)]
};

/// Torsion of a tube that is free to lengthen and to widen; theory manual eq. (LA-5).
///
/// The axial strain is constant through the wall, the hoop strain is w/r and the shear strain grows
/// with the radius; the radial stress is left out.  For isotropic plies this is exact.  Against
/// elasticity theory, eight walls are within 0.15 % at r/h = 40 and within 0.6 % at r/h = 10.
///
/// @param plies      from the inner face of the wall to the outer one
/// @param thickness  of the wall [m]; the plies share it in proportion to their own thicknesses
/// @param radius     of the middle of the wall [m]; > thickness/2
template <class Real>
[[nodiscard]] TubeTorsion<Real> tube_torsion(std::span<const LaminatePly<Real>> plies,
                                             const Real& thickness, const Real& radius) {
  using std::log;
  Real sum(0.0);
  for (const LaminatePly<Real>& ply : plies) sum += ply.thickness;
  Real k11(0.0), k12(0.0), k22(0.0), k16(0.0), k26(0.0), k66(0.0);
  const Real inner = radius - thickness / 2;
  Real below(0.0);  // thickness of the plies inside of this one
  for (const LaminatePly<Real>& ply : plies) {
    const InPlane<Real> Q = turned_stiffness(reduced_stiffness(ply.lamina), ply.angle);
    const Real r0 = inner + below / sum * thickness;
    below += ply.thickness;
    const Real r1 = inner + below / sum * thickness;
    const Real first = r1 - r0;  // integrals of 1, r, r^2, r^3 over the ply
    const Real second = first * (r1 + r0) / 2;
    const Real third = first * (r1 * r1 + r1 * r0 + r0 * r0) / 3;
    const Real fourth = second * (r1 * r1 + r0 * r0) / 2;
    k11 += Q.m11 * second;
    k12 += Q.m12 * first;
    k22 += Q.m22 * log(r1 / r0);
    k16 += Q.m16 * third;
    k26 += Q.m26 * second;
    k66 += Q.m66 * fourth;
  }
  const Real determinant = k11 * k22 - k12 * k12;
  // Per unit of twist against the hoop direction: axial strain, and radial displacement.
  const Real axial = (k12 * k26 - k22 * k16) / determinant;
  const Real widening = (k12 * k16 - k11 * k26) / determinant;
  const Real stiffness = 2 * std::numbers::pi * (k66 + k16 * axial + k26 * widening);  // (LA-5)
  return {.stiffness = stiffness,
          .axial_strain = -axial / stiffness,
          .hoop_strain = -widening / (radius * stiffness)};
}

/// Compliance of a wall under stresses in its plane, as a homogeneous sheet [1/Pa]; theory manual
/// eq. (LA-4), a = h/A.  The wall of a tube does not bend under them.
template <class Real>
[[nodiscard]] InPlane<Real> sheet_compliance(const LaminateStiffness<Real>& of) {
  InPlane<Real> a;
  return a.add(inverse(of.A), of.thickness);  // (LA-4)
}

/// The sum and the product of the two roots with positive imaginary part of
/// a11 s^4 - 2 a16 s^3 + (2 a12 + a66) s^2 - 2 a26 s + a22 = 0.
template <class Real = double>
struct CharacteristicRoots {
  Real sum_real{};           ///< real part of the sum [-]
  Real sum_imaginary{};      ///< imaginary part of the sum [-]; > 0
  Real product_real{};       ///< real part of the product [-]
  Real product_imaginary{};  ///< imaginary part of the product [-]
};

/// Sum and product of the roots; theory manual eq. (LA-7).  They need no root, so equal roots are
/// no special case.
/// @param a  compliance of a sheet; positive definite
template <class Real>
[[nodiscard]] CharacteristicRoots<Real> characteristic_roots(const InPlane<Real>& a) {
  using std::sqrt;
  const Real p = a.m16 / a.m11;
  const Real c2 = (2 * a.m12 + a.m66) / a.m11;
  const Real c1 = a.m26 / a.m11;
  const Real c0 = a.m22 / a.m11;
  const Real d = c2 - p * p;
  // X, the square of the sum's imaginary part, is the largest root of a cubic; above that root the
  // cubic is convex, so Newton's steps from above fall to it.
  const auto step = [&](const auto& X) {
    const auto left = d - X;
    const auto odd = 2 * c1 - p * left;
    const auto value = X * left * left + odd * odd - 4 * c0 * X;
    const auto slope = left * left - 2 * X * left + 2 * p * odd - 4 * c0;
    return value / slope;
  };
  const double scale = 4 * (magnitude(c2) + std::sqrt(magnitude(c0)) + magnitude(p) * magnitude(p) +
                            std::cbrt(magnitude(c1) * magnitude(c1)));
  double X = scale;
  constexpr int kMostSteps = 200;
  for (int i = 0; i < kMostSteps; ++i) {
    const double change = value_of(Real(step(Real(X))));
    if (!(change > 1e-16 * X)) break;
    X -= change;
  }
  const Real square = Real(X) - step(Real(X));  // this step gives the derivatives
  CharacteristicRoots<Real> roots;
  roots.sum_real = p;
  roots.sum_imaginary = sqrt(square);
  roots.product_real = (d - square) / 2;
  roots.product_imaginary = (c1 - p * roots.product_real) / roots.sum_imaginary;  // (LA-7)
  return roots;
}

/// The energy that a straight crack releases at a tip per area, as a form in K_I and K_II:
/// G = opening K_I^2 + 2 coupling K_I K_II + sliding K_II^2 [1/Pa].
template <class Real = double>
struct TipEnergy {
  Real opening{};   ///< G per K_I^2 [1/Pa]
  Real sliding{};   ///< G per K_II^2 [1/Pa]
  Real coupling{};  ///< half of G per K_I K_II [1/Pa]
};

/// Energy of a crack along the first axis of a sheet; theory manual eq. (LA-8).
/// @param a  compliance of the sheet in the axes of the crack [1/Pa]
template <class Real>
[[nodiscard]] TipEnergy<Real> tip_energy(const InPlane<Real>& a) {
  const CharacteristicRoots<Real> s = characteristic_roots(a);
  // Im(sum/product) = Im(sum conj(product))/|product|^2, and |product|^2 = a22/a11.
  const Real quotient = s.sum_imaginary * s.product_real - s.sum_real * s.product_imaginary;
  return {.opening = -a.m11 / 2 * quotient,
          .sliding = a.m11 / 2 * s.sum_imaginary,
          .coupling = a.m11 / 2 * s.product_imaginary};  // (LA-8)
}

/// Energy of a crack at an angle to the axis of the tube.
/// @param a      compliance of the sheet in the axes of the wall [1/Pa]
/// @param angle  of the crack, measured like that of a ply [rad]
template <class Real>
[[nodiscard]] TipEnergy<Real> tip_energy(const InPlane<Real>& a, const Real& angle) {
  const InPlane<Real> along = inverse(turned_stiffness(inverse(a), Real(-angle)));
  return tip_energy(along);
}

/// Mean over all directions of the shear stiffness A66 [N/m]; theory manual eq. (LA-10).
template <class Real>
[[nodiscard]] Real mean_shear_stiffness(const LaminateStiffness<Real>& of) {
  return (of.A.m11 + of.A.m22 - 2 * of.A.m12 + 4 * of.A.m66) / 8;  // (LA-10)
}

/// Largest difference of the stiffness in two directions at which a bottom counts as isotropic in
/// its plane, relative [-].  Angles of plies scatter by a degree or two.
inline constexpr double kNearlyIsotropic = 0.05;

/// Whether the wall is as stiff in its plane in every direction, to a relative tolerance.
[[nodiscard]] bool isotropic_in_plane(const LaminateStiffness<double>& of, double tolerance = 1e-9);

/// Stiffness of the wall against a change of its hoop curvature, where it does not bend along the
/// tube and carries no hoop force [N*m]; theory manual eq. (LA-6), D22 - B22^2/A22.
template <class Real>
[[nodiscard]] Real hoop_bending_stiffness(const LaminateStiffness<Real>& of) {
  return of.D.m22 - of.B.m22 * of.B.m22 / of.A.m22;  // (LA-6)
}

/// Whether forces in the plane of the wall neither shear nor bend it, to a relative tolerance: A16,
/// A26 and B vanish against A and A h/2.
[[nodiscard]] bool balanced_and_symmetric(const LaminateStiffness<double>& of, double tolerance);

/// A plate that bends equally in all directions.
template <class Real = double>
struct EvenPlate {
  Real bending{};         ///< D [N*m]
  Real poissons_ratio{};  ///< of its bending [-]
};

/// The mean over all directions of the bending stiffness of a flat wall; theory manual eq. (LA-17).
/// An upper bound of the mean resistance.
template <class Real>
[[nodiscard]] EvenPlate<Real> mean_plate(const LaminateStiffness<Real>& of) {
  const InPlane<Real>& D = of.D;
  const Real bends = (3 * (D.m11 + D.m22) + 2 * D.m12 + 4 * D.m66) / 8;
  const Real twists = (D.m11 + D.m22 - 2 * D.m12 + 4 * D.m66) / 8;
  return {.bending = bends, .poissons_ratio = 1 - 2 * twists / bends};  // (LA-17)
}

/// The plate whose compliance is the mean over all directions; theory manual eq. (LA-17).  A lower
/// bound of the mean resistance.
[[nodiscard]] EvenPlate<double> softest_plate(const LaminateStiffness<double>& of);

}  // namespace strainwave

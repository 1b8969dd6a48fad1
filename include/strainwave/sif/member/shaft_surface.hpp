// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/bar/tables.hpp"
#include "strainwave/sif/kassir_sih.hpp"
#include "strainwave/sif/newman_raju.hpp"

namespace strainwave::sif {

/// Least a/c of a front in a solid shaft [-].
inline constexpr double kNearlyStraight = 0.02;

/// Aspect ratio a/c of the ellipse of a surface crack in a solid shaft, from its half length along
/// the arc of the surface.
///
/// Implements theory manual eq. (FR-22).  A crack that is longer than with a straight front counts
/// as nearly straight.
/// @param depth        a [m]; > 0, <= radius
/// @param half_length  c along the arc [m]; >= depth
/// @param radius       of the shaft [m]; > 0
/// @return             a/c [-]; in [0.02, 1.06]; 0.02 beyond a quarter of the circumference
template <class Real>
[[nodiscard]] Real front_aspect_ratio(const Real& depth, const Real& half_length,
                                      const Real& radius) {
  using std::sin, std::sqrt;
  // A straight front ends at the arc r*arccos(1 - a/r), at most a quarter of the circumference.  A
  // longer arc must not come round to a small angle again.
  if (value_of(half_length) >= std::numbers::pi / 2 * value_of(radius)) return kNearlyStraight;
  const Real half = sin(half_length / radius / 2);
  const Real sunk = 2 * radius * half * half / depth;  // u_e/a
  if (!(value_of(sunk) < 1)) return kNearlyStraight;
  const Real aspect =
      depth * sqrt((1 - sunk) * (1 + sunk)) / (radius * sin(half_length / radius));  // (FR-22)
  return value_of(aspect) < kNearlyStraight ? Real(kNearlyStraight) : aspect;
}

/// Surface crack of elliptical front in a solid shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (SB-7), (SB-8), (FR-22).  The front runs from the surface, s = 0,
/// to the deepest point, s = 1.  The crack grows at constant aspect ratio.  a/d <= 0.5.
template <class Real>
class BasicShaftSurfaceSolid {
 public:
  static constexpr std::size_t kLoads = 2;
  static constexpr double kMaxDepthRatio = BasicOneSidedTable<Real>::kMaxDepthRatio;  ///< a/d

  /// Sizes of crack and shaft.
  struct Parameters {
    Real depth{};        ///< a [m]; > 0, <= half of the diameter
    Real half_length{};  ///< c along the arc of the surface [m]
    Real diameter{};     ///< d [m]
    bool open = true;    ///< false: the axial force presses the faces together, K_I = 0 (FR-17)
  };

  /// Interpolates the table at the aspect ratio of the crack.
  explicit BasicShaftSurfaceSolid(const Parameters& parameters)
      : p_(parameters),
        aspect_(front_aspect_ratio(p_.depth, p_.half_length, Real(p_.diameter / 2))),
        table_(aspect_) {}

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicShaftSurfaceSolid pressed() const {
    BasicShaftSurfaceSolid crack = *this;
    crack.p_.open = false;
    return crack;
  }
  /// A crack of another size in the same shaft.
  [[nodiscard]] BasicShaftSurfaceSolid with_size(const Real& depth, const Real& half_length) const {
    Parameters parameters = p_;
    parameters.depth = depth;
    parameters.half_length = half_length;
    return BasicShaftSurfaceSolid(parameters);
  }
  [[nodiscard]] Real size() const { return p_.depth; }
  /// Depth at which two polynomials of the factors meet [m]; (SB-7).
  [[nodiscard]] Real kink() const { return BasicOneSidedTable<Real>::kKink * p_.diameter; }
  /// a/c of the ellipse [-].
  [[nodiscard]] Real aspect_ratio() const { return aspect_; }
  [[nodiscard]] FrontRange front() const { return {0.0, 1.0}; }
  /// Swept area of both halves [m]; (SB-8).
  [[nodiscard]] Real swept_area(const Real& a, double) const {
    const Real radius = p_.diameter / 2;
    return radius * one_sided_swept(Real(a / radius), aspect_);
  }
  [[nodiscard]] UnitStressIntensity<kLoads, Real> stress_intensity(const Real& a, double s) const {
    using std::sqrt;
    const Real& d = p_.diameter;
    const BasicOneSidedFactors<Real> factor = table_.at(Real(a / d), 1 - s);
    const Real root = sqrt(std::numbers::pi * a);
    const Real shear = 16 / (std::numbers::pi * d * d * d) * root;
    UnitStressIntensity<kLoads, Real> k;
    if (p_.open) k.I[kAxial] = factor.tension * 4 / (std::numbers::pi * d * d) * root;  // (SB-7)
    k.II[kTorsion] = factor.sliding * shear;                                            // (SB-7)
    k.III[kTorsion] = factor.tearing * shear;                                           // (SB-7)
    return k;
  }

  /// Largest K_I in a turn of the shaft under a bending moment that is fixed in space, per unit of
  /// the moment [Pa*m^0.5/(N*m)]; (GR-34).
  [[nodiscard]] Real turning_bending(const Real& a, double s) const {
    using std::sin, std::sqrt;
    const Real& d = p_.diameter;
    const BasicOneSidedFactors<Real> factor = table_.at(Real(a / d), 1 - s);
    const BasicOneSidedFront<Real> ends = one_sided_front(Real(2 * a / d), aspect_);
    const Real aside = ends.half_chord * sin((1 - s) * ends.psi) / sin(ends.psi);
    // K of a stress proportional to y: 2/3 of the value of its own place, exact in a circular
    // crack.
    const Real beside = 2.0 / 3 * factor.tension * aside;
    return sqrt(factor.bending * factor.bending + beside * beside) * 32 /
           (std::numbers::pi * d * d * d) * sqrt(std::numbers::pi * a);  // (GR-34)
  }

 private:
  Parameters p_;
  Real aspect_;
  BasicOneSidedTable<Real> table_;
};
using ShaftSurfaceSolid = BasicShaftSurfaceSolid<double>;

/// Semi-elliptical crack in the outer surface of a hollow shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (SB-10), (SB-11), with the wall treated as a plate.  The front
/// runs from the surface, phi = 0, to the deepest point, phi = pi/2.  The crack grows at constant
/// aspect ratio.  a/t <= 0.6, a/c >= 0.4, 0.5 <= r_i/r_o <= 0.9.
template <class Real>
class BasicShaftSurfaceHollow {
 public:
  static constexpr std::size_t kLoads = 2;
  static constexpr double kMaxDepthRatio = 0.6;     ///< a/t
  static constexpr double kLeastAspectRatio = 0.4;  ///< a/c
  static constexpr double kLeastBore = 0.5;         ///< r_i/r_o
  static constexpr double kLargestBore = 0.9;       ///< r_i/r_o

  /// Sizes of crack and shaft.
  struct Parameters {
    Real depth{};              ///< a [m]; > 0, < wall
    Real half_length{};        ///< c along the arc of the surface [m]; >= depth
    Real outer_radius{};       ///< r_o [m]
    Real inner_radius{};       ///< r_i [m]; > 0, < outer_radius
    Real poissons_ratio{0.3};  ///< nu [-]; in (-1, 0.5)
    bool open = true;  ///< false: the axial force presses the faces together, K_I = 0 (FR-17)
  };

  /// Computes what depends on aspect ratio and Poisson's ratio alone.
  explicit BasicShaftSurfaceHollow(const Parameters& parameters)
      : p_(parameters),
        aspect_(p_.depth / p_.half_length),
        tension_(aspect_),
        shear_(aspect_, p_.poissons_ratio) {}

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicShaftSurfaceHollow pressed() const {
    BasicShaftSurfaceHollow crack = *this;
    crack.p_.open = false;
    return crack;
  }
  /// A crack of another size in the same shaft.
  [[nodiscard]] BasicShaftSurfaceHollow with_size(const Real& depth,
                                                  const Real& half_length) const {
    Parameters parameters = p_;
    parameters.depth = depth;
    parameters.half_length = half_length;
    return BasicShaftSurfaceHollow(parameters);
  }
  [[nodiscard]] Real size() const { return p_.depth; }
  /// a/c [-].
  [[nodiscard]] Real aspect_ratio() const { return aspect_; }
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// dA = c da dphi on each half of the front [m]; (FR-3).
  [[nodiscard]] Real swept_area(const Real& a, double) const { return 2 * a / aspect_; }
  [[nodiscard]] UnitStressIntensity<kLoads, Real> stress_intensity(const Real& a,
                                                                   double phi) const {
    using std::sqrt;
    const Real root = sqrt(std::numbers::pi * a);
    const Real tau = (p_.outer_radius - a / 2) / (2 * second_moment());
    UnitStressIntensity<kLoads, Real> k;
    if (p_.open) k.I[kAxial] = tension_.factor(Real(a / wall()), phi) / area() * root;  // (SB-10)
    k.II[kTorsion] = shear_.factor_II(phi) * tau * root;                                // (SB-11)
    k.III[kTorsion] = shear_.factor_III(phi) * tau * root;                              // (SB-11)
    return k;
  }

  /// Largest K_I in a turn of the shaft under a bending moment that is fixed in space, per unit of
  /// the moment [Pa*m^0.5/(N*m)]; (GR-34).
  [[nodiscard]] Real turning_bending(const Real& a, double phi) const {
    using std::sqrt;
    const Real alpha = a / wall();
    const Real middle = (p_.outer_radius + p_.inner_radius) / 2;
    // Without the cosine of (SB-10): in a turn each point comes to the middle of the tension side.
    return tension_.factor(alpha, phi) *
           (middle + tension_.bending_ratio(alpha, phi) * wall() / 2) / second_moment() *
           sqrt(std::numbers::pi * a);  // (GR-34)
  }

 private:
  [[nodiscard]] Real wall() const { return p_.outer_radius - p_.inner_radius; }
  [[nodiscard]] Real area() const {
    return std::numbers::pi * (p_.outer_radius + p_.inner_radius) * wall();
  }
  [[nodiscard]] Real second_moment() const {
    return area() * (p_.outer_radius * p_.outer_radius + p_.inner_radius * p_.inner_radius) /
           4;  // (SB-1)
  }

  Parameters p_;
  Real aspect_;
  BasicNewmanRaju<Real> tension_;
  BasicKassirSih<Real> shear_;
};
using ShaftSurfaceHollow = BasicShaftSurfaceHollow<double>;

}  // namespace strainwave::sif

// SPDX-License-Identifier: Apache-2.0
#include "flexspline_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/torsion/diaphragm_stress.hpp"

namespace strainwave {
namespace {

/// Slope psi, displacement W, moment M and force Q of the barrel at one place (TC-2).
template <class Real>
using WallState = std::array<Real, 4>;

/// The barrel as a beam of constant section that bends, shears and twists on a foundation.
template <class Real>
struct BarrelBeam {
  Real bending{};
  Real shear{};
  Real twist{};
  Real foundation{};

  /// The state at the end of a piece, by the power series of the differential equation.
  [[nodiscard]] WallState<Real> after(const Real& length, WallState<Real> y) const {
    // Roots times length are below 1.2 in pieces of R/n, so the rest of the series is below 1e-17.
    constexpr int kTerms = 20;
    WallState<Real> sum = y;
    const Real per_shear = length / (shear + twist);
    const Real per_bending = length / bending;
    const Real shears = length * shear;
    const Real supports = length * foundation;
    for (int j = 1; j <= kTerms; ++j) {
      const Real rise = (y[3] + shear * y[0]) * per_shear;  // W' times length
      y = {y[2] * per_bending, rise, shears * y[0] - shear * rise, supports * y[1]};
      for (std::size_t i = 0; i < 4; ++i) {
        y[i] *= 1.0 / j;
        sum[i] += y[i];
      }
    }
    return sum;
  }
};

/// Mean thickness over the radius; the thickness law of the plate matters little here.
template <class Real>
Real mean_thickness(const Lift<Real>& lift, const Diaphragm& diaphragm) {
  if (diaphragm.profile.empty()) return lift(diaphragm.thickness);
  constexpr int kPoints = 64;
  const Real inner = lift(diaphragm.inner_diameter);
  const Real width = lift(diaphragm.outer_diameter) - inner;
  Real h(0.0);
  for (int i = 0; i < kPoints; ++i)
    h += diaphragm_thickness(lift, diaphragm, Real((inner + width * (i + 0.5) / kPoints) / 2)) /
         kPoints;
  return h;
}

template <class Real>
Real plate_bending(const BasicElasticConstants<Real>& steel, const Real& thickness) {
  return steel.plane_strain_modulus() * thickness * thickness * thickness / 12;
}

}  // namespace

template <class Real>
BasicWallMode<Real> wall_mode(const BasicFlexsplineWall<Real>& wall, int n) {
  using std::numbers::pi;
  const Real& R = wall.radius;
  const Real& t = wall.barrel_thickness;
  const double n2 = n * n;
  const Real warp = R / n2;  // axial displacement of the edge per slope
  const Real hoop = (n2 - 1) * (n2 - 1) / (R * R * R * R);
  const Real turn = 2 * (1 - wall.steel.nu) * (n - 1.0 / n) * (n - 1.0 / n) / (R * R);
  const Real D = plate_bending(wall.steel, t);
  const BarrelBeam<Real> beam{.bending = wall.steel.E * t * warp * warp,
                              .shear = wall.steel.G * t / n2,
                              .twist = turn * D,
                              .foundation = hoop * D};
  const Real resists =
      wall.bottom ? Real(plate_edge_stiffness(*wall.bottom, n) * warp * warp) : Real(0.0);

  // Two states that the bottom allows, with the slope or the force there equal to 1.  At the end of
  // each piece they become the states of unit slope and of unit displacement.
  WallState<Real> sloped = {Real(1.0), Real(0.0), resists / (pi * R), Real(0.0)};
  WallState<Real> moved = {Real(0.0), Real(0.0), Real(0.0), Real(1.0)};
  std::array<Real, 2> at_bottom = {Real(1.0), Real(0.0)};  // slope there, of both states
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(value_of(wall.barrel_length) * n / value_of(R))));
  const Real piece = wall.barrel_length / pieces;
  std::array<WallState<Real>, 4> of_unit;
  for (std::size_t i = 0; i < 4; ++i) {
    WallState<Real> unit{};
    unit[i] = Real(1.0);
    of_unit[i] = beam.after(piece, unit);
  }
  for (int k = 0; k < pieces; ++k) {
    const auto across = [&](const WallState<Real>& y) {
      WallState<Real> sum{};
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum[j] += of_unit[i][j] * y[i];
      return sum;
    };
    const WallState<Real> a = across(sloped);
    const WallState<Real> b = across(moved);
    const Real det = a[0] * b[1] - a[1] * b[0];
    const auto of_slope = [&](const Real& of_a, const Real& of_b) {
      return Real((of_a * b[1] - of_b * a[1]) / det);
    };
    const auto of_displacement = [&](const Real& of_a, const Real& of_b) {
      return Real((of_b * a[0] - of_a * b[0]) / det);
    };
    sloped = {Real(1.0), Real(0.0), of_slope(a[2], b[2]), of_slope(a[3], b[3])};
    moved = {Real(0.0), Real(1.0), of_displacement(a[2], b[2]), of_displacement(a[3], b[3])};
    at_bottom = {of_slope(at_bottom[0], at_bottom[1]), of_displacement(at_bottom[0], at_bottom[1])};
  }

  // The rim stays straight along the axis.  It tilts about the middle of the face.
  const Real& width = wall.rim_width;
  const Real half = width / 2;
  const Real D_rim = plate_bending(wall.steel, wall.rim_thickness);
  const Real tilts = sloped[2] - 2 * half * sloped[3] + half * half * moved[3] +
                     D_rim * width * (turn + hoop * width * width / 12);
  const Real couples = sloped[3] - half * moved[3];
  BasicWallMode<Real> mode;
  mode.tilt = -couples / tilts;
  const Real slope = at_bottom[0] * mode.tilt + at_bottom[1] * (1 - half * mode.tilt);
  mode.mouth = warp * slope;
  mode.diaphragm = resists * slope * slope;
  mode.barrel = pi * R * (moved[3] + couples * mode.tilt) - mode.diaphragm;
  return mode;
}

template <class Real>
BasicFlexsplineWall<Real> flexspline_wall(const Flexspline& fs, const Lift<Real>& lift,
                                          const Real& radius,
                                          const BasicElasticConstants<Real>& steel, bool warping) {
  BasicFlexsplineWall<Real> wall{.radius = radius,
                                 .barrel_length = lift(fs.barrel->length),
                                 .barrel_thickness = lift(fs.barrel->wall_thickness),
                                 .rim_width = lift(fs.rim->length),
                                 .rim_thickness = lift(fs.rim->wall_thickness),
                                 .steel = steel,
                                 .bottom = {}};
  if (!warping) return wall;
  using std::pow, std::sqrt;
  const Diaphragm& diaphragm = *fs.diaphragm;
  const Real& t = wall.barrel_thickness;
  // A long tube whose edge stays round, against a moment all round its edge.
  const Real decay = pow(3 * (1 - steel.nu * steel.nu), 0.25) / sqrt(radius * t);
  wall.bottom = {
      .outer_radius = lift(diaphragm.outer_diameter) / 2,
      .inner_radius = lift(diaphragm.inner_diameter) / 2,
      .thickness = mean_thickness(lift, diaphragm),
      .youngs_modulus = steel.E,
      .poissons_ratio = steel.nu,
      .clamped = fs.shape == FlexsplineShape::hat ? ClampedEdge::outer : ClampedEdge::inner,
      .corner = 2 * plate_bending(steel, t) * decay};  // (TC-3)
  return wall;
}

double diaphragm_wave_stress(const Flexspline& flexspline, const ElasticConstants& steel,
                             double radius, int waves, double displacement) {
  const auto wall = flexspline_wall(flexspline, Lift<double>(), radius, steel, true);
  return steel.plane_strain_modulus() * wall.bottom->thickness / 2 *
         std::abs(clamped_edge_curvature(*wall.bottom, waves) * wall_mode(wall, waves).mouth) *
         displacement;  // (CV-2)
}

template BasicWallMode<double> wall_mode(const BasicFlexsplineWall<double>&, int);
template BasicWallMode<DualReal> wall_mode(const BasicFlexsplineWall<DualReal>&, int);
template BasicFlexsplineWall<double> flexspline_wall(const Flexspline&, const Lift<double>&,
                                                     const double&, const ElasticConstants&, bool);
template BasicFlexsplineWall<DualReal> flexspline_wall(const Flexspline&, const Lift<DualReal>&,
                                                       const DualReal&,
                                                       const BasicElasticConstants<DualReal>&,
                                                       bool);

}  // namespace strainwave

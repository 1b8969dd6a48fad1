// SPDX-License-Identifier: Apache-2.0
#include "flexspline_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/model/input/section_materials.hpp"
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

template <class Real>
BasicBarrelWall<Real> barrel_wall(const BasicElasticConstants<Real>& steel, const Real& t,
                                  const Real& radius) {
  using std::pow, std::sqrt;
  const Real D = plate_bending(steel, t);
  // A long tube whose edge stays round, against a moment all round its edge.
  const Real decay = pow(3 * (1 - steel.nu * steel.nu), 0.25) / sqrt(radius * t);
  return {.stretch = steel.E * t,
          .shear = steel.G * t,
          .hoop = D,
          .twist = 2 * (1 - steel.nu),
          .corner = 2 * D * decay};  // (TC-3)
}

template <class Real>
BasicBarrelWall<Real> barrel_wall(const LaminateStiffness<Real>& wall, const Real& radius) {
  using std::pow, std::sqrt;
  const InPlane<Real> a = inverse(wall.A);
  const Real hoop = hoop_bending_stiffness(wall);
  const Real decay = pow(1 / (4 * a.m22 * wall.D.m11), 0.25) / sqrt(radius);
  return {.stretch = 1 / a.m11,
          .shear = 1 / a.m66,
          .hoop = hoop,
          .twist = 4 * wall.D.m66 / hoop,
          .corner = 2 * wall.D.m11 * decay};  // (LA-16)
}

}  // namespace

template <class Real>
BasicWallMode<Real> wall_mode(const BasicFlexsplineWall<Real>& wall, int n) {
  using std::numbers::pi;
  const Real& R = wall.radius;
  const double n2 = n * n;
  const Real warp = R / n2;  // axial displacement of the edge per slope
  const Real hoop = (n2 - 1) * (n2 - 1) / (R * R * R * R);
  const auto turn = [&](const Real& twist) -> Real {
    return twist * (n - 1.0 / n) * (n - 1.0 / n) / (R * R);
  };
  const Real& D = wall.barrel.hoop;
  const BarrelBeam<Real> beam{.bending = wall.barrel.stretch * warp * warp,
                              .shear = wall.barrel.shear / n2,
                              .twist = turn(wall.barrel.twist) * D,
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
  const Real D_rim = plate_bending(wall.rim, wall.rim_thickness);
  const Real tilts = sloped[2] - 2 * half * sloped[3] + half * half * moved[3] +
                     D_rim * width * (turn(2 * (1 - wall.rim.nu)) + hoop * width * width / 12);
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
BasicWallMaterials<Real> wall_materials(const Flexspline& fs, const Lift<Real>& lift,
                                        const Real& radius,
                                        const BasicElasticConstants<Real>& steel) {
  return {.rim = steel,
          .barrel = barrel_wall(steel, Real(lift(fs.barrel->wall_thickness)), radius),
          .bottom_thickness = mean_thickness(lift, *fs.diaphragm),
          .bottom_modulus = steel.E,
          .bottom_poissons_ratio = steel.nu};
}

template <class Real>
BasicWallMaterials<Real> wall_materials(const GearSet& gear, const Lift<Real>& lift,
                                        const Real& radius) {
  const Flexspline& fs = *gear.flexspline;
  const auto material = [&](const auto& section) -> const Material& {
    return material_of(gear, material_name(fs, section), "flexspline.material");
  };
  BasicWallMaterials<Real> of;
  of.rim = elastic_constants(lift, rim_material(gear, fs));
  const Real thickness = lift(fs.barrel->wall_thickness);
  if (const auto wall = wall_laminate(lift, gear, material(*fs.barrel), thickness))
    of.barrel = barrel_wall(*wall, radius);
  else
    of.barrel = barrel_wall(elastic_constants(lift, material(*fs.barrel)), thickness, radius);
  of.bottom_thickness = mean_thickness(lift, *fs.diaphragm);
  const Real& h = of.bottom_thickness;
  if (const auto wall = wall_laminate(lift, gear, material(*fs.diaphragm), h)) {
    const EvenPlate<Real> plate = mean_plate(*wall);
    const Real& nu = plate.poissons_ratio;
    of.bottom_modulus = 12 * (1 - nu * nu) * plate.bending / (h * h * h);  // (LA-17)
    of.bottom_poissons_ratio = nu;
  } else {
    const BasicElasticConstants<Real> steel = elastic_constants(lift, material(*fs.diaphragm));
    of.bottom_modulus = steel.E;
    of.bottom_poissons_ratio = steel.nu;
  }
  return of;
}

template <class Real>
BasicFlexsplineWall<Real> flexspline_wall(const Flexspline& fs, const Lift<Real>& lift,
                                          const Real& radius, const BasicWallMaterials<Real>& of,
                                          bool warping) {
  BasicFlexsplineWall<Real> wall{.radius = radius,
                                 .barrel_length = lift(fs.barrel->length),
                                 .rim_width = lift(fs.rim->length),
                                 .rim_thickness = lift(fs.rim->wall_thickness),
                                 .rim = of.rim,
                                 .barrel = of.barrel,
                                 .bottom = {}};
  if (!warping) return wall;
  const Diaphragm& diaphragm = *fs.diaphragm;
  wall.bottom = {
      .outer_radius = lift(diaphragm.outer_diameter) / 2,
      .inner_radius = lift(diaphragm.inner_diameter) / 2,
      .thickness = of.bottom_thickness,
      .youngs_modulus = of.bottom_modulus,
      .poissons_ratio = of.bottom_poissons_ratio,
      .clamped = fs.shape == FlexsplineShape::hat ? ClampedEdge::outer : ClampedEdge::inner,
      .corner = of.barrel.corner};
  return wall;
}

double diaphragm_wave_stress(const Flexspline& flexspline, const ElasticConstants& steel,
                             double radius, int waves, double displacement) {
  const Lift<double> lift;
  const auto wall = flexspline_wall(flexspline, lift, radius,
                                    wall_materials(flexspline, lift, radius, steel), true);
  return steel.plane_strain_modulus() * wall.bottom->thickness / 2 *
         std::abs(clamped_edge_curvature(*wall.bottom, waves) * wall_mode(wall, waves).mouth) *
         displacement;  // (CV-2)
}

template BasicWallMode<double> wall_mode(const BasicFlexsplineWall<double>&, int);
template BasicWallMode<DualReal> wall_mode(const BasicFlexsplineWall<DualReal>&, int);
template BasicWallMaterials<double> wall_materials(const Flexspline&, const Lift<double>&,
                                                   const double&, const ElasticConstants&);
template BasicWallMaterials<double> wall_materials(const GearSet&, const Lift<double>&,
                                                   const double&);
template BasicWallMaterials<DualReal> wall_materials(const GearSet&, const Lift<DualReal>&,
                                                     const DualReal&);
template BasicFlexsplineWall<double> flexspline_wall(const Flexspline&, const Lift<double>&,
                                                     const double&,
                                                     const BasicWallMaterials<double>&, bool);
template BasicFlexsplineWall<DualReal> flexspline_wall(const Flexspline&, const Lift<DualReal>&,
                                                       const DualReal&,
                                                       const BasicWallMaterials<DualReal>&, bool);

}  // namespace strainwave

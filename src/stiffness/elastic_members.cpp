// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/elastic_members.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"

namespace strainwave {

using std::numbers::pi;

namespace {

template <class Real>
Real tube_compliance(const BasicTube<Real>& tube, const Real& shear_modulus) {
  const auto& [D, d, L] = tube;
  require(D > 0, "outer_diameter", value_of(D), "m", "outer_diameter > 0");
  require(d >= 0 && d < D, "inner_diameter", value_of(d), "m",
          "0 <= inner_diameter < outer_diameter");
  require(L > 0, "length", value_of(L), "m", "length > 0");
  require(shear_modulus > 0, "shear_modulus", value_of(shear_modulus), "Pa", "shear_modulus > 0");
  // The form D^4 - d^4 = (D^2 + d^2)(D + d)(D - d) is accurate for thin walls.
  const Real J = pi / 32 * (D * D + d * d) * (D + d) * (D - d);
  return L / (shear_modulus * J);  // (ST-2)
}

template <class Real>
Real plate_compliance(const Real& D, const Real& d, const Real& h, const Real& shear_modulus) {
  require(d > 0, "inner_diameter", value_of(d), "m", "inner_diameter > 0");
  require(D > d, "outer_diameter", value_of(D), "m", "outer_diameter > inner_diameter");
  require(h > 0, "thickness", value_of(h), "m", "thickness > 0");
  require(shear_modulus > 0, "shear_modulus", value_of(shear_modulus), "Pa", "shear_modulus > 0");
  const Real curvature = 4 * (D - d) * (D + d) / (d * d * D * D);  // 1/r_i^2 - 1/r_o^2
  return curvature / (4 * pi * shear_modulus * h);                 // (ST-3)
}

template <class Real>
Real free_ring_compliance(int wave_number, const Real& R, const Real& bending_stiffness) {
  require(wave_number >= 2, "wave_number", wave_number, "1", "wave_number >= 2");
  require(R > 0, "mean_radius", value_of(R), "m", "mean_radius > 0");
  require(bending_stiffness > 0, "bending_stiffness", value_of(bending_stiffness), "N*m^2",
          "bending_stiffness > 0");
  const double theta = pi / wave_number;
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  return R * R * R / (2 * bending_stiffness) *
         ((theta + s * c) / (2 * s * s) - 1 / theta);  // (ST-10)
}

}  // namespace

double torsional_compliance(const Tube& tube, double shear_modulus) {
  return tube_compliance(tube, shear_modulus);
}
DualReal torsional_compliance(const BasicTube<DualReal>& tube, const DualReal& shear_modulus) {
  return tube_compliance(tube, shear_modulus);
}

double torsional_compliance(const AnnularPlate& plate, double shear_modulus) {
  return plate_compliance(plate.outer_diameter, plate.inner_diameter, plate.thickness,
                          shear_modulus);
}

namespace {

/// Integral of 1/(r^3 (h(r) - depth)) over a diaphragm between two radii.
template <class Real>
Real twist_integral(const Lift<Real>& lift, const Diaphragm& diaphragm, const Real& depth,
                    const Real& inner, const Real& outer) {
  std::vector<Real> joints{inner};
  for (const DiaphragmStation& station : diaphragm.profile)
    if (station.radius > inner && station.radius < outer) joints.push_back(lift(station.radius));
  joints.push_back(outer);
  Real sum(0.0);
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
    sum += integrate(
               [&](const Real& r) -> Real {
                 return 1 / (r * r * r * (diaphragm_thickness(lift, diaphragm, r) - depth));
               },
               joints[i], joints[i + 1], {.relative_tolerance = 1e-12})
               .value;
  return sum;
}

}  // namespace

template <class Real>
Real torsional_compliance(const Lift<Real>& lift, const Diaphragm& diaphragm,
                          const Real& shear_modulus) {
  const Real D = lift(diaphragm.outer_diameter);
  const Real d = lift(diaphragm.inner_diameter);
  if (diaphragm.profile.empty())
    return plate_compliance<Real>(D, d, lift(diaphragm.thickness), shear_modulus);
  require(shear_modulus > 0, "shear_modulus", value_of(shear_modulus), "Pa", "shear_modulus > 0");
  return twist_integral<Real>(lift, diaphragm, 0.0, d / 2, D / 2) /
         (2 * pi * shear_modulus);  // (TC-13)
}

template <class Real>
Real groove_compliance(const Lift<Real>& lift, const Diaphragm& diaphragm,
                       const DiaphragmGroove& groove, const Real& shear_modulus) {
  const Real inner = lift(groove.radius) - lift(groove.width) / 2;
  const Real outer = lift(groove.radius) + lift(groove.width) / 2;
  return (twist_integral<Real>(lift, diaphragm, lift(groove.depth), inner, outer) -
          twist_integral<Real>(lift, diaphragm, 0.0, inner, outer)) /
         (2 * pi * shear_modulus);  // (TC-20)
}

template double torsional_compliance(const Lift<double>&, const Diaphragm&, const double&);
template DualReal torsional_compliance(const Lift<DualReal>&, const Diaphragm&, const DualReal&);
template double groove_compliance(const Lift<double>&, const Diaphragm&, const DiaphragmGroove&,
                                  const double&);
template DualReal groove_compliance(const Lift<DualReal>&, const Diaphragm&, const DiaphragmGroove&,
                                    const DualReal&);

double torsional_compliance(const Diaphragm& diaphragm, double shear_modulus) {
  return torsional_compliance(Lift<double>(), diaphragm, shear_modulus);
}

double groove_compliance(const Diaphragm& diaphragm, const DiaphragmGroove& groove,
                         double shear_modulus) {
  return groove_compliance(Lift<double>(), diaphragm, groove, shear_modulus);
}

double ring_compliance(int wave_number, double mean_radius, double bending_stiffness) {
  return free_ring_compliance(wave_number, mean_radius, bending_stiffness);
}
DualReal ring_compliance(int wave_number, const DualReal& mean_radius,
                         const DualReal& bending_stiffness) {
  return free_ring_compliance(wave_number, mean_radius, bending_stiffness);
}

}  // namespace strainwave

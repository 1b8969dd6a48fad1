// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/ring_states.hpp"

#include <cmath>
#include <numbers>

#include "assembled_drive_contents.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A ring with its internal forces per curvature and its hoop stresses per moment and force.
struct Section {
  double bending = 0.0;     // M per unit of curvature [N*m^2]
  double fibre = 0.0;       // stress of the outer surface per unit of curvature [N/m]
  double area = 0.0;        // [m^2]
  double hoop_share = 0.0;  // of the hoop force of a free ring [-]
};

Section outer_ring(const CoupledGeometry& g) {
  return {.bending = g.outer_bending,
          .fibre = g.ball_steel.plane_strain_modulus() * g.outer_thickness / 2,  // (TC-38)
          .area = g.outer_width * g.outer_thickness};
}

Section circular_spline(const GearSet& gear, const CoupledGeometry& g) {
  const CircularSpline& spline = *gear.circular_spline;
  const double t = (spline.outer_diameter - spline.inner_diameter) / 2;
  const double E =
      elastic_constants(material_of(gear, spline.material, "circular_spline.material")).E;
  return {.bending = g.spline_bending,
          .fibre = E * t / 2,  // (TC-39)
          .area = spline.width * t,
          .hoop_share = g.support};
}

}  // namespace

bool bends(const GearSet& gear, BendingRing ring) {
  return ring == BendingRing::outer_ring ||
         (gear.circular_spline && gear.circular_spline->support > 0);
}

std::vector<RingState> ring_states(const AssembledDrive& assembled, BendingRing ring, double torque,
                                   int positions) {
  require(positions > 0, "positions", positions, "1", "> 0");
  const AssembledDrive::Contents& contents = assembled.contents();
  if (!bends(contents.gear, ring))
    throw InputError("circular_spline.support",
                     "must be above 0 for the stress of the circular spline; a rigid circular "
                     "spline does not bend");
  const Equilibrium state = state_at(assembled, torque);
  const ElasticRings& rings = contents.drive.rings();
  const Eigen::VectorXd x = contents.drive.coefficients_of(state.force);
  const bool outer = ring == BendingRing::outer_ring;
  const Section section =
      outer ? outer_ring(contents.geometry) : circular_spline(contents.gear, contents.geometry);
  const ElasticRings::HoopForce hoop = rings.spline_hoop_force(state.force);
  std::vector<RingState> states;
  for (int i = 0; i < positions; ++i) {
    const double theta = 2 * pi * i / positions;
    const double kappa = outer ? rings.curvature(x, theta) : rings.spline_curvature(x, theta);
    const double force = outer ? 0.0 : section.hoop_share * hoop.at(theta);
    const double bending = section.fibre * kappa;
    const double membrane = force / section.area;
    states.push_back({.position = theta,
                      .bending_moment = section.bending * kappa,  // (TC-38), (TC-39)
                      .hoop_force = force,
                      .outside_stress = membrane + bending,
                      .inside_stress = membrane - bending});
  }
  return states;
}

}  // namespace strainwave

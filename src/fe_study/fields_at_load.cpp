// SPDX-License-Identifier: Apache-2.0
#include "fields_at_load.hpp"

#include <cmath>
#include <numbers>

namespace strainwave::fe_study {
namespace {

using fem::FieldPoint;
using std::numbers::pi;

/// Adds factor*b to a; the caller sets the energy densities.
void add(FieldPoint& a, const FieldPoint& b, double factor) {
  for (std::size_t i = 0; i < 3; ++i) a.displacement[i] += factor * b.displacement[i];
  for (std::size_t i = 0; i < 6; ++i) a.stress[i] += factor * b.stress[i];
}

void scale(FieldPoint& point, double factor) {
  for (double& u : point.displacement) u *= factor;
  for (double& s : point.stress) s *= factor;
}

}  // namespace

fem::SampledFields fields_at_load(const ShaftCrackRun& run, const GearSet& gear) {
  const double torque = gear.load.torque;
  const double force = gear.load.axial_force;
  const double outer = run.section.outer_diameter / 2;
  const double inner = run.section.inner_diameter / 2;
  const double polar = pi / 2 * (std::pow(outer, 4) - std::pow(inner, 4));
  const double area = pi * (outer * outer - inner * inner);
  const double E = run.elasticity.youngs_modulus;
  const double nu = run.elasticity.poissons_ratio;
  const double mu = run.elasticity.shear_modulus();
  fem::SampledFields fields = run.result.torsion.fields;
  const fem::SampledFields& tension = run.result.tension.fields;
  fields.without_crack = true;
  for (std::size_t c = 0; c < fields.cells.size(); ++c)
    for (std::size_t i = 0; i < fields.cells[c].points.size(); ++i) {
      FieldPoint& point = fields.cells[c].points[i];
      const double r = point.place[0];
      const double stress = force / area;
      const double shear = torque * r / polar;
      // Torsion and tension cause different components of stress, so their energies add.
      double energy = torque * torque * point.energy_density;
      scale(point, torque);
      if (force >= 0) {
        const FieldPoint& pulled = tension.cells[c].points[i];
        add(point, pulled, force);
        energy += force * force * pulled.energy_density;
      } else {  // a closed crack acts like no crack
        point.stress[2] += stress;
        point.displacement[0] -= nu * stress / E * r;
        point.displacement[2] += stress / E * point.place[2];
        energy += stress * stress / (2 * E);
      }
      point.energy_density = energy;
      point.energy_density_without_crack =
          shear * shear / (2 * mu) + stress * stress / (2 * E);  // (FE-38)
    }
  return fields;
}

fem::SampledFields fields_at_load(const gear_fem::CupResult& cup, const GearSet& gear) {
  const double torque = gear.load.torque;
  fem::SampledFields fields = cup.solution.fields;
  for (fem::FieldCell& cell : fields.cells)
    for (FieldPoint& point : cell.points) {
      scale(point, torque);
      point.energy_density *= torque * torque;
    }
  return fields;
}

fem::CrackFront front_at_load(const ShaftCrackRun& run, const GearSet& gear) {
  constexpr int kSides = 72;
  const gear_fem::ShaftCrack& crack = *run.section.crack;
  const double radius = crack.surface == gear_fem::ShaftCrack::Surface::outer
                            ? run.section.outer_diameter / 2 - crack.depth
                            : run.section.inner_diameter / 2 + crack.depth;
  const double torque = gear.load.torque;
  const double pull = std::max(0.0, gear.load.axial_force);
  const fem::TipResult& twisted = run.result.torsion.tip;
  const fem::TipResult& pulled = run.result.tension.tip;
  fem::CrackFront front;
  front.length = 2 * pi * radius;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2 * pi * i / kSides;
    front.stations.push_back(
        {.position = static_cast<double>(i) / kSides,
         .place = {radius * std::cos(angle), radius * std::sin(angle), crack.position},
         .energy_release_rate = torque * torque * twisted.energy_release_rate +
                                pull * pull * pulled.energy_release_rate,
         .K_I = pull * pulled.K_I,
         .K_II = pull * pulled.K_II,
         .K_III = torque * twisted.K_III});
  }
  return front;
}

}  // namespace strainwave::fe_study

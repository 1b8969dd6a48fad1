// SPDX-License-Identifier: Apache-2.0
#include "strainwave/article/repaired.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "member.hpp"
#include "strainwave/article/as_printed.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/model/input/section_materials.hpp"

// If a printed equation is right, the function of as_printed.hpp is called in SI units, because a
// right equation is valid in every system of units.

namespace strainwave {
namespace article {
namespace {

using std::numbers::pi;

// --- Wave generator -------------------------------------------------------------------------

double lobe_force(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  return radial_load(wg.load_factor, wg.force_transmission_coefficient, std::abs(gear.load.torque),
                     gear.drive.pitch_diameter);  // (AR-1)
}

double lobe_stiffness(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  if (wg.radial_stiffness) return *wg.radial_stiffness;
  const LobeDisplacements& d = *wg.displacements;
  return sound_radial_stiffness(lobe_force(gear), d.bearing, d.cam, d.shaft);
}

CrackedRace race_of(const GearSet& gear, const RaceSurfaceCrack& crack) {
  const WaveGenerator& wg = *gear.wave_generator;
  const auto& [a_contact, b_contact] = *wg.contact_semi_axes;
  return {.depth = crack.depth,
          .ring_thickness = *wg.inner_ring_thickness,
          .flaw_parameter = 1 + 1.464 * std::pow(crack.aspect_ratio, 1.65),
          .contact_factor = *crack.contact_factor,
          .contact_semi_major = a_contact,
          .contact_semi_minor = b_contact,
          .youngs_modulus =
              material_of(gear, wg.material, "wave_generator.material").youngs_modulus.value()};
}

/// Radial compliance that the race crack adds [m/N],
/// Delta C = 0.217 t_i (beta a/(a' b'))^2/(E Q).
double race_crack_compliance(const CrackedRace& race) {
  const double stress_per_pressure =
      race.contact_factor * race.depth / (race.contact_semi_major * race.contact_semi_minor);
  return 0.217 * race.ring_thickness * stress_per_pressure * stress_per_pressure /
         (race.youngs_modulus * race.flaw_parameter);  // (AR-2)
}

StressIntensities race_stress_intensities(const GearSet& gear, const CrackedRace& race) {
  const double sigma_max =
      contact_pressure(lobe_force(gear), race.contact_semi_major, race.contact_semi_minor);
  const double sigma = race_stress(race.contact_factor, sigma_max);
  return stress_intensities(race_stress_intensity(sigma, race.depth, race.flaw_parameter), 0.0,
                            0.0);
}

Member repaired_wave_generator(const GearSet& gear, const RaceSurfaceCrack* crack) {
  if (!gear.wave_generator) return absent_member("wave_generator");
  const WaveGenerator& wg = *gear.wave_generator;
  Member member;
  if (wg.conversion != Conversion::cam)
    member.notes.push_back(not_read("wave_generator.conversion", "AR-4",
                                    "the article turns the cam back over its mean slope"));
  if (wg.displacements || crack != nullptr) member.equations = {"AR-1"};

  const Cam cam{.force_transmission_coefficient = wg.force_transmission_coefficient,
                .pitch_diameter = gear.drive.pitch_diameter,
                .wave_number = static_cast<double>(gear.drive.wave_number),
                .radial_displacement = gear.drive.radial_displacement,
                .ratio = gear.drive.ratio};
  const double K_G0 = lobe_stiffness(gear);
  member.sound = wave_generator_compliance(cam, K_G0);  // (AR-4)
  if (crack != nullptr) {
    const CrackedRace race = race_of(gear, *crack);
    const double Delta_C = race_crack_compliance(race);
    // (AR-3) 1/K_G = 1/K_G0 + Delta C, so the conversion, linear in 1/K_G, splits into two terms.
    member.added = member.sound * K_G0 * Delta_C;
    member.crack = crack_report("wave_generator.crack[0]", RaceSurfaceCrack::kKind, member.added,
                                race_stress_intensities(gear, race), false);
    for (const char* const tag : {"AR-2", "AR-3"}) member.equations.emplace_back(tag);
  }
  member.equations.emplace_back("AR-4");
  member.cracked = member.sound + member.added;
  return member;
}

// --- Flexspline -----------------------------------------------------------------------------

Member repaired_flexspline(const GearSet& gear, const WallThroughCrack* crack) {
  if (!gear.flexspline) return absent_member("flexspline");
  const Flexspline& fs = *gear.flexspline;
  const Material& material = only_material(gear, fs);
  Member member;
  member.equations = {"AR-6"};
  const double k = fs.shape_factor.value_or(fs.shape == FlexsplineShape::cup ? 0.83 : 1.0);
  member.sound =
      sound_flexspline_compliance({.shape_coefficient = k,
                                   .structure_coefficient = 1.0,
                                   .length = fs.tube_length(),
                                   .pitch_diameter = gear.drive.pitch_diameter,
                                   .wall_thickness = fs.ring_thickness(),
                                   .shear_modulus = elastic_constants(material).G});  // (AR-6)
  if (crack != nullptr) {
    if (crack->shell_correction)
      member.notes.push_back(not_read("flexspline.crack[0].shell_correction", "AR-5",
                                      "the article takes the wall as a flat plate"));
    const double r_m = (gear.drive.pitch_diameter - fs.ring_thickness()) / 2;
    member.added =
        wall_crack_compliance({.half_length = crack->half_length,
                               .mean_radius = r_m,
                               .wall_thickness = fs.ring_thickness(),
                               .stress_nonuniformity = fs.stress_nonuniformity,
                               .dynamic_load = fs.dynamic_load,
                               .youngs_modulus = material.youngs_modulus.value()});  // (AR-5)
    const double tau = wall_shear(std::abs(gear.load.torque), r_m, fs.ring_thickness());
    const auto [K_I, K_II] = wall_stress_intensity(tau, crack->angle, crack->half_length);
    member.crack = crack_report("flexspline.crack[0]", WallThroughCrack::kKind, member.added,
                                stress_intensities(K_I, K_II, 0.0), true);
    member.equations.emplace_back("AR-5");
  }
  member.cracked = member.sound + member.added;
  return member;
}

// --- Output shaft ---------------------------------------------------------------------------

/// Diameter of the solid shaft with the polar moment of the hollow shaft [m].
double equal_torsion_diameter(const OutputShaft& shaft) {
  const double D = shaft.outer_diameter;
  const double d = shaft.inner_diameter;
  return std::sqrt(std::sqrt((D * D + d * d) * (D + d) * (D - d)));  // (AR-7)
}

/// K_I per axial force [1/m^1.5], handbook polynomial.  @param d  diameter of the solid shaft [m]
double axial_stress_intensity(double d, double a) {
  const double d_e = d - 2 * a;
  const double x = d_e / d;
  const double M_p =
      std::sqrt(x) / 2 * (1 + x * (1.0 / 2 + x * (3.0 / 8 + x * (-0.363 + x * 0.731))));
  return M_p * 4 / (pi * d_e * d_e) * std::sqrt(pi * a);
}

/// K_III per torque [1/m^2.5], handbook polynomial.
double torsion_stress_intensity(double d, double a) {
  const double d_e = d - 2 * a;
  const double x = d_e / d;
  const double series =
      1 + x * (1.0 / 2 + x * (3.0 / 8 + x * (5.0 / 16 + x * (35.0 / 128 + x * 0.208))));
  const double M_M = 3 * std::sqrt(x) / 8 * series;
  return M_M * 16 / (pi * d_e * d_e * d_e) * std::sqrt(pi * a);
}

/// Delta lambda_so = 1/mu int_0^a (K_III/T)^2 dA, dA = pi d_e da [rad/(N*m)].
double annular_crack_compliance(double d, double depth, double shear_modulus) {
  const auto integrand = [&](double a) {
    const double k_III = torsion_stress_intensity(d, a);
    return k_III * k_III / shear_modulus * pi * (d - 2 * a);
  };
  const auto integral = integrate(integrand, 0.0, depth, {.relative_tolerance = 1e-12});  // (AR-8)
  if (!integral.converged)
    throw SolverError(
        fmt::format("the crack integral (AR-8) did not converge: error {:.2g} of {:.2g}; check "
                    "whether the crack goes almost through the shaft",
                    integral.error, integral.value));
  return integral.value;
}

Member repaired_output_shaft(const GearSet& gear, const AnnularCrack* crack) {
  if (!gear.output_shaft) return absent_member("output_shaft");
  const OutputShaft& shaft = *gear.output_shaft;
  const Material& material = material_of(gear, shaft.material, "output_shaft.material");
  const double mu = elastic_constants(material).G;
  const double d = equal_torsion_diameter(shaft);
  Member member;
  member.equations = {"AR-7", "AR-9"};
  member.sound = sound_shaft_compliance(shaft.length, d, mu);  // (AR-9)
  if (crack != nullptr) {
    if (shaft.solid() && crack->solution != AnnularSolution::tada)
      member.notes.push_back(not_read("output_shaft.crack[0].solution", "AR-8",
                                      "this method takes the handbook's polynomial"));
    const double a = crack->depth;
    member.added = annular_crack_compliance(d, a, mu);
    member.crack = crack_report(
        "output_shaft.crack[0]", AnnularCrack::kKind, member.added,
        stress_intensities(axial_stress_intensity(d, a) * gear.load.axial_force, 0.0,
                           torsion_stress_intensity(d, a) * std::abs(gear.load.torque)),
        true);
    member.equations.emplace_back("AR-8");
  }
  member.cracked = member.sound + member.added;
  return member;
}

}  // namespace
}  // namespace article

StiffnessResult torsional_stiffness_repaired(const GearSet& gear) {
  check(gear);
  const article::Cracks cracks = article::treatable_cracks(gear, Method::repaired);
  return article::drive_result(gear, Method::repaired,
                               article::repaired_wave_generator(gear, cracks.race),
                               article::repaired_flexspline(gear, cracks.wall),
                               article::repaired_output_shaft(gear, cracks.shaft));
}

}  // namespace strainwave

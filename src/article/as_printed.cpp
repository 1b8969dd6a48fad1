// SPDX-License-Identifier: Apache-2.0
#include "strainwave/article/as_printed.hpp"

#include <cmath>
#include <numbers>

#include "member.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace article {

using std::numbers::pi;

// --- Fracture mechanics ---------------------------------------------------------------------

double energy_release_rate(double K_I, double K_II, double K_III, double generalised_modulus,
                           double poissons_ratio) {
  const double E = generalised_modulus;
  return K_I * K_I / E + K_II * K_II / E + K_III * K_III / (E * (1 - poissons_ratio));  // (AP-19)
}

double added_displacement(const ReleaseRateOverArea& release_rate, double area, double load) {
  return integrate([&](double A) { return release_rate(A) / load; }, 0.0, area).value;  // (AP-20)
}

double added_compliance(const ReleaseRateOverArea& release_rate, double area, double load) {
  const auto integrand = [&](double A) { return 2 * release_rate(A) / (load * load); };
  return integrate(integrand, 0.0, area).value;  // (AP-21)
}

// --- Wave generator -------------------------------------------------------------------------

double race_stress_intensity(double stress, double depth, double flaw_parameter) {
  return 1.95 * stress * std::sqrt(depth / flaw_parameter);  // (AP-1)
}

double race_stress(double contact_factor, double contact_pressure) {
  return contact_factor * contact_pressure / 2;  // (AP-2)
}

double contact_pressure(double radial_load, double semi_major, double semi_minor) {
  return 3 * radial_load / (2 * pi * semi_major * semi_minor);  // (AP-3)
}

double radial_load(double load_factor, double force_transmission_coefficient, double torque,
                   double pitch_diameter) {
  return load_factor * force_transmission_coefficient * torque / pitch_diameter;  // (AP-4)
}

namespace {

/// 0.217 t_i (beta a/(a' b'))^2, the common factor of eqs. (AP-5) and (AP-6).
double cracked_length(const CrackedRace& race) {
  const double ratio =
      race.contact_factor * race.depth / (race.contact_semi_major * race.contact_semi_minor);
  return 0.217 * race.ring_thickness * ratio * ratio;
}

}  // namespace

double race_crack_displacement(const CrackedRace& race, double radial_load) {
  const double E = race.youngs_modulus;
  return cracked_length(race) * radial_load * radial_load / (E * race.flaw_parameter);  // (AP-5)
}

double race_crack_stiffness(const CrackedRace& race, double radial_load) {
  const double E = race.youngs_modulus;
  return E * race.flaw_parameter / (radial_load * cracked_length(race));  // (AP-6)
}

double sound_radial_stiffness(double radial_load, double bearing, double cam, double shaft) {
  return radial_load / (bearing + cam + shaft);  // (AP-7)
}

double radial_stiffness(double sound, double of_crack) { return sound - of_crack; }  // (AP-8)

double wave_generator_compliance(const Cam& cam, double radial_stiffness) {
  const double k_r = cam.force_transmission_coefficient;
  const double U = cam.wave_number;
  return k_r / radial_stiffness * pi /
         (2 * cam.pitch_diameter * U * cam.radial_displacement * cam.ratio);  // (AP-9)
}

// --- Flexspline -----------------------------------------------------------------------------

double wall_shear(double torque, double mean_radius, double wall_thickness) {
  return torque / (2 * pi * mean_radius * mean_radius * wall_thickness);  // (AP-10)
}

WallStressIntensity wall_stress_intensity(double shear, double angle, double half_length) {
  const double root = std::sqrt(pi * half_length);
  return {.K_I = shear * std::sin(2 * angle) * root,    // (AP-10)
          .K_II = shear * std::cos(2 * angle) * root};  // (AP-10)
}

double wall_crack_compliance(const CrackedWall& wall) {
  const double a = wall.half_length;
  return wall.stress_nonuniformity * wall.dynamic_load * a * a /
         (2 * pi * wall.youngs_modulus * std::pow(wall.mean_radius, 4) *
          wall.wall_thickness);  // (AP-11)
}

double sound_flexspline_compliance(const SoundCup& cup) {
  const double d_1 = cup.pitch_diameter;
  const double c_L = cup.length / d_1;
  const double c_delta = cup.wall_thickness / d_1;
  return cup.shape_coefficient * cup.structure_coefficient * c_L /
         (0.1 * cup.shear_modulus * (1 - std::pow(1 - 2 * c_delta, 4)) *
          std::pow(d_1, 3));  // (AP-12)
}

// --- Output shaft ---------------------------------------------------------------------------

namespace {

double net_diameter(const CrackedShaft& shaft) { return shaft.diameter - 2 * shaft.depth; }

}  // namespace

ShaftStressIntensity shaft_stress_intensity(const CrackedShaft& shaft, double axial_force,
                                            double torque) {
  const double d_e = net_diameter(shaft);
  const double root = std::sqrt(pi * shaft.depth);
  return {.K_I = shaft.M_p * 4 * axial_force / (pi * d_e * d_e) * root,       // (AP-13)
          .K_III = shaft.M_M * 16 * torque / (pi * d_e * d_e * d_e) * root};  // (AP-13)
}

double axial_coefficient(double net_diameter_ratio) {
  const double x = net_diameter_ratio;
  return std::sqrt(x) * (0.5 + x * (0.25 + x * (0.188 + x * (0.182 + x * 0.166))));  // (AP-14)
}

double torsion_coefficient(double net_diameter_ratio) {
  const double x = net_diameter_ratio;
  return std::sqrt(x) *
         (0.376 + x * (0.188 + x * (0.141 + x * (0.117 + x * (0.102 + x * 0.078)))));  // (AP-15)
}

ShaftCrackCompliance shaft_crack_compliance(const CrackedShaft& shaft) {
  const double a = shaft.depth;
  const double d_e = net_diameter(shaft);
  const double M_p = shaft.M_p;
  const double M_M = shaft.M_M;
  const double E = shaft.youngs_modulus;
  const double mu = shaft.shear_modulus;
  return {.axial_term = 16 * M_p * M_p * a * a / (pi * E * std::pow(d_e, 4)),          // (AP-16)
          .torsion_term = 512 * M_M * M_M * a * a * a / (3 * mu * std::pow(d_e, 6))};  // (AP-16)
}

double sound_shaft_compliance(double length, double diameter, double shear_modulus) {
  return length / (0.1 * shear_modulus * std::pow(diameter, 4));  // (AP-17)
}

// --- Drive ----------------------------------------------------------------------------------

double drive_stiffness(double wave_generator, double flexspline, double output_shaft) {
  return 1 / (wave_generator + flexspline + output_shaft);  // (AP-18)
}

// --- The method -----------------------------------------------------------------------------

namespace {

// The article's units.  Divide an SI value by a unit to get the article's number; multiply to get
// back.
using units::mm;
using units::MPa;
using units::N;
constexpr double kTorque = N * mm;
constexpr double kRadialStiffness = N / mm;
constexpr double kCompliance = 1 / (N * mm);
constexpr double kRootMm = 0.031622776601683793;  // sqrt(1e-3)
constexpr double kStressIntensity = MPa * kRootMm;

/// The numbers of the section [article]; empty without the section.
const ArticleOverrides& overrides(const GearSet& gear) {
  static const ArticleOverrides kNone;
  return gear.article ? *gear.article : kNone;
}

/// Radial load F_r in N.
double radial_load_of(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  return overrides(gear).radial_load.value_or(
      radial_load(wg.load_factor, wg.force_transmission_coefficient,
                  std::abs(gear.load.torque) / kTorque, gear.drive.pitch_diameter / mm));
}

/// Sound radial stiffness K_G0 in N/mm.
double sound_radial_stiffness_of(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  if (wg.radial_stiffness) return *wg.radial_stiffness / kRadialStiffness;
  const LobeDisplacements& d = *wg.displacements;
  return sound_radial_stiffness(radial_load_of(gear), d.bearing / mm, d.cam / mm, d.shaft / mm);
}

CrackedRace cracked_race(const GearSet& gear, const RaceSurfaceCrack& crack) {
  const WaveGenerator& wg = *gear.wave_generator;
  const auto& [a_contact, b_contact] = *wg.contact_semi_axes;
  const Material& material = material_of(gear, wg.material, "wave_generator.material");
  return {.depth = crack.depth / mm,
          .ring_thickness = *wg.inner_ring_thickness / mm,
          .flaw_parameter = overrides(gear).flaw_parameter.value_or(
              1 + 1.464 * std::pow(crack.aspect_ratio, 1.65)),
          .contact_factor = *crack.contact_factor,
          .contact_semi_major = a_contact / mm,
          .contact_semi_minor = b_contact / mm,
          .youngs_modulus = material.youngs_modulus.value() / MPa};
}

Cam cam(const GearSet& gear) {
  return {.force_transmission_coefficient = gear.wave_generator->force_transmission_coefficient,
          .pitch_diameter = gear.drive.pitch_diameter / mm,
          .wave_number = static_cast<double>(gear.drive.wave_number),
          .radial_displacement = gear.drive.radial_displacement / mm,
          .ratio = gear.drive.ratio};
}

Member wave_generator(const GearSet& gear, const RaceSurfaceCrack* crack) {
  if (!gear.wave_generator) return absent_member("wave_generator");
  Member member;
  if (gear.wave_generator->conversion != Conversion::cam)
    member.notes.push_back(not_read("wave_generator.conversion", "AP-9",
                                    "the article turns the cam back over its mean slope"));
  const bool uses_radial_load = gear.wave_generator->displacements || crack != nullptr;
  if (uses_radial_load && !overrides(gear).radial_load) member.equations.emplace_back("AP-4");
  if (gear.wave_generator->displacements) member.equations.emplace_back("AP-7");
  const double K_G0 = sound_radial_stiffness_of(gear);
  member.sound = wave_generator_compliance(cam(gear), K_G0) * kCompliance;
  member.cracked = member.sound;
  if (crack == nullptr) {
    member.equations.emplace_back("AP-9");
    return member;
  }
  const CrackedRace race = cracked_race(gear, *crack);
  const double F_r = radial_load_of(gear);
  const double Delta_K_G = race_crack_stiffness(race, F_r);
  const double K_G = radial_stiffness(K_G0, Delta_K_G);
  member.cracked = wave_generator_compliance(cam(gear), K_G) * kCompliance;
  // 1/K_G - 1/K_G0, written without cancellation
  member.added = member.cracked * (Delta_K_G / K_G0);

  const double sigma_max = contact_pressure(F_r, race.contact_semi_major, race.contact_semi_minor);
  const double K_I = race_stress_intensity(race_stress(race.contact_factor, sigma_max), race.depth,
                                           race.flaw_parameter);
  member.crack = crack_report("wave_generator.crack[0]", RaceSurfaceCrack::kKind, member.added,
                              stress_intensities(K_I * kStressIntensity, 0.0, 0.0), false);
  for (const char* const tag : {"AP-6", "AP-8", "AP-9", "AP-3", "AP-2", "AP-1"})
    member.equations.emplace_back(tag);
  return member;
}

SoundCup sound_cup(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const Material& material = only_material(gear, fs);
  const double k = fs.shape_factor.value_or(fs.shape == FlexsplineShape::cup ? 0.83 : 1.0);
  return {.shape_coefficient = k,
          .structure_coefficient = k,
          .length = fs.tube_length() / mm,
          .pitch_diameter = gear.drive.pitch_diameter / mm,
          .wall_thickness = fs.ring_thickness() / mm,
          .shear_modulus = elastic_constants(material).G / MPa};
}

CrackedWall cracked_wall(const GearSet& gear, const WallThroughCrack& crack) {
  const Flexspline& fs = *gear.flexspline;
  const Material& material = only_material(gear, fs);
  const double r_m = (gear.drive.pitch_diameter - fs.ring_thickness()) / 2;
  return {.half_length = crack.half_length / mm,
          .mean_radius = overrides(gear).mean_radius.value_or(r_m) / mm,
          .wall_thickness = fs.ring_thickness() / mm,
          .stress_nonuniformity = fs.stress_nonuniformity,
          .dynamic_load = fs.dynamic_load,
          .youngs_modulus = material.youngs_modulus.value() / MPa};
}

Member flexspline(const GearSet& gear, const WallThroughCrack* crack) {
  if (!gear.flexspline) return absent_member("flexspline");
  Member member;
  member.equations = {"AP-12"};
  if (gear.flexspline->shape_factor)
    member.notes.push_back(
        {.code = "article.factor_squared",
         .text = "the printed equation has the factor of the shape twice, as k_f and as k_G",
         .path = "flexspline.shape_factor",
         .equation = "AP-12",
         .severity = Severity::care});
  member.sound = sound_flexspline_compliance(sound_cup(gear)) * kCompliance;
  member.cracked = member.sound;
  if (crack == nullptr) return member;

  if (crack->shell_correction)
    member.notes.push_back(not_read("flexspline.crack[0].shell_correction", "AP-10",
                                    "the article treats the wall as a flat plate"));
  const CrackedWall wall = cracked_wall(gear, *crack);
  member.added = wall_crack_compliance(wall) * kCompliance;
  member.cracked = member.sound + member.added;

  const double tau =
      wall_shear(std::abs(gear.load.torque) / kTorque, wall.mean_radius, wall.wall_thickness);
  const auto [K_I, K_II] = wall_stress_intensity(tau, crack->angle, wall.half_length);
  member.crack =
      crack_report("flexspline.crack[0]", WallThroughCrack::kKind, member.added,
                   stress_intensities(K_I * kStressIntensity, K_II * kStressIntensity, 0.0), true);
  for (const char* const tag : {"AP-11", "AP-10"}) member.equations.emplace_back(tag);
  return member;
}

/// Diameter d_s in mm: the article's number, or that of the solid shaft with the same polar moment.
double equivalent_diameter(const GearSet& gear) {
  const OutputShaft& shaft = *gear.output_shaft;
  const double D = shaft.outer_diameter;
  const double d = shaft.inner_diameter;
  return overrides(gear).equivalent_shaft_diameter.value_or(
             std::pow(std::pow(D, 4) - std::pow(d, 4), 0.25)) /
         mm;
}

CrackedShaft cracked_shaft(const GearSet& gear, const AnnularCrack& crack) {
  const Material& material =
      material_of(gear, gear.output_shaft->material, "output_shaft.material");
  const double d_s = equivalent_diameter(gear);
  const double x = 1 - 2 * crack.depth / mm / d_s;
  if (!(x > 0))
    throw InputError("output_shaft.crack[0].depth", crack.depth, "m",
                     "depth < half of the equivalent solid diameter (method as-printed)");
  return {.depth = crack.depth / mm,
          .diameter = d_s,
          .M_p = overrides(gear).M_p.value_or(axial_coefficient(x)),
          .M_M = overrides(gear).M_M.value_or(torsion_coefficient(x)),
          .youngs_modulus = material.youngs_modulus.value() / MPa,
          .shear_modulus = elastic_constants(material).G / MPa};
}

Member output_shaft(const GearSet& gear, const AnnularCrack* crack) {
  if (!gear.output_shaft) return absent_member("output_shaft");
  const OutputShaft& shaft = *gear.output_shaft;
  const double mu =
      elastic_constants(material_of(gear, shaft.material, "output_shaft.material")).G / MPa;
  Member member;
  member.equations = {"AP-17"};
  member.sound =
      sound_shaft_compliance(shaft.length / mm, equivalent_diameter(gear), mu) * kCompliance;
  member.cracked = member.sound;
  if (crack == nullptr) return member;

  if (shaft.solid() && crack->solution != AnnularSolution::tada)
    member.notes.push_back(not_read("output_shaft.crack[0].solution", "AP-14",
                                    "the article prints its own polynomials"));
  const CrackedShaft cracked = cracked_shaft(gear, *crack);
  member.added = shaft_crack_compliance(cracked).total() * kCompliance;
  member.cracked = member.sound + member.added;

  const auto [K_I, K_III] = shaft_stress_intensity(cracked, gear.load.axial_force / N,
                                                   std::abs(gear.load.torque) / kTorque);
  member.crack =
      crack_report("output_shaft.crack[0]", AnnularCrack::kKind, member.added,
                   stress_intensities(K_I * kStressIntensity, 0.0, K_III * kStressIntensity), true);
  if (!overrides(gear).M_p) member.equations.emplace_back("AP-14");
  if (!overrides(gear).M_M) member.equations.emplace_back("AP-15");
  for (const char* const tag : {"AP-16", "AP-13"}) member.equations.emplace_back(tag);
  return member;
}

}  // namespace
}  // namespace article

StiffnessResult torsional_stiffness_as_printed(const GearSet& gear) {
  check(gear);
  const article::Cracks cracks = article::treatable_cracks(gear, Method::as_printed);
  return article::drive_result(gear, Method::as_printed, article::wave_generator(gear, cracks.race),
                               article::flexspline(gear, cracks.wall),
                               article::output_shaft(gear, cracks.shaft));
}

}  // namespace strainwave

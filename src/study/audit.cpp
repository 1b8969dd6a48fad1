// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/audit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "strainwave/article/as_printed.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// --- Printed inputs ---------------------------------------------------------------------------

/// The inputs of the worked example as printed, in N, mm, MPa, rad.
///
/// Kept in a system of units that can be changed, because the dimension of an equation is found by
/// evaluating it in two of them.
struct Printed {
  double E = 2.1e5, mu = 8e4, nu = 0.3;
  double T = 1e5;
  double i_h = 100, w_0 = 0.8, d_1 = 160, U = 2;
  double k_r = 0.35, F_r = 500, K_G0 = 1.2e5, dK_G = 1.5e3;
  double t_i = 10, a_contact = 5, b_contact = 2, beta = 0.45, Q = 1.5;
  double delta = 2.24, L = 160, r_m = 79.88, K_u = 1.1, K_d = 1.2;
  double D_s = 70, d_s_bore = 45, L_s = 200, d_s = 60, M_p = 0.85, M_M = 0.42;
  double a = 0.1;

  /// The same physical inputs in units of force and length that are smaller by these factors.
  [[nodiscard]] Printed in_smaller_units(double force, double length) const {
    Printed p = *this;
    const double stress = force / (length * length);
    for (double* const s : {&p.E, &p.mu}) *s *= stress;
    p.T *= force * length;
    p.F_r *= force;
    for (double* const k : {&p.K_G0, &p.dK_G}) *k *= force / length;
    for (double* const l : {&p.w_0, &p.d_1, &p.t_i, &p.a_contact, &p.b_contact, &p.delta, &p.L,
                            &p.r_m, &p.D_s, &p.d_s_bore, &p.L_s, &p.d_s, &p.a})
      *l *= length;
    return p;
  }

  [[nodiscard]] article::CrackedRace race() const {
    return {.depth = a,
            .ring_thickness = t_i,
            .flaw_parameter = Q,
            .contact_factor = beta,
            .contact_semi_major = a_contact,
            .contact_semi_minor = b_contact,
            .youngs_modulus = E};
  }
  [[nodiscard]] article::Cam cam() const {
    return {.force_transmission_coefficient = k_r,
            .pitch_diameter = d_1,
            .wave_number = U,
            .radial_displacement = w_0,
            .ratio = i_h};
  }
  [[nodiscard]] article::CrackedWall wall() const {
    return {.half_length = a,
            .mean_radius = r_m,
            .wall_thickness = delta,
            .stress_nonuniformity = K_u,
            .dynamic_load = K_d,
            .youngs_modulus = E};
  }
  [[nodiscard]] article::SoundCup cup(double k_f, double k_G) const {
    return {.shape_coefficient = k_f,
            .structure_coefficient = k_G,
            .length = L,
            .pitch_diameter = d_1,
            .wall_thickness = delta,
            .shear_modulus = mu};
  }
  [[nodiscard]] article::CrackedShaft shaft() const {
    return {.depth = a,
            .diameter = d_s,
            .M_p = M_p,
            .M_M = M_M,
            .youngs_modulus = E,
            .shear_modulus = mu};
  }
};

/// The same example for the corrected method, in SI.
GearSet example(double crack_size, double shaft_crack) {
  using units::mm;
  const Printed p;
  GearSet gear;
  gear.material["steel"] = {.youngs_modulus = p.E * units::MPa,
                            .shear_modulus = p.mu * units::MPa,
                            .poissons_ratio = p.nu,
                            .yield_strength = {},
                            .fracture_toughness = {}};
  gear.drive = {.ratio = p.i_h,
                .wave_number = 2,
                .pitch_diameter = p.d_1 * mm,
                .radial_displacement = p.w_0 * mm};
  gear.load = {.torque = p.T * mm, .axial_force = 0};
  WaveGenerator wg;
  wg.material = "steel";
  wg.force_transmission_coefficient = p.k_r;
  wg.radial_stiffness = p.K_G0 / mm;
  wg.inner_ring_thickness = p.t_i * mm;
  wg.contact_semi_axes = {p.a_contact * mm, p.b_contact * mm};
  RaceSurfaceCrack race;
  race.depth = crack_size;
  race.aspect_ratio = bracketed_root(
      [&](double rho) { return sif::NewmanRaju(rho).shape_parameter() - p.Q; }, 0.1, 1);
  race.contact_factor = p.beta;
  wg.crack = {race};
  gear.wave_generator = wg;
  Flexspline fs;
  fs.material = "steel";
  fs.wall_thickness = p.delta * mm;
  fs.length = p.L * mm;
  fs.stress_nonuniformity = p.K_u;
  WallThroughCrack wall;
  wall.half_length = crack_size;
  fs.crack = {wall};
  gear.flexspline = fs;
  OutputShaft shaft;
  shaft.material = "steel";
  shaft.outer_diameter = p.D_s * mm;
  shaft.inner_diameter = p.d_s_bore * mm;
  shaft.length = p.L_s * mm;
  AnnularCrack ring;
  ring.depth = shaft_crack;
  shaft.crack = {ring};
  gear.output_shaft = shaft;
  return gear;
}

StiffnessResult corrected_example(double crack_size_mm) {
  return torsional_stiffness(example(crack_size_mm * units::mm, crack_size_mm * units::mm));
}

// From SI to the article's units: rad/(N*m) to rad/(N*mm), N*m/rad to N*mm/rad.
double compliance_in_mm(const Quantity& q) { return q.value * units::mm; }
double stiffness_in_mm(const Quantity& q) { return q.value / units::mm; }

// --- Live tests -------------------------------------------------------------------------------

/// Exponents of force and length that an equation's value has.
struct Exponents {
  double force = 0.0;
  double length = 0.0;
};

/// Found by evaluating the equation in units of force, then of length, ten times smaller.
template <class Equation>
Exponents exponents_of(const Equation& equation) {
  const Printed p;
  const double plain = equation(p);
  return {std::log10(equation(p.in_smaller_units(10, 1)) / plain),
          std::log10(equation(p.in_smaller_units(1, 10)) / plain)};
}

std::string dimension_text(const Exponents& e) {
  return fmt::format("force^{:.0f} length^{:.0f}", std::round(e.force) + 0.0,
                     std::round(e.length) + 0.0);
}

/// The value of one input for which an equation gives `wanted`.
template <class Equation>
ReproducingInput reproducing(std::string name, std::string unit, double wanted, double lower,
                             double upper, const Equation& equation) {
  return {std::move(name),
          bracketed_root([&](double x) { return equation(x) - wanted; }, lower, upper),
          std::move(unit)};
}

/// Printed inputs with one of them changed.
Printed with(double Printed::*input, double value) {
  Printed p;
  p.*input = value;
  return p;
}

// --- The rows ---------------------------------------------------------------------------------

using Rows = std::vector<AuditRow>;
constexpr const char* kCompliance = "rad/(N*mm)";

void add_fracture_mechanics(Rows& rows) {
  const Printed p;
  const double isotropic = p.E / (2 * (1 + p.nu));
  rows.push_back({.id = "A1",
                  .quantity = "G of mode III in plane stress, K_III = 1",
                  .unit = "mm^2/N",
                  .own = article::energy_release_rate(0, 0, 1, p.E, p.nu),
                  .corrected = energy_release_rate(0, 0, 1, {.opening = p.E, .shear = isotropic}),
                  .verdict = AuditVerdict::physics,
                  .sentence = "mode III has no plane stress or strain: K_III^2/(E'(1-nu)) is right "
                              "with E' of plane strain only"});
  // A through crack of the flexspline gives both integrals something to work on.
  const double tau_squared = 1.0;
  const auto G = [&](double area) { return tau_squared * pi * area / (2 * p.delta) / p.E; };
  const double area = 2 * p.delta * p.a;
  const sif::ThroughCrackInTube crack{.half_length = p.a,
                                      .mean_radius = p.r_m,
                                      .wall_thickness = p.delta,
                                      .angle = pi / 4,
                                      .shell_correction = false};
  const double per_torque = article::wall_shear(1, p.r_m, p.delta);
  const double engine =
      added_compliance(crack, {.opening = p.E, .shear = p.mu}).matrix(kTorsion, kTorsion) /
      (per_torque * per_torque);
  rows.push_back({.id = "A2",
                  .quantity = "displacement du = int G/P dA, P = 1",
                  .unit = "mm",
                  .own = article::added_displacement(G, area, 1),
                  .corrected = engine,
                  .verdict = AuditVerdict::physics,
                  .sentence =
                      "Castigliano at constant load gives int 2G/P dA: half is missing, and "
                      "the article itself uses the 2 further on"});
  rows.push_back({.id = "A3",
                  .quantity = "compliance dl = int 2G/P^2 dA, P = 1",
                  .unit = "mm/N",
                  .own = article::added_compliance(G, area, 1),
                  .corrected = engine,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "right, and in contradiction to the displacement above it"});
  const PointContact ball{.curvature_sums = {0.01, 0.1}, .contact_modulus = p.E};
  rows.push_back({.id = "A4",
                  .quantity = "exponent n in K ~ P^n of a Hertz-driven crack",
                  .unit = "1",
                  .own = 1.0,
                  .corrected = std::log2(hertz_contact(ball, 2 * p.F_r).peak_pressure /
                                         hertz_contact(ball, p.F_r).peak_pressure),
                  .verdict = AuditVerdict::ambiguous,
                  .sentence =
                      "K = alpha P holds where the stress is proportional to the load, which "
                      "a contact pressure is not"});
  rows.push_back({.id = "A5",
                  .quantity = "1/(l_H + l_f + l_so) times their sum",
                  .unit = "1",
                  .own = article::drive_stiffness(3.0, 2.0, 7.0) * (3.0 + 2.0 + 7.0),
                  .corrected = 1.0,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "compliances in series add; tooth mesh, circular spline, bearing and "
                              "diaphragm are missing in the sum"});
  rows.push_back({.id = "A6",
                  .quantity = "references to Eq. (4) and Eq. (18)",
                  .unit = "1",
                  .verdict = AuditVerdict::misprint,
                  .sentence = "no equation of the article is numbered, and K_II/T lacks a brace"});
  const double in_series = 1 / (1 / p.K_G0 + 1 / p.dK_G);
  rows.push_back({.id = "A7",
                  .quantity = "K_G by the article's list of steps",
                  .unit = "N/mm",
                  .printed = 1.185e5,
                  .own = in_series,
                  .verdict = AuditVerdict::physics,
                  .sentence = fmt::format(
                      "the list of steps adds compliances, the derivation subtracts stiffnesses; "
                      "with the printed numbers they differ by a factor of {:.0f}",
                      article::radial_stiffness(p.K_G0, p.dK_G) / in_series)});
}

/// Hertz contact of the article's ellipse: sum of curvatures for a' = 5 mm, b' = 2 mm at a load.
double curvature_sum_of_printed_ellipse(double load) {
  const Printed p;
  const double contact_modulus = p.E / (2 * (1 - p.nu * p.nu));
  const auto contact = [&](double sum, double difference) {
    return hertz_contact(
        {.curvature_sums = {sum * (1 - difference) / 2, sum * (1 + difference) / 2},
         .contact_modulus = contact_modulus},
        load);
  };
  const double difference = bracketed_root(
      [&](double F) {
        const HertzContact h = contact(1e-3, F);
        return h.minor_semi_axis / h.major_semi_axis - p.b_contact / p.a_contact;
      },
      0.01, 0.999);
  return bracketed_root(
      [&](double sum) { return contact(sum, difference).major_semi_axis - p.a_contact; }, 1e-6,
      1.0);
}

void add_wave_generator(Rows& rows) {
  const Printed p;
  const StiffnessResult result = corrected_example(p.a);
  const WaveGenerator wg = *example(1e-4, 1e-4).wave_generator;
  const double f = lobe_force_per_torque(example(1e-4, 1e-4).drive, wg) * units::mm;  // 1/mm
  const double newman_raju =
      compliance_in_mm(result.cracks[0].positive.at_output) / (f * f);  // mm/N, of one lobe
  const double pressure = article::contact_pressure(p.F_r, p.a_contact, p.b_contact);
  const double stress = article::race_stress(p.beta, pressure);
  const double axis_ratio = p.b_contact / p.a_contact;

  rows.push_back({.id = "B1",
                  .quantity = "1.95 of K_I = 1.95 sigma sqrt(a/Q)",
                  .unit = "1",
                  .printed = 1.95,
                  .own = article::race_stress_intensity(1, 1, 1),
                  .corrected = 1.1 * std::sqrt(pi),
                  .verdict = AuditVerdict::reproduced,
                  .sentence =
                      "1.1 sqrt(pi), Irwin's deepest point of a shallow crack; Q depends on "
                      "the material in its old form only"});
  rows.push_back({.id = "B2",
                  .quantity = "sigma = beta/2 sigma_max",
                  .unit = "MPa",
                  .own = stress,
                  .corrected = edge_tension(axis_ratio, p.nu).minor_end * pressure,
                  .verdict = AuditVerdict::physics,
                  .sentence =
                      "beta/2 sigma_max is the subsurface orthogonal shear, no hoop tension; "
                      "the only Hertz tension is at the edge of the contact"});
  rows.push_back({.id = "B3",
                  .quantity = "beta for a' = 5, b' = 2",
                  .unit = "1",
                  .printed = p.beta,
                  .own = orthogonal_shear_factor(axis_ratio),
                  .corrected = orthogonal_shear_factor(axis_ratio),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format("beta follows from b'/a' and is {:.4f} here",
                                          orthogonal_shear_factor(axis_ratio)),
                  .reproduce = reproducing("b'/a'", "1", p.beta, 0.1, 1.0,
                                           [](double x) { return orthogonal_shear_factor(x); })});
  rows.push_back({.id = "B4",
                  .quantity = "sigma_max = 3F_r/(2 pi a' b')",
                  .unit = "MPa",
                  .own = pressure,
                  .corrected = peak_pressure(p.F_r, p.a_contact, p.b_contact),
                  .verdict = AuditVerdict::ambiguous,
                  .sentence = "right if a', b' are semi-axes, which the text does not say; four "
                              "times as much if they are axes"});
  // 12.7 mm ball in a groove of conformity 0.52 on a race of 55 mm radius.
  const HertzContact ball =
      hertz_contact({.curvature_sums = {2 / 12.7 - 1 / (0.52 * 12.7), 2 / 12.7 + 1 / 55.0},
                     .contact_modulus = p.E / (2 * (1 - p.nu * p.nu))},
                    p.F_r);
  rows.push_back({.id = "B5",
                  .quantity = "a' at 500 N (12.7 mm ball, 55 mm race radius)",
                  .unit = "mm",
                  .printed = p.a_contact,
                  .own = ball.major_semi_axis,
                  .corrected = ball.major_semi_axis,
                  .verdict = AuditVerdict::physics,
                  .sentence = "contact axes follow from load and curvature; 5 x 2 mm needs bodies "
                              "of metres of radius",
                  .reproduce = ReproducingInput{"sum of curvatures",
                                                curvature_sum_of_printed_ellipse(p.F_r), "1/mm"}});
  const auto load = [&](double T) { return article::radial_load(1.15, p.k_r, T, p.d_1); };
  rows.push_back({.id = "B6",
                  .quantity = "radial load F_r",
                  .unit = "N",
                  .printed = p.F_r,
                  .own = load(p.T),
                  .corrected = f * p.T,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "half of it; twice comes out if d_1 is read as a radius",
                  .reproduce = reproducing("T", "N*mm", p.F_r, 1e4, 1e6, load)});
  const double per_force = article::race_crack_displacement(p.race(), 1);
  rows.push_back({.id = "B7",
                  .quantity = "crack compliance with dA = t_i da, F_r^1",
                  .unit = "mm/N",
                  .own = per_force,
                  .corrected = newman_raju,
                  .verdict = AuditVerdict::physics,
                  .sentence = "t_i is the direction in which the crack grows, not its width: a "
                              "semi-ellipse sweeps c da dphi"});
  const auto displacement = [](const Printed& q) {
    return article::race_crack_displacement(q.race(), q.F_r);
  };
  rows.push_back({.id = "B8a",
                  .quantity = "coefficient 0.217 of Delta u_H",
                  .unit = "1",
                  .printed = 0.217,
                  .own = std::pow(1.95 * 3 / (4 * pi), 2),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "(1.95)^2 (3/(4 pi))^2; the 2 in front of G cancels the 1/2 of the "
                              "integral"});
  rows.push_back({.id = "B8b",
                  .quantity = "Delta u_H",
                  .unit = "mm",
                  .own = displacement(p),
                  .corrected = newman_raju * p.F_r,
                  .verdict = AuditVerdict::dimension,
                  .sentence = fmt::format("F_r is squared and must not be: as printed it has the "
                                          "dimension {}",
                                          dimension_text(exponents_of(displacement)))});
  const auto crack_stiffness = [](const Printed& q) {
    return article::race_crack_stiffness(q.race(), q.F_r);
  };
  const auto stiffness_at = [&](double a) { return crack_stiffness(with(&Printed::a, a)); };
  rows.push_back({.id = "B9",
                  .quantity = "crack stiffness Delta K_G",
                  .unit = "N/mm",
                  .printed = p.dK_G,
                  .own = crack_stiffness(p),
                  .corrected = 1 / newman_raju,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format("no input of the article gives it, and F_r in the "
                                          "denominator leaves the dimension {}",
                                          dimension_text(exponents_of(crack_stiffness))),
                  .reproduce = reproducing("a", "mm", p.dK_G, 0.01, 100, stiffness_at)});
  rows.push_back({.id = "B10",
                  .quantity = "K_G0 = F_r/(Db + Dg + Da)",
                  .unit = "N/mm",
                  .printed = p.K_G0,
                  .own = article::sound_radial_stiffness(p.F_r, p.F_r / p.K_G0, 0, 0),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "an input; displacements add, and the shaft's is zero for two "
                              "symmetric lobes"});
  const auto by_subtraction = [&](double a) {
    return article::radial_stiffness(p.K_G0, stiffness_at(a));
  };
  rows.push_back({.id = "B11a",
                  .quantity = "K_G = K_G0 - Delta K_G, printed Delta K_G",
                  .unit = "N/mm",
                  .printed = 1.185e5,
                  .own = article::radial_stiffness(p.K_G0, p.dK_G),
                  .corrected = 1 / (1 / p.K_G0 + newman_raju),
                  .verdict = AuditVerdict::physics,
                  .sentence = "the arithmetic holds, the subtraction does not: compliances add"});
  rows.push_back({.id = "B11b",
                  .quantity = "K_G = K_G0 - Delta K_G, its own Delta K_G",
                  .unit = "N/mm",
                  .own = by_subtraction(p.a),
                  .corrected = 1 / (1 / p.K_G0 + newman_raju),
                  .verdict = AuditVerdict::physics,
                  .sentence = "negative, and minus infinity without a crack; the input is where it "
                              "changes sign",
                  .reproduce = reproducing("a of K_G = 0", "mm", 0, 0.1, 100, by_subtraction)});
  const double own_lambda = article::wave_generator_compliance(p.cam(), p.K_G0);
  const double true_lambda = compliance_in_mm(result.intact.compliance.wave_generator);
  rows.push_back({.id = "B12",
                  .quantity = "l_H of a given K_G, sound",
                  .unit = kCompliance,
                  .own = own_lambda,
                  .corrected = true_lambda,
                  .verdict = AuditVerdict::physics,
                  .sentence = "the cam turned back over its mean slope violates reciprocity with "
                              "the lobe force, where w_0 i = d_1/2 by pi/(4 c_F^2 k_r)"});
  const auto lambda_of = [&](double K_G) {
    return article::wave_generator_compliance(p.cam(), K_G);
  };
  rows.push_back({.id = "B13a",
                  .quantity = "l_H, no cracks",
                  .unit = kCompliance,
                  .printed = 3.407e-10,
                  .own = own_lambda,
                  .corrected = true_lambda,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "half of it follows from the printed K_G0",
                  .reproduce = reproducing("K_G", "N/mm", 3.407e-10, 1e3, 1e7, lambda_of)});
  rows.push_back({.id = "B13b",
                  .quantity = "l_H, with cracks",
                  .unit = kCompliance,
                  .printed = 3.558e-10,
                  .own = lambda_of(1.185e5),
                  .corrected = compliance_in_mm(result.positive.compliance.wave_generator),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "nor does its ratio to the sound value agree with the printed K_G",
                  .reproduce = reproducing("K_G", "N/mm", 3.558e-10, 1e3, 1e7, lambda_of)});
}

void add_flexspline(Rows& rows) {
  const Printed p;
  const StiffnessResult result = corrected_example(p.a);
  const double mean_radius = (p.d_1 - p.delta) / 2;
  const double tau = article::wall_shear(p.T, mean_radius, p.delta);
  const auto K = article::wall_stress_intensity(tau, pi / 4, p.a);
  const sif::ThroughCrackInTube crack{.half_length = p.a,
                                      .mean_radius = mean_radius,
                                      .wall_thickness = p.delta,
                                      .angle = pi / 4,
                                      .shell_correction = false};
  const UnitStressIntensity<2> k = crack.stress_intensity(p.a, 0);
  rows.push_back({.id = "C1",
                  .quantity = "K_I of the flexspline crack",
                  .unit = "MPa*mm^0.5",
                  .own = K.K_I,
                  .corrected = k.I[kTorsion] * p.T,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "right for a through crack of half length a; the text calls a its "
                              "depth, and a surface crack needs other factors"});
  rows.push_back({.id = "C2",
                  .quantity = "K_II/K_I at 45 deg, \"mixed mode I-II\"",
                  .unit = "1",
                  .own = K.K_II / K.K_I,
                  .corrected = k.II[kTorsion] / k.I[kTorsion],
                  .verdict = AuditVerdict::physics,
                  .sentence = "at 45 deg to the axis torsion is pure mode I: K_II vanishes"});
  rows.push_back(
      {.id = "C3",
       .quantity = "tau = T/(2 pi r_m^2 delta), r_m = 78.88",
       .unit = "MPa",
       .own = tau,
       .corrected = sif::crack_plane_stress(mean_radius, p.delta, 0, 1).shear[kTorsion] * p.T,
       .verdict = AuditVerdict::reproduced,
       .sentence = "Bredt's formula"});
  const double corrected_crack = compliance_in_mm(result.cracks[1].positive.at_output);
  Printed own_radius = p;
  own_radius.r_m = mean_radius;
  rows.push_back({.id = "C4",
                  .quantity = "Delta l_f with r_m = 78.88",
                  .unit = kCompliance,
                  .own = article::wall_crack_compliance(own_radius.wall()),
                  .corrected = corrected_crack,
                  .verdict = AuditVerdict::physics,
                  .sentence =
                      "K_u multiplies a stress and enters squared; a load factor K_d has no "
                      "place in a compliance; so short a crack is in plane strain"});
  rows.push_back(
      {.id = "C5",
       .quantity = "factor 0.1 of l_f0 for pi/32",
       .unit = "1",
       .printed = 0.1,
       .own = pi / 32,
       .corrected = pi / 32,
       .verdict = AuditVerdict::reproduced,
       .sentence = fmt::format("rounded, {:.1f} % too stiff", 100 * (0.1 / (pi / 32) - 1))});
  const auto with_factor = [&](double factor) {
    return article::sound_flexspline_compliance(p.cup(factor, 1));
  };
  const double true_sound = compliance_in_mm(result.intact.compliance.flexspline);
  rows.push_back({.id = "C6",
                  .quantity = "l_f0",
                  .unit = kCompliance,
                  .printed = 2.359e-10,
                  .own = article::sound_flexspline_compliance(p.cup(0.83, 0.83)),
                  .corrected = true_sound,
                  .verdict = AuditVerdict::misprint,
                  .sentence = "k_f and k_G are the same 0.83: the formula has it twice, the number "
                              "once",
                  .reproduce = reproducing("k_f k_G", "1", 2.359e-10, 0.1, 2, with_factor)});
  rows.push_back({.id = "C7",
                  .quantity = "mean radius r_m",
                  .unit = "mm",
                  .printed = p.r_m,
                  .own = mean_radius,
                  .corrected = mean_radius,
                  .verdict = AuditVerdict::misprint,
                  .sentence = "(160 - 2.24)/2; one digit is wrong"});
  rows.push_back({.id = "C8",
                  .quantity = "Delta l_f",
                  .unit = kCompliance,
                  .printed = 1.0e-15,
                  .own = article::wall_crack_compliance(p.wall()),
                  .corrected = corrected_crack,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "a power of ten too large",
                  .reproduce = reproducing("a", "mm", 1.0e-15, 0.01, 10, [&](double a) {
                    return article::wall_crack_compliance(with(&Printed::a, a).wall());
                  })});
  rows.push_back({.id = "C9",
                  .quantity = "l_f with crack",
                  .unit = kCompliance,
                  .printed = 2.359e-10,
                  .own = 2.359e-10 + 1.0e-15,
                  .corrected = compliance_in_mm(result.positive.compliance.flexspline),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed parts"});
  rows.push_back({.id = "C10",
                  .quantity = "Delta l_f under reversed torque",
                  .unit = kCompliance,
                  .own = article::wall_crack_compliance(p.wall()),
                  .corrected = compliance_in_mm(result.cracks[1].negative.at_output),
                  .verdict = AuditVerdict::physics,
                  .sentence = fmt::format(
                      "a 45 deg crack that one sense of torque opens is closed by the other; and "
                      "assembly bends the wall by {:.1f} MPa, far above the shear",
                      ovalisation_stress(example(1e-4, 1e-4)) / units::MPa)});
}

/// Added compliance over [axial, torsion] of a crack in a solid shaft, in N and mm.
SymmetricMatrix<2> solid_shaft(double depth, double diameter, sif::AnnularPolynomials polynomials) {
  const Printed p;
  return added_compliance(
             sif::AnnularCrackSolid{
                 .depth = depth, .diameter = diameter, .polynomials = polynomials},
             {.opening = p.E / (1 - p.nu * p.nu), .shear = p.mu})
      .matrix;
}

void add_output_shaft(Rows& rows) {
  const Printed p;
  const StiffnessResult result = corrected_example(p.a);
  const double x = (p.d_s - 2 * p.a) / p.d_s;
  const auto tada_M_p = [](double ratio) {
    return std::sqrt(ratio) / 2 * sif::annular_p1(sif::AnnularPolynomials::tada, ratio);
  };
  const auto tada_M_M = [](double ratio) {
    return 3 * std::sqrt(ratio) / 8 * sif::annular_p3(sif::AnnularPolynomials::tada, ratio);
  };
  article::CrackedShaft with_polynomials = p.shaft();
  with_polynomials.M_p = article::axial_coefficient(x);
  with_polynomials.M_M = article::torsion_coefficient(x);
  const sif::AnnularCrackSolid improved{.depth = p.a, .diameter = p.d_s};
  rows.push_back({.id = "D1",
                  .quantity = "K_III of the shaft, M_M from its polynomial",
                  .unit = "MPa*mm^0.5",
                  .own = article::shaft_stress_intensity(with_polynomials, 0, p.T).K_III,
                  .corrected = improved.stress_intensity(p.a, 0).III[kTorsion] * p.T,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the handbook's form on the net section"});
  rows.push_back(
      {.id = "D2",
       .quantity = "M_p(1), printed +0.182 and 0.166",
       .unit = "1",
       .own = article::axial_coefficient(1),
       .corrected = tada_M_p(1),
       .verdict = AuditVerdict::misprint,
       .sentence = "-0.182 and 0.366 in the handbook; the shallow crack is then 1.1215"});
  rows.push_back({.id = "D3",
                  .quantity = "M_M(1), printed 0.376",
                  .unit = "1",
                  .own = article::torsion_coefficient(1),
                  .corrected = tada_M_M(1),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "0.375 in the handbook"});
  const article::ShaftCrackCompliance terms = article::shaft_crack_compliance(p.shaft());
  rows.push_back({.id = "D4",
                  .quantity = "first term of Delta l_so (K_I) at P = 0",
                  .unit = kCompliance,
                  .own = terms.axial_term,
                  .corrected = 0.0,
                  .verdict = AuditVerdict::physics,
                  .sentence =
                      "K_I belongs to the axial force: the torsional compliance has none of "
                      "it, and the two loads are not coupled"});
  const double solid =
      solid_shaft(p.a, p.d_s, sif::AnnularPolynomials::improved)(kTorsion, kTorsion);
  rows.push_back(
      {.id = "D5",
       .quantity = "second term (K_III), dA = 2 pi a da",
       .unit = kCompliance,
       .own = article::shaft_crack_compliance(with_polynomials).torsion_term,
       .corrected = solid,
       .verdict = AuditVerdict::physics,
       .sentence = "the area of a penny crack; an annulus sweeps pi d_e da, some 3 d_e/(4a) more"});
  const auto first_term = [](const Printed& q) {
    return article::shaft_crack_compliance(q.shaft()).axial_term;
  };
  rows.push_back({.id = "D6",
                  .quantity = "exponent of length of the first term",
                  .unit = "1",
                  .own = std::round(exponents_of(first_term).length) + 0.0,
                  .corrected = -1.0,
                  .verdict = AuditVerdict::dimension,
                  .sentence = fmt::format("it has the dimension {}; a torsional compliance has "
                                          "force^-1 length^-1",
                                          dimension_text(exponents_of(first_term)))});
  rows.push_back({.id = "D7",
                  .quantity = "second term with the printed M_M = 0.42",
                  .unit = kCompliance,
                  .own = terms.torsion_term,
                  .corrected = solid,
                  .verdict = AuditVerdict::physics,
                  .sentence = "right algebra for the wrong area and coefficient; M_M and d_e vary "
                              "while the crack grows"});
  rows.push_back({.id = "D8",
                  .quantity = "2/E in front of K_I^2, over plane strain",
                  .unit = "1",
                  .own = 1.0,
                  .corrected = 1 - p.nu * p.nu,
                  .verdict = AuditVerdict::physics,
                  .sentence = "an annular crack is in plane strain"});
  const double sound = article::sound_shaft_compliance(p.L_s, p.d_s, p.mu);
  rows.push_back(
      {.id = "D9",
       .quantity = "l_so0 of a 60 x 200 mm shaft, factor 0.1",
       .unit = kCompliance,
       .own = sound,
       .corrected = torsional_compliance(Tube{.outer_diameter = p.d_s, .length = p.L_s}, p.mu),
       .verdict = AuditVerdict::reproduced,
       .sentence = "0.1 for pi/32"});
  const double hollow_fourth = std::pow(p.D_s, 4) - std::pow(p.d_s_bore, 4);
  rows.push_back({.id = "D10",
                  .quantity = "equivalent solid diameter d_s",
                  .unit = "mm",
                  .printed = p.d_s,
                  .own = std::pow(hollow_fourth, 0.25),
                  .corrected = std::pow(hollow_fourth, 0.25),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format(
                      "equal polar moment gives {:.1f}, equal section modulus {:.1f}, equal area "
                      "{:.1f}; and a crack knows no equivalent solid shaft",
                      std::pow(hollow_fourth, 0.25), std::cbrt(hollow_fourth / p.D_s),
                      std::sqrt(p.D_s * p.D_s - p.d_s_bore * p.d_s_bore)),
                  .reproduce = reproducing("bore", "mm", p.d_s, 1, 69, [&](double bore) {
                    return std::pow(std::pow(p.D_s, 4) - std::pow(bore, 4), 0.25);
                  })});
  rows.push_back(
      {.id = "D11",
       .quantity = "l_so0",
       .unit = kCompliance,
       .printed = 6.906e-10,
       .own = sound,
       .corrected = compliance_in_mm(result.intact.compliance.output_shaft),
       .verdict = AuditVerdict::not_reproducible,
       .sentence = "it is the hollow shaft with another length",
       .reproduce = reproducing("L_s (hollow)", "mm", 6.906e-10, 10, 1000, [&](double L) {
         return article::sound_shaft_compliance(L, std::pow(hollow_fourth, 0.25), p.mu);
       })});
  rows.push_back({.id = "D12",
                  .quantity = "Delta l_so",
                  .unit = kCompliance,
                  .printed = 3.9e-14,
                  .own = terms.total(),
                  .corrected = compliance_in_mm(result.cracks[2].positive.at_output),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "printed formula and inputs give a third of it; that they come close "
                              "to the corrected value is chance",
                  .reproduce = reproducing("a", "mm", 3.9e-14, 0.01, 10, [&](double a) {
                    return article::shaft_crack_compliance(with(&Printed::a, a).shaft()).total();
                  })});
  const double doubled = solid_shaft(p.a, 2 * p.d_s, sif::AnnularPolynomials::improved)(1, 1);
  rows.push_back(
      {.id = "D13",
       .quantity = "exponent n in Delta l_so ~ d_s^n",
       .unit = "1",
       .corrected = std::log2(doubled / solid),
       .verdict = AuditVerdict::physics,
       .sentence = "\"more compliance with larger diameters\" is the reverse of the truth"});
  rows.push_back({.id = "D14",
                  .quantity = "M_p at d_e/d_s = 0.9967",
                  .unit = "1",
                  .printed = p.M_p,
                  .own = article::axial_coefficient(x),
                  .corrected = tada_M_p(x),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "it belongs to a crack 46 times as deep",
                  .reproduce = reproducing("d_e/d_s (handbook)", "1", p.M_p, 0.1, 1, tada_M_p)});
  rows.push_back({.id = "D15",
                  .quantity = "M_M at d_e/d_s = 0.9967",
                  .unit = "1",
                  .printed = p.M_M,
                  .own = article::torsion_coefficient(x),
                  .corrected = tada_M_M(x),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "it belongs to yet another crack than M_p",
                  .reproduce = reproducing("d_e/d_s (handbook)", "1", p.M_M, 0.1, 1, tada_M_M)});
}

void add_table_and_text(Rows& rows) {
  const Printed p;
  const StiffnessResult result = corrected_example(p.a);
  const double sound_sum = 3.407e-10 + 2.359e-10 + 6.906e-10;
  const double cracked_sum = 3.558e-10 + 2.359e-10 + 6.906e-10;
  rows.push_back({.id = "T1",
                  .quantity = "w_0 i_h against d_1/2",
                  .unit = "mm",
                  .own = p.w_0 * p.i_h,
                  .corrected = p.d_1 / 2,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "deflection, ratio and diameter agree"});
  const double isotropic = p.E / (2 * (1 + p.nu));
  rows.push_back({.id = "T2",
                  .quantity = "shear modulus",
                  .unit = "MPa",
                  .printed = p.mu,
                  .own = isotropic,
                  .corrected = isotropic,
                  .verdict = AuditVerdict::ambiguous,
                  .sentence = fmt::format("E, mu and nu contradict each other by {:.0f} %",
                                          100 * (isotropic / p.mu - 1)),
                  .reproduce = reproducing("nu", "1", p.mu, 0.1, 0.49,
                                           [&](double nu) { return p.E / (2 * (1 + nu)); })});
  rows.push_back({.id = "T3",
                  .quantity = "crack parameter Q",
                  .unit = "1",
                  .printed = p.Q,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "that of a semi-ellipse of this aspect ratio",
                  .reproduce = reproducing("a/c", "1", p.Q, 0.1, 1, [](double rho) {
                    return sif::NewmanRaju(rho).shape_parameter();
                  })});
  const Tube tube{.outer_diameter = p.d_1, .inner_diameter = p.d_1 - 2 * p.delta, .length = p.L};
  rows.push_back(
      {.id = "T4",
       .quantity = "1 - (1 - 2 c_delta)^4, c_delta = 0.014",
       .unit = "1",
       .own = 1 - std::pow(1 - 2 * p.delta / p.d_1, 4),
       .corrected = 32 * p.L / (pi * p.mu * torsional_compliance(tube, p.mu) * std::pow(p.d_1, 4)),
       .verdict = AuditVerdict::reproduced,
       .sentence = "wall thickness and diameter agree"});
  rows.push_back({.id = "T5",
                  .quantity = "d_e = d_s - 2a",
                  .unit = "mm",
                  .printed = 59.8,
                  .own = p.d_s - 2 * p.a,
                  .corrected = p.d_s - 2 * p.a,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "follows from the printed d_s"});
  rows.push_back({.id = "T6",
                  .quantity = "total compliance, no cracks",
                  .unit = kCompliance,
                  .printed = 12.672e-10,
                  .own = sound_sum,
                  .corrected = compliance_in_mm(result.intact.compliance.total),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed members"});
  rows.push_back({.id = "T7",
                  .quantity = "total compliance, with cracks",
                  .unit = kCompliance,
                  .printed = 12.823e-10,
                  .own = cracked_sum,
                  .corrected = compliance_in_mm(result.positive.compliance.total),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed members"});
  rows.push_back({.id = "T8",
                  .quantity = "K_HD, no cracks",
                  .unit = "N*mm/rad",
                  .printed = 7.890e10,
                  .own = article::drive_stiffness(3.407e-10, 2.359e-10, 6.906e-10),
                  .corrected = stiffness_in_mm(result.intact.stiffness),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "the exponent is 8, and the last digit rounds to 7.891"});
  rows.push_back({.id = "T9",
                  .quantity = "K_HD, with cracks",
                  .unit = "N*mm/rad",
                  .printed = 7.798e10,
                  .own = article::drive_stiffness(3.558e-10, 2.359e-10, 6.906e-10),
                  .corrected = stiffness_in_mm(result.positive.stiffness),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "the exponent is 8"});
  const auto loss_percent = [](const StiffnessResult& r) {
    return -100 * r.positive.stiffness_change.value;
  };
  rows.push_back(
      {.id = "T10",
       .quantity = "loss of stiffness by cracks of 0.1 mm",
       .unit = "%",
       .printed = 1.2,
       .own = 100 * (1 - sound_sum / cracked_sum),
       .corrected = loss_percent(result),
       .verdict = AuditVerdict::physics,
       .sentence = "the arithmetic of the printed sums; the input is the depth of an annular shaft "
                   "crack that would do it",
       .reproduce = reproducing("shaft crack depth", "mm", 1.2, 0.1, 9, [&](double depth) {
         return loss_percent(torsional_stiffness(example(p.a * units::mm, depth * units::mm)));
       })});
  const auto share = [&](const char* id, const char* member, double printed, double part,
                         Quantity Compliances::*of) {
    rows.push_back({.id = id,
                    .quantity = fmt::format("share of the {}", member),
                    .unit = "%",
                    .printed = printed,
                    .own = 100 * part / cracked_sum,
                    .corrected = 100 * (result.positive.compliance.*of).value /
                                 result.positive.compliance.total.value,
                    .verdict = AuditVerdict::reproduced,
                    .sentence = "follows from the printed members, which do not follow from the "
                                "printed inputs"});
  };
  share("T11", "output shaft", 54, 6.906e-10, &Compliances::output_shaft);
  share("T12", "wave generator", 28, 3.558e-10, &Compliances::wave_generator);
  share("T13", "flexspline", 18, 2.359e-10, &Compliances::flexspline);
  rows.push_back({.id = "T14",
                  .quantity = "loss of stiffness by cracks of 2 mm",
                  .unit = "%",
                  .corrected = loss_percent(corrected_example(2)),
                  .verdict = AuditVerdict::physics,
                  .sentence =
                      "\"even small cracks measurably affect the stiffness\" does not hold: "
                      "this is what cracks twenty times larger do"});
}

// --- Writers ----------------------------------------------------------------------------------

std::string number(const std::optional<double>& value) {
  if (!value) return "-";
  return std::abs(*value) < 1e-25 ? "0" : fmt::format("{:.5g}", *value);
}

std::string reproduce_text(const AuditRow& row) {
  if (!row.reproduce) return {};
  const ReproducingInput& r = *row.reproduce;
  return fmt::format("{} = {:.6g}{}{}", r.name, r.value, r.unit == "1" ? "" : " ",
                     r.unit == "1" ? "" : r.unit);
}

}  // namespace

std::optional<double> AuditRow::ratio() const {
  const auto quotient = [](const std::optional<double>& a,
                           const std::optional<double>& b) -> std::optional<double> {
    if (!a || !b || *b == 0) return std::nullopt;
    return *a / *b;
  };
  return printed ? quotient(printed, own) : quotient(own, corrected);
}

std::vector<AuditRow> audit() {
  Rows rows;
  add_fracture_mechanics(rows);
  add_wave_generator(rows);
  add_flexspline(rows);
  add_output_shaft(rows);
  add_table_and_text(rows);
  return rows;
}

std::string audit_text(std::span<const AuditRow> rows) {
  constexpr std::size_t kWidth = 108;
  std::string text =
      "The article's worked example, number by number.  Units N, mm, MPa, rad.\n"
      "printed: in the article; own: its own printed equation with its printed inputs; corrected:\n"
      "the corrected theory; ratio: printed/own, or own/corrected where nothing is printed.\n\n";
  text += fmt::format("{:<5}{:<46}{:>12}{:>12}{:>12}{:>11}  {}\n", "", "", "printed", "own",
                      "corrected", "ratio", "unit");
  for (const AuditRow& row : rows) {
    const std::string unit = row.unit == "1" ? "" : fmt::format("  {}", row.unit);
    text += fmt::format("{:<5}{:<46}{:>12}{:>12}{:>12}{:>11}{}\n", row.id, row.quantity,
                        number(row.printed), number(row.own), number(row.corrected),
                        number(row.ratio()), unit);
    std::string remark = fmt::format("{}: {}", enum_name(row.verdict), row.sentence);
    if (row.reproduce) remark += fmt::format("; reproduced by {}", reproduce_text(row));
    text += fmt::format("     {}\n", wrapped(remark, kWidth - 5, 5));
  }
  std::array<int, EnumNames<AuditVerdict>::names.size()> counts{};
  for (const AuditRow& row : rows) ++counts[static_cast<std::size_t>(row.verdict)];
  text += fmt::format("\n{} rows:", rows.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
    text +=
        fmt::format("{} {} {}", i == 0 ? "" : ",", counts[i], EnumNames<AuditVerdict>::names[i]);
  return text + "\n";
}

std::string audit_json(std::span<const AuditRow> rows) {
  using Json = nlohmann::ordered_json;
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  Json json = Json::array();
  for (const AuditRow& row : rows) {
    Json entry = {{"id", row.id},
                  {"quantity", row.quantity},
                  {"unit", row.unit},
                  {"printed", optional(row.printed)},
                  {"own_equation", optional(row.own)},
                  {"corrected", optional(row.corrected)},
                  {"ratio", optional(row.ratio())},
                  {"verdict", enum_name(row.verdict)},
                  {"sentence", row.sentence}};
    entry["reproduced_by"] = row.reproduce ? Json{{"input", row.reproduce->name},
                                                  {"value", row.reproduce->value},
                                                  {"unit", row.reproduce->unit}}
                                           : Json();
    json.push_back(std::move(entry));
  }
  return json.dump(2) + "\n";
}

std::string audit_markdown(std::span<const AuditRow> rows) {
  std::string text =
      "| | quantity | unit | printed | own equation | corrected | ratio | verdict |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const AuditRow& row : rows) {
    std::string remark = fmt::format("**{}**: {}", enum_name(row.verdict), row.sentence);
    if (row.reproduce) remark += fmt::format("; reproduced by {}", reproduce_text(row));
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.id, row.quantity,
                        row.unit == "1" ? "" : row.unit, number(row.printed), number(row.own),
                        number(row.corrected), number(row.ratio()), remark);
  }
  return text;
}

}  // namespace strainwave

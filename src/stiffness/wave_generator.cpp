// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "member_support.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// A quantity, the accuracy of its model, and the power of the lobe force that is in it.
struct Estimate {
  double value = 0.0;
  ModelAccuracy accuracy;
  double force_exponent = 0.0;
};

/// Radial compliance of one lobe, C_0 [m/N].
Estimate lobe_compliance(const GearSet& gear, const ElasticConstants& steel, double lobe_force,
                         MemberCompliance& member) {
  const SeriesModel<double> model(gear);
  const WaveGenerator& wg = *gear.wave_generator;
  const double C_0 = model.lobe_compliance(steel, lobe_force);
  if (wg.radial_stiffness) return {C_0, {}};
  if (wg.displacements) {
    if (wg.displacements->shaft > 0 && gear.drive.wave_number >= 2)
      member.notes.push_back({"wave_generator.shaft_bending",
                              "the forces of evenly spaced lobes balance: the shaft does not bend, "
                              "and this displacement ought to be 0",
                              "wave_generator.displacements.shaft", "ST-8"});
    use_equation(member.equations, "ST-8");
    return {C_0, {}, -1.0};
  }
  for (const char* const tag : {"ST-9", "CO-1", "CO-2", "CO-3", "CO-4"})
    use_equation(member.equations, tag);
  member.notes.push_back(
      {"wave_generator.hertz",
       fmt::format(
           "the contacts are not linear: stiffness is the tangent at the given torque, at "
           "{:.3g} MPa peak pressure on the inner race; the wind-up takes this tangent too, "
           "and its contact part is a third short; cam and inner ring are rigid",
           model.ball_contacts(steel, lobe_force).inner.peak_pressure / 1e6),
       "wave_generator.bearing", "ST-9"});
  if (model.free_outer_ring()) {
    use_equation(member.equations, "ST-10");
    member.notes.push_back({"wave_generator.free_ring",
                            "the outer ring is taken as free between the lobes, an upper bound: in "
                            "a drive it lies in the flexspline and on all balls",
                            "wave_generator.bearing.outer_ring", "ST-10"});
  } else if (wg.bearing->outer_ring) {
    member.notes.push_back(
        {"wave_generator.held_ring",
         "the outer ring lies on all balls and in the flexspline: its bending is "
         "left out here, since a ring free between the lobes would be many times "
         "too soft; the torsion curve has the ring as it is held",
         "wave_generator.bearing.outer_ring", "ST-10"});
  }
  return {C_0, accuracy::kLoadSharing, -1.0 / 3};  // (CO-4): C_0 of a contact ~ force^(-1/3)
}

/// Hoop stress at the crack per unit of lobe force, and how far it can be trusted [1/m^2].  The
/// compliance goes with its square, so with twice its uncertainty.
template <class Crack>
Estimate unit_stress(const GearSet& gear, const ElasticConstants& steel, double lobe_force,
                     const Crack& crack, const std::string& path, MemberCompliance& member) {
  const double stress = SeriesModel<double>(gear).unit_stress(crack, steel, lobe_force);
  switch (crack.stress_driver) {
    case StressDriver::orthogonal_shear:
      if (!crack.contact_factor) use_equation(member.equations, "CO-5");
      for (const char* const tag : {"ST-12", "CO-3"}) use_equation(member.equations, tag);
      member.notes.push_back(
          {"crack.orthogonal_shear",
           "half beta times the contact pressure is a subsurface shear stress; taken for a hoop "
           "tension, as the article does, it gives an order of magnitude at best",
           path, "ST-12"});
      return {stress, accuracy::kOrthogonalShear};
    case StressDriver::contact_edge:
      for (const char* const tag : {"CO-7", "CO-3"}) use_equation(member.equations, tag);
      member.notes.push_back(
          {"crack.contact_edge",
           "the tension at the edge of the contact decays like 1/r^2; taken as uniform over the "
           "crack, it is an upper bound",
           path, "CO-7"});
      return {stress, accuracy::kContactEdge};
    case StressDriver::ring_bending:
      use_equation(member.equations, "ST-13");
      member.notes.push_back(
          {"crack.ring_bending",
           "a free ring under the lobe forces: its bore is in tension there, its raceway in "
           "compression, so this is for a crack at the bore; the cam inside makes it an upper "
           "bound, and a surface crack takes the stress as uniform",
           path, "ST-13"});
      return {stress, accuracy::kRingBending};
    case StressDriver::given:
      break;
  }
  return {stress, accuracy::kGivenStress, -1.0};
}

/// Relative uncertainties of what a race crack adds, and of its K.
struct RaceAccuracy {
  double compliance = 0.0;
  double intensity = 0.0;
};

/// Adds one race crack: its radial compliance times `at_output` is its share of the drive's.
template <SweptCrack Crack>
void add_race_crack(MemberCompliance& member, CrackReport report, const Crack& crack,
                    const GearSet& gear, const CrackModuli& moduli, double lobe_force,
                    double at_output, const RaceAccuracy& accuracy,
                    const StiffnessOptions& options) {
  const WaveGenerator& wg = *gear.wave_generator;
  const auto added = added_compliance(crack, moduli, options.quadrature);
  demand_convergence(member, report, added.relative_error, added.converged);
  const Quantity at{at_output * added.matrix(0, 0), kComplianceUnit, accuracy.compliance};
  report.positive.at_output = at;
  report.negative.at_output = at;
  const double depth = crack.size();
  report_intensities(report, member, crack, {lobe_force}, moduli, all_modes(accuracy.intensity),
                     gear.material.at(wg.material), Constraint::plane_strain,
                     *wg.inner_ring_thickness - depth);
  member.cracks.push_back(std::move(report));
}

}  // namespace

RaceContacts race_contacts(const Bearing& bearing, const ElasticConstants& steel) {
  const auto [inner, outer] = race_contacts_of(Lift<double>(), bearing, steel);
  return {inner, outer};
}

double lobe_force_per_torque(const Transmission& drive, const WaveGenerator& wg) {
  return lobe_force_per_torque_of(Lift<double>(), drive, wg);
}

MemberCompliance wave_generator_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const WaveGenerator& wg = *gear.wave_generator;
  const SeriesModel<double> model(gear);
  const ElasticConstants steel =
      elastic_constants(material_of(gear, wg.material, "wave_generator.material"));
  const double lobe_force = model.lobe_force();

  MemberCompliance member;
  use_equation(member.equations, "ST-5");
  const Estimate C_0 = lobe_compliance(gear, steel, lobe_force, member);

  const auto conversion = model.conversion();
  const bool cam = wg.conversion == Conversion::cam;
  if (cam)
    member.notes.push_back(
        {"wave_generator.cam_conversion",
         "turning the cam back over its mean slope does not obey reciprocity with the lobe force, "
         "and answers another question: the input is not locked",
         "wave_generator.conversion", "ST-7"});
  use_equation(member.equations, cam ? "ST-7" : "ST-6");
  member.intact = conversion.all_lobes * C_0.value;
  // The conversion by reciprocity has the lobe force squared in it, the article's has none.
  const double conversion_exponent = cam ? 0.0 : 2.0;
  const ModelAccuracy of_force =
      accuracy::power(accuracy::kLobeForce, std::abs(conversion_exponent + C_0.force_exponent));
  member.relative_uncertainty = accuracy::combined(of_force, C_0.accuracy);
  if (of_force > 0) rest_on(member, "wave_generator", of_force);
  if (cam) {
    member.relative_uncertainty =
        accuracy::combined(member.relative_uncertainty, accuracy::kCamConversion);
    rest_on(member, "wave_generator.conversion", accuracy::kCamConversion);
  }
  if (C_0.accuracy > 0) rest_on(member, "wave_generator.bearing", C_0.accuracy);

  const CrackModuli moduli = SeriesModel<double>::plane_strain(steel);
  for (std::size_t i = 0; i < wg.crack.size(); ++i) {
    CrackReport report{.path = fmt::format("wave_generator.crack[{}]", i)};
    std::visit(
        [&](const auto& crack) {
          using Crack = std::decay_t<decltype(crack)>;
          if constexpr (std::is_same_v<Crack, OuterRaceCrack>) {
            note_contact_path(member.notes, report.path);
          } else {
            report.kind = Crack::kKind;
            const double t = *wg.inner_ring_thickness;
            const Estimate stress =
                unit_stress(gear, steel, lobe_force, crack, report.path, member);
            // Compliance goes with the square of the stress, K with the stress.
            const double stress_exponent = 1 + stress.force_exponent;  // of the force, in K
            const ModelAccuracy of_stress = accuracy::power(stress.accuracy, 2);
            const ModelAccuracy of_load = accuracy::power(
                accuracy::kLobeForce, std::abs(conversion_exponent + 2 * stress.force_exponent));
            rest_on(member, report.path, of_stress);
            if (of_load > 0) rest_on(member, report.path, of_load);
            const auto race_accuracy = [&](double of_crack) {
              const double compliance = accuracy::combined(
                  accuracy::combined(of_crack, of_stress),
                  cam ? accuracy::combined(of_load, accuracy::kCamConversion) : double{of_load});
              const double intensity =
                  accuracy::combined(accuracy::combined(of_crack / 2, stress.accuracy),
                                     stress_exponent * accuracy::kLobeForce);
              return RaceAccuracy{compliance, intensity};
            };
            // The lobe force has one sense, whatever the sense of the torque.
            const bool open = stress.value >= 0;
            report.opens_under = stress.value > 0 ? OpensUnder::both : OpensUnder::neither;
            if (!open) {
              use_equation(member.equations, "FR-17");
              member.notes.push_back({"crack.closed",
                                      "the stress presses the faces together: the crack adds "
                                      "nothing",
                                      report.path, "FR-17"});
            }
            if constexpr (std::is_same_v<Crack, RaceSurfaceCrack>) {
              const ModelAccuracy fit =
                  surface_crack_fit(member, report.path, crack.depth, crack.aspect_ratio, t);
              for (const char* const tag : {"FR-2", "FR-3", "FR-4", "FR-5", "FR-18"})
                use_equation(member.equations, tag);
              add_race_crack(member, report, model.race_crack(crack, steel, stress.value), gear,
                             moduli, lobe_force, conversion.one_lobe, race_accuracy(fit), options);
            } else {
              rest_on(member, report.path, accuracy::kEdgeCrack);
              for (const char* const tag : {"FR-2", "FR-11", "FR-18"})
                use_equation(member.equations, tag);
              add_race_crack(member, report, model.race_crack(crack, steel, stress.value), gear,
                             moduli, lobe_force, conversion.one_lobe,
                             race_accuracy(accuracy::kEdgeCrack), options);
            }
          }
        },
        wg.crack[i]);
  }
  if (!member.cracks.empty())
    member.notes.push_back({"wave_generator.crack_under_lobe",
                            "each crack is taken under the full force of one lobe; the inner ring "
                            "turns with the cam, so it stays at its place relative to the lobe",
                            "wave_generator.crack", "ST-6"});
  note_superposition(member.notes, member.cracks.size(), "wave_generator.crack");
  return member;
}

}  // namespace strainwave

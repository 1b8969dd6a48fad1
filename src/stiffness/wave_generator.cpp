// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "member_support.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/fracture/edge_crack.hpp"
#include "strainwave/fracture/surface_crack.hpp"
#include "strainwave/stiffness/accuracy.hpp"
#include "strainwave/stiffness/elastic_members.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A quantity, the accuracy of its model, and the power of the lobe force that is in it.
struct Estimate {
  double value = 0.0;
  ModelAccuracy accuracy;
  double force_exponent = 0.0;
};

/// Hertz contacts of one ball with the inner and the outer race, under its share of the lobe force.
struct BallContacts {
  HertzContact inner;
  HertzContact outer;
};

BallContacts ball_contacts(const Bearing& bearing, const ElasticConstants& steel,
                           double lobe_force) {
  const RaceContacts contacts = race_contacts(bearing, steel);
  const double ball_force = lobe_force / bearing.loaded_balls;
  return {.inner = hertz_contact(contacts.inner, ball_force),
          .outer = hertz_contact(contacts.outer, ball_force)};
}

/// Radial compliance of one lobe, C_0 [m/N].
Estimate lobe_compliance(const GearSet& gear, const ElasticConstants& steel, double lobe_force,
                         MemberCompliance& member) {
  const WaveGenerator& wg = *gear.wave_generator;
  if (wg.radial_stiffness) return {1 / *wg.radial_stiffness, {}};
  if (wg.displacements) {
    const LobeDisplacements& d = *wg.displacements;
    if (d.shaft > 0 && gear.drive.wave_number >= 2)
      member.notes.push_back({"wave_generator.shaft_bending",
                              "the forces of evenly spaced lobes balance: the shaft does not bend, "
                              "and this displacement ought to be 0",
                              "wave_generator.displacements.shaft", "ST-8"});
    use_equation(member.equations, "ST-8");
    return {(d.bearing + d.cam + d.shaft) / lobe_force, {}, -1.0};  // (ST-8)
  }
  const Bearing& bearing = *wg.bearing;
  const auto [inner, outer] = ball_contacts(bearing, steel, lobe_force);
  // (ST-9): contacts in series, balls in parallel, linearised at the given load.
  double C = (1 / inner.tangent_stiffness + 1 / outer.tangent_stiffness) / bearing.loaded_balls;
  for (const char* const tag : {"ST-9", "CO-1", "CO-2", "CO-3", "CO-4"})
    use_equation(member.equations, tag);
  member.notes.push_back(
      {"wave_generator.hertz",
       fmt::format(
           "the contacts are not linear: stiffness is the tangent at the given torque, at "
           "{:.3g} MPa peak pressure on the inner race; the wind-up takes this tangent too, "
           "and its contact part is a third short; cam and inner ring are rigid",
           inner.peak_pressure / 1e6),
       "wave_generator.bearing", "ST-9"});
  if (bearing.outer_ring && bearing.ball_count) {
    member.notes.push_back(
        {"wave_generator.held_ring",
         "the outer ring lies on all balls and in the flexspline: its bending is "
         "left out here, since a ring free between the lobes would be many times "
         "too soft; the torsion curve has the ring as it is held",
         "wave_generator.bearing.outer_ring", "ST-10"});
  } else if (bearing.outer_ring) {
    const BearingRing& ring = *bearing.outer_ring;
    C += ring_compliance(gear.drive.wave_number, ring.mean_radius,
                         steel.E * ring.width * std::pow(ring.thickness, 3) / 12);
    use_equation(member.equations, "ST-10");
    member.notes.push_back({"wave_generator.free_ring",
                            "the outer ring is taken as free between the lobes, an upper bound: in "
                            "a drive it lies in the flexspline and on all balls",
                            "wave_generator.bearing.outer_ring", "ST-10"});
  }
  return {C, accuracy::kLoadSharing, -1.0 / 3};  // (CO-4): compliance of a contact ~ force^(-1/3)
}

/// Hoop stress at the crack per unit of lobe force, and how far it can be trusted [1/m^2].  The
/// compliance goes with its square, so with twice its uncertainty.
class UnitStress {
 public:
  UnitStress(const GearSet& gear, const ElasticConstants& steel, double lobe_force)
      : gear_(gear), steel_(steel), lobe_force_(lobe_force) {}

  template <class Crack>
  Estimate operator()(const Crack& crack, const std::string& path, MemberCompliance& member) const {
    switch (crack.stress_driver) {
      case StressDriver::orthogonal_shear: {
        const auto [a, b] = semi_axes();
        const double beta =
            crack.contact_factor ? *crack.contact_factor : orthogonal_shear_factor(b / a);
        if (!crack.contact_factor) use_equation(member.equations, "CO-5");
        for (const char* const tag : {"ST-12", "CO-3"}) use_equation(member.equations, tag);
        member.notes.push_back(
            {"crack.orthogonal_shear",
             "half beta times the contact pressure is a subsurface shear stress; taken for a hoop "
             "tension, as the article does, it gives an order of magnitude at best",
             path, "ST-12"});
        return {beta / 2 * pressure_per_force(a, b), accuracy::kOrthogonalShear};  // (ST-12)
      }
      case StressDriver::contact_edge: {
        const auto [a, b] = semi_axes();
        for (const char* const tag : {"CO-7", "CO-3"}) use_equation(member.equations, tag);
        member.notes.push_back(
            {"crack.contact_edge",
             "the tension at the edge of the contact decays like 1/r^2; taken as uniform over the "
             "crack, it is an upper bound",
             path, "CO-7"});
        return {edge_tension(b / a, steel_.nu).minor_end * pressure_per_force(a, b),
                accuracy::kContactEdge};
      }
      case StressDriver::ring_bending: {
        const WaveGenerator& wg = *gear_.wave_generator;
        const double t = *wg.inner_ring_thickness;
        use_equation(member.equations, "ST-13");
        member.notes.push_back(
            {"crack.ring_bending",
             "a free ring under the lobe forces: its bore is in tension there, its raceway in "
             "compression, so this is for a crack at the bore; the cam inside makes it an upper "
             "bound, and a surface crack takes the stress as uniform",
             path, "ST-13"});
        return {6 * ring_moment_factor(gear_.drive.wave_number) * *wg.inner_ring_mean_radius /
                    (*wg.inner_ring_width * t * t),
                accuracy::kRingBending};  // (ST-13)
      }
      case StressDriver::given:
        break;
    }
    return {*crack.stress / lobe_force_, accuracy::kGivenStress, -1.0};
  }

 private:
  [[nodiscard]] std::array<double, 2> semi_axes() const {
    const WaveGenerator& wg = *gear_.wave_generator;
    if (wg.contact_semi_axes) return *wg.contact_semi_axes;
    const HertzContact inner = ball_contacts(*wg.bearing, steel_, lobe_force_).inner;
    return {inner.major_semi_axis, inner.minor_semi_axis};
  }

  /// Peak pressure per unit of lobe force, of the ball that carries the crack.
  [[nodiscard]] double pressure_per_force(double a, double b) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const double share = wg.bearing ? 1 / wg.bearing->loaded_balls : 1.0;
    return peak_pressure(share, a, b);
  }

  const GearSet& gear_;
  const ElasticConstants& steel_;
  double lobe_force_;
};

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
  const double D = bearing.ball_diameter;
  // Ball and races of one material: 1/E* = 2 (1 - nu^2)/E.
  const double contact_modulus = steel.plane_strain_modulus() / 2;
  const auto contact = [&](double race_curvature, double conformity) {
    // (CO-1): across the groove, and along the rolling direction.
    return PointContact{.curvature_sums = {2 / D - 1 / (conformity * D), 2 / D + race_curvature},
                        .contact_modulus = contact_modulus};
  };
  return {.inner = contact(2 / bearing.inner_raceway_diameter, bearing.inner_conformity),
          .outer = contact(-2 / bearing.outer_raceway_diameter, bearing.outer_conformity)};
}

double lobe_force_per_torque(const Transmission& drive, const WaveGenerator& wg) {
  return 2 * wg.load_factor * wg.force_transmission_coefficient /
         (drive.wave_number * drive.pitch_diameter);  // (ST-5)
}

MemberCompliance wave_generator_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const WaveGenerator& wg = *gear.wave_generator;
  const Transmission& drive = gear.drive;
  const int U = drive.wave_number;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, wg.material, "wave_generator.material"));
  const double f = lobe_force_per_torque(drive, wg);
  const double lobe_force = f * std::abs(gear.load.torque);

  MemberCompliance member;
  use_equation(member.equations, "ST-5");
  const Estimate C_0 = lobe_compliance(gear, steel, lobe_force, member);

  // Output compliance per unit of compliance of one lobe, and of all lobes.
  double one_lobe = f * f;       // (ST-6)
  double all_lobes = U * f * f;  // (ST-6)
  if (wg.conversion == Conversion::cam) {
    // (ST-7): the article's, where one compliance stands for the whole wave generator.
    one_lobe = wg.force_transmission_coefficient * pi /
               (2 * drive.pitch_diameter * U * drive.radial_displacement * drive.ratio);
    all_lobes = one_lobe;
    member.notes.push_back(
        {"wave_generator.cam_conversion",
         "turning the cam back over its mean slope does not obey reciprocity with the lobe force, "
         "and answers another question: the input is not locked",
         "wave_generator.conversion", "ST-7"});
  }
  use_equation(member.equations, wg.conversion == Conversion::cam ? "ST-7" : "ST-6");
  member.intact = all_lobes * C_0.value;
  const bool cam = wg.conversion == Conversion::cam;
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

  const UnitStress unit_stress(gear, steel, lobe_force);
  const CrackModuli moduli{.opening = steel.plane_strain_modulus(), .shear = steel.G};
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
            const Estimate stress = unit_stress(crack, report.path, member);
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
              add_race_crack(member, report,
                             SurfaceCrack<1>({.depth = crack.depth,
                                              .aspect_ratio = crack.aspect_ratio,
                                              .thickness = t,
                                              .poissons_ratio = steel.nu,
                                              .normal_stress = {stress.value},
                                              .open = open}),
                             gear, moduli, lobe_force, one_lobe, race_accuracy(fit), options);
            } else {
              rest_on(member, report.path, accuracy::kEdgeCrack);
              for (const char* const tag : {"FR-2", "FR-11", "FR-18"})
                use_equation(member.equations, tag);
              const bool bending = crack.stress_driver == StressDriver::ring_bending;
              add_race_crack(
                  member, report,
                  EdgeCrack{.depth = crack.depth,
                            .thickness = t,
                            .width = *wg.inner_ring_width,
                            .unit_stress = stress.value,
                            .loading = bending ? StripLoading::bending : StripLoading::tension,
                            .open = open},
                  gear, moduli, lobe_force, one_lobe, race_accuracy(accuracy::kEdgeCrack), options);
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

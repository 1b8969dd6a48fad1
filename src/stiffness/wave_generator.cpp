// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "member_support.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// A quantity, the accuracy of its model, and its power of the lobe force.
struct Estimate {
  double value = 0.0;
  ModelAccuracy accuracy;
  double force_exponent = 0.0;
};

/// Radial compliance of one lobe by Hertz contacts, C_0 [m/N].
/// @param left_out  severity of notes on effects that only the coupled drive contains
Estimate hertz_compliance(const GearSet& gear, const SeriesModel<double>& model,
                          MemberCompliance& member, Severity left_out) {
  use_equations(member.equations, {"ST-9", "CO-1", "CO-2", "CO-3", "CO-4"});
  member.notes.push_back(
      {.code = "wave_generator.hertz",
       .text = fmt::format(
           "the contacts are not linear; the stiffness is the tangent at the given torque, where "
           "the peak pressure on the inner race is {}; the wind-up uses this tangent too, "
           "which makes its contact part a third too small; cam and inner ring are assumed rigid",
           shown_quantity(model.ball_contacts().inner.peak_pressure, "Pa", 3)),
       .path = "wave_generator.bearing",
       .equation = "ST-9",
       .severity = left_out});
  if (model.free_outer_ring()) {
    use_equations(member.equations, {"ST-10"});
    member.notes.push_back(
        {.code = "wave_generator.free_ring",
         .text = "the outer ring is assumed free between the lobes, which is an upper bound, "
                 "because in a drive the ring lies in the flexspline and on all balls",
         .path = "wave_generator.bearing.outer_ring",
         .equation = "ST-10",
         .severity = Severity::care,
         .next_step = "Give ball_count and run strainwave torsion."});
  } else if (gear.wave_generator->bearing->outer_ring) {
    member.notes.push_back(
        {.code = "wave_generator.held_ring",
         .text = "the outer ring lies on all balls and in the flexspline; its bending is left out "
                 "here, because a ring free between the lobes would be many times too soft",
         .path = "wave_generator.bearing.outer_ring",
         .equation = "ST-10",
         .severity = left_out,
         .next_step = "Run strainwave torsion, which models the ring with its supports."});
  }
  return {model.lobe_compliance(), accuracy::kLoadSharing, -1.0 / 3};  // (CO-4): ~ force^(-1/3)
}

/// Radial compliance of one lobe, C_0 [m/N].
Estimate lobe_compliance(const GearSet& gear, const SeriesModel<double>& model,
                         MemberCompliance& member, Severity left_out) {
  const WaveGenerator& wg = *gear.wave_generator;
  if (wg.radial_stiffness) return {model.lobe_compliance(), {}};
  if (!wg.displacements) return hertz_compliance(gear, model, member, left_out);
  if (wg.displacements->shaft > 0 && gear.drive.wave_number >= 2)
    member.notes.push_back({.code = "wave_generator.shaft_bending",
                            .text = "the forces of evenly spaced lobes balance, so the shaft does "
                                    "not bend and this displacement should be 0",
                            .path = "wave_generator.displacements.shaft",
                            .equation = "ST-8",
                            .severity = Severity::care,
                            .next_step = "Set wave_generator.displacements.shaft to 0."});
  use_equations(member.equations, {"ST-8"});
  return {model.lobe_compliance(), {}, -1.0};
}

/// The stress model of a race crack: equations, a note, and its accuracy.
struct Driver {
  std::vector<const char*> equations;
  std::optional<Note> note;
  ModelAccuracy accuracy;
  double force_exponent = 0.0;  ///< exponent of the lobe force in the stress per unit of lobe force
};

template <class Crack>
Driver driver_of(const Crack& crack, const std::string& path) {
  const auto upper_bound = [&](const char* code, const char* text, const char* equation) {
    return Note{
        .code = code, .text = text, .path = path, .equation = equation, .severity = Severity::care};
  };
  switch (crack.stress_driver) {
    case StressDriver::orthogonal_shear: {
      Driver driver{
          .equations = {"ST-12", "CO-3"},
          .note = upper_bound(
              "crack.orthogonal_shear",
              "half beta times the contact pressure is a subsurface shear stress; the article uses "
              "this stress as a hoop tension, which gives an order of magnitude at best",
              "ST-12"),
          .accuracy = accuracy::kOrthogonalShear};
      driver.note->next_step =
          "Choose contact_edge, which the torsion curve contains too. Or give the hoop stress with "
          "stress_driver = \"given\"; the torsion curve leaves such a crack out.";
      if (!crack.contact_factor) driver.equations.insert(driver.equations.begin(), "CO-5");
      return driver;
    }
    case StressDriver::contact_edge:
      return {.equations = {"CO-7", "CO-3"},
              .note = upper_bound("crack.contact_edge",
                                  "the tension at the edge of the contact decays like 1/r^2, but "
                                  "is assumed uniform over the crack, which is an upper bound",
                                  "CO-7"),
              .accuracy = accuracy::kContactEdge};
    case StressDriver::ring_bending:
      return {.equations = {"ST-13"},
              .note = upper_bound(
                  "crack.ring_bending",
                  "the model is a free ring under the lobe forces, whose bore is in tension at the "
                  "lobes and whose raceway is in compression, so the result is for a crack at the "
                  "bore; because of the cam inside, the result is an upper bound",
                  "ST-13"),
              .accuracy = accuracy::kRingBending};
    case StressDriver::given:
      break;
  }
  return {.equations = {}, .note = {}, .accuracy = accuracy::kGivenStress, .force_exponent = -1.0};
}

/// Largest a/t at which the model of a ring with an edge crack is valid [-]; (FR-11).
constexpr double kDeepEdgeCrack = 0.8;

/// Reports the cracks of the bearing's races, with separate notes for each kind.
class RaceCracks : public CrackAdder {
 public:
  explicit RaceCracks(const CrackAdder& adder) : CrackAdder(adder) {}

  void add(const CrackReport& report, const RaceSurfaceCrack& crack,
           const LoadedCrack<sif::SurfaceCrack<1>>& loaded) {
    if (crack.stress_driver == StressDriver::ring_bending) use({"SP-3"});
    if (gear.wave_generator->inner_ring_width) use({"SP-1"});
    add_race_crack(report, crack, loaded, {"FR-2", "FR-3", "FR-4", "FR-5", "FR-18"}, [&] {
      const ModelAccuracy fit =
          surface_crack_fit(member, report.path, crack.depth, crack.aspect_ratio,
                            *gear.wave_generator->inner_ring_thickness);
      return ModelAccuracy{
          accuracy::combined(fit, beyond_width_range(report.path, crack, loaded.solution)),
          fit.source};
    });
  }
  void add(const CrackReport& report, const RaceEdgeCrack& crack,
           const LoadedCrack<sif::EdgeCrack>& loaded) {
    add_race_crack(report, crack, loaded, {"FR-2", "FR-11", "FR-18"}, [&] {
      note_depth(report.path, crack.depth);
      rest_on(member, report.path, accuracy::kEdgeCrack);
      return accuracy::kEdgeCrack;
    });
  }

 private:
  void note_depth(const std::string& path, double depth) {
    const double thickness = *gear.wave_generator->inner_ring_thickness;
    demand_ligament(member, path, depth, thickness);
    if (clearly_less(kDeepEdgeCrack * thickness, depth))
      member.notes.push_back(
          {.code = "crack.edge_range",
           .text = fmt::format(
               "a/t = {:.3g}: beyond {:g} the cracked section acts like a hinge, "
               "and the support by the cam determines the result, which is extrapolated",
               depth / thickness, kDeepEdgeCrack),
           .path = path,
           .equation = "FR-11",
           .severity = Severity::care});
  }

  /// Relative uncertainty of the compliance by the width factor beyond its range, f_w^2 - 1 [-],
  /// with a note; 0 in the range.
  double beyond_width_range(const std::string& path, const RaceSurfaceCrack& crack,
                            const sif::SurfaceCrack<1>& solution) {
    const auto& width = gear.wave_generator->inner_ring_width;
    if (!width) return 0.0;
    const double c_b = 2 * crack.depth / crack.aspect_ratio / *width;
    if (!clearly_less(sif::kFittedWidthRatio, c_b)) return 0.0;
    const double f_w = solution.width_factor(crack.depth);
    const ModelAccuracy beyond{f_w * f_w - 1, accuracy::kBeyondWidthRange};
    rest_on(member, path, beyond);
    member.notes.push_back(
        {.code = "crack.wide",
         .text =
             fmt::format("the crack spans {:.3g} of the ring's width; beyond {:g} the width "
                         "factor, {:.3g} here, is extrapolated, and the uncertainty contains this",
                         c_b, sif::kFittedWidthRatio, f_w),
         .path = path,
         .equation = "SP-1",
         .severity = Severity::care,
         .next_step = "Compare with an edge crack of the same depth, kind = \"edge\"."});
    return beyond;
  }

  template <class Crack, class Solution, class Fit>
  void add_race_crack(CrackReport report, const Crack& crack, const LoadedCrack<Solution>& loaded,
                      std::initializer_list<const char*> equations, const Fit& accuracy_of_fit);
};

/// Adds one race crack under the stress of the lobe force.
/// @param accuracy_of_fit  accuracy of the compliance by the crack's solution, with its notes
template <class Crack, class Solution, class Fit>
void RaceCracks::add_race_crack(CrackReport report, const Crack& crack,
                                const LoadedCrack<Solution>& loaded,
                                std::initializer_list<const char*> equations,
                                const Fit& accuracy_of_fit) {
  const bool cam = gear.wave_generator->conversion == Conversion::cam;
  Driver driver = driver_of(crack, report.path);
  use_equations(member.equations, driver.equations);
  if (driver.note) member.notes.push_back(std::move(*driver.note));
  // Compliance is proportional to the square of the stress, K to the stress.
  const ModelAccuracy of_stress = accuracy::power(driver.accuracy, 2);
  const ModelAccuracy of_load = accuracy::power(
      accuracy::kLobeForce, std::abs((cam ? 0.0 : 2.0) + 2 * driver.force_exponent));
  rest_on(member, report.path, of_stress);
  if (of_load > 0) rest_on(member, report.path, of_load);
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  if (loaded.faces.positive == Faces::pressed) {
    use_equations(member.equations, {"FR-17"});
    member.notes.push_back(
        {.code = "crack.closed",
         .text = "the stress presses the faces together, so the crack adds no compliance",
         .path = report.path,
         .equation = "FR-17",
         .severity = Severity::care});
  }
  const ModelAccuracy fit = accuracy_of_fit();
  use_equations(member.equations, equations);
  const double compliance = accuracy::combined(
      accuracy::combined(fit, of_stress),
      cam ? accuracy::combined(of_load, accuracy::kCamConversion) : double{of_load});
  const double intensity = accuracy::combined(accuracy::combined(fit / 2, driver.accuracy),
                                              (1 + driver.force_exponent) * accuracy::kLobeForce);
  const auto added = closed_form(loaded, options.quadrature).positive;
  demand_convergence(member, report, added.relative_error, added.converged);
  report.positive.at_output = {model.at_output(added.matrix), kComplianceUnit, compliance};
  report.negative = report.positive;
  report_intensities(report, loaded.with_faces(loaded.faces.positive), {model.loads().lobe_force()},
                     all_modes(intensity));
  member.cracks.push_back(std::move(report));
}

/// Adds the sound wave generator: lobe compliance times conversion.
void add_sound_wave_generator(const GearSet& gear, const SeriesModel<double>& model,
                              MemberCompliance& member, Severity left_out) {
  use_equations(member.equations, {"ST-5"});
  const Estimate C_0 = lobe_compliance(gear, model, member, left_out);
  const bool cam = gear.wave_generator->conversion == Conversion::cam;
  if (cam)
    member.notes.push_back({.code = "wave_generator.cam_conversion",
                            .text = "turning the cam back over its mean slope violates reciprocity "
                                    "with the lobe force, because the input is then not locked",
                            .path = "wave_generator.conversion",
                            .equation = "ST-7",
                            .severity = Severity::care,
                            .next_step = "Leave wave_generator.conversion at its default."});
  use_equations(member.equations, {cam ? "ST-7" : "ST-6"});
  member.intact = model.conversion().all_lobes * C_0.value;
  // The conversion by reciprocity contains the square of the lobe force; the article's conversion
  // does not contain it.
  const ModelAccuracy of_force =
      accuracy::power(accuracy::kLobeForce, std::abs((cam ? 0.0 : 2.0) + C_0.force_exponent));
  member.relative_uncertainty = accuracy::combined(of_force, C_0.accuracy);
  if (of_force > 0) rest_on(member, "wave_generator", of_force);
  if (cam) {
    member.relative_uncertainty =
        accuracy::combined(member.relative_uncertainty, accuracy::kCamConversion);
    rest_on(member, "wave_generator.conversion", accuracy::kCamConversion);
  }
  if (C_0.accuracy > 0) rest_on(member, "wave_generator.bearing", C_0.accuracy);
}

}  // namespace

MemberCompliance wave_generator_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const SeriesModel<double> model(gear);
  MemberCompliance member;
  add_sound_wave_generator(gear, model, member, options.left_out());
  add_cracks(member, model.loads(), "wave_generator", gear.wave_generator->crack,
             RaceCracks({gear, model, options, member}));
  if (!member.cracks.empty())
    member.notes.push_back(
        {.code = "wave_generator.crack_under_lobe",
         .text = "each crack is assumed under the full force of one lobe; the inner ring turns "
                 "with the cam, so the crack stays at its place relative to the lobe",
         .path = "wave_generator.crack",
         .equation = "ST-6",
         .severity = Severity::information});
  note_superposition(member.notes, member.cracks.size(), "wave_generator.crack");
  return member;
}

}  // namespace strainwave

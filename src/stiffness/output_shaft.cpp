// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <utility>

#include "member_support.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// Uncertainties of an annular crack's added compliance.
struct AnnularAccuracy {
  ModelAccuracy torsion = accuracy::kAnnularTorsion;
  ModelAccuracy tension = accuracy::kAnnularTension;
  double K_I = accuracy::kAnnularTension / 2;  ///< uncertainty of the stress intensity
  double K_III = accuracy::kAnnularTorsion / 2;
};

/// Whether Poisson's ratio differs from 0.3, for which mode I was computed.
bool other_poissons_ratio(const ElasticConstants& steel) { return std::abs(steel.nu - 0.3) > 0.02; }

AnnularAccuracy annular_accuracy(const ElasticConstants& steel) {
  if (!other_poissons_ratio(steel)) return {};
  return {.tension = accuracy::kAnnularTensionOtherRatio,
          .K_I = accuracy::kAnnularTensionOtherRatio / 2};
}

/// Reports the cracks of an output shaft.
class ShaftCracks : public CrackAdder {
 public:
  explicit ShaftCracks(const CrackAdder& adder) : CrackAdder(adder) {}

  void add(CrackReport report, const AnnularCrack& crack,
           const LoadedCrack<sif::AnnularCrackSolid>& loaded);
  void add(CrackReport report, const AnnularCrack& crack,
           const LoadedCrack<sif::AnnularCrackHollow>& loaded);

 private:
  void note_load_and_ends(const CrackReport& report, const BothSenses& faces);
  AnnularAccuracy hollow_accuracy(const std::string& path);

  /// Adds one annular crack; the crack is open unless the axial force presses it together.
  template <class Solution>
  void add_annular(CrackReport report, const AnnularCrack& crack,
                   const LoadedCrack<Solution>& loaded, const AnnularAccuracy& accuracy);
};

template <class Solution>
void ShaftCracks::add_annular(CrackReport report, const AnnularCrack& crack,
                              const LoadedCrack<Solution>& loaded,
                              const AnnularAccuracy& accuracy) {
  const double P = gear.load.axial_force;
  if (loaded.table) {
    take_from_table(report, member, gear, crack, *loaded.table);
  } else {
    const auto added = closed_form(loaded, options.quadrature).positive;
    demand_convergence(member, report, added.relative_error, added.converged);
    rest_on(member, report.path, accuracy.torsion);
    if (P != 0) rest_on(member, report.path, accuracy.tension);
    report.positive.at_output = {model.at_output(added.matrix), kComplianceUnit, accuracy.torsion};
    report.positive.axial_torsion = axial_torsion(added.matrix, accuracy.tension, accuracy.torsion);
    report.negative = report.positive;
  }
  report_intensities(report, loaded.with_faces(loaded.faces.positive), {P, gear.load.torque},
                     {accuracy.K_I, 0.0, accuracy.K_III});
  member.cracks.push_back(std::move(report));
}

void ShaftCracks::note_load_and_ends(const CrackReport& report, const BothSenses& faces) {
  const OutputShaft& shaft = *gear.output_shaft;
  use({"FR-2", "FR-18"});
  if (faces.positive == Faces::pressed) {
    use({"FR-17"});
    member.notes.push_back(
        {.code = "crack.closed",
         .text = "the axial force presses the faces together, so there is no mode I; friction is "
                 "left out, although it would hinder mode III until the torque overcomes it",
         .path = report.path,
         .equation = "FR-17",
         .severity = Severity::care});
  }
  if (clearly_less(shaft.length, 2 * shaft.outer_diameter))
    member.notes.push_back({.code = "crack.short_shaft",
                            .text = "even a crack in the middle has less than one diameter of "
                                    "shaft on each side, so the ends disturb its field",
                            .path = report.path,
                            .equation = "FR-12",
                            .severity = Severity::care});
  if (other_poissons_ratio(model.loads().shaft_steel()) && gear.load.axial_force != 0)
    member.notes.push_back({.code = "crack.poissons_ratio",
                            .text = "the mode I solution was computed for Poisson's ratio 0.3; "
                                    "torsion does not depend on it",
                            .path = report.path,
                            .equation = shaft.solid() ? "FR-13" : "FR-15",
                            .severity = Severity::care});
}

void ShaftCracks::add(CrackReport report, const AnnularCrack& crack,
                      const LoadedCrack<sif::AnnularCrackSolid>& loaded) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  note_load_and_ends(report, loaded.faces);
  use({"FR-12", "FR-13"});
  add_annular(std::move(report), crack, loaded,
              crack.solution == AnnularSolution::tada
                  ? AnnularAccuracy{accuracy::kAnnularTada, accuracy::kAnnularTada,
                                    accuracy::kAnnularTada / 2, accuracy::kAnnularTada / 2}
                  : annular_accuracy(model.loads().shaft_steel()));
}

AnnularAccuracy ShaftCracks::hollow_accuracy(const std::string& path) {
  const OutputShaft& shaft = *gear.output_shaft;
  const ElasticConstants steel = model.loads().shaft_steel();
  AnnularAccuracy accuracy = annular_accuracy(steel);
  accuracy.K_I = other_poissons_ratio(steel) ? double{accuracy::kAnnularTensionOtherRatio}
                                             : accuracy::kHollowTensionIntensity;
  accuracy.K_III = accuracy::kHollowTorsionIntensity;
  const double radius_ratio = shaft.inner_diameter / 2 / (shaft.outer_diameter / 2);
  if (!clearly_less(sif::AnnularCrackHollow::kMaxTensionRadiusRatio, radius_ratio)) return accuracy;
  accuracy.tension = accuracy::kAnnularExtrapolated;
  accuracy.K_I = accuracy.tension / 2;
  if (gear.load.axial_force != 0)
    member.notes.push_back({.code = "crack.tension_range",
                            .text = "the wall is thinner than in the table in tension, r_i/r_o <= "
                                    "0.95, so the axial entries are extrapolated",
                            .path = path,
                            .equation = "FR-15",
                            .severity = Severity::care});
  return accuracy;
}

void ShaftCracks::add(CrackReport report, const AnnularCrack& crack,
                      const LoadedCrack<sif::AnnularCrackHollow>& loaded) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  note_load_and_ends(report, loaded.faces);
  use({"FR-14", "FR-15", "FR-16"});
  const AnnularAccuracy accuracy = hollow_accuracy(report.path);
  const double depth_ratio = model.loads().depth_ratio(crack);
  if (!loaded.in_range && loaded.table) {
    take_from_table(report, member, gear, crack, *loaded.table);
    member.notes.push_back(
        {.code = "crack.depth_range",
         .text = fmt::format(
             "no stress intensity: a/t = {:.4g} is outside the table of the hollow shaft",
             depth_ratio),
         .path = report.path,
         .equation = "FR-14",
         .severity = Severity::care});
    member.cracks.push_back(std::move(report));
    return;
  }
  if (!loaded.in_range)
    member.unusable_because =
        fmt::format("{}: a/t = {:.4g} is outside the table of the hollow shaft, a/t <= {}",
                    report.path, depth_ratio, sif::AnnularCrackHollow::kMaxDepthRatio);
  add_annular(std::move(report), crack, loaded, accuracy);
}

}  // namespace

MemberCompliance output_shaft_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const SeriesModel<double> model(gear);
  MemberCompliance member;
  member.intact = model.sound_shaft();
  member.relative_uncertainty = accuracy::kTube;
  rest_on(member, "output_shaft", accuracy::kTube);
  use_equations(member.equations, {"ST-2"});
  add_cracks(member, model.loads(), "output_shaft", gear.output_shaft->crack,
             ShaftCracks({gear, model, options, member}));
  note_superposition(member.notes, member.cracks.size(), "output_shaft.crack");
  return member;
}

}  // namespace strainwave

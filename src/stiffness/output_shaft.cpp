// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "member_support.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// Uncertainties of an annular crack's added compliance.
struct AnnularAccuracy {
  ModelAccuracy torsion = accuracy::kAnnularTorsion;
  ModelAccuracy tension = accuracy::kAnnularTension;
  double K_I = accuracy::kAnnularTension / 2;  ///< of the stress intensity
  double K_III = accuracy::kAnnularTorsion / 2;
};

/// Mode I was computed for Poisson's ratio 0.3.
bool other_poissons_ratio(const ElasticConstants& steel) { return std::abs(steel.nu - 0.3) > 0.02; }

AnnularAccuracy annular_accuracy(const ElasticConstants& steel) {
  if (!other_poissons_ratio(steel)) return {};
  return {.tension = accuracy::kAnnularTensionOtherRatio,
          .K_I = accuracy::kAnnularTensionOtherRatio / 2};
}

/// Adds one annular crack; it is open unless the axial force presses it together.
template <SweptCrack Crack>
void add_annular_crack(MemberCompliance& member, CrackReport report, const AnnularCrack& given,
                       const Crack& crack, const GearSet& gear, const ElasticConstants& steel,
                       const AnnularAccuracy& accuracy, const StiffnessOptions& options) {
  const CrackModuli moduli{.opening = steel.plane_strain_modulus(), .shear = steel.G};
  if (given.compliance_table) {
    take_from_table(report, member, gear, given);
  } else {
    const auto added = added_compliance(crack, moduli, options.quadrature);
    demand_convergence(member, report, added.relative_error, added.converged);
    rest_on(member, report.path, accuracy.torsion);
    if (gear.load.axial_force != 0) rest_on(member, report.path, accuracy.tension);
    report.positive.at_output = {added.matrix(kTorsion, kTorsion), kComplianceUnit,
                                 accuracy.torsion};
    report.positive.axial_torsion = axial_torsion(added.matrix, accuracy.tension, accuracy.torsion);
    report.negative = report.positive;
  }
  const OutputShaft& shaft = *gear.output_shaft;
  const double wall = (shaft.outer_diameter - shaft.inner_diameter) / 2;
  report_intensities(report, member, crack, {gear.load.axial_force, gear.load.torque}, moduli,
                     {accuracy.K_I, 0.0, accuracy.K_III}, gear.material.at(shaft.material),
                     Constraint::plane_strain, wall - crack.size());
  member.cracks.push_back(std::move(report));
}

void add_crack(MemberCompliance& member, CrackReport report, const AnnularCrack& crack,
               const GearSet& gear, const ElasticConstants& steel,
               const StiffnessOptions& options) {
  const OutputShaft& shaft = *gear.output_shaft;
  const SeriesModel<double> model(gear);
  const bool open = model.annular_open();
  report.opens_under = gear.load.axial_force > 0 ? OpensUnder::both : OpensUnder::neither;
  for (const char* const tag : {"FR-2", "FR-18"}) use_equation(member.equations, tag);
  if (!open) {
    use_equation(member.equations, "FR-17");
    member.notes.push_back(
        {"crack.closed",
         "the axial force presses the faces together: no mode I; friction, which would hinder "
         "mode III until the torque overcomes it, is left out",
         report.path, "FR-17"});
  }
  if (clearly_less(shaft.length, 2 * shaft.outer_diameter))
    member.notes.push_back({"crack.short_shaft",
                            "less than one diameter of shaft on each side of a crack even in the "
                            "middle: the ends disturb its field",
                            report.path, "FR-12"});
  if (other_poissons_ratio(steel) && gear.load.axial_force != 0)
    member.notes.push_back({"crack.poissons_ratio",
                            "the mode I solution was computed for Poisson's ratio 0.3; torsion "
                            "does not depend on it",
                            report.path, shaft.solid() ? "FR-13" : "FR-15"});
  if (shaft.solid()) {
    const bool tada = crack.solution == AnnularSolution::tada;
    for (const char* const tag : {"FR-12", "FR-13"}) use_equation(member.equations, tag);
    add_annular_crack(member, std::move(report), crack, model.solid_shaft_crack(crack), gear, steel,
                      tada ? AnnularAccuracy{accuracy::kAnnularTada, accuracy::kAnnularTada,
                                             accuracy::kAnnularTada / 2, accuracy::kAnnularTada / 2}
                           : annular_accuracy(steel),
                      options);
    return;
  }
  for (const char* const tag : {"FR-14", "FR-15", "FR-16"}) use_equation(member.equations, tag);
  const double ro = shaft.outer_diameter / 2;
  const double ri = shaft.inner_diameter / 2;
  const double depth_ratio = model.depth_ratio(crack);
  AnnularAccuracy accuracy = annular_accuracy(steel);
  accuracy.K_I = other_poissons_ratio(steel) ? double{accuracy::kAnnularTensionOtherRatio}
                                             : accuracy::kHollowTensionIntensity;
  accuracy.K_III = accuracy::kHollowTorsionIntensity;
  if (clearly_less(sif::AnnularCrackHollow::kMaxTensionRadiusRatio, ri / ro)) {
    accuracy.tension = accuracy::kAnnularExtrapolated;
    accuracy.K_I = accuracy.tension / 2;
    if (gear.load.axial_force != 0)
      member.notes.push_back(
          {"crack.tension_range",
           "the wall is thinner than r_i/r_o = 0.95 of the table in tension: the "
           "axial entries are extrapolated",
           report.path, "FR-15"});
  }
  const bool beyond = clearly_less(sif::AnnularCrackHollow::kMaxDepthRatio, depth_ratio);
  if (beyond && crack.compliance_table) {
    take_from_table(report, member, gear, crack);
    member.notes.push_back({"crack.depth_range",
                            fmt::format("no stress intensity: a/t = {:.4g} is outside the table of "
                                        "the hollow shaft",
                                        depth_ratio),
                            report.path, "FR-14"});
    member.cracks.push_back(std::move(report));
    return;
  }
  if (beyond)
    member.unusable_because =
        fmt::format("{}: a/t = {:.4g} is outside the table of the hollow shaft, a/t <= {}",
                    report.path, depth_ratio, sif::AnnularCrackHollow::kMaxDepthRatio);
  add_annular_crack(member, std::move(report), crack, model.hollow_shaft_crack(crack), gear, steel,
                    accuracy, options);
}

}  // namespace

MemberCompliance output_shaft_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const OutputShaft& shaft = *gear.output_shaft;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, shaft.material, "output_shaft.material"));
  MemberCompliance member;
  member.intact = SeriesModel<double>(gear).sound_shaft(steel);
  member.relative_uncertainty = accuracy::kTube;
  rest_on(member, "output_shaft", accuracy::kTube);
  use_equation(member.equations, "ST-2");
  for (std::size_t i = 0; i < shaft.crack.size(); ++i) {
    CrackReport report{.path = fmt::format("output_shaft.crack[{}]", i),
                       .kind = std::string(AnnularCrack::kKind)};
    add_crack(member, std::move(report), std::get<AnnularCrack>(shaft.crack[i]), gear, steel,
              options);
  }
  note_superposition(member.notes, shaft.crack.size(), "output_shaft.crack");
  return member;
}

}  // namespace strainwave

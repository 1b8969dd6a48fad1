// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "member_support.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/drive_cracks/shaft_group.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// Uncertainties of the added compliance of a shaft's crack and of its stress intensity.
struct ShaftAccuracy {
  ModelAccuracy torsion = accuracy::kAnnularTorsion;
  ModelAccuracy tension = accuracy::kAnnularTension;
  double K_I = accuracy::kAnnularTension / 2;  ///< uncertainty of the stress intensity
  double K_III = accuracy::kAnnularTorsion / 2;
};

/// Whether Poisson's ratio differs from 0.3, for which mode I was computed.
bool other_poissons_ratio(const ElasticConstants& steel) { return std::abs(steel.nu - 0.3) > 0.02; }

ShaftAccuracy annular_accuracy(const ElasticConstants& steel) {
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
  void add(CrackReport report, const ShaftSurfaceCrack& crack,
           const LoadedCrack<sif::ShaftSurfaceSolid>& loaded);
  void add(CrackReport report, const ShaftSurfaceCrack& crack,
           const LoadedCrack<sif::ShaftSurfaceHollow>& loaded);

 private:
  void note_load_and_ends(const CrackReport& report, const BothSenses& faces);
  void note_poissons_ratio(const CrackReport& report);
  ShaftAccuracy hollow_accuracy(const std::string& path);

  /// Adds one annular crack; the crack is open unless the axial force presses it together.
  template <class Solution>
  void add_annular(CrackReport report, const AnnularCrack& crack,
                   const LoadedCrack<Solution>& loaded, const ShaftAccuracy& accuracy);
  /// The compliance by the closed form, which is the same under both senses of torque.
  template <class Solution>
  void take_closed_form(CrackReport& report, const LoadedCrack<Solution>& loaded,
                        const ShaftAccuracy& accuracy);
  /// Adds one surface crack by the closed form.
  template <class Solution>
  void add_surface(CrackReport report, const LoadedCrack<Solution>& loaded,
                   const ShaftAccuracy& accuracy);
};

template <class Solution>
void ShaftCracks::take_closed_form(CrackReport& report, const LoadedCrack<Solution>& loaded,
                                   const ShaftAccuracy& accuracy) {
  const auto added = closed_form(loaded, options.quadrature).positive;
  demand_convergence(member, report, added.relative_error, added.converged);
  rest_on(member, report.path, accuracy.torsion);
  if (gear.load.axial_force != 0) rest_on(member, report.path, accuracy.tension);
  report.positive.at_output = {model.at_output(added.matrix), kComplianceUnit, accuracy.torsion};
  report.positive.axial_torsion = axial_torsion(added.matrix, accuracy.tension, accuracy.torsion);
  report.negative = report.positive;
}

template <class Solution>
void ShaftCracks::add_annular(CrackReport report, const AnnularCrack& crack,
                              const LoadedCrack<Solution>& loaded, const ShaftAccuracy& accuracy) {
  const double P = gear.load.axial_force;
  if (loaded.table) {
    take_from_table(report, member, gear, crack, *loaded.table);
  } else {
    take_closed_form(report, loaded, accuracy);
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
                            .equation = report.kind == AnnularCrack::kKind ? "FR-12" : "FR-22",
                            .severity = Severity::care});
}

void ShaftCracks::note_poissons_ratio(const CrackReport& report) {
  if (other_poissons_ratio(model.loads().shaft_steel()) && gear.load.axial_force != 0)
    member.notes.push_back({.code = "crack.poissons_ratio",
                            .text = "the mode I solution was computed for Poisson's ratio 0.3; "
                                    "torsion does not depend on it",
                            .path = report.path,
                            .equation = gear.output_shaft->solid() ? "FR-13" : "FR-15",
                            .severity = Severity::care});
}

void ShaftCracks::add(CrackReport report, const AnnularCrack& crack,
                      const LoadedCrack<sif::AnnularCrackSolid>& loaded) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  note_load_and_ends(report, loaded.faces);
  note_poissons_ratio(report);
  use({"FR-12", "FR-13"});
  add_annular(std::move(report), crack, loaded,
              crack.solution == AnnularSolution::tada
                  ? ShaftAccuracy{accuracy::kAnnularTada, accuracy::kAnnularTada,
                                  accuracy::kAnnularTada / 2, accuracy::kAnnularTada / 2}
                  : annular_accuracy(model.loads().shaft_steel()));
}

ShaftAccuracy ShaftCracks::hollow_accuracy(const std::string& path) {
  const OutputShaft& shaft = *gear.output_shaft;
  const ElasticConstants steel = model.loads().shaft_steel();
  ShaftAccuracy accuracy = annular_accuracy(steel);
  accuracy.K_I = other_poissons_ratio(steel) ? double{accuracy::kAnnularTensionOtherRatio}
                                             : accuracy::kHollowTensionIntensity;
  accuracy.K_III = accuracy::kHollowTorsionIntensity;
  const double radius_ratio = shaft.inner_diameter / 2 / (shaft.outer_diameter / 2);
  if (!clearly_less(sif::AnnularCrackHollow::kMaxTensionRadiusRatio, radius_ratio)) return accuracy;
  accuracy.tension = accuracy::kAnnularExtrapolated;
  accuracy.K_I = accuracy.tension / 2;
  const auto pulls = [](const DutyBlock& block) {
    return block.axial_force != 0 || block.bending_moment != 0;
  };
  if (gear.load.axial_force != 0 || (gear.duty && std::ranges::any_of(gear.duty->block, pulls)))
    member.notes.push_back({.code = "crack.tension_range",
                            .text = "the wall is thinner than in the table in tension, r_i/r_o <= "
                                    "0.95, so the axial entries and K by a bending moment are "
                                    "extrapolated",
                            .path = path,
                            .equation = "FR-15",
                            .severity = Severity::care});
  return accuracy;
}

void ShaftCracks::add(CrackReport report, const AnnularCrack& crack,
                      const LoadedCrack<sif::AnnularCrackHollow>& loaded) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  note_load_and_ends(report, loaded.faces);
  note_poissons_ratio(report);
  use({"FR-14", "FR-15", "FR-16"});
  const ShaftAccuracy accuracy = hollow_accuracy(report.path);
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

template <class Solution>
void ShaftCracks::add_surface(CrackReport report, const LoadedCrack<Solution>& loaded,
                              const ShaftAccuracy& accuracy) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  note_load_and_ends(report, loaded.faces);
  use({"FR-22"});
  take_closed_form(report, loaded, accuracy);
  report_intensities(report, loaded.with_faces(loaded.faces.positive),
                     {gear.load.axial_force, gear.load.torque},
                     {accuracy.K_I, accuracy.K_III, accuracy.K_III});
  member.cracks.push_back(std::move(report));
}

/// The same uncertainty for compliance and half of it for K.
ShaftAccuracy one_accuracy(const ModelAccuracy& accuracy) {
  return {accuracy, accuracy, accuracy / 2, accuracy / 2};
}

void ShaftCracks::add(CrackReport report, const ShaftSurfaceCrack&,
                      const LoadedCrack<sif::ShaftSurfaceSolid>& loaded) {
  use({"SB-7", "SB-8"});
  ShaftAccuracy accuracy = {accuracy::kSolidSurfaceTorsion, accuracy::kSolidSurfaceTension,
                            accuracy::kSolidSurfaceOpening, accuracy::kSolidSurfaceShear};
  if (other_poissons_ratio(model.loads().shaft_steel())) {
    accuracy = one_accuracy(accuracy::kSolidSurfaceOtherRatio);
    member.notes.push_back({.code = "crack.poissons_ratio",
                            .text = "the stress intensity was computed for Poisson's ratio 0.3",
                            .path = report.path,
                            .equation = "SB-7",
                            .severity = Severity::care});
  }
  if (loaded.solution.aspect_ratio() <= sif::kNearlyStraight) {
    accuracy = one_accuracy(accuracy::kShaftSurfaceExtrapolated);
    member.notes.push_back(
        {.code = "crack.surface_range",
         .text = "the crack is longer than a crack of its depth with a straight front, and is "
                 "computed with a straight front",
         .path = report.path,
         .equation = "FR-22",
         .severity = Severity::care});
  }
  add_surface(std::move(report), loaded, accuracy);
}

void ShaftCracks::add(CrackReport report, const ShaftSurfaceCrack& crack,
                      const LoadedCrack<sif::ShaftSurfaceHollow>& loaded) {
  use({"SB-10", "SB-11"});
  using Hollow = sif::ShaftSurfaceHollow;
  const OutputShaft& shaft = *gear.output_shaft;
  const double wall = (shaft.outer_diameter - shaft.inner_diameter) / 2;
  const double bore = shaft.inner_diameter / shaft.outer_diameter;
  const double aspect = loaded.solution.aspect_ratio();
  ShaftAccuracy accuracy = {accuracy::kHollowSurfaceTorsion, accuracy::kHollowSurfaceTension,
                            accuracy::kHollowSurfaceOpening, accuracy::kHollowSurfaceShear};
  demand_ligament(member, report.path, crack.depth, wall);
  if (clearly_less(Hollow::kMaxDepthRatio * wall, crack.depth) ||
      clearly_less(aspect, Hollow::kLeastAspectRatio) || clearly_less(bore, Hollow::kLeastBore) ||
      clearly_less(Hollow::kLargestBore, bore)) {
    accuracy = one_accuracy(accuracy::kShaftSurfaceExtrapolated);
    member.notes.push_back(
        {.code = "crack.surface_range",
         .text = fmt::format("a/t = {:.3g}, a/c = {:.3g} and r_i/r_o = {:.3g}: the wall was "
                             "compared with finite elements for a/t <= {:g}, a/c >= {:g} and "
                             "{:g} <= r_i/r_o <= {:g}, and is extrapolated",
                             crack.depth / wall, aspect, bore, Hollow::kMaxDepthRatio,
                             Hollow::kLeastAspectRatio, Hollow::kLeastBore, Hollow::kLargestBore),
         .path = report.path,
         .equation = "SB-10",
         .severity = Severity::care});
  }
  add_surface(std::move(report), loaded, accuracy);
}

/// Adds an uncertainty to what the cracks of a group add.
void widen(MemberCompliance& member, const ShaftGroup& group, double share) {
  const auto take = [share](Quantity& quantity) {
    quantity.relative_uncertainty =
        accuracy::combined(quantity.relative_uncertainty.value_or(0.0), share);
  };
  for (const std::size_t index : group.index)
    for (AddedCompliance* const added :
         {&member.cracks[index].positive, &member.cracks[index].negative}) {
      take(added->at_output);
      if (added->axial_torsion) take((*added->axial_torsion)[2]);
    }
}

/// Takes what annular cracks that have a place do to each other's compliance, and says so.
/// @return  whether all cracks of the shaft are in the group
bool take_neighbours(const GearSet& gear, MemberCompliance& member) {
  const ShaftGroup group = shaft_group(gear);
  if (group.cracks.empty()) return false;
  use_equations(member.equations, {"CG-12"});
  if (std::string fault = group.fault(); !fault.empty()) {
    // The deepest crack alone is the least that the group adds.
    double sum = 0.0;
    double most = 0.0;
    for (const std::size_t index : group.index) {
      const double added = member.cracks[index].positive.at_output.value;
      sum += added;
      most = std::max(most, added);
    }
    if (sum > 0) widen(member, group, 1 - most / sum);
    member.notes.push_back(
        {.code = "crack.shielding",
         .text = "annular cracks shield each other, which this answer leaves out, so it adds too "
                 "much compliance; " +
                 fault,
         .path = "output_shaft.crack",
         .equation = "CG-12",
         .severity = Severity::care});
    return false;
  }
  const AnnularGroup solved = group.solved();
  double least = 1.0;
  double alone = 0.0;
  double together = 0.0;
  for (std::size_t j = 0; j < group.index.size(); ++j) {
    CrackReport& report = member.cracks[group.index[j]];
    const double ratio = solved.cracks[j].compliance;
    for (AddedCompliance* const added : {&report.positive, &report.negative}) {
      const auto shield = [&](Quantity& quantity) {
        quantity.value *= ratio;  // (CG-12)
        quantity.relative_uncertainty =
            accuracy::combined(quantity.relative_uncertainty.value_or(0.0), solved.error / ratio);
      };
      if (added == &report.positive) alone += added->at_output.value;
      shield(added->at_output);
      if (added == &report.positive) together += added->at_output.value;
      if (added->axial_torsion) shield((*added->axial_torsion)[2]);
    }
    // Pressed faces may hold each other by friction, and then the others do not shield.
    const bool pressed = gear.load.axial_force < 0;
    const double factor = pressed ? 1.0 : group.intensity(j, group.cracks[j].depth);
    least = std::min(least, factor);
    for (auto* const K : {&report.deepest, &report.largest}) {
      if (!*K) continue;
      (*K)->K_III.value *= factor;  // (CG-12)
      (*K)->K_III.relative_uncertainty =
          accuracy::combined((*K)->K_III.relative_uncertainty.value_or(0.0), solved.error / factor);
    }
    if (report.intensity_uncertainty)
      report.intensity_uncertainty =
          accuracy::combined(*report.intensity_uncertainty, solved.error / factor);
  }
  std::string bound;
  if (const double apart = group.stretch(); group.stretched()) {
    // The deepest crack alone is the least that the group adds.
    double most = 0.0;
    for (const std::size_t index : group.index)
      most = std::max(most, member.cracks[index].positive.at_output.value);
    if (together > 0) widen(member, group, 1 - most / together);
    bound = fmt::format(
        "; two of them are nearer than {:g} of the deeper one, so all distances count as {:.3g} "
        "times as long, which is an upper bound; K is that of each crack alone; replace two "
        "cracks that are so near by the deeper one",
        kLeastAnnularDistance, apart);
  }
  member.notes.push_back({.code = "crack.shielding",
                          .text = fmt::format("{} annular cracks shield each other in torsion: "
                                              "together they add {:.3f} times the sum of "
                                              "their compliances alone, which this answer "
                                              "contains; K_III is down to {:.3f} times that of "
                                              "a crack alone{}",
                                              group.index.size(), together / alone, least, bound),
                          .path = "output_shaft.crack",
                          .equation = "CG-12",
                          .severity = bound.empty() ? Severity::information : Severity::care});
  return group.index.size() == member.cracks.size();
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
  if (!take_neighbours(gear, member))
    note_superposition(member.notes, member.cracks.size(), "output_shaft.crack");
  return member;
}

}  // namespace strainwave

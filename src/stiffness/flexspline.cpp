// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "member_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

void add_sound_flexspline(const GearSet& gear, const ElasticConstants& steel,
                          MemberCompliance& member) {
  const Flexspline& fs = *gear.flexspline;
  const SeriesModel<double> model(gear);
  member.intact = model.sound_flexspline(steel);
  if (fs.crack_free == CrackFree::factor) {
    const bool plain_tube = fs.shape == FlexsplineShape::cylinder && !fs.shape_factor;
    const bool below_one = fs.shape == FlexsplineShape::cup && model.shape_factor() < 1;
    const ModelAccuracy& accuracy = plain_tube  ? accuracy::kTube
                                    : below_one ? accuracy::kShapeFactorBelowOne
                                                : accuracy::kShapeFactor;
    member.relative_uncertainty = accuracy;
    rest_on(member, "flexspline", accuracy);
    use_equation(member.equations, "ST-4");
    if (below_one)
      member.notes.push_back({"flexspline.shape_factor",
                              "a factor below 1 for a cup has the wrong direction: its bottom adds "
                              "compliance, 6 % to ten "
                              "times the barrel's; give the sections where the geometry is known",
                              "flexspline.crack_free", "ST-4"});
    return;
  }
  member.relative_uncertainty = accuracy::kSections;
  rest_on(member, "flexspline", accuracy::kSections);
  use_equation(member.equations, "ST-2");
  if (fs.diaphragm) use_equation(member.equations, "ST-3");
}

void note_thick_wall(MemberCompliance& member, const Wall<double>& wall, const std::string& path) {
  if (wall.mean_radius < 10 * wall.thickness)
    member.notes.push_back({"crack.thick_wall",
                            "the wall is thicker than a tenth of its radius: plate and shell "
                            "solutions and mean shear stress lose accuracy",
                            path, "FR-6"});
}

/// What differs between the kinds of wall cracks.
struct WallCrackModel {
  CrackModuli moduli;
  Constraint constraint = Constraint::plane_strain;
  double axial_uncertainty = 0.0;      ///< of the added compliance, entries with the force [-]
  double torsion_uncertainty = 0.0;    ///< of the added compliance in torsion [-]
  double pressed_uncertainty = 0.0;    ///< in addition where the faces are pressed together [-]
  double intensity_uncertainty = 0.0;  ///< of K, if more than half of that of the compliance [-]
  double ligament = 0.0;               ///< left of the section [m]
};

void note_closed(MemberCompliance& member, const std::string& path, const BothSenses& state) {
  if (state.positive != Faces::pressed && state.negative != Faces::pressed) return;
  use_equation(member.equations, "FR-17");
  member.notes.push_back(
      {"crack.closed",
       fmt::format("closed under {} torque: mode I adds nothing there, and the faces slide "
                   "without friction, an upper bound",
                   state.positive != Faces::pressed   ? "negative"
                   : state.negative != Faces::pressed ? "positive"
                                                      : "either sense of"),
       path, "FR-17"});
}

/// Adds one wall crack; `crack_with(open)` makes it with its faces apart or not.
template <class MakeCrack>
void add_wall_crack(MemberCompliance& member, CrackReport report, const MakeCrack& crack_with,
                    const BothSenses& state, const GearSet& gear, const WallCrackModel& model,
                    const StiffnessOptions& options) {
  const auto added_under = [&](Faces sense) {
    const auto added =
        added_compliance(crack_with(sense != Faces::pressed), model.moduli, options.quadrature);
    demand_convergence(member, report, added.relative_error, added.converged);
    const double pressed = sense == Faces::pressed ? model.pressed_uncertainty : 0.0;
    const double torsion = accuracy::combined(model.torsion_uncertainty, pressed);
    AddedCompliance result;
    result.at_output = {added.matrix(kTorsion, kTorsion), kComplianceUnit, torsion};
    result.axial_torsion =
        axial_torsion(added.matrix, accuracy::combined(model.axial_uncertainty, pressed), torsion);
    return result;
  };
  report.opens_under = opens_under(state.positive, state.negative);
  report.positive = added_under(state.positive);
  report.negative = (state.negative == Faces::pressed) == (state.positive == Faces::pressed)
                        ? report.positive
                        : added_under(state.negative);
  const Faces given = gear.load.torque > 0 ? state.positive : state.negative;
  const double of_compliance = gear.load.axial_force != 0
                                   ? std::max(model.axial_uncertainty, model.torsion_uncertainty)
                                   : model.torsion_uncertainty;
  report_intensities(report, member, crack_with(given != Faces::pressed),
                     {gear.load.axial_force, gear.load.torque}, model.moduli,
                     all_modes(std::max(of_compliance / 2, model.intensity_uncertainty)),
                     gear.material.at(gear.flexspline->material), model.constraint, model.ligament);
  note_closed(member, report.path, state);
  const AddedCompliance& at_given = gear.load.torque > 0 ? report.positive : report.negative;
  const double turned_by_axial_force = (*at_given.axial_torsion)[1].value * gear.load.axial_force;
  if (turned_by_axial_force != 0)
    member.notes.push_back(
        {"crack.axial_coupling",
         fmt::format(
             "the axial force turns the output by {:.3g} arcmin through this inclined crack; "
             "stiffness and wind-up are those of the torque alone",
             turned_by_axial_force / units::arcmin),
         report.path, "FR-2"});
  member.cracks.push_back(std::move(report));
}

double shell_parameter(const WallThroughCrack& crack, const GearSet& gear,
                       const ElasticConstants& steel) {
  return std::sqrt(SeriesModel<double>(gear)
                       .wall_crack(crack, steel, true)
                       .shell_parameter_squared(crack.half_length));
}

/// What the ends of the section do to a crack half-way along it, which the closed form leaves out.
struct EndsOfSection {
  ModelAccuracy accuracy;
  double share;      ///< of the section's length that the crack has, 2a/L [-]
  double confirmed;  ///< finite elements reach to this share [-]
};

EndsOfSection ends_of_section(const Flexspline& fs, const WallThroughCrack& crack) {
  const bool sections = fs.crack_free == CrackFree::sections;
  const bool rim = crack.section == WallSection::rim;
  const double length = !sections ? fs.length : rim ? fs.rim->length : fs.barrel->length;
  const bool between = sections && fs.rim && fs.diaphragm && !rim;
  EndsOfSection ends{.accuracy = between ? accuracy::kThroughCrackBetweenJoints
                                         : accuracy::kThroughCrackNearFreeEnd,
                     .share = 2 * crack.half_length / length,
                     .confirmed = between ? 0.7 : 0.47};
  ends.accuracy.relative_uncertainty *= ends.share * ends.share;
  return ends;
}

/// What the closed form of a through crack is worth, with its equations and notes.
struct ThroughCrackModel {
  WallCrackModel wall;
  std::vector<ModelAccuracy> compliance_rests_on;
};

ThroughCrackModel through_crack_model(MemberCompliance& member, const std::string& path,
                                      const WallThroughCrack& crack, const GearSet& gear,
                                      const ElasticConstants& steel) {
  const SeriesModel<double> series(gear);
  const double lambda = shell_parameter(crack, gear, steel);
  const ModelAccuracy accuracy =
      lambda > kCloseShellParameter ? accuracy::kThroughCrackLong : accuracy::kThroughCrack;
  if (lambda > kCloseShellParameter && lambda <= kMaxShellParameter)
    member.notes.push_back(
        {"crack.shell_range",
         fmt::format("shell parameter {:.3g}: for so long a crack finite elements have up to 1.3 % "
                     "more added compliance, and 2.7 % more energy release rate",
                     lambda),
         path, "FR-9"});
  constexpr double kWorthNaming = 0.005;
  const EndsOfSection ends = ends_of_section(*gear.flexspline, crack);
  if (ends.share > ends.confirmed)
    member.notes.push_back(
        {"crack.near_ends",
         fmt::format("the crack has {:.2g} of its section's length: what the ends add, and its "
                     "uncertainty, is confirmed by finite elements to {:.2g}",
                     ends.share, ends.confirmed),
         path, "FR-7"});
  // The tips run along the tube, which is long: there is no ligament to speak of.
  ThroughCrackModel model{
      .wall = {.moduli = SeriesModel<double>::wall_moduli(crack, steel),
               .constraint = Constraint::plane_stress,
               .torsion_uncertainty = accuracy::combined(accuracy, ends.accuracy),
               .pressed_uncertainty = accuracy::kThroughCrackPressed,
               .intensity_uncertainty = accuracy::combined(
                   clearly_less(0.3, steel.nu) ? accuracy::kThroughCrackIntensityOtherRatio
                                               : accuracy::kThroughCrackIntensity,
                   ends.accuracy),
               .ligament = std::numeric_limits<double>::infinity()},
      .compliance_rests_on = {accuracy}};
  if (ends.accuracy > kWorthNaming) model.compliance_rests_on.push_back(ends.accuracy);
  for (const char* const tag : {"FR-6", "FR-7", "ST-11"}) use_equation(member.equations, tag);
  if (crack.shell_correction) {
    for (const char* const tag : {"FR-8", "FR-9", "SU-2"}) use_equation(member.equations, tag);
  } else {
    const double missing =
        series.wall_crack(crack, steel, true).shell_release(crack.half_length) - 1;  // (FR-9)
    const ModelAccuracy flat{missing, "flat plate instead of the curved shell: too stiff"};
    model.wall.torsion_uncertainty = accuracy::combined(model.wall.torsion_uncertainty, flat);
    model.wall.intensity_uncertainty =
        accuracy::combined(model.wall.intensity_uncertainty, missing / 2);
    model.compliance_rests_on.push_back(flat);
    member.notes.push_back({"crack.flat_plate",
                            fmt::format("without the shell correction the crack is up to {:.2g} % "
                                        "too stiff",
                                        100 * missing),
                            path, "FR-9"});
  }
  model.wall.axial_uncertainty =
      accuracy::combined(model.wall.torsion_uncertainty, accuracy::kThroughCrackAxial);
  note_thick_wall(member, series.wall_of(crack.section), path);
  return model;
}

/// The uncertainty of a sheet's K is a part of the whole of K: of the smaller mode it is more.
void share_between_modes(CrackReport& report) {
  for (std::optional<StressIntensities>* const at : {&report.deepest, &report.largest}) {
    if (!*at) continue;
    StressIntensities& K = **at;
    const double whole = std::hypot(K.K_I.value, K.K_II.value);
    for (Quantity* const mode : {&K.K_I, &K.K_II})
      if (mode->value != 0)
        *mode->relative_uncertainty =
            std::min(1.0, *mode->relative_uncertainty * whole / std::abs(mode->value));
  }
}

void add_through_crack(MemberCompliance& member, CrackReport report, const WallThroughCrack& crack,
                       const GearSet& gear, const ElasticConstants& steel,
                       const StiffnessOptions& options) {
  const SeriesModel<double> series(gear);
  const auto make = [&](bool open) { return series.wall_crack(crack, steel, open); };
  for (const char* const tag : {"FR-2", "FR-6", "FR-7", "FR-18", "FR-21"})
    use_equation(member.equations, tag);
  const double lambda = shell_parameter(crack, gear, steel);
  if (lambda > kMaxShellParameter)
    member.unusable_because = fmt::format(
        "{}: shell parameter {:.3g} is outside the range that finite elements confirm, <= {:g}: "
        "such a long crack needs finite elements of its own",
        report.path, lambda, kMaxShellParameter);
  const ThroughCrackModel model = through_crack_model(member, report.path, crack, gear, steel);
  for (const ModelAccuracy& basis : model.compliance_rests_on) rest_on(member, report.path, basis);
  add_wall_crack(member, std::move(report), make, series.faces_of(crack), gear, model.wall,
                 options);
  share_between_modes(member.cracks.back());
}

/// A through crack whose compliance a table of finite elements gives: the closed form is left with
/// the stress intensity, where it has one.
void add_tabulated_through_crack(MemberCompliance& member, CrackReport report,
                                 const WallThroughCrack& crack, const GearSet& gear,
                                 const ElasticConstants& steel) {
  const SeriesModel<double> series(gear);
  const BothSenses state = series.faces_of(crack);
  report.opens_under = opens_under(state.positive, state.negative);
  const Faces given = gear.load.torque > 0 ? state.positive : state.negative;
  const double lambda = shell_parameter(crack, gear, steel);
  if (lambda <= kMaxShellParameter) {
    const WallCrackModel model = through_crack_model(member, report.path, crack, gear, steel).wall;
    report_intensities(report, member, series.wall_crack(crack, steel, given != Faces::pressed),
                       {gear.load.axial_force, gear.load.torque}, model.moduli,
                       all_modes(model.intensity_uncertainty),
                       gear.material.at(gear.flexspline->material), model.constraint,
                       model.ligament);
    share_between_modes(report);
    note_closed(member, report.path, state);
  } else {
    member.notes.push_back(
        {"crack.shell_range",
         fmt::format("no stress intensity: shell parameter {:.3g} is outside the range that finite "
                     "elements confirm, <= {:g}",
                     lambda, kMaxShellParameter),
         report.path, "FR-9"});
  }
  if (gear.flexspline->stress_nonuniformity != 1)
    member.notes.push_back({"crack.stress_nonuniformity",
                            "the compliance table has the stress of its own finite elements: "
                            "stress_nonuniformity is not applied to it",
                            report.path, "FE-41"});
  take_from_table(report, member, gear, crack);
  member.cracks.push_back(std::move(report));
}

void add_surface_crack(MemberCompliance& member, CrackReport report, const WallSurfaceCrack& crack,
                       const GearSet& gear, const ElasticConstants& steel,
                       const StiffnessOptions& options) {
  const SeriesModel<double> series(gear);
  const Wall<double> wall = series.wall_of(crack.section);
  const sif::CrackPlaneStress stress = series.plane_of(crack);
  const auto make = [&](bool open) { return series.wall_crack(crack, steel, open); };
  for (const char* const tag : {"FR-2", "FR-3", "FR-4", "FR-5", "FR-6", "FR-18", "ST-11"})
    use_equation(member.equations, tag);
  WallCrackModel model{.moduli = SeriesModel<double>::wall_moduli(crack, steel),
                       .constraint = Constraint::plane_strain,
                       .ligament = wall.thickness - crack.depth};
  const ModelAccuracy fit = surface_crack_fit(member, report.path, crack.depth,
                                              crack.depth / crack.half_length, wall.thickness);
  // Torque shears at angles other than 45 degrees, an axial force at angles other than 0 and 90
  // degrees: no angle is without shear in one of the entries.
  const double sheared = accuracy::combined(fit, accuracy::kSurfaceCrackShear);
  model.torsion_uncertainty = stress.shear[kTorsion] != 0 ? sheared : double{fit};
  model.axial_uncertainty = sheared;
  const double P = gear.load.axial_force;
  use_equation(member.equations, "FR-10");
  if (stress.shear[kTorsion] != 0 || stress.shear[kAxial] * P != 0) {
    rest_on(member, report.path, accuracy::kSurfaceCrackShear);
    member.notes.push_back({"crack.surface_shear",
                            "the crack is sheared as well as opened: K_II and K_III are those of "
                            "an ellipse inside a body, without the free surface",
                            report.path, "FR-10"});
  }
  note_thick_wall(member, wall, report.path);
  add_wall_crack(member, std::move(report), make, series.faces_of(crack), gear, model, options);
}

/// An arc crack of the diaphragm slides under torque: a flat through crack in pure mode II.
void add_diaphragm_arc(MemberCompliance& member, CrackReport report, const DiaphragmArcCrack& crack,
                       const GearSet& gear, const ElasticConstants& steel,
                       const StiffnessOptions& options) {
  const SeriesModel<double> series(gear);
  const auto make = [&](bool open) { return series.wall_crack(crack, steel, open); };
  for (const char* const tag : {"TC-19", "FR-2", "FR-18"}) use_equation(member.equations, tag);
  if (crack.half_length > series.arc_radius(crack) / 2)
    member.notes.push_back({"crack.diaphragm_arc",
                            "the arc is longer than its radius: the shear varies along it and it "
                            "is not straight",
                            report.path, "TC-19"});
  rest_on(member, report.path, accuracy::kDiaphragmArc);
  const WallCrackModel model{.moduli = SeriesModel<double>::wall_moduli(crack, steel),
                             .constraint = Constraint::plane_stress,
                             .axial_uncertainty = accuracy::kDiaphragmArc,
                             .torsion_uncertainty = accuracy::kDiaphragmArc,
                             .ligament = std::numeric_limits<double>::infinity()};
  add_wall_crack(member, std::move(report), make, series.faces_of(crack), gear, model, options);
}

void add_diaphragm_groove(MemberCompliance& member, CrackReport report,
                          const DiaphragmGroove& groove, const GearSet& gear,
                          const ElasticConstants& steel) {
  use_equation(member.equations, "TC-20");
  rest_on(member, report.path, accuracy::kDiaphragmGroove);
  const Quantity added{SeriesModel<double>(gear).groove(groove, steel), kComplianceUnit,
                       accuracy::kDiaphragmGroove};
  report.opens_under = OpensUnder::neither;
  report.positive.at_output = added;
  report.negative.at_output = added;
  member.cracks.push_back(std::move(report));
}

void note_ovalisation(const GearSet& gear, MemberCompliance& member) {
  const int U = gear.drive.wave_number;
  if (U < 2) return;  // one lobe shifts the ring, it does not bend it
  const Wall<double> wall = SeriesModel<double>(gear).tooth_ring();
  const double tau = std::abs(gear.load.torque) * gear.flexspline->stress_nonuniformity /
                     (2 * std::numbers::pi * wall.mean_radius * wall.mean_radius * wall.thickness);
  use_equation(member.equations, "ST-17");
  member.notes.push_back(
      {"flexspline.ovalisation",
       fmt::format("assembly on the wave generator bends the wall at the tooth ring by {:.3g} MPa, "
                   "against {:.3g} MPa of shear from the torque; it opens one face of a crack and "
                   "closes the other {} times per turn, and is left out of the decision whether a "
                   "crack is open",
                   ovalisation_stress(gear) / units::MPa, tau / units::MPa, U),
       "flexspline.crack", "ST-17"});
}

}  // namespace

double ovalisation_stress(const GearSet& gear) {
  const Wall<double> wall = SeriesModel<double>(gear).tooth_ring();
  const ElasticConstants steel =
      elastic_constants(material_of(gear, gear.flexspline->material, "flexspline.material"));
  const int U = gear.drive.wave_number;
  const double curvature =
      (U * U - 1) * gear.drive.radial_displacement / (wall.mean_radius * wall.mean_radius);
  return steel.plane_strain_modulus() * wall.thickness / 2 * curvature;  // (ST-17)
}

MemberCompliance flexspline_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, fs.material, "flexspline.material"));
  MemberCompliance member;
  add_sound_flexspline(gear, steel, member);
  for (std::size_t i = 0; i < fs.crack.size(); ++i) {
    CrackReport report{.path = fmt::format("flexspline.crack[{}]", i)};
    std::visit(
        [&](const auto& crack) {
          using Crack = std::decay_t<decltype(crack)>;
          report.kind = Crack::kKind;
          if constexpr (requires { crack.compliance_table; })
            if (crack.compliance_table) {
              add_tabulated_through_crack(member, std::move(report), crack, gear, steel);
              return;
            }
          if constexpr (std::is_same_v<Crack, WallThroughCrack>)
            add_through_crack(member, std::move(report), crack, gear, steel, options);
          else if constexpr (std::is_same_v<Crack, WallSurfaceCrack>)
            add_surface_crack(member, std::move(report), crack, gear, steel, options);
          else if constexpr (std::is_same_v<Crack, DiaphragmArcCrack>)
            add_diaphragm_arc(member, std::move(report), crack, gear, steel, options);
          else if constexpr (std::is_same_v<Crack, DiaphragmGroove>)
            add_diaphragm_groove(member, std::move(report), crack, gear, steel);
          else
            note_contact_path(member.notes, report.path);
        },
        fs.crack[i]);
  }
  const bool in_the_wall = std::ranges::any_of(fs.crack, [](const FlexsplineCrack& crack) {
    return std::holds_alternative<WallThroughCrack>(crack) ||
           std::holds_alternative<WallSurfaceCrack>(crack);
  });
  if (in_the_wall) note_ovalisation(gear, member);
  if (fs.dynamic_load != 1)
    member.notes.push_back({"flexspline.dynamic_load",
                            "a factor of the load has no place in a compliance: not used",
                            "flexspline.dynamic_load", ""});
  note_superposition(member.notes, member.cracks.size(), "flexspline.crack");
  return member;
}

}  // namespace strainwave

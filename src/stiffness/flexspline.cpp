// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "crack_interaction.hpp"
#include "member_support.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

/// The evidence of a section of a laminate.
template <class Section>
void note_laminate(MemberCompliance& member, const std::string& path, const Section& section,
                   const Material& laminate) {
  double wall = 0.0;
  if constexpr (std::is_base_of_v<TubeSection, Section>) {
    wall = section.wall_thickness;
    use_equations(member.equations, {"LA-1", "LA-2", "LA-3", "LA-5"});
    rest_on(member, path, accuracy::kLaminateTube);
  } else {
    wall = section.thickness;
    use_equations(member.equations, {"LA-1", "LA-2", "LA-3", "LA-10"});
  }
  note_thickness(member.notes, path, laminate, wall);
}

void add_sound_flexspline(const GearSet& gear, const SeriesModel<double>& model,
                          MemberCompliance& member) {
  const Flexspline& fs = *gear.flexspline;
  member.intact = model.sound_flexspline();
  if (fs.crack_free == CrackFree::factor) {
    const bool plain_tube = fs.shape == FlexsplineShape::cylinder && !fs.shape_factor;
    const ModelAccuracy& accuracy = plain_tube ? accuracy::kTube : accuracy::kShapeFactor;
    member.relative_uncertainty = accuracy;
    rest_on(member, "flexspline", accuracy);
    use_equations(member.equations, {"ST-4"});
    if (!plain_tube)
      member.notes.push_back(
          {.code = "flexspline.shape_factor",
           .text = fmt::format(
               "the factor {:.4g} represents all parts except the barrel; cups are 1.06 to 11 "
               "times as compliant as their barrel in finite elements{}",
               model.shape_factor(),
               model.shape_factor() < 1 ? ", so a factor below 1 makes the cup too stiff" : ""),
           .path = "flexspline.crack_free",
           .equation = "ST-4",
           .severity = Severity::care,
           .next_step = "If the geometry of the flexspline is known, give its sections with "
                        "crack_free = \"sections\"."});
    return;
  }
  member.relative_uncertainty = accuracy::kSections;
  rest_on(member, "flexspline", accuracy::kSections);
  use_equations(member.equations, {"ST-2"});
  if (fs.diaphragm) use_equations(member.equations, {"ST-3"});
  for_each_section(fs, [&](std::string_view name, const auto& section) {
    const Material& of = material_of(gear, material_name(fs, section), "flexspline.material");
    if (of.is_laminate()) note_laminate(member, fmt::format("flexspline.{}", name), section, of);
  });
}

void note_thick_wall(MemberCompliance& member, const Wall<double>& wall, const std::string& path) {
  if (wall.mean_radius < 10 * wall.thickness)
    member.notes.push_back({.code = "crack.thick_wall",
                            .text = "the wall is thicker than a tenth of its radius: plate and "
                                    "shell solutions and mean shear stress lose accuracy",
                            .path = path,
                            .equation = "FR-6",
                            .severity = Severity::care});
}

/// Range of r/t of the tubes in which the closed form of a through crack was compared with finite
/// elements [-].
constexpr Range kComparedRadiusRatio{
    .lower = 20.0, .lower_open = false, .upper = 60.0, .upper_open = false};

void note_radius_ratio(MemberCompliance& member, const Wall<double>& wall,
                       const std::string& path) {
  const double ratio = wall.mean_radius / wall.thickness;
  if (wall.mean_radius < 10 * wall.thickness || kComparedRadiusRatio.contains(ratio)) return;
  member.notes.push_back(
      {.code = "crack.radius_ratio",
       .text = fmt::format(
           "r/t = {:.4g} is outside the range from {:g} to {:g} in which the closed form was "
           "compared with finite elements; the stated accuracy holds only in this range",
           ratio, kComparedRadiusRatio.lower, kComparedRadiusRatio.upper),
       .path = path,
       .equation = "FR-9",
       .severity = Severity::care});
}

/// Accuracy of the closed form of a wall crack, as relative uncertainties [-].
struct WallCrackAccuracy {
  double axial = 0.0;      ///< uncertainty of the added compliance, entries with the force
  double torsion = 0.0;    ///< uncertainty of the added compliance in torsion
  double pressed = 0.0;    ///< added if the faces are pressed together
  double intensity = 0.0;  ///< uncertainty of K, if it exceeds half of that of the compliance
};

void note_closed(MemberCompliance& member, const std::string& path, const BothSenses& state) {
  if (state.positive != Faces::pressed && state.negative != Faces::pressed) return;
  use_equations(member.equations, {"FR-17"});
  member.notes.push_back(
      {.code = "crack.closed",
       .text = fmt::format("the crack is closed under {} torque: mode I adds nothing, and the "
                           "faces are assumed to slide without friction, which is an upper bound",
                           state.positive != Faces::pressed   ? "negative"
                           : state.negative != Faces::pressed ? "positive"
                                                              : "either sense of"),
       .path = path,
       .equation = "FR-17",
       .severity = Severity::care});
}

void note_axial_coupling(MemberCompliance& member, const CrackReport& report, const Load& load) {
  const AddedCompliance& at_given = load.torque > 0 ? report.positive : report.negative;
  const double turned_by_axial_force = (*at_given.axial_torsion)[1].value * load.axial_force;
  if (turned_by_axial_force == 0) return;
  member.notes.push_back(
      {.code = "crack.axial_coupling",
       .text = fmt::format("the axial force turns the output by {} through this inclined crack; "
                           "stiffness and wind-up are those of the torque alone",
                           shown_quantity(turned_by_axial_force, "rad", 3, "wind_up")),
       .path = report.path,
       .equation = "FR-2",
       .severity = Severity::care});
}

// Largest shares 2a/L of a section's length [-] at which solid elements of cups confirm the effect
// of its ends on a crack (theory manual, table ST-1), from the longest crack computed in each
// section.
constexpr double kConfirmedBetweenJoints = 0.7;
constexpr double kConfirmedNearFreeEnd = 0.47;

/// Effect of the ends of the section, which the closed form leaves out.
struct EndsOfSection {
  ModelAccuracy accuracy;
  /// half length over the distance to the nearer end; 2a/L of a crack half-way along [-]
  double share;
  double confirmed;  ///< largest share computed by finite elements [-]
};

EndsOfSection ends_of_section(const Flexspline& fs, const WallThroughCrack& crack) {
  const bool sections = fs.crack_free == CrackFree::sections;
  const bool rim = crack.section == WallSection::rim;
  const double length = !sections ? *fs.length : rim ? fs.rim->length : fs.barrel->length;
  const double from = crack.distance.value_or(length / 2);
  const bool between = sections && fs.rim && fs.diaphragm && !rim;
  EndsOfSection ends{.accuracy = between ? accuracy::kThroughCrackBetweenJoints
                                         : accuracy::kThroughCrackNearFreeEnd,
                     .share = crack.half_length / std::min(from, length - from),
                     .confirmed = between ? kConfirmedBetweenJoints : kConfirmedNearFreeEnd};
  ends.accuracy.relative_uncertainty *= ends.share * ends.share;
  return ends;
}

/// Accuracy of the closed form of a through crack, and the basis of its compliance.
struct ThroughCrackAccuracy {
  WallCrackAccuracy wall;
  std::vector<ModelAccuracy> compliance_rests_on;
};

/// Converts the uncertainty of a sheet's K, a share of the whole K, to each mode; for a smaller
/// mode the share is larger.
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

/// Reports the cracks of a flexspline, with separate notes for each kind.
class FlexsplineCracks : public CrackAdder {
 public:
  /// @param groups  of the drive, which take the sums of their cracks
  FlexsplineCracks(const CrackAdder& adder, std::vector<AnsweredGroup>& groups)
      : CrackAdder(adder), groups_(&groups) {}

  void add(CrackReport report, const WallThroughCrack& crack,
           const LoadedCrack<sif::ThroughCrackInTube>& loaded);
  void add(CrackReport report, const WallSurfaceCrack& crack,
           const LoadedCrack<sif::SurfaceCrack<2>>& loaded);
  void add(CrackReport report, const DiaphragmArcCrack& crack,
           const LoadedCrack<sif::ThroughCrackInTube>& loaded);
  void add(CrackReport report, const DiaphragmGroove& groove, const LoadedGroove& loaded);

 private:
  [[nodiscard]] Faces given(const BothSenses& state) const {
    return gear.load.torque > 0 ? state.positive : state.negative;
  }

  void note_range(const std::string& path, double lambda, const EndsOfSection& ends);
  void note_row(const std::string& path, const LoadedCrack<sif::ThroughCrackInTube>& row);
  ModelAccuracy note_row(const std::string& path, const WallSurfaceCrack& crack);
  ThroughCrackAccuracy accuracy_of(const std::string& path, const WallThroughCrack& crack,
                                   const sif::ThroughCrackInTube& solution, double lambda);
  void add_flat_plate(const std::string& path, const sif::ThroughCrackInTube& solution,
                      ThroughCrackAccuracy& accuracy);
  void add_in_laminate(CrackReport report, const WallThroughCrack& crack,
                       const LoadedCrack<sif::ThroughCrackInTube>& loaded);
  void add_tabulated(CrackReport report, const WallThroughCrack& crack,
                     const LoadedCrack<sif::ThroughCrackInTube>& loaded, double lambda);

  template <class Solution>
  void report_given_load(CrackReport& report, const LoadedCrack<Solution>& loaded,
                         double uncertainty) const {
    report_intensities(report, loaded.with_faces(given(loaded.faces)),
                       {gear.load.axial_force, gear.load.torque}, all_modes(uncertainty));
  }
  /// @param group  of the crack; empty: it has none
  template <class Solution>
  void add_wall_crack(CrackReport report, const LoadedCrack<Solution>& loaded,
                      const WallCrackAccuracy& accuracy, const std::optional<InGroup>& group = {});
  [[nodiscard]] std::optional<InGroup> group_of(const WallThroughCrack& crack) const;
  void report_in_group(CrackReport& report, const LoadedCrack<sif::ThroughCrackInTube>& loaded,
                       double uncertainty, const InGroup& group) const;

  std::vector<AnsweredGroup>* groups_;
};

/// The group of a crack, if it has a usable answer.
std::optional<InGroup> FlexsplineCracks::group_of(const WallThroughCrack& crack) const {
  for (AnsweredGroup& answered : *groups_)
    for (std::size_t j = 0; answered.fault.empty() && j < answered.group.members().size(); ++j)
      if (&crack ==
          std::get_if<WallThroughCrack>(&gear.flexspline->crack[answered.group.members()[j].index]))
        return InGroup{answered, j};
  return std::nullopt;
}

/// Fills in the stress intensities of the tip with the larger K.
void FlexsplineCracks::report_in_group(CrackReport& report,
                                       const LoadedCrack<sif::ThroughCrackInTube>& loaded,
                                       double uncertainty, const InGroup& group) const {
  const TorqueSense sense = gear.load.torque > 0 ? TorqueSense::positive : TorqueSense::negative;
  const GroupEffect& effect = group.under(sense);
  const double curvature = by_curvature(group.group.group, effect).intensity;
  double most = -1.0;
  for (const sif::CrackPlaneStress& stress : effect.tips) {
    sif::ThroughCrackInTube tip = loaded.solution;
    tip.open = !effect.closed;
    tip.tip_stress = stress;  // (CG-9)
    CrackReport of_tip;
    report_intensities(of_tip, tip, {gear.load.axial_force, gear.load.torque},
                       all_modes(accuracy::combined(uncertainty, curvature)));
    const double whole = std::hypot(of_tip.largest->K_I.value, of_tip.largest->K_II.value);
    if (whole <= most) continue;
    most = whole;
    report.deepest = of_tip.deepest;
    report.largest = of_tip.largest;
    report.intensity_uncertainty = of_tip.intensity_uncertainty;
  }
}

/// Adds one wall crack by its closed form.
template <class Solution>
void FlexsplineCracks::add_wall_crack(CrackReport report, const LoadedCrack<Solution>& loaded,
                                      const WallCrackAccuracy& accuracy,
                                      const std::optional<InGroup>& group) {
  const auto added = closed_form(loaded, options.quadrature);
  const auto reported = [&](const CrackCompliance<2>& under, Faces state, TorqueSense sense) {
    demand_convergence(member, report, under.relative_error, under.converged);
    const double pressed = state == Faces::pressed ? accuracy.pressed : 0.0;
    double torsion = accuracy::combined(accuracy.torsion, pressed);
    double axial = accuracy::combined(accuracy.axial, pressed);
    SymmetricMatrix<2> matrix = under.matrix;
    if (group) {
      const GroupEffect& effect = group->under(sense);
      matrix = in_group(under.matrix, effect);
      const double curvature = by_curvature(group->group.group, effect).compliance;
      torsion = accuracy::combined(torsion, curvature);
      axial = accuracy::combined(axial, curvature);
      const std::size_t which = sense == TorqueSense::positive ? 0 : 1;
      group->group.alone[which] += model.at_output(under.matrix);
      group->group.added[which] += model.at_output(matrix);
    }
    AddedCompliance result;
    result.at_output = {model.at_output(matrix), kComplianceUnit, torsion};
    result.axial_torsion = axial_torsion(matrix, axial, torsion);
    return result;
  };
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  report.positive = reported(added.positive, loaded.faces.positive, TorqueSense::positive);
  report.negative = reported(added.negative, loaded.faces.negative, TorqueSense::negative);
  const double of_compliance =
      gear.load.axial_force != 0 ? std::max(accuracy.axial, accuracy.torsion) : accuracy.torsion;
  const double of_intensity = std::max(of_compliance / 2, accuracy.intensity);
  if constexpr (std::is_same_v<Solution, sif::ThroughCrackInTube>) {
    if (group)
      report_in_group(report, loaded, of_intensity, *group);
    else
      report_given_load(report, loaded, of_intensity);
  } else {
    report_given_load(report, loaded, of_intensity);
  }
  note_closed(member, report.path, loaded.faces);
  note_axial_coupling(member, report, gear.load);
  member.cracks.push_back(std::move(report));
}

void FlexsplineCracks::note_range(const std::string& path, double lambda,
                                  const EndsOfSection& ends) {
  if (lambda > kCloseShellParameter && lambda <= kMaxShellParameter)
    member.notes.push_back(
        {.code = "crack.shell_range",
         .text =
             fmt::format("shell parameter {:.3g}: for a crack this long, finite elements give "
                         "up to 1.3 % more added compliance, and 2.7 % more energy release rate",
                         lambda),
         .path = path,
         .equation = "FR-9",
         .severity = Severity::care});
  if (ends.share > ends.confirmed)
    member.notes.push_back(
        {.code = "crack.near_ends",
         .text = fmt::format(
             "half of the crack is {:.2g} of the distance from its middle to the nearer "
             "end of its section: the effect of the ends and its uncertainty are "
             "confirmed by finite elements up to {:.2g}",
             ends.share, ends.confirmed),
         .path = path,
         .equation = "FR-7",
         .severity = Severity::care});
}

void FlexsplineCracks::add_flat_plate(const std::string& path,
                                      const sif::ThroughCrackInTube& solution,
                                      ThroughCrackAccuracy& accuracy) {
  const double missing = solution.shell_release(solution.half_length) - 1;  // (FR-9)
  const ModelAccuracy flat{
      missing, "the crack is treated as in a flat plate, which is too stiff for a curved shell"};
  accuracy.wall.torsion = accuracy::combined(accuracy.wall.torsion, flat);
  accuracy.wall.intensity = accuracy::combined(accuracy.wall.intensity, missing / 2);
  accuracy.compliance_rests_on.push_back(flat);
  member.notes.push_back(
      {.code = "crack.flat_plate",
       .text = fmt::format(
           "the shell correction would raise the added compliance of this crack by up to {:.2g} %",
           100 * missing),
       .path = path,
       .equation = "FR-9",
       .severity = Severity::care,
       .next_step = "Leave shell_correction at its default, true."});
}

/// Compliance and K of a row over those of its cracks alone, in one state of the faces.
struct RowEffect {
  double compliance = 1.0;  ///< [-]
  double intensity = 1.0;   ///< root of the energy release rate [-]
};

/// @return  empty if the torque neither opens nor shears the crack
std::optional<RowEffect> row_effect(const sif::ThroughCrackInTube& row, const CrackModuli& moduli,
                                    const QuadratureOptions& quadrature) {
  sif::ThroughCrackInTube alone = row;
  alone.count = 1;
  const auto compliance = [&](const sif::ThroughCrackInTube& crack) {
    return added_compliance(crack, moduli, quadrature).matrix(kTorsion, kTorsion);
  };
  const auto intensity = [](const sif::ThroughCrackInTube& crack) {
    const auto k = crack.stress_intensity(crack.half_length, 0.0);
    return std::hypot(k.I[kTorsion], k.II[kTorsion]);
  };
  if (!(intensity(alone) > 0)) return std::nullopt;
  return RowEffect{.compliance = compliance(row) / (row.count * compliance(alone)),
                   .intensity = intensity(row) / intensity(alone)};
}

/// Uncertainty of the compliance of a row whose curvature between the cracks is left out (CG-8).
ModelAccuracy without_curvature(const sif::ThroughCrackInTube& row) {
  constexpr double kFull = 0.8;   // shell parameter of the full uncertainty
  constexpr double kLong = 2.0;   // beyond, twice as much
  constexpr double kClose = 0.5;  // share 2 a/p of the full uncertainty
  const double lambda = std::sqrt(row.shell_parameter_squared(row.half_length));
  const double near = std::min(1.0, row.row_share(row.half_length) / kClose);
  return {accuracy::kRowInFlatSheet * (lambda > kLong ? 2 : 1) * std::min(1.0, lambda / kFull) *
              near * near,
          accuracy::kRowInFlatSheet.source};
}

/// Notes what the neighbours of a row of through cracks change.
void FlexsplineCracks::note_row(const std::string& path,
                                const LoadedCrack<sif::ThroughCrackInTube>& row) {
  use({"CG-7"});
  const bool curved = !row.solution.in_line && row.solution.shell_correction;
  if (curved) use({"CG-8"});
  std::string text;
  const auto say = [&](const char* when, Faces faces) {
    const auto effect = row_effect(row.with_faces(faces), row.moduli, options.quadrature);
    if (!effect) return;
    text += fmt::format(
        "; {} they add {:.4g} times the sum of their compliances, and K is {:.4g} "
        "times that of a crack alone",
        when, effect->compliance, effect->intensity);
  };
  const auto state = [](Faces faces) {
    return faces == Faces::pressed ? "with pressed faces" : "with open faces";
  };
  say(state(row.faces.positive), row.faces.positive);
  if (row.faces.differ()) say(state(row.faces.negative), row.faces.negative);
  member.notes.push_back(
      {.code = "crack.row",
       .text = fmt::format("the {} cracks of the row influence each other{}, and this answer "
                           "contains their influence{}",
                           row.solution.count, curved ? "" : " as in a flat sheet", text),
       .path = path,
       .equation = "CG-7",
       .severity = Severity::information});
}

/// Notes that the influence of surface cracks on each other is left out, with its bound.
/// @return  the bound, as a share of the compliance
ModelAccuracy FlexsplineCracks::note_row(const std::string& path, const WallSurfaceCrack& crack) {
  use({"CG-7"});
  const double bound = model.loads().row_bound(crack);
  if (bound > kLargestRowBound)
    member.unusable_because = fmt::format(
        "{}: the {} surface cracks lie so close that through cracks of their length would change "
        "each other's energy release rate by more than {:g} %; give a smaller count or shorter "
        "cracks",
        path, crack.count, 100 * kLargestRowBound);
  else
    member.notes.push_back(
        {.code = "crack.row_of_surface_cracks",
         .text = fmt::format(
             "the compliances of the {} surface cracks of the row are added; through cracks of "
             "their length would change each other's energy release rate by up to {:.2g} %, and "
             "surface cracks are taken to influence each other less",
             crack.count, 100 * bound),
         .path = path,
         .equation = "CG-7",
         .severity = bound > 0.05 ? Severity::care : Severity::information});
  return {std::min(bound, kLargestRowBound),
          "the influence of surface cracks on each other is left out"};
}

/// The reason why a row has no usable answer; empty if it has one.
std::string row_fault(CrackLoads<double>::RowState state, const std::string& path) {
  using RowState = CrackLoads<double>::RowState;
  switch (state) {
    case RowState::holds:
      break;
    case RowState::too_close:
      return fmt::format(
          "{}: the gap between neighbours of the row is less than {:g} of the half length, where "
          "the cracks are about to grow together; give shorter cracks or a smaller count",
          path, kLeastRowGap);
    case RowState::beyond_table:
      return fmt::format(
          "{}: the cracks of the row lie closer than the table of their influence in a curved "
          "wall; "
          "give shorter cracks or a smaller count",
          path);
    case RowState::faces:
      return fmt::format(
          "{}: the neighbours of the row open faces that the load presses together, or press faces "
          "that the load opens, and no model tells which part of them touches; give a smaller "
          "count or leave out the axial force",
          path);
  }
  return {};
}

ThroughCrackAccuracy FlexsplineCracks::accuracy_of(const std::string& path,
                                                   const WallThroughCrack& crack,
                                                   const sif::ThroughCrackInTube& solution,
                                                   double lambda) {
  constexpr double kWorthNaming = 0.005;
  constexpr double kUsualRatio = 0.3;  // largest Poisson's ratio at which K was compared closely
  const ModelAccuracy shell =
      lambda > kCloseShellParameter ? accuracy::kThroughCrackLong : accuracy::kThroughCrack;
  const EndsOfSection ends = ends_of_section(*gear.flexspline, crack);
  ThroughCrackAccuracy result{
      .wall = {.torsion = accuracy::combined(shell, ends.accuracy),
               .pressed = accuracy::kThroughCrackPressed,
               .intensity = accuracy::combined(clearly_less(kUsualRatio, solution.poissons_ratio)
                                                   ? accuracy::kThroughCrackIntensityOtherRatio
                                                   : accuracy::kThroughCrackIntensity,
                                               ends.accuracy)},
      .compliance_rests_on = {shell}};
  if (ends.accuracy > kWorthNaming) result.compliance_rests_on.push_back(ends.accuracy);
  use({"FR-6", "FR-7", "ST-11"});
  note_range(path, lambda, ends);
  if (crack.shell_correction)
    use({"FR-8", "FR-9", "SU-2"});
  else
    add_flat_plate(path, solution, result);
  note_thick_wall(member, model.loads().wall_of(crack.section), path);
  note_radius_ratio(member, model.loads().wall_of(crack.section), path);
  result.wall.axial = accuracy::combined(result.wall.torsion, accuracy::kThroughCrackAxial);
  return result;
}

void FlexsplineCracks::add(CrackReport report, const WallThroughCrack& crack,
                           const LoadedCrack<sif::ThroughCrackInTube>& loaded) {
  const double lambda = std::sqrt(loaded.solution.shell_parameter_squared(crack.half_length));
  if (loaded.table) {
    add_tabulated(std::move(report), crack, loaded, lambda);
    return;
  }
  if (loaded.moduli.anisotropic) {
    add_in_laminate(std::move(report), crack, loaded);
    return;
  }
  use({"FR-2", "FR-6", "FR-7", "FR-18", "FR-21"});
  const std::string in_row = row_fault(model.loads().row_state(crack), report.path);
  if (!in_row.empty())
    member.unusable_because = in_row;
  else if (!loaded.in_range)
    member.unusable_because = fmt::format(
        "{}: shell parameter {:.3g} is outside the range that finite elements confirm, <= {:g}; "
        "compute so long a crack by strainwave fe",
        report.path, lambda, kMaxShellParameter);
  ThroughCrackAccuracy accuracy = accuracy_of(report.path, crack, loaded.solution, lambda);
  if (crack.count > 1) {
    note_row(report.path, loaded);
    const ModelAccuracy flat = without_curvature(loaded.solution);
    const ModelAccuracy row = crack.shell_correction ? accuracy::kRowOfCracks : flat;
    accuracy.compliance_rests_on.push_back(row);
    for (double* const of : {&accuracy.wall.axial, &accuracy.wall.torsion})
      *of = accuracy::combined(*of, row);
    accuracy.wall.intensity = accuracy::combined(accuracy.wall.intensity, row / 2);
    // The table is that of open faces.
    accuracy.wall.pressed = accuracy::combined(accuracy.wall.pressed, flat);
  }
  const auto group = group_of(crack);
  if (group) {
    double curvature = 0.0;
    for (const TorqueSense sense : {TorqueSense::positive, TorqueSense::negative})
      curvature =
          std::max(curvature, by_curvature(group->group.group, group->under(sense)).compliance);
    accuracy.compliance_rests_on.push_back({curvature, accuracy::kRowInFlatSheet.source});
  }
  for (const ModelAccuracy& basis : accuracy.compliance_rests_on)
    rest_on(member, report.path, basis);
  add_wall_crack(std::move(report), loaded, accuracy.wall, group);
  share_between_modes(member.cracks.back());
}

/// Adds a through crack of a laminate, as that of a flat sheet.
void FlexsplineCracks::add_in_laminate(CrackReport report, const WallThroughCrack& crack,
                                       const LoadedCrack<sif::ThroughCrackInTube>& loaded) {
  use({"FR-2", "FR-6", "FR-7", "ST-11", "LA-4", "LA-7", "LA-8", "LA-9"});
  // What the curvature adds to a crack of this size in an isotropic wall.
  sif::ThroughCrackInTube isotropic = loaded.solution;
  isotropic.poissons_ratio = kMetalPoissonsRatio;
  isotropic.shell_correction = true;
  const double lambda = std::sqrt(isotropic.shell_parameter_squared(crack.half_length));
  const double curvature =
      isotropic.shell_release(crack.half_length * std::min(1.0, kMaxShellParameter / lambda)) - 1;
  const double uncertainty = accuracy::combined(accuracy::kLaminateCrack, curvature);
  if (!loaded.in_range)
    member.unusable_because = fmt::format(
        "{}: the crack is too long for the solution of a flat sheet; shorten its half length to "
        "{}, where the shell parameter is {:g}",
        report.path, shown_quantity(crack.half_length * kMaxShellParameter / lambda, "m", 3),
        kMaxShellParameter);
  rest_on(member, report.path, {uncertainty, accuracy::kLaminateCrack.source});
  member.notes.push_back(
      {.code = "crack.laminate",
       .text = fmt::format(
           "the crack goes through all plies of a laminate, as in a flat sheet; delamination and "
           "the curvature of the wall are left out; in an isotropic wall the curvature would raise "
           "the added compliance by up to {:.2g} %",
           100 * curvature),
       .path = report.path,
       .equation = "LA-9",
       .severity = Severity::care});
  note_thick_wall(member, model.loads().wall_of(crack.section), report.path);
  add_wall_crack(std::move(report), loaded,
                 {.axial = uncertainty,
                  .torsion = uncertainty,
                  .pressed = accuracy::kThroughCrackPressed,
                  .intensity = uncertainty});
  share_between_modes(member.cracks.back());
}

/// Adds a through crack whose compliance comes from a table of finite elements; the closed form
/// still gives the stress intensity if it is valid.
void FlexsplineCracks::add_tabulated(CrackReport report, const WallThroughCrack& crack,
                                     const LoadedCrack<sif::ThroughCrackInTube>& loaded,
                                     double lambda) {
  report.opens_under = opens_under(loaded.faces.positive, loaded.faces.negative);
  const auto group = group_of(crack);
  if (loaded.in_range) {
    const double uncertainty =
        accuracy_of(report.path, crack, loaded.solution, lambda).wall.intensity;
    if (group)
      report_in_group(report, loaded, uncertainty, *group);
    else
      report_given_load(report, loaded, uncertainty);
    share_between_modes(report);
    note_closed(member, report.path, loaded.faces);
  } else {
    member.notes.push_back(
        {.code = "crack.shell_range",
         .text =
             fmt::format("no stress intensity: shell parameter {:.3g} is outside the range that "
                         "finite elements confirm, <= {:g}",
                         lambda, kMaxShellParameter),
         .path = report.path,
         .equation = "FR-9",
         .severity = Severity::care});
  }
  if (gear.flexspline->stress_nonuniformity != 1)
    member.notes.push_back({.code = "crack.stress_nonuniformity",
                            .text = "the compliance table contains the stress of its finite "
                                    "elements, so stress_nonuniformity is not applied",
                            .path = report.path,
                            .equation = "FE-41",
                            .severity = Severity::information});
  take_from_table(report, member, gear, crack, *loaded.table);
  if (group) {
    // The table is that of the crack alone.
    std::size_t which = 0;
    for (AddedCompliance* const added : {&report.positive, &report.negative}) {
      const GroupEffect& effect =
          group->under(which == 0 ? TorqueSense::positive : TorqueSense::negative);
      group->group.alone[which] += added->at_output.value;
      added->at_output.value *= effect.ratio();  // (CG-9)
      added->at_output.relative_uncertainty =
          accuracy::combined(added->at_output.relative_uncertainty.value_or(0.0),
                             by_curvature(group->group.group, effect).compliance);
      group->group.added[which] += added->at_output.value;
      added->axial_torsion.reset();
      ++which;
    }
  }
  member.cracks.push_back(std::move(report));
}

void FlexsplineCracks::add(CrackReport report, const WallSurfaceCrack& crack,
                           const LoadedCrack<sif::SurfaceCrack<2>>& loaded) {
  const Wall<double> wall = model.loads().wall_of(crack.section);
  const sif::CrackPlaneStress stress = model.loads().plane_of(crack);
  use({"FR-2", "FR-3", "FR-4", "FR-5", "FR-6", "FR-18", "ST-11"});
  const ModelAccuracy fit = surface_crack_fit(member, report.path, crack.depth,
                                              crack.depth / crack.half_length, wall.thickness);
  // Torque causes shear at angles other than 45 degrees, and an axial force at angles other than 0
  // and 90 degrees.  At every angle one entry contains shear.
  const double sheared = accuracy::combined(fit, accuracy::kSurfaceCrackShear);
  use({"FR-10"});
  if (stress.shear[kTorsion] != 0 || stress.shear[kAxial] * gear.load.axial_force != 0) {
    rest_on(member, report.path, accuracy::kSurfaceCrackShear);
    member.notes.push_back({.code = "crack.surface_shear",
                            .text = "the crack is sheared as well as opened: K_II and K_III are "
                                    "those of an ellipse inside a body, without the free surface",
                            .path = report.path,
                            .equation = "FR-10",
                            .severity = Severity::care});
  }
  note_thick_wall(member, wall, report.path);
  WallCrackAccuracy accuracy{.axial = sheared,
                             .torsion = stress.shear[kTorsion] != 0 ? sheared : double{fit}};
  if (crack.count > 1) {
    const ModelAccuracy row = note_row(report.path, crack);
    rest_on(member, report.path, row);
    for (double* const of : {&accuracy.axial, &accuracy.torsion})
      *of = accuracy::combined(*of, row);
  }
  add_wall_crack(std::move(report), loaded, accuracy);
}

void FlexsplineCracks::add(CrackReport report, const DiaphragmArcCrack& crack,
                           const LoadedCrack<sif::ThroughCrackInTube>& loaded) {
  use({"TC-19", "FR-2", "FR-18"});
  if (crack.half_length > model.loads().arc_radius(crack) / 2)
    member.notes.push_back({.code = "crack.diaphragm_arc",
                            .text = "the arc is longer than its radius, so the shear varies along "
                                    "the arc and the arc is not straight",
                            .path = report.path,
                            .equation = "TC-19",
                            .severity = Severity::care});
  rest_on(member, report.path, accuracy::kDiaphragmArc);
  if (!loaded.in_range)
    member.unusable_because = row_fault(CrackLoads<double>::RowState::too_close, report.path);
  if (crack.count > 1) note_row(report.path, loaded);
  add_wall_crack(std::move(report), loaded,
                 {.axial = accuracy::kDiaphragmArc, .torsion = accuracy::kDiaphragmArc});
}

void FlexsplineCracks::add(CrackReport report, const DiaphragmGroove& groove, const LoadedGroove&) {
  use({"TC-20"});
  rest_on(member, report.path, accuracy::kDiaphragmGroove);
  const Quantity added{model.groove(groove), kComplianceUnit, accuracy::kDiaphragmGroove};
  report.opens_under = OpensUnder::neither;
  report.positive.at_output = added;
  report.negative.at_output = added;
  member.cracks.push_back(std::move(report));
}

/// Notes the stress by the assembly at the wall that contains cracks.
void note_ovalisation(const GearSet& gear, const CrackLoads<double>& loads, WallSection section,
                      MemberCompliance& member) {
  const int U = gear.drive.wave_number;
  if (U < 2) return;  // one lobe shifts the ring without bending it
  const std::string& material = material_name(*gear.flexspline, section);
  if (material_of(gear, material, "flexspline.material").is_laminate()) {
    member.notes.push_back({.code = "flexspline.laminate_assembly",
                            .text = "assembly on the wave generator bends the plies; this bending "
                                    "is not in the compliance of the cracks, while strength and "
                                    "growth take an upper bound of it",
                            .path = "flexspline.crack",
                            .equation = "LA-6",
                            .severity = Severity::care,
                            .next_step = "Run strainwave laminate, which states the stress of each "
                                         "ply."});
    return;
  }
  const Wall<double> wall = loads.wall_of(section);
  const char* const where = gear.flexspline->crack_free == CrackFree::factor ? "at the tooth ring"
                            : section == WallSection::rim                    ? "of the rim"
                                                                             : "of the barrel";
  const double tau = std::abs(gear.load.torque) * gear.flexspline->stress_nonuniformity /
                     (2 * std::numbers::pi * wall.mean_radius * wall.mean_radius * wall.thickness);
  use_equations(member.equations, {"ST-17"});
  member.notes.push_back(
      {.code = "flexspline.ovalisation",
       .text = fmt::format(
           "assembly on the wave generator bends the wall {} by {}, against {} of shear from the "
           "torque; it opens one face of a crack and closes the other {} times per turn; the "
           "stiffness takes a crack as the torque alone opens or closes it, and over a turn the "
           "compliance of the crack lies between those of an open and of a closed crack",
           where,
           shown_quantity(bending_to_shape(gear.drive, loads.wall_steel(section), wall.mean_radius,
                                           wall.thickness),
                          "Pa", 3),
           shown_quantity(tau, "Pa", 3), U),
       .path = "flexspline.crack",
       .equation = "ST-17",
       .severity = Severity::care,
       .next_step = "Run strainwave turn, which states K and the share of a turn during which the "
                    "crack is open."});
}

}  // namespace

MemberCompliance flexspline_compliance(const GearSet& gear, const StiffnessOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const SeriesModel<double> model(gear);
  MemberCompliance member;
  add_sound_flexspline(gear, model, member);
  std::vector<AnsweredGroup> groups;
  for (WallGroup& group : wall_groups(gear, model.loads())) groups.emplace_back(std::move(group));
  add_cracks(member, model.loads(), "flexspline", fs.crack,
             FlexsplineCracks({gear, model, options, member}, groups));
  for (const WallSection section : {WallSection::barrel, WallSection::rim}) {
    const bool cracked = std::ranges::any_of(fs.crack, [&](const FlexsplineCrack& any) {
      return std::visit(
          [&](const auto& crack) {
            const CrackPlace place = crack.place();
            return place.angle.has_value() && place.part == part_of(section);
          },
          any);
    });
    if (cracked) note_ovalisation(gear, model.loads(), section, member);
  }
  if (fs.dynamic_load != 1)
    member.notes.push_back({.code = "flexspline.dynamic_load",
                            .text = "this factor of the load is not used, because a compliance "
                                    "does not depend on the load",
                            .path = "flexspline.dynamic_load",
                            .equation = "",
                            .severity = Severity::information});
  std::size_t in_groups = 0;
  for (const AnsweredGroup& answered : groups) {
    note_interaction(answered, member);
    in_groups = std::max(in_groups, answered.group.members().size());
  }
  if (in_groups < member.cracks.size())  // else the note above says how the cracks interact
    note_superposition(member.notes, member.cracks.size(), "flexspline.crack");
  return member;
}

}  // namespace strainwave

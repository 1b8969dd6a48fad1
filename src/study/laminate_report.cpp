// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/laminate_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/laminate/ply_failure.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

std::array<double, 6> entries(const InPlane<>& m) {
  return {m.m11, m.m12, m.m22, m.m16, m.m26, m.m66};
}

double largest(const InPlane<>& m) {
  double most = 0.0;
  for (const double entry : entries(m)) most = std::max(most, std::abs(entry));
  return most;
}

/// Strengths of a ply; those of an isotropic one make the criterion of von Mises of (LA-12).
std::optional<LaminaStrength> strength_of(const Material& material) {
  if (material.ply_strength) return material.ply_strength;
  if (!material.is_isotropic() || !material.yield_strength) return std::nullopt;
  const double yield = *material.yield_strength;
  return LaminaStrength{.fibre_tension = yield,
                        .fibre_compression = yield,
                        .transverse_tension = yield,
                        .transverse_compression = yield,
                        .shear = yield / std::sqrt(3.0)};
}

/// The plies of the file in the order of the wall.
std::vector<const Ply*> listed(const Material& laminate) {
  std::vector<const Ply*> plies;
  for (const Ply& ply : laminate.ply) plies.push_back(&ply);
  if (laminate.stacking == Stacking::symmetric)
    for (auto ply = laminate.ply.rbegin(); ply != laminate.ply.rend(); ++ply)
      plies.push_back(&*ply);
  return plies;
}

LaminaStress negative(const LaminaStress& s) { return {-s.along, -s.across, -s.shear}; }
LaminaStress sum(const LaminaStress& a, const LaminaStress& b) {
  return {a.along + b.along, a.across + b.across, a.shear + b.shear};
}

void take_largest(std::optional<double>& largest, double other) {
  if (!largest || other > *largest) largest = other;
}

void take_least(std::optional<double>& least, const std::optional<double>& other) {
  if (other && (!least || *other < *least)) least = other;
}

class Walls {
 public:
  Walls(const GearSet& gear, LaminateReport& report) : gear_(gear), report_(report) {}

  void add(const std::string& path, const TubeSection& section) {
    LaminateWall wall = basics(path, section, section.wall_thickness);
    const double r = (section.outer_diameter - section.wall_thickness) / 2;
    const TubeTorsion<> torsion = tube_torsion<double>(plies_, section.wall_thickness, r);
    wall.torsional_rigidity = torsion.stiffness;
    wall.compliance = section.length / torsion.stiffness;
    wall.axial_strain = torsion.axial_strain * gear_.load.torque;
    wall.hoop_strain = torsion.hoop_strain * gear_.load.torque;
    add_plies(wall, r);
    note(wall);
    report_.walls.push_back(std::move(wall));
  }

  void add(const std::string& path, const Diaphragm& section) {
    LaminateWall wall = basics(path, section, section.thickness);
    if (!isotropic_in_plane(stiffness_, kNearlyIsotropic))
      report_.notes.push_back(
          {.code = "laminate.bottom",
           .text =
               "the bottom is not as stiff in every direction of its plane, so its twist is not "
               "derived",
           .path = path,
           .equation = "LA-10",
           .severity = Severity::cannot_tell,
           .next_step = "Give quasi-isotropic plies, such as 0, 45, -45 and 90 deg."});
    note(wall);
    report_.walls.push_back(std::move(wall));
  }

 private:
  template <class Section>
  LaminateWall basics(const std::string& path, const Section& section, const double& thickness) {
    const Flexspline& fs = *gear_.flexspline;
    LaminateWall wall{.path = path, .material = material_name(fs, section)};
    material_ = &material_of(gear_, wall.material, "flexspline.material");
    plies_ = plies_of(Lift<double>(), gear_, *material_);
    stiffness_ = laminate_stiffness<double>(plies_, thickness);
    wall.thickness = thickness;
    wall.thickness_of_plies = strainwave::thickness_of_plies(*material_);
    const InPlane<> a = sheet_compliance(stiffness_);  // (LA-4)
    wall.E_x = 1 / a.m11;
    wall.E_y = 1 / a.m22;
    wall.G_xy = 1 / a.m66;
    wall.nu_xy = -a.m12 / a.m11;
    wall.A = entries(stiffness_.A);
    wall.B = entries(stiffness_.B);
    wall.D = entries(stiffness_.D);
    wall.hoop_bending = hoop_bending_stiffness(stiffness_);
    constexpr double kRounding = 1e-9;
    wall.symmetric = largest(stiffness_.B) <= kRounding * largest(stiffness_.A) * thickness;
    wall.balanced = std::max(std::abs(stiffness_.A.m16), std::abs(stiffness_.A.m26)) <=
                    kRounding * largest(stiffness_.A);
    return wall;
  }

  void add_plies(LaminateWall& wall, double radius) {
    const int U = gear_.drive.wave_number;
    const double curvature =
        (U * U - 1) * gear_.drive.radial_displacement / (radius * radius);  // (LA-6)
    const double K_u = gear_.flexspline->stress_nonuniformity;
    const auto stresses = [&](double torque) {
      return ply_stresses(plies_, wall.thickness,
                          {.radius = radius,
                           .torque = torque,
                           .axial_force = gear_.load.axial_force,
                           .curvature = curvature});
    };
    const std::vector<PlyFace> given = stresses(K_u * gear_.load.torque);
    const std::vector<PlyFace> other = stresses(-K_u * gear_.load.torque);
    const std::vector<const Ply*> named = listed(*material_);
    for (std::size_t i = 0; i < named.size(); ++i) {
      const Material& of = material_of(gear_, named[i]->material, "material.ply.material");
      PlyState ply{.number = static_cast<int>(i) + 1,
                   .material = named[i]->material,
                   .angle = named[i]->angle,
                   .thickness = named[i]->thickness / wall.thickness_of_plies * wall.thickness};
      for (const std::size_t face : {2 * i, 2 * i + 1}) {
        const LaminaStress& bent = given[face].assembly;
        ply.load_along = given[face].load.along;
        ply.load_across = given[face].load.across;
        ply.load_shear = given[face].load.shear;
        ply.assembly_along = std::max(ply.assembly_along, std::abs(bent.along));
        ply.assembly_across = std::max(ply.assembly_across, std::abs(bent.across));
        ply.assembly_shear = std::max(ply.assembly_shear, std::abs(bent.shear));
      }
      if (const std::optional<LaminaStrength> strength = strength_of(of)) {
        add_failure(ply, i, given, other, *strength);
        if (of.ply_endurance) add_endurance(ply, i, given, other, *strength, *of.ply_endurance);
      } else {
        without_strength_ = named[i]->material;
      }
      if (!ply.haigh) without_endurance_ = named[i]->material;
      std::optional<double> least = ply.tsai_wu;
      take_least(least, ply.largest_strain);
      if (least && (!wall.reserve || *least < *wall.reserve)) {
        wall.reserve = least;
        wall.first_ply = ply.number;
      }
      take_least(wall.proportional, ply.proportional);
      if (ply.haigh) take_largest(wall.haigh, *ply.haigh);
      wall.plies.push_back(std::move(ply));
    }
    note_unknown(wall);
  }

  /// First failure of a ply, over both faces, both senses of torque and a turn.  The stress of the
  /// assembly runs from that at a lobe to its negative, and what a criterion admits is convex, so
  /// the least factor belongs to one of these ends (LA-18).
  void add_failure(PlyState& ply, std::size_t i, const std::vector<PlyFace>& given,
                   const std::vector<PlyFace>& other, const LaminaStrength& strength) const {
    const double between = std::numbers::pi / gear_.drive.wave_number;
    std::optional<double> worst;
    for (const std::size_t face : {2 * i, 2 * i + 1}) {
      const LaminaStress& bent = given[face].assembly;
      for (const bool at_lobe : {true, false})
        for (const bool as_given : {true, false}) {
          const LaminaStress fixed = at_lobe ? bent : negative(bent);
          const LaminaStress& load = (as_given ? given : other)[face].load;
          const Lamina<>& lamina = plies_[i].lamina;
          const auto criterion = tsai_wu_factor(fixed, load, strength);
          const auto strain = strain_factor(fixed, load, lamina, strength);
          take_least(ply.tsai_wu, criterion);
          take_least(ply.largest_strain, strain);
          const LaminaStress both = sum(fixed, load);
          take_least(ply.proportional, tsai_wu_factor({}, both, strength));  // (LA-18)
          take_least(ply.proportional, strain_factor({}, both, lamina, strength));
          std::optional<double> least = criterion;
          take_least(least, strain);
          if (!least || (worst && *least >= *worst)) continue;
          worst = least;
          ply.worst_face = given[face].outer ? "outer" : "inner";
          ply.worst_angle = at_lobe ? 0.0 : between;
          ply.worst_sense = as_given == (gear_.load.torque >= 0) ? 1 : -1;
          ply.worst_along = both.along;
          ply.worst_across = both.across;
          ply.worst_shear = both.shear;
        }
    }
  }

  /// Endurance of a ply over a turn at constant load; (LA-19).
  static void add_endurance(PlyState& ply, std::size_t i, const std::vector<PlyFace>& given,
                            const std::vector<PlyFace>& other, const LaminaStrength& strength,
                            const LaminaEndurance& endurance) {
    for (const std::size_t face : {2 * i, 2 * i + 1})
      for (const std::vector<PlyFace>* const sense : {&given, &other}) {
        const LaminaStress& bent = (*sense)[face].assembly;
        const LaminaStress& load = (*sense)[face].load;
        take_largest(ply.haigh, ply_endurance(bent, load, strength, endurance).utilisation());
        take_least(ply.haigh_factor, endurance_factor(bent, load, strength, endurance));
      }
  }

  /// Notes what the plies of a wall do not state.
  void note_unknown(LaminateWall& wall) {
    if (!without_endurance_.empty()) {
      wall.haigh.reset();
      report_.notes.push_back(
          {.code = "laminate.no_endurance",
           .text = fmt::format("{} states no endurance, so it cannot be told whether the plies "
                               "endure the turns of the wave generator",
                               shown(without_endurance_)),
           .path = wall.path,
           .equation = "LA-19",
           .severity = Severity::care,
           .next_step = "Give ply_endurance of the layer, from tests of your laminate."});
      without_endurance_.clear();
    }
    if (without_strength_.empty()) return;
    wall.reserve.reset();
    wall.proportional.reset();
    wall.first_ply = 0;
    report_.notes.push_back(
        {.code = "laminate.no_strength",
         .text = fmt::format("{} has no strengths, so the first failure is not known",
                             shown(without_strength_)),
         .path = wall.path,
         .equation = "LA-12",
         .severity = Severity::cannot_tell,
         .next_step = "Give ply_strength of the layer, or yield_strength of an isotropic ply."});
    without_strength_.clear();
  }

  void note(const LaminateWall& wall) {
    note_thickness(report_.notes, wall.path, *material_, wall.thickness);
    if (!wall.symmetric)
      report_.notes.push_back(
          {.code = "laminate.unsymmetric",
           .text =
               "the plies are not symmetric about the middle of the wall, so curing, moisture "
               "and assembly bend the wall; only the bending by the assembly is in the stresses",
           .path = wall.path,
           .equation = "LA-3",
           .severity = Severity::care,
           .next_step = "Set stacking = \"symmetric\", unless the laminate is meant so."});
    if (!wall.balanced && wall.axial_strain)
      report_.notes.push_back(
          {.code = "laminate.unbalanced",
           .text =
               fmt::format("torque changes the length of this section, by a strain of {:.3g} at "
                           "the torque of the load",
                           *wall.axial_strain),
           .path = wall.path,
           .equation = "LA-5",
           .severity = Severity::care});
  }

  const GearSet& gear_;
  LaminateReport& report_;
  const Material* material_ = nullptr;
  std::vector<LaminatePly<>> plies_;
  LaminateStiffness<> stiffness_;
  std::string without_strength_;
  std::string without_endurance_;
};

/// The least reserve of all tubes; absent if that of one of them is not known.
std::optional<double> reserve_of(const LaminateReport& report) {
  std::optional<double> least;
  for (const LaminateWall& wall : report.walls) {
    if (wall.plies.empty()) continue;  // a bottom
    if (!wall.reserve) return std::nullopt;
    take_least(least, wall.reserve);
  }
  return least;
}

/// The largest share of the Haigh line of all tubes; absent if that of one of them is not known.
std::optional<double> haigh_of(const LaminateReport& report) {
  std::optional<double> largest;
  for (const LaminateWall& wall : report.walls) {
    if (wall.plies.empty()) continue;  // a bottom
    if (!wall.haigh) return std::nullopt;
    take_largest(largest, *wall.haigh);
  }
  return largest;
}

std::string failure_sentence(const LaminateReport& report) {
  if (!report.reserve)
    return "It is not known at which load the first ply fails; the notes say what is missing.";
  const auto first = std::ranges::find(report.walls, report.reserve, &LaminateWall::reserve);
  if (*first->reserve == 0)
    return fmt::format("Ply {} of {} fails when the wave generator is put in.", first->first_ply,
                       first->path);
  return fmt::format("Ply {} of {} fails first, at {:.3g} times the load.", first->first_ply,
                     first->path, *first->reserve);
}

std::string sentence_of(const LaminateReport& report) {
  const std::string failure = failure_sentence(report);
  if (!report.haigh) return failure;
  return fmt::format("{} Over a turn the plies use {:.3g} of what they endure.", failure,
                     *report.haigh);
}

}  // namespace

bool has_laminates(const GearSet& gear) {
  bool any = false;
  if (gear.flexspline)
    for_each_section(*gear.flexspline, [&](std::string_view, const auto& section) {
      const std::string& material = material_name(*gear.flexspline, section);
      any = any || material_of(gear, material, "flexspline.material").is_laminate();
    });
  return any;
}

LaminateReport laminate_report(const GearSet& gear) {
  LaminateReport report;
  if (!gear.flexspline)
    throw InputError("flexspline", "must be given, because its walls are asked for");
  Walls walls(gear, report);
  for_each_section(*gear.flexspline, [&](std::string_view name, const auto& section) {
    const std::string& material = material_name(*gear.flexspline, section);
    if (material_of(gear, material, "flexspline.material").is_laminate())
      walls.add(fmt::format("flexspline.{}", name), section);
  });
  if (report.walls.empty())
    throw InputError("flexspline.material",
                     "names no laminate, and no section names one; give the material plies, "
                     "[[material.NAME.ply]]");
  if (gear.drive.wave_number < 2)
    report.notes.push_back({.code = "laminate.one_lobe",
                            .text = "one lobe shifts the wall without bending it",
                            .path = "drive.wave_number",
                            .equation = "LA-6",
                            .severity = Severity::information});
  report.notes.push_back(
      {.code = "laminate.left_out",
       .text = "stresses by curing and moisture, by the ends of the sections and by the teeth, and "
               "delamination are left out",
       .path = "flexspline",
       .equation = "LA-11",
       .severity = Severity::care});
  report.reserve = reserve_of(report);
  report.haigh = haigh_of(report);
  report.sentence = sentence_of(report);
  if (report.reserve && *report.reserve < 1)
    report.notes.push_back({.code = "laminate.fails",
                            .text = "a ply fails below the load",
                            .path = "load.torque",
                            .equation = "LA-14",
                            .severity = Severity::critical,
                            .next_step = "Lower the load, or change the plies."});
  if (report.haigh && *report.haigh > 1)
    report.notes.push_back(
        {.code = "laminate.fatigue",
         .text = "a ply does not endure the turns of the wave generator under this load",
         .path = "load.torque",
         .equation = "LA-19",
         .severity = Severity::critical,
         .next_step = "Lower the load or drive.radial_displacement, or change the plies."});
  report.equations = {"LA-1",  "LA-2",  "LA-3",  "LA-4",  "LA-5", "LA-6",
                      "LA-11", "LA-12", "LA-13", "LA-14", "LA-18"};
  const auto endures = [](const LaminateWall& wall) {
    return std::ranges::any_of(wall.plies, [](const PlyState& ply) { return !!ply.haigh; });
  };
  if (std::ranges::any_of(report.walls, endures)) report.equations.emplace_back("LA-19");
  return report;
}

}  // namespace strainwave

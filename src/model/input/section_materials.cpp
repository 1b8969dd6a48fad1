// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/section_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

void refuse_if_given(bool given, const FieldPath& field, std::string_view why) {
  if (given) throw InputError(field.text(), std::string(why));
}

/// The numbers of an isotropic material that neither a layer nor a laminate has.
void refuse_isotropic_numbers(const FieldPath& path, const Material& material,
                              std::string_view why) {
  refuse_if_given(material.yield_strength.has_value(), path / "yield_strength", why);
  refuse_if_given(material.ultimate_strength.has_value(), path / "ultimate_strength", why);
  refuse_if_given(material.fracture_toughness.has_value(), path / "fracture_toughness", why);
  refuse_if_given(material.fatigue.has_value(), path / "fatigue", why);
}

/// A layer that endures an amplitude also carries its peaks once.
void check_endurance(const FieldPath& path, const Material& layer) {
  if (!layer.ply_strength)
    throw InputError(path.text(), "needs ply_strength, because mean stresses count against it");
  const LaminaStrength& once = *layer.ply_strength;
  const LaminaEndurance& often = *layer.ply_endurance;
  const auto below = [&](std::string_view name, double amplitude, double strength) {
    require(amplitude < strength, path / name, amplitude, "Pa", [&] {
      return fmt::format("below {}, the smaller strength of ply_strength in this direction",
                         shown_quantity(strength, "Pa", 4));
    });
  };
  below("fibre", often.fibre, std::min(once.fibre_tension, once.fibre_compression));
  below("transverse", often.transverse,
        std::min(once.transverse_tension, once.transverse_compression));
  below("shear", often.shear, once.shear);
}

void check_layer(const FieldPath& path, const Material& layer) {
  if (!layer.shear_modulus)
    throw InputError((path / "shear_modulus").text(),
                     "must be given beside transverse_modulus (G12)");
  if (!layer.poissons_ratio)
    throw InputError((path / "poissons_ratio").text(),
                     "must be given beside transverse_modulus (nu12)");
  const double most = std::sqrt(*layer.youngs_modulus / *layer.transverse_modulus);
  require(std::abs(*layer.poissons_ratio) < most, path / "poissons_ratio", *layer.poissons_ratio,
          "1", [&] {
            return fmt::format(
                "of a smaller magnitude than sqrt(youngs_modulus/transverse_modulus) = {:.4g}",
                most);
          });
  refuse_isotropic_numbers(path, layer,
                           "is not read for a layer of a laminate; give its strengths as "
                           "ply_strength");
  if (layer.ply_endurance) check_endurance(path / "ply_endurance", layer);
  constexpr std::string_view kOfAll = "is not read for a layer; give that of the laminate";
  refuse_if_given(!layer.growth.empty(), path / "growth", kOfAll);
  refuse_if_given(layer.growth_bounds.has_value(), path / "growth_bounds", kOfAll);
  refuse_if_given(layer.growth_scatter.has_value(), path / "growth_scatter", kOfAll);
}

void check_laminate(const GearSet& gear, const FieldPath& path, const Material& laminate) {
  constexpr std::string_view kByPlies = "is not read beside ply, because the plies give it";
  refuse_if_given(laminate.based_on.has_value(), path / "based_on", kByPlies);
  refuse_if_given(laminate.youngs_modulus.has_value(), path / "youngs_modulus", kByPlies);
  refuse_if_given(laminate.shear_modulus.has_value(), path / "shear_modulus", kByPlies);
  refuse_if_given(laminate.poissons_ratio.has_value(), path / "poissons_ratio", kByPlies);
  refuse_if_given(laminate.is_layer(), path / "transverse_modulus", kByPlies);
  refuse_if_given(laminate.ply_strength.has_value(), path / "ply_strength", kByPlies);
  refuse_if_given(laminate.ply_endurance.has_value(), path / "ply_endurance", kByPlies);
  refuse_isotropic_numbers(path, laminate, "is not read for a laminate");
  if (!laminate.growth.empty() && !laminate.reference_modulus)
    throw InputError((path / "reference_modulus").text(),
                     "must be given beside growth: the E by which the law's K = sqrt(G*E) was made "
                     "from energy release rates");
  for (std::size_t i = 0; i < laminate.ply.size(); ++i) {
    const FieldPath field = (path / "ply")[i] / "material";
    (void)material_of(gear, laminate.ply[i].material, field);
    if (gear.material.at(laminate.ply[i].material).is_laminate())
      throw InputError(field.text(),
                       fmt::format("\"{}\" is a laminate; a ply is of a layer or of an isotropic "
                                   "material",
                                   shown(laminate.ply[i].material)));
  }
}

/// A material from which a part is made: no single layer, and a laminate only where it may be one.
void check_part(const GearSet& gear, std::string_view name, const FieldPath& field,
                bool may_be_laminate) {
  const Material& material = material_of(gear, name, field);
  if (material.is_layer())
    throw InputError(field.text(),
                     fmt::format("\"{}\" is a single layer; name a material with plies, [[material."
                                 "NAME.ply]]",
                                 shown(name)));
  if (material.is_laminate() && !may_be_laminate)
    throw InputError(field.text(),
                     fmt::format("\"{}\" is a laminate; only rim, barrel and diaphragm of a "
                                 "flexspline with crack_free = \"sections\" may be of one",
                                 shown(name)));
}

bool is_laminate(const GearSet& gear, std::string_view name) {
  return material_of(gear, name, "material").is_laminate();
}

/// Refuses what is not derived for a crack in a laminate.
void check_crack(const GearSet& gear, const FieldPath& path, const FlexsplineCrack& any) {
  const Flexspline& fs = *gear.flexspline;
  const auto refuse = [&](std::string_view field, std::string_view why) {
    throw InputError((path / field).text(), std::string(why));
  };
  constexpr std::string_view kOnlyThrough =
      "is in a laminate; the stress intensity of a laminate is known for kind = \"through\" only";
  std::visit(
      [&](const auto& crack) {
        if (!is_laminate(gear, material_name(fs, crack.place().part))) return;
        if constexpr (std::is_same_v<std::decay_t<decltype(crack)>, WallThroughCrack>) {
          if (crack.shell_correction)
            refuse("shell_correction",
                   "must be false for a crack in a laminate, because the correction for the "
                   "curvature is derived for isotropic walls");
          if (crack.count > 1)
            refuse("count",
                   "must be 1 for a crack in a laminate, because the influence of cracks on each "
                   "other is derived for isotropic walls");
          if (crack.compliance_table)
            refuse("compliance_table", "is for isotropic walls; the crack is in a laminate");
          if (crack.turn_table)
            refuse("turn_table", "is for isotropic walls; the crack is in a laminate");
        } else {
          refuse("kind", kOnlyThrough);
        }
      },
      any);
}

void check_sections(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const FieldPath path("flexspline");
  const bool sections = fs.crack_free == CrackFree::sections;
  check_part(gear, fs.material, path / "material", sections);
  for_each_section(fs, [&](std::string_view name, const auto& section) {
    const bool boss = name == "boss";
    if (section.material) check_part(gear, *section.material, path / name / "material", !boss);
    if (boss && is_laminate(gear, material_name(fs, section)))
      throw InputError((path / name / "material").text(),
                       "must be given and isotropic, because the flexspline is of a laminate");
  });
  if (!sections && fs.joint_compliance != 0)
    throw InputError((path / "joint_compliance").text(),
                     "is read only where crack_free = \"sections\"");
  for (std::size_t i = 0; i < fs.crack.size(); ++i)
    check_crack(gear, (path / "crack")[i], fs.crack[i]);
}

}  // namespace

const std::string& material_name(const Flexspline& flexspline, CrackedPart part) {
  const auto of = [&](const auto& section) -> const std::string& {
    return section ? material_name(flexspline, *section) : flexspline.material;
  };
  switch (part) {
    case CrackedPart::rim:
      return of(flexspline.rim);
    case CrackedPart::barrel:
      return of(flexspline.barrel);
    case CrackedPart::diaphragm:
      return of(flexspline.diaphragm);
    default:
      return flexspline.material;
  }
}

const Material& only_material(const GearSet& gear, const Flexspline& flexspline) {
  const Material& material = material_of(gear, flexspline.material, "flexspline.material");
  const auto refuse = [](const std::string& field, std::string_view name, std::string_view what) {
    throw InputError(field,
                     fmt::format("\"{}\" {}; this computation is derived for a flexspline of "
                                 "one isotropic material",
                                 shown(name), what));
  };
  if (material.is_laminate()) refuse("flexspline.material", flexspline.material, "is a laminate");
  for_each_section(flexspline, [&](std::string_view name, const auto& section) {
    if (section.material && &material_of(gear, *section.material, "flexspline") != &material)
      refuse((FieldPath("flexspline") / name / "material").text(), *section.material,
             "is another material than flexspline.material");
  });
  return material;
}

const Material& rim_material(const GearSet& gear, const Flexspline& flexspline) {
  const bool own = flexspline.rim && flexspline.rim->material;
  const std::string field = own ? "flexspline.rim.material" : "flexspline.material";
  const std::string& name = own ? *flexspline.rim->material : flexspline.material;
  const Material& material = material_of(gear, name, field);
  if (material.is_laminate())
    throw InputError(field,
                     fmt::format("\"{}\" is a laminate; the coupled drive is derived for an "
                                 "isotropic rim under the teeth, while barrel and diaphragm may be "
                                 "of laminates",
                                 shown(name)));
  return material;
}

double thickness_of_plies(const Material& laminate) {
  double sum = 0.0;
  for (const Ply& ply : laminate.ply) sum += ply.thickness;
  return laminate.stacking == Stacking::symmetric ? 2 * sum : sum;
}

std::optional<double> density_of(const GearSet& gear, std::string_view material) {
  const Material& of = material_of(gear, material, "material");
  if (of.density || !of.is_laminate()) return of.density;
  double mass = 0.0;
  double thickness = 0.0;
  for (const Ply& ply : of.ply) {
    const std::optional<double> density = density_of(gear, ply.material);
    if (!density) return std::nullopt;
    mass += *density * ply.thickness;
    thickness += ply.thickness;
  }
  return mass / thickness;
}

void note_thickness(std::vector<Note>& notes, const std::string& path, const Material& laminate,
                    double thickness) {
  constexpr double kRounded = 0.01;
  const double plies = thickness_of_plies(laminate);
  if (std::abs(plies / thickness - 1) <= kRounded) return;
  notes.push_back(
      {.code = "laminate.thickness",
       .text = fmt::format("the plies add up to {}, and the wall has {}; the plies are "
                           "scaled to fill the wall",
                           shown_quantity(plies, "m", 4), shown_quantity(thickness, "m", 4)),
       .path = path,
       .equation = "LA-3",
       .severity = Severity::care,
       .next_step = "Give the plies of this wall, or check their thicknesses."});
}

namespace {

/// Whether the drive has a layer, a laminate or a section with its own material.  Most drives have
/// none of them, and need no check.
bool has_layers(const GearSet& gear) {
  const auto special = [](const auto& named) {
    const Material& material = named.second;
    return !material.is_isotropic() || material.ply_strength || material.ply_endurance ||
           material.stacking;
  };
  if (std::ranges::any_of(gear.material, special)) return true;
  if (!gear.flexspline) return false;
  bool own = gear.flexspline->joint_compliance != 0;
  for_each_section(*gear.flexspline, [&](std::string_view, const auto& section) {
    own = own || section.material.has_value();
  });
  return own;
}

}  // namespace

void check_laminates(const GearSet& gear) {
  for (const auto& [name, material] : gear.material) {
    if (material.is_laminate()) continue;
    if (!material.fracture_energy && !material.reference_modulus) continue;
    const FieldPath path = FieldPath("material") / name;
    refuse_if_given(material.fracture_energy.has_value(), path / "fracture_energy",
                    "is read only beside ply; a metal has a fracture_toughness");
    refuse_if_given(material.reference_modulus.has_value(), path / "reference_modulus",
                    "is read only beside ply; a metal has a youngs_modulus");
  }
  if (!has_layers(gear)) return;
  for (const auto& [name, material] : gear.material) {
    const FieldPath path = FieldPath("material") / name;
    if (material.is_laminate())
      check_laminate(gear, path, material);
    else if (material.is_layer())
      check_layer(path, material);
    else {
      constexpr std::string_view kOfLayer = "is read only beside transverse_modulus";
      refuse_if_given(material.ply_strength.has_value(), path / "ply_strength", kOfLayer);
      refuse_if_given(material.ply_endurance.has_value(), path / "ply_endurance", kOfLayer);
    }
    if (!material.is_laminate())
      refuse_if_given(material.stacking.has_value(), path / "stacking", "is read only beside ply");
  }
  if (gear.wave_generator)
    check_part(gear, gear.wave_generator->material, FieldPath("wave_generator") / "material",
               false);
  if (gear.circular_spline)
    check_part(gear, gear.circular_spline->material, FieldPath("circular_spline") / "material",
               false);
  if (gear.output_shaft)
    check_part(gear, gear.output_shaft->material, FieldPath("output_shaft") / "material", false);
  if (gear.flexspline) check_sections(gear);
}

}  // namespace strainwave

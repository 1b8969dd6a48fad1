// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/gear_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "lazy_path.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/sought_number.hpp"

namespace strainwave {
namespace {

/// Calls `f(const Field&, number)` for the number at `path` of `gear` (const or not).
template <class Gear, class F>
void visit_number(Gear& gear, std::string_view path, const F& f) {
  bool found = false;
  const auto take = [&](const Field& field, double& number) {
    found = true;
    f(field, static_cast<std::conditional_t<std::is_const_v<Gear>, const double, double>&>(number));
  };
  walk_to_number(shape_of<GearSet>(), const_cast<GearSet*>(&gear), path, std::cref(take));
  if (found) return;
  std::vector<std::string> known;
  for_each_number(
      gear, [&](const FieldPath& at, const Field&, const double&) { known.push_back(at.text()); });
  const std::string near = nearest_word(path, known);
  throw InputError(path, "is not a number of this drive" +
                             (near.empty() ? std::string() : "; did you mean " + near + "?"));
}

}  // namespace

template const Shape& shape_of<Material>();
template const Shape& shape_of<GearSet>();

void require_isotropic(const Material& material) {
  if (material.is_laminate())
    throw InputError("ply", "makes a laminate, which has no single Young's modulus");
  if (material.is_layer())
    throw InputError("transverse_modulus", "makes a layer, which has no single Young's modulus");
}

ElasticConstants elastic_constants(const Material& material) {
  return elastic_constants(Lift<double>(), material);
}

double elastic_contradiction(const Material& material) {
  if (!material.is_isotropic() || !material.shear_modulus || !material.poissons_ratio) return 0.0;
  const double isotropic = *material.youngs_modulus / (2 * (1 + *material.poissons_ratio));
  return *material.shear_modulus / isotropic - 1;
}

double diaphragm_thickness(const Diaphragm& diaphragm, double radius) {
  return diaphragm_thickness(Lift<double>(), diaphragm, radius);
}

namespace {

/// Whether two isotropic materials are equally elastic.
bool equally_elastic(const Material& a, const Material& b) {
  const ElasticConstants one = elastic_constants(a);
  const ElasticConstants other = elastic_constants(b);
  return one.E == other.E && one.G == other.G && one.nu == other.nu;
}

using NamedMaterial = std::map<std::string, Material>::const_iterator;

/// The material of the first ply if a laminate is a solid wall, else the material itself.
NamedMaterial solid_wall(const GearSet& gear, const NamedMaterial& of) {
  NamedMaterial first = of;
  for (const Ply& ply : of->second.ply) {
    const auto found = gear.material.find(ply.material);
    if (found == gear.material.end() || !found->second.is_isotropic() ||
        (first != of && !equally_elastic(first->second, found->second)))
      return of;
    if (first == of) first = found;
  }
  return first;
}

/// A material by its name.  A drive has few, among which a search by text takes longer than a look
/// at each.
NamedMaterial found_material(const GearSet& gear, std::string_view name) {
  constexpr std::size_t kFew = 8;
  if (gear.material.size() > kFew) return gear.material.find(std::string(name));
  return std::ranges::find_if(gear.material,
                              [&](const auto& named) { return named.first == name; });
}

template <class MakeField>
const Material& material_for(const GearSet& gear, std::string_view name, const MakeField& field) {
  const auto found = found_material(gear, name);
  if (found != gear.material.end()) return solid_wall(gear, found)->second;
  std::vector<std::string> known;
  for (const auto& [known_name, material] : gear.material) known.push_back(known_name);
  throw InputError(field(),
                   fmt::format("\"{}\" is not one of the materials given ({})", shown(name),
                               shown(fmt::format("{}", fmt::join(known, ", ")))));
}

}  // namespace

const Material& material_of(const GearSet& gear, std::string_view name, std::string_view field) {
  return material_for(gear, name, [&] { return std::string(field); });
}

const Material& material_of(const GearSet& gear, std::string_view name, const FieldPath& field) {
  return material_for(gear, name, [&] { return field.text(); });
}

const Material& material_of(const GearSet& gear, std::string_view name, const LazyPath& field) {
  return material_for(gear, name, [&] { return field.text(); });
}

std::string_view solid_name(const GearSet& gear, std::string_view name) {
  const auto found = found_material(gear, name);
  return found == gear.material.end() ? name : std::string_view(solid_wall(gear, found)->first);
}

namespace {

/// The variables of inputs with the paths, and the correlations of those among them.
CorrelatedNormals normals_of(const GearSet& gear, const std::vector<std::string>& paths) {
  std::vector<RankCorrelation> pairs;
  for (const InputCorrelation& pair : gear.correlation) {
    const auto first = std::ranges::find(paths, pair.path);
    const auto second = std::ranges::find(paths, pair.with);
    if (first == paths.end() || second == paths.end()) continue;
    pairs.push_back({static_cast<std::size_t>(first - paths.begin()),
                     static_cast<std::size_t>(second - paths.begin()), pair.rank_correlation});
  }
  std::optional<CorrelatedNormals> normals = CorrelatedNormals::of(paths.size(), pairs);
  if (!normals)
    throw InputError("correlation",
                     "the rank correlations contradict each other, because their matrix is not "
                     "positive definite; bring them closer to 0");
  return *std::move(normals);
}

std::vector<std::string> scattering_paths(const GearSet& gear) {
  std::vector<std::string> paths;
  for (const InputScatter& scatter : gear.scatter) paths.push_back(scatter.path);
  return paths;
}

}  // namespace

CorrelatedNormals scattering_normals(const GearSet& gear) {
  return normals_of(gear, scattering_paths(gear));
}

std::vector<GrowthLevel> growth_levels(const GearSet& gear) {
  std::vector<GrowthLevel> levels;
  for (const auto& [name, material] : gear.material) {
    if (!material.growth_scatter) continue;
    const FieldPath path = FieldPath("material") / name / "growth_scatter";
    if (material.growth_scatter->level) levels.push_back({name, false, (path / "level").text()});
    if (material.growth_scatter->exponent)
      levels.push_back({name, true, (path / "exponent").text()});
  }
  return levels;
}

CorrelatedNormals life_normals(const GearSet& gear) {
  std::vector<std::string> paths = scattering_paths(gear);
  for (const GrowthLevel& level : growth_levels(gear)) paths.push_back(level.path);
  return normals_of(gear, paths);
}

KinematicError kinematic_error_of(const GearSet& gear) {
  std::vector<ErrorOrder> orders = gear.kinematic_error;
  if (gear.error_table)
    orders.insert(orders.end(), gear.error_table->lines.orders.begin(),
                  gear.error_table->lines.orders.end());
  return orders;
}

void drop_lost_paths(GearSet& gear, const GearSet& before) {
  const auto numbers_of = [](const GearSet& drive) {
    std::map<std::string, double, std::less<>> numbers;
    for_each_number(drive, [&](const FieldPath& path, const Field&, double number) {
      numbers.emplace(path.text(), number);
    });
    return numbers;
  };
  if (gear.inspection && !gear.inspection->place.empty()) {
    std::vector<std::string> cracks;
    for_each_crack(gear, [&](const CrackPath& crack, const auto&) { cracks.push_back(crack); });
    std::erase_if(gear.inspection->place, [&](const InspectedPlace& place) {
      return std::ranges::find(cracks, place.crack) == cracks.end();
    });
    // An inspection without places would see all cracks.
    if (gear.inspection->place.empty()) gear.inspection.reset();
  }
  if (gear.range.empty() && gear.scatter.empty()) return;
  const auto now = numbers_of(gear);
  const auto then = numbers_of(before);
  const auto lost = [&](std::string_view path) {
    const auto number = now.find(path);
    const auto old = then.find(path);
    return number == now.end() || old == then.end() || number->second != old->second;
  };
  for_each_path_list(gear, [&](std::string_view, auto& entries) {
    std::erase_if(entries,
                  [&](const auto& entry) { return std::ranges::any_of(entry.paths(), lost); });
  });
}

void set_number(GearSet& gear, std::string_view path, double value) {
  bool changed = false;
  visit_number(gear, path, [&](const Field&, double& number) {
    changed = number != value;
    number = value;
  });
  for_each_path_list(gear, [&](std::string_view, auto& entries) {
    std::erase_if(entries, [&](const auto& entry) {
      const auto paths = entry.paths();
      return std::ranges::find(paths, path) != paths.end();
    });
  });
  if (!changed) return;
  for (auto& [name, material] : gear.material) {
    const std::string table = (FieldPath("material") / name).text() + '.';
    if (material.origin.empty() || !path.starts_with(table)) continue;
    const std::string_view field = path.substr(table.size());
    if (field.find('.') != std::string_view::npos) continue;  // "a" is not a part of the name "a.b"
    const std::string remark = fmt::format("; {} was set since", field);
    if (material.origin.find(remark) == std::string::npos) material.origin += remark;
    std::erase(material.from_library, field);
  }
}

NumberAt number_at(const GearSet& gear, std::string_view path) {
  NumberAt result{.path = std::string(path), .field = {}};
  visit_number(gear, path, [&](const Field& field, const double& number) {
    result.field = field;
    result.value = number;
  });
  return result;
}

}  // namespace strainwave

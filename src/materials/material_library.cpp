// SPDX-License-Identifier: Apache-2.0
#include "strainwave/materials/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "material_data.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/toml_reader.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/materials/library_law.hpp"

namespace strainwave {

namespace {

/// The name in lower case without blanks; names that agree in this form count as equal.
std::string plain_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (std::isspace(code) == 0) result += static_cast<char>(std::tolower(code));
  }
  return result;
}

void check_text(const std::string& field, std::string_view text) {
  if (text.empty()) throw InputError(field, "must not be empty");
  if (std::ranges::any_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }))
    throw InputError(field, "must be one line, without control characters");
}

/// Calls `f(path, evidence)` for everything in a record that has a source.
template <class F>
void for_each_evidence(const MaterialRecord& record, const FieldPath& path, const F& f) {
  for_each_property(record, [&](std::string_view name, std::string_view, const auto& number) {
    f(path / name, number);
  });
  const auto list = [&](std::string_view name, const auto& elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) f((path / name)[i], elements[i]);
  };
  list("fatigue_limit", record.fatigue_limit);
  list("threshold", record.threshold);
  for (std::size_t i = 0; i < record.growth.size(); ++i)
    std::visit([&](const Evidence& law) { f((path / "growth")[i], law); }, record.growth[i]);
}

void check_names(const MaterialLibrary& library) {
  std::set<std::string> taken;
  const auto take = [&](const FieldPath& path, const std::string& name) {
    check_text(path.text(), name);
    if (!taken.insert(plain_name(name)).second)
      throw InputError(
          path.text(),
          fmt::format("\"{}\" is given twice; case and blanks do not count", shown(name)));
  };
  for (std::size_t i = 0; i < library.material.size(); ++i) {
    const MaterialRecord& record = library.material[i];
    const FieldPath path = FieldPath("material")[i];
    take(path / "name", record.name);
    for (std::size_t k = 0; k < record.aliases.size(); ++k)
      take((path / "aliases")[k], record.aliases[k]);
  }
}

void check_sources(const MaterialLibrary& library) {
  std::set<std::string> used;
  for (std::size_t i = 0; i < library.material.size(); ++i)
    for_each_evidence(library.material[i], FieldPath("material")[i],
                      [&](const FieldPath& path, const Evidence& evidence) {
                        const std::string field = (path / "source").text();
                        if (!library.source.contains(evidence.source))
                          throw InputError(field, fmt::format("\"{}\" is not a key of [source]",
                                                              shown(evidence.source)));
                        used.insert(evidence.source);
                        if (!evidence.remark.empty())
                          check_text((path / "remark").text(), evidence.remark);
                      });
  for (const auto& [key, text] : library.source) {
    const std::string field = (FieldPath("source") / key).text();
    check_text(field, text);
    if (!used.contains(key)) throw InputError(field, "is not used by any number");
  }
}

void check_ratios(const FieldPath& path, const StressRatios& ratios) {
  require(ratios[0] <= ratios[1], (path / "stress_ratio")[0].text(), ratios[0], "1",
          "first <= second");
}

void check_law(const FieldPath& path, const ParisLaw& law) {
  check_ratios(path, law.stress_ratio);
  check_text((path / "environment").text(), law.environment);
  if (law.from && law.to)
    require(*law.from < *law.to, (path / "to").text(), *law.to, "Pa*m^0.5", "to > from");
}

void check_law(const FieldPath& path, const NasgroLaw& law) {
  check_text((path / "environment").text(), law.environment);
  require(law.part_through_toughness >= law.plane_strain_toughness,
          (path / "part_through_toughness").text(), law.part_through_toughness, "Pa*m^0.5",
          "part_through_toughness >= plane_strain_toughness");
  require(law.threshold_at_one < law.plane_strain_toughness, (path / "threshold_at_one").text(),
          law.threshold_at_one, "Pa*m^0.5", "threshold_at_one < plane_strain_toughness");
}

/// Checks that two branches of one law meet at the end of the first; otherwise a number is
/// mistyped.
void check_branches(const FieldPath& path, const std::vector<GrowthLaw>& growth) {
  for (std::size_t i = 1; i < growth.size(); ++i) {
    const auto* const first = std::get_if<ParisLaw>(&growth[i - 1]);
    const auto* const second = std::get_if<ParisLaw>(&growth[i]);
    if (first == nullptr || second == nullptr || !first->to || !second->from ||
        first->stress_ratio != second->stress_ratio || first->environment != second->environment)
      continue;
    require(*second->from == *first->to, (path[i] / "from").text(), *second->from, "Pa*m^0.5",
            "from = to of the branch before it");
    constexpr double kDigits = 0.01;  // accuracy of three printed digits
    require(std::abs(transition_range(*first, *second) / *first->to - 1) < kDigits,
            (path[i] / "from").text(), *second->from, "Pa*m^0.5",
            "the branches give the same growth where they meet");
  }
}

/// Checks that a layer has all its elastic constants, and all strengths or none.
void check_layer(const FieldPath& path, const MaterialRecord& record) {
  const auto demand = [&](const auto& number, std::string_view name, std::string_view beside) {
    if (!number)
      throw InputError((path / name).text(), fmt::format("must be given beside {}", beside));
  };
  const auto forbid = [&](const auto& number, std::string_view name) {
    if (number) throw InputError((path / name).text(), "is read only beside transverse_modulus");
  };
  using Strength = std::pair<const std::optional<Sourced<StressKind>>*, const char*>;
  const std::array<Strength, 5> strengths = {
      Strength{&record.fibre_tension, "fibre_tension"},
      {&record.fibre_compression, "fibre_compression"},
      {&record.transverse_tension, "transverse_tension"},
      {&record.transverse_compression, "transverse_compression"},
      {&record.shear_strength, "shear_strength"}};
  if (!record.transverse_modulus) {
    for (const auto& [strength, name] : strengths) forbid(*strength, name);
    return;
  }
  demand(record.shear_modulus, "shear_modulus", "transverse_modulus");
  demand(record.poissons_ratio, "poissons_ratio", "transverse_modulus");
  const auto* const given =
      std::ranges::find_if(strengths, [](const auto& of) { return of.first->has_value(); });
  if (given == strengths.end()) return;
  for (const auto& [strength, name] : strengths) demand(*strength, name, given->second);
}

void check_record(const FieldPath& path, const MaterialRecord& record) {
  if (record.use.empty()) throw InputError((path / "use").text(), "must name at least one use");
  if (std::set<MaterialUse>(record.use.begin(), record.use.end()).size() != record.use.size())
    throw InputError((path / "use").text(), "names a use twice");
  check_text((path / "treatment").text(), record.treatment);
  if (!record.remark.empty()) check_text((path / "remark").text(), record.remark);
  if (!record.youngs_modulus) throw InputError((path / "youngs_modulus").text(), "must be given");
  if (record.yield_strength && record.ultimate_strength)
    require(record.ultimate_strength->value >= record.yield_strength->value,
            (path / "ultimate_strength" / "value").text(), record.ultimate_strength->value, "Pa",
            "ultimate_strength >= yield_strength");
  check_layer(path, record);
  try {
    const Material material = as_material(record);
    if (material.is_isotropic()) (void)elastic_constants(material);
  } catch (const InputError& error) {
    const FieldPath field = path / error.field();
    if (error.rule().empty()) throw InputError(field.text(), "must be given, or shear_modulus");
    throw InputError((field / "value").text(), record.shear_modulus->value, "Pa", error.rule());
  }
  for (std::size_t i = 0; i < record.fatigue_limit.size(); ++i)
    if (record.ultimate_strength)
      require(record.fatigue_limit[i].value < record.ultimate_strength->value,
              ((path / "fatigue_limit")[i] / "value").text(), record.fatigue_limit[i].value, "Pa",
              "fatigue limit < ultimate_strength");
  for (std::size_t i = 0; i < record.threshold.size(); ++i) {
    const FieldPath at = (path / "threshold")[i];
    check_ratios(at, record.threshold[i].stress_ratio);
    check_text((at / "environment").text(), record.threshold[i].environment);
  }
  for (std::size_t i = 0; i < record.growth.size(); ++i)
    std::visit([&](const auto& law) { check_law((path / "growth")[i], law); }, record.growth[i]);
  check_branches(path / "growth", record.growth);
}

void check(const MaterialLibrary& library) {
  if (library.format != kMaterialFormat)
    throw InputError("format", fmt::format("\"{}\" is not known; this version reads \"{}\"",
                                           shown(library.format), kMaterialFormat));
  for_each_number(library, [](const FieldPath& path, const Field& field, const double& value) {
    require(field.range.contains(value), path.text(), value, field.unit,
            rule_text(field.range, field.unit));
  });
  check_names(library);
  check_sources(library);
  for (std::size_t i = 0; i < library.material.size(); ++i)
    check_record(FieldPath("material")[i], library.material[i]);
}

const MaterialLibrary& built_in() {
  static const MaterialLibrary library =
      parse_material_library(material_data(), "data/materials.toml");
  return library;
}

}  // namespace

MaterialLibrary parse_material_library(std::string_view text, std::string_view file_name) {
  const toml::table table = parse_toml(text, file_name);
  TomlReader reader(file_name);
  MaterialLibrary library;
  reader.read_table(table, FieldPath(), library);
  try {
    check(library);
  } catch (const InputError& error) {
    throw reader.located(error);
  }
  return library;
}

std::span<const MaterialRecord> material_library() { return built_in().material; }

std::string_view material_source(std::string_view key) {
  const auto& sources = built_in().source;
  const auto found = sources.find(std::string(key));
  if (found == sources.end())
    throw InputError("source",
                     fmt::format("\"{}\" is not a source of the material library", shown(key)));
  return found->second;
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const MaterialRecord& record : material_library()) {
    names.push_back(record.name);
    names.insert(names.end(), record.aliases.begin(), record.aliases.end());
  }
  return names;
}

const MaterialRecord* find_material(std::string_view name_or_alias) {
  const auto find = [&](const auto& same) -> const MaterialRecord* {
    for (const MaterialRecord& record : material_library())
      if (same(record.name) || std::ranges::any_of(record.aliases, same)) return &record;
    return nullptr;
  };
  const auto* const exact = find([&](const std::string& name) { return name == name_or_alias; });
  if (exact != nullptr) return exact;
  const std::string wanted = plain_name(name_or_alias);
  return find([&](const std::string& name) { return plain_name(name) == wanted; });
}

std::string meant_material(std::string_view unknown, std::span<const std::string> known) {
  constexpr std::size_t kMostNames = 4;
  constexpr std::size_t kLongEnough = 8;
  std::vector<std::string> names = words_beginning(unknown, known);
  if (names.size() > kMostNames) names.resize(kMostNames);
  if (names.empty() && unknown.size() >= kLongEnough) {
    const std::string near = nearest_word(unknown, known);
    if (!near.empty()) names.push_back(near);
  }
  return names.empty() ? std::string() : fmt::format("did you mean {}?", fmt::join(names, " or "));
}

const MaterialRecord& require_material(std::string_view name_or_alias) {
  if (const MaterialRecord* const record = find_material(name_or_alias)) return *record;
  const std::string meant = meant_material(name_or_alias, material_names());
  throw InputError("material",
                   fmt::format("\"{}\" is not in the material library; {}", shown(name_or_alias),
                               meant.empty() ? "strainwave material list shows the names" : meant));
}

Material as_material(const MaterialRecord& record) { return completed({}, record); }

Material completed(const Material& own, const MaterialRecord& record) {
  Material material = own;
  std::vector<std::string> own_numbers;
  std::vector<std::string> taken;
  std::vector<std::string> unverified;
  const bool own_E = own.youngs_modulus.has_value();
  const bool own_elastic = own_E || own.shear_modulus || own.poissons_ratio;
  const auto take = [&](auto& value, std::string_view name, bool wanted) {
    for_each_property(record, [&](std::string_view at, std::string_view words, const auto& number) {
      if (at != name || !wanted) return;
      value = number.value;
      material.from_library.emplace_back(name);
      // Every stiffness depends on Young's modulus, so the text also gives the remark that
      // contradicts it.
      const bool with_remark = name == "youngs_modulus" && !number.remark.empty();
      taken.push_back(fmt::format(
          "{} {} ({}{}{})", words, shown_quantity(number.value, unit_of(number), 4),
          enum_name(number.confidence), with_remark ? "; " : "", with_remark ? number.remark : ""));
      if (number.confidence == Confidence::unverified) unverified.emplace_back(words);
    });
  };
  // Two of E, G and nu define a material: both others of the file define E.
  const bool defines_E =
      !own_E && own.shear_modulus && own.poissons_ratio && !record.transverse_modulus;
  if (defines_E) material.youngs_modulus = 2 * *own.shear_modulus * (1 + *own.poissons_ratio);
  take(material.youngs_modulus, "youngs_modulus", !own_E && !defines_E);
  // The four constants of a layer are independent.
  const bool layer = record.transverse_modulus.has_value();
  take(material.transverse_modulus, "transverse_modulus", !own.transverse_modulus);
  take(material.shear_modulus, "shear_modulus",
       layer
           ? !own.shear_modulus
           : !own_elastic || (!own.shear_modulus && !own.poissons_ratio && !record.poissons_ratio));
  take(material.poissons_ratio, "poissons_ratio",
       !own.poissons_ratio && (layer || !own.shear_modulus));
  if (!own.ply_strength && record.fibre_tension) {
    LaminaStrength strength;
    take(strength.fibre_tension, "fibre_tension", true);
    take(strength.fibre_compression, "fibre_compression", true);
    take(strength.transverse_tension, "transverse_tension", true);
    take(strength.transverse_compression, "transverse_compression", true);
    take(strength.shear, "shear_strength", true);
    material.ply_strength = strength;
    material.from_library.emplace_back("ply_strength");
  }
  take(material.yield_strength, "yield_strength", !own.yield_strength);
  take(material.ultimate_strength, "ultimate_strength", !own.ultimate_strength);
  take(material.fracture_toughness, "fracture_toughness", !own.fracture_toughness);
  // Density and the numbers of fatigue and growth do not enter stiffness and strength, so they do
  // not decide whether the material is verified; the origin names their confidence.
  const auto whole = [&](bool given, std::string_view name, const std::string& words,
                         const Evidence& evidence, const auto& fill) {
    if (given) return;
    fill();
    material.from_library.emplace_back(name);
    taken.push_back(fmt::format("{} ({})", words, enum_name(evidence.confidence)));
  };
  const auto reversed = std::ranges::find(record.fatigue_limit, -1.0, &FatigueLimit::stress_ratio);
  if (reversed != record.fatigue_limit.end())
    whole(own.fatigue.has_value(), "fatigue",
          "fatigue limit " + shown_quantity(reversed->value, "Pa", 4), *reversed, [&] {
            material.fatigue =
                FatigueStrength{.limit = reversed->value, .cycles = reversed->cycles};
          });
  if (record.density)
    whole(own.density.has_value(), "density",
          "density " + shown_quantity(record.density->value, unit_of(*record.density), 4),
          *record.density, [&] { material.density = record.density->value; });
  const std::optional<RateLaw> law = single_rate_law(record);
  if (law)
    std::visit(
        [&](const Evidence& evidence) {
          whole(!own.growth.empty(), "growth", "law of crack growth", evidence,
                [&] { material.growth = {*law}; });
        },
        record.growth.front());
  if (!record.threshold.empty())
    whole(own.growth_bounds.has_value() || !own.growth.empty(), "growth_bounds",
          "threshold of crack growth " +
              shown_quantity(record.threshold.front().value, "Pa*m^0.5", 4),
          record.threshold.front(), [&] { material.growth_bounds = growth_bounds(record); });
  else if (law && !own.growth_bounds && own.growth.empty()) {
    material.growth_bounds = growth_bounds(record);
    material.from_library.emplace_back("growth_bounds");
  }
  for_each_number(own, [&](const FieldPath& path, const Field& field, const double& value) {
    if (value != 0)
      own_numbers.push_back(
          fmt::format("{} {}", path.text(), shown_quantity(value, field.unit, 4)));
  });
  if (defines_E)
    own_numbers.push_back(fmt::format("youngs_modulus {} = 2 G (1 + nu)",
                                      shown_quantity(*material.youngs_modulus, "Pa", 4)));
  const std::string numbers = taken.empty() ? "nothing" : fmt::format("{}", fmt::join(taken, ", "));
  material.origin =
      own.based_on
          ? fmt::format(
                "based on {} of the material library; values of the library: {}; own values: {}",
                record.name, numbers,
                own_numbers.empty() ? "nothing" : fmt::format("{}", fmt::join(own_numbers, ", ")))
          : fmt::format("values of the material library, {}: {}", record.name, numbers);
  material.verified = unverified.empty();
  if (!material.verified)
    material.origin += fmt::format(
        "; these values are unverified, so check them before you base a decision on them: {}",
        fmt::join(unverified, ", "));
  return material;
}

double transition_range(const ParisLaw& first, const ParisLaw& second) {
  require(first.exponent != second.exponent, "exponent", second.exponent, "1",
          "an exponent that differs from that of the first law");
  return units::MPa * std::pow(first.coefficient / second.coefficient,
                               1 / (second.exponent - first.exponent));  // (MA-3)
}

}  // namespace strainwave

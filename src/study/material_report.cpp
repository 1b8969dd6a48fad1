// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/material_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report_cells.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/result_writer.hpp"

namespace strainwave {
namespace {

std::string use_text(const MaterialRecord& record) {
  std::vector<std::string_view> names;
  for (const MaterialUse use : record.use) names.push_back(enum_name(use));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string ratio_text(const StressRatios& R) {
  return R[0] == R[1] ? fmt::format("R = {:g}", R[0]) : fmt::format("R = {:g} to {:g}", R[0], R[1]);
}

std::string scatter_text(const Evidence& evidence) {
  return evidence.scatter ? percent(*evidence.scatter) : "not stated";
}

// --- One datum after the other, the same for all forms -----------------------------------------

/// A number or law of a record in words.
struct Datum {
  std::string what;
  std::string value;
  const Evidence* evidence = nullptr;
};

std::string words_of(const FatigueLimit& limit) {
  return fmt::format("fatigue limit, R = {:g}, {}{}", limit.stress_ratio,
                     limit.loading == FatigueLoading::not_stated         ? "loading not stated"
                     : limit.loading == FatigueLoading::rotating_bending ? "rotating bending"
                                                                         : enum_name(limit.loading),
                     limit.cycles ? fmt::format(", {:g} cycles", *limit.cycles) : std::string());
}

Datum datum_of(const ParisLaw& law) {
  const auto end = [](const std::optional<double>& K, std::string_view word) {
    return K ? fmt::format(", {} {}", word, short_quantity(*K, "Pa*m^0.5")) : std::string();
  };
  return {fmt::format("growth, power law, {}, {}{}{}", ratio_text(law.stress_ratio),
                      law.environment, end(law.from, "from"), end(law.to, "to")),
          fmt::format("C = {}, m = {:g}", short_quantity(law.coefficient, "m"), law.exponent),
          &law};
}

Datum datum_of(const NasgroLaw& law) {
  const auto K = [](double value) { return short_quantity(value, "Pa*m^0.5"); };
  return {fmt::format("growth, NASGRO, all R, {}", law.environment),
          fmt::format("C = {}, n = {:g}, p = {:g}, q = {:g}, K_Ic = {}, K_Ie = {}, A_k = {:g}, "
                      "B_k = {:g}, Delta K_1 = {}, C_th+ = {:g}, C_th- = {:g}, alpha = {:g}, "
                      "S_max/sigma_0 = {:g}, a_0 = {:.4g} mm",
                      short_quantity(law.coefficient, "m"), law.exponent, law.threshold_exponent,
                      law.instability_exponent, K(law.plane_strain_toughness),
                      K(law.part_through_toughness), law.thickness_A, law.thickness_B,
                      K(law.threshold_at_one), law.threshold_slope_plus, law.threshold_slope_minus,
                      law.constraint, law.stress_level, law.intrinsic_crack_length / units::mm),
          &law};
}

std::vector<Datum> data_of(const MaterialRecord& record) {
  std::vector<Datum> data;
  for_each_property(record, [&](std::string_view, std::string_view words, const auto& number) {
    data.push_back({std::string(words), short_quantity(number.value, unit_of(number)), &number});
  });
  for (const FatigueLimit& limit : record.fatigue_limit)
    data.push_back({words_of(limit), short_quantity(limit.value, "Pa"), &limit});
  for (const GrowthThreshold& threshold : record.threshold)
    data.push_back({fmt::format("growth threshold, {}, {}", ratio_text(threshold.stress_ratio),
                                threshold.environment),
                    short_quantity(threshold.value, "Pa*m^0.5"), &threshold});
  for (const GrowthLaw& law : record.growth)
    data.push_back(std::visit([](const auto& one) { return datum_of(one); }, law));
  return data;
}

void add(MaterialData& data, const MaterialRecord& record) {
  data.material.push_back(record);
  for (const Datum& datum : data_of(record))
    data.source[datum.evidence->source] = material_source(datum.evidence->source);
}

// --- Text ---------------------------------------------------------------------------------------

std::string paragraph(const std::string& text, std::size_t indent) {
  return std::string(indent, ' ') + wrapped(text, kTextWidth - indent, indent) + '\n';
}

template <class Kind>
std::string cell(const std::optional<Sourced<Kind>>& number, double unit) {
  if (!number) return "-";
  return fmt::format("{:.4g}{}", number->value / unit,
                     number->confidence == Confidence::unverified ? "*" : "");
}

}  // namespace

MaterialData material_list(std::optional<MaterialUse> use) {
  MaterialData data;
  for (const MaterialRecord& record : material_library())
    if (!use || std::ranges::find(record.use, *use) != record.use.end()) add(data, record);
  return data;
}

MaterialData material_show(std::string_view name) {
  MaterialData data;
  add(data, require_material(name));
  return data;
}

std::string material_list_text(const MaterialData& data) {
  std::string text =
      "Steels of the material library; * unverified, - not known\n"
      "E in GPa, strengths in MPa, K_Ic in MPa*m^0.5\n\n";
  text += fmt::format("{:<22}{:>7}{:>8}{:>8}{:>9}{:>8}  {:<15}{}\n", "name", "E", "nu", "yield",
                      "tensile", "K_Ic", "growth", "use");
  for (const MaterialRecord& record : data.material) {
    std::vector<std::string_view> laws;
    for (const GrowthLaw& law : record.growth) {
      const std::string_view kind = std::visit([](const auto& one) { return one.kKind; }, law);
      if (std::ranges::find(laws, kind) == laws.end()) laws.push_back(kind);
    }
    text += fmt::format("{:<22}{:>7}{:>8}{:>8}{:>9}{:>8}  {:<15}{}\n", record.name,
                        cell(record.youngs_modulus, units::GPa), cell(record.poissons_ratio, 1),
                        cell(record.yield_strength, units::MPa),
                        cell(record.ultimate_strength, units::MPa),
                        cell(record.fracture_toughness, units::MPa),
                        laws.empty() ? std::string("-") : fmt::format("{}", fmt::join(laws, ", ")),
                        use_text(record));
  }
  return text + "\nstrainwave material show NAME gives sources, scatter and remarks.\n";
}

std::string material_list_markdown(const MaterialData& data) {
  std::string text =
      "# Material library\n\nMade by `strainwave material list --format markdown` from "
      "`data/materials.toml`.\n\n"
      "A member of a drive may name any of these steels, by name or alias, in place of a table of\n"
      "the input file: `material = \"17-4PH H900\"`. Case and blanks do not matter. A table\n"
      "`[material.\"17-4PH H900\"]` in the file always wins over the library, and must then be\n"
      "complete: the two are not mixed. The corrected method lists in a note what it took from "
      "the\nlibrary, and which of it is unverified.\n\n"
      "What the confidences mean, and how numbers were converted, is in chapter MA of the theory\n"
      "manual. Scatter is one standard deviation over the value.\n";
  for (const MaterialRecord& record : data.material) {
    text += fmt::format("\n## {}\n\nFor: {}. Treatment: {}.", record.name, use_text(record),
                        record.treatment);
    if (!record.aliases.empty()) text += fmt::format(" Also: {}.", fmt::join(record.aliases, ", "));
    if (!record.remark.empty()) text += fmt::format(" Remark: {}.", record.remark);
    text +=
        "\n\n| what | value | confidence | scatter | source | remark "
        "|\n|---|---|---|---|---|---|\n";
    for (const Datum& datum : data_of(record))
      text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", datum.what, datum.value,
                          enum_name(datum.evidence->confidence), scatter_text(*datum.evidence),
                          datum.evidence->source, datum.evidence->remark);
  }
  text += "\n## Sources\n\n| key | source |\n|---|---|\n";
  for (const auto& [key, work] : data.source) text += fmt::format("| {} | {} |\n", key, work);
  return text;
}

std::string material_text(const MaterialData& data) {
  const MaterialRecord& record = data.material.front();
  std::string text = record.name + '\n';
  const auto line = [&](std::string_view label, const std::string& content) {
    if (!content.empty()) text += paragraph(fmt::format("{}: {}", label, content), 2);
  };
  line("also", fmt::format("{}", fmt::join(record.aliases, ", ")));
  line("use", use_text(record));
  line("treatment", record.treatment);
  line("remark", record.remark);
  for (const Datum& datum : data_of(record)) {
    text += '\n' + paragraph(fmt::format("{}: {}", datum.what, datum.value), 2);
    text +=
        paragraph(fmt::format("{}, scatter {}, source {}", enum_name(datum.evidence->confidence),
                              scatter_text(*datum.evidence), datum.evidence->source),
                  4);
    if (!datum.evidence->remark.empty()) text += paragraph(datum.evidence->remark, 4);
  }
  text += "\nSources\n";
  for (const auto& [key, work] : data.source)
    text += paragraph(fmt::format("{}: {}", key, work), 2);
  return text;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/present/table.hpp"

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
  return evidence.scatter ? percent(*evidence.scatter, 3) : "not stated";
}

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
    return K ? fmt::format(", {} {}", word, shown_quantity(*K, "Pa*m^0.5", 4)) : std::string();
  };
  return {fmt::format("growth, power law, {}, {}{}{}", ratio_text(law.stress_ratio),
                      law.environment, end(law.from, "from"), end(law.to, "to")),
          fmt::format("C = {:.4g} m, m = {:g}", law.coefficient, law.exponent), &law};
}

Datum datum_of(const NasgroLaw& law) {
  const auto K = [](double value) { return shown_quantity(value, "Pa*m^0.5", 4); };
  return {
      fmt::format("growth, NASGRO, all R, {}", law.environment),
      fmt::format("C = {:.4g} m, n = {:g}, p = {:g}, q = {:g}, K_Ic = {}, K_Ie = {}, A_k = {:g}, "
                  "B_k = {:g}, Delta K_1 = {}, C_th+ = {:g}, C_th- = {:g}, alpha = {:g}, "
                  "S_max/sigma_0 = {:g}, a_0 = {}",
                  law.coefficient, law.exponent, law.threshold_exponent, law.instability_exponent,
                  K(law.plane_strain_toughness), K(law.part_through_toughness), law.thickness_A,
                  law.thickness_B, K(law.threshold_at_one), law.threshold_slope_plus,
                  law.threshold_slope_minus, law.constraint, law.stress_level,
                  shown_quantity(law.intrinsic_crack_length, "m", 4)),
      &law};
}

std::vector<Datum> data_of(const MaterialRecord& record) {
  std::vector<Datum> data;
  for_each_property(record, [&](std::string_view, std::string_view words, const auto& number) {
    data.push_back({std::string(words), shown_quantity(number.value, unit_of(number), 4), &number});
  });
  for (const FatigueLimit& limit : record.fatigue_limit)
    data.push_back({words_of(limit), shown_quantity(limit.value, "Pa", 4), &limit});
  for (const GrowthThreshold& threshold : record.threshold)
    data.push_back({fmt::format("growth threshold, {}, {}", ratio_text(threshold.stress_ratio),
                                threshold.environment),
                    shown_quantity(threshold.value, "Pa*m^0.5", 4), &threshold});
  for (const GrowthLaw& law : record.growth)
    data.push_back(std::visit([](const auto& one) { return datum_of(one); }, law));
  return data;
}

template <class Kind>
std::string number_in(const std::optional<Sourced<Kind>>& number, double unit) {
  if (!number) return "-";
  return fmt::format("{:.4g}{}", number->value / unit,
                     number->confidence == Confidence::unverified ? "*" : "");
}

}  // namespace

std::string material_list_text(const MaterialData& data) {
  const DisplayUnit modulus = display_unit({}, "Pa", {"GPa", units::GPa});
  const DisplayUnit strength = display_unit({}, "Pa");
  const DisplayUnit toughness = display_unit({}, "Pa*m^0.5");
  std::string text = fmt::format(
      "Materials of the library; * means unverified, - means not known\n"
      "E in {}, strengths in {}, K_Ic in {}\n\n",
      modulus.text, strength.text, toughness.text);
  Table table{.head = {"name", "E", "nu", "yield", "tensile", "K_Ic", "growth", "use"},
              .align = "lrrrrrll"};
  for (const MaterialRecord& record : data.material) {
    std::vector<std::string_view> laws;
    for (const GrowthLaw& law : record.growth) {
      const std::string_view kind = std::visit([](const auto& one) { return one.kKind; }, law);
      if (std::ranges::find(laws, kind) == laws.end()) laws.push_back(kind);
    }
    table.rows.push_back(
        {record.name, number_in(record.youngs_modulus, modulus.in_si),
         number_in(record.poissons_ratio, 1), number_in(record.yield_strength, strength.in_si),
         number_in(record.ultimate_strength, strength.in_si),
         number_in(record.fracture_toughness, toughness.in_si),
         laws.empty() ? "-" : fmt::format("{}", fmt::join(laws, ", ")), use_text(record)});
  }
  return text + text_table(table) +
         "\nstrainwave material show NAME gives sources, scatter and remarks.\n";
}

std::string material_list_markdown(const MaterialData& data) {
  std::string text =
      "# Material library\n\n`strainwave material list --format markdown` writes this page from "
      "`data/materials.toml`.\n\n"
      "A member of a drive may name any of these steels, and a ply of a laminate any layer, by "
      "name or\n"
      "alias, in place of a table of\n"
      "the input file: `material = \"17-4PH H900\"`. Case and blanks do not matter. A table\n"
      "`[material.\"17-4PH H900\"]` in the file always wins over the library. A table with\n"
      "`based_on = \"17-4PH H900\"`, under any name, uses the library's values for all fields that "
      "it\n"
      "leaves out. In this way you can add or replace one number:\n\n"
      "```toml\n[material.flexspline]\nbased_on = \"17-4PH H900\"\n"
      "fracture_toughness = \"50 MPa*m^0.5\"\n```\n\n"
      "Two of E, G and nu define a material. A shear modulus in the table therefore replaces the\n"
      "Poisson's ratio of the library, and any of the three in the table replaces the library's "
      "shear\n"
      "modulus. G and nu of the table define E = 2G(1+nu) in place of the library's Young's "
      "modulus.\n"
      "The corrected method lists in a note the values of the library, the values of the table, "
      "and\n"
      "the unverified values.\n\n"
      "Chapter MA of the theory manual explains the confidences and the conversion of numbers.\n"
      "Scatter is one standard deviation over the value.\n";
  for (const MaterialRecord& record : data.material) {
    const Table about{
        .head = {"use", "treatment", "other names", "remark"},
        .rows = {{use_text(record), record.treatment,
                  fmt::format("{}", fmt::join(record.aliases, ", ")), record.remark}}};
    text += fmt::format("\n## {}\n\n{}", record.name, markdown_table(about));
    Table table{.head = {"what", "value", "confidence", "scatter", "source", "remark"}};
    for (const Datum& datum : data_of(record))
      table.rows.push_back(
          {datum.what, datum.value, std::string(enum_name(datum.evidence->confidence)),
           scatter_text(*datum.evidence), datum.evidence->source, datum.evidence->remark});
    text += '\n' + markdown_table(table);
  }
  Table sources{.head = {"key", "source"}};
  for (const auto& [key, work] : data.source) sources.rows.push_back({key, work});
  return text + "\n## Sources\n\n" + markdown_table(sources);
}

std::string material_text(const MaterialData& data) {
  const MaterialRecord& record = data.material.front();
  std::string text = record.name + '\n';
  const auto line = [&](std::string_view label, const std::string& content) {
    if (!content.empty()) text += paragraph(fmt::format("{}: {}", label, content), 2, 0);
  };
  line("also", fmt::format("{}", fmt::join(record.aliases, ", ")));
  line("use", use_text(record));
  line("treatment", record.treatment);
  line("remark", record.remark);
  for (const Datum& datum : data_of(record)) {
    text += '\n' + paragraph(fmt::format("{}: {}", datum.what, datum.value), 2, 0);
    text +=
        paragraph(fmt::format("{}, scatter {}, source {}", enum_name(datum.evidence->confidence),
                              scatter_text(*datum.evidence), datum.evidence->source),
                  4);
    if (!datum.evidence->remark.empty()) text += paragraph(datum.evidence->remark, 4, 0);
  }
  text += "\nSources\n";
  for (const auto& [key, work] : data.source)
    text += paragraph(fmt::format("{}: {}", key, work), 2, 0);
  return text;
}

}  // namespace strainwave

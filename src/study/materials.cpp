// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/materials.hpp"

#include <algorithm>

namespace strainwave {
namespace {

void add(MaterialData& data, const MaterialRecord& record) {
  data.material.push_back(record);
  const auto cite = [&](const Evidence& evidence) {
    data.source[evidence.source] = material_source(evidence.source);
  };
  for_each_property(record, [&](auto, auto, const auto& number) { cite(number); });
  std::ranges::for_each(record.fatigue_limit, cite);
  std::ranges::for_each(record.threshold, cite);
  for (const GrowthLaw& law : record.growth) std::visit(cite, law);
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

}  // namespace strainwave

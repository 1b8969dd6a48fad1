// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "field_writer.hpp"
#include "fields_at_load.hpp"
#include "strainwave/fe_study/output_files.hpp"
#include "strainwave/fem/vtu.hpp"

namespace strainwave::fe_study {
std::vector<OutputFile> vtu_files(const RunResult& result, const GearSet& gear,
                                  const Ranks& ranks) {
  std::vector<OutputFile> files;
  FieldWriter writer(files, ranks);
  const auto add_wall = [&](const auto& crack) {
    for (const auto* const one : {&crack.positive, &crack.negative}) {
      const std::string stem =
          file_stem(crack.path) + (one == &crack.positive ? "_positive" : "_negative");
      const fem::SampledFields& fields = one->solid.fields;
      using Pieces = std::vector<std::string>;
      writer.add(
          stem, [&] { return fem::vtu_text(fields); },
          [&](const Pieces& pieces) { return fem::pvtu_text(pieces, fields); });
      writer.add(
          stem + "_faces", [&] { return fem::crack_faces_vtu_text(fields); },
          [&](const Pieces& pieces) { return fem::crack_faces_pvtu_text(pieces); });
      if (!ranks.first()) continue;
      std::vector<fem::CrackFront> fronts = one->solid.fronts;
      if (one->closed)  // the rest is rounding
        for (fem::CrackFront& front : fronts)
          for (fem::FrontStation& station : front.stations) station.K_I = 0;
      files.push_back({stem + "_fronts.vtu", fem::fronts_vtu_text(fronts)});
    }
  };
  for (const WallCrackRun& crack : result.flexspline.cracks) std::visit(add_wall, crack);
  // Only the first rank has shaft and cup; they are empty on the others.
  for (const ShaftCrackRun& crack : result.output_shaft.cracks) {
    const std::string stem = file_stem(crack.path);
    files.push_back({stem + ".vtu", fem::vtu_text(fields_at_load(crack, gear))});
    files.push_back(
        {stem + "_fronts.vtu", fem::fronts_vtu_text(std::array{front_at_load(crack, gear)})});
  }
  if (const auto& cup = result.flexspline.sound)
    files.push_back({.name = "flexspline.vtu", .text = fem::vtu_text(fields_at_load(*cup, gear))});
  return files;
}

}  // namespace strainwave::fe_study

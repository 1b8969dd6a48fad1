// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "files.hpp"
#include "strainwave/catalogue/factors.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/present/equation_titles.hpp"
#include "strainwave/present/glossary.hpp"
#include "strainwave/present/note_texts.hpp"
#include "strainwave/sif/library.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave_program.hpp"

namespace strainwave::cli {

std::vector<std::string> names_of(std::string_view what, const std::string& file) {
  std::vector<std::string> names;
  if (what == "material") return material_names();
  if (what == "solution")
    for (const sif::Row& row : sif::library()) names.emplace_back(row.info.name);
  if (what == "unit" || what == "explained")
    for (const KnownUnit& unit : known_units()) names.emplace_back(unit.symbol);
  if (what == "explained") {
    for (const Command& command : commands()) names.emplace_back(command.name);
    for (const GlossaryTerm& term : glossary()) names.emplace_back(term.term);
    for (const NoteText& note : note_texts()) names.emplace_back(note.code);
    for (const EquationTitle& equation : equation_titles()) names.emplace_back(equation.tag);
    for (const sif::Row& row : sif::library()) names.emplace_back(row.info.name);
    std::ranges::copy(material_names(), std::back_inserter(names));
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
  }
  if (what == "factor")
    names.assign(EnumNames<Factor>::names.begin(), EnumNames<Factor>::names.end());
  if (what != "output" || file.empty() || file == "-") return names;
  const auto drive = read_drive(text_of(file), file, attachments_beside(file));
  for_each_quantity(evaluate(drive->gear, Method::corrected),
                    [&](const std::string& path, const Quantity&) { names.push_back(path); });
  return names;
}

}  // namespace strainwave::cli

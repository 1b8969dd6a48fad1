// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/gear_reader.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/toml_reader.hpp"
#include "strainwave/io/compliance_table_file.hpp"
#include "strainwave/io/error_table_file.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/io/turn_table_file.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/model/input/placed_group.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

/// Takes a material that a field names from the library, unless the file defines it.
void add_from_library(GearSet& gear, const std::string& wanted, const FieldPath& path) {
  if (gear.material.contains(wanted)) return;
  const std::string field = path.text();
  if (const MaterialRecord* const record = find_material(wanted)) {
    // A table of the file takes precedence.  If its name is spelled differently, it must not be
    // overlooked.
    for (const auto& [name, material] : gear.material)
      if (material.in_file() && find_material(name) == record)
        throw InputError(field, fmt::format("\"{}\" is in the material library, but the file gives "
                                            "the same steel as [material.\"{}\"]; use one name",
                                            shown(wanted), shown(name)));
    gear.material.emplace(wanted, as_material(*record));
    return;
  }
  std::vector<std::string> given;
  for (const auto& [name, material] : gear.material)
    if (material.in_file()) given.push_back(name);
  const std::string near = nearest_word(wanted, given);
  const std::string meant = near.empty() ? meant_material(wanted, material_names())
                                         : fmt::format("did you mean {}?", near);
  throw InputError(
      field,
      fmt::format("\"{}\" is not one of the materials given ({}), nor in the material library; {}",
                  shown(wanted), shown(fmt::format("{}", fmt::join(given, ", "))),
                  meant.empty() ? "strainwave material list shows the names" : shown(meant)));
}

template <class Member>
void add_from_library(GearSet& gear, const std::optional<Member>& member, std::string_view path) {
  if (member) add_from_library(gear, member->material, FieldPath(std::string(path)) / "material");
}

/// Takes the materials of all parts and plies from the library, unless the file defines them.
void add_from_library(GearSet& gear) {
  add_from_library(gear, gear.wave_generator, "wave_generator");
  add_from_library(gear, gear.flexspline, "flexspline");
  add_from_library(gear, gear.output_shaft, "output_shaft");
  add_from_library(gear, gear.circular_spline, "circular_spline");
  if (gear.flexspline)
    for_each_section(*gear.flexspline, [&](std::string_view name, const auto& section) {
      if (section.material)
        add_from_library(gear, *section.material, FieldPath("flexspline") / name / "material");
    });
  std::vector<std::pair<FieldPath, std::string>> of_plies;
  for (const auto& [name, material] : gear.material)
    for (std::size_t i = 0; i < material.ply.size(); ++i)
      of_plies.emplace_back((FieldPath("material") / name / "ply")[i] / "material",
                            material.ply[i].material);
  for (const auto& [field, name] : of_plies) add_from_library(gear, name, field);
}

/// Completes the tables of the file that name a record of the library with the values that they
/// leave out.
void complete_from_library(GearSet& gear) {
  for (auto& [name, material] : gear.material) {
    if (!material.based_on) continue;
    const MaterialRecord* const record = find_material(*material.based_on);
    if (record == nullptr) {
      const std::string meant = meant_material(*material.based_on, material_names());
      throw InputError(
          (FieldPath("material") / name / "based_on").text(),
          fmt::format("\"{}\" is not in the material library; {}", shown(*material.based_on),
                      meant.empty() ? "strainwave material list shows the names" : shown(meant)));
    }
    material = completed(material, *record);
  }
}

/// Refuses HTML, XML and JSON by name, because the first TOML fault of such a text would not help.
void refuse_other_formats(std::string_view text, std::string_view file_name) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const char begins = first == std::string_view::npos ? '#' : text[first];
  if (begins == '<' || begins == '{')
    throw InputError(TextPlace{.file = std::string(file_name)},
                     begins == '<'
                         ? "is HTML or XML, not a drive in TOML; strainwave new writes a drive"
                         : "is JSON, not a drive in TOML; for a result, give the file "
                           "that provenance.input_file names");
}

/// Makes the cracks of groups, and lets the places of each table hold for all of its cracks.
void place_groups(GearSet& gear, TomlReader& reader) {
  place_groups(gear);
  for (const PlacedGroup& group : gear.placed_groups)
    for (std::size_t i = 1; i < group.count; ++i) reader.repeat(group.crack(0), group.crack(i));
}

/// Says which table of the file gives the cracks that a message names.
InputError with_tables(const GearSet& gear, const InputError& error) {
  const std::string_view message = error.what();
  std::vector<std::string> of_groups;
  for (const PlacedGroup& group : gear.placed_groups)
    for (std::size_t i = 1; i < group.count; ++i)
      if (const std::string path = group.crack(i); message.find(path) != std::string_view::npos)
        of_groups.push_back(fmt::format("{} is crack {}/{} of the table {}", path, i + 1,
                                        group.count, std::string(group.crack(0))));
  return of_groups.empty() ? error : error.remarked(fmt::format("{}", fmt::join(of_groups, "; ")));
}

}  // namespace

GearSet read_gear_set(std::string_view text, std::string_view file_name,
                      const Attachments& attachments) {
  if (text.size() > kMaxTextSize)
    throw InputError(TextPlace{.file = std::string(file_name)},
                     "is larger than 1 MiB; a drive takes a few kilobytes");
  refuse_other_formats(text, file_name);
  const toml::table table = parse_toml(text, file_name);
  TomlReader reader(file_name);
  GearSet gear;
  reader.read_table(table, FieldPath(), gear);
  try {
    place_groups(gear, reader);
    complete_from_library(gear);
    add_from_library(gear);
    read_compliance_tables(gear, attachments);
    read_turn_tables(gear, attachments);
    read_error_table(gear, attachments);
    check(gear);
    read_duty_record(gear, attachments);
  } catch (const InputError& error) {
    // A fault in a history names its own file and line.
    if (gear.duty && error.place().file == gear.duty->history) throw;
    throw with_tables(gear, reader.located(error));
  }
  return gear;
}

InputError located(const InputError& fault, std::string_view text, std::string_view file_name) {
  const std::string section = fault.field().substr(0, fault.field().find_first_of(".["));
  bool of_drive = false;
  GearSet::describe(
      [&](const Field& field, auto) { of_drive = of_drive || field.name == section; });
  if (!of_drive || !fault.place().file.empty()) return fault;
  TomlReader reader(file_name);
  GearSet gear;
  reader.read_table(parse_toml(text, file_name), FieldPath(), gear);
  place_groups(gear, reader);
  bool same = true;
  if (!fault.rule().empty())
    for_each_number(gear, [&](const FieldPath& path, const Field& field, double value) {
      if (path.text() == fault.field())
        same = InputError(fault.field(), value, field.unit, fault.rule()).value() == fault.value();
    });
  return same ? with_tables(gear, reader.located(fault)) : fault;
}

GearSet read_gear_set_file(const std::filesystem::path& file) {
  return read_gear_set(read_text_file(file), file.string(), attachments_beside(file));
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/materials/material_record.hpp"
#include "strainwave/model/input/material.hpp"

/// @file
/// The steels of strain wave gears.  data/materials.toml holds all data; the build compiles the
/// file into the library.

namespace strainwave {

/// Format of data/materials.toml that this version reads.
inline constexpr std::string_view kMaterialFormat = "strainwave-materials/1";

/// A file of materials: sources by key, records in order.
struct MaterialLibrary {
  std::string format;
  std::map<std::string, std::string> source;
  std::vector<MaterialRecord> material;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "format",
                .unit = "",
                .doc = "always \"strainwave-materials/1\"",
                .example = R"("strainwave-materials/1")"},
          &MaterialLibrary::format);
    field(Field{.name = "source",
                .unit = "",
                .doc = "sources by key",
                .example = R"("author, title, what was read")"},
          &MaterialLibrary::source);
    field(Field{.name = "material", .unit = "", .doc = "records"}, &MaterialLibrary::material);
  }
};

/// Reads and checks a file of materials.
///
/// @param text         content of the file: TOML of the format kMaterialFormat
/// @param file_name    name of the file in messages
/// @throws InputError  if the file breaks a rule; the message names file, line, column, field,
///                     value and rule
[[nodiscard]] MaterialLibrary parse_material_library(std::string_view text,
                                                     std::string_view file_name);

/// The built-in records.  The first call reads them; any thread may call it.
[[nodiscard]] std::span<const MaterialRecord> material_library();

/// The publication behind a source key of the built-in records.
/// @throws InputError  if the key does not exist
[[nodiscard]] std::string_view material_source(std::string_view key);

/// All names and aliases of the built-in records, in their order.
[[nodiscard]] std::vector<std::string> material_names();

/// The record with a name or an alias; null if none matches.  The exact name has priority over a
/// name that differs in case and blanks only.  A merely similar name does not match.
[[nodiscard]] const MaterialRecord* find_material(std::string_view name_or_alias);

/// A suggestion such as "did you mean 4340 tempered 425 C or 4340 tempered 260 C?".  It lists the
/// names of `known` that begin with the unknown name, else a near name if the unknown name is long
/// enough; otherwise it is empty.  No suggestion is made for a short name, because 4340 and C300
/// differ in only two letters.
[[nodiscard]] std::string meant_material(std::string_view unknown,
                                         std::span<const std::string> known);

/// The record with a name or an alias.
/// @throws InputError  if none matches; the message suggests a near name if there is one
[[nodiscard]] const MaterialRecord& require_material(std::string_view name_or_alias);

/// The record as a material of a drive; its origin states which numbers are unverified.
[[nodiscard]] Material as_material(const MaterialRecord& record);

/// Completes a material with values of a record.  The origin of the result states which values come
/// from the record and which are the material's own; `from_library` names the fields that come from
/// the record.
///
/// Two of E, G and nu define a material.  Its own shear modulus therefore replaces the Poisson's
/// ratio of the record, and any own value of the three replaces the shear modulus of the record.
///
/// @param own     material to complete; an absent E is not given
/// @param record  of the library
[[nodiscard]] Material completed(const Material& own, const MaterialRecord& record);

/// Delta K at which two power laws give the same growth (MA-3).
/// @return             Delta K [Pa*m^0.5]
/// @throws InputError  if the exponents are equal
[[nodiscard]] double transition_range(const ParisLaw& first, const ParisLaw& second);

}  // namespace strainwave

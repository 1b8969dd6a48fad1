// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/materials.hpp"

namespace strainwave {
namespace {

struct ListOptions {
  std::optional<MaterialUse> use;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"use", "", "only steels for this use"}, &ListOptions::use);
  }
};

struct ShowOptions {
  std::string name;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "name",
           .unit = "",
           .doc = "name or alias; case and blanks do not matter",
           .positional = true,
           .names = "material"},
          &ShowOptions::name);
  }
};

constexpr std::string_view kMaterialDescription =
    "The library holds the steels that come with strainwave, each number with its source, its "
    "confidence and its scatter. A member of a drive may name any of these steels instead of a "
    "material table of the input file. material list prints the steels. material show prints all "
    "data of one steel: elastic constants, strength, toughness, fatigue limits, thresholds and "
    "growth laws.";

}  // namespace

Command material_list_command() {
  return command<ListOptions, MaterialData>({
      .name = "material list",
      .summary = "Print all steels, one line for each",
      .description = kMaterialDescription,
      .example = "strainwave material list --use flexspline",
      .takes = Takes::nothing,
      .function = [](const Request&, const ListOptions& o) { return material_list(o.use); },
      .documents = {{Format::text, material_list_text}, {Format::markdown, material_list_markdown}},
  });
}

Command material_show_command() {
  return command<ShowOptions, MaterialData>({
      .name = "material show",
      .summary = "Print all data of one steel",
      .description = kMaterialDescription,
      .example = "strainwave material show '17-4PH H900'",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const ShowOptions& o) {
            return from_option([&] { return material_show(o.name); });
          },
      .documents = {{Format::text, material_text}},
  });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <sstream>

#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/io/input_format.hpp"

namespace strainwave {
namespace {

struct NewOptions {
  std::optional<int> size;
  std::optional<double> ratio;
  std::optional<FlexsplineForm> form;
  std::optional<FlexsplineLength> length;
  std::optional<Blank> blank;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"size", "", "size in the catalogue; prints its typical drive"}, &NewOptions::size);
    field({"ratio", "1", "ratio of the typical drive, 30 to 320"}, &NewOptions::ratio);
    field({.name = "form",
           .unit = "",
           .doc = "flexspline of the typical drive: cup, or silk hat with the diaphragm outward",
           .fallback = "cup"},
          &NewOptions::form);
    field({.name = "length",
           .unit = "",
           .doc = "length class of its flexspline",
           .fallback = "short"},
          &NewOptions::length);
    field({.name = "blank",
           .unit = "",
           .doc = "walls made for the wave of this ratio, or of ratio 100 for all ratios of a size",
           .fallback = "ratio"},
          &NewOptions::blank);
  }
};

struct NewDrive {
  std::string text;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"text", "", "the input file"}, &NewDrive::text);
  }
};

/// Editors find the schema of a file by its first line.
constexpr std::string_view kSchemaLine = "#:schema ./strainwave-drive-1.schema.json\n";

/// Commented lines for the output shaft, which no catalogue contains.
std::string output_shaft_of(const GearSet& gear) {
  const double d = gear.drive.pitch_diameter;
  GearSet with;
  // A steel shaft of usual proportions, in whole millimetres.
  with.output_shaft = OutputShaft{.material = gear.flexspline->material,
                                  .outer_diameter = std::round(450 * d) / 1000,
                                  .length = std::round(600 * d) / 1000,
                                  .crack = {}};
  constexpr std::string_view kHead = "[output_shaft]\n";
  const std::string text = gear_text(with);
  std::istringstream lines(text.substr(text.find(kHead)));
  std::string commented =
      "\n"
      "# The maker's stiffness ends at the output flange. With an [output_shaft], the drive "
      "includes "
      "your\n"
      "# shaft behind it: remove the # of these lines and give the dimensions of the shaft.\n";
  for (std::string line; std::getline(lines, line) && !line.empty();)
    commented += "# " + line + '\n';
  return commented;
}

NewDrive drive_of(const Request&, const NewOptions& options) {
  if (options.size.has_value() != options.ratio.has_value())
    throw OptionError(options.size ? "ratio" : "size",
                      "must be given; give both size and ratio, or neither");
  const auto needs_size = [&](std::string_view name, bool given) {
    if (given && !options.size) throw OptionError(name, "needs --size and --ratio; give them too");
  };
  needs_size("form", options.form.has_value());
  needs_size("length", options.length.has_value());
  needs_size("blank", options.blank.has_value());
  if (!options.size) return {std::string(kSchemaLine) + input_template()};
  const CommentedDrive drive = from_option([&] {
    const DriveType usual;
    return starting_drive(*options.size, *options.ratio,
                          {.form = options.form.value_or(usual.form),
                           .length = options.length.value_or(usual.length),
                           .blank = options.blank.value_or(usual.blank)});
  });
  return {std::string(kSchemaLine) +
          "# A typical drive of this size and ratio, because makers do not publish the geometry of "
          "a drive.\n"
          "# The comment after each number states its origin, its limits and their origin.\n" +
          gear_text(drive.gear, drive.comments) + output_shaft_of(drive.gear)};
}

}  // namespace

Command new_command() {
  return command<NewOptions, NewDrive>({
      .name = "new",
      .summary = "Print a commented starting file",
      .description =
          "Prints a valid input file with every field and its meaning; fields that are not needed "
          "are commented out. With --size and --ratio, prints the typical drive of that size in "
          "the makers' catalogues instead. Every number then has a comment on its origin and its "
          "limits, and ranges for the torsion curve are included. The lines of an output "
          "shaft are comments, because no catalogue contains a shaft.",
      .example = "strainwave new --size 25 --ratio 100 --output drive.toml",
      .takes = Takes::nothing,
      .function = drive_of,
      .documents = {{Format::toml, &NewDrive::text}},
  });
}

}  // namespace strainwave

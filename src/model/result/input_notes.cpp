// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/input_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "strainwave/core/compare.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

/// Whether a magnitude is outside the usual range of its field; 0 means an absent feature and is
/// usual.
bool unusual(const Field& field, double value) {
  return value != 0 && !usual_range(field).contains(std::abs(value));
}

void note_unusual(const GearSet& gear, std::vector<Note>& notes) {
  bool all_usual = true;
  for_each_plain_number(gear, [&](const Field& field, const double& value) {
    all_usual = all_usual && !unusual(field, value);
  });
  if (all_usual) return;
  // Make the paths only now, because a usual drive does not need them.
  for_each_number(gear, [&](const FieldPath& path, const Field& field, const double& value) {
    if (!unusual(field, value)) return;
    const Range usual = usual_range(field);
    notes.push_back({.code = "input.implausible",
                     .text = fmt::format("{} is unusual; the usual range is {} to {}",
                                         shown_quantity(value, field.unit, 4),
                                         shown_quantity(usual.lower, field.unit, 4),
                                         shown_quantity(usual.upper, field.unit, 4)),
                     .path = path.text(),
                     .equation = "",
                     .severity = Severity::care,
                     .next_step = "Check the value and its unit. If the value is intended, the "
                                  "answer is valid for it."});
  });
}

/// Notes a length of the flexspline that differs from its sections.
void note_contradiction(std::vector<Note>& notes, std::string_view field, double given,
                        double by_sections, std::string_view sections) {
  constexpr double kRounding = 1e-3;  // tolerance for numbers with few digits
  if (std::abs(given - by_sections) <= kRounding * by_sections) return;
  notes.push_back(
      {.code = "flexspline.contradiction",
       .text = fmt::format("the file gives {0:.4g} mm here, but {2} gives {1:.4g} mm; the "
                           "program uses {1:.4g} mm",
                           given / units::mm, by_sections / units::mm, sections),
       .path = fmt::format("flexspline.{}", field),
       .equation = "",
       .severity = Severity::care,
       .next_step = fmt::format("Remove {}; a flexspline by sections does not need it.", field)});
}

/// Adds a note if the walls of two joined sections do not meet.  Such a step adds compliance that
/// the sum leaves out.
void note_step(std::vector<Note>& notes, const TubeSection& barrel, double bore, double outside,
               std::string_view other) {
  const double inner = barrel.outer_diameter - 2 * barrel.wall_thickness;
  if (!clearly_less(outside, inner) && !clearly_less(barrel.outer_diameter, bore)) return;
  notes.push_back({.code = "flexspline.step",
                   .text = fmt::format(
                       "the wall of the barrel lies between {:.4g} and {:.4g} mm in diameter, "
                       "and {} does not meet this wall; the step adds compliance that the "
                       "model by sections leaves out",
                       inner / units::mm, barrel.outer_diameter / units::mm,
                       bore == outside ? fmt::format("{}, {:.4g} mm,", other, outside / units::mm)
                                       : fmt::format("{}, {:.4g} to {:.4g} mm,", other,
                                                     bore / units::mm, outside / units::mm)),
                   .path = "flexspline.barrel.outer_diameter",
                   .equation = "ST-2",
                   .severity = Severity::care,
                   .next_step = "Check the diameters of the sections."});
}

/// Says which cracks a table with a group stands for.
void note_groups(const GearSet& gear, std::vector<Note>& notes) {
  for (const PlacedGroup& group : gear.placed_groups) {
    const std::string table = group.crack(0);
    const std::string second = group.crack(1);
    const std::string last = group.crack(group.count - 1);
    notes.push_back(
        {.code = "input.crack_group",
         .text = fmt::format("this table gives {0} cracks: crack 1/{0} has this path, {1}; a path "
                             "names only one of them in --vary, [[scatter]], [[range]] and "
                             "[[inspection.place]]",
                             group.count,
                             group.count == 2
                                 ? fmt::format("and crack 2/2 is {}", second)
                                 : fmt::format("and cracks 2/{0} to {0}/{0} are {1} to {2}",
                                               group.count, second, last)),
         .path = table,
         .equation = "",
         .severity = Severity::information,
         .next_step = "Change the table to change all of its cracks."});
  }
}

}  // namespace

std::vector<Note> input_notes(const GearSet& gear) {
  std::vector<Note> notes;
  note_unusual(gear, notes);
  note_groups(gear, notes);
  if (!gear.flexspline || gear.flexspline->crack_free != CrackFree::sections) return notes;
  const Flexspline& fs = *gear.flexspline;
  if (fs.length)
    note_contradiction(notes, "length", *fs.length, fs.tube_length(),
                       fs.rim ? "rim.length + barrel.length" : "barrel.length");
  if (fs.wall_thickness && fs.rim)
    note_contradiction(notes, "wall_thickness", *fs.wall_thickness, fs.rim->wall_thickness,
                       "rim.wall_thickness");
  if (fs.barrel && fs.rim)
    note_step(notes, *fs.barrel, fs.rim->outer_diameter - 2 * fs.rim->wall_thickness,
              fs.rim->outer_diameter, "the wall of the rim");
  if (fs.barrel && fs.diaphragm) {
    const bool hat = fs.shape == FlexsplineShape::hat;
    const double edge = hat ? fs.diaphragm->inner_diameter : fs.diaphragm->outer_diameter;
    note_step(notes, *fs.barrel, edge, edge, "the edge of the diaphragm");
  }
  return notes;
}

}  // namespace strainwave

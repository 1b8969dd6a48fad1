// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/input_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

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
  for_each_number<NoPath>(gear, [&](NoPath, const Field& field, const double& value) {
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

}  // namespace

std::vector<Note> input_notes(const GearSet& gear) {
  std::vector<Note> notes;
  note_unusual(gear, notes);
  if (!gear.flexspline || gear.flexspline->crack_free != CrackFree::sections) return notes;
  const Flexspline& fs = *gear.flexspline;
  if (fs.length)
    note_contradiction(notes, "length", *fs.length, fs.tube_length(),
                       fs.rim ? "rim.length + barrel.length" : "barrel.length");
  if (fs.wall_thickness && fs.rim)
    note_contradiction(notes, "wall_thickness", *fs.wall_thickness, fs.rim->wall_thickness,
                       "rim.wall_thickness");
  return notes;
}

}  // namespace strainwave

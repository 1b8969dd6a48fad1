// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// The materials of the sections of a flexspline.

namespace strainwave {

/// Calls f(name of the section, section) for each section of a flexspline that is given.
template <class Fs, class F>
void for_each_section(Fs& flexspline, const F& f) {
  if (flexspline.rim) f("rim", *flexspline.rim);
  if (flexspline.barrel) f("barrel", *flexspline.barrel);
  if (flexspline.diaphragm) f("diaphragm", *flexspline.diaphragm);
  if (flexspline.boss) f("boss", *flexspline.boss);
}

/// The name of the material of a section.
template <class Section>
[[nodiscard]] const std::string& material_name(const Flexspline& flexspline,
                                               const Section& section) {
  return section.material ? *section.material : flexspline.material;
}

/// The name of the material of the part that contains a crack of the flexspline; that of the
/// flexspline if the part is not given.
[[nodiscard]] const std::string& material_name(const Flexspline& flexspline, CrackedPart part);
/// The same for a crack of the wall.
[[nodiscard]] inline const std::string& material_name(const Flexspline& flexspline,
                                                      WallSection section) {
  return material_name(flexspline, part_of(section));
}

/// The one isotropic material of a flexspline, for a model that knows no other wall.
/// @throws InputError  if the flexspline is of a laminate, or of several materials
[[nodiscard]] const Material& only_material(const GearSet& gear, const Flexspline& flexspline);

/// The isotropic material of the rim of a flexspline, for the theory of rings.  Barrel and bottom
/// may be of other materials, also of laminates.
/// @throws InputError  if the rim is of a laminate
[[nodiscard]] const Material& rim_material(const GearSet& gear, const Flexspline& flexspline);

/// Sum of the thicknesses of all plies of a laminate, as the file gives them [m].
[[nodiscard]] double thickness_of_plies(const Material& laminate);

/// Density of a material [kg/m^3]: its own, or the mean of its plies; absent if one is not known.
[[nodiscard]] std::optional<double> density_of(const GearSet& gear, std::string_view material);

/// Adds a note if the plies of a wall do not add up to its thickness (LA-3).
/// @param notes      the list to which the note is added
/// @param path       field that the note concerns: the wall
/// @param laminate   material of the wall, with its plies
/// @param thickness  of the wall [m]; > 0
void note_thickness(std::vector<Note>& notes, const std::string& path, const Material& laminate,
                    double thickness);

/// Checks the plies of all laminates, and the materials of the sections of the flexspline.
/// @throws InputError  naming the field and the rule
void check_laminates(const GearSet& gear);

}  // namespace strainwave

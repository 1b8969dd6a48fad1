// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/oval.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/oval.hpp"

namespace strainwave {

std::string drive_oval_text(const DriveOval& oval, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n" + verdict_text(evidence_of(oval).verdict) + '\n' +
                     largest_stress_sentence(oval.torques);
  text += paragraph(fmt::format(
      "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides, at most {:.3g} "
      "MPa. The rim turns outward by {:.3g} deg at a lobe (coning).",
      oval.contact.lobe_force, oval.contact.half_arc / units::deg,
      oval.contact.largest_pressure / units::MPa, oval.coning_angle / units::deg));
  text += paragraph(oval.large_rotations
                        ? fmt::format("Large rotations of the oval change a stress by up to "
                                      "{:.4g} MPa.",
                                      oval.rotation_stress / units::MPa)
                        : std::string("The oval is computed for small rotations."));
  text += oval_tables(oval.torques);
  text += "\nNotes\n" + notes_text(oval.notes);
  return text + '\n' + equations_text(oval.equations);
}

std::string drive_oval_csv(const DriveOval& oval) { return oval_csv(oval.torques); }

std::string drive_oval_plot(const DriveOval& oval, const GearSet& gear) {
  std::vector<PlotPanel> panels;
  PlotPanel& pressure = panels.emplace_back();
  pressure.title = "Pressure of the wave generator on the bore";
  pressure.subtitle = gear.name;
  pressure.x_label = "angle from a lobe [deg]";
  pressure.y_label = "pressure [MPa]";
  PlotSeries& line = pressure.series.emplace_back();
  line.label = "even over the width of the band";
  for (const BandPressure& at : oval.pressure) {
    line.x.push_back(at.angle / units::deg);
    line.y.push_back(at.pressure / units::MPa);
  }
  for (PlotPanel& panel : oval_panels(oval.torques)) panels.push_back(std::move(panel));
  return svg_plot(panels);
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/oval.hpp"

#include <utility>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/oval.hpp"

namespace strainwave {

std::string drive_oval_text(const DriveOval& oval, const GearSet& gear) {
  return name_of(gear) + "\n\n" + verdict_text(evidence_of(oval).verdict) + '\n' +
         oval_sentences(oval, oval.contact) + oval_tables(oval.torques) + "\nNotes\n" +
         notes_text(oval.notes) + '\n' + equations_text(oval.equations);
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

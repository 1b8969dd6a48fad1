// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/oval.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

/// A stress of a station by its name.
struct Shown {
  std::string_view name;
  std::string_view words;
  StressExtremes OvalStation::*stress;
};
constexpr std::array kShown = {
    Shown{"hoop", "Stress round the axis", &OvalStation::hoop},
    Shown{"meridional", "Stress along the wall", &OvalStation::meridional},
    Shown{"shear", "Shear stress", &OvalStation::shear}};

std::string stress_text(double stress) { return fmt::format("{:.4g}", stress / units::MPa); }
std::string angle_text(double angle) { return fmt::format("{:.4g}", angle / units::deg); }

std::string place_of(const OvalStation& station) {
  return fmt::format(
      "the {} face of the {}, {} {:.4g} mm", station.face, enum_name(station.part),
      station.part == WallPart::diaphragm ? "radius" : "z =", station.at / units::mm);
}

Table table_of(const LoadedOval& loaded) {
  Table table;
  table.head = {"part", "at [mm]", "face"};
  for (const Shown& shown : kShown) {
    table.head.push_back(fmt::format("{} max", shown.name));
    table.head.emplace_back("min");
  }
  table.head.emplace_back("von Mises");
  table.head.emplace_back("at [deg]");
  table.align = "lrlrrrrrrrr";
  std::optional<WallPart> part;
  double at = 0;
  int place = 0;
  for (const OvalStation& station : loaded.stations) {
    if (station.part != part)
      place = 0;
    else if (station.at != at)
      ++place;
    part = station.part;
    at = station.at;
    if (place % 2 != 0) continue;  // every second place, with both ends
    auto& row = table.rows.emplace_back(std::vector<std::string>{
        std::string(enum_name(station.part)), fmt::format("{:.4g}", station.at / units::mm),
        std::string(station.face)});
    for (const Shown& shown : kShown) {
      row.push_back(stress_text((station.*shown.stress).largest));
      row.push_back(stress_text((station.*shown.stress).least));
    }
    row.push_back(stress_text(station.equivalent.largest));
    row.push_back(angle_text(station.equivalent.at_largest));
  }
  return table;
}

/// Distances along the wall from the first station [m]; both faces of a place have one.
std::vector<double> along_the_wall(const std::vector<OvalStation>& stations) {
  std::vector<double> distances;
  double distance = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0 && stations[i].part == stations[i - 1].part)
      distance += std::abs(stations[i].at - stations[i - 1].at);
    distances.push_back(distance);
  }
  return distances;
}

PlotPanel panel_of(const LoadedOval& loaded, const Shown& shown) {
  PlotPanel panel;
  panel.title = fmt::format("{}, T = {:.6g} N·m", shown.words, loaded.torque);
  panel.x_label = "distance along the wall to the rim's end [mm]";
  panel.y_label = "extremes over a turn [MPa]";
  panel.legend_title = "face";
  const std::vector<double> distances = along_the_wall(loaded.stations);
  for (const std::string_view face : {"inner", "outer"})
    for (const bool most : {true, false}) {
      PlotSeries line{.label = fmt::format("{}, {}", face, most ? "largest" : "least")};
      for (std::size_t i = 0; i < loaded.stations.size(); ++i) {
        const OvalStation& station = loaded.stations[i];
        if (station.face != face) continue;
        const StressExtremes& stress = station.*shown.stress;
        line.x.push_back(distances[i] / units::mm);
        line.y.push_back((most ? stress.largest : stress.least) / units::MPa);
      }
      panel.series.push_back(std::move(line));
    }
  return panel;
}

}  // namespace

std::string oval_sentences(const OvalState& oval, const WaveContact& contact) {
  const OvalStation& worst = oval.governing();
  return paragraph(fmt::format(
             "The largest von Mises stress of the sound wall over a turn is {} MPa, on {}, at {} "
             "deg from a lobe.",
             stress_text(worst.equivalent.largest), place_of(worst),
             angle_text(worst.equivalent.at_largest))) +
         paragraph(fmt::format(
             "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides, at most "
             "{:.3g} MPa. The rim turns outward by {:.3g} deg at a lobe (coning).",
             contact.lobe_force, contact.half_arc / units::deg,
             contact.largest_pressure / units::MPa, oval.coning_angle / units::deg)) +
         paragraph(oval.large_rotations
                       ? fmt::format("Large rotations of the oval change a stress by up to {} MPa.",
                                     stress_text(oval.rotation_stress))
                       : std::string("The oval is computed for small rotations."));
}

std::string oval_tables(std::span<const LoadedOval> torques) {
  std::string text;
  for (const LoadedOval& loaded : torques)
    text += fmt::format("\nStress over a turn [MPa], torque {:+.6g} N*m\n", loaded.torque) +
            text_table(table_of(loaded));
  return text;
}

std::string oval_csv(std::span<const LoadedOval> torques) {
  std::vector<std::string> head = {"torque [N*m]", "part", "at [m]", "face"};
  for (const std::string_view name : {"hoop", "meridional", "shear", "equivalent"})
    for (const std::string_view column :
         {"largest [Pa]", "at_largest [rad]", "least [Pa]", "at_least [rad]"})
      head.push_back(fmt::format("{}_{}", name, column));
  std::string text = csv_line(head);
  for (const LoadedOval& loaded : torques)
    for (const OvalStation& of : loaded.stations) {
      std::vector<std::string> row = cells(loaded.torque, of.part, of.at, of.face);
      for (const StressExtremes* const s : {&of.hoop, &of.meridional, &of.shear, &of.equivalent})
        for (const double value : {s->largest, s->at_largest, s->least, s->at_least})
          row.push_back(cell(value));
      text += csv_line(row);
    }
  return text;
}

std::vector<PlotPanel> oval_panels(std::span<const LoadedOval> torques) {
  std::vector<PlotPanel> panels;
  for (const LoadedOval& loaded : torques)
    for (const Shown& shown : kShown) panels.push_back(panel_of(loaded, shown));
  return panels;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/laminate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

constexpr double kMPa = 1e6;

std::string factor(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : std::string("not known");
}

TitledTable moduli_table(const LaminateReport& report) {
  Table table{.head = {"section", "material", "E_x [GPa]", "E_y [GPa]", "G_xy [GPa]", "nu_xy",
                       "hoop bending [N*m]"},
              .align = "llrrrrr"};
  for (const LaminateWall& wall : report.walls)
    table.rows.push_back(
        cells(wall.path, wall.material, fmt::format("{:.4g}", wall.E_x / 1e9),
              fmt::format("{:.4g}", wall.E_y / 1e9), fmt::format("{:.4g}", wall.G_xy / 1e9),
              fmt::format("{:.4g}", wall.nu_xy), fmt::format("{:.4g}", wall.hoop_bending)));
  return {.title = "Walls as homogeneous sheets (LA-4), (LA-6)", .table = std::move(table)};
}

TitledTable torsion_table(const LaminateReport& report) {
  Table table{.head = {"section", "GJ [N*m^2]", "compliance [rad/(N*m)]", "axial strain",
                       "reserve of the first ply", "ply"}};
  for (const LaminateWall& wall : report.walls) {
    if (!wall.torsional_rigidity) continue;
    table.rows.push_back(
        cells(wall.path, fmt::format("{:.5g}", *wall.torsional_rigidity),
              fmt::format("{:.4g}", *wall.compliance), fmt::format("{:.3g}", *wall.axial_strain),
              factor(wall.reserve),
              wall.first_ply > 0 ? fmt::format("{}", wall.first_ply) : std::string()));
  }
  return {.title = "Torsion (LA-5) and first failure (LA-14)",
          .table = std::move(table),
          .remark =
              "The axial strain is that of the torque of the load. The reserve is a factor on "
              "torque and axial force, in both senses of torque, beside the assembly."};
}

TitledTable ply_table(const LaminateWall& wall) {
  Table table{.head = {"ply", "material", "angle [deg]", "load along [MPa]", "across", "shear",
                       "assembly along [MPa]", "across", "shear", "Tsai-Wu", "largest strain"},
              .align = "rlrrrrrrrrr"};
  // What is left of stresses that cancel is a rounding error.
  const auto stress = [](double value) {
    return fmt::format("{:.4g}", std::abs(value) < 1e-9 * kMPa ? 0.0 : value / kMPa);
  };
  for (const PlyState& ply : wall.plies)
    table.rows.push_back(cells(
        fmt::format("{}", ply.number), ply.material, fmt::format("{:.4g}", ply.angle / units::deg),
        stress(ply.load_along), stress(ply.load_across), stress(ply.load_shear),
        stress(ply.assembly_along), stress(ply.assembly_across), stress(ply.assembly_shear),
        factor(ply.tsai_wu), factor(ply.largest_strain)));
  return {.title = fmt::format("Plies of {}, from the inner face", wall.path),
          .table = std::move(table),
          .remark =
              "Stresses are in the axes of the fibres. Those of the assembly are the largest "
              "ones over the ply and over a turn, without sign."};
}

/// The stresses through the wall, in steps at the faces of the plies.
PlotPanel wall_panel(const LaminateWall& wall) {
  PlotPanel panel{.title = wall.path,
                  .x_label = "distance from the inner face [mm]",
                  .y_label = "stress in the axes of the fibres [MPa]"};
  const auto curve = [&](std::string label, double PlyState::*member) {
    PlotSeries series{.label = std::move(label)};
    double below = 0.0;
    for (const PlyState& ply : wall.plies) {
      for (const double z : {below, below + ply.thickness}) {
        series.x.push_back(1e3 * z);
        series.y.push_back(ply.*member / kMPa);
      }
      below += ply.thickness;
    }
    panel.series.push_back(std::move(series));
  };
  curve("load, along", &PlyState::load_along);
  curve("load, across", &PlyState::load_across);
  curve("load, shear", &PlyState::load_shear);
  curve("assembly, along, largest", &PlyState::assembly_along);
  curve("assembly, across, largest", &PlyState::assembly_across);
  return panel;
}

}  // namespace

std::vector<TitledTable> laminate_tables(const LaminateReport& report) {
  std::vector<TitledTable> tables = {moduli_table(report), torsion_table(report)};
  for (const LaminateWall& wall : report.walls)
    if (!wall.plies.empty()) tables.push_back(ply_table(wall));
  return tables;
}

std::string laminate_text(const LaminateReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n" + paragraph(report.sentence);
  text += text_tables(laminate_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string laminate_csv(const LaminateReport& report) {
  Table table{.head = {"section", "ply", "material", "angle [rad]", "thickness [m]",
                       "load_along [Pa]", "load_across [Pa]", "load_shear [Pa]",
                       "assembly_along [Pa]", "assembly_across [Pa]", "assembly_shear [Pa]",
                       "tsai_wu [1]", "largest_strain [1]"}};
  for (const LaminateWall& wall : report.walls)
    for (const PlyState& ply : wall.plies)
      table.rows.push_back(cells(wall.path, ply.number, ply.material, ply.angle, ply.thickness,
                                 ply.load_along, ply.load_across, ply.load_shear,
                                 ply.assembly_along, ply.assembly_across, ply.assembly_shear,
                                 ply.tsai_wu, ply.largest_strain));
  return csv_table(table);
}

std::string laminate_plot(const LaminateReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels;
  for (const LaminateWall& wall : report.walls)
    if (!wall.plies.empty()) panels.push_back(wall_panel(wall));
  if (!panels.empty()) panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave

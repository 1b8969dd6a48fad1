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

/// What is left of stresses that cancel is a rounding error.
std::string in_MPa(double stress) {
  return fmt::format("{:.4g}", std::abs(stress) < 1e-9 * kMPa ? 0.0 : stress / kMPa);
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
              "torque and axial force, in both senses of torque, while the assembly stays."};
}

/// Where each ply fails first, and how it endures a turn.
TitledTable failure_table(const LaminateWall& wall) {
  Table table{.head = {"ply", "face", "from a lobe [deg]", "torque", "along [MPa]", "across",
                       "shear", "on the load", "on load and assembly", "Haigh", "on the load"},
              .align = "rlrrrrrrrrr"};
  for (const PlyState& ply : wall.plies) {
    std::optional<double> least = ply.tsai_wu;
    if (ply.largest_strain && (!least || *ply.largest_strain < *least)) least = ply.largest_strain;
    const bool known = ply.worst_sense != 0;
    const auto stress = [&](double value) { return known ? in_MPa(value) : std::string("-"); };
    table.rows.push_back(cells(
        fmt::format("{}", ply.number), known ? ply.worst_face : std::string("-"),
        known ? fmt::format("{:.4g}", ply.worst_angle / units::deg) : std::string("-"),
        ply.worst_sense > 0   ? std::string("T > 0")
        : ply.worst_sense < 0 ? std::string("T < 0")
                              : std::string("-"),
        stress(ply.worst_along), stress(ply.worst_across), stress(ply.worst_shear), factor(least),
        factor(ply.proportional), factor(ply.haigh), factor(ply.haigh_factor)));
  }
  return {.title = fmt::format("Plies of {} under load and assembly (LA-18), (LA-19)", wall.path),
          .table = std::move(table),
          .remark =
              "The stresses are those of load and assembly together at the place that fails first. "
              "The factors lead to the first failure: on torque and axial force while the assembly "
              "stays, and on all of them. Haigh is the share of what the ply endures over a turn, "
              "with the factor on the load at which it is 1."};
}

TitledTable ply_table(const LaminateWall& wall) {
  Table table{.head = {"ply", "material", "angle [deg]", "load along [MPa]", "across", "shear",
                       "assembly along [MPa]", "across", "shear", "Tsai-Wu", "largest strain"},
              .align = "rlrrrrrrrrr"};
  for (const PlyState& ply : wall.plies)
    table.rows.push_back(cells(
        fmt::format("{}", ply.number), ply.material, fmt::format("{:.4g}", ply.angle / units::deg),
        in_MPa(ply.load_along), in_MPa(ply.load_across), in_MPa(ply.load_shear),
        in_MPa(ply.assembly_along), in_MPa(ply.assembly_across), in_MPa(ply.assembly_shear),
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
    if (!wall.plies.empty()) {
      tables.push_back(ply_table(wall));
      tables.push_back(failure_table(wall));
    }
  return tables;
}

std::string laminate_text(const LaminateReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n" + paragraph(report.sentence);
  text += text_tables(laminate_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string laminate_csv(const LaminateReport& report) {
  Table table{.head = {"section",
                       "ply",
                       "material",
                       "angle [rad]",
                       "thickness [m]",
                       "load_along [Pa]",
                       "load_across [Pa]",
                       "load_shear [Pa]",
                       "assembly_along [Pa]",
                       "assembly_across [Pa]",
                       "assembly_shear [Pa]",
                       "tsai_wu [1]",
                       "largest_strain [1]",
                       "proportional [1]",
                       "worst_face",
                       "worst_angle [rad]",
                       "worst_sense",
                       "worst_along [Pa]",
                       "worst_across [Pa]",
                       "worst_shear [Pa]",
                       "haigh [1]",
                       "haigh_factor [1]"}};
  for (const LaminateWall& wall : report.walls)
    for (const PlyState& ply : wall.plies)
      table.rows.push_back(cells(wall.path, ply.number, ply.material, ply.angle, ply.thickness,
                                 ply.load_along, ply.load_across, ply.load_shear,
                                 ply.assembly_along, ply.assembly_across, ply.assembly_shear,
                                 ply.tsai_wu, ply.largest_strain, ply.proportional, ply.worst_face,
                                 ply.worst_angle, ply.worst_sense, ply.worst_along,
                                 ply.worst_across, ply.worst_shear, ply.haigh, ply.haigh_factor));
  return csv_table(table);
}

std::vector<PlotPanel> laminate_panels(const LaminateReport& report) {
  std::vector<PlotPanel> panels;
  for (const LaminateWall& wall : report.walls)
    if (!wall.plies.empty()) panels.push_back(wall_panel(wall));
  return panels;
}

std::string laminate_plot(const LaminateReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = laminate_panels(report);
  if (!panels.empty()) panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave

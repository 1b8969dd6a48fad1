// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/torsion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string twist(double angle) { return shown_number(angle / angle_unit().in_si); }

std::string torque(double T) {
  const DisplayUnit unit = display_unit({}, "N*m");
  return fmt::format("{} {}", shown_number(T / unit.in_si), unit.text);
}

TitledTable lines_table(const TorsionReport& report) {
  Table table{.head = {"", "T > 0", "T < 0"}};
  if (report.bands) table.head.emplace_back("90 % of the ranges");
  const auto both = [&](const char* label, double MakersLines::*line, Band LineBands::*range,
                        const DisplayUnit& unit) {
    auto& row = table.rows.emplace_back(cells(with_unit(label, unit),
                                              shown_number(report.positive.*line / unit.in_si),
                                              shown_number(report.negative.*line / unit.in_si)));
    if (range == nullptr || !report.bands) return;
    const Band& band = (*report.bands).*range;
    row.push_back(shown_number(band.low / unit.in_si, 3) + " to " +
                  shown_number(band.high / unit.in_si, 3));
  };
  both("K1", &MakersLines::K1, &LineBands::K1, stiffness_unit());
  both("K2", &MakersLines::K2, &LineBands::K2, stiffness_unit());
  both("K3", &MakersLines::K3, &LineBands::K3, stiffness_unit());
  const DisplayUnit angle = angle_unit();
  both("twist at T1", &MakersLines::phi1, nullptr, angle);
  both("twist at T2", &MakersLines::phi2, nullptr, angle);
  const auto reached = [](const std::optional<double>& at_load) {
    return at_load ? twist(*at_load) : std::string("not reached");
  };
  table.rows.push_back(
      cells(with_unit(fmt::format("twist at {}, the load", torque(report.at_load.torque)), angle),
            reached(report.at_load.positive), reached(report.at_load.negative)));
  const HysteresisLoop& loop = report.loop;
  table.rows.push_back(cells(fmt::format("{}, at +-{}", with_unit("lost motion", angle),
                                         torque(report.torques.lost_motion)),
                             twist(report.lost_motion)));
  table.rows.push_back(cells(fmt::format("{}, at {}", with_unit("largest loop width", angle),
                                         torque(loop.torque_of_largest_width)),
                             twist(loop.largest_width)));
  std::string remark;
  if (report.bands) {
    remark = fmt::format("{} drawn from {}",
                         counted(static_cast<std::size_t>(report.bands->draws), "drive"),
                         counted(static_cast<std::size_t>(report.bands->ranges), "range"));
    if (report.bands->rejected > 0)
      remark += fmt::format("; {} further draws could not be assembled", report.bands->rejected);
  }
  return {"Torsion curve in the maker's numbers, with the cracks of the file", table, remark};
}

TitledTable friction_table(const FrictionReport& friction) {
  Table table{.head = {"", "total", "balls", "outer ring", "flanks", "output"}};
  const DisplayUnit angle = angle_unit();
  const DisplayUnit of_torque = display_unit({}, "N*m");
  const auto at_input = [&](double T) { return shown_number(T / of_torque.in_si); };
  const LossAtZero& loss = friction.loss_at_zero;
  table.rows.push_back(cells(with_unit("loss at zero torque, all contacts slip", angle),
                             twist(loss.total()), "", twist(loss.outer_ring), twist(loss.flanks),
                             twist(loss.output)));
  const RunningTorque& run = friction.no_load;
  table.rows.push_back(cells(with_unit("no-load torque at the input", of_torque),
                             at_input(run.total()), at_input(run.balls), at_input(run.outer_ring),
                             at_input(run.flanks), at_input(run.output)));
  table.rows.push_back(cells(with_unit("back-driving torque at the output", of_torque),
                             friction.back_driving_torque ? at_input(*friction.back_driving_torque)
                                                          : "above the rated torque"));
  return {"Friction without load, by its causes, without the grease (TC-16, TC-34, TC-35)", table};
}

TitledTable cage_table(const LinesOverCage& over) {
  Table table{.head = {"", "softest", "mean", "stiffest"}};
  const DisplayUnit unit = stiffness_unit();
  const auto add = [&](const char* label, double LineStiffnesses::*line) {
    table.rows.push_back(cells(with_unit(label, unit),
                               shown_number(over.softest.*line / unit.in_si),
                               shown_number(over.mean.*line / unit.in_si),
                               shown_number(over.stiffest.*line / unit.in_si)));
  };
  add("K1", &LineStiffnesses::K1);
  add("K2", &LineStiffnesses::K2);
  add("K3", &LineStiffnesses::K3);
  return {fmt::format("Stiffness under T > 0 while the balls roll past the lobes, at {} phases of "
                      "the cage",
                      over.phases.size()),
          table};
}

TitledTable tolerance_table(const ToleranceEffects& effects) {
  Table table{.head = {"", "without deviations", "5 %", "median", "95 %"}};
  const auto add = [&](const std::string& label, const ToleranceSpread& spread, double in_si) {
    auto& row = table.rows.emplace_back(cells(label));
    for (const double value : {spread.nominal, spread.low, spread.median, spread.high})
      row.push_back(shown_number(value / in_si));
  };
  const DisplayUnit stiffness = stiffness_unit();
  add(with_unit("K1", stiffness), effects.K1, stiffness.in_si);
  add(with_unit("K2", stiffness), effects.K2, stiffness.in_si);
  add(with_unit("K3", stiffness), effects.K3, stiffness.in_si);
  add(with_unit("lost motion", angle_unit()), effects.lost_motion, angle_unit().in_si);
  add("ripple of K1 over a turn [%]", effects.ripple, 0.01);
  for (const ContactSpread& contacts : effects.contacts) {
    add("flanks in contact at " + torque(contacts.torque), contacts.flanks, 1);
    add("teeth in contact at " + torque(contacts.torque), contacts.teeth, 1);
  }
  const DeviationLimits& limits = effects.limits;
  const DisplayUnit micron = display_unit("tolerances", "m", {"um", 1e-6});
  const auto length = [&](double value) {
    return fmt::format("{} {}", shown_number(value / micron.in_si, 3), micron.text);
  };
  return {
      fmt::format("Drives with deviations within their tolerances, {} from seed {} (TC-36)",
                  counted(static_cast<std::size_t>(effects.draws), "drive"), effects.seed),
      table,
      fmt::format("Single pitch deviation {}; standard deviations: middle of a tooth {}, "
                  "thickness {}, ball {}; eccentricity of the cam {}",
                  length(limits.single_pitch), length(limits.position), length(limits.thickness),
                  length(limits.diameter_of_ball), length(limits.eccentricity))};
}

double largest_force(const std::vector<ContactForce>& forces) {
  double largest = 0.0;
  for (const ContactForce& contact : forces) largest = std::max(largest, contact.force);
  return largest;
}

TitledTable points_table(const TorsionReport& report) {
  const DisplayUnit of_torque = display_unit({}, "N*m");
  const DisplayUnit force = display_unit({}, "N");
  Table table{.head = {with_unit("at T", of_torque)}};
  const auto row = [&](std::vector<std::string>& to, const auto& cell_of) {
    for (const std::size_t i : report.shown) to.push_back(cell_of(report.curve.points[i]));
  };
  const auto add = [&](const std::string& label, const auto& cell_of) {
    row(table.rows.emplace_back(cells(label)), cell_of);
  };
  row(table.head,
      [&](const CurvePoint& p) { return fmt::format("{:.5g}", p.torque / of_torque.in_si); });
  add(with_unit("twist", angle_unit()), [](const CurvePoint& p) { return twist(p.twist); });
  add(with_unit("tangent K", stiffness_unit()), [](const CurvePoint& p) {
    return shown_number(p.tangent_stiffness() / stiffness_unit().in_si);
  });
  add(fmt::format("teeth in contact of {}", report.curve.teeth),
      [](const CurvePoint& p) { return cell(p.teeth_in_contact); });
  add("balls in contact", [](const CurvePoint& p) { return cell(p.balls_in_contact); });
  add(with_unit("largest ball force", force),
      [&](const CurvePoint& p) { return shown_number(largest_force(p.balls) / force.in_si); });
  add(with_unit("largest flank force", force), [&](const CurvePoint& p) {
    return shown_number(std::max(largest_force(p.drive_flanks), largest_force(p.coast_flanks)) /
                        force.in_si);
  });
  table.rows.push_back({"share of the tangent compliance"});
  for (std::size_t m = 0; m < kCurveMembers; ++m) {
    if (std::ranges::none_of(report.shown, [&](std::size_t i) {
          return std::abs(report.curve.points[i].share[m]) > 5e-5;
        }))
      continue;
    std::string name = "  " + std::string(EnumNames<CurveMember>::names[m]);
    std::ranges::replace(name, '_', ' ');
    add(name, [&](const CurvePoint& p) { return fmt::format("{:.1f} %", 100 * p.share[m]); });
  }
  return {"Points of the curve, and the share of each member in the tangent compliance", table};
}

TitledTable rim_table(const TorsionReport& report) {
  const DisplayUnit unit = display_unit({}, "Pa");
  Table table{.head = {"", "least", "largest"}};
  const auto add = [&](const char* label, const auto& stress) {
    const auto [least, most] = std::ranges::minmax_element(report.rim, {}, stress);
    table.rows.push_back(cells(label, shown_number(stress(*least) / unit.in_si),
                               shown_number(stress(*most) / unit.in_si)));
  };
  add("rim at the tooth roots, hoop", std::mem_fn(&RimState::rim_outside_stress));
  add("rim at its bore, hoop", std::mem_fn(&RimState::rim_inside_stress));
  if (report.rim.front().barrel_bending_stress)
    add("barrel at the rim, hoop bending",
        [](const RimState& state) { return *state.barrel_bending_stress; });
  add("barrel, shear from the torque", std::mem_fn(&RimState::barrel_shear_stress));
  return {fmt::format("Stress over a turn of the wave generator at {} [{}], without concentration "
                      "(TC-24)",
                      torque(report.torques.rated), unit.text),
          table};
}

TitledTable comparison_table(const CurveComparison& c) {
  Table table{.head = {"", "T > 0: K1", "K2", "K3", "T < 0: K1", "K2", "K3"}};
  const auto add = [&](const char* label, LineChanges ChangesOverTurn::*which) {
    const LineChanges& p = c.positive.*which;
    const LineChanges& n = c.negative.*which;
    auto& row = table.rows.emplace_back(cells(label));
    for (const double change : {p.K1, p.K2, p.K3, n.K1, n.K2, n.K3})
      row.push_back(percent_change(change));
  };
  add("as in the file", &ChangesOverTurn::as_given);
  add("mean", &ChangesOverTurn::mean);
  add("worst", &ChangesOverTurn::worst);
  add("best", &ChangesOverTurn::best);
  add("ripple", &ChangesOverTurn::ripple);
  const char* const where = c.crack_class == CrackClass::series ? "in a member in series"
                            : c.crack_class == CrackClass::contact_path
                                ? "in the path of the contacts"
                            : c.crack_class == CrackClass::none ? "cannot tell"
                                                                : "cannot tell, or several members";
  return {
      fmt::format("Change of stiffness by the cracks, at {} position{} over a turn of the wave "
                  "generator",
                  c.angles.size(), c.angles.size() == 1 ? "" : "s"),
      table,
      fmt::format("Lost motion is {0} {2} without and {1} {2} with cracks; the largest width of "
                  "the loop is {3} and {4} {2}. Place of the crack: {5}; {6} (TC-26)",
                  twist(c.lost_motion_sound), twist(c.lost_motion_cracked), angle_unit().text,
                  twist(c.hysteresis_sound), twist(c.hysteresis_cracked), where, c.evidence)};
}

}  // namespace

std::vector<TitledTable> torsion_tables(const TorsionReport& report) {
  std::vector<TitledTable> tables{lines_table(report), friction_table(report.friction)};
  if (report.comparison) tables.push_back(comparison_table(*report.comparison));
  tables.push_back(cage_table(report.over_cage));
  if (report.tolerances) tables.push_back(tolerance_table(*report.tolerances));
  tables.push_back(points_table(report));
  tables.push_back(rim_table(report));
  return tables;
}

std::string torsion_text(const TorsionReport& report, const GearSet& gear,
                         const Provenance& provenance) {
  const MakersTorques& at = report.torques;
  const DisplayUnit unit = display_unit({}, "N*m");
  std::string text = fmt::format(
      "{}\n{}, strainwave {}\nTorsion curve of the coupled drive, output against locked input\n\n"
      "T1 = {:.5g}, T2 = {:.5g}, T3 = {:.5g}, rated {:.5g} {}{}\n",
      name_of(gear), provenance.input_file, provenance.version, at.T1 / unit.in_si,
      at.T2 / unit.in_si, at.T3 / unit.in_si, at.rated / unit.in_si, unit.text,
      at.by_convention ? " (by convention)" : "");
  text += text_tables(torsion_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string torsion_csv(const TorsionReport& report) {
  Table table{.head = {"torque [N*m]", "twist [rad]", "tangent_stiffness [N*m/rad]",
                       "teeth_in_contact", "balls_in_contact"}};
  const bool compare = report.comparison.has_value();
  const std::size_t of_curve = table.head.size();
  if (compare) {
    table.head.insert(table.head.begin(), "part");
    table.head.insert(table.head.end(),
                      {"sound_twist [rad]", "sound_tangent_stiffness [N*m/rad]", "angle [rad]"});
    for (const char* const sense : {"positive", "negative"})
      for (const char* const line : {"K1", "K2", "K3"})
        table.head.push_back(fmt::format("{}.{}_change [1]", sense, line));
  }
  const auto add = [&](const TorsionCurve& curve, const TorsionCurve& sound, std::size_t i) {
    const CurvePoint& p = curve.points[i];
    auto& row = table.rows.emplace_back(
        cells(p.torque, p.twist, p.tangent_stiffness(), p.teeth_in_contact, p.balls_in_contact));
    if (!compare) return;
    const CurvePoint& s = sound.points[i];
    row.insert(row.begin(), "curve");
    for (std::string& one : cells(s.twist, s.tangent_stiffness())) row.push_back(std::move(one));
    row.resize(table.head.size());
  };
  for (std::size_t i = report.curve_negative.points.size(); i-- > 0;)
    add(report.curve_negative, report.sound_negative, i);
  for (std::size_t i = 0; i < report.curve.points.size(); ++i) add(report.curve, report.sound, i);
  if (!compare) return csv_table(table);
  const CurveComparison& c = *report.comparison;
  for (std::size_t i = 0; i < c.angles.size(); ++i) {
    const LineChanges& p = c.positive.at_angle[i];
    const LineChanges& n = c.negative.at_angle[i];
    auto& row = table.rows.emplace_back(std::vector<std::string>{"turn"});
    row.resize(1 + of_curve + 2);
    for (std::string& one : cells(c.angles[i], p.K1, p.K2, p.K3, n.K1, n.K2, n.K3))
      row.push_back(std::move(one));
  }
  return csv_table(table);
}

}  // namespace strainwave

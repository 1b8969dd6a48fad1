// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/run_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace strainwave::fe_study {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMPaRootMetre = 1e6;

Json quantity(double value, const char* unit) { return {{"value", value}, {"unit", unit}}; }

Json evidence(const gear_fem::ShaftCrackLoad& load) {
  return {{"ring_spread", load.tip.ring_spread},
          {"growth_check", load.growth_check},
          {"displacement_check", load.tip.displacement_check},
          {"energy_balance", load.energy_balance},
          {"equilibrium_residual", load.equilibrium_residual},
          {"worst_jacobian", load.worst_jacobian},
          {"unknowns", load.dofs}};
}

Json json_of(const gear_fem::ShaftCrackLoad& load, const char* compliance_unit,
             const char* release_unit) {
  return {{"sound_compliance", quantity(load.sound_compliance, compliance_unit)},
          {"added_compliance", quantity(load.added_compliance, compliance_unit)},
          {"added_by_difference", quantity(load.added_by_difference, compliance_unit)},
          {"energy_release_rate_per_load_squared",
           quantity(load.tip.energy_release_rate, release_unit)},
          {"evidence", evidence(load)},
          {"usable", load.usable},
          {"reason", load.reason}};
}

bool closed(const GearSet& gear) { return gear.load.axial_force < 0; }

/// Stress intensity at the given load [Pa*m^0.5]: modes I and II of the force, III of the torque.
struct AtLoad {
  double K_I, K_II, K_III;
};
AtLoad at_load(const gear_fem::ShaftCrackResult& result, const GearSet& gear) {
  const double force = gear.load.axial_force;
  return {closed(gear) ? 0.0 : result.tension.tip.K_I * force,
          closed(gear) ? 0.0 : result.tension.tip.K_II * force,
          result.torsion.tip.K_III * gear.load.torque};
}

std::string verdict(bool usable, const std::string& reason) {
  return usable ? "usable" : fmt::format("NOT usable: {}", reason);
}

std::string line(std::string_view name, double value, std::string_view unit) {
  return fmt::format("  {:<44} {:>13.6g} {}\n", name, value, unit);
}

void write(std::string& text, const gear_fem::ShaftCrackLoad& load, std::string_view unit) {
  text += line("sound compliance", load.sound_compliance, unit);
  text += line("added by the crack, integral of 2G", load.added_compliance, unit);
  text += line("the same by difference of two solutions", load.added_by_difference, unit);
  text += fmt::format(
      "  checks: rings {:.1e}, dC/dA {:.1e}, faces {:.1e}, energy {:.1e}, equilibrium {:.1e},\n"
      "          worst Jacobian {:.2f}; {} unknowns; {}\n",
      load.tip.ring_spread, load.growth_check, load.tip.displacement_check, load.energy_balance,
      load.equilibrium_residual, load.worst_jacobian, load.dofs, verdict(load.usable, load.reason));
}

}  // namespace

std::string run_text(const RunResult& result, const GearSet& gear) {
  std::string text = fmt::format("Finite elements of order {}, axisymmetric: {}\n", result.order,
                                 gear.name.empty() ? "drive" : gear.name);
  for (const ShaftCrackRun& crack : result.shaft_cracks) {
    text += fmt::format("\n{}: annular crack, depth {:.6g} mm\n", crack.path,
                        crack.section.crack->depth * 1e3);
    const AtLoad K = at_load(crack.result, gear);
    text += fmt::format(" at the given load, {:.6g} N*m and {:.6g} N\n", gear.load.torque,
                        gear.load.axial_force);
    text += line("K_I", K.K_I / kMPaRootMetre, "MPa*m^0.5");
    text += line("K_III", K.K_III / kMPaRootMetre, "MPa*m^0.5");
    if (closed(gear)) text += "  the axial force presses the faces together: closed, no K_I\n";
    text += " torsion\n";
    write(text, crack.result.torsion, "rad/(N*m)");
    text += " tension\n";
    write(text, crack.result.tension, "m/N");
  }
  if (result.cup) {
    const gear_fem::CupResult& cup = *result.cup;
    text += "\nflexspline: sound, torsion of the open end against the held one\n";
    text += line("compliance", cup.compliance, "rad/(N*m)");
    for (const gear_fem::CupPart& part : cup.parts)
      text += fmt::format("  {:<44} {:>13.6g} rad/(N*m) {:6.2f} %\n", part.name, part.compliance,
                          100 * part.share);
    text += fmt::format(
        "  checks: order {} to {} {:.1e}, energy {:.1e}, equilibrium {:.1e}, worst Jacobian "
        "{:.2f};\n          {} unknowns; {}\n",
        result.order - 1, result.order, cup.lower_order, cup.solution.energy_balance,
        cup.solution.equilibrium_residual, cup.solution.worst_jacobian, cup.solution.dofs,
        verdict(cup.usable, cup.reason));
  }
  if (!result.notes.empty()) text += "\nNotes\n";
  for (const std::string& note : result.notes) text += fmt::format("  - {}\n", note);
  return text;
}

std::string run_json(const RunResult& result, const GearSet& gear) {
  Json json{{"method", "finite elements, axisymmetric"},
            {"order", result.order},
            {"usable", result.usable()},
            {"reason", result.reason()},
            {"output_shaft", Json::object()},
            {"flexspline", Json::object()},
            {"notes", result.notes}};
  Json cracks = Json::array();
  for (const ShaftCrackRun& crack : result.shaft_cracks) {
    const AtLoad K = at_load(crack.result, gear);
    cracks.push_back({{"path", crack.path},
                      {"kind", "annular"},
                      {"depth", quantity(crack.section.crack->depth, "m")},
                      {"opens", !closed(gear)},
                      {"stress_intensity",
                       {{"K_I", quantity(K.K_I, "Pa*m^0.5")},
                        {"K_II", quantity(K.K_II, "Pa*m^0.5")},
                        {"K_III", quantity(K.K_III, "Pa*m^0.5")}}},
                      {"torsion", json_of(crack.result.torsion, "rad/(N*m)", "J/(m^2*N^2*m^2)")},
                      {"tension", json_of(crack.result.tension, "m/N", "J/(m^2*N^2)")}});
  }
  json["output_shaft"]["cracks"] = cracks;
  if (result.cup) {
    const gear_fem::CupResult& cup = *result.cup;
    Json parts = Json::array();
    for (const gear_fem::CupPart& part : cup.parts)
      parts.push_back({{"name", part.name},
                       {"compliance", quantity(part.compliance, "rad/(N*m)")},
                       {"share", quantity(part.share, "1")}});
    json["flexspline"] = {{"compliance", quantity(cup.compliance, "rad/(N*m)")},
                          {"parts", parts},
                          {"evidence",
                           {{"lower_order", cup.lower_order},
                            {"energy_balance", cup.solution.energy_balance},
                            {"equilibrium_residual", cup.solution.equilibrium_residual},
                            {"worst_jacobian", cup.solution.worst_jacobian},
                            {"unknowns", cup.solution.dofs}}},
                          {"usable", cup.usable},
                          {"reason", cup.reason}};
  }
  return json.dump(2) + "\n";
}

std::string plan_text(const std::vector<RunSize>& sizes) {
  std::string text = "Would calculate, estimated:\n";
  for (const RunSize& size : sizes)
    text += fmt::format("  {:<28} {:>8} unknowns, {} solutions, {:.2g} GB, {:.2g} s\n", size.path,
                        size.dofs, size.solutions, size.memory / 1e9, size.seconds);
  return text;
}

std::string plan_json(const std::vector<RunSize>& sizes) {
  Json list = Json::array();
  for (const RunSize& size : sizes)
    list.push_back({{"path", size.path},
                    {"unknowns", size.dofs},
                    {"solutions", size.solutions},
                    {"memory_bytes", size.memory},
                    {"time", quantity(size.seconds, "s")}});
  return Json{{"plan", list}}.dump(2) + "\n";
}

}  // namespace strainwave::fe_study

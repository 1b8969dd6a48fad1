// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <vector>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/json.hpp"

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

/// Whether there is an energy release rate to compare with its derivative.
bool releases(const gear_fem::TubeCrackResult& result) {
  return std::abs(result.energy_release_rate) > result.closed_release_rate;
}

/// K_I of a station [Pa*m^0.5]: 0 where the crack is closed, and what is left there is rounding.
double opening(const gear_fem::TubeCrackResult& result, const fem::FrontStation& station) {
  return result.closed ? 0.0 : station.K_I;
}

/// How the faces are.
std::string state_of(const gear_fem::TubeCrackResult& result) {
  if (result.closed) return "closed";
  return result.solid.contact_share > 0 ? "partly closed" : "open";
}

double largest_ring_spread(const gear_fem::TubeCrackResult& result) {
  double spread = 0.0;
  for (const fem::CrackFront& front : result.solid.fronts)
    spread = std::max(spread, front.ring_spread);
  return spread;
}

/// What has the crack, in words.
std::string_view body_of(const gear_fem::TubeWithThroughCrack& tube) {
  return tube.ends.any() ? "cup" : "tube";
}

/// Its parts besides the barrel.
std::string ends_of(const gear_fem::TubeWithThroughCrack& tube) {
  std::vector<std::string> parts;
  if (tube.ends.rim) parts.emplace_back("rim");
  if (tube.ends.diaphragm) parts.emplace_back("diaphragm");
  if (tube.ends.boss) parts.emplace_back("boss");
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// The tip toward +z (at 90 degrees: toward -theta), the other one.
constexpr std::array kTips = {"upper", "lower"};

void write_checks(std::string& text, const gear_fem::TubeCrackResult& result) {
  const fem::SolidResult& solid = result.solid;
  text += releases(result) ? fmt::format("  checks: rings {:.1e}, dC/dA {:.1e}, ",
                                         largest_ring_spread(result), result.growth_check)
                           : std::string("  checks: no energy is released; ");
  text += fmt::format(
      "energy {:.1e}, equilibrium {:.1e},\n          {}worst Jacobian {:.2f}; {} "
      "unknowns; {}\n",
      solid.energy_balance, solid.equilibrium_residual,
      result.sound_check != 0 ? fmt::format("sound cup {:.1e}, ", result.sound_check)
                              : std::string(),
      solid.worst_jacobian, solid.dofs, verdict(result.usable, result.reason));
}

void write_intensities(std::string& text, const std::string& where,
                       const gear_fem::TubeCrackResult& result, const fem::FrontStation& s) {
  text += fmt::format("    {:<22} {:>13.5g} {:>13.5g} {:>13.5g}\n", where,
                      opening(result, s) / kMPaRootMetre, s.K_II / kMPaRootMetre,
                      s.K_III / kMPaRootMetre);
}

void write_state(std::string& text, const gear_fem::TubeCrackResult& result) {
  text += fmt::format("  {}: the faces touch over {:.3g} % of the crack\n", state_of(result),
                      100 * result.solid.contact_share);
  text += line("added by the crack", result.added_compliance, "rad/(N*m)");
}

void write(std::string& text, const gear_fem::TubeCrackResult& result) {
  write_state(text, result);
  text += line("energy release rate, mean of both fronts", result.energy_release_rate, "J/m^2");
  text += "  through the wall              K_I          K_II         K_III  MPa*m^0.5\n";
  for (std::size_t f = 0; f < result.solid.fronts.size(); ++f) {
    const auto& stations = result.solid.fronts[f].stations;
    for (const fem::FrontStation& s : stations) {
      const std::string_view where = &s == &stations.front()  ? "inner face"
                                     : &s == &stations.back() ? "outer face"
                                                              : "within";
      write_intensities(text, fmt::format("{} tip, {}", kTips.at(f), where), result, s);
    }
  }
  write_checks(text, result);
}

/// Stations of a surface crack's front without its two ends, where K is not defined.
std::vector<fem::FrontStation> inner_stations(const gear_fem::TubeSurfaceCrackResult& result) {
  const auto& all = result.solid.fronts.at(0).stations;
  return {all.begin() + 1, all.end() - 1};
}

double front_angle(const fem::FrontStation& station) { return station.position * std::numbers::pi; }

void write(std::string& text, const gear_fem::TubeSurfaceCrackResult& result) {
  write_state(text, result);
  text += line("energy release rate, grown in proportion", result.energy_release_rate, "J/m^2");
  if (releases(result))
    text += "  along the front               K_I          K_II         K_III  MPa*m^0.5\n";
  else
    text += "  along the front all K are zero but for rounding and mesh\n";
  for (const fem::FrontStation& s : inner_stations(result)) {
    if (!releases(result)) break;
    const double degrees = front_angle(s) * 180 / std::numbers::pi;
    write_intensities(text,
                      fmt::format("{:.4g} deg{}", degrees, s.position == 0.5 ? ", deepest" : ""),
                      result, s);
  }
  write_checks(text, result);
}

Json intensities(const gear_fem::TubeCrackResult& result, const fem::FrontStation& s) {
  return {{"place", {{"value", s.place}, {"unit", "m"}}},
          {"K_I", quantity(opening(result, s), "Pa*m^0.5")},
          {"K_II", quantity(s.K_II, "Pa*m^0.5")},
          {"K_III", quantity(s.K_III, "Pa*m^0.5")},
          {"energy_release_rate", quantity(s.energy_release_rate, "J/m^2")}};
}

/// @param fronts  the crack's fronts as the kind of crack has them
Json json_of(const gear_fem::TubeCrackResult& result, const char* sense, const Json& fronts) {
  const fem::SolidResult& solid = result.solid;
  return {{"torque_sense", sense},
          {"faces", state_of(result)},
          {"contact_share", quantity(solid.contact_share, "1")},
          {"added_compliance", quantity(result.added_compliance, "rad/(N*m)")},
          {"energy_release_rate", quantity(result.energy_release_rate, "J/m^2")},
          {"fronts", fronts},
          {"evidence",
           {{"ring_spread", releases(result) ? Json(largest_ring_spread(result)) : Json()},
            {"growth_check", releases(result) ? Json(result.growth_check) : Json()},
            {"sound_check", result.sound_check != 0 ? Json(result.sound_check) : Json()},
            {"energy_balance", solid.energy_balance},
            {"equilibrium_residual", solid.equilibrium_residual},
            {"worst_jacobian", solid.worst_jacobian},
            {"unknowns", solid.dofs}}},
          {"usable", result.usable},
          {"reason", result.reason}};
}

Json json_of(const gear_fem::TubeCrackResult& result, const char* sense) {
  Json fronts = Json::array();
  for (std::size_t f = 0; f < result.solid.fronts.size(); ++f) {
    Json stations = Json::array();
    for (const fem::FrontStation& s : result.solid.fronts[f].stations)
      stations.push_back(intensities(result, s));
    fronts.push_back({{"tip", kTips.at(f)}, {"from_inner_to_outer_face", stations}});
  }
  return json_of(result, sense, fronts);
}

Json json_of(const gear_fem::TubeSurfaceCrackResult& result, const char* sense) {
  Json stations = Json::array();
  for (const fem::FrontStation& s : inner_stations(result)) {
    Json station = intensities(result, s);
    station["front_angle"] = quantity(front_angle(s), "rad");
    stations.push_back(std::move(station));
  }
  return json_of(result, sense, Json::array({{{"from_upper_to_lower_end", stations}}}));
}

}  // namespace

std::string run_text(const RunResult& result, const GearSet& gear) {
  std::string text = fmt::format("Finite elements: {}\n", gear.name.empty() ? "drive" : gear.name);
  if (!result.shaft_cracks.empty() || result.cup)
    text += fmt::format("Bodies of revolution by elements of order {}\n", result.section_order);
  if (!result.wall_cracks.empty() || !result.surface_cracks.empty())
    text += fmt::format("Cracks of the wall by solid elements of order {}\n", result.solid_order);
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
        result.section_order - 1, result.section_order, cup.lower_order,
        cup.solution.energy_balance, cup.solution.equilibrium_residual, cup.solution.worst_jacobian,
        cup.solution.dofs, verdict(cup.usable, cup.reason));
  }
  for (const TubeCrackRun& crack : result.wall_cracks) {
    const gear_fem::TubeWithThroughCrack& tube = crack.tube;
    text += fmt::format(
        "\n{}: through crack, half length {:.6g} mm, {:.4g} deg from the generator,\n"
        "  in {} of mean radius {:.6g} mm, wall {:.6g} mm, length {:.6g} mm\n",
        crack.path, tube.half_length * 1e3, tube.angle * 180 / std::numbers::pi,
        tube.ends.any() ? "the barrel of a cup" : "a tube", tube.mean_radius * 1e3,
        tube.wall_thickness * 1e3, tube.length * 1e3);
    if (tube.ends.any()) text += fmt::format("  besides the barrel: {}\n", ends_of(tube));
    text += line(fmt::format("compliance of the {} without the crack", body_of(tube)),
                 crack.positive.compliance_without, "rad/(N*m)");
    text += fmt::format(" torque {:+.6g} N*m\n", tube.torque);
    write(text, crack.positive);
    text += fmt::format(" torque {:+.6g} N*m\n", -tube.torque);
    write(text, crack.negative);
  }
  for (const SurfaceCrackRun& crack : result.surface_cracks) {
    const gear_fem::TubeWithSurfaceCrack& tube = crack.tube;
    text += fmt::format(
        "\n{}: surface crack, depth {:.6g} mm, half length {:.6g} mm,\n"
        "  {:.4g} deg from the generator, mouth on the outer surface,\n"
        "  in a tube of mean radius {:.6g} mm, wall {:.6g} mm, length {:.6g} mm\n",
        crack.path, tube.depth * 1e3, tube.half_length * 1e3, tube.angle * 180 / std::numbers::pi,
        tube.mean_radius * 1e3, tube.wall_thickness * 1e3, tube.length * 1e3);
    text += line("compliance of the tube without the crack", crack.positive.compliance_without,
                 "rad/(N*m)");
    text += fmt::format(" torque {:+.6g} N*m\n", tube.torque);
    write(text, crack.positive);
    text += fmt::format(" torque {:+.6g} N*m\n", -tube.torque);
    write(text, crack.negative);
  }
  if (!result.notes.empty()) text += "\nNotes\n";
  for (const std::string& note : result.notes)
    text += "  " + wrapped("- " + note, kTextWidth - 2, 4) + "\n";
  return text;
}

std::string run_json(const RunResult& result, const GearSet& gear, const Provenance& provenance) {
  Json json{{"method", "finite elements"},       {"section_order", result.section_order},
            {"solid_order", result.solid_order}, {"usable", result.usable()},
            {"reason", result.reason()},         {"output_shaft", Json::object()},
            {"flexspline", Json::object()},      {"notes", result.notes}};
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
  Json& flexspline = json["flexspline"];
  if (result.cup) {
    const gear_fem::CupResult& cup = *result.cup;
    Json parts = Json::array();
    for (const gear_fem::CupPart& part : cup.parts)
      parts.push_back({{"name", part.name},
                       {"compliance", quantity(part.compliance, "rad/(N*m)")},
                       {"share", quantity(part.share, "1")}});
    flexspline["sound"] = {{"compliance", quantity(cup.compliance, "rad/(N*m)")},
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
  flexspline["cracks"] = Json::array();
  for (const TubeCrackRun& crack : result.wall_cracks)
    flexspline["cracks"].push_back(
        {{"path", crack.path},
         {"kind", "through"},
         {"body", body_of(crack.tube)},
         {"half_length", quantity(crack.tube.half_length, "m")},
         {"angle", quantity(crack.tube.angle, "rad")},
         {"torque", quantity(crack.tube.torque, "N*m")},
         {"compliance_without", quantity(crack.positive.compliance_without, "rad/(N*m)")},
         {"senses", {json_of(crack.positive, "positive"), json_of(crack.negative, "negative")}}});
  for (const SurfaceCrackRun& crack : result.surface_cracks)
    flexspline["cracks"].push_back(
        {{"path", crack.path},
         {"kind", "surface"},
         {"mouth", "outer"},
         {"depth", quantity(crack.tube.depth, "m")},
         {"half_length", quantity(crack.tube.half_length, "m")},
         {"angle", quantity(crack.tube.angle, "rad")},
         {"torque", quantity(crack.tube.torque, "N*m")},
         {"compliance_without", quantity(crack.positive.compliance_without, "rad/(N*m)")},
         {"senses", {json_of(crack.positive, "positive"), json_of(crack.negative, "negative")}}});
  json["provenance"] = {{"program", "strainwave"},
                        {"version", provenance.version},
                        {"revision", provenance.revision},
                        {"input_file", provenance.input_file},
                        {"input", Json::parse(strainwave::json_of(gear, JsonNumbers::as_input))}};
  // Text from a file may be any bytes; JSON must be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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

// SPDX-License-Identifier: Apache-2.0
#include "run_text.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string_view>
#include <vector>

#include "strainwave/core/shown_text.hpp"

namespace strainwave::fe_study {
namespace {

constexpr double kMPaRootMetre = 1e6;

std::string line(std::string_view name, double value, std::string_view unit) {
  return fmt::format("  {:<44} {:>13.6g} {}\n", name, value, unit);
}

void write(std::string& text, const gear_fem::ShaftCrackLoad& load, std::string_view unit) {
  text += line("sound compliance", load.sound_compliance, unit);
  text += line("added by the crack, from the integral of 2G", load.added_compliance, unit);
  text += line("added by the crack, from the difference of two solutions", load.added_by_difference,
               unit);
  text += fmt::format(
      "  checks: rings {:.1e}, dC/dA {:.1e}, faces {:.1e}, energy {:.1e}, equilibrium {:.1e},\n"
      "          worst Jacobian {:.2f}; {} unknowns; {}\n",
      load.tip.ring_spread, load.growth_check, load.tip.displacement_check, load.energy_balance,
      load.equilibrium_residual, load.worst_jacobian, load.dofs, verdict(load.usable, load.reason));
}

/// The parts of a cup in addition to the barrel.
std::string ends_of(const gear_fem::TubeWithThroughCrack& tube) {
  std::vector<std::string> parts;
  if (tube.ends.rim) parts.emplace_back("rim");
  if (tube.ends.diaphragm) parts.emplace_back("diaphragm");
  if (tube.ends.boss) parts.emplace_back("boss");
  return fmt::format("{}", fmt::join(parts, ", "));
}

void write_checks(std::string& text, const gear_fem::TubeCrackResult& result) {
  const gear_fem::Checks checks = result.checks();
  text += checks.ring_spread ? fmt::format("  checks: rings {:.1e}, dC/dA {:.1e}, ",
                                           *checks.ring_spread, *checks.growth_check)
                             : std::string("  checks: no energy is released; ");
  text += fmt::format(
      "energy {:.1e}, equilibrium {:.1e},\n          {}worst Jacobian {:.2f}; {} "
      "unknowns; {}\n",
      checks.energy_balance, checks.equilibrium_residual,
      checks.sound_check ? fmt::format("sound cup {:.1e}, ", *checks.sound_check) : std::string(),
      checks.worst_jacobian, checks.unknowns, verdict(result.usable, result.reason));
}

void write_intensities(std::string& text, const std::string& where, const gear_fem::FrontPoint& s) {
  text += fmt::format("    {:<22} {:>13.5g} {:>13.5g} {:>13.5g}\n", where, s.K_I / kMPaRootMetre,
                      s.K_II / kMPaRootMetre, s.K_III / kMPaRootMetre);
}

void write_state(std::string& text, const gear_fem::TubeCrackResult& result) {
  text += fmt::format("  {}: the faces touch over {:.3g} % of the crack\n", result.faces(),
                      100 * result.solid.contact_share);
  text += line("added by the crack", result.added_compliance, "rad/(N*m)");
}

void write(std::string& text, const gear_fem::TubeCrackResult& result) {
  write_state(text, result);
  text += line("energy release rate, mean of both fronts", result.energy_release_rate, "J/m^2");
  text += "  through the wall              K_I          K_II         K_III  MPa*m^0.5\n";
  for (const gear_fem::TipFront& front : result.tips()) {
    const auto& points = front.from_inner_to_outer_face;
    for (const gear_fem::FrontPoint& point : points) {
      const std::string_view where = &point == &points.front()  ? "inner face"
                                     : &point == &points.back() ? "outer face"
                                                                : "within";
      write_intensities(text, fmt::format("{} tip, {}", front.tip, where), point);
    }
  }
  write_checks(text, result);
}

void write(std::string& text, const gear_fem::TubeSurfaceCrackResult& result) {
  write_state(text, result);
  text += line("energy release rate, grown in proportion", result.energy_release_rate, "J/m^2");
  if (result.releases()) {
    text += "  along the front               K_I          K_II         K_III  MPa*m^0.5\n";
    for (const gear_fem::EllipsePoint& point : result.front())
      write_intensities(text,
                        fmt::format("{:.4g} deg{}", point.front_angle * 180 / std::numbers::pi,
                                    point.front_angle == std::numbers::pi / 2 ? ", deepest" : ""),
                        point);
  } else {
    text += "  along the front all K are zero within rounding and mesh errors\n";
  }
  write_checks(text, result);
}

/// Both senses of torque.
template <class Run>
void write_senses(std::string& text, const Run& crack) {
  text += fmt::format(" torque {:+.6g} N*m\n", crack.tube.torque);
  write(text, crack.positive);
  text += fmt::format(" torque {:+.6g} N*m\n", -crack.tube.torque);
  write(text, crack.negative);
}

void write_crack(std::string& text, const TubeCrackRun& crack) {
  const gear_fem::TubeWithThroughCrack& tube = crack.tube;
  text += fmt::format(
      "\n{}: through crack, half length {:.6g} mm, {:.4g} deg from the generator,\n"
      "  in {} of mean radius {:.6g} mm, wall {:.6g} mm, length {:.6g} mm\n",
      crack.path, tube.half_length * 1e3, tube.angle * 180 / std::numbers::pi,
      tube.ends.any() ? "the barrel of a cup" : "a tube", tube.mean_radius * 1e3,
      tube.wall_thickness * 1e3, tube.length * 1e3);
  if (tube.ends.any()) text += fmt::format("  in addition to the barrel: {}\n", ends_of(tube));
  text +=
      line(fmt::format("compliance of the {} without the crack", tube.ends.any() ? "cup" : "tube"),
           crack.positive.compliance_without, "rad/(N*m)");
  write_senses(text, crack);
}

void write_crack(std::string& text, const SurfaceCrackRun& crack) {
  const gear_fem::TubeWithSurfaceCrack& tube = crack.tube;
  text += fmt::format(
      "\n{}: surface crack, depth {:.6g} mm, half length {:.6g} mm,\n"
      "  {:.4g} deg from the generator, mouth on the {} surface,\n"
      "  in a tube of mean radius {:.6g} mm, wall {:.6g} mm, length {:.6g} mm\n",
      crack.path, tube.depth * 1e3, tube.half_length * 1e3, tube.angle * 180 / std::numbers::pi,
      mouth_of(tube), tube.mean_radius * 1e3, tube.wall_thickness * 1e3, tube.length * 1e3);
  text += line("compliance of the tube without the crack", crack.positive.compliance_without,
               "rad/(N*m)");
  write_senses(text, crack);
}

}  // namespace

std::string verdict(bool usable, const std::string& reason) {
  return usable ? "usable" : fmt::format("NOT usable: {}", reason);
}

std::string plan_text(const std::vector<RunSize>& sizes) {
  std::string text = "Plan, with estimates:\n";
  for (const RunSize& size : sizes)
    text += fmt::format("  {:<28} {:>8} unknowns, {} solutions, {:.2g} GB, {:.2g} s\n", size.path,
                        size.dofs, size.solutions, size.memory / 1e9, size.seconds);
  return text;
}

std::string run_text(const RunResult& result, const GearSet& gear) {
  if (!result.calculated) return plan_text(result.plan);
  std::string text = fmt::format("Finite elements: {}\n", gear.name.empty() ? "drive" : gear.name);
  if (!result.output_shaft.cracks.empty() || result.flexspline.sound)
    text += fmt::format("Bodies of revolution by elements of order {}\n", result.section_order);
  if (!result.flexspline.cracks.empty())
    text += fmt::format("Cracks of the wall by solid elements of order {}\n", result.solid_order);
  for (const ShaftCrackRun& crack : result.output_shaft.cracks) {
    text += fmt::format("\n{}: annular crack, depth {:.6g} mm\n", crack.path,
                        crack.section.crack->depth * 1e3);
    const StressIntensity K = crack.at_load();
    text += fmt::format(" at the given load, {:.6g} N*m and {:.6g} N\n", crack.torque, crack.force);
    text += line("K_I", K.K_I / kMPaRootMetre, "MPa*m^0.5");
    text += line("K_III", K.K_III / kMPaRootMetre, "MPa*m^0.5");
    if (!crack.opens())
      text += "  the axial force presses the faces together: the crack is closed, K_I = 0\n";
    text += " torsion\n";
    write(text, crack.result.torsion, "rad/(N*m)");
    text += " tension\n";
    write(text, crack.result.tension, "m/N");
  }
  if (result.flexspline.sound) {
    const gear_fem::CupResult& cup = *result.flexspline.sound;
    text += "\nflexspline: sound, torsion of the open end against the held end\n";
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
  for (const WallCrackRun& crack : result.flexspline.cracks)
    std::visit([&](const auto& one) { write_crack(text, one); }, crack);
  if (!result.notes.empty()) text += "\nNotes\n";
  for (const Note& note : result.notes)
    text += "  " + wrapped("- " + note.text, kTextWidth - 2, 4) + "\n";
  return text;
}

}  // namespace strainwave::fe_study

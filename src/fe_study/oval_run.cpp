// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/oval_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "run_text.hpp"
#include "strainwave/core/ascending.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "strainwave/present/oval.hpp"

namespace strainwave::fe_study {
namespace {

std::vector<Note> notes_of(const GearSet& gear) {
  std::vector<Note> notes;
  notes.push_back({"fe.oval_model",
                   "the wall has no cracks, no teeth and sharp corners; the places are two walls "
                   "clear of them; the cam is rigid and has no friction; the torque acts evenly "
                   "round the rim",
                   "flexspline", "FE-52", Severity::care,
                   "Add the notch of a fillet or of a tooth root by a factor of your own."});
  if (perimeter_is_assumed(gear))
    notes.push_back({"fe.cam_perimeter", "the cam is taken to have the perimeter of the bore",
                     "wave_generator.cam_perimeter_excess", "FE-52", Severity::care,
                     "Give cam_perimeter_excess if the perimeter is known."});
  return notes;
}

}  // namespace

ResultEvidence evidence_of(const OvalRun& run) {
  ResultEvidence evidence{.unusable_because = run.reason,
                          .refused = false,
                          .verdict = {},
                          .notes = run.notes,
                          .equations = {"FE-51", "FE-52"},
                          .accuracies = {},
                          .requirement = {}};
  if (run.contact.large_rotations) evidence.equations.emplace_back("FE-53");
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

OvalRun run_oval(const GearSet& gear, const OvalRequest& request) {
  check(gear);
  require_turning_cup(gear);
  for (const double torque : request.torques)
    require(std::isfinite(torque), "--torque", torque, "N*m", "finite");
  gear_fem::OvalOptions options{.large_rotations = request.large_rotations};
  options.order = request.order.value_or(options.order);
  require(options.order >= 4 && options.order <= 8, "order", options.order, "1",
          ">= 4 and <= 8 for the oval");
  const Flexspline& flexspline = *gear.flexspline;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, flexspline.material, "flexspline.material"));
  const std::vector<double> torques =
      request.torques.empty() ? std::vector{gear.load.torque} : ascending(request.torques);
  OvalRun run;
  static_cast<gear_fem::OvalStress&>(run) = gear_fem::oval_stress(
      gear_fem::cup_section(flexspline), {.youngs_modulus = steel.E, .poissons_ratio = steel.nu},
      cam_fit(gear), torques, options);
  run.notes = notes_of(gear);
  return run;
}

std::string oval_text(const OvalRun& run, const GearSet& gear) {
  const gear_fem::OvalContact& contact = run.contact;
  std::string text =
      fmt::format("Finite elements: {}\n{} unknowns for each number of waves, {}\n\n",
                  gear.name.empty() ? "drive" : gear.name, run.unknowns,
                  verdict(run.usable, run.reason)) +
      largest_stress_sentence(run.torques);
  text += paragraph(fmt::format(
      "The cam presses with {:.4g} N on each lobe, over {:.3g} deg to both sides, at most {:.3g} "
      "MPa. The rim turns outward by {:.3g} deg at a lobe (coning).",
      contact.lobe_force, contact.half_arc / units::deg, contact.largest_pressure / units::MPa,
      run.coning_angle / units::deg));
  text += paragraph(contact.large_rotations
                        ? fmt::format("Large rotations of the oval change a stress by up to "
                                      "{:.4g} MPa.",
                                      run.rotation_stress / units::MPa)
                        : std::string("The oval is computed for small rotations."));
  text += fmt::format("Checks: order p-1 {:.1e} of the largest stress, equilibrium {:.1e}\n",
                      run.order_difference, run.equilibrium_residual);
  text += oval_tables(run.torques) + "\nNotes\n";
  for (const Note& note : run.notes)
    text += "  " + wrapped("- " + note.text, kTextWidth - 2, 4) + "\n";
  return text;
}

std::string oval_csv(const OvalRun& run) { return strainwave::oval_csv(run.torques); }

std::string oval_plot(const OvalRun& run, const GearSet& gear) {
  std::vector<PlotPanel> panels = oval_panels(run.torques);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave::fe_study

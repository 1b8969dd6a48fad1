// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/oval_run.hpp"

#include <fmt/format.h>

#include "cup_notes.hpp"
#include "run_text.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/section_materials.hpp"
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
  add_oval_notes(notes, gear);
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
  if (run.large_rotations) evidence.equations.emplace_back("FE-53");
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

OvalRun run_oval(const GearSet& gear, const OvalRequest& request, std::optional<int> order) {
  const std::vector<double> torques = plan_oval(gear, request);
  gear_fem::OvalOptions options{.large_rotations = request.large_rotations};
  options.order = order.value_or(options.order);
  require(options.order >= 4 && options.order <= 8, "order", options.order, "1",
          ">= 4 and <= 8 for the oval");
  const Flexspline& flexspline = *gear.flexspline;
  const ElasticConstants steel = elastic_constants(only_material(gear, flexspline));
  OvalRun run;
  static_cast<gear_fem::OvalStress&>(run) = gear_fem::oval_stress(
      gear_fem::cup_section(flexspline), {.youngs_modulus = steel.E, .poissons_ratio = steel.nu},
      cam_fit(gear), torques, options);
  run.notes = notes_of(gear);
  return run;
}

std::string oval_text(const OvalRun& run, const GearSet& gear) {
  std::string text =
      fmt::format("Finite elements: {}\n{} unknowns for each number of waves, {}\n\n",
                  gear.name.empty() ? "drive" : gear.name, run.unknowns,
                  verdict(run.usable, run.reason)) +
      oval_sentences(run, run.contact);
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

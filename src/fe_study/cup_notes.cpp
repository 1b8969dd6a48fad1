// SPDX-License-Identifier: Apache-2.0
#include "cup_notes.hpp"

#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave::fe_study {

void add_load_notes(std::vector<Note>& notes, const GearSet& gear) {
  if (gear.load.axial_force != 0)
    notes.push_back({"fe.axial_force", "the axial force is not applied to the flexspline",
                     "load.axial_force", "", Severity::care});
  if (gear.flexspline->stress_nonuniformity != 1)
    notes.push_back({"fe.stress_nonuniformity",
                     "flexspline.stress_nonuniformity is not applied, because finite elements "
                     "compute the stress distribution",
                     "flexspline.stress_nonuniformity", "", Severity::information});
}

void add_oval_notes(std::vector<Note>& notes, const GearSet& gear) {
  if (perimeter_is_assumed(gear))
    notes.push_back({"fe.cam_perimeter", "the cam is taken to have the perimeter of the bore",
                     "wave_generator.cam_perimeter_excess", "FE-52", Severity::care,
                     "Give cam_perimeter_excess if the perimeter is known."});
  add_load_notes(notes, gear);
}

}  // namespace strainwave::fe_study

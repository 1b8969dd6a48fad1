// SPDX-License-Identifier: Apache-2.0
#include "cup_notes.hpp"

#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave {

void add_cup_notes(std::vector<Note>& notes, const GearSet& gear) {
  if (perimeter_is_assumed(gear))
    notes.push_back({"turn.cam_perimeter", "the cam is taken to have the perimeter of the bore",
                     "wave_generator.cam_perimeter_excess", "CU-2", Severity::care,
                     "Give cam_perimeter_excess if the perimeter is known."});
  if (gear.load.axial_force != 0)
    notes.push_back({"turn.axial_force", "the axial force is not applied to the flexspline",
                     "load.axial_force", "", Severity::care});
  if (gear.flexspline->boss)
    notes.push_back({"turn.boss", "the boss is taken as rigid: the bore of the diaphragm is held",
                     "flexspline.boss", "CU-1", Severity::information});
  if (gear.flexspline->stress_nonuniformity != 1)
    notes.push_back({"turn.stress_nonuniformity",
                     "flexspline.stress_nonuniformity is not applied, because the torque of a tube "
                     "is even",
                     "flexspline.stress_nonuniformity", "CU-4", Severity::care});
}

}  // namespace strainwave

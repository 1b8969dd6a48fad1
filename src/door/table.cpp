// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"

namespace strainwave {

// Each row has a function in the file of the same name in commands/.
Command accuracy_command();
Command audit_command();
Command backbone_command();
Command calibrate_command();
Command catalogue_command();
Command diff_command();
Command duty_command();
Command fit_command();
Command frf_command();
Command grow_command();
Command inspect_command();
Command laminate_command();
Command life_command();
Command material_list_command();
Command material_show_command();
Command modes_command();
Command new_command();
Command oval_command();
Command reliability_command();
Command report_command();
Command require_command();
Command sensitivity_command();
Command sif_eval_command();
Command sif_list_command();
Command sif_plot_command();
Command sif_show_command();
Command simulate_command();
Command solve_command();
Command stiffness_command();
Command sweep_command();
Command torsion_command();
Command transmission_command();
Command turn_command();
Command units_command();
Command validate_command();

std::span<const Command> commands() {
  static const std::vector<Command> table = {
      stiffness_command(),
      torsion_command(),
      duty_command(),
      life_command(),
      grow_command(),
      fit_command(),
      inspect_command(),
      oval_command(),
      turn_command(),
      laminate_command(),
      transmission_command(),
      modes_command(),
      frf_command(),
      simulate_command(),
      backbone_command(),
      accuracy_command(),
      require_command(),
      report_command(),
      sensitivity_command(),
      reliability_command(),
      sweep_command(),
      solve_command(),
      sif_list_command(),
      sif_show_command(),
      sif_eval_command(),
      sif_plot_command(),
      material_list_command(),
      material_show_command(),
      catalogue_command(),
      validate_command(),
      calibrate_command(),
      audit_command(),
      new_command(),
      schema_command(commands),
      explain_command(commands),
      units_command(),
      diff_command(),
  };
  return table;
}

}  // namespace strainwave

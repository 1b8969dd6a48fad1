// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/gear_fem/oval_stress.hpp"
#include "strainwave/model/input/oval_request.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// Stress of the sound flexspline over a turn of the wave generator, from the input file of a
/// drive.

namespace strainwave::fe_study {

struct OvalRun : gear_fem::OvalStress {
  std::vector<Note> notes;
};

[[nodiscard]] ResultEvidence evidence_of(const OvalRun& run);

/// Computes the stress.  Every MPI rank may call it, and gets the result.
/// @param order  p of the section, 4 to 8; absent: that of gear_fem::OvalOptions
/// @throws InputError, SolverError  as plan_oval and gear_fem::oval_stress
[[nodiscard]] OvalRun run_oval(const GearSet& gear, const OvalRequest& request,
                               std::optional<int> order = std::nullopt);

[[nodiscard]] std::string oval_text(const OvalRun& run, const GearSet& gear);
[[nodiscard]] std::string oval_csv(const OvalRun& run);
[[nodiscard]] std::string oval_plot(const OvalRun& run, const GearSet& gear);

}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/gear_fem/oval_stress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// Stress of the sound flexspline over a turn of the wave generator, from the input file of a
/// drive.

namespace strainwave::fe_study {

struct OvalRequest {
  std::vector<double> torques = {};  ///< T at the output [N*m]; empty: that of the file
  std::optional<int> order = {};     ///< p of the section, 4 to 8; absent: that of OvalOptions
  LargeRotations large_rotations = LargeRotations::automatic;
};

struct OvalRun : gear_fem::OvalStress {
  std::vector<Note> notes;
};

[[nodiscard]] ResultEvidence evidence_of(const OvalRun& run);

/// Computes the stress.  Every MPI rank may call it, and gets the result.
/// @throws InputError, SolverError  as `check`, require_turning_cup and gear_fem::oval_stress
[[nodiscard]] OvalRun run_oval(const GearSet& gear, const OvalRequest& request);

[[nodiscard]] std::string oval_text(const OvalRun& run, const GearSet& gear);
[[nodiscard]] std::string oval_csv(const OvalRun& run);
[[nodiscard]] std::string oval_plot(const OvalRun& run, const GearSet& gear);

}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Results that are a folder of files: VTU for ParaView, pictures as SVG.

namespace strainwave::fe_study {

/// "flexspline_crack_0" of "flexspline.crack[0]"
[[nodiscard]] std::string file_stem(const std::string& path);

/// The fields of a run as VTU, at the given load: of each crack of the output shaft and of the
/// sound cup a section in the plane y = 0, of each crack of the wall and both senses of torque the
/// body, the crack's faces and its fronts.  On several ranks each writes the cells that it has,
/// and the first one the .pvtu files that name them all.  JSON is not among them.
///
/// @param result  of a run with RunFields::of_rank
[[nodiscard]] std::vector<OutputFile> vtu_files(const RunResult& result, const GearSet& gear,
                                                const Ranks& ranks);

/// Pictures as SVG, no larger than 2 MB each: of each crack of the wall, for the sense of torque
/// that releases more energy, strain energy density on the surface, the same less that of the sound
/// wall, the crack opened and magnified, and the stress intensity along the fronts; of each crack
/// of the output shaft strain energy density and what the crack changes in it, and stress intensity
/// over depth; of the sound cup strain energy density.
///
/// @param result  of a run with RunFields::everywhere; of the first rank
[[nodiscard]] std::vector<OutputFile> pictures(const RunResult& result, const GearSet& gear);

}  // namespace strainwave::fe_study

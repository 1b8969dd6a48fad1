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

/// File name stem of a path: "flexspline_crack_0" for "flexspline.crack[0]".
[[nodiscard]] std::string file_stem(const std::string& path);

/// The fields of a run as VTU files at the given load.  Each crack of the output shaft and the
/// sound cup give a section in the plane y = 0.  Each wall crack gives, for both senses of torque,
/// the body, the faces of the crack and its fronts.  With several ranks, each rank writes its own
/// cells, and the first rank also writes the .pvtu files that list them.  JSON does not contain the
/// fields.
///
/// @param result  result of a run with RunFields::of_rank
[[nodiscard]] std::vector<OutputFile> vtu_files(const RunResult& result, const GearSet& gear,
                                                const Ranks& ranks);

/// Pictures as SVG of at most 2 MB each.  For each wall crack, under the sense of torque that
/// releases more energy: strain energy density on the surface, its difference from the sound wall,
/// the crack with magnified opening, and the stress intensity along the fronts.  For each crack of
/// the output shaft: strain energy density, its change by the crack, and stress intensity over
/// depth. For the sound cup: strain energy density.
///
/// @param result  result of a run with RunFields::everywhere, on the first rank
[[nodiscard]] std::vector<OutputFile> pictures(const RunResult& result, const GearSet& gear);

}  // namespace strainwave::fe_study

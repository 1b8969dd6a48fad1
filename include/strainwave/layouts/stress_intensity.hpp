// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/solutions.hpp"

namespace strainwave {

/// Two lines for each solution.
[[nodiscard]] std::string sif_list_text(const SolutionList& list);
/// The table of docs/guide/stress_intensity.md.
[[nodiscard]] std::string sif_list_markdown(const SolutionList& list);

/// Everything that a solution says about itself: fields, loads, range, accuracy, source.
[[nodiscard]] std::string sif_solution_text(const DescribedSolution& solution);

[[nodiscard]] std::string sif_evaluation_text(const sif::Evaluation& evaluation);

/// The geometry factors as an SVG file: over the crack's size, as it grows to its values, one line
/// for each load and named point; and along the front, where it has a length.
[[nodiscard]] std::string sif_plot(const sif::Row& row, const sif::Assignments& values);

}  // namespace strainwave

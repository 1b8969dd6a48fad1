// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/solutions.hpp"

namespace strainwave {

/// A list with two lines for each solution.
[[nodiscard]] std::string sif_list_text(const SolutionList& list);
/// The solutions as the table in docs/guide/stress_intensity.md.
[[nodiscard]] std::string sif_list_markdown(const SolutionList& list);

/// The full description of a solution: fields, loads, range, accuracy, source.
[[nodiscard]] std::string sif_solution_text(const DescribedSolution& solution);

[[nodiscard]] std::string sif_evaluation_text(const sif::Evaluation& evaluation);

/// The geometry factors as an SVG file: over the crack's size up to the given one, with one line
/// for each load and named point.  A second panel shows the factors along the front if the front
/// has a length.
[[nodiscard]] std::string sif_plot(const sif::Row& row, const sif::Assignments& values);

}  // namespace strainwave

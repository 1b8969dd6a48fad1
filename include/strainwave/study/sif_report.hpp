// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "strainwave/sif/evaluation.hpp"

// What `strainwave sif` prints.

namespace strainwave {

/// One line for each solution; `family` empty for all.
/// @throws InputError  there is no such family
[[nodiscard]] std::string sif_list_text(std::string_view family);
[[nodiscard]] std::string sif_list_json(std::string_view family);
/// The table of docs/guide/stress_intensity.md.
[[nodiscard]] std::string sif_list_markdown(std::string_view family);

/// Everything that a solution says about itself: fields, loads, range, accuracy, source.
[[nodiscard]] std::string sif_solution_text(const sif::Row& row);
[[nodiscard]] std::string sif_solution_json(const sif::Row& row);

[[nodiscard]] std::string sif_evaluation_text(const sif::Evaluation& evaluation);
[[nodiscard]] std::string sif_evaluation_json(const sif::Evaluation& evaluation);

/// Reads "depth=2 mm" or "tension=100 MPa" for a solution.
/// @throws InputError  unknown name, or a quantity of another dimension
[[nodiscard]] sif::Assignments sif_assignments(const sif::Row& row,
                                               std::span<const std::string> texts);

/// The geometry factors as an SVG file: over the crack's size, as it grows to its values, one line
/// for each load and named point; and along the front, where it has a length.
[[nodiscard]] std::string sif_plot(const sif::Row& row, const sif::Assignments& values);

}  // namespace strainwave

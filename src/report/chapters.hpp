// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/report/report.hpp"
#include "strainwave/report/section_drawing.hpp"

// The chapters of a report, one function each.

namespace strainwave::report {

/// Data that all chapters read and to which they add for later chapters.
struct Draft {
  const GearSet& gear;
  const Provenance& provenance;
  const ReportOptions& options;
  const Progress& progress;
  std::string input_text;
  StiffnessResult result;
  std::vector<NumberedCrack> cracks;
  std::vector<Note> notes = {};             ///< notes of the result and of other models, each once
  std::vector<std::string> equations = {};  ///< tags, each once
  std::string inputs_summary = {};          ///< number of inputs by origin; plain text
  std::string life = {};       ///< what ends the life of the parts; plain text, empty: not computed
  std::string laminates = {};  ///< which ply fails first; plain text, empty: no laminate
  std::string growth = {};  ///< what ends the growth of the cracks; plain text, empty: not computed

  void add(const std::vector<Note>& more);
  void add(const std::vector<std::string>& tags);
  [[nodiscard]] bool corrected() const { return result.method == Method::corrected; }
};

/// Number of a crack in drawings and tables.
[[nodiscard]] std::string crack_mark(const Draft& draft, const std::string& path);

[[nodiscard]] std::string verdict_html(const Draft& draft);

[[nodiscard]] ReportSection drawing_chapter(const Draft& draft);
[[nodiscard]] ReportSection inputs_chapter(Draft& draft);
[[nodiscard]] ReportSection results_chapter(const Draft& draft);
[[nodiscard]] ReportSection shares_chapter(const Draft& draft);
[[nodiscard]] ReportSection torsion_chapter(Draft& draft);
/// Of a flexspline with a wall of plies.
[[nodiscard]] ReportSection laminate_chapter(Draft& draft);
/// Of a drive with a duty.
[[nodiscard]] ReportSection duty_chapter(Draft& draft);
[[nodiscard]] ReportSection life_chapter(Draft& draft);
/// Of a drive with a drivetrain.
[[nodiscard]] ReportSection modes_chapter(Draft& draft);
[[nodiscard]] ReportSection frf_chapter(Draft& draft);
/// Of a drive with manoeuvres.
[[nodiscard]] ReportSection backbone_chapter(Draft& draft);
[[nodiscard]] ReportSection motion_chapter(Draft& draft);
/// Of a drive with a drivetrain and a kinematic error: the budget of its error.
[[nodiscard]] ReportSection budget_chapter(Draft& draft);
[[nodiscard]] ReportSection sensitivity_chapter(Draft& draft);
[[nodiscard]] ReportSection intensities_chapter(const Draft& draft);
[[nodiscard]] ReportSection strength_chapter(const Draft& draft);
/// The growth of each crack, and the stiffness until its end.
[[nodiscard]] std::vector<ReportSection> growth_chapters(Draft& draft);
/// Of a drive with an inspection, a duty and numbers that scatter: the risk over hours, and what
/// inspections take off it.
[[nodiscard]] ReportSection inspection_chapter(Draft& draft);
[[nodiscard]] ReportSection notes_chapter(const Draft& draft);
[[nodiscard]] ReportSection accuracy_chapter(const Draft& draft);
[[nodiscard]] ReportSection equations_chapter(const Draft& draft);
[[nodiscard]] ReportSection provenance_chapter(const Draft& draft);

}  // namespace strainwave::report

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

/// @file
/// A report on one drive as one HTML file: what an engineer attaches to a decision.

namespace strainwave {

struct ReportOptions {
  Method method = Method::corrected;
  /// The input file, word for word; empty: the drive as `gear_text` writes it.
  std::string input_text = {};
  std::string date = {};  ///< as it is to be printed; empty: none
  int angles = 24;  ///< positions of the wave generator in the comparison of torsion curves; >= 0
  int draws = 200;  ///< of the file's ranges for the bands of K1, K2, K3; >= 0
  int samples = 2000;  ///< of the scatter that the file gives; 2 to kMaxSamples
};

/// A chapter of a report.
struct ReportSection {
  std::string id;     ///< of the element, for links
  std::string title;  ///< plain text
  std::string html;   ///< content, well-formed as XML
};

struct Report {
  std::string title;       ///< name of the drive; plain text
  std::string subtitle;    ///< file, method, version, date; plain text
  StiffnessResult result;  ///< as `evaluate` gives it
  std::string verdict;     ///< usable or not, why, and the key numbers; HTML
  std::vector<ReportSection> sections;
};

/// Evaluates a drive and writes the chapters: drawing, inputs and who gave them, results, shares,
/// torsion curve where the geometry is complete, sensitivity, stress intensities against toughness,
/// validity notes, accuracies, equations, provenance.
///
/// The same input, version and options give the same bytes: no clock, no host, no environment.
/// @throws InputError  if the gear breaks a rule, or holds what the method cannot treat
[[nodiscard]] Report make_report(const GearSet& gear, const Provenance& provenance,
                                 const ReportOptions& options = {}, const Progress& progress = {});

/// The report as one HTML5 document, also well-formed XML: no script, nothing from outside the
/// file, for screens light, dark and narrow, and for A4 paper.
[[nodiscard]] std::string report_html(const Report& whole);

}  // namespace strainwave

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
/// A report on one drive as one HTML file, which an engineer can attach to a decision.

namespace strainwave {

/// What a report contains.
struct ReportOptions {
  Method method = Method::corrected;  ///< method that gives the results
  /// The unchanged input file; empty: the report shows the drive as `gear_text` writes it.
  std::string input_text = {};
  std::string date = {};  ///< date as printed; empty: no date
  /// address of the rendered documentation, to which equations and codes of notes lead; empty: none
  std::string site = {};
  int angles = 24;  ///< positions of the wave generator in the comparison of torsion curves; >= 0
  int draws = 200;  ///< draws of the file's ranges for the bands of K1, K2, K3; >= 0
  int samples = 2000;  ///< samples of the scatter that the file gives; 2 to kMaxSamples
};

/// A chapter of a report.
struct ReportSection {
  std::string id;     ///< identifier of the element, for links
  std::string title;  ///< plain text
  std::string html;   ///< content, well-formed as XML
};

/// A report on one drive, by its chapters.
struct Report {
  std::string title;                    ///< name of the drive; plain text
  std::string subtitle;                 ///< subtitle: file, method, version, date; plain text
  StiffnessResult result;               ///< as `evaluate` gives it
  std::string verdict;                  ///< verdict: usability, reason, and the key numbers; HTML
  std::vector<ReportSection> sections;  ///< the chapters, in their order
};

/// Evaluates a drive and writes the chapters: drawing, inputs and their origin, results, shares,
/// sensitivity, stress intensities against toughness, validity notes, accuracies, equations and
/// provenance.  If the geometry is complete, a chapter on the torsion curve is added.
///
/// The same input, version and options give the same bytes, independently of clock, host and
/// environment.
/// @throws InputError  if the gear breaks a rule, or the method cannot treat it
[[nodiscard]] Report make_report(const GearSet& gear, const Provenance& provenance,
                                 const ReportOptions& options = {}, const Progress& progress = {});

/// The report as one HTML5 document that is also well-formed XML.  It has no script and needs
/// nothing from outside the file.  It suits light, dark and narrow screens and A4 paper.
[[nodiscard]] std::string report_html(const Report& whole);

}  // namespace strainwave

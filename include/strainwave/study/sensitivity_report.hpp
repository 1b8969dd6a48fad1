// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"

/// @file
/// `strainwave sensitivity` as text, JSON, CSV and picture.

namespace strainwave {

struct SensitivityReport {
  Sensitivity sensitivity;
  std::optional<Scatter> scatter;

  template <class Visitor>
  static void describe(Visitor&& field) {
    Sensitivity::describe([&](const Field& what, auto member) {
      field(what,
            [member](const SensitivityReport& r) { return std::invoke(member, r.sensitivity); });
    });
    field({"scatter", "", "combined uncertainty by the scatter of the inputs"},
          &SensitivityReport::scatter);
  }
};

/// The notes of both studies.
[[nodiscard]] ResultEvidence evidence_of(const SensitivityReport& report);

/// Tables at most 100 columns wide: elasticities, the largest first; with scatter, the combined
/// uncertainty and the share of each input.
[[nodiscard]] std::string sensitivity_text(const SensitivityReport& report, const GearSet& gear);

/// A row for each output and input: output, path, unit, value, derivative, elasticity, and with
/// scatter relative_standard_deviation and share, empty for inputs that do not scatter.
[[nodiscard]] std::string sensitivity_csv(const SensitivityReport& report);

/// Bars of the elasticities, the largest on top: a panel for the cracked stiffness and, where
/// cracks take some away, one for its loss.
[[nodiscard]] std::string tornado_plot(const SensitivityReport& report, const GearSet& gear);

}  // namespace strainwave

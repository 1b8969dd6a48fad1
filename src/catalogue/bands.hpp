// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/catalogue/validation.hpp"

namespace strainwave {

/// ln of a value of a table, and ln of its predictions by all draws.
struct DrawnValue {
  const StiffnessRow* row = nullptr;
  double stated = 0.0;
  std::vector<double> drawn;
};

/// The discrepancy of the model beside the draws, estimated from classes of size and ratio (CV-3).
/// @param values  of the catalogue's short cups; at least one
[[nodiscard]] BandFit fit_band(std::span<const DrawnValue* const> values);

/// Quantile of ln K over all draws, each with the normal discrepancy about it (CV-3).
/// @param drawn        ln K of each draw
/// @param discrepancy  standard deviation of ln K; 0: none
/// @param p            [-]; in (0, 1)
[[nodiscard]] double band_quantile(std::span<const double> drawn, double discrepancy, double p);

/// How many values lie within their bands, with all classes and with each class left out.
[[nodiscard]] std::vector<BandTest> band_tests(std::span<const DrawnValue> values,
                                               const BandFit& fit);

/// Whether the bands are made from rows of this kind: short cups of the catalogue.
[[nodiscard]] bool makes_bands(const StiffnessRow& row);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// A row of the coupled drive, for any kind of table.
struct CoupledRow {
  std::string label;        ///< "K1, up to 14 N*m"
  std::string name;         ///< of the output below curve.intact, such as "K1"
  std::string unit;         ///< in which it is shown
  double unit_in_si = 1.0;  ///< of it
  Quantity sound;
  Quantity positive;
  Quantity negative;
  std::optional<Quantity> positive_change = {};  ///< absent: it is said in another row
  std::optional<Quantity> negative_change = {};
  std::string sound_name = {};  ///< of the output below curve.intact, where it is another
};

/// K1, K2, K3 in both units, over a turn where cracks turn relative to the lobes, and wind-up at
/// the given torque and at the maker's.
[[nodiscard]] std::vector<CoupledRow> coupled_rows(const CurveResult& curve, const GearSet& gear);

/// What the table of the coupled drive is called, and that of the sum of the members.
inline constexpr std::string_view kCoupledTitle =
    "Coupled drive: balls, teeth and elastic rings as one system, input locked";
inline constexpr std::string_view kSumTitle = "Sum of the members, without contacts";

/// The result as tables for a terminal; no more digits than the accuracy warrants plus two.
[[nodiscard]] std::string stiffness_text(const StiffnessResult& result, const GearSet& gear,
                                         const Provenance& provenance);

}  // namespace strainwave

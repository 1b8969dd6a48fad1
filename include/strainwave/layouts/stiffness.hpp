// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// A row of the coupled drive, for any kind of table.
struct CoupledRow {
  std::string label;        ///< "K1, up to 14 N*m"
  std::string name;         ///< name of the output below curve.intact, such as "K1"
  std::string unit;         ///< display unit
  double unit_in_si = 1.0;  ///< of it
  Quantity sound;
  Quantity positive;
  Quantity negative;
  std::optional<Quantity> positive_change = {};  ///< absent: another row gives the change
  std::optional<Quantity> negative_change = {};
  std::string sound_name = {};  ///< name of the output below curve.intact if it is not `name`
};

/// The units of a stiffness in tables: the unit that was asked for, otherwise two units.
[[nodiscard]] std::vector<DisplayUnit> stiffness_units();
/// Rows for K1, K2, K3 in these units, and for the wind-up at the given torque and at the maker's
/// torques.  If cracks turn relative to the lobes, there are also rows for K1, K2, K3 over a turn.
[[nodiscard]] std::vector<CoupledRow> coupled_rows(const CurveResult& curve, const GearSet& gear);

/// The titles of the tables of the coupled drive and of the sum of the members.
inline constexpr std::string_view kCoupledTitle =
    "Coupled drive: balls, teeth and elastic rings as one system, input locked";
inline constexpr std::string_view kSumTitle = "Sum of the members, without contacts";

/// The result as tables for a terminal, with at most two digits more than the accuracy warrants.
[[nodiscard]] std::string stiffness_text(const StiffnessResult& result, const GearSet& gear,
                                         const Provenance& provenance);

}  // namespace strainwave

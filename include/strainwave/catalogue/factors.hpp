// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Named unknowns of a drive that a calibration may change.  Each acts by changing fields of the
/// drive; none multiplies a stiffness.

namespace strainwave {

enum class Factor {
  support,          ///< s_h of the circular spline
  coning,           ///< chi of the teeth
  gap_factor,       ///< k_g of the flanks
  pair_compliance,  ///< 1/c' of a pair of teeth, over that of the file
  structure,        ///< thickness of barrel and diaphragm, the file's over it
  clearance,        ///< radial play at a ball, over w_0
  cam_flattening,   ///< c_cam of the wave generator
};
template <>
struct EnumNames<Factor> {
  static constexpr std::array<std::string_view, 7> names = {
      "support",   "coning",    "gap_factor",    "pair_compliance",
      "structure", "clearance", "cam_flattening"};
};
inline constexpr std::size_t kFactors = EnumNames<Factor>::names.size();

struct FactorInfo {
  std::string_view meaning;
  double lower = 0.0;        ///< of what is plausible [-]
  double upper = 0.0;        ///< [-]
  double least = 0.0;        ///< of what a fit to one drive may take [-]
  double most = 0.0;         ///< [-]
  bool logarithmic = false;  ///< positive by nature: fitted by its logarithm
};
[[nodiscard]] const FactorInfo& factor_info(Factor factor);

/// The factor as the drive is [-]; 1 for pair_compliance and structure.
/// @throws InputError  if the drive lacks the field that it acts on
[[nodiscard]] double factor_value(const GearSet& gear, Factor factor);

/// The drive with the factor at this value [-].
/// @throws InputError  as factor_value
[[nodiscard]] GearSet with_factor(GearSet gear, Factor factor, double value);

/// "support,coning" as a list without repetition, not empty.
/// @throws InputError  with the names that are known
[[nodiscard]] std::vector<Factor> parse_factors(std::string_view text);

/// "support, coning"
[[nodiscard]] std::string factor_names(const std::vector<Factor>& factors);

}  // namespace strainwave

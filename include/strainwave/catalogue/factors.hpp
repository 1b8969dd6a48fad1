// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Named unknowns of a drive that a calibration may change.  Each factor changes fields of the
/// drive; no factor multiplies a stiffness.

namespace strainwave {

/// The unknowns of a drive that a calibration may change, each by one number [-].
enum class Factor {
  support,          ///< s_h, support of the circular spline
  coning,           ///< chi, coning of the teeth
  gap_factor,       ///< k_g, gap of the flanks
  pair_compliance,  ///< 1/c' of a pair of teeth, relative to the file
  structure,        ///< thickness of barrel and diaphragm in the file, over the fitted one
  clearance,        ///< radial play at a ball, relative to w_0
  cam_flattening,   ///< c_cam, flattening of the wave generator
};
template <>
struct EnumNames<Factor> {
  static constexpr std::array<std::string_view, 7> names = {
      "support",   "coning",    "gap_factor",    "pair_compliance",
      "structure", "clearance", "cam_flattening"};
};
/// Number of the factors.
inline constexpr std::size_t kFactors = EnumNames<Factor>::names.size();

/// Meaning and limits of a factor.
struct FactorInfo {
  std::string_view meaning;  ///< what the factor is, in words
  double lower = 0.0;        ///< lower end of the plausible range [-]
  double upper = 0.0;        ///< upper end of the plausible range [-]
  double least = 0.0;        ///< least value that a fit to one drive may reach [-]
  double most = 0.0;         ///< largest value that a fit to one drive may reach [-]
  bool logarithmic = false;  ///< always positive, so the fit uses its logarithm
};
/// Meaning and limits of a factor, which are the same for all drives.
[[nodiscard]] const FactorInfo& factor_info(Factor factor);

/// The present value of the factor in a drive [-]; 1 for pair_compliance and structure.
/// @throws InputError  if the drive lacks the field that the factor changes
[[nodiscard]] double factor_value(const GearSet& gear, Factor factor);

/// The drive with the factor set to this value [-].
/// @throws InputError  on the same conditions as factor_value
[[nodiscard]] GearSet with_factor(GearSet gear, Factor factor, double value);

/// Reads factors such as "support,coning": at least one, none repeated.
/// @throws InputError  if a name is unknown; the message lists the known names
[[nodiscard]] std::vector<Factor> parse_factors(std::string_view text);

/// The names of factors as one text: "support, coning".
[[nodiscard]] std::string factor_names(const std::vector<Factor>& factors);

}  // namespace strainwave

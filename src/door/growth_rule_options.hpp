// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/door/door.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"

namespace strainwave {

/// Options that choose the law of growth and the effect of overloads.
struct GrowthRuleOptions {
  std::optional<std::string> law;
  MixedMode mixed_mode = MixedMode::energy;
  InteractionRule interaction = InteractionRule::none;
  std::optional<double> zone_factor;
  std::optional<double> wheeler_exponent;
  std::optional<double> constraint;
  std::optional<double> stress_level;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using G = GrowthRuleOptions;
    field({.name = "law",
           .unit = "",
           .doc = "steel of the material library whose law of growth replaces that of the file; "
                  "the file's if left out",
           .names = "material"},
          &G::law);
    field({.name = "mixed_mode",
           .unit = "",
           .doc = "rule that makes one stress intensity of three modes",
           .fallback = "energy"},
          &G::mixed_mode);
    field({.name = "interaction",
           .unit = "",
           .doc = "how a large cycle slows the cycles after it",
           .fallback = "none"},
          &G::interaction);
    field({.name = "zone_factor",
           .unit = "1",
           .doc = "beta of the plastic zone (K/yield strength)^2/(beta pi): 1 the whole zone in "
                  "plane stress, 2 its radius, 3 and 6 in plane strain; needed with --interaction",
           .range = kPositive},
          &G::zone_factor);
    field({.name = "wheeler_exponent",
           .unit = "1",
           .doc = "exponent of --interaction wheeler, which needs it",
           .range = kNonNegative},
          &G::wheeler_exponent);
    field({.name = "constraint",
           .unit = "1",
           .doc = "alpha of Newman's opening, 1 in plane stress to 3 in plane strain, for "
                  "--interaction closure; cracks with a law of NASGRO take that of their law",
           .range = {.lower = 1.0, .lower_open = false, .upper = 3.0, .upper_open = false}},
          &G::constraint);
    field({.name = "stress_level",
           .unit = "1",
           .doc = "largest stress over the flow stress of Newman's opening, with --constraint",
           .range = {.lower = 0.0, .upper = 1.0}},
          &G::stress_level);
  }
};

/// The choices that the options make.
/// @throws OptionError  if an option is missing, contradicts another one, or names no law
[[nodiscard]] GrowthOptions growth_options(const GrowthRuleOptions& o);

}  // namespace strainwave

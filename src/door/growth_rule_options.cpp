// SPDX-License-Identifier: Apache-2.0
#include "growth_rule_options.hpp"

#include "strainwave/core/error.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

/// Reads the options of the load interaction.
Interaction interaction_of(const GrowthRuleOptions& o) {
  Interaction interaction;
  interaction.rule = o.interaction;
  const bool acts = o.interaction != InteractionRule::none;
  if (acts && !o.zone_factor)
    throw OptionError("zone_factor", "must be given with --interaction, because sources differ");
  if (!acts && o.zone_factor)
    throw OptionError("zone_factor",
                      "is read with --interaction wheeler, willenborg or closure only");
  const bool wheeler = o.interaction == InteractionRule::wheeler;
  if (wheeler != o.wheeler_exponent.has_value())
    throw OptionError("wheeler_exponent", wheeler ? "must be given with --interaction wheeler"
                                                  : "is read with --interaction wheeler only");
  if (acts) interaction.zone_factor = *o.zone_factor;
  if (wheeler) interaction.wheeler_exponent = *o.wheeler_exponent;
  const bool opening = o.constraint || o.stress_level;
  if (opening && o.interaction != InteractionRule::closure)
    throw OptionError(o.constraint ? "constraint" : "stress_level",
                      "is read with --interaction closure only");
  if (opening && !o.constraint)
    throw OptionError("constraint", "must be given with --stress-level");
  if (opening && !o.stress_level)
    throw OptionError("stress_level", "must be given with --constraint");
  if (opening) interaction.closure = {.constraint = *o.constraint, .stress_level = *o.stress_level};
  return interaction;
}

}  // namespace

GrowthOptions growth_options(const GrowthRuleOptions& o) {
  GrowthOptions options;
  options.rate = {.mixed_mode = o.mixed_mode, .law = o.law.value_or("")};
  options.interaction = interaction_of(o);
  if (o.law) from_option([&] { (void)rate_law(require_material(*o.law)); });
  return options;
}

}  // namespace strainwave

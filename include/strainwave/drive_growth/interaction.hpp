// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/growth/load_interaction.hpp"

namespace strainwave {

/// How a large cycle slows the cycles after it.
enum class InteractionRule { none, wheeler, willenborg, closure };
template <>
struct EnumNames<InteractionRule> {
  static constexpr std::array<std::string_view, 4> names = {"none", "wheeler", "willenborg",
                                                            "closure"};
};

/// Load interaction with its constants.
struct Interaction {
  InteractionRule rule = InteractionRule::none;  ///< model of the slower growth
  double zone_factor = 2.0;                      ///< beta of the plastic zone (GR-17) [-]; > 0
  double wheeler_exponent = 1.5;                 ///< gamma (GR-18) [-]; >= 0
  double shut_off_ratio = 2.65;                  ///< R_so (GR-19) [-]; > 1
  /// What Willenborg's rule does with a negative K_min (GR-19).
  NegativeMinimum negative = NegativeMinimum::closed;
  /// Newman's opening (GR-32) for laws that have no own one; NASGRO takes its own
  std::optional<NewmanClosure> closure = {};
};

/// The opening that the closure rule takes for a crack: that of its law, or else the given one.
/// @throws InputError  if there is none
[[nodiscard]] NewmanClosure closure_of(const GrowingCrack& crack, const Interaction& interaction);
/// Whether the law of a crack has its own opening.
[[nodiscard]] bool has_own_closure(const GrowingCrack& crack);

/// Growth of a tip in one repetition with load interaction [m]; infinite as in
/// GrowingCrack::growth.
///
/// Implements theory manual eq. (GR-27).  The cycles follow on each other in the order of their
/// peaks, at a fixed stress intensity.  The repetition is taken from a duty that has run for long,
/// so the overload of the repetition before it still acts.  A peak that comes less than once in a
/// repetition is followed by as many repetitions as lie between two peaks.
///
/// @param crack        the crack to which the tip belongs
/// @param loads        of a tip, in the order of the duty
/// @param crack_size   a [m]; > 0
/// @param interaction  rule and its constants; beta > 0, gamma >= 0, R_so > 1 [-]
/// @param share        of what is left of the overload's zone by which equal cycles advance in one
///                     step, and of its whole zone by which equal repetitions are skipped [-]
/// @throws InputError  if a constant is out of range, or the yield strength or the opening is not
///                     known
[[nodiscard]] double growth_with_interaction(const GrowingCrack& crack,
                                             std::span<const TipLoad> loads, double crack_size,
                                             const Interaction& interaction, double share);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/drive_cracks/shaft_group.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"

// What a report says in words.

namespace strainwave {

/// Head of the report of one crack: law, origin of its constants, cycles, and its kink.
[[nodiscard]] CrackGrowth described_crack(const GearSet& gear, const GrowingCrack& crack,
                                          const RateChoice& choice, double amplification);

/// Notes on the stress of a crack and on the constants of its law.
[[nodiscard]] std::vector<Note> crack_notes(const GearSet& gear, const GrowingCrack& crack,
                                            const RateChoice& choice);

/// Whether a crack grows under the loads of the duty times a factor [-]; absent: not known.
using GrowsUnder = std::function<std::optional<bool>(double factor)>;

/// Adds margin and factor to a crack that stands still.
/// @param amplification  of the loads by the vibration [-]
void describe_arrest(CrackGrowth& to, const GrowingCrack& crack, const CrackSize& size,
                     double amplification, const GrowsUnder& grows);

/// A crack that only the coupled drive models, and that gets no stress from it.
[[nodiscard]] Note coupled_crack_note(const std::string& path, const std::string& why,
                                      const char* next_step);

/// The vibration does not act on a crack whose stress comes from the coupled drive.
[[nodiscard]] Note not_amplified_note(const std::string& path);

/// A crack of a tooth, which has no size.
[[nodiscard]] Note tooth_crack_note(const std::string& path);

/// A crack of a race in a bearing whose balls are not counted.
[[nodiscard]] Note unknown_balls_note(const std::string& path);

/// A crack of a laminate, for which no law is known.
[[nodiscard]] Note laminate_crack_note(const std::string& path);

/// A surface crack with a table of K over a turn goes on through the wall, where it has none.
[[nodiscard]] Note through_wall_note(const std::string& path);

/// The cracks grow until the rules of the input refuse the drive, because they meet for example.
[[nodiscard]] Note refused_size_note(const std::string& path, const std::string& rule);

/// What the cracks of a group change of each other's growth (CG-9).
/// @param at_begin  the group at the first sizes
/// @param at_end    the group at the last ones
[[nodiscard]] Note group_note(const WallGroup& at_begin, const WallGroup& at_end);
/// Two cracks of one line that become one (CG-14).
/// @param first   path of the one that stands first in the file
/// @param second  path of the other one
/// @param merged  the crack in place of both
/// @param change  relative change of the stiffness by the merger [-]
[[nodiscard]] Note merger_note(const std::string& first, const std::string& second,
                               const WallThroughCrack& merged, std::optional<double> change);
/// The cracks of a member grow without the influence of those that are in no group.
[[nodiscard]] Note superposed_note(const std::string& member);
/// How annular cracks of the output shaft shield each other (CG-12).
/// @param at_begin  the group at the first sizes
/// @param at_end    the group at the last ones
[[nodiscard]] Note shielding_note(const ShaftGroup& at_begin, const ShaftGroup& at_end);

/// The coupled drive has no curve with the grown cracks.
[[nodiscard]] Note no_curve_note(const std::string& why);

/// Adds tags of the theory manual that the report does not have yet.
void cite(GrowthReport& report, std::span<const std::string_view> tags);

/// Adds the tags of a crack's law, mixed modes, turn and interaction.
void cite_models(GrowthReport& report, const GrowingCrack& crack, const Interaction& interaction);

/// Least and greatest stress ratio of the cycles by which a crack grows [-].
struct RatioRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void take(double ratio) {
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
};

/// Adds sentence and notes.
/// @param ratios  of each crack of the report
void complete(GrowthReport& report, const GearSet& gear, const RateChoice& choice,
              std::span<const RatioRange> ratios);

}  // namespace strainwave

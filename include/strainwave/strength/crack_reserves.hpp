// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"

namespace strainwave {

/// Verdicts and reserves of every crack, as of crack_strength, in a fraction of its time: without
/// critical sizes and uncertainties.
/// @param gear         as of crack_strength
/// @return             as of crack_strength
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] std::vector<CrackStrength> crack_reserves(const GearSet& gear);

/// The numbers of crack_reserves alone, for a drive of which only some numbers have changed:
/// without the check of the input, sentences, notes and equations.
/// @param gear  has passed `check`
[[nodiscard]] std::vector<CrackStrength> crack_margins(const GearSet& gear);

/// Whether a material of the drive states a property by which its cracks can be assessed;
/// otherwise a result has no strength.
[[nodiscard]] bool strength_is_known(const GearSet& gear);

struct FrontsAtSize;

/// The verdicts of crack_reserves alone, for a drive under several loads: K along each front is
/// computed once for all of them.
class BreakingCracks {
 public:
  BreakingCracks();
  ~BreakingCracks();
  BreakingCracks(const BreakingCracks&) = delete;
  BreakingCracks& operator=(const BreakingCracks&) = delete;

  /// The first crack that fractures or collapses at the load of a drive, in the order of
  /// crack_reserves; absent: there is none.
  /// @param gear    has passed `check`; the drives of all calls differ in their load alone
  /// @param counts  whether a crack of this path is assessed
  [[nodiscard]] std::optional<std::string> first(
      const GearSet& gear, const std::function<bool(const std::string& path)>& counts);

 private:
  std::vector<FrontsAtSize> fronts_;  // of each crack, at the sizes of the drive
};

}  // namespace strainwave

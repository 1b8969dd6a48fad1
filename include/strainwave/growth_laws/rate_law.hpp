// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "strainwave/growth_laws/forman.hpp"
#include "strainwave/growth_laws/hartman_schijve.hpp"
#include "strainwave/growth_laws/nasgro.hpp"
#include "strainwave/growth_laws/paris.hpp"
#include "strainwave/growth_laws/tabulated.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"
#include "strainwave/growth_laws/two_lines.hpp"
#include "strainwave/growth_laws/walker.hpp"

namespace strainwave {

/// Law of the growth rate.
using RateLaw = std::variant<Paris, TwoLines, Walker, Forman, HartmanSchijve, Nasgro, Tabulated>;

/// A law of the growth rate with all that depends on no cycle computed once.
///
/// A law with a member `prepared` brings its own form for this; any other law is ready as it is.
class PreparedLaw {
 public:
  /// @param law  its constants are in range (require_constants)
  explicit PreparedLaw(RateLaw law);

  /// The law as it was given.
  [[nodiscard]] const RateLaw& law() const { return law_; }
  /// da/dN by the law alone [m]; K_max > 0 and below the toughness
  [[nodiscard]] double rate(const TipCycle& cycle, double crack_size) const;
  /// Delta K_th of the law at a stress ratio, full range [Pa*m^0.5]; absent: the law has none
  [[nodiscard]] std::optional<double> threshold(double ratio, double crack_size) const;
  /// K_max at which the law breaks the part [Pa*m^0.5]; absent: the law has no toughness
  [[nodiscard]] std::optional<double> toughness() const { return toughness_; }

 private:
  RateLaw law_;
  std::variant<Paris, TwoLines, Walker, Forman, HartmanSchijve, PreparedNasgro, TableOfRates>
      ready_;
  std::optional<double> toughness_;
};

/// What bounds a law that has no such bound of its own.
struct GrowthLimits {
  /// Delta K_th of long cracks, full range, at the stress ratio of the load [Pa*m^0.5]; > 0
  std::optional<double> threshold = {};
  double intrinsic_size = 0.0;  ///< a_0 of El Haddad's short cracks [m]; >= 0
  /// K at which the part breaks [Pa*m^0.5]; > 0
  std::optional<double> toughness = {};
};

/// Growth of a crack in one cycle.
///
/// Implements theory manual eqs. (GR-2) to (GR-12) and (GR-36).  The crack breaks where K_max
/// reaches the lesser of the toughnesses of the law and of the limits.  It stands still where Delta
/// K is not above the threshold of the law or that of the limits, or if K_max <= 0.  Its rate is
/// then exactly 0.
///
/// @param law          its constants are in range (require_constants)
/// @param cycle        K_max of any sign [Pa*m^0.5]; R < 1 where K_max > 0
/// @param crack_size   a [m]; > 0
/// @param limits       threshold and toughness beside those of the law; {}: none
/// @throws InputError  if R >= 1 although K_max > 0, if a <= 0, if a limit is out of range, or if a
///                     number is not finite
[[nodiscard]] GrowthRate growth_rate(const PreparedLaw& law, const TipCycle& cycle,
                                     double crack_size, const GrowthLimits& limits = {});
/// The same for a single cycle; many cycles are faster with a PreparedLaw.
[[nodiscard]] GrowthRate growth_rate(const RateLaw& law, const TipCycle& cycle, double crack_size,
                                     const GrowthLimits& limits = {});

/// Throws InputError, which names the constant, unless each constant of the law is in its range.
void require_constants(const RateLaw& law);

/// The law for a crack through the thickness: a law that states its toughness over the thickness
/// takes that toughness (GR-11); any other law stays.
/// @param law             with the toughness over the thickness or without it
/// @param thickness       t [m]; > 0
/// @param yield_strength  [Pa]; > 0; absent: not known
/// @throws InputError     if the law needs the yield strength and it is absent
[[nodiscard]] RateLaw law_of_through_crack(const RateLaw& law, double thickness,
                                           std::optional<double> yield_strength);

}  // namespace strainwave

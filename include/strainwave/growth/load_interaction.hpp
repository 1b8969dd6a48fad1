// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/growth_laws/nasgro.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// Size of the plastic zone ahead of the tip, (K/sigma_y)^2/(beta pi) (GR-17) [m].
struct PlasticZone {
  double yield_strength = 0.0;  ///< sigma_y [Pa]; > 0
  /// beta [-]; > 0.  1: the whole zone in plane stress, 2: its radius; 3 and 6: the same in plane
  /// strain.  Sources differ, so the value is always given.
  double factor = 1.0;

  /// Size of the zone under a K [m].
  /// @param K            K_max of the cycle or the overload [Pa*m^0.5]
  /// @throws InputError  if the yield strength or beta is not > 0
  [[nodiscard]] double size(double K) const;
};

/// The overload that governs the growth after it.
struct Overload {
  double crack_size = 0.0;  ///< a at the overload [m]
  double largest = 0.0;     ///< K_max of the overload [Pa*m^0.5]
  double least = 0.0;       ///< least K_min since the overload began [Pa*m^0.5]
};

/// Wheeler's factor of the growth rate behind an overload (GR-18) [-]; from 0 to 1.
/// @param zone        law of the zones of overload and cycle
/// @param overload    the one that governs: its K_max >= 0 and its size > 0
/// @param crack_size  a [m]; at least the size at the overload
/// @param largest     K_max of the cycle [Pa*m^0.5]; >= 0
/// @param exponent    gamma [-]; >= 0.  0: no retardation
/// @throws InputError  if one of these numbers is out of its range
[[nodiscard]] double wheeler_factor(const PlasticZone& zone, const Overload& overload,
                                    double crack_size, double largest, double exponent);

/// What generalised Willenborg does if the reduction makes K_min negative.
enum class NegativeMinimum {
  closed,  ///< the reduction stops at K_min = 0; a K_min that is negative by itself is not reduced
  kept,    ///< the reduction applies in full
};
template <>
struct EnumNames<NegativeMinimum> {
  static constexpr std::array<std::string_view, 2> names = {"closed", "kept"};
};

/// Constants of generalised Willenborg (GR-19).
struct Willenborg {
  PlasticZone zone;              ///< law of the zones of overload and cycle
  double threshold = 0.0;        ///< K_max at the threshold [Pa*m^0.5]; >= 0
  double shut_off_ratio = 2.65;  ///< R_so, overload over later K_max that stops the crack [-]; > 1
  /// What happens if the reduction makes K_min negative.
  NegativeMinimum negative = NegativeMinimum::closed;
};

/// The cycle that acts at the tip behind an overload (GR-19).  The same cycle where the overload no
/// longer governs.
/// @throws InputError  if the overload, the crack size or a constant of the rule is out of range,
///                     K_max is not finite, or R of a cycle with K_max > 0 is not < 1
[[nodiscard]] TipCycle willenborg_cycle(const Willenborg& rule, const Overload& overload,
                                        double crack_size, const TipCycle& cycle);

/// The cycle that acts at the tip behind an overload that holds the crack closed (GR-32).
///
/// R stays, and K_max falls until the range that opens the crack is the one above the held opening.
/// The same cycle, to the last digit, where the overload no longer governs or where the cycle opens
/// later than the overload.  K_max is 0 where the cycle does not open the crack.
/// @throws InputError  if the overload, the crack size or a constant of the zone is out of range,
///                     the constraint is not in [1, 3] or the stress level not in (0, 1), K_max is
///                     not finite, R of a cycle with K_max > 0 is not < 1, or K_min of an overload
///                     that governs is not below its K_max
[[nodiscard]] TipCycle closure_cycle(const PlasticZone& zone, const NewmanClosure& closure,
                                     const Overload& overload, double crack_size,
                                     const TipCycle& cycle);

}  // namespace strainwave

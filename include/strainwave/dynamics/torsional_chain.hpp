// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// @file
/// Linear vibration of inertias that are joined by springs and gears.

namespace strainwave {

/// An inertia that turns about its own axis.
struct ChainInertia {
  std::string name;                ///< in messages and results
  double inertia = 0.0;            ///< J about its own axis [kg*m^2]; > 0
  double damping_to_ground = 0.0;  ///< B [N*m*s/rad]; >= 0
};

/// A spring between inertias, with a gear or without one.
struct ChainSpring {
  std::string name;         ///< in messages and results
  double compliance = 0.0;  ///< lambda [rad/(N*m)]; > 0
  double damping = 0.0;     ///< c, parallel to the spring [N*m*s/rad]; >= 0
  /// g, one number for each inertia: the twist of the spring is the sum of g_j theta_j [-]
  std::vector<double> twist_of;
};

/// Inertias and springs; the angles are those of the inertias.
struct TorsionalChain {
  std::vector<ChainInertia> inertias;  ///< at least one
  std::vector<ChainSpring> springs;    ///< may be empty: all inertias turn freely
};

/// A mode of the chain without damping.
struct ChainMode {
  double frequency = 0.0;      ///< f [Hz]; 0: a free turn, which twists no spring
  double damping_ratio = 0.0;  ///< zeta, of first order in the damping (DY-5) [-]
  /// angle of each inertia, so that the sum of J theta^2 is 1 [(kg*m^2)^-0.5]; 0 if it is held
  std::vector<double> shape;
  /// epsilon, share of the elastic energy in each spring [-]; their sum is 1.  Minus half of it is
  /// the derivative of ln f by ln lambda (DY-4).  Empty if f is 0
  std::vector<double> energy_share;
};

/// Modes of the chain, by rising frequency (DY-3).
/// @param chain        inertias and springs, with numbers in their range
/// @param held         inertias that do not turn, as indices, not all; {}: none
/// @throws InputError  if the chain is empty, a number is out of range, all inertias are held, or a
///                     frequency is below 1e-6 of the highest one
[[nodiscard]] std::vector<ChainMode> chain_modes(const TorsionalChain& chain,
                                                 std::span<const std::size_t> held = {});

/// Answer of the chain to a harmonic excitation: the angle of each inertia.
using ChainResponse = std::vector<std::complex<double>>;

/// Angles per torque on one inertia at a frequency (DY-6) [rad/(N*m)].
/// @param chain        as in `chain_modes`
/// @param loaded       index of the inertia on which the torque acts; it is not held
/// @param frequency    [Hz]; > 0
/// @param held         as in `chain_modes`
/// @throws InputError  as `chain_modes`, if `loaded` is not the index of an inertia that can turn,
///                     if the frequency is not > 0, or if the response is infinite: an undamped
///                     resonance
[[nodiscard]] ChainResponse torque_response(const TorsionalChain& chain, std::size_t loaded,
                                            double frequency,
                                            std::span<const std::size_t> held = {});

/// Angles per error of the twist of one spring, such as a kinematic error (DY-7) [-].
/// @param chain      as in `chain_modes`
/// @param spring     index of the spring whose twist is g theta plus the error
/// @param frequency  [Hz]; > 0
/// @param held       as in `chain_modes`
/// @throws InputError  as `chain_modes`, if `spring` is not the index of a spring, if the frequency
///                     is not > 0, or if the response is infinite: an undamped resonance
[[nodiscard]] ChainResponse twist_response(const TorsionalChain& chain, std::size_t spring,
                                           double frequency,
                                           std::span<const std::size_t> held = {});

/// Speed of a shaft at which an excitation with `order` periods in each of its turns meets a
/// frequency (DY-8) [rad/s].
/// @param frequency  [Hz]; >= 0
/// @param order      [-]; > 0
[[nodiscard]] double critical_speed(double frequency, double order);

}  // namespace strainwave

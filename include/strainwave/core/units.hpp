// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

/// @file
/// Conversion factors to the units used inside strainwave: m, kg, s, K, rad
/// (hence N, Pa, N*m/rad, Pa*m^0.5).  Multiply to enter, divide to leave:
///
///     const double thickness = 0.8 * units::mm;        // [m]
///     std::cout << wind_up / units::arcmin << " arcmin";
///
/// The factors are plain doubles and cost nothing.  They document a call site but do not check it.
/// `parse_quantity` checks text, and the scaling tests check formulas.
namespace strainwave::units {

inline constexpr double m = 1.0;                         ///< metre [m]
inline constexpr double mm = 1e-3;                       ///< millimetre [m]
inline constexpr double N = 1.0;                         ///< newton [N]
inline constexpr double MPa = 1e6;                       ///< megapascal [Pa]
inline constexpr double GPa = 1e9;                       ///< gigapascal [Pa]
inline constexpr double rad = 1.0;                       ///< radian [rad]
inline constexpr double deg = std::numbers::pi / 180.0;  ///< degree [rad]
inline constexpr double arcmin = deg / 60.0;             ///< minute of arc [rad]
inline constexpr double arcsec = arcmin / 60.0;          ///< second of arc [rad]
inline constexpr double lbf = 4.4482216152605;  ///< pound-force [N]: 0.45359237 kg * 9.80665 m/s^2
inline constexpr double psi = lbf / (0.0254 * 0.0254);        ///< pound-force per square inch [Pa]
inline constexpr double rpm = 2.0 * std::numbers::pi / 60.0;  ///< revolution per minute [rad/s]

}  // namespace strainwave::units

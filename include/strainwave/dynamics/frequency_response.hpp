// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/dynamics/torsional_chain.hpp"

/// @file
/// Answers of a chain over a list of frequencies, with their resonances and antiresonances.

namespace strainwave {

/// What shakes a chain.
enum class ShakenBy {
  torque,  ///< a torque on one inertia
  twist,   ///< an error of the twist of one spring
};

/// From an excitation to the angle of an inertia.
struct ChainPath {
  ShakenBy by = ShakenBy::torque;  ///< kind of the excitation
  std::size_t at = 0;              ///< index of the loaded inertia, or of the spring with the error
  std::size_t inertia = 0;         ///< index of the inertia whose angle is asked
};

/// Whether anything damps the inertias that can turn.  A damper of an inertia that is held does
/// not.
///
/// @param chain        inertias and springs, with numbers in their range
/// @param held         as in `chain_modes`
/// @throws InputError  as `chain_modes`
[[nodiscard]] bool has_damping(const TorsionalChain& chain, std::span<const std::size_t> held = {});

/// Angles over a list of frequencies, shape (n paths, n frequencies) [rad/(N*m)] by a torque, [-]
/// by an error of a twist.
///
/// Implements theory manual eq. (DY-12).  At each frequency one small matrix is factored for all
/// paths.
/// @param chain        inertias and springs, with numbers in their range
/// @param paths        excitation and asked inertia of each response; a loaded inertia is not held
/// @param frequencies  [Hz]; each > 0
/// @param held         as in `chain_modes`; an asked inertia that is held has the angle 0
/// @throws InputError  as `torque_response` and `twist_response`
[[nodiscard]] std::vector<std::vector<std::complex<double>>> frequency_responses(
    const TorsionalChain& chain, std::span<const ChainPath> paths,
    std::span<const double> frequencies, std::span<const std::size_t> held = {});

/// Whether an amplitude is largest, or least near a zero.
enum class ExtremumKind { resonance, antiresonance };
template <>
struct EnumNames<ExtremumKind> {
  static constexpr std::array<std::string_view, 2> names = {"resonance", "antiresonance"};
};

/// A largest amplitude of a response, or a least one at which its phase rises: near a zero.
struct ResponseExtremum {
  ExtremumKind kind = ExtremumKind::resonance;  ///< which of the two it is
  double frequency = 0.0;                       ///< [Hz]
  /// |H| [as the response]; absent: infinite, a resonance without damping
  std::optional<double> amplitude = {};
  /// zeta by the half-power points (DY-13) [-]; 0 for an undamped resonance or antiresonance;
  /// absent if the response does not change by the factor sqrt(2) on both sides before the next
  /// extremum or the end of the range
  std::optional<double> damping_ratio = {};
};

/// Resonances and antiresonances of a response between two frequencies, by rising frequency.
///
/// Implements theory manual eq. (DY-13).  They are looked for at 200 frequencies in each decade and
/// at the natural frequencies, so a resonance and an antiresonance that lie closer together are
/// missed.
/// @param chain        inertias and springs, with numbers in their range
/// @param path         excitation and asked inertia; a loaded inertia is not held
/// @param from, to     [Hz]; 0 < from < to
/// @param held         as in `chain_modes`
/// @throws InputError  as `frequency_responses`, or if the range is out of order
[[nodiscard]] std::vector<ResponseExtremum> response_extrema(
    const TorsionalChain& chain, const ChainPath& path, double from, double to,
    std::span<const std::size_t> held = {});

/// Frequencies with the same ratio from one to the next [Hz].
/// @param from, to  [Hz]; 0 < from < to
/// @param points    [-]; >= 2
[[nodiscard]] std::vector<double> logarithmic_frequencies(double from, double to,
                                                          std::size_t points);

}  // namespace strainwave

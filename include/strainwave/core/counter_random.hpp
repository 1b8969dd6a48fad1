// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/special_functions/erf.hpp>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

/// @file
/// Random numbers that depend on their index, not on the order of calls.  The number of draw n and
/// input i is a function of (seed, n, i), so any thread may compute any of them.

namespace strainwave {

/// The finaliser of SplitMix64 (Steele, Lea and Flood): a bijection that leaves no pattern.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// Number n, from 0, of the sequence SplitMix64 begins with a seed.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t n) {
  return mixed(seed + (n + 1) * 0x9E3779B97F4A7C15U);
}

/// Uniform number in (0, 1) with both ends excluded.  The 52 random bits are offset by half a step.
[[nodiscard]] constexpr double counter_uniform(std::uint64_t seed, std::uint64_t draw,
                                               std::uint64_t input) {
  const std::uint64_t bits = splitmix64(splitmix64(seed, draw), input);
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;
}

/// Standard normal deviate, by the inverse of the distribution function.
[[nodiscard]] inline double counter_normal(std::uint64_t seed, std::uint64_t draw,
                                           std::uint64_t input) {
  const double u = counter_uniform(seed, draw, input);
  // In double throughout: long double takes three times as long for digits that are cut off.
  using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u, Double());
}

/// The standard normal deviates of all inputs of a draw.
/// @param seed     of the sequence
/// @param draw     number of the draw
/// @param normals  receives the deviates [-], shape (inputs)
inline void counter_normals(std::uint64_t seed, std::uint64_t draw, std::span<double> normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = counter_normal(seed, draw, i);
}

}  // namespace strainwave

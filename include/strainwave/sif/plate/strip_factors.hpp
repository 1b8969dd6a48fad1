// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/polynomial.hpp"
#include "strainwave/sif/plate/common.hpp"

/// @file
/// Factors K/(sigma sqrt(pi a)) of straight cracks across a long strip [-].  `x` is the relative
/// size of the crack, in [0, 1): depth over width of an edge crack, half length over half width of
/// a centre crack, depth over half width of two edge cracks.  The edge crack in tension and in
/// bending is `edge_crack_factor`.

namespace strainwave::sif {

/// Antiplane shear of an edge crack, a centre crack or two edge cracks, exact [-]; (SP-6).
[[nodiscard]] inline double strip_antiplane(double x) {
  return std::sqrt(tan_ratio(std::numbers::pi / 2 * x));  // (SP-6)
}

/// Centre crack in tension [-]; (SP-5).
[[nodiscard]] inline double strip_centre_tension(double x) {
  constexpr std::array kC = {1.0, -0.0213, 0.0437, 0.0333, -0.0206};
  return polynomial(kC, x * x) / std::sqrt(std::cos(std::numbers::pi / 2 * x));  // (SP-5)
}

/// Centre crack under a transverse force, given by its mean stress [-]; (SP-7).
[[nodiscard]] inline double strip_centre_shear(double x) {
  constexpr std::array kC = {1.5, -0.7498, 0.0589, -0.1846, 0.202};
  return polynomial(kC, x) / std::sqrt(1 - x);  // (SP-7)
}

/// Edge crack under a transverse force, given by its mean stress [-]; (SP-8).
[[nodiscard]] inline double strip_edge_shear(double x) {
  constexpr std::array kC = {4.0973, -5.2002, 0.8109, 3.2737, -3.36, 1.2056};
  return x * polynomial(kC, x) / std::sqrt(1 - x);  // (SP-8)
}

/// Two edge cracks in tension [-]; (SP-9).
[[nodiscard]] inline double strip_double_edge_tension(double x) {
  constexpr std::array kC = {1.1215, -0.5666, -0.7745, 2.8474, -3.9364, 2.6832, -0.7385};
  return polynomial(kC, x) / std::sqrt(1 - x);  // (SP-9)
}

/// Two edge cracks under a transverse force, given by its mean stress [-]; (SP-10).
[[nodiscard]] inline double strip_double_edge_shear(double x) {
  constexpr std::array kC = {2.0484, -1.8033, -0.0018, 0.8884, -0.6627, 0.1676};
  return x * polynomial(kC, x) / std::sqrt(1 - x);  // (SP-10)
}

/// Stack in tension, K/(sigma sqrt(h)); x = a/h in (0, infinity) [-]; (SP-14).
[[nodiscard]] inline double stack_tension(double x) {
  constexpr double kRate = 15.0;
  constexpr double kLinear = kRate - 2 * std::numbers::pi;  // K -> sigma sqrt(pi a) ...
  constexpr std::array kC = {1.0,
                             kLinear,
                             kRate * kLinear - kRate * kRate / 2,  // ... without a linear term
                             -81.81,
                             -507.87,
                             -521.83,
                             2796.94,
                             -7205.03,
                             5698.56};
  return std::sqrt((1 - std::exp(-kRate * x) * polynomial(kC, x)) / 2);  // (SP-14)
}

/// Stack in shear, K/(tau sqrt(h)); x = a/h in (0, infinity) [-]; (SP-15).
[[nodiscard]] inline double stack_shear(double x) {
  constexpr double kRate = 15.0;
  constexpr double kRoot = 0.143275;  // length over which a layer bends beyond the tip, over h
  constexpr std::array kC = {
      6 * kRoot * kRoot, 12 * kRoot + kRate * 6 * kRoot * kRoot - std::numbers::pi,
      -1.49055,          -10.4285,
      -29.8888,          66.5327};
  return std::sqrt(6 * (x + kRoot) * (x + kRoot) -
                   std::exp(-kRate * x) * polynomial(kC, x));  // (SP-15)
}

}  // namespace strainwave::sif

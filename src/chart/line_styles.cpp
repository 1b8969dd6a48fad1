// SPDX-License-Identifier: Apache-2.0
#include "line_styles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "strainwave/chart/chart.hpp"

namespace strainwave {
namespace {

struct Stroke {
  std::string_view colour;
  std::string_view dashes;
};
constexpr std::array<Stroke, kDistinctLines> kStrokes = {{{"#6E6E6E", ""},
                                                          {"#D55E00", ""},
                                                          {"#0072B2", "7 4"},
                                                          {"#009E73", "2 3"},
                                                          {"#CC79A7", "9 3 2 3"},
                                                          {"#AA7A00", "12 4"},
                                                          {"#8A63D2", "4 2"}}};

}  // namespace

std::string_view line_colour(std::size_t n) { return kStrokes[n % kStrokes.size()].colour; }

std::string line_dashes(std::size_t n) {
  std::string dashes(kStrokes[n % kStrokes.size()].dashes);
  for (std::size_t round = n / kStrokes.size(); round > 0; --round)
    dashes += dashes.empty() ? "16 3 1 3" : " 1 3";
  return dashes;
}

std::string_view bar_colour(std::size_t n) { return line_colour(n == 0 ? 2 : 1); }

std::string level_colour(double share) {
  constexpr std::array<std::array<double, 3>, 3> kColours = {
      {{0x00, 0x4C, 0x99}, {0x6A, 0x3D, 0x7C}, {0xB8, 0x3A, 0x00}}};
  const double at = 2 * std::clamp(share, 0.0, 1.0);
  const std::size_t low = at < 1 ? 0 : 1;
  const double part = at - static_cast<double>(low);
  std::string colour = "#";
  for (std::size_t c = 0; c < 3; ++c)
    colour += fmt::format("{:02X}", static_cast<int>(std::lround(kColours[low][c] * (1 - part) +
                                                                 kColours[low + 1][c] * part)));
  return colour;
}

}  // namespace strainwave

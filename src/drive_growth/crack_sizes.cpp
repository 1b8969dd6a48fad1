// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/crack_sizes.hpp"

#include <type_traits>
#include <variant>

namespace strainwave {

void set_crack_sizes(GearSet& gear, std::span<const CrackSize> sizes) {
  std::size_t index = 0;
  for_each_crack(gear, [&](const std::string&, auto& crack) {
    using Crack = std::decay_t<decltype(crack)>;
    const CrackSize& size = sizes[index++];
    if constexpr (ContactCrack<Crack>) {
      if constexpr (requires { crack.depth; })
        if (size.size > 0) crack.depth = size.size;
      return;
    }
    if constexpr (requires { crack.aspect_ratio; }) {
      crack.depth = size.size;
      crack.aspect_ratio = size.aspect_ratio;
    } else if constexpr (requires {
                           crack.depth;
                           crack.half_length;
                         }) {
      crack.depth = size.size;
      crack.half_length = size.half_length();
    } else if constexpr (requires { crack.half_length; }) {
      crack.half_length = size.size;
    } else if constexpr (requires { crack.depth; }) {
      crack.depth = size.size;
    }
  });
}

GearSet with_crack_sizes(const GearSet& gear, std::span<const CrackSize> sizes) {
  GearSet grown = gear;
  set_crack_sizes(grown, sizes);
  return grown;
}

bool break_through(GearSet& gear, std::size_t index) {
  bool broken = false;
  std::size_t at = 0;
  for_each_cracked_member(gear, [&](std::string_view, auto& member) {
    for (auto& crack : member.crack) {
      if (at++ != index) continue;
      using Variant = std::decay_t<decltype(crack)>;
      if constexpr (std::is_same_v<Variant, FlexsplineCrack>)
        if (const auto* const surface = std::get_if<WallSurfaceCrack>(&crack)) {
          crack = WallThroughCrack{.half_length = surface->half_length,  // (GR-26)
                                   .angle = surface->angle,
                                   .section = surface->section,
                                   .distance = surface->distance,
                                   .position = surface->position,
                                   .count = surface->count};
          broken = true;
        }
    }
  });
  return broken;
}

}  // namespace strainwave

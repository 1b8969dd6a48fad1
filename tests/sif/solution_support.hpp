// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/library.hpp"
#include "strainwave/sif/solution.hpp"

// Shared parts of the tests of the families.

namespace strainwave::test {

/// The limits of the validity range that a crack exceeds.
template <sif::Solution S>
std::vector<std::string> limits_broken(const S& crack) {
  std::vector<std::string> broken;
  crack.validity([&](bool inside, std::string_view text) {
    if (!inside) broken.emplace_back(text);
  });
  return broken;
}

/// The fields whose rule an impossible geometry breaks.
template <sif::Solution S>
std::vector<std::string> rules_broken(const S& crack) {
  std::vector<std::string> broken;
  crack.check([&](bool ok, std::string_view field, double, std::string_view, std::string_view) {
    if (!ok) broken.emplace_back(field);
  });
  return broken;
}

/// The library refuses these numbers and names the field.
inline void expect_refused(std::string_view name, const sif::Assignments& values,
                           std::string_view field) {
  try {
    (void)sif::solution(name).make(values);
    ADD_FAILURE() << name << " takes an impossible " << field;
  } catch (const InputError& error) {
    EXPECT_NE(std::string_view(error.what()).find(field), std::string_view::npos) << error.what();
  }
}

using Texts = std::vector<std::string>;

/// Unit moduli: compliance is int (2 k k) dA for modes I and II, int k k dA for mode III.
inline constexpr CrackModuli kUnitModuli{.opening = 1.0, .shear = 1.0};

}  // namespace strainwave::test

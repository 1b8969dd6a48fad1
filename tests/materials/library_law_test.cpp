// SPDX-License-Identifier: Apache-2.0
#include "strainwave/materials/library_law.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/materials/material_library.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

TEST(LibraryLaw, ReferenceStainlessSteel) {
  // The rates of rate_law_test.cpp, of a wall of 0.5 mm, from the record itself; and the toughness
  // of a part-through crack, 65 ksi sqrt(in).
  const MaterialRecord& record = require_material("15-5PH H900");
  const RateLaw wall = law_of_through_crack(rate_law(record), 0.5e-3, record.yield_strength->value);
  test::expect_relative(growth_rate(wall, {.largest = 6e6, .ratio = -1}, 1e-3).per_cycle,
                        5.21202457e-10, 1e-8);
  EXPECT_NEAR(std::get<Nasgro>(rate_law(record)).toughness, 71.42e6, 1e-3);
}

TEST(LibraryLaw, ReferenceTwoLinesOfGenericSteel) {
  const RateLaw law = rate_law(require_material("generic steel"));
  const TwoLines& lines = std::get<TwoLines>(law);
  EXPECT_EQ(lines.low().exponent, 5.10);
  EXPECT_EQ(lines.high().exponent, 2.88);
  // Both lines give the same rate where they meet, within the digits of the record.
  const TipCycle meets{.largest = lines.meet};
  test::expect_relative(lines.low().rate(meets), lines.high().rate(meets), 1e-3);
}

TEST(LibraryLaw, LimitOnePowerLaw) {
  MaterialRecord record = require_material("generic steel");
  record.growth.resize(1);
  EXPECT_TRUE(std::holds_alternative<Paris>(rate_law(record)));
  EXPECT_EQ(std::get<Paris>(rate_law(record)).coefficient,
            std::get<ParisLaw>(record.growth[0]).coefficient);
}

TEST(LibraryLaw, InputEachRuleBrokenOnce) {
  const auto message = [](const MaterialRecord& record) -> std::string {
    try {
      (void)rate_law(record);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  MaterialRecord record = require_material("15-5PH H900");
  EXPECT_EQ(message(record), "");
  EXPECT_THROW((void)law_of_through_crack(rate_law(record), 0.0, 1e9), InputError);
  EXPECT_THROW((void)law_of_through_crack(rate_law(record), 1e-3, {}), InputError);
  // A law without its own toughness over the thickness stays as it is, without a yield strength.
  EXPECT_EQ(std::get<Paris>(law_of_through_crack(Paris{1e-12, 3}, 1e-3, {})).exponent, 3);
  MaterialRecord two = require_material("generic steel");
  std::get<ParisLaw>(two.growth[1]).environment = "sea water";
  EXPECT_NE(message(two).find("several laws of growth"), std::string::npos);
  two = require_material("generic steel");
  two.growth.push_back(two.growth[0]);
  EXPECT_NE(message(two).find("several laws of growth"), std::string::npos);
  two.growth = {two.growth[0], record.growth[0]};
  EXPECT_NE(message(two).find("several laws of growth"), std::string::npos);
  record.growth.clear();
  EXPECT_NE(message(record).find("it has laws for 15-5PH H900"), std::string::npos)
      << message(record);
}

}  // namespace
}  // namespace strainwave

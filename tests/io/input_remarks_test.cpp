// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/input_remarks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/io/gear_reader.hpp"

namespace strainwave {
namespace {

using Remarks = std::map<std::string, InputRemark>;

TEST(InputRemarks, ReferenceValuesAsWrittenAndTheirComments) {
  const Remarks remarks = input_remarks(
      "# Head of the file.\n"
      "\n"
      "[material.steel]\n"
      "youngs_modulus = \"210 GPa\"  # mill certificate\n"
      "poissons_ratio = 0.30\n"
      "# two lines above:\n"
      "#   both count\n"
      "name = 'a # that is no comment'   # µ: this one is\n"
      "[drive]\n"
      "  ratio = 100\n"
      "flag = true\n"
      "pair = [\"5 mm\",   # first\n"
      "        \"2 mm\"]   # both\n"
      "[[crack]]\n"
      "depth = \"1 mm\" # the first\n"
      "# of the second\n"
      "[[crack]]\n"
      "depth = \"2 mm\"\r\n"
      "inline = { radius = \"3 mm\", n = 2 } # a table\n");
  const auto expect = [&](const char* path, const char* written, const char* comment) {
    const auto found = remarks.find(path);
    ASSERT_NE(found, remarks.end()) << path;
    EXPECT_EQ(found->second.written, written) << path;
    EXPECT_EQ(found->second.comment, comment) << path;
  };
  expect("material.steel.youngs_modulus", "210 GPa", "mill certificate");
  expect("material.steel.poissons_ratio", "0.3", "");
  expect("material.steel.name", "a # that is no comment", "µ: this one is");
  expect("drive.ratio", "100", "");
  expect("drive.flag", "true", "");
  expect("drive.pair", "5 mm, 2 mm", "both");
  expect("crack[0].depth", "1 mm", "the first");
  expect("crack[1].depth", "2 mm", "");
  expect("crack[1].inline.radius", "3 mm", "a table");
  expect("crack[1].inline.n", "2", "a table");
  EXPECT_FALSE(remarks.contains("crack"));
  EXPECT_FALSE(remarks.contains("drive"));
}

TEST(InputRemarks, ReferenceTheCommentAboveCountsWhereThereIsNoneBeside) {
  const Remarks remarks = input_remarks(
      "# of another\n"
      "\n"
      "# typical: first\n"
      "# and second line\n"
      "ratio = 100\n"
      "torque = \"1 N*m\"\n"
      "# above\n"
      "force = \"1 N\"  # beside\n");
  EXPECT_EQ(remarks.at("ratio").comment, "typical: first and second line");
  EXPECT_EQ(remarks.at("torque").comment, "");
  EXPECT_EQ(remarks.at("force").comment, "beside");
}

// The remarks contain every number that the reader found in a file.
TEST(InputRemarks, CrosscheckWithTheReader) {
  for (const auto& file : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES)) {
    if (file.path().extension() != ".toml") continue;
    std::ifstream stream(file.path());
    const std::string text((std::istreambuf_iterator<char>(stream)),
                           std::istreambuf_iterator<char>());
    const Remarks remarks = input_remarks(text);
    const GearSet gear = read_gear_set(text, "drive.toml", attachments_beside(file.path()));
    std::size_t known = 0;
    for_each_number(gear, [&](const FieldPath& path, const Field& field, double value) {
      const auto found = remarks.find(path.text());
      if (found == remarks.end()) {
        // The element of a list, a default, or a number of a material of the library.
        const bool library = std::ranges::any_of(gear.material, [&](const auto& named) {
          return !named.second.origin.empty() && path.text().starts_with("material." + named.first);
        });
        // A crack of a group, which the table of the first one gives.
        const bool grouped = std::ranges::any_of(gear.placed_groups, [&](const PlacedGroup& group) {
          for (std::size_t i = 1; i < group.count; ++i)
            if (path.text().starts_with(std::string(group.crack(i)))) return true;
          return false;
        });
        EXPECT_TRUE(library || grouped || !field.fallback.empty() || path.text().ends_with(']'))
            << path.text();
        return;
      }
      ++known;
      EXPECT_EQ(field.unit == "1" ? std::stod(found->second.written)
                                  : parse_quantity("x", found->second.written, field.unit),
                value)
          << path.text();
    });
    EXPECT_GT(known, 5U) << file.path();
  }
}

TEST(InputRemarks, InputThatIsNoTomlIsRefused) {
  EXPECT_THROW((void)input_remarks("ratio = = 1"), InputError);
  EXPECT_TRUE(input_remarks("").empty());
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// Groups of cracks in a file: what is read, written, edited and said.
#include "strainwave/model/input/placed_group.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/edit.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/gear_writer.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kGroupedShaft = R"(format = "strainwave-drive/1"

[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3

[drive]
ratio = 100
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"

[load]
torque = "1.5 kN*m"

[output_shaft]
material = "steel"
outer_diameter = "60 mm"
length = "300 mm"

[[output_shaft.crack]]
kind = "annular"
depth = "6 mm"
PLACES

[[output_shaft.crack]]
kind = "annular"
depth = "2 mm"
)";

/// The file with other lines for the places of its group, and more lines at its end.
std::string grouped_text(std::string_view places, std::string_view more = "") {
  std::string text(kGroupedShaft);
  text.replace(text.find("PLACES"), 6, places);
  return text.append(more);
}

std::string group_refusal(const std::string& text) {
  try {
    (void)read_gear_set(text, "gear.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

constexpr std::string_view kInspected = R"(
[inspection]
a50 = "1 mm"
a90 = "2 mm"
[[inspection.place]]
crack = "output_shaft.crack[3]"
)";

// Kind: identity.  The text that the writer gives is that of the same cracks one by one, for places
// by a list and by a pitch (sums without rounding), and it reads back as the same drive to the last
// bit.
TEST(GroupsInAFile, IdentityWrittenOneByOne) {
  const auto text_of = [](const std::string& text) {
    return gear_text(read_gear_set(text, "gear.toml"));
  };
  const auto singles = [](std::string_view first, std::string_view second, std::string_view third) {
    std::string text = grouped_text("distance = \"" + std::string(first) + '"');
    for (const std::string_view place : {second, third})
      text += "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"6 mm\"\ndistance = \"" +
              std::string(place) + "\"\n";
    return text;
  };
  const std::string listed =
      text_of(grouped_text(R"(positions = ["140 mm", "145.3 mm", "5.9 in"])"));
  EXPECT_EQ(listed, text_of(singles("140 mm", "145.3 mm", "5.9 in")));
  EXPECT_EQ(listed, text_of(listed));
  const std::string stepped =
      text_of(grouped_text("distance = \"0.125 m\"\ncount = 3\npitch = \"0.03125 m\""));
  EXPECT_EQ(stepped, text_of(singles("0.125 m", "0.15625 m", "0.1875 m")));
  EXPECT_EQ(stepped, text_of(stepped));
}

// A fault of a crack of a group points to its table, and says which crack of the table it is.
TEST(GroupsInAFile, InputFaultsPointToTheTable) {
  EXPECT_EQ(
      group_refusal(grouped_text("distance = \"140 mm\"\ncount = 3\npitch = \"100 mm\"")),
      "gear.toml:23:12: output_shaft.crack[3].distance = 0.34 m violates: distance < length of "
      "the shaft; output_shaft.crack[3] is crack 3/3 of the table output_shaft.crack[0]");
  EXPECT_EQ(group_refusal(grouped_text(R"(positions = ["140 mm", "-1 mm"])")),
            "gear.toml:20:1: output_shaft.crack[2].distance = -0.001 m violates: > 0; "
            "output_shaft.crack[2] is crack 2/2 of the table output_shaft.crack[0]");
  EXPECT_EQ(group_refusal(grouped_text(R"(positions = ["140 mm", "140 mm"])")),
            "gear.toml:23:24: output_shaft.crack[0].positions[1] = \"140 mm\" violates: a place of "
            "its own, but positions[0] is the same");
  EXPECT_EQ(group_refusal(grouped_text(R"(positions = ["140 mm", "1 deg"])")),
            "gear.toml:23:24: output_shaft.crack[0].positions[1]: \"1 deg\" is not convertible to "
            "m");
  EXPECT_EQ(group_refusal(grouped_text("positions = []")),
            "gear.toml:23:13: output_shaft.crack[0].positions: is an empty list; give at least one "
            "value, such as [\"12 mm\", \"20 mm\"], or leave positions out");
  EXPECT_EQ(group_refusal(grouped_text("distance = \"140 mm\"\ncount = 3\npitch = \"5 deg\"")),
            "gear.toml:25:9: output_shaft.crack[0].pitch: \"5 deg\" is not convertible to m");
  EXPECT_EQ(group_refusal(grouped_text("distance = \"140 mm\"\npitch = \"5 mm\"")),
            "gear.toml:24:9: output_shaft.crack[0].pitch: must be given with count, the number of "
            "cracks, 2 or more");
}

// A later fault of a computation has the place of the table too.
TEST(GroupsInAFile, BehaviourALaterFaultHasThePlaceOfTheTable) {
  const std::string text = grouped_text(R"(positions = ["140 mm", "145 mm"])");
  const InputError fault = located(
      InputError("output_shaft.crack[2].depth", 6e-3, "m", "depth < 5 mm"), text, "gear.toml");
  EXPECT_STREQ(fault.what(),
               "gear.toml:22:9: output_shaft.crack[2].depth = 0.006 m violates: depth < 5 mm; "
               "output_shaft.crack[2] is crack 2/2 of the table output_shaft.crack[0]");
  EXPECT_EQ(fault.place().line, 22U);
  EXPECT_EQ(fault.value(), "0.006 m");
}

// The text of a group has one line for all of its cracks, so the numbers of one crack of them
// cannot be set in it.
TEST(GroupsInAFile, InputNumbersOfOneCrackOfAGroup) {
  const std::string text = grouped_text(R"(positions = ["140 mm", "145 mm"])");
  const GearSet from = read_gear_set(text, "gear.toml");
  for (const char* const path : {"output_shaft.crack[0].depth", "output_shaft.crack[2].depth"}) {
    GearSet to = from;
    set_number(to, path, 5e-3);
    try {
      (void)with_numbers_of(text, from, to);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), std::string(path) +
                                  ": is a number of one of 2 cracks that output_shaft.crack[0] "
                                  "gives; give each crack a table of its own first");
    }
  }
  GearSet to = from;
  set_number(to, "output_shaft.crack[1].depth", 3e-3);
  EXPECT_NE(with_numbers_of(text, from, to).find("depth = \"3 mm\""), std::string::npos);
}

// A change of the text that moves the cracks behind the tables is refused while an entry names one
// of them.
TEST(GroupsInAFile, InputChangesThatMoveNamedCracks) {
  const std::string text =
      grouped_text(R"(positions = ["140 mm", "145 mm", "150 mm"])", kInspected);
  EXPECT_EQ(group_refusal(text), "accepted");
  const auto refused = [](const std::string& of, std::string_view path,
                          const std::optional<std::string>& value) {
    try {
      (void)edit(of, path, value);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string why =
      ": moves output_shaft.crack[3], which inspection.place[0].crack names and a group gives; "
      "remove that entry first, and add it with the new number of the crack";
  for (const auto& [path, value] : std::vector<std::pair<std::string, std::optional<std::string>>>{
           {"output_shaft.crack[1]", std::nullopt},
           {"output_shaft.crack[0].positions", R"(["140 mm", "145 mm"])"},
           {"output_shaft.crack[0].count", "3"},
           {"output_shaft", std::nullopt}})
    EXPECT_EQ(refused(text, path, value), path + why);
  EXPECT_EQ(refused(text, "output_shaft.crack[+]", "{kind = \"annular\", depth = \"1 mm\"}"),
            "output_shaft.crack[2]" + why);
  EXPECT_EQ(refused(text, "output_shaft.crack[0].depth", "\"5 mm\""), "accepted");
  // An entry that names a table follows it, as before.
  std::string of_table = text;
  of_table.replace(of_table.find("crack[3]"), 8, "crack[1]");
  EXPECT_NE(edit(of_table, "output_shaft.crack[0]", std::nullopt)
                .find("crack = \"output_shaft.crack[0]\""),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave

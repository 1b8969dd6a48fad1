// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/edit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/io/input_remarks.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kShaft = R"(# Head of the file.
format = "strainwave-drive/1"
name   =   'µ, a # that is no comment'   # beside

[drive]
ratio = 100
pitch_diameter = "160 mm" # as measured

# The shaft.
[output_shaft]
material = "steel"
length = "200 mm"

# The first crack.
[[output_shaft.crack]]
kind = "annular"
depth = "3 mm"      # by ultrasound
# of the second
[[output_shaft.crack]]   # beside
kind = "annular"
depth = "4 mm"
# the last line of the second

[material."40 Cr"]
youngs_modulus = "210 GPa"
)";

std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string edit_refusal(std::string_view text, std::string_view path,
                         const std::optional<std::string>& value) {
  try {
    return "accepted: " + edit(text, path, value);
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Expects that `edit` changes the text of the shaft by replacing one piece of text.
void expect_change(std::string_view path, const std::optional<std::string>& value,
                   const std::string& from, const std::string& to) {
  EXPECT_EQ(edit(kShaft, path, value), replaced_once(std::string(kShaft), from, to)) << path;
  // Every kind of line end, and a file without a final line end.
  const auto with_crlf = [](std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return result;
  };
  EXPECT_EQ(edit(with_crlf(kShaft), path, value),
            with_crlf(replaced_once(std::string(kShaft), from, to)))
      << path;
}

TEST(Edit, ReferenceAValueIsReplaced) {
  expect_change("output_shaft.crack[0].depth", "\"5 mm\"", "\"3 mm\"", "\"5 mm\"");
  expect_change("drive.ratio", "  80.5 # not taken over", "ratio = 100", "ratio = 80.5");
  expect_change("name", "\"\"\"a\"b\"\"\"", "'µ, a # that is no comment'", "\"\"\"a\"b\"\"\"");
  for (const std::string_view path :
       {"material.40 Cr.youngs_modulus", "material.\"40 Cr\".youngs_modulus",
        "material.'40 Cr'.youngs_modulus"})
    expect_change(path, "\"2 Pa\"", "\"210 GPa\"", "\"2 Pa\"");
}

TEST(Edit, BehaviourTheSameValueKeepsItsSpelling) {
  for (const auto& [path, value] : std::map<std::string, std::string>{
           {"name", "\"µ, a # that is no comment\""},
           {"drive.ratio", "1_00"},
           {"output_shaft.crack[1]", "{ depth = '4 mm', kind = 'annular' }"},
           {"drive", "pitch_diameter = \"160 mm\"\nratio = 100"}})
    EXPECT_EQ(edit(kShaft, path, value), kShaft) << path;
}

TEST(Edit, ReferenceAFieldIsInsertedInTheOrderOfTheDescription) {
  expect_change("output_shaft.outer_diameter", "\"70 mm\"", "material = \"steel\"\n",
                "material = \"steel\"\nouter_diameter = \"70 mm\"\n");
  expect_change("drive.wave_number", "2", "ratio = 100\n", "ratio = 100\nwave_number = 2\n");
  expect_change("output_shaft.crack[0].solution", "\"tada\"", "# by ultrasound\n",
                "# by ultrasound\nsolution = \"tada\"\n");
  // Insertion after the last line of a file without a final line end.
  EXPECT_EQ(edit("[drive]\nratio = 1", "drive.wave_number", "2"),
            "[drive]\nratio = 1\nwave_number = 2");
  EXPECT_EQ(edit("[drive]", "drive.ratio", "2"), "[drive]\nratio = 2");
  EXPECT_EQ(edit("", "name", "\"x\""), "name = \"x\"\n");
  EXPECT_EQ(edit("[drive]\n", "name", "\"x\""), "name = \"x\"\n[drive]\n");
  // Indentation is taken from the line above.
  EXPECT_EQ(edit("[drive]\n  ratio = 1\n", "drive.wave_number", "2"),
            "[drive]\n  ratio = 1\n  wave_number = 2\n");
}

TEST(Edit, ReferenceAMaterialOfTheLibraryIsCompleted) {
  const std::string based = edit("", "material.own.based_on", "\"40CrNiMoA QT\"");
  EXPECT_EQ(edit(based, "material.own.fracture_toughness", "\"90 MPa*m^0.5\""),
            "[material.own]\nbased_on = \"40CrNiMoA QT\"\nfracture_toughness = \"90 MPa*m^0.5\"\n");
}

TEST(Edit, ReferenceAMissingTableIsMade) {
  expect_change("load.torque", "\"1 N*m\"", "# as measured\n\n",
                "# as measured\n\n[load]\ntorque = \"1 N*m\"\n\n");
  expect_change("wave_generator.contact_semi_axes[0]", "\"5 mm\"", "# as measured\n\n",
                "# as measured\n\n[wave_generator]\ncontact_semi_axes = [\"5 mm\"]\n\n");
  expect_change("rating", "{ T1 = \"1 N*m\", T2 = \"2 N*m\" }", "# the last line of the second\n\n",
                "# the last line of the second\n\n[rating]\nT1 = \"1 N*m\"\nT2 = \"2 N*m\"\n\n");
  expect_change("flexspline.diaphragm.profile[+].radius", "\"1 mm\"", "# as measured\n\n",
                "# as measured\n\n[[flexspline.diaphragm.profile]]\nradius = \"1 mm\"\n\n");
  // A table that is only implied by its subtables gets a header.
  EXPECT_EQ(edit("[flexspline.rim]\nlength = \"1 m\"\n", "flexspline.length", "\"2 m\""),
            "[flexspline.rim]\nlength = \"1 m\"\n\n[flexspline]\nlength = \"2 m\"\n");
}

TEST(Edit, ReferenceACrackIsAppendedAndRemoved) {
  const std::string added = "\n[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"5 mm\"\n";
  const std::string last = "# the last line of the second\n";
  for (const std::string_view path : {"output_shaft.crack[+]", "output_shaft.crack[2]"})
    for (const std::string value : {"{ kind = \"annular\", depth = \"5 mm\" }",
                                    "kind = \"annular\" # a\ndepth = \"5 mm\"\n"}) {
      expect_change(path, value, last, last + added);
      EXPECT_EQ(edit(edit(kShaft, path, value), "output_shaft.crack[2]", std::nullopt), kShaft);
    }
  expect_change("output_shaft.crack[0]", std::nullopt,
                "# The first crack.\n[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"3 mm\" "
                "     # by ultrasound\n",
                "");
  expect_change("output_shaft.crack[1]", std::nullopt,
                "[[output_shaft.crack]]   # beside\nkind = \"annular\"\ndepth = \"4 mm\"\n# the "
                "last line of the second\n\n",
                "");
  // A replaced array keeps the lines of the elements that stay.
  expect_change("output_shaft.crack", "[{ kind = \"annular\", depth = \"3 mm\" }]",
                "[[output_shaft.crack]]   # beside\nkind = \"annular\"\ndepth = \"4 mm\"\n# the "
                "last line of the second\n\n",
                "");
}

TEST(Edit, ReferencePathsFollowTheirCracks) {
  // Ranges and scatters of a removed crack are removed too; those of the next crack get its new
  // path.
  const std::string first =
      "\n[[range]]\npath = \"output_shaft.crack[0].depth\"\nlower = \"2 mm\"\nupper = \"4 mm\"\n";
  const std::string length = "\n[[range]]\npath = \"output_shaft.length\"\nlower = \"1 mm\"\n";
  const auto second = [](const std::string& index) {
    return "\n[[scatter]]\npath = \"output_shaft.crack[" + index + "].depth\"   # by ultrasound\n";
  };
  const std::string scatters = "\n[[scatter]]\npath = \"output_shaft.crack[0].depth\"\n";
  const std::string text = std::string(kShaft) + first + length + scatters + second("1");
  EXPECT_EQ(edit(text, "output_shaft.crack[0]", std::nullopt),
            edit(kShaft, "output_shaft.crack[0]", std::nullopt) + length + second("0"));
  EXPECT_EQ(edit(text, "output_shaft.crack[1]", std::nullopt),
            edit(kShaft, "output_shaft.crack[1]", std::nullopt) + first + length + scatters);
  EXPECT_EQ(edit(text, "output_shaft.crack", std::nullopt),
            edit(kShaft, "output_shaft.crack", std::nullopt) + length);
  EXPECT_EQ(edit(text, "output_shaft", std::nullopt), edit(kShaft, "output_shaft", std::nullopt));
  // A crack of another kind has other numbers.
  const std::string other = "{ kind = \"annular\", solution = \"tada\" }";
  EXPECT_EQ(edit(text, "output_shaft.crack[1]", other),
            edit(kShaft, "output_shaft.crack[1]", other) + first + length + scatters);
  // An inline list is adapted as well; entries that name nothing in the text stay unchanged.
  const std::string inline_list =
      "scatter = [{ path = \"flexspline.crack[1].depth\" }, { path = \"no such thing\" }, 3]\n"
      "[[flexspline.crack]]\ndepth = 1\n[[flexspline.crack]]\ndepth = 2\n";
  EXPECT_EQ(
      edit(inline_list, "flexspline.crack[0]", std::nullopt),
      "scatter = [{ path = \"flexspline.crack[0].depth\" }, { path = \"no such thing\" }, 3]\n"
      "[[flexspline.crack]]\ndepth = 2\n");
}

TEST(Edit, ReferenceCorrelationsFollowTheirCracks) {
  const auto correlation = [](const std::string& path, const std::string& with) {
    return "\n[[correlation]]\npath = \"" + path + "\"\nwith = \"" + with + "\"\n";
  };
  const auto depth = [](int crack) {
    return "output_shaft.crack[" + std::to_string(crack) + "].depth";
  };
  const std::string text = std::string(kShaft) + correlation("output_shaft.length", depth(1)) +
                           correlation(depth(0), "output_shaft.length") +
                           correlation(depth(1), depth(1)) + correlation(depth(1), depth(0));
  EXPECT_EQ(edit(text, "output_shaft.crack[0]", std::nullopt),
            edit(kShaft, "output_shaft.crack[0]", std::nullopt) +
                correlation("output_shaft.length", depth(0)) + correlation(depth(0), depth(0)));
  EXPECT_EQ(edit(text, "output_shaft.crack[1]", std::nullopt),
            edit(kShaft, "output_shaft.crack[1]", std::nullopt) +
                correlation(depth(0), "output_shaft.length"));
}

TEST(Edit, ReferenceInspectedPlacesFollowTheirCracks) {
  const auto place = [](int crack) {
    return "\n[[inspection.place]]\ncrack = \"output_shaft.crack[" + std::to_string(crack) +
           "]\"\n";
  };
  const std::string head = "\n[inspection]\na50 = \"1 mm\"\na90 = \"2 mm\"\n";
  const std::string text = std::string(kShaft) + head + place(1) + place(0);
  EXPECT_EQ(edit(text, "output_shaft.crack[0]", std::nullopt),
            edit(kShaft, "output_shaft.crack[0]", std::nullopt) + head + place(0));
  EXPECT_EQ(edit(text, "output_shaft.crack[1]", std::nullopt),
            edit(kShaft, "output_shaft.crack[1]", std::nullopt) + head + place(0));
  // Without its last place the inspection would see all cracks, so it leaves with it.
  const std::string cost = "\n[inspection.cost]\ncall = 300\n";
  const std::string one = std::string(kShaft) + head + cost + place(1);
  EXPECT_EQ(edit(one, "output_shaft.crack[1]", std::nullopt),
            edit(kShaft, "output_shaft.crack[1]", std::nullopt));
  EXPECT_EQ(edit(one, "inspection.place[0]", std::nullopt), std::string(kShaft) + head + cost);
}

TEST(Edit, ReferenceWhatIsRemovedTakesItsComment) {
  expect_change("drive.pitch_diameter", std::nullopt, "pitch_diameter = \"160 mm\" # as measured\n",
                "");
  expect_change("name", std::nullopt, "name   =   'µ, a # that is no comment'   # beside\n", "");
  EXPECT_EQ(edit("[drive]\nratio = 1\n# above\nwave_number = 2\n# below\n", "drive.wave_number",
                 std::nullopt),
            "[drive]\nratio = 1\n# below\n");
  // The comment at the head of the file stays.
  expect_change("format", std::nullopt, "format = \"strainwave-drive/1\"\n", "");
  EXPECT_EQ(edit(kShaft, "material", std::nullopt),
            std::string(kShaft.substr(0, kShaft.find("\n[material"))));
}

TEST(Edit, ReferenceInlineTablesAndLists) {
  const std::string text =
      "drive = { ratio = 100, pitch_diameter = \"1 m\" } # beside\n"
      "output_shaft = { crack = [{ kind = \"annular\" }, { kind = \"annular\", depth = \"1 m\" }] "
      "}\n"
      "rating = {}\n"
      "[wave_generator]\n"
      "contact_semi_axes = [ \"5 mm\", # first\n"
      "  \"2 mm\" ]\n"
      "crack = [\n"
      "  # above\n"
      "  { kind = \"edge\" },  # one\n"
      "  { kind = \"surface\" }   # two\n"
      "]\n";
  const auto change = [&](std::string_view path, const std::optional<std::string>& value,
                          const std::string& from, const std::string& to) {
    EXPECT_EQ(edit(text, path, value), replaced_once(text, from, to)) << path;
  };
  change("drive.ratio", "50", "= 100", "= 50");
  change("drive.ratio", std::nullopt, "ratio = 100, ", "");
  change("drive.pitch_diameter", std::nullopt, ", pitch_diameter = \"1 m\"", "");
  change("drive.wave_number", "2", "\"1 m\" } #", "\"1 m\", wave_number = 2 } #");
  change("output_shaft.crack[0].depth", "\"2 m\"", "{ kind = \"annular\" }",
         "{ kind = \"annular\", depth = \"2 m\" }");
  change("output_shaft.crack[+]", "kind = \"annular\"", "\"1 m\" }] }",
         "\"1 m\" }, { kind = \"annular\" }] }");
  change("output_shaft.crack[+].depth", "\"3 m\"", "\"1 m\" }] }",
         "\"1 m\" }, { depth = \"3 m\" }] }");
  change("output_shaft.crack[0]", std::nullopt, "{ kind = \"annular\" }, ", "");
  change("output_shaft.crack[1]", std::nullopt, ", { kind = \"annular\", depth = \"1 m\" }", "");
  change("rating.T1", "\"1 N*m\"", "rating = {}", "rating = { T1 = \"1 N*m\" }");
  change("wave_generator.contact_semi_axes[0]", "\"4 mm\"", "5 mm", "4 mm");
  change("wave_generator.contact_semi_axes[1]", "\"4 mm\"", "2 mm", "4 mm");
  change("wave_generator.crack[+]", "kind = \"edge\"", "\"surface\" }   # two\n",
         "\"surface\" },   # two\n  { kind = \"edge\" }\n");
  change("wave_generator.crack[0]", std::nullopt, "  { kind = \"edge\" },  # one\n", "");
  change("wave_generator.crack[1]", std::nullopt, "  { kind = \"surface\" }   # two\n", "");
  change("wave_generator.bearing.ball_diameter", "\"7 mm\"", "# two\n]\n",
         "# two\n]\n\n[wave_generator.bearing]\nball_diameter = \"7 mm\"\n");
}

TEST(Edit, ReferenceDottedKeys) {
  const std::string text =
      "drive.ratio = 100 # a\ndrive.wave_number = 2\n[flexspline]\n"
      "rim.length = \"1 m\"\nboss = { }\n";
  EXPECT_EQ(edit(text, "drive.ratio", "5"), replaced_once(text, "100", "5"));
  EXPECT_EQ(edit(text, "drive.pitch_diameter", "\"1 m\""),
            replaced_once(text, "number = 2\n", "number = 2\ndrive.pitch_diameter = \"1 m\"\n"));
  EXPECT_EQ(edit(text, "flexspline.rim.wall_thickness", "\"1 m\""),
            replaced_once(text, "rim.length = \"1 m\"\n",
                          "rim.length = \"1 m\"\nrim.wall_thickness = \"1 m\"\n"));
  EXPECT_EQ(edit(text, "drive", std::nullopt),
            replaced_once(text, "drive.ratio = 100 # a\ndrive.wave_number = 2\n", ""));
  EXPECT_EQ(edit(text, "drive", "ratio = 7"),
            replaced_once(replaced_once(text, "100", "7"), "drive.wave_number = 2\n", ""));
  // Tables of tables, in each of the forms.
  EXPECT_EQ(edit(text, "flexspline", "rim.length = \"1 m\"\nrim.wall_thickness = \"2 m\"\nboss={}"),
            replaced_once(text, "rim.length = \"1 m\"\n",
                          "rim.length = \"1 m\"\nrim.wall_thickness = \"2 m\"\n"));
}

TEST(Edit, InputRefusedPathsNameTheNearest) {
  const std::string one = "\"1\"";
  for (const auto& [path, message] : std::map<std::string, std::string>{
           {"output_shaft.crack[0].dept",
            "output_shaft.crack[0].dept: is not known here; did you mean "
            "output_shaft.crack[0].depth?"},
           {"output_shft", "output_shft: is not known here; did you mean output_shaft?"},
           {"drive.zzzzzz",
            "drive.zzzzzz: is not known here; known names are ratio, wave_number, pitch_diameter, "
            "radial_displacement"},
           {"material.40 Cr.youngs_modulu",
            "material.40 Cr.youngs_modulu: is not known here; did you mean material.40 "
            "Cr.youngs_modulus?"},
           {"", "path: is empty; it must name a field"},
           {"drive.ratio.x", "drive.ratio.x: goes too deep: drive.ratio has nothing below it"},
           {"output_shaft.crack.depth",
            "output_shaft.crack.depth: needs an index after output_shaft.crack, such as [0] or "
            "[+]"},
           {"output_shaft.crack[x]",
            "output_shaft.crack[x]: has the index [x]; it must be a whole number or +"},
           {"output_shaft.crack[0]depth",
            "output_shaft.crack[0]depth: needs . and a key after output_shaft.crack[0]"},
           {"output_shaft.crack[3]", "output_shaft.crack: has 2 elements; the next is [2] or [+]"},
           {"material.\"x.y", "material.\"x.y: has a quote that is not closed"},
           {"wave_generator.contact_semi_axes[2]",
            "wave_generator.contact_semi_axes[2]: has two elements, [0] and [1]"}})
    EXPECT_EQ(edit_refusal(kShaft, path, one), message);
}

TEST(Edit, InputFaults) {
  EXPECT_EQ(edit_refusal(kShaft, "load", std::nullopt),
            "load: is not in the text, so it cannot be removed");
  EXPECT_EQ(edit_refusal("drive = 3", "drive.ratio", "1"), "drive: is 3, not a table");
  EXPECT_EQ(edit_refusal("drive = 3", "drive", ""),
            "value: must be one value, or the fields of one table");
  for (const std::string value :
       {"1\n[load]\ntorque = 2", "1\nx = 2", "ratio = 1\n[x]", "1 2", "\"", "]", "1, 2"})
    EXPECT_TRUE(edit_refusal(kShaft, "drive.ratio", value).starts_with("value")) << value;
  EXPECT_TRUE(edit_refusal("a = ", "name", "1").starts_with("text:1:"));
  EXPECT_EQ(edit_refusal(std::string(kMaxTextSize + 1, '\n'), "name", "1"),
            "text: is larger than 1 MiB");
  EXPECT_EQ(edit_refusal("", "name", std::string(kMaxTextSize + 1, '1')),
            "value: is larger than 1 MiB");
}

std::string example_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The value of a field as TOML, as text or bare, whichever leaves the document unchanged.
std::string own_value(const std::string& text, const std::string& path,
                      const std::string& written) {
  const std::string quoted = "'''" + written + "'''";
  return edit(text, path, quoted) == text ? quoted : written;
}

/// The comments, each line by itself.
std::vector<std::string> comments_of(const std::string& text) {
  std::vector<std::string> comments;
  for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at + 1)) {
    comments.push_back(text.substr(at, text.find('\n', at) - at));
    at = std::min(text.find('\n', at), text.size() - 1);
  }
  return comments;
}

TEST(Edit, BehaviourEveryFieldOfEveryExample) {
  std::size_t seen = 0;
  std::size_t n = 0;
  for (const auto& file : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES)) {
    if (file.path().extension() != ".toml") continue;
    const std::string text = example_text(file.path());
    const auto before = input_remarks(text);
    for (const auto& [path, remark] : before) {
      SCOPED_TRACE(file.path().filename().string() + " " + path);
      if (before.contains(path + "[0]")) continue;  // its elements are tested
      if (test::kSanitized && ++seen % 5 != 0) continue;
      ++n;
      const std::string own = own_value(text, path, remark.written);
      EXPECT_EQ(edit(text, path, own), text);
      // Another value: one line differs, and it reads back.
      const std::string other = edit(text, path, "\"another\"");
      EXPECT_EQ(std::ranges::count(other, '\n'), std::ranges::count(text, '\n'));
      EXPECT_EQ(comments_of(other), comments_of(text));
      auto after = input_remarks(other);
      EXPECT_EQ(after.at(path).written, "another");
      for (const auto& [at, kept] : before) {
        if (at != path && !path.starts_with(at + "[")) {
          EXPECT_EQ(after.at(at).written, kept.written);
        }
      }
      // Removed and inserted again.
      if (path.ends_with(']')) continue;
      const std::string shorter = edit(text, path, std::nullopt);
      EXPECT_FALSE(input_remarks(shorter).contains(path));
      const std::string again = edit(shorter, path, own);
      after = input_remarks(again);
      for (const auto& [at, kept] : before) EXPECT_EQ(after.at(at).written, kept.written) << at;
    }
  }
  EXPECT_GT(n, test::kSanitized ? 100U : 300U);
}

TEST(Edit, CrosscheckTheReaderSeesTheChange) {
  const std::filesystem::path file = STRAINWAVE_EXAMPLES "/cracked_size25.toml";
  const std::string text = example_text(file);
  const GearSet gear = read_gear_set(text, "drive");
  for_each_number(gear, [&](const FieldPath& path, const Field& field, double value) {
    // Changing one dimension alone may break a rule between dimensions.
    if (path.text().find("crack[") == std::string::npos && !path.text().starts_with("rating"))
      return;
    const double wanted = value * (1 - 1e-9);
    const std::string number = fmt::format("{}", wanted);
    const std::string right =
        field.unit == "1" ? number : fmt::format("\"{} {}\"", number, field.unit);
    const GearSet read = read_gear_set(edit(text, path.text(), right), "drive");
    for_each_number(read, [&](const FieldPath& at, const Field&, double found) {
      if (at.text() == path.text()) {
        EXPECT_EQ(found, wanted) << at.text();
      }
    });
  });
  // After removal of each crack, beginning with the last, the drive can be read and the rest is
  // unchanged.
  std::string less = text;
  for (const auto& [member, count] : std::map<std::string, int>{{"wave_generator", 2},
                                                                {"flexspline", 4},
                                                                {"mesh", 1},
                                                                {"circular_spline", 1},
                                                                {"output_shaft", 1}})
    for (int i = count; i-- > 0;) {
      less = edit(less, fmt::format("{}.crack[{}]", member, i), std::nullopt);
      (void)read_gear_set(less, "drive");
    }
  EXPECT_EQ(less.find("crack]]"), std::string::npos);
  EXPECT_NE(less.find("outer_diameter = \"62.801 mm\"            # at the tooth roots"),
            std::string::npos);
}

TEST(Edit, ReferenceStringsOfSeveralLinesAndQuotedKeys) {
  // A byte order mark and strings of several lines.
  EXPECT_EQ(
      edit("\xEF\xBB\xBFname = '''a\n[drive]\n# b'''\n[drive]\nratio = 1\n", "drive.ratio", "2"),
      "\xEF\xBB\xBFname = '''a\n[drive]\n# b'''\n[drive]\nratio = 2\n");
  EXPECT_EQ(edit("name = \"\"\"a\\\"\"\"\"\"\nformat = 'x'\n", "format", "'y'"),
            "name = \"\"\"a\\\"\"\"\"\"\nformat = 'y'\n");
  EXPECT_EQ(edit("\"na\\u006De\" = 1\n'drive' . \"ratio\" = 2\n", "name", "3"),
            "\"na\\u006De\" = 3\n'drive' . \"ratio\" = 2\n");
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/input_notes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/model/input/placed_group.hpp"
#include "support/article_gear.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 3 * mm reads as it should

GearSet gear_of_sections() {
  GearSet gear = test::article_gear();
  Flexspline& fs = *gear.flexspline;
  fs.crack_free = CrackFree::sections;
  fs.rim = TubeSection{.outer_diameter = 160 * mm, .wall_thickness = 3 * mm, .length = 30 * mm};
  fs.barrel = TubeSection{.outer_diameter = 158 * mm, .wall_thickness = 2 * mm, .length = 100 * mm};
  fs.diaphragm = Diaphragm{
      .outer_diameter = 154 * mm, .inner_diameter = 80 * mm, .thickness = 3 * mm, .profile = {}};
  fs.length.reset();
  fs.wall_thickness.reset();
  return gear;
}

/// The text of the only note of a code at a field; empty if there is not exactly one.
std::string text_of(const GearSet& gear, std::string_view code, std::string_view path) {
  std::string text;
  int count = 0;
  for (const Note& note : input_notes(gear)) {
    if (note.code != code || note.path != path) continue;
    EXPECT_EQ(note.severity, Severity::care);
    EXPECT_FALSE(note.next_step.empty());
    text = note.text;
    ++count;
  }
  return count == 1 ? text : std::string();
}

TEST(InputNotes, BehaviourOrdinaryDrivesHaveNone) {
  EXPECT_TRUE(input_notes(test::article_gear()).empty());
  EXPECT_TRUE(input_notes(gear_of_sections()).empty());
}

TEST(InputNotes, InputOutOfProportion) {
  const auto noted = [](std::string_view path, double value) {
    GearSet gear = test::article_gear();
    set_number(gear, path, value);
    return text_of(gear, "input.implausible", path);
  };
  EXPECT_EQ(noted("material.steel.youngs_modulus", 210),
            "0.00021 MPa is unusual; the usual range is 20 GPa to 800 GPa");
  EXPECT_EQ(noted("flexspline.wall_thickness", 2.24e-6),
            "0.00224 mm is unusual; the usual range is 0.05 mm to 200 mm");
  EXPECT_EQ(noted("drive.ratio", 1e-9), "1e-09 is unusual; the usual range is 10 to 1000");
  // The bounds themselves are usual.
  EXPECT_TRUE(noted("drive.ratio", 1000).empty());
  EXPECT_TRUE(noted("drive.ratio", 10).empty());
  EXPECT_FALSE(noted("drive.ratio", 1000.5).empty());
  EXPECT_TRUE(noted("load.torque", 1e6).empty());
  // The unit alone determines the range, for either sign.
  EXPECT_FALSE(noted("load.torque", 1e12).empty());
  EXPECT_FALSE(noted("load.torque", -1e12).empty());
  EXPECT_FALSE(noted("output_shaft.length", 100).empty());
  EXPECT_TRUE(noted("load.axial_force", 0).empty());
  EXPECT_TRUE(noted("load.torque", -100).empty());
}

TEST(InputNotes, InputLengthsThatTheSectionsContradict) {
  GearSet gear = gear_of_sections();
  gear.flexspline->length = 145 * mm;
  gear.flexspline->wall_thickness = 0.6 * mm;
  EXPECT_EQ(text_of(gear, "flexspline.contradiction", "flexspline.length"),
            "the file gives 145 mm here, but rim.length + barrel.length gives 130 mm; the program "
            "uses 130 mm");
  EXPECT_EQ(text_of(gear, "flexspline.contradiction", "flexspline.wall_thickness"),
            "the file gives 0.6 mm here, but rim.wall_thickness gives 3 mm; the program uses 3 mm");
  gear.flexspline->length = 130.1 * mm;  // rounded
  gear.flexspline->wall_thickness = 3 * mm;
  EXPECT_TRUE(input_notes(gear).empty());
}

TEST(InputNotes, InputSectionsWhoseWallsDoNotMeet) {
  // The wall of the rim lies between 154 and 160 mm.
  GearSet gear = gear_of_sections();
  EXPECT_TRUE(input_notes(gear).empty());
  const std::string field = "flexspline.barrel.outer_diameter";
  gear.flexspline->barrel->outer_diameter = 153 * mm;
  gear.flexspline->diaphragm->outer_diameter = 152 * mm;
  EXPECT_EQ(
      text_of(gear, "flexspline.step", field),
      "the wall of the barrel lies between 149 and 153 mm in diameter, and the wall of the rim, "
      "154 to 160 mm, does not meet this wall; the step adds compliance that the model by "
      "sections leaves out");
  gear.flexspline->barrel->outer_diameter = 154 * mm;
  EXPECT_TRUE(input_notes(gear).empty());
  gear.flexspline->diaphragm->outer_diameter = 148 * mm;
  EXPECT_EQ(
      text_of(gear, "flexspline.step", field),
      "the wall of the barrel lies between 150 and 154 mm in diameter, and the edge of the "
      "diaphragm, 148 mm, does not meet this wall; the step adds compliance that the model by "
      "sections leaves out");
}

TEST(InputNotes, InputDiaphragmOfAHat) {
  // The wall of the barrel lies between 154 and 158 mm; the inner edge of the diaphragm meets it.
  GearSet gear = gear_of_sections();
  gear.flexspline->shape = FlexsplineShape::hat;
  Diaphragm& diaphragm = *gear.flexspline->diaphragm;
  diaphragm.outer_diameter = 250 * mm;
  for (const double inner : {154.0, 157.0}) {
    diaphragm.inner_diameter = inner * mm;
    EXPECT_TRUE(input_notes(gear).empty()) << inner;
  }
  diaphragm.inner_diameter = 152 * mm;
  EXPECT_NE(text_of(gear, "flexspline.step", "flexspline.barrel.outer_diameter")
                .find("the edge of the diaphragm, 152 mm, does not meet this wall"),
            std::string::npos);
}

TEST(InputNotes, IdentityEveryUsualRangeContainsItsExample) {
  // The template of an input file describes a plausible drive, so its examples are usual.
  const GearSet gear = test::article_gear();
  for_each_number(gear, [](const FieldPath& path, const Field& field, const double& value) {
    const Range usual = usual_range(field);
    EXPECT_TRUE(value == 0 || usual.contains(std::abs(value))) << path.text();
  });
}

// A table that gives several cracks says which ones, because a path names only one of them.
TEST(InputNotes, BehaviourCracksOfAGroup) {
  const auto note_of = [](const std::vector<double>& positions) {
    GearSet gear = test::article_gear();
    gear.output_shaft->crack.emplace_back(AnnularCrack{.depth = 1 * mm, .positions = positions});
    place_groups(gear);
    const std::vector<Note> notes = input_notes(gear);
    EXPECT_EQ(notes.size(), positions.size() > 1 ? 1U : 0U);
    return notes.empty() ? Note() : notes.front();
  };
  const Note three = note_of({10 * mm, 20 * mm, 30 * mm});
  EXPECT_EQ(three.code, "input.crack_group");
  EXPECT_EQ(three.path, "output_shaft.crack[1]");
  EXPECT_EQ(three.severity, Severity::information);
  EXPECT_EQ(three.text,
            "this table gives 3 cracks: crack 1/3 has this path, and cracks 2/3 to 3/3 are "
            "output_shaft.crack[2] to output_shaft.crack[3]; a path names only one of them in "
            "--vary, [[scatter]], [[range]] and [[inspection.place]]");
  EXPECT_NE(note_of({10 * mm, 20 * mm}).text.find("and crack 2/2 is output_shaft.crack[2]"),
            std::string::npos);
  (void)note_of({10 * mm});
}

}  // namespace
}  // namespace strainwave

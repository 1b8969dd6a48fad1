// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/section_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "report/svg_document.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/article_gear.hpp"

namespace strainwave {
namespace {

using test::Box;
using test::box_of;
using test::Element;
using units::deg;
using units::mm;

// Coordinates are rounded to a micrometre of paper.
constexpr double kRounding = 0.002;

GearSet example(const std::string& name) {
  return read_gear_set_file(std::filesystem::path(STRAINWAVE_EXAMPLES) / (name + ".toml"));
}

/// A parsed drawing.
struct Drawing {
  explicit Drawing(const std::string& svg) : elements(test::parse_xml(svg)) {
    scale = std::stod(elements.at(0).at("data-scale"));
  }
  [[nodiscard]] std::vector<const Element*> with(const std::string& attribute,
                                                 const std::string& value) const {
    std::vector<const Element*> found;
    for (const Element& element : elements)
      if (element.has(attribute) && element.at(attribute) == value) found.push_back(&element);
    return found;
  }
  /// Extent of the one element [mm of the drive].
  [[nodiscard]] Box box(const std::string& attribute, const std::string& value) const {
    const auto found = with(attribute, value);
    EXPECT_EQ(found.size(), 1U) << attribute << ' ' << value;
    if (found.empty()) return {};
    Box b = box_of(found.front()->at("d"));
    b.left /= scale;
    b.right /= scale;
    b.top /= scale;
    b.bottom /= scale;
    return b;
  }
  std::vector<Element> elements;
  double scale = 0.0;
};

std::set<std::string> cracks_in(const Drawing& drawing, const char* attribute = "data-crack") {
  std::set<std::string> paths;
  for (const Element& element : drawing.elements)
    if (element.has(attribute)) paths.insert(element.at(attribute));
  return paths;
}

TEST(SectionDrawing, ScalingShaftOfTheArticleIsDrawnToScale) {
  const Drawing drawing(section_drawing(test::article_gear()));
  const Box shaft = drawing.box("data-part", "output_shaft");
  // The half section reaches from the radius of the bore to the outer radius.
  EXPECT_NEAR(shaft.width(), 200, kRounding / drawing.scale);
  EXPECT_NEAR(shaft.height(), (70 - 45) / 2.0, kRounding / drawing.scale);
  const Box wall = drawing.box("data-part", "barrel");
  EXPECT_NEAR(wall.width(), 160, kRounding / drawing.scale);
  EXPECT_NEAR(wall.height(), 2.24, kRounding / drawing.scale);
  // Twice the distance from the axis is 70 mm at the top of the shaft and 160 mm at the top of the
  // wall.
  EXPECT_NEAR(shaft.top - wall.top, (160 - 70) / 2.0, 2 * kRounding / drawing.scale);
}

TEST(SectionDrawing, ScalingPartsOfACupAreDrawnToScale) {
  const GearSet gear = example("cracked_size25");
  const Drawing drawing(section_drawing(gear));
  const double tolerance = 2 * kRounding / drawing.scale;
  const Box shaft = drawing.box("data-part", "output_shaft");
  const double axis = shaft.bottom;  // a solid shaft ends there
  EXPECT_NEAR(shaft.height(), 15, tolerance);
  const auto expect_ring = [&](const char* part, double inner, double outer, double width) {
    const Box box = drawing.box("data-part", part);
    EXPECT_NEAR(axis - box.top, outer, tolerance) << part;
    EXPECT_NEAR(axis - box.bottom, inner, tolerance) << part;
    EXPECT_NEAR(box.width(), width, tolerance) << part;
  };
  expect_ring("circular_spline", 32.4, 42.5, 9.5);
  expect_ring("rim", 62.801 / 2 - 0.755, 62.801 / 2, 9.5);
  expect_ring("barrel", 62.499 / 2 - 0.453, 62.499 / 2, 17.2);
  expect_ring("diaphragm", 18.4, 31.023, 0.762);
  expect_ring("outer_ring", 29.8985 - 0.747, 29.8985 + 0.747, 9.2);
  // The inner ring ends at the bottom of its groove.
  expect_ring("inner_ring", 48.957 / 2 - 1.494, 48.957 / 2, 9.2);
  const auto balls = drawing.with("data-part", "ball");
  ASSERT_EQ(balls.size(), 1U);
  EXPECT_NEAR(std::stod(balls[0]->at("r")) / drawing.scale, 4.673 / 2, tolerance);
  EXPECT_NEAR(axis - std::stod(balls[0]->at("cy")) / drawing.scale, (48.957 + 58.303) / 4,
              tolerance);
}

TEST(SectionDrawing, ScalingTheBarIsAsLongAsItSays) {
  for (const char* const name : {"article", "cracked_size25", "solid_shaft"}) {
    const GearSet gear = example(name);
    for (const std::string& svg :
         {section_drawing(gear), front_drawing(gear), wall_drawing(gear)}) {
      if (svg.empty()) continue;
      const Drawing drawing(svg);
      bool found = false;
      for (std::size_t i = 0; i + 2 < drawing.elements.size(); ++i) {
        if (!drawing.elements[i].has("data-bar-mm")) continue;
        found = true;
        const double length = box_of(drawing.elements[i + 2].at("d")).right -
                              box_of(drawing.elements[i + 1].at("d")).left;
        EXPECT_NEAR(length / drawing.scale, std::stod(drawing.elements[i].at("data-bar-mm")),
                    2 * kRounding / drawing.scale)
            << name;
      }
      EXPECT_TRUE(found) << name;
      // A user unit is a millimetre of paper.
      const Element& root = drawing.elements.front();
      EXPECT_EQ(root.at("viewBox").find("0 0 180 "), 0U);
      EXPECT_EQ(root.at("width"), "180mm");
    }
  }
}

TEST(SectionDrawing, ScalingCracksAreInTrueSizeAtTheirPlace) {
  const GearSet gear = example("cracked_size25");
  const Drawing drawing(section_drawing(gear));
  const double tolerance = 2 * kRounding / drawing.scale;
  const double axis = drawing.box("data-part", "output_shaft").bottom;
  const auto expect_crack = [&](const char* path, double inner, double outer, double width) {
    const Box box = drawing.box("data-crack", path);
    EXPECT_NEAR(axis - box.top, outer, tolerance) << path;
    EXPECT_NEAR(axis - box.bottom, inner, tolerance) << path;
    EXPECT_NEAR(box.width(), width, tolerance) << path;
  };
  // Depths a = 0.1, 2c = 0.1/0.5*2; 0.4 over the width; through, 4 mm long at 45 degrees; ...
  expect_crack("wave_generator.crack[0]", 48.957 / 2 - 0.1, 48.957 / 2, 0.4);
  expect_crack("wave_generator.crack[1]", 29.1515, 29.1515 + 0.4, 9.2);
  expect_crack("flexspline.crack[0]", 62.499 / 2 - 0.453, 62.499 / 2, 4 * std::cos(45 * deg));
  expect_crack("flexspline.crack[1]", 18.4, 18.4, 0.762);
  expect_crack("flexspline.crack[2]", 19.75, 20.25, 0.2);
  expect_crack("flexspline.crack[3]", 62.801 / 2 - 0.3, 62.801 / 2, 9.5);
  expect_crack("circular_spline.crack[0]", 32.4, 35.4, 9.5);
  expect_crack("output_shaft.crack[0]", 13, 15, 0);
  EXPECT_EQ(drawing.box("data-crack", "mesh.crack[0]").width(), 9.5);
}

TEST(SectionDrawing, BehaviourEveryCrackIsDrawnAndNumbered) {
  for (const char* const name :
       {"article", "cracked_size25", "cup_sections", "solid_shaft", "bent_shaft"}) {
    const GearSet gear = example(name);
    const std::vector<NumberedCrack> cracks = numbered_cracks(gear);
    const Drawing drawing(section_drawing(gear));
    std::set<std::string> expected;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      EXPECT_EQ(cracks[i].number, static_cast<int>(i) + 1);
      EXPECT_FALSE(cracks[i].size.empty());
      expected.insert(cracks[i].path);
    }
    EXPECT_EQ(cracks_in(drawing), expected) << name;
    std::set<std::string> marks;
    for (std::size_t i = 0; i + 1 < drawing.elements.size(); ++i)
      if (drawing.elements[i].has("class") && drawing.elements[i].at("class") == "crack-mark")
        marks.insert(drawing.elements[i + 1].text);
    EXPECT_EQ(marks.size(), cracks.size()) << name;
  }
}

TEST(SectionDrawing, BehaviourSmallCracksAreEnlargedByTheScaleThatIsStated) {
  GearSet gear = test::article_gear();  // 0.1 mm, drawn at 1:2.5
  const Drawing drawing(section_drawing(gear));
  EXPECT_EQ(cracks_in(drawing, "data-enlarged"),
            (std::set<std::string>{"wave_generator.crack[0]", "output_shaft.crack[0]"}));
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    const Element& group = drawing.elements[i];
    if (!group.has("data-detail")) continue;
    const double scale = std::stod(group.at("data-scale"));
    const auto shape = drawing.with("data-enlarged", group.at("data-detail"));
    ASSERT_EQ(shape.size(), 1U);
    EXPECT_NEAR(box_of(shape[0]->at("d")).height() / scale, 0.1, kRounding / scale);
    EXPECT_GE(box_of(shape[0]->at("d")).height(), 0.7);
    EXPECT_NE(group.text.find("enlarged, " + std::to_string(static_cast<int>(scale)) + ":1"),
              std::string::npos)
        << group.text;
  }
  // Cracks above 0.7 mm on paper are not enlarged.
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 2 * mm;
  EXPECT_FALSE(
      cracks_in(Drawing(section_drawing(gear)), "data-enlarged").contains("output_shaft.crack[0]"));
  // The crack of the wall is enlarged in the drawing that shows its true direction.
  EXPECT_EQ(cracks_in(Drawing(wall_drawing(gear)), "data-enlarged"),
            (std::set<std::string>{"flexspline.crack[0]"}));
}

TEST(SectionDrawing, BehaviourSurfaceCrackOfAShaftLiesAcrossTheAxis) {
  // In the section it is a line of its depth; enlarged, the detail shows its length along the arc.
  GearSet gear = example("bent_shaft");
  const Drawing drawing(section_drawing(gear));
  const Box crack = drawing.box("data-crack", "output_shaft.crack[0]");
  EXPECT_NEAR(crack.width(), 0.0, 2 * kRounding / drawing.scale);
  EXPECT_NEAR(crack.height(), 1.0, 2 * kRounding / drawing.scale);
  std::get<ShaftSurfaceCrack>(gear.output_shaft->crack[0]) = {.depth = 0.1 * mm,
                                                              .half_length = 0.15 * mm};
  const Drawing small(section_drawing(gear));
  const auto enlarged = small.with("data-enlarged", "output_shaft.crack[0]");
  ASSERT_EQ(enlarged.size(), 1U);
  const Box detail = box_of(enlarged[0]->at("d"));
  EXPECT_NEAR(detail.width() / detail.height(), 3.0, 0.1);
}

TEST(SectionDrawing, BehaviourAngleBetaRunsFromTheGeneratorTowardMinusTheta) {
  GearSet gear = example("cracked_size25");
  WallThroughCrack& crack = std::get<WallThroughCrack>(gear.flexspline->crack[0]);
  for (const double angle : {45 * deg, -30 * deg, 90 * deg, 0.0}) {
    crack.angle = angle;
    const Drawing drawing(wall_drawing(gear));
    const auto path = drawing.with("data-crack", "flexspline.crack[0]");
    ASSERT_EQ(path.size(), 1U);
    // Ends in the order of z; the paper's y grows downward, which is +theta.
    const std::string& d = path[0]->at("d");
    std::size_t used = 0;
    const double x1 = std::stod(d.substr(1), &used);
    const double y1 = std::stod(d.substr(1 + used));
    const std::size_t second = d.find('L');
    const double x2 = std::stod(d.substr(second + 1), &used);
    const double y2 = std::stod(d.substr(second + 1 + used));
    const double tolerance = 2 * kRounding / drawing.scale;
    EXPECT_NEAR((x2 - x1) / drawing.scale, 4 * std::cos(angle), tolerance);
    EXPECT_NEAR((y1 - y2) / drawing.scale, 4 * std::sin(angle), tolerance);
  }
}

TEST(SectionDrawing, ScalingFrontViewHasAnglesDepthsAndTheStatedOvality) {
  GearSet gear = example("cracked_size25");
  std::get<RimAxialCrack>(gear.flexspline->crack[3]).position = 30 * deg;
  const std::string svg = front_drawing(gear);
  const Drawing drawing(svg);
  const auto ring = drawing.with("data-part", "circular_spline");
  ASSERT_EQ(ring.size(), 1U);
  const double x0 = std::stod(ring[0]->at("cx"));
  const double y0 = std::stod(ring[0]->at("cy"));
  EXPECT_NEAR(std::stod(ring[0]->at("r")) / drawing.scale, 42.5, kRounding);
  EXPECT_EQ(
      cracks_in(drawing),
      (std::set<std::string>{"wave_generator.crack[0]", "wave_generator.crack[1]",
                             "flexspline.crack[3]", "mesh.crack[0]", "circular_spline.crack[0]"}));
  const std::size_t says = svg.find(" drawn ");
  ASSERT_NE(says, std::string::npos);
  const double factor = std::stod(svg.substr(says + 7));
  EXPECT_GT(factor, 1);
  const auto check = [&](const char* path, double angle, double from, double to) {
    const std::string& d = drawing.with("data-crack", path).at(0)->at("d");
    std::size_t used = 0;
    const double x = std::stod(d.substr(1), &used) - x0;
    const double y = y0 - std::stod(d.substr(1 + used));
    const std::size_t second = d.find('L');
    const double x2 = std::stod(d.substr(second + 1), &used) - x0;
    const double y2 = y0 - std::stod(d.substr(second + 1 + used));
    const double tolerance = 3 * kRounding / drawing.scale;
    EXPECT_NEAR(std::hypot(x, y) / drawing.scale, from, tolerance) << path;
    EXPECT_NEAR(std::hypot(x2, y2) / drawing.scale, to, tolerance) << path;
    // The angle is counter-clockwise from upright.
    EXPECT_NEAR(std::atan2(-x, y), angle, 1e-3) << path;
  };
  // Round parts keep their radius; the rim is deflected, w0 is true at the lobe, and its decrease
  // elsewhere is enlarged by `factor`.
  check("circular_spline.crack[0]", 0, 32.4, 35.4);
  const double root = 62.801 / 2 + 0.3175 - factor * 0.3175 * (1 - std::cos(60 * deg));
  check("flexspline.crack[3]", 30 * deg, root, root - 0.3);
}

TEST(SectionDrawing, BehaviourWhatTheFileDoesNotSayIsDashed) {
  const Drawing article(section_drawing(test::article_gear()));
  for (const char* const part : {"cam", "inner_ring", "outer_ring", "circular_spline", "ball"}) {
    const auto found = article.with("data-part", part);
    ASSERT_EQ(found.size(), 1U) << part;
    EXPECT_EQ(found[0]->at("class"), "sketched") << part;
  }
  EXPECT_EQ(article.with("data-part", "output_shaft").at(0)->at("class").find("part"), 0U);
  EXPECT_NE(section_drawing(test::article_gear()).find("not in the file, sketched"),
            std::string::npos);
  // If only the cam and the teeth are sketched, only these are dashed.
  const Drawing full(section_drawing(example("cracked_size25")));
  for (const char* const part : {"inner_ring", "outer_ring", "circular_spline", "rim", "barrel"})
    EXPECT_EQ(full.with("data-part", part).at(0)->at("class").find("part"), 0U) << part;
}

TEST(SectionDrawing, LimitAbsentMembersAreNotDrawn) {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  const Drawing shaft(section_drawing(gear));
  EXPECT_EQ(shaft.with("data-part", "output_shaft").size(), 1U);
  for (const char* const part : {"barrel", "inner_ring", "ball", "circular_spline", "diaphragm"})
    EXPECT_TRUE(shaft.with("data-part", part).empty()) << part;
  EXPECT_TRUE(front_drawing(gear).empty());
  EXPECT_TRUE(wall_drawing(gear).empty());
  gear.output_shaft.reset();
  EXPECT_TRUE(section_drawing(gear).empty());
  EXPECT_TRUE(numbered_cracks(gear).empty());
}

TEST(SectionDrawing, LimitEveryCombinationOfMembersIsWellFormed) {
  const GearSet full = example("cracked_size25");
  for (int choice = 0; choice < 32; ++choice) {
    GearSet gear = full;
    if ((choice & 1) != 0) gear.wave_generator.reset();
    if ((choice & 2) != 0) gear.flexspline.reset();
    if ((choice & 4) != 0) gear.output_shaft.reset();
    if ((choice & 8) != 0) gear.circular_spline.reset();
    if ((choice & 16) != 0) gear.mesh.reset();
    for (const std::string& svg :
         {section_drawing(gear), front_drawing(gear), wall_drawing(gear)}) {
      if (svg.empty()) continue;
      EXPECT_NO_THROW((void)test::parse_xml(svg)) << choice;
      EXPECT_EQ(svg.find("nan"), std::string::npos) << choice;
      EXPECT_EQ(svg.find("inf\""), std::string::npos) << choice;
    }
  }
}

TEST(SectionDrawing, ScalingTheDiaphragmOfAHatRunsOutward) {
  const GearSet gear = example("silk_hat");
  const Drawing drawing(section_drawing(gear));
  const Box plate = drawing.box("data-part", "diaphragm");
  EXPECT_NEAR(plate.width(), 0.4, 2 * kRounding / drawing.scale);
  EXPECT_NEAR(plate.height(), (86 - 62.0467) / 2, 2 * kRounding / drawing.scale);
}

TEST(SectionDrawing, BehaviourDiaphragmProfileIsFollowed) {
  GearSet gear = example("cracked_size25");
  gear.flexspline->crack.clear();
  gear.flexspline->diaphragm->profile = {{20 * mm, 2 * mm}, {25 * mm, 1 * mm}};
  const Drawing drawing(section_drawing(gear));
  const Box plate = drawing.box("data-part", "diaphragm");
  EXPECT_NEAR(plate.width(), 2, 2 * kRounding / drawing.scale);
  const std::string& d = drawing.with("data-part", "diaphragm").at(0)->at("d");
  EXPECT_EQ(std::ranges::count(d, 'L') + 1, 6);  // two corners outside, four radii inside
}

}  // namespace
}  // namespace strainwave

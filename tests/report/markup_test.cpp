// SPDX-License-Identifier: Apache-2.0 Tests private functions for text, numbers and places of
// marks.
#include "markup.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "html.hpp"
#include "report/svg_document.hpp"
#include "sheet.hpp"

namespace strainwave::report {
namespace {

TEST(Markup, ReferenceTextFromOutsideIsEscaped) {
  EXPECT_EQ(escaped("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(escaped("β = 45°, ⌀ 7 mm, 😀"), "β = 45°, ⌀ 7 mm, 😀");
  EXPECT_EQ(escaped("a\tb\nc"), "a\tb\nc");
  EXPECT_EQ(escaped("a\r\n"), "a\n");
}

// Characters that XML 1.0 forbids and bytes that are not UTF-8 give a replacement character for
// each byte.
TEST(Markup, InputBrokenTextIsReplaced) {
  EXPECT_EQ(escaped(std::string("\0\x01\x1f\x7f", 4)), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escaped("\xff|"), "\uFFFD|");
  EXPECT_EQ(escaped("\xc3"), "\uFFFD");                                // cut off
  EXPECT_EQ(escaped("\xc3(|"), "\uFFFD(|");                            // no continuation
  EXPECT_EQ(escaped("\xc0\xaf"), "\uFFFD\uFFFD");                      // overlong "/"
  EXPECT_EQ(escaped("\xe0\x80\xaf"), "\uFFFD\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(escaped("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");            // surrogate
  EXPECT_EQ(escaped("\xf4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");  // beyond U+10FFFF
  EXPECT_EQ(escaped("\xef\xbf\xbf"), "\uFFFD\uFFFD\uFFFD");            // U+FFFF
  EXPECT_EQ(escaped("\xc2\x85"), "\uFFFD\uFFFD");                      // a control of Latin-1
  EXPECT_EQ(escaped("\xc2\xa0"), "\xc2\xa0");                          // no-break space stays
  EXPECT_EQ(escaped("\xf4\x8f\xbf\xbd"), "\xf4\x8f\xbf\xbd");          // U+10FFFD
}

TEST(Markup, ReferenceNumbersForPeople) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(25914.4), "25910");
  EXPECT_EQ(number(99996), "100000");
  EXPECT_EQ(number(3.14159), "3.142");
  EXPECT_EQ(number(-0.5), "−0.5");
  EXPECT_EQ(number(100), "100");
  EXPECT_EQ(number(0.0012345, 3), "0.00123");
  EXPECT_EQ(number(6.328e-6), "6.328·10⁻⁶");
  EXPECT_EQ(number(-1.5e12, 2), "−1.5·10¹²");
  EXPECT_EQ(typeset("6.33e-06"), "6.33·10⁻⁶");
  EXPECT_EQ(typeset("-1.2e+10"), "−1.2·10¹⁰");
  EXPECT_EQ(typeset("+0.25"), "+0.25");
  EXPECT_EQ(typeset("7"), "7");
  EXPECT_EQ(coordinate(1.23456), "1.235");
  EXPECT_EQ(coordinate(-0.0001), "0");
  EXPECT_EQ(coordinate(120), "120");
  EXPECT_EQ(in_mm(0.000755), "0.755 mm");
  EXPECT_EQ(typeset("-50 %, 2e-05 to 1"), "−50 %, 2·10⁻⁵ to 1");
  EXPECT_EQ(typeset("none, contact-path"), "none, contact-path");
  EXPECT_EQ(label("K1 [N*m/rad], T > 0"), "<i>K</i><sub>1</sub> [N·m/rad], <i>T</i> &gt; 0");
}

TEST(Markup, ReferenceScalesOfDrawings) {
  EXPECT_EQ(drawing_scale(0.100, 100), 1);
  EXPECT_EQ(drawing_scale(0.1001, 100), 0.5);
  EXPECT_EQ(drawing_scale(0.050, 100), 2);
  EXPECT_EQ(drawing_scale(0.220, 100), 0.4);
  EXPECT_EQ(drawing_scale(0.0001, 12), 100);
  EXPECT_EQ(scale_text(2), "2:1");
  EXPECT_EQ(scale_text(1), "1:1");
  EXPECT_EQ(scale_text(0.4), "1:2.5");
  EXPECT_EQ(scale_text(0.005), "1:200");
}

TEST(Markup, BehaviourMarksKeepTheirDistanceAndOrder) {
  // Marks that are far apart stay at their places; close marks are centred on their wanted places.
  EXPECT_EQ(spread(std::vector{10.0, 30.0}, 5, 0, 100), (std::vector{10.0, 30.0}));
  EXPECT_EQ(spread(std::vector{50.0, 50.0, 50.0}, 6, 0, 100), (std::vector{44.0, 50.0, 56.0}));
  EXPECT_EQ(spread(std::vector{52.0, 50.0}, 6, 0, 100), (std::vector{54.0, 48.0}));
  EXPECT_EQ(spread(std::vector{2.0, 1.0}, 6, 0, 100), (std::vector{6.0, 0.0}));
  EXPECT_EQ(spread(std::vector{99.0, 98.0}, 6, 0, 100), (std::vector{100.0, 94.0}));
  // A block that grows into the next block merges with it.
  const std::vector<double> places = spread(std::vector{50.0, 50.0, 57.0}, 6, 0, 100);
  EXPECT_NEAR(places[1] - places[0], 6, 1e-12);
  EXPECT_NEAR(places[2] - places[1], 6, 1e-12);
  EXPECT_NEAR(places[0] + places[1] + places[2], 157, 1e-9);  // least squares preserve the mean
  EXPECT_TRUE(spread(std::vector<double>{}, 6, 0, 100).empty());
}

// The length of a bar is its value on an axis that ends at the largest value; the bar begins at
// zero.
TEST(Markup, ScalingBarsAreAsLongAsTheirValues) {
  const auto bars = [](const BarChart& chart) {
    std::vector<test::Element> found;
    for (const test::Element& element : test::parse_xml(bar_chart(chart)))
      if (element.name == "rect") found.push_back(element);
    return found;
  };
  const auto width = [](const test::Element& e) { return std::stod(e.at("width")); };
  const auto left = [](const test::Element& e) { return std::stod(e.at("x")); };
  const auto plain = bars({.id = "a",
                           .title = "t",
                           .axis = "x",
                           .bars = {{.label = "<one>", .to = 4, .text = "4", .style = {}},
                                    {.label = "two", .to = 1, .text = "1", .style = {}}}});
  ASSERT_EQ(plain.size(), 2U);
  EXPECT_NEAR(width(plain[0]), 4 * width(plain[1]), 0.01);
  EXPECT_EQ(left(plain[0]), left(plain[1]));
  EXPECT_LT(std::stod(plain[0].at("y")), std::stod(plain[1].at("y")));
  const auto signs = bars({.id = "a",
                           .title = "t",
                           .axis = "x",
                           .bars = {{.label = "up", .to = 3, .text = "3", .style = {}},
                                    {.label = "down", .to = -1.5, .text = "", .style = {}}}});
  EXPECT_NEAR(width(signs[0]), 2 * width(signs[1]), 0.01);
  EXPECT_NEAR(left(signs[1]) + width(signs[1]), left(signs[0]), 0.01);
  // A line of reference beyond the bars widens the axis.
  const auto short_bar = bars({.id = "a",
                               .title = "t",
                               .axis = "x",
                               .bars = {{.label = "one", .to = 0.25, .text = "", .style = {}}},
                               .reference = 1.0,
                               .reference_label = "limit"});
  EXPECT_NEAR(width(short_bar[0]), width(plain[0]) / 4, 0.01);
  // An empty chart is still a valid picture.
  EXPECT_NO_THROW((void)test::parse_xml(bar_chart({.id = "a", .title = "t", .axis = "x"})));
}

TEST(Markup, BehaviourTablesHaveHeadsWithScope) {
  const std::string html =
      table("caption & more", {"a", "b"}, {{"group <1>", {{{"x", "1"}, "style"}}}},
            {.style = {}, .numbers = 1});
  const auto elements = test::parse_xml(html);
  std::vector<std::string> scopes;
  for (const test::Element& element : elements)
    if (element.name == "th") scopes.push_back(element.at("scope"));
  EXPECT_EQ(scopes, (std::vector<std::string>{"col", "col", "rowgroup", "row"}));
  EXPECT_NE(html.find("group &lt;1&gt;"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">1</td>"), std::string::npos);
  EXPECT_NE(html.find("<caption>caption &amp; more</caption>"), std::string::npos);
}

}  // namespace
}  // namespace strainwave::report

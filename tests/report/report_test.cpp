// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "report/svg_document.hpp"
#include "strainwave/core/sha256.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/backbone.hpp"
#include "strainwave/layouts/laminate.hpp"
#include "strainwave/layouts/modes.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/report/section_drawing.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/modes_report.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "support/article_gear.hpp"
#include "support/contrast.hpp"

namespace strainwave {
namespace {

using test::Element;
using units::mm;
using units::MPa;

constexpr std::array kSections = {"drawing", "inputs",      "results",     "shares",
                                  "torsion", "sensitivity", "intensities", "strength",
                                  "notes",   "accuracy",    "equations",   "provenance"};

const Provenance kProvenance{.version = "1.2.3",
                             .revision = "abc",
                             .input_file = "drive.toml",
                             .quadrature_tolerance = 1e-10};

std::string text_of(const std::string& name) {
  std::ifstream stream(std::filesystem::path(STRAINWAVE_EXAMPLES) / (name + ".toml"));
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Few positions and draws suffice, because these tests are on the report and not on the curve.
Report report_on(const std::string& text, Method method = Method::corrected) {
  return make_report(
      read_gear_set(text, "drive.toml"), kProvenance,
      {.method = method, .input_text = text, .date = {}, .angles = 1, .draws = 2, .samples = 20});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

const ReportSection& section(const Report& report, const std::string& id) {
  for (const ReportSection& s : report.sections)
    if (s.id == id) return s;
  throw std::runtime_error("no section " + id);
}

/// The page is XML except for the raw text of the style sheet, which contains neither `<` nor `&`.
std::vector<Element> parsed(const std::string& html) { return test::parse_xml(html); }

TEST(Report, BehaviourEveryExampleGivesAWholePage) {
  for (const char* const name :
       {"article", "cracked_size25", "cup_sections", "solid_shaft", "catalogue_size25",
        "critical_crack", "article_scatter", "library_material", "joint_size25", "composite_cup"}) {
    const Report report = report_on(text_of(name));
    // A drive between motor and load has three more sections, its motion and its kinematic error
    // one each.
    std::vector<std::string> expected(kSections.begin(), kSections.end());
    if (text_of(name).find("[drivetrain]") != std::string::npos)
      for (const char* const chapter : {"modes", "frf", "backbone"})
        expected.insert(std::ranges::find(expected, "sensitivity"), chapter);
    if (text_of(name).find(".ply]]") != std::string::npos)
      expected.insert(std::ranges::find(expected, "torsion") + 1, "laminates");
    if (text_of(name).find("[[manoeuvre]]") != std::string::npos)
      expected.insert(std::ranges::find(expected, "sensitivity"), "motion");
    if (text_of(name).find("[[kinematic_error]]") != std::string::npos)
      expected.insert(std::ranges::find(expected, "sensitivity"), "budget");
    const std::string html = report_html(report);
    ASSERT_NO_THROW((void)parsed(html)) << name;
    const std::vector<Element> elements = parsed(html);
    std::set<std::string> ids;
    std::vector<std::string> sections;
    std::size_t headings = 0;
    for (const Element& element : elements) {
      if (element.has("id")) {
        EXPECT_TRUE(ids.insert(element.at("id")).second) << element.at("id");
      }
      if (element.name == "section") sections.push_back(element.at("id"));
      headings += element.name == "h2" ? 1 : 0;
      if (element.name == "th") {
        EXPECT_TRUE(element.has("scope")) << name;
      }
      if (element.name == "svg") {
        EXPECT_EQ(element.at("role"), "img");
        EXPECT_TRUE(element.has("aria-labelledby") || element.has("aria-label"));
      }
    }
    EXPECT_EQ(sections, expected) << name;
    EXPECT_EQ(headings, expected.size());
    EXPECT_EQ(elements.front().name, "html");
    EXPECT_EQ(elements.front().at("lang"), "en");
    EXPECT_EQ(html.find("<!DOCTYPE html>"), 0U);
    // Links lead somewhere in the page.
    for (const Element& element : elements)
      if (element.name == "a") {
        ASSERT_EQ(element.at("href")[0], '#');
        EXPECT_TRUE(ids.contains(element.at("href").substr(1))) << element.at("href");
      }
    for (const ReportSection& s : report.sections)
      EXPECT_GT(s.html.size(), 25U) << name << ' ' << s.id;
  }
}

// Kind: behaviour.  With the address of the documentation, each equation and each code of a note
// leads to its place there, with one slash between; the rest of the page stays as it is.
TEST(Report, BehaviourLinksIntoTheDocumentation) {
  const GearSet gear = read_gear_set(text_of("article"), "article.toml");
  const auto page = [&](const std::string& site) {
    return report_html(make_report(gear, {}, {.site = site, .angles = 1, .draws = 2}));
  };
  const std::string with = page("https://example.org/a&b");
  EXPECT_EQ(with, page("https://example.org/a&b/"));
  std::set<std::string> tags;
  std::set<std::string> codes;
  for (const Element& element : parsed(with)) {
    if (element.name == "li" && element.has("data-code")) codes.insert(element.at("data-code"));
    if (element.name != "a" || element.at("href")[0] == '#') continue;
    const std::string& to = element.at("href");
    const std::string at = to.substr(to.find('#') + 1);
    if (to.find("/a&amp;b/docs/theory/manual.html#") != std::string::npos ||
        to.find("/a&b/docs/theory/manual.html#") != std::string::npos)
      tags.insert(at);
    else if (to.find("b/notes.html#") != std::string::npos)
      EXPECT_TRUE(codes.contains(at)) << to;
    else
      ADD_FAILURE() << to;
  }
  EXPECT_TRUE(tags.contains("ST-1"));
  EXPECT_GT(tags.size(), 3U);
  EXPECT_GT(codes.size(), 1U);
  EXPECT_EQ(page("").find("manual.html"), std::string::npos);
}

/// The variables of the style sheet for light and for dark screens.
std::vector<std::map<std::string, std::string>> palettes_of(const std::string& html) {
  std::vector<std::map<std::string, std::string>> palettes;
  const std::regex variable("--([a-z]+): (#[0-9a-f]{6});");
  for (std::size_t at = html.find(":root {"); at != std::string::npos;
       at = html.find(":root {", at + 1)) {
    const std::string block = html.substr(at, html.find('}', at) - at);
    auto& palette = palettes.emplace_back();
    for (std::sregex_iterator found(block.begin(), block.end(), variable), end; found != end;
         ++found)
      palette[(*found)[1]] = (*found)[2];
  }
  return palettes;
}

TEST(Report, LimitTextAndLinesHaveContrastOnLightAndDarkScreens) {
  // WCAG 2.1, 1.4.3 and 1.4.11: text at least 4.5:1, graphical objects at least 3:1.
  const auto palettes = palettes_of(report_html(report_on(text_of("cracked_size25"))));
  ASSERT_EQ(palettes.size(), 2U);
  for (const auto& palette : palettes) {
    for (const char* const text : {"text", "muted", "link", "good", "care", "bad"})
      for (const char* const ground : {"page", "soft"})
        EXPECT_GE(test::contrast(palette.at(text), palette.at(ground)), 4.5) << text;
    for (const char* const line : {"ink", "muted", "thin", "hatch", "crack", "bar", "care"})
      for (const char* const ground : {"paper", "part"})
        EXPECT_GE(test::contrast(palette.at(line), palette.at(ground)), 3.0) << line;
  }
}

TEST(Report, BehaviourEveryPictureSaysWhatItShows) {
  for (const char* const name : {"cracked_size25", "critical_crack"}) {
    const std::vector<Element> elements = parsed(report_html(report_on(text_of(name))));
    const auto n = [&](std::string_view tag) {
      return std::ranges::count_if(elements, [&](const Element& e) { return e.name == tag; });
    };
    EXPECT_GT(n("svg"), 5) << name;
    EXPECT_EQ(n("title"), n("svg") + 1) << name;  // and that of the page
    EXPECT_EQ(n("desc"), n("svg")) << name;
  }
}

TEST(Report, BehaviourNothingComesFromOutsideTheFile) {
  const std::string html = report_html(report_on(text_of("cracked_size25")));
  for (const char* const forbidden : {"src=", "<script", "<link", "<iframe", "@import", "url("})
    EXPECT_EQ(html.find(forbidden), std::string::npos) << forbidden;
  // XML namespaces are names, not addresses.
  std::string rest = html;
  for (const std::string name :
       {"xmlns=\"http://www.w3.org/1999/xhtml\"", "xmlns=\"http://www.w3.org/2000/svg\""})
    for (std::size_t at = rest.find(name); at != std::string::npos; at = rest.find(name))
      rest.erase(at, name.size());
  EXPECT_EQ(rest.find("://"), std::string::npos);
}

TEST(Report, IdentityTheSameInputGivesTheSameBytes) {
  const std::string text = text_of("cup_sections");
  EXPECT_EQ(report_html(report_on(text)), report_html(report_on(text)));
}

// Every number of the page with a path in the result equals that of `evaluate`.
TEST(Report, CrosscheckNumbersAreThoseOfEvaluate) {
  for (const char* const name : {"article", "cracked_size25", "cup_sections", "solid_shaft"}) {
    const std::string text = text_of(name);
    const StiffnessResult result =
        evaluate(read_gear_set(text, "x"), Method::corrected, {.over_turn = true});
    std::map<std::string, double> values;
    for_each_quantity(result,
                      [&](const std::string& path, const Quantity& q) { values[path] = q.value; });
    std::set<std::string> shown;
    for (const Element& element : parsed(report_html(report_on(text)))) {
      if (element.name != "data") continue;
      const std::string& path = element.at("data-path");
      ASSERT_TRUE(values.contains(path)) << path;
      EXPECT_EQ(std::stod(element.at("value")), values[path]) << path;
      EXPECT_FALSE(element.text.empty());
      shown.insert(path);
    }
    // Members that the file does not have are left out.
    const GearSet gear = read_gear_set(text, "x");
    EXPECT_EQ(shown.contains("intact.compliance.wave_generator"), gear.wave_generator.has_value());
    EXPECT_EQ(shown.contains("intact.compliance.flexspline"), gear.flexspline.has_value());
    EXPECT_EQ(shown.contains("intact.compliance.output_shaft"), gear.output_shaft.has_value());
    for (const char* const path :
         {"intact.compliance.total", "intact.stiffness", "intact.wind_up",
          "cracked.positive.stiffness", "cracked.negative.stiffness",
          "cracked.positive.stiffness_change", "cracked.negative.stiffness_change",
          "cracked.negative.wind_up", "cracked.negative.compliance.total"})
      EXPECT_TRUE(shown.contains(path)) << name << ' ' << path;
    for (std::size_t i = 0; i < result.cracks.size(); ++i)
      EXPECT_TRUE(shown.contains(result.cracks[i].path + ".added_compliance.negative.at_output"));
    EXPECT_EQ(shown.contains("curve.positive.K3"), result.curve.has_value());
  }
}

TEST(Report, ReferenceStiffnessIsShownInTheUnitThatItNames) {
  const Report report = report_on(text_of("solid_shaft"));
  // 1 N*m/arcmin is 10800/pi N*m/rad.
  const double expected = report.result.intact.stiffness.value * 3.14159265358979 / 10800;
  bool found = false;
  for (const Element& element : parsed("<x>" + report.verdict + "</x>")) {
    if (element.name != "data" || element.at("data-path") != "intact.stiffness") continue;
    found = true;
    EXPECT_NEAR(std::stod(element.text), expected, 5e-4 * expected);
  }
  EXPECT_TRUE(found);
}

TEST(Report, InputTextFromTheFileIsEscapedEverywhere) {
  std::string text = text_of("article");
  const std::string evil = "<script>alert(1)</script> & \\\"q\\\" 'x'";
  const std::size_t at = text.find("Article example");
  text.replace(at, text.find('"', at) - at, evil);
  // The name of a material is a key and appears in paths and notes.
  for (std::size_t i = text.find("[material.steel]"); i != std::string::npos;
       i = text.find("[material.steel]"))
    text.replace(i, 16, "[material.\"<b>&\"]");
  for (std::size_t i = text.find("\"steel\""); i != std::string::npos; i = text.find("\"steel\""))
    text.replace(i, 7, "\"<b>&\"");
  text += "\n# </pre><img onerror=x> &nbsp;\n";
  Provenance provenance = kProvenance;
  provenance.input_file = "<i>\xff.toml";
  const GearSet gear = read_gear_set(text, "drive.toml");
  const std::string html =
      report_html(make_report(gear, provenance, {.input_text = text, .date = "<now>\x07"}));
  ASSERT_NO_THROW((void)parsed(html));
  for (const char* const raw : {"<script", "<img", "<b>&", "<now>", "<i>\xff", "&nbsp;"})
    EXPECT_EQ(html.find(raw), std::string::npos) << raw;
  EXPECT_NE(html.find("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;q&quot; &#39;x&#39;"),
            std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;&amp;"), std::string::npos);
  EXPECT_NE(html.find("\uFFFD.toml"), std::string::npos);
}

TEST(Report, BehaviourTheChapterOnModesIsThatOfTheCommand) {
  const GearSet gear = read_gear_set(text_of("joint_size25"), "drive.toml");
  const Report report = report_on(text_of("joint_size25"));
  const auto chapter = std::ranges::find(report.sections, "modes", &ReportSection::id);
  ASSERT_NE(chapter, report.sections.end());
  const ModesReport modes = modes_report(gear);
  for (const TitledTable& table : modes_tables(modes))
    EXPECT_NE(chapter->html.find(table.title), std::string::npos) << table.title;
  const double frequency = modes.conditions.front().modes.front().cracked->frequency;
  EXPECT_NE(chapter->html.find(shown_number(frequency, 5) + " Hz"), std::string::npos);
  std::size_t plots = 0;
  for (std::size_t at = 0; (at = chapter->html.find("<svg", at)) != std::string::npos; ++at)
    ++plots;
  EXPECT_EQ(plots, modes_panels(modes).size());
  // Another method has no frequencies and says so.
  const GearSet article = read_gear_set(text_of("article") +
                                            "\n[drivetrain]\nmotor_inertia = \"1e-4 kg*m^2\"\n"
                                            "load_inertia = \"1 kg*m^2\"\n",
                                        "drive.toml");
  const Report repaired = make_report(article, kProvenance, {.method = Method::repaired});
  const auto absent = std::ranges::find(repaired.sections, "modes", &ReportSection::id);
  ASSERT_NE(absent, repaired.sections.end());
  EXPECT_NE(absent->html.find("uses the method repaired"), std::string::npos);
}

TEST(Report, BehaviourTheChapterOnTheBackboneIsThatOfTheCommand) {
  const Report report = report_on(text_of("joint_size25"));
  const std::string& html = section(report, "backbone").html;
  const BackboneReport backbone =
      backbone_report(read_gear_set(text_of("joint_size25"), "drive.toml"));
  for (const TitledTable& table : backbone_tables(backbone))
    EXPECT_NE(html.find(table.title), std::string::npos) << table.title;
  const double resonance = backbone.backbone.back().cracked->resonance;
  EXPECT_NE(html.find(shown_number(resonance, 5) + " Hz"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
}

TEST(Report, BehaviourTheChapterOnLaminatesIsThatOfTheCommand) {
  // (LA-18): the same sentence, tables, plot, notes and equations, without a second layout.
  const std::string text = text_of("composite_cup");
  const Report report = report_on(text);
  const LaminateReport laminates = laminate_report(read_gear_set(text, "drive.toml"));
  const std::string& html = section(report, "laminates").html;
  EXPECT_NE(html.find(laminates.sentence), std::string::npos);
  EXPECT_EQ(count(html, "<svg"), laminate_panels(laminates).size());
  EXPECT_EQ(count(html, "<table"), laminate_tables(laminates).size());
  for (const TitledTable& table : laminate_tables(laminates))
    EXPECT_NE(html.find(table.title), std::string::npos) << table.title;
  EXPECT_NE(report.verdict.find("Laminates: "), std::string::npos);
  const std::string page = report_html(report);
  for (const Note& note : laminates.notes)
    EXPECT_NE(page.find(note.code), std::string::npos) << note.code;
  EXPECT_NE(section(report, "equations").html.find("LA-18"), std::string::npos);
}

TEST(Report, ReferenceProvenanceHasTheInputWordForWord) {
  const std::string text = text_of("solid_shaft");
  const Report report = report_on(text);
  const std::string& html = section(report, "provenance").html;
  EXPECT_NE(html.find(sha256_hex(text)), std::string::npos);
  for (const char* const part : {"strainwave 1.2.3 (abc)", "drive.toml", "corrected", "1·10⁻¹⁰"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  std::string word_for_word;
  for (const Element& element : parsed("<x>" + html + "</x>"))
    if (element.name == "pre") word_for_word = element.text;
  for (const auto& [entity, plain] :
       std::map<std::string, std::string>{{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}})
    for (std::size_t at = word_for_word.find(entity); at != std::string::npos;
         at = word_for_word.find(entity, at))
      word_for_word.replace(at, entity.size(), plain);
  EXPECT_EQ(word_for_word, text);
  EXPECT_EQ(html.find("Date"), std::string::npos);  // no date unless it is given
}

TEST(Report, ReferenceInputsSayWhoGaveThem) {
  const Report report = report_on(text_of("catalogue_size25"));
  std::map<std::string, std::string> givers;
  std::string path;
  for (const Element& element : parsed("<x>" + section(report, "inputs").html + "</x>")) {
    if (element.name == "code") path = element.at("data-field");
    if (element.name == "span") givers[path] = element.text;
  }
  const std::map<std::string, std::string> expected = {
      {"drive.ratio", "catalogue"},                         // from its comment
      {"wave_generator.bearing.ball_diameter", "drawing"},  // from the comment above it
      {"wave_generator.bearing.loaded_balls", "assumed"},
      {"flexspline.diaphragm.thickness", "assumed"},  // from its [[range]]
      {"material.steel.youngs_modulus", "typical"},
      {"mesh.flank_angle", "assumed"},
      {"wave_generator.load_factor", "default"},
      {"flexspline.length", "catalogue"},
      {"flexspline.rim.outer_diameter", "in the file"},  // its comment begins with another word
      {"load.axial_force", "default"}};
  for (const auto& [field, giver] : expected) EXPECT_EQ(givers[field], giver) << field;
  const std::string& html = section(report, "inputs").html;
  EXPECT_NE(html.find("18 deg to 26 deg"), std::string::npos);
  EXPECT_NE(html.find("one thickness in place of a plate"), std::string::npos);
}

// The inputs are those of the file, which gives the cracks of a group in one table.
TEST(Report, BehaviourAGroupOfCracksIsOneTableOfTheInputs) {
  const Report report = report_on(text_of("crack_group"));
  const std::string& html = section(report, "inputs").html;
  for (const char* const field : {"half_length", "count", "pitch"})
    EXPECT_NE(html.find("flexspline.crack[0]." + std::string(field)), std::string::npos) << field;
  EXPECT_EQ(html.find("flexspline.crack[1]"), std::string::npos);
}

TEST(Report, BehaviourACompletedMaterialIsMarkedFieldByField) {
  std::string text = text_of("solid_shaft");
  const std::size_t table = text.find("[material.");
  const std::size_t end = text.find("\n[", table);
  const std::string head = text.substr(table, text.find('\n', table) - table);
  text.replace(table, end - table,
               head + "\nbased_on = \"40CrNiMoA QT\"\nfracture_toughness = \"90 MPa*m^0.5\"\n");
  const Report report = report_on(text);
  const std::string& html = section(report, "inputs").html;
  const std::string name = head.substr(10, head.size() - 11);
  const auto cells = [&](const std::string& field) {
    const std::size_t row = html.find("data-field=\"material." + name + '.' + field + '"');
    EXPECT_NE(row, std::string::npos) << field;
    return html.substr(row, html.find("</tr>", row) - row);
  };
  EXPECT_NE(cells("based_on").find("in the file"), std::string::npos);
  EXPECT_NE(cells("fracture_toughness").find("in the file"), std::string::npos);
  EXPECT_NE(cells("yield_strength").find("material library"), std::string::npos);
  const auto& yield = *require_material("40CrNiMoA QT").yield_strength;
  EXPECT_NE(cells("yield_strength").find("source " + yield.source), std::string::npos);
}

TEST(Report, ReferenceMaterialsOfTheLibraryAreNamedAsSuch) {
  const Report report = report_on(text_of("library_material"));
  const std::string& html = section(report, "inputs").html;
  const std::size_t row = html.find("data-field=\"material.52100 hardened.youngs_modulus\"");
  ASSERT_NE(row, std::string::npos);
  const std::string cells = html.substr(row, html.find("</tr>", row) - row);
  const double E = read_gear_set(text_of("library_material"), "x")
                       .material.at("52100 hardened")
                       .youngs_modulus.value();
  const std::size_t value = cells.find("<td>") + 4;
  EXPECT_DOUBLE_EQ(std::stod(cells.substr(value)) * 1e9, E) << cells;
  EXPECT_NE(cells.find(" GPa</td>"), std::string::npos) << cells;
  EXPECT_NE(cells.find(">material library<"), std::string::npos) << cells;
  const auto& number = *require_material("52100 hardened").youngs_modulus;
  EXPECT_NE(cells.find("<td>" + std::string(enum_name(number.confidence)) + ", source " +
                       number.source + "</td>"),
            std::string::npos)
      << cells;
}

TEST(Report, BehaviourEveryNoteAndEquationIsThere) {
  const std::string text = text_of("cup_sections");
  const Report report = report_on(text);
  const std::string& notes = section(report, "notes").html;
  for (const Note& note : report.result.notes)
    EXPECT_NE(notes.find("data-code=\"" + note.code + "\""), std::string::npos) << note.code;
  // In addition to the notes of the result, the report has the notes of curve and sensitivity, each
  // once.
  EXPECT_GE(count(notes, "<li "), report.result.notes.size());
  const std::string& equations = section(report, "equations").html;
  for (const std::string& tag : report.result.equations)
    EXPECT_NE(equations.find("<li id=\"" + tag + "\"><b>" + tag + "</b> "), std::string::npos)
        << tag;
  EXPECT_GE(count(equations, "<li "), report.result.equations.size());
  // A title of the manual, docs/theory/FR.md.
  EXPECT_NE(equations.find("<b>FR-2</b> Added compliance<"), std::string::npos);
}

TEST(Report, ReferenceVerdictFollowsTheWorstNote) {
  // The crack of the solid shaft is far below its toughness; deeper and under more torque it
  // fractures.
  GearSet gear = read_gear_set(text_of("solid_shaft"), "x");
  const auto verdict = [&] { return make_report(gear, kProvenance, {}).verdict; };
  EXPECT_EQ(verdict().find("verdict bad"), std::string::npos);
  gear.load.torque *= 200;
  EXPECT_NE(verdict().find("verdict bad"), std::string::npos);
  EXPECT_NE(verdict().find(">Critical<"), std::string::npos);
  EXPECT_NE(verdict().find("fractures at this load"), std::string::npos);
}

TEST(Report, InputUnusableResultIsReportedWithItsReasonOnTop) {
  GearSet gear = test::article_gear();
  std::get<WallThroughCrack>(gear.flexspline->crack[0]).half_length = 30 * mm;
  const Report report = make_report(gear, kProvenance, {});
  ASSERT_FALSE(report.result.usable());
  EXPECT_NE(report.verdict.find("verdict bad"), std::string::npos);
  EXPECT_NE(report.verdict.find(">Cannot be told<"), std::string::npos);
  EXPECT_NE(report.verdict.find("compute so long a crack by strainwave fe"), std::string::npos);
  EXPECT_NO_THROW((void)parsed(report_html(report)));
}

TEST(Report, BehaviourWithoutGeometryThereIsASentenceInsteadOfACurve) {
  const Report article = report_on(text_of("article"));
  const std::string& why = section(article, "torsion").html;
  EXPECT_NE(why.find("no torsion curve"), std::string::npos);
  EXPECT_NE(why.find("wave_generator.bearing"), std::string::npos) << why;
  EXPECT_EQ(why.find("<svg"), std::string::npos);
  const Report cracked = report_on(text_of("cracked_size25"));
  const std::string& curve = section(cracked, "torsion").html;
  EXPECT_GE(count(curve, "<svg"), 2U);
  EXPECT_NE(curve.find(">with cracks<"), std::string::npos);
  EXPECT_NE(curve.find(">sound<"), std::string::npos);
  // The style rules of the plot apply only to the plot.
  EXPECT_EQ(curve.find("\ntext {"), std::string::npos);
  EXPECT_NE(curve.find(".plot text {"), std::string::npos);
}

TEST(Report, BehaviourMethodsOfTheArticleHaveAReportToo) {
  for (const Method method : {Method::as_printed, Method::repaired}) {
    const Report report = report_on(text_of("article"), method);
    EXPECT_NO_THROW((void)parsed(report_html(report)));
    EXPECT_EQ(report.result.method, method);
    EXPECT_NE(report.subtitle.find(enum_name(method)), std::string::npos);
    EXPECT_NE(section(report, "torsion").html.find("no torsion curve"), std::string::npos);
  }
}

TEST(Report, BehaviourToughnessGivesUtilisationWithALineAtOne) {
  const Report report = report_on(text_of("solid_shaft"));
  const std::string& html = section(report, "strength").html;
  const std::optional<double>& utilisation = report.result.strength.at(0).states.at(0).utilisation;
  ASSERT_TRUE(utilisation.has_value());
  bool bar = false;
  for (const Element& element : parsed("<x>" + html + "</x>"))
    if (element.name == "rect" && element.has("data-to")) {
      bar = true;
      EXPECT_NEAR(std::stod(element.at("data-to")), *utilisation, 1e-12);
    }
  EXPECT_TRUE(bar);
  EXPECT_NE(html.find("class=\"reference\""), std::string::npos);
  // Without a toughness the report states that it cannot judge.
  EXPECT_NE(
      section(report_on(text_of("article")), "intensities").html.find("give no fracture_toughness"),
      std::string::npos);
}

TEST(Report, BehaviourCracksBeyondCriticalStandOnTop) {
  const Report report = report_on(text_of("critical_crack"));
  const auto worst = std::ranges::find(report.result.strength, StrengthVerdict::fractures,
                                       &CrackStrength::verdict);
  ASSERT_NE(worst, report.result.strength.end());
  EXPECT_NE(report.verdict.find("verdict bad"), std::string::npos);
  EXPECT_NE(report.verdict.find("<code>" + worst->path + "</code>: "), std::string::npos);
  EXPECT_NE(report.verdict.find("cracks in their present state"), std::string::npos);
  const std::string& html = section(report, "strength").html;
  // A row for every state, a sentence for every crack, a bar for each under the given torque.
  std::size_t states = 0;
  std::size_t bars = 0;
  for (const CrackStrength& crack : report.result.strength) {
    states += crack.states.size();
    for (const StrengthState& state : crack.states)
      bars += state.utilisation && state.sense == crack.worst()->sense ? 1 : 0;
  }
  EXPECT_EQ(count(html, "<th scope=\"row\">T "), states);
  EXPECT_EQ(count(html, "</code>: "), report.result.strength.size());
  EXPECT_EQ(count(html, "<rect class=\"bar"), bars);
  EXPECT_NE(html.find(">line, hard_steel<"), std::string::npos);
  // If there is nothing to compare the cracks with, the report states this.
  EXPECT_NE(section(report_on(text_of("article")), "strength").html.find("Cannot tell"),
            std::string::npos);
  EXPECT_NE(report_on(text_of("article")).verdict.find("verdict care"), std::string::npos);
}

// The headline counts every crack, including cracks that cannot be assessed.
TEST(Report, BehaviourHeadlineCountsHoldingBreakingAndUnknownCracks) {
  const auto number_before = [](const std::string& text, const std::string& words) {
    const std::size_t end = text.find(words);
    if (end == std::string::npos) return std::string::npos;
    const std::size_t begin = text.find_last_not_of("0123456789", end - 1) + 1;
    return static_cast<std::size_t>(std::stoul(text.substr(begin, end - begin)));
  };
  std::size_t with_unknown = 0;
  for (const char* const name : {"critical_crack", "library_material", "solid_shaft"}) {
    const Report report = report_on(text_of(name));
    std::map<StrengthVerdict, std::size_t> n;
    double least = std::numeric_limits<double>::infinity();
    for (const CrackStrength& crack : report.result.strength) {
      ++n[crack.verdict];
      if (crack.verdict == StrengthVerdict::cannot_tell) continue;
      for (const StrengthState& state : crack.states)
        if (state.reserve && state.verdict != StrengthVerdict::cannot_tell)
          least = std::min(least, *state.reserve);
    }
    const std::size_t breaking = n[StrengthVerdict::fractures] + n[StrengthVerdict::collapses];
    const std::size_t at = report.verdict.find("<p>Strength at the given load: ");
    ASSERT_NE(at, std::string::npos) << name;
    const std::string line = report.verdict.substr(at, report.verdict.find("</p>", at) - at);
    EXPECT_EQ(number_before(line, " of "), n[StrengthVerdict::acceptable]) << line;
    EXPECT_EQ(number_before(line, " crack"), report.result.strength.size()) << line;
    EXPECT_EQ(number_before(line, " fracture"), breaking) << line;
    EXPECT_EQ(number_before(line, " cannot be told"), n[StrengthVerdict::cannot_tell]) << line;
    if (breaking > 0) {
      EXPECT_NE(report.verdict.find("verdict bad"), std::string::npos) << name;
    } else if (n[StrengthVerdict::cannot_tell] > 0) {
      EXPECT_EQ(report.verdict.find("verdict good"), std::string::npos) << name;
      ++with_unknown;
    }
    if (std::isfinite(least)) {
      const std::string label = "of the " +
                                std::to_string(n[StrengthVerdict::acceptable] + breaking) +
                                " assessed</dt><dd><b>";
      const std::size_t value = report.verdict.find(label);
      ASSERT_NE(value, std::string::npos) << report.verdict;
      EXPECT_NEAR(std::stod(report.verdict.substr(value + label.size())), least, 6e-3 * least);
    }
  }
  EXPECT_GT(with_unknown, 0U);
  EXPECT_NE(report_on(text_of("article"))
                .verdict.find("Strength: not assessed, because the file gives no toughness"),
            std::string::npos);
  EXPECT_NE(report_on(text_of("article"), Method::repaired)
                .verdict.find("not assessed, because the method repaired"),
            std::string::npos);
  // A sound drive has nothing to assess.
  GearSet sound = read_gear_set(text_of("solid_shaft"), "x");
  sound.output_shaft->crack.clear();
  EXPECT_EQ(make_report(sound, kProvenance, {}).verdict.find("Strength"), std::string::npos);
}

// The least reserve is that of the worse sense of torque, which it names.
TEST(Report, BehaviourLeastReserveIsOfBothSensesOfTorque) {
  std::set<std::string> senses;
  for (const double factor : {1.0, -1.0}) {
    GearSet gear = read_gear_set(text_of("critical_crack"), "x");
    gear.load.torque *= factor;
    const std::string verdict = make_report(gear, kProvenance, {.angles = 1, .draws = 2}).verdict;
    const std::size_t label = verdict.find("Least reserve on the load");
    ASSERT_NE(label, std::string::npos);
    const std::string cell = verdict.substr(label, verdict.find("</div>", label) - label);
    EXPECT_TRUE(cell.find("T &gt; 0") != std::string::npos ||
                cell.find("T &lt; 0") != std::string::npos ||
                cell.find("either sense") != std::string::npos)
        << cell;
    senses.insert(cell.substr(cell.find("<b>")));
  }
  // Reversing the given torque changes the given sense but not the worse sense.
  EXPECT_EQ(senses.size(), 1U);
}

TEST(Report, LimitNoiseAndSignedZerosAreShownAsZero) {
  for (const char* const name : {"article", "cracked_size25", "critical_crack"}) {
    const std::string html = report_html(report_on(text_of(name)));
    for (const char* const zero : {">−0<", ">−0 ", ">+0<", ">−0.0 %", "·10⁻¹⁷<", "·10⁻¹⁸<"})
      EXPECT_EQ(html.find(zero), std::string::npos) << name << ' ' << zero;
    EXPECT_EQ(html.find('`'), std::string::npos) << name;
  }
}

// Labels of bars of any length are complete and on the paper.
TEST(Report, BehaviourLabelsOfBarsFitOnThePaper) {
  for (const char* const name : {"cracked_size25", "critical_crack", "library_material"}) {
    const Report report = report_on(text_of(name));
    const std::string& html = section(report, "sensitivity").html;
    std::size_t labels = 0;
    for (const Element& element : parsed("<x>" + html + "</x>")) {
      if (element.name != "text" || !element.has("class")) continue;
      const std::string& style = element.at("class");
      const double size = style.find("small") == std::string::npos ? 3.1 : 2.7;
      const double width = 0.6 * size * static_cast<double>(element.text.size());
      const double x = std::stod(element.at("x"));
      if (style.ends_with("end")) {
        EXPECT_GE(x - width, 0) << element.text;
        ++labels;
      }
      if (style.ends_with("middle")) {
        EXPECT_GE(x - width / 2, 0) << element.text;
        EXPECT_LE(x + width / 2, 180) << element.text;
      }
    }
    EXPECT_GT(labels, 5U) << name;
  }
}

TEST(Report, CrosscheckElasticitiesAreThoseOfTheSensitivity) {
  const std::string text = text_of("article_scatter");
  const Report report = report_on(text);
  const Sensitivity s = sensitivity_of(read_gear_set(text, "x"));
  const std::string& html = section(report, "sensitivity").html;
  std::size_t output = 0;
  while (s.outputs.at(output).name != "cracked.positive.stiffness") ++output;
  // The longest bar is the largest elasticity.
  double largest = 0;
  for (const SensitivityInput& input : s.inputs)
    largest = std::max(largest, std::abs(input.influence[output].elasticity));
  double longest = 0;
  for (const Element& element :
       parsed("<x>" + html.substr(0, html.find("</figure>")) + "</figure></x>"))
    if (element.name == "rect")
      longest = std::max(longest, std::abs(std::stod(element.at("data-to"))));
  EXPECT_DOUBLE_EQ(longest, largest);
  EXPECT_NE(html.find("Scatter of the outputs"), std::string::npos);
  EXPECT_NE(html.find("of which 20 were evaluated"), std::string::npos);
  EXPECT_EQ(section(report_on(text_of("article")), "sensitivity").html.find("Scatter of"),
            std::string::npos);
  EXPECT_NE(section(report_on(text_of("article"), Method::repaired), "sensitivity")
                .html.find("no sensitivities"),
            std::string::npos);
}

TEST(Report, BehaviourAnInspectedDriveHasItsRisk) {
  const Report report = report_on(text_of("repaired_shaft"));
  ASSERT_NO_THROW((void)parsed(report_html(report)));
  const std::string html = section(report, "inspection").html;
  EXPECT_NE(html.find("<figure"), std::string::npos);
  EXPECT_NE(html.find("Probability of detection"), std::string::npos);
  EXPECT_NE(html.find("h apart: half of the time"), std::string::npos);
  EXPECT_NE(html.find("risk if it is the last"), std::string::npos);
  EXPECT_NE(html.find("expected cost of one drive"), std::string::npos);
  for (const ReportSection& one : report_on(text_of("inspected_shaft")).sections)
    EXPECT_NE(one.id, "inspection");
}

TEST(Report, BehaviourADriveWithADutyHasItsChaptersAndItsAnswers) {
  const Report report = report_on(text_of("growing_size25"));
  ASSERT_NO_THROW((void)parsed(report_html(report)));
  for (const char* const id : {"duty", "life", "growth", "stiffness-over-time"})
    EXPECT_NE(section(report, id).html.find("<figure"), std::string::npos) << id;
  EXPECT_NE(section(report, "duty").html.find("the average torque is"), std::string::npos);
  EXPECT_NE(section(report, "life").html.find("wave generator bearing"), std::string::npos);
  EXPECT_NE(section(report, "growth").html.find("flexspline.crack[1]"), std::string::npos);
  // The head of the report gives both answers.
  EXPECT_NE(report.verdict.find("Life of the parts, without cracks: ends by"), std::string::npos);
  EXPECT_NE(report.verdict.find("Growth of the cracks: The solution for flexspline.crack[1] ends"),
            std::string::npos);
  const Report without = report_on(text_of("article"));
  for (const char* const id : {"duty", "life", "growth", "stiffness-over-time"})
    for (const ReportSection& one : without.sections) EXPECT_NE(one.id, id);
  EXPECT_EQ(without.verdict.find("Life of the parts"), std::string::npos);
}

TEST(Report, BehaviourNoTextIsEscapedTwice) {
  for (const char* const name : {"growing_size25", "article", "cracked_size25"}) {
    const Report report = report_on(text_of(name));
    std::string html = report.verdict;
    for (const ReportSection& one : report.sections) html += one.html;
    for (const char* const twice : {"&amp;#39;", "&amp;lt;", "&amp;gt;", "&amp;quot;", "&amp;amp;"})
      EXPECT_EQ(html.find(twice), std::string::npos) << name << ": " << twice;
  }
}

TEST(Report, LimitADriveThatTheLibraryWasGivenWithoutATextHasOne) {
  const GearSet gear = test::article_gear();
  const Report report = make_report(gear, kProvenance, {});
  EXPECT_NE(section(report, "provenance").html.find("pitch_diameter = &quot;160 mm&quot;"),
            std::string::npos);
  EXPECT_NE(section(report, "inputs").html.find("160 mm"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

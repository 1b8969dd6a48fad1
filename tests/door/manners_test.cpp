// SPDX-License-Identifier: Apache-2.0
// What units, explain and diff answer, and in which units all commands answer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <tuple>

#include "door/answers.hpp"
#include "strainwave/command/exit_status.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/input_format.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/present/glossary.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using AnyJson = nlohmann::json;

Answer answer_in(std::string_view command, std::string_view example, std::string_view options,
                 std::string_view units, std::vector<std::string> columns = {}) {
  const Command& row = command_named(commands(), command);
  OptionValues values(row.options);
  values.set_from_json(options);
  return run(
      row, example.empty() ? nullptr : test::example_drives().at(std::string(example)), values, {},
      {},
      {.units = units.empty() ? AskedUnits() : AskedUnits(units), .columns = std::move(columns)});
}

std::string explained(const std::string& word) {
  return answer_in("explain", "", AnyJson{{"word", word}}.dump(), "").document("text");
}

// --- Units ---------------------------------------------------------------------------------------

TEST(AskedUnits, BehaviourDocumentsHaveTheUnitsAskedFor) {
  const Answer si = answer_in("stiffness", "article", "{}", "");
  const Answer asked = answer_in("stiffness", "article", "{}", "lbf*in/arcmin,um,arcsec");
  const double factor = parse_unit("lbf*in/arcmin").factor;
  const AnyJson one = AnyJson::parse(si.json())["result"]["intact"]["stiffness"];
  const AnyJson other = AnyJson::parse(asked.json())["result"]["intact"]["stiffness"];
  EXPECT_EQ(one["unit"], "N*m/rad");
  EXPECT_EQ(other["unit"], "lbf*in/arcmin");
  EXPECT_DOUBLE_EQ(other["value"].get<double>() * factor, one["value"].get<double>());
  EXPECT_EQ(other["relative_uncertainty"], one["relative_uncertainty"]);
  const std::string csv = asked.document("csv");
  EXPECT_NE(csv.find("\nintact.wind_up,33.5"), std::string::npos) << csv.substr(0, 800);
  EXPECT_NE(csv.find(",arcsec,"), std::string::npos);
  EXPECT_NE(csv.find(",lbf*in/arcmin,"), std::string::npos);
  EXPECT_EQ(csv.find(",N*m/rad,"), std::string::npos);
}

TEST(AskedUnits, BehaviourSiIsSiThroughout) {
  EXPECT_NE(answer_in("solve", "article",
                      R"({"vary": "output_shaft.crack[0].depth",
                          "target": "cracked.positive.stiffness_change=-1 %"})",
                      "si")
                .document("text")
                .find("output_shaft.crack[0].depth = 0.00335 m"),
            std::string::npos);
}

/// These commands show every value in the unit that was asked for, if one was asked for its
/// dimension.
TEST(AskedUnits, RegressionHeadingsTablesAndAxesHaveTheUnitsAskedFor) {
  constexpr std::string_view kUnits =
      "lbf*in,um,arcsec,lbf*in/arcsec,ksi,ksi*in^0.5,lbf,rad/(lbf*in)";
  struct Case {
    std::string command;
    std::string options;
    std::vector<std::string> documents;
  };
  for (const Case& of : std::vector<Case>{
           {"stiffness", "{}", {"text"}},
           {"torsion", R"({"draws": 3, "compare": true, "angles": 2})", {"text", "plot"}},
           {"sweep", R"({"vary": ["output_shaft.crack[0].depth=1000 um..2000 um:3"]})", {"plot"}},
           {"sweep",
            R"({"vary": ["output_shaft.crack[0].depth=1000 um..2000 um:3",
                         "output_shaft.length=40000 um..60000 um:3"]})",
            {"plot"}},
           {"report", "{}", {"html"}}}) {
    const Answer answer = answer_in(of.command, "cracked_size25", of.options, kUnits);
    for (const std::string& name : of.documents) {
      std::string text = answer.document(name);
      // A report shows the inputs as the file writes them.
      if (name == "html") {
        const std::size_t results = text.find("id=\"results\"");
        text = text.substr(results, text.find("id=\"notes\"") - results);
      }
      for (const std::string unit :
           {"N*m", "N·m", "arcmin]", " arcmin", " mm", "[mm", "MPa", "deg]"})
        EXPECT_EQ(text.find(unit), std::string::npos)
            << of.command << ' ' << name << ": "
            << text.substr(text.find(unit) < 60 ? 0 : text.find(unit) - 60, 120);
    }
  }
  const std::string text =
      answer_in("stiffness", "cracked_size25", "{}", "lbf*in,lbf*in/arcmin").document("text");
  EXPECT_NE(text.find("Load at the output: T = 424.8"), std::string::npos) << text.substr(0, 300);
  EXPECT_NE(text.find("K1, up to T1 = 123.91 lbf*in [lbf*in/arcmin]"), std::string::npos);
}

TEST(AskedUnits, BehaviourAUnitThatNothingHasIsKnown) {
  const AskedUnits units("mm,kg,rpm");
  const AskedUnits copy = units;
  EXPECT_EQ(units.unused(), (std::vector<std::string>{"mm", "kg", "rpm"}));
  ASSERT_TRUE(copy.of({}, "m"));
  EXPECT_EQ(units.unused(), (std::vector<std::string>{"kg", "rpm"}));
  EXPECT_FALSE(copy.of({}, "N"));
  EXPECT_TRUE(AskedUnits("si").unused().empty());
}

TEST(AskedUnits, BehaviourAnAnswerHasTheUnitThatWasTyped) {
  const Answer solved = answer_in("solve", "article",
                                  R"({"vary": "output_shaft.crack[0].depth=0.1 mm..8000 um",
                                      "target": "cracked.positive.stiffness=6e5 N*m/rad"})",
                                  "");
  const std::string text = solved.document("text");
  EXPECT_NE(text.find("cracked.positive.stiffness = 600000 N*m/rad"), std::string::npos) << text;
  EXPECT_NE(text.find("searched from 100 um to 8000 um; at present 100 um"), std::string::npos)
      << text;
  const std::string required =
      answer_in("require", "article",
                R"({"requirements": ["intact.stiffness >= 1000 lbf*in/arcmin"]})", "")
          .document("text");
  EXPECT_NE(required.find("intact.stiffness >= 1000 lbf*in/arcmin"), std::string::npos) << required;
  EXPECT_NE(required.find("1584.58 lbf*in/arcmin"), std::string::npos) << required;
  const Answer swept = answer_in(
      "sweep", "article", R"({"vary": ["output_shaft.crack[0].depth=0.4 mm..13.5 mm:2"]})", "");
  const std::string csv = swept.document("csv");
  EXPECT_TRUE(csv.starts_with("output_shaft.crack[0].depth [mm],")) << csv.substr(0, 60);
  EXPECT_NE(csv.find("\n0.4,"), std::string::npos);
  // The refused point speaks of millimetres too.
  EXPECT_NE(csv.find("output_shaft.crack[0].depth = 13.5 mm violates"), std::string::npos);
  EXPECT_EQ(AnyJson::parse(swept.json())["result"]["columns"][0]["unit"], "m");
}

TEST(AskedUnits, IdentityColumnsOfJsonAreConvertedWithTheirUnit) {
  constexpr std::string_view kSweep = R"({"vary": ["output_shaft.crack[0].depth=1 mm..2 mm:2"]})";
  const AnyJson si = AnyJson::parse(answer_in("sweep", "article", kSweep, "").json());
  const AnyJson mm = AnyJson::parse(answer_in("sweep", "article", kSweep, "mm").json());
  const AnyJson& one = si["result"]["columns"][0];
  const AnyJson& other = mm["result"]["columns"][0];
  EXPECT_EQ(other["unit"], "mm");
  EXPECT_EQ(other["values"], AnyJson::parse(R"({"values": [1, 2]})"));
  EXPECT_EQ(one["values"], AnyJson::parse(R"({"values": [0.001, 0.002]})"));
  // Another column keeps its unit.
  EXPECT_EQ(si["result"]["columns"][1], mm["result"]["columns"][1]);
}

TEST(AskedUnits, BehaviourColumnsOfATableInTheOrderAsked) {
  const Answer answer =
      answer_in("torsion", "catalogue_size25", R"({"draws": 0})", "arcmin", {"twist", "torque"});
  std::istringstream csv(answer.document("csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "twist [arcmin],torque [N*m]");
  EXPECT_EQ(test::broken_rule([&] {
              return answer_in("torsion", "catalogue_size25", R"({"draws": 0})", "", {"twits"})
                  .document("csv");
            }),
            "columns: twits is not a column of this table; did you mean twist?");
}

TEST(AskedUnits, InputUnitsThatCannotBeAskedForAreRefused) {
  const auto refusal = [](std::string_view units) {
    return test::broken_rule([&] { return AskedUnits(units); });
  };
  EXPECT_EQ(refusal("mm,in"), "units: mm and in have the same dimension; choose one of them");
  EXPECT_EQ(refusal("%"),
            "units: % is a unit of pure numbers, which the answer never converts; leave it out");
  EXPECT_NE(refusal("furlong").find("units: \"furlong\" has the unknown unit"), std::string::npos);
}

TEST(UnitsCommand, IdentityEveryUnitIsListedWithWhatTheReaderMakesOfIt) {
  const AnyJson result = AnyJson::parse(answer_in("units", "", "{}", "").json())["result"]["units"];
  const AnyJson units = result["unit"]["values"];
  const AnyJson factors = result["factor"]["values"];
  const AnyJson si = result["si"]["values"];
  EXPECT_GE(units.size(), 27U);
  for (std::size_t i = 0; i < units.size(); ++i)
    EXPECT_DOUBLE_EQ(
        parse_quantity("x", "1 " + units[i].get<std::string>(), si[i].get<std::string>()),
        factors[i].get<double>())
        << units[i];
  const std::string text = answer_in("units", "", "{}", "").document("text");
  EXPECT_NE(text.find("material.<name>.fatigue.roughness and"), std::string::npos) << text;
}

// --- Explain -------------------------------------------------------------------------------------

TEST(Explain, BehaviourEachKindOfWordIsExplained) {
  for (const auto& [word, kind, says] :
       std::vector<std::tuple<std::string, std::string, std::string>>{
           {"output_shaft.crack[0].depth", "field of the input", "in m; > 0"},
           {"material.steel.yield_strength", "field of the input", "in Pa"},
           {"half_length", "field of the input", "flexspline.crack[].half_length"},
           {"ksi", "unit", "1 ksi = 6894757.29316836 Pa"},
           {"N*m/arcmin", "unit", "a product of units"},
           {"crack.thick_wall", "note", "the wall is thicker than a tenth of its radius"},
           {"FR-9", "equation of the theory manual", "Shell correction"},
           {"6", "exit status", "cannot be told within the uncertainty"},
           {"17-4PH H900", "material", "material show '17-4PH H900'"},
           {"1.4542 H900", "material", "another name of 17-4PH H900"},
           {"plate-surface", "stress intensity solution", "sif show plate-surface"},
           {"cracked.positive.stiffness", "output of", "in N*m/rad"},
           {"stiffness", "command", "strainwave stiffness --help"},
           {"--vary", "option of sweep", "FROM..TO"},
           {"all_sets", "option of validate", "leave-one-size-out"},
           // terms and symbols of the glossary
           {"flexspline", "term of the glossary", "the thin-walled gear wheel"},
           {"Circular Spline", "term of the glossary", "it does not rotate"},
           {"K_HD", "term of the glossary", "inverse of the sum of compliances of the members"},
           {"pressed", "term of the glossary", "the load presses the faces together"},
           {"scatter", "term of the glossary", "an input ([[scatter]])"},
           // tables, and kinds of crack
           {"[[flexspline.crack]]", "table of the input", "cracks of wall, diaphragm and rim"},
           {"flexspline.diaphragm.profile", "table of the input", "fields: radius, thickness"},
           {"rating", "table of the input", "the maker's torques"},
           {"diaphragm_arc", "kind of [[flexspline.crack]]", "along an arc round the boss"},
           {"rim-axial", "kind of [[flexspline.crack]]", "fields: depth, position"},
           {"as-printed", "value of --method", "as-printed, repaired, corrected"},
           {"ring_bending", "value of wave_generator.crack[].stress_driver",
            "source of the stress"},
           {"pair_compliance", "factor of calibrate --factors", "compliance of a pair of teeth"},
           {"curve", "group of outputs of stiffness", "curve: group of outputs"},
           {"intact", "group of outputs of stiffness", "fields: compliance, stiffness, wind_up"},
           {"over_turn", "group of outputs of stiffness", "fields: mean, softest"},
           {"curve.positive.over_turn.mean", "group of outputs of stiffness", "fields: K1, K2, K3"},
           {"sif", "first word of commands", "sif eval"},
           {"fr-9", "equation of the theory manual", "Shell correction"}}) {
    const std::string text = explained(word);
    EXPECT_NE(text.find(kind), std::string::npos) << word << '\n' << text;
    std::string joined = text;
    for (std::size_t at = joined.find('\n'); at != std::string::npos; at = joined.find('\n', at))
      joined.replace(
          at, 1 + std::min(joined.find_first_not_of(' ', at + 1), joined.size()) - at - 1, " ");
    EXPECT_NE(joined.find(says), std::string::npos) << word << '\n' << joined;
    EXPECT_LE(std::ranges::count(text, '\n'), 50) << word;
  }
}

TEST(Explain, InputAnUnknownWordGetsTheNearest) {
  EXPECT_EQ(test::broken_rule([] { return explained("stifness"); }),
            "word: stifness is unknown to strainwave; did you mean stiffness?");
  EXPECT_EQ(test::broken_rule([] { return explained("crack.thick_walls"); }),
            "word: crack.thick_walls is unknown to strainwave; did you mean "
            "crack.thick_wall?");
  // Part of a word finds the whole word.
  EXPECT_EQ(test::broken_rule([] { return explained("intensity_fact"); }),
            "word: intensity_fact is unknown to strainwave; did you mean stress intensity factor?");
  EXPECT_EQ(test::broken_rule([] { return explained(" "); }),
            "word: is empty; give a word, such as torque");
}

TEST(Explain, IdentityEveryListedNoteAndExitStatusIsExplained) {
  std::ifstream file(STRAINWAVE_TEST_DATA "/note_codes.txt");
  int n_codes = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::string code = line.substr(0, line.find(" | "));
    EXPECT_NO_THROW((void)explained(code)) << code;
    ++n_codes;
  }
  EXPECT_GT(n_codes, 80);
  for (const auto& [status, meaning] : kExitStatuses)
    EXPECT_NE(explained(std::to_string(static_cast<int>(status))).find("exit status"),
              std::string::npos);
}

TEST(Explain, IdentityEveryTermTableAndKindIsExplained) {
  for (const GlossaryTerm& term : glossary())
    EXPECT_NE(explained(std::string(term.term)).find("term of the glossary"), std::string::npos)
        << term.term;
  EXPECT_GT(glossary().size(), 70U);
  for (const InputTable& table : input_tables()) {
    EXPECT_NE(explained(table.head).find("table of the input"), std::string::npos) << table.head;
    if (!table.kind.empty()) {
      EXPECT_NE(explained(std::string(table.kind)).find(": kind of "), std::string::npos)
          << table.kind;
    }
  }
  // The terms in plain letters contain no markup of the page.
  for (const GlossaryTerm& term : glossary())
    for (const std::string_view text : {term.term, term.meaning, term.symbol, term.unit})
      EXPECT_EQ(text.find_first_of("\\$|`{}<>"), std::string_view::npos) << text;
}

// --- Diff ----------------------------------------------------------------------------------------

/// The article's drive with one text in place of another.
std::string article_with(const std::string& from, const std::string& to) {
  std::string text = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Answer diff(const std::string& first, const std::string& second, double coverage = 1) {
  return test::run_command("diff", nullptr,
                           AnyJson{{"first", "a"}, {"second", "b"}, {"coverage", coverage}}.dump(),
                           {{"a", first}, {"b", second}});
}

AnyJson diff_result(const Answer& answer) { return AnyJson::parse(answer.json())["result"]; }

/// The difference of an output, among those that count and those that do not.
AnyJson difference_of(const AnyJson& result, const std::string& output) {
  for (const char* const group : {"outputs", "within_uncertainty", "uncertainty_not_stated"})
    for (const AnyJson& one : result[group])
      if (one["output"] == output) return one;
  ADD_FAILURE() << output;
  return {};
}

TEST(Diff, IdentityADriveDoesNotDifferFromItself) {
  const std::string text = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  const AnyJson result = diff_result(diff(text, text));
  EXPECT_TRUE(result["inputs"].empty());
  EXPECT_TRUE(result["outputs"].empty());
  EXPECT_TRUE(result["within_uncertainty"].empty());
  EXPECT_GT(result["equal"].get<int>(), 40);
}

/// All outputs of `stiffness` by name.
std::map<std::string, Quantity> stiffness_outputs(const std::string& text) {
  std::map<std::string, Quantity> named;
  const Answer answer = test::run_command("stiffness", read_drive(text, "x.toml"));
  OutputWalk walk([&](const std::string& name, const Quantity& q) { named[name] = q; });
  answer.visit(walk);
  return named;
}

/// The errors of (ST-16) in the difference of the sound stiffness of two drives whose shafts
/// differ, written out for three members [(N*m/rad)^2].
double variance_of_members(const std::map<std::string, Quantity>& a,
                           const std::map<std::string, Quantity>& b) {
  const double K_a = a.at("intact.stiffness").value;
  const double K_b = b.at("intact.stiffness").value;
  double variance = 0.0;
  for (const std::string member : {"wave_generator", "flexspline"}) {
    const Quantity& c = a.at("intact.compliance." + member);
    variance += std::pow(*c.relative_uncertainty * c.value * (K_b * K_b - K_a * K_a), 2);
  }
  for (const auto* const side : {&a, &b}) {
    const Quantity& c = side->at("intact.compliance.output_shaft");
    const double K = side->at("intact.stiffness").value;
    variance += std::pow(*c.relative_uncertainty * c.value * K * K, 2);
  }
  return variance;
}

TEST(Diff, ReferenceASharedErrorCancelsByST19) {
  // Only the shaft differs, so the errors of wave generator, flexspline and the missing compliance
  // are the same in both, (ST-19).
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  const std::string second = article_with("length = \"200 mm\"", "length = \"150 mm\"");
  const AnyJson result = diff_result(diff(first, second));
  ASSERT_EQ(result["inputs"].size(), 1U);
  EXPECT_EQ(result["inputs"][0]["path"], "output_shaft.length");
  const auto a = stiffness_outputs(first);
  const auto b = stiffness_outputs(second);
  const double K_a = a.at("intact.stiffness").value;
  const double K_b = b.at("intact.stiffness").value;
  const double left = 4 * (a.at("intact.compliance.wave_generator").value +
                           a.at("intact.compliance.flexspline").value);
  const double in_drives = 1 / (1 / K_b + left) - 1 / (1 / K_a + left);
  const AnyJson difference = difference_of(result, "intact.stiffness");
  const test::Reference reference{
      .value = std::hypot(std::sqrt(variance_of_members(a, b)), in_drives - (K_b - K_a)),
      .unit = "N*m/rad",
      .relative_tolerance = 1e-12,
      .source = "the formula (ST-19), written out for three members",
      .tolerance_is = "rounding"};
  test::expect_reference(difference["uncertainty"].get<double>(), reference);
  EXPECT_DOUBLE_EQ(difference["difference"].get<double>(), K_b - K_a);
  // Without what the drives share, the difference would be lost in their uncertainties.
  const double apart = std::hypot(*a.at("intact.stiffness").relative_uncertainty * K_a,
                                  *b.at("intact.stiffness").relative_uncertainty * K_b);
  EXPECT_LT(difference["uncertainty"].get<double>(), apart);
  // The missing compliance is in series with the shaft, so the compliances differ only by those of
  // the shafts.
  const AnyJson compliance = difference_of(result, "intact.compliance.total");
  EXPECT_NEAR(
      compliance["uncertainty"].get<double>() /
          difference_of(result, "intact.compliance.output_shaft")["uncertainty"].get<double>(),
      1, 1e-12);
}

/// The drive of examples/cracked_size25.toml with another shaft.
std::string with_shaft_of_40_mm(std::string text) {
  const std::string diameter = "outer_diameter = \"30 mm\"";
  return text.replace(text.find(diameter), diameter.size(), "outer_diameter = \"40 mm\"");
}

TEST(Diff, CrosscheckTheCoupledDrivesDifferWithinTheUncertaintyByST19) {
  // A thicker shaft changes the sum about ten times as much as K1 of the drive.  The second road is
  // the command torsion, which solves each drive by itself.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::string second = with_shaft_of_40_mm(first);
  const AnyJson result = diff_result(diff(first, second));
  const auto curve = [](const std::string& text) {
    return AnyJson::parse(
        test::run_command("torsion", read_drive(text, "x.toml"), R"({"draws": 0})")
            .json())["result"];
  };
  const AnyJson a = curve(first);
  const AnyJson b = curve(second);
  for (const std::string sense : {"positive", "negative"}) {
    const AnyJson sum = difference_of(result, "cracked." + sense + ".stiffness");
    for (const std::string K : {"K1", "K2", "K3"}) {
      const double coupled =
          b[sense][K]["value"].get<double>() - a[sense][K]["value"].get<double>();
      EXPECT_LE(std::abs(sum["difference"].get<double>() - coupled),
                sum["uncertainty"].get<double>())
          << sense << ' ' << K;
    }
  }
  const auto x = stiffness_outputs(first);
  const auto y = stiffness_outputs(second);
  const double by_sum = y.at("intact.stiffness").value - x.at("intact.stiffness").value;
  const double by_drive = y.at("curve.intact.K1").value - x.at("curve.intact.K1").value;
  EXPECT_GT(by_sum, 10 * by_drive);
  test::expect_reference(
      difference_of(result, "intact.stiffness")["uncertainty"].get<double>(),
      {.value =
           std::hypot(std::sqrt(variance_of_members(x, y)),
                      by_sum - by_drive + *x.at("curve.intact.K1").relative_uncertainty * by_drive),
       .unit = "N*m/rad",
       .relative_tolerance = 1e-9,
       .source = "the formula (ST-19), written out; K1 is the farthest of K1, K2, K3",
       .tolerance_is = "rounding of the equilibrium"});
}

TEST(Diff, LimitOnlyOneCoupledDriveIsSolvedByST19) {
  // All members have another material, and one drive lacks the mesh, so no part is the same.  The
  // variances of both sides add: the distance to the coupled drive for one side, and the estimate
  // for the other (ST-18).
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  std::string second = with_shaft_of_40_mm(first);
  const std::size_t mesh = second.find("[mesh]");
  second.erase(mesh, second.find("[output_shaft]") - mesh);
  const std::size_t modulus = second.find("206 GPa");
  ASSERT_NE(modulus, std::string::npos);
  second.replace(modulus, 3, "207");
  const AnyJson result = diff_result(diff(first, second));
  const auto x = stiffness_outputs(first);
  const auto y = stiffness_outputs(second);
  EXPECT_TRUE(x.contains("curve.intact.K1"));
  EXPECT_FALSE(y.contains("curve.intact.K1"));
  for (const std::string output :
       {"intact.stiffness", "cracked.positive.compliance.total", "cracked.negative.wind_up",
        "cracked.positive.stiffness_change"}) {
    const Quantity& a = x.at(output);
    const Quantity& b = y.at(output);
    EXPECT_NEAR(
        difference_of(result, output)["uncertainty"].get<double>() /
            std::hypot(*a.relative_uncertainty * a.value, *b.relative_uncertainty * b.value),
        1, 1e-9)
        << output;
  }
}

/// The text of examples/cracked_size25.toml with one piece replaced.
std::string cracked_with(const std::string& from, const std::string& to) {
  std::string text = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Diff, ReferenceTheErrorOfTheCoupledDriveCancelsByST20) {
  // (ST-20) is written out for four parts, of which none, one, two or all differ.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  std::string two = cracked_with("flank_angle = \"22 deg\"", "flank_angle = \"21 deg\"");
  two.replace(two.find("support = 0.5"), 13, "support = 0.6");
  const auto a = stiffness_outputs(first);
  for (const auto& [second, differ] :
       {std::pair{with_shaft_of_40_mm(first), 0},
        {cracked_with("thickness = \"0.762 mm\"", "thickness = \"0.8 mm\""), 0},
        {cracked_with("T2 = \"48 N*m\"", "T2 = \"50 N*m\""), 0},
        {cracked_with("support = 0.5", "support = 0.6"), 1},
        {cracked_with("wall_thickness = \"0.755 mm\"\nlength = \"9.5",
                      "wall_thickness = \"0.76 mm\"\nlength = \"9.5"),
         1},
        {two, 2},
        {cracked_with("radial_displacement = \"0.3175 mm\"", "radial_displacement = \"0.31 mm\""),
         4}}) {
    const AnyJson result = diff_result(diff(first, second));
    const auto b = stiffness_outputs(second);
    for (const std::string output : {"curve.intact.K1", "curve.positive.K3"}) {
      const double u_a = *a.at(output).relative_uncertainty * a.at(output).value;
      const double u_b = *b.at(output).relative_uncertainty * b.at(output).value;
      const double expected = std::sqrt((4 - differ) / 4.0 * std::pow(u_b - u_a, 2) +
                                        differ / 4.0 * (u_a * u_a + u_b * u_b));
      if (u_a == u_b && differ == 0) continue;  // the same output
      EXPECT_NEAR(difference_of(result, output)["uncertainty"].get<double>() / expected, 1, 1e-9)
          << output << ' ' << differ;
    }
  }
}

TEST(Diff, BehaviourWhatACrackChangesHasNoStatedUncertaintyByST20) {
  // The tooth loses more stiffness.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const AnyJson deeper =
      diff_result(diff(first, cracked_with("stiffness_loss = 0.5", "stiffness_loss = 0.9")));
  for (const std::string output : {"curve.positive.K1", "curve.negative.K3",
                                   "curve.positive.wind_up", "curve.negative.over_turn.mean.K2"}) {
    const AnyJson difference = difference_of(deeper, output);
    EXPECT_NE(difference["difference"], 0) << output;
    EXPECT_FALSE(difference.contains("uncertainty")) << output;
    EXPECT_EQ(difference["standing"], "not stated") << output;
  }
  // A crack that only one of both has differs too, and the outputs of the sound drive keep theirs.
  const std::string shaft = with_shaft_of_40_mm(first);
  const AnyJson without = diff_result(diff(
      first, shaft.substr(0, shaft.find("[[output_shaft")) + shaft.substr(shaft.find("[rating]"))));
  EXPECT_FALSE(difference_of(without, "curve.positive.K1").contains("uncertainty"));
  EXPECT_TRUE(difference_of(without, "curve.intact.K1").contains("uncertainty"));
  EXPECT_TRUE(
      difference_of(diff_result(diff(first, shaft)), "curve.positive.K1").contains("uncertainty"));
}

TEST(Diff, IdentityLimitsAndFrictionMakeNoPartDifferent) {
  // These fields enter neither K nor a stress intensity, so the errors of the parts stay shared.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::string shaft = with_shaft_of_40_mm(first);
  const auto compared = [&](const std::string& from, const std::string& to) {
    std::string second = shaft;
    const std::size_t at = second.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return diff_result(diff(first, second.replace(at, from.size(), to)));
  };
  const AnyJson expected = diff_result(diff(first, shaft));
  const std::string modulus = "youngs_modulus = \"206 GPa\"\n";
  for (const auto& [from, to] :
       {std::pair{modulus, modulus + "fracture_toughness = \"60 MPa*m^0.5\"\n"},
        {modulus, modulus + "yield_strength = \"900 MPa\"\n"},
        {modulus, modulus + "ultimate_strength = \"1000 MPa\"\n"},
        {std::string("ball_count = 23\n"),
         std::string("ball_count = 23\nrolling_friction = 0.002\n")},
        {std::string("[wave_generator.bearing.outer_ring]\n"),
         std::string("[wave_generator.bearing.outer_ring]\nfriction_coefficient = 0.2\n")},
        {std::string("flank_angle = \"22 deg\"\n"),
         std::string("flank_angle = \"22 deg\"\nfriction_coefficient = 0.2\n")}}) {
    const AnyJson result = compared(from, to);
    EXPECT_EQ(result["inputs"].size(), expected["inputs"].size() + 1) << to;
    for (const std::string output :
         {"curve.intact.K1", "curve.positive.K3", "curve.negative.wind_up", "intact.stiffness",
          "cracked.positive.wind_up", "cracked.negative.stiffness_change"})
      EXPECT_EQ(difference_of(result, output)["uncertainty"],
                difference_of(expected, output)["uncertainty"])
          << output << ' ' << to;
  }
  // Nor do tolerances, from which nothing is drawn here.
  EXPECT_EQ(difference_of(compared("[rating]\n", "[tolerance]\ngrade = 7\n\n[rating]\n"),
                          "curve.intact.K1")["uncertainty"],
            difference_of(expected, "curve.intact.K1")["uncertainty"]);
  // The modulus does.
  EXPECT_GT(difference_of(compared("206 GPa", "206.001 GPa"), "curve.intact.K1")["uncertainty"],
            difference_of(expected, "curve.intact.K1")["uncertainty"]);
}

TEST(Diff, ReferenceTheErrorOfAStressIntensityByST19) {
  // Both drives share the error of a stress intensity if the crack and its member are the same;
  // otherwise the variances of both add.  A utilisation is a stress intensity over a limit, so its
  // error is shared if only the limit differs.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/critical_crack.toml");
  const std::string K = "flexspline.crack[0].stress_intensity.largest.K_I";
  const std::string utilisation = "flexspline.crack[0].strength.utilisation";
  const auto a = stiffness_outputs(first);
  for (const auto& [from, to, output, shared] :
       {std::tuple{"half_length = \"5 mm\"", "half_length = \"4 mm\"", K, false},
        {"wall_thickness = \"0.9 mm\"", "wall_thickness = \"1 mm\"", K, false},
        {"fracture_toughness = \"15 MPa", "fracture_toughness = \"20 MPa", utilisation, true},
        {"fracture_toughness = \"15 MPa", "fracture_toughness = \"12 MPa", utilisation, true}}) {
    std::string second = first;
    const std::size_t at = second.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    second.replace(at, std::string_view(from).size(), to);
    const auto b = stiffness_outputs(second);
    const double u_a = *a.at(output).relative_uncertainty * a.at(output).value;
    const double u_b = *b.at(output).relative_uncertainty * b.at(output).value;
    const double expected = shared ? std::abs(u_b - u_a) : std::hypot(u_a, u_b);
    EXPECT_NEAR(
        difference_of(diff_result(diff(first, second)), output)["uncertainty"].get<double>() /
            expected,
        1, 1e-9)
        << to;
  }
}

TEST(Diff, IdentityFieldsOutsideTheModelMakeNoPartDifferent) {
  // (ST-20) counts the inputs of a part.  A name, a scatter, a range and a torque that only limits
  // the load belong to no part, so all errors of the coupled drive stay shared.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::string shaft = with_shaft_of_40_mm(first);
  const auto compared = [&](const std::string& from, const std::string& to) {
    std::string second = shaft;
    const std::size_t at = second.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return diff_result(diff(first, second.replace(at, from.size(), to)));
  };
  const AnyJson expected = diff_result(diff(first, shaft));
  const std::string rated = "rated_torque = \"87 N*m\"\n";
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"every place\"", "another place\""},
        {rated, "rated_torque = \"88 N*m\"\n"},
        {rated, rated + "\n[[scatter]]\npath = \"mesh.flank_angle\"\n"
                        "relative_standard_deviation = 0.01\n"},
        {rated, rated + "\n[[range]]\npath = \"mesh.flank_angle\"\nlower = \"21 deg\"\n"
                        "upper = \"23 deg\"\n"}}) {
    const AnyJson result = compared(from, to);
    EXPECT_GT(result["inputs"].size(), expected["inputs"].size()) << to;
    for (const std::string output :
         {"curve.intact.K1", "curve.positive.K3", "curve.negative.wind_up", "intact.stiffness",
          "cracked.positive.wind_up"})
      EXPECT_EQ(difference_of(result, output)["uncertainty"],
                difference_of(expected, output)["uncertainty"])
          << output << ' ' << to;
  }
}

TEST(Diff, BehaviourStiffnessAndWindUpComeFirstEvenWhereTheyAreTheSame) {
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const auto listed = [](const AnyJson& result) {
    std::map<std::string, std::string> standing;
    for (const AnyJson& one : result["stiffness"]) standing[one["output"]] = one["standing"];
    return standing;
  };
  const auto same = listed(diff_result(diff(first, first)));
  EXPECT_EQ(same.size(), 8U);
  for (const std::string sense : {"positive", "negative"})
    for (const std::string name : {"K1", "K2", "K3", "wind_up"})
      EXPECT_EQ(same.at(fmt::format("curve.{}.{}", sense, name)), "same");
  const Answer stiffer = diff(first, cracked_with("support = 0.5", "support = 0.6"));
  EXPECT_EQ(listed(diff_result(stiffer)).at("curve.positive.K1"), "within");
  const std::string text = stiffer.document("text");
  EXPECT_LT(text.find("curve.positive.K1"), text.find("Other outputs that differ"));
  EXPECT_EQ(text.find("curve.positive.K1 "), text.rfind("curve.positive.K1 "));
  EXPECT_NE(stiffer.document("csv").find("curve.positive.K1,within uncertainty,"),
            std::string::npos);
  // Without the coupled drive, the sum comes first; for torsion, its own stiffnesses come first.
  const std::string article = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  EXPECT_TRUE(listed(diff_result(diff(article, article))).contains("cracked.negative.wind_up"));
  const std::string torsion =
      test::run_command("torsion", read_drive(first, "x.toml"), R"({"draws": 0})").json();
  EXPECT_TRUE(listed(diff_result(diff(torsion, torsion))).contains("negative.K3"));
}

TEST(Diff, BehaviourStatesOfACrackAreNamedInWords) {
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/critical_crack.toml");
  std::string second = first;
  const std::string torque = "torque = \"600 N*m\"";
  ASSERT_NE(second.find(torque), std::string::npos);
  second.replace(second.find(torque), torque.size(), "torque = \"700 N*m\"");
  const Answer answer = diff(first, second);
  EXPECT_NE(answer.document("text").find("flexspline.crack[0], T > 0, with the assembly: K_load"),
            std::string::npos)
      << answer.document("text");
  EXPECT_NE(difference_of(diff_result(answer),
                          "flexspline.crack[0].strength.states[T > 0, load alone].K"),
            AnyJson());
}

TEST(Diff, BehaviourWithoutAStatedUncertaintyIsAListOfItsOwn) {
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  std::string second = first;
  const std::string depth = "kind = \"annular\"\ndepth = \"2 mm\"";
  second.replace(second.find(depth), depth.size(), "kind = \"annular\"\ndepth = \"3 mm\"");
  const Answer answer = diff(first, second);
  const AnyJson result = diff_result(answer);
  EXPECT_FALSE(result["uncertainty_not_stated"].empty());
  for (const AnyJson& output : result["uncertainty_not_stated"])
    EXPECT_FALSE(output.contains("uncertainty")) << output;
  for (const char* const group : {"outputs", "within_uncertainty"})
    for (const AnyJson& output : result[group])
      EXPECT_TRUE(output.contains("uncertainty")) << output;
  const std::string text = answer.document("text");
  const std::size_t heading =
      text.find("\nOther outputs that differ without a stated uncertainty\n");
  ASSERT_NE(heading, std::string::npos) << text;
  EXPECT_GT(text.find("curve.positive.change.K1"), heading);
  EXPECT_NE(answer.document("csv").find("curve.positive.change.K1,uncertainty not stated,"),
            std::string::npos);
}

TEST(Diff, BehaviourTheContentOfATableCounts) {
  const std::string drive = test::contents(STRAINWAVE_EXAMPLES "/tabulated_crack.toml");
  const std::string table = test::contents(STRAINWAVE_EXAMPLES "/tables/through_45.csv");
  const auto compared = [&](const std::string& second_table, const std::string& first) {
    const Command& row = command_named(commands(), "diff");
    OptionValues values(row.options);
    values.set_from_json(R"({"first": "a", "second": "b"})");
    return diff_result(run(row, nullptr, values, {{"a", first}, {"b", drive}}, {},
                           {.beside = [&](const std::string& name) {
                             return Attachments(Attachments::Texts{
                                 {"tables/through_45.csv", name == "b" ? second_table : table}});
                           }}));
  };
  EXPECT_TRUE(compared(table, drive)["inputs"].empty());
  const std::size_t line = table.find('\n') + 1;
  const AnyJson result =
      compared(table.substr(0, line) + "# a remark: another\n" + table.substr(line), drive);
  ASSERT_EQ(result["inputs"].size(), 1U);
  EXPECT_EQ(result["inputs"][0]["path"], "flexspline.crack[0].compliance_table");
  EXPECT_EQ(result["inputs"][0]["first"], "tables/through_45.csv");
  EXPECT_EQ(result["inputs"][0]["second"], "tables/through_45.csv with another content");
  // A result does not contain its table, so the program cannot tell whether the crack is the same.
  const std::string with_shaft =
      drive +
      "\n[output_shaft]\nmaterial = \"steel\"\nouter_diameter = \"40 mm\"\nlength = \"40 mm\"\n";
  const std::string saved =
      test::run_command(
          "stiffness",
          read_drive(with_shaft, "x.toml",
                     Attachments(Attachments::Texts{{"tables/through_45.csv", table}})))
          .json();
  const auto uncertainty = [&](const std::string& first) {
    return difference_of(compared(table, first), "cracked.positive.stiffness_change")["uncertainty"]
        .get<double>();
  };
  EXPECT_GT(uncertainty(saved), 1.01 * uncertainty(with_shaft));
}

TEST(Diff, LimitOfOneDriveTheUncertaintyIsItsOwn) {
  // The loads differ, so no error is shared and the variances of both sides add (ST-19); the load
  // affects the wind-up only.
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  const AnyJson result =
      diff_result(diff(first, article_with("torque = \"100 N*m\"", "torque = \"200 N*m\"")));
  const AnyJson difference = difference_of(result, "intact.wind_up");
  const Answer answer = test::run_on_example("stiffness", "article");
  double u = 0.0;
  OutputWalk walk([&](const std::string& name, const Quantity& q) {
    if (name == "intact.wind_up") u = *q.relative_uncertainty;
  });
  answer.visit(walk);
  const auto a = difference["first"].get<double>();
  const auto b = difference["second"].get<double>();
  EXPECT_NEAR(difference["uncertainty"].get<double>() / (u * std::hypot(a, b)), 1, 1e-12);
}

TEST(Diff, BehaviourADeeperCrackIsTold) {
  const Answer answer = diff(test::contents(STRAINWAVE_EXAMPLES "/article.toml"),
                             article_with("kind = \"annular\"\ndepth = \"0.1 mm\"",
                                          "kind = \"annular\"\ndepth = \"4 mm\""));
  const std::string text = answer.document("text");
  EXPECT_NE(text.find("output_shaft.crack[0].depth"), std::string::npos) << text;
  EXPECT_NE(text.find("cracked.positive.stiffness "), std::string::npos) << text;
  EXPECT_EQ(text.find("intact.stiffness "), std::string::npos) << text;
  EXPECT_NE(text.find("are the same."), std::string::npos);
  EXPECT_TRUE(answer.document("csv").starts_with("path,what,first,first_unit,"));
}

TEST(Diff, IdentityResultsDifferAsTheirDrivesDo) {
  const std::string first = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  const std::string second = article_with("length = \"200 mm\"", "length = \"150 mm\"");
  const auto saved = [](const std::string& text) {
    return test::run_command("stiffness", read_drive(text, "x.toml")).json();
  };
  EXPECT_EQ(diff_result(diff(first, second)), diff_result(diff(saved(first), saved(second))));
}

TEST(Diff, InputWhatCannotBeComparedIsRefused) {
  const std::string drive = test::contents(STRAINWAVE_EXAMPLES "/article.toml");
  EXPECT_EQ(test::broken_rule([&] { return diff(drive, "{\"a\": 1}"); }),
            "b: is neither a drive nor a result; strainwave stiffness FILE --format json --output "
            "RESULT writes a result");
  EXPECT_EQ(test::broken_rule([&] { return diff(drive, "\n<!DOCTYPE html>\n<p>x</p>\n"); }),
            test::broken_rule([&] { return diff(drive, "{\"a\": 1}"); }));
  EXPECT_EQ(test::broken_rule([&] {
              return diff(drive, test::run_on_example("audit", "article").json());
            }).substr(0, 3),
            "b: ");
}

}  // namespace
}  // namespace strainwave

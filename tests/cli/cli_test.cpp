// SPDX-License-Identifier: Apache-2.0 The program seen from outside: its output, its files, its
// exit codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

using test::contents;
using test::Outcome;
using test::quoted;

class Program : public test::ProgramTest {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return execute(before + quoted(STRAINWAVE_CLI) + " " + arguments);
  }

  /// The envelope that a command prints.
  [[nodiscard]] Json envelope(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --format json");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << '\n' << outcome.err;
    return Json::parse(outcome.out);
  }

  /// The result that a command prints.
  [[nodiscard]] Json result_of(const std::string& arguments) const {
    return envelope(arguments).at("result");
  }

  /// The completions that the program offers for the last word.
  [[nodiscard]] std::string offered(const std::string& words) const {
    const Outcome outcome = run("completion words -- " + words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  }

  /// A temporary file of the folder that is to replace another file; empty if there is none.
  [[nodiscard]] std::string waiting() const {
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".part") return entry.path().filename().string();
    return {};
  }

  [[nodiscard]] std::string changed_article(const std::string& from, const std::string& to) const {
    return changed("article.toml", from, to);
  }
};

const std::string kArticle = quoted(STRAINWAVE_EXAMPLES "/article.toml");

TEST_F(Program, BehaviourVersionAndHelpSucceed) {
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("strainwave ", 0), 0U);
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* const command :
       {"stiffness", "audit", "sweep", "solve", "sensitivity", "torsion", "sif", "material",
        "report", "new", "schema", "man", "require", "completion"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
}

TEST_F(Program, BehaviourACrackBeyondCriticalIsAnswered) {
  const fs::path svg = in_folder("fad.svg");
  const fs::path csv = in_folder("fad.csv");
  const Outcome outcome = run("stiffness " + quoted(STRAINWAVE_EXAMPLES "/critical_crack.toml") +
                              " --plot " + quoted(svg.string()) + " --fad " + quoted(csv.string()));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("WARNING: flexspline.crack[0] fractures at this load"),
            std::string::npos);
  EXPECT_NE(contents(svg).find("K_r, stress intensity over toughness"), std::string::npos);
  EXPECT_NE(contents(csv).find("crack,flexspline.crack[0],positive,1,"), std::string::npos);
  // Without a toughness the diagram is refused, and no file is written.
  const fs::path none = in_folder("none.svg");
  const Outcome unknown = run("stiffness " + kArticle + " --plot " + quoted(none.string()));
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_NE(unknown.err.find("fracture_toughness and yield_strength"), std::string::npos);
  EXPECT_TRUE(unknown.out.empty());
  EXPECT_FALSE(fs::exists(none));
}

TEST_F(Program, InputUsageErrorsEndWithTwo) {
  for (const std::string& arguments :
       {std::string(), std::string("stifness"), std::string("stiffness"),
        "stiffness --method guess " + kArticle, "stiffness --format xml " + kArticle,
        "stiffness --colour " + kArticle, "sweep " + kArticle,
        "sweep " + kArticle + " --vary 'output_shaft.crack[0].depth=1..2:3'",
        "sweep " + kArticle + " --vary 'output_shaft.crack[0].dept=1 mm..2 mm:3'",
        "sweep " + kArticle + " --vary drive.ratio=50..60:2 --vary drive.ratio=50..60:2",
        "sweep " + kArticle +
            " --vary drive.ratio=50..60:400 --vary load.axial_force='1 N..2 N:400'",
        "sweep " + kArticle +
            " --vary drive.ratio=50..60:2 --vary load.axial_force='1 N..2 N:2'"
            " --vary 'output_shaft.crack[0].depth=1 mm..2 mm:2'",
        "solve " + kArticle + " --vary 'output_shaft.crack[0].depth'",
        "solve " + kArticle +
            " --vary 'output_shaft.crack[0].depth' --target 'cracked.positive.stifness=1 N'",
        std::string("man nothing")}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << '\n' << outcome.err;
    EXPECT_FALSE(outcome.err.empty()) << arguments;
    EXPECT_TRUE(outcome.out.empty()) << arguments << '\n' << outcome.out;
  }
}

TEST_F(Program, InputWrongFileEndsWithThreeAndOneSentence) {
  const std::string bad =
      changed_article("outer_diameter = \"70 mm\"", "outer_diameter = \"40 mm\"");
  const Outcome outcome = run("stiffness " + bad);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(outcome.out.empty());
  EXPECT_NE(outcome.err.find("changed.toml:"), std::string::npos) << outcome.err;
  EXPECT_NE(
      outcome.err.find(
          "output_shaft.inner_diameter = \"45 mm\" violates: inner_diameter < outer_diameter"),
      std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_EQ(run("stiffness nowhere.toml").exit_code, 3);
}

TEST_F(Program, InputMethodThatCannotTreatACrackEndsWithThree) {
  const std::string edge = changed_article("kind = \"surface\"", "kind = \"edge\"");
  std::string text = contents(folder_ / "changed.toml");
  const std::string aspect = "aspect_ratio = 0.52147039               # a/c, which gives Q = 1.5\n";
  text.replace(text.find(aspect), aspect.size(), "");
  const std::string width = "inner_ring_thickness = \"10 mm\"";
  text.insert(text.find(width), "inner_ring_width = \"20 mm\"\n");
  const std::string file = write("edge.toml", text);
  for (const char* const method : {"as-printed", "repaired"}) {
    const Outcome outcome = run("stiffness " + file + " --method " + method);
    EXPECT_EQ(outcome.exit_code, 3) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("wave_generator.crack[0]"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(method), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run("stiffness " + file).exit_code, 0);
}

TEST_F(Program, InputAnswerThatMayNotBeUsedEndsWithFour) {
  const std::string text = contents(fs::path(STRAINWAVE_EXAMPLES) / "article.toml");
  std::string deep = text;
  const std::string shaft = "kind = \"annular\"\ndepth = \"0.1 mm\"";
  deep.replace(deep.find(shaft), shaft.size(), "kind = \"annular\"\ndepth = \"11 mm\"");
  const Outcome outcome = run("stiffness " + write("deep.toml", deep));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.out.find("NOT USABLE"), std::string::npos);
  EXPECT_NE(outcome.err.find("a/t = 0.88"), std::string::npos) << outcome.err;
}

TEST_F(Program, InputOutputThatCannotBeWrittenEndsWithSevenAndLeavesNothing) {
  const Outcome outcome = run("stiffness " + kArticle + " --output " +
                              quoted(in_folder("no/such/folder.txt").string()));
  EXPECT_EQ(outcome.exit_code, 7);
  EXPECT_NE(outcome.err.find("folder.txt"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(in_folder("no")));
  EXPECT_EQ(run("schema >/dev/full; true").exit_code, 0);  // the shell works
  const std::string command = quoted(STRAINWAVE_CLI) + " schema >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 7);
}

TEST_F(Program, InputOneUnwritableDocumentLeavesNoneBehind) {
  const fs::path svg = in_folder("a.svg");
  const std::string sweep = "sweep " + kArticle +
                            " --vary 'output_shaft.crack[0].depth=1 mm..2 mm:3' --plot " +
                            quoted(svg.string()) + " -o ";
  for (const std::string& output :
       {quoted(in_folder("none/x.csv").string()), quoted("/dev/full")}) {
    const Outcome outcome = run(sweep + output);
    EXPECT_EQ(outcome.exit_code, 7) << output << outcome.err;
    EXPECT_FALSE(fs::exists(svg)) << output;
    EXPECT_TRUE(waiting().empty()) << waiting();
  }
  EXPECT_EQ(run(sweep + "/dev/null").exit_code, 0);
  EXPECT_TRUE(fs::exists(svg));
}

TEST_F(Program, InputDocumentsThatWouldOverwriteEachOtherOrTheInputEndWithTwo) {
  const std::string drive = contents(STRAINWAVE_EXAMPLES "/article.toml");
  const std::string input = write("drive.toml", drive);
  fs::create_symlink("drive.toml", in_folder("link.toml"));
  const std::string sweep =
      "sweep " + input + " --vary 'output_shaft.crack[0].depth=1 mm..2 mm:3' -o ";
  const std::string same = quoted(in_folder("same.out").string());
  const Outcome twice = run(sweep + same + " --plot " + quoted(in_folder("./same.out").string()));
  EXPECT_EQ(twice.exit_code, 2) << twice.err;
  EXPECT_NE(twice.err.find("--output and --plot name the same file, "), std::string::npos)
      << twice.err;
  EXPECT_NE(twice.err.find(": write to another file\n"), std::string::npos) << twice.err;
  EXPECT_FALSE(fs::exists(in_folder("same.out")));
  for (const char* const name : {"drive.toml", "link.toml"}) {
    const Outcome over = run(sweep + quoted(in_folder(name).string()));
    EXPECT_EQ(over.exit_code, 2) << over.err;
    EXPECT_NE(over.err.find("FILE and --output name the same file, "), std::string::npos)
        << over.err;
    EXPECT_EQ(contents(in_folder("drive.toml")), drive) << name;
  }
  const std::string curve = write("curve.csv", "mine");
  EXPECT_EQ(run("calibrate " + input + " --measured " + curve + " --output " + curve).exit_code, 2);
  EXPECT_EQ(contents(in_folder("curve.csv")), "mine");
}

TEST_F(Program, InputRefusedInputLeavesAnOldOutputAlone) {
  write("result.json", "old");
  const std::string bad = changed_article("ratio = 100", "ratio = -100");
  EXPECT_EQ(
      run("stiffness " + bad + " --output " + quoted(in_folder("result.json").string())).exit_code,
      3);
  EXPECT_EQ(contents(in_folder("result.json")), "old");
  EXPECT_TRUE(waiting().empty()) << waiting();
}

TEST_F(Program, ReferenceJsonHasThePathsOfTheContract) {
  const Json whole = envelope("stiffness " + kArticle);
  EXPECT_EQ(whole.at("format"), "strainwave-result/1");
  EXPECT_EQ(whole.at("command"), "stiffness");
  const Json& json = whole.at("result");
  EXPECT_EQ(json.at("method"), "corrected");
  for (const char* const path :
       {"/intact/compliance/wave_generator", "/intact/compliance/flexspline",
        "/intact/compliance/output_shaft", "/intact/compliance/total", "/intact/stiffness",
        "/cracked/positive/compliance/total", "/cracked/positive/stiffness",
        "/cracked/positive/stiffness_change", "/cracked/negative/stiffness",
        "/cracks/0/added_compliance/positive/at_output",
        "/cracks/1/added_compliance/negative/torsion_torsion",
        "/cracks/2/stress_intensity/deepest/K_III", "/cracks/2/stress_intensity/largest/K_I"}) {
    const Json& quantity = json.at(Json::json_pointer(path));
    EXPECT_TRUE(quantity.at("value").is_number()) << path;
    EXPECT_TRUE(quantity.at("unit").is_string()) << path;
    EXPECT_TRUE(quantity.contains("relative_uncertainty")) << path;
  }
  EXPECT_EQ(json.at("/cracks/1/opens_under"_json_pointer), "positive");
  for (const char* const key : {"code", "severity", "text", "path", "equation"})
    EXPECT_TRUE(whole.at("notes").at(0).contains(key)) << key;
  EXPECT_EQ(whole.at("/provenance/input/output_shaft/outer_diameter"_json_pointer), "0.07 m");
  // The corrected K_HD of the article's sound drive, 6.1547029e8 N*mm/rad; the tolerance is the
  // printed digits.
  EXPECT_NEAR(json.at("/intact/stiffness/value"_json_pointer).get<double>(), 6.1547029e5, 0.006);
}

TEST_F(Program, BehaviourMethodsDifferAndSameInputGivesSameBytes) {
  std::vector<std::string> outputs;
  for (const char* const method : {"as-printed", "repaired", "corrected"}) {
    const std::string arguments = "stiffness " + kArticle + " --format json --method " + method;
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(run(arguments).out, outcome.out);
    EXPECT_EQ(Json::parse(outcome.out).at("result").at("method"), method);
    outputs.push_back(outcome.out);
  }
  EXPECT_NE(outputs[0], outputs[1]);
  EXPECT_NE(outputs[1], outputs[2]);
}

TEST_F(Program, BehaviourTextFitsAReportAndCsvCarriesAllQuantities) {
  const Outcome text = run("stiffness " + kArticle);
  std::istringstream lines(text.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  const Outcome csv = run("stiffness " + kArticle + " --format csv");
  EXPECT_EQ(csv.out.rfind("path,value,unit,relative_uncertainty\n", 0), 0U);
  EXPECT_NE(csv.out.find("\ncracked.negative.stiffness_change,"), std::string::npos);
}

TEST_F(Program, BehaviourEveryExampleRuns) {
  int n = 0;
  for (const auto& entry : fs::directory_iterator(STRAINWAVE_EXAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    ++n;
    EXPECT_EQ(run("stiffness " + quoted(entry.path().string())).exit_code, 0) << entry.path();
    if (contents(entry.path()).find("[mesh]") == std::string::npos) continue;
    const Outcome torsion = run("torsion " + quoted(entry.path().string()) + " --draws 5");
    EXPECT_EQ(torsion.exit_code, 0) << entry.path() << torsion.err;
  }
  EXPECT_GE(n, 3);
}

TEST_F(Program, BehaviourTemplateIsAValidInputAlsoFromStandardInput) {
  const Outcome outcome = run("stiffness - --format json", quoted(STRAINWAVE_CLI) + " new | ");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("/provenance/input_file"_json_pointer), "standard input");
  EXPECT_EQ(run("new --output " + quoted(in_folder("new.toml").string())).exit_code, 0);
  EXPECT_EQ(contents(in_folder("new.toml")), run("new").out);
}

TEST_F(Program, BehaviourSchemaIsJsonAndTheReferencePageIsUpToDate) {
  EXPECT_EQ(Json::parse(run("schema").out).at("$schema"),
            "https://json-schema.org/draft/2020-12/schema");
  // docs/guide/input_file.md is made by `strainwave schema --format markdown`.
  EXPECT_EQ(contents(fs::path(STRAINWAVE_EXAMPLES) / "../docs/guide/input_file.md"),
            run("schema --format markdown").out);
}

TEST_F(Program, BehaviourMaterialListAndShow) {
  const Outcome list = run("material list");
  ASSERT_EQ(list.exit_code, 0) << list.err;
  EXPECT_NE(list.out.find("\n  17-4PH H900 "), std::string::npos) << list.out;
  for (const std::string& out :
       {list.out, run("material show '17-4PH H900'").out, run("material show '15-5PH H900'").out,
        run("material show 'generic steel'").out}) {
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  }
  const std::string bearings = run("material list --use bearing").out;
  EXPECT_NE(bearings.find("52100 hardened"), std::string::npos);
  EXPECT_EQ(bearings.find("17-4PH"), std::string::npos);
  const std::string show = run("material show 15-5phH900").out;  // case and blanks do not matter
  EXPECT_EQ(show.rfind("15-5PH H900\n", 0), 0U) << show;
  for (const char* const part :
       {"yield strength: 1172 MPa", "handbook, scatter not stated, source nasgro155",
        "C = 1.359e-12 m, n = 4", "Sources\n", "nasgro155: NASGRO data base"})
    EXPECT_NE(show.find(part), std::string::npos) << part << '\n' << show;
  EXPECT_NE(run("material show 'generic steel'").out.find("scatter 170 %"), std::string::npos);
}

TEST_F(Program, BehaviourMaterialsAsJson) {
  const Json all = result_of("material list");
  ASSERT_GT(all["material"].size(), 10U);
  std::set<std::string> used;
  const auto visit = [&](const auto& self, const Json& json) -> void {
    if (json.is_object() && json.contains("source") && json["source"].is_string()) {
      used.insert(json["source"]);
      EXPECT_TRUE(json.contains("confidence")) << json;
    }
    if (!json.is_structured()) return;  // a plain value would iterate over itself
    for (const Json& part : json) self(self, part);
  };
  visit(visit, all["material"]);
  for (const std::string& key : used) EXPECT_TRUE(all["source"].contains(key)) << key;
  EXPECT_EQ(all["source"].size(), used.size());
  const Json one = result_of("material show '52100 hardened'")["material"][0];
  EXPECT_EQ(one["name"], "52100 hardened");
  EXPECT_EQ(one["youngs_modulus"]["value"]["value"], 203.4e9);
  EXPECT_EQ(one["youngs_modulus"]["value"]["unit"], "Pa");
  EXPECT_EQ(one["youngs_modulus"]["confidence"], "handbook");
  EXPECT_FALSE(one["youngs_modulus"].contains("scatter"));
  EXPECT_EQ(one["hardness"]["scatter"]["value"], 0.0329);
  EXPECT_FALSE(one.contains("fracture_toughness"));
  EXPECT_TRUE(result_of("material show '52100 hardened'")["source"].contains("skf"));
  const Json growth = result_of("material show '15-5PH H900'")["material"][0]["growth"];
  EXPECT_EQ(growth[0]["kind"], "nasgro");
  EXPECT_EQ(growth[0]["coefficient"]["value"], 1.359e-12);
  EXPECT_EQ(result_of("material list --use bearing")["material"].size(), 1U);
}

TEST_F(Program, BehaviourTheMaterialPageIsUpToDate) {
  // docs/guide/materials.md is made by `strainwave material list --format markdown`.
  EXPECT_EQ(contents(fs::path(STRAINWAVE_EXAMPLES) / "../docs/guide/materials.md"),
            run("material list --format markdown").out);
}

TEST_F(Program, InputMaterialsThatAreNotThere) {
  const Outcome outcome = run("material show '17-4PH H90'");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "strainwave: material: \"17-4PH H90\" is not in the material library; did you mean "
            "17-4PH H900?\n");
  EXPECT_TRUE(outcome.out.empty());
  EXPECT_EQ(run("material").exit_code, 2);
  EXPECT_EQ(run("material show").exit_code, 2);
  EXPECT_EQ(run("material list --use spoon").exit_code, 2);
}

TEST_F(Program, BehaviourLibraryMaterialIsNotedAndCanBeVaried) {
  const std::string file = quoted(STRAINWAVE_EXAMPLES "/library_material.toml");
  const Json json = envelope("stiffness " + file);
  std::map<std::string, std::string> notes;
  for (const Json& note : json["notes"])
    if (note["code"] == "material.library") notes[note["path"]] = note["text"];
  EXPECT_EQ(notes.size(), 4U);
  const std::string& text = notes["material.17-4PH H900"];
  EXPECT_NE(text.find("yield strength 1170 MPa (standard)"), std::string::npos) << text;
  EXPECT_NE(notes["material.52100 hardened"].find(
                "these values are unverified, so check them before you base a decision on them: "
                "Poisson's ratio"),
            std::string::npos);
  EXPECT_EQ(json.at("/provenance/input/material/17-4PH H900/yield_strength"_json_pointer),
            "1170000000 Pa");
  const Outcome sweep =
      run("sweep " + file + " --vary 'material.17-4PH H900.youngs_modulus=190 GPa..200 GPa:3'");
  EXPECT_EQ(sweep.exit_code, 0) << sweep.err;
  EXPECT_EQ(sweep.out.rfind("material.17-4PH H900.youngs_modulus [GPa],", 0), 0U) << sweep.out;
}

TEST_F(Program, BehaviourManualPagesNameEveryOption) {
  EXPECT_NE(run("man").out.find(".TH STRAINWAVE 1"), std::string::npos);
  std::istringstream commands(run("man --list").out);
  int n = 0;
  for (std::string command; commands >> command;) {
    if (command == "fe") continue;  // its help comes from the other program
    ++n;
    const std::string page = run("man " + command).out;
    for (const char* const section : {".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH OPTIONS",
                                      ".SH EXIT STATUS", ".SH EXAMPLE"})
      EXPECT_NE(page.find(section), std::string::npos) << command << ' ' << section;
    std::string help = run(command + " --help").out;
    if (command == "material")
      help += run("material list --help").out + run("material show --help").out;
    if (command == "sif") help += run("sif eval --help").out + run("sif plot --help").out;
    std::istringstream words(help);
    for (std::string word; words >> word;) {
      if (word.rfind("--", 0) != 0 || word == "--help") continue;
      std::string escaped;
      for (const char c : word) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_NE(page.find(escaped), std::string::npos) << command << ' ' << word;
    }
  }
  EXPECT_GE(n, 15);
  EXPECT_NE(run("man fe").out.find("strainwave\\-fe"), std::string::npos);
  EXPECT_NE(run("man torsion").out.find("default 200"), std::string::npos);
  EXPECT_NE(run("man torsion").out.find("by \\-\\-plot: draw the curve"), std::string::npos);
}

TEST_F(Program, BehaviourSweepWritesTableAndPlot) {
  const std::string csv = in_folder("sweep.csv").string();
  const std::string svg = in_folder("sweep.svg").string();
  const Outcome outcome = run("sweep " + kArticle +
                              " --vary 'output_shaft.crack[0].depth=0.05 mm..8 mm:7:log' --plot " +
                              quoted(svg) + " --output " + quoted(csv));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(contents(csv));
  int n = 0;
  for (std::string line; std::getline(lines, line);) ++n;
  EXPECT_EQ(n, 8);
  EXPECT_NE(contents(svg).find("</svg>"), std::string::npos);
  const Outcome json = run("sweep " + kArticle +
                           " --vary 'flexspline.crack[0].angle=-90 deg..90 deg:5' "
                           "--vary 'load.axial_force=0 N..1 kN:3' --format json");
  EXPECT_EQ(json.exit_code, 0) << json.err;
  EXPECT_EQ(Json::parse(json.out).at("/result/columns/0/values/values"_json_pointer).size(), 15U);
  EXPECT_TRUE(Json::parse(json.out).contains("provenance"));
}

TEST_F(Program, InputSweepKeepsRefusedPointsAndRefusesAllRefused) {
  const Outcome some =
      run("sweep " + kArticle + " --vary 'output_shaft.crack[0].depth=10 mm..14 mm:3'");
  EXPECT_EQ(some.exit_code, 0);
  EXPECT_NE(some.err.find("2 of 3 points are not usable"), std::string::npos) << some.err;
  EXPECT_EQ(
      run("sweep " + kArticle + " --vary 'output_shaft.crack[0].depth=13 mm..14 mm:3'").exit_code,
      3);
}

TEST_F(Program, CrosscheckSolveFindsWhatStiffnessConfirms) {
  const Outcome solved = run("solve " + kArticle +
                             " --vary 'output_shaft.crack[0].depth' --target "
                             "'cracked.positive.stiffness_change=-1 %' --format json");
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const Json solution = Json::parse(solved.out).at("result").at("solutions").at(0);
  const double depth = solution.at("value").at("value").get<double>();
  std::ostringstream text;
  text.precision(17);
  text << "kind = \"annular\"\ndepth = \"" << depth << " m\"";
  const std::string file = changed_article("kind = \"annular\"\ndepth = \"0.1 mm\"", text.str());
  const Json json = result_of("stiffness " + file);
  EXPECT_NEAR(json.at("/cracked/positive/stiffness_change/value"_json_pointer).get<double>(), -0.01,
              1e-9);
}

TEST_F(Program, InputSolveSaysThatThereIsNoSolution) {
  const Outcome outcome = run("solve " + kArticle +
                              " --vary 'output_shaft.crack[0].depth' --target "
                              "'cracked.positive.stiffness_change=1 %'");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_FALSE(outcome.err.empty());
}

TEST_F(Program, BehaviourTorsionWritesTablePlotAndJson) {
  const std::string file = quoted(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const fs::path plot = in_folder("curve.svg");
  const Outcome text =
      run("torsion " + file + " --compare --angles 4 --plot " + quoted(plot.string()));
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("K1 [N*m/rad]"), std::string::npos);
  EXPECT_NE(text.out.find("4 positions over a turn"), std::string::npos);
  EXPECT_TRUE(contents(plot).starts_with("<svg"));
  const Json parsed = result_of("torsion " + file);
  EXPECT_GT(parsed["positive"]["K1"]["value"].get<double>(), 1e4);
  // The same numbers appear in addition to the series model.
  const Json beside = result_of("stiffness " + file);
  EXPECT_EQ(beside["curve"]["positive"]["K1"]["value"].get<double>(),
            parsed["positive"]["K1"]["value"].get<double>());
  EXPECT_LT(beside["curve"]["positive"]["K3"]["value"].get<double>(),
            beside["curve"]["intact"]["K3"]["value"].get<double>());
  EXPECT_EQ(run("torsion " + file + " --format csv").out.rfind("torque [N*m],", 0), 0U);
}

TEST_F(Program, BehaviourEveryRowIsFitted) {
  // Fits go far beyond the plausible ranges, but must stay within the limits of the model.
  const Outcome rows = run("validate --mode per-row --format csv");
  EXPECT_EQ(rows.exit_code, 0) << rows.err;
  EXPECT_TRUE(rows.err.empty()) << rows.err;
}

TEST_F(Program, InputAnglesNeedCompare) {
  const Outcome refused = run("torsion " + kArticle + " --angles 8");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--angles: needs --compare; give it too"), std::string::npos)
      << refused.err;
}

TEST_F(Program, InputTorsionSaysWhatIsMissingAndWhatFails) {
  const Outcome missing = run("torsion " + kArticle);
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.err.find("wave_generator.bearing: must be given for the torsion curve"),
            std::string::npos)
      << missing.err;
  std::string text = contents(fs::path(STRAINWAVE_EXAMPLES) / "cracked_size25.toml");
  const std::string mesh = "[mesh]\n";
  text.insert(text.find(mesh) + mesh.size(), "lobe_gap = \"2 mm\"\n");
  const Outcome loose = run("torsion " + write("loose.toml", text));
  EXPECT_EQ(loose.exit_code, 4);
  EXPECT_NE(loose.err.find("lobe gap of 2000 um"), std::string::npos) << loose.err;
  EXPECT_TRUE(loose.out.empty());
  EXPECT_EQ(run("torsion " + kArticle + " --angles -1").exit_code, 2);
}

TEST_F(Program, BehaviourAuditPrintsItsRowsInAllForms) {
  const Outcome json = run("audit --format json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  EXPECT_FALSE(Json::parse(json.out)["result"]["rows"].empty());
  EXPECT_NE(run("audit").out.find("B9"), std::string::npos);
  EXPECT_NE(run("audit --format markdown").out.find('|'), std::string::npos);
}

// Every number of every crack may have a range and a scatter, for every command.
TEST_F(Program, BehaviourWhatIsSaidOfCracksStopsNoCommand) {
  const std::string text = contents(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  std::string said;
  for (const char* const path : {"mesh.crack[0].stiffness_loss", "flexspline.crack[0].half_length",
                                 "wave_generator.crack[0].depth", "circular_spline.crack[0].depth",
                                 "output_shaft.crack[0].depth", "mesh.crack[0].position"})
    said +=
        std::string("[[scatter]]\npath = \"") + path + "\"\nrelative_standard_deviation = 0.1\n";
  for (const auto& [path, lower, upper] :
       {std::array{"mesh.crack[0].position", "\"1 deg\"", "\"9 deg\""},
        std::array{"output_shaft.crack[0].depth", "\"1 mm\"", "\"3 mm\""},
        std::array{"output_shaft.length", "\"10 mm\"", "\"80 mm\""}})
    said += std::string("[[range]]\npath = \"") + path + "\"\nlower = " + lower +
            "\nupper = " + upper + "\n";
  const std::string plain = write("plain.toml", text);
  const std::string file = write("said.toml", text + "\n" + said);
  const auto lines = [&](const std::string& drive) {
    const Json result = result_of("stiffness " + drive);
    return result.at("curve");
  };
  EXPECT_EQ(lines(file), lines(plain));
  for (const char* const command :
       {"torsion --compare --angles 2 FILE", "torsion --draws 3 FILE",
        "calibrate FILE --catalogue --factors coning", "sensitivity FILE",
        "sensitivity FILE --scatter --samples 20", "report FILE",
        "sweep FILE --vary 'output_shaft.crack[0].depth=0.5 mm..4 mm:3'",
        "sweep FILE --vary 'mesh.crack[0].position=-5 deg..5 deg:3'"}) {
    std::string words = command;
    words.replace(words.find("FILE"), 4, file);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
    EXPECT_EQ(outcome.out.find("scatter["), std::string::npos) << command;
    EXPECT_EQ(outcome.out.find("range["), std::string::npos) << command;
  }
}

TEST_F(Program, BehaviourTypicalDriveOfACatalogueSize) {
  const Outcome drive = run("new --size 32 --ratio 50 --length standard");
  ASSERT_EQ(drive.exit_code, 0) << drive.err;
  const Outcome curve = run("torsion --draws 0 " + write("size32.toml", drive.out));
  EXPECT_EQ(curve.exit_code, 0) << curve.err;
  const Outcome hat = run("new --size 32 --ratio 50 --form hat --length flat");
  ASSERT_EQ(hat.exit_code, 0) << hat.err;
  EXPECT_NE(hat.out.find("flat hat"), std::string::npos);
  EXPECT_EQ(run("torsion --draws 0 " + write("hat.toml", hat.out)).exit_code, 0);
  // The lines of the shaft are a valid section once their # is gone.
  std::string shafted = drive.out;
  const std::size_t section = shafted.find("# [output_shaft]\n");
  ASSERT_NE(section, std::string::npos);
  for (std::size_t at = section; at != std::string::npos; at = shafted.find("\n# ", at))
    shafted.erase(at == section ? at : at + 1, 2);
  const Outcome softer = run("stiffness --format json " + write("shaft.toml", shafted));
  ASSERT_EQ(softer.exit_code, 0) << softer.err;
  EXPECT_GT(Json::parse(softer.out)["result"]["intact"]["compliance"]["output_shaft"]["value"], 0);
  // Its dimensions are whole millimetres, also where 1e-3 times their number is no short decimal.
  EXPECT_NE(run("new --size 17 --ratio 80").out.find("# length = \"26 mm\"\n"), std::string::npos);
  for (const char* const arguments :
       {"new --size 32", "new --ratio 50", "new --size 22 --ratio 50", "new --size 32 --ratio 20",
        "catalogue --size 22", "validate --factors support", "new --size 4294967321 --ratio 100"}) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 2) << arguments << refused.out;
    EXPECT_FALSE(refused.err.empty()) << arguments;
  }
}

TEST_F(Program, BehaviourCatalogueAndValidation) {
  EXPECT_NE(run("catalogue --size 25 --ratio 100").out.find("87"), std::string::npos);
  const fs::path plot = in_folder("validation.svg");
  const Outcome outcome = run("validate --format json --plot " + quoted(plot.string()));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["result"]["rows"]["size"]["values"].size(), 35U + 8U);
  EXPECT_EQ(contents(plot).rfind("<svg", 0), 0U);
}

TEST_F(Program, BehaviourCalibratedDriveIsAnInput) {
  const std::string drive = quoted(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  const std::string calibrated = quoted(in_folder("calibrated.toml").string());
  const Outcome outcome =
      run("calibrate " + drive + " --catalogue --factors coning --output " + calibrated);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(run("stiffness " + calibrated).exit_code, 0);
  // Only a head, the line of the calibrated number and its range differ from the given text.
  const std::string text = contents(in_folder("calibrated.toml"));
  EXPECT_TRUE(text.starts_with("# Calibrated with catalogue, size 25, ratio 80+.\n# coning: "))
      << text.substr(0, 200);
  std::istringstream given(contents(STRAINWAVE_EXAMPLES "/catalogue_size25.toml"));
  std::vector<std::string> changed;
  for (std::string line; std::getline(given, line);)
    if (text.find(line + '\n') == std::string::npos) changed.push_back(line);
  ASSERT_GE(changed.size(), 2U);
  EXPECT_LE(changed.size(), 6U);  // a range has a heading and up to five lines
  EXPECT_TRUE(changed[0].starts_with("coning = ")) << changed[0];
  EXPECT_EQ(changed[1], "path = \"mesh.coning\"");
  // A material of the library therefore stays a name, and the line of the schema stays first.
  const std::string named = write(
      "named.toml", "#:schema x.json\n" + contents(STRAINWAVE_EXAMPLES "/library_material.toml"));
  const std::string again = quoted(in_folder("again.toml").string());
  ASSERT_EQ(run("calibrate " + named + " --catalogue --factors support -o " + again).exit_code, 0);
  const std::string kept = contents(in_folder("again.toml"));
  EXPECT_TRUE(kept.starts_with("#:schema x.json\n# Calibrated with ")) << kept.substr(0, 200);
  EXPECT_EQ(kept.find("\n[material"), std::string::npos);
  EXPECT_EQ(run("stiffness " + again).exit_code, run("stiffness " + named).exit_code);
  const std::string curve =
      write("curve.csv", "torque [N*m],twist [arcmin]\n14,1.5\n48,4.1\n-48,-4.1\n");
  EXPECT_EQ(run("calibrate " + drive + " --factors coning --measured " + curve).exit_code, 0);
  EXPECT_EQ(run("calibrate " + drive).exit_code, 2);
  EXPECT_EQ(run("calibrate " + drive + " --catalogue --measured " + curve).exit_code, 2);
  EXPECT_EQ(run("calibrate " + drive + " --measured nowhere.csv").exit_code, 3);
}

// --- sif

TEST_F(Program, ReferenceSifEvalOfAGriffithCrack) {
  // K = 100 MPa sqrt(pi 1 mm), by hand.
  const Outcome eval =
      run("sif eval plate-through --set 'half_length=1 mm' --set 'thickness=0.5 mm' --set "
          "'tension=100 MPa' --format json");
  ASSERT_EQ(eval.exit_code, 0) << eval.err;
  const Json json = Json::parse(eval.out).at("result");
  EXPECT_NEAR(json.at("/points/0/K_I/value"_json_pointer).get<double>(), 5.6049912e6, 1);
  EXPECT_EQ(json["in_range"], true);
}

TEST_F(Program, BehaviourSifEvalTakesASteelOfTheMaterialLibrary) {
  const Outcome eval =
      run("sif eval plate-through --set 'tension=100 MPa' --material '15-5PH H900' --format json");
  ASSERT_EQ(eval.exit_code, 0) << eval.err;
  const Json json = Json::parse(eval.out).at("result");
  const double K = json["equivalent"]["value"].get<double>();
  const double K_Ic = json["material"]["fracture_toughness"]["value"].get<double>();
  EXPECT_NEAR(json["utilisation"]["value"].get<double>(), K / K_Ic, 1e-12);
  EXPECT_EQ(run("sif eval plate-through --material '15-5PHH H900'").exit_code, 2);
}

TEST_F(Program, BehaviourSifListShowAndPlotAnswer) {
  const Outcome list = run("sif list --family plate --format json");
  ASSERT_EQ(list.exit_code, 0) << list.err;
  const Json rows = Json::parse(list.out)["result"]["solutions"];
  for (const Json& row : rows) {
    const Outcome show = run("sif show " + row["name"].get<std::string>());
    EXPECT_EQ(show.exit_code, 0) << show.err;
    EXPECT_NE(show.out.find(row["accuracy"].get<std::string>()), std::string::npos);
  }
  const fs::path svg = in_folder("y.svg");
  ASSERT_EQ(run("sif plot plate-surface -o " + quoted(svg.string())).exit_code, 0);
  EXPECT_TRUE(contents(svg).starts_with("<svg"));
}

TEST_F(Program, InputSifRefusesInOneSentence) {
  const std::string svg = quoted(in_folder("none.svg").string());
  for (const std::string& bad : {std::string("sif show plate-surfac"),
                                 std::string("sif eval plate-surface --set 'dept=1 mm'"),
                                 std::string("sif eval plate-surface --set 'depth=1'"),
                                 std::string("sif eval plate-surface --set 'depth=1 m'"),
                                 std::string("sif eval plate-surface --set 'tension=nan MPa'"),
                                 "sif plot plate-surface --set 'depth=20 mm' -o " + svg}) {
    const Outcome refused = run(bad);
    EXPECT_EQ(refused.exit_code, 2) << bad;
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    EXPECT_TRUE(refused.out.empty()) << bad;
  }
  EXPECT_FALSE(fs::exists(in_folder("none.svg")));
  EXPECT_EQ(run("sif").exit_code, 2);
  EXPECT_EQ(run("sif list --family plates").exit_code, 2);
}

TEST_F(Program, BehaviourReportIsAPageInAFileOrOnStandardOutput) {
  const Outcome printed = run("report " + kArticle);
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_EQ(printed.out.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(printed.out.find("</html>"), std::string::npos);
  const fs::path page = in_folder("report.html");
  const Outcome written = run("report " + kArticle + " -o " + quoted(page.string()));
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_TRUE(written.out.empty());
  EXPECT_EQ(contents(page), printed.out);
  EXPECT_EQ(run("report " + kArticle + " --output " + quoted(page.string())).exit_code, 0);
  EXPECT_EQ(contents(page), printed.out);
}

TEST_F(Program, BehaviourReportHasADateOnlyIfItIsGiven) {
  EXPECT_EQ(run("report " + kArticle).out.find("<dt>Date</dt>"), std::string::npos);
  // The date is 86400 seconds after the beginning of 1970.
  EXPECT_NE(run("report " + kArticle, "SOURCE_DATE_EPOCH=86400 ")
                .out.find("<dt>Date</dt><dd>1970-01-02</dd>"),
            std::string::npos);
  EXPECT_NE(run("report --date 2024-02-29 " + kArticle, "SOURCE_DATE_EPOCH=86400 ")
                .out.find("<dt>Date</dt><dd>2024-02-29</dd>"),
            std::string::npos);
  for (const char* const date : {"tomorrow", "2023-02-29", "2024-2-1", "2024-02-01 ", "01.02.2024"})
    EXPECT_EQ(run("report " + kArticle + " --date " + quoted(date)).err,
              std::string("strainwave: --date: ") + date +
                  " is not a date; write YYYY-MM-DD, such as 2024-03-28\n");
  for (const char* const epoch : {"SOURCE_DATE_EPOCH=soon ", "SOURCE_DATE_EPOCH=-1 ",
                                  "SOURCE_DATE_EPOCH=1e9 ", "SOURCE_DATE_EPOCH=253402300800 "}) {
    const Outcome outcome = run("report " + kArticle, epoch);
    EXPECT_EQ(outcome.exit_code, 2) << epoch;
    EXPECT_TRUE(outcome.out.empty()) << epoch;
  }
}

TEST_F(Program, InputReportOfAWrongFileLeavesNothingBehind) {
  const fs::path page = in_folder("report.html");
  const std::string bad =
      changed_article("outer_diameter = \"70 mm\"", "outer_diameter = \"40 mm\"");
  EXPECT_EQ(run("report " + bad + " -o " + quoted(page.string())).exit_code, 3);
  EXPECT_FALSE(fs::exists(page));
  EXPECT_EQ(run("report " + quoted(in_folder("none.toml").string())).exit_code, 3);
}

TEST_F(Program, BehaviourReportOfAnUnusableResultIsMadeAndEndsWithFour) {
  const fs::path page = in_folder("report.html");
  const std::string long_crack =
      changed_article("half_length = \"0.1 mm\"", "half_length = \"30 mm\"");
  const Outcome outcome = run("report " + long_crack + " -o " + quoted(page.string()));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.err.find("finite elements"), std::string::npos);
  EXPECT_NE(contents(page).find("Cannot be told"), std::string::npos);
}

TEST_F(Program, BehaviourSensitivityInEveryForm) {
  const std::string file = quoted(std::string(STRAINWAVE_EXAMPLES) + "/article_scatter.toml");
  const fs::path plot = in_folder("tornado.svg");
  const Outcome text = run("sensitivity " + file + " --plot " + quoted(plot.string()));
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("flexspline.crack[0].half_length"), std::string::npos);
  EXPECT_TRUE(contents(plot).starts_with("<svg"));
  const Outcome json = run("sensitivity " + file + " --format json --scatter --samples 200");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const Json report = Json::parse(json.out);
  EXPECT_TRUE(report["usable"].get<bool>());
  EXPECT_EQ(report["result"]["scatter"]["samples"], 200);
  EXPECT_EQ(report["provenance"]["program"], "strainwave");
  const Outcome csv = run("sensitivity " + file + " --format csv");
  EXPECT_TRUE(
      csv.out.starts_with("output,path,unit,value,derivative,derivative_unit,elasticity\n"));
  // One thread and three threads give the same bytes.
  const std::string scatter = "sensitivity " + file + " --scatter --samples 600 --threads ";
  EXPECT_EQ(run(scatter + "1").out, run(scatter + "3").out);
  EXPECT_NE(run(scatter + "1").out, run(scatter + "1 --seed 2").out);
}

TEST_F(Program, InputSensitivityOptions) {
  const std::string file = quoted(std::string(STRAINWAVE_EXAMPLES) + "/article.toml");
  EXPECT_EQ(run("sensitivity").exit_code, 2);
  EXPECT_EQ(run("sensitivity " + file + " --samples 100").exit_code, 2);  // refused without a study
  EXPECT_EQ(run("sensitivity " + file + " --scatter --samples 1").exit_code, 2);
  EXPECT_EQ(run("sensitivity " + file + " --scatter --seed -1").exit_code, 2);
  const Outcome none = run("sensitivity " + file + " --scatter");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.err.find("[[scatter]]"), std::string::npos);
  const std::string deep = changed_article("kind = \"annular\"\ndepth = \"0.1 mm\"",
                                           "kind = \"annular\"\ndepth = \"11 mm\"");
  const Outcome unusable = run("sensitivity " + deep);
  EXPECT_EQ(unusable.exit_code, 4);
  EXPECT_NE(unusable.err.find("a/t"), std::string::npos);
}

// --- requirements

TEST_F(Program, BehaviourRequirementsEndWithZeroFiveOrSix) {
  const std::string file = kArticle;
  const Outcome met = run("require " + file +
                          " 'cracked.positive.stiffness >= 2e4 N*m/rad' "
                          "'intact.stiffness > 2e4 N*m/rad'");
  EXPECT_EQ(met.exit_code, 0) << met.out << met.err;
  EXPECT_NE(met.out.find("All together: met"), std::string::npos) << met.out;
  const Outcome broken = run("require " + file +
                             " 'cracked.positive.stiffness >= 2e4 N*m/rad' "
                             "'intact.stiffness > 2e7 N*m/rad'");
  EXPECT_EQ(broken.exit_code, 5) << broken.out << broken.err;
  // A bound equal to the stiffness lies within its uncertainty.
  EXPECT_EQ(run("require " + file + " 'intact.stiffness >= 6.15e5 N*m/rad'").exit_code, 6);
  EXPECT_EQ(envelope("require " + file + " 'intact.stiffness >= 1 N*m/rad'").at("usable"), true);
}

TEST_F(Program, InputRequirementsAreChecked) {
  for (const char* const wrong :
       {"", " 'intact.stifness > 1 N*m/rad'", " 'intact.stiffness'", " 'intact.stiffness > 1 mm'",
        " 'intact.stiffness > 1 N*m/rad' --coverage 0"}) {
    const Outcome outcome = run("require " + kArticle + wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong << outcome.out << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << wrong;
  }
}

TEST_F(Program, InputAFaultOfAnOptionNamesItAsItIsTyped) {
  EXPECT_EQ(run("sensitivity " + kArticle + " --scatter --samples 1")
                .err.rfind("strainwave: --samples: 1 violates", 0),
            0U)
      << run("sensitivity " + kArticle + " --scatter --samples 1").err;
  EXPECT_EQ(run("validate --mode guess").err.rfind("strainwave: --mode: ", 0), 0U);
  EXPECT_EQ(run("sweep " + kArticle).err.rfind("strainwave: --vary: ", 0), 0U);
  EXPECT_EQ(run("completion tcsh").err.rfind("strainwave: SUBJECT: ", 0), 0U);
  EXPECT_EQ(run("stiffness " + kArticle + " --method repaired --method corrected").exit_code, 2);
}

// --- schemas and references

TEST_F(Program, BehaviourSchemasAndReferencesOfACommand) {
  const Json options = Json::parse(run("schema --of options --command 'sif eval'").out);
  EXPECT_EQ(options.at("/properties/set/type"_json_pointer), "array");
  const Json result = Json::parse(run("schema --of result --command stiffness").out);
  EXPECT_EQ(result.at("/properties/format/const"_json_pointer), "strainwave-result/1");
  EXPECT_TRUE(result.contains("/properties/result/properties/intact"_json_pointer));
  const std::string fields = run("schema --of result --command stiffness --format markdown").out;
  EXPECT_NE(fields.find("| `intact.stiffness` | N*m/rad | K_HD"), std::string::npos);
  const std::string taken = run("schema --of options --command require --format markdown").out;
  EXPECT_NE(taken.find("| `coverage` | 1 |"), std::string::npos);
  for (const char* const wrong : {"schema --of result", "schema --command stiffness",
                                  "schema --of result --command stifness", "schema --of output"}) {
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_TRUE(outcome.out.empty()) << wrong;
  }
}

// --- completion

TEST_F(Program, BehaviourCompletionOfCommandsOptionsAndValues) {
  EXPECT_EQ(offered("sti"), "stiffness\n");
  EXPECT_EQ(offered("sif e"), "eval\n");
  EXPECT_EQ(offered("nothing ''"), "");
  EXPECT_EQ(offered("stiffness x.toml --pl"), "--plot\n");
  EXPECT_EQ(offered("stiffness x.toml --method r"), "repaired\n");
  EXPECT_EQ(offered("stiffness x.toml --method=r"), "--method=repaired\n");
  EXPECT_EQ(offered("stiffness x.toml --method = r"), "repaired\n");  // words as bash splits them
  EXPECT_EQ(offered("torsion x.toml --compare --format c"),
            "csv\n");  // a flag does not take a word
  EXPECT_EQ(offered("stiffness ''"), ":files\n");
  EXPECT_EQ(offered("stiffness x.toml -o ''"), ":files\n");
  EXPECT_EQ(offered("calibrate x.toml --measured ''"), ":files\n");
  EXPECT_EQ(offered("completion f"), "fish\n");
}

TEST_F(Program, BehaviourCompletionOfNames) {
  EXPECT_EQ(offered("sweep " + kArticle + " --vary output_shaft.crack"),
            "output_shaft.crack[0].depth\n");
  EXPECT_EQ(offered("sweep --vary output_shaft.crack"), "");  // the file is not known
  EXPECT_EQ(offered("solve " + kArticle + " --target intact.st"), "intact.stiffness\n");
  EXPECT_EQ(offered("require " + kArticle + " 'intact.stiffness > 1 N*m/rad' intact.st"),
            "intact.stiffness\n");
  EXPECT_EQ(offered("material show '17-4PH H9'"), "17-4PH H900\n");
  EXPECT_EQ(offered("sif show plate-thr"), "plate-through\n");
  EXPECT_EQ(offered("validate --factors coning,sup"), "coning,support\n");
  EXPECT_EQ(offered("schema --of result --command 'sif e'"), "sif eval\n");
  // A file that cannot be read does not give names.
  EXPECT_EQ(run("completion words -- sweep nowhere.toml --vary a").exit_code, 3);
}

TEST_F(Program, BehaviourBashCompletes) {
  const auto completed = [&](const std::string& words) {
    const std::string script = "source <(" + quoted(STRAINWAVE_CLI) +
                               " completion bash)\nCOMP_WORDS=(" + quoted(STRAINWAVE_CLI) + " " +
                               words +
                               ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_strainwave\nprintf "
                               "'%s\\n' \"${COMPREPLY[@]}\"\n";
    return execute("bash " + write("complete.sh", script)).out;
  };
  EXPECT_EQ(completed("stiffness x.toml --method rep"), "repaired\n");
  EXPECT_EQ(completed("sweep \"" + quoted(STRAINWAVE_EXAMPLES "/article.toml") +
                      "\" --vary output_shaft.crack"),
            "output_shaft.crack\\[0\\].depth\n");
  EXPECT_EQ(completed("material show \"'17-4PH H9\""), "17-4PH H900\n");  // an open quote
  EXPECT_EQ(completed("stiffness " + quoted(STRAINWAVE_EXAMPLES "/article.tom")),
            STRAINWAVE_EXAMPLES "/article.toml\n");
  for (const char* const shell : {"zsh", "fish"})
    EXPECT_NE(run(std::string("completion ") + shell).out.find("completion words -- "),
              std::string::npos);
}

// --- interruption

TEST_F(Program, BehaviourAnInterruptLeavesNoFileAndEndsWith130) {
  const fs::path csv = in_folder("sweep.csv");
  const Outcome outcome =
      interrupted(STRAINWAVE_CLI, "sweep " + kArticle +
                                      " --vary 'output_shaft.crack[0].depth=0.05 mm..8 mm:300' "
                                      "--vary 'load.axial_force=0 N..1 kN:300' -o " +
                                      quoted(csv.string()));
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(outcome.err, "strainwave: interrupted: nothing was written\n");
  EXPECT_FALSE(fs::exists(csv));
  EXPECT_TRUE(waiting().empty()) << waiting();
}

// Kind: identity.  Both spellings of the command `fit` give the same bytes.
TEST_F(Program, IdentityTheOtherSpellingOfACommand) {
  const std::string data = quoted(STRAINWAVE_EXAMPLES "/growth_specimens.csv");
  const std::string rest =
      " --stress-range '60 MPa' --plate-width '100 mm' --knots 2 --draws 200 --format json";
  const Outcome straight = run("fit " + data + rest);
  EXPECT_EQ(straight.exit_code, 0) << straight.err;
  EXPECT_EQ(run("grow --fit " + data + rest).out, straight.out);
  EXPECT_EQ(run("grow --fit=" + data + rest).out, straight.out);
  EXPECT_EQ(run("grow" + rest + " --fit " + data).out, straight.out);
}

}  // namespace
}  // namespace strainwave

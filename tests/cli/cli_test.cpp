// SPDX-License-Identifier: Apache-2.0
// The program from outside: what it prints, what it writes, how it ends.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace strainwave {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// A folder of its own for each test, with a blank in its name.
class Program : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / ("strainwave cli " + std::to_string(::getpid()) + " " +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path in_folder(const std::string& name) const { return folder_ / name; }

  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    const fs::path out = folder_ / "stdout.txt";
    const fs::path err = folder_ / "stderr.txt";
    const std::string command = before + quoted(STRAINWAVE_CLI) + " " + arguments + " >" +
                                quoted(out.string()) + " 2>" + quoted(err.string());
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
  }

  std::string write(const std::string& name, const std::string& text) const {
    const fs::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return quoted(file.string());
  }

  /// The article's example with one text replaced by another.
  std::string changed_article(const std::string& from, const std::string& to) const {
    std::string text = contents(fs::path(STRAINWAVE_EXAMPLES) / "article.toml");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return write("changed.toml", text.replace(at, from.size(), to));
  }

  fs::path folder_;
};

const std::string kArticle = quoted(STRAINWAVE_EXAMPLES "/article.toml");

TEST_F(Program, IdentityVersionAndHelpSucceed) {
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("strainwave ", 0), 0U);
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* const command :
       {"stiffness", "audit", "sweep", "solve", "sensitivity", "torsion", "new", "schema", "man"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
}

TEST_F(Program, InputUsageErrorsEndWithTwo) {
  for (const std::string& arguments :
       {std::string(), std::string("stifness"), std::string("stiffness"),
        "stiffness --method guess " + kArticle, "stiffness --format xml " + kArticle,
        "stiffness --colour " + kArticle, "sweep " + kArticle,
        "sweep " + kArticle + " --vary 'output_shaft.crack[0].depth=1..2:3'",
        "sweep " + kArticle + " --vary 'output_shaft.crack[0].dept=1 mm..2 mm:3'",
        "solve " + kArticle + " --vary 'output_shaft.crack[0].depth'",
        "solve " + kArticle +
            " --vary 'output_shaft.crack[0].depth' --target 'cracked.positive.stifness=1 N'",
        std::string("man nothing"), std::string("man man")}) {
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
  const std::string aspect = "aspect_ratio = 0.52147039               # a/c, so that Q = 1.5\n";
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

TEST_F(Program, InputOutputThatCannotBeWrittenEndsWithSeventyAndLeavesNothing) {
  const Outcome outcome = run("stiffness " + kArticle + " --output " +
                              quoted(in_folder("no/such/folder.txt").string()));
  EXPECT_EQ(outcome.exit_code, 70);
  EXPECT_NE(outcome.err.find("folder.txt"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(in_folder("no")));
  EXPECT_EQ(run("schema >/dev/full; true").exit_code, 0);  // the shell works
  const std::string command = quoted(STRAINWAVE_CLI) + " schema >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 70);
}

TEST_F(Program, InputRefusedInputLeavesAnOldOutputAlone) {
  write("result.json", "old");
  const std::string bad = changed_article("ratio = 100", "ratio = -100");
  EXPECT_EQ(
      run("stiffness " + bad + " --output " + quoted(in_folder("result.json").string())).exit_code,
      3);
  EXPECT_EQ(contents(in_folder("result.json")), "old");
  EXPECT_FALSE(fs::exists(in_folder("result.json.part")));
}

TEST_F(Program, ReferenceJsonHasThePathsOfTheContract) {
  const Outcome outcome = run("stiffness " + kArticle + " --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
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
  for (const char* const key : {"code", "text", "path", "equation"})
    EXPECT_TRUE(json.at("notes").at(0).contains(key)) << key;
  EXPECT_EQ(json.at("/provenance/input/output_shaft/outer_diameter"_json_pointer), "0.07 m");
  // The corrected K_HD of the article's sound drive, 6.1547029e8 N*mm/rad; the tolerance is the
  // printed digits.
  EXPECT_NEAR(json.at("/intact/stiffness/value"_json_pointer).get<double>(), 6.1547029e5, 0.006);
}

TEST_F(Program, IdentityMethodsDifferAndSameInputGivesSameBytes) {
  std::vector<std::string> outputs;
  for (const char* const method : {"as-printed", "repaired", "corrected"}) {
    const std::string arguments = "stiffness " + kArticle + " --format json --method " + method;
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(run(arguments).out, outcome.out);
    EXPECT_EQ(Json::parse(outcome.out).at("method"), method);
    outputs.push_back(outcome.out);
  }
  EXPECT_NE(outputs[0], outputs[1]);
  EXPECT_NE(outputs[1], outputs[2]);
}

TEST_F(Program, IdentityTextFitsAReportAndCsvCarriesAllQuantities) {
  const Outcome text = run("stiffness " + kArticle);
  std::istringstream lines(text.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  const Outcome csv = run("stiffness " + kArticle + " --format csv");
  EXPECT_EQ(csv.out.rfind("path,value,unit,relative_uncertainty\n", 0), 0U);
  EXPECT_NE(csv.out.find("\ncracked.negative.stiffness_change,"), std::string::npos);
}

TEST_F(Program, IdentityEveryExampleRuns) {
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

TEST_F(Program, IdentityTemplateIsAValidInputAlsoFromStandardInput) {
  const Outcome outcome = run("stiffness - --format json", quoted(STRAINWAVE_CLI) + " new | ");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("/provenance/input_file"_json_pointer), "standard input");
  EXPECT_EQ(run("new --output " + quoted(in_folder("new.toml").string())).exit_code, 0);
  EXPECT_EQ(contents(in_folder("new.toml")), run("new").out);
}

TEST_F(Program, IdentitySchemaIsJsonAndTheReferencePageIsUpToDate) {
  EXPECT_EQ(Json::parse(run("schema").out).at("$schema"),
            "https://json-schema.org/draft/2020-12/schema");
  // docs/guide/input_file.md is made by `strainwave schema --format markdown`.
  EXPECT_EQ(contents(fs::path(STRAINWAVE_EXAMPLES) / "../docs/guide/input_file.md"),
            run("schema --format markdown").out);
}

TEST_F(Program, IdentityManualPagesNameEveryOption) {
  EXPECT_NE(run("man").out.find(".TH STRAINWAVE 1"), std::string::npos);
  for (const std::string command : {"stiffness", "audit", "sweep", "solve", "new", "schema"}) {
    const std::string page = run("man " + command).out;
    for (const char* const section : {".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH OPTIONS",
                                      ".SH EXIT STATUS", ".SH EXAMPLE"})
      EXPECT_NE(page.find(section), std::string::npos) << command << ' ' << section;
    std::istringstream words(run(command + " --help").out);
    for (std::string word; words >> word;) {
      if (word.rfind("--", 0) != 0 || word == "--help") continue;
      std::string escaped;
      for (const char c : word) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_NE(page.find(escaped), std::string::npos) << command << ' ' << word;
    }
  }
}

TEST_F(Program, IdentitySweepWritesTableAndPlot) {
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
  EXPECT_EQ(Json::parse(json.out).at("rows").size(), 15U);
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
  const Json solution = Json::parse(solved.out).at("solutions").at(0);
  const double depth = solution.at("value").at("value").get<double>();
  std::ostringstream text;
  text.precision(17);
  text << "kind = \"annular\"\ndepth = \"" << depth << " m\"";
  const std::string file = changed_article("kind = \"annular\"\ndepth = \"0.1 mm\"", text.str());
  const Json json = Json::parse(run("stiffness " + file + " --format json").out);
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

TEST_F(Program, IdentityTorsionWritesTablePlotAndJson) {
  const std::string file = quoted(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const fs::path plot = in_folder("curve.svg");
  const Outcome text =
      run("torsion " + file + " --compare --angles 4 --plot " + quoted(plot.string()));
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("K1 [N*m/rad]"), std::string::npos);
  EXPECT_NE(text.out.find("4 positions over a turn"), std::string::npos);
  EXPECT_TRUE(contents(plot).starts_with("<svg"));
  const Outcome json = run("torsion " + file + " --format json");
  EXPECT_EQ(json.exit_code, 0) << json.err;
  const Json parsed = Json::parse(json.out);
  EXPECT_GT(parsed["positive"]["K1"]["value"].get<double>(), 1e4);
  EXPECT_TRUE(parsed.contains("provenance"));
  // The same numbers stand beside the series model.
  const Json beside = Json::parse(run("stiffness " + file + " --format json").out);
  EXPECT_EQ(beside["curve"]["positive"]["K1"]["value"].get<double>(),
            parsed["positive"]["K1"]["value"].get<double>());
  EXPECT_LT(beside["curve"]["positive"]["K3"]["value"].get<double>(),
            beside["curve"]["intact"]["K3"]["value"].get<double>());
  EXPECT_EQ(run("torsion " + file + " --format csv").out.rfind("torque [N*m],", 0), 0U);
}

TEST_F(Program, IdentityEveryRowIsFitted) {
  // Fits go far beyond what is plausible; none may leave what the model takes.
  const Outcome rows = run("validate --mode per-row --format csv");
  EXPECT_EQ(rows.exit_code, 0) << rows.err;
  EXPECT_TRUE(rows.err.empty()) << rows.err;
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

TEST_F(Program, IdentityAuditPrintsItsRowsInAllForms) {
  const Outcome json = run("audit --format json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  EXPECT_FALSE(Json::parse(json.out).empty());
  EXPECT_NE(run("audit").out.find("B9"), std::string::npos);
  EXPECT_NE(run("audit --format markdown").out.find('|'), std::string::npos);
}

TEST_F(Program, IdentityTypicalDriveOfACatalogueSize) {
  const Outcome drive = run("new --size 32 --ratio 50 --cup standard");
  ASSERT_EQ(drive.exit_code, 0) << drive.err;
  const Outcome curve = run("torsion --draws 0 " + write("size32.toml", drive.out));
  EXPECT_EQ(curve.exit_code, 0) << curve.err;
  for (const char* const arguments :
       {"new --size 32", "new --ratio 50", "new --size 22 --ratio 50", "new --size 32 --ratio 20",
        "catalogue --size 22", "validate --factors support"}) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 2) << arguments << refused.out;
    EXPECT_FALSE(refused.err.empty()) << arguments;
  }
}

TEST_F(Program, IdentityCatalogueAndValidation) {
  EXPECT_NE(run("catalogue --size 25 --ratio 100").out.find("87"), std::string::npos);
  const fs::path plot = in_folder("validation.svg");
  const Outcome outcome = run("validate --format json --plot " + quoted(plot.string()));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["rows"].size(), 35U);
  EXPECT_EQ(contents(plot).rfind("<svg", 0), 0U);
}

TEST_F(Program, IdentityCalibratedDriveIsAnInput) {
  const std::string drive = quoted(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  const std::string calibrated = quoted(in_folder("calibrated.toml").string());
  const Outcome outcome =
      run("calibrate " + drive + " --catalogue --factors coning --output " + calibrated);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(run("stiffness " + calibrated).exit_code, 0);
  const std::string curve =
      write("curve.csv", "torque [N*m],twist [arcmin]\n14,1.5\n48,4.1\n-48,-4.1\n");
  EXPECT_EQ(run("calibrate " + drive + " --factors coning --measured " + curve).exit_code, 0);
  EXPECT_EQ(run("calibrate " + drive).exit_code, 2);
  EXPECT_EQ(run("calibrate " + drive + " --catalogue --measured " + curve).exit_code, 2);
  EXPECT_EQ(run("calibrate " + drive + " --measured nowhere.csv").exit_code, 3);
}

TEST_F(Program, IdentitySensitivityInEveryForm) {
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
  EXPECT_EQ(report["scatter"]["samples"], 200);
  EXPECT_EQ(report["provenance"]["program"], "strainwave");
  const Outcome csv = run("sensitivity " + file + " --format csv");
  EXPECT_TRUE(csv.out.starts_with("output,path,unit,value,derivative,elasticity\n"));
  // One thread or three, the same bytes.
  const std::string scatter = "sensitivity " + file + " --scatter --samples 600 --threads ";
  EXPECT_EQ(run(scatter + "1").out, run(scatter + "3").out);
  EXPECT_NE(run(scatter + "1").out, run(scatter + "1 --seed 2").out);
}

TEST_F(Program, InputSensitivityOptions) {
  const std::string file = quoted(std::string(STRAINWAVE_EXAMPLES) + "/article.toml");
  EXPECT_EQ(run("sensitivity").exit_code, 2);
  EXPECT_EQ(run("sensitivity " + file + " --samples 100").exit_code, 2);  // of no study
  EXPECT_EQ(run("sensitivity " + file + " --scatter --samples 1").exit_code, 2);
  const Outcome none = run("sensitivity " + file + " --scatter");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.err.find("[[scatter]]"), std::string::npos);
  const std::string deep = changed_article("kind = \"annular\"\ndepth = \"0.1 mm\"",
                                           "kind = \"annular\"\ndepth = \"11 mm\"");
  const Outcome unusable = run("sensitivity " + deep);
  EXPECT_EQ(unusable.exit_code, 4);
  EXPECT_NE(unusable.err.find("a/t"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

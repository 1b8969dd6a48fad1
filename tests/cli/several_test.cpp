// SPDX-License-Identifier: Apache-2.0
// Several files, words that are no command, and what help says.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "strainwave/catalogue/factors.hpp"
#include "strainwave/command/exit_status.hpp"
#include "support/program.hpp"

namespace strainwave {
namespace {

using test::Outcome;

class SeveralFiles : public test::ProgramTest {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return execute(test::quoted(STRAINWAVE_CLI) + " " + arguments);
  }
  [[nodiscard]] static std::string example(const std::string& name) {
    return test::quoted(std::string(STRAINWAVE_EXAMPLES) + "/" + name + ".toml");
  }
  /// A file that breaks a rule.
  [[nodiscard]] std::string wrong_file() const {
    const auto file = in_folder("wrong.toml");
    std::ofstream(file) << "format = \"strainwave-drive/1\"\nratio = 1\n";
    return test::quoted(file.string());
  }
};

TEST_F(SeveralFiles, BehaviourOneRowForEachAndTheStatusOfTheWorst) {
  const Outcome both = run("stiffness " + example("article") + " " + example("through_crack"));
  EXPECT_EQ(both.exit_code, 0) << both.err;
  // The heading has four lines: the words of each name, and its unit.
  EXPECT_EQ(std::ranges::count(both.out, '\n'), 4 + 2) << both.out;
  EXPECT_NE(both.out.find("stiffness  stiffness_change"), std::string::npos) << both.out;
  EXPECT_NE(both.out.find("[N*m/arcmin]               [%]"), std::string::npos) << both.out;
  // A wrong file does not stop the next file.
  const Outcome wrong = run("stiffness " + wrong_file() + " " + example("article"));
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_NE(wrong.err.find("wrong.toml:2:1: ratio: is not known here"), std::string::npos)
      << wrong.err;
  EXPECT_NE(wrong.out.find("no answer"), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("179"), std::string::npos) << wrong.out;
}

TEST_F(SeveralFiles, RegressionTheCoupledDriveStandsFirst) {
  const Outcome both = run("stiffness " + example("article") + " " + example("cracked_size25"));
  EXPECT_EQ(both.exit_code, 0) << both.err;
  const std::size_t K1 = both.out.find(" K1 ");
  ASSERT_NE(K1, std::string::npos) << both.out;
  EXPECT_LT(K1, both.out.find(" K3 "));
  EXPECT_LT(both.out.find(" K3 "), both.out.find(" stiffness "));
  EXPECT_NE(both.out.find(" 7.48 "), std::string::npos) << both.out;
}

TEST_F(SeveralFiles, RegressionWhatIsWrongNamesItsFile) {
  const Outcome input = execute("printf 'ratio = 1\n' | " + test::quoted(STRAINWAVE_CLI) +
                                " stiffness - " + example("article"));
  EXPECT_EQ(input.err.find("-: "), std::string::npos) << input.err;
  EXPECT_NE(input.err.find("strainwave: standard input:1:1: "), std::string::npos) << input.err;
  EXPECT_NE(input.out.find("standard input"), std::string::npos) << input.out;
}

TEST_F(SeveralFiles, BehaviourAUnitThatTheAnswerHasNoPlaceForIsTold) {
  const std::string says = "--units kg,rpm: the answer shows no value of these dimensions\n";
  for (const std::string& files :
       {example("article"), example("article") + " " + example("article")}) {
    const Outcome unused = run("stiffness " + files + " --units kg,N*m/rad,rpm");
    EXPECT_EQ(unused.exit_code, 0);
    EXPECT_NE(unused.err.find(says), std::string::npos) << unused.err;
    EXPECT_EQ(run("stiffness " + files + " --units N*m/rad").err, "");
  }
}

TEST_F(SeveralFiles, BehaviourRequireTakesFilesAmongItsRequirements) {
  const std::string bound = "'cracked.positive.stiffness >= 2.5e5 N*m/rad'";
  const std::string too_much = "'cracked.positive.stiffness >= 2e6 N*m/rad'";
  const std::string files = example("article") + " " + example("through_crack") + " ";
  EXPECT_EQ(run("require " + files + bound).exit_code, 0);
  const Outcome broken = run("require " + files + too_much);
  EXPECT_EQ(broken.exit_code, 5) << broken.out << broken.err;
  EXPECT_NE(broken.out.find("not met"), std::string::npos);
  EXPECT_EQ(run("require " + files + bound + " " + wrong_file()).exit_code, 3);
}

TEST_F(SeveralFiles, BehaviourRequireHasARowForEachFileAndRequirement) {
  const Outcome table =
      run("require " + example("catalogue_size25") + " " + wrong_file() + " " +
          example("calibrated_size25") +
          " 'curve.positive.K2 >= 3e4 N*m/rad' 'curve.positive.change.K1 >= -1 %'");
  EXPECT_EQ(table.exit_code, 3);
  EXPECT_EQ(std::ranges::count(table.out, '\n'), 6) << table.out;
  for (const char* const said : {"bound", "value", "low", "high", "outcome", "curve.positive.K2",
                                 "30000 N*m/rad", "-1 %", "no answer"})
    EXPECT_NE(table.out.find(said), std::string::npos) << said << '\n' << table.out;
}

TEST_F(SeveralFiles, InputAMisspeltFileIsAFile) {
  const Outcome misspelt =
      run("require " + example("article") + " artcle.toml 'intact.stiffness > 1 N*m/rad'");
  EXPECT_EQ(misspelt.exit_code, 3);
  EXPECT_NE(misspelt.err.find("artcle.toml: cannot be opened for reading"), std::string::npos)
      << misspelt.err;
}

TEST_F(SeveralFiles, IdentityCsvAndJsonHaveTheOutputsOfEachFile) {
  const std::string files =
      example("article") + " " + wrong_file() + " " + example("through_crack");
  const Outcome csv = run("stiffness " + files +
                          " --format csv --units N*m/arcmin --columns "
                          "file,exit_status,cracked.positive.stiffness,fault");
  EXPECT_EQ(csv.exit_code, 3);
  EXPECT_TRUE(
      csv.out.starts_with("file,exit_status,cracked.positive.stiffness [N*m/arcmin],fault\n"))
      << csv.out;
  const Outcome text = run("stiffness " + files + " --format json");
  const auto json = nlohmann::json::parse(text.out);
  EXPECT_EQ(json["format"], "strainwave-results/1");
  ASSERT_EQ(json["answers"].size(), 3U);
  const auto alone =
      nlohmann::json::parse(run("stiffness " + example("article") + " --format json").out);
  EXPECT_EQ(json["answers"][0]["answer"], alone);
  EXPECT_EQ(json["answers"][1]["exit_status"], 3);
  EXPECT_TRUE(json["answers"][1]["answer"].is_null());
  EXPECT_FALSE(json["answers"][1]["fault"].get<std::string>().empty());
}

TEST_F(SeveralFiles, InputWhatShowsOneDriveIsRefusedForSeveral) {
  const std::string files = example("article") + " " + example("through_crack");
  const Outcome plot = run("stiffness " + files + " --plot x.svg");
  EXPECT_EQ(plot.exit_code, 2);
  EXPECT_NE(plot.err.find("--plot shows one drive: name one FILE"), std::string::npos) << plot.err;
  EXPECT_EQ(run("sweep " + files + " --vary drive.ratio=50..60:2").exit_code, 2);
}

TEST_F(SeveralFiles, InputAWordThatIsNoCommandIsNamed) {
  for (const auto& [line, says] : std::vector<std::pair<std::string, std::string>>{
           {"stifness f.toml", "stifness is not a command; did you mean strainwave stiffness?"},
           {"sif lst", "lst is not a command; did you mean strainwave sif list?"},
           {"sif", "sif needs a second word: list, show, eval, plot"},
           {"xyzzyxyzzy", "xyzzyxyzzy is not a command; strainwave --help lists the commands"},
           {"", "name a command; strainwave --help lists the commands"}}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
  }
}

// A fault that the parser of the line finds is worded like all other faults: with the name of the
// program, the nearest option, and the help of the command.
TEST_F(SeveralFiles, InputFaultsOfTheLineNameOptionAndCommand) {
  const std::string article = example("article");
  for (const auto& [line, says] : std::vector<std::pair<std::string, std::string>>{
           {"stiffness " + article + " --fomat csv",
            "the option --fomat is not known here; did you mean --format? strainwave stiffness "
            "--help lists the known options"},
           {"stiffness " + article + " --vary=1",
            "the option --vary is not known here; this option belongs to sweep, solve; strainwave "
            "stiffness --help lists the known options"},
           {"sif show plate-through -x",
            "the option -x is not known here; strainwave sif show --help lists the known options"},
           {"--verson",
            "the option --verson is not known here; did you mean --version? strainwave --help "
            "lists the known options"},
           {"explain ratio more",
            "the word more is not expected here; strainwave explain --help shows what the command "
            "takes"},
           {"stiffness",
            "stiffness needs FILE (input file, or - for standard input; several files give a table "
            "with one row for each); see strainwave stiffness --help"},
           {"stiffness " + article + " --method",
            "--method needs a value after it: theory to use: as-printed, repaired, corrected; "
            "default corrected"},
           {"stiffness " + article + " --output=",
            "--output needs a value after it: write to this file instead of standard output"},
           {"stiffness " + article + " --format csv --format csv",
            "--format is given more than once; give it once"},
           {"stiffness " + article + " --format xml",
            "--format: xml is not a choice here; choose one of text, csv, json"},
           {"sensitivity " + article + " --scatter --seed 99999999999999999999",
            "--seed: 99999999999999999999 violates: >= 0 and <= 9223372036854775807"},
           {"sensitivity " + article + " --scatter --seed x",
            "--seed: x is not a whole number, such as 100"}}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_EQ(outcome.err, "strainwave: " + says + "\n") << line;
    EXPECT_TRUE(outcome.out.empty()) << line;
  }
}

// The guide lists each exit status and each factor in the words of the program.
TEST_F(SeveralFiles, BehaviourTheGuideListsStatusesAndFactors) {
  const std::string page =
      test::contents(std::string(STRAINWAVE_EXAMPLES) + "/../docs/guide/command_line.md");
  for (const auto& [status, meaning] : kExitStatuses)
    EXPECT_NE(page.find("| " + std::to_string(static_cast<int>(status)) + " | " +
                        std::string(meaning) + " |\n"),
              std::string::npos)
        << meaning;
  for (const std::string_view factor : EnumNames<Factor>::names)
    EXPECT_NE(page.find("| `" + std::string(factor) + "` |"), std::string::npos) << factor;
}

// Words of the program itself are explained too.
TEST_F(SeveralFiles, BehaviourExplainKnowsTheOptionsOfTheProgram) {
  for (const auto& [word, says] : std::vector<std::pair<std::string, std::string>>{
           {"--force", "option of fit, calibrate, new"},
           {"-o", "short for --output"},
           {"--units", "of the answer, such as mm"},
           {"completion", "Print a script that completes words in a shell"},
           {"fe", "Finite elements of shaft and cup"}}) {
    const Outcome outcome = run("explain -- " + word);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(says), std::string::npos) << word << '\n' << outcome.out;
  }
}

TEST_F(SeveralFiles, InputLikeFaultsEndAlike) {
  // An option that needs another one.
  for (const std::string& line : {"torsion " + example("catalogue_size25") + " --angles 3",
                                  "sensitivity " + example("article_scatter") + " --seed 3",
                                  "stiffness " + example("article") + " --columns path"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_NE(outcome.err.find(" --"), std::string::npos) << outcome.err;
  }
  // An unknown name, in an option or as an option.
  for (const std::string line :
       {"material show nothing", "sif show nothing", "sif plot nothing", "sif eval nothing",
        "sif list --family nothing", "explain nothingg", "man nothing", "catalogue --size 1"})
    EXPECT_EQ(run(line).exit_code, 2) << line;
}

TEST_F(SeveralFiles, RegressionANegativeSeedIsRefusedBriefly) {
  const Outcome outcome = run("sensitivity " + example("article_scatter") + " --scatter --seed -1");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 80U) << outcome.err;
}

TEST_F(SeveralFiles, RegressionTorsionNamesVersionAndFile) {
  const Outcome outcome = run("torsion " + example("catalogue_size25") + " --draws 0");
  EXPECT_NE(outcome.out.find("catalogue_size25.toml, strainwave "), std::string::npos);
}

TEST_F(SeveralFiles, RegressionTheVersionIsInEveryJson) {
  for (const std::string line : {"validate", "sif eval plate-surface", "units", "catalogue"}) {
    const auto json = nlohmann::json::parse(run(line + " --format json").out);
    EXPECT_FALSE(json["provenance"]["version"].get<std::string>().empty()) << line;
  }
}

TEST_F(SeveralFiles, RegressionExamplesOfHelpShowTheirCommand) {
  for (const std::string command : {"sif list", "sif show", "sif plot", "sif eval", "material list",
                                    "material show", "units", "explain", "diff"}) {
    const std::string help = run(command + " --help").out;
    EXPECT_NE(help.find("Example:\n  strainwave " + command), std::string::npos) << help;
  }
}

TEST_F(SeveralFiles, RegressionManualPagesTellTheShortOption) {
  EXPECT_NE(run("man stiffness").out.find("\\fB\\-o\\fR, \\fB\\-\\-output\\fR"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

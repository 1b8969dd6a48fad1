// SPDX-License-Identifier: Apache-2.0
// strainwave-fe from outside, by its own name and as `strainwave fe`.
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace strainwave {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

using test::contents;
using test::Outcome;

class FeProgram : public test::ProgramTest {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments,
                            const std::string& program = "'" STRAINWAVE_FE "'") const {
    return execute(program + " " + arguments);
  }
};

const std::string kShaft = "'" STRAINWAVE_EXAMPLES "/solid_shaft.toml'";
const std::string kCup = "'" STRAINWAVE_EXAMPLES "/cup_sections.toml'";
const std::string kThrough = "'" STRAINWAVE_EXAMPLES "/through_crack.toml'";
const std::string kThroughCrack =
    "[[flexspline.crack]]\nkind = \"through\"\nsection = \"barrel\"\nhalf_length = \"1.5 mm\"\n"
    "angle = \"-45 deg\"\n";
const std::string kSurfaceCrack =
    "[[flexspline.crack]]\nkind = \"surface\"\nsection = \"rim\"\ndepth = \"0.4 mm\"\n"
    "half_length = \"0.8 mm\"\nangle = \"45 deg\"\n\n";
const std::string kMain = "'" STRAINWAVE_CLI "' fe";

TEST_F(FeProgram, CrosscheckShaftExampleByBothPrograms) {
  const Outcome fe = run(kShaft + " --format json", kMain);
  ASSERT_EQ(fe.exit_code, 0) << fe.err;
  const Json json = Json::parse(fe.out);
  EXPECT_TRUE(json["usable"]);
  const Json& crack = json["result"]["output_shaft"]["cracks"][0];
  EXPECT_EQ(crack["path"], "output_shaft.crack[0]");
  EXPECT_TRUE(json.contains("provenance"));
  const Outcome closed = run("stiffness " + kShaft + " --format json", "'" STRAINWAVE_CLI "'");
  ASSERT_EQ(closed.exit_code, 0) << closed.err;
  const Json other = Json::parse(closed.out)["result"]["cracks"][0]["stress_intensity"];
  for (const char* const mode : {"K_I", "K_III"}) {
    const double here = crack["stress_intensity"][mode]["value"];
    const double there = other["deepest"][mode]["value"];
    EXPECT_NEAR(here / there, 1, 1e-3) << mode;
  }
  // The text document agrees.
  const Outcome text = run(kShaft + " --order 4");
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("; usable"), std::string::npos) << text.out;
}

TEST_F(FeProgram, IdentityCupSharesAndFileOutput) {
  const fs::path file = folder_ / "cup.json";
  // Cracks of the wall would be solids; a crack of the diaphragm is left out.
  const std::string sound = changed("cup_sections.toml", kSurfaceCrack + kThroughCrack,
                                    "[[flexspline.crack]]\nkind = \"diaphragm_arc\"\n"
                                    "half_length = \"1 mm\"\n");
  const Outcome cup = run(sound + " --format json --order 4 -o '" + file.string() + "'");
  ASSERT_EQ(cup.exit_code, 0) << cup.err;
  EXPECT_TRUE(cup.out.empty());
  const Json json = Json::parse(contents(file));
  double shares = 0.0;
  for (const Json& part : json["result"]["flexspline"]["sound"]["parts"])
    shares += part["share"]["value"].get<double>();
  EXPECT_NEAR(shares, 1, 1e-8);
  EXPECT_EQ(json["result"]["section_order"], 4);
  EXPECT_TRUE(json["result"]["flexspline"]["cracks"].empty());
  EXPECT_NE(json["notes"][0]["text"].get<std::string>().find("flexspline.crack[0] is left out"),
            std::string::npos);
}

// Two ranks give one printout and the same numbers; standard input reaches only one rank.
TEST_F(FeProgram, IdentityTwoRanks) {
  const std::string two =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1 "
      "mpirun --oversubscribe -n 2 '" STRAINWAVE_FE "'";
  const Outcome one_rank = run(kShaft + " --order 3 --format json");
  const Outcome two_ranks = run(kShaft + " --order 3 --format json", two);
  EXPECT_EQ(one_rank.exit_code, two_ranks.exit_code) << two_ranks.err;
  EXPECT_EQ(one_rank.out, two_ranks.out);
  const Outcome piped = run("- <" + kShaft, two);
  EXPECT_EQ(piped.exit_code, 3);
  EXPECT_NE(piped.err.find("standard input reaches the first rank only"), std::string::npos);
}

// A fault of a single rank ends all ranks with a message, and no rank waits.
TEST_F(FeProgram, InputFaultsOfOneRankEndAll) {
  const std::string mpirun =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1 "
      "timeout 60 mpirun --oversubscribe ";
  const std::string fe = "'" STRAINWAVE_FE "' ";
  const auto told = [](const Outcome& outcome, int code, const std::string& words) {
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    const std::size_t at = outcome.err.find(words);
    ASSERT_NE(at, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find(words, at + 1), std::string::npos) << "once: " << outcome.err;
  };
  // Only the first rank writes.
  told(run(kShaft + " --dry-run -o /nowhere/plan.txt", mpirun + "-n 2 " + fe), 7,
       "strainwave-fe: /nowhere/plan.txt");
  told(run(kShaft + " --order 2 -o /nowhere/result.txt", mpirun + "-n 2 " + fe), 7,
       "strainwave-fe: /nowhere/result.txt");
  told(run("tabulate " + kShaft +
               " --order 2 --over 'output_shaft.crack[0].depth=6 mm..9 mm:2' -o /nowhere/t.csv",
           mpirun + "-n 2 " + fe),
       7, "strainwave-fe: /nowhere/t.csv");
  // A file that exists only on the first machine.
  told(run("/nowhere.toml --dry-run", mpirun + "-n 1 " + fe + kShaft + " --dry-run : -n 1 " + fe),
       3, "strainwave-fe: rank 1: /nowhere.toml");
}

TEST_F(FeProgram, IdentityDryRunCalculatesNothing) {
  const Outcome plan = run(kShaft + " --dry-run --format json");
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  const Json json = Json::parse(plan.out)["result"]["plan"][0];
  EXPECT_EQ(json["path"], "output_shaft.crack[0]");
  EXPECT_NEAR(json["unknowns"].get<double>(), 12306, 2500);
  EXPECT_NE(run(kCup + " --dry-run").out.find("unknowns"), std::string::npos);
  // Two sizes under both senses of torque.
  const Outcome surface = run("'" STRAINWAVE_EXAMPLES "/part_through_crack.toml' --dry-run");
  EXPECT_NE(surface.out.find("unknowns, 2 solutions"), std::string::npos) << surface.out;
}

// The value is 210 GPa/2.6; a note reports that a given modulus is not used.
TEST_F(FeProgram, IdentityShearModulusFollowsFromTheOthers) {
  const auto with = [&](const std::string& modulus) {
    return run(changed("solid_shaft.toml", "poissons_ratio = 0.3",
                       "poissons_ratio = 0.3\nshear_modulus = \"" + modulus + "\"") +
               " --order 3 --format json");
  };
  const Outcome other = with("70 GPa");
  ASSERT_EQ(other.exit_code, 0) << other.err;
  const Json json = Json::parse(other.out);
  EXPECT_NE(
      json["notes"].dump().find("output_shaft.material: finite elements use the shear modulus "
                                "E/(2(1+nu)), 80.769 GPa, not the given one"),
      std::string::npos)
      << json["notes"];
  const Outcome same = with("80.7692307692 GPa");
  EXPECT_EQ(same.out.find("the given one"), std::string::npos);
  EXPECT_EQ(Json::parse(same.out)["result"]["output_shaft"], json["result"]["output_shaft"]);
}

TEST_F(FeProgram, InputErrorsByCodeAndName) {
  EXPECT_EQ(run("").exit_code, 2);
  EXPECT_EQ(run(kShaft + " --order 9").exit_code, 2);
  EXPECT_EQ(run(kShaft + " --member rim").exit_code, 2);
  EXPECT_EQ(run("--help", kMain).exit_code, 0);
  EXPECT_NE(run("--version", kMain).out.find("strainwave-fe"), std::string::npos);
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 3) << arguments;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  };
  refused(changed("cup_sections.toml", kSurfaceCrack,
                  "[[flexspline.crack]]\nkind = \"diaphragm_arc\"\nhalf_length = \"1 mm\"\n\n") +
              " --member flexspline",
          "flexspline.crack[0]: finite elements do not compute a crack of kind \"diaphragm_arc\"");
  refused(changed("part_through_crack.toml", "\"1 mm\"\nhalf_length = \"2 mm\"",
                  "\"2.1 mm\"\nhalf_length = \"3 mm\"") +
              " --dry-run",
          "flexspline.crack[0]: depth");
  refused(changed("part_through_crack.toml", "length = \"160 mm\"", "length = \"5 mm\""),
          "flexspline.crack[0]: half_length: the crack needs");
  refused(changed("cracked_size25.toml", "\"2 mm\"\n\n[[flexspline.crack]]\nkind = \"diaphragm_arc",
                  "\"11 mm\"\n\n[[flexspline.crack]]\nkind = \"diaphragm_arc") +
              " --crack 'flexspline.crack[0]' --dry-run",
          "flexspline.crack[0]: half_length: the crack ends 0.8218 mm from the diaphragm");
  refused(kCup + " --member output-shaft", "output_shaft: must be given to be computed");
  refused(kShaft + " --member flexspline", "flexspline: must be given to be computed");
  refused("/nowhere.toml", "/nowhere.toml");
  refused(kThrough + " --order 5", "order");
  // A crack that does not fit into its tube is refused before the first solution, and also by a
  // plan.
  const std::string long_crack = changed("through_crack.toml", "\"10 mm\"", "\"72 mm\"");
  refused(long_crack, "flexspline.crack[0]: half_length: the crack needs");
  refused(long_crack + " --dry-run", "flexspline.crack[0]: half_length: the crack needs");
  refused(changed("solid_shaft.toml", "9 mm", "31 mm"), "output_shaft.crack[0].depth");
  refused(changed("solid_shaft.toml",
                  "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"9 mm\"", ""),
          "must give a part that finite elements can compute");
}

// Without a command word, `run` is used; the rest is the command line of every table.
TEST_F(FeProgram, IdentityCommandLineOfTheTable) {
  EXPECT_EQ(run("run " + kShaft + " --dry-run").out, run(kShaft + " --dry-run").out);
  EXPECT_EQ(run("--dry-run " + kShaft).out, run(kShaft + " --dry-run").out);
  for (const char* const command : {"run", "tabulate", "render", "schema", "man", "completion"})
    EXPECT_NE(run("--help").out.find(command), std::string::npos) << command;
  EXPECT_NE(run("man tabulate").out.find("strainwave\\-fe tabulate"), std::string::npos);
  EXPECT_EQ(run("completion words -- tab").out, "tabulate\n");
  EXPECT_EQ(run("completion words -- --member fl").out, "flexspline\n");
  EXPECT_EQ(run("completion words -- x.toml --me").out, "--member\n");
  const Outcome paths = run("completion words -- tabulate " + kShaft + " --over output_shaft.c");
  EXPECT_EQ(paths.out, "output_shaft.crack[0].depth\n") << paths.err;
  EXPECT_EQ(Json::parse(run("schema --of result --command run").out)["title"],
            "strainwave-fe run: Compute the members of a drive by finite elements");
}

TEST_F(FeProgram, IdentityClosedUnderCompression) {
  const std::string pressed = changed("solid_shaft.toml", "\"10 kN\"", "\"-10 kN\"");
  const Outcome outcome = run(pressed + " --order 4");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("the crack is closed, K_I = 0"), std::string::npos) << outcome.out;
}

TEST_F(FeProgram, InputWithoutTheProgramSaysSo) {
  fs::copy_file(STRAINWAVE_CLI, folder_ / "strainwave");
  const Outcome alone =
      run("x.toml", "PATH=/nowhere '" + (folder_ / "strainwave").string() + "' fe");
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.err.find("strainwave-fe: is neither beside"), std::string::npos) << alone.err;
}

}  // namespace
}  // namespace strainwave

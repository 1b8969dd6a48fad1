// SPDX-License-Identifier: Apache-2.0
// strainwave-fe from outside, by its own name and as `strainwave fe`.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
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

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class FeProgram : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("strainwave fe " + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& program = "'" STRAINWAVE_FE "'") {
    const std::string command = program + " " + arguments + " >'" + (folder_ / "out").string() +
                                "' 2>'" + (folder_ / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder_ / "out"),
            contents(folder_ / "err")};
  }

  /// An example with one text replaced by another.
  std::string changed(const std::string& example, const std::string& from, const std::string& to) {
    std::string text = contents(fs::path(STRAINWAVE_EXAMPLES) / example);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(folder_ / "changed.toml") << text.replace(at, from.size(), to);
    return "'" + (folder_ / "changed.toml").string() + "'";
  }

  fs::path folder_;
};

const std::string kShaft = "'" STRAINWAVE_EXAMPLES "/solid_shaft.toml'";
const std::string kCup = "'" STRAINWAVE_EXAMPLES "/cup_sections.toml'";
const std::string kMain = "'" STRAINWAVE_CLI "' fe";

TEST_F(FeProgram, CrosscheckShaftExampleByBothPrograms) {
  const Outcome fe = run(kShaft + " --format json", kMain);
  ASSERT_EQ(fe.exit_code, 0) << fe.err;
  const Json json = Json::parse(fe.out);
  EXPECT_TRUE(json["usable"]);
  const Json& crack = json["output_shaft"]["cracks"][0];
  EXPECT_EQ(crack["path"], "output_shaft.crack[0]");
  EXPECT_TRUE(json.contains("provenance"));
  const Outcome closed = run("stiffness " + kShaft + " --format json", "'" STRAINWAVE_CLI "'");
  ASSERT_EQ(closed.exit_code, 0) << closed.err;
  const Json other = Json::parse(closed.out)["cracks"][0]["stress_intensity"];
  for (const char* const mode : {"K_I", "K_III"}) {
    const double here = crack["stress_intensity"][mode]["value"];
    const double there = other["deepest"][mode]["value"];
    EXPECT_NEAR(here / there, 1, 1e-3) << mode;
  }
  // Text says the same.
  const Outcome text = run(kShaft);
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("; usable"), std::string::npos) << text.out;
}

TEST_F(FeProgram, IdentityCupSharesAndFileOutput) {
  const fs::path file = folder_ / "cup.json";
  const Outcome cup = run(kCup + " --format json --order 4 -o '" + file.string() + "'");
  ASSERT_EQ(cup.exit_code, 0) << cup.err;
  EXPECT_TRUE(cup.out.empty());
  const Json json = Json::parse(contents(file));
  double shares = 0.0;
  for (const Json& part : json["flexspline"]["parts"])
    shares += part["share"]["value"].get<double>();
  EXPECT_NEAR(shares, 1, 1e-8);
  EXPECT_EQ(json["order"], 4);
  EXPECT_EQ(json["notes"].size(), 1U);  // its cracks are left out
}

TEST_F(FeProgram, IdentityDryRunCalculatesNothing) {
  const Outcome plan = run(kShaft + " --dry-run --format json");
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  const Json json = Json::parse(plan.out)["plan"][0];
  EXPECT_EQ(json["path"], "output_shaft.crack[0]");
  EXPECT_NEAR(json["unknowns"].get<double>(), 12306, 2500);
  EXPECT_NE(run(kCup + " --dry-run").out.find("unknowns"), std::string::npos);
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
  refused(kCup + " --member flexspline", "flexspline.crack[0]: a crack in the flexspline");
  refused(kCup + " --member output-shaft", "output_shaft: is not given");
  refused(kShaft + " --member flexspline", "flexspline: is not given");
  refused("/nowhere.toml", "/nowhere.toml");
  refused("'" STRAINWAVE_EXAMPLES "/article.toml' --member flexspline", "flexspline.crack_free");
  refused(changed("solid_shaft.toml", "9 mm", "31 mm"), "output_shaft.crack[0].depth");
  refused(changed("solid_shaft.toml",
                  "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"9 mm\"", ""),
          "gives nothing that finite elements can calculate");
}

TEST_F(FeProgram, IdentityClosedUnderCompression) {
  const std::string pressed = changed("solid_shaft.toml", "\"10 kN\"", "\"-10 kN\"");
  const Outcome outcome = run(pressed + " --order 4");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("closed, no K_I"), std::string::npos) << outcome.out;
}

TEST_F(FeProgram, InputWithoutTheProgramSaysSo) {
  fs::copy_file(STRAINWAVE_CLI, folder_ / "strainwave");
  const Outcome alone =
      run("x.toml", "PATH=/nowhere '" + (folder_ / "strainwave").string() + "' fe");
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.err.find("strainwave-fe is neither beside"), std::string::npos) << alone.err;
}

}  // namespace
}  // namespace strainwave

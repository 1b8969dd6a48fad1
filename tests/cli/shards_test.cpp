// SPDX-License-Identifier: Apache-2.0
// Studies in shares on the command line: files that are kept, replaced or refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/program.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Outcome;
using test::quoted;

class ShardFiles : public test::ProgramTest {
 protected:
  static constexpr const char* kSweep =
      " --vary 'output_shaft.crack[0].depth=0.05 mm..8 mm:7:log' --quiet";

  [[nodiscard]] Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return execute(before + quoted(STRAINWAVE_CLI) + " " + arguments);
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return quoted(in_folder(name).string());
  }
  /// Computes a share of the sweep.
  [[nodiscard]] Outcome shard(const std::string& share, const std::string& name,
                              const std::string& more = {}) const {
    return run("sweep " + kArticle + kSweep + " --shard " + share + " -o " + path(name) + more);
  }

  const std::string kArticle = quoted(STRAINWAVE_EXAMPLES "/article.toml");
};

TEST_F(ShardFiles, IdentityMergedAnswerIsThatOfOneRun) {
  for (const char* const share : {"3/3", "1/3", "2/3"}) {
    const Outcome made = shard(share, std::string(1, share[0]) + ".shard");
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.out + made.err, "");
  }
  const std::string all = path("2.shard") + ' ' + path("3.shard") + ' ' + path("1.shard");
  const Outcome whole = run("sweep " + kArticle + kSweep + " --plot " + path("whole.svg"));
  const Outcome merged = run("merge " + all + " --plot " + path("merged.svg"));
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_EQ(contents(in_folder("merged.svg")), contents(in_folder("whole.svg")));
  for (const std::string options :
       {"--format json", "--format csv --units mm,lbf*in/arcmin --columns intact.stiffness"}) {
    EXPECT_EQ(run("merge " + all + ' ' + options).out,
              run("sweep " + kArticle + kSweep + ' ' + options).out)
        << options;
  }
  const Outcome no_text = run("merge " + all + " --format text");
  EXPECT_EQ(no_text.exit_code, 2);
  EXPECT_NE(no_text.err.find("sweep does not make text"), std::string::npos) << no_text.err;
}

TEST_F(ShardFiles, BehaviourACompleteShareIsKept) {
  ASSERT_EQ(shard("1/2", "a.shard").exit_code, 0);
  const std::string text = contents(in_folder("a.shard"));
  const auto written = fs::last_write_time(in_folder("a.shard"));
  const Outcome again = run("sweep " + kArticle +
                            " --vary 'output_shaft.crack[0].depth=0.05 mm..8 mm:7:log'"
                            " --shard 1/2 -o " +
                            path("a.shard"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("a.shard has share 1/2 already; it is kept"), std::string::npos)
      << again.err;
  EXPECT_EQ(fs::last_write_time(in_folder("a.shard")), written);
  // A file that was cut, as by a copy that was interrupted, is replaced.
  fs::resize_file(in_folder("a.shard"), text.size() - 5);
  EXPECT_EQ(shard("1/2", "a.shard").exit_code, 0);
  EXPECT_EQ(contents(in_folder("a.shard")), text);
}

TEST_F(ShardFiles, InputOtherFilesAreNotReplaced) {
  ASSERT_EQ(shard("1/2", "a.shard").exit_code, 0);
  const Outcome other = shard("2/2", "a.shard");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("a.shard is another shard, because the share is 1/2 in one and 2/2 in "
                           "the other: remove it or name another file"),
            std::string::npos)
      << other.err;
  const Outcome method = shard("1/2", "a.shard", " --method repaired");
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_NE(method.err.find("the option method is left out in one and repaired in the other"),
            std::string::npos)
      << method.err;
  (void)write("mine.txt", "mine");
  const Outcome mine = shard("1/2", "mine.txt");
  EXPECT_EQ(mine.exit_code, 2);
  EXPECT_NE(mine.err.find("exists already and is not a shard: name another file"),
            std::string::npos)
      << mine.err;
  EXPECT_EQ(contents(in_folder("mine.txt")), "mine");
}

TEST_F(ShardFiles, InputWhatAShareCannotDo) {
  const std::string sweep = "sweep " + kArticle + kSweep + " --shard 1/2";
  const auto said = [&](const std::string& arguments, int code) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, code) << arguments << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(said(sweep, 2).find("name a file with --output"), std::string::npos);
  for (const std::string with : {"--format json", "--units mm", "--columns x", "--plot "})
    EXPECT_NE(
        said(sweep + " -o " + path("a") + ' ' + with + (with == "--plot " ? path("b") : ""), 2)
            .find(with == "--columns x" ? "--columns" : "leave out --format"),
        std::string::npos)
        << with;
  EXPECT_NE(said("require " + kArticle + " 'intact.stiffness > 0 N*m/rad' --shard 1/2", 2)
                .find("belongs to"),
            std::string::npos);
  for (const char* const file : {"/dev/full", "/dev/null"})
    EXPECT_NE(said(sweep + " -o " + file, 7).find("must be a regular file"), std::string::npos);
  EXPECT_NE(said(sweep + " -o " + path("none/a"), 7).find("cannot be written"), std::string::npos);
  // No file is left behind if the disk is full.
  const Outcome full = run(sweep + " -o " + path("a.shard"), "ulimit -f 1; ");
  EXPECT_EQ(full.exit_code, 7) << full.err;
  EXPECT_TRUE(fs::is_empty(folder_) || !fs::exists(in_folder("a.shard")));
  EXPECT_NE(said("merge", 2).find("must be given"), std::string::npos);
  EXPECT_NE(said("merge " + kArticle, 3).find("is not a shard"), std::string::npos);
  EXPECT_NE(said("merge " + path("none"), 3).find("none"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

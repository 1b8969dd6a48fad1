// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/attachments.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;

/// The message that refuses an attachment; "accepted" if it is valid.
std::string attachment_refusal(const Attachments& attachments, std::string_view name) {
  try {
    (void)attachments.text(name, "table");
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "table");
    return error.what();
  }
  return "accepted";
}

std::string absent(const std::string& name) {
  return "table: \"" + name + "\" is not a file beside the input";
}

std::string not_below(const std::string& name) {
  return "table: \"" + name +
         "\" must be a name relative to the folder of the input, with / between folders and "
         "without .. and :";
}

/// A folder `drives` with an input, a folder of tables below it, and a secret beside it.
class AttachmentsBeside : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("strainwave attachments " + std::to_string(::getpid()));
    fs::create_directories(root_ / "drives/tables");
    write("drives/tables/a.csv", "a");
    write("drives/b.csv", "b");
    write("secret.csv", "secret");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  void link(const std::string& to, const std::string& name) const {
    fs::create_symlink(to, root_ / "drives" / name);
  }
  [[nodiscard]] Attachments beside() const { return attachments_beside(root_ / "drives/x.toml"); }
  [[nodiscard]] std::string refused(const std::string& name) const {
    return attachment_refusal(beside(), name);
  }

  fs::path root_;
};

TEST(AttachmentsGiven, BehaviourByNameOrLookedUp) {
  EXPECT_EQ(attachment_refusal(Attachments(), "a"), absent("a"));
  const Attachments given({{"tables/a.csv", "1"}, {"b", "2"}});
  EXPECT_EQ(given.text("tables/a.csv", "table"), "1");
  EXPECT_EQ(given.text("b", "table"), "2");
  EXPECT_EQ(attachment_refusal(given, "c"), absent("c"));
  const Attachments looked_up(
      [](std::string_view name) { return name == "a" ? std::optional("1") : std::nullopt; });
  EXPECT_EQ(looked_up.text("a", "table"), "1");
  EXPECT_EQ(attachment_refusal(looked_up, "b"), absent("b"));
}

TEST(AttachmentsGiven, InputTheRuleOfNamesAndSizesHoldsForAnySource) {
  const Attachments any([](std::string_view) { return std::optional("x"); });
  for (const std::string name : {"/etc/passwd", "..", "../a", "a/../../b", "a/..", "C:a", "a\\b"})
    EXPECT_TRUE(attachment_refusal(any, name).ends_with("without .. and :")) << name;
  EXPECT_TRUE(attachment_refusal(any, std::string_view("a\0b", 3)).ends_with(".. and :"));
  for (const std::string name : {"a", "..a", "a..b/c", "./a"})
    EXPECT_EQ(attachment_refusal(any, name), "accepted") << name;
  const Attachments sized(
      {{"most", std::string(kMaxTextSize, 'x')}, {"more", std::string(kMaxTextSize + 1, 'x')}});
  EXPECT_EQ(attachment_refusal(sized, "most"), "accepted");
  EXPECT_EQ(attachment_refusal(sized, "more"), "table: \"more\" is larger than 1 MiB");
}

TEST_F(AttachmentsBeside, BehaviourFilesBelowTheFolder) {
  EXPECT_EQ(beside().text("tables/a.csv", "table"), "a");
  EXPECT_EQ(beside().text("./b.csv", "table"), "b");
  link("tables/a.csv", "inside.csv");
  EXPECT_EQ(beside().text("inside.csv", "table"), "a");
  // The folder itself may be reached by a link.
  fs::create_directory_symlink(root_ / "drives", root_ / "link");
  EXPECT_EQ(attachments_beside(root_ / "link/x.toml").text("b.csv", "table"), "b");
}

TEST_F(AttachmentsBeside, BehaviourANameWithoutFolderMeansTheCurrentOne) {
  const fs::path before = fs::current_path();
  fs::current_path(root_ / "drives");
  EXPECT_EQ(attachments_beside("x.toml").text("b.csv", "table"), "b");
  EXPECT_EQ(attachments_beside("-").text("b.csv", "table"), "b");
  fs::current_path(before);
}

TEST_F(AttachmentsBeside, InputNamesThatLeadOutAreRefusedUnopened) {
  EXPECT_EQ(refused((root_ / "secret.csv").string()), not_below((root_ / "secret.csv").string()));
  for (const std::string name : {"/etc/passwd", "/no/such/file", "../secret.csv", "../no_such.csv",
                                 "tables/../../secret.csv", "tables/../b.csv"})
    EXPECT_EQ(refused(name), not_below(name));
}

TEST_F(AttachmentsBeside, InputLinksOutDoNotTellWhatExists) {
  link("../secret.csv", "to_secret.csv");
  link("../no_such.csv", "to_nothing.csv");
  link((root_ / "secret.csv").string(), "absolute.csv");
  link("..", "up");
  link("/etc", "etc");
  for (const std::string name : {"to_secret.csv", "to_nothing.csv", "absolute.csv", "up/secret.csv",
                                 "up/no_such.csv", "etc/passwd", "etc/no_such", "no_such.csv"})
    EXPECT_EQ(refused(name), absent(name));
  // A folder whose name only begins with the name of the input's folder is a different folder.
  fs::create_directories(root_ / "drives2");
  write("drives2/c.csv", "c");
  link("../drives2/c.csv", "neighbour.csv");
  EXPECT_EQ(refused("neighbour.csv"), absent("neighbour.csv"));
}

TEST_F(AttachmentsBeside, InputOnlyRegularFiles) {
  link("/dev/zero", "device");
  ASSERT_EQ(::mkfifo((root_ / "drives/pipe").c_str(), 0600), 0);
  link("pipe", "to_pipe");
  link("loop", "loop");
  for (const std::string name :
       {"tables", "device", "pipe", "to_pipe", "loop", "", ".", "tables/", "b.csv/", "b.csv/c"})
    EXPECT_EQ(refused(name), absent(name));
}

TEST_F(AttachmentsBeside, LimitOneMebibyte) {
  write("drives/most.csv", std::string(kMaxTextSize, 'x'));
  write("drives/more.csv", std::string(kMaxTextSize + 1, 'x'));
  EXPECT_EQ(refused("most.csv"), "accepted");
  EXPECT_EQ(refused("more.csv"), "table: \"more.csv\" is larger than 1 MiB");
}

TEST(ReadText, LimitAStreamIsReadUpToOneByteMore) {
  std::istringstream stream(std::string(kMaxTextSize + 100, 'x'));
  EXPECT_EQ(read_text(stream, "stream").size(), kMaxTextSize + 1);
  std::istringstream empty;
  EXPECT_EQ(read_text(empty, "stream"), "");
}

}  // namespace
}  // namespace strainwave

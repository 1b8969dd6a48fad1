// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/write_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

class WriteFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("strainwave write " + std::to_string(::getpid()) + " " +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string text_in(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::size_t n_files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }
  void write(const std::string& name, const std::string& text) const {
    WaitingFile(folder_ / name, text).replace();
  }

  std::filesystem::path folder_;
};

TEST_F(WriteFile, BehaviourTheOldTextStaysUntilTheNewOneTakesItsPlace) {
  put("r.txt", "old");
  {
    const WaitingFile given_up(folder_ / "r.txt", "new");
    EXPECT_EQ(text_in("r.txt"), "old");
    EXPECT_EQ(n_files(), 2U);
  }
  EXPECT_EQ(text_in("r.txt"), "old");
  EXPECT_EQ(n_files(), 1U);
  write("r.txt", "new");
  EXPECT_EQ(text_in("r.txt"), "new");
  EXPECT_EQ(n_files(), 1U);
}

TEST_F(WriteFile, BehaviourAReplacedFileKeepsItsPermissions) {
  using std::filesystem::perms;
  for (const perms mode : {perms::owner_read | perms::owner_write,
                           perms::owner_read | perms::owner_write | perms::group_read |
                               perms::group_write | perms::others_write}) {
    put("r.txt", "old");
    std::filesystem::permissions(folder_ / "r.txt", mode);
    write("r.txt", "new");
    EXPECT_EQ(text_in("r.txt"), "new");
    EXPECT_EQ(std::filesystem::status(folder_ / "r.txt").permissions(), mode);
  }
}

TEST_F(WriteFile, BehaviourALinkStaysAndItsTargetIsReplaced) {
  std::filesystem::create_directory(folder_ / "below");
  put("below/r.txt", "old");
  std::filesystem::create_symlink("below/r.txt", folder_ / "first");
  std::filesystem::create_symlink("first", folder_ / "second");
  write("second", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "second"));
  EXPECT_EQ(text_in("below/r.txt"), "new");
  // This also holds if the target does not exist yet.
  std::filesystem::create_symlink("below/s.txt", folder_ / "third");
  write("third", "made");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "third"));
  EXPECT_EQ(text_in("below/s.txt"), "made");
}

TEST_F(WriteFile, BehaviourFilesOfSimilarNamesStay) {
  for (const char* const name : {"r.txt.part", "r.txt.1.part", "r.txt.2.part"}) put(name, "mine");
  write("r.txt", "new");
  EXPECT_EQ(text_in("r.txt"), "new");
  for (const char* const name : {"r.txt.part", "r.txt.1.part", "r.txt.2.part"})
    EXPECT_EQ(text_in(name), "mine") << name;
  EXPECT_EQ(n_files(), 4U);
}

TEST_F(WriteFile, InputWhatIsNoFileIsNotReplaced) {
  EXPECT_FALSE(file_behind(folder_));
  EXPECT_FALSE(file_behind("/dev/null"));
  EXPECT_EQ(file_behind(folder_ / "none"), std::filesystem::canonical(folder_) / "none");
  std::filesystem::create_symlink("turn", folder_ / "turn");
  EXPECT_FALSE(file_behind(folder_ / "turn"));
  EXPECT_THROW(WaitingFile(folder_, "new"), Error);
  EXPECT_THROW(append_to("/dev/full", "new"), Error);
  EXPECT_THROW(append_to(folder_ / "turn", "new"), Error);
}

/// While this object exists, files cannot grow beyond this size.
class FileLimit {
 public:
  explicit FileLimit(rlim_t size) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{.rlim_cur = size, .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  FileLimit(FileLimit&&) = delete;
  FileLimit& operator=(FileLimit&&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST_F(WriteFile, InputAWriteThatIsCutShortSaysWhy) {
  put("journal", "");
  const std::string text(1000, 'x');
  const auto reason = [&](const auto& work) -> std::string {
    const FileLimit limit(600);
    errno = 0;
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no fault";
  };
  const std::string appended = reason([&] { append_to(folder_ / "journal", text); });
  EXPECT_NE(appended.find("cannot be written: File too large"), std::string::npos) << appended;
  const std::string written = reason([&] { write("r.txt", text); });
  EXPECT_NE(written.find("cannot be written: File too large"), std::string::npos) << written;
  EXPECT_EQ(n_files(), 1U);
  append_to(folder_ / "journal", "end");
  EXPECT_EQ(text_in("journal"), text.substr(0, 600) + "end");
}

}  // namespace
}  // namespace strainwave

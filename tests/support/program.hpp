// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace strainwave::test {

/// What a program printed and how it ended.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// Runs programs from outside, in a folder of its own for each test with a blank in its name.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("strainwave test " + std::to_string(::getpid()) + " " +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path in_folder(const std::string& name) const {
    return folder_ / name;
  }

  /// A command of the shell.
  [[nodiscard]] Outcome execute(const std::string& command) const {
    const std::filesystem::path out = folder_ / "stdout.txt";
    const std::filesystem::path err = folder_ / "stderr.txt";
    const int status =
        std::system((command + " >" + quoted(out.string()) + " 2>" + quoted(err.string())).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
  }

  /// Writes a file of the folder; its name as a word of the command line.
  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return quoted(file.string());
  }

  /// An example with one text replaced by another, as the file changed.toml.
  [[nodiscard]] std::string changed(const std::string& example, const std::string& from,
                                    const std::string& to) const {
    std::string text = contents(std::filesystem::path(STRAINWAVE_EXAMPLES) / example);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return write("changed.toml", text.replace(at, from.size(), to));
  }

  std::filesystem::path folder_;
};

}  // namespace strainwave::test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace strainwave::test {

/// Output and exit code of a program.
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

/// Runs programs as processes.  Each test has its own folder with a blank in its name.
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

  /// Runs a command of the shell.
  [[nodiscard]] Outcome execute(const std::string& command) const {
    return outcome(std::system((command + into()).c_str()));
  }

  /// Runs a program and sends SIGINT as soon as the program handles this signal and has written a
  /// text to standard error.
  [[nodiscard]] Outcome interrupted(const std::filesystem::path& program,
                                    const std::string& arguments,
                                    const std::string& said = {}) const {
    const std::string command = "exec " + quoted(program.string()) + " " + arguments + into();
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGINT, SIG_DFL);
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    const std::filesystem::path process = "/proc/" + std::to_string(child);
    const auto handles = [&] {
      std::error_code none;
      if (!std::filesystem::equivalent(process / "exe", program, none)) return false;
      const std::string status = contents(process / "status");
      const std::size_t caught = status.find("SigCgt:");
      constexpr unsigned long long kMask = 1ULL << (SIGINT - 1);
      return caught != std::string::npos &&
             (std::stoull(status.substr(caught + 7), nullptr, 16) & kMask) != 0;
    };
    int status = 0;
    while (!handles() || contents(err()).find(said) == std::string::npos) {
      if (::waitpid(child, &status, WNOHANG) == child) return outcome(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ::kill(child, SIGINT);
    ::waitpid(child, &status, 0);
    return outcome(status);
  }

  /// Writes a file into the folder; returns its name as a word of the command line.
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

 private:
  [[nodiscard]] std::filesystem::path out() const { return folder_ / "stdout.txt"; }
  [[nodiscard]] std::filesystem::path err() const { return folder_ / "stderr.txt"; }
  [[nodiscard]] std::string into() const {
    return " >" + quoted(out().string()) + " 2>" + quoted(err().string());
  }
  [[nodiscard]] Outcome outcome(int status) const {
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out()), contents(err())};
  }
};

}  // namespace strainwave::test

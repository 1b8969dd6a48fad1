// SPDX-License-Identifier: Apache-2.0
#include "converter.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "exit_code.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {
namespace {

namespace fs = std::filesystem;

/// One line per way from a document to a file.
struct Way {
  Format from;
  std::string_view to;                       ///< ending of the file name
  std::array<std::string_view, 3> programs;  ///< programs that can make such a file, the best first
  std::string_view package;                  ///< of Debian
  std::string_view input;
  std::vector<std::string> arguments;
};

const std::vector<Way>& ways() {
  static const auto svg = [](std::string_view to) {
    return Way{.from = Format::svg,
               .to = to,
               .programs = {"rsvg-convert"},
               .package = "librsvg2-bin",
               .input = "plot.svg",
               .arguments = {"--format", std::string(to.substr(1)), "--output", "OUT", "IN"}};
  };
  static const std::vector<Way> all = {
      svg(".png"),
      svg(".pdf"),
      {.from = Format::html,
       .to = ".pdf",
       .programs = {"chromium", "chromium-browser", "google-chrome"},
       .package = "chromium",
       .input = "report.html",
       .arguments = {"--headless", "--disable-gpu", "--no-pdf-header-footer",
                     "--user-data-dir=HOME", "--print-to-pdf=OUT", "IN"}}};
  return all;
}

/// Formats that need a conversion, because no document of ours has them.
constexpr std::array<std::string_view, 12> kPictures = {".png",  ".pdf", ".jpg", ".jpeg",
                                                        ".gif",  ".bmp", ".tif", ".tiff",
                                                        ".webp", ".eps", ".ps",  ".xlsx"};

std::string installed(std::string_view program) {
  const char* const path = std::getenv("PATH");
  for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path file = fs::path(rest.substr(0, end)) / program;
    rest.remove_prefix(std::min(end + 1, rest.size()));
    std::error_code unseen;
    if (file.is_absolute() && fs::is_regular_file(file, unseen) &&
        ::access(file.c_str(), X_OK) == 0)
      return file.string();
  }
  return {};
}

/// A temporary folder that is removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code fault;
    std::string name = (fs::temp_directory_path(fault) / "strainwave-XXXXXX").string();
    if (fault || ::mkdtemp(name.data()) == nullptr)
      throw UnwritableError(
          "no temporary folder can be created; set TMPDIR to a folder that can be written");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code unseen;
    fs::remove_all(path_, unseen);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  [[nodiscard]] fs::path operator/(std::string_view name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a program without a shell and without input; its output goes to a file.
/// @return  its exit code; 127 if the program cannot be run
int run_to_end(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT, 0600);
  ::posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int fault = ::posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  if (fault != 0) return 127;
  int status = 0;
  bool stop = false;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    stop = true;
    ::kill(child, SIGKILL);
  }
  if (stop) throw Stopped();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::optional<Converter> converter_for(Format format, std::string_view path) {
  std::string ending = fs::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (std::ranges::find(kPictures, ending) == kPictures.end()) return std::nullopt;
  std::vector<std::string_view> possible;
  for (const Way& way : ways()) {
    if (way.from != format) continue;
    possible.push_back(way.to);
    if (way.to != ending) continue;
    for (const std::string_view name : way.programs) {
      std::string program = name.empty() ? "" : installed(name);
      if (program.empty()) continue;
      Converter converter{std::move(program), way.arguments, way.input};
      // Chromium does not run in its sandbox as root.
      if (format == Format::html && ::geteuid() == 0)
        converter.arguments.insert(converter.arguments.begin(), "--no-sandbox");
      return converter;
    }
    throw UnwritableError(fmt::format(
        "{}: needs {}, which is not installed: install the Debian package {}, or name a .{} file",
        path, way.programs.front(), way.package, enum_name(format)));
  }
  throw UnwritableError(
      fmt::format("{}: {} cannot be written as {}: name a file that ends in .{}{}", path,
                  enum_name(format), ending, enum_name(format),
                  possible.empty() ? "" : fmt::format(" or {}", fmt::join(possible, " or "))));
}

std::string converted(const Converter& converter, const std::string& document) {
  const ScratchFolder scratch;
  const fs::path in = scratch / converter.input;
  const fs::path out = scratch / "out";
  const fs::path log = scratch / "log";
  try {
    WaitingFile(in, document).replace();
  } catch (const Error& error) {
    throw UnwritableError(error.what());
  }
  std::vector<std::string> words = {converter.program};
  for (std::string word : converter.arguments) {
    for (const auto& [name, path] : {std::pair<std::string_view, fs::path>{"IN", in},
                                     {"OUT", out},
                                     {"HOME", scratch / "home"}})
      if (word.ends_with(name)) word.replace(word.size() - name.size(), name.size(), path.string());
    words.push_back(std::move(word));
  }
  const int code = run_to_end(words, log);
  std::string bytes = bytes_of(out);
  if (code == 0 && !bytes.empty()) return bytes;
  const std::string said = bytes_of(log);
  throw UnwritableError(fmt::format("{} failed with exit code {}: {}", converter.program, code,
                                    shown(said.empty() ? "it says nothing" : said)));
}

}  // namespace strainwave::cli

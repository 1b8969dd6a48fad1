// SPDX-License-Identifier: Apache-2.0
// The program and its files: faults of files and devices, names of any kind, and what an output may
// replace.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "support/program.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Outcome;
using test::quoted;

const std::string kDrive = STRAINWAVE_EXAMPLES "/article.toml";
const std::string kTables = STRAINWAVE_EXAMPLES;

/// A word quoted so that the shell does not interpret its characters.
std::string word(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// A quick command with a plot.
const std::string kPlotted = "sweep " + word(kDrive) + " --vary 'load.axial_force=0 N..9 N:2'";

class Files : public test::ProgramTest {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return execute(before + word(STRAINWAVE_CLI) + " " + arguments);
  }

  /// A name in the folder, as a word of the command line.
  [[nodiscard]] std::string at(const std::string& name) const {
    return word(in_folder(name).string());
  }

  /// The files in the folder except those that the test itself writes.
  [[nodiscard]] std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (const std::string name = entry.path().filename().string();
          name != "stdout.txt" && name != "stderr.txt")
        names.push_back(name);
    return names;
  }

  /// Expects this exit code and one sentence that contains these words.
  void expect_refused(const std::string& arguments, int code, const std::string& words,
                      const std::string& before = {}) const {
    const Outcome outcome = run(arguments, before);
    EXPECT_EQ(outcome.exit_code, code) << arguments << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << arguments << '\n' << outcome.err;
    EXPECT_EQ(outcome.err.find('\n') + 1, outcome.err.size()) << arguments << '\n' << outcome.err;
  }
};

// --- Inputs

TEST_F(Files, InputFaultsOfTheInputEndWithThree) {
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  fs::create_symlink("nowhere", in_folder("dangling"));
  fs::create_symlink("loop", in_folder("loop"));
  write("large.toml", std::string((std::size_t{1} << 20) + 1, '#'));
  write("zero.toml", std::string("name = \"\0\"", 10));
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::string>>{
           {at("absent.toml"), "cannot be opened for reading"},
           {at("dangling"), "cannot be opened for reading"},
           {at("loop"), "cannot be opened for reading"},
           {word(folder_.string()), "is a directory"},
           {at("pipe"), "is a device, a socket or a named pipe"},
           {"/dev/zero", "is a device, a socket or a named pipe"},
           {"/dev/full", "is a device, a socket or a named pipe"},
           {"/dev/null", "is a device, a socket or a named pipe"},
           {at("large.toml"), "is larger than 1 MiB"},
           {at("zero.toml"), "zero.toml:1"},
           {"- <&-", "standard input is closed"},
           {"- </dev/zero", "is larger than 1 MiB"}})
    expect_refused("stiffness " + file, 3, words);
  for (const char* const arguments :
       {"stiffness ''", "calibrate x.toml --measured ''", "diff '' x.toml", "torsion ''"})
    expect_refused(arguments, 2, "must name a file; give its name, or - for standard input");
  for (const std::string& file : {at("pipe"), std::string("/dev/zero")})
    expect_refused("calibrate " + word(kTables + "/catalogue_size25.toml") + " --measured " + file,
                   3, "is a device, a socket or a named pipe");
  expect_refused("stiffness -", 3, "is larger than 1 MiB", "yes | ");
}

TEST_F(Files, BehaviourInputsThatTheCallerHasOpened) {
  const std::string answer = run("stiffness " + word(kDrive) + " --format csv").out;
  ASSERT_FALSE(answer.empty());
  for (const char* const input : {"- <", "/dev/stdin <", "/dev/fd/3 3<"})
    EXPECT_EQ(run("stiffness --format csv " + std::string(input) + word(kDrive)).out, answer)
        << input;
  EXPECT_EQ(run("stiffness --format csv /dev/stdin", "cat " + word(kDrive) + " | ").out, answer);
}

TEST_F(Files, BehaviourHistoriesOfAnyLength) {
  // A history comes through a file or a pipe and may be longer than other tables, whose limit is
  // 64 MiB.
  const std::string history = word(kTables + "/joint_history.csv");
  const std::string count = " --column torque --format csv";
  const std::string answer = run("duty --rainflow " + history + count).out;
  EXPECT_EQ(answer.find("range [N*m],mean [N*m],count [1]\n"), 0U) << answer;
  EXPECT_EQ(run("duty --rainflow -" + count, "cat " + history + " | ").out, answer);
  EXPECT_EQ(run("duty --rainflow /dev/stdin" + count, "cat " + history + " | ").out, answer);
  const Outcome rows = run("duty --rainflow - --format csv --classes 8 | head -n 2",
                           "seq -f '%040.0f' 1 2000000 | awk 'BEGIN{print \"x\"}{print}' | ");
  EXPECT_EQ(rows.exit_code, 0);
  EXPECT_EQ(rows.out, "range [1],mean [1],count [1]\n1966080,917504,0.5\n");
  expect_refused("duty --rainflow " + word(kTables), 2, "is a directory");
  expect_refused("duty --rainflow /dev/zero", 2, "may never end");
  expect_refused("duty --rainflow - <&-", 2, "standard input is closed");
  expect_refused("duty --rainflow ''", 2, "must name a file");
}

TEST_F(Files, BehaviourNamesOfAnyKind) {
  for (const std::string name :
       {"a b.toml", "a'b.toml", "a\"b.toml", "a\nb.toml", "\u00e4\u2014\u6c34.toml", "$(x).toml",
        "-x.toml", "a=b;c&d.toml", "%s.toml"}) {
    fs::copy_file(kDrive, in_folder(name));
    const std::string out = in_folder(name).replace_extension("txt").string();
    const Outcome outcome = run("stiffness " + at(name) + " -o " + word(out));
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_NE(contents(out).find("Torsional stiffness"), std::string::npos) << name;
    // The message shows the name of a missing file on one line.
    fs::remove(in_folder(name));
    expect_refused("stiffness " + at(name), 3, "cannot be opened for reading");
  }
}

// A text that is not a drive is refused at the first byte that shows this.
TEST_F(Files, InputTextsThatAreNoDrive) {
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {"", ":1:1: format: must be given"},
           {"\n\n", ":1:1: format: must be given"},
           {"<!DOCTYPE html>\n<html></html>\n",
            ": is HTML or XML, not a drive in TOML; strainwave new writes a drive"},
           {"\n{\"format\": \"strainwave-result/1\"}\n", ": is JSON, not a drive in TOML"},
           {"\x89PNG\r\n\x1A\n", ":1:1: "},
           {"\xFF\xFE"
            "f\0o\0",
            ":1:1: "},
           {"torque [N*m],twist [arcmin]\n14,1.5\n", ":1:8: "},
           {"name = \"\xC3\x28\"\n", ":1:"}})
    expect_refused("stiffness " + write("no_drive.toml", text), 3, "no_drive.toml" + words);
  for (const char* const folder : {"/", ".", "/dev", "/proc/self/fd"})
    expect_refused(std::string("stiffness ") + folder, 3, "is a directory");
}

// Kind: identity.  A drive gives the same answer in every form that editors write.
TEST_F(Files, IdentityFormsOfTheSameText) {
  const std::string text = contents(kDrive);
  const std::string answer = run("stiffness --format csv " + word(kDrive)).out;
  ASSERT_FALSE(answer.empty());
  std::string returns;
  for (const char c : text) returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  ASSERT_EQ(text.back(), '\n');
  for (const std::string& same :
       {"\xEF\xBB\xBF" + text, returns, "\xEF\xBB\xBF" + returns, text.substr(0, text.size() - 1),
        text + "\n\n", "\n \t\n# first\n" + text})
    EXPECT_EQ(run("stiffness --format csv " + write("same.toml", same)).out, answer);
}

// Kind: identity.  A locale whose numbers have a decimal comma changes no byte.
TEST_F(Files, IdentityTheLocaleChangesNothing) {
  // If the system cannot make the locale, only its name is set.
  (void)execute("localedef -i de_DE -f UTF-8 " + at("de_DE.UTF-8"));
  // With LOCPATH the C library loses a few bytes when a library of HDF5 asks for the locale "C".
  const std::string comma = "LOCPATH=" + word(folder_.string()) +
                            " LC_ALL=de_DE.UTF-8 ASAN_OPTIONS=\"$ASAN_OPTIONS:detect_leaks=0\" ";
  const std::string size25 = word(kTables + "/catalogue_size25.toml");
  for (const std::string& arguments :
       {"stiffness " + word(kDrive), "stiffness --format json " + word(kDrive),
        "calibrate " + size25 + " --factors coning --measured " +
            word(kTables + "/measured_size25.csv"),
        std::string("stiffness 1,5.toml")}) {
    const Outcome plain = run(arguments, "LC_ALL=C ");
    const Outcome german = run(arguments, comma);
    EXPECT_EQ(german.exit_code, plain.exit_code) << arguments;
    EXPECT_EQ(german.out, plain.out) << arguments;
    EXPECT_EQ(german.err, plain.err) << arguments;
  }
}

// --- Outputs

TEST_F(Files, InputFaultsOfTheOutputEndWithSevenBeforeTheWork) {
  fs::create_directory(in_folder("folder"));
  write("protected.txt", "mine");
  fs::permissions(in_folder("protected.txt"), fs::perms::owner_read);
  fs::create_symlink("protected.txt", in_folder("link.txt"));
  const auto before = left();
  // The work would take minutes.
  const std::string work = "sweep " + word(kDrive) +
                           " --vary 'load.torque=1 N*m..9 N*m:300' --vary "
                           "'load.axial_force=0 N..9 N:300' ";
  const auto begin = std::chrono::steady_clock::now();
  for (const auto& [output, words] : std::vector<std::pair<std::string, std::string>>{
           {"-o " + at("no/such/folder/x.csv"), "No such file or directory; make the folder first"},
           {"-o " + at("folder"), "it is a directory"},
           {"-o " + at("protected.txt"), "it is write-protected"},
           {"-o " + at("link.txt"), "it is write-protected"},
           {"-o " + at("protected.txt/x.csv"), "Not a directory"},
           {"--plot " + at("no/x.svg"), "No such file or directory"},
           {"--plot " + at("x.jpg"),
            "x.jpg: svg cannot be written as .jpg: name a file that ends in "
            ".svg or .png or .pdf"},
           {"-o " + at("x.pdf"),
            "x.pdf: csv cannot be written as .pdf: name a file that ends in .csv"}})
    expect_refused(work + output, 7, words);
  const Outcome closed = execute("(" + word(STRAINWAVE_CLI) + " " + work + " >&-)");
  EXPECT_EQ(closed.exit_code, 7) << closed.err;
  EXPECT_NE(closed.err.find("standard output is closed"), std::string::npos) << closed.err;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(left(), before);
  EXPECT_EQ(contents(in_folder("protected.txt")), "mine");
}

TEST_F(Files, InputADiskThatFillsEndsWithSevenAndLeavesNothing) {
  write("old.json", "old");
  // The shell limits files to one block of 512 or 1024 bytes, including its own error output.
  for (const char* const name : {"new.json", "old.json"})
    expect_refused("stiffness " + word(kDrive) + " --format json -o " + at(name), 7,
                   "File too large", "ulimit -f 1; ");
  EXPECT_EQ(left(), std::vector<std::string>{"old.json"});
  EXPECT_EQ(contents(in_folder("old.json")), "old");
  expect_refused("stiffness " + word(kDrive) + " -o /dev/full", 7, "No space left on device");
  EXPECT_EQ(execute(word(STRAINWAVE_CLI) + " stiffness --help >/dev/full; echo $?").out, "7\n");
}

TEST_F(Files, BehaviourDevicesAndPipesAreOutputs) {
  const std::string command = "stiffness " + word(kDrive) + " --format csv";
  const std::string answer = run(command).out;
  for (const char* const output : {"-", "/dev/stdout", "/dev/fd/1"})
    EXPECT_EQ(run(command + " -o " + output).out, answer) << output;
  EXPECT_EQ(run(command + " -o /dev/null").out, "");
  EXPECT_EQ(run(command + " -o /dev/stdout | cat").out, answer);
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  EXPECT_EQ(execute("(cat " + at("pipe") + " & " + word(STRAINWAVE_CLI) + " " + command + " -o " +
                    at("pipe") + "; wait)")
                .out,
            answer);
  // If the reader goes away, the program prints no message.
  EXPECT_EQ(run(command + " | head -n 1").err, "");
}

TEST_F(Files, InputAnOutputThatIsRead) {
  fs::copy(kTables + "/tabulated_crack.toml", in_folder("drive.toml"));
  fs::copy(kTables + "/tables", in_folder("tables"));
  fs::copy(kTables + "/turn_table.toml", in_folder("turn.toml"));
  const fs::path table = fs::path(in_folder("tables")) / "through_45.csv";
  const fs::path turn = fs::path(in_folder("tables")) / "turn_through.csv";
  fs::create_symlink("drive.toml", in_folder("soft.toml"));
  fs::create_hard_link(in_folder("drive.toml"), in_folder("hard.toml"));
  fs::create_symlink(table, in_folder("table link"));
  const auto before = left();
  const std::string drive = contents(in_folder("drive.toml"));
  const std::string points = contents(table);
  for (const std::string& output : {at("drive.toml"), at("./soft.toml"), at("hard.toml"),
                                    word(table.string()), at("table link")})
    for (const char* const option : {"-o ", "--plot "})
      for (const std::string& input : {at("drive.toml"), at("hard.toml"), at("soft.toml")})
        expect_refused("stiffness " + input + " " + option + output, 2, "name the same file, ");
  expect_refused("grow " + at("turn.toml") + " -o " + word(turn.string()), 2,
                 "turn_table and --output name the same file");
  expect_refused("stiffness - -o " + at("soft.toml") + " <" + at("drive.toml"), 2,
                 "FILE and --output name the same file");
  expect_refused("calibrate " + word(kTables + "/catalogue_size25.toml") + " --measured " +
                     word(table.string()) + " -o " + word(table.string()) + " --force",
                 2, "--measured and --output name the same file");
  EXPECT_EQ(contents(in_folder("drive.toml")), drive);
  EXPECT_EQ(contents(table), points);
  EXPECT_EQ(left(), before);
}

TEST_F(Files, InputOutputsThatAreOne) {
  const std::string command = kPlotted;
  write("a.txt", "old");
  fs::create_symlink("new.txt", in_folder("to new.txt"));
  fs::create_hard_link(in_folder("a.txt"), in_folder("b.txt"));
  for (const auto& [one, other] : {std::pair{at("x.svg"), at("./x.svg")},
                                   {at("new.txt"), at("to new.txt")},
                                   {at("a.txt"), at("b.txt")}})
    expect_refused(command + " -o " + one + " --plot " + other, 2,
                   "--output and --plot name the same file");
  expect_refused(command + " --plot -", 2, "both go to standard output");
  expect_refused(command + " -o '' ", 2, "--output must name a file");
  expect_refused(command + " --plot ''", 2, "--plot must name a file");
  EXPECT_EQ(run(command + " -o /dev/null --plot /dev/null").exit_code, 0);
}

TEST_F(Files, BehaviourDrivesAreReplacedOnlyByForce) {
  const std::string mine = "# many hours of work\n";
  write("drive.toml", mine);
  fs::permissions(in_folder("drive.toml"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("drive.toml", in_folder("link.toml"));
  const std::string calibrate =
      "calibrate " + word(kTables + "/catalogue_size25.toml") + " --catalogue --factors coning";
  for (const std::string& command :
       {std::string("new"), std::string("new --size 25 --ratio 100"), calibrate})
    for (const char* const name : {"drive.toml", "link.toml"}) {
      expect_refused(command + " -o " + at(name), 2, "exists already: give --force to replace it");
      EXPECT_EQ(contents(in_folder("drive.toml")), mine);
      EXPECT_EQ(run(command + " --force -o " + at(name)).exit_code, 0) << command;
      EXPECT_NE(contents(in_folder("drive.toml")), mine);
      EXPECT_TRUE(fs::is_symlink(in_folder("link.toml")));
      EXPECT_EQ(fs::status(in_folder("drive.toml")).permissions(),
                fs::perms::owner_read | fs::perms::owner_write);
      write("drive.toml", mine);
    }
  EXPECT_EQ(run("new -o " + at("fresh.toml")).exit_code, 0);
  EXPECT_EQ(run("new -o /dev/null").exit_code, 0);
  EXPECT_EQ(run("new --format json -o " + at("fresh.toml")).exit_code, 0);  // no drive
}

// --- Pictures

TEST_F(Files, InputAPictureNeedsItsConverter) {
  const std::string command = kPlotted + " -o /dev/null --plot ";
  for (const char* const name : {"x.png", "X.PDF"})
    expect_refused(command + at(name), 7,
                   "needs rsvg-convert, which is not installed: install the Debian package "
                   "librsvg2-bin, or name a .svg file",
                   "PATH=/nowhere ");
  expect_refused("report " + word(kDrive) + " -o " + at("x.pdf"), 7,
                 "needs chromium, which is not installed: install the Debian package chromium, or "
                 "name a .html file",
                 "PATH=/nowhere ");
  EXPECT_TRUE(left().empty());
}

TEST_F(Files, BehaviourAConverterIsCalledWithoutAShell) {
  // Replaces the real converter: records its arguments and copies the file.
  fs::create_directory(in_folder("bin"));
  write("bin/rsvg-convert",
        "#!/bin/sh\nprintf '%s\\n' \"$#\" \"$1\" \"$2\" \"$3\" >>\"$TOLD\"\ncp \"$5\" \"$4\"\n");
  write(
      "bin/chromium",
      "#!/bin/sh\nfor last; do :; done\nfor word; do case $word in --print-to-pdf=*) cp \"$last\" "
      "\"${word#*=}\";; esac; done\n");
  for (const char* const name : {"bin/rsvg-convert", "bin/chromium"})
    fs::permissions(in_folder(name), fs::perms::owner_all);
  const std::string before =
      "TOLD=" + at("told") + " PATH=" + word(in_folder("bin").string() + ":/usr/bin:/bin") + " ";
  const std::string svg = run(kPlotted + " -o /dev/null --plot -").out;
  ASSERT_NE(svg.find("<svg"), std::string::npos);
  for (const std::string name : {"a b.png", "$(touch x).png", "a'\n.png", "-.pdf"}) {
    const Outcome outcome = run(kPlotted + " -o /dev/null --plot " + at(name), before);
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_EQ(contents(in_folder(name)), svg) << name;
  }
  EXPECT_NE(contents(in_folder("told")).find("5\n--format\npng\n--output\n"), std::string::npos);
  const Outcome page = run("report " + word(kDrive) + " -o " + at("page.pdf"), before);
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_NE(contents(in_folder("page.pdf")).find("<html"), std::string::npos);
  // A converter that fails leaves no file, and the message quotes its error.
  write("bin/rsvg-convert", "#!/bin/sh\necho 'no such font'\nexit 3\n");
  expect_refused(kPlotted + " -o " + at("y.txt") + " --plot " + at("y.png"), 7,
                 "failed with exit code 3: no such font", before);
  EXPECT_FALSE(fs::exists(in_folder("y.png")));
  EXPECT_FALSE(fs::exists(in_folder("y.txt")));
}

// --- Interrupts

/// Commands that run long enough to receive the signal during their work.
const std::array kLong = {
    "sweep " + word(kDrive) +
        " --vary 'load.torque=1 N*m..9 N*m:300' --vary 'load.axial_force=0 N..9 N:300'",
    "sensitivity " + word(kTables + "/article_scatter.toml") + " --scatter --samples 10000000",
    "reliability " + word(kTables + "/article_scatter.toml") +
        " --require 'intact.stiffness > 1 N*m/rad' --draws 10000000",
    "torsion " + word(kTables + "/cracked_size25.toml") + " --compare",
    std::string("validate --mode leave-one-size-out --all-sets"),
    "calibrate " + word(kTables + "/catalogue_size25.toml") + " --catalogue",
    "report " + word(kTables + "/cracked_size25.toml")};

TEST_F(Files, BehaviourAnInterruptEndsAllLongWorkAndLeavesNothing) {
  for (const std::string& command : kLong) {
    const Outcome outcome = interrupted(STRAINWAVE_CLI, command + " -o " + at("x.out"));
    EXPECT_EQ(outcome.exit_code, 130) << command << '\n' << outcome.err;
    EXPECT_EQ(outcome.err, "strainwave: interrupted: nothing was written\n") << command;
    EXPECT_TRUE(left().empty()) << command;
  }
}

TEST_F(Files, BehaviourAnInterruptEndsTheWaitForAReader) {
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  const std::string command = kPlotted + " --plot " + at("x.svg") + " -o ";
  const auto begin = std::chrono::steady_clock::now();
  // In the foreground the program gets one interrupt; else a second one, which ends it at once.
  const Outcome outcome = execute("timeout --foreground --signal=INT 8 " + word(STRAINWAVE_CLI) +
                                  " " + command + at("pipe"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  EXPECT_EQ(outcome.err, "strainwave: interrupted: nothing was written\n");
  EXPECT_EQ(left(), std::vector<std::string>{"pipe"});
}

// --- Progress

TEST_F(Files, BehaviourProgressIsSaidWhereItIsWanted) {
  const std::string command = kLong[1] + " --format csv";
  const auto interrupted_with = [&](const std::string& option, const std::string& said) {
    return interrupted(STRAINWAVE_CLI, command + option, said).err;
  };
  const std::string interruption = "strainwave: interrupted: nothing was written\n";
  EXPECT_EQ(interrupted_with("", ""), interruption);  // standard error is a file
  EXPECT_EQ(interrupted_with(" --quiet", ""), interruption);
  const std::string lines = interrupted_with(" --progress", " left\n");
  EXPECT_NE(lines.find(" %, "), std::string::npos) << lines;
  EXPECT_NE(lines.find(" %/s, "), std::string::npos) << lines;
  EXPECT_NE(lines.find(" left\n"), std::string::npos) << lines;
  expect_refused(command + " --progress --quiet", 2, "contradict each other");
}

}  // namespace
}  // namespace strainwave

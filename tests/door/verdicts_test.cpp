// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "door/answers.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

Judgement judged(std::string_view command, std::shared_ptr<const Drive> drive,
                 std::string_view options = "{}") {
  const Verdict verdict = test::run_command(command, std::move(drive), options).evidence().verdict;
  EXPECT_FALSE(verdict.reason.empty());
  if (verdict.judgement == Judgement::critical || verdict.judgement == Judgement::cannot_be_told) {
    EXPECT_FALSE(verdict.next_step.empty()) << verdict.reason;
  }
  return verdict.judgement;
}

/// The solid shaft of the examples without its crack.
std::shared_ptr<const Drive> sound_shaft() {
  const Drive& shaft = *test::example_drives().at("solid_shaft");
  const std::string text = shaft.text.substr(0, shaft.text.find("[[output_shaft.crack]]"));
  return read_drive(text, "sound.toml");
}

/// The complete drive of the examples with the fields that its hysteresis loop needs.
std::shared_ptr<const Drive> sound_drive() {
  std::string text = test::example_drives().at("catalogue_size25")->text;
  const std::string rating = "[rating]\n";
  text.insert(text.find(rating) + rating.size(), "friction_torque = \"0.5 N*m\"\n");
  return read_drive(text, "sound_drive.toml");
}

TEST(Verdicts, ReferenceEachOfTheFourIsReached) {
  const auto example = [](const char* name) { return test::example_drives().at(name); };
  EXPECT_EQ(judged("stiffness", sound_shaft()), Judgement::good);
  EXPECT_EQ(judged("sensitivity", sound_shaft()), Judgement::good);
  // If the coupled drive is solved, the effects that the sum leaves out raise no doubt.
  EXPECT_EQ(judged("stiffness", example("catalogue_size25")), Judgement::good);
  EXPECT_EQ(judged("stiffness", example("cracked_size25")), Judgement::cannot_be_told);
  EXPECT_EQ(judged("stiffness", example("solid_shaft")), Judgement::with_care);
  EXPECT_EQ(judged("stiffness", example("critical_crack")), Judgement::critical);
  EXPECT_EQ(judged("stiffness", example("article")), Judgement::cannot_be_told);
}

TEST(Verdicts, ReferenceTheReportSaysTheVerdictInWords) {
  const auto words = [](std::shared_ptr<const Drive> drive) {
    const std::string html = test::run_command("report", std::move(drive)).document("html");
    const std::size_t at = html.find("<p class=\"word\">") + 16;
    return html.substr(at, html.find('<', at) - at);
  };
  EXPECT_EQ(words(sound_shaft()), "Usable");
  EXPECT_EQ(words(sound_drive()), "Usable");
  EXPECT_EQ(words(test::example_drives().at("solid_shaft")), "Usable with care");
  EXPECT_EQ(words(test::example_drives().at("critical_crack")), "Critical");
  EXPECT_EQ(words(test::example_drives().at("article")), "Cannot be told");
}

/// A row of the listing of note codes: "code | severities | input that causes it".
struct ListedCode {
  std::string severities;
  std::string reached;
};

std::map<std::string, ListedCode> listed_codes() {
  std::ifstream file(STRAINWAVE_TEST_DATA "/note_codes.txt");
  std::map<std::string, ListedCode> listed;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t first = line.find(" | ");
    const std::size_t last = line.rfind(" | ");
    listed[line.substr(0, first)] = {line.substr(first + 3, last - first - 3),
                                     line.substr(last + 3)};
  }
  return listed;
}

TEST(NoteCodes, IdentityNotesOfTheExamplesHaveTheListedSeverity) {
  const auto listed = listed_codes();
  std::map<std::string, int> seen;
  // Under the sanitizers each command sees every sixth example; the release build sees whether each
  // code is reached.
  constexpr std::size_t kEvery = test::kSanitized ? 6 : 1;
  std::size_t n = 0;
  for (const auto& [command, options] : test::trial_options()) {
    // These commands repeat the notes of stiffness, sensitivity and torsion.
    if (command_named(commands(), command).takes == Takes::nothing || command == "solve" ||
        command == "sweep" || command == "require" || command == "report" ||
        command == "transmission")
      continue;
    for (const auto& [name, drive] : test::example_drives()) {
      if (n++ % kEvery != 0) continue;
      try {
        const Answer answer = test::run_command(command, drive, options);
        for (const Note& note : answer.evidence().notes) {
          ++seen[note.code];
          ASSERT_TRUE(listed.contains(note.code)) << note.code;
          EXPECT_NE(listed.at(note.code).severities.find(enum_name(note.severity)),
                    std::string::npos)
              << note.code;
        }
      } catch (const Error&) {  // the drive holds what the command cannot treat
      }
    }
  }
  for (const auto& [code, row] : listed)
    EXPECT_TRUE(kEvery > 1 || row.reached != "example" || seen.contains(code)) << code;
}

/// How many notes of an answer carry a code.
long notes_with(const Answer& answer, std::string_view code) {
  return test::count_notes(answer.evidence().notes, code);
}

TEST(NoteCodes, ReferenceNotesThatCommandsAdd) {
  const auto sif = [](std::string_view options) {
    return test::run_command("sif eval", nullptr, options);
  };
  EXPECT_EQ(notes_with(sif(R"({"name": "plate-surface", "set": ["tension=200 MPa"]})"),
                       "sif.extrapolated"),
            0);
  EXPECT_GE(notes_with(sif(R"({"name": "plate-surface", "set": ["depth=9.9 mm",
                              "thickness=10 mm", "half_length=10 mm"]})"),
                       "sif.extrapolated"),
            1);
  const Answer broken = sif(R"({"name": "plate-surface", "material": "4340 tempered 425 C",
                                "set": ["tension=20 GPa"]})");
  EXPECT_EQ(notes_with(broken, "sif.fractures"), 1);
  EXPECT_EQ(broken.evidence().verdict.judgement, Judgement::critical);

  // The last point is deeper than the wall and refused.
  const Answer sweep = test::run_on_example(
      "sweep", "solid_shaft", R"({"vary": ["output_shaft.crack[0].depth=5 mm..31 mm:3"]})");
  EXPECT_EQ(notes_with(sweep, "sweep.unusable_points"), 1);
}

TEST(NoteCodes, ReferenceADriveWithoutACurveSaysWhy) {
  std::string text = test::example_drives().at("catalogue_size25")->text;
  // Under a hundred times the maker's torque the flanks slip past each other.
  const std::size_t torque = text.find("T2 = \"48 N*m\"");
  ASSERT_NE(torque, std::string::npos);
  text.replace(torque, 13, "T2 = \"4800 N*m\"");
  const Answer answer = test::run_command("stiffness", read_drive(text, "x.toml"));
  EXPECT_EQ(notes_with(answer, "curve.none"), 1);
}

}  // namespace
}  // namespace strainwave

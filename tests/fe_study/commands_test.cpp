// SPDX-License-Identifier: Apache-2.0 The second table of commands: its names, and whether its
// answers agree with their descriptions.
#include "strainwave/fe_study/commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "command/field_witness.hpp"
#include "command/kept_journal.hpp"
#include "command/surface.hpp"
#include "door/json_schema.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/mpi.hpp"
#include "support/program.hpp"

namespace strainwave {
namespace {

using fe_study::fe_commands;

GearSet example(const std::string& name) {
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/" + name + ".toml");
}

TEST(FeSurface, RegressionCommandsOptionsDocumentsAndResultFields) {
  test::expect_listed(fe_commands(), "public_surface_fe.txt");
}

TEST(FeDescriptions, IdentityEveryPublicNumberHasAUnitAndEveryFieldALine) {
  for (const Command& row : fe_commands())
    for (const auto& walk : {row.walk, row.options.walk}) {
      SCOPED_TRACE(row.name);
      test::FieldWitness witness;
      walk({}, witness);
      EXPECT_GT(witness.n_fields, 0);
    }
}

struct Trial {
  std::string_view command;
  std::string file;
  std::string_view options;
};

class FeAnswers : public testing::TestWithParam<Trial> {};

TEST_P(FeAnswers, IdentityEveryAnswerKeepsItsSchemaAndMakesItsDocuments) {
  const auto& [name, file, options] = GetParam();
  const Command& row = command_named(fe_commands(), name);
  const std::string path = std::string(STRAINWAVE_EXAMPLES "/") + file + ".toml";
  OptionValues values(row.options);
  values.set_from_json(options);
  test::KeptJournal journal;
  const Answer answer =
      run(row, row.takes == Takes::drive ? read_drive(test::contents(path), path) : nullptr, values,
          {}, {}, {.ranks = test::mpi(), .journal = &journal});
  EXPECT_TRUE(answer.usable()) << answer.evidence().unusable_because;
  const test::Json envelope = test::Json::parse(answer.json());
  for (const auto& [schema, value] : {std::pair(result_schema(row), envelope),
                                      {options_schema(row), envelope["provenance"]["options"]}}) {
    const auto faults = test::schema_faults(test::Json::parse(schema), value);
    EXPECT_TRUE(faults.empty()) << faults.size() << " faults, the first: " << faults.front();
  }
  EXPECT_EQ(envelope["provenance"]["program"], "strainwave-fe");
  for (const Document& document : row.documents) {
    if (!document.needs.empty() && !values.given(document.needs)) continue;
    SCOPED_TRACE(document.name);
    if ((document.name == "plot" || document.name == "svg") && values.given("dry_run")) {
      EXPECT_THROW((void)answer.files(document.name), OptionError);
      continue;
    }
    const std::vector<OutputFile> files = answer.files(document.name);
    EXPECT_GE(files.size(), 1U);
    for (const OutputFile& made : files) {
      EXPECT_FALSE(made.text.empty());
      EXPECT_EQ(made.name.empty(), !document.folder);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfEachCommand, FeAnswers,
    testing::Values(Trial{"run", "solid_shaft", R"({"order": 4})"},
                    Trial{"run", "solid_shaft", R"({"order": 4, "fields": true})"},
                    Trial{"run", "cup_sections", R"({"dry_run": true})"},
                    Trial{"run", "cracked_size25", R"({"member": "flexspline", "order": 3,
                                                       "crack": "flexspline.crack[0]"})"},
                    Trial{"run", "part_through_crack", R"({"order": 2})"},
                    Trial{"oval", "breathing_crack", R"({"nonlinear": "off"})"},
                    Trial{"turn", "breathing_crack", R"({"order": 2, "torque": ["48 N*m"],
                                                         "angles": 8})"},
                    Trial{"turn", "breathing_crack", R"({"dry_run": true})"},
                    Trial{"influence", "", R"({"half_length": [0.5], "radius": [30],
                                               "angle": ["90 deg"]})"},
                    Trial{"render", "solid_shaft", R"({"order": 4})"},
                    Trial{"tabulate", "solid_shaft", R"({"order": 4,
                          "over": ["output_shaft.crack[0].depth=6 mm..9 mm:2"]})"},
                    Trial{"tabulate", "solid_shaft", R"({"dry_run": true,
                          "over": ["output_shaft.crack[0].depth=6 mm..9 mm:2"]})"},
                    Trial{"schema", "", R"({"of": "result", "command": "run"})"}));

TEST(FeAnswersRefused, InputFieldsOfADryRunAndATableWithoutJournal) {
  const auto refusal = [](std::string_view name, std::string_view options,
                          std::string_view document = "vtu",
                          const std::string& drive = "solid_shaft") -> std::string {
    const Command& row = command_named(fe_commands(), name);
    OptionValues values(row.options);
    values.set_from_json(options);
    const std::string path = STRAINWAVE_EXAMPLES "/" + drive + ".toml";
    try {
      const Answer answer =
          run(row, read_drive(test::contents(path), path), values, {}, {}, {.ranks = test::mpi()});
      return answer.files(document).empty() ? "no files" : "files";
    } catch (const OptionError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal("run", R"({"dry_run": true, "fields": true})"),
            "dry_run: does not compute fields; leave out --dry-run or --fields");
  EXPECT_EQ(refusal("run", R"({"dry_run": true})"),
            "dry_run: does not compute fields; choose another format");
  EXPECT_EQ(refusal("turn", R"({"dry_run": true, "fields": true})", "vtu", "breathing_crack"),
            "dry_run: does not compute fields; choose another format");
  EXPECT_EQ(refusal("turn", R"({"dry_run": true})", "svg", "breathing_crack"),
            "dry_run: does not compute the turn; choose another format");
  EXPECT_EQ(refusal("turn", R"({"order": 2, "torque": ["0 N*m"], "angles": 8})", "vtu",
                    "breathing_crack"),
            "fields: must be given for this format");
  EXPECT_EQ(refusal("tabulate", R"({"over": ["output_shaft.crack[0].depth=6 mm..9 mm:2"]})"),
            "journal: must be given; tabulate needs a journal");
}

// Each code with a drive that causes it; no two features of the drives cause the same code.
TEST(FeNotes, IdentityEveryCodeIsReachedWithItsSeverity) {
  test::start_mpi();
  std::map<std::string, Severity> seen;
  const auto note = [&](const GearSet& gear, const fe_study::RunOptions& options = {}) {
    for (const Note& made : fe_study::plan(gear, options).notes)
      seen.emplace(made.code, made.severity);
  };
  GearSet through = example("through_crack");
  note(through);
  through.load.axial_force = 1000;
  through.flexspline->stress_nonuniformity = 1.2;
  note(through);
  note(example("part_through_crack"));
  GearSet shaft = example("solid_shaft");
  shaft.output_shaft->crack.push_back(shaft.output_shaft->crack.front());
  shaft.material.begin()->second.shear_modulus = 70e9;
  note(shaft);
  GearSet cup = example("cracked_size25");
  note(cup);
  cup.flexspline->rim->outer_diameter -= 1.5 * cup.flexspline->rim->wall_thickness;
  note(cup, {.crack = "flexspline.crack[0]"});
  const std::map<std::string, Severity> all = {{"fe.axial_force", Severity::care},
                                               {"fe.crack_in_cup", Severity::information},
                                               {"fe.crack_in_tube", Severity::care},
                                               {"fe.crack_left_out", Severity::care},
                                               {"fe.mouth_outside", Severity::care},
                                               {"fe.rim_apart", Severity::care},
                                               {"fe.shaft_cracks_alone", Severity::care},
                                               {"fe.shear_modulus", Severity::care},
                                               {"fe.sound_left_out", Severity::information},
                                               {"fe.sound_without_cracks", Severity::information},
                                               {"fe.stress_nonuniformity", Severity::information}};
  EXPECT_EQ(seen, all);
}

TEST(FeCommands, InputSurfaceCrackOfAShaft) {
  // Beside an annular crack it is left out with a note; asked for, it is refused by name.
  test::start_mpi();
  GearSet gear = example("solid_shaft");
  gear.output_shaft->crack.emplace_back(ShaftSurfaceCrack{.depth = 1e-3, .half_length = 2e-3});
  const auto plan = fe_study::plan(gear, {});
  EXPECT_EQ(std::ranges::count(plan.notes, "fe.crack_left_out", &Note::code), 1);
  const auto refused = [&](const fe_study::RunOptions& options, const std::string& text) {
    try {
      (void)fe_study::plan(gear, options);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  const std::string kind =
      "output_shaft.crack[1]: finite elements do not compute a crack of kind "
      "\"surface\", only annular cracks of a shaft";
  refused({.crack = "output_shaft.crack[1]"}, kind);
  refused({.member = fe_study::Member::output_shaft}, kind + "; remove it");
  gear.output_shaft->crack.erase(gear.output_shaft->crack.begin());
  refused({}, "an output shaft with an annular crack");
}

// The mesh contains one crack, so a row is refused by its count.
TEST(FeCommands, InputRowOfCracks) {
  test::start_mpi();
  for (const char* name : {"through_crack", "part_through_crack"}) {
    GearSet gear = example(name);
    std::visit(
        [](auto& crack) {
          if constexpr (requires { crack.count; }) crack.count = 3;
        },
        gear.flexspline->crack.front());
    try {
      (void)fe_study::plan(gear, {});
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what())
                    .find("flexspline.crack[0].count = 3 violates: 1, because the mesh contains "
                          "one crack"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// The options of `grow`, and its checkpoint.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "answers.hpp"
#include "command/kept_journal.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// The JSON of `grow` on an example, with a checkpoint if one is given.
std::string grown(const std::string& options, Journal* checkpoint = nullptr,
                  const std::string& example = "growing_shaft") {
  const Command& row = command_named(commands(), "grow");
  OptionValues values(row.options);
  values.set_from_json(options);
  return run(row, test::example_drives().at(example), values, {}, {}, {.journal = checkpoint})
      .json();
}

/// The message of the error; empty if there is none.
std::string refusal_of_grow(const std::string& options, Journal* checkpoint = nullptr,
                            const std::string& example = "growing_shaft") {
  try {
    (void)grown(options, checkpoint, example);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Grow, InputEachOptionRuleBrokenOnce) {
  struct Case {
    std::string options;
    std::string message;
  };
  const std::vector<Case> cases = {
      {R"({"until": "20000"})", "--until"},
      {R"({"until": "0 h"})", "> 0"},
      {R"({"until": "-5 cycles"})", "> 0"},
      {R"({"until": "output_shaft.crack[0].depth=0.1 mm"})", "larger than the size in the file"},
      {R"({"until": "output_shaft.crack[1].depth=3 mm"})", "is not the size of a crack"},
      {R"({"until": "output_shaft.length=3 mm"})", "is not the size of a crack"},
      {R"({"law": "cheese"})", "is not in the material library"},
      {R"({"law": "52100 hardened"})", "it has laws for"},
      {R"({"interaction": "wheeler", "wheeler_exponent": 1.5})", "zone_factor"},
      {R"({"interaction": "wheeler", "zone_factor": 2})", "wheeler_exponent"},
      {R"({"interaction": "willenborg", "zone_factor": 2, "wheeler_exponent": 1})",
       "is read with --interaction wheeler only"},
      {R"({"zone_factor": 2})", "is read with --interaction wheeler, willenborg or closure only"},
      {R"({"constraint": 2})", "is read with --interaction closure only"},
      {R"({"stress_level": 0.3})", "is read with --interaction closure only"},
      {R"({"interaction": "closure", "constraint": 2, "stress_level": 0.3})", "zone_factor"},
      {R"({"interaction": "closure", "zone_factor": 2, "constraint": 2})", "stress_level"},
      {R"({"interaction": "closure", "zone_factor": 2, "stress_level": 0.3})", "constraint"},
      {R"({"interaction": "closure", "zone_factor": 2, "constraint": 4, "stress_level": 0.3})",
       "constraint"},
      {R"({"interaction": "closure", "zone_factor": 2})", "give --constraint and --stress-level"},
      {R"({"points": 1})", "points"}};
  for (const Case& one : cases) {
    const std::string message = refusal_of_grow(one.options);
    EXPECT_NE(message.find(one.message), std::string::npos) << one.options << ": " << message;
  }
  for (const char* const accepted :
       {R"({"until": "300 h"})", R"({"until": "1e5 cycles"})", R"({"until": "event"})",
        R"({"until": "output_shaft.crack[0].depth=3 mm"})", R"({"law": "generic steel"})",
        R"({"interaction": "willenborg", "zone_factor": 2})",
        R"({"interaction": "closure", "zone_factor": 2, "constraint": 2, "stress_level": 0.3})"})
    EXPECT_EQ(refusal_of_grow(accepted), "") << accepted;
  EXPECT_NE(refusal_of_grow("{}", nullptr, "article").find("duty"), std::string::npos);
}

TEST(Grow, IdentityOfARunWithACheckpoint) {
  const std::string whole = grown("{}");
  test::KeptJournal checkpoint;
  EXPECT_EQ(grown("{}", &checkpoint), whole);
  const std::string full = *checkpoint.text();
  EXPECT_EQ(grown("{}", &checkpoint), whole);
  EXPECT_EQ(*checkpoint.text(), full);  // nothing is computed twice
  // A run that was killed within a line goes on, and leaves the same file.
  checkpoint.begin(full.substr(0, full.size() / 2));
  EXPECT_EQ(grown("{}", &checkpoint), whole);
  EXPECT_EQ(*checkpoint.text(), full);
}

TEST(Grow, InputCheckpointOfSomethingElse) {
  test::KeptJournal checkpoint;
  (void)grown("{}", &checkpoint);
  const std::string full = *checkpoint.text();
  const auto refused = [&](const std::string& options, const std::string& example) {
    return refusal_of_grow(options, &checkpoint, example)
               .find("of another drive, of other options") != std::string::npos;
  };
  EXPECT_TRUE(refused("{}", "resonant_shaft"));
  EXPECT_TRUE(refused(R"({"until": "300 h"})", "growing_shaft"));
  EXPECT_TRUE(refused(R"({"mixed_mode": "richard"})", "growing_shaft"));
  EXPECT_EQ(*checkpoint.text(), full);  // a refused checkpoint stays as it is
  // Another version, and a file of something else.
  checkpoint.begin("strainwave-growth/2 0.0.1" + full.substr(full.rfind(' ', full.find('\n'))));
  EXPECT_TRUE(refused("{}", "growing_shaft"));
  checkpoint.begin("a shopping list\n");
  EXPECT_NE(refusal_of_grow("{}", &checkpoint).find("is not a checkpoint"), std::string::npos);
  checkpoint.begin(full.substr(0, 30));
  EXPECT_NE(refusal_of_grow("{}", &checkpoint).find("is not a checkpoint"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

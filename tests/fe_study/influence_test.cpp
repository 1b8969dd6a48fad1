// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/influence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "command/kept_journal.hpp"
#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "support/mpi.hpp"
#include "support/program.hpp"

namespace strainwave::fe_study {
namespace {

using std::numbers::pi;

/// The words of the line that begins with `begin`.
std::vector<std::string> line_of(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find('\n' + begin + ' ');
  EXPECT_NE(at, std::string::npos) << begin;
  if (at == std::string::npos) return {};
  std::istringstream line(text.substr(at + 1, text.find('\n', at + 1) - at - 1));
  std::vector<std::string> words;
  for (std::string word; line >> word;) words.push_back(word);
  return words;
}

// (FE-56) Kind: regression of data/through_crack.txt, with which chapter IN is judged.  Tolerance
// 1e-4 of the largest number of a block: another machine rounds otherwise.
TEST(FeInfluence, RegressionOfTheTable) {
  test::start_mpi();
  const std::string kept = test::contents(STRAINWAVE_EXAMPLES "/../data/through_crack.txt");
  test::KeptJournal journal;
  const InfluenceOutcome outcome = run_influence(
      {.half_lengths = {1}, .radii = {60}, .angles = {pi / 8}}, &journal, test::mpi(), {});
  EXPECT_EQ(outcome.found, 0U);
  EXPECT_GT(outcome.unknowns, 10'000U);
  EXPECT_EQ(evidence_of(outcome).unusable_because, "");
  const std::vector<std::string> ours = line_of(*journal.text(), "case 1 60 22.5");
  const std::vector<std::string> theirs = line_of(kept, "case 1 60 22.5");
  ASSERT_EQ(ours.size(), theirs.size());
  ASSERT_GT(ours.size(), 2000U);
  double our_scale = 1;
  double their_scale = 1;
  for (std::size_t i = 4; i < ours.size(); ++i) {
    if (ours[i] == "K" || ours[i] == "gap" || ours[i] == "pressed") {
      ASSERT_EQ(ours[i], theirs[i]);
      ++i;
      our_scale = std::stod(ours[i]);
      their_scale = std::stod(theirs[i]);
      test::expect_relative(our_scale, their_scale, 1e-4);
      continue;
    }
    EXPECT_NEAR(std::stod(ours[i]) * our_scale, std::stod(theirs[i]) * their_scale,
                1e-4 * 1e6 * their_scale);
  }
  // The head differs in the axes alone.
  for (const std::string name :
       {"steps", "poissons_ratio", "stations", "contact_along", "contact_across"})
    EXPECT_EQ(line_of(*journal.text(), name), line_of(kept, name)) << name;
}

// Kind: behaviour.  A killed run continues: a torn last line is computed again, and the text is
// that of one run.  A table of other cracks is refused.
TEST(FeInfluence, BehaviourOfAStoppedRun) {
  test::start_mpi();
  const InfluenceGrid grid{.half_lengths = {0.5}, .radii = {30}, .angles = {0, pi / 2}};
  test::KeptJournal whole;
  (void)run_influence(grid, &whole, test::mpi(), {});
  const std::string text = *whole.text();
  test::KeptJournal torn;
  torn.begin(text.substr(0, text.size() - 100));
  const InfluenceOutcome outcome = run_influence(grid, &torn, test::mpi(), {});
  EXPECT_EQ(outcome.found, 1U);
  EXPECT_EQ(*torn.text(), text);
  const InfluenceOutcome again = run_influence(grid, &torn, test::mpi(), {});
  EXPECT_EQ(again.found, 2U);
  EXPECT_EQ(*torn.text(), text);
  const InfluenceGrid other{.half_lengths = {0.7}, .radii = {30}, .angles = {0}};
  EXPECT_NE(test::broken_rule([&] {
              return run_influence(other, &torn, test::mpi(), {});
            }).find("is a table of other cracks"),
            std::string::npos);
  EXPECT_EQ(*torn.text(), text);
  EXPECT_NE(influence_text(outcome).find("2 cracks, 1 of them there before"), std::string::npos);
  EXPECT_EQ(influence_grid().size(), 90U);
}

}  // namespace
}  // namespace strainwave::fe_study

// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/turn_run.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/io/turn_table_file.hpp"
#include "support/mpi.hpp"

namespace strainwave::fe_study {
namespace {

GearSet breathing() {
  test::start_mpi();
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml");
}

// Kind: identity.  The table is read back by the reader of turn tables (GR-30): same grid, and K to
// the six digits that it prints.
TEST(FeTurn, IdentityOfTheTableThatGrowthReads) {
  const GearSet gear = breathing();
  const TurnRun run = run_turn(
      gear,
      {.request = {.torques = {30, -30}, .half_lengths = {2e-3, 1.5e-3}, .angles = 8}, .order = 2},
      test::mpi());
  ASSERT_EQ(run.sizes.size(), 2U);
  EXPECT_EQ(run.sizes[0].half_length, 1.5e-3);
  EXPECT_EQ(run.torques, (std::vector<double>{-30, 30}));
  std::string text = turn_csv(run, gear);
  ASSERT_FALSE(run.reason().empty());  // order 2 does not suffice, so the table is refused
  {
    HistoryFile refused(pieces_of(text), "turn.csv");
    EXPECT_THROW((void)read_turn_table(refused), InputError);
  }
  const std::size_t mark = text.find("# NOT usable");
  text.erase(mark, text.find('\n', mark) + 1 - mark);
  HistoryFile file(pieces_of(text), "turn.csv");
  const TurnTable table = read_turn_table(file);
  EXPECT_EQ(table.size_name, "half_length");
  ASSERT_EQ(table.sizes.size(), 2U);
  EXPECT_NEAR(table.sizes[1], 2e-3, 1e-15);
  EXPECT_EQ(table.torques, run.torques);
  EXPECT_EQ(table.stations, (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  ASSERT_EQ(table.angles.size(), 9U);
  EXPECT_NEAR(table.angles.back(), std::numbers::pi, 1e-12);
  std::size_t row = 0;
  for (const TurnAtSize& size : run.sizes)
    for (const gear_fem::TorqueTurn& torque : size.turn.torques)
      for (const StationTurn& station : torque.stations) {
        if (station.tip != governing_station(run.turns())->tip) continue;
        for (const TurnFactor& K : station.factors) {
          EXPECT_NEAR(table.K[row][0], K.K_I, 1e-5 * std::abs(K.K_I));
          EXPECT_NEAR(table.K[row][1], K.K_II, 1e-5 * std::abs(K.K_II));
          EXPECT_NEAR(table.K[row][2], K.K_III, 1e-5 * std::abs(K.K_III));
          ++row;
        }
      }
  EXPECT_EQ(row, table.K.size());
  // A longer crack is worse; the text and the plot name each size.
  EXPECT_GT(run.sizes[1].turn.torques[1].stations[0].mode_I.largest,
            run.sizes[0].turn.torques[1].stations[0].mode_I.largest);
  EXPECT_NE(turn_text(run, gear).find("half length 1.5 mm: 16 states"), std::string::npos);
  EXPECT_NE(turn_plot(run, gear).find("half length 1.5 mm"), std::string::npos);

  // A map for each size, and an animation for each size and torque.
  std::vector<std::string> names;
  const auto count = [](const std::string& in, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at + 1))
      ++found;
    return found;
  };
  for (const OutputFile& picture : turn_pictures(run)) {
    names.push_back(picture.name);
    EXPECT_LT(picture.text.size(), 2e6) << picture.name;
    EXPECT_NE(picture.text.find("NOT usable"), std::string::npos) << picture.name;
    const bool animated = picture.name.find("torque") != std::string::npos;
    EXPECT_EQ(count(picture.text, "attributeName=\"display\""), animated ? 8U : 0U);
    EXPECT_EQ(count(picture.text, "<g display=\"inline\">"), animated ? 1U : 0U);
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "flexspline_crack_0_size_0_opening.svg",
                       "flexspline_crack_0_size_0_torque_0.svg",
                       "flexspline_crack_0_size_0_torque_1.svg",
                       "flexspline_crack_0_size_1_opening.svg",
                       "flexspline_crack_0_size_1_torque_0.svg",
                       "flexspline_crack_0_size_1_torque_1.svg",
                   }));
  // 720 angles do not make a picture of 20 MB: an animation shows at most 60 of them, and fewer
  // until it is small enough.
  TurnRun many = run;
  many.sizes.pop_back();
  many.torques.pop_back();
  std::vector<gear_fem::FacesAtAngle>& faces = many.sizes[0].turn.torques[0].faces;
  while (faces.size() < 720) faces.push_back(faces[faces.size() % 8]);
  const std::string shown = turn_pictures(many).at(1).text;
  EXPECT_EQ(count(shown, "attributeName=\"display\""), 60U);
  std::vector<gear_fem::FacesAtAngle> prime(faces.begin(), faces.begin() + 61);
  faces.swap(prime);
  EXPECT_EQ(count(turn_pictures(many).at(1).text, "attributeName=\"display\""), 31U);
  faces.swap(prime);
  many.sizes[0].turn.plane.cells.resize(10, many.sizes[0].turn.plane.cells[0]);
  for (int more = 0; more < 7; ++more) {
    auto& cells = many.sizes[0].turn.plane.cells;
    const std::vector<fem::CrackCell> copy = cells;
    cells.insert(cells.end(), copy.begin(), copy.end());
  }
  const std::string fewer = turn_pictures(many).at(1).text;
  EXPECT_LT(fewer.size(), 2e6);
  EXPECT_LT(count(fewer, "attributeName=\"display\""), 60U);
}

TEST(FeTurn, BehaviourOfThePlan) {
  const GearSet gear = breathing();
  const TurnRun run = planned_turn(gear, {});
  EXPECT_FALSE(run.calculated);
  ASSERT_EQ(run.plan.size(), 1U);
  EXPECT_EQ(run.plan[0].dofs, 73023U);
  EXPECT_EQ(run.torques, (std::vector<double>{-48, 0, 48}));
  EXPECT_NE(turn_csv(run, gear).find("73023 unknowns"), std::string::npos);
  EXPECT_EQ(std::ranges::count(run.notes, "fe.turn_model", &Note::code), 1);
  EXPECT_EQ(std::ranges::count(run.notes, "fe.cam_perimeter", &Note::code), 1);
  EXPECT_EQ(std::ranges::find(run.notes, "fe.turn_model", &Note::code)->severity, Severity::care);
  GearSet more = gear;
  more.load.axial_force = 10;
  more.flexspline->stress_nonuniformity = 1.1;
  const TurnRun noted = planned_turn(more, {});
  EXPECT_EQ(std::ranges::count(noted.notes, "fe.axial_force", &Note::code), 1);
  EXPECT_EQ(std::ranges::count(noted.notes, "fe.stress_nonuniformity", &Note::code), 1);
}

TEST(FeTurn, BehaviourOfASurfaceCrack) {
  test::start_mpi();
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_surface_crack.toml");
  auto& crack = std::get<WallSurfaceCrack>(gear.flexspline->crack.at(0));
  EXPECT_EQ(crack.mouth, Mouth::inner);
  EXPECT_EQ(std::ranges::count(planned_turn(gear, {}).notes, "fe.mouth_outside", &Note::code), 0);
  crack.depth = 0.09e-3;
  crack.half_length = 0.1e-3;
  const TurnOptions options{.request = {.torques = {0}, .depths = {0.045e-3}, .angles = 12},
                            .order = 2};
  const TurnRun inside = run_turn(gear, options, test::mpi());
  ASSERT_EQ(inside.sizes.size(), 1U);
  EXPECT_NEAR(inside.sizes[0].half_length, 0.05e-3, 1e-12);  // the same shape
  EXPECT_EQ(inside.reason(), "");
  HistoryFile file(pieces_of(turn_csv(inside, gear)), "turn.csv");
  const TurnTable table = read_turn_table(file);
  EXPECT_EQ(table.size_name, "depth");
  EXPECT_EQ(table.stations.front(), 0);
  EXPECT_EQ(table.stations.back(), 1);
  EXPECT_NE(turn_text(inside, gear).find("deepest"), std::string::npos);
  // The oval bends the wall, so the faces of the wall are open in turn.
  crack.mouth.reset();
  EXPECT_EQ(std::ranges::count(planned_turn(gear, {}).notes, "fe.mouth_outside", &Note::code), 1);
  const TurnRun outside = run_turn(gear, options, test::mpi());
  const auto deepest = [](const TurnRun& run) {
    for (const StationTurn& station : run.sizes[0].turn.torques[0].stations)
      if (station.station == 1) return station;
    throw InputError("station", "is missing");
  };
  const StationTurn in = deepest(inside);
  const StationTurn out = deepest(outside);
  for (std::size_t i = 0; i < in.factors.size(); ++i)
    EXPECT_LT(std::min(in.factors[i].K_I, out.factors[i].K_I), 0.1 * in.mode_I.largest) << i;
  EXPECT_GT(out.mode_I.largest, 0.3 * in.mode_I.largest);
}

// Each rule is broken once.
TEST(FeTurn, InputRefused) {
  const GearSet good = breathing();
  const auto refused = [](const GearSet& gear, const TurnOptions& options,
                          const std::string& text) {
    try {
      (void)planned_turn(gear, options);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refused(good, {.request = {.crack = "flexspline.crack[7]"}}, "is not a crack of the flexspline");
  refused(good, {.order = 5}, "order");
  refused(good, {.request = {.half_lengths = {20e-3}}}, "flexspline.crack[0]");
  refused(good, {.request = {.depths = {0.1e-3}}}, "--depth: is not the size of a through crack");
  GearSet gear = good;
  gear.flexspline->crack.clear();
  refused(gear, {}, "must have a through or surface crack of the barrel");
  gear = good;
  gear.flexspline->crack.push_back(gear.flexspline->crack.front());
  std::get<WallThroughCrack>(gear.flexspline->crack[1]).half_length *= 0.9;
  refused(gear, {}, "choose one of them by --crack");
  std::get<WallThroughCrack>(gear.flexspline->crack[1]).section = WallSection::rim;
  refused(gear, {.request = {.crack = "flexspline.crack[1]"}},
          "must be a through or surface crack of the barrel");
  gear = good;
  std::get<WallThroughCrack>(gear.flexspline->crack.front()).count = 3;
  refused(gear, {}, "flexspline.crack[0].count = 3");
  gear = good;
  gear.flexspline->rim.reset();
  refused(gear, {}, "flexspline.rim");
  gear = good;
  gear.flexspline->rim->outer_diameter -= 1.5 * gear.flexspline->rim->wall_thickness;
  refused(gear, {}, "covers the barrel's");
  gear = good;
  gear.flexspline->crack_free = CrackFree::factor;
  gear.flexspline->rim.reset();
  gear.flexspline->barrel.reset();
  gear.flexspline->diaphragm.reset();
  refused(gear, {}, "must be \"sections\" for a turn");
  gear = good;
  gear.drive.wave_number = 3;
  refused(gear, {}, "drive.wave_number: is 3");
  gear = good;
  gear.wave_generator->bearing->clearance = 0.5e-3;
  try {
    (void)run_turn(gear, {.request = {.torques = {0}, .angles = 8}, .order = 2}, test::mpi());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("does not touch"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace strainwave::fe_study

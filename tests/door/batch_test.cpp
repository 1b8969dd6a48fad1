// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"

namespace strainwave {
namespace {

const std::vector<std::string> kOutputs = {"cracked.positive.stiffness", "intact.stiffness"};

const GearSet& article() {
  static const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  return gear;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// Kind: input.  The numbers that tell how others vary cannot be drawn in a batch.
TEST(Batch, InputNumbersOfAScatter) {
  GearSet gear = article();
  InputScatter scatter;
  scatter.path = "load.torque";
  scatter.relative_standard_deviation = 0.1;
  gear.scatter.push_back(scatter);
  const std::vector<std::string> paths = {"scatter[0].relative_standard_deviation"};
  const std::vector<double> values = {0.03};
  EXPECT_EQ(test::broken_rule([&] {
              (void)batch(gear, {.paths = paths, .values = values, .outputs = kOutputs});
            }),
            "scatter[0].relative_standard_deviation: is not a number of the drive that can be "
            "drawn; name a number outside of range, scatter and correlation");
}

TEST(Batch, CrosscheckEqualsSingleEvaluations) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const GearSet gear = test::random_drive(seed);
    test::Dice dice(seed);
    const std::vector<std::string> paths = {"load.torque", "material.steel.youngs_modulus"};
    std::vector<double> values;
    for (int row = 0; row < 4; ++row) {
      values.push_back(dice.uniform(-2, 2) * gear.load.torque);
      values.push_back(dice.uniform(0.2, 3) * gear.material.at("steel").youngs_modulus.value());
    }
    const BatchResult result =
        batch(gear, {.paths = paths, .values = values, .outputs = kOutputs, .threads = 2});
    for (std::size_t row = 0; row < 4; ++row) {
      GearSet varied = gear;
      for (std::size_t i = 0; i < 2; ++i) set_number(varied, paths[i], values[2 * row + i]);
      RowCode expected = RowCode::ok;
      std::vector<double> numbers(2);
      try {
        const StiffnessResult single = evaluate(varied, Method::corrected);
        if (!single.usable()) expected = RowCode::not_usable;
        for (std::size_t k = 0; k < 2; ++k)
          numbers[k] = output_named(single, kOutputs[k]).value().value;
      } catch (const InputError&) {
        expected = RowCode::refused;
      }
      EXPECT_EQ(result.codes[row], expected) << seed;
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(result.numbers[2 * row + k], numbers[k]) << seed;
    }
  }
}

TEST(Batch, CrosscheckOutputsOverATurn) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  OuterRaceCrack crack;
  crack.depth = 0.7e-3;
  gear.wave_generator->crack.emplace_back(crack);
  const std::vector<std::string> paths = {"wave_generator.crack[0].depth"};
  const std::vector<double> values = {0.7e-3};
  const std::vector<std::string> outputs = {"curve.positive.over_turn.softest.K1"};
  const BatchResult result =
      batch(gear, {.paths = paths, .values = values, .outputs = outputs, .threads = 1});
  const StiffnessResult single = evaluate(gear, Method::corrected, {.over_turn = true});
  EXPECT_EQ(result.codes.front(), RowCode::ok);
  EXPECT_EQ(result.numbers.front(), output_named(single, outputs.front()).value().value);
}

TEST(Batch, CrosscheckOutputsOfTheCoupledDrive) {
  // The coupled drive is solved only if one of its outputs is asked for; the sum does not change.
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const std::vector<std::string> paths = {"flexspline.barrel.wall_thickness"};
  const std::vector<double> values = {0.40e-3, 0.46e-3};
  const auto with = [&](const std::vector<std::string>& outputs) {
    return batch(gear, {.paths = paths, .values = values, .outputs = outputs, .threads = 1});
  };
  const BatchResult both = with({"curve.positive.K1", "intact.stiffness"});
  const BatchResult sum = with({"intact.stiffness"});
  for (std::size_t row = 0; row < 2; ++row) {
    GearSet varied = gear;
    set_number(varied, paths[0], values[row]);
    const StiffnessResult single = evaluate(varied, Method::corrected);
    EXPECT_EQ(both.codes[row], RowCode::ok);
    EXPECT_EQ(both.numbers[2 * row], single.curve->positive.K1.value);
    EXPECT_EQ(both.numbers[2 * row + 1], single.intact.stiffness.value);
    EXPECT_EQ(sum.numbers[row], single.intact.stiffness.value);
  }
}

TEST(Batch, IdentityForAnyNumberOfThreads) {
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth"};
  std::vector<double> values;
  for (int i = 0; i < 40; ++i) values.push_back((i - 2) * 0.5e-3);  // some values are refused
  const auto with = [&](int threads) {
    return batch(article(),
                 {.paths = paths, .values = values, .outputs = kOutputs, .threads = threads});
  };
  const BatchResult one = with(1);
  EXPECT_GT(std::ranges::count(one.codes, RowCode::ok), 10);
  EXPECT_GT(std::ranges::count(one.codes, RowCode::refused), 1);
  for (const int threads : {0, 2, 3, 8}) {
    const BatchResult other = with(threads);
    EXPECT_TRUE(same_bits(one.numbers, other.numbers)) << threads;
    EXPECT_EQ(one.codes, other.codes) << threads;
    ASSERT_EQ(one.faults.size(), other.faults.size()) << threads;
    for (std::size_t i = 0; i < one.faults.size(); ++i) {
      EXPECT_EQ(one.faults[i].row, other.faults[i].row) << threads;
      EXPECT_EQ(one.faults[i].message, other.faults[i].message) << threads;
    }
  }
}

TEST(Batch, InputRefusedRowsHaveCodeZerosAndFirstMessage) {
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth"};
  const std::vector<double> values = {1e-3, -1e-3, std::numeric_limits<double>::quiet_NaN(), 2e-3};
  const BatchResult result =
      batch(article(), {.paths = paths, .values = values, .outputs = kOutputs});
  EXPECT_EQ(result.codes,
            (std::vector{RowCode::ok, RowCode::refused, RowCode::refused, RowCode::ok}));
  EXPECT_EQ(result.numbers[2], 0.0);
  EXPECT_EQ(result.numbers[3], 0.0);
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(result.faults[0].code, RowCode::refused);
  EXPECT_EQ(result.faults[0].row, 1U);
  EXPECT_EQ(result.faults[0].message, "output_shaft.crack[0].depth = -0.001 m violates: > 0");
}

TEST(Batch, InputFaultsAreFoundBeforeTheWork) {
  const std::vector<double> values = {1e-3, 2e-3, 3e-3};
  const auto refusal = [&](const std::vector<std::string>& paths,
                           const std::vector<std::string>& outputs, int threads = 1) {
    return test::broken_rule([&] {
      const Progress never([](double) {
        ADD_FAILURE() << "a row was evaluated";
        return true;
      });
      return batch(article(),
                   {.paths = paths, .values = values, .outputs = outputs, .threads = threads},
                   never);
    });
  };
  const std::string depth = "output_shaft.crack[0].depth";
  EXPECT_NE(refusal({"output_shaft.crack[0].depht"}, kOutputs).find(depth), std::string::npos);
  EXPECT_NE(refusal({depth}, {"cracked.positive.stifness"}).find("cracked.positive.stiffness?"),
            std::string::npos);
  EXPECT_EQ(refusal({depth}, {"a", "a"}), "outputs: \"a\" is given twice");
  EXPECT_EQ(refusal({depth, depth, depth}, kOutputs),
            "paths: \"output_shaft.crack[0].depth\" is given twice");
  EXPECT_EQ(refusal({depth, "load.torque"}, kOutputs),
            "values: has 3 numbers; give 2 for each row");
  EXPECT_EQ(refusal({}, kOutputs), "paths: must name at least one number of the drive");
  EXPECT_EQ(refusal({depth}, kOutputs, -1), "threads = -1 violates: >= 0 and <= 256");
  EXPECT_EQ(refusal({depth}, kOutputs, 257), "threads = 257 violates: >= 0 and <= 256");
}

TEST(Batch, BehaviourStopsAfterTheRowThatAsks) {
  const std::vector<std::string> paths = {"load.torque"};
  const std::vector<double> values(1000, 10.0);
  int told = 0;
  const Progress progress([&](double share) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    return ++told < 3;
  });
  const auto run = [&](int threads, const Progress& to) {
    return batch(article(),
                 {.paths = paths, .values = values, .outputs = kOutputs, .threads = threads}, to);
  };
  EXPECT_THROW((void)run(1, progress), Stopped);
  EXPECT_EQ(told, 3);
  // The calling thread asks even if other threads have taken all rows.
  EXPECT_THROW((void)run(3, Progress([](double) { return false; })), Stopped);
}

TEST(Batch, LimitOfNoRows) {
  const std::vector<std::string> paths = {"load.torque"};
  const BatchResult result = batch(article(), {.paths = paths, .values = {}, .outputs = kOutputs});
  EXPECT_TRUE(result.codes.empty());
  EXPECT_TRUE(result.numbers.empty());
}

}  // namespace
}  // namespace strainwave

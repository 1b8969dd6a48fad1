// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/batch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/study/varied_series.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"
#include "support/sanitized.hpp"

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

/// What `evaluate` gives for one row.
struct SingleRow {
  RowCode code = RowCode::ok;
  std::string message;
  std::vector<double> numbers;
};

SingleRow single_row(GearSet gear, const std::vector<std::string>& paths,
                     std::span<const double> values, const std::vector<std::string>& outputs) {
  SingleRow row{.message = {}, .numbers = std::vector<double>(outputs.size())};
  try {
    for (std::size_t i = 0; i < paths.size(); ++i) set_number(gear, paths[i], values[i]);
    const StiffnessResult result = evaluate(gear, Method::corrected, {.coupled_drive = false});
    if (!result.usable()) row.code = RowCode::not_usable;
    for (std::size_t y = 0; y < outputs.size(); ++y) {
      const auto value = output_named(result, outputs[y]);
      if (!value)
        return {RowCode::output_absent, "the result lacks the output " + outputs[y],
                std::vector<double>(outputs.size())};
      row.numbers[y] = value->value;
    }
    row.message = result.unusable_because;
  } catch (const InputError& error) {
    row = {RowCode::refused, error.what(), std::vector<double>(outputs.size())};
  }
  return row;
}

/// The strength margins of a drive, and an output of the sum.
std::vector<std::string> margins_of(const GearSet& gear) {
  std::vector<std::string> names;
  for_each_quantity(evaluate(gear, Method::corrected, {.coupled_drive = false}),
                    [&](const std::string& name, const Quantity&) {
                      if (name.find(".strength.") != std::string::npos && !name.ends_with("_size"))
                        names.push_back(name);
                    });
  if (!names.empty()) names.emplace_back("cracked.negative.stiffness");
  return names;
}

// Kind: cross-check (FA-4, FA-13).  Source: `evaluate`, which seeks critical sizes and writes
// sentences too.  All kinds of cracks of the sum, in random drives, both senses of torque.
// Tolerance: 1e-10, the contract of a batch; the same rows have no answer, for the same reason.
TEST(Batch, CrosscheckStrengthMargins) {
  std::set<std::string> kinds;
  std::map<RowCode, int> codes;
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 40U : 300U); ++seed) {
    const GearSet gear = test::random_drive(seed);
    const std::vector<std::string> outputs = margins_of(gear);
    if (outputs.empty()) continue;
    for_each_crack(gear, [&](const std::string& path, const auto& crack) {
      kinds.insert(path.substr(0, path.find('.')) +
                   std::string(std::decay_t<decltype(crack)>::kKind));
    });
    test::Dice dice(seed);
    const Material& steel = gear.material.at("steel");
    std::vector<std::string> paths = {"load.torque", "material.steel.youngs_modulus"};
    if (steel.fracture_toughness) paths.emplace_back("material.steel.fracture_toughness");
    if (steel.yield_strength) paths.emplace_back("material.steel.yield_strength");
    constexpr std::size_t kRows = 4;
    std::vector<double> values;
    for (std::size_t row = 0; row < kRows; ++row)
      for (const std::string& path : paths)
        values.push_back((row == 3 && path != "load.torque" ? dice.uniform(-0.2, 1.0) : 1.0) *
                         dice.uniform(0.3, 2) *
                         (dice.chance(0.3) && path == "load.torque" ? -1 : 1) *
                         number_at(gear, path).value);
    const BatchResult result =
        batch(gear, {.paths = paths, .values = values, .outputs = outputs, .threads = 2});
    for (std::size_t row = 0; row < kRows; ++row) {
      const SingleRow expected = single_row(
          gear, paths, std::span(values).subspan(row * paths.size(), paths.size()), outputs);
      ++codes[expected.code];
      ASSERT_EQ(result.codes[row], expected.code)
          << seed << ", " << row << ": " << expected.message;
      for (std::size_t y = 0; y < outputs.size(); ++y)
        test::expect_relative(result.numbers[row * outputs.size() + y], expected.numbers[y], 1e-10);
      const auto fault = std::ranges::find(result.faults, expected.code, &BatchFault::code);
      if (fault != result.faults.end() && fault->row == row) {
        EXPECT_EQ(fault->message, expected.message) << seed;
      }
      if (HasFailure()) FAIL() << seed << ", " << row;
    }
  }
  if (test::kSanitized) return;
  EXPECT_EQ(kinds.size(), 6U);
  for (const RowCode code : {RowCode::ok, RowCode::refused, RowCode::not_usable})
    EXPECT_GT(codes[code], 5) << enum_name(code);
}

/// Numbers of a random drive that vary: loads, the material, and the sizes of all cracks.
std::vector<std::string> varied_numbers(const GearSet& gear) {
  std::vector<std::string> paths = {"load.torque", "material.steel.youngs_modulus"};
  if (gear.load.axial_force != 0) paths.emplace_back("load.axial_force");
  const Material& steel = gear.material.at("steel");
  if (steel.fracture_toughness) paths.emplace_back("material.steel.fracture_toughness");
  if (steel.yield_strength) paths.emplace_back("material.steel.yield_strength");
  for_each_crack(gear, [&](const std::string& path, const auto&) {
    for (const char* const size : {"depth", "half_length", "aspect_ratio", "angle"}) {
      const std::string of_crack = path + '.' + size;
      try {
        (void)number_at(gear, of_crack);
        paths.push_back(of_crack);
      } catch (const InputError&) {  // this kind has no such number
      }
    }
  });
  return paths;
}

/// Outputs of the sum that a drive has, and its strength margins.
std::vector<std::string> planned_outputs(const GearSet& gear) {
  std::vector<std::string> names;
  for_each_quantity(evaluate(gear, Method::corrected, {.coupled_drive = false}),
                    [&](const std::string& name, const Quantity&) {
                      if (VariedSeries::covers(std::span(&name, 1))) names.push_back(name);
                    });
  return names;
}

/// What random rows of random drives were, and how far a batch is from `evaluate`.
struct RandomRows {
  std::map<RowCode, int> codes;
  int by_tables = 0;  ///< drives whose rows read tables
  std::size_t compared = 0;
  /// Largest difference of an output, over its value, and its place.
  std::pair<double, std::string> largest;
};

/// Compares random rows of a drive: every output that the plan covers, each code, and the message
/// of the first row with each code.
void compare_random_rows(RandomRows& found, const GearSet& gear, std::size_t rows,
                         std::uint64_t seed) {
  const std::vector<std::string> outputs = planned_outputs(gear);
  const std::vector<std::string> paths = varied_numbers(gear);
  test::Dice dice(seed);
  std::vector<double> values;
  for (std::size_t row = 0; row < rows; ++row)
    for (const std::string& path : paths) {
      const double factor = dice.chance(0.06) ? dice.uniform(-0.5, 4) : dice.log_uniform(0.75, 1.3);
      values.push_back(factor * (path == "load.torque" && dice.chance(0.3) ? -1 : 1) *
                       number_at(gear, path).value);
    }
  const BatchResult result =
      batch(gear, {.paths = paths, .values = values, .outputs = outputs, .threads = 2});
  if (result.tables) ++found.by_tables;
  std::set<RowCode> told;  // codes whose first row has been seen
  for (std::size_t row = 0; row < rows; ++row) {
    const SingleRow expected = single_row(
        gear, paths, std::span(values).subspan(row * paths.size(), paths.size()), outputs);
    ++found.codes[expected.code];
    ASSERT_EQ(result.codes[row], expected.code) << seed << ", " << row << ": " << expected.message;
    for (std::size_t y = 0; y < outputs.size(); ++y) {
      const double number = result.numbers[row * outputs.size() + y];
      const double exact = expected.numbers[y];
      ++found.compared;
      if (number == exact) continue;
      const double difference = std::abs(number - exact) / std::abs(exact);
      if (!(difference <= found.largest.first))
        found.largest = {difference, fmt::format("{}, {}: {}", seed, row, outputs[y])};
    }
    if (expected.code == RowCode::ok || !told.insert(expected.code).second) continue;
    const auto fault = std::ranges::find(result.faults, expected.code, &BatchFault::code);
    ASSERT_NE(fault, result.faults.end());
    ASSERT_EQ(fault->row, row) << seed;
    ASSERT_EQ(fault->message, expected.message) << seed;
  }
}

// Kind: cross-check (ST-21), (ST-22), (FA-4).  Source: `evaluate`.  Random rows of random drives
// with all kinds of cracks of the sum: every output that the plan covers, to the contract of a
// batch, 1e-10, and the same rows without an answer, for the same rule.  STRAINWAVE_LONG asks for a
// million rows.  A twentieth of them has strength margins, for which `evaluate` takes some
// milliseconds, because it seeks critical sizes too.
TEST(Batch, CrosscheckRandomRows) {
  const bool whole = std::getenv("STRAINWAVE_LONG") != nullptr && !test::kSanitized;
  const std::uint64_t drives = whole ? 200 : test::kSanitized ? 10 : 60;
  std::set<std::string> kinds;
  RandomRows found;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    GearSet gear = test::random_drive(1000 + seed);
    for_each_crack(gear, [&](const std::string& path, const auto& crack) {
      kinds.insert(path.substr(0, path.find('.')) +
                   std::string(std::decay_t<decltype(crack)>::kKind));
    });
    compare_random_rows(found, gear, whole ? 250 : 2, seed);
    Material& steel = gear.material.at("steel");
    steel.fracture_toughness.reset();
    steel.yield_strength.reset();
    compare_random_rows(found, gear, whole ? 4750 : 6, 1'000'000 + seed);
    if (HasFatalFailure()) return;
  }
  RecordProperty("compared", std::to_string(found.compared));
  RecordProperty("drives_by_tables", found.by_tables);
  RecordProperty("largest", fmt::format("{} at {}", found.largest.first, found.largest.second));
  for (const auto& [code, count] : found.codes)
    RecordProperty(fmt::format("rows_{}", enum_name(code)), count);
  EXPECT_LE(found.largest.first, 1e-10) << found.largest.second;
  if (test::kSanitized) return;
  EXPECT_EQ(kinds.size(), 6U);
  for (const RowCode code : {RowCode::ok, RowCode::refused, RowCode::not_usable})
    EXPECT_GT(found.codes[code], whole ? 100 : 0) << enum_name(code);
  if (whole) {
    EXPECT_GT(found.by_tables, 50);
    EXPECT_GT(found.largest.first, 0.0);
  }
}

// Kind: identity.  Margins have the same bits for any number of threads, with tables for the sum
// beside them; the result states how far the tables are from the engine.
TEST(Batch, IdentityMarginsByTablesForAnyNumberOfThreads) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/critical_crack.toml");
  const std::vector<std::string> paths = {"flexspline.crack[0].half_length",
                                          "output_shaft.crack[0].depth"};
  const std::vector<std::string> outputs = {"flexspline.crack[0].strength.reserve",
                                            "output_shaft.crack[0].strength.utilisation",
                                            "cracked.positive.stiffness"};
  const std::size_t rows = test::kSanitized ? 600 : 3000;
  std::vector<double> values;
  for (std::size_t row = 0; row < rows; ++row) {
    test::Dice dice(row);
    values.push_back(dice.uniform(4e-3, 6e-3));
    values.push_back(dice.uniform(1.5e-3, 2.5e-3));
  }
  const auto with = [&](int threads) {
    return batch(gear, {.paths = paths, .values = values, .outputs = outputs, .threads = threads});
  };
  const BatchResult one = with(1);
  const BatchResult three = with(3);
  EXPECT_TRUE(same_bits(one.numbers, three.numbers));
  EXPECT_EQ(one.codes, three.codes);
  if (test::kSanitized) return;
  ASSERT_TRUE(one.tables && three.tables);
  EXPECT_EQ(one.tables->largest_error, three.tables->largest_error);
  EXPECT_GE(one.tables->cracks, 1);
  EXPECT_EQ(one.tables->points, 1000);
  EXPECT_GT(one.tables->largest_error, 0.0);
  EXPECT_LT(one.tables->largest_error, 1e-10);
  for (const std::size_t row : {0U, 17U, 2999U}) {
    const SingleRow expected =
        single_row(gear, paths, std::span(values).subspan(row * 2, 2), outputs);
    for (std::size_t y = 0; y < 3; ++y)
      test::expect_relative(one.numbers[row * 3 + y], expected.numbers[y], 1e-10);
  }
}

// Kind: behaviour (ST-22).  A batch whose rows the engine computed states no error of tables.
TEST(Batch, BehaviourNoErrorOfTablesWithoutTables) {
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth"};
  const std::vector<double> values = {1e-3, 2e-3};
  EXPECT_FALSE(
      batch(article(), {.paths = paths, .values = values, .outputs = kOutputs}).tables.has_value());
}

// Kind: cross-check.  Source: `evaluate` after `set_number`, which drops the [[range]] and the
// [[scatter]] of a number that is set.  A row beyond them has numbers by the plan too.
TEST(Batch, CrosscheckRowsBeyondARange) {
  GearSet gear = article();
  gear.range = {
      {.path = "output_shaft.crack[0].depth", .lower = "0.1 mm", .upper = "2 mm", .source = {}}};
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth"};
  const std::vector<double> values = {1e-3, 3e-3};
  const BatchResult result = batch(gear, {.paths = paths, .values = values, .outputs = kOutputs});
  for (std::size_t row = 0; row < 2; ++row) {
    const SingleRow expected = single_row(gear, paths, std::span(values).subspan(row, 1), kOutputs);
    EXPECT_EQ(result.codes[row], expected.code);
    EXPECT_EQ(result.numbers[2 * row], expected.numbers[0]);
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

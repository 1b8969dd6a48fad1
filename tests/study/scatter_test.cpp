// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/sensitivity.hpp"
#include "strainwave/present/json.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using test::article_gear;
using test::expect_relative;

GearSet example() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/article_scatter.toml"); }

Scatter scatter(const GearSet& gear, const ScatterOptions& options) {
  return scatter_of(gear, sensitivity_of(gear), options);
}

const ScatterOutput& output(const Scatter& scatter, const std::string& name) {
  return *std::ranges::find(scatter.outputs, name, &ScatterOutput::name);
}

/// The whole content of a report.
std::string told(const SensitivityReport& report) {
  return json_of(report) + json_of(evidence_of(report).notes);
}

/// A sound shaft alone, K = G J/L.
GearSet shaft() {
  GearSet gear = article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  gear.output_shaft->crack.clear();
  return gear;
}

TEST(Scatter, ReferenceLognormalByHand) {
  // K ~ G/L^1: ln K is normal with the variance of ln G plus that of ln L (SN-7, SN-8).
  GearSet gear = shaft();
  gear.scatter = {
      {.path = "material.steel.shear_modulus", .relative_standard_deviation = 0.1, .source = {}},
      {.path = "output_shaft.length", .relative_standard_deviation = 0.2, .source = {}}};
  constexpr int kN = 20'000;
  const Scatter result = scatter(gear, {.samples = kN});
  const ScatterOutput& K = output(result, "intact.stiffness");
  expect_relative(K.first_order, std::sqrt(0.05), 1e-13);
  expect_relative(K.share[0], 0.2, 1e-12);
  expect_relative(K.share[1], 0.8, 1e-12);
  const double variance = std::log1p(0.01) + std::log1p(0.04);
  const double mean = K.value * std::exp(variance / 2);
  // The tolerance is four standard errors as stated by the result.
  EXPECT_NEAR(K.mean / mean, 1, 4 * K.mean_error);
  EXPECT_NEAR(K.relative_deviation, std::sqrt(std::expm1(variance)),
              4 * K.relative_deviation_error);
  const double sigma = std::sqrt(variance);
  // Standard error of a quantile: sqrt(p(1-p)/n)/density, in units of sigma 1.25/sqrt(n) and
  // 2.11/sqrt(n).
  EXPECT_NEAR(std::log(K.median / K.value) / sigma, 0, 4 * 1.25 / std::sqrt(kN));
  EXPECT_NEAR(std::log(K.low / K.value) / sigma, -1.6449, 4 * 2.11 / std::sqrt(kN));
  EXPECT_NEAR(std::log(K.high / K.value) / sigma, 1.6449, 4 * 2.11 / std::sqrt(kN));
  // SN-9 for small normal scatter: 1/sqrt(2n); here a little more.
  EXPECT_GT(K.relative_deviation_error, K.relative_deviation / std::sqrt(2.0 * kN));
  EXPECT_LT(K.relative_deviation_error, 2 * K.relative_deviation / std::sqrt(2.0 * kN));
  EXPECT_EQ(result.evaluated, kN);
}

TEST(Scatter, ReferenceNormalByHand) {
  // K ~ G, G normal: so is K, with the file's value as mean.
  GearSet gear = shaft();
  gear.scatter = {{.path = "material.steel.shear_modulus",
                   .relative_standard_deviation = 0.05,
                   .distribution = ScatterDistribution::normal,
                   .source = {}}};
  constexpr int kN = 20'000;
  const Scatter result = scatter(gear, {.samples = kN});
  const ScatterOutput& K = output(result, "intact.stiffness");
  EXPECT_NEAR(K.mean / K.value, 1, 4 * K.mean_error);
  EXPECT_NEAR(K.relative_deviation, 0.05, 4 * K.relative_deviation_error);
  expect_relative(K.relative_deviation_error, 0.05 / std::sqrt(2.0 * kN), 0.05);
  expect_relative(K.mean_error, K.relative_deviation / std::sqrt(kN), 1e-12);
}

TEST(Scatter, CrosscheckFirstOrderAndMonteCarlo) {
  // For small scatter the model is linear, so both methods agree within their accuracy.
  GearSet gear = example();
  for (InputScatter& input : gear.scatter) *input.relative_standard_deviation /= 10;
  const Scatter result = scatter(gear, {.samples = 3000});
  ASSERT_EQ(result.outputs.size(), 5U);
  for (const ScatterOutput& out : result.outputs) {
    EXPECT_NEAR(out.relative_deviation, out.first_order,
                4 * out.relative_deviation_error + 0.02 * out.first_order)
        << out.name;
    double sum = 0.0;
    for (const double share : out.share) sum += share;
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
  EXPECT_EQ(result.evaluated, 3000);
}

TEST(Scatter, IdentityAnyNumberOfThreadsGivesTheSameBits) {
  const GearSet gear = example();
  const Sensitivity sensitivity = sensitivity_of(gear);
  const auto text = [&](int threads, std::uint64_t seed) {
    return told({.sensitivity = sensitivity,
                 .scatter = scatter_of(gear, sensitivity,
                                       {.samples = 1500, .seed = seed, .threads = threads})});
  };
  const std::string one = text(1, 5);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(text(threads, 5), one) << threads;
  EXPECT_NE(text(1, 6), one);
}

TEST(Scatter, BehaviourRefusedDrawsAreCounted) {
  // A crack of 2/3 of the wall, normal with a deviation of 1/2: the crack is deeper than the wall
  // beyond +1 deviation (15.87 %), not positive below -2 (2.28 %), and has a/t > 0.8 beyond 0.4.
  GearSet gear = shaft();
  AnnularCrack crack;
  crack.depth = 12.5 * mm * 2 / 3;
  gear.output_shaft->crack = {crack};
  gear.scatter = {{.path = "output_shaft.crack[0].depth",
                   .relative_standard_deviation = 0.5,
                   .distribution = ScatterDistribution::normal,
                   .source = {}}};
  constexpr int kN = 4000;
  const Scatter result = scatter(gear, {.samples = kN});
  const auto share = [](int n) { return static_cast<double>(n) / kN; };
  const double error = 4 * 0.5 / std::sqrt(kN);
  EXPECT_NEAR(share(result.refused), 0.1587 + 0.0228, error);
  EXPECT_NEAR(share(result.unusable), 0.3446 - 0.1587, error);
  EXPECT_EQ(result.evaluated + result.refused + result.unusable, kN);
  EXPECT_EQ(test::count_notes(result.notes, "scatter.left_out"), 1);
  EXPECT_EQ(test::count_notes(scatter(example(), {.samples = 20}).notes, "scatter.left_out"), 0);
}

TEST(Scatter, BehaviourStrongScatterIsNotLinear) {
  GearSet gear = shaft();
  // K ~ D^4.8: the deviation of a lognormal K is sqrt(exp(0.72^2) - 1) = 0.83 rather than 0.72.
  gear.scatter = {
      {.path = "output_shaft.outer_diameter", .relative_standard_deviation = 0.15, .source = {}}};
  const Scatter result = scatter(gear, {.samples = 20'000});
  EXPECT_EQ(test::count_notes(result.notes, "scatter.not_linear", "intact.stiffness"), 1);
  gear.scatter[0].relative_standard_deviation = 0.001;
  EXPECT_EQ(test::count_notes(scatter(gear, {.samples = 4000}).notes, "scatter.not_linear"), 0);
}

TEST(Scatter, IdentityAnInputWithoutInfluenceHasNoShare) {
  GearSet gear = shaft();
  gear.scatter = {{.path = "drive.ratio", .relative_standard_deviation = 0.1, .source = {}}};
  const Scatter result = scatter(gear, {.samples = 10});
  const ScatterOutput& K = output(result, "intact.stiffness");
  EXPECT_EQ(K.first_order, 0.0);
  EXPECT_EQ(K.share[0], 0.0);
  EXPECT_EQ(K.low, K.high);
}

TEST(Scatter, BehaviourModelFormStaysBeside) {
  const GearSet gear = example();
  const Scatter result = scatter(gear, {.samples = 20});
  const StiffnessResult stiffness = torsional_stiffness(gear);
  EXPECT_EQ(output(result, "cracked.positive.stiffness").model_uncertainty,
            stiffness.positive.stiffness.relative_uncertainty);
  EXPECT_EQ(test::count_notes(result.notes, "scatter.model_form"), 1);
}

TEST(Scatter, IdentityOtherResultsIgnoreIt) {
  GearSet without = example();
  without.scatter.clear();
  EXPECT_EQ(torsional_stiffness(example()).positive.stiffness.value,
            torsional_stiffness(without).positive.stiffness.value);
  const Sensitivity with = sensitivity_of(example());
  EXPECT_EQ(told({with, {}}), told({sensitivity_of(without), {}}));
}

// Kind: identity (SN-8).  Draws that are not kept have the same quantiles, bit for bit, and the
// same moments.  Tolerance: 1e-10, another order of the sums.
TEST(Scatter, IdentityDrawsThatAreNotKept) {
  const GearSet gear = example();
  const Sensitivity sensitivity = sensitivity_of(gear);
  const Scatter kept = scatter_of(gear, sensitivity, {.samples = 3000});
  for (const int few : {2999, 500, 20}) {
    const Scatter passes = scatter_of(gear, sensitivity, {.samples = 3000, .kept = few});
    EXPECT_EQ(passes.evaluated, kept.evaluated);
    EXPECT_EQ(passes.refused, kept.refused);
    EXPECT_EQ(passes.unusable, kept.unusable);
    ASSERT_EQ(passes.outputs.size(), kept.outputs.size());
    for (std::size_t y = 0; y < kept.outputs.size(); ++y) {
      const ScatterOutput& one = kept.outputs[y];
      const ScatterOutput& two = passes.outputs[y];
      EXPECT_EQ(two.low, one.low);
      EXPECT_EQ(two.median, one.median);
      EXPECT_EQ(two.high, one.high);
      test::expect_relative(two.mean, one.mean, 1e-12);
      test::expect_relative(two.relative_deviation, one.relative_deviation, 1e-10);
      test::expect_relative(two.relative_deviation_error, one.relative_deviation_error, 1e-10);
      test::expect_relative(two.mean_error, one.mean_error, 1e-10);
      EXPECT_EQ(two.share, one.share);
    }
  }
  SharedRows share(Share{.part = 1, .parts = 2});
  try {
    (void)scatter_of(gear, sensitivity, {.samples = 3000, .shared = &share, .kept = 1499});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("<= 1499 for each share, because a shard keeps its "
                        "draws; take more shares"),
              std::string::npos);
  }
}

// Kind: identity (SN-8).  A study has the same rows and the same numbers, bit for bit, if its draws
// are kept, drawn again, or read from shares of which one is held at a time.
TEST(Scatter, IdentityRows) {
  GearSet gear = example();
  for (InputScatter& of : gear.scatter)
    if (of.path == "flexspline.wall_thickness") of.relative_standard_deviation = 0.9;
  const Sensitivity sensitivity = sensitivity_of(gear);
  const int samples = test::kSanitized ? 60 : 300;
  const auto with = [&](int kept, SharedRows* shared, test::KeptRows& rows) {
    return scatter_of(gear, sensitivity,
                      {.samples = samples, .shared = shared, .kept = kept, .rows = &rows});
  };
  test::KeptRows kept;
  test::KeptRows passes;
  const Scatter of_kept = with(samples, nullptr, kept);
  const Scatter of_passes = with(samples - 1, nullptr, passes);
  ASSERT_EQ(kept.head.rows, static_cast<std::size_t>(samples));
  EXPECT_EQ(kept.head.columns.size(), gear.scatter.size() + of_kept.outputs.size());
  EXPECT_EQ(kept.head.columns.back().unit, of_kept.outputs.back().unit);
  EXPECT_TRUE(test::same_rows(passes, kept));
  constexpr int kParts = 3;
  SharedRows shares(static_cast<std::size_t>(samples), kParts, [&](int part) {
    SharedRows share(Share{.part = part, .parts = kParts});
    EXPECT_THROW((void)scatter_of(gear, sensitivity,
                                  {.samples = samples, .shared = &share, .kept = samples / 2}),
                 ShareDone);
    return share.bytes();
  });
  test::KeptRows shared;
  const Scatter of_shared = with(samples - 1, &shares, shared);
  EXPECT_TRUE(test::same_rows(shared, kept));
  for (std::size_t y = 0; y < of_passes.outputs.size(); ++y) {
    EXPECT_EQ(of_shared.outputs[y].mean, of_passes.outputs[y].mean);
    EXPECT_EQ(of_shared.outputs[y].median, of_passes.outputs[y].median);
  }
  // The rows give the summary, and a refused one names its rule.  Tolerance: rounding of the sum.
  double sum = 0.0;
  int refused = 0;
  for (std::size_t i = 0; i < kept.rules.size(); ++i) {
    if (kept.rules[i].empty()) {
      sum += kept.numbers[i].back();
    } else {
      ++refused;
      EXPECT_TRUE(std::isnan(kept.numbers[i].back()));
      EXPECT_TRUE(kept.rules[i].starts_with("flexspline.")) << kept.rules[i];
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(refused, of_kept.refused + of_kept.unusable);
  test::expect_relative(sum / of_kept.evaluated, of_kept.outputs.back().mean, 1e-12);
}

// Kind: behaviour.  A study whose draws are all refused has no answer, and its rows say why: those
// of draws that are kept, and those of draws that are made again.
TEST(Scatter, BehaviourRowsOfAStudyWithoutAnAnswer) {
  GearSet gear = example();
  InputScatter wall{.path = "flexspline.wall_thickness", .source = {}};
  wall.distribution = ScatterDistribution::table;
  wall.quantile = {{0.0, 100.0}, {1.0, 200.0}};  // thicker than the drive
  gear.scatter = {wall};
  const Sensitivity sensitivity = sensitivity_of(gear);
  for (const int kept : {1000, 10}) {
    test::KeptRows rows;
    EXPECT_THROW((void)scatter_of(gear, sensitivity, {.samples = 40, .kept = kept, .rows = &rows}),
                 SolverError);
    EXPECT_EQ(rows.numbers.size(), 40U);
    for (std::size_t n = 0; n < rows.numbers.size(); ++n) {
      EXPECT_EQ(rows.status[n], RowStatus::refused);
      EXPECT_TRUE(rows.rules[n].starts_with("flexspline.")) << rows.rules[n];
      EXPECT_GT(rows.numbers[n][0], 0.0);
      EXPECT_TRUE(std::isnan(rows.numbers[n][1]));
    }
  }
}

TEST(Scatter, InputOptions) {
  const GearSet gear = example();
  const Sensitivity sensitivity = sensitivity_of(gear);
  for (const int samples : {1, kMaxSamples + 1})
    EXPECT_THROW((void)scatter_of(gear, sensitivity, {.samples = samples}), InputError);
  EXPECT_THROW((void)scatter_of(gear, sensitivity, {.samples = 10, .threads = -1}), InputError);
  EXPECT_THROW((void)scatter_of(article_gear(), sensitivity_of(article_gear()), {.samples = 10}),
               InputError);
  Sensitivity unusable = sensitivity;
  unusable.unusable_because = "of a test";
  EXPECT_THROW((void)scatter_of(gear, unusable, {.samples = 10}), SolverError);
}

TEST(SensitivityReport, BehaviourFormsAgree) {
  const GearSet gear = example();
  SensitivityReport report{.sensitivity = sensitivity_of(gear), .scatter = {}};
  const std::string plain_csv = sensitivity_csv(report);
  report.scatter = scatter_of(gear, report.sensitivity, {.samples = 50});
  const std::string csv = sensitivity_csv(report);
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  EXPECT_EQ(lines(csv), 1 + static_cast<long>(report.sensitivity.inputs.size() *
                                              report.sensitivity.outputs.size()));
  EXPECT_EQ(lines(plain_csv), lines(csv));
  EXPECT_TRUE(
      csv.starts_with("output,path,unit,value,derivative,derivative_unit,elasticity,"
                      "relative_standard_deviation,share\n"));
  const std::string text = sensitivity_text(report, gear);
  for (const SensitivityInput& input : report.sensitivity.inputs) {
    EXPECT_NE(text.find(input.path), std::string::npos) << input.path;
    EXPECT_NE(csv.find(input.path), std::string::npos) << input.path;
  }
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    EXPECT_LE(end - begin, 100U) << text.substr(begin, end - begin);
    begin = end + 1;
  }
}

TEST(TornadoPlot, BehaviourOnePanelForStiffnessOneForLoss) {
  const GearSet gear = example();
  const std::string cracked = sensitivity_plot({sensitivity_of(gear), {}}, gear);
  EXPECT_NE(cracked.find("Stiffness of the sum"), std::string::npos);
  EXPECT_NE(cracked.find("Loss of stiffness"), std::string::npos);
  EXPECT_NE(cracked.find("flexspline.crack[0].half_length"), std::string::npos);
  EXPECT_EQ(cracked, sensitivity_plot({sensitivity_of(gear), {}}, gear));
  const std::string sound = sensitivity_plot({sensitivity_of(shaft()), {}}, shaft());
  EXPECT_EQ(sound.find("Loss of stiffness"), std::string::npos);
  EXPECT_NE(sound.find("T &gt; 0 and T &lt; 0"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

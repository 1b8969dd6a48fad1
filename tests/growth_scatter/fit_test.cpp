// SPDX-License-Identifier: Apache-2.0
// Likelihood and fit of the scatter of growth, against full covariance matrices.
#include "strainwave/growth_scatter/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_specimens.hpp"
#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

MeanGrowth equal_knots(const GrowthData& data, int number) {
  MeanGrowth mean;
  for (int k = 0; k < number; ++k)
    mean.knots.push_back(data.lowest() + (data.highest() - data.lowest()) * k / (number - 1));
  mean.pivot = (data.lowest() + data.highest()) / 2;
  return mean;
}

ScatterParameters parameters_in(const test::CsvRow& row) {
  const auto& in = row.inputs;
  return {in.at("level"),  in.at("tilt"),       in.at("slope"),
          in.at("wander"), in.at("log_length"), in.at("white")};
}

// Kind: reference (GS-3), (GS-4), (GS-5), (GS-6), (GS-7), tools/reference/growth_scatter.py.  The
// filter against full covariance matrices.  Tolerance: digits of the table.
TEST(GrowthFit, ReferenceLikelihoodOfGivenParameters) {
  const GrowthData data(test::drawn_specimens());
  for (const test::CsvRow& row : test::read_reference_csv("growth_scatter")) {
    if (!row.quantity.starts_with("at_")) continue;
    const GrowthLikelihood found = data.likelihood(
        equal_knots(data, static_cast<int>(row.inputs.at("knots"))), parameters_in(row));
    const double value = row.quantity == "at_likelihood"   ? found.value
                         : row.quantity == "at_first_rate" ? found.rates[0]
                                                           : found.covariance[0];
    test::expect_relative(value, row.value, std::pow(10, 1 - row.digits));
  }
}

// Kind: crosscheck.  The exact slopes against differences of the likelihood.  Tolerance: error of
// the differences.
TEST(GrowthFit, CrosscheckSlopesOfTheLikelihood) {
  const GrowthData data(test::drawn_specimens());
  const MeanGrowth mean = equal_knots(data, 4);
  const std::array<double, 6> at = {0.07, -0.12, 0.2, 0.13, -1.7, 0.09};
  const auto slope = data.slope(mean, ScatterParameters::of(at));
  for (std::size_t k = 0; k < at.size(); ++k) {
    auto low = at;
    auto high = at;
    low[k] -= 1e-5;
    high[k] += 1e-5;
    const double difference = (data.likelihood(mean, ScatterParameters::of(high)).value -
                               data.likelihood(mean, ScatterParameters::of(low)).value) /
                              2e-5;
    EXPECT_NEAR(slope[k], difference, 1e-5 * std::abs(difference) + 1e-4) << k;
  }
}

// Kind: reference (GS-8), tools/reference/growth_scatter.py.  The most likely parameters by
// Newton's method and by a simplex; two of the cases leave parts out, and in one the best level is
// zero. Tolerance: 1e-6 of the likelihood; parameters as flat as the likelihood is about its top.
TEST(GrowthFit, ReferenceMostLikelyParameters) {
  for (const test::CsvRow& row : test::read_reference_csv("growth_scatter")) {
    if (row.quantity != "best_likelihood") continue;
    const ScatterParameters best = parameters_in(row);
    const GrowthFit fit = fit_growth(
        test::drawn_specimens(),
        {.parts = {.level = true, .slope = best.tilt != 0, .correlated = best.wander != 0},
         .knots = static_cast<int>(row.inputs.at("knots"))});
    EXPECT_TRUE(fit.converged) << fit.reason;
    EXPECT_NEAR(fit.log_likelihood, row.value, 1e-5);
    EXPECT_NEAR(fit.parameters.level, best.level, 1e-4);
    EXPECT_NEAR(fit.parameters.tilt, best.tilt, 1e-4);
    EXPECT_NEAR(fit.parameters.wander, best.wander, 1e-4);
    EXPECT_NEAR(fit.parameters.white, best.white, 1e-4);
    if (best.wander != 0) {
      EXPECT_NEAR(fit.parameters.log_length, best.log_length, 1e-3);
    }
  }
}

// Kind: reference (GS-8).  Scatter of the level and of single steps alone is a balanced one-way
// layout, whose likelihood has its top in closed form: with n equal steps, s2 = SSW/(k (n - 1)) and
// level^2 = SSB/(k n) - s2/n.  The errors follow from the curvature there.
TEST(GrowthFit, ReferenceBalancedLayout) {
  constexpr std::size_t kSpecimens = 6;
  constexpr std::size_t kSteps = 10;
  std::vector<GrowthSpecimen> specimens;
  std::vector<std::vector<double>> rates;
  for (std::size_t s = 0; s < kSpecimens; ++s) {
    GrowthSpecimen specimen{.name = "s", .sizes = {0.001}, .cycles = {0.0}, .ranges = {}};
    std::vector<double>& of_specimen = rates.emplace_back();
    for (std::size_t i = 0; i < kSteps; ++i) {
      const auto u = static_cast<double>((7 * i + 3 * s * s) % 11) / 11 - 0.5;
      const double deviation = 0.2 * std::cos(2.4 * static_cast<double>(s * s)) + 0.3 * u;
      specimen.sizes.push_back(specimen.sizes.back() + 1e-3);
      specimen.cycles.push_back(specimen.cycles.back() + 1e-3 / (1e-8 * std::exp(deviation)));
      specimen.ranges.push_back(i % 2 == 0 ? 1e7 : 2e7);
      of_specimen.push_back(deviation);
    }
    specimens.push_back(std::move(specimen));
  }
  const GrowthFit fit =
      fit_growth(specimens, {.parts = {.slope = false, .correlated = false}, .knots = 2});
  // With two ranges the law is free at both, so each has its own mean.
  double mean[2] = {0, 0};
  for (const auto& r : rates)
    for (std::size_t i = 0; i < kSteps; ++i) mean[i % 2] += r[i] / (kSpecimens * kSteps / 2.0);
  double between = 0.0;
  double within = 0.0;
  for (const auto& r : rates) {
    double own = 0.0;
    for (std::size_t i = 0; i < kSteps; ++i) own += (r[i] - mean[i % 2]) / kSteps;
    between += kSteps * own * own;
    for (std::size_t i = 0; i < kSteps; ++i) within += std::pow(r[i] - mean[i % 2] - own, 2);
  }
  const double white = std::sqrt(within / (kSpecimens * (kSteps - 1)));
  const double level = std::sqrt(between / (kSpecimens * kSteps) - white * white / kSteps);
  EXPECT_TRUE(fit.converged);
  test::expect_relative(fit.parameters.white, white, 1e-5);
  test::expect_relative(fit.parameters.level, level, 1e-5);
  // The information of the two variances of the layout, carried over to the deviations.
  const double total = white * white + kSteps * level * level;
  const double i_ll = kSpecimens * kSteps * kSteps / (2 * total * total) * 4 * level * level;
  const double i_lw = kSpecimens * kSteps / (2 * total * total) * 4 * level * white;
  const double i_ww =
      (kSpecimens / (2 * total * total) + kSpecimens * (kSteps - 1) / (2 * std::pow(white, 4))) *
      4 * white * white;
  const double determinant = i_ll * i_ww - i_lw * i_lw;
  test::expect_relative(*fit.errors[0], std::sqrt(i_ww / determinant), 1e-3);
  test::expect_relative(*fit.errors[5], std::sqrt(i_ll / determinant), 1e-3);
}

// Kind: behaviour (GS-8).  A search that begins at a saddle, where deviations of 0 leave the slope
// 0, finds the maximum all the same.
TEST(GrowthFit, BehaviourASaddleIsLeft) {
  const GrowthFit straight = fit_growth(test::drawn_specimens(), {.parts = {}, .knots = 2});
  const GrowthFit from_saddle = fit_growth(
      test::drawn_specimens(),
      {.parts = {}, .knots = 2, .start = ScatterParameters{.level = 0.05, .white = 0.14}});
  EXPECT_TRUE(from_saddle.converged);
  EXPECT_NEAR(from_saddle.log_likelihood, straight.log_likelihood, 1e-5);
}

// Kind: behaviour (GS-8).  If steps deviate in turn, nothing is correlated: the length of that part
// has no error, because it does not matter, and the white part has one.
TEST(GrowthFit, BehaviourAPartThatVanishes) {
  std::vector<GrowthSpecimen> specimens;
  for (std::size_t s = 0; s < 4; ++s) {
    GrowthSpecimen specimen{.name = "s", .sizes = {0.01}, .cycles = {0.0}, .ranges = {}};
    for (std::size_t i = 0; i < 30; ++i) {
      const double deviation =
          (i % 2 == 0 ? 0.2 : -0.2) * (1 + 0.3 * std::cos(1.7 * static_cast<double>(i + 9 * s)));
      specimen.sizes.push_back(specimen.sizes.back() + 1e-3);
      specimen.cycles.push_back(specimen.cycles.back() + 1e-3 / (1e-8 * std::exp(deviation)));
      specimen.ranges.push_back(1e7 * std::exp(0.02 * static_cast<double>(i)));
    }
    specimens.push_back(std::move(specimen));
  }
  const GrowthFit fit =
      fit_growth(specimens, {.parts = {.level = false, .slope = false}, .knots = 2});
  EXPECT_TRUE(fit.converged) << fit.reason;
  EXPECT_NEAR(fit.parameters.wander, 0, 1e-4);
  EXPECT_FALSE(fit.errors[4]);
  ASSERT_TRUE(fit.errors[5]);
  // Of a deviation alone: sigma/sqrt(2 n), n = 120 steps.
  test::expect_relative(*fit.errors[5], fit.parameters.white / std::sqrt(240), 1e-2);
}

// Kind: behaviour (GS-9).  The number of knots with the least criterion is taken.
TEST(GrowthFit, BehaviourKnotsByTheCriterion) {
  const GrowthFit fit = fit_growth(test::drawn_specimens());
  ASSERT_EQ(fit.trials.size(), 7U);
  for (const KnotTrial& trial : fit.trials) {
    EXPECT_NEAR(trial.criterion, (trial.knots + 6) * std::log(640.0) - 2 * trial.log_likelihood,
                1e-9);
    EXPECT_GE(trial.criterion, fit.trials.front().criterion);
  }
  // The specimens were drawn about a law of Paris, so two knots are enough.
  EXPECT_EQ(fit.mean.knots.size(), 2U);
  // The law of the drawing, within four standard errors.
  EXPECT_NEAR(fit.mean.log_rate(fit.mean.pivot), std::log(8e-11) + 3.1 * fit.mean.pivot, 0.08);
}

// Kind: behaviour.  Records of different lengths are fitted together, in any order.  Tolerance:
// rounding.
TEST(GrowthFit, BehaviourSeveralDesigns) {
  std::vector<GrowthSpecimen> specimens = test::drawn_specimens();
  const auto shortened = [](const GrowthSpecimen& s) {
    return specimen_of(s.name, {s.sizes.begin(), s.sizes.begin() + 21},
                       {s.cycles.begin(), s.cycles.begin() + 21},
                       PlateTest{.stress_range = 60e6, .width = 0.1});
  };
  for (std::size_t k = 0; k < 5; ++k) specimens[k] = shortened(specimens[k]);
  const GrowthData all(specimens);
  EXPECT_EQ(all.steps(), 5U * 20 + 11U * 40);
  const MeanGrowth mean = equal_knots(all, 3);
  const ScatterParameters p{0.08, 0.1, 0.15, 0.15, -2.5, 0.08};
  // In another order the designs are met in another order.
  std::vector<GrowthSpecimen> turned(specimens.rbegin(), specimens.rend());
  test::expect_relative(all.likelihood(mean, p).value, GrowthData(turned).likelihood(mean, p).value,
                        1e-12);
  EXPECT_TRUE(fit_growth(specimens, {.parts = {}, .knots = 2}).converged);
}

// Kind: input.  Every rule, broken once.
TEST(GrowthFit, InputWhatCannotBeFitted) {
  const std::vector<GrowthSpecimen> all = test::drawn_specimens();
  const auto says = [&](const std::vector<GrowthSpecimen>& specimens, const ScatterParts& parts,
                        std::optional<int> knots, const char* words) {
    try {
      (void)fit_growth(specimens, {.parts = parts, .knots = knots});
      FAIL() << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  says({}, {}, 2, "at least one");
  says(all, {.correlated = false, .white = false}, 2, "neither correlated nor white");
  says(all, {.level = false}, 2, "slope without level");
  says(all, {}, 1, "must be from 2 to 12");
  says(all, {}, 13, "must be from 2 to 12");
  says({all[0]}, {}, 2, "one specimen cannot tell");
  const GrowthSpecimen three = specimen_of("three", {0.01, 0.02, 0.03, 0.04}, {0, 9, 16, 20},
                                           PlateTest{.stress_range = 1e8});
  says({three}, {.level = false, .slope = false}, 2, "3 steps for 5 constants");
  const GrowthSpecimen flat =
      specimen_of("flat", {0.01, 0.02, 0.03}, {0, 9, 16}, std::vector<double>(3, 1e7));
  says({flat, flat}, {}, 2, "one range");
  const GrowthData data(all);
  EXPECT_THROW((void)data.likelihood(equal_knots(data, 2), {.log_length = -2.0}), SolverError);
}

}  // namespace
}  // namespace strainwave

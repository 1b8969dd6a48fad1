// SPDX-License-Identifier: Apache-2.0 Sobol's indices and reliability of a drive whose inputs
// scatter, and the fast evaluation on which both rest.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/reliability.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/study/reliability_report.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sobol_report.hpp"
#include "strainwave/study/varied_series.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"
#include "support/random_drive.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

GearSet uncertain_example() {
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/article_scatter.toml");
}

/// A drive that is a sound shaft alone, whose stiffness is G times a constant.
GearSet shaft_alone(ScatterDistribution distribution, double deviation) {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  gear.output_shaft->crack.clear();
  gear.scatter = {{.path = "material.steel.shear_modulus",
                   .relative_standard_deviation = deviation,
                   .distribution = distribution,
                   .source = {}}};
  return gear;
}

double stiffness_of(const GearSet& gear) {
  return evaluate(gear, Method::corrected).intact.stiffness.value;
}

ReliabilityReport reliability(const GearSet& gear, const std::string& text,
                              const ReliabilitySettings& settings = {}) {
  return reliability_of(gear, requirements_on(gear, {text}), settings);
}

/// The plain draws that are usual; a tenth of them under the sanitizers.
constexpr ReliabilitySettings kUsualDraws = {.draws = test::kSanitized ? std::optional(20000)
                                                                       : std::nullopt};

// --- Fast evaluation
// ------------------------------------------------------------------------------

// Kind: cross-check.  Source: `evaluate`.  Without tables the same bits, with tables 1e-10; the
// same rows are refused.
TEST(VariedSeries, CrosscheckWithEvaluate) {
  const GearSet gear = uncertain_example();
  const std::vector<std::string> paths = {
      "output_shaft.crack[0].depth", "flexspline.crack[0].half_length",
      "wave_generator.radial_stiffness", "material.steel.youngs_modulus"};
  std::vector<std::string> names;
  for (const SeriesOutput& output : series_outputs())
    if (!output.name.ends_with("_loss")) names.emplace_back(output.name);
  const auto fill = [](std::size_t row, std::span<double> values) {
    test::Dice dice(row);
    values[0] = dice.uniform(-0.2e-3, 14e-3);  // from refused to refused, and beyond the table
    values[1] = dice.log_uniform(1e-4, 2e-2);
    values[2] = dice.uniform(0.8e8, 1.6e8);
    values[3] = dice.uniform(200e9, 220e9);
  };
  VariedSeries varied(gear, paths, names);
  VariedSeries::Evaluator by_engine(varied);
  varied.prepare(1'000'000'000, fill);
  VariedSeries::Evaluator by_tables(varied);
  std::array<int, 3> fates{};
  for (std::size_t row = 0; row < 400; ++row) {
    std::vector<double> values(paths.size());
    fill(row, values);
    GearSet one = gear;
    one.scatter.clear();
    for (std::size_t i = 0; i < paths.size(); ++i) set_number(one, paths[i], values[i]);
    Fate expected = Fate::evaluated;
    std::vector<double> exact(names.size());
    try {
      const StiffnessResult result =
          evaluate(one, Method::corrected, {.coupled_drive = false, .life = false});
      if (!result.usable()) expected = Fate::unusable;
      for (std::size_t y = 0; y < names.size(); ++y)
        exact[y] = output_named(result, names[y])->value;
    } catch (const InputError&) {
      expected = Fate::refused;
    }
    ++fates[static_cast<std::size_t>(expected)];
    std::vector<double> fast(names.size());
    std::vector<double> same(names.size());
    EXPECT_EQ(by_tables(values, fast), expected) << row;
    EXPECT_EQ(by_engine(values, same), expected) << row;
    if (expected == Fate::refused) continue;
    EXPECT_EQ(same, exact) << row;
    for (std::size_t y = 0; y < names.size(); ++y) test::expect_relative(fast[y], exact[y], 1e-10);
  }
  for (const int count : fates) EXPECT_GT(count, 10);
}

TEST(VariedSeries, BehaviourCoversTheSumAndStrengthMargins) {
  const auto covers = [](const std::string& name) {
    return VariedSeries::covers(std::vector{std::string("intact.stiffness"), name});
  };
  EXPECT_TRUE(covers("cracked.negative.wind_up"));
  EXPECT_TRUE(covers("flexspline.crack[0].strength.reserve"));
  EXPECT_TRUE(covers("flexspline.crack[0].strength.ligament"));
  EXPECT_FALSE(covers("flexspline.crack[0].strength.critical_size"));
  EXPECT_FALSE(covers("flexspline.crack[0].strength.brittle_size"));
  EXPECT_FALSE(covers("flexspline.crack[0].strength.toughness"));  // a detail is no output
  EXPECT_FALSE(covers("flexspline.crack[0].strength.verdict"));
  EXPECT_FALSE(covers("curve.positive.K1"));
  EXPECT_FALSE(covers("intact.stifness"));
  EXPECT_FALSE(VariedSeries::of_sum(std::vector<std::string>{"flexspline.crack[0].strength.K"}));
}

// Kind: cross-check (ST-22).  Source: the engine at ten thousand random rows.  The stated error is
// that of a thousand of them, so the largest of all is not far from it; both keep the contract of
// 1e-10.
TEST(VariedSeries, CrosscheckStatedErrorOfTheTables) {
  const GearSet gear = uncertain_example();
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth",
                                          "flexspline.crack[0].half_length",
                                          "flexspline.crack[0].angle"};
  const std::vector<std::string> names = {"cracked.positive.stiffness_loss"};
  const auto fill = [](std::size_t row, std::span<double> values) {
    test::Dice dice(row);
    values[0] = dice.log_uniform(0.02e-3, 5e-3);
    values[1] = dice.log_uniform(0.02e-3, 5e-3);
    values[2] = dice.uniform(0.6, 0.9);
  };
  VariedSeries varied(gear, paths, names);
  constexpr std::size_t kRows = 1'000'000;
  EXPECT_FALSE(varied.table_evidence(kRows, fill)) << "there are no tables yet";
  varied.prepare(kRows, fill);
  const auto evidence = varied.table_evidence(kRows, fill);
  ASSERT_TRUE(evidence);
  EXPECT_EQ(evidence->cracks, 3);
  EXPECT_EQ(evidence->points, static_cast<int>(VariedSeries::kEvidencePoints));
  EXPECT_EQ(varied.table_evidence(kRows, fill)->largest_error, evidence->largest_error);
  VariedSeries::Evaluator by_tables(varied);
  VariedSeries::Evaluator by_engine(varied, false);
  double largest = 0.0;
  std::vector<double> values(paths.size());
  for (std::size_t row = 0; row < (test::kSanitized ? 200 : 10'000); ++row) {
    fill(row, values);
    double read = 0.0;
    double exact = 0.0;
    ASSERT_EQ(by_tables(values, {&read, 1}), Fate::evaluated);
    ASSERT_EQ(by_engine(values, {&exact, 1}), Fate::evaluated);
    largest = std::max(largest, std::abs(read / exact - 1));
  }
  EXPECT_LT(largest, 1e-10);
  EXPECT_GT(evidence->largest_error, 0.0);
  EXPECT_LT(evidence->largest_error, 1e-10);
  if (!test::kSanitized) {
    EXPECT_GT(evidence->largest_error, largest / 100);
  }
  // A note rounds the error up to a power of ten.
  const TableEvidence two{.cracks = 2, .points = 1000, .largest_error = 3.1e-12};
  EXPECT_EQ(
      strainwave::note_of(two).text,
      "the compliances of 2 cracks are read from tables that the engine filled; at 1000 random "
      "drives of this study the outputs differ from the engine by less than 1e-11 of their "
      "value");
  const TableEvidence bad{.cracks = 1, .points = 9, .largest_error = 2e-10};
  EXPECT_EQ(strainwave::note_of(bad).severity, Severity::care);
}

// Kind: behaviour (ST-22).  A study that reads tables says how far they are from the engine, in a
// number and a note; a short one takes the engine and says nothing.
TEST(VariedSeries, BehaviourStudiesStateTheErrorOfTheirTables) {
  const GearSet gear = uncertain_example();
  const auto has_note = [](const std::vector<Note>& notes) {
    return std::ranges::find(notes, "tables.error", &Note::code) != notes.end();
  };
  const Sensitivity sensitivity = sensitivity_of(gear);
  const Scatter few = scatter_of(gear, sensitivity, {.samples = 20});
  EXPECT_FALSE(few.tables || has_note(few.notes));
  if (test::kSanitized) return;
  const Scatter many = scatter_of(gear, sensitivity, {.samples = 100'000});
  ASSERT_TRUE(many.tables && has_note(many.notes));
  EXPECT_GE(many.tables->cracks, 1);
  EXPECT_LT(many.tables->largest_error, 1e-10);
  const Sobol sobol = sobol_of(gear, {.points = 16384});
  ASSERT_TRUE(sobol.tables && has_note(sobol.notes));
  EXPECT_LT(sobol.tables->largest_error, 1e-10);
  const ReliabilityReport safe = reliability(gear, "cracked.positive.stiffness >= 5.9e5 N*m/rad");
  ASSERT_TRUE(safe.answers[0].tables && has_note(safe.notes));
  EXPECT_LT(safe.answers[0].tables->largest_error, 1e-10);
}

// Kind: cross-check (UQ-6).  Source: the law of the toughness.  K/K_Ic exceeds 1/0.8 of its value
// if K_Ic falls below 0.8 of its own, which is 2 deviations of 10 % away: Phi(-2) = 0.02275.
// Tolerance: 4 standard errors of the draws.
TEST(Reliability, CrosscheckUtilisationOfACrack) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/critical_crack.toml");
  gear.scatter = {{.path = "material.shaft_steel.fracture_toughness",
                   .relative_standard_deviation = 0.1,
                   .distribution = ScatterDistribution::normal,
                   .source = {}}};
  const std::string name = "output_shaft.crack[0].strength.utilisation";
  const double at_file = output_named(evaluate(gear, Method::corrected), name)->value;
  const ReliabilityReport report =
      reliability(gear, fmt::format("{} <= {:.15g}", name, at_file / 0.8),
                  {.draws = test::kSanitized ? 500 : 20'000});
  const RequirementReliability& answer = report.answers[0];
  EXPECT_EQ(answer.monte_carlo.without_value, 0);
  const double expected = normal_probability(-2);
  EXPECT_NEAR(answer.monte_carlo.probability, expected,
              4 * std::sqrt(expected / answer.monte_carlo.draws));
  test::expect_relative(answer.first_order.probability, expected, 1e-4);
  EXPECT_FALSE(answer.tables.has_value()) << "the engine computes margins";
}

// --- Distributions
// --------------------------------------------------------------------------------

// Kind: reference.  Mean and deviation of the drawn stiffness, which is proportional to the input.
// Tolerance: four standard errors of 65536 points, or of 8192 under the sanitizers.
TEST(ScatterLaw, ReferenceMeanAndDeviationOfEachDistribution) {
  constexpr int kPoints = test::kSanitized ? 1 << 13 : 1 << 16;
  constexpr double kWider = test::kSanitized ? 2.8 : 1.0;  // the root of the ratio of points
  for (const double s : {0.02, 0.3}) {
    for (const auto distribution : {ScatterDistribution::lognormal, ScatterDistribution::normal,
                                    ScatterDistribution::uniform, ScatterDistribution::weibull}) {
      const GearSet gear = shaft_alone(distribution, s);
      const Sobol sobol = sobol_of(gear, {.points = kPoints, .outputs = {"intact.stiffness"}});
      const SobolAnswer& answer = sobol.outputs[0];
      const bool lognormal = distribution == ScatterDistribution::lognormal;
      const double mean = lognormal ? std::sqrt(1 + s * s) : 1.0;  // the file has the median
      // Normal deviates below -3.3 of s = 0.3 would make a negative modulus.
      const double tolerance =
          kWider * (distribution == ScatterDistribution::normal && s > 0.2 ? 0.02 : 5e-3);
      test::expect_relative(answer.mean, mean * answer.value, tolerance * s);
      test::expect_relative(answer.deviation, mean * s * answer.value, tolerance);
      EXPECT_NEAR(answer.inputs[0].first.value, 1, 0.01 * kWider);
      EXPECT_NEAR(answer.inputs[0].total.value, 1, 0.01 * kWider);
    }
  }
}

// Kind: reference.  Ratios of a Weibull quantile to its mean far below, by 30 digits of gamma and
// of the error function; the stiffness is proportional to the input.  Tolerance: that of the
// search.
TEST(ScatterLaw, ReferenceLowTailOfAWeibullDistribution) {
  const GearSet gear = shaft_alone(ScatterDistribution::weibull, 0.05);
  const double value = stiffness_of(gear);
  for (const auto& [below, ratio] : {std::pair{6.5, 0.391560774964726867},
                                     {7.0, 0.341045851342311101},
                                     {7.5, 0.294140146260503501}}) {
    const std::string text = fmt::format("intact.stiffness >= {:.17g} N*m/rad", ratio * value);
    const auto answer = reliability_of(gear, requirements_on(gear, {text}), {.draws = 100});
    const FirstOrderReliability& first = answer.answers.at(0).first_order;
    ASSERT_TRUE(first.converged) << first.reason;
    EXPECT_NEAR(first.reliability_index, below, 1e-6);
  }
}

// Kind: behaviour (UQ-4).  The text says on which side of the limit the design point is.
TEST(ReliabilityText, BehaviourTheDesignPointOfADriveThatFails) {
  const GearSet gear = shaft_alone(ScatterDistribution::lognormal, 0.05);
  for (const auto& [ratio, says] : {std::pair{0.9, "at which the requirement fails"},
                                    std::pair{1.1, "at which the requirement is met"}}) {
    const std::string text =
        fmt::format("intact.stiffness >= {:.17g} N*m/rad", ratio * stiffness_of(gear));
    EXPECT_NE(reliability_text(reliability(gear, text, {.draws = 200}), gear).find(says),
              std::string::npos);
  }
}

// Kind: reference.  A table of two pieces: moments of the drawn stiffness in closed form.  The
// quantiles are 0.8 at 0, 1 at 0.5 and 1.6 at 1: mean 1.1, variance
// 0.5 (0.3^2 + 0.3*0.1 + 0.1^2 + 0.1^2 - 0.1*0.5 + 0.5^2)/3 = 0.0566667.
// Tolerance: four standard errors of 65536 points of Sobol's sequence, less than 1e-3.
TEST(ScatterLaw, ReferenceTableOfQuantiles) {
  GearSet gear = shaft_alone(ScatterDistribution::table, 0.1);
  InputScatter& input = gear.scatter[0];
  input.relative_standard_deviation.reset();
  input.quantile = {{0.0, 0.8}, {0.5, 1.0}, {1.0, 1.6}};
  const Sobol sobol = sobol_of(gear, {.points = 1 << 16, .outputs = {"intact.stiffness"}});
  const SobolAnswer& answer = sobol.outputs[0];
  test::expect_relative(answer.mean, 1.1 * answer.value, 1e-3);
  test::expect_relative(answer.deviation, std::sqrt(0.17 / 3) * answer.value, 1e-3);
  const Scatter scatter = scatter_of(gear, sensitivity_of(gear), {.samples = 20000});
  test::expect_relative(scatter.inputs[0].relative_standard_deviation, std::sqrt(0.17 / 3), 1e-14);
  test::expect_relative(scatter.outputs[0].first_order, std::sqrt(0.17 / 3), 1e-12);
  test::expect_relative(scatter.outputs[0].low, 0.82 * answer.value, 1e-2);
  test::expect_relative(scatter.outputs[0].median, 1.0 * answer.value, 1e-2);
  test::expect_relative(scatter.outputs[0].high, 1.54 * answer.value, 1e-2);
  const double probability =
      *reliability_of(gear, requirements_on(gear, {fmt::format("intact.stiffness >= {} N*m/rad",
                                                               0.88 * answer.value)}))
           .answers[0]
           .probability;
  EXPECT_NEAR(probability, 0.2, 4e-3);
}

// --- Correlation
// ----------------------------------------------------------------------------------

/// A sound shaft whose stiffness is G/L times a constant, with lognormal G and L.
GearSet shaft_of_two(double rank) {
  GearSet gear = shaft_alone(ScatterDistribution::lognormal, 0.1);
  gear.scatter.push_back(
      {.path = "output_shaft.length", .relative_standard_deviation = 0.2, .source = {}});
  gear.correlation = {{.path = "output_shaft.length",
                       .with = "material.steel.shear_modulus",
                       .rank_correlation = rank,
                       .source = {}}};
  return gear;
}

// Kind: reference.  ln K = ln G - ln L is normal, so deviation, probability and shares have closed
// forms.  Tolerances: four standard errors of the draws; 1e-5 of the design point.
TEST(Correlation, ReferenceOfAShaft) {
  for (const double rank : {0.7, -0.4}) {
    const GearSet gear = shaft_of_two(rank);
    const double r = 2 * std::sin(std::numbers::pi * rank / 6);
    const Scatter scatter = scatter_of(gear, sensitivity_of(gear));
    const ScatterOutput& K = scatter.outputs[0];
    const double first = 0.01 + 0.04 - 2 * r * 0.02;
    test::expect_relative(K.first_order, std::sqrt(first), 1e-12);
    EXPECT_NEAR(K.share[0], (0.01 - r * 0.02) / first, 1e-12);
    EXPECT_NEAR(K.share[1], (0.04 - r * 0.02) / first, 1e-12);
    const double s_G = std::sqrt(std::log1p(0.01));
    const double s_L = std::sqrt(std::log1p(0.04));
    const double sigma = std::sqrt(s_G * s_G + s_L * s_L - 2 * r * s_G * s_L);
    EXPECT_NEAR(K.relative_deviation, std::sqrt(std::expm1(sigma * sigma)),
                4 * K.relative_deviation_error);
    EXPECT_EQ(test::count_notes(scatter.notes, "scatter.correlated"), 1);
    EXPECT_EQ(test::count_notes(scatter.notes, "scatter.independent"), 0);

    const double beta = 2.5;
    const ReliabilityReport report = reliability(
        gear,
        fmt::format("intact.stiffness >= {:.17g} N*m/rad", K.value * std::exp(-beta * sigma)));
    const FirstOrderReliability& point = report.answers[0].first_order;
    test::expect_relative(point.reliability_index, beta, 1e-5);
    test::expect_relative(*report.answers[0].probability, normal_probability(-beta), 0.1);
    for (const DesignPointInput& input : point.inputs) {
      const bool modulus = input.path == "material.steel.shear_modulus";
      const double own = modulus ? s_G : s_L;
      const double other = modulus ? s_L : s_G;
      EXPECT_NEAR(input.importance, own * (own - r * other) / (sigma * sigma), 1e-5);
      // The most likely point: E[z | failure plane].
      EXPECT_NEAR(input.deviations, (modulus ? -beta : beta) * (own - r * other) / sigma, 1e-4);
      test::expect_relative(input.at_design / input.value, std::exp(own * input.deviations), 1e-9);
    }
    EXPECT_EQ(test::note_codes(report.notes),
              std::vector<std::string>{"reliability.scatter_alone"});
    EXPECT_NE(report.notes[0].text.find("with the rank correlations"), std::string::npos);
  }
}

// Kind: behaviour.  Inputs that depend on each other have one share together, and their shares with
// an independent input add up to 1 for a product.
TEST(Correlation, BehaviourSobolGivesGroupsOneShare) {
  GearSet gear = uncertain_example();
  gear.correlation = {{.path = "material.steel.youngs_modulus",
                       .with = "material.steel.shear_modulus",
                       .rank_correlation = 0.9,
                       .source = {}}};
  const Sobol sobol = sobol_of(gear, {.points = 1024});
  for (const SobolAnswer& answer : sobol.outputs) {
    EXPECT_EQ(answer.inputs.size(), gear.scatter.size() - 1);
    EXPECT_EQ(std::ranges::count(answer.inputs,
                                 "material.steel.youngs_modulus, material.steel.shear_modulus",
                                 &SobolInput::path),
              1);
  }
  EXPECT_EQ(test::count_notes(sobol.notes, "sobol.groups"), 1);
  EXPECT_EQ(test::count_notes(sobol.notes, "sobol.independent"), 0);
}

// --- Sobol's indices
// ------------------------------------------------------------------------------

// Kind: cross-check.  Source: the first-order shares (SN-7), which agree where inputs scatter by a
// per cent.  Tolerance: 3 % of the variance.
TEST(Sobol, CrosscheckWithFirstOrderShares) {
  GearSet gear = uncertain_example();
  for (InputScatter& scatter : gear.scatter) scatter.relative_standard_deviation = 0.01;
  const Sensitivity sensitivity = sensitivity_of(gear);
  const Scatter scatter = scatter_of(gear, sensitivity, {.samples = 1000});
  const Sobol sobol = sobol_of(gear, {.seed = 7});
  EXPECT_EQ(sobol.evaluations, 4096 * (static_cast<int>(gear.scatter.size()) + 2));
  EXPECT_EQ(sobol.left_out, 0);
  ASSERT_EQ(sobol.outputs.size(), 5U);
  for (const SobolAnswer& answer : sobol.outputs) {
    const auto of = std::ranges::find(scatter.outputs, answer.name, &ScatterOutput::name);
    ASSERT_NE(of, scatter.outputs.end());
    EXPECT_EQ(answer.value, of->value);
    EXPECT_EQ(answer.unit, of->unit);
    EXPECT_NEAR(answer.first_sum.value, 1, 0.03);
    double last = 2.0;
    for (const SobolInput& input : answer.inputs) {
      const auto at = std::ranges::find(gear.scatter, input.path, &InputScatter::path);
      const double share = of->share[static_cast<std::size_t>(at - gear.scatter.begin())];
      EXPECT_NEAR(input.first.value, share, 0.03) << input.path;
      EXPECT_NEAR(input.total.value, share, 0.03) << input.path;
      EXPECT_LE(input.total.value, last);
      last = input.total.value;
    }
  }
}

TEST(Sobol, BehaviourOutputsOfTheCoupledDrive) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  gear.scatter = {{.path = "mesh.flank_angle", .relative_standard_deviation = 0.02, .source = {}},
                  {.path = "load.axial_force", .relative_standard_deviation = 0.02, .source = {}}};
  gear.load.axial_force = 1.0;
  const Sobol sobol = sobol_of(gear, {.points = 32, .outputs = {"curve.positive.K1"}});
  EXPECT_EQ(sobol.outputs[0].inputs[0].path, "mesh.flank_angle");
  EXPECT_GT(sobol.outputs[0].inputs[0].total.value, 0.9);
  EXPECT_LT(sobol.outputs[0].inputs[1].total.value, 1e-6);
}

TEST(Sobol, BehaviourDrivesThatBreakARuleAreLeftOut) {
  GearSet gear = uncertain_example();
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 11e-3;  // of a wall of 12.5 mm
  const Sobol sobol = sobol_of(gear);
  EXPECT_GT(sobol.left_out, 100);
  EXPECT_EQ(test::count_notes(sobol.notes, "sobol.left_out"), 1);
  EXPECT_EQ(test::count_notes(sobol.notes, "sobol.independent"), 1);
}

/// The shares of one output from the rows of a study, by (UQ-2) and (UQ-3) written anew.
struct SharesOfRows {
  std::vector<double> first;  ///< of each group
  std::vector<double> total;
  int left_out = 0;
};

SharesOfRows shares_of_rows(const test::KeptRows& rows, std::size_t groups,
                            std::string_view output) {
  const std::size_t sets = groups + 2;
  const std::size_t points = rows.numbers.size() / sets;
  const std::size_t size = points / kSobolReplicates;
  SharesOfRows shares{.first = std::vector<double>(groups), .total = std::vector<double>(groups)};
  for (std::size_t r = 0; r < kSobolReplicates; ++r) {
    std::vector<std::vector<double>> y(sets);  // of the base points that count
    for (std::size_t n = r * size; n < (r + 1) * size; ++n) {
      const auto begin = rows.status.begin() + static_cast<std::ptrdiff_t>(n * sets);
      if (std::any_of(begin, begin + static_cast<std::ptrdiff_t>(sets),
                      [](RowStatus status) { return status != RowStatus::usable; })) {
        ++shares.left_out;
        continue;
      }
      for (std::size_t s = 0; s < sets; ++s) y[s].push_back(rows.at(n * sets + s, output));
    }
    const auto count = static_cast<double>(y[0].size());
    double mean = 0.0;
    for (std::size_t n = 0; n < y[0].size(); ++n) mean += (y[0][n] + y[1][n]) / (2 * count);
    double variance = 0.0;
    for (std::size_t n = 0; n < y[0].size(); ++n)
      variance += (std::pow(y[0][n] - mean, 2) + std::pow(y[1][n] - mean, 2)) / (2 * count);
    for (std::size_t g = 0; g < groups; ++g)
      for (std::size_t n = 0; n < y[0].size(); ++n) {
        const double scale = count * variance * kSobolReplicates;
        shares.first[g] += (y[1][n] - mean) * (y[2 + g][n] - y[0][n]) / scale;
        shares.total[g] += std::pow(y[0][n] - y[2 + g][n], 2) / (2 * scale);
      }
  }
  return shares;
}

// Kind: cross-check (UQ-2), (UQ-3).  The rows of a study are its points: they give its shares,
// computed anew, with and without correlated inputs, and a row has the outputs of `evaluate` at its
// inputs.  Points that differ in one group differ in its inputs alone.  A refused row names its
// rule; the other rows of its base point have outputs, but the study leaves them out.
// Tolerance: 1e-9 of the sums; 1e-10 of the tables.
TEST(Sobol, CrosscheckRowsGiveTheShares) {
  for (const bool correlated : {false, true}) {
    GearSet gear = uncertain_example();
    gear.scatter.resize(4);
    gear.scatter.push_back(uncertain_example().scatter.back());
    ASSERT_EQ(gear.scatter.back().path, "output_shaft.crack[0].depth");
    std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 8e-3;  // of a wall of 12.5 mm
    if (correlated)
      gear.correlation = {{.path = gear.scatter[0].path,
                           .with = gear.scatter[1].path,
                           .rank_correlation = 0.6,
                           .source = {}}};
    const std::size_t groups = correlated ? 4 : 5;
    const std::string output = "cracked.positive.stiffness";
    test::KeptRows rows;
    const SobolSettings settings{.points = test::kSanitized ? 160 : 1600,
                                 .seed = 3,
                                 .threads = 1,
                                 .outputs = {"intact.stiffness", output},
                                 .rows = &rows};
    const Sobol sobol = sobol_of(gear, settings);
    ASSERT_EQ(rows.head.rows, static_cast<std::size_t>(sobol.evaluations));
    ASSERT_EQ(rows.numbers.size(), rows.head.rows);
    EXPECT_EQ(rows.head.seed, 3U);
    const SharesOfRows shares = shares_of_rows(rows, groups, output);
    EXPECT_EQ(shares.left_out, sobol.left_out);
    EXPECT_GT(sobol.left_out, 3);
    std::vector<double> totals = shares.total;
    std::ranges::sort(totals, std::ranges::greater{});
    std::vector<double> stated;
    double first = 0.0;
    for (const SobolInput& input : sobol.outputs[1].inputs) stated.push_back(input.total.value);
    for (const double share : shares.first) first += share;
    ASSERT_EQ(stated.size(), groups);
    for (std::size_t g = 0; g < groups; ++g) EXPECT_NEAR(stated[g], totals[g], 1e-9);
    EXPECT_NEAR(sobol.outputs[1].first_sum.value, first, 1e-9);

    int refused = 0;
    int beside = 0;  // usable rows of base points that are left out
    for (std::size_t n = 0; n < rows.numbers.size(); ++n) {
      ASSERT_EQ(rows.at(n, "base_point"), static_cast<double>(n / (groups + 2)));
      ASSERT_EQ(rows.at(n, "set"), static_cast<double>(n % (groups + 2)));
      const std::size_t base = n / (groups + 2) * (groups + 2);
      if (rows.status[n] == RowStatus::refused) {
        ++refused;
        EXPECT_EQ(rows.rules[n].substr(0, 27), "output_shaft.crack[0].depth");
        EXPECT_TRUE(std::isnan(rows.at(n, output)));
        EXPECT_GT(rows.at(n, "output_shaft.crack[0].depth"), 12e-3);
        continue;
      }
      const bool whole =
          std::count(rows.status.begin() + static_cast<std::ptrdiff_t>(base),
                     rows.status.begin() + static_cast<std::ptrdiff_t>(base + groups + 2),
                     RowStatus::usable) == static_cast<std::ptrdiff_t>(groups + 2);
      if (rows.status[n] == RowStatus::usable && !whole) ++beside;
      if (n % 97 != 0 && whole) continue;
      GearSet one = gear;
      for (const InputScatter& input : gear.scatter)
        set_number(one, input.path, rows.at(n, input.path));
      const StiffnessResult result =
          evaluate(one, Method::corrected, {.coupled_drive = false, .life = false});
      EXPECT_EQ(rows.status[n] == RowStatus::usable, result.usable());
      if (result.usable())
        test::expect_relative(rows.at(n, output), output_named(result, output)->value, 1e-10);
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(beside, 0);
    // A mixed point has the inputs of A, apart from those of its group.
    const std::vector<double>& a = rows.numbers[0];
    const std::vector<double>& b = rows.numbers[1];
    const std::vector<double>& mixed = rows.numbers[2];
    for (std::size_t i = 0; i < gear.scatter.size(); ++i) {
      const bool of_group = i == 0 || (correlated && i == 1);
      EXPECT_EQ(mixed[2 + i], of_group ? b[2 + i] : a[2 + i]) << i;
    }

    test::KeptRows of_threads;
    SobolSettings other = settings;
    other.threads = 3;
    other.rows = &of_threads;
    (void)sobol_of(gear, other);
    EXPECT_TRUE(test::same_rows(of_threads, rows));
  }
}

TEST(Sobol, InputRefusals) {
  const GearSet gear = uncertain_example();
  const auto refusal = [&](const SobolSettings& settings) {
    return test::broken_rule([&] { return sobol_of(gear, settings); });
  };
  EXPECT_EQ(refusal({.points = 100}), "points = 100 violates: a multiple of 16 from 32 to 262144");
  EXPECT_EQ(refusal({.points = 16}), "points = 16 violates: a multiple of 16 from 32 to 262144");
  EXPECT_EQ(refusal({.threads = -1}), "threads = -1 violates: >= 0");
  EXPECT_NE(refusal({.outputs = {"intact.stifness"}}).find("did you mean intact.stiffness?"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([] {
              return sobol_of(test::article_gear());
            }).find("scatter: must be given"),
            std::string::npos);
}

// --- Reliability
// ----------------------------------------------------------------------------------

// Kind: reference.  K is proportional to a lognormal G, so P(K < b) = Phi(ln(b/K)/sigma).
TEST(Reliability, ReferenceOfALognormalStiffness) {
  const double s = 0.05;
  const double sigma = std::sqrt(std::log1p(s * s));
  const GearSet gear = shaft_alone(ScatterDistribution::lognormal, s);
  const double K = stiffness_of(gear);
  for (const double beta : {1.0, 3.0, 4.5}) {
    const double bound = K * std::exp(-beta * sigma);
    const ReliabilityReport report =
        reliability(gear, fmt::format("intact.stiffness >= {:.17g} N*m/rad", bound));
    const RequirementReliability& answer = report.answers[0];
    const double exact = normal_probability(-beta);
    EXPECT_NEAR(answer.first_order.reliability_index, beta, 1e-6);
    test::expect_relative(answer.first_order.probability, exact, 1e-5);
    ASSERT_TRUE(answer.second_order && answer.second_order->probability);
    test::expect_relative(*answer.second_order->probability, exact, 1e-5);
    ASSERT_TRUE(answer.importance_sampling);
    EXPECT_NEAR(answer.importance_sampling->probability, exact,
                4 * answer.importance_sampling->standard_error);
    EXPECT_LE(answer.monte_carlo.low, exact);
    EXPECT_GE(answer.monte_carlo.high, exact);
    EXPECT_EQ(answer.trusted,
              beta < 3.1 ? ReliabilityRoad::monte_carlo : ReliabilityRoad::importance_sampling);
    ASSERT_TRUE(answer.probability);
    test::expect_relative(*answer.probability, exact, 0.2);
    const DesignPointInput& input = answer.first_order.inputs[0];
    EXPECT_EQ(input.path, "material.steel.shear_modulus");
    EXPECT_EQ(input.unit, "Pa");
    test::expect_relative(input.at_design, 80e9 * std::exp(-beta * sigma), 1e-6);
    EXPECT_NEAR(input.deviations, -beta, 1e-6);
    EXPECT_NEAR(input.importance, 1, 1e-9);
    std::vector<std::string> codes = {"reliability.scatter_alone"};
    if (answer.trusted == ReliabilityRoad::importance_sampling)
      codes.insert(codes.begin(), "reliability.elsewhere");
    EXPECT_EQ(test::note_codes(report.notes), codes);
  }
}

// Kind: identity.  The probability of not keeping a bound from below and from above add up to 1.
TEST(Reliability, IdentityOfBothSidesOfABound) {
  const GearSet gear = uncertain_example();
  const auto probability = [&](const std::string& text) {
    return reliability(gear, text, {.draws = 20000}).answers[0];
  };
  const auto below = probability("cracked.positive.stiffness >= 610000 N*m/rad");
  const auto above = probability("cracked.positive.stiffness < 610000 N*m/rad");
  EXPECT_EQ(below.monte_carlo.failures + above.monte_carlo.failures, 20000);
  EXPECT_NEAR(below.first_order.probability + above.first_order.probability, 1, 1e-6);
  EXPECT_GT(below.first_order.reliability_index, 0);
  EXPECT_LT(above.first_order.reliability_index, 0);
}

// Kind: cross-check.  All roads of the example agree.
TEST(Reliability, CrosscheckOfTheExample) {
  const ReliabilityReport report =
      reliability(uncertain_example(), "cracked.positive.stiffness >= 5.8e5 N*m/rad", kUsualDraws);
  const RequirementReliability& answer = report.answers[0];
  EXPECT_EQ(answer.trusted, ReliabilityRoad::importance_sampling);
  test::expect_relative(*answer.second_order->probability, *answer.probability, 0.03);
  test::expect_relative(answer.first_order.probability, *answer.probability, 0.12);
  EXPECT_LT(answer.high - answer.low, (test::kSanitized ? 0.15 : 0.1) * *answer.probability);
  EXPECT_EQ(answer.first_order.inputs[0].path, "wave_generator.radial_stiffness");
  double importance = 0.0;
  for (const DesignPointInput& input : answer.first_order.inputs) importance += input.importance;
  EXPECT_NEAR(importance, 1, 1e-12);
}

// Kind: behaviour.  Requirements that are always or never met: limits, and what to do.
TEST(Reliability, BehaviourAlwaysAndNeverMet) {
  const GearSet gear = uncertain_example();
  const ReliabilityReport always = reliability(gear, "intact.stiffness >= 1 N*m/rad", kUsualDraws);
  EXPECT_EQ(always.answers[0].trusted, ReliabilityRoad::none);
  EXPECT_FALSE(always.answers[0].probability);
  EXPECT_EQ(always.answers[0].low, 0);
  EXPECT_LT(always.answers[0].high, test::kSanitized ? 2e-4 : 2e-5);
  EXPECT_EQ(test::count_notes(always.notes, "reliability.cannot_tell"), 1);
  EXPECT_EQ(evidence_of(always).verdict.judgement, Judgement::cannot_be_told);
  const ReliabilityReport never = reliability(gear, "intact.stiffness >= 1e9 N*m/rad", kUsualDraws);
  EXPECT_EQ(never.answers[0].trusted, ReliabilityRoad::monte_carlo);
  EXPECT_EQ(*never.answers[0].probability, 1);
  EXPECT_GT(never.answers[0].low, test::kSanitized ? 0.999 : 0.9999);
  EXPECT_NE(never.answers[0].first_order.reason.find("no drive that meets"), std::string::npos);
}

// Kind: behaviour.  Drives that cannot be built count as failures in the upper limit, with a note.
TEST(Reliability, BehaviourDrivesWithoutAValue) {
  GearSet gear = uncertain_example();
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 9.5e-3;
  const ReliabilityReport report =
      reliability(gear, "cracked.positive.stiffness >= 3e5 N*m/rad", {.draws = 20000});
  const DrawnReliability& plain = report.answers[0].monte_carlo;
  EXPECT_GT(plain.without_value, 100);
  EXPECT_GT(plain.high, plain.probability + 0.9 * plain.without_value / 20000.0);
  EXPECT_EQ(test::count_notes(report.notes, "reliability.no_value"), 1);
}

// Kind: reference.  The compliance that a surface crack of the wall adds is extreme at 45 degrees
// and symmetric about it, so a bound on it fails on two sides, 2 Phi(-1.5).  First order sees one
// side alone, and a note says how far it is off.
TEST(Reliability, ReferenceALimitWithTwoSidesIsNamed) {
  GearSet gear = uncertain_example();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  WallSurfaceCrack crack;
  crack.depth = 0.5e-3;
  crack.half_length = 1e-3;
  crack.angle = std::numbers::pi / 4;
  gear.flexspline->crack = {crack};
  gear.scatter = {{.path = "flexspline.crack[0].angle",
                   .relative_standard_deviation = 0.1,
                   .distribution = ScatterDistribution::normal,
                   .source = {}}};
  const auto change_at = [&](double deviations) {
    GearSet turned = gear;
    std::get<WallSurfaceCrack>(turned.flexspline->crack[0]).angle *= 1 + 0.1 * deviations;
    return evaluate(turned, Method::corrected).positive.stiffness_change.value;
  };
  const double bound = change_at(1.5);
  test::expect_relative(change_at(-1.5), bound, 1e-9);
  const ReliabilityReport report =
      reliability(gear, fmt::format("cracked.positive.stiffness_change {} {:.17g}",
                                    change_at(0) < bound ? "<=" : ">=", bound));
  const RequirementReliability& answer = report.answers[0];
  EXPECT_EQ(answer.trusted, ReliabilityRoad::monte_carlo);
  ASSERT_TRUE(answer.probability);
  EXPECT_NEAR(*answer.probability, 2 * normal_probability(-1.5),
              4 * answer.monte_carlo.standard_error);
  ASSERT_TRUE(answer.first_order.converged) << answer.first_order.reason;
  EXPECT_NEAR(answer.first_order.reliability_index, 1.5, 1e-3);
  EXPECT_EQ(test::count_notes(report.notes, "reliability.curved"), 1);
}

// Kind: reference (UQ-10), (UQ-11).  Two limits of the maker scatter independently, so the drive
// fails by two causes, the nearer one at 4.38 and the other at 4.42 standard deviations.  A search
// by draws finds the second cause, and draws about both give the sum; draws about the design point
// alone gave half of it.  A note still bounds what the search may miss, by the plain draws.
// Tolerance: four standard errors.
TEST(Reliability, ReferenceTwoCauses) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/life_size25.toml");
  gear.wave_generator.reset();
  gear.flexspline.reset();
  gear.mesh.reset();
  gear.circular_spline.reset();
  gear.output_shaft =
      OutputShaft{.material = "steel", .outer_diameter = 0.03, .length = 0.04, .crack = {}};
  const double s = 0.06;
  gear.rating->momentary_peak = 1.3 * 300;
  gear.rating->repeated_peak = 1.303 * 150;
  for (const char* const path : {"rating.momentary_peak", "rating.repeated_peak"})
    gear.scatter.push_back({.path = path, .relative_standard_deviation = s, .source = {}});
  const double sigma = std::sqrt(std::log1p(s * s));
  const double one = normal_probability(-std::log(1.3) / sigma);
  const double other = normal_probability(-std::log(1.303) / sigma);
  const ReliabilityReport report = reliability(gear, "life.makers_reserve >= 1", {.draws = 4000});
  const RequirementReliability& answer = report.answers[0];
  EXPECT_EQ(answer.trusted, ReliabilityRoad::importance_sampling);
  ASSERT_TRUE(answer.probability);
  EXPECT_NEAR(*answer.probability, one + other - one * other,
              4 * answer.importance_sampling->standard_error);
  EXPECT_LT(answer.importance_sampling->standard_error, 0.12 * (one + other));
  EXPECT_GT(answer.low, std::max(one, other));
  ASSERT_TRUE(answer.first_order.converged);
  test::expect_relative(answer.first_order.probability, one, 1e-3);
  EXPECT_EQ(test::count_notes(report.notes, "reliability.elsewhere"), 1);
  const auto note = std::ranges::find(report.notes, "reliability.elsewhere", &Note::code);
  EXPECT_NE(note->text.find("about 2 centres, each of a cause"), std::string::npos) << note->text;
  EXPECT_EQ(evidence_of(report).verdict.judgement, Judgement::with_care);
}

// Kind: behaviour (UQ-6).  An output on which the scattering inputs have no influence: a note says
// this in place of the advice to take more draws, whether the requirement is always kept or broken.
TEST(Reliability, BehaviourAConstantOutput) {
  GearSet gear = uncertain_example();
  gear.scatter = {
      {.path = "output_shaft.crack[0].depth", .relative_standard_deviation = 0.1, .source = {}}};
  for (const bool kept : {true, false}) {
    const ReliabilityReport report = reliability(
        gear, kept ? "intact.stiffness >= 1 N*m/rad" : "intact.stiffness >= 1e12 N*m/rad",
        {.draws = 200});
    EXPECT_EQ(test::count_notes(report.notes, "reliability.constant"), 1);
    EXPECT_EQ(test::count_notes(report.notes, "reliability.cannot_tell"), 0);
    const auto note = std::ranges::find(report.notes, "reliability.constant", &Note::code);
    EXPECT_NE(note->text.find("does not depend on the inputs"), std::string::npos) << note->text;
    EXPECT_EQ(note->next_step.find("--draws"), std::string::npos) << note->next_step;
    EXPECT_EQ(evidence_of(report).verdict.judgement,
              kept ? Judgement::cannot_be_told : Judgement::with_care);
  }
  // An output that depends on the inputs has no such note, even if no draw breaks the requirement.
  const ReliabilityReport varies =
      reliability(gear, "cracked.positive.stiffness >= 1 N*m/rad", {.draws = 200});
  EXPECT_EQ(test::count_notes(varies.notes, "reliability.constant"), 0);
  EXPECT_EQ(test::count_notes(varies.notes, "reliability.cannot_tell"), 1);
}

// Kind: behaviour (UQ-6).  A crack that is closed changes nothing, so "< 0" is broken on its bound
// in each draw, and "<= 0" is kept.
TEST(Reliability, BehaviourAStrictRequirementOnItsBound) {
  GearSet gear = uncertain_example();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  gear.scatter = {{.path = "flexspline.crack[0].half_length",
                   .relative_standard_deviation = 0.1,
                   .source = {}}};
  const std::string change = "cracked.negative.stiffness_change ";
  for (const char* const strict : {"< 0 %", "> 0 %"}) {
    const RequirementReliability answer =
        reliability(gear, change + strict, {.draws = 200}).answers[0];
    EXPECT_EQ(answer.trusted, ReliabilityRoad::monte_carlo) << strict;
    EXPECT_EQ(answer.probability, 1.0) << strict;
  }
  for (const char* const kept : {"<= 0 %", ">= 0 %"})
    EXPECT_EQ(reliability(gear, change + kept, {.draws = 200}).answers[0].monte_carlo.failures, 0)
        << kept;
}

// Kind: behaviour.  Titles of tables call an output what it is.
TEST(OutputWords, BehaviourAnyOutput) {
  EXPECT_EQ(output_words("intact.stiffness"), "stiffness, sound");
  EXPECT_EQ(output_words("cracked.positive.stiffness"), "stiffness, T > 0");
  EXPECT_EQ(output_words("cracked.negative.stiffness_loss"), "loss of stiffness, T < 0");
  EXPECT_EQ(output_words("curve.intact.K2"), "K2, sound");
  EXPECT_EQ(output_words("curve.negative.K3"), "K3, T < 0");
  for (const char* const other :
       {"cracked.positive.wind_up", "cracked.negative.stiffness_change", "intact.wind_up",
        "intact.compliance.total", "output_shaft.crack[0].strength.K", "life.makers_reserve",
        "curve.positive.over_turn.softest.K1", "cracked.positive.K1"})
    EXPECT_EQ(output_words(other), other);
}

TEST(Reliability, InputRefusals) {
  const GearSet gear = uncertain_example();
  const auto refusal = [&](const std::vector<std::string>& texts,
                           const ReliabilitySettings& settings = {}) {
    return test::broken_rule(
        [&] { return reliability_of(gear, requirements_on(gear, texts), settings); });
  };
  EXPECT_EQ(refusal({}),
            "require: must be given, such as 'cracked.positive.stiffness >= 4e5 N*m/rad'");
  EXPECT_NE(refusal({"intact.stiffness"}).find("is not a requirement; write OUTPUT OP VALUE"),
            std::string::npos);
  EXPECT_NE(refusal({"intact.stifness >= 1 N*m/rad"}).find("did you mean intact.stiffness?"),
            std::string::npos);
  EXPECT_EQ(refusal({"intact.stiffness >= 1 m"}),
            "intact.stiffness: \"1 m\" is not convertible to N*m/rad");
  const std::vector<std::string> good = {"intact.stiffness >= 1 N*m/rad"};
  EXPECT_EQ(refusal(good, {.draws = 1}), "--draws = 1 violates: >= 2 and <= 10000000");
  EXPECT_EQ(refusal(good, {.threads = -1}), "--threads = -1 violates: >= 0");
  const GearSet without = test::article_gear();
  EXPECT_NE(test::broken_rule([&] {
              return reliability_of(without, requirements_on(without, good));
            }).find("scatter: must be given"),
            std::string::npos);
}

// Kind: behaviour (GS-12).  Shares and probabilities of lives leave out the scatter of growth, and
// a note says so; other outputs have no such note.
TEST(UncertainOutputs, BehaviourLivesOfMedianGrowth) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/inspected_shaft.toml");
  gear.scatter.resize(1);
  gear.material.at("steel").growth_scatter = GrowthScatter{.level = 0.1};
  const auto noted = [](const std::vector<Note>& notes) {
    return std::ranges::count(notes, "scatter.growth_left_out", &Note::code);
  };
  const auto sobol = [&](const std::string& output) {
    return sobol_of(gear, {.points = 2 * kSobolReplicates, .outputs = {output}}).notes;
  };
  EXPECT_EQ(noted(sobol("intact.stiffness")), 0);
  EXPECT_EQ(noted(reliability(gear, "life.cracks >= 100 h", {.draws = 2}).notes), 1);
  if (test::kSanitized) return;  // its lives take a minute
  EXPECT_EQ(noted(sobol("life.cracks")), 1);
}

}  // namespace
}  // namespace strainwave

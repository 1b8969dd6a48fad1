// SPDX-License-Identifier: Apache-2.0
// Lives of drives whose numbers scatter, and inspections.
#include "strainwave/study/inspection_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/drive_growth/drawn_growth.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/inspection/detection_fit.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/inspection.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"
#include "support/program.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

constexpr double kHour = 3600;

GearSet scattering_shaft() {
  GearSet gear = read_gear_set_file(std::string(STRAINWAVE_EXAMPLES) + "/inspected_shaft.toml");
  return gear;
}

/// Only the coefficient of growth scatters.
GearSet only_coefficient() {
  GearSet gear = scattering_shaft();
  gear.scatter.resize(1);
  return gear;
}

InputScatter scatter_of(const std::string& path, double relative_standard_deviation) {
  InputScatter scatter;
  scatter.path = path;
  scatter.relative_standard_deviation = relative_standard_deviation;
  return scatter;
}

InspectionOptions options_of(int draws, std::optional<double> until = std::nullopt) {
  InspectionOptions options;
  options.growth.tolerance = 1e-6;
  options.draws = draws;
  options.until = until;
  return options;
}

bool has(const InspectionReport& report, const std::string& code) {
  return std::ranges::any_of(report.notes, [&](const Note& note) { return note.code == code; });
}

// Kind: reference (IR-3), (IR-7), (IR-8).  Only C scatters, so a life is that of the file over C:
// lives are log-normal with the drawn numbers, and their order is known.  Tolerance: 1e-4 of the
// tolerance and the bisection of the assessment.
TEST(InspectionReport, ReferenceLogNormalLives) {
  const GearSet gear = only_coefficient();
  const InspectionReport report = inspection_report(gear, options_of(200));
  const double sigma = std::sqrt(std::log1p(0.25 * 0.25));
  std::vector<double> lives;
  for (std::size_t i = 0; i < 200; ++i)
    lives.push_back(*report.nominal_life * std::exp(-sigma * counter_normal(1, i, 0)));
  std::ranges::sort(lives);
  ASSERT_EQ(report.percentiles.size(), 4U);
  test::expect_relative(*report.percentiles[1].life, lives[19], 1e-4);
  test::expect_relative(*report.percentiles[2].life, lives[99], 1e-4);
  EXPECT_LT(*report.percentiles[2].lower, *report.nominal_life);
  EXPECT_GT(*report.percentiles[2].upper, *report.nominal_life);
  const auto failed =
      std::ranges::count_if(lives, [&](double life) { return life <= *report.nominal_life; });
  EXPECT_NEAR(report.at_end.without, static_cast<double>(failed) / 200, 1e-12);
  ASSERT_EQ(report.shares.size(), 1U);
  EXPECT_NEAR(report.shares[0].share, 1, 1e-3);
}

// Kind: cross-check (IR-8).  Two inputs: the life is proportional to 1/C, so the share of C is the
// variance of ln C over that of ln L.  Tolerance: 0.1, the sampling error of 400 draws; 0.2 for
// 100.
TEST(InspectionReport, CrosscheckShareOfTheCoefficient) {
  constexpr int kDraws = test::kSanitized ? 100 : 400;
  GearSet gear = scattering_shaft();
  gear.scatter.resize(2);
  const InspectionReport report = inspection_report(gear, options_of(kDraws));
  const double of_C = std::sqrt(std::log1p(0.25 * 0.25));
  const double of_depth = std::sqrt(std::log1p(0.3 * 0.3));
  GrowthOptions fast;
  fast.tolerance = 1e-5;
  std::vector<double> logs;
  for (std::size_t i = 0; i < kDraws; ++i) {
    GearSet drawn = gear;
    drawn.scatter.clear();
    set_number(drawn, "output_shaft.crack[0].depth",
               0.5e-3 * std::exp(of_depth * counter_normal(1, i, 1)));
    logs.push_back(std::log(*life_trace(drawn, fast).life) - of_C * counter_normal(1, i, 0));
  }
  double mean = 0.0;
  for (const double value : logs) mean += value / kDraws;
  double variance = 0.0;
  for (const double value : logs) variance += (value - mean) * (value - mean) / kDraws;
  const auto share =
      std::ranges::find(report.shares, "material.steel.growth[0].coefficient", &LifeShare::path);
  ASSERT_NE(share, report.shares.end());
  EXPECT_NEAR(share->share, of_C * of_C / variance, test::kSanitized ? 0.2 : 0.1);
}

// Kind: identity.  The answer does not depend on the number of threads, and depends on the seed.
TEST(InspectionReport, IdentityThreads) {
  const GearSet gear = scattering_shaft();
  InspectionOptions options = options_of(40, 300 * kHour);
  options.threads = 1;
  const InspectionReport one = inspection_report(gear, options);
  options.threads = 3;
  const InspectionReport three = inspection_report(gear, options);
  for (std::size_t i = 0; i < one.percentiles.size(); ++i)
    EXPECT_EQ(one.percentiles[i].life, three.percentiles[i].life);
  options.seed = 2;
  EXPECT_NE(inspection_report(gear, options).percentiles[2].life, one.percentiles[2].life);
}

// Kind: identity (IR-4).  Inspections conserve: what is found, what is in service and what has
// failed make the whole; remaining risks fall, and the last one is that of all inspections.
TEST(InspectionReport, IdentityInspectionsConserve) {
  const GearSet gear = scattering_shaft();
  InspectionOptions options = options_of(100, 400 * kHour);
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3, .false_calls = 0.05};
  options.times.every = 100 * kHour;
  options.times.first = 150 * kHour;
  const InspectionReport report = inspection_report(gear, options);
  ASSERT_EQ(report.inspections.size(), 3U);
  test::expect_relative(report.inspections[0].time, 150 * kHour, 1e-12);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_LT(report.inspections[i].remaining, report.inspections[i - 1].remaining);
    EXPECT_LE(report.inspections[i].in_service,
              report.inspections[i - 1].in_service - report.inspections[i - 1].found + 1e-12);
  }
  test::expect_relative(report.inspections[2].remaining, *report.at_end.inspected, 1e-12);
  const double missed = report.inspections[0].in_service - report.inspections[0].found;
  test::expect_relative(report.inspections[0].false_call, 0.05 * missed, 1e-12);
  const LifeTrace trace = life_trace(gear, options.growth);
  const DrawnPart part{.failure = *trace.life, .times = trace.times, .sizes = trace.sizes};
  test::expect_relative(part.size_at(0, *trace.life - 2 * report.half_interval.value()), 2e-3,
                        1e-9);
  options.method->a50 = 0.05;  // larger than the shaft
  options.method->a90 = 0.1;
  const InspectionReport late = inspection_report(gear, options);
  EXPECT_EQ(late.half_interval, 0.0);
  const std::string text = inspection_text(late, gear);
  EXPECT_NE(text.find("fails before its crack reaches the size a90"), std::string::npos);
  EXPECT_EQ(text.find("half of the time"), std::string::npos);
  for (const RiskPoint& point : report.risk) EXPECT_LE(*point.inspected, point.without);
}

// Kind: reference.  The trace is the path of grow_cracks, without its evidence.  Tolerance: 1e-6.
TEST(InspectionReport, ReferenceTraceOfTheFile) {
  const GearSet gear = scattering_shaft();
  const LifeTrace trace = life_trace(gear);
  const GrowthReport full = grow_cracks(gear);
  test::expect_relative(*trace.life, *full.life, 1e-6);
  EXPECT_EQ(trace.governing, full.governing);
  EXPECT_EQ(trace.end, full.end);
  ASSERT_EQ(trace.sizes.size(), 1U);
  EXPECT_EQ(trace.cracks.front(), "output_shaft.crack[0]");
  EXPECT_TRUE(std::ranges::is_sorted(trace.times));
  EXPECT_TRUE(std::ranges::is_sorted(trace.sizes[0]));
  test::expect_relative(trace.sizes[0].back(), full.cracks[0].series.back().size, 1e-6);
}

// Kind: behaviour.  Half of the cracks are below their threshold: they have an endless life.
TEST(InspectionReport, BehaviourArrestIsAnOutcome) {
  GearSet gear = scattering_shaft();
  gear.scatter.erase(gear.scatter.begin());  // of the coefficient
  gear.material.at("steel").growth_bounds.emplace().threshold = 6.8e6;
  gear.scatter.resize(1);
  const InspectionReport report = inspection_report(gear, options_of(60, 500 * kHour));
  EXPECT_GT(report.outcomes.arrested, 15);
  EXPECT_LT(report.outcomes.arrested, 45);
  EXPECT_EQ(report.outcomes.arrested + report.outcomes.failed + report.outcomes.later, 60);
  EXPECT_TRUE(has(report, "inspection.arrested"));
  EXPECT_FALSE(report.percentiles[3].life);
}

// Kind: behaviour.  Notes: no failure among the draws; a plan that is not proven; draws that break
// a rule.
TEST(InspectionReport, BehaviourNotes) {
  const GearSet gear = scattering_shaft();
  EXPECT_TRUE(has(inspection_report(gear, options_of(30, 1 * kHour)), "inspection.draws"));
  InspectionOptions options = options_of(30, 450 * kHour);
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  options.times.risk = 1e-4;
  const InspectionReport planned = inspection_report(gear, options);
  ASSERT_EQ(planned.plans.size(), 2U);
  EXPECT_TRUE(has(planned, "inspection.draws"));
  // The advice asks for more draws than the study had, also where 3.69 over the risk is fewer.
  options = options_of(40, 450 * kHour);
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  options.times.risk = 0.2;
  const InspectionReport larger = inspection_report(gear, options);
  const auto advice = std::ranges::find(larger.notes, "inspection.draws", &Note::code);
  ASSERT_NE(advice, larger.notes.end());
  EXPECT_NE(advice->next_step.find("more than 40 draws"), std::string::npos) << advice->next_step;
  EXPECT_FALSE(planned.inspections.empty());
  GearSet wild = scattering_shaft();
  wild.scatter.resize(2);
  wild.scatter[1].relative_standard_deviation = 1.0;
  wild.scatter[1].distribution = ScatterDistribution::normal;
  const InspectionReport refused = inspection_report(wild, options_of(60, 400 * kHour));
  EXPECT_GT(refused.outcomes.refused, 0);
  EXPECT_TRUE(has(refused, "inspection.refused"));
  // A hollow shaft of a steel that does not break: the crack leaves the range of its solution.
  GearSet tough = only_coefficient();
  tough.output_shaft->inner_diameter = 0.04;
  std::get<AnnularCrack>(tough.output_shaft->crack[0]).solution = AnnularSolution::improved;
  Material& steel = tough.material.at("steel");
  steel.fracture_toughness = 1e11;
  steel.yield_strength = 1e12;
  steel.ultimate_strength = 2e12;
  const InspectionReport ranged = inspection_report(tough, options_of(30, 1e6 * kHour));
  EXPECT_EQ(ranged.outcomes.out_of_range, 30);
  EXPECT_EQ(ranged.outcomes.failed, 30);
  EXPECT_TRUE(has(ranged, "inspection.range"));
}

// Kind: input.  What is missing or contradicts.
TEST(InspectionReport, InputIsRefused) {
  const auto message = [](const GearSet& gear, const InspectionOptions& options) {
    return test::broken_rule([&] { return inspection_report(gear, options); });
  };
  const GearSet gear = scattering_shaft();
  InspectionOptions options = options_of(40);
  options.times.every = kHour;
  EXPECT_NE(message(gear, options).find("a50: must be given"), std::string::npos);
  options.method = Inspection{.a50 = 2e-3, .a90 = 1e-3};
  EXPECT_NE(message(gear, options).find("a90"), std::string::npos);
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3, .place = {{"output_shaft.crack[7]"}}};
  EXPECT_NE(
      message(gear, options)
          .find(
              "inspection.place[0].crack: \"output_shaft.crack[7]\" is not a crack of this drive"),
      std::string::npos);
  options.method->place.clear();
  options.times.at = {kHour};
  EXPECT_NE(message(gear, options).find("every: is given beside at"), std::string::npos);
  options.times.every.reset();
  options.times.first = kHour;
  EXPECT_NE(message(gear, options).find("first: is read with the interval only"),
            std::string::npos);
  options.times.first.reset();
  options.times.at = {1e9};
  EXPECT_NE(message(gear, options).find("before the end of service"), std::string::npos);
  options.times.at.clear();
  options.times.every = 1e9;
  EXPECT_NE(message(gear, options).find("every = 1e+09 s violates: before the end of service"),
            std::string::npos);
  options.times.every = 100 * kHour;
  options.times.first = 1e9;
  EXPECT_NE(message(gear, options).find("first = 1e+09 s violates: before the end of service"),
            std::string::npos);
  options.times.every.reset();
  options.times.first.reset();
  EXPECT_NE(message(gear, options).find("give at, every or risk"), std::string::npos);
  options.times.every = 1.0;
  EXPECT_NE(message(gear, options).find("at most 1000 inspections"), std::string::npos);
  options.times.every.reset();
  options.times.risk = 1.0;
  EXPECT_NE(message(gear, options).find("risk = 1"), std::string::npos);
  EXPECT_NE(message(gear, options_of(5)).find("draws"), std::string::npos);
  EXPECT_NE(message(gear, options_of(40, -1.0)).find("until"), std::string::npos);
  // No longer time is computed, so nothing is known of drives that last until then.
  EXPECT_NE(message(gear, options_of(40, 3.2e13)).find("a million years"), std::string::npos);
  GearSet sure = gear;
  sure.scatter.clear();
  EXPECT_NE(message(sure, options_of(40)).find("scatter"), std::string::npos);
  GearSet idle = gear;
  idle.duty.reset();
  EXPECT_NE(message(idle, options_of(40)).find("duty: must be given"), std::string::npos);
}

/// The crack of the example, inspected as the file itself says.
GearSet inspected_shaft(const Inspection& inspection) {
  GearSet gear = scattering_shaft();
  gear.inspection = inspection;
  return gear;
}

// Kind: identity.  The table of the file is the method; options stand in its place.  Without times
// of inspections it changes no risk.
TEST(InspectionReport, IdentityTheTableIsTheMethod) {
  const Inspection curve{.a50 = 1e-3, .a90 = 2e-3, .false_calls = 0.02};
  InspectionOptions options = options_of(60, 450 * kHour);
  options.times.every = 100 * kHour;
  const InspectionReport by_table = inspection_report(inspected_shaft(curve), options);
  options.method = curve;
  const InspectionReport by_option = inspection_report(scattering_shaft(), options);
  EXPECT_EQ(by_table.at_end.inspected, by_option.at_end.inspected);
  EXPECT_EQ(by_table.inspections.at(1).false_call, by_option.inspections.at(1).false_call);
  const InspectionReport in_its_place =
      inspection_report(inspected_shaft({.a50 = 9e-3, .a90 = 12e-3}), options);
  EXPECT_EQ(in_its_place.at_end.inspected, by_option.at_end.inspected);
  const InspectionReport idle =
      inspection_report(inspected_shaft(curve), options_of(60, 450 * kHour));
  EXPECT_FALSE(idle.at_end.inspected);
  EXPECT_EQ(idle.at_end.without, by_table.at_end.without);
  EXPECT_EQ(idle.method->a90, 2e-3);
  EXPECT_EQ(idle.half_interval, by_table.half_interval);
}

// Kind: crosscheck (IR-9).  Repair: the risk lies between that of drives out of service and that
// without inspections, falls with the size of the repair, and the drives stay in service.
TEST(InspectionReport, CrosscheckRepair) {
  Inspection curve{.a50 = 0.8e-3, .a90 = 1.6e-3};
  InspectionOptions options = options_of(120, 700 * kHour);
  options.times.every = 70 * kHour;
  const InspectionReport out = inspection_report(inspected_shaft(curve), options);
  curve.find = FindLeadsTo::repair;
  double last = *out.at_end.inspected;
  for (const double size : {0.4e-3, 0.8e-3, 1.6e-3}) {
    curve.repaired_to = size;
    const InspectionReport repaired = inspection_report(inspected_shaft(curve), options);
    EXPECT_GT(*repaired.at_end.inspected, last);
    EXPECT_LT(*repaired.at_end.inspected, repaired.at_end.without);
    EXPECT_GT(repaired.inspections.back().in_service, out.inspections.back().in_service);
    EXPECT_EQ(has(repaired, "inspection.first_size"), size < 1.5e-3);
    EXPECT_FALSE(has(repaired, "inspection.other_cracks"));
    EXPECT_NE(inspection_text(repaired, inspected_shaft(curve)).find("a repair to"),
              std::string::npos);
    last = *repaired.at_end.inspected;
  }
}

// Kind: crosscheck (IR-9).  The life after a repair, by the age of the path, is that of a drive
// whose crack has this size at first.  Tolerance: 2e-3 of the life, the path between the steps of
// growth.
TEST(InspectionReport, CrosscheckLifeFromTheRepairedSize) {
  GearSet gear = scattering_shaft();
  gear.scatter.clear();
  GrowthOptions fine;
  fine.tolerance = 1e-9;
  const LifeTrace whole = life_trace(gear, fine);
  const DrawnPart part{.failure = *whole.life, .times = whole.times, .sizes = whole.sizes};
  for (const double size : {0.7e-3, 1.5e-3, 4e-3}) {
    std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = size;
    EXPECT_NEAR(part.failure - part.time_of(0, size), *life_trace(gear, fine).life,
                2e-3 * part.failure);
  }
}

// Kind: behaviour (IR-9).  Two cracks that grow: the answer says that it may be too high.
TEST(InspectionReport, BehaviourRepairWithOtherCracks) {
  GearSet gear = inspected_shaft(
      {.a50 = 1e-3, .a90 = 2e-3, .find = FindLeadsTo::repair, .repaired_to = 0.6e-3});
  gear.output_shaft->crack.push_back(gear.output_shaft->crack.front());
  InspectionOptions options = options_of(20, 400 * kHour);
  options.times.every = 100 * kHour;
  EXPECT_TRUE(has(inspection_report(gear, options), "inspection.other_cracks"));
}

// Kind: reference (IR-15).  Cost by hand from the table of inspections.
TEST(InspectionReport, ReferenceCost) {
  Inspection curve{.a50 = 1e-3,
                   .a90 = 2e-3,
                   .false_calls = 0.05,
                   .cost = InspectionCost{.inspection = 20, .call = 300, .failure = 5000}};
  InspectionOptions options = options_of(80, 500 * kHour);
  options.times.every = 100 * kHour;
  options.times.risk = 0.05;
  const InspectionReport report = inspection_report(inspected_shaft(curve), options);
  double expected = *report.at_end.inspected * 5000;
  for (const InspectionRow& row : report.inspections)
    expected += 20 * row.in_service + 300 * (row.found + row.false_call);
  test::expect_relative(*report.cost->inspected, expected, 1e-12);
  test::expect_relative(report.cost->without, 5000 * report.at_end.without, 1e-12);
  test::expect_relative(*report.cost->inspected,
                        *report.cost->inspections + *report.cost->calls + *report.cost->failures,
                        1e-12);
  ASSERT_EQ(report.plans.size(), 2U);
  EXPECT_GT(report.plans[0].cost.value(), 0);
  EXPECT_NE(inspection_text(report, inspected_shaft(curve)).find("Cost up to the end of service"),
            std::string::npos);
  const InspectionReport idle =
      inspection_report(inspected_shaft(curve), options_of(80, 500 * kHour));
  EXPECT_EQ(idle.cost->without, report.cost->without);
  EXPECT_FALSE(idle.cost->inspected);
}

Inspection measured_by(InspectionMeans method, double noise, double false_calls = 0.05) {
  return {.method = method, .noise = noise, .false_calls = false_calls};
}

// Kind: reference (IR-10), (IR-11).  The change at the end is that of the stiffness over the growth
// of the file, and the probability that of a normal error.  Source: grow_cracks, which takes the
// stiffness from the report of the members.  Tolerance: 1e-4 of the two bisections.
TEST(InspectionReport, ReferenceMeasuredStiffness) {
  const GearSet gear = inspected_shaft(measured_by(InspectionMeans::stiffness, 1e-3));
  const InspectionReport report = inspection_report(gear, options_of(30, 400 * kHour));
  const GrowthReport grown = grow_cracks(gear);
  GearSet sound = gear;
  sound.output_shaft->crack.clear();
  sound.scatter.clear();
  const double intact = torsional_stiffness(sound).positive.stiffness.value;
  const double change = 1 - grown.stiffness.back().positive / intact;
  ASSERT_TRUE(report.method);
  EXPECT_EQ(report.method->crack, "output_shaft.crack[0]");
  test::expect_relative(*report.method->change_at_end, change, 1e-4);
  EXPECT_TRUE(has(report, "inspection.series"));
  const double z = 1.6448536269514722;
  const double called = std::erfc(-(change / 1e-3 - z) / std::sqrt(2)) / 2;
  EXPECT_NEAR(*report.method->found_at_end, (called - 0.05) / 0.95, 1e-4);
  test::expect_relative(*report.method->threshold, z * 1e-3, 1e-9);
  // The smallest change that nine of ten find is found with 0.9.
  const double ninety = *report.method->change_ninety;
  EXPECT_NEAR((std::erfc(-(ninety / 1e-3 - z) / std::sqrt(2)) / 2 - 0.05) / 0.95, 0.9, 1e-9);
  // Rising, from the smallest drawn crack on.
  const std::vector<DetectionPoint>& points = report.method->points;
  ASSERT_GT(points.size(), 20U);
  EXPECT_LT(points.front().size, 0.4e-3);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_GT(points[i].size, points[i - 1].size);
    EXPECT_GE(points[i].probability, points[i - 1].probability);
  }
}

// Kind: behaviour (IR-11).  A crack that the measurement cannot find before the failure is said so;
// with less noise it is found, and inspections lower the risk.
TEST(InspectionReport, BehaviourAMeasurementThatCannotFind) {
  InspectionOptions options = options_of(40, 450 * kHour);
  options.times.every = 50 * kHour;
  const InspectionReport blind =
      inspection_report(inspected_shaft(measured_by(InspectionMeans::stiffness, 0.5)), options);
  EXPECT_TRUE(has(blind, "inspection.not_found"));
  EXPECT_NE(blind.sentence.find("it cannot be found so in time"), std::string::npos)
      << blind.sentence;
  EXPECT_FALSE(blind.method->a90);
  EXPECT_FALSE(blind.half_interval);
  EXPECT_GT(*blind.at_end.inspected, 0.8 * blind.at_end.without);
  const InspectionReport sharp =
      inspection_report(inspected_shaft(measured_by(InspectionMeans::stiffness, 1e-5)), options);
  EXPECT_FALSE(has(sharp, "inspection.not_found"));
  EXPECT_TRUE(sharp.method->a90);
  EXPECT_LT(*sharp.at_end.inspected, 0.1 * sharp.at_end.without);
}

// Kind: behaviour (IR-11).  Two inspections or more with one first record: its error is left out,
// and a note says so.  The difference of the senses has no first record.
TEST(InspectionReport, BehaviourTheErrorOfTheFirstRecord) {
  InspectionOptions options = options_of(20, 450 * kHour);
  const auto noted = [&](InspectionMeans method) {
    return has(inspection_report(inspected_shaft(measured_by(method, 0.01)), options),
               "inspection.record");
  };
  options.times.at = {100 * kHour};
  EXPECT_FALSE(noted(InspectionMeans::stiffness));
  options.times.at = {100 * kHour, 200 * kHour};
  EXPECT_TRUE(noted(InspectionMeans::stiffness));
  EXPECT_FALSE(noted(InspectionMeans::one_sided_stiffness));
}

// Kind: behaviour (IR-10).  A crack that leaves the range of its solution counts as a failure
// there, and the measurement is judged up to this size.
TEST(InspectionReport, BehaviourAMeasurementUpToTheRange) {
  GearSet tough = only_coefficient();
  tough.output_shaft->inner_diameter = 0.04;
  std::get<AnnularCrack>(tough.output_shaft->crack[0]).solution = AnnularSolution::improved;
  Material& steel = tough.material.at("steel");
  steel.fracture_toughness = 1e11;
  steel.yield_strength = 1e12;
  steel.ultimate_strength = 2e12;
  tough.inspection = measured_by(InspectionMeans::stiffness, 1e-3);
  InspectionOptions options = options_of(20, 1e6 * kHour);
  const InspectionReport report = inspection_report(tough, options);
  EXPECT_FALSE(report.nominal_life);
  EXPECT_GT(report.method->size_at_end.value(), 3e-3);
  EXPECT_GT(report.method->found_at_end.value(), 0.9);
}

// Kind: behaviour (IR-10), (IR-11).  What docs/guide/inspection.md says of a crack through the
// barrel: 1 % of noise finds it late, and 3 % do not find it in time.
TEST(InspectionReport, BehaviourACrackOfTheFlexspline) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  InputScatter scatter;
  scatter.path = "flexspline.crack[1].half_length";
  scatter.relative_standard_deviation = 0.1;
  gear.scatter = {scatter};
  gear.inspection = measured_by(InspectionMeans::stiffness, 0.01, 0.01);
  const InspectionReport report = inspection_report(gear, options_of(20, 5 * kHour));
  EXPECT_NEAR(report.method->change_at_end.value(), 0.048, 5e-4);
  EXPECT_NEAR(2 * report.method->size_at_end.value(), 16e-3, 0.5e-3);
  EXPECT_NEAR(2 * report.method->a90.value(), 15e-3, 0.5e-3);
  gear.inspection = measured_by(InspectionMeans::stiffness, 0.03, 0.01);
  EXPECT_TRUE(has(inspection_report(gear, options_of(20, 5 * kHour)), "inspection.not_found"));
}

// Kind: limit (IR-10).  A crack all round is the same under both senses, so the difference of the
// senses never finds it.
TEST(InspectionReport, LimitOneSidedStiffnessOfASymmetricCrack) {
  InspectionOptions options = options_of(30, 450 * kHour);
  options.times.every = 50 * kHour;
  const InspectionReport report = inspection_report(
      inspected_shaft(measured_by(InspectionMeans::one_sided_stiffness, 1e-6)), options);
  EXPECT_NEAR(*report.method->change_at_end, 0, 1e-12);
  EXPECT_NEAR(*report.method->found_at_end, 0, 1e-9);
  EXPECT_TRUE(has(report, "inspection.not_found"));
  test::expect_relative(*report.at_end.inspected, report.at_end.without, 1e-6);
}

// Kind: reference (IR-10), (IR-11).  A crack through the barrel at 45 degrees opens under one sense
// only.  Change and probability follow from the stiffnesses of torsional_stiffness.  Tolerance:
// 1e-3 of the end of the growth.
TEST(InspectionReport, ReferenceOneSidedStiffnessOfAnInclinedCrack) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  gear.flexspline->crack = {gear.flexspline->crack.at(1)};
  gear.scatter = {scatter_of("flexspline.crack[0].half_length", 0.1)};
  gear.inspection = measured_by(InspectionMeans::one_sided_stiffness, 0.02, 0.02);
  const InspectionReport report = inspection_report(gear, options_of(20, 5 * kHour));
  GearSet cracked = gear;
  cracked.scatter.clear();
  cracked.inspection.reset();
  std::get<WallThroughCrack>(cracked.flexspline->crack[0]).half_length =
      report.method->size_at_end.value();
  const StiffnessResult at_end = torsional_stiffness(cracked);
  const double positive = at_end.positive.stiffness.value;
  const double negative = at_end.negative.stiffness.value;
  ASSERT_GT(std::abs(positive - negative), 0.01 * positive);
  const double change = std::abs(positive - negative) / ((positive + negative) / 2);
  test::expect_relative(report.method->change_at_end.value(), change, 1e-3);
  const double z = 2.3263478740408408;  // a normal error is beyond it at either side in 2 %
  const auto found = [&](double of) {
    const double call = std::erfc((z - of / 0.02) / std::sqrt(2)) / 2 +
                        std::erfc((z + of / 0.02) / std::sqrt(2)) / 2;
    return (call - 0.02) / 0.98;
  };
  EXPECT_NEAR(report.method->found_at_end.value(), found(change), 1e-3);
  test::expect_relative(report.method->threshold.value(), z * 0.02, 1e-9);
  EXPECT_NEAR(found(report.method->change_ninety.value()), 0.9, 1e-9);
}

// Kind: crosscheck (IR-10).  A heavy load on the drive: one spring, so the frequency changes by the
// root of the stiffness.  Tolerance: 1e-3, the inertias of the gear beside the load.
TEST(InspectionReport, CrosscheckResonanceOfAHeavyLoad) {
  GearSet gear = inspected_shaft(measured_by(InspectionMeans::resonance, 1e-3));
  Drivetrain drivetrain;
  drivetrain.motor_inertia = 1e-4;
  drivetrain.load_inertia = 1e5;
  gear.drivetrain = drivetrain;
  const InspectionReport report = inspection_report(gear, options_of(20, 400 * kHour));
  gear.inspection = measured_by(InspectionMeans::stiffness, 1e-3);
  const InspectionReport stiffness = inspection_report(gear, options_of(20, 400 * kHour));
  EXPECT_NEAR(*report.method->change_at_end, 1 - std::sqrt(1 - *stiffness.method->change_at_end),
              1e-3 * *stiffness.method->change_at_end);
}

// Kind: behaviour (IR-12), (IR-13).  Trials: the curve is that of the fit, and the risk by its
// lower bound is larger; too few trials are said.
TEST(InspectionReport, BehaviourTrials) {
  std::vector<HitOrMiss> trials;
  for (int i = 0; i < 40; ++i)
    trials.push_back({.size = 0.3e-3 * std::pow(1.08, i), .hit = i > 18 ? i % 7 != 0 : i % 5 == 0});
  InspectionOptions options = options_of(60, 450 * kHour);
  options.times.every = 100 * kHour;
  options.trials = fit_hits(DetectionForm::log_logistic, trials);
  options.method = Inspection{.a50 = options.trials->a50, .a90 = options.trials->a90};
  const InspectionReport report = inspection_report(scattering_shaft(), options);
  EXPECT_EQ(report.method->trials, 40);
  const auto cites = [](const InspectionReport& of, const char* tag) {
    return std::ranges::find(of.equations, tag) != of.equations.end();
  };
  EXPECT_TRUE(cites(report, "IR-12"));
  EXPECT_FALSE(cites(report, "IR-14"));
  std::vector<SizedSignal> signals;
  for (int i = 0; i < 20; ++i) {
    const double size = 0.3e-3 * std::pow(1.15, i);
    signals.push_back({.size = size, .signal = 1e3 * size * (i % 2 == 0 ? 1.2 : 0.8)});
  }
  InspectionOptions by_signals = options;
  by_signals.trials = fit_signals(signals, 1.0);
  by_signals.method = Inspection{.detection = DetectionForm::log_normal,
                                 .a50 = by_signals.trials->a50,
                                 .a90 = by_signals.trials->a90};
  const InspectionReport of_signals = inspection_report(scattering_shaft(), by_signals);
  EXPECT_TRUE(cites(of_signals, "IR-14"));
  EXPECT_FALSE(cites(of_signals, "IR-12"));
  EXPECT_EQ(report.method->a90_bound, options.trials->a90_bound);
  EXPECT_GT(report.bound_risk.value(), *report.at_end.inspected);
  EXPECT_LE(report.bound_risk.value(), report.at_end.without);
  EXPECT_NE(report.sentence.find("With the lower 95 % bound of detection at each size, it is"),
            std::string::npos);
  EXPECT_NE(inspection_plot(report, scattering_shaft()).find("bound of the trials"),
            std::string::npos);
  options.trials->a90_bound.reset();
  EXPECT_TRUE(has(inspection_report(scattering_shaft(), options), "inspection.trials"));
}

// Kind: behaviour.  Without inspections, a measurement that cannot be judged does not withhold the
// lives; a note says what is missing.
TEST(InspectionReport, BehaviourWithoutMeasurement) {
  GearSet gear = inspected_shaft(measured_by(InspectionMeans::resonance, 0.01));
  const InspectionReport report = inspection_report(gear, options_of(40, 400 * kHour));
  ASSERT_TRUE(has(report, "inspection.no_measurement"));
  EXPECT_NE(std::ranges::find(report.notes, "inspection.no_measurement", &Note::code)
                ->text.find("drivetrain: must be given"),
            std::string::npos);
  EXPECT_FALSE(report.method.has_value());
  EXPECT_FALSE(report.cost.has_value());
  gear.inspection.reset();
  const InspectionReport plain = inspection_report(gear, options_of(40, 400 * kHour));
  EXPECT_EQ(report.at_end.without, plain.at_end.without);
  EXPECT_FALSE(has(plain, "inspection.no_measurement"));
}

// Kind: input.  A measurement that cannot be judged.
TEST(InspectionReport, InputMeasurements) {
  InspectionOptions options = options_of(20, 400 * kHour);
  options.times.every = 100 * kHour;
  const auto message = [&](const GearSet& gear) {
    return test::broken_rule([&] { return inspection_report(gear, options); });
  };
  EXPECT_NE(message(inspected_shaft(measured_by(InspectionMeans::resonance, 0.01)))
                .find("drivetrain: must be given for inspection.method"),
            std::string::npos);
  GearSet still = inspected_shaft(measured_by(InspectionMeans::stiffness, 0.01));
  still.material.at("steel").growth_bounds.emplace().threshold = 40e6;
  EXPECT_NE(message(still).find("needs a crack that ends the life"), std::string::npos);
  // The crack of the inner ring does not grow, because the balls are not known, and it breaks at
  // once.
  GearSet ring = read_gear_set_file(STRAINWAVE_EXAMPLES "/article_duty.toml");
  ring.material.at("steel") = scattering_shaft().material.at("steel");
  ring.material.at("steel").fracture_toughness = 0.7e6;
  auto& race = std::get<RaceSurfaceCrack>(ring.wave_generator->crack.at(0));
  race.depth = 5e-3;
  race.contact_factor = 0.99;
  std::get<WallThroughCrack>(ring.flexspline->crack.at(0)).half_length = 1e-5;
  std::get<AnnularCrack>(ring.output_shaft->crack.at(0)).depth = 1e-5;
  ring.scatter = {scatter_of("flexspline.crack[0].half_length", 0.1)};
  ring.inspection = measured_by(InspectionMeans::stiffness, 0.01);
  const LifeTrace trace = life_trace(ring);
  ASSERT_EQ(trace.governing, "wave_generator.crack[0]");
  ASSERT_EQ(std::ranges::count(trace.cracks, trace.governing), 0);
  EXPECT_NE(message(ring).find("needs a crack that ends the life"), std::string::npos);
}

// Kind: behaviour (IR-3).  A draw in which a crack of the file cannot grow is left out, because the
// crack would be taken for another one.
TEST(InspectionReport, BehaviourADrawWithoutACrackOfTheFile) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  RimAxialCrack rim;
  rim.depth = 0.1e-3;
  gear.flexspline->crack = {rim, gear.flexspline->crack.at(1)};
  InputScatter scatter = scatter_of("duty.block[0].torque", 0.1);
  scatter.relative_standard_deviation.reset();
  scatter.distribution = ScatterDistribution::table;
  // In half of the draws the coupled drive, and so the crack of the rim, has no solution.
  scatter.quantile = {{0.0, 0.99}, {0.5, 1.0}, {0.501, 1e4}, {1.0, 1.01e4}};
  gear.scatter = {scatter};
  InspectionOptions options = options_of(60, 2 * kHour);
  options.growth.stop.time = 36;
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  options.times.every = 1 * kHour;
  const InspectionReport report = inspection_report(gear, options);
  EXPECT_GT(report.outcomes.refused, 15);
  EXPECT_LT(report.outcomes.refused, 45);
}

// Kind: cross-check (IR-3), (IR-7).  A drive with the inputs of a row has the life and the sizes of
// the row; the lives give the percentiles, and the outcomes their counts.  Tolerance: none, because
// a life is a function of the inputs.
TEST(InspectionReport, CrosscheckRowsAreLives) {
  const GearSet gear = scattering_shaft();
  const int draws = test::kSanitized ? 20 : 60;
  InspectionOptions options = options_of(draws);
  test::KeptRows rows;
  options.rows = &rows;
  const InspectionReport report = inspection_report(gear, options);
  ASSERT_EQ(rows.numbers.size(), static_cast<std::size_t>(draws));
  EXPECT_EQ(rows.head.seed, options.seed);
  std::vector<double> lives;
  for (std::size_t n = 0; n < rows.numbers.size(); ++n) {
    if (rows.status[n] != RowStatus::usable) continue;
    lives.push_back(rows.at(n, "life"));
    EXPECT_EQ(rows.at(n, "weight"), 1.0);
    if (n % 7 != 0) continue;
    GearSet one = gear;
    for (const InputScatter& input : gear.scatter)
      set_number(one, input.path, rows.at(n, input.path));
    const LifeTrace trace = life_trace(one, options.growth);
    ASSERT_TRUE(trace.life);
    EXPECT_EQ(rows.at(n, "life"), *trace.life);
    for (std::size_t k = 0; k < trace.cracks.size(); ++k)
      EXPECT_EQ(rows.at(n, trace.cracks[k] + ".size_at_end"), trace.sizes[k].back());
  }
  EXPECT_EQ(draws - static_cast<int>(lives.size()), report.outcomes.refused);
  std::ranges::sort(lives);
  EXPECT_EQ(
      *report.percentiles[2].life,
      lives[static_cast<std::size_t>(std::ceil(0.5 * static_cast<double>(lives.size()))) - 1]);
  double arrested = 0.0;
  for (std::size_t n = 0; n < rows.numbers.size(); ++n)
    if (rows.status[n] == RowStatus::usable) arrested += rows.at(n, "arrested");
  EXPECT_EQ(arrested, report.outcomes.arrested);
}

// Kind: behaviour.  A refused draw has its inputs and the reason; a study with too few lives hands
// its rows over before it is refused.  Draws about failures have their weights.
TEST(InspectionReport, BehaviourRowsOfRefusedDraws) {
  GearSet gear = scattering_shaft();
  InputScatter scatter = scatter_of("output_shaft.crack[0].depth", 0.1);
  scatter.relative_standard_deviation.reset();
  scatter.distribution = ScatterDistribution::table;
  scatter.quantile = {{0.0, 1e3}, {1.0, 1.1e3}};  // deeper than the wall
  gear.scatter = {scatter};
  test::KeptRows rows;
  InspectionOptions options = options_of(25, 100 * kHour);
  options.rows = &rows;
  EXPECT_NE(test::broken_rule([&] {
              (void)inspection_report(gear, options);
            }).find("lets 25 of 25 drawn drives break a rule"),
            std::string::npos);
  ASSERT_EQ(rows.numbers.size(), 25U);
  for (std::size_t n = 0; n < 25; ++n) {
    EXPECT_EQ(rows.status[n], RowStatus::refused);
    EXPECT_TRUE(rows.rules[n].starts_with("output_shaft.crack[0]")) << rows.rules[n];
    EXPECT_GT(rows.numbers[n][0], 0.1);
    EXPECT_TRUE(std::isnan(rows.at(n, "life")));
  }
}

InspectionOptions importance_of(int draws, double until) {
  InspectionOptions options = options_of(draws, until);
  options.importance_sampling = true;
  options.growth.tolerance = 1e-4;  // the search draws many lives
  return options;
}

// Kind: reference (IR-16), (UQ-10), (UQ-11).  Only C scatters, so ln L is normal, and four
// deviations before the life of the file the risk is Phi(-4).  The mean of the failures is
// phi(4)/Phi(-4) = 4.2256 deviations away.  Tolerance: the limits, 0.4 of the risk and 0.8 of the
// centre, three standard errors of 500 draws.
TEST(InspectionReport, ReferenceASmallRisk) {
  constexpr int kDraws = test::kSanitized ? 120 : 500;
  const GearSet gear = only_coefficient();
  const double sigma = std::sqrt(std::log1p(0.25 * 0.25));
  const double life = *inspection_report(gear, options_of(20)).nominal_life;
  const InspectionReport report =
      inspection_report(gear, importance_of(kDraws, life * std::exp(-4 * sigma)));
  constexpr double kExact = 3.16712e-5;
  EXPECT_LT(report.at_end.without_low, kExact);
  EXPECT_GT(report.at_end.without_high, kExact);
  if (!test::kSanitized) {
    test::expect_relative(report.at_end.without, kExact, 0.4);
    EXPECT_LT(report.at_end.without_high, 2 * kExact);
  }
  for (std::size_t i = 1; i < report.risk.size(); ++i) {
    EXPECT_GE(report.risk[i].without, report.risk[i - 1].without);
    EXPECT_GE(report.risk[i].without_high, report.risk[i - 1].without_high);
  }
  ASSERT_TRUE(report.importance_sampling);
  const DrawsAboutFailures& about = *report.importance_sampling;
  ASSERT_EQ(about.centres.size(), 1U);
  ASSERT_EQ(about.centres[0].inputs.size(), 1U);
  const FailureInput& input = about.centres[0].inputs[0];
  EXPECT_EQ(input.path, "material.steel.growth[0].coefficient");
  EXPECT_NEAR(input.deviations, 4.2256, 0.8);
  EXPECT_NEAR(about.centres[0].distance, input.deviations, 1e-12);
  test::expect_relative(input.at_centre, input.value * std::exp(sigma * input.deviations), 1e-9);
  EXPECT_EQ(about.plain_draws, kDraws / 2);
  EXPECT_EQ(about.plain, 0);
  EXPECT_NEAR(about.plain_high, 1 - std::pow(0.025, 2.0 / kDraws), 1e-12);
  EXPECT_NEAR(about.elsewhere, about.plain_high, 1e-12);
  // The median, and the share of the only input, are those of plain draws.
  EXPECT_LT(*report.percentiles[2].lower, life);
  EXPECT_GT(*report.percentiles[2].upper, life);
  test::expect_relative(*report.percentiles[2].life, life, 0.1);
  EXPECT_NEAR(report.shares[0].share, 1, 1e-3);
  const auto cites = [&](const char* tag) {
    return std::ranges::find(report.equations, tag) != report.equations.end();
  };
  EXPECT_TRUE(cites("IR-16") && cites("UQ-10") && cites("UQ-11"));
  EXPECT_FALSE(cites("IR-7"));
  EXPECT_TRUE(has(report, "inspection.importance"));
  EXPECT_FALSE(has(report, "inspection.draws"));
  const std::string text = inspection_text(report, gear);
  EXPECT_NE(text.find("half of them or more about failures"), std::string::npos);
  EXPECT_NE(text.find("Centres of the draws about failures"), std::string::npos);
}

// Kind: reference (IR-16), (UQ-10).  Two equal cracks whose depths scatter independently: a drive
// fails if one of them does, and the risk of one follows from the depth whose life is that up to
// the end of service.  Tolerance: the limits, and 0.3 of the risk, three standard errors.
TEST(InspectionReport, ReferenceTwoCracks) {
  GearSet gear = scattering_shaft();
  std::erase_if(gear.scatter, [](const InputScatter& scatter) {
    return scatter.path != "output_shaft.crack[0].depth";
  });
  ASSERT_EQ(gear.scatter.size(), 1U);
  const InspectionOptions options = importance_of(test::kSanitized ? 60 : 200, 300 * kHour);
  const double deviation = std::sqrt(std::log1p(0.3 * 0.3));
  double low = 0.0;
  double high = 6.0;
  while (high - low > 1e-3) {
    const double z = (low + high) / 2;
    GearSet deep = gear;
    deep.scatter.clear();
    set_number(deep, "output_shaft.crack[0].depth", 0.5e-3 * std::exp(deviation * z));
    (*life_trace(deep, options.growth).life > *options.until ? low : high) = z;
  }
  const double sound = normal_probability(low);
  const double exact = 1 - sound * sound;
  gear.output_shaft->crack.push_back(gear.output_shaft->crack.front());
  gear.scatter.push_back(scatter_of("output_shaft.crack[1].depth", 0.3));
  const InspectionReport report = inspection_report(gear, options);
  ASSERT_GE(report.importance_sampling->centres.size(), 2U);
  EXPECT_NE(report.importance_sampling->centres[0].inputs[0].path,
            report.importance_sampling->centres[1].inputs[0].path);
  EXPECT_LT(report.at_end.without_low, exact);
  EXPECT_GT(report.at_end.without_high, exact);
  if (!test::kSanitized) test::expect_relative(report.at_end.without, exact, 0.3);
}

// Kind: cross-check (IR-16).  Where both can be had, plain draws and draws about the failures
// agree, without and with inspections, in percentiles and cost.  Tolerance: their limits overlap;
// shares and cost by the scatter of the draws, which is twice as large for a quarter of them.
TEST(InspectionReport, CrosscheckPlainDrawsAndDrawsAboutFailures) {
  GearSet gear = scattering_shaft();
  gear.inspection = Inspection{
      .a50 = 1e-3, .a90 = 2e-3, .cost = InspectionCost{.inspection = 1, .call = 5, .failure = 100}};
  const double life = *inspection_report(gear, options_of(20)).nominal_life;
  InspectionOptions plain = options_of(test::kSanitized ? 200 : 800, 0.6 * life);
  plain.times.every = 0.2 * life;
  InspectionOptions about = plain;
  about.draws = plain.draws / 2;
  about.importance_sampling = true;
  constexpr double kFewer = test::kSanitized ? 2 : 1;  // root of the ratio of draws
  const InspectionReport one = inspection_report(gear, plain);
  const InspectionReport two = inspection_report(gear, about);
  ASSERT_GT(one.at_end.without, 0.005);
  EXPECT_LT(one.at_end.without, 0.15);
  EXPECT_LT(std::max(one.at_end.without_low, two.at_end.without_low),
            std::min(one.at_end.without_high, two.at_end.without_high));
  EXPECT_LT(std::max(*one.at_end.inspected_low, *two.at_end.inspected_low),
            std::min(*one.at_end.inspected_high, *two.at_end.inspected_high));
  if (!test::kSanitized) {
    EXPECT_LT(two.at_end.without_high - two.at_end.without_low,
              one.at_end.without_high - one.at_end.without_low);
  }
  for (std::size_t i = 0; i < one.percentiles.size(); ++i) {
    ASSERT_TRUE(one.percentiles[i].upper && two.percentiles[i].upper) << i;
    EXPECT_LT(std::max(*one.percentiles[i].lower, *two.percentiles[i].lower),
              std::min(*one.percentiles[i].upper, *two.percentiles[i].upper));
    EXPECT_LE(*two.percentiles[i].lower, *two.percentiles[i].life);
    EXPECT_LE(*two.percentiles[i].life, *two.percentiles[i].upper);
  }
  for (std::size_t i = 0; i < one.shares.size(); ++i) {
    const auto same = std::ranges::find(two.shares, one.shares[i].path, &LifeShare::path);
    ASSERT_NE(same, two.shares.end());
    EXPECT_NEAR(same->share, one.shares[i].share, 0.12 * kFewer);
  }
  test::expect_relative(*two.cost->inspected, *one.cost->inspected, 0.1 * kFewer);
  test::expect_relative(two.cost->without, 100 * two.at_end.without, 1e-12);
  test::expect_relative(*two.cost->failures, 100 * *two.at_end.inspected, 1e-12);
}

// Kind: identity (IR-16), (UQ-8).  Inputs that depend on each other: the distance of the centre is
// that of the independent variables, and the risk is that of plain draws.  Tolerance: the limits
// overlap.
TEST(InspectionReport, IdentityCorrelatedInputsOfImportanceSampling) {
  GearSet gear = scattering_shaft();
  gear.scatter.resize(2);
  constexpr double kRank = 0.7;
  gear.correlation = {{.path = gear.scatter[0].path,
                       .with = gear.scatter[1].path,
                       .rank_correlation = kRank,
                       .source = "test"}};
  const InspectionReport about =
      inspection_report(gear, importance_of(test::kSanitized ? 60 : 300, 330 * kHour));
  const InspectionReport plain =
      inspection_report(gear, options_of(test::kSanitized ? 200 : 400, 330 * kHour));
  EXPECT_LT(std::max(about.at_end.without_low, plain.at_end.without_low),
            std::min(about.at_end.without_high, plain.at_end.without_high));
  EXPECT_GT(plain.at_end.without, 0.005);
  const CentreOfFailures& centre = about.importance_sampling->centres[0];
  const double a = centre.inputs[0].deviations;
  const double b = centre.inputs[1].deviations;
  const double r = 2 * std::sin(std::numbers::pi / 6 * kRank);  // (UQ-8)
  EXPECT_NEAR((a * a - 2 * r * a * b + b * b) / (1 - r * r), centre.distance * centre.distance,
              1e-9);
}

// Kind: identity (IR-16), (IR-7).  Nearly all cracks stand still, and the failures are found: the
// risk is that of plain draws, and the median life is endless.
TEST(InspectionReport, IdentityArrestAndImportanceSampling) {
  GearSet gear = scattering_shaft();
  gear.scatter.erase(gear.scatter.begin());  // of the coefficient
  gear.scatter.resize(1);
  gear.material.at("steel").growth_bounds.emplace().threshold = 9e6;
  const double until = 250 * kHour;
  constexpr int kPlain = test::kSanitized ? 500 : 2000;
  const InspectionReport about =
      inspection_report(gear, importance_of(test::kSanitized ? 100 : 200, until));
  const InspectionReport plain = inspection_report(gear, options_of(kPlain, until));
  EXPECT_GT(plain.outcomes.arrested, 0.9 * kPlain);
  EXPECT_LT(std::max(about.at_end.without_low, plain.at_end.without_low),
            std::min(about.at_end.without_high, plain.at_end.without_high));
  EXPECT_GT(about.at_end.without_low, 0);
  EXPECT_FALSE(about.percentiles[2].life);
  EXPECT_FALSE(about.percentiles[2].upper);
  EXPECT_GT(about.outcomes.arrested, test::kSanitized ? 25 : 50);
}

// Kind: identity (IR-16), (IR-4).  Shares of weighted draws by any number of threads make the same
// answer, and weights count in what inspections find.
TEST(InspectionReport, IdentitySharesOfImportanceSampling) {
  GearSet gear = only_coefficient();
  gear.inspection = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  // Each share searches for the failures, and failures that are less rare are found in fewer
  // rounds.
  constexpr int kParts = test::kSanitized ? 1 : 2;
  InspectionOptions options = importance_of(60, (test::kSanitized ? 450 : 330) * kHour);
  options.times.at = {150 * kHour};
  options.threads = 1;
  const InspectionReport whole = inspection_report(gear, options);
  std::string bytes;
  for (int part = 1; part <= kParts; ++part) {
    SharedRows share(Share{.part = part, .parts = kParts});
    options.shared = &share;
    options.threads = part + 1;
    EXPECT_THROW((void)inspection_report(gear, options), ShareDone);
    bytes += share.bytes();
  }
  SharedRows all(60, bytes);
  options.shared = &all;
  const InspectionReport merged = inspection_report(gear, options);
  EXPECT_EQ(merged.at_end.without, whole.at_end.without);
  EXPECT_EQ(merged.at_end.inspected, whole.at_end.inspected);
  EXPECT_EQ(merged.percentiles[2].life, whole.percentiles[2].life);
  // Half of the draws fail, and yet nearly all drives are in service at the inspection.
  EXPECT_GT(whole.outcomes.failed, 15);
  ASSERT_EQ(whole.inspections.size(), 1U);
  EXPECT_GT(whole.inspections[0].in_service, 0.99);
  EXPECT_NEAR(whole.inspections[0].remaining, *whole.at_end.inspected, 1e-15);
  const DrawnPart nominal = [&] {
    const LifeTrace trace = life_trace(gear, options.growth);
    return DrawnPart{.failure = *trace.life, .times = trace.times, .sizes = trace.sizes};
  }();
  const double found = nominal.found_at(
      150 * kHour, DetectionCurve(DetectionForm::log_logistic, 1e-3, 2e-3), {true});
  EXPECT_NEAR(whole.inspections[0].found, found, 0.5 * found);
}

// Kind: input.  Draws about failures need rare failures, and some.
TEST(InspectionReport, InputOfImportanceSampling) {
  const GearSet gear = only_coefficient();
  const auto message = [&](double until) {
    return test::broken_rule([&] { return inspection_report(gear, importance_of(20, until)); });
  };
  EXPECT_NE(message(2000 * kHour).find("importance-sampling: is for rare failures, but the drive"),
            std::string::npos)
      << message(2000 * kHour);
  EXPECT_NE(message(1 * kHour).find("no failure is nearer than 8 standard deviations"),
            std::string::npos)
      << message(1 * kHour);
  InspectionOptions without_end = importance_of(20, kHour);
  without_end.until.reset();
  const std::string needs = test::broken_rule([&] { return inspection_report(gear, without_end); });
  EXPECT_NE(needs.find("importance-sampling: needs --until"), std::string::npos) << needs;
}

/// The shaft without [[scatter]], whose growth scatters.
GearSet scattered_growth(const GrowthScatter& scatter) {
  GearSet gear = scattering_shaft();
  gear.scatter.clear();
  gear.material.at("steel").growth_scatter = scatter;
  check(gear);
  return gear;
}

// Kind: identity (GS-12).  The level alone is a log-normal coefficient of the law, with the same
// numbers.  Tolerance: rounding, which moves the steps of the growth.
TEST(InspectionReport, IdentityLevelIsAScatteringCoefficient) {
  constexpr int kDraws = test::kSanitized ? 20 : 60;
  const InspectionReport by_scatter = inspection_report(only_coefficient(), options_of(kDraws));
  const InspectionReport by_level = inspection_report(
      scattered_growth({.level = std::sqrt(std::log1p(0.25 * 0.25))}), options_of(kDraws));
  EXPECT_EQ(by_level.outcomes.failed, by_scatter.outcomes.failed);
  for (std::size_t i = 0; i < by_scatter.percentiles.size(); ++i)
    test::expect_relative(*by_level.percentiles[i].life, *by_scatter.percentiles[i].life, 1e-9);
  ASSERT_EQ(by_level.shares.size(), by_scatter.shares.size());
  for (const LifeShare& share : by_level.shares) {
    EXPECT_EQ(share.path, "material.steel.growth_scatter.level");
    EXPECT_NEAR(share.share, 1, 1e-3);
  }
}

// Kind: identity (GS-13).  Lives with paths have the same bits for any number of threads and from
// shares, and others with another seed.
TEST(InspectionReport, IdentityPathsOnThreadsAndInShares) {
  const GearSet gear = scattered_growth({.level = 0.1,
                                         .level_correlation = 0.5,
                                         .wander = 0.3,
                                         .wander_length = 0.5,
                                         .white = 0.2,
                                         .white_step = 0.5e-3});
  InspectionOptions options = options_of(20, 300 * kHour);
  options.threads = 1;
  const InspectionReport one = inspection_report(gear, options);
  options.threads = 3;
  const InspectionReport three = inspection_report(gear, options);
  std::string bytes;
  for (int part = 1; part <= 2; ++part) {
    SharedRows share(Share{.part = part, .parts = 2});
    options.shared = &share;
    EXPECT_THROW((void)inspection_report(gear, options), ShareDone);
    bytes += share.bytes();
  }
  SharedRows all(20, bytes);
  options.shared = &all;
  const InspectionReport merged = inspection_report(gear, options);
  options.shared = nullptr;
  options.seed = 2;
  const InspectionReport other = inspection_report(gear, options);
  for (std::size_t i = 0; i < one.percentiles.size(); ++i) {
    EXPECT_EQ(one.percentiles[i].life, three.percentiles[i].life);
    EXPECT_EQ(one.percentiles[i].life, merged.percentiles[i].life);
    EXPECT_NE(one.percentiles[i].life, other.percentiles[i].life);
  }
}

// Kind: crosscheck (GS-13).  The failure ends the path at the same size in all draws, so mean and
// deviation of the life follow from the times of median growth and the covariance of the
// deviations.  Tolerance: four standard errors of the draws.
TEST(InspectionReport, CrosscheckMomentsOfTheLife) {
  constexpr int kDraws = test::kSanitized ? 20 : 200;
  const double wander = 0.3;
  const double length = 0.4;
  const GearSet gear = scattered_growth({.wander = wander, .wander_length = length});
  const LifeTrace median = life_trace(gear, options_of(20).growth);
  std::vector<double> shares;
  std::vector<double> middles;
  for (std::size_t i = 1; i < median.times.size(); ++i) {
    shares.push_back((median.times[i] - median.times[i - 1]) / *median.life);
    middles.push_back(std::log(median.sizes[0][i] * median.sizes[0][i - 1]) / 2);
  }
  double second = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (std::size_t k = 0; k < shares.size(); ++k)
      second += shares[i] * shares[k] *
                std::expm1(wander * wander * std::exp(-std::abs(middles[i] - middles[k]) / length));
  const double mean = std::exp(wander * wander / 2);
  const double deviation = std::exp(wander * wander / 2) * std::sqrt(second);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    const DrawnGrowth drawn{.draw = draw};
    const double life = *life_trace(gear, options_of(20).growth, &drawn).life / *median.life;
    sum += life / kDraws;
    squares += (life - mean) * (life - mean) / kDraws;
  }
  EXPECT_NEAR(sum, mean, 4 * deviation / std::sqrt(kDraws));
  EXPECT_NEAR(std::sqrt(squares), deviation, 4 * deviation / std::sqrt(kDraws));
  EXPECT_GT(deviation, 0.1);
}

// Kind: identity (UQ-8).  The level of a material is a number that scatters, behind those of
// [[scatter]], and a correlation may name it.
TEST(InspectionReport, IdentityCorrelatedLevel) {
  GearSet gear = scattering_shaft();
  gear.scatter.resize(1);
  gear.scatter[0].path = "output_shaft.crack[0].depth";
  gear.material.at("steel").growth_scatter = GrowthScatter{.level = 0.2};
  gear.correlation = {{.path = "output_shaft.crack[0].depth",
                       .with = "material.steel.growth_scatter.level",
                       .rank_correlation = -0.5,
                       .source = {}}};
  check(gear);
  EXPECT_EQ(scattering_normals(gear).size(), 1U);
  const CorrelatedNormals normals = life_normals(gear);
  ASSERT_EQ(normals.size(), 2U);
  test::expect_relative(normals.correlation(0, 1), 2 * std::sin(-std::numbers::pi / 12), 1e-12);
  // A deep crack in slow steel: the lives differ less than with independent numbers.
  const auto spread = [](const GearSet& of) {
    const InspectionReport report = inspection_report(of, options_of(40));
    return std::log(*report.percentiles[3].life / *report.percentiles[1].life);
  };
  GearSet independent = gear;
  independent.correlation.clear();
  EXPECT_LT(spread(gear), 0.9 * spread(independent));
}

// Kind: behaviour (IR-16).  The search for failures takes the level as a number, and the draws
// about the failures have paths.
TEST(InspectionReport, BehaviourFailuresByTheLevel) {
  if (test::kSanitized) return;  // the search takes thousands of lives
  const GearSet gear = scattered_growth({.level = 0.2, .wander = 0.2, .wander_length = 0.5});
  const double life = *life_trace(gear, options_of(20).growth).life;
  InspectionOptions options = options_of(100, life * std::exp(-0.6));
  options.importance_sampling = true;
  const InspectionReport report = inspection_report(gear, options);
  ASSERT_TRUE(report.importance_sampling);
  const FailureInput& input = report.importance_sampling->centres.front().inputs.front();
  EXPECT_EQ(input.path, "material.steel.growth_scatter.level");
  EXPECT_NEAR(input.deviations, 3, 0.5);
  EXPECT_NEAR(input.at_centre, 0.6, 0.1);
  // The path adds to the deviation 0.2 of the level, and shifts the median: P is above 0.00135.
  EXPECT_GT(report.at_end.without, 0.0005);
  EXPECT_LT(report.at_end.without, 0.02);
}

// Kind: behaviour.  The documents contain the curve and all tables.
TEST(InspectionReport, BehaviourDocuments) {
  const GearSet gear = scattering_shaft();
  InspectionOptions options = options_of(60, 450 * kHour);
  options.method = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  options.times.risk = 0.05;
  const InspectionReport report = inspection_report(gear, options);
  const std::string text = inspection_text(report, gear);
  for (const char* const title : {"Outcomes of 60 drawn drives", "Percentiles of the life",
                                  "Inspections (IR-2)", "Fewest inspections"})
    EXPECT_NE(text.find(title), std::string::npos) << title;
  EXPECT_EQ(std::ranges::count(inspection_csv(report), '\n'), 62);
  EXPECT_NE(inspection_plot(report, gear).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

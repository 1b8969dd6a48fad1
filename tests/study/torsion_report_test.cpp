// SPDX-License-Identifier: Apache-2.0 Output of `strainwave torsion`: text, JSON, CSV, plot, bands.
#include "strainwave/study/torsion_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/torsion.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/table.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::json;

GearSet drive() {
  GearSet gear = test::typical_drive(25, 100);
  gear.rating = Rating{.T1 = 14, .T2 = 48, .T3 = {}, .rated_torque = 87};
  gear.load.torque = 48;
  return gear;
}

GearSet cracked() {
  GearSet gear = drive();
  gear.flexspline->crack.push_back(DiaphragmArcCrack{.half_length = 6e-3, .radius = {}});
  return gear;
}

InputRange range(const char* path, const char* lower, const char* upper) {
  return {.path = path, .lower = lower, .upper = upper, .source = {}};
}

TEST(TorsionReport, IdentityItsNumbersAreThoseOfTheModule) {
  const TorsionReport report = torsion_report(drive());
  const MakersLines lines = makers_lines(drive());
  EXPECT_EQ(report.positive.K1, lines.K1);
  EXPECT_EQ(report.negative.K3, makers_lines(drive(), -1).K3);
  EXPECT_EQ(report.lost_motion, lost_motion(drive()));
  EXPECT_EQ(report.loop.amplitude, 87.0);
  ASSERT_EQ(report.shown.size(), 3U);
  // T1, T2, which is the load, and T_N are points of the curve, so its lines can be checked by
  // hand.
  const auto at = [&](std::size_t i) { return report.curve.points[report.shown[i]]; };
  EXPECT_EQ(at(0).torque, 14.0);
  EXPECT_EQ(at(1).torque, 48.0);
  EXPECT_EQ(at(2).torque, 87.0);
  // On the finer path contacts touch in another order, so results agree to the tolerance of the
  // solver.
  test::expect_relative(at(0).torque / at(0).twist, lines.K1, 1e-9);
  test::expect_relative((48 - 14) / (at(1).twist - at(0).twist), lines.K2, 1e-9);
  EXPECT_FALSE(report.bands.has_value());
  EXPECT_FALSE(report.comparison.has_value());
}

TEST(TorsionReport, BehaviourWhatNoWorkingDriveHasIsNoted) {
  const auto has = [](const TorsionReport& report, std::string_view code) {
    return test::count_notes(report.notes, code) == 1;
  };
  const TorsionReport sound = torsion_report(drive());
  for (const char* const code : {"torsion.assembly_force", "torsion.lost_motion",
                                 "torsion.falling_stiffness", "torsion.less_lost_motion"})
    EXPECT_FALSE(has(sound, code)) << code;
  GearSet few = drive();
  few.wave_generator->bearing->ball_count = 5;
  EXPECT_TRUE(has(torsion_report(few), "torsion.assembly_force"));
  GearSet loose = drive();
  loose.mesh->lobe_gap = 200e-6;
  EXPECT_TRUE(has(torsion_report(loose), "torsion.lost_motion"));
  GearSet tight = drive();
  tight.mesh->lobe_gap = -50e-6;
  EXPECT_TRUE(has(torsion_report(tight), "torsion.falling_stiffness"));
  // Flanks that press without torque have friction there, and the loss contains it.
  const auto loss_of = [](const TorsionReport& report) {
    return std::ranges::find(report.notes, "hysteresis.no_load", &Note::code)->text;
  };
  EXPECT_EQ(sound.curve.assembly_flank_force, 0.0);
  EXPECT_GT(torsion_report(tight).curve.assembly_flank_force, 100.0);
  EXPECT_NE(loss_of(torsion_report(tight)).find("flanks, which press on each other without torque"),
            std::string::npos);
  EXPECT_NE(loss_of(sound).find("flanks carry nothing without torque"), std::string::npos);
  EXPECT_EQ(sound.friction.loss_at_zero.flanks, 0.0);
  EXPECT_FALSE(has(sound, "hysteresis.large_loss"));
  const TorsionReport jammed = torsion_report(tight);
  EXPECT_GT(jammed.friction.loss_at_zero.flanks, 0.5 * units::arcmin);
  EXPECT_TRUE(has(jammed, "hysteresis.large_loss"));
  // A crack of the outer ring between the lobes gives back part of the bending of the assembly.
  GearSet cracked = drive();
  OuterRaceCrack crack;
  crack.depth = 0.5 * cracked.wave_generator->bearing->outer_ring->thickness;
  bool noted = false;
  for (const double degrees : {50.0, 60.0, 70.0, 80.0, 90.0}) {
    crack.position = degrees * units::deg;
    cracked.wave_generator->crack = {crack};
    const TorsionReport report = torsion_report(cracked, {.compare = true, .angles = 1});
    const bool less =
        report.comparison->lost_motion_cracked < report.comparison->lost_motion_sound * (1 - 1e-9);
    EXPECT_EQ(has(report, "torsion.less_lost_motion"), less) << degrees;
    noted = noted || less;
  }
  EXPECT_TRUE(noted);
}

TEST(TorsionReport, IdentityItsLossesAreThoseOfTheModule) {
  GearSet gear = drive();
  gear.rating->friction_torque = 0.5;
  const TorsionReport report = torsion_report(gear);
  const FrictionReport& friction = report.friction;
  // The loop at rated torque has reached both envelopes before it comes to zero torque.
  test::expect_relative(friction.loss_at_zero.total(), report.loop.width_at_zero, 1e-9);
  EXPECT_GT(friction.loss_at_zero.output, 0.5 * report.loop.width_at_zero);
  const AssembledDrive assembled(gear);
  EXPECT_EQ(friction.no_load.total(), no_load_torque(assembled).total());
  EXPECT_EQ(friction.back_driving_torque, back_driving_torque(assembled));
  EXPECT_EQ(friction.no_load.output, 0.5 / 100);
  const std::string text = torsion_text(report, gear, {});
  for (const char* const line :
       {"loss at zero torque", "no-load torque at the input", "back-driving torque at the output"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  // A drive that cannot be driven back says so.
  gear.mesh->lobe_gap = -50e-6;
  EXPECT_NE(torsion_text(torsion_report(gear), gear, {}).find("above the rated torque"),
            std::string::npos);
}

TEST(TorsionReport, IdentityTheCageMovesOn) {
  // The lines over the phases of the cage contain those of the report, and --cage-phase moves the
  // first of them.
  const TorsionReport report = torsion_report(drive(), {.cage_phase = 0.05});
  ASSERT_EQ(report.over_cage.phases.size(), 12U);
  EXPECT_EQ(report.over_cage.phases[0], 0.05);
  EXPECT_EQ(report.over_cage.at_phase[0].K1, report.positive.K1);
  EXPECT_NE(report.positive.K1, torsion_report(drive()).positive.K1);
  EXPECT_GT(report.over_cage.stiffest.K2, report.over_cage.softest.K2);
}

TEST(TorsionReport, BehaviourNotesAndEquations) {
  const auto has = [](const TorsionReport& report, std::string_view code) {
    return std::ranges::count(report.notes, code, &Note::code);
  };
  GearSet gear = cracked();
  gear.rating.reset();
  const TorsionReport report = torsion_report(gear);
  EXPECT_EQ(has(report, "rating.convention"), 1);
  EXPECT_EQ(has(report, "torsion.compare"), 1);
  EXPECT_EQ(has(report, "hysteresis.no_load"), 1);
  const TorsionReport compared = torsion_report(cracked(), {.compare = true, .angles = 2});
  EXPECT_EQ(has(compared, "rating.convention"), 0);
  EXPECT_EQ(has(compared, "torsion.compare"), 0);
  EXPECT_EQ(std::ranges::count(compared.equations, "TC-26"), 1);
  gear = drive();
  gear.rating->friction_torque = 0.2;
  EXPECT_EQ(has(torsion_report(gear), "hysteresis.no_load"), 0);
}

TEST(TorsionBands, IdentityOfOneMonotonicInput) {
  // K decreases with the compliance of the flange, so its quantiles are K at the quantiles of the
  // input; 400 draws determine a quantile to about 2 % of the range.
  GearSet gear = drive();
  gear.flexspline->flange_compliance = 5e-7;
  gear.range.push_back(range("flexspline.flange_compliance", "0 rad/(N*m)", "1e-6 rad/(N*m)"));
  const LineBands bands = line_bands(AssembledDrive(gear), {.draws = 400});
  EXPECT_EQ(bands.draws, 400);
  EXPECT_EQ(bands.rejected, 0);
  const auto K2_at = [&](double compliance) {
    GearSet at = gear;
    at.range.clear();
    at.flexspline->flange_compliance = compliance;
    return makers_lines(at).K2;
  };
  const double width = K2_at(0) - K2_at(1e-6);
  EXPECT_NEAR(bands.K2.low, K2_at(0.95e-6), 0.03 * width);
  EXPECT_NEAR(bands.K2.median, K2_at(0.50e-6), 0.06 * width);
  EXPECT_NEAR(bands.K2.high, K2_at(0.05e-6), 0.03 * width);
}

TEST(TorsionBands, BehaviourReproducibleAndRejecting) {
  GearSet gear = drive();
  gear.range.push_back(range("mesh.coning", "0.1", "1"));
  const LineBands a = line_bands(AssembledDrive(gear), {.draws = 20, .threads = 1});
  const LineBands b = line_bands(AssembledDrive(gear), {.draws = 20, .threads = 3});
  EXPECT_EQ(a.K1.low, b.K1.low);
  EXPECT_EQ(a.K3.high, b.K3.high);
  EXPECT_LT(a.K1.low, a.K1.median);
  EXPECT_LT(a.K1.median, a.K1.high);
  // Half of these outer rings do not fit the bore.
  const double fits = gear.wave_generator->bearing->outer_ring->mean_radius;
  const std::string upper = std::to_string(1.01e3 * fits) + " mm";
  const std::string lower = std::to_string(0.999e3 * fits) + " mm";
  gear.range.push_back(
      range("wave_generator.bearing.outer_ring.mean_radius", lower.c_str(), upper.c_str()));
  const LineBands some = line_bands(AssembledDrive(gear), {.draws = 40});
  EXPECT_GT(some.rejected, 5);
  EXPECT_EQ(some.rejected + some.draws, 40);
  EXPECT_THROW((void)line_bands(AssembledDrive(gear), {.draws = 0}), SolverError);
}

TEST(TorsionBands, BehaviourSharesGrowToOneAndAStopEndsIt) {
  GearSet gear = drive();
  gear.range.push_back(range("mesh.coning", "0.1", "1"));
  const AssembledDrive assembled(gear);
  std::vector<double> shares;
  (void)line_bands(assembled, {.draws = 8, .threads = 2}, Progress([&](double share) {
                     shares.push_back(share);
                     return true;
                   }));
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_DOUBLE_EQ(shares.back(), 1.0);
  // The largest number of draws, so only a stop ends it in time.
  int told = 0;
  EXPECT_THROW((void)line_bands(assembled, {.draws = 100000, .threads = 2},
                                Progress([&](double) { return ++told < 2; })),
               Stopped);
  EXPECT_EQ(told, 2);
}

// Kind: identity (TC-26).  The rows of a comparison are its positions, not the draws of ranges.
TEST(TorsionReport, IdentityRowsOfAComparison) {
  GearSet gear = drive();
  RimAxialCrack rim;
  rim.depth = 0.1e-3;
  gear.flexspline->crack.emplace_back(rim);
  gear.range.push_back(range("mesh.coning", "0.1", "1"));
  test::KeptRows rows;
  const TorsionReport report =
      torsion_report(gear, {.compare = true, .angles = 4, .draws = 2, .rows = &rows});
  ASSERT_TRUE(report.comparison && report.bands);
  EXPECT_EQ(rows.head.of, "positions of the wave generator");
  EXPECT_FALSE(rows.head.seed);
  EXPECT_EQ(rows.columns(),
            (std::vector<std::pair<std::string, std::string>>{{"angle", "rad"},
                                                              {"positive.K1", "1"},
                                                              {"positive.K2", "1"},
                                                              {"positive.K3", "1"},
                                                              {"negative.K1", "1"},
                                                              {"negative.K2", "1"},
                                                              {"negative.K3", "1"}}));
  ASSERT_EQ(rows.numbers.size(), 4U);
  for (std::size_t n = 0; n < 4; ++n) {
    const LineChanges& positive = report.comparison->positive.at_angle[n];
    const LineChanges& negative = report.comparison->negative.at_angle[n];
    EXPECT_EQ(rows.numbers[n], (std::vector{report.comparison->angles[n], positive.K1, positive.K2,
                                            positive.K3, negative.K1, negative.K2, negative.K3}));
    EXPECT_EQ(rows.status[n], RowStatus::usable);
  }
}

TEST(TorsionText, BehaviourTablesAndUnits) {
  GearSet gear = cracked();
  gear.name = "My drive";
  gear.range.push_back(range("mesh.coning", "0.5", "1"));
  const TorsionReport report = torsion_report(gear, {.compare = true, .angles = 2, .draws = 10});
  const std::string text = torsion_text(
      report, gear,
      {.version = "1.2", .revision = {}, .input_file = "my.toml", .quadrature_tolerance = 0});
  for (const char* const part :
       {"My drive\n", "T1 = 14, T2 = 48, T3 = 76.8, rated 87 N*m\n", "K1 [N*m/rad]",
        "90 % of the ranges", "10 drives drawn from 1 range\n", "my.toml, strainwave 1.2\n",
        "lost motion [arcmin]", "largest loop width [arcmin]", "tangent K [N*m/rad]",
        "teeth in contact of 200", "share of the tangent compliance",
        "rim at the tooth roots, hoop", "over a turn of the wave generator at 87 N*m",
        "series cracks", "Change of stiffness by the cracks, at 1 position", "a member in series",
        "(TC-26)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find(" \n"), std::string::npos);  // no trailing blanks
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    EXPECT_LE(end - begin, 100U) << text.substr(begin, end - begin);
    begin = end + 1;
  }
}

TEST(TorsionJson, BehaviourEverythingIsThere) {
  const GearSet gear = cracked();
  const TorsionReport report = torsion_report(gear, {.compare = true, .angles = 3});
  const Json json = Json::parse(json_of(report));
  EXPECT_EQ(json["positive"]["K1"]["value"].get<double>(), report.positive.K1);
  EXPECT_EQ(json["positive"]["K1"]["unit"], "N*m/rad");
  EXPECT_EQ(json["torques"]["rated"]["value"].get<double>(), 87.0);
  const Json& points = json["curve"]["points"];
  EXPECT_EQ(points["torque"]["unit"], "N*m");
  EXPECT_EQ(points["torque"]["values"].size(), report.curve.points.size());
  double sum = 0.0;
  for (const auto& [name, share] : points["share"].items())
    sum += share["values"].back().get<double>();
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(points["balls"]["force"]["values"][3].size(), 23U);
  EXPECT_EQ(json["comparison"]["crack_class"], "series");
  EXPECT_EQ(json["comparison"]["positive"]["at_angle"]["K1"]["values"].size(), 1U);
  EXPECT_EQ(json["hysteresis"]["torque"]["values"].size(), report.loop.torque.size());
  EXPECT_FALSE(evidence_of(report).notes.empty());
  const Json& stress = json["rim"]["rim_outside_stress"];
  EXPECT_EQ(stress["unit"], "Pa");
  ASSERT_EQ(stress["values"].size(), 180U);
  const std::vector<RimState> rim = rim_states(gear, 87, 180);
  EXPECT_EQ(stress["values"][17].get<double>(), rim[17].rim_outside_stress);
}

TEST(TorsionCsv, BehaviourBothSensesInOrder) {
  const TorsionReport report = torsion_report(drive());
  const std::string csv = torsion_csv(report);
  const auto lines = static_cast<std::size_t>(std::ranges::count(csv, '\n'));
  EXPECT_EQ(lines, 1 + report.curve.points.size() + report.curve_negative.points.size());
  EXPECT_TRUE(csv.starts_with("torque [N*m],twist [rad],"));
  EXPECT_NE(csv.find("\n-87,"), std::string::npos);
}

TEST(TorsionCsv, BehaviourAComparisonIsInIt) {
  const TorsionReport report = torsion_report(cracked(), {.compare = true, .angles = 3});
  const std::string csv = torsion_csv(report);
  EXPECT_TRUE(csv.starts_with(
      "part,torque [N*m],twist [rad],tangent_stiffness [N*m/rad],teeth_in_contact,balls_in_contact,"
      "sound_twist [rad],sound_tangent_stiffness [N*m/rad],angle [rad],positive.K1_change [1],"));
  const CurvePoint& sound = report.sound.points.back();
  EXPECT_NE(csv.find(fmt::format(",{},{},,,", exact_text(sound.twist),
                                 exact_text(sound.tangent_stiffness()))),
            std::string::npos)
      << csv;
  const LineChanges& change = report.comparison->negative.at_angle.at(0);
  EXPECT_NE(csv.find(fmt::format("{},{},{}\n", exact_text(change.K1), exact_text(change.K2),
                                 exact_text(change.K3))),
            std::string::npos);
  // Every row has as many cells as the head.
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);)
    EXPECT_EQ(std::ranges::count(line, ','), 14) << line;
}

TEST(TorsionReport, IdentityTwistAtTheLoad) {
  GearSet gear = drive();
  gear.load.torque = -31;
  const TorsionReport report = torsion_report(gear, {.draws = 0});
  EXPECT_EQ(report.at_load.torque, 31);
  test::expect_relative(report.at_load.positive.value(), twists(AssembledDrive(gear), {{31.0}})[0],
                        1e-12);
  test::expect_relative(report.at_load.negative.value(),
                        -twists(AssembledDrive(gear), {{-31.0}})[0], 1e-12);
  EXPECT_NE(torsion_text(report, gear, {}).find("twist at 31 N*m, the load [arcmin]"),
            std::string::npos);
  EXPECT_NE(torsion_csv(report).find("\n31,"), std::string::npos);
  EXPECT_NE(torsion_csv(report).find("\n-31,"), std::string::npos);
}

TEST(TorsionReport, InputALoadThatIsNotReachedIsSaid) {
  GearSet gear = drive();
  gear.load.torque = 1e5;
  const TorsionReport report = torsion_report(gear, {.draws = 0});
  EXPECT_FALSE(report.at_load.positive);
  EXPECT_EQ(test::count_notes(report.notes, "curve.no_wind_up", "load.torque"), 1);
  EXPECT_NE(torsion_text(report, gear, {}).find("not reached"), std::string::npos);
}

TEST(TorsionPlot, BehaviourPanels) {
  const TorsionReport plain = torsion_report(drive());
  const std::string svg = torsion_plot(plain, drive());
  EXPECT_NE(svg.find("Tangent stiffness"), std::string::npos);
  EXPECT_EQ(svg.find("over a turn"), std::string::npos);
  const TorsionReport compared = torsion_report(cracked(), {.compare = true, .angles = 3});
  const std::string both = torsion_plot(compared, cracked());
  EXPECT_NE(both.find("over a turn"), std::string::npos);
  EXPECT_NE(both.find(">sound<"), std::string::npos);
  EXPECT_NE(both.find(">with cracks<"), std::string::npos);
}

// The last panels show each ball and each flank in contact once, at its angle from the nearest of
// two lobes, with a gap in the line between the lobes.  200 teeth are alike at both lobes.
TEST(TorsionPlot, CrosscheckForcesAreThoseOfTheContacts) {
  const TorsionReport report = torsion_report(drive(), {.draws = 0});
  const std::vector<PlotPanel> panels = torsion_panels(report, drive());
  const PlotPanel& balls = panels.at(panels.size() - 2);
  const PlotPanel& flanks = panels.back();
  EXPECT_EQ(balls.title, "Forces of the balls");
  EXPECT_EQ(flanks.title, "Forces of the flanks");
  const auto at_T2 = std::ranges::find(report.curve.points, report.torques.T2, &CurvePoint::torque);
  ASSERT_NE(at_T2, report.curve.points.end());
  const auto expect_shown = [](const PlotSeries& series,
                               const std::vector<ContactForce>& contacts) {
    std::vector<double> shown;
    long gaps = 0;
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      gaps += std::isnan(series.y[i]);
      if (std::isnan(series.y[i])) continue;
      shown.push_back(series.y[i]);
      EXPECT_LE(std::abs(series.x[i]), 90.0);
      EXPECT_FALSE(i > 0 && series.x[i] < series.x[i - 1]);
    }
    std::vector<double> forces;
    for (const ContactForce& contact : contacts) forces.push_back(contact.force);
    std::ranges::sort(shown);
    std::ranges::sort(forces);
    EXPECT_EQ(shown, forces);
    EXPECT_EQ(gaps, 1);
  };
  ASSERT_EQ(balls.series.size(), 3U);
  ASSERT_EQ(flanks.series.size(), 3U);
  EXPECT_EQ(balls.series[2].label, "T = 48 N·m");
  expect_shown(balls.series[2], at_T2->balls);
  expect_shown(flanks.series[2], at_T2->drive_flanks);
  const std::vector<double>& x = flanks.series[2].x;
  EXPECT_NEAR(x.front(), x[x.size() / 2 + 1], 1e-9);  // rounding of degrees
}

TEST(TorsionReport, InputUnusableCurveSaysWhy) {
  GearSet gear = drive();
  gear.mesh->lobe_gap = 2e-3;
  try {
    (void)torsion_report(gear);
    FAIL();
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("half a tooth pitch"), std::string::npos);
  }
  gear.mesh.reset();
  EXPECT_THROW((void)torsion_report(gear), InputError);
}

TEST(TorsionReport, IdentityExampleWithACrackInEveryPlace) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  const MakersLines cracked_lines = makers_lines(gear);
  const MakersLines sound = makers_lines(without_cracks(gear));
  EXPECT_LT(cracked_lines.K1, sound.K1);
  EXPECT_LT(cracked_lines.K2, sound.K2);
  EXPECT_LT(cracked_lines.K3, sound.K3);
}

}  // namespace
}  // namespace strainwave

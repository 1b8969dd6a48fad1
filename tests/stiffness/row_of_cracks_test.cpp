// SPDX-License-Identifier: Apache-2.0
// A row of equal cracks round the flexspline: what `count` changes in compliance and K.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "strainwave/crack_group/straight_cracks.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/sif/tube/shell_row.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using units::mm;

constexpr double kRowRadius = (160 * mm - 2.24 * mm) / 2;
constexpr double kQuarter = std::numbers::pi / 4;

/// A thin wall, because the thickness of the wall changes K by the size of the crack.
GearSet with_row(FlexsplineCrack crack) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.output_shaft->crack.clear();
  gear.flexspline->crack = {std::move(crack)};
  gear.flexspline->dynamic_load = 1;
  return gear;
}

GearSet through_row(int count, double half_length, double angle, bool shell = false) {
  return with_row(WallThroughCrack{
      .half_length = half_length, .angle = angle, .shell_correction = shell, .count = count});
}

CrackReport report_of(const GearSet& gear) { return flexspline_compliance(gear).cracks.at(0); }

double added(const CrackReport& report, bool positive) {
  return (positive ? report.positive : report.negative).at_output.value;
}

/// Compliance of a flat row over that of its cracks alone, by the work on the faces under torsion.
double row_ratio(double angle, double share) {
  const StraightCrack crack{
      .centre = 0.0, .half_length = share / 2, .angle = std::numbers::pi / 2 + angle};
  return crack_group(std::array{crack}, {.xy = 1}, {.order = 120, .period = 1.0}).compliance_ratio;
}

/// A count whose share 2 a/p is near the wanted one, and the share itself.
struct RowOf {
  int count;
  double share;
};
RowOf row_with(double share, double half_length) {
  const double round = std::numbers::pi * kRowRadius;
  const int count = static_cast<int>(std::lround(share * round / half_length));
  return {count, half_length * count / round};
}

// Kind: crosscheck (CG-7), (CG-6).  In a flat sheet the row adds the compliance of one crack times
// the number of cracks times the ratio that the work on the faces gives.  The half length is 12
// walls, so the effect of the thickness on K hardly varies over the growth from 0: the tolerance of
// 2 % stands for it.
TEST(RowOfCracks, CrosscheckComplianceWithTheWorkOnTheFaces) {
  const double a = 12 * 2.24 * mm / 8;
  for (const double angle : {kQuarter, -kQuarter, 0.3})
    for (const double wanted : {0.5, 1.0}) {
      const RowOf row = row_with(wanted, a);
      const CrackReport alone = report_of(through_row(1, a, angle));
      const CrackReport all = report_of(through_row(row.count, a, angle));
      for (const bool positive : {true, false}) {
        const double one = added(alone, positive);
        if (one == 0) {
          EXPECT_EQ(added(all, positive), 0);
          continue;
        }
        const StraightCrack crack{
            .centre = 0.0, .half_length = row.share / 2, .angle = std::numbers::pi / 2 + angle};
        const CrackGroup group = crack_group(std::array{crack}, {.xy = positive ? 1.0 : -1.0},
                                             {.order = 120, .period = 1.0});
        test::expect_relative(added(all, positive) / (row.count * one), group.compliance_ratio,
                              0.02);
      }
    }
}

// Kind: identity (CG-7).  K of the row is that of a crack alone times the factors of the row, at
// each face and for each mode; the row itself changes nothing else.
TEST(RowOfCracks, IdentityFactorsOnK) {
  const double a = 4 * mm;
  const RowOf row = row_with(0.9, a);
  const CrackReport alone = report_of(through_row(1, a, kQuarter));
  const CrackReport all = report_of(through_row(row.count, a, kQuarter));
  const RowFactors factors = row_factors(row.share, kQuarter);
  const double K = alone.deepest->K_I.value;
  test::expect_relative(all.deepest->K_I.value, factors.opening_by_normal * K, 1e-9);
  test::expect_relative(all.deepest->K_II.value, factors.sliding_by_normal * K, 1e-9);
}

// Kind: limit (CG-7).  Short cracks far apart do not see each other: the row adds the sum.
TEST(RowOfCracks, LimitFarApart) {
  const double a = 0.5 * mm;
  for (const bool shell : {false, true}) {
    const double one = added(report_of(through_row(1, a, kQuarter, shell)), true);
    test::expect_relative(added(report_of(through_row(3, a, kQuarter, shell)), true), 3 * one,
                          1e-4);
  }
}

// Kind: behaviour.  Rows of 45 degrees amplify, stacked axial cracks slide more, and each sense of
// the torque is that of the mirrored row.
TEST(RowOfCracks, BehaviourOfBothSenses) {
  const double a = 4 * mm;
  const int count = row_with(0.8, a).count;
  const CrackReport right = report_of(through_row(count, a, kQuarter));
  const CrackReport left = report_of(through_row(count, a, -kQuarter));
  EXPECT_EQ(right.opens_under, OpensUnder::positive);
  EXPECT_EQ(left.opens_under, OpensUnder::negative);
  test::expect_relative(added(right, true), added(left, false), 1e-9);
  EXPECT_GT(added(right, true), 1.1 * count * added(report_of(through_row(1, a, kQuarter)), true));
  EXPECT_GT(added(report_of(through_row(count, a, 0.0)), true),
            1.1 * count * added(report_of(through_row(1, a, 0.0)), true));
}

// Kind: behaviour.  The note says by how much the neighbours act, in place of the note that cracks
// are only added; a crack alone has none.
TEST(RowOfCracks, BehaviourNote) {
  const double a = 4 * mm;
  const MemberCompliance row =
      flexspline_compliance(through_row(row_with(0.8, a).count, a, kQuarter));
  ASSERT_EQ(test::count_notes(row.notes, "crack.row"), 1);
  EXPECT_EQ(test::count_notes(row.notes, "crack.superposed"), 0);
  const Note& note = *std::ranges::find(row.notes, "crack.row", &Note::code);
  EXPECT_NE(note.text.find("with open faces they add 1.2"), std::string::npos) << note.text;
  EXPECT_NE(std::ranges::find(row.equations, "CG-7"), row.equations.end());
  EXPECT_EQ(
      test::count_notes(flexspline_compliance(through_row(1, a, kQuarter)).notes, "crack.row"), 0);
  // The neighbours make the answer less certain.
  EXPECT_GT(*row.cracks[0].positive.at_output.relative_uncertainty,
            *report_of(through_row(1, a, kQuarter)).positive.at_output.relative_uncertainty);
}

// Kind: limit.  Where the cracks nearly touch, or lie closer than the table of their influence, the
// answer cannot be used.
TEST(RowOfCracks, LimitGap) {
  const double a = 4 * mm;
  const auto refusal = [&](int of, bool shell) {
    return flexspline_compliance(through_row(of, a, 1.4, shell)).unusable_because;
  };
  const int flat = row_with(largest_row_share(1.4), a).count;
  EXPECT_EQ(refusal(row_with(0.7, a).count, false), "");
  EXPECT_NE(refusal(flat + 2, false).find("less than 0.2 of the half length"), std::string::npos);
  const int curved = row_with(sif::largest_tabulated_share(1.4), a).count;
  EXPECT_EQ(refusal(curved - 1, true), "");
  EXPECT_NE(refusal(curved + 1, true).find("closer than the table"), std::string::npos);
  EXPECT_TRUE(series_compliance<double>(through_row(curved - 1, a, 1.4, true)).usable);
  EXPECT_FALSE(series_compliance<double>(through_row(curved + 1, a, 1.4, true)).usable);
}

// Kind: limit.  Neighbours may press faces together that the load opens a little; then no model
// tells which part of them touches.
TEST(RowOfCracks, LimitFacesThatNeighboursPress) {
  const double a = 4 * mm;
  GearSet gear = through_row(row_with(1.0, a).count, a, 0.3);
  EXPECT_EQ(flexspline_compliance(gear).unusable_because, "");
  const double tau = gear.flexspline->stress_nonuniformity * 6000 /
                     (2 * std::numbers::pi * kRowRadius * kRowRadius * 2.24 * mm);
  // T > 0 pulls at the faces by sin(2 beta) tau, and the axial force presses a little less.
  gear.load.torque = 6000;
  gear.load.axial_force = -0.98 * tau * std::sin(0.6) / (std::sin(0.3) * std::sin(0.3)) *
                          (2 * std::numbers::pi * kRowRadius * 2.24 * mm);
  EXPECT_NE(flexspline_compliance(gear).unusable_because.find("faces that the load"),
            std::string::npos)
      << flexspline_compliance(gear).unusable_because;
}

// Kind: crosscheck (CG-8).  Source: tests/data/crack_rows.csv, solid elements.  Where the curvature
// between the cracks is left out, the stated uncertainty of the row covers what it is wrong by.
TEST(RowOfCracks, CrosscheckUncertaintyOfAFlatSheet) {
  int rows = 0;
  double least = 1.0;
  double most = 0.0;
  for (const test::CsvRow& row : test::read_reference_csv("crack_rows")) {
    if (row.quantity != "torsion.ratio") continue;
    GearSet gear = through_row(static_cast<int>(row("cracks")), row("half_length"), row("angle"));
    gear.drive.pitch_diameter = 2 * row("radius") + row("wall");
    gear.flexspline->wall_thickness = row("wall");
    const MemberCompliance member = flexspline_compliance(gear);
    const auto stated = std::ranges::find_if(member.accuracies, [](const AccuracyBasis& basis) {
      return basis.source.find("between the cracks is left out") != std::string::npos;
    });
    ASSERT_NE(stated, member.accuracies.end()) << row.place;
    const double flat = row_ratio(row("angle"), 1 / row("pitch_over_length"));
    EXPECT_LT(std::abs(flat / row.value - 1), stated->relative_uncertainty) << row.place;
    least = std::min(least, stated->relative_uncertainty);
    most = std::max(most, stated->relative_uncertainty);
    ++rows;
  }
  EXPECT_EQ(rows, 15);
  EXPECT_GT(least, 0.05);
  EXPECT_LE(most, 0.4);
}

// Kind: crosscheck (CG-9).  Source: tests/data/crack_rows.csv, solid elements.  The uncertainty of
// unlike cracks in a curved wall, min(1.5, 0.7 lambda) of the influence of the flat sheet, covers
// what the curvature changes in each judged row.  It is hardly larger than the worst one.
TEST(RowOfCracks, CrosscheckUncertaintyOfUnlikeCracks) {
  const auto uncertainty = [](double shell_parameter) {
    WallGroup::Wall wall;
    wall.round = 1.0;
    wall.shell_parameter = shell_parameter / 1e-3;
    WallGroup::Member member;
    member.place.half_length = 1e-3;
    return WallGroup(wall, {member, member}).uncertainty();
  };
  double most = 0.0;
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("crack_rows")) {
    if (row.quantity != "torsion.ratio") continue;
    const double flat = row_ratio(row("angle"), 1 / row("pitch_over_length"));
    const double share =
        std::abs(row.value - flat) / (uncertainty(row("shell_parameter")) * std::abs(flat - 1));
    EXPECT_LT(share, 1) << row.place;
    most = std::max(most, share);
    ++rows;
  }
  EXPECT_EQ(rows, 15);
  EXPECT_GT(most, 0.9);
  test::expect_relative(uncertainty(1.0), 0.7, 1e-12);
  test::expect_relative(uncertainty(5.0), 1.5, 1e-12);
}

// Kind: behaviour.  Surface cracks are added; the bound by through cracks of their length makes the
// answer less certain and ends it.
TEST(RowOfCracks, BehaviourSurfaceCracks) {
  const auto row = [](int count) {
    return with_row(WallSurfaceCrack{
        .depth = 1 * mm, .half_length = 2 * mm, .angle = kQuarter, .count = count});
  };
  const CrackReport alone = report_of(row(1));
  const CrackReport ten = report_of(row(10));
  test::expect_relative(added(ten, true), 10 * added(alone, true), 1e-9);
  EXPECT_EQ(ten.deepest->K_I.value, alone.deepest->K_I.value);
  EXPECT_GT(*ten.positive.at_output.relative_uncertainty,
            *alone.positive.at_output.relative_uncertainty);
  EXPECT_EQ(test::count_notes(flexspline_compliance(row(10)).notes, "crack.row_of_surface_cracks"),
            1);
  EXPECT_EQ(flexspline_compliance(row(10)).unusable_because, "");
  EXPECT_NE(flexspline_compliance(row(120)).unusable_because.find("120 surface cracks"),
            std::string::npos);
  EXPECT_FALSE(series_compliance<double>(row(120)).usable);
}

// Kind: reference (CG-7).  Arcs on a circle lie in one line, whose row is exact: per crack the
// compliance grows by -2 ln(cos x)/x^2, x = pi a/p.  Tolerance: 1e-8.
TEST(RowOfCracks, ReferenceArcsOfTheDiaphragm) {
  GearSet gear = with_row(DiaphragmArcCrack{});
  gear.flexspline = Flexspline{};
  Flexspline& fs = *gear.flexspline;
  fs.material = "steel";
  fs.crack_free = CrackFree::sections;
  fs.shape = FlexsplineShape::cup;
  fs.barrel =
      TubeSection{.outer_diameter = 160 * mm, .wall_thickness = 2.24 * mm, .length = 60 * mm};
  fs.diaphragm = Diaphragm{};
  fs.diaphragm->inner_diameter = 80 * mm;
  fs.diaphragm->outer_diameter = 150 * mm;
  fs.diaphragm->thickness = 2 * mm;
  const auto arcs = [&](int count) {
    fs.crack = {DiaphragmArcCrack{.half_length = 5 * mm, .radius = 50 * mm, .count = count}};
    return flexspline_compliance(gear);
  };
  const double one = added(arcs(1).cracks.at(0), true);
  const int count = 16;
  const double x = 5 * mm * count / (2 * 50 * mm);  // pi a/p, p = 2 pi R/count
  test::expect_relative(added(arcs(count).cracks.at(0), true) / (count * one),
                        -2 * std::log(std::cos(x)) / (x * x), 1e-8);
  EXPECT_NE(arcs(29).unusable_because.find("less than 0.2"), std::string::npos);
}

}  // namespace
}  // namespace strainwave

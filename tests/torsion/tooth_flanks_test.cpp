// SPDX-License-Identifier: Apache-2.0 Teeth as drawn: gap of the flanks (TC-29), compliance
// (TC-30).
#include "strainwave/torsion/tooth_flanks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "half_path.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The teeth of a row of tests/data/tooth_gap.csv.
BasicTeeth<double> teeth_of(const test::CsvRow& row) {
  const bool half_path = row.quantity.starts_with("half_path");
  return {.profile = half_path                              ? ToothProfile::half_path
                     : row.quantity.starts_with("straight") ? ToothProfile::straight
                                                            : ToothProfile::involute,
          .flank_angle = half_path ? 0.0 : row("flank_angle"),
          .addendum = row("flexspline_addendum"),
          .spline_addendum = row("spline_addendum"),
          .thickness = row("thickness"),
          .ring_radius = row("radius"),
          .pitch_offset = row("offset"),
          .wave = row("wave"),
          .teeth = static_cast<int>(std::lround(2 * row("ratio")))};
}

/// Size 25 with the walls of a typical drive.
BasicTeeth<double> typical_teeth(double ratio, ToothProfile profile = ToothProfile::straight) {
  const double d = 63.5e-3;
  const double m = d / (2 * ratio);
  const double wall = 1e-4 * (65 + 2.5 * std::cbrt(ratio * ratio)) * d;
  const double R = d / 2 - 1.1 * m - wall / 2;
  return {.profile = profile,
          .flank_angle = 22 * units::deg,
          .addendum = 0.65 * m,
          .spline_addendum = 0.65 * m,
          .thickness = pi / 2 * m,
          .ring_radius = R,
          .pitch_offset = d / 2 - R,
          .wave = m,
          .teeth = static_cast<int>(std::lround(2 * ratio))};
}

/// The same teeth in dual numbers, without derivatives.
BasicTeeth<DualReal> lifted(const BasicTeeth<double>& at) {
  return {.profile = at.profile,
          .flank_angle = at.flank_angle,
          .addendum = at.addendum,
          .spline_addendum = at.spline_addendum,
          .thickness = at.thickness,
          .ring_radius = at.ring_radius,
          .pitch_offset = at.pitch_offset,
          .wave = at.wave,
          .teeth = at.teeth};
}

TEST(ToothGap, CrosscheckPointsOnTheFlanks) {
  // tools/reference/tooth_gap.py measures the distance between points on both flanks and the chords
  // of the other, and integrates the centre line by Gauss's rule.  Tolerance: 1e-9 m, as the
  // chapter promises; chords and closed forms agree better.  The end of the table moves the wall by
  // its play along the normal, the library across, which changes the angle by less than 0.25
  // degrees.
  int gaps = 0;
  int seats = 0;
  int ends = 0;
  for (const test::CsvRow& row : test::read_reference_csv("tooth_gap")) {
    const bool law = row.quantity.starts_with("straight.") || row.quantity.starts_with("involute.");
    if (!law) continue;
    const std::string what = row.quantity.substr(row.quantity.find('.') + 1);
    const ToothGap gap(teeth_of(row), 0.0, 1e-2);
    if (what == "gap") {
      const double found = gap.mid_gap(row("angle"));
      if (std::abs(row("angle")) <= 30 * units::deg) {
        EXPECT_GT(found, -1e-9) << row.quantity << " " << row("ratio") << " " << row("angle");
      }
      EXPECT_NEAR(std::abs(found), row.value, 1e-9)
          << row.quantity << " " << row("ratio") << " " << row("angle");
      ++gaps;
    } else if (what == "seat") {
      EXPECT_NEAR(gap.play(), row.value, 1e-9) << row.quantity << row("ratio");
      ++seats;
    } else if (what == "drive_end") {
      EXPECT_NEAR(gap.end(), row.value, 0.4 * units::deg) << row.quantity << row("ratio");
      ++ends;
    }
  }
  EXPECT_GE(gaps, 240);
  EXPECT_GE(seats, 10);
  EXPECT_GE(ends, 10);
}

TEST(HalfPath, CrosscheckPointsOnTheFlanks) {
  // tools/reference/tooth_gap.py: the wall is the outline of all positions of 4001 points of the
  // tooth, gaps are distances of points from chords, contacts come from the velocities of points.
  // Tolerances: 1e-9 m of gaps and heights, 1e-6 rad of angles, as the chapter states: chords, and
  // differences along the flank, which give 4e-8 rad.  A wave of 1.15 modules is beyond the rule of
  // the program; its contacts on the drive side agree, too.
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("tooth_gap")) {
    if (!row.quantity.starts_with("half_path.")) continue;
    const std::string what = row.quantity.substr(row.quantity.find('.') + 1);
    const ToothGap gap(teeth_of(row), 0.0, 1e-2);
    const std::string where = std::to_string(row("ratio")) + " " +
                              std::to_string(what.ends_with("end") ? 0 : row("angle"));
    if (what == "drive_end") {
      EXPECT_NEAR(gap.end(), row.value, 1e-7) << where;
    } else if (what == "gap") {
      if (row("wave") > 1.05 * row("module") && row("angle") < 0) continue;
      EXPECT_NEAR(gap.mid_gap(row("angle")), row.value, 1e-9) << where;
    } else if (what == "contact_height" && row("angle") > 0) {
      EXPECT_NEAR(gap.contact(row("angle")).height, row.value, 1e-9) << where;
    } else if (what == "contact_angle") {
      EXPECT_NEAR(gap.contact(row("angle")).angle, row.value, 1e-6) << where;
    } else {
      continue;
    }
    ++seen[what];
  }
  EXPECT_GE(seen["drive_end"], 6);
  EXPECT_GE(seen["gap"], 100);
  EXPECT_GE(seen["contact_height"], 55);
  EXPECT_GE(seen["contact_angle"], 55);
}

TEST(HalfPath, LimitARackTouchesAtHalfItsPath) {
  // With many teeth and the pitch height on the centre line the space is that of a rack.  The point
  // of contact then stands half as high above the pitch height of the tooth as the tooth has gone
  // down, w_0 (1 - cos 2t)/2, and the normal has the angle tan(beta) = tan(t)/2 of the path.
  // Tolerance: terms of w_0/R, 1e-4 at ratio 5000, times 3 and over 1 - cos 2t.
  BasicTeeth<double> teeth = typical_teeth(5000, ToothProfile::half_path);
  teeth.pitch_offset = 0.0;
  teeth.ring_radius = teeth.teeth * teeth.wave / 2;
  const ToothGap gap(teeth, 0.0, 1e-2);
  for (const double degrees : {15.0, 30.0, 50.0}) {
    const double t = degrees * units::deg;
    const auto [angle, height] = gap.contact(t);
    const double down = teeth.wave * (1 - std::cos(2 * t));
    EXPECT_NEAR(height, down / 2, 5e-3 * down) << degrees;
    EXPECT_NEAR(std::tan(angle), std::tan(t) / 2, 5e-3) << degrees;
  }
}

TEST(HalfPath, IdentityTheTipLeadsBesideTheLobe) {
  // Definition (TC-29): where the edge of the tip touches, the force has the direction of the flank
  // at the tip.  It joins the contact of the flank without a jump, and the gap along the face is
  // largest at the lobe, where the flanks are seated.  Tolerance of the jump: 0.001 degrees times
  // its rate, which is steep, as a root, where the contact leaves the tip.
  for (const double ratio : {30.0, 100.0, 160.0}) {
    const BasicTeeth<double> teeth = typical_teeth(ratio, ToothProfile::half_path);
    const ToothGap gap(teeth, 0.014, 9e-3);
    EXPECT_EQ(gap.seat(), 0.0);
    EXPECT_EQ(gap.gap(0.0), 0.0);
    EXPECT_EQ(gap.contact(0.0).height, teeth.addendum);
    double before = gap.contact(0.0).angle;
    for (int i = 1; i <= 53000; i += 1) {
      const double t = i * 1e-3 * units::deg;
      const double angle = gap.contact(t).angle;
      ASSERT_NEAR(angle, before, 5e-4) << ratio << " " << i;
      before = angle;
      if (i <= 30000 && i % 1000 == 0) {
        EXPECT_LE(gap.slope(t), gap.slope(0.0)) << ratio << " " << i;
      }
    }
  }
}

TEST(HalfPath, ReferenceTheGapGrowsAlongTheFaceWithTheWave) {
  // Direct geometry: in a section with a larger wave the point of contact moves along the common
  // normal by the slope of (TC-29), within 3 % of its value at the lobe, as for straight flanks.
  for (const double ratio : {50.0, 100.0}) {
    BasicTeeth<double> teeth = typical_teeth(ratio, ToothProfile::half_path);
    const double cone = 0.0145;
    const ToothGap gap(teeth, cone, 1e-2);
    const double w0 = teeth.wave;
    for (const double degrees : {5.0, 10.0, 20.0, 30.0, 40.0, 50.0}) {
      const double t = degrees * units::deg;
      const auto contact = gap.contact(t);
      const BasicHalfPathFlank<double> flank = half_path_flank(teeth);
      const auto point = flank.point(std::acos(1 - 2 * contact.height / w0));
      const auto along_normal = [&](double by) {
        BasicTeeth<double> section = teeth;
        section.wave = w0 * (1 + by);
        const auto at = placed(BasicToothMotion<double>(section).pose(t), point);
        return at.across * std::cos(contact.angle) + at.outward * std::sin(contact.angle);
      };
      const double moved = (along_normal(0.02) - along_normal(-0.02)) / (0.04 * w0);
      const double lobe = gap.slope(0.0) / cone;
      EXPECT_NEAR(std::abs(moved), gap.slope(t) / cone, 0.03 * lobe) << ratio << " " << degrees;
    }
  }
}

TEST(HalfPath, BehaviourRelievedTipsAreFullOnes) {
  // The gap of half paths does not become smaller again, so there is nothing to relieve.
  BasicTeeth<double> teeth = typical_teeth(100, ToothProfile::half_path);
  const ToothGap full(teeth, 0.0, 9e-3);
  teeth.tips = ToothTips::relieved;
  const ToothGap relieved(teeth, 0.0, 9e-3);
  EXPECT_EQ(relieved.end(), full.end());
  EXPECT_EQ(relieved.relief(), 0.0);
}

TEST(HalfPath, ReferenceTheMeanAngle) {
  // With w_0 = m and h_a = 0.65 m, cos(eta) = -0.3: across m (eta - sin eta)/4.
  const double eta = std::acos(-0.3);
  EXPECT_NEAR(half_path_angle(0.65, 1.0, 1.0), std::atan((eta - std::sin(eta)) / 4 / 0.65), 1e-15);
  EXPECT_NEAR(half_path_angle(0.65, 1.0, 1.0), 19.5 * units::deg, 0.05 * units::deg);
}

TEST(HalfPath, IdentityDerivativesAreThoseOfTheContact) {
  // Dual numbers against central differences, 1e-6 of the value over the input.  The angles lie on
  // both sides of the lobe, where the tip and where the flank touches.
  const BasicTeeth<double> at = typical_teeth(80, ToothProfile::half_path);
  const std::array<double BasicTeeth<double>::*, 5> inputs = {
      &BasicTeeth<double>::addendum, &BasicTeeth<double>::thickness,
      &BasicTeeth<double>::ring_radius, &BasicTeeth<double>::pitch_offset,
      &BasicTeeth<double>::wave};
  const std::array<DualReal BasicTeeth<DualReal>::*, 5> duals = {
      &BasicTeeth<DualReal>::addendum, &BasicTeeth<DualReal>::thickness,
      &BasicTeeth<DualReal>::ring_radius, &BasicTeeth<DualReal>::pitch_offset,
      &BasicTeeth<DualReal>::wave};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    BasicTeeth<DualReal> dual = lifted(at);
    (dual.*duals[k]).partial[0] = 1.0;
    const BasicToothGap<DualReal> gap(dual, DualReal(0.01), DualReal(9e-3));
    for (const double degrees : {-25.0, -12.0, -1.0, 1.0, 5.0, 17.0, 35.0, 48.0}) {
      const double t = degrees * units::deg;
      const double step = 1e-6 * at.*inputs[k];
      const auto shifted = [&](double by) {
        BasicTeeth<double> other = at;
        other.*inputs[k] += by;
        const ToothGap gap_of(other, 0.01, 9e-3);
        const auto contact = gap_of.contact(t);
        return std::array{gap_of.mid_gap(t), gap_of.slope(t), contact.angle, contact.height};
      };
      const auto after = shifted(step);
      const auto before = shifted(-step);
      const auto contact = gap.contact(t);
      const std::array found = {gap.mid_gap(t), gap.slope(t), contact.angle, contact.height};
      const std::array scale = {at.wave, 0.01, 1.0, at.wave};
      for (std::size_t i = 0; i < found.size(); ++i) {
        const double expected = (after[i] - before[i]) / (2 * step);
        EXPECT_NEAR(found[i].partial[0], expected,
                    1e-6 * (std::abs(expected) + scale[i] / at.*inputs[k]))
            << k << " " << degrees << " " << i;
      }
    }
  }
}

TEST(ToothGap, LimitSmallTeethFollowTheFirstOrder) {
  // (TC-7) with the displacement of the point of contact: at ratio 1000 the gap of the drive flank
  // at 20 degrees is that of the path x = w_0 [t - (1 - 3 e_c/R) sin(2t)/2], y = w_0 cos(2t), less
  // the turn of the section, within the order w_0/R.
  const BasicTeeth<double> teeth = typical_teeth(1000);
  const ToothGap gap(teeth, 0.0, 1e-2);
  const double t = 20 * units::deg;
  const double lever = 3 * (teeth.pitch_offset + teeth.addendum) / teeth.ring_radius;
  const double x = t - (1 - lever) / 2 * std::sin(2 * t);
  const double first = teeth.wave * ((1 - std::cos(2 * t)) * std::sin(teeth.flank_angle) -
                                     x * std::cos(teeth.flank_angle));
  EXPECT_NEAR(gap.mid_gap(t) - gap.play(), first, 0.02 * first);
}

TEST(ToothGap, IdentityTheSeatTouchesWithoutCrossing) {
  for (const double ratio : {30.0, 100.0, 160.0})
    for (const ToothProfile profile : {ToothProfile::straight, ToothProfile::involute})
      for (const double cone : {0.0, 0.01}) {
        const ToothGap gap(typical_teeth(ratio, profile), cone, 9.525e-3);
        double least = 1.0;
        for (int i = -300; i <= 300; ++i) {
          const double t = 0.1 * i * units::deg;
          least = std::min(least, gap.mid_gap(t) - gap.slope(t) * 9.525e-3 / 2);
        }
        // The samples are 0.1 degrees apart; the gap is flat at its least value.
        EXPECT_NEAR(least, 0.0, 2e-8) << ratio << " " << cone;
        EXPECT_LE(std::abs(gap.seat()), 30 * units::deg + 1e-9);
      }
}

TEST(ToothGap, IdentityRelievedTipsEndAtTheLargestGap) {
  // Definition: no gap of the full tooth between the seat and its end is larger than the gap at the
  // relieved end, and the relief is the difference of the gaps at the two ends.  Tolerance 1e-12 m:
  // rounding.  The end moves with the profile; that of straight flanks is near tan t = 2 tan alpha,
  // 38.9 degrees, up to terms of w_0/R (3 degrees at ratio 30).
  for (const ToothProfile profile : {ToothProfile::straight, ToothProfile::involute})
    for (const double ratio : {30.0, 50.0, 100.0, 160.0}) {
      BasicTeeth<double> teeth = typical_teeth(ratio, profile);
      const ToothGap full(teeth, 0.0, 9e-3);
      teeth.tips = ToothTips::relieved;
      const ToothGap relieved(teeth, 0.0, 9e-3);
      EXPECT_NEAR(relieved.end(), std::atan(2 * std::tan(teeth.flank_angle)), 3 * units::deg);
      for (int i = 0; i <= 100; ++i)
        EXPECT_LE(full.mid_gap(full.end() * i / 100), full.mid_gap(relieved.end()) + 1e-12)
            << ratio;
      EXPECT_NEAR(relieved.relief(), full.mid_gap(relieved.end()) - full.mid_gap(full.end()),
                  1e-12);
      EXPECT_GT(relieved.relief(), 0.1 * full.mid_gap(relieved.end()));
      EXPECT_EQ(full.relief(), 0.0);
      EXPECT_EQ(relieved.gap(0.3), full.gap(0.3));
    }
}

TEST(ToothGap, ReferenceDepthOfTheRelief) {
  // The gaps of law_straight of tools/reference/tooth_gap.py with the play of the seat, at the
  // angles widest_gap and drawn_end of coupled_drive.py, which finds both angles by other
  // methods: 39.1 and 53.6 degrees at ratio 100.  The tolerances are half of the last printed
  // digit; the chapter rounds to 33, 26, 16 and 11 um.
  for (const auto& [ratio, depth] :
       {std::pair{30.0, 32.7}, {50.0, 26.1}, {100.0, 15.8}, {160.0, 10.5}}) {
    BasicTeeth<double> teeth = typical_teeth(ratio);
    teeth.tips = ToothTips::relieved;
    EXPECT_NEAR(ToothGap(teeth, 0.0, 9e-3).relief(), depth * 1e-6, 0.05e-6) << ratio;
  }
}

TEST(ToothGap, BehaviourRelievedTipsOfASmallWave) {
  // With w_0 = 0.9 m at ratio 30 the flanks are seated far from the lobe, and their gap at the lobe
  // is larger than any gap beyond the seat.  Engagement must not end at the lobe.
  BasicTeeth<double> teeth = typical_teeth(30);
  teeth.wave *= 0.9;
  teeth.tips = ToothTips::relieved;
  const ToothGap gap(teeth, 0.0, 9e-3);
  EXPECT_GT(gap.mid_gap(0.0), gap.mid_gap(gap.end()));
  EXPECT_GT(gap.end(), gap.seat());
  EXPECT_GT(gap.end(), 25 * units::deg);
}

TEST(ToothGap, ReferenceTipsCrossBelowTheLargestAddendum) {
  // tools/reference/tooth_gap.py: at ratio 100 straight flanks have the largest equal addenda
  // without interference of 0.61, 0.70 and 0.81 modules at 20, 22 and 25 degrees, to 0.01.
  for (const auto& [degrees, most] : {std::pair{20.0, 0.61}, {22.0, 0.70}, {25.0, 0.81}})
    for (const double by : {-0.015, 0.015}) {
      BasicTeeth<double> teeth = typical_teeth(100);
      teeth.flank_angle = degrees * units::deg;
      teeth.addendum = teeth.spline_addendum = (most + by) * teeth.wave;
      EXPECT_EQ(ToothGap(teeth, 0.0, 1e-2).crossing() > 0, by > 0) << degrees;
    }
}

TEST(ToothCompliance, ReferenceTheContactInATooth) {
  // (TC-30): 0.045 is the approach of a half-plane, -nu/2(1 - nu), plus that of the elements for a
  // tooth instead of the half-plane, over Gamma = 2(1 - nu^2)/pi.  Tolerance: the scatter of the
  // elements over the teeth, 0.011/Gamma, as the root of the mean square.
  double sum = 0.0;
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("tooth_pair_fe"))
    if (row.quantity == "contact_in_tooth") {
      sum += row.value;
      ++rows;
    }
  ASSERT_GE(rows, 90);
  const double layer = 2 * (1 - 0.09) / pi;
  EXPECT_NEAR(sum / rows / layer - 0.3 / (2 * 0.7), 0.045, 0.011 / layer);
}

TEST(ToothGap, ReferenceTheGapGrowsAlongTheFaceWithTheWave) {
  // Direct geometry: a section with a larger wave has another path.  The drive with the wave w_0 (1
  // + h) against the same wall, less that with (1 - h), gives the slope of (TC-29) within 3 % of
  // its value at the lobe, without the seats.
  BasicTeeth<double> teeth = typical_teeth(100);
  const double w0 = teeth.wave;
  constexpr double kStep = 0.02;
  const double cone = 0.0145;
  const ToothGap slope_of(teeth, cone, 1e-2);
  const auto moved = [&](double t) {
    double gap[2];
    double lobe[2];
    for (const int i : {0, 1}) {
      teeth.wave = w0 * (1 + (i == 0 ? -kStep : kStep));
      const ToothGap section(teeth, 0.0, 1e-2);
      gap[i] = section.mid_gap(t) - section.play();
      lobe[i] = teeth.wave;
    }
    // The wall of the library moves out with the lobe; a straight wall stays.
    return (gap[1] - gap[0]) / (lobe[1] - lobe[0]) - std::sin(teeth.flank_angle);
  };
  for (const double degrees : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0}) {
    const double t = degrees * units::deg;
    const double sign = t < 20.4 * units::deg ? 1.0 : -1.0;
    EXPECT_NEAR(-moved(t), sign * slope_of.slope(t) / cone, 0.03 * std::sin(teeth.flank_angle))
        << degrees;
  }
}

TEST(ToothGap, IdentityDerivativesAreThoseOfTheGap) {
  // Dual numbers against central differences, 1e-6 of the gap.
  for (const ToothProfile profile : {ToothProfile::straight, ToothProfile::involute}) {
    const BasicTeeth<double> at = typical_teeth(80, profile);
    const std::array<double BasicTeeth<double>::*, 6> inputs = {
        &BasicTeeth<double>::flank_angle,     &BasicTeeth<double>::addendum,
        &BasicTeeth<double>::spline_addendum, &BasicTeeth<double>::thickness,
        &BasicTeeth<double>::ring_radius,     &BasicTeeth<double>::wave};
    const std::array<DualReal BasicTeeth<DualReal>::*, 6> duals = {
        &BasicTeeth<DualReal>::flank_angle,     &BasicTeeth<DualReal>::addendum,
        &BasicTeeth<DualReal>::spline_addendum, &BasicTeeth<DualReal>::thickness,
        &BasicTeeth<DualReal>::ring_radius,     &BasicTeeth<DualReal>::wave};
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      BasicTeeth<DualReal> dual = lifted(at);
      (dual.*duals[k]).partial[0] = 1.0;
      const BasicToothGap<DualReal> gap(dual, DualReal(0.01), DualReal(9e-3));
      for (const double degrees : {-12.0, 3.0, 17.0, 35.0, 48.0}) {
        const double t = degrees * units::deg;
        const double step = 1e-5 * at.*inputs[k];
        const auto shifted = [&](double by) {
          BasicTeeth<double> other = at;
          other.*inputs[k] += by;
          return ToothGap(other, 0.01, 9e-3).mid_gap(t);
        };
        const double expected = (shifted(step) - shifted(-step)) / (2 * step);
        EXPECT_NEAR(gap.mid_gap(t).partial[0], expected,
                    1e-6 * std::abs(expected) + 1e-8 * at.wave / at.*inputs[k])
            << k << " " << degrees;
      }
    }
  }
}

TEST(ToothCompliance, CrosscheckPlaneFiniteElements) {
  // tools/reference/tooth_pair.py: quadratic plane elements.  The tolerances are the errors of the
  // fit that (TC-30) states.
  int teeth = 0;
  int walls = 0;
  for (const test::CsvRow& row : test::read_reference_csv("tooth_pair_fe")) {
    const double m = 1.0;
    const BasicToothOnWall<double> tooth{.flank_angle = row("flank_angle"),
                                         .thickness = row("thickness_over_pitch") * pi * m,
                                         .dedendum = row("dedendum_over_module") * m,
                                         .wall = row("wall_over_module") * m,
                                         .module = m};
    if (row.quantity == "tooth") {
      test::expect_relative(tooth_compliance(tooth, 0.3), row.value, 0.04);
      ++teeth;
    } else if (row.quantity == "stretch_free") {
      test::expect_relative(toothed_extension(tooth), row.value, 0.025);
      ++walls;
    }
  }
  EXPECT_GE(teeth, 90);
  EXPECT_GE(walls, 70);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
// Annular cracks of the output shaft that have a place shield each other (CG-12).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/annular_cracks.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

AnnularCrack ring_at(double depth, std::optional<double> distance) {
  AnnularCrack crack;
  crack.depth = depth;
  crack.distance = distance;
  return crack;
}

GearSet shaft_with(const std::vector<AnnularCrack>& cracks, bool solid = false) {
  GearSet gear = test::article_gear(1 * mm);
  gear.output_shaft->length = 300 * mm;
  if (solid) {
    gear.output_shaft->outer_diameter = 60 * mm;
    gear.output_shaft->inner_diameter = 0;
  }
  gear.output_shaft->crack.assign(cracks.begin(), cracks.end());
  return gear;
}

double added_by(const GearSet& gear) {
  double sum = 0.0;
  for (const CrackReport& crack : output_shaft_compliance(gear).cracks)
    sum += crack.positive.at_output.value;
  return sum;
}

// Kind: identity (CG-12).  The report, the sum without a report and annular_group agree, in a solid
// and in a hollow shaft, for the compliance and for K_III.  Tolerance: rounding.
TEST(ShaftGroup, IdentityRatiosOfTheGroup) {
  for (const bool solid : {true, false}) {
    const double depth = solid ? 9 * mm : 2 * mm;
    const std::vector<AnnularCrack> placed = {ring_at(depth, 150 * mm),
                                              ring_at(1.1 * mm, 152 * mm)};
    const GearSet gear = shaft_with(placed, solid);
    const OutputShaft& shaft = *gear.output_shaft;
    const AnnularGroup group =
        annular_group(std::vector<PlacedAnnularCrack>{{150 * mm, depth}, {152 * mm, 1.1 * mm}},
                      {shaft.outer_diameter / 2, shaft.inner_diameter / 2});
    const MemberCompliance member = output_shaft_compliance(gear);
    const MemberCompliance alone =
        output_shaft_compliance(shaft_with({ring_at(depth, {}), ring_at(1.1 * mm, {})}, solid));
    for (const std::size_t j : {0U, 1U}) {
      EXPECT_LT(group.cracks[j].compliance, 0.999);
      test::expect_relative(member.cracks[j].positive.at_output.value,
                            group.cracks[j].compliance * alone.cracks[j].positive.at_output.value,
                            1e-12);
      EXPECT_EQ(member.cracks[j].negative.at_output.value,
                member.cracks[j].positive.at_output.value);
      test::expect_relative((*member.cracks[j].positive.axial_torsion)[2].value,
                            member.cracks[j].positive.at_output.value, 1e-12);
      EXPECT_EQ((*member.cracks[j].positive.axial_torsion)[0].value,
                (*alone.cracks[j].positive.axial_torsion)[0].value);
      EXPECT_GE(*member.cracks[j].positive.at_output.relative_uncertainty,
                *alone.cracks[j].positive.at_output.relative_uncertainty);
      for (const auto K : {&CrackReport::largest, &CrackReport::deepest})
        test::expect_relative((member.cracks[j].*K)->K_III.value,
                              group.cracks[j].factor * (alone.cracks[j].*K)->K_III.value, 1e-12);
      EXPECT_GE(*member.cracks[j].intensity_uncertainty, *alone.cracks[j].intensity_uncertainty);
    }
    // The shallow crack hides behind the deep one.
    EXPECT_LT(group.cracks[1].compliance, solid ? 0.5 : 0.8);
    GearSet sound = gear;
    sound.output_shaft->crack.clear();
    test::expect_relative(
        series_compliance<double>(gear).positive - series_compliance<double>(sound).positive,
        added_by(gear), 1e-9);
  }
}

// Kind: limit (CG-12).  Far apart, the compliances add; the order of the cracks does not matter.
TEST(ShaftGroup, LimitFarApart) {
  const auto at = [](double second) {
    return added_by(shaft_with({ring_at(2 * mm, 60 * mm), ring_at(3 * mm, second)}));
  };
  const double sum = added_by(shaft_with({ring_at(2 * mm, {}), ring_at(3 * mm, {})}));
  test::expect_relative(at(290 * mm), sum, 1e-3);
  EXPECT_LT(at(62 * mm), 0.85 * sum);
  test::expect_relative(added_by(shaft_with({ring_at(3 * mm, 62 * mm), ring_at(2 * mm, 60 * mm)})),
                        at(62 * mm), 1e-12);
}

// Kind: crosscheck (CG-12).  Derivatives by depth, place and diameters against differences of the
// whole compliance, in a hollow and in a solid shaft.  Tolerance: 1e-3, the error of differences of
// the whole, whose number of modes follows the depth.
TEST(ShaftGroup, CrosscheckDerivatives) {
  for (const bool solid : {false, true}) {
    GearSet gear = shaft_with({ring_at(2 * mm, 150 * mm), ring_at(3 * mm, 153 * mm)}, solid);
    OutputShaft& shaft = *gear.output_shaft;
    auto& first = std::get<AnnularCrack>(shaft.crack[0]);
    const std::array<double*, 4> inputs = {&first.depth, &*first.distance, &shaft.outer_diameter,
                                           &shaft.inner_diameter};
    const std::vector<const double*> constant(inputs.begin(), inputs.end());
    const auto dual = series_compliance(gear, Lift<DualReal>(constant));
    const double added = series_compliance<double>(gear).positive_added;
    test::expect_relative(dual.positive_added.value, added, 1e-9);
    for (std::size_t k = 0; k < (solid ? 3U : 4U); ++k) {
      const double value = *inputs[k];
      const double step = 2e-4 * 10 * mm;
      const auto moved = [&](double by) {
        *inputs[k] = value + by;
        const double result = series_compliance<double>(gear).positive_added;
        *inputs[k] = value;
        return result;
      };
      const double slope = (moved(step) - moved(-step)) / (2 * step);
      EXPECT_NEAR(dual.positive_added.partial[k] / value, slope, 1e-3 * std::abs(slope)) << k;
    }
  }
}

// Kind: behaviour (CG-12).  What the notes say with, without and with some places.
TEST(ShaftGroup, BehaviourNotes) {
  const auto codes = [](const std::vector<AnnularCrack>& cracks) {
    return test::note_codes(output_shaft_compliance(shaft_with(cracks)).notes);
  };
  const auto has = [](const std::vector<std::string>& all, const char* code) {
    return std::ranges::find(all, code) != all.end();
  };
  const auto placed = codes({ring_at(2 * mm, 60 * mm), ring_at(3 * mm, 62 * mm)});
  EXPECT_TRUE(has(placed, "crack.shielding"));
  EXPECT_FALSE(has(placed, "crack.superposed"));
  const auto without = codes({ring_at(2 * mm, {}), ring_at(3 * mm, 62 * mm)});
  EXPECT_FALSE(has(without, "crack.shielding"));
  EXPECT_TRUE(has(without, "crack.superposed"));
  const auto some =
      codes({ring_at(2 * mm, 60 * mm), ring_at(3 * mm, 62 * mm), ring_at(1 * mm, {})});
  EXPECT_TRUE(has(some, "crack.shielding"));
  EXPECT_TRUE(has(some, "crack.superposed"));
}

// Kind: behaviour (CG-12).  Cracks nearer than a twentieth of the deeper one count as so far apart:
// the answer has no step there, and it is an upper bound that states how much less may be added.
TEST(ShaftGroup, BehaviourVeryNearCracks) {
  const auto at = [](double apart) {
    return shaft_with({ring_at(2 * mm, 60 * mm), ring_at(3 * mm, 60 * mm + apart)});
  };
  const double limit = 0.05 * 3 * mm;
  test::expect_relative(added_by(at(0.999999 * limit)), added_by(at(1.000001 * limit)), 1e-5);
  test::expect_relative(added_by(at(0.5 * limit)), added_by(at(0.9 * limit)), 1e-9);
  const MemberCompliance member = output_shaft_compliance(at(0.5 * limit));
  const auto note = std::ranges::find(member.notes, "crack.shielding", &Note::code);
  ASSERT_NE(note, member.notes.end());
  EXPECT_EQ(note->severity, Severity::care);
  EXPECT_NE(note->text.find("count as 2 times as long, which is an upper bound; K is "
                            "that of each crack alone"),
            std::string::npos)
      << note->text;
  // K of the deeper one would be too small where the distances are stretched.
  const MemberCompliance alone = output_shaft_compliance(shaft_with({ring_at(3 * mm, {})}));
  EXPECT_EQ(member.cracks[1].deepest->K_III.value, alone.cracks[0].deepest->K_III.value);
  const auto& first = member.cracks[0].positive.at_output;
  const auto& second = member.cracks[1].positive.at_output;
  EXPECT_GE(*second.relative_uncertainty, first.value / (first.value + second.value) - 1e-12);
}

// Kind: behaviour (CG-12).  An axial force that presses the faces may lock the neighbours by
// friction, so K is that of each crack alone.
TEST(ShaftGroup, BehaviourPressedFacesDoNotShield) {
  const auto K_of = [](std::optional<double> distance, double force) {
    GearSet gear = shaft_with({ring_at(2 * mm, 150 * mm), ring_at(3 * mm, distance)});
    gear.load.axial_force = force;
    return output_shaft_compliance(gear).cracks[0].deepest->K_III.value;
  };
  EXPECT_EQ(K_of(153 * mm, -1000), K_of({}, -1000));
  EXPECT_LT(K_of(153 * mm, 0), 0.9 * K_of({}, 0));
}

// Kind: crosscheck (CG-12).  Derivatives of very near cracks, whose distances are stretched.
TEST(ShaftGroup, CrosscheckDerivativesOfVeryNearCracks) {
  GearSet gear = shaft_with({ring_at(2 * mm, 150 * mm), ring_at(3 * mm, 150.1 * mm)});
  double& depth = std::get<AnnularCrack>(gear.output_shaft->crack[1]).depth;
  const double value = depth;
  const std::vector<const double*> constant = {&depth};
  const double partial =
      series_compliance(gear, Lift<DualReal>(constant)).positive_added.partial[0];
  const double step = 2e-3 * mm;
  const auto moved = [&](double by) {
    depth = value + by;
    return series_compliance<double>(gear).positive_added;
  };
  const double slope = (moved(step) - moved(-step)) / (2 * step);
  EXPECT_NEAR(partial / value, slope, 1e-3 * slope);
}

// Kind: input (CG-12).  Each reason why the influence is left out, and a place outside the shaft.
TEST(ShaftGroup, InputGroupsThatCannotTell) {
  const auto fault = [](const std::vector<AnnularCrack>& cracks) {
    const GearSet gear = shaft_with(cracks);
    std::vector<AnnularCrack> unplaced = cracks;
    for (AnnularCrack& crack : unplaced) crack.distance.reset();
    EXPECT_EQ(added_by(gear), added_by(shaft_with(unplaced)));
    const auto notes = output_shaft_compliance(gear).notes;
    const auto note = std::ranges::find(notes, "crack.shielding", &Note::code);
    EXPECT_NE(note, notes.end());
    EXPECT_EQ(note->severity, Severity::care);
    // What is left out stands in the uncertainty: all but the deepest crack.
    EXPECT_GT(*output_shaft_compliance(gear).cracks[0].positive.at_output.relative_uncertainty,
              10 * *output_shaft_compliance(shaft_with(unplaced))
                        .cracks[0]
                        .positive.at_output.relative_uncertainty);
    return note->text;
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(fault({ring_at(2 * mm, 60 * mm), ring_at(3 * mm, 60 * mm)}),
           "output_shaft.crack[1]: the distance is that of output_shaft.crack[0]");
  contains(fault({ring_at(0.009 * mm, 60 * mm), ring_at(0.009 * mm, 62 * mm)}),
           "output_shaft.crack[0]: the depth is");
  std::vector<AnnularCrack> many;
  for (int i = 0; i < 21; ++i) many.push_back(ring_at(1 * mm, (20 + 10 * i) * mm));
  contains(fault(many), "at most 20 are solved together");
  contains(test::broken_rule(
               [] { return torsional_stiffness(shaft_with({ring_at(2 * mm, 300 * mm)})); }),
           "distance < length of the shaft");
}

}  // namespace
}  // namespace strainwave

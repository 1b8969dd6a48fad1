// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/drive_cracks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"
#include "strainwave/sif/bar/bar_annular.hpp"
#include "strainwave/sif/bar/hollow_annular_outer.hpp"
#include "strainwave/sif/tube/shell_row.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

DriveCrack crack_of(const GearSet& gear, const std::string& path) {
  for (DriveCrack& crack : drive_cracks(gear))
    if (crack.path == path) return crack;
  throw std::runtime_error("no " + path);
}

GearSet with_surface_crack() {
  GearSet gear = test::article_gear(1 * mm);
  WallSurfaceCrack surface;
  surface.depth = 0.8 * mm;
  surface.half_length = 2 * mm;
  surface.angle = 30 * deg;
  gear.flexspline->crack = {surface};
  return gear;
}

TEST(Faces, LimitRoundingCountsAsNone) {
  EXPECT_EQ(faces(1.0, 1.0), Faces::open);
  EXPECT_EQ(faces(-1.0, 1.0), Faces::pressed);
  EXPECT_EQ(faces(0.0, 0.0), Faces::touching);
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(faces(sign * 0.9e-12, 1.0), Faces::touching);
    EXPECT_NE(faces(sign * 1.1e-12, 1.0), Faces::touching);
  }
  EXPECT_TRUE((BothSenses{Faces::open, Faces::pressed}.differ()));
  EXPECT_FALSE((BothSenses{Faces::open, Faces::touching}.differ()));
}

TEST(DriveCracks, BehaviourOrderKindsAndMaterials) {
  GearSet gear = with_surface_crack();
  gear.flexspline->crack.emplace_back(RimAxialCrack{});
  const std::vector<DriveCrack> cracks = drive_cracks(gear);
  std::vector<std::string> paths;
  for (const DriveCrack& crack : cracks) {
    paths.push_back(crack.path + " " + crack.kind);
    EXPECT_EQ(crack.material, "steel");
    EXPECT_EQ(crack.acts_in_coupled_drive, crack.kind == "rim_axial");
    EXPECT_EQ(static_cast<bool>(crack.front), crack.kind != "rim_axial");
  }
  EXPECT_EQ(paths, (std::vector<std::string>{
                       "wave_generator.crack[0] surface", "flexspline.crack[0] surface",
                       "flexspline.crack[1] rim_axial", "output_shaft.crack[0] annular"}));
}

TEST(DriveCracks, BehaviourDepthAndHalfLengthApart) {
  // K at another depth and half length equals that of a drive whose crack has this size.
  const DriveCrack given = crack_of(with_surface_crack(), "flexspline.crack[0]");
  EXPECT_EQ(given.size_name, "depth");
  EXPECT_NEAR(given.size.half_length(), 2 * mm, 1e-17);
  for (const double depth : {0.5 * mm, 1.1 * mm})
    for (const double half_length : {1.2 * mm, 3 * mm}) {
      GearSet other = with_surface_crack();
      auto& surface = std::get<WallSurfaceCrack>(other.flexspline->crack[0]);
      surface.depth = depth;
      surface.half_length = half_length;
      const DriveCrack grown = crack_of(other, "flexspline.crack[0]");
      const CrackSize size = CrackSize::of(depth, half_length);
      for (const Faces state : {Faces::open, Faces::pressed}) {
        const auto a = given.front(size, state);
        const auto b = grown.front(grown.size, state);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
          EXPECT_EQ(a[i].load.I, b[i].load.I);
          EXPECT_EQ(a[i].load.II, b[i].load.II);
          EXPECT_EQ(a[i].load.III, b[i].load.III);
          EXPECT_EQ(a[i].assembly, b[i].assembly);
        }
        EXPECT_EQ(a.back().load.I[kTorsion] == 0, state == Faces::pressed);
      }
    }
}

TEST(DriveCracks, IdentityUnitLoadsGiveTheStressOfEach) {
  // For a short through crack along a generator of a flat wall, K = stress sqrt(pi a) for each
  // load.
  GearSet gear = test::article_gear(1 * mm);
  auto& through = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  through.shell_correction = false;
  through.angle = 90 * deg;
  const DriveCrack crack = crack_of(gear, "flexspline.crack[0]");
  const double r = 78.88 * mm;
  const double t = 2.24 * mm;
  const double root = std::sqrt(pi * 1 * mm);
  const FrontIntensity middle = crack.front(crack.size, Faces::open).at(1);
  const double K_u = gear.flexspline->stress_nonuniformity;
  test::expect_relative(middle.load.I[kAxial], root / (2 * pi * r * t), 1e-12);
  test::expect_relative(std::abs(middle.load.II[kTorsion]), K_u * root / (2 * pi * r * r * t),
                        1e-12);
  // Navier's stress is M/(pi r^2 t) in the middle of the tension side.
  test::expect_relative(crack.bending(crack.size).at(1)[0], root / (pi * r * r * t), 1e-12);
  test::expect_relative(middle.assembly[0], assembly_stress(gear, r, t, 90 * deg).normal * root,
                        1e-12);
}

TEST(DriveCracks, InputReferenceStressNeedsASection) {
  // A crack over half of the circumference, or over the whole length, leaves no net section.
  const auto refused = [](const GearSet& gear, double half_length) {
    const DriveCrack crack = crack_of(gear, "flexspline.crack[0]");
    EXPECT_GT(crack.reference_stress({.size = crack.range_end}, 0.0, 1.0), 0.0);
    try {
      (void)crack.reference_stress({.size = half_length}, 0.0, 1.0);
    } catch (const InputError& error) {
      return error.field() + " = " + error.value();
    }
    return std::string("accepted");
  };
  GearSet gear = test::article_gear(1 * mm);
  auto& through = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  through.angle = 90 * deg;
  EXPECT_EQ(refused(gear, 0.125), "flexspline.crack[0].half_length = 0.125 m");
  through.angle = 0;
  EXPECT_EQ(refused(gear, *gear.flexspline->length / 2),
            "flexspline.crack[0].half_length = 0.08 m");
}

TEST(DriveCracks, IdentityAssemblyOverTheWaveAngle) {
  GearSet gear = with_surface_crack();
  const DriveCrack crack = crack_of(gear, "flexspline.crack[0]");
  EXPECT_TRUE(crack.assembly);
  EXPECT_EQ(crack.assembly_phase(0.0), 1.0);
  EXPECT_NEAR(crack.assembly_phase(pi / 2), -1.0, 1e-15);  // two lobes
  EXPECT_NEAR(crack.assembly_phase(pi / 4), 0.0, 1e-15);
  gear.drive.wave_number = 1;
  EXPECT_FALSE(crack_of(gear, "flexspline.crack[0]").assembly);
}

TEST(DriveCracks, CrosscheckBendingOfTheShaft) {
  GearSet gear = test::article_gear(2 * mm);
  const double D = gear.output_shaft->outer_diameter;
  const double d = gear.output_shaft->inner_diameter;
  DriveCrack crack = crack_of(gear, "output_shaft.crack[0]");
  const sif::HollowAnnularOuterCrack hollow{
      .depth = 2 * mm, .outer_diameter = D, .inner_diameter = d};
  EXPECT_EQ(crack.bending(crack.size).at(0)[0],
            hollow.stress_intensity(2 * mm, 0.0).I[sif::kMoment]);
  gear.output_shaft->inner_diameter = 0.0;
  crack = crack_of(gear, "output_shaft.crack[0]");
  const sif::BarAnnularCrack solid{.depth = 2 * mm, .diameter = D};
  EXPECT_EQ(crack.bending(crack.size).at(0)[0],
            solid.stress_intensity(2 * mm, 0.0).I[sif::kMoment]);
  // Beyond the table of tension the moment counts as tension with the largest stress of bending.
  // Up to the end of the table both roads exist.  They differ by the fall of the stress through the
  // wall and by the crack, which can bend more in one case than in the other: 2 %.
  const auto at_bore = [&](double share) {
    gear.output_shaft->inner_diameter = share * D;
    std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 0.2 * (1 - share) * D / 2;
    const DriveCrack thin = crack_of(gear, "output_shaft.crack[0]");
    return thin.bending(thin.size).at(0)[0];
  };
  EXPECT_NEAR(at_bore(0.9501) / at_bore(0.9499), 1.0, 0.02);
  EXPECT_GT(at_bore(0.96), at_bore(0.9501));
}

TEST(DriveCracks, ScalingRaceCrackFollowsTheLobeForceOfEitherSense) {
  GearSet gear = test::article_gear(1 * mm);
  const DriveCrack crack = crack_of(gear, "wave_generator.crack[0]");
  EXPECT_FALSE(crack.reverses);
  EXPECT_FALSE(crack.unknown.empty());
  EXPECT_FALSE(crack.next_step.empty());
  const CrackLoads<double> loads(gear);
  const auto& given = std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
  const double K =
      loads.loaded(given).solution.stress_intensity(given.depth, pi / 2).I[0] * loads.lobe_force();
  const double T = std::abs(gear.load.torque);
  test::expect_relative(crack.front(crack.size, Faces::open).back().load.I[kTorsion] * T, K, 1e-14);
  EXPECT_EQ(crack.front(crack.size, Faces::open).back().load.I[kAxial], 0.0);
  EXPECT_EQ(crack.reference_stress(crack.size, 0.0, T),
            crack.reference_stress(crack.size, 0.0, -T));
}

TEST(DriveCracks, LimitRaceCrackEndsAsLongAsTheRingIsWide) {
  GearSet gear = test::article_gear(1 * mm);
  const double t = *gear.wave_generator->inner_ring_thickness;
  EXPECT_EQ(crack_of(gear, "wave_generator.crack[0]").range_end, 0.8 * t);
  auto& race = std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
  race.aspect_ratio = 0.5;
  gear.wave_generator->inner_ring_width = 10 * mm;
  const DriveCrack crack = crack_of(gear, "wave_generator.crack[0]");
  test::expect_relative(crack.range_end, 2.5 * mm, 1e-14);
  EXPECT_EQ(crack.range_text, "where the crack is as long as the ring is wide");
  EXPECT_NE(std::ranges::find(crack.equations, "SP-1"), crack.equations.end());
  // A longer crack stays as long as the ring is wide: the width factor is that of c = b.
  const double at_end =
      crack.front({.size = 4 * mm, .aspect_ratio = 0.5}, Faces::open).back().load.I[kTorsion];
  gear.wave_generator->inner_ring_width.reset();
  const double wide = crack_of(gear, "wave_generator.crack[0]")
                          .front({.size = 4 * mm, .aspect_ratio = 0.5}, Faces::open)
                          .back()
                          .load.I[kTorsion];
  test::expect_relative(at_end / wide, 1 / std::sqrt(std::cos(pi / 2 * std::sqrt(4 * mm / t))),
                        1e-12);
}

// Kind: identities of ranges and ligaments with the geometry of each part, written out.  Tolerance
// 1e-12: rounding.

TEST(DriveCracks, IdentityAThroughCrackEndsWhereItsWallEnds) {
  GearSet gear = test::article_gear(1 * mm);
  auto& through = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  const double r = 78.88 * mm;
  const double t = 2.24 * mm;
  const double nearly = 1 - 1e-6;
  const double shell = 4 / std::sqrt(std::sqrt(12 * (1 - 0.3 * 0.3)) / (r * t));
  const auto range_end = [&](double degrees, double length) {
    through.angle = degrees * deg;
    gear.flexspline->length = length;
    return crack_of(gear, "flexspline.crack[0]").range_end;
  };
  test::expect_relative(range_end(90, 160 * mm), shell, 1e-12);
  // A short tube ends before the shell parameter does, whichever way the crack leans.
  for (const double degrees : {0.0, 60.0, -60.0, 120.0})
    test::expect_relative(range_end(degrees, 20 * mm),
                          nearly * 10 * mm / std::abs(std::cos(degrees * deg)), 1e-12);
  // So does half of the circumference of a tube with a thick wall.
  gear.flexspline->wall_thickness = 60 * mm;
  const double thick = 50 * mm;
  for (const double degrees : {90.0, -90.0})
    test::expect_relative(range_end(degrees, 1.0), nearly * pi * thick / 2, 1e-12);
}

TEST(DriveCracks, IdentityASolidShaftEndsAtItsAxis) {
  GearSet gear = test::article_gear(2 * mm);
  gear.output_shaft->inner_diameter = 0;
  const DriveCrack crack = crack_of(gear, "output_shaft.crack[0]");
  test::expect_relative(crack.range_end, (1 - 1e-6) * 35 * mm, 1e-12);
  test::expect_relative(crack.ligament, 33 * mm, 1e-12);
}

TEST(DriveCracks, IdentityLigamentsOfAnEdgeCrackAndAnArc) {
  GearSet gear = test::article_gear(1 * mm);
  RaceEdgeCrack edge;
  edge.depth = 3 * mm;
  edge.contact_factor = 0.45;
  gear.wave_generator->crack = {edge};
  Diaphragm diaphragm;
  diaphragm.outer_diameter = 157 * mm;
  diaphragm.inner_diameter = 60 * mm;
  diaphragm.thickness = 3 * mm;
  gear.flexspline->diaphragm = diaphragm;
  DiaphragmArcCrack arc;
  arc.half_length = 4 * mm;
  arc.radius = 40 * mm;
  gear.flexspline->crack = {arc};
  const DriveCrack race = crack_of(gear, "wave_generator.crack[0]");
  test::expect_relative(race.ligament, 7 * mm, 1e-12);
  test::expect_relative(race.range_end, 0.9 * 10 * mm, 1e-12);
  EXPECT_EQ(race.front(race.size, Faces::open).size(), 1U);
  const DriveCrack wall = crack_of(gear, "flexspline.crack[0]");
  test::expect_relative(wall.ligament, pi * 40 * mm - 4 * mm, 1e-12);
  test::expect_relative(wall.range_end, 20 * mm, 1e-12);
}

TEST(DriveCracks, IdentityAGrooveIsAssessedAtItsEndsAndStations) {
  // (FA-11): the worst place of a groove is an edge of it, or a station of the thickness inside it.
  GearSet gear = test::article_gear(1 * mm);
  Diaphragm diaphragm;
  diaphragm.outer_diameter = 157 * mm;
  diaphragm.inner_diameter = 60 * mm;
  diaphragm.thickness = 4 * mm;
  diaphragm.profile = {{.radius = 35 * mm, .thickness = 4 * mm},
                       {.radius = 41 * mm, .thickness = 2 * mm},
                       {.radius = 50 * mm, .thickness = 4 * mm}};
  gear.flexspline->diaphragm = diaphragm;
  DiaphragmGroove groove;
  groove.depth = 0.5 * mm;
  groove.width = 6 * mm;
  groove.radius = 40 * mm;
  gear.flexspline->crack = {groove};
  const DriveCrack crack = crack_of(gear, "flexspline.crack[0]");
  const auto front = crack.front(crack.size, Faces::open);
  const std::vector<std::array<double, 2>> places = {
      {37 * mm, (4 - 2 * 2.0 / 6) * mm}, {43 * mm, (2 + 2 * 2.0 / 9) * mm}, {41 * mm, 2 * mm}};
  ASSERT_EQ(front.size(), places.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [r, h] = places[i];
    const double shear = 1 / (2 * pi * r * r * h);  // under 1 N*m
    test::expect_relative(front[i].load.III[kTorsion], groove_intensity(shear, 0.5 * mm, h), 1e-12);
    worst = std::max(worst, std::sqrt(3.0) * shear * h / (h - 0.5 * mm));
  }
  test::expect_relative(crack.reference_stress(crack.size, 0.0, 1.0), worst, 1e-12);
  test::expect_relative(crack.ligament, 1.5 * mm, 1e-12);
  test::expect_relative(crack.range_end, (1 - 1e-6) * 2 * mm, 1e-12);
}

TEST(DriveCracks, IdentityBendingAndTensionOfAWallAreTheSameStress) {
  // Navier: a moment M causes the stress of the axial force 2 M/r in the middle of the tension
  // side, so all modes follow.
  GearSet gear = with_surface_crack();
  WallThroughCrack through;
  through.half_length = 2 * mm;
  through.angle = 30 * deg;
  gear.flexspline->crack.emplace_back(through);
  const double r = 78.88 * mm;
  for (const char* const path : {"flexspline.crack[0]", "flexspline.crack[1]"}) {
    const DriveCrack crack = crack_of(gear, path);
    const auto front = crack.front(crack.size, Faces::open);
    const auto bent = crack.bending(crack.size);
    ASSERT_EQ(bent.size(), front.size());
    for (std::size_t i = 0; i < bent.size(); ++i) {
      EXPECT_NEAR(bent[i][0], front[i].load.I[kAxial] * 2 / r, 1e-12 * std::abs(bent[i][0]));
      EXPECT_NEAR(bent[i][1], front[i].load.II[kAxial] * 2 / r, 1e-12 * std::abs(bent[i][1]));
      EXPECT_NEAR(bent[i][2], front[i].load.III[kAxial] * 2 / r, 1e-12 * std::abs(bent[i][2]));
    }
    // (FA-8), (FA-9): an axial force P = sqrt(3) K_u T/r has the equivalent stress of a torque T.
    const double T = 100;
    test::expect_relative(crack.reference_stress(crack.size, std::sqrt(3.0) * 1.1 * T / r, 0.0),
                          crack.reference_stress(crack.size, 0.0, T), 1e-12);
  }
}

// --- Rows
// -----------------------------------------------------------------------------------------------

GearSet with_row_in_wall(int count) {
  GearSet gear = test::article_gear();
  auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  crack.half_length = 4 * units::mm;
  crack.count = count;
  return gear;
}

// Kind: identity (CG-7).  The stress of the assembly acts on the neighbours too, so its K has the
// factors of the row as well as that of the load; the faces of the crack alone have neither.
TEST(DriveCracks, IdentityAssemblyOfARow) {
  const int count = 50;
  const double path = std::numbers::pi * (160 - 2.24) / 2 * units::mm;
  const DriveCrack alone = crack_of(with_row_in_wall(1), "flexspline.crack[0]");
  const DriveCrack row = crack_of(with_row_in_wall(count), "flexspline.crack[0]");
  EXPECT_EQ(alone.count, 1);
  EXPECT_EQ(row.count, count);
  for (const double a : {2 * units::mm, 4 * units::mm}) {
    const RowFactors F = row_factors(a * count / path, std::numbers::pi / 4);
    const Modes one = alone.front({.size = a}, Faces::open).at(1).assembly;
    const Modes all = row.front({.size = a}, Faces::open).at(1).assembly;
    test::expect_relative(
        all[0], std::max(1.0, F.opening_by_normal) * one[0] + F.opening_by_shear * one[1], 1e-12);
    test::expect_relative(
        all[1], F.sliding_by_normal * one[0] + std::max(1.0, F.sliding_by_shear) * one[1], 1e-12);
  }
}

// Kind: identity (CG-7).  The estimate for surface cracks is 1.5 times the largest change of G over
// all directions of the stress, or of pressed faces.  Tolerance: 1e-4, the steps of the direction.
TEST(DriveCracks, IdentityEstimateOfARowOfSurfaceCracks) {
  for (const double angle : {0.0, 0.4, std::numbers::pi / 4, 1.3}) {
    GearSet gear = with_row_in_wall(1);
    const WallSurfaceCrack crack{
        .depth = 0.5 * units::mm, .half_length = 1 * units::mm, .angle = angle, .count = 100};
    gear.flexspline->crack = {crack};
    const double share = 1 * units::mm * 100 / (std::numbers::pi * (160 - 2.24) / 2 * units::mm);
    const RowFactors F = row_factors(share, angle);
    double largest = std::abs(std::pow(pressed_row(share, angle), 2) - 1);
    for (double direction = 0; direction < std::numbers::pi; direction += 1e-3) {
      const double N = std::cos(direction);
      const double S = std::sin(direction);
      const double K_I = F.opening_by_normal * N + F.opening_by_shear * S;
      const double K_II = F.sliding_by_normal * N + F.sliding_by_shear * S;
      largest = std::max(largest, std::abs(K_I * K_I + K_II * K_II - 1));
    }
    test::expect_relative(CrackLoads<double>(gear).row_bound(crack), 1.5 * largest, 1e-4);
  }
}

// Kind: limit (CG-7).  Where tips are about to pass each other, neighbours pull at pressed faces,
// and the range ends there, not at the gap.
TEST(DriveCracks, LimitRangeByTheFacesOfARow) {
  GearSet gear = with_row_in_wall(100);
  auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack[0]);
  crack.angle = 80 * std::numbers::pi / 180;
  crack.half_length = 1 * units::mm;
  crack.shell_correction = false;  // no table ends the range
  using RowState = CrackLoads<double>::RowState;
  const CrackLoads<double> loads(gear);
  const double end = crack_of(gear, "flexspline.crack[0]").range_end;
  crack.half_length = end * 0.999;
  EXPECT_EQ(loads.row_state(crack), RowState::holds);
  crack.half_length = end * 1.001;
  EXPECT_EQ(loads.row_state(crack), RowState::faces);
}

// Kind: limit (CG-7), (CG-8).  The range ends at the end of the table, in a flat plate where the
// gap is a fifth of the half length; that of a surface crack where its neighbours would matter.
TEST(DriveCracks, LimitRangeOfARow) {
  const DriveCrack alone = crack_of(with_row_in_wall(1), "flexspline.crack[0]");
  const DriveCrack row = crack_of(with_row_in_wall(100), "flexspline.crack[0]");
  EXPECT_LE(row.range_end, alone.range_end);
  GearSet steep = with_row_in_wall(100);
  std::get<WallThroughCrack>(steep.flexspline->crack[0]).angle = 1.5;
  std::get<WallThroughCrack>(steep.flexspline->crack[0]).half_length = 1 * units::mm;
  const double radius = (160 - 2.24) / 2 * units::mm;
  const auto share_of = [&](double a) { return a * 100 / (std::numbers::pi * radius); };
  const DriveCrack in_line = crack_of(steep, "flexspline.crack[0]");
  EXPECT_NEAR(share_of(in_line.range_end), sif::largest_tabulated_share(1.5), 1e-5);
  EXPECT_NE(in_line.range_text.find("what is known"), std::string::npos);
  std::get<WallThroughCrack>(steep.flexspline->crack[0]).shell_correction = false;
  std::get<WallThroughCrack>(steep.flexspline->crack[0]).angle = std::numbers::pi / 2;
  const DriveCrack flat = crack_of(steep, "flexspline.crack[0]");
  EXPECT_NEAR(row_gap(share_of(flat.range_end), std::numbers::pi / 2), kLeastRowGap, 1e-4);
  EXPECT_NE(flat.range_text.find("next crack"), std::string::npos);
  GearSet surface = with_row_in_wall(1);
  surface.flexspline->crack = {
      WallSurfaceCrack{.depth = 0.5 * units::mm, .half_length = 1 * units::mm, .count = 40}};
  const DriveCrack shallow = crack_of(surface, "flexspline.crack[0]");
  auto longest = std::get<WallSurfaceCrack>(surface.flexspline->crack[0]);
  longest.half_length = shallow.length_end;
  EXPECT_NEAR(CrackLoads<double>(surface).row_bound(longest), kLargestRowBound, 1e-6);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0 The coupled drive made from a file: its cracks, and its
// refusals.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/friction.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "torsion/solved_drive.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using test::point_at;
using test::share;
using test::supported_drive;
using test::Ts;
using test::twist;

using namespace units;  // NOLINT(google-build-using-namespace): 0.3 * mm reads as it should
using std::numbers::pi;
using test::typical_drive;

// --- cracks inside the contact problem (TC-21), (TC-22), (TC-23) --------------------------------

using AddCrack = std::function<void(GearSet&, double)>;

/// Cracks given by their size: depth over thickness, or loss of stiffness.
const std::map<std::string, AddCrack>& contact_cracks() {
  static const std::map<std::string, AddCrack> all = {
      {"rim", [](GearSet& g, double size) { test::crack_rim(g, size, 0.3); }},
      {"outer_race", [](GearSet& g, double size) { test::crack_outer_race(g, size, 1.3); }},
      {"circular_spline", [](GearSet& g, double size) { test::crack_spline(g, size, 0.3); }},
      {"tooth", [](GearSet& g, double size) { test::crack_tooth(g, 3, size); }},
      {"inner_race", [](GearSet& g, double size) { test::crack_race(g, 1e-7 * size); }},
  };
  return all;
}

double cracked_twist(const AddCrack& add, double size, double T) {
  GearSet gear = supported_drive();
  add(gear, size);
  return twist(gear, T);
}

TEST(ContactCracks, LimitVanishingSize) {
  for (const double T : {Ts()[0], -Ts()[1]}) {
    const double sound = twist(supported_drive(), T);
    for (const auto& [name, add] : contact_cracks())
      // Depth enters as its square, other sizes linearly, so the change is at most 1e-8 plus the
      // error of the solver.
      EXPECT_NEAR(cracked_twist(add, 1e-8, T) / sound, 1, 1e-8) << name;
  }
}

TEST(ContactCracks, IdentityGrowWithTheirSize) {
  const double T = Ts()[1];
  const double sound = twist(supported_drive(), T);
  for (const auto& [name, add] : contact_cracks()) {
    double last = 0.0;
    for (const double size : {0.1, 0.2, 0.35, 0.5}) {
      const double effect = cracked_twist(add, size, T) / sound - 1;
      EXPECT_GT(std::abs(effect), std::abs(last)) << name << " " << size;
      EXPECT_GE(effect * last, 0.0) << name << " changes its sign at " << size;
      last = effect;
    }
    EXPECT_LT(std::abs(last), 0.2) << name;
  }
}

TEST(ContactCracks, IdentityToothOnlyWhereTeethMeet) {
  const double T = Ts()[1];
  const double sound = twist(typical_drive(), T);
  const auto cracked = [&](double position, double torque) {
    GearSet gear = typical_drive();
    gear.mesh->crack.emplace_back(ToothCrack{.stiffness_loss = 1.0, .position = position});
    return twist(gear, torque);
  };
  const CurvePoint state = point_at(typical_drive(), T);
  EXPECT_TRUE(state.coast_flanks.empty());
  for (std::size_t i = 0; i < state.drive_flanks.size(); i += 3)
    EXPECT_GT(cracked(state.drive_flanks[i].position, T), sound);
  // Far from the lobes only rounding remains, because the cracked drive is assembled again.
  for (const double position : {60 * deg, 90 * deg, -90 * deg, 250 * deg})
    test::expect_relative(cracked(position, T), sound, 1e-11);
  const double farthest = std::ranges::max(state.drive_flanks, {}, [](const ContactForce& c) {
                            return std::abs(std::remainder(c.position, pi));
                          }).position;
  const double lobe = pi * std::round(farthest / pi);
  const double other_side = 2 * lobe - farthest;
  EXPECT_NEAR(cracked(other_side, -T), -cracked(farthest, T), 1e-9 * sound);
  // The position selects the nearest tooth: less than half a pitch away is the same tooth, beyond
  // is the next.
  const double pitch = 2 * pi / 100;
  EXPECT_EQ(cracked(0.5 * pitch, T), cracked(0.95 * pitch, T));
  EXPECT_EQ(cracked(0.5 * pitch, T), cracked(0.5 * pitch + 2 * pi, T));
  EXPECT_NE(cracked(0.5 * pitch, T), cracked(1.5 * pitch, T));
}

TEST(ContactCracks, IdentityLostToothCarriesNothing) {
  GearSet gear = typical_drive();
  test::crack_tooth(gear, 3, 1.0);
  const double place = 3.5 * 2 * pi / 100;
  const auto carries = [&](const GearSet& g) {
    return std::ranges::any_of(point_at(g, Ts()[1]).drive_flanks, [&](const ContactForce& c) {
      return std::abs(c.position - place) < 1e-9;
    });
  };
  EXPECT_TRUE(carries(typical_drive()));
  EXPECT_FALSE(carries(gear));
}

TEST(ContactCracks, IdentityCracksOfOneToothMultiply) {
  const double T = Ts()[1];
  GearSet twice = typical_drive();
  test::crack_tooth(twice, 3, 0.5);
  test::crack_tooth(twice, 3, 0.5);
  GearSet once = typical_drive();
  test::crack_tooth(once, 3, 0.75);
  EXPECT_EQ(twist(twice, T), twist(once, T));
}

TEST(ContactCracks, LimitShallowRimCrackIsAHinge) {
  // Castigliano: a hinge of compliance c_M turns the output by c_M M dM/dT, M the moment there.
  // c_M -> 72 pi (1 - nu^2) 1.1215^2 xi^2/(2 E b t^2) for xi = a/t -> 0.
  const test::DriveInputs& in = test::drive_inputs(25, 50);
  const double E = in.at("youngs_modulus");
  const double b = in.at("face_width");
  const double t = in.at("rim_thickness");
  const double R = in.at("rim_radius");
  const double xi = 5e-3;
  const double c_M = 72 * pi * 0.91 * std::pow(1.1215 * xi, 2) / (2 * E * b * t * t);
  const double EI = 1.25 * E * b * t * t * t / 12;
  const CoupledOptions exact{.tolerance = 1e-13};
  const double T = Ts()[1];
  const int n = 4096;
  const int at = 200;  // of 4096: 17.6 degrees
  const auto moment = [&](double torque) {
    // Mean curvature over the softened length 2 t_r, without the uniform expansion of the ring.
    const std::vector<RimState> rim = rim_states(typical_drive(), torque, n, exact);
    double breathing = 0.0;
    for (const RimState& state : rim) breathing += state.radial / n;
    const int half = static_cast<int>(std::lround(t / R * n / (2 * pi)));
    double mean = 0.0;
    for (int i = at - half; i <= at + half; ++i)
      mean += (i == at - half || i == at + half ? 0.5 : 1.0) / (2 * half) *
              rim[static_cast<std::size_t>(i)].barrel_bending_stress.value();
    return EI * (mean * 0.91 / E / (in.at("barrel_thickness") / 2) + breathing / (R * R));
  };
  const double h = 0.01 * T;
  const double expected = c_M * moment(T) * (moment(T + h) - moment(T - h)) / (2 * h);
  GearSet gear = typical_drive();
  const double sound = twist(gear, T, exact);
  test::crack_rim(gear, xi, 2 * pi * at / n);
  // The tolerance covers 3 xi from the factor of the edge crack, 7 xi^2 from the hinge, and 1 %
  // from the grid over the short length.
  EXPECT_NEAR((twist(gear, T, exact) - sound) / expected, 1, 3 * xi + 0.015);
}

TEST(ContactCracks, IdentityBallCrackSoftensTheNearestBall) {
  // Reciprocity of a small compliance in series with ball 1: c Q dQ/dT.
  const double T = Ts()[1];
  GearSet gear = typical_drive();
  const CurvePoint sound = point_at(gear, T, {.tolerance = 1e-12});
  const double c = 1e-11;
  test::crack_race(gear, c);
  const ContactForce& ball = sound.balls.at(1);
  EXPECT_NEAR(
      (twist(gear, T, {.tolerance = 1e-12}) - sound.twist) / (c * ball.force * ball.tangent), 1,
      1e-3);  // next order in c, 1e-4, and rounding of the difference
}

TEST(ContactCracks, IdentityCracksThatDoNotReachTheContacts) {
  const double T = Ts()[1];
  GearSet gear = typical_drive();
  const double sound = twist(gear, T);
  test::crack_spline(gear);
  const TorsionCurve rigid = torsion_curve(gear, {{T}});
  test::expect_relative(rigid.points.at(0).twist, sound, 1e-11);
  EXPECT_EQ(test::count_notes(rigid.notes, "crack.rigid_ring", "circular_spline.support"), 1);

  gear = typical_drive();
  test::crack_race(gear, 1e-8);
  auto& race = std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
  race.contact_factor.reset();
  race.stress_driver = StressDriver::ring_bending;
  const TorsionCurve bent = torsion_curve(gear, {{T}});
  test::expect_relative(bent.points.at(0).twist, sound, 1e-11);
  EXPECT_EQ(test::count_notes(bent.notes, "crack.not_of_a_ball", "wave_generator.crack[0]"), 1);
  // The driver that its next step names makes the crack act, and asks for no other driver.
  EXPECT_NE(bent.notes.at(0).next_step.find("contact_edge"), std::string::npos);
  race.stress_driver = StressDriver::contact_edge;
  const TorsionCurve edge = torsion_curve(gear, {{T}});
  EXPECT_GT(edge.points.at(0).twist, sound * (1 + 1e-9));
  for (const Note& note : edge.notes)
    EXPECT_EQ(note.next_step.find("stress_driver"), std::string::npos) << note.next_step;
}

TEST(ContactCracks, IdentityRaceCrackIsThatOfItsBall) {
  // Neither the load-sharing balls of the series model nor the file's load matter: the crack is
  // evaluated at the force of its own ball.  The notes on its stress are included.
  const double T = Ts()[1];
  GearSet gear = typical_drive();
  test::crack_race(gear, 1e-8);
  const TorsionCurve curve = torsion_curve(gear, {{T}});
  for (const char* const code : {"crack.orthogonal_shear", "crack.under_a_ball"})
    EXPECT_EQ(test::count_notes(curve.notes, code, "wave_generator.crack[0]"), 1) << code;
  GearSet other = gear;
  other.wave_generator->bearing->loaded_balls = 5;
  other.load.torque *= 7;
  EXPECT_EQ(twist(other, T), twist(gear, T));
  // Between the lobes no ball carries.
  auto& race = std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
  race.position = std::acos(-1.0) / 2;
  const TorsionCurve idle = torsion_curve(gear, {{T}});
  EXPECT_EQ(test::count_notes(idle.notes, "crack.unloaded_ball", "wave_generator.crack[0]"), 1);
  test::expect_relative(idle.points.at(0).twist, twist(typical_drive(), T), 1e-12);
}

// Kind: identity.  The ellipse of a file is the flattening 1.5.
TEST(CoupledGeometry, IdentityEllipse) {
  GearSet flat = typical_drive();
  flat.wave_generator->cam_flattening = 1.5;
  GearSet ellipse = typical_drive();
  ellipse.wave_generator->cam =
      Cam{.profile = CamProfile::ellipse, .arc_angle = {}, .disc_offset = {}, .point = {}};
  EXPECT_EQ(twist(ellipse, 30), twist(flat, 30));
  EXPECT_NE(twist(ellipse, 30), twist(typical_drive(), 30));
}

TEST(CoupledGeometry, InputLimitsOfTheModel) {
  const auto field = [](const auto& change) {
    GearSet gear = typical_drive();
    change(gear);
    try {
      (void)torsion_curve(gear, {{1.0}});
    } catch (const InputError& error) {
      return error.field();
    }
    return std::string("none");
  };
  EXPECT_EQ(field([](GearSet& g) { g.wave_generator->bearing->ball_count = 60; }),
            "wave_generator.bearing.ball_count");
  EXPECT_EQ(field([](GearSet& g) { g.wave_generator->bearing->clearance = 1e-3; }),
            "wave_generator.bearing.clearance");
  EXPECT_EQ(field([](GearSet& g) { g.wave_generator->cam_flattening = 6.1; }),
            "wave_generator.cam_flattening");
  EXPECT_EQ(
      field([](GearSet& g) {
        g.wave_generator->cam =
            Cam{.profile = CamProfile::two_arcs, .arc_angle = 0.5, .disc_offset = {}, .point = {}};
      }),
      "wave_generator.cam.profile");
  EXPECT_EQ(field([](GearSet& g) { g.mesh->coning = 5.1; }), "mesh.coning");
  EXPECT_EQ(field([](GearSet& g) { g.drive.radial_displacement *= 2.1; }),
            "drive.radial_displacement");
  EXPECT_EQ(field([](GearSet& g) { g.drive.radial_displacement *= 0.29; }),
            "drive.radial_displacement");
  GearSet locking = typical_drive();
  locking.mesh->friction_coefficient = 0.5;
  EXPECT_THROW((void)sliding_curve(AssembledDrive(locking), {{1.0}}), InputError);
}

// --- cracks in series ---------------------------------------------------------------------------

TEST(SeriesCracks, IdentityTheirAddedCompliance) {
  const GearSet base = [] {
    GearSet gear = typical_drive();
    OutputShaft shaft;
    shaft.material = "steel";
    shaft.outer_diameter = 30 * mm;
    shaft.length = 40 * mm;
    gear.output_shaft = shaft;
    return gear;
  }();
  WallThroughCrack wall;
  wall.half_length = 1 * mm;
  wall.angle = 30 * deg;
  WallSurfaceCrack surface;
  surface.depth = 0.2 * mm;
  surface.half_length = 0.5 * mm;
  surface.angle = -45 * deg;
  const std::vector<FlexsplineCrack> cracks = {
      wall, surface, DiaphragmArcCrack{.half_length = 4 * mm, .radius = 20 * mm},
      DiaphragmGroove{.depth = 0.3 * mm, .width = 1 * mm, .radius = 25 * mm}};
  const auto expect = [&](const GearSet& gear, const CrackReport& report) {
    for (const double T : {30.0, -30.0}) {
      const CurvePoint point = point_at(gear, T);
      const double added = (T > 0 ? report.positive : report.negative).at_output.value;
      const double sound = twist(base, T);
      EXPECT_NEAR(point.twist - sound, added * T, 1e-12 * std::abs(sound)) << report.kind;
      EXPECT_NEAR(share(point, CurveMember::series_cracks) * point.tangent_compliance, added,
                  1e-12 * added);
    }
  };
  for (const FlexsplineCrack& crack : cracks) {
    GearSet gear = base;
    gear.flexspline->crack = {crack};
    expect(gear, flexspline_compliance(gear).cracks.at(0));
  }
  GearSet gear = base;
  gear.output_shaft->crack = {AnnularCrack{.depth = 3 * mm}};
  expect(gear, output_shaft_compliance(gear).cracks.at(0));
}

TEST(SeriesCracks, InputTooLongCrackIsPassedOn) {
  GearSet gear = typical_drive();
  WallThroughCrack wall;
  wall.half_length = 16 * mm;  // shell parameter beyond 4
  wall.angle = 80 * deg;
  gear.flexspline->crack = {wall};
  const TorsionCurve curve = torsion_curve(gear, {{10.0}});
  EXPECT_EQ(curve.unusable_because, flexspline_compliance(gear).unusable_because);
  EXPECT_FALSE(curve.usable());
}

// --- what is missing, refused, or noted ---------------------------------------------------------

/// The refused field; "accepted" if the drive is valid.
std::string refused(const GearSet& gear, const CoupledOptions& options = {}, double torque = 1.0) {
  try {
    (void)torsion_curve(gear, {{torque}}, options);
  } catch (const InputError& error) {
    return std::string(error.field());
  }
  return "accepted";
}

TEST(CoupledGeometry, InputMissingSections) {
  const std::vector<std::pair<std::string, std::function<void(GearSet&)>>> missing = {
      {"wave_generator", [](GearSet& g) { g.wave_generator.reset(); }},
      {"wave_generator.bearing",
       [](GearSet& g) {
         g.wave_generator->bearing.reset();
         g.wave_generator->radial_stiffness = 1e8;
       }},
      {"wave_generator.bearing.ball_count",
       [](GearSet& g) { g.wave_generator->bearing->ball_count.reset(); }},
      {"wave_generator.bearing.outer_ring",
       [](GearSet& g) { g.wave_generator->bearing->outer_ring.reset(); }},
      {"flexspline", [](GearSet& g) { g.flexspline.reset(); }},
      {"flexspline.crack_free",
       [](GearSet& g) {
         g.flexspline->crack_free = CrackFree::factor;
         g.flexspline->rim.reset();
         g.flexspline->barrel.reset();
         g.flexspline->diaphragm.reset();
       }},
      {"flexspline.rim", [](GearSet& g) { g.flexspline->rim.reset(); }},
      {"flexspline.diaphragm",
       [](GearSet& g) {
         g.flexspline->shape = FlexsplineShape::cylinder;
         g.flexspline->diaphragm.reset();
       }},
      {"mesh", [](GearSet& g) { g.mesh.reset(); }},
  };
  EXPECT_EQ(missing_for_torsion_curve(typical_drive()), "");
  EXPECT_EQ(refused(typical_drive()), "accepted");
  for (const auto& [field, change] : missing) {
    GearSet gear = typical_drive();
    change(gear);
    EXPECT_EQ(refused(gear), field);
    EXPECT_TRUE(missing_for_torsion_curve(gear).starts_with(
        field + ": must be given for the torsion curve ("))
        << missing_for_torsion_curve(gear);
    EXPECT_THROW((void)rim_states(gear, 1.0, 4), InputError);
    EXPECT_THROW((void)makers_lines(gear), InputError);
  }
  EXPECT_TRUE(missing_for_torsion_curve(test::article_gear())
                  .starts_with("wave_generator.bearing: must be given"));
}

TEST(CoupledGeometry, InputRulesBrokenOnce) {
  const std::vector<std::pair<std::string, std::function<void(GearSet&)>>> broken = {
      {"drive.wave_number", [](GearSet& g) { g.drive.wave_number = 3; }},
      {"drive.ratio", [](GearSet& g) { g.drive.ratio += 0.25; }},
      {"drive.ratio",
       [](GearSet& g) {
         g.drive.ratio = 9;
         g.drive.radial_displacement = g.drive.pitch_diameter / 18;
       }},
      {"drive.ratio",  // more teeth than memory has room for
       [](GearSet& g) {
         g.drive.ratio = 1500;
         g.drive.radial_displacement = g.drive.pitch_diameter / 3000;
         g.flexspline->rim->outer_diameter = g.drive.pitch_diameter * (1 - 2.4 / 3000);
       }},
      {"flexspline.rim.outer_diameter",
       [](GearSet& g) { g.flexspline->rim->outer_diameter = 63.5 * mm; }},
      {"flexspline.rim.outer_diameter",
       [](GearSet& g) { g.flexspline->rim->outer_diameter = 58.3 * mm; }},
      {"wave_generator.bearing.outer_ring.mean_radius",
       [](GearSet& g) { g.wave_generator->bearing->outer_ring->mean_radius *= 1.01; }},
      {"wave_generator.bearing.outer_ring.mean_radius",
       [](GearSet& g) { g.wave_generator->bearing->outer_ring->mean_radius *= 0.99; }},
      {"wave_generator.bearing.outer_raceway_diameter",
       [](GearSet& g) { g.wave_generator->bearing->outer_raceway_diameter = 62 * mm; }},
      {"material.steel.poissons_ratio",  // what `check` refuses
       [](GearSet& g) { g.material["steel"].poissons_ratio = 0.7; }},
  };
  for (const auto& [field, change] : broken) {
    GearSet gear = typical_drive();
    change(gear);
    EXPECT_EQ(refused(gear), field);
  }
  for (const int N : {7, 129, 0, -1})
    EXPECT_EQ(refused(typical_drive(), {.harmonics = N}), "harmonics");
  for (const int N : {8, 128}) EXPECT_EQ(refused(typical_drive(), {.harmonics = N}), "accepted");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double T : {std::nan(""), infinity, -infinity}) {
    EXPECT_EQ(refused(typical_drive(), {}, T), "torque");
    EXPECT_THROW((void)rim_states(typical_drive(), T, 4), InputError);
  }
  for (const int positions : {0, -1})
    EXPECT_THROW((void)rim_states(typical_drive(), 1.0, positions), InputError);
}

}  // namespace
}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0 Breaks every rule once, and tests every boundary that a rule
// still accepts.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "support/article_gear.hpp"
#include "support/not_finite.hpp"

namespace strainwave {
namespace {

using test::kInfinity;
using test::kNaN;

using namespace units;  // NOLINT(google-build-using-namespace): 3 * mm reads as it should
using std::numbers::pi;
using test::article_gear;

/// The message that refuses a gear; "accepted" if it is valid.
InputError refusal(const GearSet& gear) {
  try {
    check(gear);
  } catch (const InputError& error) {
    return error;
  }
  return {"", "accepted"};
}

/// A second sound drive with the parts that the article's drive lacks.
GearSet sections_gear() {
  GearSet gear = article_gear();
  gear.name = "sections";
  gear.article.reset();

  WaveGenerator& wg = *gear.wave_generator;
  wg.radial_stiffness.reset();
  wg.contact_semi_axes.reset();
  wg.bearing = Bearing{
      .ball_diameter = 12.7 * mm,
      .inner_raceway_diameter = 110 * mm,
      .outer_raceway_diameter = 135.4 * mm,
      .loaded_balls = 3,
      .ball_count = 23,
      .outer_ring = BearingRing{.mean_radius = 70 * mm, .thickness = 4 * mm, .width = 20 * mm}};
  wg.inner_ring_width = 20 * mm;
  wg.inner_ring_mean_radius = 60 * mm;
  RaceSurfaceCrack bent;
  bent.depth = 1 * mm;
  bent.aspect_ratio = 0.5;
  bent.stress_driver = StressDriver::ring_bending;
  RaceEdgeCrack edge;
  edge.depth = 1 * mm;
  edge.stress_driver = StressDriver::given;
  edge.stress = -5 * MPa;
  wg.crack = {bent, edge};

  Flexspline& fs = *gear.flexspline;
  fs.crack_free = CrackFree::sections;
  fs.rim = TubeSection{.outer_diameter = 160 * mm, .wall_thickness = 3 * mm, .length = 30 * mm};
  fs.barrel = TubeSection{.outer_diameter = 158 * mm, .wall_thickness = 2 * mm, .length = 100 * mm};
  fs.diaphragm = Diaphragm{
      .outer_diameter = 154 * mm, .inner_diameter = 80 * mm, .thickness = 3 * mm, .profile = {}};
  fs.boss = Boss{{.outer_diameter = 80 * mm, .wall_thickness = 10 * mm, .length = 10 * mm}};
  WallSurfaceCrack in_rim;
  in_rim.depth = 1 * mm;
  in_rim.half_length = 2 * mm;
  in_rim.section = WallSection::rim;
  WallThroughCrack in_barrel;
  in_barrel.half_length = 1 * mm;
  fs.crack = {in_rim, in_barrel};
  return gear;
}

/// The second drive as a sound silk hat.
GearSet hat_gear() {
  GearSet gear = sections_gear();
  Flexspline& fs = *gear.flexspline;
  fs.shape = FlexsplineShape::hat;
  fs.diaphragm = Diaphragm{
      .outer_diameter = 210 * mm, .inner_diameter = 156 * mm, .thickness = 3 * mm, .profile = {}};
  fs.boss.reset();
  fs.crack.clear();
  return gear;
}

/// The second drive with the inputs of the torsion curve and its cracks.
GearSet coupled_gear() {
  GearSet gear = sections_gear();
  gear.name = "coupled";
  OuterRaceCrack outer_race;
  outer_race.depth = 1 * mm;
  gear.wave_generator->crack.emplace_back(outer_race);
  RimAxialCrack rim_axial;
  rim_axial.depth = 1 * mm;
  gear.flexspline->diaphragm->profile = {{.radius = 42 * mm, .thickness = 5 * mm},
                                         {.radius = 50 * mm, .thickness = 2 * mm}};
  gear.flexspline->crack = {rim_axial, DiaphragmArcCrack{.half_length = 3 * mm, .radius = 45 * mm},
                            DiaphragmGroove{.depth = 0.5 * mm, .width = 1 * mm, .radius = 60 * mm}};
  gear.mesh = ToothMesh{};
  gear.mesh->crack.emplace_back(ToothCrack{.stiffness_loss = 1.0, .position = 0.1});
  CircularSpline spline;
  spline.material = "steel";
  spline.outer_diameter = 214 * mm;
  spline.inner_diameter = 164 * mm;
  spline.width = 25 * mm;
  spline.support = 0.5;
  CircularSplineRingCrack ring;
  ring.depth = 2 * mm;
  spline.crack = {ring};
  gear.circular_spline = spline;
  Rating rating;
  rating.T1 = 212;
  rating.T2 = 766;
  rating.T3 = 1226;
  gear.rating = rating;
  gear.range = {InputRange{.path = "flexspline.wall_thickness",
                           .lower = "2 mm",
                           .upper = "2.5 mm",
                           .knowledge = Knowledge::typical,
                           .source = "drawing"},
                InputRange{.path = "mesh.friction_coefficient",
                           .lower = "0",
                           .upper = "0.1",
                           .knowledge = Knowledge::assumed,
                           .source = ""}};
  gear.scatter = {InputScatter{.path = "flexspline.wall_thickness",
                               .relative_standard_deviation = 0.01,
                               .source = "drawing"},
                  InputScatter{.path = "material.steel.youngs_modulus",
                               .relative_standard_deviation = 0.02,
                               .distribution = ScatterDistribution::normal,
                               .source = ""}};
  return gear;
}

Diaphragm& diaphragm(GearSet& gear) { return *gear.flexspline->diaphragm; }

/// Adds the same crack a second time at another position [rad].
template <class Cracks, class Crack>
void crack_again(Cracks& cracks, Crack crack, double position) {
  crack.position = position;
  cracks.emplace_back(crack);
}

/// A table of quantiles in place of the first scatter.
InputScatter& scatter_table(GearSet& gear) {
  InputScatter& scatter = gear.scatter[0];
  scatter.distribution = ScatterDistribution::table;
  scatter.relative_standard_deviation.reset();
  scatter.quantile = {{0.0, 0.9}, {0.5, 1.0}, {1.0, 1.2}};
  return scatter;
}

/// A correlation of the two scatters.
InputCorrelation& correlation(GearSet& gear) {
  gear.correlation = {{.path = gear.scatter[0].path,
                       .with = gear.scatter[1].path,
                       .rank_correlation = 0.5,
                       .source = {}}};
  return gear.correlation[0];
}

/// An inspection of all cracks by a curve.
Inspection& inspection(GearSet& gear) {
  gear.inspection = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  return *gear.inspection;
}

/// An inspection by the stiffness of the drive.
Inspection& measurement(GearSet& gear) {
  gear.inspection =
      Inspection{.method = InspectionMeans::stiffness, .noise = 0.01, .false_calls = 0.05};
  return *gear.inspection;
}

RimAxialCrack& rim_axial_crack(GearSet& gear) {
  return std::get<RimAxialCrack>(gear.flexspline->crack[0]);
}
DiaphragmArcCrack& arc_crack(GearSet& gear) {
  return std::get<DiaphragmArcCrack>(gear.flexspline->crack[1]);
}
DiaphragmGroove& groove(GearSet& gear) {
  return std::get<DiaphragmGroove>(gear.flexspline->crack[2]);
}

WaveGenerator& wave_generator(GearSet& gear) { return *gear.wave_generator; }
Flexspline& flexspline(GearSet& gear) { return *gear.flexspline; }
OutputShaft& shaft(GearSet& gear) { return *gear.output_shaft; }
/// What the steel states for growth and fatigue; made on the first call.
GrowthBounds& growth_bounds(GearSet& gear) {
  auto& bounds = gear.material["steel"].growth_bounds;
  return bounds ? *bounds : bounds.emplace();
}
/// The scatter of growth of the steel, with all parts; made on the first call.
GrowthScatter& growth_scatter(GearSet& gear) {
  auto& scatter = gear.material["steel"].growth_scatter;
  return scatter ? *scatter
                 : scatter.emplace(GrowthScatter{.level = 0.1,
                                                 .level_correlation = 0.5,
                                                 .exponent = 0.1,
                                                 .exponent_correlation = 0.2,
                                                 .pivot = 15e6,
                                                 .wander = 0.1,
                                                 .wander_length = 0.2,
                                                 .white = 0.1,
                                                 .white_step = 1e-4});
}
FatigueStrength& fatigue(GearSet& gear) {
  auto& strength = gear.material["steel"].fatigue;
  return strength ? *strength : strength.emplace(FatigueStrength{.limit = 400e6});
}
RaceSurfaceCrack& race_crack(GearSet& gear) {
  return std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]);
}
RaceEdgeCrack& edge_crack(GearSet& gear) {
  return std::get<RaceEdgeCrack>(gear.wave_generator->crack[1]);
}
WallThroughCrack& through_crack(GearSet& gear) {
  return std::get<WallThroughCrack>(gear.flexspline->crack[0]);
}
WallSurfaceCrack& rim_crack(GearSet& gear) {
  return std::get<WallSurfaceCrack>(gear.flexspline->crack[0]);
}
WallThroughCrack& barrel_crack(GearSet& gear) {
  return std::get<WallThroughCrack>(gear.flexspline->crack[1]);
}
AnnularCrack& annular_crack(GearSet& gear) {
  return std::get<AnnularCrack>(gear.output_shaft->crack[0]);
}

TEST(Check, InputSoundDrivesAreAccepted) {
  EXPECT_STREQ(refusal(article_gear()).what(), ": accepted");
  EXPECT_STREQ(refusal(sections_gear()).what(), ": accepted");
  EXPECT_STREQ(refusal(coupled_gear()).what(), ": accepted");
}

// --- Rules between fields ------------------------------------------------------------------------

using Mutation =
    void (*)(GearSet&);  // a std::function would add ten functions to each of 400 lambdas

/// One rule, broken by one change of a sound drive.
struct Broken {
  std::string name;
  GearSet (*base)();
  Mutation change;
  std::string field;
  std::string rule;     ///< rule of a number; else empty
  std::string problem;  ///< the message after the field, if the message is not a rule

  friend std::ostream& operator<<(std::ostream& out, const Broken& b) { return out << b.name; }
};

GearSet article() { return article_gear(); }

const std::vector<Broken> kBroken = {
    {"Format", article, [](GearSet& g) { g.format = "strainwave-drive/2"; }, "format", "",
     "\"strainwave-drive/2\" is not known; this version reads \"strainwave-drive/1\""},
    {"FormatEmpty", article, [](GearSet& g) { g.format.clear(); }, "format", "",
     "\"\" is not known; this version reads \"strainwave-drive/1\""},
    {"NameOfTwoLines", article, [](GearSet& g) { g.name = "one\ntwo"; }, "name", "",
     "must be one line, without control characters"},
    {"NameWithEscapes", article, [](GearSet& g) { g.name = "\x1b[31m"; }, "name", "",
     "must be one line, without control characters"},

    // materials
    {"MaterialOfOneConstant", article,
     [](GearSet& g) {
       g.material["steel"].shear_modulus.reset();
       g.material["steel"].poissons_ratio.reset();
     },
     "material.steel.poissons_ratio", "", "must be given, or shear_modulus"},
    {"MaterialIncompressible", article,
     [](GearSet& g) {
       g.material["steel"].shear_modulus = 70 * GPa;
       g.material["steel"].poissons_ratio.reset();
     },
     "material.steel.shear_modulus", "Poisson's ratio E/(2G) - 1 > -1 and < 0.5", ""},
    {"MaterialWeakerThanItsYield", article,
     [](GearSet& g) {
       g.material["steel"].yield_strength = 900e6;
       g.material["steel"].ultimate_strength = 899e6;
     },
     "material.steel.ultimate_strength", "ultimate_strength >= yield_strength", ""},
    {"MaterialUnusedButWrong", article, [](GearSet& g) { g.material["air"].youngs_modulus = 1; },
     "material.air.poissons_ratio", "", "must be given, or shear_modulus"},
    {"MaterialUnknownWaveGenerator", article,
     [](GearSet& g) { wave_generator(g).material = "stel"; }, "wave_generator.material", "",
     "\"stel\" is not one of the materials given (steel)"},
    {"MaterialUnknownFlexspline", article, [](GearSet& g) { flexspline(g).material = ""; },
     "flexspline.material", "", "\"\" is not one of the materials given (steel)"},
    {"MaterialUnknownShaft", article, [](GearSet& g) { shaft(g).material = "Steel"; },
     "output_shaft.material", "", "\"Steel\" is not one of the materials given (steel)"},

    // drive and load
    {"NoWave", article, [](GearSet& g) { g.drive.wave_number = 0; }, "drive.wave_number",
     ">= 1 and <= 8", ""},
    {"NegativeWaves", article, [](GearSet& g) { g.drive.wave_number = -2; }, "drive.wave_number",
     ">= 1 and <= 8", ""},
    {"NineWaves", article, [](GearSet& g) { g.drive.wave_number = 9; }, "drive.wave_number",
     ">= 1 and <= 8", ""},
    {"DisplacementOfTheRadius", article,
     [](GearSet& g) { g.drive.radial_displacement = g.drive.pitch_diameter / 2; },
     "drive.radial_displacement", "radial_displacement < pitch_diameter/2", ""},
    {"NoTorque", article, [](GearSet& g) { g.load.torque = 0; }, "load.torque", "torque != 0", ""},
    {"NegativeZeroTorque", article, [](GearSet& g) { g.load.torque = -0.0; }, "load.torque",
     "torque != 0", ""},
    {"NoMember", article,
     [](GearSet& g) {
       g.wave_generator.reset();
       g.flexspline.reset();
       g.output_shaft.reset();
     },
     "flexspline", "", "at least one of wave_generator, flexspline, output_shaft must be given"},

    // wave generator: sources of its stiffness
    {"NoRadialStiffness", article, [](GearSet& g) { wave_generator(g).radial_stiffness.reset(); },
     "wave_generator.radial_stiffness", "",
     "must be given (K_G0 of one lobe [N/m]), or displacements, or bearing"},
    {"StiffnessAndDisplacements", article,
     [](GearSet& g) { wave_generator(g).displacements = LobeDisplacements{.bearing = 3e-6}; },
     "wave_generator.displacements", "",
     "is a second source of the radial stiffness; give only one of radial_stiffness, displacements, bearing"},
    {"StiffnessAndBearing", sections_gear,
     [](GearSet& g) { wave_generator(g).radial_stiffness = 1e8; }, "wave_generator.bearing", "",
     "is a second source of the radial stiffness; give only one of radial_stiffness, displacements, bearing"},
    {"DisplacementsAndBearing", sections_gear,
     [](GearSet& g) { wave_generator(g).displacements = LobeDisplacements{.bearing = 3e-6}; },
     "wave_generator.bearing", "",
     "is a second source of the radial stiffness; give only one of radial_stiffness, displacements, bearing"},
    {"AllThreeSources", sections_gear,
     [](GearSet& g) {
       wave_generator(g).radial_stiffness = 1e8;
       wave_generator(g).displacements = LobeDisplacements{.bearing = 3e-6};
     },
     "wave_generator.displacements", "",
     "is a second source of the radial stiffness; give only one of radial_stiffness, displacements, bearing"},
    {"NoDisplacementAtAll", article,
     [](GearSet& g) {
       wave_generator(g).radial_stiffness.reset();
       wave_generator(g).displacements = LobeDisplacements{};
     },
     "wave_generator.displacements.bearing", "bearing + cam + shaft > 0", ""},

    // wave generator: geometry
    {"SemiAxesSwapped", article,
     [](GearSet& g) {
       wave_generator(g).contact_semi_axes = {2 * mm, 5 * mm};
     },
     "wave_generator.contact_semi_axes[1]", "second semi-axis <= first semi-axis", ""},
    {"RingThickerThanItsRadius", sections_gear,
     [](GearSet& g) { wave_generator(g).inner_ring_thickness = 60 * mm; },
     "wave_generator.inner_ring_thickness", "inner_ring_thickness < inner_ring_mean_radius", ""},
    {"RacewaysSwapped", sections_gear,
     [](GearSet& g) {
       std::swap(wave_generator(g).bearing->inner_raceway_diameter,
                 wave_generator(g).bearing->outer_raceway_diameter);
     },
     "wave_generator.bearing.outer_raceway_diameter",
     "outer_raceway_diameter > inner_raceway_diameter", ""},
    {"RacewaysEqual", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->outer_raceway_diameter = 110 * mm; },
     "wave_generator.bearing.outer_raceway_diameter",
     "outer_raceway_diameter > inner_raceway_diameter", ""},
    {"BallLargerThanTheGap", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->ball_diameter = 12.701 * mm; },
     "wave_generator.bearing.ball_diameter",
     "ball_diameter <= (outer_raceway_diameter - inner_raceway_diameter)/2", ""},
    {"ContactGivenAndOfTheBearing", sections_gear,
     [](GearSet& g) {
       wave_generator(g).contact_semi_axes = {5 * mm, 2 * mm};
     },
     "wave_generator.contact_semi_axes", "",
     "is a second source of the contact, which follows from bearing; remove one of them"},
    {"OuterRingThickerThanItsRadius", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->outer_ring->thickness = 70 * mm; },
     "wave_generator.bearing.outer_ring.thickness", "thickness < mean_radius", ""},
    {"OuterRingBentByOneLobe", sections_gear,
     [](GearSet& g) {
       g.drive.wave_number = 1;
       wave_generator(g).crack.clear();
     },
     "drive.wave_number", "wave_number >= 2 where a ring bends between lobes", ""},

    // wave generator: cracks
    {"RaceCrackInUnknownRing", article,
     [](GearSet& g) { wave_generator(g).inner_ring_thickness.reset(); },
     "wave_generator.inner_ring_thickness", "",
     "must be given for wave_generator.crack[0] (inner ring thickness t_i [m])"},
    {"RaceCrackThroughTheRing", article, [](GearSet& g) { race_crack(g).depth = 10 * mm; },
     "wave_generator.crack[0].depth", "depth < inner_ring_thickness", ""},
    {"EdgeCrackThroughTheRing", sections_gear, [](GearSet& g) { edge_crack(g).depth = 10 * mm; },
     "wave_generator.crack[1].depth", "depth < inner_ring_thickness", ""},
    {"OrthogonalShearWithoutContact", article,
     [](GearSet& g) { wave_generator(g).contact_semi_axes.reset(); },
     "wave_generator.contact_semi_axes", "",
     "must be given for wave_generator.crack[0] (stress_driver = \"orthogonal_shear\" needs it)"},
    {"ContactEdgeWithoutContact", article,
     [](GearSet& g) {
       wave_generator(g).contact_semi_axes.reset();
       race_crack(g).stress_driver = StressDriver::contact_edge;
     },
     "wave_generator.contact_semi_axes", "",
     "must be given for wave_generator.crack[0] (stress_driver = \"contact_edge\" needs it)"},
    {"RingBendingWithoutWidth", sections_gear,
     [](GearSet& g) { wave_generator(g).inner_ring_width.reset(); },
     "wave_generator.inner_ring_width", "",
     "must be given for wave_generator.crack[0] (stress_driver = \"ring_bending\" needs it)"},
    {"RingBendingWithoutRadius", sections_gear,
     [](GearSet& g) { wave_generator(g).inner_ring_mean_radius.reset(); },
     "wave_generator.inner_ring_mean_radius", "",
     "must be given for wave_generator.crack[0] (stress_driver = \"ring_bending\" needs it)"},
    {"RingBendingByOneLobe", sections_gear,
     [](GearSet& g) {
       g.drive.wave_number = 1;
       wave_generator(g).bearing->outer_ring.reset();
     },
     "drive.wave_number", "wave_number >= 2 where a ring bends between lobes", ""},
    {"GivenStressNotGiven", sections_gear, [](GearSet& g) { edge_crack(g).stress.reset(); },
     "wave_generator.crack[1].stress", "",
     "must be given for wave_generator.crack[1] (stress_driver = \"given\" needs it)"},
    {"StressNotRead", article, [](GearSet& g) { race_crack(g).stress = 5 * MPa; },
     "wave_generator.crack[0].stress", "", "is read only with stress_driver = \"given\""},
    {"ContactFactorNotRead", article,
     [](GearSet& g) { race_crack(g).stress_driver = StressDriver::contact_edge; },
     "wave_generator.crack[0].contact_factor", "",
     "is read only with stress_driver = \"orthogonal_shear\""},
    {"EdgeCrackInRingOfUnknownWidth", sections_gear,
     [](GearSet& g) {
       wave_generator(g).inner_ring_width.reset();
       wave_generator(g).crack.erase(wave_generator(g).crack.begin());
     },
     "wave_generator.inner_ring_width", "",
     "must be given for an edge crack (axial width of the ring [m])"},

    // flexspline
    {"WallOfTheRadius", article, [](GearSet& g) { flexspline(g).wall_thickness = 80 * mm; },
     "flexspline.wall_thickness", "wall_thickness < drive.pitch_diameter/2", ""},
    {"RimOfTheRadius", sections_gear,
     [](GearSet& g) { flexspline(g).rim->wall_thickness = 80 * mm; },
     "flexspline.rim.wall_thickness", "wall_thickness < outer_diameter/2", ""},
    {"BarrelOfTheRadius", sections_gear,
     [](GearSet& g) { flexspline(g).barrel->wall_thickness = 79 * mm; },
     "flexspline.barrel.wall_thickness", "wall_thickness < outer_diameter/2", ""},
    {"BossOfTheRadius", sections_gear,
     [](GearSet& g) { flexspline(g).boss->wall_thickness = 40 * mm; },
     "flexspline.boss.wall_thickness", "wall_thickness < outer_diameter/2", ""},
    {"DiaphragmWithoutWidth", sections_gear,
     [](GearSet& g) { flexspline(g).diaphragm->inner_diameter = 154 * mm; },
     "flexspline.diaphragm.inner_diameter", "inner_diameter < outer_diameter", ""},
    {"SectionsWithoutBarrel", sections_gear, [](GearSet& g) { flexspline(g).barrel.reset(); },
     "flexspline.barrel", "", "must be given where crack_free = \"sections\" (smooth tube)"},
    {"SectionsLongerThanTheFlexspline", sections_gear,
     [](GearSet& g) { flexspline(g).length = 129.9 * mm; }, "flexspline.length",
     "length >= barrel.length + rim.length", ""},
    {"BarrelLongerThanTheFlexspline", sections_gear,
     [](GearSet& g) {
       flexspline(g).rim.reset();
       rim_crack(g).section = WallSection::barrel;
       flexspline(g).length = 99.9 * mm;
     },
     "flexspline.length", "length >= barrel.length + rim.length", ""},
    {"SectionsWithShapeFactor", sections_gear,
     [](GearSet& g) { flexspline(g).shape_factor = 0.83; }, "flexspline.shape_factor", "",
     "is read only where crack_free = \"factor\""},
    {"CupWithoutBottom", sections_gear, [](GearSet& g) { flexspline(g).diaphragm.reset(); },
     "flexspline.diaphragm", "",
     "must be given for a cup where crack_free = \"sections\" (bottom)"},
    {"FactorWithRim", article,
     [](GearSet& g) {
       flexspline(g).rim = TubeSection{1, 0.1, 1};
     },
     "flexspline.rim", "", "is read only where crack_free = \"sections\""},
    {"FactorWithBarrel", article,
     [](GearSet& g) {
       flexspline(g).barrel = TubeSection{1, 0.1, 1};
     },
     "flexspline.barrel", "", "is read only where crack_free = \"sections\""},
    {"FactorWithDiaphragm", article,
     [](GearSet& g) {
       flexspline(g).diaphragm = Diaphragm{1, 0.1, 1, {}};
     },
     "flexspline.diaphragm", "", "is read only where crack_free = \"sections\""},
    {"FactorWithBoss", article,
     [](GearSet& g) {
       flexspline(g).boss = Boss{{1, 0.1, 1}};
     },
     "flexspline.boss", "", "is read only where crack_free = \"sections\""},

    // flexspline: cracks
    {"CrackInRimThatIsNotThere", sections_gear, [](GearSet& g) { flexspline(g).rim.reset(); },
     "flexspline.crack[0].section", "", "\"rim\" needs a [flexspline.rim]"},
    {"CrackInRimOfTheFactor", article,
     [](GearSet& g) { through_crack(g).section = WallSection::rim; }, "flexspline.crack[0].section",
     "", "is read only where crack_free = \"sections\""},
    {"AxialCrackOfTheLength", article,
     [](GearSet& g) {
       through_crack(g).angle = 0;
       through_crack(g).half_length = 80 * mm;
     },
     "flexspline.crack[0].half_length", "2 half_length cos(angle) < length of the tube", ""},
    {"AxialCrackOfTheBarrel", sections_gear,
     [](GearSet& g) {
       barrel_crack(g).angle = 0;
       barrel_crack(g).half_length = 50 * mm;
     },
     "flexspline.crack[1].half_length", "2 half_length cos(angle) < length of the tube", ""},
    {"AxialCrackOfTheRim", sections_gear,
     [](GearSet& g) {
       rim_crack(g).angle = 0;
       rim_crack(g).half_length = 15 * mm;
     },
     "flexspline.crack[0].half_length", "2 half_length cos(angle) < length of the tube", ""},
    {"CrackAcrossTheLowerEnd", sections_gear,
     [](GearSet& g) { barrel_crack(g).distance = 0.7 * mm; }, "flexspline.crack[1].distance",
     "half_length cos(angle) < distance < length of the tube - half_length cos(angle), that is, "
     "between 0.7071 mm and 99.29 mm",
     ""},
    {"CrackAcrossTheUpperEnd", sections_gear,
     [](GearSet& g) { barrel_crack(g).distance = 99.5 * mm; }, "flexspline.crack[1].distance",
     "half_length cos(angle) < distance < length of the tube - half_length cos(angle), that is, "
     "between 0.7071 mm and 99.29 mm",
     ""},
    {"CircumferentialCrackAllRound", article,
     [](GearSet& g) {
       through_crack(g).angle = pi / 2;
       through_crack(g).half_length = pi / 2 * (160 - 2.24) * mm * (1 + 1e-12);
     },
     "flexspline.crack[0].half_length", "2 half_length |sin(angle)| < circumference of the tube",
     ""},
    {"NegativeAngleAllRound", article,
     [](GearSet& g) {
       flexspline(g).length = 10;
       through_crack(g).angle = -pi / 4;
       through_crack(g).half_length = 400 * mm;
     },
     "flexspline.crack[0].half_length", "2 half_length |sin(angle)| < circumference of the tube",
     ""},
    {"RowThatTouches", article,
     [](GearSet& g) {
       through_crack(g).angle = pi / 2;
       through_crack(g).half_length = 25 * mm;
       through_crack(g).count = 10;
     },
     "flexspline.crack[0].count",
     "2 half_length count < 495.6 mm, the circumference, or the cracks touch", ""},
    {"ArcsThatTouch", hat_gear,
     [](GearSet& g) {
       flexspline(g).crack = {
           DiaphragmArcCrack{.half_length = 70 * mm, .radius = 100 * mm, .count = 5}};
     },
     "flexspline.crack[0].count",
     "2 half_length count < 628.3 mm, the circumference, or the cracks touch", ""},
    {"RowWithoutCracks", article, [](GearSet& g) { through_crack(g).count = 0; },
     "flexspline.crack[0].count", ">= 1 and <= 2000", ""},
    {"ComplianceTableOfOneCrackForARow", article,
     [](GearSet& g) {
       through_crack(g).count = 3;
       through_crack(g).compliance_table = "table.csv";
     },
     "flexspline.crack[0].compliance_table", "",
     "is of one crack, but count is 3; leave out the table or give count = 1"},
    {"TurnTableOfOneCrackForARow", article,
     [](GearSet& g) {
       through_crack(g).count = 2;
       through_crack(g).turn_table = "turn.csv";
     },
     "flexspline.crack[0].turn_table", "",
     "is of one crack, but count is 2; leave out the table or give count = 1"},
    {"SurfaceCrackThroughTheWall", sections_gear,
     [](GearSet& g) {
       rim_crack(g).half_length = 5 * mm;
       rim_crack(g).depth = 3 * mm;
     },
     "flexspline.crack[0].depth", "depth < wall_thickness", ""},
    {"SurfaceCrackDeeperThanLong", sections_gear,
     [](GearSet& g) { rim_crack(g).half_length = 0.99 * mm; }, "flexspline.crack[0].half_length",
     "half_length >= depth", ""},

    {"RaceCrackLongerThanTheRingIsWide", sections_gear,
     [](GearSet& g) { race_crack(g).aspect_ratio = 0.05; }, "wave_generator.crack[0].aspect_ratio",
     ">= 0.1: the crack runs along the axis, and its length 2c = 2 depth/aspect_ratio = 40 mm must "
     "fit into the ring, 20 mm wide (inner_ring_width)",
     ""},
    {"RaceCrackLongerThanTheRingIsRound", article,
     [](GearSet& g) { race_crack(g).aspect_ratio = 3.9e-4; }, "wave_generator.crack[0].aspect_ratio",
     ">= 0.0003979: the crack runs along the axis, and its length 2c = 2 depth/aspect_ratio = 512.8 "
     "mm must fit into the ring, 502.7 mm round (no inner_ring_width is given)",
     ""},
    {"LengthMissing", article, [](GearSet& g) { flexspline(g).length.reset(); },
     "flexspline.length", "", "must be given where crack_free = \"factor\" [m]"},
    {"WallThicknessMissing", article, [](GearSet& g) { flexspline(g).wall_thickness.reset(); },
     "flexspline.wall_thickness", "", "must be given where crack_free = \"factor\" [m]"},
    {"BallsThatOverlap", coupled_gear,
     [](GearSet& g) { wave_generator(g).bearing->ball_count = 31; },
     "wave_generator.bearing.ball_count",
     "<= 30: more balls of 12.7 mm overlap on their pitch circle of 122.7 mm", ""},
    {"MoreLoadedBallsThanBalls", coupled_gear,
     [](GearSet& g) { wave_generator(g).bearing->loaded_balls = 23.5; },
     "wave_generator.bearing.loaded_balls", "<= ball_count, 23", ""},

    // coupled drive: balls and rings
    {"TwoBalls", coupled_gear, [](GearSet& g) { wave_generator(g).bearing->ball_count = 2; },
     "wave_generator.bearing.ball_count", ">= 3 and <= 200", ""},
    {"TooManyBalls", coupled_gear, [](GearSet& g) { wave_generator(g).bearing->ball_count = 201; },
     "wave_generator.bearing.ball_count", ">= 3 and <= 200", ""},
    {"InnerRingNarrowerThanTheGroove", sections_gear,
     [](GearSet& g) { wave_generator(g).inner_ring_width = 0.1 * mm; },
     "wave_generator.inner_ring_width",
     fmt::format(">= wave_generator.bearing.ball_diameter/2, {:.4g} mm: the balls run in a groove "
                 "of the ring",
                 1e3 * sections_gear().wave_generator->bearing->ball_diameter / 2),
     ""},
    {"OuterRingNarrowerThanTheGroove", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->outer_ring->width = 0.1 * mm; },
     "wave_generator.bearing.outer_ring.width",
     fmt::format(">= wave_generator.bearing.ball_diameter/2, {:.4g} mm: the balls run in a groove "
                 "of the ring",
                 1e3 * sections_gear().wave_generator->bearing->ball_diameter / 2),
     ""},
    {"InnerRingNarrowerThanTheContact", article,
     [](GearSet& g) { wave_generator(g).inner_ring_width = 3.9 * mm; },
     "wave_generator.inner_ring_width",
     ">= 2 contact_semi_axes[1], 4 mm: the contact lies on the ring", ""},
    {"BarrelApartFromTheRim", sections_gear,
     [](GearSet& g) { flexspline(g).barrel->outer_diameter = 119 * mm; },
     "flexspline.barrel.outer_diameter",
     "within 25 % of rim.outer_diameter, 160 mm, because the barrel joins the rim", ""},
    {"DiaphragmApartFromTheBarrel", sections_gear,
     [](GearSet& g) { flexspline(g).diaphragm->outer_diameter = 118 * mm; },
     "flexspline.diaphragm.outer_diameter",
     "within 25 % of barrel.outer_diameter, 158 mm, because the diaphragm joins the barrel", ""},
    {"CupWithTheDiaphragmOfAHat", sections_gear,
     [](GearSet& g) {
       flexspline(g).diaphragm->inner_diameter = 156 * mm;
       flexspline(g).diaphragm->outer_diameter = 220 * mm;
     },
     "flexspline.shape", "",
     "is \"cup\", but the diaphragm, 156 to 220 mm in diameter, lies outside of the barrel, 158 mm; give shape = \"hat\" or correct the diameters"},
    {"HatWithTheDiaphragmOfACup", hat_gear,
     [](GearSet& g) { diaphragm(g) = *sections_gear().flexspline->diaphragm; }, "flexspline.shape",
     "",
     "is \"hat\", but the diaphragm, 80 to 154 mm in diameter, lies inside of the barrel, 158 mm; give shape = \"cup\" or correct the diameters"},
    {"HatWithoutDiaphragm", hat_gear, [](GearSet& g) { flexspline(g).diaphragm.reset(); },
     "flexspline.diaphragm", "",
     "must be given for a hat where crack_free = \"sections\" (bottom)"},
    {"HatWithABoss", hat_gear,
     [](GearSet& g) { flexspline(g).boss = *sections_gear().flexspline->boss; }, "flexspline.boss",
     "",
     "is not read for a hat, whose output is the flange around the diaphragm; remove the boss"},
    {"HatByAFactor", article, [](GearSet& g) { flexspline(g).shape = FlexsplineShape::hat; },
     "flexspline.crack_free", "",
     "must be \"sections\" for a hat, because no factor is known for it"},
    {"DiaphragmOfAHatApartFromTheBarrel", hat_gear,
     [](GearSet& g) {
       diaphragm(g).inner_diameter = 212 * mm;
       diaphragm(g).outer_diameter = 230 * mm;
     },
     "flexspline.diaphragm.inner_diameter",
     "within 25 % of barrel.outer_diameter, 158 mm, because the diaphragm joins the barrel", ""},
    {"ArcInsideOfTheBarrelOfAHat", hat_gear,
     [](GearSet& g) {
       flexspline(g).crack = {DiaphragmArcCrack{.half_length = 3 * mm, .radius = 70 * mm}};
     },
     "flexspline.crack[0].radius", "on the diaphragm", ""},
    {"GrooveInTheFlangeOfAHat", hat_gear,
     [](GearSet& g) {
       flexspline(g).crack = {
           DiaphragmGroove{.depth = 0.5 * mm, .width = 2 * mm, .radius = 110 * mm}};
     },
     "flexspline.crack[0].radius", "radius +- width/2 on the diaphragm", ""},
    {"RimApartFromTheTeeth", sections_gear,
     [](GearSet& g) { flexspline(g).rim->outer_diameter = 153.5 * mm; },
     "flexspline.rim.outer_diameter",
     "between 153.6 and 161.6 mm: the rim ends at the tooth roots", ""},
    {"RimOutsideOfTheTeeth", sections_gear,
     [](GearSet& g) { flexspline(g).rim->outer_diameter = 161.7 * mm; },
     "flexspline.rim.outer_diameter",
     "between 153.6 and 161.6 mm: the rim ends at the tooth roots", ""},
    {"WaveTooLow", article, [](GearSet& g) { g.drive.radial_displacement = 0.239 * mm; },
     "drive.radial_displacement",
     "between 0.3 and 2 times pitch_diameter/(2 ratio), 0.8 mm; otherwise the teeth cannot engage "
     "and disengage",
     ""},
    {"WaveTooHigh", article, [](GearSet& g) { g.drive.radial_displacement = 1.61 * mm; },
     "drive.radial_displacement",
     "between 0.3 and 2 times pitch_diameter/(2 ratio), 0.8 mm; otherwise the teeth cannot engage "
     "and disengage",
     ""},
    {"OuterRaceCrackWithoutRing", coupled_gear,
     [](GearSet& g) { wave_generator(g).bearing->outer_ring.reset(); },
     "wave_generator.bearing.outer_ring", "",
     "must be given for wave_generator.crack[2] (the ring that it is in)"},
    {"OuterRaceCrackWithoutBearing", coupled_gear,
     [](GearSet& g) {
       wave_generator(g).bearing.reset();
       wave_generator(g).radial_stiffness = 1e8;
     },
     "wave_generator.bearing.outer_ring", "",
     "must be given for wave_generator.crack[2] (the ring that it is in)"},
    {"OuterRaceCrackThroughTheRing", coupled_gear,
     [](GearSet& g) {
       std::get<OuterRaceCrack>(wave_generator(g).crack[2]).depth = 4 * mm;
     },
     "wave_generator.crack[2].depth", "depth < wave_generator.bearing.outer_ring.thickness", ""},
    {"RimAxialCrackWithoutRim", coupled_gear, [](GearSet& g) { flexspline(g).rim.reset(); },
     "flexspline.rim", "", "must be given for flexspline.crack[0] (the ring that it is in)"},
    {"RimAxialCrackThroughTheRim", coupled_gear,
     [](GearSet& g) { rim_axial_crack(g).depth = 3 * mm; }, "flexspline.crack[0].depth",
     "depth < flexspline.rim.wall_thickness", ""},

    {"RimAxialCracksInOnePlace", coupled_gear,
     [](GearSet& g) { crack_again(flexspline(g).crack, rim_axial_crack(g), 0.0); },
     "flexspline.crack[3].position", "",
     "0 deg is 0 mm along the ring from flexspline.crack[0] at 0 deg, and each crack softens 6 mm: combine them into one crack, or place them that far apart"},
    {"RimAxialCracksAWholeTurnApart", coupled_gear,
     [](GearSet& g) { crack_again(flexspline(g).crack, rim_axial_crack(g), 2 * pi); },
     "flexspline.crack[3].position", "",
     "360 deg is 0 mm along the ring from flexspline.crack[0] at 0 deg, and each crack softens 6 mm: combine them into one crack, or place them that far apart"},
    {"RimAxialCracksNear", coupled_gear,
     [](GearSet& g) { crack_again(flexspline(g).crack, rim_axial_crack(g), 5.9 / 78.5); },
     "flexspline.crack[3].position", "",
     "4.306 deg is 5.9 mm along the ring from flexspline.crack[0] at 0 deg, and each crack softens 6 mm: combine them into one crack, or place them that far apart"},
    {"OuterRaceCracksNear", coupled_gear,
     [](GearSet& g) { crack_again(wave_generator(g).crack, std::get<OuterRaceCrack>(wave_generator(g).crack[2]), -7.9 / 70); },
     "wave_generator.crack[3].position", "",
     "-6.466 deg is 7.9 mm along the ring from wave_generator.crack[2] at 0 deg, and each crack softens 8 mm: combine them into one crack, or place them that far apart"},
    {"SplineCracksNear", coupled_gear,
     [](GearSet& g) { crack_again(g.circular_spline->crack, std::get<CircularSplineRingCrack>(g.circular_spline->crack[0]), 49 / 94.5); },
     "circular_spline.crack[1].position", "",
     "29.71 deg is 49 mm along the ring from circular_spline.crack[0] at 0 deg, and each crack softens 50 mm: combine them into one crack, or place them that far apart"},

    // coupled drive: diaphragm
    {"GroovesOverlap", coupled_gear,
     [](GearSet& g) {
       flexspline(g).crack.emplace_back(groove(g));
       groove(g).radius = 60.9 * mm;
     },
     "flexspline.crack[3].radius", "", "overlaps flexspline.crack[2]: combine the two cracks into one, because the model adds cracks without interaction"},
    {"GrooveOverAnArc", coupled_gear, [](GearSet& g) { groove(g).radius = 45.4 * mm; },
     "flexspline.crack[2].radius", "", "overlaps flexspline.crack[1]: combine the two cracks into one, because the model adds cracks without interaction"},
    {"StationsNotRising", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[1].radius = 41 * mm; },
     "flexspline.diaphragm.profile[1].radius", "radius > that of the station before", ""},
    {"StationsAtOneRadius", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[1].radius = 42 * mm; },
     "flexspline.diaphragm.profile[1].radius", "radius > that of the station before", ""},
    {"StationInTheBoss", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[0].radius = 39.9 * mm; },
     "flexspline.diaphragm.profile[0].radius",
     "inner_diameter/2 <= radius < outer_diameter/2", ""},
    {"StationAtTheBarrel", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[1].radius = 77 * mm; },
     "flexspline.diaphragm.profile[1].radius",
     "inner_diameter/2 <= radius < outer_diameter/2", ""},
    {"DiaphragmCrackWithoutDiaphragm", coupled_gear,
     [](GearSet& g) {
       flexspline(g).shape = FlexsplineShape::cylinder;
       flexspline(g).diaphragm.reset();
     },
     "flexspline.diaphragm", "", "must be given for flexspline.crack[1]"},
    {"ArcInTheBoss", coupled_gear, [](GearSet& g) { arc_crack(g).radius = 39.9 * mm; },
     "flexspline.crack[1].radius", "on the diaphragm", ""},
    {"ArcBeyondTheDiaphragm", coupled_gear, [](GearSet& g) { arc_crack(g).radius = 77 * mm; },
     "flexspline.crack[1].radius", "on the diaphragm", ""},
    {"ArcAllRound", coupled_gear,
     [](GearSet& g) { arc_crack(g).half_length = pi * 45 * mm; },
     "flexspline.crack[1].half_length", "2 half_length < circumference at its radius", ""},
    {"GrooveReachesIntoTheBoss", coupled_gear, [](GearSet& g) { groove(g).radius = 40.4 * mm; },
     "flexspline.crack[2].radius", "radius +- width/2 on the diaphragm", ""},
    {"GrooveReachesIntoTheBarrel", coupled_gear, [](GearSet& g) { groove(g).radius = 76.6 * mm; },
     "flexspline.crack[2].radius", "radius +- width/2 on the diaphragm", ""},
    {"GrooveThroughTheDiaphragm", coupled_gear, [](GearSet& g) { groove(g).depth = 2.5 * mm; },
     "flexspline.crack[2].depth", "depth < thickness of the diaphragm", ""},
    {"GrooveThroughAThinPlaceInside", coupled_gear,  // 2 mm thick at a radius of 50 mm, thicker on either side
     [](GearSet& g) {
       groove(g).radius = 50 * mm;
       groove(g).width = 6 * mm;
       groove(g).depth = 2.05 * mm;
     },
     "flexspline.crack[2].depth", "depth < thickness of the diaphragm", ""},

    // coupled drive: circular spline, rating, ranges
    {"SplineOfUnknownMaterial", coupled_gear,
     [](GearSet& g) { g.circular_spline->material = "iron"; }, "circular_spline.material", "",
     "\"iron\" is not one of the materials given (steel)"},
    {"SplineWithoutRing", coupled_gear,
     [](GearSet& g) { g.circular_spline->outer_diameter = 164 * mm; },
     "circular_spline.inner_diameter", "inner_diameter < outer_diameter", ""},
    {"SplineInsideThePitchDiameter", coupled_gear,
     [](GearSet& g) { g.circular_spline->inner_diameter = 160 * mm; },
     "circular_spline.inner_diameter", "inner_diameter > drive.pitch_diameter", ""},
    {"SplineCrackThroughTheRing", coupled_gear,
     [](GearSet& g) {
       std::get<CircularSplineRingCrack>(g.circular_spline->crack[0]).depth = 25 * mm;
     },
     "circular_spline.crack[0].depth", "depth < (outer_diameter - inner_diameter)/2", ""},
    {"RatingsOutOfOrder", coupled_gear, [](GearSet& g) { g.rating->T2 = 212; }, "rating.T2",
     "T2 > T1", ""},
    {"ThirdTorqueOutOfOrder", coupled_gear, [](GearSet& g) { g.rating->T3 = 766; }, "rating.T3",
     "T3 > T2", ""},
    {"RangePathOfTwoLines", coupled_gear, [](GearSet& g) { g.range[0].path = "a\nb"; },
     "range[0].path", "", "must be one line, without control characters"},
    {"RangeSourceOfTwoLines", coupled_gear, [](GearSet& g) { g.range[1].source = "a\nb"; },
     "range[1].source", "", "must be one line, without control characters"},
    {"RangeReversed", coupled_gear, [](GearSet& g) { g.range[0].lower = "2.5 mm"; },
     "range[0].upper", "upper > lower", ""},
    {"RangeAboveItsNumber", coupled_gear, [](GearSet& g) { g.range[0].lower = "2.3 mm"; },
     "range[0].path", "",
     "flexspline.wall_thickness is 2.24 mm in the file, outside of this range from 2.3 mm to 2.5 "
     "mm; correct the range or the value"},
    {"RangeBelowItsNumber", coupled_gear, [](GearSet& g) { g.range[0].upper = "2.2 mm"; },
     "range[0].path", "",
     "flexspline.wall_thickness is 2.24 mm in the file, outside of this range from 2 mm to 2.2 mm; "
"correct the range or the value"},
    {"RangeBeyondTheRuleBelow", coupled_gear, [](GearSet& g) { g.range[0].lower = "0 mm"; },
     "range[0].lower", "> 0", ""},
    {"RangeBeyondTheRuleAbove", coupled_gear, [](GearSet& g) { g.range[1].upper = "0.6"; },
     "range[1].upper", ">= 0 and <= 0.5", ""},
    {"ScatterPathOfTwoLines", coupled_gear, [](GearSet& g) { g.scatter[0].path = "a\nb"; },
     "scatter[0].path", "", "must be one line, without control characters"},
    {"ScatterSourceOfTwoLines", coupled_gear, [](GearSet& g) { g.scatter[1].source = "a\nb"; },
     "scatter[1].source", "", "must be one line, without control characters"},
    {"ScatterOfNoNumber", coupled_gear,
     [](GearSet& g) { g.scatter[0].path = "flexspline.material"; }, "scatter[0].path", "",
     "\"flexspline.material\" is not a number of this drive"},
    {"ScatterOfAnAbsentNumber", coupled_gear,
     [](GearSet& g) { g.scatter[0].path = "drive.wave_number"; }, "scatter[0].path", "",
     "\"drive.wave_number\" is not a number of this drive"},
    {"ScatterOfScatter", coupled_gear,
     [](GearSet& g) { g.scatter[0].path = "scatter[1].relative_standard_deviation"; },
     "scatter[0].path", "",
     "must be a number of the drive, not of its ranges, scatter or correlations; name another "
     "number or remove this entry"},
    {"ScatterOfCorrelation", coupled_gear,
     [](GearSet& g) {
       g.correlation = {{.path = g.scatter[0].path, .with = g.scatter[1].path, .rank_correlation = 0.5, .source = ""}};
       g.scatter.push_back(g.scatter[0]);
       g.scatter.back().path = "correlation[0].rank_correlation";
     },
     "scatter[2].path", "", "must be a number of the drive, not of its ranges, scatter or correlations; name another "
     "number or remove this entry"},
    {"RangeOfScatter", coupled_gear,
     [](GearSet& g) { g.range[0].path = "scatter[0].relative_standard_deviation"; },
     "range[0].path", "", "must be a number of the drive, not of its ranges, scatter or correlations; name another "
     "number or remove this entry"},
    {"ScatterOfNothing", coupled_gear, [](GearSet& g) { g.scatter[0].path = "load.axial_force"; },
     "scatter[0].path", "", "load.axial_force is 0, so a relative scatter has no effect; give a value other than 0 or remove the scatter"},
    {"ScatterTwice", coupled_gear, [](GearSet& g) { g.scatter[1].path = g.scatter[0].path; },
     "scatter[1].path", "", "flexspline.wall_thickness already has a scatter, scatter[0]; remove one of them"},
    {"ScatterOfNoWidth", coupled_gear,
     [](GearSet& g) { g.scatter[0].relative_standard_deviation = 0; },
     "scatter[0].relative_standard_deviation", "> 0 and <= 1", ""},
    {"ScatterTooWide", coupled_gear,
     [](GearSet& g) { g.scatter[1].relative_standard_deviation = 1.01; },
     "scatter[1].relative_standard_deviation", "> 0 and <= 1", ""},
    {"ScatterWithoutItsWidth", coupled_gear,
     [](GearSet& g) { g.scatter[0].relative_standard_deviation.reset(); },
     "scatter[0].relative_standard_deviation", "", "must be given"},
    {"ScatterQuantilesWithoutTable", coupled_gear,
     [](GearSet& g) { g.scatter[0].quantile = {{0, 0.9}, {1, 1.1}}; }, "scatter[0].quantile", "",
     "is read with distribution = \"table\" only; remove it or change the distribution"},
    {"ScatterTableWithoutQuantiles", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile.clear(); }, "scatter[0].quantile", "",
     "must be given for distribution = \"table\""},
    {"ScatterTableWithWidth", coupled_gear,
     [](GearSet& g) { scatter_table(g).relative_standard_deviation = 0.1; },
     "scatter[0].relative_standard_deviation", "",
     "must not be given with distribution = \"table\", whose quantiles contain it"},
    {"ScatterTableOfOneEntry", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile.resize(1); }, "scatter[0].quantile", "",
     "needs at least two entries, of probability 0 and 1"},
    {"ScatterTableBeginsLate", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile[0].probability = 0.1; },
     "scatter[0].quantile[0].probability", "0 in the first entry", ""},
    {"ScatterTableEndsEarly", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile[2].probability = 0.9; },
     "scatter[0].quantile[2].probability", "1 in the last entry", ""},
    {"ScatterTableGoesBack", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile[1].probability = 0; },
     "scatter[0].quantile[1].probability", "larger than that of the entry before", ""},
    {"ScatterTableFalls", coupled_gear, [](GearSet& g) { scatter_table(g).quantile[1].ratio = 0.8; },
     "scatter[0].quantile[1].ratio", "not smaller than that of the entry before", ""},
    {"ScatterTableOfNoWidth", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile = {{0, 1}, {1, 1}}; },
     "scatter[0].quantile[1].ratio", "larger than that of the first entry", ""},
    {"ScatterTableOfNegativeValues", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile[0].ratio = -0.1; },
     "scatter[0].quantile[0].ratio", "> 0", ""},
    {"ScatterOfTheInspection", coupled_gear,
     [](GearSet& g) {
       inspection(g);
       g.scatter[0].path = "inspection.a50";
     },
     "scatter[0].path", "",
     "must be a number of the drive, not of its inspection; name another number or remove this "
     "entry"},
    {"InspectionWithoutA50", coupled_gear, [](GearSet& g) { inspection(g).a50.reset(); },
     "inspection.a50", "", "must be given for method = \"curve\""},
    {"InspectionWithoutA90", coupled_gear, [](GearSet& g) { inspection(g).a90.reset(); },
     "inspection.a90", "", "must be given for method = \"curve\""},
    {"InspectionThatFalls", coupled_gear, [](GearSet& g) { inspection(g).a90 = 1e-3; },
     "inspection.a90", "> a50: a larger crack is found more often", ""},
    {"InspectionByACurveWithNoise", coupled_gear, [](GearSet& g) { inspection(g).noise = 0.01; },
     "inspection.noise", "",
     "is read with the methods stiffness, one_sided_stiffness and resonance only; remove it or "
     "change the method"},
    {"InspectionThatAlwaysCalls", coupled_gear,
     [](GearSet& g) { inspection(g).false_calls = 1.0; }, "inspection.false_calls",
     ">= 0 and < 1", ""},
    {"InspectionWithoutNoise", coupled_gear, [](GearSet& g) { measurement(g).noise.reset(); },
     "inspection.noise", "", "must be given for method = \"stiffness\""},
    {"InspectionWithoutFalseCalls", coupled_gear,
     [](GearSet& g) { measurement(g).false_calls.reset(); }, "inspection.false_calls", "",
     "must be given for method = \"stiffness\", whose threshold follows from it"},
    {"InspectionThatNeverCalls", coupled_gear, [](GearSet& g) { measurement(g).false_calls = 0.0; },
     "inspection.false_calls",
     "> 0 and < 0.5 with a measurement, whose threshold follows from it", ""},
    {"InspectionThatCallsHalfOfTheDrives", coupled_gear,
     [](GearSet& g) { measurement(g).false_calls = 0.5; }, "inspection.false_calls",
     "> 0 and < 0.5 with a measurement, whose threshold follows from it", ""},
    {"InspectionByStiffnessWithA50", coupled_gear, [](GearSet& g) { measurement(g).a50 = 1e-3; },
     "inspection.a50", "",
     "is read with method = \"curve\" only; remove it or change the method"},
    {"InspectionByStiffnessWithA90", coupled_gear, [](GearSet& g) { measurement(g).a90 = 1e-3; },
     "inspection.a90", "",
     "is read with method = \"curve\" only; remove it or change the method"},
    {"InspectionByStiffnessWithAForm", coupled_gear,
     [](GearSet& g) { measurement(g).detection = DetectionForm::log_normal; },
     "inspection.detection", "",
     "is read with method = \"curve\" only; remove it or change the method"},
    {"InspectionByStiffnessAtAPlace", coupled_gear,
     [](GearSet& g) { measurement(g).place = {{"circular_spline.crack[0]"}}; },
     "inspection.place", "",
     "is read with method = \"curve\" only; remove it or change the method"},
    {"InspectionThatRepairsToNothing", coupled_gear,
     [](GearSet& g) { inspection(g).find = FindLeadsTo::repair; }, "inspection.repaired_to", "",
     "must be given for find = \"repair\""},
    {"InspectionThatRepairsNothing", coupled_gear,
     [](GearSet& g) { inspection(g).repaired_to = 1e-4; }, "inspection.repaired_to", "",
     "is read with find = \"repair\" only; remove it or change find"},
    {"InspectionOfNoCrack", article,
     [](GearSet& g) { inspection(g).place = {{"flexspline.crack[0]"}, {"flexspline.crack[7]"}}; },
     "inspection.place[1].crack", "",
     "\"flexspline.crack[7]\" is not a crack of this drive: wave_generator.crack[0], "
     "flexspline.crack[0], output_shaft.crack[0]"},
    {"InspectionOfTwoLines", article, [](GearSet& g) { inspection(g).place = {{"a\nb"}}; },
     "inspection.place[0].crack", "", "must be one line, without control characters"},
    {"InspectionTwice", article,
     [](GearSet& g) { inspection(g).place = {{"flexspline.crack[0]"}, {"flexspline.crack[0]"}}; },
     "inspection.place[1].crack", "",
     "flexspline.crack[0] is already inspection.place[0]; remove one of them"},
    {"CorrelationOfNoScatter", coupled_gear,
     [](GearSet& g) { correlation(g).path = "flexspline.length"; }, "correlation[0].path", "",
     "\"flexspline.length\" does not scatter; add a [[scatter]] with this path, or remove the "
     "correlation"},
    {"CorrelationWithNoScatter", coupled_gear,
     [](GearSet& g) { correlation(g).with = "flexspline.length"; }, "correlation[0].with", "",
     "\"flexspline.length\" does not scatter; add a [[scatter]] with this path, or remove the "
     "correlation"},
    {"CorrelationSourceOfTwoLines", coupled_gear,
     [](GearSet& g) { correlation(g).source = "a\nb"; }, "correlation[0].source", "",
     "must be one line, without control characters"},
    {"CorrelationPathOfTwoLines", coupled_gear,
     [](GearSet& g) { correlation(g).with = "a\nb"; }, "correlation[0].with", "",
     "must be one line, without control characters"},
    {"CorrelationWithItself", coupled_gear,
     [](GearSet& g) { correlation(g).with = correlation(g).path; }, "correlation[0].with", "",
     "must be another number than path"},
    {"CorrelationTwice", coupled_gear,
     [](GearSet& g) {
       correlation(g);
       g.correlation.push_back(g.correlation[0]);
       std::swap(g.correlation[1].path, g.correlation[1].with);
     },
     "correlation[1].with", "",
     "material.steel.youngs_modulus and flexspline.wall_thickness already have a correlation, "
     "correlation[0]; remove one of them"},
    {"CorrelationOfOne", coupled_gear, [](GearSet& g) { correlation(g).rank_correlation = 1; },
     "correlation[0].rank_correlation", "> -1 and < 1", ""},
    {"CorrelationsThatContradict", coupled_gear,
     [](GearSet& g) {
       g.scatter.push_back(g.scatter[0]);
       g.scatter[2].path = "flexspline.length";
       correlation(g).rank_correlation = 0.9;
       g.correlation.push_back(g.correlation[0]);
       g.correlation[1].with = "flexspline.length";
       g.correlation.push_back(g.correlation[1]);
       g.correlation[2].path = "material.steel.youngs_modulus";
       g.correlation[2].rank_correlation = -0.9;
     },
     "correlation", "",
     "the rank correlations contradict each other, because their matrix is not positive definite; "
     "bring them closer to 0"},

    // life of a material
    {"TwoLawsOfGrowth", article,
     [](GearSet& g) { g.material["steel"].growth = {Paris{1e-12, 3}, Paris{1e-12, 3}}; },
     "material.steel.growth[1]", "", "is a second law; give one law, and two_lines for a law of two branches"},
    {"TableWithoutCurves", article,
     [](GearSet& g) { g.material["steel"].growth = {Tabulated{}}; },
     "material.steel.growth[0].curve", "", "must be given: rates at one or more R"},
    {"StressRatiosReversed", article,
     [](GearSet& g) { growth_bounds(g).stress_ratio = {0.5, 0.1}; },
     "material.steel.growth_bounds.stress_ratio", "not below the first one of the pair", ""},
    {"TemperaturesOfGrowthReversed", article,
     [](GearSet& g) { growth_bounds(g).temperature = {310, 290}; },
     "material.steel.growth_bounds.temperature", "not below the first one of the pair", ""},
    {"RangesOfGrowthReversed", article,
     [](GearSet& g) {
       growth_bounds(g).from = 4e6;
       growth_bounds(g).to = 3e6;
     },
     "material.steel.growth_bounds.to", "to > from", ""},
    {"GrowthScatterOfNothing", article, [](GearSet& g) { growth_scatter(g) = {}; },
     "material.steel.growth_scatter", "",
     "must give at least one of level, exponent, wander and white"},
    {"GrowthScatterOfTwoLines", article, [](GearSet& g) { growth_scatter(g).source = "a\nb"; },
     "material.steel.growth_scatter.source", "", "must be one line, without control characters"},
    {"LevelCorrelationAlone", article,
     [](GearSet& g) {
       growth_scatter(g) = {.level_correlation = 0.5, .white = 0.1, .white_step = 1e-4};
     },
     "material.steel.growth_scatter.level_correlation", "",
     "is read only beside level or exponent"},
    {"ExponentCorrelationWithoutLevel", article,
     [](GearSet& g) { growth_scatter(g).level.reset(); },
     "material.steel.growth_scatter.exponent_correlation", "",
     "is read only beside level and exponent"},
    {"PivotWithoutExponent", article,
     [](GearSet& g) { growth_scatter(g) = {.level = 0.1, .pivot = 15e6}; },
     "material.steel.growth_scatter.pivot", "", "is read only beside exponent"},
    {"ExponentWithoutPivot", article, [](GearSet& g) { growth_scatter(g).pivot.reset(); },
     "material.steel.growth_scatter.pivot", "",
     "must be given beside exponent: the range of K at which the level holds"},
    {"WanderLengthAlone", article, [](GearSet& g) { growth_scatter(g).wander.reset(); },
     "material.steel.growth_scatter.wander_length", "", "is read only beside wander"},
    {"WanderWithoutLength", article, [](GearSet& g) { growth_scatter(g).wander_length.reset(); },
     "material.steel.growth_scatter.wander_length", "",
     "must be given beside wander: the correlation length in ln(size)"},
    {"WhiteStepAlone", article, [](GearSet& g) { growth_scatter(g).white.reset(); },
     "material.steel.growth_scatter.white_step", "", "is read only beside white"},
    {"WhiteWithoutStep", article, [](GearSet& g) { growth_scatter(g).white_step.reset(); },
     "material.steel.growth_scatter.white_step", "",
     "must be given beside white, whose deviation is that of a step of this length"},
    {"ScatterOfAScatter", coupled_gear,
     [](GearSet& g) {
       growth_scatter(g).source.clear();
       g.scatter[0].path = "material.steel.growth_scatter.level";
     },
     "scatter[0].path", "",
     "material.steel.growth_scatter.level is a scatter itself; name a number of the drive"},
    {"CorrelationWithAPartOfAPath", coupled_gear,
     [](GearSet& g) {
       growth_scatter(g).source.clear();
       correlation(g).with = "material.steel.growth_scatter.wander";
     },
     "correlation[0].with", "",
     "\"material.steel.growth_scatter.wander\" does not scatter; add a [[scatter]] with this path, "
     "or remove the correlation"},
    {"TemperaturesOfFatigueReversed", article,
     [](GearSet& g) { fatigue(g).temperature = {310, 290}; }, "material.steel.fatigue.temperature",
     "not below the first one of the pair", ""},
    {"SlopeWithoutKnee", article, [](GearSet& g) { fatigue(g).slope = 5; },
     "material.steel.fatigue.cycles", "", "must be given beside slope: the line goes through the knee"},

    // output shaft
    {"BoreOfTheDiameter", article, [](GearSet& g) { shaft(g).inner_diameter = 70 * mm; },
     "output_shaft.inner_diameter", "inner_diameter < outer_diameter", ""},
    {"BoreBeyondTheDiameter", article, [](GearSet& g) { shaft(g).inner_diameter = 71 * mm; },
     "output_shaft.inner_diameter", "inner_diameter < outer_diameter", ""},
    {"AnnularCrackThroughTheWall", article, [](GearSet& g) { annular_crack(g).depth = 12.5 * mm; },
     "output_shaft.crack[0].depth", "depth < (outer_diameter - inner_diameter)/2, the wall", ""},
    {"DepthIsThatOfTheWallButForRounding", article,
     [](GearSet& g) { annular_crack(g).depth = std::nextafter((70 * mm - 45 * mm) / 2, 0.0); },
     "output_shaft.crack[0].depth", "depth < (outer_diameter - inner_diameter)/2, the wall", ""},
    {"AnnularCrackOfTheRadius", article,
     [](GearSet& g) {
       shaft(g).inner_diameter = 0;
       annular_crack(g).depth = 35 * mm;
     },
     "output_shaft.crack[0].depth", "depth < outer_diameter/2", ""},
    {"SecondCrackIsCheckedToo", article,
     [](GearSet& g) { shaft(g).crack.emplace_back(AnnularCrack{.depth = 13 * mm}); },
     "output_shaft.crack[1].depth", "depth < (outer_diameter - inner_diameter)/2, the wall", ""},
    {"TadaOfAHollowShaft", article,
     [](GearSet& g) { annular_crack(g).solution = AnnularSolution::tada; },
     "output_shaft.crack[0].solution", "",
     "\"tada\" is for solid shafts; a hollow one has a table"},
    {"SurfaceCrackThroughTheWallOfTheShaft", article,
     [](GearSet& g) {
       shaft(g).crack = {ShaftSurfaceCrack{.depth = 12.5 * mm, .half_length = 20 * mm}};
     },
     "output_shaft.crack[0].depth", "depth < (outer_diameter - inner_diameter)/2, the wall", ""},
    {"SurfaceCrackOfTheRadius", article,
     [](GearSet& g) {
       shaft(g).inner_diameter = 0;
       shaft(g).crack = {ShaftSurfaceCrack{.depth = 35 * mm, .half_length = 40 * mm}};
     },
     "output_shaft.crack[0].depth", "depth < outer_diameter/2", ""},
    {"SurfaceCrackShorterThanDeep", article,
     [](GearSet& g) {
       shaft(g).crack = {ShaftSurfaceCrack{.depth = 2 * mm, .half_length = 1.9 * mm}};
     },
     "output_shaft.crack[0].half_length", "half_length >= depth", ""},
    {"SurfaceCrackRoundTheShaft", article,
     [](GearSet& g) {
       shaft(g).crack = {ShaftSurfaceCrack{.depth = 2 * mm, .half_length = 110 * mm}};
     },
     "output_shaft.crack[0].half_length", "2 half_length < circumference of the shaft", ""},
};

class CheckRule : public testing::TestWithParam<Broken> {};

TEST_P(CheckRule, InputBrokenOnceIsRefused) {
  const Broken& broken = GetParam();
  GearSet gear = broken.base();
  broken.change(gear);
  const InputError error = refusal(gear);
  EXPECT_EQ(error.field(), broken.field);
  EXPECT_EQ(error.rule(), broken.rule);
  const std::string message = error.what();
  if (broken.rule.empty())
    EXPECT_EQ(message, broken.field + ": " + broken.problem);
  else
    EXPECT_TRUE(message.ends_with(" violates: " + broken.rule)) << message;
}

INSTANTIATE_TEST_SUITE_P(Rules, CheckRule, testing::ValuesIn(kBroken),
                         [](const auto& test) { return test.param.name; });

/// The article's drive between a motor and a load.
GearSet driven_gear() {
  GearSet gear = article_gear();
  gear.drivetrain = Drivetrain{.motor_inertia = 1e-4, .load_inertia = 1.0};
  return gear;
}

// Cracks of a wall whose places are given must not touch or cross, also round the axis.
TEST(Check, InputCracksOfTheWallThatTouch) {
  constexpr double degree = pi / 180;
  const auto pair = [](double position, double distance, double angle) {
    GearSet gear = sections_gear();
    WallThroughCrack one;
    one.half_length = 10 * mm;
    one.angle = pi / 4;
    one.distance = 50 * mm;
    one.position = 0;
    WallThroughCrack two = one;
    two.position = position;
    two.distance = distance;
    two.angle = angle;
    gear.flexspline->crack = {one, two};
    return gear;
  };
  const auto refused = [](const GearSet& gear) {
    try {
      check(gear);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const std::string same = refused(pair(0, 50 * mm, pi / 4));
  EXPECT_NE(same.find("flexspline.crack[1].position"), std::string::npos) << same;
  EXPECT_NE(same.find("touches or crosses flexspline.crack[0]"), std::string::npos) << same;
  EXPECT_NE(refused(pair(0, 50 * mm, -pi / 4)), "");      // a cross
  EXPECT_NE(refused(pair(2 * pi, 50 * mm, pi / 2)), "");  // the same place after a turn
  // On one line: the barrel has a mean radius of 78 mm, and the angle runs toward -theta.
  EXPECT_NE(refused(pair(-2 * degree, (50 + 78 * 2 * degree) * mm, pi / 4)), "");
  EXPECT_EQ(refused(pair(-2 * degree, 52 * mm, pi / 4)), "");    // beside each other, 0.5 mm
  EXPECT_EQ(refused(pair(20 * degree, 50 * mm, pi / 4)), "");    // 27 mm round the axis
  EXPECT_EQ(refused(pair(0, 80 * mm, pi / 4)), "");              // one above the other
  EXPECT_NE(refused(pair(359 * degree, 50 * mm, -pi / 4)), "");  // across the mark
  GearSet row = pair(60 * degree, 50 * mm, -pi / 4);
  EXPECT_EQ(refused(row), "");
  std::get<WallThroughCrack>(row.flexspline->crack[0]).count = 6;  // one at 60 degrees
  EXPECT_NE(refused(row), "");
  std::get<WallThroughCrack>(row.flexspline->crack[0]).count = 4;
  EXPECT_EQ(refused(row), "");
  GearSet somewhere = pair(0, 50 * mm, pi / 4);
  std::get<WallThroughCrack>(somewhere.flexspline->crack[1]).position.reset();
  EXPECT_EQ(refused(somewhere), "");  // far apart
  GearSet repeated = somewhere;
  std::get<WallThroughCrack>(repeated.flexspline->crack[0]).position.reset();
  EXPECT_EQ(refused(repeated),
            "flexspline.crack[1]: repeats flexspline.crack[0]; give both a position, or leave one "
            "out");
  std::get<WallThroughCrack>(repeated.flexspline->crack[0]).half_length = 9 * mm;
  EXPECT_EQ(refused(repeated), "");
  GearSet other_section = pair(0, 15 * mm, pi / 4);
  std::get<WallThroughCrack>(other_section.flexspline->crack[1]).section = WallSection::rim;
  EXPECT_EQ(refused(other_section), "");
}

TEST(Check, InputACam) {
  const auto refused = [](const std::function<void(GearSet&)>& change) {
    GearSet gear = article_gear();
    gear.wave_generator->cam =
        Cam{.profile = CamProfile::ellipse, .arc_angle = {}, .disc_offset = {}, .point = {}};
    change(gear);
    return std::string(refusal(gear).what());
  };
  EXPECT_EQ(refused([](GearSet&) {}), ": accepted");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam_flattening = 1; }),
            "wave_generator.cam_flattening: is a second shape of the cam; give only one of "
            "cam_flattening and cam");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->arc_angle = 0.5; }),
            "wave_generator.cam.arc_angle: must be left out; it belongs to profile = \"two_arcs\"");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->disc_offset = 1 * mm; }),
            "wave_generator.cam.disc_offset: must be left out; it belongs to profile = "
            "\"two_discs\"");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->point.resize(5); }),
            "wave_generator.cam.point: must be left out; it belongs to profile = \"points\"");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->profile = CamProfile::two_arcs; }),
            "wave_generator.cam.arc_angle: must be given for profile = \"two_arcs\"");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->profile = CamProfile::two_discs; }),
            "wave_generator.cam.disc_offset: must be given for profile = \"two_discs\"");
  EXPECT_EQ(refused([](GearSet& g) { g.wave_generator->cam->profile = CamProfile::points; }),
            "wave_generator.cam.point: must be given for profile = \"points\"");
  const auto discs = [](GearSet& g) {
    g.wave_generator->cam->profile = CamProfile::two_discs;
    g.wave_generator->cam->disc_offset = 3.5 * g.drive.radial_displacement;
  };
  EXPECT_EQ(refused(discs), ": accepted");
  EXPECT_EQ(refused([&](GearSet& g) {
              discs(g);
              g.wave_generator->cam_perimeter_excess = 0.01 * mm;
            }),
            "wave_generator.cam_perimeter_excess: must be left out, because the heights of the cam "
            "are given by its profile");
  const std::string near = refused([&](GearSet& g) {
    discs(g);
    g.wave_generator->cam->disc_offset = 0.9 * g.drive.radial_displacement;
  });
  EXPECT_NE(near.find("wave_generator.cam.disc_offset = "), std::string::npos) << near;
}

TEST(Check, InputADrivetrain) {
  EXPECT_STREQ(refusal(driven_gear()).what(), ": accepted");
  const auto refused = [](const Mutation& change) {
    GearSet gear = driven_gear();
    change(gear);
    return std::string(refusal(gear).what());
  };
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->motor_inertia = 0; }),
            "drivetrain.motor_inertia = 0 kg*m^2 violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->load_inertia = -1; }),
            "drivetrain.load_inertia = -1 kg*m^2 violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->wave_generator_inertia = 0; }),
            "drivetrain.wave_generator_inertia = 0 kg*m^2 violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->gear_damping = -1; }),
            "drivetrain.gear_damping = -1 N*m*s/rad violates: >= 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->motor_damping = -1; }),
            "drivetrain.motor_damping = -1 N*m*s/rad violates: >= 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->load_damping = -1; }),
            "drivetrain.load_damping = -1 N*m*s/rad violates: >= 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->coupling_stiffness = 2000; }),
            "drivetrain.coupling_stiffness: needs drivetrain.wave_generator_inertia, the inertia "
            "behind the coupling; give it, or leave out the coupling");
  EXPECT_EQ(refused([](GearSet& g) {
              g.duty.emplace().fixed = FixedMember::flexspline;
              g.duty->block = {{.duration = 1, .output_speed = 1.0, .torque = 1}};
            }),
            "drivetrain.fixed: contradicts duty.fixed; write \"flexspline\" here, or change "
            "duty.fixed");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->wave_generator_inertia = 4e-5;
              g.drivetrain->coupling_stiffness = 2000;
              g.drivetrain->fixed = FixedMember::flexspline;
              g.duty.emplace().fixed = FixedMember::flexspline;
              g.duty->block = {{.duration = 1, .output_speed = 1.0, .torque = 1}};
            }),
            ": accepted");
}

TEST(Check, InputAMotion) {
  const auto refused = [](const std::function<void(GearSet&)>& change) {
    GearSet gear = driven_gear();
    gear.drivetrain->friction = LuGre{.bristle_stiffness = 100, .coulomb = 0.03, .breakaway = 0.05};
    gear.drivetrain->hysteresis = BoucWen{.stiffness = 1e5, .limit = 3};
    gear.kinematic_error = {{.order = 2, .amplitude = 1e-4}};
    gear.manoeuvre = {{.duration = 1, .input_speed = 10.0}, {.duration = 1, .input_speed = 0.0}};
    change(gear);
    return std::string(refusal(gear).what());
  };
  EXPECT_EQ(refused([](GearSet&) {}), ": accepted");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->friction->breakaway = 0.02; }),
            "drivetrain.friction.breakaway = 0.02 N*m violates: at least "
            "drivetrain.friction.coulomb");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->friction->coulomb = 0; }),
            "drivetrain.friction.coulomb = 0 N*m violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->hysteresis->asymmetry = 0.6; }),
            "drivetrain.hysteresis.asymmetry = 0.6 violates: <= 0.5");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->friction->load_coulomb = -0.1; }),
            "drivetrain.friction.load_coulomb = -0.1 violates: >= 0");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->friction->load_breakaway = -0.1; }),
            "drivetrain.friction.load_breakaway = -0.1 violates: >= 0");
  const LuGre of_load{.bristle_stiffness = 1e5, .coulomb = 3, .breakaway = 5};
  EXPECT_EQ(refused([&](GearSet& g) { g.drivetrain->load_friction = of_load; }), ": accepted");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->load_friction = of_load;
              g.drivetrain->load_friction->breakaway = 2;
            }),
            "drivetrain.load_friction.breakaway = 2 N*m violates: at least "
            "drivetrain.load_friction.coulomb");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->load_friction = of_load;
              g.drivetrain->load_friction->load_coulomb = 0.1;
            }),
            "drivetrain.load_friction.load_coulomb: is a share of the torque through the drive, "
            "whose friction is drivetrain.friction; give it there, or leave it out");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->load_friction = of_load;
              g.drivetrain->load_friction->load_breakaway = 0.1;
            }),
            "drivetrain.load_friction.load_breakaway: is a share of the torque through the drive, "
            "whose friction is drivetrain.friction; give it there, or leave it out");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->load_friction = of_load;
              g.drivetrain->load_friction->warming = 300;
            }),
            "drivetrain.load_friction.warming = 300 K violates: at most 200 K, up or down");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->servo = Servo{.speed_gain = 0.01, .stall_torque = 2.0};
            }),
            "drivetrain.servo.stall_torque: needs no_load_speed, the other end of the motor's "
            "line; give both, or leave out both");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->servo = Servo{.speed_gain = 0.01, .no_load_speed = 2.0};
            }),
            "drivetrain.servo.no_load_speed: needs stall_torque, the other end of the motor's "
            "line; give both, or leave out both");
  // The weak motor cannot speed up the drive in time, whatever its speed; one that turns back may
  // have more than its stall torque.
  const auto weak = [](double before, double after) {
    return [before, after](GearSet& g) {
      g.drivetrain->servo =
          Servo{.speed_gain = 0.01, .stall_torque = 1e-6, .no_load_speed = 1000.0};
      g.manoeuvre = {{.duration = 1e6, .input_speed = before},
                     {.duration = 1, .input_speed = after}};
    };
  };
  EXPECT_NE(refused(weak(0.0, 10.0)).find("more than drivetrain.servo.stall_torque"),
            std::string::npos);
  EXPECT_EQ(refused(weak(-5.0, 10.0)), ": accepted");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->hysteresis.reset();
              g.drivetrain->slip_element = {{1e4, 1.0}, {1e4, 2.0}};
            }),
            ": accepted");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->hysteresis.reset();
              g.drivetrain->slip_element = {{1e4, 1.0}, {1e4, 0.0}};
            }),
            "drivetrain.slip_element[1].limit = 0 N*m violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) {
              g.drivetrain->slip_element = {{1e4, 1.0}};
            }),
            "drivetrain.slip_element: is read in place of drivetrain.hysteresis; give one of the "
            "two");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[1].output_speed = 1.0; }),
            "manoeuvre[1].output_speed: must be given in all pieces or in none; write output_speed "
            "= \"0 rpm\" for an output that stands");
  EXPECT_EQ(refused([](GearSet& g) {
              for (Manoeuvre& piece : g.manoeuvre) piece.output_speed = 0.1;
            }),
            ": accepted");
  EXPECT_EQ(refused([](GearSet& g) {
              for (Manoeuvre& piece : g.manoeuvre) piece.output_speed = 0.1;
              g.manoeuvre[1].output_torque = 1.0;
            }),
            "manoeuvre[1].output_speed: needs whatever torque the output has, so output_torque "
            "cannot be given beside it; give one of the two");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain->hysteresis->exponent = 0.5; }),
            "drivetrain.hysteresis.exponent = 0.5 violates: >= 1");
  // A kinematic error of a degree is no error.
  EXPECT_EQ(refused([](GearSet& g) { g.kinematic_error[0].amplitude = 0.01745; }),
            "kinematic_error[0].amplitude = 0.01745 rad violates: >= 0 and < 0.5 deg");
  EXPECT_EQ(refused([](GearSet& g) { g.kinematic_error[0].order = 0; }),
            "kinematic_error[0].order = 0 violates: > 0 and <= 1000");
  const Servo servo{.speed_gain = 0.05, .torque_limit = 0.05};
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->servo = servo;
              g.drivetrain->servo->speed_gain = 0;
            }),
            "drivetrain.servo.speed_gain = 0 N*m*s/rad violates: > 0");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->servo = servo;
              g.drivetrain->servo->sample_time = 0.1;
            }),
            "drivetrain.servo.sample_time = 0.1 s violates: below 2*(inertia of the "
            "input)/speed_gain");
  // J_m + J_L/101^2 = 1.98e-4 kg*m^2 and 10 rad/s in 10 ms are 0.198 N*m.
  const auto fast = [&](GearSet& g) {
    g.drivetrain->servo = servo;
    g.manoeuvre[0].duration = 0.01;
  };
  EXPECT_EQ(refused(fast),
            "manoeuvre[0].input_speed: needs at least 0.198 N*m to speed the drive up or down "
            "within the piece, more than drivetrain.servo.torque_limit; give the piece more time");
  // Friction helps to brake.
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->servo = servo;
              g.manoeuvre[1].duration = 0.01;
            }),
            ": accepted");
  EXPECT_NE(refused([&](GearSet& g) {
              g.drivetrain->servo = servo;
              g.drivetrain->friction.reset();
              g.manoeuvre[1].duration = 0.01;
            }),
            ": accepted");
  EXPECT_EQ(refused([](GearSet& g) { g.kinematic_error[0].order = 1001; }),
            "kinematic_error[0].order = 1001 violates: > 0 and <= 1000");
  EXPECT_EQ(refused([&](GearSet& g) {
              fast(g);
              g.manoeuvre[0].output_torque = 1.0;  // it may help the motor
            }),
            ": accepted");
  EXPECT_EQ(refused([&](GearSet& g) {
              g.drivetrain->servo = servo;
              for (Manoeuvre& piece : g.manoeuvre) {
                piece.input_speed.reset();
                piece.input_torque = 0.1;
              }
            }),
            "manoeuvre[0].input_torque: contradicts drivetrain.servo, which follows input_speed; "
            "give input_speed, or leave out the servo");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[1].duration = 0; }),
            "manoeuvre[1].duration = 0 s violates: > 0");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[1].duration = 1e-20; }),
            "manoeuvre[1].duration = 1e-20 s violates: long enough to move the time of the pieces "
            "before");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[0].input_torque = 1.0; }),
            "manoeuvre[0]: must have either input_speed or input_torque");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[1].input_speed.reset(); }),
            "manoeuvre[1]: must have either input_speed or input_torque");
  EXPECT_EQ(refused([](GearSet& g) { g.manoeuvre[1] = {.duration = 1, .input_torque = 1.0}; }),
            "manoeuvre[1]: must give what the pieces before give: input_speed in all, or "
            "input_torque in all");
  EXPECT_EQ(refused([](GearSet& g) { g.drivetrain.reset(); }),
            "manoeuvre[0]: needs [drivetrain], the inertias that the manoeuvres move; give it");
}

TEST(Check, InputFlangeComplianceNeedsSections) {
  GearSet gear = test::article_gear();
  gear.flexspline->flange_compliance = 1e-7;
  EXPECT_STREQ(refusal(gear).what(),
               "flexspline.flange_compliance: is read only where crack_free = \"sections\"");
}

TEST(Check, InputRangeOfWhatIsNoNumber) {
  GearSet gear = coupled_gear();
  gear.range[0].path = "flexspline.wall_thicknes";
  EXPECT_STREQ(refusal(gear).what(),
               "range[0].path: \"flexspline.wall_thicknes\" is not a number of this drive; did you "
               "mean flexspline.wall_thickness?");
  // A range is read in the unit of its number.
  gear = coupled_gear();
  gear.range[0].lower = "2 N";
  EXPECT_EQ(refusal(gear).field(), "range[0].lower");
  gear = coupled_gear();
  gear.range[0].upper = "wide";
  EXPECT_EQ(refusal(gear).field(), "range[0].upper");
}

// --- Boundaries that are still inside ------------------------------------------------------------

struct Accepted {
  std::string name;
  GearSet (*base)();
  Mutation change;

  friend std::ostream& operator<<(std::ostream& out, const Accepted& a) { return out << a.name; }
};

double below(double x) { return std::nextafter(x, 0.0); }
/// Factor for rules that are not decided by rounding.
double just_below(double x) { return x * (1 - 1e-11); }

const std::vector<Accepted> kAccepted = {
    {"NoName", article, [](GearSet& g) { g.name.clear(); }},
    {"NameInGreek", article, [](GearSet& g) { g.name = "\u03BA\u03CD\u03BC\u03B1"; }},
    {"OneWave", article, [](GearSet& g) { g.drive.wave_number = 1; }},
    {"EightWaves", article, [](GearSet& g) { g.drive.wave_number = 8; }},
    {"TwoWavesBendARing", sections_gear, [](GearSet& g) { g.drive.wave_number = 2; }},
    {"NegativeTorque", article, [](GearSet& g) { g.load.torque = -100; }},
    {"TinyTorque", article, [](GearSet& g) { g.load.torque = 1e-300; }},
    {"Compression", article, [](GearSet& g) { g.load.axial_force = -1e6; }},
    {"DisplacementBelowTheRadius", article,
     [](GearSet& g) {
       g.drive.ratio = 1.5;
       g.drive.radial_displacement = below(g.drive.pitch_diameter / 2);
     }},
    {"MaterialThatYieldsAsItBreaks", article,
     [](GearSet& g) {
       g.material["steel"].yield_strength = 900e6;
       g.material["steel"].ultimate_strength = 900e6;
     }},
    {"MaterialOfTensileStrengthAlone", article,
     [](GearSet& g) { g.material["steel"].ultimate_strength = 1e6; }},
    {"AuxeticMaterial", article, [](GearSet& g) { g.material["steel"].poissons_ratio = -0.999; }},
    {"MaterialOfEAndG", article, [](GearSet& g) { g.material["steel"].poissons_ratio.reset(); }},
    {"MaterialOfEAndNu", article, [](GearSet& g) { g.material["steel"].shear_modulus.reset(); }},
    {"ContradictoryMaterial", article,
     [](GearSet& g) { g.material["steel"].shear_modulus = 200 * GPa; }},
    {"WaveGeneratorAlone", article,
     [](GearSet& g) {
       g.flexspline.reset();
       g.output_shaft.reset();
     }},
    {"FlexsplineAlone", article,
     [](GearSet& g) {
       g.wave_generator.reset();
       g.output_shaft.reset();
     }},
    {"ShaftAlone", article,
     [](GearSet& g) {
       g.wave_generator.reset();
       g.flexspline.reset();
     }},
    {"NoCracks", article,
     [](GearSet& g) {
       wave_generator(g).crack.clear();
       flexspline(g).crack.clear();
       shaft(g).crack.clear();
       wave_generator(g).inner_ring_thickness.reset();
       wave_generator(g).contact_semi_axes.reset();
     }},
    {"CamAloneDeflects", article,
     [](GearSet& g) {
       wave_generator(g).radial_stiffness.reset();
       wave_generator(g).displacements = LobeDisplacements{.cam = 1e-9};
     }},
    {"ShaftAloneDeflects", article,
     [](GearSet& g) {
       wave_generator(g).radial_stiffness.reset();
       wave_generator(g).displacements = LobeDisplacements{.shaft = 1e-9};
     }},
    {"CircularContact", article,
     [](GearSet& g) {
       wave_generator(g).contact_semi_axes = {2 * mm, 2 * mm};
     }},
    {"OneLoadedBall", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->loaded_balls = 1; }},
    {"BallThatFillsTheGap", sections_gear,
     [](GearSet& g) {
       wave_generator(g).bearing->ball_diameter = (135.4 * mm - 110 * mm) / 2 * (1 + 1e-14);
     }},
    {"BallWithClearance", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->ball_diameter = 12.6 * mm; }},
    {"SectionsAsLongAsTheFlexspline", sections_gear,
     [](GearSet& g) { flexspline(g).length = 130 * mm * (1 - 1e-14); }},
    {"RingOfOneLobeThatDoesNotBend", sections_gear,
     [](GearSet& g) {
       g.drive.wave_number = 1;
       wave_generator(g).bearing->outer_ring.reset();
       wave_generator(g).crack.erase(wave_generator(g).crack.begin());
     }},
    {"RingJustThinnerThanItsRadius", sections_gear,
     [](GearSet& g) { wave_generator(g).inner_ring_thickness = below(60 * mm); }},
    {"OuterRingJustThinnerThanItsRadius", sections_gear,
     [](GearSet& g) { wave_generator(g).bearing->outer_ring->thickness = below(70 * mm); }},
    {"SemicircularRaceCrack", article, [](GearSet& g) { race_crack(g).aspect_ratio = 1; }},
    {"ContactFactorOfOne", article, [](GearSet& g) { race_crack(g).contact_factor = 1; }},
    {"ContactFactorComputed", article, [](GearSet& g) { race_crack(g).contact_factor.reset(); }},
    {"ContactOfTheBearing", sections_gear,
     [](GearSet& g) { race_crack(g).stress_driver = StressDriver::orthogonal_shear; }},
    {"ContactEdge", article,
     [](GearSet& g) {
       race_crack(g).stress_driver = StressDriver::contact_edge;
       race_crack(g).contact_factor.reset();
     }},
    {"GivenStressOfZero", sections_gear, [](GearSet& g) { edge_crack(g).stress = 0; }},
    {"RaceCrackJustInTheRing", article,
     [](GearSet& g) { race_crack(g).depth = just_below(10 * mm); }},
    {"WallJustBelowTheRadius", article,
     [](GearSet& g) { flexspline(g).wall_thickness = below(80 * mm); }},
    {"RimJustBelowTheRadius", sections_gear,
     [](GearSet& g) { flexspline(g).rim->wall_thickness = below(80 * mm); }},
    {"NarrowestDiaphragm", sections_gear,
     [](GearSet& g) { flexspline(g).diaphragm->inner_diameter = below(154 * mm); }},
    {"BarrelJustJoinedToTheRim", sections_gear,
     [](GearSet& g) {
       flexspline(g).barrel->outer_diameter = 120.01 * mm;
       diaphragm(g).outer_diameter = 119 * mm;
     }},
    // Shapes of drives that are built, as multiples of their barrel or rim.
    {"HatOfSize14WithAFilletOf2Millimetres", hat_gear,
     [](GearSet& g) {
       diaphragm(g).inner_diameter = 158 * 38.7 / 34.6 * mm;
       diaphragm(g).outer_diameter = 250 * mm;
     }},
    {"CupOfSize14WhoseDiaphragmEndsAtItsFillet", sections_gear,
     [](GearSet& g) { diaphragm(g).outer_diameter = 158 * 30.2 / 34.6 * mm; }},
    {"BarrelOfSize25NeckedTo56Millimetres", sections_gear,
     [](GearSet& g) {
       flexspline(g).barrel->outer_diameter = 160 * 56 / 62.8 * mm;
       diaphragm(g).outer_diameter = 140 * mm;
     }},
    {"RimJustAtTheTeeth", sections_gear,
     [](GearSet& g) { flexspline(g).rim->outer_diameter = 153.7 * mm; }},
    {"RimOfShiftedTeeth", sections_gear,
     [](GearSet& g) { flexspline(g).rim->outer_diameter = 161.5 * mm; }},
    {"RingAsWideAsTheGroove", sections_gear,
     [](GearSet& g) {
       wave_generator(g).inner_ring_width = wave_generator(g).bearing->ball_diameter / 2;
     }},
    {"LowestWave", article, [](GearSet& g) { g.drive.radial_displacement = 0.241 * mm; }},
    {"HighestWave", article, [](GearSet& g) { g.drive.radial_displacement = 1.59 * mm; }},
    {"CupWithoutRimAndBoss", sections_gear,
     [](GearSet& g) {
       flexspline(g).rim.reset();
       flexspline(g).boss.reset();
       rim_crack(g).section = WallSection::barrel;
     }},
    {"CylinderWithoutBottom", sections_gear,
     [](GearSet& g) {
       flexspline(g).shape = FlexsplineShape::cylinder;
       flexspline(g).diaphragm.reset();
     }},
    {"Hat", hat_gear, [](GearSet&) {}},
    {"HatWithCracks", hat_gear,
     [](GearSet& g) {
       flexspline(g).crack = {
           DiaphragmArcCrack{.half_length = 3 * mm, .radius = {}},
           DiaphragmGroove{.depth = 0.5 * mm, .width = 2 * mm, .radius = 100 * mm}};
     }},
    {"CylinderWithBottom", sections_gear,
     [](GearSet& g) { flexspline(g).shape = FlexsplineShape::cylinder; }},
    {"ShapeFactorGiven", article, [](GearSet& g) { flexspline(g).shape_factor = 0.5; }},
    {"AxialCrackJustInTheTube", article,
     [](GearSet& g) {
       through_crack(g).angle = 0;
       through_crack(g).half_length = below(80 * mm);
     }},
    {"CircumferentialCrack", article, [](GearSet& g) { through_crack(g).angle = pi / 2; }},
    {"CircumferentialCrackJustOpen", article,
     [](GearSet& g) {
       through_crack(g).angle = pi / 2;
       through_crack(g).half_length = pi / 2 * (160 - 2.24) * mm * (1 - 1e-12);
     }},
    {"AlmostMinusNinetyDegrees", article,
     [](GearSet& g) { through_crack(g).angle = std::nextafter(-pi / 2, 0.0); }},
    {"SemicircularWallCrack", sections_gear,
     [](GearSet& g) { rim_crack(g).half_length = rim_crack(g).depth; }},
    {"WallCrackJustInTheRim", sections_gear,
     [](GearSet& g) {
       rim_crack(g).half_length = 5 * mm;
       rim_crack(g).depth = just_below(3 * mm);
     }},
    {"SolidShaft", article, [](GearSet& g) { shaft(g).inner_diameter = 0; }},
    {"SolidShaftByTada", article,
     [](GearSet& g) {
       shaft(g).inner_diameter = 0;
       annular_crack(g).solution = AnnularSolution::tada;
     }},
    {"ThinnestShaft", article,
     [](GearSet& g) {
       shaft(g).inner_diameter = below(70 * mm);
       g.output_shaft->crack.clear();
     }},
    {"AnnularCrackJustInTheWall", article,
     [](GearSet& g) { annular_crack(g).depth = just_below(12.5 * mm); }},
    {"AnnularCrackJustInTheRadius", article,
     [](GearSet& g) {
       shaft(g).inner_diameter = 0;
       annular_crack(g).depth = just_below(35 * mm);
     }},
    {"SurfaceCrackJustInTheShaft", article,
     [](GearSet& g) {
       shaft(g).crack = {ShaftSurfaceCrack{.depth = just_below(12.5 * mm),
                                           .half_length = just_below(std::numbers::pi * 35 * mm)},
                         ShaftSurfaceCrack{.depth = 2 * mm, .half_length = 2 * mm}};
     }},
    {"ThreeBalls", coupled_gear, [](GearSet& g) { wave_generator(g).bearing->ball_count = 3; }},
    {"TwoHundredBalls", coupled_gear,
     [](GearSet& g) {
       wave_generator(g).bearing->ball_count = 200;
       wave_generator(g).bearing->ball_diameter = 1 * mm;
     }},
    {"BallsSideBySide", coupled_gear,
     [](GearSet& g) { wave_generator(g).bearing->ball_count = 30; }},
    {"AllBallsLoaded", coupled_gear,
     [](GearSet& g) { wave_generator(g).bearing->loaded_balls = 23; }},
    {"RaceCrackOverTheWidth", sections_gear, [](GearSet& g) { race_crack(g).aspect_ratio = 0.1; }},
    {"SectionsWithoutLengthAndThickness", sections_gear,
     [](GearSet& g) {
       flexspline(g).length.reset();
       flexspline(g).wall_thickness.reset();
     }},
    {"GroovesSideBySide", coupled_gear,
     [](GearSet& g) {
       flexspline(g).crack.emplace_back(groove(g));
       groove(g).radius = 61 * mm;
     }},
    {"ArcsOnOneCircle", coupled_gear,
     [](GearSet& g) { flexspline(g).crack.emplace_back(arc_crack(g)); }},
    {"RimAxialCracksJustApart", coupled_gear,
     [](GearSet& g) { crack_again(flexspline(g).crack, rim_axial_crack(g), 6 / 78.5); }},
    {"OuterRaceCracksJustApart", coupled_gear,
     [](GearSet& g) {
       crack_again(wave_generator(g).crack, std::get<OuterRaceCrack>(wave_generator(g).crack[2]),
                   2 * pi - 8.0 / 70);
     }},
    {"SplineCracksJustApart", coupled_gear,
     [](GearSet& g) {
       crack_again(g.circular_spline->crack,
                   std::get<CircularSplineRingCrack>(g.circular_spline->crack[0]), -50 / 94.5);
     }},
    {"RimAxialCrackJustInTheRim", coupled_gear,
     [](GearSet& g) { rim_axial_crack(g).depth = just_below(3 * mm); }},
    {"OuterRaceCrackJustInTheRing", coupled_gear,
     [](GearSet& g) {
       std::get<OuterRaceCrack>(wave_generator(g).crack[2]).depth = just_below(4 * mm);
     }},
    {"SplineCrackJustInTheRing", coupled_gear,
     [](GearSet& g) {
       std::get<CircularSplineRingCrack>(g.circular_spline->crack[0]).depth = just_below(25 * mm);
     }},
    {"StationAtTheBoss", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[0].radius = 40 * mm; }},
    {"StationJustInsideTheBarrel", coupled_gear,
     [](GearSet& g) { diaphragm(g).profile[1].radius = just_below(77 * mm); }},
    {"ArcAtTheBoss", coupled_gear, [](GearSet& g) { arc_crack(g).radius.reset(); }},
    {"ArcJustInsideTheBarrel", coupled_gear,
     [](GearSet& g) { arc_crack(g).radius = below(77 * mm); }},
    {"ArcAlmostAllRound", coupled_gear,
     [](GearSet& g) { arc_crack(g).half_length = just_below(pi * 45 * mm); }},
    {"GrooveAtTheBoss", coupled_gear, [](GearSet& g) { groove(g).radius = 40.5 * mm; }},
    {"GrooveAtTheBarrel", coupled_gear, [](GearSet& g) { groove(g).radius = 76.5 * mm; }},
    {"SplineAlmostRigid", coupled_gear, [](GearSet& g) { g.circular_spline->support = 0; }},
    {"ThirdTorqueByDefault", coupled_gear, [](GearSet& g) { g.rating->T3.reset(); }},
    {"RangeFromItsNumber", coupled_gear, [](GearSet& g) { g.range[0].lower = "2.24 mm"; }},
    {"RangeInOtherUnits", coupled_gear, [](GearSet& g) { g.range[0].lower = "2000 um"; }},
    {"ScatterAsWideAsItsNumber", coupled_gear,
     [](GearSet& g) { g.scatter[0].relative_standard_deviation = 1; }},
    {"ScatterTable", coupled_gear, [](GearSet& g) { scatter_table(g); }},
    {"ScatterTableWithAStep", coupled_gear,
     [](GearSet& g) { scatter_table(g).quantile[1].ratio = 0.9; }},
    {"CorrelationNegative", coupled_gear,
     [](GearSet& g) { correlation(g).rank_correlation = -0.99; }},
    {"ScatterOfAnAngle", coupled_gear, [](GearSet& g) { g.scatter[0].path = "mesh.flank_angle"; }},
    {"Inspection", article,
     [](GearSet& g) {
       inspection(g).place = {{"flexspline.crack[0]"}};
       g.inspection->find = FindLeadsTo::repair;
       g.inspection->repaired_to = 3e-3;
       g.inspection->false_calls = 0.0;
       g.inspection->cost = InspectionCost{};
     }},
    {"InspectionByStiffness", article, [](GearSet& g) { measurement(g); }},
    {"NoOverrides", article, [](GearSet& g) { g.article = ArticleOverrides{}; }},
    {"MaterialOfAnyName", article,
     [](GearSet& g) {
       g.material["a.b[0]"] = g.material["steel"];
       flexspline(g).material = "a.b[0]";
     }},
};

class CheckBoundary : public testing::TestWithParam<Accepted> {};

TEST_P(CheckBoundary, InputStillInsideIsAccepted) {
  GearSet gear = GetParam().base();
  GetParam().change(gear);
  EXPECT_STREQ(refusal(gear).what(), ": accepted");
}

INSTANTIATE_TEST_SUITE_P(Boundaries, CheckBoundary, testing::ValuesIn(kAccepted),
                         [](const auto& test) { return test.param.name; });

// --- Ranges of single fields ---------------------------------------------------------------------

/// Some number inside a range.
double inside(const Range& range) {
  if (std::isfinite(range.lower) && std::isfinite(range.upper))
    return (range.lower + range.upper) / 2;
  if (std::isfinite(range.upper)) return range.upper - 1;
  return std::isfinite(range.lower) ? range.lower + 1 : 1.0;
}

/// Fills a value with everything that its type can hold: each optional, one element in each map,
/// and one element of every kind in each list.
template <class T>
void fill(T& value, const Field& field) {
  if constexpr (std::is_same_v<T, double>) {
    value = inside(field.range);
  } else if constexpr (is_optional<T>) {
    fill(value.emplace(), field);
  } else if constexpr (is_pair_of_numbers<T>) {
    value = {inside(field.range), inside(field.range)};
  } else if constexpr (is_string_map<T>) {
    fill(value["steel"], field);
  } else if constexpr (is_vector<T>) {
    if constexpr (is_variant<typename T::value_type>) {
      for_each_alternative<typename T::value_type>(
          [&]<class Alternative>() { value.emplace_back(Alternative{}); });
      for (auto& element : value)
        std::visit([&](auto& alternative) { fill(alternative, field); }, element);
    } else {
      fill(value.emplace_back(), field);
    }
  } else if constexpr (Described<T>) {
    T::describe([&](const Field& inner, auto member) { fill(value.*member, inner); });
  }
}

/// A drive that gives every possible number.  It breaks rules between fields, which are checked
/// only after the ranges.
GearSet full_gear() {
  GearSet gear;
  fill(gear, Field{});
  return gear;
}

/// Paths of all numbers that the types can hold, found without values.
template <class T>
void collect(const FieldPath& path, std::set<std::string>& paths) {
  if constexpr (std::is_same_v<T, double>) {
    paths.insert(path.text());
  } else if constexpr (is_optional<T>) {
    collect<typename T::value_type>(path, paths);
  } else if constexpr (is_pair_of_numbers<T>) {
    paths.insert(path[0].text());
    paths.insert(path[1].text());
  } else if constexpr (is_string_map<T>) {
    collect<typename T::mapped_type>(path / "steel", paths);
  } else if constexpr (is_vector<T>) {
    if constexpr (is_variant<typename T::value_type>) {
      std::size_t i = 0;
      for_each_alternative<typename T::value_type>(
          [&]<class Alternative>() { collect<Alternative>(path[i++], paths); });
    } else {
      collect<typename T::value_type>(path[0], paths);
    }
  } else if constexpr (Described<T>) {
    // The owner of a member may be a base of T.
    T::describe([&]<class Value, class Owner>(const Field& field, Value Owner::*) {
      collect<Value>(path / field.name, paths);
    });
  }
}

/// Sets each number of the full drive in turn; `f(path, field, gear, number)` changes it.
template <class F>
void for_each_number_alone(const F& f) {
  const GearSet full = full_gear();
  for_each_number(full, [&](const FieldPath& path, const Field& field, const double&) {
    GearSet gear = full;
    for_each_number(gear, [&](const FieldPath& at, const Field&, double& number) {
      if (at.text() == path.text()) f(path.text(), field, gear, number);
    });
  });
}

TEST(CheckRange, BehaviourTheFullDriveHasEveryNumberThatADriveCanHave) {
  std::set<std::string> possible;
  collect<GearSet>(FieldPath(), possible);
  std::set<std::string> present;
  const GearSet full = full_gear();
  for_each_number(full, [&](const FieldPath& path, const Field&, const double&) {
    present.insert(path.text());
  });
  EXPECT_EQ(present, possible);
  EXPECT_GT(present.size(), 60U);
  // All numbers are in their ranges, so the fault is not a range.
  EXPECT_EQ(refusal(full).rule(), "");
  EXPECT_EQ(refusal(full).field(), "material.steel.growth[1]");
}

TEST(CheckRange, InputEveryNumberRefusesWhatIsNoNumber) {
  for_each_number_alone([](const std::string& path, const Field&, GearSet& gear, double& x) {
    for (const double value : {kNaN, -kNaN, kInfinity, -kInfinity}) {
      x = value;
      const InputError error = refusal(gear);
      EXPECT_EQ(error.field(), path) << value;
      EXPECT_EQ(error.rule(), "a finite number") << path << " " << value;
    }
  });
}

TEST(CheckRange, InputEveryBoundIsHeldOnBothSides) {
  int bounds = 0;
  for_each_number_alone([&](const std::string& path, const Field& field, GearSet& gear, double& x) {
    const auto expect = [&](double value, bool accepted) {
      x = value;
      const InputError error = refusal(gear);
      if (accepted) {
        EXPECT_NE(error.field(), path) << value << ": " << error.what();
      } else {
        EXPECT_EQ(error.field(), path) << value;
        EXPECT_EQ(error.rule(), rule_text(field.range, field.unit)) << path;
      }
    };
    const Range& range = field.range;
    if (std::isfinite(range.lower)) {
      ++bounds;
      expect(std::nextafter(range.lower, -kInfinity), false);
      expect(range.lower, !range.lower_open);
    }
    if (std::isfinite(range.upper)) {
      ++bounds;
      expect(std::nextafter(range.upper, kInfinity), false);
      expect(range.upper, !range.upper_open);
    }
  });
  EXPECT_GT(bounds, 60);
}

/// The bounds, written down a second time, so a range that was widened by mistake is detected.
TEST(CheckRange, ReferenceRanges) {
  const std::set<std::string> any = {"load.torque",
                                     "drivetrain.gravity_torque",
                                     "drivetrain.gravity_angle",
                                     "drivetrain.friction.warming",
                                     "drivetrain.load_friction.warming",
                                     "kinematic_error[0].phase",
                                     "manoeuvre[0].input_speed",
                                     "manoeuvre[0].input_torque",
                                     "manoeuvre[0].output_torque",
                                     "manoeuvre[0].output_speed",
                                     "load.axial_force",
                                     "wave_generator.crack[0].stress",
                                     "wave_generator.crack[1].stress",
                                     "wave_generator.crack[0].position",
                                     "wave_generator.crack[1].position",
                                     "wave_generator.crack[2].position",
                                     "flexspline.crack[0].position",
                                     "flexspline.crack[1].position",
                                     "flexspline.crack[2].position",
                                     "flexspline.crack[4].position",
                                     "flexspline.crack[0].pitch",
                                     "flexspline.crack[1].pitch",
                                     "flexspline.crack[2].pitch",
                                     "flexspline.crack[4].pitch",
                                     "flexspline.crack[0].axial_pitch",
                                     "flexspline.crack[1].axial_pitch",
                                     "flexspline.crack[0].positions[0]",
                                     "flexspline.crack[1].positions[0]",
                                     "flexspline.crack[2].positions[0]",
                                     "flexspline.crack[4].positions[0]",
                                     "output_shaft.crack[0].pitch",
                                     "mesh.lobe_gap",
                                     "mesh.crack[0].position",
                                     "circular_spline.crack[0].position",
                                     "material.steel.growth[5].slope_plus",
                                     "material.steel.growth[5].slope_minus",
                                     "wave_generator.cam_perimeter_excess",
                                     "wave_generator.cam.point[0].height",
                                     "duty.block[0].output_speed",
                                     "duty.block[0].input_speed",
                                     "duty.block[0].torque",
                                     "duty.block[0].axial_force",
                                     "duty.peak[0].output_speed",
                                     "duty.peak[0].input_speed",
                                     "duty.peak[0].torque"};
  const std::set<std::string> may_be_zero = {"output_shaft.inner_diameter",
                                             "tolerance.thickness_deviation",
                                             "wave_generator.displacements.bearing",
                                             "wave_generator.displacements.cam",
                                             "wave_generator.displacements.shaft",
                                             "wave_generator.bearing.clearance",
                                             "wave_generator.cam_flattening",
                                             "flexspline.flange_compliance",
                                             "flexspline.joint_compliance",
                                             "mesh.gap_factor",
                                             "mesh.coning",
                                             "rating.friction_torque",
                                             "material.steel.growth[4].threshold",
                                             "material.steel.growth[5].threshold_exponent",
                                             "material.steel.growth[5].instability_exponent",
                                             "material.steel.growth[5].intrinsic_size",
                                             "material.steel.growth[5].over_thickness.A",
                                             "material.steel.growth[5].over_thickness.B",
                                             "material.steel.growth_bounds.short_crack_size",
                                             "duty.block[0].radial_force",
                                             "duty.block[0].bending_moment",
                                             "drivetrain.motor_damping",
                                             "drivetrain.gear_damping",
                                             "drivetrain.load_damping",
                                             "drivetrain.friction.bristle_damping",
                                             "drivetrain.friction.viscous",
                                             "drivetrain.friction.thinning",
                                             "drivetrain.friction.load_coulomb",
                                             "drivetrain.friction.load_breakaway",
                                             "drivetrain.load_friction.bristle_damping",
                                             "drivetrain.load_friction.viscous",
                                             "drivetrain.load_friction.thinning",
                                             "drivetrain.load_friction.load_coulomb",
                                             "drivetrain.load_friction.load_breakaway",
                                             "duty.resonance.frequency_ratio",
                                             "inspection.cost.inspection",
                                             "inspection.cost.call",
                                             "inspection.cost.failure"};
  const std::map<std::string, std::string> others = {
      {"material.steel.poissons_ratio", "> -1 and < 0.5"},
      {"material.steel.ply[0].angle", ">= -90 deg and <= 90 deg"},
      {"material.steel.fatigue.slope", ">= 1"},
      {"material.steel.fatigue.size_factor", "> 0 and <= 1"},
      {"material.steel.growth[2].gamma", ">= 0 and <= 1"},
      {"material.steel.growth[5].closure.constraint", ">= 1 and <= 3"},
      {"material.steel.growth[5].closure.stress_level", "> 0 and < 1"},
      {"material.steel.growth[6].curve[0].stress_ratio", "< 1"},
      {"material.steel.growth_bounds.stress_ratio[0]", "<= 1"},
      {"material.steel.growth_bounds.stress_ratio[1]", "<= 1"},
      {"material.steel.growth_scatter.level", ">= 0 and <= 3"},
      {"material.steel.growth_scatter.level_correlation", ">= 0 and <= 1"},
      {"material.steel.growth_scatter.exponent", ">= 0 and <= 3"},
      {"material.steel.growth_scatter.exponent_correlation", ">= -1 and <= 1"},
      {"material.steel.growth_scatter.wander", ">= 0 and <= 3"},
      {"material.steel.growth_scatter.wander_length", ">= 0.001 and <= 100"},
      {"material.steel.growth_scatter.white", ">= 0 and <= 3"},
      {"material.steel.growth_scatter.white_step", ">= 1e-06 m"},
      {"output_bearing.load_factor", ">= 1"},
      {"wave_generator.bearing.inner_conformity", "> 0.5 and < 1"},
      {"wave_generator.bearing.outer_conformity", "> 0.5 and < 1"},
      {"wave_generator.bearing.loaded_balls", ">= 1"},
      {"wave_generator.bearing.rolling_friction", ">= 0 and <= 0.1"},
      {"wave_generator.bearing.outer_ring.friction_coefficient", ">= 0 and <= 0.5"},
      {"wave_generator.bearing.outer_ring.groove_factor", "> 0 and <= 1"},
      {"mesh.flank_angle", "> 0 and < 60 deg"},
      {"mesh.friction_coefficient", ">= 0 and <= 0.5"},
      {"mesh.crack[0].stiffness_loss", "> 0 and <= 1"},
      {"circular_spline.support", ">= 0 and <= 1"},
      {"drivetrain.hysteresis.exponent", ">= 1"},
      {"drivetrain.hysteresis.asymmetry", "<= 0.5"},
      {"kinematic_error[0].amplitude", ">= 0 and < 0.5 deg"},
      {"kinematic_error[0].order", "> 0 and <= 1000"},
      {"rating.lost_motion_share", "> 0 and < 1"},
      {"tolerance.run_out", ">= 0 and <= 2e-05 m"},
      {"tolerance.ball_variation", ">= 0 and <= 5e-06 m"},
      {"scatter[0].relative_standard_deviation", "> 0 and <= 1"},
      {"scatter[0].quantile[0].probability", ">= 0 and <= 1"},
      {"correlation[0].rank_correlation", "> -1 and < 1"},
      {"inspection.noise", "> 0 and < 1"},
      {"inspection.false_calls", ">= 0 and < 1"},
      {"wave_generator.crack[0].aspect_ratio", "> 0 and <= 1"},
      {"wave_generator.crack[0].contact_factor", "> 0 and <= 1"},
      {"wave_generator.crack[1].contact_factor", "> 0 and <= 1"},
      {"wave_generator.cam.arc_angle", ">= 5 deg and <= 85 deg"},
      {"wave_generator.cam.point[0].angle", ">= 0 and <= 90 deg"},
      {"flexspline.crack[0].angle", "> -90 deg and <= 90 deg"},
      {"flexspline.crack[1].angle", "> -90 deg and <= 90 deg"}};
  const GearSet full = full_gear();
  for_each_number(full, [&](const FieldPath& path, const Field& field, const double&) {
    const std::string& at = path.text();
    const auto other = others.find(at);
    const std::string expected = any.contains(at)           ? "a finite number"
                                 : may_be_zero.contains(at) ? ">= 0"
                                 : other != others.end()    ? other->second
                                                            : "> 0";
    EXPECT_EQ(rule_text(field.range, field.unit), expected) << at;
  });
}

TEST(CheckRange, InputRangesAreCheckedBeforeTheRulesBetweenFields) {
  GearSet gear = article_gear();
  shaft(gear).inner_diameter = -1;
  shaft(gear).outer_diameter = -2;
  EXPECT_EQ(refusal(gear).field(), "output_shaft.outer_diameter");
  EXPECT_STREQ(refusal(gear).what(), "output_shaft.outer_diameter = -2 m violates: > 0");
}

}  // namespace
}  // namespace strainwave

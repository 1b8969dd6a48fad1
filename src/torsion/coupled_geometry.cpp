// SPDX-License-Identifier: Apache-2.0
#include "coupled_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// Limits of the coupled drive.  Beyond a limit the input is a mistake, or a law is not valid.
constexpr double kMostRootDistance = 8;  // pitch less root diameter over m [-]: no tooth is taller
// share of the bore [-]: a bearing with a larger deviation does not fit
constexpr double kFitInBore = 0.005;
constexpr double kMostFlattening = 6;       // c_cam [-], (TC-5): four times that of an ellipse
constexpr double kMostConing = 5;           // chi [-], (TC-8): five times an uncorrected tooth
constexpr double kLeastDisplacement = 0.3;  // w_0/m [-]: the gap law (TC-7) is for 1,
constexpr double kMostDisplacement = 2;     //   with a note outside 0.6 to 1.3
constexpr int kLeastTeeth = 20;             // [-]: a tooth is small against the wave
constexpr double kWhole = 1e-9;             // rounding of a number of teeth [-]

/// The first missing input of the coupled drive that `check` does not require: its field and
/// meaning.
struct Missing {
  std::string field;
  std::string what;
};

std::optional<Missing> missing(const GearSet& gear) {
  if (!gear.wave_generator) return Missing{"wave_generator", "the cam and its bearing"};
  if (!gear.wave_generator->bearing) return Missing{"wave_generator.bearing", "balls and raceways"};
  if (!gear.wave_generator->bearing->ball_count)
    return Missing{"wave_generator.bearing.ball_count", "balls all round"};
  if (!gear.wave_generator->bearing->outer_ring)
    return Missing{"wave_generator.bearing.outer_ring", "it bends with the rim"};
  if (!gear.flexspline) return Missing{"flexspline", "the cup"};
  if (gear.flexspline->crack_free != CrackFree::sections)
    return Missing{"flexspline.crack_free", "\"sections\", with rim, barrel and diaphragm"};
  if (!gear.flexspline->rim) return Missing{"flexspline.rim", "the toothed ring"};
  if (!gear.flexspline->diaphragm) return Missing{"flexspline.diaphragm", "the bottom of the cup"};
  if (!gear.mesh) return Missing{"mesh", "tooth engagement"};
  return std::nullopt;
}

/// Bending stiffness of a section, E b t^3/12 times a factor [N*m^2].
double third_power_bending(double E, double width, double thickness, double factor) {
  return E * width * thickness * thickness * thickness / 12 * factor;
}

/// Rotation c_M of a hinge per unit of moment, from an edge crack in bending [rad/(N*m)].
double hinge_compliance(double depth, double thickness, double width,
                        const ElasticConstants& steel) {
  const sif::EdgeCrack crack{.depth = depth,
                             .thickness = thickness,
                             .width = width,
                             .unit_stress = 6 / (width * thickness * thickness),
                             .loading = sif::StripLoading::bending};
  return added_compliance(crack, {.opening = steel.plane_strain_modulus(), .shear = steel.G})
      .matrix(0, 0);  // (TC-22)
}

/// Radial compliance of a race crack under the force of one ball [m/N], with the notes of its
/// stress.
double race_crack_compliance(const GearSet& gear, const std::string& path, double ball_force,
                             std::vector<Note>& notes) {
  // Use the crack of the series model under one lobe, with the lobe force set to that of this ball.
  GearSet single = gear;
  WaveGenerator& wg = *single.wave_generator;
  wg.conversion = Conversion::reciprocity;
  if (wg.bearing) wg.bearing->loaded_balls = 1;
  const double f = lobe_force_per_torque(gear.drive, wg);
  single.load.torque = ball_force / f;
  const MemberCompliance member = wave_generator_compliance(single);
  for (const Note& note : member.notes)
    if (note.path == path) notes.push_back(note);
  for (const CrackReport& report : member.cracks)
    if (report.path == path) return report.positive.at_output.value / (f * f);  // (TC-23)
  return 0.0;
}

/// Checks the rules of the coupled drive in addition to those of `check`.
void check_coupled(const GearSet& gear, const CoupledOptions& options) {
  check(gear);
  if (const auto gap = missing(gear))
    throw InputError(gap->field,
                     fmt::format("must be given for the torsion curve ({})", gap->what));
  require(options.harmonics >= 8 && options.harmonics <= 128, "harmonics", options.harmonics, "1",
          ">= 8 and <= 128");
  const Transmission& drive = gear.drive;
  const TubeSection& rim = *gear.flexspline->rim;
  const WaveGenerator& wg = *gear.wave_generator;
  const Bearing& bearing = *wg.bearing;
  require(drive.wave_number == 2, "drive.wave_number", drive.wave_number, "1",
          "2 for the torsion curve");
  const double teeth = drive.wave_number * drive.ratio;
  require(std::abs(teeth - std::round(teeth)) < kWhole && teeth >= kLeastTeeth, "drive.ratio",
          drive.ratio, "1", "a whole number of teeth, wave_number times ratio, of 20 or more");
  const double module = drive.pitch_diameter / teeth;
  require(rim.outer_diameter < drive.pitch_diameter, "flexspline.rim.outer_diameter",
          rim.outer_diameter, "m", "outer_diameter, of the tooth roots, < drive.pitch_diameter");
  require(drive.pitch_diameter - rim.outer_diameter < kMostRootDistance * module,
          "flexspline.rim.outer_diameter", rim.outer_diameter, "m",
          "outer_diameter, of the tooth roots, within 4 modules of drive.pitch_diameter/2");
  const double bore = rim.outer_diameter / 2 - rim.wall_thickness;
  const double ring_outside = bearing.outer_ring->mean_radius + bearing.outer_ring->thickness / 2;
  if (std::abs(ring_outside - bore) > kFitInBore * bore)
    throw InputError(
        "wave_generator.bearing.outer_ring.mean_radius",
        fmt::format("makes an outer radius of {:.5g} mm in a flexspline bore of {:.5g} mm: the "
                    "bearing does not assemble; rule: within 0.5 %",
                    1e3 * ring_outside, 1e3 * bore));
  if (bearing.outer_raceway_diameter / 2 > ring_outside)
    throw InputError("wave_generator.bearing.outer_raceway_diameter",
                     bearing.outer_raceway_diameter, "m",
                     "inside the outer ring, whose outer diameter is 2 mean_radius + thickness");
  const double circle = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  require(*bearing.ball_count * bearing.ball_diameter < pi * circle,
          "wave_generator.bearing.ball_count", *bearing.ball_count, "1",
          "ball_count times ball_diameter < circumference of the balls' circle");
  require(bearing.clearance < drive.radial_displacement, "wave_generator.bearing.clearance",
          bearing.clearance, "m", "clearance < drive.radial_displacement");
  require(wg.cam_flattening <= kMostFlattening, "wave_generator.cam_flattening", wg.cam_flattening,
          "1", "<= 6 for the torsion curve");
  require(gear.mesh->coning <= kMostConing, "mesh.coning", gear.mesh->coning, "1",
          "<= 5 for the torsion curve");
  const double kappa = drive.radial_displacement / module;
  require(kappa > kLeastDisplacement && kappa < kMostDisplacement, "drive.radial_displacement",
          drive.radial_displacement, "m", "0.3 to 2 modules for the torsion curve");
}

/// Sets the flank angle, turned by friction, and the gaps and stiffness of the tooth pairs.
void add_mesh(CoupledGeometry& g, const ToothMesh& mesh, FlankFriction friction) {
  g.flank_angle = mesh.flank_angle;
  const double turn = std::atan(mesh.friction_coefficient);
  g.force_angle = g.flank_angle;
  if (friction == FlankFriction::loading) g.force_angle -= turn;    // (TC-16)
  if (friction == FlankFriction::unloading) g.force_angle += turn;  // (TC-16)
  require(g.force_angle > 0, "mesh.friction_coefficient", mesh.friction_coefficient, "1",
          "less than the tangent of mesh.flank_angle: else the flanks lock themselves");
  g.gap_factor = mesh.gap_factor;
  g.lobe_gap = mesh.lobe_gap;
  g.flank = {.pair_stiffness = mesh.pair_stiffness.value_or(
                 tooth_pair_stiffness(g.rim_steel.E, g.module, g.rim_thickness)),
             .face_width = g.rim_width,
             .slope = mesh.coning * std::sin(g.flank_angle) * g.radial_displacement /
                      (g.length - g.rim_width / 2)};  // (TC-8)
}

/// A ring that a crack softens.
struct CrackedRing {
  RingHinge::Ring ring{};
  double thickness = 0.0;  // [m]
  double width = 0.0;      // [m]
  double bending = 0.0;    // EI; for the circular spline, EI over its support [N*m^2]
  double support = 1.0;    // share of the ring's compliance that remains in its housing [-]
  ElasticConstants steel;
};

/// Turns cracks into their effects in the contact problem.  Each kind of effect has an overload of
/// `add`.
class ContactCracksOf {
 public:
  ContactCracksOf(const GearSet& gear, const CoupledGeometry& geometry, const BallForce& ball_force,
                  std::vector<Note>& notes)
      : gear_(gear), geometry_(geometry), ball_force_(ball_force), notes_(notes) {}

  void add(const std::string&, const ToothCrack& crack) {
    result.teeth.push_back({crack.position, crack.stiffness_loss});
  }

  template <CrackedPart part, bool from_inside>
  void add(const std::string&, const RingCrack<part, from_inside>& crack) {
    if (part == CrackedPart::circular_spline && !(geometry_.support > 0)) {
      note_rigid_spline();
      return;
    }
    const CrackedRing ring = ring_of(part);
    const double c_M =
        ring.support * hinge_compliance(crack.depth, ring.thickness, ring.width, ring.steel);
    const double length = crack.softened_length(ring.thickness);
    const double left = ring.bending / (1 + c_M * ring.bending / length);
    result.hinges.push_back({.ring = ring.ring,
                             .position = crack.position,
                             .length = length,
                             .softening = (ring.bending - left) * length});  // (TC-22)
  }

  /// Adds a crack of the inner race, which the balls load.
  template <class Crack>
  requires requires(const Crack& crack) { crack.stress_driver; }
  void add(const std::string& path, const Crack& crack) {
    if (crack.stress_driver != StressDriver::orthogonal_shear &&
        crack.stress_driver != StressDriver::contact_edge) {
      notes_.push_back({"crack.not_of_a_ball",
                        "its stress does not follow from the force of the ball over it: it is "
                        "left out of the torsion curve",
                        path, "TC-23", Severity::care,
                        "Choose a stress_driver of the ball, orthogonal_shear or contact_edge."});
    } else if (const double force = ball_force_(crack.position); force > 0) {
      result.balls.push_back({crack.position, race_crack_compliance(gear_, path, force, notes_)});
      notes_.push_back({"crack.under_a_ball",
                        fmt::format("taken with the nearest ball exactly over it, the worst "
                                    "place, linear at {:.3g} N; the balls roll over it, so its "
                                    "effect comes and goes at ball-pass frequency",
                                    force),
                        path, "TC-23", Severity::care});
    } else {
      notes_.push_back({"crack.unloaded_ball", "no ball that carries is near it: no effect", path,
                        "TC-23", Severity::information});
    }
  }

  ContactCracks result;

 private:
  [[nodiscard]] CrackedRing ring_of(CrackedPart part) const {
    const CoupledGeometry& g = geometry_;
    if (part == CrackedPart::rim)
      return {.ring = RingHinge::Ring::rim,
              .thickness = g.rim_thickness,
              .width = g.rim_width,
              .bending = g.rim_bending,
              .steel = g.rim_steel};
    if (part == CrackedPart::outer_ring)
      return {.ring = RingHinge::Ring::outer,
              .thickness = g.outer_thickness,
              .width = g.outer_width,
              .bending = g.outer_bending,
              .steel = g.ball_steel};
    const CircularSpline& spline = *gear_.circular_spline;
    return {.ring = RingHinge::Ring::spline,
            .thickness = (spline.outer_diameter - spline.inner_diameter) / 2,
            .width = spline.width,
            .bending = g.spline_bending / g.support,
            .support = g.support,
            .steel =
                elastic_constants(material_of(gear_, spline.material, "circular_spline.material"))};
  }

  void note_rigid_spline() {
    const Note note{.code = "crack.rigid_ring",
                    .text =
                        "the circular spline is held rigidly (support = 0): a crack in it has "
                        "no effect",
                    .path = "circular_spline.support",
                    .equation = "TC-10",
                    .severity = Severity::care,
                    .next_step = "Give a support above 0."};
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(note);
  }

  const GearSet& gear_;
  const CoupledGeometry& geometry_;
  const BallForce& ball_force_;
  std::vector<Note>& notes_;
};

}  // namespace

std::string missing_for_torsion_curve(const GearSet& gear) {
  const auto gap = missing(gear);
  return gap ? fmt::format("{}: must be given for the torsion curve ({})", gap->field, gap->what)
             : std::string();
}

CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options) {
  check_coupled(gear, options);
  const Transmission& drive = gear.drive;
  const Flexspline& fs = *gear.flexspline;
  const WaveGenerator& wg = *gear.wave_generator;
  const Bearing& bearing = *wg.bearing;
  const BearingRing& outer = *bearing.outer_ring;
  const double teeth = drive.wave_number * drive.ratio;
  CoupledGeometry g;
  g.rim_steel = elastic_constants(material_of(gear, fs.material, "flexspline.material"));
  g.ball_steel = elastic_constants(material_of(gear, wg.material, "wave_generator.material"));
  g.pitch_radius = drive.pitch_diameter / 2;
  g.radial_displacement = drive.radial_displacement;
  g.teeth = static_cast<int>(std::lround(teeth));
  g.module = drive.pitch_diameter / teeth;
  g.rim_thickness = fs.rim->wall_thickness;
  g.rim_width = fs.rim->length;
  g.ring_radius = (fs.rim->outer_diameter - fs.rim->wall_thickness) / 2;
  g.rim_bending =
      third_power_bending(g.rim_steel.E, g.rim_width, g.rim_thickness, gear.mesh->rim_stiffening);
  g.outer_thickness = outer.thickness;
  g.outer_width = outer.width;
  g.outer_bending =
      third_power_bending(g.ball_steel.E, outer.width, outer.thickness, outer.groove_factor);
  g.extension = g.rim_steel.E * g.rim_width * g.rim_thickness;
  g.barrel_length = fs.barrel->length;
  g.barrel_thickness = fs.barrel->wall_thickness;
  g.length = g.barrel_length + g.rim_width;

  const RaceContacts races = race_contacts(bearing, g.ball_steel);
  // delta = c Q^(2/3) at each race: c is the approach at 1 N.
  const double c =
      hertz_contact(races.inner, 1.0).approach + hertz_contact(races.outer, 1.0).approach;
  g.ball_stiffness = std::pow(c, -1.5);  // (TC-5)
  g.balls = *bearing.ball_count;
  g.clearance = bearing.clearance;
  g.cam_flattening = wg.cam_flattening;
  add_mesh(g, *gear.mesh, options.friction);
  if (gear.circular_spline) {
    const CircularSpline& spline = *gear.circular_spline;
    const double E =
        elastic_constants(material_of(gear, spline.material, "circular_spline.material")).E;
    g.support = spline.support;
    g.spline_radius = (spline.outer_diameter + spline.inner_diameter) / 4;
    g.spline_bending = third_power_bending(
        E, spline.width, (spline.outer_diameter - spline.inner_diameter) / 2, 1.0);
  }
  return g;
}

ContactCracks contact_cracks(const GearSet& gear, const CoupledGeometry& geometry,
                             const BallForce& ball_force, std::vector<Note>& notes) {
  ContactCracksOf cracks(gear, geometry, ball_force, notes);
  const auto add = [&]<class Crack>(const std::string& path, const Crack& crack) {
    if constexpr (ContactCrack<Crack> || requires { crack.stress_driver; }) cracks.add(path, crack);
  };
  // The order of the hinges determines the order of a sum, and so its rounding.
  if (gear.mesh) for_each_crack("mesh", gear.mesh->crack, add);
  for_each_crack("flexspline", gear.flexspline->crack, add);
  if (gear.circular_spline) for_each_crack("circular_spline", gear.circular_spline->crack, add);
  for_each_crack("wave_generator", gear.wave_generator->crack, add);
  return std::move(cracks.result);
}

}  // namespace strainwave

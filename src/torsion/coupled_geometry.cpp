// SPDX-License-Identifier: Apache-2.0
#include "coupled_geometry.hpp"

#include <fmt/format.h>

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

/// What the coupled drive needs beyond what `check` asks for: field and meaning of the first thing
/// that is missing.
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

double third_power_bending(double E, double width, double thickness, double factor) {
  return E * width * thickness * thickness * thickness / 12 * factor;
}

/// Rotation of a hinge per unit of moment, c_M: an edge crack in bending.
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

/// Radial compliance of a race crack under the force of one ball, with the notes of its stress.
double race_crack_compliance(const GearSet& gear, std::size_t index, double ball_force,
                             std::vector<Note>& notes) {
  // The series model's crack under one lobe, whose force is made that of this ball.
  GearSet single = gear;
  WaveGenerator& wg = *single.wave_generator;
  wg.conversion = Conversion::reciprocity;
  if (wg.bearing) wg.bearing->loaded_balls = 1;
  const double f = lobe_force_per_torque(gear.drive, wg);
  single.load.torque = ball_force / f;
  const MemberCompliance member = wave_generator_compliance(single);
  const std::string path = fmt::format("wave_generator.crack[{}]", index);
  for (const Note& note : member.notes)
    if (note.path == path) notes.push_back(note);
  for (const CrackReport& report : member.cracks)
    if (report.path == path) return report.positive.at_output.value / (f * f);  // (TC-23)
  return 0.0;
}

}  // namespace

std::string missing_for_torsion_curve(const GearSet& gear) {
  const auto gap = missing(gear);
  return gap ? fmt::format("{}: must be given for the torsion curve ({})", gap->field, gap->what)
             : std::string();
}

CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options) {
  check(gear);
  if (const auto gap = missing(gear))
    throw InputError(gap->field,
                     fmt::format("must be given for the torsion curve ({})", gap->what));
  require(options.harmonics >= 8 && options.harmonics <= 128, "harmonics", options.harmonics, "1",
          ">= 8 and <= 128");
  const Transmission& drive = gear.drive;
  const Flexspline& fs = *gear.flexspline;
  const WaveGenerator& wg = *gear.wave_generator;
  const Bearing& bearing = *wg.bearing;
  const BearingRing& outer = *bearing.outer_ring;
  const ToothMesh& mesh = *gear.mesh;
  require(drive.wave_number == 2, "drive.wave_number", drive.wave_number, "1",
          "2 for the torsion curve");
  const double teeth = drive.wave_number * drive.ratio;
  require(std::abs(teeth - std::round(teeth)) < 1e-9 && teeth >= 20, "drive.ratio", drive.ratio,
          "1", "a whole number of teeth, wave_number times ratio, of 20 or more");

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
  require(fs.rim->outer_diameter < drive.pitch_diameter, "flexspline.rim.outer_diameter",
          fs.rim->outer_diameter, "m",
          "outer_diameter, of the tooth roots, < drive.pitch_diameter");
  require(drive.pitch_diameter - fs.rim->outer_diameter < 8 * g.module,
          "flexspline.rim.outer_diameter", fs.rim->outer_diameter, "m",
          "outer_diameter, of the tooth roots, within 4 modules of drive.pitch_diameter/2");
  const double bore = fs.rim->outer_diameter / 2 - fs.rim->wall_thickness;
  const double ring_outside = outer.mean_radius + outer.thickness / 2;
  if (std::abs(ring_outside - bore) > 0.005 * bore)
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
  require(wg.cam_flattening <= 6, "wave_generator.cam_flattening", wg.cam_flattening, "1",
          "<= 6 for the torsion curve");
  require(mesh.coning <= 5, "mesh.coning", mesh.coning, "1", "<= 5 for the torsion curve");
  const double kappa = drive.radial_displacement / g.module;
  require(kappa > 0.3 && kappa < 2, "drive.radial_displacement", drive.radial_displacement, "m",
          "0.3 to 2 modules for the torsion curve");
  g.rim_bending =
      third_power_bending(g.rim_steel.E, g.rim_width, g.rim_thickness, mesh.rim_stiffening);
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

  g.flank_angle = mesh.flank_angle;
  const double friction = std::atan(mesh.friction_coefficient);
  g.force_angle = g.flank_angle;
  if (options.friction == FlankFriction::loading) g.force_angle -= friction;    // (TC-16)
  if (options.friction == FlankFriction::unloading) g.force_angle += friction;  // (TC-16)
  require(g.force_angle > 0, "mesh.friction_coefficient", mesh.friction_coefficient, "1",
          "less than the tangent of mesh.flank_angle: else the flanks lock themselves");
  g.gap_factor = mesh.gap_factor;
  g.lobe_gap = mesh.lobe_gap;
  g.flank = {.pair_stiffness = mesh.pair_stiffness.value_or(
                 tooth_pair_stiffness(g.rim_steel.E, g.module, g.rim_thickness)),
             .face_width = g.rim_width,
             .slope = mesh.coning * std::sin(g.flank_angle) * g.radial_displacement /
                      (g.length - g.rim_width / 2)};  // (TC-8)
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

ContactCracks contact_cracks(const GearSet& gear, const CoupledGeometry& g,
                             const BallForce& ball_force, std::vector<Note>& notes) {
  ContactCracks cracks;
  const auto hinge = [&](RingHinge::Ring ring, const RingCrack& crack, double thickness,
                         double width, double bending, double scale,
                         const ElasticConstants& steel) {
    const double c_M = scale * hinge_compliance(crack.depth, thickness, width, steel);
    const double length = 2 * thickness;
    const double left = bending / (1 + c_M * bending / length);
    cracks.hinges.push_back({.ring = ring,
                             .position = crack.position,
                             .length = length,
                             .softening = (bending - left) * length});  // (TC-22)
  };
  if (gear.mesh)
    for (const ToothMeshCrack& any : gear.mesh->crack) {
      const auto& crack = std::get<ToothCrack>(any);
      cracks.teeth.push_back({crack.position, crack.stiffness_loss});
    }
  for (const FlexsplineCrack& any : gear.flexspline->crack)
    if (const auto* const crack = std::get_if<RimAxialCrack>(&any))
      hinge(RingHinge::Ring::rim, *crack, g.rim_thickness, g.rim_width, g.rim_bending, 1.0,
            g.rim_steel);
  if (gear.circular_spline && g.support > 0) {
    const CircularSpline& spline = *gear.circular_spline;
    for (const CircularSplineCrack& any : spline.crack)
      hinge(RingHinge::Ring::spline, std::get<CircularSplineRingCrack>(any),
            (spline.outer_diameter - spline.inner_diameter) / 2, spline.width,
            g.spline_bending / g.support, g.support,
            elastic_constants(material_of(gear, spline.material, "circular_spline.material")));
  } else if (gear.circular_spline && !gear.circular_spline->crack.empty()) {
    notes.push_back({"crack.rigid_ring",
                     "the circular spline is held rigidly (support = 0): a crack in it has no "
                     "effect",
                     "circular_spline.support", "TC-10", Severity::care,
                     "Give a support above 0."});
  }

  const WaveGenerator& wg = *gear.wave_generator;
  for (std::size_t i = 0; i < wg.crack.size(); ++i) {
    const std::string path = fmt::format("wave_generator.crack[{}]", i);
    std::visit(
        [&](const auto& crack) {
          using Crack = std::decay_t<decltype(crack)>;
          if constexpr (std::is_same_v<Crack, OuterRaceCrack>) {
            hinge(RingHinge::Ring::outer, crack, g.outer_thickness, g.outer_width, g.outer_bending,
                  1.0, g.ball_steel);
          } else if (crack.stress_driver != StressDriver::orthogonal_shear &&
                     crack.stress_driver != StressDriver::contact_edge) {
            notes.push_back(
                {"crack.not_of_a_ball",
                 "its stress does not follow from the force of the ball over it: it is "
                 "left out of the torsion curve",
                 path, "TC-23", Severity::care,
                 "Choose a stress_driver of the ball, orthogonal_shear or contact_edge."});
          } else if (const double force = ball_force(crack.position); force > 0) {
            cracks.balls.push_back({crack.position, race_crack_compliance(gear, i, force, notes)});
            notes.push_back(
                {"crack.under_a_ball",
                 fmt::format("taken with the nearest ball exactly over it, the worst "
                             "place, linear at {:.3g} N; the balls roll over it, so its "
                             "effect comes and goes at ball-pass frequency",
                             force),
                 path, "TC-23", Severity::care});
          } else {
            notes.push_back({"crack.unloaded_ball", "no ball that carries is near it: no effect",
                             path, "TC-23", Severity::information});
          }
        },
        wg.crack[i]);
  }
  return cracks;
}

}  // namespace strainwave

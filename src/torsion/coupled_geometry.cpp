// SPDX-License-Identifier: Apache-2.0
#include "coupled_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "flexspline_wall.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/crack_tables/crack_derivatives.hpp"
#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// Limits of the coupled drive.  Beyond a limit the input is a mistake, or a law is not valid.
// share of the bore [-]: a bearing with a larger deviation does not fit
constexpr double kFitInBore = 0.005;
constexpr double kMostFlattening = 6;      // c_cam [-], (TC-5): four times that of an ellipse
constexpr double kMostConing = 5;          // chi [-], (TC-8): five times an uncorrected tooth
constexpr int kLeastTeeth = 20;            // [-]: a tooth is small against the wave
constexpr int kMostTeeth = 2000;           // [-]: the unknowns fit into memory
constexpr double kWhole = 1e-9;            // rounding of a number of teeth [-]
constexpr double kTypicalAddendum = 0.65;  // of drawn teeth, over the module [-] (TC-29)
constexpr double kLeastFlankAngle = 15 * units::deg;  // of the finite elements of (TC-30)
constexpr double kMostFlankAngle = 30 * units::deg;

/// A missing input of the coupled drive that `check` does not require: its field and meaning.
struct Missing {
  std::string field;
  std::string what;
};

/// All fields that are missing for the coupled drive, in the order of the file.
std::vector<Missing> missing(const GearSet& gear) {
  std::vector<Missing> fields;
  const auto need = [&](bool given, const char* field, const char* what) {
    if (!given) fields.push_back({field, what});
    return given;
  };
  if (need(gear.wave_generator.has_value(), "wave_generator", "the cam and its bearing") &&
      need(gear.wave_generator->bearing.has_value(), "wave_generator.bearing",
           "balls and raceways")) {
    const Bearing& bearing = *gear.wave_generator->bearing;
    need(bearing.ball_count.has_value(), "wave_generator.bearing.ball_count", "balls all round");
    need(bearing.outer_ring.has_value(), "wave_generator.bearing.outer_ring",
         "the ring that bends with the rim");
  }
  if (need(gear.flexspline.has_value(), "flexspline", "the cup")) {
    const Flexspline& fs = *gear.flexspline;
    need(fs.crack_free == CrackFree::sections, "flexspline.crack_free",
         "\"sections\", with rim, barrel and diaphragm");
    need(fs.rim.has_value(), "flexspline.rim", "the toothed ring");
    need(fs.diaphragm.has_value(), "flexspline.diaphragm", "the bottom of the cup");
  }
  need(gear.mesh.has_value(), "mesh", "tooth engagement");
  return fields;
}

/// "must be given for the torsion curve (balls and raceways)": of the first field, with the others.
std::string rule_of(const std::vector<Missing>& gaps) {
  std::string rule = fmt::format("must be given for the torsion curve ({})", gaps.front().what);
  for (std::size_t i = 1; i < gaps.size(); ++i)
    rule += fmt::format("{}{}", i == 1 ? "; the torsion curve also needs these fields: " : ", ",
                        gaps[i].field);
  return rule;
}

/// Bending stiffness of a section, E b t^3/12 times a factor [N*m^2].
template <class Real>
Real third_power_bending(const Real& E, const Real& width, const Real& thickness,
                         const Real& factor) {
  return E * width * thickness * thickness * thickness / 12 * factor;
}

/// Rotation c_M of a hinge per unit of moment, from an edge crack in bending [rad/(N*m)].
template <class Real>
Real hinge_compliance(const Real& depth, const Real& thickness, const Real& width,
                      const BasicElasticConstants<Real>& steel) {
  const CrackNumbers<sif::BasicEdgeCrack<Real>> crack{
      .parameters = {.depth = depth,
                     .thickness = thickness,
                     .width = width,
                     .unit_stress = 6 / (width * thickness * thickness),
                     .loading = sif::StripLoading::bending},
      .moduli = {.opening = steel.plane_strain_modulus(), .shear = steel.G},
      .faces = {}};
  if constexpr (is_dual<Real>)
    return CrackDerivatives(crack, {})(crack).positive;  // (TC-22)
  else
    return added_compliance(crack.parameters, crack.moduli).matrix(0, 0);  // (TC-22)
}

/// The drive of the series model with the lobe force set to the force of one ball.
GearSet under_one_ball(const GearSet& gear, double ball_force) {
  GearSet single = gear;
  WaveGenerator& wg = *single.wave_generator;
  wg.conversion = Conversion::reciprocity;
  if (wg.bearing) wg.bearing->loaded_balls = 1;
  single.load.torque = ball_force / lobe_force_per_torque(gear.drive, wg);
  return single;
}

/// Radial compliance of a race crack under the force of one ball [m/N], with the notes of its
/// stress.
template <class Crack>
double race_crack_compliance(const GearSet& gear, const Lift<double>&, const std::string& path,
                             const Crack&, double ball_force, std::vector<Note>& notes) {
  const GearSet single = under_one_ball(gear, ball_force);
  const double f = lobe_force_per_torque(single.drive, *single.wave_generator);
  const MemberCompliance member = wave_generator_compliance(single);
  for (const Note& note : member.notes)
    if (note.path == path) notes.push_back(note);
  for (const CrackReport& report : member.cracks)
    if (report.path == path) return report.positive.at_output.value / (f * f);  // (TC-23)
  return 0.0;
}

/// The race crack compliance with its derivatives at a fixed torque and with respect to the torque;
/// (SN-2).
template <class Crack>
DualReal race_crack_compliance(const GearSet& gear, const Lift<DualReal>& lift,
                               const std::string& path, const Crack&, const DualReal& ball_force,
                               std::vector<Note>&) {
  const GearSet single = under_one_ball(gear, ball_force.value);
  // The inputs of the copy have other addresses.  Torque and number of balls differ from those of
  // the drive.
  std::array<const double*, kDualWidth> inputs{};
  std::vector<const double*> of_drive;
  for_each_number(gear, [&](const FieldPath&, const Field&, const double& number) {
    of_drive.push_back(&number);
  });
  std::size_t at = 0;
  for_each_number(single, [&](const FieldPath&, const Field&, const double& number) {
    const bool replaced =
        &number == &single.load.torque || &number == &single.wave_generator->bearing->loaded_balls;
    const auto* const found = std::ranges::find(lift.inputs(), of_drive[at++]);
    if (!replaced && found != lift.inputs().end())
      inputs[static_cast<std::size_t>(found - lift.inputs().begin())] = &number;
  });
  const auto compliance = [&](const Lift<DualReal>& reads) {
    DualReal result;
    const CrackLoads<DualReal> loads(single, reads);
    for_each_crack("wave_generator", single.wave_generator->crack,
                   [&](const std::string& of, const auto& crack) {
                     if constexpr (std::is_same_v<std::decay_t<decltype(crack)>, Crack>)
                       if (of == path) {
                         const auto numbers = loads.numbers(crack);
                         result = CrackDerivatives(numbers, {})(numbers).positive;
                       }
                   });
    return result;
  };
  const DualReal at_force = compliance(Lift<DualReal>(inputs));
  std::array<const double*, 1> torque = {&single.load.torque};
  const DualReal by_force = compliance(Lift<DualReal>(torque));
  // The crack is loaded by the force of the ball; the torque of the copy only represents this
  // force.
  const DualReal of_torque =
      ball_force / lobe_force_per_torque(lift, gear.drive, *gear.wave_generator);
  return at_force + chain(of_torque / of_torque.value, 0.0, by_force.partial[0]);  // (TC-23)
}

/// The tooth of the circular spline on its ring, and the ring's material.
template <class Real>
struct SplineTooth {
  BasicToothOnWall<Real> on_ring;
  BasicElasticConstants<Real> steel;
};

/// Without a circular spline in the file, the ring is as thick as the formula reaches.
template <class Real>
SplineTooth<Real> spline_tooth(const GearSet& gear, const Lift<Real>& lift,
                               const BasicCoupledGeometry<Real>& g,
                               const BasicToothOnWall<Real>& on_rim) {
  constexpr double kThickest = 40;  // modules (TC-30)
  SplineTooth<Real> tooth{.on_ring = on_rim, .steel = g.rim_steel};
  tooth.on_ring.thickness = pi * g.module - on_rim.thickness;
  tooth.on_ring.wall = kThickest * g.module;
  if (!gear.circular_spline) return tooth;
  const CircularSpline& spline = *gear.circular_spline;
  tooth.steel =
      elastic_constants(lift, material_of(gear, spline.material, "circular_spline.material"));
  const Real inside = lift(spline.inner_diameter);
  tooth.on_ring.wall = (lift(spline.outer_diameter) - inside) / 2;
  tooth.on_ring.dedendum = inside / 2 - g.pitch_radius - g.radial_displacement;
  return tooth;
}

/// Stiffness of a pair of drawn teeth per face width, c' (TC-30) [Pa].
/// @param g  with the extension of the toothed rim
template <class Real>
Real drawn_pair_stiffness(const BasicCoupledGeometry<Real>& g, const BasicToothOnWall<Real>& on_rim,
                          const SplineTooth<Real>& spline) {
  using std::cos, std::log, std::sin, std::sqrt;
  const Real& alpha = g.flank_angle;
  const Real& nu = g.rim_steel.nu;
  const Real layer = 2 * (1 - nu * nu) / pi;
  // The reference load of the line contact is T2 of a steel drive by convention (TC-14) on a sixth
  // of the teeth, and its curvature is that of an involute against a straight flank.
  constexpr double kT2 = 0.187e6 / 206e9;  // over E and the cube of the pitch diameter [-]
  const Real d = 2 * g.pitch_radius;
  const Real force =
      12 * kT2 * g.rim_steel.E * d * d / (cos(alpha) * g.teeth * g.rim_width);  // [N/m]
  const Real both = 1 / g.rim_steel.E + 1 / spline.steel.E;
  const Real half_width =
      sqrt(4 * (1 - nu * nu) * force * (g.pitch_radius * sin(alpha)) * both / pi);
  const Real depth = on_rim.thickness / (2 * cos(alpha));
  const Real contact = layer * (log(2 * depth / half_width) + 0.045) * both;
  const Real step = cos(alpha) * cos(alpha) * pi / 12 * g.module * g.rim_width / g.extension;
  return 1 / (tooth_compliance(on_rim, nu) / g.rim_steel.E +
              tooth_compliance(spline.on_ring, spline.steel.nu) / spline.steel.E + contact + step);
}

/// Sets the flank angle, and the gaps and stiffness of the tooth pairs.
template <class Real>
void add_mesh(BasicCoupledGeometry<Real>& g, const GearSet& gear, const Lift<Real>& lift) {
  const ToothMesh& mesh = *gear.mesh;
  using std::sin;
  g.flank_angle = lift(mesh.flank_angle);
  g.gap_factor = lift(mesh.gap_factor);
  g.lobe_gap = lift(mesh.lobe_gap);
  const Real cone = lift(mesh.coning) * g.radial_displacement * g.tilt;  // (TC-8)
  g.flank = {.pair_stiffness = mesh.pair_stiffness
                                   ? Real(lift(*mesh.pair_stiffness))
                                   : tooth_pair_stiffness(g.rim_steel.E, g.module, g.rim_thickness),
             .face_width = g.rim_width,
             .slope = cone * sin(g.flank_angle)};
  if (!mesh.tooth) return;
  const ToothShape& shape = *mesh.tooth;
  const auto given = [&](const std::optional<double>& number, const Real& typical) {
    return number ? Real(lift(*number)) : typical;
  };
  const Real addendum = given(shape.addendum, kTypicalAddendum * g.module);
  if (shape.profile == ToothProfile::half_path)
    g.flank_angle = half_path_angle(addendum, g.radial_displacement, g.module);  // (TC-29)
  const BasicTeeth<Real> teeth{
      .profile = shape.profile,
      .flank_angle = g.flank_angle,
      .addendum = addendum,
      .spline_addendum = given(shape.spline_addendum, kTypicalAddendum * g.module),
      .thickness = given(shape.thickness, pi / 2 * g.module),
      .ring_radius = g.ring_radius,
      .pitch_offset = g.pitch_radius - g.ring_radius,
      .wave = g.radial_displacement,
      .teeth = g.teeth,
      .tips = shape.tips};
  g.tooth.emplace(teeth, cone, g.rim_width);
  const BasicToothOnWall<Real> on_rim{
      .flank_angle = g.flank_angle,
      .thickness = teeth.thickness,
      .dedendum = g.pitch_radius - g.ring_radius - g.rim_thickness / 2,
      .wall = g.rim_thickness,
      .module = g.module};
  g.extension *= toothed_extension(on_rim);  // (TC-30)
  const SplineTooth<Real> spline = spline_tooth(gear, lift, g, on_rim);
  if (!mesh.pair_stiffness) g.flank.pair_stiffness = drawn_pair_stiffness(g, on_rim, spline);
  if (gear.circular_spline)
    g.neighbours.emplace(spline.on_ring, spline.steel, g.rim_width,
                         g.teeth);  // (TC-31)
}

/// A ring that a crack softens.
template <class Real>
struct CrackedRing {
  RingHinge::Ring ring{};
  Real thickness{};   // [m]
  Real width{};       // [m]
  Real bending{};     // EI; for the circular spline, EI over its support [N*m^2]
  Real support{1.0};  // share of the ring's compliance that remains in its housing [-]
  BasicElasticConstants<Real> steel;
};

/// Turns cracks into their effects in the contact problem.  Each kind of effect has an overload of
/// `add`.
template <class Real>
class ContactCracksOf {
 public:
  ContactCracksOf(const GearSet& gear, const Lift<Real>& lift,
                  const BasicCoupledGeometry<Real>& geometry,
                  const BasicBallForce<Real>& ball_force, std::vector<Note>& notes)
      : gear_(gear), lift_(lift), geometry_(geometry), ball_force_(ball_force), notes_(notes) {}

  [[nodiscard]] BasicContactCracks<Real> all() && {
    const auto take = [&]<class Crack>(const std::string& path, const Crack& crack) {
      if constexpr (ContactCrack<Crack> || requires { crack.stress_driver; }) add(path, crack);
    };
    // The order of the hinges determines the order of a sum, and so its rounding.
    if (gear_.mesh) for_each_crack("mesh", gear_.mesh->crack, take);
    for_each_crack("flexspline", gear_.flexspline->crack, take);
    if (gear_.circular_spline)
      for_each_crack("circular_spline", gear_.circular_spline->crack, take);
    for_each_crack("wave_generator", gear_.wave_generator->crack, take);
    return std::move(result_);
  }

 private:
  void add(const std::string&, const ToothCrack& crack) {
    result_.teeth.push_back({crack.position, lift_(crack.stiffness_loss)});
  }

  template <CrackedPart part, bool from_inside>
  void add(const std::string& path, const RingCrack<part, from_inside>& crack) {
    if (part == CrackedPart::circular_spline && !(geometry_.support > 0)) {
      note_rigid_spline();
      return;
    }
    const CrackedRing<Real> ring = ring_of(part);
    const Real c_M = ring.support * hinge_compliance<Real>(lift_(crack.depth), ring.thickness,
                                                           ring.width, ring.steel);
    const Real length = crack.softened_length(ring.thickness);
    const Real left = ring.bending / (1 + c_M * ring.bending / length);
    result_.hinges.push_back({.ring = ring.ring,
                              .position = lift_(crack.position),
                              .length = length,
                              .softening = (ring.bending - left) * length,  // (TC-22)
                              .from_inside = from_inside,
                              .path = path,
                              .depth = crack.depth});
  }

  /// Adds a crack of the inner race, which the balls load.
  template <class Crack>
  requires requires(const Crack& crack) { crack.stress_driver; }
  void add(const std::string& path, const Crack& crack) {
    if (crack.stress_driver != StressDriver::orthogonal_shear &&
        crack.stress_driver != StressDriver::contact_edge) {
      notes_.push_back(
          {"crack.not_of_a_ball",
           "the stress of this crack does not follow from the force of the ball over "
           "it, so the torsion curve leaves the crack out",
           path, "TC-23", Severity::care,
           "If the curve must contain the crack, choose stress_driver = \"contact_edge\", an "
           "upper bound. Otherwise, read the effect of this crack from the sum of "
           "the members."});
    } else if (const Real force = ball_force_(crack.position); force > 0) {
      result_.balls.push_back(
          {crack.position, race_crack_compliance(gear_, lift_, path, crack, force, notes_)});
      notes_.push_back(
          {"crack.under_a_ball",
           fmt::format("the nearest ball is assumed to be exactly over this crack, the worst "
                       "place, with a linear response at {:.3g} N; in a turning drive the balls "
                       "roll over the crack, so its effect comes and goes at ball-pass frequency",
                       value_of(force)),
           path, "TC-23", Severity::care});
    } else {
      notes_.push_back({"crack.unloaded_ball",
                        "no loaded ball is near this crack, so it has no effect", path, "TC-23",
                        Severity::information});
    }
  }

  [[nodiscard]] CrackedRing<Real> ring_of(CrackedPart part) const {
    const BasicCoupledGeometry<Real>& g = geometry_;
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
            .thickness = (lift_(spline.outer_diameter) - lift_(spline.inner_diameter)) / 2,
            .width = lift_(spline.width),
            .bending = g.spline_bending / g.support,
            .support = g.support,
            .steel = elastic_constants(
                lift_, material_of(gear_, spline.material, "circular_spline.material"))};
  }

  void note_rigid_spline() {
    const Note note{
        .code = "crack.rigid_ring",
        .text = "the circular spline is held rigidly (support = 0), so a crack in it has no effect",
        .path = "circular_spline.support",
        .equation = "TC-10",
        .severity = Severity::care,
        .next_step = "Give a support above 0."};
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(note);
  }

  BasicContactCracks<Real> result_;
  const GearSet& gear_;
  const Lift<Real>& lift_;
  const BasicCoupledGeometry<Real>& geometry_;
  const BasicBallForce<Real>& ball_force_;
  std::vector<Note>& notes_;
};

/// Rules of half-path flanks (TC-29).
void check_half_path(const Transmission& drive, double module, double addendum,
                     double spline_addendum) {
  // With a smaller wave the tooth has a shoulder at the pitch height, and with a larger one its
  // path turns back at the lobe.
  constexpr double kLeast = 0.9;
  constexpr double kMost = 1.05;
  require(
      drive.radial_displacement >= kLeast * module && drive.radial_displacement <= kMost * module,
      "drive.radial_displacement", drive.radial_displacement, "m",
      "between 0.9 and 1.05 modules for mesh.tooth.profile = \"half_path\" (TC-29)");
  require(
      addendum <= spline_addendum, "mesh.tooth.addendum", addendum, "m",
      "at most spline_addendum for mesh.tooth.profile = \"half_path\", because the tooth sweeps "
      "the wall only as far as its own addendum reaches (TC-29)");
  const double angle = half_path_angle(addendum, drive.radial_displacement, module);
  require(angle >= kLeastFlankAngle && angle <= kMostFlankAngle, "mesh.tooth.addendum", addendum,
          "m",
          fmt::format("an addendum with a mean angle of the half-path flank between 15 and 30 deg, "
                      "which is {:.1f} deg (TC-30)",
                      angle / units::deg));
}

/// Rules of teeth as drawn.
void check_teeth(const GearSet& gear, const ToothShape& tooth) {
  const Transmission& drive = gear.drive;
  const double module = drive.pitch_diameter / (drive.wave_number * drive.ratio);
  const double addendum = tooth.addendum.value_or(kTypicalAddendum * module);
  const double spline_addendum = tooth.spline_addendum.value_or(kTypicalAddendum * module);
  const double rim_dedendum = (drive.pitch_diameter - gear.flexspline->rim->outer_diameter) / 2;
  require(addendum + spline_addendum < 2 * drive.radial_displacement, "mesh.tooth.addendum",
          addendum, "m",
          "addendum + spline_addendum < 2 drive.radial_displacement, because otherwise the teeth "
          "never part");
  require(spline_addendum <= rim_dedendum, "mesh.tooth.spline_addendum", spline_addendum, "m",
          "at most (drive.pitch_diameter - flexspline.rim.outer_diameter)/2, because otherwise the "
          "tips of the circular spline meet the roots of the flexspline");
  const double pitch = pi * module;
  const double thickness = tooth.thickness.value_or(pitch / 2);
  require(thickness >= 0.4 * pitch && thickness <= 0.6 * pitch, "mesh.tooth.thickness", thickness,
          "m", "between 0.4 and 0.6 pitches, pi pitch_diameter/teeth");
  const bool half_path = tooth.profile == ToothProfile::half_path;
  if (half_path) check_half_path(drive, module, addendum, spline_addendum);
  const double narrowing =
      2 * std::tan(half_path ? half_path_angle(addendum, drive.radial_displacement, module)
                             : gear.mesh->flank_angle);
  require(narrowing * addendum < thickness, "mesh.tooth.addendum", addendum, "m",
          "2 addendum tan(mesh.flank_angle) < thickness, because otherwise the tooth is pointed");
  require(
      narrowing * spline_addendum < pitch - thickness, "mesh.tooth.spline_addendum",
      spline_addendum, "m",
      "2 spline_addendum tan(mesh.flank_angle) < pitch - thickness, because otherwise the tooth "
      "of the circular spline is pointed");
  // The finite elements of (TC-30) cover these teeth.  Outside, the fits may even turn negative.
  const auto covered = [&](double dedendum, const char* field, double value, const char* rule) {
    require(dedendum >= 0.9 * module && dedendum <= 1.5 * module, field, value, "m", rule);
  };
  require(half_path || (gear.mesh->flank_angle >= kLeastFlankAngle &&
                        gear.mesh->flank_angle <= kMostFlankAngle),
          "mesh.flank_angle", gear.mesh->flank_angle, "rad",
          "between 15 and 30 deg for drawn teeth (TC-30)");
  covered(rim_dedendum, "flexspline.rim.outer_diameter", gear.flexspline->rim->outer_diameter,
          "1.8 to 3 modules below drive.pitch_diameter for drawn teeth (TC-30)");
  require(narrowing * rim_dedendum <= pitch - thickness, "flexspline.rim.outer_diameter",
          gear.flexspline->rim->outer_diameter, "m",
          "at least drive.pitch_diameter - (pitch - thickness)/tan(mesh.flank_angle), because "
          "otherwise the roots of the flexspline's teeth overlap (TC-30)");
  require(gear.flexspline->rim->wall_thickness >= 0.4 * module, "flexspline.rim.wall_thickness",
          gear.flexspline->rim->wall_thickness, "m", ">= 0.4 modules for drawn teeth (TC-30)");
  // A pair alone is softer than this, because its line contact has more than 3/E.  Up to this limit
  // the contacts stay stable with the neighbours of (TC-31).
  if (gear.mesh->pair_stiffness) {
    const double E = elastic_constants(rim_material(gear, *gear.flexspline)).E;
    require(*gear.mesh->pair_stiffness <= E / 3, "mesh.pair_stiffness", *gear.mesh->pair_stiffness,
            "Pa",
            "at most a third of Young's modulus of the flexspline's rim for drawn teeth (TC-31)");
  }
  if (!gear.circular_spline) return;
  const double inside = gear.circular_spline->inner_diameter;
  const double spline_dedendum = inside / 2 - drive.pitch_diameter / 2 - drive.radial_displacement;
  require(spline_dedendum >= addendum, "circular_spline.inner_diameter", inside, "m",
          "at least drive.pitch_diameter + 2 (drive.radial_displacement + mesh.tooth.addendum), "
          "because otherwise the tips of the flexspline meet the roots of the circular spline");
  covered(spline_dedendum, "circular_spline.inner_diameter", inside,
          "1.8 to 3 modules above drive.pitch_diameter + 2 drive.radial_displacement for drawn "
          "teeth (TC-30)");
  require(narrowing * spline_dedendum <= thickness, "circular_spline.inner_diameter", inside, "m",
          "at most drive.pitch_diameter + 2 drive.radial_displacement + "
          "thickness/tan(mesh.flank_angle), because otherwise the roots of the circular spline's "
          "teeth overlap (TC-31)");
}

/// Largest coupling of a wall's stretching with its shear or bending, relative [-], up to which the
/// ring leaves the coupling out.  Angles of plies scatter by a degree or two.
constexpr double kNearlyUncoupled = 0.05;

/// Rules of walls of laminates (LA-16), (LA-17).
void check_walls(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  (void)rim_material(gear, fs);
  const auto check_wall = [&](std::string_view name, const auto& section, double thickness) {
    const std::string field = section.material ? fmt::format("flexspline.{}.material", name)
                                               : std::string("flexspline.material");
    const std::string& material = material_name(fs, section);
    const auto wall =
        wall_laminate(Lift<double>(), gear, material_of(gear, material, field), thickness);
    if (wall && !balanced_and_symmetric(*wall, kNearlyUncoupled))
      throw InputError(
          field,
          fmt::format("\"{}\" couples stretching with shear or bending, which the coupled drive "
                      "does not know; give a symmetric laminate with as many plies at +angle as at "
                      "-angle",
                      shown(material)));
  };
  check_wall("barrel", *fs.barrel, fs.barrel->wall_thickness);
  check_wall("diaphragm", *fs.diaphragm, fs.diaphragm->thickness);
}

}  // namespace

std::string missing_for_torsion_curve(const GearSet& gear) {
  const std::vector<Missing> gaps = missing(gear);
  return gaps.empty() ? std::string() : fmt::format("{}: {}", gaps.front().field, rule_of(gaps));
}

void check_coupled(const GearSet& gear, const CoupledOptions& options) {
  check(gear);
  if (const auto gaps = missing(gear); !gaps.empty())
    throw InputError(gaps.front().field, rule_of(gaps));
  require(options.harmonics >= 8 && options.harmonics <= 128, "harmonics", options.harmonics, "1",
          ">= 8 and <= 128");
  require(std::isfinite(options.cage_phase), "cage_phase", options.cage_phase, "rad",
          "a finite number");
  if (gear.tolerance) (void)deviation_limits(gear);
  check_walls(gear);
  const Transmission& drive = gear.drive;
  const TubeSection& rim = *gear.flexspline->rim;
  const WaveGenerator& wg = *gear.wave_generator;
  const Bearing& bearing = *wg.bearing;
  require(drive.wave_number == 2, "drive.wave_number", drive.wave_number, "1",
          "2 for the torsion curve");
  const double teeth = drive.wave_number * drive.ratio;
  require(
      std::abs(teeth - std::round(teeth)) < kWhole && teeth >= kLeastTeeth && teeth <= kMostTeeth,
      "drive.ratio", drive.ratio, "1",
      "a whole number of teeth, wave_number times ratio, from 20 to 2000");
  require(rim.outer_diameter < drive.pitch_diameter, "flexspline.rim.outer_diameter",
          rim.outer_diameter, "m", "outer_diameter (of the tooth roots) < drive.pitch_diameter");
  const double bore = rim.outer_diameter / 2 - rim.wall_thickness;
  const double ring_outside = bearing.outer_ring->mean_radius + bearing.outer_ring->thickness / 2;
  if (std::abs(ring_outside - bore) > kFitInBore * bore)
    throw InputError(
        "wave_generator.bearing.outer_ring.mean_radius",
        fmt::format("makes an outer radius of {:.5g} mm in a flexspline bore of {:.5g} mm, so the "
                    "bearing does not assemble; both must agree within 0.5 %",
                    1e3 * ring_outside, 1e3 * bore));
  if (bearing.outer_raceway_diameter / 2 > ring_outside)
    throw InputError("wave_generator.bearing.outer_raceway_diameter",
                     bearing.outer_raceway_diameter, "m",
                     "inside the outer ring, whose outer diameter is 2 mean_radius + thickness");
  require(bearing.clearance < drive.radial_displacement, "wave_generator.bearing.clearance",
          bearing.clearance, "m", "clearance < drive.radial_displacement");
  if (!cam_flattening(wg))
    throw InputError(
        "wave_generator.cam.profile",
        "must be \"cosine\" or \"ellipse\" for the torsion curve, which does not know "
        "other cams; without wave_generator.cam, cam_flattening gives a flattened cosine");
  require(wg.cam_flattening <= kMostFlattening, "wave_generator.cam_flattening", wg.cam_flattening,
          "1", "<= 6 for the torsion curve");
  if (gear.mesh->tooth) check_teeth(gear, *gear.mesh->tooth);
  require(gear.mesh->coning <= kMostConing, "mesh.coning", gear.mesh->coning, "1",
          "<= 5 for the torsion curve");
}

template <class Real>
BasicCoupledGeometry<Real> coupled_geometry(const GearSet& gear, const CoupledOptions& options,
                                            const Lift<Real>& lift) {
  using std::pow;
  const Transmission& drive = gear.drive;
  const Flexspline& fs = *gear.flexspline;
  const WaveGenerator& wg = *gear.wave_generator;
  const Bearing& bearing = *wg.bearing;
  const BearingRing& outer = *bearing.outer_ring;
  const double teeth = drive.wave_number * drive.ratio;
  BasicCoupledGeometry<Real> g;
  g.rim_steel = elastic_constants(lift, rim_material(gear, fs));
  g.ball_steel = elastic_constants(lift, material_of(gear, wg.material, "wave_generator.material"));
  g.pitch_radius = lift(drive.pitch_diameter) / 2;
  g.radial_displacement = lift(drive.radial_displacement);
  g.teeth = static_cast<int>(std::lround(teeth));
  g.module = lift(drive.pitch_diameter) / teeth;
  g.rim_thickness = lift(fs.rim->wall_thickness);
  g.rim_width = lift(fs.rim->length);
  g.ring_radius = (lift(fs.rim->outer_diameter) - lift(fs.rim->wall_thickness)) / 2;
  g.rim_bending = third_power_bending<Real>(g.rim_steel.E, g.rim_width, g.rim_thickness,
                                            lift(gear.mesh->rim_stiffening));
  g.outer_thickness = lift(outer.thickness);
  g.outer_width = lift(outer.width);
  g.outer_bending = third_power_bending<Real>(g.ball_steel.E, lift(outer.width),
                                              lift(outer.thickness), lift(outer.groove_factor));
  g.extension = g.rim_steel.E * g.rim_width * g.rim_thickness;
  g.barrel_length = lift(fs.barrel->length);
  g.barrel_thickness = lift(fs.barrel->wall_thickness);
  if (const Material& barrel =
          material_of(gear, material_name(fs, *fs.barrel), "flexspline.material");
      !barrel.is_laminate())
    g.barrel_modulus = elastic_constants(lift, barrel).plane_strain_modulus();
  g.tilt =
      wall_mode(flexspline_wall(fs, lift, g.ring_radius, wall_materials(gear, lift, g.ring_radius),
                                options.diaphragm_warping),
                2)
          .tilt;

  const BasicRaceContacts<Real> races = race_contacts(lift, bearing, g.ball_steel);
  // delta = c Q^(2/3) at each race: c is the approach at 1 N.
  const Real c = hertz_contact(races.inner, Real(1.0)).approach +
                 hertz_contact(races.outer, Real(1.0)).approach;
  g.ball_stiffness = pow(c, -1.5);  // (TC-5)
  g.balls = *bearing.ball_count;
  g.clearance = lift(bearing.clearance);
  g.cam_flattening = wg.cam ? Real(cam_flattening(wg).value()) : lift(wg.cam_flattening);
  add_mesh(g, gear, lift);
  if (gear.circular_spline) {
    const CircularSpline& spline = *gear.circular_spline;
    const Real E =
        elastic_constants(lift, material_of(gear, spline.material, "circular_spline.material")).E;
    const Real outside = lift(spline.outer_diameter);
    const Real inside = lift(spline.inner_diameter);
    g.support = lift(spline.support);
    g.spline_radius = (outside + inside) / 4;
    g.spline_bending =
        third_power_bending<Real>(E, lift(spline.width), (outside - inside) / 2, 1.0);
  }
  return g;
}

CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options) {
  check_coupled(gear, options);
  return coupled_geometry(gear, options, Lift<double>());
}

double drive_pair_stiffness(const GearSet& gear) {
  return coupled_geometry(gear, CoupledOptions{}).flank.pair_stiffness;
}

template <class Real>
BasicContactCracks<Real> contact_cracks(const GearSet& gear, const Lift<Real>& lift,
                                        const BasicCoupledGeometry<Real>& geometry,
                                        const BasicBallForce<Real>& ball_force,
                                        std::vector<Note>& notes) {
  return ContactCracksOf<Real>(gear, lift, geometry, ball_force, notes).all();
}

template CoupledGeometry coupled_geometry(const GearSet&, const CoupledOptions&,
                                          const Lift<double>&);
template BasicCoupledGeometry<DualReal> coupled_geometry(const GearSet&, const CoupledOptions&,
                                                         const Lift<DualReal>&);
template ContactCracks contact_cracks(const GearSet&, const Lift<double>&, const CoupledGeometry&,
                                      const BallForce&, std::vector<Note>&);
template BasicContactCracks<DualReal> contact_cracks(const GearSet&, const Lift<DualReal>&,
                                                     const BasicCoupledGeometry<DualReal>&,
                                                     const BasicBallForce<DualReal>&,
                                                     std::vector<Note>&);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/torsion_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "coupled_drive.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The members beside the ring, in series with it.
struct SeriesMembers {
  double barrel = 0.0;
  double diaphragm = 0.0;
  double rim = 0.0;
  double boss_and_flange = 0.0;
  double output_shaft = 0.0;
  double cracks_positive = 0.0;
  double cracks_negative = 0.0;

  [[nodiscard]] double cracks(double torque) const {
    return torque < 0 ? cracks_negative : cracks_positive;
  }
  [[nodiscard]] double sound() const {
    return barrel + diaphragm + rim + boss_and_flange + output_shaft;
  }
};

double tube_compliance(const TubeSection& section, double length, double G) {
  return torsional_compliance(
      Tube{.outer_diameter = section.outer_diameter,
           .inner_diameter = section.outer_diameter - 2 * section.wall_thickness,
           .length = length},
      G);
}

SeriesMembers series_members(const GearSet& gear, TorsionCurve& curve) {
  const Flexspline& fs = *gear.flexspline;
  const double G = elastic_constants(material_of(gear, fs.material, "flexspline.material")).G;
  SeriesMembers series;
  series.barrel = tube_compliance(*fs.barrel, fs.barrel->length, G);
  series.diaphragm = torsional_compliance(*fs.diaphragm, G);  // (TC-13)
  // (TC-13): traction spread evenly over the teeth twists the rim like a third of its length.
  series.rim = tube_compliance(*fs.rim, fs.rim->length / 3, G);
  if (fs.boss) series.boss_and_flange += tube_compliance(*fs.boss, fs.boss->length, G);
  series.boss_and_flange += fs.flange_compliance;
  const auto take = [&](const MemberCompliance& member, bool notes) {
    for (const CrackReport& crack : member.cracks) {
      series.cracks_positive += crack.positive.at_output.value;
      series.cracks_negative += crack.negative.at_output.value;
    }
    if (notes)
      for (const Note& note : member.notes)
        if (note.code != "crack.contact_path") curve.notes.push_back(note);
    if (curve.unusable_because.empty()) curve.unusable_because = member.unusable_because;
  };
  if (!fs.crack.empty()) take(flexspline_compliance(gear), true);
  if (gear.output_shaft) {
    const MemberCompliance shaft = output_shaft_compliance(gear);
    series.output_shaft = shaft.intact;
    take(shaft, true);
  }
  return series;
}

void note_geometry(const GearSet& gear, const CoupledGeometry& g, TorsionCurve& curve) {
  const double kappa = g.radial_displacement / g.module;
  if (kappa < 0.6 || kappa > 1.3)
    curve.notes.push_back(
        {"torsion.deflection",
         fmt::format("w_0 is {:.3g} modules; the gap law is for about one", kappa),
         "drive.radial_displacement", "TC-7"});
  if (const double least = least_flank_angle(kappa); g.flank_angle < least)
    curve.notes.push_back(
        {"torsion.flank_angle",
         fmt::format("w_0 of {:.3g} modules needs flanks of {:.3g} degrees or more, else the "
                     "tooth path crosses the flank",
                     kappa, least * 180 / pi),
         "mesh.flank_angle", "TC-25"});
  if (gear.drive.ratio < 50)
    curve.notes.push_back({"torsion.low_ratio",
                           "against catalogues the model is too stiff below ratio 50, by a factor "
                           "of up to 2.2 at 30: take it as empirical there",
                           "drive.ratio", "TC-14"});
  if (gear.drive.pitch_diameter < 0.043)
    curve.notes.push_back({"torsion.small_size",
                           "makers' drives below size 17 are not similar to the larger ones, and "
                           "typical proportions miss their stiffness by 20 to 60 %",
                           "drive.pitch_diameter", "TC-14"});
  if (gear.circular_spline == std::nullopt)
    curve.notes.push_back({"torsion.rigid_spline",
                           "no circular spline given: it is taken as rigid, which is 13 to 36 % "
                           "too stiff",
                           "circular_spline", "TC-10"});
}

CurvePoint point_of(CoupledDrive& drive, const Equilibrium& state, const SeriesMembers& series) {
  const double R = drive.geometry().ring_radius;
  CurvePoint point;
  point.torque = state.torque;
  point.ring_rotation = (state.rotation - drive.assembled().rotation) / R;
  const double in_series = series.sound() + series.cracks(state.torque);
  point.twist = point.ring_rotation + in_series * state.torque;  // (TC-14)
  point.residual = state.residual;
  point.iterations = state.iterations;
  const CoupledDrive::Tangent tangent = drive.tangent(state);
  point.tangent_compliance = tangent.rotation / R + in_series;  // (TC-15)
  if (std::isfinite(tangent.rotation)) {
    drive.add_shares(state, tangent, point.share);
    const auto add = [&](CurveMember member, double value) {
      point.share[static_cast<std::size_t>(member)] += value;
    };
    add(CurveMember::barrel, series.barrel);
    add(CurveMember::diaphragm, series.diaphragm);
    add(CurveMember::rim_shear, series.rim);
    add(CurveMember::boss_and_flange, series.boss_and_flange);
    add(CurveMember::output_shaft, series.output_shaft);
    add(CurveMember::series_cracks, series.cracks(state.torque));
    for (double& share : point.share) share /= point.tangent_compliance;
  }
  for (int i = 0; i < drive.contacts(); ++i) {
    const ContactForce contact{drive.position_of(i), state.force[i], tangent.force[i]};
    const bool touches = state.force[i] > 0;
    if (i < drive.balls()) {
      point.balls.push_back(contact);
      point.balls_in_contact += touches;
    } else if (touches) {
      const bool drives = i < drive.balls() + drive.tooth_count();
      (drives ? point.drive_flanks : point.coast_flanks).push_back(contact);
      // A tooth that touches on both flanks is one tooth.
      point.teeth_in_contact += drives || !(state.force[i - drive.tooth_count()] > 0);
    }
  }
  return point;
}

/// The larger force of the ball nearest to a position, of both senses of torque at T2, in the
/// sound drive [N].
double sound_ball_force(CoupledDrive& sound, double torque, double position) {
  double largest = 0.0;
  for (const double sense : {1.0, -1.0}) {
    const Equilibrium state = sound.solve(sense * torque, sound.assembled());
    int nearest = 0;
    const auto distance = [&](int ball) {
      return std::abs(std::remainder(sound.position_of(ball) - position, 2 * pi));
    };
    for (int ball = 1; ball < sound.balls(); ++ball)
      if (distance(ball) < distance(nearest)) nearest = ball;
    largest = std::max(largest, state.force[nearest]);
  }
  return largest;
}

/// A drive on its cam, or the reason why there is none.  The cam is that of the sound drive.
struct Assembly {
  CoupledDrive drive;
  std::string fails_because;
  std::vector<std::string> equations;  ///< of the cracks that act in the contacts
};

Assembly assemble(const GearSet& gear, const CoupledGeometry& g, std::vector<Note>& notes,
                  const CoupledOptions& options) {
  Assembly assembly{CoupledDrive(gear, g, {}, options), {}, {}};
  if (!assembly.drive.assemble()) {
    assembly.fails_because =
        assembly.drive.assembled().converged
            ? fmt::format(
                  "the drive does not assemble: no cam amplitude lifts the lobes by w_0 = "
                  "{:.4g} mm with a flank gap of {:.4g} um and a bearing clearance of "
                  "{:.4g} um",
                  1e3 * g.radial_displacement, 1e6 * g.lobe_gap, 1e6 * g.clearance)
            : fmt::format(
                  "the assembled state was not found: residual {:.2g} of the largest "
                  "contact force after {} steps",
                  assembly.drive.assembled().residual, assembly.drive.assembled().iterations);
    return assembly;
  }
  const double T2 = makers_torques(gear).T2;
  const ContactCracks cracks = contact_cracks(
      gear, g, [&](double position) { return sound_ball_force(assembly.drive, T2, position); },
      notes);
  if (!cracks.teeth.empty()) assembly.equations.emplace_back("TC-21");
  if (!cracks.hinges.empty()) assembly.equations.emplace_back("TC-22");
  if (!cracks.balls.empty()) assembly.equations.emplace_back("TC-23");
  if (assembly.equations.empty()) return assembly;
  const double amplitude = assembly.drive.cam_amplitude();
  assembly.drive = CoupledDrive(gear, g, cracks, options);
  if (!assembly.drive.assemble_on(amplitude))
    assembly.fails_because = "the cracked drive does not assemble on the cam of the sound one";
  return assembly;
}

}  // namespace

TorsionCurve torsion_curve(const GearSet& gear, std::span<const double> torques,
                           const CoupledOptions& options) {
  const CoupledGeometry geometry = coupled_geometry(gear, options);
  for (const double torque : torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  TorsionCurve curve;
  curve.teeth = geometry.teeth;
  for (const char* const tag : {"TC-1", "TC-2", "TC-4", "TC-5", "TC-6", "TC-7", "TC-8", "TC-9",
                                "TC-11", "TC-12", "TC-13", "TC-14", "TC-15"})
    curve.equations.emplace_back(tag);
  if (geometry.support > 0) curve.equations.emplace_back("TC-10");
  note_geometry(gear, geometry, curve);
  const SeriesMembers series = series_members(gear, curve);
  curve.series_compliance = series.sound();
  Assembly assembly = assemble(gear, geometry, curve.notes, options);
  std::ranges::move(assembly.equations, std::back_inserter(curve.equations));
  if (!assembly.fails_because.empty()) {
    curve.unusable_because = std::move(assembly.fails_because);
    return curve;
  }
  CoupledDrive& drive = assembly.drive;
  curve.cam_amplitude = drive.cam_amplitude();
  for (int k = 0; k < drive.balls(); ++k)
    curve.assembly_ball_force = std::max(curve.assembly_ball_force, drive.assembled().force[k]);
  if (const double jam = drive.largest_flank_force(drive.assembled()); jam > 0)
    curve.notes.push_back(
        {"torsion.interference",
         fmt::format("the flanks press on each other without torque, with up to {:.3g} N: {}", jam,
                     geometry.lobe_gap < 0
                         ? fmt::format("the lobe gap of {:.4g} um is an interference",
                                       1e6 * geometry.lobe_gap)
                         : std::string("the assembled ring bulges beside the lobes; see clearance, "
                                       "cam_flattening, ball_count, flank_angle")),
         "mesh.lobe_gap", "TC-6"});
  Equilibrium state = drive.assembled();
  // Half a pitch of free travel: the flanks of this tooth never meet, the next one's would.
  const double most = pi * geometry.pitch_radius / geometry.teeth;
  for (const double torque : torques) {
    // At no torque the ring rests where it was assembled, whatever the path.
    state = torque == 0 ? drive.assembled() : drive.solve(torque, state);
    if (!state.converged) {
      curve.unusable_because = fmt::format(
          "no equilibrium at {:.6g} N*m: residual {:.2g} of the largest contact force "
          "after {} steps",
          torque, state.residual, state.iterations);
      return curve;
    }
    if (std::abs(state.rotation) > most) {
      curve.unusable_because = fmt::format(
          "at {:.6g} N*m the ring has turned by {:.4g} mm, more than half a tooth pitch: the "
          "flanks "
          "do not hold; the torque, the lobe gap of {:.4g} um or the gap factor is too large",
          torque, 1e3 * state.rotation, 1e6 * geometry.lobe_gap);
      return curve;
    }
    curve.points.push_back(point_of(drive, state, series));
  }
  return curve;
}

std::vector<RimState> rim_states(const GearSet& gear, double torque, int positions,
                                 const CoupledOptions& options) {
  const CoupledGeometry g = coupled_geometry(gear, options);
  require(positions > 0, "positions", positions, "1", "> 0");
  require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  std::vector<Note> notes;
  Assembly assembly = assemble(gear, g, notes, options);
  if (!assembly.fails_because.empty()) throw SolverError(assembly.fails_because);
  CoupledDrive& drive = assembly.drive;
  const Equilibrium state = drive.solve(torque, drive.assembled());
  if (!state.converged) throw SolverError("no equilibrium at this torque");
  const Eigen::VectorXd x = drive.coefficients_of(state.force);
  const double E_plate = g.rim_steel.plane_strain_modulus();
  const double shear = torque / (2 * pi * g.ring_radius * g.ring_radius * g.barrel_thickness);
  std::vector<RimState> states;
  for (int i = 0; i < positions; ++i) {
    const double theta = 2 * pi * i / positions;
    const double bending = E_plate * drive.curvature(x, theta);           // (TC-24), per distance
    const double membrane = g.rim_steel.E * drive.hoop_strain(x, theta);  // (TC-24)
    states.push_back({.position = theta,
                      .radial = drive.radial(x, theta),
                      .tangential = drive.tangential(x, theta) + state.rotation,
                      .rim_outside_stress = membrane + bending * g.rim_thickness / 2,
                      .rim_inside_stress = membrane - bending * g.rim_thickness / 2,
                      .barrel_bending_stress = bending * g.barrel_thickness / 2,
                      .barrel_shear_stress = shear});
  }
  return states;
}

double curve_uncertainty(const GearSet& gear) { return gear.drive.ratio < 50 ? 1.0 : 0.15; }

MakersTorques makers_torques(const GearSet& gear) {
  const double d3 = std::pow(gear.drive.pitch_diameter, 3);
  MakersTorques torques{.T1 = 0.0517e6 * d3, .T2 = 0.187e6 * d3, .by_convention = true};
  const Rating rating = gear.rating.value_or(Rating{});
  if (gear.rating) {
    torques.T1 = rating.T1;
    torques.T2 = rating.T2;
    torques.by_convention = false;
  }
  torques.T3 = rating.T3.value_or(1.6 * torques.T2);
  torques.rated = rating.rated_torque.value_or(1.8 * torques.T2);
  torques.lost_motion = rating.lost_motion_share * torques.rated;
  return torques;
}

MakersLines makers_lines(const GearSet& gear, int sense, const CoupledOptions& options) {
  const MakersTorques at = makers_torques(gear);
  const double s = sense < 0 ? -1.0 : 1.0;
  const std::array<double, 4> torques = {s * at.T1 / 3, s * at.T1, s * at.T2, s * at.T3};
  const TorsionCurve curve = torsion_curve(gear, torques, options);
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  const auto twist = [&](std::size_t i) { return s * curve.points[i].twist; };
  return {.K1 = at.T1 / twist(1),  // (TC-14)
          .K2 = (at.T2 - at.T1) / (twist(2) - twist(1)),
          .K3 = (at.T3 - at.T2) / (twist(3) - twist(2)),
          .phi1 = twist(1),
          .phi2 = twist(2)};
}

}  // namespace strainwave

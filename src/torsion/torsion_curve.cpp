// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/torsion_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "assembled_drive_contents.hpp"
#include "line_torques.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Sets the shares of the members in the tangent compliance: members of the contact problem and
/// members in series.
void set_shares(CurvePoint& point, const AssembledDrive::Contents& contents,
                const Equilibrium& state, const CoupledDrive::Tangent& tangent) {
  const SeriesMembers& series = contents.series;
  contents.drive.add_shares(state, tangent, point.share);
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

void add_contacts(CurvePoint& point, const CoupledDrive& drive, const Equilibrium& state,
                  const CoupledDrive::Tangent& tangent) {
  for (int i = 0; i < drive.contacts(); ++i) {
    const ContactForce contact{drive.position_of(i), state.force[i], tangent.force[i]};
    const bool touches = state.force[i] > 0;
    if (i < drive.balls()) {
      point.balls.push_back(contact);
      point.balls_in_contact += touches;
    } else if (touches) {
      const bool drives = i < drive.balls() + drive.tooth_count();
      (drives ? point.drive_flanks : point.coast_flanks).push_back(contact);
      // A tooth that touches on both flanks counts as one tooth.
      point.teeth_in_contact += drives || !(state.force[i - drive.tooth_count()] > 0);
    }
  }
}

CurvePoint point_of(const AssembledDrive::Contents& contents, const Equilibrium& state) {
  const CoupledDrive& drive = contents.drive;
  const SeriesMembers& series = contents.series;
  const double R = drive.geometry().ring_radius;
  CurvePoint point;
  point.torque = state.torque;
  point.ring_rotation = (state.rotation - drive.assembled().rotation) / R;
  const double in_series = series.sound() + series.cracks(state.torque);
  point.twist = contents.twist(state);
  point.residual = state.residual;
  point.iterations = state.iterations;
  const CoupledDrive::Tangent tangent = drive.tangent(state);
  point.tangent_compliance = tangent.rotation / R + in_series;  // (TC-15)
  if (std::isfinite(tangent.rotation)) set_shares(point, contents, state, tangent);
  add_contacts(point, drive, state, tangent);
  return point;
}

}  // namespace

namespace {

/// The closings of the last states of a curve, extrapolated to the next torque.
class Extrapolation {
 public:
  void add(const Equilibrium& state) {
    // Where a contact opens or touches, the closings bend.
    if (!last_.empty() && (!state.system || !last_.back().system ||
                           state.system->contact != last_.back().system->contact))
      last_.clear();
    last_.push_back({state.torque, state.closing, state.system});
    if (last_.size() > kStates) last_.erase(last_.begin());
  }
  /// Empty if too few states are known, or if the torque is far from theirs.
  [[nodiscard]] Eigen::VectorXd to(double torque) const {
    Eigen::VectorXd ahead;
    if (last_.size() < kStates) return ahead;
    const double reach = last_.back().torque - last_.front().torque;
    if (!(std::abs(torque - last_.back().torque) <= std::abs(reach))) return ahead;
    ahead = Eigen::VectorXd::Zero(last_.back().closing.size());
    for (const Known& at : last_) {
      double weight = 1.0;
      for (const Known& other : last_)
        if (&other != &at) weight *= (torque - other.torque) / (at.torque - other.torque);
      ahead += weight * at.closing;
    }
    return ahead;
  }

 private:
  static constexpr std::size_t kStates = 3;
  struct Known {
    double torque = 0.0;
    Eigen::VectorXd closing;
    std::shared_ptr<const ContactSystem> system;
  };
  std::vector<Known> last_;
};

}  // namespace

std::string walk(const AssembledDrive::Contents& contents, std::span<const double> torques,
                 const Progress& progress, const std::function<void(Equilibrium&)>& see) {
  const CoupledDrive& drive = contents.drive;
  const CoupledGeometry& g = contents.geometry;
  for (const double torque : torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  if (!contents.fails_because.empty()) return contents.fails_because;
  Equilibrium state = drive.assembled();
  Extrapolation extrapolation;
  // After half a pitch of free travel, the flanks of the next tooth would touch instead of those of
  // this tooth.
  const double most = pi * g.pitch_radius / g.teeth;
  for (std::size_t i = 0; i < torques.size(); ++i) {
    const double torque = torques[i];
    if (!drive.can_carry(torque))
      return fmt::format(
          "no tooth is left that can carry {:.6g} N*m; remove a crack of mesh.crack "
          "with a stiffness_loss of 1",
          torque);
    // At zero torque the ring rests in its assembled position, independently of the path.
    state = torque == 0 ? drive.assembled() : drive.solve(torque, state, extrapolation.to(torque));
    if (!state.converged)
      return fmt::format(
          "no equilibrium at {:.6g} N*m: residual {:.2g} of the largest contact force "
          "after {} steps",
          torque, state.residual, state.iterations);
    if (!(std::abs(state.rotation) <= most))
      return fmt::format(
          "at {:.6g} N*m the ring has turned by {:.4g} mm, more than half a tooth pitch, so the "
          "flanks do not hold; the torque, the lobe gap of {:.4g} um or the gap factor is too "
          "large",
          torque, 1e3 * state.rotation, 1e6 * g.lobe_gap);
    see(state);
    if (state.system) extrapolation.add(state);
    progress.at(static_cast<double>(i + 1) / static_cast<double>(torques.size()));
  }
  return contents.unusable_because;
}

TorsionCurve torsion_curve(const AssembledDrive& assembled, std::span<const double> torques,
                           const Progress& progress) {
  const AssembledDrive::Contents& contents = assembled.contents();
  TorsionCurve curve;
  curve.teeth = contents.geometry.teeth;
  curve.series_compliance = contents.series.sound();
  curve.notes = assembled.notes();
  curve.equations = assembled.equations();
  if (contents.fails_because.empty()) {
    const CoupledDrive& drive = contents.drive;
    curve.cam_amplitude = drive.cam_amplitude();
    curve.assembly_flank_force = drive.largest_flank_force(drive.assembled());
    for (int k = 0; k < drive.balls(); ++k)
      curve.assembly_ball_force = std::max(curve.assembly_ball_force, drive.assembled().force[k]);
  }
  curve.unusable_because = walk(contents, torques, progress, [&](Equilibrium& state) {
    state.system = contents.drive.system_of(state);  // for the tangent and for the next torque
    curve.points.push_back(point_of(contents, state));
  });
  return curve;
}

std::vector<double> twists(const AssembledDrive& assembled, std::span<const double> torques,
                           const Progress& progress) {
  const AssembledDrive::Contents& contents = assembled.contents();
  std::vector<double> twist;
  const std::string unusable_because =
      walk(contents, torques, progress,
           [&](const Equilibrium& state) { twist.push_back(contents.twist(state)); });
  if (!unusable_because.empty()) throw SolverError(unusable_because);
  return twist;
}

std::optional<double> reached_twist(const AssembledDrive& drive, double torque,
                                    std::vector<Note>& notes) {
  try {
    return twists(drive, std::span(&torque, 1)).front();
  } catch (const SolverError& error) {
    Note note{.code = "curve.no_wind_up",
              .text = fmt::format("the coupled drive does not reach the torque of the load: {}",
                                  error.what()),
              .path = "load.torque",
              .equation = "TC-11",
              .severity = Severity::care,
              .next_step = "Check load.torque against the maker's torques."};
    if (std::ranges::find(notes, note.code, &Note::code) == notes.end())
      notes.push_back(std::move(note));
    return std::nullopt;
  }
}

Equilibrium state_at(const AssembledDrive& assembled, double torque) {
  require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  const AssembledDrive::Contents& contents = assembled.contents();
  Equilibrium state;
  const std::string fails =
      walk(contents, {&torque, 1}, {}, [&](const Equilibrium& found) { state = found; });
  if (!fails.empty()) throw SolverError(fails);
  return state;
}

std::vector<RimState> rim_states(const AssembledDrive& assembled, double torque, int positions) {
  require(positions > 0, "positions", positions, "1", "> 0");
  const Equilibrium state = state_at(assembled, torque);
  const CoupledDrive& drive = assembled.contents().drive;
  const CoupledGeometry& g = assembled.contents().geometry;
  const Eigen::VectorXd x = drive.coefficients_of(state.force);
  const ElasticRings& rings = drive.rings();
  const double E_plate = g.rim_steel.plane_strain_modulus();
  const double shear = torque / (2 * pi * g.ring_radius * g.ring_radius * g.barrel_thickness);
  std::vector<RimState> states;
  for (int i = 0; i < positions; ++i) {
    const double theta = 2 * pi * i / positions;
    const double curvature = rings.curvature(x, theta);
    const double bending = E_plate * curvature;                           // (TC-24), per distance
    const double membrane = g.rim_steel.E * rings.hoop_strain(x, theta);  // (TC-24)
    std::optional<double> barrel;
    if (g.barrel_modulus) barrel = *g.barrel_modulus * curvature * g.barrel_thickness / 2;
    states.push_back({.position = theta,
                      .radial = rings.radial(x, theta),
                      .tangential = rings.tangential(x, theta) + state.rotation,
                      .rim_outside_stress = membrane + bending * g.rim_thickness / 2,
                      .rim_inside_stress = membrane - bending * g.rim_thickness / 2,
                      .barrel_bending_stress = barrel,
                      .barrel_shear_stress = shear});
  }
  return states;
}

double curve_uncertainty(const GearSet& gear) {
  // Values from the errors against catalogues (theory manual, chapter CV).
  constexpr double kLeastRegularRatio = 50;
  constexpr double kRegular = 0.15;
  constexpr double kAtLowRatio = 1.0;
  return gear.drive.ratio < kLeastRegularRatio ? kAtLowRatio : kRegular;
}

MakersTorques makers_torques(const GearSet& gear) {
  const auto [T1, T2, T3] = line_torques(gear, Lift<double>());
  const Rating rating = gear.rating.value_or(Rating{});
  const double rated = rating.rated_torque.value_or(kConventionRated * T2);
  return {.T1 = T1,
          .T2 = T2,
          .T3 = T3,
          .rated = rated,
          .lost_motion = rating.lost_motion_share * rated,
          .by_convention = !gear.rating};
}

MakersLines makers_lines(const AssembledDrive& drive, int sense) {
  const MakersTorques at = makers_torques(drive.gear());
  const double s = sense < 0 ? -1.0 : 1.0;
  const std::array<double, 4> torques = {s * at.T1 / 3, s * at.T1, s * at.T2, s * at.T3};
  const std::vector<double> solved = twists(drive, torques);
  const auto twist = [&](std::size_t i) { return s * solved[i]; };
  return {.K1 = at.T1 / twist(1),  // (TC-14)
          .K2 = (at.T2 - at.T1) / (twist(2) - twist(1)),
          .K3 = (at.T3 - at.T2) / (twist(3) - twist(2)),
          .phi1 = twist(1),
          .phi2 = twist(2),
          .phi3 = twist(3)};
}

}  // namespace strainwave

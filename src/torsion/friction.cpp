// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "assembled_drive_contents.hpp"
#include "contact_laws.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using Contents = AssembledDrive::Contents;

const Bearing& bearing_of(const Contents& contents) {
  return *contents.gear.wave_generator->bearing;
}

/// Sum of the ball forces times their slip in the bore.  Balls roll, so they do not hold the outer
/// ring; it turns until the friction on it is in balance, at the weighted median of the slip
/// (TC-33).
double slip_of_free_ring(const Eigen::VectorXd& slip, const Eigen::VectorXd& force) {
  std::vector<std::pair<double, double>> balls;  // slip, force
  for (Eigen::Index k = 0; k < slip.size(); ++k)
    if (force[k] > 0) balls.emplace_back(slip[k], force[k]);
  std::ranges::sort(balls);
  double half = 0.0;
  for (const auto& ball : balls) half += ball.second / 2;
  double rotation = 0.0;
  double below = 0.0;
  for (const auto& ball : balls) {
    rotation = ball.first;
    below += ball.second;
    if (below >= half) break;
  }
  double sum = 0.0;
  for (const auto& ball : balls) sum += ball.second * std::abs(ball.first - rotation);
  return sum;
}

/// Distance between the centre lines of rim and outer ring [m].
double ring_distance(const CoupledGeometry& g) { return (g.rim_thickness + g.outer_thickness) / 2; }

/// Slip of the bore against a ring that does not stretch, at each ball, except for a rotation of
/// the ring (TC-33) [m per unit of the coefficients].
Eigen::VectorXd outer_ring_slip(const CoupledDrive& drive, const Eigen::VectorXd& x) {
  const RingModel<double>& rings = drive.rings().model();
  const double bending = ring_distance(drive.geometry()) / rings.ring_radius();
  Eigen::VectorXd slip = Eigen::VectorXd::Zero(drive.balls());
  for (int n = 1; n <= rings.harmonics(); ++n) {
    const int i = rings.at(n);
    const double bent = bending * (n - 1.0 / n);
    const double even = x[i + 2] - x[i + 1] / n + bent * x[i + 1];
    const double odd = x[i + 3] + x[i] / n - bent * x[i];
    for (int k = 0; k < drive.balls(); ++k) {
      const double phase = n * drive.position_of(k);
      slip[k] += even * std::cos(phase) + odd * std::sin(phase);
    }
  }
  return slip;
}

/// Slip of the flanks per unit of coefficients and rotation, along the drive and the coast flank
/// toward the tip of the tooth of the flexspline (TC-33).
Eigen::VectorXd flank_slip(const CoupledDrive& drive, const Eigen::VectorXd& x, double rotation) {
  const RingModel<double>& rings = drive.rings().model();
  ElasticRings::Shares along(3, drive.contacts() - drive.balls());
  Eigen::VectorXd slip = Eigen::VectorXd::Zero(drive.contacts());
  for (int i = drive.balls(); i < drive.contacts(); ++i) {
    const FlankShares normal = drive.shares_of(i);
    const int side = drive.side_of(i);
    const double height = normal.higher / normal.along;
    const FlankShares shares{.outward = side * normal.along,
                             .along = -side * normal.outward,
                             .higher = -side * normal.outward * height};  // (TC-33)
    along.col(i - drive.balls()) << shares.outward, shares.along, shares.higher;
    slip[i] = rings.turn(shares) * rotation;
  }
  return slip + drive.rings().displacements_of(x, ContactDirection{}, along);
}

/// Tangent of the least angle of the flanks.
double least_slope(const CoupledDrive& drive) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = drive.balls(); i < drive.contacts(); ++i) {
    const FlankShares normal = drive.shares_of(i);
    least = std::min(least, normal.outward / std::abs(normal.along));
  }
  return least;
}

FrictionWidth width_at(const Contents& contents, const Equilibrium& state) {
  const CoupledDrive& drive = contents.drive;
  const CoupledDrive::Tangent tangent = drive.tangent(state);
  const Eigen::VectorXd x = drive.coefficients_of(tangent.force);
  const Eigen::VectorXd slip = flank_slip(drive, x, tangent.rotation);
  double flanks = 0.0;
  for (int i = drive.balls(); i < drive.contacts(); ++i)
    flanks += state.force[i] * std::abs(slip[i]);
  const double ring = slip_of_free_ring(outer_ring_slip(drive, x), state.force.head(drive.balls()));
  return {.flanks = 2 * contents.gear.mesh->friction_coefficient * flanks,  // (TC-16)
          .outer_ring = 2 * bearing_of(contents).outer_ring->friction_coefficient * ring};
}

void require_usable(const std::string& unusable_because) {
  if (!unusable_because.empty()) throw SolverError(unusable_because);
}

/// The width at zero torque.  Without pressed flanks the ring turns freely there, so the outer ring
/// takes its slip from small torques of both senses.
FrictionWidth width_at_rest(const Contents& contents) {
  constexpr double kSmall = 1e-3;  // share of T1; the width hardly changes down to 1e-5
  const CoupledDrive& drive = contents.drive;
  if (drive.largest_flank_force(drive.assembled()) > 0)
    return width_at(contents, drive.assembled());
  const double small = kSmall * makers_torques(contents.gear).T1;
  FrictionWidth width;
  for (const double torque : {small, -small})
    require_usable(walk(contents, std::array{torque}, {}, [&](const Equilibrium& state) {
      width.outer_ring += width_at(contents, state).outer_ring / 2;
    }));
  return width;
}

/// Losses of the contacts in a state of equilibrium, per angle of the input (TC-34).
RunningTorque losses(const Contents& contents, const Equilibrium& state) {
  const CoupledDrive& drive = contents.drive;
  const CoupledGeometry& g = drive.geometry();
  const Bearing& bearing = bearing_of(contents);
  const double turn = 1 + 1 / contents.gear.drive.ratio;  // of the rim against the wave (TC-28)
  const Eigen::VectorXd balls = state.force.head(drive.balls());
  const Eigen::VectorXd x = drive.coefficients_of(state.force);
  Eigen::VectorXd speed(drive.balls());
  for (int k = 0; k < drive.balls(); ++k)
    speed[k] =
        g.ring_radius * (drive.rings().hoop_strain(x, drive.position_of(k)) -
                         ring_distance(g) * drive.rings().curvature(x, drive.position_of(k)));
  double flanks = 0.0;
  for (int i = drive.balls(); i < drive.contacts(); ++i) {
    const double t = drive.side_of(i) * angle_from_lobe(drive.position_of(i));
    const double w0 = g.radial_displacement;
    const FlankShares normal = drive.shares_of(i);
    const double path = 2 * w0 * std::sin(2 * t) * std::abs(normal.along) +
                        (g.module - w0 * std::cos(2 * t)) * normal.outward;
    flanks += state.force[i] * std::abs(path);
  }
  const double pitch_radius = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 4;
  return {.balls = turn * bearing.rolling_friction * pitch_radius * balls.sum(),
          .outer_ring =
              turn * bearing.outer_ring->friction_coefficient * slip_of_free_ring(speed, balls),
          .flanks = turn * contents.gear.mesh->friction_coefficient * flanks};
}

double output_friction(const GearSet& gear) {
  return gear.rating ? gear.rating->friction_torque : 0.0;
}

}  // namespace

SlidingCurve sliding_curve(const AssembledDrive& drive, std::span<const double> torques,
                           const Progress& progress) {
  const Contents& contents = drive.contents();
  const ToothMesh& mesh = *contents.gear.mesh;
  require(mesh.friction_coefficient < least_slope(contents.drive), "mesh.friction_coefficient",
          mesh.friction_coefficient, "1",
          "less than the tangent of the angle of the flanks, because otherwise the flanks lock "
          "themselves");
  SlidingCurve curve;
  require_usable(walk(contents, torques, progress, [&](const Equilibrium& state) {
    curve.twist.push_back(contents.twist(state));
    curve.width.push_back(state.torque == 0 ? width_at_rest(contents) : width_at(contents, state));
  }));
  return curve;
}

RunningTorque running_torque(const AssembledDrive& drive, double torque) {
  RunningTorque running;
  require_usable(walk(drive.contents(), std::array{torque}, {}, [&](const Equilibrium& state) {
    running = losses(drive.contents(), state);
  }));
  return running;
}

RunningTorque no_load_torque(const AssembledDrive& drive) {
  const double at_output = output_friction(drive.gear());
  RunningTorque running = running_torque(drive, at_output);
  running.output = at_output / drive.gear().drive.ratio;
  return running;
}

std::optional<double> back_driving_torque(const AssembledDrive& drive) {
  constexpr int kMostSteps = 200;
  constexpr double kExact = 1e-11;
  const double most = makers_torques(drive.gear()).rated;
  const double friction = output_friction(drive.gear());
  double torque = friction;
  for (int step = 0; step < kMostSteps; ++step) {
    if (torque > most) return std::nullopt;
    // The flanks carry what the friction at the output leaves.
    const double driving =
        drive.gear().drive.ratio * running_torque(drive, torque - friction).total();
    const double next = friction + driving;
    if (std::abs(next - torque) <= kExact * next) return next;
    torque = next;
  }
  throw SolverError(
      "the back-driving torque did not settle in 200 steps; check the coefficients of friction");
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "tube_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

// Share of the clear distance that the turning may use.  The ends of the tube carry support and
// load, so they must stay plane with a margin.
constexpr double kTurnRoom = 0.97;

// The turning shears the cells by up to 15/8 |turn|/ln(r2/r1), where 15/8 is the steepest slope of
// `turned_share`.  With r2/r1 > 1 + 1.2 |turn| and a turn of at most 45 degrees that is 2.2 at
// most, and the scaled Jacobian determinant stays above 1/sqrt(1 + 2.2^2) = 0.41.
constexpr double kReachPerTurn = 1.2;

/// Share of the turn: 1 up to r1, 0 from r2 on, smooth in the logarithm of r.
double turned_share(double r, double r1, double r2) {
  if (r <= r1) return 1;
  if (r >= r2) return 0;
  const double s = std::log(r / r1) / std::log(r2 / r1);
  return 1 - s * s * s * (10 - 15 * s + 6 * s * s);
}

}  // namespace

void check_tube(double mean_radius, double wall_thickness, double length, double angle,
                double place) {
  require(mean_radius > 0 && std::isfinite(mean_radius), "mean_radius", mean_radius, "m",
          "mean_radius > 0");
  require(wall_thickness > 0 && wall_thickness <= 0.5 * mean_radius, "wall_thickness",
          wall_thickness, "m", "0 < wall_thickness <= 0.5 mean_radius");
  require(length > 0 && std::isfinite(length), "length", length, "m", "length > 0");
  require(angle > -pi / 2 && angle <= pi / 2 * (1 + 1e-12), "angle", angle, "rad",
          "-pi/2 < angle <= pi/2");
  require(place >= 0 && place < length, "place", place, "m", "0 <= place < length");
}

TubeBody tube_body(const TubePlan& plan) {
  const double middle = plan.mean_radius;
  const double R = middle + plan.surface;
  // The angle from +z toward -theta is 90 degrees + beta from the first axis of (R theta, z).
  const double direction = pi / 2 + plan.angle;
  const double quarter = std::floor(direction / (pi / 2) + 0.5 - 1e-9);
  const double turn = direction - quarter * pi / 2;
  const double below = plan.place;
  const double above = plan.length - plan.place;
  const double room = kTurnRoom * std::min({below, above, pi * R});
  const double r1 = plan.rigid_radius;
  const double r2 = std::min(room, plan.turn_reach * r1);
  const double least = 1 + kReachPerTurn * std::abs(turn);
  if (!(r2 > least * r1))
    throw InputError(
        "half_length",
        fmt::format(
            "the crack needs a clear distance of {:.4g} mm from its middle to either end of "
            "the tube and half-way round, but only {:.4g} mm is available",
            least * r1 / kTurnRoom / units::mm, room / kTurnRoom / units::mm));
  TubeBody body;
  body.plan = plan;
  body.map = [=](const fem::Point3& p) {
    const double rotation =
        quarter * pi / 2 + turn * turned_share(std::hypot(p[0], p[1]), r1, r2);  // (FE-29)
    const double x = std::cos(rotation) * p[0] - std::sin(rotation) * p[1];
    const double y = std::sin(rotation) * p[0] + std::cos(rotation) * p[1];
    const double theta = x / R;
    const double r = middle + p[2];
    return fem::Point3{r * std::cos(theta), r * std::sin(theta), plan.place + y};
  };
  const double round = pi * R;
  const double longest_round = pi * R / 5;
  const double longest_z = std::max(plan.length / 4, R / 4);
  const int q = static_cast<int>(quarter);  // 0: x round the tube, 1: along z, 2: round, reversed
  if (q == 1) {
    body.along = {-below, above};
    body.across = {-round, round};
    body.longest_along = longest_z;
    body.longest_across = longest_round;
  } else {
    body.along = {-round, round};
    body.across = q == 0 ? std::array{-below, above} : std::array{-above, below};
    body.longest_along = longest_round;
    body.longest_across = longest_z;
  }
  const double tiny = 1e-9 * plan.length;
  body.end_tag = [=, map = body.map](const fem::Point3& p) -> int {
    const double z = map(p)[2];
    if (std::abs(z) < tiny) return kTubeClamp;
    return std::abs(z - plan.length) < tiny ? kTubeLoad : 0;
  };
  return body;
}

double tube_polar_moment(double mean_radius, double wall_thickness) {
  const double outer = mean_radius + wall_thickness / 2;
  const double inner = mean_radius - wall_thickness / 2;
  return pi / 2 * (std::pow(outer, 4) - std::pow(inner, 4));
}

double release_by_work(const SizedRelease& given, const SizedRelease& smaller) {
  return (given.work - smaller.work) / (2 * kSizeStep) +
         (given.release - smaller.release) / 2;  // (FE-28)
}

fem::Traction end_torque(double mean_radius, double wall_thickness, double torque) {
  const double rate = torque / tube_polar_moment(mean_radius, wall_thickness);
  return {.tag = kTubeLoad, .value = [rate](const fem::Point3& p) {
            return fem::Point3{-rate * p[1], rate * p[0], 0};
          }};
}

fem::SolidProblem clamped_tube(const fem::Elasticity& material) {
  fem::SolidProblem problem;
  problem.material = material;
  problem.crack_tag = kTubeCrack;
  problem.supports.push_back({.tag = kTubeClamp, .directions = [](const fem::Point3&) {
                                return std::vector<fem::Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
                              }});
  return problem;
}

fem::SolidLoad tube_torsion(double mean_radius, double wall_thickness, double torque) {
  const double rate = torque / tube_polar_moment(mean_radius, wall_thickness);
  return {.tractions = {end_torque(mean_radius, wall_thickness, torque)},
          .stress_without_crack = [rate](const fem::Point3& p) {
            std::array<fem::Point3, 3> s{};
            s[0][2] = s[2][0] = -rate * p[1];
            s[1][2] = s[2][1] = rate * p[0];
            return s;
          }};
}

void judge(TubeCrackResult& result, bool derivative, bool overlap) {
  const fem::SolidResult& solid = result.solid;
  const auto refuse = [&](const std::string& why) {
    if (result.reason.empty()) result.reason = why;
  };
  // NaN counts as above every limit.
  const auto above = [](double value, double limit) { return !(std::abs(value) <= limit); };
  if (!std::isfinite(result.energy_release_rate) || !std::isfinite(result.added_compliance))
    refuse("the answer is not a number");
  if (overlap)
    refuse("closed: the faces of the crack pass through each other, K_I < 0; solve with contact");
  if (above(solid.equilibrium_residual, 1e-7))
    refuse(fmt::format("nodal forces out of equilibrium by {:.2g}", solid.equilibrium_residual));
  if (above(solid.energy_balance, 1e-7))
    refuse(fmt::format("work and strain energy differ by {:.2g}", solid.energy_balance));
  if (above(solid.contact_overlap, 1e-6)) refuse("the faces of the crack overlap");
  // Skip comparisons if no energy is released.
  const bool released = std::abs(result.energy_release_rate) > result.closed_release_rate;
  for (const fem::CrackFront& front : solid.fronts) {
    if (!released) break;
    if (above(front.ring_spread, 0.01))
      refuse(fmt::format("the energy release rate differs by {:.2g} between rings",
                         front.ring_spread));
    if (above(front.mode_energy_ratio - 1, 0.05))
      refuse(fmt::format("K carries {:.4g} of the energy release rate", front.mode_energy_ratio));
  }
  if (!derivative)
    refuse("not compared with another size of the crack");
  else if (released ? above(result.growth_check, 0.01)
                    : above(result.derivative_release_rate, result.closed_release_rate))
    refuse(fmt::format("dC/dA between two sizes differs from G by {:.2g}", result.growth_check));
  result.usable = result.reason.empty();
}

}  // namespace strainwave::gear_fem

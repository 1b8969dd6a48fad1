// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/crack_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/crack_response.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "tube_body.hpp"
#include "turn_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Largest difference of dC/dA, and of the G of the factors K, from G: a share of G, and a share of
/// the largest G of all torques.  The edge of the contact crosses the cells, which costs 2 % of G
/// (FE-55).
constexpr double kOfRelease = 0.03;
constexpr double kOfLargest = 0.003;

/// Places of the ring of the sound wall.
constexpr int kRingAngles = 72;
constexpr int kRingRadii = 5;

/// The stress of the sound cup in the coordinates of the solid, whose z counts from the lower end
/// of the barrel.
class SoundStress {
 public:
  SoundStress(const OvalCup& cup, double barrel_from) : cup_(cup), barrel_from_(barrel_from) {}

  [[nodiscard]] std::array<fem::Point3, 3> at(const fem::Point3& place, double from_lobe,
                                              double torque) {
    return turned(place, from_lobe, torque, &OvalCup::field);
  }
  [[nodiscard]] fem::Point3 displacement(const fem::Point3& place, double from_lobe,
                                         double torque) {
    const double theta = std::atan2(place[1], place[0]);
    const OvalField field =
        cup_.field(known(std::hypot(place[0], place[1]), place[2]), from_lobe + theta, torque);
    const auto& [radial, round, axial] = field.displacement;
    return {radial * std::cos(theta) - round * std::sin(theta),
            radial * std::sin(theta) + round * std::cos(theta), axial};
  }
  /// The same for small rotations of the oval.
  [[nodiscard]] std::array<fem::Point3, 3> small_at(const fem::Point3& place, double from_lobe,
                                                    double torque) {
    return turned(place, from_lobe, torque, &OvalCup::small_field);
  }

 private:
  template <class Field>
  [[nodiscard]] std::array<fem::Point3, 3> turned(const fem::Point3& place, double from_lobe,
                                                  double torque, Field of) {
    const double r = std::hypot(place[0], place[1]);
    const double theta = std::atan2(place[1], place[0]);
    const OvalField field = (cup_.*of)(known(r, place[2]), from_lobe + theta, torque);
    const auto& [rr, tt, zz, tz, rz, rt] = field.stress;
    const std::array<fem::Point3, 3> local{{{rr, rt, rz}, {rt, tt, tz}, {rz, tz, zz}}};
    const std::array<fem::Point3, 3> axes{
        {{std::cos(theta), std::sin(theta), 0}, {-std::sin(theta), std::cos(theta), 0}, {0, 0, 1}}};
    std::array<fem::Point3, 3> s{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l) s[i][j] += axes[k][i] * local[k][l] * axes[l][j];
    return s;
  }

  /// The waves at a place; solid elements ask for the same places for each angle, torque and side.
  const OvalPlace& known(double r, double z) {
    constexpr double kSame = 1e-10;  // [m]
    // The cells of the solid are no exact cylinders, so a place of its surface may lie outside.
    constexpr double kBeyond = 1e-4;
    const std::pair key{std::llround(r / kSame), std::llround(z / kSame)};
    const auto at = places_.find(key);
    if (at != places_.end()) return at->second;
    return places_.emplace(key, cup_.at(r, z + barrel_from_, kBeyond)).first->second;
  }

  const OvalCup& cup_;
  double barrel_from_;
  std::map<std::pair<long long, long long>, OvalPlace> places_;
};

fem::Point3 times(const std::array<fem::Point3, 3>& stress, const fem::Point3& normal) {
  fem::Point3 t{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) t[i] += stress[i][k] * normal[k];
  return t;
}

double dot(const fem::Point3& a, const fem::Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void check(const TurningCrack& turning) {
  if (!turning.ends.rim)
    throw InputError("flexspline.rim",
                     "must be given, because the wave generator presses on the bore of the rim");
  if (turning.torques.empty()) throw InputError("torques", "must have at least one torque");
  for (const double torque : turning.torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  require(turning.angles >= 8 && turning.angles <= 720, "angles", turning.angles, "1",
          ">= 8 and <= 720");
}

/// Reports the time of a step.
class Steps {
 public:
  explicit Steps(const TurningCrack& turning) : turning_(turning) {}
  void done(const std::string& step) {
    const auto now = std::chrono::steady_clock::now();
    if (turning_.done) turning_.done(step, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  const TurningCrack& turning_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The state of the largest release under each torque.
std::vector<fem::SolidLoad> checked_states(const CrackTurn& turn, SoundStress& sound) {
  std::vector<fem::SolidLoad> loads;
  for (const TorqueTurn& one : turn.torques)
    loads.push_back({.tractions = {},
                     .stress_without_crack =
                         [&sound, angle = one.checked_angle, torque = one.torque](
                             const fem::Point3& place) { return sound.at(place, angle, torque); },
                     .released = true});
  return loads;
}

/// A full solution under one torque, and what judges it.
struct FullSolution {
  const fem::SolidResult& solid;
  ProportionalRelease release;
  std::optional<SizedRelease> smaller;  ///< a smaller crack; absent without a comparison of sizes
  double largest;                       ///< largest mean G of all torques [J/m^2]
};

/// Fills in the checks of one torque, and returns the reason why they fail; empty if they agree.
std::string judge(TorqueTurn& turn, const FullSolution& full) {
  const fem::SolidResult& solid = full.solid;
  turn.checks = {.energy_balance = solid.energy_balance,
                 .equilibrium_residual = solid.equilibrium_residual,
                 .worst_jacobian = solid.worst_jacobian,
                 .unknowns = solid.dofs};
  const double G = full.release.mean();
  const auto above = [](double value, double limit) { return !(std::abs(value) <= limit); };
  const double limit = kOfRelease * G + kOfLargest * full.largest;
  if (G > kOfLargest * full.largest) {  // else nothing is released that could be compared
    turn.checks.ring_spread = 0.0;
    for (const fem::CrackFront& front : solid.fronts)
      turn.checks.ring_spread = std::max(*turn.checks.ring_spread, front.ring_spread);
    turn.checks.mode_check = full.release.of_K / full.release.rate - 1;
  }
  if (full.smaller) {
    const double derivative =
        release_by_work({solid.work, full.release.rate}, *full.smaller) / full.release.sweep;
    if (turn.checks.ring_spread) turn.checks.growth_check = derivative / G - 1;
    if (above(derivative - G, limit))
      return fmt::format("dC/dA between two sizes differs from G by {:.2g}", derivative / G - 1);
  }
  if (above(solid.equilibrium_residual, 1e-7))
    return fmt::format("nodal forces out of equilibrium by {:.2g}", solid.equilibrium_residual);
  if (above(solid.energy_balance, 1e-6))
    return fmt::format("work and strain energy differ by {:.2g}", solid.energy_balance);
  if (above(solid.contact_overlap, 1e-6)) return "the faces of the crack overlap";
  if (above(full.release.of_K / full.release.sweep - G, limit))
    return fmt::format("K carries {:.4g} of the energy release rate",
                       full.release.of_K / full.release.rate);
  return {};
}

/// The wall at the middle of a crack.
struct CrackWall {
  double mean_radius;  ///< [m]
  double thickness;    ///< [m]
  double place;        ///< z of the crack's middle [m]
  double angle;        ///< of the crack, from +z toward -theta [rad]
};

CrackWall wall_of(const TurningCrack& turning) {
  return std::visit(
      [](const auto& tube) {
        return CrackWall{tube.mean_radius, tube.wall_thickness,
                         tube.place > 0 ? tube.place : tube.length / 2, tube.angle};
      },
      turning.tube);
}

CrackPlane plane_of(const fem::CrackResponse& crack, const CrackWall& wall) {
  CrackPlane plane{.nodes = {},
                   .cells = {crack.cells().begin(), crack.cells().end()},
                   .half_wall = wall.thickness / 2};
  for (const fem::CrackNode& node : crack.nodes()) {
    const auto& [x, y, z] = node.place;
    const double round = wall.mean_radius * std::atan2(y, x);
    plane.nodes.push_back(
        {.along = (z - wall.place) * std::cos(wall.angle) - round * std::sin(wall.angle),
         .through = std::hypot(x, y) - wall.mean_radius});
  }
  return plane;
}

/// The places of the ring, and the displacement there, which no torque changes.
SoundRing ring_of(const CrackWall& wall, SoundStress& sound) {
  SoundRing ring;
  for (int i = 0; i < kRingRadii; ++i)
    ring.radii.push_back(wall.mean_radius +
                         wall.thickness * (static_cast<double>(i) / (kRingRadii - 1) - 0.5));
  for (int i = 0; i <= kRingAngles; ++i) {
    ring.angles.push_back(pi * i / kRingAngles);
    ring.outward.push_back(
        sound.displacement({wall.mean_radius, 0, wall.place}, ring.angles.back(), 0)[0]);
  }
  return ring;
}

/// Stress normal to the crack round the sound wall, as TorqueTurn::ring_stress.
std::vector<double> ring_stress(const SoundRing& ring, const CrackWall& wall, SoundStress& sound,
                                double torque) {
  const fem::Point3 normal{0, std::cos(wall.angle), std::sin(wall.angle)};
  std::vector<double> stress;
  for (const double angle : ring.angles)
    for (const double radius : ring.radii)
      stress.push_back(
          dot(times(sound.at({radius, 0, wall.place}, angle, torque), normal), normal));
  return stress;
}

/// Keeps what the faces do at an angle.
void keep_faces(TorqueTurn& turn, const fem::CrackState& state, double angle) {
  FacesAtAngle& faces = turn.faces.emplace_back();
  faces.opening = state.gap;
  faces.contact_share = state.contact_share;
  for (const double pressure : state.pressure) faces.touching.push_back(pressure > 0);
  for (const double opening : faces.opening)
    if (opening > turn.largest_opening) {
      turn.largest_opening = opening;
      turn.at_opening = angle;
    }
  turn.least_contact_share = std::min(turn.least_contact_share, state.contact_share);
  turn.largest_contact_share = std::max(turn.largest_contact_share, state.contact_share);
}

/// The stress that the crack sees at each of its nodes, times the normal [Pa].
std::vector<fem::Point3> tractions_at(const fem::CrackResponse& crack, SoundStress& sound,
                                      double angle, double torque) {
  std::vector<fem::Point3> tractions;
  for (const fem::CrackNode& node : crack.nodes())
    tractions.push_back(times(sound.at(node.place, angle, torque), node.normal));
  return tractions;
}

/// Solves each state in full, and hands over its fields.
void take_frames(const TurningCrack& turning, const fem::CrackResponse& crack, SoundStress& sound) {
  for (std::size_t t = 0; t < turning.torques.size(); ++t)
    for (int i = 0; i < turning.angles; ++i) {
      const double torque = turning.torques[t];
      const double angle = pi * i / turning.angles;
      const fem::SolidLoad load{.tractions = {},
                                .stress_without_crack =
                                    [&sound, angle, torque](const fem::Point3& place) {
                                      return sound.at(place, angle, torque);
                                    },
                                .released = true,
                                .displacement_without_crack =
                                    [&sound, angle, torque](const fem::Point3& place) {
                                      return sound.displacement(place, angle, torque);
                                    }};
      fem::SolidResult solid = std::move(crack.solve({&load, 1}).front());
      const fem::CrackState state = crack.state(tractions_at(crack, sound, angle, torque));
      std::size_t s = 0;
      for (fem::CrackFront& front : solid.fronts)
        for (fem::FrontStation& station : front.stations) {
          const fem::StationFactors& K = state.stations.at(s++);
          station.K_I = K.K_I;
          station.K_II = K.K_II;
          station.K_III = K.K_III;
        }
      turning.frame({.torque = t,
                     .number = static_cast<std::size_t>(i),
                     .angle = angle,
                     .fields = std::move(solid.fields),
                     .fronts = std::move(solid.fronts)});
    }
}

/// The turn under one torque, without its checks; `result` gets the largest stresses.
TorqueTurn turn_under(double torque, int angles, const fem::CrackResponse& crack,
                      const std::vector<LabelledStation>& labels, SoundStress& sound,
                      double poissons_ratio, CrackTurn& result) {
  TorqueTurn turn;
  turn.torque = torque;
  turn.least_contact_share = 1;
  for (const LabelledStation& place : labels)
    turn.stations.push_back(
        {.tip = place.tip, .station = place.label, .mode_I = {}, .factors = {}});
  double most = -1;
  for (int i = 0; i < angles; ++i) {
    const double angle = pi * i / angles;
    const std::vector<fem::Point3> tractions = tractions_at(crack, sound, angle, torque);
    for (std::size_t n = 0; n < tractions.size(); ++n) {
      const fem::CrackNode& node = crack.nodes()[n];
      const double across = dot(tractions[n], node.normal);
      const double small =
          dot(times(sound.small_at(node.place, angle, torque), node.normal), node.normal);
      result.largest_stress = std::max(result.largest_stress, std::abs(across));
      result.rotation_stress = std::max(result.rotation_stress, std::abs(across - small));
    }
    const fem::CrackState state = crack.state(tractions);
    keep_faces(turn, state, angle);
    double release = 0;  // up to a factor
    for (std::size_t s = 0; s < labels.size(); ++s) {
      const fem::StationFactors& K = state.stations[labels[s].number];
      turn.stations[s].factors.push_back(
          {.angle = angle, .K_I = K.K_I, .K_II = K.K_II, .K_III = K.K_III});
      release += K.K_I * K.K_I + K.K_II * K.K_II + K.K_III * K.K_III / (1 - poissons_ratio);
    }
    if (release > most) {
      most = release;
      turn.checked_angle = angle;
    }
  }
  for (StationTurn& station : turn.stations) {
    station.factors.push_back(station.factors.front());
    station.factors.back().angle = pi;
    station.mode_I = turn_range(station.factors);
  }
  return turn;
}

}  // namespace

CrackTurn turn_crack(const TurningCrack& turning) {
  check(turning);
  Steps steps(turning);
  const std::unique_ptr<TurnBody> body = turn_body(turning);
  const CupSection section = sound_cup(turning);
  const fem::Elasticity& steel = body->problem().material;
  const OvalCup cup(section, steel, turning.fit, {.large_rotations = turning.large_rotations});
  steps.done("sound cup");
  SoundStress sound(cup, section.diaphragm ? section.diaphragm->thickness : 0.0);
  // The factors of this body are freed before those of the smaller crack are made.
  fem::SolidProblem problem = body->problem();
  if (turning.frame) problem.fields = turning.fields;
  auto crack = std::make_unique<fem::CrackResponse>(body->mesh(1), problem);
  steps.done(fmt::format("crack, {} solutions", crack->solutions()));

  CrackTurn result;
  result.contact = cup.contact();
  result.second_order_stress = cup.second_order_stress();
  result.unknowns = crack->unknowns();
  result.states = turning.torques.size() * static_cast<std::size_t>(turning.angles);
  const CrackWall wall = wall_of(turning);
  result.plane = plane_of(*crack, wall);
  result.ring = ring_of(wall, sound);
  const std::vector<LabelledStation> labels = body->labels(crack->stations());
  for (const double torque : turning.torques) {
    result.torques.push_back(
        turn_under(torque, turning.angles, *crack, labels, sound, steel.poissons_ratio, result));
    result.torques.back().ring_stress = ring_stress(result.ring, wall, sound, torque);
  }
  double range = -1;
  for (const TorqueTurn& turn : result.torques)
    if (const StationTurn& station = *governing_station(turn.stations);
        station.mode_I.range > range) {
      range = station.mode_I.range;
      result.governing_tip = station.tip;
    }
  steps.done(fmt::format("{} states", result.states));

  const auto refuse = [&](const std::string& why) {
    if (result.reason.empty()) result.reason = why;
  };
  if (!(cup.equilibrium_residual() <= kOvalEquilibrium))
    refuse(fmt::format("the sound cup: nodal forces out of equilibrium by {:.2g}",
                       cup.equilibrium_residual()));
  const std::vector<fem::SolidLoad> states = checked_states(result, sound);
  const std::vector<fem::SolidResult> full = crack->solve(states);
  if (problem.fields.divisions > 0) {
    take_frames(turning, *crack, sound);
    steps.done(fmt::format("fields of {} states", result.states));
  }
  crack.reset();
  std::vector<fem::SolidResult> smaller;
  if (turning.check_growth)
    smaller = fem::solve_solid(body->mesh(1 - kSizeStep), body->problem(), states);
  steps.done("checks");
  double largest = 0;
  for (const fem::SolidResult& solid : full)
    largest = std::max(largest, body->release(solid, 1).mean());
  for (std::size_t n = 0; n < result.torques.size(); ++n) {
    TorqueTurn& turn = result.torques[n];
    FullSolution of{
        .solid = full[n], .release = body->release(full[n], 1), .smaller = {}, .largest = largest};
    if (turning.check_growth)
      of.smaller = {smaller[n].work, body->release(smaller[n], 1 - kSizeStep).rate};
    if (std::string why = judge(turn, of); !why.empty())
      refuse(fmt::format("torque {:.6g} N*m: {}", turn.torque, why));
  }
  if (!turning.check_growth) refuse("not compared with another size of the crack");
  result.usable = result.reason.empty();
  return result;
}

}  // namespace strainwave::gear_fem

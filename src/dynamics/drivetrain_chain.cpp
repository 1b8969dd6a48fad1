// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/drivetrain_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A chain while it is built: inertias may be 0, and springs may be rigid.
class Assembly {
 public:
  std::size_t add(std::string name, double inertia, double damping = 0.0) {
    made_.chain.inertias.push_back(
        {.name = std::move(name), .inertia = inertia, .damping_to_ground = damping});
    return made_.chain.inertias.size() - 1;
  }
  void join(ChainSpring spring, const DrivetrainChain::Parts& parts,
            std::initializer_list<std::pair<std::size_t, double>> twist) {
    spring.twist_of.assign(made_.chain.inertias.size(), 0.0);
    for (const auto& [at, factor] : twist) spring.twist_of[at] = factor;
    made_.chain.springs.push_back(std::move(spring));
    made_.parts.push_back(parts);
  }

  /// @param follows  inertias that turn as the output does while the input stands and nothing
  /// twists
  DrivetrainChain finished(std::size_t motor, std::size_t load,
                           std::initializer_list<std::size_t> follows) && {
    made_.motor = motor;
    made_.load = load;
    for (ChainSpring& spring : made_.chain.springs)
      spring.twist_of.resize(made_.chain.inertias.size());
    follows_.assign(made_.chain.inertias.size(), 0.0);
    for (const std::size_t at : follows) follows_[at] = 1.0;
    while (join_rigid() || join_massless()) {
    }
    place_error();
    return std::move(made_);
  }

 private:
  [[nodiscard]] bool inner(std::size_t at) const {
    return at != made_.motor && at != made_.load &&
           made_.chain.inertias[at].name != "wave generator";
  }

  void remove_inertia(std::size_t at) {
    const auto offset = static_cast<std::ptrdiff_t>(at);
    made_.chain.inertias.erase(made_.chain.inertias.begin() + offset);
    follows_.erase(follows_.begin() + offset);
    for (ChainSpring& spring : made_.chain.springs)
      spring.twist_of.erase(spring.twist_of.begin() + offset);
    if (made_.motor > at) --made_.motor;
    if (made_.load > at) --made_.load;
  }
  void remove_spring(std::size_t at) {
    const auto offset = static_cast<std::ptrdiff_t>(at);
    made_.chain.springs.erase(made_.chain.springs.begin() + offset);
    made_.parts.erase(made_.parts.begin() + offset);
  }

  /// Takes out one spring without compliance and the inner inertia that follows from the others.
  /// An inertia of 0 goes first: one that follows from two others would couple their accelerations.
  bool join_rigid() {
    auto& [inertias, springs] = made_.chain;
    for (std::size_t s = 0; s < springs.size(); ++s) {
      if (springs[s].compliance > 0) continue;
      const std::vector<double> rigid = springs[s].twist_of;
      std::size_t at = inertias.size();
      for (std::size_t n = 0; n < inertias.size(); ++n)
        if (rigid[n] != 0 && inner(n) && (at == inertias.size() || inertias[at].inertia > 0))
          at = n;
      if (at == inertias.size()) throw InputError("drive", "has no compliance");
      for (std::size_t n = 0; n < inertias.size(); ++n) {
        if (n == at) continue;
        const double of = -rigid[n] / rigid[at];
        inertias[n].inertia += of * of * inertias[at].inertia;
        for (ChainSpring& spring : springs) spring.twist_of[n] += of * spring.twist_of[at];
      }
      remove_spring(s);
      remove_inertia(at);
      return true;
    }
    return false;
  }

  /// Joins the two springs at one inner point without inertia.
  bool join_massless() {
    auto& [inertias, springs] = made_.chain;
    for (std::size_t at = 0; at < inertias.size(); ++at) {
      if (inertias[at].inertia > 0 || !inner(at)) continue;
      std::vector<std::size_t> both;
      for (std::size_t s = 0; s < springs.size(); ++s)
        if (springs[s].twist_of[at] != 0) both.push_back(s);
      ChainSpring& first = springs[both[0]];
      const ChainSpring& second = springs[both[1]];
      // The point bears no torque, so the torques of both springs have this ratio.
      const double ratio = first.twist_of[at] / second.twist_of[at];
      const double square = ratio * ratio;
      const double sum = first.compliance + square * second.compliance;
      auto& parts = made_.parts[both[0]];
      const auto& more = made_.parts[both[1]];
      const double own = first.compliance / sum;
      const double other = square * second.compliance / sum;
      parts = {.mesh = own * parts.mesh + other * more.mesh,
               .body = own * parts.body + other * more.body,
               .shaft = own * parts.shaft + other * more.shaft};
      // Springs of a drive have one time constant, damping times compliance.
      first.damping *= first.compliance / sum;
      first.compliance = sum;
      for (std::size_t n = 0; n < inertias.size(); ++n)
        first.twist_of[n] -= ratio * second.twist_of[n];
      first.name += " and " + second.name;
      remove_spring(both[1]);
      remove_inertia(at);
      return true;
    }
    return false;
  }

  /// The kinematic error turns the output while the input stands and no spring bears a torque, so
  /// it is minus what the output's turn twists in the spring (DY-12).
  void place_error() {
    const auto first_with = [&](double DrivetrainChain::Parts::*part) {
      for (std::size_t s = 0; s < made_.parts.size(); ++s)
        if (made_.parts[s].*part > 0) return s;
      return made_.parts.size();
    };
    std::size_t at = first_with(&DrivetrainChain::Parts::mesh);
    if (at == made_.parts.size()) at = first_with(&DrivetrainChain::Parts::body);
    if (at == made_.parts.size()) at = first_with(&DrivetrainChain::Parts::shaft);
    made_.error_spring = at;
    for (std::size_t n = 0; n < follows_.size(); ++n)
      made_.error_twist -= made_.chain.springs[at].twist_of[n] * follows_[n];  // (DY-12)
  }

  DrivetrainChain made_;
  std::vector<double> follows_;  ///< turn of each inertia per turn of the output, input held [-]
};

/// J of a tube about its axis [kg*m^2].
double tube_inertia(double density, double outer_diameter, double inner_diameter, double length) {
  return pi / 32 * density * length * (std::pow(outer_diameter, 4) - std::pow(inner_diameter, 4));
}

double tube_inertia(double density, const TubeSection& tube) {
  return tube_inertia(density, tube.outer_diameter, tube.outer_diameter - 2 * tube.wall_thickness,
                      tube.length);
}

/// J of a diaphragm by its profile [kg*m^2].
double diaphragm_inertia(double density, const Diaphragm& diaphragm) {
  std::vector<double> radii = {diaphragm.inner_diameter / 2};
  for (const DiaphragmStation& station : diaphragm.profile)
    if (station.radius > radii.back() && station.radius < diaphragm.outer_diameter / 2)
      radii.push_back(station.radius);
  radii.push_back(diaphragm.outer_diameter / 2);
  // Between stations the thickness is linear, so three points by Gauss are exact.
  const double node = std::sqrt(0.6);
  double sum = 0.0;
  for (std::size_t k = 1; k < radii.size(); ++k) {
    const double middle = (radii[k] + radii[k - 1]) / 2;
    const double half = (radii[k] - radii[k - 1]) / 2;
    for (const auto& [at, weight] :
         {std::pair{-node, 5.0 / 9}, std::pair{0.0, 8.0 / 9}, std::pair{node, 5.0 / 9}}) {
      const double r = middle + half * at;
      sum += half * weight * r * r * r * diaphragm_thickness(diaphragm, r);
    }
  }
  return 2 * pi * density * sum;
}

}  // namespace

GearInertias gear_inertias(const GearSet& gear) {
  // (DY-9)
  GearInertias own;
  if (gear.flexspline) {
    const Flexspline& of = *gear.flexspline;
    if (of.crack_free == CrackFree::sections) {
      // A section without a density has no inertia here; the caller notes it.
      const auto density = [&](const auto& section) {
        return density_of(gear, material_name(of, section)).value_or(0.0);
      };
      const double barrel = tube_inertia(density(*of.barrel), *of.barrel);
      own.rim = (of.rim ? tube_inertia(density(*of.rim), *of.rim) : 0.0) + barrel / 2;
      own.hub = barrel / 2;
      if (of.diaphragm) own.hub += diaphragm_inertia(density(*of.diaphragm), *of.diaphragm);
      if (of.boss) own.hub += tube_inertia(density(*of.boss), *of.boss);
    } else if (const auto density = density_of(gear, of.material)) {
      const double diameter = gear.drive.pitch_diameter;
      const double tube =
          tube_inertia(*density, diameter, diameter - 2 * *of.wall_thickness, *of.length);
      own.rim = tube / 2;
      own.hub = tube / 2;
    }
  }
  if (gear.circular_spline) {
    const CircularSpline& of = *gear.circular_spline;
    if (const std::optional<double> density =
            material_of(gear, of.material, "circular_spline.material").density)
      own.circular_spline = tube_inertia(*density, of.outer_diameter, of.inner_diameter, of.width);
  }
  if (gear.output_shaft) {
    const OutputShaft& of = *gear.output_shaft;
    if (const std::optional<double> density =
            material_of(gear, of.material, "output_shaft.material").density)
      own.shaft = tube_inertia(*density, of.outer_diameter, of.inner_diameter, of.length);
  }
  return own;
}

DrivetrainChain drivetrain_chain(const Drivetrain& drivetrain, double ratio,
                                 const DriveSprings& springs, const GearInertias& own) {
  require(ratio > 0 && std::isfinite(ratio), "ratio", ratio, "1", "> 0");
  for (const auto& [name, value] :
       {std::pair{"mesh", springs.mesh}, {"body", springs.body}, {"shaft", springs.shaft}})
    require(value >= 0 && std::isfinite(value), name, value, "rad/(N*m)", ">= 0");
  if (springs.mesh + springs.body + springs.shaft <= 0)
    throw InputError("drive", "has no compliance");
  // (DY-10)
  Assembly made;
  const double wave_generator = drivetrain.wave_generator_inertia.value_or(0.0);
  const std::size_t motor = made.add(
      "motor", drivetrain.motor_inertia + (drivetrain.coupling_stiffness ? 0.0 : wave_generator),
      drivetrain.motor_damping);
  std::size_t wave = motor;
  if (drivetrain.coupling_stiffness) {
    wave = made.add("wave generator", wave_generator);
    made.join(
        {.name = "coupling", .compliance = 1 / *drivetrain.coupling_stiffness, .twist_of = {}}, {},
        {{motor, 1.0}, {wave, -1.0}});
  }
  const bool circular_spline_fixed = drivetrain.fixed == FixedMember::circular_spline;
  const double step = flexspline_torque(arrangement_of(drivetrain.fixed), ratio);
  // The drive has one time constant, c times its compliance at the output.
  const double time =
      drivetrain.gear_damping * (step * step * (springs.mesh + springs.body) + springs.shaft);
  const auto spring = [&](std::string name, double compliance) {
    return ChainSpring{.name = std::move(name),
                       .compliance = compliance,
                       .damping = compliance > 0 ? time / compliance : 0.0,
                       .twist_of = {}};
  };
  const DrivetrainChain::Parts mesh{.mesh = 1.0};
  const DrivetrainChain::Parts body{.body = 1.0};
  const DrivetrainChain::Parts shaft{.shaft = 1.0};
  // A mesh without compliance makes the rim of a fixed flexspline follow two parts, so its inertia
  // is left out (DY-10).
  const bool follows_two = springs.mesh <= 0 && !circular_spline_fixed;
  const std::size_t rim = made.add("rim", follows_two ? 0.0 : own.rim);
  const std::size_t output =
      made.add(circular_spline_fixed ? "hub" : "circular spline",
               (circular_spline_fixed ? own.hub : own.circular_spline) + own.shaft / 2);
  const std::size_t load =
      made.add("load", drivetrain.load_inertia + own.shaft / 2, drivetrain.load_damping);
  if (circular_spline_fixed) {
    made.join(spring("mesh", springs.mesh), mesh, {{wave, 1 / ratio}, {rim, 1.0}});
    made.join(spring("body", springs.body), body, {{rim, 1.0}, {output, -1.0}});
  } else {
    made.join(spring("mesh", springs.mesh), mesh,
              {{wave, 1 / ratio}, {rim, 1.0}, {output, 1 / step}});
    made.join(spring("body", springs.body), body, {{rim, 1.0}});
  }
  made.join(spring("shaft", springs.shaft), shaft, {{output, 1.0}, {load, -1.0}});
  // The rim of a flexspline that is fixed stands.
  if (circular_spline_fixed) return std::move(made).finished(motor, load, {rim, output, load});
  return std::move(made).finished(motor, load, {output, load});
}

}  // namespace strainwave

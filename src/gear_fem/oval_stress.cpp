// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/oval_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Components of OvalField::stress.
enum Component : std::size_t { kRadial, kHoop, kAxial, kHoopAxial, kRadialAxial, kRadialHoop };

/// A place of a face of the wall.
struct FacePlace {
  WallPart part;
  double at;  ///< as OvalStation::at [m]
  bool outer;
  double r;
  double z;
};

/// Walls between the ends of a part and the first place: the stress of a sharp corner has no limit.
constexpr double kClearWalls = 2;
/// Share by which a place lies inside of its face.
constexpr double kInside = 1e-4;

/// Adds the places of both faces of a part.
/// @param wall  thickness of the wall at a place
template <class Wall, class Place>
void add_part(std::vector<FacePlace>& places, WallPart part, double from, double to,
              const Wall& wall, const Place& place) {
  from += kClearWalls * wall(from);
  to -= kClearWalls * wall(to);
  if (!(to > from))
    throw InputError(fmt::format("flexspline.{}", enum_name(part)),
                     "must be longer than four walls for the stress of the oval");
  for (int i = 0; i < kOvalPlaces; ++i) {
    const double at = from + (to - from) * i / (kOvalPlaces - 1);
    for (const bool outer : {false, true}) {
      const auto [r, z] = place(at, outer ? 1 - kInside : kInside);
      places.push_back({.part = part, .at = at, .outer = outer, .r = r, .z = z});
    }
  }
}

/// All places at which the stress is stated, from the bore of the diaphragm to the rim's end.
std::vector<FacePlace> places_of(const CupSection& cup) {
  std::vector<FacePlace> places;
  const double foot = cup.diaphragm ? cup.diaphragm->thickness : 0.0;
  const double radius = (cup.barrel.outer_diameter - cup.barrel.wall_thickness) / 2;
  if (cup.diaphragm) {
    const Diaphragm& plate = *cup.diaphragm;
    const auto wall = [&](double at) { return diaphragm_thickness(plate, at); };
    // The outer face is flat, at z = 0.
    add_part(places, WallPart::diaphragm, plate.inner_diameter / 2, radius, wall,
             [&](double at, double outward) {
               return std::array{at, (1 - outward) * wall(at)};
             });
  }
  const auto add_tube = [&](WallPart part, const TubeSection& tube, double from) {
    const double t = tube.wall_thickness;
    add_part(
        places, part, from, from + tube.length, [t](double) { return t; },
        [&, t](double at, double outward) {
          return std::array{tube.outer_diameter / 2 - (1 - outward) * t, foot + at};
        });
  };
  add_tube(WallPart::barrel, cup.barrel, 0);
  add_tube(WallPart::rim, *cup.rim, cup.barrel.length);
  return places;
}

OvalStation over_turn(const OvalCup& cup, const FacePlace& face, const OvalPlace& place,
                      double torque) {
  OvalStation station{.part = face.part,
                      .at = face.at,
                      .face = face.outer ? "outer" : "inner",
                      .hoop = {},
                      .meridional = {},
                      .shear = {},
                      .equivalent = {}};
  const bool flat = face.part == WallPart::diaphragm;
  for (int i = 0; i < kOvalAngles; ++i) {
    const double angle = pi * i / kOvalAngles;
    const std::array<double, 6> s = cup.field(place, angle, torque).stress;
    station.hoop.take(s[kHoop], angle, i == 0);
    station.meridional.take(s[flat ? kRadial : kAxial], angle, i == 0);
    station.shear.take(s[flat ? kRadialHoop : kHoopAxial], angle, i == 0);
    station.equivalent.take(von_mises(s), angle, i == 0);
  }
  return station;
}

/// Largest difference of a stress component, and the largest component.
struct Compared {
  double difference = 0;
  double largest = 0;

  void take(const std::array<double, 6>& a, const std::array<double, 6>& b) {
    for (std::size_t c = 0; c < a.size(); ++c) {
      difference = std::max(difference, std::abs(a[c] - b[c]));
      largest = std::max(largest, std::abs(a[c]));
    }
  }
};
constexpr int kComparedAngles = 24;

double coning_angle(const OvalCup& cup, const CupSection& section) {
  const TubeSection& rim = *section.rim;
  const double foot = section.diaphragm ? section.diaphragm->thickness : 0.0;
  const double middle = foot + section.barrel.length + rim.length / 2;
  const double r = rim.outer_diameter / 2 - rim.wall_thickness / 2;
  const auto outward = [&](double z) { return cup.field(cup.at(r, z), 0, 0).displacement[0]; };
  const double reach = rim.length / 10;
  return (outward(middle + reach) - outward(middle - reach)) / (2 * reach);
}

}  // namespace

OvalStress oval_stress(const CupSection& cup, const fem::Elasticity& steel, const CamFit& fit,
                       const std::vector<double>& torques, const OvalOptions& options) {
  if (!cup.rim) throw InputError("flexspline.rim", "must be given for the oval");
  const std::vector<FacePlace> faces = places_of(cup);
  OvalOptions higher = options;
  higher.fine_corners = true;
  const OvalCup oval(cup, steel, fit, higher);
  OvalOptions lower = higher;
  --lower.order;
  const OvalCup coarse(cup, steel, fit, lower);
  OvalStress result;
  result.contact = oval.contact();
  result.large_rotations = result.contact.large_rotations;
  result.coning_angle = coning_angle(oval, cup);
  result.unknowns = oval.unknowns();
  result.equilibrium_residual = oval.equilibrium_residual();
  for (const double torque : torques)
    result.torques.push_back(LoadedOval{.torque = torque, .stations = {}});
  Compared orders;
  Compared rotations;
  for (const FacePlace& face : faces) {
    const OvalPlace place = oval.at(face.r, face.z);
    const OvalPlace below = coarse.at(face.r, face.z);
    for (LoadedOval& loaded : result.torques)
      loaded.stations.push_back(over_turn(oval, face, place, loaded.torque));
    for (int i = 0; i < kComparedAngles; ++i) {
      const double angle = pi * i / kComparedAngles;
      for (const double torque : torques)
        orders.take(oval.field(place, angle, torque).stress,
                    coarse.field(below, angle, torque).stress);
      if (result.large_rotations)
        rotations.take(oval.field(place, angle, 0).stress,
                       oval.small_field(place, angle, 0).stress);
    }
  }
  result.rotation_stress = rotations.difference;
  result.order_difference = orders.difference / orders.largest;
  if (!(result.equilibrium_residual <= kOvalEquilibrium))
    result.reason = fmt::format("nodal forces are out of equilibrium by {:.2g}, more than {:g}",
                                result.equilibrium_residual, kOvalEquilibrium);
  else if (!(result.order_difference <= kStressTolerance))
    result.reason = fmt::format(
        "a stress changes by {:.2g} of the largest from order p-1 to p, more than {:g}; give a "
        "higher order",
        result.order_difference, kStressTolerance);
  result.usable = result.reason.empty();
  return result;
}

}  // namespace strainwave::gear_fem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/quadrature.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/tube/tube_surface.hpp"

namespace strainwave::sif {

/// Axial crack of even depth along a whole tube or ring, loads [pressure, hoop stress, wall
/// bending].
///
/// Implements theory manual eq. (SU-11): the strip (FR-11) under the wall's stress, assumed linear
/// over the depth, and the force and moment with which the rest of the ring, a curved beam, resists
/// the opening.  Plane strain is assumed. The curvature of the wall at the crack is neglected.
template <Face face>
struct TubeEdgeAxial {
  static constexpr SolutionInfo kInfo{
      .name = face == Face::inner ? "tube-edge-axial-inner" : "tube-edge-axial-outer",
      .family = "tube",
      .title = face == Face::inner ? "Axial crack all along the inner face of a tube"
                                   : "Axial crack all along the outer face of a tube",
      .modes = "I",
      .equation = "SU-11",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.01,
      .accuracy = "plane-strain finite elements of rings, r/t 5 to 20, a/t 0.2 to 0.6: 0.7 %",
      .constraint = Constraint::plane_strain,
      .reference_stress =
          "hoop stress of the pressure, as the mean over the wall; for the stress loads, the load "
          "itself"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"pressure", "Pa",
               face == Face::inner ? "pressure inside the tube, also on the crack's faces"
                                   : "pressure inside the tube"},
      LoadInfo{"hoop_stress", "Pa", "hoop stress, uniform over the wall of the uncracked ring"},
      LoadInfo{"wall_bending", "Pa",
               "bending stress of the uncracked ring at the cracked face, from given forces"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"front", 0.0}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double mean_radius = 0.0;  ///< r [m]; > thickness/2
  double thickness = 0.0;    ///< t [m]; > 0
  double length = 0.0;       ///< length of the front along the axis [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "a", .range = kPositive, .example = "0.4 mm"},
          &TubeEdgeAxial::depth);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeEdgeAxial::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeEdgeAxial::thickness);
    field(Field{.name = "length",
                .unit = "m",
                .doc = "length of tube, crack and front along the axis",
                .range = kPositive,
                .example = "40 mm"},
          &TubeEdgeAxial::length);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(thickness < 2 * mean_radius, "thickness", thickness, "m", "thickness < 2 mean_radius");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.7 * thickness, "a/t <= 0.7");
    limit(mean_radius >= 5 * thickness, "r >= 5 t");
    limit(length >= 5 * thickness, "length >= 5 t, plane strain");
  }
  /// The wall of the tube.
  [[nodiscard]] TubeWall wall() const {
    return {.mean_radius = mean_radius, .thickness = thickness};
  }
  /// For the pressure, the mean over the wall, r_i/t.
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return load == 0 ? wall().inner() / thickness : 1.0;
  }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return length; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double alpha = a / thickness;
    const double tension = edge_crack_factor(StripLoading::tension, alpha);
    const double bending = edge_crack_factor(StripLoading::bending, alpha);
    const Flexibility crack = flexibility(alpha);
    const double root = std::sqrt(std::numbers::pi * a);
    UnitStressIntensity<kLoads> k;
    for (std::size_t i = 0; i < kLoads; ++i) {
      const WallStress stress = relieved(wall_stress(i, a), crack);
      k.I[i] = (stress.tension * tension + stress.bending * bending) * root;  // (SU-11)
    }
    return k;
  }

 private:
  /// Added flexibility of the strip under tension and bending stress, times E'/t [-].
  struct Flexibility {
    double tt, tb, bb;
  };
  [[nodiscard]] static Flexibility flexibility(double alpha) {
    const auto integral = [&](StripLoading one, StripLoading other) {
      return 2 * std::numbers::pi *
             integrate(
                 [&](double x) {
                   return x * edge_crack_factor(one, x) * edge_crack_factor(other, x);
                 },
                 0.0, alpha)
                 .value;  // (SU-11)
    };
    return {.tt = integral(StripLoading::tension, StripLoading::tension),
            .tb = integral(StripLoading::tension, StripLoading::bending),
            .bb = integral(StripLoading::bending, StripLoading::bending)};
  }
  [[nodiscard]] WallStress wall_stress(std::size_t load, double a) const {
    if (load == 1) return {.tension = 1.0, .bending = 0.0};
    if (load == 2) return {.tension = 0.0, .bending = 1.0};
    WallStress hoop =
        WallStress::line(lame_hoop_stress(wall(), wall().radius(face, 0.0)),
                         lame_hoop_stress(wall(), wall().radius(face, a)), a, thickness);
    if (face == Face::inner) hoop.tension += 1;  // on the faces (SU-7)
    return hoop;
  }
  /// The stress that remains when the ring resists the opening.
  [[nodiscard]] WallStress relieved(const WallStress& stress, const Flexibility& crack) const {
    const double rho = mean_radius / thickness;
    const double pi = std::numbers::pi;
    const double side = face == Face::inner ? -1.0 : 1.0;
    // (crack + ring) x = -crack stress
    const double tt = crack.tt + 36 * pi * rho * rho * rho;  // (SU-11)
    const double tb = crack.tb + side * 4 * pi * rho * rho;  // (SU-11)
    const double bb = crack.bb + 2 * pi / 3 * rho;           // (SU-11)
    const double opening = crack.tt * stress.tension + crack.tb * stress.bending;
    const double rotation = crack.tb * stress.tension + crack.bb * stress.bending;
    const double determinant = tt * bb - tb * tb;
    return {.tension = stress.tension - (bb * opening - tb * rotation) / determinant,
            .bending = stress.bending - (tt * rotation - tb * opening) / determinant};
  }
};

using TubeEdgeAxialInner = TubeEdgeAxial<Face::inner>;
using TubeEdgeAxialOuter = TubeEdgeAxial<Face::outer>;

}  // namespace strainwave::sif

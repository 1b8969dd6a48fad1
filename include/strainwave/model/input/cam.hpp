// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// The cam of a wave generator, as the input file describes it.

namespace strainwave {

/// Shape of a cam with two lobes, as the bore of the flexspline sees it through the bearing.
enum class CamProfile {
  cosine,     ///< the radius is a cosine
  ellipse,    ///< the cosine with c_cam = 1.5
  two_arcs,   ///< an arc at each lobe, and an arc between the lobes that continues it smoothly
  two_discs,  ///< a disc at each lobe; nothing between the discs
  points      ///< given at several angles
};
template <>
struct EnumNames<CamProfile> {
  static constexpr std::array<std::string_view, 5> names = {"cosine", "ellipse", "two_arcs",
                                                            "two_discs", "points"};
};

/// A point of a cam between a lobe and the middle between the lobes.
struct CamPoint {
  double angle = 0;   ///< from the lobe [rad]; 0 to pi/2
  double height = 0;  ///< of the cam outside the round bore, without clearance [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle from a lobe, rising from 0 to 90 deg",
                .range = {.lower = 0,
                          .lower_open = false,
                          .upper = std::numbers::pi / 2,
                          .upper_open = false},
                .example = R"("0 deg")"},
          &CamPoint::angle);
    field(Field{.name = "height",
                .unit = "m",
                .doc = "height of the cam outside the round bore, without clearance; < 0 inside",
                .example = R"("0.3 mm")"},
          &CamPoint::height);
  }
};

/// Profile of a cam, with the numbers that it needs.
struct Cam {
  CamProfile profile = CamProfile::cosine;
  /// gamma of two_arcs: half the angle of the arc at a lobe [rad]; 5 to 85 deg
  std::optional<double> arc_angle;
  /// e of two_discs: distance of a disc's centre from the axis [m]
  std::optional<double> disc_offset;
  std::vector<CamPoint> point;  ///< of points; 5 or more, the first at 0, the last at pi/2

  template <class Visitor>
  static void describe(Visitor&& field) {
    constexpr double kDegree = std::numbers::pi / 180;
    field(Field{.name = "profile",
                .unit = "",
                .doc = "shape as the flexspline's bore sees it; K over a turn knows all, the "
                       "coupled drive knows cosine and ellipse",
                .example = R"("ellipse")"},
          &Cam::profile);
    field(Field{.name = "arc_angle",
                .unit = "rad",
                .doc = "half the angle of the arc at a lobe, about the arc's centre; of two_arcs",
                .range = {.lower = 5 * kDegree,
                          .lower_open = false,
                          .upper = 85 * kDegree,
                          .upper_open = false},
                .example = R"("30 deg")",
                .in_template = InTemplate::commented},
          &Cam::arc_angle);
    field(Field{.name = "disc_offset",
                .unit = "m",
                .doc = "distance of a disc's centre from the axis; of two_discs",
                .range = kPositive,
                .example = R"("1.2 mm")",
                .in_template = InTemplate::commented},
          &Cam::disc_offset);
    field(Field{.name = "point",
                .unit = "",
                .doc = "points of the cam from a lobe, where the height is radial_displacement "
                       "within 10 %, to the middle, 90 deg; of points",
                .in_template = InTemplate::commented},
          &Cam::point);
  }
};

}  // namespace strainwave

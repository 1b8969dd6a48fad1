// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/cam_curve.hpp"

#include <fmt/format.h>
#include <math.h>  // NOLINT(modernize-deprecated-headers): pchip.hpp of Boost 1.74 calls ::isnan

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A circle about a point near the axis, seen from the axis.
struct Circle {
  double radius{};  ///< [m]
  double offset{};  ///< distance of its centre from the axis, in the direction alpha = 0 [m]
  bool exact{};     ///< false: for a small offset

  [[nodiscard]] double across(double alpha) const {
    const double side = offset * std::sin(alpha);
    return exact ? std::sqrt(radius * radius - side * side) : radius;
  }
  [[nodiscard]] double distance(double alpha) const {
    return offset * std::cos(alpha) + across(alpha);
  }
  [[nodiscard]] double slope(double alpha) const {
    const double turned = -offset * std::sin(alpha);
    return exact ? turned * (1 + offset * std::cos(alpha) / across(alpha)) : turned;
  }
};

/// Offset e of the arc at a lobe, for the semi-axes R_1 + e and R_1 + e (sec gamma - tan gamma).
double arc_offset(const TwoArcs& arcs, double radial_displacement) {
  return 2 * radial_displacement / (1 + std::tan(arcs.arc_angle) - 1 / std::cos(arcs.arc_angle));
}

/// Radius R_1 of the arc at a lobe: a quarter of the perimeter is R_1 pi/2 + (R_2 - R_1)(pi/2 -
/// gamma), with R_2 - R_1 = e sec gamma.
double arc_radius(const TwoArcs& arcs, double offset, double perimeter) {
  const double between = offset / std::cos(arcs.arc_angle) * (pi / 2 - arcs.arc_angle);
  return (perimeter / 4 - between) / (pi / 2);
}

/// What a shape follows from besides its own numbers.
struct Frame {
  double w_0;
  double bore;
  double middle;
  double perimeter;
  bool exact;
};

/// Height outside the bore, and slope, over the angle from the nearest lobe, 0 to pi/2.
struct Outline {
  std::function<double(double)> height;
  std::function<double(double)> slope;
};

/// Without its mean.
Outline outline_of(const FlattenedCosine& cosine, const Frame& in) {
  const double two = in.w_0;
  const double four = cosine.flattening * in.w_0 * in.w_0 / (2 * in.middle);
  return {[=](double angle) { return two * std::cos(2 * angle) + four * std::cos(4 * angle); },
          [=](double angle) {
            return -2 * two * std::sin(2 * angle) - 4 * four * std::sin(4 * angle);
          }};
}
Outline outline_of(const TwoArcs& arcs, const Frame& in) {
  const double gamma = arcs.arc_angle;
  const double e = arc_offset(arcs, in.w_0);
  const Circle lobe{arc_radius(arcs, e, in.perimeter), e, in.exact};
  const Circle side{lobe.radius + e / std::cos(gamma), -e * std::tan(gamma), in.exact};
  const double meet =
      in.exact ? std::atan2(lobe.radius * std::sin(gamma), e + lobe.radius * std::cos(gamma))
               : gamma;
  const double bore = in.bore;
  return {
      [=](double angle) {
        return (angle < meet ? lobe.distance(angle) : side.distance(angle - pi / 2)) - bore;
      },
      [=](double angle) { return angle < meet ? lobe.slope(angle) : side.slope(angle - pi / 2); }};
}
Outline outline_of(const TwoDiscs& discs, const Frame& in) {
  const Circle disc{in.bore + in.w_0 - discs.offset, discs.offset, in.exact};
  const double bore = in.bore;
  return {[=](double angle) { return disc.distance(angle) - bore; },
          [=](double angle) { return disc.slope(angle); }};
}
Outline outline_of(const CamPoints& points, const Frame& /*in*/) {
  std::vector<double> angles;
  std::vector<double> heights;
  for (const CamPoint& point : points) {
    angles.push_back(point.angle);
    heights.push_back(point.height);
  }
  angles.back() = pi / 2;
  const boost::math::interpolators::pchip curve(std::move(angles), std::move(heights), 0.0, 0.0);
  return {[=](double angle) { return curve(std::min(angle, pi / 2)); },
          [=](double angle) { return curve.prime(std::min(angle, pi / 2)); }};
}

}  // namespace

bool follows_perimeter(const CamShape& shape) {
  return std::holds_alternative<FlattenedCosine>(shape) || std::holds_alternative<TwoArcs>(shape);
}

CamCurve::CamCurve(const CamFit& fit, double bore, double middle, bool exact) : bore_(bore) {
  const Frame frame{.w_0 = fit.radial_displacement,
                    .bore = bore,
                    .middle = middle,
                    .perimeter = 2 * pi * bore + fit.perimeter_excess,
                    .exact = exact};
  Outline outline =
      std::visit([&](const auto& shape) { return outline_of(shape, frame); }, fit.shape);
  height_ = std::move(outline.height);
  slope_ = std::move(outline.slope);
  if (std::holds_alternative<FlattenedCosine>(fit.shape)) {
    mean_ = fit.perimeter_excess / (2 * pi);
    // A uniform offset changes the length of a curve by 2 pi times the offset, up to terms of
    // higher order, which two more steps remove.
    if (exact)
      for (int step = 0; step < 3; ++step) mean_ += (frame.perimeter - length()) / (2 * pi);
  }
  mean_ -= fit.clearance;
}

double CamCurve::length() const {
  constexpr int kPoints = 256;  // exact for a smooth periodic curve
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * pi * i / kPoints;
    sum += std::hypot(bore_ + at(angle), slope(angle)) * 2 * pi / kPoints;
  }
  return sum;
}

double CamCurve::at(double angle) const {
  return mean_ + height_(std::abs(std::remainder(angle, pi)));
}

double CamCurve::slope(double angle) const {
  const double turned = std::remainder(angle, pi);
  return std::copysign(1.0, turned) * slope_(std::abs(turned));
}

double CamCurve::farthest() const {
  double most = at(0);
  for (int i = 1; i <= 90; ++i) most = std::max(most, at(pi / 2 * i / 90));
  return most;
}

double CamCurve::band_excess() const {
  // The length of a band is the integral of its support function over the direction.
  constexpr int kDirections = 90;
  double sum = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double direction = pi / 2 * (i + 0.5) / kDirections;
    double farthest = 0;
    for (int j = -kDirections; j <= 2 * kDirections; ++j) {
      const double angle = pi / 2 * j / kDirections;
      farthest = std::max(farthest, (bore_ + at(angle)) * std::cos(angle - direction));
    }
    sum += farthest - bore_;
  }
  return 4 * sum * pi / 2 / kDirections;
}

CamGap::CamGap(const CamCurve& cam, double angle, double u_r, double u_theta) {
  const double x = cam.bore() + u_r;
  const double distance = std::hypot(x, u_theta);
  const double now = angle + std::atan2(u_theta, x);
  const double slope = cam.slope(now);
  value = distance - cam.bore() - cam.at(now);
  by_r = x / distance + slope * u_theta / (distance * distance);
  by_theta = u_theta / distance - slope * x / (distance * distance);
}

CamShape cam_shape(const WaveGenerator& generator) {
  if (const std::optional<double> flattening = cam_flattening(generator))
    return FlattenedCosine{*flattening};
  const Cam& cam = *generator.cam;
  if (cam.profile == CamProfile::two_arcs) return TwoArcs{*cam.arc_angle};
  if (cam.profile == CamProfile::two_discs) return TwoDiscs{*cam.disc_offset};
  return cam.point;
}

namespace {

void check_shape(const FlattenedCosine& cosine, double /*w_0*/, double /*bore*/,
                 const FieldPath& /*path*/) {
  require(cosine.flattening >= 0 && std::isfinite(cosine.flattening), "cam_flattening",
          cosine.flattening, "1", ">= 0");
}

void check_shape(const TwoArcs& arcs, double w_0, double bore, const FieldPath& path) {
  const std::string field = (path / "arc_angle").text();
  const double angle = arcs.arc_angle;
  require(angle >= 5 * units::deg && angle <= 85 * units::deg, field, angle, "rad", "5 to 85 deg");
  const double e = arc_offset(arcs, w_0);
  require(e < arc_radius(arcs, e, 2 * pi * bore), field, angle, "rad",
          "an arc whose radius exceeds the distance of its centre from the axis; give a larger "
          "angle");
}

void check_shape(const TwoDiscs& discs, double w_0, double bore, const FieldPath& path) {
  require(discs.offset > w_0 && discs.offset < bore / 2, (path / "disc_offset").text(),
          discs.offset, "m",
          fmt::format("> drive.radial_displacement, {:.6g} mm, and < half of the bore's radius, "
                      "{:.6g} mm: the discs leave the bore between the lobes",
                      w_0 / units::mm, bore / 2 / units::mm));
}

void check_shape(const CamPoints& points, double w_0, double /*bore*/, const FieldPath& path) {
  const FieldPath of = path / "point";
  if (points.size() < 5 || points.size() > 1000)
    throw InputError(of.text(), fmt::format("has {} points, but needs 5 to 1000", points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [angle, height] = points[i];
    const std::string at = (of[i] / "angle").text();
    if (i == 0) require(angle == 0, at, angle, "rad", "0 deg: the first point is that of a lobe");
    if (i > 0)
      require(angle > points[i - 1].angle, at, angle, "rad",
              fmt::format("> {:.6g} deg: the angles rise", points[i - 1].angle / units::deg));
    require(std::isfinite(height) && height <= points.front().height, (of[i] / "height").text(),
            height, "m",
            fmt::format("<= {:.6g} mm: the cam is highest at the lobe",
                        points.front().height / units::mm));
  }
  const double last = points.back().angle;
  require(std::abs(last - pi / 2) < 1e-6, (of[points.size() - 1] / "angle").text(), last, "rad",
          "90 deg: the last point is midway between the lobes");
  const double lobe = points.front().height;
  require(std::abs(lobe - w_0) <= 0.1 * w_0, (of[0] / "height").text(), lobe, "m",
          fmt::format("within 10 % of drive.radial_displacement, {:.6g} mm", w_0 / units::mm));
}

}  // namespace

void check(const CamShape& shape, double radial_displacement, double bore, const FieldPath& path) {
  std::visit([&](const auto& of) { check_shape(of, radial_displacement, bore, path); }, shape);
}

void check(const CamFit& fit, const TubeSection& rim) {
  const auto length = [](double value, const char* name, bool zero) {
    require((zero ? value >= 0 : value > 0) && std::isfinite(value), name, value, "m",
            zero ? ">= 0" : "> 0");
  };
  length(fit.radial_displacement, "radial_displacement", false);
  length(fit.clearance, "clearance", true);
  length(fit.band_width, "band_width", true);
  check(fit.shape, fit.radial_displacement, rim.outer_diameter / 2 - rim.wall_thickness, {});
  require(std::abs(fit.perimeter_excess) < 0.01 * pi * rim.outer_diameter, "perimeter_excess",
          fit.perimeter_excess, "m", "less than 1 % of the perimeter");
  require(fit.perimeter_excess == 0 || follows_perimeter(fit.shape), "perimeter_excess",
          fit.perimeter_excess, "m", "0 for two discs and for points, whose heights are given");
}

}  // namespace strainwave

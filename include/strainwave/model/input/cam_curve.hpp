// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "strainwave/model/input/cam.hpp"
#include "strainwave/model/input/flexspline.hpp"
#include "strainwave/model/input/wave_generator.hpp"

/// @file
/// The cam, as the bore of the rim sees it.

namespace strainwave {

/// w_0 cos 2 phi + c_cam w_0^2/(2 R) cos 4 phi, with R the radius of the rim's middle surface.
struct FlattenedCosine {
  double flattening = 0;  ///< c_cam [-]; >= 0; 1.5 for an ellipse
};
/// An arc at each lobe and an arc between the lobes; both have one tangent where they meet.
struct TwoArcs {
  double arc_angle{};  ///< gamma, half the angle of the arc at a lobe [rad]; 5 to 85 deg
};
/// A disc at each lobe, w_0 outside the bore at the lobe.
struct TwoDiscs {
  /// e, distance of a disc's centre from the axis [m]; > w_0, < half of the bore's radius
  double offset{};
};
/// Points of the cam from a lobe to the middle between the lobes.
using CamPoints = std::vector<CamPoint>;

/// Shape of a cam, with the numbers of its own.
using CamShape = std::variant<FlattenedCosine, TwoArcs, TwoDiscs, CamPoints>;

/// The cam in the bore, and the band on which it presses.
///
/// w_0 is half the difference of the semi-axes of a flattened cosine and of two arcs; their mean
/// height follows from the perimeter.  The heights of two discs and of points are those given.
struct CamFit {
  double radial_displacement{};        ///< w_0 [m]; > 0
  CamShape shape = FlattenedCosine{};  ///< profile of the cam
  /// perimeter of the cam without clearance minus that of the round bore [m]; > 0 stretches the
  /// rim; of a flattened cosine and of two arcs
  double perimeter_excess = 0;
  double clearance = 0;  ///< the cam lies this far inside, all round [m]; >= 0
  /// width of the band, in the middle of the rim [m]; 0: the whole rim
  double band_width = 0;
};

/// Whether the mean height of a cam follows from its perimeter; else its heights are given.
[[nodiscard]] bool follows_perimeter(const CamShape& shape);

/// The cam about the round bore; eq. (FE-52).
class CamCurve {
 public:
  /// @param fit  has passed `check`
  /// @param bore, middle  radii of the bore and of the rim's middle surface [m]
  /// @param exact  the mean follows from the length of the curve; false: for small w_0
  CamCurve(const CamFit& fit, double bore, double middle, bool exact);

  /// Height of the cam outside the bore at an angle from a lobe [m].
  [[nodiscard]] double at(double angle) const;
  [[nodiscard]] double slope(double angle) const;  ///< by the angle [m]
  [[nodiscard]] double farthest() const;           ///< largest height outside the bore [m]
  /// Length of a band round the cam minus the perimeter of the bore [m]; the band spans what the
  /// cam leaves open.
  [[nodiscard]] double band_excess() const;
  /// Radius of the bore [m].
  [[nodiscard]] double bore() const { return bore_; }

 private:
  [[nodiscard]] double length() const;

  double bore_;
  double mean_ = 0;
  // over the angle from the nearest lobe, 0 to pi/2
  std::function<double(double)> height_;
  std::function<double(double)> slope_;
};

/// Height of the bore over the cam at a point of the bore, and its derivatives by the point's
/// displacement, which are the direction of the cam's pressure.
struct CamGap {
  double value;     ///< the height [m]; < 0: the point is inside the cam
  double by_r;      ///< by the displacement outward [-]
  double by_theta;  ///< by the displacement round the axis [-]

  /// @param cam           the cam about the round bore
  /// @param angle         at which the point was [rad]
  /// @param u_r, u_theta  displacement of the point [m]
  CamGap(const CamCurve& cam, double angle, double u_r, double u_theta);
};

/// The shape of a wave generator's cam.
/// @param generator  has passed `check`
[[nodiscard]] CamShape cam_shape(const WaveGenerator& generator);

/// Refuses a shape that cannot be a cam of this bore.
/// @param shape                profile of the cam
/// @param radial_displacement  w_0 [m]; > 0
/// @param bore                 radius of the bore, or one that is about as large [m]
/// @param path                 of the cam in the input file, for messages; empty for none
/// @throws InputError  for values out of the ranges above; if discs do not leave the bore between
///                     the lobes; if points do not run from a lobe to the middle between the lobes,
///                     or do not agree with w_0
void check(const CamShape& shape, double radial_displacement, double bore, const FieldPath& path);

/// Refuses a cam with values out of range.
/// @throws InputError  if a value is out of the range above, if the perimeters differ by 1 % or
///                     more, or if `perimeter_excess` is not 0 for two discs or for points
void check(const CamFit& fit, const TubeSection& rim);

}  // namespace strainwave

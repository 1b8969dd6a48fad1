// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// What every model of a turn of the wave generator reads from a drive: a cup that is bent oval,
/// and the cam as the bore of its rim sees it.

namespace strainwave {

/// The cam, as the bore of the rim sees it, and the band on which it presses.
///
/// At the angle phi from a lobe, the cam lies w_0 cos 2 phi + c_cam w_0^2/(2 R) cos 4 phi + m
/// outside the round bore, with R the radius of the rim's middle surface.  The mean m follows from
/// the perimeter, less the clearance (FE-52).
struct CamFit {
  double radial_displacement{};  ///< w_0 [m]; > 0
  double flattening = 0;         ///< c_cam [-]; >= 0; 1.5 for an ellipse
  /// perimeter of the cam without clearance minus that of the round bore [m]; > 0 stretches the rim
  double perimeter_excess = 0;
  double clearance = 0;  ///< the cam lies this far inside, all round [m]; >= 0
  /// width of the band, in the middle of the rim [m]; 0: the whole rim
  double band_width = 0;
};

/// The cam about the round bore; eq. (FE-52).
class CamCurve {
 public:
  /// @param bore, middle  radii of the bore and of the rim's middle surface [m]
  /// @param exact  the mean follows from the length of the curve; false: for small w_0
  CamCurve(const CamFit& fit, double bore, double middle, bool exact);

  /// Distance outside the bore at an angle from a lobe [m].
  [[nodiscard]] double at(double angle) const;
  [[nodiscard]] double slope(double angle) const;  ///< by the angle [m]
  [[nodiscard]] double farthest() const;           ///< largest distance outside the bore [m]
  [[nodiscard]] double bore() const { return bore_; }

 private:
  [[nodiscard]] double length() const;

  double bore_;
  double two_;
  double four_;
  double mean_;
};

/// Distance of a point of the bore from the cam, and its derivatives by the point's displacement,
/// which are the direction of the cam's pressure.
struct CamGap {
  double value;  ///< [m]
  double by_r;
  double by_theta;

  /// @param angle         at which the point was [rad]
  /// @param u_r, u_theta  displacement of the point [m]
  CamGap(const CamCurve& cam, double angle, double u_r, double u_theta);
};

/// Refuses a cam with values out of range.
/// @throws InputError  if a value is out of the range above, or the perimeters differ by 1 %
void check(const CamFit& fit, const TubeSection& rim);

/// The cam of a drive; without a wave generator, a cosine of the drive's w_0 on the whole rim.
[[nodiscard]] CamFit cam_fit(const GearSet& gear);

/// Whether the rim's wall covers the barrel's wall inside and outside.
[[nodiscard]] bool rim_covers(const TubeSection& rim, const TubeSection& barrel);

/// Refuses a drive whose flexspline is not a cup, or a cylinder, that two lobes bend oval.
///
/// @param gear  has passed `check`
/// @throws InputError  if the flexspline is missing, is a hat, or has no sections; if the rim is
///                     missing or does not cover the barrel; for another wave number than 2; if
///                     the cam's perimeter stretches the rim beyond its yield strength
void require_turning_cup(const GearSet& gear);

}  // namespace strainwave

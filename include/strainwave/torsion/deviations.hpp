// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Deviations of the parts of one drive from their drawings, within their tolerances (TC-36).

namespace strainwave {

/// Deviation of one tooth at the pitch circle.
struct ToothDeviation {
  double position = 0.0;   ///< of the middle of the tooth along the pitch circle, toward +theta [m]
  double thickness = 0.0;  ///< [m]
};

/// The parts of one drive, measured.  Nothing deviates if all members are empty or 0.
struct Deviations {
  /// z teeth of the flexspline; tooth j stands at (j + 1/2) 2 pi/z
  std::vector<ToothDeviation> flexspline;
  /// z + 2 teeth of the circular spline; tooth j stands half a pitch beyond the space of tooth j
  std::vector<ToothDeviation> spline;
  std::vector<double> balls;        ///< deviation of the diameter of each ball [m]
  double eccentricity = 0.0;        ///< of the cam in the bearing, half of its run-out [m]
  double eccentricity_angle = 0.0;  ///< direction of the eccentricity from the major axis [rad]
  double pairing_gap = 0.0;         ///< further gap of all flanks, normal to them [m]

  /// Whether nothing deviates: no lists, and 0 for eccentricity and gap.
  [[nodiscard]] bool empty() const {
    return flexspline.empty() && spline.empty() && balls.empty() && eccentricity == 0 &&
           pairing_gap == 0;
  }
};

/// Standard deviations of the parts of a drive, from its tolerances.
struct DeviationLimits {
  double single_pitch = 0.0;      ///< f_pT, the limit of the single pitch deviation [m]
  double position = 0.0;          ///< of the middle of a tooth [m]
  double thickness = 0.0;         ///< of the thickness of a tooth [m]
  double diameter_of_ball = 0.0;  ///< [m]
  double eccentricity = 0.0;      ///< of the cam, not drawn [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"single_pitch", "m", "f_pT, limit of the single pitch deviation of ISO 1328-1"},
          &DeviationLimits::single_pitch);
    field({"position", "m", "standard deviation of the middle of a tooth along the pitch circle"},
          &DeviationLimits::position);
    field({"thickness", "m", "standard deviation of the thickness of a tooth"},
          &DeviationLimits::thickness);
    field({"diameter_of_ball", "m", "standard deviation of the diameters of the balls"},
          &DeviationLimits::diameter_of_ball);
    field({"eccentricity", "m", "eccentricity of the cam in the bearing, in a drawn direction"},
          &DeviationLimits::eccentricity);
  }
};

/// Limit of the single pitch deviation f_pT of ISO 1328-1:2013 [m].
///
/// Implements theory manual eq. (TC-36).  The standard is for modules of 0.5 mm and more and is
/// extrapolated below.
/// @param grade           flank tolerance class, 1 to 11
/// @param pitch_diameter  d [m]; > 0
/// @param module          m [m]; > 0
[[nodiscard]] double single_pitch_limit(int grade, double pitch_diameter, double module);

/// The limits of a drive, from its tolerances or their defaults.
/// @throws InputError  if the thickness deviates more than the pitch of the flanks allows
[[nodiscard]] DeviationLimits deviation_limits(const GearSet& gear);

/// Draws the parts of one drive and pairs them: normal deviates, and a uniform direction of the
/// eccentricity.  The numbers depend on seed and draw alone, and are the same on every machine.
/// @param gear  has a bearing with balls and a mesh
/// @param seed  of the random numbers [-]; any number
/// @param draw  number of the drive among those of the seed [-]; any number
/// @throws InputError  as `deviation_limits`
[[nodiscard]] Deviations draw_deviations(const GearSet& gear, std::uint64_t seed,
                                         std::uint64_t draw);

/// Least further gap of all flanks with which no flank is closer to the flank that it faces than in
/// the drive without deviations, at any place and in any position of the wave generator over its
/// first turn against the circular spline [m].  On later turns each tooth meets other spaces, so
/// flanks can come closer by a small part of this gap.
///
/// Implements theory manual eq. (TC-36).
/// @param deviations  of all teeth of both parts; its own `pairing_gap` is ignored
/// @param gear        has a mesh
[[nodiscard]] double pairing_gap(const Deviations& deviations, const GearSet& gear);

/// The parts of a drive of which some teeth were measured: teeth that were not measured do not
/// deviate, and all flanks get the further gap of (TC-36).
/// @param measured  its `pairing_gap` is ignored
/// @param gear      has a bearing with balls and a mesh
/// @throws InputError  as `check_deviations`
[[nodiscard]] Deviations paired(Deviations measured, const GearSet& gear);

/// The parts after the wave generator has moved on by a number of teeth: teeth of both parts move
/// by one place for each tooth.  Balls and cam keep their places.
[[nodiscard]] Deviations moved_on(const Deviations& deviations, int teeth);

/// Closing of a flank by the deviations, normal to it [m].
/// @param deviations   of the teeth, and the gap of the pairing; a part without a list does not
///                     deviate
/// @param tooth        number j of the place, 0 to z - 1
/// @param side         +1 for the drive flank, -1 for the coast flank
/// @param teeth        z of the flexspline
/// @param flank_angle  alpha, or the angle beta of the flank (TC-6) [rad]
[[nodiscard]] double flank_closing(const Deviations& deviations, int tooth, int side, int teeth,
                                   double flank_angle);

/// Closing of a ball by the deviations [m].
/// @param deviations  of the balls, and the eccentricity of the cam; balls without a list do not
///                    deviate
/// @param ball        number of the ball, from 0
/// @param position    psi, its angle from the major axis [rad]
[[nodiscard]] double ball_closing(const Deviations& deviations, int ball, double position);

/// @throws InputError  if numbers of teeth or balls do not fit the drive, or are not finite
void check_deviations(const Deviations& deviations, const GearSet& gear);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "angles.hpp"
#include "strainwave/torsion/tooth_flanks.hpp"

// Half-path flanks (TC-29): the tooth has the path of the pitch point at half its size, and the
// wall is what the tooth sweeps.

namespace strainwave {

/// A point of a flank: across from the middle of the tooth or space, and outward.
template <class Real>
struct BasicFlankPoint {
  Real across{};
  Real outward{};
};

/// A half-path flank above the pitch height.  Its points are those of the path at the angle eta/2
/// from the lobe.
template <class Real>
struct BasicHalfPathFlank {
  Real half{};      // of the tooth's thickness at the pitch height
  Real offset{};    // of the pitch height from the centre line
  Real wave{};      // w_0
  Real stretch{};   // m/w_0
  Real addendum{};  // h_a

  [[nodiscard]] BasicFlankPoint<Real> point(const Real& eta) const {
    using std::cos, std::sin;
    return {half - wave / 4 * (eta * stretch - sin(eta)), offset + wave / 2 * (1 - cos(eta))};
  }
  /// eta of the tip.
  [[nodiscard]] Real tip_path() const { return arc_cosine(Real(1 - 2 * addendum / wave)); }
  [[nodiscard]] BasicFlankPoint<Real> tip() const { return point(tip_path()); }
  /// Angle of the normal above the tangent of the pitch circle.
  [[nodiscard]] Real normal(const Real& eta) const {
    using std::cos, std::sin;
    return angle_of(Real(stretch - cos(eta)), Real(2 * sin(eta)));
  }
};

template <class Real>
[[nodiscard]] BasicHalfPathFlank<Real> half_path_flank(const BasicTeeth<Real>& teeth) {
  return {.half = teeth.thickness / 2,
          .offset = teeth.pitch_offset,
          .wave = teeth.wave,
          .stretch = 2 * (teeth.ring_radius + teeth.pitch_offset) / (teeth.teeth * teeth.wave),
          .addendum = teeth.addendum};
}

/// A point of a tooth in the frame of the space.
template <class Real>
[[nodiscard]] BasicFlankPoint<Real> placed(const typename BasicToothMotion<Real>::Pose& pose,
                                           const BasicFlankPoint<Real>& point) {
  using std::cos, std::sin;
  const Real c = cos(pose.turn);
  const Real s = sin(pose.turn);
  return {pose.across + point.across * c + point.outward * s,
          pose.outward - point.across * s + point.outward * c};
}

/// The wall that half-path flanks sweep, and the points of the wall and of a tooth that are nearest
/// to each other.
class HalfPathWall {
 public:
  using Motion = BasicToothMotion<double>;
  using Point = BasicFlankPoint<double>;

  /// @param end  angle at which the tips part
  HalfPathWall(const BasicTeeth<double>& teeth, const Motion& motion, double end);

  /// The point of a tooth that lies on the wall.
  struct Touch {
    double angle = 0.0;   // of the tooth
    double path = 0.0;    // eta of the point
    bool at_tip = false;  // the edge of the tip sweeps the wall
    Point at;             // in the frame of the space
    Point along;          // the wall's tangent, downward
  };
  /// @param t  angle of the tooth; from 0 to the end
  [[nodiscard]] Touch touch(double t) const;

  struct Nearest {
    Touch wall;
    double path = 0.0;    // eta of the point of the tooth
    bool at_tip = false;  // it is the edge of the tip
    bool below = false;   // it lies below the pitch height
    Point foot;           // in the frame of the tooth
    Point apart;          // from the tooth to the wall, in the frame of the space
  };
  /// @param t  angle of the tooth; < 0
  [[nodiscard]] Nearest nearest(double t) const;
  [[nodiscard]] double end() const { return end_; }

 private:
  [[nodiscard]] Nearest from(const Motion::Pose& tooth, const Touch& wall) const;

  BasicHalfPathFlank<double> flank_;
  Motion motion_;
  double lowest_ = 0.0;  // eta from which the flank is convex and leans inward
  double end_ = 0.0;
  std::vector<Touch> samples_;  // of the wall
};

/// Contact and distance of half-path flanks.
template <class Real>
class BasicHalfPath {
 public:
  using Motion = BasicToothMotion<Real>;
  using Point = BasicFlankPoint<Real>;

  /// @param wall  of the same teeth, without derivatives
  BasicHalfPath(const BasicTeeth<Real>& teeth, const Motion& motion,
                std::shared_ptr<const HalfPathWall> wall)
      : flank_(half_path_flank(teeth)), motion_(motion), wall_(std::move(wall)) {}

  struct Flanks {
    Real distance{};  // of tooth and wall without play; 0 for t >= 0
    BasicFlankContact<Real> contact;
  };
  /// @param t  as for `BasicToothGap`
  [[nodiscard]] Flanks at(double t) const;
  [[nodiscard]] const std::shared_ptr<const HalfPathWall>& wall() const { return wall_; }

 private:
  [[nodiscard]] BasicFlankContact<Real> contact(double t) const;
  [[nodiscard]] BasicFlankContact<Real> at_tip(double t) const;
  [[nodiscard]] Real distance(double t, const HalfPathWall::Nearest& nearest) const;

  BasicHalfPathFlank<Real> flank_;
  Motion motion_;
  std::shared_ptr<const HalfPathWall> wall_;
};

extern template class BasicHalfPath<double>;
extern template class BasicHalfPath<DualReal>;

}  // namespace strainwave

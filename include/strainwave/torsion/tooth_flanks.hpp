// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "strainwave/core/dual.hpp"
#include "strainwave/model/input/tooth_mesh.hpp"

/// @file
/// Teeth as drawn: gap between their flanks on the deformed rim, end of their engagement, and their
/// compliance.

namespace strainwave {

/// The teeth of a drive, and the rim on which they stand.
template <class Real>
struct BasicTeeth {
  ToothProfile profile = ToothProfile::straight;  ///< shape of the working flanks
  Real flank_angle{};      ///< alpha at the pitch height [rad]; in (0, pi/3); unused by half paths
  Real addendum{};         ///< h_a of the flexspline, working height [m]; > 0
  Real spline_addendum{};  ///< h_ac of the circular spline [m]; > 0
  Real thickness{};        ///< s_t of the flexspline's tooth at the pitch height [m]; > 0
  Real ring_radius{};      ///< R, centre line of the round rim [m]
  Real pitch_offset{};     ///< e, pitch radius minus R [m]
  Real wave{};             ///< w_0, half the difference of the semi-axes of the deformed rim [m]
  int teeth = 0;           ///< z
  ToothTips tips = ToothTips::full;  ///< whether the tips are relieved
};

/// Finite motion of a tooth in the space of the circular spline; theory manual eqs. (TC-28),
/// (TC-29).  Exact for a rigid tooth on a centre line r = R_m + w_0 cos(2 phi) of constant length.
template <class Real>
class BasicToothMotion {
 public:
  BasicToothMotion() = default;
  /// Finds the centre line of the deformed rim, which keeps its length.
  explicit BasicToothMotion(const BasicTeeth<Real>& teeth);

  /// Centre of the section and turn of the tooth, in the frame of the space.
  struct Pose {
    Real across{};   ///< X [m]
    Real outward{};  ///< Y [m]
    Real turn{};     ///< delta [rad]
  };
  /// @param t  angle of the tooth from the lobe, toward the flank [rad]
  [[nodiscard]] Pose pose(double t) const { return pose_of(t, section(t)); }
  /// A pose and its derivatives by the angle.
  struct Moving {
    Pose at;    ///< the pose
    Pose rate;  ///< derivatives by t: of the place [m/rad], of the turn [-]
  };
  /// Pose and derivatives at an angle.
  [[nodiscard]] Moving moving(double t) const;
  /// R_m [m].
  [[nodiscard]] const Real& mean_radius() const { return mean_radius_; }

 private:
  struct Section {
    Real angle{};   // phi
    Real radius{};  // r
    Real slope{};   // dr/dphi
  };
  [[nodiscard]] Section section(double t) const;
  [[nodiscard]] Pose pose_of(double t, const Section& at) const;

  static constexpr int kTerms = 7;
  Real ring_radius_{};
  Real wave_{};
  int teeth_ = 0;
  Real mean_radius_{};
  std::array<Real, kTerms> series_;  // a_n of ds/dphi
};

/// Where and in which direction two flanks press each other.
template <class Real>
struct BasicFlankContact {
  Real angle{};   ///< beta, common normal against the tangent of the ring [rad]
  Real height{};  ///< h_c of the point of contact above the pitch height [m]
};

/// A flank of a drawn tooth at one angle from the lobe.
template <class Real>
struct BasicToothFlank {
  Real gap{};    ///< at the end of the face that touches first [m]; 0 where the flanks would cross
  Real slope{};  ///< growth of the gap along the face, s [-]; >= 0
  BasicFlankContact<Real> contact;  ///< where and in which direction the flanks press each other
};

/// A flank at one angle in plain numbers.
using ToothFlank = BasicToothFlank<double>;

template <class Real>
class BasicHalfPath;

/// Gap between the flanks of rigid teeth that stand normal to the deformed centre line of the rim.
///
/// Implements theory manual eqs. (TC-28), (TC-29): closed forms for straight flanks and involutes,
/// searches for half-path flanks.  Straight flanks and involutes are seated so that they touch
/// without crossing anywhere on the face up to 30 degrees from a lobe, half-path flanks at the
/// lobe. Accuracy: exact for a rigid tooth, 1e-9 m for half paths.
template <class Real>
class BasicToothGap {
 public:
  /// A flank in the scalar of the gap.
  using Flank = BasicToothFlank<Real>;
  /// A contact in the scalar of the gap.
  using Contact = BasicFlankContact<Real>;

  /// @param teeth       shape of the teeth, and the rim on which they stand
  /// @param cone        growth of the wave along the face, chi w_0 times the tilt (TC-2) [-]; >= 0
  /// @param face_width  b [m]; > 0
  BasicToothGap(const BasicTeeth<Real>& teeth, const Real& cone, const Real& face_width);

  /// @param t  angle of the tooth from the lobe, toward the flank [rad]; in [-pi/2, pi/2]
  [[nodiscard]] Flank flank(double t) const;
  /// Gap at the end of the face that touches first [m]; 0 where the flanks would cross.
  [[nodiscard]] Real gap(double t) const { return flank(t).gap; }
  /// Growth of the gap along the face, s [-]; >= 0.
  [[nodiscard]] Real slope(double t) const { return slope(t, contact(t)); }
  /// Place and direction of the contact.  Straight flanks and involutes keep alpha and the pitch
  /// height.
  [[nodiscard]] Contact contact(double t) const;
  /// Largest angle at which drive flanks can touch [rad]: where they have a height in common, and
  /// with relieved tips at most where their gap is largest.
  [[nodiscard]] double end() const { return end_; }
  /// Least relief of the tips that `ToothTips::relieved` presumes: the largest gap less the gap
  /// where the flanks part [m]; 0 for full tips and for half paths.
  [[nodiscard]] double relief() const { return relief_; }
  /// Angle at which the flanks are seated [rad].
  [[nodiscard]] double seat() const { return seat_; }
  /// Play g_s of the seat, normal to the flank [m].
  [[nodiscard]] const Real& play() const { return play_; }
  /// Depth by which flanks would cross beyond 30 degrees, where makers relieve the tips [m]; 0 if
  /// they do not cross.
  [[nodiscard]] double crossing() const;
  /// Gap at mid-face, negative where the flanks cross [m].
  [[nodiscard]] Real mid_gap(double t) const { return mid_gap(t, play_); }

 private:
  template <class>
  friend class BasicToothGap;
  using Pose = typename BasicToothMotion<Real>::Pose;
  [[nodiscard]] Real mid_gap(double t, const Real& play) const;
  [[nodiscard]] Real slope(double t, const Contact& contact) const;
  [[nodiscard]] Real straight_gap(const Pose& at, const Real& play) const;
  [[nodiscard]] Real involute_gap(const Pose& at, const Real& play) const;
  [[nodiscard]] Real pitch_height() const;
  [[nodiscard]] Real tip_thickness() const;
  [[nodiscard]] double find_end() const;
  [[nodiscard]] double find_seat() const;
  [[nodiscard]] double find_widest() const;

  BasicTeeth<Real> teeth_;
  Real cone_{};
  Real face_width_{};
  BasicToothMotion<Real> motion_;
  struct Direction {
    Real cosine{};
    Real sine{};
  };
  Direction flank_direction_;                             // of alpha
  std::shared_ptr<const BasicHalfPath<Real>> half_path_;  // of half-path flanks
  double end_ = 0.0;
  double relief_ = 0.0;
  double seat_ = 0.0;
  Real play_{};
};
/// A gap in plain numbers.
using ToothGap = BasicToothGap<double>;

extern template class BasicToothGap<double>;
extern template class BasicToothGap<DualReal>;

/// Mean angle of a half-path flank against the radius, between the pitch height and the tip [rad].
///
/// Implements theory manual eq. (TC-29).
/// @param addendum  h_a [m]; > 0, < wave
/// @param wave      w_0 [m]; > 0
/// @param module    m [m]; > 0
template <class Real>
[[nodiscard]] Real half_path_angle(const Real& addendum, const Real& wave, const Real& module);

/// A tooth on its wall, in plane strain.
template <class Real>
struct BasicToothOnWall {
  Real flank_angle{};  ///< alpha [rad]; fitted in 15 to 30 degrees
  Real thickness{};    ///< s_t at the pitch height [m]; fitted in 0.4 to 0.5 pitches
  Real dedendum{};     ///< h_f [m]; fitted in 1.0 to 1.4 modules
  Real wall{};    ///< t, thickness of the wall under the roots [m]; fitted in 0.4 to 40 modules
  Real module{};  ///< m [m]

  /// Width B of the tooth at its roots [m].
  [[nodiscard]] Real root_width() const;
};

/// Compliance of a tooth on its wall under a flank force at the pitch height, times E and per face
/// width, without the stretch of the wall as a bar, c_t [-].
///
/// Implements theory manual eq. (TC-30).  Beam integrals without fitted numbers; the foundation is
/// fitted to plane finite elements, within 4 % of 91 teeth.
template <class Real>
[[nodiscard]] Real tooth_compliance(const BasicToothOnWall<Real>& tooth,
                                    const Real& poissons_ratio);

/// Stiffness in tension of a toothed wall over that of the bare wall, EA/(E b t_r) [-].
///
/// Implements theory manual eq. (TC-30), fitted to plane finite elements within 2.5 % (t_r/m 0.4 to
/// 5).
template <class Real>
[[nodiscard]] Real toothed_extension(const BasicToothOnWall<Real>& tooth);

}  // namespace strainwave

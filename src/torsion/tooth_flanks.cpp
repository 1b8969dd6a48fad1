// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/tooth_flanks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "angles.hpp"
#include "half_path.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kSeat = pi / 6;  // flanks are seated on the teeth up to this angle from a lobe

template <class Real>
const Real& least(const Real& a, const Real& b) {
  return b < a ? b : a;
}

template <class Real>
BasicTeeth<double> values_of(const BasicTeeth<Real>& t) {
  return {.profile = t.profile,
          .flank_angle = value_of(t.flank_angle),
          .addendum = value_of(t.addendum),
          .spline_addendum = value_of(t.spline_addendum),
          .thickness = value_of(t.thickness),
          .ring_radius = value_of(t.ring_radius),
          .pitch_offset = value_of(t.pitch_offset),
          .wave = value_of(t.wave),
          .teeth = t.teeth,
          .tips = t.tips};
}

/// Roll angle of an involute at a distance from the centre.
template <class Real>
Real roll(const Real& distance, const Real& base) {
  using std::sqrt;
  const Real over = distance / base;
  const Real square = over * over - 1;
  return square > 0 ? Real(sqrt(square)) : Real(0.0);
}

/// Turns the cosine and the sine of an angle to that of an angle which is larger by a small one.
template <class Real>
void turn_by(const Real& angle, Real& c, Real& s) {
  using std::cos, std::sin;
  Real cosine;
  Real sine;
  constexpr double kSmall = 0.03;  // the next terms are below 1e-18
  if (std::abs(value_of(angle)) < kSmall) {
    const Real square = angle * angle;
    cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)));
    sine = angle * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
  } else {
    cosine = cos(angle);
    sine = sin(angle);
  }
  const Real before = c;
  c = before * cosine - s * sine;
  s = s * cosine + before * sine;
}

}  // namespace

template <class Real>
BasicToothMotion<Real>::BasicToothMotion(const BasicTeeth<Real>& teeth)
    : ring_radius_(teeth.ring_radius), wave_(teeth.wave), teeth_(teeth.teeth) {
  // (TC-29): the centre line keeps its length; ds/dphi = R + sum a_n cos(2 n phi).
  constexpr int kSamples = 32;
  constexpr int kSteps = 4;
  const Real& R = ring_radius_;
  const Real& w0 = wave_;
  mean_radius_ = R - w0 * w0 / R;
  std::array<Real, kSamples> speed;
  for (int step = 0; step < kSteps; ++step) {
    Real mean(0.0);
    for (int i = 0; i < kSamples; ++i) {
      const double phi = pi * i / kSamples;
      speed[static_cast<std::size_t>(i)] =
          length_of(Real(mean_radius_ + w0 * std::cos(2 * phi)), Real(2 * w0 * std::sin(2 * phi)));
      mean += speed[static_cast<std::size_t>(i)] / kSamples;
    }
    if (step + 1 < kSteps) mean_radius_ += R - mean;
  }
  for (int n = 1; n <= kTerms; ++n) {
    Real a(0.0);
    for (int i = 0; i < kSamples; ++i)
      a += 2 * speed[static_cast<std::size_t>(i)] * std::cos(2 * n * pi * i / kSamples) / kSamples;
    series_[static_cast<std::size_t>(n - 1)] = a;
  }
}

template <class Real>
typename BasicToothMotion<Real>::Section BasicToothMotion<Real>::section(double t) const {
  const Real& R = ring_radius_;
  const Real& w0 = wave_;
  constexpr int kSteps = 3;  // of Newton's method; the start errs by (w_0/R)^2
  // Below this step Newton's method has no error that a double shows.
  constexpr double kExact = 1e-9;
  // cosine and sine of 2 t, and then of 2 phi
  Real c(std::cos(2 * t));
  Real s(std::sin(2 * t));
  const Real start = -w0 / (2 * R) * s;
  Real phi = t + start;
  turn_by(Real(2 * start), c, s);
  for (int step = 0; step < kSteps; ++step) {
    Real length = R * phi;
    Real before(0.0);  // sin(2 (n - 1) phi)
    Real sine = s;     // sin(2 n phi)
    for (int n = 1; n <= kTerms; ++n) {
      length += series_[static_cast<std::size_t>(n - 1)] * sine / (2 * n);
      before = std::exchange(sine, Real(2 * c * sine - before));
    }
    const Real missing =
        (R * t - length) / length_of(Real(mean_radius_ + w0 * c), Real(2 * w0 * s));
    phi += missing;
    turn_by(Real(2 * missing), c, s);
    if (std::is_same_v<Real, double> && std::abs(value_of(missing)) < kExact) break;
  }
  return {.angle = phi, .radius = mean_radius_ + w0 * c, .slope = -2 * w0 * s};
}

template <class Real>
typename BasicToothMotion<Real>::Pose BasicToothMotion<Real>::pose_of(double t,
                                                                      const Section& at) const {
  using std::atan, std::cos, std::sin;
  const Real from_space = at.angle - t * teeth_ / (teeth_ + 2);  // (TC-28)
  return {.across = at.radius * sin(from_space),
          .outward = at.radius * cos(from_space),
          .turn = from_space - atan(at.slope / at.radius)};
}

template <class Real>
typename BasicToothMotion<Real>::Moving BasicToothMotion<Real>::moving(double t) const {
  using std::cos, std::sin;
  const Section section = this->section(t);
  const Real& r = section.radius;
  const Real& slope = section.slope;
  const Real square = r * r + slope * slope;
  const Real faster = ring_radius_ / length_of(r, slope);  // dphi/dt
  const double space = static_cast<double>(teeth_) / (teeth_ + 2);
  const Real from_space = section.angle - t * space;
  const Real turns = faster - space;
  const Real grows = slope * faster;
  const Real bend = -4 * wave_ * cos(2 * section.angle);  // of r by phi, second derivative
  return {.at = pose_of(t, section),
          .rate = {.across = grows * sin(from_space) + r * turns * cos(from_space),
                   .outward = grows * cos(from_space) - r * turns * sin(from_space),
                   .turn = turns - faster * (bend * r - slope * slope) / square}};
}

template class BasicToothMotion<double>;
template class BasicToothMotion<DualReal>;

template <class Real>
BasicToothGap<Real>::BasicToothGap(const BasicTeeth<Real>& teeth, const Real& cone,
                                   const Real& face_width)
    : teeth_(teeth), cone_(cone), face_width_(face_width), motion_(teeth) {
  using std::cos, std::sin;
  flank_direction_ = {cos(teeth.flank_angle), sin(teeth.flank_angle)};
  end_ = find_end();
  const bool half_path = teeth.profile == ToothProfile::half_path;
  // At the seat the gap is least, so its derivative by the angle is zero, and the angle may be that
  // of the values alone.
  if constexpr (std::is_same_v<Real, double>) {
    if (half_path)
      half_path_ = std::make_shared<const BasicHalfPath<Real>>(
          teeth, motion_, std::make_shared<const HalfPathWall>(teeth, motion_, end_));
    seat_ = find_seat();
  } else {
    const BasicToothGap<double> values(values_of(teeth), value_of(cone), value_of(face_width));
    if (half_path)
      half_path_ =
          std::make_shared<const BasicHalfPath<Real>>(teeth, motion_, values.half_path_->wall());
    seat_ = values.seat();
  }
  play_ = slope(seat_) * face_width_ / 2 - mid_gap(seat_, Real(0.0));
  if (teeth.tips == ToothTips::relieved && !half_path) {
    const double widest = find_widest();
    relief_ = value_of(mid_gap(widest, play_) - mid_gap(end_, play_));
    end_ = widest;
  }
}

template <class Real>
Real BasicToothGap<Real>::pitch_height() const {
  return motion_.mean_radius() + teeth_.wave + teeth_.pitch_offset;
}

template <class Real>
Real BasicToothGap<Real>::tip_thickness() const {
  using std::tan;
  if (teeth_.profile == ToothProfile::half_path) return 2 * half_path_flank(teeth_).tip().across;
  return teeth_.thickness - 2 * teeth_.addendum * tan(teeth_.flank_angle);
}

template <class Real>
double BasicToothGap<Real>::find_end() const {
  const double half_tip = value_of(tip_thickness()) / 2;
  const double tip = value_of(teeth_.pitch_offset + teeth_.addendum);
  const double lowest = value_of(pitch_height() - teeth_.spline_addendum);
  const auto common = [&](double t) {  // height that both teeth have
    const Pose at = motion_.pose(t);
    const double turn = value_of(at.turn);
    return value_of(at.outward) - half_tip * std::sin(turn) + tip * std::cos(turn) - lowest;
  };
  const double at_lobe = common(0.0);
  if (!(at_lobe > 0)) return 0.0;
  const double between = common(pi / 2);
  if (between >= 0) return pi / 2;
  return bracketed_root(common, 0.0, pi / 2, at_lobe, between);  // (TC-29)
}

template <class Real>
Real BasicToothGap<Real>::straight_gap(const Pose& at, const Real& play) const {
  using std::cos, std::sin;
  const Real c = cos(at.turn);
  const Real s = sin(at.turn);
  const Real half = teeth_.thickness / 2;
  const Real& e = teeth_.pitch_offset;
  // from the pitch point of the tooth's flank to that of the wall
  const Real dx = half - at.across - half * c - e * s;
  const Real dy = pitch_height() - at.outward + half * s - e * c;
  const auto& [ca, sa] = flank_direction_;  // of alpha
  const Real tilted = s / ca;
  const Real tip = dx * ca + dy * sa + play - teeth_.addendum * tilted;
  const Real root =
      dx * (ca * c + sa * s) + dy * (sa * c - ca * s) + play * c + teeth_.spline_addendum * tilted;
  return least(tip, root);  // (TC-29)
}

template <class Real>
Real BasicToothGap<Real>::involute_gap(const Pose& at, const Real& play) const {
  using std::cos, std::sin, std::tan;
  const Real& alpha = teeth_.flank_angle;
  const Real pitch_radius = teeth_.ring_radius + teeth_.pitch_offset;
  const Real b1 = pitch_radius * cos(alpha);
  const Real b2 = b1 * (teeth_.teeth + 2) / teeth_.teeth;
  const Real centre_x = at.across - teeth_.ring_radius * sin(at.turn);
  const Real centre_y = at.outward - teeth_.ring_radius * cos(at.turn);
  const Real half_angle = teeth_.thickness / (2 * pitch_radius);
  const Real A1 = half_angle + tan(alpha) - alpha + at.turn;
  const auto beginning = [](const Real& x, const Real& y, const Real& base) {
    const Real q = roll(length_of(x, y), base);
    return angle_of(x, y) + q - angle_of(q, Real(1.0));
  };
  // At the lobe both flanks go through the same point of the pitch height.
  const Real A2 = beginning(pitch_radius * sin(half_angle),
                            pitch_radius * cos(half_angle) + pitch_height() - pitch_radius, b2) +
                  play / b2;
  const auto point = [](const Real& x, const Real& y, const Real& base, const Real& start,
                        const Real& q) {
    const Real b = start - q;
    return std::pair{Real(x + base * (sin(b) + q * cos(b))),
                     Real(y + base * (cos(b) - q * sin(b)))};
  };
  const Real tip = roll(Real(pitch_radius + teeth_.addendum), b1);
  const Real wall = roll(Real(pitch_height() - teeth_.spline_addendum), b2);
  const auto [tip_x, tip_y] = point(centre_x, centre_y, b1, A1, tip);
  Real gap = b2 * (A2 - beginning(tip_x, tip_y, b2));
  const auto [wall_x, wall_y] = point(Real(0.0), Real(0.0), b2, A2, wall);
  gap =
      least(gap, Real(b1 * (beginning(Real(wall_x - centre_x), Real(wall_y - centre_y), b1) - A1)));
  const Real apart = length_of(centre_x, centre_y);
  const Real differ = b2 - b1;
  if (apart > differ) {
    const Real b = angle_of(centre_x, centre_y) - arc_cosine(Real(differ / apart));
    const Real q1 = A1 - b;
    const Real q2 = A2 - b;
    if (q1 <= tip && q2 >= wall)  // the common normal meets both working flanks
      gap = least(gap, Real(b2 * q2 - b1 * q1 - (centre_x * cos(b) - centre_y * sin(b))));
  }
  return gap;  // (TC-29)
}

template <class Real>
Real BasicToothGap<Real>::mid_gap(double t, const Real& play) const {
  if (half_path_) return half_path_->at(t).distance + play;
  const Pose at = motion_.pose(t);
  return teeth_.profile == ToothProfile::straight ? straight_gap(at, play) : involute_gap(at, play);
}

template <class Real>
BasicFlankContact<Real> BasicToothGap<Real>::contact(double t) const {
  if (half_path_) return half_path_->at(t).contact;
  return {.angle = teeth_.flank_angle, .height = Real(0.0)};
}

template <class Real>
Real BasicToothGap<Real>::slope(double t, const Contact& contact) const {
  using std::abs, std::cos, std::sin;
  const Real& beta = contact.angle;
  // The tip touches the drive flank, except on half paths.
  const Real& height = half_path_ ? contact.height : teeth_.addendum;
  const Real lever = 3 * (teeth_.pitch_offset + height) / teeth_.ring_radius;
  return cone_ * abs(sin(beta) * std::cos(2 * t) -
                     (1 - lever) / 2 * std::sin(2 * t) * cos(beta));  // (TC-29)
}

template <class Real>
BasicToothFlank<Real> BasicToothGap<Real>::flank(double t) const {
  Contact at{};
  Real middle{};
  if (half_path_) {
    const auto flanks = half_path_->at(t);
    at = flanks.contact;
    middle = flanks.distance + play_;
  } else {
    at = contact(t);
    middle = mid_gap(t, play_);
  }
  const Real s = slope(t, at);
  const Real at_end = middle - s * face_width_ / 2;
  return {.gap = at_end > 0 ? at_end : Real(0.0), .slope = s, .contact = at};
}

template <class Real>
double BasicToothGap<Real>::crossing() const {
  constexpr int kSamples = 60;
  if (end_ <= kSeat) return 0.0;
  double deepest = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = kSeat + (end_ - kSeat) * i / kSamples;
    deepest = std::max(deepest, value_of(slope(t) * face_width_ / 2 - mid_gap(t, play_)));
  }
  return deepest;
}

template <class Real>
double BasicToothGap<Real>::find_seat() const {
  if (half_path_) return 0.0;  // (TC-29): their slope along the face is largest there
  const auto height = [&](double t) {
    return value_of(mid_gap(t, Real(0.0)) - slope(t) * face_width_ / 2);
  };
  constexpr int kSamples = 60;
  double best = 0.0;
  double least = height(best);
  for (int i = 0; i <= kSamples; ++i) {
    const double t = kSeat * (2.0 * i / kSamples - 1);
    if (const double at = height(t); at < least) {
      best = t;
      least = at;
    }
  }
  // golden section around the best sample
  constexpr double kGolden = 0.6180339887498949;
  double low = std::max(-kSeat, best - 2 * kSeat / kSamples);
  double high = std::min(kSeat, best + 2 * kSeat / kSamples);
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double at_left = height(left);
  double at_right = height(right);
  while (high - low > 1e-4) {
    if (at_left < at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = height(left);
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = height(right);
    }
  }
  double found = (low + high) / 2;
  // The derivatives hold at the exact seat.  Newton's method on the slope finds the angle better
  // than the height itself, whose change near the seat is lost in rounding.
  constexpr double kStep = 1e-4;
  for (int step = 0; step < 3; ++step) {
    const double before = height(found - kStep);
    const double after = height(found + kStep);
    const double bend = (after - 2 * height(found) + before) / (kStep * kStep);
    const double next = found - (after - before) / (2 * kStep * bend);
    if (!(bend > 0) || std::abs(next - found) > 0.01) break;  // a corner, or the last tooth
    found = std::clamp(next, -kSeat, kSeat);
  }
  return height(found) < height(best) ? found : best;
}

template <class Real>
double BasicToothGap<Real>::find_widest() const {
  if (!(end_ > 0)) return end_;
  const auto height = [&](double t) { return value_of(mid_gap(t, play_)); };
  constexpr int kSamples = 120;
  const double step = end_ / kSamples;
  std::array<double, kSamples + 1> heights;
  for (int i = 0; i <= kSamples; ++i) heights[static_cast<std::size_t>(i)] = height(i * step);
  // Flanks that are seated beside the lobe have a gap at the lobe, too.
  const auto seats = static_cast<int>(std::min<double>(kSamples, kSeat / step));
  const auto seat = std::min_element(heights.begin(), heights.begin() + seats + 1);
  const double seated = step * static_cast<double>(seat - heights.begin());
  const double best =
      step * static_cast<double>(std::max_element(seat, heights.end()) - heights.begin());
  const double low = std::max(best - step, seated);
  const double high = std::min(best + step, end_);
  const auto rises = [&](double t) {
    constexpr double kStep = 1e-6;
    return height(t + kStep) - height(t - kStep);
  };
  const double at_low = rises(low);
  const double at_high = rises(high);
  if (!(at_low > 0)) return low;
  if (!(at_high < 0)) return high;
  return bracketed_root(rises, low, high, at_low, at_high);
}

template class BasicToothGap<double>;
template class BasicToothGap<DualReal>;

template <class Real>
Real half_path_angle(const Real& addendum, const Real& wave, const Real& module) {
  using std::atan;
  const BasicHalfPathFlank<Real> flank{.half = Real(0.0),
                                       .offset = Real(0.0),
                                       .wave = wave,
                                       .stretch = module / wave,
                                       .addendum = addendum};
  return atan(-flank.tip().across / addendum);  // (TC-29)
}
template double half_path_angle(const double&, const double&, const double&);
template DualReal half_path_angle(const DualReal&, const DualReal&, const DualReal&);

template <class Real>
Real BasicToothOnWall<Real>::root_width() const {
  using std::tan;
  return thickness + 2 * dedendum * tan(flank_angle);
}

template struct BasicToothOnWall<double>;
template struct BasicToothOnWall<DualReal>;

template <class Real>
Real tooth_compliance(const BasicToothOnWall<Real>& tooth, const Real& nu) {
  using std::cos, std::log, std::tan;
  const Real tau = tan(tooth.flank_angle);
  const Real c = cos(tooth.flank_angle);
  const Real c2 = c * c;
  const Real B = tooth.root_width();
  const Real x = (tooth.dedendum - tooth.thickness * tau / 2) / B;
  const Real q = tooth.thickness / (B * c2);
  const Real l = tooth.wall / B;
  const Real plane = 1 - nu * nu;
  const Real layer = 2 * plane / pi;
  const Real narrows = log(1 / q);
  const Real bending =
      plane * 3 / (2 * tau * tau * tau) * (narrows - 2 * (1 - q) + (1 - q * q) / 2);
  const Real rocks = x + 0.26;
  // (TC-30): the numbers of the foundation are fitted to plane finite elements.
  return c2 * (bending + 2.4 * (1 + nu) / (2 * tau) * narrows +
               4.84 * rocks * rocks * l / (l + 0.44) - 2.87 * x - 0.54 * q +
               layer * log(1 + 2.12 * l)) +
         (1 - c2) * (plane / (2 * tau) * narrows + layer * log(1 + 6.17 * l));
}
template double tooth_compliance(const BasicToothOnWall<double>&, const double&);
template DualReal tooth_compliance(const BasicToothOnWall<DualReal>&, const DualReal&);

template <class Real>
Real toothed_extension(const BasicToothOnWall<Real>& tooth) {
  const Real B = tooth.root_width();
  const Real pitch = pi * tooth.module;
  // (TC-30): fitted to plane finite elements
  return 1 / (1 - 0.523 * B / pitch * (1 - 1 / (1 + 0.175 * B / tooth.wall)));
}
template double toothed_extension(const BasicToothOnWall<double>&);
template DualReal toothed_extension(const BasicToothOnWall<DualReal>&);

}  // namespace strainwave

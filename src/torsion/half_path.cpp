// SPDX-License-Identifier: Apache-2.0
#include "half_path.hpp"

#include <algorithm>

#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

constexpr int kWallSamples = 20;

/// Velocity of the points of a flank along its normal, per angle of the tooth and times a positive
/// factor.
template <class Real>
class NormalVelocity {
 public:
  NormalVelocity(const BasicHalfPathFlank<Real>& flank,
                 const typename BasicToothMotion<Real>::Moving& moving)
      : flank_(flank), turn_(moving.rate.turn) {
    using std::cos, std::sin;
    const Real c = cos(moving.at.turn);
    const Real s = sin(moving.at.turn);
    across_ = moving.rate.across * c - moving.rate.outward * s;
    outward_ = moving.rate.across * s + moving.rate.outward * c;
  }
  [[nodiscard]] Real operator()(const Real& eta) const {
    using std::cos, std::sin;
    const BasicFlankPoint<Real> at = flank_.point(eta);
    return 2 * sin(eta) * (across_ + turn_ * at.outward) +
           (flank_.stretch - cos(eta)) * (outward_ - turn_ * at.across);  // (TC-29)
  }
  /// Derivative by eta.
  [[nodiscard]] double slope(double eta) const {
    const double c = std::cos(eta);
    const double s = std::sin(eta);
    const double steep = value_of(flank_.stretch) - c;
    const BasicFlankPoint<Real> at = flank_.point(Real(eta));
    return 2 * c * value_of(across_ + turn_ * at.outward) +
           s * value_of(outward_ - turn_ * at.across) +
           value_of(turn_) * value_of(flank_.wave) * (s * s + steep * steep / 4);
  }

 private:
  BasicHalfPathFlank<Real> flank_;
  Real across_{};  // of the section, in the frame of the tooth
  Real outward_{};
  Real turn_{};
};

/// Velocity of a point of a tooth in the frame of the space, per angle of the tooth.
template <class Real>
BasicFlankPoint<Real> velocity(const typename BasicToothMotion<Real>::Moving& moving,
                               const BasicFlankPoint<Real>& point) {
  const BasicFlankPoint<Real> at = placed(moving.at, point);
  return {moving.rate.across + moving.rate.turn * (at.outward - moving.at.outward),
          moving.rate.outward - moving.rate.turn * (at.across - moving.at.across)};
}

}  // namespace

HalfPathWall::HalfPathWall(const BasicTeeth<double>& teeth, const Motion& motion, double end)
    : flank_(half_path_flank(teeth)), motion_(motion), end_(end) {
  // With m > w_0 the flank is hollow next to the pitch height, with m < w_0 it hangs over.
  lowest_ = std::acos(std::min(flank_.stretch, 1 / flank_.stretch));
  // The direction of the wall changes most beside the lobe.
  for (int i = 0; i <= kWallSamples; ++i)
    samples_.push_back(touch(end_ * i * i / (kWallSamples * kWallSamples)));
}

HalfPathWall::Touch HalfPathWall::touch(double t) const {
  const Motion::Moving moving = motion_.moving(t);
  const NormalVelocity<double> normal(flank_, moving);
  constexpr double kStart = 1e-3;  // the velocity at the pitch height itself is 0 with m = w_0
  const double low = std::max(lowest_, kStart);
  const double tip = flank_.tip_path();
  Touch touch{.angle = t, .path = tip, .at_tip = true, .at = {}, .along = {}};
  if (normal(tip) < 0) {
    touch.path = normal(low) > 0 ? bracketed_root(normal, low, tip) : low;
    touch.at_tip = false;
  }
  const Point point = flank_.point(touch.path);
  touch.at = placed(moving.at, point);
  if (touch.at_tip) {
    touch.along = velocity(moving, point);
  } else {
    const double beta = flank_.normal(touch.path) - moving.at.turn;
    touch.along = {std::sin(beta), -std::cos(beta)};
  }
  return touch;
}

HalfPathWall::Nearest HalfPathWall::from(const Motion::Pose& tooth, const Touch& wall) const {
  const double c = std::cos(tooth.turn);
  const double s = std::sin(tooth.turn);
  const double dx = wall.at.across - tooth.across;
  const double dy = wall.at.outward - tooth.outward;
  const Point seen = {dx * c - dy * s, dx * s + dy * c};  // in the frame of the tooth
  // Along the flank toward the tip, times a positive factor.
  const auto ahead = [&](double eta) {
    const Point at = flank_.point(eta);
    return 2 * std::sin(eta) * (seen.outward - at.outward) -
           (flank_.stretch - std::cos(eta)) * (seen.across - at.across);
  };
  constexpr double kStart = 1e-6;
  const double low = std::max(lowest_, kStart);
  const double tip = flank_.tip_path();
  Nearest found{.wall = wall, .path = tip, .at_tip = true, .below = false, .foot = {}, .apart = {}};
  if (ahead(tip) < 0) {
    found.path = ahead(low) > 0 ? bracketed_root(ahead, low, tip) : low;
    found.at_tip = false;
  }
  found.foot = flank_.point(found.path);
  const auto distance = [&](const Point& foot) {
    return length_of(seen.across - foot.across, seen.outward - foot.outward);
  };
  const Point under{flank_.half, std::min(seen.outward, flank_.offset)};
  if (distance(under) < distance(found.foot)) {
    found.foot = under;
    found.below = true;
    found.at_tip = false;
  }
  const Point at = placed(tooth, found.foot);
  found.apart = {wall.at.across - at.across, wall.at.outward - at.outward};
  return found;
}

HalfPathWall::Nearest HalfPathWall::nearest(double t) const {
  const Motion::Pose tooth = motion_.pose(t);
  const auto distance = [](const Nearest& of) {
    return length_of(of.apart.across, of.apart.outward);
  };
  // Down the wall, the distance grows where this is positive.
  const auto grows = [&](double angle) {
    const Nearest at = from(tooth, touch(angle));
    return at.apart.across * at.wall.along.across + at.apart.outward * at.wall.along.outward;
  };
  std::vector<Nearest> all;
  for (const Touch& sample : samples_) all.push_back(from(tooth, sample));
  Nearest best = *std::ranges::min_element(all, {}, distance);
  // The tip and the flank have a least distance each; that of the tip may be the end of the wall.
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool before = i == 0 || distance(all[i]) <= distance(all[i - 1]);
    const bool after = i + 1 == all.size() || distance(all[i]) <= distance(all[i + 1]);
    if (!before || !after) continue;
    const double low = all[i == 0 ? i : i - 1].wall.angle;
    const double high = all[i + 1 == all.size() ? i : i + 1].wall.angle;
    if (!(grows(low) < 0 && grows(high) > 0)) continue;
    const Nearest found = from(tooth, touch(bracketed_root(grows, low, high)));
    if (distance(found) < distance(best)) best = found;
  }
  return best;
}

template <class Real>
BasicFlankContact<Real> BasicHalfPath<Real>::at_tip(double t) const {
  return {.angle = flank_.normal(flank_.tip_path()) - motion_.pose(t).turn,
          .height = flank_.addendum};
}

template <class Real>
BasicFlankContact<Real> BasicHalfPath<Real>::contact(double t) const {
  using std::cos;
  const HalfPathWall::Touch touch = wall_->touch(t);
  if (touch.at_tip && t < wall_->end() / 2) return at_tip(t);
  const typename Motion::Moving moving = motion_.moving(t);
  if (touch.at_tip) {  // the edge sweeps the end of the wall
    const Point along = velocity(moving, flank_.tip());
    return {.angle = angle_of(along.across, Real(-along.outward)), .height = flank_.addendum};
  }
  const NormalVelocity<Real> normal(flank_, moving);
  // One step of Newton's method carries the derivatives.
  const Real path = touch.path - normal(Real(touch.path)) / normal.slope(touch.path);
  return {.angle = flank_.normal(path) - moving.at.turn,
          .height = flank_.wave / 2 * (1 - cos(path))};
}

template <class Real>
Real BasicHalfPath<Real>::distance(double t, const HalfPathWall::Nearest& nearest) const {
  const double apart = length_of(nearest.apart.across, nearest.apart.outward);
  if (apart == 0) return 0.0;
  // Both points may move along their curves without a change of the distance.
  const HalfPathWall::Touch& touch = nearest.wall;
  const Point wall = placed(motion_.pose(touch.angle),
                            touch.at_tip ? flank_.tip() : flank_.point(Real(touch.path)));
  const Point foot =
      placed(motion_.pose(t), nearest.below    ? Point{flank_.half, nearest.foot.outward}
                              : nearest.at_tip ? flank_.tip()
                                               : flank_.point(Real(nearest.path)));
  return (nearest.apart.across * (wall.across - foot.across) +
          nearest.apart.outward * (wall.outward - foot.outward)) /
         apart;
}

template <class Real>
typename BasicHalfPath<Real>::Flanks BasicHalfPath<Real>::at(double t) const {
  if (t >= 0) return {.distance = Real(0.0), .contact = contact(t)};
  const HalfPathWall::Nearest nearest = wall_->nearest(t);
  const bool tip = nearest.at_tip || wall_->touch(-t).at_tip;
  return {.distance = distance(t, nearest), .contact = tip ? at_tip(t) : contact(-t)};
}

template class BasicHalfPath<double>;
template class BasicHalfPath<DualReal>;

}  // namespace strainwave

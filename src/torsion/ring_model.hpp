// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "coupled_geometry.hpp"
#include "flank_shares.hpp"
#include "flexspline_wall.hpp"
#include "strainwave/core/error.hpp"

// Flexspline, outer ring and circular spline as Fourier modes, in templates for double and for dual
// numbers.

namespace Eigen {

/// Vectors of numbers that carry derivatives.
template <std::size_t N>
struct NumTraits<strainwave::Dual<N>> : NumTraits<double> {
  using Real = strainwave::Dual<N>;
  using NonInteger = strainwave::Dual<N>;
  using Nested = strainwave::Dual<N>;
  enum { RequireInitialization = 1 };  // NOLINT(readability-identifier-naming): Eigen's name
};

}  // namespace Eigen

namespace strainwave {

/// Closing of a contact per unit of displacement of the rings at its position.
template <class Real>
struct BasicContactDirection {
  Real radial{};
  Real tangential{};
  Real slope{};  ///< of the wall, w'
  Real spline_radial{};
  Real spline_tangential{};
  Real spline_slope{};

  /// Closing per unit of the n-th amplitude by tilt and shift of the circular spline, whose ring
  /// does not stretch.
  [[nodiscard]] Real spline_turn(int n) const { return n * spline_slope + spline_tangential / n; }
};
using ContactDirection = BasicContactDirection<double>;

/// The direction of a ball: a ring that moves outward opens the contact.
template <class Real>
[[nodiscard]] BasicContactDirection<Real> ball_direction() {
  return {.radial = Real(-1.0)};
}

/// The three directions of which every flank has its shares (TC-6): outward, along the pitch
/// circle, and the change of the latter per unit of height above the pitch circle.  The tooth of
/// the circular spline moves away under the same force.
template <class Real>
[[nodiscard]] std::array<BasicContactDirection<Real>, 3> flank_directions(
    const BasicCoupledGeometry<Real>& g) {
  const bool rigid = !(g.support > 0);
  const Real reach = (g.pitch_radius - g.ring_radius) / g.ring_radius;
  const Real spline_reach =
      rigid ? Real(0.0) : Real((g.pitch_radius - g.spline_radius) / g.spline_radius);
  const Real higher = 1 / g.ring_radius;
  const Real spline_higher = rigid ? Real(0.0) : Real(1 / g.spline_radius);
  return {{{.radial = Real(1.0), .spline_radial = Real(-1.0)},
           {.tangential = 1 + reach,
            .slope = -reach,
            .spline_tangential = -(1 + spline_reach),
            .spline_slope = spline_reach},
           {.tangential = higher,
            .slope = -higher,
            .spline_tangential = -spline_higher,
            .spline_slope = spline_higher}}};
}

/// Closing of a contact by the nominal wave w_0 cos(2 theta) of an inextensional ring.
template <class Real>
[[nodiscard]] Real of_nominal_wave(const BasicContactDirection<Real>& d, double theta,
                                   const Real& amplitude) {
  return amplitude *
         (d.radial * std::cos(2 * theta) - (2 * d.slope + d.tangential / 2) * std::sin(2 * theta));
}

/// Sums of contact forces times the cosines and sines of the harmonics 0 to N: of the balls, and of
/// the flanks with their shares in the three directions.
template <class Real>
struct BasicForceWaves {
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  std::array<Vector, 4> even;
  std::array<Vector, 4> odd;
};

/// Stiffness of one harmonic per unit of amplitude squared, of both phases.
template <class Real>
struct RingMode {
  Real rim_bending{};
  Real outer_bending{};
  Real barrel{};
  Real diaphragm{};
  Real extension{};  // of a + n d
  Real lateral{};    // n = 1
  Real spline{};

  struct Inverse {  // (TC-4): of [[bend + ke, n ke], [n ke, n^2 ke]]
    Real ww{};
    Real wv{};
    Real vv{};
  };
  Inverse inverse;

  [[nodiscard]] Inverse inverted(int n) const {
    if (n == 0) return {.ww = 1 / (extension + rim_bending + outer_bending)};
    if (n == 1) {
      const Real ke = extension;
      const Real kl = lateral;
      const Real det = kl * (kl + 2 * ke);
      const Real ww = (ke + kl) / det;
      return {.ww = ww, .wv = -ke / det, .vv = ww};
    }
    const Real bend = rim_bending + outer_bending + barrel + diaphragm;
    return {.ww = 1 / bend, .wv = -1 / (n * bend), .vv = (1 / extension + 1 / bend) / (n * n)};
  }
};

/// The elastic rings of a drive in their coefficients; the model turns forces of contacts into
/// displacements.
template <class Real>
class RingModel {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Mode = RingMode<Real>;

  /// A length of a ring that a crack softens (TC-22).
  struct Softening {
    RingHinge::Ring ring = RingHinge::Ring::rim;
    Real softening{};  // alpha
    Vector curvature;  // mean curvature over the length, as a row
    Vector response;   // coefficients under a unit of its conjugate
    Real factor{};     // alpha/(1 - alpha curvature.response)
  };

  RingModel(const GearSet& gear, const Lift<Real>& lift, const BasicCoupledGeometry<Real>& geometry,
            const CoupledOptions& options)
      : N_(options.harmonics),
        has_spline_(geometry.support > 0),
        ring_radius_(geometry.ring_radius),
        spline_radius_(geometry.spline_radius),
        ball_(ball_direction<Real>()),
        flanks_(flank_directions(geometry)) {
    make_modes(gear, lift, geometry, options);
  }

  [[nodiscard]] int harmonics() const { return N_; }
  [[nodiscard]] bool has_spline() const { return has_spline_; }
  [[nodiscard]] const Real& ring_radius() const { return ring_radius_; }
  [[nodiscard]] const Real& spline_radius() const { return spline_radius_; }
  [[nodiscard]] const Mode& mode(int n) const { return modes_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const std::vector<Softening>& softenings() const { return softenings_; }
  [[nodiscard]] const BasicContactDirection<Real>& ball() const { return ball_; }
  /// The directions of which flanks have their shares.
  [[nodiscard]] const std::array<BasicContactDirection<Real>, 3>& flanks() const { return flanks_; }
  /// Closing of a flank per unit of rotation.
  [[nodiscard]] Real turn(const BasicFlankShares<Real>& of) const {
    return of.along * flanks_[1].tangential + of.higher * flanks_[2].tangential;
  }
  /// Closing of a flank by the nominal wave.
  [[nodiscard]] Real of_nominal_wave(const BasicFlankShares<Real>& of, double theta,
                                     const Real& amplitude) const {
    return of.outward * strainwave::of_nominal_wave(flanks_[0], theta, amplitude) +
           of.along * strainwave::of_nominal_wave(flanks_[1], theta, amplitude) +
           of.higher * strainwave::of_nominal_wave(flanks_[2], theta, amplitude);
  }

  [[nodiscard]] int at(int n) const { return 4 * n - 3; }  // a_n, b_n, c_n, d_n of the ring
  [[nodiscard]] int spline_at(int n) const { return 1 + 4 * N_ + 2 * (n - 2); }  // a_n, b_n
  [[nodiscard]] int coefficients() const { return 1 + 4 * N_ + (has_spline_ ? 2 * (N_ - 1) : 0); }

  /// Generalised forces of contact forces, by the transposed operation with opposite sign.
  [[nodiscard]] Vector load_of(const BasicForceWaves<Real>& forces) const {
    Vector load = Vector::Constant(coefficients(), Real(0.0));
    for (std::size_t group = 0; group < 4; ++group) {
      const auto& d = group == 0 ? ball_ : flanks_[group - 1];
      const Vector& even = forces.even[group];
      const Vector& odd = forces.odd[group];
      load[0] -= d.radial * even[0];
      for (int n = 1; n <= N_; ++n) {
        const int i = at(n);
        load[i] -= d.radial * even[n] - d.slope * n * odd[n];
        load[i + 1] -= d.radial * odd[n] + d.slope * n * even[n];
        load[i + 2] -= d.tangential * even[n];
        load[i + 3] -= d.tangential * odd[n];
        if (!has_spline_ || n < 2) continue;
        const int j = spline_at(n);
        const Real turn = d.spline_turn(n);
        load[j] -= d.spline_radial * even[n] - turn * odd[n];
        load[j + 1] -= d.spline_radial * odd[n] + turn * even[n];
      }
    }
    return load;
  }

  /// Coefficients under generalised forces (TC-4).
  [[nodiscard]] Vector response_to(const Vector& load) const {
    Vector out = Vector::Constant(coefficients(), Real(0.0));
    out[0] = mode(0).inverse.ww * load[0];
    for (int n = 1; n <= N_; ++n) {
      const Mode& of = mode(n);
      const auto& [ww, wv, vv] = of.inverse;
      const int i = at(n);
      out[i] = ww * load[i] + wv * load[i + 3];
      out[i + 3] = wv * load[i] + vv * load[i + 3];
      out[i + 1] = ww * load[i + 1] - wv * load[i + 2];
      out[i + 2] = -wv * load[i + 1] + vv * load[i + 2];
      if (of.spline > 0) {
        out[spline_at(n)] = load[spline_at(n)] / of.spline;
        out[spline_at(n) + 1] = load[spline_at(n) + 1] / of.spline;
      }
    }
    for (const Softening& soft : softenings_)
      out += (soft.factor * soft.response.dot(load)) * soft.response;  // (TC-22)
    return out;
  }

  /// Generalised force of the mean of w over the lobes: w at 0 and pi, the even cosines.
  [[nodiscard]] Vector lobe_load() const {
    Vector mean = Vector::Constant(coefficients(), Real(0.0));
    mean[0] = Real(1.0);
    for (int n = 2; n <= N_; n += 2) mean[at(n)] = Real(1.0);
    return mean;
  }

  /// Softens a ring by one crack.
  /// @return  whether there is a ring to soften, because a rigid ring cannot bend
  /// @throws SolverError  if hinges of one ring overlap so far that the ring has no stiffness left
  bool soften(const BasicRingHinge<Real>& hinge) {
    using std::cos, std::sin;
    const bool spline = hinge.ring == RingHinge::Ring::spline;
    if (spline && !has_spline_) return false;
    const Real R = spline ? spline_radius_ : ring_radius_;
    Softening soft{.ring = hinge.ring,
                   .softening = hinge.softening,
                   .curvature = Vector::Constant(coefficients(), Real(0.0)),
                   .response = {}};
    for (int n = 2; n <= N_; ++n) {
      const Real half = n * hinge.length / (2 * R);
      const Real amplitude = (1.0 - n * n) / (R * R) * (sin(half) / half);  // (TC-22)
      const int i = spline ? spline_at(n) : at(n);
      const Real angle = n * hinge.position;
      soft.curvature[i] = amplitude * cos(angle);
      soft.curvature[i + 1] = amplitude * sin(angle);
    }
    soft.response = response_to(soft.curvature);
    const Real left = 1 - soft.softening * soft.curvature.dot(soft.response);
    if (!(left > 0))
      throw SolverError(
          "two cracks of a ring soften the same length of the ring and leave no stiffness there "
          "(TC-22); give one crack instead of the two");
    soft.factor = soft.softening / left;
    softenings_.push_back(std::move(soft));
    return true;
  }

 private:
  void make_modes(const GearSet& gear, const Lift<Real>& lift, const BasicCoupledGeometry<Real>& g,
                  const CoupledOptions& options) {
    using std::numbers::pi, std::pow;
    const Real R = g.ring_radius;
    const auto wall = flexspline_wall(*gear.flexspline, lift, R, wall_materials(gear, lift, R),
                                      options.diaphragm_warping);
    modes_.assign(static_cast<std::size_t>(N_) + 1, {});
    modes_[0].extension = 2 * pi * g.extension / R;  // (TC-1)
    modes_[0].rim_bending = 2 * pi * g.rim_bending / (R * R * R);
    modes_[0].outer_bending = 2 * pi * g.outer_bending / (R * R * R);
    for (int n = 1; n <= N_; ++n) {
      Mode& mode = modes_[static_cast<std::size_t>(n)];
      const double n2 = n * n;
      const double bent = (n2 - 1) * (n2 - 1);
      mode.rim_bending = pi * g.rim_bending / (R * R * R) * bent;      // (TC-1)
      mode.outer_bending = pi * g.outer_bending / (R * R * R) * bent;  // (TC-1)
      mode.extension = pi * g.extension / R;                           // (TC-1)
      if (n == 1) {
        mode.lateral = 0.5 * pi * R * wall.barrel.shear / g.barrel_length;  // (TC-2)
        continue;
      }
      const auto along = wall_mode(wall, n);
      mode.barrel = along.barrel;
      mode.diaphragm = along.diaphragm;
      if (g.support > 0)
        mode.spline =
            pi * g.spline_bending / pow(g.spline_radius, 3.0) * bent / g.support;  // (TC-10)
    }
    for (int n = 0; n <= N_; ++n) {
      Mode& mode = modes_[static_cast<std::size_t>(n)];
      mode.inverse = mode.inverted(n);
    }
  }

  int N_ = 0;
  bool has_spline_ = false;
  Real ring_radius_{};
  Real spline_radius_{};
  BasicContactDirection<Real> ball_;
  std::array<BasicContactDirection<Real>, 3> flanks_;
  std::vector<Mode> modes_;  // 0 to N
  std::vector<Softening> softenings_;
};

}  // namespace strainwave

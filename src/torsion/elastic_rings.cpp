// SPDX-License-Identifier: Apache-2.0
#include "elastic_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/torsion/plate_edge.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Up to this harmonic the whole barrel follows its end.  Beyond, the part that follows decreases
/// like 1/n, because short waves stay near the rim.  The number is not derived (TC-2), but the
/// ring's own bending dominates there.
constexpr double kDecay = 2.5;

double sinc(double x) { return std::sin(x) / x; }

/// Mean thickness over the radius; the thickness law of the plate matters little here.
double mean_thickness(const Diaphragm& diaphragm) {
  if (diaphragm.profile.empty()) return diaphragm.thickness;
  constexpr int kPoints = 64;
  const double width = diaphragm.outer_diameter - diaphragm.inner_diameter;
  double h = 0.0;
  for (int i = 0; i < kPoints; ++i)
    h += diaphragm_thickness(diaphragm,
                             (diaphragm.inner_diameter + width * (i + 0.5) / kPoints) / 2) /
         kPoints;
  return h;
}

}  // namespace

Waves::Waves(const std::vector<double>& positions, int harmonics) {
  const Eigen::Map<const Eigen::ArrayXd> angle(positions.data(),
                                               static_cast<Eigen::Index>(positions.size()));
  const Eigen::ArrayXd c = angle.cos();
  const Eigen::ArrayXd s = angle.sin();
  cosine = Eigen::MatrixXd::Ones(angle.size(), harmonics + 1);
  sine = Eigen::MatrixXd::Zero(angle.size(), harmonics + 1);
  for (int n = 1; n <= harmonics; ++n) {  // advanced by one angle
    const auto c_before = cosine.col(n - 1).array();
    const auto s_before = sine.col(n - 1).array();
    cosine.col(n) = c * c_before - s * s_before;
    sine.col(n) = s * c_before + c * s_before;
  }
}

std::vector<double> ContactPlaces::positions() const {
  std::vector<double> positions = balls;
  for (int flank = 0; flank < 2; ++flank)
    for (const int tooth : teeth) positions.push_back((tooth + 0.5) * pitch());
  return positions;
}

ElasticRings::ElasticRings(const GearSet& gear, const CoupledGeometry& geometry,
                           const CoupledOptions& options, const ContactPlaces& places,
                           const ContactDirection& ball, const ContactDirection& drive_flank)
    : N_(options.harmonics),
      has_spline_(geometry.support > 0),
      ring_radius_(geometry.ring_radius),
      spline_radius_(geometry.spline_radius),
      balls_(static_cast<int>(places.balls.size())),
      teeth_(static_cast<int>(places.teeth.size())),
      ball_(ball),
      drive_flank_(drive_flank),
      position_(places.positions()),
      at_balls_({position_.begin(), position_.begin() + balls_}, N_),
      at_teeth_({position_.begin() + balls_, position_.begin() + balls_ + teeth_}, N_) {
  make_modes(gear, geometry, options);
  fill_flexibility(places);
  fill_lobe();
}

void ElasticRings::make_modes(const GearSet& gear, const CoupledGeometry& g,
                              const CoupledOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const double R = g.ring_radius;
  const double L = g.barrel_length;
  const auto& [E, G, nu] = g.rim_steel;
  const double plate = E * std::pow(g.barrel_thickness, 3) / (12 * (1 - nu * nu));
  const ClampedPlate bottom{.outer_radius = fs.diaphragm->outer_diameter / 2,
                            .inner_radius = fs.diaphragm->inner_diameter / 2,
                            .thickness = mean_thickness(*fs.diaphragm),
                            .youngs_modulus = E,
                            .poissons_ratio = nu};
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
      mode.lateral = 0.5 * pi * G * R * g.barrel_thickness / L;  // (TC-2)
      continue;
    }
    const double twist = (n - 1.0 / n) * (n - 1.0 / n);
    mode.barrel = plate * pi * R * (L / 3) *
                  (bent / std::pow(R, 4) + 6 * (1 - nu) * twist / (R * R * L * L)) *
                  std::min(1.0, kDecay / n);  // (TC-2)
    if (options.diaphragm_warping)
      mode.diaphragm = plate_edge_stiffness(bottom, n) * std::pow(R / (n2 * L), 2);  // (TC-2)
    if (g.support > 0)
      mode.spline =
          pi * g.spline_bending / std::pow(g.spline_radius, 3) * bent / g.support;  // (TC-10)
  }
  for (int n = 0; n <= N_; ++n) {
    Mode& mode = modes_[static_cast<std::size_t>(n)];
    mode.inverse = mode.inverted(n);
  }
}

ElasticRings::Mode::Inverse ElasticRings::Mode::inverted(int n) const {
  if (n == 0) return {.ww = 1 / (extension + rim_bending + outer_bending)};
  if (n == 1) {
    const double ke = extension;
    const double kl = lateral;
    const double det = kl * (kl + 2 * ke);
    const double ww = (ke + kl) / det;
    return {.ww = ww, .wv = -ke / det, .vv = ww};
  }
  const double bend = rim_bending + outer_bending + barrel + diaphragm;
  return {.ww = 1 / bend, .wv = -1 / (n * bend), .vv = (1 / extension + 1 / bend) / (n * n)};
}

std::array<ElasticRings::Group, 3> ElasticRings::groups() const {
  return {{{0, at_balls_, ball_},
           {balls_, at_teeth_, drive_flank_},
           {balls_ + teeth_, at_teeth_, drive_flank_.mirrored()}}};
}

Eigen::VectorXd ElasticRings::closings_of(const Eigen::VectorXd& x) const {
  Eigen::VectorXd closings(contacts());
  for (const auto& [first, waves, d] : groups()) {
    Eigen::VectorXd even = Eigen::VectorXd::Zero(N_ + 1);
    Eigen::VectorXd odd = even;
    even[0] = d.radial * x[0];
    for (int n = 1; n <= N_; ++n) {
      const int i = at(n);
      even[n] = d.radial * x[i] + d.slope * n * x[i + 1] + d.tangential * x[i + 2];
      odd[n] = d.radial * x[i + 1] - d.slope * n * x[i] + d.tangential * x[i + 3];
      if (!has_spline_ || n < 2) continue;
      const int j = spline_at(n);
      even[n] += d.spline_radial * x[j] + d.spline_turn(n) * x[j + 1];
      odd[n] += d.spline_radial * x[j + 1] - d.spline_turn(n) * x[j];
    }
    closings.segment(first, waves.cosine.rows()) = waves.cosine * even + waves.sine * odd;
  }
  return closings;
}

Eigen::VectorXd ElasticRings::load_of(const Eigen::VectorXd& force) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(coefficients());
  for (const auto& [first, waves, d] : groups()) {
    const auto of_group = force.segment(first, waves.cosine.rows());
    const Eigen::VectorXd even = waves.cosine.transpose() * of_group;
    const Eigen::VectorXd odd = waves.sine.transpose() * of_group;
    load[0] -= d.radial * even[0];
    for (int n = 1; n <= N_; ++n) {
      const int i = at(n);
      load[i] -= d.radial * even[n] - d.slope * n * odd[n];
      load[i + 1] -= d.radial * odd[n] + d.slope * n * even[n];
      load[i + 2] -= d.tangential * even[n];
      load[i + 3] -= d.tangential * odd[n];
      if (!has_spline_ || n < 2) continue;
      const int j = spline_at(n);
      load[j] -= d.spline_radial * even[n] - d.spline_turn(n) * odd[n];
      load[j + 1] -= d.spline_radial * odd[n] + d.spline_turn(n) * even[n];
    }
  }
  return load;
}

Eigen::VectorXd ElasticRings::response_to(const Eigen::VectorXd& load) const {
  Eigen::VectorXd out(coefficients());
  out[0] = modes_[0].inverse.ww * load[0];
  for (int n = 1; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const auto& [ww, wv, vv] = mode.inverse;
    const int i = at(n);
    out[i] = ww * load[i] + wv * load[i + 3];
    out[i + 3] = wv * load[i] + vv * load[i + 3];
    out[i + 1] = ww * load[i + 1] - wv * load[i + 2];
    out[i + 2] = -wv * load[i + 1] + vv * load[i + 2];
    if (mode.spline > 0) {
      out[spline_at(n)] = load[spline_at(n)] / mode.spline;
      out[spline_at(n) + 1] = load[spline_at(n) + 1] / mode.spline;
    }
  }
  for (const Softening& soft : softenings_)
    out += soft.factor * soft.response.dot(load) * soft.response;  // (TC-22)
  return out;
}

ElasticRings::Kernel ElasticRings::kernel(const ContactDirection& of,
                                          const ContactDirection& by) const {
  Kernel kernel{Eigen::VectorXd(N_ + 1), Eigen::VectorXd(N_ + 1)};
  for (int n = 0; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const auto& [ww, wv, vv] = mode.inverse;
    double even = ww * (of.radial * by.radial + n * n * of.slope * by.slope) -
                  wv * n * (of.slope * by.tangential + of.tangential * by.slope) +
                  vv * of.tangential * by.tangential;
    double odd = ww * n * (of.radial * by.slope - of.slope * by.radial) +
                 wv * (of.tangential * by.radial - of.radial * by.tangential);
    if (mode.spline > 0) {
      const double of_turn = of.spline_turn(n);
      const double by_turn = by.spline_turn(n);
      even += (of.spline_radial * by.spline_radial + of_turn * by_turn) / mode.spline;
      odd += (of.spline_radial * by_turn - of_turn * by.spline_radial) / mode.spline;
    }
    kernel.even[n] = even;
    kernel.odd[n] = odd;
  }
  return kernel;
}

void ElasticRings::fill_flexibility(const ContactPlaces& places) {
  flexibility_.resize(contacts(), contacts());
  const Kernel balls = kernel(ball_, ball_);
  flexibility_.topLeftCorner(balls_, balls_) =
      at_balls_.cosine * (at_balls_.cosine * balls.even.asDiagonal()).transpose() +
      at_balls_.sine * (at_balls_.sine * balls.even.asDiagonal()).transpose();

  // For a ball, a coast flank is equivalent to the drive flank on its other side.
  const Kernel mixed = kernel(ball_, drive_flank_);
  const Eigen::MatrixXd even =
      at_balls_.cosine * (at_teeth_.cosine * mixed.even.asDiagonal()).transpose() +
      at_balls_.sine * (at_teeth_.sine * mixed.even.asDiagonal()).transpose();
  const Eigen::MatrixXd odd =
      at_balls_.sine * (at_teeth_.cosine * mixed.odd.asDiagonal()).transpose() -
      at_balls_.cosine * (at_teeth_.sine * mixed.odd.asDiagonal()).transpose();
  flexibility_.block(0, balls_, balls_, teeth_) = even + odd;
  flexibility_.block(0, balls_ + teeth_, balls_, teeth_) = even - odd;
  flexibility_.bottomLeftCorner(2 * teeth_, balls_) =
      flexibility_.topRightCorner(balls_, 2 * teeth_).transpose();

  // Between teeth only the number of pitches matters.
  std::vector<double> apart;
  for (int k = 0; k < places.pitches; ++k) apart.push_back(k * places.pitch());
  const Waves waves(apart, N_);
  const Kernel like = kernel(drive_flank_, drive_flank_);
  const Kernel facing = kernel(drive_flank_, drive_flank_.mirrored());
  const Eigen::VectorXd like_flanks = waves.cosine * like.even;
  const Eigen::VectorXd drive_by_coast = waves.cosine * facing.even + waves.sine * facing.odd;
  const Eigen::VectorXd coast_by_drive = waves.cosine * facing.even - waves.sine * facing.odd;
  const int drive = balls_;
  const int coast = balls_ + teeth_;
  for (int j = 0; j < teeth_; ++j)
    for (int i = 0; i < teeth_; ++i) {
      const int steps =
          places.teeth[static_cast<std::size_t>(i)] - places.teeth[static_cast<std::size_t>(j)];
      const int k = steps < 0 ? steps + places.pitches : steps;
      flexibility_(drive + i, drive + j) = flexibility_(coast + i, coast + j) = like_flanks[k];
      flexibility_(drive + i, coast + j) = drive_by_coast[k];
      flexibility_(coast + i, drive + j) = coast_by_drive[k];
    }
}

void ElasticRings::fill_lobe() {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(coefficients());
  mean[0] = 1.0;  // mean of w at 0 and pi, that is, the even cosines
  for (int n = 2; n <= N_; n += 2) mean[at(n)] = 1.0;
  lobe_ = -closings_of(response_to(mean));  // by reciprocity
}

ElasticRings ElasticRings::softened(const std::vector<RingHinge>& hinges) const {
  ElasticRings soft_rings = *this;
  for (const RingHinge& hinge : hinges) {
    const bool spline = hinge.ring == RingHinge::Ring::spline;
    if (spline && !has_spline_) continue;  // a rigid ring cannot bend
    const double R = spline ? spline_radius_ : ring_radius_;
    Softening soft{.ring = hinge.ring,
                   .softening = hinge.softening,
                   .curvature = Eigen::VectorXd::Zero(coefficients()),
                   .response = {}};
    for (int n = 2; n <= N_; ++n) {
      const double amplitude =
          (1.0 - n * n) / (R * R) * sinc(n * hinge.length / (2 * R));  // (TC-22)
      const int i = spline ? spline_at(n) : at(n);
      soft.curvature[i] = amplitude * std::cos(n * hinge.position);
      soft.curvature[i + 1] = amplitude * std::sin(n * hinge.position);
    }
    soft.response = soft_rings.response_to(soft.curvature);
    const double left = 1 - soft.softening * soft.curvature.dot(soft.response);
    if (!(left > 0))
      throw SolverError(
          "two cracks of a ring soften the same length of it, which leaves it no stiffness there "
          "(TC-22): give one crack in place of both");
    soft.factor = soft.softening / left;
    const Eigen::VectorXd closings = closings_of(soft.response);
    soft_rings.flexibility_ += soft.factor * closings * closings.transpose();  // (TC-22)
    soft_rings.softenings_.push_back(std::move(soft));
  }
  soft_rings.fill_lobe();
  return soft_rings;
}

double ElasticRings::of_nominal_wave(int contact, double amplitude) const {
  const ContactDirection d = contact < balls_            ? ball_
                             : contact < balls_ + teeth_ ? drive_flank_
                                                         : drive_flank_.mirrored();
  const double theta = position_of(contact);
  return amplitude *
         (d.radial * std::cos(2 * theta) - (2 * d.slope + d.tangential / 2) * std::sin(2 * theta));
}

Eigen::VectorXd ElasticRings::coefficients_of(const Eigen::VectorXd& force) const {
  return response_to(load_of(force));
}

Eigen::VectorXd ElasticRings::closings(const Eigen::VectorXd& force) const {
  std::vector<int> carries;
  for (int i = 0; i < contacts(); ++i)
    if (force[i] != 0) carries.push_back(i);
  const auto made = [&](std::size_t p) { return force[carries[p]] * flexibility_.col(carries[p]); };
  Eigen::VectorXd closings = Eigen::VectorXd::Zero(contacts());
  std::size_t p = 0;
  for (; p + 4 <= carries.size(); p += 4)  // four in one pass keep the sums in registers
    closings -= (made(p) + made(p + 1)) + (made(p + 2) + made(p + 3));
  for (; p < carries.size(); ++p) closings -= made(p);
  return closings;
}

void ElasticRings::add_shares(const Eigen::VectorXd& x,
                              std::array<double, kCurveMembers>& share) const {
  const auto add = [&](CurveMember member, double value) {
    share[static_cast<std::size_t>(member)] += value;
  };
  const auto square = [&](int i) { return x[i] * x[i] + x[i + 1] * x[i + 1]; };
  add(CurveMember::rim_extension, modes_[0].extension * x[0] * x[0]);
  add(CurveMember::rim_bending, modes_[0].rim_bending * x[0] * x[0]);
  add(CurveMember::outer_ring_bending, modes_[0].outer_bending * x[0] * x[0]);
  for (int n = 1; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const int i = at(n);
    const double bent = square(i);
    add(CurveMember::rim_bending, mode.rim_bending * bent);
    add(CurveMember::outer_ring_bending, mode.outer_bending * bent);
    add(CurveMember::barrel_warping, mode.barrel * bent + mode.lateral * (bent + square(i + 2)));
    add(CurveMember::diaphragm_warping, mode.diaphragm * bent);
    add(CurveMember::rim_extension,
        mode.extension * (std::pow(x[i] + n * x[i + 3], 2) + std::pow(x[i + 1] - n * x[i + 2], 2)));
    if (mode.spline > 0) add(CurveMember::circular_spline, mode.spline * square(spline_at(n)));
  }
  for (const Softening& soft : softenings_) {
    const double lost = soft.softening * std::pow(soft.curvature.dot(x), 2);
    add(soft.ring == RingHinge::Ring::rim     ? CurveMember::rim_bending
        : soft.ring == RingHinge::Ring::outer ? CurveMember::outer_ring_bending
                                              : CurveMember::circular_spline,
        -lost);
  }
}

double ElasticRings::radial(const Eigen::VectorXd& x, double theta) const {
  double w = x[0];
  for (int n = 1; n <= N_; ++n)
    w += x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta);
  return w;
}

double ElasticRings::tangential(const Eigen::VectorXd& x, double theta) const {
  double v = 0.0;
  for (int n = 1; n <= N_; ++n)
    v += x[at(n) + 2] * std::cos(n * theta) + x[at(n) + 3] * std::sin(n * theta);
  return v;
}

double ElasticRings::curvature(const Eigen::VectorXd& x, double theta) const {
  const double R2 = ring_radius_ * ring_radius_;
  double kappa = 0.0;  // -(w'' + w)/R^2, positive if the ring bends more
  for (int n = 2; n <= N_; ++n)
    kappa +=
        (n * n - 1.0) / R2 * (x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta));
  return kappa - x[0] / R2;
}

double ElasticRings::hoop_strain(const Eigen::VectorXd& x, double theta) const {
  double strain = x[0];
  for (int n = 1; n <= N_; ++n)
    strain += (x[at(n)] + n * x[at(n) + 3]) * std::cos(n * theta) +
              (x[at(n) + 1] - n * x[at(n) + 2]) * std::sin(n * theta);
  return strain / ring_radius_;
}

}  // namespace strainwave

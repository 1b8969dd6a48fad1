// SPDX-License-Identifier: Apache-2.0
#include "elastic_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strainwave {
namespace {

/// Only half-path flanks have shares in all directions.
template <class Row>
bool absent(const Row& shares) {
  return (shares.array() == 0.0).all();
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

Waves Waves::transposed() const {
  Waves columns = *this;
  columns.cosine = cosine.transpose();
  columns.sine = sine.transpose();
  return columns;
}

std::vector<double> ContactPlaces::positions() const {
  std::vector<double> positions = balls;
  for (int flank = 0; flank < 2; ++flank)
    for (const int tooth : teeth) positions.push_back(position_of(tooth));
  return positions;
}

ElasticRings::ElasticRings(const GearSet& gear, const CoupledGeometry& geometry,
                           const CoupledOptions& options, const ContactPlaces& places,
                           const std::vector<FlankShares>& shares)
    : model_(gear, Lift<double>(), geometry, options),
      balls_(static_cast<int>(places.balls.size())),
      teeth_(static_cast<int>(places.teeth.size())),
      tooth_(places.teeth),
      shares_(3, 2 * teeth_),
      neighbours_(geometry.neighbours),
      position_(places.positions()),
      at_balls_({position_.begin(), position_.begin() + balls_}, options.harmonics),
      at_teeth_({position_.begin() + balls_, position_.begin() + balls_ + teeth_},
                options.harmonics),
      of_tooth_(at_teeth_.transposed()) {
  for (int i = 0; i < 2 * teeth_; ++i) {
    const FlankShares& of = shares[static_cast<std::size_t>(i)];
    shares_.col(i) << of.outward, of.along, of.higher;
  }
  fill_flexibility(places);
  fill_lobe();
}

FlankShares ElasticRings::shares_of(int contact) const {
  const auto of = shares_.col(contact - balls_);
  return {.outward = of[0], .along = of[1], .higher = of[2]};
}

BasicForceWaves<double> ElasticRings::waves_of(const Eigen::VectorXd& force) const {
  BasicForceWaves<double> sums;
  const auto of_balls = force.head(balls_);
  sums.even[0] = at_balls_.cosine.transpose() * of_balls;
  sums.odd[0] = at_balls_.sine.transpose() * of_balls;
  for (std::size_t group = 1; group < 4; ++group) {
    sums.even[group] = sums.odd[group] = Eigen::VectorXd::Zero(model_.harmonics() + 1);
    const auto share = shares_.row(static_cast<Eigen::Index>(group) - 1);
    if (absent(share)) continue;
    for (int j = 0; j < teeth_; ++j) {
      const double of_tooth =
          share[j] * force[balls_ + j] + share[teeth_ + j] * force[balls_ + teeth_ + j];
      if (of_tooth == 0) continue;  // most teeth carry no force
      sums.even[group] += of_tooth * of_tooth_.cosine.col(j);
      sums.odd[group] += of_tooth * of_tooth_.sine.col(j);
    }
  }
  return sums;
}

Eigen::VectorXd ElasticRings::displacements_of(const Eigen::VectorXd& x,
                                               const ContactDirection& of_balls,
                                               const Shares& of_flanks) const {
  const auto in = [&](const ContactDirection& d, const Waves& waves) -> Eigen::VectorXd {
    Eigen::VectorXd even = Eigen::VectorXd::Zero(model_.harmonics() + 1);
    Eigen::VectorXd odd = even;
    even[0] = d.radial * x[0];
    for (int n = 1; n <= model_.harmonics(); ++n) {
      const int i = model_.at(n);
      even[n] = d.radial * x[i] + d.slope * n * x[i + 1] + d.tangential * x[i + 2];
      odd[n] = d.radial * x[i + 1] - d.slope * n * x[i] + d.tangential * x[i + 3];
      if (!model_.has_spline() || n < 2) continue;
      const int j = model_.spline_at(n);
      even[n] += d.spline_radial * x[j] + d.spline_turn(n) * x[j + 1];
      odd[n] += d.spline_radial * x[j + 1] - d.spline_turn(n) * x[j];
    }
    return waves.cosine * even + waves.sine * odd;
  };
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(contacts());
  moved.head(balls_) = in(of_balls, at_balls_);
  for (int k = 0; k < 3; ++k) {
    if (absent(of_flanks.row(k))) continue;
    const Eigen::VectorXd of_teeth = in(model_.flanks()[static_cast<std::size_t>(k)], at_teeth_);
    for (const int first : {0, teeth_})
      moved.segment(balls_ + first, teeth_) +=
          of_flanks.row(k).segment(first, teeth_).transpose().cwiseProduct(of_teeth);
  }
  return moved;
}

ElasticRings::Kernel ElasticRings::kernel(const ContactDirection& of,
                                          const ContactDirection& by) const {
  Kernel kernel{Eigen::VectorXd(model_.harmonics() + 1), Eigen::VectorXd(model_.harmonics() + 1)};
  for (int n = 0; n <= model_.harmonics(); ++n) {
    const RingMode<double>& mode = model_.mode(n);
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
  fill_balls();
  fill_flanks(places);
}

void ElasticRings::fill_balls() {
  const Kernel balls = kernel(model_.ball(), model_.ball());
  flexibility_.topLeftCorner(balls_, balls_) =
      at_balls_.cosine * (at_balls_.cosine * balls.even.asDiagonal()).transpose() +
      at_balls_.sine * (at_balls_.sine * balls.even.asDiagonal()).transpose();
  const auto even = [&](const Eigen::VectorXd& of) -> Eigen::MatrixXd {
    return at_balls_.cosine * (at_teeth_.cosine * of.asDiagonal()).transpose() +
           at_balls_.sine * (at_teeth_.sine * of.asDiagonal()).transpose();
  };
  const auto odd = [&](const Eigen::VectorXd& of) -> Eigen::MatrixXd {
    return at_balls_.sine * (at_teeth_.cosine * of.asDiagonal()).transpose() -
           at_balls_.cosine * (at_teeth_.sine * of.asDiagonal()).transpose();
  };
  flexibility_.rightCols(2 * teeth_).topRows(balls_).setZero();
  for (int k = 0; k < 3; ++k) {
    if (absent(shares_.row(k))) continue;
    const Kernel mixed = kernel(model_.ball(), model_.flanks()[static_cast<std::size_t>(k)]);
    const Eigen::MatrixXd opens = k == 0 ? even(mixed.even) : odd(mixed.odd);
    for (const int first : {0, teeth_})
      flexibility_.block(0, balls_ + first, balls_, teeth_) +=
          opens * shares_.row(k).segment(first, teeth_).asDiagonal();
  }
  flexibility_.bottomLeftCorner(2 * teeth_, balls_) =
      flexibility_.topRightCorner(balls_, 2 * teeth_).transpose();
}

void ElasticRings::fill_flanks(const ContactPlaces& places) {
  // Between teeth only the number of pitches matters.  A radial and a radial force, and forces
  // along the pitch circle, are even in it, a radial force and one along the pitch circle odd.
  std::vector<double> apart;
  for (int k = 0; k < places.pitches; ++k) apart.push_back(k * places.pitch());
  const Waves waves(apart, model_.harmonics());
  const auto& [outward, along, higher] = model_.flanks();
  const auto even = [&](const ContactDirection& of, const ContactDirection& by) -> Eigen::VectorXd {
    return waves.cosine * kernel(of, by).even;
  };
  const auto odd = [&](const ContactDirection& of, const ContactDirection& by) -> Eigen::VectorXd {
    return waves.sine * kernel(of, by).odd;
  };
  const bool has_higher = !absent(shares_.row(2));
  const Eigen::VectorXd along_higher = has_higher ? even(along, higher) : Eigen::VectorXd();
  const Eigen::VectorXd higher_higher = has_higher ? even(higher, higher) : Eigen::VectorXd();
  const Eigen::VectorXd outward_higher = has_higher ? odd(outward, higher) : Eigen::VectorXd();
  struct Table {
    Eigen::VectorXd outward;
    Eigen::VectorXd along;
    Eigen::VectorXd mixed;
  };
  const Table rings{even(outward, outward), even(along, along), odd(outward, along)};
  // With the neighbouring teeth (TC-31), which depend on the sides of both flanks.
  const auto table = [&](int of_side, int by_side) {
    Table sum = rings;
    for (int k = 0; neighbours_ && k < places.pitches; ++k) {
      const auto moved = neighbours_->between({k, of_side}, {0, by_side});
      sum.outward[k] += moved.outward;
      sum.along[k] += moved.along;
      sum.mixed[k] += moved.mixed;
    }
    return sum;
  };
  const auto fill = [&](int of_first, int by_first, const Table& by) {
    const bool same = of_first == by_first;
    for (int j = 0; j < teeth_; ++j) {
      const auto b = shares_.col(by_first + j);
      for (int i = same ? j : 0; i < teeth_; ++i) {
        const auto a = shares_.col(of_first + i);
        const int steps = tooth_[static_cast<std::size_t>(i)] - tooth_[static_cast<std::size_t>(j)];
        const int k = steps < 0 ? steps + places.pitches : steps;
        double opens = a[0] * b[0] * by.outward[k] + a[1] * b[1] * by.along[k] +
                       (a[0] * b[1] - a[1] * b[0]) * by.mixed[k];
        if (has_higher)
          opens += (a[1] * b[2] + a[2] * b[1]) * along_higher[k] + a[2] * b[2] * higher_higher[k] +
                   (a[0] * b[2] - a[2] * b[0]) * outward_higher[k];
        flexibility_(balls_ + of_first + i, balls_ + by_first + j) = opens;
        flexibility_(balls_ + by_first + j, balls_ + of_first + i) = opens;  // Maxwell
      }
    }
  };
  const Table like = table(+1, +1);
  fill(0, 0, like);
  fill(teeth_, teeth_, like);
  fill(0, teeth_, table(+1, -1));
}

FlankPlace ElasticRings::flank(int contact) const {
  const bool drive = contact < balls_ + teeth_;
  const int place = contact - balls_ - (drive ? 0 : teeth_);
  return {.tooth = tooth_[static_cast<std::size_t>(place)], .side = drive ? 1 : -1};
}

double ElasticRings::neighbour_energy(const Eigen::VectorXd& force) const {
  double energy = 0.0;
  if (!neighbours_) return energy;
  struct Loaded {
    FlankPlace place;
    FlankShares force;  // of the contact, by its directions
  };
  std::vector<Loaded> loaded;
  for (int i = balls_; i < contacts(); ++i)
    if (force[i] != 0) {
      const FlankShares shares = shares_of(i);
      loaded.push_back(
          {flank(i), {.outward = force[i] * shares.outward, .along = force[i] * shares.along}});
    }
  for (std::size_t p = 0; p < loaded.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)  // Maxwell; a flank is no neighbour of itself
      energy += 2 * neighbours_->between(loaded[p].place, loaded[q].place)
                        .opening(loaded[p].force, loaded[q].force);
  return energy;
}

void ElasticRings::fill_lobe() {
  lobe_ = -closings_of(model_.response_to(model_.lobe_load()));  // by reciprocity
}

ElasticRings ElasticRings::softened(const std::vector<RingHinge>& hinges) const {
  ElasticRings soft_rings = *this;
  for (const RingHinge& hinge : hinges) {
    if (!soft_rings.model_.soften(hinge)) continue;
    const auto& soft = soft_rings.model_.softenings().back();
    const Eigen::VectorXd closings = closings_of(soft.response);
    soft_rings.flexibility_ += soft.factor * closings * closings.transpose();  // (TC-22)
  }
  soft_rings.fill_lobe();
  return soft_rings;
}

double ElasticRings::of_nominal_wave(int contact, double amplitude) const {
  const double theta = position_of(contact);
  return contact < balls_ ? strainwave::of_nominal_wave(model_.ball(), theta, amplitude)
                          : model_.of_nominal_wave(shares_of(contact), theta, amplitude);
}

Eigen::VectorXd ElasticRings::coefficients_of(const Eigen::VectorXd& force) const {
  return model_.response_to(model_.load_of(waves_of(force)));
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
  add(CurveMember::rim_extension, model_.mode(0).extension * x[0] * x[0]);
  add(CurveMember::rim_bending, model_.mode(0).rim_bending * x[0] * x[0]);
  add(CurveMember::outer_ring_bending, model_.mode(0).outer_bending * x[0] * x[0]);
  for (int n = 1; n <= model_.harmonics(); ++n) {
    const RingMode<double>& mode = model_.mode(n);
    const int i = model_.at(n);
    const double bent = square(i);
    add(CurveMember::rim_bending, mode.rim_bending * bent);
    add(CurveMember::outer_ring_bending, mode.outer_bending * bent);
    add(CurveMember::barrel_warping, mode.barrel * bent + mode.lateral * (bent + square(i + 2)));
    add(CurveMember::diaphragm_warping, mode.diaphragm * bent);
    add(CurveMember::rim_extension,
        mode.extension * (std::pow(x[i] + n * x[i + 3], 2) + std::pow(x[i + 1] - n * x[i + 2], 2)));
    if (mode.spline > 0)
      add(CurveMember::circular_spline, mode.spline * square(model_.spline_at(n)));
  }
  for (const auto& soft : model_.softenings()) {
    const double lost = soft.softening * std::pow(soft.curvature.dot(x), 2);
    add(soft.ring == RingHinge::Ring::rim     ? CurveMember::rim_bending
        : soft.ring == RingHinge::Ring::outer ? CurveMember::outer_ring_bending
                                              : CurveMember::circular_spline,
        -lost);
  }
}

double ElasticRings::radial(const Eigen::VectorXd& x, double theta) const {
  double w = x[0];
  for (int n = 1; n <= model_.harmonics(); ++n)
    w += x[model_.at(n)] * std::cos(n * theta) + x[model_.at(n) + 1] * std::sin(n * theta);
  return w;
}

double ElasticRings::tangential(const Eigen::VectorXd& x, double theta) const {
  double v = 0.0;
  for (int n = 1; n <= model_.harmonics(); ++n)
    v += x[model_.at(n) + 2] * std::cos(n * theta) + x[model_.at(n) + 3] * std::sin(n * theta);
  return v;
}

double ElasticRings::curvature(const Eigen::VectorXd& x, double theta) const {
  const double R2 = model_.ring_radius() * model_.ring_radius();
  double kappa = 0.0;  // -(w'' + w)/R^2, positive if the ring bends more
  for (int n = 2; n <= model_.harmonics(); ++n)
    kappa += (n * n - 1.0) / R2 *
             (x[model_.at(n)] * std::cos(n * theta) + x[model_.at(n) + 1] * std::sin(n * theta));
  return kappa - x[0] / R2;
}

double ElasticRings::spline_curvature(const Eigen::VectorXd& x, double theta) const {
  if (!model_.has_spline()) return 0.0;
  double kappa = 0.0;
  for (int n = 2; n <= model_.harmonics(); ++n) {
    const int i = model_.spline_at(n);
    kappa += (n * n - 1.0) * (x[i] * std::cos(n * theta) + x[i + 1] * std::sin(n * theta));
  }
  return kappa / (model_.spline_radius() * model_.spline_radius());
}

double ElasticRings::HoopForce::at(double theta) const {
  double force = 0.0;
  for (int n = 2; n < cosine.size(); ++n)
    force += cosine[n] * std::cos(n * theta) + sine[n] * std::sin(n * theta);
  return force;
}

ElasticRings::HoopForce ElasticRings::spline_hoop_force(const Eigen::VectorXd& force) const {
  HoopForce hoop{.cosine = Eigen::VectorXd::Zero(model_.harmonics() + 1),
                 .sine = Eigen::VectorXd::Zero(model_.harmonics() + 1)};
  if (!model_.has_spline()) return hoop;
  const BasicForceWaves<double> waves = waves_of(force);
  for (std::size_t group = 1; group < 4; ++group) {
    // A flank pushes its place of the ring against the direction in which it closes.
    const double along = -model_.flanks()[group - 1].spline_tangential;
    for (int n = 2; n <= model_.harmonics(); ++n) {
      const double per_wave = along / (n * std::numbers::pi);
      hoop.cosine[n] += per_wave * waves.odd[group][n];  // (TC-39)
      hoop.sine[n] -= per_wave * waves.even[group][n];   // (TC-39)
    }
  }
  return hoop;
}

double ElasticRings::hoop_strain(const Eigen::VectorXd& x, double theta) const {
  double strain = x[0];
  for (int n = 1; n <= model_.harmonics(); ++n)
    strain += (x[model_.at(n)] + n * x[model_.at(n) + 3]) * std::cos(n * theta) +
              (x[model_.at(n) + 1] - n * x[model_.at(n) + 2]) * std::sin(n * theta);
  return strain / model_.ring_radius();
}

}  // namespace strainwave

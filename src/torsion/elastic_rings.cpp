// SPDX-License-Identifier: Apache-2.0
#include "elastic_rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>

#include "columns.hpp"

namespace strainwave {
namespace {

/// Only half-path flanks have shares in all directions.
template <class Row>
bool absent(const Row& shares) {
  return (shares.array() == 0.0).all();
}

}  // namespace

Waves::Waves(const std::vector<double>& positions, int harmonics)
    : Waves(std::ssize(positions), harmonics) {
  for (Eigen::Index i = 0; i < cosine.cols(); ++i) {
    const double angle = positions[static_cast<std::size_t>(i)];
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    cosine(0, i) = 1.0;
    sine(0, i) = 0.0;
    for (int n = 1; n <= harmonics; ++n) {  // advanced by one angle
      cosine(n, i) = c * cosine(n - 1, i) - s * sine(n - 1, i);
      sine(n, i) = s * cosine(n - 1, i) + c * sine(n - 1, i);
    }
  }
}

HalfPitches::HalfPitches(int pitches)
    : cosine_(2 * static_cast<std::size_t>(pitches)), sine_(cosine_.size()) {
  const auto turn = cosine_.size();
  const std::size_t half = turn / 2;
  for (std::size_t k = 0; k <= half / 2; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(turn);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (const std::size_t at : {k, turn - k}) {  // both sides of 0
      cosine_[at % turn] = c;
      sine_[at % turn] = at == k ? s : -s;
    }
    for (const std::size_t at : {half - k, half + k}) {  // both sides of half a turn
      cosine_[at] = -c;
      sine_[at] = at == half - k ? s : -s;
    }
  }
  sine_[0] = sine_[half] = 0.0;
}

std::vector<double> ContactPlaces::positions() const {
  std::vector<double> positions = balls;
  for (int flank = 0; flank < 2; ++flank)
    for (const int tooth : teeth) positions.push_back(position_of(tooth));
  return positions;
}

ElasticRings::ElasticRings(const GearSet& gear, const CoupledGeometry& geometry,
                           const CoupledOptions& options, const ContactPlaces& places,
                           const std::vector<FlankShares>& shares, const HalfPitches& angles)
    : model_(gear, Lift<double>(), geometry, options),
      balls_(static_cast<int>(places.balls.size())),
      teeth_(static_cast<int>(places.teeth.size())),
      tooth_(places.teeth),
      shares_(3, 2 * teeth_),
      neighbours_(geometry.neighbours),
      position_(places.positions()),
      at_balls_({position_.begin(), position_.begin() + balls_}, options.harmonics),
      at_teeth_(angles.waves(teeth_, options.harmonics, [&](Eigen::Index i) {
        return 2 * tooth_[static_cast<std::size_t>(i)] + 1;
      })) {
  for (int i = 0; i < 2 * teeth_; ++i) {
    const FlankShares& of = shares[static_cast<std::size_t>(i)];
    shares_.col(i) << of.outward, of.along, of.higher;
  }
  fill_flexibility(places, angles);
  fill_lobe();
}

FlankShares ElasticRings::shares_of(int contact) const {
  const auto of = shares_.col(contact - balls_);
  return {.outward = of[0], .along = of[1], .higher = of[2]};
}

BasicForceWaves<double> ElasticRings::waves_of(const Eigen::VectorXd& force) const {
  BasicForceWaves<double> sums;
  std::vector<int> carries;  // most contacts carry no force
  std::vector<double> of_each;
  carries.reserve(position_.size());
  of_each.reserve(position_.size());
  const auto sum = [&](const Eigen::MatrixXd& waves) {
    Eigen::VectorXd total = Eigen::VectorXd::Zero(waves.rows());
    subtract_columns(
        total.data(), total.size(), std::ssize(carries),
        [&](Eigen::Index p) {
          return waves.data() + carries[static_cast<std::size_t>(p)] * waves.rows();
        },
        [&](Eigen::Index p) { return -of_each[static_cast<std::size_t>(p)]; });
    return total;
  };
  const auto carry = [&](int place, double value) {
    if (value == 0) return;
    carries.push_back(place);
    of_each.push_back(value);
  };
  for (int k = 0; k < balls_; ++k) carry(k, force[k]);
  sums.even[0] = sum(at_balls_.cosine);
  sums.odd[0] = sum(at_balls_.sine);
  for (std::size_t group = 1; group < 4; ++group) {
    carries.clear();
    of_each.clear();
    const auto share = shares_.row(static_cast<Eigen::Index>(group) - 1);
    for (int j = 0; j < teeth_; ++j)
      carry(j, share[j] * force[balls_ + j] + share[teeth_ + j] * force[balls_ + teeth_ + j]);
    sums.even[group] = sum(at_teeth_.cosine);
    sums.odd[group] = sum(at_teeth_.sine);
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
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(waves.cosine.cols());
    if (!absent(even)) moves.noalias() += waves.cosine.transpose() * even;
    if (!absent(odd)) moves.noalias() += waves.sine.transpose() * odd;
    return moves;
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

void ElasticRings::fill_flexibility(const ContactPlaces& places, const HalfPitches& angles) {
  flexibility_.resize(contacts(), contacts());
  fill_balls(places);
  fill_flanks(places, angles);
}

Eigen::MatrixXd ElasticRings::balls_by_teeth(const Eigen::VectorXd& kernel, bool odd,
                                             const ContactPlaces& places) const {
  // An even kernel is cos cos + sin sin of ball and tooth, an odd one sin cos - cos sin.  A mirror
  // of the tooth at the lobe changes the sign of the second product.  With an even number of teeth
  // there is a tooth half a turn away, for which the odd harmonics change their signs.
  const Eigen::Index sides = places.pitches % 2 == 0 ? 2 : 1;
  const Eigen::Index half = teeth_ / sides;
  const Eigen::Index base = (half + 1) / 2;
  // With a ball at the lobe the balls have the mirror too.
  const bool mirrored = position_.front() == 0.0;
  const Eigen::Index balls = mirrored ? balls_ / 2 + 1 : balls_;
  const auto products = [&](const Eigen::MatrixXd& of_balls, const Eigen::MatrixXd& of_teeth) {
    std::array<Eigen::MatrixXd, 2> sums;  // of all harmonics at a tooth, and half a turn away
    for (Eigen::Index side = 0; side < sides; ++side) {
      const Eigen::Index rows = (kernel.size() - side + sides - 1) / sides;
      Eigen::MatrixXd weighted(rows, balls);
      Eigen::MatrixXd waves(rows, base);
      for (Eigen::Index n = 0; n < rows; ++n) {
        const Eigen::Index harmonic = side + sides * n;
        weighted.row(n) = kernel[harmonic] * of_balls.row(harmonic).head(balls);
        waves.row(n) = of_teeth.row(harmonic).head(base);
      }
      const Eigen::MatrixXd sum = weighted.transpose() * waves;
      if (side == 0)
        sums = {sum, sum};
      else
        sums = {sums[0] + sum, sums[1] - sum};
    }
    return sums;
  };
  const auto even = products(odd ? at_balls_.sine : at_balls_.cosine, at_teeth_.cosine);
  const auto second = products(odd ? at_balls_.cosine : at_balls_.sine, at_teeth_.sine);
  const double sign = odd ? -1.0 : 1.0;
  Eigen::MatrixXd opens(balls_, teeth_);
  auto of_balls = opens.topRows(balls);
  of_balls.leftCols(base) = even[0] + sign * second[0];
  of_balls.rightCols(base) = (even[0] - sign * second[0]).rowwise().reverse();
  if (sides == 2) {
    of_balls.middleCols(half - base, base) = (even[1] - sign * second[1]).rowwise().reverse();
    of_balls.middleCols(half, base) = even[1] + sign * second[1];
  }
  for (Eigen::Index k = balls; k < balls_; ++k)
    opens.row(k) = sign * opens.row(balls_ - k).reverse();
  return opens;
}

void ElasticRings::fill_balls(const ContactPlaces& places) {
  const Eigen::VectorXd balls =
      HalfPitches(balls_)
          .waves(balls_, model_.harmonics(), [](Eigen::Index k) { return 2 * k; })
          .cosine.transpose() *
      kernel(model_.ball(), model_.ball()).even;
  for (int i = 0; i < balls_; ++i)
    for (int k = 0; k < balls_; ++k) flexibility_(i, k) = balls[std::abs(i - k)];
  flexibility_.rightCols(2 * teeth_).topRows(balls_).setZero();
  for (int k = 0; k < 3; ++k) {
    if (absent(shares_.row(k))) continue;
    const Kernel mixed = kernel(model_.ball(), model_.flanks()[static_cast<std::size_t>(k)]);
    const Eigen::MatrixXd opens = balls_by_teeth(k == 0 ? mixed.even : mixed.odd, k > 0, places);
    for (const int first : {0, teeth_})
      flexibility_.block(0, balls_ + first, balls_, teeth_) +=
          opens * shares_.row(k).segment(first, teeth_).asDiagonal();
  }
  flexibility_.bottomLeftCorner(2 * teeth_, balls_) =
      flexibility_.topRightCorner(balls_, 2 * teeth_).transpose();
}

void ElasticRings::fill_flanks(const ContactPlaces& places, const HalfPitches& angles) {
  // Between teeth only the number of pitches matters.  A radial and a radial force, and forces
  // along the pitch circle, are even in it, a radial force and one along the pitch circle odd.
  const int turn = places.pitches;
  const int half = turn / 2;
  const Waves waves =
      angles.waves(half + 1, model_.harmonics(), [](Eigen::Index k) { return 2 * k; });
  const auto& [outward, along, higher] = model_.flanks();
  // The closing over the pitches between two teeth, from -(turn - 1) to turn - 1.
  using Table = Eigen::ArrayXd;
  const auto table = [&](const Eigen::MatrixXd& of_waves, const Eigen::VectorXd& kernel,
                         double sign) -> Table {
    const Eigen::VectorXd first = of_waves.transpose() * kernel;
    Table over(2 * turn - 1);
    for (int k = 0; k < turn; ++k) {
      const double value = k <= half ? first[k] : sign * first[turn - k];
      over[turn - 1 + k] = value;
      over[turn - 1 - k] = sign * value;
    }
    return over;
  };
  const auto even = [&](const ContactDirection& of, const ContactDirection& by) {
    return table(waves.cosine, kernel(of, by).even, 1.0);
  };
  const auto odd = [&](const ContactDirection& of, const ContactDirection& by) {
    return table(waves.sine, kernel(of, by).odd, -1.0);
  };
  const bool has_higher = !absent(shares_.row(2));
  const Table along_higher = has_higher ? even(along, higher) : Table();
  const Table higher_higher = has_higher ? even(higher, higher) : Table();
  const Table outward_higher = has_higher ? odd(outward, higher) : Table();
  struct Tables {
    Table outward;
    Table along;
    Table mixed;
  };
  const Tables rings{even(outward, outward), even(along, along), odd(outward, along)};
  // With the neighbouring teeth (TC-31), which depend on the sides of both flanks.
  const auto tables = [&](int of_side, int by_side) {
    Tables sum = rings;
    if (!neighbours_) return sum;
    for (int k = 0; k < turn; ++k) {
      const auto moved = neighbours_->between({k, of_side}, {0, by_side});
      for (const int at : {turn - 1 + k, k - 1})  // both are k pitches ahead
        if (at >= 0) {
          sum.outward[at] += moved.outward;
          sum.along[at] += moved.along;
          sum.mixed[at] += moved.mixed;
        }
    }
    return sum;
  };
  std::vector<ContactRun> runs;  // of teeth side by side
  for (int i = 0; i < teeth_; ++i) {
    if (i == 0 || number(i) != number(i - 1) + 1) runs.push_back({.first = i, .count = 0});
    ++runs.back().count;
  }
  const Eigen::ArrayX3d shares = shares_.transpose();
  // All flanks but half paths of a side have the same shares, so one table serves a whole block.
  const auto alike = [&](int first) {
    const auto of_side = shares.middleRows(first, teeth_);
    return (of_side.colwise().minCoeff() == of_side.colwise().maxCoeff()).all();
  };
  const bool one_table = teeth_ > 0 && !has_higher && alike(0) && alike(teeth_);
  const auto fill = [&](int of_first, int by_first, const Tables& by) {
    Table block;
    if (one_table) {
      const auto a = shares.row(of_first);
      const auto b = shares.row(by_first);
      block = a[0] * b[0] * by.outward + a[1] * b[1] * by.along +
              (a[0] * b[1] - a[1] * b[0]) * by.mixed;
    }
    for (int j = 0; j < teeth_; ++j) {
      const auto b = shares_.col(by_first + j);
      for (const ContactRun& run : runs) {
        const int steps = number(run.first) - number(j) + turn - 1;
        const auto at = [&](const Table& of) { return of.segment(steps, run.count); };
        auto opens = flexibility_.col(balls_ + by_first + j)
                         .segment(balls_ + of_first + run.first, run.count)
                         .array();
        if (one_table) {
          opens = at(block);
          continue;
        }
        const auto a = [&](int k) {
          return shares.col(k).segment(of_first + run.first, run.count);
        };
        opens = a(0) * (b[0] * at(by.outward) + b[1] * at(by.mixed)) +
                a(1) * (b[1] * at(by.along) - b[0] * at(by.mixed));
        if (has_higher)
          opens += a(0) * (b[2] * at(outward_higher)) + a(1) * (b[2] * at(along_higher)) +
                   a(2) * (b[1] * at(along_higher) + b[2] * at(higher_higher) -
                           b[0] * at(outward_higher));
      }
    }
  };
  const Tables like = tables(+1, +1);
  fill(0, 0, like);
  fill(teeth_, teeth_, like);
  fill(0, teeth_, tables(+1, -1));
  flexibility_.block(balls_ + teeth_, balls_, teeth_, teeth_) =  // Maxwell
      flexibility_.block(balls_, balls_ + teeth_, teeth_, teeth_).transpose();
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
  loaded.reserve(position_.size());
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

Eigen::VectorXd ElasticRings::closings(const Eigen::VectorXd& force,
                                       const std::vector<ContactRun>& of) const {
  std::vector<int> carries;
  carries.reserve(position_.size());
  for (int i = 0; i < contacts(); ++i)
    if (force[i] != 0) carries.push_back(i);
  const auto contact = [&](Eigen::Index p) { return carries[static_cast<std::size_t>(p)]; };
  Eigen::VectorXd closings = Eigen::VectorXd::Zero(contacts());
  for (const ContactRun& run : of)
    subtract_columns(
        closings.data() + run.first, run.count, std::ssize(carries),
        [&](Eigen::Index p) {
          return flexibility_.data() + contact(p) * flexibility_.rows() + run.first;
        },
        [&](Eigen::Index p) { return force[contact(p)]; });
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

// SPDX-License-Identifier: Apache-2.0
#include "twist_cycle.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/core/multiple_angle.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr int kLargestRule = 48;            // points of one Gauss rule
constexpr double kPointsPerWave = 0.6;      // of a piece, per harmonic and radian
constexpr double kLeastPoints = 10;         // of a piece
constexpr double kBendPerStep = 1.0 / 32;   // n A |change|/F_c of one step of (MO-8)
constexpr double kNearZero = 0.1;           // z/F_c
constexpr double kStands = 1e-14;           // slope of the saturated hysteresis, over A
constexpr int kMostTwistSteps = 60;         // of Newton's method in a piece of a table
constexpr double kExactCycleTwist = 4e-16;  // of the twist from the end of the piece
constexpr double kSaturated = 60.0;         // A |change|/F_c behind which z does not change
/// The hysteresis is saturated behind these changes of the twist, over F_c/A.
constexpr std::array<double, 2> kSaturation = {8.0, 32.0};

struct GaussRule {
  std::vector<double> point;
  std::vector<double> weight;
};

/// Rule of n rising points on [-1, 1].
GaussRule gauss_rule(int n) {
  GaussRule rule;
  const auto add = [&](double x) {
    const double slope = boost::math::legendre_p_prime(n, x);
    rule.point.push_back(x);
    rule.weight.push_back(2 / ((1 - x * x) * slope * slope));
  };
  const std::vector<double> zeros = boost::math::legendre_p_zeros<double>(n);  // those from 0 on
  for (auto zero = zeros.rbegin(); zero != zeros.rend(); ++zero)
    if (*zero > 0) add(-*zero);
  for (const double zero : zeros) add(zero);
  return rule;
}

const GaussRule& rule_of(int n) {
  static const std::vector<GaussRule> rules = [] {
    std::vector<GaussRule> made(2);
    for (int k = 2; k <= kLargestRule; ++k) made.push_back(gauss_rule(k));
    return made;
  }();
  return rules[static_cast<std::size_t>(n)];
}

/// x^n for x >= 0; whole n are products.
double power_of(double x, double n) {
  if (n > 8 || n != std::floor(n)) return std::pow(x, n);
  double power = 1.0;
  for (int k = 0; k < static_cast<int>(n); ++k) power *= x;
  return power;
}

/// The way of y < 0 to zero with dy/dq = 1 + r |y|^n.
struct BendRange {
  double to_zero = 0.0;           ///< q
  double at_zero_by_start = 1.0;  ///< derivative of y, at the q of the zero, by y at the start
};
BendRange range_to_zero(double y, double r, double n) {
  const double size = -y;
  if (n == 1)
    return {.to_zero = r == 0 ? size : std::log1p(r * size) / r,
            .at_zero_by_start = 1 / (1 + r * size)};
  const GaussRule& rule = rule_of(24);
  BendRange range{.at_zero_by_start = 1 / (1 + r * std::pow(size, n))};
  for (std::size_t k = 0; k < rule.point.size(); ++k)
    range.to_zero +=
        size / 2 * rule.weight[k] / (1 + r * std::pow(size / 2 * (1 + rule.point[k]), n));
  return range;
}

/// Root of a function that changes its sign between two angles, by Newton's steps inside the
/// bracket.
/// @param f  angle -> {value, slope}
template <class Function>
double polished_root(const Function& f, double low, double high) {
  const bool rises = f(high).first > 0;
  double at = (low + high) / 2;
  for (int step = 0; step < 80; ++step) {
    const auto [value, slope] = f(at);
    if (value == 0) return at;
    ((value > 0) == rises ? high : low) = at;
    const double newton = at - value / slope;
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    const double change = std::abs(next - at);
    at = next;
    if (change < 1e-14) break;
  }
  return at;
}

}  // namespace

void ElasticCurve::take_cracks(const std::vector<BreathingCrack>& cracks) {
  for (const BreathingCrack& crack : cracks) {
    // A crack that opens over an angle is open for the mean of it.
    const double share = crack.opening ? crack.opening->coefficients.front() : 1.0;
    if (!crack.sense || *crack.sense == OpeningSense::positive)
      forward_ += share * crack.compliance;  // (MO-5)
    if (!crack.sense || *crack.sense == OpeningSense::negative)
      backward_ += share * crack.compliance;  // (MO-5)
  }
}

ElasticCurve::ElasticCurve(const Spring& spring, const std::vector<BreathingCrack>& cracks)
    : spring_(spring) {
  take_cracks(cracks);
  for (const double size : corner_torques(spring)) {
    corners_.push_back(twist_under(size));
    corners_.push_back(twist_under(-size));
  }
  if (forward_ != backward_) corners_.push_back(0.0);
  std::ranges::sort(corners_);
}

ElasticCurve::ElasticCurve(const EnergyTable::Slice& slice, const std::vector<double>& torques,
                           const std::vector<BreathingCrack>& cracks) {
  take_cracks(cracks);
  // The sense of the torque changes inside a piece of the table.
  std::vector<double> ends = torques;
  if (!std::ranges::binary_search(ends, 0.0)) ends.insert(std::ranges::upper_bound(ends, 0.0), 0.0);
  for (const double torque : ends) {
    const EnergyTable::At at = slice.at_torque(torque);
    nodes_.push_back({.torque = torque,
                      .twist = at.twist + (torque < 0 ? backward_ : forward_) * torque,  // (MO-28)
                      .below = at.compliance + (torque > 0 ? forward_ : backward_),
                      .above = at.compliance + (torque < 0 ? backward_ : forward_)});
    corners_.push_back(nodes_.back().twist);
  }
}

/// The twist is a cubic of the torque between two nodes, and linear beyond the last ones (MO-26).
ElasticCurve::At ElasticCurve::on_nodes(double twist) const {
  const auto next = std::ranges::upper_bound(nodes_, twist, {}, &Node::twist);
  if (next == nodes_.begin())
    return {.torque = next->torque + (twist - next->twist) / next->below,
            .tangent = 1 / next->below};
  const Node& from = *std::prev(next);
  if (next == nodes_.end())
    return {.torque = from.torque + (twist - from.twist) / from.above, .tangent = 1 / from.above};
  const double h = next->torque - from.torque;
  const double chord = (next->twist - from.twist) / h;
  const double third = (from.above + next->below - 2 * chord) / (h * h);
  const double second = (3 * chord - 2 * from.above - next->below) / h;
  const double asked = twist - from.twist;
  double low = 0.0;
  double high = h;
  double t = asked / chord;
  double slope = chord;
  for (int step = 0; step < kMostTwistSteps; ++step) {
    const double missing = asked - t * (from.above + t * (second + t * third));  // (MO-28)
    slope = from.above + t * (2 * second + t * 3 * third);
    if (std::abs(missing) <= kExactCycleTwist * std::abs(asked)) break;
    (missing > 0 ? low : high) = t;
    double better = t + missing / slope;
    if (!(better >= low && better <= high)) better = low + (high - low) / 2;
    if (better == t) break;
    t = better;
  }
  return {.torque = from.torque + t, .tangent = 1 / slope};
}

ElasticCurve::At ElasticCurve::at(double twist) const {
  if (!nodes_.empty()) return on_nodes(twist);
  const double compliance = twist < 0 ? backward_ : forward_;
  const SpringState state = in_series(spring_, twist, compliance);
  const double tangent = tangent_stiffness(spring_, state.twist);
  return {.torque = state.torque, .tangent = tangent / (1 + compliance * tangent)};  // (MO-1)
}

ElasticCurve::Sides ElasticCurve::tangents_under(double torque) const {
  if (torque != 0) {
    // A load often is a torque at which the lines of a maker meet, such as T2.  Rounding must not
    // choose one of them.
    constexpr double kBeside = 1e-9;
    return {.below = at(twist_under(torque * (1 - kBeside))).tangent,
            .above = at(twist_under(torque * (1 + kBeside))).tangent};
  }
  if (!nodes_.empty()) {
    const Node& zero = *std::ranges::lower_bound(nodes_, 0.0, {}, &Node::torque);
    return {.below = 1 / zero.below, .above = 1 / zero.above};
  }
  const double tangent = tangent_stiffness(spring_, 0.0);
  return {.below = tangent / (1 + backward_ * tangent),
          .above = tangent / (1 + forward_ * tangent)};  // (MO-1)
}

double ElasticCurve::twist_under(double torque) const {
  if (!nodes_.empty()) {
    const auto next = std::ranges::lower_bound(nodes_, torque, {}, &Node::torque);
    if (next == nodes_.begin()) return next->twist + (torque - next->torque) * next->below;
    const Node& from = *std::prev(next);
    if (next == nodes_.end()) return from.twist + (torque - from.torque) * from.above;
    const double h = next->torque - from.torque;
    const double t = torque - from.torque;
    const double chord = (next->twist - from.twist) / h;
    return from.twist +
           t * (from.above + t * ((3 * chord - 2 * from.above - next->below) / h +
                                  t * (from.above + next->below - 2 * chord) / (h * h)));
  }
  if (torque == 0) return 0.0;
  double far = torque / at(0.0).tangent;
  while (std::abs(at(far).torque) < std::abs(torque)) far *= 2;
  return bracketed_root([&](double twist) { return at(twist).torque - torque; }, std::min(0.0, far),
                        std::max(0.0, far));
}

TwistSeries::At TwistSeries::at(double angle) const {
  MultipleAngle multiple(angle);
  At sum{.value = coefficients(0)};
  const Eigen::Index terms = even ? coefficients.size() - 1 : (coefficients.size() - 1) / 2;
  for (Eigen::Index k = 1; k <= terms; ++k) {
    multiple.next();
    const double cosine = multiple.cosine();
    const double sine = multiple.sine();
    const double a = coefficients(even ? k : 2 * k - 1);
    const double b = even ? 0.0 : coefficients(2 * k);
    const auto order = static_cast<double>(k);
    const double term = a * cosine + b * sine;
    sum.value += term;
    sum.slope += order * (b * cosine - a * sine);
    sum.curvature -= order * order * term;
  }
  return sum;
}

double loop_slope(const BoucWen& model, double torque, double sense) {
  return sense * model.rate(torque, sense);  // (MO-8)
}

double loop_bend(const BoucWen& model, double torque, double sense) {
  const double n = model.exponent;
  const double power = n == 1 ? 1.0 : std::pow(std::abs(torque) / model.limit, n - 1);
  const double along = (1 - model.asymmetry) * sense + model.asymmetry * (torque < 0 ? -1.0 : 1.0);
  return -model.stiffness / model.limit * n * power * along;  // (MO-8)
}

LoopStep loop_after(const BoucWen& model, double torque, double change) {
  if (change == 0) return {.torque = torque};
  const double n = model.exponent;
  if (n == 1 && model.asymmetry == 0)
    return {.torque = dahl_after(model, torque, change),
            .by_torque = std::exp(-model.stiffness * std::abs(change) / model.limit)};  // (MO-9)
  // In y = z/F_c to the side of the change, over q = A |change|/F_c:
  // dy/dq = 1 + r |y|^n for y < 0, and 1 - y^n behind zero (MO-8).
  const double sense = change > 0 ? 1.0 : -1.0;
  const double r = 1 - 2 * model.asymmetry;
  double y = sense * torque / model.limit;
  double left = std::min(std::abs(change) * model.stiffness / model.limit, kSaturated);
  double by_torque = 1.0;
  if (y < 0) {
    const BendRange range = range_to_zero(y, r, n);
    if (range.to_zero <= left) {
      by_torque = range.at_zero_by_start;
      left -= range.to_zero;
      y = 0.0;
    }
  }
  if (n == 2) {  // y' = 1 + r y^2 before zero and 1 - y^2 behind it
    const double before = y;
    if (y >= 0) {
      const double t = std::tanh(left);
      y = (y + t) / (1 + y * t);
      by_torque *= (1 - t * t) / ((1 + before * t) * (1 + before * t));
    } else {
      const double root = std::sqrt(r);
      y = r == 0 ? y + left : std::tan(std::atan(root * y) + root * left) / root;
      by_torque *= (1 + r * y * y) / (1 + r * before * before);
    }
    return {.torque = sense * model.limit * y, .by_torque = by_torque};
  }
  if (n == 1) {
    const double rate = y < 0 ? r : 1.0;  // y' = 1 - rate y
    by_torque *= std::exp(-rate * left);
    y = rate == 0 ? y + left : 1 / rate + (y - 1 / rate) * std::exp(-rate * left);
    return {.torque = sense * model.limit * y, .by_torque = by_torque};
  }
  const double way = y < 0 ? r : -1.0;
  const auto slope = [&](double at) { return 1 + way * power_of(std::abs(at), n); };
  const auto bend = [&](double at) {
    return way * n * power_of(std::abs(at), n - 1) * (at < 0 ? -1.0 : 1.0);
  };
  // A power that is not whole has no third derivative at zero.
  const bool whole = n == std::floor(n);
  double exponent = 0.0;
  while (left > 0) {
    const double longest = kBendPerStep / n;
    const double h = std::min(left, !whole && std::abs(y) < kNearZero ? longest / 16 : longest);
    left -= h;
    const double k1 = slope(y);
    if (k1 < kStands) return {.torque = sense * model.limit * y, .by_torque = 0.0};
    const double y2 = y + h / 2 * k1;
    const double k2 = slope(y2);
    const double y3 = y + h / 2 * k2;
    const double k3 = slope(y3);
    const double y4 = y + h * k3;
    const double k4 = slope(y4);
    exponent += h / 6 * (bend(y) + 2 * bend(y2) + 2 * bend(y3) + bend(y4));
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {.torque = sense * model.limit * y, .by_torque = by_torque * std::exp(exponent)};
}

TwistCycle::TwistCycle(const ElasticCurve& elastic, const std::optional<BoucWen>& loop,
                       int harmonics, bool even, std::vector<SlipElement> slip)
    : elastic_(elastic), loop_(loop), slip_(std::move(slip)), harmonics_(harmonics), even_(even) {
  const Eigen::Index H = harmonics;
  size_ = even ? H + 1 : 2 * H + 1;
  const Eigen::Index grid = std::max<Eigen::Index>(64, 8 * H);
  // Only half of an even period is looked at.
  const Eigen::Index rows = even ? grid / 2 + 1 : grid;
  grid_slopes_ = Eigen::MatrixXd::Zero(rows, size_);
  for (Eigen::Index j = 0; j < rows; ++j)
    for (Eigen::Index k = 1; k <= H; ++k) {
      const auto order = static_cast<double>(k);
      const double angle = 2 * pi * static_cast<double>(j * k % grid) / static_cast<double>(grid);
      grid_slopes_(j, even ? k : 2 * k - 1) = -order * std::sin(angle);
      if (!even) grid_slopes_(j, 2 * k) = order * std::cos(angle);
    }
  const Eigen::Index nodes = std::max<Eigen::Index>(64, (6 * H + 7) / 8 * 8);
  uniform_basis_.resize(even ? nodes / 2 + 1 : nodes, size_);
  for (Eigen::Index j = 0; j < uniform_basis_.rows(); ++j)
    uniform_basis_.row(j) =
        basis(2 * pi * static_cast<double>(j) / static_cast<double>(nodes)).transpose();
}

Eigen::VectorXd TwistCycle::basis(double angle) const {
  Eigen::VectorXd row(size_);
  row(0) = 1.0;
  MultipleAngle multiple(angle);
  for (Eigen::Index k = 1; k <= harmonics_; ++k) {
    multiple.next();
    row(even_ ? k : 2 * k - 1) = multiple.cosine();
    if (!even_) row(2 * k) = multiple.sine();
  }
  return row;
}

double TwistCycle::crossing(double level, double from, double to) const {
  const TwistSeries series{x_, even_};
  return polished_root(
      [&](double angle) {
        const TwistSeries::At at = series.at(angle);
        return std::pair(at.value - level, at.slope);
      },
      from, to);
}

/// Breaks from a turn of the twist to the next, without the end.
void TwistCycle::add_levels(std::size_t turn, double to) {
  const double from = turns_[turn];
  const double first = turn_twists_[turn];
  const double last = turn_twists_[(turn + 1) % turn_twists_.size()];
  const bool rises = last > first;
  breaks_.push_back({.angle = from, .twist = first, .turn = turn});
  const double low = std::min(first, last);
  const double high = std::max(first, last);
  levels_.clear();
  const auto add = [&](double level) {
    if (level > low && level < high) levels_.push_back(level);
  };
  for (const double corner : elastic_.corners()) add(corner);
  if (loop_)
    for (const double change : kSaturation)
      add(first + (rises ? 1 : -1) * change * loop_->limit / loop_->stiffness);
  for (std::size_t j = 0; j < slip_.size(); ++j) {
    const double torque = slip_at_turns_[turn].torque[j];
    const double left = rises ? slip_[j].limit - torque : -slip_[j].limit - torque;
    if (left != 0) add(first + left / slip_[j].stiffness);  // (MO-44)
  }
  std::ranges::sort(levels_);
  if (!rises) std::ranges::reverse(levels_);
  double after = from;
  for (const double level : levels_) {
    after = crossing(level, after, to);
    breaks_.push_back({.angle = after, .twist = level, .turn = turn});
  }
}

/// The periodic state of the slip elements at each turn: each element that slips bears its limit at
/// the largest twist, and the others bear nothing in the middle of the range (MO-44).
void TwistCycle::follow_slip() {
  slip_at_turns_.clear();
  slipped_at_.clear();
  slips_ = 0;
  if (slip_.empty()) return;
  const std::size_t turns = turn_twists_.size();
  slip_at_turns_.resize(turns);
  slipped_at_.resize(turns);
  SlipState& top = slip_at_turns_[highest_turn_];
  top.twist = turn_twists_[highest_turn_];
  for (const SlipElement& of : slip_) {
    const double sticking = of.stiffness * amplitude_;
    const bool slips = of.limit < sticking;
    top.torque.push_back(slips ? of.limit : sticking);
    slipped_at_[highest_turn_].push_back(slips ? highest_turn_ : turns);
    slips_ += slips ? 1 : 0;
  }
  for (std::size_t n = 1; n < turns; ++n) {
    const std::size_t before = (highest_turn_ + n - 1) % turns;
    const std::size_t here = (highest_turn_ + n) % turns;
    slip_at_turns_[here] = slip_after(slip_, slip_at_turns_[before], turn_twists_[here]);
    slipped_at_[here] = slipped_at_[before];
    for (std::size_t j = 0; j < slip_.size(); ++j) {
      if (slipped_at_[here][j] == turns) continue;
      if (std::abs(slip_at_turns_[here].torque[j]) < slip_[j].limit) continue;
      slipped_at_[here][j] = here;
      ++slips_;
    }
  }
}

void TwistCycle::place_slip() {
  slip_pieces_.clear();
  if (slip_.empty()) return;
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const CycleBreak& from = breaks_[i];
    const SlipState& turn = slip_at_turns_[from.turn];
    SlipPiece piece{.torque = slip_torque(slip_, turn, from.twist),
                    .since = std::vector<double>(turn_twists_.size() + 1, 0.0)};
    // An element that slips bears its limit in the middle of the piece.
    const SlipState middle = slip_after(slip_, turn, (from.twist + breaks_[i + 1].twist) / 2);
    for (std::size_t j = 0; j < slip_.size(); ++j) {
      const std::size_t last = slipped_at_[from.turn][j];
      if (last < turn_twists_.size() && std::abs(middle.torque[j]) >= slip_[j].limit) continue;
      piece.stiffness += slip_[j].stiffness;
      piece.since[last] += slip_[j].stiffness;
    }
    slip_pieces_.push_back(std::move(piece));
  }
}

void TwistCycle::find_breaks() {
  turns_.clear();
  turn_twists_.clear();
  breaks_.clear();
  slip_at_turns_.clear();
  slips_ = 0;
  amplitude_ = 0.0;
  amplitude_slope_.setZero(size_);
  const TwistSeries series{x_, even_};
  const auto turn_between = [&](double low, double high) {
    return polished_root(
        [&](double angle) {
          const TwistSeries::At at = series.at(angle);
          return std::pair(at.slope, at.curvature);
        },
        low, high);
  };
  const Eigen::VectorXd slope = grid_slopes_ * x_;
  const Eigen::Index rows = slope.size();
  const double step =
      even_ ? pi / static_cast<double>(rows - 1) : 2 * pi / static_cast<double>(rows);
  if (even_) {
    turns_.push_back(0.0);
    // The slope is zero at both ends, so the outer intervals have no sign.
    for (Eigen::Index j = 1; j + 2 < rows; ++j)
      if ((slope(j) < 0) != (slope(j + 1) < 0))
        turns_.push_back(
            turn_between(static_cast<double>(j) * step, static_cast<double>(j + 1) * step));
    turns_.push_back(pi);
  } else {
    for (Eigen::Index j = 0; j < rows; ++j)
      if ((slope(j) < 0) != (slope((j + 1) % rows) < 0))
        turns_.push_back(
            turn_between(static_cast<double>(j) * step, static_cast<double>(j + 1) * step));
  }
  if (turns_.size() < 2) return;
  for (const double turn : turns_) turn_twists_.push_back(series.at(turn).value);
  lowest_turn_ =
      static_cast<std::size_t>(std::ranges::min_element(turn_twists_) - turn_twists_.begin());
  highest_turn_ =
      static_cast<std::size_t>(std::ranges::max_element(turn_twists_) - turn_twists_.begin());
  const double lowest = turn_twists_[lowest_turn_];
  const double highest = turn_twists_[highest_turn_];
  amplitude_ = (highest - lowest) / 2;
  amplitude_slope_ = (basis(turns_[highest_turn_]) - basis(turns_[lowest_turn_])) / 2;
  follow_slip();
  torque_amplitude_ = (elastic_.at(highest).torque - elastic_.at(lowest).torque) / 2;
  const bool bent = std::ranges::any_of(
      elastic_.corners(), [&](double corner) { return corner > lowest && corner < highest; });
  if (!loop_ && slip_.empty() && !bent) return;  // smooth over the whole period
  for (std::size_t i = 0; i + 1 < turns_.size(); ++i) add_levels(i, turns_[i + 1]);
  if (!even_) add_levels(turns_.size() - 1, turns_.front() + 2 * pi);
  breaks_.push_back({.angle = even_ ? pi : turns_.front() + 2 * pi,
                     .twist = even_ ? turn_twists_.back() : turn_twists_.front()});
}

void TwistCycle::place_nodes() {
  nodes_.clear();
  // A mean over half of an even period is that over the whole.
  const double period = even_ ? pi : 2 * pi;
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const double length = breaks_[i + 1].angle - breaks_[i].angle;
    const double points = kLeastPoints + kPointsPerWave * harmonics_ * length;
    const int parts = static_cast<int>(std::ceil(points / kLargestRule));
    const GaussRule& rule = rule_of(static_cast<int>(std::ceil(points / parts)));
    const double half = length / parts / 2;
    for (int part = 0; part < parts; ++part) {
      const double middle = breaks_[i].angle + (2 * part + 1) * half;
      for (std::size_t k = 0; k < rule.point.size(); ++k)
        nodes_.push_back({.angle = middle + half * rule.point[k],
                          .weight = half * rule.weight[k] / period,
                          .piece = i});
    }
  }
}

/// The periodic z at each break: a cycle of any z shrinks the distance from it.
void TwistCycle::close_loop() {
  if (!loop_ || breaks_.empty()) return;
  breaks_.front().loop = 0.0;
  for (int round = 0; round < 50; ++round) {
    double shrinks = 1.0;
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
      const LoopStep step =
          loop_after(*loop_, breaks_[i].loop, breaks_[i + 1].twist - breaks_[i].twist);
      breaks_[i + 1].loop = step.torque;
      shrinks *= step.by_torque;
    }
    const double gap = breaks_.back().loop - breaks_.front().loop;
    if (std::abs(gap) <= 1e-14 * loop_->limit || !(shrinks < 1)) break;
    const double next = breaks_.front().loop + gap / (1 - shrinks);
    breaks_.front().loop = std::clamp(next, -loop_->limit, loop_->limit);
  }
}

/// Without memory, the torque is the largest and the least where the twist is.
void TwistCycle::measure_torque() {
  if ((!loop_ && slip_.empty()) || breaks_.empty()) return;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (std::size_t i = 0; i < breaks_.size(); ++i) {
    const CycleBreak& at = breaks_[i];
    const double torque = elastic_.at(at.twist).torque + at.loop +
                          (slip_.empty() ? 0.0 : slip_pieces_[i % slip_pieces_.size()].torque);
    lowest = std::min(lowest, torque);
    highest = std::max(highest, torque);
  }
  torque_amplitude_ = (highest - lowest) / 2;
}

/// The rate of an asymmetric loop has a corner where z is zero.
void TwistCycle::split_where_loop_is_zero() {
  if (!loop_ || loop_->asymmetry == 0) return;
  std::vector<CycleBreak> split;
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const CycleBreak& from = breaks_[i];
    const CycleBreak& to = breaks_[i + 1];
    split.push_back(from);
    const double sense = to.twist > from.twist ? 1.0 : -1.0;
    if (!(sense * from.loop < 0 && sense * to.loop > 0)) continue;
    const BendRange range =
        range_to_zero(sense * from.loop / loop_->limit, 1 - 2 * loop_->asymmetry, loop_->exponent);
    const double level = from.twist + sense * range.to_zero * loop_->limit / loop_->stiffness;
    if (!(sense * (to.twist - level) > 0)) continue;
    split.push_back(
        {.angle = crossing(level, from.angle, to.angle), .twist = level, .turn = from.turn});
  }
  if (!breaks_.empty()) split.push_back(breaks_.back());
  breaks_ = std::move(split);
}

void TwistCycle::fill_basis() {
  if (breaks_.empty()) {
    basis_ = uniform_basis_;
    return;
  }
  const auto rows = static_cast<Eigen::Index>(nodes_.size());
  basis_.resize(rows, size_);
  for (Eigen::Index n = 0; n < rows; ++n) {
    const double angle = nodes_[static_cast<std::size_t>(n)].angle;
    MultipleAngle multiple(angle);
    basis_(n, 0) = 1.0;
    for (Eigen::Index k = 1; k <= harmonics_; ++k) {
      multiple.next();
      basis_(n, even_ ? k : 2 * k - 1) = multiple.cosine();
      if (!even_) basis_(n, 2 * k) = multiple.sine();
    }
  }
}

void TwistCycle::sum_up() {
  const Eigen::Index rows = basis_.rows();
  twist_.noalias() = basis_ * x_;
  at_nodes_.resize(rows);
  weighted_ = basis_;
  const bool with_loop = loop_ && !breaks_.empty();
  // A twist that stands still meets the hysteresis as a spring.
  const double standing = loop_ && breaks_.empty() ? loop_->stiffness : 0.0;
  const bool with_slip = !slip_pieces_.empty();
  Eigen::VectorXd stiffness(rows);
  for (Eigen::Index n = 0; n < rows; ++n) {
    const ElasticCurve::At elastic = elastic_.at(twist_(n));
    at_nodes_(n) = elastic.torque;
    stiffness(n) = elastic.tangent + standing;
    if (with_slip) {
      const std::size_t i = nodes_[static_cast<std::size_t>(n)].piece;
      const SlipPiece& piece = slip_pieces_[i];
      at_nodes_(n) += piece.torque + piece.stiffness * (twist_(n) - breaks_[i].twist);  // (MO-44)
      stiffness(n) += piece.stiffness;
    }
    double weight = 0.0;
    if (!breaks_.empty()) {
      weight = nodes_[static_cast<std::size_t>(n)].weight;
    } else if (even_) {
      weight = (n == 0 || n == rows - 1 ? 0.5 : 1.0) / static_cast<double>(rows - 1);
    } else {
      weight = 1.0 / static_cast<double>(rows);
    }
    weighted_.row(n) *= 2 * weight;
    weighted_(n, 0) *= 0.5;
  }
  slopes_ = stiffness.asDiagonal() * basis_;
  if (with_slip) {
    // An element that sticks bears k times the twist since the turn at which it slipped last, or
    // since the middle of the range.
    const auto turns = static_cast<Eigen::Index>(turns_.size());
    Eigen::MatrixXd at_turns(turns + 1, size_);
    for (Eigen::Index t = 0; t < turns; ++t)
      at_turns.row(t) = basis(turns_[static_cast<std::size_t>(t)]).transpose();
    at_turns.row(turns) = (at_turns.row(static_cast<Eigen::Index>(lowest_turn_)) +
                           at_turns.row(static_cast<Eigen::Index>(highest_turn_))) /
                          2;
    Eigen::RowVectorXd at_begin(size_);
    std::size_t piece = slip_pieces_.size();
    for (Eigen::Index n = 0; n < rows; ++n) {
      const std::size_t here = nodes_[static_cast<std::size_t>(n)].piece;
      if (here != piece) {
        piece = here;
        at_begin.setZero();
        for (Eigen::Index t = 0; t <= turns; ++t)
          at_begin += slip_pieces_[piece].since[static_cast<std::size_t>(t)] * at_turns.row(t);
      }
      slopes_.row(n) -= at_begin;
    }
  } else if (!slip_.empty()) {
    // A small vibration meets sticking elements, whose middle moves with the mean.
    double sum = 0.0;
    for (const SlipElement& of : slip_) sum += of.stiffness;
    slopes_.rightCols(size_ - 1) += sum * basis_.rightCols(size_ - 1);
  }
  if (with_loop) {
    // z at a fixed angle depends on the twist there and at each angle before, round the cycle.
    Eigen::MatrixXd of_loop(rows, size_);
    Eigen::VectorXd of_start(rows);
    const Eigen::VectorXd first = basis(breaks_.front().angle);
    Eigen::RowVectorXd by_twist = Eigen::RowVectorXd::Zero(size_);
    Eigen::RowVectorXd before = first.transpose();
    double by_start = 1.0;
    double z = breaks_.front().loop;
    double angle_twist = breaks_.front().twist;
    std::size_t piece = 0;
    double sense = breaks_[1].twist > breaks_[0].twist ? 1.0 : -1.0;
    const auto step_to = [&](double twist, const auto& row) {
      const LoopStep step = loop_after(*loop_, z, twist - angle_twist);
      z = step.torque;
      by_twist = step.by_torque * by_twist + loop_slope(*loop_, z, sense) * (row - before);
      by_start *= step.by_torque;
      before = row;
      angle_twist = twist;
    };
    const auto end_piece = [&] {
      ++piece;
      const CycleBreak& at = breaks_[piece];
      const Eigen::RowVectorXd row = basis(at.angle).transpose();
      step_to(at.twist, row);
      if (piece + 1 < breaks_.size()) sense = breaks_[piece + 1].twist > at.twist ? 1.0 : -1.0;
    };
    for (Eigen::Index n = 0; n < rows; ++n) {
      while (piece < nodes_[static_cast<std::size_t>(n)].piece) end_piece();
      step_to(twist_(n), basis_.row(n));
      at_nodes_(n) += z;
      of_loop.row(n) = by_twist;
      of_start(n) = by_start;
    }
    while (piece + 1 < breaks_.size()) end_piece();
    // z at the start is that at the end.
    if (by_start < 1) of_loop += of_start * (by_twist / (1 - by_start));
    slopes_ += of_loop;
  }
  torque_.noalias() = weighted_.transpose() * at_nodes_;
  by_twist_.noalias() = weighted_.transpose() * slopes_;
}

void TwistCycle::evaluate(const Eigen::VectorXd& coefficients) {
  x_ = coefficients;
  torque_amplitude_ = 0.0;
  find_breaks();
  close_loop();
  split_where_loop_is_zero();
  place_slip();
  measure_torque();
  place_nodes();
  fill_basis();
  sum_up();
}

/// The last break before tau = 0.
std::size_t TwistCycle::break_before_zero() const {
  // The period of the breaks begins at a turn in (0, 2 pi).
  const double angle = breaks_.front().angle > 0 ? 2 * pi : 0.0;
  std::size_t i = 0;
  while (i + 2 < breaks_.size() && breaks_[i + 1].angle <= angle) ++i;
  return i;
}

double TwistCycle::loop_at_zero() const {
  if (!loop_ || breaks_.empty()) return 0.0;
  const CycleBreak& before = breaks_[break_before_zero()];
  const double twist = TwistSeries{x_, even_}.at(0.0).value;
  return loop_after(*loop_, before.loop, twist - before.twist).torque;
}

SlipState TwistCycle::slip_at_zero() const {
  const double twist = TwistSeries{x_, even_}.at(0.0).value;
  if (slip_.empty() || breaks_.empty()) return relaxed(slip_, twist);
  return slip_after(slip_, slip_at_turns_[breaks_[break_before_zero()].turn], twist);
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/harmonic_balance.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "strainwave/core/error.hpp"
#include "twist_cycle.hpp"

namespace strainwave {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int kMostHarmonics = 200;
constexpr int kMostIterations = 14;
constexpr double kSmallStep = 1e-9;       // of Newton's last step, over the size of the solution
constexpr int kMostHalvings = 14;         // of a step of a continuation
constexpr double kFirstStep = 0.02;       // of the relative length of a curve
constexpr double kStraight = 0.97;        // cosine between the tangents of two points
constexpr double kAtCorner = 2e-3;        // length of a step over a corner of a curve
constexpr double kTurnTolerance = 1e-9;   // of a rate along the curve at a fold or a peak
constexpr double kStable = 1 + 1e-6;      // largest magnitude of a multiplier
constexpr double kStepsOfPeriod = 64;     // of the variational equation
constexpr double kLeastStepsOfPiece = 4;  // the same in each smooth piece

/// The spring of a joint, or its table where the input stands at its start (MO-28).
ElasticCurve elastic_curve(const Joint& joint) {
  if (joint.table) return {joint.table->at(0.0), joint.table->torques(), joint.cracks};
  return {joint.spring, joint.cracks};
}

/// The two ends of a joint without the drive, seen by the twist (MO-15).
class Ends {
 public:
  Ends(const Joint& joint, VibratingInput input)
      : joint_(joint),
        locked_(input == VibratingInput::locked),
        square_(joint.ratio * joint.ratio) {}

  /// Receptances' inverses a of the input, at the output, and b of the output, with derivatives by
  /// s.
  struct End {
    Complex value;
    Complex slope;
  };
  [[nodiscard]] End input(Complex s) const {
    return {square_ * s * (joint_.input_inertia * s + joint_.input_damping),
            square_ * (2.0 * joint_.input_inertia * s + joint_.input_damping)};
  }
  [[nodiscard]] End output(Complex s) const {
    return {s * (joint_.output_inertia * s + joint_.output_damping),
            2.0 * joint_.output_inertia * s + joint_.output_damping};
  }
  /// D + s c: torque per twist that the ends and the damping need.
  [[nodiscard]] End stiffness(Complex s) const {
    const End b = output(s);
    End sum = b;
    if (!locked_) {
      const End a = input(s);
      sum.value = a.value * b.value / (a.value + b.value);  // (MO-15)
      const Complex to_a = sum.value / a.value;
      const Complex to_b = sum.value / b.value;
      sum.slope = to_a * to_a * a.slope + to_b * to_b * b.slope;
    }
    sum.value += joint_.damping * s;  // (MO-15)
    sum.slope += joint_.damping;
    return sum;
  }
  /// E of (MO-15) per torque at an end.
  [[nodiscard]] End excitation(JointEnd end, Complex s) const {
    if (locked_) return {-1.0, 0.0};
    const End a = input(s);
    const End b = output(s);
    const Complex sum = a.value + b.value;
    const Complex turn = (a.slope * b.value - a.value * b.slope) / (sum * sum);
    if (end == JointEnd::load) return {-a.value / sum, -turn};    // (MO-15)
    return {joint_.ratio * b.value / sum, -joint_.ratio * turn};  // (MO-15)
  }
  /// Inertia of the twist without damping [kg*m^2].
  [[nodiscard]] double inertia() const {
    if (locked_) return joint_.output_inertia;
    const double input = square_ * joint_.input_inertia;
    return input * joint_.output_inertia / (input + joint_.output_inertia);
  }
  [[nodiscard]] bool locked() const { return locked_; }
  [[nodiscard]] double input_at_output() const { return square_ * joint_.input_inertia; }

 private:
  const Joint& joint_;
  bool locked_ = false;
  double square_ = 0.0;  ///< of the ratio
};

/// Harmonics of the twist's equation without excitation, and their derivatives.
class Balance {
 public:
  /// @param undamped  without damping and hysteresis, with an even series
  Balance(const Joint& joint, const BalanceSettings& settings, bool undamped)
      : ends(joint, settings.input),
        elastic(elastic_curve(joint)),
        cycle(elastic, undamped ? std::optional<BoucWen>() : joint.hysteresis, settings.harmonics,
              undamped, undamped ? std::vector<SlipElement>() : joint.slip_elements),
        mean_torque_(-settings.load_torque),
        undamped_(undamped) {}

  void evaluate(const Eigen::VectorXd& x, double omega) {
    cycle.evaluate(x);
    residual = cycle.torque();
    by_twist = cycle.by_twist();
    by_omega.setZero(x.size());
    residual(0) -= mean_torque_;  // (MO-15)
    const Eigen::Index terms = undamped_ ? x.size() - 1 : (x.size() - 1) / 2;
    for (Eigen::Index k = 1; k <= terms; ++k) {
      const auto order = static_cast<double>(k);
      if (undamped_) {
        const double stiffness = -ends.inertia() * order * order * omega * omega;
        residual(k) += stiffness * x(k);  // (MO-16)
        by_twist(k, k) += stiffness;
        by_omega(k) = 2 * stiffness / omega * x(k);
        continue;
      }
      const Ends::End at = ends.stiffness(Complex(0, order * omega));
      const Complex slope = Complex(0, order) * at.slope;
      const Eigen::Index c = 2 * k - 1;
      const Eigen::Index s = 2 * k;
      residual(c) += at.value.real() * x(c) + at.value.imag() * x(s);  // (MO-15)
      residual(s) += at.value.real() * x(s) - at.value.imag() * x(c);  // (MO-15)
      by_twist(c, c) += at.value.real();
      by_twist(c, s) += at.value.imag();
      by_twist(s, c) -= at.value.imag();
      by_twist(s, s) += at.value.real();
      by_omega(c) = slope.real() * x(c) + slope.imag() * x(s);
      by_omega(s) = slope.real() * x(s) - slope.imag() * x(c);
    }
  }

  Ends ends;
  ElasticCurve elastic;
  TwistCycle cycle;
  Eigen::VectorXd residual;
  Eigen::MatrixXd by_twist;
  Eigen::VectorXd by_omega;

 private:
  double mean_torque_ = 0.0;
  bool undamped_ = false;
};

/// Share of the last two harmonics in the kinetic energy of the twist.
double last_share(const Eigen::VectorXd& x, bool even) {
  const Eigen::Index terms = even ? x.size() - 1 : (x.size() - 1) / 2;
  double all = 0.0;
  double last = 0.0;
  for (Eigen::Index k = 1; k <= terms; ++k) {
    const double a = x(even ? k : 2 * k - 1);
    const double b = even ? 0.0 : x(2 * k);
    const auto order = static_cast<double>(k);
    const double energy = order * order * (a * a + b * b);
    all += energy;
    if (k > 1 && k + 2 > terms) last += energy;
  }
  return all > 0 ? last / all : 0.0;  // (MO-15)
}

/// Size of the vibration without the mean.
double vibration_size(const Eigen::VectorXd& x) { return x.tail(x.size() - 1).norm(); }

std::vector<double> all_terms(const Eigen::VectorXd& x, bool even) {
  std::vector<double> terms = {x(0)};
  for (Eigen::Index k = 1; k < x.size(); ++k) {
    terms.push_back(x(k));
    if (even) terms.push_back(0.0);
  }
  return terms;
}

/// Twist and frequency.
struct Vibration {
  Eigen::VectorXd x;
  double omega = 0.0;
};

/// The vibration of a given amplitude, by Newton's steps from a guess.
class FreeVibration {
 public:
  FreeVibration(Balance& balance, BackboneKind kind) : balance_(balance), kind_(kind) {}

  /// Amplitude of the exciting torque on the twist (MO-17) [N*m].
  double excitation = 0.0;

  [[nodiscard]] std::optional<Vibration> solve(Vibration at, double amplitude) {
    const Eigen::Index n = at.x.size();
    const bool even = kind_ == BackboneKind::undamped;
    const Eigen::Index unknowns = even ? n + 1 : n;
    Eigen::MatrixXd matrix(unknowns, unknowns);
    Eigen::VectorXd right(unknowns);
    for (int i = 0; i < kMostIterations; ++i) {
      balance_.evaluate(at.x, at.omega);
      const double force =
          balance_.ends.inertia() * at.omega * at.omega * amplitude;  // scale of the rows
      if (even) {
        matrix.topLeftCorner(n, n) = balance_.by_twist * (amplitude / force);
        matrix.col(n).head(n) = balance_.by_omega * (at.omega / force);
        matrix.row(n).head(n) = balance_.cycle.amplitude_slope().transpose();
        matrix(n, n) = 0.0;
        right.head(n) = balance_.residual / force;
        right(n) = balance_.cycle.amplitude() / amplitude - 1;
      } else {
        // The first harmonic is a cosine, and the torque that excites it a sine: the frequency
        // takes the place of its sine, and the amplitude that of the torque (MO-17).
        excitation = std::abs(balance_.residual(2));
        matrix = balance_.by_twist * (amplitude / force);
        matrix.col(2) = balance_.by_omega * (at.omega / force);
        matrix.row(2) = balance_.cycle.amplitude_slope().transpose();
        matrix(2, 2) = 0.0;
        right = balance_.residual / force;
        right(2) = balance_.cycle.amplitude() / amplitude - 1;
      }
      const Eigen::VectorXd step = matrix.partialPivLu().solve(right);
      const double size = step.norm();
      if (!std::isfinite(size)) return std::nullopt;
      // A long step leaves the basin; a shortened one stays.
      const double share = std::min(1.0, 0.5 / size);
      if (even) {
        at.x -= share * amplitude * step.head(n);
        at.omega *= 1 - share * step(n);
      } else {
        const double turn = step(2);
        at.x -= share * amplitude * step;
        at.x(2) = 0.0;
        at.omega *= 1 - share * turn;
      }
      if (!(at.omega > 0)) return std::nullopt;
      if (size < kSmallStep) {
        // The vibration of the other sign is the same half a period later.
        return at.x(1) > 0 ? std::optional(at) : std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  Balance& balance_;
  BackboneKind kind_;
};

/// A vibration of one cosine, with the frequency at which its first harmonic balances.
Vibration first_guess(Balance& balance, Eigen::Index size, double mean, double amplitude) {
  Vibration at{.x = Eigen::VectorXd::Zero(size), .omega = 1.0};
  at.x(0) = mean;
  at.x(1) = amplitude;
  balance.cycle.evaluate(at.x);
  const double stiffness = balance.cycle.torque()(1) / amplitude;
  at.omega = std::sqrt(std::max(stiffness, 0.0) / balance.ends.inertia());
  return at;
}

void check_balance(const Joint& joint, const BalanceSettings& settings, JointEnd excited) {
  require_constants(joint);
  require(settings.harmonics >= 1 && settings.harmonics <= kMostHarmonics, "harmonics",
          settings.harmonics, "1", "from 1 to 200");
  require(std::isfinite(settings.load_torque), "load_torque", settings.load_torque, "N*m",
          "a finite number");
  if (settings.input == VibratingInput::locked && excited == JointEnd::motor)
    throw InputError("at",
                     "cannot be the motor while the input is locked; excite the load, or take a "
                     "free input");
}

/// Curve of responses to one excitation.
class ResponseCurve {
 public:
  ResponseCurve(const Joint& joint, const ResponseSettings& settings)
      : joint_(joint),
        settings_(settings),
        balance_(joint, settings.balance, false),
        size_(balance_.cycle.size()) {}

  ForcedResponse follow(const Progress& progress) {
    ForcedResponse curve;
    const double low = 2 * pi * settings_.from;
    const double high = 2 * pi * settings_.to;
    std::optional<Vibration> start = begin(low);
    if (!start) {
      curve.reason = fmt::format("no response was found at {:.6g} Hz; begin at another frequency",
                                 settings_.from);
      return curve;
    }
    Vibration at = *start;
    evaluate(at);
    Tangent along = tangent(at, {Eigen::VectorXd::Zero(size_), 1.0});
    curve.points.push_back(point(at));
    double rate = amplitude_rate(along);
    int slips = balance_.cycle.slips();
    double step = std::min(kFirstStep, settings_.largest_step);
    int halvings = 0;
    double done = 0.0;
    while (static_cast<int>(curve.points.size()) < settings_.most_points) {
      // At a fold the frequency turns back, but the work does not.
      done = std::max(done, std::clamp((at.omega - low) / (high - low), 0.0, 1.0));
      progress.at(done);
      int iterations = 0;
      const std::optional<Vibration> next = corrected(at, along, step, iterations);
      std::optional<Tangent> turned;
      if (next) {
        evaluate(*next);
        turned = tangent(*next, along);
        const double size = std::sqrt(product(along, along, next->x, next->omega));
        // Where one more element slips, the curve has a corner.
        const bool corner = balance_.cycle.slips() != slips && step < kAtCorner;
        if (!corner && product(*turned, along, next->x, next->omega) < kStraight * size)
          turned.reset();
      }
      if (!turned) {
        if (++halvings > kMostHalvings) {
          curve.reason = fmt::format(
              "the curve could not be followed beyond {:.6g} Hz; take more harmonics, or a "
              "smaller excitation",
              at.omega / (2 * pi));
          return curve;
        }
        step /= 2;
        continue;
      }
      halvings = 0;
      slips = balance_.cycle.slips();
      const double rate_after = amplitude_rate(*turned);
      const bool leaves = next->omega > high || next->omega < low;
      if (!leaves) curve.points.push_back(point(*next));
      // The last step goes beyond the range, and its peak or fold may be inside.
      const auto inside = [&](double frequency) {
        return frequency >= settings_.from && frequency <= settings_.to;
      };
      if (rate > 0 && rate_after <= 0)
        if (const Peak found = peak(at, along, step); inside(found.frequency))
          curve.peaks.push_back(found);
      if ((along.omega > 0) != (turned->omega > 0))
        if (const Fold found = fold(at, along, step, along.omega > 0); inside(found.frequency))
          curve.folds.push_back(found);
      if (leaves) {
        const double end = next->omega > high ? high : low;
        const double share = (end - at.omega) / (next->omega - at.omega);
        Vibration guess{.x = at.x + share * (next->x - at.x), .omega = end};
        if (const std::optional<Vibration> last = at_frequency(guess, 1.0)) {
          evaluate(*last);
          curve.points.push_back(point(*last));
          curve.converged = end == high;
        }
        if (end != high)
          curve.reason = fmt::format(
              "the curve returns to {:.6g} Hz, where it began; begin at a lower frequency",
              settings_.from);
        else if (!curve.converged)
          curve.reason = fmt::format(
              "no vibration was found at {:.6g} Hz, where the curve ends; end at a higher "
              "frequency",
              settings_.to);
        return curve;
      }
      rate = rate_after;
      at = *next;
      along = *turned;
      step = std::min(settings_.largest_step,
                      step * std::clamp(4.0 / std::max(iterations, 1), 0.5, 2.0));
    }
    curve.reason =
        fmt::format("the curve has {} points before its end; take a narrower range of frequencies",
                    settings_.most_points);
    return curve;
  }

  /// The joint on the response while the exciting cosine is 1.
  [[nodiscard]] JointState state(const ResponsePoint& at) {
    const Vibration v{Eigen::Map<const Eigen::VectorXd>(at.twist.data(),
                                                        static_cast<Eigen::Index>(at.twist.size())),
                      2 * pi * at.frequency};
    balance_.cycle.evaluate(v.x);
    const TwistSeries::At twist = TwistSeries{v.x}.at(0.0);
    double output_speed = 0.0;
    for (Eigen::Index k = 1; 2 * k < v.x.size(); ++k) {
      const Complex s(0, static_cast<double>(k) * v.omega);
      output_speed += (s * output_angle(v, k)).real();
    }
    JointState start{.output_angle = -twist.value,
                     .output_speed = output_speed,
                     .hysteresis = balance_.cycle.loop_at_zero()};
    if (!joint_.slip_elements.empty()) start.slip = balance_.cycle.slip_at_zero();
    if (!balance_.ends.locked())
      start.input_speed = joint_.ratio * (v.omega * twist.slope + output_speed);
    return start;
  }

 private:
  struct Tangent {
    Eigen::VectorXd x;
    double omega = 0.0;
  };

  /// Product of two directions; lengths count relative to the vibration and to the frequency.
  [[nodiscard]] static double product(const Tangent& a, const Tangent& b, const Eigen::VectorXd& x,
                                      double omega) {
    const double size = vibration_size(x);
    return a.x.dot(b.x) / (size * size) + a.omega * b.omega / (omega * omega);
  }

  /// Residual with the excitation, and its derivatives.
  void evaluate(const Vibration& at, double share = 1.0) {
    balance_.evaluate(at.x, at.omega);
    const Ends::End factor = balance_.ends.excitation(settings_.excited, Complex(0, at.omega));
    const Complex force = share * settings_.excitation * factor.value;
    const Complex slope = share * settings_.excitation * Complex(0, 1) * factor.slope;
    balance_.residual(1) -= force.real();  // (MO-15)
    balance_.residual(2) += force.imag();  // (MO-15)
    balance_.by_omega(1) -= slope.real();
    balance_.by_omega(2) += slope.imag();
  }

  [[nodiscard]] std::optional<Vibration> at_frequency(Vibration at, double share) {
    for (int i = 0; i < 2 * kMostIterations; ++i) {
      evaluate(at, share);
      Eigen::VectorXd step = balance_.by_twist.partialPivLu().solve(balance_.residual);
      const double size = std::max(vibration_size(at.x), step.tail(size_ - 1).norm());
      const double length = step.norm() / size;
      if (!std::isfinite(length)) return std::nullopt;
      at.x -= step;
      if (length < kSmallStep) return at;
    }
    return std::nullopt;
  }

  /// The response at a frequency that grows out of rest with the excitation.
  [[nodiscard]] std::optional<Vibration> begin(double omega) {
    Vibration at{.x = Eigen::VectorXd::Zero(size_), .omega = omega};
    at.x(0) = balance_.elastic.twist_under(-settings_.balance.load_torque);
    double share = 0.0;
    double step = 1.0;
    for (int i = 0; i < 60; ++i) {
      const double to = std::min(1.0, share + step);
      if (const std::optional<Vibration> next = at_frequency(at, to)) {
        at = *next;
        share = to;
        step *= 2;
        if (share >= 1) return at;
      } else {
        step /= 4;
      }
    }
    return std::nullopt;
  }

  /// Direction of the curve at a point where `evaluate` was called last (MO-18).
  [[nodiscard]] Tangent tangent(const Vibration& at, const Tangent& before) const {
    const double size = vibration_size(at.x);
    Eigen::MatrixXd matrix(size_ + 1, size_ + 1);
    const double row = balance_.ends.inertia() * at.omega * at.omega * size;
    matrix.topLeftCorner(size_, size_) = balance_.by_twist * (size / row);
    matrix.col(size_).head(size_) = balance_.by_omega * (at.omega / row);
    matrix.row(size_).head(size_) = before.x.transpose() / size;
    matrix(size_, size_) = before.omega / at.omega;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size_ + 1);
    right(size_) = 1.0;
    const Eigen::VectorXd t = matrix.partialPivLu().solve(right).normalized();  // (MO-18)
    return {.x = t.head(size_) * size, .omega = t(size_) * at.omega};
  }

  /// The point of the curve in the plane across the tangent at a distance (MO-18).
  [[nodiscard]] std::optional<Vibration> corrected(const Vibration& from, const Tangent& along,
                                                   double distance, int& iterations) {
    const double size = vibration_size(from.x);
    Vibration at{.x = from.x + distance * along.x, .omega = from.omega + distance * along.omega};
    Eigen::MatrixXd matrix(size_ + 1, size_ + 1);
    Eigen::VectorXd right(size_ + 1);
    const double row = balance_.ends.inertia() * from.omega * from.omega * size;
    for (iterations = 1; iterations <= kMostIterations; ++iterations) {
      if (!(at.omega > 0)) return std::nullopt;
      evaluate(at);
      matrix.topLeftCorner(size_, size_) = balance_.by_twist * (size / row);
      matrix.col(size_).head(size_) = balance_.by_omega * (from.omega / row);
      matrix.row(size_).head(size_) = along.x.transpose() / size;
      matrix(size_, size_) = along.omega / from.omega;
      right.head(size_) = balance_.residual / row;
      right(size_) = along.x.dot(at.x - from.x) / (size * size) +
                     along.omega * (at.omega - from.omega) / (from.omega * from.omega) - distance;
      const Eigen::VectorXd step = matrix.partialPivLu().solve(right);
      const double length = step.norm();
      if (!(length < 10 * distance + kFirstStep)) return std::nullopt;
      at.x -= size * step.head(size_);
      at.omega -= from.omega * step(size_);
      if (length < kSmallStep) return at;
    }
    return std::nullopt;
  }

  /// Change of the amplitude along a tangent, where `evaluate` was called last [rad].
  [[nodiscard]] double amplitude_rate(const Tangent& along) const {
    return balance_.cycle.amplitude_slope().dot(along.x);
  }

  /// The point between two points of the curve at which a rate changes its sign from that of
  /// `positive`, by bisection (MO-18).
  /// @param rate  tangent -> rate over its scale, where `evaluate` was called last
  template <class Rate>
  [[nodiscard]] Vibration turning_point(const Vibration& from, const Tangent& along,
                                        double distance, bool positive, const Rate& rate) {
    double low = 0.0;
    double high = distance;
    Vibration best = from;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      int iterations = 0;
      const std::optional<Vibration> at = corrected(from, along, middle, iterations);
      if (!at) break;
      best = *at;
      evaluate(best);
      const double here = rate(best, tangent(best, along));
      if (std::abs(here) < kTurnTolerance) break;
      ((here > 0) == positive ? low : high) = middle;
      if (high - low < kTurnTolerance * distance) break;
    }
    evaluate(best);
    return best;
  }

  /// Where the frequency turns between two points of the curve (MO-18).
  [[nodiscard]] Fold fold(const Vibration& from, const Tangent& along, double distance,
                          bool rising) {
    const Vibration at =
        turning_point(from, along, distance, rising,
                      [](const Vibration& here, const Tangent& t) { return t.omega / here.omega; });
    return {.frequency = at.omega / (2 * pi),
            .amplitude = balance_.cycle.amplitude(),
            .rising = rising};
  }

  /// Where the amplitude turns between two points of the curve (MO-18).
  [[nodiscard]] Peak peak(const Vibration& from, const Tangent& along, double distance) {
    const Vibration at =
        turning_point(from, along, distance, true, [this](const Vibration&, const Tangent& t) {
          return amplitude_rate(t) / balance_.cycle.amplitude();
        });
    return {.frequency = at.omega / (2 * pi),
            .amplitude = balance_.cycle.amplitude(),
            .torque = balance_.cycle.torque_amplitude(),
            .stable = std::abs(multipliers(at).front()) <= kStable};
  }

  /// Harmonic k of theta_L.
  [[nodiscard]] Complex output_angle(const Vibration& at, Eigen::Index k) const {
    const Complex s(0, static_cast<double>(k) * at.omega);
    const Complex twist(at.x(2 * k - 1), -at.x(2 * k));
    const Complex own = balance_.ends.stiffness(s).value - joint_.damping * s;
    Complex torque = -own * twist;  // (MO-15)
    if (k == 1) {
      torque += settings_.excitation * balance_.ends.excitation(settings_.excited, s).value;
      if (settings_.excited == JointEnd::load) torque += settings_.excitation;
    }
    return torque / balance_.ends.output(s).value;
  }

  [[nodiscard]] ResponsePoint point(const Vibration& at) {
    ResponsePoint made{.frequency = at.omega / (2 * pi),
                       .amplitude = balance_.cycle.amplitude(),
                       .mean_twist = at.x(0),
                       .torque = balance_.cycle.torque_amplitude(),
                       .truncation = last_share(at.x, false),
                       .twist = all_terms(at.x, false)};
    const Complex output = output_angle(at, 1);
    made.output = std::abs(output);
    made.lag = -std::arg(output);
    made.multipliers = multipliers(at);
    made.multiplier = std::abs(made.multipliers.front());
    made.stable = made.multiplier <= kStable;  // (MO-19)
    return made;
  }

  // At most: twist, two speeds, z, and the twist at which slip elements begin to stick.
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5>;

  /// Which states the variational equation has beside twist and speeds.
  struct Memory {
    bool with_loop = false;
    double slip = 0.0;  ///< stiffness of all slip elements [N*m/rad]
  };

  /// Derivative of the rates by the state, over the angle of the period (MO-19).  Speeds count over
  /// the angle too, and z as the twist of a spring of its stiffness.
  [[nodiscard]] Small jacobian(double tangent, double loop, double loop_decay, double omega,
                               const Memory& memory, bool both_ends) const {
    const bool with_loop = memory.with_loop;
    const double square = omega * omega;
    const double A = with_loop ? joint_.hysteresis->stiffness : 0.0;
    const double c = joint_.damping * omega;
    const Eigen::Index speeds = both_ends ? 2 : 1;
    const Eigen::Index size = 1 + speeds + (with_loop ? 1 : 0) + (memory.slip > 0 ? 1 : 0);
    Small J = Small::Zero(size, size);
    const auto of_torque = [&](Eigen::Index row, double inertia) {
      J(row, 0) -= tangent / (inertia * square);
      J(row, 1) -= c / (inertia * square);
      if (both_ends) J(row, 2) += c / (inertia * square);
      if (with_loop) J(row, 1 + speeds) -= A / (inertia * square);
      if (memory.slip > 0) J(row, size - 1) += memory.slip / (inertia * square);
    };
    J(0, 1) = 1.0;
    if (both_ends) {
      J(0, 2) = -1.0;
      of_torque(1, balance_.ends.input_at_output());
      J(1, 1) -= joint_.input_damping / (joint_.input_inertia * omega);
      of_torque(2, -joint_.output_inertia);
      J(2, 2) -= joint_.output_damping / (joint_.output_inertia * omega);
    } else {
      of_torque(1, balance_.ends.inertia());
      if (balance_.ends.locked())
        J(1, 1) -= joint_.output_damping / (joint_.output_inertia * omega);
    }
    if (with_loop) {
      const Eigen::Index z = 1 + speeds;
      for (Eigen::Index k = 0; k < z; ++k) J(z, k) = loop / A * J(0, k);
      J(z, z) += loop_decay;
    }
    return J;
  }

  [[nodiscard]] static Small exponential(const Small& matrix) {
    const double size = matrix.cwiseAbs().rowwise().sum().maxCoeff();
    const int halvings = size > 0.25 ? static_cast<int>(std::ceil(std::log2(size / 0.25))) : 0;
    const Small part = matrix / std::pow(2.0, halvings);
    Small sum = Small::Identity(matrix.rows(), matrix.cols());
    for (int k = 10; k >= 1; --k)
      sum = Small::Identity(matrix.rows(), matrix.cols()) + part * sum / k;
    for (int i = 0; i < halvings; ++i) sum = sum * sum;
    return sum;
  }

  /// Floquet multipliers of the response of the last evaluation, by Magnus' steps of the fourth
  /// order (MO-19).
  [[nodiscard]] std::vector<Complex> multipliers(const Vibration& at) const {
    const TwistSeries series{at.x};
    const TwistCycle& cycle = balance_.cycle;
    const bool with_loop = joint_.hysteresis && !cycle.breaks().empty();
    // Without damping to the ground the mean speed neither grows nor decays.
    const bool both_ends =
        !balance_.ends.locked() && (joint_.input_damping > 0 || joint_.output_damping > 0);
    std::vector<CycleBreak> breaks = cycle.breaks();
    if (breaks.empty()) breaks = {{.angle = 0.0}, {.angle = 2 * pi}};
    const std::vector<SlipPiece>& slip = cycle.slip_pieces();
    Memory memory{.with_loop = with_loop};
    if (!slip.empty())
      for (const SlipElement& of : joint_.slip_elements) memory.slip += of.stiffness;
    const Eigen::Index state = (both_ends ? 3 : 2) + (with_loop ? 1 : 0);
    const Eigen::Index size = state + (slip.empty() ? 0 : 1);
    // The last row is what sticking elements remember of the twist.
    Small solution = Small::Identity(size, state);
    const std::size_t pieces = breaks.size() - 1;
    // At the largest twist each element that slips bears its limit, so it remembers nothing.
    std::size_t begin = 0;
    if (!slip.empty())
      while (breaks[begin].turn != cycle.highest_turn()) ++begin;
    std::vector<Eigen::RowVectorXd> at_turns(slip.empty() ? 0 : slip.front().since.size(),
                                             Eigen::RowVectorXd::Zero(state));
    for (std::size_t n = 0; n < pieces; ++n) {
      const std::size_t i = (begin + n) % pieces;
      const double length = breaks[i + 1].angle - breaks[i].angle;
      const double enough =
          kLeastStepsOfPiece +
          kStepsOfPeriod * length / (2 * pi) * std::max(1.0, settings_.balance.harmonics / 9.0);
      const int steps = static_cast<int>(std::ceil(enough));
      const double h = length / steps;
      const double sense = breaks[i + 1].twist > breaks[i].twist ? 1.0 : -1.0;
      double sticking = 0.0;
      if (!slip.empty()) {
        if (n == 0 || breaks[i].turn != breaks[(begin + n - 1) % pieces].turn)
          at_turns[breaks[i].turn] = solution.row(0);
        sticking = slip[i].stiffness;
        solution.row(state).setZero();
        for (std::size_t t = 0; t + 1 < at_turns.size(); ++t)
          solution.row(state) += slip[i].since[t] / memory.slip * at_turns[t];  // (MO-47)
      }
      double z = breaks[i].loop;
      double twist = breaks[i].twist;
      const auto rates = [&](double angle) {
        const TwistSeries::At here = series.at(angle);
        double slope = 0.0;
        double decay = 0.0;
        if (with_loop) {
          const BoucWen& loop = *joint_.hysteresis;
          z = loop_after(loop, z, here.value - twist).torque;
          twist = here.value;
          slope = loop_slope(loop, z, sense);
          decay = loop_bend(loop, z, sense) * here.slope;
        }
        return jacobian(balance_.elastic.at(here.value).tangent + sticking, slope, decay, at.omega,
                        memory, both_ends);
      };
      const double gauss = std::sqrt(3.0) / 6;
      for (int k = 0; k < steps; ++k) {
        const double start = breaks[i].angle + k * h;
        const Small first = rates(start + (0.5 - gauss) * h);
        const Small second = rates(start + (0.5 + gauss) * h);
        const Small turn = second * first - first * second;
        solution =
            exponential(h / 2 * (first + second) + std::sqrt(3.0) / 12 * h * h * turn) * solution;
      }
    }
    const Small monodromy = solution.topRows(state);
    const Eigen::VectorXcd values = Eigen::MatrixXd(monodromy).eigenvalues();
    std::vector<Complex> all(values.data(), values.data() + values.size());
    std::ranges::sort(all, [](const Complex& a, const Complex& b) {
      return std::pair(std::abs(a), a.imag()) > std::pair(std::abs(b), b.imag());
    });
    return all;
  }

  const Joint& joint_;
  const ResponseSettings& settings_;
  Balance balance_;
  Eigen::Index size_ = 0;
};

}  // namespace

Backbone backbone(const Joint& joint, const BackboneSettings& settings, const Progress& progress) {
  const bool undamped = settings.kind == BackboneKind::undamped;
  check_balance(joint, settings.balance, undamped ? JointEnd::load : settings.excited);
  if (settings.amplitudes.empty()) throw InputError("amplitudes", "must have at least one value");
  for (std::size_t i = 0; i < settings.amplitudes.size(); ++i)
    require(std::isfinite(settings.amplitudes[i]) &&
                settings.amplitudes[i] > (i == 0 ? 0.0 : settings.amplitudes[i - 1]),
            (FieldPath("amplitudes")[i]).text(), settings.amplitudes[i], "rad",
            "> 0 and larger than the one before");
  Balance balance(joint, settings.balance, undamped);
  FreeVibration vibration(balance, settings.kind);
  const Eigen::Index size = balance.cycle.size();
  const double mean = balance.elastic.twist_under(-settings.balance.load_torque);
  Backbone curve;
  // The first vibration grows out of a smaller one if the guess is too far away.
  std::optional<Vibration> at;
  double amplitude = settings.amplitudes.front();
  for (int i = 0; i < kMostHalvings && !at; ++i) {
    at = vibration.solve(first_guess(balance, size, mean, amplitude), amplitude);
    if (!at) amplitude /= 4;
  }
  if (!at) {
    curve.reason = fmt::format("no vibration was found at {:.6g} rad; give a smaller amplitude",
                               settings.amplitudes.front());
    return curve;
  }
  std::optional<Vibration> before;
  double amplitude_before = 0.0;
  for (const double wanted : settings.amplitudes) {
    progress.at(static_cast<double>(curve.points.size()) /
                static_cast<double>(settings.amplitudes.size()));
    double step = std::log(wanted / amplitude);
    int halvings = 0;
    while (amplitude < wanted) {
      const double left = std::log(wanted / amplitude);
      const double next = step < left ? amplitude * std::exp(step) : wanted;
      const double growth = next / amplitude;
      Vibration guess = *at;
      guess.x.tail(size - 1) *= growth;
      if (before) {
        // A straight line over the logarithm of the amplitude.
        const double share = std::log(growth) / std::log(amplitude / amplitude_before);
        guess.omega += share * (at->omega - before->omega);
        guess.x(0) += share * (at->x(0) - before->x(0));
        guess.x.tail(size - 1) +=
            share * growth *
            (at->x.tail(size - 1) - before->x.tail(size - 1) * (amplitude / amplitude_before));
      }
      const std::optional<Vibration> found = vibration.solve(guess, next);
      if (!found) {
        if (++halvings > kMostHalvings) {
          curve.reason = fmt::format(
              "the vibrations could not be followed beyond {:.6g} rad; take more harmonics, or a "
              "smaller amplitude",
              amplitude);
          return curve;
        }
        step = std::min(step, left) / 2;
        continue;
      }
      before = at;
      amplitude_before = amplitude;
      at = found;
      amplitude = next;
    }
    BackbonePoint point{.amplitude = wanted,
                        .frequency = at->omega / (2 * pi),
                        .mean_twist = at->x(0),
                        .torque = balance.cycle.torque_amplitude(),
                        .truncation = last_share(at->x, undamped),
                        .twist = all_terms(at->x, undamped)};
    if (!undamped) {
      const Complex s(0, at->omega);
      // (MO-17): the work of the torque on the first harmonic is all that is lost.
      point.damping_ratio =
          vibration.excitation / (2 * balance.ends.inertia() * at->omega * at->omega * at->x(1));
      point.excitation =
          vibration.excitation / std::abs(balance.ends.excitation(settings.excited, s).value);
    }
    curve.points.push_back(std::move(point));
  }
  curve.converged = true;
  return curve;
}

ForcedResponse forced_response(const Joint& joint, const ResponseSettings& settings,
                               const Progress& progress) {
  check_balance(joint, settings.balance, settings.excited);
  const auto positive_number = [](const char* field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  positive_number("excitation", settings.excitation, "N*m");
  positive_number("from", settings.from, "Hz");
  require(settings.to > settings.from && std::isfinite(settings.to), "to", settings.to, "Hz",
          "larger than from");
  positive_number("largest_step", settings.largest_step, "1");
  require(settings.most_points >= 2, "most_points", settings.most_points, "1", ">= 2");
  return ResponseCurve(joint, settings).follow(progress);
}

JointState state_on_response(const Joint& joint, const ResponseSettings& settings,
                             const ResponsePoint& point) {
  check_balance(joint, settings.balance, settings.excited);
  if (static_cast<int>(point.twist.size()) != 2 * settings.balance.harmonics + 1)
    throw InputError("point", "must be a response of the same settings");
  return ResponseCurve(joint, settings).state(point);
}

double small_frequency(const Joint& joint, const BalanceSettings& settings) {
  check_balance(joint, settings, JointEnd::load);
  const ElasticCurve elastic = elastic_curve(joint);
  const ElasticCurve::Sides tangents = elastic.tangents_under(-settings.load_torque);
  const double inertia = Ends(joint, settings.input).inertia();
  const auto frequency = [&](double stiffness) {
    if (joint.hysteresis) stiffness += joint.hysteresis->stiffness;
    for (const SlipElement& of : joint.slip_elements) stiffness += of.stiffness;
    return std::sqrt(stiffness / inertia) / (2 * pi);
  };
  return bilinear_frequency(frequency(tangents.below), frequency(tangents.above));
}

double bilinear_frequency(double one, double other) {
  return one == other ? one : 2 * one * other / (one + other);  // (MO-16)
}

double twist_at_rest(const Joint& joint, double load_torque) {
  check_balance(joint, {.load_torque = load_torque}, JointEnd::load);
  return elastic_curve(joint).twist_under(-load_torque);
}

}  // namespace strainwave

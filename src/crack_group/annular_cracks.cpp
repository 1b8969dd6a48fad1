// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/annular_cracks.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <deque>
#include <memory>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Functions of the jump of a crack, and how many fewer estimate the error.
constexpr Eigen::Index kFunctions = 10;
constexpr Eigen::Index kFewerFunctions = 7;
/// Products of wave number and depth from which on a mode counts less, and at which the sum over
/// the modes ends.
/// @{
constexpr double kFirstFading = 64;
constexpr double kLastPhase = 112;
/// @}

/// Weight of a mode by its wave number times the depth, from 1 down to 0 with two continuous
/// derivatives, so that the sum changes smoothly with the depth (CG-12).
double fading(double phase) {
  // Written from the end, where rounding of 1 minus the share would give less than 0.
  const double s = std::clamp((kLastPhase - phase) / (kLastPhase - kFirstFading), 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

/// The integral of (1 - fading(x))/x^2 over all x (CG-12).
double faded_part() {
  static const double part =
      boost::math::quadrature::gauss<double, 30>::integrate(
          [](double x) { return (1 - fading(x)) / (x * x); }, kFirstFading, kLastPhase) +
      1 / kLastPhase;
  return part;
}

/// Bessel functions in the precision of their argument, which is all that they need here.
using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// Bessel functions of both kinds, J = m cos(phase) and Y = m sin(phase).
struct BesselPair {
  double square = 0.0;  ///< m^2
  double phase = 0.0;   ///< continuous in the argument [rad]
};

/// From here on the terms of Hankel's series fall to 1e-11.
constexpr double kLarge = 25;

/// The series P and Q of Hankel, J = sqrt(2/(pi x)) (P cos(chi) - Q sin(chi)) and
/// Y = sqrt(2/(pi x)) (P sin(chi) + Q cos(chi)) with chi = x - (order/2 + 1/4) pi.
template <int kOrder>
std::array<double, 2> hankel(double x) {
  constexpr std::size_t kTerms = 12;
  static const std::array<double, kTerms> terms = [] {
    std::array<double, kTerms> result{1.0};
    for (std::size_t j = 1; j < kTerms; ++j) {
      const double odd = 2.0 * static_cast<double>(j) - 1;
      result[j] =
          result[j - 1] * (4.0 * kOrder * kOrder - odd * odd) / (8.0 * static_cast<double>(j));
    }
    return result;
  }();
  const double y = -1 / (x * x);
  double p = 0.0;
  double q = 0.0;
  for (std::size_t j = kTerms; j > 0; j -= 2) {
    q = q * y + terms[j - 1];
    p = p * y + terms[j - 2];
  }
  return {p, q / x};
}

/// The Bessel functions of order 2; x > 0.
BesselPair second_order(double x) {
  const double chi = x - 5 * pi / 4;
  if (x >= kLarge) {
    const auto [p, q] = hankel<2>(x);
    return {.square = 2 / (pi * x) * (p * p + q * q), .phase = chi + std::atan2(q, p)};
  }
  const double j = boost::math::cyl_bessel_j(2, x, Plain());
  const double y = boost::math::cyl_neumann(2, x, Plain());
  double phase = std::atan2(y, j);
  constexpr double kFirstTurn = 5;  // up to which the phase is less than half a turn
  if (x > kFirstTurn) phase += 2 * pi * std::round((chi + 15 / (8 * x) - phase) / (2 * pi));
  return {.square = j * j + y * y, .phase = phase};
}

/// A mode of a shaft of outer radius 1 in torsion.
struct Mode {
  double wave_number = 0.0;  ///< k
  double surface = 0.0;      ///< phase of the Bessel functions of order 2 at k
  double weight = 0.0;       ///< k/(2 N) times the modes that this one stands for (CG-11)

  /// phi at a radius, J_1(kr) sin(surface) - Y_1(kr) cos(surface) (CG-10).
  [[nodiscard]] double at(double r) const {
    const double x = wave_number * r;
    if (x < kLarge)
      return boost::math::cyl_bessel_j(1, x, Plain()) * std::sin(surface) -
             boost::math::cyl_neumann(1, x, Plain()) * std::cos(surface);
    const auto [p, q] = hankel<1>(x);
    const double angle = surface - x + 3 * pi / 4;
    return std::sqrt(2 / (pi * x)) * (p * std::sin(angle) - q * std::cos(angle));
  }
};

/// Points and weights of Gauss for the sum over the integers 0 to `of` - 1: exact for polynomials
/// up to degree 2 `points` - 1 (CG-13).
std::vector<std::pair<double, double>> gauss_of_sum(std::size_t of, std::size_t points) {
  // The polynomials that are orthogonal in the sum (Gram) have this recurrence.
  const auto m = static_cast<Eigen::Index>(points);
  const double count = static_cast<double>(of);
  const Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(m);
  Eigen::VectorXd beside(m - 1);
  for (Eigen::Index j = 1; j < m; ++j) {
    const double square = static_cast<double>(j) * static_cast<double>(j);
    beside[j - 1] =
        std::sqrt(square * (count * count - square) / (4 * (4 * square - 1)));  // (CG-13)
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  std::vector<std::pair<double, double>> result;
  for (Eigen::Index i = 0; i < m; ++i) {
    const double first = solver.eigenvectors()(0, i);
    result.emplace_back(solver.eigenvalues()[i] + (count - 1) / 2, count * first * first);
  }
  return result;
}

/// Number of modes up to which a block of modes reaches; each block is longer by the root of 2.
std::size_t end_of_block(int block) {
  return static_cast<std::size_t>(std::ceil(std::pow(2.0, block / 2.0)));
}

/// The modes of a shaft of outer radius 1, in torsion: phi(r) exp(-k |z|) with free surfaces.  A
/// long block of modes is represented by fewer ones at numbers between whole ones.
class ShaftModes {
 public:
  /// @param inner  inner radius [-]
  /// @param most   number of modes, the end of a block; fewer modes are the first ones of these
  ShaftModes(double inner, std::size_t most) : inner_(inner), most_(most) {
    std::size_t begin = 0;
    for (int block = 0; begin < most; ++block) {
      const std::size_t end = end_of_block(block);
      if (end <= begin) continue;
      // The deepest crack that this block concerns has it as its last one, and its phase moves
      // most.
      const double phase = std::numbers::sqrt2 * kLastPhase * static_cast<double>(end - begin) /
                           static_cast<double>(end);
      constexpr double kMore = 14;
      const auto points = static_cast<std::size_t>(std::ceil(kMore + phase));
      if (points < end - begin) {
        for (const auto& [place, weight] : gauss_of_sum(end - begin, points))
          add(static_cast<double>(begin) + place + 1, weight);
      } else {
        for (std::size_t n = begin; n < end; ++n) add(static_cast<double>(n) + 1, 1.0);
      }
      begin = end;
      ends_.emplace_back(end, modes_.size());
    }
  }

  [[nodiscard]] std::size_t most() const { return most_; }
  [[nodiscard]] const std::vector<Mode>& modes() const { return modes_; }
  /// How many of `modes` represent the first `count` modes, the end of a block.
  [[nodiscard]] std::size_t size(std::size_t count) const {
    for (const auto& [end, size] : ends_)
      if (end >= count) return size;
    return modes_.size();
  }

 private:
  /// Wave number of mode n, counted from 1, by Newton's method from a value k nearby (CG-13).
  [[nodiscard]] double wave_number(double n, double k) const {
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps; ++i) {
      const BesselPair outside = second_order(k);
      double value = outside.phase - n * pi + pi / 2;
      double slope = 1 / outside.square;
      if (inner_ > 0) {
        const BesselPair inside = second_order(k * inner_);
        value -= inside.phase + pi / 2;
        slope -= 1 / inside.square;
      }
      // The phase grows by 2/(pi k square).
      const double step = value * pi * k / (2 * slope);
      k = std::max(k - step, k / 2);
      if (std::abs(step) < 1e-14 * k) break;
    }
    return k;
  }
  void add(double n, double weight) {
    const double k = wave_number(
        n, modes_.empty() ? (n + 0.75) * pi / (1 - 0.5 * inner_)
                          : modes_.back().wave_number + (n - last_) * pi / (1 - inner_));
    const BesselPair outside = second_order(k);
    const double bore = inner_ > 0 ? 1 / second_order(k * inner_).square : 0.0;
    const double norm = 2 / (pi * pi * k * k) * (1 / outside.square - bore);  // (CG-13)
    modes_.push_back(
        {.wave_number = k, .surface = outside.phase, .weight = weight * k / (2 * norm)});
    last_ = n;
  }

  double inner_;
  std::size_t most_;
  double last_ = 0.0;  ///< number of the last one of `modes_`
  std::vector<Mode> modes_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;  ///< modes up to a block, and size there
};

/// A crack in a shaft of outer radius 1, by the functions of its jump.
struct Jump {
  double place = 0.0;
  double depth = 0.0;
  Eigen::MatrixXd modes;      ///< integral of r phi_n psi_m, a column for each mode
  Eigen::VectorXd of_torque;  ///< integral of r^2 psi_m
  Eigen::VectorXd at_tip;     ///< psi_m over c sqrt(xi/a) at the tip
};

/// Jacobi's polynomials P_m^(1/2, 0), m < kFunctions, which are orthogonal on the depth with the
/// root at the tip as their weight.
Eigen::VectorXd polynomials(double x) {
  Eigen::VectorXd p(kFunctions);
  p[0] = 1;
  p[1] = (5 * x + 1) / 4;
  for (Eigen::Index m = 2; m < kFunctions; ++m) {
    const double n = static_cast<double>(m);
    const double c = 2 * n + 0.5;
    p[m] =
        ((c - 1) * (c * (c - 2) * x + 0.25) * p[m - 1] - 2 * (n - 0.5) * (n - 1) * c * p[m - 2]) /
        (2 * n * (n + 0.5) * (c - 2));
  }
  return p;
}

/// Points and weights on [0, 1] for functions with some `phase` of oscillation.
std::vector<std::pair<double, double>> points_for(double phase) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  constexpr double kPhaseOfPiece = 36;
  const auto pieces = static_cast<std::size_t>(std::ceil(1 + phase / kPhaseOfPiece));
  const double half = 0.5 / static_cast<double>(pieces);
  std::vector<std::pair<double, double>> points;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const double middle = (2 * static_cast<double>(piece) + 1) * half;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0})
        points.emplace_back(middle + side * half * Rule::abscissa()[i], half * Rule::weights()[i]);
  }
  return points;
}

Jump jump_of(double place, double depth, const ShaftModes& modes, std::size_t count) {
  Jump jump;
  jump.place = place;
  jump.depth = depth;
  const double tip = 1 - depth;
  const std::size_t size = modes.size(count);
  jump.modes = Eigen::MatrixXd::Zero(kFunctions, static_cast<Eigen::Index>(size));
  jump.of_torque = Eigen::VectorXd::Zero(kFunctions);
  jump.at_tip = polynomials(1);
  // s is the root of the distance from the tip over the depth.
  struct Point {
    double r;
    Eigen::Matrix<double, kFunctions, 1> weights;
  };
  std::vector<Point> points;
  double reach = -1.0;  // phase up to which the points serve
  for (std::size_t n = 0; n < size; ++n) {
    const Mode& mode = modes.modes()[n];
    const double weight_of_mode = fading(mode.wave_number * depth);
    if (weight_of_mode == 0) break;  // and that of all that follow
    // The phase moves twice as fast at the surface.
    const double phase = 2 * mode.wave_number * depth;
    if (phase > reach) {
      points.clear();
      reach = std::min(1.25 * phase + 10, 2 * modes.modes()[size - 1].wave_number * depth);
      for (const auto& [s, weight] : points_for(reach)) {
        const double r = tip + depth * s * s;
        points.push_back({r, weight * 2 * s * depth * r * r * s * polynomials(1 - 2 * s * s)});
      }
      if (n == 0)
        for (const Point& point : points) jump.of_torque += point.r * point.weights;  // (CG-11)
    }
    for (const Point& point : points)
      jump.modes.col(static_cast<Eigen::Index>(n)) += mode.at(point.r) * point.weights;  // (CG-11)
    jump.modes.col(static_cast<Eigen::Index>(n)) *= std::sqrt(weight_of_mode);           // (CG-12)
  }
  return jump;
}

/// Stress that the functions of one jump cause at another, weighted by the functions there; G = 1.
Eigen::MatrixXd stress_between(const Jump& one, const Jump& other, bool same,
                               const ShaftModes& modes) {
  const Eigen::Index count = std::min(one.modes.cols(), other.modes.cols());
  Eigen::VectorXd weights(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    const Mode& mode = modes.modes()[static_cast<std::size_t>(n)];
    weights[n] = mode.weight * std::exp(-mode.wave_number * std::abs(one.place - other.place));
  }
  Eigen::MatrixXd stress = one.modes.leftCols(count) * weights.asDiagonal() *
                           other.modes.leftCols(count).transpose();  // (CG-11)
  if (same) {
    // The modes that follow see the root at the tip alone; their sum is an integral.
    const double tip = 1 - one.depth;
    stress +=
        one.at_tip * one.at_tip.transpose() * (tip * tip * tip * faded_part() / 8);  // (CG-12)
  }
  return stress;
}

/// Weights of the functions of all jumps.
Eigen::VectorXd solved(const std::vector<Jump>& jumps,
                       const std::vector<std::vector<Eigen::MatrixXd>>& stress,
                       Eigen::Index functions) {
  const auto count = static_cast<Eigen::Index>(jumps.size());
  Eigen::MatrixXd matrix(count * functions, count * functions);
  Eigen::VectorXd right(count * functions);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j)
      matrix.block(i * functions, j * functions, functions, functions) =
          stress[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].topLeftCorner(functions,
                                                                                         functions);
    right.segment(i * functions, functions) =
        jumps[static_cast<std::size_t>(i)].of_torque.head(functions);
  }
  return matrix.ldlt().solve(right);
}

AnnularGroup group_of(const std::vector<Jump>& jumps,
                      const std::vector<std::vector<Eigen::MatrixXd>>& stress,
                      const ShaftRadii& radii, Eigen::Index functions) {
  const double inner = radii.inner / radii.outer;
  const double section = pi / 2 * (1 - std::pow(inner, 4));  // polar moment; stress r/section
  const Eigen::VectorXd together = solved(jumps, stress, functions);
  AnnularGroup group;
  for (std::size_t j = 0; j < jumps.size(); ++j) {
    const Jump& jump = jumps[j];
    const Eigen::VectorXd among =
        together.segment(static_cast<Eigen::Index>(j) * functions, functions);
    const Eigen::VectorXd alone = solved({jump}, {{stress[j][j]}}, functions);
    // K_III is in proportion to the jump at the tip; the constant cancels.
    const auto at_tip = [&](const Eigen::VectorXd& weights) {
      return jump.at_tip.head(functions).dot(weights);  // (CG-12)
    };
    const auto rotation = [&](const Eigen::VectorXd& weights) {
      return 2 * pi * jump.of_torque.head(functions).dot(weights) / (section * section);  // (CG-12)
    };
    group.cracks.push_back({.rotation = rotation(among) / std::pow(radii.outer, 3),
                            .factor = at_tip(among) / at_tip(alone),
                            .compliance = rotation(among) / rotation(alone)});
  }
  return group;
}

/// The modes of a shaft, which this thread keeps for the last shafts: an assessment asks at some
/// hundred sizes.
std::shared_ptr<const ShaftModes> modes_of(double inner, std::size_t most) {
  struct Known {
    double inner;
    std::shared_ptr<const ShaftModes> modes;
  };
  constexpr std::size_t kKept = 16;
  thread_local std::deque<Known> last;
  for (const Known& known : last)
    if (known.inner == inner && known.modes->most() >= most) return known.modes;
  last.push_front({inner, std::make_shared<const ShaftModes>(inner, most)});
  if (last.size() > kKept) last.pop_back();
  return last.front().modes;
}

/// The jump of a crack, which this thread keeps for the last depths, because only some cracks of a
/// group change from one question to the next.
Jump kept_jump(double inner, const PlacedAnnularCrack& crack, const ShaftModes& modes,
               std::size_t count) {
  struct Known {
    double inner;
    double depth;
    std::size_t count;
    Jump jump;
  };
  constexpr std::size_t kKept = 64;
  thread_local std::deque<Known> last;
  for (const Known& known : last)
    if (known.inner == inner && known.depth == crack.depth && known.count == count) {
      Jump jump = known.jump;
      jump.place = crack.place;
      return jump;
    }
  last.push_front({inner, crack.depth, count, jump_of(crack.place, crack.depth, modes, count)});
  if (last.size() > kKept) last.pop_back();
  return last.front().jump;
}

void require_in_range(std::span<const PlacedAnnularCrack> cracks, const ShaftRadii& radii) {
  if (!(radii.outer > 0 && radii.inner >= 0 && radii.inner < radii.outer))
    throw InputError("radii",
                     fmt::format("outer {:.6g} m and inner {:.6g} m are no shaft; the outer "
                                 "radius must be > 0 and the inner in [0, outer)",
                                 radii.outer, radii.inner));
  const double wall = radii.outer - radii.inner;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const double share = cracks[i].depth / wall;
    if (!(share >= kLeastAnnularDepth && share <= kLargestAnnularDepth &&
          std::isfinite(cracks[i].place)))
      throw InputError(
          fmt::format("cracks[{}]", i),
          fmt::format("the depth is {:.4g} of the wall at {:.6g} m; the depth must be {} "
                      "to {} of the wall, and the place finite",
                      share, cracks[i].place, kLeastAnnularDepth, kLargestAnnularDepth));
  }
  if (const auto pair = touching_annular_cracks(cracks))
    throw InputError(
        fmt::format("cracks[{}]", pair->second),
        fmt::format("is nearer to cracks[{}] than {} of the deeper crack; replace both "
                    "by one crack",
                    pair->first, kLeastAnnularDistance));
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> touching_annular_cracks(
    std::span<const PlacedAnnularCrack> cracks) {
  for (std::size_t j = 1; j < cracks.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (std::abs(cracks[i].place - cracks[j].place) <
          kLeastAnnularDistance * std::max(cracks[i].depth, cracks[j].depth))
        return std::pair(i, j);
  return std::nullopt;
}

std::vector<std::size_t> annular_modes(std::span<const PlacedAnnularCrack> cracks,
                                       const ShaftRadii& radii) {
  // Few different numbers, so that a small change of a depth mostly keeps its number, and the
  // answer has no small step.
  const double wall = radii.outer - radii.inner;
  std::vector<std::size_t> modes;
  for (const PlacedAnnularCrack& crack : cracks) {
    const double least = kLastPhase * wall / (pi * crack.depth);
    modes.push_back(end_of_block(static_cast<int>(std::ceil(2 * std::log2(least)))));
  }
  return modes;
}

AnnularGroup annular_group(std::span<const PlacedAnnularCrack> cracks, const ShaftRadii& radii,
                           const std::vector<std::size_t>& modes_of_cracks) {
  if (cracks.empty()) throw InputError("cracks", "is empty; give at least one crack");
  if (modes_of_cracks.empty()) require_in_range(cracks, radii);
  std::vector<std::size_t> counts =
      modes_of_cracks.empty() ? annular_modes(cracks, radii) : modes_of_cracks;
  for (std::size_t& count : counts) {
    int block = 0;
    while (end_of_block(block) < count) ++block;
    count = end_of_block(block);
  }
  const double inner = radii.inner / radii.outer;
  const std::shared_ptr<const ShaftModes> modes = modes_of(inner, std::ranges::max(counts));
  std::vector<Jump> jumps;
  for (std::size_t j = 0; j < cracks.size(); ++j)
    jumps.push_back(kept_jump(
        inner, {.place = cracks[j].place / radii.outer, .depth = cracks[j].depth / radii.outer},
        *modes, counts[j]));
  std::vector<std::vector<Eigen::MatrixXd>> stress(jumps.size());
  for (std::size_t i = 0; i < jumps.size(); ++i)
    for (std::size_t j = 0; j < jumps.size(); ++j)
      stress[i].push_back(stress_between(jumps[i], jumps[j], i == j, *modes));
  AnnularGroup group = group_of(jumps, stress, radii, kFunctions);
  const AnnularGroup coarse = group_of(jumps, stress, radii, kFewerFunctions);
  for (std::size_t j = 0; j < jumps.size(); ++j)
    group.error = std::max({group.error, std::abs(group.cracks[j].factor - coarse.cracks[j].factor),
                            std::abs(group.cracks[j].compliance - coarse.cracks[j].compliance)});
  return group;
}

}  // namespace strainwave

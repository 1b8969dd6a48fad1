// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/annular_cracks.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Functions of the jump of a crack, and how many fewer estimate the error.
constexpr Eigen::Index kFunctions = 10;
constexpr Eigen::Index kFewerFunctions = 7;
/// Product of wave number and depth at which the sum over the modes ends.
constexpr double kLastPhase = 80;

/// Bessel functions in the precision of their argument, which is all that they need here.
using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
double bessel_j(int order, double x) { return boost::math::cyl_bessel_j(order, x, Plain()); }
double bessel_y(int order, double x) { return boost::math::cyl_neumann(order, x, Plain()); }

/// The modes of a shaft of outer radius 1, in torsion: phi(r) exp(-k |z|) with free surfaces.
class ShaftModes {
 public:
  /// @param inner  inner radius [-]
  /// @param count  of modes
  ShaftModes(double inner, std::size_t count) : inner_(inner) {
    const double step = pi / (1 - inner);
    // The modes are a step apart; the first is at 1.63 steps in a solid shaft and at 1 in a thin
    // tube.
    double begin = 0.8 * step;
    double end = 1.8 * step;
    while (wave_numbers_.size() < count) {
      wave_numbers_.push_back(root(begin, end));
      begin = wave_numbers_.back() + 0.5 * step;
      end = wave_numbers_.back() + 1.5 * step;
    }
    for (const double k : wave_numbers_) {
      second_.push_back(inner > 0 ? bessel_j(2, k * inner) / bessel_y(2, k * inner) : 0.0);
      const std::size_t n = second_.size() - 1;
      const double outside = at(n, 1);
      const double inside = inner > 0 ? inner * at(n, inner) : 0.0;
      norms_.push_back((outside * outside - inside * inside) / 2);  // (CG-10)
    }
  }

  [[nodiscard]] double wave_number(std::size_t n) const { return wave_numbers_[n]; }
  /// Integral of r phi^2 over the wall [-].
  [[nodiscard]] double norm(std::size_t n) const { return norms_[n]; }
  /// phi of mode n at a radius [-].
  [[nodiscard]] double at(std::size_t n, double r) const {
    const double x = wave_numbers_[n] * r;
    return bessel_j(1, x) - (second_[n] == 0 ? 0.0 : second_[n] * bessel_y(1, x));  // (CG-10)
  }

 private:
  /// Zero where the surfaces carry no stress (CG-10).
  [[nodiscard]] double root(double begin, double end) const {
    const auto stress = [&](double k) {
      if (inner_ == 0) return bessel_j(2, k);
      return bessel_j(2, k) * bessel_y(2, k * inner_) - bessel_y(2, k) * bessel_j(2, k * inner_);
    };
    std::uintmax_t steps = 60;
    const auto [below, above] = boost::math::tools::toms748_solve(
        stress, begin, end, boost::math::tools::eps_tolerance<double>(44), steps);
    return (below + above) / 2;
  }

  double inner_;
  std::vector<double> wave_numbers_;
  std::vector<double> second_;  ///< share of the second Bessel function
  std::vector<double> norms_;
};

/// A crack in a shaft of outer radius 1, by the functions of its jump.
struct Jump {
  double place = 0.0;
  double depth = 0.0;
  Eigen::MatrixXd modes;      ///< integral of r phi_n psi_m, a row for each mode
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
  constexpr double kPhaseOfPiece = 24;
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

Jump jump_of(const PlacedAnnularCrack& crack, const ShaftRadii& radii, const ShaftModes& modes,
             std::size_t count) {
  Jump jump;
  jump.place = crack.place / radii.outer;
  jump.depth = crack.depth / radii.outer;
  const double tip = 1 - jump.depth;
  jump.modes = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), kFunctions);
  jump.of_torque = Eigen::VectorXd::Zero(kFunctions);
  jump.at_tip = polynomials(1);
  // s is the root of the distance from the tip over the depth.
  // The phase of the last mode, which moves twice as fast at the surface.
  const double phase = 2 * modes.wave_number(count - 1) * jump.depth;
  for (const auto& [s, weight] : points_for(phase)) {
    const double r = tip + jump.depth * s * s;
    const Eigen::VectorXd psi = r * s * polynomials(1 - 2 * s * s);  // (CG-11)
    const double area = weight * 2 * s * jump.depth * r;
    jump.of_torque += area * r * psi;
    for (std::size_t n = 0; n < count; ++n)
      jump.modes.row(static_cast<Eigen::Index>(n)) += area * modes.at(n, r) * psi.transpose();
  }
  return jump;
}

/// Stress that the functions of one jump cause at another, weighted by the functions there; G = 1.
Eigen::MatrixXd stress_between(const Jump& one, const Jump& other, bool same,
                               const ShaftModes& modes) {
  const Eigen::Index count = std::min(one.modes.rows(), other.modes.rows());
  Eigen::VectorXd weights(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto mode = static_cast<std::size_t>(n);
    const double k = modes.wave_number(mode);
    weights[n] = 0.5 * k * std::exp(-k * std::abs(one.place - other.place)) / modes.norm(mode);
  }
  Eigen::MatrixXd stress = one.modes.topRows(count).transpose() * weights.asDiagonal() *
                           other.modes.topRows(count);  // (CG-11)
  if (same) {
    // The modes that follow see the root at the tip alone; their sum is an integral.
    const double tip = 1 - one.depth;
    const auto last = static_cast<std::size_t>(count);
    const double end = (modes.wave_number(last - 1) + modes.wave_number(last)) / 2;
    stress +=
        one.at_tip * one.at_tip.transpose() * (tip * tip * tip / (8 * one.depth * end));  // (CG-12)
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
    modes.push_back(
        static_cast<std::size_t>(std::ceil(std::pow(2.0, std::ceil(2 * std::log2(least)) / 2))));
  }
  return modes;
}

AnnularGroup annular_group(std::span<const PlacedAnnularCrack> cracks, const ShaftRadii& radii,
                           const std::vector<std::size_t>& modes_of_cracks) {
  if (cracks.empty()) throw InputError("cracks", "is empty; give at least one crack");
  if (modes_of_cracks.empty()) require_in_range(cracks, radii);
  const std::vector<std::size_t> counts =
      modes_of_cracks.empty() ? annular_modes(cracks, radii) : modes_of_cracks;
  const ShaftModes modes(radii.inner / radii.outer, std::ranges::max(counts) + 1);
  std::vector<Jump> jumps;
  for (std::size_t j = 0; j < cracks.size(); ++j)
    jumps.push_back(jump_of(cracks[j], radii, modes, counts[j]));
  std::vector<std::vector<Eigen::MatrixXd>> stress(jumps.size());
  for (std::size_t i = 0; i < jumps.size(); ++i)
    for (std::size_t j = 0; j < jumps.size(); ++j)
      stress[i].push_back(stress_between(jumps[i], jumps[j], i == j, modes));
  AnnularGroup group = group_of(jumps, stress, radii, kFunctions);
  const AnnularGroup coarse = group_of(jumps, stress, radii, kFewerFunctions);
  for (std::size_t j = 0; j < jumps.size(); ++j)
    group.error = std::max({group.error, std::abs(group.cracks[j].factor - coarse.cracks[j].factor),
                            std::abs(group.cracks[j].compliance - coarse.cracks[j].compliance)});
  return group;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/straight_cracks.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "dislocations.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Solves a system whose blocks on the diagonal are those of single cracks.
///
/// GMRES with these blocks as preconditioner needs the fewer steps, the less the cracks influence
/// each other: about ten for gaps of half a length.  A system of one or two cracks, and one that
/// does not converge, is factored.
Eigen::VectorXd solved_by_blocks(const Eigen::MatrixXd& matrix, Eigen::Index block,
                                 const Eigen::VectorXd& right) {
  constexpr int kMostSteps = 120;
  constexpr double kTolerance = 1e-14;  // of the right-hand side
  const Eigen::Index blocks = matrix.rows() / block;
  const double size = right.norm();
  if (size == 0) return right;
  if (blocks <= 2) return matrix.partialPivLu().solve(right);
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXd>> alone;
  for (Eigen::Index j = 0; j < blocks; ++j)
    alone.emplace_back(matrix.block(j * block, j * block, block, block));
  const auto preconditioned = [&](const Eigen::VectorXd& of) {
    Eigen::VectorXd result(of.size());
    for (Eigen::Index j = 0; j < blocks; ++j)
      result.segment(j * block, block) =
          alone[static_cast<std::size_t>(j)].solve(of.segment(j * block, block));
    return result;
  };
  // Orthonormal basis of the Krylov space of matrix times preconditioner, and the triangle of its
  // least squares by Givens rotations.
  Eigen::MatrixXd basis(right.size(), kMostSteps + 1);
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(kMostSteps + 1, kMostSteps);
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(kMostSteps + 1);
  std::vector<Eigen::JacobiRotation<double>> turns;
  basis.col(0) = right / size;
  rest[0] = size;
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::VectorXd next = matrix * preconditioned(basis.col(step));
    for (int pass = 0; pass < 2; ++pass)  // twice, against rounding
      for (int i = 0; i <= step; ++i) {
        const double along = basis.col(i).dot(next);
        triangle(i, step) += along;
        next -= along * basis.col(i);
      }
    const double left = next.norm();
    for (int i = 0; i < step; ++i) {
      const double upper = triangle(i, step);
      const double lower = triangle(i + 1, step);
      const auto& turn = turns[static_cast<std::size_t>(i)];
      triangle(i, step) = turn.c() * upper + turn.s() * lower;
      triangle(i + 1, step) = -turn.s() * upper + turn.c() * lower;
    }
    const double length = std::hypot(triangle(step, step), left);
    turns.emplace_back(triangle(step, step) / length, left / length);
    triangle(step, step) = length;
    rest[step + 1] = -turns.back().s() * rest[step];
    rest[step] *= turns.back().c();
    if (std::abs(rest[step + 1]) <= kTolerance * size) {
      const Eigen::VectorXd weights = triangle.topLeftCorner(step + 1, step + 1)
                                          .triangularView<Eigen::Upper>()
                                          .solve(rest.head(step + 1));
      return preconditioned(basis.leftCols(step + 1) * weights);
    }
    basis.col(step + 1) = next / left;
  }
  return matrix.partialPivLu().solve(right);
}

/// The densities of all cracks at their points, for one order.
class Densities {
 public:
  Densities(std::span<const StraightCrack> cracks, int order, const std::optional<double>& period)
      : cracks_(cracks), n_(order), points_(order), period_(period), closed_(cracks.size(), false) {
    for (const StraightCrack& crack : cracks) turn_.push_back(std::exp(kI * crack.angle));
  }

  /// Solves for the densities, and finds the cracks that are closed (CG-4).
  void solve(const SheetStress& stress) {
    // Each crack alone tells where to begin.  Most groups need one or two passes.
    const std::size_t most = 4 * cracks_.size() + 4;
    for (std::size_t j = 0; j < cracks_.size(); ++j)
      closed_[j] = tractions_of(stress, cracks_[j].angle).normal < -kRounding * largest_of(stress);
    for (std::size_t pass = 0; pass < most; ++pass) {
      solve_plane(stress);
      bool changed = false;
      for (std::size_t j = 0; j < cracks_.size(); ++j) {
        const bool wrong = closed_[j] ? pull_at_middle(j, stress) > kRounding * largest_of(stress)
                                      : opening_at_middle(j) < -kRounding * density_of(j);
        if (wrong) closed_[j] = !closed_[j];
        changed = changed || wrong;
      }
      settled_ = !changed;
      if (settled_) break;
    }
    solve_out_of_plane(stress);
  }
  /// Whether `solve` found which cracks are closed.
  [[nodiscard]] bool settled() const { return settled_; }

  /// Solves for another stress with the same closed cracks.
  void solve_in_this_state(const SheetStress& stress) {
    solve_plane(stress);
    solve_out_of_plane(stress);
  }

  [[nodiscard]] GroupedCrack crack(std::size_t j) const {
    const auto segment = [&](const Eigen::VectorXd& of) -> Eigen::VectorXd {
      return of.segment(static_cast<Eigen::Index>(j) * n_, n_);
    };
    const Eigen::VectorXd normal = segment(normal_);
    const Eigen::VectorXd shear = segment(shear_);
    const Eigen::VectorXd out = segment(out_);
    const double root = std::sqrt(pi * cracks_[j].half_length);
    GroupedCrack result;
    result.closed = closed_[j];
    // (CG-5)
    result.ahead = {.mode_1 = 2 * pi * root * at_end(normal),
                    .mode_2 = 2 * pi * root * at_end(shear),
                    .mode_3 = pi * root * at_end(out)};
    result.behind = {.mode_1 = -2 * pi * root * at_end(normal.reverse()),
                     .mode_2 = -2 * pi * root * at_end(shear.reverse()),
                     .mode_3 = -pi * root * at_end(out.reverse())};
    return result;
  }

  /// Work of a stress on the faces of a crack, for which `solve` was called last.
  struct Work {
    double in_plane = 0.0;
    double out_of_plane = 0.0;
  };
  [[nodiscard]] Work work(std::size_t j, const SheetStress& stress) const {
    const auto first = static_cast<Eigen::Index>(j) * n_;
    // (CG-6): the opening is the integral of the density, so its integral is the first moment.
    const double a = cracks_[j].half_length;
    const auto moment = [&](const Eigen::VectorXd& of) {
      return pi / n_ * a * a * points_.density.dot(of.segment(first, n_));
    };
    const Tractions t = tractions_of(stress, cracks_[j].angle);
    return {.in_plane = 8 * pi * (t.normal * moment(normal_) + t.shear * moment(shear_)),
            .out_of_plane = 4 * pi * t.out * moment(out_)};
  }

 private:
  [[nodiscard]] Complex place(std::size_t j, double s) const {
    return cracks_[j].centre + s * cracks_[j].half_length * turn_[j];
  }

  /// Share of densities or stresses below which an opening or a pull is rounding.
  static constexpr double kRounding = 1e-10;

  static double largest_of(const SheetStress& s) {
    return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.xy)});
  }

  /// Normal stress on the closed faces of a crack near its middle; > 0 pulls.
  [[nodiscard]] double pull_at_middle(std::size_t i, const SheetStress& stress) const {
    const Complex here = place(i, points_.force[n_ / 2 - 1]);
    double pull = tractions_of(stress, cracks_[i].angle).normal;
    for (std::size_t j = 0; j < cracks_.size(); ++j) {
      const double weight = pi / n_ * cracks_[j].half_length;
      for (int k = 0; k < n_; ++k) {
        const Influence at = influence(i, j, here - place(j, points_.density[k]));
        const Eigen::Index of = static_cast<Eigen::Index>(j) * n_ + k;
        pull += weight * (at.of_normal.real() * normal_[of] + at.of_shear.real() * shear_[of]);
      }
    }
    return pull;
  }

  /// The largest density of a crack.
  [[nodiscard]] double density_of(std::size_t j) const {
    const auto first = static_cast<Eigen::Index>(j) * n_;
    return std::max(normal_.segment(first, n_).cwiseAbs().maxCoeff(),
                    shear_.segment(first, n_).cwiseAbs().maxCoeff());
  }

  /// A positive multiple of the opening of the faces at the middle.
  [[nodiscard]] double opening_at_middle(std::size_t j) const {
    // The density is a polynomial over a root.  The part of the opening from one end to the middle
    // is that of its odd Chebyshev terms.
    double opening = 0.0;
    for (int m = 1; m < n_; m += 2) {
      double coefficient = 0.0;
      for (int k = 0; k < n_; ++k)
        coefficient += 2.0 / n_ * normal_[static_cast<Eigen::Index>(j) * n_ + k] *
                       std::cos(m * (2 * k + 1) * pi / (2 * n_));
      // Integral of T_m/sqrt(1 - s^2) from 0 to 1.
      opening += coefficient * std::sin(m * pi / 2) / m;
    }
    return opening;
  }

  /// @param w  from the place of the density to that of the traction
  [[nodiscard]] Influence influence(std::size_t on, std::size_t by, const Complex& w) const {
    return influence_of(turn_[on], turn_[by], w, sums_of(w, period_));
  }

  void solve_plane(const SheetStress& stress) {
    const auto count = static_cast<Eigen::Index>(cracks_.size());
    const Eigen::Index block = Eigen::Index{2} * n_;  // of one crack
    const Eigen::Index size = block * count;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    // Unknowns and equations of a crack: n of normal, then n of shear; the last of each n equations
    // closes the crack at its ends.
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      const auto row = block * static_cast<Eigen::Index>(i);
      const Tractions t = tractions_of(stress, cracks_[i].angle);
      for (int r = 0; r + 1 < n_; ++r) {
        if (!closed_[i]) right[row + r] = -t.normal;
        right[row + n_ + r] = -t.shear;
        const Complex here = place(i, points_.force[r]);
        for (std::size_t j = 0; j < cracks_.size(); ++j) {
          const auto column = block * static_cast<Eigen::Index>(j);
          const double weight = pi / n_ * cracks_[j].half_length;
          for (int k = 0; k < n_; ++k) {
            const Influence at = influence(i, j, here - place(j, points_.density[k]));
            if (!closed_[i]) {
              matrix(row + r, column + k) = weight * at.of_normal.real();
              matrix(row + r, column + n_ + k) = weight * at.of_shear.real();
            }
            matrix(row + n_ + r, column + k) = weight * at.of_normal.imag();
            matrix(row + n_ + r, column + n_ + k) = weight * at.of_shear.imag();
          }
        }
      }
      for (int k = 0; k < n_; ++k) {
        if (!closed_[i]) matrix(row + n_ - 1, row + k) = 1.0;
        matrix(row + block - 1, row + n_ + k) = 1.0;
      }
      if (closed_[i])  // the faces cannot part
        for (int k = 0; k < n_; ++k) matrix(row + k, row + k) = 1.0;
    }
    const Eigen::VectorXd solved = solved_by_blocks(matrix, block, right);
    normal_.resize(n_ * count);
    shear_.resize(n_ * count);
    for (Eigen::Index j = 0; j < count; ++j) {
      normal_.segment(j * n_, n_) = solved.segment(2 * j * n_, n_);
      shear_.segment(j * n_, n_) = solved.segment(2 * j * n_ + n_, n_);
    }
  }

  void solve_out_of_plane(const SheetStress& stress) {
    const auto size = n_ * static_cast<Eigen::Index>(cracks_.size());
    out_ = Eigen::VectorXd::Zero(size);
    if (stress.xz == 0 && stress.yz == 0) return;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      const auto row = n_ * static_cast<Eigen::Index>(i);
      const Tractions t = tractions_of(stress, cracks_[i].angle);
      for (int r = 0; r + 1 < n_; ++r) {
        right[row + r] = -t.out;
        const Complex here = place(i, points_.force[r]);
        for (std::size_t j = 0; j < cracks_.size(); ++j) {
          const double weight = pi / n_ * cracks_[j].half_length;
          for (int k = 0; k < n_; ++k)
            matrix(row + r, n_ * static_cast<Eigen::Index>(j) + k) =
                weight * influence(i, j, here - place(j, points_.density[k])).out;
        }
      }
      for (int k = 0; k < n_; ++k) matrix(row + n_ - 1, row + k) = 1.0;
    }
    out_ = solved_by_blocks(matrix, n_, right);
  }

  std::span<const StraightCrack> cracks_;
  int n_;
  Points points_;
  std::optional<double> period_;
  std::vector<bool> closed_;
  bool settled_ = false;
  std::vector<Complex> turn_;  ///< exp(i angle) of each crack
  Eigen::VectorXd normal_;
  Eigen::VectorXd shear_;
  Eigen::VectorXd out_;
};

/// All cracks of a group.
std::vector<GroupedCrack> cracks_of(const Densities& densities, std::size_t count) {
  std::vector<GroupedCrack> result;
  for (std::size_t j = 0; j < count; ++j) result.push_back(densities.crack(j));
  return result;
}

/// Sets work and ratios of a group whose densities are those of `of` (CG-6).
/// @param stress  that decided which cracks are closed
void set_compliance(CrackGroup& group, const Densities& densities,
                    std::span<const StraightCrack> cracks, const SheetStress& stress,
                    const SheetStress& of) {
  double alone = 0.0;
  double alone_out = 0.0;
  double open_or_closed = 0.0;  // the same as `alone` if all cracks were open
  for (std::size_t j = 0; j < cracks.size(); ++j) {
    const auto work = densities.work(j, of);
    group.work += work.in_plane;
    group.work_out_of_plane += work.out_of_plane;
    const Tractions t = tractions_of(of, cracks[j].angle);
    const double square = 2 * pi * cracks[j].half_length * cracks[j].half_length;
    const bool open = tractions_of(stress, cracks[j].angle).normal > 0;
    alone += square * ((open ? t.normal * t.normal : 0.0) + t.shear * t.shear);
    alone_out += square * t.out * t.out;
    open_or_closed += square * (t.normal * t.normal + t.shear * t.shear);
  }
  constexpr double kRounding = 1e-20;
  if (alone > kRounding * open_or_closed) group.compliance_ratio = group.work / alone;
  if (alone_out > 0) group.compliance_ratio_out_of_plane = group.work_out_of_plane / alone_out;
}

double cross(const Complex& a, const Complex& b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// Distance of a point from a segment.
double distance_to(const Complex& point, const Complex& from, const Complex& to) {
  const Complex along = to - from;
  const double share =
      std::clamp(((point - from) * std::conj(along)).real() / std::norm(along), 0.0, 1.0);
  return std::abs(point - from - share * along);
}

}  // namespace

double distance(const StraightCrack& one, const StraightCrack& other) {
  const auto ends = [](const StraightCrack& crack) {
    const Complex half = crack.half_length * std::exp(kI * crack.angle);
    return std::pair{crack.centre - half, crack.centre + half};
  };
  const auto [a, b] = ends(one);
  const auto [c, d] = ends(other);
  const bool crosses = cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
                       cross(d - c, a - c) * cross(d - c, b - c) < 0;
  if (crosses) return 0.0;
  return std::min(
      {distance_to(a, c, d), distance_to(b, c, d), distance_to(c, a, b), distance_to(d, a, b)});
}

std::optional<std::pair<std::size_t, std::size_t>> touching_cracks(
    std::span<const StraightCrack> cracks, const std::optional<double>& period) {
  if (period) require(*period > 0 && std::isfinite(*period), "period", *period, "m", "> 0");
  for (const StraightCrack& crack : cracks)
    require(crack.half_length > 0 && std::isfinite(crack.half_length), "half_length",
            crack.half_length, "m", "> 0");
  for (std::size_t i = 0; i < cracks.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double reach = std::abs(cracks[i].centre - cracks[j].centre) + cracks[i].half_length +
                           cracks[j].half_length;
      const int images = period ? static_cast<int>(std::ceil(reach / *period)) : 0;
      for (int k = -images; k <= images; ++k) {
        if (i == j && k == 0) continue;
        StraightCrack moved = cracks[j];
        if (period) moved.centre += k * *period;
        if (distance(cracks[i], moved) <= 1e-9 * cracks[i].half_length) return std::pair{j, i};
      }
    }
  return std::nullopt;
}

CrackGroup crack_group(std::span<const StraightCrack> cracks, const SheetStress& stress,
                       const GroupOptions& options) {
  constexpr int kLeastOrder = 4;
  constexpr int kMostOrder = 400;
  require(options.order >= kLeastOrder && options.order <= kMostOrder, "order", options.order, "1",
          fmt::format(">= {} and <= {}", kLeastOrder, kMostOrder));
  if (const auto touching = touching_cracks(cracks, options.period)) {
    const auto [j, i] = *touching;
    throw InputError("cracks", i == j ? fmt::format("crack {} touches the next one of its row", i)
                                      : fmt::format("cracks {} and {} cross or touch", j, i));
  }
  Densities densities(cracks, options.order, options.period);
  densities.solve(stress);
  CrackGroup group{.cracks = cracks_of(densities, cracks.size()), .settled = densities.settled()};
  Densities coarse(cracks, 2 * options.order / 3, options.period);
  coarse.solve(stress);
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t j = 0; j < cracks.size(); ++j) {
    const GroupedCrack of_coarse = coarse.crack(j);
    for (const auto tip : {&GroupedCrack::behind, &GroupedCrack::ahead})
      for (const auto mode : {&TipFactors::mode_1, &TipFactors::mode_2, &TipFactors::mode_3}) {
        const double K = group.cracks[j].*tip.*mode;
        largest = std::max(largest, std::abs(K));
        change = std::max(change, std::abs(K - of_coarse.*tip.*mode));
      }
  }
  if (largest > 0) group.error = change / largest;
  if (options.compliance_of) densities.solve_in_this_state(*options.compliance_of);
  set_compliance(group, densities, cracks, stress, options.compliance_of.value_or(stress));
  return group;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/crack_row.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

#include "dislocations.hpp"
#include "strainwave/core/chebyshev_cells.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Even number of points whose error is about 1e-13, from the distance to the neighbours (CG-3).
int order_of(double gap) {
  constexpr double kDigits = 28.0;
  constexpr int kLeast = 8;
  constexpr int kMost = 200;
  const double rate = std::log10(gap + std::hypot(1.0, gap));
  const double points = std::ceil(kDigits / (2 * rate));
  return std::clamp(2 * static_cast<int>(points / 2) + 4, kLeast, kMost);
}

/// The equations of a crack and its images in a row of pitch 1 (CG-7).
///
/// Turned half round, the row is the same, so the densities are odd: half of the points suffice.
class Row {
 public:
  Row(double share, double angle) : a_(share / 2), turn_(std::exp(kI * (pi / 2 + angle))) {
    const double gap = row_gap(share, angle);
    require(gap > 0, "share", share, "1", "the cracks of a row must not touch");
    n_ = order_of(gap);
    half_ = n_ / 2;
    const Points points(n_);
    matrix_.resize(n_, n_);
    for (int r = 0; r < half_; ++r)
      for (int k = 0; k < half_; ++k) {
        const double t = points.force[r];
        const double s = points.density[k];
        const Influence near = at(t - s);
        const Influence far = at(t + s);  // of the opposite density
        const double weight = pi / n_ * a_;
        const Complex normal = weight * (near.of_normal - far.of_normal);
        const Complex shear = weight * (near.of_shear - far.of_shear);
        matrix_(r, k) = normal.real();
        matrix_(r, half_ + k) = shear.real();
        matrix_(half_ + r, k) = normal.imag();
        matrix_(half_ + r, half_ + k) = shear.imag();
      }
  }

  [[nodiscard]] RowFactors apart() const {
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n_, 2);
    right.col(0).head(half_).setConstant(-1.0);
    right.col(1).tail(half_).setConstant(-1.0);
    const Eigen::MatrixXd densities = matrix_.partialPivLu().solve(right);
    const auto factor = [&](int mode, int load) {
      return at_tip(densities.col(load).segment(Eigen::Index{mode} * half_, half_));
    };
    // A positive shear of (FR-6) has the opposite sense of S.
    return {.opening_by_normal = factor(0, 0),
            .sliding_by_normal = -factor(1, 0),
            .opening_by_shear = -factor(0, 1),
            .sliding_by_shear = factor(1, 1)};
  }

  [[nodiscard]] double pressed() const { return at_tip(sliding()); }

  [[nodiscard]] PullOfRow pull() const {
    // A positive shear of (FR-6) has the opposite sense of S.
    const Eigen::VectorXd pulls = -matrix_.topRightCorner(half_, half_) * sliding();
    return {.least = pulls.minCoeff(), .most = pulls.maxCoeff()};
  }

 private:
  /// Densities of pressed faces under a unit shear.
  [[nodiscard]] Eigen::VectorXd sliding() const {
    return matrix_.bottomRightCorner(half_, half_)
        .partialPivLu()
        .solve(Eigen::VectorXd::Constant(half_, -1.0));
  }
  /// @param distance  from the density to the traction, over a
  [[nodiscard]] Influence at(double distance) const {
    const Complex w = a_ * distance * turn_;
    return influence_of(turn_, turn_, w, sums_of(w, 1.0));
  }
  /// K over sqrt(pi a) from the densities of one half (CG-5).
  [[nodiscard]] double at_tip(const Eigen::VectorXd& half) const {
    Eigen::VectorXd whole(n_);
    whole.head(half_) = half;
    whole.tail(half_) = -half.reverse();
    return 2 * pi * at_end(whole);
  }

  double a_;
  Complex turn_;
  int n_ = 0;
  int half_ = 0;
  Eigen::MatrixXd matrix_;  ///< rows: normal, then shear stress; columns likewise
};

/// The factors of rows of one angle over the share, as polynomials that fill themselves.  A crack
/// is integrated over its size, so that the same angle is asked for many times.
class RowTable {
 public:
  explicit RowTable(double angle)
      : by_normal_(
            [angle](const ChebyshevCells::Place& at, ChebyshevCells::Values& values) {
              const RowFactors row = apart_at(std::expm1(at[0]), angle);
              values = {row.opening_by_normal, row.sliding_by_normal};
              return true;
            },
            options(2)),
        by_shear_(
            [angle](const ChebyshevCells::Place& at, ChebyshevCells::Values& values) {
              const RowFactors row = apart_at(std::expm1(at[0]), angle);
              values = {row.opening_by_shear, row.sliding_by_shear};
              return true;
            },
            options(2)),
        pressed_(
            [angle](const ChebyshevCells::Place& at, ChebyshevCells::Values& values) {
              values = {pressed_at(std::expm1(at[0]), angle)};
              return true;
            },
            options(1)),
        angle_(angle),
        // A box must not reach the cracks that touch.
        end_(std::expm1(std::log1p(largest_row_share(angle, kTouching)) - kWidth)) {}

  [[nodiscard]] RowFactors apart(double share) {
    ChebyshevCells::Values normal{};
    ChebyshevCells::Values shear{};
    const ChebyshevCells::Place at{std::log1p(share)};
    if (share > end_ || !ChebyshevCells::Reader(by_normal_)(at, normal) ||
        !ChebyshevCells::Reader(by_shear_)(at, shear))
      return apart_at(share, angle_);
    return {normal[0], normal[1], shear[0], shear[1]};
  }
  [[nodiscard]] double pressed(double share) {
    ChebyshevCells::Values values{};
    if (share > end_ || !ChebyshevCells::Reader(pressed_)({std::log1p(share)}, values))
      return pressed_at(share, angle_);
    return values[0];
  }

  [[nodiscard]] static RowFactors apart_at(double share, double angle) {
    return share == 0 ? RowFactors{1.0, 0.0, 0.0, 1.0} : Row(share, angle).apart();
  }
  [[nodiscard]] static double pressed_at(double share, double angle) {
    return share == 0 ? 1.0 : Row(share, angle).pressed();
  }

 private:
  static constexpr double kTouching = 0.05;  ///< least gap in a box, over the half length
  static constexpr double kWidth = 0.125;    ///< of the boxes, in ln(1 + share)
  static ChebyshevCells::Options options(std::size_t values) {
    return {.widths = {kWidth}, .values = values, .tolerance = 1e-12};
  }

  ChebyshevCells by_normal_;
  ChebyshevCells by_shear_;
  ChebyshevCells pressed_;
  double angle_;
  double end_;
};

/// The table of an angle.  Up to 64 tables are kept: they save time and do not change the answer,
/// which depends on the angle and the share alone.
std::shared_ptr<RowTable> table_of(double angle) {
  constexpr std::size_t kKept = 64;
  static std::mutex mutex;
  static std::map<double, std::shared_ptr<RowTable>> kept;
  const std::lock_guard lock(mutex);
  auto& table = kept[angle];
  if (table) return table;
  auto made = std::make_shared<RowTable>(angle);
  if (kept.size() > kKept) {
    kept.clear();
    kept[angle] = made;
  } else {
    table = made;
  }
  return made;
}

/// f(share, angle) with its derivatives, by differences of fourth order.  f is even and smooth in
/// the share.
template <std::size_t N, class F>
std::array<CrackReal, N> with_derivatives(const CrackReal& share, const CrackReal& angle,
                                          const F& f) {
  // Beside neighbours that touch, the step is short.
  const double step = 1e-3 * std::min(1.0, row_gap(std::max(share.value, 1e-6), angle.value));
  const auto slopes = [&](double along_share, double along_angle) {
    const auto at = [&](double steps) -> std::array<double, N> {
      return f(std::abs(share.value + steps * along_share), angle.value + steps * along_angle);
    };
    const auto far_ahead = at(2.0);
    const auto ahead = at(1.0);
    const auto behind = at(-1.0);
    const auto far_behind = at(-2.0);
    std::array<double, N> slope{};
    for (std::size_t i = 0; i < N; ++i)
      slope[i] = (8 * (ahead[i] - behind[i]) - (far_ahead[i] - far_behind[i])) / (12 * step);
    return slope;
  };
  const std::array<double, N> value = f(share.value, angle.value);
  const auto by_share = slopes(step, 0.0);
  const auto by_angle = slopes(0.0, step);
  std::array<CrackReal, N> result;
  for (std::size_t i = 0; i < N; ++i)
    result[i] = chain(share, value[i], by_share[i]) + chain(angle, 0.0, by_angle[i]);
  return result;
}

}  // namespace

RowFactors row_factors(double share, double angle) { return table_of(angle)->apart(share); }

BasicRowFactors<CrackReal> row_factors(const CrackReal& share, const CrackReal& angle) {
  const auto f = with_derivatives<4>(share, angle, [](double x, double beta) {
    const RowFactors row = row_factors(x, beta);
    return std::array{row.opening_by_normal, row.sliding_by_normal, row.opening_by_shear,
                      row.sliding_by_shear};
  });
  return {f[0], f[1], f[2], f[3]};
}

double pressed_row(double share, double angle) { return table_of(angle)->pressed(share); }

CrackReal pressed_row(const CrackReal& share, const CrackReal& angle) {
  return with_derivatives<1>(
      share, angle, [](double x, double beta) { return std::array{pressed_row(x, beta)}; })[0];
}

PullOfRow pull_of_row(double share, double angle) { return Row(share, angle).pull(); }

double row_gap(double share, double angle) {
  const StraightCrack crack{.centre = 0.0, .half_length = share / 2, .angle = pi / 2 + angle};
  StraightCrack next = crack;
  next.centre = 1.0;
  const double gap = 2 * distance(crack, next) / share;
  constexpr double kRounding = 1e-12;
  return gap > kRounding ? gap : 0.0;
}

double largest_row_share(double angle, double gap) {
  // Beyond a share of |sin| the tips pass each other, and the gap is that between the lines.
  const double sine = std::abs(std::sin(angle));
  const double cosine = std::abs(std::cos(angle));
  const double between_lines = 2 * cosine / gap;
  if (between_lines >= sine) return between_lines;
  // (sin/x - 1)^2 + (cos/x)^2 = (gap/2)^2 for the share x.
  return 1 / (sine + std::sqrt(std::max(0.0, gap * gap / 4 - cosine * cosine)));
}

}  // namespace strainwave

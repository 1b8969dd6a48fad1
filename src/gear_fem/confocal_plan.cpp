// SPDX-License-Identifier: Apache-2.0
#include "confocal_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Largest semi-axis of the ellipses over the distance to the nearest side of the patch.
constexpr double kRoundShare = 0.6;
/// Longest crack that a plan for a given length must hold, over that length.
constexpr double kNeighbour = 1.01;
/// Longest step between ellipses over the step between hyperbolas.
constexpr double kLongestStep = 2;
/// Number of sectors on either side of a tip that the rings of the tip replace.
constexpr int kTipSectors = 2;
/// Half a side of the patch over the longest cell round the tube, unless the crack needs more.
constexpr double kPatchCells = 1.3;
/// Radius of the outermost circle about a tip over half the square's side.
constexpr double kCircle = 0.65;

/// The rectangular patch of cells about the crack.
class Patch {
 public:
  explicit Patch(const ConfocalPlan& plan)
      : plan_(plan), sector_(2 * pi / plan.sectors), nearest_(nearest_side(plan)) {
    const auto side = [this](double reach) {  // avoids a very thin grid beyond the patch
      return reach < 1.4 * nearest_ ? reach : nearest_;
    };
    width_ = side(plan.half_round);
    below_ = side(plan.below);
    above_ = side(plan.above);
    // The first two steps between ellipses equal a sector, because the rings need a square.
    xi_ = {0, sector_, 2 * sector_};
    double step = sector_;
    while (true) {
      step = std::min(step * plan.stretch, kLongestStep * sector_);
      if (plan.sized_for * std::cosh(xi_.back() + step) > kRoundShare * nearest_) break;
      xi_.push_back(xi_.back() + step);
    }
    // Layers from the last ellipse to the rectangle.
    const double outermost = plan.half_length * std::cosh(xi_.back());
    const double growth = std::log(nearest_ / outermost);
    const double sized_for = std::log(nearest_ / (plan.sized_for * std::cosh(xi_.back())));
    const int beyond = std::max(1, static_cast<int>(std::ceil(sized_for / step - 0.2)));
    for (int i = 0; i <= beyond; ++i)
      share_.push_back(std::expm1(growth * i / beyond) / std::expm1(growth));
    const double first_corner = (-pi / 4 - plan.direction) / sector_;
    corner_ = static_cast<int>(std::lround(first_corner));
  }

  void add_to(std::vector<PlanCell>& cells) const {
    for (std::size_t i = 0; i + 1 < xi_.size(); ++i)
      for (int k = 0; k < plan_.sectors; ++k)
        if (i >= kTipSectors || !beside_tip(k))
          cells.push_back({.map =
                               [self = *this, i, k](double u, double v) {
                                 return self.confocal({(1 - u) * self.xi_[i] + u * self.xi_[i + 1],
                                                       (k + v) * self.sector_});
                               },
                           .half = half(k)});
    for (int tip = 0; tip < 2; ++tip) add_tip(tip, cells);
    for (std::size_t i = 0; i + 1 < share_.size(); ++i)
      for (int k = 0; k < plan_.sectors; ++k)
        cells.push_back({.map =
                             [self = *this, i, k](double u, double v) {
                               return blend(
                                   self.confocal({self.xi_.back(), (k + v) * self.sector_}),
                                   blend(self.on_rectangle(k), self.on_rectangle(k + 1), v),
                                   (1 - u) * self.share_[i] + u * self.share_[i + 1]);
                             },
                         .half = half(k)});
  }

  /// Grid lines on the sides of the patch, round the tube and along it.
  [[nodiscard]] std::vector<double> round_lines() const { return even(-width_, width_); }
  [[nodiscard]] std::vector<double> along_lines() const { return even(-below_, above_); }

 private:
  static double nearest_side(const ConfocalPlan& plan) {
    const double room = std::min({plan.below, plan.above, plan.half_round});
    const double needed =
        kNeighbour * plan.sized_for * std::cosh(kTipSectors * 2 * pi / plan.sectors) / 0.9;
    if (!(room > needed))
      throw InputError("half_length",
                       fmt::format("the crack needs a clear distance of {:.4g} mm from its middle "
                                   "to either {} and half-way round, but only {:.4g} mm is "
                                   "available",
                                   needed / units::mm, plan.end, room / units::mm));
    // A patch larger than a few grid cells would have larger cells than the grid.
    return std::min(room,
                    std::max({kPatchCells * plan.longest_round, 2.5 * plan.sized_for, needed}));
  }

  [[nodiscard]] bool beside_tip(int sector) const {
    const int half = plan_.sectors / 2;
    return sector % half < kTipSectors || sector % half >= half - kTipSectors;
  }
  [[nodiscard]] int half(int sector) const { return sector < plan_.sectors / 2 ? 1 : -1; }

  /// Maps (xi, eta) to (s, y); (FE-46).
  [[nodiscard]] PlanPoint confocal(const PlanPoint& at) const {
    const double along = plan_.half_length * std::cosh(at[0]) * std::cos(at[1]);
    const double across = plan_.half_length * std::sinh(at[0]) * std::sin(at[1]);
    const double c = std::cos(plan_.direction);
    const double s = std::sin(plan_.direction);
    return {c * along - s * across, s * along + c * across};
  }

  [[nodiscard]] std::vector<double> even(double from, double to) const {
    const int count = plan_.sectors / 4;
    std::vector<double> lines;
    for (int i = 0; i <= count; ++i) lines.push_back(from + (to - from) * i / count);
    lines.back() = to;
    return lines;
  }

  /// Point at which the line between two sectors meets the rectangle.
  [[nodiscard]] PlanPoint on_rectangle(int line) const {
    const int quarter = plan_.sectors / 4;
    const int from_corner = ((line - corner_) % plan_.sectors + plan_.sectors) % plan_.sectors;
    const auto i = static_cast<std::size_t>(from_corner % quarter);
    const std::vector<double> s = round_lines();
    const std::vector<double> y = along_lines();
    const auto last = static_cast<std::size_t>(quarter);
    switch (from_corner / quarter) {
      case 0:
        return {width_, y[i]};
      case 1:
        return {s[last - i], above_};
      case 2:
        return {-width_, y[last - i]};
      default:
        return {s[i], -below_};
    }
  }

  /// Adds the rings of a tip in the half plane xi >= 0 about (0, 0) or (0, pi); half a turn there
  /// is a whole turn about the tip.
  void add_tip(int tip, std::vector<PlanCell>& cells) const {
    const auto on_circle = [](double radius, int eighth, double v) {
      const double angle = (eighth < 4 ? eighth + v : eighth - 8 + v) * pi / 8;
      return PlanPoint{radius * std::cos(angle), radius * std::sin(angle)};
    };
    // Corners of the cells on the three sides of the square, from (0, -2) up to (0, 2).
    const auto on_square = [sector = sector_](int eighth, double v) {
      constexpr std::array<PlanPoint, 9> kSquare{
          {{0, -2}, {1, -2}, {2, -2}, {2, -1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}}};
      const auto from = static_cast<std::size_t>((eighth + 4) % 8);
      const PlanPoint point = blend(kSquare.at(from), kSquare.at(from + 1), v);
      return PlanPoint{sector * point[0], sector * point[1]};
    };
    const double c = std::cos(plan_.direction);
    const double s = std::sin(plan_.direction);
    const auto add = [&](int ring, int side, auto map) {
      cells.push_back({.map =
                           [self = *this, tip, map](double u, double v) {
                             const PlanPoint at = map(u, v);
                             return self.confocal({at[0], at[1] + tip * pi});
                           },
                       .half = tip == 0 ? side : -side,
                       .tip = PlanTipPlace{.tip = static_cast<std::size_t>(tip),
                                           .ring = ring,
                                           .side = side,
                                           .growth = tip == 0 ? PlanPoint{c, s} : PlanPoint{-c, -s},
                                           .square_root = true}});
    };
    const double core = ring_radius(0);
    for (const int k : {0, 2, 4, 6})
      add(-1, k < 4 ? 1 : -1, [=](double u, double v) {
        const PlanPoint a = on_circle(core, k, 0);
        const PlanPoint b = on_circle(core, k, 1);
        const PlanPoint d = on_circle(core, k, 2);
        return blend({u * a[0], u * a[1]}, blend(d, b, u), v);
      });
    for (int ring = 0; ring <= plan_.rings; ++ring)
      for (int k = 0; k < 8; ++k) {
        const double inner = ring_radius(ring);
        const double outer = ring_radius(ring + 1);
        add(ring, k < 4 ? 1 : -1, [=, last = plan_.rings](double u, double v) {
          const PlanPoint from = ring == 0
                                     ? blend(on_circle(inner, k, 0), on_circle(inner, k, 1), v)
                                     : on_circle(inner, k, v);
          return blend(from, ring == last ? on_square(k, v) : on_circle(outer, k, v), u);
        });
      }
  }

  /// Inner radius of a circular ring in (xi, eta); the radius about the tip halves from ring to
  /// ring.
  [[nodiscard]] double ring_radius(int ring) const {
    return kCircle * kTipSectors * sector_ * std::pow(0.5, 0.5 * (plan_.rings - ring));
  }

  ConfocalPlan plan_;
  double sector_;
  double nearest_;
  double width_ = 0;
  double below_ = 0;
  double above_ = 0;
  std::vector<double> xi_;
  std::vector<double> share_;
  int corner_ = 0;
};

/// The lines of the patch and the lines beyond it.
std::vector<double> continued(const std::vector<double>& patch, double from, double to,
                              double longest) {
  constexpr double kGrowth = 1.5;
  const double gap = patch[1] - patch[0];
  const auto beyond = [&](double start, double end) {
    return std::abs(end - start) < 1e-9 * gap
               ? std::vector<double>{}
               : graded_lines(start, end, gap, kGrowth, std::max(longest, gap));
  };
  std::vector<double> lines = beyond(patch.front(), from);
  std::reverse(lines.begin(), lines.end());
  lines.insert(lines.end(), patch.begin(), patch.end());
  const std::vector<double> after = beyond(patch.back(), to);
  lines.insert(lines.end(), after.begin(), after.end());
  return lines;
}

}  // namespace

ConfocalCells confocal_plan(const ConfocalPlan& plan) {
  const Patch patch(plan);
  ConfocalCells result;
  patch.add_to(result.cells);
  const std::vector<double> inner_s = patch.round_lines();
  const std::vector<double> inner_y = patch.along_lines();
  result.round = continued(inner_s, -plan.half_round, plan.half_round, plan.longest_round);
  const std::vector<double> y = continued(inner_y, -plan.below, plan.above, plan.longest_along);
  const std::vector<double>& s = result.round;
  const auto inside = [](const std::vector<double>& inner, double from, double to) {
    const double middle = (from + to) / 2;
    return middle > inner.front() && middle < inner.back();
  };
  for (std::size_t i = 0; i + 1 < s.size(); ++i)
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      if (!inside(inner_s, s[i], s[i + 1]) || !inside(inner_y, y[j], y[j + 1]))
        result.cells.push_back(
            {.map = [s0 = s[i], s1 = s[i + 1], y0 = y[j], y1 = y[j + 1]](double u, double v) {
              return PlanPoint{(1 - u) * s0 + u * s1, (1 - v) * y0 + v * y1};
            }});
  return result;
}

double outermost_ring(double half_length, int sectors) {
  return half_length * (std::cosh(kCircle * kTipSectors * 2 * pi / sectors) - 1);
}

PlanPoint on_crack_axes(const ConfocalPlan& plan, const PlanPoint& point) {
  const double c = std::cos(plan.direction);
  const double s = std::sin(plan.direction);
  return {c * point[0] + s * point[1], c * point[1] - s * point[0]};
}

}  // namespace strainwave::gear_fem

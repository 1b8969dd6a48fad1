// SPDX-License-Identifier: Apache-2.0
#include "crack_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// The rings of one tip, with angles from its direction of growth.
class TipTemplate {
 public:
  TipTemplate(const CrackPlan& plan, int index)
      : plan_(plan), tip_(plan.tips[static_cast<std::size_t>(index)]), index_(index) {
    const double smallest =
        std::min({plan.x[tip_.i + 1] - plan.x[tip_.i], plan.x[tip_.i] - plan.x[tip_.i - 1],
                  plan.y[tip_.j + 1] - plan.y[tip_.j], plan.y[tip_.j] - plan.y[tip_.j - 1]});
    outer_ = plan.circle * smallest;
  }

  void add(std::vector<PlanCell>& cells) const {
    const double core = radius(0);
    for (int k = 0; k < 4; ++k) {  // cells at the tip have straight sides
      const PlanPoint o = on_circle(0, 0);
      const PlanPoint a = on_circle(core, 2 * k);
      const PlanPoint b = on_circle(core, 2 * k + 1);
      const PlanPoint c = on_circle(core, 2 * k + 2);
      cells.push_back(
          {.map = [=](double u, double v) { return blend(blend(o, a, u), blend(c, b, u), v); },
           .half = half(k < 2 ? 1 : -1),
           .tip = place(-1, k < 2 ? 1 : -1)});
    }
    for (int ring = 0; ring <= plan_.rings; ++ring)
      for (int k = 0; k < 8; ++k)
        cells.push_back({.map = ring_map(ring, k),
                         .half = half(k < 4 ? 1 : -1),
                         .tip = place(ring, k < 4 ? 1 : -1)});
  }

 private:
  [[nodiscard]] int half(int side) const { return side * tip_.growth; }
  [[nodiscard]] PlanTipPlace place(int ring, int side) const {
    return {.tip = static_cast<std::size_t>(index_),
            .ring = ring,
            .side = side,
            .growth = {static_cast<double>(tip_.growth), 0}};
  }

  /// Inner radius of a circular ring; `rings` gives the outermost circle.
  [[nodiscard]] double radius(int ring) const {
    return outer_ * std::pow(plan_.ratio, plan_.rings - ring);
  }

  /// Point on a circle; the angle is in eighths of a turn.
  [[nodiscard]] PlanPoint on_circle(double r, double eighths) const {
    const double angle = eighths * pi / 4 + (tip_.growth < 0 ? pi : 0);
    return {plan_.x[tip_.i] + r * std::cos(angle), plan_.y[tip_.j] + r * std::sin(angle)};
  }

  /// Corners of the square and middles of its sides.
  [[nodiscard]] PlanPoint on_square(int eighth) const {
    constexpr std::array<int, 8> kX{1, 1, 0, -1, -1, -1, 0, 1};
    const auto e = static_cast<std::size_t>((eighth + (tip_.growth < 0 ? 4 : 0)) % 8);
    const auto line = [](const std::vector<double>& lines, std::size_t i, int step) {
      return lines[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step)];
    };
    return {line(plan_.x, tip_.i, kX[e]), line(plan_.y, tip_.j, kX[(e + 6) % 8])};
  }

  [[nodiscard]] std::function<PlanPoint(double, double)> ring_map(int ring, int k) const {
    const TipTemplate self = *this;
    if (ring == 0)
      return [self, k](double u, double v) {
        const double r = self.radius(0);
        return blend(blend(self.on_circle(r, k), self.on_circle(r, k + 1), v),
                     self.on_circle(self.radius(1), k + v), u);
      };
    if (ring == plan_.rings)
      return [self, ring, k](double u, double v) {
        return blend(self.on_circle(self.radius(ring), k + v),
                     blend(self.on_square(k), self.on_square(k + 1), v), u);
      };
    return [self, ring, k](double u, double v) {
      return self.on_circle((1 - u) * self.radius(ring) + u * self.radius(ring + 1), k + v);
    };
  }

  CrackPlan plan_;
  PlanTip tip_;
  int index_;
  double outer_;
};

}  // namespace

std::vector<PlanCell> crack_plan(const CrackPlan& plan) {
  std::vector<PlanCell> cells;
  const auto in_a_square = [&](std::size_t i, std::size_t j) {
    return std::any_of(plan.tips.begin(), plan.tips.end(), [&](const PlanTip& t) {
      return (i == t.i || i + 1 == t.i) && (j == t.j || j + 1 == t.j);
    });
  };
  for (std::size_t i = 0; i + 1 < plan.x.size(); ++i)
    for (std::size_t j = 0; j + 1 < plan.y.size(); ++j)
      if (!in_a_square(i, j))
        cells.push_back({.map =
                             [x0 = plan.x[i], x1 = plan.x[i + 1], y0 = plan.y[j],
                              y1 = plan.y[j + 1]](double u, double v) {
                               return PlanPoint{(1 - u) * x0 + u * x1, (1 - v) * y0 + v * y1};
                             },
                         .half = plan.tips.empty() || j >= plan.tips.front().j ? 1 : -1});
  for (std::size_t t = 0; t < plan.tips.size(); ++t)
    TipTemplate(plan, static_cast<int>(t)).add(cells);
  return cells;
}

std::vector<double> graded_lines(double from, double to, double first, double growth, double most) {
  const double span = std::abs(to - from);
  std::vector<double> gaps;
  double sum = 0;
  double gap = first;
  while (sum < span * (1 - 1e-12)) {
    gaps.push_back(std::min(gap, most));
    sum += gaps.back();
    gap *= growth;
  }
  if (gaps.size() > 1 && sum - gaps.back() / 2 > span) {  // the last gap would be very thin
    sum -= gaps.back();
    gaps.pop_back();
  }
  std::vector<double> lines;
  double at = 0;
  for (const double g : gaps) {
    at += g * span / sum;
    lines.push_back(from + (to > from ? at : -at));
  }
  lines.back() = to;
  return lines;
}

std::vector<fem::TemplateCell> extruded(const std::vector<PlanCell>& plan,
                                        const std::vector<double>& layers) {
  std::vector<fem::TemplateCell> cells;
  for (std::size_t k = 0; k + 1 < layers.size(); ++k)
    for (const PlanCell& source : plan) {
      fem::TemplateCell cell;
      cell.map = [map = source.map, z0 = layers[k], z1 = layers[k + 1]](const fem::Point3& p) {
        const PlanPoint x = map(p[0], p[1]);
        return fem::Point3{x[0], x[1], (1 - p[2]) * z0 + p[2] * z1};
      };
      cell.side = source.half;
      if (source.tip) {
        const fem::Point3 growth{source.tip->growth[0], source.tip->growth[1], 0};
        cell.front = fem::FrontPlace{.front = source.tip->tip,
                                     .segment = k,
                                     .ring = source.tip->ring,
                                     .side = source.tip->side,
                                     .advance = [growth](const fem::Point3&) { return growth; },
                                     .square_root = source.tip->square_root};
      }
      cells.push_back(std::move(cell));
    }
  return cells;
}

}  // namespace strainwave::gear_fem

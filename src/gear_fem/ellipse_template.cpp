// SPDX-License-Identifier: Apache-2.0
#include "ellipse_template.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "crack_plan.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;
using FlatMap = std::function<PlanPoint(double u, double v)>;

// Size of the box about the crack: its extent beyond the ends of the crack along x over the smaller
// half axis, and its depth over the crack's depth.  The cells between rings and box are then about
// square.
constexpr double kBoxBeyond = 1.5;
constexpr double kBoxDepth = 2.5;
// A box that takes more than this share of the room takes all of it, so no thin cells remain beside
// it.
constexpr double kNearlyAll = 0.7;
// The half width of the square of rings about the front, in the confocal coordinate r, has three
// limits.  The first leaves cells inside the ellipse.
constexpr double kWidestSquare = 0.35;
// The second is a share of the way to the line between the foci, at which the coordinates fold.
constexpr double kToFoci = 0.6;
// The third is a share of the way to the box, which leaves half of the way to the layers outside.
constexpr double kToBox = 0.55;

PlanPoint between(const PlanPoint& a, const PlanPoint& b, double u) {
  return {(1 - u) * a[0] + u * b[0], (1 - u) * a[1] + u * b[1]};
}

FlatMap rectangle(double x0, double x1, double z0, double z1) {
  return [=](double u, double v) {
    return PlanPoint{(1 - u) * x0 + u * x1, (1 - v) * z0 + v * z1};
  };
}

/// Confocal coordinates of the half plane; r = 1 is the front.
struct Confocal {
  double A;
  double B;

  [[nodiscard]] PlanPoint axes(double r) const { return {A * r + B / r, A * r - B / r}; }
  [[nodiscard]] PlanPoint at(double r, double phi) const {
    const PlanPoint e = axes(r);
    return {e[0] * std::cos(phi), e[1] * std::sin(phi)};  // (FE-27)
  }
};

class Drawing {
 public:
  explicit Drawing(const EllipseTemplate& slab)
      : s_(slab),
        confocal_{(slab.half_length + slab.depth) / 2, (slab.half_length - slab.depth) / 2},
        quarter_(slab.segments / 4) {
    const double a = slab.depth;
    const double c = slab.half_length;
    const double room = std::min(slab.x[1], -slab.x[0]);
    box_x_ = c + kBoxBeyond * std::min(a, c);
    if (box_x_ > kNearlyAll * room) box_x_ = room;
    box_z_ = kBoxDepth * a;
    if (box_z_ > kNearlyAll * slab.thickness) box_z_ = slab.thickness;
    half_square_ =
        std::min(kWidestSquare, kToFoci * (1 - std::sqrt(std::abs(confocal_.B) / confocal_.A)));
    // Use a closed form instead of a search in steps, because neighbouring sizes, whose results are
    // subtracted, must have similar cells.
    const double AB = confocal_.A * confocal_.B;
    const auto widest = [&](double reach, double sign) {
      return (reach + std::sqrt(reach * reach - sign * 4 * AB)) / (2 * confocal_.A) - 1;
    };
    half_square_ = std::min({half_square_, widest(c + kToBox * (box_x_ - c), 1),
                             widest(a + kToBox * (box_z_ - a), -1)});
    scale_y_ = std::sqrt(a * c);
    const double b = half_square_ * scale_y_;
    y_ = graded_lines(-b, slab.y[0], b, slab.growth, slab.longest_y);
    std::reverse(y_.begin(), y_.end());
    first_above_ = y_.size() + 1;
    for (const double line : {-b, 0.0, b}) y_.push_back(line);
    for (const double line : graded_lines(b, slab.y[1], b, slab.growth, slab.longest_y))
      y_.push_back(line);
  }

  [[nodiscard]] double rings_half_length() const { return confocal_.axes(1 + half_square_)[0]; }

  std::vector<fem::TemplateCell> cells() {
    add_section();
    add_core();
    add_shell();
    add_outside();
    return std::move(cells_);
  }

 private:
  [[nodiscard]] double phi(double k) const { return pi * k / s_.segments; }

  /// Point at which the ray of the k-th node meets a rectangle [-ex, ex] x [0, ez].
  [[nodiscard]] PlanPoint on_box(int k, double ex, double ez) const {
    const double root = std::sqrt(2.0);
    if (k <= quarter_) return {ex, ez * root * std::sin(phi(k))};
    if (k >= 3 * quarter_) return {-ex, ez * root * std::sin(phi(k))};
    return {ex * root * std::cos(phi(k)), ez};
  }

  /// Adds a flat cell of (x, z) between all lines of y; the flat map is turned to make (u, y, v)
  /// right-handed.
  void add_prisms(const FlatMap& flat) {
    for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
      fem::TemplateCell cell;
      cell.side = j < first_above_ ? -1 : 1;
      cell.map = [flat, y0 = y_[j], y1 = y_[j + 1]](const fem::Point3& p) {
        const PlanPoint f = flat(p[0], p[2]);
        return fem::Point3{f[0], (1 - p[1]) * y0 + p[1] * y1, f[1]};
      };
      cells_.push_back(std::move(cell));
    }
  }

  void add_section() {
    CrackPlan plan;
    plan.rings = s_.rings;
    plan.x = {1 - half_square_, 1, 1 + half_square_};
    for (const double line : y_) plan.y.push_back(line / scale_y_);
    plan.tips = {{.i = 1, .j = first_above_, .growth = 1}};
    const std::vector<PlanCell> flat = crack_plan(plan);
    for (int k = 0; k < s_.segments; ++k)
      for (const PlanCell& source : flat) {
        const auto angle = [from = phi(k), to = phi(k + 1)](double w) {
          return (1 - w) * from + w * to;
        };
        fem::TemplateCell cell;
        cell.side = source.half;
        cell.map = [=, map = source.map, confocal = confocal_,
                    scale = scale_y_](const fem::Point3& p) {
          const PlanPoint f = map(p[0], p[1]);
          const PlanPoint x = confocal.at(f[0], angle(p[2]));
          return fem::Point3{x[0], scale * f[1], x[1]};
        };
        if (source.tip)
          cell.front = fem::FrontPlace{
              .front = 0,
              .segment = static_cast<std::size_t>(k),
              .ring = source.tip->ring,
              .side = source.tip->side,
              .advance = [=, map = source.map, confocal = confocal_](const fem::Point3& p) {
                const double r = map(p[0], p[1])[0];
                const double slope = confocal.B / (r * r);
                return fem::Point3{(confocal.A - slope) * std::cos(angle(p[2])), 0,
                                   (confocal.A + slope) * std::sin(angle(p[2]))};
              }};
        cells_.push_back(std::move(cell));
      }
  }

  void add_core() {
    constexpr double kInner = 0.5;  // size of the square in the middle over the ellipse's axes
    const PlanPoint e = confocal_.axes(1 - half_square_);
    for (int k = 0; k < s_.segments; ++k)
      add_prisms([e, from = phi(k), to = phi(k + 1), p0 = on_box(k, kInner, kInner),
                  p1 = on_box(k + 1, kInner, kInner)](double u, double v) {
        const double angle = (1 - v) * from + v * to;
        const PlanPoint f = between(between(p0, p1, v), {std::cos(angle), std::sin(angle)}, u);
        return PlanPoint{e[0] * f[0], e[1] * f[1]};
      });
    for (int i = quarter_; i < 3 * quarter_; ++i)
      for (int j = 0; j < quarter_; ++j)
        add_prisms(rectangle(
            e[0] * on_box(i + 1, kInner, kInner)[0], e[0] * on_box(i, kInner, kInner)[0],
            e[1] * on_box(j, kInner, kInner)[1], e[1] * on_box(j + 1, kInner, kInner)[1]));
  }

  void add_shell() {
    // Layers from the rings to the box; the inner layer is thinner, because the stress falls off
    // outwards.
    constexpr std::array<double, 3> kLayers{0, 0.4, 1};
    for (std::size_t l = 0; l + 1 < kLayers.size(); ++l)
      for (int k = 0; k < s_.segments; ++k)
        add_prisms([=, confocal = confocal_, r = 1 + half_square_, from = phi(k), to = phi(k + 1),
                    p0 = on_box(k, box_x_, box_z_), p1 = on_box(k + 1, box_x_, box_z_),
                    l0 = kLayers[l], l1 = kLayers[l + 1]](double u, double v) {
          return between(confocal.at(r, (1 - v) * from + v * to), between(p0, p1, v),
                         (1 - u) * l0 + u * l1);
        });
  }

  void add_outside() {
    std::vector<double> z{0};
    for (int j = 1; j <= quarter_; ++j) z.push_back(on_box(j, box_x_, box_z_)[1]);
    const std::size_t box_top = z.size() - 1;
    if (box_z_ < s_.thickness)
      for (const double line : graded_lines(box_z_, s_.thickness, box_z_, s_.growth, s_.thickness))
        z.push_back(line);
    std::vector<double> x;
    const double first = kBoxBeyond * std::min(s_.depth, s_.half_length);
    if (-s_.x[0] > box_x_ * (1 + 1e-12)) {
      x = graded_lines(-box_x_, s_.x[0], first, s_.growth, s_.longest_x);
      std::reverse(x.begin(), x.end());
    }
    const std::size_t box_left = x.size();
    for (int i = 3 * quarter_; i >= quarter_; --i) x.push_back(on_box(i, box_x_, box_z_)[0]);
    const std::size_t box_right = x.size() - 1;
    if (s_.x[1] > box_x_ * (1 + 1e-12))
      for (const double line : graded_lines(box_x_, s_.x[1], first, s_.growth, s_.longest_x))
        x.push_back(line);
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      for (std::size_t j = 0; j + 1 < z.size(); ++j)
        if (i < box_left || i >= box_right || j >= box_top)
          add_prisms(rectangle(x[i], x[i + 1], z[j], z[j + 1]));
  }

  EllipseTemplate s_;
  Confocal confocal_;
  int quarter_;
  double box_x_{};
  double box_z_{};
  double half_square_{};
  double scale_y_{};
  std::vector<double> y_;
  std::size_t first_above_{};  ///< index of the line y = 0
  std::vector<fem::TemplateCell> cells_;
};

}  // namespace

std::vector<fem::TemplateCell> ellipse_template(const EllipseTemplate& slab) {
  return Drawing(slab).cells();
}

double rings_half_length(const EllipseTemplate& slab) { return Drawing(slab).rings_half_length(); }

bool inside_ellipse(const EllipseTemplate& slab, const fem::Point3& p) {
  const double tiny = 1e-9;
  return std::abs(p[1]) < tiny * (slab.depth + slab.half_length) &&
         std::hypot(p[0] / slab.half_length, p[2] / slab.depth) < 1 - tiny;
}

}  // namespace strainwave::gear_fem

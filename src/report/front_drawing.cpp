// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "layout.hpp"
#include "markup.hpp"
#include "sheet.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

using namespace report;

constexpr double kRound = 112;      // largest radius of the drawing [mm]
constexpr double kOvality = 0.055;  // exaggerated deflection per radius

/// A point at an angle from the major axis, which is upright; the view is against +z.
Point at_angle(double radius, double angle) {
  return {-radius * std::sin(angle), radius * std::cos(angle)};
}

/// Factor by which the deflection is enlarged.
double exaggeration(const GearSet& gear, double radius) {
  const double wanted = kOvality * radius / gear.drive.radial_displacement;
  double factor = 1;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (step <= wanted) factor = step;
  return factor;
}

class Front {
 public:
  Front(const GearSet& gear, const Layout& layout, const std::vector<NumberedCrack>& cracks)
      : gear_(gear),
        at_(layout),
        cracks_(cracks),
        sheet_(drawing_scale(2 * layout.top, kRound), {0, 0}),
        factor_(exaggeration(gear, layout.tooth_root)) {
    half_ = sheet_.paper(at_.top) + 12;
    sheet_ = Sheet(sheet_.scale(), {half_ + 6, half_});
  }

  std::string svg() {
    if (at_.circular_spline) {
      const char* const style = at_.circular_spline->given ? "seen" : "sketched";
      sheet_.circle("circular_spline", {0, 0}, at_.circular_spline->outer, style);
      sheet_.circle("circular_spline_roots", {0, 0}, at_.circular_spline->inner, style);
    }
    if (gear_.flexspline) {
      const Ring& wall = at_.rim ? *at_.rim : *at_.barrel;
      oval(wall.outer, "seen");
      oval(wall.inner, "seen");
    }
    if (gear_.wave_generator) {
      if (!gear_.flexspline)
        oval(at_.outer_ring->outer, at_.outer_ring->given ? "seen" : "sketched");
      oval(at_.outer_ring->inner, at_.outer_ring->given ? "seen" : "sketched");
      oval(at_.inner_ring->outer, at_.inner_ring->given ? "seen" : "sketched");
      oval(at_.inner_ring->inner, at_.inner_ring->given ? "seen" : "sketched");
      draw_balls();
    }
    const double beyond = at_.top + 5e-3 / sheet_.scale();
    for (int lobe = 0; lobe < gear_.drive.wave_number; ++lobe)
      sheet_.line({0, 0}, at_angle(beyond, 2 * std::numbers::pi * lobe / gear_.drive.wave_number),
                  "axis");
    if (gear_.drive.wave_number == 2) sheet_.line({-beyond, 0}, {beyond, 0}, "axis");
    for (const NumberedCrack& crack : cracks_) add(crack, *crack.place.position);
    draw_marks();
    return finish();
  }

 private:
  /// Deflected radius of a part that is round before assembly; it is true at the lobes.
  [[nodiscard]] double deflected(double radius, double angle) const {
    const double w0 = gear_.drive.radial_displacement;
    return radius + w0 - factor_ * w0 * (1 - std::cos(gear_.drive.wave_number * angle));
  }

  void oval(double radius, const char* style) {
    constexpr int kSteps = 180;
    Polygon points;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSteps;
      points.push_back(at_angle(deflected(radius, angle), angle));
    }
    sheet_.curve(points, style);
  }

  void draw_balls() {
    const bool counted = gear_.wave_generator->bearing && gear_.wave_generator->bearing->ball_count;
    const int count =
        counted
            ? *gear_.wave_generator->bearing->ball_count
            : static_cast<int>(0.7 * 2 * std::numbers::pi * at_.ball_radius / at_.ball_diameter);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      sheet_.circle("ball", at_angle(deflected(at_.ball_radius, angle), angle),
                    at_.ball_diameter / 2, counted && at_.ball_given ? "ball" : "sketched");
    }
  }

  /// Adds a radial line from the surface where the crack starts; for a tooth, over its height.
  void add(const NumberedCrack& crack, double angle) {
    const CrackPlace& c = crack.place;
    double from = at_.tooth_root;
    double length = at_.tooth_height;
    if (c.part != CrackedPart::tooth) {
      const Ring& ring = ring_of(at_, c.part);
      from = c.from_inside ? ring.inner : ring.outer;
      length = c.from_inside ? c.depth : -c.depth;
    }
    if (c.part != CrackedPart::circular_spline) from = deflected(from, angle);
    const double to = from + length;
    sheet_.crack(crack.path, {at_angle(from, angle), at_angle(to, angle)}, false);
    const Point target = sheet_.paper(at_angle((from + to) / 2, angle));
    placed_.push_back({crack.number, angle, target});
  }

  struct Placed {
    int number = 0;
    double angle = 0.0;
    Point target;
  };

  /// Draws marks round the drawing at the angles of their cracks, moved apart where they would
  /// overlap.
  void draw_marks() {
    std::vector<double> wanted;
    for (const Placed& c : placed_) wanted.push_back(std::remainder(c.angle, 2 * std::numbers::pi));
    const double radius = at_.top + 7e-3 / sheet_.scale();
    const double apart = 6e-3 / sheet_.scale() / radius;
    const std::vector<double> angles = spread(wanted, apart, -std::numbers::pi, std::numbers::pi);
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Point mark = sheet_.paper(at_angle(radius, angles[i]));
      sheet_.paper_line(placed_[i].target, mark, "crack-leader");
      sheet_.balloon(mark, std::to_string(placed_[i].number), "crack-mark");
    }
  }

  std::string finish() {
    // The words are beside the drawing, or below it if the room does not suffice.
    constexpr double kWords = 64;
    const bool beside = 2 * half_ + 16 + kWords <= kPaperWidth;
    const double x = beside ? 2 * half_ + 16 : 10;
    double y = beside ? 12 : 2 * half_ + 8;
    const auto say = [&](const std::string& text, const char* style) {
      sheet_.words({x, y}, text, style);
      y += 4.6;
    };
    say("Seen from the output, against +z", "");
    say("major axis upright, +θ counter-clockwise", "small");
    say(fmt::format("deflection w₀ = {} drawn {:g} times", in_mm(gear_.drive.radial_displacement),
                    factor_),
        "small");
    say("too large; radii are true at the lobes", "small");
    say("cracks: angle and depth to scale", "small");
    say(fmt::format("scale {}", scale_text(sheet_.scale())), "small");
    y += 2;
    for (const NumberedCrack& crack : cracks_)
      say(fmt::format("{}: {} at {:.4g}°", crack.number, crack.kind,
                      *crack.place.position / units::deg),
          "small");
    sheet_.scale_bar(
        beside ? Point{x, std::max(y + 2, 2 * half_ - 8)} : Point{x + kWords + 30, y - 8}, 30);
    return sheet_.svg("front", {kPaperWidth, std::max(2 * half_, y + 10)},
                      "Front view of the drive with the angles of its cracks",
                      fmt::format("Scale {}; the deflection is drawn {:g} times too large.",
                                  scale_text(sheet_.scale()), factor_));
  }

  const GearSet& gear_;
  const Layout& at_;
  const std::vector<NumberedCrack>& cracks_;  ///< cracks with a position
  Sheet sheet_;
  double factor_;
  double half_ = 0.0;  ///< half of the square that the drawing takes [mm]
  std::vector<Placed> placed_;
};

}  // namespace

std::string front_drawing(const GearSet& gear) {
  std::vector<NumberedCrack> cracks = numbered_cracks(gear);
  std::erase_if(cracks, [](const NumberedCrack& crack) { return !crack.place.position; });
  if (cracks.empty()) return {};
  const Layout layout = layout_of(gear);
  return Front(gear, layout, cracks).svg();
}

}  // namespace strainwave

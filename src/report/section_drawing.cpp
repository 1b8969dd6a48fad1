// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/section_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "layout.hpp"
#include "markup.hpp"
#include "sheet.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

using namespace report;

// Lengths in millimetres of paper.
constexpr double kLeft = 20;     // space for the marks of the parts at the open end
constexpr double kRight = 10;    // space behind the output
constexpr double kHeight = 100;  // largest height of the half section
constexpr double kMarks = 7;     // distance between two marks
constexpr double kLine = 4.3;    // height of a line in the list of parts

/// A part with its mark: its place in the list and its target.
struct Marked {
  std::string text;
  Point target;  ///< real [m]
  bool at_left = false;
};

std::string diameter(double radius) { return "⌀" + in_mm(2 * radius); }

std::string sketched(const char* what) {
  return fmt::format("; {} not in the file, sketched", what);
}

class Section {
 public:
  explicit Section(const GearSet& gear)
      : gear_(gear),
        at_(layout_of(gear)),
        cracks_(numbered_cracks(gear)),
        sheet_(std::min(drawing_scale(at_.end, kPaperWidth - kLeft - kRight),
                        drawing_scale(at_.top, kHeight)),
               {0, 0}) {
    // From top to bottom: the row of crack marks, the drawing, the row of part marks below the
    // axis.
    const double above = cracks_.empty() ? 4 : 12;
    axis_ = above + sheet_.paper(at_.top) + 3;
    const double drawn = sheet_.paper(at_.end);
    left_ = kLeft + std::max(0.0, (kPaperWidth - kLeft - kRight - drawn) / 3);
    sheet_ = Sheet(sheet_.scale(), {left_, axis_});
  }

  std::string svg() {
    if (gear_.wave_generator) draw_wave_generator();
    draw_flexspline_and_spline();
    if (gear_.output_shaft) draw_shaft();
    sheet_.line({-8e-3 / sheet_.scale(), 0}, {at_.end + 8e-3 / sheet_.scale(), 0}, "axis");
    draw_cracks();
    double y = draw_part_marks();
    y = draw_details(y);
    sheet_.scale_bar({4, y + 1}, 40);
    sheet_.words({kPaperWidth - 2, y + 2.2},
                 fmt::format("half section at the major axis, before assembly; scale {} at {:g} mm "
                             "width; lengths in {}",
                             scale_text(sheet_.scale()), kPaperWidth, display_unit({}, "m").text),
                 "small end");
    sheet_.words({kPaperWidth - 2, y + 5.8},
                 "dashed: not in the file, sketched; output (+z) to the right", "small end");
    return sheet_.svg("section", {kPaperWidth, y + 8}, "Half section of the drive through its axis",
                      description());
  }

 private:
  void ring(const char* id, const Ring& r, const Hatch& hatch) {
    if (r.given)
      sheet_.part(id, r.polygon(), hatch, std::min(r.thickness(), r.z2 - r.z1));
    else
      sheet_.outline(id, r.polygon(), "sketched");
  }

  /// The shoulders beside a groove, from the bottom of the groove toward the ball.
  void shoulders(const char* id, const Ring& r, double bottom, double conformity, double toward) {
    const double groove = conformity * at_.ball_diameter;
    const double height = std::min(0.18 * at_.ball_diameter, 0.9 * groove);
    const double half = (r.z2 - r.z1) / 2;
    const double mouth = std::sqrt(groove * groove - (groove - height) * (groove - height));
    if (mouth >= half) return;
    for (const double side : {-1.0, 1.0}) {
      Polygon outline = {{r.middle() + side * half, bottom},
                         {r.middle() + side * half, bottom + toward * height}};
      constexpr int kSteps = 12;
      for (int i = 0; i <= kSteps; ++i) {
        const double z = mouth * (kSteps - i) / kSteps;
        outline.push_back({r.middle() + side * z,
                           bottom + toward * (groove - std::sqrt(groove * groove - z * z))});
      }
      sheet_.outline(id, outline, "sketched");
    }
  }

  void draw_wave_generator() {
    const WaveGenerator& wg = *gear_.wave_generator;
    ring("cam", *at_.cam, {});
    ring("inner_ring", *at_.inner_ring, {.angle = 45, .spacing = 1.6});
    ring("outer_ring", *at_.outer_ring, {.angle = -45, .spacing = 1.6});
    if (wg.bearing) {
      shoulders("inner_ring_shoulder", *at_.inner_ring, wg.bearing->inner_raceway_diameter / 2,
                wg.bearing->inner_conformity, +1);
      shoulders("outer_ring_shoulder", *at_.outer_ring, wg.bearing->outer_raceway_diameter / 2,
                wg.bearing->outer_conformity, -1);
    }
    const double middle = at_.inner_ring->middle();
    sheet_.circle("ball", {middle, at_.ball_radius}, at_.ball_diameter / 2,
                  at_.ball_given ? "ball" : "sketched");
    const auto width = [](const Ring& r) { return in_mm(r.z2 - r.z1); };
    const Ring& inner = *at_.inner_ring;
    const Ring& outer = *at_.outer_ring;
    left({inner.z1, at_.cam->inner + 0.6 * at_.cam->thickness()}, "cam" + sketched("shape"));
    const std::string inner_size =
        wg.inner_ring_thickness
            ? fmt::format("inner ring, {} thick", in_mm(*wg.inner_ring_thickness))
            : std::string("inner ring");
    left({inner.z1, (inner.inner + inner.outer) / 2},
         inner_size + (!inner.given          ? sketched("place and width")
                       : wg.inner_ring_width ? ", " + width(inner) + " wide"
                                             : ", as wide as the outer"));
    left({middle - 0.4 * at_.ball_diameter, at_.ball_radius},
         at_.ball_given
             ? fmt::format("{}balls ⌀{}",
                           wg.bearing->ball_count ? fmt::format("{} ", *wg.bearing->ball_count)
                                                  : std::string(),
                           in_mm(at_.ball_diameter))
             : "balls" + sketched("size"));
    left({outer.z1, (outer.inner + outer.outer) / 2},
         outer.given
             ? fmt::format("outer ring, {} thick, {} wide", in_mm(outer.thickness()), width(outer))
             : "outer ring" + sketched("size"));
  }

  void draw_flexspline_and_spline() {
    if (at_.circular_spline) {
      const Ring& cs = *at_.circular_spline;
      ring("circular_spline", cs, {.angle = -45, .spacing = 2.2});
      sheet_.outline("circular_spline_teeth",
                     rectangle(cs.z1, cs.inner - at_.tooth_height, cs.z2, cs.inner), "sketched");
      left({cs.z1, cs.inner + 0.6 * cs.thickness()},
           cs.given ? fmt::format("circular spline {} / {}, {} wide", diameter(cs.outer),
                                  diameter(cs.inner), in_mm(cs.z2 - cs.z1))
                    : "circular spline" + sketched("size"));
    }
    if (!gear_.flexspline) return;
    const Hatch hatch{.angle = 45, .spacing = 1.3};
    const Ring& barrel = *at_.barrel;
    const double root = at_.rim ? at_.rim->outer : barrel.outer;
    sheet_.outline("flexspline_teeth", rectangle(0, root, at_.teeth_width, root + at_.tooth_height),
                   "sketched");
    const auto tube = [](const char* name, const Ring& r) {
      return fmt::format("{} {} × {}, wall {}", name, diameter(r.outer), in_mm(r.z2 - r.z1),
                         in_mm(r.thickness()));
    };
    if (at_.rim) {
      ring("rim", *at_.rim, hatch);
      left({at_.rim->z1, (at_.rim->inner + at_.rim->outer) / 2},
           tube("rim, at the roots,", *at_.rim));
    }
    ring("barrel", barrel, hatch);
    below({barrel.z1 + 0.7 * (barrel.z2 - barrel.z1), barrel.inner + barrel.thickness() / 2},
          tube(at_.rim ? "barrel" : "flexspline", barrel) +
              (at_.rim ? std::string() : std::string("; teeth sketched")));
    if (at_.bottom) {
      const Ring& plate = *at_.bottom;
      if (plate.given)
        sheet_.part("diaphragm", at_.bottom_outline, hatch, plate.z2 - plate.z1);
      else
        sheet_.outline("diaphragm", at_.bottom_outline, "sketched");
      below({(plate.z1 + plate.z2) / 2, plate.inner + 0.25 * plate.thickness()},
            plate.given
                ? fmt::format(
                      "diaphragm {} / {}, {} thick{}", diameter(plate.outer), diameter(plate.inner),
                      in_mm(gear_.flexspline->diaphragm->thickness),
                      gear_.flexspline->diaphragm->profile.empty() ? "" : " outside, profiled")
                : "bottom of the cup" + sketched("size"));
    }
    if (at_.boss) {
      ring("boss", *at_.boss, hatch);
      below({at_.boss->middle(), (at_.boss->inner + at_.boss->outer) / 2}, tube("boss", *at_.boss));
    }
  }

  void draw_shaft() {
    const Ring& shaft = *at_.shaft;
    ring("output_shaft", shaft, {.angle = 45, .spacing = 2.6});
    below({shaft.z1 + 0.8 * (shaft.z2 - shaft.z1), shaft.inner + 0.4 * shaft.thickness()},
          shaft.inner > 0 ? fmt::format("output shaft {} / {} × {}", diameter(shaft.outer),
                                        diameter(shaft.inner), in_mm(shaft.z2 - shaft.z1))
                          : fmt::format("output shaft {} × {}, solid", diameter(shaft.outer),
                                        in_mm(shaft.z2 - shaft.z1)));
  }

  // --- cracks -----------------------------------------------------------------------------------

  /// Draws a crack and keeps its mark, and its detail if the crack is too small to be visible.
  void add(const NumberedCrack& crack, const Polygon& shape, bool closed, double seen,
           std::optional<Detail> detail) {
    sheet_.crack(crack.path, shape, closed);
    Point middle{0, 0};
    double highest = shape.front().y;
    for (const Point& p : shape) {
      middle.x += p.x / static_cast<double>(shape.size());
      highest = std::max(highest, p.y);
    }
    middle.y = highest;
    // Several cracks over the whole width of the teeth coincide in the drawing, so let their marks
    // point beside each other.
    if (closed && shape.size() == 4 && sheet_.paper(shape[1].x - shape[0].x) > kMarks)
      middle.x = shape[0].x + (shape[1].x - shape[0].x) * (0.2 + 0.2 * (n_wide_++ % 4));
    crack_marks_.push_back({std::to_string(crack.number), sheet_.paper(middle), "crack"});
    if (sheet_.paper(seen) >= kVisible || !detail) return;
    detail->number = crack.number;
    detail->path = crack.path;
    details_.push_back(*detail);
  }

  void draw(const NumberedCrack& crack) {
    if (crack.place.part == CrackedPart::diaphragm)
      draw_on_diaphragm(crack);
    else if (crack.place.part == CrackedPart::tooth)
      add(crack, rectangle(0, at_.tooth_root, at_.teeth_width, at_.tooth_root + at_.tooth_height),
          true, at_.teeth_width, {});
    else
      draw_in_ring(crack);
  }

  void draw_in_ring(const NumberedCrack& crack) {
    const CrackPlace& c = crack.place;
    const Ring& r = ring_of(at_, c.part);
    const double z = c.angle ? crack_place(r) : r.middle();
    const double half = c.half_length * std::cos(c.angle.value_or(0.0));
    const double from = c.from_inside ? r.inner : r.outer;
    const double into = c.from_inside ? 1 : -1;
    const auto detail = [&](double along, Detail::Shape shape) {
      return Detail{.wall = r.thickness(), .depth = c.depth, .half = along, .shape = shape};
    };
    switch (c.shape) {
      case CrackShape::semi_ellipse:
        if (c.part == CrackedPart::output_shaft) {  // it lies across the axis
          add(crack, {{z, from}, {z, from + into * c.depth}}, false, c.depth,
              detail(c.half_length, Detail::Shape::ellipse));
          break;
        }
        add(crack, semi_ellipse({z, from}, half, c.depth, {0, into}), true, c.depth,
            detail(c.half_length, Detail::Shape::ellipse));
        break;
      case CrackShape::through:
        add(crack, rectangle(z - half, r.inner, z + half, r.outer), true, 2 * half, {});
        break;
      case CrackShape::all_round:
        add(crack, {{z, from}, {z, from + into * c.depth}}, false, c.depth,
            detail(0, Detail::Shape::line));
        break;
      default:
        add(crack, rectangle(r.z1, from, r.z2, from + into * c.depth), true, c.depth,
            detail((r.z2 - r.z1) / 2, Detail::Shape::rectangle));
    }
  }

  void draw_on_diaphragm(const NumberedCrack& crack) {
    const CrackPlace& c = crack.place;
    const Diaphragm& plate = *gear_.flexspline->diaphragm;
    const double z = at_.bottom->z2;
    const double r = c.radius.value_or(plate.inner_diameter / 2);
    const double h = diaphragm_thickness(plate, r);
    if (c.shape == CrackShape::through)
      add(crack, {{z - h, r}, {z, r}}, false, h,
          Detail{.wall = h, .depth = h, .half = 0, .shape = Detail::Shape::line});
    else
      add(crack, rectangle(z - c.depth, r - c.half_length, z, r + c.half_length), true, c.depth,
          Detail{.wall = h,
                 .depth = c.depth,
                 .half = c.half_length,
                 .shape = Detail::Shape::rectangle});
  }

  /// Place of a crack in a wall.  Several cracks are drawn beside each other, because the file does
  /// not give their places.
  double crack_place(const Ring& r) {
    const auto count = std::ranges::count_if(cracks_, [&](const NumberedCrack& crack) {
      return crack.place.angle && &ring_of(at_, crack.place.part) == &r;
    });
    const int index = placed_[&r]++;
    return r.z1 + (r.z2 - r.z1) * (index + 1) / static_cast<double>(count + 1);
  }

  void draw_cracks() {
    for (const NumberedCrack& crack : cracks_) draw(crack);
    std::vector<double> wanted;
    for (const Balloon& mark : crack_marks_) wanted.push_back(mark.target.x);
    const std::vector<double> places = spread(wanted, kMarks, 4, kPaperWidth - 4);
    constexpr double kRow = 4;
    for (std::size_t i = 0; i < places.size(); ++i) {
      sheet_.paper_line({places[i], kRow + 2.5}, crack_marks_[i].target, "crack-leader");
      sheet_.balloon({places[i], kRow}, crack_marks_[i].text, "crack-mark");
    }
  }

  double draw_details(double y) {
    if (details_.empty()) return y;
    constexpr double kGap = 4;
    const auto per_row = static_cast<std::size_t>((kPaperWidth + kGap) / (kDetailWidth + kGap));
    for (std::size_t i = 0; i < details_.size(); ++i) {
      const std::size_t row = i / per_row;
      const std::size_t column = i % per_row;
      draw_detail(sheet_, details_[i],
                  {static_cast<double>(column) * (kDetailWidth + kGap) + 2,
                   y + static_cast<double>(row) * (kDetailHeight + kGap)});
    }
    const std::size_t rows = (details_.size() - 1) / per_row + 1;
    return y + static_cast<double>(rows) * (kDetailHeight + kGap) + 2;
  }

  // --- parts ------------------------------------------------------------------------------------

  void left(Point target, std::string text) { parts_.push_back({std::move(text), target, true}); }
  void below(Point target, std::string text) { parts_.push_back({std::move(text), target, false}); }

  /// Draws the marks at the open end and below the axis and their list; returns the end of the
  /// list.
  double draw_part_marks() {
    std::vector<double> rows;
    std::vector<double> columns;
    for (const Marked& part : parts_) {
      const Point p = sheet_.paper(part.target);
      if (part.at_left)
        rows.push_back(p.y);
      else
        columns.push_back(p.x);
    }
    const double below_axis = axis_ + 7;
    const std::vector<double> at_y = spread(rows, kMarks - 0.5, 4, axis_ + 1);
    const std::vector<double> at_x = spread(columns, kMarks, left_, kPaperWidth - 4);
    std::size_t row = 0;
    std::size_t column = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::string letter(1, static_cast<char>('A' + i));
      const Point target = sheet_.paper(parts_[i].target);
      const Point mark =
          parts_[i].at_left ? Point{left_ - 13, at_y[row++]} : Point{at_x[column++], below_axis};
      sheet_.paper_line(
          parts_[i].at_left ? Point{mark.x + 2.5, mark.y} : Point{mark.x, mark.y - 2.5}, target,
          "leader");
      sheet_.raw(fmt::format("<circle class=\"dot\" cx=\"{}\" cy=\"{}\" r=\".45\"/>\n",
                             coordinate(target.x), coordinate(target.y)));
      sheet_.balloon(mark, letter, "mark");
    }
    double y = (columns.empty() ? axis_ + 2 : below_axis + 3) + 5;
    const std::size_t half = (parts_.size() + 1) / 2;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      sheet_.words({i < half ? 4.0 : kPaperWidth / 2 + 2,
                    y + kLine * static_cast<double>(i < half ? i : i - half)},
                   fmt::format("{}: {}", static_cast<char>('A' + i), parts_[i].text), "small");
    return y + kLine * static_cast<double>(half) + 1;
  }

  [[nodiscard]] std::string description() const {
    std::string text = fmt::format("Scale {}. Parts: ", scale_text(sheet_.scale()));
    for (std::size_t i = 0; i < parts_.size(); ++i)
      text +=
          fmt::format("{}{} {}", i == 0 ? "" : "; ", static_cast<char>('A' + i), parts_[i].text);
    text += ". Cracks: ";
    for (const NumberedCrack& c : cracks_)
      text += fmt::format("{}{} {} ({}), {}", c.number == 1 ? "" : "; ", c.number, c.path, c.kind,
                          c.size);
    return text + (cracks_.empty() ? "none." : ".");
  }

  const GearSet& gear_;
  Layout at_;
  std::vector<NumberedCrack> cracks_;
  Sheet sheet_;
  double axis_ = 0.0;  ///< y of the centre line [mm]
  double left_ = 0.0;  ///< x of z = 0 [mm]
  std::vector<Marked> parts_;
  std::vector<Balloon> crack_marks_;
  std::vector<Detail> details_;
  std::map<const Ring*, int> placed_;
  int n_wide_ = 0;  ///< number of cracks over the width of a ring so far
};

}  // namespace

std::string section_drawing(const GearSet& gear) {
  if (!gear.wave_generator && !gear.flexspline && !gear.circular_spline && !gear.output_shaft)
    return {};
  return Section(gear).svg();
}

}  // namespace strainwave

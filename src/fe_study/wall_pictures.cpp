// SPDX-License-Identifier: Apache-2.0
#include "wall_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "painter.hpp"
#include "strainwave/chart/chart.hpp"

namespace strainwave::fe_study {
namespace {

using fem::FieldPoint;
using fem::Point3;
using std::numbers::pi;

Point3 operator+(const Point3& a, const Point3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point3 operator-(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3 operator*(double f, const Point3& a) { return {f * a[0], f * a[1], f * a[2]}; }
double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const Point3& a) { return std::sqrt(dot(a, a)); }

/// One face of a cell on the boundary, with the points of its grid; the first index runs fastest.
struct BoundaryFace {
  std::vector<const FieldPoint*> points;
  Point3 outward{};  ///< vector from the middle of the cell [m]
};

std::vector<BoundaryFace> boundary_faces(const fem::SampledFields& fields) {
  const auto n = static_cast<std::size_t>(fields.divisions) + 1;
  const std::array<std::size_t, 3> stride = {1, n, n * n};
  std::vector<BoundaryFace> faces;
  for (const fem::FieldCell& cell : fields.cells) {
    const Point3 middle = 0.5 * (cell.points.front().place + cell.points.back().place);
    for (std::size_t f = 0; f < 6; ++f) {
      if (cell.face_tag[f] == 0) continue;
      const std::size_t across = f / 2;
      const std::size_t first = across == 0 ? 1 : 0;
      const std::size_t second = across == 2 ? 1 : 2;
      BoundaryFace& face = faces.emplace_back();
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          face.points.push_back(&cell.points[(f % 2) * (n - 1) * stride[across] +
                                             i * stride[first] + j * stride[second]]);
      face.outward = 0.5 * (face.points.front()->place + face.points.back()->place) - middle;
    }
  }
  return faces;
}

/// The face of the wall at a radius.
std::vector<BoundaryFace> cylinder(const std::vector<BoundaryFace>& faces, double radius,
                                   double tolerance) {
  std::vector<BoundaryFace> found;
  for (const BoundaryFace& face : faces)
    if (std::ranges::all_of(face.points, [&](const FieldPoint* p) {
          return std::abs(std::hypot(p->place[0], p->place[1]) - radius) < tolerance;
        }))
      found.push_back(face);
  return found;
}

/// The view of a distant camera: maps space to paper.
struct View {
  Point3 right{}, up{}, toward{};  ///< orthonormal; `toward` points to the eye
  Point3 centre{};                 ///< point drawn at `origin` [m]
  PaperPoint origin{};
  double scale = 1.0;  ///< px per metre

  [[nodiscard]] PaperPoint paper(const Point3& p) const {
    const Point3 d = p - centre;
    return {origin.x + scale * dot(d, right), origin.y - scale * dot(d, up)};
  }
};

View view_from(Point3 toward, const Point3& up) {
  View view;
  view.toward = (1 / norm(toward)) * toward;
  const Point3 right = cross(up, view.toward);
  view.right = (1 / norm(right)) * right;
  view.up = cross(view.toward, view.right);
  return view;
}

std::string torque_text(double torque) {
  return fmt::format("T = {}{} N·m", torque < 0 ? "" : "+", shown_number(torque));
}

class WallPictures {
 public:
  explicit WallPictures(const CrackedWall& wall)
      : wall_(wall),
        fields_(wall.solid->fields),
        radius_(wall.mean_radius + (wall.inside ? -0.5 : 0.5) * wall.wall_thickness),
        all_(boundary_faces(fields_)),
        face_(cylinder(all_, radius_, 1e-3 * wall.wall_thickness)),
        window_(
            std::min({2.4 * wall.half_length, 0.5 * wall.length, 0.9 * pi * wall.mean_radius})) {
    for (const BoundaryFace& face : face_)
      for (const FieldPoint* const p : face.points)  // not at the joints of a cup
        if (std::abs(p->place[2] - wall_.place) <= window_)
          sound_ = std::max(sound_, p->energy_density_without_crack);
  }

  [[nodiscard]] std::string energy() const {
    return surface({.map = ColourMap::rising, .lower = 0, .upper = round_up(2.4 * sound_)},
                   "strain energy density", "w [J/m³]",
                   [](const FieldPoint& p) { return p.energy_density; });
  }

  [[nodiscard]] std::string added() const {
    const double most = round_up(sound_);
    return surface(
        {.map = ColourMap::diverging, .lower = -most, .upper = most, .bands = 21},
        "strain energy density, cracked minus sound", "w − w₀ [J/m³]",
        [](const FieldPoint& p) { return p.energy_density - p.energy_density_without_crack; });
  }

  [[nodiscard]] std::string opened() const;
  [[nodiscard]] std::string stress_intensity() const;

 private:
  using Value = std::function<double(const FieldPoint&)>;

  [[nodiscard]] std::vector<std::string> captions(const std::string& more) const {
    std::vector<std::string> lines = {
        wall_.description,
        fmt::format("{}; the crack is {}. {}", torque_text(wall_.torque), wall_.state, more)};
    if (!wall_.fault.empty()) lines.push_back("NOT usable: " + wall_.fault);
    return lines;
  }
  [[nodiscard]] std::string titled(const std::string& what) const {
    return wall_.path + ": " + what;
  }
  [[nodiscard]] std::string face_name() const { return wall_.inside ? "inner" : "outer"; }

  /// Direction of the crack and of its normal at theta = 0.
  [[nodiscard]] Point3 along() const { return {0, -std::sin(wall_.angle), std::cos(wall_.angle)}; }
  [[nodiscard]] Point3 across() const {
    return {0, -std::cos(wall_.angle), -std::sin(wall_.angle)};
  }

  [[nodiscard]] std::string surface(const ValueScale& scale, const std::string& what,
                                    const std::string& quantity, const Value& value) const;
  void whole_tube(PictureSheet& sheet, PaperPoint corner, double width, double height,
                  const ValueScale& scale, const Value& value) const;
  void outline_tube(PictureSheet& sheet, const View& view) const;
  void axes(PictureSheet& sheet, PaperPoint corner) const;

  const CrackedWall& wall_;
  const fem::SampledFields& fields_;
  double radius_;
  std::vector<BoundaryFace> all_;
  std::vector<BoundaryFace> face_;
  double window_;  ///< half of the side of the drawn square [m]
  double sound_ = 0.0;
};

/// Draws the directions of z and theta.
void WallPictures::axes(PictureSheet& sheet, PaperPoint corner) const {
  sheet.arrow(corner, {corner.x + 46, corner.y});
  sheet.words({corner.x + 52, corner.y + 4}, "tick", "z");
  sheet.arrow(corner, {corner.x, corner.y - 34});
  sheet.words({corner.x + 6, corner.y - 26}, "tick", "−θ");
}

std::string WallPictures::surface(const ValueScale& scale, const std::string& what,
                                  const std::string& quantity, const Value& value) const {
  constexpr double kSize = 440;
  constexpr PaperPoint kCorner{24, 104};
  PictureSheet sheet(900, 606);
  sheet.title(titled(what), captions(fmt::format("Sound wall, {} face: {} J/m³.", face_name(),
                                                 shown_number(sound_))));
  const double px = kSize / (2 * window_);
  const PaperPoint middle{kCorner.x + kSize / 2, kCorner.y + kSize / 2};
  BandPainter painter(scale);
  for (const BoundaryFace& face : face_) {
    PaperPatch patch{
        .divisions = static_cast<std::size_t>(fields_.divisions), .points = {}, .values = {}};
    double from = 4;
    double to = -4;
    bool seen = false;
    for (const FieldPoint* const p : face.points) {
      const double theta = std::atan2(p->place[1], p->place[0]);
      from = std::min(from, theta);
      to = std::max(to, theta);
      const double z = p->place[2] - wall_.place;
      const double s = -radius_ * theta;
      seen = seen || (std::abs(z) <= window_ && std::abs(s) <= window_);
      patch.points.push_back({middle.x + px * z, middle.y - px * s});
      patch.values.push_back(value(*p));
    }
    // A large cell may be visible although its points lie outside the window, so test its bounding
    // box.
    PaperPoint low = patch.points.front();
    PaperPoint high = low;
    for (const PaperPoint& p : patch.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    seen = seen || (low.x < kCorner.x + kSize && high.x > kCorner.x && low.y < kCorner.y + kSize &&
                    high.y > kCorner.y);
    if (seen && to - from < pi) painter.patch(patch);
  }
  sheet.begin_clip("window", kCorner, kSize, kSize);
  sheet.raw(painter.svg());
  const double dx = px * wall_.half_length * std::cos(wall_.angle);
  const double dy = px * wall_.half_length * std::sin(wall_.angle);
  const std::array crack = {PaperPoint{middle.x - dx, middle.y + dy},
                            PaperPoint{middle.x + dx, middle.y - dy}};
  sheet.line(crack, "halo");
  sheet.line(crack, "crack");
  sheet.end_clip();
  sheet.raw(fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                        kCorner.x, kCorner.y, kSize, kSize));
  sheet.scale_bar({kCorner.x, kCorner.y + kSize + 14}, px, 150);
  sheet.words({kCorner.x, kCorner.y + kSize + 44}, "small",
              fmt::format("{} face of the wall about the crack (black line), unrolled, seen from "
                          "outside",
                          wall_.inside ? "Inner" : "Outer"));
  axes(sheet, {kCorner.x + kSize + 40, kCorner.y + kSize + 44});
  sheet.colour_bar({500, 150}, 316, scale, quantity, "singular at the tips");
  whole_tube(sheet, {610, 120}, 270, 360, scale, value);
  sheet.words({610, 508}, "small",
              fmt::format("the {}: radius {}, length {},", wall_.body, in_mm(wall_.mean_radius),
                          in_mm(wall_.length)));
  sheet.words({610, 523}, "small",
              fmt::format("wall {}; at another scale", in_mm(wall_.wall_thickness)));
  return sheet.svg(what + " on the wall of a tube with a crack, in colours");
}

void WallPictures::whole_tube(PictureSheet& sheet, PaperPoint corner, double width, double height,
                              const ValueScale& scale, const Value& value) const {
  View view = view_from({1, -0.42, 0.5}, {0, -1, 0});
  view.centre = {0, 0, (wall_.outline.front().from + wall_.outline.back().to) / 2};
  view.origin = {corner.x + width / 2, corner.y + height / 2};
  double half_width = 0.0;
  double half_height = 0.0;
  for (const BoundaryFace& face : all_)
    for (const FieldPoint* const p : face.points) {
      const PaperPoint at = view.paper(p->place);
      half_width = std::max(half_width, std::abs(at.x - view.origin.x));
      half_height = std::max(half_height, std::abs(at.y - view.origin.y));
    }
  view.scale = 0.5 * std::min(width / half_width, height / half_height);
  DepthPainter painter;
  const auto n = static_cast<std::size_t>(fields_.divisions);
  for (const BoundaryFace& face : all_) {
    // A face turned away from the eye is hidden by the wall itself.
    if (dot(face.outward, view.toward) < -0.5 * norm(face.outward)) continue;
    const auto at = [&](std::size_t i, std::size_t j) { return face.points[j * (n + 1) + i]; };
    const PaperPoint a = view.paper(at(0, 0)->place);
    const PaperPoint b = view.paper(at(n, n)->place);
    const std::size_t step = std::hypot(a.x - b.x, a.y - b.y) < 6 ? n : 1;
    for (std::size_t j = 0; j < n; j += step)
      for (std::size_t i = 0; i < n; i += step) {
        const std::array corner_points = {at(i, j), at(i + step, j), at(i + step, j + step),
                                          at(i, j + step)};
        std::vector<PaperPoint> outline;
        double mean = 0.0;
        double depth = 0.0;
        for (const FieldPoint* const p : corner_points) {
          outline.push_back(view.paper(p->place));
          mean += value(*p) / 4;
          depth += dot(p->place, view.toward) / 4;
        }
        painter.polygon(depth, std::move(outline), scale.colour(scale.band(mean)));
      }
  }
  sheet.raw(painter.svg());
  outline_tube(sheet, view);
  // Frame of the enlarged square.
  std::vector<PaperPoint> square;
  constexpr int kSteps = 12;
  const auto side = [&](double z0, double s0, double z1, double s1) {
    for (int i = 0; i <= kSteps; ++i) {
      const double share = static_cast<double>(i) / kSteps;
      const double theta = -std::lerp(s0, s1, share) / radius_;
      square.push_back(view.paper({radius_ * std::cos(theta), radius_ * std::sin(theta),
                                   wall_.place + std::lerp(z0, z1, share)}));
    }
  };
  const double w = window_;
  side(-w, -w, w, -w);
  side(w, -w, w, w);
  side(w, w, -w, w);
  side(-w, w, -w, -w);
  sheet.line(square, "halo");
  sheet.line(square, "thin");
}

/// Draws the visible edges: both ends of each tube, and the lines at which its wall turns away from
/// the eye.
void WallPictures::outline_tube(PictureSheet& sheet, const View& view) const {
  constexpr int kSteps = 180;
  const auto at = [&](double r, double theta, double z) {
    return view.paper({r * std::cos(theta), r * std::sin(theta), z});
  };
  const double facing = std::atan2(view.toward[1], view.toward[0]);
  const auto circle = [&](double r, double z, double half) {
    std::vector<PaperPoint> line;
    for (int i = 0; i <= kSteps; ++i)
      line.push_back(at(r, facing + half * (2.0 * i / kSteps - 1), z));
    sheet.line(line, "thin");
  };
  for (const DrawnTube& tube : wall_.outline) {
    circle(tube.outer_radius, tube.from, pi / 2);
    const bool open_end = &tube == &wall_.outline.back();
    circle(tube.outer_radius, tube.to, open_end ? pi : pi / 2);
    if (open_end) circle(tube.inner_radius, tube.to, pi);
    for (const double turn : {-pi / 2, pi / 2})
      sheet.line(std::array{at(tube.outer_radius, facing + turn, tube.from),
                            at(tube.outer_radius, facing + turn, tube.to)},
                 "thin");
  }
}

/// A rigid displacement of a body: rotation about a centre and translation.
struct RigidMotion {
  Point3 centre{}, shift{}, turn{};

  [[nodiscard]] Point3 at(const Point3& p) const { return shift + cross(turn, p - centre); }
};

struct Sample {
  Point3 place{}, displacement{};
  double weight{};
};

/// The rigid motion with the least mean square difference from the samples.
RigidMotion rigid_motion(const std::vector<Sample>& samples) {
  RigidMotion motion;
  double whole = 0.0;
  for (const Sample& s : samples) {
    whole += s.weight;
    motion.centre = motion.centre + s.weight * s.place;
    motion.shift = motion.shift + s.weight * s.displacement;
  }
  if (!(whole > 0)) return motion;
  motion.centre = (1 / whole) * motion.centre;
  motion.shift = (1 / whole) * motion.shift;
  std::array<Point3, 3> inertia{};
  Point3 moment{};
  for (const Sample& s : samples) {
    const Point3 d = s.place - motion.centre;
    moment = moment + s.weight * cross(d, s.displacement);
    for (std::size_t i = 0; i < 3; ++i) {
      inertia[i][i] += s.weight * dot(d, d);
      for (std::size_t j = 0; j < 3; ++j) inertia[i][j] -= s.weight * d[i] * d[j];
    }
  }
  const double determinant = dot(inertia[0], cross(inertia[1], inertia[2]));
  if (!(std::abs(determinant) > 0)) return motion;
  motion.turn = (1 / determinant) * Point3{dot(moment, cross(inertia[1], inertia[2])),
                                           dot(moment, cross(inertia[2], inertia[0])),
                                           dot(moment, cross(inertia[0], inertia[1]))};
  return motion;
}

std::string WallPictures::opened() const {
  constexpr double kWidth = 640;
  constexpr double kHeight = 440;
  constexpr PaperPoint kCorner{24, 104};
  const double a = wall_.half_length;
  const double half = std::min(1.45 * a, window_);
  const auto n = static_cast<std::size_t>(fields_.divisions);
  std::vector<Sample> samples;
  for (const BoundaryFace& face : face_) {
    const Point3 d1 = face.points.back()->place - face.points.front()->place;
    const Point3 d2 = face.points[n]->place - face.points[n * (n + 1)]->place;
    const FieldPoint& p = *face.points[(n / 2) * (n + 2)];
    const double theta = std::atan2(p.place[1], p.place[0]);
    if (std::abs(p.place[2] - wall_.place) > 1.3 * half || std::abs(radius_ * theta) > 1.3 * half)
      continue;
    samples.push_back({p.place, p.displacement, norm(cross(d1, d2)) / 2});
  }
  const RigidMotion rigid = rigid_motion(samples);
  double jump = 0.0;
  double opening = 0.0;
  for (const fem::CrackFacePatch& patch : fields_.crack_faces)
    for (const fem::CrackFacePoint& p : patch.points) {
      jump = std::max(jump, norm(p.upper - p.lower));
      opening = std::max(opening, p.opening);
    }
  const double magnification = round_down(0.45 * a / std::max(jump, 1e-30));
  const auto moved = [&](const Point3& place, const Point3& u) {
    return place + magnification * (u - rigid.at(place));
  };
  const double side = wall_.inside ? -1.0 : 1.0;
  View view = view_from(Point3{side, 0, 0} + 0.5 * across() + 0.1 * along(), {0, -1, 0});
  view.centre = {radius_, 0, wall_.place};
  view.origin = {kCorner.x + kWidth / 2, kCorner.y + kHeight / 2};
  view.scale = std::min(kWidth, kHeight) / (2 * half);
  const ValueScale scale{.map = ColourMap::rising, .lower = 0, .upper = round_up(2.4 * sound_)};
  DepthPainter painter;
  const auto grid = [&](const std::vector<Point3>& points, const std::vector<double>& values,
                        std::string_view edge) {
    PaperPatch patch{.divisions = n, .points = {}, .values = values};
    double depth = 0.0;
    for (const Point3& p : points) {
      patch.points.push_back(view.paper(p));
      depth += dot(p, view.toward) / static_cast<double>(points.size());
    }
    const PaperPoint p0 = patch.points.front();
    const PaperPoint p1 = patch.points.back();
    const bool small = std::hypot(p0.x - p1.x, p0.y - p1.y) < 5;
    if (values.empty()) {
      painter.polygon(depth, patch.outline(), "#d9875f");
    } else {
      BandPainter bands(scale);
      bands.patch(patch);
      painter.finished(depth, bands.svg());
    }
    if (!small) painter.polygon(depth, patch.outline(), "none", edge);
  };
  for (const BoundaryFace& face : face_) {
    const Point3& middle = face.points[(n / 2) * (n + 2)]->place;
    if (std::abs(middle[2] - wall_.place) > 3 * half || middle[0] < 0 ||
        std::abs(middle[1]) > 3 * half)
      continue;
    std::vector<Point3> points;
    std::vector<double> values;
    for (const FieldPoint* const p : face.points) {
      points.push_back(moved(p->place, p->displacement));
      values.push_back(p->energy_density);
    }
    grid(points, values, "mesh");
  }
  for (const fem::CrackFacePatch& patch : fields_.crack_faces)
    for (const auto which : {&fem::CrackFacePoint::upper, &fem::CrackFacePoint::lower}) {
      std::vector<Point3> points;
      for (const fem::CrackFacePoint& p : patch.points) points.push_back(moved(p.place, p.*which));
      grid(points, {}, "face");
    }
  PictureSheet sheet(900, 606);
  sheet.title(titled("the crack under load, magnified"),
              captions(fmt::format("Largest opening {} µm, displacements magnified {} times.",
                                   shown_number(opening * 1e6), shown_number(magnification))));
  sheet.begin_clip("window", kCorner, kWidth, kHeight);
  sheet.raw(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#d8d8d8\"/>\n",
                        kCorner.x, kCorner.y, kWidth, kHeight));
  sheet.raw(painter.svg());
  sheet.end_clip();
  sheet.raw(fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                        kCorner.x, kCorner.y, kWidth, kHeight));
  sheet.scale_bar({kCorner.x, kCorner.y + kHeight + 14}, view.scale, 150);
  sheet.words({kCorner.x, kCorner.y + kHeight + 44}, "small",
              fmt::format("Seen obliquely from {}; copper: faces of the crack; thin lines: "
                          "elements; the mean motion of the part is subtracted",
                          wall_.inside ? "inside" : "outside"));
  sheet.colour_bar({720, 150}, 316, scale, "w [J/m³]", "singular at the tips");
  axes(sheet, {720, kCorner.y + kHeight + 44});
  return sheet.svg("Deformed wall about a crack, displacements magnified");
}

std::string WallPictures::stress_intensity() const {
  constexpr int kPoints = 12;  // points on a segment
  constexpr double kMPa = 1e6;
  const std::array names = {"K_I", "K_II", "K_III"};
  const std::array modes = {&fem::FrontStation::K_I, &fem::FrontStation::K_II,
                            &fem::FrontStation::K_III};
  PlotPanel panel{
      .title = titled(wall_.fault.empty() ? "stress intensity along the crack front"
                                          : "stress intensity along the crack front; NOT usable"),
      .subtitle = fmt::format("{}; {}, faces {}", wall_.description, torque_text(wall_.torque),
                              wall_.state),
      .x_label = wall_.along + " [mm]",
      .y_label = "stress intensity factor K [MPa·√m]"};
  for (std::size_t f = 0; f < wall_.solid->fronts.size(); ++f) {
    const std::vector<fem::FrontStation>& stations = wall_.solid->fronts[f].stations;
    for (std::size_t mode = 0; mode < 3; ++mode) {
      PlotSeries series{.label = fmt::format("{}, {}", names[mode], wall_.front_names.at(f))};
      double before = 0.0;
      // The quadratic of an end segment contains the value at the corner, so draw only its
      // stations.
      for (std::size_t k = 1; wall_.corners && k + 1 < stations.size(); ++k) {
        before += norm(stations[k].place - stations[k - 1].place);
        series.x.push_back(before * 1e3);
        series.y.push_back(stations[k].*modes[mode] / kMPa);
      }
      // K is quadratic along each segment, as in its computation (FE-23).
      for (std::size_t k = 0; !wall_.corners && k + 2 < stations.size(); k += 2) {
        const double first = norm(stations[k + 1].place - stations[k].place);
        const double second = norm(stations[k + 2].place - stations[k + 1].place);
        for (int i = 0; i <= kPoints; ++i) {
          const double w = static_cast<double>(i) / kPoints;
          const std::array<double, 3> shape = {(1 - w) * (1 - 2 * w), 4 * w * (1 - w),
                                               w * (2 * w - 1)};
          double K = 0.0;
          for (std::size_t j = 0; j < 3; ++j) K += shape[j] * stations[k + j].*modes[mode];
          if (mode == 0 && wall_.closed) K = 0.0;
          const double s = w < 0.5 ? 2 * w * first : first + (2 * w - 1) * second;
          series.x.push_back((before + s) * 1e3);
          series.y.push_back(K / kMPa);
        }
        before += first + second;
      }
      panel.series.push_back(std::move(series));
    }
  }
  return svg_plot(std::array{panel});
}

}  // namespace

std::vector<OutputFile> wall_pictures(const CrackedWall& wall) {
  const WallPictures pictures(wall);
  const std::string stem = file_stem(wall.path);
  return {{stem + "_energy.svg", pictures.energy()},
          {stem + "_added_energy.svg", pictures.added()},
          {stem + "_opened.svg", pictures.opened()},
          {stem + "_stress_intensity.svg", pictures.stress_intensity()}};
}

}  // namespace strainwave::fe_study

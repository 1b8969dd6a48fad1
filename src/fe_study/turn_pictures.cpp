// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "painter.hpp"
#include "strainwave/chart/moving_plot.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/turn_run.hpp"
#include "strainwave/present/turn.hpp"
#include "turn_files.hpp"

namespace strainwave::fe_study {
namespace {

using gear_fem::CrackPlane;
using gear_fem::CrackTurn;
using gear_fem::SoundRing;
using gear_fem::TorqueTurn;
using std::numbers::pi;

constexpr double kMicrometre = 1e-6;
/// No picture is larger than this [byte].
constexpr std::size_t kLargestPicture = 1'900'000;
/// Largest number of states in an animation, which an eye can tell apart.
constexpr std::size_t kMostFrames = 60;
constexpr double kSecondsOfAWave = 9;

std::string torque_words(double torque) {
  return fmt::format("T = {}{} N·m", torque > 0 ? "+" : "", shown_number(torque));
}

std::string shown_degrees(double angle) { return fmt::format("{:.4g}°", angle / units::deg); }

/// The lines below the title of a picture.
std::vector<std::string> captions(const TurnAtSize& size, const std::string& more) {
  std::vector<std::string> lines = {
      fmt::format("{}, {}, wall {}. {}", size.depth ? "surface crack" : "through crack",
                  size.name(), in_mm(2 * size.turn.plane.half_wall), more)};
  if (!size.turn.usable) lines.push_back("NOT usable: " + size.turn.reason);
  return lines;
}

// --- the crack through the wall

/// The plane of a crack on paper, with its upper tip to the right and the outer face of the wall
/// upward.  The wall is stretched.
class PlaneView {
 public:
  /// @param corner  upper left [px]
  PlaneView(const CrackPlane& plane, PaperPoint corner, double width, double most_height)
      : plane_(plane), corner_(corner), width_(width) {
    double reach = 0;
    for (const CrackPlane::Node& node : plane.nodes) reach = std::max(reach, std::abs(node.along));
    const double wall = 2 * plane.half_wall;
    scale_ = std::min(width / (kRoom * 2 * reach), most_height / wall);
    stretch_ = std::max(1.0, std::floor(most_height / (wall * scale_)));
  }

  [[nodiscard]] double height() const { return 2 * plane_.half_wall * scale_ * stretch_; }
  [[nodiscard]] double stretch() const { return stretch_; }
  [[nodiscard]] double scale() const { return scale_; }  ///< along the crack [px/m]
  [[nodiscard]] PaperPoint paper(const CrackPlane::Node& node) const {
    return {corner_.x + width_ / 2 + scale_ * node.along,
            corner_.y + scale_ * stretch_ * (plane_.half_wall - node.through)};
  }

  /// The section of the wall, its faces and their names.
  void draw_wall(PictureSheet& sheet) const {
    sheet.raw(
        fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                    "fill=\"#d8d8d8\"/>\n",
                    corner_.x, corner_.y, width_, height()));
    for (const bool outer : {true, false}) {
      const double y = corner_.y + (outer ? 0 : height());
      sheet.line(std::array{PaperPoint{corner_.x, y}, PaperPoint{corner_.x + width_, y}}, "thin");
      sheet.words({corner_.x, y + (outer ? -5.0 : 14.0)}, "tick",
                  outer ? "outer face" : "inner face");
    }
    sheet.words({corner_.x + width_ - 66, corner_.y + height() + 14}, "tick", "upper tip →");
  }

  /// The opening in colours, and a cross at each place that touches.
  [[nodiscard]] std::string faces(const gear_fem::FacesAtAngle& faces,
                                  const ValueScale& scale) const {
    BandPainter painter(scale);
    for (const fem::CrackCell& cell : plane_.cells) {
      const auto side =
          static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(cell.nodes.size()))));
      PaperPatch patch{.divisions = side - 1, .points = {}, .values = {}};
      for (const std::size_t node : cell.nodes) {
        patch.points.push_back(paper(plane_.nodes[node]));
        patch.values.push_back(faces.opening[node] / kMicrometre);
      }
      painter.patch(patch);
    }
    std::string crosses;
    for (std::size_t n = 0; n < plane_.nodes.size(); ++n) {
      if (!faces.touching[n]) continue;
      constexpr double kHalf = 2.2;
      const auto [x, y] = paper(plane_.nodes[n]);
      crosses += path_of(
          std::array{PaperPoint{x - kHalf, y - kHalf}, PaperPoint{x + kHalf, y + kHalf}}, false);
      crosses += path_of(
          std::array{PaperPoint{x - kHalf, y + kHalf}, PaperPoint{x + kHalf, y - kHalf}}, false);
    }
    std::string svg = painter.svg();
    if (!crosses.empty()) svg += fmt::format("<path class=\"touch\" d=\"{}\"/>\n", crosses);
    return svg;
  }

 private:
  static constexpr double kRoom = 1.12;  ///< drawn length over that of the crack
  const CrackPlane& plane_;
  PaperPoint corner_;
  double width_;
  double scale_;
  double stretch_;
};

ValueScale opening_scale(double largest) {
  return {.map = ColourMap::rising, .lower = 0, .upper = round_up(largest / kMicrometre)};
}

std::size_t angle_of_opening(const TorqueTurn& turn) {
  const auto angles = static_cast<double>(turn.faces.size());
  return static_cast<std::size_t>(std::lround(turn.at_opening / pi * angles)) % turn.faces.size();
}

/// The opening under each torque at the angle of its largest opening.
std::string opening_map(const TurnRun& run, const TurnAtSize& size) {
  constexpr double kLeft = 24;
  constexpr double kTop = 130;
  constexpr double kWidth = 690;
  constexpr double kMostHeight = 110;
  constexpr double kBetween = 84;
  const CrackTurn& turn = size.turn;
  double largest = 0;
  for (const TorqueTurn& torque : turn.torques) largest = std::max(largest, torque.largest_opening);
  const ValueScale scale = opening_scale(largest);
  const double step = PlaneView(turn.plane, {kLeft, kTop}, kWidth, kMostHeight).height() + kBetween;
  const double end = kTop + step * static_cast<double>(turn.torques.size());
  PictureSheet sheet(900, std::max(end, 460.0));
  sheet.title(run.path + ": opening through the wall, at the angle of the largest opening",
              captions(size, "White crosses: the faces touch."));
  double top = kTop;
  for (const TorqueTurn& torque : turn.torques) {
    const PlaneView view(turn.plane, {kLeft, top}, kWidth, kMostHeight);
    const gear_fem::FacesAtAngle& faces = torque.faces[angle_of_opening(torque)];
    const std::string state =
        torque.largest_opening > 0
            ? fmt::format("{} from a lobe: largest opening {} µm, {:.3g} % of the crack touches",
                          shown_degrees(torque.at_opening),
                          shown_number(torque.largest_opening / kMicrometre),
                          100 * faces.contact_share)
            : std::string("the crack is closed over the whole turn");
    sheet.words({kLeft, top - 22}, "label",
                fmt::format("{}, {}", torque_words(torque.torque), state));
    view.draw_wall(sheet);
    sheet.raw(view.faces(faces, scale));
    sheet.scale_bar({kLeft + 120, top + view.height() + 8}, view.scale(), 150);
    sheet.words({kLeft + 360, top + view.height() + 14}, "small",
                view.stretch() > 1 ? fmt::format("wall stretched {:g} times", view.stretch())
                                   : std::string("to scale"));
    top += step;
  }
  sheet.colour_bar({770, kTop}, 280, scale, "opening [µm]", "");
  return sheet.svg("Opening of a crack over its length and the thickness of the wall, in colours");
}

// --- the animation

/// The section of the wall across the axis, with the lobes of the wave generator up and down.
class RingView {
 public:
  RingView(const SoundRing& ring, PaperPoint middle) : ring_(ring), middle_(middle) {
    double most = 0;
    for (const double outward : ring.outward) most = std::max(most, std::abs(outward));
    scale_ = kRadius / ring.radii[ring.radii.size() / 2];
    magnification_ = most > 0 ? std::max(1.0, round_down(kOval / (scale_ * most))) : 1.0;
    thicker_ = std::max(1.0, round_down(kWall / (scale_ * (ring.radii.back() - ring.radii[0]))));
  }

  [[nodiscard]] double magnification() const { return magnification_; }
  [[nodiscard]] double thicker() const { return thicker_; }

  /// Distance of a point of the ring from the middle [px].
  /// @param at       index into the angles
  /// @param through  place in the wall, from its middle surface outward [m]
  [[nodiscard]] double height(std::size_t at, double through) const {
    const double mean = ring_.radii[ring_.radii.size() / 2];
    return scale_ * (mean + magnification_ * ring_.outward[at] + thicker_ * through);
  }

  /// The stress in colours.
  [[nodiscard]] std::string stress(const std::vector<double>& values,
                                   const ValueScale& scale) const {
    const std::size_t radii = ring_.radii.size();
    const std::size_t n = radii - 1;
    BandPainter painter(scale);
    for (const double half_turn : {0.0, pi})
      for (std::size_t first = 0; first + n < ring_.angles.size(); first += n) {
        PaperPatch patch{.divisions = n, .points = {}, .values = {}};
        for (std::size_t i = first; i <= first + n; ++i)
          for (std::size_t r = 0; r < radii; ++r) {
            const double angle = ring_.angles[i] + half_turn;
            const double h = height(i, ring_.radii[r] - ring_.radii[n / 2]);
            patch.points.push_back(
                {middle_.x - h * std::sin(angle), middle_.y - h * std::cos(angle)});
            patch.values.push_back(values[i * radii + r] / units::MPa);
          }
        painter.patch(patch);
      }
    return painter.svg();
  }

 private:
  static constexpr double kRadius = 130;  ///< of the middle surface [px]
  static constexpr double kOval = 22;     ///< most that the oval may depart from the circle [px]
  static constexpr double kWall = 36;     ///< most for the wall [px]
  const SoundRing& ring_;
  PaperPoint middle_;
  double scale_;
  double magnification_;
  double thicker_;
};

/// Every `step`-th state of a turn; the last one may stand for fewer.
struct ShownStates {
  std::size_t angles;
  std::size_t step;

  [[nodiscard]] std::size_t count() const { return (angles + step - 1) / step; }
  /// Share of a round at which a state is reached.
  [[nodiscard]] double at(std::size_t part) const {
    return static_cast<double>(part * step) / static_cast<double>(angles);
  }
};

/// Group that is shown while the round is nearest to one of its states.
/// @param start  the state that the animation shows first
std::string shown_at(const std::string& svg, std::size_t part, std::size_t start,
                     const ShownStates& states, const Rounds& rounds) {
  std::string values = part == 0 ? "inline" : "none;inline";
  std::string times = part == 0 ? "0" : fmt::format("0;{:.6g}", states.at(part));
  if (part + 1 < states.count()) {
    values += ";none";
    times += fmt::format(";{:.6g}", states.at(part + 1));
  }
  // A state is shown from half a step before its angle to half a step after it.
  return fmt::format(
      "<g display=\"{}\">\n{}<animate attributeName=\"display\" calcMode=\"discrete\" "
      "values=\"{}\" keyTimes=\"{}\" {}/></g>\n",
      part == start ? "inline" : "none", svg, values, times, rounds.attributes(-states.at(1) / 2));
}

class Animation {
 public:
  Animation(const TurnRun& run, std::size_t size, std::size_t torque)
      : run_(run),
        size_(run.sizes[size]),
        torque_(size_.turn.torques[torque]),
        turns_(run.turns()),
        size_number_(size),
        torque_number_(torque) {}

  /// The document with every `step`-th state.
  [[nodiscard]] std::string svg(std::size_t step) const;

 private:
  void draw_ring(PictureSheet& sheet, const Rounds& rounds) const;
  void draw_opening(PictureSheet& sheet, const Rounds& rounds, const ShownStates& states) const;
  /// The state nearest below the largest opening.
  [[nodiscard]] std::size_t first(const ShownStates& states) const {
    return angle_of_opening(torque_) / states.step;
  }

  const TurnRun& run_;
  const TurnAtSize& size_;
  const TorqueTurn& torque_;
  std::vector<SizedTurn> turns_;
  std::size_t size_number_;
  std::size_t torque_number_;
};

void Animation::draw_ring(PictureSheet& sheet, const Rounds& rounds) const {
  constexpr PaperPoint kMiddle{196, 280};
  const SoundRing& ring = size_.turn.ring;
  const RingView view(ring, kMiddle);
  double most = 0;
  for (const double stress : torque_.ring_stress)
    most = std::max(most, std::abs(stress) / units::MPa);
  const double upper = round_up(most);
  const ValueScale scale{.map = ColourMap::diverging, .lower = -upper, .upper = upper, .bands = 21};
  const std::string place = fmt::format("{:g} {:g}", kMiddle.x, kMiddle.y);
  sheet.raw(fmt::format("<g transform=\"rotate({:.2f} {})\">\n", 180 * rounds.start, place));
  sheet.raw(view.stress(torque_.ring_stress, scale));
  const CrackPlane& plane = size_.turn.plane;
  const double rest = view.height(0, -plane.half_wall);  // inner face at a lobe
  sheet.line(std::array{PaperPoint{kMiddle.x, kMiddle.y - rest + 3},
                        PaperPoint{kMiddle.x, kMiddle.y + rest - 3}},
             "dashes");
  sheet.raw(
      fmt::format("<animateTransform attributeName=\"transform\" type=\"rotate\" "
                  "from=\"0 {0}\" to=\"180 {0}\" {1}/></g>\n",
                  place, rounds.attributes()));
  // The crack moves outward and inward with the oval.
  std::string moves;
  for (std::size_t i = 0; i < ring.angles.size(); ++i)
    moves += fmt::format("{}0 {:.1f}", i == 0 ? "" : ";", rest - view.height(i, -plane.half_wall));
  const auto start = static_cast<std::size_t>(
      std::lround(rounds.start * static_cast<double>(ring.angles.size() - 1)));
  sheet.raw(fmt::format("<g transform=\"translate(0 {:.1f})\">\n",
                        rest - view.height(start, -plane.half_wall)));
  double inner = plane.half_wall;
  double outer = -plane.half_wall;
  for (const CrackPlane::Node& node : plane.nodes) {
    inner = std::min(inner, node.through);
    outer = std::max(outer, node.through);
  }
  const std::array crack = {PaperPoint{kMiddle.x, kMiddle.y - view.height(0, inner)},
                            PaperPoint{kMiddle.x, kMiddle.y - view.height(0, outer)}};
  sheet.line(crack, "halo");
  sheet.line(crack, "crack");
  sheet.raw(
      fmt::format("<animateTransform attributeName=\"transform\" type=\"translate\" "
                  "values=\"{}\" {}/></g>\n",
                  moves, rounds.attributes()));
  sheet.words({kMiddle.x - 17, 90}, "tick", "crack");
  sheet.words(
      {20, 478}, "small",
      "Across the axis at the crack, seen from the open end. Colours: stress of the sound wall "
      "normal to the crack.");
  sheet.words(
      {20, 494}, "small",
      fmt::format("Dashed: major axis of the wave generator. The oval is magnified {} times, "
                  "the wall drawn {} times thicker.",
                  shown_number(view.magnification()), shown_number(view.thicker())));
  sheet.colour_bar({400, 150}, 260, scale, "stress [MPa]", "");
}

void Animation::draw_opening(PictureSheet& sheet, const Rounds& rounds,
                             const ShownStates& states) const {
  constexpr double kLeft = 530;
  constexpr double kTop = 158;
  constexpr double kWidth = 346;
  const ValueScale scale = opening_scale(torque_.largest_opening);
  const PlaneView view(size_.turn.plane, {kLeft, kTop}, kWidth, 150);
  sheet.words({kLeft, kTop - 34}, "label", "opening of the crack through the wall [µm]");
  view.draw_wall(sheet);
  for (std::size_t part = 0; part < states.count(); ++part) {
    const gear_fem::FacesAtAngle& faces = torque_.faces[part * states.step];
    const double largest = std::max(0.0, *std::ranges::max_element(faces.opening));
    const PaperPoint at{kLeft, kTop + view.height() + 78};
    PictureSheet words(1, 1);
    words.words(at, "label",
                fmt::format("{} from a lobe to the crack", shown_degrees(pi * states.at(part))));
    words.words({at.x, at.y + 18}, "tick",
                fmt::format("largest opening {:.3f} µm, the faces touch over {:.0f} %",
                            largest / kMicrometre, 100 * faces.contact_share));
    sheet.raw(
        shown_at(view.faces(faces, scale) + words.body(), part, first(states), states, rounds));
  }
  sheet.scale_bar({kLeft, kTop + view.height() + 30}, view.scale(), 130);
  sheet.words(
      {kLeft, kTop + view.height() + 54}, "small",
      fmt::format("{}; white crosses: the faces touch",
                  view.stretch() > 1 ? fmt::format("wall stretched {:g} times", view.stretch())
                                     : std::string("to scale")));
  sheet.level_bar({kLeft, kTop + view.height() + 112}, kWidth, scale);
}

std::string Animation::svg(std::size_t step) const {
  const ShownStates states{.angles = torque_.faces.size(), .step = step};
  const Rounds rounds{.seconds = kSecondsOfAWave, .start = states.at(first(states))};
  constexpr double kChartTop = 520;
  constexpr double kChartWidth = 860;
  PictureSheet sheet(900, kChartTop + panel_height(kChartWidth) + 10);
  sheet.title(run_.path + " over half a turn of the wave generator",
              captions(size_, torque_words(torque_.torque) + "."));
  draw_ring(sheet, rounds);
  draw_opening(sheet, rounds, states);
  const SizedTurn& sized = turns_[size_number_];
  const std::string_view tip = governing_station(turns_)->tip;
  PlotPanel panel = turn_panel(sized, sized.torques[torque_number_], tip);
  const std::vector<double>& x = panel.series.front().x;
  sheet.raw(moving_plot(panel, {.from = x.front(), .to = x.back(), .rounds = rounds},
                        {.x = 20, .y = kChartTop, .width = kChartWidth}));
  return sheet.svg(
      "Animation: the oval wall turns with the wave generator and carries its stress past the "
      "crack, which opens and closes; K_I at each place of the front over half a turn");
}

std::string animation(const TurnRun& run, std::size_t size, std::size_t torque) {
  const Animation made(run, size, torque);
  const std::size_t angles = run.sizes[size].turn.torques[torque].faces.size();
  std::size_t step = (angles + kMostFrames - 1) / kMostFrames;
  std::string svg = made.svg(step);
  while (svg.size() > kLargestPicture && step < angles) {
    // The size is nearly in proportion to the number of states.
    const double over = static_cast<double>(svg.size()) / static_cast<double>(kLargestPicture);
    step = std::max(step + 1, static_cast<std::size_t>(static_cast<double>(step) * over));
    svg = made.svg(step);
  }
  return svg;
}

}  // namespace

std::vector<OutputFile> turn_pictures(const TurnRun& run) {
  std::vector<OutputFile> files;
  for (std::size_t size = 0; size < run.sizes.size(); ++size) {
    const std::string stem = size_stem(run, size);
    files.push_back({stem + "_opening.svg", opening_map(run, run.sizes[size])});
    for (std::size_t torque = 0; torque < run.torques.size(); ++torque)
      files.push_back({torque_stem(stem, torque) + ".svg", animation(run, size, torque)});
  }
  return files;
}

}  // namespace strainwave::fe_study

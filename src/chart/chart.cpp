// SPDX-License-Identifier: Apache-2.0
#include "strainwave/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "chart_numbers.hpp"
#include "contour_lines.hpp"
#include "line_styles.hpp"
#include "strainwave/chart/moving_plot.hpp"
#include "strainwave/chart/svg_text.hpp"

namespace strainwave {
namespace {

// Lengths in px of the SVG's own coordinates.
constexpr double kPlotWidth = 860;
constexpr double kPanelHeight = 400;
constexpr double kLeft = 98;
constexpr double kRight = 200;  // room for the labels of the lines
constexpr double kTop = 60;
constexpr double kBottom = 58;
constexpr double kLabelHeight = 18;

/// The number of characters of a UTF-8 text.
std::size_t shown_length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The first `most` characters of a UTF-8 text, with an ellipsis if there are more.
std::string shortened(std::string_view text, std::size_t most) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_character = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (begins_character && n++ == most) return std::string(text.substr(0, i)) + "…";
  }
  return std::string(text);
}

/// A tick label with a fixed number of decimals and a typographic minus sign.
std::string fixed(double value, int decimals) {
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !zero ? "−" + digits : digits;
}

struct ValueRange {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void include(double value) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  [[nodiscard]] bool empty() const { return !(lower <= upper); }
};

struct Tick {
  double value = 0.0;
  std::string label;  ///< empty: a minor tick
};

/// One axis: its range of values, their positions, and its ticks.
class Axis {
 public:
  /// @param label  label of the axis; an axis of angles over about a turn has ticks every 60 deg
  /// @param steps  approximate number of steps between the ticks of a linear axis
  Axis(ValueRange values, AxisScale scale, double from_px, double to_px,
       std::string_view label = {}, int steps = 6)
      : scale_(scale),
        from_px_(from_px),
        to_px_(to_px),
        in_degrees_(label.ends_with("[deg]")),
        steps_(steps) {
    if (values.empty()) values = {scale == AxisScale::linear ? 0.0 : 1.0, 1.0};
    if (scale == AxisScale::linear)
      place_linear_ticks(widened(values));
    else
      place_decades(values);
  }

  [[nodiscard]] double px(double value) const {
    const double at = scale_ == AxisScale::linear ? value : std::log10(value);
    return from_px_ + (to_px_ - from_px_) * (at - lower_) / (upper_ - lower_);
  }
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  /// Common factor that the labels omit, such as "×10⁻⁶"; usually empty.
  [[nodiscard]] const std::string& factor() const { return factor_; }

 private:
  /// A range that ticks can divide: it surrounds a constant value and is wide enough for distinct
  /// labels.
  static ValueRange widened(const ValueRange& values) {
    const double size = std::max(std::abs(values.lower), std::abs(values.upper));
    const double width = values.upper - values.lower;
    const double lacking = (size == 0 ? 1.0 : width == 0 ? 0.1 * size : 1e-6 * size) - width;
    if (lacking <= 0) return values;
    return {values.lower - lacking / 2, values.upper + lacking / 2};
  }

  /// Places ticks in steps of 1, 2 or 5 times a power of ten; the axis ends at ticks.
  void place_linear_ticks(const ValueRange& values) {
    const double raw = (values.upper - values.lower) / steps_;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * decade;
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor * decade >= raw * (1 - 1e-9)) {
        step = factor * decade;
        break;
      }
    }
    const double width = values.upper - values.lower;
    if (in_degrees_ && width > 240 && width <= 360) step = 60;
    const double first = std::floor(values.lower / step + 1e-9);
    const double last = std::ceil(values.upper / step - 1e-9);
    lower_ = first * step;
    upper_ = last * step;
    // Very large or small labels share one power of ten, which is written once.
    const double size = std::max(std::abs(lower_), std::abs(upper_));
    int exponent = 0;
    if (size >= 1e6 || size < 1e-3) {
      exponent = static_cast<int>(std::floor(std::log10(size)));
      factor_ = "×" + power_of_ten(exponent);
    }
    const int step_exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    const int decimals = std::max(0, exponent - step_exponent);
    const int n_steps = static_cast<int>(last - first);
    for (int i = 0; i <= n_steps; ++i) {
      const double value = (first + i) * step;
      ticks_.push_back({value, fixed(value * std::pow(10.0, -exponent), decimals)});
    }
  }

  /// Places ticks at decades, with labels in between if there are few decades; the axis ends at a
  /// whole digit.
  void place_decades(const ValueRange& values) {
    const auto outward = [](double value, auto round) {
      const double decade = std::pow(10.0, std::floor(std::log10(value)));
      return decade * round(value / decade);
    };
    double lower = outward(values.lower, [](double digit) { return std::floor(digit + 1e-9); });
    double upper = outward(values.upper, [](double digit) { return std::ceil(digit - 1e-9); });
    if (!(upper > lower)) {
      lower /= 2;
      upper *= 2;
    }
    lower_ = std::log10(lower);
    upper_ = std::log10(upper);
    const double decades = upper_ - lower_;
    const int every = std::max(1, static_cast<int>(std::ceil(decades / 8)));
    const bool plain = lower >= 9.9e-4 && upper <= 1.01e5;
    const auto labelled = [&](int digit, int decade) {
      if (digit == 1) return decade % every == 0;
      return decades <= 1 || (decades <= 2.5 && (digit == 2 || digit == 5));
    };
    for (int decade = static_cast<int>(std::floor(lower_)); decade <= std::ceil(upper_); ++decade)
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10.0, decade);
        if (value < lower * (1 - 1e-9) || value > upper * (1 + 1e-9)) continue;
        if (!labelled(digit, decade)) {
          if (decades <= 5) ticks_.push_back({value, {}});
        } else if (plain) {
          ticks_.push_back({value, fixed(value, std::max(0, -decade))});
        } else {
          ticks_.push_back({value, digit == 1 ? power_of_ten(decade)
                                              : fmt::format("{}·{}", digit, power_of_ten(decade))});
        }
      }
  }

  AxisScale scale_;
  double from_px_, to_px_;
  bool in_degrees_ = false;
  int steps_ = 6;
  double lower_ = 0.0, upper_ = 1.0;  ///< limits of the values, or of their logarithms
  std::vector<Tick> ticks_;
  std::string factor_;
};

bool drawable(AxisScale scale, double value) {
  return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x1, y1, x2,
      y2, style);
}

std::string words(double x, double y, std::string_view style, std::string_view text,
                  std::string_view more = {}) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\"{}>{}</text>\n", x, y, style,
                     more, svg_text(text));
}

/// A label of the margin, broken after dots, blanks and underscores into lines of at most `most`
/// bytes.
std::string margin_words(double x, double& y, std::string_view style, std::string_view text,
                         std::size_t most) {
  std::string svg;
  while (text.size() > most) {
    const std::size_t last = text.find_last_of("._ ", most - 1);
    std::size_t end = last == std::string_view::npos || last == 0 ? most : last + 1;
    while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not inside a letter
    svg += words(x, y, style, text.substr(0, end));
    text.remove_prefix(end);
    y += kLabelHeight - 4;
  }
  svg += words(x, y, style, text);
  y += kLabelHeight;
  return svg;
}
// The largest number of characters of a label beside the sample of a line, and of another label.
constexpr std::size_t kMostOfLine = 20;
constexpr std::size_t kMostOfTitle = 26;

/// The points of a series as strokes of a path.  A point that cannot be drawn leaves a gap, and a
/// point between two gaps becomes a short stroke.
std::string path_data(const PlotPanel& panel, const PlotSeries& series, const Axis& x,
                      const Axis& y) {
  const std::size_t n = std::min(series.x.size(), series.y.size());
  const auto visible = [&](std::size_t i) {
    return i < n && drawable(panel.x_scale, series.x[i]) && drawable(panel.y_scale, series.y[i]);
  };
  constexpr double kDot = 3;
  std::string path;
  bool drawing = false;
  for (std::size_t i = 0; i < n; ++i) {
    if (visible(i)) {
      const double at_x = x.px(series.x[i]);
      const double at_y = y.px(series.y[i]);
      if (drawing || visible(i + 1))
        path += fmt::format("{}{:.2f},{:.2f} ", drawing ? "L" : "M", at_x, at_y);
      else
        path += fmt::format("M{:.2f},{:.2f} h{} ", at_x - kDot / 2, at_y, kDot);
    }
    drawing = visible(i);
  }
  return path;
}

/// The discs of a moving cursor, and its line between the edges of a panel.
std::string cursor_svg(const PlotPanel& panel, const MovingCursor& cursor, const Axis& x,
                       const Axis& y, double upper, double lower) {
  const std::string clock = cursor.rounds.attributes();
  const double from = x.px(cursor.from);
  const double to = x.px(cursor.to);
  const double start = std::lerp(from, to, cursor.rounds.start);
  std::string svg = fmt::format(
      "<g transform=\"translate({0:.2f} 0)\"><line x1=\"0\" y1=\"{1:.1f}\" x2=\"0\" "
      "y2=\"{2:.1f}\" class=\"axis\"/><animateTransform attributeName=\"transform\" "
      "type=\"translate\" from=\"{3:.2f} 0\" to=\"{4:.2f} 0\" {5}/></g>\n",
      start, upper, lower, from, to, clock);
  for (std::size_t n = 0; n < panel.series.size(); ++n) {
    const PlotSeries& series = panel.series[n];
    const std::size_t count = std::min(series.x.size(), series.y.size());
    bool whole = count > 1;
    for (std::size_t i = 0; i < count; ++i)
      whole = whole && drawable(panel.x_scale, series.x[i]) &&
              drawable(panel.y_scale, series.y[i]) && (i == 0 || series.x[i] > series.x[i - 1]);
    if (!whole || series.x.front() != cursor.from || series.x[count - 1] != cursor.to) continue;
    std::string heights;
    std::string times;
    double at_start = y.px(series.y.front());
    for (std::size_t i = 0; i < count; ++i) {
      const double height = y.px(series.y[i]);
      const double time = (x.px(series.x[i]) - from) / (to - from);
      const double before = i == 0 ? 0.0 : (x.px(series.x[i - 1]) - from) / (to - from);
      if (i > 0 && before <= cursor.rounds.start && cursor.rounds.start <= time)
        at_start = std::lerp(y.px(series.y[i - 1]), height,
                             (cursor.rounds.start - before) / (time - before));
      heights += fmt::format("{}{:.1f}", i == 0 ? "" : ";", height);
      times += fmt::format("{}{:.5g}", i == 0 ? "" : ";", i + 1 == count ? 1.0 : time);
    }
    svg += fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\">"
        "<animate attributeName=\"cx\" from=\"{:.2f}\" to=\"{:.2f}\" {}/>"
        "<animate attributeName=\"cy\" values=\"{}\" keyTimes=\"{}\" {}/></circle>\n",
        start, at_start, line_colour(n), from, to, clock, heights, times, clock);
  }
  return svg;
}

/// Draws one panel with its upper edge at `top`.
/// @param cursor  null: there is none
std::string panel_svg(const PlotPanel& panel, double top, const MovingCursor* cursor = nullptr) {
  ValueRange x_values;
  ValueRange y_values;
  for (const PlotSeries& series : panel.series)
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (!drawable(panel.x_scale, series.x[i]) || !drawable(panel.y_scale, series.y[i])) continue;
      x_values.include(series.x[i]);
      y_values.include(series.y[i]);
    }
  const double left = kLeft;
  const double right = kPlotWidth - kRight;
  const double upper = top + kTop;
  const double lower = top + kPanelHeight - kBottom;
  const Axis x(x_values, panel.x_scale, left, right, panel.x_label);
  const Axis y(y_values, panel.y_scale, lower, upper);

  constexpr std::size_t kTitleLength = 76;
  constexpr std::size_t kSubtitleLength = 110;
  std::string svg = words(left, top + 28, "title", shortened(panel.title, kTitleLength));
  if (!panel.subtitle.empty())
    svg += words(left, top + 46, "small", shortened(panel.subtitle, kSubtitleLength));
  for (const Tick& tick : x.ticks()) {
    const double at = x.px(tick.value);
    svg += line(at, upper, at, lower, tick.label.empty() ? "minor" : "grid");
    if (!tick.label.empty()) svg += words(at, lower + 18, "tick middle", tick.label);
  }
  for (const Tick& tick : y.ticks()) {
    const double at = y.px(tick.value);
    svg += line(left, at, right, at, tick.label.empty() ? "minor" : "grid");
    if (!tick.label.empty()) svg += words(left - 8, at + 4, "tick end", tick.label);
  }
  svg += line(left, lower, right, lower, "axis") + line(left, upper, left, lower, "axis");
  if (!x.factor().empty()) svg += words(right, lower + 42, "tick end", x.factor());
  if (!y.factor().empty()) svg += words(left - 8, upper - 10, "tick end", y.factor());
  svg += words((left + right) / 2, lower + 42, "label middle", panel.x_label);
  const double middle = (upper + lower) / 2;
  svg += words(16, middle, "label middle", panel.y_label,
               fmt::format(" transform=\"rotate(-90 16 {:.1f})\"", middle));

  double label_y = upper + 12;
  if (!panel.legend_title.empty())
    svg += margin_words(right + 14, label_y, "small", panel.legend_title, kMostOfTitle);
  for (std::size_t n = 0; n < panel.series.size(); ++n) {
    const PlotSeries& series = panel.series[n];
    const std::string_view colour = line_colour(n);
    const std::string dashes = line_dashes(n);
    // The first line is the widest, so a line on top of it does not hide it.
    const std::string style = fmt::format(
        "stroke=\"{}\" stroke-width=\"{}\"{}", colour, n == 0 ? 4 : 2,
        dashes.empty() ? std::string() : fmt::format(" stroke-dasharray=\"{}\"", dashes));
    svg += fmt::format("<path d=\"{}\" class=\"series\" {}/>\n", path_data(panel, series, x, y),
                       style);
    const std::size_t n_points = std::min(series.x.size(), series.y.size());
    if (series.discs == Discs::at_end && n_points > 0 &&
        drawable(panel.x_scale, series.x[n_points - 1]) &&
        drawable(panel.y_scale, series.y[n_points - 1]))
      svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"{}\"/>\n",
                         x.px(series.x[n_points - 1]), y.px(series.y[n_points - 1]), colour);
    svg += fmt::format("<path d=\"M{:.1f},{:.1f} h26\" class=\"series\" {}/>\n", right + 14,
                       label_y - 4, style);
    svg += margin_words(right + 46, label_y, "tick", series.label, kMostOfLine);
  }
  if (cursor != nullptr) svg += cursor_svg(panel, *cursor, x, y, upper, lower);
  return svg;
}

constexpr double kBarHeight = 12;
constexpr double kBarLabels = 330;  // room for the paths

double row_height(const TornadoPanel& panel) {
  return kBarHeight * static_cast<double>(panel.series.size()) + 8;
}

double tornado_height(const TornadoPanel& panel) {
  return kTop + row_height(panel) * static_cast<double>(panel.labels.size()) + kBottom;
}

/// Draws one panel of bars with its upper edge at `top`.
std::string tornado_panel_svg(const TornadoPanel& panel, double top) {
  constexpr double kEnds = 64;  // room for the numbers at the ends of the bars
  const double left = kBarLabels;
  const double right = kPlotWidth - 30;
  const double upper = top + kTop;
  const double lower = top + tornado_height(panel) - kBottom;
  ValueRange values{0.0, 0.0};
  for (const TornadoSeries& series : panel.series)
    for (const double value : series.values)
      if (std::isfinite(value)) values.include(value);
  const Axis x(values, AxisScale::linear, left + kEnds, right - kEnds);

  constexpr std::size_t kTitleLength = 88;
  std::string svg = words(16, top + 28, "title", shortened(panel.title, kTitleLength));
  double legend = 16;
  if (!panel.subtitle.empty()) {
    svg += words(legend, top + 46, "small", panel.subtitle);
    legend += 160;
  }
  for (std::size_t n = 0; n < panel.series.size(); ++n) {
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"9\" fill=\"{}\"/>\n",
                       legend, top + 38, bar_colour(n));
    svg += words(legend + 20, top + 46, "small", panel.series[n].label);
    legend += 120;
  }
  for (const Tick& tick : x.ticks()) {
    svg += line(x.px(tick.value), upper, x.px(tick.value), lower, "grid");
    svg += words(x.px(tick.value), lower + 18, "tick middle", tick.label);
  }
  for (std::size_t i = 0; i < panel.labels.size(); ++i) {
    const double row_top = upper + row_height(panel) * static_cast<double>(i) + 4;
    svg += words(left - 8, row_top + (row_height(panel) - 8) / 2 + 4, "small end",
                 shortened(panel.labels[i], 50));
    for (std::size_t n = 0; n < panel.series.size(); ++n) {
      const double value = panel.series[n].values[i];
      if (!std::isfinite(value)) continue;
      const double bar_top = row_top + kBarHeight * static_cast<double>(n);
      const double from = std::min(x.px(0.0), x.px(value));
      const double to = std::max(x.px(0.0), x.px(value));
      svg += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
          "fill=\"{}\"/>\n",
          from, bar_top + 0.5, to - from, kBarHeight - 1, bar_colour(n));
      svg += words(value < 0 ? from - 5 : to + 5, bar_top + kBarHeight / 2 + 4,
                   value < 0 ? "small end" : "small",
                   (value < 0 ? "−" : "+") + fmt::format("{:.3g}", std::abs(value)));
    }
  }
  svg += line(left, lower, right, lower, "axis") + line(x.px(0.0), upper, x.px(0.0), lower, "axis");
  if (!x.factor().empty()) svg += words(right, lower + 18, "tick end", x.factor());
  return svg + words((left + right) / 2, lower + 42, "label middle", panel.x_label);
}

/// Title and description for readers who cannot see the panels.
struct Spoken {
  std::string title;
  std::string description;
};

Spoken spoken(std::span<const PlotPanel> panels) {
  Spoken text;
  for (const PlotPanel& panel : panels) {
    if (text.title.empty()) text.title = panel.title;
    std::string lines;
    for (const PlotSeries& series : panel.series)
      if (!series.label.empty()) lines += (lines.empty() ? "" : ", ") + series.label;
    text.description +=
        fmt::format("{}{}: {} over {}{}{}.", text.description.empty() ? "" : " ", panel.title,
                    panel.y_label, panel.x_label, lines.empty() ? "" : "; lines: ", lines);
  }
  return text;
}

Spoken spoken(std::span<const TornadoPanel> panels) {
  Spoken text;
  for (const TornadoPanel& panel : panels) {
    if (text.title.empty()) text.title = panel.title;
    text.description += fmt::format(
        "{}{}: bars of {}, the first for {}.", text.description.empty() ? "" : " ", panel.title,
        panel.x_label, panel.labels.empty() ? std::string("nothing") : panel.labels.front());
  }
  return text;
}

Spoken spoken(std::span<const ContourPanel> panels) {
  Spoken text{.title = {}, .description = "Lines of equal value."};
  for (const ContourPanel& panel : panels) {
    text.title += (text.title.empty() ? "" : "; ") + panel.title;
    text.description +=
        fmt::format(" {} over {} and {}.", panel.value_label, panel.x_label, panel.y_label);
  }
  return text;
}

constexpr std::string_view kStyle =
    "<style>\n"
    "text { font-family: 'DejaVu Sans', Arial, sans-serif; fill: #222 }\n"
    ".title { font-size: 15px; font-weight: bold }\n"
    ".label { font-size: 13px }\n"
    ".tick { font-size: 12px }\n"
    ".small { font-size: 11px; fill: #555 }\n"
    ".middle { text-anchor: middle }\n"
    ".end { text-anchor: end }\n"
    ".grid { stroke: #ddd }\n"
    ".minor { stroke: #eee }\n"
    ".axis { stroke: #222 }\n"
    ".series { fill: none; stroke-linejoin: round }\n"
    "</style>\n";

/// Begins a document of one height, to which panels are added.
/// @param numbers  of the panels, as chart_numbers writes them
std::string svg_head(double height, const Spoken& text, const std::string& numbers) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" role=\"img\">\n"
      "<title>{2}</title>\n<desc>{3}</desc>\n<metadata class=\"numbers\">{4}</metadata>\n"
      "{5}"
      "<rect width=\"{0:g}\" height=\"{1:g}\" class=\"ground\" fill=\"white\"/>\n",
      kPlotWidth, height, svg_text(text.title), svg_text(text.description), svg_text(numbers),
      kStyle);
}

/// A number at a point of the grid's axis, between its neighbours on the scale of the axis.
double between(const std::vector<double>& values, double at, AxisScale scale) {
  const auto first = std::min(static_cast<std::size_t>(at), values.size() - 1);
  const std::size_t second = std::min(first + 1, values.size() - 1);
  const double share = at - static_cast<double>(first);
  if (scale == AxisScale::logarithmic)
    return values[first] * std::pow(values[second] / values[first], share);
  return values[first] + share * (values[second] - values[first]);
}

/// Ticks of both axes, their labels and the grid of a panel.
std::string frame_svg(const Axis& x, const Axis& y, const ContourPanel& panel, double left,
                      double right, double upper, double lower) {
  std::string svg;
  for (const Tick& tick : x.ticks()) {
    svg += line(x.px(tick.value), upper, x.px(tick.value), lower,
                tick.label.empty() ? "minor" : "grid");
    if (!tick.label.empty()) svg += words(x.px(tick.value), lower + 18, "tick middle", tick.label);
  }
  for (const Tick& tick : y.ticks()) {
    svg += line(left, y.px(tick.value), right, y.px(tick.value),
                tick.label.empty() ? "minor" : "grid");
    if (!tick.label.empty()) svg += words(left - 8, y.px(tick.value) + 4, "tick end", tick.label);
  }
  svg += line(left, lower, right, lower, "axis") + line(left, upper, left, lower, "axis");
  if (!x.factor().empty()) svg += words(right, lower + 42, "tick end", x.factor());
  if (!y.factor().empty()) svg += words(left - 8, upper - 10, "tick end", y.factor());
  svg += words((left + right) / 2, lower + 42, "label middle", panel.x_label);
  const double middle = (upper + lower) / 2;
  return svg + words(16, middle, "label middle", panel.y_label,
                     fmt::format(" transform=\"rotate(-90 16 {:.1f})\"", middle));
}

ValueRange range_of(const std::vector<double>& values, AxisScale scale) {
  ValueRange range;
  for (const double value : values)
    if (drawable(scale, value)) range.include(value);
  return range;
}

struct Pixel {
  double x = 0.0;
  double y = 0.0;
};
using Pixels = std::vector<Pixel>;

struct Box {
  double left = 0.0;
  double right = 0.0;
  double upper = 0.0;
  double lower = 0.0;

  [[nodiscard]] bool holds(const Pixel& p) const {
    return p.x >= left && p.x <= right && p.y >= upper && p.y <= lower;
  }
  [[nodiscard]] bool holds(const Box& b) const {
    return holds(Pixel{b.left, b.upper}) && holds(Pixel{b.right, b.lower});
  }
  [[nodiscard]] bool overlaps(const Box& b) const {
    return left < b.right && b.left < right && upper < b.lower && b.upper < lower;
  }
};

/// The lines of one level and their label.
struct ContourLevel {
  std::string label;
  std::vector<Pixels> lines = {};
};

/// The points of a line in steps of at most `step` px.
Pixels divided(const Pixels& line, double step) {
  Pixels points;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = line[i + 1].x - line[i].x;
    const double dy = line[i + 1].y - line[i].y;
    const int n = std::max(1, static_cast<int>(std::ceil(std::hypot(dx, dy) / step)));
    for (int k = 0; k < n; ++k) points.push_back({line[i].x + dx * k / n, line[i].y + dy * k / n});
  }
  if (!line.empty()) points.push_back(line.back());
  return points;
}

/// The labels of the lines, drawn above all lines.  A label lies inside the frame, apart from other
/// labels and from other lines.  It prefers a place where its line is flat, near the middle of the
/// line.  A line without room for a label gets none, because the margin lists all levels.
std::string level_labels(const std::vector<ContourLevel>& levels, const Box& frame) {
  constexpr double kStep = 4;
  constexpr double kCharacter = 7.6;  // width in a tick label, with the halo [px]
  constexpr double kHeight = 16;
  std::vector<std::vector<Pixels>> lines;
  for (const ContourLevel& level : levels) {
    auto& divided_lines = lines.emplace_back();
    for (const Pixels& one : level.lines) divided_lines.push_back(divided(one, kStep));
  }
  std::vector<Box> taken;
  std::string svg;
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const double half = (kCharacter * static_cast<double>(shown_length(levels[n].label)) + 4) / 2;
    for (const Pixels& line : lines[n]) {
      std::optional<Box> best;
      double least = std::numeric_limits<double>::infinity();
      // A label must not hide a short line.
      if (kStep * static_cast<double>(line.size()) < 3 * half) continue;
      for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Pixel& at = line[i];
        const Box box{at.x - half, at.x + half, at.y - kHeight / 2, at.y + kHeight / 2};
        if (!frame.holds(box) ||
            std::ranges::any_of(taken, [&](const Box& other) { return other.overlaps(box); }))
          continue;
        const bool crosses = std::ranges::any_of(lines, [&](const std::vector<Pixels>& of_level) {
          return std::ranges::any_of(of_level, [&](const Pixels& other) {
            return &other != &line &&
                   std::ranges::any_of(other, [&](const Pixel& p) { return box.holds(p); });
          });
        });
        if (crosses) continue;
        const double dx = line[i + 1].x - line[i - 1].x;
        const double dy = line[i + 1].y - line[i - 1].y;
        const double steep = std::abs(dy) / std::max(std::hypot(dx, dy), 1e-9);
        const double off_middle =
            std::abs(2 * static_cast<double>(i) / static_cast<double>(line.size()) - 1);
        const double cost = steep + 0.5 * off_middle;
        if (cost >= least) continue;
        least = cost;
        best = box;
      }
      if (!best) continue;
      taken.push_back(*best);
      svg += words((best->left + best->right) / 2, (best->upper + best->lower) / 2 + 4,
                   "tick middle halo", levels[n].label);
    }
  }
  return svg;
}

/// Draws one panel of contour lines with its upper edge at `top`.
/// Levels of equal value and their labels: the ticks of an axis are round numbers, and those inside
/// are levels.
Axis level_axis(const ValueRange& values) {
  constexpr int kLevels = 10;
  return {values, AxisScale::linear, 0.0, 1.0, {}, kLevels};
}

bool is_level(const Tick& tick, const ValueRange& values) {
  return tick.value > values.lower && tick.value < values.upper;
}

std::string colour_of(const Tick& tick, const ValueRange& values) {
  return level_colour((tick.value - values.lower) / (values.upper - values.lower));
}

/// The lines of a panel as its numbers state them.
ContourLines lines_of(const ContourPanel& panel) {
  ContourLines lines;
  const ValueRange values = range_of(panel.values, AxisScale::linear);
  if (values.empty() || values.lower == values.upper) return lines;
  const Axis axis = level_axis(values);
  for (const Tick& tick : axis.ticks())
    if (is_level(tick, values)) {
      lines.levels.push_back(tick.value);
      lines.colours.push_back(colour_of(tick, values));
    }
  return lines;
}

std::string contour_panel_svg(const ContourPanel& panel, double top) {
  const double left = kLeft;
  const double right = kPlotWidth - kRight;
  const double upper = top + kTop;
  const double lower = top + kPanelHeight - kBottom;
  const Axis x(range_of(panel.x, panel.x_scale), panel.x_scale, left, right, panel.x_label);
  const Axis y(range_of(panel.y, panel.y_scale), panel.y_scale, lower, upper);
  const ValueRange values = range_of(panel.values, AxisScale::linear);

  std::string svg = words(left, top + 28, "title", shortened(panel.title, 76));
  if (!panel.subtitle.empty())
    svg += words(left, top + 46, "small", shortened(panel.subtitle, 110));
  svg += frame_svg(x, y, panel, left, right, upper, lower);
  double label_y = upper + 12;
  svg += margin_words(right + 14, label_y, "small", panel.value_label, kMostOfTitle);
  if (values.empty() || values.lower == values.upper) {
    const std::string same =
        values.empty() ? "no value" : fmt::format("{:.6g} everywhere", values.lower);
    return svg + words(right + 14, label_y, "tick", same);
  }
  const Axis levels = level_axis(values);
  if (!levels.factor().empty()) {
    svg += words(right + 14, label_y, "tick", levels.factor());
    label_y += kLabelHeight;
  }
  std::vector<ContourLevel> drawn;
  for (auto tick = levels.ticks().rbegin(); tick != levels.ticks().rend(); ++tick) {
    if (!is_level(*tick, values)) continue;
    const std::string colour = colour_of(*tick, values);
    std::string path;
    ContourLevel& level = drawn.emplace_back(ContourLevel{.label = tick->label});
    for (const GridLine& one :
         contour_lines(panel.values, panel.x.size(), panel.y.size(), tick->value)) {
      Pixels& line_px = level.lines.emplace_back();
      for (const GridPoint& point : one)
        line_px.push_back({x.px(between(panel.x, point.i, panel.x_scale)),
                           y.px(between(panel.y, point.j, panel.y_scale))});
      for (std::size_t p = 0; p < line_px.size(); ++p)
        path += fmt::format("{}{:.2f},{:.2f} ", p == 0 ? "M" : "L", line_px[p].x, line_px[p].y);
    }
    svg += fmt::format("<path d=\"{}\" class=\"series\" stroke=\"{}\" stroke-width=\"2\"/>\n", path,
                       colour);
    svg += fmt::format(
        "<path d=\"M{:.1f},{:.1f} h26\" class=\"series\" stroke=\"{}\" "
        "stroke-width=\"2\"/>\n",
        right + 14, label_y - 4, colour);
    svg += words(right + 46, label_y, "tick", tick->label);
    label_y += kLabelHeight;
  }
  return svg + level_labels(drawn, {.left = left, .right = right, .upper = upper, .lower = lower});
}

}  // namespace

std::string svg_plot(std::span<const PlotPanel> panels) {
  std::string svg = svg_head(kPanelHeight * static_cast<double>(panels.size()), spoken(panels),
                             chart_numbers(panels));
  double top = 0.0;
  for (const PlotPanel& panel : panels) {
    svg += panel_svg(panel, top);
    top += kPanelHeight;
  }
  return svg + "</svg>\n";
}

std::string Rounds::attributes(double later) const {
  return fmt::format("begin=\"{:.4g}s\" dur=\"{:g}s\" repeatCount=\"indefinite\"",
                     (later - start - 1) * seconds, seconds);
}

double panel_height(double width) { return kPanelHeight / kPlotWidth * width; }

std::string moving_plot(const PlotPanel& panel, const MovingCursor& cursor,
                        const PlotPlace& place) {
  const std::span<const PlotPanel> one(&panel, 1);
  return fmt::format(
             "<svg x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" "
             "viewBox=\"0 0 {:g} {:g}\">\n<desc>{}</desc>\n"
             "<metadata class=\"numbers\">{}</metadata>\n{}",
             place.x, place.y, place.width, panel_height(place.width), kPlotWidth, kPanelHeight,
             svg_text(spoken(one).description), svg_text(chart_numbers(one)), kStyle) +
         panel_svg(panel, 0, &cursor) + "</svg>\n";
}

std::string tornado_svg(std::span<const TornadoPanel> panels) {
  double height = 0.0;
  for (const TornadoPanel& panel : panels) height += tornado_height(panel);
  std::string svg = svg_head(height, spoken(panels), chart_numbers(panels));
  double top = 0.0;
  for (const TornadoPanel& panel : panels) {
    svg += tornado_panel_svg(panel, top);
    top += tornado_height(panel);
  }
  return svg + "</svg>\n";
}

std::string contour_svg(std::span<const ContourPanel> panels) {
  std::vector<ContourLines> lines;
  for (const ContourPanel& panel : panels) lines.push_back(lines_of(panel));
  std::string svg = svg_head(kPanelHeight * static_cast<double>(panels.size()), spoken(panels),
                             chart_numbers(panels, lines));
  svg += "<style>.halo { paint-order: stroke; stroke: white; stroke-width: 4px }</style>\n";
  double top = 0.0;
  for (const ContourPanel& panel : panels) {
    svg += contour_panel_svg(panel, top);
    top += kPanelHeight;
  }
  return svg + "</svg>\n";
}

}  // namespace strainwave

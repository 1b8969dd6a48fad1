// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "display_unit.hpp"

namespace strainwave {
namespace {

// Lengths in px of the SVG's own coordinates.
constexpr double kWidth = 860;
constexpr double kPanelHeight = 380;
constexpr double kLeft = 92;
constexpr double kRight = 200;  // room for the labels of the lines
constexpr double kTop = 46;
constexpr double kBottom = 58;
constexpr double kLabelHeight = 18;

// Okabe and Ito's palette, without its yellow, which is too pale for lines on white.
struct Stroke {
  std::string_view colour;
  std::string_view dashes;
};
constexpr std::array<Stroke, 7> kStrokes = {{{"#000000", ""},
                                             {"#D55E00", ""},
                                             {"#0072B2", "7 4"},
                                             {"#009E73", "2 3"},
                                             {"#CC79A7", "9 3 2 3"},
                                             {"#E69F00", "12 4"},
                                             {"#56B4E9", "4 2"}}};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

struct Interval {
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

/// One axis: which values it shows, where it puts them, and its ticks.
class Axis {
 public:
  Axis(Interval values, AxisScale scale, double from_px, double to_px)
      : scale_(scale), from_px_(from_px), to_px_(to_px) {
    if (values.empty()) values = {scale == AxisScale::linear ? 0.0 : 1.0, 1.0};
    if (scale == AxisScale::linear) {
      if (values.lower == values.upper) {
        const double margin = values.lower == 0 ? 1.0 : std::abs(values.lower) * 0.05;
        values = {values.lower - margin, values.upper + margin};
      }
      place_linear_ticks(values);
    } else {
      if (values.lower == values.upper) values = {values.lower / 2, values.upper * 2};
      place_decades(values);
    }
  }

  [[nodiscard]] bool shows(double value) const {
    return std::isfinite(value) && (scale_ == AxisScale::linear || value > 0);
  }
  [[nodiscard]] double px(double value) const {
    return from_px_ + (to_px_ - from_px_) * (position(value) - lower_) / (upper_ - lower_);
  }
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  [[nodiscard]] double position(double value) const {
    return scale_ == AxisScale::linear ? value : std::log10(value);
  }

  /// Steps of 1, 2 or 5 times a power of ten, about six of them; the axis ends at ticks.
  void place_linear_ticks(const Interval& values) {
    const double raw = (values.upper - values.lower) / 6;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * decade;
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor * decade >= raw * (1 - 1e-9)) {
        step = factor * decade;
        break;
      }
    }
    const double first = std::floor(values.lower / step + 1e-9);
    const double last = std::ceil(values.upper / step - 1e-9);
    lower_ = first * step;
    upper_ = last * step;
    for (double i = first; i <= last; ++i) {
      const double value = i * step;
      ticks_.push_back({value, fmt::format("{:.6g}", std::abs(value) < step / 2 ? 0.0 : value)});
    }
  }

  /// Decades, with 2 and 5 between them where there are few.
  void place_decades(const Interval& values) {
    lower_ = std::floor(std::log10(values.lower) + 1e-9);
    upper_ = std::ceil(std::log10(values.upper) - 1e-9);
    const bool few = upper_ - lower_ <= 2;
    const int every = static_cast<int>(std::ceil((upper_ - lower_) / 8));
    for (int decade = static_cast<int>(lower_); decade <= static_cast<int>(upper_); ++decade)
      for (int digit = 1; digit < 10; ++digit) {
        if (digit > 1 && decade == static_cast<int>(upper_)) break;
        const double value = digit * std::pow(10.0, decade);
        const bool labelled =
            (digit == 1 && (decade - static_cast<int>(lower_)) % std::max(every, 1) == 0) ||
            (few && (digit == 2 || digit == 5));
        ticks_.push_back({value, labelled ? fmt::format("{:g}", value) : std::string()});
      }
  }

  AxisScale scale_;
  double from_px_, to_px_;
  double lower_ = 0.0, upper_ = 1.0;
  std::vector<Tick> ticks_;
};

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x1, y1, x2,
      y2, style);
}

std::string words(double x, double y, std::string_view style, std::string_view text,
                  std::string_view more = {}) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\"{}>{}</text>\n", x, y, style,
                     more, escaped(text));
}

/// Draws one panel with its upper edge at `top`.
std::string panel_svg(const PlotPanel& panel, double top) {
  Interval x_values;
  Interval y_values;
  const auto drawable = [](AxisScale scale, double value) {
    return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
  };
  for (const PlotSeries& series : panel.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!drawable(panel.x_scale, series.x[i]) || !drawable(panel.y_scale, series.y[i])) continue;
      x_values.include(series.x[i]);
      y_values.include(series.y[i]);
    }
  const double left = kLeft;
  const double right = kWidth - kRight;
  const double upper = top + kTop;
  const double lower = top + kPanelHeight - kBottom;
  const Axis x(x_values, panel.x_scale, left, right);
  const Axis y(y_values, panel.y_scale, lower, upper);

  std::string svg = words(left, top + 28, "title", panel.title);
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
  svg += words((left + right) / 2, lower + 42, "label middle", panel.x_label);
  const double middle = (upper + lower) / 2;
  svg += words(22, middle, "label middle", panel.y_label,
               fmt::format(" transform=\"rotate(-90 22 {:.1f})\"", middle));

  double label_y = upper + 12;
  if (!panel.legend_title.empty()) {
    svg += words(right + 14, label_y, "small", panel.legend_title);
    label_y += kLabelHeight;
  }
  for (std::size_t n = 0; n < panel.series.size(); ++n) {
    const PlotSeries& series = panel.series[n];
    const Stroke& stroke = kStrokes[n % kStrokes.size()];
    // The first line is the widest: another that lies on it does not hide it.
    const std::string style =
        fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", stroke.colour, n == 0 ? 4 : 2,
                    stroke.dashes.empty() ? std::string()
                                          : fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes));
    std::string path;
    bool drawing = false;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!x.shows(series.x[i]) || !y.shows(series.y[i])) {
        drawing = false;
        continue;
      }
      path += fmt::format("{}{:.2f},{:.2f} ", drawing ? "L" : "M", x.px(series.x[i]),
                          y.px(series.y[i]));
      drawing = true;
    }
    svg += fmt::format("<path d=\"{}\" class=\"series\" {}/>\n", path, style);
    svg += fmt::format("<path d=\"M{:.1f},{:.1f} h26\" class=\"series\" {}/>\n", right + 14,
                       label_y - 4, style);
    svg += words(right + 46, label_y, "tick", series.label);
    label_y += kLabelHeight;
  }
  return svg;
}

// --- The picture of a sweep -------------------------------------------------------------------

/// A column of a sweep in display units; NaN where a point has no such output.
class SweepTable {
 public:
  explicit SweepTable(const SweepResult& result) : result_(result) {}

  [[nodiscard]] std::vector<double> output(std::string_view name) const {
    const auto found = std::ranges::find(result_.outputs, name, &SweepColumn::name);
    const DisplayUnit unit =
        display_unit(name, found == result_.outputs.end() ? std::string_view("1") : found->unit);
    const auto column = static_cast<std::size_t>(found - result_.outputs.begin());
    std::vector<double> values;
    for (const SweepRow& row : result_.rows) {
      const bool known = column < row.outputs.size() && row.outputs[column] && row.usable();
      values.push_back(known ? row.outputs[column]->value / unit.in_si
                             : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
  }

  [[nodiscard]] std::vector<double> input(std::size_t which) const {
    const DisplayUnit unit = shown(which);
    std::vector<double> values;
    for (const SweepRow& row : result_.rows) values.push_back(row.inputs[which] / unit.in_si);
    return values;
  }

  [[nodiscard]] DisplayUnit shown(std::size_t which) const {
    return display_unit(result_.inputs[which].name, result_.inputs[which].unit);
  }

  [[nodiscard]] std::string axis_label(std::size_t which) const {
    const std::string_view unit = shown(which).typeset;
    return unit == "1" ? result_.inputs[which].name
                       : fmt::format("{} [{}]", result_.inputs[which].name, unit);
  }

 private:
  const SweepResult& result_;
};

AxisScale scale_of(const Variation& variation) {
  return variation.spacing == Spacing::logarithmic && variation.from > 0 ? AxisScale::logarithmic
                                                                         : AxisScale::linear;
}

/// 100 (cracked - intact)/total cracked compliance of one member, under positive torque.
std::vector<double> loss_by_member(const SweepTable& table, const std::string& member) {
  const std::vector<double> cracked = table.output("cracked.positive.compliance." + member);
  const std::vector<double> intact = table.output("intact.compliance." + member);
  const std::vector<double> total = table.output("cracked.positive.compliance.total");
  std::vector<double> loss;
  for (std::size_t i = 0; i < cracked.size(); ++i)
    loss.push_back(100 * (cracked[i] - intact[i]) / total[i]);
  return loss;
}

std::vector<PlotPanel> panels_over_one(const SweepResult& result, const GearSet& gear) {
  const SweepTable table(result);
  const std::vector<double> x = table.input(0);
  const auto negated = [](std::vector<double> values) {
    for (double& value : values) value = -value;
    return values;
  };
  PlotPanel stiffness{
      .title = gear.name.empty() ? "Torsional stiffness" : gear.name,
      .x_label = table.axis_label(0),
      .y_label = "stiffness K at the output [N·m/arcmin]",
      .x_scale = scale_of(result.variations[0]),
      .series = {{"sound", x, table.output("intact.stiffness")},
                 {"cracked, T > 0", x, table.output("cracked.positive.stiffness")},
                 {"cracked, T < 0", x, table.output("cracked.negative.stiffness")}}};
  PlotPanel loss{
      .title = fmt::format("Loss of stiffness by cracks, method {}", enum_name(result.method)),
      .x_label = table.axis_label(0),
      .y_label = "loss of stiffness [%]",
      .x_scale = scale_of(result.variations[0]),
      .y_scale = AxisScale::logarithmic,
      .series = {{"total, T > 0", x, negated(table.output("cracked.positive.stiffness_change"))}}};
  const auto add_member = [&](bool cracked, const char* label, const char* name) {
    if (cracked) loss.series.push_back({label, x, loss_by_member(table, name)});
  };
  add_member(gear.output_shaft && !gear.output_shaft->crack.empty(), "output shaft",
             "output_shaft");
  add_member(gear.flexspline && !gear.flexspline->crack.empty(), "flexspline", "flexspline");
  add_member(gear.wave_generator && !gear.wave_generator->crack.empty(), "wave generator",
             "wave_generator");
  return {std::move(stiffness), std::move(loss)};
}

std::vector<PlotPanel> panels_over_two(const SweepResult& result, const GearSet& gear) {
  constexpr int kMostLines = 7;  // as many as there are strokes
  const SweepTable table(result);
  const std::vector<double> x = table.input(0);
  const std::vector<double> y = table.output("cracked.positive.stiffness_change");
  const auto n_lines = static_cast<std::size_t>(result.variations[1].n_points);
  const DisplayUnit unit = table.shown(1);
  PlotPanel panel{.title = gear.name.empty() ? "Change of stiffness" : gear.name,
                  .x_label = table.axis_label(0),
                  .y_label = "change of stiffness, T > 0 [%]",
                  .x_scale = scale_of(result.variations[0])};
  const std::size_t every = (n_lines + kMostLines - 1) / kMostLines;
  for (std::size_t line = 0; line < n_lines; line += every) {
    PlotSeries series{.label = fmt::format("{:.4g}{}{}", table.input(1)[line],
                                           unit.typeset == "1" ? "" : " ",
                                           unit.typeset == "1" ? "" : unit.typeset)};
    for (std::size_t i = line; i < x.size(); i += n_lines) {
      series.x.push_back(x[i]);
      series.y.push_back(y[i]);
    }
    panel.series.push_back(std::move(series));
  }
  panel.legend_title = result.inputs[1].name;
  return {std::move(panel)};
}

}  // namespace

std::string svg_plot(std::span<const PlotPanel> panels) {
  const double height = kPanelHeight * static_cast<double>(panels.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\">\n"
      "<style>\n"
      "text {{ font-family: 'DejaVu Sans', Arial, sans-serif; fill: #222 }}\n"
      ".title {{ font-size: 15px; font-weight: bold }}\n"
      ".label {{ font-size: 13px }}\n"
      ".tick {{ font-size: 12px }}\n"
      ".small {{ font-size: 11px }}\n"
      ".middle {{ text-anchor: middle }}\n"
      ".end {{ text-anchor: end }}\n"
      ".grid {{ stroke: #ddd }}\n"
      ".minor {{ stroke: #f2f2f2 }}\n"
      ".axis {{ stroke: #222 }}\n"
      ".series {{ fill: none; stroke-linejoin: round }}\n"
      "</style>\n"
      "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n",
      kWidth, height);
  double top = 0.0;
  for (const PlotPanel& panel : panels) {
    svg += panel_svg(panel, top);
    top += kPanelHeight;
  }
  return svg + "</svg>\n";
}

std::string sweep_plot(const SweepResult& result, const GearSet& gear) {
  return svg_plot(result.variations.size() == 1 ? panels_over_one(result, gear)
                                                : panels_over_two(result, gear));
}

}  // namespace strainwave

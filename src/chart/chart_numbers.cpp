// SPDX-License-Identifier: Apache-2.0
#include "chart_numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "line_styles.hpp"

namespace strainwave {
namespace {

std::string json_text(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      json += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      json += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      json += c;
  }
  return json + '"';
}

/// A list of what `one` makes of each value.
template <class Values, class One>
std::string json_list(const Values& values, const One& one) {
  std::string json = "[";
  for (const auto& value : values) json += (json.size() > 1 ? "," : "") + one(value);
  return json + "]";
}

/// Five digits, more than a reader sees in the chart.
std::string json_numbers(std::span<const double> values) {
  return json_list(values, [](double value) {
    return std::isfinite(value) ? fmt::format("{:.5g}", value) : std::string("null");
  });
}

std::string_view scale_word(AxisScale scale) {
  return scale == AxisScale::linear ? "linear" : "log";
}

/// The members that all panels have.
template <class Panel>
std::string begin_panel(std::string_view kind, const Panel& panel) {
  return fmt::format(R"({{"kind":"{}","title":{},"subtitle":{},"x_label":{})", kind,
                     json_text(panel.title), json_text(panel.subtitle), json_text(panel.x_label));
}

template <class Panel>
std::string axes(const Panel& panel) {
  return fmt::format(R"(,"y_label":{},"x_scale":"{}","y_scale":"{}")", json_text(panel.y_label),
                     scale_word(panel.x_scale), scale_word(panel.y_scale));
}

std::string json_of_panels(const std::string& list) { return R"({"panels":)" + list + "}"; }

}  // namespace

std::string chart_numbers(std::span<const PlotPanel> panels) {
  return json_of_panels(json_list(panels, [](const PlotPanel& panel) {
    std::size_t n = 0;
    const std::string series = json_list(panel.series, [&](const PlotSeries& one) {
      std::string json =
          fmt::format(R"({{"label":{},"colour":"{}","dashes":"{}","end":{},"x":{},"y":{}}})",
                      json_text(one.label), line_colour(n), line_dashes(n),
                      one.discs == Discs::at_end, json_numbers(one.x), json_numbers(one.y));
      ++n;
      return json;
    });
    return begin_panel("lines", panel) + axes(panel) +
           fmt::format(R"(,"legend_title":{},"series":{}}})", json_text(panel.legend_title),
                       series);
  }));
}

std::string chart_numbers(std::span<const TornadoPanel> panels) {
  return json_of_panels(json_list(panels, [](const TornadoPanel& panel) {
    std::size_t n = 0;
    const std::string series = json_list(panel.series, [&](const TornadoSeries& one) {
      return fmt::format(R"({{"label":{},"colour":"{}","values":{}}})", json_text(one.label),
                         bar_colour(n++), json_numbers(one.values));
    });
    return begin_panel("bars", panel) +
           fmt::format(R"(,"labels":{},"series":{}}})", json_list(panel.labels, json_text), series);
  }));
}

std::string chart_numbers(std::span<const ContourPanel> panels,
                          std::span<const ContourLines> lines) {
  std::size_t n = 0;
  return json_of_panels(json_list(panels, [&](const ContourPanel& panel) {
    const ContourLines& drawn = lines[n++];
    return begin_panel("contours", panel) + axes(panel) +
           fmt::format(R"(,"value_label":{},"levels":{},"colours":{},"x":{},"y":{},"values":{}}})",
                       json_text(panel.value_label), json_numbers(drawn.levels),
                       json_list(drawn.colours, json_text), json_numbers(panel.x),
                       json_numbers(panel.y), json_numbers(panel.values));
  }));
}

}  // namespace strainwave

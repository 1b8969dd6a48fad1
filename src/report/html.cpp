// SPDX-License-Identifier: Apache-2.0
#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "markup.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave::report {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return value.empty() ? std::string() : fmt::format(" {}=\"{}\"", name, value);
}

/// Estimated widths of text in a chart [mm], wider than in most fonts.
constexpr double kWide = 1.95;    // width of a character
constexpr double kNarrow = 1.72;  // width of a small character

double characters(std::string_view text) {
  return static_cast<double>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Place at which a label that is too long is broken: after the last dot, comma or blank that
/// fits, such that the two lines are of similar length.
std::size_t break_of(std::string_view label) {
  std::size_t best = 0;
  for (std::size_t i = 1; i + 1 < label.size(); ++i) {
    const std::size_t end = label[i] == '.' ? i : i + 1;
    if (label[i] != '.' && label[i] != ' ') continue;
    const auto uneven = [&](std::size_t at) {
      return std::abs(2 * static_cast<double>(at) - static_cast<double>(label.size()));
    };
    if (best == 0 || uneven(end) < uneven(best)) best = end;
  }
  return best;
}

/// The bars in words, for a reader who does not see them.
std::string description_of(const BarChart& chart) {
  std::string text = chart.axis + ".";
  for (const Bar& bar : chart.bars)
    text += bar.same_line ? " and " + bar.text : fmt::format(" {}: {}", bar.label, bar.text);
  return text;
}

}  // namespace

std::string table(std::string_view caption, const std::vector<std::string>& head,
                  const std::vector<RowGroup>& groups, const TableLook& look) {
  const auto style = [&](std::size_t column) {
    return column >= look.numbers ? " class=\"number\"" : "";
  };
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n"
      "<table{1}>\n<caption>{0}</caption>\n<thead>\n<tr>",
      escaped(caption), attribute("class", look.style));
  for (std::size_t i = 0; i < head.size(); ++i)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", style(i), head[i]);
  html += "</tr>\n</thead>\n";
  for (const RowGroup& group : groups) {
    html += "<tbody>\n";
    if (!group.title.empty())
      html +=
          fmt::format("<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                      head.size(), escaped(group.title));
    for (const Row& row : group.rows) {
      html += fmt::format("<tr{}>", attribute("class", row.style));
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", row.cells[i])
                       : fmt::format("<td{}>{}</td>", style(i), row.cells[i]);
      html += "</tr>\n";
    }
    html += "</tbody>\n";
  }
  return html + "</table>\n</div>\n";
}

std::string table(const TitledTable& plain) {
  std::vector<std::string> head;
  for (const std::string& cell : plain.table.head) head.push_back(label(cell));
  std::vector<RowGroup> groups(1);
  for (const std::vector<std::string>& cells : plain.table.rows) {
    if (cells.size() == 1 && head.size() > 1) {
      groups.push_back({.title = cells[0], .rows = {}});
      continue;
    }
    Row row{{label(cells[0])}, {}};
    for (std::size_t i = 1; i < head.size(); ++i)
      row.cells.push_back(i < cells.size() ? typeset(escaped(cells[i])) : std::string());
    groups.back().rows.push_back(std::move(row));
  }
  std::erase_if(groups, [](const RowGroup& group) { return group.rows.empty(); });
  return table(plain.title, head, groups, {.style = "results", .numbers = 1}) +
         (plain.remark.empty() ? std::string() : paragraph(plain.remark, "remark"));
}

std::string quantity(std::string_view path, const Quantity& q, double unit_in_si) {
  return fmt::format(
      "<data value=\"{}\" data-path=\"{}\">{}</data>", q.value, path,
      q.value == 0
          ? "0"
          : typeset(warranted_digits({q.value / unit_in_si, q.unit, q.relative_uncertainty})));
}

std::string bar_chart(const BarChart& chart) {
  // Lengths are millimetres of paper, as in the drawings.
  constexpr double kWidth = 180;
  constexpr double kMostLabels = 66;
  constexpr double kRow = 6;
  double labels = 30;
  double texts = 12;
  for (const Bar& bar : chart.bars) {
    labels = std::max(labels, std::min(kMostLabels, 2 + kWide * characters(bar.label)));
    texts = std::max(texts, 3 + kWide * characters(bar.text));
  }
  constexpr double kTop = 8;
  double least = std::min(0.0, chart.reference.value_or(0.0));
  double most = std::max(0.0, chart.reference.value_or(0.0));
  for (const Bar& bar : chart.bars) {
    least = std::min({least, bar.from, bar.to});
    most = std::max({most, bar.from, bar.to});
  }
  if (!(most > least)) most = least + 1;
  const double left = labels + (least < 0 ? texts : 0);
  const double right = kWidth - texts;
  const auto x = [&](double value) {
    return left + (right - left) * (value - least) / (most - least);
  };
  std::string body;
  const auto words = [&](double at_x, double at_y, std::string_view style, std::string_view text) {
    body += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">{}</text>\n", coordinate(at_x),
                        coordinate(at_y), style, escaped(text));
  };
  double y = kTop;
  bool first = true;
  for (const Bar& bar : chart.bars) {
    if (!bar.same_line && !first) y += kRow;
    first = false;
    const double from = x(std::min(bar.from, bar.to));
    const double to = x(std::max(bar.from, bar.to));
    if (!bar.same_line) {
      const std::size_t cut =
          2 + kWide * characters(bar.label) > kMostLabels ? break_of(bar.label) : 0;
      if (cut == 0) {
        words(labels - 2, y + 3.3, "end", bar.label);
      } else {
        const std::string_view label = bar.label;
        words(labels - 2, y + 1.6, "small end", label.substr(0, cut));
        words(labels - 2, y + 4.3, "small end", label.substr(cut));
      }
    }
    body += fmt::format(
        "<rect class=\"bar{}\" data-from=\"{}\" data-to=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" "
        "height=\"4.2\"/>\n",
        bar.style.empty() ? "" : " " + bar.style, bar.from, bar.to, coordinate(from), coordinate(y),
        coordinate(to - from));
    if (bar.to < bar.from)
      words(from - 1.2, y + 3.3, "end", bar.text);
    else
      words(to + 1.2, y + 3.3, "", bar.text);
  }
  y += kRow;
  body += fmt::format("<path class=\"zero\" d=\"M{0} {1}V{2}\"/>\n", coordinate(x(0)),
                      coordinate(kTop - 1.5), coordinate(y));
  if (chart.reference) {
    body += fmt::format("<path class=\"reference\" d=\"M{0} {1}V{2}\"/>\n",
                        coordinate(x(*chart.reference)), coordinate(kTop - 1.5), coordinate(y));
    words(x(*chart.reference), kTop - 2.6, "small middle", chart.reference_label);
  }
  // Place the axis label in the middle of the bars, as far as the paper is wide enough.
  const double half = kNarrow * characters(chart.axis) / 2;
  words(std::max(half, std::min((left + right) / 2, kWidth - half)), y + 3.6, "small middle",
        chart.axis);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}mm\" height=\"{1}mm\" role=\"img\" aria-labelledby=\"{2}-title {2}-desc\">\n"
      "<title id=\"{2}-title\">{3}</title>\n<desc id=\"{2}-desc\">{4}</desc>\n{5}</svg>\n",
      coordinate(kWidth), coordinate(y + 6), chart.id, escaped(chart.title),
      escaped(description_of(chart)), body);
}

std::string figure(std::string_view svg, std::string_view caption, std::string_view style) {
  return fmt::format(
      "<figure class=\"{}\">\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"{}\">\n{}</div>\n<figcaption>{}</figcaption>\n</figure>\n",
      style, escaped(caption), svg, escaped(caption));
}

std::string plot_figure(const std::string& svg, std::string_view caption) {
  // Each rule of the style sheet has one line.  In a page, the rules would affect all other
  // pictures and the text.
  constexpr std::string_view kBegin = "<style>\n";
  constexpr std::string_view kEnd = "</style>";
  std::string confined;
  const std::size_t begin = svg.find(kBegin);
  const std::size_t end = svg.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) return figure(svg, caption, "plot");
  confined = svg.substr(0, begin + kBegin.size());
  std::string_view rules =
      std::string_view(svg).substr(begin + kBegin.size(), end - begin - kBegin.size());
  while (!rules.empty()) {
    const std::size_t line = std::min(rules.find('\n'), rules.size());
    if (line > 0) confined += ".plot " + std::string(rules.substr(0, line)) + '\n';
    rules.remove_prefix(std::min(line + 1, rules.size()));
  }
  confined += svg.substr(end);
  const std::size_t role = confined.find("role=\"img\"");
  if (role != std::string::npos)
    confined.insert(role, fmt::format("aria-label=\"{}\" ", escaped(caption)));
  return figure(confined, caption, "plot");
}

std::string figures(const std::vector<PlotPanel>& panels) {
  std::string html;
  for (const PlotPanel& panel : panels)
    html += plot_figure(svg_plot(std::span(&panel, 1)), panel.title + ".");
  return html;
}

std::string tables(const std::vector<TitledTable>& plain) {
  std::string html;
  for (const TitledTable& one : plain) html += table(one);
  return html;
}

std::string paragraph(std::string_view text, std::string_view style) {
  return fmt::format("<p{}>{}</p>\n", attribute("class", style), escaped(text));
}

}  // namespace strainwave::report

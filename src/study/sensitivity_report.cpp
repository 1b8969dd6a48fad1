// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sensitivity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "display_unit.hpp"
#include "report_cells.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/study/plot.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kPathWidth = 36;

/// Head of a column.
std::string_view short_name(std::string_view output) {
  if (output == "intact.stiffness") return "K sound";
  if (output == "cracked.positive.stiffness") return "K, T > 0";
  if (output == "cracked.negative.stiffness") return "K, T < 0";
  if (output == "cracked.positive.stiffness_loss") return "loss, T > 0";
  return "loss, T < 0";
}

bool is_loss(std::string_view output) { return output.ends_with("_loss"); }

std::string shown_value(double value, std::string_view path, std::string_view si) {
  const DisplayUnit unit = display_unit(path, si);
  return unit.text == "1" ? fmt::format("{:.5g}", value)
                          : fmt::format("{:.5g} {}", value / unit.in_si, unit.text);
}

std::string shown_output(const Quantity& value, std::string_view name) {
  if (is_loss(name)) return fmt::format("{:.4g} %", 100 * value.value);
  return fmt::format("{:.5g}", value.value / display_unit(name, value.unit).in_si);
}

/// A row of a table; a path that is too long for its column has a line of its own.
std::string row(std::string_view label, std::string_view value,
                const std::vector<std::string>& cells) {
  std::string text;
  if (label.size() > kPathWidth) {
    text += fmt::format("  {}\n", label);
    label = "";
  }
  text += fmt::format("  {:<36}{:>14}", label, value);
  for (const std::string& cell : cells) text += fmt::format("{:>12}", cell);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

template <class Range, class Cell>
std::vector<std::string> cells(const Range& range, const Cell& cell) {
  std::vector<std::string> result;
  for (const auto& element : range) result.push_back(cell(element));
  return result;
}

/// Columns of a table that do not fit beside each other go below: stiffness, then loss.
std::vector<std::vector<std::size_t>> column_groups(const Sensitivity& sensitivity) {
  std::vector<std::vector<std::size_t>> groups;
  for (const bool loss : {false, true}) {
    std::vector<std::size_t> group;
    for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y)
      if (is_loss(sensitivity.outputs[y].name) == loss) group.push_back(y);
    if (!group.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

double largest(const SensitivityInput& input, const std::vector<std::size_t>& outputs) {
  double most = 0.0;
  for (const std::size_t y : outputs)
    most = std::max(most, std::abs(input.influence[y].elasticity));
  return most;
}

std::string elasticities_text(const Sensitivity& sensitivity) {
  std::string text =
      "Elasticities: per cent that the output changes per per cent of the input (SN-1)\n";
  for (const std::vector<std::size_t>& group : column_groups(sensitivity)) {
    text += '\n' + row("", "", cells(group, [&](std::size_t y) {
                         return std::string(short_name(sensitivity.outputs[y].name));
                       }));
    text += row(is_loss(sensitivity.outputs[group[0]].name) ? "loss of stiffness"
                                                            : "stiffness [N*m/arcmin]",
                "", cells(group, [&](std::size_t y) {
                  return shown_output(sensitivity.outputs[y].value, sensitivity.outputs[y].name);
                }));
    std::vector<const SensitivityInput*> inputs;
    for (const SensitivityInput& input : sensitivity.inputs)
      if (largest(input, group) > 0) inputs.push_back(&input);
    std::ranges::stable_sort(inputs, [&](const auto* a, const auto* b) {
      return largest(*a, group) > largest(*b, group);
    });
    for (const SensitivityInput* const input : inputs)
      text += row(input->path, shown_value(input->value, input->path, input->unit),
                  cells(group, [&](std::size_t y) {
                    const double e = input->influence[y].elasticity;
                    return e == 0 ? std::string("0") : fmt::format("{:+.4g}", e);
                  }));
  }
  std::string zeros;
  for (const SensitivityInput& input : sensitivity.inputs) {
    if (input.value != 0) continue;
    for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y)
      zeros += fmt::format("  d {}/d {} = {:.5g} in SI units\n", sensitivity.outputs[y].name,
                           input.path, input.influence[y].derivative);
  }
  if (!zeros.empty())
    text += "\nInputs that are 0, which have a derivative but no elasticity\n" + zeros;
  if (!sensitivity.no_influence.empty())
    text += "\n" +
            wrapped(fmt::format("No influence: {}", fmt::join(sensitivity.no_influence, ", ")),
                    kTextWidth, 2) +
            '\n';
  text += fmt::format("\nDimensions hold to {:.1g}, at most {:.0g} is accepted (SN-6)\n",
                      sensitivity.homogeneity_residual(), kMaxHomogeneityResidual);
  return text;
}

std::string scatter_text(const Scatter& scatter, const Sensitivity& sensitivity) {
  std::string text = fmt::format(
      "\nScatter of the inputs: {} of {} draws evaluated, {} refused, {} not usable; seed {}\n",
      scatter.evaluated, scatter.samples, scatter.refused, scatter.unusable, scatter.seed);
  for (const std::vector<std::size_t>& group : column_groups(sensitivity)) {
    const auto line = [&](std::string_view label, const auto& cell) {
      text += row(label, "", cells(group, [&](std::size_t y) { return cell(scatter.outputs[y]); }));
    };
    text += '\n';
    line("", [](const ScatterOutput& o) { return std::string(short_name(o.name)); });
    line("relative deviation, first order",
         [](const ScatterOutput& o) { return percent(o.first_order); });
    line("relative deviation, Monte Carlo",
         [](const ScatterOutput& o) { return percent(o.relative_deviation); });
    line("  its standard error",
         [](const ScatterOutput& o) { return percent(o.relative_deviation_error); });
    const auto value = [](const ScatterOutput& o, double of) {
      return shown_output({of, o.unit}, o.name);
    };
    line("value in the file", [&](const ScatterOutput& o) { return value(o, o.value); });
    line("mean", [&](const ScatterOutput& o) { return value(o, o.mean); });
    line("5 %", [&](const ScatterOutput& o) { return value(o, o.low); });
    line("median", [&](const ScatterOutput& o) { return value(o, o.median); });
    line("95 %", [&](const ScatterOutput& o) { return value(o, o.high); });
    line("beside it: form of the model", [](const ScatterOutput& o) {
      return o.model_uncertainty ? percent(*o.model_uncertainty) : std::string("none");
    });
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scatter.inputs.size(); ++i) order.push_back(i);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return scatter.outputs[group[0]].share[a] > scatter.outputs[group[0]].share[b];
    });
    text += row("share of the variance, first order", "deviation", {});
    for (const std::size_t i : order)
      text += row(scatter.inputs[i].path, percent(scatter.inputs[i].relative_standard_deviation),
                  cells(group, [&](std::size_t y) {
                    return fmt::format("{:.1f} %", 100 * scatter.outputs[y].share[i]);
                  }));
  }
  return text;
}

/// A path as a field of a CSV line, quoted where it must be (RFC 4180).
/// Bars of the outputs of one kind that a panel shows, the largest on top.
TornadoPanel panel_of(const Sensitivity& sensitivity, const std::vector<std::size_t>& outputs) {
  constexpr std::size_t kMostBars = 14;
  TornadoPanel panel;
  std::vector<const SensitivityInput*> inputs;
  for (const SensitivityInput& input : sensitivity.inputs)
    if (largest(input, outputs) > 0) inputs.push_back(&input);
  std::ranges::stable_sort(inputs, [&](const auto* a, const auto* b) {
    return largest(*a, outputs) > largest(*b, outputs);
  });
  const std::size_t shown = std::min(kMostBars, inputs.size());
  if (shown < inputs.size())
    panel.subtitle = fmt::format("the {} largest of {}", shown, inputs.size());
  for (const std::size_t y : outputs) {
    TornadoSeries series{
        .label = sensitivity.outputs[y].name.find("positive") != std::string::npos   ? "T > 0"
                 : sensitivity.outputs[y].name.find("negative") != std::string::npos ? "T < 0"
                                                                                     : "sound",
        .values = {}};
    for (std::size_t i = 0; i < shown; ++i)
      series.values.push_back(inputs[i]->influence[y].elasticity);
    panel.series.push_back(std::move(series));
  }
  for (std::size_t i = 0; i < shown; ++i) panel.labels.push_back(inputs[i]->path);
  // One bar tells as much where both senses are the same to the eye.
  if (panel.series.size() == 2) {
    bool same = true;
    for (std::size_t i = 0; i < shown; ++i)
      same = same && std::abs(panel.series[0].values[i] - panel.series[1].values[i]) < 5e-4;
    if (same) {
      panel.series.pop_back();
      panel.series[0].label = "T > 0 and T < 0";
    }
  }
  return panel;
}

}  // namespace

std::string sensitivity_text(const SensitivityReport& report, const GearSet& gear) {
  const Sensitivity& sensitivity = report.sensitivity;
  std::string text =
      fmt::format("{}\nSensitivity of the torsional stiffness, method corrected, series model\n\n",
                  gear.name.empty() ? "Strain wave gear" : gear.name);
  text += elasticities_text(sensitivity);
  if (report.scatter) text += scatter_text(*report.scatter, sensitivity);
  text += "\nNotes\n" + notes_text(sensitivity.notes);
  if (report.scatter) text += notes_text(report.scatter->notes);
  return text;
}

ResultEvidence evidence_of(const SensitivityReport& report) {
  ResultEvidence evidence = evidence_of(report.sensitivity);
  if (report.scatter)
    evidence.notes.insert(evidence.notes.end(), report.scatter->notes.begin(),
                          report.scatter->notes.end());
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

std::string sensitivity_csv(const SensitivityReport& report) {
  const Sensitivity& sensitivity = report.sensitivity;
  std::string csv = "output,path,unit,value,derivative,elasticity";
  if (report.scatter) csv += ",relative_standard_deviation,share";
  csv += '\n';
  for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y)
    for (const SensitivityInput& input : sensitivity.inputs) {
      csv += fmt::format("{},{},{},{},{},{}", sensitivity.outputs[y].name, csv_field(input.path),
                         input.unit, input.value, input.influence[y].derivative,
                         input.influence[y].elasticity);
      if (report.scatter) {
        const auto& inputs = report.scatter->inputs;
        const auto at = std::ranges::find(inputs, input.path, &InputScatter::path);
        csv += at == inputs.end()
                   ? std::string(",,")
                   : fmt::format(",{},{}", at->relative_standard_deviation,
                                 report.scatter->outputs[y]
                                     .share[static_cast<std::size_t>(at - inputs.begin())]);
      }
      csv += '\n';
    }
  return csv;
}

std::string tornado_plot(const SensitivityReport& report, const GearSet& gear) {
  const Sensitivity& sensitivity = report.sensitivity;
  std::vector<TornadoPanel> panels;
  for (std::vector<std::size_t> group : column_groups(sensitivity)) {
    const bool loss = is_loss(sensitivity.outputs[group[0]].name);
    if (!loss) group.erase(group.begin());  // the sound drive: both cracked ones show it too
    TornadoPanel panel = panel_of(sensitivity, group);
    panel.title = loss ? "Loss of stiffness by cracks" : "Stiffness K at the output";
    if (panels.empty() && !gear.name.empty()) panel.title += ": " + gear.name;
    panel.x_label =
        loss ? "elasticity of the loss, ∂ ln(−ΔK/K)/∂ ln x" : "elasticity, ∂ ln K/∂ ln x";
    panels.push_back(std::move(panel));
  }
  return tornado_svg(panels);
}

}  // namespace strainwave

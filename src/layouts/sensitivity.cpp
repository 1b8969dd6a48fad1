// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

constexpr double kNoise = 1e-12;  // rounding noise; elasticities are of the order of one

/// The outputs of one kind, which share a table.
struct Group {
  std::string what;                  ///< "stiffness of the sum"
  std::string symbol;                ///< "K", for the head of a column
  std::vector<std::size_t> outputs;  ///< by index

  [[nodiscard]] bool is_loss() const { return symbol == "loss"; }
  [[nodiscard]] bool is_of_sum() const { return is_loss() || symbol == "K"; }
};

/// The groups of outputs: K1, K2, K3 of the coupled drive, then the stiffness of the sum and its
/// loss.
std::vector<Group> groups_of(const Sensitivity& sensitivity) {
  std::vector<Group> groups;
  for (const char* const line : {"K1", "K2", "K3"})
    groups.push_back({fmt::format("{} of the coupled drive", line), line, {}});
  groups.push_back({"stiffness of the sum", "K", {}});
  groups.push_back({"loss of stiffness of the sum", "loss", {}});
  for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y) {
    const std::string& name = sensitivity.outputs[y].name;
    const std::string symbol = name.starts_with("curve.") ? name.substr(name.rfind('.') + 1)
                               : name.ends_with("_loss")  ? "loss"
                                                          : "K";
    std::ranges::find(groups, symbol, &Group::symbol)->outputs.push_back(y);
  }
  std::erase_if(groups, [](const Group& group) { return group.outputs.empty(); });
  return groups;
}

/// The inputs on which at least one output of a group depends, the largest elasticity first.
std::vector<const SensitivityInput*> inputs_of(const Sensitivity& sensitivity, const Group& group) {
  const auto largest = [&](const SensitivityInput* input) {
    double most = 0.0;
    for (const std::size_t y : group.outputs)
      most = std::max(most, std::abs(input->influence[y].elasticity));
    return most;
  };
  std::vector<const SensitivityInput*> inputs;
  for (const SensitivityInput& input : sensitivity.inputs)
    if (largest(&input) > 0) inputs.push_back(&input);
  std::ranges::stable_sort(inputs, std::ranges::greater{}, largest);
  return inputs;
}

/// Adds a row with one cell for each output of a group.
template <class Cell>
void add_row(Table& table, std::string label, std::string value, const Group& group,
             const Cell& cell) {
  auto& row = table.rows.emplace_back(std::vector{std::move(label), std::move(value)});
  for (const std::size_t y : group.outputs) row.push_back(cell(y));
}

Table table_of(const Sensitivity& sensitivity, const Group& group) {
  Table table{.head = {"", ""}};
  for (const std::size_t y : group.outputs) {
    std::string head = output_words(sensitivity.outputs[y].name);
    table.head.push_back(head.replace(0, head.find(','), group.symbol));
  }
  return table;
}

std::string digits_of(double value, std::string_view unit, const std::string& output) {
  return fmt::format("{:.5g}", value / display_unit(output, unit).in_si);
}

/// Bars of the outputs of one kind, the largest on top.
TornadoPanel panel_of(const Sensitivity& sensitivity, const Group& group) {
  constexpr std::size_t kMostBars = 14;
  TornadoPanel panel;
  const std::vector<const SensitivityInput*> inputs = inputs_of(sensitivity, group);
  const std::size_t shown = std::min(kMostBars, inputs.size());
  if (shown < inputs.size())
    panel.subtitle = fmt::format("the {} largest of {}", shown, inputs.size());
  for (const std::size_t y : group.outputs) {
    const std::string words = output_words(sensitivity.outputs[y].name);
    TornadoSeries series{.label = words.substr(words.find(", ") + 2), .values = {}};
    for (std::size_t i = 0; i < shown; ++i)
      series.values.push_back(inputs[i]->influence[y].elasticity);
    panel.series.push_back(std::move(series));
  }
  for (std::size_t i = 0; i < shown; ++i) panel.labels.push_back(inputs[i]->path);
  // One bar is enough if both senses look the same.
  if (panel.series.size() == 2 &&
      std::ranges::equal(panel.series[0].values, panel.series[1].values,
                         [](double a, double b) { return std::abs(a - b) < 5e-4; })) {
    panel.series.pop_back();
    panel.series[0].label = "T > 0 and T < 0";
  }
  return panel;
}

}  // namespace

std::vector<TitledTable> elasticity_tables(const Sensitivity& sensitivity) {
  std::vector<TitledTable> tables;
  for (const Group& group : groups_of(sensitivity)) {
    Table table = table_of(sensitivity, group);
    const SensitivityOutput& first = sensitivity.outputs[group.outputs[0]];
    add_row(table,
            fmt::format("{} [{}]", group.what, display_unit(first.name, first.value.unit).text), "",
            group, [&](std::size_t y) {
              const SensitivityOutput& output = sensitivity.outputs[y];
              return digits_of(output.value.value, output.value.unit, output.name);
            });
    for (const SensitivityInput* const input : inputs_of(sensitivity, group))
      add_row(table, input->path, shown_quantity(input->value, input->unit, 5, input->path), group,
              [&](std::size_t y) {
                const double e = input->influence[y].elasticity;
                return std::abs(e) < kNoise ? std::string("0") : fmt::format("{:+.4g}", e);
              });
    tables.push_back(
        {fmt::format("Elasticities of {}{}: per cent of change per per cent of input (SN-1)",
                     group.is_of_sum() ? "the " : "", group.what),
         std::move(table)});
  }
  return tables;
}

std::vector<TitledTable> scatter_tables(const Scatter& scatter, const Sensitivity& sensitivity) {
  std::vector<TitledTable> tables;
  for (const Group& group : groups_of(sensitivity)) {
    if (group.outputs[0] >= scatter.outputs.size()) continue;  // not drawn
    Table table = table_of(sensitivity, group);
    const auto share = [&](const char* label, double ScatterOutput::*member) {
      add_row(table, label, "", group,
              [&](std::size_t y) { return percent(scatter.outputs[y].*member, 3); });
    };
    const auto value = [&](const char* label, double ScatterOutput::*member) {
      add_row(table, label, "", group, [&](std::size_t y) {
        const ScatterOutput& output = scatter.outputs[y];
        return digits_of(output.*member, output.unit, output.name);
      });
    };
    share("relative deviation, first order", &ScatterOutput::first_order);
    share("relative deviation, Monte Carlo", &ScatterOutput::relative_deviation);
    share("  its standard error", &ScatterOutput::relative_deviation_error);
    value("value in the file", &ScatterOutput::value);
    value("mean", &ScatterOutput::mean);
    value("5 %", &ScatterOutput::low);
    value("median", &ScatterOutput::median);
    value("95 %", &ScatterOutput::high);
    add_row(table, "in addition: form of the model", "", group, [&](std::size_t y) {
      return accuracy_text({1.0, "1", scatter.outputs[y].model_uncertainty});
    });
    table.rows.push_back({"deviation of each input and its share of the variance, first order"});
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scatter.inputs.size(); ++i) order.push_back(i);
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) {
      return scatter.outputs[group.outputs[0]].share[i];
    });
    for (const std::size_t i : order)
      add_row(table, scatter.inputs[i].path,
              percent(scatter.inputs[i].relative_standard_deviation, 3), group, [&](std::size_t y) {
                return fmt::format("{:.1f} %", 100 * scatter.outputs[y].share[i]);
              });
    const SensitivityOutput& first = sensitivity.outputs[group.outputs[0]];
    tables.push_back({fmt::format("Scatter of the outputs: {} [{}]", group.what,
                                  display_unit(first.name, first.value.unit).text),
                      std::move(table)});
  }
  return tables;
}

std::vector<TitledTable> sobol_tables(const Sobol& sobol) {
  // Adding 0 to a rounded share prevents "-0.0".
  const auto tenths = [](double share) { return std::round(1000 * share) / 10 + 0.0; };
  const auto share = [&](const SobolShare& of) {
    return fmt::format("{:.1f} %", tenths(of.value));
  };
  const auto interval = [&](const SobolShare& of) {
    return fmt::format("{:.1f} to {:.1f}", tenths(of.low), tenths(of.high));
  };
  std::vector<TitledTable> tables;
  for (const SobolAnswer& answer : sobol.outputs) {
    Table table{.head = {"", "alone", "95 % interval", "total", "95 % interval"}};
    for (const SobolInput& input : answer.inputs)
      table.rows.push_back(cells(input.path, share(input.first), interval(input.first),
                                 share(input.total), interval(input.total)));
    if (answer.inputs.empty())
      table.rows.push_back({"the output does not vary"});
    else
      table.rows.push_back(
          cells("sum of the single inputs", share(answer.first_sum), interval(answer.first_sum)));
    tables.push_back(
        {fmt::format("Shares in the variance of {}: mean {}, standard deviation {} (UQ-2, UQ-3)",
                     output_words(answer.name),
                     shown_quantity(answer.mean, answer.unit, 5, answer.name),
                     shown_quantity(answer.deviation, answer.unit, 3, answer.name)),
         std::move(table)});
  }
  return tables;
}

std::string sensitivity_text(const SensitivityReport& report, const GearSet& gear) {
  const Sensitivity& sensitivity = report.sensitivity;
  std::string text = name_of(gear) +
                     "\nSensitivity of the torsional stiffness, method corrected\n" +
                     text_tables(elasticity_tables(sensitivity));
  std::string zeros;
  for (const SensitivityInput& input : sensitivity.inputs) {
    if (input.value != 0) continue;
    for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y)
      zeros += fmt::format("  d {}/d {} = {:.5g} in SI units\n", sensitivity.outputs[y].name,
                           input.path, input.influence[y].derivative);
  }
  if (!zeros.empty()) text += "\nInputs that are 0 have a derivative but no elasticity\n" + zeros;
  if (!sensitivity.no_influence.empty())
    text += '\n' +
            paragraph(fmt::format("No influence: {}", fmt::join(sensitivity.no_influence, ", ")));
  for (const CurveStep& step : sensitivity.not_differentiated)
    text += paragraph(fmt::format("K1, K2, K3 have no derivative with respect to {}: {}", step.path,
                                  step.reason));
  text += fmt::format("\nResidual of the dimensions: {:.1g}; at most {:.0g} is accepted (SN-6)\n",
                      sensitivity.homogeneity_residual(), kMaxHomogeneityResidual);
  if (const auto& scatter = report.scatter)
    text += text_tables(scatter_tables(*scatter, sensitivity)) +
            fmt::format("  {} of {} draws evaluated, {} refused, {} not usable; seed {}\n",
                        scatter->evaluated, scatter->samples, scatter->refused, scatter->unusable,
                        scatter->seed);
  if (const auto& sobol = report.sobol)
    text += text_tables(sobol_tables(*sobol)) +
            fmt::format("  {} drives evaluated at {} points, {} points left out; seed {}\n",
                        sobol->evaluations, sobol->points, sobol->left_out, sobol->seed);
  return text + "\nNotes\n" + notes_text(evidence_of(report).notes);
}

namespace {

/// "N*m/rad/(m)": unit of the output over that of the input.
std::string derivative_unit(const SensitivityOutput& output, const SensitivityInput& input) {
  return input.unit == "1" ? std::string(output.value.unit)
                           : fmt::format("{}/({})", output.value.unit, input.unit);
}

}  // namespace

std::string sensitivity_csv(const SensitivityReport& report) {
  const Sensitivity& sensitivity = report.sensitivity;
  Table table{
      .head = {"output", "path", "unit", "value", "derivative", "derivative_unit", "elasticity"}};
  if (report.scatter) table.head.insert(table.head.end(), {"relative_standard_deviation", "share"});
  for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y)
    for (const SensitivityInput& input : sensitivity.inputs) {
      auto& row = table.rows.emplace_back(cells(sensitivity.outputs[y].name, input.path, input.unit,
                                                input.value, input.influence[y].derivative,
                                                derivative_unit(sensitivity.outputs[y], input),
                                                input.influence[y].elasticity));
      if (!report.scatter || y >= report.scatter->outputs.size()) continue;  // not drawn
      const auto& inputs = report.scatter->inputs;
      const auto at = std::ranges::find(inputs, input.path, &ScatteredInput::path);
      if (at == inputs.end()) continue;
      const auto i = static_cast<std::size_t>(at - inputs.begin());
      row.push_back(cell(at->relative_standard_deviation));
      row.push_back(cell(report.scatter->outputs[y].share[i]));
    }
  return csv_table(table);
}

std::string sensitivity_plot(const SensitivityReport& report, const GearSet& gear) {
  const Sensitivity& sensitivity = report.sensitivity;
  std::vector<TornadoPanel> panels;
  for (Group group : groups_of(sensitivity)) {
    // Leave out the sound drive, because the tables of both cracked drives show it too.
    if (!group.is_loss() && group.outputs.size() > 1) group.outputs.erase(group.outputs.begin());
    TornadoPanel panel = panel_of(sensitivity, group);
    panel.title = group.what;
    if (group.is_of_sum()) panel.title[0] = group.is_loss() ? 'L' : 'S';
    if (panels.empty() && !gear.name.empty()) panel.title += ": " + gear.name;
    panel.x_label = group.is_loss() ? "elasticity of the loss, ∂ ln(−ΔK/K)/∂ ln x"
                                    : fmt::format("elasticity, ∂ ln {0}/∂ ln x", group.symbol);
    panels.push_back(std::move(panel));
  }
  return tornado_svg(panels);
}

}  // namespace strainwave

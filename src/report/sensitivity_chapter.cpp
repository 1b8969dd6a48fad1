// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/sensitivity.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave::report {
namespace {

constexpr std::size_t kMostBars = 12;
constexpr std::size_t kMostRows = 20;

std::string elasticity_text(double elasticity) {
  constexpr double kNoise = 1e-12;  // rounding noise; elasticities are of the order of one
  return std::abs(elasticity) < kNoise ? "0" : typeset(fmt::format("{:+.3g}", elasticity));
}

std::string tornado(const Sensitivity& s, std::size_t output, const std::string& id) {
  std::vector<const SensitivityInput*> inputs;
  for (const SensitivityInput& input : s.inputs)
    if (elasticity_text(input.influence[output].elasticity) != "0") inputs.push_back(&input);
  std::ranges::stable_sort(inputs, std::greater<>(), [&](const SensitivityInput* input) {
    return std::abs(input->influence[output].elasticity);
  });
  inputs.resize(std::min(inputs.size(), kMostBars));
  const std::string what = output_words(s.outputs[output].name);
  BarChart chart{.id = id,
                 .title = "Elasticities of the " + what,
                 .axis = "change in percent when the input increases by 1 %"};
  for (const SensitivityInput* input : inputs) {
    const double elasticity = input->influence[output].elasticity;
    chart.bars.push_back({.label = input->path,
                          .to = elasticity,
                          .text = elasticity_text(elasticity),
                          .style = elasticity < 0 ? "low" : ""});
  }
  return chart.bars.empty()
             ? std::string()
             : figure(bar_chart(chart), "Inputs with the strongest influence on the " + what + ".",
                      "bars");
}

std::string scatter_html(Draft& draft, const Sensitivity& s) {
  const ScatterOptions options{.samples = draft.options.samples, .seed = 1, .threads = 1};
  const Scatter scatter = scatter_of(draft.gear, s, options, draft.progress.part(0.95, 1.0));
  draft.add(scatter.notes);
  draft.add(std::vector<std::string>{"SN-7", "SN-8"});
  std::string html =
      paragraph(fmt::format("Scatter of {} inputs, as the file gives it, by first order and by {} "
                            "draws, of which {} were evaluated.",
                            scatter.inputs.size(), scatter.samples, scatter.evaluated));
  for (const TitledTable& one : scatter_tables(scatter, s)) html += table(one);
  return html;
}

ReportSection absent(std::string_view why) {
  return {"sensitivity", "Sensitivity", paragraph(why, "absent")};
}

}  // namespace

ReportSection sensitivity_chapter(Draft& draft) {
  if (!draft.corrected())
    return absent(
        fmt::format("This report has no sensitivities, because it uses the method {}; only the "
                    "method corrected gives sensitivities.",
                    enum_name(draft.result.method)));
  try {
    const Sensitivity s = sensitivity_of(draft.gear);
    if (!s.usable()) return absent("No sensitivity: " + s.unusable_because + ".");
    std::string html = paragraph(
        "The table gives exact first derivatives as elasticities: the change of an output in "
        "percent when one input increases by one percent and all other inputs stay the same. The "
        "outputs are those of the sum of the members and, if the coupled drive is solved, K1, K2, "
        "K3.");
    const std::string sense = draft.gear.load.torque > 0 ? "positive" : "negative";
    const std::string coupled = draft.cracks.empty() ? "curve.intact." : "curve." + sense + ".";
    std::size_t charts = 0;
    for (const std::string& name : {coupled + "K1", coupled + "K2", coupled + "K3",
                                    draft.cracks.empty() ? std::string("intact.stiffness")
                                                         : "cracked." + sense + ".stiffness",
                                    "cracked." + sense + ".stiffness_loss"}) {
      const auto output = std::ranges::find(s.outputs, name, &SensitivityOutput::name);
      if (output == s.outputs.end()) continue;
      html += tornado(s, static_cast<std::size_t>(output - s.outputs.begin()),
                      fmt::format("tornado-{}", ++charts));
    }
    for (TitledTable& one : elasticity_tables(s)) {
      auto& rows = one.table.rows;
      if (rows.size() > kMostRows)
        one.remark = fmt::format("The {} largest are shown.", kMostRows - 1);
      rows.resize(std::min(rows.size(), kMostRows));
      html += table(one);
    }
    if (!s.no_influence.empty())
      html +=
          paragraph(fmt::format("{} numbers of the file have no influence on any of these outputs.",
                                s.no_influence.size()),
                    "remark");
    for (const CurveStep& step : s.not_differentiated)
      html += paragraph(fmt::format("K1, K2, K3 have no derivative with respect to {}: {}.",
                                    escaped(step.path), step.reason),
                        "remark");
    draft.add(s.notes);
    draft.add(std::vector<std::string>{"SN-1", "SN-2", "SN-6", "TC-27"});
    if (!draft.gear.scatter.empty()) html += scatter_html(draft, s);
    return {"sensitivity", draft.gear.scatter.empty() ? "Sensitivity" : "Sensitivity and scatter",
            html};
  } catch (const Error& error) {
    return absent(std::string("No sensitivity: ") + error.what());
  }
}

}  // namespace strainwave::report

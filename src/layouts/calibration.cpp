// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

std::string calibration_text(const Calibration& c) {
  const auto number = [](double value) { return fmt::format("{:.5g}", value); };
  const DisplayUnit unit = stiffness_unit();
  Table stiffness{
      .head = {fmt::format("[{}]", unit.text), "wanted", "as given", "", "calibrated", ""}};
  for (const CalibratedStiffness& s : c.stiffnesses) {
    const auto off = [&](double K) { return percent_change(K / s.target.stiffness - 1); };
    const auto shown = [&](double K) { return number(K / unit.in_si); };
    stiffness.rows.push_back(cells(s.target.name, shown(s.target.stiffness), shown(s.before),
                                   off(s.before), shown(s.after), off(s.after)));
  }
  Table factors{.head = {"factor", "as given", "calibrated", "uncertainty", ""}, .align = "lrrrl"};
  for (const CalibratedFactor& f : c.factors) {
    std::string verdict = f.identified ? "identified" : "NOT IDENTIFIED";
    if (f.at_limit)
      verdict += ": the fit stopped at a limit of the factor";
    else if (!f.identified)
      verdict += ": uncertain by more than 50 %";
    if (!f.plausible) verdict += "; outside the plausible range";
    factors.rows.push_back(cells(f.factor, fmt::format("{:.4g}", f.before),
                                 fmt::format("{:.4g}", f.value),
                                 fmt::format("{:.2g}", f.uncertainty), verdict));
  }
  Table combinations{.head = {"singular value", "uncertainty", "", "combination"}, .align = "rrll"};
  for (const FactorCombination& combination : c.combinations) {
    std::string sum;
    for (std::size_t i = 0; i < combination.weights.size(); ++i)
      sum += fmt::format(
          "{}{:.2f} {}",
          combination.weights[i] < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + "),
          std::abs(combination.weights[i]), enum_name(c.factors[i].factor));
    combinations.rows.push_back(cells(fmt::format("{:.3g}", combination.singular_value),
                                      fmt::format("{:.2g}", combination.uncertainty),
                                      combination.identified ? "identified" : "not identified",
                                      sum));
  }
  std::string text = fmt::format(
      "Calibration with {}: {} factors, {} values\n\n{}\n{}\n"
      "With all other numbers of the file taken as exact, {} values identify {} of {} "
      "combinations:\n"
      "{}\nUncertainties are one standard uncertainty, for values uncertain by {} each; residual "
      "{}, {} steps{}.\n",
      c.source, c.factors.size(), c.stiffnesses.size(), text_table(stiffness), text_table(factors),
      c.stiffnesses.size(), std::ranges::count_if(c.combinations, &FactorCombination::identified),
      c.combinations.size(), text_table(combinations), percent(c.relative_uncertainty),
      percent(c.residual), c.iterations, c.converged ? "" : ", NOT CONVERGED");
  const std::vector<Note> notes = evidence_of(c).notes;
  if (!notes.empty()) text += "\nNotes\n" + notes_text(notes);
  return text;
}

std::string calibrated_drive(const Calibration& calibration, const GearSet& before,
                             const std::string& text) {
  std::string head = "# Calibrated with " + calibration.source + ".\n";
  for (const CalibratedFactor& factor : calibration.factors)
    head += fmt::format("# {}: {:.4g}, was {:.4g}; standard uncertainty {:.2g}, {}\n",
                        enum_name(factor.factor), factor.value, factor.before, factor.uncertainty,
                        factor.identified ? "identified" : "not identified") +
            (factor.at_limit    ? "#   the fit stopped at a limit of the factor\n"
             : factor.plausible ? ""
                                : "#   outside the plausible range\n");
  std::string drive =
      with_numbers_of(text.empty() ? gear_text(before) : text, before, calibration.gear);
  // A byte order mark and the line that names the schema to an editor stay first.
  std::size_t first = drive.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (drive.substr(first).starts_with("#:schema"))
    first = std::min(drive.find('\n', first), drive.size() - 1) + 1;
  return drive.insert(first, head);
}

}  // namespace strainwave

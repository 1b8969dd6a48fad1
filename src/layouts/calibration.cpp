// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/io/edit.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string percent_or_dash(const std::optional<double>& share) {
  return share ? percent(*share) : std::string("-");
}

std::string_view words_of(RatioClass to) {
  return to == RatioClass::eighty_up ? "80 and more" : enum_name(to);
}

constexpr double kShownDifference = 1e-4;  // a smaller one comes from rounding and the solver [-]

std::string other_ratios_text(const OtherRatios& other) {
  const DisplayUnit unit = stiffness_unit();
  const auto shown = [&](double K) { return fmt::format("{:.5g}", K / unit.in_si); };
  Table table{.head = {"ratio", fmt::format("[{}]", unit.text), "predicted", "stated", "error",
                       "usual error", "worst error", ""},
              .align = "rlrrrrrl"};
  for (const RatioPrediction& p : other.predictions)
    table.rows.push_back(cells(
        fmt::format("{:g}", p.ratio), p.name, shown(p.predicted), p.stated ? shown(*p.stated) : "-",
        p.error() ? percent_change(*p.error()) : "-", percent_or_dash(p.usual_error),
        percent_or_dash(p.worst_error), p.same_row ? "same row as the fit" : ""));
  const std::string type = fmt::format("{} {} of size {}", enum_name(other.type.length),
                                       enum_name(other.type.form), other.size);
  std::string text =
      fmt::format("\nOther ratios of a {}, from the calibration at ratio {:g}\n\n{}\n", type,
                  other.from, text_table(table));
  text += other.median
              ? paragraph(fmt::format("Error against the stated values that entered no fit: median "
                                      "{}, worst {}.",
                                      percent(*other.median), percent(*other.worst)),
                          0, 0)
              : paragraph("At these ratios no table states a value that entered no fit.", 0, 0);
  text += paragraph(
      fmt::format("Each other ratio is the typical {} with the fitted factors. The geometry of "
                  "that drive is typical; only the factors are those of the calibration. At ratio "
                  "{:g} the typical drive with these factors differs from the calibrated drive by "
                  "{} at most in K1 to K3.",
                  type, other.from,
                  other.geometry_difference < kShownDifference
                      ? std::string("0 %")
                      : percent(other.geometry_difference)),
      0, 0);
  if (!errors_are_known(other)) return text;
  text += paragraph(
      "Usual and worst error: the same calibration and prediction, repeated with the typical short "
      "cup of each size of the catalogue. The values of the fitted rows are left out, so the other "
      "ratios of such a row have no usual error.",
      0, 0);
  for (const TransferError& transfer : other.transfer.classes)
    text += paragraph(
        fmt::format("From ratio {:g} to {}: median {}, worst {} over {} of the catalogue's sizes "
                    "of 17 and more ({} values).",
                    other.from, words_of(transfer.to), percent(transfer.median),
                    percent(transfer.worst), transfer.sizes, transfer.values),
        2, 2);
  if (other.transfer.left_out > 0)
    text += paragraph(
        fmt::format(
            "Sizes left out because a drive cannot be computed or its fit does not converge: {}.",
            other.transfer.left_out),
        2, 2);
  return text;
}

/// Lines of [drivetrain.friction], below their heading.
std::string friction_lines(const LuGre& friction) {
  std::string lines;
  const auto add = [&](std::string_view name, double value, std::string_view unit) {
    const std::string text =
        unit == "1" ? fmt::format("{:.6g}", value) : fmt::format("\"{:.6g} {}\"", value, unit);
    lines += fmt::format("{} = {}\n", name, text);
  };
  add("coulomb", friction.coulomb, "N*m");
  add("breakaway", friction.breakaway, "N*m");
  add("stribeck_speed", friction.stribeck_speed, "rad/s");
  add("bristle_stiffness", friction.bristle_stiffness, "N*m/rad");
  if (friction.viscous > 0) add("viscous", friction.viscous, "N*m*s/rad");
  add("load_coulomb", friction.load_coulomb, "1");
  if (friction.load_breakaway) add("load_breakaway", *friction.load_breakaway, "1");
  return lines;
}

/// Comments that say to what the friction of a drive is fitted.
std::string friction_head(const Calibration& c) {
  std::string head =
      fmt::format("# drivetrain.friction is fitted to {}, at {:.6g} rad/s and {:.6g} N*m:\n",
                  c.source, c.friction->targets.speed, c.friction->targets.torque);
  for (const FrictionValue& value : c.friction->values)
    head += fmt::format("# {}: {:.6g}{}{}\n", enum_name(value.quantity), value.wanted,
                        value.unit() == "1" ? "" : " N*m",
                        value.simulated ? fmt::format(", simulated {:.6g}", *value.simulated)
                                        : std::string(", not simulated"));
  return head;
}

std::string friction_text(const Calibration& c) {
  const FrictionFit& fit = *c.friction;
  Table table{.head = {"", "given", "fitted", "", "simulated", ""}, .align = "lrrrrr"};
  const auto change = [](double share) {
    return std::abs(share) < 5e-6 ? std::string("exact") : fmt::format("{:+.2g} %", 100 * share);
  };
  for (const FrictionValue& value : fit.values) {
    const DisplayUnit unit = display_unit({}, value.unit());
    const auto shown = [&](double x) { return shown_number(x / unit.in_si, 5); };
    table.rows.push_back(cells(value.unit() == "1" ? std::string(enum_name(value.quantity))
                                                   : with_unit(enum_name(value.quantity), unit),
                               shown(value.wanted), shown(value.fitted), change(value.residual()),
                               value.simulated ? shown(*value.simulated) : std::string("-"),
                               value.error() ? change(*value.error()) : std::string("-")));
  }
  std::string text =
      fmt::format("Friction of the input, fitted to {}\n\n{}\n", c.source, text_table(table));
  text += paragraph(
      fmt::format("No-load torque and efficiency are those at {}, the efficiency with {} on the "
                  "output. Fitted: by the formulas of the model (MO-41 to MO-43). Simulated: two "
                  "runs and two slow ramps of the torque on the drive's inertias and spring, "
                  "without cracks, kinematic error, gravity, and damping of motor and load.",
                  number_and_unit(fit.targets.speed, display_unit({}, "rad/s")),
                  number_and_unit(fit.targets.torque, display_unit({}, "N*m"))),
      0, 0);
  text += fmt::format("\n[drivetrain.friction]                 # fitted to {}\n{}", c.source,
                      friction_lines(fit.friction));
  return text;
}

std::string calibration_notes(const Calibration& c) {
  const std::vector<Note> notes = evidence_of(c).notes;
  return notes.empty() ? std::string() : "\nNotes\n" + notes_text(notes);
}

}  // namespace

std::string calibration_text(const Calibration& c) {
  if (c.friction) return friction_text(c) + calibration_notes(c);
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
  if (c.other_ratios) text += other_ratios_text(*c.other_ratios);
  return text + calibration_notes(c);
}

std::string calibrated_drive(const Calibration& calibration, const GearSet& before,
                             const std::string& text) {
  std::string head = calibration.friction ? friction_head(calibration)
                                          : "# Calibrated with " + calibration.source + ".\n";
  for (const CalibratedFactor& factor : calibration.factors)
    head += fmt::format("# {}: {:.4g}, was {:.4g}; standard uncertainty {:.2g}, {}\n",
                        enum_name(factor.factor), factor.value, factor.before, factor.uncertainty,
                        factor.identified ? "identified" : "not identified") +
            (factor.at_limit    ? "#   the fit stopped at a limit of the factor\n"
             : factor.plausible ? ""
                                : "#   outside the plausible range\n");
  const std::string given = text.empty() ? gear_text(before) : text;
  std::string drive = calibration.friction ? edit(given, "drivetrain.friction",
                                                  friction_lines(calibration.friction->friction))
                                           : with_numbers_of(given, before, calibration.gear);
  // A byte order mark and the line that names the schema to an editor stay first.
  std::size_t first = drive.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (drive.substr(first).starts_with("#:schema"))
    first = std::min(drive.find('\n', first), drive.size() - 1) + 1;
  return drive.insert(first, head);
}

}  // namespace strainwave

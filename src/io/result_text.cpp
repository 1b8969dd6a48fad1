// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/units.hpp"
#include "strainwave/io/result_writer.hpp"

namespace strainwave {
namespace {

std::string percent_text(double relative) {
  const double p = 100 * relative;
  return p >= 9.95 ? fmt::format("{:.0f} %", p) : fmt::format("{:.2g} %", p);
}

/// "none" where nobody can state an accuracy, "-" where there is nothing to state one of.
std::string accuracy(const Quantity& q) {
  if (!q.relative_uncertainty) return "none";
  return q.value == 0 ? "-" : percent_text(*q.relative_uncertainty);
}

/// The quantity in another unit.
Quantity in_unit(const Quantity& q, double unit_in_si, std::string_view unit) {
  return {q.value / unit_in_si, unit, q.relative_uncertainty};
}

std::string percent(const Quantity& q) { return warranted_digits(in_unit(q, 0.01, "%")) + " %"; }

std::string row(std::string_view label, std::string_view sound, std::string_view share,
                std::string_view positive, std::string_view negative, std::string_view accuracy) {
  std::string line = fmt::format("  {:<26}{:>14}{:>9}{:>16}{:>16}{:>11}", label, sound, share,
                                 positive, negative, accuracy);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string compliance_row(std::string_view label, const StiffnessResult& result,
                           Quantity Compliances::*member) {
  const Quantity& sound = result.intact.compliance.*member;
  const double share = sound.value / result.intact.compliance.total.value;
  return row(label, warranted_digits(sound), fmt::format("{:.1f} %", 100 * share),
             warranted_digits(result.positive.compliance.*member),
             warranted_digits(result.negative.compliance.*member), accuracy(sound));
}

template <class Convert>
std::string drive_row(std::string_view label, const StiffnessResult& result,
                      Quantity IntactDrive::*sound, Quantity CrackedDrive::*cracked,
                      const Convert& convert) {
  return row(label, convert(result.intact.*sound), "", convert(result.positive.*cracked),
             convert(result.negative.*cracked), accuracy(result.intact.*sound));
}

std::string crack_lines(const CrackReport& crack) {
  // A mode that is nothing but rounding of the others is 0.
  const auto modes = [](const auto& at) {
    const double largest =
        std::max({std::abs(at.K_I.value), std::abs(at.K_II.value), std::abs(at.K_III.value)});
    const auto mpa = [&](Quantity K) {
      if (std::abs(K.value) < 1e-12 * largest) K.value = 0.0;
      return warranted_digits(in_unit(K, units::MPa, "MPa*m^0.5"));
    };
    return fmt::format("K_I = {}, K_II = {}, K_III = {} MPa*m^0.5\n", mpa(at.K_I), mpa(at.K_II),
                       mpa(at.K_III));
  };
  std::string text =
      fmt::format("  {} ({}), opens under {} torque\n", crack.path, crack.kind,
                  crack.opens_under == OpensUnder::both      ? "either sense of"
                  : crack.opens_under == OpensUnder::neither ? "neither sense of"
                                                             : enum_name(crack.opens_under));
  text += row("  adds rad/(N*m)", "", "", warranted_digits(crack.positive.at_output),
              warranted_digits(crack.negative.at_output), accuracy(crack.positive.at_output));
  if (crack.deepest) text += "    at the given load, deepest point: " + modes(*crack.deepest);
  if (crack.largest && crack.deepest &&
      (crack.largest->K_I.value != crack.deepest->K_I.value ||
       crack.largest->K_II.value != crack.deepest->K_II.value ||
       crack.largest->K_III.value != crack.deepest->K_III.value))
    text += "    largest along the front:          " + modes(*crack.largest);
  return text;
}

std::string three_digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

std::string critical_text(const StrengthState& state) {
  const auto& answer = state.critical_size ? state.critical_size : state.brittle_size;
  if (!answer) return "-";
  return answer->size ? fmt::format("{:.3g} mm", *answer->size / units::mm) : "none";
}

/// One line per state of a crack, then the verdict in words.
std::string strength_lines(const std::vector<CrackStrength>& strength) {
  std::string text = "\nStrength at the given load: failure assessment, option 1 of BS 7910\n";
  const auto line = [&](std::string_view state, std::string_view utilisation, std::string_view L_r,
                        std::string_view K_r, std::string_view limit, std::string_view reserve,
                        std::string_view critical, std::string_view zone,
                        std::string_view verdict) {
    text += fmt::format("  {:<16}{:>8}{:>9}{:>9}{:>7}{:>9}{:>12}{:>9}  {}\n", state, utilisation,
                        L_r, K_r, limit, reserve, critical, zone, verdict);
  };
  line("", "K/K_Ic", "L_r", "K_r", "line", "reserve", "critical", "r_p/lig.", "verdict");
  for (const CrackStrength& crack : strength) {
    text += fmt::format(
        "  {} ({}{})\n", crack.path, crack.kind,
        crack.size_name.empty()
            ? std::string()
            : fmt::format(", {} {:.3g} mm", crack.size_name == "depth" ? "depth" : "half length",
                          crack.size / units::mm));
    for (const StrengthState& state : crack.states) {
      std::optional<double> zone;
      if (state.plastic_zone && crack.ligament) zone = *state.plastic_zone / *crack.ligament;
      line(
          fmt::format("  T {} 0{}", state.sense == TorqueSense::positive ? '>' : '<',
                      state.with_assembly ? " + assem." : ""),
          three_digits(state.utilisation), three_digits(state.L_r), three_digits(state.K_r),
          three_digits(state.line), three_digits(state.reserve), critical_text(state),
          three_digits(zone),
          state.verdict == StrengthVerdict::cannot_tell ? "cannot tell" : enum_name(state.verdict));
    }
    text += "    " + wrapped(crack.sentence, kTextWidth - 4, 4) + '\n';
  }
  return text + "  " + strength_summary(strength) + '\n';
}

}  // namespace

std::string warranted_digits(const Quantity& quantity) {
  // A quantity without a stated accuracy repeats a published number: as many digits as those have,
  // and a few to compare.
  constexpr int kUnstated = 6;
  constexpr int kMost = 9;
  const double u = quantity.relative_uncertainty.value_or(0.0);
  const int digits =
      u > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(u))), 1, kMost - 2) + 2 : kUnstated;
  return fmt::format("{:.{}g}", quantity.value, digits);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > 0 && column + 1 + end > width) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string notes_text(std::span<const Note> notes) {
  std::string text;
  for (const Note& note : notes) {
    std::string line = note.path.empty() ? note.text : note.path + ": " + note.text;
    if (!note.equation.empty()) line += fmt::format(" ({})", note.equation);
    if (!note.next_step.empty()) line += ". " + note.next_step;
    text += fmt::format("  - {}\n", wrapped(line, kTextWidth - 4, 4));
  }
  return text;
}

std::string result_text(const StiffnessResult& result, const GearSet& gear,
                        const Provenance& provenance) {
  std::string text = fmt::format(
      "{}\n{}, method {}, strainwave {}\nLoad at the output: T = {} N*m, P = {} N\n\n",
      gear.name.empty() ? "Strain wave gear" : gear.name, provenance.input_file,
      enum_name(result.method), provenance.version, gear.load.torque, gear.load.axial_force);
  if (!result.usable())
    text += wrapped("NOT USABLE: " + result.unusable_because, kTextWidth, 2) + "\n\n";
  for (const CrackStrength& crack : result.strength)
    if (crack.breaks())
      text += wrapped("WARNING: " + crack.path + " " + crack.sentence, kTextWidth, 2) + '\n';
  if (std::ranges::any_of(result.strength, &CrackStrength::breaks))
    text += "The stiffness below is that of the cracks as they stand.\n\n";

  text += row("", "sound", "share", "cracked, T > 0", "cracked, T < 0", "accuracy");
  text += "Compliance at the output, input locked [rad/(N*m)]\n";
  text += compliance_row("wave generator", result, &Compliances::wave_generator);
  text += compliance_row("flexspline", result, &Compliances::flexspline);
  text += compliance_row("output shaft", result, &Compliances::output_shaft);
  text += compliance_row("total", result, &Compliances::total);
  text += "Torsional stiffness K_HD\n";
  text += drive_row("N*m/rad", result, &IntactDrive::stiffness, &CrackedDrive::stiffness,
                    warranted_digits);
  text += drive_row("N*m/arcmin", result, &IntactDrive::stiffness, &CrackedDrive::stiffness,
                    [](const Quantity& K) {
                      return warranted_digits(in_unit(K, 1 / units::arcmin, "N*m/arcmin"));
                    });
  text +=
      row("change", "", "", percent(result.positive.stiffness_change),
          percent(result.negative.stiffness_change), accuracy(result.positive.stiffness_change));
  text += drive_row(fmt::format("Wind-up at {} N*m [arcmin]", std::abs(gear.load.torque)), result,
                    &IntactDrive::wind_up, &CrackedDrive::wind_up, [](const Quantity& phi) {
                      return warranted_digits(in_unit(phi, units::arcmin, "arcmin"));
                    });
  if (result.curve) {
    text += "Torsion curve of the coupled drive, with balls, teeth and rings [N*m/rad]\n";
    const auto line = [&](std::string_view label, Quantity CurveStiffness::*K) {
      text += row(label, warranted_digits(result.curve->intact.*K), "",
                  warranted_digits(result.curve->positive.*K),
                  warranted_digits(result.curve->negative.*K), accuracy(result.curve->intact.*K));
      const auto change = [&](const CurveStiffness& cracked) {
        return percent({(cracked.*K).value / (result.curve->intact.*K).value - 1, "1", 0.1});
      };
      const auto differs = [&](const CurveStiffness& cracked) {
        return std::abs((cracked.*K).value / (result.curve->intact.*K).value - 1) > 1e-9;
      };
      if (differs(result.curve->positive) || differs(result.curve->negative))
        text += row("  change", "", "", change(result.curve->positive),
                    change(result.curve->negative), "");
    };
    line("K1, up to T1", &CurveStiffness::K1);
    line("K2, T1 to T2", &CurveStiffness::K2);
    line("K3, from T2", &CurveStiffness::K3);
  }
  if (!result.cracks.empty()) text += "\nCracks\n";
  for (const CrackReport& crack : result.cracks) text += crack_lines(crack);
  if (!result.strength.empty()) text += strength_lines(result.strength);
  if (!result.notes.empty()) text += "\nNotes\n";
  text += notes_text(result.notes);
  if (!result.accuracies.empty()) text += "\nAccuracy of the models, one standard uncertainty\n";
  for (const AccuracyBasis& basis : result.accuracies)
    text += fmt::format("  {:>5}  ", percent_text(basis.relative_uncertainty)) +
            wrapped(basis.path + ": " + basis.source, kTextWidth - 9, 9) + '\n';
  text +=
      "\n" +
      wrapped(fmt::format("Equations of the theory manual: {}", fmt::join(result.equations, ", ")),
              kTextWidth, 2) +
      "\n";
  return text;
}

}  // namespace strainwave

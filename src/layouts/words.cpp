// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/words.hpp"

#include <fmt/format.h>

#include "strainwave/core/units.hpp"

namespace strainwave {

std::string_view words_of(OpensUnder opens) {
  switch (opens) {
    case OpensUnder::neither:
      return "neither sense";
    case OpensUnder::both:
      return "either sense";
    case OpensUnder::positive:
      return words_of(TorqueSense::positive);
    case OpensUnder::negative:
      break;
  }
  return words_of(TorqueSense::negative);
}

std::string_view words_of(TorqueSense sense) {
  return sense == TorqueSense::positive ? "T > 0" : "T < 0";
}

std::string_view words_of(StrengthVerdict verdict) {
  return verdict == StrengthVerdict::cannot_tell ? "cannot tell" : enum_name(verdict);
}

std::string words_of(const StrengthState& state) {
  return fmt::format("{}, {}", words_of(state.sense),
                     state.with_assembly ? "with the assembly" : "load alone");
}

std::optional<std::string> at_work_sentence(const CrackReport& crack) {
  if (!crack.at_work) return std::nullopt;
  const TurnRange& K = *crack.at_work;
  const DisplayUnit unit = display_unit({}, "Pa*m^0.5");
  const auto shown = [&](double value) { return shown_number(value / unit.in_si, 3); };
  return fmt::format("K_I runs from {} to {} {}, Delta K = {}, R = {}", shown(K.least),
                     shown(K.largest), unit.text, shown(K.range), shown_number(K.ratio, 3));
}

std::string output_words(std::string_view output) {
  const std::string_view last = output.substr(output.rfind('.') + 1);
  const bool line = last == "K1" || last == "K2" || last == "K3";
  std::string_view rest = output.substr(0, output.size() - last.size());
  const bool of_curve = rest.starts_with("curve.");
  if (of_curve) rest.remove_prefix(std::string_view("curve.").size());
  const std::string_view what = of_curve                   ? (line ? last : "")
                                : last == "stiffness"      ? "stiffness"
                                : last == "stiffness_loss" ? "loss of stiffness"
                                                           : "";
  const std::string_view of =
      rest == "intact."                                    ? "sound"
      : rest == "positive." || rest == "cracked.positive." ? words_of(TorqueSense::positive)
      : rest == "negative." || rest == "cracked.negative." ? words_of(TorqueSense::negative)
                                                           : "";
  if (what.empty() || of.empty()) return std::string(output);
  return fmt::format("{}, {}", what, of);
}

std::string_view place_of_intensity(std::string_view kind) {
  return kind == WallThroughCrack::kKind || kind == DiaphragmArcCrack::kKind ? "tip"
                                                                             : "deepest point";
}

std::string counted(std::size_t n, std::string_view thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

DisplayUnit stiffness_unit() { return display_unit({}, "N*m/rad", {"N*m/rad", 1.0}); }

DisplayUnit plotted_stiffness_unit() { return display_unit({}, "N*m/rad"); }

DisplayUnit angle_unit() { return display_unit({}, "rad", {"arcmin", units::arcmin}); }

std::string with_unit(std::string_view label, const DisplayUnit& unit) {
  return fmt::format("{} [{}]", label, unit.text);
}

std::string number_and_unit(double value, const DisplayUnit& unit) {
  return fmt::format("{} {}", shown_number(value / unit.in_si, 5), unit.text);
}

std::string axis_label(std::string_view label, const DisplayUnit& unit) {
  const std::string text = typeset_unit(unit.text);
  return text.empty() ? std::string(label) : fmt::format("{} [{}]", label, text);
}

const std::optional<CriticalSize>& critical_size(const StrengthState& state) {
  return state.critical_size ? state.critical_size : state.brittle_size;
}

}  // namespace strainwave

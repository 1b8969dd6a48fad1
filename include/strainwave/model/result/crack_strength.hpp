// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Answer of the failure assessment.
enum class StrengthVerdict {
  acceptable,   ///< inside the assessment line
  fractures,    ///< outside it
  collapses,    ///< the net section is fully plastic before the crack runs
  cannot_tell,  ///< not beyond the line, but a property or a stress is not known
};
template <>
struct EnumNames<StrengthVerdict> {
  static constexpr std::array<std::string_view, 4> names = {"acceptable", "fractures", "collapses",
                                                            "cannot_tell"};
};

/// Sense of the torque that a number belongs to.
enum class TorqueSense { positive, negative };
template <>
struct EnumNames<TorqueSense> {
  static constexpr std::array<std::string_view, 2> names = {"positive", "negative"};
};

/// Size of a crack at which a criterion is reached, the crack keeping its shape.
struct CriticalSize {
  /// Depth or half length, as the crack states its size [m]; absent: not reached in the range.
  std::optional<double> size = {};
  /// Where there is no size because the range ends first: its end [m].
  std::optional<double> none_up_to = {};
  std::string text = {};  ///< where there is no size: why
};

/// One crack under one sense of torque, with or without the stress of the assembly.
struct StrengthState {
  TorqueSense sense = TorqueSense::positive;
  bool with_assembly = false;  ///< with the wall's bending by the wave generator, worst in a turn
  double K_load = 0.0;         ///< equivalent K of the load alone, worst point [Pa*m^0.5]
  double K_assembly = 0.0;     ///< equivalent K of the assembly alone, worst point [Pa*m^0.5]
  double K = 0.0;              ///< equivalent K of both together, elastic, worst point [Pa*m^0.5]
  std::optional<double> relative_uncertainty = {};  ///< of K [-]
  std::optional<double> utilisation = {};           ///< K/K_Ic [-]
  std::optional<double> L_r = {};                   ///< reference stress over yield strength [-]
  std::optional<double> interaction = {};           ///< V, on the K of the assembly [-]
  std::optional<double> K_r = {};      ///< K with V on the assembly's part, over K_Ic [-]
  std::optional<double> line = {};     ///< f(L_r): the largest K_r that is accepted [-]
  std::optional<double> L_r_max = {};  ///< end of the line [-]
  /// Factor on the given load at which the line is reached [-]; 0: the assembly alone is beyond it.
  /// Of the stresses that are known; absent for a crack inside the line but beyond the range.
  std::optional<double> reserve = {};
  std::optional<double> plastic_zone = {};         ///< radius [m]
  std::optional<CriticalSize> brittle_size = {};   ///< at which K reaches K_Ic
  std::optional<CriticalSize> critical_size = {};  ///< at which the line is reached
  StrengthVerdict verdict = StrengthVerdict::cannot_tell;
  std::string unknown = {};    ///< what is missing, where the verdict is cannot_tell
  std::string next_step = {};  ///< what would tell, where the verdict is cannot_tell

  [[nodiscard]] bool breaks() const {
    return verdict == StrengthVerdict::fractures || verdict == StrengthVerdict::collapses;
  }
};

/// What a verdict leaves out.
struct StrengthNote {
  std::string text;
  std::string equation;  ///< tag of the theory manual
};

/// Strength of one crack at the given load, with its evidence.
struct CrackStrength {
  std::string path = {};                 ///< "flexspline.crack[0]"
  std::string kind = {};                 ///< "through"
  std::string material = {};             ///< name of the material
  std::string size_name = {};            ///< "depth" or "half_length"
  double size = 0.0;                     ///< present size [m]
  std::optional<double> toughness = {};  ///< K_Ic [Pa*m^0.5]
  std::optional<double> ligament = {};   ///< what is left of the section [m]
  /// Given sense of torque first, load alone before load and assembly; then the other sense where
  /// it differs.  Empty where the crack's stress is not known.
  std::vector<StrengthState> states = {};
  std::size_t governing = 0;  ///< the worst state under either sense of torque
  StrengthVerdict verdict = StrengthVerdict::cannot_tell;  ///< of that state
  std::string sentence = {};                               ///< the verdict in words
  std::string next_step = {};               ///< what would tell, where the verdict is cannot_tell
  std::vector<StrengthNote> notes = {};     ///< what the verdict leaves out
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  [[nodiscard]] const StrengthState* worst() const {
    return states.empty() ? nullptr : &states[governing];
  }
  /// The least reserve of all states [-]; absent where none has one.
  [[nodiscard]] std::optional<double> least_reserve() const {
    std::optional<double> least;
    for (const StrengthState& state : states)
      if (state.reserve) least = std::min(least.value_or(*state.reserve), *state.reserve);
    return least;
  }
  /// Whether it fractures or collapses under either sense of torque.
  [[nodiscard]] bool breaks() const {
    return verdict == StrengthVerdict::fractures || verdict == StrengthVerdict::collapses;
  }
};

/// All cracks in a line: "3 of 4 cracks hold, 1 fractures or collapses, 0 cannot be told".
[[nodiscard]] inline std::string strength_summary(std::span<const CrackStrength> cracks) {
  const auto held =
      std::ranges::count(cracks, StrengthVerdict::acceptable, &CrackStrength::verdict);
  const auto broken = std::ranges::count_if(cracks, &CrackStrength::breaks);
  const auto all = std::ssize(cracks);
  return std::to_string(held) + " of " + std::to_string(all) + (all == 1 ? " crack" : " cracks") +
         (held == 1 ? " holds, " : " hold, ") + std::to_string(broken) +
         (broken == 1 ? " fractures or collapses, " : " fracture or collapse, ") +
         std::to_string(all - held - broken) + " cannot be told";
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/quantity.hpp"

namespace strainwave {

/// Verdict of the failure assessment on a crack.
enum class StrengthVerdict {
  acceptable,   ///< the point is inside the assessment line
  fractures,    ///< the point is outside the line
  collapses,    ///< the net section becomes fully plastic before the crack grows
  cannot_tell,  ///< the point is not beyond the line, but a property or a stress is unknown
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

/// Size at which a crack that keeps its shape reaches a criterion.
struct CriticalSize {
  /// Depth or half length, as the crack states its size [m]; absent: not reached in the range.
  std::optional<double> size = {};
  /// End of the range if the range ends before the criterion is reached [m].
  std::optional<double> none_up_to = {};
  std::string text = {};  ///< reason why there is no size; else empty

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"size", "m", "depth or half length; absent: not reached in the range"},
          &CriticalSize::size);
    field({"none_up_to", "m", "end of the range, if the criterion is not reached in the range"},
          &CriticalSize::none_up_to);
    field({"text", "", "reason why there is no size; else empty"}, &CriticalSize::text);
  }
};

/// One crack under one sense of torque, with or without the stress of the assembly.
struct StrengthState {
  TorqueSense sense = TorqueSense::positive;
  /// include bending of the wall by the wave generator, worst case in a turn
  bool with_assembly = false;
  double K_load = 0.0;      ///< equivalent K of the load alone at the worst point [Pa*m^0.5]
  double K_assembly = 0.0;  ///< equivalent K of the assembly alone at the worst point [Pa*m^0.5]
  /// equivalent elastic K of load and assembly together at the worst point [Pa*m^0.5]
  double K = 0.0;
  std::optional<double> relative_uncertainty = {};  ///< relative uncertainty of K [-]
  std::optional<double> utilisation = {};           ///< K/K_Ic [-]
  std::optional<double> L_r = {};                   ///< reference stress over yield strength [-]
  std::optional<double> interaction = {};           ///< factor V on the K of the assembly [-]
  std::optional<double> K_r = {};      ///< K with V on the assembly's part, over K_Ic [-]
  std::optional<double> line = {};     ///< f(L_r), the largest accepted K_r [-]
  std::optional<double> L_r_max = {};  ///< end of the line [-]
  /// Factor on the given load at which the line is reached [-]; 0 if the assembly alone is beyond
  /// the line.  Only known stresses count.  Absent for a crack inside the line but beyond the
  /// range.
  std::optional<double> reserve = {};
  std::optional<double> plastic_zone = {};         ///< radius [m]
  std::optional<CriticalSize> brittle_size = {};   ///< size at which K reaches K_Ic
  std::optional<CriticalSize> critical_size = {};  ///< size at which the line is reached
  StrengthVerdict verdict = StrengthVerdict::cannot_tell;
  std::string unknown = {};    ///< missing input if the verdict is cannot_tell
  std::string next_step = {};  ///< step that leads to a verdict if it is cannot_tell

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = StrengthState;
    field({"torque", "", "sense of the torque"}, &S::sense);
    field({"with_assembly", "", "whether bending of the wall by the wave generator is included"},
          &S::with_assembly);
    field({"verdict", "", "verdict of the failure assessment"}, &S::verdict);
    field({"unknown", "", "missing input if the verdict is cannot_tell"}, &S::unknown);
    field({"K_load", "Pa*m^0.5", "equivalent K of the load alone at the worst point"},
          [](const S& s) {
            return Quantity{s.K_load, "Pa*m^0.5", s.relative_uncertainty};
          });
    field({"K_assembly", "Pa*m^0.5", "equivalent K of the assembly alone at the worst point"},
          &S::K_assembly);
    field({"K", "Pa*m^0.5", "equivalent K of load and assembly together at the worst point"},
          &S::intensity);
    field({"utilisation", "1", "K/K_Ic"}, &S::toughness_used);
    field({"L_r", "1", "reference stress over yield strength"}, &S::L_r);
    field({"interaction", "1", "factor V on the K of the assembly"}, &S::interaction);
    field({"K_r", "1", "K with V on the assembly's part, over K_Ic"}, &S::K_r);
    field({"line", "1", "f(L_r), the largest accepted K_r"}, &S::line);
    field({"reserve", "1", "factor on the given load at which the line is reached"}, &S::reserve);
    field({"plastic_zone", "m", "radius of the plastic zone"}, &S::plastic_zone);
    field({"brittle_size", "", "size at which K reaches K_Ic"}, &S::brittle_size);
    field({"critical_size", "", "size at which the line is reached"}, &S::critical_size);
  }
  /// K with its uncertainty [Pa*m^0.5].
  [[nodiscard]] Quantity intensity() const { return {K, "Pa*m^0.5", relative_uncertainty}; }
  /// K/K_Ic with its uncertainty [-].
  [[nodiscard]] std::optional<Quantity> toughness_used() const {
    if (!utilisation) return std::nullopt;
    return Quantity{*utilisation, "1", relative_uncertainty};
  }

  /// Whether the crack fractures or collapses in this state.
  [[nodiscard]] bool breaks() const {
    return verdict == StrengthVerdict::fractures || verdict == StrengthVerdict::collapses;
  }
};

/// An effect that a verdict leaves out.
struct StrengthNote {
  std::string text;
  std::string equation;  ///< tag of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"text", "", "effect that the verdict leaves out"}, &StrengthNote::text);
    field({"equation", "", "tag of the theory manual"}, &StrengthNote::equation);
  }
};

/// Strength of one crack at the given load, with its evidence.
struct CrackStrength {
  std::string path = {};                 ///< "flexspline.crack[0]"
  std::string kind = {};                 ///< "through"
  std::string material = {};             ///< name of the material
  std::string size_name = {};            ///< "depth" or "half_length"
  double size = 0.0;                     ///< present size [m]
  std::optional<double> toughness = {};  ///< K_Ic [Pa*m^0.5]
  std::optional<double> ligament = {};   ///< remaining thickness of the section [m]
  /// States under the given sense of torque first, with the load alone before load and assembly.
  /// The other sense follows if it differs.  Empty if the stress of the crack is unknown.
  std::vector<StrengthState> states = {};
  std::size_t governing = 0;  ///< the worst state under either sense of torque
  StrengthVerdict verdict = StrengthVerdict::cannot_tell;  ///< verdict of the governing state
  std::string sentence = {};                               ///< the verdict in words
  std::string next_step = {};               ///< what to do if the verdict is not acceptable
  std::vector<StrengthNote> notes = {};     ///< effects that the verdict leaves out
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  /// Describes the numbers of the worst state first, which are outputs, then all states.
  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = CrackStrength;
    const auto worst = [&](const Field& what, auto member) {
      field(what, [member](const C& c) {
        using Value = std::decay_t<std::invoke_result_t<decltype(member), const StrengthState&>>;
        using Optional = std::conditional_t<is_optional<Value>, Value, std::optional<Value>>;
        const StrengthState* const state = c.worst();
        return state == nullptr ? Optional() : Optional(std::invoke(member, *state));
      });
    };
    const auto size = [](std::optional<CriticalSize> StrengthState::*member) {
      return [member](const StrengthState& state) {
        return state.*member ? (state.*member)->size : std::optional<double>();
      };
    };
    worst({"K", "Pa*m^0.5", "equivalent K at the worst point in the worst state"},
          &StrengthState::intensity);
    worst({"utilisation", "1", "K/K_Ic"}, &StrengthState::toughness_used);
    worst({"L_r", "1", "reference stress over yield strength"}, &StrengthState::L_r);
    worst({"K_r", "1", "K over K_Ic, with the interaction of the assembly"}, &StrengthState::K_r);
    worst({"line", "1", "largest accepted K_r"}, &StrengthState::line);
    field({"reserve", "1", "least factor on the load at which the line is reached"},
          &C::least_reserve);
    worst({"brittle_size", "m", "size at which K reaches K_Ic"},
          size(&StrengthState::brittle_size));
    worst({"critical_size", "m", "size at which the line is reached"},
          size(&StrengthState::critical_size));
    worst({"plastic_zone", "m", "radius of the plastic zone"}, &StrengthState::plastic_zone);
    field({"ligament", "m", "remaining thickness of the section"}, &C::ligament);
    field({"verdict", "", "verdict of the failure assessment"}, &C::verdict);
    field({"sentence", "", "the verdict in words"}, &C::sentence);
    field({"size_name", "", "depth or half_length"}, &C::size_name);
    field({.name = "size", .unit = "m", .doc = "present size", .detail = true}, &C::size);
    field({"material", "", "name of the material"}, &C::material);
    field({.name = "toughness", .unit = "Pa*m^0.5", .doc = "K_Ic", .detail = true}, &C::toughness);
    field({.name = "governing", .unit = "", .doc = "index of the worst state", .detail = true},
          &C::governing);
    field({.name = "states",
           .unit = "",
           .doc = "each sense of torque, load alone and with the assembly",
           .detail = true},
          &C::states);
    field(
        {.name = "notes", .unit = "", .doc = "effects that the verdict leaves out", .detail = true},
        &C::notes);
    field({.name = "equations", .unit = "", .doc = "tags of the theory manual", .detail = true},
          &C::equations);
  }

  /// The governing state; null if there is no state.
  [[nodiscard]] const StrengthState* worst() const {
    return states.empty() ? nullptr : &states[governing];
  }
  /// The least reserve of all states [-]; absent if no state has a reserve.
  [[nodiscard]] std::optional<double> least_reserve() const {
    std::optional<double> least;
    for (const StrengthState& state : states)
      if (state.reserve) least = std::min(least.value_or(*state.reserve), *state.reserve);
    return least;
  }
  /// Whether the crack fractures or collapses under either sense of torque.
  [[nodiscard]] bool breaks() const {
    return verdict == StrengthVerdict::fractures || verdict == StrengthVerdict::collapses;
  }
};

/// All cracks in one line: "3 of 4 cracks hold, 1 fractures or collapses, 0 cannot be told".
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

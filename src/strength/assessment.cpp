// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "assessed_crack.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/strength/failure_assessment.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// uncertainty of K under the assembly, by Newman and Raju's fit
constexpr double kBendingAccuracy = 0.05;

/// K_I, K_II, K_III at one point of the front [Pa*m^0.5]; K_I < 0 means pressed faces.
struct FrontModes {
  Modes load{};      ///< modes from the given load
  Modes assembly{};  ///< modes from the assembly, where its hoop stress is tensile
};

/// Modes of the load times a factor with those of the assembly times a factor; for pressed faces,
/// mode I is zero.
Modes sum(const FrontModes& modes, double load, double assembly) {
  Modes K{};
  for (std::size_t m = 0; m < 3; ++m) K[m] = load * modes.load[m] + assembly * modes.assembly[m];
  K[0] = std::max(K[0], 0.0);  // (FR-17)
  return K;
}

/// K along the front of a crack at one size, computed once for each state of the faces.
class Fronts {
 public:
  /// @param known  K that is known already, which takes what is computed here; null: there is none
  Fronts(const DriveCrack& crack, const CrackSize& size, FrontsAtSize* known = nullptr)
      : crack_(crack), size_(size), known_(known) {}
  [[nodiscard]] const CrackSize& size() const { return size_; }
  [[nodiscard]] const std::vector<FrontIntensity>& with(Faces faces) {
    FrontsAtSize& fronts = known_ != nullptr ? *known_ : own_;
    auto& front = faces == Faces::pressed ? fronts.pressed : fronts.open;
    if (!front) front = crack_.front(size_, faces);
    return *front;
  }

 private:
  const DriveCrack& crack_;
  CrackSize size_;
  FrontsAtSize* known_;
  FrontsAtSize own_ = {};
};

Faces faces_under(const DriveCrack& crack, TorqueSense sense) {
  return sense == TorqueSense::positive ? crack.faces.positive : crack.faces.negative;
}

/// K under the given load along the front of the crack, under T or -T.
std::vector<FrontModes> under_load(const DriveCrack& crack, Fronts& fronts, double P, double T,
                                   TorqueSense sense) {
  const Faces faces = faces_under(crack, sense);
  const auto modes = [&](const UnitStressIntensity<2>& k) -> Modes {
    return {k.I[kAxial] * P + k.I[kTorsion] * T, k.II[kAxial] * P + k.II[kTorsion] * T,
            k.III[kAxial] * P + k.III[kTorsion] * T};
  };
  std::vector<FrontModes> front;
  if (crack.group &&
      faces != Faces::pressed) {  // the faces of the other cracks depend on the sense
    for (const FrontIntensity& at : crack.front_in_group(fronts.size(), sense))
      front.push_back({modes(at.load), at.assembly});
    return front;
  }
  for (const FrontIntensity& at : fronts.with(Faces::open))
    front.push_back({modes(at.load), at.assembly});
  if (faces != Faces::pressed) return front;
  // (FR-17): pressed faces carry the normal stress, so only the shear stress makes them slide.
  const std::vector<FrontIntensity> pressed =
      crack.group ? crack.front_in_group(fronts.size(), sense) : fronts.with(Faces::pressed);
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Modes sliding = modes(pressed[i].load);
    front[i].load = {std::min(front[i].load[0], 0.0), sliding[1], sliding[2]};
  }
  return front;
}

/// A crack at one size, under one sense of torque.
class AtSize {
 public:
  AtSize(const AssessedCrack& asked, double size, TorqueSense sense, bool with_assembly)
      : AtSize(asked, Fronts(asked.crack, grown(asked.crack, size)), sense, with_assembly) {}
  AtSize(const AssessedCrack& asked, Fronts&& fronts, TorqueSense sense, bool with_assembly)
      : AtSize(asked, fronts, sense, with_assembly) {}
  /// @param fronts  of the crack; K that is known there is not computed again
  AtSize(const AssessedCrack& asked, Fronts& fronts, TorqueSense sense, bool with_assembly)
      : crack_(asked.crack), with_assembly_(with_assembly) {
    const bool positive = sense == TorqueSense::positive;
    const double P = asked.load.axial_force;
    const double magnitude = std::abs(asked.load.torque);
    const double T = positive || !crack_.reverses ? magnitude : -magnitude;
    front_ = under_load(crack_, fronts, P, T, sense);
    reference_stress_ = crack_.reference_stress(fronts.size(), P, T);
    K_load_ = K_of(1, 0);
    if (!with_assembly || !crack_.turn_table) return;
    torque_ = T;
    turn_.emplace(*crack_.turn_table, fronts.size().size, crack_.size.aspect_ratio);
    if (crack_.turn_table->covers(0))
      for (std::size_t i = 0; i < turn_->stations(); ++i)
        without_torque_.push_back(turn_->at(i, 0));
  }
  /// The same crack and sense without the assembly.
  [[nodiscard]] AtSize load_alone() const {
    AtSize alone = *this;
    alone.with_assembly_ = false;
    alone.turn_.reset();
    alone.without_torque_.clear();
    return alone;
  }

  /// Largest equivalent K, by energy release rate, along the front and over a turn [Pa*m^0.5].
  [[nodiscard]] double K(double load, double assembly) const {
    // K of the load alone is in proportion to the load.
    return assembly == 0 ? load * K_load_ : K_of(load, assembly);
  }
  [[nodiscard]] double K_load() const { return K_load_; }
  [[nodiscard]] double K_assembly() const {
    const bool known = with_assembly_ && (!turn_ || !without_torque_.empty());
    return known ? K(0, 1) : 0.0;
  }
  [[nodiscard]] double K_together() const { return K(1, assembly()); }
  /// Largest K, if the assembly acts with at most a factor, or infinite if none is known; as
  /// energies are squares of lengths of (K_I, K_II, K_III), K of a sum is at most the sum of the K.
  [[nodiscard]] double most_K(double load, double assembly, double K_assembly) const {
    return turn_ ? std::numeric_limits<double>::infinity() : load * K_load_ + assembly * K_assembly;
  }

  [[nodiscard]] double plastic_zone(double yield_strength) const {
    const double eta = crack_.constraint == sif::Constraint::plane_stress ? 2 : 6;
    double largest = 0.0;
    for_each_state(1, assembly(), [&](const Modes& K) {
      const double opened = K[0] * K[0] / eta;
      const double sheared = 3 * (K[1] * K[1] + K[2] * K[2]) / 2;
      largest = std::max(largest, opened + sheared);
    });
    return largest / (pi * yield_strength * yield_strength);  // (FR-19)
  }

  [[nodiscard]] double reference_stress() const { return reference_stress_; }
  [[nodiscard]] bool with_assembly() const { return with_assembly_; }

  /// Factors on the load between which K is known: all, unless a table gives K over the turn.
  [[nodiscard]] std::array<double, 2> known_loads() const {
    if (!turn_) return {0.0, std::numeric_limits<double>::infinity()};
    return turn_load_range(*crack_.turn_table, torque_);
  }

 private:
  [[nodiscard]] static CrackSize grown(const DriveCrack& crack, double size) {
    return {.size = size, .aspect_ratio = crack.size.aspect_ratio};
  }
  [[nodiscard]] double assembly() const { return with_assembly_ ? 1.0 : 0.0; }
  [[nodiscard]] double K_of(double load, double assembly) const {
    double G = 0.0;
    for_each_state(load, assembly, [&](const Modes& K) {
      G = std::max(G, energy_release_rate(K[0], K[1], K[2], crack_.moduli));
    });
    return std::sqrt(G * crack_.moduli.opening);  // (FR-20)
  }

  template <class F>
  void for_each_state(double load, double assembly, const F& f) const {
    if (turn_ && assembly != 0) {
      // The stress of the assembly is K without torque; (GR-30).
      for (std::size_t i = 0; i < turn_->stations(); ++i) {
        const std::vector<Modes> turn = turn_->at(i, load * torque_);
        for (std::size_t k = 0; k < turn.size(); ++k)
          f(sum({.load = turn[k],
                 .assembly = without_torque_.empty() ? Modes{} : without_torque_[i][k]},
                1, assembly - 1));
      }
      return;
    }
    // G is convex in the phase of the assembly, so its largest value is at one of the two extremes.
    for (const FrontModes& modes : front_) {
      f(sum(modes, load, assembly));
      if (assembly != 0) f(sum(modes, load, -assembly));
    }
  }

  const DriveCrack& crack_;
  std::vector<FrontModes> front_;
  double reference_stress_ = 0.0;
  double K_load_ = 0.0;  // K of the load alone
  bool with_assembly_;
  double torque_ = 0.0;                             // with its sense
  std::optional<TurnFactors> turn_;                 // with the assembly, if the crack has a table
  std::vector<std::vector<Modes>> without_torque_;  // of each station; empty: not in the table
};

/// A crack at one size in the diagram, at any multiple of the given load.
class InDiagram {
 public:
  InDiagram(const AtSize& crack, const AssessmentMaterial& material, double toughness)
      : crack_(crack), material_(material), toughness_(toughness) {
    const double K_p = crack.K_load();
    const double K_s = crack.K_assembly();
    // If the load does not cause K at the crack, chi is infinite.
    K_assembly_ = K_s;
    chi_ = K_s == 0  ? 0.0
           : K_p > 0 ? K_s * L_r(1.0) / K_p
                     : std::numeric_limits<double>::infinity();  // (FA-3)
    L_r_max_ = collapse_limit(material);
  }

  [[nodiscard]] double L_r(double load) const {
    return load * crack_.reference_stress() / material_.yield_strength;  // (FA-6)
  }
  [[nodiscard]] double interaction(double load) const {
    return crack_.with_assembly() ? plasticity_interaction(chi_, L_r(load)) : 1.0;
  }
  [[nodiscard]] double K_r(double load) const {
    const double V = crack_.with_assembly() ? interaction(load) : 0.0;
    return crack_.K(load, V) / toughness_;  // (FA-3)
  }
  [[nodiscard]] double line(double load) const { return assessment_line(L_r(load), material_); }
  [[nodiscard]] double collapse_at() const { return L_r_max_; }
  [[nodiscard]] double chi() const { return chi_; }
  /// Distance from the line; 0 or more means outside.
  [[nodiscard]] double beyond(double load) const {
    return L_r(load) > L_r_max_ ? 1.0 : K_r(load) - line(load);
  }

  [[nodiscard]] StrengthVerdict verdict() const {
    if (beyond(1.0) < 0) return StrengthVerdict::acceptable;
    return L_r(1.0) > L_r_max_ && K_r(1.0) < 1 ? StrengthVerdict::collapses
                                               : StrengthVerdict::fractures;  // (FA-13)
  }

  /// Factor on the load at which the point reaches the line; absent if the load does not stress the
  /// crack.
  [[nodiscard]] std::optional<double> reserve() const {
    if (!(L_r(1.0) > 0)) return std::nullopt;
    const std::array<double, 2> known = crack_.known_loads();
    const double least = known[0];
    const double most = known[1];
    const double collapse = L_r_max_ / L_r(1.0);
    // At `least` K begins to be known; it is 0 unless a table begins later.
    if (beyond(least) >= 0) return std::min(least, collapse);
    const double end = std::min(collapse, most);
    // A load that presses the crack may reduce K_r at first, so search for the first crossing.
    constexpr int kSteps = 32;
    const auto step = [&](int i) {
      // Rounding must not carry the last step past the end of the line.
      return i == 0 ? least
                    : least + (end - least) *
                                  (i == kSteps ? 1 - 1e-15 : static_cast<double>(i) / kSteps);
    };
    // A bound of K_r rises with the load and the line falls, so up to the last step at which the
    // bound is inside, all are.
    int inside = 0;
    for (int beyond_bound = kSteps + 1; beyond_bound - inside > 1;) {
      const int middle = (inside + beyond_bound) / 2;
      (bound_is_inside(step(middle)) ? inside : beyond_bound) = middle;
    }
    for (int i = inside + 1; i <= kSteps; ++i)
      if (beyond(step(i)) >= 0)
        return bracketed_root([&](double x) { return beyond(x); }, step(i - 1),
                              step(i));  // (FA-4)
    return end;                          // (FA-4)
  }

 private:
  /// Whether K_r is below the line even if the assembly acts with the largest factor.
  [[nodiscard]] bool bound_is_inside(double load) const {
    constexpr double kMost = 1.05;       // largest L_r at which the factor is not 1 (FA-3)
    constexpr double kRounding = 1e-12;  // of the bound, far above that of K
    const double x = std::min(chi_, kMaxInteractionRatio);
    const double most_V =
        crack_.with_assembly() ? 1 + 0.2 * kMost + 0.02 * x * (1 + 2 * kMost) : 0.0;  // (FA-3)
    return L_r(load) <= L_r_max_ &&
           crack_.most_K(load, most_V, K_assembly_) < line(load) * toughness_ * (1 - kRounding);
  }

  const AtSize& crack_;
  AssessmentMaterial material_;
  double toughness_;
  double K_assembly_ = 0.0;
  double chi_ = 0.0;
  double L_r_max_ = 1.0;
};

/// The smallest size up to the end of the range at which `beyond` is not negative.
template <class Beyond>
CriticalSize first_size(const DriveCrack& crack, const char* at_once, const Beyond& beyond) {
  constexpr int kSteps = 24;
  constexpr double kSmallest = 1e-4;  // share of the range
  const double end = crack.range_end;
  const double smallest = std::max(kSmallest, crack.range_begin / end);
  if (smallest >= 1)
    return {.text = "not known, because the table begins beyond the range of the solution"};
  double inside = smallest * end;
  if (beyond(inside) >= 0)
    return {.text = smallest > kSmallest ? "below the smallest size of the table" : at_once};
  for (int i = 1; i <= kSteps; ++i) {
    const double size = i == kSteps ? end : end * std::pow(smallest, 1 - double{1} * i / kSteps);
    if (beyond(size) >= 0) return {.size = bracketed_root(beyond, inside, size)};  // (FA-5)
    inside = size;
  }
  return {.none_up_to = end,
          .text = fmt::format("none up to {}, {}", shown_quantity(end, "m", 3), crack.range_text)};
}

/// Relative uncertainty of K under load and assembly together [-]; the errors of the two parts are
/// independent.
std::optional<double> uncertainty(const AssessedCrack& asked, const StrengthState& state) {
  if (state.with_assembly && asked.crack.turn_table) return std::nullopt;  // the table states none
  if (!state.with_assembly || !asked.relative_uncertainty || !(state.K > 0))
    return asked.relative_uncertainty;
  return std::hypot(*asked.relative_uncertainty * state.K_load,
                    kBendingAccuracy * state.K_assembly) /
         state.K;  // (FA-13)
}

void cannot_tell(StrengthState& state, std::string unknown, std::string next_step) {
  state.verdict = StrengthVerdict::cannot_tell;
  state.unknown = std::move(unknown);
  state.next_step = std::move(next_step);
}

/// Names the properties that the material lacks, and requests them.
void ask_for_properties(StrengthState& state, const DriveCrack& crack, const Material& material) {
  if (crack.laminate) {
    cannot_tell(state, crack.unknown, crack.next_step);
    return;
  }
  const bool toughness = material.fracture_toughness.has_value();
  if (toughness && material.yield_strength) return;
  const std::string name = "material." + crack.material;
  const char* const unknown = material.yield_strength ? "fracture_toughness"
                              : toughness             ? "yield_strength"
                                                      : "fracture_toughness and no yield_strength";
  const char* const wanted = material.yield_strength ? "fracture_toughness"
                             : toughness             ? "yield_strength"
                                                     : "fracture_toughness and yield_strength";
  cannot_tell(
      state, fmt::format("{} gives no {}", name, unknown),
      material.in_file()
          ? fmt::format("Give {} of {} in the file.", wanted, name)
          : fmt::format("Add [material.\"{0}\"] with based_on = \"{0}\" and your {1} to the file.",
                        crack.material, wanted));
}

/// K of a state that proves a fracture where it reaches the toughness [Pa*m^0.5].  An upper bound
/// of the bending does not prove that a crack of a laminate fractures (LA-20).
double proving_factor(const DriveCrack& crack, const AtSize& at) {
  return crack.laminate && at.with_assembly() ? at.K_load() : at.K_together();
}

/// Adds K and the results that follow without the assessment line.
void add_intensities(StrengthState& state, const AssessedCrack& asked, const AtSize& present) {
  state.K_load = present.K_load();
  state.K_assembly = present.K_assembly();
  state.K = present.K_together();
  state.relative_uncertainty = uncertainty(asked, state);
  if (asked.material.yield_strength)
    state.plastic_zone = present.plastic_zone(*asked.material.yield_strength);
  const std::optional<double>& K_Ic = asked.crack.toughness;
  if (!K_Ic) return;
  state.utilisation = state.K / *K_Ic;  // (FR-20)
  if (asked.with_sizes)
    state.brittle_size =
        first_size(asked.crack, "beyond the toughness even without a crack", [&](double size) {
          return AtSize(asked, size, state.sense, state.with_assembly).K_together() / *K_Ic - 1;
        });
  if (proving_factor(asked.crack, present) / *K_Ic >= 1)
    state.verdict = StrengthVerdict::fractures;  // (FA-13)
}

/// Records why a point inside the line does not prove that the crack holds; (FA-13).
void doubt(StrengthState& state, const AssessedCrack& asked, const InDiagram& point) {
  const DriveCrack& crack = asked.crack;
  if (clearly_less(crack.range_end, crack.size.size)) {
    state.reserve.reset();  // the reserve at the end of the range would be too large
    cannot_tell(state,
                fmt::format("the crack is larger than {}, {}",
                            shown_quantity(crack.range_end, "m", 3), crack.range_text),
                "Assess so large a crack by finite elements, because no field of the file makes an "
                "assessment possible.");
  } else if (state.with_assembly && point.chi() > kMaxInteractionRatio &&
             crack.assembly_peak > *asked.material.yield_strength) {
    cannot_tell(
        state,
        "the elastic stress of the assembly alone exceeds the yield strength, which is outside the "
        "range of the plasticity interaction (FA-3)",
        "Check drive.radial_displacement and the wall's thickness against the part; if they "
        "are right, judge the crack by elastic-plastic finite elements.");
  } else if (!crack.unknown.empty()) {
    cannot_tell(state,
                crack.unknown +
                    (state.reserve ? fmt::format("; by the {}: reserve factor {:.3g}",
                                                 state.with_assembly ? "load and the wall's bending"
                                                                     : "load alone",
                                                 *state.reserve)
                                   : std::string()),
                crack.next_step);
  }
}

/// @param material  has a yield strength
AssessmentMaterial line_material(const Material& material) {
  return {.youngs_modulus = material.youngs_modulus.value(),
          .yield_strength = *material.yield_strength,
          .ultimate_strength = material.ultimate_strength};
}

StrengthState state_of(const AssessedCrack& asked, TorqueSense which, const AtSize& present) {
  const DriveCrack& crack = asked.crack;
  const Material& material = asked.material;
  const bool with_assembly = present.with_assembly();
  StrengthState state{.sense = which, .with_assembly = with_assembly};
  ask_for_properties(state, crack, material);
  add_intensities(state, asked, present);
  if (!material.yield_strength) return state;

  const AssessmentMaterial steel = line_material(material);
  // Without a toughness only collapse can be assessed, so assume a very tough material.
  const double K_Ic = material.fracture_toughness.value_or(std::numeric_limits<double>::infinity());
  const InDiagram point(present, steel, K_Ic);
  state.L_r = point.L_r(1.0);
  state.line = point.line(1.0);
  state.L_r_max = point.collapse_at();
  if (!material.fracture_toughness) {
    if (*state.L_r > point.collapse_at()) state.verdict = StrengthVerdict::collapses;
    return state;
  }
  if (with_assembly) state.interaction = point.interaction(1.0);
  state.K_r = point.K_r(1.0);
  state.reserve = point.reserve();
  state.verdict = point.verdict();
  if (asked.with_sizes)
    state.critical_size =
        first_size(crack, "beyond the line even without a crack", [&](double size) {
          const AtSize crack_at(asked, size, which, with_assembly);
          return InDiagram(crack_at, steel, K_Ic).beyond(1.0);
        });
  if (state.verdict == StrengthVerdict::acceptable) doubt(state, asked, point);
  return state;
}

/// Rank of a verdict; a worse verdict gets a larger rank.
int badness(const StrengthState& state) {
  switch (state.verdict) {
    case StrengthVerdict::acceptable:
      return 0;
    case StrengthVerdict::cannot_tell:
      return 1;
    case StrengthVerdict::collapses:
    case StrengthVerdict::fractures:
      return 2;
  }
  return 0;
}

bool worse(const StrengthState& a, const StrengthState& b) {
  if (badness(a) != badness(b)) return badness(a) > badness(b);
  if (a.reserve && b.reserve && *a.reserve != *b.reserve) return *a.reserve < *b.reserve;
  return a.K > b.K;
}

/// Whether a state is worse by more than rounding; two states that end at the same collapse are
/// equal.
bool clearly_worse(const StrengthState& a, const StrengthState& b) {
  if (badness(a) != badness(b)) return badness(a) > badness(b);
  if (a.reserve && b.reserve) return clearly_less(*a.reserve, *b.reserve);
  return clearly_less(b.K, a.K);
}

std::string shown_intensity(double K) { return shown_quantity(K, "Pa*m^0.5", 3); }

/// The critical size in words: "critical depth 1.23 mm, present 2 mm", or the reason why it is
/// missing.
std::string size_words(const CrackStrength& crack, const StrengthState& state) {
  const std::optional<CriticalSize>& answer =
      state.critical_size ? state.critical_size : state.brittle_size;
  if (!answer) return {};
  const std::string name = crack.size_name == "half_length" ? "half length" : crack.size_name;
  if (answer->size)
    return fmt::format("; critical {} {}, present {}", name, shown_quantity(*answer->size, "m", 3),
                       shown_quantity(crack.size, "m", 3));
  return fmt::format("; critical {}: {}", name, answer->text);
}

std::string beyond_the_end(const StrengthState& state) {
  return fmt::format("L_r = {:.3g} beyond L_r,max = {:.3g}", *state.L_r, *state.L_r_max);
}

/// For a point inside the line, the words "; the line is within the accuracy of K (10 %)" if they
/// apply.
std::string accuracy_words(const StrengthState& state) {
  if (!state.K_r || !state.relative_uncertainty || *state.K_r >= *state.line ||
      *state.K_r * (1 + *state.relative_uncertainty) < *state.line)
    return {};
  return fmt::format("; the line is within the accuracy of K ({:.0f} %)",
                     100 * *state.relative_uncertainty);  // (FA-13)
}

std::string_view word(StrengthVerdict verdict) {
  return verdict == StrengthVerdict::cannot_tell ? "cannot tell" : enum_name(verdict);
}

std::string words(const CrackStrength& crack, const StrengthState& state, TorqueSense given,
                  bool laminate) {
  const std::string sense = state.sense == given
                                ? ""
                                : fmt::format(" under torque of the other sense (T {} 0)",
                                              state.sense == TorqueSense::positive ? '>' : '<');
  const std::string with =
      sense + (state.with_assembly ? " together with the assembly's bending" : "");
  switch (state.verdict) {
    case StrengthVerdict::fractures:
      if (laminate)
        return fmt::format(
            "fractures at this load{}: the energy release rate is {:.3g} times the fracture "
            "energy{}",
            with, *state.utilisation * *state.utilisation, size_words(crack, state));
      if (!state.K_r)
        return fmt::format("fractures at this load{}: K = {} reaches K_Ic{}", with,
                           shown_intensity(state.K), size_words(crack, state));
      if (*state.L_r > *state.L_r_max)
        return fmt::format("fractures at this load{}: K = {}, K_r = {:.3g}, {}{}", with,
                           shown_intensity(state.K), *state.K_r, beyond_the_end(state),
                           size_words(crack, state));
      return fmt::format(
          "fractures at this load{}: K = {}, K_r = {:.3g} against {:.3g} at L_r = "
          "{:.3g}{}",
          with, shown_intensity(state.K), *state.K_r, *state.line, *state.L_r,
          size_words(crack, state));
    case StrengthVerdict::collapses:
      return fmt::format("collapses at this load{}: the net section is fully plastic, {}{}", sense,
                         beyond_the_end(state), size_words(crack, state));
    case StrengthVerdict::acceptable:
      return fmt::format("holds at this load{}{}{}{}", with,
                         state.reserve
                             ? fmt::format(": reserve factor {:.3g}", *state.reserve)
                             : std::string(", because the load does not stress the crack"),
                         accuracy_words(state), size_words(crack, state));
    case StrengthVerdict::cannot_tell:
      break;
  }
  std::string text = fmt::format("cannot tell{}: {}", sense, state.unknown);
  if (state.utilisation && laminate) {
    const double times = *state.utilisation * *state.utilisation;
    const double by_load = state.K_load / state.K * state.K_load / state.K * times;
    text +=
        state.with_assembly
            ? fmt::format(
                  "; the energy release rate is at most {:.3g} times the fracture "
                  "energy, and {:.3g} times without the bending of the plies",
                  times, by_load)
            : fmt::format("; the energy release rate is {:.3g} times the fracture energy", times);
  }
  if (state.utilisation && !laminate) text += fmt::format("; K/K_Ic = {:.3g}", *state.utilisation);
  if (state.L_r) text += fmt::format("; L_r = {:.3g}", *state.L_r);
  return text + accuracy_words(state) + size_words(crack, state);
}

/// A crack at its present size under one sense of torque, with the assembly if that stresses it.
struct PresentCrack {
  PresentCrack(const AssessedCrack& asked, Fronts& fronts, TorqueSense of)
      : sense(of), whole(asked, fronts, of, asked.crack.assembly) {
    if (asked.crack.assembly) alone.emplace(whole.load_alone());
  }
  [[nodiscard]] const AtSize& load_alone() const { return alone ? *alone : whole; }

  TorqueSense sense;
  AtSize whole;
  std::optional<AtSize> alone;
};

/// Whether K or the reference stress of two senses of torque differ.
bool senses_differ(const AtSize& one, const AtSize& other) {
  const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(y); };
  return !close(one.K_together(), other.K_together()) ||
         !close(one.reference_stress(), other.reference_stress());
}

/// Whether reversing the torque changes K or the reference stress of a crack.
bool senses_differ(const AssessedCrack& asked, const PresentCrack& one, const PresentCrack& other) {
  return senses_differ(one.load_alone(), other.load_alone()) ||
         (asked.crack.assembly && senses_differ(one.whole, other.whole));
}

/// Whether both senses of torque load the crack alike, so that it has one answer.
bool same_load(const DriveCrack& crack) {
  return !crack.reverses && !crack.group && !crack.turn_table &&
         crack.faces.positive == crack.faces.negative;
}

/// Whether the verdict of `state_of` is that the crack fractures or collapses.
bool breaks(const AssessedCrack& asked, const AtSize& present) {
  const Material& material = asked.material;
  const std::optional<double>& K_Ic = asked.crack.toughness;
  if (material.yield_strength && material.fracture_toughness) {
    const InDiagram point(present, line_material(material), *material.fracture_toughness);
    return !(point.beyond(1.0) < 0);  // (FA-13)
  }
  if (K_Ic && proving_factor(asked.crack, present) / *K_Ic >= 1) return true;  // (FA-13)
  if (!material.yield_strength) return false;
  const AssessmentMaterial steel = line_material(material);
  return present.reference_stress() / *material.yield_strength > collapse_limit(steel);  // (FA-6)
}
bool breaks(const AssessedCrack& asked, const PresentCrack& present) {
  return breaks(asked, present.load_alone()) ||
         (asked.crack.assembly && breaks(asked, present.whole));
}

/// K along the front of a crack at its present size.
Fronts present_fronts(const AssessedCrack& asked) {
  const DriveCrack& crack = asked.crack;
  return {
      crack,
      {.size = std::min(crack.size.size, crack.range_end), .aspect_ratio = crack.size.aspect_ratio},
      asked.fronts};
}

/// The states under one sense of torque: the load alone, and with the assembly.
std::vector<StrengthState> states_of(const AssessedCrack& asked, const PresentCrack& present) {
  std::vector<StrengthState> of_sense;
  of_sense.push_back(state_of(asked, present.sense, present.load_alone()));
  if (asked.crack.assembly) of_sense.push_back(state_of(asked, present.sense, present.whole));
  for (StrengthState& state : of_sense)
    if (state.verdict != StrengthVerdict::cannot_tell) {
      state.unknown.clear();
      state.next_step.clear();
    }
  return of_sense;
}

/// Index of the worst of some states; of equal states, the first.
std::size_t worst_of(const std::vector<StrengthState>& states, std::size_t first,
                     std::size_t last) {
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i)
    if (worse(states[i], states[at])) at = i;
  return at;
}

}  // namespace

bool breaks(const AssessedCrack& asked) {
  const bool positive = asked.load.torque > 0;
  Fronts fronts = present_fronts(asked);
  const PresentCrack given(asked, fronts, positive ? TorqueSense::positive : TorqueSense::negative);
  if (breaks(asked, given)) return true;
  if (same_load(asked.crack)) return false;
  const PresentCrack other(asked, fronts, positive ? TorqueSense::negative : TorqueSense::positive);
  // As in `assess`, the other sense counts only if it differs by more than rounding.
  return breaks(asked, other) && senses_differ(asked, given, other);
}

CrackStrength assess(const AssessedCrack& asked, CrackStrength result) {
  const TorqueSense given = asked.load.torque > 0 ? TorqueSense::positive : TorqueSense::negative;
  const TorqueSense other =
      given == TorqueSense::positive ? TorqueSense::negative : TorqueSense::positive;
  result.toughness = asked.crack.toughness;
  const DriveCrack& crack = asked.crack;
  Fronts fronts = present_fronts(asked);
  const PresentCrack present(asked, fronts, given);
  result.states = states_of(asked, present);
  const std::size_t n = result.states.size();
  const bool other_known = !crack.turn_table || crack.turn_table->covers(-asked.load.torque);
  if (other_known && !same_load(crack)) {
    const PresentCrack reversed(asked, fronts, other);
    if (senses_differ(asked, present, reversed))
      for (StrengthState& state : states_of(asked, reversed))
        result.states.push_back(std::move(state));
  }

  // The drive may reverse, so take the worst state under either sense, and the given sense if both
  // are equal.
  const std::size_t of_given = worst_of(result.states, 0, n);
  result.governing = of_given;
  if (result.states.size() > n) {
    const std::size_t of_other = worst_of(result.states, n, result.states.size());
    if (clearly_worse(result.states[of_other], result.states[of_given]))
      result.governing = of_other;
  }
  const StrengthState& worst = *result.worst();
  result.verdict = worst.verdict;
  if (!asked.with_words) return result;
  result.sentence = words(result, worst, given, asked.crack.laminate);
  result.next_step = worst.next_step;
  const auto beside = [&](const char* what, const StrengthState& state) {
    result.sentence += fmt::format("; under the {}: {}", what, word(state.verdict));
    if (state.reserve) result.sentence += fmt::format(", reserve factor {:.3g}", *state.reserve);
  };
  const StrengthState& load_alone = result.states[result.governing < n ? 0 : n];
  if (worst.with_assembly && result.verdict != load_alone.verdict && load_alone.reserve)
    beside("load alone", load_alone);
  if (worst.sense != given) beside("given torque", result.states[of_given]);
  return result;
}

}  // namespace strainwave

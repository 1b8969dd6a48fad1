// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/load_cycles.hpp"
#include "strainwave/growth/mixed_mode.hpp"
#include "strainwave/growth_laws/rate_law.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// A crack of a drive as its growth sees it: cycles at its tips, and the rate of its sizes.

namespace strainwave {

/// Choices of the law.
struct RateChoice {
  MixedMode mixed_mode = MixedMode::energy;  ///< rule that makes one K of three modes
  /// Record of the material library whose law replaces that of every material; empty: none.
  std::string law;
};

/// The choice as it applies to a crack: the laws of the library are those of metals, so a laminate
/// keeps its own.
[[nodiscard]] RateChoice choice_of(const DriveCrack& crack, RateChoice choice);

/// Whether the material of a crack states a law of growth.
[[nodiscard]] bool has_law(const GearSet& gear, const DriveCrack& crack);

/// The cycle at a tip between two states of K (GR-22).
///
/// The larger equivalent factor of the two is K_max.  The range is the equivalent of the ranges of
/// the three modes, so R = 1 - Delta K/K_max, and R = -1 for a load that changes its sign.
[[nodiscard]] TipCycle tip_cycle(MixedMode rule, const Modes& from, const Modes& to,
                                 double poissons_ratio);

/// The least factor of a cycle, with its sign [Pa*m^0.5] (GR-22).
///
/// K_min = R K_max of a cycle that opens the crack.  A cycle that does not has no R: its least
/// factor is the equivalent of the sizes of K in its most pressed state, as a negative number.
/// Either is the same where K_max becomes 0.
///
/// @param rule            makes one K of three modes
/// @param cycle           of the moments
/// @param one             K at the moments of the cycle
/// @param other           further moments of the cycle, or none
/// @param poissons_ratio  nu [-]; in (-1, 0.5)
[[nodiscard]] double least_factor(MixedMode rule, const TipCycle& cycle, std::span<const Modes> one,
                                  std::span<const Modes> other, double poissons_ratio);

/// A cycle of the duty at one tip of a crack of a given size.
struct TipLoad {
  TipCycle cycle;        ///< of the phase and the point with the fastest growth
  double count = 0.0;    ///< in one repetition [-]
  std::size_t step = 0;  ///< as LoadCycle::step
  bool rare = false;     ///< as LoadCycle::rare
  bool further = false;  ///< as LoadCycle::further
  /// The cycle of the phase and the point with the largest K_max, if it is not `cycle`
  TipCycle largest = {};
  /// The least factor of `cycle`, with its sign; the least one of all phases and points if the tip
  /// stands still [Pa*m^0.5].  Absent: R K_max
  std::optional<double> least = {};

  /// The cycle whose K_max the toughness must bear.
  [[nodiscard]] const TipCycle& governing() const {
    return largest.largest > cycle.largest ? largest : cycle;
  }
  /// The least factor of the cycle, with its sign [Pa*m^0.5].
  [[nodiscard]] double least_of_cycle() const {
    return least.value_or(cycle.largest > 0 ? cycle.ratio * cycle.largest : cycle.largest);
  }
};

/// How the rate of a crack deviates from its law: by the factor exp(b_0 + b_1 ln(Delta K/pivot));
/// eq. (GS-12).
struct RateDeviation {
  double logarithm = 0.0;  ///< b_0, deviation of ln(da/dN) at the pivot [-]
  double exponent = 0.0;   ///< b_1, deviation of the exponent m [-]
  double pivot = 1.0;      ///< range at which `logarithm` holds [Pa*m^0.5]; > 0
};

/// The ends of a crack that grow.
enum class Tip { depth, length };

/// A crack of a drive under its duty.
class GrowingCrack {
 public:
  /// @param gear       has passed `check` and has a duty
  /// @param crack      of drive_cracks(gear), or the crack that coupled_crack makes
  /// @param history    duty of the drive, as in crack_duty
  /// @param choice     choice_of(crack): law of growth and rule of mixed modes
  /// @param at_torque  the crack at the torques of the duty, if K is not proportional to the
  ///                   torque; ignored for a crack under the balls, whose table the constructor
  ///                   makes
  /// @throws InputError  if its material has no law of growth
  GrowingCrack(const GearSet& gear, DriveCrack crack, const DutyHistory& history,
               const RateChoice& choice, CracksAtTorques at_torque = {});

  /// The crack with which the object was made.
  [[nodiscard]] const DriveCrack& crack() const { return crack_; }
  /// Cycles of the crack's load in one repetition.
  [[nodiscard]] const CrackDuty& duty() const { return duty_; }
  /// Law of growth, for a crack through the wall with its toughness there.
  [[nodiscard]] const RateLaw& law() const { return law_.law(); }
  /// Rule that makes one K of three modes.
  [[nodiscard]] MixedMode mixed_mode() const { return mixed_mode_; }
  /// Threshold and short-crack size of the material or the record, and the toughness of the
  /// material if the law has none.
  [[nodiscard]] const GrowthLimits& limits() const { return limits_; }
  /// The tips that move: depth and length of a surface crack, else the size alone.  A surface crack
  /// whose table of K over a turn has no aspect ratios keeps its shape and grows by its worst
  /// point.
  [[nodiscard]] std::span<const Tip> tips() const;

  /// The cycles of one repetition at each tip, in the order of `tips`.
  /// @param size    a [m] and a/c [-] of the crack
  /// @param factor  on torque, axial force and bending moment of the duty [-]
  [[nodiscard]] std::vector<std::vector<TipLoad>> loads(const CrackSize& size,
                                                        double factor = 1.0) const;
  /// Growth of a tip in one repetition without load interaction [m]; 0 if it stands still, infinite
  /// if the law knows no rate because a cycle breaks the part.
  [[nodiscard]] double growth(std::span<const TipLoad> loads, double crack_size) const;
  /// Growth in one cycle without load interaction [m]; infinite as in `growth`.
  [[nodiscard]] double rate_of(const TipCycle& cycle, double crack_size) const;
  /// Yield strength of the material [Pa].
  /// @throws InputError  if the file does not give it
  [[nodiscard]] double yield_strength() const;
  /// The cycle with the largest K_max of all phases and points.
  [[nodiscard]] static TipCycle governing(std::span<const TipLoad> loads);
  /// The cycle with the largest range.
  [[nodiscard]] TipCycle widest(std::span<const TipLoad> loads) const;
  /// Threshold of the range of a cycle, of the law or of the material [Pa*m^0.5]; absent: none.
  [[nodiscard]] std::optional<double> threshold(const TipCycle& cycle, double crack_size) const;
  /// K at the worst point of the first tip in the state of the duty's largest K_max.
  [[nodiscard]] Modes worst_factors(const CrackSize& size) const;
  /// Whether K_max of any phase and point reaches the toughness of law or material.
  [[nodiscard]] bool breaks(const CrackSize& size, double factor = 1.0) const;

  /// Lets all rates deviate from the law from now on; threshold and toughness stay.
  void deviate(const RateDeviation& deviation);

  /// Largest factor on the loads of the duty at which K is known: up to the end of the table of K
  /// over a turn; infinite without a table [-].
  [[nodiscard]] double largest_factor() const;
  /// Estimate of what the angles of the table of K over a turn miss of the widest range at the size
  /// in the file, as a share of it; 0 without a table [-].
  [[nodiscard]] double missed_by_angles() const;

 private:
  [[nodiscard]] CrackFactors factors(const CrackSize& size) const;
  /// Adds a cycle, or the cycles within a wave, from the table of K over a turn.
  void add_turn(std::vector<TipLoad>& to, const CrackFactors& K,
                std::pair<std::size_t, std::size_t> points, const LoadCycle& cycle,
                const CrackSize& size, double factor) const;
  /// The points of a front whose growth moves a tip: the first one and the one behind the last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> points_of(Tip tip, std::size_t points) const;

  DriveCrack crack_;
  CracksAtTorques at_torque_;  // only if K is not linear in the torque
  CrackDuty duty_;
  PreparedLaw law_;
  GrowthLimits limits_;
  MixedMode mixed_mode_;
  double poissons_ratio_ = 0.3;
  std::optional<double> yield_strength_;
  RateDeviation deviation_;
  double factor_ = 1.0;  // exp of the logarithm of the deviation
};

}  // namespace strainwave

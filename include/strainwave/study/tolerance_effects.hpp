// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/deviations.hpp"

/// @file
/// What the tolerances of the parts do to the torsion curve (TC-36).

namespace strainwave {

/// Draws of drives from the tolerances.
struct ToleranceOptions {
  int draws = 100;               ///< drives drawn from the tolerances; > 0
  std::uint64_t seed = 1;        ///< the same seed gives the same drives
  int threads = 0;               ///< 0: as many as the machine runs at once; the result is the same
  SharedRows* shared = nullptr;  ///< null, or the part of the draws computed or read here
  RowSink* rows = nullptr;       ///< null, or takes each draw
};

/// A quantity without deviations, and its quantiles over the drawn drives.
struct ToleranceSpread {
  double nominal = 0.0;  ///< without deviations
  double low = 0.0;      ///< 5 %
  double median = 0.0;   ///< 50 %
  double high = 0.0;     ///< 95 %
};

/// Kinds of quantities that have a spread, which decide its unit.
enum class SpreadOf { stiffness, angle, count, share };

/// A spread with the unit of its quantity.
template <SpreadOf quantity>
struct SpreadIn : ToleranceSpread {
  template <class Visitor>
  static void describe(Visitor&& field) {
    constexpr std::string_view unit = quantity == SpreadOf::stiffness ? "N*m/rad"
                                      : quantity == SpreadOf::angle   ? "rad"
                                                                      : "1";
    field({"nominal", unit, "without deviations"}, &ToleranceSpread::nominal);
    field({"low", unit, "5 % of the drawn drives"}, &ToleranceSpread::low);
    field({"median", unit, "50 % of the drawn drives"}, &ToleranceSpread::median);
    field({"high", unit, "95 % of the drawn drives"}, &ToleranceSpread::high);
  }
};

/// Flanks and teeth in contact under one torque about +z.
struct ContactSpread {
  double torque = 0.0;  ///< [N*m]
  SpreadIn<SpreadOf::count> flanks;
  SpreadIn<SpreadOf::count> teeth;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &ContactSpread::torque);
    field({"flanks", "", "flanks in contact"}, &ContactSpread::flanks);
    field({"teeth", "", "teeth in contact"}, &ContactSpread::teeth);
  }
};

/// The torsion curve of drives whose parts are drawn from their tolerances.
struct ToleranceEffects {
  DeviationLimits limits;
  SpreadIn<SpreadOf::stiffness> K1;  ///< over half of the twist between both senses
  SpreadIn<SpreadOf::stiffness> K2;
  SpreadIn<SpreadOf::stiffness> K3;
  SpreadIn<SpreadOf::angle> lost_motion;
  /// largest less least K1 over its mean, over a turn of the wave generator
  SpreadIn<SpreadOf::share> ripple;
  std::vector<ContactSpread> contacts;  ///< at T1, T2, T3
  int positions = 0;                    ///< of the wave generator, for the ripple
  int draws = 0;                        ///< drawn drives that gave a curve
  int failed = 0;                       ///< drawn drives without an equilibrium
  std::uint64_t seed = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"limits", "", "deviations that the tolerances allow"}, &ToleranceEffects::limits);
    field({"K1", "", "K1 over half of the twist between both senses of torque"},
          &ToleranceEffects::K1);
    field({"K2", "", "K2, likewise"}, &ToleranceEffects::K2);
    field({"K3", "", "K3, likewise"}, &ToleranceEffects::K3);
    field({"lost_motion", "", "lost motion"}, &ToleranceEffects::lost_motion);
    field({"ripple", "", "largest less least K1 over its mean, over a turn of the wave generator"},
          &ToleranceEffects::ripple);
    field({"contacts", "", "contacts at T1, T2 and T3"}, &ToleranceEffects::contacts);
    field({"positions", "", "positions of the wave generator for the ripple"},
          &ToleranceEffects::positions);
    field({"draws", "", "drawn drives that gave a curve"}, &ToleranceEffects::draws);
    field({"failed", "", "drawn drives without an equilibrium"}, &ToleranceEffects::failed);
    field({"seed", "", "seed of the draws"}, &ToleranceEffects::seed);
  }
};

/// Draws the parts of drives within their tolerances and solves each drive under both senses of
/// torque.
///
/// Implements theory manual eq. (TC-36).
/// @param drive     without deviations of its parts
/// @param options   draws and threads; `draws` > 0; {}: 100 draws
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if the tolerances break a rule
/// @throws SolverError  if no drawn drive has an equilibrium
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] ToleranceEffects tolerance_effects(const AssembledDrive& drive,
                                                 const ToleranceOptions& options = {},
                                                 const Progress& progress = {});

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/model/input/output_bearing.hpp"

namespace strainwave {

/// Load of the output bearing for a part of a duty.
struct OutputBearingLoad {
  double radial_force = 0.0;    ///< F_r [N]; >= 0
  double axial_force = 0.0;     ///< F_a [N]; taken in size
  double bending_moment = 0.0;  ///< M about the middle of the rollers [N*m]; >= 0
  double speed = 0.0;           ///< of the output, in turns [1/s]; >= 0
  double duration = 0.0;        ///< how long the load acts [s]; > 0
};

/// Life of the output bearing.
struct OutputBearingLife {
  double ten_percent = 0.0;  ///< L10 [s]
  double load = 0.0;         ///< P_c, the constant load with this life [N]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"L10", "s", "life that 90 % of the output bearings reach"},
          &OutputBearingLife::ten_percent);
    field({"load", "N", "constant load with the same life"}, &OutputBearingLife::load);
  }
};

/// Equivalent load P_c of a crossed roller bearing [N].
///
/// Implements theory manual eq. (LI-33), the rule of makers.
[[nodiscard]] double output_bearing_load(const OutputBearing& bearing,
                                         const OutputBearingLoad& load);

/// Implements theory manual eq. (LI-33) over a duty that is repeated for ever.
/// @throws InputError  if a number is out of range or nothing moves under load
[[nodiscard]] OutputBearingLife output_bearing_life(const OutputBearing& bearing,
                                                    std::span<const OutputBearingLoad> duty);

}  // namespace strainwave

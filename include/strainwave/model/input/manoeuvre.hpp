// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// A piece of a motion.  Speeds and torques go to their values at its end in straight lines.
struct Manoeuvre {
  double duration = 0.0;                    ///< [s]; > 0
  std::optional<double> input_speed = {};   ///< of the motor at the end, with sign [rad/s]
  std::optional<double> input_torque = {};  ///< of the motor at the end, with sign [N*m]
  /// T_ext on the load at the end, about +z [N*m]; absent: as before
  std::optional<double> output_torque = {};
  /// of the output at the end, with sign [rad/s]; absent: the output moves freely
  std::optional<double> output_speed = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "duration",
                .unit = "s",
                .doc = "time that the piece takes",
                .range = kPositive,
                .example = R"("0.2 s")"},
          &Manoeuvre::duration);
    field(Field{.name = "input_speed",
                .unit = "rad/s",
                .doc = "speed of the motor at the end of the piece; the motion begins at rest",
                .example = R"("1000 rpm")"},
          &Manoeuvre::input_speed);
    field(Field{.name = "input_torque",
                .unit = "N*m",
                .doc = "torque of the motor at the end of the piece, in place of input_speed; the "
                       "motion begins with the torque that holds the load",
                .example = R"("0.5 N*m")",
                .in_template = InTemplate::commented},
          &Manoeuvre::input_torque);
    field(Field{.name = "output_torque",
                .unit = "N*m",
                .doc = "external torque on the load at the end of the piece; if left out, as "
                       "before; the first value holds from the start",
                .example = R"("0 N*m")",
                .in_template = InTemplate::commented},
          &Manoeuvre::output_torque);
    field(Field{.name = "output_speed",
                .unit = "rad/s",
                .doc = "speed of the output at the end of the piece, in place of output_torque; "
                       "the motion states the external torque that it needs",
                .example = R"("10 rpm")",
                .in_template = InTemplate::commented},
          &Manoeuvre::output_speed);
  }
};

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The maker's torques, at which the three straight lines of a torsion curve meet.
///
/// The torques are conventions, about 0.052 d^3 and 0.187 d^3 N/mm^2; no model can predict them.
struct Rating {
  double T1 = 0.0;                     ///< upper torque of K1 [N*m]; > 0
  double T2 = 0.0;                     ///< upper torque of K2 [N*m]; > T1
  std::optional<double> T3;            ///< upper torque of K3 [N*m]; > T2; absent: 1.6 T2
  std::optional<double> rated_torque;  ///< T_N [N*m]; > 0; absent: 1.8 T2
  /// share of T_N at which lost motion is measured [-]; in (0, 1)
  double lost_motion_share = 0.04;
  /// What the maker allows; absent: not known.
  std::optional<double> average_torque = {};     ///< limit of the average torque [N*m]; > 0
  std::optional<double> repeated_peak = {};      ///< limit of repeated peak torque [N*m]; > 0
  std::optional<double> momentary_peak = {};     ///< limit of momentary peak torque [N*m]; > 0
  std::optional<double> ratcheting_torque = {};  ///< torque at which teeth jump [N*m]; > 0
  std::optional<double> buckling_torque = {};    ///< torque at which the wall buckles [N*m]; > 0
  std::optional<double> largest_speed = {};      ///< of the input [rad/s]; > 0
  std::optional<double> average_speed = {};      ///< of the input [rad/s]; > 0
  /// L10 of the wave generator's bearing at T_N and 2000 rpm [s]; > 0
  std::optional<double> bearing_life = {};
  /// friction of seals, grease and output bearing, at the output [N*m]; >= 0
  double friction_torque = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "T1",
                .unit = "N*m",
                .doc = "torque up to which K1 holds",
                .range = kPositive,
                .example = R"("212 N*m")"},
          &Rating::T1);
    field(Field{.name = "T2",
                .unit = "N*m",
                .doc = "torque up to which K2 holds",
                .range = kPositive,
                .example = R"("766 N*m")"},
          &Rating::T2);
    field(Field{.name = "T3",
                .unit = "N*m",
                .doc = "torque up to which K3 is taken; 1.6 T2 if left out",
                .range = kPositive,
                .example = R"("1226 N*m")",
                .in_template = InTemplate::commented},
          &Rating::T3);
    field(Field{.name = "rated_torque",
                .unit = "N*m",
                .doc = "T_N; 1.8 T2 if left out",
                .range = kPositive,
                .example = R"("1380 N*m")",
                .in_template = InTemplate::commented},
          &Rating::rated_torque);
    field(Field{.name = "lost_motion_share",
                .unit = "1",
                .doc = "share of the rated torque at which lost motion is measured",
                .range = {.lower = 0.0, .upper = 1.0},
                .example = "0.04",
                .fallback = "0.04",
                .in_template = InTemplate::commented},
          &Rating::lost_motion_share);
    const auto limit = [&](std::string_view name, std::string_view unit, std::string_view doc,
                           std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = unit,
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    limit("average_torque", "N*m", "largest average torque that the maker allows", R"("1500 N*m")",
          &Rating::average_torque);
    limit("repeated_peak", "N*m", "largest repeated peak torque that the maker allows",
          R"("2800 N*m")", &Rating::repeated_peak);
    limit("momentary_peak", "N*m", "largest momentary peak torque that the maker allows",
          R"("4800 N*m")", &Rating::momentary_peak);
    limit("ratcheting_torque", "N*m", "torque at which teeth jump", R"("5000 N*m")",
          &Rating::ratcheting_torque);
    limit("buckling_torque", "N*m", "torque at which the flexspline buckles", R"("9000 N*m")",
          &Rating::buckling_torque);
    limit("largest_speed", "rad/s", "largest speed of the input", R"("2800 rpm")",
          &Rating::largest_speed);
    limit("average_speed", "rad/s", "largest average speed of the input", R"("1900 rpm")",
          &Rating::average_speed);
    limit("bearing_life", "s",
          "life L10 of the wave generator's bearing at rated torque and 2000 rpm", R"("10000 h")",
          &Rating::bearing_life);
    field(Field{.name = "friction_torque",
                .unit = "N*m",
                .doc = "friction torque of seals, grease and output bearing, at the output without "
                       "load; for the hysteresis and the running torque",
                .range = kNonNegative,
                .example = R"("0 N*m")",
                .fallback = R"("0 N*m")",
                .in_template = InTemplate::commented},
          &Rating::friction_torque);
  }
};

/// Origin of a value.
enum class Knowledge {
  catalogue,  ///< a maker's stated value
  drawing,    ///< from drawings, published samples and handbooks
  stress,     ///< from the endurance of the part at the drive's deflection
  typical,    ///< typical of published drives
  assumed,    ///< assumed, because makers do not publish the value
};
template <>
struct EnumNames<Knowledge> {
  static constexpr std::array<std::string_view, 5> names = {"catalogue", "drawing", "stress",
                                                            "typical", "assumed"};
};

/// A number of the file that is known only within limits, with a uniform distribution between them.
struct InputRange {
  std::string path;   ///< path of the number, such as "flexspline.diaphragm.thickness"
  std::string lower;  ///< quantity text, in the unit of the number
  std::string upper;  ///< as lower; > lower
  Knowledge knowledge = Knowledge::typical;  ///< where the limits come from
  std::string source;                        ///< origin of the limits, one line; may be empty

  /// Keys of the fields that hold paths.
  static constexpr std::array<std::string_view, 1> kPathKeys = {"path"};
  /// Paths of the numbers that the entry names, in the order of `kPathKeys`.
  [[nodiscard]] std::array<std::string_view, 1> paths() const { return {path}; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "path",
                .unit = "",
                .doc = "path of the number",
                .example = R"("flexspline.wall_thickness")"},
          &InputRange::path);
    field(Field{.name = "lower",
                .unit = "",
                .doc = "lower limit with its unit; a bare number if the field has no unit",
                .example = R"("2 mm")",
                .number_text = true},
          &InputRange::lower);
    field(Field{.name = "upper",
                .unit = "",
                .doc = "upper limit with its unit; a bare number if the field has no unit",
                .example = R"("2.5 mm")",
                .number_text = true},
          &InputRange::upper);
    field(Field{.name = "knowledge",
                .unit = "",
                .doc = "where the limits come from",
                .example = R"("typical")",
                .fallback = R"("typical")"},
          &InputRange::knowledge);
    field(Field{.name = "source",
                .unit = "",
                .doc = "one line",
                .example = R"("drawing tolerance")",
                .fallback = R"("")"},
          &InputRange::source);
  }
};

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/inspection/detection_form.hpp"

/// @file
/// How the cracks of a drive are looked for, and what a find leads to.

namespace strainwave {

/// What an inspection looks at.
enum class InspectionMeans {
  curve,                ///< the cracks, with a curve of detection over their size
  stiffness,            ///< the stiffness of the drive in its softer sense
  one_sided_stiffness,  ///< the difference of the stiffness between the two senses of the torque
  resonance,            ///< the first natural frequency of the drive between motor and load
};
template <>
struct EnumNames<InspectionMeans> {
  static constexpr std::array<std::string_view, 4> names = {"curve", "stiffness",
                                                            "one_sided_stiffness", "resonance"};
};

/// What a find leads to.
enum class FindLeadsTo {
  out,     ///< the drive leaves service
  repair,  ///< the cracks that can be seen are reduced to a size, and the drive stays in service
};
template <>
struct EnumNames<FindLeadsTo> {
  static constexpr std::array<std::string_view, 2> names = {"out", "repair"};
};

/// A crack that inspections can see.
struct InspectedPlace {
  std::string crack;  ///< path, such as "output_shaft.crack[0]"

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "crack",
                .unit = "",
                .doc = "path of a crack that the inspections can see",
                .example = R"("flexspline.crack[0]")"},
          &InspectedPlace::crack);
  }
};

/// What inspections and failures cost, in one currency.
struct InspectionCost {
  double inspection = 0.0;  ///< of one inspection of one drive [-]; >= 0
  double call = 0.0;        ///< of one find or false call: of the repair or the new drive [-]; >= 0
  double failure = 0.0;     ///< of one failure in service [-]; >= 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = InspectionCost;
    const auto add = [&](std::string_view name, std::string_view doc, std::string_view example,
                         auto member) {
      field(Field{.name = name,
                  .unit = "1",
                  .doc = doc,
                  .range = kNonNegative,
                  .example = example,
                  .fallback = "0"},
            member);
    };
    add("inspection", "of one inspection of one drive, in the currency of the table", "200",
        &C::inspection);
    add("call", "of one find or one false call, in the same currency", "3000", &C::call);
    add("failure", "of one failure in service, in the same currency", "50000", &C::failure);
  }
};

/// How the cracks of a drive are looked for, and what a find leads to.  `strainwave inspect` reads
/// it.
struct Inspection {
  InspectionMeans method = InspectionMeans::curve;
  /// form of the curve of detection; absent: log-logistic
  std::optional<DetectionForm> detection = {};
  std::optional<double> a50 = {};          ///< size found in half of the cases [m]; > 0
  std::optional<double> a90 = {};          ///< size found in nine of ten cases [m]; > a50
  std::optional<double> noise = {};        ///< of one measurement, relative [-]; > 0
  std::optional<double> false_calls = {};  ///< probability of a false call [-]; in [0, 1)
  FindLeadsTo find = FindLeadsTo::out;
  std::optional<double> repaired_to = {};  ///< size of a crack after its repair [m]; > 0
  std::optional<InspectionCost> cost = {};
  std::vector<InspectedPlace> place = {};  ///< empty: all cracks can be seen

  template <class Visitor>
  static void describe(Visitor&& field) {
    using I = Inspection;
    field(Field{.name = "method",
                .unit = "",
                .doc = "curve looks for cracks by a curve over their size; stiffness, "
                       "one_sided_stiffness and resonance measure the drive",
                .example = R"("curve")",
                .fallback = R"("curve")"},
          &I::method);
    field(Field{.name = "detection",
                .unit = "",
                .doc = "form of the probability of detection over the size; log_logistic if left "
                       "out; of a curve",
                .example = R"("log_logistic")"},
          &I::detection);
    field(Field{.name = "a50",
                .unit = "m",
                .doc = "size of a crack that one inspection finds in half of the cases: the depth, "
                       "or the half length of a crack through the wall; of a curve",
                .range = kPositive,
                .example = R"("1 mm")",
                .usual = {.lower = 1e-6, .upper = 0.1}},
          &I::a50);
    field(Field{.name = "a90",
                .unit = "m",
                .doc = "size that is found in nine of ten cases; of a curve",
                .range = kPositive,
                .example = R"("2 mm")",
                .usual = {.lower = 1e-6, .upper = 0.1}},
          &I::a90);
    field(Field{.name = "noise",
                .unit = "1",
                .doc = "standard deviation of the measured change over the measured value; of a "
                       "measurement",
                .range = {.lower = 0.0, .upper = 1.0},
                .example = "0.01",
                .in_template = InTemplate::commented},
          &I::noise);
    field(Field{.name = "false_calls",
                .unit = "1",
                .doc = "probability that an inspection finds a crack that is not there; 0 if left "
                       "out of a curve",
                .range = {.lower = 0.0, .lower_open = false, .upper = 1.0},
                .example = "0.01"},
          &I::false_calls);
    field(Field{.name = "find",
                .unit = "",
                .doc = "what a find leads to: the drive goes out of service, or the repair of its "
                       "cracks",
                .example = R"("repair")",
                .fallback = R"("out")"},
          &I::find);
    field(Field{.name = "repaired_to",
                .unit = "m",
                .doc = "size of a crack after its repair; of a repair",
                .range = kPositive,
                .example = R"("0.5 mm")",
                .usual = {.lower = 1e-6, .upper = 0.1}},
          &I::repaired_to);
    field(Field{.name = "cost",
                .unit = "",
                .doc = "what inspections and failures cost",
                .in_template = InTemplate::commented},
          &I::cost);
    field(Field{.name = "place",
                .unit = "",
                .doc = "cracks that the inspections can see; all if left out; of a curve",
                .in_template = InTemplate::commented},
          &I::place);
  }
};

/// Whether inspections measure the drive, and do not look for the cracks.
[[nodiscard]] constexpr bool is_measurement(InspectionMeans method) {
  return method != InspectionMeans::curve;
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Distribution of a number about the value in the file.
enum class ScatterDistribution {
  lognormal,  ///< the file's value is the median; the sign cannot change
  normal,     ///< the file's value is the mean
  uniform,    ///< the file's value is the mean, in the middle of the two ends
  weibull,    ///< the file's value is the mean; the smallest value is 0
};
template <>
struct EnumNames<ScatterDistribution> {
  static constexpr std::array<std::string_view, 4> names = {"lognormal", "normal", "uniform",
                                                            "weibull"};
};

/// A number of the file that scatters independently of the others.  `strainwave sensitivity
/// --scatter` and `--sobol`, `strainwave reliability` and `strainwave accuracy` read it.
struct InputScatter {
  /// path of the number, such as "flexspline.wall_thickness"
  std::string path;
  double relative_standard_deviation = 0.0;  ///< s [-]; in (0, 1]
  ScatterDistribution distribution = ScatterDistribution::lognormal;
  std::string source;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "path",
                .unit = "",
                .doc = "path of the number",
                .example = R"("flexspline.wall_thickness")"},
          &InputScatter::path);
    field(Field{.name = "relative_standard_deviation",
                .unit = "1",
                .doc = "s, standard deviation over the value in the file",
                .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
                .example = "0.03"},
          &InputScatter::relative_standard_deviation);
    field(Field{.name = "distribution",
                .unit = "",
                .doc = "distribution about the value in the file, which is the median of lognormal "
                       "and the mean of normal, uniform and weibull",
                .example = R"("lognormal")",
                .fallback = R"("lognormal")"},
          &InputScatter::distribution);
    field(Field{.name = "source",
                .unit = "",
                .doc = "one line",
                .example = R"("drawing tolerance")",
                .fallback = R"("")"},
          &InputScatter::source);
  }
};

}  // namespace strainwave

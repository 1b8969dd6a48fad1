// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Distribution of a number about the value in the file.
enum class ScatterDistribution {
  lognormal,  ///< the file's value is the median; the sign cannot change
  normal,     ///< the file's value is the mean
  uniform,    ///< the file's value is the mean, in the middle of the two ends
  weibull,    ///< the file's value is the mean; the smallest value is 0
  table,      ///< quantiles of the file
};
template <>
struct EnumNames<ScatterDistribution> {
  static constexpr std::array<std::string_view, 5> names = {"lognormal", "normal", "uniform",
                                                            "weibull", "table"};
};

/// A point of a distribution that is given as a table.
struct ScatterQuantile {
  double probability = 0.0;  ///< of a smaller value [-]; in [0, 1]
  double ratio = 0.0;        ///< value over the value in the file [-]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "probability",
                .unit = "1",
                .doc = "probability of a smaller value; 0 in the first entry and 1 in the last",
                .range = {.lower = 0.0, .lower_open = false, .upper = 1.0, .upper_open = false},
                .example = "0.5"},
          &ScatterQuantile::probability);
    field(Field{.name = "ratio",
                .unit = "1",
                .doc = "value over the value in the file; linear over the probability between "
                       "two entries",
                .range = kPositive,
                .example = "1.05"},
          &ScatterQuantile::ratio);
  }
};

/// A number of the file that scatters.  `strainwave sensitivity --scatter` and `--sobol`,
/// `strainwave reliability` and `strainwave accuracy` read it.
struct InputScatter {
  /// path of the number, such as "flexspline.wall_thickness"
  std::string path;
  std::optional<double> relative_standard_deviation = {};  ///< s [-]; in (0, 1]; not of a table
  ScatterDistribution distribution = ScatterDistribution::lognormal;
  std::vector<ScatterQuantile> quantile = {};  ///< of a table
  std::string source;                          ///< origin of the scatter, one line; may be empty

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
          &InputScatter::path);
    field(Field{.name = "relative_standard_deviation",
                .unit = "1",
                .doc = "s, standard deviation over the value in the file; not with a table",
                .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
                .example = "0.03"},
          &InputScatter::relative_standard_deviation);
    field(Field{.name = "distribution",
                .unit = "",
                .doc = "distribution about the value in the file, which is the median of lognormal "
                       "and the mean of normal, uniform and weibull; a table gives quantiles",
                .example = R"("lognormal")",
                .fallback = R"("lognormal")"},
          &InputScatter::distribution);
    field(Field{.name = "quantile",
                .unit = "",
                .doc = "distribution as a table, from probability 0 to 1; of a table",
                .in_template = InTemplate::commented},
          &InputScatter::quantile);
    field(Field{.name = "source",
                .unit = "",
                .doc = "one line",
                .example = R"("drawing tolerance")",
                .fallback = R"("")"},
          &InputScatter::source);
  }
};

/// Rank correlation of two numbers that scatter.
///
/// The numbers keep their distributions.  Their standard normal variables have the correlation of
/// theory manual eq. (UQ-8).
struct InputCorrelation {
  std::string path;               ///< of a number that scatters
  std::string with;               ///< of another one
  double rank_correlation = 0.0;  ///< Spearman's rho [-]; in (-1, 1)
  std::string source;             ///< origin of the correlation, one line; may be empty

  /// Keys of the fields that hold paths.
  static constexpr std::array<std::string_view, 2> kPathKeys = {"path", "with"};
  /// Paths of the numbers that the entry names, in the order of `kPathKeys`.
  [[nodiscard]] std::array<std::string_view, 2> paths() const { return {path, with}; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "path",
                .unit = "",
                .doc = "path of a number that scatters",
                .example = R"("flexspline.wall_thickness")"},
          &InputCorrelation::path);
    field(Field{.name = "with",
                .unit = "",
                .doc = "path of another number that scatters",
                .example = R"("flexspline.length")"},
          &InputCorrelation::with);
    field(Field{.name = "rank_correlation",
                .unit = "1",
                .doc = "Spearman's rank correlation of the two numbers",
                .range = {.lower = -1.0, .upper = 1.0},
                .example = "0.6"},
          &InputCorrelation::rank_correlation);
    field(Field{.name = "source",
                .unit = "",
                .doc = "one line",
                .example = R"("same tool")",
                .fallback = R"("")"},
          &InputCorrelation::source);
  }
};

}  // namespace strainwave

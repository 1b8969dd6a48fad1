// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// Data that makers publish: torsional stiffness in 35 rows of size and ratio, and torques of 36
/// drives.

namespace strainwave {

/// The classes of ratio for which makers tabulate stiffness: 30, 50, and one class for 80 and more.
enum class RatioClass { thirty, fifty, eighty_up };
template <>
struct EnumNames<RatioClass> {
  static constexpr std::array<std::string_view, 3> names = {"30", "50", "80+"};
};
inline constexpr std::size_t kRatioClasses = EnumNames<RatioClass>::names.size();

/// The class nearest to a ratio, by its logarithm: 30 below 38.7, 50 below 63.2, else 80+.
/// @param ratio  i_h [-]; > 0
[[nodiscard]] RatioClass ratio_class_of(double ratio);

/// The ratio that represents a class in computations: 30, 50, and 100 for 80+.
[[nodiscard]] double representative_ratio(RatioClass ratio_class);

/// One row of the stiffness tables.  The numbers are printed with two or three digits, so rounding
/// errors reach 5 %.
struct StiffnessRow {
  int size = 0;
  RatioClass ratio_class = RatioClass::eighty_up;
  double T1 = 0.0;           ///< upper torque of K1 [N*m]
  double T2 = 0.0;           ///< upper torque of K2 [N*m]
  double K1 = 0.0;           ///< [N*m/rad]
  double K2 = 0.0;           ///< [N*m/rad]
  std::optional<double> K3;  ///< stiffness beyond T2 [N*m/rad]; absent in two rows
  std::string_view sources;  ///< letters A, B, C of the sources in catalogue_data.cpp

  /// K1, K2, K3 as an array [N*m/rad].
  [[nodiscard]] std::array<std::optional<double>, 3> K() const { return {K1, K2, K3}; }
  /// Torque up to which K3 is compared, kT3OverT2 times T2 [N*m].  Makers state no upper torque;
  /// this is a convention of the project.
  [[nodiscard]] double T3() const { return kT3OverT2 * T2; }
  static constexpr double kT3OverT2 = 1.6;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"size", "1", "maker's size, in tenths of an inch"}, &StiffnessRow::size);
    field({"ratio_class", "", "30, 50, or 80 and more"}, &StiffnessRow::ratio_class);
    field({"T1", "N*m", "upper torque of K1"}, &StiffnessRow::T1);
    field({"T2", "N*m", "upper torque of K2"}, &StiffnessRow::T2);
    field({"K1", "N*m/rad", "stiffness up to T1"}, &StiffnessRow::K1);
    field({"K2", "N*m/rad", "stiffness from T1 to T2"}, &StiffnessRow::K2);
    field({"K3", "N*m/rad", "stiffness beyond T2"}, &StiffnessRow::K3);
    field({"sources", "", "tables that state the row"}, &StiffnessRow::sources);
  }
};

/// One row of the rating tables.
struct RatingRow {
  std::string_view series;
  int size = 0;
  int ratio = 0;
  double repeated_peak = 0.0;        ///< [N*m]
  double average = 0.0;              ///< largest average torque [N*m]
  double rated = 0.0;                ///< rated torque T_N at an input of 2000 rpm [N*m]
  double momentary_peak = 0.0;       ///< [N*m]
  double max_input_speed = 0.0;      ///< largest speed of the input, with grease [rad/s]
  double average_input_speed = 0.0;  ///< largest average speed of the input, with grease [rad/s]
  double input_inertia = 0.0;        ///< [kg*m^2]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"series", "", "maker's series"}, &RatingRow::series);
    field({"size", "1", "maker's size, in tenths of an inch"}, &RatingRow::size);
    field({"ratio", "1", "reduction ratio"}, &RatingRow::ratio);
    field({"rated", "N*m", "rated torque T_N at an input of 2000 rpm"}, &RatingRow::rated);
    field({"average", "N*m", "largest average torque"}, &RatingRow::average);
    field({"repeated_peak", "N*m", "largest repeated torque"}, &RatingRow::repeated_peak);
    field({"momentary_peak", "N*m", "largest momentary torque"}, &RatingRow::momentary_peak);
    field({"max_input_speed", "rad/s", "largest speed of the input, with grease"},
          &RatingRow::max_input_speed);
    field({"average_input_speed", "rad/s", "largest average speed of the input, with grease"},
          &RatingRow::average_input_speed);
    field({"input_inertia", "kg*m^2", "moment of inertia of the input"}, &RatingRow::input_inertia);
  }
};

[[nodiscard]] std::span<const StiffnessRow> stiffness_rows();
[[nodiscard]] std::span<const RatingRow> rating_rows();

/// Sizes of the stiffness table, in ascending order.
[[nodiscard]] std::vector<int> catalogue_sizes();

/// Pitch diameter d of a size [m].  A maker's size is d in tenths of an inch.
[[nodiscard]] double pitch_diameter_of(int size);

/// The row of a size and of the class of a ratio; null if the table lacks it.
[[nodiscard]] const StiffnessRow* find_stiffness(int size, double ratio);

/// The row of exactly this size and ratio; null if the table lacks it.
[[nodiscard]] const RatingRow* find_rating(int size, double ratio);

/// The row nearest to a drive.  The class of the ratio decides first, then the size by its
/// logarithm.
/// @param pitch_diameter  [m]; > 0
[[nodiscard]] const StiffnessRow& nearest_stiffness(double pitch_diameter, double ratio);

/// Throws InputError unless the size is in the catalogue; the message lists the sizes that are.
void require_catalogue_size(int size);

/// Selects rows of the catalogue.
struct CatalogueFilter {
  std::optional<int> size;
  std::optional<double> ratio;  ///< selects stiffness rows by class and ratings exactly
};
/// Rows of both tables, with their sources.
struct CatalogueRows {
  std::vector<StiffnessRow> stiffness;
  std::vector<RatingRow> ratings;
  std::map<std::string, std::string> sources;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"stiffness", "", "torsional stiffness, input locked"}, &CatalogueRows::stiffness);
    field({"ratings", "", "torques, speeds and inertia"}, &CatalogueRows::ratings);
    field({"sources", "", "publications from which the rows were taken"}, &CatalogueRows::sources);
  }
};

/// The rows that a filter selects.
/// @throws InputError  if the size is unknown or no row is left
[[nodiscard]] CatalogueRows catalogue_rows(const CatalogueFilter& filter = {});
}  // namespace strainwave

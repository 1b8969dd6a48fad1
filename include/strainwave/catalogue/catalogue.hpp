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
/// Data that makers publish: torsional stiffness in 35 rows of size and ratio and in 8 rows of
/// other series, and torques of 36 drives.

namespace strainwave {

/// The classes of ratio for which makers tabulate stiffness: 30, 50, and one class for 80 and more.
enum class RatioClass { thirty, fifty, eighty_up };
template <>
struct EnumNames<RatioClass> {
  static constexpr std::array<std::string_view, 3> names = {"30", "50", "80+"};
};
/// Number of the classes of ratio.
inline constexpr std::size_t kRatioClasses = EnumNames<RatioClass>::names.size();

/// The class nearest to a ratio, by its logarithm: 30 below 38.7, 50 below 63.2, else 80+.
/// @param ratio  i_h [-]; > 0
[[nodiscard]] RatioClass ratio_class_of(double ratio);

/// Size from which the catalogue's sizes are similar within a few per cent: K is proportional to
/// d^3.
inline constexpr double kLeastSimilarSize = 17;

/// Shape of the flexspline.
enum class FlexsplineForm {
  cup,  ///< the diaphragm points inward
  hat,  ///< silk hat: the diaphragm points outward, and the drive is hollow
};
template <>
struct EnumNames<FlexsplineForm> {
  static constexpr std::array<std::string_view, 2> names = {"cup", "hat"};
};

/// Length class of the flexspline.
enum class FlexsplineLength {
  standard,      ///< the long form of handbooks
  short_length,  ///< present-day component sets, about half as long
  flat,          ///< about half as long as the short one
};
template <>
struct EnumNames<FlexsplineLength> {
  static constexpr std::array<std::string_view, 3> names = {"standard", "short", "flat"};
};

/// Where a row of data comes from.  Only rows of the catalogue may enter a fit; all other rows
/// judge.
enum class RowOrigin {
  catalogue,
  other_series,  ///< manuals of other series by the same maker
  repeat,        ///< another series that repeats a row of the catalogue; not counted again
  file,          ///< the user's own rows
};
template <>
struct EnumNames<RowOrigin> {
  static constexpr std::array<std::string_view, 4> names = {"catalogue", "other-series", "repeat",
                                                            "file"};
};

/// One row of the stiffness tables.  The numbers are printed with two or three digits, so rounding
/// errors reach 5 %.
struct StiffnessRow {
  std::string series;  ///< maker's series, several separated by slashes
  FlexsplineForm form = FlexsplineForm::cup;
  FlexsplineLength length = FlexsplineLength::short_length;
  RowOrigin origin = RowOrigin::catalogue;
  double size = 0.0;  ///< maker's size, d in tenths of an inch; fractions in rows of a file only
  RatioClass ratio_class = RatioClass::eighty_up;
  /// Reduction ratios for which the row holds: those that the maker offers in a class, or the one
  /// that the source states.
  std::vector<double> ratios;
  double T1 = 0.0;           ///< upper torque of K1 [N*m]
  double T2 = 0.0;           ///< upper torque of K2 [N*m]
  std::optional<double> K1;  ///< stiffness up to T1 [N*m/rad]
  std::optional<double> K2;  ///< stiffness from T1 to T2 [N*m/rad]
  std::optional<double> K3;  ///< stiffness beyond T2 [N*m/rad]; absent in two rows of the catalogue
  std::string sources;       ///< letters of the sources in catalogue_data.cpp, or a line of a file

  /// K1, K2, K3 as an array [N*m/rad].
  [[nodiscard]] std::array<std::optional<double>, 3> K() const { return {K1, K2, K3}; }
  /// Torque up to which K3 is compared, kT3OverT2 times T2 [N*m].  Makers state no upper torque;
  /// this is a convention of the project.
  [[nodiscard]] double T3() const { return kT3OverT2 * T2; }
  /// Upper torque of the comparison of K3 over T2 [-]; a convention of the project.
  static constexpr double kT3OverT2 = 1.6;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    describe_drive(field);
    field({"T1", "N*m", "upper torque of K1"}, &StiffnessRow::T1);
    field({"T2", "N*m", "upper torque of K2"}, &StiffnessRow::T2);
    field({"K1", "N*m/rad", "stiffness up to T1"}, &StiffnessRow::K1);
    field({"K2", "N*m/rad", "stiffness from T1 to T2"}, &StiffnessRow::K2);
    field({"K3", "N*m/rad", "stiffness beyond T2"}, &StiffnessRow::K3);
    field({"sources", "", "tables that state the row"}, &StiffnessRow::sources);
  }
  /// Describes the drive of the row, without its numbers.
  template <class Visitor>
  static void describe_drive(Visitor&& field) {
    field({"size", "1", "maker's size, in tenths of an inch"}, &StiffnessRow::size);
    field({"ratio_class", "", "30, 50, or 80 and more"}, &StiffnessRow::ratio_class);
    field({"ratios", "1", "reduction ratios for which the row holds"}, &StiffnessRow::ratios);
    field({"series", "", "maker's series"}, &StiffnessRow::series);
    field({"form", "", "cup, or hat with the diaphragm outward"}, &StiffnessRow::form);
    field({"length", "", "length class of the flexspline"}, &StiffnessRow::length);
    field({"origin", "", "where the row comes from; only rows of the catalogue enter a fit"},
          &StiffnessRow::origin);
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
  double input_inertia = 0.0;        ///< of the wave generator alone [kg*m^2]

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
    field({"input_inertia", "kg*m^2", "moment of inertia of the wave generator"},
          &RatingRow::input_inertia);
  }
};

/// One row of the tables of friction, at 20 degrees Celsius with grease.
struct FrictionRow {
  std::string_view series;    ///< maker's series; RT1-H-CS in every row
  int size = 0;               ///< size of the drive, as the maker names it
  int ratio = 0;              ///< ratio of input speed to output speed [-]
  double rated = 0.0;         ///< rated torque, for the efficiency [N*m]
  double efficiency = 0.0;    ///< at the rated torque and an input of 2000 rpm [-]
  double no_load = 0.0;       ///< torque of the input without load at 2000 rpm [N*m]
  double starting = 0.0;      ///< torque that starts the input without load [N*m]
  double back_driving = 0.0;  ///< torque on the output that starts the free input [N*m]
};

/// The rows of the catalogue.  Only these may enter a fit.
[[nodiscard]] std::span<const StiffnessRow> stiffness_rows();
/// Rows of other series.  They judge only; no fit and no calibration reads them.
[[nodiscard]] std::span<const StiffnessRow> other_series_rows();
/// The rows of the rating tables: the series CSG and HFUC with grease.
[[nodiscard]] std::span<const RatingRow> rating_rows();
/// The rows of the tables of friction: four sizes of one series at ratio 100.
[[nodiscard]] std::span<const FrictionRow> friction_rows();

/// Sizes of the stiffness table, in ascending order.
[[nodiscard]] std::vector<int> catalogue_sizes();

/// Pitch diameter d of a size [m].  A maker's size is d in tenths of an inch.
[[nodiscard]] double pitch_diameter_of(double size);

/// The row of a size and of the class of a ratio; null if the table lacks it.
[[nodiscard]] const StiffnessRow* find_stiffness(int size, double ratio);

/// The row of exactly this size and ratio; null if the table lacks it.
[[nodiscard]] const RatingRow* find_rating(int size, double ratio);

/// The row of a form, a length and the class of a ratio with the nearest size by the logarithm;
/// null if the table has none.
/// @param pitch_diameter  [m]; > 0
/// @param ratio           i_h [-]; > 0
/// @param form            shape of the flexspline
/// @param length          length class of the flexspline
[[nodiscard]] const StiffnessRow* nearest_stiffness(
    double pitch_diameter, double ratio, FlexsplineForm form = FlexsplineForm::cup,
    FlexsplineLength length = FlexsplineLength::short_length);

/// Throws InputError unless the size is in the catalogue; the message lists the sizes that are.
void require_catalogue_size(int size);

/// Reads rows of a user: a table with the columns T1, T2 [N*m], K1, K2, K3 [N*m/rad], ratio, and
/// size or pitch_diameter [mm], in any order and in any units of torque, stiffness and length.
/// Cells of K1 to K3 may be empty, but not all of a row.  The columns series, form (cup or hat) and
/// length (standard, short or flat) may be left out; a row is then a short cup.  The function reads
/// the dialects of parse_measured_curve.
/// @param text       content of the file, with at least one row
/// @param file_name  used in messages and as `sources` of the rows
/// @throws InputError  if the text is not such a table; the message gives file, line and column
[[nodiscard]] std::vector<StiffnessRow> parse_stiffness_rows(std::string_view text,
                                                             std::string_view file_name);

/// Selects rows of the catalogue.
struct CatalogueFilter {
  std::optional<int> size;      ///< as the maker names it; absent: all
  std::optional<double> ratio;  ///< selects the catalogue's stiffness rows by class, others exactly
};
/// One row of the tables of ratcheting and buckling torque.
struct TorqueLimitRow {
  std::string_view series;
  int size = 0;
  int ratio = 0;
  double ratcheting = 0.0;  ///< torque at which teeth jump [N*m]
  double buckling = 0.0;    ///< torque at which the flexspline buckles, for all ratios [N*m]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"series", "", "maker's series"}, &TorqueLimitRow::series);
    field({"size", "1", "maker's size, in tenths of an inch"}, &TorqueLimitRow::size);
    field({"ratio", "1", "reduction ratio"}, &TorqueLimitRow::ratio);
    field({"ratcheting", "N*m", "torque at which teeth jump"}, &TorqueLimitRow::ratcheting);
    field({"buckling", "N*m", "torque at which the flexspline buckles, for all ratios of a size"},
          &TorqueLimitRow::buckling);
  }
};

/// Lives of a series' wave generator bearing at rated torque and 2000 rpm.
struct RatedLife {
  std::string_view series;
  double ten_percent = 0.0;    ///< L10 [s]
  double fifty_percent = 0.0;  ///< L50 [s]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"series", "", "maker's series"}, &RatedLife::series);
    field({"L10", "s", "life that 90 % of the bearings reach"}, &RatedLife::ten_percent);
    field({"L50", "s", "life that half of the bearings reach"}, &RatedLife::fifty_percent);
  }
};

/// Rows of all tables, with their sources.
struct CatalogueRows {
  std::vector<StiffnessRow> stiffness;
  std::vector<RatingRow> ratings;
  std::vector<TorqueLimitRow> limits;  ///< ratcheting and buckling torques
  /// lives of the bearings of all series; a filter does not select among them
  std::vector<RatedLife> lives;
  std::map<std::string, std::string> sources;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"stiffness", "", "torsional stiffness, input locked, also of other series"},
          &CatalogueRows::stiffness);
    field({"ratings", "", "torques, speeds and inertia"}, &CatalogueRows::ratings);
    field({"limits", "", "ratcheting and buckling torques"}, &CatalogueRows::limits);
    field({"lives", "", "lives of the wave generator bearings of all series"},
          &CatalogueRows::lives);
    field({"sources", "", "publications from which the rows were taken"}, &CatalogueRows::sources);
  }
};

/// The rows that a filter selects.
/// @throws InputError  if the size is unknown or no row is left
[[nodiscard]] CatalogueRows catalogue_rows(const CatalogueFilter& filter = {});
}  // namespace strainwave

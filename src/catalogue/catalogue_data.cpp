// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/core/units.hpp"

// The tables as printed in the sources.  Only this file converts their units to SI.
//
// Stiffness, T in N*m, K in 1e4 N*m/rad.  Sources:
//   A  CSF/CSG component set catalogue of Harmonic Drive LLC, page 50;
//   B  engineering data 1018854 of Harmonic Drive AG for the CHA series, tables 54.3 and 54.4;
//   C  data/reducers_tables.py of the public project harmonic-drive-selector by A. Haidar, revision
// e1df012 (Apache-2.0), which holds data of Harmonic Drive SE; a row for SHG/HFUS says so.  If a
// row has several sources, they agree.  "A(K1 K2)" means that A lacks K3, so K3 is from the other
// sources.
//
// The catalogue's rows are those of cups of the present short length.  The same numbers stand in
// the tables of the series CSF, CSG and HFUC; one row is known from the silk hats SHG and HFUS
// only. The tables of ratcheting torques of source A show which ratios of 80 and more a size has.
//
// Rows of other series judge only.  Sources:
//   D  manual of the FHA mini actuators, page 16, and manual of the RSF-B actuators, page 12, which
// misprints K1 of ratio 50 as 0.44e4; the row of ratio 50 repeats the catalogue;
//   E  manual of the FHA-C actuators, page 16.  The manual gives the size of the actuator; the size
// of the gear follows from T1 and T2.
//
// Friction of the RT1-H-CS series at ratio 100, 20 degrees Celsius and 2000 rpm, torques in mN*m
// and N*m: Schaeffler TPI 275, as digitised in harmonic_drive_twin/catalogue.py of the public
// project harmonic-drive-twin, revision 093e506 (MIT).  The page itself was not read.
//
// Ratings of the CSG and HFUC series with grease: source C.  Torques in N*m, speeds in rpm, inertia
// of the wave generator in 1e-4 kg*m^2.

namespace strainwave {
namespace {

using units::rpm;

constexpr RatioClass k30 = RatioClass::thirty;
constexpr RatioClass k50 = RatioClass::fifty;
constexpr RatioClass k80 = RatioClass::eighty_up;
constexpr std::optional<double> kNone = std::nullopt;

/// Converts from 1e4 N*m/rad and rounds, because all values are whole N*m/rad but the double 0.81 *
/// 1e4 is not.
std::optional<double> whole(std::optional<double> K) {
  return K ? std::optional(std::round(1e4 * *K)) : std::nullopt;
}

std::vector<double> offered_ratios(int size, RatioClass ratio_class) {
  if (ratio_class == k30) return {30};
  if (ratio_class == k50) return {50};
  if (size < 14) return {100};
  if (size < 17) return {80, 100};
  if (size < 20) return {80, 100, 120};
  return {80, 100, 120, 160};
}

/// A row of the catalogue.
StiffnessRow stiffness(int size, RatioClass ratio_class, double T1, double T2, double K1, double K2,
                       std::optional<double> K3, const std::string& sources) {
  const bool hat = sources == "C(SHG/HFUS)";
  return {.series = hat ? "SHG/HFUS" : "CSF/CSG/HFUC",
          .form = hat ? FlexsplineForm::hat : FlexsplineForm::cup,
          .length = FlexsplineLength::short_length,
          .origin = RowOrigin::catalogue,
          .size = static_cast<double>(size),
          .ratio_class = ratio_class,
          .ratios = offered_ratios(size, ratio_class),
          .T1 = T1,
          .T2 = T2,
          .K1 = whole(K1),
          .K2 = whole(K2),
          .K3 = whole(K3),
          .sources = sources};
}

/// A row of another series, which states its ratio.
StiffnessRow other(const std::string& series, FlexsplineForm form, FlexsplineLength length,
                   RowOrigin origin, int size, double ratio, double T1, double T2,
                   std::optional<double> K1, std::optional<double> K2, std::optional<double> K3,
                   const std::string& sources) {
  return {.series = series,
          .form = form,
          .length = length,
          .origin = origin,
          .size = static_cast<double>(size),
          .ratio_class = ratio_class_of(ratio),
          .ratios = {ratio},
          .T1 = T1,
          .T2 = T2,
          .K1 = whole(K1),
          .K2 = whole(K2),
          .K3 = whole(K3),
          .sources = sources};
}

constexpr RatingRow rating(std::string_view series, int size, int ratio, double repeated_peak,
                           double average, double rated, double momentary_peak, double max_speed,
                           double average_speed, double inertia) {
  return {.series = series,
          .size = size,
          .ratio = ratio,
          .repeated_peak = repeated_peak,
          .average = average,
          .rated = rated,
          .momentary_peak = momentary_peak,
          .max_input_speed = max_speed * rpm,
          .average_input_speed = average_speed * rpm,
          .input_inertia = 1e-4 * inertia};
}

// clang-format off
const StiffnessRow kStiffness[] = {
    //        size class   T1    T2    K1     K2     K3     sources
    stiffness(8, k30, 0.29, 0.75, 0.034, 0.044, 0.054, "A"),
    stiffness(11, k30, 0.80, 2.0, 0.084, 0.13, 0.16, "A"),
    stiffness(14, k30, 2.0, 6.9, 0.19, 0.24, 0.34, "A+B+C"),
    stiffness(17, k30, 3.9, 12, 0.34, 0.44, 0.67, "A+B+C"),
    stiffness(20, k30, 7.0, 25, 0.57, 0.71, 1.1, "A+B+C"),
    stiffness(25, k30, 14, 48, 1.0, 1.3, 2.1, "A+B+C"),
    stiffness(32, k30, 29, 108, 2.4, 3.0, 4.9, "A+B+C"),
    stiffness(8, k50, 0.29, 0.75, 0.044, 0.067, kNone, "A"),
    stiffness(11, k50, 0.80, 2.0, 0.22, 0.30, 0.32, "A(K1 K2)+C(SHG/HFUS)"),
    stiffness(14, k50, 2.0, 6.9, 0.34, 0.47, 0.57, "A(K1 K2)+B+C"),
    stiffness(17, k50, 3.9, 12, 0.81, 1.1, 1.3, "A(K1 K2)+B+C"),
    stiffness(20, k50, 7.0, 25, 1.3, 1.8, 2.3, "A(K1 K2)+B+C"),
    stiffness(25, k50, 14, 48, 2.5, 3.4, 4.4, "A(K1 K2)+B+C"),
    stiffness(32, k50, 29, 108, 5.4, 7.8, 9.8, "A(K1 K2)+B+C"),
    stiffness(40, k50, 54, 196, 10, 14, 18, "A(K1 K2)+B+C"),
    stiffness(45, k50, 76, 275, 15, 20, 26, "A(K1 K2)+C"),
    stiffness(50, k50, 108, 382, 20, 28, 34, "A(K1 K2)+B+C"),
    stiffness(58, k50, 168, 598, 31, 44, 54, "A(K1 K2)+B+C"),
    stiffness(65, k50, 235, 843, 44, 61, 78, "A(K1 K2)+C"),
    stiffness(80, k50, 430, 1570, 81, 115, 145, "A(K1 K2)+C"),
    stiffness(90, k50, 618, 2260, 118, 162, 206, "A(K1 K2)+C"),
    stiffness(100, k50, 843, 3040, 162, 222, kNone, "A"),
    stiffness(11, k80, 0.8, 2.0, 0.27, 0.34, 0.44, "C(SHG/HFUS)"),
    stiffness(14, k80, 2.0, 6.9, 0.47, 0.61, 0.71, "B+C"),
    stiffness(17, k80, 3.9, 12, 1.0, 1.4, 1.6, "B+C"),
    stiffness(20, k80, 7.0, 25, 1.6, 2.5, 2.9, "B+C"),
    stiffness(25, k80, 14, 48, 3.1, 5.0, 5.7, "B+C"),
    stiffness(32, k80, 29, 108, 6.7, 11, 12, "B+C"),
    stiffness(40, k80, 54, 196, 13, 20, 23, "B+C"),
    stiffness(45, k80, 76, 275, 18, 29, 33, "C"),
    stiffness(50, k80, 108, 382, 25, 40, 44, "B+C"),
    stiffness(58, k80, 168, 598, 40, 61, 71, "B+C"),
    stiffness(65, k80, 235, 843, 54, 88, 98, "C"),
    stiffness(80, k80, 430, 1570, 100, 162, 185, "C"),
    stiffness(90, k80, 618, 2260, 145, 230, 263, "C"),
};

constexpr FlexsplineForm kCup = FlexsplineForm::cup;
constexpr FlexsplineForm kHat = FlexsplineForm::hat;
constexpr FlexsplineLength kShort = FlexsplineLength::short_length;
constexpr FlexsplineLength kFlat = FlexsplineLength::flat;
constexpr RowOrigin kOther = RowOrigin::other_series;
constexpr RowOrigin kRepeat = RowOrigin::repeat;

const StiffnessRow kOtherSeries[] = {
    //    series         form  length  origin  size ratio T1    T2    K1     K2     K3     sources
    other("FHA-C mini/RSF-B", kCup, kShort, kRepeat, 8, 50, 0.29, 0.75, 0.044, 0.067, kNone, "D"),
    other("FHA-C mini/RSF-B", kCup, kShort, kOther, 8, 100, 0.29, 0.75, 0.091, 0.10, 0.12, "D"),
    other("FHA-C", kHat, kFlat, kOther, 20, 50, 7.0, 25, 1.1, 1.3, kNone, "E"),
    other("FHA-C", kHat, kFlat, kOther, 20, 100, 7.0, 25, 1.3, 1.7, kNone, "E"),
    other("FHA-C", kHat, kFlat, kOther, 20, 160, 7.0, 25, 1.3, 1.7, kNone, "E"),
    other("FHA-C", kHat, kFlat, kOther, 40, 50, 54, 196, 8.8, kNone, kNone, "E"),
    other("FHA-C", kHat, kFlat, kOther, 40, 100, 54, 196, 11, kNone, kNone, "E"),
    other("FHA-C", kHat, kFlat, kOther, 40, 160, 54, 196, 11, kNone, kNone, "E"),
};

constexpr RatingRow kRatings[] = {
    //     series  size ratio peak average rated momentary max average inertia
    rating("CSG", 14, 50, 23, 9, 7, 46, 8500, 3500, 0.033),
    rating("CSG", 14, 80, 30, 14, 10, 58, 8500, 3500, 0.033),
    rating("CSG", 14, 100, 36, 14, 10, 58, 8500, 3500, 0.033),
    rating("CSG", 17, 50, 44, 34, 21, 91, 7300, 3500, 0.079),
    rating("CSG", 17, 80, 56, 35, 29, 109, 7300, 3500, 0.079),
    rating("CSG", 17, 100, 70, 51, 31, 109, 7300, 3500, 0.079),
    rating("CSG", 20, 50, 73, 44, 33, 127, 6500, 3500, 0.193),
    rating("CSG", 20, 80, 96, 61, 44, 165, 6500, 3500, 0.193),
    rating("CSG", 20, 100, 107, 64, 52, 191, 6500, 3500, 0.193),
    rating("CSG", 25, 50, 127, 72, 51, 242, 5600, 3500, 0.413),
    rating("CSG", 25, 80, 178, 113, 82, 332, 5600, 3500, 0.413),
    rating("CSG", 25, 100, 204, 140, 87, 369, 5600, 3500, 0.413),
    rating("CSG", 32, 50, 281, 140, 99, 497, 4800, 3500, 1.69),
    rating("CSG", 32, 80, 395, 217, 153, 738, 4800, 3500, 1.69),
    rating("CSG", 32, 100, 433, 281, 178, 841, 4800, 3500, 1.69),
    rating("CSG", 40, 50, 523, 255, 178, 892, 4000, 3000, 4.50),
    rating("CSG", 40, 80, 675, 369, 268, 1270, 4000, 3000, 4.50),
    rating("CSG", 40, 100, 738, 484, 345, 1400, 4000, 3000, 4.50),
    rating("CSG", 45, 50, 650, 345, 229, 1235, 3800, 3000, 8.68),
    rating("CSG", 45, 80, 918, 507, 407, 1651, 3800, 3000, 8.68),
    rating("CSG", 45, 100, 982, 650, 459, 2041, 3800, 3000, 8.68),
    rating("HFUC", 50, 50, 715, 175, 122, 1430, 3500, 2500, 12.5),
    rating("CSG", 50, 80, 1223, 675, 484, 2418, 3500, 2500, 12.5),
    rating("CSG", 50, 100, 1274, 866, 611, 2678, 3500, 2500, 12.5),
    rating("HFUC", 58, 50, 1020, 260, 176, 1960, 3000, 2200, 27.3),
    rating("CSG", 58, 80, 1924, 1001, 714, 3185, 3000, 2200, 27.3),
    rating("CSG", 58, 100, 2067, 1378, 905, 4134, 3000, 2200, 27.3),
    rating("HFUC", 65, 50, 1420, 360, 245, 2830, 2800, 1900, 46.8),
    rating("CSG", 65, 80, 2743, 1352, 969, 4836, 2800, 1900, 46.8),
    rating("CSG", 65, 100, 2990, 1976, 1236, 6175, 2800, 1900, 46.8),
    rating("HFUC", 80, 50, 2440, 630, 436, 4870, 2300, 1500, 122),
    rating("HFUC", 80, 80, 3430, 1830, 1320, 6590, 2300, 1500, 122),
    rating("HFUC", 80, 100, 4220, 2360, 1700, 7910, 2300, 1500, 122),
    rating("HFUC", 90, 50, 3530, 860, 590, 6660, 2000, 1300, 214),
    rating("HFUC", 90, 80, 3990, 2510, 1550, 7250, 2000, 1300, 214),
    rating("HFUC", 90, 100, 5680, 3360, 2270, 9020, 2000, 1300, 214),
};
// clang-format on

}  // namespace

std::span<const StiffnessRow> stiffness_rows() { return kStiffness; }
std::span<const StiffnessRow> other_series_rows() { return kOtherSeries; }
std::span<const RatingRow> rating_rows() { return kRatings; }

std::span<const FrictionRow> friction_rows() {
  static constexpr FrictionRow kRows[] = {
      // series, size, ratio, rated, efficiency, no load, starting, back-driving
      {"RT1-H-CS", 14, 100, 10, 0.67, 35e-3, 21e-3, 2.21},
      {"RT1-H-CS", 17, 100, 31, 0.77, 51e-3, 29e-3, 3.06},
      {"RT1-H-CS", 20, 100, 52, 0.77, 105e-3, 37e-3, 3.89},
      {"RT1-H-CS", 25, 100, 87, 0.77, 195e-3, 69e-3, 7.26},
  };
  return kRows;
}

}  // namespace strainwave

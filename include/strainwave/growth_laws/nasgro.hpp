// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/power.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// Newman's crack opening (GR-7).
struct NewmanClosure {
  double constraint = 2.0;    ///< alpha [-]; 1 for plane stress to 3 for plane strain
  double stress_level = 0.3;  ///< s = S_max/sigma_0 [-]; in (0, 1)

  /// A_0, the opening at R = 0.
  [[nodiscard]] double at_zero() const {
    const double alpha = constraint;
    return (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) *
           std::pow(std::cos(std::numbers::pi * stress_level / 2), 1 / alpha);
  }
  /// f = K_op/K_max.
  /// @param ratio  R [-]; < 1
  [[nodiscard]] double opening(double ratio) const { return opening(ratio, at_zero()); }
  /// The same with A_0 given, because its computation takes most of the time.
  [[nodiscard]] double opening(double ratio, double A0) const {
    const double A1 = (0.415 - 0.071 * constraint) * stress_level;
    if (ratio < 0) return A0 + A1 * std::max(ratio, -2.0);
    const double A3 = 2 * A0 + A1 - 1;
    const double A2 = 1 - A0 - A1 - A3;
    return std::max(ratio, A0 + ratio * (A1 + ratio * (A2 + ratio * A3)));
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "constraint",
                .unit = "1",
                .doc = "alpha, 1 in plane stress to 3 in plane strain",
                .range = {.lower = 1.0, .lower_open = false, .upper = 3.0, .upper_open = false},
                .example = "2.5"},
          &NewmanClosure::constraint);
    field(Field{.name = "stress_level",
                .unit = "1",
                .doc = "S_max/sigma_0, largest stress over the flow stress",
                .range = {.lower = 0.0, .upper = 1.0},
                .example = "0.3",
                .fallback = "0.3"},
          &NewmanClosure::stress_level);
  }
};

/// How the threshold depends on the stress ratio.
enum class NasgroThreshold {
  from_zero,  ///< the datum is Delta K_0 at R = 0 (GR-9)
  from_one,   ///< the datum is Delta K_1 for R -> 1 (GR-10)
};
template <>
struct EnumNames<NasgroThreshold> {
  static constexpr std::array<std::string_view, 2> names = {"from_zero", "from_one"};
};

/// Toughness of a through crack over the thickness (GR-11).
struct ToughnessOverThickness {
  double plane_strain_toughness = 0.0;  ///< K_Ic [Pa*m^0.5]; > 0
  double A = 0.0;                       ///< A_k [-]; >= 0
  double B = 0.0;                       ///< B_k [-]; >= 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "plane_strain_toughness",
                .unit = "Pa*m^0.5",
                .doc = "K_Ic",
                .range = kPositive,
                .example = R"("60 MPa*m^0.5")"},
          &ToughnessOverThickness::plane_strain_toughness);
    field(Field{.name = "A", .unit = "1", .doc = "A_k", .range = kNonNegative, .example = "0.75"},
          &ToughnessOverThickness::A);
    field(Field{.name = "B", .unit = "1", .doc = "B_k", .range = kNonNegative, .example = "0.5"},
          &ToughnessOverThickness::B);
  }
};

class PreparedNasgro;

/// da/dN = C [(1 - f)/(1 - R) Delta K/K_1]^n (1 - Delta K_th/Delta K)^p/(1 - K_max/K_c)^q (GR-8).
///
/// R < 0: Delta K is the full range; the opening f lets only a part of it count.
struct Nasgro {
  static constexpr std::string_view kKind = "nasgro";
  static constexpr std::string_view kMeaning = "NASGRO equation with Newman's crack opening";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 2> kEquations = {"GR-7", "GR-8"};
  double coefficient = 0.0;           ///< C [m]; > 0
  double exponent = 0.0;              ///< n [-]; > 0
  double threshold_exponent = 0.0;    ///< p [-]; >= 0
  double instability_exponent = 0.0;  ///< q [-]; >= 0
  double toughness = 0.0;             ///< K_Ie of a part-through crack, or K_c [Pa*m^0.5]; > 0
  NewmanClosure closure;
  NasgroThreshold form = NasgroThreshold::from_one;
  double threshold_datum = 0.0;  ///< Delta K_0 or Delta K_1 [Pa*m^0.5]; > 0
  double slope_plus = 0.0;       ///< C_th of R >= 0 [-]
  double slope_minus = 0.0;      ///< C_th of R < 0 [-]
  double intrinsic_size = 0.0;   ///< a_0 of short cracks [m]; >= 0
  /// toughness of through cracks; absent: `toughness` holds for them too
  std::optional<ToughnessOverThickness> over_thickness = {};

  /// The law with A_0 computed once.
  [[nodiscard]] PreparedNasgro prepared() const;
  /// As PreparedNasgro::threshold.
  [[nodiscard]] double threshold(double ratio, double crack_size) const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto pure = [&](std::string_view name, std::string_view doc, std::string_view example,
                          const Range& range, auto member) {
      field(Field{.name = name, .unit = "1", .doc = doc, .range = range, .example = example},
            member);
    };
    field(law_fields::kCoefficient, &Nasgro::coefficient);
    field(law_fields::kExponent, &Nasgro::exponent);
    pure("threshold_exponent", "p", "0.25", kNonNegative, &Nasgro::threshold_exponent);
    pure("instability_exponent", "q", "0.25", kNonNegative, &Nasgro::instability_exponent);
    field(law_fields::toughness("K_c of a through crack, K_Ie of a part-through crack"),
          &Nasgro::toughness);
    field(Field{.name = "closure", .unit = "", .doc = "crack opening"}, &Nasgro::closure);
    field(
        Field{.name = "form",
              .unit = "",
              .doc = "stress ratio of the threshold's datum: Delta K_0 at R = 0, or Delta K_1 for "
                     "R near 1",
              .example = R"("from_one")",
              .fallback = R"("from_one")"},
        &Nasgro::form);
    field(Field{.name = "threshold_datum",
                .unit = "Pa*m^0.5",
                .doc = "Delta K_0 or Delta K_1 of long cracks",
                .range = kPositive,
                .example = R"("2.2 MPa*m^0.5")"},
          &Nasgro::threshold_datum);
    pure("slope_plus", "C_th of R >= 0", "1.4", kFinite, &Nasgro::slope_plus);
    pure("slope_minus", "C_th of R < 0", "-0.1", kFinite, &Nasgro::slope_minus);
    field(Field{.name = "intrinsic_size",
                .unit = "m",
                .doc = "a_0 of short cracks; 0: their threshold is that of long cracks",
                .range = kNonNegative,
                .example = R"("38.1 um")",
                .fallback = R"("0 m")"},
          &Nasgro::intrinsic_size);
    field(Field{.name = "over_thickness",
                .unit = "",
                .doc = "toughness of through cracks over the thickness",
                .in_template = InTemplate::commented},
          &Nasgro::over_thickness);
  }
};

/// NASGRO with the opening at R = 0, which depends on no cycle and takes most of the time.
class PreparedNasgro {
 public:
  /// @param law  its constants are in range (require_constants)
  explicit PreparedNasgro(const Nasgro& law)
      : law_(law), A0_(law.closure.at_zero()), open_at_zero_(std::log1p(-A0_)) {}

  /// Delta K_th, full range [Pa*m^0.5].
  ///
  /// Below R = -2, where the opening has no further data, K_max at the threshold stays.
  /// @param ratio       R [-]; < 1
  /// @param crack_size  a [m]; > 0
  [[nodiscard]] double threshold(double ratio, double crack_size) const {
    return threshold_of(ratio, law_.closure.opening(ratio, A0_), crack_size);
  }

  /// da/dN [m]; 0 up to the threshold; K_max < K_c.
  [[nodiscard]] double rate(const TipCycle& cycle, double crack_size) const {
    const double f = law_.closure.opening(cycle.ratio, A0_);
    const double over = 1 - threshold_of(cycle.ratio, f, crack_size) / cycle.full_range();
    if (!(over > 0)) return 0.0;
    const double effective = (1 - f) * cycle.largest / units::MPa;
    return law_.coefficient * power(effective, law_.exponent) *
           power(over, law_.threshold_exponent) /
           power(1 - cycle.largest / law_.toughness, law_.instability_exponent);  // (GR-8)
  }

 private:
  [[nodiscard]] double threshold_of(double ratio, double f, double crack_size) const {
    const double R = std::max(ratio, -2.0);
    const double below = (1 - ratio) / (1 - R);  // 1 from R = -2 on
    const double datum =
        below * law_.threshold_datum * std::sqrt(crack_size / (crack_size + law_.intrinsic_size));
    const double slope = R < 0 ? law_.slope_minus : law_.slope_plus;
    // One logarithm and one exponential in place of two powers.
    const double open = (1 + R * slope) * std::log((1 - f) / (1 - R));
    if (law_.form == NasgroThreshold::from_zero)
      return datum * std::exp((1 + R * slope) * open_at_zero_ - open);               // (GR-9)
    return datum * std::exp(-open - (law_.slope_plus - R * slope) * open_at_zero_);  // (GR-10)
  }

  Nasgro law_;
  double A0_;
  double open_at_zero_;  // ln(1 - A_0)
};

inline PreparedNasgro Nasgro::prepared() const { return PreparedNasgro(*this); }
inline double Nasgro::threshold(double ratio, double crack_size) const {
  return prepared().threshold(ratio, crack_size);
}

/// Toughness of a through crack over the thickness (GR-11) [Pa*m^0.5].
/// @param plane_strain_toughness  K_Ic [Pa*m^0.5]; > 0
/// @param yield_strength          [Pa]; > 0
/// @param thickness               t [m]; > 0
/// @param A                       A_k [-]; >= 0
/// @param B                       B_k [-]; >= 0
/// @throws InputError             if a number is out of range
[[nodiscard]] double toughness_of_thickness(double plane_strain_toughness, double yield_strength,
                                            double thickness, double A, double B);

}  // namespace strainwave

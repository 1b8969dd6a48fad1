// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// Measured rates over Delta K at one stress ratio.
struct RateCurve {
  double stress_ratio = 0.0;    ///< R [-]; < 1
  std::vector<double> delta_K;  ///< full range, strictly rising [Pa*m^0.5]; > 0
  std::vector<double> rate;     ///< da/dN at each of them, strictly rising [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "stress_ratio",
                .unit = "1",
                .doc = "R of the curve; larger than that of the curve before",
                .range = {.upper = 1.0},
                .example = "0.1"},
          &RateCurve::stress_ratio);
    field(Field{.name = "delta_K",
                .unit = "Pa*m^0.5",
                .doc = "full ranges of K, rising; the first one is the threshold",
                .range = kPositive,
                .example = R"(["5 MPa*m^0.5", "10 MPa*m^0.5", "40 MPa*m^0.5"])"},
          &RateCurve::delta_K);
    field(Field{.name = "rate",
                .unit = "m",
                .doc = "growth per cycle at each range, rising",
                .range = kPositive,
                .example = R"(["1e-10 m", "7e-9 m", "4.5e-7 m"])",
                .usual = {.lower = 1e-14, .upper = 1e-2}},
          &RateCurve::rate);
  }
};

/// The curves of a table, ready to give rates (GR-36).
class TableOfRates {
 public:
  /// A table that breaks a rule of its curves gives no number.
  explicit TableOfRates(const std::vector<RateCurve>& curves);

  /// da/dN [m]; 0 up to the threshold.
  [[nodiscard]] double rate(const TipCycle& cycle) const;
  /// Delta K of the first points at a stress ratio, full range [Pa*m^0.5]
  [[nodiscard]] double threshold(double ratio) const;
  /// Delta K of the last points at a stress ratio, full range [Pa*m^0.5]
  [[nodiscard]] double last(double ratio) const;

 private:
  struct Curve {
    double ratio;
    double first;           // Delta K of the threshold
    std::vector<double> x;  // ln Delta K
    std::vector<double> y;  // ln da/dN
    [[nodiscard]] double at(double x_wanted) const;
  };
  /// The curves below and above a stress ratio, and the share of the one above; outside of the
  /// curves both are the end curve.
  struct Between {
    const Curve* low;
    const Curve* high;
    double share;
  };
  [[nodiscard]] Between between(double ratio) const;

  std::vector<Curve> curves_;
};

/// ln(da/dN) over ln(Delta K) by straight lines between measured points, at several R (GR-36).
///
/// R < 0: Delta K is the full range; without a curve at such an R, the curve of the least R holds,
/// which is on the safe side.
struct Tabulated {
  static constexpr std::string_view kKind = "tabulated";
  static constexpr std::string_view kMeaning = "rates from a table over the range of K and R";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-36"};
  std::vector<RateCurve> curve;  ///< at rising R; at least one of at least two points

  /// The curves, ready to give rates.
  [[nodiscard]] TableOfRates prepared() const { return TableOfRates(curve); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "curve", .unit = "", .doc = "rates at one stress ratio, at rising R"},
          &Tabulated::curve);
  }
};

}  // namespace strainwave

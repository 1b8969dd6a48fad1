// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_laws/rate_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kToughness = "Pa*m^0.5";

/// The toughness of the law itself.
std::optional<double> own_toughness(const RateLaw& law) {
  return std::visit(
      [](const auto& l) -> std::optional<double> {
        if constexpr (requires { l.toughness; })
          return l.toughness;
        else
          return {};
      },
      law);
}

void positive(std::string_view name, double value, std::string_view unit) {
  require(value > 0 && std::isfinite(value), name, value, unit, "> 0");
}
void not_negative(std::string_view name, double value, std::string_view unit) {
  require(value >= 0 && std::isfinite(value), name, value, unit, ">= 0");
}

template <class Law>
void power(const Law& law) {
  positive("coefficient", law.coefficient, "m");
  positive("exponent", law.exponent, "1");
}

void check(const Paris& law) { power(law); }
void check(const TwoLines& law) {
  power(law);
  positive("upper_coefficient", law.upper_coefficient, "m");
  positive("upper_exponent", law.upper_exponent, "1");
  positive("meet", law.meet, kToughness);
  const TipCycle meets{.largest = law.meet};
  const double step = law.high().rate(meets) / law.low().rate(meets) - 1;
  require(std::abs(step) <= 0.01, "meet", law.meet, kToughness,
          "a Delta K at which both laws agree within 1 % (MA-3)");
}
void check(const Walker& law) {
  power(law);
  require(law.gamma >= 0 && law.gamma <= 1, "gamma", law.gamma, "1", "0 to 1");
}
void check(const Forman& law) {
  power(law);
  positive("toughness", law.toughness, kToughness);
}
void check(const HartmanSchijve& law) {
  power(law);
  not_negative("threshold", law.threshold, kToughness);
  positive("toughness", law.toughness, kToughness);
}
void check(const Nasgro& law) {
  power(law);
  not_negative("threshold_exponent", law.threshold_exponent, "1");
  not_negative("instability_exponent", law.instability_exponent, "1");
  positive("toughness", law.toughness, kToughness);
  require(law.closure.constraint >= 1 && law.closure.constraint <= 3, "constraint",
          law.closure.constraint, "1", "1 to 3");
  require(law.closure.stress_level > 0 && law.closure.stress_level < 1, "stress_level",
          law.closure.stress_level, "1", "between 0 and 1");
  positive("threshold_datum", law.threshold_datum, kToughness);
  require(std::isfinite(law.slope_plus), "slope_plus", law.slope_plus, "1", "a finite number");
  require(std::isfinite(law.slope_minus), "slope_minus", law.slope_minus, "1", "a finite number");
  not_negative("intrinsic_size", law.intrinsic_size, "m");
}

void check(const RateCurve& curve, const FieldPath& at) {
  const FieldPath ranges = at / "delta_K";
  const FieldPath rates = at / "rate";
  require(curve.stress_ratio < 1 && std::isfinite(curve.stress_ratio), (at / "stress_ratio").text(),
          curve.stress_ratio, "1", "< 1");
  if (curve.delta_K.size() < 2)
    throw InputError(ranges.text(), "must have at least two values, the first one the threshold");
  if (curve.rate.size() != curve.delta_K.size())
    throw InputError(rates.text(), fmt::format("has {} values, but delta_K has {}",
                                               curve.rate.size(), curve.delta_K.size()));
  const auto rises = [](const std::vector<double>& values, const FieldPath& path,
                        std::string_view unit) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      positive(path[i].text(), values[i], unit);
      if (i > 0 && !(values[i] > values[i - 1]))
        throw InputError(path[i].text(), "must be larger than the value before");
    }
  };
  rises(curve.delta_K, ranges, kToughness);
  rises(curve.rate, rates, "m");
}
void check(const Tabulated& law) {
  const FieldPath at("curve");
  if (law.curve.empty()) throw InputError("curve", "must be given: rates at one or more R");
  for (std::size_t i = 0; i < law.curve.size(); ++i) {
    check(law.curve[i], at[i]);
    if (i > 0 && !(law.curve[i].stress_ratio > law.curve[i - 1].stress_ratio))
      throw InputError((at[i] / "stress_ratio").text(), "must be larger than in the curve before");
  }
}

void require_limits(const GrowthLimits& limits) {
  if (limits.threshold) positive("threshold", *limits.threshold, kToughness);
  not_negative("intrinsic_size", limits.intrinsic_size, "m");
  if (limits.toughness) positive("toughness", *limits.toughness, kToughness);
}

}  // namespace

void require_constants(const RateLaw& law) {
  std::visit([](const auto& l) { check(l); }, law);
}

PreparedLaw::PreparedLaw(RateLaw law) : law_(std::move(law)), toughness_(own_toughness(law_)) {
  std::visit(
      [this](const auto& l) {
        if constexpr (requires { l.prepared(); })
          ready_ = l.prepared();
        else
          ready_ = l;
      },
      law_);
}

double PreparedLaw::rate(const TipCycle& cycle, double crack_size) const {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.rate(cycle, crack_size); })
          return l.rate(cycle, crack_size);
        else
          return l.rate(cycle);
      },
      ready_);
}

std::optional<double> PreparedLaw::threshold(double ratio, double crack_size) const {
  return std::visit(
      [&](const auto& l) -> std::optional<double> {
        if constexpr (requires { l.threshold(ratio, crack_size); })
          return l.threshold(ratio, crack_size);
        else if constexpr (requires { l.threshold(ratio); })
          return l.threshold(ratio);
        else
          return {};
      },
      ready_);
}

GrowthRate growth_rate(const RateLaw& law, const TipCycle& cycle, double crack_size,
                       const GrowthLimits& limits) {
  return growth_rate(PreparedLaw(law), cycle, crack_size, limits);
}

GrowthRate growth_rate(const PreparedLaw& law, const TipCycle& cycle, double crack_size,
                       const GrowthLimits& limits) {
  require(std::isfinite(cycle.largest), "K_max", cycle.largest, kToughness, "a finite number");
  require(crack_size > 0 && std::isfinite(crack_size), "crack_size", crack_size, "m", "> 0");
  require_limits(limits);
  if (!(cycle.largest > 0)) return {};  // the whole cycle presses; its R has no meaning
  require(cycle.ratio < 1 && std::isfinite(cycle.ratio), "R", cycle.ratio, "1", "< 1");
  for (const std::optional<double>& toughness : {law.toughness(), limits.toughness})
    if (toughness && cycle.largest >= *toughness) return {0.0, TipState::breaks};
  if (limits.threshold) {
    const double least = *limits.threshold *
                         std::sqrt(crack_size / (crack_size + limits.intrinsic_size));  // (GR-12)
    if (cycle.full_range() <= least) return {};
  }
  const double rate = law.rate(cycle, crack_size);
  if (std::isnan(rate))
    throw InputError("law", "its constants give no number; require_constants names the constant");
  return rate > 0 ? GrowthRate{rate, TipState::grows} : GrowthRate{};
}

RateLaw law_of_through_crack(const RateLaw& law, double thickness,
                             std::optional<double> yield_strength) {
  const auto* const stated = std::get_if<Nasgro>(&law);
  if (stated == nullptr || !stated->over_thickness) return law;
  if (!yield_strength)
    throw InputError("yield_strength",
                     "must be given: the toughness over the thickness depends on it");
  Nasgro through = *stated;
  through.toughness =
      toughness_of_thickness(stated->over_thickness->plane_strain_toughness, *yield_strength,
                             thickness, stated->over_thickness->A, stated->over_thickness->B);
  return through;
}

double toughness_of_thickness(double plane_strain_toughness, double yield_strength,
                              double thickness, double A, double B) {
  positive("plane_strain_toughness", plane_strain_toughness, kToughness);
  positive("yield_strength", yield_strength, "Pa");
  positive("thickness", thickness, "m");
  not_negative("thickness_A", A, "1");
  not_negative("thickness_B", B, "1");
  const double zone = plane_strain_toughness / yield_strength;
  const double over = A * thickness / (2.5 * zone * zone);
  return plane_strain_toughness * (1 + B * std::exp(-over * over));  // (GR-11)
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool takes_prefix;
};

constexpr Dimension kOne = {};
constexpr Dimension kLength = {1, 0, 0, 0, 0, 0};
constexpr Dimension kMass = {0, 1, 0, 0, 0, 0};
constexpr Dimension kTime = {0, 0, 1, 0, 0, 0};
constexpr Dimension kTemperature = {0, 0, 0, 1, 0, 0};
constexpr Dimension kAngle = {0, 0, 0, 0, 1, 0};
constexpr Dimension kFrequency = {0, 0, -1, 0, 0, 0};
constexpr Dimension kSpeed = {0, 0, -1, 0, 1, 0};
constexpr Dimension kForce = {1, 1, -2, 0, 0, 0};
constexpr Dimension kTorque = {2, 1, -2, 0, 0, 0};
constexpr Dimension kStress = {-1, 1, -2, 0, 0, 0};
constexpr Dimension kEnergy = {2, 1, -2, 0, 0, 1};
constexpr Dimension kPower = {2, 1, -3, 0, 0, 1};

// To support a new unit, add a line here.
constexpr NamedUnit kUnits[] = {
    {"1", {1.0, kOne}, false},
    {"%", {0.01, kOne}, false},
    {"m", {1.0, kLength}, true},
    {"g", {1e-3, kMass}, true},
    {"s", {1.0, kTime}, true},
    {"min", {60.0, kTime}, false},
    {"h", {3600.0, kTime}, false},
    {"K", {1.0, kTemperature}, true},
    {"rad", {1.0, kAngle}, true},
    {"deg", {units::deg, kAngle}, false},
    {"arcmin", {units::arcmin, kAngle}, false},
    {"arcsec", {units::arcsec, kAngle}, false},
    {"Hz", {1.0, kFrequency}, true},
    {"rpm", {units::rpm, kSpeed}, false},
    {"N", {1.0, kForce}, true},
    {"Nm", {1.0, kTorque}, true},
    {"Pa", {1.0, kStress}, true},
    {"J", {1.0, kEnergy}, true},
    {"W", {1.0, kPower}, true},
};

struct Prefix {
  std::string_view symbol;
  double factor;
};

constexpr Prefix kPrefixes[] = {{"n", 1e-9},        {"u", 1e-6}, {"\xC2\xB5", 1e-6},
                                {"\xCE\xBC", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                                {"k", 1e3},         {"M", 1e6},  {"G", 1e9}};

const Unit* known_unit(std::string_view symbol, bool prefixed) {
  const auto* const found = std::ranges::find(kUnits, symbol, &NamedUnit::symbol);
  return found != std::end(kUnits) && (!prefixed || found->takes_prefix) ? &found->unit : nullptr;
}

/// Reads one unit expression; error messages name `field` and quote `whole`.
class UnitParser {
 public:
  UnitParser(std::string_view field, std::string_view whole, std::string_view unit)
      : field_(field), whole_(whole), rest_(unit) {}

  Unit parse() {
    const Unit unit = product(0);
    if (!rest_.empty()) refuse("has something after the unit");
    return unit;
  }

 private:
  // Units do not need deeper nesting, and a limit prevents hostile input from exhausting the stack.
  static constexpr int kMaxDepth = 8;

  [[noreturn]] void refuse(std::string_view why) const {
    throw InputError(field_, fmt::format("\"{}\" {}", shown(whole_), why));
  }

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  Unit product(int depth) {
    Unit result = power(depth);
    while (!rest_.empty() && rest_.front() != ')') {
      const double sign = take('*') ? 1.0 : take('/') ? -1.0 : 0.0;
      if (sign == 0.0) refuse("may have only * / ^ and parentheses between units");
      multiply(result, power(depth), sign);
    }
    return result;
  }

  Unit power(int depth) {
    Unit base = factor(depth);
    if (!take('^')) return base;
    const std::size_t length = number_length(rest_);
    const std::optional<double> exponent = parse_number(rest_.substr(0, length));
    if (!exponent || std::abs(*exponent) > 12.0)
      refuse("needs a number between -12 and 12 after ^");
    rest_.remove_prefix(length);
    Unit result;
    multiply(result, base, *exponent);
    return result;
  }

  Unit factor(int depth) {
    if (take('(')) {
      if (depth == kMaxDepth) refuse("has too many nested parentheses");
      const Unit inner = product(depth + 1);
      if (!take(')')) refuse("has an opening parenthesis that is not closed");
      return inner;
    }
    const std::size_t n = std::min(rest_.find_first_of("*/^()"), rest_.size());
    const std::string_view symbol = rest_.substr(0, n);
    rest_.remove_prefix(n);
    if (const Unit* const unit = known_unit(symbol, false)) return *unit;
    for (const auto& [prefix, scale] : kPrefixes) {
      if (!symbol.starts_with(prefix)) continue;
      if (const Unit* const unit = known_unit(symbol.substr(prefix.size()), true))
        return {scale * unit->factor, unit->dimension};
    }
    refuse(symbol.empty()
               ? "lacks a unit where one is due"
               : fmt::format("has the unknown unit \"{}\"; known are products such as mm, N*m/rad "
                             "or MPa*m^0.5",
                             shown(symbol)));
  }

  static void multiply(Unit& result, const Unit& by, double exponent) {
    result.factor *= std::pow(by.factor, exponent);
    for (std::size_t i = 0; i < result.dimension.size(); ++i)
      result.dimension[i] += exponent * by.dimension[i];
  }

  std::string_view field_;
  std::string_view whole_;
  std::string_view rest_;
};

bool same_dimension(const Dimension& a, const Dimension& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < 1e-9; });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

Unit parse_unit(std::string_view text) { return UnitParser("unit", text, text).parse(); }

double parse_quantity(std::string_view field, std::string_view text, std::string_view unit) {
  const auto refuse = [&](std::string_view why) {
    throw InputError(field, fmt::format("\"{}\" {}", shown(text), why));
  };
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  const std::size_t length = number_length(rest);
  if (length == 0) refuse("must start with a finite number, such as 2.24 or 1.2e5");
  const std::optional<double> number = parse_number(rest.substr(0, length));
  if (!number) refuse("has a number that is too large or too small");
  rest.remove_prefix(length);
  if (rest.starts_with(',')) refuse("has a comma; write a decimal point");
  rest = trimmed(rest);
  if (rest.empty() && unit != "1")
    refuse(fmt::format("has no unit; it must be convertible to {}", unit));
  const Unit given = rest.empty() ? Unit{} : UnitParser(field, text, rest).parse();
  if (!same_dimension(given.dimension, parse_unit(unit).dimension))
    refuse(fmt::format("is not convertible to {}", unit));
  const double value = *number * given.factor;
  if (!std::isfinite(value)) refuse("is too large");
  return value;
}

std::string quantity_text(double value, std::string_view unit) {
  return unit == "1" ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

}  // namespace strainwave

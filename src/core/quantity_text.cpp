// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

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

// One line per unit: to support a new unit, add a line here.
constexpr KnownUnit kUnits[] = {
    {"1", {1.0, kOne, 0}, "pure number", false},
    {"%", {0.01, kOne, -2}, "pure number", false},
    {"m", {1.0, kLength, 0}, "length", true},
    {"in", {0.0254, kLength, {}}, "length", false},
    {"ft", {0.3048, kLength, {}}, "length", false},
    {"g", {1e-3, kMass, -3}, "mass", true},
    {"s", {1.0, kTime, 0}, "time", true},
    {"min", {60.0, kTime, {}}, "time", false},
    {"h", {3600.0, kTime, {}}, "time", false},
    {"K", {1.0, kTemperature, 0}, "temperature", true},
    {"rad", {1.0, kAngle, 0}, "angle", true},
    {"deg", {units::deg, kAngle, {}}, "angle", false},
    {"\xC2\xB0", {units::deg, kAngle, {}}, "angle", false},
    {"arcmin", {units::arcmin, kAngle, {}}, "angle", false},
    {"\xE2\x80\xB2", {units::arcmin, kAngle, {}}, "angle", false},
    {"arcsec", {units::arcsec, kAngle, {}}, "angle", false},
    {"\xE2\x80\xB3", {units::arcsec, kAngle, {}}, "angle", false},
    {"Hz", {1.0, kFrequency, 0}, "frequency", true},
    {"rpm", {units::rpm, kSpeed, {}}, "rotational speed", false},
    {"N", {1.0, kForce, 0}, "force", true},
    {"lbf", {units::lbf, kForce, {}}, "force", false},
    {"Nm", {1.0, kTorque, 0}, "torque", true},
    {"Nmm", {1e-3, kTorque, -3}, "torque", false},
    {"Pa", {1.0, kStress, 0}, "stress", true},
    {"psi", {units::psi, kStress, {}}, "stress", false},
    {"ksi", {1e3 * units::psi, kStress, {}}, "stress", false},
    {"J", {1.0, kEnergy, 0}, "energy", true},
    {"W", {1.0, kPower, 0}, "power", true},
};

constexpr UnitPrefix kPrefixes[] = {{"n", -9},        {"u", -6}, {"\xC2\xB5", -6},
                                    {"\xCE\xBC", -6}, {"m", -3}, {"c", -2},
                                    {"k", 3},         {"M", 6},  {"G", 9}};

/// A sign of typeset text and how a unit is written without it.
struct TypesetSign {
  std::string_view sign;
  std::string_view plain;
};
constexpr TypesetSign kSigns[] = {
    {"\xC2\xB7", "*"},                                                    // middle dot
    {"\xE2\x8B\x85", "*"},                                                // dot operator
    {"\xC3\x97", "*"},                                                    // multiplication sign
    {"\xE2\x88\x92", "-"},                                                // minus
    {"\xC2\xA0", " "},     {"\xE2\x80\x89", " "}, {"\xE2\x80\xAF", " "},  // narrow blanks
};
constexpr std::string_view kRootOfMetre = "\xE2\x88\x9Am";
constexpr TypesetSign kRaised[] = {
    {"\xE2\x81\xBB", "-"}, {"\xE2\x81\xB0", "0"}, {"\xC2\xB9", "1"},     {"\xC2\xB2", "2"},
    {"\xC2\xB3", "3"},     {"\xE2\x81\xB4", "4"}, {"\xE2\x81\xB5", "5"}, {"\xE2\x81\xB6", "6"},
    {"\xE2\x81\xB7", "7"}, {"\xE2\x81\xB8", "8"}, {"\xE2\x81\xB9", "9"}};

/// The text with plain characters for typeset signs: "MPa*m^0.5", "m^-2".
std::string plainly_written(std::string_view text) {
  std::string plain;
  bool raised = false;
  const auto take = [&](std::span<const TypesetSign> signs) -> const TypesetSign* {
    const auto found = std::ranges::find_if(
        signs, [&](const TypesetSign& sign) { return text.starts_with(sign.sign); });
    if (found == signs.end()) return nullptr;
    text.remove_prefix(found->sign.size());
    return &*found;
  };
  while (!text.empty()) {
    if (const TypesetSign* const digit = take(kRaised)) {
      if (!raised) plain += '^';
      plain += digit->plain;
      raised = true;
      continue;
    }
    raised = false;
    if (text.starts_with(kRootOfMetre)) {
      // "MPa√m" and "MPa √m" mean the product, as people write it.
      text.remove_prefix(kRootOfMetre.size());
      while (plain.ends_with(' ')) plain.pop_back();
      const bool behind_unit =
          !plain.empty() &&
          std::string_view("0123456789*/(").find(plain.back()) == std::string_view::npos;
      plain += behind_unit ? "*m^0.5" : "m^0.5";
      continue;
    }
    if (const TypesetSign* const sign = take(kSigns)) {
      plain += sign->plain;
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
}

/// A decimal number times a power of ten, as exact text.
/// @param text  a number as number_length knows it
std::string shifted_text(std::string_view text, int power) {
  const std::size_t e = text.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    // A number with such an exponent is too large or too small in any unit.
    if (fault != std::errc() || std::abs(exponent) > 100'000) return std::string(text);
  }
  return power == 0 ? std::string(text) : fmt::format("{}e{}", text.substr(0, e), exponent + power);
}

double power_of_ten(int power) {
  constexpr int kExact = 22;  // largest power of ten that a double holds exactly
  const double size = std::pow(10.0, std::min(std::abs(power), kExact));
  if (std::abs(power) <= kExact) return power < 0 ? 1 / size : size;
  return *parse_number(fmt::format("1e{}", power));
}

const Unit* known_unit(std::string_view symbol, bool prefixed) {
  const auto* const found = std::ranges::find(kUnits, symbol, &KnownUnit::symbol);
  return found != std::end(kUnits) && (!prefixed || found->takes_prefix) ? &found->unit : nullptr;
}

/// Reads one unit expression; error messages name `field` and quote `whole`.
class UnitParser {
 public:
  UnitParser(std::string_view field, std::string_view whole, std::string_view unit)
      : field_(field), whole_(whole), rest_(unit) {}

  Unit parse() {
    const Unit unit = product(0);
    if (!rest_.empty()) refuse("has text after the unit; remove this text");
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
      if (sign == 0.0) refuse("may contain only * / ^ and parentheses between units");
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
      refuse("needs an exponent between -12 and 12 after ^");
    rest_.remove_prefix(length);
    Unit result;
    multiply(result, base, *exponent);
    return result;
  }

  Unit factor(int depth) {
    if (take('(')) {
      if (depth == kMaxDepth) refuse("has too many nested parentheses");
      const Unit inner = product(depth + 1);
      if (!take(')')) refuse("has an opening parenthesis without a closing one");
      return inner;
    }
    const std::size_t n = std::min(rest_.find_first_of("*/^()"), rest_.size());
    const std::string_view symbol = rest_.substr(0, n);
    rest_.remove_prefix(n);
    if (const Unit* const unit = known_unit(symbol, false)) return *unit;
    for (const UnitPrefix& prefix : kPrefixes) {
      if (!symbol.starts_with(prefix.symbol)) continue;
      if (const Unit* const unit = known_unit(symbol.substr(prefix.symbol.size()), true))
        return {power_of_ten(prefix.power + *unit->power_of_ten), unit->dimension,
                prefix.power + *unit->power_of_ten};
    }
    if (const std::string product = meant_product(symbol); !product.empty())
      refuse(fmt::format("needs * between units; write {} in place of {}", product, shown(symbol)));
    if (symbol.find("sqrt") != std::string_view::npos)
      refuse("needs ^0.5 for a root, such as MPa*m^0.5");
    refuse(symbol.empty() ? "lacks a unit where the text needs one"
                          : fmt::format("has the unknown unit \"{}\"; write a unit such as mm, "
                                        "N*m/rad or MPa*m^0.5; strainwave units lists all units",
                                        shown(symbol)));
  }

  /// "N*m" for "N.m", "N-m" and "N m"; empty if the symbol is no such product.
  static std::string meant_product(std::string_view symbol) {
    std::string product(symbol);
    std::ranges::replace_if(
        product, [](char c) { return c == '.' || c == '-' || c == ' '; }, '*');
    if (product == symbol) return {};
    try {
      (void)UnitParser({}, product, product).parse();
      return product;
    } catch (const InputError&) {
      return {};
    }
  }

  static void multiply(Unit& result, const Unit& by, double exponent) {
    const double power = by.power_of_ten && result.power_of_ten
                             ? *result.power_of_ten + *by.power_of_ten * exponent
                             : 0.5;
    if (power == std::round(power) && std::abs(power) < 300) {
      result.power_of_ten = static_cast<int>(power);
      result.factor = strainwave::power_of_ten(*result.power_of_ten);
    } else {
      result.power_of_ten.reset();
      result.factor *= std::pow(by.factor, exponent);
    }
    for (std::size_t i = 0; i < result.dimension.size(); ++i)
      result.dimension[i] += exponent * by.dimension[i];
  }

  std::string_view field_;
  std::string_view whole_;
  std::string_view rest_;
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::span<const KnownUnit> known_units() { return kUnits; }

std::span<const UnitPrefix> unit_prefixes() { return kPrefixes; }

Unit parse_unit(std::string_view text) {
  return UnitParser("unit", text, plainly_written(text)).parse();
}

bool same_dimension(const Unit& a, const Unit& b) {
  return std::ranges::equal(a.dimension, b.dimension,
                            [](double x, double y) { return std::abs(x - y) < 1e-9; });
}

double parse_quantity(std::string_view field, std::string_view text, std::string_view unit) {
  const auto refuse = [&](std::string_view why) {
    throw InputError(field, fmt::format("\"{}\" {}", shown(text), why));
  };
  const std::string plain = plainly_written(text);
  std::string_view rest = trimmed(plain);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  const std::size_t length = number_length(rest);
  if (length == 0) refuse("must start with a finite number, such as 2.24 or 1.2e5");
  const std::string_view digits = rest.substr(0, length);
  rest.remove_prefix(length);
  if (rest.starts_with(',')) refuse("has a comma; write a decimal point");
  int power = 0;
  if (rest.starts_with("*10^")) {  // as a report prints it
    const std::string_view exponent = rest.substr(4);
    const auto [end, fault] =
        std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (fault != std::errc() || std::abs(power) > 1000) refuse("needs a whole number after 10^");
    rest.remove_prefix(4 + static_cast<std::size_t>(end - exponent.data()));
  }
  rest = trimmed(rest);
  if (!parse_number(digits)) refuse("has a number that is too large or too small");
  if (rest.empty() && unit != "1")
    refuse(fmt::format("has no unit; it must be convertible to {}", unit));
  const Unit given = rest.empty() ? Unit{} : UnitParser(field, text, rest).parse();
  if (!same_dimension(given, parse_unit(unit)))
    refuse(fmt::format("is not convertible to {}", unit));
  const std::optional<double> number =
      parse_number(shifted_text(digits, power + given.power_of_ten.value_or(0)));
  if (!number) refuse(power + *given.power_of_ten > 0 ? "is too large" : "is too small");
  const double value = given.power_of_ten ? *number : *number * given.factor;
  if (!std::isfinite(value)) refuse("is too large");
  return value;
}

namespace {

/// A number in plain digits, or with an exponent if it is far from 1.
/// @param text  a number in the form that number_length accepts, such as "0.0102e3"
std::string plain_digits(std::string_view text) {
  const std::size_t e = std::min(text.find('e'), text.size());
  int exponent = 0;
  if (e < text.size()) std::from_chars(text.data() + e + 1, text.data() + text.size(), exponent);
  std::string digits(text.substr(0, e));
  const bool negative = digits.starts_with('-');
  if (negative) digits.erase(0, 1);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  int before = static_cast<int>(point) + exponent;  // digits before the point
  if (point < digits.size()) digits.erase(point, 1);
  const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  digits.erase(0, zeros);
  before -= static_cast<int>(zeros);
  std::string plain;
  if (before > 16 || before < -3)
    plain = fmt::format("{}{}{}e{:+03}", digits[0], digits.size() > 1 ? "." : "", digits.substr(1),
                        before - 1);
  else if (before <= 0)
    plain = "0." + std::string(static_cast<std::size_t>(-before), '0') + digits;
  else if (digits.size() <= static_cast<std::size_t>(before))
    plain = digits + std::string(static_cast<std::size_t>(before) - digits.size(), '0');
  else
    plain = digits.insert(static_cast<std::size_t>(before), 1, '.');
  return negative ? '-' + plain : plain;
}

}  // namespace

std::string number_in(double value, const Unit& unit) {
  std::string si = fmt::format("{}", value);
  if (value == 0.0 || !std::isfinite(value)) return si;
  if (unit.power_of_ten) {
    const std::string exact = shifted_text(si, -*unit.power_of_ten);
    const std::optional<double> number = parse_number(exact);
    std::string text = number ? fmt::format("{}", *number) : std::string();
    const bool reads_back = number && parse_number(shifted_text(text, *unit.power_of_ten)) == value;
    return reads_back ? text : plain_digits(exact);
  }
  const double number = value / unit.factor;
  for (int digits = 1; digits <= 17; ++digits) {
    const double rounded = *parse_number(fmt::format("{:.{}g}", number, digits));
    if (rounded * unit.factor == value) return fmt::format("{}", rounded);
  }
  return fmt::format("{}", number);  // no number in this unit is the value: the nearest
}

std::string quantity_text(double value, std::string_view unit) {
  return unit == "1" ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

}  // namespace strainwave

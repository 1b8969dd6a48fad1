// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/asked_units.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

const AskedUnits kNone;
thread_local const AskedUnits* innermost = &kNone;

/// @throws InputError  if the text is not a unit
Unit unit_of(std::string_view text) {
  try {
    return parse_unit(text);
  } catch (const InputError& error) {
    throw InputError("units", std::string_view(error.what()).substr(error.field().size() + 2));
  }
}

/// The unit that a text of a result names; absent if the text names no unit.
std::optional<Unit> unit_if_any(std::string_view text) {
  try {
    return parse_unit(text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

AskedUnits::AskedUnits(std::string_view text) {
  if (text == "si") {
    si_ = true;
    return;
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view one = text.substr(begin, end - begin);
    begin = end + 1;
    const Unit unit = unit_of(one);
    if (same_dimension(unit, Unit{}))
      throw InputError(
          "units",
          fmt::format("{} is a unit of pure numbers, which the answer never converts; leave it out",
                      shown(one)));
    for (const Asked& other : asked_)
      if (same_dimension(unit, other.unit))
        throw InputError("units",
                         fmt::format("{} and {} have the same dimension; choose one of them",
                                     other.text, shown(one)));
    asked_.push_back({.name = {}, .text = std::string(one), .unit = unit});
  }
}

void AskedUnits::ask_for(std::string_view name, std::string_view unit) {
  asked_.insert(asked_.begin(),
                {.name = std::string(name), .text = std::string(unit), .unit = unit_of(unit)});
}

std::optional<DisplayUnit> AskedUnits::of(std::string_view name, std::string_view unit) const {
  if (empty() || unit.empty()) return std::nullopt;
  const std::optional<Unit> from = unit_if_any(unit);
  if (!from) return std::nullopt;
  std::optional<DisplayUnit> found;
  for (const Asked& asked : asked_) {
    if (!same_dimension(asked.unit, *from)) continue;
    *asked.used = true;
    if (!found && (asked.name.empty() || asked.name == name))
      found = DisplayUnit{asked.text, asked.unit.factor / from->factor};
  }
  return !found && si_ ? DisplayUnit{unit, 1.0} : found;
}

std::vector<std::string> AskedUnits::unused() const {
  std::vector<std::string> texts;
  for (const Asked& asked : asked_)
    if (asked.name.empty() && !*asked.used) texts.push_back(asked.text);
  return texts;
}

std::string number_in(double value, std::string_view from, std::string_view to) {
  const Unit source = parse_unit(from);
  return number_in(source.factor == 1.0 ? value : value * source.factor, parse_unit(to));
}

AskedUnitsScope::AskedUnitsScope(const AskedUnits& units) : before_(innermost) {
  innermost = &units;
}

AskedUnitsScope::~AskedUnitsScope() { innermost = before_; }

const AskedUnits& asked_units() { return *innermost; }

bool within_asked_units() { return innermost != &kNone; }

}  // namespace strainwave

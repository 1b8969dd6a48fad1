// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/quantity_text.hpp"

/// @file
/// The units that a reader asked for.  Computations and results are in SI; texts and documents are
/// written within an `AskedUnitsScope`, which `display_unit` and the writers of documents consult.

namespace strainwave {

/// A unit for people.
struct DisplayUnit {
  std::string_view text;  ///< unit in the form that `parse_unit` reads
  double in_si = 1.0;     ///< divide a value in SI by it
};

/// Units that a reader asked for: some for all values of their dimension, some for one name.
class AskedUnits {
 public:
  AskedUnits() = default;
  /// @param text  units separated by commas, such as "mm,N*m/rad"; "si" for SI throughout
  /// @throws InputError  a unit is not known, is of a pure number, or two have one dimension
  explicit AskedUnits(std::string_view text);

  /// Asks for a unit of one output or field.
  /// @throws InputError  the unit is not known
  void ask_for(std::string_view name, std::string_view unit);
  /// The unit that the caller asked for an output or a field of this name and unit; absent if the
  /// choice is free.
  /// The text lives as long as this.
  /// @param name  of the output or field; units asked for without a name count for any name
  /// @param unit  unit of the values, such as "m"; text that is not a unit has no other unit
  [[nodiscard]] std::optional<DisplayUnit> of(std::string_view name, std::string_view unit) const;

  /// Whether no unit was asked for, and SI throughout was not asked for either.
  [[nodiscard]] bool empty() const { return asked_.empty() && !si_; }
  /// The units, given without the name of an output, that no written value has.  A unit counts as
  /// used if `of` of this object or of a copy of it met the dimension of the unit.
  [[nodiscard]] std::vector<std::string> unused() const;

 private:
  struct Asked {
    std::string name;  ///< empty: any of this dimension
    std::string text;
    Unit unit;
    /// Whether `of` met this dimension.  All copies share this flag, and any thread may set it.
    std::shared_ptr<std::atomic<bool>> used = std::make_shared<std::atomic<bool>>(false);
  };
  std::vector<Asked> asked_;
  bool si_ = false;
};

/// Converts the number of a value from one unit to another, with the shortest digits that read back
/// exactly.
/// @param value  number in the unit `from`
/// @param from, to units in the form that `parse_unit` reads; both of the same dimension
[[nodiscard]] std::string number_in(double value, std::string_view from, std::string_view to);

/// While it lives, texts that this thread writes have the units asked for.
class AskedUnitsScope {
 public:
  /// @param units  outlive the scope
  explicit AskedUnitsScope(const AskedUnits& units);
  ~AskedUnitsScope();
  AskedUnitsScope(const AskedUnitsScope&) = delete;
  AskedUnitsScope& operator=(const AskedUnitsScope&) = delete;
  AskedUnitsScope(AskedUnitsScope&&) = delete;
  AskedUnitsScope& operator=(AskedUnitsScope&&) = delete;

 private:
  const AskedUnits* before_;
};

/// The units asked for in the innermost scope; none outside of all.
[[nodiscard]] const AskedUnits& asked_units();
/// Whether a scope is active, that is, whether the reader of this thread's output typed units.  A
/// caller from code has SI.
[[nodiscard]] bool within_asked_units();

}  // namespace strainwave

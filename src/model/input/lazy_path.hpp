// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// The path of a field in a rule between fields.  It links to the path above it, which must outlive
/// it, so that a rule that holds costs next to nothing; a study checks a million drives.
class LazyPath {
 public:
  /// A path of one step, such as "flexspline", or of several: "drive.wave_number".
  explicit LazyPath(std::string_view name) : name_(name) {}

  /// The path of a field of the table at this path, or of an element of the list at this path.
  /// @{
  [[nodiscard]] LazyPath operator/(std::string_view name) const& { return {this, name, kNone}; }
  [[nodiscard]] LazyPath operator[](std::size_t index) const& { return {this, {}, index}; }
  /// @}
  /// The same of a path that is about to end, to which no path can link.
  /// @{
  [[nodiscard]] FieldPath operator/(std::string_view name) const&& { return path() / name; }
  [[nodiscard]] FieldPath operator[](std::size_t index) const&& { return path()[index]; }
  /// @}

  /// The path with all of its steps.
  [[nodiscard]] FieldPath path() const {
    if (above_ == nullptr) return FieldPath(std::string(name_));
    return index_ == kNone ? above_->path() / name_ : above_->path()[index_];
  }
  /// As FieldPath::text.
  [[nodiscard]] std::string text() const { return path().text(); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  LazyPath(const LazyPath* above, std::string_view name, std::size_t index)
      : above_(above), name_(name), index_(index) {}

  const LazyPath* above_ = nullptr;
  std::string_view name_;
  std::size_t index_ = kNone;  ///< kNone: the last step goes to a name
};

/// As `require` of a FieldPath.
/// @{
inline void require(bool ok, const LazyPath& field, double value, std::string_view unit,
                    std::string_view rule) {
  if (!ok) throw InputError(field.text(), value, unit, rule);
}
template <std::invocable Rule>
void require(bool ok, const LazyPath& field, double value, std::string_view unit,
             const Rule& rule) {
  if (!ok) throw InputError(field.text(), value, unit, rule());
}
/// @}

/// As `material_of` with a FieldPath.
const Material& material_of(const GearSet& gear, std::string_view name, const LazyPath& field);

}  // namespace strainwave

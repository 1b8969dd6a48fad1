// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"

/// @file
/// Every struct of the input, of a result and of the options of a command describes its fields
/// once, by a static member `describe`.  Visitors of that description are the file reader, the
/// schemas, the template of `strainwave new`, the field reference in the docs, the range checks,
/// the field paths of `sweep` and `solve`, the command line and every document of a result.  They
/// therefore always agree.

namespace strainwave {

/// The allowed values of a number.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();  ///< in the unit of the number
  bool lower_open = true;  ///< whether `lower` itself is not allowed
  double upper = std::numeric_limits<double>::infinity();  ///< in the unit of the number
  bool upper_open = true;  ///< whether `upper` itself is not allowed

  /// Always false for NaN and infinities.
  [[nodiscard]] constexpr bool contains(double x) const {
    return (lower_open ? x > lower : x >= lower) && (upper_open ? x < upper : x <= upper);
  }
};

inline constexpr Range kFinite{};                ///< any finite number
inline constexpr Range kPositive{.lower = 0.0};  ///< any finite number above zero
/// Zero and any finite number above it.
inline constexpr Range kNonNegative{.lower = 0.0, .lower_open = false};

/// The rule of a range in words: "> 0", "> -1 and < 0.5", "<= 1.5708 rad".
[[nodiscard]] std::string rule_text(const Range& range, std::string_view unit = "1");

/// The form in which the template of `strainwave new` shows a field.
enum class InTemplate {
  yes,        ///< shown as an active line
  commented,  ///< shown as a comment that the user can activate
};

/// Whether every value of a struct has the field.
enum class Presence {
  always,    ///< every value has the field
  sometimes  ///< a value may lack the field
};

/// Marks a number whose unit is given by the field `unit` of the same struct.
inline constexpr std::string_view kUnitBeside = "*";

/// Description of one field of an input, of a result or of the options of a command.
struct Field {
  std::string_view name;  ///< key in the file
  std::string_view unit;  ///< SI unit of a number, "1" if pure; empty for text, flags, tables and
                          ///< whole numbers
  std::string_view doc;   ///< meaning and symbol, one line
  Range range = kFinite;  ///< allowed values of a number
  std::string_view example = {};   ///< right-hand side in the template, TOML
  std::string_view fallback = {};  ///< TOML value used if the field is left out; empty: the field
                                   ///< is required, or optional without a fallback (std::optional)
  InTemplate in_template = InTemplate::yes;  ///< form in the template of `strainwave new`
  /// For a result: evidence that only complete documents show; it is not an output of a table.
  bool detail = false;
  /// For a field of a result: a table of many drives shows this field.  A result with such a field
  /// can be a row of this table.
  bool headline = false;
  /// For an option: the command line recognises it by its place and not by `--name`.
  bool positional = false;
  /// For an option: the kind of thing that its text names, such as "field path" or "material";
  /// empty if there is nothing to list.  "attachment": a file whose text the command reads.
  /// "history": a file that the command reads piece by piece.
  std::string_view names = {};
  /// For a number of the input: its usual range; kFinite means the usual range of its unit.
  Range usual = kFinite;
  /// For a text of the input: whether the text is a number with its unit.  A number without a unit
  /// may then be bare.
  bool number_text = false;
  /// For a required field of the input: the names of other fields of the table, each of which makes
  /// this field optional if given; an empty name is none.
  std::array<std::string_view, 2> unless = {};
};

/// The usual range of a number: `usual` of its field, or else the usual range of its unit; kFinite
/// if every value is usual.  A value outside this range, or its unit, is probably a mistake.
[[nodiscard]] Range usual_range(const Field& field);

/// A struct that describes itself.
template <class T>
concept Described = requires {
  T::describe([](const Field&, auto) {});
};

/// Names of the values of an enumeration in files, in order; specialise `names` for each
/// enumeration.
template <class E>
struct EnumNames;

/// The name of a value of an enumeration in files: its entry in EnumNames.
template <class E>
[[nodiscard]] std::string_view enum_name(E value) {
  return EnumNames<E>::names[static_cast<std::size_t>(value)];
}

/// The value of an enumeration by its name in files; absent if no value has the name.
template <class E>
[[nodiscard]] std::optional<E> enum_value(std::string_view name) {
  for (std::size_t i = 0; i < EnumNames<E>::names.size(); ++i)
    if (EnumNames<E>::names[i] == name) return static_cast<E>(i);
  return std::nullopt;
}

/// Whether a type is a std::optional.
/// @{
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
/// @}

/// Whether a type is a std::vector.
/// @{
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
/// @}

/// Whether a type is a std::variant.
/// @{
template <class T>
inline constexpr bool is_variant = false;
template <class... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;
/// @}

/// Whether a type is a std::map whose keys are std::string.
/// @{
template <class T>
inline constexpr bool is_string_map = false;
template <class T>
inline constexpr bool is_string_map<std::map<std::string, T>> = true;
/// @}

/// Whether a type is std::array<double, 2>, which files give as a list of two.
template <class T>
inline constexpr bool is_pair_of_numbers = std::is_same_v<T, std::array<double, 2>>;

/// Calls `f.template operator()<Alternative>()` for each alternative of a variant type.
template <class Variant, class F>
void for_each_alternative(F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (f.template operator()<std::variant_alternative_t<I, Variant>>(), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

/// Path of a field inside its file, such as `output_shaft.crack[0].depth`; walks extend it on their
/// way down.
///
/// The text is built only where it is needed, because a drive without faults is checked a million
/// times in a study.  A name that extends a path must outlive the path.
class FieldPath {
 public:
  FieldPath() = default;  ///< the whole file
  /// A path from its text.
  explicit FieldPath(std::string text) : base_(std::move(text)) {}
  /// Copy a path.  Only the steps in use are copied.
  /// @{
  FieldPath(const FieldPath& other) : base_(other.base_), steps_(other.steps_) {
    std::copy_n(other.step_.begin(), steps_, step_.begin());
  }
  FieldPath& operator=(const FieldPath& other) {
    base_ = other.base_;
    steps_ = other.steps_;
    std::copy_n(other.step_.begin(), steps_, step_.begin());
    return *this;
  }
  /// @}
  ~FieldPath() = default;

  /// The path of a field of the table at this path.
  [[nodiscard]] FieldPath operator/(std::string_view name) const {
    return extended({.name = name.data(), .size = name.size(), .index = kNone});
  }
  /// The path of an element of the list at this path.
  /// @param index  from 0
  [[nodiscard]] FieldPath operator[](std::size_t index) const {
    return extended({.name = nullptr, .size = 0, .index = index});
  }
  /// The path as text: `output_shaft.crack[0].depth`.
  [[nodiscard]] std::string text() const;
  /// Whether `text()` is this text.
  [[nodiscard]] bool is(std::string_view text) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t kMaxSteps = 8;
  struct Step {
    const char* name;
    std::size_t size;   ///< of the name
    std::size_t index;  ///< kNone: the step goes to a name
  };

  [[nodiscard]] FieldPath extended(const Step& step) const {
    FieldPath path = steps_ == kMaxSteps ? FieldPath(text()) : *this;
    path.step_[path.steps_++] = step;
    return path;
  }

  std::string base_;
  std::array<Step, kMaxSteps>
      step_;  // NOLINT(cppcoreguidelines-pro-type-member-init): first steps_
  std::size_t steps_ = 0;
};

/// As `require` of a text, for a path whose text is built only after a fault.
inline void require(bool ok, const FieldPath& field, double value, std::string_view unit,
                    std::string_view rule) {
  if (!ok) throw InputError(field.text(), value, unit, rule);
}
/// The same for a rule whose text is built only after a fault.
template <std::invocable Rule>
void require(bool ok, const FieldPath& field, double value, std::string_view unit,
             const Rule& rule) {
  if (!ok) throw InputError(field.text(), value, unit, rule());
}

}  // namespace strainwave

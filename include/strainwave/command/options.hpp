// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/described.hpp"
#include "strainwave/core/error.hpp"

/// @file
/// The options of a command are a described struct.  The command line, JSON and the C interface set
/// options by name and text.  This header makes any such struct settable without knowledge of its
/// type.

namespace strainwave {

/// An option, or the text or file that the option names, cannot be understood.
class OptionError : public InputError {
 public:
  using InputError::InputError;
  /// Turns a fault of an input into the same fault of an option.
  explicit OptionError(const InputError& error) : InputError(error) {}
};

/// Runs `parse` and reports an InputError from it as an OptionError, because the fault is in an
/// option and not in the input file.
template <class Parse>
auto from_option(const Parse& parse) {
  try {
    return parse();
  } catch (const InputError& error) {
    throw OptionError(error);
  }
}

/// The quantity that the text of an option states, in SI units.
/// @param option  name of the option, for the message
/// @param text    number and unit, such as "30 N*m"
/// @param unit    SI unit of the dimension that the text must have
/// @throws OptionError  if the text states no such quantity
[[nodiscard]] double option_quantity(std::string_view option, std::string_view text,
                                     std::string_view unit);

/// What kind of text an option takes.
enum class OptionKind {
  flag,    ///< "true" or "false"
  whole,   ///< a whole number
  number,  ///< a number with its unit; a pure number has none
  text,    ///< any text
  choice   ///< one of the names in Option::choices
};

/// One option of a command.
struct Option {
  Field field;                                 ///< its name, unit, meaning, range and default value
  OptionKind kind = OptionKind::text;          ///< of each text that it takes
  bool repeatable = false;                     ///< whether it may be given several times
  bool required = false;                       ///< whether it must be given
  std::vector<std::string_view> choices = {};  ///< the names that a choice takes, else empty

  /// The name as spelled on a command line: "all-sets".
  [[nodiscard]] std::string spelled() const;
};

namespace detail {

/// @throws OptionError  if the text is not a number, or the number is outside the range
[[nodiscard]] double number_option(const Field& field, std::string_view text);
/// @param least, most  limits of the type that takes the number
[[nodiscard]] std::int64_t whole_option(const Field& field, std::string_view text,
                                        std::int64_t least, std::int64_t most);
[[nodiscard]] bool flag_option(const Field& field, std::string_view text);
[[noreturn]] void refuse_choice(const Field& field, std::string_view text,
                                std::span<const std::string_view> choices);
[[noreturn]] void refuse_unknown_option(std::string_view name, std::span<const Option> known);

template <class Value>
[[nodiscard]] Option option_of(const Field& field) {
  if constexpr (is_optional<Value>) {
    Option option = option_of<typename Value::value_type>(field);
    option.required = false;
    return option;
  } else if constexpr (is_vector<Value>) {
    Option option = option_of<typename Value::value_type>(field);
    option.required = false;
    option.repeatable = true;
    return option;
  } else {
    Option option{.field = field, .required = field.fallback.empty()};
    if constexpr (std::is_same_v<Value, bool>) {
      option.kind = OptionKind::flag;
      option.required = false;
    } else if constexpr (std::is_enum_v<Value>) {
      option.kind = OptionKind::choice;
      option.choices.assign(EnumNames<Value>::names.begin(), EnumNames<Value>::names.end());
    } else if constexpr (std::is_integral_v<Value>) {
      option.kind = OptionKind::whole;
    } else if constexpr (std::is_same_v<Value, double>) {
      option.kind = OptionKind::number;
    } else {
      static_assert(std::is_same_v<Value, std::string>);
    }
    return option;
  }
}

template <class Value>
void assign_option(Value& value, const Field& field, std::string_view text) {
  if constexpr (is_optional<Value>) {
    assign_option(value.emplace(), field, text);
  } else if constexpr (is_vector<Value>) {
    assign_option(value.emplace_back(), field, text);
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = flag_option(field, text);
  } else if constexpr (std::is_enum_v<Value>) {
    const auto named = enum_value<Value>(text);
    if (!named) refuse_choice(field, text, EnumNames<Value>::names);
    value = *named;
  } else if constexpr (std::is_integral_v<Value>) {
    using Limits = std::numeric_limits<Value>;
    constexpr auto kMost = static_cast<std::uint64_t>(Limits::max());
    constexpr auto kMostWhole = std::numeric_limits<std::int64_t>::max();
    value = static_cast<Value>(whole_option(
        field, text, std::is_signed_v<Value> ? static_cast<std::int64_t>(Limits::min()) : 0,
        kMost < static_cast<std::uint64_t>(kMostWhole) ? static_cast<std::int64_t>(kMost)
                                                       : kMostWhole));
  } else if constexpr (std::is_same_v<Value, double>) {
    value = number_option(field, text);
  } else {
    value = text;
  }
}

}  // namespace detail

/// The options of a command with their type erased.
struct OptionsType {
  std::vector<Option> options;                         ///< in the order of their description
  std::shared_ptr<void> (*make)();                     ///< makes options with their default values
  std::shared_ptr<void> (*copy)(const void* options);  ///< makes a copy of options
  /// Sets an option from text; does nothing if no option has this name.
  /// @throws OptionError  if the option does not take this text
  void (*set)(void* options, std::string_view name, std::string_view text);
  void (*visit)(const void* options, ValueVisitor& to);  ///< walks the values of options
  void (*walk)(const Field& field, TypeVisitor& to);     ///< walks the type of the options
};

/// The options that a struct describes, with their type erased.
template <Described Options>
[[nodiscard]] OptionsType options_type() {
  OptionsType type{
      .options = {},
      .make = []() -> std::shared_ptr<void> { return std::make_shared<Options>(); },
      .copy = [](const void* options) -> std::shared_ptr<void> {
        return std::make_shared<Options>(*static_cast<const Options*>(options));
      },
      .set =
          [](void* options, std::string_view name, std::string_view text) {
            Options::describe([&](const Field& field, auto member) {
              if (field.name == name)
                detail::assign_option(static_cast<Options*>(options)->*member, field, text);
            });
          },
      .visit = [](const void* options,
                  ValueVisitor& to) { visit_value(*static_cast<const Options*>(options), {}, to); },
      .walk = visit_type<Options>};
  Options::describe([&](const Field& field, auto member) {
    type.options.push_back(detail::option_of<MemberValue<Options, decltype(member)>>(field));
  });
  return type;
}

/// The options of a command while they are being set.  The type is copyable.
class OptionValues {
 public:
  /// Options with their default values.
  /// @param type  must outlive the options
  explicit OptionValues(const OptionsType& type) : type_(&type), values_(type.make()) {}
  /// Copy or move options with their texts.
  /// @{
  OptionValues(const OptionValues& other)
      : type_(other.type_), values_(type_->copy(other.get())), given_(other.given_) {}
  OptionValues(OptionValues&&) noexcept = default;
  OptionValues& operator=(OptionValues other) noexcept {
    std::swap(type_, other.type_);
    values_.swap(other.values_);
    given_.swap(other.given_);
    return *this;
  }
  /// @}
  ~OptionValues() = default;

  /// Sets an option from text, as written on the command line; "true" for a flag.  An option that
  /// may be repeated takes one text per call.
  /// @param name  as in the struct: "all_sets"
  /// @param text  a value of the kind of the option: "12 mm"; see OptionKind
  /// @throws OptionError  if the option does not exist, does not take this text, or is given again
  ///                      although it may not be repeated
  void set(std::string_view name, std::string_view text);
  /// Sets the options that a JSON object names; a list sets a repeatable option.
  /// @throws OptionError  if the text is not such an object, or for the reasons of `set`
  void set_from_json(std::string_view json);
  /// Checks that all required options are set.
  /// @throws OptionError  if a required option was not set
  void require_complete() const;

  /// Whether an option was set.
  /// @param name  as in the struct
  [[nodiscard]] bool given(std::string_view name) const;
  /// Names and texts as they were set, in their order.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& texts() const {
    return given_;
  }
  /// The struct of the options, of the type that the OptionsType was made for.
  [[nodiscard]] const void* get() const { return values_.get(); }

 private:
  const OptionsType* type_;
  std::shared_ptr<void> values_;
  std::vector<std::pair<std::string, std::string>> given_;
};

}  // namespace strainwave

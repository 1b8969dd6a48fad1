// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/quantity.hpp"

/// @file
/// Walks over described structs (core/fields.hpp).  JSON, CSV, tables, schemas and the names of
/// outputs are visitors of these walks, so a result states its fields once.

namespace strainwave {

/// A struct that is one row of a long table.  A list of such rows is walked by columns, so the unit
/// of a column is stated once.
template <class T>
concept TableRow = Described<T> && requires {
  requires T::kTableRow;
};

/// Reads a member of a described struct: a data member, or the result of a member function or
/// lambda that takes the struct.
///
/// Does what std::invoke does, without the functions that each of thousands of members would make.
template <class T, class Member>
[[gnu::always_inline]] inline decltype(auto) member_of(const T& value, const Member& member) {
  if constexpr (std::is_member_object_pointer_v<Member>)
    return (value.*member);
  else if constexpr (std::is_member_function_pointer_v<Member>)
    return (value.*member)();
  else
    return member(value);
}

/// Type of a member, as member_of reads it.
template <class T, class Member>
using MemberValue =
    std::decay_t<decltype(member_of(std::declval<const T&>(), std::declval<const Member&>()))>;

/// Whether a type is a list of numbers, which is walked as one column.
/// @{
template <class T>
inline constexpr bool is_array_of_numbers = false;
template <>
inline constexpr bool is_array_of_numbers<std::vector<double>> = true;
template <>
inline constexpr bool is_array_of_numbers<std::vector<std::optional<double>>> = true;
template <std::size_t N>
inline constexpr bool is_array_of_numbers<std::array<double, N>> = true;
/// @}

/// Whether a type is text: std::string, std::string_view, or anything that converts to the latter.
template <class T>
inline constexpr bool is_text = std::is_convertible_v<const T&, std::string_view>;

/// Receives a described value piece by piece.
///
/// Inside a column, every number, word and list is one element, and the unit of the column applies.
class ValueVisitor {
 public:
  virtual ~ValueVisitor() = default;

  /// Enclose a record.  Its fields come in between, each announced by `field`.
  /// @{
  virtual void begin_record() = 0;
  virtual void end_record() = 0;
  /// @}
  /// Announces that the value of this field of a record comes next.  Returning false skips the
  /// field.
  virtual bool field(const Field& field) = 0;
  /// Enclose a list.  Its elements come in between.
  /// @{
  virtual void begin_list() = 0;
  virtual void end_list() = 0;
  /// @}
  /// Begins a column: a list of numbers, or the values of one field over the rows of a table.
  /// @param field  describes each element
  virtual void begin_column(const Field& field) = 0;
  virtual void end_column() = 0;  ///< Ends the column that was begun last.
  /// Receives a number.
  /// @param value  in the unit of the field
  /// @param field  describes the number: its name, unit and meaning; in a column, the column's
  virtual void number(double value, const Field& field) = 0;
  /// Receives a number that has a unit and an accuracy of its own.
  virtual void quantity(const Quantity& value) = 0;
  virtual void whole(std::int64_t value) = 0;  ///< Receives a whole number.
  virtual void flag(bool value) = 0;           ///< Receives a truth value.
  /// Receives text, or the name of a value of an enumeration.
  virtual void text(std::string_view value) = 0;
  virtual void nothing() = 0;  ///< Receives an absent element of a column or a list.
};

template <class T>
void visit_value(const T& value, const Field& field, ValueVisitor& to);

namespace detail {

/// Walks elements of one type by columns; `walk(leaf)` calls `leaf` on each of them in order.
template <class T, class Walk>
void visit_columns(const Field& field, const Walk& walk, ValueVisitor& to) {
  if constexpr (Described<T>) {
    to.begin_record();
    T::describe([&](const Field& inner, auto member) {
      if (!to.field(inner)) return;
      visit_columns<MemberValue<T, decltype(member)>>(
          inner,
          [&](const auto& leaf) {
            walk([&](const T& element) { leaf(member_of(element, member)); });
          },
          to);
    });
    to.end_record();
  } else if constexpr (is_vector<T>) {
    visit_columns<typename T::value_type>(
        field,
        [&](const auto& leaf) {
          walk([&](const T& list) {
            to.begin_list();
            for (const auto& element : list) leaf(element);
            to.end_list();
          });
        },
        to);
  } else {
    to.begin_column(field);
    walk([&](const T& element) { visit_value(element, field, to); });
    to.end_column();
  }
}

template <class T>
void visit_fields(const T& value, ValueVisitor& to) {
  T::describe([&](const Field& inner, auto member) {
    const auto& part = member_of(value, member);
    if constexpr (is_optional<std::decay_t<decltype(part)>>) {
      if (part && to.field(inner)) visit_value(*part, inner, to);
    } else if (to.field(inner)) {
      visit_value(part, inner, to);
    }
  });
}

}  // namespace detail

/// Walks a value.  `field` describes the value itself.
///
/// An absent field of a record is left out; an absent element of a column is passed as `nothing`.
template <class T>
void visit_value(const T& value, const Field& field, ValueVisitor& to) {
  if constexpr (std::is_same_v<T, double>) {
    to.number(value, field);
  } else if constexpr (std::is_same_v<T, Quantity>) {
    to.quantity(value);
  } else if constexpr (std::is_same_v<T, bool>) {
    to.flag(value);
  } else if constexpr (std::is_integral_v<T>) {
    to.whole(static_cast<std::int64_t>(value));
  } else if constexpr (std::is_enum_v<T>) {
    to.text(enum_name(value));
  } else if constexpr (is_text<T>) {
    to.text(value);
  } else if constexpr (is_optional<T>) {
    if (value)
      visit_value(*value, field, to);
    else
      to.nothing();
  } else if constexpr (is_array_of_numbers<T>) {
    to.begin_column(field);
    for (const auto& element : value) visit_value(element, field, to);
    to.end_column();
  } else if constexpr (is_vector<T>) {
    using Element = typename T::value_type;
    if constexpr (TableRow<Element>) {
      detail::visit_columns<Element>(
          field,
          [&](const auto& leaf) {
            for (const Element& row : value) leaf(row);
          },
          to);
    } else {
      to.begin_list();
      for (const auto& element : value) visit_value(element, field, to);
      to.end_list();
    }
  } else if constexpr (is_string_map<T>) {
    to.begin_record();
    for (const auto& [name, element] : value)
      if (to.field({.name = name, .unit = field.unit, .doc = field.doc}))
        visit_value(element, field, to);
    to.end_record();
  } else if constexpr (is_variant<T>) {
    std::visit(
        [&](const auto& alternative) {
          to.begin_record();
          if (to.field({"kind", "", "name of the alternative"}))
            to.text(std::decay_t<decltype(alternative)>::kKind);
          detail::visit_fields(alternative, to);
          to.end_record();
        },
        value);
  } else {
    static_assert(Described<T>);
    to.begin_record();
    detail::visit_fields(value, to);
    to.end_record();
  }
}

/// Receives the description of a type piece by piece, as ValueVisitor receives a value.
class TypeVisitor {
 public:
  virtual ~TypeVisitor() = default;

  /// Enclose a record.  Its fields come in between, each announced by `field`.
  /// @{
  virtual void begin_record() = 0;
  virtual void end_record() = 0;
  /// @}
  /// Announces that the type of this field comes next.  `always`: every value has the field.
  virtual void field(const Field& field, Presence presence) = 0;
  /// Enclose a list.  The type of its elements comes in between.
  /// @{
  virtual void begin_list() = 0;
  virtual void end_list() = 0;
  /// @}
  /// Begins a map from names to the type that comes next.
  virtual void begin_map() = 0;
  virtual void end_map() = 0;  ///< Ends the map that was begun last.
  /// Begins a choice between the records that come next, each with its kind.
  virtual void begin_alternatives() = 0;
  virtual void end_alternatives() = 0;  ///< Ends the choice that was begun last.
  /// Receives the kind of the record that was begun last: the value of its field `kind`.
  virtual void kind(std::string_view kind) = 0;
  /// Receive a column, a number, a quantity or a whole number.
  /// @param field  gives its unit, its meaning and its allowed values
  /// @{
  virtual void column(const Field& field) = 0;
  virtual void number(const Field& field) = 0;
  virtual void quantity(const Field& field) = 0;
  virtual void whole(const Field& field) = 0;
  /// @}
  virtual void flag() = 0;  ///< Receives a truth value.
  virtual void text() = 0;  ///< Receives a text.
  /// Receives a text that is one of these names.
  virtual void choice(std::span<const std::string_view> names) = 0;
};

namespace detail {

template <class T>
void visit_column_types(const Field& field, TypeVisitor& to) {
  if constexpr (Described<T>) {
    to.begin_record();
    T::describe([&](const Field& inner, auto member) {
      to.field(inner, Presence::always);
      visit_column_types<MemberValue<T, decltype(member)>>(inner, to);
    });
    to.end_record();
  } else if constexpr (is_vector<T>) {
    visit_column_types<typename T::value_type>(field, to);
  } else {
    to.column(field);
  }
}

}  // namespace detail

/// Walks a type; `field` describes the value that has the type.
template <class T>
void visit_type(const Field& field, TypeVisitor& to) {
  const auto fields = [&to]<class U>(std::type_identity<U>) {
    U::describe([&](const Field& inner, auto member) {
      using Value = MemberValue<U, decltype(member)>;
      if constexpr (is_optional<Value>) {
        to.field(inner, Presence::sometimes);
        visit_type<typename Value::value_type>(inner, to);
      } else {
        to.field(inner, Presence::always);
        visit_type<Value>(inner, to);
      }
    });
  };
  if constexpr (std::is_same_v<T, double>) {
    to.number(field);
  } else if constexpr (std::is_same_v<T, Quantity>) {
    to.quantity(field);
  } else if constexpr (std::is_same_v<T, bool>) {
    to.flag();
  } else if constexpr (std::is_integral_v<T>) {
    to.whole(field);
  } else if constexpr (std::is_enum_v<T>) {
    to.choice(EnumNames<T>::names);
  } else if constexpr (is_text<T>) {
    to.text();
  } else if constexpr (is_optional<T>) {
    visit_type<typename T::value_type>(field, to);
  } else if constexpr (is_array_of_numbers<T>) {
    to.column(field);
  } else if constexpr (is_vector<T>) {
    using Element = typename T::value_type;
    if constexpr (TableRow<Element>) {
      detail::visit_column_types<Element>(field, to);
    } else {
      to.begin_list();
      visit_type<Element>(field, to);
      to.end_list();
    }
  } else if constexpr (is_string_map<T>) {
    to.begin_map();
    visit_type<typename T::mapped_type>(field, to);
    to.end_map();
  } else if constexpr (is_variant<T>) {
    to.begin_alternatives();
    for_each_alternative<T>([&]<class Alternative>() {
      to.begin_record();
      to.kind(Alternative::kKind);
      fields(std::type_identity<Alternative>{});
      to.end_record();
    });
    to.end_alternatives();
  } else {
    static_assert(Described<T>);
    to.begin_record();
    fields(std::type_identity<T>{});
    to.end_record();
  }
}

}  // namespace strainwave

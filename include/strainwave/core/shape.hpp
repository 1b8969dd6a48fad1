// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// The shape of a described input struct (core/fields.hpp) at run time.  The reader of files, the
/// writer, the schema, the reference and the walk over all numbers are ordinary functions of a
/// shape, so the compiler reads the description of a struct once and not for each of them
/// (docs/adr/0027).

namespace strainwave {

struct Shape;

/// Name of the alternatives of a variant in messages; specialise it if they are no cracks.
template <class Variant>
inline constexpr std::string_view kKindsOf = "crack that this member can have";

/// One field of a record.
struct ShapeField {
  Field field;                   ///< its description
  const Shape* shape = nullptr;  ///< of its value; never null
  std::size_t offset = 0;        ///< of its value in the record, in bytes
};

/// What a value consists of, and how to reach its parts.
///
/// A pointer that a function here takes leads to a value with this shape, and the pointer that it
/// returns leads to a part of this value.  The functions that a kind of value does not name are
/// null.
struct Shape {
  /// The kind of a value.
  enum class Kind {
    number,        ///< double
    whole,         ///< int
    flag,          ///< bool
    text,          ///< std::string
    choice,        ///< an enumeration; `names`, `index`, `take`
    optional,      ///< std::optional; `element`, `size` (0 or 1), `at`, `add`
    pair,          ///< two numbers; `element`, `size`, `at`
    list,          ///< std::vector; `element`, `size`, `at`, `add`
    map,           ///< from names; `element`, `entry`, `each`
    alternatives,  ///< std::variant of records; `alternatives`, `kinds`, `index`, `at`, `take`
    record         ///< a described struct; `fields`, `kind_name`, `meaning`, `unset`
  };
  Kind kind = Kind::record;        ///< what the value is
  const Shape* element = nullptr;  ///< of the elements, or of the value of an optional
  std::span<const std::string_view> names = {};  ///< of a choice, in their order
  std::vector<ShapeField> fields = {};           ///< of a record, in the order of its description
  std::string_view kind_name = {};               ///< kKind of a record that is an alternative
  std::string_view meaning = {};                 ///< kMeaning of a record that is an alternative
  const void* unset = nullptr;                   ///< a record whose fields nobody has set
  std::vector<const Shape*> alternatives = {};   ///< records, in their order
  std::string_view kinds = {};                   ///< what the alternatives are, in messages
  std::size_t (*size)(const void*) = nullptr;    ///< number of elements
  void* (*at)(void*, std::size_t) = nullptr;     ///< an element; the record that a variant holds
  void* (*add)(void*) = nullptr;                 ///< a new element behind the others
  /// the element with this name, made if there is none
  void* (*entry)(void*, const std::string&) = nullptr;
  /// calls the function for each element of a map, in the order of the names
  void (*each)(void*, const std::function<void(const std::string&, void*)>&) = nullptr;
  std::size_t (*index)(const void*) = nullptr;  ///< of the name, or of the alternative, that it has
  /// sets the name or the alternative with this index, and returns the new record of a variant
  void* (*take)(void*, std::size_t) = nullptr;

  /// The field of a record with this name; null if there is none.
  [[nodiscard]] const ShapeField* find(std::string_view name) const;
  /// Whether it is a record, or alternatives.
  [[nodiscard]] bool is_table() const { return kind == Kind::record || kind == Kind::alternatives; }
};

/// Whether a file must give a field; one of the fields `unless` may take its place.
[[nodiscard]] bool is_required(const ShapeField& field);
/// Whether a file must give a field, whatever other fields it gives.
[[nodiscard]] bool is_always_required(const ShapeField& field);

/// The shape of the elements of a list or map, or of the value of an optional; else the same shape.
[[nodiscard]] inline const Shape& unwrapped(const Shape& shape) {
  return shape.element != nullptr && shape.kind != Shape::Kind::pair ? *shape.element : shape;
}

/// Whether a value has headings of its own in a file: a table, an array of tables or a table of
/// tables.
[[nodiscard]] inline bool is_section(const Shape& shape) { return unwrapped(shape).is_table(); }

/// The value of a field of a record.
/// @{
[[nodiscard]] inline void* value_in(void* record, const ShapeField& field) {
  return static_cast<char*>(record) + field.offset;
}
[[nodiscard]] inline const void* value_in(const void* record, const ShapeField& field) {
  return static_cast<const char*>(record) + field.offset;
}
/// @}

/// An element of a list, a pair or an optional, or the record that a variant holds, to read.
[[nodiscard]] const void* element_of(const Shape& shape, const void* value, std::size_t index);
/// Calls `f` for each element of a map, to read, in the order of the names.
void each_element(const Shape& map, const void* value,
                  const std::function<void(const std::string&, const void*)>& f);

/// The shape of a type, made once.
template <class T>
const Shape& shape_of();

namespace detail {

template <class T>
T& as(void* value) {
  return *static_cast<T*>(value);
}
template <class T>
const T& as(const void* value) {
  return *static_cast<const T*>(value);
}

template <class T>
Shape record_shape() {
  static const T unset{};
  Shape shape{.kind = Shape::Kind::record, .unset = &unset};
  if constexpr (requires { T::kKind; }) shape.kind_name = T::kKind;
  if constexpr (requires { T::kMeaning; }) shape.meaning = T::kMeaning;
  T::describe([&](const Field& field, auto member) {
    const auto& part = unset.*member;
    shape.fields.push_back(
        {.field = field,
         .shape = &shape_of<std::decay_t<decltype(part)>>(),
         .offset = static_cast<std::size_t>(reinterpret_cast<const char*>(std::addressof(part)) -
                                            reinterpret_cast<const char*>(&unset))});
  });
  return shape;
}

template <class T>
Shape alternatives_shape() {
  Shape shape{.kind = Shape::Kind::alternatives, .kinds = kKindsOf<T>};
  for_each_alternative<T>(
      [&]<class Alternative>() { shape.alternatives.push_back(&shape_of<Alternative>()); });
  shape.index = [](const void* value) { return as<T>(value).index(); };
  shape.at = [](void* value, std::size_t) {
    return std::visit([](auto& held) -> void* { return &held; }, as<T>(value));
  };
  shape.take = [](void* value, std::size_t wanted) {
    void* taken = nullptr;
    std::size_t i = 0;
    for_each_alternative<T>([&]<class Alternative>() {
      if (i++ == wanted) taken = &as<T>(value).template emplace<Alternative>();
    });
    return taken;
  };
  return shape;
}

template <class T>
Shape element_shape(Shape::Kind kind) {
  Shape shape{.kind = kind, .element = &shape_of<typename T::value_type>()};
  if constexpr (is_optional<T>) {
    shape.size = [](const void* value) -> std::size_t { return as<T>(value) ? 1 : 0; };
    shape.at = [](void* value, std::size_t) -> void* { return &*as<T>(value); };
    shape.add = [](void* value) -> void* { return &as<T>(value).emplace(); };
  } else {
    shape.size = [](const void* value) { return as<T>(value).size(); };
    shape.at = [](void* value, std::size_t i) -> void* { return &as<T>(value)[i]; };
    if constexpr (is_vector<T>)
      shape.add = [](void* value) -> void* { return &as<T>(value).emplace_back(); };
  }
  return shape;
}

template <class T>
Shape map_shape() {
  Shape shape{.kind = Shape::Kind::map, .element = &shape_of<typename T::mapped_type>()};
  shape.entry = [](void* value, const std::string& name) -> void* { return &as<T>(value)[name]; };
  shape.each = [](void* value, const std::function<void(const std::string&, void*)>& f) {
    for (auto& [name, element] : as<T>(value)) f(name, &element);
  };
  return shape;
}

template <class T>
Shape choice_shape() {
  Shape shape{.kind = Shape::Kind::choice, .names = EnumNames<T>::names};
  shape.index = [](const void* value) { return static_cast<std::size_t>(as<T>(value)); };
  shape.take = [](void* value, std::size_t wanted) -> void* {
    as<T>(value) = static_cast<T>(wanted);
    return value;
  };
  return shape;
}

template <class T>
Shape make_shape() {
  if constexpr (std::is_same_v<T, double>) {
    return {.kind = Shape::Kind::number};
  } else if constexpr (std::is_same_v<T, int>) {
    return {.kind = Shape::Kind::whole};
  } else if constexpr (std::is_same_v<T, bool>) {
    return {.kind = Shape::Kind::flag};
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {.kind = Shape::Kind::text};
  } else if constexpr (std::is_enum_v<T>) {
    return choice_shape<T>();
  } else if constexpr (is_optional<T>) {
    return element_shape<T>(Shape::Kind::optional);
  } else if constexpr (is_pair_of_numbers<T>) {
    return element_shape<T>(Shape::Kind::pair);
  } else if constexpr (is_vector<T>) {
    return element_shape<T>(Shape::Kind::list);
  } else if constexpr (is_string_map<T>) {
    return map_shape<T>();
  } else if constexpr (is_variant<T>) {
    return alternatives_shape<T>();
  } else {
    static_assert(Described<T>);
    return record_shape<T>();
  }
}

}  // namespace detail

template <class T>
const Shape& shape_of() {
  static const Shape shape = detail::make_shape<T>();
  return shape;
}

/// Calls `f` for all numbers that a value of this shape holds now.  `f` may change the numbers; it
/// gets the path of each number, which begins with `path`, and the description of its field.  A
/// number that is no field of a record has no description, and is left out.
void walk_numbers(const Shape& shape, void* value, const FieldPath& path,
                  const std::function<void(const FieldPath&, const Field&, double&)>& f);
/// The same without paths, which cost more than the walk.
void walk_numbers(const Shape& shape, void* value,
                  const std::function<void(const Field&, double&)>& f);

/// Walks all numbers that a described value holds now by calling `f(const FieldPath&, const Field&,
/// double&)` (const double& for a const value).
template <class T, class F>
void for_each_number(T& value, const F& f, const FieldPath& path = {}) {
  using Value = std::remove_const_t<T>;
  using Number = std::conditional_t<std::is_const_v<T>, const double, double>;
  const auto call = [&f](const FieldPath& at, const Field& field, double& number) {
    f(at, field, static_cast<Number&>(number));
  };
  walk_numbers(shape_of<Value>(), const_cast<Value*>(&value), path, std::cref(call));
}

/// The same without paths: `f(const Field&, double&)`.
template <class T, class F>
void for_each_plain_number(T& value, const F& f) {
  using Value = std::remove_const_t<T>;
  using Number = std::conditional_t<std::is_const_v<T>, const double, double>;
  const auto call = [&f](const Field& field, double& number) {
    f(field, static_cast<Number&>(number));
  };
  walk_numbers(shape_of<Value>(), const_cast<Value*>(&value), std::cref(call));
}

}  // namespace strainwave

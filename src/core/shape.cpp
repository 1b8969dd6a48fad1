// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shape.hpp"

#include <algorithm>

namespace strainwave {
namespace {

/// Replaces a FieldPath at no cost where its text is not needed.
struct NoPath {
  NoPath operator/(std::string_view) const { return {}; }
  NoPath operator[](std::size_t) const { return {}; }
};

template <class Path, class F>
void walk(const Shape& shape, void* value, const Path& path, const Field* field, const F& f) {
  switch (shape.kind) {
    case Shape::Kind::number:
      if (field != nullptr) f(path, *field, *static_cast<double*>(value));
      return;
    case Shape::Kind::optional:
      if (shape.size(value) == 1) walk(*shape.element, shape.at(value, 0), path, field, f);
      return;
    case Shape::Kind::pair:
    case Shape::Kind::list:
      for (std::size_t i = 0; i < shape.size(value); ++i)
        walk(*shape.element, shape.at(value, i), path[i], field, f);
      return;
    case Shape::Kind::map:
      shape.each(value, [&](const std::string& name, void* element) {
        walk(*shape.element, element, path / name, field, f);
      });
      return;
    case Shape::Kind::alternatives:
      walk(*shape.alternatives[shape.index(value)], shape.at(value, 0), path, nullptr, f);
      return;
    case Shape::Kind::record:
      for (const ShapeField& part : shape.fields) {
        void* const at = value_in(value, part);
        if (part.shape->kind == Shape::Kind::number)  // most fields
          f(path / part.field.name, part.field, *static_cast<double*>(at));
        else
          walk(*part.shape, at, path / part.field.name, &part.field, f);
      }
      return;
    case Shape::Kind::whole:
    case Shape::Kind::flag:
    case Shape::Kind::text:
    case Shape::Kind::choice:
      return;
  }
}

}  // namespace

const ShapeField* Shape::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(fields, [&](const ShapeField& one) { return one.field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

bool is_required(const ShapeField& field) {
  const bool conditional = !field.field.unless.front().empty();
  switch (field.shape->kind) {
    case Shape::Kind::optional:
      return conditional && field.field.fallback.empty();
    case Shape::Kind::list:
    case Shape::Kind::map:
      return false;
    case Shape::Kind::number:
    case Shape::Kind::whole:
    case Shape::Kind::flag:
    case Shape::Kind::text:
    case Shape::Kind::choice:
    case Shape::Kind::pair:
    case Shape::Kind::alternatives:
    case Shape::Kind::record:
      break;
  }
  return field.field.fallback.empty();
}

bool is_always_required(const ShapeField& field) {
  return is_required(field) && field.field.unless.front().empty();
}

const void* element_of(const Shape& shape, const void* value, std::size_t index) {
  return shape.at(const_cast<void*>(value), index);
}

void each_element(const Shape& map, const void* value,
                  const std::function<void(const std::string&, const void*)>& f) {
  map.each(const_cast<void*>(value), f);
}

void walk_numbers(const Shape& shape, void* value, const FieldPath& path,
                  const std::function<void(const FieldPath&, const Field&, double&)>& f) {
  walk(shape, value, path, nullptr, f);
}

void walk_numbers(const Shape& shape, void* value,
                  const std::function<void(const Field&, double&)>& f) {
  walk(shape, value, NoPath(), nullptr,
       [&](NoPath, const Field& field, double& number) { f(field, number); });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shape.hpp"

#include <algorithm>
#include <string>

#include "strainwave/core/sought_number.hpp"

namespace strainwave {
namespace {

/// Replaces a FieldPath at no cost where its text is not needed.
struct NoPath {
  NoPath operator/(std::string_view) const { return {}; }
  NoPath operator[](std::size_t) const { return {}; }
};

/// What is left of a path that is sought; a walk leaves out what does not lead there.
class SoughtPath {
 public:
  explicit SoughtPath(std::string_view path) : rest_(path), whole_(true), leads_there_(true) {}

  SoughtPath operator/(std::string_view name) const {
    std::string_view rest = rest_;
    if (!whole_ && !take(rest, ".")) return {};
    return take(rest, name) ? SoughtPath(rest, true) : SoughtPath();
  }
  SoughtPath operator[](std::size_t index) const {
    std::string_view rest = rest_;
    const bool is = take(rest, "[") && take(rest, std::to_string(index)) && take(rest, "]");
    return is ? SoughtPath(rest, true) : SoughtPath();
  }
  [[nodiscard]] bool leads_there() const { return leads_there_; }
  [[nodiscard]] bool is_there() const { return rest_.empty(); }

 private:
  SoughtPath() = default;
  SoughtPath(std::string_view rest, bool leads_there) : rest_(rest), leads_there_(leads_there) {}

  static bool take(std::string_view& text, std::string_view part) {
    if (!text.starts_with(part)) return false;
    text.remove_prefix(part.size());
    return true;
  }

  std::string_view rest_;
  bool whole_ = false;  // nothing is taken from the path yet
  bool leads_there_ = false;
};

template <class Path>
bool may_go_on(const Path&) {
  return true;
}
bool may_go_on(const SoughtPath& path) { return path.leads_there(); }

template <class Path, class F>
void walk(const Shape& shape, void* value, const Path& path, const Field* field, const F& f) {
  if (!may_go_on(path)) return;
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

void walk_to_number(const Shape& shape, void* value, std::string_view path,
                    const std::function<void(const Field&, double&)>& f) {
  walk(shape, value, SoughtPath(path), nullptr,
       [&](const SoughtPath& sought, const Field& field, double& number) {
         if (sought.leads_there() && sought.is_there()) f(field, number);
       });
}

}  // namespace strainwave

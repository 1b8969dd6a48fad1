// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/core/described.hpp"

namespace strainwave {

/// Walks a described type: visit_type<T> for one type T.
using TypeWalk = void (*)(const Field& field, TypeVisitor& to);

/// Subject of a schema.
enum class SchemaOf {
  result,   ///< numbers are objects with a unit
  options,  ///< numbers are bare, or text with a unit
};

/// JSON Schema (draft 2020-12) of a described type, as a JSON object without `$schema`.
[[nodiscard]] std::string schema_of(TypeWalk walk, SchemaOf what);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Fills described structs (core/fields.hpp) from TOML.  The readers of drives and of the material
/// library share this header.  It needs toml++, so it is not installed, and only sources may
/// include it.

#include <map>
#include <string>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shape.hpp"
#include "strainwave/core/toml_library.hpp"

namespace strainwave {

/// Place of a value in the file, and its spelling there.
struct TomlSource {
  toml::source_position position;  ///< line and column of its first character, from 1
  std::string written;             ///< spelling; empty for a table or a list
};

/// A value as spelled in the file.
[[nodiscard]] std::string written(const toml::node& node);

/// Fills described structs from TOML nodes and records the place of each value.
class TomlReader {
 public:
  /// @param file_name  name of the file in messages
  explicit TomlReader(std::string_view file_name) : file_name_(file_name) {}

  /// Fills a struct from a table and the tables below it.
  /// @param path   path of the table in its file
  /// @param value  keeps what it holds in fields that the table may leave out
  /// @throws InputError  if a key is unknown, a required field is missing, or a value has the wrong
  ///                     type, unit or name
  template <Described T>
  void read_table(const toml::table& table, const FieldPath& path, T& value) {
    read_record(table, path, shape_of<T>(), &value);
  }

  /// Lets the places of a table hold for a copy of its struct too, which the file does not contain.
  /// A message shows the values of the copy, which may be others than the table gives.
  void repeat(const std::string& table, const std::string& copy);

  /// Adds the place in the file to a fault: the place of the field, or of the table that lacks it.
  [[nodiscard]] InputError located(const InputError& error) const;

 private:
  [[nodiscard]] TextPlace place(toml::source_position position) const;
  void remember(const toml::node& node, const FieldPath& path);
  [[noreturn]] void refuse(const toml::node& node, const FieldPath& path,
                           std::string_view problem) const;
  [[noreturn]] void refuse_type(const toml::node& node, const FieldPath& path,
                                std::string_view type, std::string_view example) const;
  void refuse_unknown(const toml::table& table, const FieldPath& path, const Shape& shape) const;
  void require_optional(const ShapeField& field, const toml::table& table,
                        const FieldPath& path) const;

  void read_record(const toml::table& table, const FieldPath& path, const Shape& shape,
                   void* record);
  /// Fills a value of any shape.
  void read(const toml::node& node, const FieldPath& path, const Field& field, const Shape& shape,
            void* value);
  [[nodiscard]] double number(const toml::node& node, const FieldPath& path,
                              const Field& field) const;
  [[nodiscard]] int whole(const toml::node& node, const FieldPath& path, const Field& field) const;
  [[nodiscard]] std::string text(const toml::node& node, const FieldPath& path,
                                 const Field& field) const;
  [[nodiscard]] std::size_t choice(const toml::node& node, const FieldPath& path,
                                   const Shape& shape) const;
  void read_pair(const toml::node& node, const FieldPath& path, const Field& field,
                 const Shape& shape, void* value);
  void read_list(const toml::node& node, const FieldPath& path, const Field& field,
                 const Shape& shape, void* value);
  void read_map(const toml::node& node, const FieldPath& path, const Field& field,
                const Shape& shape, void* value);
  void read_alternative(const toml::node& node, const FieldPath& path, const Shape& shape,
                        void* value);

  std::string file_name_;
  std::map<std::string, TomlSource> sources_;
};

/// Parses TOML text.  The caller limits its size.
/// @throws InputError  with file, line and column
[[nodiscard]] toml::table parse_toml(std::string_view text, std::string_view file_name);

}  // namespace strainwave

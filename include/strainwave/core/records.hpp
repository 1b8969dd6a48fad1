// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// @file
/// Values as bytes, exact to the last bit, and back.
///
/// A type says once what it consists of, and both directions follow:
/// `template <class Archive> void archive(Archive& to, Row& row) { to(row.value, row.fate); }`.
/// The function stands in the namespace of the type.

namespace strainwave {

/// A record is shorter than its values, or has another form.
class BrokenRecord : public std::runtime_error {
 public:
  BrokenRecord() : std::runtime_error("the record is incomplete") {}
};

/// Writes values as bytes: 8 bytes for a number, the lowest byte first.
class RecordWriter {
 public:
  /// Adds values, each a double, an integer, an enumerator, a std::string, a type with an `archive`
  /// function, or a std::vector, array, pair, map or optional of these.  The values do not change.
  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }
  /// What was written.  It leaves the writer, which is of no use afterwards.
  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  void put_word(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte)
      bytes_ += static_cast<char>(static_cast<unsigned char>(word >> (8 * byte)));
  }
  template <class Value>
  void put(Value& value) {
    if constexpr (std::is_same_v<Value, double>)
      put_word(std::bit_cast<std::uint64_t>(value));
    else if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>)
      put_word(static_cast<std::uint64_t>(value));
    else
      archive(*this, value);
  }
  void put(std::string& text) {
    put_word(text.size());
    bytes_ += text;
  }
  template <class Value>
  void put(std::vector<Value>& values) {
    put_word(values.size());
    for (Value& value : values) put(value);
  }
  template <class Value, std::size_t n>
  void put(std::array<Value, n>& values) {
    for (Value& value : values) put(value);
  }
  template <class First, class Second>
  void put(std::pair<First, Second>& values) {
    put(values.first);
    put(values.second);
  }
  template <class Key, class Value, class Less>
  void put(std::map<Key, Value, Less>& values) {
    std::vector<std::pair<Key, Value>> entries(values.begin(), values.end());
    put(entries);
  }
  template <class Value>
  void put(std::optional<Value>& value) {
    put_word(value ? 1 : 0);
    if (value) put(*value);
  }

  std::string bytes_;
};

/// Reads what a RecordWriter wrote, in the same order.
class RecordReader {
 public:
  /// @param bytes  must outlive the reader
  explicit RecordReader(std::string_view bytes) : rest_(bytes) {}

  /// Fills the values with the next ones of the record.
  /// @throws BrokenRecord
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  /// Whether all bytes have been read.
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::uint64_t word() {
    if (rest_.size() < 8) throw BrokenRecord();
    std::uint64_t word = 0;
    for (unsigned byte = 0; byte < 8; ++byte)
      word |= std::uint64_t{static_cast<unsigned char>(rest_[byte])} << (8 * byte);
    rest_.remove_prefix(8);
    return word;
  }
  /// A number of things that each take at least one byte.
  std::size_t count() {
    const std::uint64_t n = word();
    if (n > rest_.size()) throw BrokenRecord();
    return n;
  }
  template <class Value>
  void get(Value& value) {
    if constexpr (std::is_same_v<Value, double>)
      value = std::bit_cast<double>(word());
    else if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>)
      value = static_cast<Value>(word());
    else
      archive(*this, value);
  }
  void get(std::string& text) {
    const std::size_t n = count();
    text = rest_.substr(0, n);
    rest_.remove_prefix(n);
  }
  template <class Value>
  void get(std::vector<Value>& values) {
    values.resize(count());
    for (Value& value : values) get(value);
  }
  template <class Value, std::size_t n>
  void get(std::array<Value, n>& values) {
    for (Value& value : values) get(value);
  }
  template <class First, class Second>
  void get(std::pair<First, Second>& values) {
    get(values.first);
    get(values.second);
  }
  template <class Key, class Value, class Less>
  void get(std::map<Key, Value, Less>& values) {
    std::vector<std::pair<Key, Value>> entries;
    get(entries);
    values.clear();
    values.insert(entries.begin(), entries.end());
  }
  template <class Value>
  void get(std::optional<Value>& value) {
    value.reset();
    if (word() != 0) get(value.emplace());
  }

  std::string_view rest_;
};

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/io/attachments.hpp"

// Private header of io/history_file.cpp.

namespace strainwave {

/// Lines of a text that comes in pieces.
class TextLines {
 public:
  explicit TextLines(TextPieces pieces) : pieces_(std::move(pieces)), buffer_(kPiece) {}

  /// The next line without its end; absent at the end of the text.  It is valid until the next
  /// call.
  std::optional<std::string_view> next() {
    for (std::size_t searched = begin_;;) {
      const void* const found = std::memchr(buffer_.data() + searched, '\n', end_ - searched);
      if (found != nullptr) {
        const auto at = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
        return take(at, at + 1);
      }
      if (ended_) {
        if (begin_ == end_) return std::nullopt;
        return take(end_, end_);
      }
      searched = end_ - begin_;
      refill();
    }
  }

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] bool too_long() const { return too_long_; }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 18;
  static constexpr std::size_t kMaxLine = std::size_t{1} << 20;

  std::string_view take(std::size_t end, std::size_t next) {
    const std::string_view line(buffer_.data() + begin_, end - begin_);
    begin_ = next;
    ++line_;
    return line;
  }

  /// Moves the rest to the front and reads behind it.
  void refill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size()) {
      if (buffer_.size() >= kMaxLine) {
        too_long_ = true;  // the caller refuses what the line begins with
        ended_ = true;
        return;
      }
      buffer_.resize(2 * buffer_.size());
    }
    const std::size_t size = pieces_(std::span(buffer_).subspan(end_));
    ended_ = size == 0;
    end_ += size;
    bytes_ += size;
  }

  TextPieces pieces_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool ended_ = false;
  bool too_long_ = false;
  std::size_t line_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace strainwave

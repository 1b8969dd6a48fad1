// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/attachments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <system_error>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// Whether a name stays below its folder on every system: without drive letter, root, step up, or a
/// character that ends a name.
bool stays_below(std::string_view name) {
  if (name.starts_with('/') || name.find_first_of(std::string_view("\\:\0", 3)) != name.npos)
    return false;
  const std::filesystem::path path(name);
  return std::ranges::find(path, "..") == path.end();
}

void require_below(std::string_view name, std::string_view field) {
  if (!stays_below(name))
    throw InputError(field,
                     fmt::format("\"{}\" must be a name relative to the folder of the input, "
                                 "with / between folders and without .. and :",
                                 shown(name)));
}

[[noreturn]] void refuse_absent(std::string_view name, std::string_view field) {
  throw InputError(field, fmt::format("\"{}\" is not a file beside the input", shown(name)));
}

/// The regular file of a name below the folder of an input file.
std::optional<std::filesystem::path> file_below(const std::filesystem::path& parent,
                                                std::string_view name) {
  std::error_code error;
  const auto folder = std::filesystem::canonical(parent.empty() ? "." : parent, error);
  if (error) return std::nullopt;
  auto file = std::filesystem::canonical(folder / name, error);
  if (error || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  if (std::ranges::mismatch(folder, file).in1 != folder.end()) return std::nullopt;
  return file;
}

}  // namespace

Attachments::Attachments(Texts texts)
    : lookup_([texts = std::move(texts)](std::string_view name) {
        const auto found = texts.find(name);
        return found == texts.end() ? std::nullopt : std::optional(found->second);
      }) {
  open_ = [lookup = lookup_](std::string_view name) {
    std::optional<std::string> found = lookup(name);
    return found ? std::optional(pieces_of(*std::move(found))) : std::nullopt;
  };
}

Attachments Attachments::noted_in(Texts& texts) const {
  const auto lookup = [lookup = lookup_, &texts](std::string_view name) {
    std::optional<std::string> found = lookup ? lookup(name) : std::nullopt;
    if (found) texts.insert_or_assign(std::string(name), *found);
    return found;
  };
  if (!open_) return Attachments(lookup);
  return Attachments(lookup, [open = open_, &texts](std::string_view name) {
    std::optional<TextPieces> found = open(name);
    if (!found) return found;
    std::string& text = texts.insert_or_assign(std::string(name), std::string()).first->second;
    return std::optional<TextPieces>([pieces = *std::move(found), &text](std::span<char> to) {
      const std::size_t size = pieces(to);
      text.append(to.data(), size);
      return size;
    });
  });
}

std::string Attachments::text(std::string_view name, std::string_view field) const {
  require_below(name, field);
  const std::optional<std::string> found = lookup_ ? lookup_(name) : std::nullopt;
  if (!found) refuse_absent(name, field);
  if (found->size() > kMaxTextSize)
    throw InputError(field, fmt::format("\"{}\" is larger than 1 MiB", shown(name)));
  return *found;
}

TextPieces Attachments::pieces(std::string_view name, std::string_view field) const {
  if (!open_) return pieces_of(text(name, field));
  require_below(name, field);
  std::optional<TextPieces> found = open_(name);
  if (!found) refuse_absent(name, field);
  return *std::move(found);
}

TextPieces pieces_of(std::string text) {
  return [text = std::move(text), at = std::size_t{0}](std::span<char> to) mutable {
    const std::size_t size = text.copy(to.data(), to.size(), at);
    at += size;
    return size;
  };
}

TextPieces pieces_of_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(name, "is a directory");
  const auto stream = std::make_shared<std::ifstream>(file, std::ios::binary);
  if (!*stream)
    throw InputError(name, fmt::format("cannot be opened for reading: {}",
                                       std::generic_category().message(errno)));
  return [stream, name](std::span<char> to) {
    stream->read(to.data(), static_cast<std::streamsize>(to.size()));
    if (stream->bad()) throw InputError(name, "cannot be read");
    return static_cast<std::size_t>(stream->gcount());
  };
}

Attachments attachments_beside(const std::filesystem::path& input_file) {
  const std::filesystem::path parent = input_file.parent_path();
  return Attachments(
      [parent](std::string_view name) -> std::optional<std::string> {
        const auto file = file_below(parent, name);
        return file ? std::optional(read_text_file(*file)) : std::nullopt;
      },
      [parent](std::string_view name) -> std::optional<TextPieces> {
        const auto file = file_below(parent, name);
        return file ? std::optional(pieces_of_file(*file)) : std::nullopt;
      });
}

std::string read_text(std::istream& stream, std::string_view name) {
  // A file of a drive has some kilobytes, so memory for the largest one would take longer to clear
  // than the file to read.
  std::string text;
  std::array<char, 1 << 14> piece;
  do {
    stream.read(piece.data(), piece.size());
    if (stream.bad()) throw InputError(name, "cannot be read");
    const auto got = static_cast<std::size_t>(stream.gcount());
    text.append(piece.data(), std::min(got, kMaxTextSize + 1 - text.size()));
  } while (stream && text.size() <= kMaxTextSize);
  return text;
}

std::string read_text_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(name, "is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(name, "cannot be opened for reading");
  return read_text(stream, name);
}

}  // namespace strainwave

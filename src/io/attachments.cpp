// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/attachments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

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

}  // namespace

Attachments::Attachments(Texts texts)
    : lookup_([texts = std::move(texts)](std::string_view name) {
        const auto found = texts.find(name);
        return found == texts.end() ? std::nullopt : std::optional(found->second);
      }) {}

std::string Attachments::text(std::string_view name, std::string_view field) const {
  if (!stays_below(name))
    throw InputError(field,
                     fmt::format("\"{}\" must be a name relative to the folder of the input, "
                                 "with / between folders and without .. and :",
                                 shown(name)));
  const std::optional<std::string> found = lookup_ ? lookup_(name) : std::nullopt;
  if (!found)
    throw InputError(field, fmt::format("\"{}\" is not a file beside the input", shown(name)));
  if (found->size() > kMaxTextSize)
    throw InputError(field, fmt::format("\"{}\" is larger than 1 MiB", shown(name)));
  return *found;
}

Attachments attachments_beside(const std::filesystem::path& input_file) {
  return Attachments(
      [parent = input_file.parent_path()](std::string_view name) -> std::optional<std::string> {
        std::error_code error;
        const auto folder = std::filesystem::canonical(parent.empty() ? "." : parent, error);
        if (error) return std::nullopt;
        const auto file = std::filesystem::canonical(folder / name, error);
        if (error || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
        if (std::ranges::mismatch(folder, file).in1 != folder.end()) return std::nullopt;
        return read_text_file(file);
      });
}

std::string read_text(std::istream& stream, std::string_view name) {
  std::string text(kMaxTextSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(name, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
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

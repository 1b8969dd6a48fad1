// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// @file
/// The texts that a drive names, such as its tables of compliances.  The reader of a drive opens no
/// file: its caller supplies these texts.

namespace strainwave {

/// No attachment, and no drive, is larger [bytes].
inline constexpr std::size_t kMaxTextSize = 1 << 20;  // 1 MiB

/// Texts by name, given at once or looked up when they are asked for.
class Attachments {
 public:
  using Texts = std::map<std::string, std::string, std::less<>>;
  /// The text of a name, or nothing; a text may be cut behind kMaxTextSize + 1 bytes.
  using Lookup = std::function<std::optional<std::string>(std::string_view name)>;

  Attachments() = default;  ///< none
  explicit Attachments(Texts texts);
  explicit Attachments(Lookup lookup) : lookup_(std::move(lookup)) {}

  /// The text of that name.
  /// @throws InputError  names the field: the name is absolute, leads out of the folder of the
  ///                     input or is not attached; the text is larger than kMaxTextSize
  [[nodiscard]] std::string text(std::string_view name, std::string_view field) const;

 private:
  Lookup lookup_;
};

/// The regular files below the folder of an input file.
///
/// A link that leads out of the folder, a folder, a device and a pipe count as absent, so that the
/// answer does not tell what exists outside.
///
/// @param input_file  of a drive; a name without a folder means the current one
[[nodiscard]] Attachments attachments_beside(const std::filesystem::path& input_file);

/// The first bytes of a stream, at most kMaxTextSize + 1: enough to see that it has more than
/// kMaxTextSize.
/// @param name  for messages
/// @throws InputError  it cannot be read
[[nodiscard]] std::string read_text(std::istream& stream, std::string_view name);

/// The same of a file that the user names.
/// @throws InputError  it cannot be opened or read
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

}  // namespace strainwave

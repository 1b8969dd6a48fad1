// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// @file
/// The texts that a drive names, such as its compliance tables.  The reader of a drive does not
/// open files, so its caller supplies these texts.

namespace strainwave {

/// Reads the next bytes of a long text into `to`.  Returns their number; 0 at the end of the text.
/// @throws InputError  if the text cannot be read
using TextPieces = std::function<std::size_t(std::span<char> to)>;

/// The pieces of a text in memory.
[[nodiscard]] TextPieces pieces_of(std::string text);
/// The pieces of a file; the file stays open as long as they exist.
/// @throws InputError  if the file cannot be opened
[[nodiscard]] TextPieces pieces_of_file(const std::filesystem::path& file);

/// Largest size of an attachment or of a drive [bytes].
inline constexpr std::size_t kMaxTextSize = 1 << 20;  // 1 MiB

/// Texts by name.  They are given in advance, or looked up on request.
class Attachments {
 public:
  /// Texts by their names.
  using Texts = std::map<std::string, std::string, std::less<>>;
  /// Returns the text of a name, or nothing.  A text may be cut after kMaxTextSize + 1 bytes.
  using Lookup = std::function<std::optional<std::string>(std::string_view name)>;
  /// Returns the pieces of a text of any length by its name, or nothing.
  using Open = std::function<std::optional<TextPieces>(std::string_view name)>;

  Attachments() = default;  ///< without attachments
  /// Texts that are given in advance.
  explicit Attachments(Texts texts);
  /// Texts that are looked up on request.
  /// @param lookup  returns the text of a name; empty: `text` finds none
  /// @param open    empty: all texts come from `lookup` and are at most kMaxTextSize long
  explicit Attachments(Lookup lookup, Open open = {})
      : lookup_(std::move(lookup)), open_(std::move(open)) {}

  /// The same texts.  Each text that is looked up is also stored in `texts`, which must outlive the
  /// attachments.
  [[nodiscard]] Attachments noted_in(Texts& texts) const;

  /// The text with a given name.
  /// @throws InputError  if the name is absolute, leads out of the folder of the input or is not
  ///                     attached, or if the text is larger than kMaxTextSize; the message names
  ///                     the field
  [[nodiscard]] std::string text(std::string_view name, std::string_view field) const;

  /// The pieces of the text with a given name, which may be of any length.
  /// @throws InputError  as `text`, except for the length
  [[nodiscard]] TextPieces pieces(std::string_view name, std::string_view field) const;

 private:
  Lookup lookup_;
  Open open_;
};

/// The regular files below the folder of an input file.
///
/// A link that leads out of the folder, a folder, a device and a pipe count as absent, so an answer
/// does not reveal what exists outside.
///
/// @param input_file  input file of a drive; a name without a folder means the current folder
[[nodiscard]] Attachments attachments_beside(const std::filesystem::path& input_file);

/// Reads the first bytes of a stream, at most kMaxTextSize + 1.  One byte more than the limit shows
/// the caller that the text is too long.
/// @param stream  stream to read, from its present place
/// @param name    name of the stream in messages
/// @throws InputError  if the stream cannot be read
[[nodiscard]] std::string read_text(std::istream& stream, std::string_view name);

/// Reads a file that the user names, as read_text does.
/// @throws InputError  if the file cannot be opened or read
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

}  // namespace strainwave

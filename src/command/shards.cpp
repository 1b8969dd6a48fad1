// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/shards.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <span>

#include "strainwave/core/sha256.hpp"
#include "strainwave/core/version.hpp"

namespace strainwave {

template <class Archive>
void archive(Archive& to, SharedStudy& study) {
  to(study.program, study.version, study.revision, study.code_path, study.command, study.options,
     study.texts, study.drive_name, study.drive_text, study.attachments);
}

template <class Archive>
void archive(Archive& to, Shard& shard) {
  to(shard.study, shard.share.part, shard.share.parts, shard.rows, shard.bytes);
}

namespace {

constexpr std::string_view kShardFormat = "strainwave-shard/1";
constexpr int kMostShares = 100'000;

/// What decides which variants of the mathematical functions run.
std::string code_path() {
  std::string path = "other processor";
#ifdef __x86_64__
  path = "x86-64";
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") != 0) path += " avx2";
  if (__builtin_cpu_supports("fma") != 0) path += " fma";
#endif
  return fmt::format("{}, glibc {}", path, gnu_get_libc_version());
}

bool is_share(const Share& share) {
  return share.parts <= kMostShares && share.part >= 1 && share.part <= share.parts;
}

std::string words_of(const Share& share) { return fmt::format("{}/{}", share.part, share.parts); }

/// All texts of an option in a study, such as "1"; empty if it was not given.
std::string given(const SharedStudy& study, const std::string& option) {
  std::vector<std::string> texts;
  for (const auto& [name, text] : study.options)
    if (name == option) texts.push_back(text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string option_difference(const SharedStudy& one, const SharedStudy& other) {
  const auto differs = [&](const std::string& name) {
    const auto words = [](const std::string& text) {
      return text.empty() ? "left out" : shown(text);
    };
    const std::string a = given(one, name);
    const std::string b = given(other, name);
    return a == b ? std::string()
                  : fmt::format("the option {} is {} in one and {} in the other", name, words(a),
                                words(b));
  };
  for (const SharedStudy* const study : {&one, &other})
    for (const auto& [name, text] : study->options)
      if (std::string found = differs(name); !found.empty()) return found;
  return one.options == other.options ? "" : "the options have another order";
}

/// Name of a shard, and the shard without its rows.
using NamedShard = std::pair<std::string, Shard>;

/// Checks that the shares are all parts of one division, each once.
void require_complete(const std::vector<std::pair<std::string, Shard>>& shards) {
  const std::string& first_name = shards.front().first;
  const Shard& first = shards.front().second;
  std::vector<const std::string*> file(static_cast<std::size_t>(first.share.parts), nullptr);
  for (const auto& [name, shard] : shards) {
    if (shard.share.parts != first.share.parts)
      throw InputError(name, fmt::format("is share {}, but {} is share {}; merge the shares of one "
                                         "division",
                                         words_of(shard.share), first_name, words_of(first.share)));
    const std::string*& of_part = file[static_cast<std::size_t>(shard.share.part - 1)];
    if (of_part != nullptr)
      throw InputError(name, fmt::format("is share {}, and so is {}; give each share once",
                                         words_of(shard.share), *of_part));
    of_part = &name;
  }
  std::vector<std::size_t> missing;
  for (std::size_t k = 0; k < file.size(); ++k)
    if (file[k] == nullptr) missing.push_back(k + 1);
  if (missing.empty()) return;
  constexpr std::size_t kShown = 8;
  const std::size_t more = missing.size() - std::min(missing.size(), kShown);
  missing.resize(missing.size() - more);
  throw InputError("shards",
                   fmt::format("{} of {} are missing{}; compute them with --shard {}/{} and so on",
                               fmt::join(missing, ", "), first.share.parts,
                               more > 0 ? fmt::format(", and {} more", more) : std::string(),
                               missing.front(), first.share.parts));
}

/// The text of a shard.
std::string text_of_shard(const std::string& name, const OptionTexts& texts, const Host& host) {
  if (const auto text = texts.find(name); text != texts.end()) return text->second;
  if (!host.open) throw OptionError("shards", "names a text that is not attached");
  const TextPieces pieces = host.open(name);
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::string text;
  for (std::size_t size = 0;;) {
    text.resize(size + kPiece);
    const std::size_t n = pieces(std::span(text).subspan(size));
    size += n;
    text.resize(size);
    // Another file may be larger than the memory; the reader of shards refuses its beginning.
    if (n == 0 || (size >= kPiece && !begins_as_shard(text))) return text;
  }
}

/// Refuses to write rows of a study that has none, before its shards are read and merged.
void require_rows(std::span<const Command> table, const SharedStudy& study, const Host& host) {
  if (host.rows != nullptr && command_named(table, study.command).rows.empty())
    throw OptionError("rows", fmt::format("cannot be written, because the study of {} has none; "
                                          "merge its shards without --rows",
                                          study.command));
}

/// The answer of the study whose shares `load` reads again.
/// @param shards  without their rows
/// @param load    returns a shard with its rows, by its place in `shards`
Answer merged_by(std::span<const Command> table, const std::vector<NamedShard>& shards,
                 const std::function<Shard(std::size_t)>& load, const Progress& progress,
                 const Host& host);

struct MergeOptions {
  std::vector<std::string> shards;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "shards",
           .unit = "",
           .doc = "files that --shard wrote, in any order",
           .positional = true,
           .names = "shard"},
          &MergeOptions::shards);
  }
};

/// The result of `merge`, which is that of another command.
struct OtherResult {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

ResultEvidence evidence_of(const OtherResult&) { return {}; }

/// Never called, because the answer of the merged command writes its documents.
std::string no_document(const OtherResult&) { return {}; }

}  // namespace

Share parse_share(std::string_view text) {
  Share share;
  const char* const end = text.data() + text.size();
  const auto part = std::from_chars(text.data(), end, share.part);
  const bool slash = part.ec == std::errc() && part.ptr != end && *part.ptr == '/';
  const auto parts = slash ? std::from_chars(part.ptr + 1, end, share.parts) : part;
  if (!slash || parts.ec != std::errc() || parts.ptr != end)
    throw OptionError("shard", fmt::format("is {}; it must be a share such as 3/16", shown(text)));
  if (!is_share(share))
    throw OptionError(
        "shard", fmt::format("is {}; the first number must be from 1 to the second, and the second "
                             "from 1 to {}",
                             shown(text), kMostShares));
  return share;
}

SharedStudy shared_study(const Command& command, const Drive* drive, Attachments::Texts attachments,
                         const OptionValues& options, const OptionTexts& texts) {
  auto kept = options.texts();
  std::erase_if(kept, [](const auto& option) { return option.first == "threads"; });
  return {.program = std::string(command.program),
          .version = std::string(version()),
          .revision = std::string(git_revision()),
          .code_path = code_path(),
          .command = std::string(command.name),
          .options = std::move(kept),
          .texts = texts,
          .drive_name = drive != nullptr ? drive->name : std::string(),
          .drive_text = drive != nullptr ? drive->text : std::string(),
          .attachments = std::move(attachments)};
}

std::vector<std::pair<std::string, std::string>> rows_origin(const SharedStudy& study) {
  std::string options;
  for (const auto& [name, text] : study.options)
    options += fmt::format("{}{}={}", options.empty() ? "" : "\n", name, text);
  std::string files;
  const auto add_files = [&](const auto& texts) {
    for (const auto& [name, text] : texts)
      files += fmt::format("{}{} {}", files.empty() ? "" : "\n", sha256_hex(text), name);
  };
  add_files(study.attachments);
  add_files(study.texts);
  return {{"program", study.program},
          {"version", study.version},
          {"revision", study.revision},
          {"code_path", study.code_path},
          {"command", study.command},
          {"options", options},
          {"input_file", study.drive_name},
          {"input_sha256", study.drive_text.empty() ? "" : sha256_hex(study.drive_text)},
          {"attached_sha256", files}};
}

Shard computed_shard(const Command& command, const std::shared_ptr<const Drive>& drive,
                     const OptionValues& options, SharedStudy study, const Share& share,
                     const Progress& progress, const Host& host) {
  if (command.shares.empty())
    throw OptionError("shard", fmt::format("is not known to {}", command.name));
  SharedRows rows(share);
  Host shares{.ranks = host.ranks,
              .shared = &rows,
              .units = host.units,
              .beside = host.beside,
              .open = host.open};
  try {
    (void)run(command, drive, options, study.texts, progress, shares);
  } catch (const ShareDone&) {
    return {.study = std::move(study), .share = share, .rows = rows.rows(), .bytes = rows.bytes()};
  }
  throw OptionError(
      "shard", fmt::format("divides {}, and there are none with these options", command.shares));
}

std::string shard_text(Shard shard) {
  RecordWriter to;
  to(shard);
  const std::string record = std::move(to).bytes();
  return fmt::format("{}\n{}\n", kShardFormat, sha256_hex(record)) + record;
}

bool begins_as_shard(std::string_view text) {
  return text.substr(0, text.find('\n')) == kShardFormat;
}

Shard parse_shard(std::string_view text, const std::string& name) {
  const std::size_t first = text.find('\n');
  if (!begins_as_shard(text))
    throw InputError(name, fmt::format("is not a shard; its first line must be {}", kShardFormat));
  const std::size_t second = text.find('\n', first + 1);
  Shard shard;
  try {
    if (second == std::string_view::npos) throw BrokenRecord();
    const std::string_view record = text.substr(second + 1);
    if (text.substr(first + 1, second - first - 1) != sha256_hex(record)) throw BrokenRecord();
    RecordReader from(record);
    from(shard);
    if (!from.at_end() || !is_share(shard.share)) throw BrokenRecord();
  } catch (const BrokenRecord&) {
    throw InputError(name, "is a damaged shard; compute it again");
  }
  return shard;
}

std::string difference(const SharedStudy& one, const SharedStudy& other) {
  const auto differs = [](std::string_view what, const std::string& a, const std::string& b) {
    return a == b
               ? std::string()
               : fmt::format("the {} is {} in one and {} in the other", what, shown(a), shown(b));
  };
  for (const auto& [what, member] : {std::pair{"program", &SharedStudy::program},
                                     {"version", &SharedStudy::version},
                                     {"revision", &SharedStudy::revision},
                                     {"command", &SharedStudy::command},
                                     {"name of the drive", &SharedStudy::drive_name},
                                     {"code path", &SharedStudy::code_path}})
    if (std::string found = differs(what, one.*member, other.*member); !found.empty()) return found;
  if (std::string found = option_difference(one, other); !found.empty()) return found;
  if (one.drive_text != other.drive_text) return "the text of the drive differs";
  if (one.attachments != other.attachments) return "a file that the drive names differs";
  if (one.texts != other.texts) return "a file that an option names differs";
  return {};
}

Answer merged(std::span<const Command> table,
              const std::vector<std::pair<std::string, Shard>>& shards, const Progress& progress,
              const Host& host) {
  if (!shards.empty()) require_rows(table, shards.front().second.study, host);
  return merged_by(
      table, shards, [&](std::size_t at) { return shards[at].second; }, progress, host);
}

namespace {

Answer merged_by(std::span<const Command> table, const std::vector<NamedShard>& shards,
                 const std::function<Shard(std::size_t)>& load, const Progress& progress,
                 const Host& host) {
  if (shards.empty()) throw OptionError("shards", "must be given; name the files of all shards");
  const std::string& first_name = shards.front().first;
  const Shard& first = shards.front().second;
  const SharedStudy& study = first.study;
  const Command& command = command_named(table, study.command);
  const SharedStudy here = shared_study(command, nullptr, {}, OptionValues(command.options), {});
  for (const auto& [name, shard] : shards) {
    if (const std::string found = difference(study, shard.study); !found.empty())
      throw InputError(name,
                       fmt::format("is a shard of another study than {}: {}", first_name, found));
    if (shard.rows != first.rows)
      throw InputError(name, fmt::format("is a shard of {} rows, but {} of {}", shard.rows,
                                         first_name, first.rows));
  }
  for (const auto& [what, member] : {std::pair{"version", &SharedStudy::version},
                                     {"revision", &SharedStudy::revision},
                                     {"code path", &SharedStudy::code_path}})
    if (study.*member != here.*member)
      throw InputError(first_name,
                       fmt::format("has the {} {}, and this program has {}; merge the shards where "
                                   "both are the same, because digits may differ",
                                   what, shown(study.*member), shown(here.*member)));
  require_complete(shards);
  std::vector<std::size_t> place_of(shards.size());  // in `shards`, by the part
  for (std::size_t at = 0; at < shards.size(); ++at)
    place_of[static_cast<std::size_t>(shards[at].second.share.part - 1)] = at;
  SharedRows rows(first.rows, first.share.parts, [&](int part) {
    const std::size_t at = place_of[static_cast<std::size_t>(part - 1)];
    Shard shard = load(at);
    if (shard.rows != first.rows || shard.share != shards[at].second.share ||
        !difference(shard.study, study).empty())
      throw InputError(shards[at].first, "was changed by another program; merge again");
    return std::move(shard.bytes);
  });
  if (host.rows != nullptr) host.rows->come_from(rows_origin(study));
  OptionValues options(command.options);
  for (const auto& [name, text] : study.options) options.set(name, text);
  std::shared_ptr<const Drive> drive;
  if (!study.drive_text.empty())
    drive = read_drive(study.drive_text, study.drive_name, Attachments(study.attachments));
  try {
    return run(command, drive, options, study.texts, progress,
               {.ranks = host.ranks,
                .shared = &rows,
                .rows = host.rows,
                .units = host.units,
                .columns = host.columns,
                .beside = host.beside,
                .open = host.open});
  } catch (const BrokenRecord&) {
    throw InputError("shards", "have rows of another form than this program; compute all again");
  }
}

}  // namespace

Command merge_command(std::span<const Command> (*table)()) {
  Command row = command<MergeOptions, OtherResult>({
      .name = "merge",
      .summary = "Merge the shards of a study into the answer of one run",
      .description =
          "Reads the files that --shard wrote for all shares of a study, in any order and from any "
          "machine, and gives the answer that one run without --shard gives, to the byte. A shard "
          "contains the drive and the options, so no other file is needed. Shards of another "
          "drive, version, option, seed or code path are refused by name; the code path is what "
          "the last digits depend on, the instructions of the processor and the mathematical "
          "library.",
      .example = "strainwave merge part-*.shard --format json --output study.json",
      .rows = "rows of the study, as its command",
      .takes = Takes::nothing,
      .function = [](const Request&, const MergeOptions&) { return OtherResult(); },
      .documents = {{{.name = kDefaultDocument}, no_document},
                    {{.name = "text", .format = Format::text}, no_document},
                    {{.name = "csv", .format = Format::csv}, no_document},
                    {{.name = "markdown", .format = Format::markdown}, no_document},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the study as an SVG file, if its command does"},
                     no_document}},
  });
  row.instead = [table](const OptionValues& options, const OptionTexts& texts,
                        const Progress& progress, const Host& host) {
    std::vector<NamedShard> shards;
    const auto load = [&](const std::string& name) {
      return parse_shard(text_of_shard(name, texts, host), name);
    };
    for (const auto& option : options.texts()) {
      const std::string& name = option.second;
      if (std::ranges::any_of(shards, [&](const auto& one) { return one.first == name; }))
        throw InputError(name, "is given twice; give each shard once");
      shards.emplace_back(name, load(name)).second.bytes = std::string();
      if (shards.size() == 1) require_rows(table(), shards.front().second.study, host);
    }
    return merged_by(
        table(), shards, [&](std::size_t at) { return load(shards[at].first); }, progress, host);
  };
  return row;
}

}  // namespace strainwave

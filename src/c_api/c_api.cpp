// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "strainwave/core/version.hpp"
#include "strainwave/door/batch.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/io/edit.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/strainwave.h"

// NOLINTBEGIN(readability-identifier-naming): the header fixes these names
struct sw_drive {
  std::shared_ptr<const strainwave::Drive> drive;
};

struct sw_answer {
  strainwave::Answer answer;
};

struct sw_error {
  sw_code code = SW_INTERNAL;
  std::array<std::string, SW_RULE + 1> texts;
  std::size_t line = 0;
  std::size_t column = 0;
};
// NOLINTEND(readability-identifier-naming)

namespace strainwave {
namespace {

std::string_view view(sw_text text) {
  return text.size == 0 ? std::string_view() : std::string_view(text.data, text.size);
}

/// Thrown if a source or a sink of the caller reports a fault.
class CallbackFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The error that can be reported without allocating memory.
sw_error* no_memory() {
  // At most 15 characters, which std::string stores without allocation.
  static sw_error error{.code = SW_NO_MEMORY, .texts = {"out of memory"}};
  return &error;
}

sw_error* error_of(sw_code code, const char* message) {
  return std::make_unique<sw_error>(sw_error{.code = code, .texts = {message}}).release();
}

sw_error* error_of(sw_code code, const InputError& error) {
  return std::make_unique<sw_error>(sw_error{.code = code,
                                             .texts = {error.what(), error.place().file,
                                                       error.field(), error.value(), error.rule()},
                                             .line = error.place().line,
                                             .column = error.place().column})
      .release();
}

/// The current exception as an error of this interface.
sw_error* thrown() {
  try {
    throw;
  } catch (const OptionError& error) {
    return error_of(SW_OPTION, error);
  } catch (const InputError& error) {
    return error_of(SW_INPUT, error);
  } catch (const SolverError& error) {
    return error_of(SW_NO_ANSWER, error.what());
  } catch (const Stopped& stopped) {
    return error_of(SW_STOPPED, stopped.what());
  } catch (const CallbackFault& fault) {
    return error_of(SW_CALLBACK, fault.what());
  } catch (const std::bad_alloc&) {
    return no_memory();
  } catch (const std::exception& error) {
    return error_of(SW_INTERNAL, error.what());
  } catch (...) {
    return error_of(SW_INTERNAL, "unknown exception");
  }
}

/// Runs `work` and turns any exception into an error.
template <class Work>
sw_error* guarded(const Work& work) noexcept {
  try {
    try {
      work();
      return nullptr;
    } catch (...) {
      return thrown();
    }
  } catch (...) {  // describing the error needed more memory than available
    return no_memory();
  }
}

/// A text that the caller frees.
sw_text given(std::string_view text) {
  if (text.empty()) return {.data = nullptr, .size = 0};
  auto* const data = new char[text.size()];
  std::memcpy(data, text.data(), text.size());
  return {.data = data, .size = text.size()};
}

/// A source that is closed when nobody reads it any more.
class OpenSource {
 public:
  explicit OpenSource(const sw_source& source) : source_(source) {}
  ~OpenSource() {
    if (source_.close != nullptr) source_.close(source_.context);
  }
  OpenSource(const OpenSource&) = delete;
  OpenSource& operator=(const OpenSource&) = delete;

  /// Reads at most as many bytes as there is room for; 0 at the end.
  [[nodiscard]] std::size_t next(std::span<char> to) const {
    const std::ptrdiff_t n = source_.next(source_.context, to.data(), to.size());
    if (n < 0 || static_cast<std::size_t>(n) > to.size())
      throw CallbackFault("the source function of the caller reported a fault");
    return static_cast<std::size_t>(n);
  }

 private:
  sw_source source_;
};

/// Reads a source, at most kMaxTextSize + 1 bytes.  One byte more than the limit shows the caller
/// that the text is too long.
std::string all_of(const OpenSource& source) {
  std::string text;
  std::vector<char> piece(std::size_t{1} << 16U);
  while (text.size() <= kMaxTextSize) {
    const std::size_t n =
        source.next(std::span(piece).first(std::min(piece.size(), kMaxTextSize + 1 - text.size())));
    if (n == 0) break;
    text.append(piece.data(), n);
  }
  return text;
}

/// The attachment of a name among those that were handed over.
const sw_attachment* handed_over(const sw_attachments& given, std::string_view name) {
  const sw_attachment* const end = given.array + given.count;
  const sw_attachment* const known = std::find_if(
      given.array, end, [&](const sw_attachment& one) { return view(one.name) == name; });
  return known != end ? known : nullptr;
}

/// The source of a name that the caller finds; null if there is none.
std::shared_ptr<const OpenSource> found_source(const sw_attachments& given, std::string_view name) {
  sw_source source{};
  if (given.find == nullptr ||
      given.find(given.context, {.data = name.data(), .size = name.size()}, &source) != 0)
    return nullptr;
  return std::make_shared<const OpenSource>(source);
}

Attachments attachments_of(const sw_attachments* given) {
  if (given == nullptr) return {};
  return Attachments(
      [given](std::string_view name) -> std::optional<std::string> {
        if (const sw_attachment* const known = handed_over(*given, name))
          return std::string(view(known->text));
        const auto source = found_source(*given, name);
        return source ? std::optional(all_of(*source)) : std::nullopt;
      },
      [given](std::string_view name) -> std::optional<TextPieces> {
        if (const sw_attachment* const known = handed_over(*given, name))
          return pieces_of(std::string(view(known->text)));
        const auto source = found_source(*given, name);
        if (!source) return std::nullopt;
        return [source](std::span<char> to) { return source->next(to); };
      });
}

Progress progress_of(const sw_progress* progress) {
  if (progress == nullptr) return {};
  return Progress(
      [told = *progress](double share) { return told.report(told.context, share) == 0; });
}

std::vector<std::string> strings(const sw_text* texts, std::size_t n) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < n; ++i) all.emplace_back(view(texts[i]));
  return all;
}

sw_drive* drive_of(std::string text, sw_text name, const sw_attachments* attachments) {
  return std::make_unique<sw_drive>(sw_drive{read_drive(std::move(text), std::string(view(name)),
                                                        attachments_of(attachments))})
      .release();
}

std::string commands_json() {
  auto rows = nlohmann::ordered_json::array();
  for (const Command& command : commands()) {
    auto options = nlohmann::ordered_json::array();
    for (const Option& option : command.options.options) options.push_back(option.field.name);
    nlohmann::ordered_json documents = {"json"};
    for (const Document& document : command.documents) documents.push_back(document.name);
    rows.push_back({{"name", command.name},
                    {"summary", command.summary},
                    {"takes", enum_name(command.takes)},
                    {"options", std::move(options)},
                    {"documents", std::move(documents)}});
  }
  return rows.dump();
}

}  // namespace
}  // namespace strainwave

using namespace strainwave;  // NOLINT(google-build-using-namespace): the C functions have no other

const char* sw_version(void) { return version().data(); }

sw_error* sw_commands(sw_text* json) {
  return guarded([&] { *json = given(commands_json()); });
}

sw_error* sw_read(sw_text text, sw_text name, const sw_attachments* attachments, sw_drive** drive) {
  return guarded([&] { *drive = drive_of(std::string(view(text)), name, attachments); });
}

sw_error* sw_read_from(sw_source source, sw_text name, const sw_attachments* attachments,
                       sw_drive** drive) {
  return guarded([&] { *drive = drive_of(all_of(OpenSource(source)), name, attachments); });
}

sw_error* sw_edit(sw_text text, sw_text path, const sw_text* value, sw_text* edited) {
  return guarded([&] {
    *edited =
        given(edit(view(text), view(path),
                   value != nullptr ? std::optional(std::string(view(*value))) : std::nullopt));
  });
}

sw_error* sw_drive_fields(const sw_drive* drive, sw_text* json) {
  return guarded([&] { *json = given(json_of(drive->drive->gear, JsonNumbers::as_input)); });
}

sw_error* sw_run(const sw_drive* drive, sw_text command, sw_text options,
                 const sw_attachment* texts, size_t n_texts, const sw_progress* progress,
                 sw_answer** answer) {
  return guarded([&] {
    const Command& row = command_named(commands(), view(command));
    OptionValues values(row.options);
    if (options.size > 0) values.set_from_json(view(options));
    OptionTexts named;
    for (std::size_t i = 0; i < n_texts; ++i)
      named.emplace(view(texts[i].name), view(texts[i].text));
    *answer =
        std::make_unique<sw_answer>(sw_answer{run(row, drive != nullptr ? drive->drive : nullptr,
                                                  values, named, progress_of(progress))})
            .release();
  });
}

int sw_answer_usable(const sw_answer* answer) { return answer->answer.usable() ? 1 : 0; }

sw_error* sw_answer_document(const sw_answer* answer, sw_text name, sw_text* document) {
  return guarded([&] { *document = given(answer->answer.document(view(name))); });
}

sw_error* sw_answer_write(const sw_answer* answer, sw_text name, const sw_sink* sink) {
  return guarded([&] {
    constexpr std::size_t kPiece = std::size_t{1} << 16U;
    const std::string document = answer->answer.document(view(name));
    for (std::size_t at = 0; at < document.size(); at += kPiece)
      if (sink->write(sink->context, document.data() + at,
                      std::min(kPiece, document.size() - at)) != 0)
        throw CallbackFault("the sink function of the caller reported a fault");
    if (sink->commit != nullptr && sink->commit(sink->context) != 0)
      throw CallbackFault("the sink function of the caller reported a fault");
  });
}

sw_error* sw_batch(const sw_drive* drive, const sw_batch_task* task, const sw_progress* progress,
                   double* numbers, int* codes, sw_text* faults) {
  return sw_batch_with_evidence(drive, task, progress, numbers, codes, faults, nullptr);
}

sw_error* sw_batch_with_evidence(const sw_drive* drive, const sw_batch_task* task,
                                 const sw_progress* progress, double* numbers, int* codes,
                                 sw_text* faults, sw_table_evidence* tables) {
  return guarded([&] {
    const auto method = enum_value<Method>(view(task->method));
    if (!method)
      throw OptionError("method", "\"" + shown(view(task->method)) +
                                      "\" is not one of as-printed, repaired or corrected");
    const std::vector<std::string> paths = strings(task->paths, task->n_paths);
    const std::vector<std::string> outputs = strings(task->outputs, task->n_outputs);
    const BatchResult result = batch(drive->drive->gear,
                                     {.paths = paths,
                                      .values = {task->values, task->n_rows * task->n_paths},
                                      .outputs = outputs,
                                      .method = *method,
                                      .threads = task->threads},
                                     progress_of(progress));
    if (faults != nullptr) {
      std::array<sw_text, SW_ROW_CODES> messages{};
      for (const BatchFault& fault : result.faults)
        messages[static_cast<std::size_t>(fault.code)] = given(fault.message);
      std::ranges::copy(messages, faults);
    }
    std::ranges::copy(result.numbers, numbers);
    std::ranges::transform(result.codes, codes,
                           [](RowCode code) { return static_cast<int>(code); });
    if (tables != nullptr) {
      const TableEvidence stated = result.tables.value_or(TableEvidence());
      *tables = {
          .cracks = stated.cracks, .points = stated.points, .largest_error = stated.largest_error};
    }
  });
}

sw_code sw_error_code(const sw_error* error) { return error->code; }

sw_text sw_error_text(const sw_error* error, sw_error_part part) {
  const auto index = static_cast<std::size_t>(part);
  if (index >= error->texts.size()) return {.data = nullptr, .size = 0};
  return {.data = error->texts[index].data(), .size = error->texts[index].size()};
}

size_t sw_error_line(const sw_error* error) { return error->line; }

size_t sw_error_column(const sw_error* error) { return error->column; }

void sw_drive_free(sw_drive* drive) { delete drive; }

void sw_answer_free(sw_answer* answer) { delete answer; }

void sw_error_free(sw_error* error) {
  if (error != no_memory()) delete error;
}

void sw_text_free(sw_text text) { delete[] text.data; }

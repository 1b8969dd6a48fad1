// SPDX-License-Identifier: Apache-2.0 libFuzzer: a command with its options, a drive and an
// attachment are either refused by an Error, or give an answer with all its documents.  Any other
// exception, a sanitizer report, a hang or too much memory is a finding.  Run it by tools/fuzz.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/door/door.hpp"

namespace {

std::string_view take_to(std::string_view& rest, std::string_view mark) {
  const std::size_t at = rest.find(mark);
  const std::string_view taken = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + mark.size());
  return taken;
}

void run_input(std::string_view input) {
  using namespace strainwave;  // NOLINT(google-build-using-namespace): all of it is used here
  // The input is a drive alone, or a command after `=`, a line of options, a drive and its
  // attachment.
  std::string_view name = "stiffness";
  std::string_view options = "{}";
  if (input.starts_with('=')) {
    name = take_to(input, "\n").substr(1);
    options = take_to(input, "\n");
  }
  const std::string text(take_to(input, "\n=attachment\n"));
  const std::string attachment(input);
  const Command& command = command_named(commands(), name);
  OptionValues values(command.options);
  values.set_from_json(options);
  const auto drive =
      command.takes == Takes::drive || (command.takes == Takes::drive_or_nothing && !text.empty())
          ? read_drive(text, "fuzz.toml",
                       Attachments([&](std::string_view) { return std::optional(attachment); }))
          : nullptr;
  int calls = 0;  // long computations are stopped
  const Progress progress([&](double) { return ++calls < 20; });
  const Answer answer = run(command, drive, values, {{"attachment", attachment}}, progress);
  (void)answer.json();
  for (const Document& document : command.documents) (void)answer.document(document.name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    run_input({reinterpret_cast<const char*>(data), size});
  } catch (const strainwave::Error&) {
    return 0;
  } catch (const strainwave::Stopped&) {
    return 0;
  }
  return 0;
}

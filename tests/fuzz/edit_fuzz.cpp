// SPDX-License-Identifier: Apache-2.0
// libFuzzer: a text, a path and a value, each after a line of its own.  Either `edit` refuses them
// by an InputError, or the new text has the value, a second edit does not change the text, and the
// value can be removed again.  `edit` itself compares that only the path changes.  Run it by
// tools/fuzz.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/io/edit.hpp"

namespace {

std::string_view take_line(std::string_view& rest) {
  const std::string_view line = rest.substr(0, rest.find('\n'));
  rest.remove_prefix(line.size() < rest.size() ? line.size() + 1 : rest.size());
  return line;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // An unchanged example begins with a comment or its format; these values are then set and
  // removed.
  std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string path = "output_shaft.crack[+]";
  std::string value = "{ kind = \"annular\", depth = \"1 mm\" }";
  if (text.starts_with('=')) {
    path = take_line(text).substr(1);
    value = take_line(text);  // a single line
  }
  std::string edited;
  try {
    edited = strainwave::edit(text, path, value);
  } catch (const strainwave::InputError&) {
    return 0;
  }
  if (path.find("[+]") == std::string::npos) {
    if (strainwave::edit(edited, path, value) != edited) std::abort();
    try {
      (void)strainwave::edit(edited, path, std::nullopt);
    } catch (const strainwave::InputError&) {
      return 0;
    }
  }
  return 0;
}

// SPDX-License-Identifier: Apache-2.0 libFuzzer: any text is either refused by an Error or
// describes a drive that can be computed.  Any other exception, a sanitizer report, a hang or too
// much memory is a finding.  Run it by tools/fuzz.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto gear = strainwave::read_gear_set(text, "fuzz.toml");
    (void)strainwave::torsional_stiffness(gear);
  } catch (const strainwave::Error&) {
    return 0;
  }
  return 0;
}

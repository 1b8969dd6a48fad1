// SPDX-License-Identifier: Apache-2.0
// libFuzzer: a text is either refused by an InputError, or is a finite quantity of a unit, whose
// own text is read back as the same number.  Run it by tools/fuzz.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using strainwave::parse_quantity;
  static constexpr std::array<std::string_view, 7> kUnits = {"1",        "m",   "N*m",    "N*m/rad",
                                                             "Pa*m^0.5", "rad", "1/(N*m)"};
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::string_view unit : kUnits) {
    try {
      const double value = parse_quantity("field", text, unit);
      if (!std::isfinite(value)) std::abort();
      if (parse_quantity("field", strainwave::quantity_text(value, unit), unit) != value)
        std::abort();
    } catch (const strainwave::InputError&) {
      continue;
    }
  }
  try {
    (void)strainwave::parse_unit(text);
  } catch (const strainwave::InputError&) {
    return 0;
  }
  return 0;
}

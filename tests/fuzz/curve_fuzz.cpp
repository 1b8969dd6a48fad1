// SPDX-License-Identifier: Apache-2.0
// libFuzzer: any text is either refused by an InputError with its place, or is a measured curve
// whose points a calibration can use.  Run it by tools/fuzz.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "strainwave/catalogue/calibration.hpp"
#include "strainwave/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto points = strainwave::parse_measured_curve(text, "curve.csv");
    if (points.empty()) std::abort();
    for (const strainwave::MeasuredPoint& point : points)
      if (!std::isfinite(point.torque) || !(point.torque * point.twist >= 0)) std::abort();
  } catch (const strainwave::InputError& error) {
    if (!std::string_view(error.what()).starts_with("curve.csv")) std::abort();
  }
  return 0;
}

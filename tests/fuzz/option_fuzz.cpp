// SPDX-License-Identifier: Apache-2.0
// libFuzzer: the text of --vary, --unknown, --target or --factors is either refused by an
// InputError or names numbers of the drive.  Run it by tools/fuzz.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "strainwave/catalogue/factors.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/variation.hpp"
#include "strainwave/study/solve.hpp"

namespace {

constexpr std::string_view kDrive = R"(format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
[drive]
ratio = 100
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "100 N*m"
[output_shaft]
material = "steel"
outer_diameter = "70 mm"
length = "200 mm"
[[output_shaft.crack]]
kind = "annular"
depth = "1 mm"
)";

/// Runs the reader of the text; a refusal is not a finding.
template <class Read>
void read(const Read& what) {
  try {
    what();
  } catch (const strainwave::InputError&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace strainwave;  // NOLINT(google-build-using-namespace): all of it is used here
  static const GearSet kGear = read_gear_set(kDrive, "fuzz.toml");
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read([&] {
    const Variation variation = parse_variation(kGear, text);
    check_variation(variation);
    if (variation.value(0) != variation.from ||
        variation.value(variation.n_points - 1) != variation.to)
      std::abort();
    for (int i = 0; i < variation.n_points; i += 1 + variation.n_points / 100)
      if (!std::isfinite(variation.value(i))) std::abort();
  });
  read([&] { (void)parse_unknown(kGear, text); });
  read([&] { (void)parse_target(kGear, Method::corrected, text); });
  read([&] { (void)parse_factors(text); });
  return 0;
}

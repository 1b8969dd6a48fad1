// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/calibration.hpp"

namespace strainwave {
namespace {

struct CalibrateOptions {
  bool catalogue = false;
  std::optional<std::string> measured;
  std::string factors = "support,coning";

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"catalogue", "", "with K1, K2, K3 of the nearest size and ratio"},
          &CalibrateOptions::catalogue);
    field({.name = "measured",
           .unit = "",
           .doc = "with a curve: CSV with the columns torque [N*m] and twist [arcmin]",
           .names = "attachment"},
          &CalibrateOptions::measured);
    field({.name = "factors",
           .unit = "",
           .doc = "factors to fit, separated by commas",
           .fallback = "support,coning",
           .names = "factor"},
          &CalibrateOptions::factors);
  }
};

Calibration calibrated(const Request& request, const CalibrateOptions& options) {
  if (options.catalogue == options.measured.has_value())
    throw OptionError("catalogue", "or measured must be given, and only one of the two");
  const auto factors = from_option([&] { return parse_factors(options.factors); });
  const GearSet& gear = request.drive.gear;
  if (options.catalogue)
    return calibrate(gear, catalogue_target(gear), factors, {}, request.progress);
  const auto text = request.texts.find(*options.measured);
  if (text == request.texts.end()) throw OptionError("measured", "names no text that was given");
  const auto curve = parse_measured_curve(text->second, *options.measured);
  return calibrate(gear, measured_target(curve, *options.measured), factors, {}, request.progress);
}

}  // namespace

Command calibrate_command() {
  return command<CalibrateOptions, Calibration>({
      .name = "calibrate",
      .summary = "Factors of a drive from its catalogue or measured stiffness",
      .description =
          "Fits named factors of a drive, by least squares of the logarithm of stiffness, to the "
          "catalogue's K1, K2, K3 of the nearest size and ratio, or to a measured curve with the "
          "columns torque and twist. Prints each factor with its uncertainty, which combinations "
          "of them the values identify, and refuses to call one identified that is uncertain by "
          "more than half. A factor changes fields of the drive; the calibrated drive is written "
          "as a new input file.",
      .example = "strainwave calibrate examples/catalogue_size25.toml --catalogue --output "
                 "calibrated.toml",
      .function = calibrated,
      .documents = {{Format::text, calibration_text},
                    {{.name = "toml",
                      .format = Format::toml,
                      .option = "output",
                      .doc = "write the calibrated drive to this file"},
                     calibrated_drive}},
  });
}

}  // namespace strainwave

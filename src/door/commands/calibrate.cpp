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
    field({"catalogue", "", "calibrate to K1, K2, K3 of the nearest size and ratio"},
          &CalibrateOptions::catalogue);
    field(
        {.name = "measured",
         .unit = "",
         .doc =
             "calibrate to a measured curve: CSV with the columns torque [N*m] and twist [arcmin]",
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
    throw OptionError("catalogue", "give either --catalogue or --measured");
  const auto factors = from_option([&] { return parse_factors(options.factors); });
  const GearSet& gear = request.drive.gear;
  const auto fitted = [&](const CalibrationTarget& target) {
    try {
      return calibrate(gear, target, factors, {}, request.progress);
    } catch (const InputError& error) {
      if (error.field() == "factors") throw OptionError(error);
      throw;
    }
  };
  if (options.catalogue) return fitted(catalogue_target(gear));
  const auto text = request.texts.find(*options.measured);
  if (text == request.texts.end())
    throw OptionError("measured", "names a text that is not attached");
  const auto curve = parse_measured_curve(text->second, *options.measured);
  return fitted(measured_target(curve, *options.measured));
}

}  // namespace

Command calibrate_command() {
  return command<CalibrateOptions, Calibration>({
      .name = "calibrate",
      .summary = "Find factors of a drive from its catalogue or measured stiffness",
      .description =
          "Fits named factors of a drive by least squares of the logarithm of stiffness. The "
          "targets are K1, K2, K3 of the nearest size and ratio in the catalogue, or a measured "
          "curve with the columns torque and twist. Prints each factor with its uncertainty, and "
          "the combinations of factors that the targets determine. A factor whose uncertainty "
          "exceeds half of its value is not called identified. A factor changes fields of the "
          "drive; --output writes the calibrated drive as a new input file, which keeps the "
          "comments of the given file. Ranges and scatters of the changed numbers are left out.",
      .example = "strainwave calibrate examples/catalogue_size25.toml --catalogue --output "
                 "calibrated.toml",
      .function = calibrated,
      .documents = {{Format::text, calibration_text},
                    {{.name = "toml",
                      .format = Format::toml,
                      .option = "output",
                      .doc = "write the calibrated drive to this file"},
                     [](const Calibration& calibration, const Rendering& to) {
                       return calibrated_drive(calibration, to.drive.gear, to.drive.text);
                     }}},
  });
}

}  // namespace strainwave

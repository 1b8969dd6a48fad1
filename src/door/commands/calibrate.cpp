// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/calibration.hpp"

namespace strainwave {
namespace {

struct CalibrateOptions {
  bool catalogue = false;
  std::optional<std::string> measured;
  std::string factors = "support,coning";
  std::optional<std::string> predict_ratios;
  std::optional<Blank> blank;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"catalogue", "",
           "calibrate to K1, K2, K3 of the catalogue's row for this form, length, ratio and the "
           "nearest "
           "size"},
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
    field({"predict_ratios", "",
           "also predict K1, K2, K3 at these ratios of the size, such as 50,80,100, or all for "
           "the other ratios of the tables, with the error"},
          &CalibrateOptions::predict_ratios);
    field({.name = "blank",
           .unit = "",
           .doc = "with --predict-ratios, walls of the drives of other ratios: made for the wave "
                  "of each ratio, or of ratio 100 for all ratios of a size",
           .fallback = "ratio"},
          &CalibrateOptions::blank);
  }
};

Calibration calibrated(const Request& request, const CalibrateOptions& options) {
  if (options.catalogue == options.measured.has_value())
    throw OptionError("catalogue", "give either --catalogue or --measured");
  if (options.blank && !options.predict_ratios)
    throw OptionError("blank", "needs --predict-ratios; give it too");
  const auto factors = from_option([&] { return parse_factors(options.factors); });
  const GearSet& gear = request.drive.gear;
  std::optional<std::vector<double>> ratios;
  if (options.predict_ratios)
    ratios = from_option([&] { return parse_ratios(*options.predict_ratios); });
  const auto fitted = [&](const CalibrationTarget& target) {
    const double fit_ends = ratios ? 0.1 : 1.0;
    try {
      Calibration calibration =
          calibrate(gear, target, factors, {}, request.progress.part(0.0, fit_ends));
      if (ratios)
        calibration.other_ratios =
            predict_other_ratios(calibration, *ratios, options.blank.value_or(Blank::ratio), {},
                                 request.progress.part(fit_ends, 1.0));
      return calibration;
    } catch (const InputError& error) {
      if (error.field() == "factors" || error.field() == "predict-ratios") throw OptionError(error);
      throw;
    }
  };
  if (options.catalogue) return fitted(from_option([&] { return catalogue_target(gear); }));
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
          "comments of the given file. Ranges and scatters of the changed numbers are left out. "
          "--predict-ratios predicts K1, K2, K3 at other ratios of the size by typical drives with "
          "the fitted factors, and states the error of each value and of such predictions over "
          "the catalogue.",
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

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/calibration.hpp"
#include "strainwave/study/drive_joint.hpp"

namespace strainwave {
namespace {

struct CalibrateOptions {
  bool catalogue = false;
  std::optional<std::string> measured;
  std::string factors = "support,coning";
  std::optional<std::string> predict_ratios;
  std::optional<Blank> blank;
  bool friction = false;
  std::optional<std::string> no_load_torque;
  std::optional<std::string> starting_torque;
  std::optional<std::string> back_driving_torque;
  std::optional<std::string> efficiency;
  std::optional<std::string> at_speed;
  std::optional<std::string> at_torque;

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
    field({"friction", "",
           "fit drivetrain.friction to a maker's four values, those below or, with --catalogue, of "
           "the row of this size and ratio; in place of factors"},
          &CalibrateOptions::friction);
    field({"no_load_torque", "",
           "with --friction, torque that turns the input at --at-speed without load, a number with "
           "its unit"},
          &CalibrateOptions::no_load_torque);
    field({"starting_torque", "",
           "with --friction, torque that starts the input without load, a number with its unit"},
          &CalibrateOptions::starting_torque);
    field({"back_driving_torque", "",
           "with --friction, torque on the output that starts the free input, a number with its "
           "unit"},
          &CalibrateOptions::back_driving_torque);
    field({"efficiency", "",
           "with --friction, efficiency at --at-torque and --at-speed, such as 0.77 or 77 %"},
          &CalibrateOptions::efficiency);
    field({"at_speed", "",
           "with --friction, speed of the input for no-load torque and efficiency, a number with "
           "its unit; 2000 rpm if left out"},
          &CalibrateOptions::at_speed);
    field({"at_torque", "",
           "with --friction, torque on the output for the efficiency, a number with its unit; "
           "rating.rated_torque if left out"},
          &CalibrateOptions::at_torque);
  }
};

/// The four values of the options.
FrictionTargets given_targets(const GearSet& gear, const CalibrateOptions& options) {
  const auto read = [](const char* name, const std::optional<std::string>& text,
                       std::string_view unit) {
    if (!text)
      throw OptionError(name, "must be given for --friction; give all four values, or --catalogue");
    return option_quantity(name, *text, unit);
  };
  FrictionTargets targets{
      .no_load_torque = read("no-load-torque", options.no_load_torque, "N*m"),
      .starting_torque = read("starting-torque", options.starting_torque, "N*m"),
      .back_driving_torque = read("back-driving-torque", options.back_driving_torque, "N*m"),
      .efficiency = read("efficiency", options.efficiency, "1"),
      .speed = read("at-speed", options.at_speed.value_or("2000 rpm"), "rad/s")};
  if (options.at_torque)
    targets.torque = read("at-torque", options.at_torque, "N*m");
  else if (gear.rating && gear.rating->rated_torque)
    targets.torque = *gear.rating->rated_torque;
  else
    throw OptionError("at-torque",
                      "must be given, because the file has no rating.rated_torque at which the "
                      "efficiency holds");
  return targets;
}

Calibration calibrated_friction(const Request& request, const CalibrateOptions& options) {
  const GearSet& gear = request.drive.gear;
  if (options.measured || options.predict_ratios)
    throw OptionError("friction", "fits no stiffness; leave out --measured and --predict-ratios");
  const bool given = options.no_load_torque || options.starting_torque ||
                     options.back_driving_torque || options.efficiency || options.at_speed ||
                     options.at_torque;
  if (options.catalogue && given)
    throw OptionError("friction",
                      "takes its values from --catalogue or from the other options; give one of "
                      "the two");
  const FrictionTargets targets = options.catalogue
                                      ? from_option([&] { return friction_targets(gear); })
                                      : given_targets(gear, options);
  // The values are those of a sound drive, and the computed curve contains the cracks.
  const DriveJoint made =
      drive_joint(gear, request.progress.part(0.0, 0.3), RestoringTorque::lines);
  return from_option([&] {
    return calibrate_friction(
        gear, made.joint, targets,
        options.catalogue ? "the catalogue's four values" : "four given values",
        request.progress.part(0.3, 1.0));
  });
}

Calibration calibrated(const Request& request, const CalibrateOptions& options) {
  if (options.friction) return calibrated_friction(request, options);
  if (options.no_load_torque || options.starting_torque || options.back_driving_torque ||
      options.efficiency || options.at_speed || options.at_torque)
    throw OptionError("friction", "must be given with the values of friction; give --friction");
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
          "the catalogue. --friction fits the friction of the input to a maker's no-load torque, "
          "starting torque, back-driving torque and efficiency, measures all four on the fitted "
          "drive by simulation, and prints [drivetrain.friction].",
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

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/backbone.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct BackboneOptions {
  std::vector<std::string> excitation;
  std::optional<std::string> amplitude;
  std::optional<std::string> load_torque;
  JointEnd at = JointEnd::load;
  VibratingInput input = VibratingInput::free;
  int harmonics = 9;
  int points = 40;
  std::optional<std::string> from;
  std::optional<std::string> to;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"excitation", "",
           "amplitude of the torque that shakes the drive, a number with its unit, once for each "
           "response; a twentieth and a fifth of the load's torque if left out, over the ratio at "
           "the "
           "motor"},
          &BackboneOptions::excitation);
    field({"amplitude", "",
           "largest half range of the twist of the backbone, a number with its unit; the twist "
           "under the load's torque if left out"},
          &BackboneOptions::amplitude);
    field({"load_torque", "",
           "constant torque on the output about which the drive vibrates, a number with its unit; "
           "that of the load if left out"},
          &BackboneOptions::load_torque);
    field({.name = "at", .unit = "", .doc = "end that is shaken", .fallback = "load"},
          &BackboneOptions::at);
    field({.name = "input",
           .unit = "",
           .doc = "free: the motor gives its torque; locked: the motor keeps its speed",
           .fallback = "free"},
          &BackboneOptions::input);
    field({.name = "harmonics",
           .unit = "",
           .doc = "harmonics of the twist",
           .range = {.lower = 1, .lower_open = false, .upper = 200, .upper_open = false},
           .fallback = "9"},
          &BackboneOptions::harmonics);
    field({.name = "points",
           .unit = "",
           .doc = "amplitudes of the backbone",
           .range = {.lower = 2, .lower_open = false, .upper = 10000, .upper_open = false},
           .fallback = "40"},
          &BackboneOptions::points);
    field({"from", "",
           "frequency at which the responses begin, a number with its unit; half of the lowest "
           "resonance if left out"},
          &BackboneOptions::from);
    field({"to", "",
           "frequency at which the responses end, a number with its unit; one and a half of the "
           "highest resonance if left out"},
          &BackboneOptions::to);
  }
};

BackboneReport backbone_of(const Request& request, const BackboneOptions& options) {
  BackboneReportSettings settings{.input = options.input,
                                  .at = options.at,
                                  .harmonics = options.harmonics,
                                  .points = options.points};
  const auto read = [](const char* name, const std::optional<std::string>& text, const char* unit,
                       std::optional<double>& value) {
    if (text) value = option_quantity(name, *text, unit);
  };
  read("--amplitude", options.amplitude, "rad", settings.amplitude);
  read("--load-torque", options.load_torque, "N*m", settings.load_torque);
  read("--from", options.from, "Hz", settings.from);
  read("--to", options.to, "Hz", settings.to);
  for (const std::string& text : options.excitation)
    settings.excitations.push_back(option_quantity("--excitation", text, "N*m"));
  return backbone_report(request.drive.gear, settings, request.progress);
}

}  // namespace

Command backbone_command() {
  return command<BackboneOptions, BackboneReport>({
      .name = "backbone",
      .summary = "Compute resonance and response over the amplitude, sound and cracked",
      .description =
          "Prints how the resonance between the motor and the load of a drive's [drivetrain] "
          "depends on the amplitude, with its equivalent damping, and how the drive answers to a "
          "torque that shakes it, once sound and once with its cracks. The drive vibrates about a "
          "constant load torque, without turning on average. Corners of the torsion curve, "
          "hysteresis, damping and cracks that open with the sense of the torque are contained; "
          "the kinematic error, gravity and the friction of the input are left out. Responses "
          "are followed through their folds, and each point is tested for stability.",
      .example = "strainwave backbone examples/joint_size25.toml --excitation '2 N*m' --excitation "
                 "'10 N*m'",
      .takes = Takes::drive,
      .function = backbone_of,
      .documents = {{Format::text, backbone_text},
                    {Format::csv, backbone_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw backbones and responses over the frequency as an SVG file"},
                     backbone_plot}},
  });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "strainwave/door/door.hpp"
#include "strainwave/io/attachments.hpp"
#include "support/program.hpp"

namespace strainwave::test {

/// The drives of the examples, by their names without ".toml".
inline const std::map<std::string, std::shared_ptr<const Drive>>& example_drives() {
  static const auto drives = [] {
    std::map<std::string, std::shared_ptr<const Drive>> read;
    for (const auto& entry : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES))
      if (entry.path().extension() == ".toml")
        read[entry.path().stem().string()] =
            read_drive(contents(entry.path()), entry.path().filename().string(),
                       attachments_beside(entry.path()));
    return read;
  }();
  return drives;
}

inline Answer run_command(std::string_view command, std::shared_ptr<const Drive> drive,
                          std::string_view options = "{}", const OptionTexts& texts = {},
                          const Progress& progress = {}) {
  const Command& row = command_named(commands(), command);
  OptionValues values(row.options);
  values.set_from_json(options);
  return run(row, std::move(drive), values, texts, progress);
}

inline Answer run_on_example(std::string_view command, const std::string& example,
                             std::string_view options = "{}") {
  return run_command(command, example_drives().at(example), options);
}

/// Options, as JSON, that show each part of a command's result at little cost.
inline const std::multimap<std::string_view, std::string_view>& trial_options() {
  static const std::multimap<std::string_view, std::string_view> options = {
      {"stiffness", "{}"},
      {"stiffness", R"({"method": "repaired"})"},
      {"stiffness", R"({"method": "as-printed"})"},
      {"torsion", R"({"draws": 2})"},
      {"torsion", R"({"compare": true, "angles": 2, "draws": 0})"},
      {"duty", "{}"},
      {"duty", R"({"classes": 4})"},
      {"duty", R"({"rainflow": "joint_history.csv", "column": "torque"})"},
      {"duty", R"({"rainflow": "joint_history.csv", "column": "torque", "classes": 8})"},
      {"life", "{}"},
      {"grow", "{}"},
      {"grow", R"({"interaction": "wheeler", "zone_factor": 2, "wheeler_exponent": 1.5})"},
      {"oval", R"({"torque": ["10 N*m", "0 N*m"]})"},
      {"oval", R"({"nonlinear": "off"})"},
      {"turn", R"({"torque": ["10 N*m"], "angles": 8})"},
      {"turn", R"({"torque": ["-5 N*m", "10 N*m"], "half_length": ["1 mm", "2 mm"], "angles": 8})"},
      {"transmission", R"({"draws": 0})"},
      {"transmission", R"({"spline_teeth": "spline_teeth.csv"})"},
      {"modes", "{}"},
      {"modes", R"({"growth": true})"},
      {"modes", R"({"torque": "20 N*m"})"},
      {"frf", R"({"torque": "20 N*m", "from": "1 Hz", "to": "100 Hz", "points": 30})"},
      {"accuracy",
       R"({"torque": "20 N*m", "speed": "700 rpm", "tool_radius": "0.7 m", "draws": 3})"},
      {"simulate", R"({"step": "10 ms", "tolerance": "1e-8 rad"})"},
      {"simulate", R"({"step": "50 ms", "growth": "100 h"})"},
      {"backbone", R"({"points": 3, "harmonics": 5})"},
      {"backbone", R"({"excitation": ["5 N*m"], "amplitude": "10 arcmin", "load_torque": "0 N*m",
                       "at": "load", "input": "locked", "points": 3, "from": "15 Hz",
                       "to": "40 Hz"})"},
      {"require", R"({"requirements": ["intact.stiffness > 1 N*m/rad",
                                        "cracked.positive.stiffness_change >= 1 %"]})"},
      {"report", R"({"date": "2026-01-31"})"},
      {"sensitivity", "{}"},
      {"sensitivity", R"({"scatter": true, "samples": 200, "threads": 1})"},
      {"sweep", R"({"vary": ["load.torque=1 N*m..20 N*m:3", "drive.ratio=80..120:2"]})"},
      {"solve", R"({"vary": "output_shaft.length=150 mm..250 mm",
                    "target": "intact.stiffness=2e4 N*m/rad"})"},
      {"sif list", "{}"},
      {"sif show", R"({"name": "plate-surface"})"},
      {"sif eval",
       R"({"name": "plate-surface", "set": ["tension=200 MPa"], "material": "42CrMo4 QT to 16 mm"})"},
      {"sif plot", R"({"name": "plate-surface"})"},
      {"material list", "{}"},
      {"material show", R"({"name": "17-4PH H900"})"},
      {"catalogue", R"({"size": 25, "ratio": 100})"},
      {"validate", "{}"},
      {"calibrate", R"({"catalogue": true})"},
      {"audit", "{}"},
      {"new", "{}"},
      {"new", R"({"size": 25, "ratio": 100})"},
      {"schema", "{}"},
      {"schema", R"({"of": "options", "command": "sif eval"})"},
      {"schema", R"({"of": "result", "command": "torsion"})"},
      {"explain", R"({"word": "half_length"})"},
      {"units", "{}"},
      {"diff", R"({"first": "article.toml", "second": "through_crack.toml"})"}};
  return options;
}

/// The texts that they name.
inline OptionTexts trial_texts() {
  OptionTexts texts;
  for (const char* const name :
       {"article.toml", "through_crack.toml", "joint_history.csv", "spline_teeth.csv"})
    texts[name] = contents(std::filesystem::path(STRAINWAVE_EXAMPLES) / name);
  return texts;
}

}  // namespace strainwave::test

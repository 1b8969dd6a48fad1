// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/transmission.hpp"

#include <fmt/format.h>

#include <array>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"

namespace strainwave {
namespace {

struct TransmissionCommandOptions {
  std::optional<std::string> torque;
  std::optional<std::string> flexspline_teeth;
  std::optional<std::string> spline_teeth;
  int draws = 20;
  std::uint64_t seed = 1;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TransmissionCommandOptions;
    field({"torque", "",
           "torque at the output, a number with its unit; that of the load if left out"},
          &O::torque);
    field({.name = "flexspline_teeth",
           .unit = "",
           .doc = "measured teeth of the flexspline: CSV with a row for each tooth and the columns "
                  "position and thickness, deviations with their units; one column is enough",
           .names = "history"},
          &O::flexspline_teeth);
    field({.name = "spline_teeth",
           .unit = "",
           .doc = "measured teeth of the circular spline, likewise",
           .names = "history"},
          &O::spline_teeth);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives whose teeth are drawn from their tolerances, without measured "
                  "teeth; 0 for teeth without deviations",
           .range = {.lower = 0, .lower_open = false, .upper = 10000, .upper_open = false},
           .fallback = "20"},
          &O::draws);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws and of the random positions",
           .fallback = "1"},
          &O::seed);
  }
};

/// The teeth of a part from a table with a row for each tooth.
std::vector<ToothDeviation> teeth_of(const Request& request, std::string_view option,
                                     const std::string& name, int teeth) {
  HistoryFile file(request.pieces(option, name), name == "-" ? "standard input" : name);
  std::vector<std::size_t> wanted;
  std::vector<double> factors;
  std::vector<double ToothDeviation::*> members;
  for (const auto& [column, member] : {std::pair{"position", &ToothDeviation::position},
                                       std::pair{"thickness", &ToothDeviation::thickness}}) {
    if (!file.has(column)) continue;
    wanted.push_back(file.number_of(column));
    factors.push_back(file.factor_to("m", wanted.back()));
    members.push_back(member);
  }
  if (wanted.empty())
    throw InputError(TextPlace{.file = file.name()},
                     "has neither a column position nor a column thickness; name one of them, such "
                     "as position [um]");
  std::vector<ToothDeviation> read;
  for (;;) {
    const std::vector<std::vector<double>>& block = file.read(wanted);
    if (block.front().empty()) break;
    for (std::size_t row = 0; row < block.front().size(); ++row) {
      ToothDeviation& tooth = read.emplace_back();
      for (std::size_t c = 0; c < wanted.size(); ++c)
        tooth.*members[c] = factors[c] * block[c][row];
    }
  }
  if (read.size() != static_cast<std::size_t>(teeth))
    throw InputError(TextPlace{.file = file.name()},
                     fmt::format("has {} rows, but the part has {} teeth; give one row for each "
                                 "tooth",
                                 read.size(), teeth));
  return read;
}

TransmissionReport transmission_of(const Request& request,
                                   const TransmissionCommandOptions& options) {
  const GearSet& gear = request.drive.gear;
  TransmissionOptions made{.draws = options.draws, .seed = options.seed};
  if (options.torque) made.torque = parse_quantity("--torque", *options.torque, "N*m");
  if (options.flexspline_teeth || options.spline_teeth) {
    const int teeth = flexspline_teeth(gear.drive);
    made.measured.emplace();
    if (options.flexspline_teeth)
      made.measured->flexspline =
          teeth_of(request, "flexspline_teeth", *options.flexspline_teeth, teeth);
    if (options.spline_teeth)
      made.measured->spline = teeth_of(request, "spline_teeth", *options.spline_teeth, teeth + 2);
  }
  return transmission_report(gear, made, request.progress);
}

}  // namespace

Command transmission_command() {
  return command<TransmissionCommandOptions, TransmissionReport>({
      .name = "transmission",
      .summary = "Compute the kinematic error by deviations of the teeth and by cracks",
      .description =
          "Prints the kinematic error of a drive under a torque: its range from peak to valley, "
          "and its lines over the angle of the input, sound and with the cracks of the file. The "
          "coupled drive is solved at each tooth. The teeth deviate as measured, or as drawn "
          "from the tolerances of the file. The largest lines are printed as [[kinematic_error]] "
          "for the file, where frf, simulate and accuracy read them.",
      .example = "strainwave transmission examples/cracked_size25.toml",
      .takes = Takes::drive,
      .function = transmission_of,
      .documents = {{Format::text, transmission_text},
                    {Format::csv, transmission_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the error over a turn of the wave as an SVG file"},
                     transmission_plot}},
  });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <string>
#include <utility>

#include "numbers_beside.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/sha256.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/motion_record.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "tooth_file.hpp"

namespace strainwave {
namespace {

struct SimulateOptions : ToothFiles {
  std::optional<std::string> step;
  std::string tolerance = "1e-9 rad";
  MotionEngine engine = MotionEngine::explicit_steps;
  std::optional<std::string> growth;
  std::optional<std::uint64_t> drawn_teeth;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"step", "",
           "time between two rows, a number with its unit; a thousandth of the motion if left out"},
          &SimulateOptions::step);
    field({.name = "tolerance",
           .unit = "",
           .doc = "error of the output's angle that one time step may add, a number with its unit",
           .fallback = "1e-9 rad"},
          &SimulateOptions::tolerance);
    field({.name = "engine",
           .unit = "",
           .doc = "what takes the steps: explicit, or stiff for very stiff friction and springs, "
                  "if the program was built with it",
           .fallback = "explicit"},
          &SimulateOptions::engine);
    field({"growth", "",
           "time of the [duty] of the file that passes evenly during the motion while the cracks "
           "grow as strainwave grow computes them, a number with its unit such as '100 h'; a time "
           "lapse unless the motion takes as long"},
          &SimulateOptions::growth);
    ToothFiles::describe<SimulateOptions>(field);
    field({"drawn_teeth", "",
           "draw the deviations of the teeth from the tolerances of the file by this seed, in "
           "place of measured teeth; both need the computed curve"},
          &SimulateOptions::drawn_teeth);
  }
};

constexpr std::string_view kRunFormat = "strainwave-motion-run/1";

RecordForm form_of(const std::string& name) {
  if (name.ends_with(".csv")) return RecordForm::csv;
  if (name.ends_with(".bin")) return RecordForm::binary;
  throw OptionError("--record", fmt::format("{} must end in .csv or .bin, which chooses the form "
                                            "of the record; name another file",
                                            shown(name)));
}

/// The teeth of a motion; absent: none deviates.
std::optional<Deviations> teeth_of_motion(const Request& request, const SimulateOptions& options) {
  const GearSet& gear = request.drive.gear;
  if (!options.drawn_teeth && !options.flexspline_teeth && !options.spline_teeth)
    return std::nullopt;
  if (!gear.drivetrain || gear.drivetrain->spring != RestoringTorque::computed)
    throw OptionError(options.drawn_teeth        ? "--drawn-teeth"
                      : options.flexspline_teeth ? "--flexspline-teeth"
                                                 : "--spline-teeth",
                      "needs the computed curve; leave it out, or give drivetrain.spring = "
                      "\"computed\"");
  require_inputs_of_curve(gear);
  if (std::optional<Deviations> measured = measured_teeth(request, options)) {
    if (options.drawn_teeth)
      throw OptionError("--drawn-teeth", "stands in place of measured teeth; give one of the two");
    return paired(*std::move(measured), gear);
  }
  return draw_deviations(gear, *options.drawn_teeth, 0);
}

/// All numbers of the teeth as text.
std::string teeth_text(const std::optional<Deviations>& teeth) {
  if (!teeth) return {};
  std::string text = fmt::format("\n{:a} {:a} {:a}", teeth->pairing_gap, teeth->eccentricity,
                                 teeth->eccentricity_angle);
  for (const auto* const part : {&teeth->flexspline, &teeth->spline})
    for (const ToothDeviation& tooth : *part)
      text += fmt::format(" {:a} {:a}", tooth.position, tooth.thickness);
  return text;
}

/// The checkpoint of a record as text: the program and all that the rows depend on, the bytes of
/// the record, the state of the motion, and a digest of these lines.
class RecordCheckpoint {
 public:
  RecordCheckpoint(const Request& request, const SimulateOptions& options, const std::string& teeth,
                   RecordForm form)
      : name_(request.recording->name()),
        head_(fmt::format("{} {} {} {}", kRunFormat, version(), git_revision(),
                          sha256_hex(fmt::format("{}\n{}\n{}\n{}\n{}\n{}", enum_name(form),
                                                 options.step.value_or(""), options.tolerance,
                                                 options.growth.value_or(""), request.drive.text,
                                                 numbers_beside(request.drive.gear) + teeth)))) {}

  /// @param state  empty: the motion is to begin
  [[nodiscard]] std::string text(std::uint64_t size, const std::string& state) const {
    const std::string lines = fmt::format("{}\n{}\n{}\n", head_, size, state);
    return lines + sha256_hex(lines) + '\n';
  }

  /// The bytes of the record and the state of the motion.
  /// @throws OptionError  if the text is not that of a checkpoint of this run
  [[nodiscard]] std::pair<std::uint64_t, std::string> read(std::string_view text) const {
    if (!text.starts_with(kRunFormat))
      refuse("is not one of strainwave simulate; name another file");
    const std::string_view rest = text;
    const auto line = [&text] {
      const std::size_t end = text.find('\n');
      const std::string_view made = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      return made;
    };
    const std::string_view head = line();
    const std::string_view bytes = line();
    const std::string_view state = line();
    const std::string_view lines = rest.substr(0, rest.size() - text.size());
    std::uint64_t size = 0;
    const auto [end, fault] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), size);
    if (text != sha256_hex(lines) + '\n' || fault != std::errc{} ||
        end != bytes.data() + bytes.size())
      refuse("is damaged; remove both files to begin again");
    if (head != head_)
      refuse(
          "is that of another drive, of other options or of another version; name another file "
          "or remove both");
    return {size, std::string(state)};
  }

 private:
  [[noreturn]] void refuse(std::string_view why) const {
    throw OptionError("--resume", fmt::format("the checkpoint of {} {}", shown(name_), why));
  }

  std::string name_;
  std::string head_;
};

/// A motion whose rows go into a record.
SimulationReport recorded(const Request& request, const SimulateOptions& options,
                          const std::string& teeth, const SimulationSettings& settings) {
  Recording& recording = *request.recording;
  const RecordForm form = form_of(recording.name());
  const RecordCheckpoint checkpoint(request, options, teeth, form);
  SimulationRecord record;
  std::uint64_t size = 0;
  if (const std::optional<std::string> found = recording.checkpoint()) {
    const auto [bytes, state] = checkpoint.read(*found);
    size = bytes;
    if (!state.empty()) record.from = read_simulation_checkpoint(state);
  }
  RecordColumns columns;
  record.begin = [&](bool with_cracks) {
    columns = {.cracked = with_cracks,
               .output_given = request.drive.gear.manoeuvre.front().output_speed.has_value()};
    if (record.from) return recording.go_on(size);
    recording.begin(checkpoint.text(0, {}));
    const Provenance from = provenance_of(request.drive);
    RecordOrigin origin{.version = from.version,
                        .revision = from.revision,
                        .input_file = from.input_file,
                        .input_sha256 = sha256_hex(request.drive.text),
                        .options = {{"tolerance", options.tolerance}}};
    if (options.step) origin.options.emplace_back("step", *options.step);
    if (options.growth) origin.options.emplace_back("growth", *options.growth);
    if (options.flexspline_teeth)
      origin.options.emplace_back("flexspline-teeth", *options.flexspline_teeth);
    if (options.spline_teeth) origin.options.emplace_back("spline-teeth", *options.spline_teeth);
    if (options.drawn_teeth)
      origin.options.emplace_back("drawn-teeth", fmt::format("{}", *options.drawn_teeth));
    recording.append(record_head(form, origin, columns));
  };
  std::string bytes;
  record.write = [&](const SimulationRow& row) {
    bytes.clear();
    add_record_row(bytes, form, row, columns);
    recording.append(bytes);
  };
  record.due = [&] { return recording.due(); };
  record.keep = [&](const SimulationCheckpoint& state) {
    recording.keep(checkpoint.text(recording.size(), checkpoint_text(state)));
  };
  return simulation_report(request.drive.gear, settings, request.progress, &record);
}

constexpr std::string_view kCurveFormat = "strainwave-curve-table/1";

/// The text of a kept curve: the program, a digest of the drive, the samples, and a digest of these
/// lines (MO-27).
class CurveKeeper {
 public:
  CurveKeeper(const Request& request, const std::string& teeth)
      : kept_(*request.kept), program_(fmt::format("{} {}", version(), git_revision())) {
    const GearSet drive = what_the_curve_depends_on(request.drive.gear);
    drive_ = sha256_hex(json_of(drive) + '\n' + numbers_beside(drive) + teeth);
  }

  /// The curve of the text, or one that `made_anew` computes, whose text is then kept.
  [[nodiscard]] ComputedCurve curve(const CurveSource& made_anew, const GearSet& gear,
                                    const Progress& progress) const {
    if (const std::optional<std::string> found = kept_.text()) return read(*found);
    ComputedCurve made = made_anew(gear, progress);
    const std::string lines =
        fmt::format("{}\n{}\n{}\n{}\n", kCurveFormat, program_, drive_, curve_text(made.samples));
    kept_.keep(lines + sha256_hex(lines) + '\n');
    return made;
  }

 private:
  [[nodiscard]] ComputedCurve read(std::string_view text) const {
    const std::string_view whole = text;
    const auto line = [&text] {
      const std::size_t end = text.find('\n');
      const std::string_view made = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      return made;
    };
    if (line() != kCurveFormat)
      refuse("is not a curve table of this version of strainwave simulate; name another file");
    const std::string_view program = line();
    const std::string_view drive = line();
    const std::string_view samples = line();
    const std::string_view lines = whole.substr(0, whole.size() - text.size());
    if (text != sha256_hex(lines) + '\n')
      refuse("is damaged; remove the file to compute the table again");
    if (program != program_)
      refuse(
          "was made by another version of the program; remove the file to compute the table again");
    if (drive != drive_)
      refuse(
          "belongs to another drive, or to this drive before it was edited; name another file, or "
          "remove this one to compute the table again");
    return read_curve(samples);
  }
  [[noreturn]] void refuse(std::string_view why) const {
    throw OptionError("--curve-table", fmt::format("{} {}", shown(kept_.name()), why));
  }

  KeptText& kept_;
  std::string program_;
  std::string drive_;
};

SimulationReport simulation_of(const Request& request, const SimulateOptions& options) {
  SimulationSettings settings;
  settings.engine = options.engine;
  settings.tolerance = option_quantity("--tolerance", options.tolerance, "rad");
  if (options.step) {
    settings.output_step = option_quantity("--step", *options.step, "s");
    require(settings.output_step > 0, "--step", settings.output_step, "s", "> 0");
  }
  const auto& train = request.drive.gear.drivetrain;
  const bool computed = train && train->spring == RestoringTorque::computed;
  const std::optional<Deviations> teeth = teeth_of_motion(request, options);
  if (teeth) {
    settings.curve = [teeth](const GearSet& gear, const Progress& progress) {
      return computed_curve_of_teeth(gear, *teeth, progress);
    };
  }
  if (request.kept != nullptr) {
    if (!computed)
      throw OptionError("--curve-table",
                        "keeps the table of a computed curve, and the spring of this drive has "
                        "none; leave it out, or give drivetrain.spring = \"computed\"");
    const auto keeper = std::make_shared<const CurveKeeper>(request, teeth_text(teeth));
    settings.curve = [keeper, anew = settings.curve](const GearSet& gear,
                                                     const Progress& progress) {
      return keeper->curve(anew, gear, progress);
    };
  }
  if (options.growth) settings.growth = option_quantity("--growth", *options.growth, "s");
  return request.recording != nullptr
             ? recorded(request, options, teeth_text(teeth), settings)
             : simulation_report(request.drive.gear, settings, request.progress);
}

}  // namespace

Command simulate_command() {
  return command<SimulateOptions, SimulationReport>({
      .name = "simulate",
      .summary = "Compute the motion of a drive between motor and load, sound and cracked",
      .description =
          "Moves the drive of a file through its [[manoeuvre]] pieces, between the motor and the "
          "load of its [drivetrain], once sound and once with its cracks. The drive is a spring "
          "with the maker's three lines of its torsion curve, or the sum of its members, with "
          "[[kinematic_error]], hysteresis and friction as given. Cracks open with the sense of "
          "the torque, and keep their sizes without --growth. Prints the largest torques and "
          "errors with the balance of energy; --format csv prints the motion over time. --record "
          "writes the rows of a long motion while it is computed; a run that was interrupted goes "
          "on from its last checkpoint, to the same "
          "digits. --curve-table keeps the table of a computed curve between runs.",
      .example = "strainwave simulate examples/joint_size25.toml",
      .record = "write the rows to this file while they are computed, as CSV (.csv) or in the "
                "compact binary form (.bin); the answer then has none",
      .kept_option = "curve-table",
      .kept =
          "read the table of the computed curve from this file, or compute it and write it there "
          "for later runs",
      .takes = Takes::drive,
      .function = simulation_of,
      .documents = {{Format::text, simulation_text},
                    {Format::csv, simulation_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw torque and error of the output over time as an SVG file"},
                     simulation_plot}},
  });
}

}  // namespace strainwave

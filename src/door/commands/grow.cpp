// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <optional>
#include <string>

#include "growth_rule_options.hpp"
#include "numbers_beside.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/sha256.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/layouts/growth.hpp"

namespace strainwave {
namespace {

struct GrowOptions : GrowthRuleOptions {
  std::string until = "event";
  int points = 60;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "until",
           .unit = "",
           .doc = "end of the computation: a time such as \"20000 h\", \"1e6 cycles\", a size such "
                  "as \"output_shaft.crack[0].depth=5 mm\", or \"event\" for the first crack that "
                  "ends the life",
           .fallback = "event"},
          &GrowOptions::until);
    GrowthRuleOptions::describe(field);
    field({.name = "points",
           .unit = "",
           .doc = "largest number of rows of a series",
           .range = {.lower = 2, .lower_open = false, .upper = 100000, .upper_open = false},
           .fallback = "60"},
          &GrowOptions::points);
  }
};

constexpr std::string_view kCheckpointFormat = "strainwave-growth/2";

/// First line of a checkpoint: the program and all that the result depends on.
std::string checkpoint_head(const Request& request, const GrowOptions& o) {
  const std::string asked = fmt::format(
      "{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", o.until, o.law.value_or(""),
      enum_name(o.mixed_mode), enum_name(o.interaction), o.zone_factor.value_or(0),
      o.wheeler_exponent.value_or(-1), o.constraint.value_or(-1), o.stress_level.value_or(-1),
      request.drive.text, numbers_beside(request.drive.gear));
  return fmt::format("{} {} {}", kCheckpointFormat, version(), sha256_hex(asked));
}

/// The steps of a run before, from its checkpoint.
GrowthCheckpoint checkpoint_of(const Request& request, const GrowOptions& o) {
  Journal* const journal = request.journal;
  if (journal == nullptr) return {};
  const std::string head = checkpoint_head(request, o);
  const auto append = [journal](const std::string& line) { journal->append(line); };
  const std::optional<std::string> text = journal->text();
  if (!text || text->empty()) {
    journal->begin(head + "\n");
    return {"", append};
  }
  const std::size_t end = text->find('\n');
  const std::string found = text->substr(0, end);
  if (!found.starts_with(kCheckpointFormat) || end == std::string::npos)
    throw OptionError("--resume", fmt::format("{} is not a checkpoint of strainwave grow; name "
                                              "another file",
                                              journal->name()));
  if (found != head)
    throw OptionError("--resume",
                      fmt::format("{} is a checkpoint of another drive, of other options or of "
                                  "another version; name another file or remove it",
                                  journal->name()));
  const std::string steps = text->substr(end + 1);
  // A line that was cut off must not stand before the next one.
  const std::size_t whole = steps.rfind('\n');
  const std::string kept = whole == std::string::npos ? "" : steps.substr(0, whole + 1);
  if (kept.size() != steps.size()) journal->begin(head + "\n" + kept);
  return from_option([&] { return GrowthCheckpoint(kept, append); });
}

/// Reads --until.
GrowthStop stop_of(const GearSet& gear, const std::string& until) {
  GrowthStop stop;
  if (until == "event") return stop;
  constexpr std::string_view kCycles = "cycles";
  if (until.ends_with(kCycles)) {
    stop.cycles = option_quantity("--until", until.substr(0, until.size() - kCycles.size()), "1");
    require(*stop.cycles > 0, "--until", *stop.cycles, "1", "> 0");
    return stop;
  }
  if (const auto equal = until.find('='); equal != std::string::npos) {
    const std::string path = until.substr(0, equal);
    const std::size_t dot = path.rfind('.');
    stop.crack = path.substr(0, dot == std::string::npos ? 0 : dot);
    for (const DriveCrack& crack : drive_cracks(gear))
      if (crack.path == stop.crack && crack.path + "." + crack.size_name == path) {
        stop.size = option_quantity("--until", until.substr(equal + 1), "m");
        require(stop.size > crack.size.size, "--until", stop.size, "m",
                "larger than the size in the file");
        return stop;
      }
    throw InputError("--until", fmt::format("{} is not the size of a crack of this drive; write "
                                            "the path of its depth or half_length",
                                            shown(path)));
  }
  stop.time = option_quantity("--until", until, "s");
  require(*stop.time > 0, "--until", *stop.time, "s", "> 0");
  return stop;
}

}  // namespace

Command grow_command() {
  return command<GrowOptions, GrowthReport>({
      .name = "grow",
      .summary = "Grow the cracks over the duty: size, stiffness and reserve over hours",
      .description =
          "Counts the cycles of the duty for each crack, grows all cracks of the file together by "
          "the law of their material, and says what ends the life, after how many hours, or that "
          "the cracks stand still and which loads would start them again. The stiffness, the "
          "natural frequency and the reserve against failure follow over time. The file must give "
          "[duty] and a law of growth of each cracked material. `strainwave grow --fit DATA.csv` "
          "is another command: it finds such a law with its scatter from measured specimens, as "
          "`strainwave fit` does.",
      .example = "strainwave grow examples/growing_shaft.toml --plot growth.svg",
      .journal = "keep the steps in this file; if it has steps of the same run, go on from them",
      .journal_option = "resume",
      .function =
          [](const Request& request, const GrowOptions& o) {
            const GearSet& gear = request.drive.gear;
            GrowthOptions options = growth_options(o);
            options.points = o.points;
            options.stop = from_option([&] { return stop_of(gear, o.until); });
            GrowthCheckpoint checkpoint = checkpoint_of(request, o);
            return grow_cracks(gear, options, request.progress, &checkpoint);
          },
      .documents = {{Format::text,
                     [](const GrowthReport& report, const Rendering& to) {
                       return growth_text(report, to.drive.gear, to.provenance);
                     }},
                    {Format::csv, growth_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw sizes, ranges of K and stiffness over time as an SVG file"},
                     growth_plot}},
  });
}

}  // namespace strainwave

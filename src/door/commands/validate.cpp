// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/validation.hpp"

namespace strainwave {
namespace {

struct ValidateOptions {
  ValidationMode mode = ValidationMode::geometry;
  std::optional<std::string> factors;
  Blank blank = Blank::ratio;
  bool all_sets = false;
  int draws = 0;
  std::optional<std::string> data;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "mode",
           .unit = "",
           .doc = "which factors are fitted before the comparison, and to what",
           .fallback = "geometry"},
          &ValidateOptions::mode);
    field({.name = "factors",
           .unit = "",
           .doc = "other factors to fit, at most three, separated by commas",
           .names = "factor"},
          &ValidateOptions::factors);
    field({.name = "blank",
           .unit = "",
           .doc = "walls of the drives: made for the wave of each ratio, or of ratio 100 for all "
                  "ratios of a size",
           .fallback = "ratio"},
          &ValidateOptions::blank);
    field({"all_sets", "",
           "with mode leave-one-size-out or leave-one-class-out, also fit every set of one to "
           "three factors"},
          &ValidateOptions::all_sets);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives drawn for the bands, at least 2; 0 for none",
           .range = {.lower = 0, .lower_open = false, .upper = 100000, .upper_open = false},
           .fallback = "0"},
          &ValidateOptions::draws);
    field({.name = "data",
           .unit = "",
           .doc = "also judge rows of your own: CSV with the columns series, form, length, size or "
                  "pitch_diameter [mm], ratio, T1 [N*m], T2 [N*m], K1 [N*m/rad], K2 [N*m/rad], K3 "
                  "[N*m/rad]",
           .names = "attachment"},
          &ValidateOptions::data);
  }
};

Validation validated(const Request& request, const ValidateOptions& options) {
  if (request.rows != nullptr && options.draws == 0)
    throw OptionError("rows", "needs draws; give their number with --draws too");
  std::vector<StiffnessRow> rows;
  if (options.data) {
    const auto text = request.texts.find(*options.data);
    if (text == request.texts.end()) throw OptionError("data", "names a text that is not attached");
    rows = parse_stiffness_rows(text->second, *options.data);
  }
  return from_option([&] {
    return validate(
        {.mode = options.mode,
         .factors = options.factors ? parse_factors(*options.factors) : std::vector<Factor>(),
         .blank = options.blank,
         .all_sets = options.all_sets,
         .draws = options.draws,
         .sizes = {},
         .data = std::move(rows),
         .coupled = {}},
        request.progress, request.shared, request.rows);
  });
}

}  // namespace

Command validate_command() {
  return command<ValidateOptions, Validation>({
      .name = "validate",
      .summary = "Compare the torsion curve with the makers' tables",
      .description =
          "Predicts every row of the stiffness tables at each ratio for which it holds, and "
          "compares "
          "prediction and table by series, form, size and ratio. Rows of other series and rows of "
          "a file (--data) judge only; no fit uses them. Mode geometry does not fit factors: every "
          "drive has the typical proportions. Mode leave-one-size-out fits up to three factors to "
          "all other sizes and predicts the remaining one; leave-one-class-out does the same with "
          "the classes of ratio. Mode per-row fits up to three factors to each row and shows what "
          "the model can follow, not what it predicts. With --draws, the proportions are drawn "
          "between their limits, which gives the band of a drive of unknown geometry.",
      .example = "strainwave validate --mode geometry --draws 200 --plot validation.svg",
      .shares = "draws",
      .rows = "draws of --draws",
      .takes = Takes::nothing,
      .function = validated,
      .documents = {{Format::text, validation_text},
                    {Format::csv, validation_csv},
                    {Format::markdown, validation_markdown},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw predicted over stated stiffness as an SVG file"},
                     validation_plot}},
  });
}

}  // namespace strainwave

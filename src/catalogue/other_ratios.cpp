// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/other_ratios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "compared_drive.hpp"
#include "strainwave/catalogue/calibration.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/quantile.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kOption = "predict-ratios";

/// The drives of one size that differ in ratio only.
struct Family {
  int size = 0;
  DriveType type;
};

int catalogue_size_of(const GearSet& gear) {
  const double d = gear.drive.pitch_diameter;
  const std::vector<int> known = catalogue_sizes();
  const auto found = std::ranges::find_if(known, [&](int size) { return has_size(d, size); });
  if (found == known.end())
    throw InputError("drive.pitch_diameter", d, "m",
                     fmt::format("2.54 mm times a size of the catalogue, {}, to predict other "
                                 "ratios (--predict-ratios)",
                                 fmt::join(known, ", ")));
  return *found;
}

Family family_of(const GearSet& gear, Blank blank) {
  Family family{.size = catalogue_size_of(gear), .type = {}};
  const auto type = type_of(gear);
  if (!type)
    throw InputError("flexspline.shape",
                     "must be cup or hat to predict other ratios (--predict-ratios)");
  family.type = *type;
  family.type.blank = blank;
  return family;
}

/// The row of a table that states a ratio of the family; null if no table does.
const StiffnessRow* stating_row(const Family& family, double ratio) {
  for (const auto table : {stiffness_rows(), other_series_rows()})
    for (const StiffnessRow& row : table)
      if (row.size == family.size && row.form == family.type.form &&
          row.length == family.type.length && row.origin != RowOrigin::repeat &&
          std::ranges::find(row.ratios, ratio) != row.ratios.end())
        return &row;
  return nullptr;
}

/// All ratios of all tables.
std::set<double> known_ratios() {
  std::set<double> ratios;
  for (const auto table : {stiffness_rows(), other_series_rows()})
    for (const StiffnessRow& row : table) ratios.insert(row.ratios.begin(), row.ratios.end());
  return ratios;
}

/// The ratios that the tables state for a family.
/// @param without  leave out a ratio and its row
template <class Without>
std::vector<double> stated_ratios(const Family& family, const Without& without) {
  std::vector<double> ratios;
  for (const double ratio : known_ratios())
    if (const StiffnessRow* const row = stating_row(family, ratio);
        row != nullptr && !without(ratio, row))
      ratios.push_back(ratio);
  return ratios;
}

/// The typical drive of a ratio with the fitted factors.
GearSet typical_with_factors(const Calibration& calibration, const Family& family, double ratio) {
  GearSet gear = typical_drive_of_size(family.size, ratio, family.type);
  for (const CalibratedFactor& factor : calibration.factors)
    gear = with_factor(std::move(gear), factor.factor, factor.value);
  return gear;
}

/// The calibrated drive as a catalogue compares it, at the torques of its size.
GearSet own_drive(const Calibration& calibration, const Family& family) {
  GearSet gear = component_set(calibration.gear);
  gear.rating = typical_drive_of_size(family.size, gear.drive.ratio, family.type).rating;
  return gear;
}

std::array<double, 3> lines_of_ratio(const GearSet& gear, const CoupledOptions& options) {
  try {
    const MakersLines lines = makers_lines(gear, +1, options);
    return {lines.K1, lines.K2, lines.K3};
  } catch (const Error& error) {
    throw SolverError(fmt::format("prediction at ratio {:g}: {}", gear.drive.ratio, error.what()));
  }
}

/// The calibrated drive itself at its ratio, otherwise the typical drive with its factors.
std::vector<RatioPrediction> predictions(const Calibration& calibration, const Family& family,
                                         const std::vector<double>& ratios,
                                         const CoupledOptions& options, const Progress& progress) {
  std::vector<RatioPrediction> predicted;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    progress.at(static_cast<double>(i) / static_cast<double>(ratios.size()));
    const GearSet gear = ratios[i] == calibration.gear.drive.ratio
                             ? own_drive(calibration, family)
                             : typical_with_factors(calibration, family, ratios[i]);
    const std::array<double, 3> K = lines_of_ratio(gear, options);
    const MakersTorques at = makers_torques(gear);
    const std::array<double, 4> torques = {0.0, at.T1, at.T2, at.T3};
    const StiffnessRow* const row = stating_row(family, ratios[i]);
    for (std::size_t k = 0; k < 3; ++k)
      predicted.push_back({.ratio = ratios[i],
                           .name = fmt::format("K{}", k + 1),
                           .from_torque = torques[k],
                           .to_torque = torques[k + 1],
                           .predicted = K[k],
                           .series = row != nullptr ? row->series : std::string(),
                           .stated = row != nullptr ? row->K()[k] : std::nullopt,
                           .same_row = row != nullptr && row == calibration.row,
                           .usual_error = {},
                           .worst_error = {}});
  }
  return predicted;
}

}  // namespace

bool errors_are_known(const OtherRatios& other) {
  return is_short_cup(other.type) && other.size >= kLeastSimilarSize;
}

std::vector<double> parse_ratios(std::string_view text) {
  std::vector<double> ratios;
  if (text == "all") return ratios;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view one = text.substr(0, comma);
    const auto ratio = parse_number(one);
    if (!ratio)
      throw InputError(kOption, fmt::format("\"{}\" is not a ratio; write ratios such as "
                                            "50,80,100, or all",
                                            shown(one)));
    try {
      require_typical_ratio(*ratio);
    } catch (const InputError& error) {
      throw InputError(kOption, fmt::format("{:g} violates: {}", *ratio, error.rule()));
    }
    if (std::ranges::find(ratios, *ratio) != ratios.end())
      throw InputError(kOption, fmt::format("{:g} is named twice; name it once", *ratio));
    ratios.push_back(*ratio);
    if (comma == text.size()) return ratios;
    text.remove_prefix(comma + 1);
  }
}

OtherRatios predict_other_ratios(const Calibration& calibration, const std::vector<double>& ratios,
                                 Blank blank, const CoupledOptions& options,
                                 const Progress& progress) {
  const GearSet& gear = calibration.gear;
  const double from = gear.drive.ratio;
  const Family family = family_of(gear, blank);
  OtherRatios result{.from = from,
                     .size = family.size,
                     .type = family.type,
                     .predictions = {},
                     .median = {},
                     .worst = {},
                     .transfer = {}};
  const std::vector<double> wanted =
      ratios.empty()
          ? stated_ratios(family, [&](double ratio, const StiffnessRow*) { return ratio == from; })
          : ratios;
  if (wanted.empty())
    throw InputError(kOption,
                     fmt::format("no table states another ratio of a {} of size {}; name ratios, "
                                 "such as 50,80,100",
                                 words_of(family.type), family.size));
  for (const double ratio : wanted) require_typical_ratio(ratio);
  result.predictions = predictions(calibration, family, wanted, options, progress.part(0.0, 0.1));

  const std::array<double, 3> own = lines_of_ratio(own_drive(calibration, family), options);
  const std::array<double, 3> typical =
      lines_of_ratio(typical_with_factors(calibration, family, from), options);
  for (std::size_t k = 0; k < 3; ++k)
    result.geometry_difference =
        std::max(result.geometry_difference, std::abs(typical[k] / own[k] - 1));

  if (errors_are_known(result)) {
    std::vector<Factor> factors;
    for (const CalibratedFactor& factor : calibration.factors) factors.push_back(factor.factor);
    result.transfer = transfer_errors(from, factors, blank, options, progress.part(0.1, 1.0));
  }

  std::vector<double> errors;
  const std::set<double> known = known_ratios();
  for (RatioPrediction& p : result.predictions) {
    if (p.ratio == from) continue;
    if (const auto error = p.error(); error && !p.same_row) errors.push_back(std::abs(*error));
    if (p.ratio < *known.begin() || p.ratio > *known.rbegin()) continue;
    for (const TransferError& transfer : result.transfer.classes)
      if (transfer.to == ratio_class_of(p.ratio)) {
        p.usual_error = transfer.median;
        p.worst_error = transfer.worst;
      }
  }
  if (!errors.empty()) {
    result.median = quantile(errors, 0.5);
    result.worst = std::ranges::max(errors);
  }
  return result;
}

TransferErrors transfer_errors(double from, const std::vector<Factor>& factors, Blank blank,
                               const CoupledOptions& options, const Progress& progress) {
  require_typical_ratio(from);
  if (factors.empty() || factors.size() > 3)
    throw InputError("factors",
                     "name one to three to predict other ratios (--predict-ratios), because a row "
                     "of the catalogue has three values");
  struct OfClass {
    std::set<int> sizes;
    std::vector<double> errors;
  };
  std::map<RatioClass, OfClass> classes;
  TransferErrors result;
  const std::vector<int> sizes = catalogue_sizes();
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto share = [&](double done) {
      return (static_cast<double>(i) + done) / static_cast<double>(sizes.size());
    };
    const StiffnessRow* const row = find_stiffness(sizes[i], from);
    if (sizes[i] < kLeastSimilarSize || row == nullptr) continue;
    const auto K = row->K();
    if (static_cast<std::size_t>(std::ranges::count_if(
            K, [](const std::optional<double>& of) { return of.has_value(); })) < factors.size())
      continue;
    const Family family{.size = sizes[i], .type = {.blank = blank}};
    try {
      const GearSet gear = typical_drive_of_size(family.size, from, family.type);
      const Calibration calibration = calibrate(gear, catalogue_target(gear), factors, options,
                                                progress.part(share(0.0), share(0.8)));
      if (!calibration.converged) {
        ++result.left_out;
        continue;
      }
      const std::vector<double> ratios = stated_ratios(
          family, [&](double, const StiffnessRow* stating) { return stating == calibration.row; });
      for (const RatioPrediction& p : predictions(calibration, family, ratios, options,
                                                  progress.part(share(0.8), share(1.0)))) {
        if (!p.stated) continue;
        OfClass& of_class = classes[ratio_class_of(p.ratio)];
        of_class.sizes.insert(family.size);
        of_class.errors.push_back(std::abs(*p.error()));
      }
    } catch (const SolverError&) {
      ++result.left_out;
    }
  }
  for (auto& of_class : classes)
    result.classes.push_back({.to = of_class.first,
                              .sizes = static_cast<int>(of_class.second.sizes.size()),
                              .values = static_cast<int>(of_class.second.errors.size()),
                              .median = quantile(of_class.second.errors, 0.5),
                              .worst = std::ranges::max(of_class.second.errors)});
  progress.at(1.0);
  return result;
}

}  // namespace strainwave

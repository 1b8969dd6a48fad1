// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turn_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/model/input/turn_table.hpp"
#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave {
namespace {

/// Digits of a number in a table.
constexpr int kDigits = 9;

class Conditions {
 public:
  void word(std::string name, std::string_view text) {
    list_.push_back({.name = std::move(name), .text = std::string(text)});
  }
  void number(std::string name, double value, std::string_view unit) {
    const std::string_view last = std::string_view(name).substr(name.rfind('.') + 1);
    std::string text = shown_quantity(value, unit, kDigits, last);
    list_.push_back(
        {.name = std::move(name), .text = std::move(text), .number = value, .unit = unit});
  }
  /// Each number of a described part, under the names of the input file.
  template <class Part>
  void numbers(const std::string& path, const Part& part) {
    Part::describe([&](const Field& field, auto member, auto&&...) {
      const auto& value = part.*member;
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
        number(fmt::format("{}.{}", path, field.name), value, field.unit);
    });
  }
  [[nodiscard]] std::vector<TurnCondition> take() && { return std::move(list_); }

 private:
  std::vector<TurnCondition> list_;
};

std::string words_of(const CamShape& shape) {
  const auto length = [](double value) { return shown_quantity(value, "m", kDigits); };
  const auto angle = [](double value) { return shown_quantity(value, "rad", kDigits, "angle"); };
  struct Words {
    decltype(length) of_length;
    decltype(angle) of_angle;
    std::string operator()(const FlattenedCosine& cam) const {
      return fmt::format("cosine with a flattening of {:.9g}", cam.flattening);
    }
    std::string operator()(const TwoArcs& cam) const {
      return "two arcs of " + of_angle(cam.arc_angle);
    }
    std::string operator()(const TwoDiscs& cam) const {
      return "two discs at " + of_length(cam.offset);
    }
    std::string operator()(const CamPoints& cam) const {
      std::string text = "points";
      for (const CamPoint& point : cam)
        text += fmt::format("; {} at {}", of_length(point.height), of_angle(point.angle));
      return text;
    }
  };
  return std::visit(Words{length, angle}, shape);
}

void add_drive(Conditions& conditions, const GearSet& gear) {
  conditions.number("drive.wave_number", gear.drive.wave_number, "1");
  const CamFit fit = cam_fit(gear);
  conditions.number("drive.radial_displacement", fit.radial_displacement, "m");
  conditions.word("wave_generator.cam", words_of(fit.shape));
  if (follows_perimeter(fit.shape))
    conditions.number("wave_generator.cam_perimeter_excess", fit.perimeter_excess, "m");
  conditions.number("wave_generator.bearing.clearance", fit.clearance, "m");
}

void add_flexspline(Conditions& conditions, const GearSet& gear) {
  const Flexspline& flexspline = *gear.flexspline;
  const ElasticConstants steel = elastic_constants(only_material(gear, flexspline));
  conditions.number("flexspline.material.youngs_modulus", steel.E, "Pa");
  conditions.number("flexspline.material.poissons_ratio", steel.nu, "1");
  if (flexspline.rim) {
    conditions.numbers("flexspline.rim", *flexspline.rim);
    const double band = cam_fit(gear).band_width;
    conditions.number("wave_generator.bearing.outer_ring.width",
                      band > 0 ? std::min(band, flexspline.rim->length) : flexspline.rim->length,
                      "m");
  }
  if (flexspline.barrel) conditions.numbers("flexspline.barrel", *flexspline.barrel);
  // A table for a cup without a bottom is not for a cup with one.
  conditions.word("flexspline.diaphragm", flexspline.diaphragm ? "plate" : "none");
  if (!flexspline.diaphragm) return;
  conditions.numbers("flexspline.diaphragm", *flexspline.diaphragm);
  conditions.number("stations of flexspline.diaphragm.profile",
                    static_cast<double>(flexspline.diaphragm->profile.size()), "1");
  for (std::size_t i = 0; i < flexspline.diaphragm->profile.size(); ++i)
    conditions.numbers(fmt::format("flexspline.diaphragm.profile[{}]", i),
                       flexspline.diaphragm->profile[i]);
}

template <class Crack>
void add_crack(Conditions& conditions, const GearSet& gear, const Crack& crack) {
  conditions.word("crack.kind", Crack::kKind);
  if constexpr (requires { crack.section; }) {
    conditions.word("crack.section", enum_name(crack.section));
    conditions.number("crack.angle", crack.angle, "rad");
    const auto& part =
        crack.section == WallSection::barrel ? gear.flexspline->barrel : gear.flexspline->rim;
    if (part) conditions.number("crack.distance", crack.distance.value_or(part->length / 2), "m");
  }
  if constexpr (std::is_same_v<Crack, WallSurfaceCrack>) {
    conditions.word("crack.mouth", enum_name(crack.mouth.value_or(Mouth::outer)));
    conditions.number("crack.depth/half_length", crack.depth / crack.half_length, "1");
  }
}

bool meets(const TurnCondition& drive, const std::string& wanted) {
  if (!drive.number) return drive.text == wanted;
  const double number = parse_quantity(drive.name, wanted, drive.unit);
  const double largest = std::max(std::abs(number), std::abs(*drive.number));
  return std::abs(number - *drive.number) <= kTurnConditionTolerance * largest;
}

}  // namespace

std::vector<TurnCondition> turn_conditions(const GearSet& gear, std::string_view path) {
  Conditions conditions;
  for_each_crack_with_turn(gear, [&](const std::string& here, const auto& crack) {
    if (here != path) return;
    add_drive(conditions, gear);
    if (gear.flexspline) add_flexspline(conditions, gear);
    add_crack(conditions, gear, crack);
  });
  return std::move(conditions).take();
}

void check_turn_conditions(const std::vector<TurnCondition>& wanted,
                           const std::vector<TurnCondition>& found, std::string_view file,
                           std::string_view at) {
  for (const TurnCondition& condition : wanted) {
    const auto here = std::ranges::find(found, condition.name, &TurnCondition::name);
    const auto refuse = [&](const std::string& has) {
      throw InputError(
          at, fmt::format(
                  "\"{}\" is for a drive with {} = {}, but this drive {}; leave out turn_table, "
                  "and compute a table for this drive by strainwave turn",
                  shown(file), shown(condition.name), shown(condition.text), has));
    };
    if (here == found.end()) refuse("does not give it");
    bool same = false;
    try {
      same = meets(*here, condition.text);
    } catch (const InputError& error) {
      throw InputError(at, fmt::format("\"{}\": {}", shown(file), error.what()));
    }
    if (!same) refuse("has " + here->text);
  }
}

}  // namespace strainwave

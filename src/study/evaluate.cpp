// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/evaluate.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "strainwave/article/as_printed.hpp"
#include "strainwave/article/repaired.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/crack_assessment.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

CurveStiffness lines_of(const AssembledDrive& drive, int sense) {
  const MakersLines lines = makers_lines(drive, sense);
  const auto quantity = [&](double K) {
    return Quantity{K, "N*m/rad", curve_uncertainty(drive.gear())};
  };
  return {quantity(lines.K1), quantity(lines.K2), quantity(lines.K3)};
}

/// Adds the maker's stiffnesses to the result of the series model, or a note with the reason why
/// they are missing.
void add_curve(StiffnessResult& result, const GearSet& gear) {
  try {
    const AssembledDrive drive(gear);
    result.curve = {.intact = lines_of(drive.without_cracks(), +1),
                    .positive = lines_of(drive, +1),
                    .negative = lines_of(drive, -1)};
    result.equations.emplace_back("TC-14");
  } catch (const Error& error) {
    result.notes.push_back(
        {.code = "curve.none",
         .text = std::string("no torsion curve of the coupled drive: ") + error.what(),
         .path = "",
         .equation = "TC-11",
         .severity = Severity::care});
  }
}

/// Adds the strength of the cracks to the stiffness, or a note that names the missing input.
void add_strength(StiffnessResult& result, const GearSet& gear) {
  std::vector<CrackStrength> strength = crack_strength(gear, result.cracks);
  if (strength.empty()) return;
  const bool known = std::ranges::any_of(gear.material, [](const auto& named) {
    return named.second.fracture_toughness || named.second.yield_strength;
  });
  if (!known) {
    result.notes.push_back(
        {.code = "strength.cannot_tell",
         .text = "crack strength not assessed: no material specifies fracture_toughness or "
                 "yield_strength",
         .path = "material",
         .equation = "FA-13",
         .severity = Severity::cannot_tell,
         .next_step = "Give fracture_toughness and yield_strength of the cracked materials."});
    return;
  }
  for (Note& note : strength_notes(strength)) result.notes.push_back(std::move(note));
  for (const CrackStrength& crack : strength)
    for (const std::string& tag : crack.equations)
      if (std::ranges::find(result.equations, tag) == result.equations.end())
        result.equations.push_back(tag);
  result.strength = std::move(strength);
}

}  // namespace

StiffnessResult evaluate(const GearSet& gear, Method method) {
  switch (method) {
    case Method::as_printed:
      return torsional_stiffness_as_printed(gear);
    case Method::repaired:
      return torsional_stiffness_repaired(gear);
    case Method::corrected:
      break;
  }
  assert(method == Method::corrected);
  StiffnessResult result = torsional_stiffness(gear);
  add_strength(result, gear);
  if (missing_for_torsion_curve(gear).empty()) add_curve(result, gear);
  return result;
}

}  // namespace strainwave

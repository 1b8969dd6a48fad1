// SPDX-License-Identifier: Apache-2.0
#include "crack_interaction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "member_support.hpp"

namespace strainwave {
namespace {

/// The ratios of K in a group under one sense of the torque.
struct IntensityRatios {
  double least = 1.0;
  double most = 1.0;
  std::size_t at = 0;  ///< the crack with the largest one
  bool act = false;    ///< whether a crack opens or slides
};

IntensityRatios ratios_of(const std::vector<GroupEffect>& effects) {
  constexpr double kNothing = 1e-9;
  IntensityRatios result;
  for (std::size_t j = 0; j < effects.size(); ++j) {
    if (effects[j].tip <= kNothing) continue;
    const double ratio = effects[j].intensity;
    if (!result.act || ratio > result.most) {
      result.most = ratio;
      result.at = j;
    }
    result.least = result.act ? std::min(result.least, ratio) : ratio;
    result.act = true;
  }
  return result;
}

std::string words_of(std::string_view sense, const AnsweredGroup& of, std::size_t which) {
  const IntensityRatios K = ratios_of(which == 0 ? of.positive : of.negative);
  if (!K.act) return fmt::format("under {} none of them opens or slides", sense);
  const double ratio = of.alone[which] > 0 ? of.added[which] / of.alone[which] : 1.0;
  return fmt::format(
      "under {} they add {:.3f} times the sum of their compliances, and K is {:.3f} to {:.3f} "
      "times that of a crack alone, the most at {}",
      sense, ratio, K.least, K.most, of.group.members()[K.at].path);
}

}  // namespace

AnsweredGroup::AnsweredGroup(WallGroup of) : group(std::move(of)), fault(group.fault()) {
  if (!fault.empty()) return;
  positive = group.under(TorqueSense::positive);
  negative = group.under(TorqueSense::negative);
}

SymmetricMatrix<2> in_group(const SymmetricMatrix<2>& alone, const GroupEffect& effect) {
  SymmetricMatrix<2> result = alone;
  std::array<double, 2> curved{};  // compliance of the curved wall per unit of that of the sheet
  for (const std::size_t load : {kAxial, kTorsion})
    if (effect.alone(load, load) > 0) curved[load] = alone(load, load) / effect.alone(load, load);
  for (const std::size_t load : {kAxial, kTorsion})
    if (curved[load] == 0) curved[load] = curved[1 - load];
  result(kTorsion, kTorsion) = alone(kTorsion, kTorsion) * effect.ratio();  // (CG-9)
  result(kAxial, kAxial) +=
      curved[kAxial] * (effect.in_group(kAxial, kAxial) - effect.alone(kAxial, kAxial));  // (CG-9)
  result(kAxial, kTorsion) +=
      std::sqrt(curved[kAxial] * curved[kTorsion]) *
      (effect.in_group(kAxial, kTorsion) - effect.alone(kAxial, kTorsion));  // (CG-9)
  return result;
}

ByCurvature by_curvature(const WallGroup& group, const GroupEffect& effect) {
  const double ratio = std::abs(effect.ratio());
  const double share = group.uncertainty();
  ByCurvature result;
  if (ratio > 0) result.compliance = std::min(1.0, share * std::abs(effect.ratio() - 1) / ratio);
  if (effect.tip > 0)
    result.intensity =
        std::min(1.0, share * effect.changed_intensity / effect.tip + effect.overlap);
  return result;
}

void note_interaction(const AnsweredGroup& answered, MemberCompliance& member) {
  use_equations(member.equations, {"CG-6", "CG-9"});
  if (!answered.fault.empty()) {
    member.unusable_because = answered.fault;
    return;
  }
  double compliance = 0.0;  // error of plain superposition
  double intensity = 0.0;
  double left_out_compliance = 0.0;
  double left_out_intensity = 0.0;
  for (const std::size_t which : {0U, 1U}) {
    const auto& effects = which == 0 ? answered.positive : answered.negative;
    const IntensityRatios K = ratios_of(effects);
    if (!K.act) continue;
    if (answered.added[which] > 0)
      compliance =
          std::max(compliance, std::abs(answered.alone[which] / answered.added[which] - 1));
    intensity = std::max({intensity, std::abs(1 / K.most - 1), std::abs(1 / K.least - 1)});
    for (const GroupEffect& effect : effects) {
      const ByCurvature by = by_curvature(answered.group, effect);
      left_out_compliance = std::max(left_out_compliance, by.compliance);
      left_out_intensity = std::max(left_out_intensity, by.intensity);
    }
  }
  constexpr double kSmall = 0.05;
  const bool care = std::max(left_out_compliance, left_out_intensity) > kSmall;
  member.notes.push_back(
      {.code = "crack.interaction",
       .text = fmt::format(
           "the {} through cracks of the {} influence each other, and this answer contains their "
           "influence, as in a flat sheet: {}; {}; plain superposition would be {:.2g} % off in "
           "the compliance that they add and {:.2g} % in K; the curvature between the cracks is "
           "left out, which may change the compliance of a crack by {:.2g} % and its K by {:.2g} %",
           answered.group.members().size(), answered.group.wall().name,
           words_of("T > 0", answered, 0), words_of("T < 0", answered, 1), 100 * compliance,
           100 * intensity, 100 * left_out_compliance, 100 * left_out_intensity),
       .path = "flexspline.crack",
       .equation = "CG-9",
       .severity = care ? Severity::care : Severity::information});
}

}  // namespace strainwave

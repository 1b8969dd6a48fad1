// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {

std::optional<Quantity> output_named(const StiffnessResult& result, std::string_view path) {
  std::optional<Quantity> found;
  for_each_quantity(result, [&](const std::string& name, const Quantity& q) {
    if (name == path) found = q;
  });
  return found;
}

void refuse_output(const StiffnessResult& result, std::string_view path, std::string_view option) {
  std::vector<std::string> known;
  std::vector<std::string> ending;  // "stiffness" may stand for three outputs
  for_each_quantity(result, [&](const std::string& name, const Quantity&) {
    known.push_back(name);
    if (!path.empty() && name.ends_with("." + std::string(path))) ending.push_back(name);
  });
  if (ending.empty())
    if (std::string near = nearest_word(path, known); !near.empty())
      ending.push_back(std::move(near));
  const bool without_turn =
      is_over_turn(path) && result.curve &&
      std::ranges::find(result.notes, "curve.one_angle", &Note::code) == result.notes.end();
  const std::string suggested =
      without_turn ? std::string(
                         "; outputs over a turn exist only for cracks of teeth, rim, outer "
                         "ring or circular spline.")
      : !ending.empty()
          ? fmt::format("; did you mean {}?", fmt::join(ending, " or "))
          : fmt::format("; write an output such as {}.",
                        result.curve ? "curve.positive.K2" : "cracked.positive.stiffness");
  throw InputError(option,
                   fmt::format("\"{}\" is not an output of this drive{} strainwave stiffness FILE "
                               "--format csv lists its outputs, and strainwave explain OUTPUT "
                               "explains an output",
                               path, suggested));
}

}  // namespace strainwave

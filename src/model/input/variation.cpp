// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/variation.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/model/input/vary_option.hpp"

namespace strainwave {

void check_variation(const Variation& variation, std::string_view option_name) {
  const std::string option = vary_option(variation.path, option_name);
  const auto& [path, from, to, n_points, spacing] = variation;
  if (!std::isfinite(from) || !std::isfinite(to) || from == to)
    throw InputError(option, fmt::format("{}..{} must be two different finite numbers", from, to));
  if (n_points < 2 || n_points > kMaxSweepPoints)
    throw InputError(option, fmt::format("the number of points is {}; it must be from 2 to {}",
                                         n_points, kMaxSweepPoints));
  const bool one_sign = (from > 0 && to > 0) || (from < 0 && to < 0);
  if (spacing == Spacing::logarithmic && !one_sign)
    throw InputError(option, fmt::format("the range {} 0, but equal ratios (:log) never reach "
                                         "0; {}, or leave out :log for equal steps",
                                         from == 0 || to == 0 ? "reaches" : "crosses",
                                         from == 0 ? "begin at a number other than 0"
                                         : to == 0 ? "end at a number other than 0"
                                                   : "give ends of one sign"));
}

double Variation::value(int i) const {
  if (i == 0) return from;
  if (i == n_points - 1) return to;
  const double t = static_cast<double>(i) / (n_points - 1);
  return spacing == Spacing::linear ? std::lerp(from, to, t) : from * std::pow(to / from, t);
}

Variation parse_variation(const GearSet& gear, std::string_view text,
                          std::string_view option_name) {
  const Assignment given = assignment(text);
  if (!given.has_value)
    throw InputError(option_name,
                     fmt::format("\"{}\" must be PATH=FROM..TO:N or PATH=FROM..TO:N:log", text));
  const NumberAt number = varied_number(gear, given.key, option_name);
  const std::string option = vary_option(number.path, option_name);

  const std::size_t colon = given.value.find(':');
  if (colon == std::string_view::npos)
    throw InputError(option,
                     fmt::format("\"{}\" needs a number of points: FROM..TO:N", given.value));
  const Interval interval = parse_interval(number, given.value.substr(0, colon), option_name);
  Variation variation{.path = number.path, .from = interval.from, .to = interval.to};

  std::string_view points = given.value.substr(colon + 1);
  if (const std::size_t next = points.find(':'); next != std::string_view::npos) {
    const std::string_view spacing = without_blanks(points.substr(next + 1));
    if (spacing != "log")
      throw InputError(
          option, fmt::format("has \"{}\" after the number of points, where only \"log\" may stand",
                              spacing));
    variation.spacing = Spacing::logarithmic;
    points = points.substr(0, next);
  }
  points = without_blanks(points);
  const auto [end, error] =
      std::from_chars(points.data(), points.data() + points.size(), variation.n_points);
  if (error != std::errc{} || end != points.data() + points.size())
    throw InputError(
        option,
        fmt::format("the number of points is \"{}\"; it must be a whole number from 2 to {}",
                    points, kMaxSweepPoints));
  check_variation(variation, option_name);
  return variation;
}

}  // namespace strainwave

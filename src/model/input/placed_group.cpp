// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/placed_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lazy_path.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A step from one crack of a group to the next, on the unrolled surface.
struct Step {
  double round = 0.0;  ///< toward +theta [m]
  double along = 0.0;  ///< along z [m]

  [[nodiscard]] double length() const { return std::hypot(round, along); }
};

/// How far a crack reaches along the step to the next one [m]; its two halves together.
template <class Crack>
double reach(const Crack& crack, const Step& step) {
  if constexpr (requires { crack.angle; }) {
    // The angle runs from +z toward -theta.
    const double along = step.along * std::cos(crack.angle) - step.round * std::sin(crack.angle);
    return 2 * crack.half_length * std::abs(along) / step.length();
  } else {
    return 2 * crack.half_length;  // an arc lies along its circle
  }
}

/// Radius of the circle on which the positions of a crack lie [m]; absent if the drive lacks a
/// member that tells it, which `check` refuses.
std::optional<double> radius_of(const GearSet& gear, const DiaphragmArcCrack& crack) {
  if (crack.radius) return crack.radius;
  const auto& diaphragm = gear.flexspline->diaphragm;
  return diaphragm ? std::optional(diaphragm->inner_diameter / 2) : std::nullopt;
}

template <class Crack>
requires requires(Crack crack) { crack.section; }
std::optional<double> radius_of(const GearSet& gear, const Crack& crack) {
  const Flexspline& fs = *gear.flexspline;
  if (fs.crack_free == CrackFree::factor)
    return fs.wall_thickness ? std::optional((gear.drive.pitch_diameter - *fs.wall_thickness) / 2)
                             : std::nullopt;
  const auto& tube = crack.section == WallSection::rim ? fs.rim : fs.barrel;
  return tube ? std::optional((tube->outer_diameter - tube->wall_thickness) / 2) : std::nullopt;
}

void require_no_zero(const LazyPath& at, std::string_view field, std::optional<double> step,
                     std::string_view unit) {
  if (step)
    require(*step != 0, at / field, *step, unit, [&] { return fmt::format("{} != 0", field); });
}

/// Refuses a pitch that is not longer than the crack along it.
template <class Crack>
void require_longer(const LazyPath& at, const GearSet& gear, const Crack& crack) {
  if constexpr (requires { crack.half_length; }) {
    const std::optional<double> radius = radius_of(gear, crack);
    if (!radius) return;
    Step step{.round = *radius * crack.pitch.value_or(0.0)};
    if constexpr (requires { crack.axial_pitch; }) step.along = crack.axial_pitch.value_or(0.0);
    const double least = reach(crack, step);
    const bool along = !crack.pitch;
    // A number that is none passes; `check` refuses it by its own path.
    require(!(step.length() <= least), at / (along ? "axial_pitch" : "pitch"),
            along ? step.along : *crack.pitch, along ? "m" : "rad", [&] {
              return fmt::format(
                  "a step of more than {:.4g} mm from crack to crack, the length of the crack "
                  "along the step, but it is {:.4g} mm; give positions, or one table for each "
                  "crack, if they pass each other side by side",
                  least / units::mm, step.length() / units::mm);
            });
  }
}

/// Refuses two equal places of a list.
void require_different(const LazyPath& at, const std::vector<double>& positions,
                       std::string_view unit) {
  constexpr double kSame = 1e-9;  // [m] or [rad]
  const LazyPath list = at / "positions";
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t other = 0; other < i; ++other) {
      double apart = positions[i] - positions[other];
      if (unit == "rad") apart = std::remainder(apart, kTurn);
      require(!(std::abs(apart) <= kSame), list[i], positions[i], unit, [&] {
        return fmt::format("a place of its own, but positions[{}] is the same", other);
      });
    }
}

/// The value that the table gives to the field that the group places.
template <class Crack>
std::optional<double> given_place(const Crack& crack) {
  const auto& place = crack.*Crack::kPlace;
  if constexpr (is_optional<std::decay_t<decltype(place)>>)
    return place;
  else
    return place == 0.0 ? std::nullopt : std::optional(place);  // 0 is its default
}

/// The cracks of one table that gives a group.
template <class Crack>
std::vector<Crack> cracks_of(const LazyPath& at, const GearSet& gear, const Crack& table) {
  constexpr bool kRound = !std::is_same_v<Crack, AnnularCrack>;
  constexpr std::string_view kPlaceName = kRound ? "position" : "distance";
  constexpr std::string_view kUnit = kRound ? "rad" : "m";
  std::optional<double> axial;
  if constexpr (requires { table.axial_pitch; }) axial = table.axial_pitch;
  const std::string_view step = table.pitch ? "pitch" : "axial_pitch";
  const auto refuse = [&](std::string_view field, const std::string& problem) {
    throw InputError((at / field).text(), problem);
  };

  Crack one = table;
  one.count = 1;
  one.pitch.reset();
  one.positions.clear();
  if constexpr (requires { one.axial_pitch; }) one.axial_pitch.reset();
  std::vector<Crack> cracks;

  if (!table.positions.empty()) {
    if (table.pitch || axial)
      refuse(step, fmt::format("is given beside positions; give one of the two, {} with count or "
                               "positions",
                               step));
    if (given_place(table))
      refuse(kPlaceName,
             "is given beside positions; leave it out, or make it one of the positions");
    const std::size_t listed = table.positions.size();
    if (table.count != 1 && static_cast<std::size_t>(table.count) != listed)
      throw InputError((at / "count").text(), table.count, "1",
                       fmt::format("{}, the number of positions; or leave count out", listed));
    require_different(at, table.positions, kUnit);
    for (const double place : table.positions) {
      one.*Crack::kPlace = place;
      cracks.push_back(one);
    }
    return cracks;
  }

  if (!table.pitch && !axial) {  // evenly spaced round the axis, if that is a place
    if constexpr (!kRound)
      refuse("pitch", "must be given with count [m]; or give positions in place of both");
  } else {
    if (table.count < 2) refuse(step, "must be given with count, the number of cracks, 2 or more");
    require_no_zero(at, "pitch", table.pitch, kUnit);
    require_no_zero(at, "axial_pitch", axial, "m");
    if constexpr (is_optional<std::decay_t<decltype(table.*Crack::kPlace)>>)
      if (!given_place(table))
        refuse(kPlaceName, fmt::format("must be given with {}, the place of the first crack [{}]",
                                       step, kUnit));
    if constexpr (requires { table.axial_pitch; })
      if (axial && !table.distance)
        refuse("distance", "must be given with axial_pitch, the place of the first crack [m]");
    require_longer(at, gear, table);
  }
  const double first = given_place(table).value_or(0.0);
  const double pitch = table.pitch ? *table.pitch : axial ? 0.0 : kTurn / table.count;
  for (int i = 0; i < table.count; ++i) {
    one.*Crack::kPlace = first + i * pitch;
    if constexpr (requires { one.axial_pitch; })
      if (axial) one.distance = *table.distance + i * *axial;
    cracks.push_back(one);
  }
  return cracks;
}

}  // namespace

void place_groups(GearSet& gear) {
  for_each_cracked_member(gear, [&](std::string_view name, auto& member) {
    using Cracks = std::decay_t<decltype(member.crack)>;
    const LazyPath part(name);
    const LazyPath list = part / "crack";
    const std::size_t tables = member.crack.size();
    std::size_t total = 0;
    Cracks copies;
    for (std::size_t i = 0; i < tables; ++i)
      std::visit(
          [&](auto& crack) {
            using Crack = std::decay_t<decltype(crack)>;
            if constexpr (GroupableCrack<Crack>) {
              if (!is_group(crack)) return;
              const LazyPath at = list[i];
              const std::size_t more = crack.positions.empty()
                                           ? static_cast<std::size_t>(std::max(crack.count, 0))
                                           : crack.positions.size();
              total += more;
              if (total > kMostPlacedCracks)
                throw InputError((at / (crack.positions.empty() ? "count" : "positions")).text(),
                                 fmt::format("makes {} cracks of the groups of {}; at most {} are "
                                             "allowed",
                                             total, name, kMostPlacedCracks));
              const std::vector<Crack> cracks = cracks_of(at, gear, crack);
              crack = cracks.front();
              if (cracks.size() > 1)
                gear.placed_groups.push_back({.member = name,
                                              .index = i,
                                              .first_copy = tables + copies.size(),
                                              .count = cracks.size()});
              copies.insert(copies.end(), cracks.begin() + 1, cracks.end());
            }
          },
          member.crack[i]);
    member.crack.insert(member.crack.end(), copies.begin(), copies.end());
  });
}

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turn_request.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "strainwave/core/ascending.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave {
namespace {

/// The crack of the wall that a turn can compute; absent if it is of another kind or place.
std::optional<CrackOfWall> known_crack(const std::string& path, const FlexsplineCrack& crack,
                                       RimCracks rim) {
  if (const auto* const through = std::get_if<WallThroughCrack>(&crack);
      through != nullptr && through->section == WallSection::barrel)
    return CrackOfWall{path, *through};
  if (const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
      surface != nullptr && (surface->section == WallSection::barrel || rim == RimCracks::surface))
    return CrackOfWall{path, *surface};
  return std::nullopt;
}

std::string known_words(RimCracks rim) {
  return std::string("a through or surface crack of the barrel") +
         (rim == RimCracks::surface ? ", or a surface crack of the rim" : "");
}

CrackOfWall chosen(const Flexspline& flexspline, const std::optional<std::string>& asked,
                   RimCracks rim) {
  std::vector<CrackOfWall> found;
  for (std::size_t n = 0; n < flexspline.crack.size(); ++n) {
    const std::string path = fmt::format("flexspline.crack[{}]", n);
    if (asked && *asked != path) continue;
    if (std::optional<CrackOfWall> crack = known_crack(path, flexspline.crack[n], rim))
      found.push_back(std::move(*crack));
    else if (asked)
      throw InputError(
          path, fmt::format("must be {}; choose another crack by --crack", known_words(rim)));
  }
  if (found.empty() && asked)
    throw InputError("--crack", fmt::format("\"{}\" is not a crack of the flexspline; give a path "
                                            "such as flexspline.crack[0]",
                                            shown(*asked)));
  if (found.empty())
    throw InputError("flexspline.crack", fmt::format("must have {}", known_words(rim)));
  if (found.size() > 1)
    throw InputError("flexspline.crack",
                     "has several cracks that a turn can take; choose one of them by --crack");
  return std::move(found.front());
}

std::vector<TurnSize> sizes_of(const WallThroughCrack& crack, const TurnRequest& request) {
  if (!request.depths.empty())
    throw InputError("--depth", "is not the size of a through crack; give --half-length");
  std::vector<TurnSize> sizes;
  for (const double half_length : request.half_lengths.empty() ? std::vector{crack.half_length}
                                                               : ascending(request.half_lengths))
    sizes.push_back({.depth = {}, .half_length = half_length});
  return sizes;
}
std::vector<TurnSize> sizes_of(const WallSurfaceCrack& crack, const TurnRequest& request) {
  if (!request.half_lengths.empty())
    throw InputError("--half-length", "is not the size of a surface crack; give --depth");
  std::vector<TurnSize> sizes;
  for (const double depth :
       request.depths.empty() ? std::vector{crack.depth} : ascending(request.depths))
    sizes.push_back({.depth = depth, .half_length = crack.half_length * depth / crack.depth});
  return sizes;
}

}  // namespace

TurnRequest TurnRequestOptions::request(std::optional<std::string> crack) const {
  TurnRequest request{
      .crack = std::move(crack), .torques = torque, .half_lengths = half_length, .depths = depth};
  if (angles) request.angles = *angles;
  return request;
}

double CrackOfWall::angle() const {
  return std::visit([](const auto& of) { return of.angle; }, crack);
}

WallSection CrackOfWall::section() const {
  return std::visit([](const auto& of) { return of.section; }, crack);
}

bool CrackOfWall::mouth_unknown() const {
  const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
  return surface != nullptr && !surface->mouth;
}

int CrackOfWall::count() const {
  return std::visit([](const auto& of) { return of.count; }, crack);
}

TurnPlan plan_turn(const GearSet& gear, const TurnRequest& request, RimCracks rim) {
  check(gear);
  require_turning_cup(gear);
  require(request.angles >= 8 && request.angles <= 720, "angles", request.angles, "1",
          ">= 8 and <= 720");
  const double T = gear.load.torque;
  TurnPlan plan{
      .crack = chosen(*gear.flexspline, request.crack, rim),
      .torques = ascending(request.torques.empty() ? std::vector{-T, 0.0, T} : request.torques),
      .sizes = {},
      .angles = request.angles};
  for (const double torque : plan.torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  plan.sizes =
      std::visit([&](const auto& crack) { return sizes_of(crack, request); }, plan.crack.crack);
  return plan;
}

}  // namespace strainwave

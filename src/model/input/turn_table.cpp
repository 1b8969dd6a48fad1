// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turn_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/hermite.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Relative distance by which rounding may carry a number beyond a table.
constexpr double kTurnRounding = 1e-9;
/// Largest difference of the span of the angles to a wave or a turn [rad].
constexpr double kSpanTolerance = 1e-6;

bool within(const std::vector<double>& nodes, double value) {
  const double slack = kTurnRounding * std::max(std::abs(nodes.front()), std::abs(nodes.back()));
  return value >= nodes.front() - slack && value <= nodes.back() + slack;
}

/// Weights of the nodes for the value at a place, over the logarithm (FE-41); beyond the nodes,
/// that of the nearest one.
std::vector<double> logarithmic_weights(const std::vector<double>& nodes, double at) {
  std::vector<double> weights(nodes.size(), 0.0);
  std::vector<double> x;
  for (const double node : nodes) x.push_back(std::log(node));
  const double place = std::clamp(std::log(at), x.front(), x.back());
  if (nodes.size() == 1) {
    weights.front() = 1.0;
    return weights;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::vector<double> unit(nodes.size(), 0.0);
    unit[i] = 1.0;
    weights[i] = hermite_interpolation<double, double>(x, unit, place);
  }
  return weights;
}

template <class Crack>
void check_turn(const GearSet& gear, const std::string& path, const Crack& crack) {
  const std::string at = path + ".turn_table";
  const std::string& file = *crack.turn_table;
  const auto found = gear.turn_tables.find(file);
  if (found == gear.turn_tables.end() || !found->second)
    throw InputError(at, fmt::format("\"{}\" has not been read", shown(file)));
  const TurnTable& table = *found->second;
  const auto refuse = [&](const std::string& problem) {
    throw InputError(at, fmt::format("\"{}\" {}", shown(file), problem));
  };
  constexpr bool kHasDepth = requires { crack.depth; };
  constexpr bool kSurface = std::is_same_v<Crack, WallSurfaceCrack>;
  const std::string_view wanted = kHasDepth ? "depth" : "half_length";
  if (table.size_name != wanted)
    refuse(fmt::format("has a column {}, but a crack of kind \"{}\" needs the column {}",
                       table.size_name, Crack::kKind, wanted));
  if (!kSurface && !table.aspect_ratios.empty())
    refuse(fmt::format("has a column aspect_ratio, which a crack of kind \"{}\" does not have",
                       Crack::kKind));
  const double least_station = kSurface ? 0.0 : -1.0;
  if (table.stations.front() < least_station || table.stations.back() > 1 ||
      (kSurface && (table.stations.front() != 0 || table.stations.back() != 1)))
    refuse(kSurface ? "must have the stations 0, at the surface, and 1, at the deepest point, and "
                      "others between them only"
                    : "must have stations from -1 to 1 only");
  const double span = table.angles.back() - table.angles.front();
  const double wave = 2 * pi / gear.drive.wave_number;
  if (std::abs(span - wave) > kSpanTolerance && std::abs(span - 2 * pi) > kSpanTolerance)
    refuse(fmt::format(
        "runs over {}, but must run over a wave of {} or a turn of 360 deg, with the "
        "first angle again at the end",
        shown_quantity(span, "rad", 9, "angle"), shown_quantity(wave, "rad", 9, "angle")));
  const auto covered = [&](const std::vector<double>& nodes, double value, std::string_view unit,
                           std::string_view name) {
    if (nodes.size() > 1 && !within(nodes, value))
      refuse(fmt::format("covers {} to {} of {}, but the drive has {}",
                         shown_quantity(nodes.front(), unit, 9, name),
                         shown_quantity(nodes.back(), unit, 9, name), name,
                         shown_quantity(value, unit, 9, name)));
  };
  if constexpr (kHasDepth)
    covered(table.sizes, crack.depth, "m", "depth");
  else
    covered(table.sizes, crack.half_length, "m", "half_length");
  if constexpr (kSurface)
    if (!table.aspect_ratios.empty())
      covered(table.aspect_ratios, crack.depth / crack.half_length, "1", "depth/half_length");
  check_turn_conditions(table.conditions, turn_conditions(gear, path), file, at);
  if (gear.load.axial_force != 0)
    refuse("is a table for torque alone, so load.axial_force must be 0");
  if (!gear.duty) return;
  for (std::size_t i = 0; i < gear.duty->block.size(); ++i)
    if (gear.duty->block[i].axial_force != 0)
      refuse(
          fmt::format("is a table for torque alone, so duty.block[{}].axial_force must be 0", i));
}

}  // namespace

bool TurnTable::covers(double torque) const { return within(torques, torque); }

std::array<double, 2> turn_load_range(const TurnTable& table, double torque) {
  const double near = torque > 0 ? table.torques.front() : table.torques.back();
  const double far = torque > 0 ? table.torques.back() : table.torques.front();
  return {std::max(0.0, near / torque), far / torque};
}

TurnFactors::TurnFactors(const TurnTable& table, double size, double aspect_ratio) : table_(table) {
  const std::vector<double> of_size = logarithmic_weights(table.sizes, size);
  const std::vector<double> of_shape = table.aspect_ratios.empty()
                                           ? std::vector<double>{1.0}
                                           : logarithmic_weights(table.aspect_ratios, aspect_ratio);
  const std::size_t block = table.torques.size() * table.stations.size() * table.angles.size();
  K_.assign(block, {});
  for (std::size_t i = 0; i < of_size.size(); ++i)
    for (std::size_t j = 0; j < of_shape.size(); ++j) {
      const double weight = of_size[i] * of_shape[j] * std::sqrt(size / table.sizes[i]);  // (GR-30)
      if (weight == 0) continue;
      const std::array<double, 3>* const from = table.K.data() + (i * of_shape.size() + j) * block;
      for (std::size_t k = 0; k < block; ++k)
        for (std::size_t mode = 0; mode < 3; ++mode) K_[k][mode] += weight * from[k][mode];
    }
}

std::vector<std::array<double, 3>> TurnFactors::at(std::size_t station, double torque) const {
  const std::vector<double>& T = table_.torques;
  if (!table_.covers(torque))
    throw InputError(
        table_.file,
        fmt::format("covers torques from {} to {}, but {} acts; compute K at this "
                    "torque too",
                    shown_quantity(T.front(), "N*m", 9), shown_quantity(T.back(), "N*m", 9),
                    shown_quantity(torque, "N*m", 9)));
  std::size_t i = 0;
  while (i + 2 < T.size() && torque > T[i + 1]) ++i;
  const std::size_t next = std::min(i + 1, T.size() - 1);
  const double share = next == i ? 0.0 : std::clamp((torque - T[i]) / (T[next] - T[i]), 0.0, 1.0);
  const std::size_t n = table_.angles.size();
  const auto* const below = K_.data() + (i * table_.stations.size() + station) * n;
  const auto* const above = K_.data() + (next * table_.stations.size() + station) * n;
  std::vector<std::array<double, 3>> turn(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (std::size_t mode = 0; mode < 3; ++mode)
      turn[k][mode] = (1 - share) * below[k][mode] + share * above[k][mode];  // (GR-30)
  return turn;
}

int waves_of(const TurnTable& table, int wave_number) {
  const double span = table.angles.back() - table.angles.front();
  return std::max(1, static_cast<int>(std::lround(span * wave_number / (2 * pi))));
}

TurnTable turn_table(std::span<const SizedTurn> sizes, std::vector<TurnCondition> conditions) {
  const std::string_view tip = governing_station(sizes)->tip;
  TurnTable table;
  table.conditions = std::move(conditions);
  table.size_name = sizes.front().depth ? "depth" : "half_length";
  for (const LoadedTurn& torque : sizes.front().torques) table.torques.push_back(torque.torque);
  for (const StationTurn& station : sizes.front().torques.front().stations) {
    if (station.tip != tip) continue;
    table.stations.push_back(station.station);
    if (!table.angles.empty()) continue;
    for (const TurnFactor& K : station.factors) table.angles.push_back(K.angle);
  }
  for (const SizedTurn& size : sizes) {
    table.sizes.push_back(size.depth.value_or(size.half_length));
    for (const LoadedTurn& torque : size.torques)
      for (const StationTurn& station : torque.stations)
        if (station.tip == tip)
          for (const TurnFactor& K : station.factors) table.K.push_back({K.K_I, K.K_II, K.K_III});
  }
  return table;
}

TurnRange turn_range(const TurnTable& table, double size, double aspect_ratio, double torque) {
  const TurnFactors turn(table, size, aspect_ratio);
  TurnRange widest;
  for (std::size_t i = 0; i < turn.stations(); ++i) {
    std::vector<TurnFactor> factors;
    for (const auto& [K_I, K_II, K_III] : turn.at(i, torque))
      factors.push_back({.angle = table.angles[factors.size()],
                         .K_I = std::max(K_I, 0.0),
                         .K_II = K_II,
                         .K_III = K_III});
    factors.push_back(factors.front());
    const TurnRange range = turn_range(factors);
    if (i == 0 || range.range > widest.range) widest = range;
  }
  return widest;
}

void check_turn_tables(const GearSet& gear) {
  for_each_crack_with_turn(gear, [&](const CrackPath& path, const auto& crack) {
    if (crack.turn_table) check_turn(gear, path, crack);
  });
}

}  // namespace strainwave

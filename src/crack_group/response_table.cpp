// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/response_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Width of the widest cell, in the logarithm of a half length [-].
constexpr double kWidest = 0.2;
constexpr int kMostHalvings = 3;
/// Least gap at the largest sizes of a cell, over the longer half length and the width of the cell.
/// The cracks touch where one of them has grown by the gap, so there the responses have their
/// nearest singular place.
constexpr double kGapOverWidth = 4.0;
/// Cells of about 130 kB that a table keeps; beyond them it begins again.
constexpr std::size_t kMostCells = 400;

double width_of(int halvings) { return kWidest / (1 << halvings); }

/// The entries of responses, one after another.
std::vector<double> entries_of(const std::vector<std::vector<CrackResponse>>& responses) {
  std::vector<double> entries;
  for (const std::vector<CrackResponse>& under : responses)
    for (const CrackResponse& of : under) {
      entries.insert(entries.end(), {of.behind.mode_1, of.behind.mode_2, of.ahead.mode_1,
                                     of.ahead.mode_2, of.opening, of.sliding});
      entries.insert(entries.end(), of.faces.begin(), of.faces.end());
      entries.insert(entries.end(), of.slid.begin(), of.slid.end());
    }
  return entries;
}

/// The responses of their entries.
/// @param points  on each crack
std::vector<std::vector<CrackResponse>> responses_of(const std::vector<double>& entries,
                                                     std::size_t stresses,
                                                     const std::vector<int>& points) {
  std::vector<std::vector<CrackResponse>> responses(stresses);
  auto next = entries.begin();
  for (std::vector<CrackResponse>& under : responses)
    for (const int n : points) {
      CrackResponse& of = under.emplace_back();
      for (double* const into : {&of.behind.mode_1, &of.behind.mode_2, &of.ahead.mode_1,
                                 &of.ahead.mode_2, &of.opening, &of.sliding})
        *into = *next++;
      of.faces.assign(next, next + (n - 1));
      next += n - 1;
      of.slid.assign(next, next + (n - 1));
      next += n - 1;
    }
  return responses;
}

/// Largest difference of two responses, over the largest entry of the same kind and crack.
double difference(const std::vector<std::vector<CrackResponse>>& one,
                  const std::vector<std::vector<CrackResponse>>& other) {
  double largest = 0.0;
  for (std::size_t j = 0; j < one.front().size(); ++j) {
    const auto compare = [&](const auto& entries) {
      double size = 0.0;
      double apart = 0.0;
      for (std::size_t s = 0; s < one.size(); ++s) {
        const std::vector<double> a = entries(one[s][j]);
        const std::vector<double> b = entries(other[s][j]);
        for (std::size_t i = 0; i < a.size(); ++i) {
          size = std::max(size, std::abs(a[i]));
          apart = std::max(apart, std::abs(a[i] - b[i]));
        }
      }
      if (apart > 0) largest = std::max(largest, apart / size);
    };
    compare([](const CrackResponse& of) {
      return std::vector{of.behind.mode_1, of.behind.mode_2, of.ahead.mode_1, of.ahead.mode_2};
    });
    compare([](const CrackResponse& of) { return std::vector{of.opening, of.sliding}; });
    compare([](const CrackResponse& of) { return of.faces; });
    compare([](const CrackResponse& of) { return of.slid; });
  }
  return largest;
}

}  // namespace

ResponseTable::ResponseTable(std::vector<FacedCrack> cracks, std::vector<SheetStress> stresses,
                             double period)
    : cracks_(std::move(cracks)), stresses_(std::move(stresses)), period_(period) {
  if (cracks_.size() != 2 || stresses_.empty())
    throw InputError("cracks", "must be two, under at least one stress");
}

std::vector<StraightCrack> ResponseTable::at_sizes(
    const std::array<double, 2>& half_lengths) const {
  std::vector<StraightCrack> places;
  for (std::size_t j = 0; j < 2; ++j) {
    places.push_back(cracks_[j].crack);
    places.back().half_length = half_lengths[j];
  }
  return places;
}

std::vector<std::vector<CrackResponse>> ResponseTable::direct(
    const std::array<double, 2>& half_lengths, const std::vector<int>& points) {
  std::vector<FacedCrack> cracks = cracks_;
  for (std::size_t j = 0; j < 2; ++j) cracks[j].crack.half_length = half_lengths[j];
  ++solved_;
  return group_response(cracks, stresses_, {.period = period_, .points = points});
}

std::optional<ResponseTable::Place> ResponseTable::place_of(
    const std::array<double, 2>& logarithms) const {
  for (int halvings = 0; halvings <= kMostHalvings; ++halvings) {
    const double width = width_of(halvings);
    const Place place = {halvings, static_cast<int>(std::floor(logarithms[0] / width)),
                         static_cast<int>(std::floor(logarithms[1] / width))};
    const std::vector<StraightCrack> largest =
        at_sizes({std::exp((place[1] + 1) * width), std::exp((place[2] + 1) * width)});
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < 2; ++j) gap = std::min(gap, nearest_crack(largest, j, period_).gap);
    if (gap >= kGapOverWidth * width) return place;
  }
  return std::nullopt;
}

std::vector<std::vector<CrackResponse>> ResponseTable::at(
    const std::array<double, 2>& half_lengths) {
  const std::array<double, 2> logarithms = {std::log(half_lengths[0]), std::log(half_lengths[1])};
  const std::optional<Place> place = place_of(logarithms);
  if (!place) return direct(half_lengths, {});
  auto found = cells_.find(*place);
  if (found == cells_.end()) {
    if (cells_.size() >= kMostCells) cells_.clear();
    found = cells_.emplace(*place, made(*place)).first;
  }
  const Cell& cell = found->second;
  if (cell.entries.empty()) return direct(half_lengths, {});
  return responses_of(interpolated(cell, *place, logarithms), stresses_.size(), cell.points);
}

ResponseTable::Cell ResponseTable::made(const Place& place) {
  const double width = width_of(place[0]);
  const auto size_at = [&](std::size_t j, double share) {
    return std::exp((place[j + 1] + share) * width);
  };
  const auto node = [](std::size_t i) {
    return (1 - std::cos((2 * static_cast<double>(i) + 1) * pi / (2 * kNodes))) / 2;
  };
  Cell cell;
  // All nodes have as many points as the largest cracks need, so that their faces are comparable.
  cell.points = response_points(at_sizes({size_at(0, 1), size_at(1, 1)}), period_);
  for (std::size_t i = 0; i < kNodes; ++i)
    for (std::size_t k = 0; k < kNodes; ++k) {
      const std::vector<double> entries =
          entries_of(direct({size_at(0, node(i)), size_at(1, node(k))}, cell.points));
      cell.entries.insert(cell.entries.end(), entries.begin(), entries.end());
    }
  // At the corners a polynomial through these nodes differs most.
  for (const std::array<double, 2>& share : {std::array{1.0, 1.0}, {0.0, 1.0}, {1.0, 0.0}}) {
    const std::array<double, 2> sizes = {size_at(0, share[0]), size_at(1, share[1])};
    const auto by_table =
        responses_of(interpolated(cell, place, {std::log(sizes[0]), std::log(sizes[1])}),
                     stresses_.size(), cell.points);
    if (difference(direct(sizes, cell.points), by_table) > kTolerance) {
      cell.entries.clear();
      break;
    }
  }
  return cell;
}

std::vector<double> ResponseTable::interpolated(const Cell& cell, const Place& place,
                                                const std::array<double, 2>& logarithms) const {
  // The barycentric formula of the Chebyshev points, along each half length; (CG-15).
  const auto weights_along = [&](std::size_t j) {
    std::array<double, kNodes> weights{};
    const double x = 2 * (logarithms[j] / width_of(place[0]) - place[j + 1]) - 1;
    double sum = 0.0;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const double angle = (2 * static_cast<double>(i) + 1) * pi / (2 * kNodes);
      const double apart = x + std::cos(angle);
      if (apart == 0) {
        weights = {};
        weights[i] = 1.0;
        return weights;
      }
      weights[i] = (i % 2 == 0 ? 1 : -1) * std::sin(angle) / apart;
      sum += weights[i];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
  };
  const std::array<double, kNodes> first = weights_along(0);
  const std::array<double, kNodes> second = weights_along(1);
  const std::size_t count = cell.entries.size() / (kNodes * kNodes);
  std::vector<double> entries(count, 0.0);
  const double* next = cell.entries.data();
  for (std::size_t i = 0; i < kNodes; ++i)
    for (std::size_t k = 0; k < kNodes; ++k, next += count) {
      const double weight = first[i] * second[k];  // (CG-15)
      for (std::size_t e = 0; e < count; ++e) entries[e] += weight * next[e];
    }
  return entries;
}

}  // namespace strainwave

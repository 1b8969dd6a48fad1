// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/torque_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/core/units.hpp"

// The tables as printed, in N*m: CSF/CSG component set catalogue of Harmonic Drive LLC, page 14.
// The rated lives stand there too: L10 7000 h of CSF and 10 000 h of CSG, L50 35 000 and 50 000 h.
// HFUC has 35 000 h (engineering data of Harmonic Drive SE); L10 is a fifth of it.

namespace strainwave {
namespace {

/// Ratcheting torques of one size at up to six ratios; 0: the table has no value.
struct Ratcheting {
  std::string_view series;
  int size;
  double buckling;
  double at[6];
};
constexpr int kRatios[6] = {30, 50, 80, 100, 120, 160};

// clang-format off
constexpr Ratcheting kTable[] = {
    // series size buckling  30     50     80    100    120    160
    {"CSF", 8,     35, {   11,    12,     0,    14,     0,     0}},
    {"CSF", 11,    90, {   29,    34,     0,    43,     0,     0}},
    {"CSF", 14,   190, {   59,    88,   110,    84,     0,     0}},
    {"CSF", 17,   330, {  100,   150,   200,   160,   120,     0}},
    {"CSF", 20,   560, {  170,   220,   350,   260,   240,   220}},
    {"CSF", 25,  1000, {  340,   450,   680,   500,   470,   450}},
    {"CSF", 32,  2200, {  720,   980,  1400,  1000,   980,   980}},
    {"CSF", 40,  4300, {    0,  1800,  2800,  2100,  1900,  1800}},
    {"CSF", 45,  5800, {    0,  2700,  3900,  3100,  2800,  2600}},
    {"CSF", 50,  8000, {    0,  3700,  5400,  4100,  3800,  3600}},
    {"CSF", 58, 12000, {    0,  5800,  8200,  6400,  5800,  5600}},
    {"CSF", 65, 17000, {    0,  7800, 11000,  9400,  8300,  8000}},
    {"CSF", 80, 31000, {    0, 14000, 22000, 16000, 15000, 14000}},
    {"CSF", 90, 45000, {    0, 20000, 30000, 23000, 21000, 20000}},
    {"CSF", 100, 58000, {   0, 29000, 44000, 33000, 30000, 28000}},
    {"CSG", 14,   260, {    0,   110,   140,   100,     0,     0}},
    {"CSG", 17,   500, {    0,   190,   260,   200,   150,     0}},
    {"CSG", 20,   800, {    0,   280,   450,   330,   310,   280}},
    {"CSG", 25,  1700, {    0,   580,   880,   650,   610,   580}},
    {"CSG", 32,  3500, {    0,  1200,  1800,  1300,  1200,  1200}},
    {"CSG", 40,  6700, {    0,  2300,  3600,  2700,  2400,  2300}},
};
// clang-format on

constexpr double kHour = 3600;
constexpr RatedLife kLives[] = {
    {.series = "CSF", .ten_percent = 7000 * kHour, .fifty_percent = 35000 * kHour},
    {.series = "CSG", .ten_percent = 10000 * kHour, .fifty_percent = 50000 * kHour},
    {.series = "HFUC", .ten_percent = 7000 * kHour, .fifty_percent = 35000 * kHour},
};

std::vector<TorqueLimitRow> all_rows() {
  std::vector<TorqueLimitRow> rows;
  for (const Ratcheting& of : kTable)
    for (std::size_t i = 0; i < std::size(kRatios); ++i)
      if (of.at[i] > 0)
        rows.push_back({.series = of.series,
                        .size = of.size,
                        .ratio = kRatios[i],
                        .ratcheting = of.at[i],
                        .buckling = of.buckling});
  return rows;
}

/// The maker's size of a pitch diameter, whole or not.
double size_of(double pitch_diameter) { return pitch_diameter / pitch_diameter_of(1); }

/// Two sizes or torques that a file may state with six digits are the same.
bool same(double a, double b) { return std::abs(a - b) <= 1e-5 * std::abs(b); }

/// The row of the ratings that is the drive's own; null if there is none.
const RatingRow* own_rating(const GearSet& gear) {
  if (!gear.rating || !gear.rating->rated_torque) return nullptr;
  const double size = size_of(gear.drive.pitch_diameter);
  const RatingRow* const row =
      same(std::round(size), size)
          ? find_rating(static_cast<int>(std::lround(size)), gear.drive.ratio)
          : nullptr;
  return row != nullptr && same(*gear.rating->rated_torque, row->rated) ? row : nullptr;
}

/// The nearest row of a ratio by the logarithm of the size; null unless the size lies between the
/// rows.
template <class Rows>
auto nearest_between(const Rows& rows, double size, double ratio, std::string_view series)
    -> decltype(&rows.front()) {
  decltype(&rows.front()) nearest = nullptr;
  bool below = false;
  bool above = false;
  const auto distance = [&](const auto& row) { return std::abs(std::log(row.size / size)); };
  for (const auto& row : rows) {
    if (row.ratio != ratio || (!series.empty() && row.series != series)) continue;
    below = below || row.size <= size;
    above = above || row.size >= size;
    if (nearest == nullptr || distance(row) < distance(*nearest)) nearest = &row;
  }
  return below && above ? nearest : nullptr;
}

void fill(std::optional<MakersLimit>& limit, double value, const std::string& origin,
          bool similar = false) {
  if (!limit) limit = {.value = value, .origin = origin, .similar = similar};
}

void fill_from_file(MakersLimits& limits, const Rating& rating) {
  const auto take = [](std::optional<MakersLimit>& limit, const std::optional<double>& given,
                       std::string_view name) {
    if (given) limit = {.value = *given, .origin = fmt::format("file: rating.{}", name)};
  };
  take(limits.average_torque, rating.average_torque, "average_torque");
  take(limits.repeated_peak, rating.repeated_peak, "repeated_peak");
  take(limits.momentary_peak, rating.momentary_peak, "momentary_peak");
  take(limits.ratcheting_torque, rating.ratcheting_torque, "ratcheting_torque");
  take(limits.buckling_torque, rating.buckling_torque, "buckling_torque");
  take(limits.largest_speed, rating.largest_speed, "largest_speed");
  take(limits.average_speed, rating.average_speed, "average_speed");
  take(limits.bearing_life, rating.bearing_life, "bearing_life");
  take(limits.rated_torque, rating.rated_torque, "rated_torque");
}

void fill_from_own_row(MakersLimits& limits, const RatingRow& row) {
  const std::string origin =
      fmt::format("catalogue: {} size {}, ratio {}", row.series, row.size, row.ratio);
  fill(limits.average_torque, row.average, origin);
  fill(limits.repeated_peak, row.repeated_peak, origin);
  fill(limits.momentary_peak, row.momentary_peak, origin);
  fill(limits.largest_speed, row.max_input_speed, origin);
  fill(limits.average_speed, row.average_input_speed, origin);
  fill(limits.rated_torque, row.rated, origin);
  if (const RatedLife* const life = find_rated_life(row.series))
    fill(limits.bearing_life, life->ten_percent, fmt::format("catalogue: series {}", row.series));
  if (const TorqueLimitRow* const of = find_torque_limits(row.series, row.size, row.ratio)) {
    fill(limits.ratcheting_torque, of->ratcheting, origin);
    fill(limits.buckling_torque, of->buckling, origin);
  }
}

void fill_by_similarity(MakersLimits& limits, const GearSet& gear) {
  const Transmission& drive = gear.drive;
  const double size = size_of(drive.pitch_diameter);
  const auto cube = [size](const auto& row) { return std::pow(size / row.size, 3); };
  const auto scaled = [&](std::optional<MakersLimit>& limit, const auto* row, auto torque,
                          double weaker = 1.0) {
    if (row == nullptr) return;
    fill(limit, weaker * (row->*torque) * cube(*row),  // (LI-30)
         fmt::format("similar: {} size {}, ratio {}, in proportion to d^3{}", row->series,
                     row->size, row->ratio, weaker < 1 ? " and to the rated torque" : ""),
         true);
  };
  const RatingRow* const rating = nearest_between(rating_rows(), size, drive.ratio, {});
  double weaker = 1.0;
  if (rating != nullptr && gear.rating && gear.rating->rated_torque)
    weaker = std::min(1.0, *gear.rating->rated_torque / (rating->rated * cube(*rating)));
  scaled(limits.average_torque, rating, &RatingRow::average, weaker);
  scaled(limits.repeated_peak, rating, &RatingRow::repeated_peak, weaker);
  scaled(limits.momentary_peak, rating, &RatingRow::momentary_peak, weaker);
  // The weaker series.
  const TorqueLimitRow* const row = nearest_between(torque_limit_rows(), size, drive.ratio, "CSF");
  scaled(limits.ratcheting_torque, row, &TorqueLimitRow::ratcheting);
  scaled(limits.buckling_torque, row, &TorqueLimitRow::buckling);
}

}  // namespace

std::span<const TorqueLimitRow> torque_limit_rows() {
  static const std::vector<TorqueLimitRow> rows = all_rows();
  return rows;
}

std::span<const RatedLife> rated_lives() { return kLives; }

const RatedLife* find_rated_life(std::string_view series) {
  const auto* const found = std::ranges::find(kLives, series, &RatedLife::series);
  return found == std::end(kLives) ? nullptr : found;
}

const TorqueLimitRow* find_torque_limits(std::string_view series, int size, double ratio) {
  const auto rows = torque_limit_rows();
  const auto found = std::ranges::find_if(rows, [&](const TorqueLimitRow& row) {
    return row.series == series && row.size == size && row.ratio == ratio;
  });
  return found == rows.end() ? nullptr : &*found;
}

MakersLimits makers_limits(const GearSet& gear) {
  MakersLimits limits;
  if (gear.rating) fill_from_file(limits, *gear.rating);
  if (const RatingRow* const own = own_rating(gear))
    fill_from_own_row(limits, *own);
  else
    fill_by_similarity(limits, gear);
  return limits;
}

}  // namespace strainwave

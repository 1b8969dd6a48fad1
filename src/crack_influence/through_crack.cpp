// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_influence/through_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/contact/one_sided.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "through_crack_data.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
constexpr std::size_t kShapes = FaceTractions::kShapes;
constexpr std::size_t kDirections = 3;
constexpr std::size_t kTractions = kDirections * kShapes;
constexpr std::size_t kModes = 3;

/// Reads words and numbers from the text of a table.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() {
    skip();
    return rest_.empty();
  }
  std::string_view word() {
    skip();
    const std::size_t end = std::min(rest_.find_first_of(" \n"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }
  void expect(std::string_view name) {
    if (const std::string_view found = word(); found != name)
      throw InputError("through_crack", fmt::format("must have \"{}\" in place of \"{}\"", name,
                                                    found.substr(0, 40)));
  }
  double number() {
    const std::string_view text = word();
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      throw InputError("through_crack", fmt::format("must have a finite number in place of \"{}\"",
                                                    text.substr(0, 40)));
    return value;
  }
  /// The numbers up to the end of the line.
  std::vector<double> line(std::string_view name) {
    expect(name);
    std::vector<double> numbers;
    while (!rest_.empty() && rest_.front() != '\n') numbers.push_back(number());
    return numbers;
  }

 private:
  void skip() {
    while (!rest_.empty()) {
      if (rest_.front() == '#')
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      else if (rest_.front() == ' ' || rest_.front() == '\n')
        rest_.remove_prefix(1);
      else
        break;
    }
  }
  std::string_view rest_;
};

/// Sign of a component under a reflection that turns the angle beta into -beta: tension and K_I
/// keep it, the shears, K_II and K_III change it.
double reflected(std::size_t component) { return component == 0 ? 1.0 : -1.0; }

/// Sign of a traction under half a turn about the radius through the middle of the crack.
double turned(std::size_t traction) {
  const bool odd_in_s = traction % kShapes / 2 == 1;
  const bool outward = traction / kShapes == 2;
  return odd_in_s != outward ? -1.0 : 1.0;
}

/// A value and the points of an axis that it is interpolated from.
struct AxisWeights {
  std::size_t first = 0;
  std::vector<double> weights;
};

/// Lagrange's polynomial through the nearest points, in the logarithm.
AxisWeights nearest_points(const std::vector<double>& points, double at) {
  const std::size_t count = std::min<std::size_t>(4, points.size());
  const auto above =
      static_cast<std::size_t>(std::ranges::upper_bound(points, at) - points.begin());
  AxisWeights axis;
  axis.first = std::min(above > count / 2 ? above - count / 2 : 0, points.size() - count);
  const double x = std::log(at);
  for (std::size_t i = 0; i < count; ++i) {
    double weight = 1;
    const double own = std::log(points[axis.first + i]);
    for (std::size_t j = 0; j < count; ++j)
      if (j != i) {
        const double other = std::log(points[axis.first + j]);
        weight *= (x - other) / (own - other);
      }
    axis.weights.push_back(weight);
  }
  return axis;
}

/// Sums of cosines (even) or sines of 2 k beta through the values at equal steps from 0 to 90
/// degrees.
std::vector<double> over_angles(std::size_t count, double angle, bool even) {
  const std::size_t steps = count - 1;
  std::vector<double> weights(count, 0.0);
  const auto ends = [steps](std::size_t k) { return k == 0 || k == steps ? 0.5 : 1.0; };
  for (std::size_t j = 0; j < count; ++j) {
    const double own = pi / 2 * static_cast<double>(j) / static_cast<double>(steps);
    for (std::size_t k = 0; k < count; ++k) {
      const double twice = 2 * static_cast<double>(k);
      if (even)
        weights[j] += 2.0 / static_cast<double>(steps) * ends(k) * ends(j) * std::cos(twice * own) *
                      std::cos(twice * angle);
      else if (k > 0 && k < steps)
        weights[j] +=
            2.0 / static_cast<double>(steps) * std::sin(twice * own) * std::sin(twice * angle);
    }
  }
  return weights;
}

std::vector<double> as_vector(const FaceTractions& tractions) {
  std::vector<double> loads;
  for (const auto& direction : {tractions.normal, tractions.along, tractions.outward})
    loads.insert(loads.end(), direction.begin(), direction.end());
  return loads;
}

}  // namespace

struct ThroughCrackTable::Parts {
  std::vector<double> stations;
  std::size_t along = 0;
  std::size_t across = 0;
  std::vector<double> half_lengths;
  std::vector<double> radii;
  std::size_t angles = 0;
  std::size_t half_places = 0;  ///< places whose gaps the table states
  std::size_t pairs = 0;        ///< pairs of places that the table states
  /// over half lengths, radii and angles: K, gap, pressed, one after the other
  std::vector<double> numbers;

  [[nodiscard]] std::size_t places() const { return along * across; }
  [[nodiscard]] std::size_t of_K() const {
    return stations.size() * kModes * (kTractions + places());
  }
  [[nodiscard]] std::size_t of_gap() const { return half_places * kTractions; }
  [[nodiscard]] std::size_t of_case() const { return of_K() + of_gap() + pairs; }
  [[nodiscard]] std::size_t mirrored(std::size_t place) const {
    return (along - 1 - place / across) * across + place % across;
  }
  /// Calls f for each pair of places that the table states, in its order.
  template <class F>
  void for_each_pair(const F& f) const {
    for (std::size_t i = 0; i < places(); ++i)
      for (std::size_t j = i; j < places(); ++j) {
        const auto [one, other] = std::minmax({mirrored(i), mirrored(j)});
        if (std::pair(i, j) <= std::pair(one, other)) f(i, j, one, other);
      }
  }
};

ThroughCrackTable::~ThroughCrackTable() = default;
ThroughCrackTable::ThroughCrackTable(ThroughCrackTable&&) noexcept = default;
ThroughCrackTable& ThroughCrackTable::operator=(ThroughCrackTable&&) noexcept = default;

ThroughCrackTable::ThroughCrackTable(std::string_view text) : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  Words words(text);
  words.expect("steps");
  const double steps = words.number();
  words.expect("poissons_ratio");
  (void)words.number();
  parts.stations = words.line("stations");
  parts.along = words.line("contact_along").size();
  parts.across = words.line("contact_across").size();
  parts.half_lengths = words.line("half_lengths");
  parts.radii = words.line("radii");
  const std::vector<double> angles = words.line("angles");
  parts.angles = angles.size();
  const auto rises = [](const std::vector<double>& axis) {
    return axis.size() >= 2 && axis.front() >= 0 &&
           std::ranges::adjacent_find(axis, std::greater_equal<>()) == axis.end();
  };
  bool equal_steps = rises(angles) && angles.front() == 0 && angles.back() == 90;
  for (std::size_t i = 0; i < angles.size(); ++i)
    equal_steps =
        equal_steps && std::abs(angles[i] - 90.0 * static_cast<double>(i) /
                                                static_cast<double>(angles.size() - 1)) < 1e-9;
  if (!(steps > 0) || !rises(parts.half_lengths) || !rises(parts.radii) || !equal_steps)
    throw InputError("through_crack",
                     "must have rising half_lengths and radii, and angles in equal steps from 0 to "
                     "90 degrees");
  for (std::size_t i = 0; i < parts.places(); ++i) parts.half_places += i <= parts.mirrored(i);
  parts.for_each_pair([&](auto...) { ++parts.pairs; });
  const std::size_t cases = parts.half_lengths.size() * parts.radii.size() * parts.angles;
  parts.numbers.reserve(cases * parts.of_case());
  for (const double half_length : parts.half_lengths)
    for (const double radius : parts.radii)
      for (const double angle : angles) {
        words.expect("case");
        for (const double expected : {half_length, radius, angle})
          if (words.number() != expected)
            throw InputError("through_crack", "must have its cases in the order of its axes");
        const auto block = [&](std::string_view name, std::size_t count) {
          words.expect(name);
          const double scale = words.number();
          for (std::size_t i = 0; i < count; ++i)
            parts.numbers.push_back(words.number() * (scale / steps));
        };
        block("K", parts.of_K());
        block("gap", parts.of_gap());
        block("pressed", parts.pairs);
      }
  if (!words.at_end()) throw InputError("through_crack", "has text behind its last case");
}

ThroughCrackResponse ThroughCrackTable::at(double half_length, double thickness, double mean_radius,
                                           double angle) const {
  const Parts& parts = *parts_;
  require(thickness > 0, "wall_thickness", thickness, "m", "> 0");
  const double a_t = half_length / thickness;
  const double R_t = mean_radius / thickness;
  constexpr double kRounding = 1e-12;
  require(a_t >= parts.half_lengths.front() * (1 - kRounding) &&
              a_t <= parts.half_lengths.back() * (1 + kRounding),
          "half_length", half_length, "m",
          fmt::format("from {:g} to {:g} walls", parts.half_lengths.front(),
                      parts.half_lengths.back()));
  require(R_t >= parts.radii.front() && R_t <= parts.radii.back(), "mean_radius", mean_radius, "m",
          fmt::format("from {:g} to {:g} walls", parts.radii.front(), parts.radii.back()));
  const AxisWeights by_length = nearest_points(parts.half_lengths, a_t);
  const AxisWeights by_radius = nearest_points(parts.radii, R_t);
  const std::vector<double> even = over_angles(parts.angles, angle, true);
  const std::vector<double> odd = over_angles(parts.angles, angle, false);

  std::vector<double> with_even(parts.of_case(), 0.0);
  std::vector<double> with_odd(parts.of_K() + parts.of_gap(), 0.0);
  for (std::size_t i = 0; i < by_length.weights.size(); ++i)
    for (std::size_t j = 0; j < by_radius.weights.size(); ++j)
      for (std::size_t k = 0; k < parts.angles; ++k) {
        const std::size_t number =
            ((by_length.first + i) * parts.radii.size() + by_radius.first + j) * parts.angles + k;
        const double* const from = &parts.numbers[number * parts.of_case()];
        const double weight = by_length.weights[i] * by_radius.weights[j];
        const double cosine = weight * even[k];
        const double sine = weight * odd[k];
        for (std::size_t n = 0; n < with_even.size(); ++n) with_even[n] += cosine * from[n];
        for (std::size_t n = 0; n < with_odd.size(); ++n) with_odd[n] += sine * from[n];
      }

  ThroughCrackResponse response;
  response.unit_ = std::sqrt(pi * half_length);
  response.across_ = parts.across;
  response.stations_ = parts.stations;
  const std::size_t places = parts.places();
  const std::size_t columns = kTractions + places;
  response.K_.resize(parts.of_K());
  for (std::size_t row = 0; row < parts.stations.size() * kModes; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t direction = column < kTractions ? column / kShapes : 0;
      const bool keeps = reflected(row % kModes) * reflected(direction) > 0;
      const std::size_t n = row * columns + column;
      response.K_[n] = keeps ? with_even[n] : with_odd[n];
    }
  response.gap_.resize(places * kTractions);
  std::size_t stated = 0;
  for (std::size_t place = 0; place < places; ++place) {
    const std::size_t mirror = parts.mirrored(place);
    if (place > mirror) continue;
    for (std::size_t column = 0; column < kTractions; ++column) {
      const std::size_t n = parts.of_K() + stated * kTractions + column;
      const double value = reflected(column / kShapes) > 0 ? with_even[n] : with_odd[n];
      response.gap_[place * kTractions + column] = value;
      if (mirror != place) response.gap_[mirror * kTractions + column] = turned(column) * value;
    }
    ++stated;
  }
  response.pressed_.resize(places * places);
  std::size_t n = parts.of_K() + parts.of_gap();
  parts.for_each_pair([&](std::size_t i, std::size_t j, std::size_t one, std::size_t other) {
    const double value = with_even[n++];
    response.pressed_[i * places + j] = response.pressed_[j * places + i] = value;
    response.pressed_[one * places + other] = response.pressed_[other * places + one] = value;
  });
  return response;
}

ThroughCrackState ThroughCrackResponse::factors(std::span<const double> loads,
                                                std::vector<double> pressure) const {
  const std::size_t places = pressure.size();
  const std::size_t columns = kTractions + places;
  std::vector<double> upper(loads.begin(), loads.end());
  std::vector<double> lower;
  for (std::size_t i = 0; i < kTractions; ++i) lower.push_back(turned(i) * loads[i]);
  upper.insert(upper.end(), pressure.begin(), pressure.end());
  for (std::size_t i = 0; i < places; ++i)
    lower.push_back(pressure[(places / across_ - 1 - i / across_) * across_ + i % across_]);
  ThroughCrackState state;
  state.pressure = std::move(pressure);
  for (std::size_t s = 0; s < stations_.size(); ++s) {
    StationModes of_upper{};
    StationModes of_lower{};
    for (std::size_t m = 0; m < kModes; ++m) {
      const double* const row = &K_[(s * kModes + m) * columns];
      for (std::size_t c = 0; c < columns; ++c) {
        of_upper[m] += unit_ * row[c] * upper[c];
        of_lower[m] += unit_ * row[c] * lower[c];
      }
    }
    state.upper.push_back(of_upper);
    state.lower.push_back(of_lower);
  }
  return state;
}

ThroughCrackState ThroughCrackResponse::state_without_contact(
    const FaceTractions& tractions) const {
  const std::size_t places = gap_.size() / kTractions;
  return factors(as_vector(tractions), std::vector<double>(places, 0.0));
}

ThroughCrackState ThroughCrackResponse::state(const FaceTractions& tractions,
                                              std::span<const double> start) const {
  const std::vector<double> loads = as_vector(tractions);
  const std::size_t places = gap_.size() / kTractions;
  std::vector<double> open(places, 0.0);
  for (std::size_t i = 0; i < places; ++i)
    for (std::size_t c = 0; c < kTractions; ++c) open[i] += gap_[i * kTractions + c] * loads[c];
  ThroughCrackState state = factors(loads, solve_one_sided(pressed_, open, start).pressure);
  for (auto* const front : {&state.upper, &state.lower})
    for (StationModes& K : *front) K[0] = std::max(K[0], 0.0);
  return state;
}

const ThroughCrackTable& through_crack_table() {
  static const ThroughCrackTable table(through_crack_data());
  return table;
}

}  // namespace strainwave

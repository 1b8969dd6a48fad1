// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/energy_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr int kMostSteps = 60;         // of Newton's method
constexpr double kMostSlope = 3.0;     // slope over that of the chord at which a cubic still rises
constexpr double kExactTwist = 4e-16;  // of the larger of twist and chord
constexpr int kChecksPerInterval = 3;  // points at which the sum is checked to rise

/// Solves m[q-1] + 4 m[q] + m[q+1] = right[q] round a circle of at least two points, by Sherman and
/// Morrison's formula.
std::vector<double> periodic_solution(const std::vector<double>& right) {
  const std::size_t n = right.size();
  if (n == 2)  // each point is twice the neighbour of the other
    return {(4 * right[0] - 2 * right[1]) / 12, (4 * right[1] - 2 * right[0]) / 12};
  std::vector<double> upper(n);
  std::vector<double> x(right);
  std::vector<double> u(n, 0.0);
  const double gamma = -4.0;
  u.front() = gamma;
  u.back() = 1.0;
  const auto diagonal = [&](std::size_t q) {
    return q == 0 ? 4.0 - gamma : q == n - 1 ? 4.0 - 1 / gamma : 4.0;
  };
  double pivot = diagonal(0);
  x[0] /= pivot;
  u[0] /= pivot;
  for (std::size_t q = 1; q < n; ++q) {
    upper[q - 1] = 1 / pivot;
    pivot = diagonal(q) - upper[q - 1];
    x[q] = (x[q] - x[q - 1]) / pivot;
    u[q] = (u[q] - u[q - 1]) / pivot;
  }
  for (std::size_t q = n - 1; q-- > 0;) {
    x[q] -= upper[q] * x[q + 1];
    u[q] -= upper[q] * u[q + 1];
  }
  const double share = (x.front() + x.back() / gamma) / (1 + u.front() + u.back() / gamma);
  for (std::size_t q = 0; q < n; ++q) x[q] -= share * u[q];
  return x;
}

/// Coefficients of the periodic cubic spline through even points, by interval, with the distance
/// from the left point over the step as the variable.
std::vector<std::array<double, 4>> periodic_spline(const std::vector<double>& value) {
  const std::size_t n = value.size();
  if (n == 1) return {{value[0], 0.0, 0.0, 0.0}};
  std::vector<double> right(n);
  for (std::size_t q = 0; q < n; ++q)
    right[q] = 6 * (value[(q + 1) % n] - 2 * value[q] + value[(q + n - 1) % n]);
  const std::vector<double> bend = periodic_solution(right);
  std::vector<std::array<double, 4>> made(n);
  for (std::size_t q = 0; q < n; ++q) {
    const std::size_t next = (q + 1) % n;
    made[q] = {value[q], value[next] - value[q] - (2 * bend[q] + bend[next]) / 6, bend[q] / 2,
               (bend[next] - bend[q]) / 6};
  }
  return made;
}

double cubic(const std::array<double, 4>& c, double x) {
  return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}
double cubic_slope(const std::array<double, 4>& c, double x) {
  return c[1] + x * (2 * c[2] + x * 3 * c[3]);
}

}  // namespace

std::vector<double> rising_slopes(const std::vector<double>& torques,
                                  const std::vector<double>& twist) {
  const std::size_t n = torques.size();
  if (n < 3 || twist.size() != n)
    throw InputError("torques", "must have at least 3 values, and one twist for each");
  std::vector<double> chord(n - 1);
  std::vector<double> h(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = torques[i + 1] - torques[i];
    chord[i] = (twist[i + 1] - twist[i]) / h[i];
  }
  // The natural spline: no third derivative of W at both ends.
  std::vector<double> diagonal(n);
  std::vector<double> slope(n);
  std::vector<double> upper(n - 1);
  diagonal[0] = 2;
  upper[0] = 1;
  slope[0] = 3 * chord[0];
  for (std::size_t i = 1; i < n; ++i) {
    const bool last = i + 1 == n;
    const double lower = last ? 1 : h[i];
    diagonal[i] = last ? 2 : 2 * (h[i - 1] + h[i]);
    if (!last) upper[i] = h[i - 1];
    slope[i] = last ? 3 * chord[i - 1] : 3 * (h[i] * chord[i - 1] + h[i - 1] * chord[i]);
    const double factor = lower / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    slope[i] -= factor * slope[i - 1];
  }
  slope[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;)
    slope[i] = (slope[i] - upper[i] * slope[i + 1]) / diagonal[i];
  // Between rising points a cubic rises if no slope is above three chords (MO-26).
  for (std::size_t i = 0; i < n; ++i) {
    double least = i > 0 ? chord[i - 1] : chord[0];
    if (i + 1 < n) least = std::min(least, chord[i]);
    if (least <= 0) continue;  // the caller is told by the sum
    slope[i] = std::clamp(slope[i], 0.0, kMostSlope * least);
  }
  return slope;
}

EnergyTable::EnergyTable(std::vector<double> torques, const std::vector<EnergySamples>& families,
                         double compliance)
    : torques_(std::move(torques)), compliance_(compliance) {
  if (torques_.size() < 3) throw InputError("torques", "must have at least 3 values");
  for (std::size_t n = 0; n < torques_.size(); ++n)
    require(std::isfinite(torques_[n]) && (n == 0 || torques_[n] > torques_[n - 1]), "torques",
            torques_[n], "N*m", "larger than the torque before");
  require(torques_.front() < 0, "torques", torques_.front(), "N*m", "a negative first torque");
  require(torques_.back() > 0, "torques", torques_.back(), "N*m", "a positive last torque");
  require(compliance >= 0 && std::isfinite(compliance), "compliance", compliance, "rad/(N*m)",
          ">= 0");
  if (families.empty() || families.size() > kMostFamilies)
    throw InputError("families", fmt::format("must be from 1 to {}", kMostFamilies));
  for (const EnergySamples& of : families) families_.push_back(family_of(of));
  for (const Family& of : families_)
    if (of.angles > 1)
      points_per_turn_ =
          std::max(points_per_turn_, std::abs(of.rate) * 2 * std::numbers::pi / of.step);
  require_rising();
}

EnergyTable::Family EnergyTable::family_of(const EnergySamples& samples) const {
  const std::size_t count = torques_.size();
  const std::size_t angles = samples.angles();
  require(std::isfinite(samples.rate), "rate", samples.rate, "1", "a finite number");
  require(samples.period > 0 && std::isfinite(samples.period), "period", samples.period, "rad",
          "> 0");
  if (angles == 0 || samples.twist.size() != angles * count ||
      samples.compliance.size() != angles * count)
    throw InputError("twist", "must have one value for each angle and each torque");
  const auto finite = [](const std::vector<double>& values, const char* name, const char* unit) {
    for (const double v : values) require(std::isfinite(v), name, v, unit, "a finite number");
  };
  finite(samples.energy, "energy", "J");
  finite(samples.twist, "twist", "rad");
  finite(samples.compliance, "compliance", "rad/(N*m)");
  Family family{.rate = samples.rate,
                .step = samples.period / static_cast<double>(angles),
                .angles = angles,
                .cells = {}};
  // W, its derivatives at the nodes, and with them all coefficients depend linearly on the samples,
  // so each coefficient of the torque is a spline over the angle (MO-26).
  const auto anchor =
      static_cast<std::size_t>(std::ranges::upper_bound(torques_, 0.0) - torques_.begin());
  family.cells.resize((count + 1) * angles);
  std::array<std::vector<double>, 5> a;
  for (auto& of : a) of.resize(angles);
  // Sets the powers of the interval from a node on; the energy of the node is in a[0].
  const auto rise_from = [&](std::size_t node, bool beyond) {
    const double h = beyond ? 1.0 : torques_[node + 1] - torques_[node];
    for (std::size_t q = 0; q < angles; ++q) {
      const std::size_t at = q * count + node;
      const double phi = samples.twist[at];
      const double slope = samples.compliance[at];
      a[1][q] = phi;
      a[2][q] = slope / 2;
      a[3][q] = a[4][q] = 0.0;
      if (beyond) continue;
      const double next = samples.compliance[at + 1];
      const double chord = (samples.twist[at + 1] - phi) / h;
      a[3][q] = (3 * chord - 2 * slope - next) / (3 * h);  // (MO-26)
      a[4][q] = (slope + next - 2 * chord) / (4 * h * h);  // (MO-26)
    }
  };
  const auto rise_of = [&](std::size_t node, std::size_t q) {
    const double h = torques_[node + 1] - torques_[node];
    return h * (a[1][q] + h * (a[2][q] + h * (a[3][q] + h * a[4][q])));
  };
  // Interval 0 ends at the first node, and interval n > 0 begins at node n - 1.
  const auto keep = [&](std::size_t interval) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      const auto spline = periodic_spline(a[j]);
      for (std::size_t q = 0; q < angles; ++q) family.cells[interval * angles + q][j] = spline[q];
    }
  };
  a[0] = samples.energy;
  for (std::size_t node = anchor; node < count; ++node) {
    rise_from(node, node + 1 == count);
    keep(node + 1);
    if (node + 1 < count)
      for (std::size_t q = 0; q < angles; ++q) a[0][q] += rise_of(node, q);
  }
  a[0] = samples.energy;
  for (std::size_t node = anchor; node-- > 0;) {
    rise_from(node, false);
    for (std::size_t q = 0; q < angles; ++q) a[0][q] -= rise_of(node, q);
    keep(node + 1);
  }
  rise_from(0, true);
  keep(0);
  return family;
}

void EnergyTable::require_rising() const {
  // The least compliance of each family over its angles, at points inside each interval, is a lower
  // bound of the sum at any angles.
  for (std::size_t interval = 1; interval < torques_.size(); ++interval) {
    const double h = torques_[interval] - torques_[interval - 1];
    for (int k = 0; k <= kChecksPerInterval; ++k) {
      const double t = h * k / kChecksPerInterval;
      double sum = compliance_;
      for (const Family& of : families_) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t q = 0; q < of.angles; ++q) {
          const Cell& c = of.cells[interval * of.angles + q];
          least = std::min(least, 2 * c[2][0] + t * (6 * c[3][0] + t * 12 * c[4][0]));
        }
        sum += least;
      }
      if (!(sum > 0))
        throw SolverError(fmt::format(
            "at {:.4g} N*m the twist of the computed curve does not rise with the torque at every "
            "angle (MO-26), because the lobe gap or the cracks are too large",
            torques_[interval - 1] + t));
    }
  }
}

EnergyTable::Slice EnergyTable::at(double input_angle) const {
  std::array<double, kMostFamilies> angles{};
  for (std::size_t k = 0; k < families_.size(); ++k) angles[k] = families_[k].rate * input_angle;
  return at_angles(angles);
}

EnergyTable::Slice EnergyTable::at_angles(const std::array<double, kMostFamilies>& angles) const {
  Slice slice;
  slice.table_ = this;
  for (std::size_t k = 0; k < families_.size(); ++k) {
    const Family& of = families_[k];
    if (of.angles == 1) continue;
    const auto count = static_cast<double>(of.angles);
    double x = angles[k] / of.step;
    x -= count * std::floor(x / count);
    const auto cell = std::min(static_cast<std::size_t>(std::max(x, 0.0)), of.angles - 1);
    slice.cell_[k] = cell;
    slice.in_cell_[k] = x - static_cast<double>(cell);
  }
  return slice;
}

EnergyTable::At EnergyTable::Slice::Piece::at(double torque) const {
  const double t = torque - from;
  const auto sum = [&](const std::array<double, 5>& c) {
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
  };
  const auto slope = [&](const std::array<double, 5>& c) {
    return c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4]));
  };
  return {.torque = torque,
          .twist = slope(a),
          .compliance = 2 * a[2] + t * (6 * a[3] + t * 12 * a[4]),
          .energy = sum(a),
          .by_input = sum(by_input),
          .twist_by_input = slope(by_input)};
}

EnergyTable::Slice::Piece EnergyTable::Slice::piece(std::size_t interval, double in_series) const {
  const auto& torques = table_->torques_;
  Piece made{.from = torques[interval == 0 ? 0 : interval - 1],
             .least = -std::numeric_limits<double>::infinity(),
             .most = std::numeric_limits<double>::infinity()};
  if (interval > 0) made.least = torques[interval - 1];
  if (interval < torques.size()) made.most = torques[interval];
  for (std::size_t k = 0; k < table_->families_.size(); ++k) {
    const Family& of = table_->families_[k];
    const Cell& cell = of.cells[interval * of.angles + cell_[k]];
    const double x = in_cell_[k];
    const double turn = of.rate / of.step;
    for (std::size_t j = 0; j < made.a.size(); ++j) {
      made.a[j] += cubic(cell[j], x);
      made.by_input[j] += turn * cubic_slope(cell[j], x);
    }
  }
  const double more = table_->compliance_ + in_series;
  made.a[0] += more * made.from * made.from / 2;
  made.a[1] += more * made.from;
  made.a[2] += more / 2;
  return made;
}

double EnergyTable::Slice::twist_at_node(std::size_t node, double in_series) const {
  double sum = (table_->compliance_ + in_series) * table_->torques_[node];
  for (std::size_t k = 0; k < table_->families_.size(); ++k) {
    const Family& of = table_->families_[k];
    sum += cubic(of.cells[(node + 1) * of.angles + cell_[k]][1], in_cell_[k]);
  }
  return sum;
}

EnergyTable::Slice::Piece EnergyTable::Slice::piece_at(double torque, double in_series) const {
  const auto& torques = table_->torques_;
  const auto next = std::ranges::upper_bound(torques, torque);
  return piece(static_cast<std::size_t>(next - torques.begin()), in_series);
}

EnergyTable::At EnergyTable::Slice::at_torque(double torque, double in_series) const {
  return piece_at(torque, in_series).at(torque);
}

EnergyTable::At EnergyTable::Slice::at_twist(double twist, double in_series) const {
  const auto& torques = table_->torques_;
  // The number of nodes whose twist is at most that which is asked.
  std::size_t low = 0;
  std::size_t high = torques.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (twist_at_node(middle, in_series) <= twist)
      low = middle + 1;
    else
      high = middle;
  }
  const Piece here = piece(low, in_series);
  if (low == 0 || low == torques.size())
    return here.at(here.from + (twist - here.a[1]) / (2 * here.a[2]));  // constant compliance
  double below = torques[low - 1];
  double above = torques[low];
  const double scale = std::abs(twist) + std::abs(here.at(above).twist - here.a[1]);
  double torque = below + (above - below) / 2;
  At at;
  for (int step = 0; step < kMostSteps; ++step) {
    at = here.at(torque);
    const double missing = twist - at.twist;
    if (std::abs(missing) <= kExactTwist * scale) break;
    (missing > 0 ? below : above) = torque;
    double next = torque + missing / at.compliance;
    if (!(next >= below && next <= above)) next = below + (above - below) / 2;
    if (next == torque) break;
    torque = next;
  }
  return at;
}

}  // namespace strainwave

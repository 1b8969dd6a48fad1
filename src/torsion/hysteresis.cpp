// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/hysteresis.hpp"

// pchip.hpp of Boost 1.74 calls ::isnan, which <cmath> does not have to declare.
#include <math.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <array>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
struct Hysteresis::Envelopes {
  using Pchip = boost::math::interpolators::pchip<std::vector<double>>;

  /// Twist without friction and friction width over the magnitude of the torque, for one sense.
  struct Branch {
    Pchip twist;
    Pchip flanks;
    Pchip outer_ring;
  };

  double largest = 0.0;
  double friction_torque = 0.0;
  int elements = 0;
  Branch positive;
  Branch negative;

  [[nodiscard]] const Branch& of(double torque) const { return torque < 0 ? negative : positive; }
  /// Middle of the envelopes, the twist without friction.
  [[nodiscard]] double middle(double torque) const { return of(torque).twist(std::abs(torque)); }
  [[nodiscard]] FrictionWidth width(double torque) const {
    const double size = std::abs(torque);
    return {.flanks = of(torque).flanks(size), .outer_ring = of(torque).outer_ring(size)};
  }
};

Hysteresis::Hysteresis(const AssembledDrive& drive, double largest_torque,
                       const HysteresisOptions& options, const Progress& progress) {
  require(largest_torque > 0 && std::isfinite(largest_torque), "largest_torque", largest_torque,
          "N*m", "> 0");
  require(options.elements >= 1, "elements", options.elements, "1", ">= 1");
  require(options.grid >= 8, "grid", options.grid, "1", ">= 8");
  const Rating rating = drive.gear().rating.value_or(Rating{});
  require(rating.friction_torque < largest_torque, "rating.friction_torque", rating.friction_torque,
          "N*m", "less than the torque of the loop");
  std::vector<double> grid = {0.0};
  for (int i = 1; i <= options.grid; ++i) {
    const double share = static_cast<double>(i) / options.grid;
    grid.push_back(largest_torque * share *
                   share);  // more points there, because the curve is steep at the origin
  }
  const auto branch = [&](double sense, const Progress& part) {
    std::vector<double> torques = grid;
    for (double& torque : torques) torque *= sense;
    SlidingCurve curve = sliding_curve(drive, torques, part);
    std::vector<double> flanks;
    std::vector<double> outer_ring;
    for (const FrictionWidth& width : curve.width) {
      flanks.push_back(width.flanks);
      outer_ring.push_back(width.outer_ring);
    }
    const auto over_torque = [&](std::vector<double> values) {
      return Envelopes::Pchip(std::vector(grid), std::move(values));
    };
    return Envelopes::Branch{over_torque(std::move(curve.twist)), over_torque(std::move(flanks)),
                             over_torque(std::move(outer_ring))};
  };
  envelopes_ = std::make_unique<Envelopes>(Envelopes{
      .largest = largest_torque,
      .friction_torque = rating.friction_torque,
      .elements = options.elements,
      .positive = branch(+1, progress.part(0.0, 0.5)),
      .negative = branch(-1, progress.part(0.5, 1.0)),
  });
}

Hysteresis::~Hysteresis() = default;
Hysteresis::Hysteresis(Hysteresis&&) noexcept = default;
Hysteresis& Hysteresis::operator=(Hysteresis&&) noexcept = default;

double Hysteresis::rising(double torque) const {
  return envelopes_->middle(torque) - envelopes_->width(torque).total() / 2;
}
double Hysteresis::falling(double torque) const {
  return envelopes_->middle(torque) + envelopes_->width(torque).total() / 2;
}

LossAtZero Hysteresis::loss_at_zero() const {
  const Envelopes& e = *envelopes_;
  LossAtZero loss;
  for (const double sense : {+1.0, -1.0}) {
    const double at = sense * e.friction_torque;
    const FrictionWidth width = e.width(at);
    loss.flanks += width.flanks / 2;
    loss.outer_ring += width.outer_ring / 2;
    loss.output += sense * e.middle(at);  // (TC-17)
  }
  return loss;
}

HysteresisMemory Hysteresis::at_rest() const {
  return {.play = std::vector<double>(static_cast<std::size_t>(envelopes_->elements), 0.0)};
}

void Hysteresis::slide(HysteresisMemory& memory, double elastic_torque) const {
  const Envelopes& e = *envelopes_;
  memory.elastic_torque = elastic_torque;
  const double at = std::clamp(elastic_torque, -e.largest, e.largest);
  const double middle = e.middle(at);
  const double half = e.width(at).total() / 2;
  double sum = 0.0;
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    const double threshold = 2 * (static_cast<double>(k) + 0.5) / e.elements;
    double& play = memory.play[k];
    play = std::clamp(play, middle - threshold * half, middle + threshold * half);
    sum += play;  // (TC-17)
  }
  memory.twist = sum / e.elements;
}

double Hysteresis::advance(HysteresisMemory& memory, double torque) const {
  const Envelopes& e = *envelopes_;
  require(std::abs(torque) <= e.largest * (1 + 1e-12), "torque", torque, "N*m",
          "within the largest torque of the envelopes");
  // (TC-17): the friction torque of seals and output bearing does not reach the flanks.
  slide(memory,
        std::clamp(memory.elastic_torque, torque - e.friction_torque, torque + e.friction_torque));
  memory.torque = torque;
  return memory.twist;
}

double Hysteresis::advance_to_twist(HysteresisMemory& memory, double twist) const {
  const Envelopes& e = *envelopes_;
  if (twist == memory.twist) return memory.torque;
  const double sense = twist > memory.twist ? 1.0 : -1.0;
  // (TC-17): the twist does not fall while T* rises.
  const auto missing = [&](double elastic_torque) {
    HysteresisMemory moved = memory;
    slide(moved, elastic_torque);
    return moved.twist - twist;
  };
  const double end = sense * (e.largest - e.friction_torque);
  require(sense * missing(end) >= 0, "twist", twist, "rad",
          "within the twists of the envelopes at their largest torque");
  slide(memory, bracketed_root(missing, std::min(memory.elastic_torque, end),
                               std::max(memory.elastic_torque, end)));
  memory.twist = twist;
  memory.torque = memory.elastic_torque + sense * e.friction_torque;
  return memory.torque;
}

std::vector<double> Hysteresis::twist(std::span<const double> path) const {
  HysteresisMemory memory = at_rest();
  std::vector<double> twist;
  twist.reserve(path.size());
  for (const double torque : path) twist.push_back(advance(memory, torque));
  return twist;
}

HysteresisLoop hysteresis_loop(const Hysteresis& hysteresis, double amplitude,
                               int points_per_branch) {
  require(amplitude > 0 && std::isfinite(amplitude), "amplitude", amplitude, "N*m", "> 0");
  require(points_per_branch >= 4, "points_per_branch", points_per_branch, "1", ">= 4");
  // Use an odd number of evenly spaced torques, so zero is one of them in both directions.
  const int n = points_per_branch / 2 * 2;
  std::vector<double> path = {amplitude};
  for (int i = 1; i <= n; ++i) path.push_back(amplitude * (1 - 2.0 * i / n));
  for (int i = 1; i <= n; ++i) path.push_back(amplitude * (2.0 * i / n - 1));
  HysteresisLoop loop{.torque = path, .twist = hysteresis.twist(path), .amplitude = amplitude};
  const auto down = [&](int i) { return loop.twist[static_cast<std::size_t>(i)]; };
  const auto up = [&](int i) { return loop.twist[static_cast<std::size_t>(2 * n - i)]; };
  for (int i = 0; i <= n; ++i) {
    const double width = down(i) - up(i);
    if (i == n / 2) loop.width_at_zero = width;
    if (width > loop.largest_width) {
      loop.largest_width = width;
      loop.torque_of_largest_width = std::abs(path[static_cast<std::size_t>(i)]);
    }
    if (i > 0) loop.lost_energy += (width + down(i - 1) - up(i - 1)) / 2 * (2 * amplitude / n);
  }
  return loop;
}

double lost_motion(const AssembledDrive& drive) {
  const double torque = makers_torques(drive.gear()).lost_motion;
  double sum = 0.0;
  for (const double sense : {+1.0, -1.0})
    sum += std::abs(twists(drive, std::array{sense * torque})[0]);  // (TC-18)
  return sum;
}

}  // namespace strainwave

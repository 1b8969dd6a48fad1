// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/hysteresis.hpp"

// pchip.hpp of Boost 1.74 calls ::isnan, which <cmath> does not have to declare.
#include <math.h>  // NOLINT(modernize-deprecated-headers)

#include <algorithm>
#include <array>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {
struct Hysteresis::Envelopes {
  /// A monotonic curve through the origin over the magnitude of the torque.
  class Branch {
   public:
    Branch(std::vector<double> torque, std::vector<double> twist)
        : curve_(std::move(torque), std::move(twist)) {}
    [[nodiscard]] double operator()(double torque) const { return curve_(torque); }

   private:
    boost::math::interpolators::pchip<std::vector<double>> curve_;
  };

  double largest = 0.0;
  double friction_torque = 0.0;
  int elements = 0;
  Branch loading_positive;
  Branch unloading_positive;
  Branch loading_negative;
  Branch unloading_negative;

  /// Twist with slip on all flanks while the torque grows in size, (TC-16).
  [[nodiscard]] double loading(double torque) const {
    return torque < 0 ? -loading_negative(-torque) : loading_positive(torque);
  }
  [[nodiscard]] double unloading(double torque) const {
    return torque < 0 ? -unloading_negative(-torque) : unloading_positive(torque);
  }
  /// Twist with slip on all flanks while the torque rises or falls; the order of both curves does
  /// not change.
  [[nodiscard]] double rising(double torque) const {
    return torque < 0 ? unloading(torque) : loading(torque);
  }
  [[nodiscard]] double sinking(double torque) const {
    return torque < 0 ? loading(torque) : unloading(torque);
  }
};

Hysteresis::Hysteresis(const SlidingDrive& drive, double largest_torque,
                       const HysteresisOptions& options, const Progress& progress) {
  require(largest_torque > 0 && std::isfinite(largest_torque), "largest_torque", largest_torque,
          "N*m", "> 0");
  require(options.elements >= 1, "elements", options.elements, "1", ">= 1");
  require(options.grid >= 8, "grid", options.grid, "1", ">= 8");
  const Rating rating = drive.loading.gear().rating.value_or(Rating{});
  require(rating.friction_torque < largest_torque, "rating.friction_torque", rating.friction_torque,
          "N*m", "less than the torque of the loop");
  std::vector<double> grid = {0.0};
  for (int i = 1; i <= options.grid; ++i) {
    const double share = static_cast<double>(i) / options.grid;
    grid.push_back(largest_torque * share *
                   share);  // more points there, because the curve is steep at the origin
  }
  int solved = 0;
  const auto branch = [&](double sense, const AssembledDrive& sliding) {
    std::vector<double> torques;
    for (std::size_t i = 1; i < grid.size(); ++i) torques.push_back(sense * grid[i]);
    std::vector<double> twist = {0.0};
    for (const double solution :
         twists(sliding, torques, progress.part(0.25 * solved, 0.25 * (solved + 1))))
      twist.push_back(sense * solution);
    ++solved;
    return Envelopes::Branch(grid, std::move(twist));
  };
  envelopes_ = std::make_unique<Envelopes>(Envelopes{
      .largest = largest_torque,
      .friction_torque = rating.friction_torque,
      .elements = options.elements,
      .loading_positive = branch(+1, drive.loading),
      .unloading_positive = branch(+1, drive.unloading),
      .loading_negative = branch(-1, drive.loading),
      .unloading_negative = branch(-1, drive.unloading),
  });
}

Hysteresis::~Hysteresis() = default;
Hysteresis::Hysteresis(Hysteresis&&) noexcept = default;
Hysteresis& Hysteresis::operator=(Hysteresis&&) noexcept = default;

double Hysteresis::loading(double torque) const { return envelopes_->loading(torque); }
double Hysteresis::unloading(double torque) const { return envelopes_->unloading(torque); }

std::vector<double> Hysteresis::twist(std::span<const double> path) const {
  const Envelopes& e = *envelopes_;
  std::vector<double> play(static_cast<std::size_t>(e.elements), 0.0);
  double elastic_torque = 0.0;
  std::vector<double> twist;
  twist.reserve(path.size());
  for (const double torque : path) {
    require(std::abs(torque) <= e.largest * (1 + 1e-12), "torque", torque, "N*m",
            "within the largest torque of the envelopes");
    // (TC-17): the friction torque of seal and bearings does not reach the flanks.
    elastic_torque =
        std::clamp(elastic_torque, torque - e.friction_torque, torque + e.friction_torque);
    const double at = std::clamp(elastic_torque, -e.largest, e.largest);
    const double low = e.rising(at);
    const double high = e.sinking(at);
    const double middle = (low + high) / 2;
    const double half = (high - low) / 2;
    double sum = 0.0;
    for (std::size_t k = 0; k < play.size(); ++k) {
      const double threshold = 2 * (static_cast<double>(k) + 0.5) / e.elements;
      play[k] = std::clamp(play[k], middle - threshold * half, middle + threshold * half);
      sum += play[k];  // (TC-17)
    }
    twist.push_back(sum / e.elements);
  }
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

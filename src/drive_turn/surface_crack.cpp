// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sound_wall.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/sif/kassir_sih.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Limits of Newman and Raju's equation (FR-4).
constexpr double kDeepest = 0.8;
constexpr double kLongest = 0.2;

/// Stations of each half of the front, from the surface to the deepest point.
constexpr std::size_t kStations = 5;
double angle_of(std::size_t station) {
  return pi / 2 * static_cast<double>(station) / (kStations - 1);
}

/// Effect of a stress that grows in proportion to the distance from the middle, over that of the
/// stress at the station itself: 2/3 for a penny-shaped crack (IN-3).
constexpr double kOfSlope = 2.0 / 3.0;

/// Effect of a stress x/a, with x the depth, over that of an even stress: that of |x|/a on a
/// penny-shaped crack, to the fourth wave round its front (IN-3).
double of_depth(double phi) { return 0.5 - std::cos(2 * phi) / 4 - std::cos(4 * phi) / 24; }

class TurningSurfaceCrack : public TurningCrack {
 public:
  TurningSurfaceCrack(double thickness, double poissons_ratio, double depth, double half_length,
                      bool inner, SoundWall wall)
      : depth_(depth),
        alpha_(depth / thickness),
        mouth_(inner ? -1.0 : 1.0),
        plate_(depth / half_length),
        sheared_(depth / half_length, poissons_ratio),
        wall_(std::move(wall)) {}

  /// `at` takes the stress at these offsets: that of the middle, then those of the stations of
  /// both halves [m].
  [[nodiscard]] static std::vector<double> offsets(double half_length) {
    std::vector<double> offsets = {0.0};
    for (const double side : {1.0, -1.0})
      for (std::size_t i = 0; i < kStations; ++i)
        offsets.push_back(side * half_length * std::cos(angle_of(i)));
    return offsets;
  }

  [[nodiscard]] std::vector<double> stations() const override {
    std::vector<double> sines;
    for (std::size_t i = 0; i < kStations; ++i) sines.push_back(std::sin(angle_of(i)));
    sines.back() = 1;
    return sines;
  }
  [[nodiscard]] std::vector<StationFactors> at(double from_lobe, double torque) override {
    const double root = std::sqrt(pi * depth_);
    const Through middle = through(0, from_lobe, torque);
    std::vector<StationFactors> K;
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 0; i < kStations; ++i) {
        const double phi = angle_of(i);
        const Through here = through(1 + half * kStations + i, from_lobe, torque);
        const auto mean = [&](double Through::*part) {
          return middle.*part + kOfSlope * (here.*part - middle.*part);
        };
        const double tension = plate_.tension(alpha_, phi) * root;
        const double opening =
            tension * (mean(&Through::membrane) +
                       mean(&Through::bending) * plate_.bending_ratio(alpha_, phi));
        const double shear =
            (mean(&Through::shear) + mean(&Through::shear_slope) * alpha_ * of_depth(phi)) * root;
        // The tangent of the front leads from one tip to the other, so K_II changes its sign on
        // the way; the frame of an inner mouth is that of an outer one, turned about the crack.
        const double tip = half == 0 ? 1.0 : -1.0;
        K.push_back({std::max(opening, 0.0), -mouth_ * tip * shear * sheared_.factor_II(phi),
                     mouth_ * shear * sheared_.factor_III(phi)});
      }
    return K;
  }
  [[nodiscard]] double largest_stress(double from_lobe, double torque) const override {
    const Through middle = through(0, from_lobe, torque);
    return std::abs(middle.membrane) + std::abs(middle.bending);
  }

 private:
  /// The stress through the wall at one place [Pa].
  struct Through {
    double membrane;
    double bending;      ///< at the surface of the mouth
    double shear;        ///< along the crack, at the surface of the mouth
    double shear_slope;  ///< its change through the wall
  };
  [[nodiscard]] Through through(std::size_t offset, double from_lobe, double torque) const {
    const PlaneStress mouth = wall_.at(offset, mouth_, from_lobe, torque);
    const PlaneStress other = wall_.at(offset, -mouth_, from_lobe, torque);
    return {.membrane = (mouth.normal + other.normal) / 2,
            .bending = (mouth.normal - other.normal) / 2,
            .shear = mouth.along,
            .shear_slope = other.along - mouth.along};
  }

  double depth_;
  double alpha_;
  double mouth_;  ///< zeta of the surface from which the crack starts
  sif::NewmanRajuPlate plate_;
  sif::KassirSih sheared_;
  SoundWall wall_;
};

}  // namespace

std::unique_ptr<TurningCrack> turning_crack(const WallSurfaceCrack& crack, const OvalShell& shell,
                                            double place, const TurnSize& size) {
  const double depth = size.depth.value();
  const double half_length = size.half_length;
  const bool in_rim = crack.section == WallSection::rim;
  const double thickness = (in_rim ? shell.cup.rim : shell.cup.barrel).wall_thickness;
  require(depth > 0 && depth <= kDeepest * thickness, "depth", depth, "m",
          "> 0 and <= 0.8 of the wall");
  require(crack.depth <= crack.half_length && crack.depth >= kLongest * crack.half_length,
          "half_length", half_length, "m", "from 1 to 5 depths");
  return std::make_unique<TurningSurfaceCrack>(
      thickness, shell.cup.poissons_ratio, depth, half_length, crack.mouth == Mouth::inner,
      SoundWall(shell, in_rim ? WallPart::rim : WallPart::barrel, place, crack.angle,
                TurningSurfaceCrack::offsets(half_length)));
}

}  // namespace strainwave

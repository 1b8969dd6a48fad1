// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/deviations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Number of an entry that repeats after `count` entries.
std::size_t around(int number, std::size_t count) {
  const int n = static_cast<int>(count);
  return static_cast<std::size_t>((number % n + n) % n);
}

/// Deviations of one flank of the flexspline and of the flank that it presses, toward each other
/// along the pitch circle [m].
/// @param tooth  tooth of the flexspline
/// @param space  space of the circular spline; its tooth `space` lies ahead
double approach(const Deviations& of, int tooth, int space, int side) {
  double sum = 0.0;
  if (!of.flexspline.empty()) {
    const ToothDeviation& own = of.flexspline[around(tooth, of.flexspline.size())];
    sum += side * own.position + own.thickness / 2;
  }
  if (!of.spline.empty()) {
    const ToothDeviation& met = of.spline[around(side > 0 ? space : space - 1, of.spline.size())];
    sum += -side * met.position + met.thickness / 2;
  }
  return sum;
}

/// Lobe nearest to a tooth: 0, 1 for the one at pi, 2 after the whole turn.  The circular spline
/// has one space more than the flexspline has teeth up to each further lobe.
int lobe_of(int tooth, int teeth) {
  return static_cast<int>(std::lround((tooth + 0.5) * 2 / teeth));
}

}  // namespace

double single_pitch_limit(int grade, double pitch_diameter, double module) {
  constexpr double kMicron = 1e-6;
  return (0.001 * pitch_diameter / units::mm + 0.4 * module / units::mm + 5) *
         std::pow(std::numbers::sqrt2, grade - 5) * kMicron;  // (TC-36)
}

DeviationLimits deviation_limits(const GearSet& gear) {
  const Tolerance tolerance = gear.tolerance.value_or(Tolerance{});
  const double d = gear.drive.pitch_diameter;
  DeviationLimits limits;
  limits.single_pitch = single_pitch_limit(tolerance.grade, d, d / flexspline_teeth(gear.drive));
  limits.thickness = tolerance.thickness_deviation.value_or(limits.single_pitch / 3);
  // (TC-36): the difference of two flanks has the standard deviation f_pT/3; what the thickness
  // leaves of the flank's variance belongs to the middle of the tooth.
  const double of_middle =
      std::pow(limits.single_pitch, 2) / 18 - std::pow(limits.thickness, 2) / 4;
  require(of_middle >= 0, "tolerance.thickness_deviation", limits.thickness, "m",
          "<= 0.471 times the single pitch deviation of tolerance.grade, because the thickness is "
          "a part of the pitch of the flanks (TC-36)");
  limits.position = std::sqrt(of_middle);
  limits.diameter_of_ball = tolerance.ball_variation;
  limits.eccentricity = tolerance.run_out / 2;
  return limits;
}

Deviations draw_deviations(const GearSet& gear, std::uint64_t seed, std::uint64_t draw) {
  const DeviationLimits limits = deviation_limits(gear);
  std::uint64_t input = 0;
  const auto normal = [&](double deviation) {
    return deviation * counter_normal(seed, draw, input++);
  };
  Deviations drawn;
  const auto draw_teeth = [&](std::vector<ToothDeviation>& teeth, int count) {
    for (int j = 0; j < count; ++j) {
      ToothDeviation& tooth = teeth.emplace_back();
      tooth.position = normal(limits.position);
      tooth.thickness = normal(limits.thickness);
    }
  };
  draw_teeth(drawn.flexspline, flexspline_teeth(gear.drive));
  draw_teeth(drawn.spline, flexspline_teeth(gear.drive) + 2);
  for (int k = 0; k < *gear.wave_generator->bearing->ball_count; ++k)
    drawn.balls.push_back(normal(limits.diameter_of_ball));
  drawn.eccentricity = limits.eccentricity;
  drawn.eccentricity_angle = 2 * pi * counter_uniform(seed, draw, input);
  drawn.pairing_gap = pairing_gap(drawn, gear);
  return drawn;
}

double pairing_gap(const Deviations& deviations, const GearSet& gear) {
  // The flanks of half paths have angles of their own; none closes by more than with the angle 0.
  const auto& tooth = gear.mesh->tooth;
  const bool own_angles = tooth && tooth->profile == ToothProfile::half_path;
  const double flank_angle = own_angles ? 0.0 : gear.mesh->flank_angle;
  const int teeth = static_cast<int>(deviations.flexspline.size());
  double closest = 0.0;
  for (int moved = 0; moved < teeth + 2; ++moved)
    for (int j = 0; j < teeth; ++j)
      for (const int side : {+1, -1})
        closest =
            std::max(closest, approach(deviations, j + moved, j + moved + lobe_of(j, teeth), side));
  return closest * std::cos(flank_angle);  // (TC-36)
}

Deviations paired(Deviations measured, const GearSet& gear) {
  const auto teeth = static_cast<std::size_t>(flexspline_teeth(gear.drive));
  if (measured.flexspline.empty()) measured.flexspline.resize(teeth);
  if (measured.spline.empty()) measured.spline.resize(teeth + 2);
  check_deviations(measured, gear);
  measured.pairing_gap = pairing_gap(measured, gear);
  return measured;
}

Deviations moved_on(const Deviations& deviations, int teeth) {
  Deviations moved = deviations;
  const auto move = [&](std::vector<ToothDeviation>& of) {
    if (of.empty()) return;
    const auto first = of.begin() + static_cast<std::ptrdiff_t>(around(teeth, of.size()));
    std::rotate(of.begin(), first, of.end());
  };
  move(moved.flexspline);
  move(moved.spline);
  return moved;
}

double flank_closing(const Deviations& deviations, int tooth, int side, int teeth,
                     double flank_angle) {
  return std::cos(flank_angle) * approach(deviations, tooth, tooth + lobe_of(tooth, teeth), side) -
         deviations.pairing_gap;  // (TC-36)
}

double ball_closing(const Deviations& deviations, int ball, double position) {
  const double of_cam =
      deviations.eccentricity * std::cos(position - deviations.eccentricity_angle);
  return deviations.balls.empty() ? of_cam
                                  : of_cam + deviations.balls[static_cast<std::size_t>(ball)];
}

void check_deviations(const Deviations& deviations, const GearSet& gear) {
  const auto require_count = [](const char* field, std::size_t is, int wanted, const char* rule) {
    require(is == 0 || is == static_cast<std::size_t>(wanted), field, static_cast<double>(is), "1",
            rule);
  };
  require_count("deviations.flexspline", deviations.flexspline.size(), flexspline_teeth(gear.drive),
                "none, or one for each of the z teeth");
  require_count("deviations.spline", deviations.spline.size(), flexspline_teeth(gear.drive) + 2,
                "none, or one for each of the z + 2 teeth");
  require_count("deviations.balls", deviations.balls.size(),
                *gear.wave_generator->bearing->ball_count, "none, or one for each ball");
  const auto require_finite = [](const char* field, double value, const char* unit) {
    require(std::isfinite(value), field, value, unit, "a finite number");
  };
  for (const auto* const teeth : {&deviations.flexspline, &deviations.spline})
    for (const ToothDeviation& tooth : *teeth) {
      require_finite("deviations.position", tooth.position, "m");
      require_finite("deviations.thickness", tooth.thickness, "m");
    }
  for (const double ball : deviations.balls) require_finite("deviations.balls", ball, "m");
  require_finite("deviations.eccentricity", deviations.eccentricity, "m");
  require_finite("deviations.eccentricity_angle", deviations.eccentricity_angle, "rad");
  require_finite("deviations.pairing_gap", deviations.pairing_gap, "m");
}

}  // namespace strainwave

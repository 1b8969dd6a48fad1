// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/tolerance_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// Positions of the wave generator over its turn, for the ripple.
constexpr int kPositions = 8;

/// The numbers of one drive.
struct DrawnCurve {
  double K1 = 0.0;
  double K2 = 0.0;
  double K3 = 0.0;
  double lost_motion = 0.0;
  double ripple = 0.0;
  std::array<double, 3> flanks{};  // at T1, T2, T3
  std::array<double, 3> teeth{};
};

template <class Archive>
void archive(Archive& to, DrawnCurve& curve) {
  to(curve.K1, curve.K2, curve.K3, curve.lost_motion, curve.ripple, curve.flanks, curve.teeth);
}

/// Half of the twist between both senses of a torque: the rest within the play does not count.
double half_twist(double positive, double negative) { return (positive - negative) / 2; }

double first_stiffness(const AssembledDrive& drive, double T1) {
  return T1 /
         half_twist(twists(drive, {{T1 / 3, T1}}).back(), twists(drive, {{-T1 / 3, -T1}}).back());
}

DrawnCurve curve_of(const AssembledDrive& drive) {
  const MakersTorques at = makers_torques(drive.gear());
  const std::array<double, 4> torques = {at.T1 / 3, at.T1, at.T2, at.T3};
  std::array<double, 4> reversed{};
  std::ranges::transform(torques, reversed.begin(), [](double torque) { return -torque; });
  const TorsionCurve curve = torsion_curve(drive, torques);
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  const std::vector<double> other = twists(drive, reversed);
  const auto twist = [&](std::size_t i) { return half_twist(curve.points[i].twist, other[i]); };
  DrawnCurve drawn{.K1 = at.T1 / twist(1),  // (TC-36)
                   .K2 = (at.T2 - at.T1) / (twist(2) - twist(1)),
                   .K3 = (at.T3 - at.T2) / (twist(3) - twist(2)),
                   .lost_motion = lost_motion(drive)};
  for (std::size_t i = 0; i < 3; ++i) {
    const CurvePoint& point = curve.points[i + 1];
    drawn.flanks[i] = static_cast<double>(point.drive_flanks.size() + point.coast_flanks.size());
    drawn.teeth[i] = point.teeth_in_contact;
  }
  return drawn;
}

DrawnCurve drawn_curve(const AssembledDrive& drive, const ToleranceOptions& options,
                       std::uint64_t draw) {
  const Deviations deviations = draw_deviations(drive.gear(), options.seed, draw);
  DrawnCurve drawn = curve_of(drive.with_deviations(deviations));
  const double T1 = makers_torques(drive.gear()).T1;
  const auto spaces = static_cast<int>(deviations.spline.size());
  double least = drawn.K1;
  double largest = drawn.K1;
  double sum = drawn.K1;
  for (int i = 1; i < kPositions; ++i) {
    const AssembledDrive at = drive.with_deviations(moved_on(deviations, i * spaces / kPositions));
    const double K1 = first_stiffness(at, T1);
    least = std::min(least, K1);
    largest = std::max(largest, K1);
    sum += K1;
  }
  drawn.ripple = (largest - least) / (sum / kPositions);  // (TC-36)
  return drawn;
}

/// Hands the draws over as rows.
/// @param drawn  absent: the drive has no equilibrium
void write_rows(const std::vector<std::optional<DrawnCurve>>& drawn, const AssembledDrive& drive,
                const ToleranceOptions& options) {
  RowHead head{.of = "draws of the tolerances",
               .rows = drawn.size(),
               .columns = {{"K1", "N*m/rad"},
                           {"K2", "N*m/rad"},
                           {"K3", "N*m/rad"},
                           {"lost_motion", "rad"},
                           {"ripple", "1"}},
               .seed = options.seed};
  for (const std::string_view what : {"flanks", "teeth"})
    for (const std::string_view at : {"T1", "T2", "T3"})
      head.columns.push_back({fmt::format("{}_at_{}", what, at), "1"});
  options.rows->begin(head);
  std::vector<double> numbers;
  for (std::size_t n = 0; n < drawn.size(); ++n) {
    numbers.clear();
    std::string rule;
    if (const std::optional<DrawnCurve>& of = drawn[n]) {
      numbers = {of->K1, of->K2, of->K3, of->lost_motion, of->ripple};
      numbers.insert(numbers.end(), of->flanks.begin(), of->flanks.end());
      numbers.insert(numbers.end(), of->teeth.begin(), of->teeth.end());
    } else {
      try {
        (void)drawn_curve(drive, options, n);
      } catch (const SolverError& fault) {
        rule = rule_of(fault);
      }
    }
    numbers.resize(head.columns.size(), std::numeric_limits<double>::quiet_NaN());
    options.rows->add(numbers, drawn[n] ? RowStatus::usable : RowStatus::unusable, rule);
  }
}

}  // namespace

ToleranceEffects tolerance_effects(const AssembledDrive& drive, const ToleranceOptions& options,
                                   const Progress& progress) {
  require(options.draws > 0, "tolerances", options.draws, "1", "> 0");
  ToleranceEffects effects;
  effects.limits = deviation_limits(drive.gear());
  effects.seed = options.seed;
  effects.positions = kPositions;
  const DrawnCurve nominal = curve_of(drive);
  auto drawn = shared_rows<std::optional<DrawnCurve>>(
      static_cast<std::size_t>(options.draws), {.threads = options.threads}, progress,
      options.shared, [&] {
        return [&](std::size_t n, std::optional<DrawnCurve>& curve) {
          try {
            curve = drawn_curve(drive, options, n);
          } catch (const SolverError&) {  // these parts have no equilibrium
          }
        };
      });
  if (options.rows != nullptr) write_rows(drawn, drive, options);
  effects.failed = static_cast<int>(std::erase(drawn, std::nullopt));
  effects.draws = static_cast<int>(drawn.size());
  if (drawn.empty()) throw SolverError("none of the drawn drives has an equilibrium");
  const auto set = [&](ToleranceSpread& spread, const auto& value_of) {
    std::vector<double> values;
    for (const auto& one : drawn) values.push_back(value_of(*one));
    spread = {.nominal = value_of(nominal),
              .low = quantile(values, 0.05),
              .median = quantile(values, 0.5),
              .high = quantile(values, 0.95)};
  };
  set(effects.K1, [](const DrawnCurve& of) { return of.K1; });
  set(effects.K2, [](const DrawnCurve& of) { return of.K2; });
  set(effects.K3, [](const DrawnCurve& of) { return of.K3; });
  set(effects.lost_motion, [](const DrawnCurve& of) { return of.lost_motion; });
  set(effects.ripple, [](const DrawnCurve& of) { return of.ripple; });
  const MakersTorques at = makers_torques(drive.gear());
  const std::array<double, 3> torques = {at.T1, at.T2, at.T3};
  for (std::size_t i = 0; i < torques.size(); ++i) {
    ContactSpread& contacts = effects.contacts.emplace_back();
    contacts.torque = torques[i];
    set(contacts.flanks, [&](const DrawnCurve& of) { return of.flanks[i]; });
    set(contacts.teeth, [&](const DrawnCurve& of) { return of.teeth[i]; });
  }
  return effects;
}

}  // namespace strainwave

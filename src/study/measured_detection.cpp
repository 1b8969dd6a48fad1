// SPDX-License-Identifier: Apache-2.0
#include "measured_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/crack_sizes.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "vibrating_drive.hpp"

namespace strainwave {
namespace {

constexpr int kRowsOfGrowth = 40;
/// Points below the first size of the file.
constexpr int kSmallerSizes = 12;

/// The lowest natural frequency with a held motor, of both senses of the load [Hz].
double lowest_frequency(const GearSet& gear) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const double torque : {gear.load.torque, -gear.load.torque})
    for (const ChainMode& mode : vibrating_drive(gear, torque).modes(MotorGives::speed))
      lowest = std::min(lowest, mode.frequency);
  return lowest;
}

/// What the cracks of a drive change of a measured value (IR-10).
class MeasuredChange {
 public:
  MeasuredChange(const GearSet& gear, InspectionMeans method) : method_(method) {
    if (method != InspectionMeans::resonance) return;
    if (!gear.drivetrain)
      throw InputError("drivetrain",
                       "must be given for inspection.method = \"resonance\", with the inertias of "
                       "motor and load");
    sound_ = lowest_frequency(without_cracks(gear));
    if (!std::isfinite(sound_))
      throw InputError("drivetrain",
                       "has no natural frequency with a held motor; give the inertia "
                       "of the load");
  }

  /// [-]; >= 0
  [[nodiscard]] double of(const GearSet& gear) const {
    if (method_ == InspectionMeans::resonance)
      return std::max(0.0, 1 - lowest_frequency(gear) / sound_);  // (IR-10)
    const SeriesCompliance<double> of = series_compliance<double>(gear);
    if (method_ == InspectionMeans::stiffness)
      return std::max(of.positive_loss(), of.negative_loss());
    const double positive = of.positive_stiffness();
    const double negative = of.negative_stiffness();
    return 2 * std::abs(positive - negative) / (positive + negative);
  }

 private:
  InspectionMeans method_;
  double sound_ = 0.0;
};

/// The crack with a path; the drive has it.
DriveCrack crack_at(const std::vector<DriveCrack>& cracks, const std::string& path) {
  return *std::ranges::find(cracks, path, &DriveCrack::path);
}

/// Probability that a measurement calls [-] (IR-11).
/// @param ratio  change over noise [-]; >= 0
/// @param z      threshold over noise [-]
double called(InspectionMeans method, double ratio, double z) {
  const double above = normal_probability(ratio - z);
  // The difference of the senses counts by its absolute value, so it may also be below -z.
  return method == InspectionMeans::one_sided_stiffness ? above + normal_probability(-ratio - z)
                                                        : above;
}

/// The size at which a curve through points reaches a probability [m]; absent: it does not.
std::optional<double> size_found(const std::vector<DetectionPoint>& points, double wanted) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].probability < wanted) continue;
    if (i == 0) return points[i].size;
    const double share =
        (wanted - points[i - 1].probability) / (points[i].probability - points[i - 1].probability);
    return points[i - 1].size * std::pow(points[i].size / points[i - 1].size, share);
  }
  return std::nullopt;
}

}  // namespace

void refuse_without_end(InspectionMeans method) {
  throw InputError("inspection.method",
                   fmt::format("is \"{}\", which needs a crack that ends the life at the "
                               "values of the file; look for the cracks by a curve instead",
                               enum_name(method)));
}

MeasuredDetection measured_detection(const GearSet& gear, const Inspection& asked,
                                     const GrowthOptions& growth, double smallest,
                                     const Progress& progress) {
  GrowthOptions options = growth;
  options.points = kRowsOfGrowth;
  const GrowthReport grown = grow_cracks(gear, options, progress);
  // A crack that leaves the range of its solution counts as a failure there.
  if (grown.governing.empty() || !(grown.life || grown.end == DriveEnd::range))
    refuse_without_end(asked.method);
  const std::vector<DriveCrack> first = drive_cracks(gear);
  const DriveCrack governing = crack_at(first, grown.governing);
  if (governing.acts_in_coupled_drive && asked.method != InspectionMeans::resonance)
    throw InputError("inspection.method",
                     fmt::format("is \"{}\", which does not know how {} changes the stiffness, "
                                 "because it acts in the contacts; use \"resonance\"",
                                 enum_name(asked.method), grown.governing));
  const MeasuredChange change(gear, asked.method);
  MethodOfInspection stated;
  stated.method = asked.method;
  stated.crack = grown.governing;
  stated.noise = asked.noise;
  stated.false_calls = asked.false_calls.value_or(0.0);
  std::vector<DetectionPoint>& points = stated.points;
  if (smallest < governing.size.size)
    for (int i = 0; i < kSmallerSizes; ++i) {
      const double factor =
          std::pow(smallest / governing.size.size, 1 - static_cast<double>(i) / kSmallerSizes);
      std::vector<CrackSize> sizes;
      for (const DriveCrack& crack : first)
        sizes.push_back(
            {.size = crack.size.size * factor, .aspect_ratio = crack.size.aspect_ratio});
      points.push_back({.size = governing.size.size * factor,
                        .change = change.of(with_crack_sizes(gear, sizes))});
    }
  for (const GearSet& drive : grown.drives) {
    const double size = crack_at(drive_cracks(drive), grown.governing).size.size;
    if (points.empty() || size > points.back().size)
      points.push_back({.size = size, .change = change.of(drive)});
  }
  const double alpha = stated.false_calls;
  const double z =
      -normal_quantile(asked.method == InspectionMeans::one_sided_stiffness ? alpha / 2 : alpha);
  for (DetectionPoint& point : points)
    point.probability =
        std::max(0.0, (called(asked.method, *point.change / *stated.noise, z) - alpha) /
                          (1 - alpha));  // (IR-11)
  // A crack that hides again is not found later: the curve does not rise above what follows.
  for (std::size_t i = points.size() - 1; i-- > 0;)
    points[i].probability = std::min(points[i].probability, points[i + 1].probability);
  stated.threshold = z * *stated.noise;
  const double ninety = 0.9 * (1 - alpha) + alpha;
  stated.change_ninety =
      *stated.noise *
      bracketed_root([&](double ratio) { return called(asked.method, ratio, z) - ninety; }, 0.0,
                     1 + z - normal_quantile(1 - ninety));
  stated.a50 = size_found(points, 0.5);
  stated.a90 = size_found(points, 0.9);
  stated.change_at_end = points.back().change;
  stated.found_at_end = points.back().probability;
  stated.size_at_end = points.back().size;
  std::vector<double> sizes;
  std::vector<double> probabilities;
  for (const DetectionPoint& point : points) {
    sizes.push_back(point.size);
    probabilities.push_back(point.probability);
  }
  return {.curve = DetectionCurve(std::move(sizes), std::move(probabilities)),
          .stated = std::move(stated)};
}

}  // namespace strainwave

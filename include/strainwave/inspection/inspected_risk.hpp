// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/inspection/detection_form.hpp"

/// @file
/// Probability of failure of cracked parts over time, without inspections and with them, from the
/// histories of drawn parts.  Theory manual, chapter IR.

namespace strainwave {

/// Probability that one inspection finds a crack, over its size.
class DetectionCurve {
 public:
  /// @param form    of the curve over the size
  /// @param half    size that is found in half of the inspections, a50 [m]; > 0
  /// @param ninety  size that is found in nine of ten, a90 [m]; > half
  /// @throws InputError  if a size is not positive, or detection would fall with the size
  DetectionCurve(DetectionForm form, double half, double ninety);
  /// A curve through points: linear over the logarithm of the size between two points, 0 below the
  /// first one, and as at the last one above it.
  /// @param sizes          [m]; > 0, each larger than the one before; at least one
  /// @param probabilities  [-]; one for each size, in [0, 1], none smaller than the one before
  /// @throws InputError    if a rule of the points is broken
  DetectionCurve(std::vector<double> sizes, std::vector<double> probabilities);

  /// Implements theory manual eq. (IR-1).
  /// @param size  of the crack [m]; 0 is never found
  [[nodiscard]] double at(double size) const;

 private:
  DetectionForm form_ = DetectionForm::log_logistic;
  double log_half_ = 0.0;
  double width_ = 1.0;            ///< of the logarithm of the size
  std::vector<double> sizes_;     ///< of the points; empty: a curve of a form
  std::vector<double> at_sizes_;  ///< probabilities of the points
};

/// What becomes of one drawn part.
struct DrawnPart {
  /// Time until it fails [s]; infinite if it does not fail
  double failure = std::numeric_limits<double>::infinity();
  std::vector<double> times = {};  ///< ascending [s]; the sizes stay after the last one
  /// size of each crack at each time [m], shape (cracks, times)
  std::vector<std::vector<double>> sizes = {};
  /// Its share among all parts over that of a plain draw [-]; > 0, 1 of all parts: plain draws
  double weight = 1.0;

  /// Size of a crack at a time [m]; its logarithm is linear between two times.
  [[nodiscard]] double size_at(std::size_t crack, double time) const;
  /// First time at which a crack has a size, by the same line [s]; 0 if it is as large from the
  /// first time on, infinite if it does not grow so far.
  /// @param crack  its index
  /// @param size   [m]; > 0
  [[nodiscard]] double time_of(std::size_t crack, double size) const;
  /// Probability that one inspection at a time finds at least one crack (IR-2).
  /// @param time   of the inspection [s]
  /// @param curve  of detection
  /// @param seen   whether an inspection can see each crack, shape (cracks)
  [[nodiscard]] double found_at(double time, const DetectionCurve& curve,
                                const std::vector<bool>& seen) const;
};

/// Drawn parts that stand for all parts.
struct PartSample {
  std::span<const DrawnPart> parts;  ///< at least one
  /// Weight of a further part that may fail, for upper limits [-]; 1 for plain draws
  double further = 1.0;

  /// A list of parts is a sample.
  // NOLINTNEXTLINE(google-explicit-constructor)
  PartSample(std::span<const DrawnPart> of, double weight_of_further = 1.0)
      : parts(of), further(weight_of_further) {}
  /// A list of parts is a sample.
  // NOLINTNEXTLINE(google-explicit-constructor)
  PartSample(const std::vector<DrawnPart>& of, double weight_of_further = 1.0)
      : parts(of), further(weight_of_further) {}
  /// Sum of the weights of all parts [-].
  [[nodiscard]] double total_weight() const;
};

/// How inspections find cracks, and what a find leads to.
struct CrackSearch {
  DetectionCurve curve;    ///< of detection
  std::vector<bool> seen;  ///< whether an inspection can see each crack, shape (cracks)
  /// Size to which a find reduces the cracks that can be seen [m]; > 0.  Absent: a part with a
  /// found crack leaves service.
  std::optional<double> repaired_to = {};
};

/// What the inspections before an end do to one part.
struct InspectedCourse {
  std::vector<double> in_service;  ///< probability that it is in service at each inspection [-]
  std::vector<double> found;       ///< probability that this inspection finds a crack [-]
  double failed = 0.0;             ///< probability that it fails up to the end [-]
};

/// The course of one part up to a time; theory manual eqs. (IR-4) and (IR-9).
///
/// After a repair a crack grows as it did from that size on, so its age falls back to the time at
/// which it had the size.  A smaller crack stays as it is, and no crack becomes smaller than its
/// first size.  The path of a crack that has grown is known up to the failure of the part, so the
/// part counts as failed when such a crack reaches this age.
/// @param part         one drawn part
/// @param until        end of the time at risk [s]
/// @param inspections  times [s], ascending; those from `until` on do not act
/// @param search       how cracks are found
[[nodiscard]] InspectedCourse inspected_course(const DrawnPart& part, double until,
                                               std::span<const double> inspections,
                                               const CrackSearch& search);

/// A probability with limits that contain it with 95 % confidence.
struct RiskEstimate {
  double probability = 0.0;  ///< estimate [-]
  double low = 0.0;          ///< lower limit [-]
  double high = 1.0;         ///< upper limit [-]
};

/// Sums over the weights of some parts.
struct WeightSums {
  double sum = 0.0;      ///< [-]
  double squares = 0.0;  ///< sum of the squares [-]
  double largest = 0.0;  ///< largest weight [-]

  /// Takes one more part into the sums.
  void add(double weight);
};

/// The share of the weights of parts that fail among all, with the limits of Fay and Feuer for the
/// rarer of the two kinds; theory manual eq. (IR-16).
/// @param failing  the parts that fail
/// @param whole    the others; at least one part is in either
/// @param further  weight of a further part that may fail [-]; > 0
[[nodiscard]] RiskEstimate weighted_risk(const WeightSums& failing, const WeightSums& whole,
                                         double further);

/// Probability of failure up to a time without inspections; theory manual eqs. (IR-3) and (IR-16).
/// The limits are those of Clopper and Pearson, or of Fay and Feuer if the weights differ from 1.
/// @param sample  drawn parts
/// @param until   end of the time at risk [s]
[[nodiscard]] RiskEstimate failure_risk(const PartSample& sample, double until);

/// Probability of failure up to a time with inspections; theory manual eqs. (IR-4) and (IR-16).
///
/// The limits are those of Fay and Feuer for a weighted sum of rare events.  The upper one assumes
/// that a further part may fail before all inspections.  So it does not fall below 3.69 times the
/// weight of this part over that of all parts, or is the limit without inspections where that is
/// lower.
/// @param sample       drawn parts
/// @param until        end of the time at risk [s]
/// @param inspections  times [s], ascending
/// @param search       how cracks are found
[[nodiscard]] RiskEstimate inspected_risk(const PartSample& sample, double until,
                                          std::span<const double> inspections,
                                          const CrackSearch& search);

/// Inspections at equal intervals before a time [s]: first, first + interval, ...
[[nodiscard]] std::vector<double> equal_inspections(double first, double interval, double until);

/// A plan of inspections.
struct InspectionPlan {
  std::vector<double> times;  ///< [s]
  RiskEstimate risk;          ///< up to the end
  bool reached = false;       ///< whether the wanted risk is reached
};

/// The fewest inspections at equal intervals whose risk is at most `wanted`; theory manual eq.
/// (IR-5).
/// @param sample  drawn parts
/// @param until   end of the time at risk [s]; > 0
/// @param wanted  largest allowed risk [-]
/// @param most    largest number of inspections
/// @param search  how cracks are found
[[nodiscard]] InspectionPlan equal_plan(const PartSample& sample, double until, double wanted,
                                        std::size_t most, const CrackSearch& search);

/// The fewest inspections at times of least risk whose risk is at most `wanted`; theory manual eq.
/// (IR-6).  The times are moved in turn until none of them lowers the risk further.
/// @param placing  parts among which the times are searched; at least one
/// @param judging  other parts, by which the risk and the number of inspections are judged, because
///                 the times suit the first ones too well; at least one
/// @param until    end of the time at risk [s]; > 0
/// @param wanted   largest allowed risk [-]
/// @param most     largest number of inspections
/// @param search   how cracks are found
[[nodiscard]] InspectionPlan least_plan(const PartSample& placing, const PartSample& judging,
                                        double until, double wanted, std::size_t most,
                                        const CrackSearch& search);

}  // namespace strainwave

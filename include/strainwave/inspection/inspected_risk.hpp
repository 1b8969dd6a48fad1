// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// Probability of failure of cracked parts over time, without inspections and with them, from the
/// histories of drawn parts.  Theory manual, chapter IR.

namespace strainwave {

/// Form of a curve of detection over the size of a crack.
enum class DetectionForm {
  log_logistic,
  log_normal,
};
template <>
struct EnumNames<DetectionForm> {
  static constexpr std::array<std::string_view, 2> names = {"log_logistic", "log_normal"};
};

/// Probability that one inspection finds a crack.
class DetectionCurve {
 public:
  /// @param form    of the curve over the size
  /// @param half    size that is found in half of the inspections, a50 [m]; > 0
  /// @param ninety  size that is found in nine of ten, a90 [m]; > half
  /// @throws InputError  if a size is not positive, or detection would fall with the size
  DetectionCurve(DetectionForm form, double half, double ninety);

  /// Implements theory manual eq. (IR-1).
  /// @param size  of the crack [m]; 0 is never found
  [[nodiscard]] double at(double size) const;

 private:
  DetectionForm form_;
  double log_half_;
  double width_;  ///< of the logarithm of the size
};

/// What becomes of one drawn part.
struct DrawnPart {
  /// Time until it fails [s]; infinite if it does not fail
  double failure = std::numeric_limits<double>::infinity();
  std::vector<double> times = {};  ///< ascending [s]; the sizes stay after the last one
  /// size of each crack at each time [m], shape (cracks, times)
  std::vector<std::vector<double>> sizes = {};

  /// Size of a crack at a time [m]; its logarithm is linear between two times.
  [[nodiscard]] double size_at(std::size_t crack, double time) const;
  /// Probability that one inspection at a time finds at least one crack (IR-2).
  /// @param time   of the inspection [s]
  /// @param curve  of detection
  /// @param seen   whether an inspection can see each crack, shape (cracks)
  [[nodiscard]] double found_at(double time, const DetectionCurve& curve,
                                const std::vector<bool>& seen) const;
};

/// A probability with limits that contain it with 95 % confidence.
struct RiskEstimate {
  double probability = 0.0;  ///< estimate [-]
  double low = 0.0;          ///< lower limit [-]
  double high = 1.0;         ///< upper limit [-]
};

/// Probability of failure up to a time without inspections; theory manual eq. (IR-3).  The limits
/// are those of Clopper and Pearson.
/// @param parts  drawn parts; the caller gives at least one
/// @param until  end of the time at risk [s]
[[nodiscard]] RiskEstimate failure_risk(std::span<const DrawnPart> parts, double until);

/// Probability of failure up to a time, if parts are out of service once a crack is found; theory
/// manual eq. (IR-4).
///
/// The limits are those of Fay and Feuer for a weighted sum of rare events.  The upper one assumes
/// that a further part may fail before all inspections, so it does not fall below 3.69 over the
/// number of parts, or is the limit without inspections where that is lower.
/// @param parts        at least one
/// @param until        end of the time at risk [s]
/// @param inspections  times [s], ascending
/// @param curve        of detection
/// @param seen         as in DrawnPart::found_at
[[nodiscard]] RiskEstimate inspected_risk(std::span<const DrawnPart> parts, double until,
                                          std::span<const double> inspections,
                                          const DetectionCurve& curve,
                                          const std::vector<bool>& seen);

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
/// @param parts   at least one
/// @param until   end of the time at risk [s]; > 0
/// @param wanted  largest allowed risk [-]
/// @param most    largest number of inspections
/// @param curve   of detection
/// @param seen    as in DrawnPart::found_at
[[nodiscard]] InspectionPlan equal_plan(std::span<const DrawnPart> parts, double until,
                                        double wanted, std::size_t most,
                                        const DetectionCurve& curve, const std::vector<bool>& seen);

/// The fewest inspections at times of least risk whose risk is at most `wanted`; theory manual eq.
/// (IR-6).  The times are moved in turn until none of them lowers the risk further.
/// @param placing  parts among which the times are searched; at least one
/// @param judging  other parts, by which the risk and the number of inspections are judged, because
///                 the times suit the first ones too well; at least one
/// @param until    end of the time at risk [s]; > 0
/// @param wanted   largest allowed risk [-]
/// @param most     largest number of inspections
/// @param curve    of detection
/// @param seen     as in DrawnPart::found_at
[[nodiscard]] InspectionPlan least_plan(std::span<const DrawnPart> placing,
                                        std::span<const DrawnPart> judging, double until,
                                        double wanted, std::size_t most,
                                        const DetectionCurve& curve, const std::vector<bool>& seen);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/core/progress.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/inspection/inspected_risk.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/inspection_report.hpp"

// The measurement of a drive as an inspection: how its cracks change what is measured.

namespace strainwave {

/// A measurement as a curve of detection over the size of the crack that ends the life.
struct MeasuredDetection {
  DetectionCurve curve;
  MethodOfInspection stated;  ///< with its points
};

/// Refuses a measurement, because no growing crack ends the life at the values of the file.
[[noreturn]] void refuse_without_end(InspectionMeans method);

/// Implements theory manual eqs. (IR-10) and (IR-11).
///
/// The drive is grown at the values of the file.  Below the first size of its crack, all cracks
/// are smaller by the same factor.
/// @param gear      has passed `check`; its cracks grow to an end
/// @param asked     a measurement with its noise and its false calls
/// @param growth    how the cracks grow
/// @param smallest  smallest size of the crack that ends the life, of all draws [m]; > 0
/// @throws InputError  if no crack ends the life, the measurement does not contain its change, or
///                     what it needs is missing
[[nodiscard]] MeasuredDetection measured_detection(const GearSet& gear, const Inspection& asked,
                                                   const GrowthOptions& growth, double smallest,
                                                   const Progress& progress);

}  // namespace strainwave

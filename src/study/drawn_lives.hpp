// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawn_drive.hpp"
#include "scatter_law.hpp"
#include "strainwave/core/correlated_normals.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/inspection/inspected_risk.hpp"
#include "strainwave/study/inspection_report.hpp"
#include "strainwave/uncertainty/failure_centre.hpp"

namespace strainwave {

/// What became of one draw.
struct DrawnLife {
  bool refused = false;     ///< breaks a rule of the input, or has no answer
  bool unfinished = false;  ///< no end within the longest duty that is computed
  bool out_of_range = false;
  bool arrested = false;
  DrawnPart part;
};

/// The failure and the sizes of a trace.  A crack that leaves the range of its solution fails.
[[nodiscard]] DrawnPart part_of(const LifeTrace& trace);

/// Whether the growth of a material scatters.
[[nodiscard]] bool growth_scatters(const GearSet& gear);

/// Draws drives of [[scatter]] and of the scatter of their growth, and grows their cracks.
class DrawnLives {
 public:
  /// @param gear     as of `inspection_report`; outlives this object
  /// @param options  the same
  DrawnLives(const GearSet& gear, const InspectionOptions& options);

  [[nodiscard]] const CorrelatedNormals& normals() const { return normals_; }
  /// Paths of the inputs: those of [[scatter]], then those of growth_levels.
  [[nodiscard]] std::vector<std::string> inputs() const;
  /// Independent standard normal variables of a draw.
  [[nodiscard]] std::vector<double> normals_of(std::size_t draw) const;
  /// Whether a draw scatters about failures (IR-16).
  [[nodiscard]] bool about_failures(std::size_t draw) const {
    return draw % (centres_.size() + 1) != 0;
  }
  /// Lets draws scatter about the failures up to a time too, if these are found (UQ-10).
  /// @param cracks  as of `draws`
  FailureCentres centre_draws(double until, const std::vector<std::string>& cracks,
                              const Progress& progress);
  /// The centres of the failures, with the most deviating input first.
  [[nodiscard]] std::vector<CentreOfFailures> centres() const;
  /// The lives of all draws.
  /// @param cracks  paths of the cracks that grow in the drive of the file.  Inspections find a
  ///                crack by its place in this list, so a draw with other growing cracks is
  ///                refused.
  [[nodiscard]] std::vector<DrawnLife> draws(const std::vector<std::string>& cracks,
                                             const Progress& progress) const;
  /// Hands the draws over as rows: the inputs, the life, and the sizes of the cracks at its end.
  /// @param lives   of `draws`
  /// @param cracks  as of `draws`
  void write_lives(const std::vector<DrawnLife>& lives, const std::vector<std::string>& cracks,
                   RowSink& to) const;

 private:
  /// Values of the inputs at independent standard normal variables u; of a level of growth, its
  /// deviation.
  [[nodiscard]] std::vector<double> values_at(std::span<const double> u) const;
  /// @param draw  number of the draw, of which the paths of the cracks are a function; absent: the
  ///              rates do not vary along the paths
  /// @throws Error  if the drive breaks a rule, or has no answer
  [[nodiscard]] LifeTrace trace_at(DrawnDrive& drive, std::span<const double> u,
                                   std::optional<std::size_t> draw) const;
  /// Why a draw is refused.
  [[nodiscard]] std::string reason_of(DrawnDrive& drive, std::size_t draw,
                                      const std::vector<std::string>& cracks) const;
  /// @param draw    as of `trace_at`
  /// @param cracks  as of `draws`
  [[nodiscard]] DrawnLife life_at(DrawnDrive& drive, std::span<const double> u,
                                  std::optional<std::size_t> draw,
                                  const std::vector<std::string>& cracks) const;

  const GearSet& gear_;
  const InspectionOptions& options_;
  std::vector<ScatterLaw> laws_;
  std::vector<GrowthLevel> levels_;
  bool growth_scatters_ = false;  ///< whether a material has a scatter of growth
  CorrelatedNormals normals_;
  std::vector<std::vector<double>> centres_;  ///< u* of failures; empty: plain draws alone
};

}  // namespace strainwave

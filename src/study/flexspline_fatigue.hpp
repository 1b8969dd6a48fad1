// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/life/critical_plane.hpp"
#include "strainwave/life/tooth_root.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/life_report.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {

[[nodiscard]] std::string_view place_words(FatiguePlace place);

/// Forces of one kind of flank on a tooth that passes the lobes, between the teeth that were
/// solved.
class FlankForce {
 public:
  /// @param pitch  angle between teeth [rad]
  FlankForce(const std::vector<ContactForce>& flanks, double pitch);
  /// @param angle  of the tooth from the major axis [rad]
  [[nodiscard]] double at(double angle) const;

 private:
  double pitch_;
  const std::vector<ContactForce>& flanks_;
};

/// Working heights of the teeth with their defaults filled in.
struct WorkingHeights {
  double addendum = 0.0;         ///< h_a [m]
  double spline_addendum = 0.0;  ///< h_ac [m]
  double thickness = 0.0;        ///< s_t at the pitch height [m]
};
[[nodiscard]] WorkingHeights working_heights(const GearSet& gear);

/// What a place of the flexspline endures, with the factors of its surface and its size.
class PlaceStrength {
 public:
  PlaceStrength(const GearSet& gear, FatiguePlace place);

  /// What to give; empty if the strength is known.
  [[nodiscard]] const std::string& unknown_because() const { return unknown_because_; }
  [[nodiscard]] double surface() const { return surface_; }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] double support() const { return support_; }
  [[nodiscard]] const PlaneStrength& plane() const { return plane_; }
  /// tau_-1 of a smooth specimen [Pa].
  [[nodiscard]] double specimen_shear() const { return specimen_shear_; }
  [[nodiscard]] const FatigueStrength& fatigue() const { return fatigue_; }

 private:
  std::string unknown_because_;
  double surface_ = 1.0;
  double size_ = 1.0;
  double support_ = 1.0;
  double specimen_shear_ = 0.0;
  PlaneStrength plane_;
  FatigueStrength fatigue_;
};

/// Stresses of a place of the flexspline while a wave passes.
class PlaceStresses {
 public:
  PlaceStresses(const GearSet& gear, FatiguePlace place);

  /// What to give; empty if the stresses are known.
  [[nodiscard]] const std::string& unknown_because() const { return unknown_because_; }
  /// Concentration of the rim's hoop stress [-].
  [[nodiscard]] double concentration() const { return groove_.hoop; }
  /// The points of the place: both fillets of a tooth, else one.
  [[nodiscard]] const std::vector<int>& sides() const { return sides_; }
  /// @param rim    states over a turn at a torque
  /// @param point  contact forces at the torque
  /// @param side   one of `sides`
  [[nodiscard]] WaveStates over_turn(const std::vector<RimState>& rim, const CurvePoint& point,
                                     int side) const;

 private:
  FatiguePlace place_;
  std::string unknown_because_;
  GrooveConcentration groove_;
  std::vector<int> sides_ = {0};
  double wall_shear_factor_ = 1.0;     ///< K_u
  double rim_shear_per_torque_ = 0.0;  ///< [1/m^3]
  std::optional<RootSection> root_;    ///< with the force at the pitch height
  WorkingHeights heights_;
  double lift_ = 0.0;    ///< w_0 [m]
  double across_ = 1.0;  ///< share of a flank force that bends the tooth
  double pitch_ = 0.0;   ///< angle between teeth [rad]
};

}  // namespace strainwave

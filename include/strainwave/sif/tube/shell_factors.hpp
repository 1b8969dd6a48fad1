// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/sif/solution.hpp"

/// @file
/// Through cracks in the wall of a tube: factors of the curvature on the K of a plate.  The front
/// runs through the wall, s from -1 (inner face) to +1 (outer face); K = mean + s linear.

namespace strainwave::sif {

/// Shell parameter lambda = (12 (1 - nu^2))^(1/4) a/sqrt(r t) [-]; (SU-1).
[[nodiscard]] double shell_parameter(double half_length, double mean_radius, double thickness,
                                     double poissons_ratio);

/// Stress intensity through the wall over sigma sqrt(pi a) [-].
template <class Real>
struct BasicWallIntensity {
  Real mean{};    ///< mean over the wall: membrane part
  Real linear{};  ///< excess at the outer face; its energy is that of shell bending
  /// At one place, s from -1 (inner face) to +1 (outer face) [-].
  [[nodiscard]] Real at(double s) const { return mean + s * linear; }
};
/// BasicWallIntensity without derivatives.
using WallIntensity = BasicWallIntensity<double>;

/// Stress intensities of a crack in a shallow cylindrical shell under a remote unit stress.
template <class Real>
struct BasicShellFactors {
  BasicWallIntensity<Real> opening_by_normal;  ///< K_I from the normal stress; flat plate: mean 1
  BasicWallIntensity<Real> sliding_by_normal;  ///< K_II from the normal stress; flat plate: 0
  BasicWallIntensity<Real> opening_by_shear;   ///< K_I from the shear stress; flat plate: 0
  BasicWallIntensity<Real> sliding_by_shear;   ///< K_II from the shear stress; flat plate: mean 1
};
/// BasicShellFactors without derivatives.
using ShellFactors = BasicShellFactors<double>;

/// Largest lambda of the table.
inline constexpr double kShellTableEnd = 8.0;

/// Shell factors of one angle at many lambda; the table is interpolated over the angle once.
///
/// Implements theory manual eq. (SU-2): Donnell's shallow shell with Kirchhoff bending, nu = 0.3,
/// interpolated to 0.06 %; nu between 0.25 and 0.35 changes K by up to 0.7 %.
template <class Real>
class BasicShellFactorsAtAngle {
 public:
  /// @param angle  angle beta from the generator toward -theta [rad]
  explicit BasicShellFactorsAtAngle(const Real& angle);

  /// @param lambda  shell parameter, root of (FR-8) [-]; in [0, 8]
  [[nodiscard]] BasicShellFactors<Real> at(const Real& lambda) const;

  /// Nodes of lambda by columns.
  using Table = std::array<std::array<double, 8>, 12>;

 private:
  Real angle_;
  Real sin_2beta_{};
  Table value_{};
  Table by_angle_{};  ///< derivative with respect to the angle; zero without dual numbers
};

extern template class BasicShellFactorsAtAngle<double>;
extern template class BasicShellFactorsAtAngle<CrackReal>;

/// Shell factors at one lambda and angle, as BasicShellFactorsAtAngle.
///
/// @param lambda  shell parameter [-]; in [0, 8]
/// @param angle   angle beta from the generator toward -theta [rad]
[[nodiscard]] ShellFactors shell_factors(double lambda, double angle);

/// Largest lambda of the table for a circumferential crack.
inline constexpr double kMaxCircumferentialShellParameter = 24.0;

/// Circumferential through crack of finite angle, K over nominal stress sqrt(pi a) [-].
struct CircumferentialFactors {
  WallIntensity axial;    ///< K_I of an axial force
  WallIntensity bending;  ///< K_I of a bending moment, crack in the middle of the tensile side
  WallIntensity torque;   ///< K_II of a torque
};

/// Implements theory manual eq. (SU-4): Sanders and Koiter's shell, interpolated to 0.3 %.
///
/// @param half_angle  alpha = a/r [rad]; in [0, pi/2]
/// @param radius_ratio  r/t [-]; in [5, 60]
/// @param lambda      shell parameter [-]; in [0, 24]
[[nodiscard]] CircumferentialFactors circumferential_factors(double half_angle, double radius_ratio,
                                                             double lambda);

/// Points of a front through the wall.
inline constexpr std::array<FrontPoint, 3> kWallPoints{
    FrontPoint{"middle", 0.0}, FrontPoint{"inner", -1.0}, FrontPoint{"outer", 1.0}};

}  // namespace strainwave::sif

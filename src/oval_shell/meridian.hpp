// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <array>
#include <cstddef>
#include <vector>

#include "strainwave/oval_shell/oval_shell.hpp"

/// @file
/// The meridian of a shell of revolution in elements, and its equations for n waves (CU-1).

namespace strainwave::meridian {

/// Radial, circumferential and axial displacement, and rotation of the meridian.
inline constexpr int kNodeUnknowns = 4;
/// Two bubbles of the displacement along the meridian and two of that round the axis.
inline constexpr int kInnerUnknowns = 4;
inline constexpr int kElementUnknowns = 2 * kNodeUnknowns + kInnerUnknowns;
/// Place of an unknown of an element behind `Element::unknown`: first node, bubbles, second node.
[[nodiscard]] constexpr Eigen::Index place_of(int unknown) {
  if (unknown < kNodeUnknowns) return unknown;
  return unknown < 2 * kNodeUnknowns ? unknown + kInnerUnknowns : unknown - kNodeUnknowns;
}
/// The numbers of ShellWave, in their order.
inline constexpr int kStrains = 9;

using Strains = Eigen::Matrix<double, kStrains, 1>;
using StrainRows = Eigen::Matrix<double, kStrains, kElementUnknowns>;

/// One conical element.
struct Element {
  std::array<double, 2> r;  ///< of its ends [m]
  std::array<double, 2> z;  ///< [m]
  double thickness;         ///< [m]
  /// The first end hangs on a rigid arm this far outside of its node [m].
  double arm = 0;
  /// Of its first node in the equations; < 0: held.
  Eigen::Index unknown = 0;

  [[nodiscard]] double length() const;
  [[nodiscard]] double slope() const { return (r[1] - r[0]) / length(); }  ///< dr/ds
  [[nodiscard]] double rise() const { return (z[1] - z[0]) / length(); }   ///< dz/ds
  [[nodiscard]] double radius(double at) const { return r[0] + at * (r[1] - r[0]); }
  /// Strains over the unknowns.
  /// @param at  from 0 to 1 along the element
  [[nodiscard]] StrainRows strains(int waves, double at) const;
  /// Radial displacement and displacement round the axis over the unknowns.
  /// @param outside  distance from the middle surface [m]
  [[nodiscard]] Eigen::Matrix<double, 2, kElementUnknowns> displacement(int waves, double at,
                                                                        double outside) const;
};

/// Stiffness of membrane and bending over the first six strains.
[[nodiscard]] Eigen::Matrix<double, 6, 6> elasticity(const ShellCup& cup, double thickness);

/// Four Gauss points from 0 to 1.
inline constexpr std::array<double, 4> kGaussAt = {0.06943184420297371, 0.3300094782075719,
                                                   0.6699905217924281, 0.9305681557970263};
inline constexpr std::array<double, 4> kGaussWeight = {0.1739274225687269, 0.3260725774312731,
                                                       0.3260725774312731, 0.1739274225687269};

/// The equations of one number of waves.
class Equations {
 public:
  Equations(const std::vector<Element>& elements, const ShellCup& cup, int waves);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& load) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      factor_;
};

/// The meridian of a cup.
struct Meridian {
  std::vector<Element> elements;
  std::size_t barrel_from = 0;  ///< first element of the barrel
  std::size_t rim_from = 0;     ///< first element of the rim
  std::size_t band_from = 0;    ///< first element of the pressed band
  std::size_t band_to = 0;      ///< behind its last element
  Eigen::Index unknowns = 0;
};

[[nodiscard]] Meridian meridian_of(const ShellCup& cup, double band_width);

}  // namespace strainwave::meridian

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// A round tube under torque, for its buckling.
struct TwistedTube {
  double radius = 0.0;          ///< r of the middle of the wall [m]; > 0
  double thickness = 0.0;       ///< t [m]; > 0, below r
  double length = 0.0;          ///< L [m]; > 0
  double youngs_modulus = 0.0;  ///< E [Pa]; > 0
  double poissons_ratio = 0.3;  ///< nu [-]; in (-1, 0.5)
};

/// Torque at which a tube buckles.
struct TubeBuckling {
  double Z = 0.0;               ///< Batdorf's parameter [-]
  double coefficient = 0.0;     ///< k of the least buckling stress [-]
  int waves = 0;                ///< whole waves n around the tube
  double elastic_stress = 0.0;  ///< tau_cr of an elastic wall [Pa]
  double elastic_torque = 0.0;  ///< [N*m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"Z", "1", "Batdorf's parameter of length"}, &TubeBuckling::Z);
    field({"coefficient", "1", "k of the buckling stress"}, &TubeBuckling::coefficient);
    field({"waves", "", "whole waves around the tube"}, &TubeBuckling::waves);
    field({"elastic_stress", "Pa", "shear stress at which an elastic wall buckles"},
          &TubeBuckling::elastic_stress);
    field({"elastic_torque", "N*m", "torque at which an elastic wall buckles"},
          &TubeBuckling::elastic_torque);
  }
};

/// Least coefficient k of torsional buckling with simply supported ends (LI-39) [-], over all real
/// wave lengths around the tube.
///
/// Galerkin's solution of Donnell's equation with `terms` half waves along the tube.  With 24 terms
/// it has converged to 3e-5 up to Z = 1000.
/// @param Z      Batdorf's parameter [-]; >= 0, at most 1e5
/// @param terms  [-]; 4 to 64
/// @throws InputError  if a number is out of range
[[nodiscard]] double torsional_buckling_coefficient(double Z, int terms = 24);

/// Implements theory manual eq. (LI-39) with the whole number of waves that buckles first.
///
/// For thin walls: the waves must be long against the thickness.  The ends are simply supported.
/// The wall is elastic and exactly round.
/// @throws InputError  if a dimension is out of range
[[nodiscard]] TubeBuckling tube_buckling(const TwistedTube& tube, int terms = 24);

/// Shear stress at which a wall buckles that yields (LI-40) [Pa].
/// @param elastic_stress  tau_cr [Pa]; > 0
/// @param yield_strength  R_p [Pa]; > 0
[[nodiscard]] double plastic_buckling_stress(double elastic_stress, double yield_strength);

/// Torque of a shear stress in a thin tube, 2 pi r^2 t tau [N*m].
[[nodiscard]] double tube_torque(const TwistedTube& tube, double stress);

}  // namespace strainwave

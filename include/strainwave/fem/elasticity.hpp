// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave::fem {

/// An isotropic, linear elastic material.
struct Elasticity {
  double youngs_modulus = 0.0;  ///< E [Pa]; > 0
  double poissons_ratio = 0.0;  ///< nu [-]; in (-1, 0.5)

  /// Shear modulus mu = E/(2(1+nu)) [Pa].  Finite elements use this value only.
  [[nodiscard]] double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
};

}  // namespace strainwave::fem

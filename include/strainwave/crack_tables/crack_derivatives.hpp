// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/core/dual.hpp"
#include "strainwave/crack_tables/similarity.hpp"

namespace strainwave {

/// Added compliance of one crack of a drive with its derivatives with respect to any inputs.
///
/// Implements theory manual eq. (SN-10).  The engine differentiates the parts f_i with respect to
/// their at most four arguments, once; the chain rule gives the derivatives with respect to all
/// inputs of the drive.
///
/// @tparam Solution  solution of the crack in DualReal
template <class Solution>
class CrackDerivatives {
 public:
  using Similar = Similarity<Solution>;                    ///< weights and arguments
  using Shape = typename Similar::template In<CrackReal>;  ///< the solution of the parts
  static_assert(Similar::kArguments <= kCrackWidth);

  /// @param crack    numbers of the crack; their derivatives have no effect
  /// @param faces    state of the faces
  /// @param options  tolerance of the crack integrals and of their derivatives
  CrackDerivatives(const CrackNumbers<Solution>& crack, Faces faces,
                   const QuadratureOptions& options)
      : faces_(faces) {
    const auto at = Similar::arguments(crack.parameters);
    std::array<CrackReal, Similar::kArguments> x;
    for (std::size_t j = 0; j < x.size(); ++j) {
      x[j] = at[j].value;
      x[j].partial[j] = 1.0;
    }
    const auto part = [&](CrackPart of, const BasicCrackModuli<CrackReal>& moduli) {
      const auto f = similar_part<Shape>(crack.parameters, x, of, faces, moduli, options);
      converged_ = converged_ && f.converged;
      return f.value;
    };
    if (crack.moduli.anisotropic) {
      for (std::size_t i = 0; i < kSheetParts; ++i) f_[i] = part(Similar::kParts[0], sheet_part(i));
      return;
    }
    const auto w = Similar::weights(crack.parameters, crack.moduli, faces);
    // A weight is the square of a stress, so where it is 0 its derivatives are 0 too.
    for (std::size_t i = 0; i < w.size(); ++i)
      if (w[i].value != 0)
        f_[i] = part(Similar::kParts[i], moduli_of<CrackReal>(Similar::kParts[i]));
  }

  /// Added compliance under the torque, or under the lobe force.
  /// @param crack  the same crack, with the derivatives of its numbers
  [[nodiscard]] DualReal operator()(const CrackNumbers<Solution>& crack) const {
    const auto x = Similar::arguments(crack.parameters);
    DualReal sum = 0.0;
    const auto add = [&](std::size_t i, const DualReal& weight) {
      DualReal f = f_[i].value;
      for (std::size_t j = 0; j < x.size(); ++j)
        f += chain(x[j], 0.0, f_[i].partial[j]);  // (SN-10)
      sum += weight * f;                          // (ST-21)
    };
    const auto w = Similar::weights(crack.parameters, crack.moduli, faces_);
    if (!crack.moduli.anisotropic) {
      for (std::size_t i = 0; i < w.size(); ++i) add(i, w[i]);
      return sum;
    }
    const auto moduli = faces_ == Faces::pressed ? crack.moduli.pressed() : crack.moduli;
    const DualReal size = w[0] * crack.moduli.opening;
    add(0, size / moduli.opening);
    add(1, size * moduli.anisotropic->sliding);
    add(2, size * moduli.anisotropic->coupling);
    return sum;
  }

  /// Whether the quadratures of all parts and of their derivatives met the tolerance.
  [[nodiscard]] bool converged() const { return converged_; }

 private:
  static constexpr std::size_t kSheetParts = 3;  ///< opening, sliding, both: (LA-9)
  static_assert(Similar::kParts.size() <= kSheetParts);

  /// Unit moduli under which only one part of a sheet that is not isotropic releases energy.
  [[nodiscard]] static BasicCrackModuli<CrackReal> sheet_part(std::size_t i) {
    BasicCrackModuli<CrackReal> moduli =
        moduli_of<CrackReal>(i == 0 ? CrackPart::opening : CrackPart::tearing);
    moduli.shear = std::numeric_limits<double>::infinity();
    moduli.anisotropic = AnisotropicSliding<CrackReal>{.sliding = i == 1 ? 1.0 : 0.0,
                                                       .coupling = i == 2 ? 1.0 : 0.0};
    return moduli;
  }

  Faces faces_;
  std::array<CrackReal, kSheetParts> f_{};
  bool converged_ = true;
};

}  // namespace strainwave

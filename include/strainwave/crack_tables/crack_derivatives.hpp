// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/core/dual.hpp"
#include "strainwave/crack_tables/similarity.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"

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
  static_assert(Similar::kFacesChangeShape == SharedByFaces<UnderLastLoad<Shape>>);

  /// @param crack    numbers of the crack; their derivatives have no effect
  /// @param options  tolerance of the crack integrals and of their derivatives
  CrackDerivatives(const CrackNumbers<Solution>& crack, const QuadratureOptions& options)
      : faces_(crack.faces) {
    const auto at = Similar::arguments(crack.parameters);
    std::array<CrackReal, Similar::kArguments> x;
    for (std::size_t j = 0; j < x.size(); ++j) {
      x[j] = at[j].value;
      x[j].partial[j] = 1.0;
    }
    const auto part = [&](CrackPart of, const BasicCrackModuli<CrackReal>& moduli) {
      ApartAndPressed<CrackReal> f;
      const auto take = [&](CrackReal& value, const SimilarPart<CrackReal>& solved) {
        value = solved.value;
        converged_ = converged_ && solved.converged;
      };
      if constexpr (Similar::kFacesChangeShape) {
        if (faces_.differ()) {
          const auto both =
              similar_part_in_both_states<Shape>(crack.parameters, x, of, moduli, options);
          take(f.apart, both.apart);
          take(f.pressed, both.pressed);
          return f;
        }
      }
      const Faces state = Similar::kFacesChangeShape ? faces_.positive : Faces::open;
      take(f.apart, similar_part<Shape>(crack.parameters, x, of, state, moduli, options));
      f.pressed = f.apart;
      return f;
    };
    if (crack.moduli.anisotropic) {
      for (std::size_t i = 0; i < kSheetParts; ++i) f_[i] = part(Similar::kParts[0], sheet_part(i));
      return;
    }
    const auto under_positive = Similar::weights(crack.parameters, crack.moduli, faces_.positive);
    const auto under_negative = Similar::weights(crack.parameters, crack.moduli, faces_.negative);
    // A weight is the square of a stress, so where it is 0 its derivatives are 0 too.
    for (std::size_t i = 0; i < under_positive.size(); ++i)
      if (under_positive[i].value != 0 || under_negative[i].value != 0)
        f_[i] = part(Similar::kParts[i], moduli_of<CrackReal>(Similar::kParts[i]));
  }

  /// Added compliance under both senses of the torque, or under the lobe force.
  /// @param crack  the same crack, with the derivatives of its numbers
  [[nodiscard]] UnderBothSenses<DualReal> operator()(const CrackNumbers<Solution>& crack) const {
    const auto x = Similar::arguments(crack.parameters);
    const auto under = [&](Faces faces) {
      DualReal sum = 0.0;
      const auto add = [&](std::size_t i, const DualReal& weight) {
        const CrackReal& part = faces == Faces::pressed ? f_[i].pressed : f_[i].apart;
        DualReal f = part.value;
        for (std::size_t j = 0; j < x.size(); ++j)
          f += chain(x[j], 0.0, part.partial[j]);  // (SN-10)
        sum += weight * f;                         // (ST-21)
      };
      const auto w = Similar::weights(crack.parameters, crack.moduli, faces);
      if (!crack.moduli.anisotropic) {
        for (std::size_t i = 0; i < w.size(); ++i) add(i, w[i]);
        return sum;
      }
      const auto moduli = faces == Faces::pressed ? crack.moduli.pressed() : crack.moduli;
      const DualReal size = w[0] * crack.moduli.opening;
      add(0, size / moduli.opening);
      add(1, size * moduli.anisotropic->sliding);
      add(2, size * moduli.anisotropic->coupling);
      return sum;
    };
    const DualReal positive = under(faces_.positive);
    return {positive, faces_.differ() ? under(faces_.negative) : positive};
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

  BothSenses faces_;
  std::array<ApartAndPressed<CrackReal>, kSheetParts> f_{};
  bool converged_ = true;
};

}  // namespace strainwave

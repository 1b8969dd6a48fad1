// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave {

/// A crack with N loads behind one fixed type, so the engine is compiled only once for each N.
///
/// The object keeps a copy of the crack.
template <std::size_t N>
class ErasedCrack {
 public:
  static constexpr std::size_t kLoads = N;

  /// @param crack  crack with N loads that computes in double
  template <SweptCrack Crack>
  explicit ErasedCrack(const Crack& crack)
      : size_(crack.size()),
        front_(crack.front()),
        intensity_([crack](double a, double s) { return crack.stress_intensity(a, s); }),
        area_([crack](double a, double s) { return crack.swept_area(a, s); }) {}

  /// Size a [m].
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] FrontRange front() const { return front_; }
  /// Stress intensity K per unit of each load, at size a and place s of the front [Pa*m^0.5 per
  /// unit of load].
  [[nodiscard]] UnitStressIntensity<N> stress_intensity(double a, double s) const {
    return intensity_(a, s);
  }
  /// dA/(ds da) of the front [m].
  [[nodiscard]] double swept_area(double a, double s) const { return area_(a, s); }

 private:
  double size_;
  FrontRange front_;
  std::function<UnitStressIntensity<N>(double, double)> intensity_;
  std::function<double(double, double)> area_;
};

/// `added_compliance` of an erased crack with the default tolerance; compiled for 1 to 4 loads.
template <std::size_t N>
[[nodiscard]] CrackCompliance<N> compliance_of(const ErasedCrack<N>& crack,
                                               const CrackModuli& moduli);
/// Compiled once, in the library.
/// @{
extern template CrackCompliance<1> compliance_of(const ErasedCrack<1>&, const CrackModuli&);
extern template CrackCompliance<2> compliance_of(const ErasedCrack<2>&, const CrackModuli&);
extern template CrackCompliance<3> compliance_of(const ErasedCrack<3>&, const CrackModuli&);
extern template CrackCompliance<4> compliance_of(const ErasedCrack<4>&, const CrackModuli&);
/// @}

}  // namespace strainwave

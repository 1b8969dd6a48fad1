// SPDX-License-Identifier: Apache-2.0
#include "strainwave/laminate/laminate.hpp"

#include <algorithm>

namespace strainwave {

bool isotropic_in_plane(const LaminateStiffness<double>& of, double tolerance) {
  const InPlane<>& A = of.A;
  const double limit = tolerance * A.m11;
  return std::max({std::abs(A.m11 - A.m22), std::abs(A.m11 - A.m12 - 2 * A.m66), std::abs(A.m16),
                   std::abs(A.m26)}) <= limit;
}

bool balanced_and_symmetric(const LaminateStiffness<double>& of, double tolerance) {
  const InPlane<>& A = of.A;
  const InPlane<>& B = of.B;
  const double stretch = tolerance * std::min(A.m11, A.m22);
  const double bend = stretch * of.thickness / 2;
  return std::max(std::abs(A.m16), std::abs(A.m26)) <= stretch &&
         std::max({std::abs(B.m11), std::abs(B.m12), std::abs(B.m22), std::abs(B.m16),
                   std::abs(B.m26), std::abs(B.m66)}) <= bend;
}

EvenPlate<double> softest_plate(const LaminateStiffness<double>& of) {
  const InPlane<> d = inverse(of.D);
  const double bends = (3 * (d.m11 + d.m22) + 2 * d.m12 + d.m66) / 8;
  const double twists = (d.m11 + d.m22 - 2 * d.m12 + d.m66) / 2;
  const double nu = twists / (2 * bends) - 1;
  return {.bending = 1 / (bends * (1 - nu * nu)), .poissons_ratio = nu};  // (LA-17)
}

}  // namespace strainwave

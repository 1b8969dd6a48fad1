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

double hoop_bending_stiffness(const LaminateStiffness<double>& of) {
  return of.D.m22 - of.B.m22 * of.B.m22 / of.A.m22;  // (LA-6)
}

}  // namespace strainwave

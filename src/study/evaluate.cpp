// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/evaluate.hpp"

#include <cassert>

#include "strainwave/article/as_printed.hpp"
#include "strainwave/article/repaired.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {

StiffnessResult evaluate(const GearSet& gear, Method method) {
  switch (method) {
    case Method::as_printed:
      return torsional_stiffness_as_printed(gear);
    case Method::repaired:
      return torsional_stiffness_repaired(gear);
    case Method::corrected:
      break;
  }
  assert(method == Method::corrected);
  return torsional_stiffness(gear);
}

}  // namespace strainwave

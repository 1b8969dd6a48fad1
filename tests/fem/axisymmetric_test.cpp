// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/axisymmetric.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace strainwave::fem {
namespace {

TEST(SectionTorsion, ReferenceTube) {
  const SectionShape tube{.rectangles = {{.r_from = 1, .r_to = 2, .z_from = 0, .z_to = 3}},
                          .fillets = {},
                          .sides = {{.level = 0, .from = 1, .to = 2, .role = EdgeRole::held},
                                    {.level = 3, .from = 1, .to = 2, .role = EdgeRole::loaded}},
                          .crack = {}};
  const SectionMesh mesh = mesh_section(tube, {.coarse_r = 1, .coarse_z = 1});
  const auto solution = solve_section(mesh, SectionLoad::torsion, {2.6, 0.3}, {.order = 1});
  EXPECT_NEAR(solution.compliance * (std::numbers::pi / 2 * 15) / 3, 1, 1e-12);  // L/(mu J)
}

}  // namespace
}  // namespace strainwave::fem

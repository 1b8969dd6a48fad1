// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {

/// A group of cracks of the flexspline with its effects on each crack (CG-9), and the sums of their
/// compliances in torsion.
struct AnsweredGroup {
  explicit AnsweredGroup(WallGroup of);

  WallGroup group;
  std::string fault;                  ///< why the group has no usable answer; empty: it has one
  std::vector<GroupEffect> positive;  ///< under T > 0; empty with a fault
  std::vector<GroupEffect> negative;  ///< under T < 0; empty with a fault
  /// Sums over the cracks under T > 0 and T < 0: as added, and alone [rad/(N*m)].
  std::array<double, 2> added{};
  std::array<double, 2> alone{};
};

/// What the others of its group do to one crack.
struct InGroup {
  AnsweredGroup& group;
  std::size_t member;

  [[nodiscard]] const GroupEffect& under(TorqueSense sense) const {
    return (sense == TorqueSense::positive ? group.positive : group.negative)[member];
  }
};

/// The compliance of a crack in its group over [axial, torsion], from that of the crack alone in
/// the curved wall (CG-9).
[[nodiscard]] SymmetricMatrix<2> in_group(const SymmetricMatrix<2>& alone,
                                          const GroupEffect& effect);

/// Uncertainties of a crack by the curvature that its group leaves out [-].
struct ByCurvature {
  double compliance = 0.0;
  double intensity = 0.0;
};
[[nodiscard]] ByCurvature by_curvature(const WallGroup& group, const GroupEffect& effect);

/// Says what the cracks of a group do to each other, and how far off plain superposition would be;
/// a group with a fault makes the answer unusable.
void note_interaction(const AnsweredGroup& answered, MemberCompliance& member);

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

// Parts shared by the article's two methods: which drives they accept, and how the members'
// compliances become a result.

namespace strainwave::article {

/// One member of the drive by one of the article's methods, with its evidence; SI.
struct Member {
  double sound = 0.0;  ///< lambda_0 without its crack [rad/(N*m)]
  double added = 0.0;  ///< Delta lambda of its crack [rad/(N*m)]
  /// lambda; not the sum of the two above, because they may cancel [rad/(N*m)]
  double cracked = 0.0;
  std::optional<CrackReport> crack;
  std::vector<Note> notes;
  std::vector<std::string> equations;
};

/// The result for a member that the drive lacks.
[[nodiscard]] Member absent_member(std::string_view path);

/// The cracks that the article can treat, at most one in each member; null if a member has no
/// crack.
struct Cracks {
  const RaceSurfaceCrack* race = nullptr;
  const WallThroughCrack* wall = nullptr;
  const AnnularCrack* shaft = nullptr;
};

/// @throws InputError  if the checked gear contains anything that the article's methods cannot
///                     treat
[[nodiscard]] Cracks treatable_cracks(const GearSet& gear, Method method);

/// Makes the report of a crack, open under both senses of torque, because the article does not
/// model closure.
///
/// @param uniform_front  whether the stress intensity is the same along the whole front
[[nodiscard]] CrackReport crack_report(std::string_view path, std::string_view kind,
                                       double added_compliance, const StressIntensities& deepest,
                                       bool uniform_front);

/// The three stress intensity factors as quantities [Pa*m^0.5].
[[nodiscard]] StressIntensities stress_intensities(double K_I, double K_II, double K_III);

/// A note that the method does not read a field whose value differs from the method's assumption.
[[nodiscard]] Note not_read(std::string_view path, std::string_view equation,
                            std::string_view what_is_done);

/// Adds the compliances of the members.  Their sum, eq. (AP-18), is right as printed.
[[nodiscard]] StiffnessResult drive_result(const GearSet& gear, Method method,
                                           const Member& wave_generator, const Member& flexspline,
                                           const Member& output_shaft);

}  // namespace strainwave::article

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

// What the article's two methods have in common: which drives they take, and how the members'
// compliances become a result.

namespace strainwave::article {

/// One member of the drive by one of the article's methods, with its evidence; SI.
struct Member {
  double sound = 0.0;    ///< lambda_0, without its crack [rad/(N*m)]
  double added = 0.0;    ///< Delta lambda, of its crack [rad/(N*m)]
  double cracked = 0.0;  ///< lambda; not summed from the two, which may cancel [rad/(N*m)]
  std::optional<CrackReport> crack;
  std::vector<Note> notes;
  std::vector<std::string> equations;
};

/// A member that is not there.
[[nodiscard]] Member absent_member(std::string_view path);

/// The cracks that the article can treat, one of its kind in each member; null where none is.
struct Cracks {
  const RaceSurfaceCrack* race = nullptr;
  const WallThroughCrack* wall = nullptr;
  const AnnularCrack* shaft = nullptr;
};

/// @throws InputError  for everything in a checked gear that the article's methods cannot treat
[[nodiscard]] Cracks treatable_cracks(const GearSet& gear, Method method);

/// A crack's report: open under both senses of torque, because the article knows no closure.
///
/// @param uniform_front  the stress intensity is the same all along the front
[[nodiscard]] CrackReport crack_report(std::string_view path, std::string_view kind,
                                       double added_compliance, const StressIntensities& deepest,
                                       bool uniform_front);

/// The three stress intensity factors as quantities [Pa*m^0.5].
[[nodiscard]] StressIntensities stress_intensities(double K_I, double K_II, double K_III);

/// A note that the method does not read a field which says something else than it does.
[[nodiscard]] Note not_read(std::string_view path, std::string_view equation,
                            std::string_view what_is_done);

/// Adds the members up; the sum, eq. (AP-18), is right as printed.
[[nodiscard]] StiffnessResult drive_result(const GearSet& gear, Method method,
                                           const Member& wave_generator, const Member& flexspline,
                                           const Member& output_shaft);

}  // namespace strainwave::article

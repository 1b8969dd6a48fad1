// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/fe_study/output_files.hpp"
#include "strainwave/fem/solid.hpp"

namespace strainwave::fe_study {

/// A tube of the drawn body.
struct DrawnTube {
  double inner_radius{};  ///< [m]
  double outer_radius{};  ///< [m]
  double from{};          ///< z [m]
  double to{};            ///< z [m]
};

/// A crack of any shape in a tube's wall, in the form that pictures need.  Its middle is at theta =
/// 0.
struct CrackedWall {
  std::string path;                ///< "flexspline.crack[0]"
  std::string description;         ///< "through crack 2a = 20 mm at 45° from the generator, ..."
  double mean_radius{};            ///< [m]
  double wall_thickness{};         ///< [m]
  double length{};                 ///< [m]
  std::string body;                ///< "tube", "cup"
  std::vector<DrawnTube> outline;  ///< outline of the body, from the lowest to the open end
  double place{};                  ///< z of the crack's middle [m]
  double half_length{};            ///< half length a on the visible face [m]
  double angle{};                  ///< angle from +z toward -theta [rad]
  /// true: pictures show the inner face, from which the crack starts
  bool inside = false;
  double torque{};      ///< torque with its sign [N*m]
  std::string state;    ///< "open", "partly closed", "closed"
  bool closed = false;  ///< K_I = 0 is exact
  std::string fault;    ///< reason why the result must not be used; empty if usable
  const fem::SolidResult* solid = nullptr;
  std::vector<std::string> front_names;  ///< name of each front: "upper tip"
  std::string along;                     ///< direction along a front: "from the inner face"
  bool corners = false;                  ///< K is not defined at a front's two ends
};

/// Pictures of the energy on the face, its difference from the sound wall, the opened crack, and
/// the stress intensity along its fronts.
[[nodiscard]] std::vector<OutputFile> wall_pictures(const CrackedWall& wall);

}  // namespace strainwave::fe_study
